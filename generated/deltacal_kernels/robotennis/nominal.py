"""Derivatives of the nominal machine's position by its errors, many poses at once: `robotennis`, RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/nominal.py.jinja; sha256 of both d50c4b0b04fe1434; SymPy 1.14.0.

Rods of a pair are parallel there, and the platform does not turn, which leaves little of the exact machine's
derivatives. x (N, 3) is the position of the reference point, q (N, 3) the joints there, tool
(N or 1, 3) the reference point in {O'}, k from `nominal_constants` of the nominal machine: errors and
deflections among its parameters play no part. Poses stand side by side as in ``kinematics.py``. The functions return
False where the machine is singular at one of the poses, or nearly so.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import arctangent, cosine, outer, outer_of, scratch, sine, tangent, wide
from deltacal_kernels.straight import straight

from .blocks import LANES, SPARE, WORK, aim, hold, load

# where in w the terms of each column of the sensitivity have their factors and values
FACTORS = np.array(((3808, 3808, 3808, 3808, 3808, 3808, 3808, 3808, 3808, 3840, 3840, 3840, 3840, 3840, 3840, 3840, 3840, 3840, 3872, 3872, 3872, 3872, 3872, 3872, 3872, 3872, 3872),))
VALUES = np.array(((864, 896, 928, 960, 992, 1024, 1056, 1088, 1120, 2080, 2112, 2144, 2176, 2208, 2240, 2272, 2304, 2336, 3296, 3328, 3360, 3392, 3424, 3456, 3488, 3520, 3552),))
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _nominal(w, k, n):
    """Equations of a nominal limb by platform and errors (55 operations)."""
    u_x = k[0]
    s1 = k[1]
    u_y = k[2]
    u_y_dphi = k[3]
    a = k[4]
    A_x = k[5]
    A_x_dphi = k[6]
    A_y = k[7]
    A_y_dphi = k[8]
    s33 = k[9]
    s36 = k[10]
    C_x_dphi = k[11]
    C_y_dphi = k[12]
    b = k[13]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        s8 = cosine(q)
        arm_x = s8*u_x
        s10 = sine(q)
        arm_x_theta0 = -s10*u_x
        arm_x_dphi = -s1*s8
        arm_y = s8*u_y
        arm_y_theta0 = -s10*u_y
        arm_y_dphi = s8*u_y_dphi
        arm_z = sine(q)
        arm_z_theta0 = cosine(q)
        B_x = A_x + a*arm_x
        B_x_theta0 = a*arm_x_theta0
        B_x_dphi = A_x_dphi + a*arm_x_dphi
        B_y = A_y + a*arm_y
        B_y_theta0 = a*arm_y_theta0
        B_y_dphi = A_y_dphi + a*arm_y_dphi
        B_z = a*arm_z
        B_z_theta0 = a*arm_z_theta0
        centre_x = px - tx
        centre_y = py - ty
        centre_z = pz - tz
        C_x = centre_x + s33
        C_y = centre_y + s36
        rod_x = -B_x + C_x
        rod_x_dphi = -B_x_dphi + C_x_dphi
        rod_y = -B_y + C_y
        rod_y_dphi = -B_y_dphi + C_y_dphi
        rod_z = -B_z + centre_z
        s47 = -arm_x*rod_x - arm_y*rod_y - arm_z*rod_z
        s50 = rod_x*u_x + rod_y*u_y
        s54 = -B_x_theta0*rod_x - B_y_theta0*rod_y - B_z_theta0*rod_z
        s57 = rod_x*rod_x_dphi + rod_y*rod_y_dphi
        w[256 + lane] = rod_x
        w[288 + lane] = rod_y
        w[320 + lane] = rod_z
        w[864 + lane] = s47
        w[896 + lane] = -b
        w[928 + lane] = s50
        w[960 + lane] = s54
        w[992 + lane] = s57
        w[1024 + lane] = -s50
        w[1056 + lane] = rod_x
        w[1088 + lane] = rod_y
        w[1120 + lane] = rod_z


@straight
def _nominal_inverse(w, n):
    """Minus the inverse of the derivatives, its rows of the position; how far the equations are from dependent (71 operations)."""
    for lane in range(n):
        J00_0 = w[256 + lane]
        J10_0 = w[1472 + lane]
        J20_0 = w[2688 + lane]
        J00_1 = w[288 + lane]
        J10_1 = w[1504 + lane]
        J20_1 = w[2720 + lane]
        J00_2 = w[320 + lane]
        J10_2 = w[1536 + lane]
        J20_2 = w[2752 + lane]
        G_cof_00 = J10_1*J20_2 - J10_2*J20_1
        G_cof_01 = -J10_0*J20_2 + J10_2*J20_0
        G_cof_02 = J10_0*J20_1 - J10_1*J20_0
        G_cof_10 = -J00_1*J20_2 + J00_2*J20_1
        G_cof_11 = J00_0*J20_2 - J00_2*J20_0
        G_cof_12 = -J00_0*J20_1 + J00_1*J20_0
        G_cof_20 = J00_1*J10_2 - J00_2*J10_1
        G_cof_21 = -J00_0*J10_2 + J00_2*J10_0
        G_cof_22 = J00_0*J10_1 - J00_1*J10_0
        G_det_00 = G_cof_00*J00_0 + G_cof_01*J00_1 + G_cof_02*J00_2
        G_by_00 = (1.0 / G_det_00)
        G_inv_00 = G_by_00*G_cof_00
        G_inv_01 = G_by_00*G_cof_10
        G_inv_02 = G_by_00*G_cof_20
        G_inv_10 = G_by_00*G_cof_01
        G_inv_11 = G_by_00*G_cof_11
        G_inv_12 = G_by_00*G_cof_21
        G_inv_20 = G_by_00*G_cof_02
        G_inv_21 = G_by_00*G_cof_12
        G_inv_22 = G_by_00*G_cof_22
        s49 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2)
        s53 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2)
        s55 = (G_det_00 * G_det_00) - 1.0e-12*s49*s53*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        w[3808 + lane] = -G_inv_00
        w[3840 + lane] = -G_inv_01
        w[3872 + lane] = -G_inv_02
        w[3904 + lane] = -G_inv_10
        w[3936 + lane] = -G_inv_11
        w[3968 + lane] = -G_inv_12
        w[4000 + lane] = -G_inv_20
        w[4032 + lane] = -G_inv_21
        w[4064 + lane] = -G_inv_22
        w[4096 + lane] = s55


@straight
def _singular(w, poses):
    """Return how many of the poses are not regular."""
    many = 0
    for lane in range(poses):
        many += 0 if (w[4096 + lane] > 0.0) else 1
    return many


@fast
def _products(w, S, first, last):
    """Multiply the inverse and the derivatives by the errors where they do not vanish."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 81 * (first + lane + 8) <= S.size  # else the last poses are written through scratch
        to, at = (S, 81 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 9 * i + 0, 81, 27, 3, w, (3808 + 32 * i + lane, ), 96, (864 + 1216 * i + lane, ), 32, 8)
            outer(to, at + 9 * i + 8, 81, 27, 3, w, (3808 + 32 * i + lane, ), 96, (1120 + 1216 * i + lane, ), 32, 1)
        if not whole:
            for c in range(81 * (last + 1 - first - lane)):
                S[81 * (first + lane) + c] = to[c]



