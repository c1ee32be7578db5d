"""Commands of one pose for a servo loop: `planar_parallelogram`, Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both a8183660bc08a7c2; SymPy 1.14.0.

Scalar code without allocation, to be called from loops that Numba compiles. Lengths in mm, angles in rad.
"""

import math

import numpy as np

from deltacal_kernels.compiled import kernel

from .vectorised import MAX_STEPS, PIVOT_SINGULAR, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 27  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 26  # `exact_command` reads these first columns of k only


@kernel(nogil=True, error_model="numpy")
def _newton(x, q, tool, k, out):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint (102 operations)."""
    px = x[0]
    py = x[1]
    cz = x[2]
    tx = tool[0]
    ty = tool[1]
    q = q
    h = k[0]
    q0 = k[1]
    s7 = k[2]
    b1_x = k[3]
    b2_x = k[4]
    b2_y = k[5]
    A2_x = k[6]
    A2_y = k[7]
    A1_x = k[8]
    s69 = k[9]
    C_y = -h + ty
    s8 = q + q0
    r1_x = s7*math.sin(s8)
    r1_y = -s7*math.cos(s8)
    s13 = (cz * cz)
    s15 = 0.25*s13 + 1
    s16 = (1.0 / s15)
    s18 = -0.5*s13*s16 + 1
    s19 = b1_x - tx
    B1_x = C_y*cz*s16 + px + s18*s19
    B1_y = -C_y*s18 + cz*s16*s19 + py
    s26 = b2_x - tx
    s28 = -C_y + b2_y
    B2_x = -cz*s16*s28 + px + s18*s26
    B2_y = cz*s16*s26 + py + s18*s28
    r2_x = -A2_x + B2_x
    r2_y = -A2_y + B2_y
    s36 = -A1_x + B1_x - r1_x
    s40 = -0.5*s16
    s41 = -0.5*s13
    s45 = (1.0 / (s15 * s15))
    s49 = 2*cz
    s51 = C_y*s16 + s49*(s19*s40 - 0.25*s45*(C_y*cz + s19*s41))
    s52 = B1_y - r1_y
    s62 = s16*s19 + s49*(-C_y*s40 - 0.25*s45*(-C_y*s41 + cz*s19))
    s70 = 0.5*(r2_x * r2_x) + 0.5*(r2_y * r2_y) + s69
    s71 = 2*r2_y
    s72 = 0.5*s71
    s73 = 2*r2_x
    s74 = 0.5*s73
    s91 = s26*s74 + s28*s72
    s98 = s49*(s40*s91 - 0.25*s45*(cz*s26*s72 - cz*s28*s74 + s41*s91))
    s99 = s16*s26*s72 - s16*s28*s74 + s98
    out[0] = s36
    out[1] = 1
    out[2] = 0
    out[3] = s51
    out[4] = r1_y
    out[5] = s52
    out[6] = 0
    out[7] = 1
    out[8] = s62
    out[9] = -r1_x
    out[10] = s70
    out[11] = s74
    out[12] = s72
    out[13] = s99
    out[14] = 0


@kernel(nogil=True, error_model="numpy")
def _joint(x, q, tool, k, out):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (64 operations)."""
    px = x[0]
    tx = tool[0]
    ty = tool[1]
    h = k[0]
    q0 = k[1]
    s7 = k[2]
    b1_x = k[3]
    s103 = k[10]
    s102 = k[11]
    s108 = k[12]
    s116 = k[13]
    s120 = k[14]
    s122 = k[15]
    s124 = k[16]
    s130 = k[17]
    s134 = k[18]
    s136 = k[19]
    s138 = k[20]
    s149 = k[21]
    s153 = k[22]
    s156 = k[23]
    s158 = k[24]
    s160 = k[25]
    C_y = -h + ty
    s104 = px + s103 - tx
    s107 = -q0 + math.asin(s102*s104)
    s109 = (s104 * s104)
    s111 = -s108*s109 + 1
    s112 = math.sqrt(s111)
    s125 = s104*s116 + s112*s120 + s112*s122 + s124
    s139 = s104*s130 + s104*s134 + s112*s136 + s138
    s161 = s104*s153 + s104*s156 + s109 + s111*s149 + s112*s158 + s160
    s164 = math.sqrt((s125 * s125) + (s139 * s139) - (s161 * s161))
    s167 = -s125*s161 + s139*s164
    s171 = -s125*s164 - s139*s161
    s174 = 1/math.sqrt((s167 * s167) + (s171 * s171))
    s177 = C_y*s171*s174 - s112*s7 - s167*s174*(b1_x - tx)
    s181 = 2*math.tan(0.5*math.atan2(s167, s171))
    out[0] = s107
    out[1] = s177
    out[2] = s181


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
    s136 = (1.0 / l1)
    s137 = a1x - b1x
    s145 = -dl2*l2
    k[0] = s137
    k[1] = s136
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
    k[27] = s145
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


