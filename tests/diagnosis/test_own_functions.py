"""Joints that each err by a function of their own angle, over less than a turn: corrected together, without a name."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis.correction import Smooth
from deltacal_gen.diagnosis.laws.laws import Sought
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.use.prediction import CORRECTED
from tests.support.left_out import FRAME
from tests.support.prototype import wanted

LINKS: list[dict[str, Any]] = [
    {"kind": "revolute", "alpha": 90.0, "d": 120.0},
    {"kind": "revolute", "a": 400.0},
    {"kind": "revolute", "a": 350.0},
    {"kind": "revolute", "alpha": 90.0, "d": 110.0},
]
RANGES_DEG = np.array([(-35.0, 30.0), (20.0, 75.0), (-110.0, -50.0), (-40.0, 25.0)])
BUMPS, WIDE_DEG = 24, 2.0  # of a joint's error: no wave of any order
ERR_DEG, SIGMA = 0.01, 0.01


@pytest.fixture(scope="module")
def arm() -> Robot:
    head = {"robot": {"name": "arm", "mechanism": "serial"}, "geometry": {"tool": [10.0, -5.0, 60.0]}}
    return robot_from_dict(head | {"joint": LINKS})


def errs(q: np.ndarray, order: float = 0.0) -> np.ndarray:
    """Return the error of each joint [deg] at joints (N, 4) [deg]: bumps up and down; the last joint does not err.

    With an order the second one errs by that wave, and the third does not either.
    """
    rng, out = np.random.default_rng(3), np.zeros_like(q)
    for j, ends in enumerate(RANGES_DEG[:3]):
        middle, height = rng.uniform(*ends, BUMPS), ERR_DEG * rng.standard_normal(BUMPS)
        out[:, j] = np.exp(-0.5 * ((q[:, [j]] - middle) / WIDE_DEG) ** 2) @ height
    if order:
        out[:, 1:] = ERR_DEG * np.sin(np.radians(order * q[:, 1:])) * [1.0, 0.0, 0.0]
    return out


def read(robot: Robot, q: np.ndarray, seed: int, sigma: float = SIGMA, order: float = 0.0) -> Recording:
    """Return positions of the arm at joints (N, 4) [deg]."""
    there = dataclasses.replace(wanted(np.zeros((len(q), 3))), joints=np.radians(q + errs(q, order)), targets=None)
    done = simulate(robot, there, {"a_2": 0.3, "a_3": -0.2, "theta_4": 1e-3}, frame=FRAME)
    noise = sigma * np.random.default_rng([seed, 1]).standard_normal((len(q), 3))
    return dataclasses.replace(done, joints=np.radians(q), measured=done.measured + noise)


def anywhere(n: int, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(*RANGES_DEG.T, (n, 4))


def diagnosed(robot: Robot, recording: Recording) -> Diagnosis:
    """A diagnosis that has sought no laws, which bend to any smooth function."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("deltacal_gen.diagnosis.diagnosis.laws", lambda found, progress: Sought())
        return dc.diagnose(robot, recording)


@pytest.fixture(scope="module")
def found(arm: Robot) -> Diagnosis:
    return diagnosed(arm, read(arm, anywhere(300, 1), 1))


def missed(known: Diagnosis, fresh: Recording) -> float:
    return float(np.sqrt(np.mean((dc.predict(known, fresh).measured - fresh.measured) ** 2)))


@pytest.mark.walk
def test_every_joint_is_corrected_by_its_own_angle_and_none_is_named(arm: Robot, found: Diagnosis) -> None:
    assert found.verdict == "unexplained"
    assert not found.effects
    made = found.correction
    assert made is not None
    assert made.depends_on == ("q1_deg", "q2_deg", "q3_deg", "q4_deg")
    assert made.limbs == (1, 2, 3, 4)
    fresh = read(arm, anywhere(200, 9), 9, sigma=0.0)
    assert missed(found, fresh) < 0.5 * missed(found.replace(correction=None), fresh)
    promised = np.hypot(missed(found, fresh), SIGMA)
    assert made.heldout_rms_mm.after == pytest.approx(promised, rel=0.25)  # by fits of a part, a little more


