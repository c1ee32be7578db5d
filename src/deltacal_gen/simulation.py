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

from deltacal_gen import sphere
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.measurement import BOTH, CONTACT, FRAMELESS, Instrument, Readings, both, frameless, home_of
from deltacal_gen.mechanism import SOLVED, STATUS, Array, Machine, mechanism_of, nominal_joints
from deltacal_gen.physics import Body, Channels, Term, blank, effect_names, load_effect, reading_shift, row_factors
from deltacal_gen.recording import Measurement, Recording
from deltacal_gen.robot import Number, Robot, Table, TomlFile, nearest
from deltacal_gen.rotation import from_vector, to_vector
from deltacal_gen.units import DEG, to_internal

VISIBLE = 0.9  # part of the half image that a simulated ball stays in


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
        if name not in units:
            near = nearest(name, units)
            raise file.error(
                f"{mechanism.name} has no parameter '{name}'.",
                f"Did you mean '{near}'?" if near else "See deltacal models for the names.",
                "parameters",
                name,
            )
    errors = {name: value * to_internal(units[name]) for name, value in truth.parameters.items()}
    return Truth(errors, tuple(_checked_term(file, table, mechanism) for table in truth.effects))


def truth_names(path: str | Path) -> tuple[str, ...]:
    """Return the source errors that a TRUTH.toml names, right or wrong: they tell which description of a machine."""
    return tuple(TomlFile.read(path).check(_Truth).parameters)


def _checked_term(file: TomlFile, table: dict[str, Any], mechanism: Machine) -> Term:
    try:
        term = _term(file, table, mechanism)
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


