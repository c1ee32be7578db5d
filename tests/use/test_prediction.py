"""Prediction: the identified machine at other joints, in the instrument's frame."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank, kept_term, load_effect
from deltacal_gen.results.parts import MachineState
from deltacal_gen.results.reader import read_result
from deltacal_gen.results.result import Result
from deltacal_gen.use.prediction import calibrated_robot, place_of, predict, residual, told_of_events
from deltacal_gen.use.validation import validate
from tests.support.prototype import plausible, rings, scattered, wanted

FRAME = (np.array([0.1, -0.2, 0.9]), np.array([900.0, -500.0, 1200.0]))


@pytest.fixture(scope="module")
def truth(mechanism: Machine) -> dict[str, float]:
    return plausible(mechanism, 3, mechanism.model("18"))


def measured(robot: Robot, truth: dict[str, float], kind: str, targets: np.ndarray, **more: Any) -> Recording:
    return simulate(robot, wanted(targets, kind, **more), truth, frame=FRAME)


@pytest.fixture(scope="module")
def results(robot: Robot, truth: dict[str, float]) -> dict[str, Result]:
    """Results from noise-free readings, as they come back from a file."""
    poses = rings(robot, 9)
    pairs = np.column_stack(np.triu_indices(len(poses), 1))
    found = {
        kind: identify(robot, measured(robot, truth, kind, poses, **more), "18").answer().to_json()
        for kind, more in (("position", {}), ("pose", {}), ("distance", {"pairs": pairs}))
    }
    return {kind: read_result(json.loads(text)) for kind, text in found.items()}


@pytest.mark.parametrize("kind", ["position", "pose"])
def test_readings_are_predicted_in_the_instrument_s_frame(
    robot: Robot, truth: dict[str, float], results: dict[str, Result], kind: str
) -> None:
    fresh = measured(robot, truth, kind, scattered(robot, 20, 8))
    blank = dataclasses.replace(fresh, measured=np.full_like(fresh.measured, np.nan))
    assert predict(results[kind], blank).measured == pytest.approx(fresh.measured, abs=1e-6)


@pytest.mark.parametrize("kind", ["position", "pose"])
@pytest.mark.parametrize("setup", ["1", "day 2"])
def test_a_set_up_is_placed_by_other_poses_and_the_readings_asked_for_are_not_read(
    robot: Robot, truth: dict[str, float], results: dict[str, Result], kind: str, setup: str
) -> None:
    elsewhere = (np.array([0.3, 0.2, -0.9]), np.array([-300.0, -500.0, 900.0]))
    many = wanted(scattered(robot, 30, 8), kind, setup=[setup] * 30)
    day = simulate(robot, many, truth, frame=elsewhere)
    other, asked = (take(day, rows, name) for rows, name in ((slice(0, 10), "other.csv"), (slice(10, 30), "asked.csv")))
    spoiled = dataclasses.replace(asked, measured=asked.measured + 1000.0)
    predicted = predict(results[kind], spoiled, place_of(other, spoiled))
    assert predicted.measured == pytest.approx(asked.measured, abs=1e-5)


def test_readings_are_not_placed_by_themselves(robot: Robot, truth: dict[str, float]) -> None:
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8))
    with pytest.raises(InputError, match="by the readings that are to be predicted"):
        place_of(fresh, fresh)


def test_a_set_up_that_nothing_places_is_refused_with_the_way_out(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8), setup=["a"] * 3 + ["b"] * 3)
    with pytest.raises(InputError, match=r"predict --place OTHER\.csv"):
        predict(results["position"], fresh)


def test_positions_are_validated_and_placed_by_a_result_of_distances(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    fresh = measured(robot, truth, "position", scattered(robot, 20, 8))
    report = validate(results["distance"], fresh)
    assert report.rms_mm < 1e-5
    assert [p.why for p in report.placed or ()] == ["unknown"]


def take(recording: Recording, rows: slice, name: str) -> Recording:
    """Return some rows of a recording, as of a file of their own."""
    return dataclasses.replace(
        recording,
        path=Path(name),
        joints=recording.joints[rows],
        measured=recording.measured[rows],
        pose=recording.pose[rows],
        line=recording.line[rows],
        setup=recording.setup[rows],
        tool=None if recording.tool is None else recording.tool[rows],
        channels={key: values[rows] for key, values in recording.channels.items()},
    )


def test_distances_are_predicted_by_any_result(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    fresh = measured(robot, truth, "distance", scattered(robot, 6, 8), pairs=np.array([[0, 1], [2, 5], [3, 1]]))
    for result in results.values():
        assert predict(result, fresh).pair_measured == pytest.approx(fresh.pair_measured, abs=1e-6)


def test_positions_are_predicted_from_poses(robot: Robot, truth: dict[str, float], results: dict[str, Result]) -> None:
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8))
    assert predict(results["pose"], fresh).measured == pytest.approx(fresh.measured, abs=1e-6)


def test_the_robot_s_own_frame_needs_no_instrument(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    """Distances fix eq. (11)'s frame with model 18, so positions in {O} are known from them."""
    inside = simulate(robot, wanted(scattered(robot, 6, 8), frame="robot"), truth)
    assert predict(results["distance"], inside).measured == pytest.approx(inside.measured, abs=1e-6)


