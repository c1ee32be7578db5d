"""A chain whose joints turn and slide: from its file to a diagnosis and to corrected commands."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import read_robot, robot_to_dict, robot_to_toml
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.units import DEG
from deltacal_gen.use.compensation import Compensator
from tests.support.open_chains import SCARA, robot
from tests.support.prototype import calibrated

FACTORS = np.array([DEG, DEG, 1.0, DEG])
LOW, HIGH = np.array([-130.0, -140.0, 0.0, -170.0]), np.array([130.0, 140.0, 180.0, 170.0])
TRUTH = """
[parameters]
a_1 = 0.3
theta_2 = 0.12
alpha_1 = 0.04
d_3 = 0.2
tx = 0.4

[[effects]]
name = "backlash"
limbs = [2, 3]
width = [0.05, 0.12]
"""


def scara() -> Any:
    return robot(SCARA, joints={"limits": np.column_stack([LOW, HIGH]).tolist()}, masses={})


@pytest.fixture(scope="module")
def cell(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A SCARA with errors and with play in a turning and in the sliding joint, read by a tracker."""
    folder, rng = tmp_path_factory.mktemp("cell"), np.random.default_rng(8)
    (folder / "robot.toml").write_text(robot_to_toml(scara()))
    (folder / "truth.toml").write_text(TRUTH)
    q = LOW + (HIGH - LOW) * rng.random((160, 4))
    header = "q1_deg,q2_deg,q3_mm,q4_deg," + ",".join(f"approach{i}" for i in range(1, 5))
    table = np.hstack([q, rng.choice([-1, 1], (160, 4))])
    np.savetxt(folder / "poses.csv", table, delimiter=",", header=header, comments="")
    (folder / "poses.toml").write_text('[measurement]\nkind = "pose"\nframe = "unknown"\nsigma_deg = 0.002\n')
    how = {"truth": folder / "truth.toml", "noise": 0.01, "seed": 3}
    dc.simulate(folder / "robot.toml", folder / "poses.csv", output=folder / "read.csv", **how)
    return folder


def test_its_file_and_its_recording_count_each_joint_in_its_own_unit(cell: Path) -> None:
    again = read_robot(cell / "robot.toml")
    assert robot_to_dict(again) == robot_to_dict(scara())
    assert again.joint_limits == pytest.approx(np.column_stack([LOW, HIGH]) * FACTORS[:, None])
    read = read_recording(cell / "read.csv", mechanism_of(again))
    assert np.abs(read.joints / FACTORS - np.loadtxt(cell / "poses.csv", delimiter=",", skiprows=1)[:, :4]).max() < 1e-9
    (cell / "wrong.csv").write_text((cell / "read.csv").read_text().replace("q3_mm", "q3_deg"))
    with pytest.raises(InputError, match="q3_mm"):
        read_recording(cell / "wrong.csv", mechanism_of(again))


@pytest.mark.walk
def test_play_is_found_in_degrees_where_it_turns_and_in_mm_where_it_slides(cell: Path) -> None:
    found = dc.diagnose(
        cell / "robot.toml", cell / "read.csv", output=cell / "diagnosis.json", report=cell / "page.html"
    )
    assert found["verdict"] == "missing_physics"
    (effect,) = found["effects"]
    assert (effect["name"], effect["limbs"]) == ("backlash", [2, 3])
    widths = {p["limb"]: (p["value"], p["std"], p["unit"]) for p in effect["parameters"]}
    for joint, true, unit in ((2, 0.05, "deg"), (3, 0.12, "mm")):
        value, std, stated = widths[joint]
        assert stated == unit
        assert abs(value - true) < 4 * std
    assert found["final"]["train_rms_mm"] == pytest.approx(0.01, rel=0.1)
    dc.predict(cell / "diagnosis.json", cell / "read.csv", output=cell / "predicted.csv")
    predicted, read = (np.genfromtxt(cell / f, delimiter=",", names=True) for f in ("predicted.csv", "read.csv"))
    assert np.sqrt(np.mean([(predicted[a] - read[a]) ** 2 for a in ("x_mm", "y_mm", "z_mm")])) < 0.012
    corrected = dc.compensate(cell / "diagnosis.json", cell / "poses.csv")
    q = np.loadtxt(cell / "poses.csv", delimiter=",", skiprows=1)[:, :4]
    assert 0.02 < np.abs(corrected - q)[:, 2].max() < 5


def test_four_joints_meet_the_position_and_turn_as_far_as_they_can(cell: Path) -> None:
    drawn, told = scara(), []
    drawn.errors.update({"a_1": 0.3, "alpha_1": 0.1 * DEG, "theta_2": 0.2 * DEG, "d_3": 0.2, "theta_4": 0.1 * DEG})
    result = calibrated(drawn)
    rows = (cell / "poses.csv").read_text().splitlines()
    inside = [r for r in rows[1:] if abs(float(r.split(",")[1])) < 120 and 10 < float(r.split(",")[2]) < 170]
    (cell / "program.csv").write_text("\n".join([rows[0], *inside]) + "\n")
    q = np.array([[float(v) for v in r.split(",")[:4]] for r in inside])
    joints = dc.compensate(result, cell / "program.csv", tell=told.append)
    wanted = Compensator(scara()).pose(q * FACTORS)[0]
    missed = Compensator(drawn).missed(joints * FACTORS, wanted)
    assert np.abs(missed[:, :3]).max() < 1e-8
    assert np.abs(missed[:, 5]).max() < 1e-5  # about its own axis the tool is turned as wanted
    assert any("fewer than six joints" in words for words in told)


def test_joints_are_planned_within_limits_of_both_kinds(cell: Path) -> None:
    found = dc.plan(cell / "robot.toml", model="serial/dh", output=cell / "plan.csv", kind="pose")
    joints = np.array([pose["joints"] for pose in found["poses"]])
    assert ((joints >= LOW) & (joints <= HIGH)).all()
    assert found["rank"][-1] == len(found["parameters"])
    assert (cell / "plan.csv").read_text().startswith("pose,q1_deg,q2_deg,q3_mm,q4_deg,x_mm")
