"""Trackers' lists of points beside a table of joints."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.machine.registry import load_mechanism, mechanism_of
from deltacal_gen.units import DEG
from tests.support.commands import Run

JOINTS = "point,J1 [deg],J2 [deg],J3 [deg],payload_kg\nP1,10,20,30,0.5\nP2,11,21,31,0.5\nP9,12,22,32,0.7\n"
LISTS = {
    "header": "Group Name,Point Name,X [mm],Y [mm],Z [mm]\nA,P1,1.5,2,-800\nA,P2,2.5,3,-801\nA,P7,0,0,0\n",
    "bare": "// exported\nA P1 1.5 2 -800\nA P2 2.5 3 -801\nA P7 0 0 0\n",
    "commas": "A;P1;1,5;2,0;-800,0\nA;P2;2,5;3,0;-801,0\nA;P7;0,0;0,0;0,0\n",
    "metres": "Point\tX (m)\tY (m)\tZ (m)\nP1\t0.0015\t0.002\t-0.8\nP2\t0.0025\t0.003\t-0.801\nP7\t0\t0\t0\n",
}


def files(folder: Path, points: str, joints: str = JOINTS) -> tuple[Path, Path]:
    (folder / "points.txt").write_text(points)
    (folder / "joints.csv").write_text(joints)
    return folder / "points.txt", folder / "joints.csv"


@pytest.mark.parametrize("form", LISTS)
def test_lists_of_every_form_give_one_recording(tmp_path: Path, form: str) -> None:
    found = dc.import_points(*files(tmp_path, LISTS[form]), output=tmp_path / "out")
    recording = read_recording(tmp_path / "out" / "recording.csv", load_mechanism("delta"))
    assert recording.pose.tolist() == ["P1", "P2"]
    assert recording.joints == pytest.approx(np.array([[10, 20, 30], [11, 21, 31]]) * DEG)
    assert recording.measured == pytest.approx(np.array([[1.5, 2, -800], [2.5, 3, -801]]))
    assert recording.measurement.frame == "unknown"
    assert recording.payload_kg == pytest.approx([0.5, 0.5])
    assert len(found.warnings) == 2
    assert "P7" in found.warnings[0]
    assert "P9" in found.warnings[1]


def test_a_list_may_be_a_sheet_of_a_workbook(tmp_path: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    for row in (
        ["cell 7", "night shift"],
        [],
        ["Group", "Point Name", "X [m]", "Y [m]", "Z [m]"],
        ["A", "P1", 1, 2, 3],
    ):
        book["Sheet"].append(row)
    book.save(tmp_path / "points.xlsx")
    (tmp_path / "joints.csv").write_text(JOINTS)
    found = dc.import_points(tmp_path / "points.xlsx", tmp_path / "joints.csv").recordings["recording"]
    assert found.measured.tolist() == [[1000, 2000, 3000]]
    assert found.line.tolist() == [4]


def test_rotations_that_a_list_holds_are_not_passed_over(tmp_path: Path) -> None:
    points = "point,X,Y,Z,Rx,Ry,Rz\nP1,1,2,3,10,20,30\nP2,2,3,4,11,21,31\nP9,5,3,4,12,22,32\n"
    (warning,) = dc.import_points(*files(tmp_path, points)).warnings
    assert warning.startswith("Rx, Ry, Rz are not read")


def test_groups_are_set_ups_and_a_point_that_comes_again_is_a_repeat(tmp_path: Path) -> None:
    points = "A,P1,1,2,3\nA,P1,1.1,2,3\nB,P1,5,6,7\nB,P2,8,9,10\n"
    recording = dc.import_points(*files(tmp_path, points)).recordings["recording"]
    assert recording.setup_names == ("A", "B")
    assert recording.setup.tolist() == [0, 0, 1, 1]
    assert recording.pose.tolist() == ["P1", "P1", "P1", "P2"]


@pytest.mark.parametrize(
    ("points", "joints", "said"),
    [
        ("A,P1,1,2,3\n", JOINTS.replace(" [deg]", ""), "unit of a joint"),
        ("A,P5,1,2,3\n", JOINTS, "no point of the list"),
        ("A P1 1 2 3\nA P2 2\n", JOINTS, "points.txt, line 2: the row has 3 cells, the header 5"),
        (
            "group,point,X,Y,Z\nA,P1,1,x,3\n",
            JOINTS,
            "points.txt, line 2, column 'y_mm': the cell holds 'x'",
        ),
        ("group,point,X,Y\nA,P1,1,2\n", JOINTS, "points.txt, line 1, column 'z_mm': the column is missing"),
        ("A,P1,1,2,3\n", JOINTS + "P1,1,1,1,0\n", "comes twice"),
        ("A,P1,1,2,3\n", JOINTS.replace("J2", "J4"), "not numbered from 1"),
    ],
)
def test_mistakes_are_named(tmp_path: Path, points: str, joints: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        dc.import_points(*files(tmp_path, points, joints))


def test_the_robot_is_written_beside_and_its_joints_are_counted(tmp_path: Path) -> None:
    arm = tmp_path / "arm.toml"
    links = '[[joint]]\nkind = "revolute"\na = 200.0\n' * 3
    arm.write_text('[robot]\nname = "arm"\nmechanism = "serial"\n' + links + "[geometry]\ntool = [0.0, 0.0, 0.0]\n")
    dc.import_points(*files(tmp_path, LISTS["bare"]), arm, tmp_path / "out")
    assert mechanism_of(dc.read_robot(tmp_path / "out" / "robot.toml")).limbs == 3
    arm.write_text(arm.read_text().replace(links, links + links[: len(links) // 3]))
    with pytest.raises(InputError, match="has 3 joints, the robot 4"):
        dc.import_points(*files(tmp_path, LISTS["bare"]), arm)


def test_an_import_says_which_files_it_takes(run: Run, tmp_path: Path) -> None:
    code, _, said = run("import", "rrf", tmp_path / "config.g", "-o", tmp_path / "mine")
    assert code == 2
    assert 'import rrf" parameter HEIGHT_MAP requires an argument' in said