def test_a_gauge_is_predicted_where_the_sidecar_says_it_stands(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    for zero in ("absolute", "incremental"):
        more = {"base_point_mm": (300.0, 10.0, -20.0), "zero": zero}
        fresh = measured(robot, truth, "gauge", scattered(robot, 6, 8), **more)
        assert predict(results["position"], fresh).measured == pytest.approx(fresh.measured, abs=1e-6)
        told: list[str] = []
        dc.predict(results["position"], fresh, tell=told.append)
        assert any("changes from the first row" in words for words in told) == (zero == "incremental")


def test_a_frame_that_is_not_known_is_not_invented(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8))
    with pytest.raises(InputError, match="identified from readings of the kind 'distance' and knows no frame"):
        predict(results["distance"], fresh)


def test_another_tool_point_is_predicted_too(robot: Robot, truth: dict[str, float], results: dict[str, Result]) -> None:
    """Model 18 turns nothing, so what was measured at one point holds for all."""
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8), tool=np.array([40.0, 20.0, -80.0]))
    assert predict(results["position"], fresh).measured == pytest.approx(fresh.measured, abs=1e-6)


def test_the_calibrated_robot_carries_the_errors(
    mechanism: Machine, truth: dict[str, float], results: dict[str, Result]
) -> None:
    errors = calibrated_robot(results["position"]).errors
    for name, value in truth.items():
        assert errors[name] == pytest.approx(value, abs=1e-4 * mechanism.typical[mechanism.index[name]])


def test_residuals_are_measured_minus_predicted(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    from deltacal_gen.instrument.kinds import readings

    fresh = measured(robot, truth, "position", scattered(robot, 6, 8))
    off = dataclasses.replace(fresh, measured=fresh.measured + np.array([0.1, 0.2, 0.3]))
    assert residual(results["position"], off, readings(off)) == pytest.approx(
        np.tile([0.1, 0.2, 0.3], (6, 1)), abs=1e-6
    )


# --- with the effects of a diagnosis ----------------------------------------------------------------------------------


class ByRow(MachineState):
    """A machine of which a moment is known by the row that it came before."""

    @property
    def clock(self) -> Literal["time_s", "row"]:
        return "row"


def with_effects(result: Result, *terms: Term, kind: type[MachineState] = MachineState) -> MachineState:
    """Return a result as a diagnosis with these effects would have it."""
    return kind(robot=result.robot, physics=tuple(map(kept_term, terms)), instrument=result.instrument)


def effect(name: str, value: float, limbs: tuple[int, ...] = (2,), constants: tuple[float, ...] = ()) -> Term:
    bare = blank(name, limbs, constants)
    factors = [factor for _, _, factor, _ in load_effect(name).COEFFICIENTS]
    return bare.with_values(value * np.array(factors) * np.ones_like(bare.values))


def told(n: int) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(12)
    names = ("approach1", "approach2", "approach3")
    found = {name: rng.choice([-1.0, 1.0], n) for name in names}
    return found | {"temp_C": rng.uniform(18, 30, n), "time_s": np.linspace(0, 3600, n)}


@pytest.mark.parametrize("kind", ["position", "pose", "distance", "gauge"])
def test_a_diagnosis_predicts_its_effects_from_the_channels(
    robot: Robot, truth: dict[str, float], results: dict[str, Result], kind: str
) -> None:
    terms = (effect("backlash", 0.1), effect("thermal_zero", 0.01, (1, 3)), effect("instrument_scale", 50.0))
    more: dict[str, Any] = {"pairs": np.array([[0, 1], [2, 5], [3, 1]])} if kind == "distance" else {}
    more |= {"base_point_mm": (300.0, 10.0, -20.0)} if kind == "gauge" else {}
    poses = wanted(scattered(robot, 6, 8), kind, channels=told(6), **more)
    fresh = simulate(robot, poses, truth, frame=FRAME, terms=terms)
    result = results[kind if kind in results else "position"]
    done = predict(with_effects(result, *terms), fresh)
    measured_then, predicted = (r.pair_measured if kind == "distance" else r.measured for r in (fresh, done))
    assert predicted == pytest.approx(measured_then, abs=1e-6)
    without = predict(result, fresh)
    assert np.abs((without.pair_measured if kind == "distance" else without.measured) - measured_then).max() > 0.05


@pytest.mark.parametrize(
    ("name", "missing"),
    [("backlash", "approach2"), ("thermal_zero", "temp_C"), ("zero_drift", "time_s"), ("thermal_growth", "temp_C")],
)
def test_a_channel_that_is_not_given_is_asked_for(
    robot: Robot, truth: dict[str, float], results: dict[str, Result], name: str, missing: str
) -> None:
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8), channels=told(6))
    channels = {k: v for k, v in fresh.channels.items() if k != missing}
    found = with_effects(results["position"], effect(name, 1e-5))
    predict(found, fresh)
    with pytest.raises(InputError, match=rf"what was diagnosed \({name}\) needs the column.*{missing}"):
        predict(found, dataclasses.replace(fresh, channels=channels))
    with pytest.raises(InputError) as refused:
        predict(found, dataclasses.replace(fresh, channels={}))
    assert ("; or time_s, and run" in str(refused.value)) is (name == "backlash")  # of which ways of approach are made


