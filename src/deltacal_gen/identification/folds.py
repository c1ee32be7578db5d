"""Folds: readings parted into those that fit and those that judge."""

from __future__ import annotations

import numpy as np

from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.values import Recording

FOLDS = 5
SEED = 20150415  # of the folds: results do not change from run to run


# ------------------------------------------------------------------------------------------------------- held out


def folds(found: Readings, recording: Recording, count: int = FOLDS) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return (train, test) masks of readings; repeats of a pose, or of a pair of poses, stay together.

    Distances made of positions are split by pose: a distance counts where both its poses are in the same part.
    """
    rng = np.random.default_rng(SEED)
    if found.made:
        _, pose = np.unique(recording.pose, return_inverse=True)
        ends = pose[found.rows]
        part = _parts(int(pose.max()) + 1, count, rng)[ends]
        return [((part != k).all(axis=1), (part == k).all(axis=1)) for k in range(count)]
    group, run = found.group, recording.channels.get("run")
    if found.kind.in_motion and run is not None and len(np.unique(run[found.rows[:, 0]])) > 1:
        group = np.unique(run[found.rows[:, 0]], return_inverse=True)[1]  # neighbours in time are not independent
    groups = int(group.max()) + 1
    part = _parts(groups, min(count, groups), rng)[group]
    return [(part != k, part == k) for k in range(min(count, groups))]


def _parts(n: int, count: int, rng: np.random.Generator) -> np.ndarray:
    return rng.permutation(np.arange(n) % count)
