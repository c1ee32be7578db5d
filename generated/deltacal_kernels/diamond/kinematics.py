"""Kinematics of `diamond`: Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 857c157ad9acd2c4; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 2)  platform: px py
q (N, 2)  joints        tool (N, 3)  reference point in {O'}
p (M, 2, 13)  one row of parameters per limb: base_x base_y L l side theta ex ey L l mx my tip_v
k (M, 2, 11)  what `constants` makes of p; M is 1 (one machine) or N (parameters that change from pose to pose)

Kernels allocate nothing per pose and never raise: `status` says what became of each pose.
"""

import math

import numpy as np
from numba import njit

SOLVED, UNREACHABLE, SINGULAR = 0, 1, 2
MAX_STEPS = 30
STEP_DONE = 1e-9  # mm and rad; Newton is quadratic: after such a step the rest is rounding
STEP_LOST = 1e5  # mm and rad; a step of this size leads nowhere
ANGLE_STEP = 1e-3  # rad per mm: joints and rotations are asked for this much finer than lengths
CLOSED = 1e-3  # mm^2: loops that are open by more where Newton gets stuck cannot be closed
PIVOT_SINGULAR = 1e-9  # of the largest entry of its matrix, in mm
COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 12  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 9  # `exact_command` reads these first columns of k only


def constants(p):
    """Return k (M, 2, 11), what no pose changes, from p (23 operations).

    Plain NumPy over all rows at once: it runs once per machine, and compiling it would take longer than running it.
    """
    k = np.zeros((p.shape[0], 2, 11))
    base_x = p[..., 0]
    base_y = p[..., 1]
    L = p[..., 2]
    l = p[..., 3]
    side = p[..., 4]
    theta = p[..., 5]
    ex = p[..., 6]
    ey = p[..., 7]
    dL = p[..., 8]
    dl = p[..., 9]
    tip_v = p[..., 12]
    B_x = base_x*side + ex
    B_y = base_y + ey
    s3 = L + dL
    s6 = theta - 0.5*np.pi*(1 - side)
    s9 = s3*side
    s12 = -side*tip_v
    s26 = dl + l
    s28 = -0.5*(s26 * s26)
    s51 = -s26
    s59 = (side * side)
    s60 = (s3 * s3)
    s62 = s28 + 0.5*s59*s60
    s66 = s59*s60
    s71 = s3*s59
    k[..., 0] = s6
    k[..., 1] = s9
    k[..., 2] = s12
    k[..., 3] = B_x
    k[..., 4] = B_y
    k[..., 5] = s28
    k[..., 6] = s62
    k[..., 7] = s66
    k[..., 8] = s71
    k[..., 9] = side
    k[..., 10] = s51
    return k


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def _parameters(x, q, tool, k, out):
    """Per rod of one limb: derivatives of the closure by errors, by deflections (41 operations)."""
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
    side = k[9]
    s51 = k[10]
    s7 = q + s6
    s8 = math.cos(s7)
    s11 = math.sin(s7)
    C_x = B_x + s11*s12 + s8*s9
    C_y = B_y + s11*s9 - s12*s8
    A_x = px - tx
    A_y = py - ty
    d_x = A_x - C_x
    d_y = A_y - C_y
    s30 = 2*d_y
    s31 = 0.5*s30
    s32 = 2*d_x
    s33 = 0.5*s32
    s46 = -s11*(s12*s31 - s33*s9) + s8*(-s12*s33 - s31*s9)
    s50 = side*(-s11*s31 - s33*s8)
    s52 = -side*(-s11*s33 + s31*s8)
    out[0] = s46
    out[1] = -s33
    out[2] = -s31
    out[3] = s50
    out[4] = s51
    out[7] = s52


@njit(cache=True, nogil=True, error_model="numpy")
def _sphere(x, q, tool, k, out):
    """The simplified limb as a sphere |P|^2 / 2 - c.P + d = 0: c, d (15 operations)."""
    tx = tool[0]
    ty = tool[1]
    q = q
    s6 = k[0]
    s9 = k[1]
    B_x = k[3]
    B_y = k[4]
    s28 = k[5]
    s7 = q + s6
    s79 = B_x + s9*math.cos(s7) + tx
    s80 = B_y + s9*math.sin(s7) + ty
    s85 = s28 + 0.5*(s79 * s79) + 0.5*(s80 * s80)
    out[0] = s79
    out[1] = s80
    out[2] = s85


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def _closure(x, q, tool, k, out, F, J_x, J_q):
    """Fill closure F (2,), J_x (2, 2) and the joints' part J_q (2,) of one pose; k (2, :), out scratch."""
    for i in range(2):
        _newton(x, q[i], tool, k[i], out)
        for j in range(1):
            row, start = 1 * i + j, 4 * j
            F[row] = out[start]
            for c in range(2):
                J_x[row, c] = out[start + 1 + c]
            J_q[row] = out[start + 3]


