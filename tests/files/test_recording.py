"""Recordings: every kind is read as it is written, and every flaw is refused with file, line, column and remedy."""

from __future__ import annotations

import contextlib
import dataclasses
import shutil
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError
from deltacal_gen.files.checks import check_units
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import robot_from_dict
from deltacal_gen.files.writing import write_files, write_recording
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.units import DEG

SPACE: Any = {
    "axes": ("x", "y", "z"),
    "turns": ("x", "y", "z"),
    "asks": ("px", "py", "pz"),
    "widths": (3,),
    "turning": False,
    "geometry": (),
}
DELTA: Any = SimpleNamespace(name="delta", limbs=3, joint_unit="rad", **SPACE)
TOWERS: Any = SimpleNamespace(name="linear_delta", limbs=3, joint_unit="mm", **SPACE)
PLANAR: Any = SimpleNamespace(
    name="diamond", limbs=2, joint_unit="rad", **SPACE | {"axes": ("x", "y"), "turns": (), "asks": ("px", "py")}
)

HEADER = "pose,q1_deg,q2_deg,q3_deg,x_mm,y_mm,z_mm"
ROWS = ("a,10,20,30,1,2,-700", "b,-10,20,30,300,2,-750", "c,10,-40,5,,,")
CONTACTS = '[measurement]\nkind = "contact"\n[contacts]\ndistance_mm = [["s0", "s1", 50.0]]\n'
CAMERA = "[measurement.camera]\nfx_px = 900\nfy_px = 901\ncx_px = 320\ncy_px = 240\nball_radius_mm = 20\n"
GAUGE = "[measurement]\nbase_point_mm = [1, 2, 3]\n"


@pytest.fixture
def read(tmp_path: Path) -> Any:
    """Writes the files of a recording and reads it back."""

    def read(text: str | bytes, sidecar: str = "", distances: str = "", mechanism: Any = DELTA, **how: Any) -> Any:
        path = tmp_path / "recording.csv"
        path.write_bytes(text.encode() if isinstance(text, str) else text)
        for name, companion in (("recording.toml", sidecar), ("recording.distances.csv", distances)):
            if companion:
                (tmp_path / name).write_text(companion, encoding="utf-8")
        return read_recording(path, mechanism, **how)

    return read


def csv(*rows: str, header: str = HEADER) -> str:
    return "\n".join((header, *rows)) + "\n"


def test_positions_and_channels(read: Any) -> None:
    header = HEADER + ",time_s,temp_motor_C,payload_kg,approach1,humidity,operator,setup,tool_x_mm,tool_y_mm,tool_z_mm"
    tail = (",0,20.5,0,1,40,Ann,A,1,2,3", ",1.5,,,0,41,Bob,B,,,", ",3,21,2.5,-1,,Ann,A,4,5,6")
    recording = read("# a comment\r\n\r\n" + csv(*(a + b for a, b in zip(ROWS, tail, strict=True)), header=header))
    assert (recording.kind, recording.columns, recording.n_rows) == ("position", ("x_mm", "y_mm", "z_mm"), 3)
    np.testing.assert_array_equal(recording.joints, np.array([[10, 20, 30], [-10, 20, 30], [10, -40, 5]]) * DEG)
    np.testing.assert_array_equal(recording.measured, [[1, 2, -700], [300, 2, -750], [np.nan] * 3])
    assert recording.pose.tolist() == ["a", "b", "c"]
    assert recording.line.tolist() == [4, 5, 6]
    assert recording.setup.tolist() == [0, 1, 0]
    assert recording.setup_names == ("A", "B")
    np.testing.assert_array_equal(recording.tool, [[1, 2, 3], [np.nan] * 3, [4, 5, 6]])
    assert list(recording.channels) == ["time_s", "temp_motor_C", "payload_kg", "approach1", "humidity"]
    np.testing.assert_array_equal(recording.channels["approach1"], [1, np.nan, -1])
    np.testing.assert_array_equal(recording.time_s, [0, 1.5, 3])
    np.testing.assert_array_equal(recording.payload_kg, [0, np.nan, 2.5])


JOINTS = "q1_deg,q2_deg,q3_deg"


