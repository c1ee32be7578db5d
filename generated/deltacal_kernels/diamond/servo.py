"""Commands of one pose for a servo loop: `diamond`, Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both 47f475370bdbef70; SymPy 1.14.0.

Scalar code without allocation, to be called from loops that Numba compiles. Lengths in mm, angles in rad.
"""

import math

import numpy as np

from deltacal_kernels.compiled import kernel

from .vectorised import MAX_STEPS, PIVOT_SINGULAR, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 12  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 9  # `exact_command` reads these first columns of k only


@kernel(nogil=True, error_model="numpy")
def _newton(x, q, tool, k, out):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint (35 operations)."""
    px = x[0]
    py = x[1]
    tx = tool[0]
    ty = tool[1]
    q = q
    s6 = k[0]
    s9 = k[1]
    s12 = k[2]
    B_x = k[3]
    B_y = k[4]
    s28 = k[5]
    s7 = q + s6
    s8 = math.cos(s7)
    s11 = math.sin(s7)
    C_x = B_x + s11*s12 + s8*s9
    C_y = B_y + s11*s9 - s12*s8
    A_x = px - tx
    A_y = py - ty
    d_x = A_x - C_x
    d_y = A_y - C_y
    s29 = 0.5*(d_x * d_x) + 0.5*(d_y * d_y) + s28
    s30 = 2*d_y
    s31 = 0.5*s30
    s32 = 2*d_x
    s33 = 0.5*s32
    s46 = -s11*(s12*s31 - s33*s9) + s8*(-s12*s33 - s31*s9)
    out[0] = s29
    out[1] = s33
    out[2] = s31
    out[3] = s46


@kernel(nogil=True, error_model="numpy")
def _joint(x, q, tool, k, out):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (29 operations)."""
    px = x[0]
    py = x[1]
    tx = tool[0]
    ty = tool[1]
    s6 = k[0]
    s9 = k[1]
    B_x = k[3]
    B_y = k[4]
    s62 = k[6]
    s66 = k[7]
    s71 = k[8]
    s53 = -B_y + py - ty
    s54 = -B_x + px - tx
    s55 = (s54 * s54)
    s57 = (s53 * s53)
    s63 = 0.5*s55 + 0.5*s57 + s62
    s70 = math.sqrt(s55*s66 + s57*s66 - (s63 * s63))
    s78 = -s6 + math.atan2(s53*s63*s9 + s54*s70*s71, -s53*s70*s71 + s54*s63*s9)
    out[0] = s78


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


