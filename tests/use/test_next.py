"""`next`: rows to measure, exactly as many as asked for, which settle what a diagnosis leaves open."""

from __future__ import annotations

import csv
import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis import discrimination
from deltacal_gen.diagnosis.designs import Duel, Question, choose, least_misfit, take
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.discrimination import CLEAR, Pool, next_measurements
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import robot_from_dict, robot_to_dict
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.use.experiments import Open, next_rows, open_questions, shared
from tests.benchmarks.honesty_rounds import round_of
from tests.support.commands import Run
from tests.support.laws import law
from tests.support.left_out import DELTA, channels, effect, machine, record
from tests.support.prototype import PROTOTYPE

pytestmark = pytest.mark.usefixtures("compiled")

NEAR = machine(masses={"proximal": 0.3}, workspace={"radius": 250.0, "height": 400.0})
LIMITED = robot_from_dict(
    {
        **PROTOTYPE,
        "masses": {**PROTOTYPE["masses"], "proximal": 0.3},
        "joints": {"limits_deg": [[-60.0, 80.0]] * 3},
        "limits": {"payload_kg": [0.0, 5.0], "temp_C": [15.0, 35.0]},
    }
)


@pytest.fixture(scope="module")
def soft() -> Diagnosis:
    """A soft joint on poses that do not tell it from a soft arm; time was recorded."""
    made = record(NEAR, effect("joint_compliance", (1, 2, 3), 0.011), n=50, of=channels(50, "time"))
    return diagnose(LIMITED, made).answer()


@pytest.mark.walk
def test_rows_are_complete_and_come_after_the_last_reading(soft: Diagnosis) -> None:
    entry = next(n for n in soft.next_measurements if n.separates == ("joint_compliance", "proximal_bending"))
    assert entry.expected_chi2 is not None
    assert entry.expected_chi2 >= CLEAR
    assert entry.chi2_by_pose is not None
    assert entry.further is not None
    assert len(entry.chi2_by_pose) == len(entry.poses) + len(entry.further)
    assert entry.chi2_by_pose[len(entry.poses) - 1] == pytest.approx(entry.expected_chi2)
    times = [float(row["time_s"]) for row in entry.poses]
    assert times == sorted(set(times))
    recorded = soft.residuals.channels["time_s"]
    assert times[0] > recorded.max()
    assert {row["payload_kg"] for row in (*entry.poses, *entry.further)} == {0.0, 5.0}  # as [limits] says


@pytest.mark.walk
@pytest.mark.parametrize("budget", [1, 2, 7, 90])
def test_a_budget_is_kept_to_the_row_and_poses_are_repeated_last(soft: Diagnosis, budget: int) -> None:
    questions = open_questions(soft)
    rows = next_rows(questions, shared(questions, budget))
    assert len(rows) == budget
    poses = {tuple(row[f"q{i}_deg"] for i in (1, 2, 3)): row["pose"] for row in rows}
    assert len(set(poses.values())) == len(poses)  # a label for each pose
    fresh = {tuple(row[f"q{i}_deg"] for i in (1, 2, 3)) for q in questions for row in q.rows}
    assert len(poses) == min(budget, len(fresh))
    times = [float(row["time_s"]) for row in rows]
    assert times == sorted(set(times))


def test_rows_go_to_what_is_least_separated() -> None:
    easy, hard = (
        Open(why, tuple({"pose": f"next{n + 1}", why: float(n)} for n in range(8)), tuple(np.arange(1, 9) * each))
        for why, each in (("easy", 0.75 * CLEAR), ("hard", CLEAR / 8))
    )
    assert shared([easy, hard], 8).counts == (2, 6)
    assert shared([easy, hard], None).counts == (2, 8)
    faint = Open("faint", easy.rows, tuple(np.arange(1, 9) * CLEAR / 16))
    assert shared([faint], None).counts == (16,)  # each row twice
    assert shared([easy, hard], 20).counts == (8, 12)
    both = shared([easy, easy], 5)
    assert (len(both.rows), sum(both.counts)) == (5, 9)  # a row counts for all that it settles


