"""Measured rotations whose angles mean something else than a rotation vector: told, and read as the sidecar says."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.rotation import from_turns, from_vector, to_vector
from deltacal_gen.machine.values import POSITION, ROTATION
from tests.support.open_chains import robot

POSE = '[measurement]\nkind = "pose"\n'


@pytest.fixture(scope="module")
def read(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with an arm and 60 poses of it, in an unknown frame, from a wrist that turns by some 60 deg."""
    folder = tmp_path_factory.mktemp("poses")
    (folder / "robot.toml").write_text(robot_to_toml(robot()))
    q = np.random.default_rng(3).uniform(-30, 30, (60, 6)) + np.array([0, 40, -60, 10, 50, 20])
    header = ",".join(f"q{i}_deg" for i in range(1, 7))
    np.savetxt(folder / "poses.csv", q, delimiter=",", header=header, comments="")
    (folder / "poses.toml").write_text(POSE + 'frame = "unknown"\n')
    dc.simulate(folder / "robot.toml", folder / "poses.csv", output=folder / "vector.csv", noise=0.01, seed=2)
    rows = (folder / "vector.csv").read_text().splitlines()
    columns = rows[0].split(",")
    at = [columns.index(f"r{axis}_deg") for axis in "xyz"]
    cells = [row.split(",") for row in rows[1:]]
    vectors = np.radians([[float(c[k]) for k in at] for c in cells])
    for name, angles in (("turns", _angles(from_vector(vectors))), ("nonsense", -vectors[:, ::-1])):
        for c, own in zip(cells, np.degrees(angles), strict=True):
            for k, angle in zip(at, own, strict=True):
                c[k] = repr(float(angle))
        (folder / f"{name}.csv").write_text("\n".join([rows[0], *map(",".join, cells)]) + "\n")
        (folder / f"{name}.toml").write_text(POSE)
    return folder


def _angles(R: np.ndarray) -> np.ndarray:
    """Roll, pitch and yaw (N, 3) of Rz Ry Rx, by hand."""
    roll, yaw = np.arctan2(R[:, 2, 1], R[:, 2, 2]), np.arctan2(R[:, 1, 0], R[:, 0, 0])
    return np.column_stack([roll, -np.arcsin(R[:, 2, 0]), yaw])


def test_the_order_of_turns_is_that_of_roll_pitch_and_yaw() -> None:
    vectors = np.random.default_rng(1).uniform(-1, 1, (20, 3))
    assert to_vector(from_turns("xyz", _angles(from_vector(vectors)))) == pytest.approx(vectors)


def test_angles_that_are_turns_are_told_and_read(read: Path, tmp_path: Path) -> None:
    """A recording of them is refused, and told what they are; said so, the result is that of rotation vectors."""
    with pytest.raises(InputError, match=r'from pose to pose .* deg if they are angles .*rotation = "xyz"'):
        dc.identify(read / "robot.toml", read / "turns.csv")
    (tmp_path / "turns.csv").write_text((read / "turns.csv").read_text())
    (tmp_path / "turns.toml").write_text(POSE + 'rotation = "xyz"\n')
    both = [
        dc.identify(read / "robot.toml", path)["parameters"] for path in (tmp_path / "turns.csv", read / "vector.csv")
    ]
    values = [[p["value"] for p in parameters] for parameters in both]
    assert values[0] == pytest.approx(values[1], abs=1e-3)


@pytest.mark.walk
def test_rotations_that_tell_nothing_are_told(read: Path) -> None:
    """Positions alone then know the machine: no answer passes over that rotations were read, and not used."""
    found = dc.identify(read / "robot.toml", read / "nonsense.csv")
    assert "told next to nothing" in json.dumps(found["doubts"])
    assert "told next to nothing" in dc.diagnose(read / "robot.toml", read / "nonsense.csv")["summary"]
    assert not dc.identify(read / "robot.toml", read / "vector.csv").get("doubts")


