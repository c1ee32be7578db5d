"""Validation on readings that the calibration has not seen, and the figures of ISO 9283."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.accuracy import (
    check_poses,
    circle,
    distance_error,
    largest,
    volumetric_error,
    workspace_of,
)
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.use import iso9283
from deltacal_gen.use.validation import validate
from tests.support.prototype import plausible, rings, scattered, wanted

FRAME = (np.array([0.1, -0.2, 0.9]), np.array([900.0, -500.0, 1200.0]))


@pytest.fixture(scope="module")
def truth(mechanism: Machine) -> dict[str, float]:
    return plausible(mechanism, 3, mechanism.model("18"))


@pytest.fixture(scope="module")
def result(robot: Robot, truth: dict[str, float]) -> dict[str, Any]:
    given = wanted(np.vstack([rings(robot, 9), scattered(robot, 20, 4)]))
    recording = simulate(robot, given, truth, noise_mm=0.005, rng=np.random.default_rng(1), frame=FRAME)
    return identify(robot, recording, "18").answer()


def test_fresh_readings_are_as_good_as_their_noise(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    fresh = simulate(
        robot, wanted(scattered(robot, 80, 5)), truth, noise_mm=0.005, rng=np.random.default_rng(2), frame=FRAME
    )
    report = validate(result, fresh)
    assert report["readings"] == 80
    assert report["rms_mm"] == pytest.approx(0.0055, rel=0.15)  # the noise and what calibration leaves
    assert report["chi2_per_dof"] == pytest.approx((report["rms_mm"] / result["sigma_mm"]) ** 2)
    assert "iso9283" not in report  # nothing was repeated


@pytest.mark.parametrize("broken", [{}, {"schema": "deltacal.result/1"}, {"robot": {}}])
def test_what_is_no_result_is_said(tmp_path: Path, broken: dict[str, Any]) -> None:
    (tmp_path / "result.json").write_text(json.dumps(broken))
    for given in (broken, tmp_path / "result.json"):
        with pytest.raises(InputError, match="no result of identify or diagnose"):
            dc.validate(given, tmp_path / "recording.csv")


def test_the_worst_rows_come_first_with_their_lines(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    fresh = simulate(robot, wanted(scattered(robot, 30, 5)), truth, frame=FRAME)
    off = fresh.measured.copy()
    off[11] += [3.0, 4.0, 0.0]
    off[20] += [0.0, 0.0, 1.0]
    report = validate(result, dataclasses.replace(fresh, measured=off))
    assert [row["line"] for row in report["rows"][:2]] == [13, 22]
    assert report["worst_mm"] == pytest.approx(5.0, abs=0.03)
    assert len(report["rows"]) == 10


def test_a_reading_that_went_wrong_stands_apart_from_what_the_machine_does(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    """One touch that slipped was told as the error of the machine, of which it was most."""
    fresh = simulate(
        robot, wanted(scattered(robot, 40, 5)), truth, noise_mm=0.005, rng=np.random.default_rng(2), frame=FRAME
    )
    assert validate(result, fresh).apart is None
    slipped = dataclasses.replace(fresh, measured=fresh.measured + 2.0 * (np.arange(40)[:, None] == 7))
    found = validate(result, slipped)
    assert found.apart is not None
    assert found.apart.lines == (int(fresh.line[7]),)
    assert found.rms_mm > 0.3
    assert found.apart.rms_of_others_mm == pytest.approx(0.0055, rel=0.2)
    two = dataclasses.replace(slipped, measured=slipped.measured + 0.2 * (np.arange(40)[:, None] == 9))
    assert (far := validate(result, two).apart) is not None
    assert far.lines == (int(fresh.line[7]), int(fresh.line[9]))
    assert f"line {fresh.line[7]}: more than three times as far off as any other" in " ".join(found.told)
    worse = dataclasses.replace(fresh, measured=fresh.measured + np.geomspace(0.01, 2.0, 40)[:, None])
    assert validate(result, worse).apart is None  # what the model does not know is of all sizes


ELSEWHERE = (np.array([0.3, 0.2, -0.9]), np.array([-300.0, -500.0, 900.0]))


@pytest.mark.parametrize("setup", ["1", "day 2"])
def test_an_instrument_that_stands_elsewhere_is_placed_by_the_readings(
    robot: Robot, truth: dict[str, float], result: dict[str, Any], setup: str
) -> None:
    given = wanted(scattered(robot, 40, 5), setup=[setup] * 40)
    fresh = simulate(robot, given, truth, noise_mm=0.005, rng=np.random.default_rng(2), frame=ELSEWHERE)
    report = validate(result, fresh)
    assert report["rms_mm"] == pytest.approx(0.0055, rel=0.15)
    assert report["degrees_of_freedom"] == 3 * 40 - 6
    assert report["chi2_per_dof"] == pytest.approx(1.1, abs=0.3)
    (placed,) = report["placed"]
    assert (placed["setup"], placed["unknowns"], placed["left_out"]) == (setup, 6, True)
    far = np.linalg.norm(ELSEWHERE[1] - FRAME[1])
    assert placed["shift_mm"] == pytest.approx(far, abs=1.0)
    assert placed["rms_where_known_mm"] > 100


def test_errors_are_of_poses_that_took_no_part_in_placing(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    """Repeats of a pose stay together: left out one by one they would vouch for one another."""
    names = [f"P{j // 2}" for j in range(12)]
    given = wanted(np.repeat(scattered(robot, 6, 5), 2, axis=0), pose=names)
    fresh = simulate(robot, given, truth, frame=ELSEWHERE)
    off = fresh.measured.copy()
    off[:2] += [0.0, 0.0, 5.0]
    report = validate(result, dataclasses.replace(fresh, measured=off))
    assert [row["line"] for row in report["rows"][:2]] == [2, 3]
    assert report["rows"][0]["error_mm"] == pytest.approx(5.0, abs=0.01)


def test_set_ups_known_and_unknown_in_one_recording(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    given = wanted(scattered(robot, 30, 5), setup=["1"] * 10 + ["b"] * 20)
    report = validate(result, simulate(robot, given, truth, frame=FRAME))
    assert [(p["setup"], p["why"]) for p in report["placed"]] == [("b", "unknown")]
    assert report["rms_mm"] < 0.01


def test_a_machine_that_has_changed_is_no_instrument_that_moved(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    other = truth | {"theta_1": truth["theta_1"] + 0.01}
    report = validate(result, simulate(robot, wanted(scattered(robot, 30, 5)), other, frame=FRAME))
    assert report["rms_mm"] > 1.0
    assert "placed" not in report


def test_two_readings_leave_open_where_an_instrument_stands(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    given = wanted(scattered(robot, 12, 5), setup=["1"] * 10 + ["b"] * 2)
    with pytest.raises(InputError, match="the 2 readings of the set-up 'b' leave open where it stands"):
        validate(result, simulate(robot, given, truth, frame=FRAME))


def test_figures_of_the_standard_do_not_depend_on_where_the_instrument_stands(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    names = [f"P{j // 10}" for j in range(100)]
    given = wanted(np.repeat(scattered(robot, 10, 5), 10, axis=0), pose=names)
    here, there = (
        validate(result, simulate(robot, given, truth, noise_mm=0.01, rng=np.random.default_rng(2), frame=frame))
        for frame in (FRAME, ELSEWHERE)
    )
    for key in ("RP_mean_mm", "RP_max_mm", "AP_mean_mm"):
        assert there["iso9283"][key] == pytest.approx(here["iso9283"][key], rel=0.35)


def test_repeats_give_the_figures_of_the_standard(
    robot: Robot, truth: dict[str, float], result: dict[str, Any]
) -> None:
    targets = np.repeat(scattered(robot, 10, 5), 30, axis=0)
    names = [f"P{j // 30}" for j in range(300)]
    fresh = simulate(
        robot, wanted(targets, pose=names), truth, noise_mm=0.01, rng=np.random.default_rng(2), frame=FRAME
    )
    figures = validate(result, fresh)["iso9283"]
    assert figures["poses"] == 10
    # distances from the mean of normal readings are Maxwell: mean 1.596 sigma, deviation 0.673 sigma
    assert figures["RP_mean_mm"] == pytest.approx((1.596 + 3 * 0.673) * 0.01, rel=0.1)
    assert figures["AP_mean_mm"] < 0.01
    assert figures["RP_max_mm"] >= figures["RP_mean_mm"]


def test_accuracy_and_repeatability_of_a_case_worked_by_hand() -> None:
    attained = np.array([[1.0, 0.0, 2.0], [-1.0, 0.0, 2.0], [0.0, 1.0, 2.0], [0.0, -1.0, 2.0]])
    figures = iso9283.pose(attained, np.zeros(3))
    assert (figures.accuracy, figures.readings) == (pytest.approx(2.0), 4)
    assert figures.repeatability == pytest.approx(1.0)  # all one unit off the mean: no deviation
    two = iso9283.pose(np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 4.0]]), np.array([3.0, 0.0, 2.0]))
    assert (two.accuracy, two.repeatability) == (pytest.approx(3.0), pytest.approx(2.0))
    with pytest.raises(ValueError, match="at least two visits"):
        iso9283.pose(attained[:1], np.zeros(3))


# ----------------------------------------------------------------------------------- the measures and poses of Bai 2015


def test_the_check_poses_are_the_paper_s(robot: Robot) -> None:
    """Section 5.2: radii 250 and 500 mm in the top, middle and bottom layers, 96 beside home."""
    poses = check_poses(workspace_of(robot))
    assert len(poses) == 97
    assert poses[0].tolist() == [0.0, 0.0, -853.0]
    radius, z = np.linalg.norm(poses[1:, :2], axis=1), poses[1:, 2]
    found = {(round(float(r), 6), round(float(h), 6)) for r, h in zip(radius, z, strict=True)}
    assert found == {(r, h) for r in (250.0, 500.0) for h in (-728.0, -853.0, -978.0)}


def test_a_circle_starts_where_it_is_told(robot: Robot) -> None:
    points = circle(workspace_of(robot), 1.0, 0.5, 4, start=np.pi / 2)
    assert points == pytest.approx(
        np.array([[0, 250, -978], [-250, 0, -978], [0, -250, -978], [250, 0, -978]]), abs=1e-9
    )


def test_a_robot_without_a_cylinder_is_told_so(robot: Robot) -> None:
    with pytest.raises(InputError, match=r"no \[workspace\] with top, radius and height"):
        workspace_of(dataclasses.replace(robot, workspace=None))


def test_the_distance_error_knows_no_frame_and_the_volumetric_error_takes_the_best() -> None:
    rng = np.random.default_rng(1)
    wanted_points = 300 * rng.standard_normal((20, 3))
    actual = wanted_points + 0.1 * rng.standard_normal((20, 3))
    turn, shift = from_vector(np.array([0.3, 1.0, -0.4])), np.array([100.0, 5.0, -30.0])
    moved = actual @ turn.T + shift
    assert distance_error(moved, wanted_points) == pytest.approx(distance_error(actual, wanted_points), abs=1e-9)
    assert volumetric_error(moved, wanted_points) == pytest.approx(volumetric_error(actual, wanted_points), abs=1e-9)
    assert volumetric_error(moved, wanted_points, turn=turn) == pytest.approx(
        np.linalg.norm((actual - actual[0]) - (wanted_points - wanted_points[0]), axis=1), abs=1e-9
    )
    assert distance_error(actual, wanted_points)[0] == 0.0


def test_the_errors_of_a_case_worked_by_hand() -> None:
    at = np.array([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 20.0, 0.0]])
    actual = at + np.array([[1.0, 1.0, 1.0], [1.5, 1.0, 1.0], [1.0, 0.0, 1.0]])
    assert distance_error(actual, at) == pytest.approx([0.0, 0.5, -1.0])
    assert volumetric_error(actual, at, turn=np.eye(3)) == pytest.approx([0.0, 0.5, 1.0])
    assert largest(distance_error(actual, at)) == pytest.approx(1.0)
    assert largest([]) == 0.0
