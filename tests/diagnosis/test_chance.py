"""The p-value of a search: uniform where there is nothing but noise, small where there is an effect."""

from __future__ import annotations

import copy
import types
from typing import Any

import numpy as np
import pytest
from scipy.stats import kstest

from deltacal_gen.diagnosis import chance
from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.estimation.fit import fit, rough
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.machine.values import Recording
from tests.benchmarks.honesty_chance import geometry_of
from tests.benchmarks.honesty_nulls import ROBOT, null
from tests.support.left_out import DELTA, channels, effect, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

NULLS = 150
KOLMOGOROV = 1.63 / NULLS**0.5  # exceeded by one set of uniform numbers in a hundred


@pytest.fixture(scope="module")
def search() -> Search:
    robot = machine()
    made = record(robot, n=50, of=channels(50, "approach", "temp", "time", "payload"))
    problem = pose_problem(robot, made, DELTA.model("42"))
    start = rough(problem)
    first = fit(problem, Prior(), errors=start.errors, instrument=start.instrument)
    return Search(first, library(problem)[0])


def with_noise(search: Search, noise: np.ndarray) -> Any:
    """Return a search whose readings are noise alone, beside the same columns."""
    Q = search.beside.Q
    beside = copy.copy(search.beside)
    beside.residual = noise - Q @ (Q.T @ noise)
    same = {name: getattr(search, name) for name in ("columns", "terms", "where", "gram")}
    return types.SimpleNamespace(beside=beside, **same)


@pytest.mark.walk
@pytest.mark.parametrize("shape", [pytest.param("normal", marks=pytest.mark.thorough), "heavy tails"])
def test_it_is_uniform_where_there_is_nothing_but_noise_of_whatever_shape(search: Search, shape: str) -> None:
    found = []
    for k in range(NULLS):
        rng = np.random.default_rng([k, 99])
        size = search.readings
        noise = rng.standard_normal(size) if shape == "normal" else rng.standard_t(4, size)
        found.append(Chance(with_noise(search, noise), rng).p_value)
    assert kstest(found, "uniform").statistic < KOLMOGOROV


def test_it_does_not_depend_on_how_large_the_noise_is(search: Search) -> None:
    noise = np.random.default_rng(1).standard_normal(search.readings)
    one, ten = (Chance(with_noise(search, k * noise), np.random.default_rng(2)) for k in (1.0, 10.0))
    assert one.p_value == ten.p_value
    assert one.best == ten.best


def test_beyond_the_draws_it_falls_as_a_sum_of_squares_does(search: Search) -> None:
    found = Chance(
        with_noise(search, np.random.default_rng(1).standard_normal(search.readings)), np.random.default_rng(2)
    )
    scores = np.linspace(found.score - 20, found.score + 60, 200)
    p = np.array([found.of(s) for s in scores])
    assert (np.diff(p) <= 0).all()
    assert p[0] == pytest.approx(1.0, abs=0.02)
    assert 1e-16 < p[-1] < 1e-6
    assert found.of(1e9) > 0


@pytest.mark.walk
def test_every_diagnosis_says_how_surely_the_search_found_something() -> None:
    robot = machine()
    of = channels(60, "approach")
    null = diagnose(robot, record(robot, of=of)).answer()
    assert null.search is not None
    assert 0.001 < null.search.p_value <= 1.0
    worn = diagnose(robot, record(robot, effect("backlash", (2,), 0.05), of=of)).answer()
    assert worn.search is not None
    assert worn.search.best == "backlash"
    assert worn.search.p_value < 1e-6
    assert 0 < worn.effects[0].p_value < 1e-6
    weak = diagnose(robot, record(robot, effect("backlash", (2,), 0.01), of=of)).answer()
    assert weak.search is not None
    assert weak.search.p_value > worn.search.p_value


@pytest.fixture(scope="module")
def coarse() -> Search:
    """Return the competition on a recording whose joints were rounded to 0.05 deg, of which most of its noise is."""
    return looked_at(null("rounded", 30011))


def looked_at(made: Recording) -> Search:
    first = geometry_of(made)
    return Search(first, library(first.problem)[0])


def test_joints_that_were_rounded_move_readings_along_joints_by_chance_too(
    coarse: Search, monkeypatch: pytest.MonkeyPatch
) -> None:
    p = Chance(coarse, np.random.default_rng(1)).p_value
    monkeypatch.setattr(chance, "_steps", lambda search, own: None)
    assert p > 5 * Chance(coarse, np.random.default_rng(1)).p_value


def test_what_stands_apart_stays_where_it_was_read() -> None:
    search = looked_at(null("gross", 10))
    apart = search.beside.fit.weights[search.beside.owner] < 1
    assert 0 < apart.sum() < 10
    drawn = np.abs(chance._drawn(search, np.random.default_rng(1)))
    largest = np.argmax(drawn[:, 0])
    assert apart[largest]
    assert (drawn[largest, 1:] > 3).all()


def test_joints_that_were_commanded_in_steps_leave_no_rounding(coarse: Search) -> None:
    step = 0.05  # deg
    joints = np.degrees(record(ROBOT, n=100, sigma=0.0).joints)
    sharp = looked_at(record(ROBOT, n=100, joints=np.round(joints / step) * step, declared=False))
    assert chance._steps(sharp, sharp.beside.residual) is None
    found = chance._steps(coarse, coarse.beside.residual)
    assert found is not None
    assert float((found**2).sum()) / 12 == pytest.approx(coarse.readings, rel=0.5)  # most of the noise is rounding


def test_without_effects_to_test_nothing_is_found(search: Search) -> None:
    bare = with_noise(search, np.random.default_rng(1).standard_normal(search.readings))
    bare = types.SimpleNamespace(**{**vars(bare), "terms": (), "columns": search.columns[:, :0]})
    found = Chance(bare, np.random.default_rng(0))
    assert (found.best, found.p_value) == (None, 1.0)


@pytest.mark.walk
def test_chance_is_that_of_noise_as_it_hangs_together() -> None:
    found = diagnose(ROBOT, null("AR 0.9", 1)).answer()
    assert found.search is not None
    assert found.noise.model is not None
    assert found.noise.model.rows > 10
    assert found.search.p_value > 0.01  # were its rows independent, 3e-7
