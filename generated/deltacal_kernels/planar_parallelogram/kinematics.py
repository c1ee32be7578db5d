"""Kinematics of `planar_parallelogram`: Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both a03a66a7e4c8d758; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 3)  platform: px py cz
q (N, 1)  joints        tool (N, 3)  reference point in {O'}
p (M, 1, 18)  one row of parameters per limb: a1x a2x a2y b1x b2x b2y l1 l2 h q0 a1x a2x a2y b1x b2x b2y l1 l2
k (M, 1, 28)  what `constants` makes of p; M is 1 (one machine) or N (parameters that change from pose to pose)

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
COMMAND_CONSTANTS = 26  # `exact_command` reads these first columns of k only


def constants(p):
    """Return k (M, 1, 28), what no pose changes, from p (91 operations).

    Plain NumPy over all rows at once: it runs once per machine, and compiling it would take longer than running it.
    """
    k = np.zeros((p.shape[0], 1, 28))
    a1x = p[..., 0]
    a2x = p[..., 1]
    a2y = p[..., 2]
    b1x = p[..., 3]
    b2x = p[..., 4]
    b2y = p[..., 5]
    l1 = p[..., 6]
    l2 = p[..., 7]
    h = p[..., 8]
    q0 = p[..., 9]
    da1x = p[..., 10]
    da2x = p[..., 11]
    da2y = p[..., 12]
    db1x = p[..., 13]
    db2x = p[..., 14]
    db2y = p[..., 15]
    dl1 = p[..., 16]
    dl2 = p[..., 17]
    A1_x = -a1x - da1x
    A2_x = a2x + da2x
    A2_y = a2y + da2y
    b1_x = -b1x - db1x
    b2_x = b2x + db2x
    b2_y = b2y + db2y
    s7 = dl1 + l1
    s67 = dl2 + l2
    s69 = -0.5*(s67 * s67)
    s101 = -s67
    s102 = (1.0 / s7)
    s103 = -A1_x + b1_x
    s108 = (1.0 / (s7 * s7))
    s116 = -2*b2_y
    s120 = -2*b2_x*s7
    s122 = 2*b1_x*s7
    s124 = -2*A1_x*b2_y + 2*A2_x*b2_y + 2*A2_y*b1_x - 2*A2_y*b2_x
    s130 = -2*b1_x
    s133 = 2*A1_x*b2_x
    s134 = 2*b2_x
    s136 = -2*b2_y*s7
    s138 = -2*A1_x*b1_x + 2*A2_x*b1_x - 2*A2_x*b2_x - 2*A2_y*b2_y + s133
    s143 = (b2_x * b2_x)
    s144 = (b2_y * b2_y)
    s145 = (A1_x * A1_x)
    s146 = (b1_x * b1_x)
    s147 = (dl2 * dl2)
    s148 = (l2 * l2)
    s149 = (s7 * s7)
    s151 = -2*dl2*l2
    s152 = -2*A1_x*A2_x
    s153 = -2*A2_x
    s155 = -2*b1_x*b2_x
    s156 = 2*A1_x
    s158 = 2*A2_y*s7
    s160 = (A2_x * A2_x) + (A2_y * A2_y) + s143 + s144 + s145 + s146 - s147 - s148 + s151 + s152 + s155
    s195 = -2*A2_y
    k[..., 0] = h
    k[..., 1] = q0
    k[..., 2] = s7
    k[..., 3] = b1_x
    k[..., 4] = b2_x
    k[..., 5] = b2_y
    k[..., 6] = A2_x
    k[..., 7] = A2_y
    k[..., 8] = A1_x
    k[..., 9] = s69
    k[..., 10] = s103
    k[..., 11] = s102
    k[..., 12] = s108
    k[..., 13] = s116
    k[..., 14] = s120
    k[..., 15] = s122
    k[..., 16] = s124
    k[..., 17] = s130
    k[..., 18] = s134
    k[..., 19] = s136
    k[..., 20] = s138
    k[..., 21] = s149
    k[..., 22] = s153
    k[..., 23] = s156
    k[..., 24] = s158
    k[..., 25] = s160
    k[..., 26] = s101
    k[..., 27] = s195
    return k


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def _parameters(x, q, tool, k, out):
    """Per rod of one limb: derivatives of the closure by errors, by deflections (45 operations)."""
    px = x[0]
    py = x[1]
    cz = x[2]
    tx = tool[0]
    ty = tool[1]
    q = q
    h = k[0]
    q0 = k[1]
    s7 = k[2]
    b2_x = k[4]
    b2_y = k[5]
    A2_x = k[6]
    A2_y = k[7]
    s101 = k[26]
    C_y = -h + ty
    s8 = q + q0
    s9 = math.sin(s8)
    r1_x = s7*s9
    s11 = math.cos(s8)
    r1_y = -s11*s7
    s13 = (cz * cz)
    s16 = (1.0 / (0.25*s13 + 1))
    s18 = -0.5*s13*s16 + 1
    s26 = b2_x - tx
    s28 = -C_y + b2_y
    B2_x = -cz*s16*s28 + px + s18*s26
    B2_y = cz*s16*s26 + py + s18*s28
    r2_x = -A2_x + B2_x
    r2_y = -A2_y + B2_y
    s37 = cz*s16
    s71 = 2*r2_y
    s72 = 0.5*s71
    s73 = 2*r2_x
    s74 = 0.5*s73
    s87 = s18*s72 - s37*s74
    s90 = s18*s74 + s37*s72
    out[0] = r1_y
    out[1] = 1
    out[4] = -s18
    out[7] = -s9
    out[9] = -r1_x
    out[13] = -s37
    out[16] = s11
    out[20] = -s74
    out[21] = -s72
    out[23] = s90
    out[24] = s87
    out[26] = s101


@njit(cache=True, nogil=True, error_model="numpy")
def _position(x, q, tool, k, out):
    """Platform of the simplified machine at a given joint (67 operations)."""
    tx = tool[0]
    ty = tool[1]
    q = q
    h = k[0]
    q0 = k[1]
    s7 = k[2]
    b1_x = k[3]
    A1_x = k[8]
    s116 = k[13]
    s124 = k[16]
    s130 = k[17]
    s134 = k[18]
    s138 = k[20]
    s153 = k[22]
    s156 = k[23]
    s160 = k[25]
    s195 = k[27]
    C_y = -h + ty
    s8 = q + q0
    r1_x = s7*math.sin(s8)
    r1_y = -s7*math.cos(s8)
    s19 = b1_x - tx
    s185 = r1_x*s116 + r1_y*s130 + r1_y*s134 + s124
    s190 = r1_x*s130 + r1_x*s134 - r1_y*s116 + s138
    s198 = (r1_x * r1_x) + r1_x*s153 + r1_x*s156 + (r1_y * r1_y) + r1_y*s195 + s160
    s201 = math.sqrt((s185 * s185) + (s190 * s190) - (s198 * s198))
    s204 = -s185*s198 + s190*s201
    s208 = -s185*s201 - s190*s198
    s211 = 1/math.sqrt((s204 * s204) + (s208 * s208))
    s214 = A1_x - C_y*s204*s211 + r1_x - s19*s208*s211
    s217 = C_y*s208*s211 + r1_y - s19*s204*s211
    s221 = 2*math.tan(0.5*math.atan2(s204, s208))
    out[0] = s214
    out[1] = s217
    out[2] = s221


@njit(cache=True, nogil=True, error_model="numpy")
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
    """Fill the closure F (N, 3) and its Jacobians J_x (N, 3, 3), J_q (N, 3), J_p (N, 3, 9).

    Rows 3 i .. 3 i + 2 belong to limb i and depend on its own joint, errors and deflections only:
    J_q and J_p hold the derivatives by those.
    """
    out, by_errors = np.zeros(15), np.zeros(27)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F[n], J_x[n], J_q[n])
        for i in range(1):
            _parameters(x[n], q[n, i], tool[n], k[m, i], by_errors)
            for j in range(3):
                for c in range(9):
                    J_p[n, 3 * i + j, c] = by_errors[9 * j + c]


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
    """Fill the derivatives of the exact pose: S_p (N, 3, 9) by errors and deflections, S_q (N, 3, 1) by joints.

    ``J_x S = -J``. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    F, J_q = np.empty(3), np.empty(3)
    J_x = np.empty((3, 3))
    unit = np.empty((3, 3))
    out = np.zeros(15)
    J_p = np.zeros(27)
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
                for c in range(9):
                    total = 0.0
                    for j in range(3):
                        total += unit[r, 3 * i + j] * J_p[9 * j + c]
                    S_p[n, r, 9 * i + c] = total if status[n] == SOLVED else np.nan
                total = 0.0
                for j in range(3):
                    total += unit[r, 3 * i + j] * J_q[3 * i + j]
                S_q[n, r, i] = total if status[n] == SOLVED else np.nan


