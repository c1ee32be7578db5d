"""Dynamics of `delta`, many samples at once: Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both b66887495bd637fe; SymPy 1.14.0.

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
