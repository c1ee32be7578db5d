"""What only errors of geometry let a load do is no effect: its size would be arbitrary, and a fit would not end."""

from __future__ import annotations

import dataclasses
import itertools
import json
from typing import Any

import numpy as np
import pytest

from deltacal_gen.diagnosis.charges import stiffest
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.refits import refitted, terms_of
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import blank, load_effect
from tests.support.open_chains import robot
from tests.support.prototype import wanted

TILT, TWIST = "joint_tilt_compliance", "joint_compliance"
ARM = robot(masses={"gravity": [0.0, 0.0, -9.81]})


@pytest.fixture(scope="module")
def leaning() -> Fit:
    """An arm of which the first axis is not upright by 0.3 deg, and whose shoulder tilts."""
    rng = np.random.default_rng(3)
    poses = wanted(np.zeros((90, 3)), frame="robot")
    poses = dataclasses.replace(poses, joints=np.radians(rng.uniform(-120, 120, (90, 6))), targets=None)
    factor = load_effect(TILT).COEFFICIENTS[0][2]
    tilts = blank(TILT, (2,)).with_values(np.array([0.004, 0.0]) * factor)
    read = simulate(ARM, poses, {"alpha_1": 0.005, "a_2": 0.3}, noise_mm=0.01, rng=rng, terms=[tilts])
    mechanism = mechanism_of(ARM)
    return fit(pose_problem(ARM, read, mechanism.model(mechanism.full_model)), Prior(), must_converge=False)


def test_a_moment_about_an_axis_that_is_upright_as_drawn_is_none(leaning: Fit) -> None:
    every = blank(TILT, (1, 2, 3))
    assert leaning.problem.borne([every]).tolist() == [True, True, True, False, True, True]
    moved = leaning.problem.term_columns([every], leaning.errors, leaning.instrument, leaning.machine)
    assert np.abs(moved[:, :, 3]).max() > 0  # with its errors the machine does bear one


def test_what_needs_no_load_is_borne(leaning: Fit) -> None:
    assert leaning.problem.borne([blank("joint_scale", (1, 2)), blank("instrument_scale", ())]).all()
    assert leaning.problem.borne([]).shape == (0,)


def test_the_search_does_not_look_at_it(leaning: Fit) -> None:
    search = Search(leaning, library(leaning.problem)[0])
    columns = search.columns[:, search.where(blank(TILT, (2,)))]
    assert np.linalg.norm(columns, axis=0) == pytest.approx([1.0, 0.0])


def test_a_fit_leaves_it_at_nothing_and_ends(leaning: Fit) -> None:
    start = blank(TILT, (2,)).with_values(np.array([0.004, 0.5]) * load_effect(TILT).COEFFICIENTS[0][2])
    found = refitted(leaning.problem, leaning, [start])
    assert found is not None
    assert len(found.history) < 10
    [own] = terms_of(found)
    assert own.values[0, 0] / start.values[0, 0] == pytest.approx(1.0, abs=0.2)
    assert abs(own.values[0, 1]) < 1e-6 * own.values[0, 0]


def state_of(at: Fit) -> tuple[Any, ...]:
    return at.errors, at.instrument, at.machine


@pytest.fixture(scope="module")
def straight() -> Fit:
    """An arm whose shoulder twists under its load, of which elbow and wrist stayed at zero: it was straight."""
    upper = {"kind": "revolute", "a": 400.0, "mass": 4.0, "com": [-200.0, 0.0, 0.0]}
    links = [{"kind": "revolute", "alpha": -90.0, "d": 340.0}, upper | {"theta": -90.0}, upper, upper]
    arm = robot(links, masses={"gravity": [0.0, 0.0, -9.81]}, geometry={"tool": [30.0, 0.0, 0.0]})
    rng = np.random.default_rng(5)
    joints = np.zeros((30, 4))
    joints[:, :2] = np.radians(rng.uniform(-100, 100, (30, 2)))
    poses = dataclasses.replace(wanted(np.zeros((30, 3)), frame="unknown"), joints=joints, targets=None)
    own = blank(TWIST, (2,)).with_values(np.array([0.003]) * load_effect(TWIST).COEFFICIENTS[0][2])
    read = simulate(arm, poses, {"theta_2": 0.001, "a_1": 0.3}, noise_mm=0.02, rng=rng, terms=[own])
    mechanism = mechanism_of(arm)
    return fit(pose_problem(arm, read, mechanism.model(mechanism.full_model)), Prior(), must_converge=False)


@pytest.mark.walk
def test_of_joints_that_nothing_tells_apart_the_one_that_gives_least_is_named_and_the_others_told(
    straight: Fit,
) -> None:
    """The wrist has to be softer by as much as its load and its lever are less: no machine is, and what a payload
    does to it would be many times too much."""
    search = Search(straight, library(straight.problem)[0])
    every = blank(TWIST, (1, 2, 3, 4))
    G, b = search.normal(search.where(every))
    size = np.linalg.norm(straight.problem.term_columns([every], *state_of(straight)), axis=(0, 1))
    for limb in (2, 3, 4):
        assert stiffest(every, blank(TWIST, (limb,)), G, b, size).limbs == (2,)
        other = search.stiffer(blank(TWIST, (limb,)))
        assert (other.limbs if other else (limb,)) == (2,)
    assert search.elsewhere(blank(TWIST, (2,))) == {2: (3, 4)}
    hardens = search.best("saturating_compliance").term  # about a torque that is another at each joint
    assert {*hardens.limbs, *itertools.chain(*search.elsewhere(hardens).values())} == {2, 3, 4}
    factor = load_effect(TWIST).COEFFICIENTS[0][2]
    shoulder, wrist = (search.estimated(blank(TWIST, (i,))).values[0, 0] / factor for i in (2, 4))
    assert shoulder == pytest.approx(0.003, rel=0.2)
    assert wrist > 10 * shoulder
    named = diagnose(straight.problem.robot, straight.problem.recording).answer()
    [effect] = named.effects
    assert (effect.name, *effect.limbs) == (TWIST, 2) or TWIST in effect.indistinguishable_from
    assert f"{effect.name} at joint {effect.limbs[0]} from one at joint" in named.summary
    assert "No poses within the recorded joint range do" in json.dumps([n.text for n in named.next_measurements])
