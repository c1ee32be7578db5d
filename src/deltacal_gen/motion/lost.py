"""Readings that were lost: a logger that no longer hears a drive writes its last reading on, or zeros."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np

from deltacal_gen.motion.joint import USUAL, Joint
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.trajectories import Trajectories

SELDOM = 0.05  # of the stretches of equal readings longer than one sample: those of a drive that hardly repeats itself
CHANCE = 1e-6  # of a stretch of equal readings, where one is like the next as seldom as elsewhere
ROUNDS = 3
MOST = 0.5  # of a joint's samples: fewer that change do not refute more that stand still
STALE = 3.0  # times the rest elsewhere: where a reading stands still and is off by more it is none


def lost(given: Trajectories, joint: Joint) -> np.ndarray:
    """Return the rows (K,) at which a joint's reading stands still for long, and other rows do not foretell it.

    Where the drive really gave the same all along, a fit of the rigid machine with usual friction to the other rows is
    no worse there. A drive whose reading often repeats itself, for its coarse counts, tells nothing.
    """
    y, nothing = given.readings[:, joint.number - 1], np.empty(0, dtype=int)
    equal = (np.diff(y) == 0) & (np.diff(given.piece) == 0)
    stretch = np.concatenate([[0], np.cumsum(~equal)])
    length, seldom = np.bincount(stretch), 1.0
    ordinary = np.ones(len(length), dtype=bool)
    for _ in range(ROUNDS):  # stretches that stand out say nothing of how often a reading repeats itself
        seldom = max(float(np.mean(length[ordinary] > 1)), 1.0 / len(length))
        ordinary = len(y) * seldom ** (length - 1.0) >= CHANCE
    still = ~ordinary[stretch]
    seen = still[joint.rows]
    if seldom > SELDOM or not 0.0 < np.mean(seen) < MOST:
        return nothing
    X = joint.columns([Rung(name) for name in USUAL], joint.load_by(None))
    left = joint.y - X @ np.linalg.lstsq(X[~seen], joint.y[~seen], rcond=1e-9)[0]
    off, elsewhere = (float(np.mean(left[of] ** 2)) for of in (seen, ~seen))
    return np.flatnonzero(still) if off > STALE**2 * elsewhere else nothing


def without_lost(given: Trajectories, joints: Sequence[Joint]) -> Trajectories | None:
    """Return a recording without the readings that were lost, and what is said of it; None where none were."""
    readings, repairs, lines = given.readings.copy(), list(given.repairs), set(given.repaired)
    for joint in joints:
        rows = lost(given, joint)
        if len(rows):
            readings[rows, joint.number - 1] = np.nan
            lines |= set(given.line[rows].tolist())
            repairs.append(
                f"{given.path}:{given.line[rows[0]]}: {given.columns[joint.number - 1]} stands still, here and on "
                f"{len(rows) - 1} rows more, where all others foretell something else; these readings are left out"
            )
    if len(repairs) == len(given.repairs):
        return None
    return dataclasses.replace(given, readings=readings, repairs=tuple(repairs), repaired=tuple(sorted(lines)))
