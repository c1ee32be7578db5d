"""The diagnosis: each verdict, the file it writes, and what can be done with it."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis.conclusion import Named
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.strategy import borne_out as speak_for
from deltacal_gen.diagnosis.words import indistinguishable
from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.places import places_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.pages import figures
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import effect_names
from tests.support.left_out import DELTA, POSES, SIGMA, channels, diagnosis, effect, machine, named, record
from tests.support.prototype import plausible

pytestmark = pytest.mark.usefixtures("compiled")

WIDTH = 0.02  # deg of backlash: 0.12 mm at the platform, twelve times the noise
NUMBER = (int, float)
MOVED = channels(70, "motion", seed=3)
SCHEMA: dict[str, Any] = {  # contract, section 4
    "schema": str,
    "verdict": str,
    "summary": str,
    "noise": {"sigma_mm": NUMBER, "source": str},
    "baseline": {"model": str, "train_rms_mm": NUMBER, "heldout_rms_mm": NUMBER, "chi2_per_dof": NUMBER},
    "location": {
        "channels": [{"name": str, "p_value": NUMBER, "share": NUMBER}],
        "limbs": [int],
        "region": ({"centre_mm": [NUMBER], "radius_mm": NUMBER}, None),
        "text": str,
    },
    "effects": [
        {
            "name": str,
            "limbs": [int],
            "parameters": [{"name": str, "limb": (int, None), "value": NUMBER, "std": (NUMBER, None), "unit": str}],
            "p_value": NUMBER,
            "share_of_excess": NUMBER,
            "indistinguishable_from": [str],
        }
    ],
    "final": {"train_rms_mm": NUMBER, "heldout_rms_mm": NUMBER, "chi2_per_dof": NUMBER},
    "rejected": [{"name": str, "why": str}],
    "next_measurements": [{"why": str, "poses": [dict]}],
}


def conforms(value: Any, schema: Any, where: str = "") -> None:
    """Assert that a value has all keys and types of a schema; further keys are allowed."""
    if isinstance(schema, dict):
        assert isinstance(value, dict), where
        for key, part in schema.items():
            assert key in value, f"{where}.{key} is missing"
            conforms(value[key], part, f"{where}.{key}")
    elif isinstance(schema, list):
        assert isinstance(value, list), where
        for item in value:
            conforms(item, schema[0], f"{where}[]")
    elif isinstance(schema, tuple) and None in schema:
        if value is not None:
            conforms(value, schema[0], where)
    else:
        assert isinstance(value, schema), f"{where} is {value!r}"
        assert not isinstance(value, bool), where


@pytest.fixture(scope="module")
def robot() -> Robot:
    return machine(transmission={"gear_ratio": 20.5})


@pytest.fixture(scope="module")
def sound(robot: Robot) -> dict[str, Any]:
    return diagnosis(robot, record(robot, of=channels(POSES, "approach", "temp")))


@pytest.fixture(scope="module")
def loose_recording(robot: Robot) -> Recording:
    return record(robot, effect("backlash", (2,), WIDTH), of=channels(POSES, "approach", "temp", "time"))


@pytest.fixture(scope="module")
def loose(robot: Robot, loose_recording: Recording) -> dict[str, Any]:
    return diagnosis(robot, loose_recording)


def bumpy(recording: Recording, robot: Robot, reach: float = 90.0, much: float = 0.3) -> tuple[Recording, np.ndarray]:
    """Return readings moved by up to `much` mm around a place of the workspace, and that place."""
    centre = np.array([250.0, 100.0, -850.0])
    x = simulate(robot, dataclasses.replace(recording, channels={}), frame=(np.zeros(3), np.zeros(3))).measured
    bump = np.exp(-0.5 * np.sum(((x - centre) / reach) ** 2, axis=1))
    return dataclasses.replace(recording, measured=recording.measured + much * bump[:, None] * [0.6, -0.6, 0.5]), centre


@pytest.fixture(scope="module")
def dented(robot: Robot) -> tuple[dict[str, Any], np.ndarray]:
    recording, centre = bumpy(record(robot, n=140, of=channels(140, "temp")), robot)
    return diagnosis(robot, recording), centre


# ---------------------------------------------------------------------------------------------------- the verdicts


@pytest.mark.parametrize(("kind", "n"), [("position", POSES), ("pose", 30), ("distance", POSES), ("gauge", 130)])
def test_where_nothing_is_missing_nothing_is_named(robot: Robot, kind: str, n: int) -> None:
    how = {"base_point_mm": (0.0, 0.0, -1400.0)} if kind == "gauge" else {}
    found = diagnosis(robot, record(robot, kind=kind, n=n, of=channels(n, "approach", "temp", "time"), **how))
    assert found["verdict"] == "adequate"
    assert found["effects"] == []
    assert found["final"]["chi2_per_dof"] == pytest.approx(1.0, abs=0.4)


def test_what_is_missing_is_named_with_its_limb_and_its_size(loose: dict[str, Any]) -> None:
    assert loose["verdict"] == "missing_physics"
    assert named(loose) == [("backlash", [2])]
    [width] = loose["effects"][0]["parameters"]
    assert (width["name"], width["limb"], width["unit"]) == ("width", 2, "deg")
    assert abs(width["value"] - WIDTH) < 4 * width["std"]
    assert width["std"] < 0.06 * WIDTH
    assert loose["location"]["channels"][0]["name"] == "approach2"
    assert loose["location"]["limbs"] == [2]
    assert loose["effects"][0]["indistinguishable_from"] == []
    assert loose["baseline"]["heldout_rms_mm"] > 3 * SIGMA
    assert loose["final"]["heldout_rms_mm"] < 2 * SIGMA
    assert loose["effects"][0]["share_of_excess"] > 0.95


@pytest.mark.walk
def test_what_no_effect_explains_is_located_and_sized(dented: tuple[dict[str, Any], np.ndarray]) -> None:
    found, centre = dented
    assert found["verdict"] == "unexplained"
    assert found["location"]["channels"][0]["name"] == "position"
    region = found["location"]["region"]
    assert np.linalg.norm(np.array(region["centre_mm"]) - centre) < 150
    assert 30 < region["radius_mm"] < 300
    assert found["effects"] == []
    assert 1.5 * SIGMA < found["baseline"]["train_rms_mm"] < 0.1


@pytest.mark.walk
def test_readings_that_lie_off_together_are_no_gross_errors(robot: Robot) -> None:
    recording, centre = bumpy(record(robot, n=140, of=channels(140, "temp", "approach")), robot, reach=60.0, much=2.0)
    found = diagnosis(robot, recording)
    assert found["verdict"] == "unexplained"
    assert found["effects"] == []
    assert np.linalg.norm(np.array(found["location"]["region"]["centre_mm"]) - centre) < 150


@pytest.mark.walk
def test_an_instrument_that_turns_is_no_fault_of_a_joint(robot: Robot) -> None:
    """A stand that creeps turns more than it shifts: what it does to a reading depends on time and place."""
    recording = record(robot, n=120, of=channels(120, "time"), declared=False)
    x, t = recording.measured - recording.measured.mean(axis=0), recording.channels["time_s"]
    turned = np.cross([1e-4, 2e-4, -3e-4], x) * (t / t[-1])[:, None]
    found = diagnosis(robot, dataclasses.replace(recording, measured=recording.measured + turned))
    assert found["verdict"] == "unexplained"
    assert found["effects"] == []
    assert found["location"]["channels"][0]["name"] == "time_s"
    assert found["location"]["limbs"] == []


@pytest.mark.walk
def test_play_that_varies_over_the_angle_is_placed_at_its_joint(robot: Robot) -> None:
    """Wide at one end of the stroke, crossed at the other: no mean that a backlash could be."""
    of = channels(80, "approach")
    plain = record(robot, n=80, of=of)
    q = plain.joints[:, 1]
    moved = plain.joints.copy()
    moved[:, 1] += 2e-4 * of["approach2"] * np.cos(2 * np.pi * (q - q.min()) / np.ptp(q))
    recording = record(robot, n=80, of=of, joints=np.degrees(moved), declared=False)
    found = diagnosis(robot, dataclasses.replace(recording, joints=plain.joints))
    assert found["verdict"] == "missing_physics"
    assert found["effects"] == []
    assert {limb for term in found["laws"][0]["terms"] for limb in term["limbs"]} == {2}
    assert {"approach", "q"} <= set(found["laws"][0]["states"])
    assert found["location"]["channels"][0]["name"] == "approach2"
    assert found["location"]["limbs"] == [2]


def test_what_predicts_far_worse_than_it_fits_is_told_so(robot: Robot, loose_recording: Recording) -> None:
    """A law of few readings may leave noise where it was fitted, and three times that elsewhere."""
    found = diagnose(robot, loose_recording)
    assert "mm remain. That is measurement noise." in found.answer().summary
    before, after = found.heldout
    far = dataclasses.replace(found, heldout=(10 * before, 3 * after))
    told = f"{3 * after:.4f} mm of held-out readings: it is there, but more poses would determine it better."
    assert f"With it {found.final.rms():.4f} mm remain of the readings of the fit, " in far.answer().summary
    assert told in far.answer().summary


@pytest.mark.parametrize(("better", "borne_out"), [(0.9, True), (1.0, False), (1.1, False)])
def test_held_out_readings_speak_for_what_is_named_or_do_not(better: float, borne_out: bool) -> None:
    before = np.random.default_rng(0).standard_normal((60, 3))
    after = better * before
    after[0], after[1] = 100.0, np.nan  # a gross error outweighs nothing, and what is not predicted does not count
    assert speak_for(before, after) is borne_out


@pytest.mark.walk
def test_two_effects_are_both_named(robot: Robot) -> None:
    terms = effect("backlash", (2,), WIDTH), effect("thermal_zero", (1,), 0.004)
    found = diagnosis(robot, record(robot, *terms, n=80, of=channels(80, "approach", "temp", "time")))
    assert found["verdict"] == "missing_physics"
    assert sorted(named(found)) == [("backlash", [2]), ("thermal_zero", [1])]
    shares = [e["share_of_excess"] for e in found["effects"]]
    assert 0.95 < sum(shares) <= 1.0
    assert min(shares) > 0.1


@pytest.mark.parametrize("order", [7.0, 20.5, 61.5])
def test_the_order_of_a_periodic_error_is_found_also_beyond_the_gear(robot: Robot, order: float) -> None:
    wave = effect("transmission_eccentricity", (1, 3), 0.008, -0.006, constants=(order,))
    found = diagnosis(robot, record(robot, wave, n=80))
    assert named(found) == [("transmission_eccentricity", [1, 3])]
    values = {(p["name"], p["limb"]): (p["value"], p["std"]) for p in found["effects"][0]["parameters"]}
    assert values["order", None][0] == order
    for limb in (1, 3):
        for name, truth in (("cos", 0.008), ("sin", -0.006)):
            value, std = values[name, limb]
            assert abs(value - truth) < 4 * std


def test_rods_that_differ_are_named_only_where_the_model_leaves_them_out(robot: Robot) -> None:
    rods = {**plausible(DELTA, 11, DELTA.model("delta/24"), size=0.3), "dl_2": 0.6, "dc_2": 0.3}
    made = record(robot, kind="pose", n=40, errors=rods)
    whole = diagnosis(robot, made)
    assert whole["verdict"] == "adequate"
    assert "geometry" in {t["name"]: t["missing"] for t in whole["not_tested"]}["parallelogram_error"]

    lesser = dc.diagnose(robot, made, model="delta/24")
    assert lesser["baseline"]["model"] == "delta/24"
    assert lesser["verdict"] == "missing_physics"
    assert named(lesser) == [("parallelogram_error", [2])]
    found = {p["name"]: (p["value"], p["std"]) for p in lesser["effects"][0]["parameters"]}
    for name in ("dl", "dc"):
        value, std = found[name]
        assert abs(value - rods[f"{name}_2"]) < 4 * std
        assert std < 0.05


def test_a_periodic_error_shows_along_its_joint() -> None:
    wave = effect("transmission_eccentricity", (2,), 0.03, 0.02, constants=(3.0,))
    robot = machine()
    found = diagnosis(robot, record(robot, wave, n=80))
    assert named(found) == [("transmission_eccentricity", [2])]
    assert [c["name"] for c in found["location"]["channels"]] == ["q2_deg"]
    assert found["location"]["text"] == "the residual depends on q2_deg, at limb 2"
    assert figures.main_channel(found) == "q2_deg"  # which it is drawn against


@pytest.mark.parametrize(("lead", "odds"), [(2 * np.log(3.0), "3"), (-2 * np.log(2.0), "0.5"), (40.0, "above 100")])
def test_how_little_speaks_for_what_is_named_is_said(lead: float, odds: str) -> None:
    spring, load = effect("joint_compliance", (2,), 0.01), effect("payload_deflection", (2,), 0.01)
    found = Named(spring, np.ones(1), 80.0, 1.0, (load,), ("thermal_zero",), 60.0, lead=lead)
    places = places_of(machine())
    alone = dataclasses.replace(found, rivals=(), unrecorded=(), lead=np.inf)
    assert indistinguishable([alone], places) == ""
    assert indistinguishable([alone, found], places) == (
        "Indistinguishable at these poses: joint_compliance from payload_deflection, thermal_zero "
        f"(likelihood ratio {odds})."
    )


# -------------------------------------------------------------------------------------------------------- the file


OF_OTHERS = {"effector_tilt", "tower_lean"} | {  # of printers, and of chains
    "joint_tilt_compliance",
    "column_lean",
    "link_bending",
    "link_torsion",
}


@pytest.mark.walk
def test_the_file_keeps_the_contract(
    sound: dict[str, Any], loose: dict[str, Any], dented: tuple[dict[str, Any], np.ndarray]
) -> None:
    for found in (sound, loose, dented[0]):
        conforms(found.to_dict(), SCHEMA)
        assert found["schema"] == "deltacal.diagnosis/1"
        assert json.loads(found.to_json()) == found
        assert found["baseline"]["model"] == "delta/42"
        shares = [c["share"] for c in found["location"]["channels"]]
        assert shares == sorted(shares, reverse=True)
        figures = [c["p_value"] for c in found["location"]["channels"]] + [e["p_value"] for e in found["effects"]]
        assert all(0 <= f <= 1 for f in figures + shares)
        tested = {e["name"] for e in found["effects"]} | {r["name"] for r in found["rejected"]}
        left_out = {t["name"] for t in found["not_tested"]}
        assert tested | left_out == set(effect_names()) - OF_OTHERS
        assert not tested & left_out
        assert len(found["summary"]) > 40


@pytest.mark.walk
def test_the_same_recording_gives_the_same_file(robot: Robot, loose_recording: Recording) -> None:
    assert diagnosis(robot, loose_recording) == diagnosis(robot, loose_recording)


# ------------------------------------------------------------------------------------------------------ its use


def test_a_diagnosis_predicts_fresh_readings_with_their_channels(
    robot: Robot, loose_recording: Recording, loose: dict[str, Any]
) -> None:
    fresh = record(machine(), effect("backlash", (2,), WIDTH), sigma=0.0, seed=9, of=channels(POSES, "approach"))
    geometry = dc.identify(robot, loose_recording)
    error = {
        name: float(np.sqrt(np.mean((dc.predict(model, fresh).measured - fresh.measured) ** 2)))
        for name, model in (("geometry", geometry), ("diagnosis", loose))
    }
    assert error["diagnosis"] < 0.02
    assert error["diagnosis"] < 0.5 * error["geometry"]


def test_a_prediction_without_a_channel_that_the_physics_needs_says_which(
    loose: dict[str, Any], loose_recording: Recording
) -> None:
    without = {name: v for name, v in loose_recording.channels.items() if not name.startswith("approach")}
    with pytest.raises(InputError, match="approach1"):
        dc.predict(loose, dataclasses.replace(loose_recording, channels=without))


def test_a_diagnosis_carries_to_another_session(robot: Robot, loose: dict[str, Any]) -> None:
    later = plausible(DELTA, 11, size=0.3) | {"theta_1": 0.004, "theta_3": -0.002}  # homed anew, tracker moved
    second = record(
        robot, effect("backlash", (2,), WIDTH), seed=2, errors=later, of=channels(POSES, "approach", seed=6)
    )
    plain = dc.identify(robot, second)
    carried = dc.identify(robot, second, physics=loose)
    assert carried["heldout_rms_mm"] < 2 * SIGMA
    assert carried["heldout_rms_mm"] < 0.5 * plain["heldout_rms_mm"]
    assert carried["chi2_per_dof"] == pytest.approx(1.0, abs=0.4)
    assert plain["chi2_per_dof"] > 5


@pytest.mark.walk
def test_a_long_latency_is_found_as_surely_as_a_short_one() -> None:
    """Of 32 ms, where poses lie up to 2 deg of joint beside where they were thought."""
    found = diagnosis(machine(), record(machine(), effect("latency", (), 0.032), n=70, seed=3, of=MOVED))
    (one,) = found["effects"]
    (delay,) = one["parameters"]
    assert one["name"] == "latency"
    assert abs(delay["value"] - 0.032) < 3 * delay["std"]


def test_what_nothing_says_to_be_noise_only_looks_like_it() -> None:
    said, sure = (diagnosis(machine(), record(machine(), seed=4, declared=declared)) for declared in (False, True))
    assert said["verdict"] == sure["verdict"] == "adequate"
    assert "looks like measurement noise" in said["summary"]
    assert "neither repeats nor a declared sigma_mm): model error of this size cannot be excluded" in said["summary"]
    assert "is measurement noise" in sure["summary"]
    assert "looks like" not in sure["summary"]
