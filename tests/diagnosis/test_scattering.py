"""A misfit that moves with one joint is physics of that joint, though no function of anything recorded explains it."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.scattering import scattering
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.rounding import moved_by_steps
from deltacal_gen.machine.values import Recording
from tests.benchmarks.honesty_nulls import drawn
from tests.support.left_out import DELTA, SIGMA, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

N, JOINT = 100, 2
ROBOT = machine()


def restless(size: float, seed: int = 3) -> Recording:
    """Return readings of a machine one joint of which stands elsewhere at every pose, by chance [rad]."""
    quiet = record(ROBOT, n=N, sigma=0.0)
    moved = quiet.joints.copy()
    moved[:, JOINT - 1] += size * np.random.default_rng(seed).standard_normal(N)
    done = record(ROBOT, n=N, joints=np.degrees(moved))
    return dataclasses.replace(done, joints=quiet.joints)


def geometry(recording: Recording) -> Fit:
    problem = pose_problem(ROBOT, recording, DELTA.model(DELTA.full_model))
    return fit(problem, Prior(), drop_gross=False, must_converge=False)


@pytest.mark.walk
def test_the_joint_that_moves_what_is_left_is_told_and_no_noise_is_blamed() -> None:
    found = diagnose(ROBOT, restless(7e-5)).answer()
    assert (found.verdict, found.effects, found.laws) == ("unexplained", (), ())
    assert found.location.limbs == (JOINT,)
    assert "moves readings as one joint does, at limb 2" in found.location.text


@pytest.mark.walk
def test_a_gross_error_beside_it_is_no_part_of_what_is_told() -> None:
    """Nor is a channel that earns next to nothing, which is none that the misfit depends on."""
    made = restless(7e-5)
    made.measured[17] += [60.0, -40.0, 20.0]
    found = diagnose(ROBOT, made).answer()
    assert found.gross_errors == (int(made.line[17]),)
    assert found.location.limbs == (JOINT,)
    assert found.location.channels == ()
    assert f"Residual not explained: {found.final.train_rms_mm:.4f} mm remain" in found.summary
    assert found.final.train_rms_mm < 0.1
    assert "joint 2 coming from either side" in found.next_measurements[-1].text


def test_how_much_of_the_noise_is_the_joints_is_its_share() -> None:
    little, much = (scattering(geometry(restless(size))) for size in (4e-5, 2e-4))
    assert little is not None
    assert much is not None
    assert (little.joint, much.joint) == (JOINT, JOINT)
    assert 1.0 < little.variance < much.variance <= 3.0


@pytest.mark.parametrize("sort", ["white", "t3", "skewed", "gross", "AR 0.9", "AR mixed"])
def test_noise_of_an_instrument_moves_as_no_joint_does(sort: str) -> None:
    exact = record(ROBOT, n=N, sigma=0.0, declared=False)
    for seed in range(4):
        noise = SIGMA * drawn(sort, (N, 3), np.random.default_rng([seed, 5]))
        assert scattering(geometry(dataclasses.replace(exact, measured=exact.measured + noise))) is None


def test_noise_of_a_tracker_that_knows_how_far_better_than_where_to_is_no_joint() -> None:
    exact = record(ROBOT, n=N, sigma=0.0, declared=False)
    towards = exact.measured - exact.measured.mean(axis=0) - np.array([1500.0, 900.0, 400.0])
    towards /= np.linalg.norm(towards, axis=1)[:, None]
    noise = 3 * SIGMA * np.random.default_rng(8).standard_normal((N, 3))
    noise -= 0.8 * (noise * towards).sum(axis=1)[:, None] * towards
    assert scattering(geometry(dataclasses.replace(exact, measured=exact.measured + noise))) is None


def test_a_joint_that_was_written_in_steps_scatters_by_them() -> None:
    exact = record(ROBOT, n=N, sigma=0.1 * SIGMA, declared=False)
    steps = np.array([1e-5, 0.02, 1e-5])  # deg
    rounded = np.radians(np.round(np.degrees(exact.joints) / steps) * steps)
    assert scattering(geometry(dataclasses.replace(exact, joints=rounded))) is None
    rng = np.random.default_rng(2)
    moved = exact.joints + np.radians(steps) * rng.uniform(-0.5, 0.5, exact.joints.shape)  # as much, of no grid
    assert scattering(geometry(dataclasses.replace(exact, joints=moved))) is not None


def test_what_repeats_show_is_noise_whoever_makes_it() -> None:
    made = restless(2e-4)
    twice = dataclasses.replace(
        made, pose=(np.arange(N) // 2).astype(str), joints=np.repeat(made.joints[::2], 2, axis=0)
    )
    at = geometry(made)
    assert scattering(at) is not None
    recording = dataclasses.replace(twice, measured=np.repeat(made.measured[::2], 2, axis=0))
    noise = 0.05 * np.random.default_rng(1).standard_normal((N, 3))
    assert scattering(geometry(dataclasses.replace(recording, measured=recording.measured + noise))) is None


@pytest.mark.walk
def test_cells_that_were_not_measured_are_no_rows_that_are_not_there() -> None:
    """What joints' steps do is asked of every reading by its own row; a diagnosis of such a recording ended there."""
    made = restless(7e-5)
    made.measured[20:30] = np.nan
    read = np.isfinite(made.measured).all(axis=1)
    every, those = (moved_by_steps(geometry(recording)) for recording in (made, made.subset(np.flatnonzero(read))))
    np.testing.assert_allclose(every, those, rtol=1e-6, atol=1e-12)
    assert diagnose(ROBOT, made).verdict == "unexplained"
