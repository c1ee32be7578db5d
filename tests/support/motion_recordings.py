"""Recordings of an arm in motion, written for the tests: its joints, its friction, what it carries."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import deltacal_gen as dc
from deltacal_gen.files.robot import read_robot, robot_from_dict, robot_to_toml
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.motion.session import Session
from deltacal_gen.motion.trajectories import read, read_sidecar
from tests.support.every_effect import ARM
from tests.support.moving_chains import bodies

MOTION = '[measurement]\nkind = "torque"\n'
PLANNED = MOTION + '[motion]\nderivatives = "recorded"\n'
LINKS = ARM[:3]
BODIED = [link | {"mass": 3.0, "com": [40.0, -20.0, 30.0], "inertia": [2e4, 3e4, 4e4, 1e3, 2e3, 3e3]} for link in LINKS]
HEAD = {"robot": {"name": "arm", "mechanism": "serial"}}
DEG = np.pi / 180
NOISE = 0.05  # Nm
STEP = 0.01  # s
COULOMB, VISCOUS = np.array([6.0, 4.0, 0.0]), np.array([0.15, 0.0, 0.08])  # Nm, Nm s/deg


def robot(links: list[dict[str, Any]] = LINKS) -> Any:
    return robot_from_dict(HEAD | {"joint": [dict(link) for link in links]})


def waves(t: np.ndarray, seed: int, joints: int = 3) -> np.ndarray:
    """Return joints, velocities, accelerations (3, N, n) of sums of waves [rad] at times (N,)."""
    rng = np.random.default_rng(seed)
    out = np.zeros((3, len(t), joints))
    for j in range(joints):
        for w in 2 * np.pi * np.array([0.1, 0.23, 0.41, 0.6]):
            a, phase = rng.uniform(0.2, 0.5) / (1 + w), rng.uniform(0, 6)
            angle = w * t + phase
            out[:, :, j] += a * np.array([np.sin(angle), w * np.cos(angle), -(w**2) * np.sin(angle)])
    return out


def trajectory(seconds: float, seed: int, joints: int = 3, late: float = 0.0) -> np.ndarray:
    """Return the same at 100 Hz, `late` seconds earlier."""
    return waves(np.arange(0, seconds, STEP) - late, seed, joints)


Friction = Callable[[np.ndarray, np.ndarray], np.ndarray]  # of states (3, N, n) and the rigid torque (N, n) [Nm]


def usual(states: np.ndarray, load: np.ndarray) -> np.ndarray:
    return COULOMB * np.sign(states[1]) + VISCOUS * states[1] / DEG


def written(folder: Path, friction: Friction, runs: int = 4, seed: int = 0, sidecar: str = "", **kept: Any) -> Path:
    """Write a recording of an arm with some friction, and its robot file; return the recording's path.

    With `alone` one joint moves in every run, one after another, and the others stand at zero.
    """
    machine, rng = robot(), np.random.default_rng(seed)
    own, inertia = dynamics_of(machine), bodies(LINKS).ravel()
    rows = [["run", "time_s", *(f"q{i}_deg" for i in (1, 2, 3)), *(f"tau{i}_Nm" for i in (1, 2, 3))]]
    for run in range(runs):
        moved = np.arange(3) == run % 3 if kept.get("alone") else np.ones(3)
        states = moved * trajectory(kept.get("seconds", 12.0), 10 * seed + run)
        load = own.torque(states, inertia) / 1000
        tau = load + friction(states, load)
        for j, delay in enumerate(kept.get("delay", ())):
            then = moved * trajectory(kept.get("seconds", 12.0), 10 * seed + run, late=delay)
            force = own.torque(then, inertia) / 1000
            tau[:, j] = (force + friction(then, force))[:, j]
        tau = tau + NOISE * rng.standard_normal(load.shape)
        q = states[0] / DEG + 0.001 * rng.standard_normal(load.shape)
        for n in range(len(tau)):
            cells = [f"{v:.6f}" for v in (n * STEP, *q[n], *tau[n])]
            rows.append([str(run + 1), *cells])
    path = folder / "recording.csv"
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    path.with_suffix(".toml").write_text(f'[measurement]\nkind = "torque"\n{sidecar}')
    (folder / "robot.toml").write_text(robot_to_toml(machine))
    return path


def named(found: Any) -> dict[str, list[int]]:
    return {effect["name"]: effect["limbs"] for effect in found["effects"]}


def planned(folder: Path, truth: str, runs: int = 4, seconds: float = 10.0) -> Path:
    """Write a trajectory with 2 kg, the robot with all its bodies, and a truth; return the trajectory's path."""
    rows = [["run", "time_s", "q1_deg", "q2_deg", "q3_deg", "payload_kg"]]
    for run in range(runs):
        q = trajectory(seconds, 60 + run)[0] / DEG
        rows += [[str(run), *(f"{v:.6f}" for v in (n * STEP, *row)), "2.0"] for n, row in enumerate(q)]
    path = folder / "trajectory.csv"
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\n')
    (folder / "robot.toml").write_text(robot_to_toml(robot(BODIED)))
    (folder / "truth.toml").write_text(truth)
    return path


def carried(folder: Path, truth: str) -> Path:
    """Write runs of an arm whose file states all bodies, with a payload that is written as 2 kg; return the path."""
    path, made = planned(folder, truth), folder / "made.csv"
    dc.simulate(folder / "robot.toml", path, output=made, truth=folder / "truth.toml", noise=NOISE, seed=3)
    return made


def session_of(recording: Path) -> Session:
    machine, said = read_robot(recording.parent / "robot.toml"), read_sidecar(recording)
    assert said is not None
    return Session.of(machine, read(recording, mechanism_of(machine), said))
