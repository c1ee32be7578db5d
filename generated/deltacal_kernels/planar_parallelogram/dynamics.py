"""Dynamics of `planar_parallelogram`, many samples at once: Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 5e27be022abae736; SymPy 1.14.0.

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
from deltacal_kernels.elementary import arctangent, cosine, scratch, sine, tangent
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


@straight
def _fill_by(p, p_by, k, rows):
    for lane in range(rows):
        l1_now = p[18 * lane + 6]
        dl1_now = p[18 * lane + 16]
        a2x_now_by = p_by[18 * lane + 1]
        a2y_now_by = p_by[18 * lane + 2]
        b1x_now_by = p_by[18 * lane + 3]
        b2x_now_by = p_by[18 * lane + 4]
        b2y_now_by = p_by[18 * lane + 5]
        l1_now_by = p_by[18 * lane + 6]
        h_now_by = p_by[18 * lane + 8]
        q0_now_by = p_by[18 * lane + 9]
        da2x_now_by = p_by[18 * lane + 11]
        da2y_now_by = p_by[18 * lane + 12]
        db1x_now_by = p_by[18 * lane + 13]
        db2x_now_by = p_by[18 * lane + 14]
        db2y_now_by = p_by[18 * lane + 15]
        dl1_now_by = p_by[18 * lane + 16]
        s7_now = dl1_now + l1_now
        s12 = a2x_now_by + da2x_now_by
        s13 = a2y_now_by + da2y_now_by
        s14 = -b1x_now_by - db1x_now_by
        s15 = b2x_now_by + db2x_now_by
        s16 = b2y_now_by + db2y_now_by
        s17 = dl1_now_by + l1_now_by
        s22 = -(2*dl1_now_by + 2*l1_now_by)/((2*dl1_now + 2*l1_now) * (2*dl1_now + 2*l1_now))
        s26 = -s17/(s7_now * s7_now * s7_now)
        k[10 * lane + 0] = h_now_by
        k[10 * lane + 1] = q0_now_by
        k[10 * lane + 2] = s14
        k[10 * lane + 3] = s15
        k[10 * lane + 4] = s16
        k[10 * lane + 5] = s12
        k[10 * lane + 6] = s13
        k[10 * lane + 7] = s17
        k[10 * lane + 8] = s22
        k[10 * lane + 9] = s26


@straight
def _fill_machine_by(p, p_by, k, rows):
    for lane in range(rows):
        a1x_now = p[18 * lane + 0]
        a2x_now = p[18 * lane + 1]
        a2y_now = p[18 * lane + 2]
        b1x_now = p[18 * lane + 3]
        b2x_now = p[18 * lane + 4]
        b2y_now = p[18 * lane + 5]
        l1_now = p[18 * lane + 6]
        l2_now = p[18 * lane + 7]
        da1x_now = p[18 * lane + 10]
        da2x_now = p[18 * lane + 11]
        da2y_now = p[18 * lane + 12]
        db1x_now = p[18 * lane + 13]
        db2x_now = p[18 * lane + 14]
        db2y_now = p[18 * lane + 15]
        dl1_now = p[18 * lane + 16]
        dl2_now = p[18 * lane + 17]
        a1x_now_by = p_by[18 * lane + 0]
        a2x_now_by = p_by[18 * lane + 1]
        a2y_now_by = p_by[18 * lane + 2]
        b1x_now_by = p_by[18 * lane + 3]
        b2x_now_by = p_by[18 * lane + 4]
        b2y_now_by = p_by[18 * lane + 5]
        l1_now_by = p_by[18 * lane + 6]
        l2_now_by = p_by[18 * lane + 7]
        h_now_by = p_by[18 * lane + 8]
        q0_now_by = p_by[18 * lane + 9]
        da1x_now_by = p_by[18 * lane + 10]
        da2x_now_by = p_by[18 * lane + 11]
        da2y_now_by = p_by[18 * lane + 12]
        db1x_now_by = p_by[18 * lane + 13]
        db2x_now_by = p_by[18 * lane + 14]
        db2y_now_by = p_by[18 * lane + 15]
        dl1_now_by = p_by[18 * lane + 16]
        dl2_now_by = p_by[18 * lane + 17]
        A1_x_now = -a1x_now - da1x_now
        A2_x_now = a2x_now + da2x_now
        A2_y_now = a2y_now + da2y_now
        b1_x_now = -b1x_now - db1x_now
        b2_x_now = b2x_now + db2x_now
        b2_y_now = b2y_now + db2y_now
        s7_now = dl1_now + l1_now
        s69_now = dl2_now + l2_now
        s108_now = (1.0 / (s7_now * s7_now))
        s116_now = -2*b2_y_now
        s130_now = -2*b1_x_now
        s134_now = 2*b2_x_now
        s153_now = -2*A2_x_now
        s156_now = 2*A1_x_now
        s195_now = -2*A2_y_now
        s47 = -a1x_now_by - da1x_now_by
        s48 = a2x_now_by + da2x_now_by
        s49 = a2y_now_by + da2y_now_by
        s50 = -b1x_now_by - db1x_now_by
        s51 = b2x_now_by + db2x_now_by
        s52 = b2y_now_by + db2y_now_by
        s53 = dl1_now_by + l1_now_by
        s54 = dl2_now_by + l2_now_by
        s57 = -s54*s69_now
        s58 = -s108_now*s53
        s59 = -s47 + s50
        s62 = -2*s53/(s7_now * s7_now * s7_now)
        s63 = -2*s52
        s64 = -2*s7_now
        s67 = -s134_now*s53 + s51*s64
        s70 = -s130_now*s53 - s50*s64
        s82 = -s130_now*s49 - s195_now*s50
        s83 = s116_now*s47 - s116_now*s48 - s134_now*s49 - s153_now*s52 - s156_now*s52 + s195_now*s51 + s82
        s84 = -2*s50
        s88 = 2*s51
        s91 = s116_now*s53 + s52*s64
        s97 = -s134_now*s48 + s153_now*s51
        s100 = s116_now*s49 + s195_now*s52
        s103 = -s130_now*s48 - s153_now*s50
        s104 = s100 + s103 + s130_now*s47 + s134_now*s47 - s156_now*s50 + s156_now*s51 + s97
        s107 = s156_now*s47
        s108 = -s130_now*s50
        s109 = 2*dl2_now
        s110 = dl2_now_by*s109
        s111 = 2*l2_now
        s112 = l2_now_by*s111
        s113 = -s53*s64
        s116 = -dl2_now_by*s111 - l2_now_by*s109
        s119 = s153_now*s47 - s156_now*s48
        s120 = -2*s48
        s123 = s130_now*s51 - s134_now*s50
        s124 = 2*s47
        s127 = -s195_now*s53 - s49*s64
        s128 = -s153_now*s48
        s129 = -s195_now*s49
        s130 = s107 + s108 - s110 - s112 + s116 - s116_now*s52 + s119 + s123 + s128 + s129 + s134_now*s51
        s131 = -2*s49
        k[28 * lane + 0] = h_now_by
        k[28 * lane + 1] = q0_now_by
        k[28 * lane + 2] = s53
        k[28 * lane + 3] = s50
        k[28 * lane + 4] = s51
        k[28 * lane + 5] = s52
        k[28 * lane + 6] = s48
        k[28 * lane + 7] = s49
        k[28 * lane + 8] = s47
        k[28 * lane + 9] = s57
        k[28 * lane + 10] = s59
        k[28 * lane + 11] = s58
        k[28 * lane + 12] = s62
        k[28 * lane + 13] = s63
        k[28 * lane + 14] = s67
        k[28 * lane + 15] = s70
        k[28 * lane + 16] = s83
        k[28 * lane + 17] = s84
        k[28 * lane + 18] = s88
        k[28 * lane + 19] = s91
        k[28 * lane + 20] = s104
        k[28 * lane + 21] = s113
        k[28 * lane + 22] = s120
        k[28 * lane + 23] = s124
        k[28 * lane + 24] = s127
        k[28 * lane + 25] = s130
        k[28 * lane + 26] = -s54
        k[28 * lane + 27] = s131


@fast
def _constants_by(p, p_by, k, c):
    _fill_machine_by(p, p_by, k, p.shape[0] * p.shape[1])
    _fill_by(p, p_by, c, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how k and c change, which `constants` of ``kinematics.py`` and of this module make of one machine's p
    (1, 1, 18), along each of p_by (E, 1, 18)."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((len(p_by), 1, 28))
    c_by = np.empty((len(p_by), 1, 10))
    _constants_by(np.repeat(p, len(p_by), axis=0), p_by, k_by, c_by)
    return k_by, c_by


@straight
def _move_platform_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform after a step, and its rotation matrix (34 operations)."""
    for lane in range(n):
        cz_now = w[192 + lane]
        y2_now = w[2208 + lane]
        going_now = w[2272 + lane]
        y0_now_by = w_by[2144 + lane]
        y1_now_by = w_by[2176 + lane]
        y2_now_by = w_by[2208 + lane]
        s6 = 0.25*(cz_now * cz_now) + 1
        new_20_now = cz_now - going_now*s6*y2_now
        s9_now = (new_20_now * new_20_now)
        s11 = 0.25*s9_now + 1
        s12_now = (1.0 / s11)
        s16 = -going_now*y0_now_by
        s17 = -going_now*y1_now_by
        s22 = -going_now*s6*y2_now_by
        s24 = 2*new_20_now*s22
        s27 = -0.25*s24/(s11 * s11)
        s32 = -0.5*s12_now*s24 - 0.5*s27*s9_now
        s35 = -new_20_now*s27 - s12_now*s22
        w_by[128 + lane] = s16
        w_by[160 + lane] = s17
        w_by[192 + lane] = s22
        w_by[224 + lane] = s32
        w_by[256 + lane] = s35
        w_by[288 + lane] = -s35
        w_by[320 + lane] = s32


