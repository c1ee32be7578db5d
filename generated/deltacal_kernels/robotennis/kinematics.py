"""Kinematics of `robotennis`: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both f832e1387a2532d1; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 3)  platform: px py pz
q (N, 3)  joints        tool (N, 3)  reference point in {O'}
p (M, 3, 17)  one row of parameters per limb: a b h H phi hx hy hz a b h theta0 px0 py0 pz0 tip_v tip_w
k (M, 3, 23)  what `constants` makes of p; M is 1 (one machine) or N (parameters that change from pose to pose)

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
COMMAND_WORK = 21  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 22  # `exact_command` reads these first columns of k only


def constants(p):
    """Return k (M, 3, 23), what no pose changes, from p (44 operations).

    Plain NumPy over all rows at once: it runs once per machine, and compiling it would take longer than running it.
    """
    k = np.zeros((p.shape[0], 3, 23))
    a = p[..., 0]
    b = p[..., 1]
    h = p[..., 2]
    H = p[..., 3]
    phi = p[..., 4]
    da = p[..., 8]
    db = p[..., 9]
    dh = p[..., 10]
    theta0 = p[..., 11]
    px0 = p[..., 12]
    py0 = p[..., 13]
    pz0 = p[..., 14]
    tip_v = p[..., 15]
    tip_w = p[..., 16]
    s0 = np.cos(phi)
    A_x = H*s0
    s2 = np.sin(phi)
    A_y = H*s2
    s9 = a + da
    s12 = -s0*tip_v
    s14 = A_x + s2*tip_w
    s18 = -s2*tip_v
    s20 = A_y - s0*tip_w
    s28 = dh + h
    s29 = s0*s28
    s31 = s2*s28
    s42 = b + db
    s44 = -0.5*(s42 * s42)
    s75 = -s42
    s85 = -A_x + px0 + s29
    s87 = -s0*s9
    s89 = -A_y + py0 + s31
    s91 = -s2*s9
    s106 = s44 + 0.5*(s9 * s9)*((s0 * s0) + (s2 * s2))
    s111 = -2*a - 2*da
    s113 = 0.25*(s111 * s111)
    s118 = -0.5*s111
    k[..., 0] = theta0
    k[..., 1] = s0
    k[..., 2] = s2
    k[..., 3] = s9
    k[..., 4] = s12
    k[..., 5] = s14
    k[..., 6] = s18
    k[..., 7] = s20
    k[..., 8] = tip_v
    k[..., 9] = px0
    k[..., 10] = py0
    k[..., 11] = pz0
    k[..., 12] = s29
    k[..., 13] = s31
    k[..., 14] = s44
    k[..., 15] = s85
    k[..., 16] = s87
    k[..., 17] = s89
    k[..., 18] = s91
    k[..., 19] = s106
    k[..., 20] = s113
    k[..., 21] = s118
    k[..., 22] = s75
    return k


@njit(cache=True, nogil=True, error_model="numpy")
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
    s0 = k[1]
    s2 = k[2]
    s9 = k[3]
    s12 = k[4]
    s14 = k[5]
    s18 = k[6]
    s20 = k[7]
    tip_v = k[8]
    px0 = k[9]
    py0 = k[10]
    pz0 = k[11]
    s29 = k[12]
    s31 = k[13]
    s44 = k[14]
    s4 = q + theta0
    s5 = math.cos(s4)
    arm_x = s0*s5
    arm_y = s2*s5
    arm_z = math.sin(s4)
    B_x = arm_x*s9 + arm_z*s12 + s14
    B_y = arm_y*s9 + arm_z*s18 + s20
    B_z = arm_z*s9 + s5*tip_v
    centre_x = px + px0 - tx
    centre_y = py + py0 - ty
    centre_z = pz + pz0 - tz
    C_x = centre_x + s29
    C_y = centre_y + s31
    rod_x = -B_x + C_x
    rod_y = -B_y + C_y
    rod_z = -B_z + centre_z
    s45 = 0.5*(rod_x * rod_x) + 0.5*(rod_y * rod_y) + 0.5*(rod_z * rod_z) + s44
    s46 = 2*rod_z
    s47 = 0.5*s46
    s48 = 2*rod_y
    s49 = 0.5*s48
    s50 = 2*rod_x
    s51 = 0.5*s50
    s71 = -arm_z*(-s0*s51*s9 - s2*s49*s9 - s47*tip_v)
    s72 = s5*(-s12*s51 - s18*s49 - s47*s9) + s71
    out[0] = s45
    out[1] = s51
    out[2] = s49
    out[3] = s47
    out[4] = s72


@njit(cache=True, nogil=True, error_model="numpy")
def _parameters(x, q, tool, k, out):
    """Per rod of one limb: derivatives of the closure by errors, by deflections (70 operations)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    q = q
    theta0 = k[0]
    s0 = k[1]
    s2 = k[2]
    s9 = k[3]
    s12 = k[4]
    s14 = k[5]
    s18 = k[6]
    s20 = k[7]
    tip_v = k[8]
    px0 = k[9]
    py0 = k[10]
    pz0 = k[11]
    s29 = k[12]
    s31 = k[13]
    s75 = k[22]
    s4 = q + theta0
    s5 = math.cos(s4)
    arm_x = s0*s5
    arm_y = s2*s5
    arm_z = math.sin(s4)
    B_x = arm_x*s9 + arm_z*s12 + s14
    B_y = arm_y*s9 + arm_z*s18 + s20
    B_z = arm_z*s9 + s5*tip_v
    centre_x = px + px0 - tx
    centre_y = py + py0 - ty
    centre_z = pz + pz0 - tz
    C_x = centre_x + s29
    C_y = centre_y + s31
    rod_x = -B_x + C_x
    rod_y = -B_y + C_y
    rod_z = -B_z + centre_z
    s46 = 2*rod_z
    s47 = 0.5*s46
    s48 = 2*rod_y
    s49 = 0.5*s48
    s50 = 2*rod_x
    s51 = 0.5*s50
    s71 = -arm_z*(-s0*s51*s9 - s2*s49*s9 - s47*tip_v)
    s72 = s5*(-s12*s51 - s18*s49 - s47*s9) + s71
    s73 = -arm_x*s51 - arm_y*s49 - arm_z*s47
    s78 = s0*s51 + s2*s49
    s81 = arm_z*s0*s51 + arm_z*s2*s49 - s47*s5
    s84 = s0*s49 - s2*s51
    out[0] = s73
    out[1] = s75
    out[2] = s78
    out[3] = s72
    out[4] = s51
    out[5] = s49
    out[6] = s47
    out[7] = s81
    out[8] = s84


