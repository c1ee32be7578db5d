"""Dynamics of `delta`, many samples at once: Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both d0c2c01eca309b2d; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 6)  platform: px py pz cx cy cz
motion (3, N, 3)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 3, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 3, 24)  what `constants` makes of p (M, 3, 22)
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
    ("m_rod", "kg", "mass of each of the two rods"),
)
PLATFORM = (
    ("m_platform", "kg", "mass of the platform, at its centre"),
    ("payload", "kg", "mass at the reference point"),
)
OWN, SHARED = 1280, 2112  # numbers of a limb's second region; of what all share
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
        b = p[22 * lane + 0]
        a = p[22 * lane + 1]
        L = p[22 * lane + 2]
        c = p[22 * lane + 4]
        phi = p[22 * lane + 5]
        theta = p[22 * lane + 6]
        ex = p[22 * lane + 7]
        ey = p[22 * lane + 8]
        ez = p[22 * lane + 9]
        dL = p[22 * lane + 10]
        alpha0 = p[22 * lane + 11]
        beta0 = p[22 * lane + 12]
        dc = p[22 * lane + 15]
        alpha03 = p[22 * lane + 16]
        beta03 = p[22 * lane + 17]
        alpha2 = p[22 * lane + 18]
        beta2 = p[22 * lane + 19]
        tip_v = p[22 * lane + 20]
        tip_w = p[22 * lane + 21]
        s0 = (beta0 * beta0)
        s1 = (alpha0 * alpha0)
        s2 = s0 + s1
        s10 = s2*(s2*(s2*(1.5619206968586225e-16*s0 + 1.5619206968586225e-16*s1 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
        s18 = s2*(s2*(s2*(s2*(s10 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        s19 = s18 + 0.5
        s20 = -s0*s19
        s21 = s20 + 1
        s22 = cosine(phi)
        s31 = s2*(s2*(s2*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
        s39 = s2*(s2*(s2*(s2*(s31 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
        s40 = s39 + 1
        s41 = sine(phi)
        s42 = -beta0*s40*s41
        R0_11 = s21*s22 + s42
        R0_12 = alpha0*beta0*s19*s22 + alpha0*s40*s41
        s47 = -s1*s19
        s48 = s20 + s47 + 1
        s50 = beta0*s22*s40
        R0_13 = s41*s48 + s50
        R0_21 = s21*s41 + s50
        R0_22 = alpha0*beta0*s19*s41 - alpha0*s22*s40
        R0_23 = -s22*s48 - s42
        R0_31 = alpha0*beta0*s19
        R0_32 = s47 + 1
        R0_33 = -alpha0*s40
        s62 = (alpha2 * alpha2)
        s63 = (beta2 * beta2)
        s64 = s62 + s63
        s72 = s64*(s64*(s64*(2.8114572543455206e-15*s62 + 2.8114572543455206e-15*s63 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
        s80 = s64*(s64*(s64*(s64*(s72 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
        s81 = s80 + 1
        s84 = 0.5*c + 0.5*dc
        g_x = beta2*s81*s84
        g_y = -alpha2*s81*s84
        s94 = s64*(s64*(s64*(1.5619206968586225e-16*s62 + 1.5619206968586225e-16*s63 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
        s102 = s64*(s64*(s64*(s64*(s94 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        s103 = s102 + 0.5
        g_z = s84*(-s103*s62 - s103*s63 + 1)
        s108 = alpha0 - alpha03
        s109 = (s108 * s108)
        s110 = beta0 - beta03
        s111 = (s110 * s110)
        s112 = s109 + s111
        s120 = s112*(s112*(s112*(1.5619206968586225e-16*s109 + 1.5619206968586225e-16*s111 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
        s128 = s112*(s112*(s112*(s112*(s120 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        s129 = s128 + 0.5
        s132 = -(s108 * s108)*s129 - (s110 * s110)*s129 + 1
        s141 = s112*(s112*(s112*(2.8114572543455206e-15*s109 + 2.8114572543455206e-15*s111 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
        s149 = s112*(s112*(s112*(s112*(s141 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
        s150 = s149 + 1
        h_x = 0.5*c*(s110*s150*s22 + s132*s41)
        h_y = 0.5*c*(s110*s150*s41 - s132*s22)
        h_z = -0.5*c*s108*s150
        B_x = b*s22 + ex
        B_y = b*s41 + ey
        s184 = L + dL
        s188 = B_x + R0_13*tip_w
        s193 = B_y + R0_23*tip_w
        s198 = R0_33*tip_w + ez
        s200 = a*s22
        s203 = a*s41
        s218 = R0_13*g_z
        s222 = R0_23*g_z
        s226 = R0_33*g_z
        s577 = (1.0 / (2*L + 2*dL))
        s639 = 0.5/(s184 * s184)
        k[24 * lane + 0] = theta
        k[24 * lane + 1] = R0_11
        k[24 * lane + 2] = R0_12
        k[24 * lane + 3] = R0_21
        k[24 * lane + 4] = R0_22
        k[24 * lane + 5] = R0_31
        k[24 * lane + 6] = R0_32
        k[24 * lane + 7] = s184
        k[24 * lane + 8] = tip_v
        k[24 * lane + 9] = s188
        k[24 * lane + 10] = s193
        k[24 * lane + 11] = s198
        k[24 * lane + 12] = s200
        k[24 * lane + 13] = s203
        k[24 * lane + 14] = g_x
        k[24 * lane + 15] = g_y
        k[24 * lane + 16] = s218
        k[24 * lane + 17] = s222
        k[24 * lane + 18] = s226
        k[24 * lane + 19] = h_x
        k[24 * lane + 20] = h_y
        k[24 * lane + 21] = h_z
        k[24 * lane + 22] = s577
        k[24 * lane + 23] = s639


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return c (M, 3, 24), what no pose changes of bodies in motion, from p (262 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 3, 24))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (84 operations)."""
    for lane in range(n):
        M_0_0 = w[9312 + lane]
        M_0_1 = w[9344 + lane]
        M_0_2 = w[9376 + lane]
        M_0_3 = w[9408 + lane]
        M_0_4 = w[9440 + lane]
        M_0_5 = w[9472 + lane]
        M_1_0 = w[9504 + lane]
        M_1_1 = w[9536 + lane]
        M_1_2 = w[9568 + lane]
        M_1_3 = w[9600 + lane]
        M_1_4 = w[9632 + lane]
        M_1_5 = w[9664 + lane]
        M_2_0 = w[9696 + lane]
        M_2_1 = w[9728 + lane]
        M_2_2 = w[9760 + lane]
        M_2_3 = w[9792 + lane]
        M_2_4 = w[9824 + lane]
        M_2_5 = w[9856 + lane]
        M_3_0 = w[9888 + lane]
        M_3_1 = w[9920 + lane]
        M_3_2 = w[9952 + lane]
        M_3_3 = w[9984 + lane]
        M_3_4 = w[10016 + lane]
        M_3_5 = w[10048 + lane]
        M_4_0 = w[10080 + lane]
        M_4_1 = w[10112 + lane]
        M_4_2 = w[10144 + lane]
        M_4_3 = w[10176 + lane]
        M_4_4 = w[10208 + lane]
        M_4_5 = w[10240 + lane]
        M_5_0 = w[10272 + lane]
        M_5_1 = w[10304 + lane]
        M_5_2 = w[10336 + lane]
        M_5_3 = w[10368 + lane]
        M_5_4 = w[10400 + lane]
        M_5_5 = w[10432 + lane]
        q_t_0 = d[0 + lane]
        Q_0 = w[832 + lane]
        Q_3 = w[1088 + lane]
        q_t_1 = d[1280 + lane]
        Q_1 = w[3840 + lane]
        Q_4 = w[4096 + lane]
        q_t_2 = d[2560 + lane]
        Q_2 = w[6848 + lane]
        Q_5 = w[7104 + lane]
        V_0_0 = M_0_0*Q_0 + M_0_3*Q_3
        V_0_1 = M_0_1*Q_1 + M_0_4*Q_4
        V_0_2 = M_0_2*Q_2 + M_0_5*Q_5
        V_1_0 = M_1_0*Q_0 + M_1_3*Q_3
        V_1_1 = M_1_1*Q_1 + M_1_4*Q_4
        V_1_2 = M_1_2*Q_2 + M_1_5*Q_5
        V_2_0 = M_2_0*Q_0 + M_2_3*Q_3
        V_2_1 = M_2_1*Q_1 + M_2_4*Q_4
        V_2_2 = M_2_2*Q_2 + M_2_5*Q_5
        V_3_0 = M_3_0*Q_0 + M_3_3*Q_3
        V_3_1 = M_3_1*Q_1 + M_3_4*Q_4
        V_3_2 = M_3_2*Q_2 + M_3_5*Q_5
        V_4_0 = M_4_0*Q_0 + M_4_3*Q_3
        V_4_1 = M_4_1*Q_1 + M_4_4*Q_4
        V_4_2 = M_4_2*Q_2 + M_4_5*Q_5
        V_5_0 = M_5_0*Q_0 + M_5_3*Q_3
        V_5_1 = M_5_1*Q_1 + M_5_4*Q_4
        V_5_2 = M_5_2*Q_2 + M_5_5*Q_5
        s57 = V_0_0*q_t_0 + V_0_1*q_t_1 + V_0_2*q_t_2
        s61 = V_1_0*q_t_0 + V_1_1*q_t_1 + V_1_2*q_t_2
        s65 = V_2_0*q_t_0 + V_2_1*q_t_1 + V_2_2*q_t_2
        s69 = V_3_0*q_t_0 + V_3_1*q_t_1 + V_3_2*q_t_2
        s73 = V_4_0*q_t_0 + V_4_1*q_t_1 + V_4_2*q_t_2
        s77 = V_5_0*q_t_0 + V_5_1*q_t_1 + V_5_2*q_t_2
        s[0 + lane] = V_0_0
        s[32 + lane] = V_0_1
        s[64 + lane] = V_0_2
        s[96 + lane] = V_1_0
        s[128 + lane] = V_1_1
        s[160 + lane] = V_1_2
        s[192 + lane] = V_2_0
        s[224 + lane] = V_2_1
        s[256 + lane] = V_2_2
        s[288 + lane] = V_3_0
        s[320 + lane] = V_3_1
        s[352 + lane] = V_3_2
        s[384 + lane] = V_4_0
        s[416 + lane] = V_4_1
        s[448 + lane] = V_4_2
        s[480 + lane] = V_5_0
        s[512 + lane] = V_5_1
        s[544 + lane] = V_5_2
        s[576 + lane] = s57
        s[608 + lane] = s61
        s[640 + lane] = s65
        s[672 + lane] = s69
        s[704 + lane] = s73
        s[736 + lane] = s77


@straight
def _curved(w, d, s, k, gravity, shares, n):
    """Second derivatives of a limb's equations by time where nothing accelerates (336 operations)."""
    theta = k[0]
    R0_11 = k[1]
    R0_12 = k[2]
    R0_21 = k[3]
    R0_22 = k[4]
    R0_31 = k[5]
    R0_32 = k[6]
    s184 = k[7]
    tip_v = k[8]
    s188 = k[9]
    s193 = k[10]
    s198 = k[11]
    s200 = k[12]
    s203 = k[13]
    g_x = k[14]
    g_y = k[15]
    s218 = k[16]
    s222 = k[17]
    s226 = k[18]
    h_x = k[19]
    h_y = k[20]
    h_z = k[21]
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
        v_px = s[576 + lane]
        v_py = s[608 + lane]
        v_pz = s[640 + lane]
        w_x = s[672 + lane]
        w_y = s[704 + lane]
        w_z = s[736 + lane]
        q_t = d[0 + lane]
        s163 = q + theta
        s164 = cosine(s163)
        s166 = sine(s163)
        R1_11 = R0_11*s164 + R0_12*s166
        R1_12 = -R0_11*s166 + R0_12*s164
        R1_21 = R0_21*s164 + R0_22*s166
        R1_22 = -R0_21*s166 + R0_22*s164
        R1_31 = R0_31*s164 + R0_32*s166
        R1_32 = -R0_31*s166 + R0_32*s164
        C_x = R1_11*s184 + R1_12*tip_v + s188
        C_y = R1_21*s184 + R1_22*tip_v + s193
        C_z = R1_31*s184 + R1_32*tip_v + s198
        s201 = s200 - tx
        s204 = s203 - ty
        A_x = R_11*s201 + R_12*s204 - R_13*tz + px
        A_y = R_21*s201 + R_22*s204 - R_23*tz + py
        A_z = R_31*s201 + R_32*s204 - R_33*tz + pz
        c1_x = R1_11*g_x + R1_12*g_y + s218
        c1_y = R1_21*g_x + R1_22*g_y + s222
        c1_z = R1_31*g_x + R1_32*g_y + s226
        a1_x = R_11*h_x + R_12*h_y + R_13*h_z
        a1_y = R_21*h_x + R_22*h_y + R_23*h_z
        a1_z = R_31*h_x + R_32*h_y + R_33*h_z
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = a1_x - c1_x
        s_y = a1_y - c1_y
        s_z = a1_z - c1_z
        s276 = -R_21*w_z + R_31*w_y
        s279 = -R_22*w_z + R_32*w_y
        s282 = -R_23*w_z + R_33*w_y
        s285 = R_11*w_z - R_31*w_x
        s288 = R_12*w_z - R_32*w_x
        s291 = R_13*w_z - R_33*w_x
        s294 = -R_11*w_y + R_21*w_x
        s297 = -R_12*w_y + R_22*w_x
        s300 = -R_13*w_y + R_23*w_x
        s301 = -q_t*s166
        s303 = q_t*s164
        s305 = R0_11*s301 + R0_12*s303
        s308 = -R0_11*s303 + R0_12*s301
        s311 = R0_21*s301 + R0_22*s303
        s314 = -R0_21*s303 + R0_22*s301
        s317 = R0_31*s301 + R0_32*s303
        s320 = -R0_31*s303 + R0_32*s301
        s363 = -s184*s305 + s201*s276 + s204*s279 - s282*tz - s308*tip_v + v_px
        s364 = -s184*s311 + s201*s285 + s204*s288 - s291*tz - s314*tip_v + v_py
        s365 = -s184*s317 + s201*s294 + s204*s297 - s300*tz - s320*tip_v + v_pz
        s366 = -g_x*s305 - g_y*s308 + h_x*s276 + h_y*s279 + h_z*s282
        s367 = -g_x*s311 - g_y*s314 + h_x*s285 + h_y*s288 + h_z*s291
        s368 = -g_x*s317 - g_y*s320 + h_x*s294 + h_y*s297 + h_z*s300
        s400 = -s285*w_z + s294*w_y
        s403 = -s288*w_z + s297*w_y
        s406 = -s291*w_z + s300*w_y
        s409 = s276*w_z - s294*w_x
        s412 = s279*w_z - s297*w_x
        s415 = s282*w_z - s300*w_x
        s418 = -s276*w_y + s285*w_x
        s421 = -s279*w_y + s288*w_x
        s424 = -s282*w_y + s291*w_x
        s425 = -q_t*s303
        s427 = q_t*s301
        s429 = R0_11*s425 + R0_12*s427
        s432 = -R0_11*s427 + R0_12*s425
        s435 = R0_21*s425 + R0_22*s427
        s438 = -R0_21*s427 + R0_22*s425
        s441 = R0_31*s425 + R0_32*s427
        s444 = -R0_31*s427 + R0_32*s425
        s487 = -s184*s429 + s201*s400 + s204*s403 - s406*tz - s432*tip_v
        s488 = -s184*s435 + s201*s409 + s204*s412 - s415*tz - s438*tip_v
        s489 = -s184*s441 + s201*s418 + s204*s421 - s424*tz - s444*tip_v
        s490 = -g_x*s429 - g_y*s432 + h_x*s400 + h_y*s403 + h_z*s406
        s491 = -g_x*s435 - g_y*s438 + h_x*s409 + h_y*s412 + h_z*s415
        s492 = -g_x*s441 - g_y*s444 + h_x*s418 + h_y*s421 + h_z*s424
        s507 = d_z*s489 + (s365 * s365)
        s512 = (s366 * s366) + s490*s_x
        s517 = (s367 * s367) + s491*s_y
        s522 = (s368 * s368) + s492*s_z
        s523 = d_x*s487 + d_y*s488 + (s363 * s363) + (s364 * s364) + s507 + s512 + s517 + s522
        s525 = s363*s366
        s531 = s364*s367
        s537 = s365*s368
        s541 = d_z*s492 + s489*s_z + 2*s537
        s542 = d_x*s490 + d_y*s491 + s487*s_x + s488*s_y + 2*s525 + 2*s531 + s541
        d[64 + lane] = s523
        d[96 + lane] = s542


