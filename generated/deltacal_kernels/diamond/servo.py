"""Commands of one pose for a servo loop: `diamond`, Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both af16dbee4a9d1d73; SymPy 1.14.0.

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
COMMAND_CONSTANTS = 9  # what is exported reads these first columns of `vectorised.constants` only
LANES = np.int64(2)  # no literal: a loop whose end is known beforehand is unrolled, and not turned into SIMD code
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
fast = kernel(**OPTIONS)  # to let other threads run meanwhile would take longer than a command
few = partial(straight, wide=False)  # lanes: the limbs


def _exact_constants(p):
    """Return k (M, 2, 9), what no target changes, from p (22 operations).

    p is that of the calibrated machine.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((9, p.shape[1], 2))
    base_x = p[0]
    base_y = p[1]
    L = p[2]
    l = p[3]
    side = p[4]
    theta = p[5]
    ex = p[6]
    ey = p[7]
    dL = p[8]
    dl = p[9]
    tip_v = p[12]
    B_x = base_x*side + ex
    B_y = base_y + ey
    s3 = L + dL
    s6 = theta - 0.5*np.pi*(1 - side)
    s9 = s3*side
    s12 = -side*tip_v
    s30 = -0.5*((dl + l) * (dl + l))
    s31 = (side * side)
    s32 = (s3 * s3)
    s34 = s30 + 0.5*s31*s32
    s38 = s31*s32
    s43 = s3*s31
    k[0] = B_y
    k[1] = B_x
    k[2] = s34
    k[3] = s9
    k[4] = s38
    k[5] = s43
    k[6] = s6
    k[7] = s12
    k[8] = s30
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _linear_constants(p):
    """Return k (M, 2, 12), what no target changes, from p (24 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((12, p.shape[1], 2))
    base_x = p[0]
    base_y = p[1]
    L = p[2]
    l = p[3]
    side = p[4]
    theta = p[5]
    ex = p[6]
    ey = p[7]
    dL = p[8]
    dl = p[9]
    tip_v = p[12]
    B_x = base_x*side
    by_s1 = 1 - side
    by_s2 = -0.5*np.pi*by_s1
    by_s5 = L*side
    by_s10 = dL*side
    by_s12 = -side*tip_v
    by_s14 = -L*side*theta
    s14 = by_s12 + by_s14
    s34 = (L * L)
    s35 = (side * side)
    s37 = -0.5*(l * l) + 0.5*s34*s35
    s41 = s34*s35
    s46 = L*s35
    s58 = -dl*l
    k[0] = base_y
    k[1] = B_x
    k[2] = s37
    k[3] = by_s5
    k[4] = s41
    k[5] = s46
    k[6] = by_s2
    k[7] = by_s10
    k[8] = s14
    k[9] = ex
    k[10] = ey
    k[11] = s58
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def linear_constants(p):
    """Return k (M, 2, 13), what `linear` reads that no pose changes, from p (23 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((13, p.shape[1], 2))
    base_x = p[0]
    base_y = p[1]
    L = p[2]
    l = p[3]
    side = p[4]
    theta = p[5]
    ex = p[6]
    ey = p[7]
    dL = p[8]
    dl = p[9]
    tip_v = p[12]
    B_x = base_x*side
    s2 = -0.5*np.pi*(1 - side)
    s5 = L*side
    s10 = dL*side
    s12 = -side*tip_v
    s14 = -L*side*theta
    s35 = (L * L)
    s36 = (side * side)
    s38 = -0.5*(l * l) + 0.5*s35*s36
    s42 = s35*s36
    s47 = L*s36
    s57 = -dl*l
    k[0] = base_y
    k[1] = B_x
    k[2] = s38
    k[3] = s5
    k[4] = s42
    k[5] = s47
    k[6] = s2
    k[7] = s10
    k[8] = s12
    k[9] = s14
    k[10] = ex
    k[11] = ey
    k[12] = s57
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def exact_state(p, tool, sign):
    """Return the array w of `exact_command` for a machine: p (2, 13), tool (3,), sign (2,) of the controller's joints."""
    w = aligned(64)
    w[16:19], w[20:22] = tool, sign
    k = _exact_constants(p[None])[0]
    w[44:62].reshape(-1, 2)[:] = np.pad(k, ((0, 0), (0, 0)), mode="edge").T
    return w


def linear_state(p, tool, sign):
    """Return the array w of `linear_command` for a machine: p (2, 13), tool (3,), sign (2,) of the controller's joints."""
    w = aligned(68)
    w[16:19], w[20:22] = tool, sign
    k = _linear_constants(p[None])[0]
    w[44:68].reshape(-1, 2)[:] = np.pad(k, ((0, 0), (0, 0)), mode="edge").T
    return w


@few
def _exact_joint(w, lanes):
    """Joint of the simplified limb at the target, then the platform's coordinates that follow from it (29 operations)."""
    px = w[0]
    py = w[1]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        B_y = w[44 + lane]
        B_x = w[46 + lane]
        s34 = w[48 + lane]
        s9 = w[50 + lane]
        s38 = w[52 + lane]
        s43 = w[54 + lane]
        s6 = w[56 + lane]
        s22 = -B_y + py - ty
        s23 = -B_x + px - tx
        s24 = (s23 * s23)
        s26 = (s22 * s22)
        s35 = 0.5*s24 + 0.5*s26 + s34
        s42 = math.sqrt(s24*s38 + s26*s38 - (s35 * s35))
        s50 = -s6 + arctangent(s22*s35*s9 + s23*s42*s43, -s22*s42*s43 + s23*s35*s9)
        w[28 + lane] = s50


@few
def _exact_rows(w, lanes):
    """Equations of a limb, their derivatives by turns of the platform and by the joint (33 operations)."""
    px = w[0]
    py = w[1]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        B_y = w[44 + lane]
        B_x = w[46 + lane]
        s9 = w[50 + lane]
        s6 = w[56 + lane]
        s12 = w[58 + lane]
        s30 = w[60 + lane]
        q = w[28 + lane]
        s7 = q + s6
        s8 = cosine(s7)
        s10 = s8*s9
        s11 = sine(s7)
        s13 = s11*s12
        C_x = B_x + s10 + s13
        s15 = -s12*s8
        s16 = s11*s9
        C_y = B_y + s15 + s16
        A_x = px - tx
        A_y = py - ty
        d_x = A_x - C_x
        d_y = A_y - C_y
        s51 = (d_x * d_x)
        s53 = (d_y * d_y)
        s55 = s30 + 0.5*s51 + 0.5*s53
        s60 = d_x*(s15 + s16) + d_y*(-s10 - s13)
        s64 = -1.0e-12*s51 - 1.0e-12*s53 + (s60 * s60)
        w[36 + lane] = s55
        w[38 + lane] = s60
        w[40 + lane] = s64


@few
def _exact_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (2 operations)."""
    F00 = w[36]
    Q00 = w[38]
    F10 = w[37]
    Q10 = w[39]
    s1 = F00/Q00
    s3 = F10/Q10
    w[24] = s1
    w[25] = s3


@few
def _exact_move(w):
    """The platform after a step, and its rotation matrix (0 operations)."""
    px = w[0]
    py = w[1]
    w[0] = px
    w[1] = py


@fast
def _exact(px, py, w):
    w[0] = px
    w[1] = py
    _exact_joint(w, LANES)
    status = UNREACHABLE
    if (abs(w[28]) < math.inf) & (abs(w[29]) < math.inf):
        _exact_move(w)
        for _ in range(MAX_STEPS):
            _exact_rows(w, LANES)
            _exact_solution(w)
            if not ((w[40] > 0.0) & (w[41] > 0.0)):
                status = SINGULAR
                break
            size = 0.0
            for j in range(2):
                size = max(size, abs(w[24 + j]))
            for i in range(2):
                w[28 + i] -= w[24 + i]
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
            _exact_move(w)
    if status != SOLVED:
        for i in range(2):
            w[28 + i] = np.nan
    return status


@fast
def exact_command(px, py, w):
    """Return the joints that bring the reference point to a target, as the controller counts them; NaN where there are none.

    `inverse` for one pose, w from `exact_state`.
    """
    _exact(px, py, w)
    return w[20] * w[28], w[21] * w[29]


@few
def _linear_joint(w, lanes):
    """Joint of the nominal limb at the target, its cosine and sine (29 operations)."""
    px = w[0]
    py = w[1]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        base_y = w[44 + lane]
        B_x = w[46 + lane]
        s37 = w[48 + lane]
        by_s5 = w[50 + lane]
        s41 = w[52 + lane]
        s46 = w[54 + lane]
        by_s2 = w[56 + lane]
        s26 = -base_y + py - ty
        s27 = -B_x + px - tx
        s28 = (s27 * s27)
        s30 = (s26 * s26)
        s38 = 0.5*s28 + 0.5*s30 + s37
        s45 = math.sqrt(s28*s41 + s30*s41 - (s38 * s38))
        s53 = -by_s2 + arctangent(by_s5*s26*s38 + s27*s45*s46, by_s5*s27*s38 - s26*s45*s46)
        w[28 + lane] = s53


@few
def _linear_rows(w, lanes):
    """Equations of a nominal limb: change by all errors, derivatives by rotation and joint (36 operations)."""
    px = w[0]
    py = w[1]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        base_y = w[44 + lane]
        B_x = w[46 + lane]
        by_s5 = w[50 + lane]
        by_s2 = w[56 + lane]
        by_s10 = w[58 + lane]
        s14 = w[60 + lane]
        ex = w[62 + lane]
        ey = w[64 + lane]
        s58 = w[66 + lane]
        q = w[28 + lane]
        by_s3 = by_s2 + q
        by_s4 = cosine(by_s3)
        by_s8 = sine(by_s3)
        C_x_q = -by_s5*by_s8
        C_x_errors = by_s10*by_s4 + by_s8*s14 + ex
        C_y_q = by_s4*by_s5
        C_y_errors = by_s10*by_s8 - by_s4*s14 + ey
        d_x = -B_x - by_s4*by_s5 + px - tx
        d_y = C_x_q - base_y + py - ty
        s59 = -C_x_errors*d_x - C_y_errors*d_y + s58
        s62 = -C_x_q*d_x - C_y_q*d_y
        s68 = -1.0e-12*(d_x * d_x) - 1.0e-12*(d_y * d_y) + (s62 * s62)
        w[36 + lane] = s59
        w[38 + lane] = s62
        w[40 + lane] = s68


@few
def _linear_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (2 operations)."""
    F00 = w[36]
    Q00 = w[38]
    F10 = w[37]
    Q10 = w[39]
    s1 = F00/Q00
    s3 = F10/Q10
    w[24] = s1
    w[25] = s3


@fast
def _linear(px, py, w):
    w[0] = px
    w[1] = py
    _linear_joint(w, LANES)
    _linear_rows(w, LANES)
    _linear_solution(w)
    status = (SOLVED if (w[40] > 0.0) & (w[41] > 0.0) else SINGULAR) if (abs(w[28]) < math.inf) & (abs(w[29]) < math.inf) else UNREACHABLE
    w[28] = w[28] - w[24] if status == SOLVED else np.nan
    w[29] = w[29] - w[25] if status == SOLVED else np.nan
    return status


@fast
def linear_command(px, py, w):
    """Return the joints that bring the reference point to a target to first order in the errors, like `exact_command`.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. w from `linear_state`.
    """
    _linear(px, py, w)
    return w[20] * w[28], w[21] * w[29]


@fast
def linear_change(px, py, q_1, q_2, w):
    """Return what to add to the nominal joints of a target, both as the controller counts them; NaN where it is singular.

    For a controller that has nominal joints already: what `linear_command` adds to them.
    """
    w[0] = px
    w[1] = py
    w[28] = w[20] * q_1
    w[29] = w[21] * q_2
    _linear_rows(w, LANES)
    _linear_solution(w)
    back = -1.0 if (w[40] > 0.0) & (w[41] > 0.0) else np.nan
    return back * w[20] * w[24], back * w[21] * w[25]


@kernel(nogil=True, **OPTIONS)
def linear_commands(target, tool, w, q, status):
    """Fill q (N, 2), as the geometry counts, and status (N,) by `linear_command`; target (N, 2), tool (N or 1, 3)."""
    for n in range(target.shape[0]):
        if n == 0 or tool.shape[0] > 1:
            for c in range(3):
                w[16 + c] = tool[n, c]
        status[n] = _linear(target[n, 0], target[n, 1], w)
        for i in range(2):
            q[n, i] = w[28 + i]
