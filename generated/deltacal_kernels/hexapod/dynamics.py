"""Dynamics of `hexapod`, many samples at once: Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both f13f5c323e6c5e1f; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 6)  platform: px py pz cx cy cz
motion (3, N, 6)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 6, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 6, 12)  what `constants` makes of p (M, 6, 18)
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
        base = p[18 * lane + 0]
        alpha = p[18 * lane + 1]
        up = p[18 * lane + 2]
        plate = p[18 * lane + 3]
        beta = p[18 * lane + 4]
        down = p[18 * lane + 5]
        leg = p[18 * lane + 6]
        ax = p[18 * lane + 7]
        ay = p[18 * lane + 8]
        az = p[18 * lane + 9]
        bx = p[18 * lane + 10]
        by = p[18 * lane + 11]
        bz = p[18 * lane + 12]
        dl = p[18 * lane + 13]
        scale = p[18 * lane + 14]
        dtx = p[18 * lane + 15]
        dty = p[18 * lane + 16]
        dtz = p[18 * lane + 17]
        A_x = ax + base*cosine(alpha)
        A_y = ay + base*sine(alpha)
        A_z = az + up
        s9 = bx - dtx + plate*cosine(beta)
        s13 = by - dty + plate*sine(beta)
        s15 = bz + down - dtz
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
    """Return c (M, 6, 12), what no pose changes of bodies in motion, from p (26 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 6, 12))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (102 operations)."""
    for lane in range(n):
        M_0_0 = w[10272 + lane]
        M_0_1 = w[10304 + lane]
        M_0_2 = w[10336 + lane]
        M_0_3 = w[10368 + lane]
        M_0_4 = w[10400 + lane]
        M_0_5 = w[10432 + lane]
        M_1_0 = w[10464 + lane]
        M_1_1 = w[10496 + lane]
        M_1_2 = w[10528 + lane]
        M_1_3 = w[10560 + lane]
        M_1_4 = w[10592 + lane]
        M_1_5 = w[10624 + lane]
        M_2_0 = w[10656 + lane]
        M_2_1 = w[10688 + lane]
        M_2_2 = w[10720 + lane]
        M_2_3 = w[10752 + lane]
        M_2_4 = w[10784 + lane]
        M_2_5 = w[10816 + lane]
        M_3_0 = w[10848 + lane]
        M_3_1 = w[10880 + lane]
        M_3_2 = w[10912 + lane]
        M_3_3 = w[10944 + lane]
        M_3_4 = w[10976 + lane]
        M_3_5 = w[11008 + lane]
        M_4_0 = w[11040 + lane]
        M_4_1 = w[11072 + lane]
        M_4_2 = w[11104 + lane]
        M_4_3 = w[11136 + lane]
        M_4_4 = w[11168 + lane]
        M_4_5 = w[11200 + lane]
        M_5_0 = w[11232 + lane]
        M_5_1 = w[11264 + lane]
        M_5_2 = w[11296 + lane]
        M_5_3 = w[11328 + lane]
        M_5_4 = w[11360 + lane]
        M_5_5 = w[11392 + lane]
        q_t_0 = d[0 + lane]
        Q_0 = w[832 + lane]
        q_t_1 = d[1248 + lane]
        Q_1 = w[2496 + lane]
        q_t_2 = d[2496 + lane]
        Q_2 = w[4160 + lane]
        q_t_3 = d[3744 + lane]
        Q_3 = w[5824 + lane]
        q_t_4 = d[4992 + lane]
        Q_4 = w[7488 + lane]
        q_t_5 = d[6240 + lane]
        Q_5 = w[9152 + lane]
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
        M_0_0 = w[10272 + lane]
        M_0_1 = w[10304 + lane]
        M_0_2 = w[10336 + lane]
        M_0_3 = w[10368 + lane]
        M_0_4 = w[10400 + lane]
        M_0_5 = w[10432 + lane]
        M_1_0 = w[10464 + lane]
        M_1_1 = w[10496 + lane]
        M_1_2 = w[10528 + lane]
        M_1_3 = w[10560 + lane]
        M_1_4 = w[10592 + lane]
        M_1_5 = w[10624 + lane]
        M_2_0 = w[10656 + lane]
        M_2_1 = w[10688 + lane]
        M_2_2 = w[10720 + lane]
        M_2_3 = w[10752 + lane]
        M_2_4 = w[10784 + lane]
        M_2_5 = w[10816 + lane]
        M_3_0 = w[10848 + lane]
        M_3_1 = w[10880 + lane]
        M_3_2 = w[10912 + lane]
        M_3_3 = w[10944 + lane]
        M_3_4 = w[10976 + lane]
        M_3_5 = w[11008 + lane]
        M_4_0 = w[11040 + lane]
        M_4_1 = w[11072 + lane]
        M_4_2 = w[11104 + lane]
        M_4_3 = w[11136 + lane]
        M_4_4 = w[11168 + lane]
        M_4_5 = w[11200 + lane]
        M_5_0 = w[11232 + lane]
        M_5_1 = w[11264 + lane]
        M_5_2 = w[11296 + lane]
        M_5_3 = w[11328 + lane]
        M_5_4 = w[11360 + lane]
        M_5_5 = w[11392 + lane]
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
        regular = (w[11424 + lane] > 0.0) & (w[11456 + lane] > 0.0)
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
        regular = (w[11424 + lane] > 0.0) & (w[11456 + lane] > 0.0)
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
    w_1 = w[0:1664]
    w_2 = w[1664:3328]
    w_3 = w[3328:4992]
    w_4 = w[4992:6656]
    w_5 = w[6656:8320]
    w_6 = w[8320:9984]
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
    w_1 = w[0:1664]
    w_2 = w[1664:3328]
    w_3 = w[3328:4992]
    w_4 = w[4992:6656]
    w_5 = w[6656:8320]
    w_6 = w[8320:9984]
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


@straight
def _fill_by(p, p_by, k, rows):
    for lane in range(rows):
        base_now = p[18 * lane + 0]
        alpha_now = p[18 * lane + 1]
        plate_now = p[18 * lane + 3]
        beta_now = p[18 * lane + 4]
        leg_now = p[18 * lane + 6]
        base_now_by = p_by[18 * lane + 0]
        alpha_now_by = p_by[18 * lane + 1]
        up_now_by = p_by[18 * lane + 2]
        plate_now_by = p_by[18 * lane + 3]
        beta_now_by = p_by[18 * lane + 4]
        down_now_by = p_by[18 * lane + 5]
        leg_now_by = p_by[18 * lane + 6]
        ax_now_by = p_by[18 * lane + 7]
        ay_now_by = p_by[18 * lane + 8]
        az_now_by = p_by[18 * lane + 9]
        bx_now_by = p_by[18 * lane + 10]
        by_now_by = p_by[18 * lane + 11]
        bz_now_by = p_by[18 * lane + 12]
        dl_now_by = p_by[18 * lane + 13]
        scale_now_by = p_by[18 * lane + 14]
        dtx_now_by = p_by[18 * lane + 15]
        dty_now_by = p_by[18 * lane + 16]
        dtz_now_by = p_by[18 * lane + 17]
        s0 = cosine(alpha_now)
        s3 = sine(alpha_now)
        s7 = cosine(beta_now)
        s10 = sine(beta_now)
        s25 = -alpha_now_by*base_now*s3 + ax_now_by + base_now_by*s0
        s30 = alpha_now_by*base_now*s0 + ay_now_by + base_now_by*s3
        s31 = az_now_by + up_now_by
        s36 = -beta_now_by*plate_now*s10 + bx_now_by - dtx_now_by + plate_now_by*s7
        s41 = beta_now_by*plate_now*s7 + by_now_by - dty_now_by + plate_now_by*s10
        s42 = bz_now_by + down_now_by - dtz_now_by
        s43 = dl_now_by + leg_now_by
        s45 = -0.5*leg_now_by/(leg_now * leg_now)
        s49 = -leg_now_by/(leg_now * leg_now * leg_now)
        s50 = -0.5*leg_now_by
        k[12 * lane + 0] = s36
        k[12 * lane + 1] = s41
        k[12 * lane + 2] = s42
        k[12 * lane + 3] = s25
        k[12 * lane + 4] = s30
        k[12 * lane + 5] = s31
        k[12 * lane + 6] = scale_now_by
        k[12 * lane + 7] = s43
        k[12 * lane + 8] = leg_now_by
        k[12 * lane + 9] = s50
        k[12 * lane + 10] = s45
        k[12 * lane + 11] = s49


@straight
def _fill_machine_by(p, p_by, k, rows):
    for lane in range(rows):
        base_now = p[18 * lane + 0]
        alpha_now = p[18 * lane + 1]
        plate_now = p[18 * lane + 3]
        beta_now = p[18 * lane + 4]
        leg_now = p[18 * lane + 6]
        dl_now = p[18 * lane + 13]
        scale_now = p[18 * lane + 14]
        base_now_by = p_by[18 * lane + 0]
        alpha_now_by = p_by[18 * lane + 1]
        up_now_by = p_by[18 * lane + 2]
        plate_now_by = p_by[18 * lane + 3]
        beta_now_by = p_by[18 * lane + 4]
        down_now_by = p_by[18 * lane + 5]
        leg_now_by = p_by[18 * lane + 6]
        ax_now_by = p_by[18 * lane + 7]
        ay_now_by = p_by[18 * lane + 8]
        az_now_by = p_by[18 * lane + 9]
        bx_now_by = p_by[18 * lane + 10]
        by_now_by = p_by[18 * lane + 11]
        bz_now_by = p_by[18 * lane + 12]
        dl_now_by = p_by[18 * lane + 13]
        scale_now_by = p_by[18 * lane + 14]
        dtx_now_by = p_by[18 * lane + 15]
        dty_now_by = p_by[18 * lane + 16]
        dtz_now_by = p_by[18 * lane + 17]
        s0 = cosine(alpha_now)
        s3 = sine(alpha_now)
        s7 = cosine(beta_now)
        s10 = sine(beta_now)
        s67_now = scale_now + 1
        s69_now = dl_now + leg_now
        s167_now = (1.0 / (s67_now * s67_now))
        s183_now = (s69_now * s69_now)
        s190_now = 2*scale_now + 2
        s22 = (s190_now * s190_now)
        s23 = (1.0 / (s67_now * s67_now * s67_now * s67_now))
        s29 = alpha_now - beta_now
        s30 = cosine(s29)
        s203_now = -(base_now * base_now) + 2*base_now*plate_now*s30 + (leg_now * leg_now) - (plate_now * plate_now)
        s39 = -alpha_now_by*base_now*s3 + ax_now_by + base_now_by*s0
        s44 = alpha_now_by*base_now*s0 + ay_now_by + base_now_by*s3
        s45 = az_now_by + up_now_by
        s50 = -beta_now_by*plate_now*s10 + bx_now_by - dtx_now_by + plate_now_by*s7
        s55 = beta_now_by*plate_now*s7 + by_now_by - dty_now_by + plate_now_by*s10
        s56 = bz_now_by + down_now_by - dtz_now_by
        s57 = dl_now_by + leg_now_by
        s60 = -2*scale_now_by/(s67_now * s67_now * s67_now)
        s62 = 2*s57*s69_now
        s63 = -0.5*s62
        s64 = 2*s60
        s65 = 2*scale_now_by
        s76 = -s183_now*s22*scale_now_by/(s67_now * s67_now * s67_now * s67_now * s67_now)
        s77 = 0.5*s183_now*s190_now*s23*s65 + 0.25*s22*s23*s62 + s76
        s84 = -0.5*s167_now*s190_now*s57 - 0.5*s167_now*s65*s69_now - 0.5*s190_now*s60*s69_now
        s99 = -2*base_now*plate_now*(alpha_now_by - beta_now_by)*sine(s29)
        s100 = 2*base_now*plate_now_by*s30 + 2*base_now_by*plate_now*s30 + s99
        s103 = 0.5/math.sqrt(s203_now)
        s105 = -down_now_by + s103*(-2*base_now*base_now_by + 2*leg_now*leg_now_by - 2*plate_now*plate_now_by + s100) + up_now_by
        k[13 * lane + 0] = s50
        k[13 * lane + 1] = s55
        k[13 * lane + 2] = s56
        k[13 * lane + 3] = s39
        k[13 * lane + 4] = s44
        k[13 * lane + 5] = s45
        k[13 * lane + 6] = scale_now_by
        k[13 * lane + 7] = s57
        k[13 * lane + 8] = s63
        k[13 * lane + 9] = s64
        k[13 * lane + 10] = s77
        k[13 * lane + 11] = s84
        k[13 * lane + 12] = s105


@fast
def _constants_by(p, p_by, k, c):
    _fill_machine_by(p, p_by, k, p.shape[0] * p.shape[1])
    _fill_by(p, p_by, c, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how k and c change, which `constants` of ``kinematics.py`` and of this module make of one machine's p
    (1, 6, 18), along each of p_by (E, 6, 18)."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((len(p_by), 6, 13))
    c_by = np.empty((len(p_by), 6, 12))
    _constants_by(np.repeat(p, len(p_by), axis=0), p_by, k_by, c_by)
    return k_by, c_by


@straight
def _move_platform_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform after a step, and its rotation matrix (187 operations)."""
    for lane in range(n):
        cx_now = w[224 + lane]
        cy_now = w[256 + lane]
        cz_now = w[288 + lane]
        y3_now = w[10080 + lane]
        y4_now = w[10112 + lane]
        y5_now = w[10144 + lane]
        going_now = w[10240 + lane]
        y0_now_by = w_by[9984 + lane]
        y1_now_by = w_by[10016 + lane]
        y2_now_by = w_by[10048 + lane]
        y3_now_by = w_by[10080 + lane]
        y4_now_by = w_by[10112 + lane]
        y5_now_by = w_by[10144 + lane]
        s10_now = 0.5*cz_now
        s11_now = 0.25*cx_now*cy_now
        s14_now = -0.5*cy_now
        s15_now = 0.25*cx_now*cz_now
        s10 = s14_now + s15_now
        s17_now = -going_now*s10*y5_now
        s14 = 0.25*(cx_now * cx_now) + 1
        s16 = s10_now + s11_now
        new_30_now = cx_now - going_now*s14*y3_now - going_now*s16*y4_now + s17_now
        s25_now = 0.5*cx_now
        s26_now = 0.25*cy_now*cz_now
        s21 = s25_now + s26_now
        s28_now = -going_now*s21*y5_now
        s23 = -s10_now + s11_now
        s27 = 0.25*(cy_now * cy_now) + 1
        new_40_now = cy_now - going_now*s23*y3_now - going_now*s27*y4_now + s28_now
        s32 = 0.25*(cz_now * cz_now) + 1
        s37_now = -going_now*s32*y5_now
        s34 = -s14_now + s15_now
        s36 = -s25_now + s26_now
        new_50_now = cz_now - going_now*s34*y3_now - going_now*s36*y4_now + s37_now
        s39_now = (new_30_now * new_30_now)
        s41_now = (new_40_now * new_40_now)
        s43_now = (new_50_now * new_50_now)
        s45 = 0.25*s39_now + 0.25*s41_now + 0.25*s43_now + 1
        s46_now = (1.0 / s45)
        s47_now = -0.5*s41_now
        s48_now = -0.5*s43_now
        s52_now = 0.5*new_30_now*new_40_now
        s55_now = 0.5*new_30_now*new_50_now
        s60_now = -0.5*s39_now
        s64_now = 0.5*new_40_now*new_50_now
        s74 = -going_now*y0_now_by
        s75 = -going_now*y1_now_by
        s76 = -going_now*y2_now_by
        s93 = -going_now*s10*y5_now_by - going_now*s14*y3_now_by - going_now*s16*y4_now_by
        s104 = -going_now*s21*y5_now_by - going_now*s23*y3_now_by - going_now*s27*y4_now_by
        s115 = -going_now*s32*y5_now_by - going_now*s34*y3_now_by - going_now*s36*y4_now_by
        s117 = 2*new_30_now*s93
        s119 = 2*new_40_now*s104
        s121 = 2*new_50_now*s115
        s127 = -(0.25*s117 + 0.25*s119 + 0.25*s121)/(s45 * s45)
        s128 = -0.5*s119
        s129 = -0.5*s121
        s133 = s127*(s47_now + s48_now) + s46_now*(s128 + s129)
        s134 = 0.5*new_40_now
        s135 = 0.5*new_30_now
        s138 = s104*s135 + s134*s93
        s142 = s127*(-new_50_now + s52_now) + s46_now*(-s115 + s138)
        s143 = 0.5*new_50_now
        s146 = s115*s135 + s143*s93
        s150 = s127*(new_40_now + s55_now) + s46_now*(s104 + s146)
        s154 = s127*(new_50_now + s52_now) + s46_now*(s115 + s138)
        s155 = -0.5*s117
        s159 = s127*(s48_now + s60_now) + s46_now*(s129 + s155)
        s162 = s104*s143 + s115*s134
        s166 = s127*(-new_30_now + s64_now) + s46_now*(s162 - s93)
        s170 = s127*(-new_40_now + s55_now) + s46_now*(-s104 + s146)
        s174 = s127*(new_30_now + s64_now) + s46_now*(s162 + s93)
        s178 = s127*(s47_now + s60_now) + s46_now*(s128 + s155)
        w_by[128 + lane] = s74
        w_by[1792 + lane] = s74
        w_by[3456 + lane] = s74
        w_by[5120 + lane] = s74
        w_by[6784 + lane] = s74
        w_by[8448 + lane] = s74
        w_by[160 + lane] = s75
        w_by[1824 + lane] = s75
        w_by[3488 + lane] = s75
        w_by[5152 + lane] = s75
        w_by[6816 + lane] = s75
        w_by[8480 + lane] = s75
        w_by[192 + lane] = s76
        w_by[1856 + lane] = s76
        w_by[3520 + lane] = s76
        w_by[5184 + lane] = s76
        w_by[6848 + lane] = s76
        w_by[8512 + lane] = s76
        w_by[224 + lane] = s93
        w_by[256 + lane] = s104
        w_by[288 + lane] = s115
        w_by[320 + lane] = s133
        w_by[1984 + lane] = s133
        w_by[3648 + lane] = s133
        w_by[5312 + lane] = s133
        w_by[6976 + lane] = s133
        w_by[8640 + lane] = s133
        w_by[352 + lane] = s142
        w_by[2016 + lane] = s142
        w_by[3680 + lane] = s142
        w_by[5344 + lane] = s142
        w_by[7008 + lane] = s142
        w_by[8672 + lane] = s142
        w_by[384 + lane] = s150
        w_by[2048 + lane] = s150
        w_by[3712 + lane] = s150
        w_by[5376 + lane] = s150
        w_by[7040 + lane] = s150
        w_by[8704 + lane] = s150
        w_by[416 + lane] = s154
        w_by[2080 + lane] = s154
        w_by[3744 + lane] = s154
        w_by[5408 + lane] = s154
        w_by[7072 + lane] = s154
        w_by[8736 + lane] = s154
        w_by[448 + lane] = s159
        w_by[2112 + lane] = s159
        w_by[3776 + lane] = s159
        w_by[5440 + lane] = s159
        w_by[7104 + lane] = s159
        w_by[8768 + lane] = s159
        w_by[480 + lane] = s166
        w_by[2144 + lane] = s166
        w_by[3808 + lane] = s166
        w_by[5472 + lane] = s166
        w_by[7136 + lane] = s166
        w_by[8800 + lane] = s166
        w_by[512 + lane] = s170
        w_by[2176 + lane] = s170
        w_by[3840 + lane] = s170
        w_by[5504 + lane] = s170
        w_by[7168 + lane] = s170
        w_by[8832 + lane] = s170
        w_by[544 + lane] = s174
        w_by[2208 + lane] = s174
        w_by[3872 + lane] = s174
        w_by[5536 + lane] = s174
        w_by[7200 + lane] = s174
        w_by[8864 + lane] = s174
        w_by[576 + lane] = s178
        w_by[2240 + lane] = s178
        w_by[3904 + lane] = s178
        w_by[5568 + lane] = s178
        w_by[7232 + lane] = s178
        w_by[8896 + lane] = s178


@straight
def _early_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what moves with a joint only; then platform at home, whatever the joint (6 operations)."""
    s67_now = k[6]
    s69_now = k[7]
    s44_now_by = k_by[0]
    s48_now_by = k_by[1]
    s50_now_by = k_by[2]
    s67_now_by = k_by[6]
    s69_now_by = k_by[7]
    s205_now_by = k_by[12]
    for lane in range(n):
        q_now = w[0 + lane]
        s_now = q_now*s67_now + s69_now
        s12 = -s_now*(q_now*s67_now_by + s69_now_by)
        w_by[864 + lane] = s44_now_by
        w_by[896 + lane] = s48_now_by
        w_by[928 + lane] = s50_now_by
        w_by[960 + lane] = s12
        w_by[992 + lane] = 0
        w_by[1024 + lane] = 0
        w_by[1056 + lane] = s205_now_by
        w_by[1088 + lane] = 0
        w_by[1120 + lane] = 0
        w_by[1152 + lane] = 0


@straight
def _more_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what else derivatives by joint and errors read of it (11 operations)."""
    s67_now = k[6]
    s69_now = k[7]
    s67_now_by = k_by[6]
    s69_now_by = k_by[7]
    for lane in range(n):
        q_now = w[0 + lane]
        s_now = q_now*s67_now + s69_now
        s5 = q_now*s67_now_by + s69_now_by
        s6 = -q_now*s5
        s9 = -s5*s67_now - s67_now_by*s_now
        w_by[1216 + lane] = s9
        w_by[1248 + lane] = -s5
        w_by[1280 + lane] = s6


