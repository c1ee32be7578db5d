"""Commands of one pose for a servo loop: `robotennis`, RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both 551ce77364038b50; SymPy 1.14.0.

Scalar code without allocation, to be called from loops that Numba compiles. Lengths in mm, angles in rad.
"""

import math

import numpy as np

from deltacal_kernels.compiled import kernel

from .vectorised import MAX_STEPS, PIVOT_SINGULAR, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 21  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 22  # `exact_command` reads these first columns of k only


@kernel(nogil=True, error_model="numpy")
def _newton(x, q, tool, k, out):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint (60 operations)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    q = q
    theta0 = k[0]
    u_x = k[1]
    u_y = k[2]
    s11 = k[3]
    s14 = k[4]
    s16 = k[5]
    s20 = k[6]
    s22 = k[7]
    tip_v = k[8]
    px0 = k[9]
    py0 = k[10]
    pz0 = k[11]
    s31 = k[12]
    s33 = k[13]
    s46 = k[14]
    s6 = q + theta0
    s7 = math.cos(s6)
    arm_x = s7*u_x
    arm_y = s7*u_y
    arm_z = math.sin(s6)
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
    s47 = 0.5*(rod_x * rod_x) + 0.5*(rod_y * rod_y) + 0.5*(rod_z * rod_z) + s46
    s48 = 2*rod_z
    s49 = 0.5*s48
    s50 = 2*rod_y
    s51 = 0.5*s50
    s52 = 2*rod_x
    s53 = 0.5*s52
    s73 = -arm_z*(-s11*s51*u_y - s11*s53*u_x - s49*tip_v)
    s74 = s7*(-s11*s49 - s14*s53 - s20*s51) + s73
    out[0] = s47
    out[1] = s53
    out[2] = s51
    out[3] = s49
    out[4] = s74


@kernel(nogil=True, error_model="numpy")
def _joint(x, q, tool, k, out):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (35 operations)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    theta0 = k[0]
    pz0 = k[11]
    s96 = k[15]
    s98 = k[16]
    s100 = k[17]
    s102 = k[18]
    s117 = k[19]
    s124 = k[20]
    s129 = k[21]
    centre_z = pz + pz0 - tz
    s97 = px + s96 - tx
    s101 = py + s100 - ty
    s104 = s101*s102 + s97*s98
    s106 = (centre_z * centre_z)
    s118 = 0.5*(s101 * s101) + 0.5*s106 + s117 + 0.5*(s97 * s97)
    s127 = math.sqrt((s104 * s104) + s106*s124 - (s118 * s118))
    s136 = -theta0 + math.atan2(centre_z*s118*s129 + s104*s127, centre_z*s127*s129 - s104*s118)
    out[0] = s136


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


