"""Sets of targets in a workspace: rings, edges, a grid, candidates, reference points on the platform."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from deltacal_gen.errors import NotForThisMachine, UnknownName, ValueOutOfRange
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.accuracy import circle, joint_spread, workspace_of
from deltacal_gen.instrument.kind import Kind
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Measurement, Workspace
from deltacal_gen.planning import boards

LAYERS = {"top": 0.0, "middle": 0.5, "bottom": 1.0}  # part of the cylinder's height below its top
ROUGH, FINE = ("middle",), ("top", "bottom")  # Bai 2015, sections 5.1 and 5.2
OFFSETS = ((0.0, 0.0, 0.0), (0.0, 0.0, -100.0), (100.0, 0.0, 0.0))  # mm: second and third reference points, from P
CANDIDATES = 400  # joints of an open chain, positions near singularities


def rings(workspace: Workspace, n: int, layers: Sequence[str | float] = FINE, start_angle: float = 0.0) -> Array:
    """Return the paper's set: the centre of the cylinder and n evenly spaced poses on the rim of each layer.

    Parameters
    ----------
    layers : sequence
        ``top``, ``middle``, ``bottom``, or parts of the height below the top.
    start_angle : float
        Of the first pose of each ring about z [rad].

    Returns
    -------
    targets : (1 + n * len(layers), 3) array
        [mm]

    References
    ----------
    Bai 2015, section 3.3 and Fig. 4.
    """
    radius(workspace)
    rims = [circle(workspace, part, 1.0, n, start_angle) for part in parts_of(layers)]
    return np.vstack([workspace.home, *rims])


def edges(workspace: Workspace, n: int, layers: Sequence[str | float] = FINE) -> Array:
    """Return n evenly spaced poses along each level of a planar machine's rectangle, all in the same direction.

    A stroke is a single level.

    Returns
    -------
    targets : (n * len(layers), 3) array
        [mm]

    References
    ----------
    Mei 2018, section 5 and Fig. 7; the order, which the condition number of differences depends on, is the one that
    gives its figures.
    """
    x = np.linspace(-0.5, 0.5, n) * width(workspace)
    return np.vstack([workspace.place(x, part) for part in (parts_of(layers) if workspace.height else (0.0,))])


def spread_of(robot: Robot, kind: Kind, said: Measurement) -> str:
    """Say what `candidates_of` draws from, in words."""
    if kind.aims == "touch":
        return "joints that bring the tip to points of a flat print, where it lies so that most of them arrive"
    if kind.aims == "look" and said.camera is not None and said.camera.place == "fixed":
        return (
            "joints that show a board across the last axis to a camera at which that points, tilted by up to 35 deg; "
            "it stands where most of them arrive"
        )
    if kind.aims == "look":
        return (
            "joints from which a camera along the last axis looks at the middle of a board, from 0.75 to 1.35 of its "
            "usual distance and tilted by up to 35 deg, where it lies so that most of them arrive"
        )
    ranges = "within their limits" if robot.joint_limits is not None else "over full turns, as the file gives no limits"
    where = " and the workspace" if robot.workspace is not None else ""
    return f"{CANDIDATES} joints spread evenly {ranges}{where}"


def candidates_of(robot: Robot, kind: Kind | None = None) -> Array:
    """Return what poses are chosen from: positions (M, 3) of `grid`, or joints (M, n_q) of an open chain.

    Those for a board bring the machine to it; see `boards`.
    """
    many = mechanism_of(robot).many_ways
    if kind is not None and kind.aims == "touch":
        return boards.touched(robot)
    if kind is not None and kind.aims == "look" and many:
        return boards.looking(robot)
    if many:
        return joint_spread(robot, CANDIDATES)
    return grid(workspace_of(robot))


def grid(workspace: Workspace, layers: int = 3, radii: int = 2, angles: int = 24) -> Array:
    """Return candidates (M, 3) that fill the cylinder, or the rectangle of a planar machine, evenly [mm]."""
    if workspace.radius is None:
        return edges(workspace, radii * angles + 1, np.linspace(0.0, 1.0, layers).tolist())
    heights = np.linspace(0.0, 1.0, layers).tolist()
    axis = workspace.place(np.zeros((layers, 2)), heights)
    parts = np.arange(1, radii + 1) / radii
    return np.vstack([axis, *(circle(workspace, height, part, angles) for part in parts for height in heights)])


def reference_points(robot: Robot, count: int) -> Array:
    """Return one to three reference points (count, 3) in {O'}: the robot's own, one below it, one beside it [mm].

    The one below sees how the platform turns about x and y (Bai 2015, section 5.2).
    """
    if not 1 <= count <= len(OFFSETS):
        raise ValueOutOfRange(
            f"{count} reference points cannot be placed by default: give 1 to {len(OFFSETS)}, or their coordinates."
        )
    points: Array = robot.tool + np.array(OFFSETS[:count])
    return points


def radius(workspace: Workspace) -> float:
    """Return the radius of a cylinder [mm]; raise UsageError where the workspace is none."""
    if workspace.radius is None:
        raise NotForThisMachine("poses are planned in a cylinder: the workspace needs a radius.")
    return workspace.radius


def width(workspace: Workspace) -> float:
    """Return the width of a rectangle [mm]; raise UsageError where the workspace is none."""
    if workspace.width is None:
        raise NotForThisMachine("poses are planned in a rectangle: the workspace needs a width.")
    return workspace.width


def parts_of(layers: Sequence[str | float]) -> tuple[float, ...]:
    """Return layers, by name or number, as parts of the height of the workspace, 0 to 1."""
    for layer in layers:
        if layer not in LAYERS if isinstance(layer, str) else not 0 <= layer <= 1:
            raise UnknownName(
                f"there is no layer '{layer}'; write {', '.join(LAYERS)} or a part of the height, 0 to 1."
            )
    return tuple(LAYERS[layer] if isinstance(layer, str) else float(layer) for layer in layers)
