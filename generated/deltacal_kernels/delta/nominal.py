"""Derivatives of the nominal machine's position by its errors, many poses at once: `delta`, Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/nominal.py.jinja; sha256 of both fd97dd6949a08091; SymPy 1.14.0.

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
FACTORS = np.array(((9312, 9312, 9312, 9312, 9312, 9312, 9312, 9312, 9408, 9408, 9408, 9408, 9408, 9408, 9344, 9344, 9344, 9344, 9344, 9344, 9344, 9344, 9440, 9440, 9440, 9440, 9440, 9440, 9376, 9376, 9376, 9376, 9376, 9376, 9376, 9376, 9472, 9472, 9472, 9472, 9472, 9472),))
VALUES = np.array(((1984, 2016, 2048, 2080, 2112, 2144, 2176, 2208, 2752, 2784, 2816, 2848, 2880, 2912, 4992, 5024, 5056, 5088, 5120, 5152, 5184, 5216, 5760, 5792, 5824, 5856, 5888, 5920, 8000, 8032, 8064, 8096, 8128, 8160, 8192, 8224, 8768, 8800, 8832, 8864, 8896, 8928),))
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _nominal(w, k, n):
    """Equations of a nominal limb by platform and errors (100 operations)."""
    R0_11 = k[0]
    R0_12_alpha0 = k[1]
    s1 = k[2]
    R0_21 = k[3]
    R0_21_beta0 = k[4]
    L = k[5]
    B_x = k[6]
    B_y = k[7]
    s47 = k[8]
    s49 = k[9]
    g_y_alpha2 = k[10]
    g_x_beta2 = k[11]
    h_y = k[12]
    h_x = k[13]
    c1_x_dc = k[14]
    c1_y_dc = k[15]
    h_z_alpha03 = k[16]
    h_x_beta03 = k[17]
    h_y_beta03 = k[18]
    l = k[19]
    s97 = k[20]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        s21 = cosine(q)
        s22 = R0_11*s21
        s23 = sine(q)
        s24 = -R0_11*s23
        R1_11_alpha0 = R0_12_alpha0*s23
        R1_11_beta0 = -s1*s21
        s29 = R0_21*s21
        s30 = -R0_21*s23
        R1_21_alpha0 = -R0_11*s23
        R1_21_beta0 = R0_21_beta0*s21
        C_x = B_x + L*s22
        C_x_theta = L*s24
        C_x_alpha0 = L*R1_11_alpha0
        C_x_beta0 = L*R1_11_beta0
        C_y = B_y + L*s29
        C_y_theta = L*s30
        C_y_alpha0 = L*R1_21_alpha0
        C_y_beta0 = L*R1_21_beta0
        C_z_theta = L*s21
        s48 = s47 - tx
        s50 = s49 - ty
        A_x = px + s48
        A_y = py + s50
        A_z = pz - tz
        c1_x_alpha2 = g_y_alpha2*s24
        c1_x_beta2 = g_x_beta2*s22
        c1_y_alpha2 = g_y_alpha2*s30
        c1_y_beta2 = g_x_beta2*s29
        c1_z_alpha2 = g_y_alpha2*s21
        c1_z_beta2 = g_x_beta2*s23
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - L*s23
        s71 = d_y*tz + d_z*s50
        s74 = -d_x*tz - d_z*s48
        s77 = -d_x*s50 + d_y*s48
        s78 = d_z*h_y
        s79 = -d_z*h_x
        s82 = -d_x*h_y + d_y*h_x
        s86 = -C_x_theta*d_x - C_y_theta*d_y - C_z_theta*d_z
        s90 = -d_x*s22 - d_y*s29 - d_z*s23
        s93 = -C_x_alpha0*d_x - C_y_alpha0*d_y
        s96 = -C_x_beta0*d_x - C_y_beta0*d_y
        s100 = -c1_x_dc*d_x - c1_y_dc*d_y
        s101 = d_z*h_z_alpha03
        s104 = d_x*h_x_beta03 + d_y*h_y_beta03
        s108 = -c1_x_alpha2*d_x - c1_y_alpha2*d_y - c1_z_alpha2*d_z
        s112 = -c1_x_beta2*d_x - c1_y_beta2*d_y - c1_z_beta2*d_z
        w[640 + lane] = d_x
        w[672 + lane] = d_y
        w[704 + lane] = d_z
        w[736 + lane] = s71
        w[768 + lane] = s74
        w[800 + lane] = s77
        w[992 + lane] = s78
        w[1024 + lane] = s79
        w[1056 + lane] = s82
        w[1984 + lane] = s86
        w[2016 + lane] = -d_x
        w[2048 + lane] = -d_y
        w[2080 + lane] = -d_z
        w[2112 + lane] = s90
        w[2144 + lane] = s93
        w[2176 + lane] = s96
        w[2208 + lane] = -l
        w[2752 + lane] = s97
        w[2784 + lane] = s100
        w[2816 + lane] = s101
        w[2848 + lane] = s104
        w[2880 + lane] = s108
        w[2912 + lane] = s112


@straight
def _nominal_inverse(w, n):
    """Minus the inverse of the derivatives, its rows of the position; how far the equations are from dependent (223 operations)."""
    for lane in range(n):
        J00_0 = w[640 + lane]
        J10_0 = w[3648 + lane]
        J20_0 = w[6656 + lane]
        J00_1 = w[672 + lane]
        J10_1 = w[3680 + lane]
        J20_1 = w[6688 + lane]
        J00_2 = w[704 + lane]
        J10_2 = w[3712 + lane]
        J20_2 = w[6720 + lane]
        J00_3 = w[736 + lane]
        J10_3 = w[3744 + lane]
        J20_3 = w[6752 + lane]
        J00_4 = w[768 + lane]
        J10_4 = w[3776 + lane]
        J20_4 = w[6784 + lane]
        J00_5 = w[800 + lane]
        J10_5 = w[3808 + lane]
        J20_5 = w[6816 + lane]
        J01_3 = w[992 + lane]
        J11_3 = w[4000 + lane]
        J21_3 = w[7008 + lane]
        J01_4 = w[1024 + lane]
        J11_4 = w[4032 + lane]
        J21_4 = w[7040 + lane]
        J01_5 = w[1056 + lane]
        J11_5 = w[4064 + lane]
        J21_5 = w[7072 + lane]
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
        w[9312 + lane] = -G_inv_00
        w[9344 + lane] = -G_inv_01
        w[9376 + lane] = -G_inv_02
        w[9408 + lane] = s121
        w[9440 + lane] = s125
        w[9472 + lane] = s129
        w[9504 + lane] = -G_inv_10
        w[9536 + lane] = -G_inv_11
        w[9568 + lane] = -G_inv_12
        w[9600 + lane] = s133
        w[9632 + lane] = s137
        w[9664 + lane] = s141
        w[9696 + lane] = -G_inv_20
        w[9728 + lane] = -G_inv_21
        w[9760 + lane] = -G_inv_22
        w[9792 + lane] = s145
        w[9824 + lane] = s149
        w[9856 + lane] = s153
        w[9888 + lane] = s168
        w[9920 + lane] = s183


@straight
def _singular(w, poses):
    """Return how many of the poses are not regular."""
    many = 0
    for lane in range(poses):
        many += 0 if (w[9888 + lane] > 0.0) & (w[9920 + lane] > 0.0) else 1
    return many


@fast
def _products(w, S, first, last):
    """Multiply the inverse and the derivatives by the errors where they do not vanish."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 126 * (first + lane + 8) <= S.size  # else the last poses are written through scratch
        to, at = (S, 126 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 14 * i + 0, 126, 42, 3, w, (9312 + 32 * i + lane, ), 192, (1984 + 3008 * i + lane, ), 32, 8)
            outer(to, at + 14 * i + 8, 126, 42, 3, w, (9408 + 32 * i + lane, ), 192, (2752 + 3008 * i + lane, ), 32, 6)
        if not whole:
            for c in range(126 * (last + 1 - first - lane)):
                S[126 * (first + lane) + c] = to[c]



@fast
def nominal_sensitivity(x, q, tool, k, S):
    """Fill S (N, 3, 42) with the derivatives by the errors, limb by limb.

    Those of one limb are in the order of ``parameters.ERRORS``.
    """
    w, whole = scratch(WORK + SPARE), S.reshape(S.size)
    w_1 = w[0:3008]
    w_2 = w[3008:6016]
    w_3 = w[6016:9024]
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
        if not 0 <= columns[j] < 42:
            raise IndexError("there is no such column of the sensitivity")
    m = (n_h + 7) // 8 * 8
    w = scratch(WORK + 3 * ((poses + 7) * m + poses))
    C = w[WORK:]
    w_1 = w[0:3008]
    w_2 = w[3008:6016]
    w_3 = w[6016:9024]
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
