"""The one least squares: uncertainties by Monte Carlo, repeats, steps and their end."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.errors import NoSolutionError
from deltacal_gen.estimation.fit import by_means, fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.residuals import Repeats, lengths, rms
from deltacal_gen.estimation.solvers import TSVD, LeastSquares, Prior
from deltacal_gen.files.robot import Robot
from deltacal_gen.inference.least_squares import _Steps
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from tests.support.prototype import plausible, rings, scattered, wanted

pytestmark = pytest.mark.usefixtures("compiled")

NOISE = 0.005
FRAME = (np.array([0.1, -0.2, 0.9]), np.array([900.0, -500.0, 1200.0]))
BASE_POINT = (420.0, -150.0, 40.0)


@pytest.fixture(scope="module")
def truth(mechanism: Machine) -> dict[str, float]:
    return plausible(mechanism, 3, mechanism.model("18"))


def clean(robot: Robot, truth: dict[str, float], kind: str, zero: str = "absolute") -> Recording:
    poses = np.vstack([rings(robot, 9), scattered(robot, 60 if kind == "gauge" else 20, 4)])
    if kind == "gauge":
        given = wanted(poses, kind, base_point_mm=BASE_POINT, zero=zero)
    elif kind == "distance":
        given = wanted(poses, kind, pairs=np.column_stack(np.triu_indices(len(poses), 1))[::4])
    else:
        given = wanted(poses, kind)
    return simulate(robot, given, truth, frame=FRAME)


def with_noise(recording: Recording, seed: int) -> Recording:
    rng = np.random.default_rng(seed)
    if recording.pair_measured is not None:
        noise = NOISE * rng.standard_normal(recording.pair_measured.shape)
        return dataclasses.replace(recording, pair_measured=recording.pair_measured + noise)
    return dataclasses.replace(
        recording, measured=recording.measured + NOISE * rng.standard_normal(recording.measured.shape)
    )


def true_instrument(found: Instrument, errors_of_gauge: np.ndarray) -> np.ndarray:
    """Return by which increments of its unknowns the true instrument differs from the one found."""
    if found.kind.name == "position":
        turn, origin = from_vector(FRAME[0]), FRAME[1]
        return np.concatenate([to_vector(turn @ found.state[0, :9].reshape(3, 3).T), origin - found.state[0, 9:12]])
    if found.kind.name == "gauge":
        return (errors_of_gauge - found.state[0])[list(found.free)]
    return np.zeros(0)


@pytest.mark.parametrize("kind", ["position", "distance", "gauge"])
def test_machine_and_instrument_lie_off_the_truth_by_their_covariance(
    robot: Robot, mechanism: Machine, truth: dict[str, float], kind: str
) -> None:
    """Monte Carlo over 40 noises: coverage of each parameter, and chi2 of all of them with the instrument's."""
    recording, p = clean(robot, truth, kind), mechanism.vector(truth)
    problem = pose_problem(robot, recording, mechanism.model("18"))
    problem = dataclasses.replace(problem, scale=10 * problem.scale)
    z, chi2 = [], []
    for seed in range(40):
        noisy = pose_problem(robot, with_noise(recording, seed), problem.names)
        found = fit(dataclasses.replace(noisy, scale=problem.scale), Prior(), errors=p)
        gap = np.concatenate(
            [(p - found.errors)[problem.columns], true_instrument(found.instrument, np.array([*BASE_POINT, 0.0]))]
        )
        z.append(gap / np.sqrt(np.diag(found.covariance)))
        chi2.append(gap @ np.linalg.solve(found.covariance, gap) / len(gap))
    z = np.array(z)
    assert np.mean(np.abs(z) < 1) == pytest.approx(0.683, abs=0.1)
    assert np.mean(np.abs(z) < 2) == pytest.approx(0.954, abs=0.04)
    # chi2 of some 20 degrees, 40 times: 1 +- 0.05, and 5 % for the noise that each fit estimates for itself
    assert np.mean(chi2) == pytest.approx(1.0, abs=0.2)


