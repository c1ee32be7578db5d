"""Joints that are gone through and reached from either side: one axis in cycles, joints behind second encoders.

What such readings tell is what the transmission does, and that shows by the side from which a joint comes. One axis
goes forth and back through positions that are unevenly spaced, so that no period of its drive hides between them, as
ISO 230-2 has it: at least five a metre, each five times from either side. Several joints go to places spread over their
ranges, each place once from one side and once from the other; which joints come from the same side changes from place
to place, so that no joint passes for another.
"""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deltacal_gen.errors import MissingKey, OptionNotApplicable, ValueOutOfRange
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.writing import write_recording
from deltacal_gen.identification.accuracy import joint_spread
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import POSITION, Measurement, Recording
from deltacal_gen.planning.matrix import generic
from deltacal_gen.planning.rows import blank_recording, joints_in_files, readable
from deltacal_gen.results.plan import CyclePlan, Visit

POSITIONS, PER_METRE, CYCLES = 11, 5, 5  # of one axis, at least; ISO 230-2:2014, section 4.3.2
PLACES = 30  # of several joints
ROOM = 0.02  # of an axis' range, at either end: to come from beyond the last position
UNEVEN = 0.3  # of the distance between two positions, by which they are off an even row
GOLDEN = (math.sqrt(5) - 1) / 2


@dataclass(frozen=True, eq=False)
class BothSides:
    """Rows to be measured, in their order.

    Attributes
    ----------
    joints : (R, n_q) array
        As the controller counts [rad or mm].
    approach : (R, n_q) int array
        From which side each joint comes: 1 where it grows.
    cycle : (R,) int array or None
        Counted from 1; None of several joints.
    positions : int
    """

    robot: Robot
    kind: str
    joints: Array
    approach: np.ndarray
    cycle: np.ndarray | None
    positions: int

    @property
    def words(self) -> str:
        """How they were chosen."""
        if self.cycle is not None:
            return (
                f"{self.positions} positions, unevenly spaced, in {self.cycle.max()} cycles forth and back; go beyond "
                "the last one at either end and come back."
            )
        return f"{self.positions} places, each reached from either side of every joint."

    def recording(self, path: str | Path = "poses.csv") -> Recording:
        """Return the rows as a recording in which nothing was read yet."""
        mechanism = mechanism_of(self.robot)
        columns = kind_of(self.kind).columns(mechanism)
        if len(mechanism.joint_units) == 1 and mechanism.joint_unit == "mm" and not kind_of(self.kind).sees_joints:
            columns = (self._along(),)
        channels = {} if self.cycle is None else {"cycle": self.cycle.astype(float)}
        channels |= {f"approach{j + 1}": side.astype(float) for j, side in enumerate(self.approach.T)}
        said = Measurement(kind=self.kind)
        return blank_recording(self.robot, self.kind, self.joints, columns, said, path, channels=channels)

    def _along(self) -> str:
        """Return the coordinate along which the axis moves most, which alone is read."""
        mechanism = mechanism_of(self.robot)
        ends = self.robot.joint_sign * np.array([self.joints.min(axis=0), self.joints.max(axis=0)])
        x, _ = mechanism.forward(ends, self.robot.tool, mechanism.rows(self.robot))
        return POSITION[int(np.argmax(np.abs(np.diff(x[:, :3], axis=0)[0])))]

    def answer(self) -> CyclePlan:
        """Return the same as users read it."""
        cycles = [None] * len(self.joints) if self.cycle is None else self.cycle.tolist()
        return CyclePlan(
            robot=self.robot.name,
            mechanism=self.robot.mechanism,
            kind=self.kind,
            positions=self.positions,
            cycles=None if self.cycle is None else int(self.cycle.max()),
            conventions=self.words,
            poses=tuple(
                Visit(approach=tuple(side), cycle=cycle, **joints)
                for joints, side, cycle in zip(
                    joints_in_files(self.robot, self.joints), self.approach.tolist(), cycles, strict=True
                )
            ),
        )


def plan_both_sides(robot: Robot, kind: str, positions: int | None = None, cycles: int | None = None) -> BothSides:
    """Return joints of one axis in cycles, or of several over their ranges, each reached from either side.

    Raises
    ------
    InputError
        Nothing says how far the joints go.
    UsageError
        Too few positions or cycles, or cycles of several joints.
    """
    if (positions is not None and positions < 2) or (cycles is not None and cycles < 2):
        raise ValueOutOfRange("what is repeated has a spread only from 2 positions and 2 cycles on.")
    if mechanism_of(robot).limbs == 1:
        return _cycles(robot, kind, positions, cycles or CYCLES)
    if cycles is not None:
        raise OptionNotApplicable("cycles are of one axis; give --positions for several joints.")
    joints = readable(_spread(robot, positions or PLACES), mechanism_of(robot).joint_units)
    k = np.arange(1, len(joints) + 1)[:, None]
    sides = np.where((k * np.sqrt(np.arange(2, joints.shape[1] + 2)) * GOLDEN) % 1 < 0.5, 1, -1)
    approach = np.stack([sides, -sides], axis=1).reshape(-1, joints.shape[1])
    return BothSides(robot, kind, np.repeat(joints, 2, axis=0), approach, None, len(joints))


def _cycles(robot: Robot, kind: str, positions: int | None, cycles: int) -> BothSides:
    (low, high), unit = _limits(robot)[0], mechanism_of(robot).joint_unit
    count = positions or max(POSITIONS, math.ceil(PER_METRE * (high - low) / 1000) if unit == "mm" else 0)
    room, k = ROOM * (high - low), np.arange(count)
    part = (k + UNEVEN * ((k * GOLDEN) % 1)) / (count - 1 + UNEVEN)
    forth = readable((low + room + (high - low - 2 * room) * part)[:, None], mechanism_of(robot).joint_units)
    joints = np.tile(np.vstack([forth, forth[::-1]]), (cycles, 1))
    approach = np.tile(np.repeat([[1], [-1]], count, axis=0), (cycles, 1))
    return BothSides(robot, kind, joints, approach, np.repeat(np.arange(1, cycles + 1), 2 * count), count)


def _spread(robot: Robot, count: int) -> Array:
    """Return joints (count, n_q) as the controller counts, all over their ranges or the workspace."""
    mechanism = mechanism_of(robot)
    if mechanism.many_ways:
        return joint_spread(robot, count)
    if robot.workspace is None or not robot.drawn:
        _limits(robot)
        return joint_spread(dataclasses.replace(robot, workspace=None), count)
    joints: Array = generic(robot, robot.tool[None]).joints
    if count > len(joints):
        raise ValueOutOfRange(f"{len(joints)} places are spread over the workspace, fewer than {count}.")
    return joints[:count]


def _limits(robot: Robot) -> Array:
    if robot.joint_limits is None:
        raise MissingKey(
            "a plan needs to know how far the joints go.",
            "Add limits to [joints] in the robot file.",
            file=robot.source,
        )
    return robot.joint_limits


def write_rows(found: BothSides, path: str | Path) -> None:
    """Write the rows as a CSV with a sidecar, to be measured, simulated or studied.

    Raises
    ------
    InputError
        A file cannot be written.
    """
    write_recording(found.recording(path), path)
