"""Prediction: what an identified machine would read at other joints, in the instrument's frame."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from deltacal_gen.diagnosis.correction import Smooth, variable
from deltacal_gen.errors import InputError
from deltacal_gen.estimation.estimation import Problem, pose_problem
from deltacal_gen.files.recording import Measurement, Recording
from deltacal_gen.files.robot import Robot, robot_of
from deltacal_gen.instrument.instrument import Instrument
from deltacal_gen.instrument.kinds import instrument_of, kind_of
from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.physics.physics import Term, of_reading, reading_shift, term_of
from deltacal_gen.results.diagnosis import Diagnosis, SmoothCorrection
from deltacal_gen.results.parts import MachineState
from deltacal_gen.results.result import Result

Known = Result | Diagnosis | MachineState  # of a machine: what is predicted from
CORRECTED = "correction_share"  # channel of a prediction
COMMAND_STEPS = 20
COMMAND_SETTLED_MM = 1e-7  # by which a command with a smooth correction may still miss


def calibrated_robot(result: Known) -> Robot:
    """Return the calibrated robot of a result."""
    return robot_of(result.robot)


def known_effects(result: Known, *, timed: bool) -> list[Term]:
    """Return the effects that a result knows as they act on other readings.

    Parameters
    ----------
    timed : bool
        Whether the other readings tell their time. Without it, and where a jump was found by its row, they come after
        all rows that the jump was found in.
    """
    held = [term_of(t) for t in result.physics or ()]
    if result.clock == "row" or not timed:
        held = [t.afterwards() for t in held]
    return held


def predict(result: Known, recording: Recording) -> Recording:
    """Return the recording with its measured cells as the identified model predicts them.

    Parameters
    ----------
    result : Result or Diagnosis
    recording : Recording
        Joints, tool points and channels; its measured cells are not read.

    Returns
    -------
    Recording
        Where a diagnosis has a smooth correction, the channel `correction_share` says which part of it holds in each
        row: 1 where readings like it were measured, 0 far from them, where nothing is corrected.

    Raises
    ------
    InputError
        A set-up of the recording whose frame the result does not know, a channel that an effect reads and that is not
        given, or a pose that cannot be.
    """
    robot = calibrated_robot(result)
    problem, instrument = prediction_problem(result, robot, recording)
    x = problem.poses(problem.reference)
    values, rotations = _read(problem, instrument, x)
    if (correction := result.correction) is not None:
        share, corrected, seen, moved = _corrected(result, correction, recording, x)
        other, turned = _read(corrected, seen, moved)
        each = share[problem.readings.rows].min(axis=1)[:, None]
        values = values + each * (other - values)
        if rotations is not None and turned is not None:
            rotations = from_vector(each * to_vector(turned @ np.swapaxes(rotations, 1, 2))) @ rotations
        recording = dataclasses.replace(recording, channels=recording.channels | {CORRECTED: share})
    return problem.readings.kind.with_values(recording, problem.readings, values, rotations)


def corrected_joints(
    result: Known,
    correction: SmoothCorrection,
    joints: Array,
    tool: Array | None,
    channels: Mapping[str, Array | float],
) -> tuple[Array, Array]:
    """Return commands (N, n_q) that undo a smooth correction too, and which part (N,) of it they undo.

    Parameters
    ----------
    joints : (N, n_q) array
        Commands that bring the machine to its targets but for the correction, as the controller counts.
    tool : (3,) or (N, 3) array, optional
    channels : mapping of (N,) arrays or numbers
        Of each command, by the names of the recording's columns.

    Notes
    -----
    Newton's method with the Jacobian of the machine without the correction, on positions as the instrument reads them:
    both descriptions of the machine are fitted in that frame.
    """
    robot, n = calibrated_robot(result), len(joints)
    mechanism = mechanism_of(robot)
    commands = Recording(
        path=Path("targets"),
        kind="position",
        measurement=Measurement(kind="position", frame="unknown"),
        joint_unit=mechanism.joint_unit,
        joints=joints,
        columns=tuple(f"{axis}_mm" for axis in mechanism.axes),
        measured=np.full((n, len(mechanism.axes)), np.nan),
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        channels={k: np.broadcast_to(np.asarray(v, dtype=float), (n,)) for k, v in channels.items()},
        setup=np.zeros(n, dtype=int),
        setup_names=result.instrument.setups[:1],
        tool=None if tool is None else np.broadcast_to(tool, (n, 3)),
    )
    problem, instrument = prediction_problem(result, robot, commands)
    rows = mechanism.rows(robot)
    wanted, _ = _read(problem, instrument, problem.poses(problem.reference))
    turn, tool = instrument.state[0, :9].reshape(3, 3), problem.body.tool
    for _ in range(COMMAND_STEPS):
        at = dataclasses.replace(commands, joints=joints)
        plain, seen = prediction_problem(result, robot, at)
        x = plain.poses(plain.reference)
        reached, _ = _read(plain, seen, x)
        share, beside, other, moved = _corrected(result, correction, at, x)
        reached = reached + share[:, None] * (_read(beside, other, moved)[0] - reached)
        miss = (reached - wanted) @ turn
        joints = joints + robot.joint_sign * mechanism.undo(miss, x, plain.body.q, tool, rows)
        if np.abs(mechanism.asked(miss)).max() < COMMAND_SETTLED_MM:
            break
    return joints, share


def _read(problem: Problem, instrument: Instrument, x: Array) -> tuple[Array, Array | None]:
    values, rotations = instrument.mounted(problem.mechanism, problem.reference).predict(problem.readings, x)
    return values + reading_shift(of_reading(problem.held), problem.body, problem.readings, values, x)[0], rotations


def _corrected(
    result: Known, correction: SmoothCorrection, recording: Recording, x: Array, found: Readings | None = None
) -> tuple[Array, Problem, Instrument, Array]:
    """Return which part (N,) of a smooth correction holds in each row, and all that a reading with it comes from.

    `x` are the poses without it.
    """
    machine, smooth = correction.machine, Smooth.of(correction.smooth)
    beside = result.replace(robot=machine.robot, physics=machine.physics, instrument=machine.instrument)
    robot = calibrated_robot(beside)
    values = variable(smooth.variable, recording, robot.joint_sign * recording.joints, x)
    values = np.full((len(x), smooth.knots.shape[1]), np.nan) if values is None else values
    moved = np.nan_to_num(smooth.displacement(values))
    if smooth.limbs:
        joints = recording.joints.copy()
        own = [i - 1 for i in smooth.limbs]
        joints[:, own] += np.broadcast_to(robot.joint_sign, joints.shape)[:, own] * moved
        recording = dataclasses.replace(recording, joints=joints)
    problem, instrument = prediction_problem(beside, robot, recording, found)
    x = problem.poses(problem.reference)
    if not smooth.limbs:
        x = np.hstack([x[:, :3] + moved, x[:, 3:]])
    return smooth.share(values), problem, instrument, x


def prediction_problem(
    result: Known,
    robot: Robot,
    recording: Recording,
    found: Readings | None = None,
) -> tuple[Problem, Instrument]:
    """Return the problem of a recording with nothing free, and the instrument that a result knows for it."""
    found = kind_of(recording.kind).unread(recording) if found is None else found
    found, instrument = _instrument(result, robot, recording, found)
    held = known_effects(result, timed=recording.time_s is not None)
    problem = pose_problem(robot, recording, (), found=found, held=held)
    for term in held:
        if why := problem.body.missing(term.effect):
            raise InputError(
                f"what was diagnosed ({term.effect}) needs {why}.",
                "Add it, with the values at which the readings are to be predicted.",
                file=recording.path,
            )
    return problem, instrument


def _instrument(result: Known, robot: Robot, recording: Recording, found: Readings) -> tuple[Readings, Instrument]:
    def poses() -> Array:
        held = known_effects(result, timed=recording.time_s is not None)
        problem = pose_problem(robot, recording, (), found=found, held=held)
        return problem.poses(problem.reference)

    if (own := found.kind.own(found, recording, robot, poses)) is not None:
        return found, own
    given = instrument_of(result.instrument)
    if (instrument := found.kind.like(given, recording)) is None:
        raise InputError(
            f"the result was identified from readings of the kind '{given.kind.name}' and knows no frame for "
            f"'{found.kind.name}'.",
            f'Give readings of the kind {given.kind.name}, or say frame = "robot" in the sidecar.',
            file=recording.path,
        )
    names = result.instrument.setups
    missing = [n for n in recording.setup_names if n not in names]
    if missing and not (len(names) == 1 and len(recording.setup_names) == 1):
        raise InputError(
            f"the result knows no frame of the set-up '{missing[0]}'; it knows {', '.join(names)}.",
            "Identify with readings of that set-up too.",
            file=recording.path,
            column="setup",
        )
    index = np.array([names.index(n) if n in names else 0 for n in recording.setup_names])
    return dataclasses.replace(found, setup=index[found.setup]), instrument


def residual(result: Known, recording: Recording, found: Readings) -> Array:
    """Return measured minus predicted (R, k) of readings that the result has not seen [mm, rad]."""
    problem, instrument = prediction_problem(result, calibrated_robot(result), recording, found)
    x = problem.poses(problem.reference)
    r = problem.residual(problem.reference, instrument, x)
    if (correction := result.correction) is not None:
        share, other, seen, moved = _corrected(result, correction, recording, x, found)
        r += share[found.rows].min(axis=1)[:, None] * (other.residual(other.reference, seen, moved) - r)
    return r
