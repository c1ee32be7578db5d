"""Kinematics of `diamond` in plain NumPy: Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both 2cf197764640594b; SymPy 1.14.0.

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
    """Return k (M, 2, 12), what no pose changes, from p (23 operations).

    All rows at once.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((12, p.shape[1], 2))
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
    B_x = base_x*side + ex
    B_y = base_y + ey
    s3 = L + dL
    s6 = theta - 0.5*np.pi*(1 - side)
    s9 = s3*side
    s12 = -side*tip_v
    s26 = dl + l
    s27 = (s26 * s26)
    s28 = -0.5*s27
    s51 = -s26
    s59 = (side * side)
    s60 = (s3 * s3)
    s62 = s28 + 0.5*s59*s60
    s66 = s59*s60
    s71 = s3*s59
    k[0] = s6
    k[1] = s9
    k[2] = s12
    k[3] = B_x
    k[4] = B_y
    k[5] = s28
    k[6] = s62
    k[7] = s66
    k[8] = s71
    k[9] = side
    k[10] = s51
    k[11] = s27
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _newton(x, q, tool, k):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint: (4, limbs, N)."""
    px = x[0]
    py = x[1]
    tx = tool[0]
    ty = tool[1]
    s6 = k[0]
    s9 = k[1]
    s12 = k[2]
    B_x = k[3]
    B_y = k[4]
    s28 = k[5]
    s7 = q + s6
    s8 = np.cos(s7)
    s11 = np.sin(s7)
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
    out = np.zeros((4, *(k.shape[1], x.shape[-1])))
    out[0] = s29
    out[1] = s33
    out[2] = s31
    out[3] = s46
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (8, limbs, N)."""
    px = x[0]
    py = x[1]
    tx = tool[0]
    ty = tool[1]
    s6 = k[0]
    s9 = k[1]
    s12 = k[2]
    B_x = k[3]
    B_y = k[4]
    side = k[9]
    s51 = k[10]
    s7 = q + s6
    s8 = np.cos(s7)
    s11 = np.sin(s7)
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
    out = np.zeros((8, *(k.shape[1], x.shape[-1])))
    out[0] = s46
    out[1] = -s33
    out[2] = -s31
    out[3] = s50
    out[4] = s51
    out[7] = s52
    return out


def _sphere(x, q, tool, k):
    """The simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d: (3, limbs, N)."""
    tx = tool[0]
    ty = tool[1]
    s6 = k[0]
    s9 = k[1]
    B_x = k[3]
    B_y = k[4]
    s27 = k[11]
    s7 = q + s6
    s79 = B_x + s9*np.cos(s7) + tx
    s80 = B_y + s9*np.sin(s7) + ty
    s83 = -s27 + (s79 * s79) + (s80 * s80)
    out = np.zeros((3, *(k.shape[1], x.shape[-1])))
    out[0] = s79
    out[1] = s80
    out[2] = s83
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (1, limbs, N)."""
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
    s70 = np.sqrt(s55*s66 + s57*s66 - (s63 * s63))
    s78 = -s6 + np.arctan2(s53*s63*s9 + s54*s70*s71, -s53*s70*s71 + s54*s63*s9)
    out = np.zeros((1, *(k.shape[1], x.shape[-1])))
    out[0] = s78
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
    x, tool, k = (np.broadcast_to(a, (len(a), 2, len(x))).copy() for a in (x.T[:, None], tool.T[:, None], k.T))
    return x, q.T.copy(), tool, k


def _by_rod(values):
    """Return what a kernel gives of the rods of a limb (rods k, limbs, N) as (2, k, N): limb by limb."""
    each = len(values) // 1
    by_rod = values.reshape(1, each, *values.shape[1:])
    return by_rod.transpose(2, 0, 1, 3).reshape(2, each, values.shape[2])


def _closure(x, q, tool, k):
    """Return F (2, N), J_x (2, 2, N) and the joints' part J_q (2, N)."""
    rows = _by_rod(_newton(*_turned(x, q, tool, k)))
    return rows[:, 0], rows[:, 1 : 3], rows[:, 3]


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
    """Where the spheres meet; how far off the centres, how far these are apart, what that is compared with: (5, N)."""
    c_00 = spheres[0]
    c_01 = spheres[1]
    c_02 = spheres[2]
    c_10 = spheres[3]
    c_11 = spheres[4]
    c_12 = spheres[5]
    a_x = -c_00 + c_10
    a_y = -c_01 + c_11
    to_a = -0.5*c_02 + 0.5*c_12
    aa = (a_x * a_x) + (a_y * a_y)
    inverse = (1.0 / aa)
    by_a = inverse*to_a
    p_x = a_x*by_a
    p_y = a_y*by_a
    half = inverse*(a_x*(-c_01 + p_y) - a_y*(-c_00 + p_x))
    rest = -2*c_00*p_x - 2*c_01*p_y + c_02 + (p_x * p_x) + (p_y * p_y)
    under = (half * half) - inverse*rest
    kept = np.where((under > 0), under, 0)
    s27 = np.sqrt(kept)
    along = -half - np.where((a_x > 0), s27, -s27)
    s31 = -a_y*along + p_x
    s33 = a_x*along + p_y
    s34 = aa*under
    s39 = (c_00 * c_00) + (c_01 * c_01) + (c_10 * c_10) + (c_11 * c_11)
    out = np.zeros((5, *spheres.shape[1:]))
    out[0] = s31
    out[1] = s33
    out[2] = s34
    out[3] = aa
    out[4] = s39
    return out


def forward(q, tool, k, x, status, warm):
    """See ``kinematics.forward``."""
    status[:] = UNREACHABLE
    if not (warm and np.isfinite(x).all()):
        x[:] = 0.0
        spheres = _sphere(*_turned(x, q, tool, k)).swapaxes(0, 1).reshape(6, -1)
        with np.errstate(divide="ignore", invalid="ignore"):
            *at, _, square, wide = _meet(spheres)
        x[:, :2] = np.transpose(at)
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
    x[:, :2] = target
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
        A = np.zeros((2, 2, len(active)))
        A[range(2), np.arange(2) // 1] = J_q
        A[:, 2:] = J_x[:, 2:]
        step, regular = _solve(A, F[:, None])
        status[active[~regular]] = np.where(
            np.abs(F[:, ~regular]).max(axis=0, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE
        )
        active, step = active[regular], step[:, 0, regular].T
        q[active] -= step[:, :2]
        x[active, 2:] -= step[:, 2:]
        size = np.abs(step).max(axis=1, initial=0.0)
        status[active[size < STEP_DONE * ANGLE_STEP]] = SOLVED
        active = active[(size >= STEP_DONE * ANGLE_STEP) & (size < STEP_LOST)]
    x[status != SOLVED], q[status != SOLVED] = np.nan, np.nan


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """See ``kinematics.sensitivity``."""
    _, J_x, J_q = _closure(x, q, tool, k)
    unit, regular = _solve(J_x, np.tile(-np.eye(2)[:, :, None], len(x)))
    status[:] = np.where(regular, SOLVED, SINGULAR)
    unit[:, :, ~regular] = np.nan
    by_limb = unit.reshape(2, 2, 1, -1).transpose(3, 1, 0, 2)
    J_p = _parameters(*_turned(x, q, tool, k)).reshape(1, 8, 2, -1).transpose(3, 2, 0, 1)
    S_p[:] = (by_limb @ J_p).transpose(0, 2, 1, 3).reshape(S_p.shape)
    S_q[:] = np.moveaxis((unit * J_q).reshape(2, 2, 1, -1).sum(axis=2), -1, 0)