def _term(file: TomlFile, table: dict[str, Any], mechanism: Machine) -> Term:
    given = dict(table)
    name = given.pop("name", None)
    if name not in effect_names():
        near = nearest(str(name), effect_names())
        raise file.error(
            f"there is no effect '{name}'.",
            f"Did you mean '{near}'?" if near else f"Registered: {', '.join(effect_names())}.",
            "effects",
        )
    kernels = load_effect(name)
    limbs = given.pop("limbs", None)
    limb = given.pop("limb", None)
    chosen = [limb] if limb is not None else list(limbs or range(1, mechanism.limbs + 1))
    tools = given.pop("tools", None) or ([given.pop("tool")] if "tool" in given else [])
    if any(not 1 <= i <= mechanism.limbs for i in chosen):
        raise file.error(f"{name}: limbs are counted from 1 to {mechanism.limbs}.", "Correct limb or limbs.", "effects")
    term = blank(name, chosen, (), tools)
    rows, values = len(term.values), term.values
    known = [*kernels.COEFFICIENTS, *kernels.CONSTANTS]
    for key in given:
        if key not in [k for k, *_ in known]:
            raise file.error(
                f"the effect '{name}' has no parameter '{key}'; it has {', '.join(k for k, *_ in known)}.",
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
    missing = [key for key, *_ in kernels.CONSTANTS if key not in given]
    if missing:
        raise file.error(f"the effect '{name}' needs {', '.join(missing)}.", "Add it.", "effects")
    constants = tuple(float(given[key]) * factor for key, _, factor, _ in kernels.CONSTANTS)
    return dataclasses.replace(term, constants=constants)


def simulate(
    robot: Robot,
    poses: Recording,
    errors: dict[str, float] | None = None,
    *,
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
    noise_mm, noise_rad : float
        Standard deviation per coordinate, of images at the ball; `rng` must be given where they are not 0.
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
    tool = np.broadcast_to(robot.tool, (poses.n_rows, 3))
    if poses.tool is not None:
        tool = np.where(np.isfinite(poses.tool), poses.tool, tool)
    if poses.kind == "gauge" and poses.measurement.platform_point_mm is not None and poses.tool is None:
        tool = np.broadcast_to(np.asarray(poses.measurement.platform_point_mm), (poses.n_rows, 3))
    joints = poses.joints
    if poses.targets is not None:
        theta, status = nominal_joints(robot, poses.targets, tool)
        _all_solved(poses, status, "the target cannot be commanded")
        joints = robot.joint_sign * theta
    commanded = dataclasses.replace(poses, joints=joints)
    body = Body(robot, mechanism, robot.joint_sign * joints, np.ascontiguousarray(tool), Channels.of(commanded, robot))
    for term in terms:
        if why := body.missing(term.effect):
            raise InputError(f"the effect '{term.effect}' needs {why}.", "Add it.", file=poses.path)
    machine, status = body.solve(true, terms)
    _all_solved(poses, status, "the pose cannot be simulated")
    x = machine.x
    found = unread(poses)
    instrument = _instrument(poses, robot, x, frame, rng).mounted(mechanism, true)
    values, rotations = instrument.predict(found, x)
    values = values + reading_shift(terms, body, found, values, x)[0]
    if (noise_mm or noise_rad) and rng is None:
        raise ValueError("noise needs a random generator: pass rng.")
    if noise_mm and rng is not None:
        values = values + noise_mm / instrument.scale * rng.standard_normal(values.shape)
    if rotations is not None:
        if noise_rad and rng is not None:
            rotations = from_vector(noise_rad * rng.standard_normal((len(values), 3))) @ rotations
        values = np.hstack([values, to_vector(rotations)])
    if poses.kind in ("position", "pose"):
        values = values[:, list(poses.components)]
    if poses.kind == "gauge" and poses.measurement.zero == "incremental":
        values = values - values[0]
    truth = {
        f"true_r{axis}_deg": column / DEG
        for axis, column in zip("xyz", to_vector(x[:, 3:].reshape(-1, 3, 3)).T, strict=True)
    }
    measurement = dataclasses.replace(poses.measurement, kind=poses.kind)
    if noise_mm and poses.measurement.sigma_mm is None:
        measurement = dataclasses.replace(measurement, sigma_mm=noise_mm)
    done = dataclasses.replace(
        poses, joints=joints, targets=None, measurement=measurement, channels={**poses.channels, **truth}
    )
    return with_values(done, found, values)


def with_values(recording: Recording, found: Readings, values: Array) -> Recording:
    """Return a recording whose measured cells hold `values` (R, k) of all readings that `unread` lists."""
    if found.kind == "distance":
        return dataclasses.replace(recording, pair_measured=values[:, 0])
    if found.kind != BOTH:
        return dataclasses.replace(recording, measured=values)
    height = found.rows[:, 0] == found.rows[:, 1]
    measured = np.full((recording.n_rows, 1), np.nan)
    measured[found.rows[height, 0], 0] = values[height, 0]
    return dataclasses.replace(recording, measured=measured, pair_measured=values[~height, 1])


def unread(poses: Recording) -> Readings:
    """Return the readings that would be taken: every row, or every pair; heights at the rows that no pair names."""
    if poses.kind == CONTACT:
        raise InputError(
            "a contact reads nothing that could be simulated or predicted: its joints are the reading.",
            'Ask for the kind position, with frame = "robot" in the sidecar.',
            file=poses.path,
        )
    if poses.kind == "height" and poses.pairs is not None:
        own = np.isfinite(poses.measured[:, 0])
        own[np.setdiff1d(np.arange(poses.n_rows), poses.pairs)] = True
        rows, pairs = np.flatnonzero(own), np.arange(len(poses.pairs))
        count = len(rows) + len(pairs)
        return both(poses, rows, pairs, np.zeros(count), np.arange(count))
    if poses.kind == "distance":
        if poses.pairs is None:
            raise InputError("no pairs of poses are given.", "Add NAME.distances.csv.", file=poses.path)
        rows = poses.pairs
    else:
        rows = np.arange(poses.n_rows)[:, None]
    n = len(rows)
    setup = np.zeros(n, dtype=int) if poses.kind == "distance" else poses.setup
    zeros = np.zeros((n, {"position": 3, "pose": 3, "sphere": 4}.get(poses.kind, 1)))
    components = poses.components or tuple(range(6))
    return Readings(poses.kind, rows, zeros, None, setup, np.arange(n), np.arange(n), components=components)


def _instrument(
    poses: Recording, robot: Robot, x: Array, frame: tuple[Array, Array] | None, rng: np.random.Generator | None
) -> Instrument:
    """Return the instrument that will read: in the robot's frame, in the one given, or in one drawn at random."""
    if poses.kind in FRAMELESS:
        return frameless(BOTH if poses.kind == "height" and poses.pairs is not None else poses.kind)
    measurement: Measurement = poses.measurement
    if poses.kind == "gauge":
        return Instrument("gauge", np.array([[*(measurement.base_point_mm or (0.0, 0.0, 0.0)), 0.0]]), ())
    setups = int(poses.setup.max()) + 1
    if poses.kind == "sphere":
        return _camera(poses, x, setups, rng)
    turn, origin = np.tile(np.eye(3), (setups, 1, 1)), np.zeros((setups, 3))
    if frame is not None:
        turn[:], origin[:] = from_vector(frame[0]), frame[1]
    elif measurement.frame == "unknown" and rng is not None:
        vectors, origin = drawn_frames(poses, setups, rng)
        turn = from_vector(vectors)
    home = home_of(poses, robot)
    if any(home):
        origin[:] = 0.0
    state = np.hstack([turn.reshape(setups, 9), origin])
    if poses.kind == "pose":
        state = np.hstack([state, np.swapaxes(turn, 1, 2).reshape(setups, 9)])  # rotations about the instrument's axes
    return Instrument(poses.kind, state, (), home=home)


def drawn_frames(poses: Recording, setups: int, rng: np.random.Generator) -> tuple[Array, Array]:
    """Return where instruments of unknown frame stand: rotation vectors (setups, 3) [rad] and origins (setups, 3)."""
    moving = np.array([1.0, 1.0, 1.0] if 2 in poses.components else [0.0, 0.0, 1.0])  # in the plane: about z
    return 0.3 * rng.standard_normal((setups, 3)) * moving, 1000.0 * rng.standard_normal((setups, 3))


def _camera(poses: Recording, x: Array, setups: int, rng: np.random.Generator | None) -> Instrument:
    """Return a camera whose ball stands on its axis, as near as all poses still see the whole of it.

    Where the frame is unknown the camera is mounted some degrees off the sidecar's rotation.
    """
    camera = poses.measurement.camera
    assert camera is not None  # the recording was read
    off = 0.03 * rng.standard_normal(3) if rng is not None and poses.measurement.frame == "unknown" else np.zeros(3)
    turn = from_vector(off) @ from_vector(np.asarray(camera.rotation_deg) * DEG).T
    P = x[:, :3] @ turn.T
    away = P - (P.max(axis=0) + P.min(axis=0)) / 2
    slope = VISIBLE * np.array([camera.cx_px / camera.fx_px, camera.cy_px / camera.fy_px])  # the centre is about half
    reach = (np.abs(away[:, :2]) + 2 * camera.ball_radius_mm) / slope
    depth = max(float((reach + away[:, 2:]).max()), 4 * camera.ball_radius_mm + float(away[:, 2].max()))
    ball = turn.T @ ((P.max(axis=0) + P.min(axis=0)) / 2 + [0, 0, depth])
    state = np.tile(sphere.state(camera, turn, ball), (setups, 1))
    return Instrument("sphere", state, (), depth / np.sqrt(camera.fx_px * camera.fy_px))


def _all_solved(poses: Recording, status: np.ndarray, what: str) -> None:
    bad = np.flatnonzero(status != SOLVED)
    if len(bad):
        raise NoSolutionError(
            f"{poses.path}, line {int(poses.line[bad[0]])}: {what}: {STATUS[int(status[bad[0]])]}"
            + (f" ({len(bad)} rows in all)." if len(bad) > 1 else ".")
            + " Move the row into the workspace or remove it."
        )
