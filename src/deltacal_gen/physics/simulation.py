"""Exact simulation: what an instrument would read on a machine with known errors.

The machine is solved on its closure, with no linearisation anywhere; noise comes from a Generator that is passed in.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import Field

from deltacal_gen.errors import MissingChannel, OutOfReach
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.toml import Number, Table, TomlFile, nearest
from deltacal_gen.instrument.kind import TURN_MM
from deltacal_gen.instrument.kinds import kind_of, measured_points
from deltacal_gen.machine.registry import SOLVED, STATUS, UNDEFINED, Array, Machine, mechanism_of, nominal_joints
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import ROTATION, TRUTH, Recording
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.motion import with_motion
from deltacal_gen.physics.parts import lacks
from deltacal_gen.physics.reading import reading_shift
from deltacal_gen.physics.terms import LOGGED, Term, blank, constants_of, effect_names, row_factors, scaled
from deltacal_gen.states import CLOCK
from deltacal_gen.units import DEG, to_internal


class _Truth(Table):
    parameters: dict[str, Number] = Field(default_factory=dict)
    effects: list[dict[str, Any]] = Field(default_factory=list)


@dataclass(frozen=True)
class Truth:
    """What a simulated machine is: source errors [mm, rad] and effects on it."""

    errors: dict[str, float]
    terms: tuple[Term, ...] = ()


def read_truth(path: str | Path, robot: Robot) -> Truth:
    """Return the source errors and effects of a TRUTH.toml.

    An effect is a table ``[[effects]]`` with ``name``, ``limb`` or ``limbs``, and its parameters in the units of the
    contract, one number for all its limbs or a list with one for each.

    Raises
    ------
    InputError
        A parameter that the mechanism or the effect does not have, or an effect that is not registered.
    """
    file = TomlFile.read(path)
    truth = file.check(_Truth)
    mechanism = mechanism_of(robot)
    units = {p.name: p.unit for p in mechanism.parameters}
    for name in truth.parameters:
        if name not in units and name not in CLOCK:
            near = nearest(name, units)
            raise file.error(
                f"{mechanism.name} has no parameter '{name}'.",
                f"Did you mean '{near}'?" if near else "See deltacal models for the names.",
                "parameters",
                name,
            )
    errors = {name: v * to_internal(units[name]) for name, v in truth.parameters.items() if name not in CLOCK}
    return Truth(errors, tuple(_checked_term(file, table, robot, mechanism) for table in truth.effects))


def truth_names(path: str | Path) -> tuple[str, ...]:
    """Return the source errors that a TRUTH.toml names, right or wrong: they tell which description of a machine."""
    return tuple(name for name in TomlFile.read(path).check(_Truth).parameters if name not in CLOCK)


def truth_clock(path: str | Path) -> dict[str, float]:
    """Return what a TRUTH.toml says of an instrument's own clock: `clock_offset` [s] and `clock_rate`."""
    return {name: v for name, v in TomlFile.read(path).check(_Truth).parameters.items() if name in CLOCK}


def _checked_term(file: TomlFile, table: dict[str, Any], robot: Robot, mechanism: Machine) -> Term:
    try:
        term = _term(file, table, robot, mechanism)
    except (TypeError, ValueError):
        raise file.error(
            f"the effect '{table.get('name')}' holds a value of the wrong type.",
            "Give limb as an integer, limbs as a list of them, and numbers for the parameters.",
            "effects",
        ) from None
    if len(set(term.limbs)) < len(term.limbs) or not np.isfinite(term.values).all():
        raise file.error(
            f"the effect '{term.effect}' has a limb twice or a value that is no number.", "Correct it.", "effects"
        )
    return term


def _term(file: TomlFile, table: dict[str, Any], robot: Robot, mechanism: Machine) -> Term:
    given = dict(table)
    name = given.pop("name", None)
    if name not in effect_names():
        near = nearest(str(name), effect_names())
        raise file.error(
            f"there is no effect '{name}'.",
            f"Did you mean '{near}'?" if near else f"Registered: {', '.join(effect_names())}.",
            "effects",
        )
    limbs = given.pop("limbs", None)
    limb = given.pop("limb", None)
    chosen = [limb] if limb is not None else list(limbs or range(1, mechanism.limbs + 1))
    tools = given.pop("tools", None) or ([given.pop("tool")] if "tool" in given else [])
    if any(not 1 <= i <= mechanism.limbs for i in chosen):
        raise file.error(f"{name}: limbs are counted from 1 to {mechanism.limbs}.", "Correct limb or limbs.", "effects")
    term = blank(name, chosen, (), tools, lacks(name, mechanism, mechanism.moves(robot), mechanism.roles(robot)))
    rows, values, kernels = len(term.values), term.values, term.kernels
    known = [*kernels.COEFFICIENTS, *kernels.CONSTANTS]
    for key in given:
        if key not in [k for k, *_ in known]:
            raise file.error(
                f"the effect '{name}' has no parameter '{key}' on {mechanism.name}; "
                f"it has {', '.join(k for k, *_ in known)}.",
                "Correct the name.",
                "effects",
            )
    factors = row_factors(term, mechanism.joint_unit)
    for c, (key, *_) in enumerate(kernels.COEFFICIENTS):
        value = np.asarray(given.get(key, 0.0), dtype=float)
        if value.ndim and len(value) != rows:
            raise file.error(
                f"{name}: {key} needs one number, or one for each of {rows} limbs.", "Correct it.", "effects"
            )
        values[:, c] = value * factors[:, c]
    columns = [key for kind, key in kernels.SEARCHED.items() if kind in ("columns", "clocks")]
    given = {kernels.SEARCHED["clocks"]: LOGGED} | given if "clocks" in kernels.SEARCHED else given
    missing = [key for key, *_ in kernels.CONSTANTS if key not in given]
    if missing:
        raise file.error(f"the effect '{name}' needs {', '.join(missing)}.", "Add it.", "effects")
    of = constants_of(term, mechanism.joint_unit)
    constants = tuple(scaled(_constant(given[key], key in columns), factor) for key, _, factor in of)
    return dataclasses.replace(term, constants=constants)


