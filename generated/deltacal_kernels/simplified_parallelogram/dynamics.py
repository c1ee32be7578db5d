"""Dynamics of `simplified_parallelogram`, many samples at once: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 47273ad9804f4bb1; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 3)  platform: px py cz
motion (3, N, 1)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 1, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 1, 4)  what `constants` makes of p (M, 1, 11)
gravity (3,)  in {O} [m/s^2]      shares (1,)  of a rod's mass at either end: 1/6 where it is uniform
inertia (6,)  of `LIMB`, limb by limb, then of `PLATFORM`, of which the payload is the last

Samples stand side by side as in ``kinematics.py``: a limb has a second region d, and s holds what all limbs share. What
bodies ask for is linear in their inertial parameters: `torque` sums it up, `regressor` gives it one by one, without the
payload. Both are NaN where x is, and where the machine is singular or nearly so.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import cosine, scratch, sine
from deltacal_kernels.straight import straight

from .blocks import LANES, WORK, hold, load
from .kinematics import _begin, _early, _inverse_of_rows, _joints, _more, _place, _rows
from .kinematics import _move as _move_platform

# (name, unit, meaning) of the inertial parameters of a limb, and of the platform
LIMB = (
    ("m_arm", "kg", "mass of the arm, at its joint"),
    ("mx_arm", "kg mm", "its first moment along the arm"),
    ("i_arm", "kg mm^2", "its inertia about the joint"),
    ("m_rod", "kg", "mass of the rod that is not driven, which goes as the other"),
)
PLATFORM = (
    ("m_platform", "kg", "mass of the platform, at its centre"),
    ("payload", "kg", "mass at the reference point"),
)
OWN, SHARED = 736, 768  # numbers of a limb's second region; of what all share
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


def stated(geometry, masses, own):
    """Return what a robot file says of inertial parameters, by name: one value, or one per limb.

    `own` is a limb's own inertia about its centre of mass [kg mm^2].
    """
    l1 = geometry["l1"]
    proximal = masses["proximal"]
    proximal_com = masses["proximal_com"]
    distal_rod = masses["distal_rod"]
    platform = masses["platform"]
    return {
        "m_arm": proximal,
        "mx_arm": l1*proximal*proximal_com,
        "i_arm": (l1 * l1)*proximal*(proximal_com * proximal_com) + own,
        "m_rod": distal_rod,
        "m_platform": platform,
    }


@straight
def _fill(p, k, rows):
    for lane in range(rows):
        l1 = p[11 * lane + 6]
        q0 = p[11 * lane + 9]
        dl1 = p[11 * lane + 10]
        s1 = dl1 + l1
        s26 = (1.0 / (2*dl1 + 2*l1))
        s57 = 0.5/(s1 * s1)
        k[4 * lane + 0] = q0
        k[4 * lane + 1] = s1
        k[4 * lane + 2] = s26
        k[4 * lane + 3] = s57


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return c (M, 1, 4), what no pose changes of bodies in motion, from p (8 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 1, 4))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (18 operations)."""
    for lane in range(n):
        M_0_0 = w[1408 + lane]
        M_0_1 = w[1440 + lane]
        M_0_2 = w[1472 + lane]
        M_1_0 = w[1504 + lane]
        M_1_1 = w[1536 + lane]
        M_1_2 = w[1568 + lane]
        M_2_0 = w[1600 + lane]
        M_2_1 = w[1632 + lane]
        M_2_2 = w[1664 + lane]
        q_t_0 = d[0 + lane]
        Q_0 = w[352 + lane]
        Q_1 = w[512 + lane]
        Q_2 = w[672 + lane]
        V_0_0 = M_0_0*Q_0 + M_0_1*Q_1 + M_0_2*Q_2
        V_1_0 = M_1_0*Q_0 + M_1_1*Q_1 + M_1_2*Q_2
        V_2_0 = M_2_0*Q_0 + M_2_1*Q_1 + M_2_2*Q_2
        s12 = V_0_0*q_t_0
        s13 = V_1_0*q_t_0
        s14 = V_2_0*q_t_0
        s[0 + lane] = V_0_0
        s[32 + lane] = V_1_0
        s[64 + lane] = V_2_0
        s[96 + lane] = s12
        s[128 + lane] = s13
        s[160 + lane] = s14


@straight
def _curved(w, d, s, k, gravity, shares, n):
    """Second derivatives of a limb's equations by time where nothing accelerates (12 operations)."""
    q0 = k[0]
    s1 = k[1]
    for lane in range(n):
        q = w[0 + lane]
        q_t = d[0 + lane]
        s2 = q + q0
        s19 = -(q_t * q_t)*s1*sine(s2)
        s21 = (q_t * q_t)*s1*cosine(s2)
        d[64 + lane] = -s19
        d[96 + lane] = -s21
        d[128 + lane] = 0


@straight
def _accelerate(w, d, s, n):
    """The platform's acceleration (21 operations)."""
    for lane in range(n):
        M_0_0 = w[1408 + lane]
        M_0_1 = w[1440 + lane]
        M_0_2 = w[1472 + lane]
        M_1_0 = w[1504 + lane]
        M_1_1 = w[1536 + lane]
        M_1_2 = w[1568 + lane]
        M_2_0 = w[1600 + lane]
        M_2_1 = w[1632 + lane]
        M_2_2 = w[1664 + lane]
        q_tt_0 = d[32 + lane]
        c_0 = d[64 + lane]
        c_1 = d[96 + lane]
        c_2 = d[128 + lane]
        V_0_0 = s[0 + lane]
        V_1_0 = s[32 + lane]
        V_2_0 = s[64 + lane]
        s4 = M_0_0*c_0 + M_0_1*c_1 + M_0_2*c_2 + V_0_0*q_tt_0
        s9 = M_1_0*c_0 + M_1_1*c_1 + M_1_2*c_2 + V_1_0*q_tt_0
        s14 = M_2_0*c_0 + M_2_1*c_1 + M_2_2*c_2 + V_2_0*q_tt_0
        s[192 + lane] = s4
        s[224 + lane] = s9
        s[256 + lane] = s14


