"""Kinematics of `robotennis` in plain NumPy: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both a451481c801c4ecf; SymPy 1.14.0.

The functions of ``kinematics.py`` over all poses at once, from the same lowered kernels. Nothing is compiled: a first
small job is done before Numba would be loaded, and the compiled kernels have an independent check.
"""

import numpy as np

SOLVED, UNREACHABLE, SINGULAR = 0, 1, 2
MAX_STEPS = 30
STEP_DONE = 1e-9  # mm and rad; Newton is quadratic: after such a step the rest is rounding
STEP_LOST = 1e5  # mm and rad; a step of this size leads nowhere
ANGLE_STEP = 1e-3  # rad per mm: joints and rotations are asked for this much finer than lengths
CLOSED = 1e-3  # mm^2: loops that are open by more where Newton gets stuck cannot be closed
PIVOT_SINGULAR = 1e-9  # of the largest entry of its matrix, in mm


def constants(p):
    """Return k (M, 3, 23), what no pose changes, from p (44 operations).

    All rows at once.
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


def _newton(x, q, tool, k):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint: (N, 5)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    q = q
    theta0 = k[:, 0]
    s0 = k[:, 1]
    s2 = k[:, 2]
    s9 = k[:, 3]
    s12 = k[:, 4]
    s14 = k[:, 5]
    s18 = k[:, 6]
    s20 = k[:, 7]
    tip_v = k[:, 8]
    px0 = k[:, 9]
    py0 = k[:, 10]
    pz0 = k[:, 11]
    s29 = k[:, 12]
    s31 = k[:, 13]
    s44 = k[:, 14]
    s4 = q + theta0
    s5 = np.cos(s4)
    arm_x = s0*s5
    arm_y = s2*s5
    arm_z = np.sin(s4)
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
    out = np.zeros((len(x), 5))
    out[:, 0] = s45
    out[:, 1] = s51
    out[:, 2] = s49
    out[:, 3] = s47
    out[:, 4] = s72
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (N, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    q = q
    theta0 = k[:, 0]
    s0 = k[:, 1]
    s2 = k[:, 2]
    s9 = k[:, 3]
    s12 = k[:, 4]
    s14 = k[:, 5]
    s18 = k[:, 6]
    s20 = k[:, 7]
    tip_v = k[:, 8]
    px0 = k[:, 9]
    py0 = k[:, 10]
    pz0 = k[:, 11]
    s29 = k[:, 12]
    s31 = k[:, 13]
    s75 = k[:, 22]
    s4 = q + theta0
    s5 = np.cos(s4)
    arm_x = s0*s5
    arm_y = s2*s5
    arm_z = np.sin(s4)
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
    out = np.zeros((len(x), 9))
    out[:, 0] = s73
    out[:, 1] = s75
    out[:, 2] = s78
    out[:, 3] = s72
    out[:, 4] = s51
    out[:, 5] = s49
    out[:, 6] = s47
    out[:, 7] = s81
    out[:, 8] = s84
    return out


def _sphere(x, q, tool, k):
    """The simplified limb as a sphere |P|^2 / 2 - c.P + d = 0: c, d: (N, 4)."""
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    q = q
    theta0 = k[:, 0]
    s9 = k[:, 3]
    pz0 = k[:, 11]
    s44 = k[:, 14]
    s85 = k[:, 15]
    s87 = k[:, 16]
    s89 = k[:, 17]
    s91 = k[:, 18]
    s4 = q + theta0
    s5 = np.cos(s4)
    arm_z = np.sin(s4)
    s127 = -s5*s87 - s85 + tx
    s129 = -s5*s91 - s89 + ty
    s130 = arm_z*s9 - pz0 + tz
    s137 = 0.5*(s127 * s127) + 0.5*(s129 * s129) + 0.5*(s130 * s130) + s44
    out = np.zeros((len(x), 4))
    out[:, 0] = s127
    out[:, 1] = s129
    out[:, 2] = s130
    out[:, 3] = s137
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (N, 1)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    theta0 = k[:, 0]
    pz0 = k[:, 11]
    s85 = k[:, 15]
    s87 = k[:, 16]
    s89 = k[:, 17]
    s91 = k[:, 18]
    s106 = k[:, 19]
    s113 = k[:, 20]
    s118 = k[:, 21]
    centre_z = pz + pz0 - tz
    s86 = px + s85 - tx
    s90 = py + s89 - ty
    s93 = s86*s87 + s90*s91
    s95 = (centre_z * centre_z)
    s107 = s106 + 0.5*(s86 * s86) + 0.5*(s90 * s90) + 0.5*s95
    s116 = np.sqrt(-(s107 * s107) + s113*s95 + (s93 * s93))
    s125 = -theta0 + np.arctan2(centre_z*s107*s118 + s116*s93, centre_z*s116*s118 - s107*s93)
    out = np.zeros((len(x), 1))
    out[:, 0] = s125
    return out


def _of(k, chosen):
    return k[chosen] if len(k) > 1 else k


def _closure(x, q, tool, k):
    """Return F (N, 3), J_x (N, 3, 3) and the joints' part J_q (N, 3)."""
    parts = [_newton(x, q[:, i], tool, k[:, i]).reshape(len(x), 1, 5) for i in range(3)]
    rows = np.concatenate(parts, axis=1)
    return rows[:, :, 0], rows[:, :, 1 : 4], rows[:, :, 4]


