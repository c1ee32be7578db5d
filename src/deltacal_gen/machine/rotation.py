"""Rotations: SciPy's, loaded on first use, and those of the kernels by their Cayley vectors.

SciPy's rotations take a quarter of a second to import, which a calibration from distances never needs.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from deltacal_kernels import rotations

Array = np.ndarray[Any, np.dtype[np.float64]]


def about_z(radius: Array | float, turn: Array) -> Array:
    """Return points (N, 2) of a plane by their distance from z and their angle about it, from x [rad]."""
    return np.stack([radius * np.cos(turn), radius * np.sin(turn)], axis=-1)


# of the generated kernels: vectors are Cayley's, c = 2 tan(t/2) n, those of turns by less than half a turn
cayley_matrix: Callable[[Array], Array] = rotations.matrix  # rotations (N, 3, 3) by vectors (N, 3)
cayley_vector: Callable[[Array], Array] = rotations.vector  # vectors (N, 3) of rotations (N, 3, 3)
spin: Callable[[Array], Array] = rotations.spin  # how changes of vectors (N, 3) turn a body about the axes of {O}
swept: Callable[[Array], Array] = rotations.swept  # how points (N, 3) move by turns about the axes of {O}, (N, 3, 3)
aim: Callable[[Array], Array] = rotations.aim  # turns about z, then x, that bring y along lines (N, 3): (N, 2) [rad]


def from_vector(vector: Array) -> Array:
    """Return rotation matrices (..., 3, 3) by rotation vectors (..., 3) [rad]."""
    from scipy.spatial.transform import Rotation

    matrix: Array = Rotation.from_rotvec(vector).as_matrix()
    return matrix


def from_turns(order: str, angles: Array) -> Array:
    """Return rotation matrices (N, 3, 3) of turns about fixed axes x, y, z by angles (N, 3) [rad], one after another.

    `order` says which comes first, as in "xyz"; the angle about each axis stands in that axis' own column.
    """
    from scipy.spatial.transform import Rotation

    matrix: Array = Rotation.from_euler(order, angles[:, ["xyz".index(axis) for axis in order]]).as_matrix()
    return matrix


def to_vector(matrix: Array) -> Array:
    """Return rotation vectors (..., 3) [rad] of rotation matrices (..., 3, 3); NaN where a pose has none."""
    matrix = np.asarray(matrix)
    axial = np.stack([matrix[..., 2, 1], matrix[..., 0, 2], matrix[..., 1, 0]], axis=-1) / 2
    axial -= np.stack([matrix[..., 1, 2], matrix[..., 2, 0], matrix[..., 0, 1]], axis=-1) / 2
    sin, cos = np.linalg.norm(axial, axis=-1), (np.trace(matrix, axis1=-2, axis2=-1) - 1) / 2
    with np.errstate(invalid="ignore", divide="ignore"):
        stretch = np.where(sin > 1e-300, np.arctan2(sin, cos) / sin, 1.0)
    vector: Array = axial * stretch[..., None]
    if (half := cos <= -0.9).any():  # away from half turns the axis is plain; near them it is SciPy's
        from scipy.spatial.transform import Rotation

        vector[half] = Rotation.from_matrix(matrix[half]).as_rotvec()
    return vector


def vector_of_quaternion(quaternions: Array) -> Array:
    """Return rotation vectors (N, 3) [rad] of quaternions (N, 4), x y z w; nan where one has no length."""
    from scipy.spatial.transform import Rotation

    out = np.full((len(quaternions), 3), np.nan)
    turned = np.linalg.norm(quaternions, axis=1) > 0  # false where there are no numbers
    if turned.any():
        out[turned] = Rotation.from_quat(quaternions[turned]).as_rotvec()
    return out


def mean(matrices: Array) -> Array:
    """Return the mean rotation (3, 3) of rotation matrices (N, 3, 3)."""
    from scipy.spatial.transform import Rotation

    matrix: Array = Rotation.from_matrix(matrices).mean().as_matrix()
    return matrix


def align(a: Array, b: Array) -> Array:
    """Return the rotation R (3, 3) that minimises |b - R a|^2 (Kabsch)."""
    if len(a) < 3:
        return np.eye(3)
    U, _, Vt = np.linalg.svd(b.T @ a)
    turn: Array = U @ np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    return turn