@straight
def _early_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what moves with a joint only; then platform of the simplified machine at a given joint (191 operations)."""
    h_now = k[0]
    q0_now = k[1]
    s7_now = k[2]
    b1_x_now = k[3]
    s116_now = k[13]
    s124_now = k[16]
    s130_now = k[17]
    s134_now = k[18]
    s138_now = k[20]
    s153_now = k[22]
    s156_now = k[23]
    s160_now = k[25]
    s195_now = k[27]
    h_now_by = k_by[0]
    q0_now_by = k_by[1]
    s7_now_by = k_by[2]
    b1_x_now_by = k_by[3]
    b2_x_now_by = k_by[4]
    b2_y_now_by = k_by[5]
    A1_x_now_by = k_by[8]
    s116_now_by = k_by[13]
    s124_now_by = k_by[16]
    s130_now_by = k_by[17]
    s134_now_by = k_by[18]
    s138_now_by = k_by[20]
    s153_now_by = k_by[22]
    s156_now_by = k_by[23]
    s160_now_by = k_by[25]
    s195_now_by = k_by[27]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        C_y_now = -h_now + ty_now
        s8_now = q0_now + q_now
        s2 = sine(s8_now)
        r1_x_now = s2*s7_now
        s4 = cosine(s8_now)
        r1_y_now = -s4*s7_now
        s22_now = b1_x_now - tx_now
        s185_now = r1_x_now*s116_now + r1_y_now*s130_now + r1_y_now*s134_now + s124_now
        s190_now = r1_x_now*s130_now + r1_x_now*s134_now - r1_y_now*s116_now + s138_now
        s198_now = (r1_x_now * r1_x_now) + r1_x_now*s153_now + r1_x_now*s156_now + (r1_y_now * r1_y_now) + r1_y_now*s195_now + s160_now
        s26 = (s185_now * s185_now) + (s190_now * s190_now) - (s198_now * s198_now)
        s201_now = math.sqrt(s26)
        s204_now = -s185_now*s198_now + s190_now*s201_now
        s208_now = -s185_now*s201_now - s190_now*s198_now
        s36 = (s204_now * s204_now) + (s208_now * s208_now)
        s211_now = 1/math.sqrt(s36)
        s51 = q0_now_by*s4*s7_now + s2*s7_now_by
        s55 = q0_now_by*s2*s7_now - s4*s7_now_by
        s56 = b2_y_now_by + h_now_by
        s66 = r1_x_now*s116_now_by + r1_y_now*s130_now_by + r1_y_now*s134_now_by + s116_now*s51 + s124_now_by + s130_now*s55 + s134_now*s55
        s76 = r1_x_now*s130_now_by + r1_x_now*s134_now_by - r1_y_now*s116_now_by - s116_now*s55 + s130_now*s51 + s134_now*s51 + s138_now_by
        s86 = r1_x_now*s156_now_by + s156_now*s51
        s89 = r1_y_now*s195_now_by + s195_now*s55
        s90 = r1_x_now*s153_now_by + 2*r1_x_now*s51 + 2*r1_y_now*s55 + s153_now*s51 + s160_now_by + s86 + s89
        s100 = 0.5*(2*s185_now*s66 + 2*s190_now*s76 - 2*s198_now*s90)/math.sqrt(s26)
        s107 = s100*s190_now - s185_now*s90 - s198_now*s66 + s201_now*s76
        s114 = -s100*s185_now - s190_now*s90 - s198_now*s76 - s201_now*s66
        s122 = -0.5*(2*s107*s204_now + 2*s114*s208_now)/(s36 * math.sqrt(s36))
        s123 = -s204_now*s211_now
        s124 = -C_y_now*s211_now
        s130 = -s211_now*s22_now
        s132 = -s208_now*s211_now
        s136 = b1_x_now_by*s132 + s114*s130 - s122*s208_now*s22_now
        s137 = A1_x_now_by - C_y_now*s122*s204_now - h_now_by*s123 + s107*s124 + s136 + s51
        s147 = b1_x_now_by*s123 + s107*s130 - s122*s204_now*s22_now
        s148 = C_y_now*s122*s208_now + h_now_by*s132 - s114*s124 + s147 + s55
        s149 = (1.0 / s36)
        s157 = ((tangent(0.5*arctangent(s204_now, s208_now))) * (tangent(0.5*arctangent(s204_now, s208_now)))) + 1
        s159 = 2*s157*(0.5*s107*s149*s208_now - 0.5*s114*s149*s204_now)
        w_by[832 + lane] = b1_x_now_by
        w_by[864 + lane] = -h_now_by
        w_by[896 + lane] = b2_x_now_by
        w_by[928 + lane] = s56
        w_by[960 + lane] = s51
        w_by[992 + lane] = s55
        w_by[1024 + lane] = s137
        w_by[1056 + lane] = s148
        w_by[1088 + lane] = s159


@straight
def _more_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what else derivatives by joint and errors read of it (6 operations)."""
    q0_now = k[1]
    q0_now_by = k_by[1]
    for lane in range(n):
        q_now = w[0 + lane]
        s8_now = q0_now + q_now
        s9_now = sine(s8_now)
        s11_now = cosine(s8_now)
        s3 = q0_now_by*s11_now
        s4 = -q0_now_by*s9_now
        w_by[1216 + lane] = s3
        w_by[1248 + lane] = s4


