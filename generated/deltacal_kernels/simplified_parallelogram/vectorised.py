"""Kinematics of `simplified_parallelogram` in plain NumPy: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both ffd41b76f59b86a3; SymPy 1.14.0.

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
    """Return k (M, 1, 6), what no pose changes, from p (5 operations).

    All rows at once.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((6, p.shape[1], 1))
    a1x = p[0]
    b1x = p[3]
    l1 = p[6]
    h = p[8]
    q0 = p[9]
    dl1 = p[10]
    A_x = -a1x + b1x
    s1 = dl1 + l1
    s12 = (1.0 / s1)
    s17 = (1.0 / (s1 * s1))
    k[0] = q0
    k[1] = s1
    k[2] = A_x
    k[3] = h
    k[4] = s12
    k[5] = s17
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _newton(x, q, tool, k):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint: (15, limbs, N)."""
    px = x[0]
    py = x[1]
    cz = x[2]
    tx = tool[0]
    ty = tool[1]
    q0 = k[0]
    s1 = k[1]
    A_x = k[2]
    h = k[3]
    s2 = q + q0
    r_x = s1*np.sin(s2)
    r_y = -s1*np.cos(s2)
    B_x = A_x + r_x
    C_x = px - tx
    C_y = h + py - ty
    s10 = -B_x + C_x
    s11 = C_y - r_y
    out = np.zeros((15, *(k.shape[1], x.shape[-1])))
    out[0] = s10
    out[1] = 1
    out[2] = 0
    out[3] = 0
    out[4] = r_y
    out[5] = s11
    out[6] = 0
    out[7] = 1
    out[8] = 0
    out[9] = -r_x
    out[10] = cz
    out[11] = 0
    out[12] = 0
    out[13] = 1
    out[14] = 0
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (6, limbs, N)."""
    q0 = k[0]
    s1 = k[1]
    s2 = q + q0
    s3 = np.sin(s2)
    r_x = s1*s3
    s5 = np.cos(s2)
    r_y = -s1*s5
    out = np.zeros((6, *(k.shape[1], x.shape[-1])))
    out[0] = r_y
    out[1] = -s3
    out[2] = -r_x
    out[3] = s5
    return out


def _position(x, q, tool, k):
    """Platform of the simplified machine at a given joint: (3, limbs, N)."""
    tx = tool[0]
    ty = tool[1]
    q0 = k[0]
    s1 = k[1]
    A_x = k[2]
    h = k[3]
    s2 = q + q0
    r_x = s1*np.sin(s2)
    r_y = -s1*np.cos(s2)
    s24 = A_x + r_x + tx
    s25 = -h + r_y + ty
    out = np.zeros((3, *(k.shape[1], x.shape[-1])))
    out[0] = s24
    out[1] = s25
    out[2] = 0
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (3, limbs, N)."""
    px = x[0]
    tx = tool[0]
    ty = tool[1]
    q0 = k[0]
    s1 = k[1]
    A_x = k[2]
    h = k[3]
    s12 = k[4]
    s17 = k[5]
    s13 = -A_x + px - tx
    s16 = -q0 + np.asin(s12*s13)
    s23 = -h - s1*np.sqrt(-(s13 * s13)*s17 + 1) + ty
    out = np.zeros((3, *(k.shape[1], x.shape[-1])))
    out[0] = s16
    out[1] = s23
    out[2] = 0
    return out


def _spin(x):
    """Turn about the axes of {O} by the Cayley vector: (1, N)."""
    cz = x[2]
    s29 = (1.0 / (0.25*(cz * cz) + 1))
    out = np.zeros((1, *x.shape[1:]))
    out[0] = s29
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
    x, tool, k = (np.broadcast_to(a, (len(a), 1, len(x))).copy() for a in (x.T[:, None], tool.T[:, None], k.T))
    return x, q.T.copy(), tool, k


def _by_rod(values):
    """Return what a kernel gives of the rods of a limb (rods k, limbs, N) as (3, k, N): limb by limb."""
    each = len(values) // 3
    by_rod = values.reshape(3, each, *values.shape[1:])
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


def forward(q, tool, k, x, status, warm):
    """See ``kinematics.forward``."""
    status[:] = UNREACHABLE
    if not (warm and np.isfinite(x).all()):
        x[:] = 0.0
        with np.errstate(invalid="ignore"):
            x[:] = _position(*_turned(x, q, tool, k))[:, 0].T
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
    x[:, :1] = target
    with np.errstate(invalid="ignore"):
        x_, _, tool_, k_ = _turned(x, q, tool, k)
        start = _joint(x_, 0.0, tool_, k_)
    q[:] = start[0].T
    x[:, 1:] = start[1:, -1].T
    status[:] = UNREACHABLE
    active = np.flatnonzero(np.isfinite(q).all(axis=1))
    for _ in range(MAX_STEPS):
        if not len(active):
            break
        F, J_x, J_q = _closure(x[active], q[active], tool[active], _of(k, active))
        A = np.zeros((3, 3, len(active)))
        A[range(3), np.arange(3) // 3] = J_q
        A[:, 1:] = J_x[:, 1:]
        step, regular = _solve(A, F[:, None])
        status[active[~regular]] = np.where(
            np.abs(F[:, ~regular]).max(axis=0, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE
        )
        active, step = active[regular], step[:, 0, regular].T
        q[active] -= step[:, :1]
        x[active, 1:] -= step[:, 1:]
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
    by_limb = unit.reshape(3, 1, 3, -1).transpose(3, 1, 0, 2)
    J_p = _parameters(*_turned(x, q, tool, k)).reshape(3, 2, 1, -1).transpose(3, 2, 0, 1)
    S_p[:] = (by_limb @ J_p).transpose(0, 2, 1, 3).reshape(S_p.shape)
    S_q[:] = np.moveaxis((unit * J_q).reshape(3, 1, 3, -1).sum(axis=2), -1, 0)
    W = _spin(x.T).T.reshape(-1, 1, 1)
    S_p[:, 2:], S_q[:, 2:] = W @ S_p[:, 2:], W @ S_q[:, 2:]
