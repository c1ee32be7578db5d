"""Dynamics of `diamond`, many samples at once: Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 6bcb50d852ee3ed4; SymPy 1.14.0.

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