@straight
def _rows_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of equations of a limb, their derivatives by shift and turn of the platform (104 operations)."""
    A_x_now = k[3]
    A_y_now = k[4]
    A_z_now = k[5]
    A_x_now_by = k_by[3]
    A_y_now_by = k_by[4]
    A_z_now_by = k_by[5]
    for lane in range(n):
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        b_x_now = w[864 + lane]
        b_y_now = w[896 + lane]
        b_z_now = w[928 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        b_x_now_by = w_by[864 + lane]
        b_y_now_by = w_by[896 + lane]
        b_z_now_by = w_by[928 + lane]
        s82_now_by = w_by[960 + lane]
        s52_now = R_11_now*b_x_now
        s53_now = R_12_now*b_y_now
        s54_now = R_13_now*b_z_now
        B_x_now = px_now + s52_now + s53_now + s54_now
        s56_now = R_21_now*b_x_now
        s57_now = R_22_now*b_y_now
        s58_now = R_23_now*b_z_now
        B_y_now = py_now + s56_now + s57_now + s58_now
        s60_now = R_31_now*b_x_now
        s61_now = R_32_now*b_y_now
        s62_now = R_33_now*b_z_now
        B_z_now = pz_now + s60_now + s61_now + s62_now
        d_x_now = -A_x_now + B_x_now
        d_y_now = -A_y_now + B_y_now
        d_z_now = -A_z_now + B_z_now
        s210_now = -s60_now - s61_now - s62_now
        s212_now = s56_now + s57_now + s58_now
        s216_now = -s52_now - s53_now - s54_now
        s36 = R_11_now*b_x_now_by + R_11_now_by*b_x_now
        s39 = R_12_now*b_y_now_by + R_12_now_by*b_y_now
        s42 = R_13_now*b_z_now_by + R_13_now_by*b_z_now
        s46 = R_21_now*b_x_now_by + R_21_now_by*b_x_now
        s49 = R_22_now*b_y_now_by + R_22_now_by*b_y_now
        s52 = R_23_now*b_z_now_by + R_23_now_by*b_z_now
        s56 = R_31_now*b_x_now_by + R_31_now_by*b_x_now
        s59 = R_32_now*b_y_now_by + R_32_now_by*b_y_now
        s62 = R_33_now*b_z_now_by + R_33_now_by*b_z_now
        s64 = -A_x_now_by + px_now_by + s36 + s39 + s42
        s65 = -A_y_now_by + py_now_by + s46 + s49 + s52
        s66 = -A_z_now_by + pz_now_by + s56 + s59 + s62
        s76 = d_x_now*s64 + d_y_now*s65 + d_z_now*s66 + s82_now_by
        s77 = -s56 - s59 - s62
        s78 = s46 + s49 + s52
        s85 = d_y_now*s77 + d_z_now*s78 + s210_now*s65 + s212_now*s66
        s86 = -s36 - s39 - s42
        s93 = -d_x_now*s77 + d_z_now*s86 - s210_now*s64 + s216_now*s66
        s100 = -d_x_now*s78 - d_y_now*s86 - s212_now*s64 - s216_now*s65
        w_by[608 + lane] = s76
        w_by[640 + lane] = s64
        w_by[672 + lane] = s65
        w_by[704 + lane] = s66
        w_by[736 + lane] = s85
        w_by[768 + lane] = s93
        w_by[800 + lane] = s100


@straight
def _joints_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of derivatives of a limb's equations by its joint (0 operations)."""
    for lane in range(n):
        s222_now_by = w_by[1216 + lane]
        w_by[832 + lane] = s222_now_by


