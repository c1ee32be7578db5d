"""Dynamics of `complete_delta`, many samples at once: Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 24a5275d985d8e50; SymPy 1.14.0.

Arrays are C-contiguous float64, the sample first; mm, rad, s, kg, N:

x (N, 6)  platform: px py pz cx cy cz
motion (3, N, 3)  joints, their velocities, their accelerations      tool (N or 1, 3)  reference point in {O'}
k (M, 3, ...)  what `constants` of ``kinematics.py`` makes of p; each of the M machines has N / M of the samples
c (M, 3, 25)  what `constants` makes of p (M, 3, 25)
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
        b = p[25 * lane + 0]
        a = p[25 * lane + 1]
        L = p[25 * lane + 2]
        c = p[25 * lane + 4]
        phi = p[25 * lane + 5]
        bx1 = p[25 * lane + 6]
        by1 = p[25 * lane + 7]
        bz1 = p[25 * lane + 8]
        ax1 = p[25 * lane + 9]
        ay1 = p[25 * lane + 10]
        az1 = p[25 * lane + 11]
        bx2 = p[25 * lane + 13]
        by2 = p[25 * lane + 14]
        bz2 = p[25 * lane + 15]
        ax2 = p[25 * lane + 16]
        ay2 = p[25 * lane + 17]
        az2 = p[25 * lane + 18]
        betax = p[25 * lane + 20]
        betay = p[25 * lane + 21]
        betaz = p[25 * lane + 22]
        tip_v = p[25 * lane + 23]
        tip_w = p[25 * lane + 24]
        s0 = (betay * betay)
        s1 = (betax * betax)
        s2 = (betaz * betaz)
        s3 = s0 + s1 + s2
        s10 = s3*(s3*(1.5619206968586225e-16*s0 + 1.5619206968586225e-16*s1 + 1.5619206968586225e-16*s2 - 4.779477332387385e-14) + 1.1470745597729725e-11)
        s18 = s3*(s3*(s3*(s3*(s10 - 2.08767569878681e-09) + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889)
        s21 = s3*(s18 - 0.041666666666666664) + 0.5
        s22 = -s0*s21
        s23 = -s2*s21
        s24 = s22 + s23 + 1
        s25 = sine(phi)
        s33 = s3*(s3*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 + 2.8114572543455206e-15*s2 - 7.647163731819816e-13) + 1.6059043836821613e-10)
        s41 = s3*(s3*(s3*(s3*(s33 - 2.505210838544172e-08) + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333)
        s44 = s3*(s41 - 0.16666666666666666) + 1
        s45 = -betaz*s44
        s46 = betax*betay*s21
        s47 = s45 + s46
        s48 = cosine(phi)
        R0_11 = s24*s25 - s47*s48
        R0_12 = s24*s48 + s25*s47
        s54 = betay*s44
        s55 = betax*betaz*s21
        R0_13 = s54 + s55
        s57 = -s45 + s46
        s59 = -s1*s21
        s60 = s23 + s59 + 1
        R0_21 = s25*s57 - s48*s60
        R0_22 = s25*s60 + s48*s57
        s66 = -betax*s44
        s67 = betay*betaz*s21
        R0_23 = s66 + s67
        s69 = -s54 + s55
        s71 = -s66 + s67
        R0_31 = s25*s69 - s48*s71
        R0_32 = s25*s71 + s48*s69
        R0_33 = s22 + s59 + 1
        s98 = 0.5*c
        g1_x = ax1 + s98 + tip_w
        g1_y = L + ay1
        g1_z = az1 + tip_v
        s102 = a*s48
        s103 = 0.5*c*s25
        h1_x = bx1 + s102 + s103
        s105 = a*s25
        s106 = -0.5*c*s48
        h1_y = by1 + s105 + s106
        s111 = b*s48
        s112 = R0_11*g1_x + s111
        s117 = b*s25
        s118 = R0_21*g1_x + s117
        s120 = R0_31*g1_x
        g2_x = ax2 - s98 + tip_w
        g2_y = L + ay2
        g2_z = az2 + tip_v
        h2_x = bx2 + s102 - s103
        h2_y = by2 + s105 - s106
        s150 = R0_11*g2_x + s111
        s155 = R0_21*g2_x + s117
        s157 = R0_31*g2_x
        s484 = 0.5/L
        s541 = 0.5/(L * L)
        k[25 * lane + 0] = R0_12
        k[25 * lane + 1] = R0_13
        k[25 * lane + 2] = R0_22
        k[25 * lane + 3] = R0_23
        k[25 * lane + 4] = R0_32
        k[25 * lane + 5] = R0_33
        k[25 * lane + 6] = g1_y
        k[25 * lane + 7] = g1_z
        k[25 * lane + 8] = s112
        k[25 * lane + 9] = s118
        k[25 * lane + 10] = s120
        k[25 * lane + 11] = h1_x
        k[25 * lane + 12] = h1_y
        k[25 * lane + 13] = bz1
        k[25 * lane + 14] = g2_y
        k[25 * lane + 15] = g2_z
        k[25 * lane + 16] = s150
        k[25 * lane + 17] = s155
        k[25 * lane + 18] = s157
        k[25 * lane + 19] = h2_x
        k[25 * lane + 20] = h2_y
        k[25 * lane + 21] = bz2
        k[25 * lane + 22] = L
        k[25 * lane + 23] = s484
        k[25 * lane + 24] = s541


@fast
def _constants(p, k):
    _fill(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return c (M, 3, 25), what no pose changes of bodies in motion, from p (150 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    c = np.empty((len(p), 3, 25))
    _constants(p, c)
    return c


@straight
def _move(w, d, s, n):
    """How the platform moves with each joint, and how it does (84 operations)."""
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
        Q_3 = w[1088 + lane]
        q_t_1 = d[1280 + lane]
        Q_1 = w[4160 + lane]
        Q_4 = w[4416 + lane]
        q_t_2 = d[2560 + lane]
        Q_2 = w[7488 + lane]
        Q_5 = w[7744 + lane]
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
    """Second derivatives of a limb's equations by time where nothing accelerates (348 operations)."""
    R0_12 = k[0]
    R0_13 = k[1]
    R0_22 = k[2]
    R0_23 = k[3]
    R0_32 = k[4]
    R0_33 = k[5]
    g1_y = k[6]
    g1_z = k[7]
    s112 = k[8]
    s118 = k[9]
    s120 = k[10]
    h1_x = k[11]
    h1_y = k[12]
    bz1 = k[13]
    g2_y = k[14]
    g2_z = k[15]
    s150 = k[16]
    s155 = k[17]
    s157 = k[18]
    h2_x = k[19]
    h2_y = k[20]
    bz2 = k[21]
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
        s78 = cosine(q)
        s80 = sine(q)
        R1_12 = R0_12*s78 + R0_13*s80
        R1_13 = -R0_12*s80 + R0_13*s78
        R1_22 = R0_22*s78 + R0_23*s80
        R1_23 = -R0_22*s80 + R0_23*s78
        R1_32 = R0_32*s78 + R0_33*s80
        R1_33 = -R0_32*s80 + R0_33*s78
        A1_x = R1_12*g1_y + R1_13*g1_z + s112
        A1_y = R1_22*g1_y + R1_23*g1_z + s118
        A1_z = R1_32*g1_y + R1_33*g1_z + s120
        s124 = h1_x - tx
        s126 = h1_y - ty
        s128 = bz1 - tz
        B1_x = R_11*s124 + R_12*s126 + R_13*s128 + px
        B1_y = R_21*s124 + R_22*s126 + R_23*s128 + py
        B1_z = R_31*s124 + R_32*s126 + R_33*s128 + pz
        d1_x = -A1_x + B1_x
        d1_y = -A1_y + B1_y
        d1_z = -A1_z + B1_z
        A2_x = R1_12*g2_y + R1_13*g2_z + s150
        A2_y = R1_22*g2_y + R1_23*g2_z + s155
        A2_z = R1_32*g2_y + R1_33*g2_z + s157
        s161 = h2_x - tx
        s163 = h2_y - ty
        s165 = bz2 - tz
        B2_x = R_11*s161 + R_12*s163 + R_13*s165 + px
        B2_y = R_21*s161 + R_22*s163 + R_23*s165 + py
        B2_z = R_31*s161 + R_32*s163 + R_33*s165 + pz
        d2_x = -A2_x + B2_x
        d2_y = -A2_y + B2_y
        d2_z = -A2_z + B2_z
        s205 = -R_21*w_z + R_31*w_y
        s208 = -R_22*w_z + R_32*w_y
        s211 = -R_23*w_z + R_33*w_y
        s214 = R_11*w_z - R_31*w_x
        s217 = R_12*w_z - R_32*w_x
        s220 = R_13*w_z - R_33*w_x
        s223 = -R_11*w_y + R_21*w_x
        s226 = -R_12*w_y + R_22*w_x
        s229 = -R_13*w_y + R_23*w_x
        s230 = -q_t*s80
        s232 = q_t*s78
        s234 = R0_12*s230 + R0_13*s232
        s237 = -R0_12*s232 + R0_13*s230
        s240 = R0_22*s230 + R0_23*s232
        s243 = -R0_22*s232 + R0_23*s230
        s246 = R0_32*s230 + R0_33*s232
        s249 = -R0_32*s232 + R0_33*s230
        s271 = -g1_y*s234 - g1_z*s237 + s124*s205 + s126*s208 + s128*s211 + v_px
        s272 = -g1_y*s240 - g1_z*s243 + s124*s214 + s126*s217 + s128*s220 + v_py
        s273 = -g1_y*s246 - g1_z*s249 + s124*s223 + s126*s226 + s128*s229 + v_pz
        s295 = -g2_y*s234 - g2_z*s237 + s161*s205 + s163*s208 + s165*s211 + v_px
        s296 = -g2_y*s240 - g2_z*s243 + s161*s214 + s163*s217 + s165*s220 + v_py
        s297 = -g2_y*s246 - g2_z*s249 + s161*s223 + s163*s226 + s165*s229 + v_pz
        s320 = -s214*w_z + s223*w_y
        s323 = -s217*w_z + s226*w_y
        s326 = -s220*w_z + s229*w_y
        s329 = s205*w_z - s223*w_x
        s332 = s208*w_z - s226*w_x
        s335 = s211*w_z - s229*w_x
        s338 = -s205*w_y + s214*w_x
        s341 = -s208*w_y + s217*w_x
        s344 = -s211*w_y + s220*w_x
        s345 = -q_t*s232
        s347 = q_t*s230
        s349 = R0_12*s345 + R0_13*s347
        s352 = -R0_12*s347 + R0_13*s345
        s355 = R0_22*s345 + R0_23*s347
        s358 = -R0_22*s347 + R0_23*s345
        s361 = R0_32*s345 + R0_33*s347
        s364 = -R0_32*s347 + R0_33*s345
        s415 = 2*(s271 * s271)
        s416 = 2*d1_x*(-g1_y*s349 - g1_z*s352 + s124*s320 + s126*s323 + s128*s326) + s415
        s417 = 0.25*s416
        s420 = 2*(s272 * s272)
        s421 = 2*d1_y*(-g1_y*s355 - g1_z*s358 + s124*s329 + s126*s332 + s128*s335) + s420
        s422 = 0.25*s421
        s425 = 2*(s273 * s273)
        s426 = 2*d1_z*(-g1_y*s361 - g1_z*s364 + s124*s338 + s126*s341 + s128*s344) + s425
        s427 = 0.25*s426
        s430 = 2*(s295 * s295)
        s431 = 2*d2_x*(-g2_y*s349 - g2_z*s352 + s161*s320 + s163*s323 + s165*s326) + s430
        s432 = 0.25*s431
        s435 = 2*(s296 * s296)
        s436 = 2*d2_y*(-g2_y*s355 - g2_z*s358 + s161*s329 + s163*s332 + s165*s335) + s435
        s437 = 0.25*s436
        s440 = 2*(s297 * s297)
        s441 = 2*d2_z*(-g2_y*s361 - g2_z*s364 + s161*s338 + s163*s341 + s165*s344) + s440
        s442 = 0.25*s441
        s443 = s417 + s422 + s427 + s432 + s437 + s442
        s444 = s417 + s422 + s427 - s432 - s437 - s442
        d[64 + lane] = s443
        d[96 + lane] = s444


@straight
def _accelerate(w, d, s, n):
    """The platform's acceleration (102 operations)."""
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
    """Gravity less acceleration of the points of a limb (242 operations)."""
    gx = gravity[0]
    gy = gravity[1]
    gz = gravity[2]
    R0_12 = k[0]
    R0_13 = k[1]
    R0_22 = k[2]
    R0_23 = k[3]
    R0_32 = k[4]
    R0_33 = k[5]
    g1_y = k[6]
    g1_z = k[7]
    h1_x = k[11]
    h1_y = k[12]
    bz1 = k[13]
    g2_y = k[14]
    g2_z = k[15]
    h2_x = k[19]
    h2_y = k[20]
    bz2 = k[21]
    L = k[22]
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
        s78 = cosine(q)
        s80 = sine(q)
        s124 = h1_x - tx
        s126 = h1_y - ty
        s128 = bz1 - tz
        s161 = h2_x - tx
        s163 = h2_y - ty
        s165 = bz2 - tz
        s205 = -R_21*w_z + R_31*w_y
        s208 = -R_22*w_z + R_32*w_y
        s211 = -R_23*w_z + R_33*w_y
        s214 = R_11*w_z - R_31*w_x
        s217 = R_12*w_z - R_32*w_x
        s220 = R_13*w_z - R_33*w_x
        s223 = -R_11*w_y + R_21*w_x
        s226 = -R_12*w_y + R_22*w_x
        s229 = -R_13*w_y + R_23*w_x
        s1200 = -R_21*w_z_t + R_31*w_y_t - s214*w_z + s223*w_y
        s1205 = -R_22*w_z_t + R_32*w_y_t - s217*w_z + s226*w_y
        s1210 = -R_23*w_z_t + R_33*w_y_t - s220*w_z + s229*w_y
        s1215 = R_11*w_z_t - R_31*w_x_t + s205*w_z - s223*w_x
        s1220 = R_12*w_z_t - R_32*w_x_t + s208*w_z - s226*w_x
        s1225 = R_13*w_z_t - R_33*w_x_t + s211*w_z - s229*w_x
        s1230 = -R_11*w_y_t + R_21*w_x_t - s205*w_y + s214*w_x
        s1235 = -R_12*w_y_t + R_22*w_x_t - s208*w_y + s217*w_x
        s1240 = -R_13*w_y_t + R_23*w_x_t - s211*w_y + s220*w_x
        s1242 = -(q_t * q_t)*s78 - q_tt*s80
        s1245 = -(q_t * q_t)*s80 + q_tt*s78
        s1247 = R0_12*s1242 + R0_13*s1245
        s1250 = -R0_12*s1245 + R0_13*s1242
        s1253 = R0_22*s1242 + R0_23*s1245
        s1256 = -R0_22*s1245 + R0_23*s1242
        s1259 = R0_32*s1242 + R0_33*s1245
        s1262 = -R0_32*s1245 + R0_33*s1242
        s1265 = g1_y*s1247 + g1_z*s1250
        s1268 = g1_y*s1253 + g1_z*s1256
        s1271 = g1_y*s1259 + g1_z*s1262
        s1275 = s1200*s124 + s1205*s126 + s1210*s128 + v_px_t
        s1279 = s1215*s124 + s1220*s126 + s1225*s128 + v_py_t
        s1283 = s1230*s124 + s1235*s126 + s1240*s128 + v_pz_t
        s1289 = g2_y*s1247 + g2_z*s1250
        s1292 = g2_y*s1253 + g2_z*s1256
        s1295 = g2_y*s1259 + g2_z*s1262
        s1299 = s1200*s161 + s1205*s163 + s1210*s165 + v_px_t
        s1303 = s1215*s161 + s1220*s163 + s1225*s165 + v_py_t
        s1307 = s1230*s161 + s1235*s163 + s1240*s165 + v_pz_t
        s2010 = -0.001*L*s1247
        s2011 = gx + s2010
        s2012 = -0.001*L*s1253
        s2013 = gy + s2012
        s2014 = -0.001*L*s1259
        s2015 = gz + s2014
        s2016 = gx - s2010
        s2017 = gy - s2012
        s2018 = gz - s2014
        s2020 = gx - 0.001*s1265
        s2022 = gy - 0.001*s1268
        s2024 = gz - 0.001*s1271
        s2026 = gx - 0.0005*s1265 - 0.0005*s1275
        s2028 = gy - 0.0005*s1268 - 0.0005*s1279
        s2030 = gz - 0.0005*s1271 - 0.0005*s1283
        s2032 = gx - 0.001*s1275
        s2034 = gy - 0.001*s1279
        s2036 = gz - 0.001*s1283
        s2038 = gx - 0.001*s1289
        s2040 = gy - 0.001*s1292
        s2042 = gz - 0.001*s1295
        s2044 = gx - 0.0005*s1289 - 0.0005*s1299
        s2046 = gy - 0.0005*s1292 - 0.0005*s1303
        s2048 = gz - 0.0005*s1295 - 0.0005*s1307
        s2050 = gx - 0.001*s1299
        s2052 = gy - 0.001*s1303
        s2054 = gz - 0.001*s1307
        d[224 + lane] = s2011
        d[256 + lane] = s2013
        d[288 + lane] = s2015
        d[320 + lane] = s2016
        d[352 + lane] = s2017
        d[384 + lane] = s2018
        d[416 + lane] = s2020
        d[448 + lane] = s2022
        d[480 + lane] = s2024
        d[512 + lane] = s2026
        d[544 + lane] = s2028
        d[576 + lane] = s2030
        d[608 + lane] = s2032
        d[640 + lane] = s2034
        d[672 + lane] = s2036
        d[704 + lane] = s2038
        d[736 + lane] = s2040
        d[768 + lane] = s2042
        d[800 + lane] = s2044
        d[832 + lane] = s2046
        d[864 + lane] = s2048
        d[896 + lane] = s2050
        d[928 + lane] = s2052
        d[960 + lane] = s2054


