"""Kinematics of `simplified_parallelogram`: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 879a3b286b3322d4; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 3)  platform: px py cz
q (N, 1)  joints        tool (N, 3)  reference point in {O'}
p (M, 1, 11)  one row of parameters per limb: a1x a2x a2y b1x b2x b2y l1 l2 h q0 l1
k (M, 1, 6)  what `constants` makes of p; M is 1 (one machine) or N (parameters that change from pose to pose)

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
COMMAND_WORK = 27  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 6  # `exact_command` reads these first columns of k only


def constants(p):
    """Return k (M, 1, 6), what no pose changes, from p (5 operations).

    Plain NumPy over all rows at once: it runs once per machine, and compiling it would take longer than running it.
    """
    k = np.zeros((p.shape[0], 1, 6))
    a1x = p[..., 0]
    b1x = p[..., 3]
    l1 = p[..., 6]
    h = p[..., 8]
    q0 = p[..., 9]
    dl1 = p[..., 10]
    s0 = dl1 + l1
    s4 = a1x - b1x
    s9 = (1.0 / s0)
    s14 = (1.0 / (s0 * s0))
    k[..., 0] = q0
    k[..., 1] = s0
    k[..., 2] = s4
    k[..., 3] = h
    k[..., 4] = s9
    k[..., 5] = s14
    return k


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def _parameters(x, q, tool, k, out):
    """Per rod of one limb: derivatives of the closure by errors, by deflections (8 operations)."""
    q = q
    q0 = k[0]
    s0 = k[1]
    s1 = q + q0
    s2 = math.sin(s1)
    s3 = -s0*s2
    s6 = math.cos(s1)
    s7 = -s0*s6
    out[0] = s7
    out[1] = -s2
    out[2] = s3
    out[3] = s6


@njit(cache=True, nogil=True, error_model="numpy")
def _position(x, q, tool, k, out):
    """Platform of the simplified machine at a given joint (9 operations)."""
    tx = tool[0]
    ty = tool[1]
    q = q
    q0 = k[0]
    s0 = k[1]
    s4 = k[2]
    h = k[3]
    s1 = q + q0
    s21 = s0*math.sin(s1) - s4 + tx
    s22 = -h - s0*math.cos(s1) + ty
    out[0] = s21
    out[1] = s22


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def _closure(x, q, tool, k, out, F, J_x, J_q):
    """Fill closure F (3,), J_x (3, 3) and the joints' part J_q (3,) of one pose; k (1, :), out scratch."""
    for i in range(1):
        _newton(x, q[i], tool, k[i], out)
        for j in range(3):
            row, start = 3 * i + j, 5 * j
            F[row] = out[start]
            for c in range(3):
                J_x[row, c] = out[start + 1 + c]
            J_q[row] = out[start + 4]


@njit(cache=True, nogil=True, error_model="numpy")
def _solve(A, B, columns):
    """Solve A X = B in place by Gauss elimination with partial pivoting; X takes the place of B.

    Returns False where a pivot falls below PIVOT_SINGULAR of the largest entry of A: then A is singular to that tolerance.
    """
    largest = 0.0
    for r in range(3):
        for c in range(3):
            largest = max(largest, abs(A[r, c]))
    for c in range(3):
        pivot = c
        for r in range(c + 1, 3):
            if abs(A[r, c]) > abs(A[pivot, c]):
                pivot = r
        if not abs(A[pivot, c]) > PIVOT_SINGULAR * largest:
            return False
        if pivot != c:
            for j in range(c, 3):
                A[c, j], A[pivot, j] = A[pivot, j], A[c, j]
            for j in range(columns):
                B[c, j], B[pivot, j] = B[pivot, j], B[c, j]
        inverse = 1.0 / A[c, c]
        for r in range(c + 1, 3):
            factor = A[r, c] * inverse
            if factor != 0.0:
                for j in range(c + 1, 3):
                    A[r, j] -= factor * A[c, j]
                for j in range(columns):
                    B[r, j] -= factor * B[c, j]
    for c in range(2, -1, -1):
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
    for r in range(3):
        if not abs(F[r]) < CLOSED:
            return UNREACHABLE
    return SINGULAR


@njit(cache=True, nogil=True, error_model="numpy")
def jacobians(x, q, tool, k, F, J_x, J_q, J_p):
    """Fill the closure F (N, 3) and its Jacobians J_x (N, 3, 3), J_q (N, 3), J_p (N, 3, 2).

    Rows 3 i .. 3 i + 2 belong to limb i and depend on its own joint, errors and deflections only:
    J_q and J_p hold the derivatives by those.
    """
    out, by_errors = np.zeros(15), np.zeros(6)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F[n], J_x[n], J_q[n])
        for i in range(1):
            _parameters(x[n], q[n, i], tool[n], k[m, i], by_errors)
            for j in range(3):
                for c in range(2):
                    J_p[n, 3 * i + j, c] = by_errors[2 * j + c]