def _constant(value: object, named: bool) -> float | str:
    """Return a constant as a truth gives it: the name of a column, or a number."""
    if named and isinstance(value, str):
        return value
    if not named and isinstance(value, int | float):
        return float(value)
    raise TypeError


def simulate(
    robot: Robot,
    poses: Recording,
    errors: dict[str, float] | None = None,
    *,
    noise: float = 0.0,
    noise_mm: float = 0.0,
    noise_rad: float = 0.0,
    rng: np.random.Generator | None = None,
    terms: Sequence[Term] = (),
    frame: tuple[Array, Array] | None = None,
) -> Recording:
    """Return the recording that an instrument would make.

    Parameters
    ----------
    robot : Robot
        Nominal machine: it commands the joints where `poses` gives targets; its own errors are not among the truth.
    poses : Recording
        Joints, or targets in {O} for the reference point of each row; kind and frame of the measurement. Its measured
        cells are not read.
    errors : dict, optional
        True source errors [mm, rad]; default the robot's own.
    noise : float
        Standard deviation per coordinate in the unit of the readings' file: mm, px, deg. Rotations beside lengths have
        that of the sidecar, or where it says none what `TURN_MM` from the measured point is such a shift. What the
        sidecar does not say of it the recording's says then; `rng` must be given.
    noise_mm, noise_rad : float
        Instead of it, at the platform: of images at the ball or board.
    terms : sequence of Term
        Effects on the machine; compliant parts are solved to their static equilibrium.
    frame : (rotation vector (3,) [rad], origin (3,) [mm]), optional
        {O} in the instrument's frame, where that is not the robot's; default drawn from `rng`, or a fixed one.

    Raises
    ------
    NoSolutionError
        A target or a pose cannot be reached; the message names the line.
    """
    mechanism = mechanism_of(robot)
    true = mechanism.vector(robot.errors if errors is None else errors)
    tool = measured_points(robot, poses)
    joints = poses.joints
    if poses.targets is not None:
        theta, status = nominal_joints(robot, poses.targets, tool)
        _all_solved(poses, status, "the target cannot be commanded")
        joints = robot.joint_sign * theta
    commanded = with_motion(dataclasses.replace(poses, joints=joints, begun=0.0))  # a truth counts as its poses do
    body = Body(robot, mechanism, robot.joint_sign * joints, np.ascontiguousarray(tool), Channels.of(commanded, robot))
    for term in terms:
        if why := body.missing(term):
            raise MissingChannel(f"the effect '{term.effect}' needs {why}.", "Add it.", file=poses.path)
    machine, status = body.solve(true, terms)
    _all_solved(poses, status, "the pose cannot be simulated")
    x = machine.x
    found = kind_of(poses.kind).unread(poses)
    if found.kind.sees_joints:
        x = body.theta(machine.q, machine.rows)
    instrument = found.kind.drawn(poses, robot, x, frame, rng).mounted(mechanism, true)
    values, rotations = instrument.predict(found, x)
    values = values + reading_shift(terms, body, found, values, x)[0]
    unit, length = instrument.unit(poses.columns or found.kind.columns(mechanism)) or ("mm", 1.0)
    noise_mm = noise_mm or noise * length
    if noise and rotations is not None:
        noise_rad = noise_rad or poses.measurement.sigma_rad or noise_mm / TURN_MM
    if (noise_mm or noise_rad) and rng is None:
        raise ValueError("noise needs a random generator: pass rng.")
    if noise_mm and rng is not None:
        values = values + noise_mm / instrument.at_platform[: values.shape[1]] * rng.standard_normal(values.shape)
    if rotations is not None and noise_rad and rng is not None:
        rotations = from_vector(noise_rad * rng.standard_normal((len(values), 3))) @ rotations
    x = machine.x
    truth = {
        f"{TRUTH}{turn}": column / DEG
        for turn, column in zip(ROTATION, to_vector(x[:, 3:].reshape(-1, 3, 3)).T, strict=True)
    }
    measurement = dataclasses.replace(poses.measurement, kind=poses.kind)
    if noise_mm and found.kind.sigma(measurement, instrument.scale) is None:
        measurement = measurement.with_noise(unit, noise or noise_mm / length)
    if noise_rad and rotations is not None and measurement.sigma_deg is None:
        measurement = measurement.with_noise("deg", noise_rad / DEG)
    done = dataclasses.replace(
        poses, joints=joints, targets=None, measurement=measurement, channels={**poses.channels, **truth}
    )
    return found.kind.with_values(done, found, values, rotations)


def _all_solved(poses: Recording, status: np.ndarray, what: str) -> None:
    bad = np.flatnonzero(status != SOLVED)
    if len(bad):
        lost = status[bad[0]] == UNDEFINED
        raise OutOfReach(
            f"{poses.path}, line {int(poses.line[bad[0]])}: {what}: {STATUS[int(status[bad[0]])]}"
            + (f" ({len(bad)} rows in all)." if len(bad) > 1 else ".")
            + (" Remove the row, or the effect." if lost else " Move the row into the workspace or remove it.")
        )