@straight
def _limb_fields(w, d, s, k, gravity, shares, n):
    """Gravity less acceleration of the points of a limb (27 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    q0 = k[0]
    s1 = k[1]
    for lane in range(n):
        q = w[0 + lane]
        q_t = d[0 + lane]
        q_tt = d[32 + lane]
        s2 = q + q0
        s3 = sine(s2)
        s5 = cosine(s2)
        s180 = s1*(-(q_t * q_t)*s3 + q_tt*s5)
        s183 = -s1*(-(q_t * q_t)*s5 - q_tt*s3)
        s255 = -0.001*s180
        s256 = gx + s255
        s257 = -0.001*s183
        s258 = gy + s257
        s259 = gx - s255
        s260 = gy - s257
        s262 = gx - 0.0005*s180
        s264 = gy - 0.0005*s183
        d[256 + lane] = s256
        d[288 + lane] = s258
        d[352 + lane] = s259
        d[384 + lane] = s260
        d[448 + lane] = s262
        d[480 + lane] = s264
        d[544 + lane] = s256
        d[576 + lane] = s258


@straight
def _limb_asks(w, d, s, k, gravity, shares, n):
    """Loads per inertial parameter of a limb, along joint, shifts and turns (40 operations)."""
    share = shares[0]
    q0 = k[0]
    s1 = k[1]
    s26 = k[2]
    s57 = k[3]
    for lane in range(n):
        q = w[0 + lane]
        f1x = d[256 + lane]
        f1y = d[288 + lane]
        f2x = d[352 + lane]
        f2y = d[384 + lane]
        f3x = d[448 + lane]
        f3y = d[480 + lane]
        f4x = d[544 + lane]
        f4y = d[576 + lane]
        s2 = q + q0
        s3 = sine(s2)
        s5 = cosine(s2)
        s52 = s1*s3*(f1y*s26 + f2y*s26) + s1*s5*(f1x*s26 + f2x*s26)
        s76 = s1*s3*(f1y*s57 - f2y*s57) + s1*s5*(f1x*s57 - f2x*s57)
        s85 = 1 - 2*share
        s116 = s1*s5*(0.5*f3x*s85 + f4x*share)
        s117 = s1*s3*(0.5*f3y*s85 + f4y*share) + s116
        d[640 + lane] = s52
        d[672 + lane] = s76
        d[704 + lane] = s117


@straight
def _platform_fields(w, d, s, gravity, n):
    """Gravity less acceleration of the points of a platform (4 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    for lane in range(n):
        v_px_t = s[192 + lane]
        v_py_t = s[224 + lane]
        s42 = gx - 0.001*v_px_t
        s44 = gy - 0.001*v_py_t
        s[288 + lane] = s42
        s[320 + lane] = s44
        s[384 + lane] = s42
        s[416 + lane] = s44


@straight
def _platform_asks(w, d, s, n):
    """Loads per inertial parameter of a platform, along joint, shifts and turns (0 operations)."""
    for lane in range(n):
        f0x = s[288 + lane]
        f0y = s[320 + lane]
        f1x = s[384 + lane]
        f1y = s[416 + lane]
        s[480 + lane] = f0x
        s[512 + lane] = f0y
        s[544 + lane] = f1x
        s[576 + lane] = f1y


@straight
def _give(d, s, inertia, n):
    """What the joints give (16 operations)."""
    m_1 = inertia[1]
    m_2 = inertia[2]
    m_3 = inertia[3]
    m_4 = inertia[4]
    m_5 = inertia[5]
    for lane in range(n):
        a_0_0 = d[640 + lane]
        a_0_1 = d[672 + lane]
        a_0_2 = d[704 + lane]
        a_p_0 = s[480 + lane]
        a_p_1 = s[512 + lane]
        a_p_2 = s[544 + lane]
        a_p_3 = s[576 + lane]
        V_0_0 = s[0 + lane]
        V_1_0 = s[32 + lane]
        W_0 = a_p_0*m_4 + a_p_2*m_5
        W_1 = a_p_1*m_4 + a_p_3*m_5
        s11 = -V_0_0*W_0 - V_1_0*W_1 - a_0_0*m_1 - a_0_1*m_2 - a_0_2*m_3
        s[608 + lane] = s11


@straight
def _give_each(d, s, n):
    """What the joints give for each inertial parameter (7 operations)."""
    for lane in range(n):
        a_0_0 = d[640 + lane]
        a_0_1 = d[672 + lane]
        a_0_2 = d[704 + lane]
        a_p_0 = s[480 + lane]
        a_p_1 = s[512 + lane]
        V_0_0 = s[0 + lane]
        V_1_0 = s[32 + lane]
        s2 = -V_0_0*a_p_0 - V_1_0*a_p_1
        s[640 + lane] = -a_0_0
        s[672 + lane] = -a_0_1
        s[704 + lane] = -a_0_2
        s[736 + lane] = s2


@straight
def _rates(speeds, accelerations, d, first, last, n):
    """Put velocities and accelerations of the joints side by side, the last ones again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        d[0 + lane] = speeds[1 * m + 0]
        d[32 + lane] = accelerations[1 * m + 0]


@straight
def _pay(w, s, tau, first, last):
    """Write what the joints give."""
    for lane in range(last - first + 1):
        regular = (w[1696 + lane] > 0.0)
        tau[1 * (first + lane) + 0] = s[608 + lane] if regular else math.nan


@straight
def _pay_each(w, s, Y, first, last):
    """Write what the joints give for each inertial parameter."""
    for lane in range(last - first + 1):
        regular = (w[1696 + lane] > 0.0)
        Y[5 * (first + lane) + 0] = 0.0 if regular else math.nan
        Y[5 * (first + lane) + 1] = s[640 + lane] if regular else math.nan
        Y[5 * (first + lane) + 2] = s[672 + lane] if regular else math.nan
        Y[5 * (first + lane) + 3] = s[704 + lane] if regular else math.nan
        Y[5 * (first + lane) + 4] = s[736 + lane] if regular else math.nan


@fast
def _torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    found = tau.reshape(tau.size)
    w, d, s = scratch(WORK), scratch(1 * OWN), scratch(SHARED)
    w_1 = w[0:1248]
    d_1 = d[0 * OWN:1 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 1 :], states[2 * samples * 1 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(states, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _rates(speeds, accelerations, d, first, last, n)
            _place(x, w, first, last, n)
            _begin(w, n)
            _move_platform(w, n)
            _early(w_1, k_1, n)
            _more(w_1, k_1, n)
            _rows(w_1, k_1, n)
            _joints(w_1, k_1, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give(d, s, inertia, n)
            _pay(w, s, found, first, last)


def torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    """Fill tau (N, 1) [N mm, N]: what the joints must give, positive along positive joints."""
    _torque(x, motion, tool, k, c, gravity, shares, inertia, tau)


@fast
def _regressor(x, motion, tool, k, c, gravity, shares, Y):
    found = Y.reshape(Y.size)
    w, d, s = scratch(WORK), scratch(1 * OWN), scratch(SHARED)
    w_1 = w[0:1248]
    d_1 = d[0 * OWN:1 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 1 :], states[2 * samples * 1 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(states, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _rates(speeds, accelerations, d, first, last, n)
            _place(x, w, first, last, n)
            _begin(w, n)
            _move_platform(w, n)
            _early(w_1, k_1, n)
            _more(w_1, k_1, n)
            _rows(w_1, k_1, n)
            _joints(w_1, k_1, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give_each(d, s, n)
            _pay_each(w, s, found, first, last)


def regressor(x, motion, tool, k, c, gravity, shares, Y):
    """Fill Y (N, 1, 5): what the joints must give for each inertial parameter, which is 1."""
    _regressor(x, motion, tool, k, c, gravity, shares, Y)


@straight
def _fill_by(p, p_by, k, rows):
    for lane in range(rows):
        l1_now = p[11 * lane + 6]
        dl1_now = p[11 * lane + 10]
        l1_now_by = p_by[11 * lane + 6]
        q0_now_by = p_by[11 * lane + 9]
        dl1_now_by = p_by[11 * lane + 10]
        s1_now = dl1_now + l1_now
        s7 = dl1_now_by + l1_now_by
        s12 = -(2*dl1_now_by + 2*l1_now_by)/((2*dl1_now + 2*l1_now) * (2*dl1_now + 2*l1_now))
        s16 = -s7/(s1_now * s1_now * s1_now)
        k[4 * lane + 0] = q0_now_by
        k[4 * lane + 1] = s7
        k[4 * lane + 2] = s12
        k[4 * lane + 3] = s16


@straight
def _fill_machine_by(p, p_by, k, rows):
    for lane in range(rows):
        l1_now = p[11 * lane + 6]
        dl1_now = p[11 * lane + 10]
        a1x_now_by = p_by[11 * lane + 0]
        b1x_now_by = p_by[11 * lane + 3]
        l1_now_by = p_by[11 * lane + 6]
        h_now_by = p_by[11 * lane + 8]
        q0_now_by = p_by[11 * lane + 9]
        dl1_now_by = p_by[11 * lane + 10]
        s1_now = dl1_now + l1_now
        s17_now = (1.0 / (s1_now * s1_now))
        s4 = -a1x_now_by + b1x_now_by
        s5 = dl1_now_by + l1_now_by
        s6 = -s17_now*s5
        s9 = -2*s5/(s1_now * s1_now * s1_now)
        k[6 * lane + 0] = q0_now_by
        k[6 * lane + 1] = s5
        k[6 * lane + 2] = s4
        k[6 * lane + 3] = h_now_by
        k[6 * lane + 4] = s6
        k[6 * lane + 5] = s9


@fast
def _constants_by(p, p_by, k, c):
    _fill_machine_by(p, p_by, k, p.shape[0] * p.shape[1])
    _fill_by(p, p_by, c, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how k and c change, which `constants` of ``kinematics.py`` and of this module make of one machine's p
    (1, 1, 11), along each of p_by (E, 1, 11)."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((len(p_by), 1, 6))
    c_by = np.empty((len(p_by), 1, 4))
    _constants_by(np.repeat(p, len(p_by), axis=0), p_by, k_by, c_by)
    return k_by, c_by


@straight
def _move_platform_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform after a step, and its rotation matrix (10 operations)."""
    for lane in range(n):
        cz_now = w[192 + lane]
        going_now = w[1376 + lane]
        y0_now_by = w_by[1248 + lane]
        y1_now_by = w_by[1280 + lane]
        y2_now_by = w_by[1312 + lane]
        s9 = -going_now*y0_now_by
        s10 = -going_now*y1_now_by
        s15 = -going_now*y2_now_by*(0.25*(cz_now * cz_now) + 1)
        w_by[128 + lane] = s9
        w_by[160 + lane] = s10
        w_by[192 + lane] = s15


@straight
def _early_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what moves with a joint only; then platform of the simplified machine at a given joint (13 operations)."""
    q0_now = k[0]
    s1_now = k[1]
    q0_now_by = k_by[0]
    s1_now_by = k_by[1]
    A_x_now_by = k_by[2]
    h_now_by = k_by[3]
    for lane in range(n):
        q_now = w[0 + lane]
        s2_now = q0_now + q_now
        s1 = sine(s2_now)
        s3 = cosine(s2_now)
        s15 = q0_now_by*s1*s1_now - s1_now_by*s3
        s16 = A_x_now_by + q0_now_by*s1_now*s3 + s1*s1_now_by
        s17 = -h_now_by + s15
        w_by[704 + lane] = s16
        w_by[736 + lane] = s15
        w_by[768 + lane] = s16
        w_by[800 + lane] = s17
        w_by[832 + lane] = 0


@straight
def _more_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what else derivatives by joint and errors read of it (9 operations)."""
    q0_now = k[0]
    s1_now = k[1]
    q0_now_by = k_by[0]
    s1_now_by = k_by[1]
    for lane in range(n):
        q_now = w[0 + lane]
        s2_now = q0_now + q_now
        s3_now = sine(s2_now)
        s5_now = cosine(s2_now)
        s4 = q0_now_by*s5_now
        s7 = s1_now*s4 + s1_now_by*s3_now
        s8 = -q0_now_by*s3_now
        w_by[960 + lane] = s7
        w_by[992 + lane] = s4
        w_by[1024 + lane] = s8


@straight
def _rows_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of equations of a limb, their derivatives by shift and turn of the platform (5 operations)."""
    h_now_by = k_by[3]
    for lane in range(n):
        cz_now = w[192 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        cz_now_by = w_by[192 + lane]
        B_x_now_by = w_by[704 + lane]
        r_y_now_by = w_by[736 + lane]
        s8 = -B_x_now_by + px_now_by
        s9 = h_now_by + py_now_by - r_y_now_by
        s12 = 0.5*cz_now*cz_now_by
        w_by[224 + lane] = s8
        w_by[256 + lane] = 0
        w_by[288 + lane] = 0
        w_by[320 + lane] = 0
        w_by[384 + lane] = s9
        w_by[416 + lane] = 0
        w_by[448 + lane] = 0
        w_by[480 + lane] = 0
        w_by[544 + lane] = cz_now_by
        w_by[576 + lane] = 0
        w_by[608 + lane] = 0
        w_by[640 + lane] = s12


@straight
def _joints_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of derivatives of a limb's equations by its joint (1 operations)."""
    for lane in range(n):
        r_y_now_by = w_by[736 + lane]
        r_x_now_by = w_by[960 + lane]
        w_by[352 + lane] = r_y_now_by
        w_by[512 + lane] = -r_x_now_by
        w_by[672 + lane] = 0


@straight
def _inverse_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of minus the inverse of the derivatives, row by row; how far the equations are from dependent (202 operations)."""
    for lane in range(n):
        J00_0_now = w[256 + lane]
        J00_1_now = w[288 + lane]
        J00_2_now = w[320 + lane]
        J01_0_now = w[416 + lane]
        J01_1_now = w[448 + lane]
        J01_2_now = w[480 + lane]
        J02_0_now = w[576 + lane]
        J02_1_now = w[608 + lane]
        J02_2_now = w[640 + lane]
        J00_0_now_by = w_by[256 + lane]
        J00_1_now_by = w_by[288 + lane]
        J00_2_now_by = w_by[320 + lane]
        J01_0_now_by = w_by[416 + lane]
        J01_1_now_by = w_by[448 + lane]
        J01_2_now_by = w_by[480 + lane]
        J02_0_now_by = w_by[576 + lane]
        J02_1_now_by = w_by[608 + lane]
        J02_2_now_by = w_by[640 + lane]
        G_cof_00_now = J01_1_now*J02_2_now - J01_2_now*J02_1_now
        G_cof_01_now = -J01_0_now*J02_2_now + J01_2_now*J02_0_now
        G_cof_02_now = J01_0_now*J02_1_now - J01_1_now*J02_0_now
        G_cof_10_now = -J00_1_now*J02_2_now + J00_2_now*J02_1_now
        G_cof_11_now = J00_0_now*J02_2_now - J00_2_now*J02_0_now
        G_cof_12_now = -J00_0_now*J02_1_now + J00_1_now*J02_0_now
        G_cof_20_now = J00_1_now*J01_2_now - J00_2_now*J01_1_now
        G_cof_21_now = -J00_0_now*J01_2_now + J00_2_now*J01_0_now
        G_cof_22_now = J00_0_now*J01_1_now - J00_1_now*J01_0_now
        G_det_00_now = G_cof_00_now*J00_0_now + G_cof_01_now*J00_1_now + G_cof_02_now*J00_2_now
        G_by_00_now = (1.0 / G_det_00_now)
        s61_now = (J01_0_now * J01_0_now) + (J01_1_now * J01_1_now) + (J01_2_now * J01_2_now)
        s65_now = (J02_0_now * J02_0_now) + (J02_1_now * J02_1_now) + (J02_2_now * J02_2_now)
        s53 = (J00_0_now * J00_0_now) + (J00_1_now * J00_1_now) + (J00_2_now * J00_2_now)
        s62 = J01_1_now*J02_2_now_by + J01_1_now_by*J02_2_now - J01_2_now*J02_1_now_by - J01_2_now_by*J02_1_now
        s69 = -J01_0_now*J02_2_now_by - J01_0_now_by*J02_2_now + J01_2_now*J02_0_now_by + J01_2_now_by*J02_0_now
        s76 = J01_0_now*J02_1_now_by + J01_0_now_by*J02_1_now - J01_1_now*J02_0_now_by - J01_1_now_by*J02_0_now
        s128 = G_cof_00_now*J00_0_now_by + G_cof_01_now*J00_1_now_by + G_cof_02_now*J00_2_now_by + J00_0_now*s62 + J00_1_now*s69 + J00_2_now*s76
        s130 = -s128/(G_det_00_now * G_det_00_now)
        s133 = G_by_00_now*s62 + G_cof_00_now*s130
        s136 = G_by_00_now*(-J00_1_now*J02_2_now_by - J00_1_now_by*J02_2_now + J00_2_now*J02_1_now_by + J00_2_now_by*J02_1_now) + G_cof_10_now*s130
        s139 = G_by_00_now*(J00_1_now*J01_2_now_by + J00_1_now_by*J01_2_now - J00_2_now*J01_1_now_by - J00_2_now_by*J01_1_now) + G_cof_20_now*s130
        s142 = G_by_00_now*s69 + G_cof_01_now*s130
        s145 = G_by_00_now*(J00_0_now*J02_2_now_by + J00_0_now_by*J02_2_now - J00_2_now*J02_0_now_by - J00_2_now_by*J02_0_now) + G_cof_11_now*s130
        s148 = G_by_00_now*(-J00_0_now*J01_2_now_by - J00_0_now_by*J01_2_now + J00_2_now*J01_0_now_by + J00_2_now_by*J01_0_now) + G_cof_21_now*s130
        s151 = G_by_00_now*s76 + G_cof_02_now*s130
        s154 = G_by_00_now*(-J00_0_now*J02_1_now_by - J00_0_now_by*J02_1_now + J00_1_now*J02_0_now_by + J00_1_now_by*J02_0_now) + G_cof_12_now*s130
        s157 = G_by_00_now*(J00_0_now*J01_1_now_by + J00_0_now_by*J01_1_now - J00_1_now*J01_0_now_by - J00_1_now_by*J01_0_now) + G_cof_22_now*s130
        s184 = -1.0e-12*s61_now*s65_now*(2*J00_0_now*J00_0_now_by + 2*J00_1_now*J00_1_now_by + 2*J00_2_now*J00_2_now_by)
        s185 = -1.0e-12*s53*s65_now*(2*J01_0_now*J01_0_now_by + 2*J01_1_now*J01_1_now_by + 2*J01_2_now*J01_2_now_by)
        s186 = -1.0e-12*s53*s61_now*(2*J02_0_now*J02_0_now_by + 2*J02_1_now*J02_1_now_by + 2*J02_2_now*J02_2_now_by)
        s188 = 2*G_det_00_now*s128 + s184 + s185 + s186
        w_by[1408 + lane] = -s133
        w_by[1440 + lane] = -s136
        w_by[1472 + lane] = -s139
        w_by[1504 + lane] = -s142
        w_by[1536 + lane] = -s145
        w_by[1568 + lane] = -s148
        w_by[1600 + lane] = -s151
        w_by[1632 + lane] = -s154
        w_by[1664 + lane] = -s157
        w_by[1696 + lane] = s188


@straight
def _move_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of how the platform moves with each joint, and how it does (57 operations)."""
    for lane in range(n):
        M_0_0_now = w[1408 + lane]
        M_0_1_now = w[1440 + lane]
        M_0_2_now = w[1472 + lane]
        M_1_0_now = w[1504 + lane]
        M_1_1_now = w[1536 + lane]
        M_1_2_now = w[1568 + lane]
        M_2_0_now = w[1600 + lane]
        M_2_1_now = w[1632 + lane]
        M_2_2_now = w[1664 + lane]
        q_t_0_now = d[0 + lane]
        Q_0_now = w[352 + lane]
        Q_1_now = w[512 + lane]
        Q_2_now = w[672 + lane]
        M_0_0_now_by = w_by[1408 + lane]
        M_0_1_now_by = w_by[1440 + lane]
        M_0_2_now_by = w_by[1472 + lane]
        M_1_0_now_by = w_by[1504 + lane]
        M_1_1_now_by = w_by[1536 + lane]
        M_1_2_now_by = w_by[1568 + lane]
        M_2_0_now_by = w_by[1600 + lane]
        M_2_1_now_by = w_by[1632 + lane]
        M_2_2_now_by = w_by[1664 + lane]
        q_t_0_now_by = d_by[0 + lane]
        Q_0_now_by = w_by[352 + lane]
        Q_1_now_by = w_by[512 + lane]
        Q_2_now_by = w_by[672 + lane]
        V_0_0_now = M_0_0_now*Q_0_now + M_0_1_now*Q_1_now + M_0_2_now*Q_2_now
        V_1_0_now = M_1_0_now*Q_0_now + M_1_1_now*Q_1_now + M_1_2_now*Q_2_now
        V_2_0_now = M_2_0_now*Q_0_now + M_2_1_now*Q_1_now + M_2_2_now*Q_2_now
        s24 = M_0_0_now*Q_0_now_by + M_0_0_now_by*Q_0_now + M_0_1_now*Q_1_now_by + M_0_1_now_by*Q_1_now + M_0_2_now*Q_2_now_by + M_0_2_now_by*Q_2_now
        s34 = M_1_0_now*Q_0_now_by + M_1_0_now_by*Q_0_now + M_1_1_now*Q_1_now_by + M_1_1_now_by*Q_1_now + M_1_2_now*Q_2_now_by + M_1_2_now_by*Q_2_now
        s44 = M_2_0_now*Q_0_now_by + M_2_0_now_by*Q_0_now + M_2_1_now*Q_1_now_by + M_2_1_now_by*Q_1_now + M_2_2_now*Q_2_now_by + M_2_2_now_by*Q_2_now
        s47 = V_0_0_now*q_t_0_now_by + q_t_0_now*s24
        s50 = V_1_0_now*q_t_0_now_by + q_t_0_now*s34
        s53 = V_2_0_now*q_t_0_now_by + q_t_0_now*s44
        s_by[0 + lane] = s24
        s_by[32 + lane] = s34
        s_by[64 + lane] = s44
        s_by[96 + lane] = s47
        s_by[128 + lane] = s50
        s_by[160 + lane] = s53


@straight
def _curved_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of second derivatives of a limb's equations by time where nothing accelerates (26 operations)."""
    q0_now = k[0]
    s1_now = k[1]
    q0_now_by = k_by[0]
    s1_now_by = k_by[1]
    for lane in range(n):
        q_now = w[0 + lane]
        q_t_now = d[0 + lane]
        q_t_now_by = d_by[0 + lane]
        s2_now = q0_now + q_now
        s1 = (q_t_now * q_t_now)
        s2 = sine(s2_now)
        s4 = cosine(s2_now)
        s7 = 2*q_t_now*q_t_now_by
        s11 = -s1*s1_now
        s15 = q0_now_by*s11*s4 - s1*s1_now_by*s2 - s1_now*s2*s7
        s22 = q0_now_by*s11*s2 + s1*s1_now_by*s4 + s1_now*s4*s7
        d_by[64 + lane] = -s15
        d_by[96 + lane] = -s22
        d_by[128 + lane] = 0


@straight
def _accelerate_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform's acceleration (45 operations)."""
    for lane in range(n):
        M_0_0_now = w[1408 + lane]
        M_0_1_now = w[1440 + lane]
        M_0_2_now = w[1472 + lane]
        M_1_0_now = w[1504 + lane]
        M_1_1_now = w[1536 + lane]
        M_1_2_now = w[1568 + lane]
        M_2_0_now = w[1600 + lane]
        M_2_1_now = w[1632 + lane]
        M_2_2_now = w[1664 + lane]
        q_tt_0_now = d[32 + lane]
        c_0_now = d[64 + lane]
        c_1_now = d[96 + lane]
        c_2_now = d[128 + lane]
        V_0_0_now = s[0 + lane]
        V_1_0_now = s[32 + lane]
        V_2_0_now = s[64 + lane]
        M_0_0_now_by = w_by[1408 + lane]
        M_0_1_now_by = w_by[1440 + lane]
        M_0_2_now_by = w_by[1472 + lane]
        M_1_0_now_by = w_by[1504 + lane]
        M_1_1_now_by = w_by[1536 + lane]
        M_1_2_now_by = w_by[1568 + lane]
        M_2_0_now_by = w_by[1600 + lane]
        M_2_1_now_by = w_by[1632 + lane]
        M_2_2_now_by = w_by[1664 + lane]
        q_tt_0_now_by = d_by[32 + lane]
        c_0_now_by = d_by[64 + lane]
        c_1_now_by = d_by[96 + lane]
        c_2_now_by = d_by[128 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_1_0_now_by = s_by[32 + lane]
        V_2_0_now_by = s_by[64 + lane]
        s26 = V_0_0_now*q_tt_0_now_by + V_0_0_now_by*q_tt_0_now
        s27 = M_0_0_now*c_0_now_by + M_0_0_now_by*c_0_now + M_0_1_now*c_1_now_by + M_0_1_now_by*c_1_now + M_0_2_now*c_2_now_by + M_0_2_now_by*c_2_now + s26
        s39 = V_1_0_now*q_tt_0_now_by + V_1_0_now_by*q_tt_0_now
        s40 = M_1_0_now*c_0_now_by + M_1_0_now_by*c_0_now + M_1_1_now*c_1_now_by + M_1_1_now_by*c_1_now + M_1_2_now*c_2_now_by + M_1_2_now_by*c_2_now + s39
        s52 = V_2_0_now*q_tt_0_now_by + V_2_0_now_by*q_tt_0_now
        s53 = M_2_0_now*c_0_now_by + M_2_0_now_by*c_0_now + M_2_1_now*c_1_now_by + M_2_1_now_by*c_1_now + M_2_2_now*c_2_now_by + M_2_2_now_by*c_2_now + s52
        s_by[192 + lane] = s27
        s_by[224 + lane] = s40
        s_by[256 + lane] = s53


@straight
def _limb_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a limb (48 operations)."""
    q0_now = k[0]
    s1_now = k[1]
    q0_now_by = k_by[0]
    s1_now_by = k_by[1]
    for lane in range(n):
        q_now = w[0 + lane]
        q_t_now = d[0 + lane]
        q_tt_now = d[32 + lane]
        q_t_now_by = d_by[0 + lane]
        q_tt_now_by = d_by[32 + lane]
        s2_now = q0_now + q_now
        s3_now = sine(s2_now)
        s5_now = cosine(s2_now)
        s4 = (q_t_now * q_t_now)
        s22 = q0_now_by*s5_now
        s23 = -q0_now_by*s3_now
        s28 = 2*q_t_now*q_t_now_by
        s34 = s1_now*(q_tt_now*s23 + q_tt_now_by*s5_now - s22*s4 - s28*s3_now)
        s35 = s1_now_by*(q_tt_now*s5_now - s3_now*s4) + s34
        s44 = -s1_now_by*(-q_tt_now*s3_now - s4*s5_now)
        s45 = -s1_now*(-q_tt_now*s22 - q_tt_now_by*s3_now - s23*s4 - s28*s5_now) + s44
        s46 = -0.001*s35
        s47 = -0.001*s45
        s48 = -0.0005*s35
        s49 = -0.0005*s45
        d_by[256 + lane] = s46
        d_by[288 + lane] = s47
        d_by[352 + lane] = -s46
        d_by[384 + lane] = -s47
        d_by[448 + lane] = s48
        d_by[480 + lane] = s49
        d_by[544 + lane] = s46
        d_by[576 + lane] = s47


@straight
def _limb_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a limb, along joint, shifts and turns (110 operations)."""
    share_now = shares[0]
    q0_now = k[0]
    s1_now = k[1]
    s26_now = k[2]
    s57_now = k[3]
    q0_now_by = k_by[0]
    s1_now_by = k_by[1]
    s26_now_by = k_by[2]
    s57_now_by = k_by[3]
    for lane in range(n):
        q_now = w[0 + lane]
        f1x_now = d[256 + lane]
        f1y_now = d[288 + lane]
        f2x_now = d[352 + lane]
        f2y_now = d[384 + lane]
        f3x_now = d[448 + lane]
        f3y_now = d[480 + lane]
        f4x_now = d[544 + lane]
        f4y_now = d[576 + lane]
        f1x_now_by = d_by[256 + lane]
        f1y_now_by = d_by[288 + lane]
        f2x_now_by = d_by[352 + lane]
        f2y_now_by = d_by[384 + lane]
        f3x_now_by = d_by[448 + lane]
        f3y_now_by = d_by[480 + lane]
        f4x_now_by = d_by[544 + lane]
        f4y_now_by = d_by[576 + lane]
        s2_now = q0_now + q_now
        s3_now = sine(s2_now)
        s5_now = cosine(s2_now)
        s5 = f1y_now*s26_now + f2y_now*s26_now
        s9 = f1x_now*s26_now + f2x_now*s26_now
        s14 = f1y_now*s57_now - f2y_now*s57_now
        s18 = f1x_now*s57_now - f2x_now*s57_now
        s85_now = 1 - 2*share_now
        s25 = 0.5*f3x_now*s85_now + f4x_now*share_now
        s29 = 0.5*f3y_now*s85_now + f4y_now*share_now
        s32 = q0_now_by*s5_now
        s33 = -q0_now_by*s3_now
        s43 = s1_now*s3_now
        s46 = s43*(f1y_now*s26_now_by + f1y_now_by*s26_now + f2y_now*s26_now_by + f2y_now_by*s26_now)
        s57 = s1_now*s5_now
        s60 = s57*(f1x_now*s26_now_by + f1x_now_by*s26_now + f2x_now*s26_now_by + f2x_now_by*s26_now)
        s61 = s1_now*s33*s9 + s1_now_by*s5_now*s9 + s60
        s62 = s1_now*s32*s5 + s1_now_by*s3_now*s5 + s46 + s61
        s74 = s14*s1_now*s32
        s75 = s14*s1_now_by*s3_now + s43*(f1y_now*s57_now_by + f1y_now_by*s57_now - f2y_now*s57_now_by - f2y_now_by*s57_now) + s74
        s87 = s18*s1_now*s33
        s88 = s18*s1_now_by*s5_now + s57*(f1x_now*s57_now_by + f1x_now_by*s57_now - f2x_now*s57_now_by - f2x_now_by*s57_now) + s87
        s89 = s75 + s88
        s91 = 0.5*s85_now
        s110 = s1_now*s29*s32 + s1_now_by*s29*s3_now + s43*(f3y_now_by*s91 + f4y_now_by*share_now)
        s111 = s110 + s1_now*s25*s33 + s1_now_by*s25*s5_now + s57*(f3x_now_by*s91 + f4x_now_by*share_now)
        d_by[640 + lane] = s62
        d_by[672 + lane] = s89
        d_by[704 + lane] = s111


@straight
def _platform_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a platform (4 operations)."""
    for lane in range(n):
        v_px_t_now_by = s_by[192 + lane]
        v_py_t_now_by = s_by[224 + lane]
        s4 = -0.001*v_px_t_now_by
        s5 = -0.001*v_py_t_now_by
        s_by[288 + lane] = s4
        s_by[320 + lane] = s5
        s_by[384 + lane] = s4
        s_by[416 + lane] = s5


@straight
def _platform_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a platform, along joint, shifts and turns (0 operations)."""
    for lane in range(n):
        f0x_now_by = s_by[288 + lane]
        f0y_now_by = s_by[320 + lane]
        f1x_now_by = s_by[384 + lane]
        f1y_now_by = s_by[416 + lane]
        s_by[480 + lane] = f0x_now_by
        s_by[512 + lane] = f0y_now_by
        s_by[544 + lane] = f1x_now_by
        s_by[576 + lane] = f1y_now_by


@straight
def _give_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what the joints give (27 operations)."""
    m_1_now = inertia[1]
    m_2_now = inertia[2]
    m_3_now = inertia[3]
    m_4_now = inertia[4]
    m_5_now = inertia[5]
    for lane in range(n):
        a_p_0_now = s[480 + lane]
        a_p_1_now = s[512 + lane]
        a_p_2_now = s[544 + lane]
        a_p_3_now = s[576 + lane]
        V_0_0_now = s[0 + lane]
        V_1_0_now = s[32 + lane]
        a_0_0_now_by = d_by[640 + lane]
        a_0_1_now_by = d_by[672 + lane]
        a_0_2_now_by = d_by[704 + lane]
        a_p_0_now_by = s_by[480 + lane]
        a_p_1_now_by = s_by[512 + lane]
        a_p_2_now_by = s_by[544 + lane]
        a_p_3_now_by = s_by[576 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_1_0_now_by = s_by[32 + lane]
        W_0_now = a_p_0_now*m_4_now + a_p_2_now*m_5_now
        W_1_now = a_p_1_now*m_4_now + a_p_3_now*m_5_now
        s23 = -V_1_0_now*(a_p_1_now_by*m_4_now + a_p_3_now_by*m_5_now) - V_1_0_now_by*W_1_now
        s26 = -a_0_2_now_by*m_3_now
        s27 = -V_0_0_now*(a_p_0_now_by*m_4_now + a_p_2_now_by*m_5_now) - V_0_0_now_by*W_0_now - a_0_0_now_by*m_1_now - a_0_1_now_by*m_2_now + s23 + s26
        s_by[608 + lane] = s27


@straight
def _step_by(moves, w_by, first, last, n):
    """Move the platform by its twists, which a step takes off, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w_by[1248 + lane] = -moves[3 * m + 0]
        w_by[1280 + lane] = -moves[3 * m + 1]
        w_by[1312 + lane] = -moves[3 * m + 2]


@straight
def _held(w, size):
    """Begin with nothing that changes."""
    for n in range(size):
        w[n] = 0.0


@straight
def _pay_by(w, s_by, tau, first, last):
    """Write how what the joints give changes."""
    for lane in range(last - first + 1):
        regular = (w[1696 + lane] > 0.0)
        tau[1 * (first + lane) + 0] = s_by[608 + lane] if regular else math.nan


@fast
def _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    found, moves = tau.reshape(tau.size), x_by.reshape(x_by.size)
    w_by, d_by, s_by = scratch(WORK), scratch(1 * OWN), scratch(SHARED)
    _held(w_by, WORK)
    _held(d_by, 1 * OWN)
    _held(s_by, SHARED)
    u_1, e_1 = w_by[0:1248], d_by[0 * OWN:1 * OWN]
    w, d, s = scratch(WORK), scratch(1 * OWN), scratch(SHARED)
    w_1 = w[0:1248]
    d_1 = d[0 * OWN:1 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 1 :], states[2 * samples * 1 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        for first in range(m * each, (m + 1) * each, LANES):
            last = min(first + LANES, (m + 1) * each) - 1
            n = (last - first + 8) // 8 * 8
            load(states, w, first, last, n)
            if len(tool) > 1:
                hold(tool, w, first, last, n)
            _rates(speeds, accelerations, d, first, last, n)
            _place(x, w, first, last, n)
            _begin(w, n)
            _move_platform(w, n)
            _early(w_1, k_1, n)
            _more(w_1, k_1, n)
            _rows(w_1, k_1, n)
            _joints(w_1, k_1, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give(d, s, inertia, n)
            for e in range(len(k_by)):
                k_by_1, own_by_1 = k_by[e, 0], c_by[e, 0]
                _step_by(moves[e * samples * 3 :], w_by, first, last, n)
                _move_platform_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _early_by(
                    w_1, u_1, d_1, e_1, s, s_by, k_1, k_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _more_by(
                    w_1, u_1, d_1, e_1, s, s_by, k_1, k_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _rows_by(
                    w_1, u_1, d_1, e_1, s, s_by, k_1, k_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _joints_by(
                    w_1, u_1, d_1, e_1, s, s_by, k_1, k_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _inverse_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _move_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _curved_by(
                    w_1, u_1, d_1, e_1, s, s_by, own_1, own_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _accelerate_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _limb_fields_by(
                    w_1, u_1, d_1, e_1, s, s_by, own_1, own_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _limb_asks_by(
                    w_1, u_1, d_1, e_1, s, s_by, own_1, own_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _platform_fields_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _platform_asks_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _give_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _pay_by(w, s_by, found[e * samples * 1 :], first, last)


def torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    """Fill tau (E, N, 1) [N mm, N]: how `torque` of one machine changes along each of E errors, joints held.

    x_by (E, N, 3) are its platform's twists along them, shift and turn about the axes of {O}; k_by and c_by are
    what `constants_by` makes of them.
    """
    _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau)
