"""Machines with loops written down by hand for the engine of `mujoco_trees`."""

from __future__ import annotations

import numpy as np

from deltacal_gen.machine.values import Robot
from tests.support import independent_delta
from tests.support.machines_with_loops import MASSES
from tests.support.mujoco_trees import Linkage


def arm(length: float, joint: np.ndarray, line: np.ndarray, drawn: float) -> tuple[float, np.ndarray, float]:
    """Return mass, centre and own inertia of an arm as the robot file has it."""
    assert length > 0
    return MASSES.proximal, joint + MASSES.proximal_com * drawn * line, MASSES.proximal * drawn**2 / 12


def delta(robot: Robot) -> Linkage:
    """Return the Delta by hand, with all its errors: the twin of the kinematics' tests at joints and platform zero."""
    geometry = {key: float(np.ravel(v)[0]) for key, v in robot.geometry.items()}
    b, L = geometry["base_radius"], geometry["proximal_length"]
    geometry["c"] = geometry["joint_spacing"]
    elbows, hands, lengths = independent_delta.rod_ends(geometry, robot.errors, np.zeros(6), np.zeros(3), robot.tool)
    joints, axes, arms = [], [], []
    for i in range(3):
        e = {name: robot.errors[f"{name}_{i + 1}"] for name in ("ex", "ey", "ez", "alpha0", "beta0", "theta", "L")}
        frame = independent_delta.nominal_frame(i)
        turned = frame @ independent_delta.turned(e["alpha0"], e["beta0"], 0.0)
        joints.append(b * frame[:, 0] + np.array([e["ex"], e["ey"], e["ez"]]))
        axes.append(turned[:, 2])
        line = turned @ independent_delta.turned(0.0, 0.0, e["theta"])[:, 0]
        arms.append(arm(L + e["L"], joints[-1], line, L))
    return Linkage(
        joint=np.array(joints),
        axis=np.array(axes),
        slides=False,
        elbows=elbows,
        hands=hands,
        lengths=lengths,
        centre=-robot.tool,
        arms=arms,
        rod=MASSES.distal_rod,
        platform=MASSES.platform,
        gravity=np.array([0.0, 0.0, -9.81]),
    )
