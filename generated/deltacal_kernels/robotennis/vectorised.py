"""Kinematics of `robotennis` in plain NumPy: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both d98c384384506145; SymPy 1.14.0.

The functions of ``kinematics.py`` over all poses at once, from the same lowered kernels. Nothing is compiled: a first
small job is done before Numba would be loaded, and the compiled kernels have an independent check.
"""

import numpy as np

SOLVED, UNREACHABLE, SINGULAR = 0, 1, 2
FEW = 100  # poses at once, up to which calls of NumPy cost more than what they compute
MAX_STEPS = 30
STEP_DONE = 1e-9  # mm and rad; Newton is quadratic: after such a step the rest is rounding
STEP_LOST = 1e5  # mm and rad; a step of this size leads nowhere
ANGLE_STEP = 1e-3  # rad per mm: joints and rotations are asked for this much finer than lengths
CLOSED = 1e-3  # mm^2: loops that are open by more where Newton gets stuck cannot be closed
PIVOT_SINGULAR = 1e-9  # of the largest entry of its matrix, in mm


def constants(p):
    """Return k (M, 3, 24), what no pose changes, from p (46 operations).

    All rows at once.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((24, p.shape[1], 3))
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
    s0 = dphi + phi
    u_x = np.cos(s0)
    u_y = np.sin(s0)
    s3 = H + dH
    A_x = s3*u_x
    A_y = s3*u_y
    s11 = a + da
    s14 = -tip_v*u_x
    s16 = A_x + tip_w*u_y
    s20 = -tip_v*u_y
    s22 = A_y - tip_w*u_x
    s30 = dh + h
    s31 = s30*u_x
    s33 = s30*u_y
    s44 = b + db
    s45 = (s44 * s44)
    s46 = -0.5*s45
    s77 = -s44
    s96 = -A_x + px0 + s31
    s98 = -s11*u_x
    s100 = -A_y + py0 + s33
    s102 = -s11*u_y
    s117 = 0.5*(s11 * s11)*((u_x * u_x) + (u_y * u_y)) + s46
    s122 = -2*a - 2*da
    s124 = 0.25*(s122 * s122)
    s129 = -0.5*s122
    k[0] = theta0
    k[1] = u_x
    k[2] = u_y
    k[3] = s11
    k[4] = s14
    k[5] = s16
    k[6] = s20
    k[7] = s22
    k[8] = tip_v
    k[9] = px0
    k[10] = py0
    k[11] = pz0
    k[12] = s31
    k[13] = s33
    k[14] = s46
    k[15] = s96
    k[16] = s98
    k[17] = s100
    k[18] = s102
    k[19] = s117
    k[20] = s124
    k[21] = s129
    k[22] = s77
    k[23] = s45
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _newton(x, q, tool, k):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint: (5, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
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
    s7 = np.cos(s6)
    arm_x = s7*u_x
    arm_y = s7*u_y
    arm_z = np.sin(s6)
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
    out = np.zeros((5, *(k.shape[1], x.shape[-1])))
    out[0] = s47
    out[1] = s53
    out[2] = s51
    out[3] = s49
    out[4] = s74
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (11, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
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
    s77 = k[22]
    s6 = q + theta0
    s7 = np.cos(s6)
    arm_x = s7*u_x
    arm_y = s7*u_y
    arm_z = np.sin(s6)
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
    s48 = 2*rod_z
    s49 = 0.5*s48
    s50 = 2*rod_y
    s51 = 0.5*s50
    s52 = 2*rod_x
    s53 = 0.5*s52
    s59 = -arm_z*s51
    s60 = -s11*s51
    s63 = -arm_z*s53
    s64 = -s11*s53
    s73 = -arm_z*(-s49*tip_v + s60*u_y + s64*u_x)
    s74 = s7*(-s11*s49 - s14*s53 - s20*s51) + s73
    s75 = -arm_x*s53 - arm_y*s51 - arm_z*s49
    s80 = s51*u_y + s53*u_x
    s86 = -s20*s63
    s87 = s60*s7*u_x
    s88 = -s64*s7*u_y
    s89 = s14*s59 - s16*s51 + s22*s53 + s31*s51 - s33*s53 + s86 + s87 + s88
    s92 = -s49*s7 - s59*u_y - s63*u_x
    s95 = s51*u_x - s53*u_y
    out = np.zeros((11, *(k.shape[1], x.shape[-1])))
    out[0] = s75
    out[1] = s77
    out[2] = s80
    out[3] = s74
    out[4] = s89
    out[5] = -s80
    out[6] = s53
    out[7] = s51
    out[8] = s49
    out[9] = s92
    out[10] = s95
    return out


def _sphere(x, q, tool, k):
    """The simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d: (4, limbs, N)."""
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    theta0 = k[0]
    s11 = k[3]
    pz0 = k[11]
    s96 = k[15]
    s98 = k[16]
    s100 = k[17]
    s102 = k[18]
    s45 = k[23]
    s6 = q + theta0
    s7 = np.cos(s6)
    arm_z = np.sin(s6)
    s138 = -s7*s98 - s96 + tx
    s140 = -s100 - s102*s7 + ty
    s141 = arm_z*s11 - pz0 + tz
    s145 = (s138 * s138) + (s140 * s140) + (s141 * s141) - s45
    out = np.zeros((4, *(k.shape[1], x.shape[-1])))
    out[0] = s138
    out[1] = s140
    out[2] = s141
    out[3] = s145
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (1, limbs, N)."""
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
    s127 = np.sqrt((s104 * s104) + s106*s124 - (s118 * s118))
    s136 = -theta0 + np.arctan2(centre_z*s118*s129 + s104*s127, centre_z*s127*s129 - s104*s118)
    out = np.zeros((1, *(k.shape[1], x.shape[-1])))
    out[0] = s136
    return out


