"""Recordings in motion, simulated: torques of bodies with the friction of a truth, and what is found of them."""

from __future__ import annotations

import copy
import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import read_robot, robot_from_dict, robot_to_toml
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.motion import kinds
from tests.support.every_effect import MASSES
from tests.support.motion_recordings import DEG, LINKS, NOISE, STEP, named, planned, robot, trajectory, usual, written
from tests.support.prototype import PROTOTYPE


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("usual"), usual)


@pytest.mark.walk
def test_readings_that_come_late_are_told_with_their_delay(tmp_path: Path, commanded: Path) -> None:
    """Of joint 2 alone, by less than a sample and by more; what a model with a delay predicts comes as late."""
    second = np.array([0.0, 1.0, 0.0])
    late = written(tmp_path, usual, seed=6, delay=0.0137 * second)
    found = dc.diagnose(tmp_path / "robot.toml", late)
    assert named(found) == {"coulomb_friction": [1, 2], "viscous_friction": [1, 3], "latency": [2]}
    (delay,) = found["effects"][-1]["parameters"]
    assert (delay["name"], delay["unit"]) == ("delay", "s")
    assert abs(delay["value"] - 0.0137) < 4 * delay["std"] < 0.004
    assert all(v < 1.15 * NOISE for v in dc.validate(found, late)["rms_by_joint"])
    (tmp_path / "truth.toml").write_text('[[effects]]\nname = "latency"\nlimb = 1\ndelay = 0.02\n')
    plain: Any = dc.simulate(commanded.with_name("robot.toml"), commanded)
    done: Any = dc.simulate(commanded.with_name("robot.toml"), commanded, truth=tmp_path / "truth.toml")
    assert done.readings[2:, 0] == pytest.approx(plain.readings[:-2, 0])
    assert done.readings[:, 1:] == pytest.approx(plain.readings[:, 1:])
    assert found["effects"][-1]["title"] == "readings that come late"


@pytest.mark.walk
@pytest.mark.parametrize("stated", [True, False])
@pytest.mark.parametrize("coulomb", [0.0, 4.0])
def test_what_rounding_leaves_is_nothing(tmp_path: Path, stated: bool, coulomb: float) -> None:
    """Simulated without noise: no effect, and no open question, of what is a ten-millionth of what drives give."""
    truth = f'[[effects]]\nname = "coulomb_friction"\nlimbs = [2]\ncoulomb = {coulomb}\n'
    path, made = planned(tmp_path, truth, runs=3, seconds=6.0), tmp_path / "made.csv"
    dc.simulate(tmp_path / "robot.toml", path, output=made, truth=tmp_path / "truth.toml")
    if not stated:
        (tmp_path / "robot.toml").write_text(robot_to_toml(robot()))
    found = dc.diagnose(tmp_path / "robot.toml", made)
    assert named(found) == ({"coulomb_friction": [2]} if coulomb else {})
    assert (found["unexplained"], found["laws"], "would drive" in found["summary"]) == ([], [], False)


def test_a_joint_that_stands_has_no_dry_friction(tmp_path: Path) -> None:
    """The sign of a velocity that is what rounding leaves would make its drive chatter."""
    path = planned(tmp_path, '[[effects]]\nname = "coulomb_friction"\ncoulomb = 5.0\n', runs=1, seconds=4.0)
    head, *rows = path.read_text().splitlines()
    cells = [row.split(",") for row in rows]
    path.write_text("\n".join([head, *(",".join([*row[:4], "12.345678", row[5]]) for row in cells)]) + "\n")
    plain: Any = dc.simulate(tmp_path / "robot.toml", path)
    done: Any = dc.simulate(tmp_path / "robot.toml", path, truth=tmp_path / "truth.toml")
    assert np.abs(np.abs(done.readings - plain.readings) - [5.0, 5.0, 0.0]).max() < 1e-9


@pytest.mark.walk
def test_readings_that_come_early_are_told_so(tmp_path: Path) -> None:
    """Where a controller filters the joints, their drives are ahead of what it writes."""
    found = dc.diagnose(tmp_path / "robot.toml", written(tmp_path, usual, seed=6, delay=(0.0, -0.03, 0.0)))
    assert found["effects"][-1]["title"].startswith("readings that come early")
    assert found["effects"][-1]["parameters"][0]["value"] < 0


TRUTH = """
[parameters]
m_3 = 0.5

[[effects]]
name = "coulomb_friction"
limbs = [1, 3]
coulomb = 2.0

[[effects]]
name = "stribeck_friction"
limb = 3
stribeck = 1.0
velocity = 4.0
"""


