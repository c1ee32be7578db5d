"""What drives give along a trajectory: the bodies of the robot file, and a truth that names what drives have beside."""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Container, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, TypeGuard

import numpy as np
from pydantic import Field

from deltacal_gen.errors import MissingChannel, MissingKey
from deltacal_gen.files.toml import Raw, Table, TomlFile, nearest, toml_text
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.derivatives import motion
from deltacal_gen.motion.joint import DRY, NOISY_SPEED, earlier
from deltacal_gen.motion.lag import LATENCY
from deltacal_gen.motion.library import Rung, of_joint
from deltacal_gen.motion.payload import NAMES, PAYLOAD, torque_of
from deltacal_gen.motion.rigid import Rigid
from deltacal_gen.motion.trajectories import Trajectories
from deltacal_gen.physics.terms import coefficients, drive_effect_names, load_effect
from deltacal_gen.states import CLOCK
from deltacal_gen.units import of_sliding

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

ROUNDED = 1e-12  # of a joint's way, per sample: what arithmetic leaves of a joint that stands
FORCE = "coulomb"  # what builds up over a way: the coefficient of dry friction


class _File(Table):
    parameters: dict[str, float] = Field(default_factory=dict)
    effects: list[dict[str, object]] = Field(default_factory=list)


@dataclass(frozen=True)
class Truth:
    """What a machine has that its robot file does not say.

    Attributes
    ----------
    parameters : mapping
        Inertial parameters, actual minus robot file [kg, mm].
    effects : tuple of (int, Rung, array)
        Joint (from 1), effect, coefficients in units inside.
    delays : mapping
        By which the readings of joints (from 1) come late [s].
    payloads : tuple of (str, (4,) array)
        Set-up, mass [kg] and centre [mm] beyond what is written.
    """

    parameters: Mapping[str, float] = field(default_factory=dict)
    effects: tuple[tuple[int, Rung, Array], ...] = ()
    delays: Mapping[int, float] = field(default_factory=dict)
    payloads: tuple[tuple[str, Array], ...] = ()


def read_truth(path: str | Path, rigid: Rigid) -> Truth:
    """Read a TRUTH.toml of a machine in motion; raises InputError."""
    file = TomlFile.read(path)
    said = file.check(_File)
    own = {name: value for name, value in said.parameters.items() if name not in CLOCK}
    for name in own:
        if name not in rigid.names:
            near = nearest(name, rigid.names)
            hint = f"Did you mean '{near}'?" if near else "They are m_i, mx_i, ixx_i ... of link i."
            raise file.error(f"no link has an inertial parameter '{name}'.", hint, "parameters", name)
    late, carried = ([t for t in said.effects if t.get("name") == name] for name in (LATENCY, PAYLOAD))
    delays = {i: d for table in late for i, d in _delays(file, table, rigid).items()}
    tables = [table for table in said.effects if table not in (*late, *carried)]
    dry = {
        i: t[FORCE] for t in tables if t.get("name") == DRY and FORCE in t for i in _limbs(file, DRY, dict(t), rigid)
    }
    acting = [
        found for table in tables for own in _by_way(file, table, rigid, dry) for found in _effects(file, own, rigid)
    ]
    return Truth(own, tuple(acting), delays, tuple(_payload(file, table) for table in carried))


def _is_number(value: object) -> TypeGuard[float]:
    """Tell whether a value of a truth is a finite number: integers of TOML may be longer than any."""
    return isinstance(value, int | float) and abs(value) <= sys.float_info.max


def _payload(file: TomlFile, table: Raw) -> tuple[str, Array]:
    """Return the set-up of a payload that is not what is written, and what it has beside: mass and centre."""
    given, names = dict(table), [name for name, _ in NAMES]
    setup = str(given.pop("setup", ""))
    values = [given.pop(name, 0.0) for name in names]
    if set(given) - {"name"} or not all(map(_is_number, values)):
        raise file.error(f"{PAYLOAD} has the numbers {', '.join(names)}, and setup.", "Correct the table.", "effects")
    return setup, np.array(values, dtype=float)


def _delays(file: TomlFile, table: Raw, rigid: Rigid) -> dict[int, float]:
    """Return by how much readings come late, joint by joint [s]."""
    delay = table.get("delay")
    if not _is_number(delay) or set(table) - {"name", "delay", "limb", "limbs"}:
        raise file.error("latency needs a number for 'delay', and no other.", "Give delay in s.", "effects")
    return {i: float(delay) for i in _limbs(file, LATENCY, dict(table), rigid)}


def _limbs(file: TomlFile, name: str, given: dict[str, object], rigid: Rigid) -> list[int]:
    """Take the joints out of an effect's table."""
    every, limb = range(1, rigid.dynamics.joints + 1), given.pop("limb", None)
    limbs = given.pop("limbs", None) or ([limb] if limb is not None else list(every))
    if not isinstance(limbs, list) or any(i not in every for i in limbs):
        raise file.error(f"{name}: joints are counted from 1 to {len(every)}.", "Correct limb or limbs.", "effects")
    return [int(i) for i in limbs]


