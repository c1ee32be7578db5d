"""A trajectory as commands need it: samples in time of joints, or of targets, which are brought to joints first."""

from __future__ import annotations

import dataclasses
from pathlib import Path

from deltacal_gen.files.robot import robot_of
from deltacal_gen.files.rows import Rows, read_table
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.feedforward import FeedForward, fed_forward
from deltacal_gen.motion.trajectories import Sidecar, read_sidecar, trajectories
from deltacal_gen.results.motion import MotionModel
from deltacal_gen.results.reader import TORQUE
from deltacal_gen.units import joint_factors, joint_names
from deltacal_gen.use.compensation import Compensator

TARGET = ("x_mm", "y_mm", "z_mm")


def feed_forward(known: MotionModel, path: str | Path) -> FeedForward:
    """Return commanded joints and torques along a trajectory: ``time_s``, and joints or targets.

    Targets are brought to joints by the geometry of the result's own robot, its source errors included.

    Raises
    ------
    InputError
        The file is no trajectory, or it goes where the machine cannot stand.
    NoSolutionError
        A target is out of reach.
    """
    robot, path = robot_of(known.robot), Path(path)
    mechanism, rows = mechanism_of(robot), read_table(path)
    if joint_names(mechanism.joint_unit, mechanism.limbs)[0] not in rows.columns and TARGET[0] in rows.columns:
        rows = _with_joints(rows, robot)
    sidecar = read_sidecar(path) or Sidecar.model_validate({"measurement": {"kind": TORQUE}})
    return fed_forward(known, trajectories(rows, mechanism, sidecar, need_measured=False))


def _with_joints(rows: Rows, robot: Robot) -> Rows:
    """Return the rows of targets with the joints that bring the reference point there, to the last digit."""
    mechanism = mechanism_of(robot)
    rows.require(*TARGET)
    joints = Compensator(robot).joints(rows.numbers(*TARGET, blank=False))
    names, factors = (
        joint_names(mechanism.joint_unit, mechanism.limbs),
        joint_factors(mechanism.joint_unit, mechanism.limbs),
    )
    cells = {name: [repr(v) for v in values] for name, values in zip(names, (joints / factors).T.tolist(), strict=True)}
    return dataclasses.replace(rows.without(TARGET), columns=rows.without(TARGET).columns | cells)
