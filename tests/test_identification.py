"""Identification: what was simulated is found again, with honest uncertainties, from every kind of reading."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest
from conftest import plausible, rings, scattered, wanted

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.identification import Identification, folds, identify
from deltacal_gen.mechanism import Mechanism
from deltacal_gen.prediction import predict
from deltacal_gen.recording import Recording
from deltacal_gen.robot import Robot
from deltacal_gen.simulation import simulate
from deltacal_gen.units import DEG, to_internal

NOISE = 0.005  # mm, a laser tracker
BASE_POINT = (420.0, -150.0, 40.0)
POINT = np.array([25.0, -10.0, -45.0])


def poses_of(robot: Robot) -> np.ndarray:
    """Return 19 poses on the rim and 20 anywhere: more than any model needs."""
    return np.vstack([rings(robot, 9), scattered(robot, 20, 4)])


def asked(robot: Robot, kind: str, poses: np.ndarray, **more: Any) -> Recording:
    """Return what is to be measured at `poses` for a kind; every fourth possible pair for distances."""
    if kind.startswith("gauge"):
        zero = "incremental" if kind == "gauge, incremental" else "absolute"
        return wanted(poses, "gauge", base_point_mm=BASE_POINT, platform_point_mm=tuple(POINT), zero=zero, **more)
    if kind == "distance":
        pairs = np.column_stack(np.triu_indices(len(poses), 1))[::4]
        return wanted(poses, "distance", tool=POINT, pairs=pairs, **more)
    return wanted(poses, kind, tool=POINT, **more)


def values(recording: Recording) -> np.ndarray:
    """Return what was read: lengths, or lengths and rotations."""
    found = recording.measured if recording.pair_measured is None else recording.pair_measured
    assert found is not None
    return found


def in_deviations(found: Identification, truth: dict[str, float]) -> np.ndarray:
    """Return (value - truth) / std of the identified parameters of a RESULT.json."""
    out = []
    for entry in found.to_dict()["parameters"]:
        if entry["status"] == "identified":
            unit = to_internal("rad" if entry["unit"] == "deg" else "mm")
            out.append((entry["value"] * unit - truth.get(entry["name"], 0.0)) / (entry["std"] * unit))
    return np.array(out)


KINDS = ["position", "pose", "distance", "gauge", "gauge, incremental"]


@pytest.mark.parametrize("model", ["18", "42"])
@pytest.mark.parametrize("kind", KINDS)
def test_without_noise_fresh_readings_are_predicted_exactly(
    robot: Robot, mechanism: Mechanism, kind: str, model: str
) -> None:
    truth = plausible(mechanism, 3, mechanism.model(model))
    poses = np.vstack([poses_of(robot), scattered(robot, 60, 9)]) if kind.startswith("gauge") else poses_of(robot)
    rng = np.random.default_rng(5)
    frame = (np.array([0.4, -0.2, 2.0]), np.array([1500.0, -800.0, 900.0]))
    recording = simulate(robot, asked(robot, kind, poses), truth, rng=rng, frame=frame)
    fresh = simulate(robot, asked(robot, kind, scattered(robot, 25, 77)), truth, rng=rng, frame=frame)
    result = identify(robot, recording, model).to_dict()
    assert result["train_rms_mm"] < 1e-7
    assert result["heldout_rms_mm"] < 1e-6
    got, want = values(predict(result, fresh)), values(fresh)
    if kind == "gauge, incremental":
        assert got == pytest.approx(want, abs=1e-6)
    else:
        assert got == pytest.approx(want, abs=1e-6)


def test_a_gauge_is_found_where_it_is_and_not_where_the_sidecar_says(robot: Robot, mechanism: Mechanism) -> None:
    truth = plausible(mechanism, 3, mechanism.model("18"))
    poses = np.vstack([poses_of(robot), scattered(robot, 60, 9)])
    recording = simulate(robot, asked(robot, "gauge", poses), truth)
    nominal = recording.measurement.model_copy(update={"base_point_mm": (421.5, -152.0, 39.0)})
    found = identify(robot, dataclasses.replace(recording, measurement=nominal), "18")
    fresh = simulate(robot, asked(robot, "gauge", scattered(robot, 25, 77)), truth)
    assert values(predict(found.to_dict(), fresh)) == pytest.approx(values(fresh), abs=1e-6)


@pytest.mark.parametrize("kind", ["position", "distance", "pose", "gauge"])
def test_errors_are_as_large_as_they_are_said_to_be(robot: Robot, mechanism: Mechanism, kind: str) -> None:
    """Monte Carlo over 30 noises: values lie off the truth by their stated deviations, no more and no less."""
    truth = plausible(mechanism, 3, mechanism.model("18"))
    poses = np.vstack([poses_of(robot), scattered(robot, 30, 9)]) if kind == "gauge" else poses_of(robot)
    deviations, mahalanobis = [], []
    for seed in range(30):
        rng = np.random.default_rng(seed)
        recording = simulate(robot, asked(robot, kind, poses), truth, noise_mm=NOISE, noise_rad=2e-5, rng=rng)
        found = identify(robot, recording, "18")
        deviations.append(in_deviations(found, truth))
        columns = found.fit.problem.columns
        gap = found.fit.errors[columns] - mechanism.vector(truth)[columns]
        C = found.fit.covariance[:18, :18]
        mahalanobis.append(gap @ np.linalg.solve(C, gap) / 18)
    z = np.concatenate(deviations)
    print(kind, len(z), np.sqrt(np.mean(z**2)), np.mean(np.abs(z) < 2), np.mean(mahalanobis))
    assert len(z) > 30 * 12
    assert np.mean(np.abs(z) < 1) == pytest.approx(0.68, abs=0.12)
    assert np.mean(np.abs(z) < 2) == pytest.approx(0.954, abs=0.05)
    # chi2 with 18 degrees, 30 times: mean 1, deviation sqrt(2 / 540) = 0.06, and some for the estimated noise
    assert np.mean(mahalanobis) == pytest.approx(1.0, abs=0.25)
