"""An arm of six joints, and what a tracker that nobody placed reads of it."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np

from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.simulation import simulate

LINKS = ((50, -90, 480, 0), (500, 0, 0, -90), (0, 90, 50, 90), (0, -90, 550, 0), (0, 90, 0, 0), (0, 0, 100, 0))
SIGMA = 0.002  # mm


def six_joints() -> Robot:
    joints = [
        {"kind": "revolute", "convention": "standard", "a": a, "alpha": alpha, "d": d, "theta": theta}
        for a, alpha, d, theta in LINKS
    ]
    tool = {"tool": [-30.0, -20.0, 100.0]}
    return robot_from_dict({"robot": {"name": "arm", "mechanism": "serial"}, "joint": joints, "geometry": tool})


def unread(robot: Robot, joints: np.ndarray) -> Recording:
    """Return joints at which positions in an unknown frame are still to be read."""
    n = len(joints)
    return Recording(
        path=Path("arm"),
        kind="position",
        measurement=Measurement(kind="position", frame="unknown"),
        joint_unit=mechanism_of(robot).joint_unit,
        joints=joints,
        columns=("x_mm", "y_mm", "z_mm"),
        measured=np.full((n, 3), np.nan),
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        channels={},
        setup=np.zeros(n, dtype=int),
        setup_names=("",),
    )


def recorded(arm: Robot, joints: np.ndarray, sag: float = 0.0, size: float = 1.0) -> Recording:
    """Return positions in an unknown frame of an arm with errors, that sinks with its reach by a part `sag` of it."""
    rng, mechanism = np.random.default_rng(3), mechanism_of(arm)
    names = mechanism.model(mechanism.full_model)
    errors = {name: float(size * mechanism.typical[mechanism.index[name]] * rng.standard_normal()) for name in names}
    here = (np.zeros(3), np.zeros(3))
    low = simulate(arm, unread(arm, joints), errors, noise_mm=SIGMA, rng=rng, frame=here)
    sunk = low.measured - np.outer(sag * np.linalg.norm(low.measured[:, :2], axis=1), [0, 0, 1.0])
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    return dataclasses.replace(low, measured=sunk @ turn.T + [-70.0, -2900.0, 660.0])


def wide(rng: np.random.Generator, n: int, span: float) -> np.ndarray:
    return np.array([-0.7, 0.2, 1.2, 1.1, 1.2, -0.9]) + span * rng.uniform(-1, 1, (n, 6))
