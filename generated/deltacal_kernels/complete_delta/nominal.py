"""Derivatives of the nominal machine's position by its errors, many poses at once: `complete_delta`, Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/nominal.py.jinja; sha256 of both 6310438228ab48ea; SymPy 1.14.0.

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
FACTORS = np.array(((10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10272, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10304, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336, 10336), (10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10368, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10400, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432, 10432)))
VALUES = np.array(((2112, 2144, 2176, 2208, 2240, 2272, 2304, 2336, 2368, 2400, 2432, 2464, 2496, 2528, 2560, 2592, 2624, 5440, 5472, 5504, 5536, 5568, 5600, 5632, 5664, 5696, 5728, 5760, 5792, 5824, 5856, 5888, 5920, 5952, 8768, 8800, 8832, 8864, 8896, 8928, 8960, 8992, 9024, 9056, 9088, 9120, 9152, 9184, 9216, 9248, 9280), (2720, 2752, 2784, 2816, 2848, 2880, 2912, 2944, 2976, 3008, 3040, 3072, 3104, 3136, 3168, 3200, 3232, 6048, 6080, 6112, 6144, 6176, 6208, 6240, 6272, 6304, 6336, 6368, 6400, 6432, 6464, 6496, 6528, 6560, 9376, 9408, 9440, 9472, 9504, 9536, 9568, 9600, 9632, 9664, 9696, 9728, 9760, 9792, 9824, 9856, 9888)))
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _nominal(w, k, n):
    """Equations of a nominal limb by platform and errors (207 operations)."""
    R0_12 = k[0]
    R0_11 = k[1]
    R0_22 = k[2]
    R0_22_betaz = k[3]
    R0_32_betax = k[4]
    R0_11_betaz = k[5]
    L = k[6]
    s31 = k[7]
    s34 = k[8]
    s39 = k[9]
    s41 = k[10]
    s28 = k[11]
    h1_x = k[12]
    h1_y = k[13]
    s60 = k[14]
    s62 = k[15]
    s64 = k[16]
    s66 = k[17]
    s59 = k[18]
    h2_x = k[19]
    h2_y = k[20]
    s105 = k[21]
    s107 = k[22]
    s118 = k[23]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        s7 = cosine(q)
        s8 = R0_12*s7
        s9 = sine(q)
        R1_12_betaz = -R0_11*s7
        s11 = -R0_12*s9
        s13 = R0_22*s7
        R1_22_betaz = R0_22_betaz*s7
        s15 = -R0_22*s9
        R1_32_betax = R0_32_betax*s7
        R1_32_betay = -R0_11_betaz*s7
        s29 = L*s8
        A1_x = s29 + s31
        s33 = L*s9
        s35 = L*R1_12_betaz
        A1_x_betaz = s34 + s35
        s37 = L*s13
        A1_y = s37 + s39
        s42 = L*R1_22_betaz
        A1_y_betaz = s41 + s42
        s44 = L*R1_32_betax
        A1_z_betax = -s34 + s44
        s46 = L*R1_32_betay
        A1_z_betay = -s28 + s46
        s48 = h1_x - tx
        s49 = h1_y - ty
        B1_x = px + s48
        B1_y = py + s49
        B1_z = pz - tz
        d1_x = -A1_x + B1_x
        d1_y = -A1_y + B1_y
        d1_z = B1_z - s33
        A2_x = s29 + s60
        A2_x_betaz = s35 + s62
        A2_y = s37 + s64
        A2_y_betaz = s42 + s66
        A2_z_betax = s44 - s62
        A2_z_betay = s46 - s59
        s70 = h2_x - tx
        s71 = h2_y - ty
        B2_x = px + s70
        B2_y = py + s71
        B2_z = pz - tz
        d2_x = -A2_x + B2_x
        d2_y = -A2_y + B2_y
        d2_z = B2_z - s33
        s78 = 0.5*d1_x
        s79 = 0.5*d2_x
        s80 = s78 + s79
        s81 = 0.5*d1_y
        s82 = 0.5*d2_y
        s83 = s81 + s82
        s84 = 0.5*d1_z
        s85 = 0.5*d2_z
        s86 = s84 + s85
        s87 = 0.5*d1_y*tz
        s88 = 0.5*d1_z*s49
        s89 = 0.5*d2_y*tz
        s90 = 0.5*d2_z*s71
        s91 = s87 + s88 + s89 + s90
        s92 = -0.5*d1_x*tz
        s93 = -0.5*d1_z*s48
        s94 = -0.5*d2_x*tz
        s95 = -0.5*d2_z*s70
        s96 = s92 + s93 + s94 + s95
        s97 = -0.5*d1_x*s49
        s98 = 0.5*d1_y*s48
        s99 = -0.5*d2_x*s71
        s100 = 0.5*d2_y*s70
        s101 = s100 + s97 + s98 + s99
        s102 = s87 + s88 - s89 - s90
        s103 = s92 + s93 - s94 - s95
        s104 = -s100 + s97 + s98 - s99
        s109 = d1_x*s105 + d1_y*s107
        s113 = -0.5*d1_x*s8 - 0.5*d1_y*s13 - 0.5*d1_z*s9
        s117 = -0.5*d1_x*s11 - 0.5*d1_y*s15 - 0.5*d1_z*s7
        s121 = d2_x*s105 + d2_y*s107
        s125 = -0.5*d2_x*s8 - 0.5*d2_y*s13 - 0.5*d2_z*s9
        s129 = -0.5*d2_x*s11 - 0.5*d2_y*s15 - 0.5*d2_z*s7
        s130 = 0.5*d1_y*s33
        s131 = -0.5*A1_z_betax*d1_z
        s132 = 0.5*d2_y*s33
        s133 = -0.5*A2_z_betax*d2_z
        s134 = s130 + s131 + s132 + s133
        s135 = -0.5*d1_x*s33
        s136 = -0.5*A1_z_betay*d1_z
        s137 = -0.5*d2_x*s33
        s138 = -0.5*A2_z_betay*d2_z
        s139 = s135 + s136 + s137 + s138
        s140 = -0.5*A1_x_betaz*d1_x
        s141 = -0.5*A1_y_betaz*d1_y
        s142 = -0.5*A2_x_betaz*d2_x
        s143 = -0.5*A2_y_betaz*d2_y
        s144 = s140 + s141 + s142 + s143
        s145 = s130 + s131 - s132 - s133
        s146 = s135 + s136 - s137 - s138
        s147 = s140 + s141 - s142 - s143
        w[640 + lane] = s80
        w[672 + lane] = s83
        w[704 + lane] = s86
        w[736 + lane] = s91
        w[768 + lane] = s96
        w[800 + lane] = s101
        w[992 + lane] = s102
        w[1024 + lane] = s103
        w[1056 + lane] = s104
        w[2112 + lane] = s78
        w[2144 + lane] = s81
        w[2176 + lane] = s84
        w[2208 + lane] = s109
        w[2240 + lane] = s113
        w[2272 + lane] = s117
        w[2304 + lane] = s118
        w[2336 + lane] = s79
        w[2368 + lane] = s82
        w[2400 + lane] = s85
        w[2432 + lane] = s121
        w[2464 + lane] = s125
        w[2496 + lane] = s129
        w[2528 + lane] = s118
        w[2560 + lane] = s134
        w[2592 + lane] = s139
        w[2624 + lane] = s144
        w[2720 + lane] = s78
        w[2752 + lane] = s81
        w[2784 + lane] = s84
        w[2816 + lane] = s109
        w[2848 + lane] = s113
        w[2880 + lane] = s117
        w[2912 + lane] = s118
        w[2944 + lane] = -s79
        w[2976 + lane] = -s82
        w[3008 + lane] = -s85
        w[3040 + lane] = -s121
        w[3072 + lane] = -s125
        w[3104 + lane] = -s129
        w[3136 + lane] = -s118
        w[3168 + lane] = s145
        w[3200 + lane] = s146
        w[3232 + lane] = s147


@straight
def _nominal_inverse(w, n):
    """Minus the inverse of the derivatives, its rows of the position; how far the equations are from dependent (223 operations)."""
    for lane in range(n):
        J00_0 = w[640 + lane]
        J10_0 = w[3968 + lane]
        J20_0 = w[7296 + lane]
        J00_1 = w[672 + lane]
        J10_1 = w[4000 + lane]
        J20_1 = w[7328 + lane]
        J00_2 = w[704 + lane]
        J10_2 = w[4032 + lane]
        J20_2 = w[7360 + lane]
        J00_3 = w[736 + lane]
        J10_3 = w[4064 + lane]
        J20_3 = w[7392 + lane]
        J00_4 = w[768 + lane]
        J10_4 = w[4096 + lane]
        J20_4 = w[7424 + lane]
        J00_5 = w[800 + lane]
        J10_5 = w[4128 + lane]
        J20_5 = w[7456 + lane]
        J01_3 = w[992 + lane]
        J11_3 = w[4320 + lane]
        J21_3 = w[7648 + lane]
        J01_4 = w[1024 + lane]
        J11_4 = w[4352 + lane]
        J21_4 = w[7680 + lane]
        J01_5 = w[1056 + lane]
        J11_5 = w[4384 + lane]
        J21_5 = w[7712 + lane]
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
        w[10272 + lane] = -G_inv_00
        w[10304 + lane] = -G_inv_01
        w[10336 + lane] = -G_inv_02
        w[10368 + lane] = s121
        w[10400 + lane] = s125
        w[10432 + lane] = s129
        w[10464 + lane] = -G_inv_10
        w[10496 + lane] = -G_inv_11
        w[10528 + lane] = -G_inv_12
        w[10560 + lane] = s133
        w[10592 + lane] = s137
        w[10624 + lane] = s141
        w[10656 + lane] = -G_inv_20
        w[10688 + lane] = -G_inv_21
        w[10720 + lane] = -G_inv_22
        w[10752 + lane] = s145
        w[10784 + lane] = s149
        w[10816 + lane] = s153
        w[10848 + lane] = s168
        w[10880 + lane] = s183


@straight
def _singular(w, poses):
    """Return how many of the poses are not regular."""
    many = 0
    for lane in range(poses):
        many += 0 if (w[10848 + lane] > 0.0) & (w[10880 + lane] > 0.0) else 1
    return many


@fast
def _products(w, S, first, last):
    """Multiply the inverse and the derivatives by the errors where they do not vanish."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 153 * (first + lane + 8) <= S.size  # else the last poses are written through scratch
        to, at = (S, 153 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(3):
            outer(to, at + 17 * i + 0, 153, 51, 3, w, (10272 + 32 * i + lane, 10368 + 32 * i + lane, ), 192, (2112 + 3328 * i + lane, 2720 + 3328 * i + lane, ), 32, 8)
            outer(to, at + 17 * i + 8, 153, 51, 3, w, (10272 + 32 * i + lane, 10368 + 32 * i + lane, ), 192, (2368 + 3328 * i + lane, 2976 + 3328 * i + lane, ), 32, 8)
            outer(to, at + 17 * i + 16, 153, 51, 3, w, (10272 + 32 * i + lane, 10368 + 32 * i + lane, ), 192, (2624 + 3328 * i + lane, 3232 + 3328 * i + lane, ), 32, 1)
        if not whole:
            for c in range(153 * (last + 1 - first - lane)):
                S[153 * (first + lane) + c] = to[c]



@fast
def nominal_sensitivity(x, q, tool, k, S):
    """Fill S (N, 3, 51) with the derivatives by the errors, limb by limb.

    Those of one limb are in the order of ``parameters.ERRORS``.
    """
    w, whole = scratch(WORK + SPARE), S.reshape(S.size)
    w_1 = w[0:3328]
    w_2 = w[3328:6656]
    w_3 = w[6656:9984]
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
                w, lane, 192, FACTORS, VALUES, columns, start, 2,
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
        if not 0 <= columns[j] < 51:
            raise IndexError("there is no such column of the sensitivity")
    m = (n_h + 7) // 8 * 8
    w = scratch(WORK + 3 * ((poses + 7) * m + poses))
    C = w[WORK:]
    w_1 = w[0:3328]
    w_2 = w[3328:6656]
    w_3 = w[6656:9984]
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
