"""`next` in motion: runs to record, where a run is what tells, as a trajectory that can be followed and simulated."""

from __future__ import annotations

import csv
import json
import shlex
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.results.diagnosis import NextMeasurement
from tests.support.commands import Run
from tests.support.motion_recordings import DEG, HEAD, LINKS, STEP, named, trajectory

BODIED = [link | {"mass": 3.0, "com": [40.0, -20.0, 30.0], "inertia": [2e4, 3e4, 4e4, 1e3, 2e3, 3e3]} for link in LINKS]
TRUTH = '[[effects]]\nname = "coulomb_friction"\nlimbs = [1, 3]\ncoulomb = 4.0\n'
MACHINE = robot_from_dict(HEAD | {"joint": BODIED, "limits": {"payload_kg": [0.0, 5.0], "qd1_deg_s": [-50.0, 50.0]}})


@pytest.fixture(scope="module")
def still(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Any]:
    """Return folder and diagnosis of a recording in which the third joint stands."""
    folder = tmp_path_factory.mktemp("still")
    rows = [["run", "time_s", *(f"q{i}_deg" for i in (1, 2, 3))]]
    for run in range(3):
        q = trajectory(10.0, 80 + run)[0] / DEG
        q[:, 2] = 20.0
        rows += [[str(run), *(f"{v:.6f}" for v in (n * STEP, *row))] for n, row in enumerate(q)]
    (folder / "moved.csv").write_text("\n".join(map(",".join, rows)) + "\n")
    (folder / "moved.toml").write_text('[measurement]\nkind = "torque"\n')
    (folder / "robot.toml").write_text(robot_to_toml(MACHINE))
    (folder / "truth.toml").write_text(TRUTH)
    dc.simulate(
        folder / "robot.toml",
        folder / "moved.csv",
        output=folder / "recording.csv",
        truth=folder / "truth.toml",
        noise=0.05,
    )
    return folder, dc.diagnose(folder / "robot.toml", folder / "recording.csv", output=folder / "diagnosis.json")


def columns(path: Path) -> dict[str, list[str]]:
    rows = list(csv.DictReader(path.read_text().splitlines()))
    return {name: [row[name] for row in rows] for name in rows[0]}


@pytest.mark.walk
def test_a_joint_that_stood_still_is_moved_and_its_friction_found(still: tuple[Path, Any], run: Run) -> None:
    folder, before = still
    assert named(before) == {"coulomb_friction": [1]}
    code, out, _ = run("next", folder / "diagnosis.json", "-o", folder / "next.csv")
    assert code == 0
    assert "joints stood still: Move joint 3" in out
    assert "runs written" in out
    found = columns(folder / "next.csv")
    assert list(found)[:5] == ["run", "time_s", "q1_deg", "q2_deg", "q3_deg"]
    assert "payload_kg" not in found  # no load is to be told apart
    speeds = np.abs(np.array(found["qd1_deg_s"], dtype=float))
    assert 40.0 < speeds.max() < 50.1  # [limits], at the samples by which it was planned
    done, made = folder / "next.csv", folder / "more.csv"
    dc.simulate(folder / "robot.toml", done, output=made, truth=folder / "truth.toml", noise=0.05, seed=4)
    assert named(dc.diagnose(folder / "robot.toml", made)) == {"coulomb_friction": [1, 3]}


def test_speeds_and_loads_that_tell_effects_apart_are_in_the_runs(still: tuple[Path, Any], tmp_path: Path) -> None:
    _, found = still
    names = ("stribeck_friction", "load_friction")
    entry = NextMeasurement(
        why="separates", text="", poses=(), expected_chi2=None, separates=names, run=("qd", "torque")
    )
    path = tmp_path / "next.csv"
    asked = dc.next_poses(found.replace(next_measurements=(entry,)), output=path)
    assert asked["motion"]["period_s"] == [10.0, 10.0, 10.0, 30.0, 90.0]
    assert asked["motion"]["payload_kg"] == [0.0, 5.0, 0.0, 5.0, 0.0]
    made = columns(path)
    runs = {name: np.array([r == name for r in made["run"]]) for name in asked["motion"]["runs"]}
    q, qd = (np.array(made[name], dtype=float) for name in ("q2_deg", "qd2_deg_s"))
    first, *_, slowest = runs.values()
    assert np.abs(qd[slowest]).max() == pytest.approx(np.abs(qd[first]).max() / 9, rel=1e-2)
    assert np.ptp(q[slowest]) == pytest.approx(np.ptp(q[first]), rel=1e-3)
    assert set(np.array(made["payload_kg"], dtype=float)[slowest]) == {0.0}
    assert json.loads(asked.to_json())["schema"] == "deltacal.next/1"


@pytest.mark.walk
def test_the_command_that_is_told_plans_such_runs(still: tuple[Path, Any], tmp_path: Path, run: Run) -> None:
    folder, found = still
    words = shlex.split(dc.next_poses(found, output=tmp_path / "next.csv")["motion"]["command"])
    assert words[:3] == ["deltacal", "plan", "robot.toml"]
    code, _, err = run("plan", folder / "robot.toml", *words[3:])
    assert code == 0, err
    assert np.max(np.array(columns(tmp_path / "next.csv")["time_s"], dtype=float)) == 10.0
    with pytest.raises(UsageError, match=r"deltacal plan robot\.toml --kind torque --runs 3 --period 10"):
        dc.next_poses(found, output=tmp_path / "next.csv", budget=20)


def test_what_no_run_tells_is_said_and_nothing_written(still: tuple[Path, Any], tmp_path: Path, run: Run) -> None:
    folder, found = still
    entry = NextMeasurement(why="readings never change", text="Record it.", poses=(), expected_chi2=None)
    (tmp_path / "silent.json").write_text(found.replace(next_measurements=(entry,)).to_json())
    code, out, _ = run("next", tmp_path / "silent.json", "-o", tmp_path / "next.csv")
    assert code == 1
    assert "readings never change: Record it." in out
    assert not (tmp_path / "next.csv").exists()
    with pytest.raises(InputError, match="this is no diagnosis"):
        dc.next_poses(dc.identify(folder / "robot.toml", folder / "recording.csv"))
