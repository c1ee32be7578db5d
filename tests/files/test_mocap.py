"""Motion capture beside a table of joints: C3D, Motive's CSV, Nexus' CSV."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.units import DEG
from tests.support.commands import Run
from tests.support.mocap import TIMES, c3d, motive, seen, stairs


@pytest.fixture
def joints(tmp_path: Path) -> Path:
    rows = [f"{t:.3f},{','.join(f'{v:.5f}' for v in q)}" for t, q in zip(TIMES, stairs(TIMES), strict=True)]
    (tmp_path / "joints.csv").write_text("\n".join(["time_s,q1_deg,q2_deg,q3_deg", *rows]) + "\n")
    return tmp_path / "joints.csv"


def nexus(folder: Path) -> Path:
    head = ["Trajectories", "100", ",,Arm:tool,,,Arm:base,,", "Frame,Sub Frame,X,Y,Z,X,Y,Z", ",,mm,mm,mm,mm,mm,mm"]
    rows = [f"{k},0,{x},{y},{z},1,2,3" for k, (x, y, z) in enumerate(seen(TIMES))]
    (folder / "take.csv").write_text("\n".join(head + rows) + "\n")
    return folder / "take.csv"


def assert_stairs(found: dc.Recording, rows: int = 8) -> None:
    assert found.n_rows == rows
    assert found.joints == pytest.approx(stairs(np.arange(rows) / 2 + 0.4) * DEG, abs=1e-6)
    assert found.measured[:, :3] == pytest.approx(seen(np.arange(rows) / 2 + 0.4), abs=1e-3)


@pytest.mark.parametrize("unit", ["mm", "m"])
def test_a_marker_of_a_c3d_file(tmp_path: Path, joints: Path, unit: str) -> None:
    assert_stairs(dc.import_c3d(c3d(tmp_path, unit=unit), joints).recordings["recording"])


def test_a_rigid_body_of_motive_is_a_pose(tmp_path: Path, joints: Path) -> None:
    found = dc.import_c3d(motive(tmp_path), joints).recordings["recording"]
    assert_stairs(found)
    assert found.kind == "pose"
    assert from_vector(found.measured[:, 3:])[0, :2, 0] == pytest.approx([np.cos(0.4), np.sin(0.4)])


def test_a_marker_of_nexus_is_named(tmp_path: Path, joints: Path, run: Run) -> None:
    code, _, said = run("import", "c3d", nexus(tmp_path), joints, "-o", tmp_path / "out")
    assert code == 3
    assert "2 markers were captured. Name one, --readings NAME; there are Arm:tool, Arm:base" in said
    assert run("import", "c3d", nexus(tmp_path), joints, "--readings", "Arm:tool", "-o", tmp_path / "out")[0] == 0
    assert_stairs(dc.import_c3d(nexus(tmp_path), joints, readings="Arm:tool").recordings["recording"])


def test_another_clock_is_brought_to_that_of_the_joints(tmp_path: Path, joints: Path) -> None:
    text = joints.read_text().splitlines()
    late = [f"{float(line.partition(',')[0]) + 1000},{line.partition(',')[2]}" for line in text[1:]]
    joints.write_text("\n".join([text[0], *late]) + "\n")
    with pytest.raises(InputError, match="say by how much they differ"):
        dc.import_c3d(motive(tmp_path), joints)
    assert_stairs(dc.import_c3d(motive(tmp_path), joints, offset_s=1000.0).recordings["recording"])


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("", "neither C3D nor a table"),
        ("Trajectories\n100\n", "ends in its header"),
        ("Trajectories\n0\n,,a,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n1,0,1,2,3\n", "rate of the frames"),
        ("Trajectories\n100\n,,a,,\nFrame,Sub Frame,X,Y,Z\n,,ell,ell,ell\n1,0,1,2,3\n", "'ell' is no unit"),
        (
            "Trajectories\n100\n,,a,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n1,0,1,x,3\n",
            "line 6.*'column 4': .* 'x', a number",
        ),
        ("Frame,Time (Seconds),X\n", "row with names is missing"),
    ],
)
def test_what_is_no_capture_is_said(tmp_path: Path, joints: Path, content: str, said: str) -> None:
    (tmp_path / "take.csv").write_text(content)
    with pytest.raises(InputError, match=said):
        dc.import_c3d(tmp_path / "take.csv", joints)


def test_labels_of_a_damaged_c3d_file_may_be_numbers(
    tmp_path: Path, joints: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ezc3d = pytest.importorskip("ezc3d")
    path = c3d(tmp_path, labels=("tool", "base"))
    read = ezc3d.c3d(str(path))
    read["parameters"]["POINT"]["LABELS"]["value"] = np.array([3, 7])
    monkeypatch.setattr(ezc3d, "c3d", lambda _: read)
    with pytest.raises(InputError, match=r"2 markers were captured\. Name one, --readings NAME; there are 3, 7"):
        dc.import_c3d(path, joints)


def test_a_damaged_c3d_file_is_said(tmp_path: Path, joints: Path) -> None:
    pytest.importorskip("ezc3d")
    (tmp_path / "take.c3d").write_bytes(b"\x02\x50" + bytes(2000))
    with pytest.raises(InputError, match="C3D"):
        dc.import_c3d(tmp_path / "take.c3d", joints)
