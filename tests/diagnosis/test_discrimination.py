"""What to measure next: explanations that a recording cannot tell apart, and the readings that can."""

from __future__ import annotations

import dataclasses
import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.diagnosis.designs import Duel
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.discrimination import (
    CLEAR,
    FEWEST_POSES,
    MOST_POSES,
    Question,
    candidates,
    next_measurements,
)
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.writing import csv_text
from deltacal_gen.machine.registry import SOLVED
from deltacal_gen.machine.values import Recording
from deltacal_gen.pages import report
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import Channel, Location, RegionOf
from tests.support.left_out import DELTA, channels, diagnosis, effect, machine, named, record
from tests.support.prototype import plausible

pytestmark = pytest.mark.usefixtures("compiled")

LIGHT = machine(masses={"proximal": 0.3}, joints={"limits_deg": [[-60.0, 80.0]] * 3})
NEAR = machine(masses={"proximal": 0.3}, workspace={"radius": 250.0, "height": 400.0})  # where rods hang straight
COMPLIANT = effect("joint_compliance", (1, 2, 3), 0.011)  # deg/Nm
BENDING = effect("proximal_bending", (1, 2, 3), 0.027)  # mm/N: as much at the tip of the arm
N = 50


def extended(recording: Recording, rows: Sequence[Mapping[str, Any]], *terms: Term) -> Recording:
    """Return the recording with further readings behind it, taken on the same machine."""
    joints = np.degrees(recording.joints)
    joints = np.vstack([joints, [[row[f"q{i}_deg"] for i in (1, 2, 3)] for row in rows]])
    of = {
        name: np.concatenate([recording.channels.get(name, np.zeros(recording.n_rows)), [row[name] for row in rows]])
        for name in rows[0]
        if name not in ("pose", "q1_deg", "q2_deg", "q3_deg")
    }
    return record(LIGHT, *terms, n=len(joints), joints=joints, of=of)


@pytest.fixture(scope="module")
def compliant() -> dict[str, Any]:
    return diagnosis(LIGHT, record(NEAR, COMPLIANT, n=N))


# ------------------------------------------------------------------------------------- joint or arm, steel or tracker


@pytest.mark.walk
@pytest.mark.parametrize(
    ("truth", "other"),
    [
        (COMPLIANT, "proximal_bending"),
        pytest.param(BENDING, "joint_compliance", marks=pytest.mark.thorough),
    ],
)
def test_a_soft_joint_and_a_soft_arm_are_one_answer_until_the_proposed_poses_are_measured(
    truth: Term, other: str
) -> None:
    first = record(NEAR, truth, n=N)
    found = diagnosis(LIGHT, first)
    assert found["verdict"] == "missing_physics"
    [answer] = found["effects"]
    assert {answer["name"], *answer["indistinguishable_from"]} >= {truth.effect, other}

    question = next(q for q in found["next_measurements"] if truth.effect in q["why"] and other in q["why"])
    assert question["why"].startswith("separates ")
    assert question["expected_chi2"] >= CLEAR
    assert FEWEST_POSES <= len(question["poses"]) <= MOST_POSES
    then = diagnosis(LIGHT, extended(first, question["poses"], truth))
    assert [name for name, _ in named(then)] == [truth.effect]
    assert other not in then["effects"][0]["indistinguishable_from"]

    old = np.degrees(first.joints[: len(question["poses"])])
    again = diagnosis(LIGHT, extended(first, [{f"q{i + 1}_deg": v for i, v in enumerate(q)} for q in old], truth))
    assert {again["effects"][0]["name"], *again["effects"][0]["indistinguishable_from"]} >= {truth.effect, other}


@pytest.mark.walk
def test_what_goes_with_time_may_be_warmth_until_the_temperature_is_recorded() -> None:
    robot, of = machine(), channels(60, "time")
    made = record(robot, effect("zero_drift", (2,), 0.05), n=60, of=of)
    found = diagnosis(robot, made)
    assert named(found) == [("zero_drift", [2])]
    assert "thermal_zero" in found["effects"][0]["indistinguishable_from"]
    (asked,) = [q for q in found["next_measurements"] if "thermal_zero" in q["why"]]
    assert "Record temp_C" in asked["text"]
    assert asked["expected_chi2"] > CLEAR
    assert {row["temp_C"] for row in asked["poses"]} <= {20.0, 30.0}
    assert min(row["time_s"] for row in asked["poses"]) > of["time_s"].max()
    known = {"temp_C": np.random.default_rng(8).choice([20.0, 26.0], 60)}
    again = diagnosis(robot, dataclasses.replace(made, channels=made.channels | known))
    assert named(again) == [("zero_drift", [2])]
    assert "thermal_zero" not in again["effects"][0]["indistinguishable_from"]


