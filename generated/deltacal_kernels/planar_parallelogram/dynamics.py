"""Dynamics of `planar_parallelogram`, many samples at once: Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 3a0a2fbfca475544; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 3)  platform: px py cz
motion (3, N, 1)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 1, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 1, 10)  what `constants` makes of p (M, 1, 18)
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
    ("m_rod", "kg", "mass of the rod that is not driven"),
)
PLATFORM = (
    ("m_platform", "kg", "mass of the platform, at its centre"),
    ("payload", "kg", "mass at the reference point"),
)
OWN, SHARED = 896, 800  # numbers of a limb's second region; of what all share
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
        a2x = p[18 * lane + 1]
        a2y = p[18 * lane + 2]
        b1x = p[18 * lane + 3]
        b2x = p[18 * lane + 4]
        b2y = p[18 * lane + 5]
        l1 = p[18 * lane + 6]
        h = p[18 * lane + 8]
        q0 = p[18 * lane + 9]
        da2x = p[18 * lane + 11]
        da2y = p[18 * lane + 12]
        db1x = p[18 * lane + 13]
        db2x = p[18 * lane + 14]
        db2y = p[18 * lane + 15]
        dl1 = p[18 * lane + 16]
        A2_x = a2x + da2x
        A2_y = a2y + da2y
        b1_x = -b1x - db1x
        b2_x = b2x + db2x
        b2_y = b2y + db2y
        s7 = dl1 + l1
        s110 = (1.0 / (2*dl1 + 2*l1))
        s142 = 0.5/(s7 * s7)
        k[10 * lane + 0] = h
        k[10 * lane + 1] = q0
        k[10 * lane + 2] = b1_x
        k[10 * lane + 3] = b2_x
        k[10 * lane + 4] = b2_y
        k[10 * lane + 5] = A2_x
        k[10 * lane + 6] = A2_y
        k[10 * lane + 7] = s7
        k[10 * lane + 8] = s110
        k[10 * lane + 9] = s142


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return c (M, 1, 10), what no pose changes of bodies in motion, from p (14 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 1, 10))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (18 operations)."""
    for lane in range(n):
        M_0_0 = w[2304 + lane]
        M_0_1 = w[2336 + lane]
        M_0_2 = w[2368 + lane]
        M_1_0 = w[2400 + lane]
        M_1_1 = w[2432 + lane]
        M_1_2 = w[2464 + lane]
        M_2_0 = w[2496 + lane]
        M_2_1 = w[2528 + lane]
        M_2_2 = w[2560 + lane]
        q_t_0 = d[0 + lane]
        Q_0 = w[480 + lane]
        Q_1 = w[640 + lane]
        Q_2 = w[800 + lane]
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
    """Second derivatives of a limb's equations by time where nothing accelerates (64 operations)."""
    h = k[0]
    q0 = k[1]
    b1_x = k[2]
    b2_x = k[3]
    b2_y = k[4]
    A2_x = k[5]
    A2_y = k[6]
    s7 = k[7]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        R_11 = w[224 + lane]
        R_12 = w[256 + lane]
        R_21 = w[288 + lane]
        R_22 = w[320 + lane]
        v_px = s[96 + lane]
        v_py = s[128 + lane]
        w_z = s[160 + lane]
        q_t = d[0 + lane]
        C_y = -h + ty
        s8 = q + q0
        s13 = b1_x - tx
        s20 = b2_x - tx
        s22 = -C_y + b2_y
        B2_x = R_11*s20 + R_12*s22 + px
        B2_y = R_21*s20 + R_22*s22 + py
        r2_x = -A2_x + B2_x
        r2_y = -A2_y + B2_y
        s40 = -R_21*w_z
        s41 = -R_22*w_z
        s42 = R_11*w_z
        s43 = R_12*w_z
        s56 = s20*s40 + s22*s41 + v_px
        s59 = s20*s42 + s22*s43 + v_py
        s69 = -s42*w_z
        s70 = -s43*w_z
        s71 = s40*w_z
        s72 = s41*w_z
        s89 = -C_y*s70 + (q_t * q_t)*s7*sine(s8) + s13*s69
        s90 = -C_y*s72 - (q_t * q_t)*s7*cosine(s8) + s13*s71
        s100 = r2_y*(s20*s71 + s22*s72) + (s59 * s59)
        s101 = r2_x*(s20*s69 + s22*s70) + s100 + (s56 * s56)
        d[64 + lane] = s89
        d[96 + lane] = s90
        d[128 + lane] = s101


