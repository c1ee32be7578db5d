"""Poses of bodies and the coordinates that kernels solve for, many at once.

Written by "deltacal kernels". Do not edit.

A pose, twelve numbers, is a position and a rotation matrix, row by row. Coordinates are those of px py pz cx cy cz in
which a platform moves, `at` says which, the others are zero; c is the Cayley vector of a rotation, 2 tan(t/2) n by an
angle t about n. Lengths in mm.
"""

import numpy as np

from deltacal_kernels.compiled import kernel

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@fast
def as_poses(x, at, out):
    """Fill out (N, 12) by coordinates x (N, n), the `at` (n,) of all six; NaN where one of them is not finite."""
    own = np.zeros(6)
    for n in range(x.shape[0]):
        finite = 0.0
        for j in range(at.size):
            own[at[j]] = x[n, j]
            finite += 0.0 * x[n, j]
        cx, cy, cz = own[3], own[4], own[5]
        s = 1.0 / (1.0 + 0.25 * (cx * cx + cy * cy + cz * cz))
        u, v, w = s * cx, s * cy, s * cz
        xx, yy, zz = 0.5 * u * cx, 0.5 * v * cy, 0.5 * w * cz
        xy, yz, zx = 0.5 * u * cy, 0.5 * v * cz, 0.5 * w * cx
        to = out[n]
        to[0], to[1], to[2] = own[0] + finite, own[1] + finite, own[2] + finite
        to[3], to[4], to[5] = 1.0 - yy - zz + finite, xy - w + finite, zx + v + finite
        to[6], to[7], to[8] = xy + w + finite, 1.0 - zz - xx + finite, yz - u + finite
        to[9], to[10], to[11] = zx - v + finite, yz + u + finite, 1.0 - xx - yy + finite


@fast
def as_coordinates(poses, at, x):
    """Fill x (N, n) with the coordinates of poses (N, 12), the `at` (n,) of all six; rotations by less than half a turn."""
    own = np.empty(6)
    for n in range(poses.shape[0]):
        of = poses[n]
        s = 2.0 / (1.0 + of[3] + of[7] + of[11])
        own[0], own[1], own[2] = of[0], of[1], of[2]
        own[3], own[4], own[5] = s * (of[10] - of[8]), s * (of[5] - of[9]), s * (of[6] - of[4])
        for j in range(at.size):
            x[n, j] = own[at[j]]
