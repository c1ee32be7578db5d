"""Dynamics of `robotennis`, many samples at once: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both eb47a23b805f1847; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 3)  platform: px py pz
motion (3, N, 3)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 3, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 3, 16)  what `constants` makes of p (M, 3, 19)
gravity (3,)  in {O} [m/s^2]      shares (3,)  of a rod's mass at either end: 1/6 where it is uniform
inertia (14,)  of `LIMB`, limb by limb, then of `PLATFORM`, of which the payload is the last

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
    ("m_rod", "kg", "mass of each rod of the pair"),
)
PLATFORM = (
    ("m_platform", "kg", "mass of the platform, at its centre"),
    ("payload", "kg", "mass at the reference point"),
)
OWN, SHARED = 864, 1536  # numbers of a limb's second region; of what all share
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


def stated(geometry, masses, own):
    """Return what a robot file says of inertial parameters, by name: one value, or one per limb.

    `own` is a limb's own inertia about its centre of mass [kg mm^2].
    """
    a = geometry["arm_length"]
    proximal = masses["proximal"]
    proximal_com = masses["proximal_com"]
    distal_rod = masses["distal_rod"]
    platform = masses["platform"]
    return {
        "m_arm": proximal,
        "mx_arm": a*proximal*proximal_com,
        "i_arm": (a * a)*proximal*(proximal_com * proximal_com) + own,
        "m_rod": distal_rod,
        "m_platform": platform,
    }


@straight
def _fill(p, k, rows):
    for lane in range(rows):
        a = p[19 * lane + 0]
        h = p[19 * lane + 2]
        H = p[19 * lane + 3]
        phi = p[19 * lane + 4]
        da = p[19 * lane + 8]
        dh = p[19 * lane + 10]
        theta0 = p[19 * lane + 11]
        dphi = p[19 * lane + 12]
        dH = p[19 * lane + 13]
        px0 = p[19 * lane + 14]
        py0 = p[19 * lane + 15]
        pz0 = p[19 * lane + 16]
        tip_v = p[19 * lane + 17]
        tip_w = p[19 * lane + 18]
        s0 = dphi + phi
        u_x = cosine(s0)
        u_y = sine(s0)
        s3 = H + dH
        A_x = s3*u_x
        A_y = s3*u_y
        s11 = a + da
        s14 = -tip_v*u_x
        s16 = A_x + tip_w*u_y
        s20 = -tip_v*u_y
        s22 = A_y - tip_w*u_x
        s30 = dh + h
        s31 = s30*u_x
        s33 = s30*u_y
        s109 = (1.0 / (2*a + 2*da))
        s162 = 0.5/(s11 * s11)
        k[16 * lane + 0] = theta0
        k[16 * lane + 1] = u_x
        k[16 * lane + 2] = u_y
        k[16 * lane + 3] = s11
        k[16 * lane + 4] = s14
        k[16 * lane + 5] = s16
        k[16 * lane + 6] = s20
        k[16 * lane + 7] = s22
        k[16 * lane + 8] = tip_v
        k[16 * lane + 9] = px0
        k[16 * lane + 10] = py0
        k[16 * lane + 11] = pz0
        k[16 * lane + 12] = s31
        k[16 * lane + 13] = s33
        k[16 * lane + 14] = s109
        k[16 * lane + 15] = s162


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return c (M, 3, 16), what no pose changes of bodies in motion, from p (25 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 3, 16))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (24 operations)."""
    for lane in range(n):
        M_0_0 = w[3808 + lane]
        M_0_1 = w[3840 + lane]
        M_0_2 = w[3872 + lane]
        M_1_0 = w[3904 + lane]
        M_1_1 = w[3936 + lane]
        M_1_2 = w[3968 + lane]
        M_2_0 = w[4000 + lane]
        M_2_1 = w[4032 + lane]
        M_2_2 = w[4064 + lane]
        q_t_0 = d[0 + lane]
        Q_0 = w[352 + lane]
        q_t_1 = d[864 + lane]
        Q_1 = w[1568 + lane]
        q_t_2 = d[1728 + lane]
        Q_2 = w[2784 + lane]
        V_0_0 = M_0_0*Q_0
        V_0_1 = M_0_1*Q_1
        V_0_2 = M_0_2*Q_2
        V_1_0 = M_1_0*Q_0
        V_1_1 = M_1_1*Q_1
        V_1_2 = M_1_2*Q_2
        V_2_0 = M_2_0*Q_0
        V_2_1 = M_2_1*Q_1
        V_2_2 = M_2_2*Q_2
        s12 = V_0_0*q_t_0 + V_0_1*q_t_1 + V_0_2*q_t_2
        s16 = V_1_0*q_t_0 + V_1_1*q_t_1 + V_1_2*q_t_2
        s20 = V_2_0*q_t_0 + V_2_1*q_t_1 + V_2_2*q_t_2
        s[0 + lane] = V_0_0
        s[32 + lane] = V_0_1
        s[64 + lane] = V_0_2
        s[96 + lane] = V_1_0
        s[128 + lane] = V_1_1
        s[160 + lane] = V_1_2
        s[192 + lane] = V_2_0
        s[224 + lane] = V_2_1
        s[256 + lane] = V_2_2
        s[288 + lane] = s12
        s[320 + lane] = s16
        s[352 + lane] = s20


@straight
def _curved(w, d, s, k, gravity, shares, n):
    """Second derivatives of a limb's equations by time where nothing accelerates (69 operations)."""
    theta0 = k[0]
    u_x = k[1]
    u_y = k[2]
    s11 = k[3]
    s14 = k[4]
    s16 = k[5]
    s20 = k[6]
    s22 = k[7]
    tip_v = k[8]
    px0 = k[9]
    py0 = k[10]
    pz0 = k[11]
    s31 = k[12]
    s33 = k[13]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        v_px = s[288 + lane]
        v_py = s[320 + lane]
        v_pz = s[352 + lane]
        q_t = d[0 + lane]
        s6 = q + theta0
        s7 = cosine(s6)
        arm_x = s7*u_x
        arm_y = s7*u_y
        arm_z = sine(s6)
        B_x = arm_x*s11 + arm_z*s14 + s16
        B_y = arm_y*s11 + arm_z*s20 + s22
        B_z = arm_z*s11 + s7*tip_v
        centre_x = px + px0 - tx
        centre_y = py + py0 - ty
        centre_z = pz + pz0 - tz
        C_x = centre_x + s31
        C_y = centre_y + s33
        rod_x = -B_x + C_x
        rod_y = -B_y + C_y
        rod_z = -B_z + centre_z
        s48 = -arm_z*q_t
        s51 = q_t*s7
        s61 = -s11*s48*u_x - s14*s51 + v_px
        s62 = -s11*s48*u_y - s20*s51 + v_py
        s63 = -s11*s51 - s48*tip_v + v_pz
        s74 = -q_t*s51
        s77 = q_t*s48
        s96 = -rod_y*(s11*s74*u_y + s20*s77) + (s62 * s62)
        s101 = -rod_z*(s11*s77 + s74*tip_v) + (s63 * s63)
        s102 = -rod_x*(s11*s74*u_x + s14*s77) + s101 + (s61 * s61) + s96
        d[64 + lane] = s102


