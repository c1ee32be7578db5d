"""Commands along a trajectory: the torque that was identified, ramped where friction is not known."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import UsageError
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.motion.feedforward import FeedForward
from tests.every_effect import machines

COULOMB, VISCOUS = 0.4, 0.004  # Nm, Nm s/deg
TRUTH = f"""
[[effects]]
name = "coulomb_friction"
coulomb = {COULOMB}
[[effects]]
name = "viscous_friction"
viscous = {VISCOUS}
"""
MOTION = '[measurement]\nkind = "torque"\n'
PLANNED = MOTION + '[motion]\nderivatives = "recorded"\n'


@pytest.fixture(scope="module")
def known(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a Delta with errors, and the diagnosis of its friction."""
    folder = tmp_path_factory.mktemp("feedforward")
    robot = dataclasses.replace(machines()[0], joint_sign=np.array([1.0, -1.0, 1.0]))
    robot = dataclasses.replace(robot, limits={"tau1_Nm": (-1.0, 1.0)})
    (folder / "robot.toml").write_text(robot_to_toml(robot))
    (folder / "truth.toml").write_text(TRUTH)
    t, rng, rows = np.arange(0, 8, 0.01), np.random.default_rng(2), ["run,time_s,q1_deg,q2_deg,q3_deg"]
    for run in (1, 2, 3):
        q = np.zeros((len(t), 3))
        for k in range(1, 6):
            q += rng.uniform(2, 9, 3) / k * np.sin(2 * np.pi * 0.3 * k * t[:, None] + rng.uniform(0, 6, 3))
        q = (q - [8.0, 8.0, 8.0]) * robot.joint_sign
        rows += [f"{run},{time:.2f},{a:.9f},{b:.9f},{c:.9f}" for time, (a, b, c) in zip(t, q, strict=True)]
    (folder / "planned.csv").write_text("\n".join(rows))
    (folder / "planned.toml").write_text(MOTION)
    recording = folder / "recording.csv"
    dc.simulate(folder / "robot.toml", folder / "planned.csv", recording, truth=folder / "truth.toml", noise=0.01)
    dc.diagnose(folder / "robot.toml", recording, folder / "diagnosis.json")
    return folder


def along(folder: Path, states: np.ndarray, name: str = "states") -> FeedForward:
    """Return commands at states (3, N, 3) as they are [deg, s]."""
    head = [f"{q}{i}{unit}" for q, unit in (("q", "_deg"), ("qd", "_deg_s"), ("qdd", "_deg_s2")) for i in (1, 2, 3)]
    table = np.column_stack([0.01 * np.arange(states.shape[1]), *(s for s in states)])
    text = [",".join(["time_s", *head]), *(",".join(f"{v!r}" for v in row) for row in table.tolist())]
    (folder / f"{name}.csv").write_text("\n".join(text))
    (folder / f"{name}.toml").write_text(PLANNED)
    return dc.feed_forward(folder / "diagnosis.json", folder / f"{name}.csv")


def at_speeds(speeds: np.ndarray) -> np.ndarray:
    """Return states at one pose and some speeds of joint 1."""
    states = np.zeros((3, len(speeds), 3))
    states[0] = [-8.0, 8.0, -8.0]
    states[1, :, 0] = speeds
    return states


def test_in_motion_it_is_what_is_predicted(known: Path) -> None:
    found = dc.feed_forward(known / "diagnosis.json", known / "planned.csv")
    predicted: Any = dc.predict(known / "diagnosis.json", known / "planned.csv")
    moving = np.isfinite(predicted.readings)
    assert moving.mean() > 0.8
    assert found.torque[moving] == pytest.approx(predicted.readings[moving], abs=1e-9)
    assert np.isfinite(found.torque).all()


def test_near_rest_friction_goes_straight_from_side_to_side(known: Path) -> None:
    edge = float(np.degrees(dc.read_answer(known / "diagnosis.json").joints[0].at_rest_below))
    speeds = np.array([-edge, -edge / 2, 0.0, edge / 2, edge])
    found = along(known, at_speeds(speeds))
    steps = np.diff(found.torque[:, 0])
    assert steps == pytest.approx(np.full(4, steps.mean()), rel=1e-4)  # but what turns pulls outwards
    assert 4 * steps.mean() == pytest.approx(2 * COULOMB + 2 * VISCOUS * edge, rel=0.05)
    assert found.ramped.tolist() == [3, 5, 5]


