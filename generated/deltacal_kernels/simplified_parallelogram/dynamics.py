"""Dynamics of `simplified_parallelogram`, many samples at once: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both f87657e556c0e9ab; SymPy 1.14.0.

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