TIGHT = machine(
    tolerance={p.name: 0.01 if p.unit == "mm" else 0.005 for p in DELTA.parameters if p.error != "theta"}
)  # measured on a co-ordinate measuring machine, at 20 degC
ROUGH = {name: 0.02 * value for name, value in plausible(DELTA, 3).items()}
SCALE = effect("instrument_scale", (), 300.0)  # ppm
GROWTH = effect("thermal_growth", (), 23e-6, 23e-6, 23e-6)  # 1/K, aluminium
COLD, WARM = 32.0, 44.0  # degC


@pytest.mark.walk
@pytest.mark.parametrize("truth", [SCALE, GROWTH], ids=lambda t: t.effect)
def test_a_wrong_scale_and_a_warm_machine_are_one_answer_until_the_temperature_is_recorded(truth: Term) -> None:
    warm = {"temp_C": np.full(60, COLD)}
    made = record(TIGHT, truth, errors=ROUGH, of=warm)
    found = diagnosis(TIGHT, dataclasses.replace(made, channels={}))
    assert named(found) == [("instrument_scale", [])]
    assert found["effects"][0]["indistinguishable_from"] == ["thermal_growth"]
    [question] = found["next_measurements"]
    assert "thermal_growth" in question["why"]
    assert "temp_C" in question["text"]

    both = {"temp_C": np.repeat([COLD, WARM], 60)}
    joints = np.degrees(np.vstack([made.joints] * 2))
    then = diagnosis(TIGHT, record(TIGHT, truth, n=120, joints=joints, errors=ROUGH, of=both))
    assert named(then) == [(truth.effect, [])]
    assert then["effects"][0]["indistinguishable_from"] == []
    assert then["next_measurements"] == []


# -------------------------------------------------------------------------------------------------- the proposals


def test_nothing_is_proposed_where_nothing_is_open() -> None:
    robot = machine()
    assert diagnosis(robot, record(robot))["next_measurements"] == []


@pytest.mark.walk
def test_proposed_poses_stay_within_limits_and_workspace(compliant: dict[str, Any]) -> None:
    question = compliant["next_measurements"][0]
    q = np.array([[row[f"q{i}_deg"] for i in (1, 2, 3)] for row in question["poses"]])
    assert ((q >= -60) & (q <= 80)).all()
    x, status = DELTA.forward(np.radians(q), LIGHT.tool, DELTA.rows(LIGHT))
    assert (status == SOLVED).all()
    assert LIGHT.workspace is not None
    assert LIGHT.workspace.radius is not None
    spare = 2.0  # mm: the calibrated machine stands elsewhere than the nominal one
    assert (np.hypot(x[:, 0], x[:, 1]) <= LIGHT.workspace.radius + spare).all()
    assert ((x[:, 2] <= -LIGHT.workspace.top + spare) & (x[:, 2] >= -LIGHT.workspace.top - 250 - spare)).all()
    assert {row["payload_kg"] for row in question["poses"]} <= {0.0, 0.8}  # none was recorded: the platform once more


@pytest.mark.parametrize("kind", ["position", "distance", "pose", "gauge"])
def test_proposals_are_rows_of_a_recording(kind: str, tmp_path: Path) -> None:
    robot = machine()
    how = {"base_point_mm": (0.0, 0.0, -1400.0)} if kind == "gauge" else {}
    n = 130 if kind == "gauge" else 60
    made = record(robot, kind=kind, n=n, of=channels(n, "approach", "payload", "time"), **how)
    found = diagnose(robot, made)
    soft, loose = effect("payload_deflection", (1,), 0.02), effect("zero_drift", (2,), 0.05)
    questions = [Question(soft, (loose,)), Question(loose, proven=False)]
    for entry in next_measurements(found.final, questions, None):
        assert entry.poses
        assert json.loads(json.dumps(entry.to_dict())) == entry.to_dict()
        path = tmp_path / f"{kind}.csv"
        columns = {name: [row[name] for row in entry.poses] for name in entry.poses[0]}
        path.write_text(csv_text({k: v if k == "pose" else np.array(v) for k, v in columns.items()}))
        read = read_recording(path, DELTA, need_measured=False)
        assert read.n_rows == len(entry.poses) * (2 if kind == "distance" else 1)
        assert read.channels["time_s"].min() > made.channels["time_s"].max()
        assert set(np.unique(read.channels["payload_kg"])) <= {0.0, 1.0, 2.0}


