"""What plans are held against: ranks of models, the matrix of a recording to come, what a D-optimal set makes large."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.identifiability import Combination, observability, unseen
from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.instrument.kinds import PAIRS, kind_of
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.planning.matrix import Task, generic, matrix_of
from deltacal_gen.planning.optimal import with_frame
from deltacal_gen.planning.reach import reached_of
from deltacal_gen.planning.targets import OFFSETS, reference_points


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


def rank_table(robot: Robot, kind: str = PAIRS) -> list[RankRow]:
    """Return the rank of every model of the mechanism for one, two and three reference points.

    Poses have no symmetry and fill the workspace, so that a combination which stays unseen is so at all poses.
    """
    mechanism = mechanism_of(robot)
    every = [p.name for p in mechanism.parameters]
    rows = []
    for points in range(1, len(OFFSETS) + 1):
        tools = reference_points(robot, points)
        poses = generic(robot, tools)
        # singular values and null space in few rows
        whole = np.linalg.qr(matrix_of(robot, poses, every, kind_of(kind)))[1]
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


def design(robot: Robot, targets: Array, tools: Array, names: Sequence[str], kind: str = PAIRS) -> Array:
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
    return matrix_of(robot, reached_of(robot, targets, tools), names, kind_of(kind))


def log_determinant(task: Task, targets: Array) -> float:
    """Return what an optimal set maximises, in ordinary errors, for noise of 1 mm; -inf where the rank is short."""
    poses = reached_of(task.robot, targets, task.tools)
    J, F, _ = with_frame(task, poses)
    figures = observability(project_out(J.reshape(-1, J.shape[2]), basis(F.reshape(-1, F.shape[2]))), len(poses))
    return float(2 * np.log(figures.singular_values).sum()) if figures.rank == len(task.names) else -math.inf
