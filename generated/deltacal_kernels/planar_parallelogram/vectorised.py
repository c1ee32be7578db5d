"""Kinematics of `planar_parallelogram` in plain NumPy: Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both f226beb3bbca959f; SymPy 1.14.0.

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
    """Return k (M, 1, 28), what no pose changes, from p (91 operations).

    All rows at once.
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
    A1_x = -a1x - da1x
    A2_x = a2x + da2x
    A2_y = a2y + da2y
    b1_x = -b1x - db1x
    b2_x = b2x + db2x
    b2_y = b2y + db2y
    s7 = dl1 + l1
    s69 = dl2 + l2
    s71 = -0.5*(s69 * s69)
    s101 = -s69
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
    k[0] = h
    k[1] = q0
    k[2] = s7
    k[3] = b1_x
    k[4] = b2_x
    k[5] = b2_y
    k[6] = A2_x
    k[7] = A2_y
    k[8] = A1_x
    k[9] = s71
    k[10] = s103
    k[11] = s102
    k[12] = s108
    k[13] = s116
    k[14] = s120
    k[15] = s122
    k[16] = s124
    k[17] = s130
    k[18] = s134
    k[19] = s136
    k[20] = s138
    k[21] = s149
    k[22] = s153
    k[23] = s156
    k[24] = s158
    k[25] = s160
    k[26] = s101
    k[27] = s195
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _newton(x, q, tool, k):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint: (15, limbs, N)."""
    px = x[0]
    py = x[1]
    cz = x[2]
    tx = tool[0]
    ty = tool[1]
    h = k[0]
    q0 = k[1]
    s7 = k[2]
    b1_x = k[3]
    b2_x = k[4]
    b2_y = k[5]
    A2_x = k[6]
    A2_y = k[7]
    A1_x = k[8]
    s71 = k[9]
    C_y = -h + ty
    s8 = q + q0
    r1_x = s7*np.sin(s8)
    r1_y = -s7*np.cos(s8)
    s13 = (cz * cz)
    s15 = 0.25*s13 + 1
    s16 = (1.0 / s15)
    s17 = -0.5*s13*s16
    R_11 = s17 + 1
    R_12 = -cz*s16
    R_21 = cz*s16
    R_22 = s17 + 1
    s22 = b1_x - tx
    B1_x = -C_y*R_12 + R_11*s22 + px
    B1_y = -C_y*R_22 + R_21*s22 + py
    s29 = b2_x - tx
    s31 = -C_y + b2_y
    B2_x = R_11*s29 + R_12*s31 + px
    B2_y = R_21*s29 + R_22*s31 + py
    r2_x = -A2_x + B2_x
    r2_y = -A2_y + B2_y
    s39 = -A1_x + B1_x - r1_x
    s42 = -0.5*s16
    s43 = -0.5*s13
    s47 = (1.0 / (s15 * s15))
    s51 = 2*cz
    s53 = C_y*s16 + s51*(s22*s42 - 0.25*s47*(C_y*cz + s22*s43))
    s54 = B1_y - r1_y
    s64 = s16*s22 + s51*(-C_y*s42 - 0.25*s47*(-C_y*s43 + cz*s22))
    s72 = 0.5*(r2_x * r2_x) + 0.5*(r2_y * r2_y) + s71
    s73 = 2*r2_y
    s74 = 0.5*s73
    s75 = 2*r2_x
    s76 = 0.5*s75
    s79 = s29*s74
    s81 = s31*s76
    s91 = s29*s76 + s31*s74
    s98 = s51*(s42*s91 - 0.25*s47*(cz*s79 - cz*s81 + s43*s91))
    s99 = s16*s79 - s16*s81 + s98
    out = np.zeros((15, *(k.shape[1], x.shape[-1])))
    out[0] = s39
    out[1] = 1
    out[2] = 0
    out[3] = s53
    out[4] = r1_y
    out[5] = s54
    out[6] = 0
    out[7] = 1
    out[8] = s64
    out[9] = -r1_x
    out[10] = s72
    out[11] = s76
    out[12] = s74
    out[13] = s99
    out[14] = 0
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (27, limbs, N)."""
    px = x[0]
    py = x[1]
    cz = x[2]
    tx = tool[0]
    ty = tool[1]
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
    s9 = np.sin(s8)
    r1_x = s7*s9
    s11 = np.cos(s8)
    r1_y = -s11*s7
    s13 = (cz * cz)
    s16 = (1.0 / (0.25*s13 + 1))
    s17 = -0.5*s13*s16
    R_11 = s17 + 1
    R_12 = -cz*s16
    R_21 = cz*s16
    R_22 = s17 + 1
    s29 = b2_x - tx
    s31 = -C_y + b2_y
    B2_x = R_11*s29 + R_12*s31 + px
    B2_y = R_21*s29 + R_22*s31 + py
    r2_x = -A2_x + B2_x
    r2_y = -A2_y + B2_y
    s73 = 2*r2_y
    s74 = 0.5*s73
    s75 = 2*r2_x
    s76 = 0.5*s75
    s83 = R_12*s76 + R_22*s74
    s86 = R_11*s76 + R_21*s74
    out = np.zeros((27, *(k.shape[1], x.shape[-1])))
    out[0] = r1_y
    out[1] = 1
    out[4] = -R_11
    out[7] = -s9
    out[9] = -r1_x
    out[13] = -R_21
    out[16] = s11
    out[20] = -s76
    out[21] = -s74
    out[23] = s86
    out[24] = s83
    out[26] = s101
    return out