@kernel(nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (33 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s75 = k[i, 0]
    s77 = k[i, 1]
    s81 = k[i, 2]
    s83 = k[i, 3]
    s100 = k[i, 4]
    s95 = k[i, 5]
    a = k[i, 6]
    centre_z = pz - tz
    s76 = px + s75 - tx
    s82 = py + s81 - ty
    s85 = s76*s77 + s82*s83
    s87 = (centre_z * centre_z)
    s101 = s100 + 0.5*(s76 * s76) + 0.5*(s82 * s82) + 0.5*s87
    s105 = math.sqrt(-(s101 * s101) + (s85 * s85) + s87*s95)
    s112 = math.atan2(a*centre_z*s101 + s105*s85, a*centre_z*s105 - s101*s85)
    row = 1 * i
    out[row + 0] = s112


@kernel(nogil=True, error_model="numpy")
def _linear(x, q, tool, k, i, out):
    """Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (65 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    a = k[i, 6]
    u_x = k[i, 7]
    u_x_errors = k[i, 8]
    s18 = k[i, 9]
    u_y = k[i, 10]
    u_y_errors = k[i, 11]
    s24 = k[i, 12]
    theta0 = k[i, 13]
    A_x = k[i, 14]
    da = k[i, 15]
    s36 = k[i, 16]
    s38 = k[i, 17]
    A_y = k[i, 18]
    s46 = k[i, 19]
    s48 = k[i, 20]
    tip_v = k[i, 21]
    s59 = k[i, 22]
    s64 = k[i, 23]
    C_x_errors = k[i, 24]
    C_y_errors = k[i, 25]
    pz0 = k[i, 26]
    s116 = k[i, 27]
    s13 = math.cos(q)
    arm_x = s13*u_x
    s15 = math.sin(q)
    arm_x_q = -s15*u_x
    arm_x_errors = s13*u_x_errors + s15*s18
    arm_y = s13*u_y
    arm_y_q = -s15*u_y
    arm_y_errors = s13*u_y_errors + s15*s24
    arm_z = math.sin(q)
    arm_z_q = math.cos(q)
    arm_z_errors = s13*theta0
    B_x = A_x + a*arm_x
    B_x_q = a*arm_x_q
    B_x_errors = a*arm_x_errors + arm_x*da + s15*s36 + s38
    B_y = A_y + a*arm_y
    B_y_q = a*arm_y_q
    B_y_errors = a*arm_y_errors + arm_y*da + s15*s46 + s48
    B_z = a*arm_z
    B_z_q = a*arm_z_q
    B_z_errors = a*arm_z_errors + arm_z*da + s13*tip_v
    centre_x = px - tx
    centre_y = py - ty
    centre_z = pz - tz
    C_x = centre_x + s59
    C_y = centre_y + s64
    rod_x = -B_x + C_x
    rod_x_errors = -B_x_errors + C_x_errors
    rod_y = -B_y + C_y
    rod_y_errors = -B_y_errors + C_y_errors
    rod_z = -B_z + centre_z
    rod_z_errors = -B_z_errors + pz0
    s117 = rod_x*rod_x_errors + rod_y*rod_y_errors + rod_z*rod_z_errors + s116
    s121 = -B_x_q*rod_x - B_y_q*rod_y - B_z_q*rod_z
    row = 5 * i
    out[row + 0] = s117
    out[row + 4] = s121


@kernel(nogil=True, error_model="numpy")
def _hold(work):
    """Solve for the changes of joints and rotation that undo the closures while the reference point stays in place.

    work: per rod closure, its derivatives by the platform and by the joint; then room for the reduced equations; then
    the changes. A limb's joint is eliminated with the rod that feels it most; what is left are 0 equations for the
    rotation. Returns False where a joint is felt by no rod of its limb, or the rotation is not held.
    """
    largest = 0.0
    for row in range(3):
        for c in range(4, 5):
            largest = max(largest, abs(work[5 * row + c]))
    smallest = PIVOT_SINGULAR * largest
    target = 15
    for i in range(3):
        best = 5 * i
        for j in range(1, 1):
            if abs(work[5 * i + 5 * j + 4]) > abs(work[best + 4]):
                best = 5 * i + 5 * j
        if not abs(work[best + 4]) > smallest:
            return False
        inverse = 1.0 / work[best + 4]
        for j in range(1):
            rod = 5 * i + 5 * j
            if rod != best:
                factor = work[rod + 4] * inverse
                for c in range(0):
                    work[target + c] = work[rod + 4 + c] - factor * work[best + 4 + c]
                work[target + 0] = work[rod] - factor * work[best]
                target += 1
        # the joint's own equation, left to the end: closure and rotation over the joint's derivative
        for c in range(0):
            work[5 * i + 4 + c] = work[best + 4 + c] * inverse
        work[15 + i] = work[best] * inverse
    for c in range(0):
        pivot = 15 + 1 * c
        for r in range(c + 1, 0):
            if abs(work[15 + 1 * r + c]) > abs(work[pivot + c]):
                pivot = 15 + 1 * r
        row = 15 + 1 * c
        if not abs(work[pivot + c]) > smallest:
            return False
        if pivot != row:
            for j in range(c, 1):
                work[row + j], work[pivot + j] = work[pivot + j], work[row + j]
        inverse = 1.0 / work[row + c]
        for r in range(c + 1, 0):
            below = 15 + 1 * r
            factor = work[below + c] * inverse
            for j in range(c + 1, 1):
                work[below + j] -= factor * work[row + j]
    for c in range(-1, -1, -1):
        row = 15 + 1 * c
        total = work[row + 0]
        for j in range(c + 1, 0):
            total -= work[row + j] * work[18 + j]
        work[18 + c] = total / work[row + c]
    for i in range(3):
        for c in range(0):
            work[15 + i] -= work[5 * i + 4 + c] * work[18 + c]
    return True


@kernel(nogil=True, error_model="numpy")
def exact_command(target, tool, k, work, q):
    """Fill the joints q (3,) that bring the reference point to target (3,); return the status.

    `inverse` for one pose, to be called from a servo loop: tool (3,), k (3, :), scratch work (COMMAND_WORK,).
    q is NaN unless SOLVED.
    """
    pose = work[18:]
    for c in range(3):
        pose[c] = target[c]
    for c in range(0):
        pose[3 + c] = 0.0
    status = SOLVED
    for i in range(3):
        _joint(pose, 0.0, tool, k[i], work)
        q[i] = work[0]
        if not math.isfinite(q[i]):
            status = UNREACHABLE
    if status == SOLVED:
        status = UNREACHABLE
        for _ in range(MAX_STEPS):
            for i in range(3):
                _newton(pose, q[i], tool, k[i], work[5 * i : 5 * (i + 1)])
            if not _hold(work):
                status = SINGULAR
                break
            size = 0.0
            for i in range(3):
                q[i] -= work[15 + i]
                size = max(size, abs(work[15 + i]))
            for c in range(0):
                pose[3 + c] -= work[18 + c]
                size = max(size, abs(work[18 + c]))
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
    if status != SOLVED:
        for i in range(3):
            q[i] = np.nan
    return status


@kernel(nogil=True, error_model="numpy")
def linear_command(target, tool, k, work, q):
    """Fill the joints q (3,) that bring the reference point to target (3,) to first order in the errors; return the status.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. tool (3,), k (3, 28) from `linear_constants`, scratch work
    (COMMAND_WORK,). q is NaN unless SOLVED.
    """
    status = SOLVED
    for i in range(3):
        _nominal_joint(target, 0.0, tool, k, i, q)
        if not math.isfinite(q[i]):
            status = UNREACHABLE
    if status == SOLVED:
        for i in range(3):
            _linear(target, q[i], tool, k, i, work)
        if not _hold(work):
            status = SINGULAR
    for i in range(3):
        q[i] = q[i] - work[15 + i] if status == SOLVED else np.nan
    return status


@kernel(nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 3) and status (N,) by `linear_command`; target (N, 3) and tool (N, 3), k (M, 3, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])


@kernel(nogil=True, error_model="numpy")
def exact_joints(px, py, pz, state):
    """Return the joints of `exact_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (3,), scratch
    (COMMAND_WORK,) and k (3, COMMAND_CONSTANTS), one after the other.
    """
    state[0] = px
    state[1] = py
    state[2] = pz
    q = state[6:9]
    exact_command(state[:3], state[3:6], state[33:].reshape((3, COMMAND_CONSTANTS)), state[12:33], q)
    return q[0] * state[9], q[1] * state[10], q[2] * state[11], 


@kernel(nogil=True, error_model="numpy")
def linear_joints(px, py, pz, state):
    """Return the joints of `linear_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (3,), scratch
    (COMMAND_WORK,) and k (3, 28), one after the other.
    """
    state[0] = px
    state[1] = py
    state[2] = pz
    q = state[6:9]
    linear_command(state[:3], state[3:6], state[33:].reshape((3, 28)), state[12:33], q)
    return q[0] * state[9], q[1] * state[10], q[2] * state[11], 
