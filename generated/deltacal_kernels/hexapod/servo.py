"""Commands of one pose for a servo loop: `hexapod`, Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both 1ff1b93210c0b35d; SymPy 1.14.0.

Numbers in, numbers out, for loops that Numba compiles and for calls from Python: an array, or a part of one, costs more
than a command. Lengths in mm, angles in rad. Target, machine and scratch stand in one flat array w, which `exact_state`
and `linear_state` make, `copied` for every thread: loops over `lane` run over the limbs, the last of them again so that
they are 8.
"""

import math
from functools import partial

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import aligned, arcsine, arctangent, copied, cosine, sine, tangent
from deltacal_kernels.straight import straight

from .vectorised import MAX_STEPS, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_CONSTANTS = 12  # what is exported reads these first columns of `vectorised.constants` only
LANES = np.int64(8)  # no literal: a loop whose end is known beforehand is unrolled, and not turned into SIMD code
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
fast = kernel(**OPTIONS)  # to let other threads run meanwhile would take longer than a command
few = partial(straight, wide=False)  # lanes: the limbs


def _exact_constants(p):
    """Return k (M, 6, 13), what no target changes, from p (37 operations).

    p is that of the calibrated machine.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((13, p.shape[1], 6))
    base = p[0]
    alpha = p[1]
    up = p[2]
    plate = p[3]
    beta = p[4]
    down = p[5]
    leg = p[6]
    ax = p[7]
    ay = p[8]
    az = p[9]
    bx = p[10]
    by = p[11]
    bz = p[12]
    dl = p[13]
    scale = p[14]
    dtx = p[15]
    dty = p[16]
    dtz = p[17]
    A_x = ax + base*np.cos(alpha)
    A_y = ay + base*np.sin(alpha)
    A_z = az + up
    s44 = bx - dtx + plate*np.cos(beta)
    s48 = by - dty + plate*np.sin(beta)
    s50 = bz + down - dtz
    s67 = scale + 1
    s69 = dl + leg
    s75 = (1.0 / (s67 * s67))
    s91 = (s69 * s69)
    s92 = -0.5*s91
    s94 = 2*s75
    s98 = 2*scale + 2
    s100 = 0.25*s91*(s98 * s98)/(s67 * s67 * s67 * s67)
    s103 = -0.5*s69*s75*s98
    s136 = (s67 * s67)
    k[0] = s44
    k[1] = s48
    k[2] = s50
    k[3] = A_x
    k[4] = A_y
    k[5] = A_z
    k[6] = s92
    k[7] = s94
    k[8] = s100
    k[9] = s103
    k[10] = s67
    k[11] = s69
    k[12] = s136
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _linear_constants(p):
    """Return k (M, 6, 15), what no target changes, from p (14 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((15, p.shape[1], 6))
    base = p[0]
    alpha = p[1]
    up = p[2]
    plate = p[3]
    beta = p[4]
    down = p[5]
    leg = p[6]
    ax = p[7]
    ay = p[8]
    az = p[9]
    bx = p[10]
    by = p[11]
    bz = p[12]
    dl = p[13]
    scale = p[14]
    dtx = p[15]
    dty = p[16]
    dtz = p[17]
    by_s35 = np.cos(alpha)
    A_x = base*by_s35
    by_s37 = np.sin(alpha)
    A_y = base*by_s37
    by_s39 = np.cos(beta)
    by_s40 = by_s39*plate
    b_x_errors = bx - dtx
    by_s43 = np.sin(beta)
    by_s44 = by_s43*plate
    b_y_errors = by - dty
    b_z_errors = bz - dtz
    s74 = -ax + b_x_errors
    s77 = -ay + b_y_errors
    s80 = -az + b_z_errors
    k[0] = by_s40
    k[1] = by_s44
    k[2] = down
    k[3] = A_x
    k[4] = A_y
    k[5] = up
    k[6] = leg
    k[7] = b_y_errors
    k[8] = b_z_errors
    k[9] = b_x_errors
    k[10] = s74
    k[11] = s77
    k[12] = s80
    k[13] = scale
    k[14] = dl
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def linear_constants(p):
    """Return k (M, 6, 15), what `linear` reads that no pose changes, from p (11 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((15, p.shape[1], 6))
    base = p[0]
    alpha = p[1]
    up = p[2]
    plate = p[3]
    beta = p[4]
    down = p[5]
    leg = p[6]
    ax = p[7]
    ay = p[8]
    az = p[9]
    bx = p[10]
    by = p[11]
    bz = p[12]
    dl = p[13]
    scale = p[14]
    dtx = p[15]
    dty = p[16]
    dtz = p[17]
    A_x = base*np.cos(alpha)
    A_y = base*np.sin(alpha)
    s40 = plate*np.cos(beta)
    b_x_errors = bx - dtx
    s44 = plate*np.sin(beta)
    b_y_errors = by - dty
    b_z_errors = bz - dtz
    k[0] = s40
    k[1] = s44
    k[2] = down
    k[3] = A_x
    k[4] = A_y
    k[5] = up
    k[6] = leg
    k[7] = b_x_errors
    k[8] = b_y_errors
    k[9] = b_z_errors
    k[10] = ax
    k[11] = ay
    k[12] = az
    k[13] = scale
    k[14] = dl
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def exact_state(p, tool, sign):
    """Return the array w of `exact_command` for a machine: p (6, 18), tool (3,), sign (6,) of the controller's joints."""
    w = aligned(192)
    w[20:23], w[24:30] = tool, sign
    k = _exact_constants(p[None])[0]
    w[88:192].reshape(-1, 8)[:] = np.pad(k, ((0, 2), (0, 0)), mode="edge").T
    return w


def linear_state(p, tool, sign):
    """Return the array w of `linear_command` for a machine: p (6, 18), tool (3,), sign (6,) of the controller's joints."""
    w = aligned(208)
    w[20:23], w[24:30] = tool, sign
    k = _linear_constants(p[None])[0]
    w[88:208].reshape(-1, 8)[:] = np.pad(k, ((0, 2), (0, 0)), mode="edge").T
    return w


@few
def _exact_joint(w, lanes):
    """Joint of the simplified limb at the target, then the platform's coordinates that follow from it (66 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    cx = w[3]
    cy = w[4]
    cz = w[5]
    R_11 = w[8]
    R_22 = w[12]
    R_33 = w[16]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s44 = w[88 + lane]
        s48 = w[96 + lane]
        s50 = w[104 + lane]
        A_x = w[112 + lane]
        A_y = w[120 + lane]
        A_z = w[128 + lane]
        s92 = w[136 + lane]
        s94 = w[144 + lane]
        s100 = w[152 + lane]
        s103 = w[160 + lane]
        s7 = (1.0 / (0.25*(cx * cx) + 0.25*(cy * cy) + 0.25*(cz * cz) + 1))
        s13 = 0.5*cx*cy
        s16 = 0.5*cx*cz
        s25 = 0.5*cy*cz
        b_x = s44 - tx
        b_y = s48 - ty
        b_z = s50 - tz
        s79 = ((-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px) * (-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px))
        s84 = ((-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py) * (-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py))
        s89 = ((-A_z + R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz) * (-A_z + R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz))
        s104 = s103 + math.sqrt(s100 + s94*(0.5*s79 + 0.5*s84 + 0.5*s89 + s92))
        w[40 + lane] = s104


@few
def _exact_rows(w, lanes):
    """Equations of a limb, their derivatives by turns of the platform and by the joint (76 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    R_11 = w[8]
    R_12 = w[9]
    R_13 = w[10]
    R_21 = w[11]
    R_22 = w[12]
    R_23 = w[13]
    R_31 = w[14]
    R_32 = w[15]
    R_33 = w[16]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s44 = w[88 + lane]
        s48 = w[96 + lane]
        s50 = w[104 + lane]
        A_x = w[112 + lane]
        A_y = w[120 + lane]
        A_z = w[128 + lane]
        s67 = w[168 + lane]
        s69 = w[176 + lane]
        s136 = w[184 + lane]
        q = w[40 + lane]
        b_x = s44 - tx
        b_y = s48 - ty
        b_z = s50 - tz
        s52 = R_11*b_x
        s53 = R_12*b_y
        s54 = R_13*b_z
        B_x = px + s52 + s53 + s54
        s56 = R_21*b_x
        s57 = R_22*b_y
        s58 = R_23*b_z
        B_y = py + s56 + s57 + s58
        s60 = R_31*b_x
        s61 = R_32*b_y
        s62 = R_33*b_z
        B_z = pz + s60 + s61 + s62
        d_x = -A_x + B_x
        d_y = -A_y + B_y
        d_z = -A_z + B_z
        s = q*s67 + s69
        s105 = (d_x * d_x)
        s107 = (d_y * d_y)
        s109 = (d_z * d_z)
        s111 = (s * s)
        s113 = 0.5*s105 + 0.5*s107 + 0.5*s109 - 0.5*s111
        s114 = -s*s67
        s118 = s60 + s61 + s62
        s120 = -s52 - s53 - s54
        s124 = -1.0e-12*((d_x*s118 + d_z*s120) * (d_x*s118 + d_z*s120))
        s125 = -s56 - s57 - s58
        s130 = -1.0e-12*((d_x*s125 - d_y*s120) * (d_x*s125 - d_y*s120))
        s135 = -1.0e-12*((-d_y*s118 - d_z*s125) * (-d_y*s118 - d_z*s125))
        s138 = -1.0e-12*s105 - 1.0e-12*s107 - 1.0e-12*s109 + s111*s136 + s124 + s130 + s135
        w[64 + lane] = s113
        w[72 + lane] = s114
        w[80 + lane] = s138


@few
def _exact_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (6 operations)."""
    F00 = w[64]
    Q00 = w[72]
    F10 = w[65]
    Q10 = w[73]
    F20 = w[66]
    Q20 = w[74]
    F30 = w[67]
    Q30 = w[75]
    F40 = w[68]
    Q40 = w[76]
    F50 = w[69]
    Q50 = w[77]
    s1 = F00/Q00
    s3 = F10/Q10
    s5 = F20/Q20
    s7 = F30/Q30
    s9 = F40/Q40
    s11 = F50/Q50
    w[32] = s1
    w[33] = s3
    w[34] = s5
    w[35] = s7
    w[36] = s9
    w[37] = s11


@few
def _exact_move(w):
    """The platform after a step, and its rotation matrix (43 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    cx = w[3]
    cy = w[4]
    cz = w[5]
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
    w[0] = px
    w[1] = py
    w[2] = pz
    w[3] = cx
    w[4] = cy
    w[5] = cz
    w[8] = s12
    w[9] = s15
    w[10] = s18
    w[11] = s20
    w[12] = s24
    w[13] = s27
    w[14] = s29
    w[15] = s31
    w[16] = s34


@fast
def _exact(px, py, pz, cx, cy, cz, w):
    w[0] = px
    w[1] = py
    w[2] = pz
    w[3] = cx
    w[4] = cy
    w[5] = cz
    _exact_move(w)  # joints begin by the rotation of this target, not by that of the last one
    _exact_joint(w, LANES)
    status = UNREACHABLE
    if (abs(w[40]) < math.inf) & (abs(w[41]) < math.inf) & (abs(w[42]) < math.inf) & (abs(w[43]) < math.inf) & (abs(w[44]) < math.inf) & (abs(w[45]) < math.inf):
        _exact_move(w)
        for _ in range(MAX_STEPS):
            _exact_rows(w, LANES)
            _exact_solution(w)
            if not ((w[80] > 0.0) & (w[81] > 0.0) & (w[82] > 0.0) & (w[83] > 0.0) & (w[84] > 0.0) & (w[85] > 0.0)):
                status = SINGULAR
                break
            size = 0.0
            for j in range(6):
                size = max(size, abs(w[32 + j]))
            for i in range(6):
                w[40 + i] -= w[32 + i]
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
            _exact_move(w)
    if status != SOLVED:
        for i in range(6):
            w[40 + i] = np.nan
    return status


@fast
def exact_command(px, py, pz, cx, cy, cz, w):
    """Return the joints that bring the reference point to a target, as the controller counts them; NaN where there are none.

    `inverse` for one pose, w from `exact_state`.
    """
    _exact(px, py, pz, cx, cy, cz, w)
    return w[24] * w[40], w[25] * w[41], w[26] * w[42], w[27] * w[43], w[28] * w[44], w[29] * w[45]


@few
def _linear_joint(w, lanes):
    """Joint of the nominal limb at the target, its cosine and sine (75 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    cx = w[3]
    cy = w[4]
    cz = w[5]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        by_s40 = w[88 + lane]
        by_s44 = w[96 + lane]
        down = w[104 + lane]
        A_x = w[112 + lane]
        A_y = w[120 + lane]
        up = w[128 + lane]
        leg = w[136 + lane]
        by_s0 = (cx * cx)
        by_s1 = 0.25*by_s0
        by_s2 = (cy * cy)
        by_s3 = 0.25*by_s2
        by_s4 = (cz * cz)
        by_s5 = 0.25*by_s4
        by_s6 = by_s1 + by_s3 + by_s5 + 1
        by_s7 = (1.0 / by_s6)
        by_s8 = -0.5*by_s2
        by_s9 = -0.5*by_s4
        by_s10 = by_s8 + by_s9
        by_s11 = by_s10*by_s7
        R_11 = by_s11 + 1
        by_s13 = 0.5*cx*cy
        by_s14 = by_s13 - cz
        by_s16 = 0.5*cx*cz
        by_s17 = by_s16 + cy
        by_s19 = by_s13 + cz
        by_s21 = -0.5*by_s0
        by_s22 = by_s21 + by_s9
        by_s23 = by_s22*by_s7
        R_22 = by_s23 + 1
        by_s25 = 0.5*cy*cz
        by_s26 = by_s25 - cx
        by_s28 = by_s16 - cy
        by_s30 = by_s25 + cx
        by_s32 = by_s21 + by_s8
        by_s33 = by_s32*by_s7
        R_33 = by_s33 + 1
        b_x = by_s40 - tx
        b_y = by_s44 - ty
        b_z = down - tz
        by_s49 = R_11*b_x
        by_s58 = R_22*b_y
        by_s67 = R_33*b_z
        s212 = ((-A_y + b_x*by_s19*by_s7 + b_z*by_s26*by_s7 + by_s58 + py) * (-A_y + b_x*by_s19*by_s7 + b_z*by_s26*by_s7 + by_s58 + py))
        s216 = ((b_x*by_s28*by_s7 + b_y*by_s30*by_s7 + by_s67 + pz - up) * (b_x*by_s28*by_s7 + b_y*by_s30*by_s7 + by_s67 + pz - up))
        s217 = s212 + s216 + ((-A_x + b_y*by_s14*by_s7 + b_z*by_s17*by_s7 + by_s49 + px) * (-A_x + b_y*by_s14*by_s7 + b_z*by_s17*by_s7 + by_s49 + px))
        s219 = -leg + math.sqrt(s217)
        w[40 + lane] = s219


@few
def _linear_rows(w, lanes):
    """Equations of a nominal limb: change by all errors, derivatives by rotation and joint (325 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    cx = w[3]
    cy = w[4]
    cz = w[5]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        by_s40 = w[88 + lane]
        by_s44 = w[96 + lane]
        down = w[104 + lane]
        A_x = w[112 + lane]
        A_y = w[120 + lane]
        up = w[128 + lane]
        leg = w[136 + lane]
        b_y_errors = w[144 + lane]
        b_z_errors = w[152 + lane]
        b_x_errors = w[160 + lane]
        s74 = w[168 + lane]
        s77 = w[176 + lane]
        s80 = w[184 + lane]
        scale = w[192 + lane]
        dl = w[200 + lane]
        q = w[40 + lane]
        by_s0 = (cx * cx)
        by_s1 = 0.25*by_s0
        by_s2 = (cy * cy)
        by_s3 = 0.25*by_s2
        by_s4 = (cz * cz)
        by_s5 = 0.25*by_s4
        by_s6 = by_s1 + by_s3 + by_s5 + 1
        by_s7 = (1.0 / by_s6)
        by_s8 = -0.5*by_s2
        by_s9 = -0.5*by_s4
        by_s10 = by_s8 + by_s9
        by_s11 = by_s10*by_s7
        R_11 = by_s11 + 1
        by_s13 = 0.5*cx*cy
        by_s14 = by_s13 - cz
        R_12 = by_s14*by_s7
        by_s16 = 0.5*cx*cz
        by_s17 = by_s16 + cy
        R_13 = by_s17*by_s7
        by_s19 = by_s13 + cz
        R_21 = by_s19*by_s7
        by_s21 = -0.5*by_s0
        by_s22 = by_s21 + by_s9
        by_s23 = by_s22*by_s7
        R_22 = by_s23 + 1
        by_s25 = 0.5*cy*cz
        by_s26 = by_s25 - cx
        R_23 = by_s26*by_s7
        by_s28 = by_s16 - cy
        R_31 = by_s28*by_s7
        by_s30 = by_s25 + cx
        R_32 = by_s30*by_s7
        by_s32 = by_s21 + by_s8
        by_s33 = by_s32*by_s7
        R_33 = by_s33 + 1
        b_x = by_s40 - tx
        b_y = by_s44 - ty
        b_z = down - tz
        by_s49 = R_11*b_x
        by_s50 = R_12*b_y
        by_s51 = R_13*b_z
        by_s57 = R_21*b_x
        by_s58 = R_22*b_y
        by_s59 = R_23*b_z
        by_s65 = R_31*b_x
        by_s66 = R_32*b_y
        by_s67 = R_33*b_z
        d_x = -A_x + by_s49 + by_s50 + by_s51 + px
        d_x_errors = R_12*b_y_errors + R_13*b_z_errors + b_x_errors*by_s11 + s74
        d_y = -A_y + by_s57 + by_s58 + by_s59 + py
        d_y_errors = R_21*b_x_errors + R_23*b_z_errors + b_y_errors*by_s23 + s77
        d_z = by_s65 + by_s66 + by_s67 + pz - up
        d_z_errors = R_31*b_x_errors + R_32*b_y_errors + b_z_errors*by_s33 + s80
        s = leg + q
        s_errors = dl + q*scale
        by_s99 = (1.0 / (by_s6 * by_s6))
        R_11_cx = -0.5*by_s10*by_s99*cx
        by_s101 = -by_s7*cy
        by_s102 = -0.5*by_s10*by_s99*cy
        R_11_cy = by_s101 + by_s102
        by_s104 = -by_s7*cz
        by_s105 = -0.5*by_s10*by_s99*cz
        R_11_cz = by_s104 + by_s105
        by_s107 = 0.5*by_s7*cy
        by_s108 = -0.5*by_s14*by_s99*cx
        R_12_cx = by_s107 + by_s108
        by_s110 = 0.5*by_s7*cx
        by_s111 = -0.5*by_s14*by_s99*cy
        R_12_cy = by_s110 + by_s111
        by_s113 = -0.5*by_s14*by_s99*cz
        R_12_cz = by_s113 - by_s7
        by_s115 = 0.5*by_s7*cz
        by_s116 = -0.5*by_s17*by_s99*cx
        R_13_cx = by_s115 + by_s116
        by_s118 = -0.5*by_s17*by_s99*cy
        R_13_cy = by_s118 + by_s7
        by_s120 = -0.5*by_s17*by_s99*cz
        R_13_cz = by_s110 + by_s120
        by_s122 = -0.5*by_s19*by_s99*cx
        R_21_cx = by_s107 + by_s122
        by_s124 = -0.5*by_s19*by_s99*cy
        R_21_cy = by_s110 + by_s124
        by_s126 = -0.5*by_s19*by_s99*cz
        R_21_cz = by_s126 + by_s7
        by_s128 = -by_s7*cx
        by_s129 = -0.5*by_s22*by_s99*cx
        R_22_cx = by_s128 + by_s129
        R_22_cy = -0.5*by_s22*by_s99*cy
        by_s132 = -0.5*by_s22*by_s99*cz
        R_22_cz = by_s104 + by_s132
        by_s134 = -0.5*by_s26*by_s99*cx
        R_23_cx = by_s134 - by_s7
        by_s136 = -0.5*by_s26*by_s99*cy
        R_23_cy = by_s115 + by_s136
        by_s138 = -0.5*by_s26*by_s99*cz
        R_23_cz = by_s107 + by_s138
        by_s140 = -0.5*by_s28*by_s99*cx
        R_31_cx = by_s115 + by_s140
        by_s142 = -0.5*by_s28*by_s99*cy
        R_31_cy = by_s142 - by_s7
        by_s144 = -0.5*by_s28*by_s99*cz
        R_31_cz = by_s110 + by_s144
        by_s146 = -0.5*by_s30*by_s99*cx
        R_32_cx = by_s146 + by_s7
        by_s148 = -0.5*by_s30*by_s99*cy
        R_32_cy = by_s115 + by_s148
        by_s150 = -0.5*by_s30*by_s99*cz
        R_32_cz = by_s107 + by_s150
        by_s152 = -0.5*by_s32*by_s99*cx
        R_33_cx = by_s128 + by_s152
        by_s154 = -0.5*by_s32*by_s99*cy
        R_33_cy = by_s101 + by_s154
        R_33_cz = -0.5*by_s32*by_s99*cz
        by_s157 = R_11_cx*b_x
        by_s158 = R_12_cx*b_y
        by_s159 = R_13_cx*b_z
        B_x_cx = by_s157 + by_s158 + by_s159
        by_s161 = R_11_cy*b_x
        by_s162 = R_12_cy*b_y
        by_s163 = R_13_cy*b_z
        B_x_cy = by_s161 + by_s162 + by_s163
        by_s165 = R_11_cz*b_x
        by_s166 = R_12_cz*b_y
        by_s167 = R_13_cz*b_z
        B_x_cz = by_s165 + by_s166 + by_s167
        by_s169 = R_21_cx*b_x
        by_s170 = R_22_cx*b_y
        by_s171 = R_23_cx*b_z
        B_y_cx = by_s169 + by_s170 + by_s171
        by_s173 = R_21_cy*b_x
        by_s174 = R_22_cy*b_y
        by_s175 = R_23_cy*b_z
        B_y_cy = by_s173 + by_s174 + by_s175
        by_s177 = R_21_cz*b_x
        by_s178 = R_22_cz*b_y
        by_s179 = R_23_cz*b_z
        B_y_cz = by_s177 + by_s178 + by_s179
        by_s181 = R_31_cx*b_x
        by_s182 = R_32_cx*b_y
        by_s183 = R_33_cx*b_z
        B_z_cx = by_s181 + by_s182 + by_s183
        by_s185 = R_31_cy*b_x
        by_s186 = R_32_cy*b_y
        by_s187 = R_33_cy*b_z
        B_z_cy = by_s185 + by_s186 + by_s187
        by_s189 = R_31_cz*b_x
        by_s190 = R_32_cz*b_y
        by_s191 = R_33_cz*b_z
        B_z_cz = by_s189 + by_s190 + by_s191
        s226 = d_x*d_x_errors + d_y*d_y_errors + d_z*d_z_errors - s*s_errors
        s232 = -1.0e-12*((B_x_cx*d_x + B_y_cx*d_y + B_z_cx*d_z) * (B_x_cx*d_x + B_y_cx*d_y + B_z_cx*d_z))
        s238 = -1.0e-12*((B_x_cy*d_x + B_y_cy*d_y + B_z_cy*d_z) * (B_x_cy*d_x + B_y_cy*d_y + B_z_cy*d_z))
        s244 = -1.0e-12*((B_x_cz*d_x + B_y_cz*d_y + B_z_cz*d_z) * (B_x_cz*d_x + B_y_cz*d_y + B_z_cz*d_z))
        s251 = -1.0e-12*(d_z * d_z)
        s252 = -1.0e-12*(d_x * d_x) - 1.0e-12*(d_y * d_y) + (s * s) + s232 + s238 + s244 + s251
        w[64 + lane] = s226
        w[72 + lane] = -s
        w[80 + lane] = s252


@few
def _linear_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (6 operations)."""
    F00 = w[64]
    Q00 = w[72]
    F10 = w[65]
    Q10 = w[73]
    F20 = w[66]
    Q20 = w[74]
    F30 = w[67]
    Q30 = w[75]
    F40 = w[68]
    Q40 = w[76]
    F50 = w[69]
    Q50 = w[77]
    s1 = F00/Q00
    s3 = F10/Q10
    s5 = F20/Q20
    s7 = F30/Q30
    s9 = F40/Q40
    s11 = F50/Q50
    w[32] = s1
    w[33] = s3
    w[34] = s5
    w[35] = s7
    w[36] = s9
    w[37] = s11


@fast
def _linear(px, py, pz, cx, cy, cz, w):
    w[0] = px
    w[1] = py
    w[2] = pz
    w[3] = cx
    w[4] = cy
    w[5] = cz
    _linear_joint(w, LANES)
    _linear_rows(w, LANES)
    _linear_solution(w)
    status = (SOLVED if (w[80] > 0.0) & (w[81] > 0.0) & (w[82] > 0.0) & (w[83] > 0.0) & (w[84] > 0.0) & (w[85] > 0.0) else SINGULAR) if (abs(w[40]) < math.inf) & (abs(w[41]) < math.inf) & (abs(w[42]) < math.inf) & (abs(w[43]) < math.inf) & (abs(w[44]) < math.inf) & (abs(w[45]) < math.inf) else UNREACHABLE
    w[40] = w[40] - w[32] if status == SOLVED else np.nan
    w[41] = w[41] - w[33] if status == SOLVED else np.nan
    w[42] = w[42] - w[34] if status == SOLVED else np.nan
    w[43] = w[43] - w[35] if status == SOLVED else np.nan
    w[44] = w[44] - w[36] if status == SOLVED else np.nan
    w[45] = w[45] - w[37] if status == SOLVED else np.nan
    return status


@fast
def linear_command(px, py, pz, cx, cy, cz, w):
    """Return the joints that bring the reference point to a target to first order in the errors, like `exact_command`.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. w from `linear_state`.
    """
    _linear(px, py, pz, cx, cy, cz, w)
    return w[24] * w[40], w[25] * w[41], w[26] * w[42], w[27] * w[43], w[28] * w[44], w[29] * w[45]


@fast
def linear_change(px, py, pz, cx, cy, cz, q_1, q_2, q_3, q_4, q_5, q_6, w):
    """Return what to add to the nominal joints of a target, both as the controller counts them; NaN where it is singular.

    For a controller that has nominal joints already: what `linear_command` adds to them.
    """
    w[0] = px
    w[1] = py
    w[2] = pz
    w[3] = cx
    w[4] = cy
    w[5] = cz
    w[40] = w[24] * q_1
    w[41] = w[25] * q_2
    w[42] = w[26] * q_3
    w[43] = w[27] * q_4
    w[44] = w[28] * q_5
    w[45] = w[29] * q_6
    w[46] = w[29] * q_6
    w[47] = w[29] * q_6
    _linear_rows(w, LANES)
    _linear_solution(w)
    back = -1.0 if (w[80] > 0.0) & (w[81] > 0.0) & (w[82] > 0.0) & (w[83] > 0.0) & (w[84] > 0.0) & (w[85] > 0.0) else np.nan
    return back * w[24] * w[32], back * w[25] * w[33], back * w[26] * w[34], back * w[27] * w[35], back * w[28] * w[36], back * w[29] * w[37]


@kernel(nogil=True, **OPTIONS)
def linear_commands(target, tool, w, q, status):
    """Fill q (N, 6), as the geometry counts, and status (N,) by `linear_command`; target (N, 6), tool (N or 1, 3)."""
    for n in range(target.shape[0]):
        if n == 0 or tool.shape[0] > 1:
            for c in range(3):
                w[20 + c] = tool[n, c]
        status[n] = _linear(target[n, 0], target[n, 1], target[n, 2], target[n, 3], target[n, 4], target[n, 5], w)
        for i in range(6):
            q[n, i] = w[40 + i]
