"""Folds: readings parted into those that fit and those that judge."""

from __future__ import annotations

import numpy as np

from deltacal_gen.estimation.ends import points_of
from deltacal_gen.estimation.series import points_of_a_pose, sequence
from deltacal_gen.instrument.kind import Readings
from deltacal_gen.instrument.sampled import at_rate, runs_of
from deltacal_gen.machine.values import Recording

FOLDS = 5
LEAST_RUNS = 3  # of a recording in motion, so that whole runs are held out
STRETCHES, STRETCH = 20, 1.0  # of one of fewer runs: how many, and how long at least [s]
SEED = 20150415  # of the folds: results do not change from run to run


# ------------------------------------------------------------------------------------------------------- held out


def folds(
    found: Readings, recording: Recording, count: int = FOLDS, rows: float = 1.0
) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return (train, test) masks of readings; repeats of a pose, or of a pair of poses, stay together.

    So do several points that were read where the machine stood, and neighbours whose noise hangs together over `rows`:
    readings of one error say nothing of one another.

    Distances made of positions are split by pose: a distance counts where both its poses are in the same part. So are
    those whose noise is of the points they share, along the way from point to point.
    """
    rng = np.random.default_rng(SEED)
    if rows > 1 and found.rows.shape[1] > 1:
        ends, points = points_of(found, recording)
        part = _along(ends, points, count)[ends]
        return [((part != k).all(axis=1), (part == k).all(axis=1)) for k in range(count)]
    if found.made:
        _, pose = np.unique(recording.pose, return_inverse=True)
        ends = pose[found.rows]
        part = _parts(int(pose.max()) + 1, count, rng)[ends]
        return [((part != k).all(axis=1), (part == k).all(axis=1)) for k in range(count)]
    group = stands(found, recording) if not at_rate(recording) else _stretches(found, recording)
    group = np.unique(group, return_inverse=True)[1]  # of poses that were not read there is no group
    groups = int(group.max()) + 1
    if rows > 1:
        first = np.unique(group[np.argsort(sequence(found, recording), kind="stable")], return_index=True)[1]
        size = max(min(int(np.ceil(rows)), groups // (2 * count)), 1)
        group = (np.argsort(np.argsort(first)) // size)[group]
        groups = int(group.max()) + 1
    part = _parts(groups, min(count, groups), rng)[group]
    return [(part != k, part == k) for k in range(min(count, groups))]


def stands(found: Readings, recording: Recording) -> np.ndarray:
    """Return groups (R,) of readings: all of one pose, whichever point of the machine they are of.

    What a model lacks at a pose moves all its points alike: none of them judges what was fitted to another. Of fewer
    poses than parts points are all there is to part. Readings of two rows are grouped as they are.
    """
    stand = points_of_a_pose(found, recording)
    return found.group if stand is None or len(np.unique(stand)) < FOLDS else stand


def _stretches(found: Readings, recording: Recording) -> np.ndarray:
    """Return groups (R,) of readings in motion: whole runs, of fewer than `LEAST_RUNS` stretches of at least a second.

    Neighbours in time are not independent.
    """
    label = np.empty(recording.n_rows)
    runs, time = runs_of(recording), recording.time_s
    assert time is not None
    length = max(STRETCH, sum(float(np.ptp(time[rows])) for rows in runs) / STRETCHES)
    done = 0
    for rows in runs:
        at = np.floor((time[rows] - time[rows[0]]) / length) if len(runs) < LEAST_RUNS else np.zeros(len(rows))
        label[rows] = done + at
        done += int(at.max(initial=0.0)) + 1
    return np.ravel(np.unique(label[found.rows[:, 0]], return_inverse=True)[1])


def _along(ends: np.ndarray, points: int, count: int) -> np.ndarray:
    """Return the part (points,) of each point that distances (R, 2) lie between: neighbours are in one, mostly.

    In the order of Cuthill and McKee (1969) neighbours stand near to one another; of a chain it is the chain's own.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import reverse_cuthill_mckee

    both = np.vstack([ends, ends[:, ::-1]]).T
    graph = coo_array((np.ones(both.shape[1]), both), shape=(points, points)).tocsr()
    part = np.empty(points, dtype=int)
    part[reverse_cuthill_mckee(graph, symmetric_mode=True)] = np.arange(points) * count // points
    return part


def _parts(n: int, count: int, rng: np.random.Generator) -> np.ndarray:
    return rng.permutation(np.arange(n) % count)