@straight
def _accelerate(w, d, s, n):
    """The platform's acceleration (102 operations)."""
    for lane in range(n):
        M_0_0 = w[9312 + lane]
        M_0_1 = w[9344 + lane]
        M_0_2 = w[9376 + lane]
        M_0_3 = w[9408 + lane]
        M_0_4 = w[9440 + lane]
        M_0_5 = w[9472 + lane]
        M_1_0 = w[9504 + lane]
        M_1_1 = w[9536 + lane]
        M_1_2 = w[9568 + lane]
        M_1_3 = w[9600 + lane]
        M_1_4 = w[9632 + lane]
        M_1_5 = w[9664 + lane]
        M_2_0 = w[9696 + lane]
        M_2_1 = w[9728 + lane]
        M_2_2 = w[9760 + lane]
        M_2_3 = w[9792 + lane]
        M_2_4 = w[9824 + lane]
        M_2_5 = w[9856 + lane]
        M_3_0 = w[9888 + lane]
        M_3_1 = w[9920 + lane]
        M_3_2 = w[9952 + lane]
        M_3_3 = w[9984 + lane]
        M_3_4 = w[10016 + lane]
        M_3_5 = w[10048 + lane]
        M_4_0 = w[10080 + lane]
        M_4_1 = w[10112 + lane]
        M_4_2 = w[10144 + lane]
        M_4_3 = w[10176 + lane]
        M_4_4 = w[10208 + lane]
        M_4_5 = w[10240 + lane]
        M_5_0 = w[10272 + lane]
        M_5_1 = w[10304 + lane]
        M_5_2 = w[10336 + lane]
        M_5_3 = w[10368 + lane]
        M_5_4 = w[10400 + lane]
        M_5_5 = w[10432 + lane]
        q_tt_0 = d[32 + lane]
        c_0 = d[64 + lane]
        c_3 = d[96 + lane]
        q_tt_1 = d[1312 + lane]
        c_1 = d[1344 + lane]
        c_4 = d[1376 + lane]
        q_tt_2 = d[2592 + lane]
        c_2 = d[2624 + lane]
        c_5 = d[2656 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        V_3_0 = s[288 + lane]
        V_3_1 = s[320 + lane]
        V_3_2 = s[352 + lane]
        V_4_0 = s[384 + lane]
        V_4_1 = s[416 + lane]
        V_4_2 = s[448 + lane]
        V_5_0 = s[480 + lane]
        V_5_1 = s[512 + lane]
        V_5_2 = s[544 + lane]
        s4 = M_0_4*c_4
        s5 = M_0_5*c_5
        s6 = V_0_0*q_tt_0
        s7 = V_0_1*q_tt_1
        s8 = V_0_2*q_tt_2
        s9 = M_0_0*c_0 + M_0_1*c_1 + M_0_2*c_2 + M_0_3*c_3 + s4 + s5 + s6 + s7 + s8
        s14 = M_1_4*c_4
        s15 = M_1_5*c_5
        s16 = V_1_0*q_tt_0
        s17 = V_1_1*q_tt_1
        s18 = V_1_2*q_tt_2
        s19 = M_1_0*c_0 + M_1_1*c_1 + M_1_2*c_2 + M_1_3*c_3 + s14 + s15 + s16 + s17 + s18
        s24 = M_2_4*c_4
        s25 = M_2_5*c_5
        s26 = V_2_0*q_tt_0
        s27 = V_2_1*q_tt_1
        s28 = V_2_2*q_tt_2
        s29 = M_2_0*c_0 + M_2_1*c_1 + M_2_2*c_2 + M_2_3*c_3 + s24 + s25 + s26 + s27 + s28
        s34 = M_3_4*c_4
        s35 = M_3_5*c_5
        s36 = V_3_0*q_tt_0
        s37 = V_3_1*q_tt_1
        s38 = V_3_2*q_tt_2
        s39 = M_3_0*c_0 + M_3_1*c_1 + M_3_2*c_2 + M_3_3*c_3 + s34 + s35 + s36 + s37 + s38
        s44 = M_4_4*c_4
        s45 = M_4_5*c_5
        s46 = V_4_0*q_tt_0
        s47 = V_4_1*q_tt_1
        s48 = V_4_2*q_tt_2
        s49 = M_4_0*c_0 + M_4_1*c_1 + M_4_2*c_2 + M_4_3*c_3 + s44 + s45 + s46 + s47 + s48
        s54 = M_5_4*c_4
        s55 = M_5_5*c_5
        s56 = V_5_0*q_tt_0
        s57 = V_5_1*q_tt_1
        s58 = V_5_2*q_tt_2
        s59 = M_5_0*c_0 + M_5_1*c_1 + M_5_2*c_2 + M_5_3*c_3 + s54 + s55 + s56 + s57 + s58
        s[768 + lane] = s9
        s[800 + lane] = s19
        s[832 + lane] = s29
        s[864 + lane] = s39
        s[896 + lane] = s49
        s[928 + lane] = s59


@straight
def _limb_fields(w, d, s, k, gravity, shares, n):
    """Gravity less acceleration of the points of a limb (293 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    theta = k[0]
    R0_11 = k[1]
    R0_12 = k[2]
    R0_21 = k[3]
    R0_22 = k[4]
    R0_31 = k[5]
    R0_32 = k[6]
    s184 = k[7]
    tip_v = k[8]
    s200 = k[12]
    s203 = k[13]
    g_x = k[14]
    g_y = k[15]
    h_x = k[19]
    h_y = k[20]
    h_z = k[21]
    for lane in range(n):
        q = w[0 + lane]
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
        w_x = s[672 + lane]
        w_y = s[704 + lane]
        w_z = s[736 + lane]
        v_px_t = s[768 + lane]
        v_py_t = s[800 + lane]
        v_pz_t = s[832 + lane]
        w_x_t = s[864 + lane]
        w_y_t = s[896 + lane]
        w_z_t = s[928 + lane]
        q_t = d[0 + lane]
        q_tt = d[32 + lane]
        s163 = q + theta
        s164 = cosine(s163)
        s166 = sine(s163)
        s201 = s200 - tx
        s204 = s203 - ty
        s276 = -R_21*w_z + R_31*w_y
        s279 = -R_22*w_z + R_32*w_y
        s282 = -R_23*w_z + R_33*w_y
        s285 = R_11*w_z - R_31*w_x
        s288 = R_12*w_z - R_32*w_x
        s291 = R_13*w_z - R_33*w_x
        s294 = -R_11*w_y + R_21*w_x
        s297 = -R_12*w_y + R_22*w_x
        s300 = -R_13*w_y + R_23*w_x
        s1344 = -R_21*w_z_t + R_31*w_y_t - s285*w_z + s294*w_y
        s1349 = -R_22*w_z_t + R_32*w_y_t - s288*w_z + s297*w_y
        s1354 = -R_23*w_z_t + R_33*w_y_t - s291*w_z + s300*w_y
        s1359 = R_11*w_z_t - R_31*w_x_t + s276*w_z - s294*w_x
        s1364 = R_12*w_z_t - R_32*w_x_t + s279*w_z - s297*w_x
        s1369 = R_13*w_z_t - R_33*w_x_t + s282*w_z - s300*w_x
        s1374 = -R_11*w_y_t + R_21*w_x_t - s276*w_y + s285*w_x
        s1379 = -R_12*w_y_t + R_22*w_x_t - s279*w_y + s288*w_x
        s1384 = -R_13*w_y_t + R_23*w_x_t - s282*w_y + s291*w_x
        s1386 = -(q_t * q_t)*s164 - q_tt*s166
        s1389 = -(q_t * q_t)*s166 + q_tt*s164
        s1391 = R0_11*s1386 + R0_12*s1389
        s1394 = -R0_11*s1389 + R0_12*s1386
        s1397 = R0_21*s1386 + R0_22*s1389
        s1400 = -R0_21*s1389 + R0_22*s1386
        s1403 = R0_31*s1386 + R0_32*s1389
        s1406 = -R0_31*s1389 + R0_32*s1386
        s1407 = s1391*s184
        s1409 = s1394*tip_v + s1407
        s1410 = s1397*s184
        s1412 = s1400*tip_v + s1410
        s1413 = s1403*s184
        s1415 = s1406*tip_v + s1413
        s1419 = s1344*s201 + s1349*s204 - s1354*tz + v_px_t
        s1423 = s1359*s201 + s1364*s204 - s1369*tz + v_py_t
        s1427 = s1374*s201 + s1379*s204 - s1384*tz + v_pz_t
        s1430 = g_x*s1391 + g_y*s1394
        s1433 = g_x*s1397 + g_y*s1400
        s1436 = g_x*s1403 + g_y*s1406
        s1440 = h_x*s1344 + h_y*s1349 + h_z*s1354
        s1444 = h_x*s1359 + h_y*s1364 + h_z*s1369
        s1448 = h_x*s1374 + h_y*s1379 + h_z*s1384
        s2123 = 0.5*s1419
        s2124 = 0.5*s1409
        s2125 = 0.5*s1440
        s2126 = 0.5*s1430
        s2129 = 0.5*s1423
        s2130 = 0.5*s1412
        s2131 = 0.5*s1444
        s2132 = 0.5*s1433
        s2135 = 0.5*s1427
        s2136 = 0.5*s1415
        s2137 = 0.5*s1448
        s2138 = 0.5*s1436
        s2255 = -0.001*s1407
        s2256 = gx + s2255
        s2257 = -0.001*s1410
        s2258 = gy + s2257
        s2259 = -0.001*s1413
        s2260 = gz + s2259
        s2261 = gx - s2255
        s2262 = gy - s2257
        s2263 = gz - s2259
        s2265 = gx - 0.001*s1409 - 0.001*s1430
        s2267 = gy - 0.001*s1412 - 0.001*s1433
        s2269 = gz - 0.001*s1415 - 0.001*s1436
        s2271 = gx - 0.001*s2123 - 0.001*s2124 - 0.001*s2125 - 0.001*s2126
        s2273 = gy - 0.001*s2129 - 0.001*s2130 - 0.001*s2131 - 0.001*s2132
        s2275 = gz - 0.001*s2135 - 0.001*s2136 - 0.001*s2137 - 0.001*s2138
        s2277 = gx - 0.001*s1419 - 0.001*s1440
        s2279 = gy - 0.001*s1423 - 0.001*s1444
        s2281 = gz - 0.001*s1427 - 0.001*s1448
        s2283 = gx - 0.001*s1409 + 0.001*s1430
        s2285 = gy - 0.001*s1412 + 0.001*s1433
        s2287 = gz - 0.001*s1415 + 0.001*s1436
        s2289 = gx - 0.001*s2123 - 0.001*s2124 + 0.001*s2125 + 0.001*s2126
        s2291 = gy - 0.001*s2129 - 0.001*s2130 + 0.001*s2131 + 0.001*s2132
        s2293 = gz - 0.001*s2135 - 0.001*s2136 + 0.001*s2137 + 0.001*s2138
        s2295 = gx - 0.001*s1419 + 0.001*s1440
        s2297 = gy - 0.001*s1423 + 0.001*s1444
        s2299 = gz - 0.001*s1427 + 0.001*s1448
        d[224 + lane] = s2256
        d[256 + lane] = s2258
        d[288 + lane] = s2260
        d[320 + lane] = s2261
        d[352 + lane] = s2262
        d[384 + lane] = s2263
        d[416 + lane] = s2265
        d[448 + lane] = s2267
        d[480 + lane] = s2269
        d[512 + lane] = s2271
        d[544 + lane] = s2273
        d[576 + lane] = s2275
        d[608 + lane] = s2277
        d[640 + lane] = s2279
        d[672 + lane] = s2281
        d[704 + lane] = s2283
        d[736 + lane] = s2285
        d[768 + lane] = s2287
        d[800 + lane] = s2289
        d[832 + lane] = s2291
        d[864 + lane] = s2293
        d[896 + lane] = s2295
        d[928 + lane] = s2297
        d[960 + lane] = s2299


@straight
def _limb_asks(w, d, s, k, gravity, shares, n):
    """Loads per inertial parameter of a limb, along joint, shifts and turns (222 operations)."""
    share = shares[0]
    theta = k[0]
    R0_11 = k[1]
    R0_12 = k[2]
    R0_21 = k[3]
    R0_22 = k[4]
    R0_31 = k[5]
    R0_32 = k[6]
    s184 = k[7]
    tip_v = k[8]
    s200 = k[12]
    s203 = k[13]
    g_x = k[14]
    g_y = k[15]
    h_x = k[19]
    h_y = k[20]
    h_z = k[21]
    s577 = k[22]
    s639 = k[23]
    for lane in range(n):
        q = w[0 + lane]
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
        f1x = d[224 + lane]
        f1y = d[256 + lane]
        f1z = d[288 + lane]
        f2x = d[320 + lane]
        f2y = d[352 + lane]
        f2z = d[384 + lane]
        f3x = d[416 + lane]
        f3y = d[448 + lane]
        f3z = d[480 + lane]
        f4x = d[512 + lane]
        f4y = d[544 + lane]
        f4z = d[576 + lane]
        f5x = d[608 + lane]
        f5y = d[640 + lane]
        f5z = d[672 + lane]
        f6x = d[704 + lane]
        f6y = d[736 + lane]
        f6z = d[768 + lane]
        f7x = d[800 + lane]
        f7y = d[832 + lane]
        f7z = d[864 + lane]
        f8x = d[896 + lane]
        f8y = d[928 + lane]
        f8z = d[960 + lane]
        s163 = q + theta
        s164 = cosine(s163)
        s166 = sine(s163)
        s201 = s200 - tx
        s204 = s203 - ty
        s608 = s184*(f1z*s577 + f2z*s577)
        s611 = s184*(f1y*s577 + f2y*s577)
        s614 = s184*(f1x*s577 + f2x*s577)
        s631 = -s166*(R0_11*s614 + R0_21*s611 + R0_31*s608)
        s632 = s164*(R0_12*s614 + R0_22*s611 + R0_32*s608) + s631
        s656 = s184*(f1z*s639 - f2z*s639)
        s659 = s184*(f1y*s639 - f2y*s639)
        s662 = s184*(f1x*s639 - f2x*s639)
        s679 = -s166*(R0_11*s662 + R0_21*s659 + R0_31*s656)
        s680 = s164*(R0_12*s662 + R0_22*s659 + R0_32*s656) + s679
        s719 = 1 - 2*share
        s750 = f7z*s719
        s752 = f7y*s719
        s754 = f7x*s719
        s756 = f4z*s719
        s758 = -0.5*s750 + 0.5*s756
        s760 = 0.5*s750 + 0.5*s756
        s762 = f4y*s719
        s764 = -0.5*s752 + 0.5*s762
        s766 = 0.5*s752 + 0.5*s762
        s768 = f4x*s719
        s770 = -0.5*s754 + 0.5*s768
        s772 = 0.5*s754 + 0.5*s768
        s776 = f8z*share
        s778 = f8y*share
        s780 = f8x*share
        s782 = f6z*share
        s784 = f6y*share
        s786 = f6x*share
        s788 = f5z*share
        s790 = f5y*share
        s792 = f5x*share
        s794 = f3z*share
        s796 = f3y*share
        s798 = f3x*share
        s799 = s758 - s776 + s788
        s806 = s764 - s778 + s790
        s813 = s770 - s780 + s792
        s820 = s758 - s782 + s794
        s825 = s764 - s784 + s796
        s830 = s770 - s786 + s798
        s835 = s760 + s776 + s788
        s842 = s766 + s778 + s790
        s849 = s772 + s780 + s792
        s858 = s760 + s782 + s794
        s863 = s766 + s784 + s796
        s868 = s772 + s786 + s798
        s873 = g_y*s820 + s858*tip_v
        s878 = g_x*s820 + s184*s858
        s883 = g_y*s825 + s863*tip_v
        s888 = g_x*s825 + s184*s863
        s893 = g_y*s830 + s868*tip_v
        s898 = g_x*s830 + s184*s868
        s902 = s164*(-R0_11*s893 + R0_12*s898 - R0_21*s883 + R0_22*s888 - R0_31*s873 + R0_32*s878)
        s905 = R0_11*s898 + R0_12*s893 + R0_21*s888 + R0_22*s883 + R0_31*s878 + R0_32*s873
        s907 = -s166*s905 + s902
        s909 = h_z*s799 - s835*tz
        s911 = h_y*s799 + s204*s835
        s913 = h_x*s799 + s201*s835
        s915 = h_z*s806 - s842*tz
        s916 = h_y*s806 + s204*s842
        s917 = h_x*s806 + s201*s842
        s918 = h_z*s813 - s849*tz
        s919 = h_y*s813 + s204*s849
        s920 = h_x*s813 + s201*s849
        s938 = R_21*s913 + R_22*s911 + R_23*s909 - R_31*s917 - R_32*s916 - R_33*s915
        s945 = -R_11*s913 - R_12*s911 - R_13*s909 + R_31*s920 + R_32*s919 + R_33*s918
        s952 = R_11*s917 + R_12*s916 + R_13*s915 - R_21*s920 - R_22*s919 - R_23*s918
        d[992 + lane] = s632
        d[1024 + lane] = s680
        d[1056 + lane] = s907
        d[1088 + lane] = s849
        d[1120 + lane] = s842
        d[1152 + lane] = s835
        d[1184 + lane] = s938
        d[1216 + lane] = s945
        d[1248 + lane] = s952


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
        w_x = s[672 + lane]
        w_y = s[704 + lane]
        w_z = s[736 + lane]
        v_px_t = s[768 + lane]
        v_py_t = s[800 + lane]
        v_pz_t = s[832 + lane]
        w_x_t = s[864 + lane]
        w_y_t = s[896 + lane]
        w_z_t = s[928 + lane]
        s307 = -R_21*w_z + R_31*w_y
        s310 = -R_22*w_z + R_32*w_y
        s313 = -R_23*w_z + R_33*w_y
        s316 = R_11*w_z - R_31*w_x
        s319 = R_12*w_z - R_32*w_x
        s322 = R_13*w_z - R_33*w_x
        s325 = -R_11*w_y + R_21*w_x
        s328 = -R_12*w_y + R_22*w_x
        s331 = -R_13*w_y + R_23*w_x
        s594 = -tx*(-R_21*w_z_t + R_31*w_y_t - s316*w_z + s325*w_y)
        s595 = -ty*(-R_22*w_z_t + R_32*w_y_t - s319*w_z + s328*w_y)
        s596 = s594 + s595 - tz*(-R_23*w_z_t + R_33*w_y_t - s322*w_z + s331*w_y) + v_px_t
        s598 = -tx*(R_11*w_z_t - R_31*w_x_t + s307*w_z - s325*w_x)
        s599 = -ty*(R_12*w_z_t - R_32*w_x_t + s310*w_z - s328*w_x)
        s600 = s598 + s599 - tz*(R_13*w_z_t - R_33*w_x_t + s313*w_z - s331*w_x) + v_py_t
        s602 = -tx*(-R_11*w_y_t + R_21*w_x_t - s307*w_y + s316*w_x)
        s603 = -ty*(-R_12*w_y_t + R_22*w_x_t - s310*w_y + s319*w_x)
        s604 = s602 + s603 - tz*(-R_13*w_y_t + R_23*w_x_t - s313*w_y + s322*w_x) + v_pz_t
        s708 = gx - 0.001*s596
        s710 = gy - 0.001*s600
        s712 = gz - 0.001*s604
        s714 = gx - 0.001*v_px_t
        s716 = gy - 0.001*v_py_t
        s718 = gz - 0.001*v_pz_t
        s[960 + lane] = s708
        s[992 + lane] = s710
        s[1024 + lane] = s712
        s[1056 + lane] = s714
        s[1088 + lane] = s716
        s[1120 + lane] = s718


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
        f0x = s[960 + lane]
        f0y = s[992 + lane]
        f0z = s[1024 + lane]
        f1x = s[1056 + lane]
        f1y = s[1088 + lane]
        f1z = s[1120 + lane]
        s259 = -f0z*ty
        s261 = -f0z*tx
        s263 = -f0y*ty
        s265 = -f0y*tx
        s267 = -f0x*ty
        s269 = -f0x*tx
        s271 = -f0z*tz
        s273 = -f0y*tz
        s275 = -f0x*tz
        s286 = R_21*s261 + R_22*s259 + R_23*s271 - R_31*s265 - R_32*s263 - R_33*s273
        s293 = -R_11*s261 - R_12*s259 - R_13*s271 + R_31*s269 + R_32*s267 + R_33*s275
        s300 = R_11*s265 + R_12*s263 + R_13*s273 - R_21*s269 - R_22*s267 - R_23*s275
        s[1152 + lane] = f0x
        s[1184 + lane] = f0y
        s[1216 + lane] = f0z
        s[1248 + lane] = s286
        s[1280 + lane] = s293
        s[1312 + lane] = s300
        s[1344 + lane] = f1x
        s[1376 + lane] = f1y
        s[1408 + lane] = f1z


@straight
def _give(d, s, inertia, n):
    """What the joints give (114 operations)."""
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
        a_0_0 = d[992 + lane]
        a_0_1 = d[1024 + lane]
        a_0_2 = d[1056 + lane]
        a_0_3 = d[1088 + lane]
        a_0_4 = d[1120 + lane]
        a_0_5 = d[1152 + lane]
        a_0_6 = d[1184 + lane]
        a_0_7 = d[1216 + lane]
        a_0_8 = d[1248 + lane]
        a_1_0 = d[2272 + lane]
        a_1_1 = d[2304 + lane]
        a_1_2 = d[2336 + lane]
        a_1_3 = d[2368 + lane]
        a_1_4 = d[2400 + lane]
        a_1_5 = d[2432 + lane]
        a_1_6 = d[2464 + lane]
        a_1_7 = d[2496 + lane]
        a_1_8 = d[2528 + lane]
        a_2_0 = d[3552 + lane]
        a_2_1 = d[3584 + lane]
        a_2_2 = d[3616 + lane]
        a_2_3 = d[3648 + lane]
        a_2_4 = d[3680 + lane]
        a_2_5 = d[3712 + lane]
        a_2_6 = d[3744 + lane]
        a_2_7 = d[3776 + lane]
        a_2_8 = d[3808 + lane]
        a_p_0 = s[1152 + lane]
        a_p_1 = s[1184 + lane]
        a_p_2 = s[1216 + lane]
        a_p_3 = s[1248 + lane]
        a_p_4 = s[1280 + lane]
        a_p_5 = s[1312 + lane]
        a_p_6 = s[1344 + lane]
        a_p_7 = s[1376 + lane]
        a_p_8 = s[1408 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        V_3_0 = s[288 + lane]
        V_3_1 = s[320 + lane]
        V_3_2 = s[352 + lane]
        V_4_0 = s[384 + lane]
        V_4_1 = s[416 + lane]
        V_4_2 = s[448 + lane]
        V_5_0 = s[480 + lane]
        V_5_1 = s[512 + lane]
        V_5_2 = s[544 + lane]
        W_0 = a_0_3*m_3 + a_1_3*m_7 + a_2_3*m_11 + a_p_0*m_12 + a_p_6*m_13
        W_1 = a_0_4*m_3 + a_1_4*m_7 + a_2_4*m_11 + a_p_1*m_12 + a_p_7*m_13
        W_2 = a_0_5*m_3 + a_1_5*m_7 + a_2_5*m_11 + a_p_2*m_12 + a_p_8*m_13
        W_3 = a_0_6*m_3 + a_1_6*m_7 + a_2_6*m_11 + a_p_3*m_12
        W_4 = a_0_7*m_3 + a_1_7*m_7 + a_2_7*m_11 + a_p_4*m_12
        W_5 = a_0_8*m_3 + a_1_8*m_7 + a_2_8*m_11 + a_p_5*m_12
        s37 = -V_4_0*W_4
        s38 = -V_5_0*W_5
        s39 = -a_0_0*m_1
        s40 = -a_0_1*m_2
        s41 = -a_0_2*m_3
        s42 = -V_0_0*W_0 - V_1_0*W_1 - V_2_0*W_2 - V_3_0*W_3 + s37 + s38 + s39 + s40 + s41
        s47 = -V_4_1*W_4
        s48 = -V_5_1*W_5
        s49 = -a_1_0*m_5
        s50 = -a_1_1*m_6
        s51 = -a_1_2*m_7
        s52 = -V_0_1*W_0 - V_1_1*W_1 - V_2_1*W_2 - V_3_1*W_3 + s47 + s48 + s49 + s50 + s51
        s57 = -V_4_2*W_4
        s58 = -V_5_2*W_5
        s59 = -a_2_0*m_9
        s60 = -a_2_1*m_10
        s61 = -a_2_2*m_11
        s62 = -V_0_2*W_0 - V_1_2*W_1 - V_2_2*W_2 - V_3_2*W_3 + s57 + s58 + s59 + s60 + s61
        s[1440 + lane] = s42
        s[1472 + lane] = s52
        s[1504 + lane] = s62


@straight
def _give_each(d, s, n):
    """What the joints give for each inertial parameter (153 operations)."""
    for lane in range(n):
        a_0_0 = d[992 + lane]
        a_0_1 = d[1024 + lane]
        a_0_2 = d[1056 + lane]
        a_0_3 = d[1088 + lane]
        a_0_4 = d[1120 + lane]
        a_0_5 = d[1152 + lane]
        a_0_6 = d[1184 + lane]
        a_0_7 = d[1216 + lane]
        a_0_8 = d[1248 + lane]
        a_1_0 = d[2272 + lane]
        a_1_1 = d[2304 + lane]
        a_1_2 = d[2336 + lane]
        a_1_3 = d[2368 + lane]
        a_1_4 = d[2400 + lane]
        a_1_5 = d[2432 + lane]
        a_1_6 = d[2464 + lane]
        a_1_7 = d[2496 + lane]
        a_1_8 = d[2528 + lane]
        a_2_0 = d[3552 + lane]
        a_2_1 = d[3584 + lane]
        a_2_2 = d[3616 + lane]
        a_2_3 = d[3648 + lane]
        a_2_4 = d[3680 + lane]
        a_2_5 = d[3712 + lane]
        a_2_6 = d[3744 + lane]
        a_2_7 = d[3776 + lane]
        a_2_8 = d[3808 + lane]
        a_p_0 = s[1152 + lane]
        a_p_1 = s[1184 + lane]
        a_p_2 = s[1216 + lane]
        a_p_3 = s[1248 + lane]
        a_p_4 = s[1280 + lane]
        a_p_5 = s[1312 + lane]
        V_0_0 = s[0 + lane]
        V_0_1 = s[32 + lane]
        V_0_2 = s[64 + lane]
        V_1_0 = s[96 + lane]
        V_1_1 = s[128 + lane]
        V_1_2 = s[160 + lane]
        V_2_0 = s[192 + lane]
        V_2_1 = s[224 + lane]
        V_2_2 = s[256 + lane]
        V_3_0 = s[288 + lane]
        V_3_1 = s[320 + lane]
        V_3_2 = s[352 + lane]
        V_4_0 = s[384 + lane]
        V_4_1 = s[416 + lane]
        V_4_2 = s[448 + lane]
        V_5_0 = s[480 + lane]
        V_5_1 = s[512 + lane]
        V_5_2 = s[544 + lane]
        s5 = -V_5_0*a_0_8
        s6 = -V_0_0*a_0_3 - V_1_0*a_0_4 - V_2_0*a_0_5 - V_3_0*a_0_6 - V_4_0*a_0_7 - a_0_2 + s5
        s13 = -V_0_1*a_0_3 - V_1_1*a_0_4 - V_2_1*a_0_5 - V_3_1*a_0_6 - V_4_1*a_0_7 - V_5_1*a_0_8
        s20 = -V_0_2*a_0_3 - V_1_2*a_0_4 - V_2_2*a_0_5 - V_3_2*a_0_6 - V_4_2*a_0_7 - V_5_2*a_0_8
        s27 = -V_0_0*a_1_3 - V_1_0*a_1_4 - V_2_0*a_1_5 - V_3_0*a_1_6 - V_4_0*a_1_7 - V_5_0*a_1_8
        s33 = -V_5_1*a_1_8
        s34 = -V_0_1*a_1_3 - V_1_1*a_1_4 - V_2_1*a_1_5 - V_3_1*a_1_6 - V_4_1*a_1_7 - a_1_2 + s33
        s41 = -V_0_2*a_1_3 - V_1_2*a_1_4 - V_2_2*a_1_5 - V_3_2*a_1_6 - V_4_2*a_1_7 - V_5_2*a_1_8
        s48 = -V_0_0*a_2_3 - V_1_0*a_2_4 - V_2_0*a_2_5 - V_3_0*a_2_6 - V_4_0*a_2_7 - V_5_0*a_2_8
        s55 = -V_0_1*a_2_3 - V_1_1*a_2_4 - V_2_1*a_2_5 - V_3_1*a_2_6 - V_4_1*a_2_7 - V_5_1*a_2_8
        s61 = -V_5_2*a_2_8
        s62 = -V_0_2*a_2_3 - V_1_2*a_2_4 - V_2_2*a_2_5 - V_3_2*a_2_6 - V_4_2*a_2_7 - a_2_2 + s61
        s69 = -V_0_0*a_p_0 - V_1_0*a_p_1 - V_2_0*a_p_2 - V_3_0*a_p_3 - V_4_0*a_p_4 - V_5_0*a_p_5
        s76 = -V_0_1*a_p_0 - V_1_1*a_p_1 - V_2_1*a_p_2 - V_3_1*a_p_3 - V_4_1*a_p_4 - V_5_1*a_p_5
        s83 = -V_0_2*a_p_0 - V_1_2*a_p_1 - V_2_2*a_p_2 - V_3_2*a_p_3 - V_4_2*a_p_4 - V_5_2*a_p_5
        s[1536 + lane] = -a_0_0
        s[1568 + lane] = -a_0_1
        s[1600 + lane] = s6
        s[1632 + lane] = s13
        s[1664 + lane] = s20
        s[1696 + lane] = -a_1_0
        s[1728 + lane] = -a_1_1
        s[1760 + lane] = s27
        s[1792 + lane] = s34
        s[1824 + lane] = s41
        s[1856 + lane] = -a_2_0
        s[1888 + lane] = -a_2_1
        s[1920 + lane] = s48
        s[1952 + lane] = s55
        s[1984 + lane] = s62
        s[2016 + lane] = s69
        s[2048 + lane] = s76
        s[2080 + lane] = s83


@straight
def _rates(speeds, accelerations, d, first, last, n):
    """Put velocities and accelerations of the joints side by side, the last ones again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        d[0 + lane] = speeds[3 * m + 0]
        d[32 + lane] = accelerations[3 * m + 0]
        d[1280 + lane] = speeds[3 * m + 1]
        d[1312 + lane] = accelerations[3 * m + 1]
        d[2560 + lane] = speeds[3 * m + 2]
        d[2592 + lane] = accelerations[3 * m + 2]


@straight
def _pay(w, s, tau, first, last):
    """Write what the joints give."""
    for lane in range(last - first + 1):
        regular = (w[10464 + lane] > 0.0) & (w[10496 + lane] > 0.0)
        tau[3 * (first + lane) + 0] = s[1440 + lane] if regular else math.nan
        tau[3 * (first + lane) + 1] = s[1472 + lane] if regular else math.nan
        tau[3 * (first + lane) + 2] = s[1504 + lane] if regular else math.nan


@straight
def _pay_each(w, s, Y, first, last):
    """Write what the joints give for each inertial parameter."""
    for lane in range(last - first + 1):
        regular = (w[10464 + lane] > 0.0) & (w[10496 + lane] > 0.0)
        Y[39 * (first + lane) + 0] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 1] = s[1536 + lane] if regular else math.nan
        Y[39 * (first + lane) + 2] = s[1568 + lane] if regular else math.nan
        Y[39 * (first + lane) + 3] = s[1600 + lane] if regular else math.nan
        Y[39 * (first + lane) + 4] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 5] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 6] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 7] = s[1760 + lane] if regular else math.nan
        Y[39 * (first + lane) + 8] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 9] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 10] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 11] = s[1920 + lane] if regular else math.nan
        Y[39 * (first + lane) + 12] = s[2016 + lane] if regular else math.nan
        Y[39 * (first + lane) + 13] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 14] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 15] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 16] = s[1632 + lane] if regular else math.nan
        Y[39 * (first + lane) + 17] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 18] = s[1696 + lane] if regular else math.nan
        Y[39 * (first + lane) + 19] = s[1728 + lane] if regular else math.nan
        Y[39 * (first + lane) + 20] = s[1792 + lane] if regular else math.nan
        Y[39 * (first + lane) + 21] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 22] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 23] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 24] = s[1952 + lane] if regular else math.nan
        Y[39 * (first + lane) + 25] = s[2048 + lane] if regular else math.nan
        Y[39 * (first + lane) + 26] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 27] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 28] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 29] = s[1664 + lane] if regular else math.nan
        Y[39 * (first + lane) + 30] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 31] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 32] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 33] = s[1824 + lane] if regular else math.nan
        Y[39 * (first + lane) + 34] = 0.0 if regular else math.nan
        Y[39 * (first + lane) + 35] = s[1856 + lane] if regular else math.nan
        Y[39 * (first + lane) + 36] = s[1888 + lane] if regular else math.nan
        Y[39 * (first + lane) + 37] = s[1984 + lane] if regular else math.nan
        Y[39 * (first + lane) + 38] = s[2080 + lane] if regular else math.nan


@fast
def _torque(x, motion, tool, k, c, gravity, shares, inertia, tau):
    found = tau.reshape(tau.size)
    w, d, s = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    w_1 = w[0:3008]
    w_2 = w[3008:6016]
    w_3 = w[6016:9024]
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
    w_1 = w[0:3008]
    w_2 = w[3008:6016]
    w_3 = w[6016:9024]
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
        b_now = p[22 * lane + 0]
        a_now = p[22 * lane + 1]
        L_now = p[22 * lane + 2]
        c_now = p[22 * lane + 4]
        phi_now = p[22 * lane + 5]
        dL_now = p[22 * lane + 10]
        alpha0_now = p[22 * lane + 11]
        beta0_now = p[22 * lane + 12]
        dc_now = p[22 * lane + 15]
        alpha03_now = p[22 * lane + 16]
        beta03_now = p[22 * lane + 17]
        alpha2_now = p[22 * lane + 18]
        beta2_now = p[22 * lane + 19]
        tip_w_now = p[22 * lane + 21]
        b_now_by = p_by[22 * lane + 0]
        a_now_by = p_by[22 * lane + 1]
        L_now_by = p_by[22 * lane + 2]
        c_now_by = p_by[22 * lane + 4]
        phi_now_by = p_by[22 * lane + 5]
        theta_now_by = p_by[22 * lane + 6]
        ex_now_by = p_by[22 * lane + 7]
        ey_now_by = p_by[22 * lane + 8]
        ez_now_by = p_by[22 * lane + 9]
        dL_now_by = p_by[22 * lane + 10]
        alpha0_now_by = p_by[22 * lane + 11]
        beta0_now_by = p_by[22 * lane + 12]
        dc_now_by = p_by[22 * lane + 15]
        alpha03_now_by = p_by[22 * lane + 16]
        beta03_now_by = p_by[22 * lane + 17]
        alpha2_now_by = p_by[22 * lane + 18]
        beta2_now_by = p_by[22 * lane + 19]
        tip_v_now_by = p_by[22 * lane + 20]
        tip_w_now_by = p_by[22 * lane + 21]
        s0_now = (beta0_now * beta0_now)
        s1_now = (alpha0_now * alpha0_now)
        s2_now = s0_now + s1_now
        s5 = 1.5619206968586225e-16*s0_now + 1.5619206968586225e-16*s1_now - 4.779477332387385e-14
        s7 = s2_now*s5 + 1.1470745597729725e-11
        s9 = s2_now*s7 - 2.08767569878681e-09
        s10_now = s2_now*s9
        s11 = s10_now + 2.755731922398589e-07
        s13 = s11*s2_now - 2.48015873015873e-05
        s15 = s13*s2_now + 0.001388888888888889
        s17 = s15*s2_now - 0.041666666666666664
        s18_now = s17*s2_now
        s19_now = s18_now + 0.5
        s20_now = -s0_now*s19_now
        s21_now = s20_now + 1
        s22_now = cosine(phi_now)
        s25 = 2.8114572543455206e-15*s0_now + 2.8114572543455206e-15*s1_now - 7.647163731819816e-13
        s27 = s25*s2_now + 1.6059043836821613e-10
        s29 = s27*s2_now - 2.505210838544172e-08
        s31_now = s29*s2_now
        s31 = s31_now + 2.7557319223985893e-06
        s33 = s2_now*s31 - 0.0001984126984126984
        s35 = s2_now*s33 + 0.008333333333333333
        s37 = s2_now*s35 - 0.16666666666666666
        s39_now = s2_now*s37
        s40_now = s39_now + 1
        s41_now = sine(phi_now)
        s42_now = -beta0_now*s40_now*s41_now
        s47_now = -s19_now*s1_now
        s48_now = s20_now + s47_now + 1
        s50_now = beta0_now*s22_now*s40_now
        R0_13_now = s41_now*s48_now + s50_now
        R0_23_now = -s22_now*s48_now - s42_now
        R0_31_now = alpha0_now*beta0_now*s19_now
        R0_33_now = -alpha0_now*s40_now
        s62_now = (alpha2_now * alpha2_now)
        s63_now = (beta2_now * beta2_now)
        s64_now = s62_now + s63_now
        s67 = 2.8114572543455206e-15*s62_now + 2.8114572543455206e-15*s63_now - 7.647163731819816e-13
        s69 = s64_now*s67 + 1.6059043836821613e-10
        s71 = s64_now*s69 - 2.505210838544172e-08
        s72_now = s64_now*s71
        s73 = s72_now + 2.7557319223985893e-06
        s75 = s64_now*s73 - 0.0001984126984126984
        s77 = s64_now*s75 + 0.008333333333333333
        s79 = s64_now*s77 - 0.16666666666666666
        s80_now = s64_now*s79
        s81_now = s80_now + 1
        s82 = 0.5*c_now
        s84_now = 0.5*dc_now + s82
        s89 = 1.5619206968586225e-16*s62_now + 1.5619206968586225e-16*s63_now - 4.779477332387385e-14
        s91 = s64_now*s89 + 1.1470745597729725e-11
        s93 = s64_now*s91 - 2.08767569878681e-09
        s94_now = s64_now*s93
        s95 = s94_now + 2.755731922398589e-07
        s97 = s64_now*s95 - 2.48015873015873e-05
        s99 = s64_now*s97 + 0.001388888888888889
        s101 = s64_now*s99 - 0.041666666666666664
        s102_now = s101*s64_now
        s103_now = s102_now + 0.5
        s106 = -s103_now*s62_now - s103_now*s63_now + 1
        g_z_now = s106*s84_now
        s108_now = -alpha03_now + alpha0_now
        s109_now = (s108_now * s108_now)
        s110_now = -beta03_now + beta0_now
        s111_now = (s110_now * s110_now)
        s112_now = s109_now + s111_now
        s115 = 1.5619206968586225e-16*s109_now + 1.5619206968586225e-16*s111_now - 4.779477332387385e-14
        s117 = s112_now*s115 + 1.1470745597729725e-11
        s119 = s112_now*s117 - 2.08767569878681e-09
        s120_now = s112_now*s119
        s121 = s120_now + 2.755731922398589e-07
        s123 = s112_now*s121 - 2.48015873015873e-05
        s125 = s112_now*s123 + 0.001388888888888889
        s127 = s112_now*s125 - 0.041666666666666664
        s128_now = s112_now*s127
        s129_now = s128_now + 0.5
        s132_now = -s109_now*s129_now - s111_now*s129_now + 1
        s135 = 2.8114572543455206e-15*s109_now + 2.8114572543455206e-15*s111_now - 7.647163731819816e-13
        s137 = s112_now*s135 + 1.6059043836821613e-10
        s139 = s112_now*s137 - 2.505210838544172e-08
        s141_now = s112_now*s139
        s141 = s141_now + 2.7557319223985893e-06
        s143 = s112_now*s141 - 0.0001984126984126984
        s145 = s112_now*s143 + 0.008333333333333333
        s147 = s112_now*s145 - 0.16666666666666666
        s149_now = s112_now*s147
        s150_now = s149_now + 1
        s184_now = L_now + dL_now
        s182 = 2*beta0_now*beta0_now_by
        s184 = 2*alpha0_now*alpha0_now_by
        s185 = s182 + s184
        s197 = s185*s9 + s2_now*(s185*s7 + s2_now*(s185*s5 + s2_now*(1.5619206968586225e-16*s182 + 1.5619206968586225e-16*s184)))
        s209 = s17*s185 + s2_now*(s15*s185 + s2_now*(s13*s185 + s2_now*(s11*s185 + s197*s2_now)))
        s212 = -s0_now*s209 - s182*s19_now
        s213 = -phi_now_by*s41_now
        s225 = s185*s29 + s2_now*(s185*s27 + s2_now*(s185*s25 + s2_now*(2.8114572543455206e-15*s182 + 2.8114572543455206e-15*s184)))
        s237 = s185*s37 + s2_now*(s185*s35 + s2_now*(s185*s33 + s2_now*(s185*s31 + s225*s2_now)))
        s238 = phi_now_by*s22_now
        s239 = -s40_now*s41_now
        s241 = -beta0_now*s40_now
        s245 = -beta0_now*s237*s41_now + beta0_now_by*s239 + s238*s241
        s249 = s212*s22_now + s213*s21_now + s245
        s261 = R0_31_now*s213
        s262 = alpha0_now*beta0_now*s209*s22_now + alpha0_now*beta0_now_by*s19_now*s22_now + alpha0_now_by*beta0_now*s19_now*s22_now + s261
        s263 = -R0_33_now*s238 + alpha0_now*s237*s41_now - alpha0_now_by*s239 + s262
        s266 = -s184*s19_now - s1_now*s209
        s267 = s212 + s266
        s268 = s22_now*s40_now
        s273 = beta0_now*s22_now*s237 + beta0_now_by*s268 - s213*s241
        s277 = s238*s48_now + s267*s41_now + s273
        s281 = s212*s41_now + s21_now*s238 + s273
        s293 = R0_31_now*s238
        s294 = alpha0_now*beta0_now*s209*s41_now + alpha0_now*beta0_now_by*s19_now*s41_now + alpha0_now_by*beta0_now*s19_now*s41_now + s293
        s295 = R0_33_now*s213 - alpha0_now*s22_now*s237 - alpha0_now_by*s268 + s294
        s299 = -s213*s48_now - s22_now*s267 - s245
        s306 = alpha0_now*beta0_now*s209 + alpha0_now*beta0_now_by*s19_now + alpha0_now_by*beta0_now*s19_now
        s309 = -alpha0_now*s237 - alpha0_now_by*s40_now
        s311 = 2*alpha2_now*alpha2_now_by
        s313 = 2*beta2_now*beta2_now_by
        s314 = s311 + s313
        s326 = s314*s71 + s64_now*(s314*s69 + s64_now*(s314*s67 + s64_now*(2.8114572543455206e-15*s311 + 2.8114572543455206e-15*s313)))
        s338 = s314*s79 + s64_now*(s314*s77 + s64_now*(s314*s75 + s64_now*(s314*s73 + s326*s64_now)))
        s341 = 0.5*c_now_by + 0.5*dc_now_by
        s342 = s81_now*s84_now
        s348 = beta2_now*s338*s84_now + beta2_now*s341*s81_now + beta2_now_by*s342
        s354 = -alpha2_now*s338*s84_now - alpha2_now*s341*s81_now - alpha2_now_by*s342
        s366 = s314*s93 + s64_now*(s314*s91 + s64_now*(s314*s89 + s64_now*(1.5619206968586225e-16*s311 + 1.5619206968586225e-16*s313)))
        s378 = s101*s314 + s64_now*(s314*s99 + s64_now*(s314*s97 + s64_now*(s314*s95 + s366*s64_now)))
        s388 = s106*s341 + s84_now*(-s103_now*s311 - s103_now*s313 - s378*s62_now - s378*s63_now)
        s389 = -alpha03_now_by + alpha0_now_by
        s391 = 2*s108_now*s389
        s392 = -beta03_now_by + beta0_now_by
        s394 = 2*s110_now*s392
        s395 = s391 + s394
        s407 = s112_now*(s112_now*(s112_now*(1.5619206968586225e-16*s391 + 1.5619206968586225e-16*s394) + s115*s395) + s117*s395) + s119*s395
        s419 = s112_now*(s112_now*(s112_now*(s112_now*s407 + s121*s395) + s123*s395) + s125*s395) + s127*s395
        s426 = -s109_now*s419 - s111_now*s419 - s129_now*s391 - s129_now*s394
        s438 = s112_now*(s112_now*(s112_now*(2.8114572543455206e-15*s391 + 2.8114572543455206e-15*s394) + s135*s395) + s137*s395) + s139*s395
        s450 = s112_now*(s112_now*(s112_now*(s112_now*s438 + s141*s395) + s143*s395) + s145*s395) + s147*s395
        s456 = s110_now*s150_now
        s464 = s82*(s110_now*s22_now*s450 + s132_now*s238 + s150_now*s22_now*s392 + s213*s456 + s41_now*s426)
        s465 = c_now_by*(0.5*s110_now*s150_now*s22_now + 0.5*s132_now*s41_now) + s464
        s478 = s82*(s110_now*s41_now*s450 - s132_now*s213 + s150_now*s392*s41_now - s22_now*s426 + s238*s456)
        s479 = c_now_by*(0.5*s110_now*s150_now*s41_now - 0.5*s132_now*s22_now) + s478
        s486 = -0.5*c_now*s108_now*s450 - 0.5*c_now*s150_now*s389 - 0.5*c_now_by*s108_now*s150_now
        s495 = L_now_by + dL_now_by
        s499 = R0_13_now*tip_w_now_by + b_now*s213 + b_now_by*s22_now + ex_now_by + s277*tip_w_now
        s503 = R0_23_now*tip_w_now_by + b_now*s238 + b_now_by*s41_now + ey_now_by + s299*tip_w_now
        s507 = R0_33_now*tip_w_now_by + ez_now_by + s309*tip_w_now
        s510 = a_now*s213 + a_now_by*s22_now
        s513 = a_now*s238 + a_now_by*s41_now
        s516 = R0_13_now*s388 + g_z_now*s277
        s519 = R0_23_now*s388 + g_z_now*s299
        s522 = R0_33_now*s388 + g_z_now*s309
        s527 = -(2*L_now_by + 2*dL_now_by)/((2*L_now + 2*dL_now) * (2*L_now + 2*dL_now))
        s531 = -s495/(s184_now * s184_now * s184_now)
        k[24 * lane + 0] = theta_now_by
        k[24 * lane + 1] = s249
        k[24 * lane + 2] = s263
        k[24 * lane + 3] = s281
        k[24 * lane + 4] = s295
        k[24 * lane + 5] = s306
        k[24 * lane + 6] = s266
        k[24 * lane + 7] = s495
        k[24 * lane + 8] = tip_v_now_by
        k[24 * lane + 9] = s499
        k[24 * lane + 10] = s503
        k[24 * lane + 11] = s507
        k[24 * lane + 12] = s510
        k[24 * lane + 13] = s513
        k[24 * lane + 14] = s348
        k[24 * lane + 15] = s354
        k[24 * lane + 16] = s516
        k[24 * lane + 17] = s519
        k[24 * lane + 18] = s522
        k[24 * lane + 19] = s465
        k[24 * lane + 20] = s479
        k[24 * lane + 21] = s486
        k[24 * lane + 22] = s527
        k[24 * lane + 23] = s531