@pytest.mark.parametrize(
    ("kind", "columns", "cells", "measured", "sidecar"),
    [
        ("pose", "x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg", "1,2,3,90,0,-90", [1, 2, 3, 90 * DEG, 0, -90 * DEG], ""),
        ("pose", "x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg", "1,2,3,,,", [1, 2, 3, np.nan, np.nan, np.nan], ""),
        ("gauge", "gauge_mm", "612.5", [612.5], GAUGE),
        ("height", "height_mm", "-0.2", [-0.2], ""),
        ("sphere", "u1_px,u2_px,v1_px,v2_px", "100,140,90,131", [100, 140, 90, 131], CAMERA),
        ("contact", "contact", "s0", [], ""),
    ],
)
def test_every_kind_follows_from_its_columns(
    read: Any, kind: str, columns: str, cells: str, measured: list[float], sidecar: str
) -> None:
    recording = read(csv(f"1,2,3,{cells}", header=f"{JOINTS},{columns}"), sidecar)
    assert recording.kind == kind
    np.testing.assert_allclose(recording.measured, [measured])
    assert recording.columns == tuple(columns.split(","))


def test_the_sidecar_is_read(read: Any) -> None:
    sidecar = '[measurement]\nkind = "sphere image"\nsigma_deg = 0.1\nzero = "incremental"\n' + CAMERA
    measurement = read(csv("1,2,3,1,2,3,4", header=JOINTS + ",u1_px,u2_px,v1_px,v2_px"), sidecar).measurement
    assert (measurement.kind, measurement.zero, measurement.frame) == ("sphere", "incremental", "unknown")
    assert measurement.sigma_rad == pytest.approx(0.1 * DEG)
    assert measurement.camera.fx_px == 900


def test_distances_between_named_rows(read: Any) -> None:
    rows = csv("p,1,2,3", "q,4,5,6", "r,7,8,9", header=f"pose,{JOINTS}")
    recording = read(rows, distances="pose_a,pose_b,distance_mm\nr,p,12.5\nq,r,\n")
    assert recording.kind == "distance"
    assert recording.pairs.tolist() == [[2, 0], [1, 2]]
    np.testing.assert_array_equal(recording.pair_measured, [12.5, np.nan])
    assert recording.pair_line.tolist() == [2, 3]
    part = recording.subset([2, 0])
    assert (part.pose.tolist(), part.pairs.tolist(), part.pair_measured.tolist()) == (["r", "p"], [[0, 1]], [12.5])
    assert recording.subset_pairs([1]).pairs.tolist() == [[1, 2]]


def test_distances_between_the_two_joint_sets_of_a_row(read: Any) -> None:
    header = "pose,q1a_deg,q2a_deg,q3a_deg,q1b_deg,q2b_deg,q3b_deg,distance_mm,temp_C,payload_a_kg,payload_b_kg"
    recording = read(csv("7,1,2,3,4,5,6,88,21,0,2", ",1,2,3,7,8,9,99,22,0,2", header=header))
    assert (recording.kind, recording.pose.tolist()) == ("distance", ["7a", "7b", "line 3a", "line 3b"])
    np.testing.assert_allclose(recording.joints / DEG, [[1, 2, 3], [4, 5, 6], [1, 2, 3], [7, 8, 9]])
    assert recording.pairs.tolist() == [[0, 1], [2, 3]]
    assert recording.pair_measured.tolist() == [88, 99]
    assert recording.channels["temp_C"].tolist() == [21, 21, 22, 22]
    assert recording.payload_kg is not None
    assert recording.payload_kg.tolist() == [0, 2, 0, 2]


def test_heights_and_distances_together(read: Any) -> None:
    rows = csv("1,400,400,400,0.1", "2,390,400,410,", header="pose,q1_mm,q2_mm,q3_mm,height_mm")
    recording = read(rows, distances="pose_a,pose_b,distance_mm\n1,2,60\n", mechanism=TOWERS)
    assert (recording.kind, recording.joint_unit, recording.pairs.tolist()) == ("height", "mm", [[0, 1]])
    assert recording.joints[1].tolist() == [390, 400, 410]