@straight
def _limb_asks(w, d, s, k, gravity, shares, n):
    """Loads per inertial parameter of a limb, along joint, shifts and turns (205 operations)."""
    share = shares[0]
    R0_12 = k[0]
    R0_13 = k[1]
    R0_22 = k[2]
    R0_23 = k[3]
    R0_32 = k[4]
    R0_33 = k[5]
    g1_y = k[6]
    g1_z = k[7]
    h1_x = k[11]
    h1_y = k[12]
    bz1 = k[13]
    g2_y = k[14]
    g2_z = k[15]
    h2_x = k[19]
    h2_y = k[20]
    bz2 = k[21]
    L = k[22]
    s484 = k[23]
    s541 = k[24]
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
        s78 = cosine(q)
        s80 = sine(q)
        s124 = h1_x - tx
        s126 = h1_y - ty
        s128 = bz1 - tz
        s161 = h2_x - tx
        s163 = h2_y - ty
        s165 = bz2 - tz
        s495 = -L*f2z
        s505 = L*f1z
        s512 = L*(f1y*s484 + f2y*s484)
        s517 = L*(f1x*s484 + f2x*s484)
        s518 = -s484*s495 + s484*s505
        s534 = -s80*(R0_12*s517 + R0_22*s512 + R0_32*s518)
        s539 = s534 + s78*(R0_13*s517 + R0_23*s512 + R0_33*s518)
        s558 = L*(f1y*s541 - f2y*s541)
        s563 = L*(f1x*s541 - f2x*s541)
        s564 = s495*s541 + s505*s541
        s580 = -s80*(R0_12*s563 + R0_22*s558 + R0_32*s564)
        s585 = s580 + s78*(R0_13*s563 + R0_23*s558 + R0_33*s564)
        s607 = 1 - 2*share
        s639 = 0.5*f7z*s607
        s642 = 0.5*f7y*s607
        s645 = 0.5*f7x*s607
        s648 = 0.5*f4z*s607
        s651 = 0.5*f4y*s607
        s654 = 0.5*f4x*s607
        s681 = f8z*share + s639
        s688 = f8y*share + s642
        s695 = f8x*share + s645
        s705 = f6z*share + s639
        s710 = f6y*share + s642
        s715 = f6x*share + s645
        s720 = f5z*share + s648
        s727 = f5y*share + s651
        s734 = f5x*share + s654
        s744 = f3z*share + s648
        s749 = f3y*share + s651
        s754 = f3x*share + s654
        s759 = g1_z*s744 + g2_z*s705
        s764 = g1_y*s744 + g2_y*s705
        s769 = g1_z*s749 + g2_z*s710
        s774 = g1_y*s749 + g2_y*s710
        s779 = g1_z*s754 + g2_z*s715
        s784 = g1_y*s754 + g2_y*s715
        s788 = s78*(-R0_12*s779 + R0_13*s784 - R0_22*s769 + R0_23*s774 - R0_32*s759 + R0_33*s764)
        s791 = R0_12*s784 + R0_13*s779 + R0_22*s774 + R0_23*s769 + R0_32*s764 + R0_33*s759
        s794 = s681 + s720
        s795 = s128*s720 + s165*s681
        s796 = s126*s720 + s163*s681
        s797 = s124*s720 + s161*s681
        s798 = s688 + s727
        s799 = s128*s727 + s165*s688
        s800 = s126*s727 + s163*s688
        s801 = s124*s727 + s161*s688
        s802 = s695 + s734
        s803 = s128*s734 + s165*s695
        s805 = s126*s734 + s163*s695
        s807 = s124*s734 + s161*s695
        s819 = s788 - s791*s80
        s826 = R_21*s797 + R_22*s796 + R_23*s795 - R_31*s801 - R_32*s800 - R_33*s799
        s833 = -R_11*s797 - R_12*s796 - R_13*s795 + R_31*s807 + R_32*s805 + R_33*s803
        s840 = R_11*s801 + R_12*s800 + R_13*s799 - R_21*s807 - R_22*s805 - R_23*s803
        d[992 + lane] = s539
        d[1024 + lane] = s585
        d[1056 + lane] = s819
        d[1088 + lane] = s802
        d[1120 + lane] = s798
        d[1152 + lane] = s794
        d[1184 + lane] = s826
        d[1216 + lane] = s833
        d[1248 + lane] = s840


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
        s243 = -R_21*w_z + R_31*w_y
        s246 = -R_22*w_z + R_32*w_y
        s249 = -R_23*w_z + R_33*w_y
        s252 = R_11*w_z - R_31*w_x
        s255 = R_12*w_z - R_32*w_x
        s258 = R_13*w_z - R_33*w_x
        s261 = -R_11*w_y + R_21*w_x
        s264 = -R_12*w_y + R_22*w_x
        s267 = -R_13*w_y + R_23*w_x
        s534 = -ty*(-R_22*w_z_t + R_32*w_y_t - s255*w_z + s264*w_y)
        s535 = -tz*(-R_23*w_z_t + R_33*w_y_t - s258*w_z + s267*w_y)
        s536 = s534 + s535 - tx*(-R_21*w_z_t + R_31*w_y_t - s252*w_z + s261*w_y) + v_px_t
        s539 = -ty*(R_12*w_z_t - R_32*w_x_t + s246*w_z - s264*w_x)
        s540 = -tz*(R_13*w_z_t - R_33*w_x_t + s249*w_z - s267*w_x)
        s541 = s539 + s540 - tx*(R_11*w_z_t - R_31*w_x_t + s243*w_z - s261*w_x) + v_py_t
        s544 = -ty*(-R_12*w_y_t + R_22*w_x_t - s246*w_y + s255*w_x)
        s545 = -tz*(-R_13*w_y_t + R_23*w_x_t - s249*w_y + s258*w_x)
        s546 = s544 + s545 - tx*(-R_11*w_y_t + R_21*w_x_t - s243*w_y + s252*w_x) + v_pz_t
        s650 = gx - 0.001*s536
        s652 = gy - 0.001*s541
        s654 = gz - 0.001*s546
        s656 = gx - 0.001*v_px_t
        s658 = gy - 0.001*v_py_t
        s660 = gz - 0.001*v_pz_t
        s[960 + lane] = s650
        s[992 + lane] = s652
        s[1024 + lane] = s654
        s[1056 + lane] = s656
        s[1088 + lane] = s658
        s[1120 + lane] = s660


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
        s195 = -f0z*tz
        s197 = -f0z*ty
        s199 = -f0z*tx
        s201 = -f0y*tz
        s203 = -f0y*ty
        s205 = -f0y*tx
        s207 = -f0x*tz
        s209 = -f0x*ty
        s211 = -f0x*tx
        s222 = R_21*s199 + R_22*s197 + R_23*s195 - R_31*s205 - R_32*s203 - R_33*s201
        s229 = -R_11*s199 - R_12*s197 - R_13*s195 + R_31*s211 + R_32*s209 + R_33*s207
        s236 = R_11*s205 + R_12*s203 + R_13*s201 - R_21*s211 - R_22*s209 - R_23*s207
        s[1152 + lane] = f0x
        s[1184 + lane] = f0y
        s[1216 + lane] = f0z
        s[1248 + lane] = s222
        s[1280 + lane] = s229
        s[1312 + lane] = s236
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
        regular = (w[11424 + lane] > 0.0) & (w[11456 + lane] > 0.0)
        tau[3 * (first + lane) + 0] = s[1440 + lane] if regular else math.nan
        tau[3 * (first + lane) + 1] = s[1472 + lane] if regular else math.nan
        tau[3 * (first + lane) + 2] = s[1504 + lane] if regular else math.nan


@straight
def _pay_each(w, s, Y, first, last):
    """Write what the joints give for each inertial parameter."""
    for lane in range(last - first + 1):
        regular = (w[11424 + lane] > 0.0) & (w[11456 + lane] > 0.0)
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
    w_1 = w[0:3328]
    w_2 = w[3328:6656]
    w_3 = w[6656:9984]
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
    w_1 = w[0:3328]
    w_2 = w[3328:6656]
    w_3 = w[6656:9984]
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
        b_now = p[25 * lane + 0]
        a_now = p[25 * lane + 1]
        L_now = p[25 * lane + 2]
        c_now = p[25 * lane + 4]
        phi_now = p[25 * lane + 5]
        ax1_now = p[25 * lane + 9]
        ax2_now = p[25 * lane + 16]
        betax_now = p[25 * lane + 20]
        betay_now = p[25 * lane + 21]
        betaz_now = p[25 * lane + 22]
        tip_w_now = p[25 * lane + 24]
        b_now_by = p_by[25 * lane + 0]
        a_now_by = p_by[25 * lane + 1]
        L_now_by = p_by[25 * lane + 2]
        c_now_by = p_by[25 * lane + 4]
        phi_now_by = p_by[25 * lane + 5]
        bx1_now_by = p_by[25 * lane + 6]
        by1_now_by = p_by[25 * lane + 7]
        bz1_now_by = p_by[25 * lane + 8]
        ax1_now_by = p_by[25 * lane + 9]
        ay1_now_by = p_by[25 * lane + 10]
        az1_now_by = p_by[25 * lane + 11]
        bx2_now_by = p_by[25 * lane + 13]
        by2_now_by = p_by[25 * lane + 14]
        bz2_now_by = p_by[25 * lane + 15]
        ax2_now_by = p_by[25 * lane + 16]
        ay2_now_by = p_by[25 * lane + 17]
        az2_now_by = p_by[25 * lane + 18]
        betax_now_by = p_by[25 * lane + 20]
        betay_now_by = p_by[25 * lane + 21]
        betaz_now_by = p_by[25 * lane + 22]
        tip_v_now_by = p_by[25 * lane + 23]
        tip_w_now_by = p_by[25 * lane + 24]
        s0_now = (betay_now * betay_now)
        s1_now = (betax_now * betax_now)
        s2_now = (betaz_now * betaz_now)
        s3_now = s0_now + s1_now + s2_now
        s7 = 1.5619206968586225e-16*s0_now + 1.5619206968586225e-16*s1_now + 1.5619206968586225e-16*s2_now - 4.779477332387385e-14
        s9 = s3_now*s7 + 1.1470745597729725e-11
        s10_now = s3_now*s9
        s11 = s10_now - 2.08767569878681e-09
        s13 = s11*s3_now + 2.755731922398589e-07
        s15 = s13*s3_now - 2.48015873015873e-05
        s17 = s15*s3_now + 0.001388888888888889
        s18_now = s17*s3_now
        s19 = s18_now - 0.041666666666666664
        s21_now = s19*s3_now + 0.5
        s22_now = -s0_now*s21_now
        s23_now = -s21_now*s2_now
        s24_now = s22_now + s23_now + 1
        s25_now = sine(phi_now)
        s29 = 2.8114572543455206e-15*s0_now + 2.8114572543455206e-15*s1_now + 2.8114572543455206e-15*s2_now - 7.647163731819816e-13
        s31 = s29*s3_now + 1.6059043836821613e-10
        s33_now = s31*s3_now
        s33 = s33_now - 2.505210838544172e-08
        s35 = s33*s3_now + 2.7557319223985893e-06
        s37 = s35*s3_now - 0.0001984126984126984
        s39 = s37*s3_now + 0.008333333333333333
        s41_now = s39*s3_now
        s41 = s41_now - 0.16666666666666666
        s44_now = s3_now*s41 + 1
        s45_now = -betaz_now*s44_now
        s46_now = betax_now*betay_now*s21_now
        s47_now = s45_now + s46_now
        s48_now = cosine(phi_now)
        R0_11_now = s24_now*s25_now - s47_now*s48_now
        s54_now = betay_now*s44_now
        s55_now = betax_now*betaz_now*s21_now
        s57_now = -s45_now + s46_now
        s59_now = -s1_now*s21_now
        s60_now = s23_now + s59_now + 1
        R0_21_now = s25_now*s57_now - s48_now*s60_now
        s66_now = -betax_now*s44_now
        s67_now = betay_now*betaz_now*s21_now
        s69_now = -s54_now + s55_now
        s71_now = -s66_now + s67_now
        R0_31_now = s25_now*s69_now - s48_now*s71_now
        s98_now = 0.5*c_now
        g1_x_now = ax1_now + s98_now + tip_w_now
        g2_x_now = ax2_now - s98_now + tip_w_now
        s110 = 2*betay_now*betay_now_by
        s112 = 2*betax_now*betax_now_by
        s114 = 2*betaz_now*betaz_now_by
        s115 = s110 + s112 + s114
        s126 = s3_now*(s115*s9 + s3_now*(s115*s7 + s3_now*(1.5619206968586225e-16*s110 + 1.5619206968586225e-16*s112 + 1.5619206968586225e-16*s114)))
        s138 = s3_now*(s115*s17 + s3_now*(s115*s15 + s3_now*(s115*s13 + s3_now*(s11*s115 + s126))))
        s140 = s115*s19 + s138
        s143 = -s0_now*s140 - s110*s21_now
        s146 = -s114*s21_now - s140*s2_now
        s147 = s143 + s146
        s148 = phi_now_by*s48_now
        s159 = s3_now*(s115*s31 + s3_now*(s115*s29 + s3_now*(2.8114572543455206e-15*s110 + 2.8114572543455206e-15*s112 + 2.8114572543455206e-15*s114)))
        s172 = s3_now*(s115*s39 + s3_now*(s115*s37 + s3_now*(s115*s35 + s3_now*(s115*s33 + s159))))
        s173 = s115*s41 + s172
        s176 = -betaz_now*s173 - betaz_now_by*s44_now
        s177 = betay_now*s21_now
        s178 = betax_now*s21_now
        s183 = betax_now*betay_now*s140 + betax_now_by*s177 + betay_now_by*s178
        s184 = s176 + s183
        s185 = -phi_now_by*s25_now
        s192 = s147*s25_now + s148*s24_now - s184*s48_now - s185*s47_now
        s199 = s147*s48_now + s148*s47_now + s184*s25_now + s185*s24_now
        s202 = betay_now*s173 + betay_now_by*s44_now
        s203 = betaz_now*s21_now
        s208 = betax_now*betaz_now*s140 + betax_now_by*s203 + betaz_now_by*s178
        s209 = s202 + s208
        s210 = -s176 + s183
        s213 = -s112*s21_now - s140*s1_now
        s214 = s146 + s213
        s221 = s148*s57_now - s185*s60_now + s210*s25_now - s214*s48_now
        s228 = s148*s60_now + s185*s57_now + s210*s48_now + s214*s25_now
        s231 = -betax_now*s173 - betax_now_by*s44_now
        s236 = betay_now*betaz_now*s140 + betay_now_by*s203 + betaz_now_by*s177
        s237 = s231 + s236
        s238 = -s202 + s208
        s239 = -s231 + s236
        s246 = s148*s69_now - s185*s71_now + s238*s25_now - s239*s48_now
        s253 = s148*s71_now + s185*s69_now + s238*s48_now + s239*s25_now
        s254 = s143 + s213
        s255 = 0.5*c_now_by
        s256 = ax1_now_by + s255 + tip_w_now_by
        s257 = L_now_by + ay1_now_by
        s258 = az1_now_by + tip_v_now_by
        s261 = a_now*s185 + a_now_by*s48_now
        s265 = 0.5*c_now_by*s25_now + s148*s98_now
        s266 = bx1_now_by + s261 + s265
        s269 = a_now*s148 + a_now_by*s25_now
        s273 = -0.5*c_now_by*s48_now - s185*s98_now
        s274 = by1_now_by + s269 + s273
        s277 = b_now*s185 + b_now_by*s48_now
        s281 = R0_11_now*s256 + g1_x_now*s192 + s277
        s284 = b_now*s148 + b_now_by*s25_now
        s288 = R0_21_now*s256 + g1_x_now*s221 + s284
        s291 = R0_31_now*s256 + g1_x_now*s246
        s292 = ax2_now_by - s255 + tip_w_now_by
        s293 = L_now_by + ay2_now_by
        s294 = az2_now_by + tip_v_now_by
        s295 = bx2_now_by + s261 - s265
        s296 = by2_now_by + s269 - s273
        s300 = R0_11_now*s292 + g2_x_now*s192 + s277
        s304 = R0_21_now*s292 + g2_x_now*s221 + s284
        s307 = R0_31_now*s292 + g2_x_now*s246
        s309 = -0.5*L_now_by/(L_now * L_now)
        s313 = -L_now_by/(L_now * L_now * L_now)
        k[25 * lane + 0] = s199
        k[25 * lane + 1] = s209
        k[25 * lane + 2] = s228
        k[25 * lane + 3] = s237
        k[25 * lane + 4] = s253
        k[25 * lane + 5] = s254
        k[25 * lane + 6] = s257
        k[25 * lane + 7] = s258
        k[25 * lane + 8] = s281
        k[25 * lane + 9] = s288
        k[25 * lane + 10] = s291
        k[25 * lane + 11] = s266
        k[25 * lane + 12] = s274
        k[25 * lane + 13] = bz1_now_by
        k[25 * lane + 14] = s293
        k[25 * lane + 15] = s294
        k[25 * lane + 16] = s300
        k[25 * lane + 17] = s304
        k[25 * lane + 18] = s307
        k[25 * lane + 19] = s295
        k[25 * lane + 20] = s296
        k[25 * lane + 21] = bz2_now_by
        k[25 * lane + 22] = L_now_by
        k[25 * lane + 23] = s309
        k[25 * lane + 24] = s313


