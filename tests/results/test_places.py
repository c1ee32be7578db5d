"""Where something sits is said in the words of the machine, and of a chain with the table of its file it stands in."""

from __future__ import annotations

import dataclasses
import json
import re
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.files.robot import kept_robot, read_robot, robot_from_dict, robot_to_toml
from deltacal_gen.machine.places import at, place_of, places_of
from deltacal_gen.motion.diagnosis import _in_words
from deltacal_gen.results.diagnosis import LawTerm
from tests.support.commands import Run
from tests.support.left_out import machine
from tests.support.open_chains import ARM, AXIS
from tests.support.open_chains import robot as arm

STAND = {"kind": "fixed", "d": 40.0}  # a link that counts as a table of the file, not as a joint


def test_every_machine_has_its_word() -> None:
    robots = {name: read_robot(example(name) / "robot.toml") for name in ("delta", "hexapod", "linear_delta")}
    told = {name: places_of(robot).part for name, robot in robots.items()}
    assert told == {"delta": "limb", "hexapod": "leg", "linear_delta": "tower"}
    assert places_of(arm()).part == "joint"


def test_an_answer_calls_places_as_the_machine_does() -> None:
    examples = [path.parent.name for path in example().parent.glob("*/robot.toml")]
    stood, axis = arm([STAND, *ARM[:2], STAND, *ARM[2:]]), robot_from_dict(AXIS)
    robots = [read_robot(example(name) / "robot.toml") for name in examples]
    for robot in (*robots, arm(), stood, axis, dataclasses.replace(axis, name="X slide")):
        assert kept_robot(robot).places == places_of(robot)


def test_several_are_counted_and_the_whole_machine_is_nowhere() -> None:
    delta = machine()
    assert (place_of(delta, (2,)), place_of(delta, (1, 3))) == ("limb 2", "limbs 1 and 3")
    assert at(delta, (1, 2, 3)) == " at limbs 1, 2 and 3"
    assert at(delta, ()) == ""
    assert at(delta, (2,), "joint") == " at joint 2"  # of drives


def test_a_joint_is_told_with_its_table_where_the_file_counts_other_links_too() -> None:
    plain, stood = arm(), arm([STAND, *ARM[:2], STAND, *ARM[2:]])
    assert place_of(plain, (2, 3)) == "joints 2 and 3"
    assert place_of(stood, (2, 3)) == "joints 2 ([[joint]] 3) and 3 ([[joint]] 5)"
    assert [places_of(stood).number(k) for k in (1, 6)] == ["1 ([[joint]] 2)", "6 ([[joint]] 8)"]


def test_an_axis_goes_by_its_name() -> None:
    axis = robot_from_dict(AXIS)
    assert at(axis, (1,)) == " at the axis"
    assert at(dataclasses.replace(axis, name="X slide"), (1,)) == " at the axis 'X slide'"


@pytest.mark.walk
def test_what_is_found_on_an_arm_is_told_of_its_joints_everywhere(run: Run, tmp_path: Path) -> None:
    """In the summary, where it sits, the table, the page and the commands; keys of JSON stay."""
    stood = arm([STAND, *ARM])
    (tmp_path / "robot.toml").write_text(robot_to_toml(stood))
    (tmp_path / "truth.toml").write_text('[[effects]]\nname = "backlash"\nlimb = 2\nwidth = 0.03\n')
    rng = np.random.default_rng(3)
    q, approach = rng.uniform(-120, 120, (70, 6)), rng.choice([-1, 1], (70, 6))
    header = ",".join([f"q{i}_deg" for i in range(1, 7)] + [f"approach{i}" for i in range(1, 7)])
    np.savetxt(tmp_path / "poses.csv", np.hstack([q, approach]), delimiter=",", header=header, comments="")
    (tmp_path / "poses.toml").write_text('[measurement]\nkind = "pose"\nframe = "unknown"\n')
    robot, read = tmp_path / "robot.toml", tmp_path / "read.csv"
    dc.simulate(robot, tmp_path / "poses.csv", output=read, truth=tmp_path / "truth.toml", noise=0.01, seed=1)
    code, out, _ = run("diagnose", robot, read, "-o", tmp_path / "found.json", "--report", tmp_path / "found.html")
    found = json.loads((tmp_path / "found.json").read_text())
    assert (code, [(e["name"], e["limbs"]) for e in found["effects"]]) == (0, [("backlash", [2])])
    place = "joint 2 ([[joint]] 3)"
    assert f"(backlash) at {place}" in found["summary"]
    assert found["location"]["text"].endswith(f"at {place}")
    assert re.search(r"effect\W+joint\W+parameter", out)
    assert re.search(r"backlash\W+2 \(\[\[joint\]\] 3\)", out)
    page = (tmp_path / "found.html").read_text()
    assert f"Backlash at {place}" in page
    assert "<th>joint</th>" in page
    assert not re.search(r"\blimbs?\b", re.sub(r"<style>.*?</style>|<[^>]*>", " ", page, flags=re.S))


def test_drives_are_told_of_joints_with_their_tables() -> None:
    law: Any = SimpleNamespace(terms=[LawTerm(target="torque", limbs=(3,), expression="c1*q", coefficients=())])
    told = [_in_words(r, [law]) for r in (arm([STAND, *ARM]), machine())]
    assert told == [["a torque of c1*q (joint 3 ([[joint]] 4))"], ["a torque of c1*q (joint 3)"]]