def test_poses_and_targets_need_no_reading(read: Any) -> None:
    assert np.isnan(read(csv("1,2,3", header=JOINTS), need_measured=False).measured).all()
    recording = read(csv("1,2,-700", header="x_mm,y_mm,z_mm"), need_measured=False, allow_targets=True)
    assert recording.targets.tolist() == [[1, 2, -700]]
    assert np.isnan(recording.joints).all()
    assert np.isnan(recording.measured).all()


def test_of_a_platform_that_turns_about_one_axis_only_that_turn_is_asked_for(read: Any) -> None:
    """Others are zero where they are written: no target is taken that the platform cannot have."""
    own = {"turns": ("z",), "asks": ("px", "py", "pz", "cz"), "widths": (3, 12), "turning": True}
    picker = SimpleNamespace(name="picker", limbs=4, joint_unit="rad", **SPACE | own)
    for header, rest in (("rz_deg", ""), ("rx_deg,ry_deg,rz_deg", "0,-0.0,")):
        text = f"x_mm,y_mm,z_mm,{header}\n10,20,-700,{rest}15\n"
        found = read(text, need_measured=False, allow_targets=True, mechanism=picker).targets
        assert to_vector(found[:, 3:].reshape(-1, 3, 3)) == pytest.approx(np.array([[0.0, 0.0, 15 * DEG]]))
    tilted = "x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n1,2,-700,0,0,5\n1,2,-700,0,3,5\n"
    with pytest.raises(InputError, match="'picker' does not turn about y") as flaw:
        read(tilted, need_measured=False, allow_targets=True, mechanism=picker)
    assert (flaw.value.line, flaw.value.column) == (3, "ry_deg")


def test_a_planar_machine_has_two_axes(read: Any) -> None:
    assert read(csv("1,2,3,4", header="q1_deg,q2_deg,x_mm,y_mm"), mechanism=PLANAR).measured.tolist() == [[3, 4]]


CELL, NO_ROW = ROWS[0], csv()


