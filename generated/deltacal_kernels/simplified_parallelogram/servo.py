"""Commands of one pose for a servo loop: `simplified_parallelogram`, Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both e19b6ea674cef9ad; SymPy 1.14.0.

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
COMMAND_CONSTANTS = 6  # what is exported reads these first columns of `vectorised.constants` only
LANES = np.int64(1)  # no literal: a loop whose end is known beforehand is unrolled, and not turned into SIMD code
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
fast = kernel(**OPTIONS)  # to let other threads run meanwhile would take longer than a command
few = partial(straight, wide=False)  # lanes: the limbs


def _exact_constants(p):
    """Return k (M, 1, 6), what no target changes, from p (5 operations).

    p is that of the calibrated machine.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((6, p.shape[1], 1))
    a1x = p[0]
    b1x = p[3]
    l1 = p[6]
    h = p[8]
    q0 = p[9]
    dl1 = p[10]
    A_x = -a1x + b1x
    s1 = dl1 + l1
    s10 = (1.0 / s1)
    s15 = (1.0 / (s1 * s1))
    k[0] = A_x
    k[1] = s10
    k[2] = q0
    k[3] = s15
    k[4] = s1
    k[5] = h
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _linear_constants(p):
    """Return k (M, 1, 5), what no target changes, from p (3 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((5, p.shape[1], 1))
    a1x = p[0]
    b1x = p[3]
    l1 = p[6]
    q0 = p[9]
    dl1 = p[10]
    A_x = -a1x + b1x
    by_s6 = l1*q0
    s17 = (1.0 / l1)
    k[0] = A_x
    k[1] = s17
    k[2] = l1
    k[3] = by_s6
    k[4] = dl1
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def linear_constants(p):
    """Return k (M, 1, 5), what `linear` reads that no pose changes, from p (3 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((5, p.shape[1], 1))
    a1x = p[0]
    b1x = p[3]
    l1 = p[6]
    q0 = p[9]
    dl1 = p[10]
    A_x = -a1x + b1x
    s8 = l1*q0
    s19 = (1.0 / l1)
    k[0] = A_x
    k[1] = s19
    k[2] = l1
    k[3] = dl1
    k[4] = s8
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def exact_state(p, tool, sign):
    """Return the array w of `exact_command` for a machine: p (1, 11), tool (3,), sign (1,) of the controller's joints."""
    w = aligned(60)
    w[16:19], w[20:21] = tool, sign
    k = _exact_constants(p[None])[0]
    w[52:58].reshape(-1, 1)[:] = np.pad(k, ((0, 0), (0, 0)), mode="edge").T
    return w


def linear_state(p, tool, sign):
    """Return the array w of `linear_command` for a machine: p (1, 11), tool (3,), sign (1,) of the controller's joints."""
    w = aligned(60)
    w[16:19], w[20:21] = tool, sign
    k = _linear_constants(p[None])[0]
    w[52:57].reshape(-1, 1)[:] = np.pad(k, ((0, 0), (0, 0)), mode="edge").T
    return w


@few
def _exact_joint(w, lanes):
    """Joint of the simplified limb at the target, then the platform's coordinates that follow from it (13 operations)."""
    px = w[0]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        A_x = w[52 + lane]
        s10 = w[53 + lane]
        q0 = w[54 + lane]
        s15 = w[55 + lane]
        s1 = w[56 + lane]
        h = w[57 + lane]
        s11 = -A_x + px - tx
        s14 = -q0 + arcsine(s10*s11)
        s21 = -h - s1*math.sqrt(-(s11 * s11)*s15 + 1) + ty
        w[28 + lane] = s14
        w[29 + lane] = s21


@few
def _exact_rows(w, lanes):
    """Equations of a limb, their derivatives by turns of the platform and by the joint (16 operations)."""
    px = w[0]
    py = w[1]
    cz = w[2]
    tx = w[16]
    ty = w[17]
    for lane in range(lanes):
        A_x = w[52 + lane]
        q0 = w[54 + lane]
        s1 = w[56 + lane]
        h = w[57 + lane]
        q = w[28 + lane]
        s2 = q + q0
        r_x = s1*sine(s2)
        r_y = -s1*cosine(s2)
        B_x = A_x + r_x
        C_x = px - tx
        C_y = h + py - ty
        s22 = -B_x + C_x
        s23 = C_y - r_y
        s26 = 0.25*(cz * cz) + 1
        w[36 + lane] = s22
        w[39 + lane] = r_y
        w[40 + lane] = s23
        w[41 + lane] = 1
        w[43 + lane] = -r_x
        w[44 + lane] = cz
        w[46 + lane] = s26


@few
def _exact_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (25 operations)."""
    F00 = w[36]
    Q00 = w[39]
    F01 = w[40]
    J01_1 = w[41]
    Q01 = w[43]
    F02 = w[44]
    J02_2 = w[46]
    A_cof_00 = J01_1*J02_2
    A_cof_01 = -J02_2*Q01
    A_cof_11 = J02_2*Q00
    A_cof_22 = J01_1*Q00
    A_det_00 = A_cof_00*Q00
    A_by_00 = (1.0 / A_det_00)
    s7 = A_by_00*A_cof_00*F00
    s11 = A_by_00*(A_cof_01*F00 + A_cof_11*F01)
    s13 = A_by_00*A_cof_22*F02
    s21 = (A_det_00 * A_det_00) - 1.0e-12*(J02_2 * J02_2)*(Q00 * Q00)*((J01_1 * J01_1) + (Q01 * Q01))
    w[24] = s7
    w[25] = s11
    w[26] = s13
    w[27] = s21


@few
def _exact_move(w):
    """The platform after a step, and its rotation matrix (6 operations)."""
    px = w[0]
    py = w[1]
    cz = w[2]
    y1 = w[25]
    y2 = w[26]
    new_10 = py - y1
    new_20 = cz - y2*(0.25*(cz * cz) + 1)
    w[0] = px
    w[1] = new_10
    w[2] = new_20


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
        A_x = w[52 + lane]
        s17 = w[53 + lane]
        s20 = arcsine(s17*(-A_x + px - tx))
        w[28 + lane] = s20


@few
def _linear_angle(w, lanes):
    """Cosine and sine of the joint (2 operations)."""
    for lane in range(lanes):
        q = w[28 + lane]
        s21 = cosine(q)
        s22 = sine(q)
        w[32 + lane] = s21
        w[33 + lane] = s22


@few
def _linear_rows(w, lanes):
    """Equations of a nominal limb: change by all errors, derivatives by rotation and joint (12 operations)."""
    for lane in range(lanes):
        l1 = w[54 + lane]
        by_s6 = w[55 + lane]
        dl1 = w[56 + lane]
        cos_q = w[32 + lane]
        sin_q = w[33 + lane]
        r_x_q = cos_q*l1
        r_x_errors = by_s6*cos_q + dl1*sin_q
        r_y_q = l1*sin_q
        r_y_errors = by_s6*sin_q - cos_q*dl1
        w[36 + lane] = -r_x_errors
        w[39 + lane] = -r_x_q
        w[40 + lane] = -r_y_errors
        w[41 + lane] = 1
        w[43 + lane] = -r_y_q
        w[46 + lane] = 1


@few
def _linear_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (15 operations)."""
    F00 = w[36]
    Q00 = w[39]
    J01_1 = w[41]
    Q01 = w[43]
    J02_2 = w[46]
    A_cof_00 = J01_1*J02_2
    A_det_00 = A_cof_00*Q00
    A_by_00 = (1.0 / A_det_00)
    s7 = A_by_00*A_cof_00*F00
    s15 = (A_det_00 * A_det_00) - 1.0e-12*(J02_2 * J02_2)*(Q00 * Q00)*((J01_1 * J01_1) + (Q01 * Q01))
    w[24] = s7
    w[27] = s15


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