@straight
def _inverse_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of minus the inverse of the derivatives, row by row; how far the equations are from dependent (1241 operations)."""
    for lane in range(n):
        J00_0_now = w[640 + lane]
        J00_1_now = w[672 + lane]
        J00_2_now = w[704 + lane]
        J00_3_now = w[736 + lane]
        J00_4_now = w[768 + lane]
        J00_5_now = w[800 + lane]
        J10_0_now = w[2304 + lane]
        J10_1_now = w[2336 + lane]
        J10_2_now = w[2368 + lane]
        J10_3_now = w[2400 + lane]
        J10_4_now = w[2432 + lane]
        J10_5_now = w[2464 + lane]
        J20_0_now = w[3968 + lane]
        J20_1_now = w[4000 + lane]
        J20_2_now = w[4032 + lane]
        J20_3_now = w[4064 + lane]
        J20_4_now = w[4096 + lane]
        J20_5_now = w[4128 + lane]
        J30_0_now = w[5632 + lane]
        J30_1_now = w[5664 + lane]
        J30_2_now = w[5696 + lane]
        J30_3_now = w[5728 + lane]
        J30_4_now = w[5760 + lane]
        J30_5_now = w[5792 + lane]
        J40_0_now = w[7296 + lane]
        J40_1_now = w[7328 + lane]
        J40_2_now = w[7360 + lane]
        J40_3_now = w[7392 + lane]
        J40_4_now = w[7424 + lane]
        J40_5_now = w[7456 + lane]
        J50_0_now = w[8960 + lane]
        J50_1_now = w[8992 + lane]
        J50_2_now = w[9024 + lane]
        J50_3_now = w[9056 + lane]
        J50_4_now = w[9088 + lane]
        J50_5_now = w[9120 + lane]
        J00_0_now_by = w_by[640 + lane]
        J00_1_now_by = w_by[672 + lane]
        J00_2_now_by = w_by[704 + lane]
        J00_3_now_by = w_by[736 + lane]
        J00_4_now_by = w_by[768 + lane]
        J00_5_now_by = w_by[800 + lane]
        J10_0_now_by = w_by[2304 + lane]
        J10_1_now_by = w_by[2336 + lane]
        J10_2_now_by = w_by[2368 + lane]
        J10_3_now_by = w_by[2400 + lane]
        J10_4_now_by = w_by[2432 + lane]
        J10_5_now_by = w_by[2464 + lane]
        J20_0_now_by = w_by[3968 + lane]
        J20_1_now_by = w_by[4000 + lane]
        J20_2_now_by = w_by[4032 + lane]
        J20_3_now_by = w_by[4064 + lane]
        J20_4_now_by = w_by[4096 + lane]
        J20_5_now_by = w_by[4128 + lane]
        J30_0_now_by = w_by[5632 + lane]
        J30_1_now_by = w_by[5664 + lane]
        J30_2_now_by = w_by[5696 + lane]
        J30_3_now_by = w_by[5728 + lane]
        J30_4_now_by = w_by[5760 + lane]
        J30_5_now_by = w_by[5792 + lane]
        J40_0_now_by = w_by[7296 + lane]
        J40_1_now_by = w_by[7328 + lane]
        J40_2_now_by = w_by[7360 + lane]
        J40_3_now_by = w_by[7392 + lane]
        J40_4_now_by = w_by[7424 + lane]
        J40_5_now_by = w_by[7456 + lane]
        J50_0_now_by = w_by[8960 + lane]
        J50_1_now_by = w_by[8992 + lane]
        J50_2_now_by = w_by[9024 + lane]
        J50_3_now_by = w_by[9056 + lane]
        J50_4_now_by = w_by[9088 + lane]
        J50_5_now_by = w_by[9120 + lane]
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
        G_inv_00_now = G_by_00_now*G_cof_00_now
        G_inv_01_now = G_by_00_now*G_cof_10_now
        G_inv_02_now = G_by_00_now*G_cof_20_now
        G_inv_10_now = G_by_00_now*G_cof_01_now
        G_inv_11_now = G_by_00_now*G_cof_11_now
        G_inv_12_now = G_by_00_now*G_cof_21_now
        G_inv_20_now = G_by_00_now*G_cof_02_now
        G_inv_21_now = G_by_00_now*G_cof_12_now
        G_inv_22_now = G_by_00_now*G_cof_22_now
        U_00_now = G_inv_00_now*J00_3_now + G_inv_01_now*J10_3_now + G_inv_02_now*J20_3_now
        U_01_now = G_inv_00_now*J00_4_now + G_inv_01_now*J10_4_now + G_inv_02_now*J20_4_now
        U_02_now = G_inv_00_now*J00_5_now + G_inv_01_now*J10_5_now + G_inv_02_now*J20_5_now
        U_10_now = G_inv_10_now*J00_3_now + G_inv_11_now*J10_3_now + G_inv_12_now*J20_3_now
        U_11_now = G_inv_10_now*J00_4_now + G_inv_11_now*J10_4_now + G_inv_12_now*J20_4_now
        U_12_now = G_inv_10_now*J00_5_now + G_inv_11_now*J10_5_now + G_inv_12_now*J20_5_now
        U_20_now = G_inv_20_now*J00_3_now + G_inv_21_now*J10_3_now + G_inv_22_now*J20_3_now
        U_21_now = G_inv_20_now*J00_4_now + G_inv_21_now*J10_4_now + G_inv_22_now*J20_4_now
        U_22_now = G_inv_20_now*J00_5_now + G_inv_21_now*J10_5_now + G_inv_22_now*J20_5_now
        S_00_now = -J30_0_now*U_00_now - J30_1_now*U_10_now - J30_2_now*U_20_now + J30_3_now
        S_01_now = -J30_0_now*U_01_now - J30_1_now*U_11_now - J30_2_now*U_21_now + J30_4_now
        S_02_now = -J30_0_now*U_02_now - J30_1_now*U_12_now - J30_2_now*U_22_now + J30_5_now
        S_10_now = -J40_0_now*U_00_now - J40_1_now*U_10_now - J40_2_now*U_20_now + J40_3_now
        S_11_now = -J40_0_now*U_01_now - J40_1_now*U_11_now - J40_2_now*U_21_now + J40_4_now
        S_12_now = -J40_0_now*U_02_now - J40_1_now*U_12_now - J40_2_now*U_22_now + J40_5_now
        S_20_now = -J50_0_now*U_00_now - J50_1_now*U_10_now - J50_2_now*U_20_now + J50_3_now
        S_21_now = -J50_0_now*U_01_now - J50_1_now*U_11_now - J50_2_now*U_21_now + J50_4_now
        S_22_now = -J50_0_now*U_02_now - J50_1_now*U_12_now - J50_2_now*U_22_now + J50_5_now
        Si_cof_00_now = S_11_now*S_22_now - S_12_now*S_21_now
        Si_cof_01_now = -S_10_now*S_22_now + S_12_now*S_20_now
        Si_cof_02_now = S_10_now*S_21_now - S_11_now*S_20_now
        Si_cof_10_now = -S_01_now*S_22_now + S_02_now*S_21_now
        Si_cof_11_now = S_00_now*S_22_now - S_02_now*S_20_now
        Si_cof_12_now = -S_00_now*S_21_now + S_01_now*S_20_now
        Si_cof_20_now = S_01_now*S_12_now - S_02_now*S_11_now
        Si_cof_21_now = -S_00_now*S_12_now + S_02_now*S_10_now
        Si_cof_22_now = S_00_now*S_11_now - S_01_now*S_10_now
        Si_det_00_now = S_00_now*Si_cof_00_now + S_01_now*Si_cof_01_now + S_02_now*Si_cof_02_now
        Si_by_00_now = (1.0 / Si_det_00_now)
        Si_inv_00_now = Si_by_00_now*Si_cof_00_now
        Si_inv_01_now = Si_by_00_now*Si_cof_10_now
        Si_inv_02_now = Si_by_00_now*Si_cof_20_now
        Si_inv_10_now = Si_by_00_now*Si_cof_01_now
        Si_inv_11_now = Si_by_00_now*Si_cof_11_now
        Si_inv_12_now = Si_by_00_now*Si_cof_21_now
        Si_inv_20_now = Si_by_00_now*Si_cof_02_now
        Si_inv_21_now = Si_by_00_now*Si_cof_12_now
        Si_inv_22_now = Si_by_00_now*Si_cof_22_now
        s193_now = -J30_0_now*Si_inv_00_now - J40_0_now*Si_inv_01_now - J50_0_now*Si_inv_02_now
        s198_now = -J30_1_now*Si_inv_00_now - J40_1_now*Si_inv_01_now - J50_1_now*Si_inv_02_now
        s203_now = -J30_2_now*Si_inv_00_now - J40_2_now*Si_inv_01_now - J50_2_now*Si_inv_02_now
        V_00_now = G_inv_00_now*s193_now + G_inv_10_now*s198_now + G_inv_20_now*s203_now
        V_01_now = G_inv_01_now*s193_now + G_inv_11_now*s198_now + G_inv_21_now*s203_now
        V_02_now = G_inv_02_now*s193_now + G_inv_12_now*s198_now + G_inv_22_now*s203_now
        s217_now = -J30_0_now*Si_inv_10_now - J40_0_now*Si_inv_11_now - J50_0_now*Si_inv_12_now
        s222_now = -J30_1_now*Si_inv_10_now - J40_1_now*Si_inv_11_now - J50_1_now*Si_inv_12_now
        s227_now = -J30_2_now*Si_inv_10_now - J40_2_now*Si_inv_11_now - J50_2_now*Si_inv_12_now
        V_10_now = G_inv_00_now*s217_now + G_inv_10_now*s222_now + G_inv_20_now*s227_now
        V_11_now = G_inv_01_now*s217_now + G_inv_11_now*s222_now + G_inv_21_now*s227_now
        V_12_now = G_inv_02_now*s217_now + G_inv_12_now*s222_now + G_inv_22_now*s227_now
        s241_now = -J30_0_now*Si_inv_20_now - J40_0_now*Si_inv_21_now - J50_0_now*Si_inv_22_now
        s246_now = -J30_1_now*Si_inv_20_now - J40_1_now*Si_inv_21_now - J50_1_now*Si_inv_22_now
        s251_now = -J30_2_now*Si_inv_20_now - J40_2_now*Si_inv_21_now - J50_2_now*Si_inv_22_now
        V_20_now = G_inv_00_now*s241_now + G_inv_10_now*s246_now + G_inv_20_now*s251_now
        V_21_now = G_inv_01_now*s241_now + G_inv_11_now*s246_now + G_inv_21_now*s251_now
        V_22_now = G_inv_02_now*s241_now + G_inv_12_now*s246_now + G_inv_22_now*s251_now
        s342_now = (J10_0_now * J10_0_now) + (J10_1_now * J10_1_now) + (J10_2_now * J10_2_now)
        s346_now = (J20_0_now * J20_0_now) + (J20_1_now * J20_1_now) + (J20_2_now * J20_2_now)
        s310 = (J00_0_now * J00_0_now) + (J00_1_now * J00_1_now) + (J00_2_now * J00_2_now)
        s357_now = (J40_3_now * J40_3_now) + (J40_4_now * J40_4_now) + (J40_5_now * J40_5_now)
        s361_now = (J50_3_now * J50_3_now) + (J50_4_now * J50_4_now) + (J50_5_now * J50_5_now)
        s325 = (J30_3_now * J30_3_now) + (J30_4_now * J30_4_now) + (J30_5_now * J30_5_now)
        s334 = J10_1_now*J20_2_now_by + J10_1_now_by*J20_2_now - J10_2_now*J20_1_now_by - J10_2_now_by*J20_1_now
        s341 = -J10_0_now*J20_2_now_by - J10_0_now_by*J20_2_now + J10_2_now*J20_0_now_by + J10_2_now_by*J20_0_now
        s348 = J10_0_now*J20_1_now_by + J10_0_now_by*J20_1_now - J10_1_now*J20_0_now_by - J10_1_now_by*J20_0_now
        s400 = G_cof_00_now*J00_0_now_by + G_cof_01_now*J00_1_now_by + G_cof_02_now*J00_2_now_by + J00_0_now*s334 + J00_1_now*s341 + J00_2_now*s348
        s402 = -s400/(G_det_00_now * G_det_00_now)
        s405 = G_by_00_now*s334 + G_cof_00_now*s402
        s408 = G_by_00_now*(-J00_1_now*J20_2_now_by - J00_1_now_by*J20_2_now + J00_2_now*J20_1_now_by + J00_2_now_by*J20_1_now) + G_cof_10_now*s402
        s411 = G_by_00_now*(J00_1_now*J10_2_now_by + J00_1_now_by*J10_2_now - J00_2_now*J10_1_now_by - J00_2_now_by*J10_1_now) + G_cof_20_now*s402
        s414 = G_by_00_now*s341 + G_cof_01_now*s402
        s417 = G_by_00_now*(J00_0_now*J20_2_now_by + J00_0_now_by*J20_2_now - J00_2_now*J20_0_now_by - J00_2_now_by*J20_0_now) + G_cof_11_now*s402
        s420 = G_by_00_now*(-J00_0_now*J10_2_now_by - J00_0_now_by*J10_2_now + J00_2_now*J10_0_now_by + J00_2_now_by*J10_0_now) + G_cof_21_now*s402
        s423 = G_by_00_now*s348 + G_cof_02_now*s402
        s426 = G_by_00_now*(-J00_0_now*J20_1_now_by - J00_0_now_by*J20_1_now + J00_1_now*J20_0_now_by + J00_1_now_by*J20_0_now) + G_cof_12_now*s402
        s429 = G_by_00_now*(J00_0_now*J10_1_now_by + J00_0_now_by*J10_1_now - J00_1_now*J10_0_now_by - J00_1_now_by*J10_0_now) + G_cof_22_now*s402
        s439 = G_inv_00_now*J00_3_now_by + G_inv_01_now*J10_3_now_by + G_inv_02_now*J20_3_now_by + J00_3_now*s405 + J10_3_now*s408 + J20_3_now*s411
        s449 = G_inv_00_now*J00_4_now_by + G_inv_01_now*J10_4_now_by + G_inv_02_now*J20_4_now_by + J00_4_now*s405 + J10_4_now*s408 + J20_4_now*s411
        s459 = G_inv_00_now*J00_5_now_by + G_inv_01_now*J10_5_now_by + G_inv_02_now*J20_5_now_by + J00_5_now*s405 + J10_5_now*s408 + J20_5_now*s411
        s469 = G_inv_10_now*J00_3_now_by + G_inv_11_now*J10_3_now_by + G_inv_12_now*J20_3_now_by + J00_3_now*s414 + J10_3_now*s417 + J20_3_now*s420
        s479 = G_inv_10_now*J00_4_now_by + G_inv_11_now*J10_4_now_by + G_inv_12_now*J20_4_now_by + J00_4_now*s414 + J10_4_now*s417 + J20_4_now*s420
        s489 = G_inv_10_now*J00_5_now_by + G_inv_11_now*J10_5_now_by + G_inv_12_now*J20_5_now_by + J00_5_now*s414 + J10_5_now*s417 + J20_5_now*s420
        s499 = G_inv_20_now*J00_3_now_by + G_inv_21_now*J10_3_now_by + G_inv_22_now*J20_3_now_by + J00_3_now*s423 + J10_3_now*s426 + J20_3_now*s429
        s509 = G_inv_20_now*J00_4_now_by + G_inv_21_now*J10_4_now_by + G_inv_22_now*J20_4_now_by + J00_4_now*s423 + J10_4_now*s426 + J20_4_now*s429
        s519 = G_inv_20_now*J00_5_now_by + G_inv_21_now*J10_5_now_by + G_inv_22_now*J20_5_now_by + J00_5_now*s423 + J10_5_now*s426 + J20_5_now*s429
        s529 = -J30_0_now*s439 - J30_0_now_by*U_00_now - J30_1_now*s469 - J30_1_now_by*U_10_now - J30_2_now*s499 - J30_2_now_by*U_20_now + J30_3_now_by
        s539 = -J30_0_now*s449 - J30_0_now_by*U_01_now - J30_1_now*s479 - J30_1_now_by*U_11_now - J30_2_now*s509 - J30_2_now_by*U_21_now + J30_4_now_by
        s549 = -J30_0_now*s459 - J30_0_now_by*U_02_now - J30_1_now*s489 - J30_1_now_by*U_12_now - J30_2_now*s519 - J30_2_now_by*U_22_now + J30_5_now_by
        s559 = -J40_0_now*s439 - J40_0_now_by*U_00_now - J40_1_now*s469 - J40_1_now_by*U_10_now - J40_2_now*s499 - J40_2_now_by*U_20_now + J40_3_now_by
        s569 = -J40_0_now*s449 - J40_0_now_by*U_01_now - J40_1_now*s479 - J40_1_now_by*U_11_now - J40_2_now*s509 - J40_2_now_by*U_21_now + J40_4_now_by
        s579 = -J40_0_now*s459 - J40_0_now_by*U_02_now - J40_1_now*s489 - J40_1_now_by*U_12_now - J40_2_now*s519 - J40_2_now_by*U_22_now + J40_5_now_by
        s589 = -J50_0_now*s439 - J50_0_now_by*U_00_now - J50_1_now*s469 - J50_1_now_by*U_10_now - J50_2_now*s499 - J50_2_now_by*U_20_now + J50_3_now_by
        s599 = -J50_0_now*s449 - J50_0_now_by*U_01_now - J50_1_now*s479 - J50_1_now_by*U_11_now - J50_2_now*s509 - J50_2_now_by*U_21_now + J50_4_now_by
        s609 = -J50_0_now*s459 - J50_0_now_by*U_02_now - J50_1_now*s489 - J50_1_now_by*U_12_now - J50_2_now*s519 - J50_2_now_by*U_22_now + J50_5_now_by
        s616 = S_11_now*s609 - S_12_now*s599 - S_21_now*s579 + S_22_now*s569
        s623 = -S_10_now*s609 + S_12_now*s589 + S_20_now*s579 - S_22_now*s559
        s630 = S_10_now*s599 - S_11_now*s589 - S_20_now*s569 + S_21_now*s559
        s682 = S_00_now*s616 + S_01_now*s623 + S_02_now*s630 + Si_cof_00_now*s529 + Si_cof_01_now*s539 + Si_cof_02_now*s549
        s684 = -s682/(Si_det_00_now * Si_det_00_now)
        s687 = Si_by_00_now*s616 + Si_cof_00_now*s684
        s690 = Si_by_00_now*(-S_01_now*s609 + S_02_now*s599 + S_21_now*s549 - S_22_now*s539) + Si_cof_10_now*s684
        s693 = Si_by_00_now*(S_01_now*s579 - S_02_now*s569 - S_11_now*s549 + S_12_now*s539) + Si_cof_20_now*s684
        s696 = Si_by_00_now*s623 + Si_cof_01_now*s684
        s699 = Si_by_00_now*(S_00_now*s609 - S_02_now*s589 - S_20_now*s549 + S_22_now*s529) + Si_cof_11_now*s684
        s702 = Si_by_00_now*(-S_00_now*s579 + S_02_now*s559 + S_10_now*s549 - S_12_now*s529) + Si_cof_21_now*s684
        s705 = Si_by_00_now*s630 + Si_cof_02_now*s684
        s708 = Si_by_00_now*(-S_00_now*s599 + S_01_now*s589 + S_20_now*s539 - S_21_now*s529) + Si_cof_12_now*s684
        s711 = Si_by_00_now*(S_00_now*s569 - S_01_now*s559 - S_10_now*s539 + S_11_now*s529) + Si_cof_22_now*s684
        s721 = -J30_0_now*s687 - J30_0_now_by*Si_inv_00_now - J40_0_now*s690 - J40_0_now_by*Si_inv_01_now - J50_0_now*s693 - J50_0_now_by*Si_inv_02_now
        s731 = -J30_1_now*s687 - J30_1_now_by*Si_inv_00_now - J40_1_now*s690 - J40_1_now_by*Si_inv_01_now - J50_1_now*s693 - J50_1_now_by*Si_inv_02_now
        s741 = -J30_2_now*s687 - J30_2_now_by*Si_inv_00_now - J40_2_now*s690 - J40_2_now_by*Si_inv_01_now - J50_2_now*s693 - J50_2_now_by*Si_inv_02_now
        s751 = G_inv_00_now*s721 + G_inv_10_now*s731 + G_inv_20_now*s741 + s193_now*s405 + s198_now*s414 + s203_now*s423
        s761 = G_inv_01_now*s721 + G_inv_11_now*s731 + G_inv_21_now*s741 + s193_now*s408 + s198_now*s417 + s203_now*s426
        s771 = G_inv_02_now*s721 + G_inv_12_now*s731 + G_inv_22_now*s741 + s193_now*s411 + s198_now*s420 + s203_now*s429
        s781 = -J30_0_now*s696 - J30_0_now_by*Si_inv_10_now - J40_0_now*s699 - J40_0_now_by*Si_inv_11_now - J50_0_now*s702 - J50_0_now_by*Si_inv_12_now
        s791 = -J30_1_now*s696 - J30_1_now_by*Si_inv_10_now - J40_1_now*s699 - J40_1_now_by*Si_inv_11_now - J50_1_now*s702 - J50_1_now_by*Si_inv_12_now
        s801 = -J30_2_now*s696 - J30_2_now_by*Si_inv_10_now - J40_2_now*s699 - J40_2_now_by*Si_inv_11_now - J50_2_now*s702 - J50_2_now_by*Si_inv_12_now
        s811 = G_inv_00_now*s781 + G_inv_10_now*s791 + G_inv_20_now*s801 + s217_now*s405 + s222_now*s414 + s227_now*s423
        s821 = G_inv_01_now*s781 + G_inv_11_now*s791 + G_inv_21_now*s801 + s217_now*s408 + s222_now*s417 + s227_now*s426
        s831 = G_inv_02_now*s781 + G_inv_12_now*s791 + G_inv_22_now*s801 + s217_now*s411 + s222_now*s420 + s227_now*s429
        s841 = -J30_0_now*s705 - J30_0_now_by*Si_inv_20_now - J40_0_now*s708 - J40_0_now_by*Si_inv_21_now - J50_0_now*s711 - J50_0_now_by*Si_inv_22_now
        s851 = -J30_1_now*s705 - J30_1_now_by*Si_inv_20_now - J40_1_now*s708 - J40_1_now_by*Si_inv_21_now - J50_1_now*s711 - J50_1_now_by*Si_inv_22_now
        s861 = -J30_2_now*s705 - J30_2_now_by*Si_inv_20_now - J40_2_now*s708 - J40_2_now_by*Si_inv_21_now - J50_2_now*s711 - J50_2_now_by*Si_inv_22_now
        s871 = G_inv_00_now*s841 + G_inv_10_now*s851 + G_inv_20_now*s861 + s241_now*s405 + s246_now*s414 + s251_now*s423
        s881 = G_inv_01_now*s841 + G_inv_11_now*s851 + G_inv_21_now*s861 + s241_now*s408 + s246_now*s417 + s251_now*s426
        s891 = G_inv_02_now*s841 + G_inv_12_now*s851 + G_inv_22_now*s861 + s241_now*s411 + s246_now*s420 + s251_now*s429
        s901 = U_00_now*s751 + U_01_now*s811 + U_02_now*s871 + V_00_now*s439 + V_10_now*s449 + V_20_now*s459 - s405
        s911 = U_00_now*s761 + U_01_now*s821 + U_02_now*s881 + V_01_now*s439 + V_11_now*s449 + V_21_now*s459 - s408
        s921 = U_00_now*s771 + U_01_now*s831 + U_02_now*s891 + V_02_now*s439 + V_12_now*s449 + V_22_now*s459 - s411
        s931 = Si_inv_00_now*s439 + Si_inv_10_now*s449 + Si_inv_20_now*s459 + U_00_now*s687 + U_01_now*s696 + U_02_now*s705
        s941 = Si_inv_01_now*s439 + Si_inv_11_now*s449 + Si_inv_21_now*s459 + U_00_now*s690 + U_01_now*s699 + U_02_now*s708
        s951 = Si_inv_02_now*s439 + Si_inv_12_now*s449 + Si_inv_22_now*s459 + U_00_now*s693 + U_01_now*s702 + U_02_now*s711
        s961 = U_10_now*s751 + U_11_now*s811 + U_12_now*s871 + V_00_now*s469 + V_10_now*s479 + V_20_now*s489 - s414
        s971 = U_10_now*s761 + U_11_now*s821 + U_12_now*s881 + V_01_now*s469 + V_11_now*s479 + V_21_now*s489 - s417
        s981 = U_10_now*s771 + U_11_now*s831 + U_12_now*s891 + V_02_now*s469 + V_12_now*s479 + V_22_now*s489 - s420
        s991 = Si_inv_00_now*s469 + Si_inv_10_now*s479 + Si_inv_20_now*s489 + U_10_now*s687 + U_11_now*s696 + U_12_now*s705
        s1001 = Si_inv_01_now*s469 + Si_inv_11_now*s479 + Si_inv_21_now*s489 + U_10_now*s690 + U_11_now*s699 + U_12_now*s708
        s1011 = Si_inv_02_now*s469 + Si_inv_12_now*s479 + Si_inv_22_now*s489 + U_10_now*s693 + U_11_now*s702 + U_12_now*s711
        s1021 = U_20_now*s751 + U_21_now*s811 + U_22_now*s871 + V_00_now*s499 + V_10_now*s509 + V_20_now*s519 - s423
        s1031 = U_20_now*s761 + U_21_now*s821 + U_22_now*s881 + V_01_now*s499 + V_11_now*s509 + V_21_now*s519 - s426
        s1041 = U_20_now*s771 + U_21_now*s831 + U_22_now*s891 + V_02_now*s499 + V_12_now*s509 + V_22_now*s519 - s429
        s1051 = Si_inv_00_now*s499 + Si_inv_10_now*s509 + Si_inv_20_now*s519 + U_20_now*s687 + U_21_now*s696 + U_22_now*s705
        s1061 = Si_inv_01_now*s499 + Si_inv_11_now*s509 + Si_inv_21_now*s519 + U_20_now*s690 + U_21_now*s699 + U_22_now*s708
        s1071 = Si_inv_02_now*s499 + Si_inv_12_now*s509 + Si_inv_22_now*s519 + U_20_now*s693 + U_21_now*s702 + U_22_now*s711
        s1098 = -1.0e-12*s342_now*s346_now*(2*J00_0_now*J00_0_now_by + 2*J00_1_now*J00_1_now_by + 2*J00_2_now*J00_2_now_by)
        s1099 = -1.0e-12*s310*s346_now*(2*J10_0_now*J10_0_now_by + 2*J10_1_now*J10_1_now_by + 2*J10_2_now*J10_2_now_by)
        s1100 = -1.0e-12*s310*s342_now*(2*J20_0_now*J20_0_now_by + 2*J20_1_now*J20_1_now_by + 2*J20_2_now*J20_2_now_by)
        s1102 = 2*G_det_00_now*s400 + s1098 + s1099 + s1100
        s1129 = -1.0e-12*s357_now*s361_now*(2*J30_3_now*J30_3_now_by + 2*J30_4_now*J30_4_now_by + 2*J30_5_now*J30_5_now_by)
        s1130 = -1.0e-12*s325*s361_now*(2*J40_3_now*J40_3_now_by + 2*J40_4_now*J40_4_now_by + 2*J40_5_now*J40_5_now_by)
        s1131 = -1.0e-12*s325*s357_now*(2*J50_3_now*J50_3_now_by + 2*J50_4_now*J50_4_now_by + 2*J50_5_now*J50_5_now_by)
        s1133 = 2*Si_det_00_now*s682 + s1129 + s1130 + s1131
        w_by[10272 + lane] = s901
        w_by[10304 + lane] = s911
        w_by[10336 + lane] = s921
        w_by[10368 + lane] = s931
        w_by[10400 + lane] = s941
        w_by[10432 + lane] = s951
        w_by[10464 + lane] = s961
        w_by[10496 + lane] = s971
        w_by[10528 + lane] = s981
        w_by[10560 + lane] = s991
        w_by[10592 + lane] = s1001
        w_by[10624 + lane] = s1011
        w_by[10656 + lane] = s1021
        w_by[10688 + lane] = s1031
        w_by[10720 + lane] = s1041
        w_by[10752 + lane] = s1051
        w_by[10784 + lane] = s1061
        w_by[10816 + lane] = s1071
        w_by[10848 + lane] = -s751
        w_by[10880 + lane] = -s761
        w_by[10912 + lane] = -s771
        w_by[10944 + lane] = -s687
        w_by[10976 + lane] = -s690
        w_by[11008 + lane] = -s693
        w_by[11040 + lane] = -s811
        w_by[11072 + lane] = -s821
        w_by[11104 + lane] = -s831
        w_by[11136 + lane] = -s696
        w_by[11168 + lane] = -s699
        w_by[11200 + lane] = -s702
        w_by[11232 + lane] = -s871
        w_by[11264 + lane] = -s881
        w_by[11296 + lane] = -s891
        w_by[11328 + lane] = -s705
        w_by[11360 + lane] = -s708
        w_by[11392 + lane] = -s711
        w_by[11424 + lane] = s1102
        w_by[11456 + lane] = s1133


@straight
def _move_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of how the platform moves with each joint, and how it does (282 operations)."""
    for lane in range(n):
        M_0_0_now = w[10272 + lane]
        M_0_1_now = w[10304 + lane]
        M_0_2_now = w[10336 + lane]
        M_0_3_now = w[10368 + lane]
        M_0_4_now = w[10400 + lane]
        M_0_5_now = w[10432 + lane]
        M_1_0_now = w[10464 + lane]
        M_1_1_now = w[10496 + lane]
        M_1_2_now = w[10528 + lane]
        M_1_3_now = w[10560 + lane]
        M_1_4_now = w[10592 + lane]
        M_1_5_now = w[10624 + lane]
        M_2_0_now = w[10656 + lane]
        M_2_1_now = w[10688 + lane]
        M_2_2_now = w[10720 + lane]
        M_2_3_now = w[10752 + lane]
        M_2_4_now = w[10784 + lane]
        M_2_5_now = w[10816 + lane]
        M_3_0_now = w[10848 + lane]
        M_3_1_now = w[10880 + lane]
        M_3_2_now = w[10912 + lane]
        M_3_3_now = w[10944 + lane]
        M_3_4_now = w[10976 + lane]
        M_3_5_now = w[11008 + lane]
        M_4_0_now = w[11040 + lane]
        M_4_1_now = w[11072 + lane]
        M_4_2_now = w[11104 + lane]
        M_4_3_now = w[11136 + lane]
        M_4_4_now = w[11168 + lane]
        M_4_5_now = w[11200 + lane]
        M_5_0_now = w[11232 + lane]
        M_5_1_now = w[11264 + lane]
        M_5_2_now = w[11296 + lane]
        M_5_3_now = w[11328 + lane]
        M_5_4_now = w[11360 + lane]
        M_5_5_now = w[11392 + lane]
        q_t_0_now = d[0 + lane]
        Q_0_now = w[832 + lane]
        q_t_1_now = d[1248 + lane]
        Q_1_now = w[2496 + lane]
        q_t_2_now = d[2496 + lane]
        Q_2_now = w[4160 + lane]
        q_t_3_now = d[3744 + lane]
        Q_3_now = w[5824 + lane]
        q_t_4_now = d[4992 + lane]
        Q_4_now = w[7488 + lane]
        q_t_5_now = d[6240 + lane]
        Q_5_now = w[9152 + lane]
        M_0_0_now_by = w_by[10272 + lane]
        M_0_1_now_by = w_by[10304 + lane]
        M_0_2_now_by = w_by[10336 + lane]
        M_0_3_now_by = w_by[10368 + lane]
        M_0_4_now_by = w_by[10400 + lane]
        M_0_5_now_by = w_by[10432 + lane]
        M_1_0_now_by = w_by[10464 + lane]
        M_1_1_now_by = w_by[10496 + lane]
        M_1_2_now_by = w_by[10528 + lane]
        M_1_3_now_by = w_by[10560 + lane]
        M_1_4_now_by = w_by[10592 + lane]
        M_1_5_now_by = w_by[10624 + lane]
        M_2_0_now_by = w_by[10656 + lane]
        M_2_1_now_by = w_by[10688 + lane]
        M_2_2_now_by = w_by[10720 + lane]
        M_2_3_now_by = w_by[10752 + lane]
        M_2_4_now_by = w_by[10784 + lane]
        M_2_5_now_by = w_by[10816 + lane]
        M_3_0_now_by = w_by[10848 + lane]
        M_3_1_now_by = w_by[10880 + lane]
        M_3_2_now_by = w_by[10912 + lane]
        M_3_3_now_by = w_by[10944 + lane]
        M_3_4_now_by = w_by[10976 + lane]
        M_3_5_now_by = w_by[11008 + lane]
        M_4_0_now_by = w_by[11040 + lane]
        M_4_1_now_by = w_by[11072 + lane]
        M_4_2_now_by = w_by[11104 + lane]
        M_4_3_now_by = w_by[11136 + lane]
        M_4_4_now_by = w_by[11168 + lane]
        M_4_5_now_by = w_by[11200 + lane]
        M_5_0_now_by = w_by[11232 + lane]
        M_5_1_now_by = w_by[11264 + lane]
        M_5_2_now_by = w_by[11296 + lane]
        M_5_3_now_by = w_by[11328 + lane]
        M_5_4_now_by = w_by[11360 + lane]
        M_5_5_now_by = w_by[11392 + lane]
        q_t_0_now_by = d_by[0 + lane]
        Q_0_now_by = w_by[832 + lane]
        q_t_1_now_by = d_by[1248 + lane]
        Q_1_now_by = w_by[2496 + lane]
        q_t_2_now_by = d_by[2496 + lane]
        Q_2_now_by = w_by[4160 + lane]
        q_t_3_now_by = d_by[3744 + lane]
        Q_3_now_by = w_by[5824 + lane]
        q_t_4_now_by = d_by[4992 + lane]
        Q_4_now_by = w_by[7488 + lane]
        q_t_5_now_by = d_by[6240 + lane]
        Q_5_now_by = w_by[9152 + lane]
        V_0_0_now = M_0_0_now*Q_0_now
        V_0_1_now = M_0_1_now*Q_1_now
        V_0_2_now = M_0_2_now*Q_2_now
        V_0_3_now = M_0_3_now*Q_3_now
        V_0_4_now = M_0_4_now*Q_4_now
        V_0_5_now = M_0_5_now*Q_5_now
        V_1_0_now = M_1_0_now*Q_0_now
        V_1_1_now = M_1_1_now*Q_1_now
        V_1_2_now = M_1_2_now*Q_2_now
        V_1_3_now = M_1_3_now*Q_3_now
        V_1_4_now = M_1_4_now*Q_4_now
        V_1_5_now = M_1_5_now*Q_5_now
        V_2_0_now = M_2_0_now*Q_0_now
        V_2_1_now = M_2_1_now*Q_1_now
        V_2_2_now = M_2_2_now*Q_2_now
        V_2_3_now = M_2_3_now*Q_3_now
        V_2_4_now = M_2_4_now*Q_4_now
        V_2_5_now = M_2_5_now*Q_5_now
        V_3_0_now = M_3_0_now*Q_0_now
        V_3_1_now = M_3_1_now*Q_1_now
        V_3_2_now = M_3_2_now*Q_2_now
        V_3_3_now = M_3_3_now*Q_3_now
        V_3_4_now = M_3_4_now*Q_4_now
        V_3_5_now = M_3_5_now*Q_5_now
        V_4_0_now = M_4_0_now*Q_0_now
        V_4_1_now = M_4_1_now*Q_1_now
        V_4_2_now = M_4_2_now*Q_2_now
        V_4_3_now = M_4_3_now*Q_3_now
        V_4_4_now = M_4_4_now*Q_4_now
        V_4_5_now = M_4_5_now*Q_5_now
        V_5_0_now = M_5_0_now*Q_0_now
        V_5_1_now = M_5_1_now*Q_1_now
        V_5_2_now = M_5_2_now*Q_2_now
        V_5_3_now = M_5_3_now*Q_3_now
        V_5_4_now = M_5_4_now*Q_4_now
        V_5_5_now = M_5_5_now*Q_5_now
        s80 = M_0_0_now*Q_0_now_by + M_0_0_now_by*Q_0_now
        s83 = M_0_1_now*Q_1_now_by + M_0_1_now_by*Q_1_now
        s86 = M_0_2_now*Q_2_now_by + M_0_2_now_by*Q_2_now
        s89 = M_0_3_now*Q_3_now_by + M_0_3_now_by*Q_3_now
        s92 = M_0_4_now*Q_4_now_by + M_0_4_now_by*Q_4_now
        s95 = M_0_5_now*Q_5_now_by + M_0_5_now_by*Q_5_now
        s98 = M_1_0_now*Q_0_now_by + M_1_0_now_by*Q_0_now
        s101 = M_1_1_now*Q_1_now_by + M_1_1_now_by*Q_1_now
        s104 = M_1_2_now*Q_2_now_by + M_1_2_now_by*Q_2_now
        s107 = M_1_3_now*Q_3_now_by + M_1_3_now_by*Q_3_now
        s110 = M_1_4_now*Q_4_now_by + M_1_4_now_by*Q_4_now
        s113 = M_1_5_now*Q_5_now_by + M_1_5_now_by*Q_5_now
        s116 = M_2_0_now*Q_0_now_by + M_2_0_now_by*Q_0_now
        s119 = M_2_1_now*Q_1_now_by + M_2_1_now_by*Q_1_now
        s122 = M_2_2_now*Q_2_now_by + M_2_2_now_by*Q_2_now
        s125 = M_2_3_now*Q_3_now_by + M_2_3_now_by*Q_3_now
        s128 = M_2_4_now*Q_4_now_by + M_2_4_now_by*Q_4_now
        s131 = M_2_5_now*Q_5_now_by + M_2_5_now_by*Q_5_now
        s134 = M_3_0_now*Q_0_now_by + M_3_0_now_by*Q_0_now
        s137 = M_3_1_now*Q_1_now_by + M_3_1_now_by*Q_1_now
        s140 = M_3_2_now*Q_2_now_by + M_3_2_now_by*Q_2_now
        s143 = M_3_3_now*Q_3_now_by + M_3_3_now_by*Q_3_now
        s146 = M_3_4_now*Q_4_now_by + M_3_4_now_by*Q_4_now
        s149 = M_3_5_now*Q_5_now_by + M_3_5_now_by*Q_5_now
        s152 = M_4_0_now*Q_0_now_by + M_4_0_now_by*Q_0_now
        s155 = M_4_1_now*Q_1_now_by + M_4_1_now_by*Q_1_now
        s158 = M_4_2_now*Q_2_now_by + M_4_2_now_by*Q_2_now
        s161 = M_4_3_now*Q_3_now_by + M_4_3_now_by*Q_3_now
        s164 = M_4_4_now*Q_4_now_by + M_4_4_now_by*Q_4_now
        s167 = M_4_5_now*Q_5_now_by + M_4_5_now_by*Q_5_now
        s170 = M_5_0_now*Q_0_now_by + M_5_0_now_by*Q_0_now
        s173 = M_5_1_now*Q_1_now_by + M_5_1_now_by*Q_1_now
        s176 = M_5_2_now*Q_2_now_by + M_5_2_now_by*Q_2_now
        s179 = M_5_3_now*Q_3_now_by + M_5_3_now_by*Q_3_now
        s182 = M_5_4_now*Q_4_now_by + M_5_4_now_by*Q_4_now
        s185 = M_5_5_now*Q_5_now_by + M_5_5_now_by*Q_5_now
        s194 = V_0_2_now*q_t_2_now_by + q_t_2_now*s86
        s197 = V_0_3_now*q_t_3_now_by + q_t_3_now*s89
        s200 = V_0_4_now*q_t_4_now_by + q_t_4_now*s92
        s203 = V_0_5_now*q_t_5_now_by + q_t_5_now*s95
        s204 = V_0_0_now*q_t_0_now_by + V_0_1_now*q_t_1_now_by + q_t_0_now*s80 + q_t_1_now*s83 + s194 + s197 + s200 + s203
        s213 = V_1_2_now*q_t_2_now_by + q_t_2_now*s104
        s216 = V_1_3_now*q_t_3_now_by + q_t_3_now*s107
        s219 = V_1_4_now*q_t_4_now_by + q_t_4_now*s110
        s222 = V_1_5_now*q_t_5_now_by + q_t_5_now*s113
        s223 = V_1_0_now*q_t_0_now_by + V_1_1_now*q_t_1_now_by + q_t_0_now*s98 + q_t_1_now*s101 + s213 + s216 + s219 + s222
        s232 = V_2_2_now*q_t_2_now_by + q_t_2_now*s122
        s235 = V_2_3_now*q_t_3_now_by + q_t_3_now*s125
        s238 = V_2_4_now*q_t_4_now_by + q_t_4_now*s128
        s241 = V_2_5_now*q_t_5_now_by + q_t_5_now*s131
        s242 = V_2_0_now*q_t_0_now_by + V_2_1_now*q_t_1_now_by + q_t_0_now*s116 + q_t_1_now*s119 + s232 + s235 + s238 + s241
        s251 = V_3_2_now*q_t_2_now_by + q_t_2_now*s140
        s254 = V_3_3_now*q_t_3_now_by + q_t_3_now*s143
        s257 = V_3_4_now*q_t_4_now_by + q_t_4_now*s146
        s260 = V_3_5_now*q_t_5_now_by + q_t_5_now*s149
        s261 = V_3_0_now*q_t_0_now_by + V_3_1_now*q_t_1_now_by + q_t_0_now*s134 + q_t_1_now*s137 + s251 + s254 + s257 + s260
        s270 = V_4_2_now*q_t_2_now_by + q_t_2_now*s158
        s273 = V_4_3_now*q_t_3_now_by + q_t_3_now*s161
        s276 = V_4_4_now*q_t_4_now_by + q_t_4_now*s164
        s279 = V_4_5_now*q_t_5_now_by + q_t_5_now*s167
        s280 = V_4_0_now*q_t_0_now_by + V_4_1_now*q_t_1_now_by + q_t_0_now*s152 + q_t_1_now*s155 + s270 + s273 + s276 + s279
        s289 = V_5_2_now*q_t_2_now_by + q_t_2_now*s176
        s292 = V_5_3_now*q_t_3_now_by + q_t_3_now*s179
        s295 = V_5_4_now*q_t_4_now_by + q_t_4_now*s182
        s298 = V_5_5_now*q_t_5_now_by + q_t_5_now*s185
        s299 = V_5_0_now*q_t_0_now_by + V_5_1_now*q_t_1_now_by + q_t_0_now*s170 + q_t_1_now*s173 + s289 + s292 + s295 + s298
        s_by[0 + lane] = s80
        s_by[32 + lane] = s83
        s_by[64 + lane] = s86
        s_by[96 + lane] = s89
        s_by[128 + lane] = s92
        s_by[160 + lane] = s95
        s_by[192 + lane] = s98
        s_by[224 + lane] = s101
        s_by[256 + lane] = s104
        s_by[288 + lane] = s107
        s_by[320 + lane] = s110
        s_by[352 + lane] = s113
        s_by[384 + lane] = s116
        s_by[416 + lane] = s119
        s_by[448 + lane] = s122
        s_by[480 + lane] = s125
        s_by[512 + lane] = s128
        s_by[544 + lane] = s131
        s_by[576 + lane] = s134
        s_by[608 + lane] = s137
        s_by[640 + lane] = s140
        s_by[672 + lane] = s143
        s_by[704 + lane] = s146
        s_by[736 + lane] = s149
        s_by[768 + lane] = s152
        s_by[800 + lane] = s155
        s_by[832 + lane] = s158
        s_by[864 + lane] = s161
        s_by[896 + lane] = s164
        s_by[928 + lane] = s167
        s_by[960 + lane] = s170
        s_by[992 + lane] = s173
        s_by[1024 + lane] = s176
        s_by[1056 + lane] = s179
        s_by[1088 + lane] = s182
        s_by[1120 + lane] = s185
        s_by[1152 + lane] = s204
        s_by[1184 + lane] = s223
        s_by[1216 + lane] = s242
        s_by[1248 + lane] = s261
        s_by[1280 + lane] = s280
        s_by[1312 + lane] = s299


