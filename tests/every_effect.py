"""Every registered effect on a machine that has its parts, in sizes that show: what the shared tests run over."""

from __future__ import annotations

import copy
import dataclasses
import importlib
from collections.abc import Sequence
from functools import cache
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Masses, Robot, robot_from_dict
from deltacal_gen.machine.registry import Array, load_mechanism, mechanism_of
from deltacal_gen.physics.physics import (
    Body,
    Channels,
    Term,
    blank,
    effect_names,
    lacking,
    load_effect,
    of_the_instrument,
)
from deltacal_gen.physics.states import STATES, columns, read_by
from deltacal_gen.units import joint_names
from tests.conftest import PROTOTYPE, plausible

PRINTER = {
    "robot": {"name": "printer", "mechanism": "linear_delta"},
    "geometry": {
        "radius": 130.0,
        "arm_length": [270.0, 270.5, 269.5],
        "tower_angle": [210.0, 330.5, 90.0],
        "endstop": [300.0, 301.0, 299.0],
    },
    "transmission": {"pulley_circumference": 32.0},
    "workspace": {"top": 110.0, "radius": 80.0, "height": 100.0},
}
MASSES = Masses(proximal=1.2, proximal_com=0.4, distal_rod=0.15, platform=0.8)


@cache
def machines() -> tuple[Robot, ...]:
    """Return machines that together have all parts: a delta whose second joint counts backwards, and a printer."""
    delta, printer = robot_from_dict(copy.deepcopy(PROTOTYPE)), robot_from_dict(copy.deepcopy(PRINTER))
    errors = plausible(load_mechanism("delta"), 3)
    sign = np.array([1.0, -1.0, 1.0])
    return dataclasses.replace(delta, masses=MASSES, errors=errors, joint_sign=sign), printer


def machine_with(name: str) -> Robot:
    """Return the first machine that has the parts of an effect."""
    for robot in machines():
        mechanism = mechanism_of(robot)
        if not lacking(name, mechanism, mechanism.moves(robot), mechanism.roles(robot)):
            return robot
    raise AssertionError(f"no machine of these tests has the parts of {name}")


ON_MACHINES = tuple(name for name in effect_names() if not of_the_instrument(name))


def declared(name: str) -> Any:
    """Return an effect as its file in derive/effects declares it."""
    return importlib.import_module(f"derive.effects.{name}").EFFECT


def constants(name: str) -> tuple[float, ...]:
    """Return an effect's constants as its first reference has them, in units inside."""
    given = declared(name).tests[0].constants
    return tuple(given[key] * factor for key, _, factor, _ in load_effect(name).CONSTANTS)


def channels(robot: Robot, n: int, seed: int = 0) -> dict[str, np.ndarray]:
    """Return every column that an effect reads, (n,), between values that an ordinary session has."""
    rng = np.random.default_rng(seed)
    mechanism = mechanism_of(robot)
    unit, limbs = mechanism.joint_unit, mechanism.limbs
    out = {"temp_C": rng.uniform(18, 35, n), "payload_kg": rng.uniform(0, 3, n), "time_s": rng.uniform(0, 7200, n)}
    for i in range(1, limbs + 1):
        out[f"approach{i}"] = rng.choice([-1.0, 1.0], n)
    for pattern, most in (("qd{i}_{unit}_s", 100.0), ("qdd{i}_{unit}_s2", 1000.0)):
        out |= {name: rng.uniform(-most, most, n) for name in joint_names(unit, limbs, pattern)}
    read = [s for name in effect_names() for s in read_by(load_effect(name))]
    covariates = [c for s in read for c in s.channels if c.base not in STATES]
    return out | {name: rng.uniform(0, 10, n) for name in columns(covariates, unit, limbs)}


def targets(robot: Robot, n: int, seed: int = 0) -> Array:
    """Return points (n, 3) in the workspace."""
    rng, space = np.random.default_rng(seed), robot.workspace
    assert space is not None
    assert space.radius is not None
    turn, r = 2 * np.pi * rng.random(n), space.radius * np.sqrt(rng.random(n))
    return space.place(np.column_stack([r * np.cos(turn), r * np.sin(turn)]), rng.random(n))


def body_of(robot: Robot, n: int = 40, seed: int = 5) -> Body:
    """Return a machine at points of its workspace, with every channel."""
    mechanism, points = mechanism_of(robot), targets(robot, n, seed)
    tool = np.ascontiguousarray(np.broadcast_to(robot.tool, (n, 3)))
    q, _, status = mechanism.inverse(points, tool, mechanism.rows(robot))
    assert not status.any()
    known = Channels.from_columns(channels(robot, n, seed), q.shape, robot, mechanism.joint_unit)
    return Body(robot, mechanism, q, tool, known)


@cache
def _reach(name: str) -> Array:
    """Return how far an effect on all limbs moves the measured point, at most, per unit of each coefficient (n_c,)."""
    robot = machine_with(name)
    body, every = body_of(robot), np.arange(40)
    term = blank(name, range(1, body.mechanism.limbs + 1), constants(name))
    machine, status = body.solve(body.mechanism.vector(robot.errors), [term])
    assert not status.any()
    S = body.mechanism.sensitivity(machine.x, machine.q, machine.tool, machine.rows)
    moved = np.abs(body.columns([term], machine, S, every)[:, :3]).max(axis=(0, 1))
    out: Array = moved.reshape(term.values.shape).max(axis=0)
    return out


def sized(name: str, limbs: Sequence[int] = (1, 2, 3), much: float = 0.2) -> Term:
    """Return an effect each of whose coefficients moves the measured point by up to `much` [mm]."""
    term = blank(name, limbs, constants(name))
    return term.with_values(np.broadcast_to(much / _reach(name), term.values.shape))
