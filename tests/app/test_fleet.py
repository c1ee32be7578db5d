"""Many recordings at once: one bad one stops nothing, a stopped run goes on, and what moved is told."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen import InputError, UsageError
from deltacal_gen.app import fleet
from deltacal_gen.app.demonstration import example
from deltacal_gen.app.moved import moved
from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_recording
from deltacal_gen.pages import report as pages
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.results.batch import Batch, Row
from deltacal_gen.results.diagnosis import Diagnosis, EffectParameter, LawTerm
from deltacal_gen.results.reader import read_answer
from deltacal_gen.use.comparison import compare_numbers
from tests.support.commands import Run
from tests.support.motion_recordings import usual, written
from tests.support.printers import LINEAR, PRINTER, grid, joints, plausible, printer_cfg, recording
from tests.support.two_clocks import written as on_two_clocks

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


@pytest.mark.walk
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
    links = re.findall(r'<a href="(pages/\w+\.html)">(printer-\d/s\d\.csv)</a>', page)
    assert [name for _, name in links] == [r["recording"] for r in found["rows"] if r["error"] is None]
    assert all("<!doctype html>" in (tmp_path / "run" / link).read_text() for link, _ in links)
    assert found["passed_over"] == ["printer-3/notes.csv"]
    assert "printer-3/notes.csv" in page
    assert "passed over: printer-3/notes.csv" in " ".join(text.split())


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


def test_a_diagnosis_says_which_part_has_moved(shop: Path, tmp_path: Path) -> None:
    one = tmp_path / "shop"
    shutil.copytree(shop / "printer-2", one / "printer-2")
    found = fleet.conduct(one, tmp_path / "run", model="6", workers=1)
    assert [r["verdict"] for r in found["rows"]] == ["adequate", "adequate"]
    (change,) = found["changed"]
    assert change["text"].startswith("still adequate; held out ")
    assert "mm. endstop_1 moved +0." in change["text"]


@pytest.mark.walk
def test_an_effect_that_has_grown_is_said() -> None:
    folder = example("gearbox")
    found = dc.diagnose(folder / "robot.toml", folder / "recording.csv")

    def diagnosis(width: float) -> Diagnosis:
        part = EffectParameter(name="width", limb=1, value=width, std=0.001, unit="deg")
        when = EffectParameter(name="time", limb=None, value=60.0 + width, std=None, unit="s")  # found, not fitted
        return found.replace(effects=(found.effects[0].replace(parameters=(part, when)),))

    assert "backlash width_1 moved +0.0100 +- 0.0014 deg" in moved(diagnosis(0.02), diagnosis(0.03))
    assert "width" not in moved(diagnosis(0.02), diagnosis(0.022))


@pytest.mark.walk
def test_each_measured_point_is_compared_with_itself() -> None:
    folder = example("gearbox")
    found = dc.diagnose(folder / "robot.toml", folder / "recording.csv")

    def diagnosis(first: float) -> Diagnosis:
        sizes = {(0.0, 107.0, 36.0): first, (99.0, -11.0, 36.0): 13.5}
        points = tuple(
            EffectParameter(name="offset_x", limb=None, value=value, std=0.1, unit="mm", tool_mm=point)
            for point, value in sizes.items()
        )
        return found.replace(effects=(found.effects[0].replace(limbs=(), parameters=points),))

    assert compare_numbers(diagnosis(-1.6), diagnosis(-1.6)).changed == ()
    (changed,) = compare_numbers(diagnosis(-1.6), diagnosis(2.0)).changed
    assert changed.name.endswith("offset_x of (0, 107, 36)")
    assert (changed.before, changed.after) == (-1.6, 2.0)


def test_validation_needs_a_result_and_says_so(shop: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"result\.json"):
        fleet.conduct(shop, tmp_path / "run", "validate", workers=1)
    copy = tmp_path / "shop"
    shutil.copytree(shop, copy)
    for k in (1, 2, 3):
        machine = copy / f"printer-{k}"
        dc.identify(machine / "robot.toml", machine / "s2.csv", model="6", output=machine / "result.json")
    rows = fleet.conduct(copy, tmp_path / "run", "validate", workers=1)["rows"]
    by_name = {r["recording"]: r for r in rows}
    assert by_name["printer-1/s1.csv"]["after_mm"] < 0.02
    assert by_name["printer-2/s1.csv"]["after_mm"] > 0.1
    assert by_name["printer-3/s1.csv"]["error"]


def test_a_pattern_says_which_recordings_are_of_one_machine(shop: Path) -> None:
    found = fleet.find(shop, machine=r"printer-[12]")
    assert [j.machine for j in found] == ["printer-1", "printer-1", "printer-2", "printer-2", "printer-3", "printer-3"]
    assert {j.machine for j in fleet.find(shop, machine="printer")} == {"printer"}


def test_mistakes(shop: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no recording beside"):
        fleet.find(tmp_path)
    with pytest.raises(UsageError, match="no action 'fix'"):
        fleet.find(shop, "fix")
    with pytest.raises(UsageError, match="no regular expression"):
        fleet.find(shop, machine="(")


def test_what_firmware_and_trackers_keep_is_imported(tmp_path: Path) -> None:
    robot = robot_from_dict(PRINTER | {"transmission": {"pulley_circumference": 40.0}})
    rng = np.random.default_rng(3)
    q = joints(robot, grid(90, 30)) + rng.normal(scale=0.01, size=(len(grid(90, 30)), 3))
    top = tmp_path / "shop"
    for name in ("klipper", "duet", "tracker", "lonely"):
        (top / name).mkdir(parents=True)
    (top / "klipper" / "printer.cfg").write_text(printer_cfg(robot, q, []))
    (top / "klipper" / "other.cfg").write_text("[printer]\nkinematics: cartesian\n#*# [bed_mesh default]\n")
    config = "M665 R130 L270 B90 H300\nM666 X0 Y0 Z0\nG31 P500 X0 Y0 Z2.5\n"
    rows = "\n".join(",".join(f"{v:.3f}" for v in row) for row in rng.normal(scale=0.1, size=(6, 6)))
    chart = (
        "RepRapFirmware height map file v2 generated at 2026-01-01 00:00, mean error 0.0, deviation 0.1\n"
        f"xmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum\n-50,50,-50,50,80,20,20,6,6\n{rows}\n"
    )
    (top / "duet" / "config.g").write_text(config)
    (top / "duet" / "heightmap.csv").write_text(chart)
    (top / "lonely" / "heightmap.csv").write_text(chart)
    (top / "tracker" / "robot.toml").write_text(robot_to_toml(robot))
    x = LINEAR.forward(q, robot.tool, LINEAR.rows(robot))[0][:, :3]
    points = [f"A P{k} " + " ".join(f"{v:.4f}" for v in p) for k, p in enumerate(x)]
    table = [f"P{k}," + ",".join(f"{v:.4f}" for v in p) for k, p in enumerate(q)]
    (top / "tracker" / "points.txt").write_text("\n".join(points) + "\n")
    (top / "tracker" / "joints.csv").write_text("\n".join(["point,q1_mm,q2_mm,q3_mm", *table]) + "\n")
    (top / "klipper" / "again").symlink_to(top)  # links may go round in circles
    found = fleet.conduct(top, tmp_path / "run", "identify", workers=1)
    by_name = {r["recording"]: r for r in found["rows"]}
    assert list(by_name) == ["duet/heightmap.csv", "klipper/printer.cfg", "lonely/heightmap.csv", "tracker/points.txt"]
    assert "config.g" in by_name.pop("lonely/heightmap.csv")["error"]
    assert all(r["error"] is None for r in by_name.values())
    assert by_name["klipper/printer.cfg"]["after_mm"] < 0.05


def test_of_very_many_the_page_shows_the_distribution_and_the_worst() -> None:
    figures = {"model": "9", "before_mm": 1.0, "fitted_mm": 0.1, "noise_mm": 0.1, "error": None}
    good = (Row(recording=f"m{k}/r.csv", machine=f"m{k}", after_mm=k / 1000, **figures) for k in range(2000))
    bad = (Row(recording=f"bad{k}/r.csv", machine=f"bad{k}", error="nothing in it") for k in range(900))
    page = pages.batch(Batch(action="identify", rows=(*good, *bad), changed=()))
    assert len(page) < 400_000
    assert "m1999/r.csv" in page
    assert "m7/r.csv" not in page
    assert "bad0/r.csv, bad1/r.csv, bad2/r.csv and 897 more" in page


@pytest.mark.walk
def test_killed_twice_and_resumed_twice_the_table_is_the_same(shop: Path, tmp_path: Path) -> None:
    whole = fleet.conduct(shop, tmp_path / "whole", "identify", model="9", workers=1)
    command = [sys.executable, "-m", "deltacal_gen.app.cli", "batch", str(shop), "--do", "identify", "--model", "9"]
    command += ["-o", str(tmp_path / "run"), "--workers", "1"]
    for done in (1, 3):
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=os.environ)
        while len(list(tmp_path.glob("run/tasks/*/*.json"))) < done and process.poll() is None:
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
    made = {f.name: f.stat().st_mtime_ns for f in (tmp_path / "run" / "tasks").rglob("*.json")}
    assert len(made) >= 3
    shutil.copytree(tmp_path / "run", tmp_path / "elsewhere")
    again = fleet.conduct(shop, tmp_path / "elsewhere", "identify", model="9", workers=1)
    assert again == whole
    tables = [(tmp_path / name / "table.csv").read_bytes() for name in ("whole", "elsewhere")]
    assert tables[0] == tables[1]


def test_where_there_is_nothing_to_do_no_folder_is_made(tmp_path: Path) -> None:
    (tmp_path / "shop").mkdir()
    with pytest.raises(InputError):
        dc.batch(tmp_path / "shop", output=tmp_path / "run")
    assert not (tmp_path / "run").exists()


def test_a_law_is_called_by_what_it_moves_and_reads_whatever_its_shape() -> None:
    def called(expression: str) -> str:
        return fleet.place_of_law(LawTerm(target="joint", limbs=(2,), expression=expression, coefficients=()))

    for shape in ("c1*payload", "c1*(tanh(payload/c2) + c3)", "c1*Max(payload - c2, 0)"):
        assert called(shape) == "joint(payload)"
    assert called("c1*payload*oil_C") == "joint(oil_C, payload)"


@pytest.fixture(scope="module")
def moving(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An arm in motion in two sessions, with a plan and a broken recording beside them, and readings on two clocks."""
    folder = tmp_path_factory.mktemp("moving")
    (folder / "arm").mkdir()
    for session in ("s2", "s1"):
        path = written(folder / "arm", usual, runs=3, seed=int(session[1]), seconds=6.0)
        for ending in (".csv", ".toml"):
            path.with_suffix(ending).rename(folder / "arm" / f"{session}{ending}")
    first = (folder / "arm" / "s1.csv").read_text().splitlines()
    (folder / "arm" / "s3.csv").write_text("\n".join(first[:5]) + "\n")
    (folder / "arm" / "plan.csv").write_text("\n".join(line.rsplit(",", 3)[0] for line in first[:99]) + "\n")
    for name in ("s3", "plan"):
        shutil.copy(folder / "arm" / "s1.toml", folder / "arm" / f"{name}.toml")
    (folder / "delta").mkdir()
    on_two_clocks(folder / "delta")
    return folder


