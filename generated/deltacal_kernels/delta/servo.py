"""Commands of one pose for a servo loop: `delta`, Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both 42bbb2ec5966f2d6; SymPy 1.14.0.

Numbers in, numbers out, for loops that Numba compiles and for calls from Python: an array, or a part of one, costs more
than a command. Lengths in mm, angles in rad. Target, machine and scratch stand in one flat array w, which `exact_state`
and `linear_state` make, `copied` for every thread: loops over `lane` run over the limbs, the last of them again so that
they are 4.
"""

import math
from functools import partial

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import aligned, arcsine, arctangent, copied, cosine, sine, tangent
from deltacal_kernels.straight import straight

from .vectorised import MAX_STEPS, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_CONSTANTS = 32  # what is exported reads these first columns of `vectorised.constants` only
LANES = np.int64(4)  # no literal: a loop whose end is known beforehand is unrolled, and not turned into SIMD code
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
fast = kernel(**OPTIONS)  # to let other threads run meanwhile would take longer than a command
few = partial(straight, wide=False)  # lanes: the limbs


def _exact_constants(p):
    """Return k (M, 3, 32), what no target changes, from p (298 operations).

    p is that of the calibrated machine.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((32, p.shape[1], 3))
    b = p[0]
    a = p[1]
    L = p[2]
    l = p[3]
    c = p[4]
    phi = p[5]
    theta = p[6]
    ex = p[7]
    ey = p[8]
    ez = p[9]
    dL = p[10]
    alpha0 = p[11]
    beta0 = p[12]
    dl_mean = p[13]
    dl = p[14]
    dc = p[15]
    alpha03 = p[16]
    beta03 = p[17]
    alpha2 = p[18]
    beta2 = p[19]
    tip_v = p[20]
    tip_w = p[21]
    s0 = (beta0 * beta0)
    s1 = (alpha0 * alpha0)
    s2 = s0 + s1
    s10 = s2*(s2*(s2*(1.5619206968586225e-16*s0 + 1.5619206968586225e-16*s1 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
    s18 = s2*(s2*(s2*(s2*(s10 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
    s19 = s18 + 0.5
    s20 = -s0*s19
    s21 = s20 + 1
    s22 = np.cos(phi)
    s31 = s2*(s2*(s2*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
    s39 = s2*(s2*(s2*(s2*(s31 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
    s40 = s39 + 1
    s41 = np.sin(phi)
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
    s159 = b*s22
    B_x = ex + s159
    s161 = b*s41
    B_y = ey + s161
    s219 = L + dL
    s223 = B_x + R0_13*tip_w
    s228 = B_y + R0_23*tip_w
    s233 = R0_33*tip_w + ez
    s235 = a*s22
    s238 = a*s41
    s253 = R0_13*g_z
    s257 = R0_23*g_z
    s261 = R0_33*g_z
    s281 = -ex - s159 + s235
    s283 = -s219*s22
    s285 = -ey - s161 + s238
    s287 = -s219*s41
    s306 = 0.5*(s219 * s219)*((s22 * s22) + (s41 * s41)) - 0.5*((dl_mean + l) * (dl_mean + l))
    s311 = -2*L - 2*dL
    s313 = 0.25*(s311 * s311)
    s318 = -0.5*s311
    s345 = -0.125*(dl * dl) - 0.5*(dl_mean * dl_mean) - dl_mean*l - 0.5*(l * l)
    s395 = -0.5*dl*dl_mean - 0.5*dl*l
    k[0] = s281
    k[1] = s283
    k[2] = s285
    k[3] = s287
    k[4] = ez
    k[5] = s306
    k[6] = s313
    k[7] = s318
    k[8] = theta
    k[9] = R0_11
    k[10] = R0_12
    k[11] = R0_21
    k[12] = R0_22
    k[13] = R0_31
    k[14] = R0_32
    k[15] = s219
    k[16] = tip_v
    k[17] = s223
    k[18] = s228
    k[19] = s233
    k[20] = s235
    k[21] = s238
    k[22] = g_x
    k[23] = g_y
    k[24] = s253
    k[25] = s257
    k[26] = s261
    k[27] = h_x
    k[28] = h_y
    k[29] = h_z
    k[30] = s345
    k[31] = s395
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _linear_constants(p):
    """Return k (M, 3, 32), what no target changes, from p (113 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((32, p.shape[1], 3))
    b = p[0]
    a = p[1]
    L = p[2]
    l = p[3]
    c = p[4]
    phi = p[5]
    theta = p[6]
    ex = p[7]
    ey = p[8]
    ez = p[9]
    dL = p[10]
    alpha0 = p[11]
    beta0 = p[12]
    dl_mean = p[13]
    dl = p[14]
    dc = p[15]
    alpha03 = p[16]
    beta03 = p[17]
    alpha2 = p[18]
    beta2 = p[19]
    tip_v = p[20]
    tip_w = p[21]
    R0_11 = np.cos(phi)
    by_s1 = np.sin(phi)
    R0_11_errors = -beta0*by_s1
    R0_12_errors = alpha0*by_s1
    R0_13 = np.sin(phi)
    R0_13_errors = R0_11*beta0
    R0_21 = np.sin(phi)
    R0_21_errors = R0_11*beta0
    R0_22_errors = -R0_11*alpha0
    R0_23_errors = beta0*by_s1
    g_x_errors = 0.5*beta2*c
    g_y_errors = -0.5*alpha2*c
    g_z = 0.5*c
    g_z_errors = 0.5*dc
    h_x = 0.5*by_s1*c
    by_s15 = 0.5*R0_11*beta0*c
    by_s16 = -0.5*R0_11*beta03*c
    h_x_errors = by_s15 + by_s16
    h_y = -0.5*R0_11*c
    by_s19 = 0.5*beta0*by_s1*c
    by_s20 = -0.5*beta03*by_s1*c
    h_y_errors = by_s19 + by_s20
    by_s22 = 0.5*alpha03*c
    by_s23 = -0.5*alpha0*c
    h_z_errors = by_s22 + by_s23
    B_x = R0_11*b
    B_y = b*by_s1
    s49 = L*R0_11
    by_s55 = R0_13*tip_w
    by_s56 = by_s55 + ex
    s57 = L*R0_11_errors + R0_11*dL
    s62 = -L*R0_11*theta + L*R0_12_errors - R0_11*tip_v
    s65 = L*R0_21
    by_s64 = -R0_11*tip_w
    by_s65 = by_s64 + ey
    s73 = L*R0_21_errors + R0_21*dL
    s78 = -L*R0_21*theta + L*R0_22_errors - R0_21*tip_v
    s84 = L*theta + tip_v
    by_s73 = R0_11*a
    by_s75 = a*by_s1
    by_s83 = R0_13*g_z_errors
    by_s84 = R0_13_errors*g_z
    by_s85 = by_s83 + by_s84
    s99 = R0_11*g_x_errors
    s101 = -R0_11*g_y_errors
    by_s90 = -R0_11*g_z_errors
    by_s91 = R0_23_errors*g_z
    by_s92 = by_s90 + by_s91
    s108 = R0_21*g_x_errors
    s110 = -R0_21*g_y_errors
    by_s96 = -alpha0*g_z
    s117 = -B_x + by_s73
    s119 = -B_y + by_s75
    s122 = -by_s85 + h_x_errors
    s124 = -by_s92 + h_y_errors
    s126 = -by_s96 + h_z_errors
    s131 = -L*by_s1
    s143 = (L * L)
    s148 = -0.5*(l * l) + 0.5*s143*((R0_11 * R0_11) + (by_s1 * by_s1))
    s172 = -dl_mean*l
    s190 = -0.5*dl*l
    k[0] = s117
    k[1] = s49
    k[2] = s119
    k[3] = s131
    k[4] = s148
    k[5] = s143
    k[6] = L
    k[7] = s57
    k[8] = s62
    k[9] = by_s56
    k[10] = s65
    k[11] = s73
    k[12] = s78
    k[13] = by_s65
    k[14] = s84
    k[15] = dL
    k[16] = ez
    k[17] = by_s73
    k[18] = by_s75
    k[19] = s99
    k[20] = s101
    k[21] = s108
    k[22] = s110
    k[23] = g_y_errors
    k[24] = g_x_errors
    k[25] = s122
    k[26] = s124
    k[27] = s126
    k[28] = s172
    k[29] = s190
    k[30] = h_y
    k[31] = h_x
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def linear_constants(p):
    """Return k (M, 3, 35), what `linear` reads that no pose changes, from p (81 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((35, p.shape[1], 3))
    b = p[0]
    a = p[1]
    L = p[2]
    l = p[3]
    c = p[4]
    phi = p[5]
    theta = p[6]
    ex = p[7]
    ey = p[8]
    ez = p[9]
    dL = p[10]
    alpha0 = p[11]
    beta0 = p[12]
    dl_mean = p[13]
    dl = p[14]
    dc = p[15]
    alpha03 = p[16]
    beta03 = p[17]
    alpha2 = p[18]
    beta2 = p[19]
    tip_v = p[20]
    tip_w = p[21]
    R0_11 = np.cos(phi)
    s1 = np.sin(phi)
    R0_11_errors = -beta0*s1
    R0_12_errors = alpha0*s1
    R0_13 = np.sin(phi)
    R0_13_errors = R0_11*beta0
    R0_21 = np.sin(phi)
    R0_21_errors = R0_11*beta0
    R0_22_errors = -R0_11*alpha0
    R0_23_errors = beta0*s1
    g_x_errors = 0.5*beta2*c
    g_y_errors = -0.5*alpha2*c
    g_z = 0.5*c
    g_z_errors = 0.5*dc
    h_x = 0.5*c*s1
    h_x_errors = 0.5*R0_11*beta0*c - 0.5*R0_11*beta03*c
    h_y = -0.5*R0_11*c
    h_y_errors = 0.5*beta0*c*s1 - 0.5*beta03*c*s1
    h_z_errors = -0.5*alpha0*c + 0.5*alpha03*c
    B_x = R0_11*b
    B_y = b*s1
    s58 = R0_13*tip_w + ex
    s67 = -R0_11*tip_w + ey
    s75 = R0_11*a
    s77 = a*s1
    s87 = R0_13*g_z_errors + R0_13_errors*g_z
    s94 = -R0_11*g_z_errors + R0_23_errors*g_z
    s98 = -alpha0*g_z
    s106 = -B_x + s75
    s108 = -L*R0_11
    s110 = -B_y + s77
    s112 = -L*s1
    s124 = (L * L)
    s129 = -0.5*(l * l) + 0.5*s124*((R0_11 * R0_11) + (s1 * s1))
    s148 = -dl_mean*l
    s149 = -0.5*dl*l
    s150 = s148 + s149
    s169 = s148 - s149
    k[0] = s106
    k[1] = s108
    k[2] = s110
    k[3] = s112
    k[4] = s129
    k[5] = s124
    k[6] = L
    k[7] = R0_11
    k[8] = R0_11_errors
    k[9] = R0_12_errors
    k[10] = theta
    k[11] = R0_21
    k[12] = R0_21_errors
    k[13] = R0_22_errors
    k[14] = B_x
    k[15] = dL
    k[16] = tip_v
    k[17] = s58
    k[18] = B_y
    k[19] = s67
    k[20] = ez
    k[21] = s75
    k[22] = s77
    k[23] = g_x_errors
    k[24] = g_y_errors
    k[25] = s87
    k[26] = s94
    k[27] = s98
    k[28] = h_x_errors
    k[29] = h_y_errors
    k[30] = h_z_errors
    k[31] = s150
    k[32] = h_y
    k[33] = h_x
    k[34] = s169
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def exact_state(p, tool, sign):
    """Return the array w of `exact_command` for a machine: p (3, 22), tool (3,), sign (3,) of the controller's joints."""
    w = aligned(232)
    w[20:23], w[24:27] = tool, sign
    k = _exact_constants(p[None])[0]
    w[104:232].reshape(-1, 4)[:] = np.pad(k, ((0, 1), (0, 0)), mode="edge").T
    return w


def linear_state(p, tool, sign):
    """Return the array w of `linear_command` for a machine: p (3, 22), tool (3,), sign (3,) of the controller's joints."""
    w = aligned(232)
    w[20:23], w[24:27] = tool, sign
    k = _linear_constants(p[None])[0]
    w[104:232].reshape(-1, 4)[:] = np.pad(k, ((0, 1), (0, 0)), mode="edge").T
    return w


@few
def _exact_joint(w, lanes):
    """Joint of the simplified limb at the target, then the platform's coordinates that follow from it (36 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s281 = w[104 + lane]
        s283 = w[108 + lane]
        s285 = w[112 + lane]
        s287 = w[116 + lane]
        ez = w[120 + lane]
        s306 = w[124 + lane]
        s313 = w[128 + lane]
        s318 = w[132 + lane]
        theta = w[136 + lane]
        s282 = px + s281 - tx
        s286 = py + s285 - ty
        s289 = s282*s283 + s286*s287
        s291 = -ez + pz - tz
        s292 = (s291 * s291)
        s307 = 0.5*(s282 * s282) + 0.5*(s286 * s286) + 0.5*s292 + s306
        s316 = math.sqrt((s289 * s289) + s292*s313 - (s307 * s307))
        s325 = -theta + arctangent(-s289*s316 + s291*s307*s318, -s289*s307 - s291*s316*s318)
        w[36 + lane] = s325


@few
def _exact_rows(w, lanes):
    """Equations of a limb, their derivatives by turns of the platform and by the joint (210 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    R_11 = w[8]
    R_12 = w[9]
    R_13 = w[10]
    R_21 = w[11]
    R_22 = w[12]
    R_23 = w[13]
    R_31 = w[14]
    R_32 = w[15]
    R_33 = w[16]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        theta = w[136 + lane]
        R0_11 = w[140 + lane]
        R0_12 = w[144 + lane]
        R0_21 = w[148 + lane]
        R0_22 = w[152 + lane]
        R0_31 = w[156 + lane]
        R0_32 = w[160 + lane]
        s219 = w[164 + lane]
        tip_v = w[168 + lane]
        s223 = w[172 + lane]
        s228 = w[176 + lane]
        s233 = w[180 + lane]
        s235 = w[184 + lane]
        s238 = w[188 + lane]
        g_x = w[192 + lane]
        g_y = w[196 + lane]
        s253 = w[200 + lane]
        s257 = w[204 + lane]
        s261 = w[208 + lane]
        h_x = w[212 + lane]
        h_y = w[216 + lane]
        h_z = w[220 + lane]
        s345 = w[224 + lane]
        s395 = w[228 + lane]
        q = w[36 + lane]
        s163 = q + theta
        s164 = cosine(s163)
        s166 = sine(s163)
        R1_11 = R0_11*s164 + R0_12*s166
        R1_12 = -R0_11*s166 + R0_12*s164
        R1_21 = R0_21*s164 + R0_22*s166
        R1_22 = -R0_21*s166 + R0_22*s164
        R1_31 = R0_31*s164 + R0_32*s166
        R1_32 = -R0_31*s166 + R0_32*s164
        C_x = R1_11*s219 + R1_12*tip_v + s223
        C_y = R1_21*s219 + R1_22*tip_v + s228
        C_z = R1_31*s219 + R1_32*tip_v + s233
        s236 = s235 - tx
        s237 = R_11*s236
        s239 = s238 - ty
        s240 = R_12*s239
        s241 = -R_13*tz
        A_x = px + s237 + s240 + s241
        s243 = R_21*s236
        s244 = R_22*s239
        s245 = -R_23*tz
        A_y = py + s243 + s244 + s245
        s247 = R_31*s236
        s248 = R_32*s239
        s249 = -R_33*tz
        A_z = pz + s247 + s248 + s249
        c1_x = R1_11*g_x + R1_12*g_y + s253
        c1_y = R1_21*g_x + R1_22*g_y + s257
        c1_z = R1_31*g_x + R1_32*g_y + s261
        a1_x = R_11*h_x + R_12*h_y + R_13*h_z
        a1_y = R_21*h_x + R_22*h_y + R_23*h_z
        a1_z = R_31*h_x + R_32*h_y + R_33*h_z
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = a1_x - c1_x
        s_y = a1_y - c1_y
        s_z = a1_z - c1_z
        s326 = (d_x * d_x)
        s328 = (d_y * d_y)
        s330 = (d_z * d_z)
        s335 = 0.5*(s_y * s_y)
        s337 = 0.5*(s_z * s_z)
        s346 = 0.5*s326 + 0.5*s328 + 0.5*s330 + s335 + s337 + s345 + 0.5*(s_x * s_x)
        s347 = -s247 - s248 - s249
        s349 = s243 + s244 + s245
        s353 = a1_y*s_z - a1_z*s_y + d_y*s347 + d_z*s349
        s355 = -s237 - s240 - s241
        s359 = -a1_x*s_z + a1_z*s_x - d_x*s347 + d_z*s355
        s364 = a1_x*s_y - a1_y*s_x - d_x*s349 - d_y*s355
        s367 = R1_11*tip_v - R1_12*s219
        s371 = R1_21*tip_v - R1_22*s219
        s375 = R1_31*tip_v - R1_32*s219
        s379 = R1_11*g_y - R1_12*g_x
        s383 = R1_21*g_y - R1_22*g_x
        s387 = R1_31*g_y - R1_32*g_x
        s389 = d_x*s367 + d_y*s371 + d_z*s375 + s379*s_x + s383*s_y + s387*s_z
        s396 = d_x*s_x + d_y*s_y + d_z*s_z + s395
        s401 = a1_y*d_z - a1_z*d_y + s347*s_y + s349*s_z
        s406 = -a1_x*d_z + a1_z*d_x - s347*s_x + s355*s_z
        s411 = a1_x*d_y - a1_y*d_x - s349*s_x - s355*s_y
        s418 = d_x*s379 + d_y*s383 + d_z*s387 + s367*s_x + s371*s_y + s375*s_z
        s423 = -1.0e-12*s326 - 1.0e-12*s328 - 1.0e-12*s330 + (s389 * s389)
        w[60 + lane] = s346
        w[64 + lane] = s353
        w[68 + lane] = s359
        w[72 + lane] = s364
        w[76 + lane] = s389
        w[80 + lane] = s396
        w[84 + lane] = s401
        w[88 + lane] = s406
        w[92 + lane] = s411
        w[96 + lane] = s418
        w[100 + lane] = s423


@few
def _exact_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (122 operations)."""
    F00 = w[60]
    J00_3 = w[64]
    J00_4 = w[68]
    J00_5 = w[72]
    Q00 = w[76]
    F01 = w[80]
    J01_3 = w[84]
    J01_4 = w[88]
    J01_5 = w[92]
    Q01 = w[96]
    F10 = w[61]
    J10_3 = w[65]
    J10_4 = w[69]
    J10_5 = w[73]
    Q10 = w[77]
    F11 = w[81]
    J11_3 = w[85]
    J11_4 = w[89]
    J11_5 = w[93]
    Q11 = w[97]
    F20 = w[62]
    J20_3 = w[66]
    J20_4 = w[70]
    J20_5 = w[74]
    Q20 = w[78]
    F21 = w[82]
    J21_3 = w[86]
    J21_4 = w[90]
    J21_5 = w[94]
    Q21 = w[98]
    by_00 = (1.0 / Q00)
    by_10 = (1.0 / Q10)
    by_20 = (1.0 / Q20)
    ratio_00 = Q01*by_00
    ratio_10 = Q11*by_10
    ratio_20 = Q21*by_20
    E_00 = -J00_3*ratio_00 + J01_3
    E_01 = -J00_4*ratio_00 + J01_4
    E_02 = -J00_5*ratio_00 + J01_5
    E_10 = -J10_3*ratio_10 + J11_3
    E_11 = -J10_4*ratio_10 + J11_4
    E_12 = -J10_5*ratio_10 + J11_5
    E_20 = -J20_3*ratio_20 + J21_3
    E_21 = -J20_4*ratio_20 + J21_4
    E_22 = -J20_5*ratio_20 + J21_5
    E_cof_00 = E_11*E_22 - E_12*E_21
    E_cof_01 = -E_10*E_22 + E_12*E_20
    E_cof_02 = E_10*E_21 - E_11*E_20
    E_cof_10 = -E_01*E_22 + E_02*E_21
    E_cof_11 = E_00*E_22 - E_02*E_20
    E_cof_12 = -E_00*E_21 + E_01*E_20
    E_cof_20 = E_01*E_12 - E_02*E_11
    E_cof_21 = -E_00*E_12 + E_02*E_10
    E_cof_22 = E_00*E_11 - E_01*E_10
    E_det_00 = E_00*E_cof_00 + E_01*E_cof_01 + E_02*E_cof_02
    E_by_00 = (1.0 / E_det_00)
    s57 = -F00*ratio_00 + F01
    s60 = -F10*ratio_10 + F11
    s63 = -F20*ratio_20 + F21
    w_00 = E_by_00*(E_cof_00*s57 + E_cof_10*s60 + E_cof_20*s63)
    w_10 = E_by_00*(E_cof_01*s57 + E_cof_11*s60 + E_cof_21*s63)
    w_20 = E_by_00*(E_cof_02*s57 + E_cof_12*s60 + E_cof_22*s63)
    s81 = by_00*(F00 - J00_3*w_00 - J00_4*w_10 - J00_5*w_20)
    s86 = by_10*(F10 - J10_3*w_00 - J10_4*w_10 - J10_5*w_20)
    s91 = by_20*(F20 - J20_3*w_00 - J20_4*w_10 - J20_5*w_20)
    s100 = (E_10 * E_10) + (E_11 * E_11) + (E_12 * E_12)
    s104 = (E_20 * E_20) + (E_21 * E_21) + (E_22 * E_22)
    s106 = (E_det_00 * E_det_00) - 1.0e-12*s100*s104*((E_00 * E_00) + (E_01 * E_01) + (E_02 * E_02))
    w[28] = s81
    w[29] = s86
    w[30] = s91
    w[31] = w_00
    w[32] = w_10
    w[33] = w_20
    w[34] = s106


@few
def _exact_move(w):
    """The platform after a step, and its rotation matrix (86 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    cx = w[3]
    cy = w[4]
    cz = w[5]
    y3 = w[31]
    y4 = w[32]
    y5 = w[33]
    s4 = 0.5*cz
    s5 = 0.25*cx*cy
    s8 = -0.5*cy
    s9 = 0.25*cx*cz
    new_30 = cx - y3*(0.25*(cx * cx) + 1) - y4*(s4 + s5) - y5*(s8 + s9)
    s19 = 0.5*cx
    s20 = 0.25*cy*cz
    new_40 = cy - y3*(-s4 + s5) - y4*(0.25*(cy * cy) + 1) - y5*(s19 + s20)
    new_50 = cz - y3*(-s8 + s9) - y4*(-s19 + s20) - y5*(0.25*(cz * cz) + 1)
    s33 = (new_30 * new_30)
    s35 = (new_40 * new_40)
    s37 = (new_50 * new_50)
    s40 = (1.0 / (0.25*s33 + 0.25*s35 + 0.25*s37 + 1))
    s41 = -0.5*s35
    s42 = -0.5*s37
    s45 = s40*(s41 + s42) + 1
    s46 = 0.5*new_30*new_40
    s48 = s40*(-new_50 + s46)
    s49 = 0.5*new_30*new_50
    s51 = s40*(new_40 + s49)
    s53 = s40*(new_50 + s46)
    s54 = -0.5*s33
    s57 = s40*(s42 + s54) + 1
    s58 = 0.5*new_40*new_50
    s60 = s40*(-new_30 + s58)
    s62 = s40*(-new_40 + s49)
    s64 = s40*(new_30 + s58)
    s67 = s40*(s41 + s54) + 1
    w[0] = px
    w[1] = py
    w[2] = pz
    w[3] = new_30
    w[4] = new_40
    w[5] = new_50
    w[8] = s45
    w[9] = s48
    w[10] = s51
    w[11] = s53
    w[12] = s57
    w[13] = s60
    w[14] = s62
    w[15] = s64
    w[16] = s67


@fast
def _exact(px, py, pz, w):
    w[0] = px
    w[1] = py
    w[2] = pz
    _exact_joint(w, LANES)
    w[3] = 0.0
    w[31] = 0.0
    w[4] = 0.0
    w[32] = 0.0
    w[5] = 0.0
    w[33] = 0.0
    status = UNREACHABLE
    if (abs(w[36]) < math.inf) & (abs(w[37]) < math.inf) & (abs(w[38]) < math.inf):
        _exact_move(w)
        for _ in range(MAX_STEPS):
            _exact_rows(w, LANES)
            _exact_solution(w)
            if not ((w[34] > 0.0) & (w[100] > 0.0) & (w[101] > 0.0) & (w[102] > 0.0)):
                status = SINGULAR
                break
            size = 0.0
            for j in range(6):
                size = max(size, abs(w[28 + j]))
            for i in range(3):
                w[36 + i] -= w[28 + i]
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
            _exact_move(w)
    if status != SOLVED:
        for i in range(3):
            w[36 + i] = np.nan
    return status


@fast
def exact_command(px, py, pz, w):
    """Return the joints that bring the reference point to a target, as the controller counts them; NaN where there are none.

    `inverse` for one pose, w from `exact_state`.
    """
    _exact(px, py, pz, w)
    return w[24] * w[36], w[25] * w[37], w[26] * w[38]


@few
def _linear_joint(w, lanes):
    """Joint of the nominal limb at the target, its cosine and sine (42 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s117 = w[104 + lane]
        s49 = w[108 + lane]
        s119 = w[112 + lane]
        s131 = w[116 + lane]
        s148 = w[120 + lane]
        s143 = w[124 + lane]
        L = w[128 + lane]
        A_z = pz - tz
        s128 = px + s117 - tx
        s130 = py + s119 - ty
        s133 = -s128*s49 + s130*s131
        s135 = (A_z * A_z)
        s149 = 0.5*(s128 * s128) + 0.5*(s130 * s130) + 0.5*s135 + s148
        s153 = math.sqrt((s133 * s133) + s135*s143 - (s149 * s149))
        s156 = A_z*L*s149 - s133*s153
        s159 = -A_z*L*s153 - s133*s149
        s160 = arctangent(s156, s159)
        s164 = 1/math.sqrt((s156 * s156) + (s159 * s159))
        s165 = s159*s164
        s166 = s156*s164
        w[36 + lane] = s160
        w[52 + lane] = s165
        w[56 + lane] = s166


@few
def _linear_angle(w, lanes):
    """Cosine and sine of the joint (2 operations)."""
    for lane in range(lanes):
        q = w[36 + lane]
        s167 = cosine(q)
        s168 = sine(q)
        w[52 + lane] = s167
        w[56 + lane] = s168


@few
def _linear_rows(w, lanes):
    """Equations of a nominal limb: change by all errors, derivatives by rotation and joint (86 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s117 = w[104 + lane]
        s49 = w[108 + lane]
        s119 = w[112 + lane]
        L = w[128 + lane]
        s57 = w[132 + lane]
        s62 = w[136 + lane]
        by_s56 = w[140 + lane]
        s65 = w[144 + lane]
        s73 = w[148 + lane]
        s78 = w[152 + lane]
        by_s65 = w[156 + lane]
        s84 = w[160 + lane]
        dL = w[164 + lane]
        ez = w[168 + lane]
        by_s73 = w[172 + lane]
        by_s75 = w[176 + lane]
        s99 = w[180 + lane]
        s101 = w[184 + lane]
        s108 = w[188 + lane]
        s110 = w[192 + lane]
        g_y_errors = w[196 + lane]
        g_x_errors = w[200 + lane]
        s122 = w[204 + lane]
        s124 = w[208 + lane]
        s126 = w[212 + lane]
        s172 = w[216 + lane]
        s190 = w[220 + lane]
        h_y = w[224 + lane]
        h_x = w[228 + lane]
        cos_q = w[52 + lane]
        sin_q = w[56 + lane]
        C_x_q = -s49*sin_q
        C_x_errors = by_s56 + cos_q*s57 + s62*sin_q
        C_y_q = -s65*sin_q
        C_y_errors = by_s65 + cos_q*s73 + s78*sin_q
        by_s67 = L*sin_q
        C_z_q = L*cos_q
        C_z_errors = cos_q*s84 + dL*sin_q + ez
        by_s74 = by_s73 - tx
        by_s76 = by_s75 - ty
        d_x = -cos_q*s49 + px + s117 - tx
        d_y = -cos_q*s65 + py + s119 - ty
        d_z = -by_s67 + pz - tz
        s_x_errors = -cos_q*s99 - s101*sin_q + s122
        s_y_errors = -cos_q*s108 - s110*sin_q + s124
        s_z_errors = -cos_q*g_y_errors - g_x_errors*sin_q + s126
        s173 = -C_x_errors*d_x - C_y_errors*d_y - C_z_errors*d_z + s172
        s176 = by_s76*d_z + d_y*tz
        s179 = -by_s74*d_z - d_x*tz
        s182 = by_s74*d_y - by_s76*d_x
        s186 = -C_x_q*d_x - C_y_q*d_y - C_z_q*d_z
        s191 = d_x*s_x_errors + d_y*s_y_errors + d_z*s_z_errors + s190
        s192 = d_z*h_y
        s193 = -d_z*h_x
        s196 = -d_x*h_y + d_y*h_x
        s204 = -1.0e-12*(d_x * d_x) - 1.0e-12*(d_y * d_y) - 1.0e-12*(d_z * d_z) + (s186 * s186)
        w[60 + lane] = s173
        w[64 + lane] = s176
        w[68 + lane] = s179
        w[72 + lane] = s182
        w[76 + lane] = s186
        w[80 + lane] = s191
        w[84 + lane] = s192
        w[88 + lane] = s193
        w[92 + lane] = s196
        w[100 + lane] = s204


@few
def _linear_solution(w):
    """Changes that undo the closures while the target is kept; how far the equations are from dependent (95 operations)."""
    F00 = w[60]
    J00_3 = w[64]
    J00_4 = w[68]
    J00_5 = w[72]
    Q00 = w[76]
    F01 = w[80]
    J01_3 = w[84]
    J01_4 = w[88]
    J01_5 = w[92]
    F10 = w[61]
    J10_3 = w[65]
    J10_4 = w[69]
    J10_5 = w[73]
    Q10 = w[77]
    F11 = w[81]
    J11_3 = w[85]
    J11_4 = w[89]
    J11_5 = w[93]
    F20 = w[62]
    J20_3 = w[66]
    J20_4 = w[70]
    J20_5 = w[74]
    Q20 = w[78]
    F21 = w[82]
    J21_3 = w[86]
    J21_4 = w[90]
    J21_5 = w[94]
    by_00 = (1.0 / Q00)
    by_10 = (1.0 / Q10)
    by_20 = (1.0 / Q20)
    E_cof_00 = J11_4*J21_5 - J11_5*J21_4
    E_cof_01 = -J11_3*J21_5 + J11_5*J21_3
    E_cof_02 = J11_3*J21_4 - J11_4*J21_3
    E_cof_10 = -J01_4*J21_5 + J01_5*J21_4
    E_cof_11 = J01_3*J21_5 - J01_5*J21_3
    E_cof_12 = -J01_3*J21_4 + J01_4*J21_3
    E_cof_20 = J01_4*J11_5 - J01_5*J11_4
    E_cof_21 = -J01_3*J11_5 + J01_5*J11_3
    E_cof_22 = J01_3*J11_4 - J01_4*J11_3
    E_det_00 = E_cof_00*J01_3 + E_cof_01*J01_4 + E_cof_02*J01_5
    E_by_00 = (1.0 / E_det_00)
    w_00 = E_by_00*(E_cof_00*F01 + E_cof_10*F11 + E_cof_20*F21)
    w_10 = E_by_00*(E_cof_01*F01 + E_cof_11*F11 + E_cof_21*F21)
    w_20 = E_by_00*(E_cof_02*F01 + E_cof_12*F11 + E_cof_22*F21)
    s54 = by_00*(F00 - J00_3*w_00 - J00_4*w_10 - J00_5*w_20)
    s59 = by_10*(F10 - J10_3*w_00 - J10_4*w_10 - J10_5*w_20)
    s64 = by_20*(F20 - J20_3*w_00 - J20_4*w_10 - J20_5*w_20)
    s73 = (J11_3 * J11_3) + (J11_4 * J11_4) + (J11_5 * J11_5)
    s77 = (J21_3 * J21_3) + (J21_4 * J21_4) + (J21_5 * J21_5)
    s79 = (E_det_00 * E_det_00) - 1.0e-12*s73*s77*((J01_3 * J01_3) + (J01_4 * J01_4) + (J01_5 * J01_5))
    w[28] = s54
    w[29] = s59
    w[30] = s64
    w[34] = s79


@fast
def _linear(px, py, pz, w):
    w[0] = px
    w[1] = py
    w[2] = pz
    _linear_joint(w, LANES)
    _linear_rows(w, LANES)
    _linear_solution(w)
    status = (SOLVED if (w[34] > 0.0) & (w[100] > 0.0) & (w[101] > 0.0) & (w[102] > 0.0) else SINGULAR) if (abs(w[36]) < math.inf) & (abs(w[37]) < math.inf) & (abs(w[38]) < math.inf) else UNREACHABLE
    w[36] = w[36] - w[28] if status == SOLVED else np.nan
    w[37] = w[37] - w[29] if status == SOLVED else np.nan
    w[38] = w[38] - w[30] if status == SOLVED else np.nan
    return status


@fast
def linear_command(px, py, pz, w):
    """Return the joints that bring the reference point to a target to first order in the errors, like `exact_command`.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. w from `linear_state`.
    """
    _linear(px, py, pz, w)
    return w[24] * w[36], w[25] * w[37], w[26] * w[38]


@fast
def linear_change(px, py, pz, q_1, q_2, q_3, w):
    """Return what to add to the nominal joints of a target, both as the controller counts them; NaN where it is singular.

    For a controller that has nominal joints already: what `linear_command` adds to them.
    """
    w[0] = px
    w[1] = py
    w[2] = pz
    w[36] = w[24] * q_1
    w[37] = w[25] * q_2
    w[38] = w[26] * q_3
    w[39] = w[26] * q_3
    _linear_angle(w, LANES)
    _linear_rows(w, LANES)
    _linear_solution(w)
    back = -1.0 if (w[34] > 0.0) & (w[100] > 0.0) & (w[101] > 0.0) & (w[102] > 0.0) else np.nan
    return back * w[24] * w[28], back * w[25] * w[29], back * w[26] * w[30]


@kernel(nogil=True, **OPTIONS)
def linear_commands(target, tool, w, q, status):
    """Fill q (N, 3), as the geometry counts, and status (N,) by `linear_command`; target (N, 3), tool (N or 1, 3)."""
    for n in range(target.shape[0]):
        if n == 0 or tool.shape[0] > 1:
            for c in range(3):
                w[20 + c] = tool[n, c]
        status[n] = _linear(target[n, 0], target[n, 1], target[n, 2], w)
        for i in range(3):
            q[n, i] = w[36 + i]
