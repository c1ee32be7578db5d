"""Derivatives of the nominal machine's position by its errors, many poses at once: `linear_delta`, Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/nominal.py.jinja; sha256 of both 614b9b376bc313c6; SymPy 1.14.0.

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
FACTORS = np.array(((6624, 6624, 6624, 6624, 6624, 6624, 6624, 6720, 6624, 6656, 6656, 6656, 6656, 6656, 6656, 6656, 6752, 6656, 6688, 6688, 6688, 6688, 6688, 6688, 6688, 6784, 6688),))
VALUES = np.array(((1472, 1504, 1536, 1568, 1600, 1632, 1664, 2016, 1728, 3584, 3616, 3648, 3680, 3712, 3744, 3776, 4128, 3840, 5696, 5728, 5760, 5792, 5824, 5856, 5888, 6240, 5952),))
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _nominal(w, k, n):
    """Equations of a nominal limb by platform and errors (55 operations)."""
    h = k[0]
    u_x = k[1]
    u_y = k[2]
    s23 = k[3]
    s25 = k[4]
    s15 = k[5]
    s19 = k[6]
    s_z_cx = k[7]
    s_z_cy = k[8]
    s_x_cz = k[9]
    s_y_cz = k[10]
    h_arm = k[11]
    l = k[12]
    h_radius = k[13]
    d_x_angle = k[14]
    d_y_angle = k[15]
    h_dr = k[16]
    s73 = k[17]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        s13 = h - q
        C_x_lean_radial = s13*u_x
        C_x_lean_tangential = -s13*u_y
        C_y_lean_radial = s13*u_y
        C_y_lean_tangential = s13*u_x
        s24 = s23 - tx
        s26 = s25 - ty
        A_x = px + s24
        A_y = py + s26
        A_z = pz - tz
        d_x = A_x - s15
        d_y = A_y - s19
        d_z = A_z - s13
        s43 = d_y*tz + d_z*s26
        s46 = -d_x*tz - d_z*s24
        s49 = -d_x*s26 + d_y*s24
        s50 = d_z*s_z_cx
        s51 = d_z*s_z_cy
        s54 = d_x*s_x_cz + d_y*s_y_cz
        s56 = -d_z*h_arm - l
        s57 = -d_x*u_x
        s58 = -d_y*u_y
        s60 = -d_z*h_radius + s57 + s58
        s63 = d_x*d_x_angle + d_y*d_y_angle
        s66 = -C_x_lean_radial*d_x - C_y_lean_radial*d_y
        s69 = -C_x_lean_tangential*d_x - C_y_lean_tangential*d_y
        s70 = d_z*q
        s72 = -d_z*h_dr + s57 + s58
        w[640 + lane] = d_x
        w[672 + lane] = d_y
        w[704 + lane] = d_z
        w[736 + lane] = s43
        w[768 + lane] = s46
        w[800 + lane] = s49
        w[992 + lane] = s50
        w[1024 + lane] = s51
        w[1056 + lane] = s54
        w[1472 + lane] = -d_z
        w[1504 + lane] = s56
        w[1536 + lane] = s60
        w[1568 + lane] = s63
        w[1600 + lane] = s66
        w[1632 + lane] = s69
        w[1664 + lane] = s70
        w[1728 + lane] = s72
        w[2016 + lane] = s73


@straight
def _nominal_inverse(w, n):
    """Minus the inverse of the derivatives, its rows of the position; how far the equations are from dependent (223 operations)."""
    for lane in range(n):
        J00_0 = w[640 + lane]
        J10_0 = w[2752 + lane]
        J20_0 = w[4864 + lane]
        J00_1 = w[672 + lane]
        J10_1 = w[2784 + lane]
        J20_1 = w[4896 + lane]
        J00_2 = w[704 + lane]
        J10_2 = w[2816 + lane]
        J20_2 = w[4928 + lane]
        J00_3 = w[736 + lane]
        J10_3 = w[2848 + lane]
        J20_3 = w[4960 + lane]
        J00_4 = w[768 + lane]
        J10_4 = w[2880 + lane]
        J20_4 = w[4992 + lane]
        J00_5 = w[800 + lane]
        J10_5 = w[2912 + lane]
        J20_5 = w[5024 + lane]
        J01_3 = w[992 + lane]
        J11_3 = w[3104 + lane]
        J21_3 = w[5216 + lane]
        J01_4 = w[1024 + lane]
        J11_4 = w[3136 + lane]
        J21_4 = w[5248 + lane]
        J01_5 = w[1056 + lane]
        J11_5 = w[3168 + lane]
        J21_5 = w[5280 + lane]
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
        U_00 = G_inv_00*J00_3 + G_inv_01*J10_3 + G_inv_02*J20_3
        U_01 = G_inv_00*J00_4 + G_inv_01*J10_4 + G_inv_02*J20_4
        U_02 = G_inv_00*J00_5 + G_inv_01*J10_5 + G_inv_02*J20_5
        U_10 = G_inv_10*J00_3 + G_inv_11*J10_3 + G_inv_12*J20_3
        U_11 = G_inv_10*J00_4 + G_inv_11*J10_4 + G_inv_12*J20_4
        U_12 = G_inv_10*J00_5 + G_inv_11*J10_5 + G_inv_12*J20_5
        U_20 = G_inv_20*J00_3 + G_inv_21*J10_3 + G_inv_22*J20_3
        U_21 = G_inv_20*J00_4 + G_inv_21*J10_4 + G_inv_22*J20_4
        U_22 = G_inv_20*J00_5 + G_inv_21*J10_5 + G_inv_22*J20_5
        Si_cof_00 = J11_4*J21_5 - J11_5*J21_4
        Si_cof_01 = -J11_3*J21_5 + J11_5*J21_3
        Si_cof_02 = J11_3*J21_4 - J11_4*J21_3
        Si_cof_10 = -J01_4*J21_5 + J01_5*J21_4
        Si_cof_11 = J01_3*J21_5 - J01_5*J21_3
        Si_cof_12 = -J01_3*J21_4 + J01_4*J21_3
        Si_cof_20 = J01_4*J11_5 - J01_5*J11_4
        Si_cof_21 = -J01_3*J11_5 + J01_5*J11_3
        Si_cof_22 = J01_3*J11_4 - J01_4*J11_3
        Si_det_00 = J01_3*Si_cof_00 + J01_4*Si_cof_01 + J01_5*Si_cof_02
        Si_by_00 = (1.0 / Si_det_00)
        Si_inv_00 = Si_by_00*Si_cof_00
        Si_inv_01 = Si_by_00*Si_cof_10
        Si_inv_02 = Si_by_00*Si_cof_20
        Si_inv_10 = Si_by_00*Si_cof_01
        Si_inv_11 = Si_by_00*Si_cof_11
        Si_inv_12 = Si_by_00*Si_cof_21
        Si_inv_20 = Si_by_00*Si_cof_02
        Si_inv_21 = Si_by_00*Si_cof_12
        Si_inv_22 = Si_by_00*Si_cof_22
        s121 = Si_inv_00*U_00 + Si_inv_10*U_01 + Si_inv_20*U_02
        s125 = Si_inv_01*U_00 + Si_inv_11*U_01 + Si_inv_21*U_02
        s129 = Si_inv_02*U_00 + Si_inv_12*U_01 + Si_inv_22*U_02
        s133 = Si_inv_00*U_10 + Si_inv_10*U_11 + Si_inv_20*U_12
        s137 = Si_inv_01*U_10 + Si_inv_11*U_11 + Si_inv_21*U_12
        s141 = Si_inv_02*U_10 + Si_inv_12*U_11 + Si_inv_22*U_12
        s145 = Si_inv_00*U_20 + Si_inv_10*U_21 + Si_inv_20*U_22
        s149 = Si_inv_01*U_20 + Si_inv_11*U_21 + Si_inv_21*U_22
        s153 = Si_inv_02*U_20 + Si_inv_12*U_21 + Si_inv_22*U_22
        s162 = (J10_0 * J10_0) + (J10_1 * J10_1) + (J10_2 * J10_2)
        s166 = (J20_0 * J20_0) + (J20_1 * J20_1) + (J20_2 * J20_2)
        s168 = (G_det_00 * G_det_00) - 1.0e-12*s162*s166*((J00_0 * J00_0) + (J00_1 * J00_1) + (J00_2 * J00_2))
        s177 = (J11_3 * J11_3) + (J11_4 * J11_4) + (J11_5 * J11_5)
        s181 = (J21_3 * J21_3) + (J21_4 * J21_4) + (J21_5 * J21_5)
        s183 = (Si_det_00 * Si_det_00) - 1.0e-12*s177*s181*((J01_3 * J01_3) + (J01_4 * J01_4) + (J01_5 * J01_5))
        w[6624 + lane] = -G_inv_00
        w[6656 + lane] = -G_inv_01
        w[6688 + lane] = -G_inv_02
        w[6720 + lane] = s121
        w[6752 + lane] = s125
        w[6784 + lane] = s129
        w[6816 + lane] = -G_inv_10
        w[6848 + lane] = -G_inv_11
        w[6880 + lane] = -G_inv_12
        w[6912 + lane] = s133
        w[6944 + lane] = s137
        w[6976 + lane] = s141
        w[7008 + lane] = -G_inv_20
        w[7040 + lane] = -G_inv_21
        w[7072 + lane] = -G_inv_22
        w[7104 + lane] = s145
        w[7136 + lane] = s149
        w[7168 + lane] = s153
        w[7200 + lane] = s168
        w[7232 + lane] = s183


@straight
def _singular(w, poses):
    """Return how many of the poses are not regular."""
    many = 0
    for lane in range(poses):
        many += 0 if (w[7200 + lane] > 0.0) & (w[7232 + lane] > 0.0) else 1
    return many


@fast
def _products(w, S, first, last):
    """Multiply the inverse and the derivatives by the errors where they do not vanish."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 81 * (first + lane + 8) <= S.size  # else the last poses are written through scratch
        to, at = (S, 81 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 9 * i + 0, 81, 27, 3, w, (6624 + 32 * i + lane, ), 192, (1472 + 2112 * i + lane, ), 32, 7)
            outer(to, at + 9 * i + 7, 81, 27, 3, w, (6720 + 32 * i + lane, ), 192, (2016 + 2112 * i + lane, ), 32, 1)
            outer(to, at + 9 * i + 8, 81, 27, 3, w, (6624 + 32 * i + lane, ), 192, (1728 + 2112 * i + lane, ), 32, 1)
        if not whole:
            for c in range(81 * (last + 1 - first - lane)):
                S[81 * (first + lane) + c] = to[c]



@fast
def nominal_sensitivity(x, q, tool, k, S):
    """Fill S (N, 3, 27) with the derivatives by the errors, limb by limb.

    Those of one limb are in the order of ``parameters.ERRORS``, then ``COMMON``.
    """
    w, whole = scratch(WORK + SPARE), S.reshape(S.size)
    w_1 = w[0:2112]
    w_2 = w[2112:4224]
    w_3 = w[4224:6336]
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
                w, lane, 192, FACTORS, VALUES, columns, start, 1,
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
    w_1 = w[0:2112]
    w_2 = w[2112:4224]
    w_3 = w[4224:6336]
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
