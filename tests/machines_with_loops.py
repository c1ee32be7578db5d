"""Machines that close loops, each with source errors, masses and states within its reach."""

from __future__ import annotations

import dataclasses
from functools import cache
from importlib import resources
from pathlib import Path

import numpy as np

from deltacal_gen.files.robot import read_robot, robot_from_dict
from deltacal_gen.machine.registry import load_mechanism, mechanism_of
from deltacal_gen.machine.values import Masses, Robot
from tests.every_effect import PRINTER, machines

PLANAR = ("diamond", "planar_parallelogram")
GRAVITY = dict.fromkeys(PLANAR, (0.0, -9.81, 0.0))  # where it is not along z
REACH = {  # centre and half widths of a part of the workspace [mm]
    "delta": ((0.0, 0.0, -853.0), (250.0, 250.0, 100.0)),
    "diamond": ((0.0, -710.0, 0.0), (200.0, 60.0, 0.0)),
    "hexapod": ((0.0, 0.0, 300.0), (30.0, 30.0, 20.0)),
    "linear_delta": ((0.0, 0.0, 60.0), (50.0, 50.0, 40.0)),
    "planar_parallelogram": ((0.0, -930.0, 0.0), (300.0, 0.0, 0.0)),
    "robotennis": ((0.0, 0.0, 900.0), (200.0, 200.0, 60.0)),
}
REACH["complete_delta"] = REACH["delta"]
MASSES = Masses(proximal=1.2, proximal_com=0.4, distal_rod=0.15, platform=0.8, carriage=0.35)


@cache
def machine(name: str) -> Robot:
    """Return a machine of a mechanism that has limbs, with errors and a tool off its platform's centre."""
    if name in ("delta", "complete_delta"):
        robot = machines()[0]
    elif name == "linear_delta":
        robot = robot_from_dict(PRINTER)
    else:
        robot = read_robot(Path(str(resources.files("deltacal_gen") / "examples" / name / "robot.toml")))
    masses = dataclasses.replace(MASSES, gravity=GRAVITY.get(name, (0.0, 0.0, -9.81)))
    rng = np.random.default_rng(3)
    errors = {p.name: 0.3 * p.typical * float(rng.standard_normal()) for p in load_mechanism(name).parameters}
    tool = np.array([20.0, -15.0, 0.0 if name in PLANAR else -30.0])
    return dataclasses.replace(robot, mechanism=name, masses=masses, errors=errors, tool=tool)


def states(robot: Robot, n: int, seed: int = 0) -> np.ndarray:
    """Return joints, velocities and accelerations (3, n, n_q) within reach."""
    mechanism, rng = mechanism_of(robot), np.random.default_rng(seed)
    centre, half = map(np.array, REACH[robot.mechanism])
    q, _, status = mechanism.inverse(centre + rng.uniform(-1, 1, (n, 3)) * half, robot.tool, mechanism.rows(robot))
    assert not status.any()
    size = 1.0 if mechanism.joint_unit == "rad" else 200.0
    return np.stack([q, 3 * size * rng.standard_normal(q.shape), 40 * size * rng.standard_normal(q.shape)])
