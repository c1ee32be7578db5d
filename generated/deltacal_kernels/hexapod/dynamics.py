"""Dynamics of `hexapod`, many samples at once: Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both e40ef027afd81888; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 6)  platform: px py pz cx cy cz
motion (3, N, 6)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 6, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 6, 12)  what `constants` makes of p (M, 6, 15)
gravity (3,)  in {O} [m/s^2]      shares (6,)  of a rod's mass at either end: 1/6 where it is uniform
inertia (20,)  of `LIMB`, limb by limb, then of `PLATFORM`, of which the payload is the last

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
    ("mx_lower", "kg mm", "its first moment along the leg's lower part"),
    ("i_lower", "kg mm^2", "its inertia about the joint"),
    ("m_rod", "kg", "mass of the leg's upper part"),
)
PLATFORM = (
    ("m_platform", "kg", "mass of the platform, at its centre"),
    ("payload", "kg", "mass at the reference point"),
)
OWN, SHARED = 1248, 5856  # numbers of a limb's second region; of what all share
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


def stated(geometry, masses, own):
    """Return what a robot file says of inertial parameters, by name: one value, or one per limb.

    `own` is a limb's own inertia about its centre of mass [kg mm^2].
    """
    leg = geometry["leg_length"]
    proximal = masses["proximal"]
    proximal_com = masses["proximal_com"]
    distal_rod = masses["distal_rod"]
    platform = masses["platform"]
    return {
        "mx_lower": leg*proximal*proximal_com,
        "i_lower": (leg * leg)*proximal*(proximal_com * proximal_com) + own,
        "m_rod": distal_rod,
        "m_platform": platform,
    }


@straight
def _fill(p, k, rows):
    for lane in range(rows):
        base = p[15 * lane + 0]
        alpha = p[15 * lane + 1]
        up = p[15 * lane + 2]
        plate = p[15 * lane + 3]
        beta = p[15 * lane + 4]
        down = p[15 * lane + 5]
        leg = p[15 * lane + 6]
        ax = p[15 * lane + 7]
        ay = p[15 * lane + 8]
        az = p[15 * lane + 9]
        bx = p[15 * lane + 10]
        by = p[15 * lane + 11]
        bz = p[15 * lane + 12]
        dl = p[15 * lane + 13]
        scale = p[15 * lane + 14]
        A_x = ax + base*cosine(alpha)
        A_y = ay + base*sine(alpha)
        A_z = az + up
        s9 = bx + plate*cosine(beta)
        s13 = by + plate*sine(beta)
        s15 = bz + down
        s32 = scale + 1
        s34 = dl + leg
        s231 = 0.5/leg
        s321 = 0.5/(leg * leg)
        s418 = -0.5*leg
        k[12 * lane + 0] = s9
        k[12 * lane + 1] = s13
        k[12 * lane + 2] = s15
        k[12 * lane + 3] = A_x
        k[12 * lane + 4] = A_y
        k[12 * lane + 5] = A_z
        k[12 * lane + 6] = s32
        k[12 * lane + 7] = s34
        k[12 * lane + 8] = leg
        k[12 * lane + 9] = s418
        k[12 * lane + 10] = s231
        k[12 * lane + 11] = s321


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return c (M, 6, 12), what no pose changes of bodies in motion, from p (23 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 6, 12))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (102 operations)."""
    for lane in range(n):
        M_0_0 = w[9696 + lane]
        M_0_1 = w[9728 + lane]
        M_0_2 = w[9760 + lane]
        M_0_3 = w[9792 + lane]
        M_0_4 = w[9824 + lane]
        M_0_5 = w[9856 + lane]
        M_1_0 = w[9888 + lane]
        M_1_1 = w[9920 + lane]
        M_1_2 = w[9952 + lane]
        M_1_3 = w[9984 + lane]
        M_1_4 = w[10016 + lane]
        M_1_5 = w[10048 + lane]
        M_2_0 = w[10080 + lane]
        M_2_1 = w[10112 + lane]
        M_2_2 = w[10144 + lane]
        M_2_3 = w[10176 + lane]
        M_2_4 = w[10208 + lane]
        M_2_5 = w[10240 + lane]
        M_3_0 = w[10272 + lane]
        M_3_1 = w[10304 + lane]
        M_3_2 = w[10336 + lane]
        M_3_3 = w[10368 + lane]
        M_3_4 = w[10400 + lane]
        M_3_5 = w[10432 + lane]
        M_4_0 = w[10464 + lane]
        M_4_1 = w[10496 + lane]
        M_4_2 = w[10528 + lane]
        M_4_3 = w[10560 + lane]
        M_4_4 = w[10592 + lane]
        M_4_5 = w[10624 + lane]
        M_5_0 = w[10656 + lane]
        M_5_1 = w[10688 + lane]
        M_5_2 = w[10720 + lane]
        M_5_3 = w[10752 + lane]
        M_5_4 = w[10784 + lane]
        M_5_5 = w[10816 + lane]
        q_t_0 = d[0 + lane]
        Q_0 = w[832 + lane]
        q_t_1 = d[1248 + lane]
        Q_1 = w[2400 + lane]
        q_t_2 = d[2496 + lane]
        Q_2 = w[3968 + lane]
        q_t_3 = d[3744 + lane]
        Q_3 = w[5536 + lane]
        q_t_4 = d[4992 + lane]
        Q_4 = w[7104 + lane]
        q_t_5 = d[6240 + lane]
        Q_5 = w[8672 + lane]
        V_0_0 = M_0_0*Q_0
        V_0_1 = M_0_1*Q_1
        V_0_2 = M_0_2*Q_2
        V_0_3 = M_0_3*Q_3
        V_0_4 = M_0_4*Q_4
        V_0_5 = M_0_5*Q_5
        V_1_0 = M_1_0*Q_0
        V_1_1 = M_1_1*Q_1
        V_1_2 = M_1_2*Q_2
        V_1_3 = M_1_3*Q_3
        V_1_4 = M_1_4*Q_4
        V_1_5 = M_1_5*Q_5
        V_2_0 = M_2_0*Q_0
        V_2_1 = M_2_1*Q_1
        V_2_2 = M_2_2*Q_2
        V_2_3 = M_2_3*Q_3
        V_2_4 = M_2_4*Q_4
        V_2_5 = M_2_5*Q_5
        V_3_0 = M_3_0*Q_0
        V_3_1 = M_3_1*Q_1
        V_3_2 = M_3_2*Q_2
        V_3_3 = M_3_3*Q_3
        V_3_4 = M_3_4*Q_4
        V_3_5 = M_3_5*Q_5
        V_4_0 = M_4_0*Q_0
        V_4_1 = M_4_1*Q_1
        V_4_2 = M_4_2*Q_2
        V_4_3 = M_4_3*Q_3
        V_4_4 = M_4_4*Q_4
        V_4_5 = M_4_5*Q_5
        V_5_0 = M_5_0*Q_0
        V_5_1 = M_5_1*Q_1
        V_5_2 = M_5_2*Q_2
        V_5_3 = M_5_3*Q_3
        V_5_4 = M_5_4*Q_4
        V_5_5 = M_5_5*Q_5
        s42 = V_0_0*q_t_0 + V_0_1*q_t_1 + V_0_2*q_t_2 + V_0_3*q_t_3 + V_0_4*q_t_4 + V_0_5*q_t_5
        s49 = V_1_0*q_t_0 + V_1_1*q_t_1 + V_1_2*q_t_2 + V_1_3*q_t_3 + V_1_4*q_t_4 + V_1_5*q_t_5
        s56 = V_2_0*q_t_0 + V_2_1*q_t_1 + V_2_2*q_t_2 + V_2_3*q_t_3 + V_2_4*q_t_4 + V_2_5*q_t_5
        s63 = V_3_0*q_t_0 + V_3_1*q_t_1 + V_3_2*q_t_2 + V_3_3*q_t_3 + V_3_4*q_t_4 + V_3_5*q_t_5
        s70 = V_4_0*q_t_0 + V_4_1*q_t_1 + V_4_2*q_t_2 + V_4_3*q_t_3 + V_4_4*q_t_4 + V_4_5*q_t_5
        s77 = V_5_0*q_t_0 + V_5_1*q_t_1 + V_5_2*q_t_2 + V_5_3*q_t_3 + V_5_4*q_t_4 + V_5_5*q_t_5
        s[0 + lane] = V_0_0
        s[32 + lane] = V_0_1
        s[64 + lane] = V_0_2
        s[96 + lane] = V_0_3
        s[128 + lane] = V_0_4
        s[160 + lane] = V_0_5
        s[192 + lane] = V_1_0
        s[224 + lane] = V_1_1
        s[256 + lane] = V_1_2
        s[288 + lane] = V_1_3
        s[320 + lane] = V_1_4
        s[352 + lane] = V_1_5
        s[384 + lane] = V_2_0
        s[416 + lane] = V_2_1
        s[448 + lane] = V_2_2
        s[480 + lane] = V_2_3
        s[512 + lane] = V_2_4
        s[544 + lane] = V_2_5
        s[576 + lane] = V_3_0
        s[608 + lane] = V_3_1
        s[640 + lane] = V_3_2
        s[672 + lane] = V_3_3
        s[704 + lane] = V_3_4
        s[736 + lane] = V_3_5
        s[768 + lane] = V_4_0
        s[800 + lane] = V_4_1
        s[832 + lane] = V_4_2
        s[864 + lane] = V_4_3
        s[896 + lane] = V_4_4
        s[928 + lane] = V_4_5
        s[960 + lane] = V_5_0
        s[992 + lane] = V_5_1
        s[1024 + lane] = V_5_2
        s[1056 + lane] = V_5_3
        s[1088 + lane] = V_5_4
        s[1120 + lane] = V_5_5
        s[1152 + lane] = s42
        s[1184 + lane] = s49
        s[1216 + lane] = s56
        s[1248 + lane] = s63
        s[1280 + lane] = s70
        s[1312 + lane] = s77


@straight
def _curved(w, d, s, k, gravity, shares, n):
    """Second derivatives of a limb's equations by time where nothing accelerates (132 operations)."""
    s9 = k[0]
    s13 = k[1]
    s15 = k[2]
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    s32 = k[6]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        v_px = s[1152 + lane]
        v_py = s[1184 + lane]
        v_pz = s[1216 + lane]
        w_x = s[1248 + lane]
        w_y = s[1280 + lane]
        w_z = s[1312 + lane]
        q_t = d[0 + lane]
        b_x = s9 - tx
        b_y = s13 - ty
        b_z = s15 - tz
        B_x = R_11*b_x + R_12*b_y + R_13*b_z + px
        B_y = R_21*b_x + R_22*b_y + R_23*b_z + py
        B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz
        d_x = -A_x + B_x
        d_y = -A_y + B_y
        d_z = -A_z + B_z
        s51 = -R_21*w_z + R_31*w_y
        s54 = -R_22*w_z + R_32*w_y
        s57 = -R_23*w_z + R_33*w_y
        s60 = R_11*w_z - R_31*w_x
        s63 = R_12*w_z - R_32*w_x
        s66 = R_13*w_z - R_33*w_x
        s69 = -R_11*w_y + R_21*w_x
        s72 = -R_12*w_y + R_22*w_x
        s75 = -R_13*w_y + R_23*w_x
        s79 = b_x*s51 + b_y*s54 + b_z*s57 + v_px
        s83 = b_x*s60 + b_y*s63 + b_z*s66 + v_py
        s87 = b_x*s69 + b_y*s72 + b_z*s75 + v_pz
        s88 = q_t*s32
        s142 = b_z*(-s66*w_z + s75*w_y)
        s146 = b_z*(s57*w_z - s75*w_x)
        s150 = b_z*(-s57*w_y + s66*w_x)
        s176 = 2*d_x*(b_x*(-s60*w_z + s69*w_y) + b_y*(-s63*w_z + s72*w_y) + s142)
        s181 = 2*d_y*(b_x*(s51*w_z - s69*w_x) + b_y*(s54*w_z - s72*w_x) + s146)
        s186 = 2*d_z*(b_x*(-s51*w_y + s60*w_x) + b_y*(-s54*w_y + s63*w_x) + s150)
        s191 = -(s88 * s88)
        s192 = 0.5*s176 + 0.5*s181 + 0.5*s186 + s191 + (s79 * s79) + (s83 * s83) + (s87 * s87)
        d[64 + lane] = s192