@straight
def _fill_machine_by(p, p_by, k, rows):
    for lane in range(rows):
        b_now = p[22 * lane + 0]
        a_now = p[22 * lane + 1]
        L_now = p[22 * lane + 2]
        l_now = p[22 * lane + 3]
        c_now = p[22 * lane + 4]
        phi_now = p[22 * lane + 5]
        dL_now = p[22 * lane + 10]
        alpha0_now = p[22 * lane + 11]
        beta0_now = p[22 * lane + 12]
        dl_mean_now = p[22 * lane + 13]
        dl_now = p[22 * lane + 14]
        dc_now = p[22 * lane + 15]
        alpha03_now = p[22 * lane + 16]
        beta03_now = p[22 * lane + 17]
        alpha2_now = p[22 * lane + 18]
        beta2_now = p[22 * lane + 19]
        tip_w_now = p[22 * lane + 21]
        b_now_by = p_by[22 * lane + 0]
        a_now_by = p_by[22 * lane + 1]
        L_now_by = p_by[22 * lane + 2]
        l_now_by = p_by[22 * lane + 3]
        c_now_by = p_by[22 * lane + 4]
        phi_now_by = p_by[22 * lane + 5]
        theta_now_by = p_by[22 * lane + 6]
        ex_now_by = p_by[22 * lane + 7]
        ey_now_by = p_by[22 * lane + 8]
        ez_now_by = p_by[22 * lane + 9]
        dL_now_by = p_by[22 * lane + 10]
        alpha0_now_by = p_by[22 * lane + 11]
        beta0_now_by = p_by[22 * lane + 12]
        dl_mean_now_by = p_by[22 * lane + 13]
        dl_now_by = p_by[22 * lane + 14]
        dc_now_by = p_by[22 * lane + 15]
        alpha03_now_by = p_by[22 * lane + 16]
        beta03_now_by = p_by[22 * lane + 17]
        alpha2_now_by = p_by[22 * lane + 18]
        beta2_now_by = p_by[22 * lane + 19]
        tip_v_now_by = p_by[22 * lane + 20]
        tip_w_now_by = p_by[22 * lane + 21]
        s0_now = (beta0_now * beta0_now)
        s1_now = (alpha0_now * alpha0_now)
        s2_now = s0_now + s1_now
        s5_now = 1.5619206968586225e-16*s0_now + 1.5619206968586225e-16*s1_now - 4.779477332387385e-14
        s7_now = s2_now*s5_now + 1.1470745597729725e-11
        s9_now = s2_now*s7_now - 2.08767569878681e-09
        s11_now = s2_now*s9_now + 2.755731922398589e-07
        s13_now = s11_now*s2_now - 2.48015873015873e-05
        s15_now = s13_now*s2_now + 0.001388888888888889
        s17_now = s15_now*s2_now - 0.041666666666666664
        s19_now = s17_now*s2_now + 0.5
        s20_now = -s0_now*s19_now
        s21_now = s20_now + 1
        s22_now = cosine(phi_now)
        s26_now = 2.8114572543455206e-15*s0_now + 2.8114572543455206e-15*s1_now - 7.647163731819816e-13
        s28_now = s26_now*s2_now + 1.6059043836821613e-10
        s30_now = s28_now*s2_now - 2.505210838544172e-08
        s32_now = s2_now*s30_now + 2.7557319223985893e-06
        s34_now = s2_now*s32_now - 0.0001984126984126984
        s36_now = s2_now*s34_now + 0.008333333333333333
        s38_now = s2_now*s36_now - 0.16666666666666666
        s40_now = s2_now*s38_now + 1
        s41_now = sine(phi_now)
        s42_now = -beta0_now*s40_now*s41_now
        s47_now = -s19_now*s1_now
        s48_now = s20_now + s47_now + 1
        s50_now = beta0_now*s22_now*s40_now
        R0_13_now = s41_now*s48_now + s50_now
        R0_23_now = -s22_now*s48_now - s42_now
        R0_31_now = alpha0_now*beta0_now*s19_now
        R0_33_now = -alpha0_now*s40_now
        s62_now = (alpha2_now * alpha2_now)
        s63_now = (beta2_now * beta2_now)
        s64_now = s62_now + s63_now
        s67_now = 2.8114572543455206e-15*s62_now + 2.8114572543455206e-15*s63_now - 7.647163731819816e-13
        s69_now = s64_now*s67_now + 1.6059043836821613e-10
        s71_now = s64_now*s69_now - 2.505210838544172e-08
        s73_now = s64_now*s71_now + 2.7557319223985893e-06
        s75_now = s64_now*s73_now - 0.0001984126984126984
        s77_now = s64_now*s75_now + 0.008333333333333333
        s79_now = s64_now*s77_now - 0.16666666666666666
        s81_now = s64_now*s79_now + 1
        s82_now = 0.5*c_now
        s84_now = 0.5*dc_now + s82_now
        s89_now = 1.5619206968586225e-16*s62_now + 1.5619206968586225e-16*s63_now - 4.779477332387385e-14
        s91_now = s64_now*s89_now + 1.1470745597729725e-11
        s93_now = s64_now*s91_now - 2.08767569878681e-09
        s95_now = s64_now*s93_now + 2.755731922398589e-07
        s97_now = s64_now*s95_now - 2.48015873015873e-05
        s99_now = s64_now*s97_now + 0.001388888888888889
        s101_now = s64_now*s99_now - 0.041666666666666664
        s103_now = s101_now*s64_now + 0.5
        s106_now = -s103_now*s62_now - s103_now*s63_now + 1
        g_z_now = s106_now*s84_now
        s108_now = -alpha03_now + alpha0_now
        s109_now = (s108_now * s108_now)
        s110_now = -beta03_now + beta0_now
        s111_now = (s110_now * s110_now)
        s112_now = s109_now + s111_now
        s115_now = 1.5619206968586225e-16*s109_now + 1.5619206968586225e-16*s111_now - 4.779477332387385e-14
        s117_now = s112_now*s115_now + 1.1470745597729725e-11
        s119_now = s112_now*s117_now - 2.08767569878681e-09
        s121_now = s112_now*s119_now + 2.755731922398589e-07
        s123_now = s112_now*s121_now - 2.48015873015873e-05
        s125_now = s112_now*s123_now + 0.001388888888888889
        s127_now = s112_now*s125_now - 0.041666666666666664
        s129_now = s112_now*s127_now + 0.5
        s132_now = -s109_now*s129_now - s111_now*s129_now + 1
        s136_now = 2.8114572543455206e-15*s109_now + 2.8114572543455206e-15*s111_now - 7.647163731819816e-13
        s138_now = s112_now*s136_now + 1.6059043836821613e-10
        s140_now = s112_now*s138_now - 2.505210838544172e-08
        s142_now = s112_now*s140_now + 2.7557319223985893e-06
        s144_now = s112_now*s142_now - 0.0001984126984126984
        s146_now = s112_now*s144_now + 0.008333333333333333
        s148_now = s112_now*s146_now - 0.16666666666666666
        s150_now = s112_now*s148_now + 1
        s219_now = L_now + dL_now
        s290_now = 0.5*dl_now
        s291_now = dl_mean_now + l_now + s290_now
        s456_now = -0.5*c_now*s108_now
        s457_now = 2*s108_now
        s458_now = 2*s110_now
        s463_now = s110_now*s41_now
        s467_now = s110_now*s22_now
        s468_now = 2*beta0_now
        s469_now = 2*alpha0_now
        s470_now = 2*alpha2_now
        s471_now = 2*beta2_now
        s472_now = -s81_now*s84_now
        s473_now = -alpha2_now*s84_now
        s475_now = beta2_now*s84_now
        s477_now = -s40_now*s41_now
        s478_now = -beta0_now*s41_now
        s480_now = s22_now*s40_now
        s481_now = beta0_now*s22_now
        s484_now = alpha0_now*beta0_now
        s485_now = -alpha0_now*s22_now
        s488_now = alpha0_now*beta0_now*s41_now
        s489_now = alpha0_now*s41_now
        s492_now = alpha0_now*beta0_now*s22_now
        s202 = 2.8114572543455206e-15*s112_now*s457_now + s136_now*s457_now
        s205 = s112_now*s202 + s138_now*s457_now
        s208 = s112_now*s205 + s140_now*s457_now
        s507_now = s112_now*s208
        s211 = s142_now*s457_now + s507_now
        s214 = s112_now*s211 + s144_now*s457_now
        s217 = s112_now*s214 + s146_now*s457_now
        s514_now = s112_now*s217 + s148_now*s457_now
        s226 = 1.5619206968586225e-16*s112_now*s457_now + s115_now*s457_now
        s229 = s112_now*s226 + s117_now*s457_now
        s232 = s112_now*s229 + s119_now*s457_now
        s532_now = s112_now*s232
        s235 = s121_now*s457_now + s532_now
        s238 = s112_now*s235 + s123_now*s457_now
        s241 = s112_now*s238 + s125_now*s457_now
        s539_now = s112_now*s241 + s127_now*s457_now
        s543_now = -2*s108_now*s129_now - s109_now*s539_now - s111_now*s539_now
        s260 = s26_now*s469_now + 2.8114572543455206e-15*s2_now*s469_now
        s262 = s260*s2_now + s28_now*s469_now
        s265 = s262*s2_now + s30_now*s469_now
        s568_now = s265*s2_now
        s268 = s32_now*s469_now + s568_now
        s271 = s268*s2_now + s34_now*s469_now
        s274 = s271*s2_now + s36_now*s469_now
        s575_now = s274*s2_now + s38_now*s469_now
        s577_now = -alpha0_now*s575_now - s40_now
        s580_now = s478_now*s575_now
        s592_now = s11_now*s469_now
        s285 = 1.5619206968586225e-16*s2_now*s469_now + s469_now*s5_now
        s288 = s285*s2_now + s469_now*s7_now
        s291 = s288*s2_now + s469_now*s9_now
        s593_now = s291*s2_now + s592_now
        s298 = s13_now*s469_now + s2_now*s593_now
        s300 = s15_now*s469_now + s298*s2_now
        s602_now = s17_now*s469_now + s2_now*s300
        s603_now = -s0_now*s602_now
        s606_now = -s19_now*s469_now - s1_now*s602_now
        s607_now = s603_now + s606_now
        s609_now = -s22_now*s607_now - s580_now
        s613_now = s481_now*s575_now
        s614_now = s41_now*s607_now + s613_now
        s318 = beta0_now*s19_now
        s335 = 2.8114572543455206e-15*s112_now*s458_now + s136_now*s458_now
        s338 = s112_now*s335 + s138_now*s458_now
        s341 = s112_now*s338 + s140_now*s458_now
        s660_now = s112_now*s341
        s344 = s142_now*s458_now + s660_now
        s347 = s112_now*s344 + s144_now*s458_now
        s350 = s112_now*s347 + s146_now*s458_now
        s667_now = s112_now*s350 + s148_now*s458_now
        s357 = 1.5619206968586225e-16*s112_now*s458_now + s115_now*s458_now
        s360 = s112_now*s357 + s117_now*s458_now
        s363 = s112_now*s360 + s119_now*s458_now
        s684_now = s112_now*s363
        s366 = s121_now*s458_now + s684_now
        s369 = s112_now*s366 + s123_now*s458_now
        s372 = s112_now*s369 + s125_now*s458_now
        s691_now = s112_now*s372 + s127_now*s458_now
        s695_now = -s109_now*s691_now - 2*s110_now*s129_now - s111_now*s691_now
        s380 = s150_now*s41_now
        s385 = s150_now*s22_now
        s393 = s26_now*s468_now + 2.8114572543455206e-15*s2_now*s468_now
        s395 = s28_now*s468_now + s2_now*s393
        s398 = s2_now*s395 + s30_now*s468_now
        s722_now = s2_now*s398
        s401 = s32_now*s468_now + s722_now
        s404 = s2_now*s401 + s34_now*s468_now
        s407 = s2_now*s404 + s36_now*s468_now
        s729_now = s2_now*s407 + s38_now*s468_now
        s730_now = -alpha0_now*s729_now
        s734_now = s477_now + s478_now*s729_now
        s747_now = s11_now*s468_now
        s418 = 1.5619206968586225e-16*s2_now*s468_now + s468_now*s5_now
        s421 = s2_now*s418 + s468_now*s7_now
        s424 = s2_now*s421 + s468_now*s9_now
        s748_now = s2_now*s424 + s747_now
        s431 = s13_now*s468_now + s2_now*s748_now
        s433 = s15_now*s468_now + s2_now*s431
        s757_now = s17_now*s468_now + s2_now*s433
        s759_now = -s0_now*s757_now - s19_now*s468_now
        s760_now = -s1_now*s757_now
        s761_now = s759_now + s760_now
        s763_now = -s22_now*s761_now - s734_now
        s768_now = s480_now + s481_now*s729_now
        s769_now = s41_now*s761_now + s768_now
        s452 = alpha0_now*s19_now
        s801_now = 0.5*s106_now
        s478 = 1.5619206968586225e-16*s470_now*s64_now + s470_now*s89_now
        s480 = s470_now*s91_now + s478*s64_now
        s482 = s470_now*s93_now + s480*s64_now
        s828_now = s482*s64_now
        s488 = s470_now*s95_now + s828_now
        s490 = s470_now*s97_now + s488*s64_now
        s492 = s470_now*s99_now + s490*s64_now
        s836_now = s101_now*s470_now + s492*s64_now
        s498 = -s103_now*s470_now - s62_now*s836_now - s63_now*s836_now
        s842_now = s498*s84_now
        s505 = 2.8114572543455206e-15*s470_now*s64_now + s470_now*s67_now
        s507 = s470_now*s69_now + s505*s64_now
        s509 = s470_now*s71_now + s507*s64_now
        s859_now = s509*s64_now
        s515 = s470_now*s73_now + s859_now
        s517 = s470_now*s75_now + s515*s64_now
        s519 = s470_now*s77_now + s517*s64_now
        s866_now = s470_now*s79_now + s519*s64_now
        s531 = 1.5619206968586225e-16*s471_now*s64_now + s471_now*s89_now
        s533 = s471_now*s91_now + s531*s64_now
        s535 = s471_now*s93_now + s533*s64_now
        s890_now = s535*s64_now
        s541 = s471_now*s95_now + s890_now
        s543 = s471_now*s97_now + s541*s64_now
        s545 = s471_now*s99_now + s543*s64_now
        s898_now = s101_now*s471_now + s545*s64_now
        s551 = -s103_now*s471_now - s62_now*s898_now - s63_now*s898_now
        s904_now = s551*s84_now
        s558 = 2.8114572543455206e-15*s471_now*s64_now + s471_now*s67_now
        s560 = s471_now*s69_now + s558*s64_now
        s562 = s471_now*s71_now + s560*s64_now
        s921_now = s562*s64_now
        s568 = s471_now*s73_now + s921_now
        s570 = s471_now*s75_now + s568*s64_now
        s572 = s471_now*s77_now + s570*s64_now
        s928_now = s471_now*s79_now + s572*s64_now
        s952_now = dl_mean_now + l_now - s290_now
        s1196_now = -2*L_now - 2*dL_now
        s619 = beta0_now_by*s468_now
        s620 = alpha0_now_by*s469_now
        s621 = s619 + s620
        s624 = 1.5619206968586225e-16*s619 + 1.5619206968586225e-16*s620
        s627 = s2_now*s624 + s5_now*s621
        s630 = s2_now*s627 + s621*s7_now
        s633 = s2_now*s630 + s621*s9_now
        s636 = s11_now*s621 + s2_now*s633
        s639 = s13_now*s621 + s2_now*s636
        s642 = s15_now*s621 + s2_now*s639
        s645 = s17_now*s621 + s2_now*s642
        s648 = -s0_now*s645 - s19_now*s619
        s649 = -phi_now_by*s41_now
        s652 = 2.8114572543455206e-15*s619 + 2.8114572543455206e-15*s620
        s655 = s26_now*s621 + s2_now*s652
        s658 = s28_now*s621 + s2_now*s655
        s661 = s2_now*s658 + s30_now*s621
        s664 = s2_now*s661 + s32_now*s621
        s667 = s2_now*s664 + s34_now*s621
        s670 = s2_now*s667 + s36_now*s621
        s673 = s2_now*s670 + s38_now*s621
        s674 = phi_now_by*s22_now
        s675 = -beta0_now*s40_now
        s679 = beta0_now_by*s477_now + s478_now*s673 + s674*s675
        s683 = s21_now*s649 + s22_now*s648 + s679
        s692 = R0_31_now*s649 + alpha0_now*beta0_now_by*s19_now*s22_now + alpha0_now_by*beta0_now*s19_now*s22_now + s492_now*s645
        s693 = -R0_33_now*s674 - alpha0_now_by*s477_now + s489_now*s673 + s692
        s696 = -s19_now*s620 - s1_now*s645
        s697 = s648 + s696
        s701 = beta0_now_by*s480_now + s481_now*s673 - s649*s675
        s705 = s41_now*s697 + s48_now*s674 + s701
        s709 = s21_now*s674 + s41_now*s648 + s701
        s718 = R0_31_now*s674 + alpha0_now*beta0_now_by*s19_now*s41_now + alpha0_now_by*beta0_now*s19_now*s41_now + s488_now*s645
        s719 = R0_33_now*s649 - alpha0_now_by*s480_now + s485_now*s673 + s718
        s723 = -s22_now*s697 - s48_now*s649 - s679
        s727 = alpha0_now_by*s318 + beta0_now_by*s452 + s484_now*s645
        s730 = -alpha0_now*s673 - alpha0_now_by*s40_now
        s731 = alpha2_now_by*s470_now
        s732 = beta2_now_by*s471_now
        s733 = s731 + s732
        s736 = 2.8114572543455206e-15*s731 + 2.8114572543455206e-15*s732
        s739 = s64_now*s736 + s67_now*s733
        s742 = s64_now*s739 + s69_now*s733
        s745 = s64_now*s742 + s71_now*s733
        s748 = s64_now*s745 + s733*s73_now
        s751 = s64_now*s748 + s733*s75_now
        s754 = s64_now*s751 + s733*s77_now
        s757 = s64_now*s754 + s733*s79_now
        s758 = 0.5*c_now_by
        s760 = 0.5*dc_now_by + s758
        s765 = beta2_now*s760*s81_now - beta2_now_by*s472_now + s475_now*s757
        s770 = -alpha2_now*s760*s81_now + alpha2_now_by*s472_now + s473_now*s757
        s773 = 1.5619206968586225e-16*s731 + 1.5619206968586225e-16*s732
        s776 = s64_now*s773 + s733*s89_now
        s779 = s64_now*s776 + s733*s91_now
        s782 = s64_now*s779 + s733*s93_now
        s785 = s64_now*s782 + s733*s95_now
        s788 = s64_now*s785 + s733*s97_now
        s791 = s64_now*s788 + s733*s99_now
        s794 = s101_now*s733 + s64_now*s791
        s801 = -s103_now*s731 - s103_now*s732 - s62_now*s794 - s63_now*s794
        s804 = s106_now*s760 + s801*s84_now
        s805 = -alpha03_now_by + alpha0_now_by
        s806 = s457_now*s805
        s807 = -beta03_now_by + beta0_now_by
        s808 = s458_now*s807
        s809 = s806 + s808
        s812 = 1.5619206968586225e-16*s806 + 1.5619206968586225e-16*s808
        s815 = s112_now*s812 + s115_now*s809
        s818 = s112_now*s815 + s117_now*s809
        s821 = s112_now*s818 + s119_now*s809
        s824 = s112_now*s821 + s121_now*s809
        s827 = s112_now*s824 + s123_now*s809
        s830 = s112_now*s827 + s125_now*s809
        s833 = s112_now*s830 + s127_now*s809
        s840 = -s109_now*s833 - s111_now*s833 - s129_now*s806 - s129_now*s808
        s843 = 2.8114572543455206e-15*s806 + 2.8114572543455206e-15*s808
        s846 = s112_now*s843 + s136_now*s809
        s849 = s112_now*s846 + s138_now*s809
        s852 = s112_now*s849 + s140_now*s809
        s855 = s112_now*s852 + s142_now*s809
        s858 = s112_now*s855 + s144_now*s809
        s861 = s112_now*s858 + s146_now*s809
        s864 = s112_now*s861 + s148_now*s809
        s868 = s110_now*s150_now
        s876 = s82_now*(s132_now*s674 + s385*s807 + s41_now*s840 + s467_now*s864 + s649*s868)
        s877 = c_now_by*(0.5*s110_now*s150_now*s22_now + 0.5*s132_now*s41_now) + s876
        s888 = s82_now*(-s132_now*s649 - s22_now*s840 + s380*s807 + s463_now*s864 + s674*s868)
        s889 = c_now_by*(0.5*s110_now*s150_now*s41_now - 0.5*s132_now*s22_now) + s888
        s894 = -0.5*c_now*s150_now*s805 - 0.5*c_now_by*s108_now*s150_now + s456_now*s864
        s897 = b_now*s649 + b_now_by*s22_now
        s901 = b_now*s674 + b_now_by*s41_now
        s903 = L_now_by + dL_now_by
        s907 = R0_13_now*tip_w_now_by + ex_now_by + s705*tip_w_now + s897
        s911 = R0_23_now*tip_w_now_by + ey_now_by + s723*tip_w_now + s901
        s915 = R0_33_now*tip_w_now_by + ez_now_by + s730*tip_w_now
        s918 = a_now*s649 + a_now_by*s22_now
        s921 = a_now*s674 + a_now_by*s41_now
        s924 = R0_13_now*s804 + g_z_now*s705
        s927 = R0_23_now*s804 + g_z_now*s723
        s930 = R0_33_now*s804 + g_z_now*s730
        s931 = 0.5*dl_now_by
        s932 = dl_mean_now_by + l_now_by + s931
        s935 = -s291_now*s932
        s939 = -0.5*c_now_by*s108_now - s805*s82_now
        s940 = 2*s805
        s941 = 2*s807
        s944 = s110_now*s674 + s41_now*s807
        s947 = s110_now*s649 + s22_now*s807
        s948 = 2*beta0_now_by
        s949 = 2*alpha0_now_by
        s950 = 2*alpha2_now_by
        s951 = 2*beta2_now_by
        s954 = -s757*s84_now - s760*s81_now
        s957 = -alpha2_now*s760 - alpha2_now_by*s84_now
        s960 = beta2_now*s760 + beta2_now_by*s84_now
        s963 = -s40_now*s674 - s41_now*s673
        s966 = -beta0_now*s674 - beta0_now_by*s41_now
        s969 = s22_now*s673 + s40_now*s649
        s972 = beta0_now*s649 + beta0_now_by*s22_now
        s975 = alpha0_now*beta0_now_by + alpha0_now_by*beta0_now
        s978 = -alpha0_now*s649 - alpha0_now_by*s22_now
        s982 = -alpha0_now_by*s478_now + beta0_now_by*s489_now + s484_now*s674
        s985 = alpha0_now*s674 + alpha0_now_by*s41_now
        s989 = alpha0_now_by*s481_now - beta0_now_by*s485_now + s484_now*s649
        s994 = 2.8114572543455206e-15*s112_now
        s1004 = s138_now*s940 + s457_now*s846
        s1005 = s1004 + s112_now*(s136_now*s940 + 2.8114572543455206e-15*s457_now*s809 + s457_now*s843 + s940*s994) + s202*s809
        s1018 = s142_now*s940 + s457_now*s852
        s1021 = s112_now*(s1018 + s112_now*(s1005*s112_now + s140_now*s940 + s205*s809 + s457_now*s849) + s208*s809)
        s1032 = s146_now*s940 + s457_now*s858
        s1035 = s112_now*(s1032 + s112_now*(s1021 + s144_now*s940 + s211*s809 + s457_now*s855) + s214*s809)
        s1040 = s1035 + s148_now*s940 + s217*s809 + s457_now*s861
        s1048 = -0.5*c_now_by*s150_now + s1040*s456_now + s514_now*s939 - s82_now*s864
        s1053 = 1.5619206968586225e-16*s112_now
        s1063 = s117_now*s940 + s457_now*s815
        s1064 = s1063 + s112_now*(s1053*s940 + s115_now*s940 + 1.5619206968586225e-16*s457_now*s809 + s457_now*s812) + s226*s809
        s1077 = s121_now*s940 + s457_now*s821
        s1080 = s112_now*(s1077 + s112_now*(s1064*s112_now + s119_now*s940 + s229*s809 + s457_now*s818) + s232*s809)
        s1091 = s125_now*s940 + s457_now*s827
        s1094 = s112_now*(s1091 + s112_now*(s1080 + s123_now*s940 + s235*s809 + s457_now*s824) + s238*s809)
        s1099 = s1094 + s127_now*s940 + s241*s809 + s457_now*s830
        s1106 = -2*s129_now
        s1110 = -s1099*s109_now - s1099*s111_now + s1106*s805 - s457_now*s833 - s539_now*s806 - s539_now*s808
        s1119 = s758*(-s22_now*s543_now + s463_now*s514_now)
        s1120 = s1119 + s82_now*(s1040*s463_now - s1110*s22_now + s514_now*s944 - s543_now*s649)
        s1129 = s758*(s41_now*s543_now + s467_now*s514_now)
        s1130 = s1129 + s82_now*(s1040*s467_now + s1110*s41_now + s514_now*s947 + s543_now*s674)
        s1138 = 2.8114572543455206e-15*s2_now
        s1145 = s260*s621 + s2_now*(s1138*s949 + s26_now*s949 + 2.8114572543455206e-15*s469_now*s621 + s469_now*s652)
        s1154 = s2_now*(s262*s621 + s2_now*(s1145 + s28_now*s949 + s469_now*s655) + s30_now*s949 + s469_now*s658)
        s1166 = s34_now*s949 + s469_now*s664
        s1169 = s271*s621
        s1170 = s1169 + s2_now*(s1166 + s268*s621 + s2_now*(s1154 + s265*s621 + s32_now*s949 + s469_now*s661))
        s1181 = s274*s621 + s2_now*(s1170 + s36_now*s949 + s469_now*s667) + s38_now*s949 + s469_now*s670
        s1185 = -alpha0_now*s1181 - alpha0_now_by*s575_now - s673
        s1188 = g_z_now*s1185 + s577_now*s804
        s1191 = s1181*s478_now + s575_now*s966
        s1199 = 1.5619206968586225e-16*s2_now
        s1209 = s469_now*s627 + s7_now*s949
        s1210 = s1209 + s285*s621 + s2_now*(s1199*s949 + 1.5619206968586225e-16*s469_now*s621 + s469_now*s624 + s5_now*s949)
        s1220 = s291*s621 + s2_now*(s1210*s2_now + s288*s621 + s469_now*s630 + s949*s9_now)
        s1235 = s2_now*(s13_now*s949 + s2_now*(s11_now*s949 + s1220 + s469_now*s633) + s469_now*s636 + s593_now*s621)
        s1241 = s2_now*(s1235 + s15_now*s949 + s298*s621 + s469_now*s639) + s300*s621
        s1242 = s1241 + s17_now*s949 + s469_now*s642
        s1245 = -s0_now*s1242 - s602_now*s619
        s1252 = -s1242*s1_now - s19_now*s949 - s469_now*s645 - s602_now*s620
        s1253 = s1245 + s1252
        s1257 = -s1191 - s1253*s22_now - s607_now*s649
        s1260 = g_z_now*s1257 + s609_now*s804
        s1263 = s1181*s481_now + s575_now*s972
        s1267 = s1253*s41_now + s1263 + s607_now*s674
        s1270 = g_z_now*s1267 + s614_now*s804
        s1273 = s1185*tip_w_now + s577_now*tip_w_now_by
        s1276 = s1257*tip_w_now + s609_now*tip_w_now_by
        s1279 = s1267*tip_w_now + s614_now*tip_w_now_by
        s1286 = beta0_now*s645 + beta0_now_by*s19_now + s1242*s484_now + s602_now*s975
        s1290 = s1245*s41_now + s1263 + s603_now*s674
        s1297 = s19_now*s41_now
        s1301 = beta0_now_by*s1297 + s318*s674 - s478_now*s645
        s1302 = s1181*s485_now + s1242*s488_now + s1301 + s575_now*s978 + s602_now*s982 - s969
        s1306 = s1191 + s1245*s22_now + s603_now*s649
        s1313 = s19_now*s22_now
        s1317 = beta0_now_by*s1313 + s318*s649 + s481_now*s645
        s1318 = s1181*s489_now + s1242*s492_now + s1317 + s575_now*s985 + s602_now*s989 - s963
        s1332 = s138_now*s941 + s458_now*s846
        s1333 = s112_now*(s136_now*s941 + 2.8114572543455206e-15*s458_now*s809 + s458_now*s843 + s941*s994) + s1332 + s335*s809
        s1346 = s142_now*s941 + s458_now*s852
        s1349 = s112_now*(s112_now*(s112_now*s1333 + s140_now*s941 + s338*s809 + s458_now*s849) + s1346 + s341*s809)
        s1360 = s146_now*s941 + s458_now*s858
        s1363 = s112_now*(s112_now*(s1349 + s144_now*s941 + s344*s809 + s458_now*s855) + s1360 + s347*s809)
        s1368 = s1363 + s148_now*s941 + s350*s809 + s458_now*s861
        s1371 = s1368*s456_now + s667_now*s939
        s1385 = s117_now*s941 + s458_now*s815
        s1386 = s112_now*(s1053*s941 + s115_now*s941 + 1.5619206968586225e-16*s458_now*s809 + s458_now*s812) + s1385 + s357*s809
        s1399 = s121_now*s941 + s458_now*s821
        s1402 = s112_now*(s112_now*(s112_now*s1386 + s119_now*s941 + s360*s809 + s458_now*s818) + s1399 + s363*s809)
        s1413 = s125_now*s941 + s458_now*s827
        s1416 = s112_now*(s112_now*(s123_now*s941 + s1402 + s366*s809 + s458_now*s824) + s1413 + s369*s809)
        s1421 = s127_now*s941 + s1416 + s372*s809 + s458_now*s830
        s1431 = -s109_now*s1421 + s1106*s807 - s111_now*s1421 - s458_now*s833 - s691_now*s806 - s691_now*s808
        s1442 = s82_now*(s1368*s463_now - s1431*s22_now + s150_now*s674 + s41_now*s864 - s649*s695_now + s667_now*s944)
        s1444 = s1442 + s758*(-s22_now*s695_now + s380 + s463_now*s667_now)
        s1455 = s82_now*(s1368*s467_now + s1431*s41_now + s150_now*s649 + s22_now*s864 + s667_now*s947 + s674*s695_now)
        s1457 = s1455 + s758*(s385 + s41_now*s695_now + s467_now*s667_now)
        s1471 = s2_now*(s1138*s948 + s26_now*s948 + 2.8114572543455206e-15*s468_now*s621 + s468_now*s652) + s393*s621
        s1481 = s2_now*(s2_now*(s1471 + s28_now*s948 + s468_now*s655) + s30_now*s948 + s395*s621 + s468_now*s658)
        s1492 = s34_now*s948 + s468_now*s664
        s1495 = s2_now*(s1492 + s2_now*(s1481 + s32_now*s948 + s398*s621 + s468_now*s661) + s401*s621)
        s1506 = s38_now*s948 + s468_now*s670
        s1507 = s1506 + s2_now*(s1495 + s36_now*s948 + s404*s621 + s468_now*s667) + s407*s621
        s1510 = -alpha0_now*s1507 - alpha0_now_by*s729_now
        s1513 = g_z_now*s1510 + s730_now*s804
        s1517 = s1507*s478_now + s729_now*s966 + s963
        s1534 = s468_now*s627 + s7_now*s948
        s1535 = s1534 + s2_now*(s1199*s948 + 1.5619206968586225e-16*s468_now*s621 + s468_now*s624 + s5_now*s948) + s418*s621
        s1545 = s2_now*(s1535*s2_now + s421*s621 + s468_now*s630 + s948*s9_now) + s424*s621
        s1561 = s2_now*(s13_now*s948 + s2_now*(s11_now*s948 + s1545 + s468_now*s633) + s468_now*s636 + s621*s748_now)
        s1566 = s2_now*(s1561 + s15_now*s948 + s431*s621 + s468_now*s639) + s433*s621
        s1567 = s1566 + s17_now*s948 + s468_now*s642
        s1574 = -s0_now*s1567 - s19_now*s948 - s468_now*s645 - s619*s757_now
        s1577 = -s1567*s1_now - s620*s757_now
        s1578 = s1574 + s1577
        s1582 = -s1517 - s1578*s22_now - s649*s761_now
        s1585 = g_z_now*s1582 + s763_now*s804
        s1589 = s1507*s481_now + s729_now*s972 + s969
        s1593 = s1578*s41_now + s1589 + s674*s761_now
        s1596 = g_z_now*s1593 + s769_now*s804
        s1599 = s1510*tip_w_now + s730_now*tip_w_now_by
        s1602 = s1582*tip_w_now + s763_now*tip_w_now_by
        s1605 = s1593*tip_w_now + s769_now*tip_w_now_by
        s1612 = alpha0_now*s645 + alpha0_now_by*s19_now + s1567*s484_now + s757_now*s975
        s1616 = s1574*s41_now + s1589 + s674*s759_now
        s1626 = alpha0_now_by*s1297 + s452*s674 + s489_now*s645
        s1627 = s1507*s485_now + s1567*s488_now + s1626 + s729_now*s978 + s757_now*s982
        s1631 = s1517 + s1574*s22_now + s649*s759_now
        s1641 = alpha0_now_by*s1313 + s452*s649 - s485_now*s645
        s1642 = s1507*s489_now + s1567*s492_now + s1641 + s729_now*s985 + s757_now*s989
        s1643 = -0.5*s932
        s1644 = 0.5*s801
        s1647 = R0_33_now*s1644 + s730*s801_now
        s1648 = -0.5*s81_now
        s1652 = -0.5*alpha2_now*s757 + alpha2_now_by*s1648
        s1656 = 0.5*beta2_now*s757 - beta2_now_by*s1648
        s1659 = R0_23_now*s1644 + s723*s801_now
        s1662 = R0_13_now*s1644 + s705*s801_now
        s1672 = 1.5619206968586225e-16*s64_now
        s1680 = s478*s733 + s64_now*(s1672*s950 + 1.5619206968586225e-16*s470_now*s733 + s470_now*s773 + s89_now*s950)
        s1686 = s64_now*(s470_now*s779 + s480*s733 + s64_now*(s1680 + s470_now*s776 + s91_now*s950) + s93_now*s950)
        s1704 = s488*s733 + s64_now*(s1686 + s470_now*s782 + s482*s733 + s950*s95_now)
        s1710 = s64_now*(s470_now*s788 + s490*s733 + s64_now*(s1704 + s470_now*s785 + s950*s97_now) + s950*s99_now)
        s1713 = s101_now*s950 + s1710 + s470_now*s791 + s492*s733
        s1723 = -s103_now*s950 - s1713*s62_now - s1713*s63_now - s470_now*s794 - s731*s836_now - s732*s836_now
        s1726 = s1723*s84_now + s498*s760
        s1729 = R0_33_now*s1726 + s730*s842_now
        s1739 = 2.8114572543455206e-15*s64_now
        s1747 = s505*s733 + s64_now*(s1739*s950 + 2.8114572543455206e-15*s470_now*s733 + s470_now*s736 + s67_now*s950)
        s1753 = s64_now*(s470_now*s742 + s507*s733 + s64_now*(s1747 + s470_now*s739 + s69_now*s950) + s71_now*s950)
        s1771 = s515*s733 + s64_now*(s1753 + s470_now*s745 + s509*s733 + s73_now*s950)
        s1777 = s64_now*(s470_now*s751 + s517*s733 + s64_now*(s1771 + s470_now*s748 + s75_now*s950) + s77_now*s950)
        s1780 = s1777 + s470_now*s754 + s519*s733 + s79_now*s950
        s1784 = s1780*s473_now + s866_now*s957 + s954
        s1787 = s1780*s475_now + s866_now*s960
        s1790 = R0_23_now*s1726 + s723*s842_now
        s1793 = R0_13_now*s1726 + s705*s842_now
        s1810 = s531*s733 + s64_now*(s1672*s951 + 1.5619206968586225e-16*s471_now*s733 + s471_now*s773 + s89_now*s951)
        s1816 = s64_now*(s471_now*s779 + s533*s733 + s64_now*(s1810 + s471_now*s776 + s91_now*s951) + s93_now*s951)
        s1834 = s541*s733 + s64_now*(s1816 + s471_now*s782 + s535*s733 + s951*s95_now)
        s1840 = s64_now*(s471_now*s788 + s543*s733 + s64_now*(s1834 + s471_now*s785 + s951*s97_now) + s951*s99_now)
        s1843 = s101_now*s951 + s1840 + s471_now*s791 + s545*s733
        s1853 = -s103_now*s951 - s1843*s62_now - s1843*s63_now - s471_now*s794 - s731*s898_now - s732*s898_now
        s1856 = s1853*s84_now + s551*s760
        s1859 = R0_33_now*s1856 + s730*s904_now
        s1876 = s558*s733 + s64_now*(s1739*s951 + 2.8114572543455206e-15*s471_now*s733 + s471_now*s736 + s67_now*s951)
        s1882 = s64_now*(s471_now*s742 + s560*s733 + s64_now*(s1876 + s471_now*s739 + s69_now*s951) + s71_now*s951)
        s1900 = s568*s733 + s64_now*(s1882 + s471_now*s745 + s562*s733 + s73_now*s951)
        s1906 = s64_now*(s471_now*s751 + s570*s733 + s64_now*(s1900 + s471_now*s748 + s75_now*s951) + s77_now*s951)
        s1909 = s1906 + s471_now*s754 + s572*s733 + s79_now*s951
        s1912 = s1909*s473_now + s928_now*s957
        s1916 = s1909*s475_now + s928_now*s960 - s954
        s1919 = R0_23_now*s1856 + s723*s904_now
        s1922 = R0_13_now*s1856 + s705*s904_now
        s1923 = dl_mean_now_by + l_now_by - s931
        s1926 = -s1923*s952_now
        s1927 = 0.5*s1923
        s1928 = -ex_now_by - s897 + s918
        s1931 = -s219_now*s649 - s22_now*s903
        s1932 = -ey_now_by - s901 + s921
        s1935 = -s219_now*s674 - s41_now*s903
        s1936 = dl_mean_now_by + l_now_by
        s1938 = s1936*(2*dl_mean_now + 2*l_now)
        s1950 = 0.5*(s219_now * s219_now)*(2*s22_now*s649 + 2*s41_now*s674)
        s1952 = -0.5*s1938 + s1950 + 2*s219_now*s903*(0.5*(s22_now * s22_now) + 0.5*(s41_now * s41_now))
        s1955 = -2*L_now_by - 2*dL_now_by
        s1958 = 0.5*s1196_now*s1955
        s1959 = -0.5*s1955
        s1972 = -dl_mean_now*dl_mean_now_by - dl_mean_now*l_now_by - dl_mean_now_by*l_now - 0.25*dl_now*dl_now_by - l_now*l_now_by
        s1973 = -0.25*dl_now_by
        s1980 = -0.5*dl_mean_now*dl_now_by - dl_mean_now_by*s290_now - 0.5*dl_now_by*l_now - l_now_by*s290_now
        s1983 = -0.5*dl_mean_now_by - 0.5*l_now_by
        k[91 * lane + 0] = theta_now_by
        k[91 * lane + 1] = s683
        k[91 * lane + 2] = s693
        k[91 * lane + 3] = s709
        k[91 * lane + 4] = s719
        k[91 * lane + 5] = s727
        k[91 * lane + 6] = s696
        k[91 * lane + 7] = s903
        k[91 * lane + 8] = tip_v_now_by
        k[91 * lane + 9] = s907
        k[91 * lane + 10] = s911
        k[91 * lane + 11] = s915
        k[91 * lane + 12] = s918
        k[91 * lane + 13] = s921
        k[91 * lane + 14] = s765
        k[91 * lane + 15] = s770
        k[91 * lane + 16] = s924
        k[91 * lane + 17] = s927
        k[91 * lane + 18] = s930
        k[91 * lane + 19] = s877
        k[91 * lane + 20] = s889
        k[91 * lane + 21] = s894
        k[91 * lane + 22] = s935
        k[91 * lane + 23] = s1926
        k[91 * lane + 24] = s1928
        k[91 * lane + 25] = s1931
        k[91 * lane + 26] = s1932
        k[91 * lane + 27] = s1935
        k[91 * lane + 28] = ez_now_by
        k[91 * lane + 29] = s1952
        k[91 * lane + 30] = s1958
        k[91 * lane + 31] = s1959
        k[91 * lane + 32] = s1048
        k[91 * lane + 33] = s1120
        k[91 * lane + 34] = s1130
        k[91 * lane + 35] = s1188
        k[91 * lane + 36] = s1260
        k[91 * lane + 37] = s1270
        k[91 * lane + 38] = s1273
        k[91 * lane + 39] = s1276
        k[91 * lane + 40] = s1279
        k[91 * lane + 41] = s1286
        k[91 * lane + 42] = s1252
        k[91 * lane + 43] = s1290
        k[91 * lane + 44] = s1302
        k[91 * lane + 45] = s1306
        k[91 * lane + 46] = s1318
        k[91 * lane + 47] = s1371
        k[91 * lane + 48] = s1444
        k[91 * lane + 49] = s1457
        k[91 * lane + 50] = s1513
        k[91 * lane + 51] = s1585
        k[91 * lane + 52] = s1596
        k[91 * lane + 53] = s1599
        k[91 * lane + 54] = s1602
        k[91 * lane + 55] = s1605
        k[91 * lane + 56] = s1612
        k[91 * lane + 57] = s1577
        k[91 * lane + 58] = s1616
        k[91 * lane + 59] = s1627
        k[91 * lane + 60] = s1631
        k[91 * lane + 61] = s1642
        k[91 * lane + 62] = s1647
        k[91 * lane + 63] = s1652
        k[91 * lane + 64] = s1656
        k[91 * lane + 65] = s1659
        k[91 * lane + 66] = s1662
        k[91 * lane + 67] = s1729
        k[91 * lane + 68] = s1784
        k[91 * lane + 69] = s1787
        k[91 * lane + 70] = s1790
        k[91 * lane + 71] = s1793
        k[91 * lane + 72] = s1859
        k[91 * lane + 73] = s1912
        k[91 * lane + 74] = s1916
        k[91 * lane + 75] = s1919
        k[91 * lane + 76] = s1922
        k[91 * lane + 77] = s730
        k[91 * lane + 78] = s723
        k[91 * lane + 79] = s705
        k[91 * lane + 80] = -s932
        k[91 * lane + 81] = s1643
        k[91 * lane + 82] = -s1923
        k[91 * lane + 83] = s1927
        k[91 * lane + 84] = s1938
        k[91 * lane + 85] = s1972
        k[91 * lane + 86] = s1980
        k[91 * lane + 87] = -s1936
        k[91 * lane + 88] = s1973
        k[91 * lane + 89] = s931
        k[91 * lane + 90] = s1983