def _of(k, chosen):
    return k[chosen] if len(k) > 1 else k


def _turned(x, q, tool, k):
    """Return arrays as the kernels read them: poses last, limbs before them, so that one call does all limbs.

    Few poses are laid out for every limb, and constants for every pose: matching shapes is most of what a small
    operation of NumPy costs.
    """
    if len(x) > FEW:
        return x.T.copy(), q.T.copy(), tool.T.copy(), k.T.copy()
    x, tool, k = (np.broadcast_to(a, (len(a), 3, len(x))).copy() for a in (x.T[:, None], tool.T[:, None], k.T))
    return x, q.T.copy(), tool, k


def _by_rod(values):
    """Return what a kernel gives of the rods of a limb (rods k, limbs, N) as (3, k, N): limb by limb."""
    each = len(values) // 1
    by_rod = values.reshape(1, each, *values.shape[1:])
    return by_rod.transpose(2, 0, 1, 3).reshape(3, each, values.shape[2])


def _closure(x, q, tool, k):
    """Return F (3, N), J_x (3, 3, N) and the joints' part J_q (3, N)."""
    rows = _by_rod(_newton(*_turned(x, q, tool, k)))
    return rows[:, 0], rows[:, 1 : 4], rows[:, 4]


def _solve(A, B):
    """Return X of A X = B (n, m, N) by Gauss-Jordan elimination, partial pivoting, and (N,) whether A is regular."""
    n, both, every = len(A), np.concatenate([A, B], axis=1), np.arange(A.shape[2])
    pivots = np.empty((n, len(every)))
    with np.errstate(divide="ignore", invalid="ignore"):
        for c in range(n):
            pivot = c + np.abs(both[c:, c]).argmax(axis=0)
            row = both[pivot, c:, every].T
            both[pivot, c:, every] = both[c, c:].T
            pivots[c] = row[0]
            row = row[1:] / row[0]
            both[:, c + 1 :] -= both[:, c, None] * row
            both[c, c + 1 :] = row
    return both[:, n:], (np.abs(pivots) > PIVOT_SINGULAR * np.abs(A).max(axis=(0, 1), initial=0.0)).all(axis=0)


def jacobians(x, q, tool, k, F, J_x, J_q, J_p):
    """See ``kinematics.jacobians``."""
    for given, found in zip((F, J_x, J_q), _closure(x, q, tool, k), strict=True):
        given[:] = np.moveaxis(found, -1, 0)
    J_p[:] = np.moveaxis(_by_rod(_parameters(*_turned(x, q, tool, k))), -1, 0)