def test_rotations_in_another_frame_than_positions_are_told_by_how_they_stand(read: Path, tmp_path: Path) -> None:
    """Some instruments count angles about axes that stand a quarter of a turn off those of their coordinates."""
    rows = (read / "vector.csv").read_text().splitlines()
    columns, cells = rows[0].split(","), [row.split(",") for row in rows[1:]]
    at = [columns.index(f"{axis}_mm") for axis in "xyz"]
    for own in cells:
        x, y = (own[k] for k in at[:2])
        own[at[0]], own[at[1]] = y, repr(-float(x))
    (tmp_path / "other.csv").write_text("\n".join([rows[0], *map(",".join, cells)]) + "\n")
    (tmp_path / "other.toml").write_text((read / "vector.toml").read_text())
    [doubt] = dc.identify(read / "robot.toml", tmp_path / "other.csv")["doubts"]
    assert "from pose to pose they turn as it does" in doubt
    assert "turned by 90 deg about (0.00, 0.00, 1.00)" in doubt


def test_targets_may_be_turns_too(read: Path, tmp_path: Path) -> None:
    rows = (read / "turns.csv").read_text().splitlines()
    keep = [k for k, name in enumerate(rows[0].split(",")) if name in (*POSITION, *ROTATION)]
    (tmp_path / "t.csv").write_text("\n".join(",".join(row.split(",")[k] for k in keep) for row in rows))
    (tmp_path / "t.toml").write_text('[measurement]\nrotation = "xyz"\n')
    arm = mechanism_of(robot())
    asked = read_recording(tmp_path / "t.csv", arm, need_measured=False, allow_targets=True).targets
    vectors = read_recording(read / "vector.csv", arm).measured[:, 3:]
    assert asked is not None
    assert asked[:, 3:].reshape(-1, 3, 3) == pytest.approx(from_vector(vectors), abs=1e-6)


def test_an_order_of_turns_wants_three(read: Path, tmp_path: Path) -> None:
    (tmp_path / "r.csv").write_text(
        "q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n" + "1,2,3,4,5,6,7,8,9\n"
    )
    (tmp_path / "r.toml").write_text('[measurement]\nrotation = "zyx"\n')
    with pytest.raises(InputError, match="which are not all measured"):
        dc.identify(read / "robot.toml", tmp_path / "r.csv")


def test_a_machine_of_one_model_has_no_rough_stage_to_show(read: Path) -> None:
    """A chain is fitted whole from the start: what is not an encoder offset is not called so."""
    assert dc.identify(read / "robot.toml", read / "vector.csv")["accuracy"].get("rough") is None


@pytest.mark.parametrize(
    ("column", "factor", "told"),
    [
        (
            "rx_deg ry_deg rz_deg",
            np.pi / 180,
            r"by no more than 0\.0\d+ deg if they are rotation vectors in rad .*rx_rad",
        ),
        ("rx_deg ry_deg rz_deg", -1.0, r"by no more than 0\.0\d+ deg if they are the inverses, .* from the platform"),
        ("q6_deg", -1.0, r"by no more than 0\.0\d+ deg if (.*, or if )?joint 6 counts the other way"),
    ],
)
def test_rotations_tell_what_positions_do_not(
    column: str, factor: float, told: str, read: Path, tmp_path: Path
) -> None:
    """Vectors in radians, those of the way back, and a joint about an axis through the point that was measured."""
    rows = [row.split(",") for row in (read / "vector.csv").read_text().splitlines()]
    for k in map(rows[0].index, column.split()):
        for row in rows[1:]:
            row[k] = repr(factor * float(row[k]))
    (tmp_path / "read.csv").write_text("\n".join(map(",".join, rows)) + "\n")
    (tmp_path / "read.toml").write_text((read / "vector.toml").read_text())
    with pytest.raises(InputError, match=told):
        dc.identify(read / "robot.toml", tmp_path / "read.csv")