@straight
def _accelerate(w, d, s, n):
    """The platform's acceleration (138 operations)."""
    for lane in range(n):
        M_0_0 = w[9696 + lane]
        M_0_1 = w[9728 + lane]
        M_0_2 = w[9760 + lane]
        M_0_3 = w[9792 + lane]
        M_0_4 = w[9824 + lane]
        M_0_5 = w[9856 + lane]
        M_1_0 = w[9888 + lane]
        M_1_1 = w[9920 + lane]
        M_1_2 = w[9952 + lane]
        M_1_3 = w[9984 + lane]
        M_1_4 = w[10016 + lane]
        M_1_5 = w[10048 + lane]
        M_2_0 = w[10080 + lane]
        M_2_1 = w[10112 + lane]
        M_2_2 = w[10144 + lane]
        M_2_3 = w[10176 + lane]
        M_2_4 = w[10208 + lane]
        M_2_5 = w[10240 + lane]
        M_3_0 = w[10272 + lane]
        M_3_1 = w[10304 + lane]
        M_3_2 = w[10336 + lane]
        M_3_3 = w[10368 + lane]
        M_3_4 = w[10400 + lane]
        M_3_5 = w[10432 + lane]
        M_4_0 = w[10464 + lane]
        M_4_1 = w[10496 + lane]
        M_4_2 = w[10528 + lane]
        M_4_3 = w[10560 + lane]
        M_4_4 = w[10592 + lane]
        M_4_5 = w[10624 + lane]
        M_5_0 = w[10656 + lane]
        M_5_1 = w[10688 + lane]
        M_5_2 = w[10720 + lane]
        M_5_3 = w[10752 + lane]
        M_5_4 = w[10784 + lane]
        M_5_5 = w[10816 + lane]
        q_tt_0 = d[32 + lane]
        c_0 = d[64 + lane]
        q_tt_1 = d[1280 + lane]
        c_1 = d[1312 + lane]
        q_tt_2 = d[2528 + lane]
        c_2 = d[2560 + lane]
        q_tt_3 = d[3776 + lane]
        c_3 = d[3808 + lane]
        q_tt_4 = d[5024 + lane]
        c_4 = d[5056 + lane]
        q_tt_5 = d[6272 + lane]
        c_5 = d[6304 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_0_3 = s[96 + lane]
        V_0_4 = s[128 + lane]
        V_0_5 = s[160 + lane]
        V_1_0 = s[192 + lane]
        V_1_1 = s[224 + lane]
        V_1_2 = s[256 + lane]
        V_1_3 = s[288 + lane]
        V_1_4 = s[320 + lane]
        V_1_5 = s[352 + lane]
        V_2_0 = s[384 + lane]
        V_2_1 = s[416 + lane]
        V_2_2 = s[448 + lane]
        V_2_3 = s[480 + lane]
        V_2_4 = s[512 + lane]
        V_2_5 = s[544 + lane]
        V_3_0 = s[576 + lane]
        V_3_1 = s[608 + lane]
        V_3_2 = s[640 + lane]
        V_3_3 = s[672 + lane]
        V_3_4 = s[704 + lane]
        V_3_5 = s[736 + lane]
        V_4_0 = s[768 + lane]
        V_4_1 = s[800 + lane]
        V_4_2 = s[832 + lane]
        V_4_3 = s[864 + lane]
        V_4_4 = s[896 + lane]
        V_4_5 = s[928 + lane]
        V_5_0 = s[960 + lane]
        V_5_1 = s[992 + lane]
        V_5_2 = s[1024 + lane]
        V_5_3 = s[1056 + lane]
        V_5_4 = s[1088 + lane]
        V_5_5 = s[1120 + lane]
        s1 = M_0_1*c_1
        s2 = M_0_2*c_2
        s3 = M_0_3*c_3
        s4 = M_0_4*c_4
        s5 = M_0_5*c_5
        s6 = V_0_0*q_tt_0
        s7 = V_0_1*q_tt_1
        s8 = V_0_2*q_tt_2
        s9 = V_0_3*q_tt_3
        s10 = V_0_4*q_tt_4
        s11 = V_0_5*q_tt_5
        s12 = M_0_0*c_0 + s1 + s10 + s11 + s2 + s3 + s4 + s5 + s6 + s7 + s8 + s9
        s14 = M_1_1*c_1
        s15 = M_1_2*c_2
        s16 = M_1_3*c_3
        s17 = M_1_4*c_4
        s18 = M_1_5*c_5
        s19 = V_1_0*q_tt_0
        s20 = V_1_1*q_tt_1
        s21 = V_1_2*q_tt_2
        s22 = V_1_3*q_tt_3
        s23 = V_1_4*q_tt_4
        s24 = V_1_5*q_tt_5
        s25 = M_1_0*c_0 + s14 + s15 + s16 + s17 + s18 + s19 + s20 + s21 + s22 + s23 + s24
        s27 = M_2_1*c_1
        s28 = M_2_2*c_2
        s29 = M_2_3*c_3
        s30 = M_2_4*c_4
        s31 = M_2_5*c_5
        s32 = V_2_0*q_tt_0
        s33 = V_2_1*q_tt_1
        s34 = V_2_2*q_tt_2
        s35 = V_2_3*q_tt_3
        s36 = V_2_4*q_tt_4
        s37 = V_2_5*q_tt_5
        s38 = M_2_0*c_0 + s27 + s28 + s29 + s30 + s31 + s32 + s33 + s34 + s35 + s36 + s37
        s40 = M_3_1*c_1
        s41 = M_3_2*c_2
        s42 = M_3_3*c_3
        s43 = M_3_4*c_4
        s44 = M_3_5*c_5
        s45 = V_3_0*q_tt_0
        s46 = V_3_1*q_tt_1
        s47 = V_3_2*q_tt_2
        s48 = V_3_3*q_tt_3
        s49 = V_3_4*q_tt_4
        s50 = V_3_5*q_tt_5
        s51 = M_3_0*c_0 + s40 + s41 + s42 + s43 + s44 + s45 + s46 + s47 + s48 + s49 + s50
        s53 = M_4_1*c_1
        s54 = M_4_2*c_2
        s55 = M_4_3*c_3
        s56 = M_4_4*c_4
        s57 = M_4_5*c_5
        s58 = V_4_0*q_tt_0
        s59 = V_4_1*q_tt_1
        s60 = V_4_2*q_tt_2
        s61 = V_4_3*q_tt_3
        s62 = V_4_4*q_tt_4
        s63 = V_4_5*q_tt_5
        s64 = M_4_0*c_0 + s53 + s54 + s55 + s56 + s57 + s58 + s59 + s60 + s61 + s62 + s63
        s66 = M_5_1*c_1
        s67 = M_5_2*c_2
        s68 = M_5_3*c_3
        s69 = M_5_4*c_4
        s70 = M_5_5*c_5
        s71 = V_5_0*q_tt_0
        s72 = V_5_1*q_tt_1
        s73 = V_5_2*q_tt_2
        s74 = V_5_3*q_tt_3
        s75 = V_5_4*q_tt_4
        s76 = V_5_5*q_tt_5
        s77 = M_5_0*c_0 + s66 + s67 + s68 + s69 + s70 + s71 + s72 + s73 + s74 + s75 + s76
        s[1344 + lane] = s12
        s[1376 + lane] = s25
        s[1408 + lane] = s38
        s[1440 + lane] = s51
        s[1472 + lane] = s64
        s[1504 + lane] = s77


@straight
def _limb_fields(w, d, s, k, gravity, shares, n):
    """Gravity less acceleration of the points of a limb (231 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    s9 = k[0]
    s13 = k[1]
    s15 = k[2]
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    s32 = k[6]
    s34 = k[7]
    leg = k[8]
    s418 = k[9]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        v_px = s[1152 + lane]
        v_py = s[1184 + lane]
        v_pz = s[1216 + lane]
        w_x = s[1248 + lane]
        w_y = s[1280 + lane]
        w_z = s[1312 + lane]
        v_px_t = s[1344 + lane]
        v_py_t = s[1376 + lane]
        v_pz_t = s[1408 + lane]
        w_x_t = s[1440 + lane]
        w_y_t = s[1472 + lane]
        w_z_t = s[1504 + lane]
        q_t = d[0 + lane]
        q_tt = d[32 + lane]
        b_x = s9 - tx
        b_y = s13 - ty
        b_z = s15 - tz
        B_x = R_11*b_x + R_12*b_y + R_13*b_z + px
        B_y = R_21*b_x + R_22*b_y + R_23*b_z + py
        B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz
        d_x = -A_x + B_x
        d_y = -A_y + B_y
        d_z = -A_z + B_z
        s_ = q*s32 + s34
        s36 = (1.0 / s_)
        s51 = -R_21*w_z + R_31*w_y
        s54 = -R_22*w_z + R_32*w_y
        s57 = -R_23*w_z + R_33*w_y
        s60 = R_11*w_z - R_31*w_x
        s63 = R_12*w_z - R_32*w_x
        s66 = R_13*w_z - R_33*w_x
        s69 = -R_11*w_y + R_21*w_x
        s72 = -R_12*w_y + R_22*w_x
        s75 = -R_13*w_y + R_23*w_x
        s88 = q_t*s32
        s89 = (1.0 / (s_ * s_))
        s90 = -s88*s89
        s156 = s90*(b_x*s51 + b_y*s54 + b_z*s57 + v_px)
        s162 = s90*(b_x*s60 + b_y*s63 + b_z*s66 + v_py)
        s168 = s90*(b_x*s69 + b_y*s72 + b_z*s75 + v_pz)
        s1076 = b_y*(-R_22*w_z_t + R_32*w_y_t - s63*w_z + s72*w_y)
        s1077 = b_z*(-R_23*w_z_t + R_33*w_y_t - s66*w_z + s75*w_y)
        s1078 = b_x*(-R_21*w_z_t + R_31*w_y_t - s60*w_z + s69*w_y) + s1076 + s1077 + v_px_t
        s1080 = b_y*(R_12*w_z_t - R_32*w_x_t + s54*w_z - s72*w_x)
        s1081 = b_z*(R_13*w_z_t - R_33*w_x_t + s57*w_z - s75*w_x)
        s1082 = b_x*(R_11*w_z_t - R_31*w_x_t + s51*w_z - s69*w_x) + s1080 + s1081 + v_py_t
        s1084 = b_y*(-R_12*w_y_t + R_22*w_x_t - s54*w_y + s63*w_x)
        s1085 = b_z*(-R_13*w_y_t + R_23*w_x_t - s57*w_y + s66*w_x)
        s1086 = b_x*(-R_11*w_y_t + R_21*w_x_t - s51*w_y + s60*w_x) + s1084 + s1085 + v_pz_t
        s1089 = -q_tt*s32*s89 + 2*(s88 * s88)/(s_ * s_ * s_)
        s1094 = d_x*s1089 + s1078*s36 + 2*s156
        s1099 = d_y*s1089 + s1082*s36 + 2*s162
        s1104 = d_z*s1089 + s1086*s36 + 2*s168
        s1507 = leg*s1094
        s1509 = leg*s1099
        s1511 = leg*s1104
        s2175 = -0.001*s1507
        s2176 = gx + s2175
        s2177 = -0.001*s1509
        s2178 = gy + s2177
        s2179 = -0.001*s1511
        s2180 = gz + s2179
        s2181 = gx - s2175
        s2182 = gy - s2177
        s2183 = gz - s2179
        s2185 = gx - 0.001*s1078 + 0.001*s1507
        s2187 = gy - 0.001*s1082 + 0.001*s1509
        s2189 = gz - 0.001*s1086 + 0.001*s1511
        s2191 = gx - 0.001*s1078 - 0.001*s1094*s418
        s2193 = gy - 0.001*s1082 - 0.001*s1099*s418
        s2195 = gz - 0.001*s1086 - 0.001*s1104*s418
        s2197 = gx - 0.001*s1078
        s2199 = gy - 0.001*s1082
        s2201 = gz - 0.001*s1086
        d[96 + lane] = s2176
        d[128 + lane] = s2178
        d[160 + lane] = s2180
        d[192 + lane] = s2181
        d[224 + lane] = s2182
        d[256 + lane] = s2183
        d[288 + lane] = s2185
        d[320 + lane] = s2187
        d[352 + lane] = s2189
        d[384 + lane] = s2191
        d[416 + lane] = s2193
        d[448 + lane] = s2195
        d[480 + lane] = s2197
        d[512 + lane] = s2199
        d[544 + lane] = s2201


@straight
def _limb_asks(w, d, s, k, gravity, shares, n):
    """Loads per inertial parameter of a limb, along joint, shifts and turns (241 operations)."""
    share = shares[0]
    s9 = k[0]
    s13 = k[1]
    s15 = k[2]
    A_x = k[3]
    A_y = k[4]
    A_z = k[5]
    s32 = k[6]
    s34 = k[7]
    leg = k[8]
    s418 = k[9]
    s231 = k[10]
    s321 = k[11]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        pz = w[192 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        f0x = d[96 + lane]
        f0y = d[128 + lane]
        f0z = d[160 + lane]
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
        b_x = s9 - tx
        b_y = s13 - ty
        b_z = s15 - tz
        B_x = R_11*b_x + R_12*b_y + R_13*b_z + px
        B_y = R_21*b_x + R_22*b_y + R_23*b_z + py
        B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz
        d_x = -A_x + B_x
        d_y = -A_y + B_y
        d_z = -A_z + B_z
        s_ = q*s32 + s34
        s36 = (1.0 / s_)
        s89 = (1.0 / (s_ * s_))
        s251 = leg*(f0z*s231 + f1z*s231)
        s256 = leg*(f0y*s231 + f1y*s231)
        s261 = leg*(f0x*s231 + f1x*s231)
        s263 = s251*s36
        s265 = s256*s36
        s267 = s261*s36
        s271 = -s32*s89*(d_x*s261 + d_y*s256 + d_z*s251)
        s273 = b_z*s263
        s275 = b_y*s263
        s277 = b_x*s263
        s279 = b_z*s265
        s281 = b_y*s265
        s283 = b_x*s265
        s285 = b_z*s267
        s287 = b_y*s267
        s289 = b_x*s267
        s305 = R_21*s277 + R_22*s275 + R_23*s273 - R_31*s283 - R_32*s281 - R_33*s279
        s312 = -R_11*s277 - R_12*s275 - R_13*s273 + R_31*s289 + R_32*s287 + R_33*s285
        s319 = R_11*s283 + R_12*s281 + R_13*s279 - R_21*s289 - R_22*s287 - R_23*s285
        s334 = leg*(f0z*s321 - f1z*s321)
        s339 = leg*(f0y*s321 - f1y*s321)
        s344 = leg*(f0x*s321 - f1x*s321)
        s346 = s334*s36
        s348 = s339*s36
        s350 = s344*s36
        s354 = -s32*s89*(d_x*s344 + d_y*s339 + d_z*s334)
        s356 = b_z*s346
        s358 = b_y*s346
        s360 = b_x*s346
        s362 = b_z*s348
        s364 = b_y*s348
        s366 = b_x*s348
        s368 = b_z*s350
        s370 = b_y*s350
        s372 = b_x*s350
        s388 = R_21*s360 + R_22*s358 + R_23*s356 - R_31*s366 - R_32*s364 - R_33*s362
        s395 = -R_11*s360 - R_12*s358 - R_13*s356 + R_31*s372 + R_32*s370 + R_33*s368
        s402 = R_11*s366 + R_12*s364 + R_13*s362 - R_21*s372 - R_22*s370 - R_23*s368
        s417 = 1 - 2*share
        s432 = f3z*s417
        s436 = f3y*s417
        s440 = f3x*s417
        s445 = f2z*share
        s447 = f2y*share
        s449 = f2x*share
        s462 = -leg*s445 + s418*s432
        s465 = -leg*s447 + s418*s436
        s468 = -leg*s449 + s418*s440
        s473 = -s32*s89*(d_x*s468 + d_y*s465 + d_z*s462)
        s475 = f4z*share + s36*s462 + s432 + s445
        s476 = b_z*s475
        s478 = b_y*s475
        s480 = b_x*s475
        s482 = f4y*share + s36*s465 + s436 + s447
        s483 = b_z*s482
        s485 = b_y*s482
        s487 = b_x*s482
        s489 = f4x*share + s36*s468 + s440 + s449
        s490 = b_z*s489
        s492 = b_y*s489
        s494 = b_x*s489
        s508 = R_21*s480 + R_22*s478 + R_23*s476 - R_31*s487 - R_32*s485 - R_33*s483
        s515 = -R_11*s480 - R_12*s478 - R_13*s476 + R_31*s494 + R_32*s492 + R_33*s490
        s522 = R_11*s487 + R_12*s485 + R_13*s483 - R_21*s494 - R_22*s492 - R_23*s490
        d[576 + lane] = s271
        d[608 + lane] = s267
        d[640 + lane] = s265
        d[672 + lane] = s263
        d[704 + lane] = s305
        d[736 + lane] = s312
        d[768 + lane] = s319
        d[800 + lane] = s354
        d[832 + lane] = s350
        d[864 + lane] = s348
        d[896 + lane] = s346
        d[928 + lane] = s388
        d[960 + lane] = s395
        d[992 + lane] = s402
        d[1024 + lane] = s473
        d[1056 + lane] = s489
        d[1088 + lane] = s482
        d[1120 + lane] = s475
        d[1152 + lane] = s508
        d[1184 + lane] = s515
        d[1216 + lane] = s522


@straight
def _platform_fields(w, d, s, gravity, n):
    """Gravity less acceleration of the points of a platform (126 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        w_x = s[1248 + lane]
        w_y = s[1280 + lane]
        w_z = s[1312 + lane]
        v_px_t = s[1344 + lane]
        v_py_t = s[1376 + lane]
        v_pz_t = s[1408 + lane]
        w_x_t = s[1440 + lane]
        w_y_t = s[1472 + lane]
        w_z_t = s[1504 + lane]
        s104 = -R_21*w_z + R_31*w_y
        s107 = -R_22*w_z + R_32*w_y
        s110 = -R_23*w_z + R_33*w_y
        s113 = R_11*w_z - R_31*w_x
        s116 = R_12*w_z - R_32*w_x
        s119 = R_13*w_z - R_33*w_x
        s122 = -R_11*w_y + R_21*w_x
        s125 = -R_12*w_y + R_22*w_x
        s128 = -R_13*w_y + R_23*w_x
        s316 = -ty*(-R_22*w_z_t + R_32*w_y_t - s116*w_z + s125*w_y)
        s317 = -tz*(-R_23*w_z_t + R_33*w_y_t - s119*w_z + s128*w_y)
        s318 = s316 + s317 - tx*(-R_21*w_z_t + R_31*w_y_t - s113*w_z + s122*w_y) + v_px_t
        s321 = -ty*(R_12*w_z_t - R_32*w_x_t + s107*w_z - s125*w_x)
        s322 = -tz*(R_13*w_z_t - R_33*w_x_t + s110*w_z - s128*w_x)
        s323 = s321 + s322 - tx*(R_11*w_z_t - R_31*w_x_t + s104*w_z - s122*w_x) + v_py_t
        s326 = -ty*(-R_12*w_y_t + R_22*w_x_t - s107*w_y + s116*w_x)
        s327 = -tz*(-R_13*w_y_t + R_23*w_x_t - s110*w_y + s119*w_x)
        s328 = s326 + s327 - tx*(-R_11*w_y_t + R_21*w_x_t - s104*w_y + s113*w_x) + v_pz_t
        s432 = gx - 0.001*s318
        s434 = gy - 0.001*s323
        s436 = gz - 0.001*s328
        s438 = gx - 0.001*v_px_t
        s440 = gy - 0.001*v_py_t
        s442 = gz - 0.001*v_pz_t
        s[1536 + lane] = s432
        s[1568 + lane] = s434
        s[1600 + lane] = s436
        s[1632 + lane] = s438
        s[1664 + lane] = s440
        s[1696 + lane] = s442


@straight
def _platform_asks(w, d, s, n):
    """Loads per inertial parameter of a platform, along joint, shifts and turns (51 operations)."""
    for lane in range(n):
        tx = w[32 + lane]
        ty = w[64 + lane]
        tz = w[96 + lane]
        R_11 = w[320 + lane]
        R_12 = w[352 + lane]
        R_13 = w[384 + lane]
        R_21 = w[416 + lane]
        R_22 = w[448 + lane]
        R_23 = w[480 + lane]
        R_31 = w[512 + lane]
        R_32 = w[544 + lane]
        R_33 = w[576 + lane]
        f0x = s[1536 + lane]
        f0y = s[1568 + lane]
        f0z = s[1600 + lane]
        f1x = s[1632 + lane]
        f1y = s[1664 + lane]
        f1z = s[1696 + lane]
        s56 = -f0z*tz
        s58 = -f0z*ty
        s60 = -f0z*tx
        s62 = -f0y*tz
        s64 = -f0y*ty
        s66 = -f0y*tx
        s68 = -f0x*tz
        s70 = -f0x*ty
        s72 = -f0x*tx
        s83 = R_21*s60 + R_22*s58 + R_23*s56 - R_31*s66 - R_32*s64 - R_33*s62
        s90 = -R_11*s60 - R_12*s58 - R_13*s56 + R_31*s72 + R_32*s70 + R_33*s68
        s97 = R_11*s66 + R_12*s64 + R_13*s62 - R_21*s72 - R_22*s70 - R_23*s68
        s[1728 + lane] = f0x
        s[1760 + lane] = f0y
        s[1792 + lane] = f0z
        s[1824 + lane] = s83
        s[1856 + lane] = s90
        s[1888 + lane] = s97
        s[1920 + lane] = f1x
        s[1952 + lane] = f1y
        s[1984 + lane] = f1z


@straight
def _give(d, s, inertia, n):
    """What the joints give (360 operations)."""
    m_0 = inertia[0]
    m_1 = inertia[1]
    m_2 = inertia[2]
    m_3 = inertia[3]
    m_4 = inertia[4]
    m_5 = inertia[5]
    m_6 = inertia[6]
    m_7 = inertia[7]
    m_8 = inertia[8]
    m_9 = inertia[9]
    m_10 = inertia[10]
    m_11 = inertia[11]
    m_12 = inertia[12]
    m_13 = inertia[13]
    m_14 = inertia[14]
    m_15 = inertia[15]
    m_16 = inertia[16]
    m_17 = inertia[17]
    m_18 = inertia[18]
    m_19 = inertia[19]
    for lane in range(n):
        a_0_0 = d[576 + lane]
        a_0_1 = d[608 + lane]
        a_0_2 = d[640 + lane]
        a_0_3 = d[672 + lane]
        a_0_4 = d[704 + lane]
        a_0_5 = d[736 + lane]
        a_0_6 = d[768 + lane]
        a_0_7 = d[800 + lane]
        a_0_8 = d[832 + lane]
        a_0_9 = d[864 + lane]
        a_0_10 = d[896 + lane]
        a_0_11 = d[928 + lane]
        a_0_12 = d[960 + lane]
        a_0_13 = d[992 + lane]
        a_0_14 = d[1024 + lane]
        a_0_15 = d[1056 + lane]
        a_0_16 = d[1088 + lane]
        a_0_17 = d[1120 + lane]
        a_0_18 = d[1152 + lane]
        a_0_19 = d[1184 + lane]
        a_0_20 = d[1216 + lane]
        a_1_0 = d[1824 + lane]
        a_1_1 = d[1856 + lane]
        a_1_2 = d[1888 + lane]
        a_1_3 = d[1920 + lane]
        a_1_4 = d[1952 + lane]
        a_1_5 = d[1984 + lane]
        a_1_6 = d[2016 + lane]
        a_1_7 = d[2048 + lane]
        a_1_8 = d[2080 + lane]
        a_1_9 = d[2112 + lane]
        a_1_10 = d[2144 + lane]
        a_1_11 = d[2176 + lane]
        a_1_12 = d[2208 + lane]
        a_1_13 = d[2240 + lane]
        a_1_14 = d[2272 + lane]
        a_1_15 = d[2304 + lane]
        a_1_16 = d[2336 + lane]
        a_1_17 = d[2368 + lane]
        a_1_18 = d[2400 + lane]
        a_1_19 = d[2432 + lane]
        a_1_20 = d[2464 + lane]
        a_2_0 = d[3072 + lane]
        a_2_1 = d[3104 + lane]
        a_2_2 = d[3136 + lane]
        a_2_3 = d[3168 + lane]
        a_2_4 = d[3200 + lane]
        a_2_5 = d[3232 + lane]
        a_2_6 = d[3264 + lane]
        a_2_7 = d[3296 + lane]
        a_2_8 = d[3328 + lane]
        a_2_9 = d[3360 + lane]
        a_2_10 = d[3392 + lane]
        a_2_11 = d[3424 + lane]
        a_2_12 = d[3456 + lane]
        a_2_13 = d[3488 + lane]
        a_2_14 = d[3520 + lane]
        a_2_15 = d[3552 + lane]
        a_2_16 = d[3584 + lane]
        a_2_17 = d[3616 + lane]
        a_2_18 = d[3648 + lane]
        a_2_19 = d[3680 + lane]
        a_2_20 = d[3712 + lane]
        a_3_0 = d[4320 + lane]
        a_3_1 = d[4352 + lane]
        a_3_2 = d[4384 + lane]
        a_3_3 = d[4416 + lane]
        a_3_4 = d[4448 + lane]
        a_3_5 = d[4480 + lane]
        a_3_6 = d[4512 + lane]
        a_3_7 = d[4544 + lane]
        a_3_8 = d[4576 + lane]
        a_3_9 = d[4608 + lane]
        a_3_10 = d[4640 + lane]
        a_3_11 = d[4672 + lane]
        a_3_12 = d[4704 + lane]
        a_3_13 = d[4736 + lane]
        a_3_14 = d[4768 + lane]
        a_3_15 = d[4800 + lane]
        a_3_16 = d[4832 + lane]
        a_3_17 = d[4864 + lane]
        a_3_18 = d[4896 + lane]
        a_3_19 = d[4928 + lane]
        a_3_20 = d[4960 + lane]
        a_4_0 = d[5568 + lane]
        a_4_1 = d[5600 + lane]
        a_4_2 = d[5632 + lane]
        a_4_3 = d[5664 + lane]
        a_4_4 = d[5696 + lane]
        a_4_5 = d[5728 + lane]
        a_4_6 = d[5760 + lane]
        a_4_7 = d[5792 + lane]
        a_4_8 = d[5824 + lane]
        a_4_9 = d[5856 + lane]
        a_4_10 = d[5888 + lane]
        a_4_11 = d[5920 + lane]
        a_4_12 = d[5952 + lane]
        a_4_13 = d[5984 + lane]
        a_4_14 = d[6016 + lane]
        a_4_15 = d[6048 + lane]
        a_4_16 = d[6080 + lane]
        a_4_17 = d[6112 + lane]
        a_4_18 = d[6144 + lane]
        a_4_19 = d[6176 + lane]
        a_4_20 = d[6208 + lane]
        a_5_0 = d[6816 + lane]
        a_5_1 = d[6848 + lane]
        a_5_2 = d[6880 + lane]
        a_5_3 = d[6912 + lane]
        a_5_4 = d[6944 + lane]
        a_5_5 = d[6976 + lane]
        a_5_6 = d[7008 + lane]
        a_5_7 = d[7040 + lane]
        a_5_8 = d[7072 + lane]
        a_5_9 = d[7104 + lane]
        a_5_10 = d[7136 + lane]
        a_5_11 = d[7168 + lane]
        a_5_12 = d[7200 + lane]
        a_5_13 = d[7232 + lane]
        a_5_14 = d[7264 + lane]
        a_5_15 = d[7296 + lane]
        a_5_16 = d[7328 + lane]
        a_5_17 = d[7360 + lane]
        a_5_18 = d[7392 + lane]
        a_5_19 = d[7424 + lane]
        a_5_20 = d[7456 + lane]
        a_p_0 = s[1728 + lane]
        a_p_1 = s[1760 + lane]
        a_p_2 = s[1792 + lane]
        a_p_3 = s[1824 + lane]
        a_p_4 = s[1856 + lane]
        a_p_5 = s[1888 + lane]
        a_p_6 = s[1920 + lane]
        a_p_7 = s[1952 + lane]
        a_p_8 = s[1984 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_0_3 = s[96 + lane]
        V_0_4 = s[128 + lane]
        V_0_5 = s[160 + lane]
        V_1_0 = s[192 + lane]
        V_1_1 = s[224 + lane]
        V_1_2 = s[256 + lane]
        V_1_3 = s[288 + lane]
        V_1_4 = s[320 + lane]
        V_1_5 = s[352 + lane]
        V_2_0 = s[384 + lane]
        V_2_1 = s[416 + lane]
        V_2_2 = s[448 + lane]
        V_2_3 = s[480 + lane]
        V_2_4 = s[512 + lane]
        V_2_5 = s[544 + lane]
        V_3_0 = s[576 + lane]
        V_3_1 = s[608 + lane]
        V_3_2 = s[640 + lane]
        V_3_3 = s[672 + lane]
        V_3_4 = s[704 + lane]
        V_3_5 = s[736 + lane]
        V_4_0 = s[768 + lane]
        V_4_1 = s[800 + lane]
        V_4_2 = s[832 + lane]
        V_4_3 = s[864 + lane]
        V_4_4 = s[896 + lane]
        V_4_5 = s[928 + lane]
        V_5_0 = s[960 + lane]
        V_5_1 = s[992 + lane]
        V_5_2 = s[1024 + lane]
        V_5_3 = s[1056 + lane]
        V_5_4 = s[1088 + lane]
        V_5_5 = s[1120 + lane]
        s0 = a_0_1*m_0
        s1 = a_0_15*m_2
        s2 = a_0_8*m_1
        s3 = a_1_1*m_3
        s4 = a_1_15*m_5
        s5 = a_1_8*m_4
        s6 = a_2_1*m_6
        s7 = a_2_15*m_8
        s8 = a_2_8*m_7
        s9 = a_3_1*m_9
        s10 = a_3_15*m_11
        s11 = a_3_8*m_10
        s12 = a_4_1*m_12
        s13 = a_4_15*m_14
        s14 = a_4_8*m_13
        s15 = a_5_1*m_15
        s16 = a_5_15*m_17
        s17 = a_5_8*m_16
        s18 = a_p_0*m_18
        s19 = a_p_6*m_19
        W_0 = s0 + s1 + s10 + s11 + s12 + s13 + s14 + s15 + s16 + s17 + s18 + s19 + s2 + s3 + s4 + s5 + s6 + s7 + s8 + s9
        s21 = a_0_16*m_2
        s22 = a_0_2*m_0
        s23 = a_0_9*m_1
        s24 = a_1_16*m_5
        s25 = a_1_2*m_3
        s26 = a_1_9*m_4
        s27 = a_2_16*m_8
        s28 = a_2_2*m_6
        s29 = a_2_9*m_7
        s30 = a_3_16*m_11
        s31 = a_3_2*m_9
        s32 = a_3_9*m_10
        s33 = a_4_16*m_14
        s34 = a_4_2*m_12
        s35 = a_4_9*m_13
        s36 = a_5_16*m_17
        s37 = a_5_2*m_15
        s38 = a_5_9*m_16
        s39 = a_p_1*m_18
        s40 = a_p_7*m_19
        W_1 = s21 + s22 + s23 + s24 + s25 + s26 + s27 + s28 + s29 + s30 + s31 + s32 + s33 + s34 + s35 + s36 + s37 + s38 + s39 + s40
        s42 = a_0_10*m_1
        s43 = a_0_17*m_2
        s44 = a_0_3*m_0
        s45 = a_1_10*m_4
        s46 = a_1_17*m_5
        s47 = a_1_3*m_3
        s48 = a_2_10*m_7
        s49 = a_2_17*m_8
        s50 = a_2_3*m_6
        s51 = a_3_10*m_10
        s52 = a_3_17*m_11
        s53 = a_3_3*m_9
        s54 = a_4_10*m_13
        s55 = a_4_17*m_14
        s56 = a_4_3*m_12
        s57 = a_5_10*m_16
        s58 = a_5_17*m_17
        s59 = a_5_3*m_15
        s60 = a_p_2*m_18
        s61 = a_p_8*m_19
        W_2 = s42 + s43 + s44 + s45 + s46 + s47 + s48 + s49 + s50 + s51 + s52 + s53 + s54 + s55 + s56 + s57 + s58 + s59 + s60 + s61
        s63 = a_0_11*m_1
        s64 = a_0_18*m_2
        s65 = a_0_4*m_0
        s66 = a_1_11*m_4
        s67 = a_1_18*m_5
        s68 = a_1_4*m_3
        s69 = a_2_11*m_7
        s70 = a_2_18*m_8
        s71 = a_2_4*m_6
        s72 = a_3_11*m_10
        s73 = a_3_18*m_11
        s74 = a_3_4*m_9
        s75 = a_4_11*m_13
        s76 = a_4_18*m_14
        s77 = a_4_4*m_12
        s78 = a_5_11*m_16
        s79 = a_5_18*m_17
        s80 = a_5_4*m_15
        s81 = a_p_3*m_18
        W_3 = s63 + s64 + s65 + s66 + s67 + s68 + s69 + s70 + s71 + s72 + s73 + s74 + s75 + s76 + s77 + s78 + s79 + s80 + s81
        s83 = a_0_12*m_1
        s84 = a_0_19*m_2
        s85 = a_0_5*m_0
        s86 = a_1_12*m_4
        s87 = a_1_19*m_5
        s88 = a_1_5*m_3
        s89 = a_2_12*m_7
        s90 = a_2_19*m_8
        s91 = a_2_5*m_6
        s92 = a_3_12*m_10
        s93 = a_3_19*m_11
        s94 = a_3_5*m_9
        s95 = a_4_12*m_13
        s96 = a_4_19*m_14
        s97 = a_4_5*m_12
        s98 = a_5_12*m_16
        s99 = a_5_19*m_17
        s100 = a_5_5*m_15
        s101 = a_p_4*m_18
        W_4 = s100 + s101 + s83 + s84 + s85 + s86 + s87 + s88 + s89 + s90 + s91 + s92 + s93 + s94 + s95 + s96 + s97 + s98 + s99
        s103 = a_0_13*m_1
        s104 = a_0_20*m_2
        s105 = a_0_6*m_0
        s106 = a_1_13*m_4
        s107 = a_1_20*m_5
        s108 = a_1_6*m_3
        s109 = a_2_13*m_7
        s110 = a_2_20*m_8
        s111 = a_2_6*m_6
        s112 = a_3_13*m_10
        s113 = a_3_20*m_11
        s114 = a_3_6*m_9
        s115 = a_4_13*m_13
        s116 = a_4_20*m_14
        s117 = a_4_6*m_12
        s118 = a_5_13*m_16
        s119 = a_5_20*m_17
        s120 = a_5_6*m_15
        s121 = a_p_5*m_18
        W_5 = s103 + s104 + s105 + s106 + s107 + s108 + s109 + s110 + s111 + s112 + s113 + s114 + s115 + s116 + s117 + s118 + s119 + s120 + s121
        s127 = -V_4_0*W_4
        s128 = -V_5_0*W_5
        s129 = -a_0_0*m_0
        s130 = -a_0_14*m_2
        s131 = -a_0_7*m_1
        s132 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - V_3_0*W_3 + s127 + s128 + s129 + s130 + s131
        s137 = -V_4_1*W_4
        s138 = -V_5_1*W_5
        s139 = -a_1_0*m_3
        s140 = -a_1_14*m_5
        s141 = -a_1_7*m_4
        s142 = -V_0_1*W_0 - V_1_1*W_1 - V_2_1*W_2 - V_3_1*W_3 + s137 + s138 + s139 + s140 + s141
        s147 = -V_4_2*W_4
        s148 = -V_5_2*W_5
        s149 = -a_2_0*m_6
        s150 = -a_2_14*m_8
        s151 = -a_2_7*m_7
        s152 = -V_0_2*W_0 - V_1_2*W_1 - V_2_2*W_2 - V_3_2*W_3 + s147 + s148 + s149 + s150 + s151
        s157 = -V_4_3*W_4
        s158 = -V_5_3*W_5
        s159 = -a_3_0*m_9
        s160 = -a_3_14*m_11
        s161 = -a_3_7*m_10
        s162 = -V_0_3*W_0 - V_1_3*W_1 - V_2_3*W_2 - V_3_3*W_3 + s157 + s158 + s159 + s160 + s161
        s167 = -V_4_4*W_4
        s168 = -V_5_4*W_5
        s169 = -a_4_0*m_12
        s170 = -a_4_14*m_14
        s171 = -a_4_7*m_13
        s172 = -V_0_4*W_0 - V_1_4*W_1 - V_2_4*W_2 - V_3_4*W_3 + s167 + s168 + s169 + s170 + s171
        s177 = -V_4_5*W_4
        s178 = -V_5_5*W_5
        s179 = -a_5_0*m_15
        s180 = -a_5_14*m_17
        s181 = -a_5_7*m_16
        s182 = -V_0_5*W_0 - V_1_5*W_1 - V_2_5*W_2 - V_3_5*W_3 + s177 + s178 + s179 + s180 + s181
        s[2016 + lane] = s132
        s[2048 + lane] = s142
        s[2080 + lane] = s152
        s[2112 + lane] = s162
        s[2144 + lane] = s172
        s[2176 + lane] = s182


@straight
def _give_each(d, s, n):
    """What the joints give for each inertial parameter (1386 operations)."""
    for lane in range(n):
        a_0_0 = d[576 + lane]
        a_0_1 = d[608 + lane]
        a_0_2 = d[640 + lane]
        a_0_3 = d[672 + lane]
        a_0_4 = d[704 + lane]
        a_0_5 = d[736 + lane]
        a_0_6 = d[768 + lane]
        a_0_7 = d[800 + lane]
        a_0_8 = d[832 + lane]
        a_0_9 = d[864 + lane]
        a_0_10 = d[896 + lane]
        a_0_11 = d[928 + lane]
        a_0_12 = d[960 + lane]
        a_0_13 = d[992 + lane]
        a_0_14 = d[1024 + lane]
        a_0_15 = d[1056 + lane]
        a_0_16 = d[1088 + lane]
        a_0_17 = d[1120 + lane]
        a_0_18 = d[1152 + lane]
        a_0_19 = d[1184 + lane]
        a_0_20 = d[1216 + lane]
        a_1_0 = d[1824 + lane]
        a_1_1 = d[1856 + lane]
        a_1_2 = d[1888 + lane]
        a_1_3 = d[1920 + lane]
        a_1_4 = d[1952 + lane]
        a_1_5 = d[1984 + lane]
        a_1_6 = d[2016 + lane]
        a_1_7 = d[2048 + lane]
        a_1_8 = d[2080 + lane]
        a_1_9 = d[2112 + lane]
        a_1_10 = d[2144 + lane]
        a_1_11 = d[2176 + lane]
        a_1_12 = d[2208 + lane]
        a_1_13 = d[2240 + lane]
        a_1_14 = d[2272 + lane]
        a_1_15 = d[2304 + lane]
        a_1_16 = d[2336 + lane]
        a_1_17 = d[2368 + lane]
        a_1_18 = d[2400 + lane]
        a_1_19 = d[2432 + lane]
        a_1_20 = d[2464 + lane]
        a_2_0 = d[3072 + lane]
        a_2_1 = d[3104 + lane]
        a_2_2 = d[3136 + lane]
        a_2_3 = d[3168 + lane]
        a_2_4 = d[3200 + lane]
        a_2_5 = d[3232 + lane]
        a_2_6 = d[3264 + lane]
        a_2_7 = d[3296 + lane]
        a_2_8 = d[3328 + lane]
        a_2_9 = d[3360 + lane]
        a_2_10 = d[3392 + lane]
        a_2_11 = d[3424 + lane]
        a_2_12 = d[3456 + lane]
        a_2_13 = d[3488 + lane]
        a_2_14 = d[3520 + lane]
        a_2_15 = d[3552 + lane]
        a_2_16 = d[3584 + lane]
        a_2_17 = d[3616 + lane]
        a_2_18 = d[3648 + lane]
        a_2_19 = d[3680 + lane]
        a_2_20 = d[3712 + lane]
        a_3_0 = d[4320 + lane]
        a_3_1 = d[4352 + lane]
        a_3_2 = d[4384 + lane]
        a_3_3 = d[4416 + lane]
        a_3_4 = d[4448 + lane]
        a_3_5 = d[4480 + lane]
        a_3_6 = d[4512 + lane]
        a_3_7 = d[4544 + lane]
        a_3_8 = d[4576 + lane]
        a_3_9 = d[4608 + lane]
        a_3_10 = d[4640 + lane]
        a_3_11 = d[4672 + lane]
        a_3_12 = d[4704 + lane]
        a_3_13 = d[4736 + lane]
        a_3_14 = d[4768 + lane]
        a_3_15 = d[4800 + lane]
        a_3_16 = d[4832 + lane]
        a_3_17 = d[4864 + lane]
        a_3_18 = d[4896 + lane]
        a_3_19 = d[4928 + lane]
        a_3_20 = d[4960 + lane]
        a_4_0 = d[5568 + lane]
        a_4_1 = d[5600 + lane]
        a_4_2 = d[5632 + lane]
        a_4_3 = d[5664 + lane]
        a_4_4 = d[5696 + lane]
        a_4_5 = d[5728 + lane]
        a_4_6 = d[5760 + lane]
        a_4_7 = d[5792 + lane]
        a_4_8 = d[5824 + lane]
        a_4_9 = d[5856 + lane]
        a_4_10 = d[5888 + lane]
        a_4_11 = d[5920 + lane]
        a_4_12 = d[5952 + lane]
        a_4_13 = d[5984 + lane]
        a_4_14 = d[6016 + lane]
        a_4_15 = d[6048 + lane]
        a_4_16 = d[6080 + lane]
        a_4_17 = d[6112 + lane]
        a_4_18 = d[6144 + lane]
        a_4_19 = d[6176 + lane]
        a_4_20 = d[6208 + lane]
        a_5_0 = d[6816 + lane]
        a_5_1 = d[6848 + lane]
        a_5_2 = d[6880 + lane]
        a_5_3 = d[6912 + lane]
        a_5_4 = d[6944 + lane]
        a_5_5 = d[6976 + lane]
        a_5_6 = d[7008 + lane]
        a_5_7 = d[7040 + lane]
        a_5_8 = d[7072 + lane]
        a_5_9 = d[7104 + lane]
        a_5_10 = d[7136 + lane]
        a_5_11 = d[7168 + lane]
        a_5_12 = d[7200 + lane]
        a_5_13 = d[7232 + lane]
        a_5_14 = d[7264 + lane]
        a_5_15 = d[7296 + lane]
        a_5_16 = d[7328 + lane]
        a_5_17 = d[7360 + lane]
        a_5_18 = d[7392 + lane]
        a_5_19 = d[7424 + lane]
        a_5_20 = d[7456 + lane]
        a_p_0 = s[1728 + lane]
        a_p_1 = s[1760 + lane]
        a_p_2 = s[1792 + lane]
        a_p_3 = s[1824 + lane]
        a_p_4 = s[1856 + lane]
        a_p_5 = s[1888 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_0_3 = s[96 + lane]
        V_0_4 = s[128 + lane]
        V_0_5 = s[160 + lane]
        V_1_0 = s[192 + lane]
        V_1_1 = s[224 + lane]
        V_1_2 = s[256 + lane]
        V_1_3 = s[288 + lane]
        V_1_4 = s[320 + lane]
        V_1_5 = s[352 + lane]
        V_2_0 = s[384 + lane]
        V_2_1 = s[416 + lane]
        V_2_2 = s[448 + lane]
        V_2_3 = s[480 + lane]
        V_2_4 = s[512 + lane]
        V_2_5 = s[544 + lane]
        V_3_0 = s[576 + lane]
        V_3_1 = s[608 + lane]
        V_3_2 = s[640 + lane]
        V_3_3 = s[672 + lane]
        V_3_4 = s[704 + lane]
        V_3_5 = s[736 + lane]
        V_4_0 = s[768 + lane]
        V_4_1 = s[800 + lane]
        V_4_2 = s[832 + lane]
        V_4_3 = s[864 + lane]
        V_4_4 = s[896 + lane]
        V_4_5 = s[928 + lane]
        V_5_0 = s[960 + lane]
        V_5_1 = s[992 + lane]
        V_5_2 = s[1024 + lane]
        V_5_3 = s[1056 + lane]
        V_5_4 = s[1088 + lane]
        V_5_5 = s[1120 + lane]
        s5 = -V_5_0*a_0_6
        s6 = -V_0_0*a_0_1 - V_1_0*a_0_2 - V_2_0*a_0_3 - V_3_0*a_0_4 - V_4_0*a_0_5 - a_0_0 + s5
        s13 = -V_0_1*a_0_1 - V_1_1*a_0_2 - V_2_1*a_0_3 - V_3_1*a_0_4 - V_4_1*a_0_5 - V_5_1*a_0_6
        s20 = -V_0_2*a_0_1 - V_1_2*a_0_2 - V_2_2*a_0_3 - V_3_2*a_0_4 - V_4_2*a_0_5 - V_5_2*a_0_6
        s27 = -V_0_3*a_0_1 - V_1_3*a_0_2 - V_2_3*a_0_3 - V_3_3*a_0_4 - V_4_3*a_0_5 - V_5_3*a_0_6
        s34 = -V_0_4*a_0_1 - V_1_4*a_0_2 - V_2_4*a_0_3 - V_3_4*a_0_4 - V_4_4*a_0_5 - V_5_4*a_0_6
        s41 = -V_0_5*a_0_1 - V_1_5*a_0_2 - V_2_5*a_0_3 - V_3_5*a_0_4 - V_4_5*a_0_5 - V_5_5*a_0_6
        s47 = -V_5_0*a_0_13
        s48 = -V_0_0*a_0_8 - V_1_0*a_0_9 - V_2_0*a_0_10 - V_3_0*a_0_11 - V_4_0*a_0_12 - a_0_7 + s47
        s55 = -V_0_1*a_0_8 - V_1_1*a_0_9 - V_2_1*a_0_10 - V_3_1*a_0_11 - V_4_1*a_0_12 - V_5_1*a_0_13
        s62 = -V_0_2*a_0_8 - V_1_2*a_0_9 - V_2_2*a_0_10 - V_3_2*a_0_11 - V_4_2*a_0_12 - V_5_2*a_0_13
        s69 = -V_0_3*a_0_8 - V_1_3*a_0_9 - V_2_3*a_0_10 - V_3_3*a_0_11 - V_4_3*a_0_12 - V_5_3*a_0_13
        s76 = -V_0_4*a_0_8 - V_1_4*a_0_9 - V_2_4*a_0_10 - V_3_4*a_0_11 - V_4_4*a_0_12 - V_5_4*a_0_13
        s83 = -V_0_5*a_0_8 - V_1_5*a_0_9 - V_2_5*a_0_10 - V_3_5*a_0_11 - V_4_5*a_0_12 - V_5_5*a_0_13
        s89 = -V_5_0*a_0_20
        s90 = -V_0_0*a_0_15 - V_1_0*a_0_16 - V_2_0*a_0_17 - V_3_0*a_0_18 - V_4_0*a_0_19 - a_0_14 + s89
        s97 = -V_0_1*a_0_15 - V_1_1*a_0_16 - V_2_1*a_0_17 - V_3_1*a_0_18 - V_4_1*a_0_19 - V_5_1*a_0_20
        s104 = -V_0_2*a_0_15 - V_1_2*a_0_16 - V_2_2*a_0_17 - V_3_2*a_0_18 - V_4_2*a_0_19 - V_5_2*a_0_20
        s111 = -V_0_3*a_0_15 - V_1_3*a_0_16 - V_2_3*a_0_17 - V_3_3*a_0_18 - V_4_3*a_0_19 - V_5_3*a_0_20
        s118 = -V_0_4*a_0_15 - V_1_4*a_0_16 - V_2_4*a_0_17 - V_3_4*a_0_18 - V_4_4*a_0_19 - V_5_4*a_0_20
        s125 = -V_0_5*a_0_15 - V_1_5*a_0_16 - V_2_5*a_0_17 - V_3_5*a_0_18 - V_4_5*a_0_19 - V_5_5*a_0_20
        s132 = -V_0_0*a_1_1 - V_1_0*a_1_2 - V_2_0*a_1_3 - V_3_0*a_1_4 - V_4_0*a_1_5 - V_5_0*a_1_6
        s138 = -V_5_1*a_1_6
        s139 = -V_0_1*a_1_1 - V_1_1*a_1_2 - V_2_1*a_1_3 - V_3_1*a_1_4 - V_4_1*a_1_5 - a_1_0 + s138
        s146 = -V_0_2*a_1_1 - V_1_2*a_1_2 - V_2_2*a_1_3 - V_3_2*a_1_4 - V_4_2*a_1_5 - V_5_2*a_1_6
        s153 = -V_0_3*a_1_1 - V_1_3*a_1_2 - V_2_3*a_1_3 - V_3_3*a_1_4 - V_4_3*a_1_5 - V_5_3*a_1_6
        s160 = -V_0_4*a_1_1 - V_1_4*a_1_2 - V_2_4*a_1_3 - V_3_4*a_1_4 - V_4_4*a_1_5 - V_5_4*a_1_6
        s167 = -V_0_5*a_1_1 - V_1_5*a_1_2 - V_2_5*a_1_3 - V_3_5*a_1_4 - V_4_5*a_1_5 - V_5_5*a_1_6
        s174 = -V_0_0*a_1_8 - V_1_0*a_1_9 - V_2_0*a_1_10 - V_3_0*a_1_11 - V_4_0*a_1_12 - V_5_0*a_1_13
        s180 = -V_5_1*a_1_13
        s181 = -V_0_1*a_1_8 - V_1_1*a_1_9 - V_2_1*a_1_10 - V_3_1*a_1_11 - V_4_1*a_1_12 - a_1_7 + s180
        s188 = -V_0_2*a_1_8 - V_1_2*a_1_9 - V_2_2*a_1_10 - V_3_2*a_1_11 - V_4_2*a_1_12 - V_5_2*a_1_13
        s195 = -V_0_3*a_1_8 - V_1_3*a_1_9 - V_2_3*a_1_10 - V_3_3*a_1_11 - V_4_3*a_1_12 - V_5_3*a_1_13
        s202 = -V_0_4*a_1_8 - V_1_4*a_1_9 - V_2_4*a_1_10 - V_3_4*a_1_11 - V_4_4*a_1_12 - V_5_4*a_1_13
        s209 = -V_0_5*a_1_8 - V_1_5*a_1_9 - V_2_5*a_1_10 - V_3_5*a_1_11 - V_4_5*a_1_12 - V_5_5*a_1_13
        s216 = -V_0_0*a_1_15 - V_1_0*a_1_16 - V_2_0*a_1_17 - V_3_0*a_1_18 - V_4_0*a_1_19 - V_5_0*a_1_20
        s222 = -V_5_1*a_1_20
        s223 = -V_0_1*a_1_15 - V_1_1*a_1_16 - V_2_1*a_1_17 - V_3_1*a_1_18 - V_4_1*a_1_19 - a_1_14 + s222
        s230 = -V_0_2*a_1_15 - V_1_2*a_1_16 - V_2_2*a_1_17 - V_3_2*a_1_18 - V_4_2*a_1_19 - V_5_2*a_1_20
        s237 = -V_0_3*a_1_15 - V_1_3*a_1_16 - V_2_3*a_1_17 - V_3_3*a_1_18 - V_4_3*a_1_19 - V_5_3*a_1_20
        s244 = -V_0_4*a_1_15 - V_1_4*a_1_16 - V_2_4*a_1_17 - V_3_4*a_1_18 - V_4_4*a_1_19 - V_5_4*a_1_20
        s251 = -V_0_5*a_1_15 - V_1_5*a_1_16 - V_2_5*a_1_17 - V_3_5*a_1_18 - V_4_5*a_1_19 - V_5_5*a_1_20
        s258 = -V_0_0*a_2_1 - V_1_0*a_2_2 - V_2_0*a_2_3 - V_3_0*a_2_4 - V_4_0*a_2_5 - V_5_0*a_2_6
        s265 = -V_0_1*a_2_1 - V_1_1*a_2_2 - V_2_1*a_2_3 - V_3_1*a_2_4 - V_4_1*a_2_5 - V_5_1*a_2_6
        s271 = -V_5_2*a_2_6
        s272 = -V_0_2*a_2_1 - V_1_2*a_2_2 - V_2_2*a_2_3 - V_3_2*a_2_4 - V_4_2*a_2_5 - a_2_0 + s271
        s279 = -V_0_3*a_2_1 - V_1_3*a_2_2 - V_2_3*a_2_3 - V_3_3*a_2_4 - V_4_3*a_2_5 - V_5_3*a_2_6
        s286 = -V_0_4*a_2_1 - V_1_4*a_2_2 - V_2_4*a_2_3 - V_3_4*a_2_4 - V_4_4*a_2_5 - V_5_4*a_2_6
        s293 = -V_0_5*a_2_1 - V_1_5*a_2_2 - V_2_5*a_2_3 - V_3_5*a_2_4 - V_4_5*a_2_5 - V_5_5*a_2_6
        s300 = -V_0_0*a_2_8 - V_1_0*a_2_9 - V_2_0*a_2_10 - V_3_0*a_2_11 - V_4_0*a_2_12 - V_5_0*a_2_13
        s307 = -V_0_1*a_2_8 - V_1_1*a_2_9 - V_2_1*a_2_10 - V_3_1*a_2_11 - V_4_1*a_2_12 - V_5_1*a_2_13
        s313 = -V_5_2*a_2_13
        s314 = -V_0_2*a_2_8 - V_1_2*a_2_9 - V_2_2*a_2_10 - V_3_2*a_2_11 - V_4_2*a_2_12 - a_2_7 + s313
        s321 = -V_0_3*a_2_8 - V_1_3*a_2_9 - V_2_3*a_2_10 - V_3_3*a_2_11 - V_4_3*a_2_12 - V_5_3*a_2_13
        s328 = -V_0_4*a_2_8 - V_1_4*a_2_9 - V_2_4*a_2_10 - V_3_4*a_2_11 - V_4_4*a_2_12 - V_5_4*a_2_13
        s335 = -V_0_5*a_2_8 - V_1_5*a_2_9 - V_2_5*a_2_10 - V_3_5*a_2_11 - V_4_5*a_2_12 - V_5_5*a_2_13
        s342 = -V_0_0*a_2_15 - V_1_0*a_2_16 - V_2_0*a_2_17 - V_3_0*a_2_18 - V_4_0*a_2_19 - V_5_0*a_2_20
        s349 = -V_0_1*a_2_15 - V_1_1*a_2_16 - V_2_1*a_2_17 - V_3_1*a_2_18 - V_4_1*a_2_19 - V_5_1*a_2_20
        s355 = -V_5_2*a_2_20
        s356 = -V_0_2*a_2_15 - V_1_2*a_2_16 - V_2_2*a_2_17 - V_3_2*a_2_18 - V_4_2*a_2_19 - a_2_14 + s355
        s363 = -V_0_3*a_2_15 - V_1_3*a_2_16 - V_2_3*a_2_17 - V_3_3*a_2_18 - V_4_3*a_2_19 - V_5_3*a_2_20
        s370 = -V_0_4*a_2_15 - V_1_4*a_2_16 - V_2_4*a_2_17 - V_3_4*a_2_18 - V_4_4*a_2_19 - V_5_4*a_2_20
        s377 = -V_0_5*a_2_15 - V_1_5*a_2_16 - V_2_5*a_2_17 - V_3_5*a_2_18 - V_4_5*a_2_19 - V_5_5*a_2_20
        s384 = -V_0_0*a_3_1 - V_1_0*a_3_2 - V_2_0*a_3_3 - V_3_0*a_3_4 - V_4_0*a_3_5 - V_5_0*a_3_6
        s391 = -V_0_1*a_3_1 - V_1_1*a_3_2 - V_2_1*a_3_3 - V_3_1*a_3_4 - V_4_1*a_3_5 - V_5_1*a_3_6
        s398 = -V_0_2*a_3_1 - V_1_2*a_3_2 - V_2_2*a_3_3 - V_3_2*a_3_4 - V_4_2*a_3_5 - V_5_2*a_3_6
        s404 = -V_5_3*a_3_6
        s405 = -V_0_3*a_3_1 - V_1_3*a_3_2 - V_2_3*a_3_3 - V_3_3*a_3_4 - V_4_3*a_3_5 - a_3_0 + s404
        s412 = -V_0_4*a_3_1 - V_1_4*a_3_2 - V_2_4*a_3_3 - V_3_4*a_3_4 - V_4_4*a_3_5 - V_5_4*a_3_6
        s419 = -V_0_5*a_3_1 - V_1_5*a_3_2 - V_2_5*a_3_3 - V_3_5*a_3_4 - V_4_5*a_3_5 - V_5_5*a_3_6
        s426 = -V_0_0*a_3_8 - V_1_0*a_3_9 - V_2_0*a_3_10 - V_3_0*a_3_11 - V_4_0*a_3_12 - V_5_0*a_3_13
        s433 = -V_0_1*a_3_8 - V_1_1*a_3_9 - V_2_1*a_3_10 - V_3_1*a_3_11 - V_4_1*a_3_12 - V_5_1*a_3_13
        s440 = -V_0_2*a_3_8 - V_1_2*a_3_9 - V_2_2*a_3_10 - V_3_2*a_3_11 - V_4_2*a_3_12 - V_5_2*a_3_13
        s446 = -V_5_3*a_3_13
        s447 = -V_0_3*a_3_8 - V_1_3*a_3_9 - V_2_3*a_3_10 - V_3_3*a_3_11 - V_4_3*a_3_12 - a_3_7 + s446
        s454 = -V_0_4*a_3_8 - V_1_4*a_3_9 - V_2_4*a_3_10 - V_3_4*a_3_11 - V_4_4*a_3_12 - V_5_4*a_3_13
        s461 = -V_0_5*a_3_8 - V_1_5*a_3_9 - V_2_5*a_3_10 - V_3_5*a_3_11 - V_4_5*a_3_12 - V_5_5*a_3_13
        s468 = -V_0_0*a_3_15 - V_1_0*a_3_16 - V_2_0*a_3_17 - V_3_0*a_3_18 - V_4_0*a_3_19 - V_5_0*a_3_20
        s475 = -V_0_1*a_3_15 - V_1_1*a_3_16 - V_2_1*a_3_17 - V_3_1*a_3_18 - V_4_1*a_3_19 - V_5_1*a_3_20
        s482 = -V_0_2*a_3_15 - V_1_2*a_3_16 - V_2_2*a_3_17 - V_3_2*a_3_18 - V_4_2*a_3_19 - V_5_2*a_3_20
        s488 = -V_5_3*a_3_20
        s489 = -V_0_3*a_3_15 - V_1_3*a_3_16 - V_2_3*a_3_17 - V_3_3*a_3_18 - V_4_3*a_3_19 - a_3_14 + s488
        s496 = -V_0_4*a_3_15 - V_1_4*a_3_16 - V_2_4*a_3_17 - V_3_4*a_3_18 - V_4_4*a_3_19 - V_5_4*a_3_20
        s503 = -V_0_5*a_3_15 - V_1_5*a_3_16 - V_2_5*a_3_17 - V_3_5*a_3_18 - V_4_5*a_3_19 - V_5_5*a_3_20
        s510 = -V_0_0*a_4_1 - V_1_0*a_4_2 - V_2_0*a_4_3 - V_3_0*a_4_4 - V_4_0*a_4_5 - V_5_0*a_4_6
        s517 = -V_0_1*a_4_1 - V_1_1*a_4_2 - V_2_1*a_4_3 - V_3_1*a_4_4 - V_4_1*a_4_5 - V_5_1*a_4_6
        s524 = -V_0_2*a_4_1 - V_1_2*a_4_2 - V_2_2*a_4_3 - V_3_2*a_4_4 - V_4_2*a_4_5 - V_5_2*a_4_6
        s531 = -V_0_3*a_4_1 - V_1_3*a_4_2 - V_2_3*a_4_3 - V_3_3*a_4_4 - V_4_3*a_4_5 - V_5_3*a_4_6
        s537 = -V_5_4*a_4_6
        s538 = -V_0_4*a_4_1 - V_1_4*a_4_2 - V_2_4*a_4_3 - V_3_4*a_4_4 - V_4_4*a_4_5 - a_4_0 + s537
        s545 = -V_0_5*a_4_1 - V_1_5*a_4_2 - V_2_5*a_4_3 - V_3_5*a_4_4 - V_4_5*a_4_5 - V_5_5*a_4_6
        s552 = -V_0_0*a_4_8 - V_1_0*a_4_9 - V_2_0*a_4_10 - V_3_0*a_4_11 - V_4_0*a_4_12 - V_5_0*a_4_13
        s559 = -V_0_1*a_4_8 - V_1_1*a_4_9 - V_2_1*a_4_10 - V_3_1*a_4_11 - V_4_1*a_4_12 - V_5_1*a_4_13
        s566 = -V_0_2*a_4_8 - V_1_2*a_4_9 - V_2_2*a_4_10 - V_3_2*a_4_11 - V_4_2*a_4_12 - V_5_2*a_4_13
        s573 = -V_0_3*a_4_8 - V_1_3*a_4_9 - V_2_3*a_4_10 - V_3_3*a_4_11 - V_4_3*a_4_12 - V_5_3*a_4_13
        s579 = -V_5_4*a_4_13
        s580 = -V_0_4*a_4_8 - V_1_4*a_4_9 - V_2_4*a_4_10 - V_3_4*a_4_11 - V_4_4*a_4_12 - a_4_7 + s579
        s587 = -V_0_5*a_4_8 - V_1_5*a_4_9 - V_2_5*a_4_10 - V_3_5*a_4_11 - V_4_5*a_4_12 - V_5_5*a_4_13
        s594 = -V_0_0*a_4_15 - V_1_0*a_4_16 - V_2_0*a_4_17 - V_3_0*a_4_18 - V_4_0*a_4_19 - V_5_0*a_4_20
        s601 = -V_0_1*a_4_15 - V_1_1*a_4_16 - V_2_1*a_4_17 - V_3_1*a_4_18 - V_4_1*a_4_19 - V_5_1*a_4_20
        s608 = -V_0_2*a_4_15 - V_1_2*a_4_16 - V_2_2*a_4_17 - V_3_2*a_4_18 - V_4_2*a_4_19 - V_5_2*a_4_20
        s615 = -V_0_3*a_4_15 - V_1_3*a_4_16 - V_2_3*a_4_17 - V_3_3*a_4_18 - V_4_3*a_4_19 - V_5_3*a_4_20
        s621 = -V_5_4*a_4_20
        s622 = -V_0_4*a_4_15 - V_1_4*a_4_16 - V_2_4*a_4_17 - V_3_4*a_4_18 - V_4_4*a_4_19 - a_4_14 + s621
        s629 = -V_0_5*a_4_15 - V_1_5*a_4_16 - V_2_5*a_4_17 - V_3_5*a_4_18 - V_4_5*a_4_19 - V_5_5*a_4_20
        s636 = -V_0_0*a_5_1 - V_1_0*a_5_2 - V_2_0*a_5_3 - V_3_0*a_5_4 - V_4_0*a_5_5 - V_5_0*a_5_6
        s643 = -V_0_1*a_5_1 - V_1_1*a_5_2 - V_2_1*a_5_3 - V_3_1*a_5_4 - V_4_1*a_5_5 - V_5_1*a_5_6
        s650 = -V_0_2*a_5_1 - V_1_2*a_5_2 - V_2_2*a_5_3 - V_3_2*a_5_4 - V_4_2*a_5_5 - V_5_2*a_5_6
        s657 = -V_0_3*a_5_1 - V_1_3*a_5_2 - V_2_3*a_5_3 - V_3_3*a_5_4 - V_4_3*a_5_5 - V_5_3*a_5_6
        s664 = -V_0_4*a_5_1 - V_1_4*a_5_2 - V_2_4*a_5_3 - V_3_4*a_5_4 - V_4_4*a_5_5 - V_5_4*a_5_6
        s670 = -V_5_5*a_5_6
        s671 = -V_0_5*a_5_1 - V_1_5*a_5_2 - V_2_5*a_5_3 - V_3_5*a_5_4 - V_4_5*a_5_5 - a_5_0 + s670
        s678 = -V_0_0*a_5_8 - V_1_0*a_5_9 - V_2_0*a_5_10 - V_3_0*a_5_11 - V_4_0*a_5_12 - V_5_0*a_5_13
        s685 = -V_0_1*a_5_8 - V_1_1*a_5_9 - V_2_1*a_5_10 - V_3_1*a_5_11 - V_4_1*a_5_12 - V_5_1*a_5_13
        s692 = -V_0_2*a_5_8 - V_1_2*a_5_9 - V_2_2*a_5_10 - V_3_2*a_5_11 - V_4_2*a_5_12 - V_5_2*a_5_13
        s699 = -V_0_3*a_5_8 - V_1_3*a_5_9 - V_2_3*a_5_10 - V_3_3*a_5_11 - V_4_3*a_5_12 - V_5_3*a_5_13
        s706 = -V_0_4*a_5_8 - V_1_4*a_5_9 - V_2_4*a_5_10 - V_3_4*a_5_11 - V_4_4*a_5_12 - V_5_4*a_5_13
        s712 = -V_5_5*a_5_13
        s713 = -V_0_5*a_5_8 - V_1_5*a_5_9 - V_2_5*a_5_10 - V_3_5*a_5_11 - V_4_5*a_5_12 - a_5_7 + s712
        s720 = -V_0_0*a_5_15 - V_1_0*a_5_16 - V_2_0*a_5_17 - V_3_0*a_5_18 - V_4_0*a_5_19 - V_5_0*a_5_20
        s727 = -V_0_1*a_5_15 - V_1_1*a_5_16 - V_2_1*a_5_17 - V_3_1*a_5_18 - V_4_1*a_5_19 - V_5_1*a_5_20
        s734 = -V_0_2*a_5_15 - V_1_2*a_5_16 - V_2_2*a_5_17 - V_3_2*a_5_18 - V_4_2*a_5_19 - V_5_2*a_5_20
        s741 = -V_0_3*a_5_15 - V_1_3*a_5_16 - V_2_3*a_5_17 - V_3_3*a_5_18 - V_4_3*a_5_19 - V_5_3*a_5_20
        s748 = -V_0_4*a_5_15 - V_1_4*a_5_16 - V_2_4*a_5_17 - V_3_4*a_5_18 - V_4_4*a_5_19 - V_5_4*a_5_20
        s754 = -V_5_5*a_5_20
        s755 = -V_0_5*a_5_15 - V_1_5*a_5_16 - V_2_5*a_5_17 - V_3_5*a_5_18 - V_4_5*a_5_19 - a_5_14 + s754
        s762 = -V_0_0*a_p_0 - V_1_0*a_p_1 - V_2_0*a_p_2 - V_3_0*a_p_3 - V_4_0*a_p_4 - V_5_0*a_p_5
        s769 = -V_0_1*a_p_0 - V_1_1*a_p_1 - V_2_1*a_p_2 - V_3_1*a_p_3 - V_4_1*a_p_4 - V_5_1*a_p_5
        s776 = -V_0_2*a_p_0 - V_1_2*a_p_1 - V_2_2*a_p_2 - V_3_2*a_p_3 - V_4_2*a_p_4 - V_5_2*a_p_5
        s783 = -V_0_3*a_p_0 - V_1_3*a_p_1 - V_2_3*a_p_2 - V_3_3*a_p_3 - V_4_3*a_p_4 - V_5_3*a_p_5
        s790 = -V_0_4*a_p_0 - V_1_4*a_p_1 - V_2_4*a_p_2 - V_3_4*a_p_3 - V_4_4*a_p_4 - V_5_4*a_p_5
        s797 = -V_0_5*a_p_0 - V_1_5*a_p_1 - V_2_5*a_p_2 - V_3_5*a_p_3 - V_4_5*a_p_4 - V_5_5*a_p_5
        s[2208 + lane] = s6
        s[2240 + lane] = s13
        s[2272 + lane] = s20
        s[2304 + lane] = s27
        s[2336 + lane] = s34
        s[2368 + lane] = s41
        s[2400 + lane] = s48
        s[2432 + lane] = s55
        s[2464 + lane] = s62
        s[2496 + lane] = s69
        s[2528 + lane] = s76
        s[2560 + lane] = s83
        s[2592 + lane] = s90
        s[2624 + lane] = s97
        s[2656 + lane] = s104
        s[2688 + lane] = s111
        s[2720 + lane] = s118
        s[2752 + lane] = s125
        s[2784 + lane] = s132
        s[2816 + lane] = s139
        s[2848 + lane] = s146
        s[2880 + lane] = s153
        s[2912 + lane] = s160
        s[2944 + lane] = s167
        s[2976 + lane] = s174
        s[3008 + lane] = s181
        s[3040 + lane] = s188
        s[3072 + lane] = s195
        s[3104 + lane] = s202
        s[3136 + lane] = s209
        s[3168 + lane] = s216
        s[3200 + lane] = s223
        s[3232 + lane] = s230
        s[3264 + lane] = s237
        s[3296 + lane] = s244
        s[3328 + lane] = s251
        s[3360 + lane] = s258
        s[3392 + lane] = s265
        s[3424 + lane] = s272
        s[3456 + lane] = s279
        s[3488 + lane] = s286
        s[3520 + lane] = s293
        s[3552 + lane] = s300
        s[3584 + lane] = s307
        s[3616 + lane] = s314
        s[3648 + lane] = s321
        s[3680 + lane] = s328
        s[3712 + lane] = s335
        s[3744 + lane] = s342
        s[3776 + lane] = s349
        s[3808 + lane] = s356
        s[3840 + lane] = s363
        s[3872 + lane] = s370
        s[3904 + lane] = s377
        s[3936 + lane] = s384
        s[3968 + lane] = s391
        s[4000 + lane] = s398
        s[4032 + lane] = s405
        s[4064 + lane] = s412
        s[4096 + lane] = s419
        s[4128 + lane] = s426
        s[4160 + lane] = s433
        s[4192 + lane] = s440
        s[4224 + lane] = s447
        s[4256 + lane] = s454
        s[4288 + lane] = s461
        s[4320 + lane] = s468
        s[4352 + lane] = s475
        s[4384 + lane] = s482
        s[4416 + lane] = s489
        s[4448 + lane] = s496
        s[4480 + lane] = s503
        s[4512 + lane] = s510
        s[4544 + lane] = s517
        s[4576 + lane] = s524
        s[4608 + lane] = s531
        s[4640 + lane] = s538
        s[4672 + lane] = s545
        s[4704 + lane] = s552
        s[4736 + lane] = s559
        s[4768 + lane] = s566
        s[4800 + lane] = s573
        s[4832 + lane] = s580
        s[4864 + lane] = s587
        s[4896 + lane] = s594
        s[4928 + lane] = s601
        s[4960 + lane] = s608
        s[4992 + lane] = s615
        s[5024 + lane] = s622
        s[5056 + lane] = s629
        s[5088 + lane] = s636
        s[5120 + lane] = s643
        s[5152 + lane] = s650
        s[5184 + lane] = s657
        s[5216 + lane] = s664
        s[5248 + lane] = s671
        s[5280 + lane] = s678
        s[5312 + lane] = s685
        s[5344 + lane] = s692
        s[5376 + lane] = s699
        s[5408 + lane] = s706
        s[5440 + lane] = s713
        s[5472 + lane] = s720
        s[5504 + lane] = s727
        s[5536 + lane] = s734
        s[5568 + lane] = s741
        s[5600 + lane] = s748
        s[5632 + lane] = s755
        s[5664 + lane] = s762
        s[5696 + lane] = s769
        s[5728 + lane] = s776
        s[5760 + lane] = s783
        s[5792 + lane] = s790
        s[5824 + lane] = s797


@straight
def _rates(speeds, accelerations, d, first, last, n):
    """Put velocities and accelerations of the joints side by side, the last ones again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        d[0 + lane] = speeds[6 * m + 0]
        d[32 + lane] = accelerations[6 * m + 0]
        d[1248 + lane] = speeds[6 * m + 1]
        d[1280 + lane] = accelerations[6 * m + 1]
        d[2496 + lane] = speeds[6 * m + 2]
        d[2528 + lane] = accelerations[6 * m + 2]
        d[3744 + lane] = speeds[6 * m + 3]
        d[3776 + lane] = accelerations[6 * m + 3]
        d[4992 + lane] = speeds[6 * m + 4]
        d[5024 + lane] = accelerations[6 * m + 4]
        d[6240 + lane] = speeds[6 * m + 5]
        d[6272 + lane] = accelerations[6 * m + 5]


@straight
def _pay(w, s, tau, first, last):
    """Write what the joints give."""
    for lane in range(last - first + 1):
        regular = (w[10848 + lane] > 0.0) & (w[10880 + lane] > 0.0)
        tau[6 * (first + lane) + 0] = s[2016 + lane] if regular else math.nan
        tau[6 * (first + lane) + 1] = s[2048 + lane] if regular else math.nan
        tau[6 * (first + lane) + 2] = s[2080 + lane] if regular else math.nan
        tau[6 * (first + lane) + 3] = s[2112 + lane] if regular else math.nan
        tau[6 * (first + lane) + 4] = s[2144 + lane] if regular else math.nan
        tau[6 * (first + lane) + 5] = s[2176 + lane] if regular else math.nan


@straight
def _pay_each(w, s, Y, first, last):
    """Write what the joints give for each inertial parameter."""
    for lane in range(last - first + 1):
        regular = (w[10848 + lane] > 0.0) & (w[10880 + lane] > 0.0)
        Y[114 * (first + lane) + 0] = s[2208 + lane] if regular else math.nan
        Y[114 * (first + lane) + 1] = s[2400 + lane] if regular else math.nan
        Y[114 * (first + lane) + 2] = s[2592 + lane] if regular else math.nan
        Y[114 * (first + lane) + 3] = s[2784 + lane] if regular else math.nan
        Y[114 * (first + lane) + 4] = s[2976 + lane] if regular else math.nan
        Y[114 * (first + lane) + 5] = s[3168 + lane] if regular else math.nan
        Y[114 * (first + lane) + 6] = s[3360 + lane] if regular else math.nan
        Y[114 * (first + lane) + 7] = s[3552 + lane] if regular else math.nan
        Y[114 * (first + lane) + 8] = s[3744 + lane] if regular else math.nan
        Y[114 * (first + lane) + 9] = s[3936 + lane] if regular else math.nan
        Y[114 * (first + lane) + 10] = s[4128 + lane] if regular else math.nan
        Y[114 * (first + lane) + 11] = s[4320 + lane] if regular else math.nan
        Y[114 * (first + lane) + 12] = s[4512 + lane] if regular else math.nan
        Y[114 * (first + lane) + 13] = s[4704 + lane] if regular else math.nan
        Y[114 * (first + lane) + 14] = s[4896 + lane] if regular else math.nan
        Y[114 * (first + lane) + 15] = s[5088 + lane] if regular else math.nan
        Y[114 * (first + lane) + 16] = s[5280 + lane] if regular else math.nan
        Y[114 * (first + lane) + 17] = s[5472 + lane] if regular else math.nan
        Y[114 * (first + lane) + 18] = s[5664 + lane] if regular else math.nan
        Y[114 * (first + lane) + 19] = s[2240 + lane] if regular else math.nan
        Y[114 * (first + lane) + 20] = s[2432 + lane] if regular else math.nan
        Y[114 * (first + lane) + 21] = s[2624 + lane] if regular else math.nan
        Y[114 * (first + lane) + 22] = s[2816 + lane] if regular else math.nan
        Y[114 * (first + lane) + 23] = s[3008 + lane] if regular else math.nan
        Y[114 * (first + lane) + 24] = s[3200 + lane] if regular else math.nan
        Y[114 * (first + lane) + 25] = s[3392 + lane] if regular else math.nan
        Y[114 * (first + lane) + 26] = s[3584 + lane] if regular else math.nan
        Y[114 * (first + lane) + 27] = s[3776 + lane] if regular else math.nan
        Y[114 * (first + lane) + 28] = s[3968 + lane] if regular else math.nan
        Y[114 * (first + lane) + 29] = s[4160 + lane] if regular else math.nan
        Y[114 * (first + lane) + 30] = s[4352 + lane] if regular else math.nan
        Y[114 * (first + lane) + 31] = s[4544 + lane] if regular else math.nan
        Y[114 * (first + lane) + 32] = s[4736 + lane] if regular else math.nan
        Y[114 * (first + lane) + 33] = s[4928 + lane] if regular else math.nan
        Y[114 * (first + lane) + 34] = s[5120 + lane] if regular else math.nan
        Y[114 * (first + lane) + 35] = s[5312 + lane] if regular else math.nan
        Y[114 * (first + lane) + 36] = s[5504 + lane] if regular else math.nan
        Y[114 * (first + lane) + 37] = s[5696 + lane] if regular else math.nan
        Y[114 * (first + lane) + 38] = s[2272 + lane] if regular else math.nan
        Y[114 * (first + lane) + 39] = s[2464 + lane] if regular else math.nan
        Y[114 * (first + lane) + 40] = s[2656 + lane] if regular else math.nan
        Y[114 * (first + lane) + 41] = s[2848 + lane] if regular else math.nan
        Y[114 * (first + lane) + 42] = s[3040 + lane] if regular else math.nan
        Y[114 * (first + lane) + 43] = s[3232 + lane] if regular else math.nan
        Y[114 * (first + lane) + 44] = s[3424 + lane] if regular else math.nan
        Y[114 * (first + lane) + 45] = s[3616 + lane] if regular else math.nan
        Y[114 * (first + lane) + 46] = s[3808 + lane] if regular else math.nan
        Y[114 * (first + lane) + 47] = s[4000 + lane] if regular else math.nan
        Y[114 * (first + lane) + 48] = s[4192 + lane] if regular else math.nan
        Y[114 * (first + lane) + 49] = s[4384 + lane] if regular else math.nan
        Y[114 * (first + lane) + 50] = s[4576 + lane] if regular else math.nan
        Y[114 * (first + lane) + 51] = s[4768 + lane] if regular else math.nan
        Y[114 * (first + lane) + 52] = s[4960 + lane] if regular else math.nan
        Y[114 * (first + lane) + 53] = s[5152 + lane] if regular else math.nan
        Y[114 * (first + lane) + 54] = s[5344 + lane] if regular else math.nan
        Y[114 * (first + lane) + 55] = s[5536 + lane] if regular else math.nan
        Y[114 * (first + lane) + 56] = s[5728 + lane] if regular else math.nan
        Y[114 * (first + lane) + 57] = s[2304 + lane] if regular else math.nan
        Y[114 * (first + lane) + 58] = s[2496 + lane] if regular else math.nan
        Y[114 * (first + lane) + 59] = s[2688 + lane] if regular else math.nan
        Y[114 * (first + lane) + 60] = s[2880 + lane] if regular else math.nan
        Y[114 * (first + lane) + 61] = s[3072 + lane] if regular else math.nan
        Y[114 * (first + lane) + 62] = s[3264 + lane] if regular else math.nan
        Y[114 * (first + lane) + 63] = s[3456 + lane] if regular else math.nan
        Y[114 * (first + lane) + 64] = s[3648 + lane] if regular else math.nan
        Y[114 * (first + lane) + 65] = s[3840 + lane] if regular else math.nan
        Y[114 * (first + lane) + 66] = s[4032 + lane] if regular else math.nan
        Y[114 * (first + lane) + 67] = s[4224 + lane] if regular else math.nan
        Y[114 * (first + lane) + 68] = s[4416 + lane] if regular else math.nan
        Y[114 * (first + lane) + 69] = s[4608 + lane] if regular else math.nan
        Y[114 * (first + lane) + 70] = s[4800 + lane] if regular else math.nan
        Y[114 * (first + lane) + 71] = s[4992 + lane] if regular else math.nan
        Y[114 * (first + lane) + 72] = s[5184 + lane] if regular else math.nan
        Y[114 * (first + lane) + 73] = s[5376 + lane] if regular else math.nan
        Y[114 * (first + lane) + 74] = s[5568 + lane] if regular else math.nan
        Y[114 * (first + lane) + 75] = s[5760 + lane] if regular else math.nan
        Y[114 * (first + lane) + 76] = s[2336 + lane] if regular else math.nan
        Y[114 * (first + lane) + 77] = s[2528 + lane] if regular else math.nan
        Y[114 * (first + lane) + 78] = s[2720 + lane] if regular else math.nan
        Y[114 * (first + lane) + 79] = s[2912 + lane] if regular else math.nan
        Y[114 * (first + lane) + 80] = s[3104 + lane] if regular else math.nan
        Y[114 * (first + lane) + 81] = s[3296 + lane] if regular else math.nan
        Y[114 * (first + lane) + 82] = s[3488 + lane] if regular else math.nan
        Y[114 * (first + lane) + 83] = s[3680 + lane] if regular else math.nan
        Y[114 * (first + lane) + 84] = s[3872 + lane] if regular else math.nan
        Y[114 * (first + lane) + 85] = s[4064 + lane] if regular else math.nan
        Y[114 * (first + lane) + 86] = s[4256 + lane] if regular else math.nan
        Y[114 * (first + lane) + 87] = s[4448 + lane] if regular else math.nan
        Y[114 * (first + lane) + 88] = s[4640 + lane] if regular else math.nan
        Y[114 * (first + lane) + 89] = s[4832 + lane] if regular else math.nan
        Y[114 * (first + lane) + 90] = s[5024 + lane] if regular else math.nan
        Y[114 * (first + lane) + 91] = s[5216 + lane] if regular else math.nan
        Y[114 * (first + lane) + 92] = s[5408 + lane] if regular else math.nan
        Y[114 * (first + lane) + 93] = s[5600 + lane] if regular else math.nan
        Y[114 * (first + lane) + 94] = s[5792 + lane] if regular else math.nan
        Y[114 * (first + lane) + 95] = s[2368 + lane] if regular else math.nan
        Y[114 * (first + lane) + 96] = s[2560 + lane] if regular else math.nan
        Y[114 * (first + lane) + 97] = s[2752 + lane] if regular else math.nan
        Y[114 * (first + lane) + 98] = s[2944 + lane] if regular else math.nan
        Y[114 * (first + lane) + 99] = s[3136 + lane] if regular else math.nan
        Y[114 * (first + lane) + 100] = s[3328 + lane] if regular else math.nan
        Y[114 * (first + lane) + 101] = s[3520 + lane] if regular else math.nan
        Y[114 * (first + lane) + 102] = s[3712 + lane] if regular else math.nan
        Y[114 * (first + lane) + 103] = s[3904 + lane] if regular else math.nan
        Y[114 * (first + lane) + 104] = s[4096 + lane] if regular else math.nan
        Y[114 * (first + lane) + 105] = s[4288 + lane] if regular else math.nan
        Y[114 * (first + lane) + 106] = s[4480 + lane] if regular else math.nan
        Y[114 * (first + lane) + 107] = s[4672 + lane] if regular else math.nan
        Y[114 * (first + lane) + 108] = s[4864 + lane] if regular else math.nan
        Y[114 * (first + lane) + 109] = s[5056 + lane] if regular else math.nan
        Y[114 * (first + lane) + 110] = s[5248 + lane] if regular else math.nan
        Y[114 * (first + lane) + 111] = s[5440 + lane] if regular else math.nan
        Y[114 * (first + lane) + 112] = s[5632 + lane] if regular else math.nan
        Y[114 * (first + lane) + 113] = s[5824 + lane] if regular else math.nan


@fast
def _torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    found = tau.reshape(tau.size)
    w, d, s = scratch(WORK), scratch(6 * OWN), scratch(SHARED)
    w_1 = w[0:1568]
    w_2 = w[1568:3136]
    w_3 = w[3136:4704]
    w_4 = w[4704:6272]
    w_5 = w[6272:7840]
    w_6 = w[7840:9408]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    d_3 = d[2 * OWN:3 * OWN]
    d_4 = d[3 * OWN:4 * OWN]
    d_5 = d[4 * OWN:5 * OWN]
    d_6 = d[5 * OWN:6 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 6 :], states[2 * samples * 6 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
        k_3, own_3 = k[m, 2], c[m, 2]
        k_4, own_4 = k[m, 3], c[m, 3]
        k_5, own_5 = k[m, 4], c[m, 4]
        k_6, own_6 = k[m, 5], c[m, 5]
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
            _early(w_4, k_4, n)
            _more(w_4, k_4, n)
            _rows(w_4, k_4, n)
            _joints(w_4, k_4, n)
            _early(w_5, k_5, n)
            _more(w_5, k_5, n)
            _rows(w_5, k_5, n)
            _joints(w_5, k_5, n)
            _early(w_6, k_6, n)
            _more(w_6, k_6, n)
            _rows(w_6, k_6, n)
            _joints(w_6, k_6, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _curved(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _curved(w_4, d_4, s, own_4, gravity, shares[3:], n)
            _curved(w_5, d_5, s, own_5, gravity, shares[4:], n)
            _curved(w_6, d_6, s, own_6, gravity, shares[5:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_fields(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_fields(w_4, d_4, s, own_4, gravity, shares[3:], n)
            _limb_fields(w_5, d_5, s, own_5, gravity, shares[4:], n)
            _limb_fields(w_6, d_6, s, own_6, gravity, shares[5:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_asks(w_4, d_4, s, own_4, gravity, shares[3:], n)
            _limb_asks(w_5, d_5, s, own_5, gravity, shares[4:], n)
            _limb_asks(w_6, d_6, s, own_6, gravity, shares[5:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give(d, s, inertia, n)
            _pay(w, s, found, first, last)


def torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    """Fill tau (N, 6) [N mm, N]: what the joints must give, positive along positive joints."""
    _torque(x, motion, tool, k, c, gravity, shares, inertia, tau)


@fast
def _regressor(x, motion, tool, k, c, gravity, shares, Y):
    found = Y.reshape(Y.size)
    w, d, s = scratch(WORK), scratch(6 * OWN), scratch(SHARED)
    w_1 = w[0:1568]
    w_2 = w[1568:3136]
    w_3 = w[3136:4704]
    w_4 = w[4704:6272]
    w_5 = w[6272:7840]
    w_6 = w[7840:9408]
    d_1 = d[0 * OWN:1 * OWN]
    d_2 = d[1 * OWN:2 * OWN]
    d_3 = d[2 * OWN:3 * OWN]
    d_4 = d[3 * OWN:4 * OWN]
    d_5 = d[4 * OWN:5 * OWN]
    d_6 = d[5 * OWN:6 * OWN]
    states = motion.reshape(motion.size)
    samples, machines = len(x), k.shape[0]
    speeds, accelerations = states[samples * 6 :], states[2 * samples * 6 :]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    each = samples // machines
    for m in range(machines):
        k_1, own_1 = k[m, 0], c[m, 0]
        k_2, own_2 = k[m, 1], c[m, 1]
        k_3, own_3 = k[m, 2], c[m, 2]
        k_4, own_4 = k[m, 3], c[m, 3]
        k_5, own_5 = k[m, 4], c[m, 4]
        k_6, own_6 = k[m, 5], c[m, 5]
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
            _early(w_4, k_4, n)
            _more(w_4, k_4, n)
            _rows(w_4, k_4, n)
            _joints(w_4, k_4, n)
            _early(w_5, k_5, n)
            _more(w_5, k_5, n)
            _rows(w_5, k_5, n)
            _joints(w_5, k_5, n)
            _early(w_6, k_6, n)
            _more(w_6, k_6, n)
            _rows(w_6, k_6, n)
            _joints(w_6, k_6, n)
            _inverse_of_rows(w, n)
            _move(w, d, s, n)
            _curved(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _curved(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _curved(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _curved(w_4, d_4, s, own_4, gravity, shares[3:], n)
            _curved(w_5, d_5, s, own_5, gravity, shares[4:], n)
            _curved(w_6, d_6, s, own_6, gravity, shares[5:], n)
            _accelerate(w, d, s, n)
            _limb_fields(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_fields(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_fields(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_fields(w_4, d_4, s, own_4, gravity, shares[3:], n)
            _limb_fields(w_5, d_5, s, own_5, gravity, shares[4:], n)
            _limb_fields(w_6, d_6, s, own_6, gravity, shares[5:], n)
            _limb_asks(w_1, d_1, s, own_1, gravity, shares[0:], n)
            _limb_asks(w_2, d_2, s, own_2, gravity, shares[1:], n)
            _limb_asks(w_3, d_3, s, own_3, gravity, shares[2:], n)
            _limb_asks(w_4, d_4, s, own_4, gravity, shares[3:], n)
            _limb_asks(w_5, d_5, s, own_5, gravity, shares[4:], n)
            _limb_asks(w_6, d_6, s, own_6, gravity, shares[5:], n)
            _platform_fields(w, d, s, gravity, n)
            _platform_asks(w, d, s, n)
            _give_each(d, s, n)
            _pay_each(w, s, found, first, last)


def regressor(x, motion, tool, k, c, gravity, shares, Y):
    """Fill Y (N, 6, 19): what the joints must give for each inertial parameter, which is 1."""
    _regressor(x, motion, tool, k, c, gravity, shares, Y)