@fast
def _constants_by(p, p_by, k, c):
    _fill_machine_by(p, p_by, k, p.shape[0] * p.shape[1])
    _fill_by(p, p_by, c, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how k and c change, which `constants` of ``kinematics.py`` and of this module make of one machine's p
    (1, 3, 22), along each of p_by (E, 3, 22)."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((len(p_by), 3, 91))
    c_by = np.empty((len(p_by), 3, 24))
    _constants_by(np.repeat(p, len(p_by), axis=0), p_by, k_by, c_by)
    return k_by, c_by


@straight
def _move_platform_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform after a step, and its rotation matrix (187 operations)."""
    for lane in range(n):
        cx_now = w[224 + lane]
        cy_now = w[256 + lane]
        cz_now = w[288 + lane]
        y3_now = w[9120 + lane]
        y4_now = w[9152 + lane]
        y5_now = w[9184 + lane]
        going_now = w[9280 + lane]
        y0_now_by = w_by[9024 + lane]
        y1_now_by = w_by[9056 + lane]
        y2_now_by = w_by[9088 + lane]
        y3_now_by = w_by[9120 + lane]
        y4_now_by = w_by[9152 + lane]
        y5_now_by = w_by[9184 + lane]
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
        w_by[3136 + lane] = s74
        w_by[6144 + lane] = s74
        w_by[160 + lane] = s75
        w_by[3168 + lane] = s75
        w_by[6176 + lane] = s75
        w_by[192 + lane] = s76
        w_by[3200 + lane] = s76
        w_by[6208 + lane] = s76
        w_by[224 + lane] = s93
        w_by[256 + lane] = s104
        w_by[288 + lane] = s115
        w_by[320 + lane] = s133
        w_by[3328 + lane] = s133
        w_by[6336 + lane] = s133
        w_by[352 + lane] = s142
        w_by[3360 + lane] = s142
        w_by[6368 + lane] = s142
        w_by[384 + lane] = s150
        w_by[3392 + lane] = s150
        w_by[6400 + lane] = s150
        w_by[416 + lane] = s154
        w_by[3424 + lane] = s154
        w_by[6432 + lane] = s154
        w_by[448 + lane] = s159
        w_by[3456 + lane] = s159
        w_by[6464 + lane] = s159
        w_by[480 + lane] = s166
        w_by[3488 + lane] = s166
        w_by[6496 + lane] = s166
        w_by[512 + lane] = s170
        w_by[3520 + lane] = s170
        w_by[6528 + lane] = s170
        w_by[544 + lane] = s174
        w_by[3552 + lane] = s174
        w_by[6560 + lane] = s174
        w_by[576 + lane] = s178
        w_by[3584 + lane] = s178
        w_by[6592 + lane] = s178


@straight
def _early_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (146 operations)."""
    theta_now = k[0]
    R0_11_now = k[1]
    R0_12_now = k[2]
    R0_21_now = k[3]
    R0_22_now = k[4]
    R0_31_now = k[5]
    R0_32_now = k[6]
    s219_now = k[7]
    tip_v_now = k[8]
    g_x_now = k[14]
    g_y_now = k[15]
    s1166_now = k[24]
    s1168_now = k[25]
    s1170_now = k[26]
    s1172_now = k[27]
    ez_now = k[28]
    theta_now_by = k_by[0]
    R0_11_now_by = k_by[1]
    R0_12_now_by = k_by[2]
    R0_21_now_by = k_by[3]
    R0_22_now_by = k_by[4]
    R0_31_now_by = k_by[5]
    R0_32_now_by = k_by[6]
    s219_now_by = k_by[7]
    tip_v_now_by = k_by[8]
    s223_now_by = k_by[9]
    s228_now_by = k_by[10]
    s233_now_by = k_by[11]
    s235_now_by = k_by[12]
    s238_now_by = k_by[13]
    g_x_now_by = k_by[14]
    g_y_now_by = k_by[15]
    s253_now_by = k_by[16]
    s257_now_by = k_by[17]
    s261_now_by = k_by[18]
    s1166_now_by = k_by[24]
    s1168_now_by = k_by[25]
    s1170_now_by = k_by[26]
    s1172_now_by = k_by[27]
    ez_now_by = k_by[28]
    s1184_now_by = k_by[84]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        s163_now = q_now + theta_now
        s164_now = cosine(s163_now)
        s166_now = sine(s163_now)
        R1_11_now = R0_11_now*s164_now + R0_12_now*s166_now
        R1_12_now = -R0_11_now*s166_now + R0_12_now*s164_now
        R1_21_now = R0_21_now*s164_now + R0_22_now*s166_now
        R1_22_now = -R0_21_now*s166_now + R0_22_now*s164_now
        R1_31_now = R0_31_now*s164_now + R0_32_now*s166_now
        R1_32_now = -R0_31_now*s166_now + R0_32_now*s164_now
        s1212_now = -s1166_now - s1168_now*s164_now + tx_now
        s1214_now = -s1170_now - s1172_now*s164_now + ty_now
        s1216_now = ez_now + s166_now*s219_now + tz_now
        s51 = -s166_now*theta_now_by
        s52 = s164_now*theta_now_by
        s59 = R0_11_now*s51 + R0_11_now_by*s164_now + R0_12_now*s52 + R0_12_now_by*s166_now
        s66 = -R0_11_now*s52 - R0_11_now_by*s166_now + R0_12_now*s51 + R0_12_now_by*s164_now
        s73 = R0_21_now*s51 + R0_21_now_by*s164_now + R0_22_now*s52 + R0_22_now_by*s166_now
        s80 = -R0_21_now*s52 - R0_21_now_by*s166_now + R0_22_now*s51 + R0_22_now_by*s164_now
        s87 = R0_31_now*s51 + R0_31_now_by*s164_now + R0_32_now*s52 + R0_32_now_by*s166_now
        s94 = -R0_31_now*s52 - R0_31_now_by*s166_now + R0_32_now*s51 + R0_32_now_by*s164_now
        s101 = R1_11_now*s219_now_by + R1_12_now*tip_v_now_by + s219_now*s59 + s223_now_by + s66*tip_v_now
        s108 = R1_21_now*s219_now_by + R1_22_now*tip_v_now_by + s219_now*s73 + s228_now_by + s80*tip_v_now
        s115 = R1_31_now*s219_now_by + R1_32_now*tip_v_now_by + s219_now*s87 + s233_now_by + s94*tip_v_now
        s122 = R1_11_now*g_x_now_by + R1_12_now*g_y_now_by + g_x_now*s59 + g_y_now*s66 + s253_now_by
        s129 = R1_21_now*g_x_now_by + R1_22_now*g_y_now_by + g_x_now*s73 + g_y_now*s80 + s257_now_by
        s136 = R1_31_now*g_x_now_by + R1_32_now*g_y_now_by + g_x_now*s87 + g_y_now*s94 + s261_now_by
        s140 = -s1166_now_by - s1168_now*s51 - s1168_now_by*s164_now
        s144 = -s1170_now_by - s1172_now*s51 - s1172_now_by*s164_now
        s148 = ez_now_by + s166_now*s219_now_by + s219_now*s52
        s155 = -s1184_now_by + 2*s1212_now*s140 + 2*s1214_now*s144 + 2*s1216_now*s148
        w_by[1120 + lane] = s235_now_by
        w_by[1152 + lane] = s238_now_by
        w_by[1184 + lane] = s101
        w_by[1216 + lane] = s108
        w_by[1248 + lane] = s115
        w_by[1280 + lane] = s122
        w_by[1312 + lane] = s129
        w_by[1344 + lane] = s136
        w_by[1376 + lane] = s140
        w_by[1408 + lane] = s144
        w_by[1440 + lane] = s148
        w_by[1472 + lane] = s155


@straight
def _more_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what else derivatives by joint and errors read of it (108 operations)."""
    theta_now = k[0]
    R0_11_now = k[1]
    R0_12_now = k[2]
    R0_21_now = k[3]
    R0_22_now = k[4]
    R0_31_now = k[5]
    R0_32_now = k[6]
    s219_now = k[7]
    tip_v_now = k[8]
    g_x_now = k[14]
    g_y_now = k[15]
    theta_now_by = k_by[0]
    R0_11_now_by = k_by[1]
    R0_12_now_by = k_by[2]
    R0_21_now_by = k_by[3]
    R0_22_now_by = k_by[4]
    R0_31_now_by = k_by[5]
    R0_32_now_by = k_by[6]
    s219_now_by = k_by[7]
    tip_v_now_by = k_by[8]
    g_x_now_by = k_by[14]
    g_y_now_by = k_by[15]
    for lane in range(n):
        q_now = w[0 + lane]
        s163_now = q_now + theta_now
        s164_now = cosine(s163_now)
        s166_now = sine(s163_now)
        R1_11_now = R0_11_now*s164_now + R0_12_now*s166_now
        R1_12_now = -R0_11_now*s166_now + R0_12_now*s164_now
        R1_21_now = R0_21_now*s164_now + R0_22_now*s166_now
        R1_22_now = -R0_21_now*s166_now + R0_22_now*s164_now
        R1_31_now = R0_31_now*s164_now + R0_32_now*s166_now
        R1_32_now = -R0_31_now*s166_now + R0_32_now*s164_now
        s39 = -s166_now*theta_now_by
        s40 = s164_now*theta_now_by
        s47 = R0_11_now*s39 + R0_11_now_by*s164_now + R0_12_now*s40 + R0_12_now_by*s166_now
        s54 = -R0_11_now*s40 - R0_11_now_by*s166_now + R0_12_now*s39 + R0_12_now_by*s164_now
        s61 = R0_21_now*s39 + R0_21_now_by*s164_now + R0_22_now*s40 + R0_22_now_by*s166_now
        s68 = -R0_21_now*s40 - R0_21_now_by*s166_now + R0_22_now*s39 + R0_22_now_by*s164_now
        s75 = R0_31_now*s39 + R0_31_now_by*s164_now + R0_32_now*s40 + R0_32_now_by*s166_now
        s82 = -R0_31_now*s40 - R0_31_now_by*s166_now + R0_32_now*s39 + R0_32_now_by*s164_now
        s89 = R1_11_now*tip_v_now_by - R1_12_now*s219_now_by - s219_now*s54 + s47*tip_v_now
        s96 = R1_21_now*tip_v_now_by - R1_22_now*s219_now_by - s219_now*s68 + s61*tip_v_now
        s103 = R1_31_now*tip_v_now_by - R1_32_now*s219_now_by - s219_now*s82 + s75*tip_v_now
        s110 = R1_11_now*g_y_now_by - R1_12_now*g_x_now_by - g_x_now*s54 + g_y_now*s47
        s117 = R1_21_now*g_y_now_by - R1_22_now*g_x_now_by - g_x_now*s68 + g_y_now*s61
        s124 = R1_31_now*g_y_now_by - R1_32_now*g_x_now_by - g_x_now*s82 + g_y_now*s75
        w_by[1536 + lane] = s82
        w_by[1568 + lane] = s75
        w_by[1600 + lane] = s68
        w_by[1632 + lane] = s61
        w_by[1664 + lane] = s54
        w_by[1696 + lane] = s47
        w_by[1728 + lane] = s40
        w_by[1760 + lane] = s39
        w_by[1792 + lane] = s89
        w_by[1824 + lane] = s96
        w_by[1856 + lane] = s103
        w_by[1888 + lane] = s110
        w_by[1920 + lane] = s117
        w_by[1952 + lane] = s124


@straight
def _rows_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of equations of a limb, their derivatives by shift and turn of the platform (250 operations)."""
    h_x_now = k[19]
    h_y_now = k[20]
    h_z_now = k[21]
    h_x_now_by = k_by[19]
    h_y_now_by = k_by[20]
    h_z_now_by = k_by[21]
    s1243_now_by = k_by[85]
    s1489_now_by = k_by[86]
    for lane in range(n):
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
        s236_now = w[1120 + lane]
        s239_now = w[1152 + lane]
        C_x_now = w[1184 + lane]
        C_y_now = w[1216 + lane]
        C_z_now = w[1248 + lane]
        c1_x_now = w[1280 + lane]
        c1_y_now = w[1312 + lane]
        c1_z_now = w[1344 + lane]
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
        s236_now_by = w_by[1120 + lane]
        s239_now_by = w_by[1152 + lane]
        C_x_now_by = w_by[1184 + lane]
        C_y_now_by = w_by[1216 + lane]
        C_z_now_by = w_by[1248 + lane]
        c1_x_now_by = w_by[1280 + lane]
        c1_y_now_by = w_by[1312 + lane]
        c1_z_now_by = w_by[1344 + lane]
        s237_now = R_11_now*s236_now
        s240_now = R_12_now*s239_now
        s241_now = -R_13_now*tz_now
        A_x_now = px_now + s237_now + s240_now + s241_now
        s243_now = R_21_now*s236_now
        s244_now = R_22_now*s239_now
        s245_now = -R_23_now*tz_now
        A_y_now = py_now + s243_now + s244_now + s245_now
        s247_now = R_31_now*s236_now
        s248_now = R_32_now*s239_now
        s249_now = -R_33_now*tz_now
        A_z_now = pz_now + s247_now + s248_now + s249_now
        a1_x_now = R_11_now*h_x_now + R_12_now*h_y_now + R_13_now*h_z_now
        a1_y_now = R_21_now*h_x_now + R_22_now*h_y_now + R_23_now*h_z_now
        a1_z_now = R_31_now*h_x_now + R_32_now*h_y_now + R_33_now*h_z_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        d_z_now = A_z_now - C_z_now
        s_x_now = a1_x_now - c1_x_now
        s_y_now = a1_y_now - c1_y_now
        s_z_now = a1_z_now - c1_z_now
        s1715_now = -s247_now - s248_now - s249_now
        s1717_now = s243_now + s244_now + s245_now
        s1723_now = -s237_now - s240_now - s241_now
        s82 = R_11_now*s236_now_by + R_11_now_by*s236_now
        s85 = R_12_now*s239_now_by + R_12_now_by*s239_now
        s86 = -R_13_now_by*tz_now
        s90 = R_21_now*s236_now_by + R_21_now_by*s236_now
        s93 = R_22_now*s239_now_by + R_22_now_by*s239_now
        s94 = -R_23_now_by*tz_now
        s98 = R_31_now*s236_now_by + R_31_now_by*s236_now
        s101 = R_32_now*s239_now_by + R_32_now_by*s239_now
        s102 = -R_33_now_by*tz_now
        s113 = R_11_now*h_x_now_by + R_11_now_by*h_x_now + R_12_now*h_y_now_by + R_12_now_by*h_y_now + R_13_now*h_z_now_by + R_13_now_by*h_z_now
        s123 = R_21_now*h_x_now_by + R_21_now_by*h_x_now + R_22_now*h_y_now_by + R_22_now_by*h_y_now + R_23_now*h_z_now_by + R_23_now_by*h_z_now
        s133 = R_31_now*h_x_now_by + R_31_now_by*h_x_now + R_32_now*h_y_now_by + R_32_now_by*h_y_now + R_33_now*h_z_now_by + R_33_now_by*h_z_now
        s134 = -C_x_now_by + px_now_by + s82 + s85 + s86
        s135 = -C_y_now_by + py_now_by + s90 + s93 + s94
        s136 = -C_z_now_by + pz_now_by + s101 + s102 + s98
        s137 = -c1_x_now_by + s113
        s138 = -c1_y_now_by + s123
        s139 = -c1_z_now_by + s133
        s158 = d_x_now*s134 + d_y_now*s135 + d_z_now*s136 + s1243_now_by + s137*s_x_now + s138*s_y_now + s139*s_z_now
        s168 = d_x_now*s137 + d_y_now*s138 + d_z_now*s139 + s134*s_x_now + s135*s_y_now + s136*s_z_now + s1489_now_by
        s169 = -s101 - s102 - s98
        s170 = s90 + s93 + s94
        s182 = -a1_z_now*s138 - s133*s_y_now
        s183 = a1_y_now*s139 + d_y_now*s169 + d_z_now*s170 + s123*s_z_now + s135*s1715_now + s136*s1717_now + s182
        s184 = -s82 - s85 - s86
        s196 = -d_x_now*s169 - s134*s1715_now
        s197 = -a1_x_now*s139 + a1_z_now*s137 + d_z_now*s184 - s113*s_z_now + s133*s_x_now + s136*s1723_now + s196
        s209 = -d_y_now*s184 - s135*s1723_now
        s210 = a1_x_now*s138 - a1_y_now*s137 - d_x_now*s170 + s113*s_y_now - s123*s_x_now - s134*s1717_now + s209
        s222 = -a1_z_now*s135 - d_y_now*s133
        s223 = a1_y_now*s136 + d_z_now*s123 + s138*s1715_now + s139*s1717_now + s169*s_y_now + s170*s_z_now + s222
        s235 = -s137*s1715_now - s169*s_x_now
        s236 = -a1_x_now*s136 + a1_z_now*s134 + d_x_now*s133 - d_z_now*s113 + s139*s1723_now + s184*s_z_now + s235
        s248 = -s138*s1723_now - s184*s_y_now
        s249 = a1_x_now*s135 - a1_y_now*s134 - d_x_now*s123 + d_y_now*s113 - s137*s1717_now - s170*s_x_now + s248
        w_by[608 + lane] = s158
        w_by[640 + lane] = s134
        w_by[672 + lane] = s135
        w_by[704 + lane] = s136
        w_by[736 + lane] = s183
        w_by[768 + lane] = s197
        w_by[800 + lane] = s210
        w_by[864 + lane] = s168
        w_by[896 + lane] = s137
        w_by[928 + lane] = s138
        w_by[960 + lane] = s139
        w_by[992 + lane] = s223
        w_by[1024 + lane] = s236
        w_by[1056 + lane] = s249


@straight
def _joints_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of derivatives of a limb's equations by its joint (154 operations)."""
    h_x_now = k[19]
    h_y_now = k[20]
    h_z_now = k[21]
    h_x_now_by = k_by[19]
    h_y_now_by = k_by[20]
    h_z_now_by = k_by[21]
    for lane in range(n):
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
        s236_now = w[1120 + lane]
        s239_now = w[1152 + lane]
        C_x_now = w[1184 + lane]
        C_y_now = w[1216 + lane]
        C_z_now = w[1248 + lane]
        c1_x_now = w[1280 + lane]
        c1_y_now = w[1312 + lane]
        c1_z_now = w[1344 + lane]
        s1750_now = w[1792 + lane]
        s1754_now = w[1824 + lane]
        s1758_now = w[1856 + lane]
        s1762_now = w[1888 + lane]
        s1766_now = w[1920 + lane]
        s1770_now = w[1952 + lane]
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
        s236_now_by = w_by[1120 + lane]
        s239_now_by = w_by[1152 + lane]
        C_x_now_by = w_by[1184 + lane]
        C_y_now_by = w_by[1216 + lane]
        C_z_now_by = w_by[1248 + lane]
        c1_x_now_by = w_by[1280 + lane]
        c1_y_now_by = w_by[1312 + lane]
        c1_z_now_by = w_by[1344 + lane]
        s1750_now_by = w_by[1792 + lane]
        s1754_now_by = w_by[1824 + lane]
        s1758_now_by = w_by[1856 + lane]
        s1762_now_by = w_by[1888 + lane]
        s1766_now_by = w_by[1920 + lane]
        s1770_now_by = w_by[1952 + lane]
        A_x_now = R_11_now*s236_now + R_12_now*s239_now - R_13_now*tz_now + px_now
        A_y_now = R_21_now*s236_now + R_22_now*s239_now - R_23_now*tz_now + py_now
        A_z_now = R_31_now*s236_now + R_32_now*s239_now - R_33_now*tz_now + pz_now
        a1_x_now = R_11_now*h_x_now + R_12_now*h_y_now + R_13_now*h_z_now
        a1_y_now = R_21_now*h_x_now + R_22_now*h_y_now + R_23_now*h_z_now
        a1_z_now = R_31_now*h_x_now + R_32_now*h_y_now + R_33_now*h_z_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        d_z_now = A_z_now - C_z_now
        s_x_now = a1_x_now - c1_x_now
        s_y_now = a1_y_now - c1_y_now
        s_z_now = a1_z_now - c1_z_now
        s98 = -C_x_now_by + R_11_now*s236_now_by + R_11_now_by*s236_now + R_12_now*s239_now_by + R_12_now_by*s239_now - R_13_now_by*tz_now + px_now_by
        s99 = -C_y_now_by + R_21_now*s236_now_by + R_21_now_by*s236_now + R_22_now*s239_now_by + R_22_now_by*s239_now - R_23_now_by*tz_now + py_now_by
        s100 = -C_z_now_by + R_31_now*s236_now_by + R_31_now_by*s236_now + R_32_now*s239_now_by + R_32_now_by*s239_now - R_33_now_by*tz_now + pz_now_by
        s101 = R_11_now*h_x_now_by + R_11_now_by*h_x_now + R_12_now*h_y_now_by + R_12_now_by*h_y_now + R_13_now*h_z_now_by + R_13_now_by*h_z_now - c1_x_now_by
        s102 = R_21_now*h_x_now_by + R_21_now_by*h_x_now + R_22_now*h_y_now_by + R_22_now_by*h_y_now + R_23_now*h_z_now_by + R_23_now_by*h_z_now - c1_y_now_by
        s103 = R_31_now*h_x_now_by + R_31_now_by*h_x_now + R_32_now*h_y_now_by + R_32_now_by*h_y_now + R_33_now*h_z_now_by + R_33_now_by*h_z_now - c1_z_now_by
        s112 = d_z_now*s1758_now_by + s100*s1758_now
        s115 = s101*s1762_now + s1762_now_by*s_x_now
        s118 = s102*s1766_now + s1766_now_by*s_y_now
        s121 = s103*s1770_now + s1770_now_by*s_z_now
        s122 = d_x_now*s1750_now_by + d_y_now*s1754_now_by + s112 + s115 + s118 + s121 + s1750_now*s98 + s1754_now*s99
        s131 = d_z_now*s1770_now_by + s100*s1770_now
        s134 = s101*s1750_now + s1750_now_by*s_x_now
        s137 = s102*s1754_now + s1754_now_by*s_y_now
        s140 = s103*s1758_now + s1758_now_by*s_z_now
        s141 = d_x_now*s1762_now_by + d_y_now*s1766_now_by + s131 + s134 + s137 + s140 + s1762_now*s98 + s1766_now*s99
        w_by[832 + lane] = s122
        w_by[1088 + lane] = s141


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
        J01_0_now = w[896 + lane]
        J01_1_now = w[928 + lane]
        J01_2_now = w[960 + lane]
        J01_3_now = w[992 + lane]
        J01_4_now = w[1024 + lane]
        J01_5_now = w[1056 + lane]
        J10_0_now = w[3648 + lane]
        J10_1_now = w[3680 + lane]
        J10_2_now = w[3712 + lane]
        J10_3_now = w[3744 + lane]
        J10_4_now = w[3776 + lane]
        J10_5_now = w[3808 + lane]
        J11_0_now = w[3904 + lane]
        J11_1_now = w[3936 + lane]
        J11_2_now = w[3968 + lane]
        J11_3_now = w[4000 + lane]
        J11_4_now = w[4032 + lane]
        J11_5_now = w[4064 + lane]
        J20_0_now = w[6656 + lane]
        J20_1_now = w[6688 + lane]
        J20_2_now = w[6720 + lane]
        J20_3_now = w[6752 + lane]
        J20_4_now = w[6784 + lane]
        J20_5_now = w[6816 + lane]
        J21_0_now = w[6912 + lane]
        J21_1_now = w[6944 + lane]
        J21_2_now = w[6976 + lane]
        J21_3_now = w[7008 + lane]
        J21_4_now = w[7040 + lane]
        J21_5_now = w[7072 + lane]
        J00_0_now_by = w_by[640 + lane]
        J00_1_now_by = w_by[672 + lane]
        J00_2_now_by = w_by[704 + lane]
        J00_3_now_by = w_by[736 + lane]
        J00_4_now_by = w_by[768 + lane]
        J00_5_now_by = w_by[800 + lane]
        J01_0_now_by = w_by[896 + lane]
        J01_1_now_by = w_by[928 + lane]
        J01_2_now_by = w_by[960 + lane]
        J01_3_now_by = w_by[992 + lane]
        J01_4_now_by = w_by[1024 + lane]
        J01_5_now_by = w_by[1056 + lane]
        J10_0_now_by = w_by[3648 + lane]
        J10_1_now_by = w_by[3680 + lane]
        J10_2_now_by = w_by[3712 + lane]
        J10_3_now_by = w_by[3744 + lane]
        J10_4_now_by = w_by[3776 + lane]
        J10_5_now_by = w_by[3808 + lane]
        J11_0_now_by = w_by[3904 + lane]
        J11_1_now_by = w_by[3936 + lane]
        J11_2_now_by = w_by[3968 + lane]
        J11_3_now_by = w_by[4000 + lane]
        J11_4_now_by = w_by[4032 + lane]
        J11_5_now_by = w_by[4064 + lane]
        J20_0_now_by = w_by[6656 + lane]
        J20_1_now_by = w_by[6688 + lane]
        J20_2_now_by = w_by[6720 + lane]
        J20_3_now_by = w_by[6752 + lane]
        J20_4_now_by = w_by[6784 + lane]
        J20_5_now_by = w_by[6816 + lane]
        J21_0_now_by = w_by[6912 + lane]
        J21_1_now_by = w_by[6944 + lane]
        J21_2_now_by = w_by[6976 + lane]
        J21_3_now_by = w_by[7008 + lane]
        J21_4_now_by = w_by[7040 + lane]
        J21_5_now_by = w_by[7072 + lane]
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
        S_00_now = -J01_0_now*U_00_now - J01_1_now*U_10_now - J01_2_now*U_20_now + J01_3_now
        S_01_now = -J01_0_now*U_01_now - J01_1_now*U_11_now - J01_2_now*U_21_now + J01_4_now
        S_02_now = -J01_0_now*U_02_now - J01_1_now*U_12_now - J01_2_now*U_22_now + J01_5_now
        S_10_now = -J11_0_now*U_00_now - J11_1_now*U_10_now - J11_2_now*U_20_now + J11_3_now
        S_11_now = -J11_0_now*U_01_now - J11_1_now*U_11_now - J11_2_now*U_21_now + J11_4_now
        S_12_now = -J11_0_now*U_02_now - J11_1_now*U_12_now - J11_2_now*U_22_now + J11_5_now
        S_20_now = -J21_0_now*U_00_now - J21_1_now*U_10_now - J21_2_now*U_20_now + J21_3_now
        S_21_now = -J21_0_now*U_01_now - J21_1_now*U_11_now - J21_2_now*U_21_now + J21_4_now
        S_22_now = -J21_0_now*U_02_now - J21_1_now*U_12_now - J21_2_now*U_22_now + J21_5_now
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
        s193_now = -J01_0_now*Si_inv_00_now - J11_0_now*Si_inv_01_now - J21_0_now*Si_inv_02_now
        s198_now = -J01_1_now*Si_inv_00_now - J11_1_now*Si_inv_01_now - J21_1_now*Si_inv_02_now
        s203_now = -J01_2_now*Si_inv_00_now - J11_2_now*Si_inv_01_now - J21_2_now*Si_inv_02_now
        V_00_now = G_inv_00_now*s193_now + G_inv_10_now*s198_now + G_inv_20_now*s203_now
        V_01_now = G_inv_01_now*s193_now + G_inv_11_now*s198_now + G_inv_21_now*s203_now
        V_02_now = G_inv_02_now*s193_now + G_inv_12_now*s198_now + G_inv_22_now*s203_now
        s217_now = -J01_0_now*Si_inv_10_now - J11_0_now*Si_inv_11_now - J21_0_now*Si_inv_12_now
        s222_now = -J01_1_now*Si_inv_10_now - J11_1_now*Si_inv_11_now - J21_1_now*Si_inv_12_now
        s227_now = -J01_2_now*Si_inv_10_now - J11_2_now*Si_inv_11_now - J21_2_now*Si_inv_12_now
        V_10_now = G_inv_00_now*s217_now + G_inv_10_now*s222_now + G_inv_20_now*s227_now
        V_11_now = G_inv_01_now*s217_now + G_inv_11_now*s222_now + G_inv_21_now*s227_now
        V_12_now = G_inv_02_now*s217_now + G_inv_12_now*s222_now + G_inv_22_now*s227_now
        s241_now = -J01_0_now*Si_inv_20_now - J11_0_now*Si_inv_21_now - J21_0_now*Si_inv_22_now
        s246_now = -J01_1_now*Si_inv_20_now - J11_1_now*Si_inv_21_now - J21_1_now*Si_inv_22_now
        s251_now = -J01_2_now*Si_inv_20_now - J11_2_now*Si_inv_21_now - J21_2_now*Si_inv_22_now
        V_20_now = G_inv_00_now*s241_now + G_inv_10_now*s246_now + G_inv_20_now*s251_now
        V_21_now = G_inv_01_now*s241_now + G_inv_11_now*s246_now + G_inv_21_now*s251_now
        V_22_now = G_inv_02_now*s241_now + G_inv_12_now*s246_now + G_inv_22_now*s251_now
        s342_now = (J10_0_now * J10_0_now) + (J10_1_now * J10_1_now) + (J10_2_now * J10_2_now)
        s346_now = (J20_0_now * J20_0_now) + (J20_1_now * J20_1_now) + (J20_2_now * J20_2_now)
        s310 = (J00_0_now * J00_0_now) + (J00_1_now * J00_1_now) + (J00_2_now * J00_2_now)
        s357_now = (J11_3_now * J11_3_now) + (J11_4_now * J11_4_now) + (J11_5_now * J11_5_now)
        s361_now = (J21_3_now * J21_3_now) + (J21_4_now * J21_4_now) + (J21_5_now * J21_5_now)
        s325 = (J01_3_now * J01_3_now) + (J01_4_now * J01_4_now) + (J01_5_now * J01_5_now)
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
        s529 = -J01_0_now*s439 - J01_0_now_by*U_00_now - J01_1_now*s469 - J01_1_now_by*U_10_now - J01_2_now*s499 - J01_2_now_by*U_20_now + J01_3_now_by
        s539 = -J01_0_now*s449 - J01_0_now_by*U_01_now - J01_1_now*s479 - J01_1_now_by*U_11_now - J01_2_now*s509 - J01_2_now_by*U_21_now + J01_4_now_by
        s549 = -J01_0_now*s459 - J01_0_now_by*U_02_now - J01_1_now*s489 - J01_1_now_by*U_12_now - J01_2_now*s519 - J01_2_now_by*U_22_now + J01_5_now_by
        s559 = -J11_0_now*s439 - J11_0_now_by*U_00_now - J11_1_now*s469 - J11_1_now_by*U_10_now - J11_2_now*s499 - J11_2_now_by*U_20_now + J11_3_now_by
        s569 = -J11_0_now*s449 - J11_0_now_by*U_01_now - J11_1_now*s479 - J11_1_now_by*U_11_now - J11_2_now*s509 - J11_2_now_by*U_21_now + J11_4_now_by
        s579 = -J11_0_now*s459 - J11_0_now_by*U_02_now - J11_1_now*s489 - J11_1_now_by*U_12_now - J11_2_now*s519 - J11_2_now_by*U_22_now + J11_5_now_by
        s589 = -J21_0_now*s439 - J21_0_now_by*U_00_now - J21_1_now*s469 - J21_1_now_by*U_10_now - J21_2_now*s499 - J21_2_now_by*U_20_now + J21_3_now_by
        s599 = -J21_0_now*s449 - J21_0_now_by*U_01_now - J21_1_now*s479 - J21_1_now_by*U_11_now - J21_2_now*s509 - J21_2_now_by*U_21_now + J21_4_now_by
        s609 = -J21_0_now*s459 - J21_0_now_by*U_02_now - J21_1_now*s489 - J21_1_now_by*U_12_now - J21_2_now*s519 - J21_2_now_by*U_22_now + J21_5_now_by
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
        s721 = -J01_0_now*s687 - J01_0_now_by*Si_inv_00_now - J11_0_now*s690 - J11_0_now_by*Si_inv_01_now - J21_0_now*s693 - J21_0_now_by*Si_inv_02_now
        s731 = -J01_1_now*s687 - J01_1_now_by*Si_inv_00_now - J11_1_now*s690 - J11_1_now_by*Si_inv_01_now - J21_1_now*s693 - J21_1_now_by*Si_inv_02_now
        s741 = -J01_2_now*s687 - J01_2_now_by*Si_inv_00_now - J11_2_now*s690 - J11_2_now_by*Si_inv_01_now - J21_2_now*s693 - J21_2_now_by*Si_inv_02_now
        s751 = G_inv_00_now*s721 + G_inv_10_now*s731 + G_inv_20_now*s741 + s193_now*s405 + s198_now*s414 + s203_now*s423
        s761 = G_inv_01_now*s721 + G_inv_11_now*s731 + G_inv_21_now*s741 + s193_now*s408 + s198_now*s417 + s203_now*s426
        s771 = G_inv_02_now*s721 + G_inv_12_now*s731 + G_inv_22_now*s741 + s193_now*s411 + s198_now*s420 + s203_now*s429
        s781 = -J01_0_now*s696 - J01_0_now_by*Si_inv_10_now - J11_0_now*s699 - J11_0_now_by*Si_inv_11_now - J21_0_now*s702 - J21_0_now_by*Si_inv_12_now
        s791 = -J01_1_now*s696 - J01_1_now_by*Si_inv_10_now - J11_1_now*s699 - J11_1_now_by*Si_inv_11_now - J21_1_now*s702 - J21_1_now_by*Si_inv_12_now
        s801 = -J01_2_now*s696 - J01_2_now_by*Si_inv_10_now - J11_2_now*s699 - J11_2_now_by*Si_inv_11_now - J21_2_now*s702 - J21_2_now_by*Si_inv_12_now
        s811 = G_inv_00_now*s781 + G_inv_10_now*s791 + G_inv_20_now*s801 + s217_now*s405 + s222_now*s414 + s227_now*s423
        s821 = G_inv_01_now*s781 + G_inv_11_now*s791 + G_inv_21_now*s801 + s217_now*s408 + s222_now*s417 + s227_now*s426
        s831 = G_inv_02_now*s781 + G_inv_12_now*s791 + G_inv_22_now*s801 + s217_now*s411 + s222_now*s420 + s227_now*s429
        s841 = -J01_0_now*s705 - J01_0_now_by*Si_inv_20_now - J11_0_now*s708 - J11_0_now_by*Si_inv_21_now - J21_0_now*s711 - J21_0_now_by*Si_inv_22_now
        s851 = -J01_1_now*s705 - J01_1_now_by*Si_inv_20_now - J11_1_now*s708 - J11_1_now_by*Si_inv_21_now - J21_1_now*s711 - J21_1_now_by*Si_inv_22_now
        s861 = -J01_2_now*s705 - J01_2_now_by*Si_inv_20_now - J11_2_now*s708 - J11_2_now_by*Si_inv_21_now - J21_2_now*s711 - J21_2_now_by*Si_inv_22_now
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
        s1129 = -1.0e-12*s357_now*s361_now*(2*J01_3_now*J01_3_now_by + 2*J01_4_now*J01_4_now_by + 2*J01_5_now*J01_5_now_by)
        s1130 = -1.0e-12*s325*s361_now*(2*J11_3_now*J11_3_now_by + 2*J11_4_now*J11_4_now_by + 2*J11_5_now*J11_5_now_by)
        s1131 = -1.0e-12*s325*s357_now*(2*J21_3_now*J21_3_now_by + 2*J21_4_now*J21_4_now_by + 2*J21_5_now*J21_5_now_by)
        s1133 = 2*Si_det_00_now*s682 + s1129 + s1130 + s1131
        w_by[9312 + lane] = s901
        w_by[9344 + lane] = s911
        w_by[9376 + lane] = s921
        w_by[9408 + lane] = s931
        w_by[9440 + lane] = s941
        w_by[9472 + lane] = s951
        w_by[9504 + lane] = s961
        w_by[9536 + lane] = s971
        w_by[9568 + lane] = s981
        w_by[9600 + lane] = s991
        w_by[9632 + lane] = s1001
        w_by[9664 + lane] = s1011
        w_by[9696 + lane] = s1021
        w_by[9728 + lane] = s1031
        w_by[9760 + lane] = s1041
        w_by[9792 + lane] = s1051
        w_by[9824 + lane] = s1061
        w_by[9856 + lane] = s1071
        w_by[9888 + lane] = -s751
        w_by[9920 + lane] = -s761
        w_by[9952 + lane] = -s771
        w_by[9984 + lane] = -s687
        w_by[10016 + lane] = -s690
        w_by[10048 + lane] = -s693
        w_by[10080 + lane] = -s811
        w_by[10112 + lane] = -s821
        w_by[10144 + lane] = -s831
        w_by[10176 + lane] = -s696
        w_by[10208 + lane] = -s699
        w_by[10240 + lane] = -s702
        w_by[10272 + lane] = -s871
        w_by[10304 + lane] = -s881
        w_by[10336 + lane] = -s891
        w_by[10368 + lane] = -s705
        w_by[10400 + lane] = -s708
        w_by[10432 + lane] = -s711
        w_by[10464 + lane] = s1102
        w_by[10496 + lane] = s1133


@straight
def _move_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of how the platform moves with each joint, and how it does (246 operations)."""
    for lane in range(n):
        M_0_0_now = w[9312 + lane]
        M_0_1_now = w[9344 + lane]
        M_0_2_now = w[9376 + lane]
        M_0_3_now = w[9408 + lane]
        M_0_4_now = w[9440 + lane]
        M_0_5_now = w[9472 + lane]
        M_1_0_now = w[9504 + lane]
        M_1_1_now = w[9536 + lane]
        M_1_2_now = w[9568 + lane]
        M_1_3_now = w[9600 + lane]
        M_1_4_now = w[9632 + lane]
        M_1_5_now = w[9664 + lane]
        M_2_0_now = w[9696 + lane]
        M_2_1_now = w[9728 + lane]
        M_2_2_now = w[9760 + lane]
        M_2_3_now = w[9792 + lane]
        M_2_4_now = w[9824 + lane]
        M_2_5_now = w[9856 + lane]
        M_3_0_now = w[9888 + lane]
        M_3_1_now = w[9920 + lane]
        M_3_2_now = w[9952 + lane]
        M_3_3_now = w[9984 + lane]
        M_3_4_now = w[10016 + lane]
        M_3_5_now = w[10048 + lane]
        M_4_0_now = w[10080 + lane]
        M_4_1_now = w[10112 + lane]
        M_4_2_now = w[10144 + lane]
        M_4_3_now = w[10176 + lane]
        M_4_4_now = w[10208 + lane]
        M_4_5_now = w[10240 + lane]
        M_5_0_now = w[10272 + lane]
        M_5_1_now = w[10304 + lane]
        M_5_2_now = w[10336 + lane]
        M_5_3_now = w[10368 + lane]
        M_5_4_now = w[10400 + lane]
        M_5_5_now = w[10432 + lane]
        q_t_0_now = d[0 + lane]
        Q_0_now = w[832 + lane]
        Q_3_now = w[1088 + lane]
        q_t_1_now = d[1280 + lane]
        Q_1_now = w[3840 + lane]
        Q_4_now = w[4096 + lane]
        q_t_2_now = d[2560 + lane]
        Q_2_now = w[6848 + lane]
        Q_5_now = w[7104 + lane]
        M_0_0_now_by = w_by[9312 + lane]
        M_0_1_now_by = w_by[9344 + lane]
        M_0_2_now_by = w_by[9376 + lane]
        M_0_3_now_by = w_by[9408 + lane]
        M_0_4_now_by = w_by[9440 + lane]
        M_0_5_now_by = w_by[9472 + lane]
        M_1_0_now_by = w_by[9504 + lane]
        M_1_1_now_by = w_by[9536 + lane]
        M_1_2_now_by = w_by[9568 + lane]
        M_1_3_now_by = w_by[9600 + lane]
        M_1_4_now_by = w_by[9632 + lane]
        M_1_5_now_by = w_by[9664 + lane]
        M_2_0_now_by = w_by[9696 + lane]
        M_2_1_now_by = w_by[9728 + lane]
        M_2_2_now_by = w_by[9760 + lane]
        M_2_3_now_by = w_by[9792 + lane]
        M_2_4_now_by = w_by[9824 + lane]
        M_2_5_now_by = w_by[9856 + lane]
        M_3_0_now_by = w_by[9888 + lane]
        M_3_1_now_by = w_by[9920 + lane]
        M_3_2_now_by = w_by[9952 + lane]
        M_3_3_now_by = w_by[9984 + lane]
        M_3_4_now_by = w_by[10016 + lane]
        M_3_5_now_by = w_by[10048 + lane]
        M_4_0_now_by = w_by[10080 + lane]
        M_4_1_now_by = w_by[10112 + lane]
        M_4_2_now_by = w_by[10144 + lane]
        M_4_3_now_by = w_by[10176 + lane]
        M_4_4_now_by = w_by[10208 + lane]
        M_4_5_now_by = w_by[10240 + lane]
        M_5_0_now_by = w_by[10272 + lane]
        M_5_1_now_by = w_by[10304 + lane]
        M_5_2_now_by = w_by[10336 + lane]
        M_5_3_now_by = w_by[10368 + lane]
        M_5_4_now_by = w_by[10400 + lane]
        M_5_5_now_by = w_by[10432 + lane]
        q_t_0_now_by = d_by[0 + lane]
        Q_0_now_by = w_by[832 + lane]
        Q_3_now_by = w_by[1088 + lane]
        q_t_1_now_by = d_by[1280 + lane]
        Q_1_now_by = w_by[3840 + lane]
        Q_4_now_by = w_by[4096 + lane]
        q_t_2_now_by = d_by[2560 + lane]
        Q_2_now_by = w_by[6848 + lane]
        Q_5_now_by = w_by[7104 + lane]
        V_0_0_now = M_0_0_now*Q_0_now + M_0_3_now*Q_3_now
        V_0_1_now = M_0_1_now*Q_1_now + M_0_4_now*Q_4_now
        V_0_2_now = M_0_2_now*Q_2_now + M_0_5_now*Q_5_now
        V_1_0_now = M_1_0_now*Q_0_now + M_1_3_now*Q_3_now
        V_1_1_now = M_1_1_now*Q_1_now + M_1_4_now*Q_4_now
        V_1_2_now = M_1_2_now*Q_2_now + M_1_5_now*Q_5_now
        V_2_0_now = M_2_0_now*Q_0_now + M_2_3_now*Q_3_now
        V_2_1_now = M_2_1_now*Q_1_now + M_2_4_now*Q_4_now
        V_2_2_now = M_2_2_now*Q_2_now + M_2_5_now*Q_5_now
        V_3_0_now = M_3_0_now*Q_0_now + M_3_3_now*Q_3_now
        V_3_1_now = M_3_1_now*Q_1_now + M_3_4_now*Q_4_now
        V_3_2_now = M_3_2_now*Q_2_now + M_3_5_now*Q_5_now
        V_4_0_now = M_4_0_now*Q_0_now + M_4_3_now*Q_3_now
        V_4_1_now = M_4_1_now*Q_1_now + M_4_4_now*Q_4_now
        V_4_2_now = M_4_2_now*Q_2_now + M_4_5_now*Q_5_now
        V_5_0_now = M_5_0_now*Q_0_now + M_5_3_now*Q_3_now
        V_5_1_now = M_5_1_now*Q_1_now + M_5_4_now*Q_4_now
        V_5_2_now = M_5_2_now*Q_2_now + M_5_5_now*Q_5_now
        s84 = M_0_0_now*Q_0_now_by + M_0_0_now_by*Q_0_now + M_0_3_now*Q_3_now_by + M_0_3_now_by*Q_3_now
        s91 = M_0_1_now*Q_1_now_by + M_0_1_now_by*Q_1_now + M_0_4_now*Q_4_now_by + M_0_4_now_by*Q_4_now
        s98 = M_0_2_now*Q_2_now_by + M_0_2_now_by*Q_2_now + M_0_5_now*Q_5_now_by + M_0_5_now_by*Q_5_now
        s105 = M_1_0_now*Q_0_now_by + M_1_0_now_by*Q_0_now + M_1_3_now*Q_3_now_by + M_1_3_now_by*Q_3_now
        s112 = M_1_1_now*Q_1_now_by + M_1_1_now_by*Q_1_now + M_1_4_now*Q_4_now_by + M_1_4_now_by*Q_4_now
        s119 = M_1_2_now*Q_2_now_by + M_1_2_now_by*Q_2_now + M_1_5_now*Q_5_now_by + M_1_5_now_by*Q_5_now
        s126 = M_2_0_now*Q_0_now_by + M_2_0_now_by*Q_0_now + M_2_3_now*Q_3_now_by + M_2_3_now_by*Q_3_now
        s133 = M_2_1_now*Q_1_now_by + M_2_1_now_by*Q_1_now + M_2_4_now*Q_4_now_by + M_2_4_now_by*Q_4_now
        s140 = M_2_2_now*Q_2_now_by + M_2_2_now_by*Q_2_now + M_2_5_now*Q_5_now_by + M_2_5_now_by*Q_5_now
        s147 = M_3_0_now*Q_0_now_by + M_3_0_now_by*Q_0_now + M_3_3_now*Q_3_now_by + M_3_3_now_by*Q_3_now
        s154 = M_3_1_now*Q_1_now_by + M_3_1_now_by*Q_1_now + M_3_4_now*Q_4_now_by + M_3_4_now_by*Q_4_now
        s161 = M_3_2_now*Q_2_now_by + M_3_2_now_by*Q_2_now + M_3_5_now*Q_5_now_by + M_3_5_now_by*Q_5_now
        s168 = M_4_0_now*Q_0_now_by + M_4_0_now_by*Q_0_now + M_4_3_now*Q_3_now_by + M_4_3_now_by*Q_3_now
        s175 = M_4_1_now*Q_1_now_by + M_4_1_now_by*Q_1_now + M_4_4_now*Q_4_now_by + M_4_4_now_by*Q_4_now
        s182 = M_4_2_now*Q_2_now_by + M_4_2_now_by*Q_2_now + M_4_5_now*Q_5_now_by + M_4_5_now_by*Q_5_now
        s189 = M_5_0_now*Q_0_now_by + M_5_0_now_by*Q_0_now + M_5_3_now*Q_3_now_by + M_5_3_now_by*Q_3_now
        s196 = M_5_1_now*Q_1_now_by + M_5_1_now_by*Q_1_now + M_5_4_now*Q_4_now_by + M_5_4_now_by*Q_4_now
        s203 = M_5_2_now*Q_2_now_by + M_5_2_now_by*Q_2_now + M_5_5_now*Q_5_now_by + M_5_5_now_by*Q_5_now
        s213 = V_0_0_now*q_t_0_now_by + V_0_1_now*q_t_1_now_by + V_0_2_now*q_t_2_now_by + q_t_0_now*s84 + q_t_1_now*s91 + q_t_2_now*s98
        s223 = V_1_0_now*q_t_0_now_by + V_1_1_now*q_t_1_now_by + V_1_2_now*q_t_2_now_by + q_t_0_now*s105 + q_t_1_now*s112 + q_t_2_now*s119
        s233 = V_2_0_now*q_t_0_now_by + V_2_1_now*q_t_1_now_by + V_2_2_now*q_t_2_now_by + q_t_0_now*s126 + q_t_1_now*s133 + q_t_2_now*s140
        s243 = V_3_0_now*q_t_0_now_by + V_3_1_now*q_t_1_now_by + V_3_2_now*q_t_2_now_by + q_t_0_now*s147 + q_t_1_now*s154 + q_t_2_now*s161
        s253 = V_4_0_now*q_t_0_now_by + V_4_1_now*q_t_1_now_by + V_4_2_now*q_t_2_now_by + q_t_0_now*s168 + q_t_1_now*s175 + q_t_2_now*s182
        s263 = V_5_0_now*q_t_0_now_by + V_5_1_now*q_t_1_now_by + V_5_2_now*q_t_2_now_by + q_t_0_now*s189 + q_t_1_now*s196 + q_t_2_now*s203
        s_by[0 + lane] = s84
        s_by[32 + lane] = s91
        s_by[64 + lane] = s98
        s_by[96 + lane] = s105
        s_by[128 + lane] = s112
        s_by[160 + lane] = s119
        s_by[192 + lane] = s126
        s_by[224 + lane] = s133
        s_by[256 + lane] = s140
        s_by[288 + lane] = s147
        s_by[320 + lane] = s154
        s_by[352 + lane] = s161
        s_by[384 + lane] = s168
        s_by[416 + lane] = s175
        s_by[448 + lane] = s182
        s_by[480 + lane] = s189
        s_by[512 + lane] = s196
        s_by[544 + lane] = s203
        s_by[576 + lane] = s213
        s_by[608 + lane] = s223
        s_by[640 + lane] = s233
        s_by[672 + lane] = s243
        s_by[704 + lane] = s253
        s_by[736 + lane] = s263


@straight
def _curved_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of second derivatives of a limb's equations by time where nothing accelerates (1004 operations)."""
    theta_now = k[0]
    R0_11_now = k[1]
    R0_12_now = k[2]
    R0_21_now = k[3]
    R0_22_now = k[4]
    R0_31_now = k[5]
    R0_32_now = k[6]
    s184_now = k[7]
    tip_v_now = k[8]
    s188_now = k[9]
    s193_now = k[10]
    s198_now = k[11]
    s200_now = k[12]
    s203_now = k[13]
    g_x_now = k[14]
    g_y_now = k[15]
    s218_now = k[16]
    s222_now = k[17]
    s226_now = k[18]
    h_x_now = k[19]
    h_y_now = k[20]
    h_z_now = k[21]
    theta_now_by = k_by[0]
    R0_11_now_by = k_by[1]
    R0_12_now_by = k_by[2]
    R0_21_now_by = k_by[3]
    R0_22_now_by = k_by[4]
    R0_31_now_by = k_by[5]
    R0_32_now_by = k_by[6]
    s184_now_by = k_by[7]
    tip_v_now_by = k_by[8]
    s188_now_by = k_by[9]
    s193_now_by = k_by[10]
    s198_now_by = k_by[11]
    s200_now_by = k_by[12]
    s203_now_by = k_by[13]
    g_x_now_by = k_by[14]
    g_y_now_by = k_by[15]
    s218_now_by = k_by[16]
    s222_now_by = k_by[17]
    s226_now_by = k_by[18]
    h_x_now_by = k_by[19]
    h_y_now_by = k_by[20]
    h_z_now_by = k_by[21]
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
        v_px_now = s[576 + lane]
        v_py_now = s[608 + lane]
        v_pz_now = s[640 + lane]
        w_x_now = s[672 + lane]
        w_y_now = s[704 + lane]
        w_z_now = s[736 + lane]
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
        v_px_now_by = s_by[576 + lane]
        v_py_now_by = s_by[608 + lane]
        v_pz_now_by = s_by[640 + lane]
        w_x_now_by = s_by[672 + lane]
        w_y_now_by = s_by[704 + lane]
        w_z_now_by = s_by[736 + lane]
        q_t_now_by = d_by[0 + lane]
        s163_now = q_now + theta_now
        s164_now = cosine(s163_now)
        s166_now = sine(s163_now)
        R1_11_now = R0_11_now*s164_now + R0_12_now*s166_now
        R1_12_now = -R0_11_now*s166_now + R0_12_now*s164_now
        R1_21_now = R0_21_now*s164_now + R0_22_now*s166_now
        R1_22_now = -R0_21_now*s166_now + R0_22_now*s164_now
        R1_31_now = R0_31_now*s164_now + R0_32_now*s166_now
        R1_32_now = -R0_31_now*s166_now + R0_32_now*s164_now
        C_x_now = R1_11_now*s184_now + R1_12_now*tip_v_now + s188_now
        C_y_now = R1_21_now*s184_now + R1_22_now*tip_v_now + s193_now
        C_z_now = R1_31_now*s184_now + R1_32_now*tip_v_now + s198_now
        s201_now = s200_now - tx_now
        s204_now = s203_now - ty_now
        A_x_now = R_11_now*s201_now + R_12_now*s204_now - R_13_now*tz_now + px_now
        A_y_now = R_21_now*s201_now + R_22_now*s204_now - R_23_now*tz_now + py_now
        A_z_now = R_31_now*s201_now + R_32_now*s204_now - R_33_now*tz_now + pz_now
        c1_x_now = R1_11_now*g_x_now + R1_12_now*g_y_now + s218_now
        c1_y_now = R1_21_now*g_x_now + R1_22_now*g_y_now + s222_now
        c1_z_now = R1_31_now*g_x_now + R1_32_now*g_y_now + s226_now
        a1_x_now = R_11_now*h_x_now + R_12_now*h_y_now + R_13_now*h_z_now
        a1_y_now = R_21_now*h_x_now + R_22_now*h_y_now + R_23_now*h_z_now
        a1_z_now = R_31_now*h_x_now + R_32_now*h_y_now + R_33_now*h_z_now
        d_x_now = A_x_now - C_x_now
        d_y_now = A_y_now - C_y_now
        d_z_now = A_z_now - C_z_now
        s_x_now = a1_x_now - c1_x_now
        s_y_now = a1_y_now - c1_y_now
        s_z_now = a1_z_now - c1_z_now
        s276_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s279_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s282_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s285_now = R_11_now*w_z_now - R_31_now*w_x_now
        s288_now = R_12_now*w_z_now - R_32_now*w_x_now
        s291_now = R_13_now*w_z_now - R_33_now*w_x_now
        s294_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s297_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s300_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s301_now = -q_t_now*s166_now
        s303_now = q_t_now*s164_now
        s305_now = R0_11_now*s301_now + R0_12_now*s303_now
        s308_now = -R0_11_now*s303_now + R0_12_now*s301_now
        s311_now = R0_21_now*s301_now + R0_22_now*s303_now
        s314_now = -R0_21_now*s303_now + R0_22_now*s301_now
        s317_now = R0_31_now*s301_now + R0_32_now*s303_now
        s320_now = -R0_31_now*s303_now + R0_32_now*s301_now
        s363_now = -s184_now*s305_now + s201_now*s276_now + s204_now*s279_now - s282_now*tz_now - s308_now*tip_v_now + v_px_now
        s364_now = -s184_now*s311_now + s201_now*s285_now + s204_now*s288_now - s291_now*tz_now - s314_now*tip_v_now + v_py_now
        s365_now = -s184_now*s317_now + s201_now*s294_now + s204_now*s297_now - s300_now*tz_now - s320_now*tip_v_now + v_pz_now
        s366_now = -g_x_now*s305_now - g_y_now*s308_now + h_x_now*s276_now + h_y_now*s279_now + h_z_now*s282_now
        s367_now = -g_x_now*s311_now - g_y_now*s314_now + h_x_now*s285_now + h_y_now*s288_now + h_z_now*s291_now
        s368_now = -g_x_now*s317_now - g_y_now*s320_now + h_x_now*s294_now + h_y_now*s297_now + h_z_now*s300_now
        s400_now = -s285_now*w_z_now + s294_now*w_y_now
        s403_now = -s288_now*w_z_now + s297_now*w_y_now
        s406_now = -s291_now*w_z_now + s300_now*w_y_now
        s409_now = s276_now*w_z_now - s294_now*w_x_now
        s412_now = s279_now*w_z_now - s297_now*w_x_now
        s415_now = s282_now*w_z_now - s300_now*w_x_now
        s418_now = -s276_now*w_y_now + s285_now*w_x_now
        s421_now = -s279_now*w_y_now + s288_now*w_x_now
        s424_now = -s282_now*w_y_now + s291_now*w_x_now
        s425_now = -q_t_now*s303_now
        s427_now = q_t_now*s301_now
        s429_now = R0_11_now*s425_now + R0_12_now*s427_now
        s432_now = -R0_11_now*s427_now + R0_12_now*s425_now
        s435_now = R0_21_now*s425_now + R0_22_now*s427_now
        s438_now = -R0_21_now*s427_now + R0_22_now*s425_now
        s441_now = R0_31_now*s425_now + R0_32_now*s427_now
        s444_now = -R0_31_now*s427_now + R0_32_now*s425_now
        s487_now = -s184_now*s429_now + s201_now*s400_now + s204_now*s403_now - s406_now*tz_now - s432_now*tip_v_now
        s488_now = -s184_now*s435_now + s201_now*s409_now + s204_now*s412_now - s415_now*tz_now - s438_now*tip_v_now
        s489_now = -s184_now*s441_now + s201_now*s418_now + s204_now*s421_now - s424_now*tz_now - s444_now*tip_v_now
        s490_now = -g_x_now*s429_now - g_y_now*s432_now + h_x_now*s400_now + h_y_now*s403_now + h_z_now*s406_now
        s491_now = -g_x_now*s435_now - g_y_now*s438_now + h_x_now*s409_now + h_y_now*s412_now + h_z_now*s415_now
        s492_now = -g_x_now*s441_now - g_y_now*s444_now + h_x_now*s418_now + h_y_now*s421_now + h_z_now*s424_now
        s268 = -s166_now*theta_now_by
        s269 = s164_now*theta_now_by
        s276 = R0_11_now*s268 + R0_11_now_by*s164_now + R0_12_now*s269 + R0_12_now_by*s166_now
        s283 = -R0_11_now*s269 - R0_11_now_by*s166_now + R0_12_now*s268 + R0_12_now_by*s164_now
        s290 = R0_21_now*s268 + R0_21_now_by*s164_now + R0_22_now*s269 + R0_22_now_by*s166_now
        s297 = -R0_21_now*s269 - R0_21_now_by*s166_now + R0_22_now*s268 + R0_22_now_by*s164_now
        s304 = R0_31_now*s268 + R0_31_now_by*s164_now + R0_32_now*s269 + R0_32_now_by*s166_now
        s311 = -R0_31_now*s269 - R0_31_now_by*s166_now + R0_32_now*s268 + R0_32_now_by*s164_now
        s340 = R_11_now*s200_now_by + R_11_now_by*s201_now + R_12_now*s203_now_by + R_12_now_by*s204_now - R_13_now_by*tz_now + px_now_by
        s348 = R_21_now*s200_now_by + R_21_now_by*s201_now + R_22_now*s203_now_by + R_22_now_by*s204_now - R_23_now_by*tz_now + py_now_by
        s356 = R_31_now*s200_now_by + R_31_now_by*s201_now + R_32_now*s203_now_by + R_32_now_by*s204_now - R_33_now_by*tz_now + pz_now_by
        s387 = R_11_now*h_x_now_by + R_11_now_by*h_x_now + R_12_now*h_y_now_by + R_12_now_by*h_y_now + R_13_now*h_z_now_by + R_13_now_by*h_z_now
        s397 = R_21_now*h_x_now_by + R_21_now_by*h_x_now + R_22_now*h_y_now_by + R_22_now_by*h_y_now + R_23_now*h_z_now_by + R_23_now_by*h_z_now
        s407 = R_31_now*h_x_now_by + R_31_now_by*h_x_now + R_32_now*h_y_now_by + R_32_now_by*h_y_now + R_33_now*h_z_now_by + R_33_now_by*h_z_now
        s408 = -R1_11_now*s184_now_by - R1_12_now*tip_v_now_by - s184_now*s276 - s188_now_by - s283*tip_v_now + s340
        s409 = -R1_21_now*s184_now_by - R1_22_now*tip_v_now_by - s184_now*s290 - s193_now_by - s297*tip_v_now + s348
        s410 = -R1_31_now*s184_now_by - R1_32_now*tip_v_now_by - s184_now*s304 - s198_now_by - s311*tip_v_now + s356
        s411 = -R1_11_now*g_x_now_by - R1_12_now*g_y_now_by - g_x_now*s276 - g_y_now*s283 - s218_now_by + s387
        s412 = -R1_21_now*g_x_now_by - R1_22_now*g_y_now_by - g_x_now*s290 - g_y_now*s297 - s222_now_by + s397
        s413 = -R1_31_now*g_x_now_by - R1_32_now*g_y_now_by - g_x_now*s304 - g_y_now*s311 - s226_now_by + s407
        s420 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s427 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s434 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s441 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s448 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s455 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s462 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s469 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s476 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s479 = -q_t_now*s269 - q_t_now_by*s166_now
        s482 = q_t_now*s268 + q_t_now_by*s164_now
        s489 = R0_11_now*s479 + R0_11_now_by*s301_now + R0_12_now*s482 + R0_12_now_by*s303_now
        s496 = -R0_11_now*s482 - R0_11_now_by*s303_now + R0_12_now*s479 + R0_12_now_by*s301_now
        s503 = R0_21_now*s479 + R0_21_now_by*s301_now + R0_22_now*s482 + R0_22_now_by*s303_now
        s510 = -R0_21_now*s482 - R0_21_now_by*s303_now + R0_22_now*s479 + R0_22_now_by*s301_now
        s517 = R0_31_now*s479 + R0_31_now_by*s301_now + R0_32_now*s482 + R0_32_now_by*s303_now
        s524 = -R0_31_now*s482 - R0_31_now_by*s303_now + R0_32_now*s479 + R0_32_now_by*s301_now
        s533 = -s184_now*s489 - s184_now_by*s305_now
        s537 = -s308_now*tip_v_now_by - s496*tip_v_now
        s538 = s200_now_by*s276_now + s201_now*s420 + s203_now_by*s279_now + s204_now*s427 - s434*tz_now + s533 + s537 + v_px_now_by
        s547 = -s184_now*s503 - s184_now_by*s311_now
        s551 = -s314_now*tip_v_now_by - s510*tip_v_now
        s552 = s200_now_by*s285_now + s201_now*s441 + s203_now_by*s288_now + s204_now*s448 - s455*tz_now + s547 + s551 + v_py_now_by
        s561 = -s184_now*s517 - s184_now_by*s317_now
        s565 = -s320_now*tip_v_now_by - s524*tip_v_now
        s566 = s200_now_by*s294_now + s201_now*s462 + s203_now_by*s297_now + s204_now*s469 - s476*tz_now + s561 + s565 + v_pz_now_by
        s575 = h_z_now*s434 + h_z_now_by*s282_now
        s578 = -g_x_now*s489 - g_x_now_by*s305_now
        s581 = -g_y_now*s496 - g_y_now_by*s308_now
        s582 = h_x_now*s420 + h_x_now_by*s276_now + h_y_now*s427 + h_y_now_by*s279_now + s575 + s578 + s581
        s591 = h_z_now*s455 + h_z_now_by*s291_now
        s594 = -g_x_now*s503 - g_x_now_by*s311_now
        s597 = -g_y_now*s510 - g_y_now_by*s314_now
        s598 = h_x_now*s441 + h_x_now_by*s285_now + h_y_now*s448 + h_y_now_by*s288_now + s591 + s594 + s597
        s607 = h_z_now*s476 + h_z_now_by*s300_now
        s610 = -g_x_now*s517 - g_x_now_by*s317_now
        s613 = -g_y_now*s524 - g_y_now_by*s320_now
        s614 = h_x_now*s462 + h_x_now_by*s294_now + h_y_now*s469 + h_y_now_by*s297_now + s607 + s610 + s613
        s621 = -s285_now*w_z_now_by + s294_now*w_y_now_by - s441*w_z_now + s462*w_y_now
        s628 = -s288_now*w_z_now_by + s297_now*w_y_now_by - s448*w_z_now + s469*w_y_now
        s635 = -s291_now*w_z_now_by + s300_now*w_y_now_by - s455*w_z_now + s476*w_y_now
        s642 = s276_now*w_z_now_by - s294_now*w_x_now_by + s420*w_z_now - s462*w_x_now
        s649 = s279_now*w_z_now_by - s297_now*w_x_now_by + s427*w_z_now - s469*w_x_now
        s656 = s282_now*w_z_now_by - s300_now*w_x_now_by + s434*w_z_now - s476*w_x_now
        s663 = -s276_now*w_y_now_by + s285_now*w_x_now_by - s420*w_y_now + s441*w_x_now
        s670 = -s279_now*w_y_now_by + s288_now*w_x_now_by - s427*w_y_now + s448*w_x_now
        s677 = -s282_now*w_y_now_by + s291_now*w_x_now_by - s434*w_y_now + s455*w_x_now
        s680 = -q_t_now*s482 - q_t_now_by*s303_now
        s683 = q_t_now*s479 + q_t_now_by*s301_now
        s690 = R0_11_now*s680 + R0_11_now_by*s425_now + R0_12_now*s683 + R0_12_now_by*s427_now
        s697 = -R0_11_now*s683 - R0_11_now_by*s427_now + R0_12_now*s680 + R0_12_now_by*s425_now
        s704 = R0_21_now*s680 + R0_21_now_by*s425_now + R0_22_now*s683 + R0_22_now_by*s427_now
        s711 = -R0_21_now*s683 - R0_21_now_by*s427_now + R0_22_now*s680 + R0_22_now_by*s425_now
        s718 = R0_31_now*s680 + R0_31_now_by*s425_now + R0_32_now*s683 + R0_32_now_by*s427_now
        s725 = -R0_31_now*s683 - R0_31_now_by*s427_now + R0_32_now*s680 + R0_32_now_by*s425_now
        s734 = -s184_now*s690 - s184_now_by*s429_now
        s738 = -s432_now*tip_v_now_by - s697*tip_v_now
        s739 = s200_now_by*s400_now + s201_now*s621 + s203_now_by*s403_now + s204_now*s628 - s635*tz_now + s734 + s738
        s748 = -s184_now*s704 - s184_now_by*s435_now
        s752 = -s438_now*tip_v_now_by - s711*tip_v_now
        s753 = s200_now_by*s409_now + s201_now*s642 + s203_now_by*s412_now + s204_now*s649 - s656*tz_now + s748 + s752
        s762 = -s184_now*s718 - s184_now_by*s441_now
        s766 = -s444_now*tip_v_now_by - s725*tip_v_now
        s767 = s200_now_by*s418_now + s201_now*s663 + s203_now_by*s421_now + s204_now*s670 - s677*tz_now + s762 + s766
        s776 = h_z_now*s635 + h_z_now_by*s406_now
        s779 = -g_x_now*s690 - g_x_now_by*s429_now
        s782 = -g_y_now*s697 - g_y_now_by*s432_now
        s783 = h_x_now*s621 + h_x_now_by*s400_now + h_y_now*s628 + h_y_now_by*s403_now + s776 + s779 + s782
        s792 = h_z_now*s656 + h_z_now_by*s415_now
        s795 = -g_x_now*s704 - g_x_now_by*s435_now
        s798 = -g_y_now*s711 - g_y_now_by*s438_now
        s799 = h_x_now*s642 + h_x_now_by*s409_now + h_y_now*s649 + h_y_now_by*s412_now + s792 + s795 + s798
        s808 = h_z_now*s677 + h_z_now_by*s424_now
        s811 = -g_x_now*s718 - g_x_now_by*s441_now
        s814 = -g_y_now*s725 - g_y_now_by*s444_now
        s815 = h_x_now*s663 + h_x_now_by*s418_now + h_y_now*s670 + h_y_now_by*s421_now + s808 + s811 + s814
        s821 = d_z_now*s767 + 2*s365_now*s566 + s410*s489_now
        s827 = 2*s366_now*s582 + s411*s490_now + s783*s_x_now
        s833 = 2*s367_now*s598 + s412*s491_now + s799*s_y_now
        s839 = 2*s368_now*s614 + s413*s492_now + s815*s_z_now
        s846 = d_x_now*s739 + s408*s487_now
        s849 = d_y_now*s753 + s409*s488_now
        s850 = 2*s363_now*s538 + 2*s364_now*s552 + s821 + s827 + s833 + s839 + s846 + s849
        s866 = s413*s489_now + s767*s_z_now
        s867 = d_z_now*s815 + 2*s365_now*s614 + 2*s368_now*s566 + s410*s492_now + s866
        s869 = 2*s364_now*s598 + 2*s367_now*s552
        s872 = d_x_now*s783 + s408*s490_now
        s875 = d_y_now*s799 + s409*s491_now
        s878 = s411*s487_now + s739*s_x_now
        s881 = s412*s488_now + s753*s_y_now
        s882 = 2*s363_now*s582 + 2*s366_now*s538 + s867 + s869 + s872 + s875 + s878 + s881
        d_by[64 + lane] = s850
        d_by[96 + lane] = s882


@straight
def _accelerate_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform's acceleration (210 operations)."""
    for lane in range(n):
        M_0_0_now = w[9312 + lane]
        M_0_1_now = w[9344 + lane]
        M_0_2_now = w[9376 + lane]
        M_0_3_now = w[9408 + lane]
        M_0_4_now = w[9440 + lane]
        M_0_5_now = w[9472 + lane]
        M_1_0_now = w[9504 + lane]
        M_1_1_now = w[9536 + lane]
        M_1_2_now = w[9568 + lane]
        M_1_3_now = w[9600 + lane]
        M_1_4_now = w[9632 + lane]
        M_1_5_now = w[9664 + lane]
        M_2_0_now = w[9696 + lane]
        M_2_1_now = w[9728 + lane]
        M_2_2_now = w[9760 + lane]
        M_2_3_now = w[9792 + lane]
        M_2_4_now = w[9824 + lane]
        M_2_5_now = w[9856 + lane]
        M_3_0_now = w[9888 + lane]
        M_3_1_now = w[9920 + lane]
        M_3_2_now = w[9952 + lane]
        M_3_3_now = w[9984 + lane]
        M_3_4_now = w[10016 + lane]
        M_3_5_now = w[10048 + lane]
        M_4_0_now = w[10080 + lane]
        M_4_1_now = w[10112 + lane]
        M_4_2_now = w[10144 + lane]
        M_4_3_now = w[10176 + lane]
        M_4_4_now = w[10208 + lane]
        M_4_5_now = w[10240 + lane]
        M_5_0_now = w[10272 + lane]
        M_5_1_now = w[10304 + lane]
        M_5_2_now = w[10336 + lane]
        M_5_3_now = w[10368 + lane]
        M_5_4_now = w[10400 + lane]
        M_5_5_now = w[10432 + lane]
        q_tt_0_now = d[32 + lane]
        c_0_now = d[64 + lane]
        c_3_now = d[96 + lane]
        q_tt_1_now = d[1312 + lane]
        c_1_now = d[1344 + lane]
        c_4_now = d[1376 + lane]
        q_tt_2_now = d[2592 + lane]
        c_2_now = d[2624 + lane]
        c_5_now = d[2656 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_0_2_now = s[64 + lane]
        V_1_0_now = s[96 + lane]
        V_1_1_now = s[128 + lane]
        V_1_2_now = s[160 + lane]
        V_2_0_now = s[192 + lane]
        V_2_1_now = s[224 + lane]
        V_2_2_now = s[256 + lane]
        V_3_0_now = s[288 + lane]
        V_3_1_now = s[320 + lane]
        V_3_2_now = s[352 + lane]
        V_4_0_now = s[384 + lane]
        V_4_1_now = s[416 + lane]
        V_4_2_now = s[448 + lane]
        V_5_0_now = s[480 + lane]
        V_5_1_now = s[512 + lane]
        V_5_2_now = s[544 + lane]
        M_0_0_now_by = w_by[9312 + lane]
        M_0_1_now_by = w_by[9344 + lane]
        M_0_2_now_by = w_by[9376 + lane]
        M_0_3_now_by = w_by[9408 + lane]
        M_0_4_now_by = w_by[9440 + lane]
        M_0_5_now_by = w_by[9472 + lane]
        M_1_0_now_by = w_by[9504 + lane]
        M_1_1_now_by = w_by[9536 + lane]
        M_1_2_now_by = w_by[9568 + lane]
        M_1_3_now_by = w_by[9600 + lane]
        M_1_4_now_by = w_by[9632 + lane]
        M_1_5_now_by = w_by[9664 + lane]
        M_2_0_now_by = w_by[9696 + lane]
        M_2_1_now_by = w_by[9728 + lane]
        M_2_2_now_by = w_by[9760 + lane]
        M_2_3_now_by = w_by[9792 + lane]
        M_2_4_now_by = w_by[9824 + lane]
        M_2_5_now_by = w_by[9856 + lane]
        M_3_0_now_by = w_by[9888 + lane]
        M_3_1_now_by = w_by[9920 + lane]
        M_3_2_now_by = w_by[9952 + lane]
        M_3_3_now_by = w_by[9984 + lane]
        M_3_4_now_by = w_by[10016 + lane]
        M_3_5_now_by = w_by[10048 + lane]
        M_4_0_now_by = w_by[10080 + lane]
        M_4_1_now_by = w_by[10112 + lane]
        M_4_2_now_by = w_by[10144 + lane]
        M_4_3_now_by = w_by[10176 + lane]
        M_4_4_now_by = w_by[10208 + lane]
        M_4_5_now_by = w_by[10240 + lane]
        M_5_0_now_by = w_by[10272 + lane]
        M_5_1_now_by = w_by[10304 + lane]
        M_5_2_now_by = w_by[10336 + lane]
        M_5_3_now_by = w_by[10368 + lane]
        M_5_4_now_by = w_by[10400 + lane]
        M_5_5_now_by = w_by[10432 + lane]
        q_tt_0_now_by = d_by[32 + lane]
        c_0_now_by = d_by[64 + lane]
        c_3_now_by = d_by[96 + lane]
        q_tt_1_now_by = d_by[1312 + lane]
        c_1_now_by = d_by[1344 + lane]
        c_4_now_by = d_by[1376 + lane]
        q_tt_2_now_by = d_by[2592 + lane]
        c_2_now_by = d_by[2624 + lane]
        c_5_now_by = d_by[2656 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_0_2_now_by = s_by[64 + lane]
        V_1_0_now_by = s_by[96 + lane]
        V_1_1_now_by = s_by[128 + lane]
        V_1_2_now_by = s_by[160 + lane]
        V_2_0_now_by = s_by[192 + lane]
        V_2_1_now_by = s_by[224 + lane]
        V_2_2_now_by = s_by[256 + lane]
        V_3_0_now_by = s_by[288 + lane]
        V_3_1_now_by = s_by[320 + lane]
        V_3_2_now_by = s_by[352 + lane]
        V_4_0_now_by = s_by[384 + lane]
        V_4_1_now_by = s_by[416 + lane]
        V_4_2_now_by = s_by[448 + lane]
        V_5_0_now_by = s_by[480 + lane]
        V_5_1_now_by = s_by[512 + lane]
        V_5_2_now_by = s_by[544 + lane]
        s65 = M_0_5_now*c_5_now_by + M_0_5_now_by*c_5_now
        s68 = V_0_0_now*q_tt_0_now_by + V_0_0_now_by*q_tt_0_now
        s71 = V_0_1_now*q_tt_1_now_by + V_0_1_now_by*q_tt_1_now
        s74 = V_0_2_now*q_tt_2_now_by + V_0_2_now_by*q_tt_2_now
        s77 = M_0_0_now*c_0_now_by + M_0_0_now_by*c_0_now
        s80 = M_0_1_now*c_1_now_by + M_0_1_now_by*c_1_now
        s83 = M_0_2_now*c_2_now_by + M_0_2_now_by*c_2_now
        s86 = M_0_3_now*c_3_now_by + M_0_3_now_by*c_3_now
        s87 = M_0_4_now*c_4_now_by + M_0_4_now_by*c_4_now + s65 + s68 + s71 + s74 + s77 + s80 + s83 + s86
        s93 = M_1_5_now*c_5_now_by + M_1_5_now_by*c_5_now
        s96 = V_1_0_now*q_tt_0_now_by + V_1_0_now_by*q_tt_0_now
        s99 = V_1_1_now*q_tt_1_now_by + V_1_1_now_by*q_tt_1_now
        s102 = V_1_2_now*q_tt_2_now_by + V_1_2_now_by*q_tt_2_now
        s105 = M_1_0_now*c_0_now_by + M_1_0_now_by*c_0_now
        s108 = M_1_1_now*c_1_now_by + M_1_1_now_by*c_1_now
        s111 = M_1_2_now*c_2_now_by + M_1_2_now_by*c_2_now
        s114 = M_1_3_now*c_3_now_by + M_1_3_now_by*c_3_now
        s115 = M_1_4_now*c_4_now_by + M_1_4_now_by*c_4_now + s102 + s105 + s108 + s111 + s114 + s93 + s96 + s99
        s121 = M_2_5_now*c_5_now_by + M_2_5_now_by*c_5_now
        s124 = V_2_0_now*q_tt_0_now_by + V_2_0_now_by*q_tt_0_now
        s127 = V_2_1_now*q_tt_1_now_by + V_2_1_now_by*q_tt_1_now
        s130 = V_2_2_now*q_tt_2_now_by + V_2_2_now_by*q_tt_2_now
        s133 = M_2_0_now*c_0_now_by + M_2_0_now_by*c_0_now
        s136 = M_2_1_now*c_1_now_by + M_2_1_now_by*c_1_now
        s139 = M_2_2_now*c_2_now_by + M_2_2_now_by*c_2_now
        s142 = M_2_3_now*c_3_now_by + M_2_3_now_by*c_3_now
        s143 = M_2_4_now*c_4_now_by + M_2_4_now_by*c_4_now + s121 + s124 + s127 + s130 + s133 + s136 + s139 + s142
        s149 = M_3_5_now*c_5_now_by + M_3_5_now_by*c_5_now
        s152 = V_3_0_now*q_tt_0_now_by + V_3_0_now_by*q_tt_0_now
        s155 = V_3_1_now*q_tt_1_now_by + V_3_1_now_by*q_tt_1_now
        s158 = V_3_2_now*q_tt_2_now_by + V_3_2_now_by*q_tt_2_now
        s161 = M_3_0_now*c_0_now_by + M_3_0_now_by*c_0_now
        s164 = M_3_1_now*c_1_now_by + M_3_1_now_by*c_1_now
        s167 = M_3_2_now*c_2_now_by + M_3_2_now_by*c_2_now
        s170 = M_3_3_now*c_3_now_by + M_3_3_now_by*c_3_now
        s171 = M_3_4_now*c_4_now_by + M_3_4_now_by*c_4_now + s149 + s152 + s155 + s158 + s161 + s164 + s167 + s170
        s177 = M_4_5_now*c_5_now_by + M_4_5_now_by*c_5_now
        s180 = V_4_0_now*q_tt_0_now_by + V_4_0_now_by*q_tt_0_now
        s183 = V_4_1_now*q_tt_1_now_by + V_4_1_now_by*q_tt_1_now
        s186 = V_4_2_now*q_tt_2_now_by + V_4_2_now_by*q_tt_2_now
        s189 = M_4_0_now*c_0_now_by + M_4_0_now_by*c_0_now
        s192 = M_4_1_now*c_1_now_by + M_4_1_now_by*c_1_now
        s195 = M_4_2_now*c_2_now_by + M_4_2_now_by*c_2_now
        s198 = M_4_3_now*c_3_now_by + M_4_3_now_by*c_3_now
        s199 = M_4_4_now*c_4_now_by + M_4_4_now_by*c_4_now + s177 + s180 + s183 + s186 + s189 + s192 + s195 + s198
        s205 = M_5_5_now*c_5_now_by + M_5_5_now_by*c_5_now
        s208 = V_5_0_now*q_tt_0_now_by + V_5_0_now_by*q_tt_0_now
        s211 = V_5_1_now*q_tt_1_now_by + V_5_1_now_by*q_tt_1_now
        s214 = V_5_2_now*q_tt_2_now_by + V_5_2_now_by*q_tt_2_now
        s217 = M_5_0_now*c_0_now_by + M_5_0_now_by*c_0_now
        s220 = M_5_1_now*c_1_now_by + M_5_1_now_by*c_1_now
        s223 = M_5_2_now*c_2_now_by + M_5_2_now_by*c_2_now
        s226 = M_5_3_now*c_3_now_by + M_5_3_now_by*c_3_now
        s227 = M_5_4_now*c_4_now_by + M_5_4_now_by*c_4_now + s205 + s208 + s211 + s214 + s217 + s220 + s223 + s226
        s_by[768 + lane] = s87
        s_by[800 + lane] = s115
        s_by[832 + lane] = s143
        s_by[864 + lane] = s171
        s_by[896 + lane] = s199
        s_by[928 + lane] = s227


@straight
def _limb_fields_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of gravity less acceleration of the points of a limb (582 operations)."""
    theta_now = k[0]
    R0_11_now = k[1]
    R0_12_now = k[2]
    R0_21_now = k[3]
    R0_22_now = k[4]
    R0_31_now = k[5]
    R0_32_now = k[6]
    s184_now = k[7]
    tip_v_now = k[8]
    s200_now = k[12]
    s203_now = k[13]
    g_x_now = k[14]
    g_y_now = k[15]
    h_x_now = k[19]
    h_y_now = k[20]
    h_z_now = k[21]
    theta_now_by = k_by[0]
    R0_11_now_by = k_by[1]
    R0_12_now_by = k_by[2]
    R0_21_now_by = k_by[3]
    R0_22_now_by = k_by[4]
    R0_31_now_by = k_by[5]
    R0_32_now_by = k_by[6]
    s184_now_by = k_by[7]
    tip_v_now_by = k_by[8]
    s200_now_by = k_by[12]
    s203_now_by = k_by[13]
    g_x_now_by = k_by[14]
    g_y_now_by = k_by[15]
    h_x_now_by = k_by[19]
    h_y_now_by = k_by[20]
    h_z_now_by = k_by[21]
    for lane in range(n):
        q_now = w[0 + lane]
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
        w_x_now = s[672 + lane]
        w_y_now = s[704 + lane]
        w_z_now = s[736 + lane]
        w_x_t_now = s[864 + lane]
        w_y_t_now = s[896 + lane]
        w_z_t_now = s[928 + lane]
        q_t_now = d[0 + lane]
        q_tt_now = d[32 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        w_x_now_by = s_by[672 + lane]
        w_y_now_by = s_by[704 + lane]
        w_z_now_by = s_by[736 + lane]
        v_px_t_now_by = s_by[768 + lane]
        v_py_t_now_by = s_by[800 + lane]
        v_pz_t_now_by = s_by[832 + lane]
        w_x_t_now_by = s_by[864 + lane]
        w_y_t_now_by = s_by[896 + lane]
        w_z_t_now_by = s_by[928 + lane]
        q_t_now_by = d_by[0 + lane]
        q_tt_now_by = d_by[32 + lane]
        s163_now = q_now + theta_now
        s164_now = cosine(s163_now)
        s166_now = sine(s163_now)
        s201_now = s200_now - tx_now
        s204_now = s203_now - ty_now
        s276_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s279_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s282_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s285_now = R_11_now*w_z_now - R_31_now*w_x_now
        s288_now = R_12_now*w_z_now - R_32_now*w_x_now
        s291_now = R_13_now*w_z_now - R_33_now*w_x_now
        s294_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s297_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s300_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s1344_now = -R_21_now*w_z_t_now + R_31_now*w_y_t_now - s285_now*w_z_now + s294_now*w_y_now
        s1349_now = -R_22_now*w_z_t_now + R_32_now*w_y_t_now - s288_now*w_z_now + s297_now*w_y_now
        s1354_now = -R_23_now*w_z_t_now + R_33_now*w_y_t_now - s291_now*w_z_now + s300_now*w_y_now
        s1359_now = R_11_now*w_z_t_now - R_31_now*w_x_t_now + s276_now*w_z_now - s294_now*w_x_now
        s1364_now = R_12_now*w_z_t_now - R_32_now*w_x_t_now + s279_now*w_z_now - s297_now*w_x_now
        s1369_now = R_13_now*w_z_t_now - R_33_now*w_x_t_now + s282_now*w_z_now - s300_now*w_x_now
        s1374_now = -R_11_now*w_y_t_now + R_21_now*w_x_t_now - s276_now*w_y_now + s285_now*w_x_now
        s1379_now = -R_12_now*w_y_t_now + R_22_now*w_x_t_now - s279_now*w_y_now + s288_now*w_x_now
        s1384_now = -R_13_now*w_y_t_now + R_23_now*w_x_t_now - s282_now*w_y_now + s291_now*w_x_now
        s78 = (q_t_now * q_t_now)
        s1386_now = -q_tt_now*s166_now - s164_now*s78
        s1389_now = q_tt_now*s164_now - s166_now*s78
        s1391_now = R0_11_now*s1386_now + R0_12_now*s1389_now
        s1394_now = -R0_11_now*s1389_now + R0_12_now*s1386_now
        s1397_now = R0_21_now*s1386_now + R0_22_now*s1389_now
        s1400_now = -R0_21_now*s1389_now + R0_22_now*s1386_now
        s1403_now = R0_31_now*s1386_now + R0_32_now*s1389_now
        s1406_now = -R0_31_now*s1389_now + R0_32_now*s1386_now
        s207 = -s166_now*theta_now_by
        s208 = s164_now*theta_now_by
        s215 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s222 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s229 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s236 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s243 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s250 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s257 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s264 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s271 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s283 = -s236*w_z_now - s285_now*w_z_now_by
        s284 = -R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now + R_31_now*w_y_t_now_by + R_31_now_by*w_y_t_now + s257*w_y_now + s283 + s294_now*w_y_now_by
        s296 = -s243*w_z_now - s288_now*w_z_now_by
        s297 = -R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now + R_32_now*w_y_t_now_by + R_32_now_by*w_y_t_now + s264*w_y_now + s296 + s297_now*w_y_now_by
        s309 = -s250*w_z_now - s291_now*w_z_now_by
        s310 = -R_23_now*w_z_t_now_by - R_23_now_by*w_z_t_now + R_33_now*w_y_t_now_by + R_33_now_by*w_y_t_now + s271*w_y_now + s300_now*w_y_now_by + s309
        s322 = -s257*w_x_now - s294_now*w_x_now_by
        s323 = R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_31_now*w_x_t_now_by - R_31_now_by*w_x_t_now + s215*w_z_now + s276_now*w_z_now_by + s322
        s335 = -s264*w_x_now - s297_now*w_x_now_by
        s336 = R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_32_now*w_x_t_now_by - R_32_now_by*w_x_t_now + s222*w_z_now + s279_now*w_z_now_by + s335
        s348 = -s271*w_x_now - s300_now*w_x_now_by
        s349 = R_13_now*w_z_t_now_by + R_13_now_by*w_z_t_now - R_33_now*w_x_t_now_by - R_33_now_by*w_x_t_now + s229*w_z_now + s282_now*w_z_now_by + s348
        s361 = -s215*w_y_now - s276_now*w_y_now_by
        s362 = -R_11_now*w_y_t_now_by - R_11_now_by*w_y_t_now + R_21_now*w_x_t_now_by + R_21_now_by*w_x_t_now + s236*w_x_now + s285_now*w_x_now_by + s361
        s374 = -s222*w_y_now - s279_now*w_y_now_by
        s375 = -R_12_now*w_y_t_now_by - R_12_now_by*w_y_t_now + R_22_now*w_x_t_now_by + R_22_now_by*w_x_t_now + s243*w_x_now + s288_now*w_x_now_by + s374
        s387 = -s229*w_y_now - s282_now*w_y_now_by
        s388 = -R_13_now*w_y_t_now_by - R_13_now_by*w_y_t_now + R_23_now*w_x_t_now_by + R_23_now_by*w_x_t_now + s250*w_x_now + s291_now*w_x_now_by + s387
        s393 = 2*q_t_now*q_t_now_by
        s397 = -q_tt_now*s208 - q_tt_now_by*s166_now - s164_now*s393 - s207*s78
        s404 = q_tt_now*s207 + q_tt_now_by*s164_now - s166_now*s393 - s208*s78
        s411 = R0_11_now*s397 + R0_11_now_by*s1386_now + R0_12_now*s404 + R0_12_now_by*s1389_now
        s418 = -R0_11_now*s404 - R0_11_now_by*s1389_now + R0_12_now*s397 + R0_12_now_by*s1386_now
        s425 = R0_21_now*s397 + R0_21_now_by*s1386_now + R0_22_now*s404 + R0_22_now_by*s1389_now
        s432 = -R0_21_now*s404 - R0_21_now_by*s1389_now + R0_22_now*s397 + R0_22_now_by*s1386_now
        s439 = R0_31_now*s397 + R0_31_now_by*s1386_now + R0_32_now*s404 + R0_32_now_by*s1389_now
        s446 = -R0_31_now*s404 - R0_31_now_by*s1389_now + R0_32_now*s397 + R0_32_now_by*s1386_now
        s449 = s1391_now*s184_now_by + s184_now*s411
        s453 = s1394_now*tip_v_now_by + s418*tip_v_now + s449
        s456 = s1397_now*s184_now_by + s184_now*s425
        s460 = s1400_now*tip_v_now_by + s432*tip_v_now + s456
        s463 = s1403_now*s184_now_by + s184_now*s439
        s467 = s1406_now*tip_v_now_by + s446*tip_v_now + s463
        s475 = s1344_now*s200_now_by + s1349_now*s203_now_by + s201_now*s284 + s204_now*s297 - s310*tz_now + v_px_t_now_by
        s483 = s1359_now*s200_now_by + s1364_now*s203_now_by + s201_now*s323 + s204_now*s336 - s349*tz_now + v_py_t_now_by
        s491 = s1374_now*s200_now_by + s1379_now*s203_now_by + s201_now*s362 + s204_now*s375 - s388*tz_now + v_pz_t_now_by
        s498 = g_x_now*s411 + g_x_now_by*s1391_now + g_y_now*s418 + g_y_now_by*s1394_now
        s505 = g_x_now*s425 + g_x_now_by*s1397_now + g_y_now*s432 + g_y_now_by*s1400_now
        s512 = g_x_now*s439 + g_x_now_by*s1403_now + g_y_now*s446 + g_y_now_by*s1406_now
        s522 = h_x_now*s284 + h_x_now_by*s1344_now + h_y_now*s297 + h_y_now_by*s1349_now + h_z_now*s310 + h_z_now_by*s1354_now
        s532 = h_x_now*s323 + h_x_now_by*s1359_now + h_y_now*s336 + h_y_now_by*s1364_now + h_z_now*s349 + h_z_now_by*s1369_now
        s542 = h_x_now*s362 + h_x_now_by*s1374_now + h_y_now*s375 + h_y_now_by*s1379_now + h_z_now*s388 + h_z_now_by*s1384_now
        s555 = -0.001*s449
        s556 = -0.001*s456
        s557 = -0.001*s463
        s558 = -0.001*s453
        s559 = -0.001*s498
        s560 = s558 + s559
        s561 = -0.001*s460
        s562 = -0.001*s505
        s563 = s561 + s562
        s564 = -0.001*s467
        s565 = -0.001*s512
        s566 = s564 + s565
        s567 = -0.0005*s475
        s568 = -0.0005*s453
        s569 = -0.0005*s522
        s570 = -0.0005*s498
        s571 = s567 + s568 + s569 + s570
        s572 = -0.0005*s483
        s573 = -0.0005*s460
        s574 = -0.0005*s532
        s575 = -0.0005*s505
        s576 = s572 + s573 + s574 + s575
        s577 = -0.0005*s491
        s578 = -0.0005*s467
        s579 = -0.0005*s542
        s580 = -0.0005*s512
        s581 = s577 + s578 + s579 + s580
        s582 = -0.001*s475
        s583 = -0.001*s522
        s584 = s582 + s583
        s585 = -0.001*s483
        s586 = -0.001*s532
        s587 = s585 + s586
        s588 = -0.001*s491
        s589 = -0.001*s542
        s590 = s588 + s589
        s591 = s558 - s559
        s592 = s561 - s562
        s593 = s564 - s565
        s594 = s567 + s568 - s569 - s570
        s595 = s572 + s573 - s574 - s575
        s596 = s577 + s578 - s579 - s580
        s597 = s582 - s583
        s598 = s585 - s586
        s599 = s588 - s589
        d_by[224 + lane] = s555
        d_by[256 + lane] = s556
        d_by[288 + lane] = s557
        d_by[320 + lane] = -s555
        d_by[352 + lane] = -s556
        d_by[384 + lane] = -s557
        d_by[416 + lane] = s560
        d_by[448 + lane] = s563
        d_by[480 + lane] = s566
        d_by[512 + lane] = s571
        d_by[544 + lane] = s576
        d_by[576 + lane] = s581
        d_by[608 + lane] = s584
        d_by[640 + lane] = s587
        d_by[672 + lane] = s590
        d_by[704 + lane] = s591
        d_by[736 + lane] = s592
        d_by[768 + lane] = s593
        d_by[800 + lane] = s594
        d_by[832 + lane] = s595
        d_by[864 + lane] = s596
        d_by[896 + lane] = s597
        d_by[928 + lane] = s598
        d_by[960 + lane] = s599


@straight
def _limb_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a limb, along joint, shifts and turns (586 operations)."""
    share_now = shares[0]
    theta_now = k[0]
    R0_11_now = k[1]
    R0_12_now = k[2]
    R0_21_now = k[3]
    R0_22_now = k[4]
    R0_31_now = k[5]
    R0_32_now = k[6]
    s184_now = k[7]
    tip_v_now = k[8]
    s200_now = k[12]
    s203_now = k[13]
    g_x_now = k[14]
    g_y_now = k[15]
    h_x_now = k[19]
    h_y_now = k[20]
    h_z_now = k[21]
    s577_now = k[22]
    s639_now = k[23]
    theta_now_by = k_by[0]
    R0_11_now_by = k_by[1]
    R0_12_now_by = k_by[2]
    R0_21_now_by = k_by[3]
    R0_22_now_by = k_by[4]
    R0_31_now_by = k_by[5]
    R0_32_now_by = k_by[6]
    s184_now_by = k_by[7]
    tip_v_now_by = k_by[8]
    s200_now_by = k_by[12]
    s203_now_by = k_by[13]
    g_x_now_by = k_by[14]
    g_y_now_by = k_by[15]
    h_x_now_by = k_by[19]
    h_y_now_by = k_by[20]
    h_z_now_by = k_by[21]
    s577_now_by = k_by[22]
    s639_now_by = k_by[23]
    for lane in range(n):
        q_now = w[0 + lane]
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
        f1x_now = d[224 + lane]
        f1y_now = d[256 + lane]
        f1z_now = d[288 + lane]
        f2x_now = d[320 + lane]
        f2y_now = d[352 + lane]
        f2z_now = d[384 + lane]
        f3x_now = d[416 + lane]
        f3y_now = d[448 + lane]
        f3z_now = d[480 + lane]
        f4x_now = d[512 + lane]
        f4y_now = d[544 + lane]
        f4z_now = d[576 + lane]
        f5x_now = d[608 + lane]
        f5y_now = d[640 + lane]
        f5z_now = d[672 + lane]
        f6x_now = d[704 + lane]
        f6y_now = d[736 + lane]
        f6z_now = d[768 + lane]
        f7x_now = d[800 + lane]
        f7y_now = d[832 + lane]
        f7z_now = d[864 + lane]
        f8x_now = d[896 + lane]
        f8y_now = d[928 + lane]
        f8z_now = d[960 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        f1x_now_by = d_by[224 + lane]
        f1y_now_by = d_by[256 + lane]
        f1z_now_by = d_by[288 + lane]
        f2x_now_by = d_by[320 + lane]
        f2y_now_by = d_by[352 + lane]
        f2z_now_by = d_by[384 + lane]
        f3x_now_by = d_by[416 + lane]
        f3y_now_by = d_by[448 + lane]
        f3z_now_by = d_by[480 + lane]
        f4x_now_by = d_by[512 + lane]
        f4y_now_by = d_by[544 + lane]
        f4z_now_by = d_by[576 + lane]
        f5x_now_by = d_by[608 + lane]
        f5y_now_by = d_by[640 + lane]
        f5z_now_by = d_by[672 + lane]
        f6x_now_by = d_by[704 + lane]
        f6y_now_by = d_by[736 + lane]
        f6z_now_by = d_by[768 + lane]
        f7x_now_by = d_by[800 + lane]
        f7y_now_by = d_by[832 + lane]
        f7z_now_by = d_by[864 + lane]
        f8x_now_by = d_by[896 + lane]
        f8y_now_by = d_by[928 + lane]
        f8z_now_by = d_by[960 + lane]
        s163_now = q_now + theta_now
        s164_now = cosine(s163_now)
        s166_now = sine(s163_now)
        s201_now = s200_now - tx_now
        s204_now = s203_now - ty_now
        s7 = f1z_now*s577_now + f2z_now*s577_now
        s608_now = s184_now*s7
        s11 = f1y_now*s577_now + f2y_now*s577_now
        s611_now = s11*s184_now
        s15 = f1x_now*s577_now + f2x_now*s577_now
        s614_now = s15*s184_now
        s30 = f1z_now*s639_now - f2z_now*s639_now
        s656_now = s184_now*s30
        s34 = f1y_now*s639_now - f2y_now*s639_now
        s659_now = s184_now*s34
        s38 = f1x_now*s639_now - f2x_now*s639_now
        s662_now = s184_now*s38
        s719_now = 1 - 2*share_now
        s750_now = f7z_now*s719_now
        s752_now = f7y_now*s719_now
        s754_now = f7x_now*s719_now
        s756_now = f4z_now*s719_now
        s57 = 0.5*s756_now
        s58 = -0.5*s750_now
        s758_now = s57 + s58
        s760_now = s57 - s58
        s762_now = f4y_now*s719_now
        s62 = 0.5*s762_now
        s63 = -0.5*s752_now
        s764_now = s62 + s63
        s766_now = s62 - s63
        s768_now = f4x_now*s719_now
        s67 = 0.5*s768_now
        s68 = -0.5*s754_now
        s770_now = s67 + s68
        s772_now = s67 - s68
        s776_now = f8z_now*share_now
        s778_now = f8y_now*share_now
        s780_now = f8x_now*share_now
        s782_now = f6z_now*share_now
        s784_now = f6y_now*share_now
        s786_now = f6x_now*share_now
        s788_now = f5z_now*share_now
        s790_now = f5y_now*share_now
        s792_now = f5x_now*share_now
        s794_now = f3z_now*share_now
        s796_now = f3y_now*share_now
        s798_now = f3x_now*share_now
        s799_now = s758_now - s776_now + s788_now
        s806_now = s764_now - s778_now + s790_now
        s813_now = s770_now - s780_now + s792_now
        s820_now = s758_now - s782_now + s794_now
        s825_now = s764_now - s784_now + s796_now
        s830_now = s770_now - s786_now + s798_now
        s835_now = s760_now + s776_now + s788_now
        s842_now = s766_now + s778_now + s790_now
        s849_now = s772_now + s780_now + s792_now
        s858_now = s760_now + s782_now + s794_now
        s863_now = s766_now + s784_now + s796_now
        s868_now = s772_now + s786_now + s798_now
        s873_now = g_y_now*s820_now + s858_now*tip_v_now
        s878_now = g_x_now*s820_now + s184_now*s858_now
        s883_now = g_y_now*s825_now + s863_now*tip_v_now
        s888_now = g_x_now*s825_now + s184_now*s863_now
        s893_now = g_y_now*s830_now + s868_now*tip_v_now
        s898_now = g_x_now*s830_now + s184_now*s868_now
        s905_now = R0_11_now*s898_now + R0_12_now*s893_now + R0_21_now*s888_now + R0_22_now*s883_now + R0_31_now*s878_now + R0_32_now*s873_now
        s909_now = h_z_now*s799_now - s835_now*tz_now
        s911_now = h_y_now*s799_now + s204_now*s835_now
        s913_now = h_x_now*s799_now + s201_now*s835_now
        s915_now = h_z_now*s806_now - s842_now*tz_now
        s916_now = h_y_now*s806_now + s204_now*s842_now
        s917_now = h_x_now*s806_now + s201_now*s842_now
        s918_now = h_z_now*s813_now - s849_now*tz_now
        s919_now = h_y_now*s813_now + s204_now*s849_now
        s920_now = h_x_now*s813_now + s201_now*s849_now
        s178 = -s166_now*theta_now_by
        s179 = s164_now*theta_now_by
        s189 = s184_now*(f1z_now*s577_now_by + f1z_now_by*s577_now + f2z_now*s577_now_by + f2z_now_by*s577_now) + s184_now_by*s7
        s199 = s11*s184_now_by + s184_now*(f1y_now*s577_now_by + f1y_now_by*s577_now + f2y_now*s577_now_by + f2y_now_by*s577_now)
        s209 = s15*s184_now_by + s184_now*(f1x_now*s577_now_by + f1x_now_by*s577_now + f2x_now*s577_now_by + f2x_now_by*s577_now)
        s219 = R0_11_now*s209 + R0_11_now_by*s614_now + R0_21_now*s199 + R0_21_now_by*s611_now + R0_31_now*s189 + R0_31_now_by*s608_now
        s234 = s164_now*(R0_12_now*s209 + R0_12_now_by*s614_now + R0_22_now*s199 + R0_22_now_by*s611_now + R0_32_now*s189 + R0_32_now_by*s608_now)
        s235 = s178*(R0_12_now*s614_now + R0_22_now*s611_now + R0_32_now*s608_now) + s234
        s236 = -s166_now*s219 - s179*(R0_11_now*s614_now + R0_21_now*s611_now + R0_31_now*s608_now) + s235
        s246 = s184_now*(f1z_now*s639_now_by + f1z_now_by*s639_now - f2z_now*s639_now_by - f2z_now_by*s639_now) + s184_now_by*s30
        s256 = s184_now*(f1y_now*s639_now_by + f1y_now_by*s639_now - f2y_now*s639_now_by - f2y_now_by*s639_now) + s184_now_by*s34
        s266 = s184_now*(f1x_now*s639_now_by + f1x_now_by*s639_now - f2x_now*s639_now_by - f2x_now_by*s639_now) + s184_now_by*s38
        s276 = R0_11_now*s266 + R0_11_now_by*s662_now + R0_21_now*s256 + R0_21_now_by*s659_now + R0_31_now*s246 + R0_31_now_by*s656_now
        s291 = s164_now*(R0_12_now*s266 + R0_12_now_by*s662_now + R0_22_now*s256 + R0_22_now_by*s659_now + R0_32_now*s246 + R0_32_now_by*s656_now)
        s292 = s178*(R0_12_now*s662_now + R0_22_now*s659_now + R0_32_now*s656_now) + s291
        s293 = -s166_now*s276 - s179*(R0_11_now*s662_now + R0_21_now*s659_now + R0_31_now*s656_now) + s292
        s298 = 0.5*f4z_now_by*s719_now
        s299 = -0.5*f7z_now_by*s719_now
        s300 = s298 + s299
        s301 = s298 - s299
        s303 = 0.5*f4y_now_by*s719_now
        s304 = -0.5*f7y_now_by*s719_now
        s305 = s303 + s304
        s306 = s303 - s304
        s308 = 0.5*f4x_now_by*s719_now
        s309 = -0.5*f7x_now_by*s719_now
        s310 = s308 + s309
        s311 = s308 - s309
        s312 = f8z_now_by*share_now
        s313 = f8y_now_by*share_now
        s314 = f8x_now_by*share_now
        s315 = f6z_now_by*share_now
        s316 = f6y_now_by*share_now
        s317 = f6x_now_by*share_now
        s318 = f5z_now_by*share_now
        s319 = f5y_now_by*share_now
        s320 = f5x_now_by*share_now
        s321 = f3z_now_by*share_now
        s322 = f3y_now_by*share_now
        s323 = f3x_now_by*share_now
        s324 = s300 - s312 + s318
        s325 = s305 - s313 + s319
        s326 = s310 - s314 + s320
        s327 = s300 - s315 + s321
        s328 = s305 - s316 + s322
        s329 = s310 - s317 + s323
        s330 = s301 + s312 + s318
        s331 = s306 + s313 + s319
        s332 = s311 + s314 + s320
        s333 = s301 + s315 + s321
        s334 = s306 + s316 + s322
        s335 = s311 + s317 + s323
        s342 = g_y_now*s327 + g_y_now_by*s820_now + s333*tip_v_now + s858_now*tip_v_now_by
        s349 = g_x_now*s327 + g_x_now_by*s820_now + s184_now*s333 + s184_now_by*s858_now
        s356 = g_y_now*s328 + g_y_now_by*s825_now + s334*tip_v_now + s863_now*tip_v_now_by
        s363 = g_x_now*s328 + g_x_now_by*s825_now + s184_now*s334 + s184_now_by*s863_now
        s370 = g_y_now*s329 + g_y_now_by*s830_now + s335*tip_v_now + s868_now*tip_v_now_by
        s377 = g_x_now*s329 + g_x_now_by*s830_now + s184_now*s335 + s184_now_by*s868_now
        s386 = R0_32_now*s349 + R0_32_now_by*s878_now
        s389 = -R0_11_now*s370 - R0_11_now_by*s893_now
        s392 = -R0_21_now*s356 - R0_21_now_by*s883_now
        s395 = -R0_31_now*s342 - R0_31_now_by*s873_now
        s397 = s164_now*(R0_12_now*s377 + R0_12_now_by*s898_now + R0_22_now*s363 + R0_22_now_by*s888_now + s386 + s389 + s392 + s395)
        s398 = s178*(-R0_11_now*s893_now + R0_12_now*s898_now - R0_21_now*s883_now + R0_22_now*s888_now - R0_31_now*s873_now + R0_32_now*s878_now)
        s408 = R0_21_now*s363 + R0_21_now_by*s888_now
        s411 = R0_22_now*s356 + R0_22_now_by*s883_now
        s414 = R0_31_now*s349 + R0_31_now_by*s878_now
        s417 = R0_32_now*s342 + R0_32_now_by*s873_now
        s418 = R0_11_now*s377 + R0_11_now_by*s898_now + R0_12_now*s370 + R0_12_now_by*s893_now + s408 + s411 + s414 + s417
        s422 = -s166_now*s418 - s179*s905_now + s397 + s398
        s427 = h_z_now*s324 + h_z_now_by*s799_now - s330*tz_now
        s434 = h_y_now*s324 + h_y_now_by*s799_now + s203_now_by*s835_now + s204_now*s330
        s441 = h_x_now*s324 + h_x_now_by*s799_now + s200_now_by*s835_now + s201_now*s330
        s446 = h_z_now*s325 + h_z_now_by*s806_now - s331*tz_now
        s453 = h_y_now*s325 + h_y_now_by*s806_now + s203_now_by*s842_now + s204_now*s331
        s460 = h_x_now*s325 + h_x_now_by*s806_now + s200_now_by*s842_now + s201_now*s331
        s465 = h_z_now*s326 + h_z_now_by*s813_now - s332*tz_now
        s472 = h_y_now*s326 + h_y_now_by*s813_now + s203_now_by*s849_now + s204_now*s332
        s479 = h_x_now*s326 + h_x_now_by*s813_now + s200_now_by*s849_now + s201_now*s332
        s488 = R_23_now*s427 + R_23_now_by*s909_now
        s491 = -R_31_now*s460 - R_31_now_by*s917_now
        s494 = -R_32_now*s453 - R_32_now_by*s916_now
        s497 = -R_33_now*s446 - R_33_now_by*s915_now
        s498 = R_21_now*s441 + R_21_now_by*s913_now + R_22_now*s434 + R_22_now_by*s911_now + s488 + s491 + s494 + s497
        s507 = R_33_now*s465 + R_33_now_by*s918_now
        s510 = -R_11_now*s441 - R_11_now_by*s913_now
        s513 = -R_12_now*s434 - R_12_now_by*s911_now
        s516 = -R_13_now*s427 - R_13_now_by*s909_now
        s517 = R_31_now*s479 + R_31_now_by*s920_now + R_32_now*s472 + R_32_now_by*s919_now + s507 + s510 + s513 + s516
        s526 = R_13_now*s446 + R_13_now_by*s915_now
        s529 = -R_21_now*s479 - R_21_now_by*s920_now
        s532 = -R_22_now*s472 - R_22_now_by*s919_now
        s535 = -R_23_now*s465 - R_23_now_by*s918_now
        s536 = R_11_now*s460 + R_11_now_by*s917_now + R_12_now*s453 + R_12_now_by*s916_now + s526 + s529 + s532 + s535
        d_by[992 + lane] = s236
        d_by[1024 + lane] = s293
        d_by[1056 + lane] = s422
        d_by[1088 + lane] = s332
        d_by[1120 + lane] = s331
        d_by[1152 + lane] = s330
        d_by[1184 + lane] = s498
        d_by[1216 + lane] = s517
        d_by[1248 + lane] = s536


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
        w_x_now = s[672 + lane]
        w_y_now = s[704 + lane]
        w_z_now = s[736 + lane]
        w_x_t_now = s[864 + lane]
        w_y_t_now = s[896 + lane]
        w_z_t_now = s[928 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        w_x_now_by = s_by[672 + lane]
        w_y_now_by = s_by[704 + lane]
        w_z_now_by = s_by[736 + lane]
        v_px_t_now_by = s_by[768 + lane]
        v_py_t_now_by = s_by[800 + lane]
        v_pz_t_now_by = s_by[832 + lane]
        w_x_t_now_by = s_by[864 + lane]
        w_y_t_now_by = s_by[896 + lane]
        w_z_t_now_by = s_by[928 + lane]
        s307_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s310_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s313_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s316_now = R_11_now*w_z_now - R_31_now*w_x_now
        s319_now = R_12_now*w_z_now - R_32_now*w_x_now
        s322_now = R_13_now*w_z_now - R_33_now*w_x_now
        s325_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s328_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s331_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s102 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s109 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s116 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s123 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s130 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s137 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s144 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s151 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s158 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s170 = -s123*w_z_now - s316_now*w_z_now_by
        s171 = -R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now + R_31_now*w_y_t_now_by + R_31_now_by*w_y_t_now + s144*w_y_now + s170 + s325_now*w_y_now_by
        s184 = -s130*w_z_now - s319_now*w_z_now_by
        s185 = -R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now + R_32_now*w_y_t_now_by + R_32_now_by*w_y_t_now + s151*w_y_now + s184 + s328_now*w_y_now_by
        s198 = -s137*w_z_now - s322_now*w_z_now_by
        s199 = -R_23_now*w_z_t_now_by - R_23_now_by*w_z_t_now + R_33_now*w_y_t_now_by + R_33_now_by*w_y_t_now + s158*w_y_now + s198 + s331_now*w_y_now_by
        s213 = -s144*w_x_now - s325_now*w_x_now_by
        s214 = R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_31_now*w_x_t_now_by - R_31_now_by*w_x_t_now + s102*w_z_now + s213 + s307_now*w_z_now_by
        s227 = -s151*w_x_now - s328_now*w_x_now_by
        s228 = R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_32_now*w_x_t_now_by - R_32_now_by*w_x_t_now + s109*w_z_now + s227 + s310_now*w_z_now_by
        s241 = -s158*w_x_now - s331_now*w_x_now_by
        s242 = R_13_now*w_z_t_now_by + R_13_now_by*w_z_t_now - R_33_now*w_x_t_now_by - R_33_now_by*w_x_t_now + s116*w_z_now + s241 + s313_now*w_z_now_by
        s256 = -s102*w_y_now - s307_now*w_y_now_by
        s257 = -R_11_now*w_y_t_now_by - R_11_now_by*w_y_t_now + R_21_now*w_x_t_now_by + R_21_now_by*w_x_t_now + s123*w_x_now + s256 + s316_now*w_x_now_by
        s270 = -s109*w_y_now - s310_now*w_y_now_by
        s271 = -R_12_now*w_y_t_now_by - R_12_now_by*w_y_t_now + R_22_now*w_x_t_now_by + R_22_now_by*w_x_t_now + s130*w_x_now + s270 + s319_now*w_x_now_by
        s284 = -s116*w_y_now - s313_now*w_y_now_by
        s285 = -R_13_now*w_y_t_now_by - R_13_now_by*w_y_t_now + R_23_now*w_x_t_now_by + R_23_now_by*w_x_t_now + s137*w_x_now + s284 + s322_now*w_x_now_by
        s288 = 0.001*s171*tx_now + 0.001*s185*ty_now + 0.001*s199*tz_now - 0.001*v_px_t_now_by
        s289 = 0.001*s214*tx_now + 0.001*s228*ty_now + 0.001*s242*tz_now - 0.001*v_py_t_now_by
        s290 = 0.001*s257*tx_now + 0.001*s271*ty_now + 0.001*s285*tz_now - 0.001*v_pz_t_now_by
        s291 = -0.001*v_px_t_now_by
        s292 = -0.001*v_py_t_now_by
        s293 = -0.001*v_pz_t_now_by
        s_by[960 + lane] = s288
        s_by[992 + lane] = s289
        s_by[1024 + lane] = s290
        s_by[1056 + lane] = s291
        s_by[1088 + lane] = s292
        s_by[1120 + lane] = s293


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
        f0x_now = s[960 + lane]
        f0y_now = s[992 + lane]
        f0z_now = s[1024 + lane]
        R_11_now_by = w_by[320 + lane]
        R_12_now_by = w_by[352 + lane]
        R_13_now_by = w_by[384 + lane]
        R_21_now_by = w_by[416 + lane]
        R_22_now_by = w_by[448 + lane]
        R_23_now_by = w_by[480 + lane]
        R_31_now_by = w_by[512 + lane]
        R_32_now_by = w_by[544 + lane]
        R_33_now_by = w_by[576 + lane]
        f0x_now_by = s_by[960 + lane]
        f0y_now_by = s_by[992 + lane]
        f0z_now_by = s_by[1024 + lane]
        f1x_now_by = s_by[1056 + lane]
        f1y_now_by = s_by[1088 + lane]
        f1z_now_by = s_by[1120 + lane]
        s259_now = -f0z_now*ty_now
        s261_now = -f0z_now*tx_now
        s263_now = -f0y_now*ty_now
        s265_now = -f0y_now*tx_now
        s267_now = -f0x_now*ty_now
        s269_now = -f0x_now*tx_now
        s271_now = -f0z_now*tz_now
        s273_now = -f0y_now*tz_now
        s275_now = -f0x_now*tz_now
        s30 = -f0z_now_by*ty_now
        s31 = -f0z_now_by*tx_now
        s32 = -f0y_now_by*ty_now
        s33 = -f0y_now_by*tx_now
        s34 = -f0x_now_by*ty_now
        s35 = -f0x_now_by*tx_now
        s36 = -f0z_now_by*tz_now
        s37 = -f0y_now_by*tz_now
        s38 = -f0x_now_by*tz_now
        s47 = R_23_now*s36 + R_23_now_by*s271_now
        s50 = -R_31_now*s33 - R_31_now_by*s265_now
        s53 = -R_32_now*s32 - R_32_now_by*s263_now
        s56 = -R_33_now*s37 - R_33_now_by*s273_now
        s57 = R_21_now*s31 + R_21_now_by*s261_now + R_22_now*s30 + R_22_now_by*s259_now + s47 + s50 + s53 + s56
        s66 = R_33_now*s38 + R_33_now_by*s275_now
        s69 = -R_11_now*s31 - R_11_now_by*s261_now
        s72 = -R_12_now*s30 - R_12_now_by*s259_now
        s75 = -R_13_now*s36 - R_13_now_by*s271_now
        s76 = R_31_now*s35 + R_31_now_by*s269_now + R_32_now*s34 + R_32_now_by*s267_now + s66 + s69 + s72 + s75
        s85 = R_13_now*s37 + R_13_now_by*s273_now
        s88 = -R_21_now*s35 - R_21_now_by*s269_now
        s91 = -R_22_now*s34 - R_22_now_by*s267_now
        s94 = -R_23_now*s38 - R_23_now_by*s275_now
        s95 = R_11_now*s33 + R_11_now_by*s265_now + R_12_now*s32 + R_12_now_by*s263_now + s85 + s88 + s91 + s94
        s_by[1152 + lane] = f0x_now_by
        s_by[1184 + lane] = f0y_now_by
        s_by[1216 + lane] = f0z_now_by
        s_by[1248 + lane] = s57
        s_by[1280 + lane] = s76
        s_by[1312 + lane] = s95
        s_by[1344 + lane] = f1x_now_by
        s_by[1376 + lane] = f1y_now_by
        s_by[1408 + lane] = f1z_now_by


@straight
def _give_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what the joints give (204 operations)."""
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
        a_0_3_now = d[1088 + lane]
        a_0_4_now = d[1120 + lane]
        a_0_5_now = d[1152 + lane]
        a_0_6_now = d[1184 + lane]
        a_0_7_now = d[1216 + lane]
        a_0_8_now = d[1248 + lane]
        a_1_3_now = d[2368 + lane]
        a_1_4_now = d[2400 + lane]
        a_1_5_now = d[2432 + lane]
        a_1_6_now = d[2464 + lane]
        a_1_7_now = d[2496 + lane]
        a_1_8_now = d[2528 + lane]
        a_2_3_now = d[3648 + lane]
        a_2_4_now = d[3680 + lane]
        a_2_5_now = d[3712 + lane]
        a_2_6_now = d[3744 + lane]
        a_2_7_now = d[3776 + lane]
        a_2_8_now = d[3808 + lane]
        a_p_0_now = s[1152 + lane]
        a_p_1_now = s[1184 + lane]
        a_p_2_now = s[1216 + lane]
        a_p_3_now = s[1248 + lane]
        a_p_4_now = s[1280 + lane]
        a_p_5_now = s[1312 + lane]
        a_p_6_now = s[1344 + lane]
        a_p_7_now = s[1376 + lane]
        a_p_8_now = s[1408 + lane]
        V_0_0_now = s[0 + lane]
        V_0_1_now = s[32 + lane]
        V_0_2_now = s[64 + lane]
        V_1_0_now = s[96 + lane]
        V_1_1_now = s[128 + lane]
        V_1_2_now = s[160 + lane]
        V_2_0_now = s[192 + lane]
        V_2_1_now = s[224 + lane]
        V_2_2_now = s[256 + lane]
        V_3_0_now = s[288 + lane]
        V_3_1_now = s[320 + lane]
        V_3_2_now = s[352 + lane]
        V_4_0_now = s[384 + lane]
        V_4_1_now = s[416 + lane]
        V_4_2_now = s[448 + lane]
        V_5_0_now = s[480 + lane]
        V_5_1_now = s[512 + lane]
        V_5_2_now = s[544 + lane]
        a_0_0_now_by = d_by[992 + lane]
        a_0_1_now_by = d_by[1024 + lane]
        a_0_2_now_by = d_by[1056 + lane]
        a_0_3_now_by = d_by[1088 + lane]
        a_0_4_now_by = d_by[1120 + lane]
        a_0_5_now_by = d_by[1152 + lane]
        a_0_6_now_by = d_by[1184 + lane]
        a_0_7_now_by = d_by[1216 + lane]
        a_0_8_now_by = d_by[1248 + lane]
        a_1_0_now_by = d_by[2272 + lane]
        a_1_1_now_by = d_by[2304 + lane]
        a_1_2_now_by = d_by[2336 + lane]
        a_1_3_now_by = d_by[2368 + lane]
        a_1_4_now_by = d_by[2400 + lane]
        a_1_5_now_by = d_by[2432 + lane]
        a_1_6_now_by = d_by[2464 + lane]
        a_1_7_now_by = d_by[2496 + lane]
        a_1_8_now_by = d_by[2528 + lane]
        a_2_0_now_by = d_by[3552 + lane]
        a_2_1_now_by = d_by[3584 + lane]
        a_2_2_now_by = d_by[3616 + lane]
        a_2_3_now_by = d_by[3648 + lane]
        a_2_4_now_by = d_by[3680 + lane]
        a_2_5_now_by = d_by[3712 + lane]
        a_2_6_now_by = d_by[3744 + lane]
        a_2_7_now_by = d_by[3776 + lane]
        a_2_8_now_by = d_by[3808 + lane]
        a_p_0_now_by = s_by[1152 + lane]
        a_p_1_now_by = s_by[1184 + lane]
        a_p_2_now_by = s_by[1216 + lane]
        a_p_3_now_by = s_by[1248 + lane]
        a_p_4_now_by = s_by[1280 + lane]
        a_p_5_now_by = s_by[1312 + lane]
        a_p_6_now_by = s_by[1344 + lane]
        a_p_7_now_by = s_by[1376 + lane]
        a_p_8_now_by = s_by[1408 + lane]
        V_0_0_now_by = s_by[0 + lane]
        V_0_1_now_by = s_by[32 + lane]
        V_0_2_now_by = s_by[64 + lane]
        V_1_0_now_by = s_by[96 + lane]
        V_1_1_now_by = s_by[128 + lane]
        V_1_2_now_by = s_by[160 + lane]
        V_2_0_now_by = s_by[192 + lane]
        V_2_1_now_by = s_by[224 + lane]
        V_2_2_now_by = s_by[256 + lane]
        V_3_0_now_by = s_by[288 + lane]
        V_3_1_now_by = s_by[320 + lane]
        V_3_2_now_by = s_by[352 + lane]
        V_4_0_now_by = s_by[384 + lane]
        V_4_1_now_by = s_by[416 + lane]
        V_4_2_now_by = s_by[448 + lane]
        V_5_0_now_by = s_by[480 + lane]
        V_5_1_now_by = s_by[512 + lane]
        V_5_2_now_by = s_by[544 + lane]
        W_0_now = a_0_3_now*m_3_now + a_1_3_now*m_7_now + a_2_3_now*m_11_now + a_p_0_now*m_12_now + a_p_6_now*m_13_now
        W_1_now = a_0_4_now*m_3_now + a_1_4_now*m_7_now + a_2_4_now*m_11_now + a_p_1_now*m_12_now + a_p_7_now*m_13_now
        W_2_now = a_0_5_now*m_3_now + a_1_5_now*m_7_now + a_2_5_now*m_11_now + a_p_2_now*m_12_now + a_p_8_now*m_13_now
        W_3_now = a_0_6_now*m_3_now + a_1_6_now*m_7_now + a_2_6_now*m_11_now + a_p_3_now*m_12_now
        W_4_now = a_0_7_now*m_3_now + a_1_7_now*m_7_now + a_2_7_now*m_11_now + a_p_4_now*m_12_now
        W_5_now = a_0_8_now*m_3_now + a_1_8_now*m_7_now + a_2_8_now*m_11_now + a_p_5_now*m_12_now
        s68 = a_0_3_now_by*m_3_now + a_1_3_now_by*m_7_now + a_2_3_now_by*m_11_now + a_p_0_now_by*m_12_now + a_p_6_now_by*m_13_now
        s74 = a_0_4_now_by*m_3_now + a_1_4_now_by*m_7_now + a_2_4_now_by*m_11_now + a_p_1_now_by*m_12_now + a_p_7_now_by*m_13_now
        s80 = a_0_5_now_by*m_3_now + a_1_5_now_by*m_7_now + a_2_5_now_by*m_11_now + a_p_2_now_by*m_12_now + a_p_8_now_by*m_13_now
        s85 = a_0_6_now_by*m_3_now + a_1_6_now_by*m_7_now + a_2_6_now_by*m_11_now + a_p_3_now_by*m_12_now
        s90 = a_0_7_now_by*m_3_now + a_1_7_now_by*m_7_now + a_2_7_now_by*m_11_now + a_p_4_now_by*m_12_now
        s95 = a_0_8_now_by*m_3_now + a_1_8_now_by*m_7_now + a_2_8_now_by*m_11_now + a_p_5_now_by*m_12_now
        s101 = -V_5_0_now*s95 - V_5_0_now_by*W_5_now
        s103 = -a_0_1_now_by*m_2_now
        s104 = -a_0_2_now_by*m_3_now
        s107 = -V_0_0_now*s68 - V_0_0_now_by*W_0_now
        s110 = -V_1_0_now*s74 - V_1_0_now_by*W_1_now
        s113 = -V_2_0_now*s80 - V_2_0_now_by*W_2_now
        s116 = -V_3_0_now*s85 - V_3_0_now_by*W_3_now
        s117 = -V_4_0_now*s90 - V_4_0_now_by*W_4_now - a_0_0_now_by*m_1_now + s101 + s103 + s104 + s107 + s110 + s113 + s116
        s123 = -V_5_1_now*s95 - V_5_1_now_by*W_5_now
        s125 = -a_1_1_now_by*m_6_now
        s126 = -a_1_2_now_by*m_7_now
        s129 = -V_0_1_now*s68 - V_0_1_now_by*W_0_now
        s132 = -V_1_1_now*s74 - V_1_1_now_by*W_1_now
        s135 = -V_2_1_now*s80 - V_2_1_now_by*W_2_now
        s138 = -V_3_1_now*s85 - V_3_1_now_by*W_3_now
        s139 = -V_4_1_now*s90 - V_4_1_now_by*W_4_now - a_1_0_now_by*m_5_now + s123 + s125 + s126 + s129 + s132 + s135 + s138
        s145 = -V_5_2_now*s95 - V_5_2_now_by*W_5_now
        s147 = -a_2_1_now_by*m_10_now
        s148 = -a_2_2_now_by*m_11_now
        s151 = -V_0_2_now*s68 - V_0_2_now_by*W_0_now
        s154 = -V_1_2_now*s74 - V_1_2_now_by*W_1_now
        s157 = -V_2_2_now*s80 - V_2_2_now_by*W_2_now
        s160 = -V_3_2_now*s85 - V_3_2_now_by*W_3_now
        s161 = -V_4_2_now*s90 - V_4_2_now_by*W_4_now - a_2_0_now_by*m_9_now + s145 + s147 + s148 + s151 + s154 + s157 + s160
        s_by[1440 + lane] = s117
        s_by[1472 + lane] = s139
        s_by[1504 + lane] = s161


@straight
def _step_by(moves, w_by, first, last, n):
    """Move the platform by its twists, which a step takes off, the last one again for the rest of `n`."""
    for lane in range(n):
        m = min(first + lane, last)
        w_by[9024 + lane] = -moves[6 * m + 0]
        w_by[9056 + lane] = -moves[6 * m + 1]
        w_by[9088 + lane] = -moves[6 * m + 2]
        w_by[9120 + lane] = -moves[6 * m + 3]
        w_by[9152 + lane] = -moves[6 * m + 4]
        w_by[9184 + lane] = -moves[6 * m + 5]


@straight
def _held(w, size):
    """Begin with nothing that changes."""
    for n in range(size):
        w[n] = 0.0


@straight
def _pay_by(w, s_by, tau, first, last):
    """Write how what the joints give changes."""
    for lane in range(last - first + 1):
        regular = (w[10464 + lane] > 0.0) & (w[10496 + lane] > 0.0)
        tau[3 * (first + lane) + 0] = s_by[1440 + lane] if regular else math.nan
        tau[3 * (first + lane) + 1] = s_by[1472 + lane] if regular else math.nan
        tau[3 * (first + lane) + 2] = s_by[1504 + lane] if regular else math.nan


@fast
def _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau):
    found, moves = tau.reshape(tau.size), x_by.reshape(x_by.size)
    w_by, d_by, s_by = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    _held(w_by, WORK)
    _held(d_by, 3 * OWN)
    _held(s_by, SHARED)
    u_1, e_1 = w_by[0:3008], d_by[0 * OWN:1 * OWN]
    u_2, e_2 = w_by[3008:6016], d_by[1 * OWN:2 * OWN]
    u_3, e_3 = w_by[6016:9024], d_by[2 * OWN:3 * OWN]
    w, d, s = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    w_1 = w[0:3008]
    w_2 = w[3008:6016]
    w_3 = w[6016:9024]
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

    x_by (E, N, 6) are its platform's twists along them, shift and turn about the axes of {O}; k_by and c_by are
    what `constants_by` makes of them.
    """
    _torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, inertia, tau)