@straight
def _fill_machine_by(p, p_by, k, rows):
    for lane in range(rows):
        b_now = p[25 * lane + 0]
        a_now = p[25 * lane + 1]
        L_now = p[25 * lane + 2]
        l_now = p[25 * lane + 3]
        c_now = p[25 * lane + 4]
        phi_now = p[25 * lane + 5]
        ax1_now = p[25 * lane + 9]
        dl1_now = p[25 * lane + 12]
        ax2_now = p[25 * lane + 16]
        dl2_now = p[25 * lane + 19]
        betax_now = p[25 * lane + 20]
        betay_now = p[25 * lane + 21]
        betaz_now = p[25 * lane + 22]
        tip_w_now = p[25 * lane + 24]
        b_now_by = p_by[25 * lane + 0]
        a_now_by = p_by[25 * lane + 1]
        L_now_by = p_by[25 * lane + 2]
        l_now_by = p_by[25 * lane + 3]
        c_now_by = p_by[25 * lane + 4]
        phi_now_by = p_by[25 * lane + 5]
        bx1_now_by = p_by[25 * lane + 6]
        by1_now_by = p_by[25 * lane + 7]
        bz1_now_by = p_by[25 * lane + 8]
        ax1_now_by = p_by[25 * lane + 9]
        ay1_now_by = p_by[25 * lane + 10]
        az1_now_by = p_by[25 * lane + 11]
        dl1_now_by = p_by[25 * lane + 12]
        bx2_now_by = p_by[25 * lane + 13]
        by2_now_by = p_by[25 * lane + 14]
        bz2_now_by = p_by[25 * lane + 15]
        ax2_now_by = p_by[25 * lane + 16]
        ay2_now_by = p_by[25 * lane + 17]
        az2_now_by = p_by[25 * lane + 18]
        dl2_now_by = p_by[25 * lane + 19]
        betax_now_by = p_by[25 * lane + 20]
        betay_now_by = p_by[25 * lane + 21]
        betaz_now_by = p_by[25 * lane + 22]
        tip_v_now_by = p_by[25 * lane + 23]
        tip_w_now_by = p_by[25 * lane + 24]
        s0_now = (betay_now * betay_now)
        s1_now = (betax_now * betax_now)
        s2_now = (betaz_now * betaz_now)
        s3_now = s0_now + s1_now + s2_now
        s7_now = 1.5619206968586225e-16*s0_now + 1.5619206968586225e-16*s1_now + 1.5619206968586225e-16*s2_now - 4.779477332387385e-14
        s9_now = s3_now*s7_now + 1.1470745597729725e-11
        s11_now = s3_now*s9_now - 2.08767569878681e-09
        s13_now = s11_now*s3_now + 2.755731922398589e-07
        s15_now = s13_now*s3_now - 2.48015873015873e-05
        s17_now = s15_now*s3_now + 0.001388888888888889
        s19_now = s17_now*s3_now - 0.041666666666666664
        s21_now = s19_now*s3_now + 0.5
        s22_now = -s0_now*s21_now
        s23_now = -s21_now*s2_now
        s24_now = s22_now + s23_now + 1
        s25_now = sine(phi_now)
        s30_now = 2.8114572543455206e-15*s0_now + 2.8114572543455206e-15*s1_now + 2.8114572543455206e-15*s2_now - 7.647163731819816e-13
        s32_now = s30_now*s3_now + 1.6059043836821613e-10
        s34_now = s32_now*s3_now - 2.505210838544172e-08
        s36_now = s34_now*s3_now + 2.7557319223985893e-06
        s38_now = s36_now*s3_now - 0.0001984126984126984
        s40_now = s38_now*s3_now + 0.008333333333333333
        s42_now = s3_now*s40_now - 0.16666666666666666
        s44_now = s3_now*s42_now + 1
        s45_now = -betaz_now*s44_now
        s46_now = betax_now*betay_now*s21_now
        s47_now = s45_now + s46_now
        s48_now = cosine(phi_now)
        R0_11_now = s24_now*s25_now - s47_now*s48_now
        s54_now = betay_now*s44_now
        s55_now = betax_now*betaz_now*s21_now
        s57_now = -s45_now + s46_now
        s59_now = -s1_now*s21_now
        s60_now = s23_now + s59_now + 1
        R0_21_now = s25_now*s57_now - s48_now*s60_now
        s66_now = -betax_now*s44_now
        s67_now = betay_now*betaz_now*s21_now
        s69_now = -s54_now + s55_now
        s71_now = -s66_now + s67_now
        R0_31_now = s25_now*s69_now - s48_now*s71_now
        s133_now = 0.5*c_now
        g1_x_now = ax1_now + s133_now + tip_w_now
        g2_x_now = ax2_now - s133_now + tip_w_now
        s220_now = dl1_now + l_now
        s355_now = 2*betay_now
        s356_now = 2*betax_now
        s357_now = 2*betaz_now
        s358_now = betaz_now*s21_now
        s359_now = betax_now*s21_now
        s360_now = betax_now*betaz_now
        s361_now = betay_now*s21_now
        s362_now = betay_now*betaz_now
        s363_now = betax_now*betay_now
        s121 = s30_now*s356_now + 2.8114572543455206e-15*s356_now*s3_now
        s123 = s121*s3_now + s32_now*s356_now
        s125 = s123*s3_now + s34_now*s356_now
        s383_now = s125*s3_now
        s131 = s356_now*s36_now + s383_now
        s133 = s131*s3_now + s356_now*s38_now
        s135 = s133*s3_now + s356_now*s40_now
        s390_now = s135*s3_now + s356_now*s42_now
        s391_now = betay_now*s390_now
        s403_now = s13_now*s356_now
        s144 = 1.5619206968586225e-16*s356_now*s3_now + s356_now*s7_now
        s146 = s144*s3_now + s356_now*s9_now
        s148 = s11_now*s356_now + s146*s3_now
        s404_now = s148*s3_now + s403_now
        s155 = s15_now*s356_now + s3_now*s404_now
        s157 = s155*s3_now + s17_now*s356_now
        s413_now = s157*s3_now + s19_now*s356_now
        s415_now = s358_now + s360_now*s413_now
        s416_now = -s391_now + s415_now
        s419_now = -betax_now*s390_now - s44_now
        s420_now = s362_now*s413_now
        s421_now = -s419_now + s420_now
        s423_now = s25_now*s416_now - s421_now*s48_now
        s426_now = -betaz_now*s390_now
        s428_now = s361_now + s363_now*s413_now
        s429_now = -s426_now + s428_now
        s431_now = -s2_now*s413_now
        s434_now = -s1_now*s413_now - s21_now*s356_now
        s435_now = s431_now + s434_now
        s437_now = s25_now*s429_now - s435_now*s48_now
        s440_now = -s0_now*s413_now
        s441_now = s431_now + s440_now
        s443_now = s426_now + s428_now
        s445_now = s25_now*s441_now - s443_now*s48_now
        s207 = s30_now*s355_now + 2.8114572543455206e-15*s355_now*s3_now
        s209 = s207*s3_now + s32_now*s355_now
        s211 = s209*s3_now + s34_now*s355_now
        s481_now = s211*s3_now
        s217 = s355_now*s36_now + s481_now
        s219 = s217*s3_now + s355_now*s38_now
        s221 = s219*s3_now + s355_now*s40_now
        s488_now = s221*s3_now + s355_now*s42_now
        s490_now = betay_now*s488_now + s44_now
        s502_now = s13_now*s355_now
        s231 = 1.5619206968586225e-16*s355_now*s3_now + s355_now*s7_now
        s233 = s231*s3_now + s355_now*s9_now
        s235 = s11_now*s355_now + s233*s3_now
        s503_now = s235*s3_now + s502_now
        s242 = s15_now*s355_now + s3_now*s503_now
        s244 = s17_now*s355_now + s242*s3_now
        s512_now = s19_now*s355_now + s244*s3_now
        s513_now = s360_now*s512_now
        s514_now = -s490_now + s513_now
        s516_now = -betax_now*s488_now
        s518_now = s358_now + s362_now*s512_now
        s519_now = -s516_now + s518_now
        s521_now = s25_now*s514_now - s48_now*s519_now
        s524_now = -betaz_now*s488_now
        s526_now = s359_now + s363_now*s512_now
        s527_now = -s524_now + s526_now
        s529_now = -s2_now*s512_now
        s530_now = -s1_now*s512_now
        s531_now = s529_now + s530_now
        s533_now = s25_now*s527_now - s48_now*s531_now
        s538_now = -s0_now*s512_now - s21_now*s355_now
        s539_now = s529_now + s538_now
        s541_now = s524_now + s526_now
        s543_now = s25_now*s539_now - s48_now*s541_now
        s293 = s30_now*s357_now + 2.8114572543455206e-15*s357_now*s3_now
        s295 = s293*s3_now + s32_now*s357_now
        s297 = s295*s3_now + s34_now*s357_now
        s579_now = s297*s3_now
        s303 = s357_now*s36_now + s579_now
        s305 = s303*s3_now + s357_now*s38_now
        s307 = s305*s3_now + s357_now*s40_now
        s586_now = s307*s3_now + s357_now*s42_now
        s587_now = betay_now*s586_now
        s599_now = s13_now*s357_now
        s316 = 1.5619206968586225e-16*s357_now*s3_now + s357_now*s7_now
        s318 = s316*s3_now + s357_now*s9_now
        s320 = s11_now*s357_now + s318*s3_now
        s600_now = s320*s3_now + s599_now
        s327 = s15_now*s357_now + s3_now*s600_now
        s329 = s17_now*s357_now + s327*s3_now
        s609_now = s19_now*s357_now + s329*s3_now
        s611_now = s359_now + s360_now*s609_now
        s612_now = -s587_now + s611_now
        s614_now = -betax_now*s586_now
        s616_now = s361_now + s362_now*s609_now
        s617_now = -s614_now + s616_now
        s619_now = s25_now*s612_now - s48_now*s617_now
        s623_now = -betaz_now*s586_now - s44_now
        s624_now = s363_now*s609_now
        s625_now = -s623_now + s624_now
        s629_now = -s21_now*s357_now - s2_now*s609_now
        s630_now = -s1_now*s609_now
        s631_now = s629_now + s630_now
        s633_now = s25_now*s625_now - s48_now*s631_now
        s636_now = -s0_now*s609_now
        s637_now = s629_now + s636_now
        s639_now = s623_now + s624_now
        s641_now = s25_now*s637_now - s48_now*s639_now
        s669_now = dl2_now + l_now
        s858_now = (L_now * L_now)
        s1083_now = -0.5*l_now
        s412 = betay_now_by*s355_now
        s413 = betax_now_by*s356_now
        s414 = betaz_now_by*s357_now
        s415 = s412 + s413 + s414
        s419 = 1.5619206968586225e-16*s412 + 1.5619206968586225e-16*s413 + 1.5619206968586225e-16*s414
        s422 = s3_now*s419 + s415*s7_now
        s425 = s3_now*s422 + s415*s9_now
        s428 = s11_now*s415 + s3_now*s425
        s431 = s13_now*s415 + s3_now*s428
        s434 = s15_now*s415 + s3_now*s431
        s437 = s17_now*s415 + s3_now*s434
        s440 = s19_now*s415 + s3_now*s437
        s443 = -s0_now*s440 - s21_now*s412
        s446 = -s21_now*s414 - s2_now*s440
        s447 = s443 + s446
        s448 = phi_now_by*s48_now
        s452 = 2.8114572543455206e-15*s412 + 2.8114572543455206e-15*s413 + 2.8114572543455206e-15*s414
        s455 = s30_now*s415 + s3_now*s452
        s458 = s32_now*s415 + s3_now*s455
        s461 = s34_now*s415 + s3_now*s458
        s464 = s36_now*s415 + s3_now*s461
        s467 = s38_now*s415 + s3_now*s464
        s470 = s3_now*s467 + s40_now*s415
        s473 = s3_now*s470 + s415*s42_now
        s476 = -betaz_now*s473 - betaz_now_by*s44_now
        s480 = betax_now_by*s361_now + betay_now_by*s359_now + s363_now*s440
        s481 = s476 + s480
        s482 = -phi_now_by*s25_now
        s489 = s24_now*s448 + s25_now*s447 - s47_now*s482 - s481*s48_now
        s496 = s24_now*s482 + s25_now*s481 + s447*s48_now + s448*s47_now
        s499 = betay_now*s473 + betay_now_by*s44_now
        s503 = betax_now_by*s358_now + betaz_now_by*s359_now + s360_now*s440
        s504 = s499 + s503
        s505 = -s476 + s480
        s508 = -s1_now*s440 - s21_now*s413
        s509 = s446 + s508
        s516 = s25_now*s505 + s448*s57_now - s482*s60_now - s48_now*s509
        s523 = s25_now*s509 + s448*s60_now + s482*s57_now + s48_now*s505
        s526 = -betax_now*s473 - betax_now_by*s44_now
        s530 = betay_now_by*s358_now + betaz_now_by*s361_now + s362_now*s440
        s531 = s526 + s530
        s532 = -s499 + s503
        s533 = -s526 + s530
        s540 = s25_now*s532 + s448*s69_now - s482*s71_now - s48_now*s533
        s547 = s25_now*s533 + s448*s71_now + s482*s69_now + s48_now*s532
        s548 = s443 + s508
        s549 = 0.5*c_now_by
        s550 = ax1_now_by + s549 + tip_w_now_by
        s551 = L_now_by + ay1_now_by
        s552 = az1_now_by + tip_v_now_by
        s555 = a_now*s482 + a_now_by*s48_now
        s559 = 0.5*c_now_by*s25_now + s133_now*s448
        s560 = bx1_now_by + s555 + s559
        s563 = a_now*s448 + a_now_by*s25_now
        s567 = -0.5*c_now_by*s48_now - s133_now*s482
        s568 = by1_now_by + s563 + s567
        s571 = b_now*s482 + b_now_by*s48_now
        s575 = R0_11_now*s550 + g1_x_now*s489 + s571
        s578 = b_now*s448 + b_now_by*s25_now
        s582 = R0_21_now*s550 + g1_x_now*s516 + s578
        s585 = R0_31_now*s550 + g1_x_now*s540
        s586 = ax2_now_by - s549 + tip_w_now_by
        s587 = L_now_by + ay2_now_by
        s588 = az2_now_by + tip_v_now_by
        s589 = bx2_now_by + s555 - s559
        s590 = by2_now_by + s563 - s567
        s594 = R0_11_now*s586 + g2_x_now*s489 + s571
        s598 = R0_21_now*s586 + g2_x_now*s516 + s578
        s601 = R0_31_now*s586 + g2_x_now*s540
        s602 = dl1_now_by + l_now_by
        s605 = -s220_now*s602
        s606 = 2*betay_now_by
        s607 = 2*betax_now_by
        s608 = 2*betaz_now_by
        s611 = betaz_now*s440 + betaz_now_by*s21_now
        s614 = betax_now*s440 + betax_now_by*s21_now
        s617 = betax_now*betaz_now_by + betax_now_by*betaz_now
        s620 = betay_now*s440 + betay_now_by*s21_now
        s623 = betay_now*betaz_now_by + betay_now_by*betaz_now
        s626 = betax_now*betay_now_by + betax_now_by*betay_now
        s636 = 2.8114572543455206e-15*s3_now
        s644 = s121*s415 + s3_now*(s30_now*s607 + 2.8114572543455206e-15*s356_now*s415 + s356_now*s452 + s607*s636)
        s650 = s3_now*(s123*s415 + s34_now*s607 + s356_now*s458 + s3_now*(s32_now*s607 + s356_now*s455 + s644))
        s668 = s131*s415 + s3_now*(s125*s415 + s356_now*s461 + s36_now*s607 + s650)
        s674 = s3_now*(s133*s415 + s356_now*s467 + s3_now*(s356_now*s464 + s38_now*s607 + s668) + s40_now*s607)
        s677 = s135*s415 + s356_now*s470 + s42_now*s607 + s674
        s680 = betay_now*s677 + betay_now_by*s390_now
        s693 = 1.5619206968586225e-16*s3_now
        s701 = s144*s415 + s3_now*(1.5619206968586225e-16*s356_now*s415 + s356_now*s419 + s607*s693 + s607*s7_now)
        s707 = s3_now*(s11_now*s607 + s146*s415 + s356_now*s425 + s3_now*(s356_now*s422 + s607*s9_now + s701))
        s722 = s3_now*(s13_now*s607 + s148*s415 + s356_now*s428 + s707) + s404_now*s415
        s728 = s3_now*(s155*s415 + s17_now*s607 + s356_now*s434 + s3_now*(s15_now*s607 + s356_now*s431 + s722))
        s731 = s157*s415 + s19_now*s607 + s356_now*s437 + s728
        s735 = s360_now*s731 + s413_now*s617 + s611
        s736 = -s680 + s735
        s740 = -betax_now*s677 - betax_now_by*s390_now - s473
        s743 = s362_now*s731 + s413_now*s623
        s744 = -s740 + s743
        s751 = s25_now*s736 + s416_now*s448 - s421_now*s482 - s48_now*s744
        s754 = g1_x_now*s751 + s423_now*s550
        s757 = -betaz_now*s677 - betaz_now_by*s390_now
        s761 = s363_now*s731 + s413_now*s626 + s620
        s762 = -s757 + s761
        s765 = -s2_now*s731 - s413_now*s414
        s772 = -s1_now*s731 - s21_now*s607 - s356_now*s440 - s413*s413_now
        s773 = s765 + s772
        s780 = s25_now*s762 + s429_now*s448 - s435_now*s482 - s48_now*s773
        s783 = g1_x_now*s780 + s437_now*s550
        s786 = -s0_now*s731 - s412*s413_now
        s787 = s765 + s786
        s788 = s757 + s761
        s795 = s25_now*s787 + s441_now*s448 - s443_now*s482 - s48_now*s788
        s798 = g1_x_now*s795 + s445_now*s550
        s805 = s25_now*s744 + s416_now*s482 + s421_now*s448 + s48_now*s736
        s806 = s772 + s786
        s813 = s25_now*s773 + s429_now*s482 + s435_now*s448 + s48_now*s762
        s814 = s740 + s743
        s821 = s25_now*s788 + s441_now*s482 + s443_now*s448 + s48_now*s787
        s822 = s680 + s735
        s839 = s207*s415 + s3_now*(s30_now*s606 + 2.8114572543455206e-15*s355_now*s415 + s355_now*s452 + s606*s636)
        s845 = s3_now*(s209*s415 + s34_now*s606 + s355_now*s458 + s3_now*(s32_now*s606 + s355_now*s455 + s839))
        s863 = s217*s415 + s3_now*(s211*s415 + s355_now*s461 + s36_now*s606 + s845)
        s869 = s3_now*(s219*s415 + s355_now*s467 + s3_now*(s355_now*s464 + s38_now*s606 + s863) + s40_now*s606)
        s872 = s221*s415 + s355_now*s470 + s42_now*s606 + s869
        s876 = betay_now*s872 + betay_now_by*s488_now + s473
        s896 = s231*s415 + s3_now*(1.5619206968586225e-16*s355_now*s415 + s355_now*s419 + s606*s693 + s606*s7_now)
        s902 = s3_now*(s11_now*s606 + s233*s415 + s355_now*s425 + s3_now*(s355_now*s422 + s606*s9_now + s896))
        s917 = s3_now*(s13_now*s606 + s235*s415 + s355_now*s428 + s902) + s415*s503_now
        s923 = s3_now*(s17_now*s606 + s242*s415 + s355_now*s434 + s3_now*(s15_now*s606 + s355_now*s431 + s917))
        s926 = s19_now*s606 + s244*s415 + s355_now*s437 + s923
        s929 = s360_now*s926 + s512_now*s617
        s930 = -s876 + s929
        s933 = -betax_now*s872 - betax_now_by*s488_now
        s937 = s362_now*s926 + s512_now*s623 + s611
        s938 = -s933 + s937
        s945 = s25_now*s930 + s448*s514_now - s482*s519_now - s48_now*s938
        s948 = g1_x_now*s945 + s521_now*s550
        s951 = -betaz_now*s872 - betaz_now_by*s488_now
        s955 = s363_now*s926 + s512_now*s626 + s614
        s956 = -s951 + s955
        s959 = -s2_now*s926 - s414*s512_now
        s962 = -s1_now*s926 - s413*s512_now
        s963 = s959 + s962
        s970 = s25_now*s956 + s448*s527_now - s482*s531_now - s48_now*s963
        s973 = g1_x_now*s970 + s533_now*s550
        s980 = -s0_now*s926 - s21_now*s606 - s355_now*s440 - s412*s512_now
        s981 = s959 + s980
        s982 = s951 + s955
        s989 = s25_now*s981 + s448*s539_now - s482*s541_now - s48_now*s982
        s992 = g1_x_now*s989 + s543_now*s550
        s999 = s25_now*s938 + s448*s519_now + s482*s514_now + s48_now*s930
        s1000 = s962 + s980
        s1007 = s25_now*s963 + s448*s531_now + s482*s527_now + s48_now*s956
        s1008 = s933 + s937
        s1015 = s25_now*s982 + s448*s541_now + s482*s539_now + s48_now*s981
        s1016 = s876 + s929
        s1033 = s293*s415 + s3_now*(s30_now*s608 + 2.8114572543455206e-15*s357_now*s415 + s357_now*s452 + s608*s636)
        s1039 = s3_now*(s295*s415 + s34_now*s608 + s357_now*s458 + s3_now*(s1033 + s32_now*s608 + s357_now*s455))
        s1057 = s303*s415 + s3_now*(s1039 + s297*s415 + s357_now*s461 + s36_now*s608)
        s1063 = s3_now*(s305*s415 + s357_now*s467 + s3_now*(s1057 + s357_now*s464 + s38_now*s608) + s40_now*s608)
        s1066 = s1063 + s307*s415 + s357_now*s470 + s42_now*s608
        s1069 = betay_now*s1066 + betay_now_by*s586_now
        s1089 = s316*s415 + s3_now*(1.5619206968586225e-16*s357_now*s415 + s357_now*s419 + s608*s693 + s608*s7_now)
        s1095 = s3_now*(s11_now*s608 + s318*s415 + s357_now*s425 + s3_now*(s1089 + s357_now*s422 + s608*s9_now))
        s1110 = s3_now*(s1095 + s13_now*s608 + s320*s415 + s357_now*s428) + s415*s600_now
        s1116 = s3_now*(s17_now*s608 + s327*s415 + s357_now*s434 + s3_now*(s1110 + s15_now*s608 + s357_now*s431))
        s1119 = s1116 + s19_now*s608 + s329*s415 + s357_now*s437
        s1123 = s1119*s360_now + s609_now*s617 + s614
        s1124 = -s1069 + s1123
        s1127 = -betax_now*s1066 - betax_now_by*s586_now
        s1131 = s1119*s362_now + s609_now*s623 + s620
        s1132 = -s1127 + s1131
        s1139 = s1124*s25_now - s1132*s48_now + s448*s612_now - s482*s617_now
        s1142 = g1_x_now*s1139 + s550*s619_now
        s1146 = -betaz_now*s1066 - betaz_now_by*s586_now - s473
        s1149 = s1119*s363_now + s609_now*s626
        s1150 = -s1146 + s1149
        s1157 = -s1119*s2_now - s21_now*s608 - s357_now*s440 - s414*s609_now
        s1160 = -s1119*s1_now - s413*s609_now
        s1161 = s1157 + s1160
        s1168 = s1150*s25_now - s1161*s48_now + s448*s625_now - s482*s631_now
        s1171 = g1_x_now*s1168 + s550*s633_now
        s1174 = -s0_now*s1119 - s412*s609_now
        s1175 = s1157 + s1174
        s1176 = s1146 + s1149
        s1183 = s1175*s25_now - s1176*s48_now + s448*s637_now - s482*s639_now
        s1186 = g1_x_now*s1183 + s550*s641_now
        s1193 = s1124*s48_now + s1132*s25_now + s448*s617_now + s482*s612_now
        s1194 = s1160 + s1174
        s1201 = s1150*s48_now + s1161*s25_now + s448*s631_now + s482*s625_now
        s1202 = s1127 + s1131
        s1209 = s1175*s48_now + s1176*s25_now + s448*s639_now + s482*s637_now
        s1210 = s1069 + s1123
        s1211 = dl2_now_by + l_now_by
        s1214 = -s1211*s669_now
        s1217 = g2_x_now*s751 + s423_now*s586
        s1220 = g2_x_now*s780 + s437_now*s586
        s1223 = g2_x_now*s795 + s445_now*s586
        s1226 = g2_x_now*s945 + s521_now*s586
        s1229 = g2_x_now*s970 + s533_now*s586
        s1232 = g2_x_now*s989 + s543_now*s586
        s1235 = g2_x_now*s1139 + s586*s619_now
        s1238 = g2_x_now*s1168 + s586*s633_now
        s1241 = g2_x_now*s1183 + s586*s641_now
        s1242 = s555 - s571
        s1245 = -L_now*s482 - L_now_by*s48_now
        s1246 = s563 - s578
        s1249 = -L_now*s448 - L_now_by*s25_now
        s1251 = 2*l_now*l_now_by
        s1252 = -0.5*s1251
        s1254 = 2*L_now*L_now_by
        s1263 = s1254*(0.5*(s25_now * s25_now) + 0.5*(s48_now * s48_now))
        s1265 = s1252 + s1263 + 0.5*s858_now*(2*s25_now*s448 + 2*s482*s48_now)
        s1268 = -0.5*dl1_now*dl1_now_by
        s1271 = -0.5*dl2_now*dl2_now_by
        s1274 = -0.5*dl1_now*l_now_by + dl1_now_by*s1083_now
        s1277 = -0.5*dl2_now*l_now_by + dl2_now_by*s1083_now
        s1278 = s1252 + s1268 + s1271 + s1274 + s1277
        s1279 = -0.5*l_now_by
        s1281 = -0.5*dl1_now_by + s1279
        s1283 = -0.5*dl2_now_by + s1279
        s1284 = s1268 - s1271 + s1274 - s1277
        k[77 * lane + 0] = s496
        k[77 * lane + 1] = s504
        k[77 * lane + 2] = s523
        k[77 * lane + 3] = s531
        k[77 * lane + 4] = s547
        k[77 * lane + 5] = s548
        k[77 * lane + 6] = s551
        k[77 * lane + 7] = s552
        k[77 * lane + 8] = s575
        k[77 * lane + 9] = s582
        k[77 * lane + 10] = s585
        k[77 * lane + 11] = s560
        k[77 * lane + 12] = s568
        k[77 * lane + 13] = bz1_now_by
        k[77 * lane + 14] = s587
        k[77 * lane + 15] = s588
        k[77 * lane + 16] = s594
        k[77 * lane + 17] = s598
        k[77 * lane + 18] = s601
        k[77 * lane + 19] = s589
        k[77 * lane + 20] = s590
        k[77 * lane + 21] = bz2_now_by
        k[77 * lane + 22] = s605
        k[77 * lane + 23] = s1214
        k[77 * lane + 24] = s1242
        k[77 * lane + 25] = s1245
        k[77 * lane + 26] = s1246
        k[77 * lane + 27] = s1249
        k[77 * lane + 28] = s1265
        k[77 * lane + 29] = s1254
        k[77 * lane + 30] = L_now_by
        k[77 * lane + 31] = s540
        k[77 * lane + 32] = s516
        k[77 * lane + 33] = s489
        k[77 * lane + 34] = s754
        k[77 * lane + 35] = s783
        k[77 * lane + 36] = s798
        k[77 * lane + 37] = s805
        k[77 * lane + 38] = s806
        k[77 * lane + 39] = s813
        k[77 * lane + 40] = s814
        k[77 * lane + 41] = s821
        k[77 * lane + 42] = s822
        k[77 * lane + 43] = s948
        k[77 * lane + 44] = s973
        k[77 * lane + 45] = s992
        k[77 * lane + 46] = s999
        k[77 * lane + 47] = s1000
        k[77 * lane + 48] = s1007
        k[77 * lane + 49] = s1008
        k[77 * lane + 50] = s1015
        k[77 * lane + 51] = s1016
        k[77 * lane + 52] = s1142
        k[77 * lane + 53] = s1171
        k[77 * lane + 54] = s1186
        k[77 * lane + 55] = s1193
        k[77 * lane + 56] = s1194
        k[77 * lane + 57] = s1201
        k[77 * lane + 58] = s1202
        k[77 * lane + 59] = s1209
        k[77 * lane + 60] = s1210
        k[77 * lane + 61] = s1217
        k[77 * lane + 62] = s1220
        k[77 * lane + 63] = s1223
        k[77 * lane + 64] = s1226
        k[77 * lane + 65] = s1229
        k[77 * lane + 66] = s1232
        k[77 * lane + 67] = s1235
        k[77 * lane + 68] = s1238
        k[77 * lane + 69] = s1241
        k[77 * lane + 70] = -s602
        k[77 * lane + 71] = -s1211
        k[77 * lane + 72] = s1251
        k[77 * lane + 73] = s1278
        k[77 * lane + 74] = s1284
        k[77 * lane + 75] = s1281
        k[77 * lane + 76] = s1283