@pytest.mark.walk
def test_an_order_that_is_there_keeps_its_name(arm: Robot) -> None:
    told = diagnosed(arm, read(arm, anywhere(200, 3), 3, order=31.0))
    assert told.correction is not None
    named = [(e.name, [p.value for p in e.parameters if p.name == "order"]) for e in told.effects]
    assert ("transmission_eccentricity", [31.0]) in named


@pytest.mark.walk
def test_the_waves_that_carry_most_are_told(found: Diagnosis) -> None:
    made = found.correction
    assert made is not None
    told = {own.limb: own for own in made.functions}
    assert [own.rms_mm for own in made.functions] == sorted((own.rms_mm for own in made.functions), reverse=True)
    assert made.functions[-1].limb == 4  # which does not err
    for j in range(3):
        own, span = told[j + 1], float(np.ptp(RANGES_DEG[j]))
        t = np.linspace(*RANGES_DEG[j], 400)
        err = errs(np.tile(t[:, None], 4))[:, j]
        err -= np.polynomial.Polynomial.fit(t, err, 1)(t)
        assert own.joint_rms_deg == pytest.approx(err.std(), rel=0.35)
        assert own.orders is not None
        assert own.orders[0] * span / 360 == pytest.approx(1 + np.argmax(np.abs(np.fft.rfft(err))[1:]), abs=1.1)
    assert "each joint has of its own angle" in found.summary
    assert "No period is claimed" in found.summary


@pytest.mark.walk
def test_it_fades_where_a_joint_or_the_path_was_not(arm: Robot, found: Diagnosis) -> None:
    q = anywhere(40, 5)
    assert (dc.predict(found, read(arm, q, 5)).channels[CORRECTED] > 0.99).mean() > 0.9
    q[:, 1] = 120.0
    away = read(arm, q, 5)
    done = dc.predict(found, away)
    assert (done.channels[CORRECTED] < 0.05).all()
    assert done.measured == pytest.approx(dc.predict(found.replace(correction=None), away).measured, abs=2e-3)


def test_the_lengths_of_waves_are_those_of_the_function() -> None:
    v = np.linspace(0, 60, 61)[:, None]
    kernel = np.exp(-0.5 * (v - v.T) ** 2 / 2.0**2)
    values = np.sin(2 * np.pi * v / 12) + 0.2 * v
    c = np.linalg.solve(kernel + 1e-9 * np.eye(61), values)
    smooth = Smooth(variable="q1_deg", limbs=(1,), knots=v, length=2.0, reach=0.5, coefficients=c)
    size, lengths = smooth.waves()
    assert size == pytest.approx(np.sqrt(0.5), rel=0.05)
    assert lengths == pytest.approx([12.0], rel=0.05)


def along(n: int) -> np.ndarray:
    """Return joints (n, 4) [deg] along one path, each step as long as the others in time."""
    t = np.linspace(0, 1, n)[:, None]
    swing = np.sin(2 * np.pi * np.array([0.5, 0.9, 1.2, 0.7]) * t + np.array([0.0, 1.0, 2.0, 3.0]))
    return RANGES_DEG.mean(axis=1) + np.ptp(RANGES_DEG, axis=1) / 2 * swing


@pytest.mark.walk
def test_on_a_path_it_holds_near_the_path_and_says_what_is_not_known(arm: Robot) -> None:
    every = read(arm, along(600), 2)
    train, test = (every.subset(np.arange(k, 600, 2)) for k in (0, 1))
    told, geometry = diagnosed(arm, train), dc.identify(arm, train)
    off = [float(np.sqrt(np.mean((dc.predict(at, test).measured - test.measured) ** 2))) for at in (told, geometry)]
    assert off[0] < 0.25 * off[1]
    assert told.correction is not None
    assert len(told.correction.functions) == 4
    assert "only the same poses on another day tell joints from time" in told.summary
    assert dc.predict(told, test).channels[CORRECTED].mean() > 0.9
    elsewhere = dc.predict(told, read(arm, anywhere(200, 5), 5)).channels[CORRECTED]
    assert np.median(elsewhere) < 0.5
    assert missed(told.replace(correction=None), test) < 1.02 * off[1]  # what noise is like spoils no geometry