@pytest.mark.parametrize(
    ("text", "line", "column", "said"),
    [
        ("", None, None, "the file is empty"),
        ("# only a comment\n", None, None, "the file is empty"),
        (NO_ROW, 1, None, "a header but no row"),
        (csv("a,10,abc,30,1,2,3"), 2, "q2_deg", "holds 'abc', a number was expected. Correct the cell"),
        (csv('a,10,"20,5",30.5,1,2,3'), 2, None, "has a decimal comma, and '30.5' a decimal point"),
        (csv(CELL, "b,10,20,30,1,1_000,3"), 3, "y_mm", "holds '1_000', a number was expected"),
        (csv(CELL, "b,10,,30,1,2,3"), 3, "q2_deg", "blank. Fill it in, or remove the row"),
        (csv(CELL, "b,10,nan,30,1,2,3"), 3, "q2_deg", "holds 'nan', a finite number was expected"),
        (csv(CELL, "b,10,20,30,1,nan,3"), 3, "y_mm", "Leave the cell blank where nothing was measured"),
        (csv(CELL, "b,10,20,30,1,inf,3"), 3, "y_mm", "a finite number was expected"),
        (csv(CELL, "b,10,20,30,1,,3"), 3, "y_mm", "but other cells of x_mm, y_mm, z_mm are not"),
        (csv(CELL, "b,10,20,30"), 3, None, "the row has 4 cells, the header 7"),
        (csv(CELL, "b,10,20,30,1,2,3,4"), 3, None, "Decimals need a point, not a comma"),
        (csv("b,10,20,30,,,"), None, None, "no row holds a reading"),
        (csv(CELL, "a,10,20.1,30,1,2,3"), 3, "pose", "pose 'a' has other joints than in line 2"),
        (csv("1,2,3,4,5", header="q1_deg,q2_deg,q2_deg,x_mm,y_mm"), 1, "q2_deg", "stands over columns 2 and 3"),
        (csv("1,2,3,4", header=JOINTS + ","), 1, None, "column 4 has no name"),
        (csv("1,2,3", header=JOINTS), 1, None, "no column holds a measured quantity"),
        (csv("1,2,3", header="x_mm,y_mm,z_mm"), 1, "q1_deg", "the column is missing. Add it in deg"),
        (csv("1,2,3,4", header="q1_deg,q2,q3_deg,x_mm"), 1, "q2_deg", "'q2' looks like it. Rename it to 'q2_deg'"),
        (csv("1,2,3,4", header="q1_grad,q2_grad,q3_grad,x_mm"), 1, "q1_deg", "'q1_grad' looks like it"),
        (csv("1,2,3,4,5,6", header=JOINTS + ",x_mm,y_mm,Z"), 1, "z_mm", "'Z' looks like it"),
        (csv("1,2,3,4,5", header=JOINTS + ",q4_deg,height_mm"), 1, "q4_deg", "joints q1_deg, q2_deg, q3_deg only"),
        (csv("1;2;3;4,567", header="q1_deg;q2_deg;q3_deg;height_mm"), 2, None, "Say it: --decimal , or --decimal ."),
        (csv("1;2;3,5;4.5", header="q1_deg;q2_deg;q3_deg;height_mm"), 2, None, "Write all with one mark"),
        (csv("1,2,3,4,5", header=JOINTS + ",height_mm,gauge_mm"), 1, None, "several kinds: gauge, height"),
        (csv("1,2,3,4,5", header=JOINTS + ",height_mm,approach2"), 2, "approach2", "'5': 1 or -1 was expected"),
        (csv("1,2,3,4,-1", header=JOINTS + ",height_mm,payload_kg"), 2, "payload_kg", "a mass cannot be negative"),
        (csv("1,2,3,4,310", header=JOINTS + ",height_mm,temp_base_C"), 2, "temp_base_C", "-100 to 300 degC"),
        (csv("1,2,3,4,1", header=JOINTS + ",height_mm,tool_x_mm"), 1, "tool_y_mm", "the column is missing"),
        (csv("1,2,3,4,", header=JOINTS + ",height_mm,setup"), 2, "setup", "the cell is blank"),
        (csv("1,2,3,4", header=JOINTS + ",gauge_mm"), None, None, "Add base_point_mm = [x, y, z] to [measurement]"),
        (csv("1,2,3,1,2,3,4", header=JOINTS + ",u1_px,u2_px,v1_px,v2_px"), None, None, "Add [measurement.camera]"),
        (csv("1,2,3,4", header=JOINTS + ",distance_mm"), 1, "distance_mm", "Add recording.distances.csv"),
        (csv("1,2,3,4,5", header="q1a_deg,q2a_deg,q3a_deg,q1b_deg,q2b_deg"), 1, "q3b_deg", "missing"),
        (csv(CELL, 'b,10,20,30,1,2,"3'), 3, None, "this is not CSV"),
        (b"\xff\xfep", None, None, "the file is not text"),
    ],
)
def test_a_flaw_is_named_with_line_column_and_remedy(
    read: Any, text: str | bytes, line: int | None, column: str | None, said: str
) -> None:
    with pytest.raises(InputError) as caught:
        read(text)
    assert said in str(caught.value)
    assert (caught.value.line, caught.value.column) == (line, column)
    assert Path(caught.value.file or "").stem == "recording"
    assert caught.value.remedy


@pytest.mark.parametrize(
    ("sidecar", "line", "said"),
    [
        ("[measurement]\nsigma = 0.01\n", 2, "'sigma' in [measurement] is not known. Did you mean 'sigma_"),
        ('[measurement]\nframe = "base"\n', 2, "'unknown' or 'robot' was expected"),
        ('[measurement]\nkind = "positions"\n', 2, "'positions': 'board_image', 'contact', 'distance'"),
        ("[measurement]\n\nsigma_mm = -1\n", 3, "a number not below 1e-12 was expected"),
        ("[mesurement]\n", 1, "Did you mean 'measurement'?"),
        ("[measurement.camera]\nfx_px = 1.0\nfxy_px = 1.0\n", 3, "'fxy_px' in [measurement.camera] is not known"),
        ("[measurement]\nbase_point_mm = [1, 2]\n", 2, "3 entries were expected"),
        ('[measurement]\nkind = "pose"\n', 1, "kind = 'pose', but this column belongs to kind = 'position'"),
        ('[measurement]\nkind = "height"\n', 1, "kind = 'height', but this column belongs to kind = 'position'"),
        ('[measurement]\nkind = "distance"\n', 1, "Add recording.distances.csv"),
    ],
)
def test_a_flaw_of_the_sidecar(read: Any, sidecar: str, line: int, said: str) -> None:
    with pytest.raises(InputError) as caught:
        read(csv(*ROWS), sidecar)
    assert said in str(caught.value)
    assert caught.value.line == line


