"""Commands of one pose for a servo loop: `linear_delta`, Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both c1aecda9b0ba7fe9; SymPy 1.14.0.

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
COMMAND_CONSTANTS = 21  # what is exported reads these first columns of `vectorised.constants` only
LANES = np.int64(4)  # no literal: a loop whose end is known beforehand is unrolled, and not turned into SIMD code
OPTIONS = {"error_model": "numpy", "fastmath": {"contract"}}
fast = kernel(**OPTIONS)  # to let other threads run meanwhile would take longer than a command
few = partial(straight, wide=False)  # lanes: the limbs


def _exact_constants(p):
    """Return k (M, 3, 26), what no target changes, from p (135 operations).

    p is that of the calibrated machine.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((26, p.shape[1], 3))
    r = p[0]
    l = p[1]
    phi = p[2]
    home = p[3]
    a = p[4]
    c = p[5]
    endstop = p[6]
    arm = p[7]
    radius = p[8]
    angle = p[9]
    lean_radial = p[10]
    lean_tangential = p[11]
    scale = p[12]
    dl = p[13]
    dr = p[14]
    stretch = p[15]
    s0 = angle + phi
    u_x = np.cos(s0)
    u_y = np.sin(s0)
    arm_0 = arm + l
    r_0 = dr + r + radius
    s7 = lean_radial*u_x - lean_tangential*u_y
    s8 = (s7 * s7)
    s11 = -lean_radial*u_y - lean_tangential*u_x
    s12 = (s11 * s11)
    s13 = s12 + s8
    s21 = s13*(s13*(s13*(2.8114572543455206e-15*s12 + 2.8114572543455206e-15*s8 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
    s29 = s13*(s13*(s13*(s13*(s21 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
    s30 = s29 + 1
    axis_x = s30*s7
    axis_y = -s11*s30
    s40 = s13*(s13*(s13*(1.5619206968586225e-16*s12 + 1.5619206968586225e-16*s8 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
    s48 = s13*(s13*(s13*(s13*(s40 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
    s49 = s48 + 0.5
    axis_z = -(s11 * s11)*s49 - s49*(s7 * s7) + 1
    s53 = (arm_0 * arm_0)
    h = endstop + home + np.sqrt(-(r_0 * r_0) + s53)
    s59 = h/axis_z
    s60 = scale + 1
    s64 = a + r_0
    s65 = s64*u_x
    s68 = s64*u_y
    s106 = a*u_x
    s109 = a*u_y
    s128 = 0.5*c
    s138 = (1.0 / (s60 * s60))
    s139 = a + dr + r + radius
    s141 = s106 - s139*u_x
    s146 = s109 - s139*u_y
    s153 = -0.5*s53
    s155 = -2*s138
    s159 = 2*scale + 2
    s161 = 0.25*(s159 * s159)/(s60 * s60 * s60 * s60)
    s165 = -0.5*s138*s159
    s185 = -arm_0*stretch - 0.125*(dl * dl) + s153 - 0.5*(stretch * stretch)
    s191 = 0.5*c*u_y
    s193 = -0.5*c*u_x
    s216 = axis_x*s60
    s218 = axis_y*s60
    s220 = axis_z*s60
    s228 = -0.5*arm_0*dl - 0.5*dl*stretch
    k[0] = s141
    k[1] = s146
    k[2] = h
    k[3] = s153
    k[4] = s155
    k[5] = s161
    k[6] = s165
    k[7] = s60
    k[8] = s59
    k[9] = axis_x
    k[10] = s65
    k[11] = axis_y
    k[12] = s68
    k[13] = axis_z
    k[14] = s106
    k[15] = s109
    k[16] = u_x
    k[17] = u_y
    k[18] = s128
    k[19] = s185
    k[20] = s191
    k[21] = s193
    k[22] = s216
    k[23] = s218
    k[24] = s220
    k[25] = s228
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _linear_constants(p):
    """Return k (M, 3, 19), what no target changes, from p (71 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((19, p.shape[1], 3))
    r = p[0]
    l = p[1]
    phi = p[2]
    home = p[3]
    a = p[4]
    c = p[5]
    endstop = p[6]
    arm = p[7]
    radius = p[8]
    angle = p[9]
    lean_radial = p[10]
    lean_tangential = p[11]
    scale = p[12]
    dl = p[13]
    dr = p[14]
    stretch = p[15]
    u_x = np.cos(phi)
    by_s1 = np.sin(phi)
    u_x_errors = -angle*by_s1
    u_y = np.sin(phi)
    u_y_errors = angle*u_x
    r_0_errors = dr + radius
    by_s6 = lean_radial*u_x
    by_s7 = -lean_tangential*u_y
    axis_x_errors = by_s6 + by_s7
    by_s9 = lean_radial*u_y
    by_s10 = lean_tangential*u_x
    axis_y_errors = by_s10 + by_s9
    by_s12 = (l * l)
    by_s13 = (r * r)
    by_s14 = by_s12 - by_s13
    by_s15 = np.sqrt(by_s14)
    h = by_s15 + home
    by_s17 = 1/np.sqrt(by_s14)
    by_s18 = arm*by_s17*l
    by_s19 = -by_s17*r*r_0_errors
    h_errors = by_s18 + by_s19 + endstop
    by_s22 = a + r
    by_s23 = by_s22*u_x
    by_s25 = r_0_errors*u_x
    by_s26 = by_s22*u_x_errors
    by_s27 = by_s25 + by_s26
    by_s29 = by_s22*u_y
    by_s31 = r_0_errors*u_y
    by_s32 = by_s22*u_y_errors
    by_s33 = by_s31 + by_s32
    by_s37 = a*u_x
    by_s39 = a*u_y
    by_s42 = a*u_x_errors
    by_s44 = a*u_y_errors
    s50 = -by_s23 + by_s37
    s52 = -axis_x_errors*h - by_s27 + by_s42
    s54 = -by_s29 + by_s39
    s56 = -axis_y_errors*h - by_s33 + by_s44
    s_x_cz = -0.5*c*u_x
    s_y_cz = -0.5*c*u_y
    s_z_cx = 0.5*c*u_x
    s_z_cy = 0.5*c*u_y
    s66 = a*by_s1 - by_s1*by_s22
    s79 = -arm*l - l*stretch
    s90 = -0.5*dl*l
    k[0] = s50
    k[1] = s66
    k[2] = by_s12
    k[3] = h
    k[4] = axis_x_errors
    k[5] = axis_y_errors
    k[6] = scale
    k[7] = h_errors
    k[8] = by_s37
    k[9] = by_s39
    k[10] = s52
    k[11] = s54
    k[12] = s56
    k[13] = s79
    k[14] = s_z_cx
    k[15] = s_z_cy
    k[16] = s_x_cz
    k[17] = s_y_cz
    k[18] = s90
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def linear_constants(p):
    """Return k (M, 3, 22), what `linear` reads that no pose changes, from p (66 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((22, p.shape[1], 3))
    r = p[0]
    l = p[1]
    phi = p[2]
    home = p[3]
    a = p[4]
    c = p[5]
    endstop = p[6]
    arm = p[7]
    radius = p[8]
    angle = p[9]
    lean_radial = p[10]
    lean_tangential = p[11]
    scale = p[12]
    dl = p[13]
    dr = p[14]
    stretch = p[15]
    u_x = np.cos(phi)
    s1 = np.sin(phi)
    u_x_errors = -angle*s1
    u_y = np.sin(phi)
    u_y_errors = angle*u_x
    r_0_errors = dr + radius
    axis_x_errors = lean_radial*u_x - lean_tangential*u_y
    axis_y_errors = lean_radial*u_y + lean_tangential*u_x
    s12 = (l * l)
    s14 = -(r * r) + s12
    h = home + np.sqrt(s14)
    s17 = 1/np.sqrt(s14)
    h_errors = arm*l*s17 + endstop - r*r_0_errors*s17
    s22 = a + r
    s23 = s22*u_x
    s27 = r_0_errors*u_x + s22*u_x_errors
    s29 = s22*u_y
    s33 = r_0_errors*u_y + s22*u_y_errors
    s37 = a*u_x
    s39 = a*u_y
    s42 = a*u_x_errors
    s44 = a*u_y_errors
    s_x_cz = -0.5*c*u_x
    s_y_cz = -0.5*c*u_y
    s_z_cx = 0.5*c*u_x
    s_z_cy = 0.5*c*u_y
    s55 = -s23 + s37
    s60 = a*s1 - s1*s22
    s69 = -arm*l
    s70 = -l*stretch
    s71 = -0.5*dl*l
    s72 = s69 + s70 + s71
    s87 = s69 + s70 - s71
    k[0] = s55
    k[1] = s60
    k[2] = s12
    k[3] = h
    k[4] = axis_x_errors
    k[5] = s27
    k[6] = axis_y_errors
    k[7] = s33
    k[8] = scale
    k[9] = h_errors
    k[10] = s37
    k[11] = s39
    k[12] = s23
    k[13] = s42
    k[14] = s29
    k[15] = s44
    k[16] = s72
    k[17] = s_z_cx
    k[18] = s_z_cy
    k[19] = s_x_cz
    k[20] = s_y_cz
    k[21] = s87
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def exact_state(p, tool, sign):
    """Return the array w of `exact_command` for a machine: p (3, 16), tool (3,), sign (3,) of the controller's joints."""
    w = aligned(208)
    w[20:23], w[24:27] = tool, sign
    k = _exact_constants(p[None])[0]
    w[104:208].reshape(-1, 4)[:] = np.pad(k, ((0, 1), (0, 0)), mode="edge").T
    return w


def linear_state(p, tool, sign):
    """Return the array w of `linear_command` for a machine: p (3, 16), tool (3,), sign (3,) of the controller's joints."""
    w = aligned(180)
    w[20:23], w[24:27] = tool, sign
    k = _linear_constants(p[None])[0]
    w[104:180].reshape(-1, 4)[:] = np.pad(k, ((0, 1), (0, 0)), mode="edge").T
    return w


@few
def _exact_joint(w, lanes):
    """Joint of the simplified limb at the target, then the platform's coordinates that follow from it (22 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s141 = w[104 + lane]
        s146 = w[108 + lane]
        h = w[112 + lane]
        s153 = w[116 + lane]
        s155 = w[120 + lane]
        s161 = w[124 + lane]
        s165 = w[128 + lane]
        s150 = -h + pz - tz
        s151 = (s150 * s150)
        s154 = 0.5*s151 + s153 + 0.5*((px + s141 - tx) * (px + s141 - tx)) + 0.5*((py + s146 - ty) * (py + s146 - ty))
        s167 = s150*s165 - math.sqrt(s151*s161 + s154*s155)
        w[36 + lane] = s167


@few
def _exact_rows(w, lanes):
    """Equations of a limb, their derivatives by turns of the platform and by the joint (150 operations)."""
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
        s60 = w[132 + lane]
        s59 = w[136 + lane]
        axis_x = w[140 + lane]
        s65 = w[144 + lane]
        axis_y = w[148 + lane]
        s68 = w[152 + lane]
        axis_z = w[156 + lane]
        s106 = w[160 + lane]
        s109 = w[164 + lane]
        u_x = w[168 + lane]
        u_y = w[172 + lane]
        s128 = w[176 + lane]
        s185 = w[180 + lane]
        s191 = w[184 + lane]
        s193 = w[188 + lane]
        s216 = w[192 + lane]
        s218 = w[196 + lane]
        s220 = w[200 + lane]
        s228 = w[204 + lane]
        q = w[36 + lane]
        s62 = -q*s60 + s59
        C_x = axis_x*s62 + s65
        C_y = axis_y*s62 + s68
        C_z = axis_z*s62
        s107 = s106 - tx
        s108 = R_11*s107
        s110 = s109 - ty
        s111 = R_12*s110
        s112 = -R_13*tz
        A_x = px + s108 + s111 + s112
        s114 = R_21*s107
        s115 = R_22*s110
        s116 = -R_23*tz
        A_y = py + s114 + s115 + s116
        s118 = R_31*s107
        s119 = R_32*s110
        s120 = -R_33*tz
        A_z = pz + s118 + s119 + s120
        d_x = A_x - C_x
        d_y = A_y - C_y
        d_z = A_z - C_z
        s_x = s128*(-R_11*u_y + R_12*u_x + u_y)
        s_y = s128*(-R_21*u_y + R_22*u_x - u_x)
        s_z = s128*(-R_31*u_y + R_32*u_x)
        s168 = (d_x * d_x)
        s170 = (d_y * d_y)
        s172 = (d_z * d_z)
        s177 = 0.5*(s_y * s_y)
        s179 = 0.5*(s_z * s_z)
        s186 = 0.5*s168 + 0.5*s170 + 0.5*s172 + s177 + s179 + s185 + 0.5*(s_x * s_x)
        s187 = -s118 - s119 - s120
        s189 = s114 + s115 + s116
        s195 = R_31*s191 + R_32*s193
        s199 = -R_21*s191 - R_22*s193
        s201 = d_y*s187 + d_z*s189 + s195*s_y + s199*s_z
        s203 = -s108 - s111 - s112
        s208 = R_11*s191 + R_12*s193
        s210 = -d_x*s187 + d_z*s203 - s195*s_x + s208*s_z
        s215 = -d_x*s189 - d_y*s203 - s199*s_x - s208*s_y
        s222 = d_x*s216 + d_y*s218 + d_z*s220
        s229 = d_x*s_x + d_y*s_y + d_z*s_z + s228
        s234 = d_y*s195 + d_z*s199 + s187*s_y + s189*s_z
        s239 = -d_x*s195 + d_z*s208 - s187*s_x + s203*s_z
        s244 = -d_x*s199 - d_y*s208 - s189*s_x - s203*s_y
        s248 = s216*s_x + s218*s_y + s220*s_z
        s253 = -1.0e-12*s168 - 1.0e-12*s170 - 1.0e-12*s172 + (s222 * s222)
        w[60 + lane] = s186
        w[64 + lane] = s201
        w[68 + lane] = s210
        w[72 + lane] = s215
        w[76 + lane] = s222
        w[80 + lane] = s229
        w[84 + lane] = s234
        w[88 + lane] = s239
        w[92 + lane] = s244
        w[96 + lane] = s248
        w[100 + lane] = s253


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
    """Joint of the nominal limb at the target, its cosine and sine (13 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s50 = w[104 + lane]
        s66 = w[108 + lane]
        by_s12 = w[112 + lane]
        h = w[116 + lane]
        d_x = px + s50 - tx
        s71 = h - pz + tz - math.sqrt(by_s12 - (d_x * d_x) - ((py + s66 - ty) * (py + s66 - ty)))
        w[36 + lane] = s71


@few
def _linear_rows(w, lanes):
    """Equations of a nominal limb: change by all errors, derivatives by rotation and joint (44 operations)."""
    px = w[0]
    py = w[1]
    pz = w[2]
    tx = w[20]
    ty = w[21]
    tz = w[22]
    for lane in range(lanes):
        s50 = w[104 + lane]
        h = w[116 + lane]
        axis_x_errors = w[120 + lane]
        axis_y_errors = w[124 + lane]
        scale = w[128 + lane]
        h_errors = w[132 + lane]
        by_s37 = w[136 + lane]
        by_s39 = w[140 + lane]
        s52 = w[144 + lane]
        s54 = w[148 + lane]
        s56 = w[152 + lane]
        s79 = w[156 + lane]
        s_z_cx = w[160 + lane]
        s_z_cy = w[164 + lane]
        s_x_cz = w[168 + lane]
        s_y_cz = w[172 + lane]
        s90 = w[176 + lane]
        q = w[36 + lane]
        C_z_errors = h_errors - q*scale
        by_s38 = by_s37 - tx
        by_s40 = by_s39 - ty
        d_x = px + s50 - tx
        d_x_errors = axis_x_errors*q + s52
        d_y = py + s54 - ty
        d_y_errors = axis_y_errors*q + s56
        d_z = -h + pz + q - tz
        s80 = -C_z_errors*d_z + d_x*d_x_errors + d_y*d_y_errors + s79
        s83 = by_s40*d_z + d_y*tz
        s86 = -by_s38*d_z - d_x*tz
        s89 = by_s38*d_y - by_s40*d_x
        s91 = d_z*s_z_cx
        s92 = d_z*s_z_cy
        s95 = d_x*s_x_cz + d_y*s_y_cz
        s96 = (d_z * d_z)
        s101 = -1.0e-12*(d_x * d_x) - 1.0e-12*(d_y * d_y) + 0.999999999999*s96
        w[60 + lane] = s80
        w[64 + lane] = s83
        w[68 + lane] = s86
        w[72 + lane] = s89
        w[76 + lane] = d_z
        w[80 + lane] = s90
        w[84 + lane] = s91
        w[88 + lane] = s92
        w[92 + lane] = s95
        w[100 + lane] = s101


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
