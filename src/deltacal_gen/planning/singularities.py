"""How far positions lie from the singular ones, and positions at a wanted distance from them.

A position is regular where the nominal machine can take it and its closure's Jacobian by the platform has the sign that
it has in the middle of the workspace: out of the regular set leads only a singularity, either the stretched limb at the
edge of what can be reached (of the inverse position) or the platform that the rods no longer hold (of the forward
position). Joint limits are none.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.errors import NoPlan, NotForThisMachine, ValueOutOfRange
from deltacal_gen.files.robot import Robot, robot_size
from deltacal_gen.identification.accuracy import workspace_of
from deltacal_gen.machine.registry import SOLVED, Array, Machine, mechanism_of, nominal_joints
from deltacal_gen.machine.rotation import about_z
from deltacal_gen.planning.reach import within_limits

DIRECTIONS = 96  # in space, 20 deg apart: a distance is too large by 2 % at most; half as many in a plane
SHELLS = 5  # distances at which a direction is looked at, before it is halved
HALVINGS = 7
MARCH = 0.01  # of the machine's size: step along a ray
BLOCK = 20_000  # poses at once
ROUNDS = 20  # of rays before giving up


def distance(robot: Robot, targets: Array, upto: float) -> Array:
    """Return the distance (M,) from positions to the nearest singular one; inf where it is more than `upto` [mm].

    Parameters
    ----------
    targets : (M, 3) array
        Of the robot's reference point in {O} [mm].
    upto : float
        How far to look [mm].

    Raises
    ------
    UsageError
        An open chain or a single joint: positions do not say whether it is singular.
    """
    targets, directions = np.atleast_2d(np.asarray(targets, dtype=float)), _directions(_checked(robot))
    shells = upto * np.arange(1, SHELLS + 1) / SHELLS
    ends = targets[:, None, None] + shells[:, None] * directions[:, None]
    lost = ~_regular(robot, ends.reshape(-1, 3)).reshape(len(targets), len(directions), SHELLS)
    pose, way = np.nonzero(lost.any(axis=2))
    high = shells[lost[pose, way].argmax(axis=1)]
    low = high - shells[0]
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        held = _regular(robot, targets[pose] + middle[:, None] * directions[way])
        low, high = np.where(held, middle, low), np.where(held, high, middle)
    found = np.full((len(targets), len(directions)), np.inf)
    found[pose, way] = (low + high) / 2
    out: Array = np.where(_regular(robot, targets), found.min(axis=1), 0.0)
    return out


def near(robot: Robot, band: tuple[float, float], count: int, rng: np.random.Generator) -> Array:
    """Return positions (count, 3), drawn at random, whose nearest singularity is within a band of distances [mm].

    Rays leave the middle of the workspace in all directions; drawn are points before the end of a ray.

    Parameters
    ----------
    band : (float, float)
        Least and largest distance [mm]: (50, 100) in the paper.

    Raises
    ------
    UsageError
        See `distance`; a band that is none.
    NoSolutionError
        There are not so many.

    References
    ----------
    Traslosheros 2013, section 4: "if a pose is located between 5 and 10 cm from a singularity, then it is included".
    """
    least, largest = band
    if not 0 < least < largest:
        raise ValueOutOfRange(f"a band of distances from singularities is two lengths, the lesser first, not {band}.")
    mechanism, middle = _checked(robot), workspace_of(robot).home
    kept: list[Array] = []
    for _ in range(ROUNDS):
        rays = rng.standard_normal((2 * count, 3)) * [1.0, 1.0, "z" in mechanism.axes]
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        marks = np.arange(MARCH, 1.0, MARCH) * 2 * robot_size(robot)
        lost = ~_regular(robot, (middle + marks[:, None] * rays[:, None]).reshape(-1, 3)).reshape(len(rays), -1)
        ends = marks[np.where(lost.any(axis=1), lost.argmax(axis=1), len(marks) - 1)]
        drawn = middle + np.maximum(ends - rng.uniform(least, 2 * largest, len(rays)), 0.0)[:, None] * rays
        away = distance(robot, drawn, largest)
        q, status = nominal_joints(robot, drawn, robot.tool)
        commanded = (status == SOLVED) & within_limits(robot, robot.joint_sign * q)
        kept.append(drawn[(away >= least) & (away <= largest) & commanded])
        if sum(map(len, kept)) >= count:
            return np.vstack(kept)[:count]
    raise NoPlan(
        f"only {sum(map(len, kept))} of {count} positions between {least:g} and {largest:g} mm from a singularity were "
        "found within the limits of the joints."
    )


def _checked(robot: Robot) -> Machine:
    mechanism = mechanism_of(robot)
    if not mechanism.looped or mechanism.limbs < 2:
        raise NotForThisMachine(
            f"{mechanism.sort} is not singular by its position: distances from singularities need a parallel machine."
        )
    return mechanism


def _directions(mechanism: Machine) -> Array:
    """Return unit vectors (D, 3) spread evenly over the sphere, or over the circle of a planar machine."""
    if "z" not in mechanism.axes:
        turn = 2 * np.pi * np.arange(DIRECTIONS // 2) / (DIRECTIONS // 2)
        return np.column_stack([about_z(1.0, turn), 0 * turn])
    z = 1 - (2 * np.arange(DIRECTIONS) + 1) / DIRECTIONS
    turn = np.pi * (3 - np.sqrt(5)) * np.arange(DIRECTIONS)  # the golden angle
    return np.column_stack([about_z(np.sqrt(1 - z**2), turn), z])


def _regular(robot: Robot, targets: Array) -> np.ndarray:
    mechanism, middle = mechanism_of(robot), workspace_of(robot).home
    rows = mechanism.rows(dataclasses.replace(robot, errors={}))

    def sign(points: Array) -> Array:
        q, x, status = mechanism.inverse(points, robot.tool, rows)
        found = np.zeros(len(points))
        good = np.flatnonzero(status == SOLVED)
        if len(good):
            found[good] = np.sign(np.linalg.det(mechanism.jacobians(x[good], q[good], robot.tool, rows)[1]))
        return found

    wanted = sign(middle[None])[0]
    if wanted == 0:
        raise NoPlan("the machine cannot take the middle of its workspace: check [workspace] in the robot file.")
    parts = [sign(targets[n : n + BLOCK]) == wanted for n in range(0, len(targets), BLOCK)]
    return np.concatenate(parts) if parts else np.zeros(0, dtype=bool)