@straight
def _curved_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of second derivatives of a limb's equations by time where nothing accelerates (384 operations)."""
    s9_now = k[0]
    s13_now = k[1]
    s15_now = k[2]
    A_x_now = k[3]
    A_y_now = k[4]
    A_z_now = k[5]
    s32_now = k[6]
    s9_now_by = k_by[0]
    s13_now_by = k_by[1]
    s15_now_by = k_by[2]
    A_x_now_by = k_by[3]
    A_y_now_by = k_by[4]
    A_z_now_by = k_by[5]
    s32_now_by = k_by[6]
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        v_px_now = s[1152 + lane]
        v_py_now = s[1184 + lane]
        v_pz_now = s[1216 + lane]
        w_x_now = s[1248 + lane]
        w_y_now = s[1280 + lane]
        w_z_now = s[1312 + lane]
        q_t_now = d[0 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        v_px_now_by = s_by[1152 + lane]
        v_py_now_by = s_by[1184 + lane]
        v_pz_now_by = s_by[1216 + lane]
        w_x_now_by = s_by[1248 + lane]
        w_y_now_by = s_by[1280 + lane]
        w_z_now_by = s_by[1312 + lane]
        q_t_now_by = d_by[0 + lane]
        b_x_now = s9_now - tx_now
        b_y_now = s13_now - ty_now
        b_z_now = s15_now - tz_now
        B_x_now = R_11_now*b_x_now + R_12_now*b_y_now + R_13_now*b_z_now + px_now
        B_y_now = R_21_now*b_x_now + R_22_now*b_y_now + R_23_now*b_z_now + py_now
        B_z_now = R_31_now*b_x_now + R_32_now*b_y_now + R_33_now*b_z_now + pz_now
        d_x_now = -A_x_now + B_x_now
        d_y_now = -A_y_now + B_y_now
        d_z_now = -A_z_now + B_z_now
        s51_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s54_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s57_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s60_now = R_11_now*w_z_now - R_31_now*w_x_now
        s63_now = R_12_now*w_z_now - R_32_now*w_x_now
        s66_now = R_13_now*w_z_now - R_33_now*w_x_now
        s69_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s72_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s75_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s79_now = b_x_now*s51_now + b_y_now*s54_now + b_z_now*s57_now + v_px_now
        s83_now = b_x_now*s60_now + b_y_now*s63_now + b_z_now*s66_now + v_py_now
        s87_now = b_x_now*s69_now + b_y_now*s72_now + b_z_now*s75_now + v_pz_now
        s88_now = q_t_now*s32_now
        s60 = -s66_now*w_z_now + s75_now*w_y_now
        s142_now = b_z_now*s60
        s64 = s57_now*w_z_now - s75_now*w_x_now
        s146_now = b_z_now*s64
        s68 = -s57_now*w_y_now + s66_now*w_x_now
        s150_now = b_z_now*s68
        s72 = -s60_now*w_z_now + s69_now*w_y_now
        s76 = -s63_now*w_z_now + s72_now*w_y_now
        s82 = s51_now*w_z_now - s69_now*w_x_now
        s86 = s54_now*w_z_now - s72_now*w_x_now
        s92 = -s51_now*w_y_now + s60_now*w_x_now
        s96 = -s54_now*w_y_now + s63_now*w_x_now
        s117 = R_11_now*s9_now_by + R_11_now_by*b_x_now + R_12_now*s13_now_by + R_12_now_by*b_y_now + R_13_now*s15_now_by + R_13_now_by*b_z_now + px_now_by
        s127 = R_21_now*s9_now_by + R_21_now_by*b_x_now + R_22_now*s13_now_by + R_22_now_by*b_y_now + R_23_now*s15_now_by + R_23_now_by*b_z_now + py_now_by
        s137 = R_31_now*s9_now_by + R_31_now_by*b_x_now + R_32_now*s13_now_by + R_32_now_by*b_y_now + R_33_now*s15_now_by + R_33_now_by*b_z_now + pz_now_by
        s147 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s154 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s161 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s168 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s175 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s182 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s189 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s196 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s203 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s213 = b_x_now*s147 + b_y_now*s154 + b_z_now*s161 + s13_now_by*s54_now + s15_now_by*s57_now + s51_now*s9_now_by + v_px_now_by
        s223 = b_x_now*s168 + b_y_now*s175 + b_z_now*s182 + s13_now_by*s63_now + s15_now_by*s66_now + s60_now*s9_now_by + v_py_now_by
        s233 = b_x_now*s189 + b_y_now*s196 + b_z_now*s203 + s13_now_by*s72_now + s15_now_by*s75_now + s69_now*s9_now_by + v_pz_now_by
        s276 = b_x_now*(-s168*w_z_now + s189*w_y_now - s60_now*w_z_now_by + s69_now*w_y_now_by) + s72*s9_now_by
        s286 = b_y_now*(-s175*w_z_now + s196*w_y_now - s63_now*w_z_now_by + s72_now*w_y_now_by) + s13_now_by*s76
        s287 = b_z_now*(-s182*w_z_now + s203*w_y_now - s66_now*w_z_now_by + s75_now*w_y_now_by) + s15_now_by*s60 + s276 + s286
        s302 = b_x_now*(s147*w_z_now - s189*w_x_now + s51_now*w_z_now_by - s69_now*w_x_now_by) + s82*s9_now_by
        s312 = b_y_now*(s154*w_z_now - s196*w_x_now + s54_now*w_z_now_by - s72_now*w_x_now_by) + s13_now_by*s86
        s313 = b_z_now*(s161*w_z_now - s203*w_x_now + s57_now*w_z_now_by - s75_now*w_x_now_by) + s15_now_by*s64 + s302 + s312
        s328 = b_x_now*(-s147*w_y_now + s168*w_x_now - s51_now*w_y_now_by + s60_now*w_x_now_by) + s92*s9_now_by
        s338 = b_y_now*(-s154*w_y_now + s175*w_x_now - s54_now*w_y_now_by + s63_now*w_x_now_by) + s13_now_by*s96
        s339 = b_z_now*(-s161*w_y_now + s182*w_x_now - s57_now*w_y_now_by + s66_now*w_x_now_by) + s15_now_by*s68 + s328 + s338
        s348 = 2*s213*s79_now
        s350 = 2*s223*s83_now
        s352 = 2*s233*s87_now
        s353 = d_x_now*s287 + 0.5*(-A_x_now_by + s117)*(2*b_x_now*s72 + 2*b_y_now*s76 + 2*s142_now)
        s354 = d_y_now*s313 + 0.5*(-A_y_now_by + s127)*(2*b_x_now*s82 + 2*b_y_now*s86 + 2*s146_now)
        s355 = d_z_now*s339 + 0.5*(-A_z_now_by + s137)*(2*b_x_now*s92 + 2*b_y_now*s96 + 2*s150_now)
        s356 = s348 + s350 + s352 + s353 + s354 + s355 - 2*s88_now*(q_t_now*s32_now_by + q_t_now_by*s32_now)
        d_by[64 + lane] = s356


@straight
def _accelerate_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform's acceleration (282 operations)."""
    for lane in range(n):
        M_0_0_now = w[10272 + lane]
        M_0_1_now = w[10304 + lane]
        M_0_2_now = w[10336 + lane]
        M_0_3_now = w[10368 + lane]
        M_0_4_now = w[10400 + lane]
        M_0_5_now = w[10432 + lane]
        M_1_0_now = w[10464 + lane]
        M_1_1_now = w[10496 + lane]
        M_1_2_now = w[10528 + lane]
        M_1_3_now = w[10560 + lane]
        M_1_4_now = w[10592 + lane]
        M_1_5_now = w[10624 + lane]
        M_2_0_now = w[10656 + lane]
        M_2_1_now = w[10688 + lane]
        M_2_2_now = w[10720 + lane]
        M_2_3_now = w[10752 + lane]
        M_2_4_now = w[10784 + lane]
        M_2_5_now = w[10816 + lane]
        M_3_0_now = w[10848 + lane]
        M_3_1_now = w[10880 + lane]
        M_3_2_now = w[10912 + lane]
        M_3_3_now = w[10944 + lane]
        M_3_4_now = w[10976 + lane]
        M_3_5_now = w[11008 + lane]
        M_4_0_now = w[11040 + lane]
        M_4_1_now = w[11072 + lane]
        M_4_2_now = w[11104 + lane]
        M_4_3_now = w[11136 + lane]
        M_4_4_now = w[11168 + lane]
        M_4_5_now = w[11200 + lane]
        M_5_0_now = w[11232 + lane]
        M_5_1_now = w[11264 + lane]
        M_5_2_now = w[11296 + lane]
        M_5_3_now = w[11328 + lane]
        M_5_4_now = w[11360 + lane]
        M_5_5_now = w[11392 + lane]
        q_tt_0_now = d[32 + lane]
        c_0_now = d[64 + lane]
        q_tt_1_now = d[1280 + lane]
        c_1_now = d[1312 + lane]
        q_tt_2_now = d[2528 + lane]
        c_2_now = d[2560 + lane]
        q_tt_3_now = d[3776 + lane]
        c_3_now = d[3808 + lane]
        q_tt_4_now = d[5024 + lane]
        c_4_now = d[5056 + lane]
        q_tt_5_now = d[6272 + lane]
        c_5_now = d[6304 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_0_2_now = s[64 + lane]
        V_0_3_now = s[96 + lane]
        V_0_4_now = s[128 + lane]
        V_0_5_now = s[160 + lane]
        V_1_0_now = s[192 + lane]
        V_1_1_now = s[224 + lane]
        V_1_2_now = s[256 + lane]
        V_1_3_now = s[288 + lane]
        V_1_4_now = s[320 + lane]
        V_1_5_now = s[352 + lane]
        V_2_0_now = s[384 + lane]
        V_2_1_now = s[416 + lane]
        V_2_2_now = s[448 + lane]
        V_2_3_now = s[480 + lane]
        V_2_4_now = s[512 + lane]
        V_2_5_now = s[544 + lane]
        V_3_0_now = s[576 + lane]
        V_3_1_now = s[608 + lane]
        V_3_2_now = s[640 + lane]
        V_3_3_now = s[672 + lane]
        V_3_4_now = s[704 + lane]
        V_3_5_now = s[736 + lane]
        V_4_0_now = s[768 + lane]
        V_4_1_now = s[800 + lane]
        V_4_2_now = s[832 + lane]
        V_4_3_now = s[864 + lane]
        V_4_4_now = s[896 + lane]
        V_4_5_now = s[928 + lane]
        V_5_0_now = s[960 + lane]
        V_5_1_now = s[992 + lane]
        V_5_2_now = s[1024 + lane]
        V_5_3_now = s[1056 + lane]
        V_5_4_now = s[1088 + lane]
        V_5_5_now = s[1120 + lane]
        M_0_0_now_by = w_by[10272 + lane]
        M_0_1_now_by = w_by[10304 + lane]
        M_0_2_now_by = w_by[10336 + lane]
        M_0_3_now_by = w_by[10368 + lane]
        M_0_4_now_by = w_by[10400 + lane]
        M_0_5_now_by = w_by[10432 + lane]
        M_1_0_now_by = w_by[10464 + lane]
        M_1_1_now_by = w_by[10496 + lane]
        M_1_2_now_by = w_by[10528 + lane]
        M_1_3_now_by = w_by[10560 + lane]
        M_1_4_now_by = w_by[10592 + lane]
        M_1_5_now_by = w_by[10624 + lane]
        M_2_0_now_by = w_by[10656 + lane]
        M_2_1_now_by = w_by[10688 + lane]
        M_2_2_now_by = w_by[10720 + lane]
        M_2_3_now_by = w_by[10752 + lane]
        M_2_4_now_by = w_by[10784 + lane]
        M_2_5_now_by = w_by[10816 + lane]
        M_3_0_now_by = w_by[10848 + lane]
        M_3_1_now_by = w_by[10880 + lane]
        M_3_2_now_by = w_by[10912 + lane]
        M_3_3_now_by = w_by[10944 + lane]
        M_3_4_now_by = w_by[10976 + lane]
        M_3_5_now_by = w_by[11008 + lane]
        M_4_0_now_by = w_by[11040 + lane]
        M_4_1_now_by = w_by[11072 + lane]
        M_4_2_now_by = w_by[11104 + lane]
        M_4_3_now_by = w_by[11136 + lane]
        M_4_4_now_by = w_by[11168 + lane]
        M_4_5_now_by = w_by[11200 + lane]
        M_5_0_now_by = w_by[11232 + lane]
        M_5_1_now_by = w_by[11264 + lane]
        M_5_2_now_by = w_by[11296 + lane]
        M_5_3_now_by = w_by[11328 + lane]
        M_5_4_now_by = w_by[11360 + lane]
        M_5_5_now_by = w_by[11392 + lane]
        q_tt_0_now_by = d_by[32 + lane]
        c_0_now_by = d_by[64 + lane]
        q_tt_1_now_by = d_by[1280 + lane]
        c_1_now_by = d_by[1312 + lane]
        q_tt_2_now_by = d_by[2528 + lane]
        c_2_now_by = d_by[2560 + lane]
        q_tt_3_now_by = d_by[3776 + lane]
        c_3_now_by = d_by[3808 + lane]
        q_tt_4_now_by = d_by[5024 + lane]
        c_4_now_by = d_by[5056 + lane]
        q_tt_5_now_by = d_by[6272 + lane]
        c_5_now_by = d_by[6304 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_0_2_now_by = s_by[64 + lane]
        V_0_3_now_by = s_by[96 + lane]
        V_0_4_now_by = s_by[128 + lane]
        V_0_5_now_by = s_by[160 + lane]
        V_1_0_now_by = s_by[192 + lane]
        V_1_1_now_by = s_by[224 + lane]
        V_1_2_now_by = s_by[256 + lane]
        V_1_3_now_by = s_by[288 + lane]
        V_1_4_now_by = s_by[320 + lane]
        V_1_5_now_by = s_by[352 + lane]
        V_2_0_now_by = s_by[384 + lane]
        V_2_1_now_by = s_by[416 + lane]
        V_2_2_now_by = s_by[448 + lane]
        V_2_3_now_by = s_by[480 + lane]
        V_2_4_now_by = s_by[512 + lane]
        V_2_5_now_by = s_by[544 + lane]
        V_3_0_now_by = s_by[576 + lane]
        V_3_1_now_by = s_by[608 + lane]
        V_3_2_now_by = s_by[640 + lane]
        V_3_3_now_by = s_by[672 + lane]
        V_3_4_now_by = s_by[704 + lane]
        V_3_5_now_by = s_by[736 + lane]
        V_4_0_now_by = s_by[768 + lane]
        V_4_1_now_by = s_by[800 + lane]
        V_4_2_now_by = s_by[832 + lane]
        V_4_3_now_by = s_by[864 + lane]
        V_4_4_now_by = s_by[896 + lane]
        V_4_5_now_by = s_by[928 + lane]
        V_5_0_now_by = s_by[960 + lane]
        V_5_1_now_by = s_by[992 + lane]
        V_5_2_now_by = s_by[1024 + lane]
        V_5_3_now_by = s_by[1056 + lane]
        V_5_4_now_by = s_by[1088 + lane]
        V_5_5_now_by = s_by[1120 + lane]
        s80 = M_0_1_now*c_1_now_by + M_0_1_now_by*c_1_now
        s83 = M_0_2_now*c_2_now_by + M_0_2_now_by*c_2_now
        s86 = M_0_3_now*c_3_now_by + M_0_3_now_by*c_3_now
        s89 = M_0_4_now*c_4_now_by + M_0_4_now_by*c_4_now
        s92 = M_0_5_now*c_5_now_by + M_0_5_now_by*c_5_now
        s95 = V_0_0_now*q_tt_0_now_by + V_0_0_now_by*q_tt_0_now
        s98 = V_0_1_now*q_tt_1_now_by + V_0_1_now_by*q_tt_1_now
        s101 = V_0_2_now*q_tt_2_now_by + V_0_2_now_by*q_tt_2_now
        s104 = V_0_3_now*q_tt_3_now_by + V_0_3_now_by*q_tt_3_now
        s107 = V_0_4_now*q_tt_4_now_by + V_0_4_now_by*q_tt_4_now
        s110 = V_0_5_now*q_tt_5_now_by + V_0_5_now_by*q_tt_5_now
        s113 = M_0_0_now*c_0_now_by + M_0_0_now_by*c_0_now
        s114 = s101 + s104 + s107 + s110 + s113 + s80 + s83 + s86 + s89 + s92 + s95 + s98
        s117 = M_1_1_now*c_1_now_by + M_1_1_now_by*c_1_now
        s120 = M_1_2_now*c_2_now_by + M_1_2_now_by*c_2_now
        s123 = M_1_3_now*c_3_now_by + M_1_3_now_by*c_3_now
        s126 = M_1_4_now*c_4_now_by + M_1_4_now_by*c_4_now
        s129 = M_1_5_now*c_5_now_by + M_1_5_now_by*c_5_now
        s132 = V_1_0_now*q_tt_0_now_by + V_1_0_now_by*q_tt_0_now
        s135 = V_1_1_now*q_tt_1_now_by + V_1_1_now_by*q_tt_1_now
        s138 = V_1_2_now*q_tt_2_now_by + V_1_2_now_by*q_tt_2_now
        s141 = V_1_3_now*q_tt_3_now_by + V_1_3_now_by*q_tt_3_now
        s144 = V_1_4_now*q_tt_4_now_by + V_1_4_now_by*q_tt_4_now
        s147 = V_1_5_now*q_tt_5_now_by + V_1_5_now_by*q_tt_5_now
        s150 = M_1_0_now*c_0_now_by + M_1_0_now_by*c_0_now
        s151 = s117 + s120 + s123 + s126 + s129 + s132 + s135 + s138 + s141 + s144 + s147 + s150
        s154 = M_2_1_now*c_1_now_by + M_2_1_now_by*c_1_now
        s157 = M_2_2_now*c_2_now_by + M_2_2_now_by*c_2_now
        s160 = M_2_3_now*c_3_now_by + M_2_3_now_by*c_3_now
        s163 = M_2_4_now*c_4_now_by + M_2_4_now_by*c_4_now
        s166 = M_2_5_now*c_5_now_by + M_2_5_now_by*c_5_now
        s169 = V_2_0_now*q_tt_0_now_by + V_2_0_now_by*q_tt_0_now
        s172 = V_2_1_now*q_tt_1_now_by + V_2_1_now_by*q_tt_1_now
        s175 = V_2_2_now*q_tt_2_now_by + V_2_2_now_by*q_tt_2_now
        s178 = V_2_3_now*q_tt_3_now_by + V_2_3_now_by*q_tt_3_now
        s181 = V_2_4_now*q_tt_4_now_by + V_2_4_now_by*q_tt_4_now
        s184 = V_2_5_now*q_tt_5_now_by + V_2_5_now_by*q_tt_5_now
        s187 = M_2_0_now*c_0_now_by + M_2_0_now_by*c_0_now
        s188 = s154 + s157 + s160 + s163 + s166 + s169 + s172 + s175 + s178 + s181 + s184 + s187
        s191 = M_3_1_now*c_1_now_by + M_3_1_now_by*c_1_now
        s194 = M_3_2_now*c_2_now_by + M_3_2_now_by*c_2_now
        s197 = M_3_3_now*c_3_now_by + M_3_3_now_by*c_3_now
        s200 = M_3_4_now*c_4_now_by + M_3_4_now_by*c_4_now
        s203 = M_3_5_now*c_5_now_by + M_3_5_now_by*c_5_now
        s206 = V_3_0_now*q_tt_0_now_by + V_3_0_now_by*q_tt_0_now
        s209 = V_3_1_now*q_tt_1_now_by + V_3_1_now_by*q_tt_1_now
        s212 = V_3_2_now*q_tt_2_now_by + V_3_2_now_by*q_tt_2_now
        s215 = V_3_3_now*q_tt_3_now_by + V_3_3_now_by*q_tt_3_now
        s218 = V_3_4_now*q_tt_4_now_by + V_3_4_now_by*q_tt_4_now
        s221 = V_3_5_now*q_tt_5_now_by + V_3_5_now_by*q_tt_5_now
        s224 = M_3_0_now*c_0_now_by + M_3_0_now_by*c_0_now
        s225 = s191 + s194 + s197 + s200 + s203 + s206 + s209 + s212 + s215 + s218 + s221 + s224
        s228 = M_4_1_now*c_1_now_by + M_4_1_now_by*c_1_now
        s231 = M_4_2_now*c_2_now_by + M_4_2_now_by*c_2_now
        s234 = M_4_3_now*c_3_now_by + M_4_3_now_by*c_3_now
        s237 = M_4_4_now*c_4_now_by + M_4_4_now_by*c_4_now
        s240 = M_4_5_now*c_5_now_by + M_4_5_now_by*c_5_now
        s243 = V_4_0_now*q_tt_0_now_by + V_4_0_now_by*q_tt_0_now
        s246 = V_4_1_now*q_tt_1_now_by + V_4_1_now_by*q_tt_1_now
        s249 = V_4_2_now*q_tt_2_now_by + V_4_2_now_by*q_tt_2_now
        s252 = V_4_3_now*q_tt_3_now_by + V_4_3_now_by*q_tt_3_now
        s255 = V_4_4_now*q_tt_4_now_by + V_4_4_now_by*q_tt_4_now
        s258 = V_4_5_now*q_tt_5_now_by + V_4_5_now_by*q_tt_5_now
        s261 = M_4_0_now*c_0_now_by + M_4_0_now_by*c_0_now
        s262 = s228 + s231 + s234 + s237 + s240 + s243 + s246 + s249 + s252 + s255 + s258 + s261
        s265 = M_5_1_now*c_1_now_by + M_5_1_now_by*c_1_now
        s268 = M_5_2_now*c_2_now_by + M_5_2_now_by*c_2_now
        s271 = M_5_3_now*c_3_now_by + M_5_3_now_by*c_3_now
        s274 = M_5_4_now*c_4_now_by + M_5_4_now_by*c_4_now
        s277 = M_5_5_now*c_5_now_by + M_5_5_now_by*c_5_now
        s280 = V_5_0_now*q_tt_0_now_by + V_5_0_now_by*q_tt_0_now
        s283 = V_5_1_now*q_tt_1_now_by + V_5_1_now_by*q_tt_1_now
        s286 = V_5_2_now*q_tt_2_now_by + V_5_2_now_by*q_tt_2_now
        s289 = V_5_3_now*q_tt_3_now_by + V_5_3_now_by*q_tt_3_now
        s292 = V_5_4_now*q_tt_4_now_by + V_5_4_now_by*q_tt_4_now
        s295 = V_5_5_now*q_tt_5_now_by + V_5_5_now_by*q_tt_5_now
        s298 = M_5_0_now*c_0_now_by + M_5_0_now_by*c_0_now
        s299 = s265 + s268 + s271 + s274 + s277 + s280 + s283 + s286 + s289 + s292 + s295 + s298
        s_by[1344 + lane] = s114
        s_by[1376 + lane] = s151
        s_by[1408 + lane] = s188
        s_by[1440 + lane] = s225
        s_by[1472 + lane] = s262
        s_by[1504 + lane] = s299


@straight
def _limb_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a limb (620 operations)."""
    s9_now = k[0]
    s13_now = k[1]
    s15_now = k[2]
    A_x_now = k[3]
    A_y_now = k[4]
    A_z_now = k[5]
    s32_now = k[6]
    s34_now = k[7]
    leg_now = k[8]
    s418_now = k[9]
    s9_now_by = k_by[0]
    s13_now_by = k_by[1]
    s15_now_by = k_by[2]
    A_x_now_by = k_by[3]
    A_y_now_by = k_by[4]
    A_z_now_by = k_by[5]
    s32_now_by = k_by[6]
    s34_now_by = k_by[7]
    leg_now_by = k_by[8]
    s418_now_by = k_by[9]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        v_px_now = s[1152 + lane]
        v_py_now = s[1184 + lane]
        v_pz_now = s[1216 + lane]
        w_x_now = s[1248 + lane]
        w_y_now = s[1280 + lane]
        w_z_now = s[1312 + lane]
        v_px_t_now = s[1344 + lane]
        v_py_t_now = s[1376 + lane]
        v_pz_t_now = s[1408 + lane]
        w_x_t_now = s[1440 + lane]
        w_y_t_now = s[1472 + lane]
        w_z_t_now = s[1504 + lane]
        q_t_now = d[0 + lane]
        q_tt_now = d[32 + lane]
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        v_px_now_by = s_by[1152 + lane]
        v_py_now_by = s_by[1184 + lane]
        v_pz_now_by = s_by[1216 + lane]
        w_x_now_by = s_by[1248 + lane]
        w_y_now_by = s_by[1280 + lane]
        w_z_now_by = s_by[1312 + lane]
        v_px_t_now_by = s_by[1344 + lane]
        v_py_t_now_by = s_by[1376 + lane]
        v_pz_t_now_by = s_by[1408 + lane]
        w_x_t_now_by = s_by[1440 + lane]
        w_y_t_now_by = s_by[1472 + lane]
        w_z_t_now_by = s_by[1504 + lane]
        q_t_now_by = d_by[0 + lane]
        q_tt_now_by = d_by[32 + lane]
        b_x_now = s9_now - tx_now
        b_y_now = s13_now - ty_now
        b_z_now = s15_now - tz_now
        B_x_now = R_11_now*b_x_now + R_12_now*b_y_now + R_13_now*b_z_now + px_now
        B_y_now = R_21_now*b_x_now + R_22_now*b_y_now + R_23_now*b_z_now + py_now
        B_z_now = R_31_now*b_x_now + R_32_now*b_y_now + R_33_now*b_z_now + pz_now
        d_x_now = -A_x_now + B_x_now
        d_y_now = -A_y_now + B_y_now
        d_z_now = -A_z_now + B_z_now
        s__now = q_now*s32_now + s34_now
        s36_now = (1.0 / s__now)
        s51_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s54_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s57_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s60_now = R_11_now*w_z_now - R_31_now*w_x_now
        s63_now = R_12_now*w_z_now - R_32_now*w_x_now
        s66_now = R_13_now*w_z_now - R_33_now*w_x_now
        s69_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s72_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s75_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s88_now = q_t_now*s32_now
        s89_now = (1.0 / (s__now * s__now))
        s90_now = -s88_now*s89_now
        s54 = b_x_now*s51_now + b_y_now*s54_now + b_z_now*s57_now + v_px_now
        s156_now = s54*s90_now
        s59 = b_x_now*s60_now + b_y_now*s63_now + b_z_now*s66_now + v_py_now
        s162_now = s59*s90_now
        s64 = b_x_now*s69_now + b_y_now*s72_now + b_z_now*s75_now + v_pz_now
        s168_now = s64*s90_now
        s70 = -R_22_now*w_z_t_now + R_32_now*w_y_t_now - s63_now*w_z_now + s72_now*w_y_now
        s1076_now = b_y_now*s70
        s76 = -R_23_now*w_z_t_now + R_33_now*w_y_t_now - s66_now*w_z_now + s75_now*w_y_now
        s1077_now = b_z_now*s76
        s82 = -R_21_now*w_z_t_now + R_31_now*w_y_t_now - s60_now*w_z_now + s69_now*w_y_now
        s1078_now = b_x_now*s82 + s1076_now + s1077_now + v_px_t_now
        s89 = R_12_now*w_z_t_now - R_32_now*w_x_t_now + s54_now*w_z_now - s72_now*w_x_now
        s1080_now = b_y_now*s89
        s95 = R_13_now*w_z_t_now - R_33_now*w_x_t_now + s57_now*w_z_now - s75_now*w_x_now
        s1081_now = b_z_now*s95
        s101 = R_11_now*w_z_t_now - R_31_now*w_x_t_now + s51_now*w_z_now - s69_now*w_x_now
        s1082_now = b_x_now*s101 + s1080_now + s1081_now + v_py_t_now
        s108 = -R_12_now*w_y_t_now + R_22_now*w_x_t_now - s54_now*w_y_now + s63_now*w_x_now
        s1084_now = b_y_now*s108
        s114 = -R_13_now*w_y_t_now + R_23_now*w_x_t_now - s57_now*w_y_now + s66_now*w_x_now
        s1085_now = b_z_now*s114
        s120 = -R_11_now*w_y_t_now + R_21_now*w_x_t_now - s51_now*w_y_now + s60_now*w_x_now
        s1086_now = b_x_now*s120 + s1084_now + s1085_now + v_pz_t_now
        s123 = (s88_now * s88_now)
        s124 = (1.0 / (s__now * s__now * s__now))
        s1089_now = -q_tt_now*s32_now*s89_now + 2*s123*s124
        s1094_now = d_x_now*s1089_now + s1078_now*s36_now + 2*s156_now
        s1099_now = d_y_now*s1089_now + s1082_now*s36_now + 2*s162_now
        s1104_now = d_z_now*s1089_now + s1086_now*s36_now + 2*s168_now
        s176 = R_11_now*s9_now_by + R_11_now_by*b_x_now + R_12_now*s13_now_by + R_12_now_by*b_y_now + R_13_now*s15_now_by + R_13_now_by*b_z_now + px_now_by
        s186 = R_21_now*s9_now_by + R_21_now_by*b_x_now + R_22_now*s13_now_by + R_22_now_by*b_y_now + R_23_now*s15_now_by + R_23_now_by*b_z_now + py_now_by
        s196 = R_31_now*s9_now_by + R_31_now_by*b_x_now + R_32_now*s13_now_by + R_32_now_by*b_y_now + R_33_now*s15_now_by + R_33_now_by*b_z_now + pz_now_by
        s201 = q_now*s32_now_by + s34_now_by
        s202 = -s201*s89_now
        s209 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s216 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s223 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s230 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s237 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s244 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s251 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s258 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s265 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s268 = q_t_now*s32_now_by + q_t_now_by*s32_now
        s269 = -2*s124
        s270 = s201*s269
        s273 = -s268*s89_now - s270*s88_now
        s283 = b_x_now*s209 + b_y_now*s216 + b_z_now*s223 + s13_now_by*s54_now + s15_now_by*s57_now + s51_now*s9_now_by + v_px_now_by
        s296 = b_x_now*s230 + b_y_now*s237 + b_z_now*s244 + s13_now_by*s63_now + s15_now_by*s66_now + s60_now*s9_now_by + v_py_now_by
        s309 = b_x_now*s251 + b_y_now*s258 + b_z_now*s265 + s13_now_by*s72_now + s15_now_by*s75_now + s69_now*s9_now_by + v_pz_now_by
        s324 = -s237*w_z_now - s63_now*w_z_now_by
        s325 = -R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now + R_32_now*w_y_t_now_by + R_32_now_by*w_y_t_now + s258*w_y_now + s324 + s72_now*w_y_now_by
        s340 = -s244*w_z_now - s66_now*w_z_now_by
        s341 = -R_23_now*w_z_t_now_by - R_23_now_by*w_z_t_now + R_33_now*w_y_t_now_by + R_33_now_by*w_y_t_now + s265*w_y_now + s340 + s75_now*w_y_now_by
        s356 = -s230*w_z_now - s60_now*w_z_now_by
        s357 = -R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now + R_31_now*w_y_t_now_by + R_31_now_by*w_y_t_now + s251*w_y_now + s356 + s69_now*w_y_now_by
        s361 = b_x_now*s357 + b_y_now*s325 + b_z_now*s341 + s13_now_by*s70 + s15_now_by*s76 + s82*s9_now_by + v_px_t_now_by
        s373 = -s258*w_x_now - s72_now*w_x_now_by
        s374 = R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_32_now*w_x_t_now_by - R_32_now_by*w_x_t_now + s216*w_z_now + s373 + s54_now*w_z_now_by
        s389 = -s265*w_x_now - s75_now*w_x_now_by
        s390 = R_13_now*w_z_t_now_by + R_13_now_by*w_z_t_now - R_33_now*w_x_t_now_by - R_33_now_by*w_x_t_now + s223*w_z_now + s389 + s57_now*w_z_now_by
        s405 = -s251*w_x_now - s69_now*w_x_now_by
        s406 = R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_31_now*w_x_t_now_by - R_31_now_by*w_x_t_now + s209*w_z_now + s405 + s51_now*w_z_now_by
        s410 = b_x_now*s406 + b_y_now*s374 + b_z_now*s390 + s101*s9_now_by + s13_now_by*s89 + s15_now_by*s95 + v_py_t_now_by
        s422 = -s216*w_y_now - s54_now*w_y_now_by
        s423 = -R_12_now*w_y_t_now_by - R_12_now_by*w_y_t_now + R_22_now*w_x_t_now_by + R_22_now_by*w_x_t_now + s237*w_x_now + s422 + s63_now*w_x_now_by
        s438 = -s223*w_y_now - s57_now*w_y_now_by
        s439 = -R_13_now*w_y_t_now_by - R_13_now_by*w_y_t_now + R_23_now*w_x_t_now_by + R_23_now_by*w_x_t_now + s244*w_x_now + s438 + s66_now*w_x_now_by
        s454 = -s209*w_y_now - s51_now*w_y_now_by
        s455 = -R_11_now*w_y_t_now_by - R_11_now_by*w_y_t_now + R_21_now*w_x_t_now_by + R_21_now_by*w_x_t_now + s230*w_x_now + s454 + s60_now*w_x_now_by
        s459 = b_x_now*s455 + b_y_now*s423 + b_z_now*s439 + s108*s13_now_by + s114*s15_now_by + s120*s9_now_by + v_pz_t_now_by
        s475 = -q_tt_now*s270*s32_now - q_tt_now*s32_now_by*s89_now - q_tt_now_by*s32_now*s89_now
        s476 = -6*s123*s201/(s__now * s__now * s__now * s__now) - 2*s268*s269*s88_now + s475
        s483 = s1078_now*s202 + s361*s36_now
        s484 = d_x_now*s476 + s1089_now*(-A_x_now_by + s176) + 2*s273*s54 + 2*s283*s90_now + s483
        s491 = s1082_now*s202 + s36_now*s410
        s492 = d_y_now*s476 + s1089_now*(-A_y_now_by + s186) + 2*s273*s59 + 2*s296*s90_now + s491
        s499 = s1086_now*s202 + s36_now*s459
        s500 = d_z_now*s476 + s1089_now*(-A_z_now_by + s196) + 2*s273*s64 + 2*s309*s90_now + s499
        s510 = -0.001*leg_now*s484 - 0.001*leg_now_by*s1094_now
        s511 = -0.001*leg_now*s492 - 0.001*leg_now_by*s1099_now
        s512 = -0.001*leg_now*s500 - 0.001*leg_now_by*s1104_now
        s513 = -0.001*s361
        s514 = -s510 + s513
        s515 = -0.001*s410
        s516 = -s511 + s515
        s517 = -0.001*s459
        s518 = -s512 + s517
        s519 = -0.001*s418_now
        s524 = -0.001*s1094_now*s418_now_by + s484*s519 + s513
        s529 = -0.001*s1099_now*s418_now_by + s492*s519 + s515
        s534 = -0.001*s1104_now*s418_now_by + s500*s519 + s517
        d_by[96 + lane] = s510
        d_by[128 + lane] = s511
        d_by[160 + lane] = s512
        d_by[192 + lane] = -s510
        d_by[224 + lane] = -s511
        d_by[256 + lane] = -s512
        d_by[288 + lane] = s514
        d_by[320 + lane] = s516
        d_by[352 + lane] = s518
        d_by[384 + lane] = s524
        d_by[416 + lane] = s529
        d_by[448 + lane] = s534
        d_by[480 + lane] = s513
        d_by[512 + lane] = s515
        d_by[544 + lane] = s517


@straight
def _limb_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a limb, along joint, shifts and turns (677 operations)."""
    share_now = shares[0]
    s9_now = k[0]
    s13_now = k[1]
    s15_now = k[2]
    A_x_now = k[3]
    A_y_now = k[4]
    A_z_now = k[5]
    s32_now = k[6]
    s34_now = k[7]
    leg_now = k[8]
    s418_now = k[9]
    s231_now = k[10]
    s321_now = k[11]
    s9_now_by = k_by[0]
    s13_now_by = k_by[1]
    s15_now_by = k_by[2]
    A_x_now_by = k_by[3]
    A_y_now_by = k_by[4]
    A_z_now_by = k_by[5]
    s32_now_by = k_by[6]
    s34_now_by = k_by[7]
    leg_now_by = k_by[8]
    s418_now_by = k_by[9]
    s231_now_by = k_by[10]
    s321_now_by = k_by[11]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        px_now = w[128 + lane]
        py_now = w[160 + lane]
        pz_now = w[192 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        f0x_now = d[96 + lane]
        f0y_now = d[128 + lane]
        f0z_now = d[160 + lane]
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
        px_now_by = w_by[128 + lane]
        py_now_by = w_by[160 + lane]
        pz_now_by = w_by[192 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        f0x_now_by = d_by[96 + lane]
        f0y_now_by = d_by[128 + lane]
        f0z_now_by = d_by[160 + lane]
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
        b_x_now = s9_now - tx_now
        b_y_now = s13_now - ty_now
        b_z_now = s15_now - tz_now
        B_x_now = R_11_now*b_x_now + R_12_now*b_y_now + R_13_now*b_z_now + px_now
        B_y_now = R_21_now*b_x_now + R_22_now*b_y_now + R_23_now*b_z_now + py_now
        B_z_now = R_31_now*b_x_now + R_32_now*b_y_now + R_33_now*b_z_now + pz_now
        d_x_now = -A_x_now + B_x_now
        d_y_now = -A_y_now + B_y_now
        d_z_now = -A_z_now + B_z_now
        s__now = q_now*s32_now + s34_now
        s36_now = (1.0 / s__now)
        s89_now = (1.0 / (s__now * s__now))
        s24 = f0z_now*s231_now + f1z_now*s231_now
        s251_now = leg_now*s24
        s28 = f0y_now*s231_now + f1y_now*s231_now
        s256_now = leg_now*s28
        s32 = f0x_now*s231_now + f1x_now*s231_now
        s261_now = leg_now*s32
        s263_now = s251_now*s36_now
        s265_now = s256_now*s36_now
        s267_now = s261_now*s36_now
        s40 = d_x_now*s261_now + d_y_now*s256_now + d_z_now*s251_now
        s273_now = b_z_now*s263_now
        s275_now = b_y_now*s263_now
        s277_now = b_x_now*s263_now
        s279_now = b_z_now*s265_now
        s281_now = b_y_now*s265_now
        s283_now = b_x_now*s265_now
        s285_now = b_z_now*s267_now
        s287_now = b_y_now*s267_now
        s289_now = b_x_now*s267_now
        s74 = f0z_now*s321_now - f1z_now*s321_now
        s334_now = leg_now*s74
        s78 = f0y_now*s321_now - f1y_now*s321_now
        s339_now = leg_now*s78
        s82 = f0x_now*s321_now - f1x_now*s321_now
        s344_now = leg_now*s82
        s346_now = s334_now*s36_now
        s348_now = s339_now*s36_now
        s350_now = s344_now*s36_now
        s90 = d_x_now*s344_now + d_y_now*s339_now + d_z_now*s334_now
        s356_now = b_z_now*s346_now
        s358_now = b_y_now*s346_now
        s360_now = b_x_now*s346_now
        s362_now = b_z_now*s348_now
        s364_now = b_y_now*s348_now
        s366_now = b_x_now*s348_now
        s368_now = b_z_now*s350_now
        s370_now = b_y_now*s350_now
        s372_now = b_x_now*s350_now
        s417_now = 1 - 2*share_now
        s432_now = f3z_now*s417_now
        s436_now = f3y_now*s417_now
        s440_now = f3x_now*s417_now
        s445_now = f2z_now*share_now
        s447_now = f2y_now*share_now
        s449_now = f2x_now*share_now
        s462_now = -leg_now*s445_now + s418_now*s432_now
        s465_now = -leg_now*s447_now + s418_now*s436_now
        s468_now = -leg_now*s449_now + s418_now*s440_now
        s142 = d_x_now*s468_now + d_y_now*s465_now + d_z_now*s462_now
        s475_now = f4z_now*share_now + s36_now*s462_now + s432_now + s445_now
        s476_now = b_z_now*s475_now
        s478_now = b_y_now*s475_now
        s480_now = b_x_now*s475_now
        s482_now = f4y_now*share_now + s36_now*s465_now + s436_now + s447_now
        s483_now = b_z_now*s482_now
        s485_now = b_y_now*s482_now
        s487_now = b_x_now*s482_now
        s489_now = f4x_now*share_now + s36_now*s468_now + s440_now + s449_now
        s490_now = b_z_now*s489_now
        s492_now = b_y_now*s489_now
        s494_now = b_x_now*s489_now
        s192 = R_11_now*s9_now_by + R_11_now_by*b_x_now + R_12_now*s13_now_by + R_12_now_by*b_y_now + R_13_now*s15_now_by + R_13_now_by*b_z_now + px_now_by
        s202 = R_21_now*s9_now_by + R_21_now_by*b_x_now + R_22_now*s13_now_by + R_22_now_by*b_y_now + R_23_now*s15_now_by + R_23_now_by*b_z_now + py_now_by
        s212 = R_31_now*s9_now_by + R_31_now_by*b_x_now + R_32_now*s13_now_by + R_32_now_by*b_y_now + R_33_now*s15_now_by + R_33_now_by*b_z_now + pz_now_by
        s213 = -A_x_now_by + s192
        s214 = -A_y_now_by + s202
        s215 = -A_z_now_by + s212
        s217 = q_now*s32_now_by + s34_now_by
        s218 = -s217*s89_now
        s221 = -2*s217/(s__now * s__now * s__now)
        s231 = leg_now*(f0z_now*s231_now_by + f0z_now_by*s231_now + f1z_now*s231_now_by + f1z_now_by*s231_now) + leg_now_by*s24
        s241 = leg_now*(f0y_now*s231_now_by + f0y_now_by*s231_now + f1y_now*s231_now_by + f1y_now_by*s231_now) + leg_now_by*s28
        s251 = leg_now*(f0x_now*s231_now_by + f0x_now_by*s231_now + f1x_now*s231_now_by + f1x_now_by*s231_now) + leg_now_by*s32
        s254 = s218*s251_now + s231*s36_now
        s257 = s218*s256_now + s241*s36_now
        s260 = s218*s261_now + s251*s36_now
        s272 = -s32_now*s89_now
        s275 = s272*(d_x_now*s251 + d_y_now*s241 + d_z_now*s231 + s213*s261_now + s214*s256_now + s215*s251_now)
        s277 = -s221*s32_now*s40 + s275 - s32_now_by*s40*s89_now
        s280 = b_z_now*s254 + s15_now_by*s263_now
        s283 = b_y_now*s254 + s13_now_by*s263_now
        s286 = b_x_now*s254 + s263_now*s9_now_by
        s289 = b_z_now*s257 + s15_now_by*s265_now
        s292 = b_y_now*s257 + s13_now_by*s265_now
        s295 = b_x_now*s257 + s265_now*s9_now_by
        s298 = b_z_now*s260 + s15_now_by*s267_now
        s301 = b_y_now*s260 + s13_now_by*s267_now
        s304 = b_x_now*s260 + s267_now*s9_now_by
        s313 = R_23_now*s280 + R_23_now_by*s273_now
        s316 = -R_31_now*s295 - R_31_now_by*s283_now
        s319 = -R_32_now*s292 - R_32_now_by*s281_now
        s322 = -R_33_now*s289 - R_33_now_by*s279_now
        s323 = R_21_now*s286 + R_21_now_by*s277_now + R_22_now*s283 + R_22_now_by*s275_now + s313 + s316 + s319 + s322
        s332 = R_33_now*s298 + R_33_now_by*s285_now
        s335 = -R_11_now*s286 - R_11_now_by*s277_now
        s338 = -R_12_now*s283 - R_12_now_by*s275_now
        s341 = -R_13_now*s280 - R_13_now_by*s273_now
        s342 = R_31_now*s304 + R_31_now_by*s289_now + R_32_now*s301 + R_32_now_by*s287_now + s332 + s335 + s338 + s341
        s351 = R_13_now*s289 + R_13_now_by*s279_now
        s354 = -R_21_now*s304 - R_21_now_by*s289_now
        s357 = -R_22_now*s301 - R_22_now_by*s287_now
        s360 = -R_23_now*s298 - R_23_now_by*s285_now
        s361 = R_11_now*s295 + R_11_now_by*s283_now + R_12_now*s292 + R_12_now_by*s281_now + s351 + s354 + s357 + s360
        s371 = leg_now*(f0z_now*s321_now_by + f0z_now_by*s321_now - f1z_now*s321_now_by - f1z_now_by*s321_now) + leg_now_by*s74
        s381 = leg_now*(f0y_now*s321_now_by + f0y_now_by*s321_now - f1y_now*s321_now_by - f1y_now_by*s321_now) + leg_now_by*s78
        s391 = leg_now*(f0x_now*s321_now_by + f0x_now_by*s321_now - f1x_now*s321_now_by - f1x_now_by*s321_now) + leg_now_by*s82
        s394 = s218*s334_now + s36_now*s371
        s397 = s218*s339_now + s36_now*s381
        s400 = s218*s344_now + s36_now*s391
        s415 = s272*(d_x_now*s391 + d_y_now*s381 + d_z_now*s371 + s213*s344_now + s214*s339_now + s215*s334_now)
        s416 = -s221*s32_now*s90 - s32_now_by*s89_now*s90 + s415
        s419 = b_z_now*s394 + s15_now_by*s346_now
        s422 = b_y_now*s394 + s13_now_by*s346_now
        s425 = b_x_now*s394 + s346_now*s9_now_by
        s428 = b_z_now*s397 + s15_now_by*s348_now
        s431 = b_y_now*s397 + s13_now_by*s348_now
        s434 = b_x_now*s397 + s348_now*s9_now_by
        s437 = b_z_now*s400 + s15_now_by*s350_now
        s440 = b_y_now*s400 + s13_now_by*s350_now
        s443 = b_x_now*s400 + s350_now*s9_now_by
        s452 = R_23_now*s419 + R_23_now_by*s356_now
        s455 = -R_31_now*s434 - R_31_now_by*s366_now
        s458 = -R_32_now*s431 - R_32_now_by*s364_now
        s461 = -R_33_now*s428 - R_33_now_by*s362_now
        s462 = R_21_now*s425 + R_21_now_by*s360_now + R_22_now*s422 + R_22_now_by*s358_now + s452 + s455 + s458 + s461
        s471 = R_33_now*s437 + R_33_now_by*s368_now
        s474 = -R_11_now*s425 - R_11_now_by*s360_now
        s477 = -R_12_now*s422 - R_12_now_by*s358_now
        s480 = -R_13_now*s419 - R_13_now_by*s356_now
        s481 = R_31_now*s443 + R_31_now_by*s372_now + R_32_now*s440 + R_32_now_by*s370_now + s471 + s474 + s477 + s480
        s490 = R_13_now*s428 + R_13_now_by*s362_now
        s493 = -R_21_now*s443 - R_21_now_by*s372_now
        s496 = -R_22_now*s440 - R_22_now_by*s370_now
        s499 = -R_23_now*s437 - R_23_now_by*s368_now
        s500 = R_11_now*s434 + R_11_now_by*s366_now + R_12_now*s431 + R_12_now_by*s364_now + s490 + s493 + s496 + s499
        s501 = f3z_now_by*s417_now
        s502 = f3y_now_by*s417_now
        s503 = f3x_now_by*s417_now
        s504 = f2z_now_by*share_now
        s505 = f2y_now_by*share_now
        s506 = f2x_now_by*share_now
        s513 = -leg_now*s504 - leg_now_by*s445_now + s418_now*s501 + s418_now_by*s432_now
        s520 = -leg_now*s505 - leg_now_by*s447_now + s418_now*s502 + s418_now_by*s436_now
        s527 = -leg_now*s506 - leg_now_by*s449_now + s418_now*s503 + s418_now_by*s440_now
        s540 = s272*(d_x_now*s527 + d_y_now*s520 + d_z_now*s513 + s213*s468_now + s214*s465_now + s215*s462_now)
        s543 = -s142*s221*s32_now - s142*s32_now_by*s89_now + s540
        s548 = f4z_now_by*share_now + s218*s462_now + s36_now*s513 + s501 + s504
        s551 = b_z_now*s548 + s15_now_by*s475_now
        s554 = b_y_now*s548 + s13_now_by*s475_now
        s557 = b_x_now*s548 + s475_now*s9_now_by
        s562 = f4y_now_by*share_now + s218*s465_now + s36_now*s520 + s502 + s505
        s565 = b_z_now*s562 + s15_now_by*s482_now
        s568 = b_y_now*s562 + s13_now_by*s482_now
        s571 = b_x_now*s562 + s482_now*s9_now_by
        s576 = f4x_now_by*share_now + s218*s468_now + s36_now*s527 + s503 + s506
        s579 = b_z_now*s576 + s15_now_by*s489_now
        s582 = b_y_now*s576 + s13_now_by*s489_now
        s585 = b_x_now*s576 + s489_now*s9_now_by
        s594 = R_23_now*s551 + R_23_now_by*s476_now
        s597 = -R_31_now*s571 - R_31_now_by*s487_now
        s600 = -R_32_now*s568 - R_32_now_by*s485_now
        s603 = -R_33_now*s565 - R_33_now_by*s483_now
        s604 = R_21_now*s557 + R_21_now_by*s480_now + R_22_now*s554 + R_22_now_by*s478_now + s594 + s597 + s600 + s603
        s613 = R_33_now*s579 + R_33_now_by*s490_now
        s616 = -R_11_now*s557 - R_11_now_by*s480_now
        s619 = -R_12_now*s554 - R_12_now_by*s478_now
        s622 = -R_13_now*s551 - R_13_now_by*s476_now
        s623 = R_31_now*s585 + R_31_now_by*s494_now + R_32_now*s582 + R_32_now_by*s492_now + s613 + s616 + s619 + s622
        s632 = R_13_now*s565 + R_13_now_by*s483_now
        s635 = -R_21_now*s585 - R_21_now_by*s494_now
        s638 = -R_22_now*s582 - R_22_now_by*s492_now
        s641 = -R_23_now*s579 - R_23_now_by*s490_now
        s642 = R_11_now*s571 + R_11_now_by*s487_now + R_12_now*s568 + R_12_now_by*s485_now + s632 + s635 + s638 + s641
        d_by[576 + lane] = s277
        d_by[608 + lane] = s260
        d_by[640 + lane] = s257
        d_by[672 + lane] = s254
        d_by[704 + lane] = s323
        d_by[736 + lane] = s342
        d_by[768 + lane] = s361
        d_by[800 + lane] = s416
        d_by[832 + lane] = s400
        d_by[864 + lane] = s397
        d_by[896 + lane] = s394
        d_by[928 + lane] = s462
        d_by[960 + lane] = s481
        d_by[992 + lane] = s500
        d_by[1024 + lane] = s543
        d_by[1056 + lane] = s576
        d_by[1088 + lane] = s562
        d_by[1120 + lane] = s548
        d_by[1152 + lane] = s604
        d_by[1184 + lane] = s623
        d_by[1216 + lane] = s642


@straight
def _platform_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a platform (270 operations)."""
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        w_x_now = s[1248 + lane]
        w_y_now = s[1280 + lane]
        w_z_now = s[1312 + lane]
        w_x_t_now = s[1440 + lane]
        w_y_t_now = s[1472 + lane]
        w_z_t_now = s[1504 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        w_x_now_by = s_by[1248 + lane]
        w_y_now_by = s_by[1280 + lane]
        w_z_now_by = s_by[1312 + lane]
        v_px_t_now_by = s_by[1344 + lane]
        v_py_t_now_by = s_by[1376 + lane]
        v_pz_t_now_by = s_by[1408 + lane]
        w_x_t_now_by = s_by[1440 + lane]
        w_y_t_now_by = s_by[1472 + lane]
        w_z_t_now_by = s_by[1504 + lane]
        s104_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s107_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s110_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s113_now = R_11_now*w_z_now - R_31_now*w_x_now
        s116_now = R_12_now*w_z_now - R_32_now*w_x_now
        s119_now = R_13_now*w_z_now - R_33_now*w_x_now
        s122_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s125_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s128_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s102 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s109 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s116 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s123 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s130 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s137 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s144 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s151 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s158 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s170 = -s116_now*w_z_now_by - s130*w_z_now
        s171 = -R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now + R_32_now*w_y_t_now_by + R_32_now_by*w_y_t_now + s125_now*w_y_now_by + s151*w_y_now + s170
        s184 = -s119_now*w_z_now_by - s137*w_z_now
        s185 = -R_23_now*w_z_t_now_by - R_23_now_by*w_z_t_now + R_33_now*w_y_t_now_by + R_33_now_by*w_y_t_now + s128_now*w_y_now_by + s158*w_y_now + s184
        s198 = -s113_now*w_z_now_by - s123*w_z_now
        s199 = -R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now + R_31_now*w_y_t_now_by + R_31_now_by*w_y_t_now + s122_now*w_y_now_by + s144*w_y_now + s198
        s213 = -s125_now*w_x_now_by - s151*w_x_now
        s214 = R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_32_now*w_x_t_now_by - R_32_now_by*w_x_t_now + s107_now*w_z_now_by + s109*w_z_now + s213
        s227 = -s128_now*w_x_now_by - s158*w_x_now
        s228 = R_13_now*w_z_t_now_by + R_13_now_by*w_z_t_now - R_33_now*w_x_t_now_by - R_33_now_by*w_x_t_now + s110_now*w_z_now_by + s116*w_z_now + s227
        s241 = -s122_now*w_x_now_by - s144*w_x_now
        s242 = R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_31_now*w_x_t_now_by - R_31_now_by*w_x_t_now + s102*w_z_now + s104_now*w_z_now_by + s241
        s256 = -s107_now*w_y_now_by - s109*w_y_now
        s257 = -R_12_now*w_y_t_now_by - R_12_now_by*w_y_t_now + R_22_now*w_x_t_now_by + R_22_now_by*w_x_t_now + s116_now*w_x_now_by + s130*w_x_now + s256
        s270 = -s110_now*w_y_now_by - s116*w_y_now
        s271 = -R_13_now*w_y_t_now_by - R_13_now_by*w_y_t_now + R_23_now*w_x_t_now_by + R_23_now_by*w_x_t_now + s119_now*w_x_now_by + s137*w_x_now + s270
        s284 = -s102*w_y_now - s104_now*w_y_now_by
        s285 = -R_11_now*w_y_t_now_by - R_11_now_by*w_y_t_now + R_21_now*w_x_t_now_by + R_21_now_by*w_x_t_now + s113_now*w_x_now_by + s123*w_x_now + s284
        s288 = 0.001*s171*ty_now + 0.001*s185*tz_now + 0.001*s199*tx_now - 0.001*v_px_t_now_by
        s289 = 0.001*s214*ty_now + 0.001*s228*tz_now + 0.001*s242*tx_now - 0.001*v_py_t_now_by
        s290 = 0.001*s257*ty_now + 0.001*s271*tz_now + 0.001*s285*tx_now - 0.001*v_pz_t_now_by
        s291 = -0.001*v_px_t_now_by
        s292 = -0.001*v_py_t_now_by
        s293 = -0.001*v_pz_t_now_by
        s_by[1536 + lane] = s288
        s_by[1568 + lane] = s289
        s_by[1600 + lane] = s290
        s_by[1632 + lane] = s291
        s_by[1664 + lane] = s292
        s_by[1696 + lane] = s293


@straight
def _platform_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a platform, along joint, shifts and turns (114 operations)."""
    for lane in range(n):
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        R_11_now = w[320 + lane]
        R_12_now = w[352 + lane]
        R_13_now = w[384 + lane]
        R_21_now = w[416 + lane]
        R_22_now = w[448 + lane]
        R_23_now = w[480 + lane]
        R_31_now = w[512 + lane]
        R_32_now = w[544 + lane]
        R_33_now = w[576 + lane]
        f0x_now = s[1536 + lane]
        f0y_now = s[1568 + lane]
        f0z_now = s[1600 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        f0x_now_by = s_by[1536 + lane]
        f0y_now_by = s_by[1568 + lane]
        f0z_now_by = s_by[1600 + lane]
        f1x_now_by = s_by[1632 + lane]
        f1y_now_by = s_by[1664 + lane]
        f1z_now_by = s_by[1696 + lane]
        s56_now = -f0z_now*tz_now
        s58_now = -f0z_now*ty_now
        s60_now = -f0z_now*tx_now
        s62_now = -f0y_now*tz_now
        s64_now = -f0y_now*ty_now
        s66_now = -f0y_now*tx_now
        s68_now = -f0x_now*tz_now
        s70_now = -f0x_now*ty_now
        s72_now = -f0x_now*tx_now
        s30 = -f0z_now_by*tz_now
        s31 = -f0z_now_by*ty_now
        s32 = -f0z_now_by*tx_now
        s33 = -f0y_now_by*tz_now
        s34 = -f0y_now_by*ty_now
        s35 = -f0y_now_by*tx_now
        s36 = -f0x_now_by*tz_now
        s37 = -f0x_now_by*ty_now
        s38 = -f0x_now_by*tx_now
        s47 = R_23_now*s30 + R_23_now_by*s56_now
        s50 = -R_31_now*s35 - R_31_now_by*s66_now
        s53 = -R_32_now*s34 - R_32_now_by*s64_now
        s56 = -R_33_now*s33 - R_33_now_by*s62_now
        s57 = R_21_now*s32 + R_21_now_by*s60_now + R_22_now*s31 + R_22_now_by*s58_now + s47 + s50 + s53 + s56
        s66 = R_33_now*s36 + R_33_now_by*s68_now
        s69 = -R_11_now*s32 - R_11_now_by*s60_now
        s72 = -R_12_now*s31 - R_12_now_by*s58_now
        s75 = -R_13_now*s30 - R_13_now_by*s56_now
        s76 = R_31_now*s38 + R_31_now_by*s72_now + R_32_now*s37 + R_32_now_by*s70_now + s66 + s69 + s72 + s75
        s85 = R_13_now*s33 + R_13_now_by*s62_now
        s88 = -R_21_now*s38 - R_21_now_by*s72_now
        s91 = -R_22_now*s37 - R_22_now_by*s70_now
        s94 = -R_23_now*s36 - R_23_now_by*s68_now
        s95 = R_11_now*s35 + R_11_now_by*s66_now + R_12_now*s34 + R_12_now_by*s64_now + s85 + s88 + s91 + s94
        s_by[1728 + lane] = f0x_now_by
        s_by[1760 + lane] = f0y_now_by
        s_by[1792 + lane] = f0z_now_by
        s_by[1824 + lane] = s57
        s_by[1856 + lane] = s76
        s_by[1888 + lane] = s95
        s_by[1920 + lane] = f1x_now_by
        s_by[1952 + lane] = f1y_now_by
        s_by[1984 + lane] = f1z_now_by


@straight
def _give_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what the joints give (672 operations)."""
    m_0_now = inertia[0]
    m_1_now = inertia[1]
    m_2_now = inertia[2]
    m_3_now = inertia[3]
    m_4_now = inertia[4]
    m_5_now = inertia[5]
    m_6_now = inertia[6]
    m_7_now = inertia[7]
    m_8_now = inertia[8]
    m_9_now = inertia[9]
    m_10_now = inertia[10]
    m_11_now = inertia[11]
    m_12_now = inertia[12]
    m_13_now = inertia[13]
    m_14_now = inertia[14]
    m_15_now = inertia[15]
    m_16_now = inertia[16]
    m_17_now = inertia[17]
    m_18_now = inertia[18]
    m_19_now = inertia[19]
    for lane in range(n):
        a_0_1_now = d[608 + lane]
        a_0_2_now = d[640 + lane]
        a_0_3_now = d[672 + lane]
        a_0_4_now = d[704 + lane]
        a_0_5_now = d[736 + lane]
        a_0_6_now = d[768 + lane]
        a_0_8_now = d[832 + lane]
        a_0_9_now = d[864 + lane]
        a_0_10_now = d[896 + lane]
        a_0_11_now = d[928 + lane]
        a_0_12_now = d[960 + lane]
        a_0_13_now = d[992 + lane]
        a_0_15_now = d[1056 + lane]
        a_0_16_now = d[1088 + lane]
        a_0_17_now = d[1120 + lane]
        a_0_18_now = d[1152 + lane]
        a_0_19_now = d[1184 + lane]
        a_0_20_now = d[1216 + lane]
        a_1_1_now = d[1856 + lane]
        a_1_2_now = d[1888 + lane]
        a_1_3_now = d[1920 + lane]
        a_1_4_now = d[1952 + lane]
        a_1_5_now = d[1984 + lane]
        a_1_6_now = d[2016 + lane]
        a_1_8_now = d[2080 + lane]
        a_1_9_now = d[2112 + lane]
        a_1_10_now = d[2144 + lane]
        a_1_11_now = d[2176 + lane]
        a_1_12_now = d[2208 + lane]
        a_1_13_now = d[2240 + lane]
        a_1_15_now = d[2304 + lane]
        a_1_16_now = d[2336 + lane]
        a_1_17_now = d[2368 + lane]
        a_1_18_now = d[2400 + lane]
        a_1_19_now = d[2432 + lane]
        a_1_20_now = d[2464 + lane]
        a_2_1_now = d[3104 + lane]
        a_2_2_now = d[3136 + lane]
        a_2_3_now = d[3168 + lane]
        a_2_4_now = d[3200 + lane]
        a_2_5_now = d[3232 + lane]
        a_2_6_now = d[3264 + lane]
        a_2_8_now = d[3328 + lane]
        a_2_9_now = d[3360 + lane]
        a_2_10_now = d[3392 + lane]
        a_2_11_now = d[3424 + lane]
        a_2_12_now = d[3456 + lane]
        a_2_13_now = d[3488 + lane]
        a_2_15_now = d[3552 + lane]
        a_2_16_now = d[3584 + lane]
        a_2_17_now = d[3616 + lane]
        a_2_18_now = d[3648 + lane]
        a_2_19_now = d[3680 + lane]
        a_2_20_now = d[3712 + lane]
        a_3_1_now = d[4352 + lane]
        a_3_2_now = d[4384 + lane]
        a_3_3_now = d[4416 + lane]
        a_3_4_now = d[4448 + lane]
        a_3_5_now = d[4480 + lane]
        a_3_6_now = d[4512 + lane]
        a_3_8_now = d[4576 + lane]
        a_3_9_now = d[4608 + lane]
        a_3_10_now = d[4640 + lane]
        a_3_11_now = d[4672 + lane]
        a_3_12_now = d[4704 + lane]
        a_3_13_now = d[4736 + lane]
        a_3_15_now = d[4800 + lane]
        a_3_16_now = d[4832 + lane]
        a_3_17_now = d[4864 + lane]
        a_3_18_now = d[4896 + lane]
        a_3_19_now = d[4928 + lane]
        a_3_20_now = d[4960 + lane]
        a_4_1_now = d[5600 + lane]
        a_4_2_now = d[5632 + lane]
        a_4_3_now = d[5664 + lane]
        a_4_4_now = d[5696 + lane]
        a_4_5_now = d[5728 + lane]
        a_4_6_now = d[5760 + lane]
        a_4_8_now = d[5824 + lane]
        a_4_9_now = d[5856 + lane]
        a_4_10_now = d[5888 + lane]
        a_4_11_now = d[5920 + lane]
        a_4_12_now = d[5952 + lane]
        a_4_13_now = d[5984 + lane]
        a_4_15_now = d[6048 + lane]
        a_4_16_now = d[6080 + lane]
        a_4_17_now = d[6112 + lane]
        a_4_18_now = d[6144 + lane]
        a_4_19_now = d[6176 + lane]
        a_4_20_now = d[6208 + lane]
        a_5_1_now = d[6848 + lane]
        a_5_2_now = d[6880 + lane]
        a_5_3_now = d[6912 + lane]
        a_5_4_now = d[6944 + lane]
        a_5_5_now = d[6976 + lane]
        a_5_6_now = d[7008 + lane]
        a_5_8_now = d[7072 + lane]
        a_5_9_now = d[7104 + lane]
        a_5_10_now = d[7136 + lane]
        a_5_11_now = d[7168 + lane]
        a_5_12_now = d[7200 + lane]
        a_5_13_now = d[7232 + lane]
        a_5_15_now = d[7296 + lane]
        a_5_16_now = d[7328 + lane]
        a_5_17_now = d[7360 + lane]
        a_5_18_now = d[7392 + lane]
        a_5_19_now = d[7424 + lane]
        a_5_20_now = d[7456 + lane]
        a_p_0_now = s[1728 + lane]
        a_p_1_now = s[1760 + lane]
        a_p_2_now = s[1792 + lane]
        a_p_3_now = s[1824 + lane]
        a_p_4_now = s[1856 + lane]
        a_p_5_now = s[1888 + lane]
        a_p_6_now = s[1920 + lane]
        a_p_7_now = s[1952 + lane]
        a_p_8_now = s[1984 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_0_2_now = s[64 + lane]
        V_0_3_now = s[96 + lane]
        V_0_4_now = s[128 + lane]
        V_0_5_now = s[160 + lane]
        V_1_0_now = s[192 + lane]
        V_1_1_now = s[224 + lane]
        V_1_2_now = s[256 + lane]
        V_1_3_now = s[288 + lane]
        V_1_4_now = s[320 + lane]
        V_1_5_now = s[352 + lane]
        V_2_0_now = s[384 + lane]
        V_2_1_now = s[416 + lane]
        V_2_2_now = s[448 + lane]
        V_2_3_now = s[480 + lane]
        V_2_4_now = s[512 + lane]
        V_2_5_now = s[544 + lane]
        V_3_0_now = s[576 + lane]
        V_3_1_now = s[608 + lane]
        V_3_2_now = s[640 + lane]
        V_3_3_now = s[672 + lane]
        V_3_4_now = s[704 + lane]
        V_3_5_now = s[736 + lane]
        V_4_0_now = s[768 + lane]
        V_4_1_now = s[800 + lane]
        V_4_2_now = s[832 + lane]
        V_4_3_now = s[864 + lane]
        V_4_4_now = s[896 + lane]
        V_4_5_now = s[928 + lane]
        V_5_0_now = s[960 + lane]
        V_5_1_now = s[992 + lane]
        V_5_2_now = s[1024 + lane]
        V_5_3_now = s[1056 + lane]
        V_5_4_now = s[1088 + lane]
        V_5_5_now = s[1120 + lane]
        a_0_0_now_by = d_by[576 + lane]
        a_0_1_now_by = d_by[608 + lane]
        a_0_2_now_by = d_by[640 + lane]
        a_0_3_now_by = d_by[672 + lane]
        a_0_4_now_by = d_by[704 + lane]
        a_0_5_now_by = d_by[736 + lane]
        a_0_6_now_by = d_by[768 + lane]
        a_0_7_now_by = d_by[800 + lane]
        a_0_8_now_by = d_by[832 + lane]
        a_0_9_now_by = d_by[864 + lane]
        a_0_10_now_by = d_by[896 + lane]
        a_0_11_now_by = d_by[928 + lane]
        a_0_12_now_by = d_by[960 + lane]
        a_0_13_now_by = d_by[992 + lane]
        a_0_14_now_by = d_by[1024 + lane]
        a_0_15_now_by = d_by[1056 + lane]
        a_0_16_now_by = d_by[1088 + lane]
        a_0_17_now_by = d_by[1120 + lane]
        a_0_18_now_by = d_by[1152 + lane]
        a_0_19_now_by = d_by[1184 + lane]
        a_0_20_now_by = d_by[1216 + lane]
        a_1_0_now_by = d_by[1824 + lane]
        a_1_1_now_by = d_by[1856 + lane]
        a_1_2_now_by = d_by[1888 + lane]
        a_1_3_now_by = d_by[1920 + lane]
        a_1_4_now_by = d_by[1952 + lane]
        a_1_5_now_by = d_by[1984 + lane]
        a_1_6_now_by = d_by[2016 + lane]
        a_1_7_now_by = d_by[2048 + lane]
        a_1_8_now_by = d_by[2080 + lane]
        a_1_9_now_by = d_by[2112 + lane]
        a_1_10_now_by = d_by[2144 + lane]
        a_1_11_now_by = d_by[2176 + lane]
        a_1_12_now_by = d_by[2208 + lane]
        a_1_13_now_by = d_by[2240 + lane]
        a_1_14_now_by = d_by[2272 + lane]
        a_1_15_now_by = d_by[2304 + lane]
        a_1_16_now_by = d_by[2336 + lane]
        a_1_17_now_by = d_by[2368 + lane]
        a_1_18_now_by = d_by[2400 + lane]
        a_1_19_now_by = d_by[2432 + lane]
        a_1_20_now_by = d_by[2464 + lane]
        a_2_0_now_by = d_by[3072 + lane]
        a_2_1_now_by = d_by[3104 + lane]
        a_2_2_now_by = d_by[3136 + lane]
        a_2_3_now_by = d_by[3168 + lane]
        a_2_4_now_by = d_by[3200 + lane]
        a_2_5_now_by = d_by[3232 + lane]
        a_2_6_now_by = d_by[3264 + lane]
        a_2_7_now_by = d_by[3296 + lane]
        a_2_8_now_by = d_by[3328 + lane]
        a_2_9_now_by = d_by[3360 + lane]
        a_2_10_now_by = d_by[3392 + lane]
        a_2_11_now_by = d_by[3424 + lane]
        a_2_12_now_by = d_by[3456 + lane]
        a_2_13_now_by = d_by[3488 + lane]
        a_2_14_now_by = d_by[3520 + lane]
        a_2_15_now_by = d_by[3552 + lane]
        a_2_16_now_by = d_by[3584 + lane]
        a_2_17_now_by = d_by[3616 + lane]
        a_2_18_now_by = d_by[3648 + lane]
        a_2_19_now_by = d_by[3680 + lane]
        a_2_20_now_by = d_by[3712 + lane]
        a_3_0_now_by = d_by[4320 + lane]
        a_3_1_now_by = d_by[4352 + lane]
        a_3_2_now_by = d_by[4384 + lane]
        a_3_3_now_by = d_by[4416 + lane]
        a_3_4_now_by = d_by[4448 + lane]
        a_3_5_now_by = d_by[4480 + lane]
        a_3_6_now_by = d_by[4512 + lane]
        a_3_7_now_by = d_by[4544 + lane]
        a_3_8_now_by = d_by[4576 + lane]
        a_3_9_now_by = d_by[4608 + lane]
        a_3_10_now_by = d_by[4640 + lane]
        a_3_11_now_by = d_by[4672 + lane]
        a_3_12_now_by = d_by[4704 + lane]
        a_3_13_now_by = d_by[4736 + lane]
        a_3_14_now_by = d_by[4768 + lane]
        a_3_15_now_by = d_by[4800 + lane]
        a_3_16_now_by = d_by[4832 + lane]
        a_3_17_now_by = d_by[4864 + lane]
        a_3_18_now_by = d_by[4896 + lane]
        a_3_19_now_by = d_by[4928 + lane]
        a_3_20_now_by = d_by[4960 + lane]
        a_4_0_now_by = d_by[5568 + lane]
        a_4_1_now_by = d_by[5600 + lane]
        a_4_2_now_by = d_by[5632 + lane]
        a_4_3_now_by = d_by[5664 + lane]
        a_4_4_now_by = d_by[5696 + lane]
        a_4_5_now_by = d_by[5728 + lane]
        a_4_6_now_by = d_by[5760 + lane]
        a_4_7_now_by = d_by[5792 + lane]
        a_4_8_now_by = d_by[5824 + lane]
        a_4_9_now_by = d_by[5856 + lane]
        a_4_10_now_by = d_by[5888 + lane]
        a_4_11_now_by = d_by[5920 + lane]
        a_4_12_now_by = d_by[5952 + lane]
        a_4_13_now_by = d_by[5984 + lane]
        a_4_14_now_by = d_by[6016 + lane]
        a_4_15_now_by = d_by[6048 + lane]
        a_4_16_now_by = d_by[6080 + lane]
        a_4_17_now_by = d_by[6112 + lane]
        a_4_18_now_by = d_by[6144 + lane]
        a_4_19_now_by = d_by[6176 + lane]
        a_4_20_now_by = d_by[6208 + lane]
        a_5_0_now_by = d_by[6816 + lane]
        a_5_1_now_by = d_by[6848 + lane]
        a_5_2_now_by = d_by[6880 + lane]
        a_5_3_now_by = d_by[6912 + lane]
        a_5_4_now_by = d_by[6944 + lane]
        a_5_5_now_by = d_by[6976 + lane]
        a_5_6_now_by = d_by[7008 + lane]
        a_5_7_now_by = d_by[7040 + lane]
        a_5_8_now_by = d_by[7072 + lane]
        a_5_9_now_by = d_by[7104 + lane]
        a_5_10_now_by = d_by[7136 + lane]
        a_5_11_now_by = d_by[7168 + lane]
        a_5_12_now_by = d_by[7200 + lane]
        a_5_13_now_by = d_by[7232 + lane]
        a_5_14_now_by = d_by[7264 + lane]
        a_5_15_now_by = d_by[7296 + lane]
        a_5_16_now_by = d_by[7328 + lane]
        a_5_17_now_by = d_by[7360 + lane]
        a_5_18_now_by = d_by[7392 + lane]
        a_5_19_now_by = d_by[7424 + lane]
        a_5_20_now_by = d_by[7456 + lane]
        a_p_0_now_by = s_by[1728 + lane]
        a_p_1_now_by = s_by[1760 + lane]
        a_p_2_now_by = s_by[1792 + lane]
        a_p_3_now_by = s_by[1824 + lane]
        a_p_4_now_by = s_by[1856 + lane]
        a_p_5_now_by = s_by[1888 + lane]
        a_p_6_now_by = s_by[1920 + lane]
        a_p_7_now_by = s_by[1952 + lane]
        a_p_8_now_by = s_by[1984 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_0_2_now_by = s_by[64 + lane]
        V_0_3_now_by = s_by[96 + lane]
        V_0_4_now_by = s_by[128 + lane]
        V_0_5_now_by = s_by[160 + lane]
        V_1_0_now_by = s_by[192 + lane]
        V_1_1_now_by = s_by[224 + lane]
        V_1_2_now_by = s_by[256 + lane]
        V_1_3_now_by = s_by[288 + lane]
        V_1_4_now_by = s_by[320 + lane]
        V_1_5_now_by = s_by[352 + lane]
        V_2_0_now_by = s_by[384 + lane]
        V_2_1_now_by = s_by[416 + lane]
        V_2_2_now_by = s_by[448 + lane]
        V_2_3_now_by = s_by[480 + lane]
        V_2_4_now_by = s_by[512 + lane]
        V_2_5_now_by = s_by[544 + lane]
        V_3_0_now_by = s_by[576 + lane]
        V_3_1_now_by = s_by[608 + lane]
        V_3_2_now_by = s_by[640 + lane]
        V_3_3_now_by = s_by[672 + lane]
        V_3_4_now_by = s_by[704 + lane]
        V_3_5_now_by = s_by[736 + lane]
        V_4_0_now_by = s_by[768 + lane]
        V_4_1_now_by = s_by[800 + lane]
        V_4_2_now_by = s_by[832 + lane]
        V_4_3_now_by = s_by[864 + lane]
        V_4_4_now_by = s_by[896 + lane]
        V_4_5_now_by = s_by[928 + lane]
        V_5_0_now_by = s_by[960 + lane]
        V_5_1_now_by = s_by[992 + lane]
        V_5_2_now_by = s_by[1024 + lane]
        V_5_3_now_by = s_by[1056 + lane]
        V_5_4_now_by = s_by[1088 + lane]
        V_5_5_now_by = s_by[1120 + lane]
        s0_now = a_0_1_now*m_0_now
        s1_now = a_0_15_now*m_2_now
        s2_now = a_0_8_now*m_1_now
        s3_now = a_1_1_now*m_3_now
        s4_now = a_1_15_now*m_5_now
        s5_now = a_1_8_now*m_4_now
        s6_now = a_2_1_now*m_6_now
        s7_now = a_2_15_now*m_8_now
        s8_now = a_2_8_now*m_7_now
        s9_now = a_3_1_now*m_9_now
        s10_now = a_3_15_now*m_11_now
        s11_now = a_3_8_now*m_10_now
        s12_now = a_4_1_now*m_12_now
        s13_now = a_4_15_now*m_14_now
        s14_now = a_4_8_now*m_13_now
        s15_now = a_5_1_now*m_15_now
        s16_now = a_5_15_now*m_17_now
        s17_now = a_5_8_now*m_16_now
        s18_now = a_p_0_now*m_18_now
        s19_now = a_p_6_now*m_19_now
        W_0_now = s0_now + s10_now + s11_now + s12_now + s13_now + s14_now + s15_now + s16_now + s17_now + s18_now + s19_now + s1_now + s2_now + s3_now + s4_now + s5_now + s6_now + s7_now + s8_now + s9_now
        s21_now = a_0_16_now*m_2_now
        s22_now = a_0_2_now*m_0_now
        s23_now = a_0_9_now*m_1_now
        s24_now = a_1_16_now*m_5_now
        s25_now = a_1_2_now*m_3_now
        s26_now = a_1_9_now*m_4_now
        s27_now = a_2_16_now*m_8_now
        s28_now = a_2_2_now*m_6_now
        s29_now = a_2_9_now*m_7_now
        s30_now = a_3_16_now*m_11_now
        s31_now = a_3_2_now*m_9_now
        s32_now = a_3_9_now*m_10_now
        s33_now = a_4_16_now*m_14_now
        s34_now = a_4_2_now*m_12_now
        s35_now = a_4_9_now*m_13_now
        s36_now = a_5_16_now*m_17_now
        s37_now = a_5_2_now*m_15_now
        s38_now = a_5_9_now*m_16_now
        s39_now = a_p_1_now*m_18_now
        s40_now = a_p_7_now*m_19_now
        W_1_now = s21_now + s22_now + s23_now + s24_now + s25_now + s26_now + s27_now + s28_now + s29_now + s30_now + s31_now + s32_now + s33_now + s34_now + s35_now + s36_now + s37_now + s38_now + s39_now + s40_now
        s42_now = a_0_10_now*m_1_now
        s43_now = a_0_17_now*m_2_now
        s44_now = a_0_3_now*m_0_now
        s45_now = a_1_10_now*m_4_now
        s46_now = a_1_17_now*m_5_now
        s47_now = a_1_3_now*m_3_now
        s48_now = a_2_10_now*m_7_now
        s49_now = a_2_17_now*m_8_now
        s50_now = a_2_3_now*m_6_now
        s51_now = a_3_10_now*m_10_now
        s52_now = a_3_17_now*m_11_now
        s53_now = a_3_3_now*m_9_now
        s54_now = a_4_10_now*m_13_now
        s55_now = a_4_17_now*m_14_now
        s56_now = a_4_3_now*m_12_now
        s57_now = a_5_10_now*m_16_now
        s58_now = a_5_17_now*m_17_now
        s59_now = a_5_3_now*m_15_now
        s60_now = a_p_2_now*m_18_now
        s61_now = a_p_8_now*m_19_now
        W_2_now = s42_now + s43_now + s44_now + s45_now + s46_now + s47_now + s48_now + s49_now + s50_now + s51_now + s52_now + s53_now + s54_now + s55_now + s56_now + s57_now + s58_now + s59_now + s60_now + s61_now
        s63_now = a_0_11_now*m_1_now
        s64_now = a_0_18_now*m_2_now
        s65_now = a_0_4_now*m_0_now
        s66_now = a_1_11_now*m_4_now
        s67_now = a_1_18_now*m_5_now
        s68_now = a_1_4_now*m_3_now
        s69_now = a_2_11_now*m_7_now
        s70_now = a_2_18_now*m_8_now
        s71_now = a_2_4_now*m_6_now
        s72_now = a_3_11_now*m_10_now
        s73_now = a_3_18_now*m_11_now
        s74_now = a_3_4_now*m_9_now
        s75_now = a_4_11_now*m_13_now
        s76_now = a_4_18_now*m_14_now
        s77_now = a_4_4_now*m_12_now
        s78_now = a_5_11_now*m_16_now
        s79_now = a_5_18_now*m_17_now
        s80_now = a_5_4_now*m_15_now
        s81_now = a_p_3_now*m_18_now
        W_3_now = s63_now + s64_now + s65_now + s66_now + s67_now + s68_now + s69_now + s70_now + s71_now + s72_now + s73_now + s74_now + s75_now + s76_now + s77_now + s78_now + s79_now + s80_now + s81_now
        s83_now = a_0_12_now*m_1_now
        s84_now = a_0_19_now*m_2_now
        s85_now = a_0_5_now*m_0_now
        s86_now = a_1_12_now*m_4_now
        s87_now = a_1_19_now*m_5_now
        s88_now = a_1_5_now*m_3_now
        s89_now = a_2_12_now*m_7_now
        s90_now = a_2_19_now*m_8_now
        s91_now = a_2_5_now*m_6_now
        s92_now = a_3_12_now*m_10_now
        s93_now = a_3_19_now*m_11_now
        s94_now = a_3_5_now*m_9_now
        s95_now = a_4_12_now*m_13_now
        s96_now = a_4_19_now*m_14_now
        s97_now = a_4_5_now*m_12_now
        s98_now = a_5_12_now*m_16_now
        s99_now = a_5_19_now*m_17_now
        s100_now = a_5_5_now*m_15_now
        s101_now = a_p_4_now*m_18_now
        W_4_now = s100_now + s101_now + s83_now + s84_now + s85_now + s86_now + s87_now + s88_now + s89_now + s90_now + s91_now + s92_now + s93_now + s94_now + s95_now + s96_now + s97_now + s98_now + s99_now
        s103_now = a_0_13_now*m_1_now
        s104_now = a_0_20_now*m_2_now
        s105_now = a_0_6_now*m_0_now
        s106_now = a_1_13_now*m_4_now
        s107_now = a_1_20_now*m_5_now
        s108_now = a_1_6_now*m_3_now
        s109_now = a_2_13_now*m_7_now
        s110_now = a_2_20_now*m_8_now
        s111_now = a_2_6_now*m_6_now
        s112_now = a_3_13_now*m_10_now
        s113_now = a_3_20_now*m_11_now
        s114_now = a_3_6_now*m_9_now
        s115_now = a_4_13_now*m_13_now
        s116_now = a_4_20_now*m_14_now
        s117_now = a_4_6_now*m_12_now
        s118_now = a_5_13_now*m_16_now
        s119_now = a_5_20_now*m_17_now
        s120_now = a_5_6_now*m_15_now
        s121_now = a_p_5_now*m_18_now
        W_5_now = s103_now + s104_now + s105_now + s106_now + s107_now + s108_now + s109_now + s110_now + s111_now + s112_now + s113_now + s114_now + s115_now + s116_now + s117_now + s118_now + s119_now + s120_now + s121_now
        s183 = a_0_1_now_by*m_0_now
        s184 = a_0_15_now_by*m_2_now
        s185 = a_0_8_now_by*m_1_now
        s186 = a_1_1_now_by*m_3_now
        s187 = a_1_15_now_by*m_5_now
        s188 = a_1_8_now_by*m_4_now
        s189 = a_2_1_now_by*m_6_now
        s190 = a_2_15_now_by*m_8_now
        s191 = a_2_8_now_by*m_7_now
        s192 = a_3_1_now_by*m_9_now
        s193 = a_3_15_now_by*m_11_now
        s194 = a_3_8_now_by*m_10_now
        s195 = a_4_1_now_by*m_12_now
        s196 = a_4_15_now_by*m_14_now
        s197 = a_4_8_now_by*m_13_now
        s198 = a_5_1_now_by*m_15_now
        s199 = a_5_15_now_by*m_17_now
        s200 = a_5_8_now_by*m_16_now
        s201 = a_p_0_now_by*m_18_now
        s202 = a_p_6_now_by*m_19_now
        s203 = s183 + s184 + s185 + s186 + s187 + s188 + s189 + s190 + s191 + s192 + s193 + s194 + s195 + s196 + s197 + s198 + s199 + s200 + s201 + s202
        s204 = a_0_16_now_by*m_2_now
        s205 = a_0_2_now_by*m_0_now
        s206 = a_0_9_now_by*m_1_now
        s207 = a_1_16_now_by*m_5_now
        s208 = a_1_2_now_by*m_3_now
        s209 = a_1_9_now_by*m_4_now
        s210 = a_2_16_now_by*m_8_now
        s211 = a_2_2_now_by*m_6_now
        s212 = a_2_9_now_by*m_7_now
        s213 = a_3_16_now_by*m_11_now
        s214 = a_3_2_now_by*m_9_now
        s215 = a_3_9_now_by*m_10_now
        s216 = a_4_16_now_by*m_14_now
        s217 = a_4_2_now_by*m_12_now
        s218 = a_4_9_now_by*m_13_now
        s219 = a_5_16_now_by*m_17_now
        s220 = a_5_2_now_by*m_15_now
        s221 = a_5_9_now_by*m_16_now
        s222 = a_p_1_now_by*m_18_now
        s223 = a_p_7_now_by*m_19_now
        s224 = s204 + s205 + s206 + s207 + s208 + s209 + s210 + s211 + s212 + s213 + s214 + s215 + s216 + s217 + s218 + s219 + s220 + s221 + s222 + s223
        s225 = a_0_10_now_by*m_1_now
        s226 = a_0_17_now_by*m_2_now
        s227 = a_0_3_now_by*m_0_now
        s228 = a_1_10_now_by*m_4_now
        s229 = a_1_17_now_by*m_5_now
        s230 = a_1_3_now_by*m_3_now
        s231 = a_2_10_now_by*m_7_now
        s232 = a_2_17_now_by*m_8_now
        s233 = a_2_3_now_by*m_6_now
        s234 = a_3_10_now_by*m_10_now
        s235 = a_3_17_now_by*m_11_now
        s236 = a_3_3_now_by*m_9_now
        s237 = a_4_10_now_by*m_13_now
        s238 = a_4_17_now_by*m_14_now
        s239 = a_4_3_now_by*m_12_now
        s240 = a_5_10_now_by*m_16_now
        s241 = a_5_17_now_by*m_17_now
        s242 = a_5_3_now_by*m_15_now
        s243 = a_p_2_now_by*m_18_now
        s244 = a_p_8_now_by*m_19_now
        s245 = s225 + s226 + s227 + s228 + s229 + s230 + s231 + s232 + s233 + s234 + s235 + s236 + s237 + s238 + s239 + s240 + s241 + s242 + s243 + s244
        s246 = a_0_11_now_by*m_1_now
        s247 = a_0_18_now_by*m_2_now
        s248 = a_0_4_now_by*m_0_now
        s249 = a_1_11_now_by*m_4_now
        s250 = a_1_18_now_by*m_5_now
        s251 = a_1_4_now_by*m_3_now
        s252 = a_2_11_now_by*m_7_now
        s253 = a_2_18_now_by*m_8_now
        s254 = a_2_4_now_by*m_6_now
        s255 = a_3_11_now_by*m_10_now
        s256 = a_3_18_now_by*m_11_now
        s257 = a_3_4_now_by*m_9_now
        s258 = a_4_11_now_by*m_13_now
        s259 = a_4_18_now_by*m_14_now
        s260 = a_4_4_now_by*m_12_now
        s261 = a_5_11_now_by*m_16_now
        s262 = a_5_18_now_by*m_17_now
        s263 = a_5_4_now_by*m_15_now
        s264 = a_p_3_now_by*m_18_now
        s265 = s246 + s247 + s248 + s249 + s250 + s251 + s252 + s253 + s254 + s255 + s256 + s257 + s258 + s259 + s260 + s261 + s262 + s263 + s264
        s266 = a_0_12_now_by*m_1_now
        s267 = a_0_19_now_by*m_2_now
        s268 = a_0_5_now_by*m_0_now
        s269 = a_1_12_now_by*m_4_now
        s270 = a_1_19_now_by*m_5_now
        s271 = a_1_5_now_by*m_3_now
        s272 = a_2_12_now_by*m_7_now
        s273 = a_2_19_now_by*m_8_now
        s274 = a_2_5_now_by*m_6_now
        s275 = a_3_12_now_by*m_10_now
        s276 = a_3_19_now_by*m_11_now
        s277 = a_3_5_now_by*m_9_now
        s278 = a_4_12_now_by*m_13_now
        s279 = a_4_19_now_by*m_14_now
        s280 = a_4_5_now_by*m_12_now
        s281 = a_5_12_now_by*m_16_now
        s282 = a_5_19_now_by*m_17_now
        s283 = a_5_5_now_by*m_15_now
        s284 = a_p_4_now_by*m_18_now
        s285 = s266 + s267 + s268 + s269 + s270 + s271 + s272 + s273 + s274 + s275 + s276 + s277 + s278 + s279 + s280 + s281 + s282 + s283 + s284
        s286 = a_0_13_now_by*m_1_now
        s287 = a_0_20_now_by*m_2_now
        s288 = a_0_6_now_by*m_0_now
        s289 = a_1_13_now_by*m_4_now
        s290 = a_1_20_now_by*m_5_now
        s291 = a_1_6_now_by*m_3_now
        s292 = a_2_13_now_by*m_7_now
        s293 = a_2_20_now_by*m_8_now
        s294 = a_2_6_now_by*m_6_now
        s295 = a_3_13_now_by*m_10_now
        s296 = a_3_20_now_by*m_11_now
        s297 = a_3_6_now_by*m_9_now
        s298 = a_4_13_now_by*m_13_now
        s299 = a_4_20_now_by*m_14_now
        s300 = a_4_6_now_by*m_12_now
        s301 = a_5_13_now_by*m_16_now
        s302 = a_5_20_now_by*m_17_now
        s303 = a_5_6_now_by*m_15_now
        s304 = a_p_5_now_by*m_18_now
        s305 = s286 + s287 + s288 + s289 + s290 + s291 + s292 + s293 + s294 + s295 + s296 + s297 + s298 + s299 + s300 + s301 + s302 + s303 + s304
        s311 = -V_5_0_now*s305 - V_5_0_now_by*W_5_now
        s313 = -a_0_14_now_by*m_2_now
        s314 = -a_0_7_now_by*m_1_now
        s317 = -V_0_0_now*s203 - V_0_0_now_by*W_0_now
        s320 = -V_1_0_now*s224 - V_1_0_now_by*W_1_now
        s323 = -V_2_0_now*s245 - V_2_0_now_by*W_2_now
        s326 = -V_3_0_now*s265 - V_3_0_now_by*W_3_now
        s327 = -V_4_0_now*s285 - V_4_0_now_by*W_4_now - a_0_0_now_by*m_0_now + s311 + s313 + s314 + s317 + s320 + s323 + s326
        s333 = -V_5_1_now*s305 - V_5_1_now_by*W_5_now
        s335 = -a_1_14_now_by*m_5_now
        s336 = -a_1_7_now_by*m_4_now
        s339 = -V_0_1_now*s203 - V_0_1_now_by*W_0_now
        s342 = -V_1_1_now*s224 - V_1_1_now_by*W_1_now
        s345 = -V_2_1_now*s245 - V_2_1_now_by*W_2_now
        s348 = -V_3_1_now*s265 - V_3_1_now_by*W_3_now
        s349 = -V_4_1_now*s285 - V_4_1_now_by*W_4_now - a_1_0_now_by*m_3_now + s333 + s335 + s336 + s339 + s342 + s345 + s348
        s355 = -V_5_2_now*s305 - V_5_2_now_by*W_5_now
        s357 = -a_2_14_now_by*m_8_now
        s358 = -a_2_7_now_by*m_7_now
        s361 = -V_0_2_now*s203 - V_0_2_now_by*W_0_now
        s364 = -V_1_2_now*s224 - V_1_2_now_by*W_1_now
        s367 = -V_2_2_now*s245 - V_2_2_now_by*W_2_now
        s370 = -V_3_2_now*s265 - V_3_2_now_by*W_3_now
        s371 = -V_4_2_now*s285 - V_4_2_now_by*W_4_now - a_2_0_now_by*m_6_now + s355 + s357 + s358 + s361 + s364 + s367 + s370
        s377 = -V_5_3_now*s305 - V_5_3_now_by*W_5_now
        s379 = -a_3_14_now_by*m_11_now
        s380 = -a_3_7_now_by*m_10_now
        s383 = -V_0_3_now*s203 - V_0_3_now_by*W_0_now
        s386 = -V_1_3_now*s224 - V_1_3_now_by*W_1_now
        s389 = -V_2_3_now*s245 - V_2_3_now_by*W_2_now
        s392 = -V_3_3_now*s265 - V_3_3_now_by*W_3_now
        s393 = -V_4_3_now*s285 - V_4_3_now_by*W_4_now - a_3_0_now_by*m_9_now + s377 + s379 + s380 + s383 + s386 + s389 + s392
        s399 = -V_5_4_now*s305 - V_5_4_now_by*W_5_now
        s401 = -a_4_14_now_by*m_14_now
        s402 = -a_4_7_now_by*m_13_now
        s405 = -V_0_4_now*s203 - V_0_4_now_by*W_0_now
        s408 = -V_1_4_now*s224 - V_1_4_now_by*W_1_now
        s411 = -V_2_4_now*s245 - V_2_4_now_by*W_2_now
        s414 = -V_3_4_now*s265 - V_3_4_now_by*W_3_now
        s415 = -V_4_4_now*s285 - V_4_4_now_by*W_4_now - a_4_0_now_by*m_12_now + s399 + s401 + s402 + s405 + s408 + s411 + s414
        s421 = -V_5_5_now*s305 - V_5_5_now_by*W_5_now
        s423 = -a_5_14_now_by*m_17_now
        s424 = -a_5_7_now_by*m_16_now
        s427 = -V_0_5_now*s203 - V_0_5_now_by*W_0_now
        s430 = -V_1_5_now*s224 - V_1_5_now_by*W_1_now
        s433 = -V_2_5_now*s245 - V_2_5_now_by*W_2_now
        s436 = -V_3_5_now*s265 - V_3_5_now_by*W_3_now
        s437 = -V_4_5_now*s285 - V_4_5_now_by*W_4_now - a_5_0_now_by*m_15_now + s421 + s423 + s424 + s427 + s430 + s433 + s436
        s_by[2016 + lane] = s327
        s_by[2048 + lane] = s349
        s_by[2080 + lane] = s371
        s_by[2112 + lane] = s393
        s_by[2144 + lane] = s415
        s_by[2176 + lane] = s437


@straight
def _step_by(moves, w_by, first, last, n):
    """Move the platform by its twists, which a step takes off, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w_by[9984 + lane] = -moves[6 * m + 0]
        w_by[10016 + lane] = -moves[6 * m + 1]
        w_by[10048 + lane] = -moves[6 * m + 2]
        w_by[10080 + lane] = -moves[6 * m + 3]
        w_by[10112 + lane] = -moves[6 * m + 4]
        w_by[10144 + lane] = -moves[6 * m + 5]


@straight
def _held(w, size):
    """Begin with nothing that changes."""
    for n in range(size):
        w[n] = 0.0


@straight
def _pay_by(w, s_by, tau, first, last):
    """Write how what the joints give changes."""
    for lane in range(last - first + 1):
        regular = (w[11424 + lane] > 0.0) & (w[11456 + lane] > 0.0)
        tau[6 * (first + lane) + 0] = s_by[2016 + lane] if regular else math.nan
        tau[6 * (first + lane) + 1] = s_by[2048 + lane] if regular else math.nan
        tau[6 * (first + lane) + 2] = s_by[2080 + lane] if regular else math.nan
        tau[6 * (first + lane) + 3] = s_by[2112 + lane] if regular else math.nan
        tau[6 * (first + lane) + 4] = s_by[2144 + lane] if regular else math.nan
        tau[6 * (first + lane) + 5] = s_by[2176 + lane] if regular else math.nan


@fast
def _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    found, moves = tau.reshape(tau.size), x_by.reshape(x_by.size)
    w_by, d_by, s_by = scratch(WORK), scratch(6 * OWN), scratch(SHARED)
    _held(w_by, WORK)
    _held(d_by, 6 * OWN)
    _held(s_by, SHARED)
    u_1, e_1 = w_by[0:1664], d_by[0 * OWN:1 * OWN]
    u_2, e_2 = w_by[1664:3328], d_by[1 * OWN:2 * OWN]
    u_3, e_3 = w_by[3328:4992], d_by[2 * OWN:3 * OWN]
    u_4, e_4 = w_by[4992:6656], d_by[3 * OWN:4 * OWN]
    u_5, e_5 = w_by[6656:8320], d_by[4 * OWN:5 * OWN]
    u_6, e_6 = w_by[8320:9984], d_by[5 * OWN:6 * OWN]
    w, d, s = scratch(WORK), scratch(6 * OWN), scratch(SHARED)
    w_1 = w[0:1664]
    w_2 = w[1664:3328]
    w_3 = w[3328:4992]
    w_4 = w[4992:6656]
    w_5 = w[6656:8320]
    w_6 = w[8320:9984]
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
            for e in range(len(k_by)):
                k_by_1, own_by_1 = k_by[e, 0], c_by[e, 0]
                k_by_2, own_by_2 = k_by[e, 1], c_by[e, 1]
                k_by_3, own_by_3 = k_by[e, 2], c_by[e, 2]
                k_by_4, own_by_4 = k_by[e, 3], c_by[e, 3]
                k_by_5, own_by_5 = k_by[e, 4], c_by[e, 4]
                k_by_6, own_by_6 = k_by[e, 5], c_by[e, 5]
                _step_by(moves[e * samples * 6 :], w_by, first, last, n)
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
                _early_by(
                    w_4, u_4, d_4, e_4, s, s_by, k_4, k_by_4,
                    gravity, shares[3:], inertia, n,
                )
                _more_by(
                    w_4, u_4, d_4, e_4, s, s_by, k_4, k_by_4,
                    gravity, shares[3:], inertia, n,
                )
                _rows_by(
                    w_4, u_4, d_4, e_4, s, s_by, k_4, k_by_4,
                    gravity, shares[3:], inertia, n,
                )
                _joints_by(
                    w_4, u_4, d_4, e_4, s, s_by, k_4, k_by_4,
                    gravity, shares[3:], inertia, n,
                )
                _early_by(
                    w_5, u_5, d_5, e_5, s, s_by, k_5, k_by_5,
                    gravity, shares[4:], inertia, n,
                )
                _more_by(
                    w_5, u_5, d_5, e_5, s, s_by, k_5, k_by_5,
                    gravity, shares[4:], inertia, n,
                )
                _rows_by(
                    w_5, u_5, d_5, e_5, s, s_by, k_5, k_by_5,
                    gravity, shares[4:], inertia, n,
                )
                _joints_by(
                    w_5, u_5, d_5, e_5, s, s_by, k_5, k_by_5,
                    gravity, shares[4:], inertia, n,
                )
                _early_by(
                    w_6, u_6, d_6, e_6, s, s_by, k_6, k_by_6,
                    gravity, shares[5:], inertia, n,
                )
                _more_by(
                    w_6, u_6, d_6, e_6, s, s_by, k_6, k_by_6,
                    gravity, shares[5:], inertia, n,
                )
                _rows_by(
                    w_6, u_6, d_6, e_6, s, s_by, k_6, k_by_6,
                    gravity, shares[5:], inertia, n,
                )
                _joints_by(
                    w_6, u_6, d_6, e_6, s, s_by, k_6, k_by_6,
                    gravity, shares[5:], inertia, n,
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
                _curved_by(
                    w_4, u_4, d_4, e_4, s, s_by, own_4, own_by_4,
                    gravity, shares[3:], inertia, n,
                )
                _curved_by(
                    w_5, u_5, d_5, e_5, s, s_by, own_5, own_by_5,
                    gravity, shares[4:], inertia, n,
                )
                _curved_by(
                    w_6, u_6, d_6, e_6, s, s_by, own_6, own_by_6,
                    gravity, shares[5:], inertia, n,
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
                _limb_fields_by(
                    w_4, u_4, d_4, e_4, s, s_by, own_4, own_by_4,
                    gravity, shares[3:], inertia, n,
                )
                _limb_asks_by(
                    w_4, u_4, d_4, e_4, s, s_by, own_4, own_by_4,
                    gravity, shares[3:], inertia, n,
                )
                _limb_fields_by(
                    w_5, u_5, d_5, e_5, s, s_by, own_5, own_by_5,
                    gravity, shares[4:], inertia, n,
                )
                _limb_asks_by(
                    w_5, u_5, d_5, e_5, s, s_by, own_5, own_by_5,
                    gravity, shares[4:], inertia, n,
                )
                _limb_fields_by(
                    w_6, u_6, d_6, e_6, s, s_by, own_6, own_by_6,
                    gravity, shares[5:], inertia, n,
                )
                _limb_asks_by(
                    w_6, u_6, d_6, e_6, s, s_by, own_6, own_by_6,
                    gravity, shares[5:], inertia, n,
                )
                _platform_fields_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _platform_asks_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _give_by(w, w_by, d, d_by, s, s_by, k_1, k_by_1, gravity, shares, inertia, n)
                _pay_by(w, s_by, found[e * samples * 6 :], first, last)


def torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    """Fill tau (E, N, 6) [N mm, N]: how `torque` of one machine changes along each of E errors, joints held.

    x_by (E, N, 6) are its platform's twists along them, shift and turn about the axes of {O}; k_by and c_by are
    what `constants_by` makes of them.
    """
    _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau)
