"""Machines of the concealed cases, and where they are measured.

The delta is drawn from sizes of its own; any other machine is the package's example of it in another size, with parts
that are not quite as long. Parts weigh what their size suggests.

A machine may be measured by one kind alone: ``"delta encoder"`` is a delta with encoders on its arms.

Public: `MACHINES`, `INSTRUMENTS`, `EVERY`, `parted`, `draw`, `ordinary_errors`, `joints_of_poses`, `kinds`, `shown`.
"""

from __future__ import annotations

import dataclasses
import functools
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot, read_robot, robot_from_dict, robot_to_dict
from deltacal_gen.identification.accuracy import turned
from deltacal_gen.instrument.kind import Kind
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Machine, mechanism_names, mechanism_of
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.terms import displaces_points, effect_names, load_effect
from deltacal_gen.units import DEG
from tests.support.drawn import example_of

Array = np.ndarray
MACHINES = (
    "delta",
    "complete_delta",
    "diamond",
    "hexapod",
    "linear_delta",
    "planar_parallelogram",
    "robotennis",
    "serial",
)
INSTRUMENTS = ("encoder", "touched_board", "board_image")  # of which a machine's cases may be
EVERY = (*MACHINES, *(name for name in mechanism_names() if name not in MACHINES))  # no case is drawn of the others
TYPICAL = {"theta": 0.05 * DEG, "length": 0.1, "angle": 0.03 * DEG}  # of machined parts
SMALL = 0.3  # of the typical errors of the other machines, which are those before any assembly
SWING = 80 * DEG  # to which the joints of a chain are turned either way
DRAWN = {"orders", "moments"}  # how constants are sought of which a case can be drawn
DOWN = {2: (0.0, -9.81, 0.0), 3: (0.0, 0.0, -9.81)}  # by the number of axes: planar machines hang in their plane


def parted(machine: str) -> tuple[str, str]:
    """Return a machine, and the only kind it is measured by: "" where that is drawn."""
    name, _, kind = machine.partition(" ")
    return name, kind


def draw(machine: str, rng: np.random.Generator) -> Robot:
    """Return a machine of a kind in one of its sizes."""
    s = rng.choice([0.55, 0.8, 1.0, 1.2])
    if machine not in ("delta", "complete_delta"):
        return _as_example(machine, float(s), rng)
    sizes = {"base_radius": 200, "platform_radius": 51, "proximal_length": 375, "distal_length": 950}
    tables: dict[str, Any] = {
        "robot": {"name": machine, "mechanism": machine},
        "geometry": {k: round(float(v * s * rng.uniform(0.97, 1.03)), 1) for k, v in sizes.items()}
        | {"joint_spacing": round(float(100 * s), 1), "tool": [0.0, 0.0, 0.0]},
        "workspace": {"top": 728.0 * s, "radius": 480.0 * s, "height": 250.0 * s},
        "masses": {
            "proximal": round(float(1.2 * s * rng.uniform(0.7, 1.4)), 3),
            "proximal_com": round(float(rng.uniform(0.35, 0.5)), 3),
            "distal_rod": round(float(0.15 * s * rng.uniform(0.7, 1.4)), 3),
            "platform": round(float(0.8 * s * rng.uniform(0.7, 1.4)), 3),
        },
    }
    if rng.random() < 0.4:
        tables["transmission"] = {"gear_ratio": float(rng.choice([16.0, 20.0, 21.0, 33.0, 50.5]))}
    return robot_from_dict(tables)


def _as_example(machine: str, s: float, rng: np.random.Generator) -> Robot:
    robot = dataclasses.replace(read_robot(example_of(machine) / "robot.toml"), mechanism=machine, tolerance={})
    mechanism, tables = mechanism_of(robot), robot_to_dict(robot)
    for key in mechanism.geometry if not robot.links else ():
        if key.unit == "mm" and key.table == "geometry":
            given = tables["geometry"][key.key]
            tables["geometry"][key.key] = (s * np.asarray(given)).tolist()
    for link in tables.get("joint", ()):
        link |= {key: float(link[key] * s) for key in ("a", "d")}
    for key in {*tables.get("workspace", ())} - {"turn"}:
        tables["workspace"][key] *= s
    if "limits_mm" in tables.get("joints", ()):
        tables["joints"]["limits_mm"] = (s * np.asarray(tables["joints"]["limits_mm"])).tolist()
    if not robot.links:
        tables["masses"] = {
            "proximal": round(float(1.2 * s * rng.uniform(0.7, 1.4)), 3),
            "distal_rod": round(float(0.2 * s * rng.uniform(0.7, 1.4)), 3),
            "platform": round(float(0.8 * s * rng.uniform(0.7, 1.4)), 3),
            "gravity": DOWN[len(mechanism.axes)],
        }
    return robot_from_dict(tables)


