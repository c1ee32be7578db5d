"""Sessions as people take them are what they are said to be, and judged by the rates that are asked."""

from __future__ import annotations

import numpy as np
import pytest

from tests.benchmarks import dirty
from tests.benchmarks.dirty_sessions import coloured, instrument_noise, lagged, nearest_first, side_of_approach


def test_a_path_visits_every_pose_once() -> None:
    theta = np.random.default_rng(1).uniform(-1, 1, (30, 3))
    order = nearest_first(theta)
    assert sorted(order) == [*range(30)]

    def length(rows: np.ndarray) -> float:
        return float(np.linalg.norm(np.diff(theta[rows], axis=0), axis=1).sum())

    assert length(order) < 0.7 * length(np.arange(30))


def test_a_joint_that_stands_keeps_the_side_from_which_it_came() -> None:
    assert side_of_approach(np.array([0.0, 1.0, 1.0, 0.5, 0.5, 2.0])).tolist() == [1, 1, 1, -1, -1, 1]


def test_a_thermometer_reads_a_step_late() -> None:
    read = lagged(np.array([20.0, 30.0, 30.0]), np.array([0.0, 100.0, 200.0]), 100.0)
    assert read == pytest.approx([20.0, 30.0 - 10.0 * np.exp(-1), 30.0 - 10.0 * np.exp(-2)])


def test_correlated_noise_has_its_memory() -> None:
    noise = coloured(20_000, 1, 4.0, np.random.default_rng(2))[:, 0]
    assert noise.std() == pytest.approx(1.0, abs=0.05)
    assert np.mean(noise[4:] * noise[:-4]) == pytest.approx(np.exp(-1.0), abs=0.05)


def test_an_instrument_has_the_noise_that_is_stated_but_for_outliers() -> None:
    rng = np.random.default_rng(3)
    x, time = 300 * rng.standard_normal((400, 3)), 30.0 * np.arange(400)
    noise = instrument_noise(x, time, np.repeat([0, 1], 200), 0.02, rng)
    typical = 1.4826 * np.median(np.abs(noise))
    assert typical == pytest.approx(0.02, rel=0.3)
    assert (np.abs(noise).max(axis=1) > 6 * 0.02).mean() <= 0.03


def test_jobs_are_drawn_by_their_seed() -> None:
    every = dirty.jobs(7, dirty.MACHINES)
    assert len(every) == sum(dirty.COUNTS.values())
    assert {machine for *_, machine in every} == set(dirty.MACHINES)
    assert every == dirty.jobs(7, dirty.MACHINES)
    assert every != dirty.jobs(8, dirty.MACHINES)


def test_a_rate_misses_its_goal_only_where_the_interval_lies_below() -> None:
    assert dirty.wilson(0, 0) == (0.0, 1.0)
    assert dirty.wilson(8, 10) == pytest.approx((0.490, 0.943), abs=1e-3)  # Brown, Cai, DasGupta 2001
    good = {"kind": "single", "names": ["zero_drift"], "verdict": "missing_physics", "verdict_ok": True, "exact": True}
    bad = good | {"verdict": "adequate", "verdict_ok": False, "exact": False, "coverage": 0.5, "to_oracle": 3.0}
    met = dirty.figures([f | {"wrong": []} for f in (good, bad)])
    assert met["one effect: name, place, verdict"] == [True, False]
    assert met["slow or sudden physics: not adequate"] == [True, False]
    assert met["prediction within 1.2 of an ideal fit"] == [False]
    assert met["95 % bands hold .90 to .98"] == [False]