@njit(cache=True, nogil=True, error_model="numpy")
def forward(q, tool, k, x, status, warm):
    """Fill x (N, 3) with the exact platform pose at the joints q, by Newton from the simplified machine, or from x where warm.

    status (N,): SOLVED, UNREACHABLE (no platform pose closes all loops) or SINGULAR; x is NaN unless SOLVED.
    """
    F, J_q = np.empty(3), np.empty(3)
    J_x = np.empty((3, 3))
    step = np.empty((3, 1))
    out = np.zeros(15)
    pose = np.zeros(3)
    for n in range(q.shape[0]):
        m = n if k.shape[0] > 1 else 0
        seeded = True
        for c in range(3):
            pose[c] = x[n, c] if warm else 0.0
            seeded = seeded and math.isfinite(pose[c])
        if not (warm and seeded):
            pose[:] = 0.0
            _position(pose, q[n, 0], tool[n], k[m, 0], pose)
            seeded = np.isfinite(pose).all()
        status[n] = UNREACHABLE
        for _ in range(MAX_STEPS if seeded else 0):
            _closure(pose, q[n], tool[n], k[m], out, F, J_x, J_q)
            for r in range(3):
                step[r, 0] = F[r]
            if not _solve(J_x, step, 1):
                status[n] = _stuck(F)
                break
            size = 0.0
            for c in range(3):
                pose[c] -= step[c, 0]
                size = max(size, abs(step[c, 0]))
            if size < STEP_DONE:
                status[n] = SOLVED
                break
            if not size < STEP_LOST:
                break
        for c in range(3):
            x[n, c] = pose[c] if status[n] == SOLVED else np.nan


@njit(cache=True, nogil=True, error_model="numpy")
def inverse(target, tool, k, x, q, status):
    """Fill the joints q (N, 1) that bring the reference point to target (N, 1), and the pose x (N, 3) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    F, J_q = np.empty(3), np.empty(3)
    J_x = np.empty((3, 3))
    A = np.empty((3, 3))
    step = np.empty((3, 1))
    out = np.zeros(15)
    pose, joints, start = np.zeros(3), np.empty(1), np.zeros(3)
    for n in range(target.shape[0]):
        m = n if k.shape[0] > 1 else 0
        pose[:] = 0.0
        for c in range(1):
            pose[c] = target[n, c]
        seeded = True
        for i in range(1):
            _joint(pose, 0.0, tool[n], k[m, i], start)
            joints[i] = start[0]
            seeded = seeded and math.isfinite(joints[i])
        pose[1] = start[1]
        pose[2] = start[2]
        status[n] = UNREACHABLE
        for _ in range(MAX_STEPS if seeded else 0):
            _closure(pose, joints, tool[n], k[m], out, F, J_x, J_q)
            A[:] = 0.0
            for r in range(3):
                A[r, r // 3] = J_q[r]
                for c in range(2):
                    A[r, 1 + c] = J_x[r, 1 + c]
                step[r, 0] = F[r]
            if not _solve(A, step, 1):
                status[n] = _stuck(F)
                break
            size = 0.0
            for c in range(1):
                joints[c] -= step[c, 0]
                size = max(size, abs(step[c, 0]))
            for c in range(2):
                pose[1 + c] -= step[1 + c, 0]
                size = max(size, abs(step[1 + c, 0]))
            if size < STEP_DONE * ANGLE_STEP:
                status[n] = SOLVED
                break
            if not size < STEP_LOST:
                break
        for c in range(1):
            q[n, c] = joints[c] if status[n] == SOLVED else np.nan
        for c in range(3):
            x[n, c] = pose[c] if status[n] == SOLVED else np.nan


@njit(cache=True, nogil=True, error_model="numpy")
def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 3, 2) by errors and deflections, S_q (N, 3, 1) by joints.

    ``J_x S = -J``. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    F, J_q = np.empty(3), np.empty(3)
    J_x = np.empty((3, 3))
    unit = np.empty((3, 3))
    out = np.zeros(15)
    J_p = np.zeros(6)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F, J_x, J_q)
        unit[:] = 0.0
        for r in range(3):
            unit[r, r] = -1.0
        status[n] = SOLVED if _solve(J_x, unit, 3) else SINGULAR
        for i in range(1):
            _parameters(x[n], q[n, i], tool[n], k[m, i], J_p)
            for r in range(3):
                for c in range(2):
                    total = 0.0
                    for j in range(3):
                        total += unit[r, 3 * i + j] * J_p[2 * j + c]
                    S_p[n, r, 2 * i + c] = total if status[n] == SOLVED else np.nan
                total = 0.0
                for j in range(3):
                    total += unit[r, 3 * i + j] * J_q[3 * i + j]
                S_q[n, r, i] = total if status[n] == SOLVED else np.nan


def linear_constants(p):
    """Return k (M, 1, 5), what `linear` reads that no pose changes, from p (4 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    k = np.zeros((p.shape[0], 1, 5))
    a1x = p[..., 0]
    b1x = p[..., 3]
    l1 = p[..., 6]
    q0 = p[..., 9]
    dl1 = p[..., 10]
    s3 = (1.0 / l1)
    s4 = a1x - b1x
    s10 = -l1*q0
    k[..., 0] = s4
    k[..., 1] = s3
    k[..., 2] = l1
    k[..., 3] = dl1
    k[..., 4] = s10
    return k


@njit(cache=True, nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (4 operations); limb i of k, row i of out."""
    px = x[0]
    tx = tool[0]
    s4 = k[i, 0]
    s3 = k[i, 1]
    s7 = math.asin(s3*(px + s4 - tx))
    row = 1 * i
    out[row + 0] = s7


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 1) and status (N,) by `linear_command`; target (N, 1) and tool (N, 3), k (M, 1, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])