@straight
def _rows_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of equations of a limb, their derivatives by shift and turn of the platform (69 operations)."""
    A2_x_now = k[6]
    A2_y_now = k[7]
    A2_x_now_by = k_by[6]
    A2_y_now_by = k_by[7]
    A1_x_now_by = k_by[8]
    s71_now_by = k_by[9]
    for lane in range(n):
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        R_11_now = w[224 + lane]
        R_12_now = w[256 + lane]
        R_21_now = w[288 + lane]
        R_22_now = w[320 + lane]
        s22_now = w[832 + lane]
        C_y_now = w[864 + lane]
        s29_now = w[896 + lane]
        s31_now = w[928 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        R_11_now_by = w_by[224 + lane]
        R_12_now_by = w_by[256 + lane]
        R_21_now_by = w_by[288 + lane]
        R_22_now_by = w_by[320 + lane]
        s22_now_by = w_by[832 + lane]
        C_y_now_by = w_by[864 + lane]
        s29_now_by = w_by[896 + lane]
        s31_now_by = w_by[928 + lane]
        r1_x_now_by = w_by[960 + lane]
        r1_y_now_by = w_by[992 + lane]
        s30_now = R_11_now*s29_now
        s32_now = R_12_now*s31_now
        B2_x_now = px_now + s30_now + s32_now
        s34_now = R_21_now*s29_now
        s35_now = R_22_now*s31_now
        B2_y_now = py_now + s34_now + s35_now
        r2_x_now = -A2_x_now + B2_x_now
        r2_y_now = -A2_y_now + B2_y_now
        s30 = R_11_now*s22_now_by + R_11_now_by*s22_now
        s33 = -C_y_now*R_12_now_by - C_y_now_by*R_12_now
        s37 = R_21_now*s22_now_by + R_21_now_by*s22_now
        s40 = -C_y_now*R_22_now_by - C_y_now_by*R_22_now
        s44 = R_11_now*s29_now_by + R_11_now_by*s29_now
        s47 = R_12_now*s31_now_by + R_12_now_by*s31_now
        s51 = R_21_now*s29_now_by + R_21_now_by*s29_now
        s54 = R_22_now*s31_now_by + R_22_now_by*s31_now
        s56 = -A2_x_now_by + px_now_by + s44 + s47
        s57 = -A2_y_now_by + py_now_by + s51 + s54
        s58 = -A1_x_now_by + px_now_by - r1_x_now_by + s30 + s33
        s59 = py_now_by - r1_y_now_by + s37 + s40
        s66 = r2_x_now*s56 + r2_y_now*s57 + s71_now_by
        s67 = -s37 - s40
        s68 = s30 + s33
        s76 = r2_y_now*(s44 + s47) + s57*(s30_now + s32_now)
        s77 = r2_x_now*(-s51 - s54) + s56*(-s34_now - s35_now) + s76
        w_by[352 + lane] = s58
        w_by[384 + lane] = 0
        w_by[416 + lane] = 0
        w_by[448 + lane] = s67
        w_by[512 + lane] = s59
        w_by[544 + lane] = 0
        w_by[576 + lane] = 0
        w_by[608 + lane] = s68
        w_by[672 + lane] = s66
        w_by[704 + lane] = s56
        w_by[736 + lane] = s57
        w_by[768 + lane] = s77


@straight
def _joints_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of derivatives of a limb's equations by its joint (1 operations)."""
    for lane in range(n):
        r1_x_now_by = w_by[960 + lane]
        r1_y_now_by = w_by[992 + lane]
        w_by[480 + lane] = r1_y_now_by
        w_by[640 + lane] = -r1_x_now_by
        w_by[800 + lane] = 0