@njit(cache=True, nogil=True, error_model="numpy")
def _solve(A, B, columns):
    """Solve A X = B in place by Gauss elimination with partial pivoting; X takes the place of B.

    Returns False where a pivot falls below PIVOT_SINGULAR of the largest entry of A: then A is singular to that tolerance.
    """
    largest = 0.0
    for r in range(2):
        for c in range(2):
            largest = max(largest, abs(A[r, c]))
    for c in range(2):
        pivot = c
        for r in range(c + 1, 2):
            if abs(A[r, c]) > abs(A[pivot, c]):
                pivot = r
        if not abs(A[pivot, c]) > PIVOT_SINGULAR * largest:
            return False
        if pivot != c:
            for j in range(c, 2):
                A[c, j], A[pivot, j] = A[pivot, j], A[c, j]
            for j in range(columns):
                B[c, j], B[pivot, j] = B[pivot, j], B[c, j]
        inverse = 1.0 / A[c, c]
        for r in range(c + 1, 2):
            factor = A[r, c] * inverse
            if factor != 0.0:
                for j in range(c + 1, 2):
                    A[r, j] -= factor * A[c, j]
                for j in range(columns):
                    B[r, j] -= factor * B[c, j]
    for c in range(1, -1, -1):
        inverse = 1.0 / A[c, c]
        for j in range(columns):
            B[c, j] *= inverse
        for r in range(c):
            factor = A[r, c]
            if factor != 0.0:
                for j in range(columns):
                    B[r, j] -= factor * B[c, j]
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def _stuck(F):
    """Return what a pose is where Newton's matrix is singular: SINGULAR if its loops are closed, else UNREACHABLE."""
    for r in range(2):
        if not abs(F[r]) < CLOSED:
            return UNREACHABLE
    return SINGULAR


@njit(cache=True, nogil=True, error_model="numpy")
def jacobians(x, q, tool, k, F, J_x, J_q, J_p):
    """Fill the closure F (N, 2) and its Jacobians J_x (N, 2, 2), J_q (N, 2), J_p (N, 2, 8).

    Rows 1 i .. 1 i + 0 belong to limb i and depend on its own joint, errors and deflections only:
    J_q and J_p hold the derivatives by those.
    """
    out, by_errors = np.zeros(4), np.zeros(8)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F[n], J_x[n], J_q[n])
        for i in range(2):
            _parameters(x[n], q[n, i], tool[n], k[m, i], by_errors)
            for j in range(1):
                for c in range(8):
                    J_p[n, 1 * i + j, c] = by_errors[8 * j + c]


@njit(cache=True, nogil=True, error_model="numpy")
def _meet(circle, pose):
    """Put the point where two circles meet into pose[:2]; False where their centres coincide.

    Their difference is a line, on which the first circle is a quadratic. Where the line misses the circle its nearest
    point is taken: the exact machine may still reach what the simplified one cannot.
    """
    ax, ay = circle[1, 0] - circle[0, 0], circle[1, 1] - circle[0, 1]
    aa = ax * ax + ay * ay
    size = circle[0, 0] ** 2 + circle[0, 1] ** 2 + circle[1, 0] ** 2 + circle[1, 1] ** 2
    if not aa > PIVOT_SINGULAR * size:
        return False
    along = (circle[1, 2] - circle[0, 2]) / aa
    px, py = along * ax, along * ay
    nx, ny = -ay, ax
    # |P + t n|^2 / 2 - c.(P + t n) + d = 0
    half = (px * nx + py * ny) - (circle[0, 0] * nx + circle[0, 1] * ny)
    rest = 0.5 * (px * px + py * py) - (circle[0, 0] * px + circle[0, 1] * py) + circle[0, 2]
    root = math.sqrt(max(half * half - 2.0 * aa * rest, 0.0))
    sign = -1.0 if ny > 0.0 else 1.0
    t = (-half + sign * root) / aa
    pose[0], pose[1] = px + t * nx, py + t * ny
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def forward(q, tool, k, x, status, warm):
    """Fill x (N, 2) with the exact platform pose at the joints q, by Newton from the simplified machine, or from x where warm.

    status (N,): SOLVED, UNREACHABLE (no platform pose closes all loops) or SINGULAR; x is NaN unless SOLVED.
    """
    F, J_q = np.empty(2), np.empty(2)
    J_x = np.empty((2, 2))
    step = np.empty((2, 1))
    out = np.zeros(4)
    pose = np.zeros(2)
    sphere = np.empty((2, 3))
    for n in range(q.shape[0]):
        m = n if k.shape[0] > 1 else 0
        seeded = True
        for c in range(2):
            pose[c] = x[n, c] if warm else 0.0
            seeded = seeded and math.isfinite(pose[c])
        if not (warm and seeded):
            pose[:] = 0.0
            for i in range(2):
                _sphere(pose, q[n, i], tool[n], k[m, i], sphere[i])
            seeded = _meet(sphere, pose)
        status[n] = UNREACHABLE if seeded else SINGULAR
        for _ in range(MAX_STEPS if seeded else 0):
            _closure(pose, q[n], tool[n], k[m], out, F, J_x, J_q)
            for r in range(2):
                step[r, 0] = F[r]
            if not _solve(J_x, step, 1):
                status[n] = _stuck(F)
                break
            size = 0.0
            for c in range(2):
                pose[c] -= step[c, 0]
                size = max(size, abs(step[c, 0]))
            if size < STEP_DONE:
                status[n] = SOLVED
                break
            if not size < STEP_LOST:
                break
        for c in range(2):
            x[n, c] = pose[c] if status[n] == SOLVED else np.nan