def test_other_rows_of_a_series_stand_before_or_after_a_jump_by_the_numbers_of_their_poses(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    """Where poses of both are numbered as they were measured, and none is in both: a series measured anew has them."""

    class Odd(ByRow):
        @property
        def poses(self) -> tuple[int, ...]:
            return (1, 3, 5, 7, 9, 11)

    fresh = measured(robot, truth, "position", scattered(robot, 6, 8))
    jumped = with_effects(results["position"], effect("zero_jump", 0.1, constants=(3.0,)), kind=Odd)  # before pose 7
    before = predict(with_effects(results["position"], kind=Odd), fresh).measured

    def moved(*poses: str) -> list[bool]:
        numbered = dataclasses.replace(fresh, pose=np.array(poses))
        return (np.abs(predict(jumped, numbered).measured - before).max(axis=1) > 0.01).tolist()

    assert moved("2", "4", "4", "8", "10", "12") == [False] * 3 + [True] * 3
    assert moved("12", "13", "14", "15", "16", "17") == [True] * 6
    assert not any(moved("0", "0", "0", "0", "0", "0"))
    assert all(moved("1", "2", "4", "6", "8", "10"))  # the series anew
    assert all(moved("4", "2", "6", "8", "10", "12"))  # not as measured
    assert all(moved("a", "b", "c", "d", "e", "f"))
    assert "by the numbers of their poses" in str(
        told_of_events(jumped, dataclasses.replace(fresh, pose=np.array(["2", "4", "6", "8", "10", "12"])))
    )


def test_a_jump_that_was_found_by_its_row_is_past(
    robot: Robot, truth: dict[str, float], results: dict[str, Result]
) -> None:
    jump = effect("zero_jump", 0.1, constants=(30.0,))
    fresh = measured(robot, truth, "position", scattered(robot, 6, 8), channels={"time_s": np.zeros(6)})
    after = predict(with_effects(results["position"], jump, kind=ByRow), fresh).measured
    before = predict(with_effects(results["position"], jump), fresh).measured
    assert before == pytest.approx(fresh.measured, abs=1e-6)
    assert np.abs(after - before).max() > 0.3
    by_row, by_time = with_effects(results["position"], jump, kind=ByRow), with_effects(results["position"], jump)
    untimed = dataclasses.replace(fresh, channels={})
    assert "after the zero_jump that was found: the recording that was" in str(told_of_events(by_row, fresh))
    assert "after the zero_jump that was found: the readings had no time_s" in str(told_of_events(by_time, untimed))
    assert told_of_events(by_time, fresh) is None
    assert told_of_events(results["position"], untimed) is None
