"""Figures of ISO 230-2 for one axis: accuracy and repeatability of positions that are approached from both sides.

Deviations are attained minus wanted. With mean and standard deviation of each position and direction: `B` the
reversal, `M` the range of the bi-directional means, `E` the systematic deviation, `R` the repeatability and `A` the
accuracy, bi-directional, with two standard deviations.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from deltacal_gen.machine.registry import Array

FEWEST = 2  # readings of a position from either side, without which nothing spreads


class Axis(NamedTuple):
    """Figures of an axis [mm] by their letters, over the positions that were read often enough from both sides.

    `positions` (P,) says which; `means` and `spreads` (P, 2) are of the side from below and that from above.
    """

    positions: np.ndarray
    means: Array
    spreads: Array
    A: float
    E: float
    R: float
    B: float
    M: float


def axis(deviation: Array, position: np.ndarray, way: Array) -> Axis | None:
    """Return the figures of deviations (R,) [mm]; None where no position was read twice from both sides.

    Parameters
    ----------
    position : (R,) int array
        Which of the positions each belongs to.
    way : (R,) array
        From which side it came, 1 or -1.

    References
    ----------
    ISO 230-2:2014, sections 2.13 to 2.22.
    """
    which, means, spreads = [], [], []
    for p in np.unique(position):
        sides = [deviation[(position == p) & (way == side)] for side in (1, -1)]
        if min(map(len, sides)) >= FEWEST:
            which.append(p)
            means.append([side.mean() for side in sides])
            spreads.append([side.std(ddof=1) for side in sides])
    if not means:
        return None
    x, s = np.array(means), np.array(spreads)
    reversal = np.abs(x[:, 0] - x[:, 1])
    repeated = np.maximum(2 * s.sum(axis=1) + reversal, 4 * s.max(axis=1))
    return Axis(
        positions=np.array(which),
        means=x,
        spreads=s,
        A=float((x + 2 * s).max() - (x - 2 * s).min()),
        E=float(np.ptp(x)),
        R=float(repeated.max()),
        B=float(reversal.max()),
        M=float(np.ptp(x.mean(axis=1))),
    )