def ordinary_errors(robot: Robot, rng: np.random.Generator) -> dict[str, float]:
    """Return errors of the parts [mm, rad] such as machining and assembly leave."""
    mechanism = mechanism_of(robot)
    if robot.mechanism in ("delta", "complete_delta"):

        def size(name: str, unit: str) -> float:
            return TYPICAL["theta" if name.startswith("theta") else "length" if unit == "mm" else "angle"]

        return {p.name: float(size(p.name, p.unit) * rng.standard_normal()) for p in mechanism.parameters}
    known = set(mechanism.models[mechanism.full_model])
    return {
        p.name: float(SMALL * p.typical * rng.standard_normal()) if p.name in known else 0.0
        for p in mechanism.parameters
    }


def joints_of_poses(robot: Robot, n: int, tool: Array, rng: np.random.Generator, flat: bool = False) -> Array:
    """Return joints (n, limbs) of poses on rings or anywhere in the workspace, or `flat` in its upper plane."""
    if flat and robot.workspace is not None:
        robot = dataclasses.replace(robot, workspace=dataclasses.replace(robot.workspace, height=0.0))
    mechanism, rings = mechanism_of(robot), rng.random() < 0.5
    if robot.links:
        return np.asarray(SWING * rng.uniform(-1, 1, (n, mechanism.limbs)))
    rows = mechanism.rows(robot, np.zeros(len(mechanism.parameters)))
    theta, _, status = mechanism.inverse(turned(robot, _targets(robot, n, rings, rng)), tool, rows)
    if (status != 0).any():
        raise RuntimeError("the workspace is larger than the machine's reach")
    return theta


def _targets(robot: Robot, n: int, rings: bool, rng: np.random.Generator) -> Array:
    space = robot.workspace
    assert space is not None
    if space.radius is None:
        assert space.width is not None
        return space.place(space.width * rng.uniform(-0.5, 0.5, n), rng.random(n))
    if rings:
        per = int(rng.choice([8, 12, 18]))
        k = np.arange(n)
        layers = int(rng.integers(3, 6))
        count = max(int(np.ceil(n / per / layers)), 1)
        radius = space.radius * (1 + (k // per) % count) / count
        angle = 2 * np.pi * (k % per) / per + rng.uniform(0, 1)
        height = np.minimum((k // (per * count)) / max(layers - 1, 1), 1.0)
    else:
        radius, angle = space.radius * np.sqrt(rng.random(n)), 2 * np.pi * rng.random(n)
        height = rng.random(n)
    return space.place(np.column_stack([radius * np.cos(angle), radius * np.sin(angle)]), height)


def kinds(mechanism: Machine) -> dict[str, float]:
    """Return the kinds of measurement and how often each is drawn."""
    if mechanism.name in ("delta", "complete_delta"):
        return {"position": 0.66, "pose": 0.1, "distance": 0.16, "gauge": 0.08}
    if mechanism.limbs == 1:  # along its stroke a point tells little
        return {"pose": 1.0}
    if len(mechanism.axes) == 2:
        return {"position": 1.0}
    return {"position": 0.7, "pose": 0.15, "distance": 0.15}


@functools.cache
def shown(machine: str) -> tuple[str, ...]:
    """Return the effects on parts of a machine, and on what its instrument reads, whose constants can be drawn."""
    name, of = parted(machine)
    robot = draw(name, np.random.default_rng(0))
    mechanism, kind = mechanism_of(robot), kind_of(of or "position")
    nothing = Channels.from_columns({}, (1, mechanism.limbs), robot)
    body = Body(robot, mechanism, np.zeros((1, mechanism.limbs)), np.zeros((1, 3)), nothing)
    return tuple(
        name
        for name in effect_names()
        if body.foreign(name) is None
        and "height" not in load_effect(name).TARGETS
        and not ("turn" in load_effect(name).STATE and body.missing(name))
        and set(load_effect(name).SEARCHED) <= DRAWN
        and (not of or _read(name, kind))
    )


def _read(name: str, kind: Kind) -> bool:
    """Tell whether an effect can show in readings of a kind, of one point."""
    kernels = load_effect(name)
    if kind.sees_joints:
        return "joint" in kernels.TARGETS
    on_reading = kernels.ACTS_ON == "reading"
    return not displaces_points(kernels) and (not on_reading or bool({*kernels.TARGETS} & {*kind.targets}))
