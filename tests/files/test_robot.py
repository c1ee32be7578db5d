"""Robot files: what is read, what is refused and how that is said, and that writing loses nothing."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import read_robot, robot_from_dict, robot_size, robot_to_dict, robot_to_toml
from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.units import DEG, to_file

LENGTHS = ("base_radius", "platform_radius", "proximal_length", "distal_length", "joint_spacing")


TEXT = """\
[robot]
name = "prototype"
mechanism = "delta"

[geometry]   # mm
base_radius = 200.0
platform_radius = 51
proximal_length = 375.0
distal_length = 950.0
joint_spacing = 100.0
tool = [0.0, 0.0, -60.0]

[workspace]
top = 728.0
radius = 500.0
height = 250.0

[masses]
proximal = 1.2
proximal_com = 0.4
distal_rod = 0.15
platform = 0.8

[transmission]
gear_ratio = 20.0
encoder_counts = 10000

[errors]
theta_1 = 0.1
[tolerance]
theta_1 = 0.5
L_2 = 0.05
[joints]
sign = [1, -1, 1]
limits_deg = [
  [-60.0, 95.0],
  [-60.0, 95.0], [-60.0, 95.0]]
"""


def read(tmp_path: Path, text: str) -> Any:
    path = tmp_path / "robot.toml"
    path.write_text(text, encoding="utf-8")
    return read_robot(path)


def test_a_complete_file_is_read_in_internal_units(tmp_path: Path) -> None:
    robot = read(tmp_path, TEXT)
    assert (robot.name, robot.mechanism, robot.source) == ("prototype", "delta", tmp_path / "robot.toml")
    assert robot.geometry["platform_radius"].tolist() == [51.0]
    np.testing.assert_allclose(robot.geometry["limb_angle_deg"], [-math.pi / 2, math.pi / 6, 5 * math.pi / 6])
    assert robot.tool.tolist() == [0.0, 0.0, -60.0]
    assert (robot.workspace.top, robot.workspace.radius, robot.workspace.height) == (728.0, 500.0, 250.0)
    assert robot.masses.gravity == (0.0, 0.0, -9.81)
    assert robot.masses.proximal_inertia is None
    assert robot.transmission.encoder_counts == 10000
    assert robot.errors == {"theta_1": 0.1 * DEG}
    assert robot.tolerance == {"theta_1": 0.5 * DEG, "L_2": 0.05}
    assert robot.joint_sign.tolist() == [1.0, -1.0, 1.0]
    np.testing.assert_allclose(robot.joint_limits, [[-60 * DEG, 95 * DEG]] * 3)
    assert robot_size(robot) == 1676.0


def test_optional_tables_may_be_absent_and_one_number_stands_for_all_limbs(tmp_path: Path) -> None:
    lengths = "radius = 160.0\narm_length = 345.0\ntower_angle = [210.0, 330.0, 90.0]\nendstop = 380.0\n"
    robot = read(tmp_path, f'[robot]\nmechanism = "linear_delta"\n[geometry]\n{lengths}')
    assert robot.geometry["arm_length"].tolist() == [345.0] * 3
    assert robot.joint_sign.tolist() == [1.0] * 3
    assert (robot.workspace, robot.masses, robot.transmission, robot.joint_limits) == (None,) * 4


@pytest.mark.parametrize(
    ("old", "new", "line", "said"),
    [
        (
            "base_radius = 200.0",
            "base_radus = 200.0",
            6,
            "'base_radus' in [geometry] is not known. Did you mean 'base_r",
        ),
        (
            "distal_length = 950.0",
            "",
            5,
            "'distal_length' in [geometry] is missing. Add it: l: length of the rods [mm]",
        ),
        ("base_radius = 200.0", "gravity = 200.0", 6, "'gravity' in [geometry] is not known. It belongs to [masses]."),
        ("[geometry]   # mm", "[geometri]", 5, "'geometri' is not known. Did you mean 'geometry'?"),
        ("= 375.0", "= -375.0", 8, "'proximal_length' in [geometry] is -375.0: a number above 0 was expected. Correct"),
        ("= 375.0", "= nan", 8, "a finite number was expected"),
        ("= 375.0", "= '375'", 8, "'375': a number was expected"),
        ("= 375.0", "= true", 8, "True: a number was expected"),
        ("= 375.0", "= 375,0", 8, "this is not TOML"),
        ("-60.0]\n\n", "]\n\n", 11, "3 entries were expected"),
        ("sign = [1, -1, 1]", "sign = [1, 2, 1]", 34, "'sign' in [joints], entry 2 is 2: 1 or -1 was expected"),
        ("sign = [1, -1, 1]", "sign = [1, 1]", 34, "3 entries were expected"),
        ("[-60.0, 95.0]]", "[95.0, -60.0]]", 35, "entry 3 is [95.0, -60.0]: the lower limit must be below"),
        ("limits_deg", "limits_mm", 35, "Did you mean 'limits_deg'?"),
        ("theta_1 = 0.1", "teta_1 = 0.1", 29, "'teta_1' in [errors] is not known. Did you mean 'theta_1'?"),
        ("L_2 = 0.05", "L_2 = 0.0", 32, "a number above 0 was expected"),
        ("top = 728.0", "", 13, "'top' in [workspace] is missing. Add it: the workspace of delta is a cylinder [mm]"),
        ("radius = 500.0", "width = 500.0", 15, "'width' in [workspace] is not known. Known here: top, height, radius"),
        ("platform = 0.8", "plattform = 0.8", 22, "Did you mean 'platform'?"),
        ('mechanism = "delta"', 'mechanism = "detla"', 3, "no mechanism 'detla'. Registered: "),
        ('mechanism = "delta"', "", 1, "'mechanism' in [robot] is missing"),
        ("[robot]", "[robot", 1, "this is not TOML"),
    ],
)
def test_a_flaw_is_named_with_its_line_and_a_remedy(tmp_path: Path, old: str, new: str, line: int, said: str) -> None:
    assert old in TEXT
    with pytest.raises(InputError) as caught:
        read(tmp_path, TEXT.replace(old, new, 1))
    assert said in str(caught.value)
    assert f"robot.toml, line {line}: " in str(caught.value)
    assert caught.value.remedy


@pytest.mark.parametrize(("factor", "unit"), [(1e-3, "metres"), (1e3, "micrometres")])
def test_lengths_in_another_unit_are_noticed(tmp_path: Path, factor: float, unit: str) -> None:
    tables = robot_to_dict(read(tmp_path, TEXT))
    tables["geometry"] |= {key: tables["geometry"][key] * factor for key in LENGTHS}
    with pytest.raises(InputError, match=f"look like {unit} .* the file is in millimetres"):
        robot_from_dict(tables)


@pytest.mark.parametrize("name", ["delta", "hexapod", "linear_delta"])
def test_directions_in_radians_are_noticed(name: str) -> None:
    tables = robot_to_dict(read_robot(example(name) / "robot.toml"))
    found = {"delta": ("joints", "limb_angle_deg"), "hexapod": ("geometry", "base_angle")}
    table, key = found.get(name, ("geometry", "tower_angle"))
    tables[table][key] = np.radians(tables[table][key]).tolist()
    with pytest.raises(InputError, match=f"{key} = .* looks like radians; the file is in degrees"):
        robot_from_dict(tables)


def test_a_file_that_cannot_be_read_is_an_input_error(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be read: No such file"):
        read_robot(tmp_path / "none.toml")
    (tmp_path / "latin.toml").write_bytes(b'[robot]\nname = "Gr\xf6\xdfe"\n')
    with pytest.raises(InputError, match=r"latin.toml, line 2: byte \d+ is not UTF-8"):
        read_robot(tmp_path / "latin.toml")
    (tmp_path / "deep.toml").write_text("a = " + "[" * 5000)
    with pytest.raises(InputError, match="this is not TOML"):
        read_robot(tmp_path / "deep.toml")


def test_writing_gives_back_the_numbers_as_they_were_typed(tmp_path: Path) -> None:
    robot = read(tmp_path, TEXT)
    assert "theta_1 = 0.1\n" in robot_to_toml(robot)
    assert "limits_deg = [[-60.0, 95.0], [-60.0, 95.0], [-60.0, 95.0]]" in robot_to_toml(robot)


lengths = st.floats(10.0, 5000.0)
signed = st.floats(-1e3, 1e3)
turned = signed.filter(lambda v: abs(v) > 10.0)  # limbs all round within a few degrees are refused as radians


@settings(max_examples=15, derandomize=True, deadline=None)
@given(
    name=st.text(st.characters(exclude_categories=["Cs"])),
    geometry=st.fixed_dictionaries(
        dict.fromkeys(LENGTHS, lengths) | {"tool": st.lists(signed, min_size=3, max_size=3)}
    ),
    joints=st.fixed_dictionaries({"limb_angle_deg": st.lists(turned, min_size=3, max_size=3)}),
    errors=st.dictionaries(st.sampled_from([p.name for p in load_mechanism("delta").parameters]), signed, min_size=1),
)
def test_a_robot_survives_toml(tmp_path_factory: Any, name: str, geometry: Any, joints: Any, errors: Any) -> None:
    tables = {
        "robot": {"name": name, "mechanism": "delta"},
        "geometry": geometry,
        "masses": {"gravity": [0.1, 0.0, -9.7]},
        "joints": joints | {"sign": [1, 1, -1], "limits_deg": [[-1.0, 1.0]] * 3},
        "errors": errors,
    }
    robot = robot_from_dict(tables)
    again = read(tmp_path_factory.getbasetemp(), robot_to_toml(robot))
    assert again.name == name
    assert again.masses == robot.masses
    for key, values in robot.geometry.items():
        np.testing.assert_allclose(again.geometry[key], values, rtol=1e-15)
    np.testing.assert_array_equal(again.tool, geometry["tool"])
    assert again.errors == pytest.approx(robot.errors, rel=1e-15, abs=0.0)


def test_angles_of_files_are_as_short_as_a_person_writes_them() -> None:
    assert [to_file(turn, "rad") for turn in (math.pi / 6, 30 * DEG, -math.pi / 2)] == [30.0, 30.0, -90.0]
    assert to_file(0.1 + 0.2, "mm") == 0.1 + 0.2  # a length is read as it was, to its last digit