@straight
def _accelerate(w, d, s, n):
    """The platform's acceleration (21 operations)."""
    for lane in range(n):
        M_0_0 = w[2304 + lane]
        M_0_1 = w[2336 + lane]
        M_0_2 = w[2368 + lane]
        M_1_0 = w[2400 + lane]
        M_1_1 = w[2432 + lane]
        M_1_2 = w[2464 + lane]
        M_2_0 = w[2496 + lane]
        M_2_1 = w[2528 + lane]
        M_2_2 = w[2560 + lane]
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
    """Gravity less acceleration of the points of a limb (58 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    h = k[0]
    q0 = k[1]
    b2_x = k[3]
    b2_y = k[4]
    s7 = k[7]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        R_11 = w[224 + lane]
        R_12 = w[256 + lane]
        R_21 = w[288 + lane]
        R_22 = w[320 + lane]
        w_z = s[160 + lane]
        v_px_t = s[192 + lane]
        v_py_t = s[224 + lane]
        w_z_t = s[256 + lane]
        q_t = d[0 + lane]
        q_tt = d[32 + lane]
        C_y = -h + ty
        s8 = q + q0
        s9 = sine(s8)
        s11 = cosine(s8)
        s20 = b2_x - tx
        s22 = -C_y + b2_y
        s337 = s22*(-R_12*(w_z * w_z) - R_22*w_z_t)
        s338 = s20*(-R_11*(w_z * w_z) - R_21*w_z_t) + s337 + v_px_t
        s341 = s20*(R_11*w_z_t - R_21*(w_z * w_z)) + s22*(R_12*w_z_t - R_22*(w_z * w_z)) + v_py_t
        s535 = -0.001*s7*(-(q_t * q_t)*s9 + q_tt*s11)
        s536 = gx + s535
        s537 = 0.001*s7*(-(q_t * q_t)*s11 - q_tt*s9)
        s538 = gy + s537
        s539 = gx - s535
        s540 = gy - s537
        s542 = gx - 0.0005*s338
        s544 = gy - 0.0005*s341
        s546 = gx - 0.001*s338
        s548 = gy - 0.001*s341
        d[256 + lane] = s536
        d[288 + lane] = s538
        d[352 + lane] = s539
        d[384 + lane] = s540
        d[544 + lane] = s542
        d[576 + lane] = s544
        d[640 + lane] = s546
        d[672 + lane] = s548


@straight
def _limb_asks(w, d, s, k, gravity, shares, n):
    """Loads per inertial parameter of a limb, along joint, shifts and turns (49 operations)."""
    share = shares[0]
    h = k[0]
    q0 = k[1]
    b2_x = k[3]
    b2_y = k[4]
    s7 = k[7]
    s110 = k[8]
    s142 = k[9]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        R_11 = w[224 + lane]
        R_12 = w[256 + lane]
        R_21 = w[288 + lane]
        R_22 = w[320 + lane]
        f1x = d[256 + lane]
        f1y = d[288 + lane]
        f2x = d[352 + lane]
        f2y = d[384 + lane]
        f4x = d[544 + lane]
        f4y = d[576 + lane]
        f5x = d[640 + lane]
        f5y = d[672 + lane]
        C_y = -h + ty
        s8 = q + q0
        s9 = sine(s8)
        s11 = cosine(s8)
        s20 = b2_x - tx
        s22 = -C_y + b2_y
        s137 = s11*s7*(f1x*s110 + f2x*s110) + s7*s9*(f1y*s110 + f2y*s110)
        s161 = s11*s7*(f1x*s142 - f2x*s142) + s7*s9*(f1y*s142 - f2y*s142)
        s174 = 1 - 2*share
        s201 = 0.5*f4y*s174 + f5y*share
        s206 = 0.5*f4x*s174 + f5x*share
        s218 = R_11*s20*s201 + R_12*s201*s22 - R_21*s20*s206 - R_22*s206*s22
        d[736 + lane] = s137
        d[768 + lane] = s161
        d[800 + lane] = s206
        d[832 + lane] = s201
        d[864 + lane] = s218


@straight
def _platform_fields(w, d, s, gravity, n):
    """Gravity less acceleration of the points of a platform (37 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        R_11 = w[224 + lane]
        R_12 = w[256 + lane]
        R_21 = w[288 + lane]
        R_22 = w[320 + lane]
        w_z = s[160 + lane]
        v_px_t = s[192 + lane]
        v_py_t = s[224 + lane]
        w_z_t = s[256 + lane]
        s133 = -ty*(-R_12*(w_z * w_z) - R_22*w_z_t)
        s138 = -tx*(R_11*w_z_t - R_21*(w_z * w_z)) - ty*(R_12*w_z_t - R_22*(w_z * w_z)) + v_py_t
        s168 = gx - 0.001*s133 + 0.001*tx*(-R_11*(w_z * w_z) - R_21*w_z_t) - 0.001*v_px_t
        s170 = gy - 0.001*s138
        s172 = gx - 0.001*v_px_t
        s174 = gy - 0.001*v_py_t
        s[288 + lane] = s168
        s[320 + lane] = s170
        s[384 + lane] = s172
        s[416 + lane] = s174


@straight
def _platform_asks(w, d, s, n):
    """Loads per inertial parameter of a platform, along joint, shifts and turns (11 operations)."""
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        R_11 = w[224 + lane]
        R_12 = w[256 + lane]
        R_21 = w[288 + lane]
        R_22 = w[320 + lane]
        f0x = s[288 + lane]
        f0y = s[320 + lane]
        f1x = s[384 + lane]
        f1y = s[416 + lane]
        s53 = -R_11*f0y*tx - R_12*f0y*ty + R_21*f0x*tx + R_22*f0x*ty
        s[480 + lane] = f0x
        s[512 + lane] = f0y
        s[544 + lane] = s53
        s[576 + lane] = f1x
        s[608 + lane] = f1y


@straight
def _give(d, s, inertia, n):
    """What the joints give (23 operations)."""
    m_1 = inertia[1]
    m_2 = inertia[2]
    m_3 = inertia[3]
    m_4 = inertia[4]
    m_5 = inertia[5]
    for lane in range(n):
        a_0_0 = d[736 + lane]
        a_0_1 = d[768 + lane]
        a_0_2 = d[800 + lane]
        a_0_3 = d[832 + lane]
        a_0_4 = d[864 + lane]
        a_p_0 = s[480 + lane]
        a_p_1 = s[512 + lane]
        a_p_2 = s[544 + lane]
        a_p_3 = s[576 + lane]
        a_p_4 = s[608 + lane]
        V_0_0 = s[0 + lane]
        V_1_0 = s[32 + lane]
        V_2_0 = s[64 + lane]
        W_0 = a_0_2*m_3 + a_p_0*m_4 + a_p_3*m_5
        W_1 = a_0_3*m_3 + a_p_1*m_4 + a_p_4*m_5
        W_2 = a_0_4*m_3 + a_p_2*m_4
        s16 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - a_0_0*m_1 - a_0_1*m_2
        s[640 + lane] = s16


@straight
def _give_each(d, s, n):
    """What the joints give for each inertial parameter (14 operations)."""
    for lane in range(n):
        a_0_0 = d[736 + lane]
        a_0_1 = d[768 + lane]
        a_0_2 = d[800 + lane]
        a_0_3 = d[832 + lane]
        a_0_4 = d[864 + lane]
        a_p_0 = s[480 + lane]
        a_p_1 = s[512 + lane]
        a_p_2 = s[544 + lane]
        V_0_0 = s[0 + lane]
        V_1_0 = s[32 + lane]
        V_2_0 = s[64 + lane]
        s3 = -V_0_0*a_0_2 - V_1_0*a_0_3 - V_2_0*a_0_4
        s7 = -V_0_0*a_p_0 - V_1_0*a_p_1 - V_2_0*a_p_2
        s[672 + lane] = -a_0_0
        s[704 + lane] = -a_0_1
        s[736 + lane] = s3
        s[768 + lane] = s7


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
        regular = (w[2592 + lane] > 0.0)
        tau[1 * (first + lane) + 0] = s[640 + lane] if regular else math.nan


@straight
def _pay_each(w, s, Y, first, last):
    """Write what the joints give for each inertial parameter."""
    for lane in range(last - first + 1):
        regular = (w[2592 + lane] > 0.0)
        Y[5 * (first + lane) + 0] = 0.0 if regular else math.nan
        Y[5 * (first + lane) + 1] = s[672 + lane] if regular else math.nan
        Y[5 * (first + lane) + 2] = s[704 + lane] if regular else math.nan
        Y[5 * (first + lane) + 3] = s[736 + lane] if regular else math.nan
        Y[5 * (first + lane) + 4] = s[768 + lane] if regular else math.nan


@fast
def _torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    found = tau.reshape(tau.size)
    w, d, s = scratch(WORK), scratch(1 * OWN), scratch(SHARED)
    w_1 = w[0:2144]
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
    w_1 = w[0:2144]
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