def _meet(spheres):
    """Where the spheres meet; how far off the centres, how far these are apart, what that is compared with: (6, N)."""
    c_00 = spheres[0]
    c_01 = spheres[1]
    c_02 = spheres[2]
    c_03 = spheres[3]
    c_10 = spheres[4]
    c_11 = spheres[5]
    c_12 = spheres[6]
    c_13 = spheres[7]
    c_20 = spheres[8]
    c_21 = spheres[9]
    c_22 = spheres[10]
    c_23 = spheres[11]
    a_x = -c_00 + c_10
    a_y = -c_01 + c_11
    a_z = -c_02 + c_12
    b_x = -c_00 + c_20
    b_y = -c_01 + c_21
    b_z = -c_02 + c_22
    s7 = -0.5*c_03
    to_a = 0.5*c_13 + s7
    to_b = 0.5*c_23 + s7
    aa = (a_x * a_x) + (a_y * a_y) + (a_z * a_z)
    n_x = a_y*b_z - a_z*b_y
    n_y = -a_x*b_z + a_z*b_x
    n_z = a_x*b_y - a_y*b_x
    nn = (n_x * n_x) + (n_y * n_y) + (n_z * n_z)
    bb = (b_x * b_x) + (b_y * b_y) + (b_z * b_z)
    ab = a_x*b_x + a_y*b_y + a_z*b_z
    inverse = (1.0 / nn)
    by_a = inverse*(-ab*to_b + bb*to_a)
    by_b = inverse*(aa*to_b - ab*to_a)
    p_x = a_x*by_a + b_x*by_b
    p_y = a_y*by_a + b_y*by_b
    p_z = a_z*by_a + b_z*by_b
    half = inverse*(n_x*(-c_00 + p_x) + n_y*(-c_01 + p_y) + n_z*(-c_02 + p_z))
    s66 = -2*c_01*p_y
    s67 = -2*c_02*p_z
    rest = -2*c_00*p_x + c_03 + (p_x * p_x) + (p_y * p_y) + (p_z * p_z) + s66 + s67
    under = (half * half) - inverse*rest
    kept = np.where((under > 0), under, 0)
    s73 = np.sqrt(kept)
    along = -half + np.where((n_z > 0), s73, -s73)
    s77 = along*n_x + p_x
    s79 = along*n_y + p_y
    s81 = along*n_z + p_z
    s82 = nn*under
    s83 = aa*bb
    out = np.zeros((6, *spheres.shape[1:]))
    out[0] = s77
    out[1] = s79
    out[2] = s81
    out[3] = s82
    out[4] = nn
    out[5] = s83
    return out


def forward(q, tool, k, x, status, warm):
    """See ``kinematics.forward``."""
    status[:] = UNREACHABLE
    if not (warm and np.isfinite(x).all()):
        x[:] = 0.0
        spheres = _sphere(*_turned(x, q, tool, k)).swapaxes(0, 1).reshape(12, -1)
        with np.errstate(divide="ignore", invalid="ignore"):
            *at, _, square, wide = _meet(spheres)
        x[:, :3] = np.transpose(at)
        status[~(square > PIVOT_SINGULAR * wide)] = SINGULAR
    active = np.flatnonzero(status == UNREACHABLE)
    for _ in range(MAX_STEPS):
        if not len(active):
            break
        F, J_x, _ = _closure(x[active], q[active], tool[active], _of(k, active))
        step, regular = _solve(J_x, F[:, None])
        status[active[~regular]] = np.where(
            np.abs(F[:, ~regular]).max(axis=0, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE
        )
        active, step = active[regular], step[:, 0, regular].T
        x[active] -= step
        size = np.abs(step).max(axis=1, initial=0.0)
        status[active[size < STEP_DONE]] = SOLVED
        active = active[(size >= STEP_DONE) & (size < STEP_LOST)]
    x[status != SOLVED] = np.nan


def inverse(target, tool, k, x, q, status):
    """See ``kinematics.inverse``."""
    x[:] = 0.0
    x[:, :3] = target
    with np.errstate(invalid="ignore"):
        x_, _, tool_, k_ = _turned(x, q, tool, k)
        start = _joint(x_, 0.0, tool_, k_)
    q[:] = start[0].T
    status[:] = UNREACHABLE
    active = np.flatnonzero(np.isfinite(q).all(axis=1))
    for _ in range(MAX_STEPS):
        if not len(active):
            break
        F, J_x, J_q = _closure(x[active], q[active], tool[active], _of(k, active))
        A = np.zeros((3, 3, len(active)))
        A[range(3), np.arange(3) // 1] = J_q
        A[:, 3:] = J_x[:, 3:]
        step, regular = _solve(A, F[:, None])
        status[active[~regular]] = np.where(
            np.abs(F[:, ~regular]).max(axis=0, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE
        )
        active, step = active[regular], step[:, 0, regular].T
        q[active] -= step[:, :3]
        x[active, 3:] -= step[:, 3:]
        size = np.abs(step).max(axis=1, initial=0.0)
        status[active[size < STEP_DONE * ANGLE_STEP]] = SOLVED
        active = active[(size >= STEP_DONE * ANGLE_STEP) & (size < STEP_LOST)]
    x[status != SOLVED], q[status != SOLVED] = np.nan, np.nan


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """See ``kinematics.sensitivity``."""
    _, J_x, J_q = _closure(x, q, tool, k)
    unit, regular = _solve(J_x, np.tile(-np.eye(3)[:, :, None], len(x)))
    status[:] = np.where(regular, SOLVED, SINGULAR)
    unit[:, :, ~regular] = np.nan
    by_limb = unit.reshape(3, 3, 1, -1).transpose(3, 1, 0, 2)
    J_p = _parameters(*_turned(x, q, tool, k)).reshape(1, 11, 3, -1).transpose(3, 2, 0, 1)
    S_p[:] = (by_limb @ J_p).transpose(0, 2, 1, 3).reshape(S_p.shape)
    S_q[:] = np.moveaxis((unit * J_q).reshape(3, 3, 1, -1).sum(axis=2), -1, 0)