def test_noise_is_estimated_from_what_the_fit_leaves(robot: Robot, mechanism: Machine, truth: dict[str, float]) -> None:
    recording = clean(robot, truth, "position")
    found = [
        fit(pose_problem(robot, with_noise(recording, seed), mechanism.model("18")), errors=mechanism.vector(truth))
        for seed in range(20)
    ]
    sigma = np.sqrt(np.mean([f.sigma[0] ** 2 for f in found]))
    assert sigma == pytest.approx(NOISE, rel=0.05)  # 20 fits of 93 degrees of freedom: 1.6 %
    assert all(f.rms() < f.sigma[0] for f in found)  # the residuals have lost 24 of 117 degrees of freedom


@pytest.mark.parametrize("size", [1e30, 1e160, 1e300])
def test_a_step_beyond_all_numbers_is_taken_back(
    robot: Robot, mechanism: Machine, truth: dict[str, float], monkeypatch: pytest.MonkeyPatch, size: float
) -> None:
    """Without a word of NumPy's about what the machine is there."""
    problem, steps = pose_problem(robot, clean(robot, truth, "position"), mechanism.model("18")), _Steps.step
    far = iter([size, size])

    def step(self: _Steps, damping: float) -> tuple[np.ndarray, float, float]:
        whole, length, gain = steps(self, damping)
        return whole * next(far, 1.0), length, gain

    with using(Backend.NUMPY):
        there = fit(problem)
        monkeypatch.setattr(_Steps, "step", step)
        again = fit(problem)
    assert next(far, None) is None
    assert again.errors == pytest.approx(there.errors, abs=1e-6)


def test_no_figure_depends_on_the_words_of_a_prior(robot: Robot, mechanism: Machine, truth: dict[str, float]) -> None:
    """Distances of positions share the positions' noise: what the prior holds is then added to the scatter."""
    recording = with_noise(clean(robot, truth, "position"), 1)
    problem = pose_problem(robot, recording, mechanism.model("42"), as_distance=True)
    mine, plain = (fit(problem, prior) for prior in (Prior("my workshop's tolerances"), Prior()))
    assert mine.solution.rule == "my workshop's tolerances"
    assert mine.solution.posterior
    assert np.array_equal(mine.covariance, plain.covariance)


# ---------------------------------------------------------------------------------------------------------------- steps


def test_the_fit_converges_from_the_drawings(robot: Robot, mechanism: Machine, truth: dict[str, float]) -> None:
    """Offsets of degrees, in one stage: quadratic, so the last gains are small at once."""
    far = {n: 8 * v if n.startswith("theta") else v for n, v in truth.items()}
    found = fit(pose_problem(robot, clean(robot, far, "position"), mechanism.model("18")))
    assert found.errors == pytest.approx(mechanism.vector(far), abs=1e-8)
    assert len(found.history) < 12


def test_a_fit_without_parameters_aligns_the_instrument_only(
    robot: Robot, mechanism: Machine, truth: dict[str, float]
) -> None:
    recording = clean(robot, {}, "position")
    found = fit(pose_problem(robot, recording, ()))
    assert (found.errors == 0).all()
    assert found.rms() < 1e-9
    ((turn, origin),) = found.instrument.frames()
    assert turn == pytest.approx(FRAME[0], abs=1e-12)
    assert origin == pytest.approx(FRAME[1], abs=1e-8)


def test_parameters_without_data_stay_at_the_robot_file(
    robot: Robot, mechanism: Machine, truth: dict[str, float]
) -> None:
    """Distances see no shift of the base: a robot file that has one keeps it, and the rest is fitted around it."""
    shifted = dataclasses.replace(robot, errors={"ez_1": 0.3, "ez_2": 0.3, "ez_3": 0.3})
    problem = pose_problem(shifted, clean(robot, truth, "distance"), mechanism.model("24"))
    found = fit(problem, Prior())
    e = [found.errors[mechanism.index[f"ez_{i}"]] for i in (1, 2, 3)]
    assert np.mean(e) == pytest.approx(0.3, abs=1e-6)
    assert found.rms() < 1e-6


