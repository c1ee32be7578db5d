"""Kinematics of `hexapod` in plain NumPy: Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both 3980282f9fbd2ebf; SymPy 1.14.0.

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
    """Return k (M, 6, 13), what no pose changes, from p (51 operations).

    All rows at once.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((13, p.shape[1], 6))
    base = p[0]
    alpha = p[1]
    up = p[2]
    plate = p[3]
    beta = p[4]
    down = p[5]
    leg = p[6]
    ax = p[7]
    ay = p[8]
    az = p[9]
    bx = p[10]
    by = p[11]
    bz = p[12]
    dl = p[13]
    scale = p[14]
    dtx = p[15]
    dty = p[16]
    dtz = p[17]
    A_x = ax + base*np.cos(alpha)
    A_y = ay + base*np.sin(alpha)
    A_z = az + up
    s44 = bx - dtx + plate*np.cos(beta)
    s48 = by - dty + plate*np.sin(beta)
    s50 = bz + down - dtz
    s67 = scale + 1
    s69 = dl + leg
    s167 = (1.0 / (s67 * s67))
    s183 = (s69 * s69)
    s184 = -0.5*s183
    s186 = 2*s167
    s190 = 2*scale + 2
    s192 = 0.25*s183*(s190 * s190)/(s67 * s67 * s67 * s67)
    s195 = -0.5*s167*s190*s69
    s203 = -(base * base) + 2*base*plate*np.cos(alpha - beta) + (leg * leg) - (plate * plate)
    s205 = -down + np.sqrt(s203) + up
    k[0] = s44
    k[1] = s48
    k[2] = s50
    k[3] = A_x
    k[4] = A_y
    k[5] = A_z
    k[6] = s67
    k[7] = s69
    k[8] = s184
    k[9] = s186
    k[10] = s192
    k[11] = s195
    k[12] = s205
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _newton(x, q, tool, k):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint: (8, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s44 = k[0]
    s48 = k[1]
    s50 = k[2]
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    s67 = k[6]
    s69 = k[7]
    s0 = (cx * cx)
    s2 = (cy * cy)
    s4 = (cz * cz)
    s6 = 0.25*s0 + 0.25*s2 + 0.25*s4 + 1
    s7 = (1.0 / s6)
    s8 = -0.5*s2
    s9 = -0.5*s4
    s10 = s8 + s9
    R_11 = s10*s7 + 1
    s13 = 0.5*cx*cy
    s14 = -cz + s13
    R_12 = s14*s7
    s16 = 0.5*cx*cz
    s17 = cy + s16
    R_13 = s17*s7
    s19 = cz + s13
    R_21 = s19*s7
    s21 = -0.5*s0
    s22 = s21 + s9
    R_22 = s22*s7 + 1
    s25 = 0.5*cy*cz
    s26 = -cx + s25
    R_23 = s26*s7
    s28 = -cy + s16
    R_31 = s28*s7
    s30 = cx + s25
    R_32 = s30*s7
    s32 = s21 + s8
    R_33 = s32*s7 + 1
    b_x = s44 - tx
    b_y = s48 - ty
    b_z = s50 - tz
    B_x = R_11*b_x + R_12*b_y + R_13*b_z + px
    B_y = R_21*b_x + R_22*b_y + R_23*b_z + py
    B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz
    d_x = -A_x + B_x
    d_y = -A_y + B_y
    d_z = -A_z + B_z
    s = q*s67 + s69
    s83 = 0.5*(d_x * d_x) + 0.5*(d_y * d_y) + 0.5*(d_z * d_z) - 0.5*(s * s)
    s86 = 2*d_z
    s87 = 0.5*s86
    s88 = 2*d_y
    s89 = 0.5*s88
    s90 = 2*d_x
    s91 = 0.5*s90
    s92 = -s*s67
    s94 = b_z*s87
    s96 = b_y*s87
    s98 = b_x*s87
    s100 = b_z*s89
    s102 = b_y*s89
    s104 = b_x*s89
    s106 = b_z*s91
    s108 = b_y*s91
    s110 = b_x*s91
    s115 = s7*s94
    s117 = s7*s96
    s119 = s7*s98
    s121 = s100*s7
    s123 = s117 + s121
    s124 = 0.5*cz
    s125 = 0.5*cy
    s128 = s102*s7
    s129 = s102*s22
    s132 = s104*s7
    s133 = s104*s19
    s134 = s106*s7
    s135 = s106*s17
    s136 = s119 + s134
    s137 = 0.5*cx
    s140 = s108*s7
    s141 = s108*s14
    s142 = s132 + s140
    s145 = s110*s7
    s146 = s10*s110
    s151 = s100*s26 + s129 + s133 + s135 + s141 + s146 + s28*s98 + s30*s96 + s32*s94
    s154 = -0.25*s151/(s6 * s6)
    s164 = 2*cx*(-0.5*s115 - 0.5*s128 + s154) + s117 - s121 + s124*s136 + s125*s142
    s165 = 2*cy*(-0.5*s115 - 0.5*s145 + s154) - s119 + s123*s124 + s134 + s137*s142
    s166 = 2*cz*(-0.5*s128 - 0.5*s145 + s154) + s123*s125 + s132 + s136*s137 - s140
    out = np.zeros((8, *(k.shape[1], x.shape[-1])))
    out[0] = s83
    out[1] = s91
    out[2] = s89
    out[3] = s87
    out[4] = s164
    out[5] = s165
    out[6] = s166
    out[7] = s92
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (11, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s44 = k[0]
    s48 = k[1]
    s50 = k[2]
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    s67 = k[6]
    s69 = k[7]
    s0 = (cx * cx)
    s2 = (cy * cy)
    s4 = (cz * cz)
    s7 = (1.0 / (0.25*s0 + 0.25*s2 + 0.25*s4 + 1))
    s8 = -0.5*s2
    s9 = -0.5*s4
    R_11 = s7*(s8 + s9) + 1
    s13 = 0.5*cx*cy
    R_12 = s7*(-cz + s13)
    s16 = 0.5*cx*cz
    R_13 = s7*(cy + s16)
    R_21 = s7*(cz + s13)
    s21 = -0.5*s0
    R_22 = s7*(s21 + s9) + 1
    s25 = 0.5*cy*cz
    R_23 = s7*(-cx + s25)
    R_31 = s7*(-cy + s16)
    R_32 = s7*(cx + s25)
    R_33 = s7*(s21 + s8) + 1
    b_x = s44 - tx
    b_y = s48 - ty
    b_z = s50 - tz
    B_x = R_11*b_x + R_12*b_y + R_13*b_z + px
    B_y = R_21*b_x + R_22*b_y + R_23*b_z + py
    B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz
    d_x = -A_x + B_x
    d_y = -A_y + B_y
    d_z = -A_z + B_z
    s = q*s67 + s69
    s85 = -s
    s86 = 2*d_z
    s87 = 0.5*s86
    s88 = 2*d_y
    s89 = 0.5*s88
    s90 = 2*d_x
    s91 = 0.5*s90
    s93 = q*s85
    s112 = R_13*s91 + R_23*s89 + R_33*s87
    s113 = R_12*s91 + R_22*s89 + R_32*s87
    s114 = R_11*s91 + R_21*s89 + R_31*s87
    out = np.zeros((11, *(k.shape[1], x.shape[-1])))
    out[0] = -s91
    out[1] = -s89
    out[2] = -s87
    out[3] = s114
    out[4] = s113
    out[5] = s112
    out[6] = s85
    out[7] = s93
    out[8] = -s114
    out[9] = -s113
    out[10] = -s112
    return out


def _home(x, q, tool, k):
    """Platform at home, whatever the joint: (6, limbs, N)."""
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s205 = k[12]
    s206 = s205 + tz
    out = np.zeros((6, *(k.shape[1], x.shape[-1])))
    out[0] = tx
    out[1] = ty
    out[2] = s206
    out[3] = 0
    out[4] = 0
    out[5] = 0
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (1, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s44 = k[0]
    s48 = k[1]
    s50 = k[2]
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    s184 = k[8]
    s186 = k[9]
    s192 = k[10]
    s195 = k[11]
    s0 = (cx * cx)
    s2 = (cy * cy)
    s4 = (cz * cz)
    s7 = (1.0 / (0.25*s0 + 0.25*s2 + 0.25*s4 + 1))
    s8 = -0.5*s2
    s9 = -0.5*s4
    R_11 = s7*(s8 + s9) + 1
    s13 = 0.5*cx*cy
    s16 = 0.5*cx*cz
    s21 = -0.5*s0
    R_22 = s7*(s21 + s9) + 1
    s25 = 0.5*cy*cz
    R_33 = s7*(s21 + s8) + 1
    b_x = s44 - tx
    b_y = s48 - ty
    b_z = s50 - tz
    s171 = ((-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px) * (-A_x + R_11*b_x + b_y*s7*(-cz + s13) + b_z*s7*(cy + s16) + px))
    s176 = ((-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py) * (-A_y + R_22*b_y + b_x*s7*(cz + s13) + b_z*s7*(-cx + s25) + py))
    s181 = ((-A_z + R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz) * (-A_z + R_33*b_z + b_x*s7*(-cy + s16) + b_y*s7*(cx + s25) + pz))
    s196 = s195 + np.sqrt(s186*(0.5*s171 + 0.5*s176 + 0.5*s181 + s184) + s192)
    out = np.zeros((1, *(k.shape[1], x.shape[-1])))
    out[0] = s196
    return out


def _spin(x):
    """Turn about the axes of {O} by the Cayley vector: (9, N)."""
    cx = x[3]
    cy = x[4]
    cz = x[5]
    s7 = (1.0 / (0.25*(cx * cx) + 0.25*(cy * cy) + 0.25*(cz * cz) + 1))
    s207 = -0.5*cz*s7
    s208 = 0.5*cy*s7
    s209 = -0.5*cx*s7
    out = np.zeros((9, *x.shape[1:]))
    out[0] = s7
    out[1] = s207
    out[2] = s208
    out[3] = -s207
    out[4] = s7
    out[5] = s209
    out[6] = -s208
    out[7] = -s209
    out[8] = s7
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
    x, tool, k = (np.broadcast_to(a, (len(a), 6, len(x))).copy() for a in (x.T[:, None], tool.T[:, None], k.T))
    return x, q.T.copy(), tool, k


def _by_rod(values):
    """Return what a kernel gives of the rods of a limb (rods k, limbs, N) as (6, k, N): limb by limb."""
    each = len(values) // 1
    by_rod = values.reshape(1, each, *values.shape[1:])
    return by_rod.transpose(2, 0, 1, 3).reshape(6, each, values.shape[2])


def _closure(x, q, tool, k):
    """Return F (6, N), J_x (6, 6, N) and the joints' part J_q (6, N)."""
    rows = _by_rod(_newton(*_turned(x, q, tool, k)))
    return rows[:, 0], rows[:, 1 : 7], rows[:, 7]


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
            x[:] = _home(*_turned(x, q, tool, k))[:, 0].T
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
    x[:, :6] = target
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
        A = np.zeros((6, 6, len(active)))
        A[range(6), np.arange(6) // 1] = J_q
        A[:, 6:] = J_x[:, 6:]
        step, regular = _solve(A, F[:, None])
        status[active[~regular]] = np.where(
            np.abs(F[:, ~regular]).max(axis=0, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE
        )
        active, step = active[regular], step[:, 0, regular].T
        q[active] -= step[:, :6]
        x[active, 6:] -= step[:, 6:]
        size = np.abs(step).max(axis=1, initial=0.0)
        status[active[size < STEP_DONE * ANGLE_STEP]] = SOLVED
        active = active[(size >= STEP_DONE * ANGLE_STEP) & (size < STEP_LOST)]
    x[status != SOLVED], q[status != SOLVED] = np.nan, np.nan


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """See ``kinematics.sensitivity``."""
    _, J_x, J_q = _closure(x, q, tool, k)
    unit, regular = _solve(J_x, np.tile(-np.eye(6)[:, :, None], len(x)))
    status[:] = np.where(regular, SOLVED, SINGULAR)
    unit[:, :, ~regular] = np.nan
    by_limb = unit.reshape(6, 6, 1, -1).transpose(3, 1, 0, 2)
    J_p = _parameters(*_turned(x, q, tool, k)).reshape(1, 11, 6, -1).transpose(3, 2, 0, 1)
    S_p[:] = (by_limb @ J_p).transpose(0, 2, 1, 3).reshape(S_p.shape)
    S_q[:] = np.moveaxis((unit * J_q).reshape(6, 6, 1, -1).sum(axis=2), -1, 0)
    W = _spin(x.T).T.reshape(-1, 3, 3)
    S_p[:, 3:], S_q[:, 3:] = W @ S_p[:, 3:], W @ S_q[:, 3:]