def linear_constants(p):
    """Return k (M, 1, 28), what `linear` reads that no pose changes, from p (68 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    k = np.zeros((p.shape[0], 1, 28))
    a1x = p[..., 0]
    a2x = p[..., 1]
    a2y = p[..., 2]
    b1x = p[..., 3]
    b2x = p[..., 4]
    b2y = p[..., 5]
    l1 = p[..., 6]
    l2 = p[..., 7]
    h = p[..., 8]
    q0 = p[..., 9]
    da1x = p[..., 10]
    da2x = p[..., 11]
    da2y = p[..., 12]
    db1x = p[..., 13]
    db2x = p[..., 14]
    db2y = p[..., 15]
    dl1 = p[..., 16]
    dl2 = p[..., 17]
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
    k[..., 0] = s137
    k[..., 1] = s136
    k[..., 2] = l1
    k[..., 3] = s6
    k[..., 4] = s8
    k[..., 5] = s11
    k[..., 6] = s13
    k[..., 7] = s24
    k[..., 8] = s34
    k[..., 9] = s41
    k[..., 10] = s43
    k[..., 11] = s45
    k[..., 12] = s47
    k[..., 13] = b1x
    k[..., 14] = h
    k[..., 15] = dl1
    k[..., 16] = s75
    k[..., 17] = db1x
    k[..., 18] = b2x
    k[..., 19] = b2y
    k[..., 20] = db2x
    k[..., 21] = db2y
    k[..., 22] = a2x
    k[..., 23] = da2x
    k[..., 24] = a2y
    k[..., 25] = da2y
    k[..., 26] = da1x
    k[..., 27] = s145
    return k


@njit(cache=True, nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (4 operations); limb i of k, row i of out."""
    px = x[0]
    tx = tool[0]
    s137 = k[i, 0]
    s136 = k[i, 1]
    s140 = math.asin(s136*(px + s137 - tx))
    row = 1 * i
    out[row + 0] = s140


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 1) and status (N,) by `linear_command`; target (N, 1) and tool (N, 3), k (M, 1, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])
