"""Open chains in motion: their bodies, states in general position, torques by differences."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from deltacal_gen.machine.dynamics import Dynamics, dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from tests.support.every_effect import robot_from_dict

GRAVITY = (1.0, -2.0, -9.0)
STEP = 0.2  # of what is typical of an error


def robot_of_links(links: Sequence[Mapping[str, Any]], gravity: Sequence[float] = GRAVITY) -> Robot:
    head = {"robot": {"name": "arm", "mechanism": "serial"}, "geometry": {"tool": [40.0, -15.0, 90.0]}}
    tables = head | {"joint": [dict(link) for link in links], "masses": {"gravity": list(gravity)}}
    return robot_from_dict(tables)


def dynamics(links: Sequence[Mapping[str, Any]], gravity: Sequence[float] = GRAVITY) -> Dynamics:
    return dynamics_of(robot_of_links(links, gravity))


def states(links: Sequence[Mapping[str, Any]], n: int, seed: int = 0) -> np.ndarray:
    """Return joints, velocities and accelerations (3, n, n_q) in general position."""
    moving = [link["kind"] == "prismatic" for link in links if link["kind"] in ("revolute", "prismatic")]
    sizes = np.where(moving, 150.0, 1.5)
    return np.random.default_rng(seed).standard_normal((3, n, len(sizes))) * sizes


def bodies(links: Sequence[Mapping[str, Any]], seed: int = 1) -> np.ndarray:
    """Return inertial parameters (links, 10) of points of mass: what could be built."""
    rng = np.random.default_rng(seed)
    found = np.zeros((len(links), 10))
    for k in range(len(links)):
        for mass, (x, y, z) in zip(rng.uniform(0.2, 3.0, 6), 120 * rng.standard_normal((6, 3)), strict=True):
            tensor = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z]
            found[k] += mass * np.array([1.0, x, y, z, *tensor])
    return found


def by_differences(robot: Robot, motion: np.ndarray, inertia: np.ndarray) -> np.ndarray:
    """Return how torques change (N, n_q, n) with each source error, per what is typical of it: of fourth order."""
    found = []
    for p in mechanism_of(robot).parameters:
        sides = []
        for n in (1, -1, 2, -2):
            errors = robot.errors | {p.name: robot.errors.get(p.name, 0.0) + n * STEP * p.typical}
            sides.append(dynamics_of(dataclasses.replace(robot, errors=errors)).torque(motion, inertia))
        found.append((8 * (sides[0] - sides[1]) - (sides[2] - sides[3])) / (12 * STEP))
    return np.stack(found, axis=2)