def _position(x, q, tool, k):
    """Platform of the simplified machine at a given joint: (3, limbs, N)."""
    tx = tool[0]
    ty = tool[1]
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
    r1_x = s7*np.sin(s8)
    r1_y = -s7*np.cos(s8)
    s22 = b1_x - tx
    s185 = r1_x*s116 + r1_y*s130 + r1_y*s134 + s124
    s190 = r1_x*s130 + r1_x*s134 - r1_y*s116 + s138
    s198 = (r1_x * r1_x) + r1_x*s153 + r1_x*s156 + (r1_y * r1_y) + r1_y*s195 + s160
    s201 = np.sqrt((s185 * s185) + (s190 * s190) - (s198 * s198))
    s204 = -s185*s198 + s190*s201
    s208 = -s185*s201 - s190*s198
    s211 = 1/np.sqrt((s204 * s204) + (s208 * s208))
    s214 = A1_x - C_y*s204*s211 + r1_x - s208*s211*s22
    s217 = C_y*s208*s211 + r1_y - s204*s211*s22
    s221 = 2*np.tan(0.5*np.arctan2(s204, s208))
    out = np.zeros((3, *(k.shape[1], x.shape[-1])))
    out[0] = s214
    out[1] = s217
    out[2] = s221
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (3, limbs, N)."""
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
    s107 = -q0 + np.asin(s102*s104)
    s109 = (s104 * s104)
    s111 = -s108*s109 + 1
    s112 = np.sqrt(s111)
    s125 = s104*s116 + s112*s120 + s112*s122 + s124
    s139 = s104*s130 + s104*s134 + s112*s136 + s138
    s161 = s104*s153 + s104*s156 + s109 + s111*s149 + s112*s158 + s160
    s164 = np.sqrt((s125 * s125) + (s139 * s139) - (s161 * s161))
    s167 = -s125*s161 + s139*s164
    s171 = -s125*s164 - s139*s161
    s174 = 1/np.sqrt((s167 * s167) + (s171 * s171))
    s177 = C_y*s171*s174 - s112*s7 - s167*s174*(b1_x - tx)
    s181 = 2*np.tan(0.5*np.arctan2(s167, s171))
    out = np.zeros((3, *(k.shape[1], x.shape[-1])))
    out[0] = s107
    out[1] = s177
    out[2] = s181
    return out


def _spin(x):
    """Turn about the axes of {O} by the Cayley vector: (1, N)."""
    cz = x[2]
    s16 = (1.0 / (0.25*(cz * cz) + 1))
    out = np.zeros((1, *x.shape[1:]))
    out[0] = s16
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
    J_p = _parameters(*_turned(x, q, tool, k)).reshape(3, 9, 1, -1).transpose(3, 2, 0, 1)
    S_p[:] = (by_limb @ J_p).transpose(0, 2, 1, 3).reshape(S_p.shape)
    S_q[:] = np.moveaxis((unit * J_q).reshape(3, 1, 3, -1).sum(axis=2), -1, 0)
    W = _spin(x.T).T.reshape(-1, 1, 1)
    S_p[:, 2:], S_q[:, 2:] = W @ S_p[:, 2:], W @ S_q[:, 2:]