@pytest.mark.walk
def test_the_command_writes_a_recording_without_readings(soft: Diagnosis, run: Run, tmp_path: Path) -> None:
    saved, out = tmp_path / "d.json", tmp_path / "poses.csv"
    saved.write_text(soft.to_json())
    code, said, _ = run("next", saved, "-o", out, "--budget", 9)
    assert code == 0
    assert "9 rows written" in said
    read = read_recording(out, DELTA, need_measured=False)
    assert read.n_rows == 9
    assert {"time_s", "payload_kg"} <= read.channels.keys()
    assert run("next", saved, "-o", out)[0] == 0
    assert read_recording(out, DELTA, need_measured=False).n_rows >= 3
    assert run("next", saved, "-o", out, "--budget", 0)[0] == 2
    answer = dc.next_poses(saved, budget=9)
    assert [row["pose"] for row in answer.poses] == [r["pose"] for r in csv_rows(run, saved, out)]
    assert sum(q.rows for q in answer.questions) >= 9


def test_rows_name_the_point_of_the_tool_that_is_measured(run: Run, tmp_path: Path) -> None:
    """Where two points of the platform take turns, a row that names neither would be read as the robot file's."""
    points = np.array([[0.0, 0.0, 0.0], [60.0, -20.0, -80.0]])
    made = record(NEAR, effect("joint_compliance", (1, 2, 3), 0.011), n=50, tool=points[np.arange(50) % 2])
    saved, out = tmp_path / "d.json", tmp_path / "poses.csv"
    saved.write_text(diagnose(LIMITED, made).answer().to_json())
    assert run("next", saved, "-o", out, "--budget", 30)[0] == 0
    read = read_recording(out, DELTA, need_measured=False)
    assert read.tool is not None
    assert {tuple(tool) for tool in read.tool.tolist()} == {tuple(point) for point in points.tolist()}
    stands = np.column_stack([read.joints, read.tool])
    assert len(np.unique(read.pose)) == len(np.unique(stands, axis=0))  # another point of a pose is another row


@pytest.mark.walk
def test_laws_that_readings_do_not_tell_apart_are_told_apart_by_rows() -> None:
    """A law that bends where few readings are, beside one that does not: at the ends of the channel they differ."""
    n, rng = 80, np.random.default_rng(2)
    of = {"payload_kg": rng.uniform(0.0, 2.0, n).round(2)}
    robot = dataclasses.replace(LIMITED, joint_limits=None)
    truth, rival = law("joint = c1*payload**2", 1e-4), law("joint = c1*Max(payload - c2, 0)", 2e-4, 0.6)
    at = diagnose(robot, record(robot, truth, n=n, of=of)).final
    (entry,) = next_measurements(at, [Question(truth, (rival,))], None)
    assert entry.separates == ("joint = c1*payload**2", "joint = c1*Max(payload - c2, 0)")
    assert entry.expected_chi2 is not None
    assert entry.expected_chi2 > CLEAR
    assert {row["payload_kg"] for row in (*entry.poses, *(entry.further or ()))} <= set(np.linspace(0, 5, 5))
    (alone,) = next_measurements(at, [Question(truth, proven=False)], None)
    assert alone.why == "settles whether there is joint = c1*payload**2"


@pytest.mark.walk
def test_a_law_that_gives_way_is_harder_to_refute(monkeypatch: pytest.MonkeyPatch) -> None:
    n = 80
    of = {"payload_kg": np.random.default_rng(2).uniform(0.0, 2.0, n).round(2)}
    truth, rival = law("joint = c1*payload**2", 1e-4), law("joint = c1*Max(payload - c2, 0)", 2e-4, 0.6)
    at = diagnose(NEAR, record(NEAR, truth, n=n, of=of)).final

    def expected() -> float:
        return Pool(at, [truth, rival], np.random.default_rng(1)).separating(truth, rival, []).gained[-1]

    bending = expected()
    monkeypatch.setattr(discrimination, "_bends", lambda term: [])
    stiff = expected()
    assert bending < 0.9 * stiff, (bending, stiff)


@pytest.mark.walk
def test_a_drift_is_told_from_a_warm_up_that_may_be_slower_than_it_looks() -> None:
    """A warm-up's time constant follows what is measured: rows are as many as refute every one."""
    told = round_of("zero_drift", 4)
    assert told["open"]
    assert told["alone after a round"]
    assert told["rows"] <= 1.3 * told["best"]