@straight
def _inverse_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of minus the inverse of the derivatives, row by row; how far the equations are from dependent (202 operations)."""
    for lane in range(n):
        J00_0_now = w[384 + lane]
        J00_1_now = w[416 + lane]
        J00_2_now = w[448 + lane]
        J01_0_now = w[544 + lane]
        J01_1_now = w[576 + lane]
        J01_2_now = w[608 + lane]
        J02_0_now = w[704 + lane]
        J02_1_now = w[736 + lane]
        J02_2_now = w[768 + lane]
        J00_0_now_by = w_by[384 + lane]
        J00_1_now_by = w_by[416 + lane]
        J00_2_now_by = w_by[448 + lane]
        J01_0_now_by = w_by[544 + lane]
        J01_1_now_by = w_by[576 + lane]
        J01_2_now_by = w_by[608 + lane]
        J02_0_now_by = w_by[704 + lane]
        J02_1_now_by = w_by[736 + lane]
        J02_2_now_by = w_by[768 + lane]
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
        w_by[2304 + lane] = -s133
        w_by[2336 + lane] = -s136
        w_by[2368 + lane] = -s139
        w_by[2400 + lane] = -s142
        w_by[2432 + lane] = -s145
        w_by[2464 + lane] = -s148
        w_by[2496 + lane] = -s151
        w_by[2528 + lane] = -s154
        w_by[2560 + lane] = -s157
        w_by[2592 + lane] = s188


@straight
def _move_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of how the platform moves with each joint, and how it does (57 operations)."""
    for lane in range(n):
        M_0_0_now = w[2304 + lane]
        M_0_1_now = w[2336 + lane]
        M_0_2_now = w[2368 + lane]
        M_1_0_now = w[2400 + lane]
        M_1_1_now = w[2432 + lane]
        M_1_2_now = w[2464 + lane]
        M_2_0_now = w[2496 + lane]
        M_2_1_now = w[2528 + lane]
        M_2_2_now = w[2560 + lane]
        q_t_0_now = d[0 + lane]
        Q_0_now = w[480 + lane]
        Q_1_now = w[640 + lane]
        Q_2_now = w[800 + lane]
        M_0_0_now_by = w_by[2304 + lane]
        M_0_1_now_by = w_by[2336 + lane]
        M_0_2_now_by = w_by[2368 + lane]
        M_1_0_now_by = w_by[2400 + lane]
        M_1_1_now_by = w_by[2432 + lane]
        M_1_2_now_by = w_by[2464 + lane]
        M_2_0_now_by = w_by[2496 + lane]
        M_2_1_now_by = w_by[2528 + lane]
        M_2_2_now_by = w_by[2560 + lane]
        q_t_0_now_by = d_by[0 + lane]
        Q_0_now_by = w_by[480 + lane]
        Q_1_now_by = w_by[640 + lane]
        Q_2_now_by = w_by[800 + lane]
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
    """Rates of second derivatives of a limb's equations by time where nothing accelerates (169 operations)."""
    h_now = k[0]
    q0_now = k[1]
    b1_x_now = k[2]
    b2_x_now = k[3]
    b2_y_now = k[4]
    A2_x_now = k[5]
    A2_y_now = k[6]
    s7_now = k[7]
    h_now_by = k_by[0]
    q0_now_by = k_by[1]
    b1_x_now_by = k_by[2]
    b2_x_now_by = k_by[3]
    b2_y_now_by = k_by[4]
    A2_x_now_by = k_by[5]
    A2_y_now_by = k_by[6]
    s7_now_by = k_by[7]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        R_11_now = w[224 + lane]
        R_12_now = w[256 + lane]
        R_21_now = w[288 + lane]
        R_22_now = w[320 + lane]
        v_px_now = s[96 + lane]
        v_py_now = s[128 + lane]
        w_z_now = s[160 + lane]
        q_t_now = d[0 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        R_11_now_by = w_by[224 + lane]
        R_12_now_by = w_by[256 + lane]
        R_21_now_by = w_by[288 + lane]
        R_22_now_by = w_by[320 + lane]
        v_px_now_by = s_by[96 + lane]
        v_py_now_by = s_by[128 + lane]
        w_z_now_by = s_by[160 + lane]
        q_t_now_by = d_by[0 + lane]
        C_y_now = -h_now + ty_now
        s8_now = q0_now + q_now
        s13_now = b1_x_now - tx_now
        s20_now = b2_x_now - tx_now
        s22_now = -C_y_now + b2_y_now
        B2_x_now = R_11_now*s20_now + R_12_now*s22_now + px_now
        B2_y_now = R_21_now*s20_now + R_22_now*s22_now + py_now
        r2_x_now = -A2_x_now + B2_x_now
        r2_y_now = -A2_y_now + B2_y_now
        s40_now = -R_21_now*w_z_now
        s41_now = -R_22_now*w_z_now
        s42_now = R_11_now*w_z_now
        s43_now = R_12_now*w_z_now
        s56_now = s20_now*s40_now + s22_now*s41_now + v_px_now
        s59_now = s20_now*s42_now + s22_now*s43_now + v_py_now
        s69_now = -s42_now*w_z_now
        s70_now = -s43_now*w_z_now
        s71_now = s40_now*w_z_now
        s72_now = s41_now*w_z_now
        s29 = (q_t_now * q_t_now)
        s30 = sine(s8_now)
        s35 = cosine(s8_now)
        s50 = b2_y_now_by + h_now_by
        s65 = -A2_x_now_by + R_11_now*b2_x_now_by + R_11_now_by*s20_now + R_12_now*s50 + R_12_now_by*s22_now + px_now_by
        s66 = -A2_y_now_by + R_21_now*b2_x_now_by + R_21_now_by*s20_now + R_22_now*s50 + R_22_now_by*s22_now + py_now_by
        s69 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now
        s72 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now
        s75 = R_11_now*w_z_now_by + R_11_now_by*w_z_now
        s78 = R_12_now*w_z_now_by + R_12_now_by*w_z_now
        s95 = -s42_now*w_z_now_by - s75*w_z_now
        s98 = -s43_now*w_z_now_by - s78*w_z_now
        s101 = s40_now*w_z_now_by + s69*w_z_now
        s104 = s41_now*w_z_now_by + s72*w_z_now
        s112 = 2*q_t_now*q_t_now_by
        s115 = s29*s7_now
        s120 = q0_now_by*s115*s35 + s112*s30*s7_now + s29*s30*s7_now_by
        s121 = -C_y_now*s98 + b1_x_now_by*s69_now + h_now_by*s70_now + s120 + s13_now*s95
        s134 = q0_now_by*s115*s30 - s112*s35*s7_now - s29*s35*s7_now_by
        s135 = -C_y_now*s104 + b1_x_now_by*s71_now + h_now_by*s72_now + s101*s13_now + s134
        s146 = r2_y_now*(b2_x_now_by*s71_now + s101*s20_now + s104*s22_now + s50*s72_now)
        s147 = s146 + s66*(s20_now*s71_now + s22_now*s72_now)
        s148 = s147 + 2*s59_now*(b2_x_now_by*s42_now + s20_now*s75 + s22_now*s78 + s43_now*s50 + v_py_now_by)
        s159 = r2_x_now*(b2_x_now_by*s69_now + s20_now*s95 + s22_now*s98 + s50*s70_now)
        s160 = s159 + s65*(s20_now*s69_now + s22_now*s70_now)
        s161 = s148 + s160 + 2*s56_now*(b2_x_now_by*s40_now + s20_now*s69 + s22_now*s72 + s41_now*s50 + v_px_now_by)
        d_by[64 + lane] = s121
        d_by[96 + lane] = s135
        d_by[128 + lane] = s161


@straight
def _accelerate_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform's acceleration (45 operations)."""
    for lane in range(n):
        M_0_0_now = w[2304 + lane]
        M_0_1_now = w[2336 + lane]
        M_0_2_now = w[2368 + lane]
        M_1_0_now = w[2400 + lane]
        M_1_1_now = w[2432 + lane]
        M_1_2_now = w[2464 + lane]
        M_2_0_now = w[2496 + lane]
        M_2_1_now = w[2528 + lane]
        M_2_2_now = w[2560 + lane]
        q_tt_0_now = d[32 + lane]
        c_0_now = d[64 + lane]
        c_1_now = d[96 + lane]
        c_2_now = d[128 + lane]
        V_0_0_now = s[0 + lane]
        V_1_0_now = s[32 + lane]
        V_2_0_now = s[64 + lane]
        M_0_0_now_by = w_by[2304 + lane]
        M_0_1_now_by = w_by[2336 + lane]
        M_0_2_now_by = w_by[2368 + lane]
        M_1_0_now_by = w_by[2400 + lane]
        M_1_1_now_by = w_by[2432 + lane]
        M_1_2_now_by = w_by[2464 + lane]
        M_2_0_now_by = w_by[2496 + lane]
        M_2_1_now_by = w_by[2528 + lane]
        M_2_2_now_by = w_by[2560 + lane]
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
    """Rates of gravity less acceleration of the points of a limb (120 operations)."""
    h_now = k[0]
    q0_now = k[1]
    b2_x_now = k[3]
    b2_y_now = k[4]
    s7_now = k[7]
    h_now_by = k_by[0]
    q0_now_by = k_by[1]
    b2_x_now_by = k_by[3]
    b2_y_now_by = k_by[4]
    s7_now_by = k_by[7]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        R_11_now = w[224 + lane]
        R_12_now = w[256 + lane]
        R_21_now = w[288 + lane]
        R_22_now = w[320 + lane]
        w_z_now = s[160 + lane]
        w_z_t_now = s[256 + lane]
        q_t_now = d[0 + lane]
        q_tt_now = d[32 + lane]
        R_11_now_by = w_by[224 + lane]
        R_12_now_by = w_by[256 + lane]
        R_21_now_by = w_by[288 + lane]
        R_22_now_by = w_by[320 + lane]
        w_z_now_by = s_by[160 + lane]
        v_px_t_now_by = s_by[192 + lane]
        v_py_t_now_by = s_by[224 + lane]
        w_z_t_now_by = s_by[256 + lane]
        q_t_now_by = d_by[0 + lane]
        q_tt_now_by = d_by[32 + lane]
        C_y_now = -h_now + ty_now
        s8_now = q0_now + q_now
        s9_now = sine(s8_now)
        s11_now = cosine(s8_now)
        s20_now = b2_x_now - tx_now
        s22_now = -C_y_now + b2_y_now
        s6 = (w_z_now * w_z_now)
        s26 = (q_t_now * q_t_now)
        s46 = q0_now_by*s11_now
        s47 = -q0_now_by*s9_now
        s48 = b2_y_now_by + h_now_by
        s50 = 2*w_z_now*w_z_now_by
        s59 = s22_now*(-R_12_now*s50 - R_12_now_by*s6 - R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now)
        s69 = b2_x_now_by*(-R_11_now*s6 - R_21_now*w_z_t_now)
        s70 = s20_now*(-R_11_now*s50 - R_11_now_by*s6 - R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now) + s69
        s71 = s48*(-R_12_now*s6 - R_22_now*w_z_t_now) + s59 + s70 + v_px_t_now_by
        s80 = b2_x_now_by*(R_11_now*w_z_t_now - R_21_now*s6)
        s90 = s48*(R_12_now*w_z_t_now - R_22_now*s6)
        s91 = s22_now*(R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_22_now*s50 - R_22_now_by*s6) + s90
        s92 = s20_now*(R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_21_now*s50 - R_21_now_by*s6) + s80 + s91 + v_py_t_now_by
        s97 = 2*q_t_now*q_t_now_by
        s102 = -0.001*s7_now
        s105 = s7_now_by*(-0.001*q_tt_now*s11_now + 0.001*s26*s9_now)
        s106 = s102*(q_tt_now*s47 + q_tt_now_by*s11_now - s26*s46 - s97*s9_now) + s105
        s116 = s7_now_by*(-0.001*q_tt_now*s9_now - 0.001*s11_now*s26)
        s117 = -s102*(-q_tt_now*s46 - q_tt_now_by*s9_now - s11_now*s97 - s26*s47) + s116
        s118 = -0.0005*s71
        s119 = -0.0005*s92
        s120 = -0.001*s71
        s121 = -0.001*s92
        d_by[256 + lane] = s106
        d_by[288 + lane] = s117
        d_by[352 + lane] = -s106
        d_by[384 + lane] = -s117
        d_by[544 + lane] = s118
        d_by[576 + lane] = s119
        d_by[640 + lane] = s120
        d_by[672 + lane] = s121


@straight
def _limb_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a limb, along joint, shifts and turns (136 operations)."""
    share_now = shares[0]
    h_now = k[0]
    q0_now = k[1]
    b2_x_now = k[3]
    b2_y_now = k[4]
    s7_now = k[7]
    s110_now = k[8]
    s142_now = k[9]
    h_now_by = k_by[0]
    q0_now_by = k_by[1]
    b2_x_now_by = k_by[3]
    b2_y_now_by = k_by[4]
    s7_now_by = k_by[7]
    s110_now_by = k_by[8]
    s142_now_by = k_by[9]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        R_11_now = w[224 + lane]
        R_12_now = w[256 + lane]
        R_21_now = w[288 + lane]
        R_22_now = w[320 + lane]
        f1x_now = d[256 + lane]
        f1y_now = d[288 + lane]
        f2x_now = d[352 + lane]
        f2y_now = d[384 + lane]
        f4x_now = d[544 + lane]
        f4y_now = d[576 + lane]
        f5x_now = d[640 + lane]
        f5y_now = d[672 + lane]
        R_11_now_by = w_by[224 + lane]
        R_12_now_by = w_by[256 + lane]
        R_21_now_by = w_by[288 + lane]
        R_22_now_by = w_by[320 + lane]
        f1x_now_by = d_by[256 + lane]
        f1y_now_by = d_by[288 + lane]
        f2x_now_by = d_by[352 + lane]
        f2y_now_by = d_by[384 + lane]
        f4x_now_by = d_by[544 + lane]
        f4y_now_by = d_by[576 + lane]
        f5x_now_by = d_by[640 + lane]
        f5y_now_by = d_by[672 + lane]
        C_y_now = -h_now + ty_now
        s8_now = q0_now + q_now
        s9_now = sine(s8_now)
        s11_now = cosine(s8_now)
        s20_now = b2_x_now - tx_now
        s22_now = -C_y_now + b2_y_now
        s8 = f1x_now*s110_now + f2x_now*s110_now
        s12 = f1y_now*s110_now + f2y_now*s110_now
        s17 = f1x_now*s142_now - f2x_now*s142_now
        s21 = f1y_now*s142_now - f2y_now*s142_now
        s174_now = 1 - 2*share_now
        s201_now = 0.5*f4y_now*s174_now + f5y_now*share_now
        s206_now = 0.5*f4x_now*s174_now + f5x_now*share_now
        s37 = q0_now_by*s11_now
        s38 = -q0_now_by*s9_now
        s39 = b2_y_now_by + h_now_by
        s49 = s11_now*s7_now
        s52 = s49*(f1x_now*s110_now_by + f1x_now_by*s110_now + f2x_now*s110_now_by + f2x_now_by*s110_now)
        s61 = s7_now*s9_now
        s66 = s12*s37*s7_now
        s67 = s12*s7_now_by*s9_now + s61*(f1y_now*s110_now_by + f1y_now_by*s110_now + f2y_now*s110_now_by + f2y_now_by*s110_now) + s66
        s68 = s11_now*s7_now_by*s8 + s38*s7_now*s8 + s52 + s67
        s80 = s11_now*s17*s7_now_by
        s81 = s17*s38*s7_now + s49*(f1x_now*s142_now_by + f1x_now_by*s142_now - f2x_now*s142_now_by - f2x_now_by*s142_now) + s80
        s93 = s21*s37*s7_now
        s94 = s21*s7_now_by*s9_now + s61*(f1y_now*s142_now_by + f1y_now_by*s142_now - f2y_now*s142_now_by - f2y_now_by*s142_now) + s93
        s95 = s81 + s94
        s97 = 0.5*s174_now
        s100 = f4y_now_by*s97 + f5y_now_by*share_now
        s104 = f4x_now_by*s97 + f5x_now_by*share_now
        s118 = R_12_now*s100*s22_now + R_12_now*s201_now*s39 + R_12_now_by*s201_now*s22_now
        s125 = -R_21_now*b2_x_now_by*s206_now - R_21_now*s104*s20_now - R_21_now_by*s206_now*s20_now
        s132 = -R_22_now*s104*s22_now - R_22_now*s206_now*s39 - R_22_now_by*s206_now*s22_now
        s133 = R_11_now*b2_x_now_by*s201_now + R_11_now*s100*s20_now + R_11_now_by*s201_now*s20_now + s118 + s125 + s132
        d_by[736 + lane] = s68
        d_by[768 + lane] = s95
        d_by[800 + lane] = s104
        d_by[832 + lane] = s100
        d_by[864 + lane] = s133


@straight
def _platform_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a platform (50 operations)."""
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        R_11_now = w[224 + lane]
        R_12_now = w[256 + lane]
        R_21_now = w[288 + lane]
        R_22_now = w[320 + lane]
        w_z_now = s[160 + lane]
        w_z_t_now = s[256 + lane]
        R_11_now_by = w_by[224 + lane]
        R_12_now_by = w_by[256 + lane]
        R_21_now_by = w_by[288 + lane]
        R_22_now_by = w_by[320 + lane]
        w_z_now_by = s_by[160 + lane]
        v_px_t_now_by = s_by[192 + lane]
        v_py_t_now_by = s_by[224 + lane]
        w_z_t_now_by = s_by[256 + lane]
        s0 = (w_z_now * w_z_now)
        s27 = 2*w_z_now*w_z_now_by
        s51 = -ty_now*(R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_22_now*s27 - R_22_now_by*s0)
        s52 = s51 - tx_now*(R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_21_now*s27 - R_21_now_by*s0) + v_py_t_now_by
        s54 = -0.001*v_px_t_now_by
        s64 = 0.001*tx_now*(-R_11_now*s27 - R_11_now_by*s0 - R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now)
        s65 = s54 + s64 + 0.001*ty_now*(-R_12_now*s27 - R_12_now_by*s0 - R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now)
        s66 = -0.001*s52
        s67 = -0.001*v_py_t_now_by
        s_by[288 + lane] = s65
        s_by[320 + lane] = s66
        s_by[384 + lane] = s54
        s_by[416 + lane] = s67


@straight
def _platform_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a platform, along joint, shifts and turns (25 operations)."""
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        R_11_now = w[224 + lane]
        R_12_now = w[256 + lane]
        R_21_now = w[288 + lane]
        R_22_now = w[320 + lane]
        f0x_now = s[288 + lane]
        f0y_now = s[320 + lane]
        R_11_now_by = w_by[224 + lane]
        R_12_now_by = w_by[256 + lane]
        R_21_now_by = w_by[288 + lane]
        R_22_now_by = w_by[320 + lane]
        f0x_now_by = s_by[288 + lane]
        f0y_now_by = s_by[320 + lane]
        f1x_now_by = s_by[384 + lane]
        f1y_now_by = s_by[416 + lane]
        s16 = R_22_now*f0x_now_by*ty_now + R_22_now_by*f0x_now*ty_now
        s22 = -R_11_now*f0y_now_by*tx_now - R_11_now_by*f0y_now*tx_now
        s28 = -R_12_now*f0y_now_by*ty_now - R_12_now_by*f0y_now*ty_now
        s29 = R_21_now*f0x_now_by*tx_now + R_21_now_by*f0x_now*tx_now + s16 + s22 + s28
        s_by[480 + lane] = f0x_now_by
        s_by[512 + lane] = f0y_now_by
        s_by[544 + lane] = s29
        s_by[576 + lane] = f1x_now_by
        s_by[608 + lane] = f1y_now_by


@straight
def _give_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what the joints give (45 operations)."""
    m_1_now = inertia[1]
    m_2_now = inertia[2]
    m_3_now = inertia[3]
    m_4_now = inertia[4]
    m_5_now = inertia[5]
    for lane in range(n):
        a_0_2_now = d[800 + lane]
        a_0_3_now = d[832 + lane]
        a_0_4_now = d[864 + lane]
        a_p_0_now = s[480 + lane]
        a_p_1_now = s[512 + lane]
        a_p_2_now = s[544 + lane]
        a_p_3_now = s[576 + lane]
        a_p_4_now = s[608 + lane]
        V_0_0_now = s[0 + lane]
        V_1_0_now = s[32 + lane]
        V_2_0_now = s[64 + lane]
        a_0_0_now_by = d_by[736 + lane]
        a_0_1_now_by = d_by[768 + lane]
        a_0_2_now_by = d_by[800 + lane]
        a_0_3_now_by = d_by[832 + lane]
        a_0_4_now_by = d_by[864 + lane]
        a_p_0_now_by = s_by[480 + lane]
        a_p_1_now_by = s_by[512 + lane]
        a_p_2_now_by = s_by[544 + lane]
        a_p_3_now_by = s_by[576 + lane]
        a_p_4_now_by = s_by[608 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_1_0_now_by = s_by[32 + lane]
        V_2_0_now_by = s_by[64 + lane]
        W_0_now = a_0_2_now*m_3_now + a_p_0_now*m_4_now + a_p_3_now*m_5_now
        W_1_now = a_0_3_now*m_3_now + a_p_1_now*m_4_now + a_p_4_now*m_5_now
        W_2_now = a_0_4_now*m_3_now + a_p_2_now*m_4_now
        s33 = -V_1_0_now*(a_0_3_now_by*m_3_now + a_p_1_now_by*m_4_now + a_p_4_now_by*m_5_now) - V_1_0_now_by*W_1_now
        s36 = -V_2_0_now*(a_0_4_now_by*m_3_now + a_p_2_now_by*m_4_now) - V_2_0_now_by*W_2_now
        s37 = -a_0_0_now_by*m_1_now
        s38 = -a_0_1_now_by*m_2_now
        s39 = -V_0_0_now*(a_0_2_now_by*m_3_now + a_p_0_now_by*m_4_now + a_p_3_now_by*m_5_now) - V_0_0_now_by*W_0_now + s33 + s36 + s37 + s38
        s_by[640 + lane] = s39


@straight
def _step_by(moves, w_by, first, last, n):
    """Move the platform by its twists, which a step takes off, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w_by[2144 + lane] = -moves[3 * m + 0]
        w_by[2176 + lane] = -moves[3 * m + 1]
        w_by[2208 + lane] = -moves[3 * m + 2]


@straight
def _held(w, size):
    """Begin with nothing that changes."""
    for n in range(size):
        w[n] = 0.0


@straight
def _pay_by(w, s_by, tau, first, last):
    """Write how what the joints give changes."""
    for lane in range(last - first + 1):
        regular = (w[2592 + lane] > 0.0)
        tau[1 * (first + lane) + 0] = s_by[640 + lane] if regular else math.nan


@fast
def _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    found, moves = tau.reshape(tau.size), x_by.reshape(x_by.size)
    w_by, d_by, s_by = scratch(WORK), scratch(1 * OWN), scratch(SHARED)
    _held(w_by, WORK)
    _held(d_by, 1 * OWN)
    _held(s_by, SHARED)
    u_1, e_1 = w_by[0:2144], d_by[0 * OWN:1 * OWN]
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
