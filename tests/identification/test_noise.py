"""What is noise and nothing else is called so: rounded, understated, shared by the readings of a pose it is said."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.series import Series
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.identification import identify
from deltacal_gen.identification.repeats import repeats
from deltacal_gen.identification.rounding import ENCODERS, step_of
from deltacal_gen.identification.together import deviance_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term
from tests.benchmarks.honesty_nulls import ROBOT, SIGMA, null, rounded
from tests.support.left_out import channels, effect, record

pytestmark = pytest.mark.usefixtures("compiled")

ANGLES = np.random.default_rng(1).uniform(-60.0, 90.0, 100)


@pytest.mark.parametrize("step", [0.01, 0.03, 0.05, 10.0, 360 / 8192, 0.0018, 1 / 3])
def test_the_step_of_rounded_values_is_found(step: float) -> None:
    values = np.round(ANGLES / step) * step
    assert step_of(values) == pytest.approx(step, rel=1e-6)
    assert step_of(np.degrees(np.radians(values)) + 12.3) == pytest.approx(step, rel=1e-6)


def test_a_step_shows_though_too_few_digits_were_written() -> None:
    step = 360 / 8192
    values = np.round(np.round(ANGLES / step) * step, 4)
    assert step_of(values) == pytest.approx(1e-4, rel=1e-6)
    assert step_of(values, ENCODERS) == pytest.approx(step)


@pytest.mark.parametrize("values", [ANGLES, np.round(ANGLES, 9), np.array([1.0, 2.0, 4.0])])
def test_what_was_not_rounded_has_no_step(values: np.ndarray) -> None:
    assert step_of(values) == 0.0


def test_values_far_from_zero_are_no_finer_than_numbers_are() -> None:
    """Two that differ by less than numbers of their size are known to are one: no step divides them."""
    values = 1e6 + np.random.default_rng(3).uniform(-300.0, 300.0, 120)
    values[1::2] = np.nextafter(values[::2], np.inf)
    assert step_of(values) == 0.0
    assert step_of(1e6 + 0.25 * np.arange(40)) == pytest.approx(0.25)


@pytest.mark.parametrize(
    ("reading", "joint", "says"), [(0.1, 0.0, "readings in steps of 0.1 mm"), (0.0, 0.05, "0.05 deg")]
)
def test_rounding_that_a_declared_sigma_leaves_out_is_noise(reading: float, joint: float, says: str) -> None:
    found = diagnose(ROBOT, rounded(record(ROBOT, n=100, seed=5), reading, joint)).answer()
    assert found.verdict == "adequate"
    assert found.noise.source == "declared"
    assert found.noise.sigma_mm > 2 * SIGMA
    assert found.noise.model is not None
    assert says in found.noise.model.text
    assert says in found.summary


@pytest.mark.parametrize(
    ("reading", "joint", "says"), [(0.1, 0.0, "readings in steps of 0.1 mm"), (0.0, 0.01, "0.01 deg")]
)
def test_rounding_that_repeats_share_is_no_lack_of_the_model(reading: float, joint: float, says: str) -> None:
    """Steps of many times the noise: repeats are rounded alike, and show less than what rounding does to a pose."""
    joints = np.tile(np.degrees(record(ROBOT, n=60, seed=5).joints), (3, 1))
    made = rounded(record(ROBOT, n=180, seed=5, joints=joints, declared=False), reading, joint)
    found = diagnose(ROBOT, made).answer()
    assert found.noise.source == "repeats"
    assert (found.verdict, says in found.summary) == ("adequate", True)


def test_what_a_pose_shares_beyond_its_rounding_is_no_noise() -> None:
    joints = np.tile(np.degrees(record(ROBOT, n=60, seed=5).joints), (3, 1))
    made = record(ROBOT, n=180, seed=5, joints=joints, declared=False)
    shared = np.tile(np.random.default_rng(1).normal(0.0, 0.06, (60, 3)), (3, 1))
    made = rounded(dataclasses.replace(made, measured=made.measured + shared), 0.05, 0.0)
    assert diagnose(ROBOT, made).verdict == "unexplained"


def test_joints_commanded_in_whole_degrees_were_not_rounded() -> None:
    joints = np.round(np.degrees(record(ROBOT, n=100, seed=5).joints))
    found = diagnose(ROBOT, record(ROBOT, n=100, joints=joints)).answer()
    assert found.noise.model is not None
    assert "rounding" not in found.noise.model.text
    assert found.noise.sigma_mm == SIGMA


@pytest.mark.parametrize("k", [0, 1, 2])
def test_a_sigma_that_noise_exceeds_is_wrong(k: int) -> None:
    found = diagnose(ROBOT, null("understated", k)).answer()
    assert (found.verdict, found.noise.source) == ("adequate", "residual")
    assert found.noise.sigma_mm == pytest.approx(SIGMA, rel=0.2)
    assert "The declared sigma_mm of 0.005 is" in found.summary
    assert "times too small: what is left depends on nothing that was recorded" in found.summary


@pytest.mark.walk
def test_a_sigma_that_repeats_bear_out_is_right_and_what_exceeds_it_no_noise() -> None:
    pose = np.arange(120) // 3
    joints = np.degrees(record(ROBOT, n=120, seed=5).joints)[pose]
    made = record(ROBOT, n=120, seed=5, joints=joints, pose=[f"p{i}" for i in pose])
    shared = 2.5 * SIGMA * np.random.default_rng(1).standard_normal((120, 3))[pose]
    found = diagnose(ROBOT, dataclasses.replace(made, measured=made.measured + shared)).answer()
    assert (found.verdict, found.noise.sigma_mm) == ("unexplained", SIGMA)


def test_no_data_sheet_is_wrong_by_ten() -> None:
    made = null("white", 1)
    stated = dataclasses.replace(made.measurement, sigma_mm=SIGMA / 10)
    assert diagnose(ROBOT, dataclasses.replace(made, measurement=stated)).answer().verdict == "unexplained"


@pytest.mark.walk
def test_a_drift_is_named_where_correlated_noise_costs_more() -> None:
    of = channels(100, "time", seed=3)
    rate = 0.03 / (of["time_s"][-1] / 3600)
    made = record(ROBOT, effect("instrument_drift", (), rate, -rate, rate / 2), n=100, of=of, declared=False, seed=1)
    found = diagnose(ROBOT, made).answer()
    assert [e.name for e in found.effects] == ["instrument_drift"]
    assert found.search is not None
    [alone] = [h for h in found.search.hypotheses if not h.effects]
    assert alone.correlated
    assert alone.cost_chi2 > 0


def test_a_sigma_that_is_more_than_all_noise_is_wrong() -> None:
    found = diagnose(ROBOT, null("overstated", 1)).answer()
    assert (found.verdict, found.noise.source) == ("adequate", "residual")
    assert found.noise.sigma_mm == pytest.approx(SIGMA, rel=0.2)
    assert "The declared sigma_mm of 0.02 is 2.0 times too large" in found.summary


def test_a_jump_is_as_uncertain_as_its_moment() -> None:
    of = channels(100, "time", seed=3)
    when = float(of["time_s"][50]) - 1.0
    found = diagnose(ROBOT, record(ROBOT, effect("zero_jump", (2,), 0.003, constants=(when,)), n=100, of=of)).answer()
    [jump] = found.effects
    size, moment = jump.parameters
    assert (size.name, moment.name) == ("size", "when")
    assert moment.std is not None
    step = float(np.median(np.diff(of["time_s"])))
    assert 0.3 * step < moment.std < 10 * step
    assert abs(moment.value - when) < 3 * moment.std
    assert size.std is not None
    assert abs(size.value - 0.003) < 3 * size.std


def test_a_moment_is_a_row_where_no_time_was_recorded() -> None:
    found = diagnose(ROBOT, record(ROBOT, effect("zero_jump", (2,), 0.01, constants=(30.0,)))).answer()
    [jump] = found.effects
    assert found.clock == "row"
    assert [(p.name, p.unit) for p in jump.parameters] == [("size", "deg"), ("when", "row")]


def test_an_order_that_stands_alone_is_sure() -> None:
    wave = effect("transmission_eccentricity", (2,), 0.004, 0.003, constants=(9,))
    [found] = diagnose(ROBOT, record(ROBOT, wave, n=100)).answer().effects
    order = {p.name: p for p in found.parameters}["order"]
    assert order.value == 9
    assert order.std is None


def _read_three_times(*terms: Term) -> Recording:
    """Return readings of 40 poses, three of each, in between which everything that is recorded changes."""
    pose = np.arange(120) // 3
    joints = np.degrees(record(ROBOT, n=120, seed=5).joints)[pose]
    of = channels(120, "approach", "payload", "humidity_pct", seed=2)
    of["temp_C"] = np.round(np.random.default_rng(3).uniform(18, 30, 120), 1)
    return record(ROBOT, *terms, n=120, seed=5, joints=joints, of=of, pose=[f"p{i}" for i in pose])


@pytest.mark.parametrize("terms", [(), (effect("thermal_zero", (2,), 0.002), effect("backlash", (1,), 0.02))])
def test_what_channels_make_of_repeats_is_no_noise(terms: tuple[Term, ...]) -> None:
    made = _read_three_times(*terms)
    shown = repeats(identify(ROBOT, made).fit, made)
    assert shown.degrees >= 60
    assert np.sqrt(shown.variance) == pytest.approx(SIGMA, rel=0.2)
    assert shown.closest == pytest.approx(SIGMA, rel=0.4)


def test_repeats_contradict_a_sigma_whatever_changes_between_them() -> None:
    made = _read_three_times()
    stated = dataclasses.replace(made.measurement, sigma_mm=SIGMA / 2)
    found = diagnose(ROBOT, dataclasses.replace(made, measurement=stated)).answer()
    assert (found.verdict, found.noise.source) == ("adequate", "repeats")
    assert "repeats of a pose differ by" in found.summary


@pytest.mark.walk
def test_rows_that_are_copies_are_no_repeats() -> None:
    made = null("white", 1)
    n = made.n_rows
    twice = made.subset(np.r_[np.arange(n), np.arange(n)])
    [said] = identify(ROBOT, twice).answer().doubts or ()
    assert said.startswith(f"{n} rows are copies of others")
    assert diagnose(ROBOT, twice, "18").doubts == (said,)
    again = twice.measured.copy()
    again[n:] += 0.01 * np.random.default_rng(1).standard_normal(again[n:].shape)
    assert identify(ROBOT, dataclasses.replace(twice, measured=again)).answer().doubts is None
    assert identify(ROBOT, made.subset(np.r_[np.arange(n), 0, 1])).answer().doubts is None  # too few to tell


def test_what_rows_beside_one_do_not_tell_is_what_its_covariance_says() -> None:
    rng = np.random.default_rng(3)
    gap = np.r_[np.inf, rng.integers(1, 4, 19), np.inf, rng.integers(1, 4, 19)].astype(float)
    time, own, rho = np.cumsum(np.where(np.isinf(gap), 1e3, gap)), 0.2, 0.95
    C = own * np.eye(40) + (1 - own) * rho ** np.abs(time[:, None] - time)
    order, v = rng.permutation(40), rng.standard_normal(40)
    values = np.empty((40, 1))
    values[order, 0] = v
    found = Series(order, gap, rho, own).alone(values)[order, 0]
    for i in range(40):
        near = [j for j in (i - 1, i + 1) if 0 <= j < 40 and abs(time[i] - time[j]) < 100]
        by = np.linalg.solve(C[np.ix_(near, near)], C[near, i])
        assert found[i] == pytest.approx((v[i] - by @ v[near]) / np.sqrt(1 - by @ C[near, i]))


def test_noise_that_wanders_leaves_no_machine_elsewhere_and_few_rows_far_off_speak_for_none() -> None:
    rec = record(ROBOT, n=150, seed=8)
    rng = np.random.default_rng(8)
    rec.measured[rng.choice(150, 12, replace=False), 1] += np.geomspace(0.1, 0.9, 12)
    mechanism = mechanism_of(ROBOT)
    problem = pose_problem(ROBOT, rec, mechanism.model(mechanism.full_model))
    white = fit(problem, Prior(), drop_gross=False, must_converge=False)
    series = Series.of(problem.readings, problem.recording)
    assert series is not None
    repeats = dataclasses.replace(white.repeats, series=dataclasses.replace(series, rho=0.9994, own=0.07))
    wanders = fit(problem, Prior(), instrument=white.instrument, repeats=repeats, must_converge=False)
    assert len(wanders.gross) < 15
    assert np.sqrt(np.mean(wanders.residual**2)) < 2 * np.sqrt(np.mean(white.residual**2))
    assert deviance_of(wanders) > deviance_of(white)
