"""Prediction: the identified machine at other joints, in the instrument's frame."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

import numpy as np
import pytest
from conftest import plausible, rings, scattered, wanted

from deltacal_gen.errors import InputError
from deltacal_gen.identification import identify
from deltacal_gen.mechanism import Mechanism
from deltacal_gen.prediction import calibrated_robot, predict, residual
from deltacal_gen.recording import Recording
from deltacal_gen.robot import Robot
from deltacal_gen.simulation import simulate

FRAME = (np.array([0.1, -0.2, 0.9]), np.array([900.0, -500.0, 1200.0]))


@pytest.fixture(scope="module")
def truth(mechanism: Mechanism) -> dict[str, float]:
    return plausible(mechanism, 3, mechanism.model("18"))


def measured(robot: Robot, truth: dict[str, float], kind: str, targets: np.ndarray, **more: Any) -> Recording:
    return simulate(robot, wanted(targets, kind, **more), truth, frame=FRAME)


@pytest.fixture(scope="module")
def results(robot: Robot, truth: dict[str, float]) -> dict[str, dict[str, Any]]:
    """Results from noise-free readings, as they come back from a file."""
    poses = rings(robot, 9)
    pairs = np.column_stack(np.triu_indices(len(poses), 1))
    return {
        kind: json.loads(json.dumps(identify(robot, measured(robot, truth, kind, poses, **more), "18").to_dict()))
        for kind, more in (("position", {}), ("pose", {}), ("distance", {"pairs": pairs}))
    }


@pytest.mark.parametrize("kind", ["position", "pose"])
def test_readings_are_predicted_in_the_instrument_s_frame(
    robot: Robot, truth: dict[str, float], results: dict[str, dict[str, Any]], kind: str
) -> None:
    fresh = measured(robot, truth, kind, scattered(robot, 20, 8))
    blank = dataclasses.replace(fresh, measured=np.full_like(fresh.measured, np.nan))
    assert predict(results[kind], blank).measured == pytest.approx(fresh.measured, abs=1e-6)


def test_distances_are_predicted_by_any_result(
    robot: Robot, truth: dict[str, float], results: dict[str, dict[str, Any]]
) -> None:
    fresh = measured(robot, truth, "distance", scattered(robot, 6, 8), pairs=np.array([[0, 1], [2, 5], [3, 1]]))
    for result in results.values():
        assert predict(result, fresh).pair_measured == pytest.approx(fresh.pair_measured, abs=1e-6)


def test_positions_are_predicted_from_poses(
    robot: Robot, truth: dict[str, float], results: dict[str, dict[str, Any]]
) -> None:
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8))
    assert predict(results["pose"], fresh).measured == pytest.approx(fresh.measured, abs=1e-6)


def test_the_robot_s_own_frame_needs_no_instrument(
    robot: Robot, truth: dict[str, float], results: dict[str, dict[str, Any]]
) -> None:
    """Distances fix eq. (11)'s frame with model 18, so positions in {O} are known from them."""
    inside = simulate(robot, wanted(scattered(robot, 6, 8), frame="robot"), truth)
    assert predict(results["distance"], inside).measured == pytest.approx(inside.measured, abs=1e-6)


def test_a_gauge_is_predicted_where_the_sidecar_says_it_stands(
    robot: Robot, truth: dict[str, float], results: dict[str, dict[str, Any]]
) -> None:
    for zero in ("absolute", "incremental"):
        more = {"base_point_mm": (300.0, 10.0, -20.0), "zero": zero}
        fresh = measured(robot, truth, "gauge", scattered(robot, 6, 8), **more)
        assert predict(results["position"], fresh).measured == pytest.approx(fresh.measured, abs=1e-6)


def test_a_frame_that_is_not_known_is_not_invented(
    robot: Robot, truth: dict[str, float], results: dict[str, dict[str, Any]]
) -> None:
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8))
    with pytest.raises(InputError, match="identified from readings of the kind 'distance' and knows no frame"):
        predict(results["distance"], fresh)


def test_another_tool_point_is_predicted_too(
    robot: Robot, truth: dict[str, float], results: dict[str, dict[str, Any]]
) -> None:
    """Model 18 turns nothing, so what was measured at one point holds for all."""
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8), tool=np.array([40.0, 20.0, -80.0]))
    assert predict(results["position"], fresh).measured == pytest.approx(fresh.measured, abs=1e-6)


def test_the_calibrated_robot_carries_the_errors(
    mechanism: Mechanism, truth: dict[str, float], results: dict[str, dict[str, Any]]
) -> None:
    errors = calibrated_robot(results["position"]).errors
    for name, value in truth.items():
        assert errors[name] == pytest.approx(value, abs=1e-4 * mechanism.typical[mechanism.index[name]])


def test_residuals_are_measured_minus_predicted(
    robot: Robot, truth: dict[str, float], results: dict[str, dict[str, Any]]
) -> None:
    from deltacal_gen.measurement import readings

    fresh = measured(robot, truth, "position", scattered(robot, 6, 8))
    off = dataclasses.replace(fresh, measured=fresh.measured + np.array([0.1, 0.2, 0.3]))
    assert residual(results["position"], off, readings(off)) == pytest.approx(
        np.tile([0.1, 0.2, 0.3], (6, 1)), abs=1e-6
    )
