"""Where to measure: poses on the rim of the workspace, the papers' rules, D-optimal sets, identifiability.

A plan is judged by the identification matrix that its recording will have: exact poses of the machine as the robot
file knows it, commanded through the nominal inverse, and derivatives by the generated kernels. For several reference
points the machine runs through the same joints once for each. Distances are those of all pairs of one reference
point, positions and poses are in one unknown frame, which is projected out.

An open chain has no rim to run along: its poses are joints, drawn evenly from their ranges and taken one by one, each
the one that adds most to the information.

Condition numbers depend on three conventions, each of which can be chosen and is said in the result: the scaling of
the columns, the norm (``spectral``: largest by smallest singular value; ``frobenius``: the norm of the matrix times
that of its pseudo-inverse), and the angle at which a ring starts. So does the number of poses that the rule picks.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.files.recording import Measurement, Recording, read_measurement, write_recording
from deltacal_gen.files.robot import Robot, Workspace, to_file
from deltacal_gen.identification.accuracy import joint_spread, turned, workspace_of
from deltacal_gen.identification.identifiability import (
    RANK_TOLERANCE,
    Combination,
    Observability,
    base_parameters,
    column_convention,
    observability,
    unseen,
)
from deltacal_gen.instrument.instrument import Instrument
from deltacal_gen.instrument.kind import Kind
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.instrument.kinds import names as kind_names
from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.registry import SOLVED, STATUS, Array, Machine, mechanism_of
from deltacal_gen.planning import singularities
from deltacal_gen.results import plan as results
from deltacal_gen.results.plan import Deviation, Expected, Method, PlannedPose
from deltacal_gen.units import file_unit

LAYERS = {"top": 0.0, "middle": 0.5, "bottom": 1.0}  # part of the cylinder's height below its top
ROUGH, FINE = ("middle",), ("top", "bottom")  # Bai 2015, sections 5.1 and 5.2
KINDS = {name: words for name in kind_names() if (words := kind_of(name).planned)}  # of what poses are planned for
NORMS = {
    "spectral": "largest singular value by the smallest",
    "frobenius": "Frobenius norm of the matrix times that of its pseudo-inverse",
}
SCALINGS = {
    "file": "columns per mm and deg",
    "paper": "columns of the unknowns in the paper's equations, angles in rad",
    "table": "columns of the unknowns in the paper's tables, angles in rad",
    "typical": "columns per ordinary error",
}
FEWEST = 3  # poses of a ring: rule (21)
GENERIC_POSES = 60  # without any symmetry, for what poses can see at all
RECURRENCE = (0.8191725134, 0.6710436067, 0.5497004779)  # powers of the root of x^4 = x + 1: evenly spread points
OFFSETS = ((0.0, 0.0, 0.0), (0.0, 0.0, -100.0), (100.0, 0.0, 0.0))  # mm: second and third reference points, from P
TURN_MM = 100.0  # at which a measured turn of 1 rad counts as a shift: what 6D trackers read, 0.01 mm beside 0.006 deg
CANDIDATES = 400  # joints of an open chain, positions near singularities
RIDGE = 1e-9  # of the information of all candidates: keeps the determinant of a poor set above zero
STARTS = 5  # random sets from which the exchange sets out


@dataclass(frozen=True)
class Mount:
    """Where a gauge's ends are nominally mounted: `base` in {O}, `platform` in {O'}, (3,) each [mm]."""

    base: Array
    platform: Array

    @property
    def said(self) -> Measurement:
        """What the sidecar of the readings will say."""
        base, platform = ((float(x), float(y), float(z)) for x, y, z in (self.base, self.platform))
        return Measurement(
            kind="gauge", frame="robot", zero="incremental", base_point_mm=base, platform_point_mm=platform
        )


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


@dataclass(frozen=True)
class Step:
    """Figures of the set with `n` poses per ring.

    `change` is ``|k_n - k_(n-1)| / k_n`` of the condition number k; of a gauge, ``|k - corrected| / k``, where
    `corrected` is the condition number with the gauge's errors of the robot file (Mei 2018: kappa_1, kappa_m).
    `indices` are O1 .. O5 as in `identifiability.Observability`.
    """

    n: int
    poses: int
    readings: int
    rank: int
    condition: float
    change: float
    indices: dict[str, float]
    corrected: float | None = None


@dataclass(frozen=True)
class Prediction:
    """Standard deviations that noise of `sigma` per coordinate will leave, by unweighted least squares.

    Attributes
    ----------
    parameters : dict of float
        [mm, rad].
    mean, largest : float
        Of the tool position over the workspace: root of the summed variances of its coordinates, up to a motion of
        the frame, which neither distances nor positions in an unknown frame tell [mm].
    """

    sigma: float
    parameters: dict[str, float]
    mean: float
    largest: float

    def answer(self, mechanism: Machine) -> Expected:
        """Return the same as users read it, in mm and deg."""
        units = {p.name: p.unit for p in mechanism.parameters}
        return Expected(
            sigma_mm=self.sigma,
            parameters=tuple(
                Deviation(name=name, std=to_file(std, units[name]), unit=file_unit(units[name]))
                for name, std in self.parameters.items()
            ),
            tool_mean_mm=self.mean,
            tool_max_mm=self.largest,
        )


@dataclass(frozen=True)
class Task:
    """What is to be identified, from which readings, and how its figures are stated.

    Attributes
    ----------
    names, dropped : tuples of str
        Parameters that enter the matrix; those left out because no poses can tell them from the others.
    tools : (T, 3) array
        Reference points in {O'} [mm].
    mount : Mount or None
        Of a gauge.
    """

    robot: Robot
    model: str
    kind: str
    scaling: str
    norm: str
    names: tuple[str, ...]
    dropped: tuple[str, ...]
    tools: Array
    mount: Mount | None = field(default=None, kw_only=True)

    def step(self, n: int, poses: Poses, before: float = math.inf) -> Step:
        """Return the figures of a set of poses; `before` is the condition number of the last smaller one."""
        nominal = dataclasses.replace(self, robot=_as_mounted(self.robot, kind_of(self.kind))) if self.mount else self
        H = nominal._columns(poses)
        figures = observability(H, len(poses))
        condition = self._condition(figures)
        corrected = self._condition(observability(self._columns(poses), len(poses))) if self.mount else None
        other = before if corrected is None else corrected
        change = abs(condition - other) / condition if math.isfinite(condition) else math.inf
        return Step(n, len(poses), len(H), figures.rank, condition, change, figures.indices, corrected)

    def _columns(self, poses: Poses) -> Array:
        factors, _ = column_convention(self.robot, self.names, self.scaling)
        columns: Array = _matrix(self.robot, poses, self.names, kind_of(self.kind), self.mount) * factors
        return columns

    def _condition(self, figures: Observability) -> float:
        if self.norm == "frobenius" and math.isfinite(figures.condition):
            s = figures.singular_values
            return float(np.sqrt((s**2).sum() * (1 / s**2).sum()))
        return figures.condition


@dataclass(frozen=True)
class Plan(Task):
    """A set of poses to be measured, and how it was chosen.

    Attributes
    ----------
    method : str
        ``rings``, ``edges``, ``joints``, ``singular`` or ``d-optimal``.
    layers : tuple of float
        Parts of the workspace's height below its top; empty for a D-optimal set.
    start_angle : float
        Of the first pose of a ring about z [rad].
    steps : tuple of Step
        One per n; a single one, n the number of positions, for a D-optimal set.
    chosen : int or None
        The smallest n whose change is within the threshold; None where there is none up to the last n.
    settled : int or None
        The smallest n from which on all changes are within the threshold, up to the last n.
    poses : Poses
        Of the chosen n, or of the last one where none was chosen.
    prediction : Prediction or None
        For the noise that was given.
    """

    method: Method
    layers: tuple[float, ...]
    start_angle: float
    threshold: float
    steps: tuple[Step, ...]
    chosen: int | None
    settled: int | None
    poses: Poses
    prediction: Prediction | None

    @property
    def conventions(self) -> str:
        """What the figures depend on, in words."""
        if self.method == "edges":
            lowest = "lowest" if len(self.layers) > 1 else "chosen"
            rule = (
                "|k - corrected| / k, with the gauge's errors of the robot file,"
                if self.mount
                else "|k(n) - k(n-1)| / k(n)"
            )
            along = (
                f"each of {len(self.layers)} levels of the workspace, all in the same direction, from the highest to "
                f"the {lowest}"
                if _mechanism(self.robot).limbs > 1
                else "the stroke"
            )
            poses = (
                f"n evenly spaced poses along {along}; chosen is the smallest n >= {FEWEST} at which every parameter "
                f"shows and {rule} <= {self.threshold:g}."
            )
        elif self.method == "rings":
            heights = " and ".join(f"{part:.0%}" for part in self.layers)
            poses = (
                f"Home at the centre of the cylinder and n evenly spaced poses on the rim at {heights} of the height "
                f"below its top, the first at {math.degrees(self.start_angle):g} deg about z; chosen is the smallest "
                f"n >= {FEWEST} with |k(n) - k(n-1)| / k(n) <= {self.threshold:g}, settled the smallest n from which "
                "on that holds."
            )
        elif self.method == "singular":
            poses = (
                "n positions drawn at random of those whose nearest singularity is as far as was asked for; chosen is "
                f"the smallest n with |k(n) - k(n-1)| / k(n) <= {self.threshold:g}."
            )
        elif self.method == "joints":
            poses = (
                f"{_spread_of(self.robot)}, {self.steps[0].n} of them chosen for the largest determinant of the "
                "information on the model, the frame eliminated, then one by one what adds most to it; chosen is the "
                f"smallest n with |k(n) - k(n-1)| / k(n) <= {self.threshold:g}. Collisions are not looked for."
            )
        else:
            poses = (
                f"{self.chosen} candidates, chosen for the largest determinant of the information that their positions "
                "hold on the model, the frame eliminated."
            )
        points = "; ".join(f"({x:g}, {y:g}, {z:g}) mm" for x, y, z in self.tools)
        left_out = f" Left out, as no poses tell them from the others: {', '.join(self.dropped)}." * bool(self.dropped)
        return (
            f"{poses} Readings: {KINDS[self.kind]}. Reference points, at the same joints: {points}. "
            f"Condition number k: {NORMS[self.norm]}, {SCALINGS[self.scaling]}.{left_out}"
        )

    def answer(self) -> results.Plan:
        """Return the same as users read it, in mm and deg; null stands for what is infinite or not there."""
        mechanism = _mechanism(self.robot)
        units, steps = mechanism.joint_units, self.steps
        joints = [
            tuple(to_file(q, unit) for q, unit in zip(row, units, strict=True)) for row in self.poses.joints.tolist()
        ]
        at = f"joints_{file_unit(units[0])}" if len(set(units)) == 1 else "joints"

        def index(name: str) -> tuple[float, ...]:
            return tuple(step.indices[name] for step in steps)

        return results.Plan(
            robot=self.robot.name,
            mechanism=mechanism.name,
            model=self.model,
            parameters=self.names,
            dropped=self.dropped,
            method=self.method,
            conventions=self.conventions,
            kind=self.kind,
            scaling=self.scaling,
            norm=self.norm,
            tools_mm=tuple(map(tuple, self.tools.tolist())),
            layers=self.layers,
            start_angle_deg=to_file(self.start_angle, "rad"),
            threshold=self.threshold,
            n=tuple(step.n for step in steps),
            pose_count=tuple(step.poses for step in steps),
            readings=tuple(step.readings for step in steps),
            rank=tuple(step.rank for step in steps),
            condition=tuple(_finite(step.condition) for step in steps),
            corrected=tuple(None if step.corrected is None else _finite(step.corrected) for step in steps),
            change=tuple(_finite(step.change) for step in steps),
            O1=index("O1"),
            O2=index("O2"),
            O3=index("O3"),
            O4=index("O4"),
            O5=index("O5"),
            chosen=self.chosen,
            settled=self.settled,
            poses=tuple(
                PlannedPose(target_mm=tuple(target), tool_mm=tuple(tool), **{at: q})
                for target, tool, q in zip(self.poses.targets.tolist(), self.poses.tool.tolist(), joints, strict=True)
            ),
            prediction=None if self.prediction is None else self.prediction.answer(mechanism),
        )


@dataclass(frozen=True)
class RankRow:
    """What poses without any symmetry can see of a model.

    Attributes
    ----------
    points : int
        Number of reference points.
    smallest, noise : float
        Smallest singular value that counts and largest one that does not, by the largest, columns in ordinary
        errors; 0 where there is none.
    unseen : list of Combination
    """

    model: str
    points: int
    columns: int
    rank: int
    smallest: float
    noise: float
    unseen: list[Combination]


def read_mount(sidecar: str | Path) -> Mount:
    """Return where a recording's sidecar says that the ends of its gauge are mounted."""
    measurement = read_measurement(sidecar)
    base, platform = measurement.base_point_mm, measurement.platform_point_mm
    if base is None or platform is None:
        raise InputError(
            "the sidecar does not say where a gauge's ends are mounted.",
            "Add base_point_mm and platform_point_mm to [measurement].",
            file=sidecar,
        )
    return Mount(np.array(base), np.array(platform))


# --------------------------------------------------------------------------------------------------- sets of targets


def rings(
    workspace: Workspace,
    n: int,
    layers: Sequence[str | float] = FINE,
    start_angle: float = 0.0,
    home: bool = True,
) -> Array:
    """Return the paper's set: the centre of the cylinder and n evenly spaced poses on the rim of each layer.

    Parameters
    ----------
    layers : sequence
        ``top``, ``middle``, ``bottom``, or parts of the height below the top.
    start_angle : float
        Of the first pose of each ring about z [rad].

    Returns
    -------
    targets : (n * len(layers) + home, 3) array
        [mm]

    References
    ----------
    Bai 2015, section 3.3 and Fig. 4.
    """
    turn = start_angle + 2 * np.pi * np.arange(n) / n
    rim = _radius(workspace) * np.column_stack([np.cos(turn), np.sin(turn)])
    sets = [workspace.place(rim, part) for part in _parts(layers)]
    return np.vstack([workspace.home, *sets] if home else sets)


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
    x = np.linspace(-0.5, 0.5, n) * _width(workspace)
    return np.vstack([workspace.place(x, part) for part in (_parts(layers) if workspace.height else (0.0,))])


def _spread_of(robot: Robot) -> str:
    """Say what `joint_spread` draws from, in words."""
    ranges = "within their limits" if robot.joint_limits is not None else "over full turns, as the file gives no limits"
    where = " and the workspace" if robot.workspace is not None else ""
    return f"{CANDIDATES} joints spread evenly {ranges}{where}"


def candidates_of(robot: Robot) -> Array:
    """Return what poses are chosen from: positions (M, 3) of `grid`, or joints (M, n_q) of an open chain."""
    if mechanism_of(robot).many_ways:
        return joint_spread(robot, CANDIDATES)
    return grid(workspace_of(robot))


def grid(workspace: Workspace, layers: int = 3, radii: int = 2, angles: int = 24) -> Array:
    """Return candidates (M, 3) that fill the cylinder, or the rectangle of a planar machine, evenly [mm]."""
    if workspace.radius is None:
        return edges(workspace, radii * angles + 1, np.linspace(0.0, 1.0, layers).tolist())
    heights = np.linspace(0.0, 1.0, layers).tolist()
    axis = workspace.place(np.zeros((layers, 2)), heights)
    inner = [
        rings(workspace.model_copy(update={"radius": _radius(workspace) * k / radii}), angles, heights, home=False)
        for k in range(1, radii + 1)
    ]
    return np.vstack([axis, *inner])


def reference_points(robot: Robot, count: int) -> Array:
    """Return one to three reference points (count, 3) in {O'}: the robot's own, one below it, one beside it [mm].

    The one below sees how the platform turns about x and y (Bai 2015, section 5.2).
    """
    if not 1 <= count <= len(OFFSETS):
        raise UsageError(
            f"{count} reference points cannot be placed by default: give 1 to {len(OFFSETS)}, or their coordinates."
        )
    points: Array = robot.tool + np.array(OFFSETS[:count])
    return points


def _radius(workspace: Workspace) -> float:
    if workspace.radius is None:
        raise UsageError("poses are planned in a cylinder: the workspace needs a radius.")
    return workspace.radius


def _width(workspace: Workspace) -> float:
    if workspace.width is None:
        raise UsageError("poses are planned in a rectangle: the workspace needs a width.")
    return workspace.width


def _parts(layers: Sequence[str | float]) -> tuple[float, ...]:
    for layer in layers:
        if layer not in LAYERS if isinstance(layer, str) else not 0 <= layer <= 1:
            raise UsageError(f"there is no layer '{layer}'; write {', '.join(LAYERS)} or a part of the height, 0 to 1.")
    return tuple(LAYERS[layer] if isinstance(layer, str) else float(layer) for layer in layers)


# ------------------------------------------------------------------------------------- the matrix of a set of targets


def reach(robot: Robot, targets: Array, tools: Array) -> tuple[Poses, np.ndarray]:
    """Return the poses that bring the first reference point to the targets, and which of them cannot be.

    Parameters
    ----------
    targets : (M, 3) array
        In {O} [mm]; of an open chain joints (M, n_q), as the controller counts.
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
    targets, tools = np.atleast_2d(np.asarray(targets, dtype=float)), _tools(tools)
    nominal, known = mechanism.rows(dataclasses.replace(robot, errors={})), mechanism.rows(robot)
    if mechanism.many_ways:
        theta = robot.joint_sign * targets
        at, solved = mechanism.forward(theta, tools[0], nominal)
        targets = at[:, :3]
    else:
        theta, _, solved = mechanism.inverse(turned(robot, targets), tools[0], nominal)
    why = np.array([STATUS[int(s)] if s != SOLVED else "" for s in solved], dtype=object)
    joints = robot.joint_sign * theta
    if robot.joint_limits is not None:
        outside = ((joints < robot.joint_limits[:, 0]) | (joints > robot.joint_limits[:, 1])).any(axis=1)
        why[outside & (why == "")] = "beyond the limits of the joints"
    theta = np.tile(np.where((why == "")[:, None], theta, 0.0), (len(tools), 1))
    tool = np.repeat(tools, len(targets), axis=0)
    x, status = mechanism.forward(theta, tool, known)
    where = x if not robot.errors else mechanism.forward(theta, tool, nominal)[0]
    for block in status.reshape(len(tools), -1):
        why[(block != SOLVED) & (why == "")] = "not solved for the machine with the errors of the robot file"
    points = where[:, :3].copy()
    points[: len(targets)] = targets
    return Poses(np.tile(joints, (len(tools), 1)), points, tool, x, len(tools)), why.astype(str)


def design(robot: Robot, targets: Array, tools: Array, names: Sequence[str], kind: str = "distance") -> Array:
    """Return the identification matrix of an imagined recording, per mm and rad.

    Parameters
    ----------
    targets : (M, 3) array
        Of the first reference point, in {O} [mm].
    tools : (T, 3) array
        Reference points in {O'} [mm].
    names : sequence of str
        Parameters, one column each.
    kind : str
        ``distance``: rows ``n^T (C_j - C_i)``, all pairs of each reference point (Bai 2015, eq. 14);
        ``position``: three rows per position, one unknown frame projected out.

    Returns
    -------
    H : (rows, n) array
        [mm / mm or mm / rad]

    Raises
    ------
    NoSolutionError
        A target cannot be reached; the message names it.
    """
    return _matrix(robot, _reached(robot, targets, tools), names, kind_of(kind))


def _reached(robot: Robot, targets: Array, tools: Array) -> Poses:
    poses, why = reach(robot, targets, tools)
    bad = np.flatnonzero(why != "")
    if len(bad):
        x, y, z = poses.targets[bad[0]]
        raise NoSolutionError(
            f"the target ({x:.6g}, {y:.6g}, {z:.6g}) mm is {why[bad[0]]} ({len(bad)} of {len(why)} targets). "
            "Plan in a smaller workspace or turn the ring."
        )
    return poses


def _generic(robot: Robot, tools: Array) -> Poses:
    """Return poses without any symmetry, what can be reached of an additive recurrence in the cylinder."""
    if _mechanism(robot).many_ways:
        return _reached(robot, joint_spread(robot, GENERIC_POSES), tools)
    workspace = workspace_of(robot)
    u = np.outer(np.arange(1, GENERIC_POSES + 1), RECURRENCE) % 1.0
    if len(_mechanism(robot).axes) == 2:
        return _reachable(robot, workspace.place((u[:, 0] - 0.5) * _width(workspace), u[:, 2]), tools)
    r, turn = _radius(workspace) * np.sqrt(u[:, 0]), 2 * np.pi * u[:, 1]
    return _reachable(robot, workspace.place(np.column_stack([r * np.cos(turn), r * np.sin(turn)]), u[:, 2]), tools)


def _reachable(robot: Robot, targets: Array, tools: Array) -> Poses:
    reached = reach(robot, targets, tools)[1] == ""
    if reached.sum() < GENERIC_POSES / 2:
        raise NoSolutionError(
            f"the machine reaches {reached.sum()} of {GENERIC_POSES} points spread over its workspace. "
            "Check [workspace] and the limits of the joints."
        )
    return reach(robot, targets[reached], tools)[0]


def _matrix(robot: Robot, poses: Poses, names: Sequence[str], kind: Kind, mount: Mount | None = None) -> Array:
    moved = _sensitivity(robot, poses, names)
    if mount is None:
        return _read(_mechanism(robot), kind, poses, moved)
    return _mounted(robot, poses, names, kind, moved, mount)


def _mounted(robot: Robot, poses: Poses, names: Sequence[str], kind: Kind, moved: Array, mount: Mount) -> Array:
    """Return differences of adjacent rows of what a gauge reads, its own errors among the parameters."""
    mechanism = _mechanism(robot)
    found, instrument = kind.imagined(poses.x, poses.points, mechanism, mount.said)
    others = tuple(u for u in instrument.free if u not in kind.carried(mechanism))
    instrument = dataclasses.replace(instrument, free=others).mounted(mechanism, mechanism.vector(robot.errors))
    J, J_m = instrument.linearise(found, poses.x, moved)
    instrument.add_carried(J, mechanism, names, found, poses.x)
    J, J_m = np.diff(J[:, 0], axis=0), np.diff(J_m[:, 0], axis=0)
    return _without(J, J_m) if others else J


def _as_mounted(robot: Robot, kind: Kind) -> Robot:
    """Return the robot with no errors of a gauge: as its ends are nominally mounted."""
    own = {_mechanism(robot).parameters[p].name for p in kind.carried(_mechanism(robot)).values()}
    return dataclasses.replace(robot, errors={k: v for k, v in robot.errors.items() if k not in own})


def _read(mechanism: Machine, kind: Kind, poses: Poses, moved: Array) -> Array:
    """Return how readings change (rows, n) where the platform moves by `moved` (P, n_x, n); the frame projected out."""
    found, instrument = kind.imagined(poses.x, poses.points, mechanism, Measurement())
    J, J_m = _linearise(found, instrument, poses.x, moved)
    J = J.reshape(-1, moved.shape[2])
    return _without(J, J_m.reshape(len(J), -1)) if instrument.n_unknown else J


def _linearise(found: Readings, instrument: Instrument, x: Array, moved: Array) -> tuple[Array, Array]:
    """Return derivatives of readings by parameters and by the instrument's unknowns, turns as shifts of `TURN_MM`."""
    J, J_m = instrument.linearise(found, x, moved)
    for derivatives in (J, J_m):
        derivatives[:, list(found.kind.turned)] *= TURN_MM
    return J, J_m


def _without(J: Array, nuisance: Array) -> Array:
    """Return columns (rows, n) with what nuisance columns could explain projected out."""
    Q = np.linalg.qr(nuisance)[0]
    return J - Q @ (Q.T @ J)


def _sensitivity(robot: Robot, poses: Poses, names: Sequence[str]) -> Array:
    """Return the derivatives (P, n_x, n) of the platform's pose per mm and rad."""
    mechanism = _mechanism(robot)
    theta = robot.joint_sign * poses.joints
    S = mechanism.sensitivity(poses.x, theta, poses.tool, mechanism.rows(robot)).parameters
    return S[:, :, [mechanism.index[name] for name in names]]


def _mechanism(robot: Robot) -> Machine:
    return mechanism_of(robot)


def _tools(tools: Array | Sequence[Sequence[float]]) -> Array:
    points = np.atleast_2d(np.asarray(tools, dtype=float))
    if points.ndim != 2 or points.shape[1] != 3 or not len(points):
        raise UsageError(f"reference points have the shape {points.shape}, but must have (T, 3): x, y, z in mm each.")
    return points


# --------------------------------------------------------------------------------------------------------- the plans


def plan(
    robot: Robot,
    model: str,
    *,
    kind: str | None = None,
    tools: int | Array | Sequence[Sequence[float]] | None = None,
    layers: Sequence[str | float] | None = None,
    start_angle: float = 0.0,
    scaling: str | None = None,
    norm: str = "spectral",
    threshold: float = 0.01,
    n_max: int = 30,
    sigma_mm: float | None = None,
    mount: Mount | None = None,
    singular: tuple[float, float] | None = None,
) -> Plan:
    """Return the papers' poses on the rim of the workspace for n = 3 .. n_max, and the n that the rule chooses.

    Rings in a cylinder (Bai 2015); for a planar machine, rows along the edges of its rectangle (Mei 2018); for an open
    chain joints out of `joint_spread`, from as many as the model needs.

    Where a model has parameters that no poses can tell apart, the largest model within it that has none stands for it,
    or else the parameters that a pivoted QR keeps.

    Parameters
    ----------
    model : str
        ``delta/18`` or ``18``.
    kind : str, optional
        ``distance``, ``position`` or ``pose``; by default distances, and positions of an open chain.
    tools : (T, 3) array or int, optional
        Reference points in {O'} [mm], or how many of `reference_points`. By default one, or two where the model's
        parameters turn the platform and no pose is read; one of an open chain.
    layers : sequence, optional
        See `rings`. By default the middle one for a model with no more parameters than joints, else top and bottom.
    start_angle : float
        [rad]
    scaling : str
        ``paper``, ``table``, ``file`` or ``typical``: see `identifiability.IdentificationMatrix`. By default the
        paper's, or ``typical`` where no paper has one.
    norm : str
        Of the condition number: ``spectral`` or ``frobenius``.
    threshold : float
        Relative change of the condition number that the rule tolerates.
    sigma_mm : float, optional
        Noise per coordinate of a position, for the prediction.
    mount : Mount, optional
        Of a gauge: where its ends are.
    singular : (float, float), optional
        Instead of rings positions drawn at random whose nearest singularity is so far away, from .. to [mm]
        (Traslosheros 2013, section 4: 50 to 100 mm).

    Raises
    ------
    UsageError
        An unknown model, kind, scaling, norm or layer; a gauge without a mount.
    InputError
        The robot file has no workspace.
    NoSolutionError
        A pose of a ring cannot be reached, or lies beyond the joints' limits.

    References
    ----------
    Bai 2015, section 3.3, rule (21): min n subject to |k_n - k_(n-1)| / k_n <= threshold, n >= 3.
    Mei 2018, section 5, rule (31): min n subject to |k_1 - k_m| / k_1 <= threshold, n >= 3, k_m of the corrected gauge.
    """
    task = _task(robot, model, kind, tools, scaling, norm, mount)
    if n_max < FEWEST:
        raise UsageError(f"n_max is {n_max}, but a ring has at least {FEWEST} poses.")
    drawn = None if singular is None else singularities.near(robot, singular, n_max, np.random.default_rng(0))
    if _mechanism(robot).many_ways:
        return _chain_plan(task, threshold, n_max, sigma_mm)
    planar = len(_mechanism(robot).axes) == 2
    if drawn is not None:
        layers = ()
    if layers is None:
        layers = ROUGH if not planar and len(_mechanism(robot).model(model)) <= _mechanism(robot).limbs else FINE
    parts = _parts(layers)

    def ring(n: int) -> Poses:
        if drawn is not None:
            return _reached(robot, drawn[:n], task.tools)
        if not planar:
            return _reached(robot, rings(workspace_of(robot), n, parts, start_angle), task.tools)
        shift = task.tools[0] - robot.tool  # the robot's own reference point runs along the edges
        return _reached(robot, edges(workspace_of(robot), n, parts) + shift, task.tools)

    steps: list[Step] = []
    before = task.step(FEWEST - 1, ring(FEWEST - 1)).condition
    for n in range(FEWEST, n_max + 1):
        steps.append(task.step(n, ring(n), before))
        before = steps[-1].condition
    chosen, settled = rule([step.n for step in steps], [step.change for step in steps], threshold)
    poses = ring(chosen or n_max)
    return Plan(
        **vars(task),
        method="singular" if drawn is not None else "edges" if planar else "rings",
        layers=parts,
        start_angle=start_angle,
        threshold=threshold,
        steps=tuple(steps),
        chosen=chosen,
        settled=settled,
        poses=poses,
        prediction=None if sigma_mm is None or mount is not None else predict(task, poses, sigma_mm),
    )


def _chain_plan(task: Task, threshold: float, n_max: int, sigma_mm: float | None) -> Plan:
    """Return joints of an open chain: as many as the model needs by exchange, then one by one what adds most."""
    wanted = joint_spread(task.robot, CANDIDATES)
    whole, frame = _bases(task, _reached(task.robot, wanted, task.tools))
    fewest = max(FEWEST, _fewest(task, whole))
    if fewest >= n_max:
        raise UsageError(
            f"{task.model} needs {fewest} poses at the least, more than {n_max}: ask for fewer parameters."
        )
    picked = _exchange(whole, frame, fewest, np.random.default_rng(0)).tolist()
    steps: list[Step] = []
    before = math.inf
    for n in range(fewest, n_max + 1):
        if n > fewest:
            gain = _log_det_with(whole, np.array(picked)) - _log_det_with(frame, np.array(picked))
            gain[picked] = -math.inf
            picked.append(int(np.argmax(gain)))
        steps.append(task.step(n, _reached(task.robot, wanted[picked], task.tools), before))
        before = steps[-1].condition
    chosen, settled = rule([step.n for step in steps], [step.change for step in steps], threshold)
    poses = _reached(task.robot, wanted[picked[: chosen or n_max]], task.tools)
    return Plan(
        **vars(task),
        method="joints",
        layers=(),
        start_angle=0.0,
        threshold=threshold,
        steps=tuple(steps),
        chosen=chosen,
        settled=settled,
        poses=poses,
        prediction=None if sigma_mm is None else predict(task, poses, sigma_mm),
    )


def _fewest(task: Task, whole: Array) -> int:
    """Return how many positions carry the unknowns that the candidates' blocks (M, k, rank) can see."""
    return -(-whole.shape[2] // _scalars(task))


def _scalars(task: Task) -> int:
    """Return how many coordinates are read at one position."""
    return _at_poses(task).scalars * len(task.tools)


def _at_poses(task: Task) -> Kind:
    """Return what is read pose by pose: of distances, the positions that they lie between."""
    kind = kind_of(task.kind)
    return kind_of("position") if kind.pairs else kind


def rule(n: Sequence[int], change: Sequence[float], threshold: float) -> tuple[int | None, int | None]:
    """Return the first n whose change is within the threshold, and the first from which on all are (or None)."""
    within = [bool(c <= threshold) for c in change]
    first = next((k for k, held in zip(n, within, strict=True) if held), None)
    settled = next((n[j] for j in range(len(n)) if all(within[j:])), None)
    return first, settled


def d_optimal(
    robot: Robot,
    model: str,
    count: int,
    *,
    candidates: Array | None = None,
    singular: tuple[float, float] | None = None,
    kind: str | None = None,
    tools: int | Array | Sequence[Sequence[float]] | None = None,
    scaling: str | None = None,
    norm: str = "spectral",
    sigma_mm: float | None = None,
    rng: np.random.Generator | None = None,
) -> Plan:
    """Return the `count` positions among the candidates that pin the model down best, by Fedorov's exchange.

    Maximised is the determinant of the information that the positions hold on the model, over the combinations that
    the candidates can see at all. The instrument's frame is unknown and eliminated: one frame for positions, one per
    reference point for distances, which are the same information but for its weights.

    Parameters
    ----------
    count : int
        Number of positions; each is measured once per reference point.
    candidates : (M, 3) array, optional
        Positions of the first reference point in {O} [mm], default `grid`; what cannot be reached is left out. Of an
        open chain joints (M, n_q), as the controller counts, default `joint_spread`.
    singular : (float, float), optional
        Candidates are positions whose nearest singularity is so far away, from .. to [mm]; see `plan`.
    rng : Generator, optional
        Draws the sets from which the exchange sets out; default a fixed one.

    Raises
    ------
    UsageError
        Too few positions for the model, or an unknown name.
    NoSolutionError
        Fewer candidates can be reached than are wanted.

    References
    ----------
    Fedorov 1972, Theory of Optimal Experiments, on exact D-optimal designs.
    """
    task = _task(robot, model, kind, tools, scaling, norm)
    if singular is not None:
        candidates = singularities.near(robot, singular, CANDIDATES, np.random.default_rng(0))
    wanted = candidates_of(robot) if candidates is None else np.atleast_2d(np.asarray(candidates, dtype=float))
    wanted = np.unique(wanted, axis=0)
    wanted = wanted[reach(robot, wanted, task.tools)[1] == ""]
    if len(wanted) < count:
        raise NoSolutionError(f"only {len(wanted)} of the candidates can be reached, but {count} positions are wanted.")
    whole, frame = _bases(task, _reached(robot, wanted, task.tools))
    if count < _fewest(task, whole):
        raise UsageError(
            f"{count} positions give {count * _scalars(task)} coordinates, but {task.model} and the frame have "
            f"{whole.shape[2]} unknowns that can be seen: plan at least {_fewest(task, whole)} positions."
        )
    picked = np.sort(_exchange(whole, frame, count, np.random.default_rng(0) if rng is None else rng))
    poses = _reached(robot, wanted[picked], task.tools)
    return Plan(
        **vars(task),
        method="d-optimal",
        layers=(),
        start_angle=0.0,
        threshold=0.0,
        steps=(task.step(count, poses),),
        chosen=count,
        settled=None,
        poses=poses,
        prediction=None if sigma_mm is None else predict(task, poses, sigma_mm),
    )


def log_determinant(task: Task, targets: Array) -> float:
    """Return what `d_optimal` maximises, in ordinary errors and for noise of 1 mm; -inf where the rank is short."""
    poses = _reached(task.robot, targets, task.tools)
    J, F = _with_frame(task, poses)
    figures = observability(_without(J.reshape(-1, J.shape[2]), F.reshape(-1, F.shape[2])), len(poses))
    return float(2 * np.log(figures.singular_values).sum()) if figures.rank == len(task.names) else -math.inf


def predict(task: Task, poses: Poses, sigma_mm: float) -> Prediction | None:
    """Return the standard deviations to expect from a set of poses, None where its rank is short.

    Distances share the positions they lie between; their correlation is accounted for.
    """
    robot, names, kind, count = task.robot, task.names, kind_of(task.kind), len(poses)
    mechanism = _mechanism(robot)
    scale = column_convention(robot, names, "typical")[0]
    moved = _sensitivity(robot, poses, names) * scale
    if kind.pairs or kind.positions:  # noise is that of the points, which a body's position and turn stand for
        read = _at_poses(task).scalars
        noise = np.zeros((count, 6, read * count))
        noise[:, :read] = np.eye(read * count).reshape(count, read, -1)
        noise[:, 3:] /= TURN_MM
        both = _read(mechanism, kind, poses, np.concatenate([moved, noise], axis=2))
        H, spread_by = both[:, : len(names)], both[:, len(names) :]
    else:
        H = _read(mechanism, kind, poses, moved)
        spread_by = np.eye(len(H))
    if observability(H, count).rank < len(names):
        return None
    response = sigma_mm * np.linalg.pinv(H) @ spread_by
    over = candidates_of(robot)
    over = over[reach(robot, over, task.tools[:1])[1] == ""]
    at = _reached(robot, over, task.tools[:1])
    tool = _read(mechanism, kind_of("position"), at, _sensitivity(robot, at, names) * scale)
    spread = np.linalg.norm((tool @ response).reshape(len(over), -1), axis=1)
    std = np.linalg.norm(response, axis=1) * scale
    return Prediction(sigma_mm, dict(zip(names, std.tolist(), strict=True)), float(spread.mean()), float(spread.max()))


def rank_table(robot: Robot, kind: str = "distance") -> list[RankRow]:
    """Return the rank of every model of the mechanism for one, two and three reference points.

    Poses have no symmetry and fill the workspace, so that a combination which stays unseen is so at all poses.
    """
    mechanism = _mechanism(robot)
    every = [p.name for p in mechanism.parameters]
    rows = []
    for points in range(1, len(OFFSETS) + 1):
        tools = reference_points(robot, points)
        poses = _generic(robot, tools)
        # singular values and null space in few rows
        whole = np.linalg.qr(_matrix(robot, poses, every, kind_of(kind)))[1]
        for model, names in mechanism.models.items():
            columns = [mechanism.index[name] for name in names]
            H, typical = whole[:, columns], mechanism.typical[columns]
            figures = observability(H * typical, len(poses))
            s = figures.singular_values / figures.singular_values[0]
            units = [mechanism.parameters[j].unit for j in columns]
            rows.append(
                RankRow(
                    model=model,
                    points=points,
                    columns=len(names),
                    rank=figures.rank,
                    smallest=float(s[figures.rank - 1]),
                    noise=float(s[figures.rank]) if figures.rank < len(s) else 0.0,
                    unseen=unseen(H, names, units, typical),
                )
            )
    return rows


def _task(
    robot: Robot,
    model: str,
    kind: str | None,
    tools: int | Array | Sequence[Sequence[float]] | None,
    scaling: str | None,
    norm: str,
    mount: Mount | None = None,
) -> Task:
    mechanism = _mechanism(robot)
    if kind is None:
        kind = "position" if mechanism.turning else "distance"
    if scaling is None:
        scaling = "paper" if mechanism.has_scaling("paper", robot) else "typical"
    for what, value, known in (("kind", kind, KINDS), ("scaling", scaling, SCALINGS), ("norm", norm, NORMS)):
        if value not in known:
            raise UsageError(f"there is no {what} '{value}'; known: {', '.join(known)}.")
    names = mechanism.model(model)
    if bool(kind_of(kind).mount) != (mount is not None):
        raise UsageError("a gauge, and nothing else, needs to know where its ends are mounted.")
    if mount is not None:
        tools = mount.platform[None]
    elif tools is None and (len(mechanism.axes) == 2 or mechanism.turning or kind_of(kind).rotations):
        tools = 1
    elif tools is None:
        home = _reached(robot, rings(workspace_of(robot), 1, ()), robot.tool)
        tools = 2 if np.abs(_sensitivity(robot, home, names)[:, 3:]).max(initial=0.0) > RANK_TOLERANCE else 1
    points = reference_points(robot, tools) if isinstance(tools, int) else _tools(tools)
    kept = _kept(robot, names, points, kind_of(kind), mount)
    return Task(
        robot=robot,
        model=mechanism.full_name(model),
        kind=kind,
        scaling=scaling,
        norm=norm,
        names=tuple(name for name in names if name in kept),
        dropped=tuple(name for name in names if name not in kept),
        tools=points,
        mount=mount,
    )


def _kept(robot: Robot, names: Sequence[str], tools: Array, kind: Kind, mount: Mount | None = None) -> set[str]:
    """Return parameters that poses can tell apart: a registered model where one fits, else those of a pivoted QR."""
    poses, typical = _generic(robot, tools), column_convention(robot, names, "typical")[0]
    H = _matrix(robot, poses, names, kind, mount)
    rank = observability(H * typical, len(poses)).rank
    if rank == len(names):
        return set(names)
    for model in _mechanism(robot).models.values():
        columns = [j for j, name in enumerate(names) if name in model]
        if len(model) == len(columns) == rank == observability((H * typical)[:, columns], len(poses)).rank:
            return set(model)
    return set(base_parameters(H, names, typical)[0])


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None


# ------------------------------------------------------------------------------------------------------ D-optimality


def _with_frame(task: Task, poses: Poses) -> tuple[Array, Array]:
    """Return derivatives of the readings by parameters and frames, (P, k, n) and (P, k, n_m), comparable in size.

    Distances lie between positions, of each reference point in a frame of its own.
    """
    found, instrument = _at_poses(task).imagined(poses.x, poses.points, _mechanism(task.robot), Measurement())
    if kind_of(task.kind).pairs:
        found = dataclasses.replace(found, setup=np.repeat(np.arange(poses.points), len(poses) // poses.points))
        instrument = dataclasses.replace(instrument, state=np.tile(instrument.state, (poses.points, 1)))
    moved = _sensitivity(task.robot, poses, task.names) * column_convention(task.robot, task.names, "typical")[0]
    J, F = _linearise(found, instrument, poses.x, moved)
    return J, F / np.linalg.norm(F, axis=(0, 1))


def _bases(task: Task, poses: Poses) -> tuple[Array, Array]:
    """Return orthonormal bases of what the candidates see of parameters and frames, and of the frames alone.

    In blocks (M, k T, rank), one per candidate: determinants in these bases differ from those in parameters by
    a constant, and are well scaled.
    """
    J, F = _with_frame(task, poses)

    def blocks(columns: Array) -> Array:
        U, s, _ = np.linalg.svd(columns.reshape(-1, columns.shape[2]), full_matrices=False)
        by_point = U[:, s > RANK_TOLERANCE * s[0]].reshape(poses.points, len(poses) // poses.points, J.shape[1], -1)
        return np.concatenate(list(by_point), axis=1)

    return blocks(np.concatenate([J, F], axis=2)), blocks(F)


def _exchange(whole: Array, frame: Array, count: int, rng: np.random.Generator) -> np.ndarray:
    """Return the candidates (count,) of the largest determinant of `whole` by that of `frame`."""
    best, found = -math.inf, np.zeros(0, dtype=int)
    for _ in range(STARTS):
        chosen = rng.choice(len(whole), count, replace=False)
        value, improved = -math.inf, True
        while improved:
            improved = False
            for k in range(count):
                rest = np.delete(chosen, k)
                gain = _log_det_with(whole, rest) - _log_det_with(frame, rest)
                gain[rest] = -math.inf
                better = int(np.argmax(gain))
                if gain[better] > gain[chosen[k]] + 1e-9:
                    chosen[k], improved = better, True
                value = float(gain[chosen[k]])
        if value > best + 1e-9:
            best, found = value, chosen.copy()
    return found


def _log_det_with(blocks: Array, rest: np.ndarray) -> Array:
    """Return the log determinant (M,) of the information of `rest` and one more candidate, for each candidate."""
    rows = blocks[rest].reshape(-1, blocks.shape[2])
    L = np.linalg.cholesky(rows.T @ rows + RIDGE * np.eye(blocks.shape[2]))
    half = np.linalg.solve(L, blocks.reshape(-1, blocks.shape[2]).T).T.reshape(blocks.shape)
    added = np.eye(blocks.shape[1]) + half @ np.swapaxes(half, 1, 2)
    gain: Array = np.linalg.slogdet(added)[1] + 2 * np.log(np.diag(L)).sum()
    return gain


# ------------------------------------------------------------------------------------------------------------- files


def target_recording(found: Plan, path: str | Path = "poses.csv") -> Recording:
    """Return a plan's poses as a recording of targets, or of a chain's joints, with nothing measured yet."""
    count, mount, mechanism = len(found.poses), found.mount, _mechanism(found.robot)
    kind = _at_poses(found)
    columns = kind.columns(mechanism)
    return Recording(
        path=Path(path),
        kind=kind.name,
        measurement=Measurement(kind=kind.name) if mount is None else mount.said,
        joint_unit=mechanism.joint_unit,
        joints=found.poses.joints,
        columns=columns,
        measured=np.full((count, len(columns)), np.nan),
        pose=np.arange(1, count + 1).astype(str),
        line=np.arange(2, count + 2),
        channels={},
        setup=np.zeros(count, dtype=int),
        setup_names=("1",),
        tool=found.poses.tool if mount is None else None,
        targets=None if mechanism.many_ways else _with_turns(found),
    )


def _with_turns(found: Plan) -> Array:
    """Return the targets (N, 3) of a plan; of a platform that turns on command the poses (N, 12) that were planned."""
    poses, mechanism = found.poses, _mechanism(found.robot)
    if not mechanism.turning:
        return poses.targets
    q = found.robot.joint_sign * poses.joints
    nominal, _ = mechanism.forward(q, poses.tool, mechanism.rows(dataclasses.replace(found.robot, errors={})))
    return np.hstack([poses.targets, nominal[:, 3:]])


def write_targets(found: Plan, path: str | Path) -> None:
    """Write a plan's targets and tool points as a CSV, with a sidecar, to be measured or simulated.

    Raises
    ------
    InputError
        A file cannot be written.
    """
    write_recording(target_recording(found, path), path)
