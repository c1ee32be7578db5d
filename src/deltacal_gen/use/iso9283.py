"""Figures of ISO 9283:1998 for positions: accuracy and repeatability of a pose and of a distance.

All are of the attained positions of repeated visits in the same direction; the standard asks for `CYCLES` of them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from deltacal_gen.machine.registry import Array

CYCLES = 30  # 7.2.1, 7.2.2 and 7.3: visits of a pose


@dataclass(frozen=True)
class Figures:
    """Accuracy and repeatability [mm], from `readings` visits.

    Attributes
    ----------
    accuracy : float
        AP, distance from the wanted position to the mean attained one; or AD, mean attained distance less the wanted
        one, with its sign.
    repeatability : float
        RP, mean plus three standard deviations of the distances from the mean position; or RD, plus or minus three
        standard deviations of the distance.
    """

    accuracy: float
    repeatability: float
    readings: int


def pose(attained: Array, wanted: Array) -> Figures:
    """Return AP and RP of attained positions (n, 3) of one wanted position (3,) [mm] (ISO 9283, 7.2.1 and 7.2.2).

    Raises
    ------
    ValueError
        Fewer than two visits.
    """
    _several(attained)
    mean = attained.mean(axis=0)
    spread = np.linalg.norm(attained - mean, axis=1)
    return Figures(float(np.linalg.norm(mean - wanted)), float(spread.mean() + 3 * spread.std(ddof=1)), len(attained))


def distance(first: Array, second: Array, wanted: float) -> Figures:
    """Return AD and RD of the distance between attained positions (n, 3) of two poses [mm] (ISO 9283, 7.3.2 and 7.3.3).

    Traslosheros 2013 (appendix) takes the absolute value of AD, which loses whether distances are too long.

    Raises
    ------
    ValueError
        Fewer than two visits.
    """
    _several(first)
    attained = np.linalg.norm(second - first, axis=1)
    return Figures(float(attained.mean() - wanted), float(3 * attained.std(ddof=1)), len(attained))


def _several(attained: Array) -> None:
    if len(attained) < 2:
        raise ValueError("figures of ISO 9283 need at least two visits of a pose.")
