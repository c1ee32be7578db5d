"""Covariances as files keep them, a triangle of numbers, and how wide a band of 95 % is by them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

HELD = 0.95  # probability of a band
DIGITS = 10  # of the factor that is kept


def packed(C: Array) -> Array:
    """Return the lower triangle of a factor L with C = L L', row by row; sums of squares lose no digits of it."""
    size = np.sqrt(np.maximum(np.diag(C), 0.0))
    unit = np.where(size > 0, size, 1.0)
    values, vectors = np.linalg.eigh(C / np.outer(unit, unit))
    R: Array = np.asarray(np.linalg.qr((vectors * np.sqrt(np.maximum(values, 0.0))).T, mode="r"))
    L = (R * np.where(np.diag(R) < 0, -1.0, 1.0)[:, None]).T * unit[:, None]
    lower: Array = L[np.tril_indices(len(L))]
    return np.array([float(f"{v:.{DIGITS - 1}e}") for v in lower.tolist()])


def unpacked(lower: Array) -> Array:
    """Return L (n, n) of its lower triangle, row by row."""
    n = int((np.sqrt(8 * len(lower) + 1) - 1) / 2 + 0.5)
    out = np.zeros((n, n))
    out[np.tril_indices(n)] = lower
    return out


def quantile(degrees: float) -> float:
    """Return the number of standard deviations within which `HELD` of a t distribution lies."""
    from scipy.special import stdtrit

    return float(stdtrit(degrees, (1 + HELD) / 2))
