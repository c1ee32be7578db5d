"""Where a machine stands at targets, and what becomes of those that it does not reach."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.errors import NoPlan, WrongArray
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.accuracy import turned
from deltacal_gen.machine.registry import SOLVED, STATUS, Array, mechanism_of
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.planning.rows import readable
from deltacal_gen.units import file_unit, to_file

ASTRAY = "singular: the joints that stand for it do not lead back to it"
INWARDS = np.linspace(0.98, 0.3, 35)  # parts of the way from the centre at which a pose beyond limits is tried


@dataclass(frozen=True)
class Poses:
    """Poses to be measured, all of the first reference point, then the same joints for the next one.

    Attributes
    ----------
    joints : (P, n_q) array
        As the controller counts [rad or mm].
    targets, tool : (P, 3) arrays
        Nominal position of the reference point in {O}, and the reference point in {O'} [mm]. Of an open chain the
        joints are what is wanted, and the targets where they lead.
    x : (P, 12) array
        Platform poses of the machine as the robot file knows it: position [mm], then the rotation matrix by rows.
    points : int
        Number of reference points.
    """

    joints: Array
    targets: Array
    tool: Array
    x: Array
    points: int

    def __len__(self) -> int:
        return len(self.joints)


def reach(robot: Robot, targets: Array, tools: Array) -> tuple[Poses, np.ndarray]:
    """Return the poses that bring the first reference point to the targets, and which of them cannot be.

    Parameters
    ----------
    targets : (M, 3) array
        In {O} [mm], or poses (M, 12) of a platform that turns on command, which else is turned as `turned` has it; of
        an open chain joints (M, n_q), as the controller counts.
    tools : (T, 3) array
        Reference points in {O'} [mm]; the others are where the first one's joints bring them.

    Returns
    -------
    poses : Poses
        T blocks of M.
    status : (M,) array of str
        Why a target cannot be measured; "" where it can.
    """
    mechanism = mechanism_of(robot)
    targets, tools = np.atleast_2d(np.asarray(targets, dtype=float)), tools_of(tools)
    nominal, known = mechanism.rows(dataclasses.replace(robot, errors={})), mechanism.rows(robot)
    if mechanism.many_ways:
        theta = robot.joint_sign * targets
        at, solved = mechanism.forward(theta, tools[0], nominal)
        targets = at[:, :3]
    else:
        theta, _, solved = mechanism.inverse(turned(robot, targets), tools[0], nominal)
    why = np.array([STATUS[int(s)] if s != SOLVED else "" for s in solved], dtype=object)
    joints = robot.joint_sign * theta
    for row in np.flatnonzero(~within_limits(robot, joints) & (why == "")):
        why[row] = _beyond(robot, joints[row])
    theta = np.tile(np.where((why == "")[:, None], theta, 0.0), (len(tools), 1))
    tool = np.repeat(tools, len(targets), axis=0)
    x, status = mechanism.forward(theta, tool, known)
    where = x if not robot.errors else mechanism.forward(theta, tool, nominal)[0]
    lost = "not solved for the machine with the errors of the robot file" if robot.errors else ASTRAY
    for block in status.reshape(len(tools), -1):
        why[(block != SOLVED) & (why == "")] = lost
    points = where[:, :3].copy()
    points[: len(targets)] = targets[:, :3]
    return Poses(np.tile(joints, (len(tools), 1)), points, tool, x, len(tools)), why.astype(str)


def within_limits(robot: Robot, joints: Array) -> np.ndarray:
    """Return which joints (N, n_q), as the controller counts, stand within their limits (N,)."""
    if robot.joint_limits is None:
        return np.ones(len(joints), dtype=bool)
    low, high = robot.joint_limits.T
    inside: np.ndarray = ((joints >= low) & (joints <= high)).all(axis=1)
    return inside


def _beyond(robot: Robot, joints: Array) -> str:
    """Say which joint (of (n_q,)) stands beyond its limit, where, and what the limit is."""
    assert robot.joint_limits is not None
    low, high = robot.joint_limits.T
    past = np.maximum(low - joints, joints - high)
    k = int(np.argmax(past))
    unit = mechanism_of(robot).joint_units[k]
    limit = low[k] if joints[k] < low[k] else high[k]
    return (
        f"beyond the limits of the joints: joint {k + 1} would stand at {to_file(joints[k], unit):.4g} "
        f"{file_unit(unit)}, its limit is {to_file(limit, unit):.4g}"
    )


def fitting(robot: Robot, targets: Array, tools: Array, centre: Array) -> tuple[Poses, tuple[str, ...]]:
    """Return the poses at targets (M, 3) in {O} [mm], and in words what became of those where it may not stand.

    What is beyond the limits of a joint moves towards the centre (3,), and turns towards level, until it is not; where
    it is all the way, it is left out.

    Raises
    ------
    NoSolutionError
        A target is out of reach whatever the limits are, or most would be left out.
    """
    targets = turned(robot, targets)
    poses, why = reach(robot, targets, tools)
    bad = np.flatnonzero(why != "")
    if not len(bad):
        return poses, ()
    free = dataclasses.replace(robot, joint_limits=None, errors={})
    if (reach(free, targets[bad], tools)[1] != "").any():
        return reached_of(robot, targets, tools), ()
    placed, still = targets.copy(), bad
    for part in INWARDS:
        tried = _towards(robot, centre, targets[still], part)
        fine = reach(robot, tried, tools)[1] == ""
        placed[still[fine]] = tried[fine]
        still = still[~fine]
    if 2 * len(still) > len(targets):
        return reached_of(robot, targets, tools), ()
    left_out = set(still.tolist())
    notes = tuple(
        f"pose {row + 1} at {place_of(targets[row])} is {why[row]}; "
        + ("it is left out" if row in left_out else f"it is moved to {place_of(placed[row])}")
        for row in bad.tolist()
    )
    return reach(robot, np.delete(placed, still, axis=0), tools)[0], notes


def _towards(robot: Robot, centre: Array, targets: Array, part: float) -> Array:
    """Return targets (M, 3), or poses (M, 12), at a part of their way from the centre, and of their turn."""
    placed = readable_targets(robot, centre + part * (targets[:, :3] - centre))
    turns = to_vector(targets[:, 3:].reshape(-1, 3, 3))
    return placed if targets.shape[1] == 3 else np.hstack([placed, from_vector(part * turns).reshape(-1, 9)])


def readable_targets(robot: Robot, wanted: Array) -> Array:
    """Return targets, or joints of an open chain, as a person types them."""
    mechanism = mechanism_of(robot)
    return readable(wanted, mechanism.joint_units if mechanism.many_ways else ["mm"] * wanted.shape[1])


def place_of(target: Array) -> str:
    """Return a position (3,) in {O} [mm] as words."""
    return f"({', '.join(str(round(v)) for v in target[:3].tolist())}) mm"


def middle(robot: Robot, tools: Array) -> str:
    """Say where the machine stands in the middle of the joints' limits: there its workspace can be; "" without any."""
    if robot.joint_limits is None:
        return ""
    mechanism = mechanism_of(robot)
    theta = robot.joint_sign * robot.joint_limits.mean(axis=1)
    x, status = mechanism.forward(theta[None], tools_of(tools)[0], mechanism.rows(robot))
    if status[0] != SOLVED:
        return ""
    return f" In the middle of the limits of all joints it is at {place_of(x[0])}."


def reached_of(robot: Robot, targets: Array, tools: Array) -> Poses:
    """Return poses at targets (N, 3) [mm]; raise NoSolutionError, naming the first, where any is out of reach."""
    poses, why = reach(robot, targets, tools)
    bad = np.flatnonzero(why != "")
    if len(bad):
        x, y, z = poses.targets[bad[0]]
        raise NoPlan(
            f"the target ({x:.6g}, {y:.6g}, {z:.6g}) mm is {why[bad[0]]} ({len(bad)} of {len(why)} targets). "
            "Plan in a smaller workspace or turn the ring."
        )
    return poses


def tools_of(tools: Array | Sequence[Sequence[float]]) -> Array:
    """Return reference points as an array (T, 3) [mm]; raise UsageError where they have another shape."""
    points = np.atleast_2d(np.asarray(tools, dtype=float))
    if points.ndim != 2 or points.shape[1] != 3 or not len(points):
        raise WrongArray(f"reference points have the shape {points.shape}, but must have (T, 3): x, y, z in mm each.")
    return points
