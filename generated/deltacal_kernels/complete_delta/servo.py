"""Commands of one pose for a servo loop: `complete_delta`, Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both b319890caad4d5b4; SymPy 1.14.0.

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
COMMAND_CONSTANTS = 31  # what is exported reads these first columns of `vectorised.constants` only
LANES = np.int64(4)  # no literal: a loop whose end is known beforehand is unrolled, and not turned into SIMD code
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
fast = kernel(**OPTIONS)  # to let other threads run meanwhile would take longer than a command
few = partial(straight, wide=False)  # lanes: the limbs


def _exact_constants(p):
    """Return k (M, 3, 31), what no target changes, from p (180 operations).

    p is that of the calibrated machine.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((31, p.shape[1], 3))
    b = p[0]
    a = p[1]
    L = p[2]
    l = p[3]
    c = p[4]
    phi = p[5]
    bx1 = p[6]
    by1 = p[7]
    bz1 = p[8]
    ax1 = p[9]
    ay1 = p[10]
    az1 = p[11]
    dl1 = p[12]
    bx2 = p[13]
    by2 = p[14]
    bz2 = p[15]
    ax2 = p[16]
    ay2 = p[17]
    az2 = p[18]
    dl2 = p[19]
    betax = p[20]
    betay = p[21]
    betaz = p[22]
    tip_v = p[23]
    tip_w = p[24]
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
    s25 = np.sin(phi)
    s33 = s3*(s3*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 + 2.8114572543455206e-15*s2 - 7.647163731819816e-13) + 1.6059043836821613e-10)
    s41 = s3*(s3*(s3*(s3*(s33 - 2.505210838544172e-08) + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333)
    s44 = s3*(s41 - 0.16666666666666666) + 1
    s45 = -betaz*s44
    s46 = betax*betay*s21
    s47 = s45 + s46
    s48 = np.cos(phi)
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
    s133 = 0.5*c
    g1_x = ax1 + s133 + tip_w
    g1_y = L + ay1
    g1_z = az1 + tip_v
    s137 = a*s48
    s138 = 0.5*c*s25
    h1_x = bx1 + s137 + s138
    s140 = a*s25
    s141 = -0.5*c*s48
    h1_y = by1 + s140 + s141
    s146 = b*s48
    s147 = R0_11*g1_x + s146
    s152 = b*s25
    s153 = R0_21*g1_x + s152
    s155 = R0_31*g1_x
    g2_x = ax2 - s133 + tip_w
    g2_y = L + ay2
    g2_z = az2 + tip_v
    h2_x = bx2 + s137 - s138
    h2_y = by2 + s140 - s141
    s185 = R0_11*g2_x + s146
    s190 = R0_21*g2_x + s152
    s192 = R0_31*g2_x
    s214 = s137 - s146
    s216 = -L*s48
    s218 = s140 - s152
    s220 = -L*s25
    s232 = -0.5*(l * l)
    s233 = (L * L)
    s238 = s232 + 0.5*s233*((s25 * s25) + (s48 * s48))
    s252 = -0.25*(dl1 * dl1)
    s254 = -0.25*(dl2 * dl2)
    s267 = -0.5*dl1*l
    s268 = -0.5*dl2*l
    s269 = s232 + s252 + s254 + s267 + s268
    s317 = s252 - s254 + s267 - s268
    k[0] = s214
    k[1] = s216
    k[2] = s218
    k[3] = s220
    k[4] = s238
    k[5] = s233
    k[6] = L
    k[7] = R0_12
    k[8] = R0_13
    k[9] = R0_22
    k[10] = R0_23
    k[11] = R0_32
    k[12] = R0_33
    k[13] = g1_y
    k[14] = g1_z
    k[15] = s147
    k[16] = s153
    k[17] = s155
    k[18] = h1_x
    k[19] = h1_y
    k[20] = bz1
    k[21] = g2_y
    k[22] = g2_z
    k[23] = s185
    k[24] = s190
    k[25] = s192
    k[26] = h2_x
    k[27] = h2_y
    k[28] = bz2
    k[29] = s269
    k[30] = s317
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _linear_constants(p):
    """Return k (M, 3, 39), what no target changes, from p (122 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((39, p.shape[1], 3))
    b = p[0]
    a = p[1]
    L = p[2]
    l = p[3]
    c = p[4]
    phi = p[5]
    bx1 = p[6]
    by1 = p[7]
    bz1 = p[8]
    ax1 = p[9]
    ay1 = p[10]
    az1 = p[11]
    dl1 = p[12]
    bx2 = p[13]
    by2 = p[14]
    bz2 = p[15]
    ax2 = p[16]
    ay2 = p[17]
    az2 = p[18]
    dl2 = p[19]
    betax = p[20]
    betay = p[21]
    betaz = p[22]
    tip_v = p[23]
    tip_w = p[24]
    R0_11 = np.sin(phi)
    by_s1 = np.cos(phi)
    R0_11_errors = betaz*by_s1
    R0_12 = np.cos(phi)
    R0_12_errors = -R0_11*betaz
    R0_21_errors = R0_11*betaz
    R0_22 = np.sin(phi)
    R0_22_errors = betaz*by_s1
    by_s8 = -betax*by_s1
    by_s9 = -R0_11*betay
    R0_31_errors = by_s8 + by_s9
    by_s11 = R0_11*betax
    by_s12 = -betay*by_s1
    R0_32_errors = by_s11 + by_s12
    g1_x = 0.5*c
    g1_x_errors = ax1 + tip_w
    g1_z_errors = az1 + tip_v
    by_s35 = a*by_s1
    by_s36 = 0.5*R0_11*c
    h1_x = by_s35 + by_s36
    by_s38 = R0_11*a
    by_s39 = -0.5*by_s1*c
    h1_y = by_s38 + by_s39
    by_s41 = R0_11*g1_x
    by_s43 = b*by_s1
    by_s44 = by_s41 + by_s43
    s44 = L*R0_12
    by_s47 = R0_11*g1_x_errors
    by_s48 = R0_11_errors*g1_x
    by_s52 = by_s47 + by_s48
    s51 = L*R0_12_errors
    s53 = R0_12*ay1 + s51
    s55 = L*betay
    s57 = -R0_12*g1_z_errors + s55
    by_s54 = -by_s1*g1_x
    by_s56 = R0_11*b
    by_s57 = by_s54 + by_s56
    s63 = L*R0_22
    by_s60 = -by_s1*g1_x_errors
    by_s61 = R0_21_errors*g1_x
    by_s65 = by_s60 + by_s61
    s70 = L*R0_22_errors
    s72 = R0_22*ay1 + s70
    s74 = L*betax
    s76 = R0_22*g1_z_errors + s74
    by_s69 = R0_31_errors*g1_x
    s83 = L*R0_32_errors
    s84 = g1_z_errors + s83
    s92 = -by_s44 + h1_x
    s94 = bx1 - by_s52
    s96 = -by_s57 + h1_y
    s98 = by1 - by_s65
    s101 = -by_s69 + bz1
    g2_x = -0.5*c
    g2_x_errors = ax2 + tip_w
    g2_z_errors = az2 + tip_v
    h2_x = by_s35 - by_s36
    h2_y = by_s38 - by_s39
    by_s90 = R0_11*g2_x
    by_s91 = by_s43 + by_s90
    by_s93 = R0_11*g2_x_errors
    by_s94 = R0_11_errors*g2_x
    by_s97 = by_s93 + by_s94
    s115 = R0_12*ay2 + s51
    s118 = -R0_12*g2_z_errors + s55
    by_s99 = -by_s1*g2_x
    by_s100 = by_s56 + by_s99
    by_s102 = -by_s1*g2_x_errors
    by_s103 = R0_21_errors*g2_x
    by_s106 = by_s102 + by_s103
    s128 = R0_22*ay2 + s70
    s131 = R0_22*g2_z_errors + s74
    by_s108 = R0_31_errors*g2_x
    s136 = g2_z_errors + s83
    s144 = -by_s91 + h2_x
    s146 = bx2 - by_s97
    s148 = -by_s100 + h2_y
    s150 = by2 - by_s106
    s153 = -by_s108 + bz2
    s155 = by_s35 - by_s43
    s157 = -L*by_s1
    s159 = by_s38 - by_s56
    s161 = -L*R0_11
    s173 = (L * L)
    s178 = -0.5*(l * l) + 0.5*s173*((R0_11 * R0_11) + (by_s1 * by_s1))
    s205 = -0.5*dl1*l
    s206 = -0.5*dl2*l
    s207 = s205 + s206
    s231 = s205 - s206
    k[0] = s155
    k[1] = s157
    k[2] = s159
    k[3] = s161
    k[4] = s178
    k[5] = s173
    k[6] = L
    k[7] = R0_12
    k[8] = R0_22
    k[9] = s44
    k[10] = s53
    k[11] = s57
    k[12] = s63
    k[13] = s72
    k[14] = s76
    k[15] = ay1
    k[16] = s84
    k[17] = h1_x
    k[18] = h1_y
    k[19] = s92
    k[20] = s94
    k[21] = s96
    k[22] = s98
    k[23] = s101
    k[24] = s115
    k[25] = s118
    k[26] = s128
    k[27] = s131
    k[28] = ay2
    k[29] = s136
    k[30] = h2_x
    k[31] = h2_y
    k[32] = s144
    k[33] = s146
    k[34] = s148
    k[35] = s150
    k[36] = s153
    k[37] = s207
    k[38] = s231
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def linear_constants(p):
    """Return k (M, 3, 40), what `linear` reads that no pose changes, from p (77 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((40, p.shape[1], 3))
    b = p[0]
    a = p[1]
    L = p[2]
    l = p[3]
    c = p[4]
    phi = p[5]
    bx1 = p[6]
    by1 = p[7]
    bz1 = p[8]
    ax1 = p[9]
    ay1 = p[10]
    az1 = p[11]
    dl1 = p[12]
    bx2 = p[13]
    by2 = p[14]
    bz2 = p[15]
    ax2 = p[16]
    ay2 = p[17]
    az2 = p[18]
    dl2 = p[19]
    betax = p[20]
    betay = p[21]
    betaz = p[22]
    tip_v = p[23]
    tip_w = p[24]
    R0_11 = np.sin(phi)
    s1 = np.cos(phi)
    R0_11_errors = betaz*s1
    R0_12 = np.cos(phi)
    R0_12_errors = -R0_11*betaz
    R0_21_errors = R0_11*betaz
    R0_22 = np.sin(phi)
    R0_22_errors = betaz*s1
    R0_31_errors = -R0_11*betay - betax*s1
    R0_32_errors = R0_11*betax - betay*s1
    g1_x = 0.5*c
    g1_x_errors = ax1 + tip_w
    g1_z_errors = az1 + tip_v
    s37 = a*s1
    s38 = 0.5*R0_11*c
    h1_x = s37 + s38
    s40 = R0_11*a
    s41 = -0.5*c*s1
    h1_y = s40 + s41
    s45 = b*s1
    s46 = R0_11*g1_x + s45
    s54 = R0_11*g1_x_errors + R0_11_errors*g1_x
    s58 = R0_11*b
    s59 = -g1_x*s1 + s58
    s67 = R0_21_errors*g1_x - g1_x_errors*s1
    s71 = R0_31_errors*g1_x
    g2_x = -0.5*c
    g2_x_errors = ax2 + tip_w
    g2_z_errors = az2 + tip_v
    h2_x = s37 - s38
    h2_y = s40 - s41
    s93 = R0_11*g2_x + s45
    s99 = R0_11*g2_x_errors + R0_11_errors*g2_x
    s102 = -g2_x*s1 + s58
    s108 = R0_21_errors*g2_x - g2_x_errors*s1
    s110 = R0_31_errors*g2_x
    s125 = s37 - s45
    s127 = -L*s1
    s129 = s40 - s58
    s131 = -L*R0_11
    s143 = (L * L)
    s148 = -0.5*(l * l) + 0.5*s143*((R0_11 * R0_11) + (s1 * s1))
    s164 = -dl1*l
    s182 = -dl2*l
    k[0] = s125
    k[1] = s127
    k[2] = s129
    k[3] = s131
    k[4] = s148
    k[5] = s143
    k[6] = L
    k[7] = R0_12
    k[8] = R0_12_errors
    k[9] = betay
    k[10] = R0_22
    k[11] = R0_22_errors
    k[12] = betax
    k[13] = R0_32_errors
    k[14] = s46
    k[15] = ay1
    k[16] = g1_z_errors
    k[17] = s54
    k[18] = s59
    k[19] = s67
    k[20] = s71
    k[21] = h1_x
    k[22] = h1_y
    k[23] = bx1
    k[24] = by1
    k[25] = bz1
    k[26] = s93
    k[27] = ay2
    k[28] = g2_z_errors
    k[29] = s99
    k[30] = s102
    k[31] = s108
    k[32] = s110
    k[33] = h2_x
    k[34] = h2_y
    k[35] = bx2
    k[36] = by2
    k[37] = bz2
    k[38] = s164
    k[39] = s182
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def exact_state(p, tool, sign):
    """Return the array w of `exact_command` for a machine: p (3, 25), tool (3,), sign (3,) of the controller's joints."""
    w = aligned(228)
    w[20:23], w[24:27] = tool, sign
    k = _exact_constants(p[None])[0]
    w[104:228].reshape(-1, 4)[:] = np.pad(k, ((0, 1), (0, 0)), mode="edge").T
    return w


def linear_state(p, tool, sign):
    """Return the array w of `linear_command` for a machine: p (3, 25), tool (3,), sign (3,) of the controller's joints."""
    w = aligned(260)
    w[20:23], w[24:27] = tool, sign
    k = _linear_constants(p[None])[0]
    w[104:260].reshape(-1, 4)[:] = np.pad(k, ((0, 1), (0, 0)), mode="edge").T
    return w


@few
def _exact_joint(w, lanes):
    """Joint of the simplified limb at the target, then the platform's coordinates that follow from it (34 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s214 = w[104 + lane]
        s216 = w[108 + lane]
        s218 = w[112 + lane]
        s220 = w[116 + lane]
        s238 = w[120 + lane]
        s233 = w[124 + lane]
        L = w[128 + lane]
        s215 = px + s214 - tx
        s219 = py + s218 - ty
        s222 = s215*s216 + s219*s220
        s224 = pz - tz
        s225 = (s224 * s224)
        s239 = 0.5*(s215 * s215) + 0.5*(s219 * s219) + 0.5*s225 + s238
        s243 = math.sqrt((s222 * s222) + s225*s233 - (s239 * s239))
        s250 = arctangent(L*s224*s239 - s222*s243, -L*s224*s243 - s222*s239)
        w[36 + lane] = s250


@few
def _exact_rows(w, lanes):
    """Equations of a limb, their derivatives by turns of the platform and by the joint (241 operations)."""
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
        R0_12 = w[132 + lane]
        R0_13 = w[136 + lane]
        R0_22 = w[140 + lane]
        R0_23 = w[144 + lane]
        R0_32 = w[148 + lane]
        R0_33 = w[152 + lane]
        g1_y = w[156 + lane]
        g1_z = w[160 + lane]
        s147 = w[164 + lane]
        s153 = w[168 + lane]
        s155 = w[172 + lane]
        h1_x = w[176 + lane]
        h1_y = w[180 + lane]
        bz1 = w[184 + lane]
        g2_y = w[188 + lane]
        g2_z = w[192 + lane]
        s185 = w[196 + lane]
        s190 = w[200 + lane]
        s192 = w[204 + lane]
        h2_x = w[208 + lane]
        h2_y = w[212 + lane]
        bz2 = w[216 + lane]
        s269 = w[220 + lane]
        s317 = w[224 + lane]
        q = w[36 + lane]
        s78 = cosine(q)
        s80 = sine(q)
        R1_12 = R0_12*s78 + R0_13*s80
        R1_13 = -R0_12*s80 + R0_13*s78
        R1_22 = R0_22*s78 + R0_23*s80
        R1_23 = -R0_22*s80 + R0_23*s78
        R1_32 = R0_32*s78 + R0_33*s80
        R1_33 = -R0_32*s80 + R0_33*s78
        A1_x = R1_12*g1_y + R1_13*g1_z + s147
        A1_y = R1_22*g1_y + R1_23*g1_z + s153
        A1_z = R1_32*g1_y + R1_33*g1_z + s155
        s159 = h1_x - tx
        s160 = R_11*s159
        s161 = h1_y - ty
        s162 = R_12*s161
        s163 = bz1 - tz
        s164 = R_13*s163
        B1_x = px + s160 + s162 + s164
        s166 = R_21*s159
        s167 = R_22*s161
        s168 = R_23*s163
        B1_y = py + s166 + s167 + s168
        s170 = R_31*s159
        s171 = R_32*s161
        s172 = R_33*s163
        B1_z = pz + s170 + s171 + s172
        d1_x = -A1_x + B1_x
        d1_y = -A1_y + B1_y
        d1_z = -A1_z + B1_z
        A2_x = R1_12*g2_y + R1_13*g2_z + s185
        A2_y = R1_22*g2_y + R1_23*g2_z + s190
        A2_z = R1_32*g2_y + R1_33*g2_z + s192
        s196 = h2_x - tx
        s197 = R_11*s196
        s198 = h2_y - ty
        s199 = R_12*s198
        s200 = bz2 - tz
        s201 = R_13*s200
        B2_x = px + s197 + s199 + s201
        s203 = R_21*s196
        s204 = R_22*s198
        s205 = R_23*s200
        B2_y = py + s203 + s204 + s205
        s207 = R_31*s196
        s208 = R_32*s198
        s209 = R_33*s200
        B2_z = pz + s207 + s208 + s209
        d2_x = -A2_x + B2_x
        d2_y = -A2_y + B2_y
        d2_z = -A2_z + B2_z
        s256 = 0.25*(d1_x * d1_x)
        s258 = 0.25*(d1_y * d1_y)
        s260 = 0.25*(d1_z * d1_z)
        s262 = 0.25*(d2_x * d2_x)
        s264 = 0.25*(d2_y * d2_y)
        s266 = 0.25*(d2_z * d2_z)
        s270 = s256 + s258 + s260 + s262 + s264 + s266 + s269
        s271 = -s170 - s171 - s172
        s272 = 0.5*d1_y*s271
        s273 = s166 + s167 + s168
        s274 = 0.5*d1_z*s273
        s275 = -s207 - s208 - s209
        s276 = 0.5*d2_y*s275
        s277 = s203 + s204 + s205
        s278 = 0.5*d2_z*s277
        s279 = s272 + s274 + s276 + s278
        s280 = -0.5*d1_x*s271
        s281 = -s160 - s162 - s164
        s282 = 0.5*d1_z*s281
        s283 = -0.5*d2_x*s275
        s284 = -s197 - s199 - s201
        s285 = 0.5*d2_z*s284
        s286 = s280 + s282 + s283 + s285
        s287 = -0.5*d1_x*s273
        s288 = -0.5*d1_y*s281
        s289 = -0.5*d2_x*s277
        s290 = -0.5*d2_y*s284
        s291 = s287 + s288 + s289 + s290
        s295 = 0.5*d1_x*(R1_12*g1_z - R1_13*g1_y)
        s299 = 0.5*d1_y*(R1_22*g1_z - R1_23*g1_y)
        s303 = 0.5*d1_z*(R1_32*g1_z - R1_33*g1_y)
        s307 = 0.5*d2_x*(R1_12*g2_z - R1_13*g2_y)
        s311 = 0.5*d2_y*(R1_22*g2_z - R1_23*g2_y)
        s315 = 0.5*d2_z*(R1_32*g2_z - R1_33*g2_y)
        s316 = s295 + s299 + s303 + s307 + s311 + s315
        s318 = s256 + s258 + s260 - s262 - s264 - s266 + s317
        s319 = s272 + s274 - s276 - s278
        s320 = s280 + s282 - s283 - s285
        s321 = s287 + s288 - s289 - s290
        s322 = s295 + s299 + s303 - s307 - s311 - s315
        s333 = -1.0e-12*((0.5*d1_y + 0.5*d2_y) * (0.5*d1_y + 0.5*d2_y))
        s338 = -1.0e-12*((0.5*d1_z + 0.5*d2_z) * (0.5*d1_z + 0.5*d2_z))
        s339 = (s316 * s316) + s333 + s338 - 1.0e-12*((0.5*d1_x + 0.5*d2_x) * (0.5*d1_x + 0.5*d2_x))
        w[60 + lane] = s270
        w[64 + lane] = s279
        w[68 + lane] = s286
        w[72 + lane] = s291
        w[76 + lane] = s316
        w[80 + lane] = s318
        w[84 + lane] = s319
        w[88 + lane] = s320
        w[92 + lane] = s321
        w[96 + lane] = s322
        w[100 + lane] = s339


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
        s155 = w[104 + lane]
        s157 = w[108 + lane]
        s159 = w[112 + lane]
        s161 = w[116 + lane]
        s178 = w[120 + lane]
        s173 = w[124 + lane]
        L = w[128 + lane]
        B1_z = pz - tz
        s156 = px + s155 - tx
        s160 = py + s159 - ty
        s163 = s156*s157 + s160*s161
        s165 = (B1_z * B1_z)
        s179 = 0.5*(s156 * s156) + 0.5*(s160 * s160) + 0.5*s165 + s178
        s183 = math.sqrt((s163 * s163) + s165*s173 - (s179 * s179))
        s186 = B1_z*L*s179 - s163*s183
        s189 = -B1_z*L*s183 - s163*s179
        s190 = arctangent(s186, s189)
        s194 = 1/math.sqrt((s186 * s186) + (s189 * s189))
        s195 = s189*s194
        s196 = s186*s194
        w[36 + lane] = s190
        w[52 + lane] = s195
        w[56 + lane] = s196


@few
def _linear_angle(w, lanes):
    """Cosine and sine of the joint (2 operations)."""
    for lane in range(lanes):
        q = w[36 + lane]
        s197 = cosine(q)
        s198 = sine(q)
        w[52 + lane] = s197
        w[56 + lane] = s198


@few
def _linear_rows(w, lanes):
    """Equations of a nominal limb: change by all errors, derivatives by rotation and joint (167 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        L = w[128 + lane]
        R0_12 = w[132 + lane]
        R0_22 = w[136 + lane]
        s44 = w[140 + lane]
        s53 = w[144 + lane]
        s57 = w[148 + lane]
        s63 = w[152 + lane]
        s72 = w[156 + lane]
        s76 = w[160 + lane]
        ay1 = w[164 + lane]
        s84 = w[168 + lane]
        h1_x = w[172 + lane]
        h1_y = w[176 + lane]
        s92 = w[180 + lane]
        s94 = w[184 + lane]
        s96 = w[188 + lane]
        s98 = w[192 + lane]
        s101 = w[196 + lane]
        s115 = w[200 + lane]
        s118 = w[204 + lane]
        s128 = w[208 + lane]
        s131 = w[212 + lane]
        ay2 = w[216 + lane]
        s136 = w[220 + lane]
        h2_x = w[224 + lane]
        h2_y = w[228 + lane]
        s144 = w[232 + lane]
        s146 = w[236 + lane]
        s148 = w[240 + lane]
        s150 = w[244 + lane]
        s153 = w[248 + lane]
        s207 = w[252 + lane]
        s231 = w[256 + lane]
        cos_q = w[52 + lane]
        sin_q = w[56 + lane]
        by_s15 = -R0_12*sin_q
        by_s23 = -R0_22*sin_q
        s45 = cos_q*s44
        by_s46 = L*by_s15
        s64 = cos_q*s63
        by_s59 = L*by_s23
        by_s67 = L*sin_q
        by_s68 = L*cos_q
        by_s74 = h1_x - tx
        by_s75 = h1_y - ty
        d1_x = px - s45 + s92 - tx
        d1_x_errors = -cos_q*s53 - s57*sin_q + s94
        d1_y = py - s64 + s96 - ty
        d1_y_errors = -cos_q*s72 + s76*sin_q + s98
        d1_z = -by_s67 + pz - tz
        d1_z_errors = -ay1*sin_q - cos_q*s84 + s101
        by_s112 = h2_x - tx
        by_s113 = h2_y - ty
        d2_x = px + s144 - s45 - tx
        d2_x_errors = -cos_q*s115 - s118*sin_q + s146
        d2_y = py + s148 - s64 - ty
        d2_y_errors = -cos_q*s128 + s131*sin_q + s150
        d2_z = -by_s67 + pz - tz
        d2_z_errors = -ay2*sin_q - cos_q*s136 + s153
        s199 = 0.5*d1_x*d1_x_errors
        s200 = 0.5*d1_y*d1_y_errors
        s201 = 0.5*d1_z*d1_z_errors
        s202 = 0.5*d2_x*d2_x_errors
        s203 = 0.5*d2_y*d2_y_errors
        s204 = 0.5*d2_z*d2_z_errors
        s208 = s199 + s200 + s201 + s202 + s203 + s204 + s207
        s209 = 0.5*d1_y*tz
        s210 = 0.5*by_s75*d1_z
        s211 = 0.5*d2_y*tz
        s212 = 0.5*by_s113*d2_z
        s213 = s209 + s210 + s211 + s212
        s214 = -0.5*d1_x*tz
        s215 = -0.5*by_s74*d1_z
        s216 = -0.5*d2_x*tz
        s217 = -0.5*by_s112*d2_z
        s218 = s214 + s215 + s216 + s217
        s219 = -0.5*by_s75*d1_x
        s220 = 0.5*by_s74*d1_y
        s221 = -0.5*by_s113*d2_x
        s222 = 0.5*by_s112*d2_y
        s223 = s219 + s220 + s221 + s222
        s227 = -0.5*by_s46*d2_x
        s228 = -0.5*by_s59*d2_y
        s229 = -0.5*by_s68*d2_z
        s230 = -0.5*by_s46*d1_x - 0.5*by_s59*d1_y - 0.5*by_s68*d1_z + s227 + s228 + s229
        s232 = s199 + s200 + s201 - s202 - s203 - s204 + s231
        s233 = s209 + s210 - s211 - s212
        s234 = s214 + s215 - s216 - s217
        s235 = s219 + s220 - s221 - s222
        s246 = -1.0e-12*((0.5*d1_y + 0.5*d2_y) * (0.5*d1_y + 0.5*d2_y))
        s251 = -1.0e-12*((0.5*d1_z + 0.5*d2_z) * (0.5*d1_z + 0.5*d2_z))
        s252 = (s230 * s230) + s246 + s251 - 1.0e-12*((0.5*d1_x + 0.5*d2_x) * (0.5*d1_x + 0.5*d2_x))
        w[60 + lane] = s208
        w[64 + lane] = s213
        w[68 + lane] = s218
        w[72 + lane] = s223
        w[76 + lane] = s230
        w[80 + lane] = s232
        w[84 + lane] = s233
        w[88 + lane] = s234
        w[92 + lane] = s235
        w[100 + lane] = s252


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
