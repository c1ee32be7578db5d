"""Commands of one pose for a servo loop: `linear_delta`, Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both 49cff534bd9c3e50; SymPy 1.14.0.

Scalar code without allocation, to be called from loops that Numba compiles. Lengths in mm, angles in rad.
"""

import math

import numpy as np

from deltacal_kernels.compiled import kernel

from .vectorised import MAX_STEPS, PIVOT_SINGULAR, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 72  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 21  # `exact_command` reads these first columns of k only


@kernel(nogil=True, error_model="numpy")
def _newton(x, q, tool, k, out):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint (334 operations)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    q = q
    s60 = k[0]
    s59 = k[1]
    axis_x = k[2]
    s65 = k[3]
    axis_y = k[4]
    s68 = k[5]
    axis_z = k[6]
    s106 = k[7]
    s109 = k[8]
    u_x = k[9]
    u_y = k[10]
    s128 = k[11]
    s150 = k[12]
    s516 = k[13]
    s62 = -q*s60 + s59
    C_x = axis_x*s62 + s65
    C_y = axis_y*s62 + s68
    C_z = axis_z*s62
    s71 = (cx * cx)
    s73 = (cy * cy)
    s75 = (cz * cz)
    s77 = 0.25*s71 + 0.25*s73 + 0.25*s75 + 1
    s78 = (1.0 / s77)
    s79 = -0.5*s73
    s80 = -0.5*s75
    s81 = s79 + s80
    R_11 = s78*s81 + 1
    s84 = 0.5*cx*cy
    s85 = -cz + s84
    R_12 = s78*s85
    s87 = 0.5*cx*cz
    s88 = cy + s87
    R_13 = s78*s88
    s90 = cz + s84
    R_21 = s78*s90
    s92 = -0.5*s71
    s93 = s80 + s92
    R_22 = s78*s93 + 1
    s96 = 0.5*cy*cz
    s97 = -cx + s96
    R_23 = s78*s97
    s99 = -cy + s87
    R_31 = s78*s99
    s101 = cx + s96
    R_32 = s101*s78
    s103 = s79 + s92
    R_33 = s103*s78 + 1
    s107 = s106 - tx
    s110 = s109 - ty
    A_x = R_11*s107 + R_12*s110 - R_13*tz + px
    A_y = R_21*s107 + R_22*s110 - R_23*tz + py
    A_z = R_31*s107 + R_32*s110 - R_33*tz + pz
    d_x = A_x - C_x
    d_y = A_y - C_y
    d_z = A_z - C_z
    s_x = s128*(-R_11*u_y + R_12*u_x + u_y)
    s_y = s128*(-R_21*u_y + R_22*u_x - u_x)
    s_z = s128*(-R_31*u_y + R_32*u_x)
    s138 = d_x + s_x
    s141 = d_y + s_y
    s144 = d_z + s_z
    s151 = 0.5*(s138 * s138) + 0.5*(s141 * s141) + 0.5*(s144 * s144) + s150
    s152 = 2*s144
    s153 = 0.5*s152
    s154 = 2*s141
    s155 = 0.5*s154
    s156 = 2*s138
    s157 = 0.5*s156
    s159 = s128*s153
    s165 = s128*s155
    s170 = s128*s157
    s176 = -s153*tz
    s182 = -s155*tz
    s188 = -s157*tz
    s196 = s176*s78
    s198 = s110*s153 + s159*u_x
    s199 = s198*s78
    s201 = s107*s153 - s159*u_y
    s203 = s201*s78
    s205 = s182*s78
    s206 = s199 + s205
    s207 = 0.5*cz
    s208 = 0.5*cy
    s211 = s110*s155 + s165*u_x
    s212 = s211*s93
    s213 = s211*s78
    s216 = s107*s155 - s165*u_y
    s217 = s216*s90
    s218 = s216*s78
    s219 = s188*s88
    s220 = s188*s78
    s221 = s203 + s220
    s222 = 0.5*cx
    s225 = s110*s157 + s170*u_x
    s226 = s225*s85
    s227 = s225*s78
    s228 = s218 + s227
    s231 = s107*s157 - s170*u_y
    s232 = s231*s81
    s233 = s231*s78
    s238 = s101*s198 + s103*s176 + s182*s97 + s201*s99 + s212 + s217 + s219 + s226 + s232
    s239 = (1.0 / (s77 * s77))
    s241 = -0.25*s238*s239
    s243 = 2*cz
    s246 = 2*cy
    s249 = 2*cx
    s258 = -s60*(-axis_x*s157 - axis_y*s155 - axis_z*s153)
    s264 = s199 - s205 + s207*s221 + s208*s228 + s249*(-0.5*s196 - 0.5*s213 + s241)
    s265 = -s203 + s206*s207 + s220 + s222*s228 + s246*(-0.5*s196 - 0.5*s233 + s241)
    s266 = s206*s208 + s218 + s221*s222 - s227 + s243*(-0.5*s213 - 0.5*s233 + s241)
    s505 = d_x - s_x
    s508 = d_y - s_y
    s511 = d_z - s_z
    s517 = 0.5*(s505 * s505) + 0.5*(s508 * s508) + 0.5*(s511 * s511) + s516
    s518 = 2*s511
    s519 = 0.5*s518
    s520 = 2*s508
    s521 = 0.5*s520
    s522 = 2*s505
    s523 = 0.5*s522
    s525 = -s128*s519
    s531 = -s128*s521
    s536 = -s128*s523
    s542 = -s519*tz
    s548 = -s521*tz
    s554 = -s523*tz
    s562 = s542*s78
    s564 = s110*s519 + s525*u_x
    s565 = s564*s78
    s567 = s107*s519 - s525*u_y
    s569 = s567*s78
    s571 = s548*s78
    s572 = s565 + s571
    s575 = s110*s521 + s531*u_x
    s576 = s575*s93
    s577 = s575*s78
    s580 = s107*s521 - s531*u_y
    s581 = s580*s90
    s582 = s580*s78
    s583 = s554*s88
    s584 = s554*s78
    s585 = s569 + s584
    s588 = s110*s523 + s536*u_x
    s589 = s588*s85
    s590 = s588*s78
    s591 = s582 + s590
    s594 = s107*s523 - s536*u_y
    s595 = s594*s81
    s596 = s594*s78
    s601 = s101*s564 + s103*s542 + s548*s97 + s567*s99 + s576 + s581 + s583 + s589 + s595
    s603 = -0.25*s239*s601
    s617 = -s60*(-axis_x*s523 - axis_y*s521 - axis_z*s519)
    s623 = s207*s585 + s208*s591 + s249*(-0.5*s562 - 0.5*s577 + s603) + s565 - s571
    s624 = s207*s572 + s222*s591 + s246*(-0.5*s562 - 0.5*s596 + s603) - s569 + s584
    s625 = s208*s572 + s222*s585 + s243*(-0.5*s577 - 0.5*s596 + s603) + s582 - s590
    out[0] = s151
    out[1] = s157
    out[2] = s155
    out[3] = s153
    out[4] = s264
    out[5] = s265
    out[6] = s266
    out[7] = s258
    out[8] = s517
    out[9] = s523
    out[10] = s521
    out[11] = s519
    out[12] = s623
    out[13] = s624
    out[14] = s625
    out[15] = s617


