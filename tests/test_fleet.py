"""Many recordings at once: one bad one stops nothing, a stopped run goes on, and what moved is told."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import Run
from test_linear_delta import PRINTER, grid, plausible, recording

from deltacal_gen import InputError, UsageError, commands, fleet
from deltacal_gen.recording import write_recording
from deltacal_gen.robot import robot_from_dict, robot_to_toml
from deltacal_gen.simulation import simulate

SIX = ("endstop_1", "endstop_2", "endstop_3", "radius", "angle_1", "angle_2")


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three printers of two sessions; an endstop of the second has moved, and the third has a broken recording."""
    folder = tmp_path_factory.mktemp("shop")
    robot = robot_from_dict(PRINTER)
    rng = np.random.default_rng(8)
    poses = recording(robot, grid(90, 30))
    for k in range(3):
        machine = folder / f"printer-{k + 1}"
        machine.mkdir()
        (machine / "robot.toml").write_text(robot_to_toml(robot))
        truth = plausible(rng, SIX)
        for session in (1, 2):
            moved = truth | ({"endstop_1": truth["endstop_1"] + 0.3} if (k, session) == (1, 2) else {})
            write_recording(simulate(robot, poses, moved, noise_mm=0.01, rng=rng), machine / f"s{session}.csv")
    (folder / "printer-3" / "s1.csv").write_text("pose,q1_mm,q2_mm,q3_mm,height_mm\n1,300,301,x,0\n")
    (folder / "printer-3" / "notes.csv").write_text("day,what\n1,oiled\n")
    return folder


def test_all_recordings_are_done_and_the_bad_one_is_listed(shop: Path, tmp_path: Path, run: Run) -> None:
    code, text, _ = run("batch", shop, "--do", "identify", "--model", "6", "-o", tmp_path / "run", "--workers", "1")
    assert code == 0, text
    found = json.loads((tmp_path / "run" / "batch.json").read_text())
    assert [r["recording"] for r in found["rows"]] == [f"printer-{k}/s{s}.csv" for k in (1, 2, 3) for s in (1, 2)]
    bad = [r for r in found["rows"] if r["error"] is not None]
    assert [r["recording"] for r in bad] == ["printer-3/s1.csv"]
    assert "recording.csv, line 2, column 'q3_mm'" in bad[0]["error"]
    assert "5 of 6 recordings done" in " ".join(text.split())
    told = {c["machine"]: c["text"] for c in found["changed"]}
    assert set(told) == {"printer-1", "printer-2"}
    assert told["printer-1"].startswith("Nothing moved")
    assert told["printer-2"].startswith("endstop_1 moved +0.")
    page = (tmp_path / "run" / "index.html").read_text()
    assert "endstop_1 moved" in page
    assert "printer-3/s1.csv" in page


def test_what_changed_since_the_last_time(shop: Path, tmp_path: Path) -> None:
    copy = tmp_path / "shop"
    shutil.copytree(shop, copy)
    first = fleet.conduct(copy, tmp_path / "run", "identify", model="6", workers=1)
    shutil.copy(copy / "printer-2" / "s2.csv", copy / "printer-2" / "s1.csv")
    shutil.copy(copy / "printer-1" / "s2.csv", copy / "printer-3" / "s1.csv")
    again = fleet.conduct(copy, tmp_path / "run", "identify", model="6", workers=1)
    since = [c for c in again["changed"] if c["from"].endswith("last time")]
    assert [c["to"] for c in since] == ["printer-2/s1.csv"]
    assert since[0]["text"].startswith("endstop_1 moved")
    assert [r["error"] is None for r in again["rows"]] == [True] * 6
    assert [r["error"] is None for r in first["rows"]].count(False) == 1


def test_validation_needs_a_result_and_says_so(shop: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"result\.json"):
        fleet.conduct(shop, tmp_path / "run", "validate", workers=1)
    copy = tmp_path / "shop"
    shutil.copytree(shop, copy)
    for k in (1, 2, 3):
        machine = copy / f"printer-{k}"
        commands.identify(machine / "robot.toml", machine / "s2.csv", "6", machine / "result.json")
    rows = fleet.conduct(copy, tmp_path / "run", "validate", workers=1)["rows"]
    by_name = {r["recording"]: r for r in rows}
    assert by_name["printer-1/s1.csv"]["after_mm"] < 0.02
    assert by_name["printer-2/s1.csv"]["after_mm"] > 0.1
    assert by_name["printer-3/s1.csv"]["error"]


def test_a_pattern_says_which_recordings_are_of_one_machine(shop: Path) -> None:
    found = fleet.jobs(shop, machine=r"printer-[12]")
    assert [j.machine for j in found] == ["printer-1", "printer-1", "printer-2", "printer-2", "printer-3", "printer-3"]
    assert {j.machine for j in fleet.jobs(shop, machine="printer")} == {"printer"}


def test_mistakes(shop: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no recording beside"):
        fleet.jobs(tmp_path)
    with pytest.raises(UsageError, match="no action 'fix'"):
        fleet.jobs(shop, "fix")
    with pytest.raises(UsageError, match="no regular expression"):
        fleet.jobs(shop, machine="(")


def test_killed_twice_and_resumed_twice_the_table_is_the_same(shop: Path, tmp_path: Path) -> None:
    whole = fleet.conduct(shop, tmp_path / "whole", "identify", model="9", workers=1)
    command = [sys.executable, "-m", "deltacal_gen.cli", "batch", str(shop), "--do", "identify", "--model", "9"]
    command += ["-o", str(tmp_path / "run"), "--workers", "1"]
    for done in (1, 3):
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=os.environ)
        while len(list(tmp_path.glob("run/tasks/*.json"))) < done and process.poll() is None:
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
    made = {f.name: f.stat().st_mtime_ns for f in (tmp_path / "run" / "tasks").glob("*.json")}
    assert len(made) >= 3
    shutil.copytree(tmp_path / "run", tmp_path / "elsewhere")
    again = fleet.conduct(shop, tmp_path / "elsewhere", "identify", model="9", workers=1)
    assert again == whole
    tables = [(tmp_path / name / "table.csv").read_bytes() for name in ("whole", "elsewhere")]
    assert tables[0] == tables[1]