def test_a_contact_that_was_never_touched(read: Any) -> None:
    with pytest.raises(InputError, match=r"recording.toml: .* names 's1', which no row has"):
        read(csv("1,2,3,s0", header=JOINTS + ",contact"), CONTACTS)


@pytest.mark.parametrize(
    ("rows", "distances", "line", "column", "said"),
    [
        (("p1,1,2,3", "p2,4,5,6"), "p1,p3,5", 2, "pose_b", "has no pose 'p3'. Correct the name"),
        (("p1,1,2,3", "p2,4,5,6"), "p1,p2,5\np2,p2,0", 3, "pose_b", "paired with itself"),
        (("p1,1,2,3", "p1,1,2,3"), "p1,p1,5", 3, "pose", "stands in line 2 too, but distances name rows by it"),
        (("p1,1,2,3", "p2,4,5,6", "p3,4,5,6"), "p1,p2,5\np3,p2,0.01", 3, None, "a pose and its own repeat"),
        (("p1,1,2,3", "p2,4,5,6"), "p1,p2,-5", 2, "distance_mm", "a distance cannot be negative"),
        (("p1,1,2,3", "p2,4,5,6"), "p1,p2,", None, None, "no row holds a reading"),
    ],
)
def test_a_flaw_of_the_distances(
    read: Any, rows: tuple[str, ...], distances: str, line: int | None, column: str | None, said: str
) -> None:
    with pytest.raises(InputError) as caught:
        read(csv(*rows, header=f"pose,{JOINTS}"), distances=f"pose_a,pose_b,distance_mm\n{distances}\n")
    assert said in str(caught.value)
    assert (caught.value.line, caught.value.column) == (line, column)


# --- units ----------------------------------------------------------------------------------------------------------

SIZED: Any = {  # a machine of 1500 mm
    "robot": {"mechanism": "delta"},
    "geometry": {
        "base_radius": 200.0,
        "platform_radius": 50.0,
        "proximal_length": 350.0,
        "distal_length": 800.0,
        "joint_spacing": 100.0,
    },
}


@pytest.mark.parametrize(
    ("q_scale", "x_scale", "said"),
    [
        (1.0, 1.0, ""),
        (1e-3, 1e-3, ""),  # a small workspace
        (0.0, 1e-4, ""),  # repeats of one pose
        (1.0, 1e-3, "look like metres. Multiply by 1000"),
        (1.0, 1e3, "look like micrometres. Divide by 1000"),
        (DEG, 1.0, "the joints look like radians"),
        (20.0, 1.0, "reads -800 deg, more than joints of this machine turn"),
    ],
)
def test_units_are_checked_against_the_machine(read: Any, q_scale: float, x_scale: float, said: str) -> None:
    q = np.array([[10.0, -40.0, 30.0], [-30.0, 20.0, 5.0], [0.0, 0.0, -35.0]]) * q_scale
    x = np.array([[10.0, 250.0, -700.0], [-200.0, 30.0, -750.0], [300.0, 10.0, -800.0]]) * x_scale
    rows = [",".join(map(repr, row)) for row in np.hstack([q, x]).tolist()]
    recording = read(csv(*rows, header=JOINTS + ",x_mm,y_mm,z_mm"))
    robot = robot_from_dict(SIZED)
    if not said:
        check_units(recording, robot)
        return
    with pytest.raises(InputError, match=said):
        check_units(recording, robot)
    if "turn" in said:
        free = dataclasses.replace(robot, joint_limits=np.array([[-900.0, 900.0]] * 3) * DEG)
        check_units(recording, free)


