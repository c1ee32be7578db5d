"""A trajectory as commands need it: samples in time of joints, or of targets, which are brought to joints first."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from deltacal_gen.errors import BadValue
from deltacal_gen.files.checks import impossible
from deltacal_gen.files.recording import targets_of
from deltacal_gen.files.robot import robot_of
from deltacal_gen.files.rows import Rows, read_table
from deltacal_gen.machine.registry import SOLVED, UNREACHABLE, Array, mechanism_of
from deltacal_gen.machine.values import ROTATION, Robot
from deltacal_gen.motion.feedforward import FeedForward, fed_forward
from deltacal_gen.motion.trajectories import Sidecar, read_sidecar, trajectories
from deltacal_gen.results.motion import MotionModel
from deltacal_gen.results.reader import TORQUE
from deltacal_gen.states import PAYLOAD
from deltacal_gen.units import joint_factors, joint_names, of_joints
from deltacal_gen.use.compensation import Compensator

TOLD = {"rad": 1e-5, "mm": 0.01}  # by which a curve leaves joints: a hundredth of a millimetre at a metre


def feed_forward(known: MotionModel, path: str | Path) -> FeedForward:
    """Return commanded joints and torques along a trajectory: ``time_s``, and joints or targets.

    Targets, with the rotation of a machine that turns on command, are brought to joints by the geometry of the result's
    own robot, its source errors included.

    Raises
    ------
    InputError
        The file is no trajectory, or it goes where the machine cannot stand.
    NoSolutionError
        A target is out of reach.
    """
    robot, path = robot_of(known.robot), Path(path)
    mechanism, rows = mechanism_of(robot), read_table(path)
    if joint_names(mechanism.joint_unit, mechanism.limbs)[0] not in rows.columns and (
        set(rows.columns) & {f"{axis}_mm" for axis in mechanism.axes}
    ):
        rows = _with_joints(rows, robot)
    sidecar = read_sidecar(path) or Sidecar.model_validate({"measurement": {"kind": TORQUE}})
    given = trajectories(rows, mechanism, sidecar, need_measured=False, asked=True)
    for name, values in given.channels.items():
        wrong, expected = impossible(name, values)
        if wrong.any():
            row = int(np.argmax(wrong))
            raise BadValue(f"{expected}.", "Correct the cell.", file=path, line=int(given.line[row]), column=name)
    return fed_forward(known, given)


def bent(found: FeedForward) -> str | None:
    """Return in words by how much the curve whose velocities are told leaves the joints; None where it goes through."""
    unit = found.given.joint_unit
    units = of_joints(unit, len(found.left))
    names, left = joint_names(unit, len(units)), found.left / joint_factors(unit, len(units))
    off = [f"{name} {v:.2g}" for name, v, own, u in zip(names, left, found.left, units, strict=True) if own > TOLD[u]]
    if not off:
        return None
    return (
        "joints are as asked for; velocities, accelerations and torques are those of a smooth curve, which leaves "
        f"the joints where they turn sharply, by up to: {', '.join(off)}. Give qd and qdd to have them as planned "
        '([motion] derivatives = "recorded")'
    )


def blanks(found: FeedForward) -> str | None:
    """Return in words in how many rows the payload is blank, of a file that has one; None where in none."""
    mass = found.given.channels.get(PAYLOAD)
    count = 0 if mass is None else int(np.isnan(mass).sum())
    return f"{PAYLOAD} blank in {count} of {len(found.torque)} rows: no payload is assumed" if count else None


def _with_joints(rows: Rows, robot: Robot) -> Rows:
    """Return the rows of targets with the joints that bring the reference point there, to the last digit."""
    mechanism = mechanism_of(robot)
    targets, others = targets_of(rows, mechanism)
    if turns := [name for name in ROTATION if name in others.columns]:
        raise rows.error(
            f"{mechanism.name} does not turn on command about this axis.", "Leave the column out.", column=turns[0]
        )
    compensator = Compensator(robot)
    near = _followed(compensator, targets, rows.labels("run", blank=False)) if mechanism.many_ways else None
    joints = compensator.joints(targets, near=near)
    names = joint_names(mechanism.joint_unit, mechanism.limbs)
    factors = joint_factors(mechanism.joint_unit, mechanism.limbs)
    cells = {name: [repr(v) for v in values] for name, values in zip(names, (joints / factors).T.tolist(), strict=True)}
    return dataclasses.replace(others, columns=others.columns | cells)


def _followed(compensator: Compensator, targets: Array, runs: Sequence[str] | None) -> Array:
    """Return joints (N, n_q) at which a chain stands along targets: it goes on standing as it stood, run by run.

    A start of its own has only the first target of each run, and one that does not follow from the one before it.
    """
    found = np.zeros((len(targets), compensator.mechanism.limbs))
    for k in range(len(targets)):
        at, status = targets[k : k + 1], np.array([UNREACHABLE])
        if k and (runs is None or runs[k] == runs[k - 1]):
            q, status = compensator.command(at, near=found[k - 1 : k])
        if status[0] != SOLVED:
            q, status = compensator.nominal_command(at)
        found[k] = q[0] if status[0] == SOLVED else found[k - 1]
    return found
