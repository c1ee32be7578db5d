"""Every registered effect on a machine that has its parts, in sizes that show: what the shared tests run over."""

from __future__ import annotations

import copy
import dataclasses
import importlib
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.machine.registry import Array, load_mechanism, mechanism_of
from deltacal_gen.machine.values import Masses
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.parts import lacking
from deltacal_gen.physics.terms import Constant, Term, blank, effect_names, load_effect, of_the_instrument, scaled
from deltacal_gen.states import STATES, columns, named, read_by
from deltacal_gen.units import joint_names
from tests.support.prototype import PROTOTYPE, plausible

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
ARM: list[dict[str, Any]] = [
    {"kind": "revolute", "alpha": 90.0, "d": 320.0, "mass": 9.0, "com": [0.0, -80.0, 0.0]},
    {"kind": "revolute", "a": 600.0, "mass": 8.0, "com": [-280.0, 0.0, 90.0]},
    {"kind": "revolute", "a": 500.0, "mass": 5.0, "com": [-240.0, 0.0, 20.0]},
    {"kind": "revolute", "alpha": 90.0, "d": 130.0, "mass": 1.5, "com": [0.0, 0.0, 10.0]},
    {"kind": "revolute", "alpha": -90.0, "d": 110.0, "mass": 1.2, "com": [0.0, 0.0, 10.0]},
    {"kind": "revolute", "d": 90.0, "mass": 0.4, "com": [0.0, 0.0, -20.0]},
]
LIFT: list[dict[str, Any]] = [  # a column that lifts an arm of two links
    {"kind": "prismatic", "d": 400.0, "mass": 12.0, "com": [60.0, 0.0, -30.0]},
    {"kind": "revolute", "a": 450.0, "d": 80.0, "mass": 6.0, "com": [-200.0, 0.0, 0.0]},
    {"kind": "revolute", "a": 380.0, "alpha": 90.0, "mass": 4.0, "com": [-170.0, 0.0, 20.0]},
    {"kind": "revolute", "d": 120.0, "mass": 1.0, "com": [0.0, 0.0, -30.0]},
]


SPAN = {"rad": 1.4, "mm": 150.0}  # either way, of the joints of a chain
MASSES = Masses(proximal=1.2, proximal_com=0.4, distal_rod=0.15, platform=0.8)


def chain(links: Sequence[Mapping[str, Any]]) -> Robot:
    """Return an open chain with a tool off its last axis."""
    head = {"robot": {"name": "arm", "mechanism": "serial"}, "geometry": {"tool": [40.0, -15.0, 90.0]}}
    return robot_from_dict(head | {"joint": copy.deepcopy(list(links))})


@cache
def machines() -> tuple[Robot, ...]:
    """Return machines that together have all parts: a delta whose joint 2 counts backwards, a printer, and a lift."""
    delta, printer = robot_from_dict(copy.deepcopy(PROTOTYPE)), robot_from_dict(copy.deepcopy(PRINTER))
    errors = plausible(load_mechanism("delta"), 3)
    sign = np.array([1.0, -1.0, 1.0])
    return dataclasses.replace(delta, masses=MASSES, errors=errors, joint_sign=sign), printer, chain(LIFT)


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


def constants(name: str) -> tuple[Constant, ...]:
    """Return an effect's constants as its first reference has them, in units inside."""
    given = declared(name).tests[0].constants
    return tuple(scaled(given[key], factor) for key, _, factor, _ in load_effect(name).CONSTANTS)


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
    covariates += [named(v) for name in effect_names() for v in constants(name) if isinstance(v, str)]
    return out | {name: rng.uniform(0, 10, n) for name in columns(covariates, unit, limbs)}


def joints(robot: Robot, n: int, seed: int = 0) -> Array:
    """Return joints (n, n_q) at which an open chain may stand."""
    rng, m = np.random.default_rng(seed), mechanism_of(robot)
    return np.column_stack([SPAN[unit] * rng.uniform(-1, 1, n) for unit in m.joint_units])


def targets(robot: Robot, n: int, seed: int = 0) -> Array:
    """Return points (n, 3) in the workspace; of an open chain poses (n, 12)."""
    rng, space = np.random.default_rng(seed), robot.workspace
    if robot.links:
        m = mechanism_of(robot)
        return m.forward(joints(robot, n, seed), robot.tool, m.rows(robot))[0]
    assert space is not None
    assert space.radius is not None
    turn, r = 2 * np.pi * rng.random(n), space.radius * np.sqrt(rng.random(n))
    return space.place(np.column_stack([r * np.cos(turn), r * np.sin(turn)]), rng.random(n))


def body_of(robot: Robot, n: int = 40, seed: int = 5) -> Body:
    """Return a machine at points of its workspace, with every channel."""
    mechanism = mechanism_of(robot)
    tool = np.ascontiguousarray(np.broadcast_to(robot.tool, (n, 3)))
    if robot.links:
        q = joints(robot, n, seed)
    else:
        q, _, status = mechanism.inverse(targets(robot, n, seed), tool, mechanism.rows(robot))
        assert not status.any()
    known = Channels.from_columns(channels(robot, n, seed), q.shape, robot, mechanism.joint_unit)
    return Body(robot, mechanism, q, tool, known)


@cache
def _reaches(name: str) -> Array:
    """Return how far an effect moves the measured point, at most, per unit of each coefficient, (limbs or 1, n_c)."""
    robot = machine_with(name)
    body, every = body_of(robot), np.arange(40)
    term = blank(name, range(1, body.mechanism.limbs + 1), constants(name))
    machine, status = body.solve(body.mechanism.vector(robot.errors), [term])
    assert not status.any()
    S = body.mechanism.sensitivity(machine.x, machine.q, machine.tool, machine.rows)
    moved = np.abs(body.columns([term], machine, S, every)[:, :3]).max(axis=(0, 1))
    out: Array = moved.reshape(term.values.shape)
    return out


def limbs_with(name: str) -> tuple[int, ...]:
    """Return two limbs, or the only one, that an effect moves at all; of its kind on the whole machine, any."""
    reaches = _reaches(name).min(axis=1)
    found = [i + 1 for i in np.flatnonzero(reaches > 1e-6 * reaches.max())]
    return (found[0], found[-1]) if len(found) > 1 else (1, 3) if len(reaches) == 1 else (found[0],)


def sized(name: str, limbs: Sequence[int] = (1, 2, 3), much: float = 0.2) -> Term:
    """Return an effect each of whose coefficients moves the measured point by up to `much` [mm]."""
    term = blank(name, limbs, constants(name))
    return term.with_values(np.broadcast_to(much / _reaches(name).max(axis=0), term.values.shape))