@njit(cache=True, nogil=True, error_model="numpy")
def _sphere(x, q, tool, k, out):
    """The simplified limb as a sphere |P|^2 / 2 - c.P + d = 0: c, d (21 operations)."""
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    q = q
    theta0 = k[0]
    s9 = k[3]
    pz0 = k[11]
    s44 = k[14]
    s85 = k[15]
    s87 = k[16]
    s89 = k[17]
    s91 = k[18]
    s4 = q + theta0
    s5 = math.cos(s4)
    arm_z = math.sin(s4)
    s127 = -s5*s87 - s85 + tx
    s129 = -s5*s91 - s89 + ty
    s130 = arm_z*s9 - pz0 + tz
    s137 = 0.5*(s127 * s127) + 0.5*(s129 * s129) + 0.5*(s130 * s130) + s44
    out[0] = s127
    out[1] = s129
    out[2] = s130
    out[3] = s137


@njit(cache=True, nogil=True, error_model="numpy")
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
    s85 = k[15]
    s87 = k[16]
    s89 = k[17]
    s91 = k[18]
    s106 = k[19]
    s113 = k[20]
    s118 = k[21]
    centre_z = pz + pz0 - tz
    s86 = px + s85 - tx
    s90 = py + s89 - ty
    s93 = s86*s87 + s90*s91
    s95 = (centre_z * centre_z)
    s107 = s106 + 0.5*(s86 * s86) + 0.5*(s90 * s90) + 0.5*s95
    s116 = math.sqrt(-(s107 * s107) + s113*s95 + (s93 * s93))
    s125 = -theta0 + math.atan2(centre_z*s107*s118 + s116*s93, centre_z*s116*s118 - s107*s93)
    out[0] = s125


