"""Error measures and check poses (Bai 2015, section 5)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.measurement import align
from deltacal_gen.mechanism import Array, mechanism_of
from deltacal_gen.robot import Robot, Workspace


def workspace_of(robot: Robot) -> Workspace:
    """Return where the robot works.

    Raises
    ------
    InputError
        The robot file does not say.
    """
    if robot.workspace is None:
        mechanism = mechanism_of(robot)
        if len(mechanism.axes) == 3:
            shape, keys = "cylinder", "top, radius and height"
        else:
            shape, keys = ("rectangle", "top, width and height") if mechanism.limbs > 1 else ("stroke", "width")
        raise InputError(
            f"the robot file has no [workspace] with {keys}.",
            f"Add the {shape} in which the machine works.",
            file=robot.source,
        )
    return robot.workspace


def circle(workspace: Workspace, depth: float, part: float, n: int, start: float = 0.0) -> Array:
    """Return n evenly spaced points (n, 3) on a circle of the cylinder [mm].

    Parameters
    ----------
    depth : float
        0 at the first layer, 1 at the last.
    part : float
        Of the cylinder's radius.
    start : float
        Angle of the first point about z [rad].
    """
    angle = start + 2 * np.pi * np.arange(n) / n
    radius = part * (workspace.radius or 0.0)
    return workspace.place(radius * np.column_stack([np.cos(angle), np.sin(angle)]), depth)


def check_poses(workspace: Workspace, per_circle: int = 16) -> Array:
    """Return the paper's check poses (1 + 6 per_circle, 3): home, then circles of half and full radius in three layers.

    With 16 to a circle these are the 96 poses of Bai 2015, section 5.2, beside the home at the cylinder's centre. As
    many, evenly spaced along three levels, for a planar machine.
    """
    depths = (0.0, 0.5, 1.0)
    if workspace.radius is None:
        x = np.linspace(-0.5, 0.5, 2 * per_circle) * (workspace.width or 0.0)
        return np.vstack([workspace.home, *(workspace.place(x, depth) for depth in depths)])
    rings = [circle(workspace, depth, part, per_circle) for depth in depths for part in (0.5, 1.0)]
    return np.vstack([workspace.home, *rings])


def distance_error(actual: Array, wanted: Array, home: int = 0) -> Array:
    """Return the error (N,) of each point's distance from home [mm]: the same in every frame."""
    from_home: Array = np.linalg.norm(actual - actual[home], axis=1) - np.linalg.norm(wanted - wanted[home], axis=1)
    return from_home


def volumetric_error(actual: Array, wanted: Array, home: int = 0, turn: Array | None = None) -> Array:
    """Return the error (N,) of each point relative to home [mm].

    Unlike the distance error it depends on the frame: `turn` (3, 3) is the rotation from the frame of `wanted` to that
    of `actual`; None takes the rotation that fits the two sets best.
    """
    a, w = actual - actual[home], wanted - wanted[home]
    turn = align(w, a) if turn is None else turn
    return np.asarray(np.linalg.norm(a - w @ turn.T, axis=1))


def largest(errors: Sequence[float] | Array) -> float:
    """Return the largest absolute error."""
    return float(np.max(np.abs(errors), initial=0.0))


def without_motion(J: Array, points: Array) -> Array:
    """Return displacements (3 N, n) of points (N, 3) less the rigid motion that fits each column best."""
    turns = np.cross(np.eye(3)[None], points[:, None]).transpose(0, 2, 1)
    rigid = np.concatenate([np.tile(np.eye(3), (len(points), 1, 1)), turns], axis=2).reshape(-1, 6)
    Q = np.linalg.qr(rigid)[0]
    out: Array = J - Q @ (Q.T @ J)
    return out