def test_a_fit_that_does_not_settle_says_so(robot: Robot, mechanism: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    recording = with_noise(clean(robot, plausible(mechanism, 3), "distance"), 2)
    monkeypatch.setattr("deltacal_gen.estimation.fit.MAX_ITERATIONS", 1)
    with pytest.raises(NoSolutionError, match=r"42 parameters did not converge in 1 iterations.*Try a smaller model"):
        fit(pose_problem(robot, recording, mechanism.model("42")), LeastSquares())


def test_a_truncation_keeps_weak_directions_at_the_robot_file(robot: Robot, mechanism: Machine) -> None:
    recording = with_noise(clean(robot, plausible(mechanism, 3), "distance"), 2)
    found = fit(pose_problem(robot, recording, mechanism.model("42")), TSVD(30))
    assert found.solution.factors.sum() == 30
    assert found.rms() < 1.3 * NOISE


def test_unread_rotations_are_left_out(robot: Robot, mechanism: Machine, truth: dict[str, float]) -> None:
    recording = clean(robot, truth, "pose")
    half = recording.measured.copy()
    half[::2, 3:] = np.nan
    problem = pose_problem(robot, dataclasses.replace(recording, measured=half), mechanism.model("18"))
    assert problem.readings.n_scalars == 39 * 3 + 19 * 3
    found = fit(problem)
    assert found.errors == pytest.approx(mechanism.vector(truth), abs=1e-8)
    assert np.isnan(found.residual[0, 3:]).all()


def test_the_controller_s_sign_is_applied(robot: Robot, mechanism: Machine, truth: dict[str, float]) -> None:
    flipped = dataclasses.replace(robot, joint_sign=np.array([1.0, -1.0, -1.0]))
    recording = simulate(flipped, wanted(scattered(robot, 20, 4)), truth, frame=FRAME)
    straight = simulate(robot, wanted(scattered(robot, 20, 4)), truth, frame=FRAME)
    assert recording.joints == pytest.approx(straight.joints * [1, -1, -1], abs=1e-15)
    assert recording.measured == pytest.approx(straight.measured, abs=1e-12)
    found = fit(pose_problem(flipped, recording, mechanism.model("3")))
    assert found.rms() < 1.0


def test_rms_counts_lengths_only_and_each_scalar_once() -> None:
    residual = np.array([[3.0, np.nan, 4.0, 100.0, 100.0, 100.0], [0.0, 0.0, 0.0, np.nan, np.nan, np.nan]])
    assert rms(lengths(residual, kind_of("pose"))) == pytest.approx(np.sqrt(25 / 5))
    assert np.isnan(rms(np.full((2, 3), np.nan)))
    ball = np.array([[1.0, -1.0, 1.0, -1.0], [3.0, 3.0, 3.0, 3.0]])
    assert rms(lengths(ball, kind_of("sphere"))) == pytest.approx(np.sqrt(5))  # of four extremes each counts


# -------------------------------------------------------------------------------------------------------------- repeats


def test_whitening_is_the_inverse_root_of_the_covariance_of_repeats() -> None:
    """Of ``1 + ratio`` on the diagonal and `ratio` between readings of a pose."""
    group = np.array([0, 1, 1, 2, 2, 2, 2, 1])
    ratio = 3.7
    covariance = np.eye(8) + ratio * (group[:, None] == group)
    W = Repeats(group, ratio).whiten(np.eye(8))
    assert W @ covariance @ W.T == pytest.approx(np.eye(8), abs=1e-14)
    assert Repeats(group, 0.0).whiten(np.eye(8)) == pytest.approx(np.eye(8), abs=0)


def test_components_are_whitened_each_by_its_own_ratio() -> None:
    group, ratio = np.array([0, 1, 1, 1]), np.array([3.7, 0.0])
    values = np.random.default_rng(3).standard_normal((4, 2, 5))
    whitened = Repeats(group, ratio).whiten(values)
    for j in range(2):
        assert whitened[:, j] == pytest.approx(Repeats(group, float(ratio[j])).whiten(values[:, j]), abs=1e-14)


def test_positions_that_are_aimed_anew_say_nothing_of_rotations(
    robot: Robot, mechanism: Machine, truth: dict[str, float]
) -> None:
    """Rotations that passed for as sure within a pose as positions are would weigh several times too much."""
    poses = np.repeat(np.vstack([rings(robot, 9), scattered(robot, 20, 4)]), 3, axis=0)
    row = np.repeat(np.arange(len(poses) // 3), 3)
    given = wanted(poses, "pose", pose=[f"P{r}" for r in row])
    rng = np.random.default_rng(8)
    recording = simulate(robot, given, truth, frame=FRAME, noise_mm=0.002, noise_rad=5e-5, rng=rng)
    recording.measured[:, :3] += 0.02 * rng.standard_normal((len(poses), 3))[row]
    found = fit(pose_problem(robot, recording, mechanism.model("18")), errors=mechanism.vector(truth))
    shared = np.broadcast_to(found.repeats.ratio, 6)
    assert shared[:3] == pytest.approx(100.0, rel=0.5)
    assert shared[3:] == pytest.approx(0.0, abs=0.2)


def test_the_ratio_of_variances_is_found() -> None:
    rng = np.random.default_rng(5)
    group = np.repeat(np.arange(300), 4)
    residual = 0.02 * rng.standard_normal((300, 3))[group] + 0.005 * rng.standard_normal((1200, 3))
    ratio, within, degrees = Repeats.ratio_of(residual, group)
    assert degrees == 300 * 3 * 3
    assert np.sqrt(within) == pytest.approx(0.005, rel=0.05)
    assert ratio == pytest.approx(16.0, rel=0.15)  # 900 values: a variance to 5 %
    assert Repeats.ratio_of(residual, np.arange(1200))[2] == 0  # no repeats, nothing known


def test_readings_that_share_nothing_have_the_ratio_zero() -> None:
    rng = np.random.default_rng(6)
    ratio, _, _ = Repeats.ratio_of(rng.standard_normal((1200, 3)), np.repeat(np.arange(300), 4))
    assert ratio < 0.05


@pytest.mark.parametrize("ratio", [0.0, 0.5, 16.0])
def test_means_of_few_readings_tell_less_of_what_poses_share(ratio: float) -> None:
    rng = np.random.default_rng(7)
    group = np.repeat(np.arange(600), np.tile([1, 2, 20], 200))
    shared = np.sqrt(ratio) * rng.standard_normal((600, 2))[group]
    found, _, _ = Repeats.ratio_of(shared + rng.standard_normal((len(group), 2)), group)
    assert found == pytest.approx(ratio, rel=0.15, abs=0.01)  # by means that count alike 0.03 where there is none


def test_only_what_means_of_groups_carry_is_taken_from_them() -> None:
    """One column moves each group as a whole, one its readings against each other, one does both."""
    group = np.repeat(np.arange(5), 2)
    read = np.ones((10, 2), dtype=bool)
    whole, within = np.ones(20), np.tile([1.0, 1.0, -1.0, -1.0], 5)
    taken = np.column_stack([whole, within, (whole + within) / np.sqrt(2)]) / np.sqrt(20)
    assert by_means(taken[:, :1], read, group) == pytest.approx(1.0)
    assert by_means(taken[:, 1:2], read, group) == pytest.approx(0.0)
    assert by_means(taken[:, 2:], read, group) == pytest.approx(0.5)


def repeated(robot: Robot, truth: dict[str, float], counts: np.ndarray) -> Recording:
    """Return poses read `counts` times, each pose with an error of its own ten times the noise of its readings."""
    poses = np.vstack([rings(robot, 9), scattered(robot, 20, 4)])
    row = np.repeat(np.arange(len(poses)), counts)
    recording = simulate(robot, wanted(poses[row], pose=[f"P{r}" for r in row]), truth, frame=FRAME)
    of_pose = 0.02 * np.random.default_rng(11).standard_normal((len(poses), 3))
    noise = 0.002 * np.random.default_rng(12).standard_normal((len(row), 3))
    return dataclasses.replace(recording, measured=recording.measured + of_pose[row] + noise)


def test_a_pose_that_was_read_fifty_times_does_not_dominate(
    robot: Robot, mechanism: Machine, truth: dict[str, float]
) -> None:
    evenly, often = np.full(39, 2), np.full(39, 2)
    often[[7, 20]] = 50
    names, p = mechanism.model("18"), mechanism.vector(truth)

    def tool_errors(counts: np.ndarray, weigh: bool) -> np.ndarray:
        found = fit(pose_problem(robot, repeated(robot, truth, counts), names), errors=p, weigh_repeats=weigh)
        fresh = simulate(robot, wanted(scattered(robot, 50, 30)), truth, frame=FRAME)
        problem = pose_problem(robot, fresh, names)
        return found.instrument.residual(problem.readings, problem.poses(found.errors))

    even = tool_errors(evenly, True)
    weighed, counted = (np.linalg.norm(tool_errors(often, how) - even) for how in (True, False))
    # two readings leave 1 % of a pose's variance to their noise, fifty none of it
    assert weighed < 0.1 * np.linalg.norm(even)
    assert counted > 4 * weighed


def test_a_gross_error_says_nothing_of_what_readings_of_a_pose_share(
    robot: Robot, mechanism: Machine, truth: dict[str, float]
) -> None:
    """One at a pose that was read once would else pass for an error of poses."""
    poses = np.vstack([rings(robot, 9), scattered(robot, 40, 4)])
    row = np.repeat(np.arange(len(poses)), 1 + np.arange(len(poses)) % 2)
    recording = simulate(robot, wanted(poses[row], pose=[f"P{r}" for r in row]), truth, frame=FRAME)
    noise = 0.01 * np.random.default_rng(12).standard_normal((len(row), 3))
    noise[[0, 30]] += 1.0  # both of poses that were read once
    found = fit(
        pose_problem(robot, dataclasses.replace(recording, measured=recording.measured + noise), mechanism.model("18")),
        errors=mechanism.vector(truth),
    )
    assert found.gross.tolist() == [0, 30]
    assert np.max(found.repeats.ratio) < 0.3


# --------------------------------------------------------------------------------------------------------------- pieces


def test_a_subset_holds_its_readings_only(robot: Robot, mechanism: Machine, truth: dict[str, float]) -> None:
    problem: Problem = pose_problem(robot, clean(robot, truth, "position"), mechanism.model("3"))
    part = problem.subset(np.arange(39) % 3 == 0)
    assert len(part.readings) == 13
    found: Fit = fit(part)
    assert found.residual.shape == (13, 3)
    assert problem.with_names(("L_1", "theta_2")).scale == pytest.approx([0.1, np.pi / 180])


def test_the_tool_point_of_a_row_goes_before_the_robot_s(robot: Robot, mechanism: Machine) -> None:
    recording = simulate(robot, wanted(scattered(robot, 4, 1)))
    own = np.full((4, 3), np.nan)
    own[1:] = [1.0, 2.0, 3.0]
    other = dataclasses.replace(robot, tool=np.array([0.0, 0.0, -70.0]))
    problem = pose_problem(other, dataclasses.replace(recording, tool=own), ())
    assert problem.body.tool.tolist() == [[0, 0, -70], [1, 2, 3], [1, 2, 3], [1, 2, 3]]
