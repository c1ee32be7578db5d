"""What is planned, and the matrix by which a set of targets sees the parameters."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import MissingKey, NoPlan
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.sidecar import read_measurement
from deltacal_gen.identification.accuracy import RECURRENCE, joint_spread, turned, workspace_of
from deltacal_gen.identification.identifiability import (
    Observability,
    column_convention,
    observability,
)
from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.instrument.kind import TURN_MM, Instrument, Kind, Readings
from deltacal_gen.instrument.kinds import POINTS, kind_of
from deltacal_gen.instrument.kinds import names as kind_names
from deltacal_gen.machine.registry import Array, Machine, mechanism_of
from deltacal_gen.machine.rotation import about_z
from deltacal_gen.machine.values import Measurement
from deltacal_gen.planning.reach import Poses, middle, place_of, reach, reached_of
from deltacal_gen.planning.rows import joints_in_files
from deltacal_gen.planning.targets import candidates_of, radius, spread_of, width
from deltacal_gen.results import plan as results
from deltacal_gen.results.plan import Expected, Method, PlannedPose
from deltacal_gen.units import to_file

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
class Task:
    """What is to be identified, from which readings, and how its figures are stated.

    Attributes
    ----------
    names, dropped : tuples of str
        Parameters that enter the matrix; those left out because no poses can tell them from the others.
    tools : (T, 3) array
        Reference points in {O'} [mm].
    said : Measurement
        What the sidecar of the readings will say: where a camera is, what of its lens is known; where the ends of a
        gauge are nominally mounted.
    """

    robot: Robot
    model: str
    kind: str
    scaling: str
    norm: str
    names: tuple[str, ...]
    dropped: tuple[str, ...]
    tools: Array
    said: Measurement = field(default=Measurement(), kw_only=True)

    def step(self, n: int, poses: Poses, before: float = math.inf) -> Step:
        """Return the figures of a set of poses; `before` is the condition number of the last smaller one."""
        kind, corrected = kind_of(self.kind), None
        nominal = dataclasses.replace(self, robot=_as_mounted(self.robot, kind)) if kind.mount else self
        H = nominal._columns(poses)
        figures = observability(H, len(poses))
        condition = self._condition(figures)
        if kind.mount:
            corrected = self._condition(observability(self._columns(poses), len(poses)))
        other = before if corrected is None else corrected
        change = abs(condition - other) / condition if math.isfinite(condition) else math.inf
        return Step(n, len(poses), len(H), figures.rank, condition, change, figures.indices, corrected)

    def _columns(self, poses: Poses) -> Array:
        factors, _ = column_convention(self.robot, self.names, self.scaling)
        columns: Array = matrix_of(self.robot, poses, self.names, kind_of(self.kind), self.said) * factors
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
    prediction : Expected or None
        For the noise that was given.
    notes : tuple of str
        What became of poses where the machine may not stand.
    """

    method: Method
    steps: tuple[Step, ...]
    chosen: int | None
    poses: Poses
    layers: tuple[float, ...] = ()
    start_angle: float = 0.0
    threshold: float = 0.0
    settled: int | None = None
    prediction: Expected | None = None
    notes: tuple[str, ...] = ()

    @property
    def conventions(self) -> str:
        """What the figures depend on, in words."""
        within = f"|k(n) - k(n-1)| / k(n) <= {self.threshold:g}"
        match self.method:
            case "edges":
                lowest = "lowest" if len(self.layers) > 1 else "chosen"
                along = f"each of {len(self.layers)} levels of the workspace, all in the same direction, from the "
                along = f"{along}highest to the {lowest}" if mechanism_of(self.robot).limbs > 1 else "the stroke"
                if kind_of(self.kind).mount:
                    errors = "the gauge's errors of the robot file"
                    within = f"|k - corrected| / k, with {errors}, <= {self.threshold:g}"
                poses = f"n evenly spaced poses along {along}; chosen is the smallest n >= {FEWEST} at which every "
                poses += f"parameter shows and {within}."
            case "rings":
                heights = " and ".join(f"{part:.0%}" for part in self.layers)
                poses = (
                    f"Home at the centre of the cylinder and n evenly spaced poses on the rim at {heights} of the "
                    f"height below its top, the first at {math.degrees(self.start_angle):g} deg about z; chosen is the "
                    f"smallest n >= {FEWEST} with {within}, settled the smallest n from which on that holds."
                )
            case "singular":
                poses = "n positions drawn at random of those whose nearest singularity is as far as was asked for; "
                poses += f"chosen is the smallest n with {within}."
            case "joints":
                drawn = spread_of(self.robot, kind_of(self.kind), self.said)
                poses = (
                    f"{drawn[0].upper()}{drawn[1:]}; {self.steps[0].n} of them for the largest determinant of the "
                    "information on the model, the frame eliminated, then one by one what adds most; chosen is the "
                    f"smallest n with {within}. Collisions are not looked for."
                )
            case _:
                poses = f"{self.chosen} candidates, chosen for the largest determinant of the information that their "
                poses += "positions hold on the model, the frame eliminated."
        points = "; ".join(f"({x:g}, {y:g}, {z:g}) mm" for x, y, z in self.tools)
        left_out = f" Left out, as no poses tell them from the others: {', '.join(self.dropped)}." * bool(self.dropped)
        return (
            f"{poses} Readings: {KINDS[self.kind]}. Reference points, at the same joints: {points}. "
            f"Condition number k: {NORMS[self.norm]}, {SCALINGS[self.scaling]}.{left_out}"
        )

    def answer(self) -> results.Plan:
        """Return the same as users read it, in mm and deg; null stands for what is infinite or not there."""
        steps, poses = self.steps, self.poses
        rows = zip(poses.targets.tolist(), poses.tool.tolist(), joints_in_files(self.robot, poses.joints), strict=True)
        return results.Plan(
            robot=self.robot.name,
            mechanism=self.robot.mechanism,
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
            condition=tuple(finite(step.condition) for step in steps),
            corrected=tuple(None if step.corrected is None else finite(step.corrected) for step in steps),
            change=tuple(finite(step.change) for step in steps),
            **indices_of([step.indices for step in steps]),
            chosen=self.chosen,
            settled=self.settled,
            poses=tuple(
                PlannedPose(target_mm=tuple(target), tool_mm=tuple(tool), **joints) for target, tool, joints in rows
            ),
            prediction=self.prediction,
            notes=self.notes or None,
        )


def read_mount(sidecar: str | Path) -> Measurement:
    """Return what a recording's sidecar says; raises InputError where it does not say where a gauge is mounted."""
    measurement = read_measurement(sidecar)
    if measurement.base_point_mm is None or measurement.platform_point_mm is None:
        raise MissingKey(
            "the sidecar does not say where a gauge's ends are mounted.",
            "Add base_point_mm and platform_point_mm to [measurement].",
            file=sidecar,
        )
    return measurement


def generic(robot: Robot, tools: Array, kind: Kind | None = None) -> Poses:
    """Return poses without any symmetry, what can be reached of an additive recurrence in the cylinder.

    Of a kind for which a machine is aimed, those are looked at that come.
    """
    if kind is not None and (kind.aims == "touch" or (kind.aims and mechanism_of(robot).many_ways)):
        return _reachable(robot, candidates_of(robot, kind), tools)
    if mechanism_of(robot).many_ways:
        return reached_of(robot, joint_spread(robot, GENERIC_POSES), tools)
    workspace = workspace_of(robot)
    u = np.outer(np.arange(1, GENERIC_POSES + 1), RECURRENCE) % 1.0
    if len(mechanism_of(robot).axes) == 2:
        return _reachable(robot, workspace.place((u[:, 0] - 0.5) * width(workspace), u[:, 2]), tools)
    r, turn = radius(workspace) * np.sqrt(u[:, 0]), 2 * np.pi * u[:, 1]
    return _reachable(robot, workspace.place(about_z(r, turn), u[:, 2]), tools)


def _reachable(robot: Robot, targets: Array, tools: Array) -> Poses:
    targets = turned(robot, targets)
    why = reach(robot, targets, tools)[1]
    missed = np.flatnonzero(why != "")
    reached = len(why) - len(missed)
    if reached < GENERIC_POSES / 2:
        places = targets[:, :3]
        worst = missed[np.argmin(np.linalg.norm(places[missed] - places.mean(axis=0), axis=1))]
        raise NoPlan(
            f"the machine reaches {reached} of {len(why)} points spread over its workspace: "
            f"{place_of(places[worst])} is {why[worst]}.{middle(robot, tools)} "
            "Check [workspace] and the limits of the joints."
        )
    return reach(robot, targets[why == ""], tools)[0]


def matrix_of(robot: Robot, poses: Poses, names: Sequence[str], kind: Kind, said: Measurement | None = None) -> Array:
    """Return the identification matrix of readings at poses; of a gauge that of differences of adjacent rows."""
    moved = sensitivity(robot, poses, names)
    if said is None or not kind.mount:
        return read_of(mechanism_of(robot), kind, poses, moved, said)
    return _mounted(robot, poses, names, kind, moved, said)


def _mounted(robot: Robot, poses: Poses, names: Sequence[str], kind: Kind, moved: Array, said: Measurement) -> Array:
    """Return differences of adjacent rows of what a gauge reads, its own errors among the parameters."""
    mechanism = mechanism_of(robot)
    found, instrument = kind.imagined(poses.x, poses.points, mechanism, said)
    others = tuple(u for u in instrument.free if u not in kind.carried(mechanism))
    instrument = dataclasses.replace(instrument, free=others).mounted(mechanism, mechanism.vector(robot.errors))
    J, J_m = instrument.linearise(found, poses.x, moved)
    instrument.add_carried(J, mechanism, names, found, poses.x)
    J, J_m = np.diff(J[:, 0], axis=0), np.diff(J_m[:, 0], axis=0)
    return project_out(J, basis(J_m)) if others else J


def _as_mounted(robot: Robot, kind: Kind) -> Robot:
    """Return the robot with no errors of a gauge: as its ends are nominally mounted."""
    own = {mechanism_of(robot).parameters[p].name for p in kind.carried(mechanism_of(robot)).values()}
    return dataclasses.replace(robot, errors={k: v for k, v in robot.errors.items() if k not in own})


def read_of(mechanism: Machine, kind: Kind, poses: Poses, moved: Array, said: Measurement | None = None) -> Array:
    """Return how readings change (rows, n) where the platform moves by `moved` (P, n_x, n); the frame projected out."""
    found, instrument = kind.imagined(poses.x, poses.points, mechanism, said or Measurement())
    J, J_m = linearise(found, instrument, poses.x, moved)
    J = J.reshape(-1, moved.shape[2])
    return project_out(J, basis(J_m.reshape(len(J), -1))) if instrument.n_unknown else J


def linearise(found: Readings, instrument: Instrument, x: Array, moved: Array) -> tuple[Array, Array]:
    """Return derivatives of readings by parameters and by the instrument's unknowns, turns as shifts of `TURN_MM`."""
    J, J_m = instrument.linearise(found, x, moved)
    for derivatives in (J, J_m):
        derivatives[:, list(found.kind.turned)] *= TURN_MM
    return J, J_m


def sensitivity(robot: Robot, poses: Poses, names: Sequence[str]) -> Array:
    """Return the derivatives (P, n_x, n) of the platform's pose per mm and rad."""
    mechanism = mechanism_of(robot)
    theta = robot.joint_sign * poses.joints
    S = mechanism.sensitivity(poses.x, theta, poses.tool, mechanism.rows(robot)).parameters
    return S[:, :, [mechanism.index[name] for name in names]]


def at_poses(task: Task) -> Kind:
    """Return what is read pose by pose: of distances, the positions that they lie between."""
    kind = kind_of(task.kind)
    return kind_of(POINTS) if kind.pairs else kind


def rule(n: Sequence[int], change: Sequence[float], threshold: float) -> tuple[int | None, int | None]:
    """Return the first n whose change is within the threshold, and the first from which on all are (or None)."""
    within = [bool(c <= threshold) for c in change]
    first = next((k for k, held in zip(n, within, strict=True) if held), None)
    settled = next((n[j] for j in range(len(n)) if all(within[j:])), None)
    return first, settled


def indices_of(found: Sequence[Mapping[str, float]]) -> dict[str, Any]:
    """Return observability indices O1 .. O5 of several sets as answers have them: a tuple for each."""
    return {name: tuple(indices[name] for indices in found) for name in found[0]} if found else {}


def finite(value: float) -> float | None:
    """Return a number as answers have it: null where it is infinite."""
    return float(value) if math.isfinite(value) else None
