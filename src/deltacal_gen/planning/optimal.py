"""Targets that together tell most: D-optimal choice, one by one and by exchange."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence

import numpy as np

from deltacal_gen.errors import NoPlan, OptionNotApplicable, UnknownName, WrongArray
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.accuracy import turned, workspace_of
from deltacal_gen.identification.identifiability import (
    RANK_TOLERANCE,
    base_parameters,
    column_convention,
    observability,
)
from deltacal_gen.instrument.kind import TURN_MM, Kind
from deltacal_gen.instrument.kinds import POINTS, kind_of, usual
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Measurement
from deltacal_gen.planning import singularities
from deltacal_gen.planning.matrix import (
    KINDS,
    NORMS,
    SCALINGS,
    Plan,
    Task,
    at_poses,
    generic,
    linearise,
    matrix_of,
    read_of,
    sensitivity,
)
from deltacal_gen.planning.reach import Poses, reach, reached_of, readable_targets, tools_of
from deltacal_gen.planning.targets import CANDIDATES, candidates_of, reference_points, rings
from deltacal_gen.results.plan import Deviation, Expected
from deltacal_gen.units import file_unit, to_file

RIDGE = 1e-9  # of the information of all candidates: keeps the determinant of a poor set above zero
STARTS = 5  # random sets from which the exchange sets out


def fewest_of(task: Task, whole: Array) -> int:
    """Return how many positions carry the unknowns that the candidates' blocks (M, k, rank) can see."""
    return -(-whole.shape[2] // _scalars(task))


def _scalars(task: Task) -> int:
    """Return how many coordinates are read at one position."""
    return at_poses(task).per_pose * len(task.tools)


def plan_optimal_poses(
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
    said: Measurement | None = None,
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
        Candidates are positions whose nearest singularity is so far away, from .. to [mm]; see `plan_poses`.
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
    task = task_of(robot, model, kind, tools, scaling, norm, said=said)
    if singular is not None:
        candidates = singularities.near(robot, singular, CANDIDATES, np.random.default_rng(0))
    if candidates is None:
        candidates = readable_targets(robot, candidates_of(robot, at_poses(task)))
    wanted = reachable(task, turned(robot, np.unique(np.atleast_2d(np.asarray(candidates, dtype=float)), axis=0)))
    if len(wanted) < count:
        raise NoPlan(f"only {len(wanted)} of the candidates can be reached, but {count} positions are wanted.")
    whole, frame = bases(task, reached_of(robot, wanted, task.tools))
    if count < (fewest := fewest_of(task, whole)):
        raise WrongArray(
            f"{count} positions give {count * _scalars(task)} coordinates, but {task.model} and the frame have "
            f"{whole.shape[2]} unknowns that can be seen: plan at least {fewest} positions."
        )
    picked = np.sort(exchange(whole, frame, count, np.random.default_rng(0) if rng is None else rng))
    poses = reached_of(robot, wanted[picked], task.tools)
    return Plan(
        **vars(task),
        method="d-optimal",
        steps=(task.step(count, poses),),
        chosen=count,
        poses=poses,
        prediction=predict(task, poses, sigma_mm),
    )


def reachable(task: Task, wanted: Array) -> Array:
    """Return those of the targets, or of a chain's joints, at which the machine can be measured."""
    return wanted[reach(task.robot, wanted, task.tools)[1] == ""]


def predict(task: Task, poses: Poses, sigma_mm: float | None) -> Expected | None:
    """Return the standard uncertainties to expect from a set of poses, by unweighted least squares.

    None where no noise is given, where the rank is short, or of a gauge. Distances share the positions they lie
    between; their correlation is accounted for. Those of the tool position over the workspace are roots of the summed
    variances of its coordinates, up to a motion of the frame, which neither distances nor positions in an unknown frame
    determine.
    """
    if sigma_mm is None or kind_of(task.kind).mount:
        return None
    robot, names, kind, count = task.robot, task.names, kind_of(task.kind), len(poses)
    mechanism = mechanism_of(robot)
    scale = column_convention(robot, names, "typical")[0]
    moved = sensitivity(robot, poses, names) * scale
    if kind.pairs or kind.positions:  # noise is that of the points, which a body's position and turn stand for
        read = at_poses(task).scalars
        noise = np.zeros((count, 6, read * count))
        noise[:, :read] = np.eye(read * count).reshape(count, read, -1)
        noise[:, 3:] /= TURN_MM
        both = read_of(mechanism, kind, poses, np.concatenate([moved, noise], axis=2), task.said)
        H, spread_by = both[:, : len(names)], both[:, len(names) :]
    else:
        H = read_of(mechanism, kind, poses, moved, task.said)
        spread_by = np.eye(len(H))
    if observability(H, count).rank < len(names):
        return None
    response = sigma_mm * np.linalg.pinv(H) @ spread_by
    one = dataclasses.replace(task, tools=task.tools[:1])
    over = reachable(one, turned(robot, candidates_of(robot)))
    at = reached_of(robot, over, one.tools)
    tool = read_of(mechanism, kind_of(POINTS), at, sensitivity(robot, at, names) * scale)
    spread = np.linalg.norm((tool @ response).reshape(len(over), -1), axis=1)
    std = (np.linalg.norm(response, axis=1) * scale).tolist()
    units = [mechanism.parameters[mechanism.index[name]].unit for name in names]
    return Expected(
        sigma_mm=sigma_mm,
        parameters=tuple(
            Deviation(name=name, std=to_file(value, unit), unit=file_unit(unit))
            for name, value, unit in zip(names, std, units, strict=True)
        ),
        tool_mean_mm=float(spread.mean()),
        tool_max_mm=float(spread.max()),
    )


def task_of(
    robot: Robot,
    model: str,
    kind: str | None,
    tools: int | Array | Sequence[Sequence[float]] | None,
    scaling: str | None,
    norm: str,
    said: Measurement | None = None,
) -> Task:
    """Return the task of a plan, what was not said chosen by the machine: kind, scaling and reference points."""
    mechanism = mechanism_of(robot)
    kind = kind and next((name for name in KINDS if kind in kind_of(name).aliases), kind)
    if kind is None:
        kind = usual(mechanism)
    if scaling is None:
        scaling = "paper" if mechanism.has_scaling("paper", robot) else "typical"
    for what, value, known in (("kind", kind, KINDS), ("scaling", scaling, SCALINGS), ("norm", norm, NORMS)):
        if value not in known:
            words = sorted(kind_of(n).words for n in known) if what == "kind" else known
            raise UnknownName(f"there is no {what} '{value}'; known: {', '.join(words)}.")
    names = mechanism.model(model)
    said = said or Measurement()
    if bool(kind_of(kind).mount) == (None in (said.base_point_mm, said.platform_point_mm)):
        raise OptionNotApplicable("a gauge, and nothing else, needs to know where its ends are mounted.")
    if said.platform_point_mm is not None:
        tools = np.array([said.platform_point_mm])
        said = dataclasses.replace(said, kind=kind, frame="robot", zero="incremental")
    elif tools is None and (len(mechanism.axes) == 2 or mechanism.turning or kind_of(kind).rotations):
        tools = 1
    elif tools is None:
        home = reached_of(robot, rings(workspace_of(robot), 1, ()), robot.tool)
        tools = 2 if np.abs(sensitivity(robot, home, names)[:, 3:]).max(initial=0.0) > RANK_TOLERANCE else 1
    points = reference_points(robot, tools) if isinstance(tools, int) else tools_of(tools)
    kept = _kept(robot, names, points, kind_of(kind), said)
    return Task(
        robot=robot,
        model=mechanism.full_name(model),
        kind=kind,
        scaling=scaling,
        norm=norm,
        names=tuple(name for name in names if name in kept),
        dropped=tuple(name for name in names if name not in kept),
        tools=points,
        said=said,
    )


def _kept(robot: Robot, names: Sequence[str], tools: Array, kind: Kind, said: Measurement) -> set[str]:
    """Return parameters that poses can tell apart: a registered model where one fits, else those of a pivoted QR."""
    poses, typical = generic(robot, tools, kind), column_convention(robot, names, "typical")[0]
    H = matrix_of(robot, poses, names, kind, said)
    rank = observability(H * typical, len(poses)).rank
    if rank == len(names):
        return set(names)
    for model in mechanism_of(robot).models.values():
        columns = [j for j, name in enumerate(names) if name in model]
        if len(model) == len(columns) == rank == observability((H * typical)[:, columns], len(poses)).rank:
            return set(model)
    return set(base_parameters(H, names, typical))


def with_frame(task: Task, poses: Poses) -> tuple[Array, Array, Array]:
    """Return derivatives of the readings by parameters and frames, (R, k, n) and (R, k, n_m), comparable in size.

    And the pose (R,) of each reading: what stands out of sight has none, an image has several.

    Distances lie between positions, of each reference point in a frame of its own.
    """
    found, instrument = at_poses(task).imagined(poses.x, poses.points, mechanism_of(task.robot), task.said)
    if kind_of(task.kind).pairs:
        found = dataclasses.replace(found, setup=np.repeat(np.arange(poses.points), len(poses) // poses.points))
        instrument = dataclasses.replace(instrument, state=np.tile(instrument.state, (poses.points, 1)))
    moved = sensitivity(task.robot, poses, task.names) * column_convention(task.robot, task.names, "typical")[0]
    J, F = linearise(found, instrument, poses.x, moved)
    return J, F / np.where((size := np.linalg.norm(F, axis=(0, 1))) > 0, size, 1.0), found.rows[:, 0]


def bases(task: Task, poses: Poses) -> tuple[Array, Array]:
    """Return orthonormal bases of what the candidates see of parameters and frames, and of the frames alone.

    In blocks (M, k T, rank), one per candidate: determinants in these bases differ from those in parameters by
    a constant, and are well scaled.
    """
    J, F, at = with_frame(task, poses)
    order = np.arange(len(at)) - np.searchsorted(at, at)  # of a reading among those of its pose
    k, most = J.shape[1], int(order.max()) + 1

    def blocks(columns: Array) -> Array:
        U, s, _ = np.linalg.svd(columns.reshape(-1, columns.shape[2]), full_matrices=False)
        seen = U[:, s > RANK_TOLERANCE * s[0]].reshape(len(at), k, -1)
        each = np.zeros((len(poses), most, k, seen.shape[2]))
        each[at, order] = seen
        by_point = each.reshape(poses.points, len(poses) // poses.points, most * k, -1)
        return np.concatenate(list(by_point), axis=1)

    return blocks(np.concatenate([J, F], axis=2)), blocks(F)


def exchange(whole: Array, frame: Array, count: int, rng: np.random.Generator) -> np.ndarray:
    """Return the candidates (count,) of the largest determinant of `whole` by that of `frame`."""
    best, found = -math.inf, np.zeros(0, dtype=int)
    for _ in range(STARTS):
        chosen = rng.choice(len(whole), count, replace=False)
        value, improved = -math.inf, True
        while improved:
            improved = False
            for k in range(count):
                rest = np.delete(chosen, k)
                gain = log_det_with(whole, rest) - log_det_with(frame, rest)
                gain[rest] = -math.inf
                better = int(np.argmax(gain))
                if gain[better] > gain[chosen[k]] + 1e-9:
                    chosen[k], improved = better, True
                value = float(gain[chosen[k]])
        if value > best + 1e-9:
            best, found = value, chosen.copy()
    return found


def log_det_with(blocks: Array, rest: np.ndarray) -> Array:
    """Return the log determinant (M,) of the information of `rest` and one more candidate, for each candidate."""
    rows = blocks[rest].reshape(-1, blocks.shape[2])
    L = np.linalg.cholesky(rows.T @ rows + RIDGE * np.eye(blocks.shape[2]))
    half = np.linalg.solve(L, blocks.reshape(-1, blocks.shape[2]).T).T.reshape(blocks.shape)
    added = np.eye(blocks.shape[1]) + half @ np.swapaxes(half, 1, 2)
    gain: Array = np.linalg.slogdet(added)[1] + 2 * np.log(np.diag(L)).sum()
    return gain
