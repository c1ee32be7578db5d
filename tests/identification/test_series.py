"""Noise that hangs together from row to row: freed exactly, estimated beside what a fit took, no rival of a drift."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.estimation.fit import fit, held_out
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.series import FADES, OWN, OWN_PRICE, STILL, Series, Taken
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification import sandwich
from deltacal_gen.identification.answer import Identification
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.identification import identify
from deltacal_gen.identification.noise import coordinate_sigma
from deltacal_gen.identification.tails import tails_of
from deltacal_gen.identification.together import deviance_of, rows_alone
from tests.benchmarks.honesty_nulls import ROBOT, SIGMA, drawn, null
from tests.support.left_out import DELTA, channels, effect, machine, record
from tests.support.prototype import plausible

pytestmark = pytest.mark.usefixtures("compiled")

ORDER = np.array([3, 0, 1, 4, 2, 6, 5])
GAP = np.array([np.inf, 1, 3, 1, np.inf, 2, 1])  # two set-ups


@pytest.mark.parametrize(("rho", "own"), [(0.0, 0.0), (0.7, 0.0), (0.95, 0.3), (0.999, 0.8)])
def test_what_is_freed_has_unit_covariance(rho: float, own: float) -> None:
    series, n = Series(ORDER, GAP, rho, own), len(ORDER)
    setup = np.cumsum(np.isinf(GAP))
    when = np.cumsum(np.where(np.isinf(GAP), 100.0, GAP))
    apart = np.abs(when[:, None] - when)
    inside = (1 - own) * np.where(setup[:, None] == setup, rho**apart, 0.0) + own * np.eye(n)
    covariance = np.empty((n, n))
    covariance[np.ix_(ORDER, ORDER)] = np.where(np.eye(n) > 0, 1.0, inside)
    W = series.freed(np.eye(n))
    assert W @ covariance @ W.T == pytest.approx(np.eye(n), abs=1e-6)
    assert series.noise.log_det == pytest.approx(np.linalg.slogdet(covariance)[1], abs=1e-6)


def test_components_are_freed_alike() -> None:
    series, values = Series(ORDER, GAP, 0.8, 0.2), np.random.default_rng(1).standard_normal((7, 2, 3))
    assert series.freed(values)[:, 1, 2] == pytest.approx(series.freed(values[:, 1, 2]))


def test_points_of_a_pose_share_what_the_machine_stands_off_by() -> None:
    gap = np.array([np.inf, STILL, STILL, 1, STILL, 2, STILL])
    series = Series(np.arange(7), gap, 0.5, 0.2)
    pose = np.array([0, 0, 0, 1, 1, 3, 3])
    covariance = 0.8 * 0.5 ** np.abs(pose[:, None] - pose) + 0.2 * np.eye(7)
    W = series.freed(np.eye(7))
    assert W @ covariance @ W.T == pytest.approx(np.eye(7), abs=0.01)
    assert series.points == pytest.approx(7 / 3)
    assert "the points of a pose have 80% of the noise's variance in common" in series.text
    few = Series(np.arange(100), np.array([np.inf, STILL, *np.ones(98)]), rho=0.5)  # one pose of two points
    assert few.text.startswith("the noise hangs together over ")
    rng = np.random.default_rng(4)
    made = np.repeat(rng.standard_normal((60, 3)), 3, axis=0) + 0.5 * rng.standard_normal((180, 3))
    gap = np.tile([1.0, STILL, STILL], 60)
    gap[0] = np.inf
    found, _ = Series(np.arange(180), gap).likeliest(made)
    assert found.own == pytest.approx(0.2, abs=0.05)
    assert found.rho < 0.3
    assert found.rows == pytest.approx(2.6, rel=0.5)
    assert dataclasses.replace(found, rho=0.0).rows == 1.0


def test_a_part_may_hold_fewer_readings_than_parameters() -> None:
    n, k = 9, 14
    rng = np.random.default_rng(8)
    known, z = rng.standard_normal((n, 1, k)), rng.standard_normal((n, 1))
    toward, whole = rng.standard_normal(k), Series(np.arange(n), np.concatenate([[np.inf], np.ones(n - 1)]))
    found = whole.deviance(z, Taken(known, toward, np.zeros((n, 1, 0))))
    square = np.column_stack([known[:, 0], np.zeros((n, 0))])
    U, root, V = np.linalg.svd(square, full_matrices=False)
    as_many = Taken((U * root)[:, None], V @ toward, np.zeros((n, 1, 0)))  # the same, in columns that are independent
    assert found == pytest.approx(whole.deviance(z, as_many))


@pytest.mark.parametrize(("sort", "rho", "n"), [("AR 0.5", 0.5, 140), ("AR 0.9", 0.9, 480), ("AR 0.95", 0.95, 880)])
def test_its_length_is_found_whatever_a_fit_has_taken(sort: str, rho: float, n: int) -> None:
    wrong = []
    for k in range(6):
        rng = np.random.default_rng(k)
        known = rng.standard_normal((n, 3, 40))
        z = drawn(sort, (n, 3), rng)
        A = known.reshape(3 * n, -1)
        taken = Taken(known, np.zeros(40), np.ones((n, 1, 1)) * np.eye(3))
        left = z.ravel() - A @ np.linalg.lstsq(A, z.ravel(), rcond=None)[0]
        whole = Series(np.arange(n), np.concatenate([[np.inf], np.ones(n - 1)]))
        found, _ = whole.likeliest(left.reshape(n, 3), taken)
        wrong.append(np.log((1 - found.rho) / (1 - rho)))
    assert np.mean(np.abs(wrong) < np.log(1.35)) > 0.8  # the length goes as 1 / (1 - rho)
    assert abs(np.mean(wrong)) < 0.15


@pytest.mark.parametrize("far", [1.0, 4.0, 12.0])  # standard deviations of what was known of each parameter
@pytest.mark.parametrize("fine", [1e2, 1e5])  # what such a deviation moves readings by, in their noise
def test_white_noise_is_white_however_far_a_machine_is_off_its_drawing(far: float, fine: float) -> None:
    n, k = 60, 20
    rng = np.random.default_rng(3)
    known = fine * rng.standard_normal((n, 3, k))
    A, z = known.reshape(3 * n, k), rng.standard_normal((n, 3))
    taken = Taken(known, far * rng.choice([-1.0, 1.0], k), np.ones((n, 1, 1)) * np.eye(3))
    left = z.ravel() - A @ np.linalg.lstsq(A, z.ravel(), rcond=None)[0]
    whole = Series(np.arange(n), np.concatenate([[np.inf], np.ones(n - 1)]))
    alone = whole.deviance(left.reshape(n, 3), taken)
    assert alone - whole.likeliest(left.reshape(n, 3), taken)[1] < 6
    # but for the noise that is told of them, readings are as likely wherever the machine stands
    near = whole.deviance(left.reshape(n, 3), taken._replace(toward=np.zeros(k)))
    assert alone - near == pytest.approx(k * far**2, rel=1e-2)


def test_what_a_prior_holds_off_is_no_noise_that_hangs_together() -> None:
    """Readings without noise leave what parameters that they hardly see are held from: that has a size of its own."""
    n, k = 29, 21
    rng = np.random.default_rng(6)
    U, V = (np.linalg.qr(rng.standard_normal(shape))[0] for shape in ((n, n), (k, k)))
    size = np.geomspace(1e3, 1e-3, k)
    known = ((U[:, :k] * size) @ V.T).reshape(n, 1, k)
    taken = Taken(known, 0.3 * rng.standard_normal(k), np.zeros((n, 1, 0)))
    left = (U[:, k - 4 : k] @ np.array([0.3, -0.8, 1.4, -4.0])).reshape(n, 1)
    whole = Series(np.arange(n), np.concatenate([[np.inf], np.ones(n - 1)]))
    alone = whole.deviance(left, taken)
    assert abs(alone) < 1000
    assert alone - whole.likeliest(left, taken)[1] < 10


def test_white_noise_is_white() -> None:
    z = np.random.default_rng(5).standard_normal((100, 3))
    whole = Series(np.arange(100), np.concatenate([[np.inf], np.ones(99)]))
    assert whole.likeliest(z)[0].rows < 1.4


def test_what_each_row_has_of_its_own_is_told_apart() -> None:
    rng = np.random.default_rng(3)
    z = 0.8**0.5 * drawn("AR 0.95", (400, 3), rng) + 0.2**0.5 * rng.standard_normal((400, 3))
    found, _ = Series(np.arange(400), np.concatenate([[np.inf], np.ones(399)])).likeliest(z)
    assert found.rho == pytest.approx(0.95, abs=0.03)
    assert found.own == pytest.approx(0.2, abs=0.08)


@pytest.mark.walk
@pytest.mark.parametrize("k", [0, 1, pytest.param(2, marks=pytest.mark.thorough)])
def test_a_machine_that_does_not_repeat_lacks_nothing(k: int) -> None:
    """Three points are read where it stands, each time somewhat elsewhere: all three are off alike."""
    rng = np.random.default_rng([k, 9])
    pose = np.arange(150) // 3
    joints = np.degrees(record(ROBOT, n=150, seed=300 + k, sigma=0.0).joints)[pose]
    tool = np.array([[40.0, 0.0, -60.0], [-20.0, 35.0, -60.0], [-20.0, -35.0, -90.0]])[np.arange(150) % 3]
    errors = plausible(DELTA, k, size=0.3)
    made = record(ROBOT, n=150, seed=k, errors=errors, sigma=0.004, declared=False, joints=joints, tool=tool)
    made = dataclasses.replace(made, measured=made.measured + 0.03 * rng.standard_normal((50, 3))[pose])
    found = diagnose(ROBOT, made).answer()
    assert (found.verdict, found.effects, found.hints) == ("adequate", (), ())
    assert found.search.p_value > 0.005
    assert "of the noise's variance in common" in found.noise.model.text


@pytest.mark.walk
@pytest.mark.parametrize("k", [0, pytest.param(3, marks=pytest.mark.thorough)])
def test_an_instrument_that_wanders_does_not_drift(k: int) -> None:
    """Rows weighed alone predict better here: that machine is given, and what is told held out is of that one."""
    whole = diagnose(ROBOT, null("walk", k))
    given = whole.baseline
    parts = folds(given.problem.readings, given.problem.recording, rows=given.repeats.rows)
    assert whole.heldout[0] == pytest.approx(held_out(rows_alone(given), Prior(), parts), rel=1e-3)
    assert whole.heldout[0] < 0.7 * held_out(given, Prior(), parts)
    assert coordinate_sigma(given) == pytest.approx(given.rms(), rel=0.3)  # not what it will be one day
    assert coordinate_sigma(given) < 0.7 * given.sigma[0]
    found = whole.answer()
    assert found.effects == ()
    assert found.noise.model is not None
    assert found.noise.model.rows > 10
    assert "hangs together" in found.noise.model.text


@pytest.mark.walk
def test_what_moves_on_from_the_first_row_to_the_last_is_not_called_noise() -> None:
    """A set-up shows it once: `noise that hangs together over 50 rows`, of 50, told nobody to look for what moves."""
    found = diagnose(ROBOT, null("walk", 3)).answer()
    assert found.effects == ()
    assert "correlated over 50 of 50 readings: no noise of readings but a slow drift" in found.summary
    assert "looks like" not in found.summary
    gap = np.concatenate([[np.inf], np.ones(99)])
    assert Series(np.arange(100), gap, 0.98).lasts
    assert not Series(np.arange(100), gap, 0.9).lasts
    short = diagnose(ROBOT, null("AR 0.9", 3)).answer()
    assert "correlated over" in short.summary
    assert "slow drift" not in short.summary


def test_a_drift_is_no_noise() -> None:
    of = channels(100, "time")
    rate = 0.1 / (of["time_s"][-1] / 3600)
    made = record(ROBOT, effect("instrument_drift", (), rate, -rate, rate), n=100, of=of, declared=False)
    assert [e.name for e in diagnose(ROBOT, made).answer().effects] == ["instrument_drift"]


@pytest.mark.walk
def test_the_size_of_noise_is_that_of_a_reading_though_a_fit_took_what_fades() -> None:
    sizes = [diagnose(ROBOT, null("AR 0.9", k)).final.sigma[0] for k in (1, 7)]
    assert np.mean(sizes) == pytest.approx(SIGMA, rel=0.2)


@pytest.mark.parametrize(("rho", "own"), [(0.0, 0.0), (0.9, 0.3), (0.9994, 0.0)])
def test_what_rows_show_of_noise_is_their_scatter_about_the_mean(rho: float, own: float) -> None:
    """Of a walk it is far less than its size, which no recording shows; by the covariance, of two set-ups with gaps."""
    gap = np.array([np.inf, 1, 1, 3, 1, np.inf, 2, 1])
    parts = [np.cumsum([0, *gap[1:5]]), np.cumsum([0, *gap[6:]])]
    shown = 0.0
    for at in parts:
        C = (1 - own) * rho ** np.abs(at[:, None] - at) + own * np.eye(len(at))
        shown += len(at) * (np.trace(C) - C.sum() / len(at)) / (len(at) - 1)
    assert Series(np.arange(8), gap, rho, own).within == pytest.approx(shown / 8)


def test_a_row_that_nobody_read_is_a_gap() -> None:
    series = Series(np.arange(3), np.array([np.inf, 1.0, 1.0]), 0.9)
    wide = dataclasses.replace(series, gap=np.array([np.inf, 1.0, 50.0]))
    assert abs(wide.freed(np.array([0.0, 1.0, 0.0]))[2]) < 0.01 < abs(series.freed(np.array([0.0, 1.0, 0.0]))[2])


def test_identify_weighs_rows_by_how_their_noise_hangs_together() -> None:
    made, alone = null("AR 0.9", 1), null("white", 1)
    assert identify(ROBOT, alone).fit.repeats.series is None
    found = identify(ROBOT, made)
    assert found.fit.repeats.series is not None
    assert found.fit.repeats.series.rho == pytest.approx(0.9, abs=0.08)
    true = plausible(DELTA, 1, size=0.3)
    off = [
        (found.robot.errors[n] - v) / s for n, v, s in zip(found.fit.problem.names, *_wide(found, true), strict=True)
    ]
    assert np.mean(np.abs(off) < 1.96) > 0.85


def _wide(found: Identification, true: dict[str, float]) -> tuple[list[float], np.ndarray]:
    names = found.fit.problem.names
    return [true[n] for n in names], np.sqrt(np.diag(found.fit.covariance)[: len(names)])


def test_a_file_that_was_sorted_is_in_the_order_of_its_time() -> None:
    made = null("AR 0.9", 0)
    made = dataclasses.replace(made, channels={"time_s": 7.0 * np.arange(made.n_rows)})
    as_taken = identify(ROBOT, made, "delta/18")
    placed = made.subset(np.lexsort((made.joints[:, 1], made.joints[:, 0])))
    placed = dataclasses.replace(placed, line=made.line)  # lines of the sorted file
    found = identify(ROBOT, placed, "delta/18")
    assert found.fit.repeats.rows == pytest.approx(as_taken.fit.repeats.rows)
    assert found.fit.errors == pytest.approx(as_taken.fit.errors, abs=1e-6)
    # of two sessions in one file, each with its own clock, lines tell the order
    both = dataclasses.replace(made, channels={"time_s": 7.0 * (np.arange(made.n_rows) % (made.n_rows // 2))})
    assert identify(ROBOT, both, "delta/18").fit.repeats.rows == pytest.approx(as_taken.fit.repeats.rows)


def test_noise_is_the_same_whichever_way_a_file_runs() -> None:
    """What rows before tell of a row is not what those after do: a robust size of either is another."""
    made = dataclasses.replace(null("AR mixed", 2), channels={})
    back = dataclasses.replace(made.subset(slice(None, None, -1)), line=made.line)
    there, again = (identify(ROBOT, rows).fit for rows in (made, back))
    assert again.sigma == pytest.approx(there.sigma, rel=1e-4)
    assert again.repeats.rows == pytest.approx(there.repeats.rows, rel=1e-3)
    first, second = (tails_of(found) for found in (there, again))
    assert second.shape == first.shape
    assert second.spread == pytest.approx(first.spread, rel=1e-3)
    assert again.errors == pytest.approx(there.errors, abs=1e-4)


def test_folds_are_blocks_where_rows_hang_together() -> None:
    made = null("white", 1)
    found = pose_problem(ROBOT, made, DELTA.model("42")).readings
    alone, blocks = (folds(found, made, rows=rows) for rows in (1.0, 8.0))
    for parts, fewest, most in ((alone, 60, 99), (blocks, 4, 12)):
        assert (np.sum([test for _, test in parts], axis=0) == 1).all()
        part = np.argmax([test for _, test in parts], axis=0)
        assert fewest <= (np.diff(part) != 0).sum() <= most


def test_folds_are_even_though_poses_in_between_were_not_read() -> None:
    made = null("white", 1)
    measured = made.measured.copy()
    measured[::3] = np.nan
    some = dataclasses.replace(made, measured=measured)
    found = pose_problem(ROBOT, some, DELTA.model("42")).readings
    for parts in (folds(found, some), folds(found, some, rows=8.0)):
        assert (np.sum([test for _, test in parts], axis=0) == 1).all()
        assert np.ptp([test.sum() for _, test in parts]) <= 8


def test_no_set_up_counts_as_less_than_one_row() -> None:
    gap = np.tile([np.inf, *np.ones(18)], 2)
    walk = Series(np.arange(38), gap, 0.999)
    assert walk.rows == walk.rows_of_size == 19
    assert Series(np.arange(38), gap, 0.5).rows == pytest.approx(3)


@pytest.mark.parametrize("rho", [0.3, 0.8, 0.97])
@pytest.mark.parametrize("own", [0.0, 0.4])
def test_no_noise_of_the_grid_is_likelier_than_the_one_that_is_found(rho: float, own: float) -> None:
    """The likeliest is walked to, one part of each row's own after the other."""
    rng = np.random.default_rng(5)
    e = rng.standard_normal((120, 3))
    for k in range(1, len(e)):
        e[k] = rho * e[k - 1] + np.sqrt(1 - rho**2) * e[k]
    z = np.sqrt(1 - own) * e + np.sqrt(own) * rng.standard_normal(e.shape)
    series = Series(np.arange(120), np.append(np.inf, np.ones(119)))
    found, deviance = series.likeliest(z)
    price = OWN_PRICE * (found.own > 0)
    for fades in FADES[1:]:
        for part in (0.0, *OWN):
            at = dataclasses.replace(series, rho=1 - float(np.exp(fades)), own=part)
            assert deviance + price <= at.deviance(z) + OWN_PRICE * (part > 0) + 1e-9


