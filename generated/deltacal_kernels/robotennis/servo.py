"""Commands of one pose for a servo loop: `robotennis`, RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both 12ea42bd11a66f2c; SymPy 1.14.0.

Numbers in, numbers out, for loops that Numba compiles and for calls from Python: an array, or a part of one, costs more
than a command. Lengths in mm, angles in rad. Target, machine and scratch stand in one flat array w, which `exact_state`
and `linear_state` make, `copied` for every thread: loops over `lane` run over the limbs, the last of them again so that
they are 4.
"""

import math
from functools import partial

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import aligned, arcsine, arctangent, copied, cosine, sine, tangent
from deltacal_kernels.straight import straight

from .vectorised import MAX_STEPS, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_CONSTANTS = 22  # what is exported reads these first columns of `vectorised.constants` only
LANES = np.int64(4)  # no literal: a loop whose end is known beforehand is unrolled, and not turned into SIMD code
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
fast = kernel(**OPTIONS)  # to let other threads run meanwhile would take longer than a command
few = partial(straight, wide=False)  # lanes: the limbs


def _exact_constants(p):
    """Return k (M, 3, 22), what no target changes, from p (45 operations).

    p is that of the calibrated machine.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((22, p.shape[1], 3))
    a = p[0]
    b = p[1]
    h = p[2]
    H = p[3]
    phi = p[4]
    da = p[8]
    db = p[9]
    dh = p[10]
    theta0 = p[11]
    dphi = p[12]
    dH = p[13]
    px0 = p[14]
    py0 = p[15]
    pz0 = p[16]
    tip_v = p[17]
    tip_w = p[18]
    s0 = dphi + phi
    u_x = np.cos(s0)
    u_y = np.sin(s0)
    s3 = H + dH
    A_x = s3*u_x
    A_y = s3*u_y
    s11 = a + da
    s14 = -tip_v*u_x
    s16 = A_x + tip_w*u_y
    s20 = -tip_v*u_y
    s22 = A_y - tip_w*u_x
    s30 = dh + h
    s31 = s30*u_x
    s33 = s30*u_y
    s38 = -A_x + px0 + s31
    s40 = -s11*u_x
    s42 = -A_y + py0 + s33
    s44 = -s11*u_y
    s56 = -0.5*((b + db) * (b + db))
    s62 = 0.5*(s11 * s11)*((u_x * u_x) + (u_y * u_y)) + s56
    s67 = -2*a - 2*da
    s69 = 0.25*(s67 * s67)
    s74 = -0.5*s67
    k[0] = pz0
    k[1] = s38
    k[2] = s40
    k[3] = s42
    k[4] = s44
    k[5] = s62
    k[6] = s69
    k[7] = s74
    k[8] = theta0
    k[9] = u_x
    k[10] = u_y
    k[11] = s11
    k[12] = s14
    k[13] = s16
    k[14] = s20
    k[15] = s22
    k[16] = tip_v
    k[17] = px0
    k[18] = py0
    k[19] = s31
    k[20] = s33
    k[21] = s56
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _linear_constants(p):
    """Return k (M, 3, 19), what no target changes, from p (71 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((19, p.shape[1], 3))
    a = p[0]
    b = p[1]
    h = p[2]
    H = p[3]
    phi = p[4]
    da = p[8]
    db = p[9]
    dh = p[10]
    theta0 = p[11]
    dphi = p[12]
    dH = p[13]
    px0 = p[14]
    py0 = p[15]
    pz0 = p[16]
    tip_v = p[17]
    tip_w = p[18]
    u_x = np.cos(phi)
    by_s1 = np.sin(phi)
    u_x_errors = -by_s1*dphi
    u_y = np.sin(phi)
    u_y_errors = dphi*u_x
    A_x = H*u_x
    by_s6 = H*u_x_errors
    by_s7 = dH*u_x
    A_x_errors = by_s6 + by_s7
    A_y = H*u_y
    by_s10 = H*u_y_errors
    by_s11 = dH*u_y
    A_y_errors = by_s10 + by_s11
    by_s16 = -theta0*u_x
    by_s22 = -theta0*u_y
    s26 = a*u_x
    by_s31 = tip_w*u_y
    by_s32 = -tip_v*u_x
    by_s34 = A_x_errors + by_s31
    s35 = a*u_x_errors + da*u_x
    s38 = a*by_s16 + by_s32
    s41 = a*u_y
    by_s41 = -tip_w*u_x
    by_s42 = -tip_v*u_y
    by_s44 = A_y_errors + by_s41
    s50 = a*u_y_errors + da*u_y
    s53 = a*by_s22 + by_s42
    s59 = a*theta0 + tip_v
    by_s55 = h*u_x
    by_s57 = dh*u_x
    by_s58 = h*u_x_errors
    C_x_errors = by_s57 + by_s58 + px0
    by_s60 = h*u_y
    by_s62 = dh*u_y
    by_s63 = h*u_y_errors
    C_y_errors = by_s62 + by_s63 + py0
    s76 = -A_x + by_s55
    s78 = C_x_errors - by_s34
    s80 = -A_y + by_s60
    s82 = C_y_errors - by_s44
    s90 = -H*by_s1 + by_s1*h
    s92 = -a*by_s1
    s104 = (a * a)
    s109 = -0.5*(b * b) + 0.5*s104*((by_s1 * by_s1) + (u_x * u_x))
    s133 = -b*db
    k[0] = s76
    k[1] = s26
    k[2] = s90
    k[3] = s92
    k[4] = s109
    k[5] = s104
    k[6] = a
    k[7] = s35
    k[8] = s38
    k[9] = s41
    k[10] = s50
    k[11] = s53
    k[12] = s59
    k[13] = da
    k[14] = s78
    k[15] = s80
    k[16] = s82
    k[17] = pz0
    k[18] = s133
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def linear_constants(p):
    """Return k (M, 3, 28), what `linear` reads that no pose changes, from p (55 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((28, p.shape[1], 3))
    a = p[0]
    b = p[1]
    h = p[2]
    H = p[3]
    phi = p[4]
    da = p[8]
    db = p[9]
    dh = p[10]
    theta0 = p[11]
    dphi = p[12]
    dH = p[13]
    px0 = p[14]
    py0 = p[15]
    pz0 = p[16]
    tip_v = p[17]
    tip_w = p[18]
    u_x = np.cos(phi)
    s1 = np.sin(phi)
    u_x_errors = -dphi*s1
    u_y = np.sin(phi)
    u_y_errors = dphi*u_x
    A_x = H*u_x
    A_x_errors = H*u_x_errors + dH*u_x
    A_y = H*u_y
    A_y_errors = H*u_y_errors + dH*u_y
    s18 = -theta0*u_x
    s24 = -theta0*u_y
    s36 = -tip_v*u_x
    s38 = A_x_errors + tip_w*u_y
    s46 = -tip_v*u_y
    s48 = A_y_errors - tip_w*u_x
    s59 = h*u_x
    C_x_errors = dh*u_x + h*u_x_errors + px0
    s64 = h*u_y
    C_y_errors = dh*u_y + h*u_y_errors + py0
    s75 = -A_x + s59
    s77 = -a*u_x
    s81 = -H*s1 + h*s1
    s83 = -a*s1
    s95 = (a * a)
    s100 = -0.5*(b * b) + 0.5*s95*((s1 * s1) + (u_x * u_x))
    s116 = -b*db
    k[0] = s75
    k[1] = s77
    k[2] = s81
    k[3] = s83
    k[4] = s100
    k[5] = s95
    k[6] = a
    k[7] = u_x
    k[8] = u_x_errors
    k[9] = s18
    k[10] = u_y
    k[11] = u_y_errors
    k[12] = s24
    k[13] = theta0
    k[14] = A_x
    k[15] = da
    k[16] = s36
    k[17] = s38
    k[18] = A_y
    k[19] = s46
    k[20] = s48
    k[21] = tip_v
    k[22] = s59
    k[23] = s64
    k[24] = C_x_errors
    k[25] = C_y_errors
    k[26] = pz0
    k[27] = s116
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def exact_state(p, tool, sign):
    """Return the array w of `exact_command` for a machine: p (3, 19), tool (3,), sign (3,) of the controller's joints."""
    w = aligned(140)
    w[16:19], w[20:23] = tool, sign
    k = _exact_constants(p[None])[0]
    w[52:140].reshape(-1, 4)[:] = np.pad(k, ((0, 1), (0, 0)), mode="edge").T
    return w


def linear_state(p, tool, sign):
    """Return the array w of `linear_command` for a machine: p (3, 19), tool (3,), sign (3,) of the controller's joints."""
    w = aligned(128)
    w[16:19], w[20:23] = tool, sign
    k = _linear_constants(p[None])[0]
    w[52:128].reshape(-1, 4)[:] = np.pad(k, ((0, 1), (0, 0)), mode="edge").T
    return w


@few
def _exact_joint(w, lanes):
    """Joint of the simplified limb at the target, then the platform's coordinates that follow from it (35 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[16]
    ty = w[17]
    tz = w[18]
    for lane in range(lanes):
        pz0 = w[52 + lane]
        s38 = w[56 + lane]
        s40 = w[60 + lane]
        s42 = w[64 + lane]
        s44 = w[68 + lane]
        s62 = w[72 + lane]
        s69 = w[76 + lane]
        s74 = w[80 + lane]
        theta0 = w[84 + lane]
        centre_z = pz + pz0 - tz
        s39 = px + s38 - tx
        s43 = py + s42 - ty
        s46 = s39*s40 + s43*s44
        s48 = (centre_z * centre_z)
        s63 = 0.5*(s39 * s39) + 0.5*(s43 * s43) + 0.5*s48 + s62
        s72 = math.sqrt((s46 * s46) + s48*s69 - (s63 * s63))
        s81 = -theta0 + arctangent(centre_z*s63*s74 + s46*s72, centre_z*s72*s74 - s46*s63)
        w[28 + lane] = s81


@few
def _exact_rows(w, lanes):
    """Equations of a limb, their derivatives by turns of the platform and by the joint (59 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[16]
    ty = w[17]
    tz = w[18]
    for lane in range(lanes):
        pz0 = w[52 + lane]
        s40 = w[60 + lane]
        s44 = w[68 + lane]
        theta0 = w[84 + lane]
        u_x = w[88 + lane]
        u_y = w[92 + lane]
        s11 = w[96 + lane]
        s14 = w[100 + lane]
        s16 = w[104 + lane]
        s20 = w[108 + lane]
        s22 = w[112 + lane]
        tip_v = w[116 + lane]
        px0 = w[120 + lane]
        py0 = w[124 + lane]
        s31 = w[128 + lane]
        s33 = w[132 + lane]
        s56 = w[136 + lane]
        q = w[28 + lane]
        s6 = q + theta0
        s7 = cosine(s6)
        arm_x = s7*u_x
        arm_y = s7*u_y
        arm_z = sine(s6)
        B_x = arm_x*s11 + arm_z*s14 + s16
        B_y = arm_y*s11 + arm_z*s20 + s22
        B_z = arm_z*s11 + s7*tip_v
        centre_x = px + px0 - tx
        centre_y = py + py0 - ty
        centre_z = pz + pz0 - tz
        C_x = centre_x + s31
        C_y = centre_y + s33
        rod_x = -B_x + C_x
        rod_y = -B_y + C_y
        rod_z = -B_z + centre_z
        s82 = (rod_x * rod_x)
        s84 = (rod_y * rod_y)
        s86 = (rod_z * rod_z)
        s88 = s56 + 0.5*s82 + 0.5*s84 + 0.5*s86
        s100 = rod_z*(arm_z*tip_v - s11*s7)
        s101 = rod_x*(-arm_z*s40 - s14*s7) + rod_y*(-arm_z*s44 - s20*s7) + s100
        s106 = (s101 * s101) - 1.0e-12*s82 - 1.0e-12*s84 - 1.0e-12*s86
        w[40 + lane] = s88
        w[44 + lane] = s101
        w[48 + lane] = s106


@few
def _exact_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (3 operations)."""
    F00 = w[40]
    Q00 = w[44]
    F10 = w[41]
    Q10 = w[45]
    F20 = w[42]
    Q20 = w[46]
    s1 = F00/Q00
    s3 = F10/Q10
    s5 = F20/Q20
    w[24] = s1
    w[25] = s3
    w[26] = s5


@few
def _exact_move(w):
    """The platform after a step, and its rotation matrix (0 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    w[0] = px
    w[1] = py
    w[2] = pz


@fast
def _exact(px, py, pz, w):
    w[0] = px
    w[1] = py
    w[2] = pz
    _exact_joint(w, LANES)
    status = UNREACHABLE
    if (abs(w[28]) < math.inf) & (abs(w[29]) < math.inf) & (abs(w[30]) < math.inf):
        _exact_move(w)
        for _ in range(MAX_STEPS):
            _exact_rows(w, LANES)
            _exact_solution(w)
            if not ((w[48] > 0.0) & (w[49] > 0.0) & (w[50] > 0.0)):
                status = SINGULAR
                break
            size = 0.0
            for j in range(3):
                size = max(size, abs(w[24 + j]))
            for i in range(3):
                w[28 + i] -= w[24 + i]
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
            _exact_move(w)
    if status != SOLVED:
        for i in range(3):
            w[28 + i] = np.nan
    return status


@fast
def exact_command(px, py, pz, w):
    """Return the joints that bring the reference point to a target, as the controller counts them; NaN where there are none.

    `inverse` for one pose, w from `exact_state`.
    """
    _exact(px, py, pz, w)
    return w[20] * w[28], w[21] * w[29], w[22] * w[30]


@few
def _linear_joint(w, lanes):
    """Joint of the nominal limb at the target, its cosine and sine (41 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[16]
    ty = w[17]
    tz = w[18]
    for lane in range(lanes):
        s76 = w[52 + lane]
        s26 = w[56 + lane]
        s90 = w[60 + lane]
        s92 = w[64 + lane]
        s109 = w[68 + lane]
        s104 = w[72 + lane]
        a = w[76 + lane]
        centre_z = pz - tz
        s86 = px + s76 - tx
        s91 = py + s90 - ty
        s94 = -s26*s86 + s91*s92
        s96 = (centre_z * centre_z)
        s110 = s109 + 0.5*(s86 * s86) + 0.5*(s91 * s91) + 0.5*s96
        s114 = math.sqrt(s104*s96 - (s110 * s110) + (s94 * s94))
        s117 = a*centre_z*s110 + s114*s94
        s120 = a*centre_z*s114 - s110*s94
        s121 = arctangent(s117, s120)
        s125 = 1/math.sqrt((s117 * s117) + (s120 * s120))
        s126 = s120*s125
        s127 = s117*s125
        w[28 + lane] = s121
        w[32 + lane] = s126
        w[36 + lane] = s127


@few
def _linear_angle(w, lanes):
    """Cosine and sine of the joint (2 operations)."""
    for lane in range(lanes):
        q = w[28 + lane]
        s128 = cosine(q)
        s129 = sine(q)
        w[32 + lane] = s128
        w[36 + lane] = s129


@few
def _linear_rows(w, lanes):
    """Equations of a nominal limb: change by all errors, derivatives by rotation and joint (50 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[16]
    ty = w[17]
    tz = w[18]
    for lane in range(lanes):
        s76 = w[52 + lane]
        s26 = w[56 + lane]
        a = w[76 + lane]
        s35 = w[80 + lane]
        s38 = w[84 + lane]
        s41 = w[88 + lane]
        s50 = w[92 + lane]
        s53 = w[96 + lane]
        s59 = w[100 + lane]
        da = w[104 + lane]
        s78 = w[108 + lane]
        s80 = w[112 + lane]
        s82 = w[116 + lane]
        pz0 = w[120 + lane]
        s133 = w[124 + lane]
        cos_q = w[32 + lane]
        sin_q = w[36 + lane]
        B_x_q = -s26*sin_q
        B_y_q = -s41*sin_q
        B_z = a*sin_q
        B_z_q = a*cos_q
        rod_x = -cos_q*s26 + px + s76 - tx
        rod_x_errors = -cos_q*s35 - s38*sin_q + s78
        rod_y = -cos_q*s41 + py + s80 - ty
        rod_y_errors = -cos_q*s50 - s53*sin_q + s82
        rod_z = -B_z + pz - tz
        rod_z_errors = -cos_q*s59 - da*sin_q + pz0
        s134 = rod_x*rod_x_errors + rod_y*rod_y_errors + rod_z*rod_z_errors + s133
        s138 = -B_x_q*rod_x - B_y_q*rod_y - B_z_q*rod_z
        s146 = -1.0e-12*(rod_x * rod_x) - 1.0e-12*(rod_y * rod_y) - 1.0e-12*(rod_z * rod_z) + (s138 * s138)
        w[40 + lane] = s134
        w[44 + lane] = s138
        w[48 + lane] = s146


@few
def _linear_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (3 operations)."""
    F00 = w[40]
    Q00 = w[44]
    F10 = w[41]
    Q10 = w[45]
    F20 = w[42]
    Q20 = w[46]
    s1 = F00/Q00
    s3 = F10/Q10
    s5 = F20/Q20
    w[24] = s1
    w[25] = s3
    w[26] = s5


@fast
def _linear(px, py, pz, w):
    w[0] = px
    w[1] = py
    w[2] = pz
    _linear_joint(w, LANES)
    _linear_rows(w, LANES)
    _linear_solution(w)
    status = (SOLVED if (w[48] > 0.0) & (w[49] > 0.0) & (w[50] > 0.0) else SINGULAR) if (abs(w[28]) < math.inf) & (abs(w[29]) < math.inf) & (abs(w[30]) < math.inf) else UNREACHABLE
    w[28] = w[28] - w[24] if status == SOLVED else np.nan
    w[29] = w[29] - w[25] if status == SOLVED else np.nan
    w[30] = w[30] - w[26] if status == SOLVED else np.nan
    return status


@fast
def linear_command(px, py, pz, w):
    """Return the joints that bring the reference point to a target to first order in the errors, like `exact_command`.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. w from `linear_state`.
    """
    _linear(px, py, pz, w)
    return w[20] * w[28], w[21] * w[29], w[22] * w[30]


@fast
def linear_change(px, py, pz, q_1, q_2, q_3, w):
    """Return what to add to the nominal joints of a target, both as the controller counts them; NaN where it is singular.

    For a controller that has nominal joints already: what `linear_command` adds to them.
    """
    w[0] = px
    w[1] = py
    w[2] = pz
    w[28] = w[20] * q_1
    w[29] = w[21] * q_2
    w[30] = w[22] * q_3
    w[31] = w[22] * q_3
    _linear_angle(w, LANES)
    _linear_rows(w, LANES)
    _linear_solution(w)
    back = -1.0 if (w[48] > 0.0) & (w[49] > 0.0) & (w[50] > 0.0) else np.nan
    return back * w[20] * w[24], back * w[21] * w[25], back * w[22] * w[26]


@kernel(nogil=True, **OPTIONS)
def linear_commands(target, tool, w, q, status):
    """Fill q (N, 3), as the geometry counts, and status (N,) by `linear_command`; target (N, 3), tool (N or 1, 3)."""
    for n in range(target.shape[0]):
        if n == 0 or tool.shape[0] > 1:
            for c in range(3):
                w[16 + c] = tool[n, c]
        status[n] = _linear(target[n, 0], target[n, 1], target[n, 2], w)
        for i in range(3):
            q[n, i] = w[28 + i]