@njit(cache=True, nogil=True, error_model="numpy")
def _closure(x, q, tool, k, out, F, J_x, J_q):
    """Fill closure F (3,), J_x (3, 3) and the joints' part J_q (3,) of one pose; k (3, :), out scratch."""
    for i in range(3):
        _newton(x, q[i], tool, k[i], out)
        for j in range(1):
            row, start = 1 * i + j, 5 * j
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

    Rows 1 i .. 1 i + 0 belong to limb i and depend on its own joint, errors and deflections only:
    J_q and J_p hold the derivatives by those.
    """
    out, by_errors = np.zeros(5), np.zeros(9)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F[n], J_x[n], J_q[n])
        for i in range(3):
            _parameters(x[n], q[n, i], tool[n], k[m, i], by_errors)
            for j in range(1):
                for c in range(9):
                    J_p[n, 1 * i + j, c] = by_errors[9 * j + c]


@njit(cache=True, nogil=True, error_model="numpy")
def _meet(sphere, pose):
    """Put the position where three spheres meet into pose[:3]; False where their centres lie on one line.

    Differences of the spheres are planes; two planes are a line, on which the first sphere is a quadratic. Where the
    line misses the sphere its nearest point is taken: the exact machine may still reach what the simplified one
    cannot.
    """
    ax, ay, az = sphere[1, 0] - sphere[0, 0], sphere[1, 1] - sphere[0, 1], sphere[1, 2] - sphere[0, 2]
    bx, by, bz = sphere[2, 0] - sphere[0, 0], sphere[2, 1] - sphere[0, 1], sphere[2, 2] - sphere[0, 2]
    da, db = sphere[1, 3] - sphere[0, 3], sphere[2, 3] - sphere[0, 3]
    nx, ny, nz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    nn = nx * nx + ny * ny + nz * nz
    aa = ax * ax + ay * ay + az * az
    bb = bx * bx + by * by + bz * bz
    if not nn > PIVOT_SINGULAR * aa * bb:
        return False
    # the point of the line in the plane of a and b: u a + v b with a.P = da, b.P = db
    ab = ax * bx + ay * by + az * bz
    u = (da * bb - db * ab) / nn
    v = (db * aa - da * ab) / nn
    px, py, pz = u * ax + v * bx, u * ay + v * by, u * az + v * bz
    # |P + t n|^2 / 2 - c.(P + t n) + d = 0
    half = (px * nx + py * ny + pz * nz) - (sphere[0, 0] * nx + sphere[0, 1] * ny + sphere[0, 2] * nz)
    rest = 0.5 * (px * px + py * py + pz * pz) - (sphere[0, 0] * px + sphere[0, 1] * py + sphere[0, 2] * pz) + sphere[0, 3]
    root = math.sqrt(max(half * half - 2.0 * nn * rest, 0.0))
    sign = 1.0 if nz > 0.0 else -1.0
    t = (-half + sign * root) / nn
    pose[0], pose[1], pose[2] = px + t * nx, py + t * ny, pz + t * nz
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def forward(q, tool, k, x, status, warm):
    """Fill x (N, 3) with the exact platform pose at the joints q, by Newton from the simplified machine, or from x where warm.

    status (N,): SOLVED, UNREACHABLE (no platform pose closes all loops) or SINGULAR; x is NaN unless SOLVED.
    """
    F, J_q = np.empty(3), np.empty(3)
    J_x = np.empty((3, 3))
    step = np.empty((3, 1))
    out = np.zeros(5)
    pose = np.zeros(3)
    sphere = np.empty((3, 4))
    for n in range(q.shape[0]):
        m = n if k.shape[0] > 1 else 0
        seeded = True
        for c in range(3):
            pose[c] = x[n, c] if warm else 0.0
            seeded = seeded and math.isfinite(pose[c])
        if not (warm and seeded):
            pose[:] = 0.0
            for i in range(3):
                _sphere(pose, q[n, i], tool[n], k[m, i], sphere[i])
            seeded = _meet(sphere, pose)
        status[n] = UNREACHABLE if seeded else SINGULAR
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
    """Fill the joints q (N, 3) that bring the reference point to target (N, 3), and the pose x (N, 3) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    F, J_q = np.empty(3), np.empty(3)
    J_x = np.empty((3, 3))
    A = np.empty((3, 3))
    step = np.empty((3, 1))
    out = np.zeros(5)
    pose, joints, start = np.zeros(3), np.empty(3), np.zeros(1)
    for n in range(target.shape[0]):
        m = n if k.shape[0] > 1 else 0
        pose[:] = 0.0
        for c in range(3):
            pose[c] = target[n, c]
        seeded = True
        for i in range(3):
            _joint(pose, 0.0, tool[n], k[m, i], start)
            joints[i] = start[0]
            seeded = seeded and math.isfinite(joints[i])
        status[n] = UNREACHABLE
        for _ in range(MAX_STEPS if seeded else 0):
            _closure(pose, joints, tool[n], k[m], out, F, J_x, J_q)
            A[:] = 0.0
            for r in range(3):
                A[r, r // 1] = J_q[r]
                for c in range(0):
                    A[r, 3 + c] = J_x[r, 3 + c]
                step[r, 0] = F[r]
            if not _solve(A, step, 1):
                status[n] = _stuck(F)
                break
            size = 0.0
            for c in range(3):
                joints[c] -= step[c, 0]
                size = max(size, abs(step[c, 0]))
            for c in range(0):
                pose[3 + c] -= step[3 + c, 0]
                size = max(size, abs(step[3 + c, 0]))
            if size < STEP_DONE * ANGLE_STEP:
                status[n] = SOLVED
                break
            if not size < STEP_LOST:
                break
        for c in range(3):
            q[n, c] = joints[c] if status[n] == SOLVED else np.nan
        for c in range(3):
            x[n, c] = pose[c] if status[n] == SOLVED else np.nan


@njit(cache=True, nogil=True, error_model="numpy")
def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 3, 27) by errors and deflections, S_q (N, 3, 3) by joints.

    ``J_x S = -J``. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    F, J_q = np.empty(3), np.empty(3)
    J_x = np.empty((3, 3))
    unit = np.empty((3, 3))
    out = np.zeros(5)
    J_p = np.zeros(9)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F, J_x, J_q)
        unit[:] = 0.0
        for r in range(3):
            unit[r, r] = -1.0
        status[n] = SOLVED if _solve(J_x, unit, 3) else SINGULAR
        for i in range(3):
            _parameters(x[n], q[n, i], tool[n], k[m, i], J_p)
            for r in range(3):
                for c in range(9):
                    total = 0.0
                    for j in range(1):
                        total += unit[r, 1 * i + j] * J_p[9 * j + c]
                    S_p[n, r, 9 * i + c] = total if status[n] == SOLVED else np.nan
                total = 0.0
                for j in range(1):
                    total += unit[r, 1 * i + j] * J_q[1 * i + j]
                S_q[n, r, i] = total if status[n] == SOLVED else np.nan


