"""Poses for a printed board: points of it that the tip touches, and places from which a camera looks at it.

An open chain is aimed: from joints spread over their ranges each set moves, as little as need be, until the tip stands
on a point of the board, or the camera looks at its middle, tilted by some angle and from some distance. Where the board
lies is chosen among places before the machine: the one at which most of them arrive. A parallel machine touches a
lattice of its workspace's middle level; a camera on it sees a board below wherever it goes.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from deltacal_gen.errors import NoPlan
from deltacal_gen.files.robot import Robot, robot_size
from deltacal_gen.identification.accuracy import RECURRENCE, joint_spread, workspace_of
from deltacal_gen.instrument.board import nice
from deltacal_gen.machine.registry import SOLVED, Array, mechanism_of
from deltacal_gen.planning.reach import within_limits

PLACES, SPREAD = 12, 400  # of a board that are looked at; joints that set out to it
FEWEST = 40  # that must arrive
LATTICE = 5  # points to either side of the middle, of a parallel machine's workspace
PRINT = 3  # likewise of a print before an arm
STEPS, LONGEST = 15, 0.3  # of Gauss and Newton; rad, or tenths of a metre, that a joint goes in one
ARRIVED = 1e-7  # of the machine's size
MOVED = 1e-6  # rad, or tenths of a metre: of differences
NEAR, FAR = 0.75, 1.35  # of the usual distance, from which a board is looked at
REACH = 0.3  # of the machine's size: that distance; a print's points lie a tenth of it apart
TILTED = np.radians(35.0)  # at most


def touched(robot: Robot) -> Array:
    """Return joints (M, n_q) of an open chain, or positions (M, 3) in {O}, whose tip stands on points of a flat print.

    Raises
    ------
    NoSolutionError
        Too few joints bring the tip there.
    """
    if not mechanism_of(robot).many_ways:
        space = workspace_of(robot)
        step = nice((space.radius or 0.0) / LATTICE) if space.radius else 0.0
        if not step or space.radius is None:
            return space.place(np.linspace(-0.5, 0.5, 2 * LATTICE + 1) * (space.width or 0.0), 0.5)
        print_ = _lattice(LATTICE, step)
        return space.place(print_[np.linalg.norm(print_, axis=1) <= space.radius], 0.5)
    size = robot_size(robot)
    points = _lattice(PRINT, nice(REACH * size / 6))
    wanted = np.column_stack([points, np.zeros(len(points))])[np.arange(SPREAD) % len(points)]

    def tip(middle: Array, axis: Array) -> Callable[[Array, np.ndarray], Array]:
        return lambda x, rows: (x[:, :3] - middle - wanted[rows]) / size

    return _best(robot, tip, 0.0)


def looking(robot: Robot) -> Array:
    """Return joints (M, n_q) of an open chain from which a camera along its last axis looks at the middle of a board.

    Raises
    ------
    NoSolutionError
        Too few joints do.
    """
    size = robot_size(robot)
    u = np.outer(np.arange(1, SPREAD + 1), RECURRENCE) % 1.0
    tilt, way = TILTED * np.sqrt(u[:, 0]), 2 * np.pi * u[:, 1]
    cap = np.column_stack([np.sin(tilt) * np.cos(way), np.sin(tilt) * np.sin(way), np.cos(tilt)])
    distance = REACH * size * (NEAR + (FAR - NEAR) * u[:, 2])

    def eye(middle: Array, axis: Array) -> Callable[[Array, np.ndarray], Array]:
        one = np.linalg.svd(axis[None])[2][1:]
        from_board = cap @ np.vstack([one, -axis])

        def off(x: Array, rows: np.ndarray) -> Array:
            out = from_board[rows]
            seen = x[:, 3:].reshape(-1, 3, 3)[:, :, 2]
            return np.hstack([(x[:, :3] - middle - distance[rows, None] * out) / size, seen + out])

        return off

    return _best(robot, eye, REACH * size)


def _lattice(half: int, step: float) -> Array:
    """Return points (n, 2) of a print about its middle, row by row."""
    each = np.arange(-half, half + 1) * step
    return np.stack(np.meshgrid(each, each, indexing="ij"), axis=-1).reshape(-1, 2)


def _best(robot: Robot, aim: Callable[[Array, Array], Callable[[Array, np.ndarray], Array]], ahead: float) -> Array:
    """Return the joints that arrive at the place of the board at which most do.

    Places lie so far `ahead` of where joints of the spread, those whose last axis points down most, bring the machine.
    """
    spread = joint_spread(robot, SPREAD)
    x = _stand(robot, spread)
    axes = x[:, 3:].reshape(-1, 3, 3)[:, :, 2]
    found = np.zeros((0, spread.shape[1]))
    for row in np.argsort(axes[:, 2], kind="stable")[:PLACES]:
        arrived = aimed(robot, spread, aim(x[row, :3] + ahead * axes[row], axes[row]))
        found = max(found, arrived, key=len)
    if len(found) < FEWEST:
        raise NoPlan(
            f"of {SPREAD} sets of joints {len(found)} bring the machine before a board, wherever it lies. "
            "Give wider limits of the joints, or write poses of your own."
        )
    return found


def aimed(robot: Robot, joints: Array, off: Callable[[Array, np.ndarray], Array]) -> Array:
    """Return the joints (K, n_q), as the controller counts, that arrive where nothing is off, within their limits.

    `off` gives, of poses (M, 12) and the numbers (M,) of the joints that lead there, what shall vanish (M, k).
    """
    unit = np.where([u == "mm" for u in mechanism_of(robot).joint_units], 100.0, 1.0)
    q, rows = joints.copy(), np.arange(len(joints))
    for _ in range(STEPS):
        r = off(_stand(robot, q), rows)
        J = np.stack(
            [(off(_stand(robot, q + MOVED * step), rows) - r) / MOVED for step in unit * np.eye(q.shape[1])], axis=2
        )
        step = -np.einsum("mnk,mk->mn", np.linalg.pinv(J, rcond=1e-4), r)
        step *= np.minimum(1.0, LONGEST / np.maximum(np.abs(step).max(axis=1, keepdims=True), 1e-300))
        q = q + step * unit
    there = np.abs(off(_stand(robot, q), rows)).max(axis=1) < ARRIVED
    return q[there & within_limits(robot, q)]


def _stand(robot: Robot, q: Array) -> Array:
    """Return the poses (M, 12) at joints (M, n_q); those that are not solved are far off."""
    mechanism = mechanism_of(robot)
    x, status = mechanism.forward(robot.joint_sign * q, robot.tool, mechanism.rows(robot))
    return np.where((status == SOLVED)[:, None], np.nan_to_num(x), 1e9)