@straight
def _accelerate(w, d, s, n):
    """The platform's acceleration (33 operations)."""
    for lane in range(n):
        M_0_0 = w[3808 + lane]
        M_0_1 = w[3840 + lane]
        M_0_2 = w[3872 + lane]
        M_1_0 = w[3904 + lane]
        M_1_1 = w[3936 + lane]
        M_1_2 = w[3968 + lane]
        M_2_0 = w[4000 + lane]
        M_2_1 = w[4032 + lane]
        M_2_2 = w[4064 + lane]
        q_tt_0 = d[32 + lane]
        c_0 = d[64 + lane]
        q_tt_1 = d[896 + lane]
        c_1 = d[928 + lane]
        q_tt_2 = d[1760 + lane]
        c_2 = d[1792 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        s6 = M_0_0*c_0 + M_0_1*c_1 + M_0_2*c_2 + V_0_0*q_tt_0 + V_0_1*q_tt_1 + V_0_2*q_tt_2
        s13 = M_1_0*c_0 + M_1_1*c_1 + M_1_2*c_2 + V_1_0*q_tt_0 + V_1_1*q_tt_1 + V_1_2*q_tt_2
        s20 = M_2_0*c_0 + M_2_1*c_1 + M_2_2*c_2 + V_2_0*q_tt_0 + V_2_1*q_tt_1 + V_2_2*q_tt_2
        s[384 + lane] = s6
        s[416 + lane] = s13
        s[448 + lane] = s20


@straight
def _limb_fields(w, d, s, k, gravity, shares, n):
    """Gravity less acceleration of the points of a limb (59 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    theta0 = k[0]
    u_x = k[1]
    u_y = k[2]
    s11 = k[3]
    s14 = k[4]
    s20 = k[6]
    tip_v = k[8]
    for lane in range(n):
        q = w[0 + lane]
        v_px_t = s[384 + lane]
        v_py_t = s[416 + lane]
        v_pz_t = s[448 + lane]
        q_t = d[0 + lane]
        q_tt = d[32 + lane]
        s6 = q + theta0
        s7 = cosine(s6)
        arm_z = sine(s6)
        s412 = -arm_z*q_tt - (q_t * q_t)*s7
        s416 = -arm_z*(q_t * q_t) + q_tt*s7
        s417 = s11*s412*u_x
        s419 = s14*s416 + s417
        s420 = s11*s412*u_y
        s422 = s20*s416 + s420
        s423 = s11*s416
        s425 = s412*tip_v + s423
        s635 = -0.001*s417
        s636 = gx + s635
        s637 = -0.001*s420
        s638 = gy + s637
        s639 = -0.001*s423
        s640 = gz + s639
        s641 = gx - s635
        s642 = gy - s637
        s643 = gz - s639
        s645 = gx - 0.001*s419
        s647 = gy - 0.001*s422
        s649 = gz - 0.001*s425
        s651 = gx - 0.0005*s419 - 0.0005*v_px_t
        s653 = gy - 0.0005*s422 - 0.0005*v_py_t
        s655 = gz - 0.0005*s425 - 0.0005*v_pz_t
        s657 = gx - 0.001*v_px_t
        s659 = gy - 0.001*v_py_t
        s661 = gz - 0.001*v_pz_t
        d[192 + lane] = s636
        d[224 + lane] = s638
        d[256 + lane] = s640
        d[288 + lane] = s641
        d[320 + lane] = s642
        d[352 + lane] = s643
        d[384 + lane] = s645
        d[416 + lane] = s647
        d[448 + lane] = s649
        d[480 + lane] = s651
        d[512 + lane] = s653
        d[544 + lane] = s655
        d[576 + lane] = s657
        d[608 + lane] = s659
        d[640 + lane] = s661


@straight
def _limb_asks(w, d, s, k, gravity, shares, n):
    """Loads per inertial parameter of a limb, along joint, shifts and turns (77 operations)."""
    share = shares[0]
    theta0 = k[0]
    u_x = k[1]
    u_y = k[2]
    s11 = k[3]
    s14 = k[4]
    s20 = k[6]
    tip_v = k[8]
    s109 = k[14]
    s162 = k[15]
    for lane in range(n):
        q = w[0 + lane]
        f1x = d[192 + lane]
        f1y = d[224 + lane]
        f1z = d[256 + lane]
        f2x = d[288 + lane]
        f2y = d[320 + lane]
        f2z = d[352 + lane]
        f3x = d[384 + lane]
        f3y = d[416 + lane]
        f3z = d[448 + lane]
        f4x = d[480 + lane]
        f4y = d[512 + lane]
        f4z = d[544 + lane]
        f5x = d[576 + lane]
        f5y = d[608 + lane]
        f5z = d[640 + lane]
        s6 = q + theta0
        s7 = cosine(s6)
        arm_z = sine(s6)
        s125 = -f2z*s11
        s134 = f1z*s11
        s154 = s11*u_x*(f1x*s109 + f2x*s109) + s11*u_y*(f1y*s109 + f2y*s109)
        s156 = -arm_z*s154 + s7*(-s109*s125 + s109*s134)
        s191 = s11*u_x*(f1x*s162 - f2x*s162) + s11*u_y*(f1y*s162 - f2y*s162)
        s193 = -arm_z*s191 + s7*(s125*s162 + s134*s162)
        s199 = 2 - 4*share
        s225 = 2*share
        s242 = 0.5*f4z*s199
        s245 = 0.5*f4y*s199
        s248 = 0.5*f4x*s199
        s250 = f5y*s225 + s245
        s251 = f5x*s225 + s248
        s252 = f5z*s225 + s242
        s253 = f3z*s225 + s242
        s258 = f3y*s225 + s245
        s263 = f3x*s225 + s248
        s275 = -arm_z*(s11*s258*u_y + s11*s263*u_x + s253*tip_v)
        s276 = s275 + s7*(s11*s253 + s14*s263 + s20*s258)
        d[672 + lane] = s156
        d[704 + lane] = s193
        d[736 + lane] = s276
        d[768 + lane] = s251
        d[800 + lane] = s250
        d[832 + lane] = s252


@straight
def _platform_fields(w, d, s, gravity, n):
    """Gravity less acceleration of the points of a platform (6 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    for lane in range(n):
        v_px_t = s[384 + lane]
        v_py_t = s[416 + lane]
        v_pz_t = s[448 + lane]
        s102 = gx - 0.001*v_px_t
        s104 = gy - 0.001*v_py_t
        s106 = gz - 0.001*v_pz_t
        s[480 + lane] = s102
        s[512 + lane] = s104
        s[544 + lane] = s106
        s[576 + lane] = s102
        s[608 + lane] = s104
        s[640 + lane] = s106


@straight
def _platform_asks(w, d, s, n):
    """Loads per inertial parameter of a platform, along joint, shifts and turns (0 operations)."""
    for lane in range(n):
        f0x = s[480 + lane]
        f0y = s[512 + lane]
        f0z = s[544 + lane]
        f1x = s[576 + lane]
        f1y = s[608 + lane]
        f1z = s[640 + lane]
        s[672 + lane] = f0x
        s[704 + lane] = f0y
        s[736 + lane] = f0z
        s[768 + lane] = f1x
        s[800 + lane] = f1y
        s[832 + lane] = f1z


@straight
def _give(d, s, inertia, n):
    """What the joints give (63 operations)."""
    m_1 = inertia[1]
    m_2 = inertia[2]
    m_3 = inertia[3]
    m_5 = inertia[5]
    m_6 = inertia[6]
    m_7 = inertia[7]
    m_9 = inertia[9]
    m_10 = inertia[10]
    m_11 = inertia[11]
    m_12 = inertia[12]
    m_13 = inertia[13]
    for lane in range(n):
        a_0_0 = d[672 + lane]
        a_0_1 = d[704 + lane]
        a_0_2 = d[736 + lane]
        a_0_3 = d[768 + lane]
        a_0_4 = d[800 + lane]
        a_0_5 = d[832 + lane]
        a_1_0 = d[1536 + lane]
        a_1_1 = d[1568 + lane]
        a_1_2 = d[1600 + lane]
        a_1_3 = d[1632 + lane]
        a_1_4 = d[1664 + lane]
        a_1_5 = d[1696 + lane]
        a_2_0 = d[2400 + lane]
        a_2_1 = d[2432 + lane]
        a_2_2 = d[2464 + lane]
        a_2_3 = d[2496 + lane]
        a_2_4 = d[2528 + lane]
        a_2_5 = d[2560 + lane]
        a_p_0 = s[672 + lane]
        a_p_1 = s[704 + lane]
        a_p_2 = s[736 + lane]
        a_p_3 = s[768 + lane]
        a_p_4 = s[800 + lane]
        a_p_5 = s[832 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        W_0 = a_0_3*m_3 + a_1_3*m_7 + a_2_3*m_11 + a_p_0*m_12 + a_p_3*m_13
        W_1 = a_0_4*m_3 + a_1_4*m_7 + a_2_4*m_11 + a_p_1*m_12 + a_p_4*m_13
        W_2 = a_0_5*m_3 + a_1_5*m_7 + a_2_5*m_11 + a_p_2*m_12 + a_p_5*m_13
        s24 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - a_0_0*m_1 - a_0_1*m_2 - a_0_2*m_3
        s31 = -V_0_1*W_0 - V_1_1*W_1 - V_2_1*W_2 - a_1_0*m_5 - a_1_1*m_6 - a_1_2*m_7
        s38 = -V_0_2*W_0 - V_1_2*W_1 - V_2_2*W_2 - a_2_0*m_9 - a_2_1*m_10 - a_2_2*m_11
        s[864 + lane] = s24
        s[896 + lane] = s31
        s[928 + lane] = s38


@straight
def _give_each(d, s, n):
    """What the joints give for each inertial parameter (81 operations)."""
    for lane in range(n):
        a_0_0 = d[672 + lane]
        a_0_1 = d[704 + lane]
        a_0_2 = d[736 + lane]
        a_0_3 = d[768 + lane]
        a_0_4 = d[800 + lane]
        a_0_5 = d[832 + lane]
        a_1_0 = d[1536 + lane]
        a_1_1 = d[1568 + lane]
        a_1_2 = d[1600 + lane]
        a_1_3 = d[1632 + lane]
        a_1_4 = d[1664 + lane]
        a_1_5 = d[1696 + lane]
        a_2_0 = d[2400 + lane]
        a_2_1 = d[2432 + lane]
        a_2_2 = d[2464 + lane]
        a_2_3 = d[2496 + lane]
        a_2_4 = d[2528 + lane]
        a_2_5 = d[2560 + lane]
        a_p_0 = s[672 + lane]
        a_p_1 = s[704 + lane]
        a_p_2 = s[736 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        s3 = -V_0_0*a_0_3 - V_1_0*a_0_4 - V_2_0*a_0_5 - a_0_2
        s7 = -V_0_1*a_0_3 - V_1_1*a_0_4 - V_2_1*a_0_5
        s11 = -V_0_2*a_0_3 - V_1_2*a_0_4 - V_2_2*a_0_5
        s15 = -V_0_0*a_1_3 - V_1_0*a_1_4 - V_2_0*a_1_5
        s19 = -V_0_1*a_1_3 - V_1_1*a_1_4 - V_2_1*a_1_5 - a_1_2
        s23 = -V_0_2*a_1_3 - V_1_2*a_1_4 - V_2_2*a_1_5
        s27 = -V_0_0*a_2_3 - V_1_0*a_2_4 - V_2_0*a_2_5
        s31 = -V_0_1*a_2_3 - V_1_1*a_2_4 - V_2_1*a_2_5
        s35 = -V_0_2*a_2_3 - V_1_2*a_2_4 - V_2_2*a_2_5 - a_2_2
        s39 = -V_0_0*a_p_0 - V_1_0*a_p_1 - V_2_0*a_p_2
        s43 = -V_0_1*a_p_0 - V_1_1*a_p_1 - V_2_1*a_p_2
        s47 = -V_0_2*a_p_0 - V_1_2*a_p_1 - V_2_2*a_p_2
        s[960 + lane] = -a_0_0
        s[992 + lane] = -a_0_1
        s[1024 + lane] = s3
        s[1056 + lane] = s7
        s[1088 + lane] = s11
        s[1120 + lane] = -a_1_0
        s[1152 + lane] = -a_1_1
        s[1184 + lane] = s15
        s[1216 + lane] = s19
        s[1248 + lane] = s23
        s[1280 + lane] = -a_2_0
        s[1312 + lane] = -a_2_1
        s[1344 + lane] = s27
        s[1376 + lane] = s31
        s[1408 + lane] = s35
        s[1440 + lane] = s39
        s[1472 + lane] = s43
        s[1504 + lane] = s47


@straight
def _rates(speeds, accelerations, d, first, last, n):
    """Put velocities and accelerations of the joints side by side, the last ones again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        d[0 + lane] = speeds[3 * m + 0]
        d[32 + lane] = accelerations[3 * m + 0]
        d[864 + lane] = speeds[3 * m + 1]
        d[896 + lane] = accelerations[3 * m + 1]
        d[1728 + lane] = speeds[3 * m + 2]
        d[1760 + lane] = accelerations[3 * m + 2]


@straight
def _pay(w, s, tau, first, last):
    """Write what the joints give."""
    for lane in range(last - first + 1):
        regular = (w[4096 + lane] > 0.0)
        tau[3 * (first + lane) + 0] = s[864 + lane] if regular else math.nan
        tau[3 * (first + lane) + 1] = s[896 + lane] if regular else math.nan
        tau[3 * (first + lane) + 2] = s[928 + lane] if regular else math.nan


@straight
def _pay_each(w, s, Y, first, last):
    """Write what the joints give for each inertial parameter."""
    for lane in range(last - first + 1):
        regular = (w[4096 + lane] > 0.0)
        Y[39 * (first + lane) + 0] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 1] = s[960 + lane] if regular else math.nan
        Y[39 * (first + lane) + 2] = s[992 + lane] if regular else math.nan
        Y[39 * (first + lane) + 3] = s[1024 + lane] if regular else math.nan
        Y[39 * (first + lane) + 4] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 5] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 6] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 7] = s[1184 + lane] if regular else math.nan
        Y[39 * (first + lane) + 8] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 9] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 10] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 11] = s[1344 + lane] if regular else math.nan
        Y[39 * (first + lane) + 12] = s[1440 + lane] if regular else math.nan
        Y[39 * (first + lane) + 13] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 14] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 15] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 16] = s[1056 + lane] if regular else math.nan
        Y[39 * (first + lane) + 17] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 18] = s[1120 + lane] if regular else math.nan
        Y[39 * (first + lane) + 19] = s[1152 + lane] if regular else math.nan
        Y[39 * (first + lane) + 20] = s[1216 + lane] if regular else math.nan
        Y[39 * (first + lane) + 21] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 22] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 23] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 24] = s[1376 + lane] if regular else math.nan
        Y[39 * (first + lane) + 25] = s[1472 + lane] if regular else math.nan
        Y[39 * (first + lane) + 26] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 27] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 28] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 29] = s[1088 + lane] if regular else math.nan
        Y[39 * (first + lane) + 30] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 31] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 32] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 33] = s[1248 + lane] if regular else math.nan
        Y[39 * (first + lane) + 34] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 35] = s[1280 + lane] if regular else math.nan
        Y[39 * (first + lane) + 36] = s[1312 + lane] if regular else math.nan
        Y[39 * (first + lane) + 37] = s[1408 + lane] if regular else math.nan
        Y[39 * (first + lane) + 38] = s[1504 + lane] if regular else math.nan


@fast
def _torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    found = tau.reshape(tau.size)
    w, d, s = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    w_1 = w[0:1216]
    w_2 = w[1216:2432]
    w_3 = w[2432:3648]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    d_3 = d[2 * OWN:3 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 3 :], states[2 * samples * 3 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
        k_3, own_3 = k[m, 2], c[m, 2]
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
            _early(w_3, k_3, n)
            _more(w_3, k_3, n)
            _rows(w_3, k_3, n)
            _joints(w_3, k_3, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _curved(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_fields(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give(d, s, inertia, n)
            _pay(w, s, found, first, last)


def torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    """Fill tau (N, 3) [N mm, N]: what the joints must give, positive along positive joints."""
    _torque(x, motion, tool, k, c, gravity, shares, inertia, tau)


@fast
def _regressor(x, motion, tool, k, c, gravity, shares, Y):
    found = Y.reshape(Y.size)
    w, d, s = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    w_1 = w[0:1216]
    w_2 = w[1216:2432]
    w_3 = w[2432:3648]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    d_3 = d[2 * OWN:3 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 3 :], states[2 * samples * 3 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
        k_3, own_3 = k[m, 2], c[m, 2]
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
            _early(w_3, k_3, n)
            _more(w_3, k_3, n)
            _rows(w_3, k_3, n)
            _joints(w_3, k_3, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _curved(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_fields(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give_each(d, s, n)
            _pay_each(w, s, found, first, last)


def regressor(x, motion, tool, k, c, gravity, shares, Y):
    """Fill Y (N, 3, 13): what the joints must give for each inertial parameter, which is 1."""
    _regressor(x, motion, tool, k, c, gravity, shares, Y)


@straight
def _fill_by(p, p_by, k, rows):
    for lane in range(rows):
        a_now = p[19 * lane + 0]
        h_now = p[19 * lane + 2]
        H_now = p[19 * lane + 3]
        phi_now = p[19 * lane + 4]
        da_now = p[19 * lane + 8]
        dh_now = p[19 * lane + 10]
        dphi_now = p[19 * lane + 12]
        dH_now = p[19 * lane + 13]
        tip_v_now = p[19 * lane + 17]
        tip_w_now = p[19 * lane + 18]
        a_now_by = p_by[19 * lane + 0]
        h_now_by = p_by[19 * lane + 2]
        H_now_by = p_by[19 * lane + 3]
        phi_now_by = p_by[19 * lane + 4]
        da_now_by = p_by[19 * lane + 8]
        dh_now_by = p_by[19 * lane + 10]
        theta0_now_by = p_by[19 * lane + 11]
        dphi_now_by = p_by[19 * lane + 12]
        dH_now_by = p_by[19 * lane + 13]
        px0_now_by = p_by[19 * lane + 14]
        py0_now_by = p_by[19 * lane + 15]
        pz0_now_by = p_by[19 * lane + 16]
        tip_v_now_by = p_by[19 * lane + 17]
        tip_w_now_by = p_by[19 * lane + 18]
        s0_now = dphi_now + phi_now
        u_x_now = cosine(s0_now)
        u_y_now = sine(s0_now)
        s3_now = H_now + dH_now
        s11_now = a_now + da_now
        s30_now = dh_now + h_now
        s22 = dphi_now_by + phi_now_by
        s23 = -s22*u_y_now
        s24 = s22*u_x_now
        s25 = H_now_by + dH_now_by
        s32 = a_now_by + da_now_by
        s35 = -s23*tip_v_now - tip_v_now_by*u_x_now
        s39 = s23*s3_now + s24*tip_w_now + s25*u_x_now + tip_w_now_by*u_y_now
        s42 = -s24*tip_v_now - tip_v_now_by*u_y_now
        s46 = -s23*tip_w_now + s24*s3_now + s25*u_y_now - tip_w_now_by*u_x_now
        s47 = dh_now_by + h_now_by
        s50 = s23*s30_now + s47*u_x_now
        s53 = s24*s30_now + s47*u_y_now
        s58 = -(2*a_now_by + 2*da_now_by)/((2*a_now + 2*da_now) * (2*a_now + 2*da_now))
        s62 = -s32/(s11_now * s11_now * s11_now)
        k[16 * lane + 0] = theta0_now_by
        k[16 * lane + 1] = s23
        k[16 * lane + 2] = s24
        k[16 * lane + 3] = s32
        k[16 * lane + 4] = s35
        k[16 * lane + 5] = s39
        k[16 * lane + 6] = s42
        k[16 * lane + 7] = s46
        k[16 * lane + 8] = tip_v_now_by
        k[16 * lane + 9] = px0_now_by
        k[16 * lane + 10] = py0_now_by
        k[16 * lane + 11] = pz0_now_by
        k[16 * lane + 12] = s50
        k[16 * lane + 13] = s53
        k[16 * lane + 14] = s58
        k[16 * lane + 15] = s62


@straight
def _fill_machine_by(p, p_by, k, rows):
    for lane in range(rows):
        a_now = p[19 * lane + 0]
        b_now = p[19 * lane + 1]
        h_now = p[19 * lane + 2]
        H_now = p[19 * lane + 3]
        phi_now = p[19 * lane + 4]
        da_now = p[19 * lane + 8]
        db_now = p[19 * lane + 9]
        dh_now = p[19 * lane + 10]
        dphi_now = p[19 * lane + 12]
        dH_now = p[19 * lane + 13]
        tip_v_now = p[19 * lane + 17]
        tip_w_now = p[19 * lane + 18]
        a_now_by = p_by[19 * lane + 0]
        b_now_by = p_by[19 * lane + 1]
        h_now_by = p_by[19 * lane + 2]
        H_now_by = p_by[19 * lane + 3]
        phi_now_by = p_by[19 * lane + 4]
        da_now_by = p_by[19 * lane + 8]
        db_now_by = p_by[19 * lane + 9]
        dh_now_by = p_by[19 * lane + 10]
        theta0_now_by = p_by[19 * lane + 11]
        dphi_now_by = p_by[19 * lane + 12]
        dH_now_by = p_by[19 * lane + 13]
        px0_now_by = p_by[19 * lane + 14]
        py0_now_by = p_by[19 * lane + 15]
        pz0_now_by = p_by[19 * lane + 16]
        tip_v_now_by = p_by[19 * lane + 17]
        tip_w_now_by = p_by[19 * lane + 18]
        s0_now = dphi_now + phi_now
        u_x_now = cosine(s0_now)
        u_y_now = sine(s0_now)
        s3_now = H_now + dH_now
        s11_now = a_now + da_now
        s30_now = dh_now + h_now
        s44_now = b_now + db_now
        s122_now = -2*a_now - 2*da_now
        s35 = dphi_now_by + phi_now_by
        s36 = -s35*u_y_now
        s37 = s35*u_x_now
        s38 = H_now_by + dH_now_by
        s41 = s36*s3_now + s38*u_x_now
        s44 = s37*s3_now + s38*u_y_now
        s45 = a_now_by + da_now_by
        s48 = -s36*tip_v_now - tip_v_now_by*u_x_now
        s52 = s37*tip_w_now + s41 + tip_w_now_by*u_y_now
        s55 = -s37*tip_v_now - tip_v_now_by*u_y_now
        s59 = -s36*tip_w_now + s44 - tip_w_now_by*u_x_now
        s60 = dh_now_by + h_now_by
        s63 = s30_now*s36 + s60*u_x_now
        s66 = s30_now*s37 + s60*u_y_now
        s67 = b_now_by + db_now_by
        s69 = 2*s44_now*s67
        s70 = -0.5*s69
        s71 = px0_now_by - s41 + s63
        s74 = -s11_now*s36 - s45*u_x_now
        s75 = py0_now_by - s44 + s66
        s78 = -s11_now*s37 - s45*u_y_now
        s89 = 0.5*(s11_now * s11_now)*(2*s36*u_x_now + 2*s37*u_y_now)
        s91 = 2*s11_now*s45*(0.5*(u_x_now * u_x_now) + 0.5*(u_y_now * u_y_now)) + s70 + s89
        s94 = -2*a_now_by - 2*da_now_by
        s97 = 0.5*s122_now*s94
        s98 = -0.5*s94
        k[24 * lane + 0] = theta0_now_by
        k[24 * lane + 1] = s36
        k[24 * lane + 2] = s37
        k[24 * lane + 3] = s45
        k[24 * lane + 4] = s48
        k[24 * lane + 5] = s52
        k[24 * lane + 6] = s55
        k[24 * lane + 7] = s59
        k[24 * lane + 8] = tip_v_now_by
        k[24 * lane + 9] = px0_now_by
        k[24 * lane + 10] = py0_now_by
        k[24 * lane + 11] = pz0_now_by
        k[24 * lane + 12] = s63
        k[24 * lane + 13] = s66
        k[24 * lane + 14] = s70
        k[24 * lane + 15] = s71
        k[24 * lane + 16] = s74
        k[24 * lane + 17] = s75
        k[24 * lane + 18] = s78
        k[24 * lane + 19] = s91
        k[24 * lane + 20] = s97
        k[24 * lane + 21] = s98
        k[24 * lane + 22] = -s67
        k[24 * lane + 23] = s69


@fast
def _constants_by(p, p_by, k, c):
    _fill_machine_by(p, p_by, k, p.shape[0] * p.shape[1])
    _fill_by(p, p_by, c, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how k and c change, which `constants` of ``kinematics.py`` and of this module make of one machine's p
    (1, 3, 19), along each of p_by (E, 3, 19)."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((len(p_by), 3, 24))
    c_by = np.empty((len(p_by), 3, 16))
    _constants_by(np.repeat(p, len(p_by), axis=0), p_by, k_by, c_by)
    return k_by, c_by


@straight
def _move_platform_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform after a step, and its rotation matrix (6 operations)."""
    for lane in range(n):
        going_now = w[3776 + lane]
        y0_now_by = w_by[3648 + lane]
        y1_now_by = w_by[3680 + lane]
        y2_now_by = w_by[3712 + lane]
        s6 = -going_now*y0_now_by
        s7 = -going_now*y1_now_by
        s8 = -going_now*y2_now_by
        w_by[128 + lane] = s6
        w_by[1344 + lane] = s6
        w_by[2560 + lane] = s6
        w_by[160 + lane] = s7
        w_by[1376 + lane] = s7
        w_by[2592 + lane] = s7
        w_by[192 + lane] = s8
        w_by[1408 + lane] = s8
        w_by[2624 + lane] = s8


@straight
def _early_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (66 operations)."""
    theta0_now = k[0]
    u_x_now = k[1]
    u_y_now = k[2]
    s11_now = k[3]
    s14_now = k[4]
    s20_now = k[6]
    tip_v_now = k[8]
    pz0_now = k[11]
    s96_now = k[15]
    s98_now = k[16]
    s100_now = k[17]
    s102_now = k[18]
    theta0_now_by = k_by[0]
    u_x_now_by = k_by[1]
    u_y_now_by = k_by[2]
    s11_now_by = k_by[3]
    s14_now_by = k_by[4]
    s16_now_by = k_by[5]
    s20_now_by = k_by[6]
    s22_now_by = k_by[7]
    tip_v_now_by = k_by[8]
    pz0_now_by = k_by[11]
    s96_now_by = k_by[15]
    s98_now_by = k_by[16]
    s100_now_by = k_by[17]
    s102_now_by = k_by[18]
    s45_now_by = k_by[23]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        s6_now = q_now + theta0_now
        s7_now = cosine(s6_now)
        arm_x_now = s7_now*u_x_now
        arm_y_now = s7_now*u_y_now
        arm_z_now = sine(s6_now)
        s24_now = arm_z_now*s11_now
        s138_now = -s7_now*s98_now - s96_now + tx_now
        s140_now = -s100_now - s102_now*s7_now + ty_now
        s141_now = -pz0_now + s24_now + tz_now
        s23 = -arm_z_now*theta0_now_by
        s30 = s7_now*theta0_now_by
        s37 = arm_x_now*s11_now_by + arm_z_now*s14_now_by + s11_now*(s23*u_x_now + s7_now*u_x_now_by) + s14_now*s30 + s16_now_by
        s44 = arm_y_now*s11_now_by + arm_z_now*s20_now_by + s11_now*(s23*u_y_now + s7_now*u_y_now_by) + s20_now*s30 + s22_now_by
        s47 = arm_z_now*s11_now_by + s11_now*s30
        s51 = s23*tip_v_now + s47 + s7_now*tip_v_now_by
        s55 = -s23*s98_now - s7_now*s98_now_by - s96_now_by
        s59 = -s100_now_by - s102_now*s23 - s102_now_by*s7_now
        s60 = -pz0_now_by + s47
        s67 = 2*s138_now*s55 + 2*s140_now*s59 + 2*s141_now*s60 - s45_now_by
        w_by[384 + lane] = s37
        w_by[416 + lane] = s44
        w_by[448 + lane] = s51
        w_by[480 + lane] = s55
        w_by[512 + lane] = s59
        w_by[544 + lane] = s60
        w_by[576 + lane] = s67


@straight
def _more_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what else derivatives by joint and errors read of it (35 operations)."""
    theta0_now = k[0]
    u_x_now = k[1]
    u_y_now = k[2]
    s11_now = k[3]
    s14_now = k[4]
    s20_now = k[6]
    tip_v_now = k[8]
    s98_now = k[16]
    s102_now = k[18]
    theta0_now_by = k_by[0]
    u_x_now_by = k_by[1]
    u_y_now_by = k_by[2]
    s11_now_by = k_by[3]
    s14_now_by = k_by[4]
    s20_now_by = k_by[6]
    tip_v_now_by = k_by[8]
    s98_now_by = k_by[16]
    s102_now_by = k_by[18]
    for lane in range(n):
        q_now = w[0 + lane]
        s6_now = q_now + theta0_now
        s7_now = cosine(s6_now)
        arm_z_now = sine(s6_now)
        s14 = -arm_z_now*theta0_now_by
        s17 = s14*u_x_now + s7_now*u_x_now_by
        s20 = s14*u_y_now + s7_now*u_y_now_by
        s21 = s7_now*theta0_now_by
        s28 = -arm_z_now*s98_now_by - s14*s14_now - s14_now_by*s7_now - s21*s98_now
        s35 = -arm_z_now*s102_now_by - s102_now*s21 - s14*s20_now - s20_now_by*s7_now
        s42 = arm_z_now*tip_v_now_by - s11_now*s14 - s11_now_by*s7_now + s21*tip_v_now
        w_by[640 + lane] = s14
        w_by[672 + lane] = s21
        w_by[704 + lane] = s20
        w_by[736 + lane] = s17
        w_by[768 + lane] = s28
        w_by[800 + lane] = s35
        w_by[832 + lane] = s42


@straight
def _rows_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of equations of a limb, their derivatives by shift and turn of the platform (25 operations)."""
    px0_now = k[9]
    py0_now = k[10]
    pz0_now = k[11]
    s31_now = k[12]
    s33_now = k[13]
    px0_now_by = k_by[9]
    py0_now_by = k_by[10]
    pz0_now_by = k_by[11]
    s31_now_by = k_by[12]
    s33_now_by = k_by[13]
    s46_now_by = k_by[14]
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        B_x_now = w[384 + lane]
        B_y_now = w[416 + lane]
        B_z_now = w[448 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        B_x_now_by = w_by[384 + lane]
        B_y_now_by = w_by[416 + lane]
        B_z_now_by = w_by[448 + lane]
        centre_x_now = px0_now + px_now - tx_now
        centre_y_now = py0_now + py_now - ty_now
        centre_z_now = pz0_now + pz_now - tz_now
        C_x_now = centre_x_now + s31_now
        C_y_now = centre_y_now + s33_now
        rod_x_now = -B_x_now + C_x_now
        rod_y_now = -B_y_now + C_y_now
        rod_z_now = -B_z_now + centre_z_now
        s20 = -B_x_now_by + px0_now_by + px_now_by + s31_now_by
        s21 = -B_y_now_by + py0_now_by + py_now_by + s33_now_by
        s22 = -B_z_now_by + pz0_now_by + pz_now_by
        s32 = rod_x_now*s20 + rod_y_now*s21 + rod_z_now*s22 + s46_now_by
        w_by[224 + lane] = s32
        w_by[256 + lane] = s20
        w_by[288 + lane] = s21
        w_by[320 + lane] = s22


@straight
def _joints_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of derivatives of a limb's equations by its joint (30 operations)."""
    px0_now = k[9]
    py0_now = k[10]
    pz0_now = k[11]
    s31_now = k[12]
    s33_now = k[13]
    px0_now_by = k_by[9]
    py0_now_by = k_by[10]
    pz0_now_by = k_by[11]
    s31_now_by = k_by[12]
    s33_now_by = k_by[13]
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        B_x_now = w[384 + lane]
        B_y_now = w[416 + lane]
        B_z_now = w[448 + lane]
        s148_now = w[768 + lane]
        s152_now = w[800 + lane]
        s156_now = w[832 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        B_x_now_by = w_by[384 + lane]
        B_y_now_by = w_by[416 + lane]
        B_z_now_by = w_by[448 + lane]
        s148_now_by = w_by[768 + lane]
        s152_now_by = w_by[800 + lane]
        s156_now_by = w_by[832 + lane]
        centre_x_now = px0_now + px_now - tx_now
        centre_y_now = py0_now + py_now - ty_now
        centre_z_now = pz0_now + pz_now - tz_now
        C_x_now = centre_x_now + s31_now
        C_y_now = centre_y_now + s33_now
        rod_x_now = -B_x_now + C_x_now
        rod_y_now = -B_y_now + C_y_now
        rod_z_now = -B_z_now + centre_z_now
        s25 = rod_y_now*s152_now_by + s152_now*(-B_y_now_by + py0_now_by + py_now_by + s33_now_by)
        s28 = rod_z_now*s156_now_by + s156_now*(-B_z_now_by + pz0_now_by + pz_now_by)
        s29 = rod_x_now*s148_now_by + s148_now*(-B_x_now_by + px0_now_by + px_now_by + s31_now_by) + s25 + s28
        w_by[352 + lane] = s29


@straight
def _inverse_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of minus the inverse of the derivatives, row by row; how far the equations are from dependent (202 operations)."""
    for lane in range(n):
        J00_0_now = w[256 + lane]
        J00_1_now = w[288 + lane]
        J00_2_now = w[320 + lane]
        J10_0_now = w[1472 + lane]
        J10_1_now = w[1504 + lane]
        J10_2_now = w[1536 + lane]
        J20_0_now = w[2688 + lane]
        J20_1_now = w[2720 + lane]
        J20_2_now = w[2752 + lane]
        J00_0_now_by = w_by[256 + lane]
        J00_1_now_by = w_by[288 + lane]
        J00_2_now_by = w_by[320 + lane]
        J10_0_now_by = w_by[1472 + lane]
        J10_1_now_by = w_by[1504 + lane]
        J10_2_now_by = w_by[1536 + lane]
        J20_0_now_by = w_by[2688 + lane]
        J20_1_now_by = w_by[2720 + lane]
        J20_2_now_by = w_by[2752 + lane]
        G_cof_00_now = J10_1_now*J20_2_now - J10_2_now*J20_1_now
        G_cof_01_now = -J10_0_now*J20_2_now + J10_2_now*J20_0_now
        G_cof_02_now = J10_0_now*J20_1_now - J10_1_now*J20_0_now
        G_cof_10_now = -J00_1_now*J20_2_now + J00_2_now*J20_1_now
        G_cof_11_now = J00_0_now*J20_2_now - J00_2_now*J20_0_now
        G_cof_12_now = -J00_0_now*J20_1_now + J00_1_now*J20_0_now
        G_cof_20_now = J00_1_now*J10_2_now - J00_2_now*J10_1_now
        G_cof_21_now = -J00_0_now*J10_2_now + J00_2_now*J10_0_now
        G_cof_22_now = J00_0_now*J10_1_now - J00_1_now*J10_0_now
        G_det_00_now = G_cof_00_now*J00_0_now + G_cof_01_now*J00_1_now + G_cof_02_now*J00_2_now
        G_by_00_now = (1.0 / G_det_00_now)
        s61_now = (J10_0_now * J10_0_now) + (J10_1_now * J10_1_now) + (J10_2_now * J10_2_now)
        s65_now = (J20_0_now * J20_0_now) + (J20_1_now * J20_1_now) + (J20_2_now * J20_2_now)
        s53 = (J00_0_now * J00_0_now) + (J00_1_now * J00_1_now) + (J00_2_now * J00_2_now)
        s62 = J10_1_now*J20_2_now_by + J10_1_now_by*J20_2_now - J10_2_now*J20_1_now_by - J10_2_now_by*J20_1_now
        s69 = -J10_0_now*J20_2_now_by - J10_0_now_by*J20_2_now + J10_2_now*J20_0_now_by + J10_2_now_by*J20_0_now
        s76 = J10_0_now*J20_1_now_by + J10_0_now_by*J20_1_now - J10_1_now*J20_0_now_by - J10_1_now_by*J20_0_now
        s128 = G_cof_00_now*J00_0_now_by + G_cof_01_now*J00_1_now_by + G_cof_02_now*J00_2_now_by + J00_0_now*s62 + J00_1_now*s69 + J00_2_now*s76
        s130 = -s128/(G_det_00_now * G_det_00_now)
        s133 = G_by_00_now*s62 + G_cof_00_now*s130
        s136 = G_by_00_now*(-J00_1_now*J20_2_now_by - J00_1_now_by*J20_2_now + J00_2_now*J20_1_now_by + J00_2_now_by*J20_1_now) + G_cof_10_now*s130
        s139 = G_by_00_now*(J00_1_now*J10_2_now_by + J00_1_now_by*J10_2_now - J00_2_now*J10_1_now_by - J00_2_now_by*J10_1_now) + G_cof_20_now*s130
        s142 = G_by_00_now*s69 + G_cof_01_now*s130
        s145 = G_by_00_now*(J00_0_now*J20_2_now_by + J00_0_now_by*J20_2_now - J00_2_now*J20_0_now_by - J00_2_now_by*J20_0_now) + G_cof_11_now*s130
        s148 = G_by_00_now*(-J00_0_now*J10_2_now_by - J00_0_now_by*J10_2_now + J00_2_now*J10_0_now_by + J00_2_now_by*J10_0_now) + G_cof_21_now*s130
        s151 = G_by_00_now*s76 + G_cof_02_now*s130
        s154 = G_by_00_now*(-J00_0_now*J20_1_now_by - J00_0_now_by*J20_1_now + J00_1_now*J20_0_now_by + J00_1_now_by*J20_0_now) + G_cof_12_now*s130
        s157 = G_by_00_now*(J00_0_now*J10_1_now_by + J00_0_now_by*J10_1_now - J00_1_now*J10_0_now_by - J00_1_now_by*J10_0_now) + G_cof_22_now*s130
        s184 = -1.0e-12*s61_now*s65_now*(2*J00_0_now*J00_0_now_by + 2*J00_1_now*J00_1_now_by + 2*J00_2_now*J00_2_now_by)
        s185 = -1.0e-12*s53*s65_now*(2*J10_0_now*J10_0_now_by + 2*J10_1_now*J10_1_now_by + 2*J10_2_now*J10_2_now_by)
        s186 = -1.0e-12*s53*s61_now*(2*J20_0_now*J20_0_now_by + 2*J20_1_now*J20_1_now_by + 2*J20_2_now*J20_2_now_by)
        s188 = 2*G_det_00_now*s128 + s184 + s185 + s186
        w_by[3808 + lane] = -s133
        w_by[3840 + lane] = -s136
        w_by[3872 + lane] = -s139
        w_by[3904 + lane] = -s142
        w_by[3936 + lane] = -s145
        w_by[3968 + lane] = -s148
        w_by[4000 + lane] = -s151
        w_by[4032 + lane] = -s154
        w_by[4064 + lane] = -s157
        w_by[4096 + lane] = s188


@straight
def _move_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of how the platform moves with each joint, and how it does (69 operations)."""
    for lane in range(n):
        M_0_0_now = w[3808 + lane]
        M_0_1_now = w[3840 + lane]
        M_0_2_now = w[3872 + lane]
        M_1_0_now = w[3904 + lane]
        M_1_1_now = w[3936 + lane]
        M_1_2_now = w[3968 + lane]
        M_2_0_now = w[4000 + lane]
        M_2_1_now = w[4032 + lane]
        M_2_2_now = w[4064 + lane]
        q_t_0_now = d[0 + lane]
        Q_0_now = w[352 + lane]
        q_t_1_now = d[864 + lane]
        Q_1_now = w[1568 + lane]
        q_t_2_now = d[1728 + lane]
        Q_2_now = w[2784 + lane]
        M_0_0_now_by = w_by[3808 + lane]
        M_0_1_now_by = w_by[3840 + lane]
        M_0_2_now_by = w_by[3872 + lane]
        M_1_0_now_by = w_by[3904 + lane]
        M_1_1_now_by = w_by[3936 + lane]
        M_1_2_now_by = w_by[3968 + lane]
        M_2_0_now_by = w_by[4000 + lane]
        M_2_1_now_by = w_by[4032 + lane]
        M_2_2_now_by = w_by[4064 + lane]
        q_t_0_now_by = d_by[0 + lane]
        Q_0_now_by = w_by[352 + lane]
        q_t_1_now_by = d_by[864 + lane]
        Q_1_now_by = w_by[1568 + lane]
        q_t_2_now_by = d_by[1728 + lane]
        Q_2_now_by = w_by[2784 + lane]
        V_0_0_now = M_0_0_now*Q_0_now
        V_0_1_now = M_0_1_now*Q_1_now
        V_0_2_now = M_0_2_now*Q_2_now
        V_1_0_now = M_1_0_now*Q_0_now
        V_1_1_now = M_1_1_now*Q_1_now
        V_1_2_now = M_1_2_now*Q_2_now
        V_2_0_now = M_2_0_now*Q_0_now
        V_2_1_now = M_2_1_now*Q_1_now
        V_2_2_now = M_2_2_now*Q_2_now
        s23 = M_0_0_now*Q_0_now_by + M_0_0_now_by*Q_0_now
        s26 = M_0_1_now*Q_1_now_by + M_0_1_now_by*Q_1_now
        s29 = M_0_2_now*Q_2_now_by + M_0_2_now_by*Q_2_now
        s32 = M_1_0_now*Q_0_now_by + M_1_0_now_by*Q_0_now
        s35 = M_1_1_now*Q_1_now_by + M_1_1_now_by*Q_1_now
        s38 = M_1_2_now*Q_2_now_by + M_1_2_now_by*Q_2_now
        s41 = M_2_0_now*Q_0_now_by + M_2_0_now_by*Q_0_now
        s44 = M_2_1_now*Q_1_now_by + M_2_1_now_by*Q_1_now
        s47 = M_2_2_now*Q_2_now_by + M_2_2_now_by*Q_2_now
        s57 = V_0_0_now*q_t_0_now_by + V_0_1_now*q_t_1_now_by + V_0_2_now*q_t_2_now_by + q_t_0_now*s23 + q_t_1_now*s26 + q_t_2_now*s29
        s67 = V_1_0_now*q_t_0_now_by + V_1_1_now*q_t_1_now_by + V_1_2_now*q_t_2_now_by + q_t_0_now*s32 + q_t_1_now*s35 + q_t_2_now*s38
        s77 = V_2_0_now*q_t_0_now_by + V_2_1_now*q_t_1_now_by + V_2_2_now*q_t_2_now_by + q_t_0_now*s41 + q_t_1_now*s44 + q_t_2_now*s47
        s_by[0 + lane] = s23
        s_by[32 + lane] = s26
        s_by[64 + lane] = s29
        s_by[96 + lane] = s32
        s_by[128 + lane] = s35
        s_by[160 + lane] = s38
        s_by[192 + lane] = s41
        s_by[224 + lane] = s44
        s_by[256 + lane] = s47
        s_by[288 + lane] = s57
        s_by[320 + lane] = s67
        s_by[352 + lane] = s77


@straight
def _curved_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of second derivatives of a limb's equations by time where nothing accelerates (199 operations)."""
    theta0_now = k[0]
    u_x_now = k[1]
    u_y_now = k[2]
    s11_now = k[3]
    s14_now = k[4]
    s16_now = k[5]
    s20_now = k[6]
    s22_now = k[7]
    tip_v_now = k[8]
    px0_now = k[9]
    py0_now = k[10]
    pz0_now = k[11]
    s31_now = k[12]
    s33_now = k[13]
    theta0_now_by = k_by[0]
    u_x_now_by = k_by[1]
    u_y_now_by = k_by[2]
    s11_now_by = k_by[3]
    s14_now_by = k_by[4]
    s16_now_by = k_by[5]
    s20_now_by = k_by[6]
    s22_now_by = k_by[7]
    tip_v_now_by = k_by[8]
    px0_now_by = k_by[9]
    py0_now_by = k_by[10]
    pz0_now_by = k_by[11]
    s31_now_by = k_by[12]
    s33_now_by = k_by[13]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        v_px_now = s[288 + lane]
        v_py_now = s[320 + lane]
        v_pz_now = s[352 + lane]
        q_t_now = d[0 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        v_px_now_by = s_by[288 + lane]
        v_py_now_by = s_by[320 + lane]
        v_pz_now_by = s_by[352 + lane]
        q_t_now_by = d_by[0 + lane]
        s6_now = q_now + theta0_now
        s7_now = cosine(s6_now)
        arm_x_now = s7_now*u_x_now
        arm_y_now = s7_now*u_y_now
        arm_z_now = sine(s6_now)
        B_x_now = arm_x_now*s11_now + arm_z_now*s14_now + s16_now
        B_y_now = arm_y_now*s11_now + arm_z_now*s20_now + s22_now
        B_z_now = arm_z_now*s11_now + s7_now*tip_v_now
        centre_x_now = px0_now + px_now - tx_now
        centre_y_now = py0_now + py_now - ty_now
        centre_z_now = pz0_now + pz_now - tz_now
        C_x_now = centre_x_now + s31_now
        C_y_now = centre_y_now + s33_now
        rod_x_now = -B_x_now + C_x_now
        rod_y_now = -B_y_now + C_y_now
        rod_z_now = -B_z_now + centre_z_now
        s48_now = -arm_z_now*q_t_now
        s51_now = q_t_now*s7_now
        s61_now = -s11_now*s48_now*u_x_now - s14_now*s51_now + v_px_now
        s62_now = -s11_now*s48_now*u_y_now - s20_now*s51_now + v_py_now
        s63_now = -s11_now*s51_now - s48_now*tip_v_now + v_pz_now
        s74_now = -q_t_now*s51_now
        s77_now = q_t_now*s48_now
        s53 = -arm_z_now*theta0_now_by
        s60 = s7_now*theta0_now_by
        s85 = px0_now_by + px_now_by + s31_now_by
        s86 = py0_now_by + py_now_by + s33_now_by
        s87 = -arm_x_now*s11_now_by - arm_z_now*s14_now_by - s11_now*(s53*u_x_now + s7_now*u_x_now_by) - s14_now*s60 - s16_now_by + s85
        s88 = -arm_y_now*s11_now_by - arm_z_now*s20_now_by - s11_now*(s53*u_y_now + s7_now*u_y_now_by) - s20_now*s60 - s22_now_by + s86
        s89 = -arm_z_now*s11_now_by + pz0_now_by + pz_now_by - s11_now*s60 - s53*tip_v_now - s7_now*tip_v_now_by
        s92 = -arm_z_now*q_t_now_by - q_t_now*s60
        s95 = q_t_now*s53 + q_t_now_by*s7_now
        s100 = -s11_now*u_x_now
        s101 = -s11_now*s48_now
        s111 = -s11_now*u_y_now
        s126 = -q_t_now*s95 - q_t_now_by*s51_now
        s129 = q_t_now*s92 + q_t_now_by*s48_now
        s130 = 2*s62_now
        s131 = s130*(s101*u_y_now_by + s111*s92 - s11_now_by*s48_now*u_y_now - s20_now*s95 - s20_now_by*s51_now + v_py_now_by)
        s136 = s11_now*s74_now
        s143 = -rod_y_now*(-s111*s126 + s11_now_by*s74_now*u_y_now + s129*s20_now + s136*u_y_now_by + s20_now_by*s77_now)
        s156 = -rod_z_now*(s11_now*s129 + s11_now_by*s77_now + s126*tip_v_now + s74_now*tip_v_now_by)
        s157 = s156 - s89*(s11_now*s77_now + s74_now*tip_v_now)
        s158 = s157 + 2*s63_now*(-s11_now*s95 - s11_now_by*s51_now - s48_now*tip_v_now_by - s92*tip_v_now + v_pz_now_by)
        s159 = 2*s61_now
        s160 = s159*(s100*s92 + s101*u_x_now_by - s11_now_by*s48_now*u_x_now - s14_now*s95 - s14_now_by*s51_now + v_px_now_by)
        s171 = -rod_x_now*(-s100*s126 + s11_now_by*s74_now*u_x_now + s129*s14_now + s136*u_x_now_by + s14_now_by*s77_now)
        s172 = s171 - s87*(s11_now*s74_now*u_x_now + s14_now*s77_now)
        s173 = s131 + s143 + s158 + s160 + s172 - s88*(s11_now*s74_now*u_y_now + s20_now*s77_now)
        d_by[64 + lane] = s173


@straight
def _accelerate_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform's acceleration (69 operations)."""
    for lane in range(n):
        M_0_0_now = w[3808 + lane]
        M_0_1_now = w[3840 + lane]
        M_0_2_now = w[3872 + lane]
        M_1_0_now = w[3904 + lane]
        M_1_1_now = w[3936 + lane]
        M_1_2_now = w[3968 + lane]
        M_2_0_now = w[4000 + lane]
        M_2_1_now = w[4032 + lane]
        M_2_2_now = w[4064 + lane]
        q_tt_0_now = d[32 + lane]
        c_0_now = d[64 + lane]
        q_tt_1_now = d[896 + lane]
        c_1_now = d[928 + lane]
        q_tt_2_now = d[1760 + lane]
        c_2_now = d[1792 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_0_2_now = s[64 + lane]
        V_1_0_now = s[96 + lane]
        V_1_1_now = s[128 + lane]
        V_1_2_now = s[160 + lane]
        V_2_0_now = s[192 + lane]
        V_2_1_now = s[224 + lane]
        V_2_2_now = s[256 + lane]
        M_0_0_now_by = w_by[3808 + lane]
        M_0_1_now_by = w_by[3840 + lane]
        M_0_2_now_by = w_by[3872 + lane]
        M_1_0_now_by = w_by[3904 + lane]
        M_1_1_now_by = w_by[3936 + lane]
        M_1_2_now_by = w_by[3968 + lane]
        M_2_0_now_by = w_by[4000 + lane]
        M_2_1_now_by = w_by[4032 + lane]
        M_2_2_now_by = w_by[4064 + lane]
        q_tt_0_now_by = d_by[32 + lane]
        c_0_now_by = d_by[64 + lane]
        q_tt_1_now_by = d_by[896 + lane]
        c_1_now_by = d_by[928 + lane]
        q_tt_2_now_by = d_by[1760 + lane]
        c_2_now_by = d_by[1792 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_0_2_now_by = s_by[64 + lane]
        V_1_0_now_by = s_by[96 + lane]
        V_1_1_now_by = s_by[128 + lane]
        V_1_2_now_by = s_by[160 + lane]
        V_2_0_now_by = s_by[192 + lane]
        V_2_1_now_by = s_by[224 + lane]
        V_2_2_now_by = s_by[256 + lane]
        s29 = M_0_2_now*c_2_now_by + M_0_2_now_by*c_2_now
        s32 = V_0_0_now*q_tt_0_now_by + V_0_0_now_by*q_tt_0_now
        s35 = V_0_1_now*q_tt_1_now_by + V_0_1_now_by*q_tt_1_now
        s38 = V_0_2_now*q_tt_2_now_by + V_0_2_now_by*q_tt_2_now
        s39 = M_0_0_now*c_0_now_by + M_0_0_now_by*c_0_now + M_0_1_now*c_1_now_by + M_0_1_now_by*c_1_now + s29 + s32 + s35 + s38
        s48 = M_1_2_now*c_2_now_by + M_1_2_now_by*c_2_now
        s51 = V_1_0_now*q_tt_0_now_by + V_1_0_now_by*q_tt_0_now
        s54 = V_1_1_now*q_tt_1_now_by + V_1_1_now_by*q_tt_1_now
        s57 = V_1_2_now*q_tt_2_now_by + V_1_2_now_by*q_tt_2_now
        s58 = M_1_0_now*c_0_now_by + M_1_0_now_by*c_0_now + M_1_1_now*c_1_now_by + M_1_1_now_by*c_1_now + s48 + s51 + s54 + s57
        s67 = M_2_2_now*c_2_now_by + M_2_2_now_by*c_2_now
        s70 = V_2_0_now*q_tt_0_now_by + V_2_0_now_by*q_tt_0_now
        s73 = V_2_1_now*q_tt_1_now_by + V_2_1_now_by*q_tt_1_now
        s76 = V_2_2_now*q_tt_2_now_by + V_2_2_now_by*q_tt_2_now
        s77 = M_2_0_now*c_0_now_by + M_2_0_now_by*c_0_now + M_2_1_now*c_1_now_by + M_2_1_now_by*c_1_now + s67 + s70 + s73 + s76
        s_by[384 + lane] = s39
        s_by[416 + lane] = s58
        s_by[448 + lane] = s77


@straight
def _limb_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a limb (94 operations)."""
    theta0_now = k[0]
    u_x_now = k[1]
    u_y_now = k[2]
    s11_now = k[3]
    s14_now = k[4]
    s20_now = k[6]
    tip_v_now = k[8]
    theta0_now_by = k_by[0]
    u_x_now_by = k_by[1]
    u_y_now_by = k_by[2]
    s11_now_by = k_by[3]
    s14_now_by = k_by[4]
    s20_now_by = k_by[6]
    tip_v_now_by = k_by[8]
    for lane in range(n):
        q_now = w[0 + lane]
        q_t_now = d[0 + lane]
        q_tt_now = d[32 + lane]
        v_px_t_now_by = s_by[384 + lane]
        v_py_t_now_by = s_by[416 + lane]
        v_pz_t_now_by = s_by[448 + lane]
        q_t_now_by = d_by[0 + lane]
        q_tt_now_by = d_by[32 + lane]
        s6_now = q_now + theta0_now
        s7_now = cosine(s6_now)
        arm_z_now = sine(s6_now)
        s4 = (q_t_now * q_t_now)
        s412_now = -arm_z_now*q_tt_now - s4*s7_now
        s416_now = -arm_z_now*s4 + q_tt_now*s7_now
        s49 = -arm_z_now*theta0_now_by
        s50 = s7_now*theta0_now_by
        s55 = 2*q_t_now*q_t_now_by
        s59 = -arm_z_now*q_tt_now_by - q_tt_now*s50 - s4*s49 - s55*s7_now
        s66 = -arm_z_now*s55 + q_tt_now*s49 + q_tt_now_by*s7_now - s4*s50
        s69 = s11_now*s412_now
        s73 = s11_now*s59*u_x_now + s11_now_by*s412_now*u_x_now + s69*u_x_now_by
        s77 = s14_now*s66 + s14_now_by*s416_now + s73
        s83 = s11_now*s59*u_y_now + s11_now_by*s412_now*u_y_now + s69*u_y_now_by
        s87 = s20_now*s66 + s20_now_by*s416_now + s83
        s90 = s11_now*s66 + s11_now_by*s416_now
        s94 = s412_now*tip_v_now_by + s59*tip_v_now + s90
        s95 = -0.001*s73
        s96 = -0.001*s83
        s97 = -0.001*s90
        s98 = -0.001*s77
        s99 = -0.001*s87
        s100 = -0.001*s94
        s103 = -0.0005*s77 - 0.0005*v_px_t_now_by
        s106 = -0.0005*s87 - 0.0005*v_py_t_now_by
        s109 = -0.0005*s94 - 0.0005*v_pz_t_now_by
        s110 = -0.001*v_px_t_now_by
        s111 = -0.001*v_py_t_now_by
        s112 = -0.001*v_pz_t_now_by
        d_by[192 + lane] = s95
        d_by[224 + lane] = s96
        d_by[256 + lane] = s97
        d_by[288 + lane] = -s95
        d_by[320 + lane] = -s96
        d_by[352 + lane] = -s97
        d_by[384 + lane] = s98
        d_by[416 + lane] = s99
        d_by[448 + lane] = s100
        d_by[480 + lane] = s103
        d_by[512 + lane] = s106
        d_by[544 + lane] = s109
        d_by[576 + lane] = s110
        d_by[608 + lane] = s111
        d_by[640 + lane] = s112


@straight
def _limb_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a limb, along joint, shifts and turns (214 operations)."""
    share_now = shares[0]
    theta0_now = k[0]
    u_x_now = k[1]
    u_y_now = k[2]
    s11_now = k[3]
    s14_now = k[4]
    s20_now = k[6]
    tip_v_now = k[8]
    s109_now = k[14]
    s162_now = k[15]
    theta0_now_by = k_by[0]
    u_x_now_by = k_by[1]
    u_y_now_by = k_by[2]
    s11_now_by = k_by[3]
    s14_now_by = k_by[4]
    s20_now_by = k_by[6]
    tip_v_now_by = k_by[8]
    s109_now_by = k_by[14]
    s162_now_by = k_by[15]
    for lane in range(n):
        q_now = w[0 + lane]
        f1x_now = d[192 + lane]
        f1y_now = d[224 + lane]
        f1z_now = d[256 + lane]
        f2x_now = d[288 + lane]
        f2y_now = d[320 + lane]
        f2z_now = d[352 + lane]
        f3x_now = d[384 + lane]
        f3y_now = d[416 + lane]
        f3z_now = d[448 + lane]
        f4x_now = d[480 + lane]
        f4y_now = d[512 + lane]
        f4z_now = d[544 + lane]
        f1x_now_by = d_by[192 + lane]
        f1y_now_by = d_by[224 + lane]
        f1z_now_by = d_by[256 + lane]
        f2x_now_by = d_by[288 + lane]
        f2y_now_by = d_by[320 + lane]
        f2z_now_by = d_by[352 + lane]
        f3x_now_by = d_by[384 + lane]
        f3y_now_by = d_by[416 + lane]
        f3z_now_by = d_by[448 + lane]
        f4x_now_by = d_by[480 + lane]
        f4y_now_by = d_by[512 + lane]
        f4z_now_by = d_by[544 + lane]
        f5x_now_by = d_by[576 + lane]
        f5y_now_by = d_by[608 + lane]
        f5z_now_by = d_by[640 + lane]
        s6_now = q_now + theta0_now
        s7_now = cosine(s6_now)
        arm_z_now = sine(s6_now)
        s125_now = -f2z_now*s11_now
        s134_now = f1z_now*s11_now
        s7 = f1x_now*s109_now + f2x_now*s109_now
        s11 = f1y_now*s109_now + f2y_now*s109_now
        s154_now = s11*s11_now*u_y_now + s11_now*s7*u_x_now
        s22 = f1x_now*s162_now - f2x_now*s162_now
        s26 = f1y_now*s162_now - f2y_now*s162_now
        s191_now = s11_now*s22*u_x_now + s11_now*s26*u_y_now
        s199_now = 2 - 4*share_now
        s225_now = 2*share_now
        s242_now = 0.5*f4z_now*s199_now
        s245_now = 0.5*f4y_now*s199_now
        s248_now = 0.5*f4x_now*s199_now
        s253_now = f3z_now*s225_now + s242_now
        s258_now = f3y_now*s225_now + s245_now
        s263_now = f3x_now*s225_now + s248_now
        s64 = -arm_z_now*theta0_now_by
        s65 = s7_now*theta0_now_by
        s68 = -f2z_now*s11_now_by - f2z_now_by*s11_now
        s71 = f1z_now*s11_now_by + f1z_now_by*s11_now
        s80 = s11_now*u_x_now
        s84 = s11_now*s7*u_x_now_by
        s85 = s11_now_by*s7*u_x_now + s80*(f1x_now*s109_now_by + f1x_now_by*s109_now + f2x_now*s109_now_by + f2x_now_by*s109_now) + s84
        s93 = s11_now*u_y_now
        s98 = s11*s11_now*u_y_now_by
        s99 = s11*s11_now_by*u_y_now + s93*(f1y_now*s109_now_by + f1y_now_by*s109_now + f2y_now*s109_now_by + f2y_now_by*s109_now) + s98
        s109 = s64*(-s109_now*s125_now + s109_now*s134_now)
        s113 = -arm_z_now*(s85 + s99) - s154_now*s65
        s114 = s109 + s113 + s7_now*(-s109_now*s68 + s109_now*s71 - s109_now_by*s125_now + s109_now_by*s134_now)
        s126 = s11_now*s22*u_x_now_by
        s127 = s11_now_by*s22*u_x_now + s126 + s80*(f1x_now*s162_now_by + f1x_now_by*s162_now - f2x_now*s162_now_by - f2x_now_by*s162_now)
        s139 = s11_now*s26*u_y_now_by
        s140 = s11_now_by*s26*u_y_now + s139 + s93*(f1y_now*s162_now_by + f1y_now_by*s162_now - f2y_now*s162_now_by - f2y_now_by*s162_now)
        s150 = s64*(s125_now*s162_now + s134_now*s162_now)
        s154 = -arm_z_now*(s127 + s140) - s191_now*s65
        s155 = s150 + s154 + s7_now*(s125_now*s162_now_by + s134_now*s162_now_by + s162_now*s68 + s162_now*s71)
        s156 = 0.5*s199_now
        s158 = f4z_now_by*s156
        s160 = f4y_now_by*s156
        s162 = f4x_now_by*s156
        s164 = f5y_now_by*s225_now + s160
        s166 = f5x_now_by*s225_now + s162
        s168 = f5z_now_by*s225_now + s158
        s170 = f3z_now_by*s225_now + s158
        s172 = f3y_now_by*s225_now + s160
        s174 = f3x_now_by*s225_now + s162
        s189 = s11_now*s263_now*u_x_now_by + s11_now_by*s263_now*u_x_now + s174*s80
        s190 = s11_now*s258_now*u_y_now_by + s11_now_by*s258_now*u_y_now + s170*tip_v_now + s172*s93 + s189 + s253_now*tip_v_now_by
        s204 = s7_now*(s11_now*s170 + s11_now_by*s253_now + s14_now*s174 + s14_now_by*s263_now + s172*s20_now + s20_now_by*s258_now)
        s206 = s204 + s64*(s11_now*s253_now + s14_now*s263_now + s20_now*s258_now)
        s207 = -arm_z_now*s190 + s206 - s65*(s11_now*s258_now*u_y_now + s11_now*s263_now*u_x_now + s253_now*tip_v_now)
        d_by[672 + lane] = s114
        d_by[704 + lane] = s155
        d_by[736 + lane] = s207
        d_by[768 + lane] = s166
        d_by[800 + lane] = s164
        d_by[832 + lane] = s168


@straight
def _platform_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a platform (6 operations)."""
    for lane in range(n):
        v_px_t_now_by = s_by[384 + lane]
        v_py_t_now_by = s_by[416 + lane]
        v_pz_t_now_by = s_by[448 + lane]
        s6 = -0.001*v_px_t_now_by
        s7 = -0.001*v_py_t_now_by
        s8 = -0.001*v_pz_t_now_by
        s_by[480 + lane] = s6
        s_by[512 + lane] = s7
        s_by[544 + lane] = s8
        s_by[576 + lane] = s6
        s_by[608 + lane] = s7
        s_by[640 + lane] = s8


@straight
def _platform_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a platform, along joint, shifts and turns (0 operations)."""
    for lane in range(n):
        f0x_now_by = s_by[480 + lane]
        f0y_now_by = s_by[512 + lane]
        f0z_now_by = s_by[544 + lane]
        f1x_now_by = s_by[576 + lane]
        f1y_now_by = s_by[608 + lane]
        f1z_now_by = s_by[640 + lane]
        s_by[672 + lane] = f0x_now_by
        s_by[704 + lane] = f0y_now_by
        s_by[736 + lane] = f0z_now_by
        s_by[768 + lane] = f1x_now_by
        s_by[800 + lane] = f1y_now_by
        s_by[832 + lane] = f1z_now_by


@straight
def _give_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what the joints give (114 operations)."""
    m_1_now = inertia[1]
    m_2_now = inertia[2]
    m_3_now = inertia[3]
    m_5_now = inertia[5]
    m_6_now = inertia[6]
    m_7_now = inertia[7]
    m_9_now = inertia[9]
    m_10_now = inertia[10]
    m_11_now = inertia[11]
    m_12_now = inertia[12]
    m_13_now = inertia[13]
    for lane in range(n):
        a_0_3_now = d[768 + lane]
        a_0_4_now = d[800 + lane]
        a_0_5_now = d[832 + lane]
        a_1_3_now = d[1632 + lane]
        a_1_4_now = d[1664 + lane]
        a_1_5_now = d[1696 + lane]
        a_2_3_now = d[2496 + lane]
        a_2_4_now = d[2528 + lane]
        a_2_5_now = d[2560 + lane]
        a_p_0_now = s[672 + lane]
        a_p_1_now = s[704 + lane]
        a_p_2_now = s[736 + lane]
        a_p_3_now = s[768 + lane]
        a_p_4_now = s[800 + lane]
        a_p_5_now = s[832 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_0_2_now = s[64 + lane]
        V_1_0_now = s[96 + lane]
        V_1_1_now = s[128 + lane]
        V_1_2_now = s[160 + lane]
        V_2_0_now = s[192 + lane]
        V_2_1_now = s[224 + lane]
        V_2_2_now = s[256 + lane]
        a_0_0_now_by = d_by[672 + lane]
        a_0_1_now_by = d_by[704 + lane]
        a_0_2_now_by = d_by[736 + lane]
        a_0_3_now_by = d_by[768 + lane]
        a_0_4_now_by = d_by[800 + lane]
        a_0_5_now_by = d_by[832 + lane]
        a_1_0_now_by = d_by[1536 + lane]
        a_1_1_now_by = d_by[1568 + lane]
        a_1_2_now_by = d_by[1600 + lane]
        a_1_3_now_by = d_by[1632 + lane]
        a_1_4_now_by = d_by[1664 + lane]
        a_1_5_now_by = d_by[1696 + lane]
        a_2_0_now_by = d_by[2400 + lane]
        a_2_1_now_by = d_by[2432 + lane]
        a_2_2_now_by = d_by[2464 + lane]
        a_2_3_now_by = d_by[2496 + lane]
        a_2_4_now_by = d_by[2528 + lane]
        a_2_5_now_by = d_by[2560 + lane]
        a_p_0_now_by = s_by[672 + lane]
        a_p_1_now_by = s_by[704 + lane]
        a_p_2_now_by = s_by[736 + lane]
        a_p_3_now_by = s_by[768 + lane]
        a_p_4_now_by = s_by[800 + lane]
        a_p_5_now_by = s_by[832 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_0_2_now_by = s_by[64 + lane]
        V_1_0_now_by = s_by[96 + lane]
        V_1_1_now_by = s_by[128 + lane]
        V_1_2_now_by = s_by[160 + lane]
        V_2_0_now_by = s_by[192 + lane]
        V_2_1_now_by = s_by[224 + lane]
        V_2_2_now_by = s_by[256 + lane]
        W_0_now = a_0_3_now*m_3_now + a_1_3_now*m_7_now + a_2_3_now*m_11_now + a_p_0_now*m_12_now + a_p_3_now*m_13_now
        W_1_now = a_0_4_now*m_3_now + a_1_4_now*m_7_now + a_2_4_now*m_11_now + a_p_1_now*m_12_now + a_p_4_now*m_13_now
        W_2_now = a_0_5_now*m_3_now + a_1_5_now*m_7_now + a_2_5_now*m_11_now + a_p_2_now*m_12_now + a_p_5_now*m_13_now
        s44 = a_0_3_now_by*m_3_now + a_1_3_now_by*m_7_now + a_2_3_now_by*m_11_now + a_p_0_now_by*m_12_now + a_p_3_now_by*m_13_now
        s50 = a_0_4_now_by*m_3_now + a_1_4_now_by*m_7_now + a_2_4_now_by*m_11_now + a_p_1_now_by*m_12_now + a_p_4_now_by*m_13_now
        s56 = a_0_5_now_by*m_3_now + a_1_5_now_by*m_7_now + a_2_5_now_by*m_11_now + a_p_2_now_by*m_12_now + a_p_5_now_by*m_13_now
        s65 = -V_2_0_now*s56 - V_2_0_now_by*W_2_now
        s67 = -a_0_1_now_by*m_2_now
        s68 = -a_0_2_now_by*m_3_now
        s69 = -V_0_0_now*s44 - V_0_0_now_by*W_0_now - V_1_0_now*s50 - V_1_0_now_by*W_1_now - a_0_0_now_by*m_1_now + s65 + s67 + s68
        s78 = -V_2_1_now*s56 - V_2_1_now_by*W_2_now
        s80 = -a_1_1_now_by*m_6_now
        s81 = -a_1_2_now_by*m_7_now
        s82 = -V_0_1_now*s44 - V_0_1_now_by*W_0_now - V_1_1_now*s50 - V_1_1_now_by*W_1_now - a_1_0_now_by*m_5_now + s78 + s80 + s81
        s91 = -V_2_2_now*s56 - V_2_2_now_by*W_2_now
        s93 = -a_2_1_now_by*m_10_now
        s94 = -a_2_2_now_by*m_11_now
        s95 = -V_0_2_now*s44 - V_0_2_now_by*W_0_now - V_1_2_now*s50 - V_1_2_now_by*W_1_now - a_2_0_now_by*m_9_now + s91 + s93 + s94
        s_by[864 + lane] = s69
        s_by[896 + lane] = s82
        s_by[928 + lane] = s95


@straight
def _step_by(moves, w_by, first, last, n):
    """Move the platform by its twists, which a step takes off, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w_by[3648 + lane] = -moves[3 * m + 0]
        w_by[3680 + lane] = -moves[3 * m + 1]
        w_by[3712 + lane] = -moves[3 * m + 2]


@straight
def _held(w, size):
    """Begin with nothing that changes."""
    for n in range(size):
        w[n] = 0.0


@straight
def _pay_by(w, s_by, tau, first, last):
    """Write how what the joints give changes."""
    for lane in range(last - first + 1):
        regular = (w[4096 + lane] > 0.0)
        tau[3 * (first + lane) + 0] = s_by[864 + lane] if regular else math.nan
        tau[3 * (first + lane) + 1] = s_by[896 + lane] if regular else math.nan
        tau[3 * (first + lane) + 2] = s_by[928 + lane] if regular else math.nan


@fast
def _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    found, moves = tau.reshape(tau.size), x_by.reshape(x_by.size)
    w_by, d_by, s_by = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    _held(w_by, WORK)
    _held(d_by, 3 * OWN)
    _held(s_by, SHARED)
    u_1, e_1 = w_by[0:1216], d_by[0 * OWN:1 * OWN]
    u_2, e_2 = w_by[1216:2432], d_by[1 * OWN:2 * OWN]
    u_3, e_3 = w_by[2432:3648], d_by[2 * OWN:3 * OWN]
    w, d, s = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    w_1 = w[0:1216]
    w_2 = w[1216:2432]
    w_3 = w[2432:3648]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    d_3 = d[2 * OWN:3 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 3 :], states[2 * samples * 3 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
        k_3, own_3 = k[m, 2], c[m, 2]
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
            _early(w_3, k_3, n)
            _more(w_3, k_3, n)
            _rows(w_3, k_3, n)
            _joints(w_3, k_3, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _curved(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_fields(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give(d, s, inertia, n)
            for e in range(len(k_by)):
                k_by_1, own_by_1 = k_by[e, 0], c_by[e, 0]
                k_by_2, own_by_2 = k_by[e, 1], c_by[e, 1]
                k_by_3, own_by_3 = k_by[e, 2], c_by[e, 2]
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
                _early_by(
                    w_3, u_3, d_3, e_3, s, s_by, k_3, k_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _more_by(
                    w_3, u_3, d_3, e_3, s, s_by, k_3, k_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _rows_by(
                    w_3, u_3, d_3, e_3, s, s_by, k_3, k_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _joints_by(
                    w_3, u_3, d_3, e_3, s, s_by, k_3, k_by_3,
                    gravity, shares[2:], inertia, n,
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
                _curved_by(
                    w_3, u_3, d_3, e_3, s, s_by, own_3, own_by_3,
                    gravity, shares[2:], inertia, n,
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
                _limb_fields_by(
                    w_3, u_3, d_3, e_3, s, s_by, own_3, own_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _limb_asks_by(
                    w_3, u_3, d_3, e_3, s, s_by, own_3, own_by_3,
                    gravity, shares[2:], inertia, n,
                )
                _platform_fields_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _platform_asks_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _give_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _pay_by(w, s_by, found[e * samples * 3 :], first, last)


def torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    """Fill tau (E, N, 3) [N mm, N]: how `torque` of one machine changes along each of E errors, joints held.

    x_by (E, N, 3) are its platform's twists along them, shift and turn about the axes of {O}; k_by and c_by are
    what `constants_by` makes of them.
    """
    _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau)