@fast
def _constants_by(p, p_by, k, c):
    _fill_machine_by(p, p_by, k, p.shape[0] * p.shape[1])
    _fill_by(p, p_by, c, p.shape[0] * p.shape[1])


def constants_by(p, p_by):
    """Return how k and c change, which `constants` of ``kinematics.py`` and of this module make of one machine's p
    (1, 3, 25), along each of p_by (E, 3, 25)."""
    p_by = np.ascontiguousarray(p_by, dtype=float)
    k_by = np.empty((len(p_by), 3, 77))
    c_by = np.empty((len(p_by), 3, 25))
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
        w_by[3456 + lane] = s74
        w_by[6784 + lane] = s74
        w_by[160 + lane] = s75
        w_by[3488 + lane] = s75
        w_by[6816 + lane] = s75
        w_by[192 + lane] = s76
        w_by[3520 + lane] = s76
        w_by[6848 + lane] = s76
        w_by[224 + lane] = s93
        w_by[256 + lane] = s104
        w_by[288 + lane] = s115
        w_by[320 + lane] = s133
        w_by[3648 + lane] = s133
        w_by[6976 + lane] = s133
        w_by[352 + lane] = s142
        w_by[3680 + lane] = s142
        w_by[7008 + lane] = s142
        w_by[384 + lane] = s150
        w_by[3712 + lane] = s150
        w_by[7040 + lane] = s150
        w_by[416 + lane] = s154
        w_by[3744 + lane] = s154
        w_by[7072 + lane] = s154
        w_by[448 + lane] = s159
        w_by[3776 + lane] = s159
        w_by[7104 + lane] = s159
        w_by[480 + lane] = s166
        w_by[3808 + lane] = s166
        w_by[7136 + lane] = s166
        w_by[512 + lane] = s170
        w_by[3840 + lane] = s170
        w_by[7168 + lane] = s170
        w_by[544 + lane] = s174
        w_by[3872 + lane] = s174
        w_by[7200 + lane] = s174
        w_by[576 + lane] = s178
        w_by[3904 + lane] = s178
        w_by[7232 + lane] = s178


@straight
def _early_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what moves with a joint only; then the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d (110 operations)."""
    R0_12_now = k[0]
    R0_13_now = k[1]
    R0_22_now = k[2]
    R0_23_now = k[3]
    R0_32_now = k[4]
    R0_33_now = k[5]
    g1_y_now = k[6]
    g1_z_now = k[7]
    g2_y_now = k[14]
    g2_z_now = k[15]
    s839_now = k[24]
    s841_now = k[25]
    s843_now = k[26]
    s845_now = k[27]
    L_now = k[30]
    R0_12_now_by = k_by[0]
    R0_13_now_by = k_by[1]
    R0_22_now_by = k_by[2]
    R0_23_now_by = k_by[3]
    R0_32_now_by = k_by[4]
    R0_33_now_by = k_by[5]
    g1_y_now_by = k_by[6]
    g1_z_now_by = k_by[7]
    s147_now_by = k_by[8]
    s153_now_by = k_by[9]
    s155_now_by = k_by[10]
    h1_x_now_by = k_by[11]
    h1_y_now_by = k_by[12]
    bz1_now_by = k_by[13]
    g2_y_now_by = k_by[14]
    g2_z_now_by = k_by[15]
    s185_now_by = k_by[16]
    s190_now_by = k_by[17]
    s192_now_by = k_by[18]
    h2_x_now_by = k_by[19]
    h2_y_now_by = k_by[20]
    bz2_now_by = k_by[21]
    s839_now_by = k_by[24]
    s841_now_by = k_by[25]
    s843_now_by = k_by[26]
    s845_now_by = k_by[27]
    L_now_by = k_by[30]
    s856_now_by = k_by[72]
    for lane in range(n):
        q_now = w[0 + lane]
        tx_now = w[32 + lane]
        ty_now = w[64 + lane]
        tz_now = w[96 + lane]
        s78_now = cosine(q_now)
        s80_now = sine(q_now)
        R1_12_now = R0_12_now*s78_now + R0_13_now*s80_now
        R1_13_now = -R0_12_now*s80_now + R0_13_now*s78_now
        R1_22_now = R0_22_now*s78_now + R0_23_now*s80_now
        R1_23_now = -R0_22_now*s80_now + R0_23_now*s78_now
        R1_32_now = R0_32_now*s78_now + R0_33_now*s80_now
        R1_33_now = -R0_32_now*s80_now + R0_33_now*s78_now
        s877_now = -s78_now*s841_now - s839_now + tx_now
        s879_now = -s78_now*s845_now - s843_now + ty_now
        s881_now = L_now*s80_now + tz_now
        s56 = R0_12_now_by*s78_now + R0_13_now_by*s80_now
        s59 = -R0_12_now_by*s80_now + R0_13_now_by*s78_now
        s62 = R0_22_now_by*s78_now + R0_23_now_by*s80_now
        s65 = -R0_22_now_by*s80_now + R0_23_now_by*s78_now
        s68 = R0_32_now_by*s78_now + R0_33_now_by*s80_now
        s71 = -R0_32_now_by*s80_now + R0_33_now_by*s78_now
        s78 = R1_12_now*g1_y_now_by + R1_13_now*g1_z_now_by + g1_y_now*s56 + g1_z_now*s59 + s147_now_by
        s85 = R1_22_now*g1_y_now_by + R1_23_now*g1_z_now_by + g1_y_now*s62 + g1_z_now*s65 + s153_now_by
        s92 = R1_32_now*g1_y_now_by + R1_33_now*g1_z_now_by + g1_y_now*s68 + g1_z_now*s71 + s155_now_by
        s99 = R1_12_now*g2_y_now_by + R1_13_now*g2_z_now_by + g2_y_now*s56 + g2_z_now*s59 + s185_now_by
        s106 = R1_22_now*g2_y_now_by + R1_23_now*g2_z_now_by + g2_y_now*s62 + g2_z_now*s65 + s190_now_by
        s113 = R1_32_now*g2_y_now_by + R1_33_now*g2_z_now_by + g2_y_now*s68 + g2_z_now*s71 + s192_now_by
        s115 = -s78_now*s841_now_by - s839_now_by
        s117 = -s78_now*s845_now_by - s843_now_by
        s118 = L_now_by*s80_now
        s125 = 2*s115*s877_now + 2*s117*s879_now + 2*s118*s881_now - s856_now_by
        w_by[1120 + lane] = h1_x_now_by
        w_by[1152 + lane] = h1_y_now_by
        w_by[1184 + lane] = bz1_now_by
        w_by[1216 + lane] = s78
        w_by[1248 + lane] = s85
        w_by[1280 + lane] = s92
        w_by[1312 + lane] = h2_x_now_by
        w_by[1344 + lane] = h2_y_now_by
        w_by[1376 + lane] = bz2_now_by
        w_by[1408 + lane] = s99
        w_by[1440 + lane] = s106
        w_by[1472 + lane] = s113
        w_by[1504 + lane] = s115
        w_by[1536 + lane] = s117
        w_by[1568 + lane] = s118
        w_by[1600 + lane] = s125


@straight
def _more_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of what else derivatives by joint and errors read of it (80 operations)."""
    R0_12_now = k[0]
    R0_13_now = k[1]
    R0_22_now = k[2]
    R0_23_now = k[3]
    R0_32_now = k[4]
    R0_33_now = k[5]
    g1_y_now = k[6]
    g1_z_now = k[7]
    g2_y_now = k[14]
    g2_z_now = k[15]
    R0_12_now_by = k_by[0]
    R0_13_now_by = k_by[1]
    R0_22_now_by = k_by[2]
    R0_23_now_by = k_by[3]
    R0_32_now_by = k_by[4]
    R0_33_now_by = k_by[5]
    g1_y_now_by = k_by[6]
    g1_z_now_by = k_by[7]
    g2_y_now_by = k_by[14]
    g2_z_now_by = k_by[15]
    for lane in range(n):
        q_now = w[0 + lane]
        s78_now = cosine(q_now)
        s80_now = sine(q_now)
        R1_12_now = R0_12_now*s78_now + R0_13_now*s80_now
        R1_13_now = -R0_12_now*s80_now + R0_13_now*s78_now
        R1_22_now = R0_22_now*s78_now + R0_23_now*s80_now
        R1_23_now = -R0_22_now*s80_now + R0_23_now*s78_now
        R1_32_now = R0_32_now*s78_now + R0_33_now*s80_now
        R1_33_now = -R0_32_now*s80_now + R0_33_now*s78_now
        s40 = R0_12_now_by*s78_now + R0_13_now_by*s80_now
        s43 = -R0_12_now_by*s80_now + R0_13_now_by*s78_now
        s46 = R0_22_now_by*s78_now + R0_23_now_by*s80_now
        s49 = -R0_22_now_by*s80_now + R0_23_now_by*s78_now
        s52 = R0_32_now_by*s78_now + R0_33_now_by*s80_now
        s55 = -R0_32_now_by*s80_now + R0_33_now_by*s78_now
        s62 = R1_12_now*g1_z_now_by - R1_13_now*g1_y_now_by - g1_y_now*s43 + g1_z_now*s40
        s69 = R1_22_now*g1_z_now_by - R1_23_now*g1_y_now_by - g1_y_now*s49 + g1_z_now*s46
        s76 = R1_32_now*g1_z_now_by - R1_33_now*g1_y_now_by - g1_y_now*s55 + g1_z_now*s52
        s83 = R1_12_now*g2_z_now_by - R1_13_now*g2_y_now_by - g2_y_now*s43 + g2_z_now*s40
        s90 = R1_22_now*g2_z_now_by - R1_23_now*g2_y_now_by - g2_y_now*s49 + g2_z_now*s46
        s97 = R1_32_now*g2_z_now_by - R1_33_now*g2_y_now_by - g2_y_now*s55 + g2_z_now*s52
        w_by[1664 + lane] = s55
        w_by[1696 + lane] = s52
        w_by[1728 + lane] = s49
        w_by[1760 + lane] = s46
        w_by[1792 + lane] = s43
        w_by[1824 + lane] = s40
        w_by[1856 + lane] = 0
        w_by[1888 + lane] = 0
        w_by[1920 + lane] = s62
        w_by[1952 + lane] = s69
        w_by[1984 + lane] = s76
        w_by[2016 + lane] = s83
        w_by[2048 + lane] = s90
        w_by[2080 + lane] = s97