@pytest.mark.parametrize(("scale", "zero"), [(1.0, "absolute"), (1e-3, "absolute"), (1e-3, "incremental")])
def test_a_ball_bar_s_length_hardly_changes_and_is_no_length_in_metres(read: Any, scale: float, zero: str) -> None:
    """What it spreads over says nothing of its unit; how long it is, does, where it says that."""
    rows = [f"{q},{-q},{q / 2},{300.1 * scale}" for q in (-40, 10, 50)]
    sidecar = f'[measurement]\nzero = "{zero}"\nbase_point_mm = [0.0, 0.0, -800.0]\n'
    recording = read(csv(*rows, header=JOINTS + ",gauge_mm"), sidecar)
    robot = robot_from_dict(SIZED)
    wrong = scale < 1.0 and zero == "absolute"
    with pytest.raises(InputError, match="look like metres") if wrong else contextlib.nullcontext():
        check_units(recording, robot)


@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
def test_a_machine_of_no_size_is_refused(tmp_path: Path, kind: str) -> None:
    (tmp_path / "robot.toml").write_text(f'[robot]\nmechanism = "serial"\n[[joint]]\nkind = "{kind}"\n')
    robot = dc.read_robot(tmp_path / "robot.toml")
    joint = "q1_deg" if kind == "revolute" else "q1_mm"
    (tmp_path / "recording.csv").write_text(f"{joint},x_mm,y_mm,z_mm\n1,1,2,3\n1,2,3,4\n")
    recording = dc.read_recording(tmp_path / "recording.csv", mechanism_of(robot))
    with pytest.raises(InputError, match=r"robot.toml: the machine has no size.* Give a and d of its"):
        check_units(recording, robot)


def test_a_wrist_turns_more_than_once() -> None:
    robot = dc.read_robot(example("serial") / "robot.toml")
    plain = dc.read_recording(example("serial") / "recording.csv", mechanism_of(robot))
    for turns, far in ((1, False), (3, True)):
        joints = plain.joints + 2 * np.pi * turns * (np.arange(6) == 5)
        with pytest.raises(InputError, match="more than joints") if far else contextlib.nullcontext():
            check_units(dataclasses.replace(plain, joints=joints), robot)


# --- writing --------------------------------------------------------------------------------------------------------


def same(a: Recording, b: Recording) -> None:
    for name in ("kind", "columns", "joint_unit", "setup_names", "contact_distances"):
        assert getattr(a, name) == getattr(b, name)
    # degrees to radians, back and there again may move the last bit
    np.testing.assert_allclose(a.joints, b.joints, 2 * np.finfo(float).eps, 0.0)
    for name in ("measured", "pose", "setup", "tool", "targets", "contact", "pairs", "pair_measured"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name), err_msg=name)
    assert a.channels.keys() == b.channels.keys()
    for name, values in a.channels.items():
        np.testing.assert_array_equal(values, b.channels[name])


NAMES = st.text(st.characters(categories=["L", "N", "P", "Zs"]), min_size=1).map(str.strip).filter(bool)
CELLS = st.floats(-1e6, 1e6).map(repr)


@settings(max_examples=30, derandomize=True, deadline=None)
@given(st.data())
def test_a_recording_survives_writing(tmp_path_factory: Any, data: st.DataObject) -> None:
    names = data.draw(st.lists(NAMES, min_size=2, max_size=5, unique=True))
    path = tmp_path_factory.mktemp("written") / "one.csv"
    quoted = ['"' + name.replace('"', '""') + '"' for name in names]
    rows = [",".join([name, *data.draw(st.lists(CELLS, min_size=8, max_size=8))]) for name in quoted]
    rows[0] = f"{quoted[0]},1,2,3,,,,0.1,"
    path.write_text(csv(*rows, header=HEADER + ",humidity,payload_kg").replace(",-", ","), encoding="utf-8")
    if data.draw(st.booleans()):
        pairs = f"pose_a,pose_b,distance_mm\n{quoted[0]},{quoted[1]},{abs(float(data.draw(CELLS)))!r}\n"
        path.with_name("one.distances.csv").write_text(pairs, encoding="utf-8")
    recording = read_recording(path, DELTA)
    write_recording(recording, path.with_name("two.csv"))
    same(read_recording(path.with_name("two.csv"), DELTA), recording)


