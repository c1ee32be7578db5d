"""Commands of one pose for a servo loop: `simplified_parallelogram`, Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both 51599eef9519bb44; SymPy 1.14.0.

Scalar code without allocation, to be called from loops that Numba compiles. Lengths in mm, angles in rad.
"""

import math

import numpy as np

from deltacal_kernels.compiled import kernel

from .vectorised import MAX_STEPS, PIVOT_SINGULAR, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 27  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 6  # `exact_command` reads these first columns of k only


@kernel(nogil=True, error_model="numpy")
def _newton(x, q, tool, k, out):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint (13 operations)."""
    px = x[0]
    py = x[1]
    cz = x[2]
    tx = tool[0]
    ty = tool[1]
    q = q
    q0 = k[0]
    s0 = k[1]
    s4 = k[2]
    h = k[3]
    s1 = q + q0
    s3 = -s0*math.sin(s1)
    s5 = px + s3 + s4 - tx
    s7 = -s0*math.cos(s1)
    s8 = h + py - s7 - ty
    out[0] = s5
    out[1] = 1
    out[2] = 0
    out[3] = 0
    out[4] = s7
    out[5] = s8
    out[6] = 0
    out[7] = 1
    out[8] = 0
    out[9] = s3
    out[10] = cz
    out[11] = 0
    out[12] = 0
    out[13] = 1
    out[14] = 0


@kernel(nogil=True, error_model="numpy")
def _joint(x, q, tool, k, out):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (13 operations)."""
    px = x[0]
    tx = tool[0]
    ty = tool[1]
    q0 = k[0]
    s0 = k[1]
    s4 = k[2]
    h = k[3]
    s9 = k[4]
    s14 = k[5]
    s10 = px + s4 - tx
    s13 = -q0 + math.asin(s10*s9)
    s20 = -h - s0*math.sqrt(-(s10 * s10)*s14 + 1) + ty
    out[0] = s13
    out[1] = s20
    out[2] = 0


def linear_constants(p):
    """Return k (M, 1, 5), what `linear` reads that no pose changes, from p (4 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((5, p.shape[1], 1))
    a1x = p[0]
    b1x = p[3]
    l1 = p[6]
    q0 = p[9]
    dl1 = p[10]
    s3 = (1.0 / l1)
    s4 = a1x - b1x
    s10 = -l1*q0
    k[0] = s4
    k[1] = s3
    k[2] = l1
    k[3] = dl1
    k[4] = s10
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


@kernel(nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (4 operations); limb i of k, row i of out."""
    px = x[0]
    tx = tool[0]
    s4 = k[i, 0]
    s3 = k[i, 1]
    s7 = math.asin(s3*(px + s4 - tx))
    row = 1 * i
    out[row + 0] = s7


@kernel(nogil=True, error_model="numpy")
def _linear(x, q, tool, k, i, out):
    """Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (12 operations); limb i of k, row i of out."""
    l1 = k[i, 2]
    dl1 = k[i, 3]
    s10 = k[i, 4]
    s0 = math.cos(q)
    s1 = -l1*s0
    s8 = math.sin(q)
    s12 = -dl1*s8 + s0*s10
    s15 = dl1*s0 + s10*s8
    s16 = -l1*s8
    row = 15 * i
    out[row + 0] = s12
    out[row + 2] = 0
    out[row + 3] = 0
    out[row + 4] = s1
    out[row + 5] = s15
    out[row + 7] = 1
    out[row + 8] = 0
    out[row + 9] = s16
    out[row + 10] = 0
    out[row + 12] = 0
    out[row + 13] = 1
    out[row + 14] = 0


