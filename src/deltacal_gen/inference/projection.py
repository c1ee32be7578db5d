"""Projection of nuisance columns: what is estimated with a flat prior is taken out of the rows."""

from __future__ import annotations

from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]

DEPENDENT = 1e-10  # of the largest singular value of columns of unit length: less is rounding of what others span


def basis(columns: Array, tolerance: float = DEPENDENT) -> Array:
    """Return an orthonormal basis (rows, rank) of what columns (rows, n) span.

    Parameters
    ----------
    tolerance : float
        Singular values of the columns, made of unit length, that are below this part of the largest are none.
    """
    size = np.linalg.norm(columns, axis=0)
    Q, R = np.linalg.qr(columns / np.where(size > 0, size, 1.0))
    U, s, _ = np.linalg.svd(R, full_matrices=False)
    return np.asarray(Q @ U[:, s > tolerance * s.max(initial=0.0)])


def project_out(values: Array, Q: Array) -> Array:
    """Return values (rows, ...) less what lies along an orthonormal basis (rows, rank)."""
    return np.asarray(values - Q @ (Q.T @ values))