@kernel(nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (29 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    tx = tool[0]
    ty = tool[1]
    base_y = k[i, 0]
    B_x = k[i, 1]
    s38 = k[i, 2]
    s5 = k[i, 3]
    s42 = k[i, 4]
    s47 = k[i, 5]
    s2 = k[i, 6]
    s27 = -base_y + py - ty
    s28 = -B_x + px - tx
    s29 = (s28 * s28)
    s31 = (s27 * s27)
    s39 = 0.5*s29 + 0.5*s31 + s38
    s46 = math.sqrt(s29*s42 + s31*s42 - (s39 * s39))
    s54 = -s2 + math.atan2(s27*s39*s5 + s28*s46*s47, -s27*s46*s47 + s28*s39*s5)
    row = 1 * i
    out[row + 0] = s54


@kernel(nogil=True, error_model="numpy")
def _linear(x, q, tool, k, i, out):
    """Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (33 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    tx = tool[0]
    ty = tool[1]
    base_y = k[i, 0]
    B_x = k[i, 1]
    s5 = k[i, 3]
    s2 = k[i, 6]
    s10 = k[i, 7]
    s12 = k[i, 8]
    s14 = k[i, 9]
    ex = k[i, 10]
    ey = k[i, 11]
    s57 = k[i, 12]
    s3 = q + s2
    s4 = math.cos(s3)
    C_x = B_x + s4*s5
    s8 = math.sin(s3)
    C_x_q = -s5*s8
    C_x_errors = ex + s10*s4 + s12*s8 + s14*s8
    C_y = -C_x_q + base_y
    C_y_q = s4*s5
    C_y_errors = ey + s10*s8 - s12*s4 - s14*s4
    A_x = px - tx
    A_y = py - ty
    d_x = A_x - C_x
    d_y = A_y - C_y
    s58 = -C_x_errors*d_x - C_y_errors*d_y + s57
    s61 = -C_x_q*d_x - C_y_q*d_y
    row = 4 * i
    out[row + 0] = s58
    out[row + 3] = s61


@kernel(nogil=True, error_model="numpy")
def _hold(work):
    """Solve for the changes of joints and rotation that undo the closures while the reference point stays in place.

    work: per rod closure, its derivatives by the platform and by the joint; then room for the reduced equations; then
    the changes. A limb's joint is eliminated with the rod that feels it most; what is left are 0 equations for the
    rotation. Returns False where a joint is felt by no rod of its limb, or the rotation is not held.
    """
    largest = 0.0
    for row in range(2):
        for c in range(3, 4):
            largest = max(largest, abs(work[4 * row + c]))
    smallest = PIVOT_SINGULAR * largest
    target = 8
    for i in range(2):
        best = 4 * i
        for j in range(1, 1):
            if abs(work[4 * i + 4 * j + 3]) > abs(work[best + 3]):
                best = 4 * i + 4 * j
        if not abs(work[best + 3]) > smallest:
            return False
        inverse = 1.0 / work[best + 3]
        for j in range(1):
            rod = 4 * i + 4 * j
            if rod != best:
                factor = work[rod + 3] * inverse
                for c in range(0):
                    work[target + c] = work[rod + 3 + c] - factor * work[best + 3 + c]
                work[target + 0] = work[rod] - factor * work[best]
                target += 1
        # the joint's own equation, left to the end: closure and rotation over the joint's derivative
        for c in range(0):
            work[4 * i + 3 + c] = work[best + 3 + c] * inverse
        work[8 + i] = work[best] * inverse
    for c in range(0):
        pivot = 8 + 1 * c
        for r in range(c + 1, 0):
            if abs(work[8 + 1 * r + c]) > abs(work[pivot + c]):
                pivot = 8 + 1 * r
        row = 8 + 1 * c
        if not abs(work[pivot + c]) > smallest:
            return False
        if pivot != row:
            for j in range(c, 1):
                work[row + j], work[pivot + j] = work[pivot + j], work[row + j]
        inverse = 1.0 / work[row + c]
        for r in range(c + 1, 0):
            below = 8 + 1 * r
            factor = work[below + c] * inverse
            for j in range(c + 1, 1):
                work[below + j] -= factor * work[row + j]
    for c in range(-1, -1, -1):
        row = 8 + 1 * c
        total = work[row + 0]
        for j in range(c + 1, 0):
            total -= work[row + j] * work[10 + j]
        work[10 + c] = total / work[row + c]
    for i in range(2):
        for c in range(0):
            work[8 + i] -= work[4 * i + 3 + c] * work[10 + c]
    return True


@kernel(nogil=True, error_model="numpy")
def exact_command(target, tool, k, work, q):
    """Fill the joints q (2,) that bring the reference point to target (2,); return the status.

    `inverse` for one pose, to be called from a servo loop: tool (3,), k (2, :), scratch work (COMMAND_WORK,).
    q is NaN unless SOLVED.
    """
    pose = work[10:]
    for c in range(2):
        pose[c] = target[c]
    for c in range(0):
        pose[2 + c] = 0.0
    status = SOLVED
    for i in range(2):
        _joint(pose, 0.0, tool, k[i], work)
        q[i] = work[0]
        if not math.isfinite(q[i]):
            status = UNREACHABLE
    if status == SOLVED:
        status = UNREACHABLE
        for _ in range(MAX_STEPS):
            for i in range(2):
                _newton(pose, q[i], tool, k[i], work[4 * i : 4 * (i + 1)])
            if not _hold(work):
                status = SINGULAR
                break
            size = 0.0
            for i in range(2):
                q[i] -= work[8 + i]
                size = max(size, abs(work[8 + i]))
            for c in range(0):
                pose[2 + c] -= work[10 + c]
                size = max(size, abs(work[10 + c]))
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
    if status != SOLVED:
        for i in range(2):
            q[i] = np.nan
    return status


@kernel(nogil=True, error_model="numpy")
def linear_command(target, tool, k, work, q):
    """Fill the joints q (2,) that bring the reference point to target (2,) to first order in the errors; return the status.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. tool (3,), k (2, 13) from `linear_constants`, scratch work
    (COMMAND_WORK,). q is NaN unless SOLVED.
    """
    status = SOLVED
    for i in range(2):
        _nominal_joint(target, 0.0, tool, k, i, q)
        if not math.isfinite(q[i]):
            status = UNREACHABLE
    if status == SOLVED:
        for i in range(2):
            _linear(target, q[i], tool, k, i, work)
        if not _hold(work):
            status = SINGULAR
    for i in range(2):
        q[i] = q[i] - work[8 + i] if status == SOLVED else np.nan
    return status


@kernel(nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 2) and status (N,) by `linear_command`; target (N, 2) and tool (N, 3), k (M, 2, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])


@kernel(nogil=True, error_model="numpy")
def exact_joints(px, py, state):
    """Return the joints of `exact_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (2,), scratch
    (COMMAND_WORK,) and k (2, COMMAND_CONSTANTS), one after the other.
    """
    state[0] = px
    state[1] = py
    q = state[5:7]
    exact_command(state[:2], state[2:5], state[21:].reshape((2, COMMAND_CONSTANTS)), state[9:21], q)
    return q[0] * state[7], q[1] * state[8], 


@kernel(nogil=True, error_model="numpy")
def linear_joints(px, py, state):
    """Return the joints of `linear_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (2,), scratch
    (COMMAND_WORK,) and k (2, 13), one after the other.
    """
    state[0] = px
    state[1] = py
    q = state[5:7]
    linear_command(state[:2], state[2:5], state[21:].reshape((2, 13)), state[9:21], q)
    return q[0] * state[7], q[1] * state[8], 