@kernel(nogil=True, error_model="numpy")
def _hold(work):
    """Solve for the changes of joints and rotation that undo the closures while the reference point stays in place.

    work: per rod closure, its derivatives by the platform and by the joint; then room for the reduced equations; then
    the changes. A limb's joint is eliminated with the rod that feels it most; what is left are 2 equations for the
    rotation. Returns False where a joint is felt by no rod of its limb, or the rotation is not held.
    """
    largest = 0.0
    for row in range(3):
        for c in range(2, 5):
            largest = max(largest, abs(work[5 * row + c]))
    smallest = PIVOT_SINGULAR * largest
    target = 15
    for i in range(1):
        best = 15 * i
        for j in range(1, 3):
            if abs(work[15 * i + 5 * j + 4]) > abs(work[best + 4]):
                best = 15 * i + 5 * j
        if not abs(work[best + 4]) > smallest:
            return False
        inverse = 1.0 / work[best + 4]
        for j in range(3):
            rod = 15 * i + 5 * j
            if rod != best:
                factor = work[rod + 4] * inverse
                for c in range(2):
                    work[target + c] = work[rod + 2 + c] - factor * work[best + 2 + c]
                work[target + 2] = work[rod] - factor * work[best]
                target += 3
        # the joint's own equation, left to the end: closure and rotation over the joint's derivative
        for c in range(2):
            work[15 * i + 2 + c] = work[best + 2 + c] * inverse
        work[21 + i] = work[best] * inverse
    for c in range(2):
        pivot = 15 + 3 * c
        for r in range(c + 1, 2):
            if abs(work[15 + 3 * r + c]) > abs(work[pivot + c]):
                pivot = 15 + 3 * r
        row = 15 + 3 * c
        if not abs(work[pivot + c]) > smallest:
            return False
        if pivot != row:
            for j in range(c, 3):
                work[row + j], work[pivot + j] = work[pivot + j], work[row + j]
        inverse = 1.0 / work[row + c]
        for r in range(c + 1, 2):
            below = 15 + 3 * r
            factor = work[below + c] * inverse
            for j in range(c + 1, 3):
                work[below + j] -= factor * work[row + j]
    for c in range(1, -1, -1):
        row = 15 + 3 * c
        total = work[row + 2]
        for j in range(c + 1, 2):
            total -= work[row + j] * work[22 + j]
        work[22 + c] = total / work[row + c]
    for i in range(1):
        for c in range(2):
            work[21 + i] -= work[15 * i + 2 + c] * work[22 + c]
    return True


@kernel(nogil=True, error_model="numpy")
def exact_command(target, tool, k, work, q):
    """Fill the joints q (1,) that bring the reference point to target (1,); return the status.

    `inverse` for one pose, to be called from a servo loop: tool (3,), k (1, :), scratch work (COMMAND_WORK,).
    q is NaN unless SOLVED.
    """
    pose = work[24:]
    for c in range(1):
        pose[c] = target[c]
    for c in range(2):
        pose[1 + c] = 0.0
    status = SOLVED
    for i in range(1):
        _joint(pose, 0.0, tool, k[i], work)
        q[i] = work[0]
        if not math.isfinite(q[i]):
            status = UNREACHABLE
    pose[1] = work[1]
    pose[2] = work[2]
    if status == SOLVED:
        status = UNREACHABLE
        for _ in range(MAX_STEPS):
            for i in range(1):
                _newton(pose, q[i], tool, k[i], work[15 * i : 15 * (i + 1)])
            if not _hold(work):
                status = SINGULAR
                break
            size = 0.0
            for i in range(1):
                q[i] -= work[21 + i]
                size = max(size, abs(work[21 + i]))
            for c in range(2):
                pose[1 + c] -= work[22 + c]
                size = max(size, abs(work[22 + c]))
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
    if status != SOLVED:
        for i in range(1):
            q[i] = np.nan
    return status


@kernel(nogil=True, error_model="numpy")
def linear_command(target, tool, k, work, q):
    """Fill the joints q (1,) that bring the reference point to target (1,) to first order in the errors; return the status.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. tool (3,), k (1, 5) from `linear_constants`, scratch work
    (COMMAND_WORK,). q is NaN unless SOLVED.
    """
    status = SOLVED
    for i in range(1):
        _nominal_joint(target, 0.0, tool, k, i, q)
        if not math.isfinite(q[i]):
            status = UNREACHABLE
    if status == SOLVED:
        for i in range(1):
            _linear(target, q[i], tool, k, i, work)
        if not _hold(work):
            status = SINGULAR
    for i in range(1):
        q[i] = q[i] - work[21 + i] if status == SOLVED else np.nan
    return status


@kernel(nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 1) and status (N,) by `linear_command`; target (N, 1) and tool (N, 3), k (M, 1, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])


@kernel(nogil=True, error_model="numpy")
def exact_joints(px, state):
    """Return the joints of `exact_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (1,), scratch
    (COMMAND_WORK,) and k (1, COMMAND_CONSTANTS), one after the other.
    """
    state[0] = px
    q = state[4:5]
    exact_command(state[:1], state[1:4], state[33:].reshape((1, COMMAND_CONSTANTS)), state[6:33], q)
    return q[0] * state[5], 


@kernel(nogil=True, error_model="numpy")
def linear_joints(px, state):
    """Return the joints of `linear_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (1,), scratch
    (COMMAND_WORK,) and k (1, 5), one after the other.
    """
    state[0] = px
    q = state[4:5]
    linear_command(state[:1], state[1:4], state[33:].reshape((1, 5)), state[6:33], q)
    return q[0] * state[5], 