@pytest.fixture
def commanded(tmp_path: Path) -> Path:
    """Write a trajectory with its derivatives, and the robot with its bodies; return the trajectory's path."""
    states = trajectory(5.0, 3) / DEG
    names = [
        f"{word}{i}_{unit}" for word, unit in (("q", "deg"), ("qd", "deg_s"), ("qdd", "deg_s2")) for i in (1, 2, 3)
    ]
    table = np.column_stack([np.arange(states.shape[1]) * STEP, *states])
    lines = [",".join(["time_s", *names]), *(",".join(map(repr, row)) for row in table.tolist())]
    path = tmp_path / "trajectory.csv"
    path.write_text("\n".join(lines) + "\n")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\n[motion]\nderivatives = "recorded"\n')
    bodied = [link | {"inertia": [2e4, 3e4, 4e4, 1e3, 2e3, 3e3]} for link in LINKS]
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot(bodied)))
    (tmp_path / "truth.toml").write_text(TRUTH)
    return path


def test_a_simulation_gives_the_torques_of_bodies_and_truth(commanded: Path) -> None:
    folder = commanded.parent
    done: Any = dc.simulate(folder / "robot.toml", commanded, output=folder / "made.csv", truth=folder / "truth.toml")
    states = trajectory(5.0, 3)
    machine = dynamics_of(read_robot(folder / "robot.toml"))
    inertia = machine.stated()
    inertia[20] += 0.5
    wanted = machine.torque(states, inertia) / 1000
    way, speed = np.sign(states[1]), states[1] / DEG
    wanted[:, 0] += 2.0 * way[:, 0]
    wanted[:, 2] += way[:, 2] * (2.0 + np.exp(-((speed[:, 2] / 4.0) ** 2)))
    assert done.readings == pytest.approx(wanted, abs=1e-9)
    again = kinds.in_motion(folder / "made.csv")
    assert again is not None
    assert again.read(robot()).readings == pytest.approx(wanted, abs=1e-9)
    noisy: Any = dc.simulate(folder / "robot.toml", commanded, output=folder / "noisy.csv", noise=0.1, seed=4)
    assert np.std(noisy.readings - dc.simulate(folder / "robot.toml", commanded).readings) == pytest.approx(
        0.1, rel=0.1
    )
    assert "sigma_Nm = 0.1" in (folder / "noisy.toml").read_text()


@pytest.mark.parametrize(
    ("before", "after", "words"),
    [
        ("m_3", "m_4", "no link has an inertial parameter 'm_4'"),
        ("coulomb_friction", "coulomb", "there is no effect 'coulomb' on what drives give. Did you mean"),
        ("coulomb = 2.0", "", "coulomb_friction needs a number for 'coulomb'"),
        ("limb = 3", "limb = 7", "joints are counted from 1 to 3"),
        ("stribeck = 1.0", "stribeck = 1.0\nspeed = 2.0", "stribeck_friction has no parameter 'speed'"),
    ],
)
def test_a_truth_that_cannot_be_is_refused(commanded: Path, before: str, after: str, words: str) -> None:
    truth = commanded.with_name("truth.toml")
    truth.write_text(TRUTH.replace(before, after, 1))
    with pytest.raises(InputError) as error:
        dc.simulate(commanded.with_name("robot.toml"), commanded, truth=truth)
    assert words in str(error.value)


def test_a_body_without_a_mass_cannot_be_simulated(recorded: Path, commanded: Path) -> None:
    bare = [{k: v for k, v in link.items() if k not in ("mass", "com")} for link in LINKS]
    commanded.with_name("robot.toml").write_text(robot_to_toml(robot(bare)))
    with pytest.raises(InputError, match="joint 1 has no mass"):
        dc.simulate(commanded.with_name("robot.toml"), commanded)


def test_a_delta_s_friction_is_found_through_its_loops(tmp_path: Path) -> None:
    machine, rng = robot_from_dict(copy.deepcopy(PROTOTYPE)), np.random.default_rng(6)
    machine = dataclasses.replace(machine, masses=MASSES)
    own, rows = dynamics_of(machine), [["run", "time_s", "q1_deg", "q2_deg", "q3_deg", "tau1_Nm", "tau2_Nm", "tau3_Nm"]]
    for run in range(3):
        states = trajectory(6.0, 40 + run)
        tau = own.torque(states, own.stated()) / 1000 + 0.02 * rng.standard_normal(states[0].shape)
        tau[:, 1] += 1.5 * np.sign(states[1][:, 1])
        table = np.column_stack([np.full(len(tau), run), np.arange(len(tau)) * STEP, states[0] / DEG, tau])
        rows += [[str(int(row[0])), *(f"{v:.6f}" for v in row[1:])] for row in table]
    path = tmp_path / "recording.csv"
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\nsigma_Nm = 0.02\n')
    (tmp_path / "robot.toml").write_text(robot_to_toml(machine))
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert (found["verdict"], named(found)) == ("missing_physics", {"coulomb_friction": [2]})
    (coulomb,) = found["effects"][0]["parameters"]
    assert abs(coulomb["value"] - 1.5) < 4 * coulomb["std"]
    assert found["baseline"]["model"] == "delta/rigid"
    assert all(v < 1.1 * 0.02 for v in found["final"]["heldout_rms_by_joint"])
