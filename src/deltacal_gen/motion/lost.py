"""Readings that were lost: a logger that no longer hears a drive writes its last reading on, or zeros.

And those that were cut off: what a drive or its instrument reads at a limit tells nothing of what lies beyond.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.motion.joint import USUAL, Joint
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.trajectories import Trajectories

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

SELDOM = 0.05  # of the stretches of equal readings longer than one sample: those of a drive that hardly repeats itself
CHANCE = 1e-6  # of a stretch of equal readings, where one is like the next as seldom as elsewhere
ROUNDS = 3
MOST = 0.5  # of a joint's samples: fewer that change do not refute more that stand still
BEYOND = 10  # values next to the largest: that of a reading that was not cut off comes less often than these together
CUT = 20  # readings at a limit, at least
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


def limits(y: Array) -> Array:
    """Return the values (K,) at which readings (N,) were cut off: the largest comes again and again, or the smallest.

    Of any other reading those near its largest become ever rarer. One that is mostly at a limit tells nothing else, nor
    does one that repeats itself elsewhere, too: that is how it counts, or what it was told. Zeros are no limit: they
    are what a logger writes that hears nothing.
    """
    values, counts = np.unique(y, return_counts=True)
    if len(values) <= 2 * BEYOND:
        return values[:0]
    most = [max(CUT, int(beside.sum())) for beside in (counts[1 : 1 + BEYOND], counts[-1 - BEYOND : -1])]
    found: Array = values[np.array([0, -1])[(counts[[0, -1]] > most) & (values[[0, -1]] != 0)]]
    elsewhere = y[~np.isin(y, found)]
    if len(elsewhere) <= (1.0 - MOST) * len(y) or np.mean(np.diff(elsewhere) == 0) > SELDOM:
        return values[:0]
    return found


def without_lost(given: Trajectories, joints: Sequence[Joint]) -> Trajectories | None:
    """Return a recording without the readings that were lost or cut off, and what is said of it; None without any."""
    readings, repairs, lines = given.readings.copy(), list(given.repairs), set(given.repaired)
    for joint in joints:
        y = given.readings[:, joint.number - 1]
        rows, why = np.flatnonzero(np.isin(y, limits(y[joint.rows]))), "is at a limit, {}: what lies beyond is not seen"
        if not len(rows):
            rows, why = lost(given, joint), "stands still, {}, where all others foretell something else"
        if len(rows):
            readings[rows, joint.number - 1] = np.nan
            lines |= set(given.line[rows].tolist())
            where = f"{given.path}:{given.line[rows[0]]}: {given.columns[joint.number - 1]}"
            here = f"here and on {len(rows) - 1} rows more"
            repairs.append(f"{where} {why.format(here)}; these readings are left out")
    if len(repairs) == len(given.repairs):
        return None
    return dataclasses.replace(given, readings=readings, repairs=tuple(repairs), repaired=tuple(sorted(lines)))
