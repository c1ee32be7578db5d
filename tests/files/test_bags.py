"""Bags of ROS and files of MCAP: joints and readings with clocks of their own become rows that belong together."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.samples import Samples, join
from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.machine.rotation import from_vector
from tests.support.bags import LOOKS, NAMES, START, TIMES, Motion, mcap, seen, way
from tests.support.commands import Run

pytest.importorskip("rosbags")
pytest.importorskip("mcap_ros2")


def staircase(t: np.ndarray) -> np.ndarray:
    """Return joints (N, 3) [rad] that move for half of each second and stand still for the rest."""
    step = np.floor(t) + np.clip(2 * (t % 1), 0, 1)
    return np.column_stack([0.1 * step, -0.05 * step, 0.02 * step**2])


def ros2(folder: Path, motion: Motion, *, kind: str = "PointStamped", damage: str = "") -> Path:
    """Write a bag of ROS 2, the order of the joints' names another in every second message; return its folder."""
    from rosbags.rosbag2 import Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE)
    types: dict[str, Any] = dict(store.types)

    def header(t: float) -> Any:
        stamp = 0.0 if damage == "no stamps" else START + t
        return types["std_msgs/msg/Header"](
            stamp=types["builtin_interfaces/msg/Time"](sec=int(stamp), nanosec=round(stamp % 1 * 1e9)), frame_id=""
        )

    with Writer(folder / "bag", version=9) as bag:
        states = bag.add_connection("/joint_states", "sensor_msgs/msg/JointState", typestore=store)
        if damage == "two of them":
            bag.add_connection("/other_states", "sensor_msgs/msg/JointState", typestore=store)
        looked = bag.add_connection("/tracker", f"geometry_msgs/msg/{kind}", typestore=store)
        for k, (t, q) in enumerate(zip(TIMES, motion(TIMES), strict=True)):
            if damage == "a gap" and 2 < t < 3:
                continue
            order = [2, 0, 1] if k % 2 else [0, 1, 2]
            stamp = TIMES[k - 1] if damage == "repeats" and k % 50 == 7 else t
            state = types["sensor_msgs/msg/JointState"](
                header=header(stamp), name=[NAMES[j] for j in order], position=q[order], velocity=q * 0, effort=q * 0
            )
            raw = store.serialize_cdr(state, "sensor_msgs/msg/JointState")
            bag.write(states, int((START + t) * 1e9), raw)
        for t, xyz in zip(LOOKS, seen(motion(LOOKS)), strict=True):
            point = types["geometry_msgs/msg/Point"](*xyz)
            if kind == "PointStamped":
                message = types["geometry_msgs/msg/PointStamped"](header=header(t), point=point)
            else:
                half = 0.2  # rad: turned by 0.4 rad about z; the sign of a quaternion says nothing
                turn = types["geometry_msgs/msg/Quaternion"](x=0.0, y=0.0, z=-np.sin(half), w=-np.cos(half))
                pose = types["geometry_msgs/msg/Pose"](position=point, orientation=turn)
                message = types["geometry_msgs/msg/PoseStamped"](header=header(t), pose=pose)
            bag.write(looked, int((START + t) * 1e9), store.serialize_cdr(message, f"geometry_msgs/msg/{kind}"))
    return folder / "bag"


@pytest.mark.parametrize("form", [ros2, mcap])
def test_readings_in_motion_get_the_joints_of_their_moment(tmp_path: Path, form: Callable[..., Path]) -> None:
    found = dc.import_bag(form(tmp_path, way), output=tmp_path / "out")
    recording = read_recording(tmp_path / "out" / "recording.csv", load_mechanism("delta"))
    assert recording.n_rows == len(LOOKS)
    assert recording.joints == pytest.approx(way(LOOKS), abs=1e-5)  # straight between samples 10 ms apart
    assert recording.measured == pytest.approx(1000 * seen(way(LOOKS)), abs=1e-9)
    assert recording.time_s == pytest.approx(LOOKS - LOOKS[0], abs=1e-6)
    assert "joints 1 to 3 are shoulder, elbow, wrist" in found.warnings
    assert any("taken to be in rad" in words for words in found.warnings)


def test_a_row_is_a_standstill_where_the_joints_stand_still(tmp_path: Path) -> None:
    bag = ros2(tmp_path, staircase)
    found = dc.import_bag(bag)
    recording = found.recordings["recording"]
    assert recording.n_rows == 6
    assert recording.joints == pytest.approx(staircase(np.arange(6) + 0.75), abs=1e-9)
    assert recording.measured == pytest.approx(1000 * seen(recording.joints), abs=1e-6)
    assert any("stand still 6 times" in words for words in found.warnings)
    assert dc.import_bag(bag, moving=True).recordings["recording"].n_rows == len(LOOKS)


