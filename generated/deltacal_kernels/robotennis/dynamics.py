"""Dynamics of `robotennis`, many samples at once: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 20610c54bed0847f; SymPy 1.14.0.

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