@pytest.mark.walk
def test_recordings_in_motion_are_done_joint_by_joint(moving: Path, tmp_path: Path, run: Run) -> None:
    code, text, said = run("batch", moving / "arm", "-o", tmp_path / "run", "--workers", "1", "--model", "18")
    assert code == 0, said
    found = read_answer(tmp_path / "run" / "batch.json")
    assert isinstance(found, Batch)
    first, second, third = found.rows
    assert [row.recording for row in found.rows] == ["s1.csv", "s2.csv", "s3.csv"]
    for row in (first, second):
        assert row.effects
        assert row.before_by_joint
        assert row.verdict == "missing_physics"
        assert "coulomb_friction, joints 1 and 2" in row.effects
        assert row.unit_by_joint == ("Nm", "Nm", "Nm")
        assert row.after_by_joint == pytest.approx([0.05] * 3, rel=0.1)
        assert row.before_by_joint[0] > 1.0
    assert third.error
    (change,) = found.changed
    assert change.text.startswith("still missing_physics; held out 0.0")
    assert change.text.endswith(" Nm.")
    page = (tmp_path / "run" / "index.html").read_text()
    (link, *_) = re.findall(r'<a href="(pages/\w+\.html)">s1.csv</a>', page)
    assert "torque" in (tmp_path / "run" / link).read_text()
    assert (tmp_path / "run" / "table.csv").read_text().count("Nm Nm Nm") == 2
    assert "plan.csv" in page  # passed over: it holds no reading
    assert "2 of 3 recordings done" in " ".join(text.split())


@pytest.mark.walk
def test_drives_are_identified_and_validated(moving: Path, tmp_path: Path) -> None:
    arm = tmp_path / "arm"
    shutil.copytree(moving / "arm", arm)
    dc.diagnose(arm / "robot.toml", arm / "s1.csv", output=arm / "result.json")
    done = fleet.conduct(arm, tmp_path / "run", "validate", workers=1)
    left = [row["after_by_joint"] for row in done["rows"] if row["error"] is None]
    assert np.array(left) == pytest.approx(0.05, rel=0.3)
    assert done.changed[0].text.startswith("error 0.0")
    found = fleet.conduct(arm, tmp_path / "again", "identify", workers=1).rows[0]
    assert found.after_by_joint
    assert found.model == "serial/rigid"
    assert min(v for v in found.after_by_joint if v is not None) > 1.0  # without friction


def test_the_readings_of_an_instrument_with_its_own_clock_come_along(moving: Path, tmp_path: Path) -> None:
    (row,) = fleet.conduct(moving / "delta", tmp_path / "run", "identify", model="3", workers=1).rows
    assert row.fitted_mm
    assert 0 < row.noise_mm < 0.1
