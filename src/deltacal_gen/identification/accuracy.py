"""Error measures and check poses (Bai 2015, section 5)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from deltacal_gen.errors import MissingKey, NoPlan
from deltacal_gen.files.robot import Robot
from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.machine.registry import SOLVED, Array, mechanism_of
from deltacal_gen.machine.rotation import about_z, align, from_vector, swept
from deltacal_gen.machine.values import Workspace
from deltacal_gen.units import DEG

TURN = 10.0  # deg: as far as a platform turns on command either way whose workspace does not say
TURN_ROOT = 1.2207440846057596  # of x^4 = x + 1: its powers spread three turns evenly
RECURRENCE = (0.8191725134, 0.6710436067, 0.5497004779)  # powers of the root of x^4 = x + 1: evenly spread points
FULL_TURN = np.pi  # rad: as far as a joint turns either way whose limits nobody gave


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
        raise MissingKey(
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
    return workspace.place(about_z(part * (workspace.radius or 0.0), angle), depth)


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


def turned(robot: Robot, positions: Array) -> Array:
    """Return targets at positions (N, 3): as they are or, of a platform that turns on command, poses (N, 12).

    The first is level; the others are turned by rotation vectors spread evenly over as far as the workspace says, to
    0.001 deg, as a person types them. What is chosen among positions has to be turned first: a turn goes by the place
    in the row. Poses (N, 12) stay as they are.
    """
    mechanism, space = mechanism_of(robot), robot.workspace
    if not mechanism.turning or mechanism.many_ways or space is None or positions.shape[1] > 3:
        return positions
    axes = ["xyz".index(name[1]) for name in mechanism.asks if name[0] == "c"]
    vectors = np.zeros((len(positions), 3))
    u = np.outer(np.arange(len(positions)), TURN_ROOT ** -np.arange(1.0, len(axes) + 1)) % 1.0
    vectors[:, axes] = np.round((2.0 * ((u + 0.5) % 1.0) - 1.0) * (TURN if space.turn is None else space.turn), 3)
    return np.hstack([positions, from_vector(vectors * DEG).reshape(-1, 9)])


def joint_spread(robot: Robot, count: int) -> Array:
    """Return joints (count, n_q) of an open chain, as the controller counts, spread evenly over their ranges.

    An additive recurrence, without any symmetry; left out is what leads the tool point outside the workspace, if the
    robot file gives one. A turning joint without limits makes half a turn either way.

    Raises
    ------
    InputError
        A sliding joint has no limits.
    NoSolutionError
        Hardly any joints lead into the workspace.
    """
    mechanism = mechanism_of(robot)
    limits = robot.joint_limits
    if limits is None:
        if "mm" in mechanism.joint_units:
            raise MissingKey(
                "a plan needs to know how far the sliding joints move.",
                "Add limits to [joints] in the robot file.",
                file=robot.source,
            )
        limits = np.tile([-FULL_TURN, FULL_TURN], (mechanism.limbs, 1))
    root = np.max(np.roots([1.0, *[0.0] * (mechanism.limbs - 1), -1.0, -1.0]).real)  # of x^(n+1) = x + 1
    for many in (1, 4, 16, 64):
        u = np.outer(np.arange(1, many * count + 1), root ** -np.arange(1.0, mechanism.limbs + 1)) % 1.0
        joints = limits[:, 0] + u * np.diff(limits, axis=1)[:, 0]
        if robot.workspace is None:
            return joints
        x, _ = mechanism.forward(robot.joint_sign * joints, robot.tool, mechanism.rows(robot))
        joints = joints[robot.workspace.holds(x[:, :3])]
        if len(joints) >= count:
            return joints[:count]
    raise NoPlan(
        f"only {len(joints)} of {many * count} joints spread over their limits lead into the workspace. "
        "Check [workspace] and the limits of the joints."
    )


def check_joints(robot: Robot, tool: Array, errors: Array | None = None) -> tuple[Array, Array, Array, np.ndarray]:
    """Return at which joints a machine is judged over its workspace, where they lead, and which targets it reaches.

    Parameters
    ----------
    tool : (3,) array
        Reference point in {O'} [mm].
    errors : (n_p,) array, optional
        Source errors of the machine; default the robot's own.

    Returns
    -------
    q, x : (N, n_q) and (N, 12) arrays
        Joints as the geometry counts, and poses; of the targets that are reached.
    targets : (M, 3) array
        Of `check_poses`; of an open chain where as many joints of `joint_spread` lead.
    reached : (M,) array of bool

    Raises
    ------
    InputError
        The robot file has no workspace.
    """
    mechanism, space = mechanism_of(robot), workspace_of(robot)
    rows, targets = mechanism.rows(robot, errors), check_poses(space)
    if mechanism.many_ways:
        q = robot.joint_sign * joint_spread(robot, len(targets))
        x, status = mechanism.forward(q, tool, rows)
        return q, x, x[:, :3], status == SOLVED
    q, x, status = mechanism.inverse(turned(robot, targets), tool, rows)
    return q[status == SOLVED], x[status == SOLVED], targets, status == SOLVED


def distance_error(actual: Array, wanted: Array, home: int = 0) -> Array:
    """Return the error (..., N) of the distances of points (..., N, 3) from home [mm]: the same in every frame."""

    def from_home(points: Array) -> Array:
        square = np.zeros(points.shape[:-1])
        for along in np.moveaxis(points, -1, 0):  # sums of three numbers each would take three times as long
            gap = along - along[..., home : home + 1]
            square += np.multiply(gap, gap, out=gap)
        return np.sqrt(square, out=square)

    error: Array = from_home(actual) - from_home(wanted)
    return error


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
    rigid = np.concatenate([np.tile(np.eye(3), (len(points), 1, 1)), swept(points)], axis=2).reshape(-1, 6)
    return project_out(J, basis(rigid))