@straight
def _rows_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of equations of a limb, their derivatives by shift and turn of the platform (260 operations)."""
    s901_now_by = k_by[73]
    s1139_now_by = k_by[74]
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
        s159_now = w[1120 + lane]
        s161_now = w[1152 + lane]
        s163_now = w[1184 + lane]
        A1_x_now = w[1216 + lane]
        A1_y_now = w[1248 + lane]
        A1_z_now = w[1280 + lane]
        s196_now = w[1312 + lane]
        s198_now = w[1344 + lane]
        s200_now = w[1376 + lane]
        A2_x_now = w[1408 + lane]
        A2_y_now = w[1440 + lane]
        A2_z_now = w[1472 + lane]
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
        s159_now_by = w_by[1120 + lane]
        s161_now_by = w_by[1152 + lane]
        s163_now_by = w_by[1184 + lane]
        A1_x_now_by = w_by[1216 + lane]
        A1_y_now_by = w_by[1248 + lane]
        A1_z_now_by = w_by[1280 + lane]
        s196_now_by = w_by[1312 + lane]
        s198_now_by = w_by[1344 + lane]
        s200_now_by = w_by[1376 + lane]
        A2_x_now_by = w_by[1408 + lane]
        A2_y_now_by = w_by[1440 + lane]
        A2_z_now_by = w_by[1472 + lane]
        s160_now = R_11_now*s159_now
        s162_now = R_12_now*s161_now
        s164_now = R_13_now*s163_now
        B1_x_now = px_now + s160_now + s162_now + s164_now
        s166_now = R_21_now*s159_now
        s167_now = R_22_now*s161_now
        s168_now = R_23_now*s163_now
        B1_y_now = py_now + s166_now + s167_now + s168_now
        s170_now = R_31_now*s159_now
        s171_now = R_32_now*s161_now
        s172_now = R_33_now*s163_now
        B1_z_now = pz_now + s170_now + s171_now + s172_now
        d1_x_now = -A1_x_now + B1_x_now
        d1_y_now = -A1_y_now + B1_y_now
        d1_z_now = -A1_z_now + B1_z_now
        s197_now = R_11_now*s196_now
        s199_now = R_12_now*s198_now
        s201_now = R_13_now*s200_now
        B2_x_now = px_now + s197_now + s199_now + s201_now
        s203_now = R_21_now*s196_now
        s204_now = R_22_now*s198_now
        s205_now = R_23_now*s200_now
        B2_y_now = py_now + s203_now + s204_now + s205_now
        s207_now = R_31_now*s196_now
        s208_now = R_32_now*s198_now
        s209_now = R_33_now*s200_now
        B2_z_now = pz_now + s207_now + s208_now + s209_now
        d2_x_now = -A2_x_now + B2_x_now
        d2_y_now = -A2_y_now + B2_y_now
        d2_z_now = -A2_z_now + B2_z_now
        s1265_now = 0.5*d1_x_now
        s1266_now = 0.5*d2_x_now
        s1268_now = 0.5*d1_y_now
        s1269_now = 0.5*d2_y_now
        s1271_now = 0.5*d1_z_now
        s1272_now = 0.5*d2_z_now
        s1274_now = -s170_now - s171_now - s172_now
        s1276_now = s166_now + s167_now + s168_now
        s1278_now = -s207_now - s208_now - s209_now
        s1280_now = s203_now + s204_now + s205_now
        s1284_now = -s160_now - s162_now - s164_now
        s1287_now = -s197_now - s199_now - s201_now
        s82 = R_11_now*s159_now_by + R_11_now_by*s159_now
        s85 = R_12_now*s161_now_by + R_12_now_by*s161_now
        s88 = R_13_now*s163_now_by + R_13_now_by*s163_now
        s92 = R_21_now*s159_now_by + R_21_now_by*s159_now
        s95 = R_22_now*s161_now_by + R_22_now_by*s161_now
        s98 = R_23_now*s163_now_by + R_23_now_by*s163_now
        s102 = R_31_now*s159_now_by + R_31_now_by*s159_now
        s105 = R_32_now*s161_now_by + R_32_now_by*s161_now
        s108 = R_33_now*s163_now_by + R_33_now_by*s163_now
        s110 = -A1_x_now_by + px_now_by + s82 + s85 + s88
        s111 = -A1_y_now_by + py_now_by + s92 + s95 + s98
        s112 = -A1_z_now_by + pz_now_by + s102 + s105 + s108
        s115 = R_11_now*s196_now_by + R_11_now_by*s196_now
        s118 = R_12_now*s198_now_by + R_12_now_by*s198_now
        s121 = R_13_now*s200_now_by + R_13_now_by*s200_now
        s125 = R_21_now*s196_now_by + R_21_now_by*s196_now
        s128 = R_22_now*s198_now_by + R_22_now_by*s198_now
        s131 = R_23_now*s200_now_by + R_23_now_by*s200_now
        s135 = R_31_now*s196_now_by + R_31_now_by*s196_now
        s138 = R_32_now*s198_now_by + R_32_now_by*s198_now
        s141 = R_33_now*s200_now_by + R_33_now_by*s200_now
        s143 = -A2_x_now_by + px_now_by + s115 + s118 + s121
        s144 = -A2_y_now_by + py_now_by + s125 + s128 + s131
        s145 = -A2_z_now_by + pz_now_by + s135 + s138 + s141
        s148 = 0.5*d1_x_now*s110
        s151 = 0.5*d1_y_now*s111
        s154 = 0.5*d1_z_now*s112
        s157 = 0.5*d2_x_now*s143
        s160 = 0.5*d2_y_now*s144
        s163 = 0.5*d2_z_now*s145
        s164 = s148 + s151 + s154 + s157 + s160 + s163 + s901_now_by
        s165 = s1139_now_by + s148 + s151 + s154 - s157 - s160 - s163
        s166 = 0.5*s110
        s167 = 0.5*s143
        s168 = s166 + s167
        s169 = 0.5*s111
        s170 = 0.5*s144
        s171 = s169 + s170
        s172 = 0.5*s112
        s173 = 0.5*s145
        s174 = s172 + s173
        s175 = -s102 - s105 - s108
        s176 = 0.5*s1274_now
        s179 = s111*s176 + s1268_now*s175
        s180 = s92 + s95 + s98
        s181 = 0.5*s1276_now
        s184 = s112*s181 + s1271_now*s180
        s185 = -s135 - s138 - s141
        s186 = 0.5*s1278_now
        s189 = s1269_now*s185 + s144*s186
        s190 = s125 + s128 + s131
        s191 = 0.5*s1280_now
        s194 = s1272_now*s190 + s145*s191
        s195 = s179 + s184 + s189 + s194
        s198 = -s110*s176 - s1265_now*s175
        s199 = -s82 - s85 - s88
        s200 = 0.5*s1284_now
        s203 = s112*s200 + s1271_now*s199
        s206 = -s1266_now*s185 - s143*s186
        s207 = -s115 - s118 - s121
        s208 = 0.5*s1287_now
        s211 = s1272_now*s207 + s145*s208
        s212 = s198 + s203 + s206 + s211
        s215 = -s110*s181 - s1265_now*s180
        s218 = -s111*s200 - s1268_now*s199
        s221 = -s1266_now*s190 - s143*s191
        s224 = -s1269_now*s207 - s144*s208
        s225 = s215 + s218 + s221 + s224
        s226 = s166 - s167
        s227 = s169 - s170
        s228 = s172 - s173
        s229 = s179 + s184 - s189 - s194
        s230 = s198 + s203 - s206 - s211
        s231 = s215 + s218 - s221 - s224
        w_by[608 + lane] = s164
        w_by[640 + lane] = s168
        w_by[672 + lane] = s171
        w_by[704 + lane] = s174
        w_by[736 + lane] = s195
        w_by[768 + lane] = s212
        w_by[800 + lane] = s225
        w_by[864 + lane] = s165
        w_by[896 + lane] = s226
        w_by[928 + lane] = s227
        w_by[960 + lane] = s228
        w_by[992 + lane] = s229
        w_by[1024 + lane] = s230
        w_by[1056 + lane] = s231


@straight
def _joints_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of derivatives of a limb's equations by its joint (160 operations)."""
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
        s159_now = w[1120 + lane]
        s161_now = w[1152 + lane]
        s163_now = w[1184 + lane]
        A1_x_now = w[1216 + lane]
        A1_y_now = w[1248 + lane]
        A1_z_now = w[1280 + lane]
        s196_now = w[1312 + lane]
        s198_now = w[1344 + lane]
        s200_now = w[1376 + lane]
        A2_x_now = w[1408 + lane]
        A2_y_now = w[1440 + lane]
        A2_z_now = w[1472 + lane]
        s1303_now = w[1920 + lane]
        s1307_now = w[1952 + lane]
        s1311_now = w[1984 + lane]
        s1315_now = w[2016 + lane]
        s1319_now = w[2048 + lane]
        s1323_now = w[2080 + lane]
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
        s159_now_by = w_by[1120 + lane]
        s161_now_by = w_by[1152 + lane]
        s163_now_by = w_by[1184 + lane]
        A1_x_now_by = w_by[1216 + lane]
        A1_y_now_by = w_by[1248 + lane]
        A1_z_now_by = w_by[1280 + lane]
        s196_now_by = w_by[1312 + lane]
        s198_now_by = w_by[1344 + lane]
        s200_now_by = w_by[1376 + lane]
        A2_x_now_by = w_by[1408 + lane]
        A2_y_now_by = w_by[1440 + lane]
        A2_z_now_by = w_by[1472 + lane]
        s1303_now_by = w_by[1920 + lane]
        s1307_now_by = w_by[1952 + lane]
        s1311_now_by = w_by[1984 + lane]
        s1315_now_by = w_by[2016 + lane]
        s1319_now_by = w_by[2048 + lane]
        s1323_now_by = w_by[2080 + lane]
        B1_x_now = R_11_now*s159_now + R_12_now*s161_now + R_13_now*s163_now + px_now
        B1_y_now = R_21_now*s159_now + R_22_now*s161_now + R_23_now*s163_now + py_now
        B1_z_now = R_31_now*s159_now + R_32_now*s161_now + R_33_now*s163_now + pz_now
        d1_x_now = -A1_x_now + B1_x_now
        d1_y_now = -A1_y_now + B1_y_now
        d1_z_now = -A1_z_now + B1_z_now
        B2_x_now = R_11_now*s196_now + R_12_now*s198_now + R_13_now*s200_now + px_now
        B2_y_now = R_21_now*s196_now + R_22_now*s198_now + R_23_now*s200_now + py_now
        B2_z_now = R_31_now*s196_now + R_32_now*s198_now + R_33_now*s200_now + pz_now
        d2_x_now = -A2_x_now + B2_x_now
        d2_y_now = -A2_y_now + B2_y_now
        d2_z_now = -A2_z_now + B2_z_now
        s47 = R_11_now*s159_now_by + R_11_now_by*s159_now + R_12_now*s161_now_by + R_12_now_by*s161_now + R_13_now*s163_now_by + R_13_now_by*s163_now + px_now_by
        s57 = R_21_now*s159_now_by + R_21_now_by*s159_now + R_22_now*s161_now_by + R_22_now_by*s161_now + R_23_now*s163_now_by + R_23_now_by*s163_now + py_now_by
        s67 = R_31_now*s159_now_by + R_31_now_by*s159_now + R_32_now*s161_now_by + R_32_now_by*s161_now + R_33_now*s163_now_by + R_33_now_by*s163_now + pz_now_by
        s80 = R_11_now*s196_now_by + R_11_now_by*s196_now + R_12_now*s198_now_by + R_12_now_by*s198_now + R_13_now*s200_now_by + R_13_now_by*s200_now + px_now_by
        s90 = R_21_now*s196_now_by + R_21_now_by*s196_now + R_22_now*s198_now_by + R_22_now_by*s198_now + R_23_now*s200_now_by + R_23_now_by*s200_now + py_now_by
        s100 = R_31_now*s196_now_by + R_31_now_by*s196_now + R_32_now*s198_now_by + R_32_now_by*s198_now + R_33_now*s200_now_by + R_33_now_by*s200_now + pz_now_by
        s108 = 0.5*d1_x_now*s1303_now_by + 0.5*s1303_now*(-A1_x_now_by + s47)
        s113 = 0.5*d1_y_now*s1307_now_by + 0.5*s1307_now*(-A1_y_now_by + s57)
        s118 = 0.5*d1_z_now*s1311_now_by + 0.5*s1311_now*(-A1_z_now_by + s67)
        s123 = 0.5*d2_x_now*s1315_now_by + 0.5*s1315_now*(-A2_x_now_by + s80)
        s128 = 0.5*d2_y_now*s1319_now_by + 0.5*s1319_now*(-A2_y_now_by + s90)
        s133 = 0.5*d2_z_now*s1323_now_by + 0.5*s1323_now*(-A2_z_now_by + s100)
        s134 = s108 + s113 + s118 + s123 + s128 + s133
        s135 = s108 + s113 + s118 - s123 - s128 - s133
        w_by[832 + lane] = s134
        w_by[1088 + lane] = s135


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
        J10_0_now = w[3968 + lane]
        J10_1_now = w[4000 + lane]
        J10_2_now = w[4032 + lane]
        J10_3_now = w[4064 + lane]
        J10_4_now = w[4096 + lane]
        J10_5_now = w[4128 + lane]
        J11_0_now = w[4224 + lane]
        J11_1_now = w[4256 + lane]
        J11_2_now = w[4288 + lane]
        J11_3_now = w[4320 + lane]
        J11_4_now = w[4352 + lane]
        J11_5_now = w[4384 + lane]
        J20_0_now = w[7296 + lane]
        J20_1_now = w[7328 + lane]
        J20_2_now = w[7360 + lane]
        J20_3_now = w[7392 + lane]
        J20_4_now = w[7424 + lane]
        J20_5_now = w[7456 + lane]
        J21_0_now = w[7552 + lane]
        J21_1_now = w[7584 + lane]
        J21_2_now = w[7616 + lane]
        J21_3_now = w[7648 + lane]
        J21_4_now = w[7680 + lane]
        J21_5_now = w[7712 + lane]
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
        J10_0_now_by = w_by[3968 + lane]
        J10_1_now_by = w_by[4000 + lane]
        J10_2_now_by = w_by[4032 + lane]
        J10_3_now_by = w_by[4064 + lane]
        J10_4_now_by = w_by[4096 + lane]
        J10_5_now_by = w_by[4128 + lane]
        J11_0_now_by = w_by[4224 + lane]
        J11_1_now_by = w_by[4256 + lane]
        J11_2_now_by = w_by[4288 + lane]
        J11_3_now_by = w_by[4320 + lane]
        J11_4_now_by = w_by[4352 + lane]
        J11_5_now_by = w_by[4384 + lane]
        J20_0_now_by = w_by[7296 + lane]
        J20_1_now_by = w_by[7328 + lane]
        J20_2_now_by = w_by[7360 + lane]
        J20_3_now_by = w_by[7392 + lane]
        J20_4_now_by = w_by[7424 + lane]
        J20_5_now_by = w_by[7456 + lane]
        J21_0_now_by = w_by[7552 + lane]
        J21_1_now_by = w_by[7584 + lane]
        J21_2_now_by = w_by[7616 + lane]
        J21_3_now_by = w_by[7648 + lane]
        J21_4_now_by = w_by[7680 + lane]
        J21_5_now_by = w_by[7712 + lane]
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
    """Rates of how the platform moves with each joint, and how it does (246 operations)."""
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
        Q_3_now = w[1088 + lane]
        q_t_1_now = d[1280 + lane]
        Q_1_now = w[4160 + lane]
        Q_4_now = w[4416 + lane]
        q_t_2_now = d[2560 + lane]
        Q_2_now = w[7488 + lane]
        Q_5_now = w[7744 + lane]
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
        Q_3_now_by = w_by[1088 + lane]
        q_t_1_now_by = d_by[1280 + lane]
        Q_1_now_by = w_by[4160 + lane]
        Q_4_now_by = w_by[4416 + lane]
        q_t_2_now_by = d_by[2560 + lane]
        Q_2_now_by = w_by[7488 + lane]
        Q_5_now_by = w_by[7744 + lane]
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
    """Rates of second derivatives of a limb's equations by time where nothing accelerates (994 operations)."""
    R0_12_now = k[0]
    R0_13_now = k[1]
    R0_22_now = k[2]
    R0_23_now = k[3]
    R0_32_now = k[4]
    R0_33_now = k[5]
    g1_y_now = k[6]
    g1_z_now = k[7]
    s112_now = k[8]
    s118_now = k[9]
    s120_now = k[10]
    h1_x_now = k[11]
    h1_y_now = k[12]
    bz1_now = k[13]
    g2_y_now = k[14]
    g2_z_now = k[15]
    s150_now = k[16]
    s155_now = k[17]
    s157_now = k[18]
    h2_x_now = k[19]
    h2_y_now = k[20]
    bz2_now = k[21]
    R0_12_now_by = k_by[0]
    R0_13_now_by = k_by[1]
    R0_22_now_by = k_by[2]
    R0_23_now_by = k_by[3]
    R0_32_now_by = k_by[4]
    R0_33_now_by = k_by[5]
    g1_y_now_by = k_by[6]
    g1_z_now_by = k_by[7]
    s112_now_by = k_by[8]
    s118_now_by = k_by[9]
    s120_now_by = k_by[10]
    h1_x_now_by = k_by[11]
    h1_y_now_by = k_by[12]
    bz1_now_by = k_by[13]
    g2_y_now_by = k_by[14]
    g2_z_now_by = k_by[15]
    s150_now_by = k_by[16]
    s155_now_by = k_by[17]
    s157_now_by = k_by[18]
    h2_x_now_by = k_by[19]
    h2_y_now_by = k_by[20]
    bz2_now_by = k_by[21]
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
        s78_now = cosine(q_now)
        s80_now = sine(q_now)
        R1_12_now = R0_12_now*s78_now + R0_13_now*s80_now
        R1_13_now = -R0_12_now*s80_now + R0_13_now*s78_now
        R1_22_now = R0_22_now*s78_now + R0_23_now*s80_now
        R1_23_now = -R0_22_now*s80_now + R0_23_now*s78_now
        R1_32_now = R0_32_now*s78_now + R0_33_now*s80_now
        R1_33_now = -R0_32_now*s80_now + R0_33_now*s78_now
        A1_x_now = R1_12_now*g1_y_now + R1_13_now*g1_z_now + s112_now
        A1_y_now = R1_22_now*g1_y_now + R1_23_now*g1_z_now + s118_now
        A1_z_now = R1_32_now*g1_y_now + R1_33_now*g1_z_now + s120_now
        s124_now = h1_x_now - tx_now
        s126_now = h1_y_now - ty_now
        s128_now = bz1_now - tz_now
        B1_x_now = R_11_now*s124_now + R_12_now*s126_now + R_13_now*s128_now + px_now
        B1_y_now = R_21_now*s124_now + R_22_now*s126_now + R_23_now*s128_now + py_now
        B1_z_now = R_31_now*s124_now + R_32_now*s126_now + R_33_now*s128_now + pz_now
        d1_x_now = -A1_x_now + B1_x_now
        d1_y_now = -A1_y_now + B1_y_now
        d1_z_now = -A1_z_now + B1_z_now
        A2_x_now = R1_12_now*g2_y_now + R1_13_now*g2_z_now + s150_now
        A2_y_now = R1_22_now*g2_y_now + R1_23_now*g2_z_now + s155_now
        A2_z_now = R1_32_now*g2_y_now + R1_33_now*g2_z_now + s157_now
        s161_now = h2_x_now - tx_now
        s163_now = h2_y_now - ty_now
        s165_now = bz2_now - tz_now
        B2_x_now = R_11_now*s161_now + R_12_now*s163_now + R_13_now*s165_now + px_now
        B2_y_now = R_21_now*s161_now + R_22_now*s163_now + R_23_now*s165_now + py_now
        B2_z_now = R_31_now*s161_now + R_32_now*s163_now + R_33_now*s165_now + pz_now
        d2_x_now = -A2_x_now + B2_x_now
        d2_y_now = -A2_y_now + B2_y_now
        d2_z_now = -A2_z_now + B2_z_now
        s205_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s208_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s211_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s214_now = R_11_now*w_z_now - R_31_now*w_x_now
        s217_now = R_12_now*w_z_now - R_32_now*w_x_now
        s220_now = R_13_now*w_z_now - R_33_now*w_x_now
        s223_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s226_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s229_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s230_now = -q_t_now*s80_now
        s232_now = q_t_now*s78_now
        s234_now = R0_12_now*s230_now + R0_13_now*s232_now
        s237_now = -R0_12_now*s232_now + R0_13_now*s230_now
        s240_now = R0_22_now*s230_now + R0_23_now*s232_now
        s243_now = -R0_22_now*s232_now + R0_23_now*s230_now
        s246_now = R0_32_now*s230_now + R0_33_now*s232_now
        s249_now = -R0_32_now*s232_now + R0_33_now*s230_now
        s271_now = -g1_y_now*s234_now - g1_z_now*s237_now + s124_now*s205_now + s126_now*s208_now + s128_now*s211_now + v_px_now
        s272_now = -g1_y_now*s240_now - g1_z_now*s243_now + s124_now*s214_now + s126_now*s217_now + s128_now*s220_now + v_py_now
        s273_now = -g1_y_now*s246_now - g1_z_now*s249_now + s124_now*s223_now + s126_now*s226_now + s128_now*s229_now + v_pz_now
        s295_now = -g2_y_now*s234_now - g2_z_now*s237_now + s161_now*s205_now + s163_now*s208_now + s165_now*s211_now + v_px_now
        s296_now = -g2_y_now*s240_now - g2_z_now*s243_now + s161_now*s214_now + s163_now*s217_now + s165_now*s220_now + v_py_now
        s297_now = -g2_y_now*s246_now - g2_z_now*s249_now + s161_now*s223_now + s163_now*s226_now + s165_now*s229_now + v_pz_now
        s320_now = -s214_now*w_z_now + s223_now*w_y_now
        s323_now = -s217_now*w_z_now + s226_now*w_y_now
        s326_now = -s220_now*w_z_now + s229_now*w_y_now
        s329_now = s205_now*w_z_now - s223_now*w_x_now
        s332_now = s208_now*w_z_now - s226_now*w_x_now
        s335_now = s211_now*w_z_now - s229_now*w_x_now
        s338_now = -s205_now*w_y_now + s214_now*w_x_now
        s341_now = -s208_now*w_y_now + s217_now*w_x_now
        s344_now = -s211_now*w_y_now + s220_now*w_x_now
        s345_now = -q_t_now*s232_now
        s347_now = q_t_now*s230_now
        s349_now = R0_12_now*s345_now + R0_13_now*s347_now
        s352_now = -R0_12_now*s347_now + R0_13_now*s345_now
        s355_now = R0_22_now*s345_now + R0_23_now*s347_now
        s358_now = -R0_22_now*s347_now + R0_23_now*s345_now
        s361_now = R0_32_now*s345_now + R0_33_now*s347_now
        s364_now = -R0_32_now*s347_now + R0_33_now*s345_now
        s211 = -g1_y_now*s349_now - g1_z_now*s352_now + s124_now*s320_now + s126_now*s323_now + s128_now*s326_now
        s222 = -g1_y_now*s355_now - g1_z_now*s358_now + s124_now*s329_now + s126_now*s332_now + s128_now*s335_now
        s233 = -g1_y_now*s361_now - g1_z_now*s364_now + s124_now*s338_now + s126_now*s341_now + s128_now*s344_now
        s244 = -g2_y_now*s349_now - g2_z_now*s352_now + s161_now*s320_now + s163_now*s323_now + s165_now*s326_now
        s255 = -g2_y_now*s355_now - g2_z_now*s358_now + s161_now*s329_now + s163_now*s332_now + s165_now*s335_now
        s266 = -g2_y_now*s361_now - g2_z_now*s364_now + s161_now*s338_now + s163_now*s341_now + s165_now*s344_now
        s274 = R0_12_now_by*s78_now + R0_13_now_by*s80_now
        s277 = -R0_12_now_by*s80_now + R0_13_now_by*s78_now
        s280 = R0_22_now_by*s78_now + R0_23_now_by*s80_now
        s283 = -R0_22_now_by*s80_now + R0_23_now_by*s78_now
        s286 = R0_32_now_by*s78_now + R0_33_now_by*s80_now
        s289 = -R0_32_now_by*s80_now + R0_33_now_by*s78_now
        s320 = R_11_now*h1_x_now_by + R_11_now_by*s124_now + R_12_now*h1_y_now_by + R_12_now_by*s126_now + R_13_now*bz1_now_by + R_13_now_by*s128_now + px_now_by
        s330 = R_21_now*h1_x_now_by + R_21_now_by*s124_now + R_22_now*h1_y_now_by + R_22_now_by*s126_now + R_23_now*bz1_now_by + R_23_now_by*s128_now + py_now_by
        s340 = R_31_now*h1_x_now_by + R_31_now_by*s124_now + R_32_now*h1_y_now_by + R_32_now_by*s126_now + R_33_now*bz1_now_by + R_33_now_by*s128_now + pz_now_by
        s374 = R_11_now*h2_x_now_by + R_11_now_by*s161_now + R_12_now*h2_y_now_by + R_12_now_by*s163_now + R_13_now*bz2_now_by + R_13_now_by*s165_now + px_now_by
        s384 = R_21_now*h2_x_now_by + R_21_now_by*s161_now + R_22_now*h2_y_now_by + R_22_now_by*s163_now + R_23_now*bz2_now_by + R_23_now_by*s165_now + py_now_by
        s394 = R_31_now*h2_x_now_by + R_31_now_by*s161_now + R_32_now*h2_y_now_by + R_32_now_by*s163_now + R_33_now*bz2_now_by + R_33_now_by*s165_now + pz_now_by
        s404 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s411 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s418 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s425 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s432 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s439 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s446 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s453 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s460 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s461 = -q_t_now_by*s80_now
        s462 = q_t_now_by*s78_now
        s469 = R0_12_now*s461 + R0_12_now_by*s230_now + R0_13_now*s462 + R0_13_now_by*s232_now
        s476 = -R0_12_now*s462 - R0_12_now_by*s232_now + R0_13_now*s461 + R0_13_now_by*s230_now
        s483 = R0_22_now*s461 + R0_22_now_by*s230_now + R0_23_now*s462 + R0_23_now_by*s232_now
        s490 = -R0_22_now*s462 - R0_22_now_by*s232_now + R0_23_now*s461 + R0_23_now_by*s230_now
        s497 = R0_32_now*s461 + R0_32_now_by*s230_now + R0_33_now*s462 + R0_33_now_by*s232_now
        s504 = -R0_32_now*s462 - R0_32_now_by*s232_now + R0_33_now*s461 + R0_33_now_by*s230_now
        s513 = bz1_now_by*s211_now + s128_now*s418
        s516 = -g1_y_now*s469 - g1_y_now_by*s234_now
        s519 = -g1_z_now*s476 - g1_z_now_by*s237_now
        s529 = bz1_now_by*s220_now + s128_now*s439
        s532 = -g1_y_now*s483 - g1_y_now_by*s240_now
        s535 = -g1_z_now*s490 - g1_z_now_by*s243_now
        s545 = bz1_now_by*s229_now + s128_now*s460
        s548 = -g1_y_now*s497 - g1_y_now_by*s246_now
        s551 = -g1_z_now*s504 - g1_z_now_by*s249_now
        s561 = bz2_now_by*s211_now + s165_now*s418
        s564 = -g2_y_now*s469 - g2_y_now_by*s234_now
        s567 = -g2_z_now*s476 - g2_z_now_by*s237_now
        s577 = bz2_now_by*s220_now + s165_now*s439
        s580 = -g2_y_now*s483 - g2_y_now_by*s240_now
        s583 = -g2_z_now*s490 - g2_z_now_by*s243_now
        s593 = bz2_now_by*s229_now + s165_now*s460
        s596 = -g2_y_now*s497 - g2_y_now_by*s246_now
        s599 = -g2_z_now*s504 - g2_z_now_by*s249_now
        s607 = -s214_now*w_z_now_by + s223_now*w_y_now_by - s425*w_z_now + s446*w_y_now
        s614 = -s217_now*w_z_now_by + s226_now*w_y_now_by - s432*w_z_now + s453*w_y_now
        s621 = -s220_now*w_z_now_by + s229_now*w_y_now_by - s439*w_z_now + s460*w_y_now
        s628 = s205_now*w_z_now_by - s223_now*w_x_now_by + s404*w_z_now - s446*w_x_now
        s635 = s208_now*w_z_now_by - s226_now*w_x_now_by + s411*w_z_now - s453*w_x_now
        s642 = s211_now*w_z_now_by - s229_now*w_x_now_by + s418*w_z_now - s460*w_x_now
        s649 = -s205_now*w_y_now_by + s214_now*w_x_now_by - s404*w_y_now + s425*w_x_now
        s656 = -s208_now*w_y_now_by + s217_now*w_x_now_by - s411*w_y_now + s432*w_x_now
        s663 = -s211_now*w_y_now_by + s220_now*w_x_now_by - s418*w_y_now + s439*w_x_now
        s666 = -q_t_now*s462 - q_t_now_by*s232_now
        s669 = q_t_now*s461 + q_t_now_by*s230_now
        s676 = R0_12_now*s666 + R0_12_now_by*s345_now + R0_13_now*s669 + R0_13_now_by*s347_now
        s683 = -R0_12_now*s669 - R0_12_now_by*s347_now + R0_13_now*s666 + R0_13_now_by*s345_now
        s690 = R0_22_now*s666 + R0_22_now_by*s345_now + R0_23_now*s669 + R0_23_now_by*s347_now
        s697 = -R0_22_now*s669 - R0_22_now_by*s347_now + R0_23_now*s666 + R0_23_now_by*s345_now
        s704 = R0_32_now*s666 + R0_32_now_by*s345_now + R0_33_now*s669 + R0_33_now_by*s347_now
        s711 = -R0_32_now*s669 - R0_32_now_by*s347_now + R0_33_now*s666 + R0_33_now_by*s345_now
        s712 = 2*s271_now
        s713 = s712*(h1_x_now_by*s205_now + h1_y_now_by*s208_now + s124_now*s404 + s126_now*s411 + s513 + s516 + s519 + v_px_now_by)
        s723 = bz1_now_by*s326_now + s128_now*s621
        s726 = -g1_y_now*s676 - g1_y_now_by*s349_now
        s729 = -g1_z_now*s683 - g1_z_now_by*s352_now
        s734 = 2*d1_x_now*(h1_x_now_by*s320_now + h1_y_now_by*s323_now + s124_now*s607 + s126_now*s614 + s723 + s726 + s729)
        s735 = 2*s211*(-R1_12_now*g1_y_now_by - R1_13_now*g1_z_now_by - g1_y_now*s274 - g1_z_now*s277 - s112_now_by + s320) + s734
        s737 = 0.5*s713 + 0.25*s735
        s738 = 2*s272_now
        s739 = s738*(h1_x_now_by*s214_now + h1_y_now_by*s217_now + s124_now*s425 + s126_now*s432 + s529 + s532 + s535 + v_py_now_by)
        s749 = bz1_now_by*s335_now + s128_now*s642
        s752 = -g1_y_now*s690 - g1_y_now_by*s355_now
        s755 = -g1_z_now*s697 - g1_z_now_by*s358_now
        s760 = 2*d1_y_now*(h1_x_now_by*s329_now + h1_y_now_by*s332_now + s124_now*s628 + s126_now*s635 + s749 + s752 + s755)
        s761 = 2*s222*(-R1_22_now*g1_y_now_by - R1_23_now*g1_z_now_by - g1_y_now*s280 - g1_z_now*s283 - s118_now_by + s330) + s760
        s763 = 0.5*s739 + 0.25*s761
        s764 = 2*s273_now
        s765 = s764*(h1_x_now_by*s223_now + h1_y_now_by*s226_now + s124_now*s446 + s126_now*s453 + s545 + s548 + s551 + v_pz_now_by)
        s775 = bz1_now_by*s344_now + s128_now*s663
        s778 = -g1_y_now*s704 - g1_y_now_by*s361_now
        s781 = -g1_z_now*s711 - g1_z_now_by*s364_now
        s786 = 2*d1_z_now*(h1_x_now_by*s338_now + h1_y_now_by*s341_now + s124_now*s649 + s126_now*s656 + s775 + s778 + s781)
        s787 = 2*s233*(-R1_32_now*g1_y_now_by - R1_33_now*g1_z_now_by - g1_y_now*s286 - g1_z_now*s289 - s120_now_by + s340) + s786
        s789 = 0.5*s765 + 0.25*s787
        s790 = 2*s295_now
        s791 = s790*(h2_x_now_by*s205_now + h2_y_now_by*s208_now + s161_now*s404 + s163_now*s411 + s561 + s564 + s567 + v_px_now_by)
        s801 = bz2_now_by*s326_now + s165_now*s621
        s804 = -g2_y_now*s676 - g2_y_now_by*s349_now
        s807 = -g2_z_now*s683 - g2_z_now_by*s352_now
        s812 = 2*d2_x_now*(h2_x_now_by*s320_now + h2_y_now_by*s323_now + s161_now*s607 + s163_now*s614 + s801 + s804 + s807)
        s813 = 2*s244*(-R1_12_now*g2_y_now_by - R1_13_now*g2_z_now_by - g2_y_now*s274 - g2_z_now*s277 - s150_now_by + s374) + s812
        s815 = 0.5*s791 + 0.25*s813
        s816 = 2*s296_now
        s817 = s816*(h2_x_now_by*s214_now + h2_y_now_by*s217_now + s161_now*s425 + s163_now*s432 + s577 + s580 + s583 + v_py_now_by)
        s827 = bz2_now_by*s335_now + s165_now*s642
        s830 = -g2_y_now*s690 - g2_y_now_by*s355_now
        s833 = -g2_z_now*s697 - g2_z_now_by*s358_now
        s838 = 2*d2_y_now*(h2_x_now_by*s329_now + h2_y_now_by*s332_now + s161_now*s628 + s163_now*s635 + s827 + s830 + s833)
        s839 = 2*s255*(-R1_22_now*g2_y_now_by - R1_23_now*g2_z_now_by - g2_y_now*s280 - g2_z_now*s283 - s155_now_by + s384) + s838
        s841 = 0.5*s817 + 0.25*s839
        s842 = 2*s297_now
        s843 = s842*(h2_x_now_by*s223_now + h2_y_now_by*s226_now + s161_now*s446 + s163_now*s453 + s593 + s596 + s599 + v_pz_now_by)
        s853 = bz2_now_by*s344_now + s165_now*s663
        s856 = -g2_y_now*s704 - g2_y_now_by*s361_now
        s859 = -g2_z_now*s711 - g2_z_now_by*s364_now
        s864 = 2*d2_z_now*(h2_x_now_by*s338_now + h2_y_now_by*s341_now + s161_now*s649 + s163_now*s656 + s853 + s856 + s859)
        s865 = 2*s266*(-R1_32_now*g2_y_now_by - R1_33_now*g2_z_now_by - g2_y_now*s286 - g2_z_now*s289 - s157_now_by + s394) + s864
        s867 = 0.5*s843 + 0.25*s865
        s868 = s737 + s763 + s789 + s815 + s841 + s867
        s869 = s737 + s763 + s789 - s815 - s841 - s867
        d_by[64 + lane] = s868
        d_by[96 + lane] = s869


