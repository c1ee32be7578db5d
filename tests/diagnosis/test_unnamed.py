"""The deviation of what is named counts small effects of the same cause that nobody named."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.refits import form, refitted, terms_of
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.diagnosis.unnamed import expected_products, shifts
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank, load_effect
from tests.support.left_out import FRAME
from tests.support.open_chains import robot
from tests.support.prototype import wanted

pytestmark = pytest.mark.usefixtures("compiled")

POSES, NOISE = 120, 0.02
SMALL = 0.004  # mm: what a tilting axis moves the readings by, a fifth of the noise


def yields() -> Term:
    """Return a shoulder and an elbow that yield by 6 and 5 thousandths of a degree per Nm."""
    factor = load_effect("joint_compliance").COEFFICIENTS[0][2]
    return blank("joint_compliance", (2, 3)).with_values(np.array([0.006, 0.005]) * factor)


def measured(seed: int, *terms: Term) -> Recording:
    """Return positions of the arm of `test_serial` at poses anywhere."""
    rng = np.random.default_rng([seed, 5])
    empty = wanted(np.zeros((POSES, 3)))
    poses = dataclasses.replace(empty, joints=np.radians(rng.uniform(-120, 120, (POSES, 6))), targets=None)
    arm = robot(masses={"gravity": [0.0, 0.0, -9.81]})
    errors = {"a_2": 0.2, "theta_3": 1e-3}
    return simulate(arm, poses, errors, noise_mm=NOISE, rng=rng, terms=terms, frame=FRAME)


def posed(recording: Recording) -> Problem:
    arm = robot(masses={"gravity": [0.0, 0.0, -9.81]})
    mechanism = mechanism_of(arm)
    return pose_problem(arm, recording, mechanism.model(mechanism.full_model))


def tilts(seed: int) -> Term:
    """Return axes that all tilt under load, each by as little as nobody sees."""
    problem = posed(measured(seed))
    every = blank("joint_tilt_compliance", tuple(range(1, 7)))
    machine = problem.solve(problem.reference)
    columns = problem.term_columns([every], problem.reference, problem.begin(problem.reference, machine), machine)
    moved = np.sqrt((columns**2).sum(axis=1).mean(axis=0))
    drawn = np.abs(np.random.default_rng([seed, 99]).standard_normal(len(moved)))
    return every.with_values(np.where(moved > 1e-9, SMALL * drawn / np.maximum(moved, 1e-9), 0.0))


def named(recording: Recording) -> tuple[Array, Array, Array]:
    """Return how far off both compliances are, their variances by the fit, and what unnamed effects add."""
    problem = posed(recording)
    first = fit(problem, Prior(), drop_gross=False, must_converge=False)
    at = refitted(problem, first, [yields()])
    assert at is not None
    [own] = terms_of(at)
    off = (own.values - yields().values).ravel()
    variance = np.diag(at.covariance)[at.problem.coefficients(0)]
    return off, variance, shifts(Search(at, library(problem)[0]))[form(own)]


def test_small_effects_that_nobody_named_are_in_the_deviation() -> None:
    found = [named(measured(seed, yields(), tilts(seed))) for seed in range(8)]
    off, variance, added = map(np.array, zip(*found, strict=True))
    assert np.mean(off**2 / variance) > 2.0  # the fit alone is far too sure
    assert 0.4 < np.mean(off**2 / (variance + added)) < 1.7


def test_where_nothing_else_yields_next_to_nothing_is_added() -> None:
    found = [named(measured(seed, yields())) for seed in range(8)]
    off, variance, added = map(np.array, zip(*found, strict=True))
    assert np.median(added / variance) < 0.2
    assert 0.4 < np.mean(off**2 / (variance + added)) < 1.7


def test_what_is_expected_of_coefficients_is_what_they_are() -> None:
    rng = np.random.default_rng(4)
    basis = rng.standard_normal((60, 6)) @ np.diag([1.0, 1.0, 1.0, 0.3, 0.3, 0.01]) / 8
    G, squares, expected = basis.T @ basis, np.zeros(6), np.zeros(6)
    for _ in range(400):
        c = 5.0 * rng.standard_normal(6)
        squares += c**2
        y = basis @ c + rng.standard_normal(60)
        expected += np.diag(expected_products(G, basis.T @ y, float(y @ y), most=1e4))
    assert expected == pytest.approx(squares, rel=0.25)


def test_nothing_is_added_where_the_likeliest_size_is_none() -> None:
    assert not expected_products(np.eye(3), np.full(3, 0.5), 3.0, most=100.0).any()


def test_a_diagnosis_tells_the_deviation_with_it() -> None:
    of = measured(3, yields(), tilts(3))
    found = diagnose(robot(masses={"gravity": [0.0, 0.0, -9.81]}), of)
    [own] = [n for n in found.effects if n.term.effect == "joint_compliance"]
    at = [t.effect for t in terms_of(found.final)].index("joint_compliance")
    variance = np.diag(found.final.covariance)[found.final.problem.coefficients(at)]
    assert (own.std > 1.1 * np.sqrt(variance)).any()
