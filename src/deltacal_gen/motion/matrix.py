"""The linear problem of a recording in motion itself: what inertial parameters ask of every drive, sample by sample."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import WrongUnit
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.rigid import base_of
from deltacal_gen.motion.session import Session
from deltacal_gen.motion.trajectories import INSIDE, Trajectories

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array


@dataclass(frozen=True, eq=False)
class Regressor:
    """The linear problem ``H p = r`` of the samples in motion, friction left out.

    Attributes
    ----------
    H : (rows, n) array
        What each inertial parameter asks of a drive, joint by joint, positive along its angle [Nm or N per unit].
    r : (rows,) array
        What the drive gave beyond the payload and the bodies that the robot file states.
    joint, line : (rows,) arrays of int
        Whose drive, from 1, and where in the file.
    names, units : tuple of str
        Of the parameters, actual minus robot file.
    base : tuple of (str, str)
        Name and combination of each base parameter that these samples know.
    unseen : tuple of str
        What they do not know, in words.
    """

    H: Array
    r: Array
    joint: np.ndarray
    line: np.ndarray
    names: tuple[str, ...]
    units: tuple[str, ...]
    base: tuple[tuple[str, str], ...]
    unseen: tuple[str, ...]


def regressor(robot: Robot, given: Trajectories) -> Regressor:
    """Return the linear problem of a recording.

    Raises
    ------
    InputError
        No joint moves for long enough, or what a drive gives per reading is not known.
    """
    if open_ := [c for c, read in zip(given.columns, given.readouts, strict=True) if not read.forces]:
        raise WrongUnit(
            f"{open_[0]} is no torque, and what it is per torque is not known: bodies of all joints have no common "
            "problem.",
            "Give torque_constant_Nm_A under [transmission]; identify says what each joint's reading knows by itself.",
            file=given.path,
            column=open_[0],
        )
    session = Session.of(robot, given)
    rigid = session.rigid
    every = [np.arange(len(rigid.names))] * len(session.joints)
    columns = rigid.columns(np.nan_to_num(session.motion.states), every)
    stated = np.nan_to_num(rigid.dynamics.stated(points=True))
    moving = session.moving
    inside = [INSIDE[joint.readout.told] for joint in moving]
    blocks = [columns[joint.number - 1][joint.rows] for joint in moving]
    size = [max(float(np.abs(Y).max()), 1e-300) for Y in blocks]
    base = base_of(np.concatenate([Y / s for Y, s in zip(blocks, size, strict=True)]))
    return Regressor(
        H=np.concatenate([Y / by for Y, by in zip(blocks, inside, strict=True)]),
        r=np.concatenate([(j.y - Y @ stated) / by for j, Y, by in zip(moving, blocks, inside, strict=True)]),
        joint=np.concatenate([np.full(len(joint.rows), joint.number) for joint in moving]),
        line=np.concatenate([given.line[joint.rows] for joint in moving]),
        names=rigid.names,
        units=tuple(rigid.dynamics.units),
        base=tuple(rigid.words(base)),
        unseen=tuple(c.text for c in rigid.unseen(base)),
    )