def _solve(A, B):
    """Return X of A X = B (N, n, m) by Gauss elimination with partial pivoting, and (N,) whether A is regular."""
    A, B = A.copy(), B.copy()
    n = A.shape[1]
    smallest = PIVOT_SINGULAR * np.abs(A).max(axis=(1, 2), initial=0.0)
    regular = np.isfinite(A).all(axis=(1, 2))
    every = np.arange(len(A))
    for c in range(n):
        pivot = c + np.argmax(np.abs(A[:, c:, c]), axis=1)
        A[every, c], A[every, pivot] = A[every, pivot], A[every, c].copy()
        B[every, c], B[every, pivot] = B[every, pivot], B[every, c].copy()
        regular &= np.abs(A[:, c, c]) > smallest
        head = np.where(regular, A[:, c, c], 1.0)
        factor = A[:, c + 1 :, c] / head[:, None]
        A[:, c + 1 :] -= factor[:, :, None] * A[:, None, c]
        B[:, c + 1 :] -= factor[:, :, None] * B[:, None, c]
    for c in range(n - 1, -1, -1):
        B[:, c] /= np.where(regular, A[:, c, c], 1.0)[:, None]
        B[:, :c] -= A[:, :c, c, None] * B[:, None, c]
    return B, regular


def jacobians(x, q, tool, k, F, J_x, J_q, J_p):
    """See ``kinematics.jacobians``."""
    F[:], J_x[:], J_q[:] = _closure(x, q, tool, k)
    for i in range(3):
        rows = slice(1 * i, 1 * i + 1)
        J_p[:, rows] = _parameters(x, q[:, i], tool, k[:, i]).reshape(len(x), 1, 9)


def _meet(sphere):
    """Return where three spheres (N, 3, 4) meet, (N, 3), and (N,) whether their centres lie off one line.

    Differences of the spheres are planes; two planes are a line, on which the first sphere is a quadratic. Where the
    line misses the sphere its nearest point is taken.
    """
    a, b = sphere[:, 1] - sphere[:, 0], sphere[:, 2] - sphere[:, 0]
    n = np.cross(a[:, :3], b[:, :3])
    nn, aa, bb, ab = ((u[:, :3] * v[:, :3]).sum(axis=1) for u, v in ((n, n), (a, a), (b, b), (a, b)))
    apart = nn > PIVOT_SINGULAR * aa * bb
    nn = np.where(apart, nn, 1.0)
    u, v = (a[:, 3] * bb - b[:, 3] * ab) / nn, (b[:, 3] * aa - a[:, 3] * ab) / nn
    p = u[:, None] * a[:, :3] + v[:, None] * b[:, :3]
    half = ((p - sphere[:, 0, :3]) * n).sum(axis=1)
    rest = 0.5 * (p * p).sum(axis=1) - (sphere[:, 0, :3] * p).sum(axis=1) + sphere[:, 0, 3]
    root = np.sqrt(np.maximum(half * half - 2.0 * nn * rest, 0.0))
    t = (-half + np.where(n[:, 2] > 0.0, 1.0, -1.0) * root) / nn
    return p + t[:, None] * n, apart


def forward(q, tool, k, x, status, warm):
    """See ``kinematics.forward``."""
    status[:] = UNREACHABLE
    if not (warm and np.isfinite(x).all()):
        x[:] = 0.0
        sphere = np.stack([_sphere(x, q[:, i], tool, k[:, i]) for i in range(3)], axis=1)
        x[:, :3], apart = _meet(sphere)
        status[~apart] = SINGULAR
    active = np.flatnonzero(status == UNREACHABLE)
    for _ in range(MAX_STEPS):
        if not len(active):
            break
        F, J_x, _ = _closure(x[active], q[active], tool[active], _of(k, active))
        step, regular = _solve(J_x, F[:, :, None])
        status[active[~regular]] = np.where(np.abs(F[~regular]).max(axis=1, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE)
        active, step = active[regular], step[regular, :, 0]
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
        for i in range(3):
            start = _joint(x, 0.0, tool, k[:, i])
            q[:, i] = start[:, 0]
    status[:] = UNREACHABLE
    active = np.flatnonzero(np.isfinite(q).all(axis=1))
    for _ in range(MAX_STEPS):
        if not len(active):
            break
        F, J_x, J_q = _closure(x[active], q[active], tool[active], _of(k, active))
        A = np.zeros((len(active), 3, 3))
        for r in range(3):
            A[:, r, r // 1] = J_q[:, r]
        A[:, :, 3:] = J_x[:, :, 3:]
        step, regular = _solve(A, F[:, :, None])
        status[active[~regular]] = np.where(np.abs(F[~regular]).max(axis=1, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE)
        active, step = active[regular], step[regular, :, 0]
        q[active] -= step[:, :3]
        x[active, 3:] -= step[:, 3:]
        size = np.abs(step).max(axis=1, initial=0.0)
        status[active[size < STEP_DONE * ANGLE_STEP]] = SOLVED
        active = active[(size >= STEP_DONE * ANGLE_STEP) & (size < STEP_LOST)]
    x[status != SOLVED], q[status != SOLVED] = np.nan, np.nan


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """See ``kinematics.sensitivity``."""
    _, J_x, J_q = _closure(x, q, tool, k)
    unit, regular = _solve(J_x, np.tile(-np.eye(3), (len(x), 1, 1)))
    status[:] = np.where(regular, SOLVED, SINGULAR)
    unit[~regular] = np.nan
    for i in range(3):
        rows = slice(1 * i, 1 * i + 1)
        J_p = _parameters(x, q[:, i], tool, k[:, i]).reshape(len(x), 1, 9)
        S_p[:, :, 9 * i : 9 * i + 9] = unit[:, :, rows] @ J_p
        S_q[:, :, i] = (unit[:, :, rows] * J_q[:, None, rows]).sum(axis=2)