def test_a_joint_that_turns_back_meets_no_jump(known: Path) -> None:
    """No two speeds a hundredth of the ramp apart ask for torques that differ by more than their part of it."""
    edge = float(np.degrees(dc.read_answer(known / "diagnosis.json").joints[0].at_rest_below))
    torque = along(known, at_speeds(np.linspace(-3 * edge, 3 * edge, 601))).torque[:, 0]
    assert np.abs(np.diff(torque)).max() < 1.1 * (2 * COULOMB + 2 * VISCOUS * edge) / 200


def test_targets_are_brought_to_joints_by_the_geometry_of_the_result(known: Path, tmp_path: Path) -> None:
    t = np.arange(0, 1, 0.01)
    points = np.column_stack([100 * t, -50 * t**2, -880 + 20 * np.sin(t)])
    rows = [",".join(f"{v!r}" for v in (time, *p)) for time, p in zip(t.tolist(), points.tolist(), strict=True)]
    (tmp_path / "line.csv").write_text("\n".join(["time_s,x_mm,y_mm,z_mm", *rows]))
    (tmp_path / "line.toml").write_text(MOTION)
    found = dc.feed_forward(known / "diagnosis.json", tmp_path / "line.csv", tmp_path / "commands.csv")
    robot = dc.read_robot(known / "robot.toml")
    mechanism = mechanism_of(robot)
    assert robot.errors
    x = mechanism.positions(found.given.joints * robot.joint_sign, robot.tool, mechanism.rows(robot))
    assert x == pytest.approx(points, abs=1e-6)
    head = (tmp_path / "commands.csv").read_text().partition("\n")[0].split(",")
    assert head == [
        "time_s",
        *(f"q{i}_deg" for i in (1, 2, 3)),
        *(f"qd{i}_deg_s" for i in (1, 2, 3)),
        *(f"qdd{i}_deg_s2" for i in (1, 2, 3)),
        *(f"tau{i}_Nm" for i in (1, 2, 3)),
    ]


def test_limits_of_the_robot_file_are_counted(known: Path) -> None:
    told: list[str] = []
    found = dc.feed_forward(known / "diagnosis.json", known / "planned.csv", tell=told.append)
    count = int((np.abs(found.torque[:, 0]) > 1.0).sum())
    assert count > 0
    assert found.beyond == {"tau1_Nm": count}
    assert f"{count} of {len(found.torque)} samples lie beyond [limits] tau1_Nm" in told


def test_the_command_writes_what_the_function_does(known: Path, tmp_path: Path, run: Callable[..., Any]) -> None:
    out = tmp_path / "commands.csv"
    code, shown, _ = run("compensate", known / "diagnosis.json", known / "planned.csv", "--trajectory", "-o", out)
    assert code == 0
    assert "samples with joints and torques written" in " ".join(shown.split())
    found = dc.feed_forward(known / "diagnosis.json", known / "planned.csv")
    table = np.genfromtxt(out, delimiter=",", names=True)
    assert table["tau2_Nm"] == pytest.approx(found.torque[:, 1], abs=1e-12)
    assert run("compensate", known / "diagnosis.json", "--trajectory")[0] == 2


def test_a_machine_at_rest_has_no_torques(known: Path) -> None:
    with pytest.raises(UsageError, match="a result of a recording in motion"):
        dc.feed_forward(_result(known), known / "planned.csv")


def _result(folder: Path) -> Path:
    """Return an identified machine at rest."""
    rows = ["x_mm,y_mm,z_mm", *(f"{100 * np.cos(k)},{100 * np.sin(k)},{-800 - 10 * k}" for k in range(12))]
    (folder / "poses.csv").write_text("\n".join(rows))
    dc.simulate(folder / "robot.toml", folder / "poses.csv", folder / "rest.csv", noise=0.01)
    dc.identify(folder / "robot.toml", folder / "rest.csv", model="delta/3", output=folder / "rest.json")
    return folder / "rest.json"