@straight
def _accelerate_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of the platform's acceleration (210 operations)."""
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
    """Rates of gravity less acceleration of the points of a limb (561 operations)."""
    R0_12_now = k[0]
    R0_13_now = k[1]
    R0_22_now = k[2]
    R0_23_now = k[3]
    R0_32_now = k[4]
    R0_33_now = k[5]
    g1_y_now = k[6]
    g1_z_now = k[7]
    h1_x_now = k[11]
    h1_y_now = k[12]
    bz1_now = k[13]
    g2_y_now = k[14]
    g2_z_now = k[15]
    h2_x_now = k[19]
    h2_y_now = k[20]
    bz2_now = k[21]
    L_now = k[22]
    R0_12_now_by = k_by[0]
    R0_13_now_by = k_by[1]
    R0_22_now_by = k_by[2]
    R0_23_now_by = k_by[3]
    R0_32_now_by = k_by[4]
    R0_33_now_by = k_by[5]
    g1_y_now_by = k_by[6]
    g1_z_now_by = k_by[7]
    h1_x_now_by = k_by[11]
    h1_y_now_by = k_by[12]
    bz1_now_by = k_by[13]
    g2_y_now_by = k_by[14]
    g2_z_now_by = k_by[15]
    h2_x_now_by = k_by[19]
    h2_y_now_by = k_by[20]
    bz2_now_by = k_by[21]
    L_now_by = k_by[22]
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
        s78_now = cosine(q_now)
        s80_now = sine(q_now)
        s124_now = h1_x_now - tx_now
        s126_now = h1_y_now - ty_now
        s128_now = bz1_now - tz_now
        s161_now = h2_x_now - tx_now
        s163_now = h2_y_now - ty_now
        s165_now = bz2_now - tz_now
        s205_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s208_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s211_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s214_now = R_11_now*w_z_now - R_31_now*w_x_now
        s217_now = R_12_now*w_z_now - R_32_now*w_x_now
        s220_now = R_13_now*w_z_now - R_33_now*w_x_now
        s223_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s226_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s229_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s1200_now = -R_21_now*w_z_t_now + R_31_now*w_y_t_now - s214_now*w_z_now + s223_now*w_y_now
        s1205_now = -R_22_now*w_z_t_now + R_32_now*w_y_t_now - s217_now*w_z_now + s226_now*w_y_now
        s1210_now = -R_23_now*w_z_t_now + R_33_now*w_y_t_now - s220_now*w_z_now + s229_now*w_y_now
        s1215_now = R_11_now*w_z_t_now - R_31_now*w_x_t_now + s205_now*w_z_now - s223_now*w_x_now
        s1220_now = R_12_now*w_z_t_now - R_32_now*w_x_t_now + s208_now*w_z_now - s226_now*w_x_now
        s1225_now = R_13_now*w_z_t_now - R_33_now*w_x_t_now + s211_now*w_z_now - s229_now*w_x_now
        s1230_now = -R_11_now*w_y_t_now + R_21_now*w_x_t_now - s205_now*w_y_now + s214_now*w_x_now
        s1235_now = -R_12_now*w_y_t_now + R_22_now*w_x_t_now - s208_now*w_y_now + s217_now*w_x_now
        s1240_now = -R_13_now*w_y_t_now + R_23_now*w_x_t_now - s211_now*w_y_now + s220_now*w_x_now
        s81 = (q_t_now * q_t_now)
        s1242_now = -q_tt_now*s80_now - s78_now*s81
        s1245_now = q_tt_now*s78_now - s80_now*s81
        s1247_now = R0_12_now*s1242_now + R0_13_now*s1245_now
        s1250_now = -R0_12_now*s1245_now + R0_13_now*s1242_now
        s1253_now = R0_22_now*s1242_now + R0_23_now*s1245_now
        s1256_now = -R0_22_now*s1245_now + R0_23_now*s1242_now
        s1259_now = R0_32_now*s1242_now + R0_33_now*s1245_now
        s1262_now = -R0_32_now*s1245_now + R0_33_now*s1242_now
        s204 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s211 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s218 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s225 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s232 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s239 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s246 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s253 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s260 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s272 = -s214_now*w_z_now_by - s225*w_z_now
        s273 = -R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now + R_31_now*w_y_t_now_by + R_31_now_by*w_y_t_now + s223_now*w_y_now_by + s246*w_y_now + s272
        s285 = -s217_now*w_z_now_by - s232*w_z_now
        s286 = -R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now + R_32_now*w_y_t_now_by + R_32_now_by*w_y_t_now + s226_now*w_y_now_by + s253*w_y_now + s285
        s298 = -s220_now*w_z_now_by - s239*w_z_now
        s299 = -R_23_now*w_z_t_now_by - R_23_now_by*w_z_t_now + R_33_now*w_y_t_now_by + R_33_now_by*w_y_t_now + s229_now*w_y_now_by + s260*w_y_now + s298
        s311 = -s223_now*w_x_now_by - s246*w_x_now
        s312 = R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_31_now*w_x_t_now_by - R_31_now_by*w_x_t_now + s204*w_z_now + s205_now*w_z_now_by + s311
        s324 = -s226_now*w_x_now_by - s253*w_x_now
        s325 = R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_32_now*w_x_t_now_by - R_32_now_by*w_x_t_now + s208_now*w_z_now_by + s211*w_z_now + s324
        s337 = -s229_now*w_x_now_by - s260*w_x_now
        s338 = R_13_now*w_z_t_now_by + R_13_now_by*w_z_t_now - R_33_now*w_x_t_now_by - R_33_now_by*w_x_t_now + s211_now*w_z_now_by + s218*w_z_now + s337
        s350 = -s204*w_y_now - s205_now*w_y_now_by
        s351 = -R_11_now*w_y_t_now_by - R_11_now_by*w_y_t_now + R_21_now*w_x_t_now_by + R_21_now_by*w_x_t_now + s214_now*w_x_now_by + s225*w_x_now + s350
        s363 = -s208_now*w_y_now_by - s211*w_y_now
        s364 = -R_12_now*w_y_t_now_by - R_12_now_by*w_y_t_now + R_22_now*w_x_t_now_by + R_22_now_by*w_x_t_now + s217_now*w_x_now_by + s232*w_x_now + s363
        s376 = -s211_now*w_y_now_by - s218*w_y_now
        s377 = -R_13_now*w_y_t_now_by - R_13_now_by*w_y_t_now + R_23_now*w_x_t_now_by + R_23_now_by*w_x_t_now + s220_now*w_x_now_by + s239*w_x_now + s376
        s380 = 2*q_t_now*q_t_now_by
        s382 = -q_tt_now_by*s80_now - s380*s78_now
        s385 = q_tt_now_by*s78_now - s380*s80_now
        s392 = R0_12_now*s382 + R0_12_now_by*s1242_now + R0_13_now*s385 + R0_13_now_by*s1245_now
        s399 = -R0_12_now*s385 - R0_12_now_by*s1245_now + R0_13_now*s382 + R0_13_now_by*s1242_now
        s406 = R0_22_now*s382 + R0_22_now_by*s1242_now + R0_23_now*s385 + R0_23_now_by*s1245_now
        s413 = -R0_22_now*s385 - R0_22_now_by*s1245_now + R0_23_now*s382 + R0_23_now_by*s1242_now
        s420 = R0_32_now*s382 + R0_32_now_by*s1242_now + R0_33_now*s385 + R0_33_now_by*s1245_now
        s427 = -R0_32_now*s385 - R0_32_now_by*s1245_now + R0_33_now*s382 + R0_33_now_by*s1242_now
        s434 = g1_y_now*s392 + g1_y_now_by*s1247_now + g1_z_now*s399 + g1_z_now_by*s1250_now
        s441 = g1_y_now*s406 + g1_y_now_by*s1253_now + g1_z_now*s413 + g1_z_now_by*s1256_now
        s448 = g1_y_now*s420 + g1_y_now_by*s1259_now + g1_z_now*s427 + g1_z_now_by*s1262_now
        s458 = bz1_now_by*s1210_now + h1_x_now_by*s1200_now + h1_y_now_by*s1205_now + s124_now*s273 + s126_now*s286 + s128_now*s299 + v_px_t_now_by
        s468 = bz1_now_by*s1225_now + h1_x_now_by*s1215_now + h1_y_now_by*s1220_now + s124_now*s312 + s126_now*s325 + s128_now*s338 + v_py_t_now_by
        s478 = bz1_now_by*s1240_now + h1_x_now_by*s1230_now + h1_y_now_by*s1235_now + s124_now*s351 + s126_now*s364 + s128_now*s377 + v_pz_t_now_by
        s485 = g2_y_now*s392 + g2_y_now_by*s1247_now + g2_z_now*s399 + g2_z_now_by*s1250_now
        s492 = g2_y_now*s406 + g2_y_now_by*s1253_now + g2_z_now*s413 + g2_z_now_by*s1256_now
        s499 = g2_y_now*s420 + g2_y_now_by*s1259_now + g2_z_now*s427 + g2_z_now_by*s1262_now
        s509 = bz2_now_by*s1210_now + h2_x_now_by*s1200_now + h2_y_now_by*s1205_now + s161_now*s273 + s163_now*s286 + s165_now*s299 + v_px_t_now_by
        s519 = bz2_now_by*s1225_now + h2_x_now_by*s1215_now + h2_y_now_by*s1220_now + s161_now*s312 + s163_now*s325 + s165_now*s338 + v_py_t_now_by
        s529 = bz2_now_by*s1240_now + h2_x_now_by*s1230_now + h2_y_now_by*s1235_now + s161_now*s351 + s163_now*s364 + s165_now*s377 + v_pz_t_now_by
        s531 = -0.001*L_now
        s534 = -0.001*L_now_by*s1247_now + s392*s531
        s538 = -0.001*L_now_by*s1253_now + s406*s531
        s542 = -0.001*L_now_by*s1259_now + s420*s531
        s543 = -0.001*s434
        s544 = -0.001*s441
        s545 = -0.001*s448
        s548 = -0.0005*s434 - 0.0005*s458
        s551 = -0.0005*s441 - 0.0005*s468
        s554 = -0.0005*s448 - 0.0005*s478
        s555 = -0.001*s458
        s556 = -0.001*s468
        s557 = -0.001*s478
        s558 = -0.001*s485
        s559 = -0.001*s492
        s560 = -0.001*s499
        s563 = -0.0005*s485 - 0.0005*s509
        s566 = -0.0005*s492 - 0.0005*s519
        s569 = -0.0005*s499 - 0.0005*s529
        s570 = -0.001*s509
        s571 = -0.001*s519
        s572 = -0.001*s529
        d_by[224 + lane] = s534
        d_by[256 + lane] = s538
        d_by[288 + lane] = s542
        d_by[320 + lane] = -s534
        d_by[352 + lane] = -s538
        d_by[384 + lane] = -s542
        d_by[416 + lane] = s543
        d_by[448 + lane] = s544
        d_by[480 + lane] = s545
        d_by[512 + lane] = s548
        d_by[544 + lane] = s551
        d_by[576 + lane] = s554
        d_by[608 + lane] = s555
        d_by[640 + lane] = s556
        d_by[672 + lane] = s557
        d_by[704 + lane] = s558
        d_by[736 + lane] = s559
        d_by[768 + lane] = s560
        d_by[800 + lane] = s563
        d_by[832 + lane] = s566
        d_by[864 + lane] = s569
        d_by[896 + lane] = s570
        d_by[928 + lane] = s571
        d_by[960 + lane] = s572


