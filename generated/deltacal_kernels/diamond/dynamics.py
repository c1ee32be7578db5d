"""Dynamics of `diamond`, many samples at once: Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both a7edf3533a14cb88; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 2)  platform: px py
motion (3, N, 2)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 2, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 2, 7)  what `constants` makes of p (M, 2, 13)
gravity (3,)  in {O} [m/s^2]      shares (2,)  of a rod's mass at either end: 1/6 where it is uniform
inertia (10,)  of `LIMB`, limb by limb, then of `PLATFORM`, of which the payload is the last

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
    ("m_rod", "kg", "mass of the distal link"),
)
PLATFORM = (
    ("m_platform", "kg", "mass of the platform, at its centre"),
    ("payload", "kg", "mass at the reference point"),
)
OWN, SHARED = 832, 960  # numbers of a limb's second region; of what all share
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


def stated(geometry, masses, own):
    """Return what a robot file says of inertial parameters, by name: one value, or one per limb.

    `own` is a limb's own inertia about its centre of mass [kg mm^2].
    """
    L = geometry["proximal_length"]
    proximal = masses["proximal"]
    proximal_com = masses["proximal_com"]
    distal_rod = masses["distal_rod"]
    platform = masses["platform"]
    return {
        "m_arm": proximal,
        "mx_arm": L*proximal*proximal_com,
        "i_arm": (L * L)*proximal*(proximal_com * proximal_com) + own,
        "m_rod": distal_rod,
        "m_platform": platform,
    }


@straight
def _fill(p, k, rows):
    for lane in range(rows):
        base_x = p[13 * lane + 0]
        base_y = p[13 * lane + 1]
        L = p[13 * lane + 2]
        side = p[13 * lane + 4]
        theta = p[13 * lane + 5]
        ex = p[13 * lane + 6]
        ey = p[13 * lane + 7]
        dL = p[13 * lane + 8]
        tip_v = p[13 * lane + 12]
        B_x = base_x*side + ex
        B_y = base_y + ey
        s3 = L + dL
        s6 = theta - 0.5*math.pi*(1 - side)
        s9 = s3*side
        s12 = -side*tip_v
        s72 = (1.0 / (2*L + 2*dL))
        s108 = 0.5/(s3 * s3)
        k[7 * lane + 0] = s6
        k[7 * lane + 1] = s9
        k[7 * lane + 2] = s12
        k[7 * lane + 3] = B_x
        k[7 * lane + 4] = B_y
        k[7 * lane + 5] = s72
        k[7 * lane + 6] = s108


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return c (M, 2, 7), what no pose changes of bodies in motion, from p (18 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 2, 7))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (10 operations)."""
    for lane in range(n):
        M_0_0 = w[1920 + lane]
        M_0_1 = w[1952 + lane]
        M_1_0 = w[1984 + lane]
        M_1_1 = w[2016 + lane]
        q_t_0 = d[0 + lane]
        Q_0 = w[288 + lane]
        q_t_1 = d[832 + lane]
        Q_1 = w[1184 + lane]
        V_0_0 = M_0_0*Q_0
        V_0_1 = M_0_1*Q_1
        V_1_0 = M_1_0*Q_0
        V_1_1 = M_1_1*Q_1
        s6 = V_0_0*q_t_0 + V_0_1*q_t_1
        s9 = V_1_0*q_t_0 + V_1_1*q_t_1
        s[0 + lane] = V_0_0
        s[32 + lane] = V_0_1
        s[64 + lane] = V_1_0
        s[96 + lane] = V_1_1
        s[128 + lane] = s6
        s[160 + lane] = s9


@straight
def _curved(w, d, s, k, gravity, shares, n):
    """Second derivatives of a limb's equations by time where nothing accelerates (42 operations)."""
    s6 = k[0]
    s9 = k[1]
    s12 = k[2]
    B_x = k[3]
    B_y = k[4]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        v_px = s[128 + lane]
        v_py = s[160 + lane]
        q_t = d[0 + lane]
        s7 = q + s6
        s8 = cosine(s7)
        s11 = sine(s7)
        C_x = B_x + s11*s12 + s8*s9
        C_y = B_y + s11*s9 - s12*s8
        A_x = px - tx
        A_y = py - ty
        d_x = A_x - C_x
        d_y = A_y - C_y
        s30 = -q_t*s11
        s32 = q_t*s8
        s38 = -s12*s32 - s30*s9 + v_px
        s39 = s12*s30 - s32*s9 + v_py
        s47 = -q_t*s32
        s49 = q_t*s30
        s64 = -d_y*(-s12*s47 + s49*s9) + (s39 * s39)
        s65 = -d_x*(s12*s49 + s47*s9) + (s38 * s38) + s64
        d[64 + lane] = s65