@njit(cache=True, nogil=True, error_model="numpy")
def inverse(target, tool, k, x, q, status):
    """Fill the joints q (N, 2) that bring the reference point to target (N, 2), and the pose x (N, 2) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    F, J_q = np.empty(2), np.empty(2)
    J_x = np.empty((2, 2))
    A = np.empty((2, 2))
    step = np.empty((2, 1))
    out = np.zeros(4)
    pose, joints, start = np.zeros(2), np.empty(2), np.zeros(1)
    for n in range(target.shape[0]):
        m = n if k.shape[0] > 1 else 0
        pose[:] = 0.0
        for c in range(2):
            pose[c] = target[n, c]
        seeded = True
        for i in range(2):
            _joint(pose, 0.0, tool[n], k[m, i], start)
            joints[i] = start[0]
            seeded = seeded and math.isfinite(joints[i])
        status[n] = UNREACHABLE
        for _ in range(MAX_STEPS if seeded else 0):
            _closure(pose, joints, tool[n], k[m], out, F, J_x, J_q)
            A[:] = 0.0
            for r in range(2):
                A[r, r // 1] = J_q[r]
                for c in range(0):
                    A[r, 2 + c] = J_x[r, 2 + c]
                step[r, 0] = F[r]
            if not _solve(A, step, 1):
                status[n] = _stuck(F)
                break
            size = 0.0
            for c in range(2):
                joints[c] -= step[c, 0]
                size = max(size, abs(step[c, 0]))
            for c in range(0):
                pose[2 + c] -= step[2 + c, 0]
                size = max(size, abs(step[2 + c, 0]))
            if size < STEP_DONE * ANGLE_STEP:
                status[n] = SOLVED
                break
            if not size < STEP_LOST:
                break
        for c in range(2):
            q[n, c] = joints[c] if status[n] == SOLVED else np.nan
        for c in range(2):
            x[n, c] = pose[c] if status[n] == SOLVED else np.nan


@njit(cache=True, nogil=True, error_model="numpy")
def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 2, 16) by errors and deflections, S_q (N, 2, 2) by joints.

    ``J_x S = -J``. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    F, J_q = np.empty(2), np.empty(2)
    J_x = np.empty((2, 2))
    unit = np.empty((2, 2))
    out = np.zeros(4)
    J_p = np.zeros(8)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F, J_x, J_q)
        unit[:] = 0.0
        for r in range(2):
            unit[r, r] = -1.0
        status[n] = SOLVED if _solve(J_x, unit, 2) else SINGULAR
        for i in range(2):
            _parameters(x[n], q[n, i], tool[n], k[m, i], J_p)
            for r in range(2):
                for c in range(8):
                    total = 0.0
                    for j in range(1):
                        total += unit[r, 1 * i + j] * J_p[8 * j + c]
                    S_p[n, r, 8 * i + c] = total if status[n] == SOLVED else np.nan
                total = 0.0
                for j in range(1):
                    total += unit[r, 1 * i + j] * J_q[1 * i + j]
                S_q[n, r, i] = total if status[n] == SOLVED else np.nan


def linear_constants(p):
    """Return k (M, 2, 13), what `linear` reads that no pose changes, from p (23 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    k = np.zeros((p.shape[0], 2, 13))
    base_x = p[..., 0]
    base_y = p[..., 1]
    L = p[..., 2]
    l = p[..., 3]
    side = p[..., 4]
    theta = p[..., 5]
    ex = p[..., 6]
    ey = p[..., 7]
    dL = p[..., 8]
    dl = p[..., 9]
    tip_v = p[..., 12]
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
    k[..., 0] = base_y
    k[..., 1] = B_x
    k[..., 2] = s38
    k[..., 3] = s5
    k[..., 4] = s42
    k[..., 5] = s47
    k[..., 6] = s2
    k[..., 7] = s10
    k[..., 8] = s12
    k[..., 9] = s14
    k[..., 10] = ex
    k[..., 11] = ey
    k[..., 12] = s57
    return k


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 2) and status (N,) by `linear_command`; target (N, 2) and tool (N, 3), k (M, 2, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])