def test_poses_come_as_rotation_vectors(tmp_path: Path) -> None:
    recording = dc.import_bag(ros2(tmp_path, way, kind="PoseStamped")).recordings["recording"]
    assert recording.kind == "pose"
    assert from_vector(recording.measured[:, 3:])[:, :2, 0] == pytest.approx(
        np.tile([np.cos(0.4), np.sin(0.4)], (len(LOOKS), 1))
    )


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        ("repeats", "12 of 600 samples repeat a stamp"),
        ("a gap", "1 gap, the longest 1 s, where a sample comes every 0.01 s"),
        ("no stamps", "messages without a stamp have the time at which they were logged"),
    ],
)
def test_what_is_wrong_with_a_clock_is_told(tmp_path: Path, damage: str, words: str) -> None:
    found = dc.import_bag(ros2(tmp_path, way, damage=damage))
    assert any(words in told for told in found.warnings), found.warnings
    recording = found.recordings["recording"]
    assert recording.time_s is not None
    assert recording.joints == pytest.approx(way(recording.time_s + LOOKS[0]), abs=1e-4)
    if damage == "a gap":
        assert any("have no joints beside them" in told for told in found.warnings)


def test_any_message_by_a_mapping(tmp_path: Path) -> None:
    (tmp_path / "map.toml").write_text(
        '[joints]\nnames = ["wrist", "elbow", "shoulder"]\n'
        '[readings]\ntopic = "/tracker"\nfields = ["point.y", "point.x", "point.z"]\nunit = "mm"\n'
    )
    recording = dc.import_bag(ros2(tmp_path, way), mapping=tmp_path / "map.toml").recordings["recording"]
    assert recording.joints == pytest.approx(way(LOOKS)[:, ::-1], abs=1e-5)
    assert recording.measured == pytest.approx(seen(way(LOOKS))[:, [1, 0, 2]])
    (tmp_path / "map.toml").write_text('[joints]\ntopic = "/joint_states"\nfields = ["position[0]", "position[9]"]\n')
    with pytest.raises(InputError, match="not as the mapping says"):
        dc.import_bag(tmp_path / "bag", mapping=tmp_path / "map.toml")
    (tmp_path / "map.toml").write_text('[joints]\nfields = ["__import__(os)"]\n')
    with pytest.raises(InputError, match=r"map.toml, line 2"):
        dc.import_bag(tmp_path / "bag", mapping=tmp_path / "map.toml")


def test_a_joint_that_slides_is_counted_in_metres(tmp_path: Path) -> None:
    links = ('"revolute"', '"revolute"', '"prismatic"')
    each = "".join(f"[[joint]]\nkind = {k}\na = 100.0\nalpha = 0.0\nd = 0.0\ntheta = 0.0\n" for k in links)
    (tmp_path / "robot.toml").write_text(f'[robot]\nname = "arm"\nmechanism = "serial"\n{each}')
    recording = dc.import_bag(ros2(tmp_path, way), tmp_path / "robot.toml").recordings["recording"]
    assert recording.joint_unit == "rad,rad,mm"
    assert recording.joints == pytest.approx(way(LOOKS) * [1, 1, 1000], abs=1e-2)
    (tmp_path / "robot.toml").write_text(f'[robot]\nname = "arm"\nmechanism = "serial"\n{each[: len(each) // 3]}')
    with pytest.raises(InputError, match="bag: the file has 3 joints, the robot 1"):
        dc.import_bag(tmp_path / "bag", tmp_path / "robot.toml")


def test_what_could_be_meant_is_asked_for(run: Run, tmp_path: Path) -> None:
    bag = ros2(tmp_path, way, damage="two of them")
    code, _, said = run("import", "bag", bag, "-o", tmp_path / "out")
    assert code == 3
    assert "several topics could be the joints. Name one, --joints TOPIC; there are /joint_states (JointState)" in said
    assert run("import", "bag", bag, "--joints", "/joint_states", "-o", tmp_path / "out")[0] == 0
    assert run("import", "bag", bag, "--joints", "/nothing", "-o", tmp_path / "out")[0] == 3
    assert run("import", "points", bag, bag, "--joints", "/joint_states", "-o", tmp_path / "out")[0] == 2


@pytest.mark.parametrize("name", ["x.mcap", "x.bag", "folder"])
def test_what_is_no_bag_is_said(tmp_path: Path, name: str) -> None:
    if name == "folder":
        (tmp_path / name).mkdir()
    else:
        (tmp_path / name).write_bytes(b"no bag at all" * 99)
    with pytest.raises(InputError, match="the bag cannot be read"):
        dc.import_bag(tmp_path / name)
    with pytest.raises(InputError, match="no such file"):
        dc.import_bag(tmp_path / "nothing.mcap")


def test_clocks_that_do_not_meet_are_said_and_an_offset_brings_them_together() -> None:
    joints = Samples("j", TIMES, way(TIMES))
    far = Samples("r", TIMES + 1e6, way(TIMES))
    with pytest.raises(InputError, match="no reading of r was taken while j was logged"):
        join(joints, far, moving=False, path=Path("x"))
    assert len(join(joints, Samples("r", far.time - 1e6, far.values), moving=True, path=Path("x")).time) == len(TIMES)