@straight
def _accelerate(w, d, s, n):
    """The platform's acceleration (14 operations)."""
    for lane in range(n):
        M_0_0 = w[1920 + lane]
        M_0_1 = w[1952 + lane]
        M_1_0 = w[1984 + lane]
        M_1_1 = w[2016 + lane]
        q_tt_0 = d[32 + lane]
        c_0 = d[64 + lane]
        q_tt_1 = d[864 + lane]
        c_1 = d[896 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_1_0 = s[64 + lane]
        V_1_1 = s[96 + lane]
        s4 = M_0_0*c_0 + M_0_1*c_1 + V_0_0*q_tt_0 + V_0_1*q_tt_1
        s9 = M_1_0*c_0 + M_1_1*c_1 + V_1_0*q_tt_0 + V_1_1*q_tt_1
        s[192 + lane] = s4
        s[224 + lane] = s9


@straight
def _limb_fields(w, d, s, k, gravity, shares, n):
    """Gravity less acceleration of the points of a limb (42 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    s6 = k[0]
    s9 = k[1]
    s12 = k[2]
    for lane in range(n):
        q = w[0 + lane]
        v_px_t = s[192 + lane]
        v_py_t = s[224 + lane]
        q_t = d[0 + lane]
        q_tt = d[32 + lane]
        s7 = q + s6
        s8 = cosine(s7)
        s11 = sine(s7)
        s281 = -(q_t * q_t)*s8 - q_tt*s11
        s282 = s281*s9
        s284 = -(q_t * q_t)*s11 + q_tt*s8
        s286 = s12*s284 + s282
        s288 = s284*s9
        s289 = -s12*s281 + s288
        s435 = -0.001*s282
        s436 = gx + s435
        s437 = -0.001*s288
        s438 = gy + s437
        s439 = gx - s435
        s440 = gy - s437
        s442 = gx - 0.001*s286
        s444 = gy - 0.001*s289
        s446 = gx - 0.0005*s286 - 0.0005*v_px_t
        s448 = gy - 0.0005*s289 - 0.0005*v_py_t
        s450 = gx - 0.001*v_px_t
        s452 = gy - 0.001*v_py_t
        d[192 + lane] = s436
        d[224 + lane] = s438
        d[288 + lane] = s439
        d[320 + lane] = s440
        d[384 + lane] = s442
        d[416 + lane] = s444
        d[480 + lane] = s446
        d[512 + lane] = s448
        d[576 + lane] = s450
        d[608 + lane] = s452


@straight
def _limb_asks(w, d, s, k, gravity, shares, n):
    """Loads per inertial parameter of a limb, along joint, shifts and turns (48 operations)."""
    share = shares[0]
    s6 = k[0]
    s9 = k[1]
    s12 = k[2]
    s72 = k[5]
    s108 = k[6]
    for lane in range(n):
        q = w[0 + lane]
        f1x = d[192 + lane]
        f1y = d[224 + lane]
        f2x = d[288 + lane]
        f2y = d[320 + lane]
        f3x = d[384 + lane]
        f3y = d[416 + lane]
        f4x = d[480 + lane]
        f4y = d[512 + lane]
        f5x = d[576 + lane]
        f5y = d[608 + lane]
        s7 = q + s6
        s8 = cosine(s7)
        s11 = sine(s7)
        s102 = -s11*s9*(f1x*s72 + f2x*s72) + s8*s9*(f1y*s72 + f2y*s72)
        s128 = -s11*s9*(f1x*s108 - f2x*s108) + s8*s9*(f1y*s108 - f2y*s108)
        s142 = 1 - 2*share
        s156 = 0.5*f4y*s142
        s159 = 0.5*f4x*s142
        s169 = f5y*share + s156
        s170 = f5x*share + s159
        s171 = f3y*share + s156
        s176 = f3x*share + s159
        s185 = -s11*(-s12*s171 + s176*s9) + s8*(s12*s176 + s171*s9)
        d[672 + lane] = s102
        d[704 + lane] = s128
        d[736 + lane] = s185
        d[768 + lane] = s170
        d[800 + lane] = s169


@straight
def _platform_fields(w, d, s, gravity, n):
    """Gravity less acceleration of the points of a platform (4 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    for lane in range(n):
        v_px_t = s[192 + lane]
        v_py_t = s[224 + lane]
        s66 = gx - 0.001*v_px_t
        s68 = gy - 0.001*v_py_t
        s[256 + lane] = s66
        s[288 + lane] = s68
        s[352 + lane] = s66
        s[384 + lane] = s68


@straight
def _platform_asks(w, d, s, n):
    """Loads per inertial parameter of a platform, along joint, shifts and turns (0 operations)."""
    for lane in range(n):
        f0x = s[256 + lane]
        f0y = s[288 + lane]
        f1x = s[352 + lane]
        f1y = s[384 + lane]
        s[448 + lane] = f0x
        s[480 + lane] = f0y
        s[512 + lane] = f1x
        s[544 + lane] = f1y


@straight
def _give(d, s, inertia, n):
    """What the joints give (34 operations)."""
    m_1 = inertia[1]
    m_2 = inertia[2]
    m_3 = inertia[3]
    m_5 = inertia[5]
    m_6 = inertia[6]
    m_7 = inertia[7]
    m_8 = inertia[8]
    m_9 = inertia[9]
    for lane in range(n):
        a_0_0 = d[672 + lane]
        a_0_1 = d[704 + lane]
        a_0_2 = d[736 + lane]
        a_0_3 = d[768 + lane]
        a_0_4 = d[800 + lane]
        a_1_0 = d[1504 + lane]
        a_1_1 = d[1536 + lane]
        a_1_2 = d[1568 + lane]
        a_1_3 = d[1600 + lane]
        a_1_4 = d[1632 + lane]
        a_p_0 = s[448 + lane]
        a_p_1 = s[480 + lane]
        a_p_2 = s[512 + lane]
        a_p_3 = s[544 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_1_0 = s[64 + lane]
        V_1_1 = s[96 + lane]
        W_0 = a_0_3*m_3 + a_1_3*m_7 + a_p_0*m_8 + a_p_2*m_9
        W_1 = a_0_4*m_3 + a_1_4*m_7 + a_p_1*m_8 + a_p_3*m_9
        s15 = -V_0_0*W_0 - V_1_0*W_1 - a_0_0*m_1 - a_0_1*m_2 - a_0_2*m_3
        s21 = -V_0_1*W_0 - V_1_1*W_1 - a_1_0*m_5 - a_1_1*m_6 - a_1_2*m_7
        s[576 + lane] = s15
        s[608 + lane] = s21


@straight
def _give_each(d, s, n):
    """What the joints give for each inertial parameter (30 operations)."""
    for lane in range(n):
        a_0_0 = d[672 + lane]
        a_0_1 = d[704 + lane]
        a_0_2 = d[736 + lane]
        a_0_3 = d[768 + lane]
        a_0_4 = d[800 + lane]
        a_1_0 = d[1504 + lane]
        a_1_1 = d[1536 + lane]
        a_1_2 = d[1568 + lane]
        a_1_3 = d[1600 + lane]
        a_1_4 = d[1632 + lane]
        a_p_0 = s[448 + lane]
        a_p_1 = s[480 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_1_0 = s[64 + lane]
        V_1_1 = s[96 + lane]
        s2 = -V_0_0*a_0_3 - V_1_0*a_0_4 - a_0_2
        s5 = -V_0_1*a_0_3 - V_1_1*a_0_4
        s8 = -V_0_0*a_1_3 - V_1_0*a_1_4
        s11 = -V_0_1*a_1_3 - V_1_1*a_1_4 - a_1_2
        s14 = -V_0_0*a_p_0 - V_1_0*a_p_1
        s17 = -V_0_1*a_p_0 - V_1_1*a_p_1
        s[640 + lane] = -a_0_0
        s[672 + lane] = -a_0_1
        s[704 + lane] = s2
        s[736 + lane] = s5
        s[768 + lane] = -a_1_0
        s[800 + lane] = -a_1_1
        s[832 + lane] = s8
        s[864 + lane] = s11
        s[896 + lane] = s14
        s[928 + lane] = s17


@straight
def _rates(speeds, accelerations, d, first, last, n):
    """Put velocities and accelerations of the joints side by side, the last ones again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        d[0 + lane] = speeds[2 * m + 0]
        d[32 + lane] = accelerations[2 * m + 0]
        d[832 + lane] = speeds[2 * m + 1]
        d[864 + lane] = accelerations[2 * m + 1]


@straight
def _pay(w, s, tau, first, last):
    """Write what the joints give."""
    for lane in range(last - first + 1):
        regular = (w[2048 + lane] > 0.0)
        tau[2 * (first + lane) + 0] = s[576 + lane] if regular else math.nan
        tau[2 * (first + lane) + 1] = s[608 + lane] if regular else math.nan


@straight
def _pay_each(w, s, Y, first, last):
    """Write what the joints give for each inertial parameter."""
    for lane in range(last - first + 1):
        regular = (w[2048 + lane] > 0.0)
        Y[18 * (first + lane) + 0] = 0.0 if regular else math.nan
        Y[18 * (first + lane) + 1] = s[640 + lane] if regular else math.nan
        Y[18 * (first + lane) + 2] = s[672 + lane] if regular else math.nan
        Y[18 * (first + lane) + 3] = s[704 + lane] if regular else math.nan
        Y[18 * (first + lane) + 4] = 0.0 if regular else math.nan
        Y[18 * (first + lane) + 5] = 0.0 if regular else math.nan
        Y[18 * (first + lane) + 6] = 0.0 if regular else math.nan
        Y[18 * (first + lane) + 7] = s[832 + lane] if regular else math.nan
        Y[18 * (first + lane) + 8] = s[896 + lane] if regular else math.nan
        Y[18 * (first + lane) + 9] = 0.0 if regular else math.nan
        Y[18 * (first + lane) + 10] = 0.0 if regular else math.nan
        Y[18 * (first + lane) + 11] = 0.0 if regular else math.nan
        Y[18 * (first + lane) + 12] = s[736 + lane] if regular else math.nan
        Y[18 * (first + lane) + 13] = 0.0 if regular else math.nan
        Y[18 * (first + lane) + 14] = s[768 + lane] if regular else math.nan
        Y[18 * (first + lane) + 15] = s[800 + lane] if regular else math.nan
        Y[18 * (first + lane) + 16] = s[864 + lane] if regular else math.nan
        Y[18 * (first + lane) + 17] = s[928 + lane] if regular else math.nan


@fast
def _torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    found = tau.reshape(tau.size)
    w, d, s = scratch(WORK), scratch(2 * OWN), scratch(SHARED)
    w_1 = w[0:896]
    w_2 = w[896:1792]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 2 :], states[2 * samples * 2 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
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
            _early(w_2, k_2, n)
            _more(w_2, k_2, n)
            _rows(w_2, k_2, n)
            _joints(w_2, k_2, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give(d, s, inertia, n)
            _pay(w, s, found, first, last)


def torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    """Fill tau (N, 2) [N mm, N]: what the joints must give, positive along positive joints."""
    _torque(x, motion, tool, k, c, gravity, shares, inertia, tau)


@fast
def _regressor(x, motion, tool, k, c, gravity, shares, Y):
    found = Y.reshape(Y.size)
    w, d, s = scratch(WORK), scratch(2 * OWN), scratch(SHARED)
    w_1 = w[0:896]
    w_2 = w[896:1792]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 2 :], states[2 * samples * 2 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
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
            _early(w_2, k_2, n)
            _more(w_2, k_2, n)
            _rows(w_2, k_2, n)
            _joints(w_2, k_2, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give_each(d, s, n)
            _pay_each(w, s, found, first, last)


def regressor(x, motion, tool, k, c, gravity, shares, Y):
    """Fill Y (N, 2, 9): what the joints must give for each inertial parameter, which is 1."""
    _regressor(x, motion, tool, k, c, gravity, shares, Y)


@straight
def _fill_by(p, p_by, k, rows):
    for lane in range(rows):
        base_x_now = p[13 * lane + 0]
        L_now = p[13 * lane + 2]
        side_now = p[13 * lane + 4]
        dL_now = p[13 * lane + 8]
        tip_v_now = p[13 * lane + 12]
        base_x_now_by = p_by[13 * lane + 0]
        base_y_now_by = p_by[13 * lane + 1]
        L_now_by = p_by[13 * lane + 2]
        side_now_by = p_by[13 * lane + 4]
        theta_now_by = p_by[13 * lane + 5]
        ex_now_by = p_by[13 * lane + 6]
        ey_now_by = p_by[13 * lane + 7]
        dL_now_by = p_by[13 * lane + 8]
        tip_v_now_by = p_by[13 * lane + 12]
        s3_now = L_now + dL_now
        s18 = base_x_now*side_now_by + base_x_now_by*side_now + ex_now_by
        s19 = base_y_now_by + ey_now_by
        s20 = L_now_by + dL_now_by
        s22 = 0.5*math.pi*side_now_by + theta_now_by
        s25 = s20*side_now + s3_now*side_now_by
        s28 = -side_now*tip_v_now_by - side_now_by*tip_v_now
        s33 = -(2*L_now_by + 2*dL_now_by)/((2*L_now + 2*dL_now) * (2*L_now + 2*dL_now))
        s37 = -s20/(s3_now * s3_now * s3_now)
        k[7 * lane + 0] = s22
        k[7 * lane + 1] = s25
        k[7 * lane + 2] = s28
        k[7 * lane + 3] = s18
        k[7 * lane + 4] = s19
        k[7 * lane + 5] = s33
        k[7 * lane + 6] = s37


@straight
def _fill_machine_by(p, p_by, k, rows):
    for lane in range(rows):
        base_x_now = p[13 * lane + 0]
        L_now = p[13 * lane + 2]
        l_now = p[13 * lane + 3]
        side_now = p[13 * lane + 4]
        dL_now = p[13 * lane + 8]
        dl_now = p[13 * lane + 9]
        tip_v_now = p[13 * lane + 12]
        base_x_now_by = p_by[13 * lane + 0]
        base_y_now_by = p_by[13 * lane + 1]
        L_now_by = p_by[13 * lane + 2]
        l_now_by = p_by[13 * lane + 3]
        side_now_by = p_by[13 * lane + 4]
        theta_now_by = p_by[13 * lane + 5]
        ex_now_by = p_by[13 * lane + 6]
        ey_now_by = p_by[13 * lane + 7]
        dL_now_by = p_by[13 * lane + 8]
        dl_now_by = p_by[13 * lane + 9]
        tip_v_now_by = p_by[13 * lane + 12]
        s3_now = L_now + dL_now
        s26_now = dl_now + l_now
        s59_now = (side_now * side_now)
        s60_now = (s3_now * s3_now)
        s21 = base_x_now*side_now_by + base_x_now_by*side_now + ex_now_by
        s22 = base_y_now_by + ey_now_by
        s23 = L_now_by + dL_now_by
        s25 = 0.5*math.pi*side_now_by + theta_now_by
        s28 = s23*side_now + s3_now*side_now_by
        s31 = -side_now*tip_v_now_by - side_now_by*tip_v_now
        s32 = dl_now_by + l_now_by
        s34 = 2*s26_now*s32
        s35 = -0.5*s34
        s37 = 2*side_now*side_now_by
        s39 = 2*s23*s3_now
        s45 = s35 + 0.5*s37*s60_now + 0.5*s39*s59_now
        s48 = s37*s60_now + s39*s59_now
        s51 = s23*s59_now + s37*s3_now
        k[12 * lane + 0] = s25
        k[12 * lane + 1] = s28
        k[12 * lane + 2] = s31
        k[12 * lane + 3] = s21
        k[12 * lane + 4] = s22
        k[12 * lane + 5] = s35
        k[12 * lane + 6] = s45
        k[12 * lane + 7] = s48
        k[12 * lane + 8] = s51
        k[12 * lane + 9] = side_now_by
        k[12 * lane + 10] = -s32
        k[12 * lane + 11] = s34


@fast
def _constants_by(p, p_by, k, c):
    _fill_machine_by(p, p_by, k, p.shape[0] * p.shape[1])
    _fill_by(p, p_by, c, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how k and c change, which `constants` of ``kinematics.py`` and of this module make of one machine's p
    (1, 2, 13), along each of p_by (E, 2, 13)."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((len(p_by), 2, 12))
    c_by = np.empty((len(p_by), 2, 7))
    _constants_by(np.repeat(p, len(p_by), axis=0), p_by, k_by, c_by)
    return k_by, c_by


@straight
def _move_platform_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform after a step, and its rotation matrix (4 operations)."""
    for lane in range(n):
        going_now = w[1888 + lane]
        y0_now_by = w_by[1792 + lane]
        y1_now_by = w_by[1824 + lane]
        s4 = -going_now*y0_now_by
        s5 = -going_now*y1_now_by
        w_by[128 + lane] = s4
        w_by[1024 + lane] = s4
        w_by[160 + lane] = s5
        w_by[1056 + lane] = s5


@straight
def _early_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (36 operations)."""
    s6_now = k[0]
    s9_now = k[1]
    s12_now = k[2]
    B_x_now = k[3]
    B_y_now = k[4]
    s6_now_by = k_by[0]
    s9_now_by = k_by[1]
    s12_now_by = k_by[2]
    B_x_now_by = k_by[3]
    B_y_now_by = k_by[4]
    s27_now_by = k_by[11]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        s7_now = q_now + s6_now
        s8_now = cosine(s7_now)
        s10_now = s8_now*s9_now
        s11_now = sine(s7_now)
        s16_now = s11_now*s9_now
        s79_now = B_x_now + s10_now + tx_now
        s80_now = B_y_now + s16_now + ty_now
        s14 = -s11_now*s6_now_by
        s17 = s14*s9_now + s8_now*s9_now_by
        s18 = s6_now_by*s8_now
        s22 = B_x_now_by + s11_now*s12_now_by + s12_now*s18 + s17
        s25 = s11_now*s9_now_by + s18*s9_now
        s29 = B_y_now_by - s12_now*s14 - s12_now_by*s8_now + s25
        s30 = B_x_now_by + s17
        s31 = B_y_now_by + s25
        s36 = -s27_now_by + 2*s30*s79_now + 2*s31*s80_now
        w_by[320 + lane] = s22
        w_by[352 + lane] = s29
        w_by[384 + lane] = s30
        w_by[416 + lane] = s31
        w_by[448 + lane] = s36


@straight
def _more_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what else derivatives by joint and errors read of it (21 operations)."""
    s6_now = k[0]
    s9_now = k[1]
    s12_now = k[2]
    s6_now_by = k_by[0]
    s9_now_by = k_by[1]
    s12_now_by = k_by[2]
    for lane in range(n):
        q_now = w[0 + lane]
        s7_now = q_now + s6_now
        s8_now = cosine(s7_now)
        s11_now = sine(s7_now)
        s9 = -s11_now*s6_now_by
        s10 = s6_now_by*s8_now
        s17 = s10*s9_now + s11_now*s9_now_by - s12_now*s9 - s12_now_by*s8_now
        s24 = -s10*s12_now - s11_now*s12_now_by - s8_now*s9_now_by - s9*s9_now
        w_by[512 + lane] = s10
        w_by[544 + lane] = s9
        w_by[576 + lane] = s17
        w_by[608 + lane] = s24


@straight
def _rows_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of equations of a limb, their derivatives by shift and turn of the platform (10 operations)."""
    s28_now_by = k_by[5]
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        C_x_now = w[320 + lane]
        C_y_now = w[352 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        C_x_now_by = w_by[320 + lane]
        C_y_now_by = w_by[352 + lane]
        A_x_now = px_now - tx_now
        A_y_now = py_now - ty_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        s9 = -C_x_now_by + px_now_by
        s10 = -C_y_now_by + py_now_by
        s17 = d_x_now*s9 + d_y_now*s10 + s28_now_by
        w_by[192 + lane] = s17
        w_by[224 + lane] = s9
        w_by[256 + lane] = s10


@straight
def _joints_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of derivatives of a limb's equations by its joint (13 operations)."""
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        C_x_now = w[320 + lane]
        C_y_now = w[352 + lane]
        s84_now = w[576 + lane]
        s86_now = w[608 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        C_x_now_by = w_by[320 + lane]
        C_y_now_by = w_by[352 + lane]
        s84_now_by = w_by[576 + lane]
        s86_now_by = w_by[608 + lane]
        A_x_now = px_now - tx_now
        A_y_now = py_now - ty_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        s15 = d_x_now*s84_now_by + d_y_now*s86_now_by + s84_now*(-C_x_now_by + px_now_by) + s86_now*(-C_y_now_by + py_now_by)
        w_by[288 + lane] = s15


@straight
def _inverse_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of minus the inverse of the derivatives, row by row; how far the equations are from dependent (60 operations)."""
    for lane in range(n):
        J00_0_now = w[224 + lane]
        J00_1_now = w[256 + lane]
        J10_0_now = w[1120 + lane]
        J10_1_now = w[1152 + lane]
        J00_0_now_by = w_by[224 + lane]
        J00_1_now_by = w_by[256 + lane]
        J10_0_now_by = w_by[1120 + lane]
        J10_1_now_by = w_by[1152 + lane]
        G_det_00_now = J00_0_now*J10_1_now - J00_1_now*J10_0_now
        G_by_00_now = (1.0 / G_det_00_now)
        s23 = J00_0_now*J10_1_now_by + J00_0_now_by*J10_1_now - J00_1_now*J10_0_now_by - J00_1_now_by*J10_0_now
        s25 = -s23/(G_det_00_now * G_det_00_now)
        s28 = G_by_00_now*J10_1_now_by + J10_1_now*s25
        s31 = -G_by_00_now*J00_1_now_by - J00_1_now*s25
        s34 = -G_by_00_now*J10_0_now_by - J10_0_now*s25
        s37 = G_by_00_now*J00_0_now_by + J00_0_now*s25
        s52 = (-1.0e-12*(J10_0_now * J10_0_now) - 1.0e-12*(J10_1_now * J10_1_now))*(2*J00_0_now*J00_0_now_by + 2*J00_1_now*J00_1_now_by)
        s53 = (-1.0e-12*(J00_0_now * J00_0_now) - 1.0e-12*(J00_1_now * J00_1_now))*(2*J10_0_now*J10_0_now_by + 2*J10_1_now*J10_1_now_by)
        s55 = 2*G_det_00_now*s23 + s52 + s53
        w_by[1920 + lane] = -s28
        w_by[1952 + lane] = -s31
        w_by[1984 + lane] = -s34
        w_by[2016 + lane] = -s37
        w_by[2048 + lane] = s55


@straight
def _move_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of how the platform moves with each joint, and how it does (30 operations)."""
    for lane in range(n):
        M_0_0_now = w[1920 + lane]
        M_0_1_now = w[1952 + lane]
        M_1_0_now = w[1984 + lane]
        M_1_1_now = w[2016 + lane]
        q_t_0_now = d[0 + lane]
        Q_0_now = w[288 + lane]
        q_t_1_now = d[832 + lane]
        Q_1_now = w[1184 + lane]
        M_0_0_now_by = w_by[1920 + lane]
        M_0_1_now_by = w_by[1952 + lane]
        M_1_0_now_by = w_by[1984 + lane]
        M_1_1_now_by = w_by[2016 + lane]
        q_t_0_now_by = d_by[0 + lane]
        Q_0_now_by = w_by[288 + lane]
        q_t_1_now_by = d_by[832 + lane]
        Q_1_now_by = w_by[1184 + lane]
        V_0_0_now = M_0_0_now*Q_0_now
        V_0_1_now = M_0_1_now*Q_1_now
        V_1_0_now = M_1_0_now*Q_0_now
        V_1_1_now = M_1_1_now*Q_1_now
        s12 = M_0_0_now*Q_0_now_by + M_0_0_now_by*Q_0_now
        s15 = M_0_1_now*Q_1_now_by + M_0_1_now_by*Q_1_now
        s18 = M_1_0_now*Q_0_now_by + M_1_0_now_by*Q_0_now
        s21 = M_1_1_now*Q_1_now_by + M_1_1_now_by*Q_1_now
        s28 = V_0_0_now*q_t_0_now_by + V_0_1_now*q_t_1_now_by + q_t_0_now*s12 + q_t_1_now*s15
        s35 = V_1_0_now*q_t_0_now_by + V_1_1_now*q_t_1_now_by + q_t_0_now*s18 + q_t_1_now*s21
        s_by[0 + lane] = s12
        s_by[32 + lane] = s15
        s_by[64 + lane] = s18
        s_by[96 + lane] = s21
        s_by[128 + lane] = s28
        s_by[160 + lane] = s35


@straight
def _curved_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of second derivatives of a limb's equations by time where nothing accelerates (115 operations)."""
    s6_now = k[0]
    s9_now = k[1]
    s12_now = k[2]
    B_x_now = k[3]
    B_y_now = k[4]
    s6_now_by = k_by[0]
    s9_now_by = k_by[1]
    s12_now_by = k_by[2]
    B_x_now_by = k_by[3]
    B_y_now_by = k_by[4]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        v_px_now = s[128 + lane]
        v_py_now = s[160 + lane]
        q_t_now = d[0 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        v_px_now_by = s_by[128 + lane]
        v_py_now_by = s_by[160 + lane]
        q_t_now_by = d_by[0 + lane]
        s7_now = q_now + s6_now
        s8_now = cosine(s7_now)
        s11_now = sine(s7_now)
        C_x_now = B_x_now + s11_now*s12_now + s8_now*s9_now
        C_y_now = B_y_now + s11_now*s9_now - s12_now*s8_now
        A_x_now = px_now - tx_now
        A_y_now = py_now - ty_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        s30_now = -q_t_now*s11_now
        s32_now = q_t_now*s8_now
        s38_now = -s12_now*s32_now - s30_now*s9_now + v_px_now
        s39_now = s12_now*s30_now - s32_now*s9_now + v_py_now
        s47_now = -q_t_now*s32_now
        s49_now = q_t_now*s30_now
        s35 = -s11_now*s6_now_by
        s36 = s6_now_by*s8_now
        s51 = -B_x_now_by + px_now_by - s11_now*s12_now_by - s12_now*s36 - s35*s9_now - s8_now*s9_now_by
        s52 = -B_y_now_by + py_now_by - s11_now*s9_now_by + s12_now*s35 + s12_now_by*s8_now - s36*s9_now
        s55 = -q_t_now*s36 - q_t_now_by*s11_now
        s58 = q_t_now*s35 + q_t_now_by*s8_now
        s75 = -q_t_now*s58 - q_t_now_by*s32_now
        s78 = q_t_now*s55 + q_t_now_by*s30_now
        s89 = -d_y_now*(-s12_now*s75 - s12_now_by*s47_now + s49_now*s9_now_by + s78*s9_now)
        s90 = -s52*(-s12_now*s47_now + s49_now*s9_now) + s89
        s91 = 2*s39_now*(s12_now*s55 + s12_now_by*s30_now - s32_now*s9_now_by - s58*s9_now + v_py_now_by) + s90
        s102 = -d_x_now*(s12_now*s78 + s12_now_by*s49_now + s47_now*s9_now_by + s75*s9_now)
        s103 = s102 - s51*(s12_now*s49_now + s47_now*s9_now)
        s104 = s103 + 2*s38_now*(-s12_now*s58 - s12_now_by*s32_now - s30_now*s9_now_by - s55*s9_now + v_px_now_by) + s91
        d_by[64 + lane] = s104


@straight
def _accelerate_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform's acceleration (30 operations)."""
    for lane in range(n):
        M_0_0_now = w[1920 + lane]
        M_0_1_now = w[1952 + lane]
        M_1_0_now = w[1984 + lane]
        M_1_1_now = w[2016 + lane]
        q_tt_0_now = d[32 + lane]
        c_0_now = d[64 + lane]
        q_tt_1_now = d[864 + lane]
        c_1_now = d[896 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_1_0_now = s[64 + lane]
        V_1_1_now = s[96 + lane]
        M_0_0_now_by = w_by[1920 + lane]
        M_0_1_now_by = w_by[1952 + lane]
        M_1_0_now_by = w_by[1984 + lane]
        M_1_1_now_by = w_by[2016 + lane]
        q_tt_0_now_by = d_by[32 + lane]
        c_0_now_by = d_by[64 + lane]
        q_tt_1_now_by = d_by[864 + lane]
        c_1_now_by = d_by[896 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_1_0_now_by = s_by[64 + lane]
        V_1_1_now_by = s_by[96 + lane]
        s21 = V_0_1_now*q_tt_1_now_by + V_0_1_now_by*q_tt_1_now
        s22 = M_0_0_now*c_0_now_by + M_0_0_now_by*c_0_now + M_0_1_now*c_1_now_by + M_0_1_now_by*c_1_now + V_0_0_now*q_tt_0_now_by + V_0_0_now_by*q_tt_0_now + s21
        s34 = V_1_1_now*q_tt_1_now_by + V_1_1_now_by*q_tt_1_now
        s35 = M_1_0_now*c_0_now_by + M_1_0_now_by*c_0_now + M_1_1_now*c_1_now_by + M_1_1_now_by*c_1_now + V_1_0_now*q_tt_0_now_by + V_1_0_now_by*q_tt_0_now + s34
        s_by[192 + lane] = s22
        s_by[224 + lane] = s35


@straight
def _limb_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a limb (67 operations)."""
    s6_now = k[0]
    s9_now = k[1]
    s12_now = k[2]
    s6_now_by = k_by[0]
    s9_now_by = k_by[1]
    s12_now_by = k_by[2]
    for lane in range(n):
        q_now = w[0 + lane]
        q_t_now = d[0 + lane]
        q_tt_now = d[32 + lane]
        v_px_t_now_by = s_by[192 + lane]
        v_py_t_now_by = s_by[224 + lane]
        q_t_now_by = d_by[0 + lane]
        q_tt_now_by = d_by[32 + lane]
        s7_now = q_now + s6_now
        s8_now = cosine(s7_now)
        s11_now = sine(s7_now)
        s4 = (q_t_now * q_t_now)
        s281_now = -q_tt_now*s11_now - s4*s8_now
        s284_now = q_tt_now*s8_now - s11_now*s4
        s36 = -s11_now*s6_now_by
        s37 = s6_now_by*s8_now
        s42 = 2*q_t_now*q_t_now_by
        s46 = -q_tt_now*s37 - q_tt_now_by*s11_now - s36*s4 - s42*s8_now
        s49 = s281_now*s9_now_by + s46*s9_now
        s56 = q_tt_now*s36 + q_tt_now_by*s8_now - s11_now*s42 - s37*s4
        s60 = s12_now*s56 + s12_now_by*s284_now + s49
        s63 = s284_now*s9_now_by + s56*s9_now
        s67 = -s12_now*s46 - s12_now_by*s281_now + s63
        s68 = -0.001*s49
        s69 = -0.001*s63
        s70 = -0.001*s60
        s71 = -0.001*s67
        s74 = -0.0005*s60 - 0.0005*v_px_t_now_by
        s77 = -0.0005*s67 - 0.0005*v_py_t_now_by
        s78 = -0.001*v_px_t_now_by
        s79 = -0.001*v_py_t_now_by
        d_by[192 + lane] = s68
        d_by[224 + lane] = s69
        d_by[288 + lane] = -s68
        d_by[320 + lane] = -s69
        d_by[384 + lane] = s70
        d_by[416 + lane] = s71
        d_by[480 + lane] = s74
        d_by[512 + lane] = s77
        d_by[576 + lane] = s78
        d_by[608 + lane] = s79


@straight
def _limb_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a limb, along joint, shifts and turns (130 operations)."""
    share_now = shares[0]
    s6_now = k[0]
    s9_now = k[1]
    s12_now = k[2]
    s72_now = k[5]
    s108_now = k[6]
    s6_now_by = k_by[0]
    s9_now_by = k_by[1]
    s12_now_by = k_by[2]
    s72_now_by = k_by[5]
    s108_now_by = k_by[6]
    for lane in range(n):
        q_now = w[0 + lane]
        f1x_now = d[192 + lane]
        f1y_now = d[224 + lane]
        f2x_now = d[288 + lane]
        f2y_now = d[320 + lane]
        f3x_now = d[384 + lane]
        f3y_now = d[416 + lane]
        f4x_now = d[480 + lane]
        f4y_now = d[512 + lane]
        f1x_now_by = d_by[192 + lane]
        f1y_now_by = d_by[224 + lane]
        f2x_now_by = d_by[288 + lane]
        f2y_now_by = d_by[320 + lane]
        f3x_now_by = d_by[384 + lane]
        f3y_now_by = d_by[416 + lane]
        f4x_now_by = d_by[480 + lane]
        f4y_now_by = d_by[512 + lane]
        f5x_now_by = d_by[576 + lane]
        f5y_now_by = d_by[608 + lane]
        s7_now = q_now + s6_now
        s8_now = cosine(s7_now)
        s11_now = sine(s7_now)
        s5 = f1y_now*s72_now + f2y_now*s72_now
        s9 = f1x_now*s72_now + f2x_now*s72_now
        s14 = f1y_now*s108_now - f2y_now*s108_now
        s18 = f1x_now*s108_now - f2x_now*s108_now
        s142_now = 1 - 2*share_now
        s156_now = 0.5*f4y_now*s142_now
        s159_now = 0.5*f4x_now*s142_now
        s171_now = f3y_now*share_now + s156_now
        s176_now = f3x_now*share_now + s159_now
        s42 = -s11_now*s6_now_by
        s43 = s6_now_by*s8_now
        s51 = s8_now*s9_now
        s56 = s5*s8_now*s9_now_by
        s57 = s42*s5*s9_now + s51*(f1y_now*s72_now_by + f1y_now_by*s72_now + f2y_now*s72_now_by + f2y_now_by*s72_now) + s56
        s66 = -s11_now*s9_now
        s70 = -s11_now*s9*s9_now_by
        s71 = -s43*s9*s9_now + s66*(f1x_now*s72_now_by + f1x_now_by*s72_now + f2x_now*s72_now_by + f2x_now_by*s72_now) + s70
        s72 = s57 + s71
        s84 = s14*s8_now*s9_now_by
        s85 = s14*s42*s9_now + s51*(f1y_now*s108_now_by + f1y_now_by*s108_now - f2y_now*s108_now_by - f2y_now_by*s108_now) + s84
        s97 = -s11_now*s18*s9_now_by
        s98 = -s18*s43*s9_now + s66*(f1x_now*s108_now_by + f1x_now_by*s108_now - f2x_now*s108_now_by - f2x_now_by*s108_now) + s97
        s99 = s85 + s98
        s100 = 0.5*s142_now
        s102 = f4y_now_by*s100
        s104 = f4x_now_by*s100
        s106 = f5y_now_by*share_now + s102
        s108 = f5x_now_by*share_now + s104
        s110 = f3y_now_by*share_now + s102
        s112 = f3x_now_by*share_now + s104
        s121 = s42*(s12_now*s176_now + s171_now*s9_now)
        s131 = -s11_now*(-s110*s12_now + s112*s9_now - s12_now_by*s171_now + s176_now*s9_now_by)
        s132 = s131 - s43*(-s12_now*s171_now + s176_now*s9_now)
        s133 = s121 + s132 + s8_now*(s110*s9_now + s112*s12_now + s12_now_by*s176_now + s171_now*s9_now_by)
        d_by[672 + lane] = s72
        d_by[704 + lane] = s99
        d_by[736 + lane] = s133
        d_by[768 + lane] = s108
        d_by[800 + lane] = s106


@straight
def _platform_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a platform (4 operations)."""
    for lane in range(n):
        v_px_t_now_by = s_by[192 + lane]
        v_py_t_now_by = s_by[224 + lane]
        s4 = -0.001*v_px_t_now_by
        s5 = -0.001*v_py_t_now_by
        s_by[256 + lane] = s4
        s_by[288 + lane] = s5
        s_by[352 + lane] = s4
        s_by[384 + lane] = s5


@straight
def _platform_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a platform, along joint, shifts and turns (0 operations)."""
    for lane in range(n):
        f0x_now_by = s_by[256 + lane]
        f0y_now_by = s_by[288 + lane]
        f1x_now_by = s_by[352 + lane]
        f1y_now_by = s_by[384 + lane]
        s_by[448 + lane] = f0x_now_by
        s_by[480 + lane] = f0y_now_by
        s_by[512 + lane] = f1x_now_by
        s_by[544 + lane] = f1y_now_by


@straight
def _give_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what the joints give (56 operations)."""
    m_1_now = inertia[1]
    m_2_now = inertia[2]
    m_3_now = inertia[3]
    m_5_now = inertia[5]
    m_6_now = inertia[6]
    m_7_now = inertia[7]
    m_8_now = inertia[8]
    m_9_now = inertia[9]
    for lane in range(n):
        a_0_3_now = d[768 + lane]
        a_0_4_now = d[800 + lane]
        a_1_3_now = d[1600 + lane]
        a_1_4_now = d[1632 + lane]
        a_p_0_now = s[448 + lane]
        a_p_1_now = s[480 + lane]
        a_p_2_now = s[512 + lane]
        a_p_3_now = s[544 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_1_0_now = s[64 + lane]
        V_1_1_now = s[96 + lane]
        a_0_0_now_by = d_by[672 + lane]
        a_0_1_now_by = d_by[704 + lane]
        a_0_2_now_by = d_by[736 + lane]
        a_0_3_now_by = d_by[768 + lane]
        a_0_4_now_by = d_by[800 + lane]
        a_1_0_now_by = d_by[1504 + lane]
        a_1_1_now_by = d_by[1536 + lane]
        a_1_2_now_by = d_by[1568 + lane]
        a_1_3_now_by = d_by[1600 + lane]
        a_1_4_now_by = d_by[1632 + lane]
        a_p_0_now_by = s_by[448 + lane]
        a_p_1_now_by = s_by[480 + lane]
        a_p_2_now_by = s_by[512 + lane]
        a_p_3_now_by = s_by[544 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_1_0_now_by = s_by[64 + lane]
        V_1_1_now_by = s_by[96 + lane]
        W_0_now = a_0_3_now*m_3_now + a_1_3_now*m_7_now + a_p_0_now*m_8_now + a_p_2_now*m_9_now
        W_1_now = a_0_4_now*m_3_now + a_1_4_now*m_7_now + a_p_1_now*m_8_now + a_p_3_now*m_9_now
        s26 = a_0_3_now_by*m_3_now + a_1_3_now_by*m_7_now + a_p_0_now_by*m_8_now + a_p_2_now_by*m_9_now
        s31 = a_0_4_now_by*m_3_now + a_1_4_now_by*m_7_now + a_p_1_now_by*m_8_now + a_p_3_now_by*m_9_now
        s40 = -a_0_2_now_by*m_3_now
        s41 = -V_0_0_now*s26 - V_0_0_now_by*W_0_now - V_1_0_now*s31 - V_1_0_now_by*W_1_now - a_0_0_now_by*m_1_now - a_0_1_now_by*m_2_now + s40
        s50 = -a_1_2_now_by*m_7_now
        s51 = -V_0_1_now*s26 - V_0_1_now_by*W_0_now - V_1_1_now*s31 - V_1_1_now_by*W_1_now - a_1_0_now_by*m_5_now - a_1_1_now_by*m_6_now + s50
        s_by[576 + lane] = s41
        s_by[608 + lane] = s51


@straight
def _step_by(moves, w_by, first, last, n):
    """Move the platform by its twists, which a step takes off, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w_by[1792 + lane] = -moves[2 * m + 0]
        w_by[1824 + lane] = -moves[2 * m + 1]


@straight
def _held(w, size):
    """Begin with nothing that changes."""
    for n in range(size):
        w[n] = 0.0


@straight
def _pay_by(w, s_by, tau, first, last):
    """Write how what the joints give changes."""
    for lane in range(last - first + 1):
        regular = (w[2048 + lane] > 0.0)
        tau[2 * (first + lane) + 0] = s_by[576 + lane] if regular else math.nan
        tau[2 * (first + lane) + 1] = s_by[608 + lane] if regular else math.nan


@fast
def _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    found, moves = tau.reshape(tau.size), x_by.reshape(x_by.size)
    w_by, d_by, s_by = scratch(WORK), scratch(2 * OWN), scratch(SHARED)
    _held(w_by, WORK)
    _held(d_by, 2 * OWN)
    _held(s_by, SHARED)
    u_1, e_1 = w_by[0:896], d_by[0 * OWN:1 * OWN]
    u_2, e_2 = w_by[896:1792], d_by[1 * OWN:2 * OWN]
    w, d, s = scratch(WORK), scratch(2 * OWN), scratch(SHARED)
    w_1 = w[0:896]
    w_2 = w[896:1792]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 2 :], states[2 * samples * 2 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
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
            _early(w_2, k_2, n)
            _more(w_2, k_2, n)
            _rows(w_2, k_2, n)
            _joints(w_2, k_2, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give(d, s, inertia, n)
            for e in range(len(k_by)):
                k_by_1, own_by_1 = k_by[e, 0], c_by[e, 0]
                k_by_2, own_by_2 = k_by[e, 1], c_by[e, 1]
                _step_by(moves[e * samples * 2 :], w_by, first, last, n)
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
                _early_by(
                    w_2, u_2, d_2, e_2, s, s_by, k_2, k_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _more_by(
                    w_2, u_2, d_2, e_2, s, s_by, k_2, k_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _rows_by(
                    w_2, u_2, d_2, e_2, s, s_by, k_2, k_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _joints_by(
                    w_2, u_2, d_2, e_2, s, s_by, k_2, k_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _inverse_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _move_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _curved_by(
                    w_1, u_1, d_1, e_1, s, s_by, own_1, own_by_1,
                    gravity, shares[0:], inertia, n,
                )
                _curved_by(
                    w_2, u_2, d_2, e_2, s, s_by, own_2, own_by_2,
                    gravity, shares[1:], inertia, n,
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
                _limb_fields_by(
                    w_2, u_2, d_2, e_2, s, s_by, own_2, own_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _limb_asks_by(
                    w_2, u_2, d_2, e_2, s, s_by, own_2, own_by_2,
                    gravity, shares[1:], inertia, n,
                )
                _platform_fields_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _platform_asks_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _give_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _pay_by(w, s_by, found[e * samples * 2 :], first, last)


def torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    """Fill tau (E, N, 2) [N mm, N]: how `torque` of one machine changes along each of E errors, joints held.

    x_by (E, N, 2) are its platform's twists along them, shift and turn about the axes of {O}; k_by and c_by are
    what `constants_by` makes of them.
    """
    _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau)