def test_what_nothing_explains_is_asked_where_it_sits() -> None:
    robot = machine(workspace=None)
    final = diagnose(robot, record(machine(), of=channels(60, "time", "humidity_pct"))).final
    nothing = Location(channels=(), limbs=(), region=None, text="")

    def along_channel(name: str) -> Location:
        return nothing.replace(channels=(Channel(name=name, p_value=0.0, share=1.0),))

    region = RegionOf(centre_mm=(100.0, 50.0, -850.0), radius_mm=80.0)
    where = along_channel("position").replace(region=region)
    [local] = next_measurements(final, [], where)
    q = np.radians([[row[f"q{i}_deg"] for i in (1, 2, 3)] for row in local.poses])
    x, _ = DELTA.forward(q, robot.tool, DELTA.rows(robot))
    assert np.median(np.linalg.norm(x[:, :3] - [100.0, 50.0, -850.0], axis=1)) < 120

    [along] = next_measurements(final, [], along_channel("q2_deg"))
    steps = np.diff([row["q2_deg"] for row in along.poses])
    assert (steps > 0).all()
    assert steps.max() < 4 * steps.min()

    [damp] = next_measurements(final, [], along_channel("humidity_pct"))
    poses = {(row["q1_deg"], row["q2_deg"], row["q3_deg"]) for row in damp.poses}
    assert len({row["humidity_pct"] for row in damp.poses}) * len(poses) == len(damp.poses)
    [later] = next_measurements(final, [], along_channel("time_s"))
    assert min(row["time_s"] for row in later.poses) > final.problem.recording.channels["time_s"].max()
    [unknown] = next_measurements(final, [], nothing)
    assert unknown.poses == ()
    assert "temp_C" in unknown.text


# ---------------------------------------------------------------------------------------------- the linear algebra


def test_expected_gains_are_those_of_fitting_anew() -> None:
    rng = np.random.default_rng(4)
    X, d, prior = rng.standard_normal((40, 6)), rng.standard_normal(40), np.array([1.0, 1, 1, 0, 0, 0])
    new, shift = rng.standard_normal((5, 3, 6)), rng.standard_normal((5, 3))

    def misfit(rows: list[int]) -> float:
        A = np.vstack([X, *new[rows], np.diag(np.sqrt(prior))])
        b = np.concatenate([d, *shift[rows], np.zeros(6)])
        return float(np.linalg.lstsq(A, b, rcond=None)[1][0])

    found = Duel(X, d, prior, new, shift)
    assert found.misfit == pytest.approx(misfit([]), rel=1e-7)
    assert found.gains(range(5)) == pytest.approx([misfit([k]) - misfit([]) for k in range(5)], rel=1e-6)
    for k in (3, 1):
        found.take(k)
    assert found.misfit == pytest.approx(misfit([3, 1]), rel=1e-7)
    assert found.gains(range(5)) == pytest.approx([misfit([3, 1, k]) - misfit([3, 1]) for k in range(5)], rel=1e-6)


def test_candidates_take_both_directions_and_loads_that_were_used() -> None:
    robot = machine()
    made = record(robot, of=channels(60, "approach", "payload", "temp", "humidity_pct"))
    found = candidates(diagnose(robot, made).final, [effect("friction_windup", (1,), 0.0)], np.random.default_rng(0))
    assert "humidity_pct" not in found.shown
    assert "temp_C" not in found.shown
    assert set(np.unique(found.problem.recording.channels["approach1"])) == {-1.0, 1.0}
    assert set(np.unique(found.problem.recording.channels["payload_kg"])) <= {0.0, 1.0, 2.0}
    assert len(found.ends) > 100


@pytest.mark.walk
def test_the_page_shows_what_to_measure(compliant: dict[str, Any]) -> None:
    page = report.diagnosis(compliant)
    for question in compliant["next_measurements"]:
        assert question["text"] in page
        assert question["why"][1:] in page
    assert "payload_kg" in page
    answered = [question for question in compliant["next_measurements"] if question["poses"]]
    assert len(answered) > 1
    assert len(re.findall(r"\bnext1\b", page)) == len(answered)