def _by_way(file: TomlFile, table: Raw, rigid: Rigid, dry: Mapping[int, object]) -> list[Raw]:
    """Return the tables of an effect, of one that builds up over a way joint by joint with that way.

    Where it is not given it is the joint's dry friction over the effect's stiffness. What an own `coulomb` says of a
    joint without a table of dry friction is both.
    """
    name = table.get("name")
    kernels = load_effect(name) if name in drive_effect_names() else None
    if kernels is None or "travels" not in kernels.SEARCHED:
        return [table]
    rest, found = dict(table), list[Raw]()
    limbs, own = _limbs(file, str(name), rest, rigid), rest.pop(FORCE, None)
    way, stiffness = kernels.SEARCHED["travels"], rest.get(kernels.COEFFICIENTS[0][0])
    for i in limbs:
        force, here = dry.get(i, own), rest | {"limb": i}
        if way not in rest and _is_number(force) and _is_number(stiffness) and stiffness > 0:
            here[way] = force / stiffness
        found.append(here)
        if own is not None and i not in dry:
            found.append({"name": DRY, "limb": i, FORCE: own})
    return found


def _effects(file: TomlFile, table: Raw, rigid: Rigid) -> list[tuple[int, Rung, Array]]:
    """Return an effect of a truth, joint by joint."""
    given = dict(table)
    name = str(given.pop("name", ""))
    if name not in drive_effect_names():
        near = nearest(name, drive_effect_names())
        known = f"Did you mean '{near}'?" if near else f"Registered: {', '.join(drive_effect_names())}."
        raise file.error(f"there is no effect '{name}' on what drives give.", known, "effects")
    limbs = _limbs(file, name, given, rigid)
    kernels = load_effect(name)
    names = [key for key, *_ in (*kernels.COEFFICIENTS, *kernels.CONSTANTS)]
    numbers = {key: float(value) for key, value in given.items() if _is_number(value)}
    for key in names:
        if key not in numbers:
            raise file.error(f"{name} needs a number for '{key}'.", f"Give {', '.join(names)}.", "effects")
    if stray := [key for key in given if key not in names]:
        raise file.error(f"{name} has no parameter '{stray[0]}'.", f"It has {', '.join(names)}.", "effects")
    found = []
    for i in limbs:
        unit = rigid.dynamics.joint_units[i - 1]
        values = np.array([numbers[key] * factor for key, _, factor in coefficients(kernels, unit)], dtype=float)
        constants = []
        for key, of, factor, _ in kernels.CONSTANTS:
            inside = of_sliding(of)[1] if unit == "mm" and key in kernels.OF_JOINT else factor
            constants.append(numbers[key] * inside)
        found.append((int(i), Rung(name, tuple(constants)), values))
    return found


def lacking(rung: Rung, read: Container[str]) -> list[str]:
    """Return what an effect depends on that a trajectory does not hold."""
    return [name for name in rung.kernels.STATE if name not in read]


def simulated(
    robot: Robot, given: Trajectories, told: Truth, noise: float | Array, rng: np.random.Generator
) -> Trajectories:
    """Return a trajectory with what the drives give along it.

    Parameters
    ----------
    told : Truth
        Inertial parameters and effects beside the robot file.
    noise : float or (n_q,) array
        Of each reading, in its unit.

    Raises
    ------
    InputError
        The robot file leaves a body open, or the truth names what there is not.
    """
    rigid, found = Rigid(robot), motion(given)
    inertia = rigid.dynamics.stated(points=True)
    if np.isnan(inertia).any():
        body = rigid.names[int(np.argmax(np.isnan(inertia)))].rpartition("_")[2]
        raise MissingKey(
            f"joint {body} has no mass: what drives give cannot be simulated.",
            "Add mass, com and inertia to its table [[joint]]; without inertia it is a point.",
            file=robot.source,
        )
    inertia = inertia + np.array([told.parameters.get(name, 0.0) for name in rigid.names])
    states = np.nan_to_num(found.states)
    least = np.maximum(NOISY_SPEED * found.noise[0], ROUNDED * np.abs(states[0]).max(axis=0, initial=0.0) / given.step)
    states[1][np.abs(states[1]) <= least] = 0.0  # what stands has no direction
    load = rigid.torque(states, inertia) + rigid.of_payload(states) * given.payload[:, None]
    for setup, values in told.payloads:
        load = load + torque_of(rigid, states, given, (setup,), values[None])

    def late(values: Array, joint: int) -> Array:
        return earlier(values, told.delays.get(joint, 0.0), given.time, given.piece)

    total = np.column_stack([late(load[:, j], j + 1) for j in range(load.shape[1])])
    for joint, rung, values in told.effects:
        read = {name: late(v, joint) for name, v in of_joint(given, states, joint - 1, load[:, joint - 1]).items()}
        if missing := lacking(rung, read):
            raise MissingChannel(
                f"{rung.effect} depends on {missing[0]}, which the trajectory does not hold.",
                "Add the column temp_C.",
                file=given.path,
            )
        total[:, joint - 1] += rung.columns(read | rung.remembered(read, given.time, given.piece)) @ values
    readings = total / np.array([read.inside for read in given.readouts])
    readings += noise * rng.standard_normal(readings.shape)
    readings[~np.isfinite(found.states).all(axis=(0, 2))] = np.nan
    return dataclasses.replace(given, readings=readings)


def sidecar_text(done: Trajectories, noise: float) -> str:
    """Return the sidecar of a simulated recording."""
    said = {k: v for k, v in done.said.measurement.model_dump().items() if v is not None}
    if noise and len(set(done.units)) == 1:
        said |= {f"sigma_{done.units[0]}": noise}
    tables = {"measurement": said}
    if done.said.motion.derivatives is not None:
        tables["motion"] = {"derivatives": done.said.motion.derivatives}
    return toml_text(tables)
