"""Recordings that a diagnosis can use only in part, or not at all: what is said, and what is found all the same."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.diagnosis.findings import only_turned
from deltacal_gen.diagnosis.search import Doubt, Found
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.files.writing import write_recording
from deltacal_gen.pages import report
from deltacal_gen.physics.terms import Beyond
from deltacal_gen.results.reader import read_result
from tests.support.commands import Run
from tests.support.laws import law
from tests.support.left_out import POSES, channels, effect, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

BACKLASH = effect("backlash", (2,), 0.02)
LOADED = ("joint_compliance", "payload_deflection", "proximal_bending", "distal_compliance", "base_compliance")
Edit = Callable[[list[str], int], None]
Diagnose = Callable[..., tuple[int, dict[str, Any], str, str]]


@pytest.fixture
def shop(tmp_path: Path) -> Path:
    """A folder with a robot file and a recording of a machine with play in joint 2, and every channel."""
    robot = machine()
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    of = channels(POSES, "approach", "temp", "time", "payload")
    write_recording(record(robot, BACKLASH, of=of), tmp_path / "recording.csv")
    return tmp_path


@pytest.fixture
def diagnose(run: Run, shop: Path) -> Diagnose:
    """Run ``deltacal diagnose`` in the shop; return exit code, DIAGNOSIS.json, standard output and error."""

    def call() -> tuple[int, dict[str, Any], str, str]:
        path = shop / "diagnosis.json"
        code, out, err = run("diagnose", shop / "robot.toml", shop / "recording.csv", "-o", path)
        return code, json.loads(path.read_text()) if path.exists() else {}, " ".join(out.split()), err

    return call


def column(shop: Path, name: str, value: Callable[[int, str], str]) -> None:
    """Replace the cells of a column: a function of the line in the file and of what is there."""
    path = shop / "recording.csv"
    rows = [row.split(",") for row in path.read_text().splitlines()]
    c = rows[0].index(name)
    for k, row in enumerate(rows[1:]):
        row[c] = value(k + 2, row[c])
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")


def not_tested(found: dict[str, Any]) -> dict[str, str]:
    return {t["name"]: t["missing"] for t in found["not_tested"]}


def still_found(found: dict[str, Any]) -> None:
    assert found["verdict"] == "missing_physics"
    assert [(e["name"], e["limbs"]) for e in found["effects"]] == [("backlash", [2])]


def test_a_sound_recording_tests_all_that_it_can(diagnose: Diagnose) -> None:
    code, found, _, _ = diagnose()
    assert code == 0
    still_found(found)
    assert not not_tested(found).keys() & {*LOADED, "thermal_zero", "thermal_growth", "zero_drift", "friction_windup"}


def test_a_channel_that_never_changes_tests_nothing(shop: Path, diagnose: Diagnose) -> None:
    column(shop, "temp_C", lambda line, cell: "23.5")
    column(shop, "payload_kg", lambda line, cell: "2")
    code, found, out, _ = diagnose()
    assert code == 0
    still_found(found)
    left_out = not_tested(found)
    assert "differ" in left_out["thermal_zero"]
    assert "differ" in left_out["thermal_growth"]
    assert "payload_kg" in left_out["payload_deflection"]
    assert "joint_compliance" not in left_out  # a constant load bends joints too
    assert re.search(r"not tested: [\w, ]*\bthermal_zero\b", out)


@pytest.mark.parametrize("times", [1, 3])
def test_a_clock_that_tells_few_times_has_no_moment_between_them(shop: Path, diagnose: Diagnose, times: int) -> None:
    column(shop, "time_s", lambda line, cell: str(60 * (line * times // (POSES + 2))))
    code, found, _, _ = diagnose()
    assert code == 0
    still_found(found)


@pytest.mark.parametrize(
    ("name", "victims"),
    [("temp_C", ("thermal_zero", "thermal_growth")), ("time_s", ("zero_drift",)), ("payload_kg", LOADED)],
)
def test_a_channel_that_is_half_missing_is_not_guessed(
    shop: Path, diagnose: Diagnose, name: str, victims: Sequence[str]
) -> None:
    column(shop, name, lambda line, cell: "" if line % 2 else cell)
    code, found, out, _ = diagnose()
    assert code == 0
    still_found(found)
    left_out = not_tested(found)
    for victim in victims:
        assert name in left_out[victim]
        assert "blank" in left_out[victim]
        assert re.search(rf"not tested: [\w, ]*\b{victim}\b", out)


@pytest.mark.parametrize(
    ("name", "value", "victims", "expected"),
    [
        ("temp_C", "400", ("thermal_zero", "thermal_growth"), "degC"),
        ("payload_kg", "1000", LOADED, "kg"),
        ("payload_kg", "-2", LOADED, "negative"),
    ],
)
def test_units_that_cannot_be_take_a_channel_out_and_say_where(
    shop: Path, diagnose: Diagnose, name: str, value: str, victims: Sequence[str], expected: str
) -> None:
    column(shop, name, lambda line, cell: value if line == 9 else cell)
    code, found, out, _ = diagnose()
    assert code == 0
    still_found(found)
    left_out = not_tested(found)
    for victim in victims:
        for word in (name, "line 9", value, expected):
            assert word in left_out[victim]
    assert "line 9" in out


def test_a_direction_that_is_none_takes_its_effects_out(shop: Path, diagnose: Diagnose) -> None:
    column(shop, "approach2", lambda line, cell: "7" if line == 12 else cell)
    code, found, _, _ = diagnose()
    assert code == 0
    assert "line 12" in not_tested(found)["backlash"]
    assert "line 12" in not_tested(found)["friction_windup"]
    assert found["verdict"] == "unexplained"
    assert found["effects"] == []


def test_without_masses_no_load_is_tested(shop: Path, diagnose: Diagnose) -> None:
    (shop / "robot.toml").write_text(robot_to_toml(machine(masses=None)))
    code, found, out, _ = diagnose()
    assert code == 0
    still_found(found)
    for name in (*LOADED, "friction_windup"):
        assert "[masses]" in not_tested(found)[name]
    assert "[masses]" in out


def shortened(shop: Path, count: int) -> None:
    path = shop / "recording.csv"
    path.write_text("\n".join(path.read_text().splitlines()[: count + 1]) + "\n")


def test_too_few_readings_are_refused_with_the_number_needed(shop: Path, diagnose: Diagnose) -> None:
    shortened(shop, 14)
    code, found, out, err = diagnose()
    assert code == 3
    assert found == {}
    assert out == ""
    assert "recording.csv" in err
    assert "51" in err  # 42 parameters, 6 of the frame, 3 to see noise in


def test_many_repeats_of_few_poses_are_no_long_recording(run: Run, tmp_path: Path) -> None:
    robot = machine()
    joints = np.degrees(record(robot, n=10).joints)
    made = record(robot, n=80, joints=np.tile(joints, (8, 1)), pose=[str(k % 10) for k in range(80)])
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    write_recording(made, tmp_path / "recording.csv")
    code, out, err = run("diagnose", tmp_path / "robot.toml", tmp_path / "recording.csv")
    assert code == 3
    assert out == ""
    assert "10 different poses" in err


def test_a_short_recording_promises_no_more_than_it_can(run: Run, tmp_path: Path) -> None:
    robot = machine()
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    write_recording(record(robot, n=17), tmp_path / "recording.csv")
    code, out, _ = run("diagnose", tmp_path / "robot.toml", tmp_path / "recording.csv", "--json")
    assert code == 0
    found = json.loads(out)
    assert found["verdict"] == "adequate"
    assert "too few" in found["summary"]
    assert any("poses" in m["text"] for m in found["next_measurements"])


@pytest.mark.walk
def test_play_of_less_than_nothing_is_a_direction_that_counts_the_other_way(shop: Path, diagnose: Diagnose) -> None:
    for joint in (1, 2, 3):
        column(shop, f"approach{joint}", lambda line, cell: str(-int(float(cell))))
    _, found, out, _ = diagnose()
    assert not found["effects"]
    size = r"backlash at limb 2 with a width of 0\.0[12]\d* deg, if approach counts the other way here"
    assert re.match(f"It may be {size}, or [a-z ]+: compare the signs of that column first", found["summary"])
    assert re.search(size, out)
    assert (found["verdict"], found["laws"]) == ("unexplained", [])
    page = report.diagnosis(read_result(found))
    assert "The direction of approach may count the other way" in page
    steps = page[page.index("What to do") :]
    assert re.search(r"<ol>\s*<li>Compare the signs of the approach columns: it may be " + size, steps)
    [why] = [r["why"] for r in found["rejected"] if r["name"] == "backlash"]
    assert "unless approach counts the other way here" in why


def test_no_law_stands_for_the_wrong_sign_but_one_of_more_than_the_direction_does() -> None:
    doubt = Doubt(Beyond(0, "width", -0.02, "deg", (0.0, 2.0), turned=True), 2, 900.0)
    considered = [Found(BACKLASH, 0.0, -np.inf, doubt), Found(effect("zero_drift", (2,), 0.1), 100.0, 80.0)]
    plain, product = law("joint = c1*approach", 0.01), law("joint = c1*approach*warming", 0.01)
    assert only_turned(considered, [plain])
    assert not only_turned(considered, [product])
    assert not only_turned(considered, [plain, product])
    assert not only_turned(considered[1:], [plain])
    assert not only_turned(considered, [])