@kernel(nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (4 operations); limb i of k, row i of out."""
    px = x[0]
    tx = tool[0]
    s137 = k[i, 0]
    s136 = k[i, 1]
    s140 = math.asin(s136*(px + s137 - tx))
    row = 1 * i
    out[row + 0] = s140


@kernel(nogil=True, error_model="numpy")
def _linear(x, q, tool, k, i, out):
    """Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (151 operations); limb i of k, row i of out."""
    px = x[0]
    tx = tool[0]
    ty = tool[1]
    l1 = k[i, 2]
    s6 = k[i, 3]
    s8 = k[i, 4]
    s11 = k[i, 5]
    s13 = k[i, 6]
    s24 = k[i, 7]
    s34 = k[i, 8]
    s41 = k[i, 9]
    s43 = k[i, 10]
    s45 = k[i, 11]
    s47 = k[i, 12]
    b1x = k[i, 13]
    h = k[i, 14]
    dl1 = k[i, 15]
    s75 = k[i, 16]
    db1x = k[i, 17]
    b2x = k[i, 18]
    b2y = k[i, 19]
    db2x = k[i, 20]
    db2y = k[i, 21]
    a2x = k[i, 22]
    da2x = k[i, 23]
    a2y = k[i, 24]
    da2y = k[i, 25]
    da1x = k[i, 26]
    s145 = k[i, 27]
    s0 = math.cos(q)
    s10 = math.sin(q)
    s14 = s0*s6 + s0*s8 + s10*s11 + s13
    s25 = s0*s11 - s10*s6 - s10*s8 + s24
    s48 = (s0 * s0)*s34 + s0*s45 + (s10 * s10)*s34 + s10*s41 + s10*s43 + s47
    s51 = math.sqrt((s14 * s14) + (s25 * s25) - (s48 * s48))
    s54 = -s14*s48 + s25*s51
    s58 = -s14*s51 - s25*s48
    s61 = 1/math.sqrt((s54 * s54) + (s58 * s58))
    s62 = b1x + tx
    nominal_py = -l1*s0 + s54*s61*s62 + s58*s61*(-h + ty)
    nominal_cz = 2*math.tan(0.5*math.atan2(s54, s58))
    C_y = -h + ty
    r1_x_q = l1*s0
    r1_x_errors = dl1*s10 + s0*s75
    r1_y_q = l1*s10
    r1_y_errors = -dl1*s0 + s10*s75
    s83 = (nominal_cz * nominal_cz)
    s85 = 0.25*s83 + 1
    s86 = (1.0 / s85)
    s88 = -0.5*s83*s86 + 1
    s95 = (1.0 / (s85 * s85))
    s97 = 0.25*(nominal_cz * nominal_cz * nominal_cz)*s95 - nominal_cz*s86
    B1_x_cz = -0.5*C_y*s83*s95 + C_y*s86 - s62*s97
    B1_x_errors = -db1x*s88
    B1_y_cz = -C_y*s97 + 0.5*s62*s83*s95 - s62*s86
    B1_y_errors = -db1x*nominal_cz*s86
    s110 = b2x - tx
    s112 = -C_y + b2y
    B2_x = -nominal_cz*s112*s86 + px + s110*s88
    B2_x_cz = s110*s97 + 0.5*s112*s83*s95 - s112*s86
    B2_x_errors = db2x*s88 - db2y*nominal_cz*s86
    B2_y = nominal_cz*s110*s86 + nominal_py + s112*s88
    B2_y_cz = -0.5*s110*s83*s95 + s110*s86 + s112*s97
    B2_y_errors = db2x*nominal_cz*s86 + db2y*s88
    r2_x = B2_x - a2x
    r2_x_errors = B2_x_errors - da2x
    r2_y = B2_y - a2y
    r2_y_errors = B2_y_errors - da2y
    s141 = B1_x_errors + da1x - r1_x_errors
    s142 = B1_y_errors - r1_y_errors
    s146 = r2_x*r2_x_errors + r2_y*r2_y_errors + s145
    s149 = B2_x_cz*r2_x + B2_y_cz*r2_y
    row = 15 * i
    out[row + 0] = s141
    out[row + 2] = 0
    out[row + 3] = B1_x_cz
    out[row + 4] = -r1_x_q
    out[row + 5] = s142
    out[row + 7] = 1
    out[row + 8] = B1_y_cz
    out[row + 9] = -r1_y_q
    out[row + 10] = s146
    out[row + 12] = r2_y
    out[row + 13] = s149
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
    is, to first order, when the errors appear. tool (3,), k (1, 28) from `linear_constants`, scratch work
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
    (COMMAND_WORK,) and k (1, 28), one after the other.
    """
    state[0] = px
    q = state[4:5]
    linear_command(state[:1], state[1:4], state[33:].reshape((1, 28)), state[6:33], q)
    return q[0] * state[5], 
