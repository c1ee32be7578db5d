"""Dynamics of `complete_delta`, many samples at once: Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/dynamics.py.jinja; sha256 of both 7aa70f236a6f5d50; SymPy 1.14.0.

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
