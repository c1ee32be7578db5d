"""Rotations: SciPy's, loaded on first use, and the Cayley map of the kernels.

SciPy's rotations take a quarter of a second to import, which a calibration from distances never needs.
"""

from __future__ import annotations

from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]


def cayley_matrix(c: Array) -> Array:
    """Return rotations (N, 3, 3) by Cayley vectors (N, 3), ``c = 2 tan(t/2) n``: the map of the generated kernels."""
    x, y, z = np.ascontiguousarray(c.T)
    xx, yy, zz = x * x / 2, y * y / 2, z * z / 2
    xy, yz, zx = x * y / 2, y * z / 2, z * x / 2
    s = 1 / (1 + (xx + yy + zz) / 2)
    entries = (-yy - zz, xy - z, zx + y, xy + z, -zz - xx, yz - x, zx - y, yz + x, -xx - yy)
    matrix = np.empty((len(c), 9))  # entry by entry: products of 3 x 3 matrices would take ten times as long
    for k, entry in enumerate(entries):
        matrix[:, k] = s * entry + (k % 4 == 0)
    return matrix.reshape(-1, 3, 3)


def cayley_vector(matrix: Array) -> Array:
    """Return Cayley vectors (N, 3) of rotations (N, 3, 3) by less than half a turn."""
    r = np.ascontiguousarray(matrix.reshape(-1, 9).T)
    s = 2 / (1 + r[0] + r[4] + r[8])
    return np.column_stack([s * (r[7] - r[5]), s * (r[2] - r[6]), s * (r[3] - r[1])])


def cayley_spin(c: Array) -> Array:
    """Return W (N, 3, 3) by which a change of a Cayley vector turns the body: ``axial(dR R^T) = W dc``."""
    K = np.zeros((len(c), 3, 3))
    K[:, 2, 1], K[:, 0, 2], K[:, 1, 0] = c.T
    K -= np.swapaxes(K, 1, 2)
    spin: Array = (np.eye(3) + K / 2) / (1 + (c**2).sum(axis=1) / 4)[:, None, None]
    return spin


def from_vector(vector: Array) -> Array:
    """Return rotation matrices (..., 3, 3) by rotation vectors (..., 3) [rad]."""
    from scipy.spatial.transform import Rotation

    matrix: Array = Rotation.from_rotvec(vector).as_matrix()
    return matrix


def to_vector(matrix: Array) -> Array:
    """Return rotation vectors (..., 3) [rad] of rotation matrices (..., 3, 3)."""
    matrix = np.asarray(matrix)
    axial = np.stack([matrix[..., 2, 1], matrix[..., 0, 2], matrix[..., 1, 0]], axis=-1) / 2
    axial -= np.stack([matrix[..., 1, 2], matrix[..., 2, 0], matrix[..., 0, 1]], axis=-1) / 2
    sin, cos = np.linalg.norm(axial, axis=-1), (np.trace(matrix, axis1=-2, axis2=-1) - 1) / 2
    if (cos > -0.9).all():  # away from half turns the axis is plain; near them it is SciPy's
        with np.errstate(invalid="ignore", divide="ignore"):
            stretch = np.where(sin > 1e-300, np.arctan2(sin, cos) / sin, 1.0)
        short: Array = axial * stretch[..., None]
        return short
    from scipy.spatial.transform import Rotation

    vector: Array = Rotation.from_matrix(matrix).as_rotvec()
    return vector


def mean(matrices: Array) -> Array:
    """Return the mean rotation (3, 3) of rotation matrices (N, 3, 3)."""
    from scipy.spatial.transform import Rotation

    matrix: Array = Rotation.from_matrix(matrices).mean().as_matrix()
    return matrix