@pytest.mark.parametrize("n", [440, 480, 520])
def test_a_needless_effect_hardly_moves_the_deviance_however_many_readings_there_are(n: int) -> None:
    """What a fit took is taken out of both fits or of neither: where many readings begin, too."""
    robot = machine()
    names = DELTA.model(DELTA.full_model)
    problem = pose_problem(robot, record(robot, n=n, of=channels(n, "time")), names)
    plain = fit(problem, Prior(), must_converge=False)
    more = refitted(problem, plain, [problem.body.blank("zero_drift", (1, 2, 3))])
    assert more is not None
    assert abs(deviance_of(more) - deviance_of(plain)) < 20.0


def test_what_is_fitted_is_as_sure_as_its_noise_lets_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ordinary least squares under noise that is correlated, against matrices that are written out."""
    problem = pose_problem(ROBOT, null("AR 0.9", 1), DELTA.model(DELTA.full_model))
    at = fit(problem, Prior(), must_converge=False, drop_gross=False)
    series = Series.of(problem.readings, problem.recording)
    assert series is not None
    noise = dataclasses.replace(series, rho=0.9, own=0.2).noise
    monkeypatch.setattr(sandwich, "_correlations", lambda at: [(1.0, noise)])
    monkeypatch.setattr(sandwich, "_creep", lambda at: np.zeros((*at.residual.shape, 0)))
    state = problem.linearise(at.errors, at.instrument, at.machine)
    R, k, n_m = state.J_m.shape
    scale, by = np.append(problem.scale, np.ones(n_m)), np.sqrt(at.weights)[:, None] / at.sigma
    A = (np.concatenate([state.J_p, state.J_m], axis=2) * scale * by[..., None]).reshape(R * k, -1)
    apart = np.abs(np.arange(R)[:, None] - np.arange(R))
    inside = np.empty((R, R))
    inside[np.ix_(series.order, series.order)] = 0.8 * 0.9**apart + 0.2 * np.eye(R)
    V = np.kron(inside, np.eye(k))
    rows = np.linalg.solve(np.linalg.cholesky(V), np.column_stack([A, (state.residual * by).ravel()]))
    left = rows[:, -1] - rows[:, :-1] @ np.linalg.lstsq(rows[:, :-1], rows[:, -1], rcond=None)[0]
    level = left @ left / (len(rows) - A.shape[1])
    P = np.diag([1.0] * len(problem.scale) + [0.0] * n_m)
    M = np.linalg.inv(A.T @ A + P)
    expected = np.sqrt(np.diag(M @ (level * A.T @ V @ A + P) @ M))
    assert np.sqrt(np.diag(sandwich.averaged(at))) / scale == pytest.approx(expected, rel=2e-2)


@pytest.mark.parametrize("creep", [0.0, 0.7])
def test_bands_hold_a_frame_that_creeps(creep: float) -> None:
    """An instrument that warms up by less than its noise is not proven to; the frame is that of its end."""
    errors = []
    for seed in range(12):
        made = null("white", seed)
        passed = np.arange(len(made.measured))[:, None] / len(made.measured)
        sigma = float(made.measurement.sigma_mm or SIGMA)
        moved = dataclasses.replace(made, measured=made.measured + creep * sigma * np.exp(-3 * passed))
        problem = pose_problem(ROBOT, moved, DELTA.model(DELTA.full_model))
        at = fit(problem, Prior(), must_converge=False, drop_gross=False)
        exact = fit(pose_problem(ROBOT, made, DELTA.model(DELTA.full_model)), Prior(), must_converge=False)
        predicted = (moved.measured - at.residual) - (made.measured - exact.residual)
        state = problem.linearise(at.errors, at.instrument, at.machine)
        middle = np.concatenate([state.J_p, state.J_m], axis=2).mean(axis=0)
        errors.append(predicted.mean(axis=0) / np.sqrt(np.diag(middle @ sandwich.averaged(at) @ middle.T)))
    assert float(np.sqrt(np.mean(np.square(errors)))) < 1.2
