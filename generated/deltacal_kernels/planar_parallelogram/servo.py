"""Commands of one pose for a servo loop: `planar_parallelogram`, Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both 48d6dd99ce440098; SymPy 1.14.0.

Numbers in, numbers out, for loops that Numba compiles and for calls from Python: an array, or a part of one, costs more
than a command. Lengths in mm, angles in rad. Target, machine and scratch stand in one flat array w, which `exact_state`
and `linear_state` make, `copied` for every thread: loops over `lane` run over the limbs.
"""

import math
from functools import partial

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import aligned, arcsine, arctangent, copied, cosine, sine, tangent
from deltacal_kernels.straight import straight

from .vectorised import MAX_STEPS, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_CONSTANTS = 26  # what is exported reads these first columns of `vectorised.constants` only
LANES = np.int64(1)  # no literal: a loop whose end is known beforehand is unrolled, and not turned into SIMD code
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
fast = kernel(**OPTIONS)  # to let other threads run meanwhile would take longer than a command
few = partial(straight, wide=False)  # lanes: the limbs


def _exact_constants(p):
    """Return k (M, 1, 26), what no target changes, from p (88 operations).

    p is that of the calibrated machine.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((26, p.shape[1], 1))
    a1x = p[0]
    a2x = p[1]
    a2y = p[2]
    b1x = p[3]
    b2x = p[4]
    b2y = p[5]
    l1 = p[6]
    l2 = p[7]
    h = p[8]
    q0 = p[9]
    da1x = p[10]
    da2x = p[11]
    da2y = p[12]
    db1x = p[13]
    db2x = p[14]
    db2y = p[15]
    dl1 = p[16]
    dl2 = p[17]
    A1_x = -a1x - da1x
    A2_x = a2x + da2x
    A2_y = a2y + da2y
    b1_x = -b1x - db1x
    b2_x = b2x + db2x
    b2_y = b2y + db2y
    s7 = dl1 + l1
    s39 = (1.0 / s7)
    s40 = -A1_x + b1_x
    s45 = (1.0 / (s7 * s7))
    s53 = -2*b2_y
    s57 = -2*b2_x*s7
    s59 = 2*b1_x*s7
    s61 = -2*A1_x*b2_y + 2*A2_x*b2_y + 2*A2_y*b1_x - 2*A2_y*b2_x
    s67 = -2*b1_x
    s70 = 2*A1_x*b2_x
    s71 = 2*b2_x
    s73 = -2*b2_y*s7
    s75 = -2*A1_x*b1_x + 2*A2_x*b1_x - 2*A2_x*b2_x - 2*A2_y*b2_y + s70
    s80 = (b2_x * b2_x)
    s81 = (b2_y * b2_y)
    s82 = (A1_x * A1_x)
    s83 = (b1_x * b1_x)
    s84 = (dl2 * dl2)
    s85 = (l2 * l2)
    s86 = (s7 * s7)
    s88 = -2*dl2*l2
    s89 = -2*A1_x*A2_x
    s90 = -2*A2_x
    s92 = -2*b1_x*b2_x
    s93 = 2*A1_x
    s95 = 2*A2_y*s7
    s97 = (A2_x * A2_x) + (A2_y * A2_y) + s80 + s81 + s82 + s83 - s84 - s85 + s88 + s89 + s92
    s129 = -0.5*((dl2 + l2) * (dl2 + l2))
    k[0] = h
    k[1] = b1_x
    k[2] = s40
    k[3] = s39
    k[4] = q0
    k[5] = s45
    k[6] = s7
    k[7] = s53
    k[8] = s57
    k[9] = s59
    k[10] = s61
    k[11] = s67
    k[12] = s71
    k[13] = s73
    k[14] = s75
    k[15] = s86
    k[16] = s90
    k[17] = s93
    k[18] = s95
    k[19] = s97
    k[20] = b2_x
    k[21] = b2_y
    k[22] = A2_x
    k[23] = A2_y
    k[24] = A1_x
    k[25] = s129
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _linear_constants(p):
    """Return k (M, 1, 28), what no target changes, from p (76 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((28, p.shape[1], 1))
    a1x = p[0]
    a2x = p[1]
    a2y = p[2]
    b1x = p[3]
    b2x = p[4]
    b2y = p[5]
    l1 = p[6]
    l2 = p[7]
    h = p[8]
    q0 = p[9]
    da1x = p[10]
    da2x = p[11]
    da2y = p[12]
    db1x = p[13]
    db2x = p[14]
    db2y = p[15]
    dl1 = p[16]
    dl2 = p[17]
    by_s1 = -2*a2y*b1x
    by_s2 = -2*a2y*b2x
    by_s3 = 2*a1x*b2y
    by_s4 = 2*a2x*b2y
    by_s5 = -2*b1x*l1
    by_s7 = -2*b2x*l1
    by_s9 = -2*b2y*l1
    by_s11 = by_s1 + by_s2 + by_s3 + by_s4
    by_s14 = -2*a1x*b1x
    by_s15 = -2*a1x*b2x
    by_s16 = -2*a2x*b1x
    by_s17 = -2*a2x*b2x
    by_s18 = -2*a2y*b2y
    by_s22 = by_s14 + by_s15 + by_s16 + by_s17 + by_s18
    by_s25 = (a1x * a1x)
    by_s26 = (a2x * a2x)
    by_s27 = (a2y * a2y)
    by_s28 = (b1x * b1x)
    by_s29 = (b2x * b2x)
    by_s30 = (b2y * b2y)
    by_s31 = (l2 * l2)
    by_s33 = (l1 * l1)
    by_s37 = 2*a1x*a2x
    by_s38 = 2*b1x*b2x
    by_s39 = -2*a1x*l1
    by_s41 = -2*a2x*l1
    by_s43 = 2*a2y*l1
    by_s45 = by_s25 + by_s26 + by_s27 + by_s28 + by_s29 + by_s30 - by_s31 + by_s37 + by_s38
    by_s73 = l1*q0
    s135 = -da2x + db2x
    s138 = -da2y + db2y
    s140 = (1.0 / l1)
    s141 = a1x - b1x
    s151 = -dl2*l2
    k[0] = s141
    k[1] = s140
    k[2] = by_s5
    k[3] = by_s7
    k[4] = by_s9
    k[5] = by_s11
    k[6] = by_s22
    k[7] = by_s33
    k[8] = by_s39
    k[9] = by_s41
    k[10] = by_s43
    k[11] = by_s45
    k[12] = b1x
    k[13] = h
    k[14] = l1
    k[15] = by_s73
    k[16] = dl1
    k[17] = db1x
    k[18] = b2x
    k[19] = b2y
    k[20] = db2y
    k[21] = db2x
    k[22] = a2x
    k[23] = s135
    k[24] = a2y
    k[25] = s138
    k[26] = da1x
    k[27] = s151
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def linear_constants(p):
    """Return k (M, 1, 28), what `linear` reads that no pose changes, from p (68 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((28, p.shape[1], 1))
    a1x = p[0]
    a2x = p[1]
    a2y = p[2]
    b1x = p[3]
    b2x = p[4]
    b2y = p[5]
    l1 = p[6]
    l2 = p[7]
    h = p[8]
    q0 = p[9]
    da1x = p[10]
    da2x = p[11]
    da2y = p[12]
    db1x = p[13]
    db2x = p[14]
    db2y = p[15]
    dl1 = p[16]
    dl2 = p[17]
    s6 = -2*b1x*l1
    s8 = -2*b2x*l1
    s11 = -2*b2y*l1
    s13 = 2*a1x*b2y + 2*a2x*b2y - 2*a2y*b1x - 2*a2y*b2x
    s20 = -2*a2y*b2y
    s24 = -2*a1x*b1x - 2*a1x*b2x - 2*a2x*b1x - 2*a2x*b2x + s20
    s31 = (b2x * b2x)
    s32 = (b2y * b2y)
    s33 = (l2 * l2)
    s34 = (l1 * l1)
    s39 = 2*a1x*a2x
    s40 = 2*b1x*b2x
    s41 = -2*a1x*l1
    s43 = -2*a2x*l1
    s45 = 2*a2y*l1
    s47 = (a1x * a1x) + (a2x * a2x) + (a2y * a2y) + (b1x * b1x) + s31 + s32 - s33 + s39 + s40
    s75 = l1*q0
    s139 = (1.0 / l1)
    s140 = a1x - b1x
    s148 = -dl2*l2
    k[0] = s140
    k[1] = s139
    k[2] = l1
    k[3] = s6
    k[4] = s8
    k[5] = s11
    k[6] = s13
    k[7] = s24
    k[8] = s34
    k[9] = s41
    k[10] = s43
    k[11] = s45
    k[12] = s47
    k[13] = b1x
    k[14] = h
    k[15] = dl1
    k[16] = s75
    k[17] = db1x
    k[18] = b2x
    k[19] = b2y
    k[20] = db2x
    k[21] = db2y
    k[22] = a2x
    k[23] = da2x
    k[24] = a2y
    k[25] = da2y
    k[26] = da1x
    k[27] = s148
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def exact_state(p, tool, sign):
    """Return the array w of `exact_command` for a machine: p (1, 18), tool (3,), sign (1,) of the controller's joints."""
    w = aligned(80)
    w[16:19], w[20:21] = tool, sign
    k = _exact_constants(p[None])[0]
    w[52:78].reshape(-1, 1)[:] = np.pad(k, ((0, 0), (0, 0)), mode="edge").T
    return w


def linear_state(p, tool, sign):
    """Return the array w of `linear_command` for a machine: p (1, 18), tool (3,), sign (1,) of the controller's joints."""
    w = aligned(80)
    w[16:19], w[20:21] = tool, sign
    k = _linear_constants(p[None])[0]
    w[52:80].reshape(-1, 1)[:] = np.pad(k, ((0, 0), (0, 0)), mode="edge").T
    return w


@few
def _exact_joint(w, lanes):
    """Joint of the simplified limb at the target, then the platform's coordinates that follow from it (64 operations)."""
    px = w[0]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        h = w[52 + lane]
        b1_x = w[53 + lane]
        s40 = w[54 + lane]
        s39 = w[55 + lane]
        q0 = w[56 + lane]
        s45 = w[57 + lane]
        s7 = w[58 + lane]
        s53 = w[59 + lane]
        s57 = w[60 + lane]
        s59 = w[61 + lane]
        s61 = w[62 + lane]
        s67 = w[63 + lane]
        s71 = w[64 + lane]
        s73 = w[65 + lane]
        s75 = w[66 + lane]
        s86 = w[67 + lane]
        s90 = w[68 + lane]
        s93 = w[69 + lane]
        s95 = w[70 + lane]
        s97 = w[71 + lane]
        C_y = -h + ty
        s41 = px + s40 - tx
        s44 = -q0 + arcsine(s39*s41)
        s46 = (s41 * s41)
        s48 = -s45*s46 + 1
        s49 = math.sqrt(s48)
        s62 = s41*s53 + s49*s57 + s49*s59 + s61
        s76 = s41*s67 + s41*s71 + s49*s73 + s75
        s98 = s41*s90 + s41*s93 + s46 + s48*s86 + s49*s95 + s97
        s101 = math.sqrt((s62 * s62) + (s76 * s76) - (s98 * s98))
        s104 = s101*s76 - s62*s98
        s108 = -s101*s62 - s76*s98
        s111 = 1/math.sqrt((s104 * s104) + (s108 * s108))
        s114 = C_y*s108*s111 - s104*s111*(b1_x - tx) - s49*s7
        s118 = 2*tangent(0.5*arctangent(s104, s108))
        w[28 + lane] = s44
        w[29 + lane] = s114
        w[30 + lane] = s118


@few
def _exact_rows(w, lanes):
    """Equations of a limb, their derivatives by turns of the platform and by the joint (49 operations)."""
    px = w[0]
    py = w[1]
    R_11 = w[4]
    R_12 = w[5]
    R_21 = w[6]
    R_22 = w[7]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        h = w[52 + lane]
        b1_x = w[53 + lane]
        q0 = w[56 + lane]
        s7 = w[58 + lane]
        b2_x = w[72 + lane]
        b2_y = w[73 + lane]
        A2_x = w[74 + lane]
        A2_y = w[75 + lane]
        A1_x = w[76 + lane]
        s129 = w[77 + lane]
        q = w[28 + lane]
        C_y = -h + ty
        s8 = q + q0
        r1_x = s7*sine(s8)
        r1_y = -s7*cosine(s8)
        s22 = b1_x - tx
        s23 = R_11*s22
        s24 = -C_y*R_12
        B1_x = px + s23 + s24
        s26 = R_21*s22
        s27 = -C_y*R_22
        B1_y = py + s26 + s27
        s29 = b2_x - tx
        s30 = R_11*s29
        s31 = -C_y + b2_y
        s32 = R_12*s31
        B2_x = px + s30 + s32
        s34 = R_21*s29
        s35 = R_22*s31
        B2_y = py + s34 + s35
        r2_x = -A2_x + B2_x
        r2_y = -A2_y + B2_y
        s119 = -A1_x + B1_x - r1_x
        s120 = -s26 - s27
        s121 = B1_y - r1_y
        s122 = s23 + s24
        s130 = 0.5*(r2_x * r2_x) + 0.5*(r2_y * r2_y) + s129
        s135 = r2_x*(-s34 - s35) + r2_y*(s30 + s32)
        w[36 + lane] = s119
        w[38 + lane] = s120
        w[39 + lane] = r1_y
        w[40 + lane] = s121
        w[41 + lane] = 1
        w[42 + lane] = s122
        w[43 + lane] = -r1_x
        w[44 + lane] = s130
        w[45 + lane] = r2_y
        w[46 + lane] = s135


@few
def _exact_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (54 operations)."""
    F00 = w[36]
    J00_2 = w[38]
    Q00 = w[39]
    F01 = w[40]
    J01_1 = w[41]
    J01_2 = w[42]
    Q01 = w[43]
    F02 = w[44]
    J02_1 = w[45]
    J02_2 = w[46]
    A_cof_00 = J01_1*J02_2 - J01_2*J02_1
    A_cof_01 = -J02_2*Q01
    A_cof_02 = J02_1*Q01
    A_cof_10 = J00_2*J02_1
    A_cof_11 = J02_2*Q00
    A_cof_12 = -J02_1*Q00
    A_cof_20 = -J00_2*J01_1
    A_cof_21 = J00_2*Q01 - J01_2*Q00
    A_cof_22 = J01_1*Q00
    A_det_00 = A_cof_00*Q00 + A_cof_02*J00_2
    A_by_00 = (1.0 / A_det_00)
    s21 = A_by_00*(A_cof_00*F00 + A_cof_10*F01 + A_cof_20*F02)
    s26 = A_by_00*(A_cof_01*F00 + A_cof_11*F01 + A_cof_21*F02)
    s31 = A_by_00*(A_cof_02*F00 + A_cof_12*F01 + A_cof_22*F02)
    s42 = (J01_1 * J01_1) + (J01_2 * J01_2) + (Q01 * Q01)
    s44 = (A_det_00 * A_det_00) - 1.0e-12*s42*((J00_2 * J00_2) + (Q00 * Q00))*((J02_1 * J02_1) + (J02_2 * J02_2))
    w[24] = s21
    w[25] = s26
    w[26] = s31
    w[27] = s44


@few
def _exact_move(w):
    """The platform after a step, and its rotation matrix (16 operations)."""
    px = w[0]
    py = w[1]
    cz = w[2]
    y1 = w[25]
    y2 = w[26]
    new_10 = py - y1
    new_20 = cz - y2*(0.25*(cz * cz) + 1)
    s6 = (new_20 * new_20)
    s9 = (1.0 / (0.25*s6 + 1))
    s11 = -0.5*s6*s9 + 1
    s12 = -new_20*s9
    w[0] = px
    w[1] = new_10
    w[2] = new_20
    w[4] = s11
    w[5] = s12
    w[6] = -s12
    w[7] = s11


@fast
def _exact(px, w):
    w[0] = px
    _exact_joint(w, LANES)
    w[1] = w[29]
    w[25] = 0.0
    w[2] = w[30]
    w[26] = 0.0
    status = UNREACHABLE
    if (abs(w[28]) < math.inf):
        _exact_move(w)
        for _ in range(MAX_STEPS):
            _exact_rows(w, LANES)
            _exact_solution(w)
            if not ((w[27] > 0.0)):
                status = SINGULAR
                break
            size = 0.0
            for j in range(3):
                size = max(size, abs(w[24 + j]))
            for i in range(1):
                w[28 + i] -= w[24 + i]
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
            _exact_move(w)
    if status != SOLVED:
        for i in range(1):
            w[28 + i] = np.nan
    return status


@fast
def exact_command(px, w):
    """Return the joints that bring the reference point to a target, as the controller counts them; NaN where there are none.

    `inverse` for one pose, w from `exact_state`.
    """
    _exact(px, w)
    return w[20] * w[28]


@few
def _linear_joint(w, lanes):
    """Joint of the nominal limb at the target, its cosine and sine (4 operations)."""
    px = w[0]
    tx = w[16]
    for lane in range(lanes):
        s141 = w[52 + lane]
        s140 = w[53 + lane]
        s144 = arcsine(s140*(px + s141 - tx))
        w[28 + lane] = s144


@few
def _linear_angle(w, lanes):
    """Cosine and sine of the joint (2 operations)."""
    for lane in range(lanes):
        q = w[28 + lane]
        s145 = cosine(q)
        s146 = sine(q)
        w[32 + lane] = s145
        w[33 + lane] = s146


@few
def _linear_rows(w, lanes):
    """Equations of a nominal limb: change by all errors, derivatives by rotation and joint (148 operations)."""
    px = w[0]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        by_s5 = w[54 + lane]
        by_s7 = w[55 + lane]
        by_s9 = w[56 + lane]
        by_s11 = w[57 + lane]
        by_s22 = w[58 + lane]
        by_s33 = w[59 + lane]
        by_s39 = w[60 + lane]
        by_s41 = w[61 + lane]
        by_s43 = w[62 + lane]
        by_s45 = w[63 + lane]
        b1x = w[64 + lane]
        h = w[65 + lane]
        l1 = w[66 + lane]
        by_s73 = w[67 + lane]
        dl1 = w[68 + lane]
        db1x = w[69 + lane]
        b2x = w[70 + lane]
        b2y = w[71 + lane]
        db2y = w[72 + lane]
        db2x = w[73 + lane]
        a2x = w[74 + lane]
        s135 = w[75 + lane]
        a2y = w[76 + lane]
        s138 = w[77 + lane]
        da1x = w[78 + lane]
        s151 = w[79 + lane]
        cos_q = w[32 + lane]
        sin_q = w[33 + lane]
        by_s6 = by_s5*cos_q
        by_s8 = by_s7*cos_q
        by_s10 = by_s9*sin_q
        by_s12 = by_s10 + by_s11 + by_s6 + by_s8
        by_s13 = (by_s12 * by_s12)
        by_s19 = by_s9*cos_q
        by_s20 = -by_s5*sin_q
        by_s21 = -by_s7*sin_q
        by_s23 = by_s19 + by_s20 + by_s21 + by_s22
        by_s24 = (by_s23 * by_s23)
        by_s32 = (cos_q * cos_q)
        by_s34 = by_s32*by_s33
        by_s35 = (sin_q * sin_q)
        by_s36 = by_s33*by_s35
        by_s40 = by_s39*sin_q
        by_s42 = by_s41*sin_q
        by_s44 = by_s43*cos_q
        by_s46 = by_s34 + by_s36 + by_s40 + by_s42 + by_s44 + by_s45
        by_s47 = (by_s46 * by_s46)
        by_s48 = by_s13 + by_s24 - by_s47
        by_s49 = math.sqrt(by_s48)
        by_s50 = by_s23*by_s49
        by_s51 = -by_s12*by_s46
        by_s52 = by_s50 + by_s51
        by_s53 = (by_s52 * by_s52)
        by_s54 = -by_s23*by_s46
        by_s55 = -by_s12*by_s49
        by_s56 = by_s54 + by_s55
        by_s57 = (by_s56 * by_s56)
        by_s58 = by_s53 + by_s57
        by_s59 = 1/math.sqrt(by_s58)
        by_s60 = b1x + tx
        by_s61 = by_s52*by_s59*by_s60
        by_s62 = -h + ty
        by_s63 = by_s56*by_s59*by_s62
        by_s65 = arctangent(by_s52, by_s56)
        by_s66 = 0.5*by_s65
        by_s67 = tangent(by_s66)
        nominal_cz = 2*by_s67
        C_y = -h + ty
        r1_x_q = cos_q*l1
        r1_x_errors = by_s73*cos_q + dl1*sin_q
        r1_y_q = l1*sin_q
        r1_y_errors = by_s73*sin_q - cos_q*dl1
        by_s81 = (nominal_cz * nominal_cz)
        by_s82 = 0.25*by_s81
        by_s83 = by_s82 + 1
        by_s84 = (1.0 / by_s83)
        by_s85 = -0.5*by_s81*by_s84
        R_11 = by_s85 + 1
        by_s87 = -by_s84*nominal_cz
        by_s88 = (nominal_cz * nominal_cz * nominal_cz)
        by_s89 = (1.0 / (by_s83 * by_s83))
        by_s90 = 0.25*by_s88*by_s89
        R_11_cz = by_s87 + by_s90
        R_12 = -by_s84*nominal_cz
        by_s93 = 0.5*by_s81*by_s89
        R_12_cz = -by_s84 + by_s93
        R_21 = by_s84*nominal_cz
        R_21_cz = by_s84 - by_s93
        R_22 = by_s85 + 1
        R_22_cz = by_s87 + by_s90
        by_s102 = -R_11_cz*by_s60
        by_s103 = -C_y*R_12_cz
        B1_x_cz = by_s102 + by_s103
        B1_x_errors = -by_s85*db1x - db1x
        by_s109 = -R_21_cz*by_s60
        by_s110 = -C_y*R_22_cz
        B1_y_cz = by_s109 + by_s110
        B1_y_errors = -R_21*db1x
        by_s113 = b2x - tx
        by_s114 = R_11*by_s113
        by_s115 = -C_y + b2y
        by_s116 = R_12*by_s115
        by_s118 = R_11_cz*by_s113
        by_s119 = R_12_cz*by_s115
        B2_x_cz = by_s118 + by_s119
        by_s124 = R_21*by_s113
        by_s125 = R_22*by_s115
        by_s127 = R_21_cz*by_s113
        by_s128 = R_22_cz*by_s115
        B2_y_cz = by_s127 + by_s128
        r2_x = -a2x + by_s114 + by_s116 + px
        r2_x_errors = R_12*db2y + by_s85*db2x + s135
        r2_y = -a2y + by_s124 + by_s125 + by_s61 + by_s63 - cos_q*l1
        r2_y_errors = R_21*db2x + by_s85*db2y + s138
        s147 = B1_x_errors + da1x - r1_x_errors
        s148 = B1_y_errors - r1_y_errors
        s152 = r2_x*r2_x_errors + r2_y*r2_y_errors + s151
        s155 = B2_x_cz*r2_x + B2_y_cz*r2_y
        w[36 + lane] = s147
        w[38 + lane] = B1_x_cz
        w[39 + lane] = -r1_x_q
        w[40 + lane] = s148
        w[41 + lane] = 1
        w[42 + lane] = B1_y_cz
        w[43 + lane] = -r1_y_q
        w[44 + lane] = s152
        w[45 + lane] = r2_y
        w[46 + lane] = s155


@few
def _linear_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (33 operations)."""
    F00 = w[36]
    J00_2 = w[38]
    Q00 = w[39]
    F01 = w[40]
    J01_1 = w[41]
    J01_2 = w[42]
    Q01 = w[43]
    F02 = w[44]
    J02_1 = w[45]
    J02_2 = w[46]
    A_cof_00 = J01_1*J02_2 - J01_2*J02_1
    A_cof_02 = J02_1*Q01
    A_cof_10 = J00_2*J02_1
    A_cof_20 = -J00_2*J01_1
    A_det_00 = A_cof_00*Q00 + A_cof_02*J00_2
    A_by_00 = (1.0 / A_det_00)
    s21 = A_by_00*(A_cof_00*F00 + A_cof_10*F01 + A_cof_20*F02)
    s32 = (J01_1 * J01_1) + (J01_2 * J01_2) + (Q01 * Q01)
    s34 = (A_det_00 * A_det_00) - 1.0e-12*s32*((J00_2 * J00_2) + (Q00 * Q00))*((J02_1 * J02_1) + (J02_2 * J02_2))
    w[24] = s21
    w[27] = s34


@fast
def _linear(px, w):
    w[0] = px
    _linear_joint(w, LANES)
    _linear_angle(w, LANES)
    _linear_rows(w, LANES)
    _linear_solution(w)
    status = (SOLVED if (w[27] > 0.0) else SINGULAR) if (abs(w[28]) < math.inf) else UNREACHABLE
    w[28] = w[28] - w[24] if status == SOLVED else np.nan
    return status


@fast
def linear_command(px, w):
    """Return the joints that bring the reference point to a target to first order in the errors, like `exact_command`.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. w from `linear_state`.
    """
    _linear(px, w)
    return w[20] * w[28]


@fast
def linear_change(px, q_1, w):
    """Return what to add to the nominal joints of a target, both as the controller counts them; NaN where it is singular.

    For a controller that has nominal joints already: what `linear_command` adds to them.
    """
    w[0] = px
    w[28] = w[20] * q_1
    _linear_angle(w, LANES)
    _linear_rows(w, LANES)
    _linear_solution(w)
    back = -1.0 if (w[27] > 0.0) else np.nan
    return back * w[20] * w[24]


@kernel(nogil=True, **OPTIONS)
def linear_commands(target, tool, w, q, status):
    """Fill q (N, 1), as the geometry counts, and status (N,) by `linear_command`; target (N, 1), tool (N or 1, 3)."""
    for n in range(target.shape[0]):
        if n == 0 or tool.shape[0] > 1:
            for c in range(3):
                w[16 + c] = tool[n, c]
        status[n] = _linear(target[n, 0], w)
        for i in range(1):
            q[n, i] = w[28 + i]