@straight
def _limb_asks_by(w, w_by, d, d_by, s, s_by, k, k_by, gravity, shares, inertia, n):
    """Rates of loads per inertial parameter of a limb, along joint, shifts and turns (496 operations)."""
    share_now = shares[0]
    R0_12_now = k[0]
    R0_13_now = k[1]
    R0_22_now = k[2]
    R0_23_now = k[3]
    R0_32_now = k[4]
    R0_33_now = k[5]
    g1_y_now = k[6]
    g1_z_now = k[7]
    h1_x_now = k[11]
    h1_y_now = k[12]
    bz1_now = k[13]
    g2_y_now = k[14]
    g2_z_now = k[15]
    h2_x_now = k[19]
    h2_y_now = k[20]
    bz2_now = k[21]
    L_now = k[22]
    s484_now = k[23]
    s541_now = k[24]
    R0_12_now_by = k_by[0]
    R0_13_now_by = k_by[1]
    R0_22_now_by = k_by[2]
    R0_23_now_by = k_by[3]
    R0_32_now_by = k_by[4]
    R0_33_now_by = k_by[5]
    g1_y_now_by = k_by[6]
    g1_z_now_by = k_by[7]
    h1_x_now_by = k_by[11]
    h1_y_now_by = k_by[12]
    bz1_now_by = k_by[13]
    g2_y_now_by = k_by[14]
    g2_z_now_by = k_by[15]
    h2_x_now_by = k_by[19]
    h2_y_now_by = k_by[20]
    bz2_now_by = k_by[21]
    L_now_by = k_by[22]
    s484_now_by = k_by[23]
    s541_now_by = k_by[24]
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
        s78_now = cosine(q_now)
        s80_now = sine(q_now)
        s124_now = h1_x_now - tx_now
        s126_now = h1_y_now - ty_now
        s128_now = bz1_now - tz_now
        s161_now = h2_x_now - tx_now
        s163_now = h2_y_now - ty_now
        s165_now = bz2_now - tz_now
        s495_now = -L_now*f2z_now
        s505_now = L_now*f1z_now
        s12 = f1y_now*s484_now + f2y_now*s484_now
        s512_now = L_now*s12
        s16 = f1x_now*s484_now + f2x_now*s484_now
        s517_now = L_now*s16
        s518_now = -s484_now*s495_now + s484_now*s505_now
        s34 = f1y_now*s541_now - f2y_now*s541_now
        s558_now = L_now*s34
        s38 = f1x_now*s541_now - f2x_now*s541_now
        s563_now = L_now*s38
        s564_now = s495_now*s541_now + s505_now*s541_now
        s607_now = 1 - 2*share_now
        s639_now = 0.5*f7z_now*s607_now
        s642_now = 0.5*f7y_now*s607_now
        s645_now = 0.5*f7x_now*s607_now
        s648_now = 0.5*f4z_now*s607_now
        s651_now = 0.5*f4y_now*s607_now
        s654_now = 0.5*f4x_now*s607_now
        s681_now = f8z_now*share_now + s639_now
        s688_now = f8y_now*share_now + s642_now
        s695_now = f8x_now*share_now + s645_now
        s705_now = f6z_now*share_now + s639_now
        s710_now = f6y_now*share_now + s642_now
        s715_now = f6x_now*share_now + s645_now
        s720_now = f5z_now*share_now + s648_now
        s727_now = f5y_now*share_now + s651_now
        s734_now = f5x_now*share_now + s654_now
        s744_now = f3z_now*share_now + s648_now
        s749_now = f3y_now*share_now + s651_now
        s754_now = f3x_now*share_now + s654_now
        s759_now = g1_z_now*s744_now + g2_z_now*s705_now
        s764_now = g1_y_now*s744_now + g2_y_now*s705_now
        s769_now = g1_z_now*s749_now + g2_z_now*s710_now
        s774_now = g1_y_now*s749_now + g2_y_now*s710_now
        s779_now = g1_z_now*s754_now + g2_z_now*s715_now
        s784_now = g1_y_now*s754_now + g2_y_now*s715_now
        s795_now = s128_now*s720_now + s165_now*s681_now
        s796_now = s126_now*s720_now + s163_now*s681_now
        s797_now = s124_now*s720_now + s161_now*s681_now
        s799_now = s128_now*s727_now + s165_now*s688_now
        s800_now = s126_now*s727_now + s163_now*s688_now
        s801_now = s124_now*s727_now + s161_now*s688_now
        s803_now = s128_now*s734_now + s165_now*s695_now
        s805_now = s126_now*s734_now + s163_now*s695_now
        s807_now = s124_now*s734_now + s161_now*s695_now
        s174 = -L_now*f2z_now_by - L_now_by*f2z_now
        s177 = L_now*f1z_now_by + L_now_by*f1z_now
        s187 = L_now*(f1y_now*s484_now_by + f1y_now_by*s484_now + f2y_now*s484_now_by + f2y_now_by*s484_now) + L_now_by*s12
        s197 = L_now*(f1x_now*s484_now_by + f1x_now_by*s484_now + f2x_now*s484_now_by + f2x_now_by*s484_now) + L_now_by*s16
        s204 = -s174*s484_now + s177*s484_now - s484_now_by*s495_now + s484_now_by*s505_now
        s214 = R0_12_now*s197 + R0_12_now_by*s517_now + R0_22_now*s187 + R0_22_now_by*s512_now + R0_32_now*s204 + R0_32_now_by*s518_now
        s226 = s78_now*(R0_13_now*s197 + R0_13_now_by*s517_now + R0_23_now*s187 + R0_23_now_by*s512_now + R0_33_now*s204 + R0_33_now_by*s518_now)
        s227 = -s214*s80_now + s226
        s237 = L_now*(f1y_now*s541_now_by + f1y_now_by*s541_now - f2y_now*s541_now_by - f2y_now_by*s541_now) + L_now_by*s34
        s247 = L_now*(f1x_now*s541_now_by + f1x_now_by*s541_now - f2x_now*s541_now_by - f2x_now_by*s541_now) + L_now_by*s38
        s254 = s174*s541_now + s177*s541_now + s495_now*s541_now_by + s505_now*s541_now_by
        s264 = R0_12_now*s247 + R0_12_now_by*s563_now + R0_22_now*s237 + R0_22_now_by*s558_now + R0_32_now*s254 + R0_32_now_by*s564_now
        s276 = s78_now*(R0_13_now*s247 + R0_13_now_by*s563_now + R0_23_now*s237 + R0_23_now_by*s558_now + R0_33_now*s254 + R0_33_now_by*s564_now)
        s277 = -s264*s80_now + s276
        s278 = 0.5*s607_now
        s280 = f7z_now_by*s278
        s282 = f7y_now_by*s278
        s284 = f7x_now_by*s278
        s286 = f4z_now_by*s278
        s288 = f4y_now_by*s278
        s290 = f4x_now_by*s278
        s292 = f8z_now_by*share_now + s280
        s294 = f8y_now_by*share_now + s282
        s296 = f8x_now_by*share_now + s284
        s298 = f6z_now_by*share_now + s280
        s300 = f6y_now_by*share_now + s282
        s302 = f6x_now_by*share_now + s284
        s304 = f5z_now_by*share_now + s286
        s306 = f5y_now_by*share_now + s288
        s308 = f5x_now_by*share_now + s290
        s310 = f3z_now_by*share_now + s286
        s312 = f3y_now_by*share_now + s288
        s314 = f3x_now_by*share_now + s290
        s321 = g1_z_now*s310 + g1_z_now_by*s744_now + g2_z_now*s298 + g2_z_now_by*s705_now
        s328 = g1_y_now*s310 + g1_y_now_by*s744_now + g2_y_now*s298 + g2_y_now_by*s705_now
        s335 = g1_z_now*s312 + g1_z_now_by*s749_now + g2_z_now*s300 + g2_z_now_by*s710_now
        s342 = g1_y_now*s312 + g1_y_now_by*s749_now + g2_y_now*s300 + g2_y_now_by*s710_now
        s349 = g1_z_now*s314 + g1_z_now_by*s754_now + g2_z_now*s302 + g2_z_now_by*s715_now
        s356 = g1_y_now*s314 + g1_y_now_by*s754_now + g2_y_now*s302 + g2_y_now_by*s715_now
        s365 = R0_33_now*s328 + R0_33_now_by*s764_now
        s368 = -R0_12_now*s349 - R0_12_now_by*s779_now
        s371 = -R0_22_now*s335 - R0_22_now_by*s769_now
        s374 = -R0_32_now*s321 - R0_32_now_by*s759_now
        s376 = s78_now*(R0_13_now*s356 + R0_13_now_by*s784_now + R0_23_now*s342 + R0_23_now_by*s774_now + s365 + s368 + s371 + s374)
        s385 = R0_22_now*s342 + R0_22_now_by*s774_now
        s388 = R0_23_now*s335 + R0_23_now_by*s769_now
        s391 = R0_32_now*s328 + R0_32_now_by*s764_now
        s394 = R0_33_now*s321 + R0_33_now_by*s759_now
        s395 = R0_12_now*s356 + R0_12_now_by*s784_now + R0_13_now*s349 + R0_13_now_by*s779_now + s385 + s388 + s391 + s394
        s396 = s292 + s304
        s403 = bz1_now_by*s720_now + bz2_now_by*s681_now + s128_now*s304 + s165_now*s292
        s410 = h1_y_now_by*s720_now + h2_y_now_by*s681_now + s126_now*s304 + s163_now*s292
        s417 = h1_x_now_by*s720_now + h2_x_now_by*s681_now + s124_now*s304 + s161_now*s292
        s418 = s294 + s306
        s425 = bz1_now_by*s727_now + bz2_now_by*s688_now + s128_now*s306 + s165_now*s294
        s432 = h1_y_now_by*s727_now + h2_y_now_by*s688_now + s126_now*s306 + s163_now*s294
        s439 = h1_x_now_by*s727_now + h2_x_now_by*s688_now + s124_now*s306 + s161_now*s294
        s440 = s296 + s308
        s447 = bz1_now_by*s734_now + bz2_now_by*s695_now + s128_now*s308 + s165_now*s296
        s454 = h1_y_now_by*s734_now + h2_y_now_by*s695_now + s126_now*s308 + s163_now*s296
        s461 = h1_x_now_by*s734_now + h2_x_now_by*s695_now + s124_now*s308 + s161_now*s296
        s463 = s376 - s395*s80_now
        s472 = R_23_now*s403 + R_23_now_by*s795_now
        s475 = -R_31_now*s439 - R_31_now_by*s801_now
        s478 = -R_32_now*s432 - R_32_now_by*s800_now
        s481 = -R_33_now*s425 - R_33_now_by*s799_now
        s482 = R_21_now*s417 + R_21_now_by*s797_now + R_22_now*s410 + R_22_now_by*s796_now + s472 + s475 + s478 + s481
        s491 = R_33_now*s447 + R_33_now_by*s803_now
        s494 = -R_11_now*s417 - R_11_now_by*s797_now
        s497 = -R_12_now*s410 - R_12_now_by*s796_now
        s500 = -R_13_now*s403 - R_13_now_by*s795_now
        s501 = R_31_now*s461 + R_31_now_by*s807_now + R_32_now*s454 + R_32_now_by*s805_now + s491 + s494 + s497 + s500
        s510 = R_13_now*s425 + R_13_now_by*s799_now
        s513 = -R_21_now*s461 - R_21_now_by*s807_now
        s516 = -R_22_now*s454 - R_22_now_by*s805_now
        s519 = -R_23_now*s447 - R_23_now_by*s803_now
        s520 = R_11_now*s439 + R_11_now_by*s801_now + R_12_now*s432 + R_12_now_by*s800_now + s510 + s513 + s516 + s519
        d_by[992 + lane] = s227
        d_by[1024 + lane] = s277
        d_by[1056 + lane] = s463
        d_by[1088 + lane] = s440
        d_by[1120 + lane] = s418
        d_by[1152 + lane] = s396
        d_by[1184 + lane] = s482
        d_by[1216 + lane] = s501
        d_by[1248 + lane] = s520


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
        s243_now = -R_21_now*w_z_now + R_31_now*w_y_now
        s246_now = -R_22_now*w_z_now + R_32_now*w_y_now
        s249_now = -R_23_now*w_z_now + R_33_now*w_y_now
        s252_now = R_11_now*w_z_now - R_31_now*w_x_now
        s255_now = R_12_now*w_z_now - R_32_now*w_x_now
        s258_now = R_13_now*w_z_now - R_33_now*w_x_now
        s261_now = -R_11_now*w_y_now + R_21_now*w_x_now
        s264_now = -R_12_now*w_y_now + R_22_now*w_x_now
        s267_now = -R_13_now*w_y_now + R_23_now*w_x_now
        s102 = -R_21_now*w_z_now_by - R_21_now_by*w_z_now + R_31_now*w_y_now_by + R_31_now_by*w_y_now
        s109 = -R_22_now*w_z_now_by - R_22_now_by*w_z_now + R_32_now*w_y_now_by + R_32_now_by*w_y_now
        s116 = -R_23_now*w_z_now_by - R_23_now_by*w_z_now + R_33_now*w_y_now_by + R_33_now_by*w_y_now
        s123 = R_11_now*w_z_now_by + R_11_now_by*w_z_now - R_31_now*w_x_now_by - R_31_now_by*w_x_now
        s130 = R_12_now*w_z_now_by + R_12_now_by*w_z_now - R_32_now*w_x_now_by - R_32_now_by*w_x_now
        s137 = R_13_now*w_z_now_by + R_13_now_by*w_z_now - R_33_now*w_x_now_by - R_33_now_by*w_x_now
        s144 = -R_11_now*w_y_now_by - R_11_now_by*w_y_now + R_21_now*w_x_now_by + R_21_now_by*w_x_now
        s151 = -R_12_now*w_y_now_by - R_12_now_by*w_y_now + R_22_now*w_x_now_by + R_22_now_by*w_x_now
        s158 = -R_13_now*w_y_now_by - R_13_now_by*w_y_now + R_23_now*w_x_now_by + R_23_now_by*w_x_now
        s170 = -s130*w_z_now - s255_now*w_z_now_by
        s171 = -R_22_now*w_z_t_now_by - R_22_now_by*w_z_t_now + R_32_now*w_y_t_now_by + R_32_now_by*w_y_t_now + s151*w_y_now + s170 + s264_now*w_y_now_by
        s184 = -s137*w_z_now - s258_now*w_z_now_by
        s185 = -R_23_now*w_z_t_now_by - R_23_now_by*w_z_t_now + R_33_now*w_y_t_now_by + R_33_now_by*w_y_t_now + s158*w_y_now + s184 + s267_now*w_y_now_by
        s198 = -s123*w_z_now - s252_now*w_z_now_by
        s199 = -R_21_now*w_z_t_now_by - R_21_now_by*w_z_t_now + R_31_now*w_y_t_now_by + R_31_now_by*w_y_t_now + s144*w_y_now + s198 + s261_now*w_y_now_by
        s213 = -s151*w_x_now - s264_now*w_x_now_by
        s214 = R_12_now*w_z_t_now_by + R_12_now_by*w_z_t_now - R_32_now*w_x_t_now_by - R_32_now_by*w_x_t_now + s109*w_z_now + s213 + s246_now*w_z_now_by
        s227 = -s158*w_x_now - s267_now*w_x_now_by
        s228 = R_13_now*w_z_t_now_by + R_13_now_by*w_z_t_now - R_33_now*w_x_t_now_by - R_33_now_by*w_x_t_now + s116*w_z_now + s227 + s249_now*w_z_now_by
        s241 = -s144*w_x_now - s261_now*w_x_now_by
        s242 = R_11_now*w_z_t_now_by + R_11_now_by*w_z_t_now - R_31_now*w_x_t_now_by - R_31_now_by*w_x_t_now + s102*w_z_now + s241 + s243_now*w_z_now_by
        s256 = -s109*w_y_now - s246_now*w_y_now_by
        s257 = -R_12_now*w_y_t_now_by - R_12_now_by*w_y_t_now + R_22_now*w_x_t_now_by + R_22_now_by*w_x_t_now + s130*w_x_now + s255_now*w_x_now_by + s256
        s270 = -s116*w_y_now - s249_now*w_y_now_by
        s271 = -R_13_now*w_y_t_now_by - R_13_now_by*w_y_t_now + R_23_now*w_x_t_now_by + R_23_now_by*w_x_t_now + s137*w_x_now + s258_now*w_x_now_by + s270
        s284 = -s102*w_y_now - s243_now*w_y_now_by
        s285 = -R_11_now*w_y_t_now_by - R_11_now_by*w_y_t_now + R_21_now*w_x_t_now_by + R_21_now_by*w_x_t_now + s123*w_x_now + s252_now*w_x_now_by + s284
        s288 = 0.001*s171*ty_now + 0.001*s185*tz_now + 0.001*s199*tx_now - 0.001*v_px_t_now_by
        s289 = 0.001*s214*ty_now + 0.001*s228*tz_now + 0.001*s242*tx_now - 0.001*v_py_t_now_by
        s290 = 0.001*s257*ty_now + 0.001*s271*tz_now + 0.001*s285*tx_now - 0.001*v_pz_t_now_by
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
        s195_now = -f0z_now*tz_now
        s197_now = -f0z_now*ty_now
        s199_now = -f0z_now*tx_now
        s201_now = -f0y_now*tz_now
        s203_now = -f0y_now*ty_now
        s205_now = -f0y_now*tx_now
        s207_now = -f0x_now*tz_now
        s209_now = -f0x_now*ty_now
        s211_now = -f0x_now*tx_now
        s30 = -f0z_now_by*tz_now
        s31 = -f0z_now_by*ty_now
        s32 = -f0z_now_by*tx_now
        s33 = -f0y_now_by*tz_now
        s34 = -f0y_now_by*ty_now
        s35 = -f0y_now_by*tx_now
        s36 = -f0x_now_by*tz_now
        s37 = -f0x_now_by*ty_now
        s38 = -f0x_now_by*tx_now
        s47 = R_23_now*s30 + R_23_now_by*s195_now
        s50 = -R_31_now*s35 - R_31_now_by*s205_now
        s53 = -R_32_now*s34 - R_32_now_by*s203_now
        s56 = -R_33_now*s33 - R_33_now_by*s201_now
        s57 = R_21_now*s32 + R_21_now_by*s199_now + R_22_now*s31 + R_22_now_by*s197_now + s47 + s50 + s53 + s56
        s66 = R_33_now*s36 + R_33_now_by*s207_now
        s69 = -R_11_now*s32 - R_11_now_by*s199_now
        s72 = -R_12_now*s31 - R_12_now_by*s197_now
        s75 = -R_13_now*s30 - R_13_now_by*s195_now
        s76 = R_31_now*s38 + R_31_now_by*s211_now + R_32_now*s37 + R_32_now_by*s209_now + s66 + s69 + s72 + s75
        s85 = R_13_now*s33 + R_13_now_by*s201_now
        s88 = -R_21_now*s38 - R_21_now_by*s211_now
        s91 = -R_22_now*s37 - R_22_now_by*s209_now
        s94 = -R_23_now*s36 - R_23_now_by*s207_now
        s95 = R_11_now*s35 + R_11_now_by*s205_now + R_12_now*s34 + R_12_now_by*s203_now + s85 + s88 + s91 + s94
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
    u_1, e_1 = w_by[0:3328], d_by[0 * OWN:1 * OWN]
    u_2, e_2 = w_by[3328:6656], d_by[1 * OWN:2 * OWN]
    u_3, e_3 = w_by[6656:9984], d_by[2 * OWN:3 * OWN]
    w, d, s = scratch(WORK), scratch(3 * OWN), scratch(SHARED)
    w_1 = w[0:3328]
    w_2 = w[3328:6656]
    w_3 = w[6656:9984]
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
