"""The derived torques against those of MuJoCo, an engine made by others."""

from __future__ import annotations

import numpy as np
import pytest

from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from tests.support import independent_delta
from tests.support.every_effect import ARM, PRINTER
from tests.support.linkages import arm, delta
from tests.support.machines_with_loops import MASSES, machine, states
from tests.support.moving_chains import bodies, dynamics
from tests.support.moving_chains import states as states_of_chain
from tests.support.mujoco_trees import Linkage, torque_of_chain, torque_of_linkage

pytest.importorskip("mujoco", reason="MuJoCo, whose torques are compared with, is of the dependency group 'dev'")
STATES = 1000
NEAR = 1e-8  # of the rms of a joint's torque


def diamond(robot: Robot) -> Linkage:
    """Return the Diamond by hand, as its file says: arms about z, one link from each to the platform."""
    g, e = {key: float(np.ravel(v)[0]) for key, v in robot.geometry.items()}, robot.errors
    assert robot.masses is not None
    joints, elbows, hands, lengths, arms = [], [], [], [], []
    for i, side in enumerate((1.0, -1.0), start=1):
        joint = np.array([side * g["base_x"] + e[f"ex_{i}"], g["base_y"] + e[f"ey_{i}"], 0.0])
        line = np.array([np.cos(e[f"theta_{i}"]), np.sin(e[f"theta_{i}"]), 0.0])
        L = g["proximal_length"] + e[f"L_{i}"]
        joints.append(joint)
        elbows.append([joint + L * line])
        hands.append([-robot.tool])
        lengths.append([g["distal_length"] + e[f"l_{i}"]])
        arms.append(arm(L, joint, line, g["proximal_length"]))
    return Linkage(
        joint=np.array(joints),
        axis=np.tile([0.0, 0.0, 1.0], (2, 1)),
        slides=False,
        elbows=np.array(elbows),
        hands=np.array(hands),
        lengths=np.array(lengths),
        centre=-robot.tool,
        arms=arms,
        rod=MASSES.distal_rod,
        platform=MASSES.platform,
        gravity=np.array(robot.masses.gravity),
        turns=False,
    )


def linear_delta(robot: Robot) -> Linkage:
    """Return the printer by hand, as its file says: leaning towers, and pairs of rods of two lengths."""
    e, given = robot.errors, PRINTER["geometry"]
    a, c = 30.0, 50.0  # of the effector and its rods, where the robot file says nothing
    axes, elbows, hands, lengths, arms = [], [], [], [], []
    for i in range(3):
        own = {key.rsplit("_", 1)[0]: v for key, v in e.items() if key.endswith(f"_{i + 1}")}
        phi = np.radians(given["tower_angle"][i]) + own["angle"]
        u, t = np.array([np.cos(phi), np.sin(phi), 0.0]), np.array([-np.sin(phi), np.cos(phi), 0.0])
        length, out = given["arm_length"][i] + own["arm"], given["radius"] + e["radius"] + own["radius"]
        lean = independent_delta.turned(*(own["lean_radial"] * t - own["lean_tangential"] * u))[:, 2]
        top = given["endstop"][i] + own["endstop"] + np.sqrt(length**2 - out**2)
        carriage = (out + a) * u + top / lean[2] * lean
        axes.append(-(1 + own["scale"]) * lean)
        elbows.append([carriage + side * c / 2 * t for side in (1, -1)])
        hands.append([a * u - robot.tool + side * c / 2 * t for side in (1, -1)])
        lengths.append([length + side * own["dl"] / 2 for side in (1, -1)])
        arms.append((float(MASSES.carriage or 0.0), carriage, 0.0))
    return Linkage(
        joint=np.array([centre for _, centre, _ in arms]),
        axis=np.array(axes),
        slides=True,
        elbows=np.array(elbows),
        hands=np.array(hands),
        lengths=np.array(lengths),
        centre=-robot.tool,
        arms=arms,
        rod=MASSES.distal_rod,
        platform=MASSES.platform,
        gravity=np.array([0.0, 0.0, -9.81]),
    )


@pytest.mark.parametrize("linkage", [delta, diamond, linear_delta])
def test_loops_ask_what_an_engine_s_open_tree_asks_along_them(linkage) -> None:  # type: ignore[no-untyped-def]
    robot = machine(linkage.__name__)
    motion, own = states(robot, STATES), dynamics_of(robot)
    pose = mechanism_of(robot).forward(motion[0, :1], robot.tool, mechanism_of(robot).rows(robot))[0][0]
    near = np.array([*pose[:3], 0.0, 0.0, 0.0])
    wanted = torque_of_linkage(linkage(robot), motion, near)
    rms = np.sqrt((wanted**2).mean(axis=0))
    assert np.abs((own.torque(motion, own.stated()) - wanted) / rms).max() < NEAR


def test_a_chain_of_six_joints_asks_what_an_engine_asks() -> None:
    motion, inertia, gravity = states_of_chain(ARM, STATES), bodies(ARM), (0.3, -0.4, -9.81)
    wanted = torque_of_chain(ARM, inertia, motion, gravity)
    rms = np.sqrt((wanted**2).mean(axis=0))
    assert np.abs((dynamics(ARM, gravity).torque(motion, inertia) - wanted) / rms).max() < NEAR