def csv_rows(run: Run, saved: Path, out: Path) -> list[dict[str, Any]]:
    assert run("next", saved, "-o", out, "--budget", 9)[0] == 0
    with out.open() as file:
        return list(csv.DictReader(file))


def test_where_nothing_is_open_no_file_is_written(run: Run, tmp_path: Path) -> None:
    robot = machine()
    saved, out = tmp_path / "d.json", tmp_path / "poses.csv"
    saved.write_text(diagnose(robot, record(robot)).answer().to_json())
    code, said, _ = run("next", saved, "-o", out)
    assert code == 1
    assert "nothing is open" in said
    assert not out.exists()
    code, said, _ = run("next", saved, "-o", out, "--json")
    assert code == 1
    assert json.loads(said)["poses"] == []


@pytest.mark.walk
def test_labels_of_poses_that_were_measured_are_not_given_again() -> None:
    made = record(NEAR, effect("joint_compliance", (1, 2, 3), 0.011), n=50)
    again = dataclasses.replace(made, pose=np.array([*made.pose[:-2], "next4", "next11"]))
    found = diagnose(LIMITED, again).answer()
    labels = {str(row["pose"]) for n in found.next_measurements for row in n.poses}
    assert labels
    assert min(int(label.removeprefix("next")) for label in labels) == 12


def test_limits_of_channels_come_back_from_a_file() -> None:
    assert robot_from_dict(robot_to_dict(LIMITED)).limits == {"payload_kg": (0.0, 5.0), "temp_C": (15.0, 35.0)}


@pytest.mark.walk
def test_poses_reach_beyond_those_that_were_recorded(soft: Diagnosis) -> None:
    joints = np.array([soft.residuals.channels[f"q{i}_deg"] for i in (1, 2, 3)]).T
    spare = 0.1 * np.ptp(joints, axis=0)
    asked = np.array([[row[f"q{i}_deg"] for i in (1, 2, 3)] for n in soft.next_measurements for row in n.poses])
    assert ((asked > joints.max(axis=0) + spare) | (asked < joints.min(axis=0) - spare)).any()


def duels(rng: np.random.Generator) -> list[Duel]:
    X, d, new, shift = (rng.standard_normal(s) for s in ((40, 6), (40,), (60, 2, 6), (60, 2)))
    return [Duel(k * X, d, np.zeros(6), k * new, shift) for k in (1.0, 2.0)]


def test_exchanged_poses_are_no_worse_than_those_chosen_one_by_one_and_their_curve_is_what_they_make() -> None:
    found, fresh = duels(np.random.default_rng(3)), duels(np.random.default_rng(3))
    chosen = choose(found, 3, 6, 1e9, further=2)
    assert (chosen.needed, len(chosen.order), len(set(chosen.order))) == (6, 8, 8)
    before, made = least_misfit(fresh), []
    for j in chosen.order:
        take(fresh, j)
        made.append(least_misfit(fresh) - before)
    assert chosen.gained == pytest.approx(made)
    greedy, taken = duels(np.random.default_rng(3)), []
    for _ in range(6):
        each = np.min([d.misfit + d.gains(range(60)) for d in greedy], axis=0)
        each[taken] = -np.inf
        taken.append(int(np.argmax(each)))
        take(greedy, taken[-1])
    assert chosen.gained[5] >= least_misfit(greedy) - before - 1e-9


def test_a_column_that_nothing_knows_leaves_numbers() -> None:
    rng = np.random.default_rng(4)
    X, d = rng.standard_normal((30, 3)), rng.standard_normal(30)
    more, shift = rng.standard_normal((5, 2, 3)), rng.standard_normal((5, 2))
    plain = Duel(X, d, np.zeros(3), more, shift)
    padded = np.concatenate([more, np.zeros((5, 2, 1))], axis=2)
    blind = Duel(np.column_stack([X, np.zeros(30)]), d, np.zeros(4), padded, shift)
    assert blind.misfit == pytest.approx(plain.misfit)
    assert blind.coefficients == pytest.approx([*plain.coefficients, 0.0])
    assert blind.gains(range(5)) == pytest.approx(plain.gains(range(5)))
