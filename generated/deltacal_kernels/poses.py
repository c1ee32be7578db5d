"""Poses of bodies and the coordinates that kernels solve for, many at once.

Written by "deltacal kernels". Do not edit.

A pose, twelve numbers, is a position and a rotation matrix, row by row. Coordinates are those of px py pz cx cy cz in
which a platform moves, `at` says which, the others are zero; c is the Cayley vector of a rotation, 2 tan(t/2) n by an
angle t about n. Lengths in mm.
"""

import numpy as np

from deltacal_kernels.cache import kernel

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@fast
def as_poses(x, at, out):
    """Fill out (N, 12) by coordinates x (N, n), the `at` (n,) of all six; NaN where one of them is not finite."""
    own = np.zeros(6)
    for n in range(x.shape[0]):
        nothing = 0.0  # NaN where a coordinate is not finite
        for j in range(at.size):
            own[at[j]] = x[n, j]
            nothing += 0.0 * x[n, j]
        cx = own[3]
        cy = own[4]
        cz = own[5]
        s0 = (cx * cx)
        s2 = (cy * cy)
        s4 = (cz * cz)
        s7 = (1.0 / (0.25*s0 + 0.25*s2 + 0.25*s4 + 1))
        s8 = -0.5*s2
        s9 = -0.5*s4
        s12 = s7*(s8 + s9) + 1
        s13 = 0.5*cx*cy
        s15 = s7*(-cz + s13)
        s16 = 0.5*cx*cz
        s18 = s7*(cy + s16)
        s20 = s7*(cz + s13)
        s21 = -0.5*s0
        s24 = s7*(s21 + s9) + 1
        s25 = 0.5*cy*cz
        s27 = s7*(-cx + s25)
        s29 = s7*(-cy + s16)
        s31 = s7*(cx + s25)
        s34 = s7*(s21 + s8) + 1
        for j in range(3):
            out[n, j] = own[j] + nothing
        out[n, 3] = s12 + nothing
        out[n, 4] = s15 + nothing
        out[n, 5] = s18 + nothing
        out[n, 6] = s20 + nothing
        out[n, 7] = s24 + nothing
        out[n, 8] = s27 + nothing
        out[n, 9] = s29 + nothing
        out[n, 10] = s31 + nothing
        out[n, 11] = s34 + nothing


@fast
def as_coordinates(poses, at, x):
    """Fill x (N, n) with the coordinates of poses (N, 12), the `at` (n,) of all six; rotations by less than half a turn."""
    own = np.empty(6)
    for n in range(poses.shape[0]):
        pose = poses[n]
        R_00 = pose[3]
        R_01 = pose[4]
        R_02 = pose[5]
        R_10 = pose[6]
        R_11 = pose[7]
        R_12 = pose[8]
        R_20 = pose[9]
        R_21 = pose[10]
        R_22 = pose[11]
        s1 = (1.0 / (R_00 + R_11 + R_22 + 1))
        s3 = 2*s1*(-R_12 + R_21)
        s5 = 2*s1*(R_02 - R_20)
        s7 = 2*s1*(-R_01 + R_10)
        own[:3] = pose[:3]
        own[3] = s3
        own[4] = s5
        own[5] = s7
        for j in range(at.size):
            x[n, j] = own[at[j]]