@kernel(nogil=True, error_model="numpy")
def _joint(x, q, tool, k, out):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (22 operations)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s660 = k[14]
    s665 = k[15]
    h = k[16]
    s672 = k[17]
    s674 = k[18]
    s680 = k[19]
    s684 = k[20]
    s669 = -h + pz - tz
    s670 = (s669 * s669)
    s673 = 0.5*s670 + s672 + 0.5*((px + s660 - tx) * (px + s660 - tx)) + 0.5*((py + s665 - ty) * (py + s665 - ty))
    s686 = s669*s684 - math.sqrt(s670*s680 + s673*s674)
    out[0] = s686


def linear_constants(p):
    """Return k (M, 3, 22), what `linear` reads that no pose changes, from p (62 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((22, p.shape[1], 3))
    r = p[0]
    l = p[1]
    phi = p[2]
    home = p[3]
    a = p[4]
    c = p[5]
    endstop = p[6]
    arm = p[7]
    radius = p[8]
    angle = p[9]
    lean_radial = p[10]
    lean_tangential = p[11]
    scale = p[12]
    dl = p[13]
    dr = p[14]
    u_x = np.cos(phi)
    s1 = np.sin(phi)
    u_x_errors = -angle*s1
    u_y = np.sin(phi)
    u_y_errors = angle*u_x
    r_0_errors = dr + radius
    axis_x_errors = lean_radial*u_x - lean_tangential*u_y
    axis_y_errors = lean_radial*u_y + lean_tangential*u_x
    s12 = (l * l)
    s14 = -(r * r) + s12
    h = home + np.sqrt(s14)
    s17 = 1/np.sqrt(s14)
    h_errors = arm*l*s17 + endstop - r*r_0_errors*s17
    s22 = a + r
    s23 = s22*u_x
    s27 = r_0_errors*u_x + s22*u_x_errors
    s29 = s22*u_y
    s33 = r_0_errors*u_y + s22*u_y_errors
    s37 = a*u_x
    s39 = a*u_y
    s42 = a*u_x_errors
    s44 = a*u_y_errors
    s_x_cz = -0.5*c*u_x
    s_y_cz = -0.5*c*u_y
    s_z_cx = 0.5*c*u_x
    s_z_cy = 0.5*c*u_y
    s55 = -s23 + s37
    s60 = a*s1 - s1*s22
    s69 = -arm*l
    s70 = -0.5*dl*l
    s71 = s69 + s70
    s86 = s69 - s70
    k[0] = s55
    k[1] = s60
    k[2] = s12
    k[3] = h
    k[4] = axis_x_errors
    k[5] = s27
    k[6] = axis_y_errors
    k[7] = s33
    k[8] = scale
    k[9] = h_errors
    k[10] = s37
    k[11] = s39
    k[12] = s23
    k[13] = s42
    k[14] = s29
    k[15] = s44
    k[16] = s71
    k[17] = s_z_cx
    k[18] = s_z_cy
    k[19] = s_x_cz
    k[20] = s_y_cz
    k[21] = s86
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


@kernel(nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (13 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s55 = k[i, 0]
    s60 = k[i, 1]
    s12 = k[i, 2]
    h = k[i, 3]
    s64 = math.sqrt(s12 - ((px + s55 - tx) * (px + s55 - tx)) - ((py + s60 - ty) * (py + s60 - ty)))
    s65 = h - pz - s64 + tz
    row = 1 * i
    out[row + 0] = s65


@kernel(nogil=True, error_model="numpy")
def _linear(x, q, tool, k, i, out):
    """Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (54 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    h = k[i, 3]
    axis_x_errors = k[i, 4]
    s27 = k[i, 5]
    axis_y_errors = k[i, 6]
    s33 = k[i, 7]
    scale = k[i, 8]
    h_errors = k[i, 9]
    s37 = k[i, 10]
    s39 = k[i, 11]
    s23 = k[i, 12]
    s42 = k[i, 13]
    s29 = k[i, 14]
    s44 = k[i, 15]
    s71 = k[i, 16]
    s_z_cx = k[i, 17]
    s_z_cy = k[i, 18]
    s_x_cz = k[i, 19]
    s_y_cz = k[i, 20]
    s86 = k[i, 21]
    s21 = h - q
    C_x_errors = axis_x_errors*s21 + s27
    C_y_errors = axis_y_errors*s21 + s33
    C_z_errors = h_errors - q*scale
    s38 = s37 - tx
    s40 = s39 - ty
    A_x = px + s38
    A_y = py + s40
    A_z = pz - tz
    d_x = A_x - s23
    d_x_errors = -C_x_errors + s42
    d_y = A_y - s29
    d_y_errors = -C_y_errors + s44
    d_z = A_z - s21
    s66 = d_x*d_x_errors
    s67 = d_y*d_y_errors
    s68 = -C_z_errors*d_z
    s72 = s66 + s67 + s68 + s71
    s73 = d_y*tz
    s74 = d_z*s40
    s75 = d_z*s_z_cx
    s76 = s73 + s74 + s75
    s77 = -d_x*tz
    s78 = -d_z*s38
    s79 = d_z*s_z_cy
    s80 = s77 + s78 + s79
    s81 = -d_x*s40
    s82 = d_y*s38
    s83 = d_x*s_x_cz
    s84 = d_y*s_y_cz
    s85 = s81 + s82 + s83 + s84
    s87 = s66 + s67 + s68 + s86
    s88 = s73 + s74 - s75
    s89 = s77 + s78 - s79
    s90 = s81 + s82 - s83 - s84
    row = 16 * i
    out[row + 0] = s72
    out[row + 4] = s76
    out[row + 5] = s80
    out[row + 6] = s85
    out[row + 7] = d_z
    out[row + 8] = s87
    out[row + 12] = s88
    out[row + 13] = s89
    out[row + 14] = s90
    out[row + 15] = d_z


@kernel(nogil=True, error_model="numpy")
def _hold(work):
    """Solve for the changes of joints and rotation that undo the closures while the reference point stays in place.

    work: per rod closure, its derivatives by the platform and by the joint; then room for the reduced equations; then
    the changes. A limb's joint is eliminated with the rod that feels it most; what is left are 3 equations for the
    rotation. Returns False where a joint is felt by no rod of its limb, or the rotation is not held.
    """
    largest = 0.0
    for row in range(6):
        for c in range(4, 8):
            largest = max(largest, abs(work[8 * row + c]))
    smallest = PIVOT_SINGULAR * largest
    target = 48
    for i in range(3):
        best = 16 * i
        for j in range(1, 2):
            if abs(work[16 * i + 8 * j + 7]) > abs(work[best + 7]):
                best = 16 * i + 8 * j
        if not abs(work[best + 7]) > smallest:
            return False
        inverse = 1.0 / work[best + 7]
        for j in range(2):
            rod = 16 * i + 8 * j
            if rod != best:
                factor = work[rod + 7] * inverse
                for c in range(3):
                    work[target + c] = work[rod + 4 + c] - factor * work[best + 4 + c]
                work[target + 3] = work[rod] - factor * work[best]
                target += 4
        # the joint's own equation, left to the end: closure and rotation over the joint's derivative
        for c in range(3):
            work[16 * i + 4 + c] = work[best + 4 + c] * inverse
        work[60 + i] = work[best] * inverse
    for c in range(3):
        pivot = 48 + 4 * c
        for r in range(c + 1, 3):
            if abs(work[48 + 4 * r + c]) > abs(work[pivot + c]):
                pivot = 48 + 4 * r
        row = 48 + 4 * c
        if not abs(work[pivot + c]) > smallest:
            return False
        if pivot != row:
            for j in range(c, 4):
                work[row + j], work[pivot + j] = work[pivot + j], work[row + j]
        inverse = 1.0 / work[row + c]
        for r in range(c + 1, 3):
            below = 48 + 4 * r
            factor = work[below + c] * inverse
            for j in range(c + 1, 4):
                work[below + j] -= factor * work[row + j]
    for c in range(2, -1, -1):
        row = 48 + 4 * c
        total = work[row + 3]
        for j in range(c + 1, 3):
            total -= work[row + j] * work[63 + j]
        work[63 + c] = total / work[row + c]
    for i in range(3):
        for c in range(3):
            work[60 + i] -= work[16 * i + 4 + c] * work[63 + c]
    return True


@kernel(nogil=True, error_model="numpy")
def exact_command(target, tool, k, work, q):
    """Fill the joints q (3,) that bring the reference point to target (3,); return the status.

    `inverse` for one pose, to be called from a servo loop: tool (3,), k (3, :), scratch work (COMMAND_WORK,).
    q is NaN unless SOLVED.
    """
    pose = work[66:]
    for c in range(3):
        pose[c] = target[c]
    for c in range(3):
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
                _newton(pose, q[i], tool, k[i], work[16 * i : 16 * (i + 1)])
            if not _hold(work):
                status = SINGULAR
                break
            size = 0.0
            for i in range(3):
                q[i] -= work[60 + i]
                size = max(size, abs(work[60 + i]))
            for c in range(3):
                pose[3 + c] -= work[63 + c]
                size = max(size, abs(work[63 + c]))
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
    is, to first order, when the errors appear. tool (3,), k (3, 22) from `linear_constants`, scratch work
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
        q[i] = q[i] - work[60 + i] if status == SOLVED else np.nan
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
    exact_command(state[:3], state[3:6], state[84:].reshape((3, COMMAND_CONSTANTS)), state[12:84], q)
    return q[0] * state[9], q[1] * state[10], q[2] * state[11], 


@kernel(nogil=True, error_model="numpy")
def linear_joints(px, py, pz, state):
    """Return the joints of `linear_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (3,), scratch
    (COMMAND_WORK,) and k (3, 22), one after the other.
    """
    state[0] = px
    state[1] = py
    state[2] = pz
    q = state[6:9]
    linear_command(state[:3], state[3:6], state[84:].reshape((3, 22)), state[12:84], q)
    return q[0] * state[9], q[1] * state[10], q[2] * state[11], 