@fast
def nominal_sensitivity(x, q, tool, k, S):
    """Fill S (N, 3, 27) with the derivatives by the errors, limb by limb.

    Those of one limb are in the order of ``parameters.ERRORS``, then ``COMMON``.
    """
    w, whole = scratch(WORK + SPARE), S.reshape(S.size)
    w_1 = w[0:1216]
    w_2 = w[1216:2432]
    w_3 = w[2432:3648]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    k_1, k_2, k_3 = k[0, 0], k[0, 1], k[0, 2]
    left = 0
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        load(x, w, first, last, n)
        if len(tool) > 1:
            hold(tool, w, first, last, n)
        aim(w, n)
        load(q, w, first, last, n)
        _nominal(w_1, k_1, n)
        _nominal(w_2, k_2, n)
        _nominal(w_3, k_3, n)
        _nominal_inverse(w, n)
        left += _singular(w, last - first + 1)
        _products(w, whole, first, last)
    return left == 0


@fast
def _chosen_products(w, columns, C, first, last):
    """Multiply them for some columns; rows of C (N, 3, n) are filled up to a multiple of eight numbers."""
    wide()
    n = (columns.size + 7) // 8 * 8
    for start in range(0, n, 8):
        for lane in range(0, last - first + 1, 8):
            outer_of(
                C, 3 * n * (first + lane) + start, 3 * n, n, 3,
                w, lane, 96, FACTORS, VALUES, columns, start, 1,
            )


