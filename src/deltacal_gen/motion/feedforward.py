"""What drives must be told along a trajectory: commanded joints, and the torque that the identified machine asks for.

Friction at rest is not known: inside the speed below which a joint of the recording counted as at rest
(`JointModel.at_rest_below`), what depends on the speed goes straight from its value at one end to that at the other.
A joint that stands gets the mean of both, and nothing jumps where it turns back. A reading that lags (`latency`) is the
reading's own affair: drives are told what they must give now.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import ImpossiblePose, TooFewReadings
from deltacal_gen.files.robot import robot_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.motion.derivatives import motion
from deltacal_gen.motion.library import of_joint
from deltacal_gen.motion.limits import PATTERNS
from deltacal_gen.motion.prediction import given_by_drive, known_beforehand, remembered
from deltacal_gen.motion.rigid import Rigid
from deltacal_gen.motion.trajectories import Readout, Trajectories, readouts_of
from deltacal_gen.results.motion import JointModel, MotionModel
from deltacal_gen.states import TIME
from deltacal_gen.units import joint_factors, joint_names

if TYPE_CHECKING:
    from deltacal_gen.files.columns import Columns
    from deltacal_gen.machine.registry import Array


@dataclass(frozen=True, eq=False)
class FeedForward:
    """Commands along a trajectory.

    Attributes
    ----------
    given : Trajectories
        What was asked for.
    states : (3, N, n_q) array
        Joints, velocities, accelerations, as the controller counts them [rad or mm, s].
    torque : (N, n_q) array
        What the drives must give, in `units`; nan of a joint that the model does not know, as it did not move.
    columns, units : tuple of str
    ramped : (n_q,) array of int
        Samples inside the speed in which friction is ramped.
    left : (n_q,) array
        By how much the curve whose derivatives are taken leaves the joints, at most [rad or mm].
    beyond : dict
        Column to how many samples ask for more than the robot file's [limits] allow.
    """

    given: Trajectories
    states: Array
    torque: Array
    columns: tuple[str, ...]
    units: tuple[str, ...]
    ramped: np.ndarray
    left: Array
    beyond: dict[str, int]

    @property
    def joints_in_files(self) -> Array:
        """Commanded joints (N, n_q) [deg or mm]."""
        return np.asarray(self.states[0] / joint_factors(self.given.joint_unit, self.states.shape[2]))

    def columns_of_file(self) -> Columns:
        """Return the columns of a file: times, commanded joints, their derivatives, torques."""
        unit, limbs = self.given.joint_unit, self.states.shape[2]
        factors = joint_factors(unit, limbs)
        found: Columns = {}
        if self.given.run_names != ("1",):
            found["run"] = [self.given.run_names[code] for code in self.given.run]
        found[TIME] = self.given.time
        for values, pattern in zip(self.states, PATTERNS, strict=True):
            found |= dict(zip(joint_names(unit, limbs, pattern), (values / factors).T, strict=True))
        return found | dict(zip(self.columns, self.torque.T, strict=True))


def fed_forward(known: MotionModel, given: Trajectories) -> FeedForward:
    """Return what drives must be told along a trajectory; its readings, if it has any, are not read.

    Raises
    ------
    InputError
        The trajectory goes where the machine cannot stand, or an effect needs a channel that it does not hold.
    """
    robot = robot_of(known.robot)
    rigid, found = Rigid(robot), motion(given)
    if (lost := ~np.isfinite(found.states).all(axis=(0, 2))).any():
        raise TooFewReadings(
            "the joints' velocities cannot be made: the movement is too short, or cut here.",
            'Give longer movements, or qd and qdd with [motion] derivatives = "recorded".',
            file=given.path,
            line=int(given.line[np.argmax(lost)]),
        )
    states, limbs = found.states, given.joints.shape[1]
    models = {model.joint: model for model in known.joints}
    chosen = [models[j + 1].columns if j + 1 in models else () for j in range(limbs)]
    columns = rigid.columns(states, [np.array(some, dtype=int) for some in chosen])
    payload = known_beforehand(known, rigid, states, given)
    if (lost := ~np.isfinite(payload).all(axis=1)).any():
        raise ImpossiblePose(
            "the machine cannot stand at these joints: its loops do not close, or it is singular.",
            "Keep the trajectory within the workspace.",
            file=given.path,
            line=int(given.line[np.argmax(lost)]),
        )
    units, readouts = readouts_of_model(known)
    torque = np.full((len(given.time), limbs), np.nan)
    ramped = np.zeros(limbs, dtype=int)
    for j, model in models.items():
        own = columns[j - 1], payload[:, j - 1], readouts[j - 1]
        torque[:, j - 1] = _ramped(model, given, states, *own) / readouts[j - 1].inside
        ramped[j - 1] = int((np.abs(states[1, :, j - 1]) < model.at_rest_below).sum())
    left = np.abs(states[0] - given.joints).max(axis=0)
    asked = np.stack([given.joints, *states[1:]])  # a drive goes where it is asked to, not where a curve goes
    done = FeedForward(given, asked, torque, known.columns, units, ramped, left, {})
    return dataclasses.replace(done, beyond=_beyond(done, robot.limits))


def readouts_of_model(known: MotionModel) -> tuple[tuple[str, ...], tuple[Readout, ...]]:
    """Return the units of the readings that a model predicts, joint by joint, and how they are read."""
    robot = robot_of(known.robot)
    units = tuple(column.rpartition("_")[2] if "_" in column else "1" for column in known.columns)
    constants = None if robot.transmission is None else robot.transmission.torque_constant_Nm_A
    return units, readouts_of(mechanism_of(robot).joint_unit, units, constants)


def _ramped(
    model: JointModel, given: Trajectories, states: Array, columns: Array, known: Array, readout: Readout
) -> Array:
    """Return what a joint's drive gives (N,), what depends on its speed ramped near rest; in units inside."""
    j, edge = model.joint - 1, model.at_rest_below
    speed, read = states[1, :, j], of_joint(given, states, j)
    past = remembered(model, read, given)
    if edge <= 0 or (np.abs(speed) >= edge).all():
        return given_by_drive(model, read, past, columns, known, readout)
    ends = []
    for side in (-1.0, 1.0):
        at = states.copy()
        at[1, :, j] = np.where(np.abs(speed) < edge, side * edge, speed)
        ends.append(given_by_drive(model, of_joint(given, at, j), past, columns, known, readout))
    part = np.clip((speed + edge) / (2 * edge), 0.0, 1.0)
    return np.asarray((1 - part) * ends[0] + part * ends[1])


def _beyond(done: FeedForward, limits: dict[str, tuple[float, float]]) -> dict[str, int]:
    """Return how many samples lie beyond the limits of a column of the file, of those that have some."""
    found = {}
    for name, values in done.columns_of_file().items():
        if name in limits:
            low, high = limits[name]
            if count := int(((np.asarray(values) < low) | (np.asarray(values) > high)).sum()):
                found[name] = count
    return found
