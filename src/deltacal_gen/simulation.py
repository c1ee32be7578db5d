"""Exact simulation: what an instrument would read on a machine with known errors.

The machine is solved on its closure, with no linearisation anywhere; noise comes from a Generator that is passed in.
"""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import Field

from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.measurement import KINDS, Instrument, Readings
from deltacal_gen.mechanism import SOLVED, STATUS, Array, load_mechanism
from deltacal_gen.recording import Measurement, Recording
from deltacal_gen.robot import Robot, Table, TomlFile, nearest
from deltacal_gen.rotation import cayley_matrix, from_vector, to_vector
from deltacal_gen.units import DEG, to_internal


class _Truth(Table):
    parameters: dict[str, float] = Field(default_factory=dict)
    effects: list[dict[str, Any]] = Field(default_factory=list)


def read_truth(path: str | Path, robot: Robot) -> dict[str, float]:
    """Return the source errors of a TRUTH.toml, in mm and rad.

    Raises
    ------
    InputError
        A parameter that the mechanism does not have, or an effect, which the simulation does not know.
    """
    file = TomlFile.read(path)
    truth = file.check(_Truth)
    mechanism = load_mechanism(robot.mechanism)
    if truth.effects:
        name = truth.effects[0].get("name", "?")
        raise file.error(
            f"the effect '{name}' cannot be simulated: no effects are registered for {mechanism.name}.",
            "Remove the [[effects]] tables; [parameters] are simulated exactly.",
            "effects",
        )
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
    return {name: value * to_internal(units[name]) for name, value in truth.parameters.items()}


def simulate(
    robot: Robot,
    poses: Recording,
    errors: dict[str, float] | None = None,
    *,
    noise_mm: float = 0.0,
    noise_rad: float = 0.0,
    rng: np.random.Generator | None = None,
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
        Standard deviation per coordinate; `rng` must be given where they are not 0.
    frame : (rotation vector (3,) [rad], origin (3,) [mm]), optional
        {O} in the instrument's frame, where that is not the robot's; default drawn from `rng`, or a fixed one.

    Raises
    ------
    NoSolutionError
        A target or a pose cannot be reached; the message names the line.
    """
    mechanism = load_mechanism(robot.mechanism)
    true = mechanism.vector(robot.errors if errors is None else errors)
    tool = np.broadcast_to(robot.tool, (poses.n_rows, 3))
    if poses.tool is not None:
        tool = np.where(np.isfinite(poses.tool), poses.tool, tool)
    if poses.kind == "gauge" and poses.measurement.platform_point_mm is not None and poses.tool is None:
        tool = np.broadcast_to(np.asarray(poses.measurement.platform_point_mm), (poses.n_rows, 3))
    joints = poses.joints
    if poses.targets is not None:
        nominal = mechanism.rows(dataclasses.replace(robot, errors={}))
        theta, _, status = mechanism.inverse(poses.targets, tool, nominal)
        _all_solved(poses, status, "the target cannot be commanded")
        joints = robot.joint_sign * theta
    x, status = mechanism.forward(robot.joint_sign * joints, tool, mechanism.rows(robot, true))
    _all_solved(poses, status, "the pose cannot be simulated")
    found = unread(poses)
    instrument = _instrument(poses, frame, rng)
    values, rotations = instrument.predict(found, x)
    if (noise_mm or noise_rad) and rng is None:
        raise ValueError("noise needs a random generator: pass rng.")
    if noise_mm and rng is not None:
        values = values + noise_mm * rng.standard_normal(values.shape)
    if rotations is not None:
        if noise_rad and rng is not None:
            rotations = from_vector(noise_rad * rng.standard_normal((len(values), 3))) @ rotations
        values = np.hstack([values, to_vector(rotations)])
    if poses.kind == "gauge" and poses.measurement.zero == "incremental":
        values = values - values[0]
    truth = {
        f"true_r{axis}_deg": column / DEG
        for axis, column in zip("xyz", to_vector(cayley_matrix(x[:, 3:6])).T, strict=True)
    }
    measurement = poses.measurement.model_copy(update={"kind": poses.kind})
    if noise_mm and poses.measurement.sigma_mm is None:
        measurement = measurement.model_copy(update={"sigma_mm": noise_mm})
    done = dataclasses.replace(
        poses, joints=joints, targets=None, measurement=measurement, channels={**poses.channels, **truth}
    )
    if poses.kind == "distance":
        return dataclasses.replace(done, pair_measured=values[:, 0])
    return dataclasses.replace(done, measured=values)


def unread(poses: Recording) -> Readings:
    """Return the readings that would be taken: every row, or every pair."""
    if poses.kind not in KINDS:
        raise InputError(
            f"readings of the kind '{poses.kind}' cannot be simulated yet.",
            f"Kinds: {', '.join(KINDS)}.",
            file=poses.path,
        )
    if poses.kind == "distance":
        if poses.pairs is None:
            raise InputError("no pairs of poses are given.", "Add NAME.distances.csv.", file=poses.path)
        rows = poses.pairs
    else:
        rows = np.arange(poses.n_rows)[:, None]
    n = len(rows)
    setup = np.zeros(n, dtype=int) if poses.kind == "distance" else poses.setup
    zeros = np.zeros((n, 3 if poses.kind in ("position", "pose") else 1))
    return Readings(poses.kind, rows, zeros, None, setup, np.arange(n), np.arange(n))


def _instrument(poses: Recording, frame: tuple[Array, Array] | None, rng: np.random.Generator | None) -> Instrument:
    """Return the instrument that will read: in the robot's frame, in the one given, or in one drawn at random."""
    if poses.kind == "distance":
        return Instrument("distance", np.zeros((1, 0)), ())
    measurement: Measurement = poses.measurement
    if poses.kind == "gauge":
        return Instrument("gauge", np.array([[*(measurement.base_point_mm or (0.0, 0.0, 0.0)), 0.0]]), ())
    setups = int(poses.setup.max()) + 1
    turn, origin = np.tile(np.eye(3), (setups, 1, 1)), np.zeros((setups, 3))
    if frame is not None:
        turn[:], origin[:] = from_vector(frame[0]), frame[1]
    elif measurement.frame == "unknown" and rng is not None:
        turn = from_vector(0.3 * rng.standard_normal((setups, 3)))
        origin = 1000.0 * rng.standard_normal((setups, 3))
    state = np.hstack([turn.reshape(setups, 9), origin])
    if poses.kind == "pose":
        state = np.hstack([state, np.swapaxes(turn, 1, 2).reshape(setups, 9)])  # rotations about the instrument's axes
    return Instrument(poses.kind, state, ())


def _all_solved(poses: Recording, status: np.ndarray, what: str) -> None:
    bad = np.flatnonzero(status != SOLVED)
    if len(bad):
        raise NoSolutionError(
            f"{poses.path}, line {int(poses.line[bad[0]])}: {what}: {STATUS[int(status[bad[0]])]}"
            + (f" ({len(bad)} rows in all)." if len(bad) > 1 else ".")
            + " Move the row into the workspace or remove it."
        )
