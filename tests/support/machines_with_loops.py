"""Machines that close loops, each with source errors, masses and states within its reach."""

from __future__ import annotations

import dataclasses
from functools import cache

import numpy as np

from deltacal_gen.files.robot import read_robot, robot_from_dict
from deltacal_gen.identification.accuracy import workspace_of
from deltacal_gen.machine.dynamics import known
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from deltacal_gen.machine.values import Masses, Robot
from tests.support.drawn import example_of
from tests.support.every_effect import PRINTER, machines

NAMES = tuple(name for name in mechanism_names() if name in known() and not load_mechanism(name).many_ways)
INNER = 0.6  # of the box about a workspace: within the cylinder too
MASSES = Masses(proximal=1.2, proximal_com=0.4, distal_rod=0.15, platform=0.8, carriage=0.35)


@cache
def machine(name: str) -> Robot:
    """Return a machine of a mechanism that has limbs, with errors and a tool off its platform's centre."""
    if name in ("delta", "complete_delta"):
        robot = machines()[0]
    elif name == "linear_delta":
        robot = robot_from_dict(PRINTER)
    else:
        robot = read_robot(example_of(name) / "robot.toml")
    mechanism, rng = load_mechanism(name), np.random.default_rng(3)
    flat = len(mechanism.axes) < 3
    masses = dataclasses.replace(MASSES, gravity=(0.0, -9.81, 0.0) if flat else (0.0, 0.0, -9.81))
    errors = {p.name: 0.3 * p.typical * float(rng.standard_normal()) for p in mechanism.parameters}
    tool = np.array([20.0, -15.0, 0.0 if flat else -30.0])
    return dataclasses.replace(robot, mechanism=name, masses=masses, errors=errors, tool=tool)


def states(robot: Robot, n: int, seed: int = 0) -> np.ndarray:
    """Return joints, velocities and accelerations (3, n, n_q) within reach."""
    mechanism, rng = mechanism_of(robot), np.random.default_rng(seed)
    centre, half = workspace_of(robot).box
    points = centre + INNER * half * rng.uniform(-1, 1, (n, 3))
    q, _, status = mechanism.inverse(points, robot.tool, mechanism.rows(robot))
    assert not status.any()
    size = 1.0 if mechanism.joint_unit == "rad" else 200.0
    return np.stack([q, 3 * size * rng.standard_normal(q.shape), 40 * size * rng.standard_normal(q.shape)])