def test_every_other_kind_survives_writing(read: Any, tmp_path: Path) -> None:
    text = csv("1,2,3,s0,A", "4,5,6,s1,B", "7,8,9,,B", header=JOINTS + ",contact,setup")
    sidecar = CONTACTS.replace("[contacts]", 'instrument = "a \\"socket\\""\nsigma_mm = 0.01\n[contacts]') + CAMERA
    recording = read(text, sidecar)
    write_recording(recording, tmp_path / "again.csv")
    again = read_recording(tmp_path / "again.csv", DELTA)
    same(again, recording)
    assert again.measurement == recording.measurement
    targets = read_recording_of_targets(tmp_path)
    write_recording(targets, tmp_path / "again.csv")
    same(read_recording(tmp_path / "again.csv", DELTA, need_measured=False, allow_targets=True), targets)


def read_recording_of_targets(folder: Path) -> Recording:
    (folder / "targets.csv").write_text("x_mm,y_mm,z_mm\n1,2,-700\n")
    return read_recording(folder / "targets.csv", DELTA, need_measured=False, allow_targets=True)


def test_a_failed_write_leaves_nothing_behind(read: Any, tmp_path: Path) -> None:
    recording = read(csv(*ROWS))
    with pytest.raises(InputError, match=r"none/new.toml: the file cannot be written: No such file"):
        write_recording(recording, tmp_path / "none" / "new.csv")
    (tmp_path / "new.distances.csv").write_text("of another recording")
    with pytest.raises(InputError, match=r"new.distances.csv: the file is in the way"):
        write_recording(recording, tmp_path / "new.csv")
    with pytest.raises(InputError, match="as CSV"):
        write_recording(recording, tmp_path / "new.parquet")
    (tmp_path / "old.csv").write_text("old")
    with pytest.raises(InputError):
        write_files({tmp_path / "old.csv": "new", tmp_path / "none" / "x.csv": "new"})
    assert (tmp_path / "old.csv").read_text() == "old"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["new.distances.csv", "old.csv", "recording.csv"]


def test_parquet_reads_like_csv(read: Any, tmp_path: Path) -> None:
    recording = read(csv(*ROWS))
    columns = {
        name: list(cells)
        for name, cells in zip(HEADER.split(","), np.transpose([r.split(",") for r in ROWS]), strict=True)
    }
    numbers = {name: [float(c) if c else None for c in cells] for name, cells in columns.items() if name != "pose"}
    pq.write_table(pa.table({"pose": columns["pose"]} | numbers), tmp_path / "rows.parquet")
    same(read_recording(tmp_path / "rows.parquet", DELTA), recording)
    (tmp_path / "bad.parquet").write_bytes(b"PAR1 but no more PAR1")
    with pytest.raises(InputError, match=r"bad.parquet: this is not a readable Parquet file"):
        read_recording(tmp_path / "bad.parquet", DELTA)


@pytest.mark.walk
@settings(max_examples=150, derandomize=True, deadline=None)
@given(
    st.one_of(st.binary(), st.text().map(str.encode), st.text('q1_degabxyzm,;"\n\r\t#-.5').map(str.encode)),
    st.sampled_from(["", HEADER + "\n", JOINTS + ",contact\n", "q1a_deg,q1b_deg,"]),
    st.sampled_from(["garbage.csv", "garbage.toml", "garbage.distances.csv", "garbage.parquet"]),
)
def test_garbage_is_an_input_error_and_nothing_else(tmp_path_factory: Any, data: bytes, head: str, name: str) -> None:
    folder = tmp_path_factory.getbasetemp() / "garbage"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    (folder / "garbage.csv").write_text(csv(*ROWS))
    (folder / name).write_bytes(head.encode() + data)
    with contextlib.suppress(InputError):
        read_recording(folder / ("garbage.parquet" if name.endswith("parquet") else "garbage.csv"), DELTA)