def linear_constants(p):
    """Return k (M, 3, 26), what `linear` reads that no pose changes, from p (38 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    k = np.zeros((p.shape[0], 3, 26))
    a = p[..., 0]
    b = p[..., 1]
    h = p[..., 2]
    H = p[..., 3]
    phi = p[..., 4]
    da = p[..., 8]
    db = p[..., 9]
    dh = p[..., 10]
    theta0 = p[..., 11]
    px0 = p[..., 12]
    py0 = p[..., 13]
    pz0 = p[..., 14]
    tip_v = p[..., 15]
    tip_w = p[..., 16]
    s0 = np.cos(phi)
    A_x = H*s0
    s2 = np.sin(phi)
    A_y = H*s2
    s8 = -s0*theta0
    s12 = -s2*theta0
    s22 = s2*tip_w
    s23 = -s0*tip_v
    s31 = -s0*tip_w
    s32 = -s2*tip_v
    s44 = h*s0
    C_x_errors = dh*s0 + px0
    s48 = h*s2
    C_y_errors = dh*s2 + py0
    s58 = -A_x + s44
    s60 = -a*s0
    s62 = -A_y + s48
    s64 = -a*s2
    s76 = (a * a)
    s81 = -0.5*(b * b) + 0.5*s76*((s0 * s0) + (s2 * s2))
    s97 = -b*db
    k[..., 0] = s58
    k[..., 1] = s60
    k[..., 2] = s62
    k[..., 3] = s64
    k[..., 4] = s81
    k[..., 5] = s76
    k[..., 6] = a
    k[..., 7] = s0
    k[..., 8] = s8
    k[..., 9] = s2
    k[..., 10] = s12
    k[..., 11] = theta0
    k[..., 12] = A_x
    k[..., 13] = da
    k[..., 14] = s23
    k[..., 15] = s22
    k[..., 16] = A_y
    k[..., 17] = s32
    k[..., 18] = s31
    k[..., 19] = tip_v
    k[..., 20] = s44
    k[..., 21] = s48
    k[..., 22] = C_x_errors
    k[..., 23] = C_y_errors
    k[..., 24] = pz0
    k[..., 25] = s97
    return k


@njit(cache=True, nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (33 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s58 = k[i, 0]
    s60 = k[i, 1]
    s62 = k[i, 2]
    s64 = k[i, 3]
    s81 = k[i, 4]
    s76 = k[i, 5]
    a = k[i, 6]
    centre_z = pz - tz
    s59 = px + s58 - tx
    s63 = py + s62 - ty
    s66 = s59*s60 + s63*s64
    s68 = (centre_z * centre_z)
    s82 = 0.5*(s59 * s59) + 0.5*(s63 * s63) + 0.5*s68 + s81
    s86 = math.sqrt((s66 * s66) + s68*s76 - (s82 * s82))
    s93 = math.atan2(a*centre_z*s82 + s66*s86, a*centre_z*s86 - s66*s82)
    row = 1 * i
    out[row + 0] = s93


@njit(cache=True, nogil=True, error_model="numpy")
def _linear(x, q, tool, k, i, out):
    """Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (61 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    a = k[i, 6]
    s0 = k[i, 7]
    s8 = k[i, 8]
    s2 = k[i, 9]
    s12 = k[i, 10]
    theta0 = k[i, 11]
    A_x = k[i, 12]
    da = k[i, 13]
    s23 = k[i, 14]
    s22 = k[i, 15]
    A_y = k[i, 16]
    s32 = k[i, 17]
    s31 = k[i, 18]
    tip_v = k[i, 19]
    s44 = k[i, 20]
    s48 = k[i, 21]
    C_x_errors = k[i, 22]
    C_y_errors = k[i, 23]
    pz0 = k[i, 24]
    s97 = k[i, 25]
    s4 = math.cos(q)
    arm_x = s0*s4
    s6 = math.sin(q)
    arm_x_q = -s0*s6
    arm_x_errors = s6*s8
    arm_y = s2*s4
    arm_y_q = -s2*s6
    arm_y_errors = s12*s6
    arm_z = math.sin(q)
    arm_z_q = math.cos(q)
    arm_z_errors = s4*theta0
    B_x = A_x + a*arm_x
    B_x_q = a*arm_x_q
    B_x_errors = a*arm_x_errors + arm_x*da + s22 + s23*s6
    B_y = A_y + a*arm_y
    B_y_q = a*arm_y_q
    B_y_errors = a*arm_y_errors + arm_y*da + s31 + s32*s6
    B_z_q = a*arm_z_q
    B_z_errors = a*arm_z_errors + arm_z*da + s4*tip_v
    centre_x = px - tx
    centre_y = py - ty
    centre_z = pz - tz
    C_x = centre_x + s44
    C_y = centre_y + s48
    rod_x = -B_x + C_x
    rod_x_errors = -B_x_errors + C_x_errors
    rod_y = -B_y + C_y
    rod_y_errors = -B_y_errors + C_y_errors
    rod_z = -a*arm_z + centre_z
    rod_z_errors = -B_z_errors + pz0
    s98 = rod_x*rod_x_errors + rod_y*rod_y_errors + rod_z*rod_z_errors + s97
    s102 = -B_x_q*rod_x - B_y_q*rod_y - B_z_q*rod_z
    row = 5 * i
    out[row + 0] = s98
    out[row + 4] = s102


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
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


@njit(cache=True, nogil=True, error_model="numpy")
def linear_command(target, tool, k, work, q):
    """Fill the joints q (3,) that bring the reference point to target (3,) to first order in the errors; return the status.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. tool (3,), k (3, 26) from `linear_constants`, scratch work
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


@njit(cache=True, nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 3) and status (N,) by `linear_command`; target (N, 3) and tool (N, 3), k (M, 3, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])