@straight
def _along(x, C, m, H, n, towards, poses):
    """Fill the rows of all pairs: along the line from one position to the other, the difference of their derivatives."""
    row = 0
    for a in range(poses):
        for b in range(a + 1, poses):
            a_x = x[3 * a + 0]
            a_y = x[3 * a + 1]
            a_z = x[3 * a + 2]
            b_x = x[3 * b + 0]
            b_y = x[3 * b + 1]
            b_z = x[3 * b + 2]
            gap_x = -a_x + b_x
            gap_y = -a_y + b_y
            gap_z = -a_z + b_z
            s7 = 1/math.sqrt((gap_x * gap_x) + (gap_y * gap_y) + (gap_z * gap_z))
            s8 = gap_x*s7
            s9 = gap_y*s7
            s10 = gap_z*s7
            towards[0 * poses + b] = s8
            towards[1 * poses + b] = s9
            towards[2 * poses + b] = s10
        for b in range(a + 1, poses):
            for j in range(n):
                n_x = towards[0 * poses + b]
                n_y = towards[1 * poses + b]
                n_z = towards[2 * poses + b]
                shift_a_x = C[m * (3 * a + 0) + j]
                shift_a_y = C[m * (3 * a + 1) + j]
                shift_a_z = C[m * (3 * a + 2) + j]
                shift_b_x = C[m * (3 * b + 0) + j]
                shift_b_y = C[m * (3 * b + 1) + j]
                shift_b_z = C[m * (3 * b + 2) + j]
                s17 = n_x*(-shift_a_x + shift_b_x) + n_y*(-shift_a_y + shift_b_y) + n_z*(-shift_a_z + shift_b_z)
                H[n * row + j] = s17
            row += 1


@fast
def distance_rows(x, q, tool, k, columns, H):
    """Fill the identification matrix H (N (N - 1) / 2, n) of the distances of all pairs of positions, first with second and so on.

    columns (n,) are those of `nominal_sensitivity`, whose derivatives are contracted and not returned. The row of two
    equal positions is NaN.
    """
    poses, n_h = len(q), len(columns)
    if H.shape[0] != poses * (poses - 1) // 2 or H.shape[1] != n_h:
        raise ValueError("H must have a row for every pair of poses and a column for every chosen one")
    for j in range(n_h):
        if not 0 <= columns[j] < 27:
            raise IndexError("there is no such column of the sensitivity")
    m = (n_h + 7) // 8 * 8
    w = scratch(WORK + 3 * ((poses + 7) * m + poses))
    C = w[WORK:]
    w_1 = w[0:1216]
    w_2 = w[1216:2432]
    w_3 = w[2432:3648]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    k_1, k_2, k_3 = k[0, 0], k[0, 1], k[0, 2]
    left = 0
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        load(x, w, first, last, n)
        if len(tool) > 1:
            hold(tool, w, first, last, n)
        aim(w, n)
        load(q, w, first, last, n)
        _nominal(w_1, k_1, n)
        _nominal(w_2, k_2, n)
        _nominal(w_3, k_3, n)
        _nominal_inverse(w, n)
        left += _singular(w, last - first + 1)
        _chosen_products(w, columns, C, first, last)
    _along(x, C, m, H, n_h, C[3 * (poses + 7) * m :], poses)
    return left == 0
