"""Kinematics of `linear_delta`: Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both 3cb1ec9eac90550d; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 6)  platform: px py pz cx cy cz
q (N, 3)  joints        tool (N, 3)  reference point in {O'}
p (M, 3, 15)  one row of parameters per limb: r l phi home a c endstop arm radius angle lean_radial lean_tangential scale dl radius
k (M, 3, 40)  what `constants` makes of p; M is 1 (one machine) or N (parameters that change from pose to pose)

Kernels allocate nothing per pose and never raise: `status` says what became of each pose.
"""

import math

import numpy as np
from numba import njit

SOLVED, UNREACHABLE, SINGULAR = 0, 1, 2
MAX_STEPS = 30
STEP_DONE = 1e-9  # mm and rad; Newton is quadratic: after such a step the rest is rounding
STEP_LOST = 1e5  # mm and rad; a step of this size leads nowhere
ANGLE_STEP = 1e-3  # rad per mm: joints and rotations are asked for this much finer than lengths
CLOSED = 1e-3  # mm^2: loops that are open by more where Newton gets stuck cannot be closed
PIVOT_SINGULAR = 1e-9  # of the largest entry of its matrix, in mm
COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 72  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 21  # `exact_command` reads these first columns of k only


def constants(p):
    """Return k (M, 3, 40), what no pose changes, from p (351 operations).

    Plain NumPy over all rows at once: it runs once per machine, and compiling it would take longer than running it.
    """
    k = np.zeros((p.shape[0], 3, 40))
    r = p[..., 0]
    l = p[..., 1]
    phi = p[..., 2]
    home = p[..., 3]
    a = p[..., 4]
    c = p[..., 5]
    endstop = p[..., 6]
    arm = p[..., 7]
    radius = p[..., 8]
    angle = p[..., 9]
    lean_radial = p[..., 10]
    lean_tangential = p[..., 11]
    scale = p[..., 12]
    dl = p[..., 13]
    dr = p[..., 14]
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
    s16 = 2.8114572543455206e-15*s12 + 2.8114572543455206e-15*s8 - 7.647163731819816e-13
    s18 = s13*s16 + 1.6059043836821613e-10
    s20 = s13*s18 - 2.505210838544172e-08
    s22 = s13*s20 + 2.7557319223985893e-06
    s24 = s13*s22 - 0.0001984126984126984
    s26 = s13*s24 + 0.008333333333333333
    s28 = s13*s26 - 0.16666666666666666
    s30 = s13*s28 + 1
    axis_x = s30*s7
    axis_y = -s11*s30
    s35 = 1.5619206968586225e-16*s12 + 1.5619206968586225e-16*s8 - 4.779477332387385e-14
    s37 = s13*s35 + 1.1470745597729725e-11
    s39 = s13*s37 - 2.08767569878681e-09
    s41 = s13*s39 + 2.755731922398589e-07
    s43 = s13*s41 - 2.48015873015873e-05
    s45 = s13*s43 + 0.001388888888888889
    s47 = s13*s45 - 0.041666666666666664
    s49 = s13*s47 + 0.5
    axis_z = -(s11 * s11)*s49 - s49*(s7 * s7) + 1
    s53 = (arm_0 * arm_0)
    s55 = -(r_0 * r_0) + s53
    h = endstop + home + np.sqrt(s55)
    s58 = (1.0 / axis_z)
    s59 = h*s58
    s60 = scale + 1
    s64 = a + r_0
    s65 = s64*u_x
    s68 = s64*u_y
    s106 = a*u_x
    s109 = a*u_y
    s128 = 0.5*c
    s147 = 0.5*dl
    s148 = arm_0 + s147
    s150 = -0.5*(s148 * s148)
    s268 = -2*s49*s7
    s269 = 2*s11
    s270 = 2*s7
    s271 = -2*s11*s49
    s273 = (0.5)/np.sqrt(s55)
    s276 = (1.0 / (axis_z * axis_z))
    s278 = -s148
    s280 = 2*arm_0*s273*s58
    s286 = -2*r_0*s273*s58
    s293 = -s269*s7
    s294 = s11*s270
    s295 = s293 + s294
    s311 = s13*(s13*(s13*(1.5619206968586225e-16*s293 + 1.5619206968586225e-16*s294) + s295*s35) + s295*s37) + s295*s39
    s319 = s13*(s13*(s13*(s13*s311 + s295*s41) + s295*s43) + s295*s45) + s295*s47
    s326 = s11*s268 - s12*s319 - s271*s7 - s319*s8
    s344 = s13*(s13*(s13*(2.8114572543455206e-15*s293 + 2.8114572543455206e-15*s294) + s16*s295) + s18*s295) + s20*s295
    s352 = s13*(s13*(s13*(s13*s344 + s22*s295) + s24*s295) + s26*s295) + s28*s295
    s354 = axis_x - s11*s352
    s358 = -axis_y + s352*s7
    s361 = -h*s276*s326
    s364 = -s269*u_y
    s365 = s270*u_x
    s366 = s364 + s365
    s382 = s13*(s13*(s13*(1.5619206968586225e-16*s364 + 1.5619206968586225e-16*s365) + s35*s366) + s366*s37) + s366*s39
    s390 = s13*(s13*(s13*(s13*s382 + s366*s41) + s366*s43) + s366*s45) + s366*s47
    s397 = -s12*s390 + s268*u_x - s271*u_y - s390*s8
    s399 = s30*u_y
    s415 = s13*(s13*(s13*(2.8114572543455206e-15*s364 + 2.8114572543455206e-15*s365) + s16*s366) + s18*s366) + s20*s366
    s423 = s13*(s13*(s13*(s13*s415 + s22*s366) + s24*s366) + s26*s366) + s28*s366
    s425 = -s11*s423 + s399
    s428 = s30*u_x
    s429 = s423*s7 + s428
    s432 = -h*s276*s397
    s435 = -s269*u_x
    s436 = -s270*u_y
    s437 = s435 + s436
    s453 = s13*(s13*(s13*(1.5619206968586225e-16*s435 + 1.5619206968586225e-16*s436) + s35*s437) + s37*s437) + s39*s437
    s461 = s13*(s13*(s13*(s13*s453 + s41*s437) + s43*s437) + s437*s45) + s437*s47
    s468 = -s12*s461 - s268*u_y - s271*u_x - s461*s8
    s485 = s13*(s13*(s13*(2.8114572543455206e-15*s435 + 2.8114572543455206e-15*s436) + s16*s437) + s18*s437) + s20*s437
    s493 = s13*(s13*(s13*(s13*s485 + s22*s437) + s24*s437) + s26*s437) + s28*s437
    s495 = -s11*s493 + s428
    s498 = -s399 + s493*s7
    s501 = -h*s276*s468
    s504 = 0.5*s278
    s514 = arm_0 - s147
    s516 = -0.5*(s514 * s514)
    s628 = -s514
    s656 = -0.5*s628
    s657 = (1.0 / (s60 * s60))
    s658 = a + dr + r + radius
    s660 = s106 - s658*u_x
    s665 = s109 - s658*u_y
    s672 = -0.5*s53
    s674 = -2*s657
    s678 = 2*scale + 2
    s680 = 0.25*(s678 * s678)/s60**4
    s684 = -0.5*s657*s678
    k[..., 0] = s60
    k[..., 1] = s59
    k[..., 2] = axis_x
    k[..., 3] = s65
    k[..., 4] = axis_y
    k[..., 5] = s68
    k[..., 6] = axis_z
    k[..., 7] = s106
    k[..., 8] = s109
    k[..., 9] = u_x
    k[..., 10] = u_y
    k[..., 11] = s128
    k[..., 12] = s150
    k[..., 13] = s516
    k[..., 14] = s660
    k[..., 15] = s665
    k[..., 16] = h
    k[..., 17] = s672
    k[..., 18] = s674
    k[..., 19] = s680
    k[..., 20] = s684
    k[..., 21] = s58
    k[..., 22] = s280
    k[..., 23] = s278
    k[..., 24] = s286
    k[..., 25] = s326
    k[..., 26] = s354
    k[..., 27] = s358
    k[..., 28] = s361
    k[..., 29] = s397
    k[..., 30] = s425
    k[..., 31] = s429
    k[..., 32] = s432
    k[..., 33] = s468
    k[..., 34] = s495
    k[..., 35] = s498
    k[..., 36] = s501
    k[..., 37] = s628
    k[..., 38] = s504
    k[..., 39] = s656
    return k


@njit(cache=True, nogil=True, error_model="numpy")
def _newton(x, q, tool, k, out):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint (334 operations)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    q = q
    s60 = k[0]
    s59 = k[1]
    axis_x = k[2]
    s65 = k[3]
    axis_y = k[4]
    s68 = k[5]
    axis_z = k[6]
    s106 = k[7]
    s109 = k[8]
    u_x = k[9]
    u_y = k[10]
    s128 = k[11]
    s150 = k[12]
    s516 = k[13]
    s62 = -q*s60 + s59
    C_x = axis_x*s62 + s65
    C_y = axis_y*s62 + s68
    C_z = axis_z*s62
    s71 = (cx * cx)
    s73 = (cy * cy)
    s75 = (cz * cz)
    s77 = 0.25*s71 + 0.25*s73 + 0.25*s75 + 1
    s78 = (1.0 / s77)
    s79 = -0.5*s73
    s80 = -0.5*s75
    s81 = s79 + s80
    R_11 = s78*s81 + 1
    s84 = 0.5*cx*cy
    s85 = -cz + s84
    R_12 = s78*s85
    s87 = 0.5*cx*cz
    s88 = cy + s87
    R_13 = s78*s88
    s90 = cz + s84
    R_21 = s78*s90
    s92 = -0.5*s71
    s93 = s80 + s92
    R_22 = s78*s93 + 1
    s96 = 0.5*cy*cz
    s97 = -cx + s96
    R_23 = s78*s97
    s99 = -cy + s87
    R_31 = s78*s99
    s101 = cx + s96
    R_32 = s101*s78
    s103 = s79 + s92
    R_33 = s103*s78 + 1
    s107 = s106 - tx
    s110 = s109 - ty
    A_x = R_11*s107 + R_12*s110 - R_13*tz + px
    A_y = R_21*s107 + R_22*s110 - R_23*tz + py
    A_z = R_31*s107 + R_32*s110 - R_33*tz + pz
    d_x = A_x - C_x
    d_y = A_y - C_y
    d_z = A_z - C_z
    s_x = s128*(-R_11*u_y + R_12*u_x + u_y)
    s_y = s128*(-R_21*u_y + R_22*u_x - u_x)
    s_z = s128*(-R_31*u_y + R_32*u_x)
    s138 = d_x + s_x
    s141 = d_y + s_y
    s144 = d_z + s_z
    s151 = 0.5*(s138 * s138) + 0.5*(s141 * s141) + 0.5*(s144 * s144) + s150
    s152 = 2*s144
    s153 = 0.5*s152
    s154 = 2*s141
    s155 = 0.5*s154
    s156 = 2*s138
    s157 = 0.5*s156
    s159 = s128*s153
    s165 = s128*s155
    s170 = s128*s157
    s176 = -s153*tz
    s182 = -s155*tz
    s188 = -s157*tz
    s196 = s176*s78
    s198 = s110*s153 + s159*u_x
    s199 = s198*s78
    s201 = s107*s153 - s159*u_y
    s203 = s201*s78
    s205 = s182*s78
    s206 = s199 + s205
    s207 = 0.5*cz
    s208 = 0.5*cy
    s211 = s110*s155 + s165*u_x
    s212 = s211*s93
    s213 = s211*s78
    s216 = s107*s155 - s165*u_y
    s217 = s216*s90
    s218 = s216*s78
    s219 = s188*s88
    s220 = s188*s78
    s221 = s203 + s220
    s222 = 0.5*cx
    s225 = s110*s157 + s170*u_x
    s226 = s225*s85
    s227 = s225*s78
    s228 = s218 + s227
    s231 = s107*s157 - s170*u_y
    s232 = s231*s81
    s233 = s231*s78
    s238 = s101*s198 + s103*s176 + s182*s97 + s201*s99 + s212 + s217 + s219 + s226 + s232
    s239 = (1.0 / (s77 * s77))
    s241 = -0.25*s238*s239
    s243 = 2*cz
    s246 = 2*cy
    s249 = 2*cx
    s258 = -s60*(-axis_x*s157 - axis_y*s155 - axis_z*s153)
    s264 = s199 - s205 + s207*s221 + s208*s228 + s249*(-0.5*s196 - 0.5*s213 + s241)
    s265 = -s203 + s206*s207 + s220 + s222*s228 + s246*(-0.5*s196 - 0.5*s233 + s241)
    s266 = s206*s208 + s218 + s221*s222 - s227 + s243*(-0.5*s213 - 0.5*s233 + s241)
    s505 = d_x - s_x
    s508 = d_y - s_y
    s511 = d_z - s_z
    s517 = 0.5*(s505 * s505) + 0.5*(s508 * s508) + 0.5*(s511 * s511) + s516
    s518 = 2*s511
    s519 = 0.5*s518
    s520 = 2*s508
    s521 = 0.5*s520
    s522 = 2*s505
    s523 = 0.5*s522
    s525 = -s128*s519
    s531 = -s128*s521
    s536 = -s128*s523
    s542 = -s519*tz
    s548 = -s521*tz
    s554 = -s523*tz
    s562 = s542*s78
    s564 = s110*s519 + s525*u_x
    s565 = s564*s78
    s567 = s107*s519 - s525*u_y
    s569 = s567*s78
    s571 = s548*s78
    s572 = s565 + s571
    s575 = s110*s521 + s531*u_x
    s576 = s575*s93
    s577 = s575*s78
    s580 = s107*s521 - s531*u_y
    s581 = s580*s90
    s582 = s580*s78
    s583 = s554*s88
    s584 = s554*s78
    s585 = s569 + s584
    s588 = s110*s523 + s536*u_x
    s589 = s588*s85
    s590 = s588*s78
    s591 = s582 + s590
    s594 = s107*s523 - s536*u_y
    s595 = s594*s81
    s596 = s594*s78
    s601 = s101*s564 + s103*s542 + s548*s97 + s567*s99 + s576 + s581 + s583 + s589 + s595
    s603 = -0.25*s239*s601
    s617 = -s60*(-axis_x*s523 - axis_y*s521 - axis_z*s519)
    s623 = s207*s585 + s208*s591 + s249*(-0.5*s562 - 0.5*s577 + s603) + s565 - s571
    s624 = s207*s572 + s222*s591 + s246*(-0.5*s562 - 0.5*s596 + s603) - s569 + s584
    s625 = s208*s572 + s222*s585 + s243*(-0.5*s577 - 0.5*s596 + s603) + s582 - s590
    out[0] = s151
    out[1] = s157
    out[2] = s155
    out[3] = s153
    out[4] = s264
    out[5] = s265
    out[6] = s266
    out[7] = s258
    out[8] = s517
    out[9] = s523
    out[10] = s521
    out[11] = s519
    out[12] = s623
    out[13] = s624
    out[14] = s625
    out[15] = s617


@njit(cache=True, nogil=True, error_model="numpy")
def _parameters(x, q, tool, k, out):
    """Per rod of one limb: derivatives of the closure by errors, by deflections (260 operations)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    q = q
    s60 = k[0]
    s59 = k[1]
    axis_x = k[2]
    s65 = k[3]
    axis_y = k[4]
    s68 = k[5]
    axis_z = k[6]
    s106 = k[7]
    s109 = k[8]
    u_x = k[9]
    u_y = k[10]
    s128 = k[11]
    s58 = k[21]
    s280 = k[22]
    s278 = k[23]
    s286 = k[24]
    s326 = k[25]
    s354 = k[26]
    s358 = k[27]
    s361 = k[28]
    s397 = k[29]
    s425 = k[30]
    s429 = k[31]
    s432 = k[32]
    s468 = k[33]
    s495 = k[34]
    s498 = k[35]
    s501 = k[36]
    s628 = k[37]
    s504 = k[38]
    s656 = k[39]
    s62 = -q*s60 + s59
    C_x = axis_x*s62 + s65
    C_y = axis_y*s62 + s68
    C_z = axis_z*s62
    s71 = (cx * cx)
    s73 = (cy * cy)
    s75 = (cz * cz)
    s78 = (1.0 / (0.25*s71 + 0.25*s73 + 0.25*s75 + 1))
    s79 = -0.5*s73
    s80 = -0.5*s75
    R_11 = s78*(s79 + s80) + 1
    s84 = 0.5*cx*cy
    R_12 = s78*(-cz + s84)
    s87 = 0.5*cx*cz
    R_13 = s78*(cy + s87)
    R_21 = s78*(cz + s84)
    s92 = -0.5*s71
    R_22 = s78*(s80 + s92) + 1
    s96 = 0.5*cy*cz
    R_23 = s78*(-cx + s96)
    R_31 = s78*(-cy + s87)
    R_32 = s78*(cx + s96)
    R_33 = s78*(s79 + s92) + 1
    s107 = s106 - tx
    s110 = s109 - ty
    A_x = R_11*s107 + R_12*s110 - R_13*tz + px
    A_y = R_21*s107 + R_22*s110 - R_23*tz + py
    A_z = R_31*s107 + R_32*s110 - R_33*tz + pz
    d_x = A_x - C_x
    d_y = A_y - C_y
    d_z = A_z - C_z
    s_x = s128*(-R_11*u_y + R_12*u_x + u_y)
    s_y = s128*(-R_21*u_y + R_22*u_x - u_x)
    s_z = s128*(-R_31*u_y + R_32*u_x)
    s153 = d_z + s_z
    s155 = d_y + s_y
    s157 = d_x + s_x
    s159 = s128*s153
    s165 = s128*s155
    s170 = s128*s157
    s251 = -s153*s62
    s253 = -s155*s62
    s255 = -s157*s62
    s257 = -axis_x*s157 - axis_y*s155 - axis_z*s153
    s259 = -q*s257
    s277 = s257*s58
    s282 = s257*s280 + s278
    s288 = -s155*u_y - s157*u_x + s257*s286
    s289 = u_x*(-R_11*s170 - R_21*s165 - R_31*s159 + s170)
    s290 = -u_y*(R_12*s170 + R_22*s165 + R_32*s159 - s165)
    s291 = s106*(R_12*s157 + R_22*s155 + R_32*s153)
    s292 = -s109*(R_11*s157 + R_21*s155 + R_31*s153)
    s356 = s157*s68
    s359 = s255*s358
    s362 = s257*s361
    s363 = -s155*s65 + s251*s326 + s253*s354 + s289 + s290 + s291 + s292 + s356 + s359 + s362
    s434 = s251*s397 + s253*s425 + s255*s429 + s257*s432
    s503 = s251*s468 + s253*s495 + s255*s498 + s257*s501
    s519 = d_z - s_z
    s521 = d_y - s_y
    s523 = d_x - s_x
    s525 = -s128*s519
    s531 = -s128*s521
    s536 = -s128*s523
    s610 = -s519*s62
    s612 = -s521*s62
    s614 = -s523*s62
    s616 = -axis_x*s523 - axis_y*s521 - axis_z*s519
    s618 = -q*s616
    s627 = s58*s616
    s630 = s280*s616 + s628
    s634 = s286*s616 - s521*u_y - s523*u_x
    s635 = u_x*(-R_11*s536 - R_21*s531 - R_31*s525 + s536)
    s636 = -u_y*(R_12*s536 + R_22*s531 + R_32*s525 - s531)
    s637 = s106*(R_12*s523 + R_22*s521 + R_32*s519)
    s638 = -s109*(R_11*s523 + R_21*s521 + R_31*s519)
    s642 = s523*s68
    s643 = s358*s614
    s644 = s361*s616
    s645 = s326*s610 + s354*s612 - s521*s65 + s635 + s636 + s637 + s638 + s642 + s643 + s644
    s650 = s397*s610 + s425*s612 + s429*s614 + s432*s616
    s655 = s468*s610 + s495*s612 + s498*s614 + s501*s616
    out[0] = s277
    out[1] = s282
    out[2] = s288
    out[3] = s363
    out[4] = s434
    out[5] = s503
    out[6] = s259
    out[7] = s504
    out[8] = s288
    out[9] = s627
    out[10] = s630
    out[11] = s634
    out[12] = s645
    out[13] = s650
    out[14] = s655
    out[15] = s618
    out[16] = s656
    out[17] = s634


@njit(cache=True, nogil=True, error_model="numpy")
def _sphere(x, q, tool, k, out):
    """The simplified limb as a sphere |P|^2 / 2 - c.P + d = 0: c, d (14 operations)."""
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    q = q
    s60 = k[0]
    s660 = k[14]
    s665 = k[15]
    h = k[16]
    s672 = k[17]
    s687 = -s660 + tx
    s688 = -s665 + ty
    s689 = h - q*s60 + tz
    s696 = s672 + 0.5*(s687 * s687) + 0.5*(s688 * s688) + 0.5*(s689 * s689)
    out[0] = s687
    out[1] = s688
    out[2] = s689
    out[3] = s696


@njit(cache=True, nogil=True, error_model="numpy")
def _joint(x, q, tool, k, out):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (22 operations)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s660 = k[14]
    s665 = k[15]
    h = k[16]
    s672 = k[17]
    s674 = k[18]
    s680 = k[19]
    s684 = k[20]
    s669 = -h + pz - tz
    s670 = (s669 * s669)
    s673 = 0.5*s670 + s672 + 0.5*((px + s660 - tx) * (px + s660 - tx)) + 0.5*((py + s665 - ty) * (py + s665 - ty))
    s686 = s669*s684 - math.sqrt(s670*s680 + s673*s674)
    out[0] = s686


@njit(cache=True, nogil=True, error_model="numpy")
def _closure(x, q, tool, k, out, F, J_x, J_q):
    """Fill closure F (6,), J_x (6, 6) and the joints' part J_q (6,) of one pose; k (3, :), out scratch."""
    for i in range(3):
        _newton(x, q[i], tool, k[i], out)
        for j in range(2):
            row, start = 2 * i + j, 8 * j
            F[row] = out[start]
            for c in range(6):
                J_x[row, c] = out[start + 1 + c]
            J_q[row] = out[start + 7]


@njit(cache=True, nogil=True, error_model="numpy")
def _solve(A, B, columns):
    """Solve A X = B in place by Gauss elimination with partial pivoting; X takes the place of B.

    Returns False where a pivot falls below PIVOT_SINGULAR of the largest entry of A: then A is singular to that tolerance.
    """
    largest = 0.0
    for r in range(6):
        for c in range(6):
            largest = max(largest, abs(A[r, c]))
    for c in range(6):
        pivot = c
        for r in range(c + 1, 6):
            if abs(A[r, c]) > abs(A[pivot, c]):
                pivot = r
        if not abs(A[pivot, c]) > PIVOT_SINGULAR * largest:
            return False
        if pivot != c:
            for j in range(c, 6):
                A[c, j], A[pivot, j] = A[pivot, j], A[c, j]
            for j in range(columns):
                B[c, j], B[pivot, j] = B[pivot, j], B[c, j]
        inverse = 1.0 / A[c, c]
        for r in range(c + 1, 6):
            factor = A[r, c] * inverse
            if factor != 0.0:
                for j in range(c + 1, 6):
                    A[r, j] -= factor * A[c, j]
                for j in range(columns):
                    B[r, j] -= factor * B[c, j]
    for c in range(5, -1, -1):
        inverse = 1.0 / A[c, c]
        for j in range(columns):
            B[c, j] *= inverse
        for r in range(c):
            factor = A[r, c]
            if factor != 0.0:
                for j in range(columns):
                    B[r, j] -= factor * B[c, j]
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def _stuck(F):
    """Return what a pose is where Newton's matrix is singular: SINGULAR if its loops are closed, else UNREACHABLE."""
    for r in range(6):
        if not abs(F[r]) < CLOSED:
            return UNREACHABLE
    return SINGULAR


@njit(cache=True, nogil=True, error_model="numpy")
def jacobians(x, q, tool, k, F, J_x, J_q, J_p):
    """Fill the closure F (N, 6) and its Jacobians J_x (N, 6, 6), J_q (N, 6), J_p (N, 6, 9).

    Rows 2 i .. 2 i + 1 belong to limb i and depend on its own joint, errors and deflections only:
    J_q and J_p hold the derivatives by those.
    """
    out, by_errors = np.zeros(16), np.zeros(18)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F[n], J_x[n], J_q[n])
        for i in range(3):
            _parameters(x[n], q[n, i], tool[n], k[m, i], by_errors)
            for j in range(2):
                for c in range(9):
                    J_p[n, 2 * i + j, c] = by_errors[9 * j + c]


@njit(cache=True, nogil=True, error_model="numpy")
def _meet(sphere, pose):
    """Put the position where three spheres meet into pose[:3]; False where their centres lie on one line.

    Differences of the spheres are planes; two planes are a line, on which the first sphere is a quadratic. Where the
    line misses the sphere its nearest point is taken: the exact machine may still reach what the simplified one
    cannot.
    """
    ax, ay, az = sphere[1, 0] - sphere[0, 0], sphere[1, 1] - sphere[0, 1], sphere[1, 2] - sphere[0, 2]
    bx, by, bz = sphere[2, 0] - sphere[0, 0], sphere[2, 1] - sphere[0, 1], sphere[2, 2] - sphere[0, 2]
    da, db = sphere[1, 3] - sphere[0, 3], sphere[2, 3] - sphere[0, 3]
    nx, ny, nz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    nn = nx * nx + ny * ny + nz * nz
    aa = ax * ax + ay * ay + az * az
    bb = bx * bx + by * by + bz * bz
    if not nn > PIVOT_SINGULAR * aa * bb:
        return False
    # the point of the line in the plane of a and b: u a + v b with a.P = da, b.P = db
    ab = ax * bx + ay * by + az * bz
    u = (da * bb - db * ab) / nn
    v = (db * aa - da * ab) / nn
    px, py, pz = u * ax + v * bx, u * ay + v * by, u * az + v * bz
    # |P + t n|^2 / 2 - c.(P + t n) + d = 0
    half = (px * nx + py * ny + pz * nz) - (sphere[0, 0] * nx + sphere[0, 1] * ny + sphere[0, 2] * nz)
    rest = 0.5 * (px * px + py * py + pz * pz) - (sphere[0, 0] * px + sphere[0, 1] * py + sphere[0, 2] * pz) + sphere[0, 3]
    root = math.sqrt(max(half * half - 2.0 * nn * rest, 0.0))
    sign = -1.0 if nz > 0.0 else 1.0
    t = (-half + sign * root) / nn
    pose[0], pose[1], pose[2] = px + t * nx, py + t * ny, pz + t * nz
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def forward(q, tool, k, x, status, warm):
    """Fill x (N, 6) with the exact platform pose at the joints q, by Newton from the simplified machine, or from x where warm.

    status (N,): SOLVED, UNREACHABLE (no platform pose closes all loops) or SINGULAR; x is NaN unless SOLVED.
    """
    F, J_q = np.empty(6), np.empty(6)
    J_x = np.empty((6, 6))
    step = np.empty((6, 1))
    out = np.zeros(16)
    pose = np.zeros(6)
    sphere = np.empty((3, 4))
    for n in range(q.shape[0]):
        m = n if k.shape[0] > 1 else 0
        seeded = True
        for c in range(6):
            pose[c] = x[n, c] if warm else 0.0
            seeded = seeded and math.isfinite(pose[c])
        if not (warm and seeded):
            pose[:] = 0.0
            for i in range(3):
                _sphere(pose, q[n, i], tool[n], k[m, i], sphere[i])
            seeded = _meet(sphere, pose)
        status[n] = UNREACHABLE if seeded else SINGULAR
        for _ in range(MAX_STEPS if seeded else 0):
            _closure(pose, q[n], tool[n], k[m], out, F, J_x, J_q)
            for r in range(6):
                step[r, 0] = F[r]
            if not _solve(J_x, step, 1):
                status[n] = _stuck(F)
                break
            size = 0.0
            for c in range(6):
                pose[c] -= step[c, 0]
                size = max(size, abs(step[c, 0]))
            if size < STEP_DONE:
                status[n] = SOLVED
                break
            if not size < STEP_LOST:
                break
        for c in range(6):
            x[n, c] = pose[c] if status[n] == SOLVED else np.nan


@njit(cache=True, nogil=True, error_model="numpy")
def inverse(target, tool, k, x, q, status):
    """Fill the joints q (N, 3) that bring the reference point to target (N, 3), and the pose x (N, 6) it then has.

    Newton on the joints and the platform's rotation from the simplified machine. status as in `forward`; UNREACHABLE
    where the target lies beyond the reach of a limb.
    """
    F, J_q = np.empty(6), np.empty(6)
    J_x = np.empty((6, 6))
    A = np.empty((6, 6))
    step = np.empty((6, 1))
    out = np.zeros(16)
    pose, joints, start = np.zeros(6), np.empty(3), np.zeros(1)
    for n in range(target.shape[0]):
        m = n if k.shape[0] > 1 else 0
        pose[:] = 0.0
        for c in range(3):
            pose[c] = target[n, c]
        seeded = True
        for i in range(3):
            _joint(pose, 0.0, tool[n], k[m, i], start)
            joints[i] = start[0]
            seeded = seeded and math.isfinite(joints[i])
        status[n] = UNREACHABLE
        for _ in range(MAX_STEPS if seeded else 0):
            _closure(pose, joints, tool[n], k[m], out, F, J_x, J_q)
            A[:] = 0.0
            for r in range(6):
                A[r, r // 2] = J_q[r]
                for c in range(3):
                    A[r, 3 + c] = J_x[r, 3 + c]
                step[r, 0] = F[r]
            if not _solve(A, step, 1):
                status[n] = _stuck(F)
                break
            size = 0.0
            for c in range(3):
                joints[c] -= step[c, 0]
                size = max(size, abs(step[c, 0]))
            for c in range(3):
                pose[3 + c] -= step[3 + c, 0]
                size = max(size, abs(step[3 + c, 0]))
            if size < STEP_DONE * ANGLE_STEP:
                status[n] = SOLVED
                break
            if not size < STEP_LOST:
                break
        for c in range(3):
            q[n, c] = joints[c] if status[n] == SOLVED else np.nan
        for c in range(6):
            x[n, c] = pose[c] if status[n] == SOLVED else np.nan


@njit(cache=True, nogil=True, error_model="numpy")
def sensitivity(x, q, tool, k, S_p, S_q, status):
    """Fill the derivatives of the exact pose: S_p (N, 6, 27) by errors and deflections, S_q (N, 6, 3) by joints.

    ``J_x S = -J``. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    F, J_q = np.empty(6), np.empty(6)
    J_x = np.empty((6, 6))
    unit = np.empty((6, 6))
    out = np.zeros(16)
    J_p = np.zeros(18)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F, J_x, J_q)
        unit[:] = 0.0
        for r in range(6):
            unit[r, r] = -1.0
        status[n] = SOLVED if _solve(J_x, unit, 6) else SINGULAR
        for i in range(3):
            _parameters(x[n], q[n, i], tool[n], k[m, i], J_p)
            for r in range(6):
                for c in range(9):
                    total = 0.0
                    for j in range(2):
                        total += unit[r, 2 * i + j] * J_p[9 * j + c]
                    S_p[n, r, 9 * i + c] = total if status[n] == SOLVED else np.nan
                total = 0.0
                for j in range(2):
                    total += unit[r, 2 * i + j] * J_q[2 * i + j]
                S_q[n, r, i] = total if status[n] == SOLVED else np.nan


def linear_constants(p):
    """Return k (M, 3, 22), what `linear` reads that no pose changes, from p (62 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    k = np.zeros((p.shape[0], 3, 22))
    r = p[..., 0]
    l = p[..., 1]
    phi = p[..., 2]
    home = p[..., 3]
    a = p[..., 4]
    c = p[..., 5]
    endstop = p[..., 6]
    arm = p[..., 7]
    radius = p[..., 8]
    angle = p[..., 9]
    lean_radial = p[..., 10]
    lean_tangential = p[..., 11]
    scale = p[..., 12]
    dl = p[..., 13]
    dr = p[..., 14]
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
    s70 = -0.5*dl*l
    s71 = s69 + s70
    s86 = s69 - s70
    k[..., 0] = s55
    k[..., 1] = s60
    k[..., 2] = s12
    k[..., 3] = h
    k[..., 4] = axis_x_errors
    k[..., 5] = s27
    k[..., 6] = axis_y_errors
    k[..., 7] = s33
    k[..., 8] = scale
    k[..., 9] = h_errors
    k[..., 10] = s37
    k[..., 11] = s39
    k[..., 12] = s23
    k[..., 13] = s42
    k[..., 14] = s29
    k[..., 15] = s44
    k[..., 16] = s71
    k[..., 17] = s_z_cx
    k[..., 18] = s_z_cy
    k[..., 19] = s_x_cz
    k[..., 20] = s_y_cz
    k[..., 21] = s86
    return k


@njit(cache=True, nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (13 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s55 = k[i, 0]
    s60 = k[i, 1]
    s12 = k[i, 2]
    h = k[i, 3]
    s64 = math.sqrt(s12 - ((px + s55 - tx) * (px + s55 - tx)) - ((py + s60 - ty) * (py + s60 - ty)))
    s65 = h - pz - s64 + tz
    row = 1 * i
    out[row + 0] = s65


@njit(cache=True, nogil=True, error_model="numpy")
def _linear(x, q, tool, k, i, out):
    """Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (54 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    h = k[i, 3]
    axis_x_errors = k[i, 4]
    s27 = k[i, 5]
    axis_y_errors = k[i, 6]
    s33 = k[i, 7]
    scale = k[i, 8]
    h_errors = k[i, 9]
    s37 = k[i, 10]
    s39 = k[i, 11]
    s23 = k[i, 12]
    s42 = k[i, 13]
    s29 = k[i, 14]
    s44 = k[i, 15]
    s71 = k[i, 16]
    s_z_cx = k[i, 17]
    s_z_cy = k[i, 18]
    s_x_cz = k[i, 19]
    s_y_cz = k[i, 20]
    s86 = k[i, 21]
    s21 = h - q
    C_x_errors = axis_x_errors*s21 + s27
    C_y_errors = axis_y_errors*s21 + s33
    C_z_errors = h_errors - q*scale
    s38 = s37 - tx
    s40 = s39 - ty
    A_x = px + s38
    A_y = py + s40
    A_z = pz - tz
    d_x = A_x - s23
    d_x_errors = -C_x_errors + s42
    d_y = A_y - s29
    d_y_errors = -C_y_errors + s44
    d_z = A_z - s21
    s66 = d_x*d_x_errors
    s67 = d_y*d_y_errors
    s68 = -C_z_errors*d_z
    s72 = s66 + s67 + s68 + s71
    s73 = d_y*tz
    s74 = d_z*s40
    s75 = d_z*s_z_cx
    s76 = s73 + s74 + s75
    s77 = -d_x*tz
    s78 = -d_z*s38
    s79 = d_z*s_z_cy
    s80 = s77 + s78 + s79
    s81 = -d_x*s40
    s82 = d_y*s38
    s83 = d_x*s_x_cz
    s84 = d_y*s_y_cz
    s85 = s81 + s82 + s83 + s84
    s87 = s66 + s67 + s68 + s86
    s88 = s73 + s74 - s75
    s89 = s77 + s78 - s79
    s90 = s81 + s82 - s83 - s84
    row = 16 * i
    out[row + 0] = s72
    out[row + 4] = s76
    out[row + 5] = s80
    out[row + 6] = s85
    out[row + 7] = d_z
    out[row + 8] = s87
    out[row + 12] = s88
    out[row + 13] = s89
    out[row + 14] = s90
    out[row + 15] = d_z


@njit(cache=True, nogil=True, error_model="numpy")
def _hold(work):
    """Solve for the changes of joints and rotation that undo the closures while the reference point stays in place.

    work: per rod closure, its derivatives by the platform and by the joint; then room for the reduced equations; then
    the changes. A limb's joint is eliminated with the rod that feels it most; what is left are 3 equations for the
    rotation. Returns False where a joint is felt by no rod of its limb, or the rotation is not held.
    """
    largest = 0.0
    for row in range(6):
        for c in range(4, 8):
            largest = max(largest, abs(work[8 * row + c]))
    smallest = PIVOT_SINGULAR * largest
    target = 48
    for i in range(3):
        best = 16 * i
        for j in range(1, 2):
            if abs(work[16 * i + 8 * j + 7]) > abs(work[best + 7]):
                best = 16 * i + 8 * j
        if not abs(work[best + 7]) > smallest:
            return False
        inverse = 1.0 / work[best + 7]
        for j in range(2):
            rod = 16 * i + 8 * j
            if rod != best:
                factor = work[rod + 7] * inverse
                for c in range(3):
                    work[target + c] = work[rod + 4 + c] - factor * work[best + 4 + c]
                work[target + 3] = work[rod] - factor * work[best]
                target += 4
        # the joint's own equation, left to the end: closure and rotation over the joint's derivative
        for c in range(3):
            work[16 * i + 4 + c] = work[best + 4 + c] * inverse
        work[60 + i] = work[best] * inverse
    for c in range(3):
        pivot = 48 + 4 * c
        for r in range(c + 1, 3):
            if abs(work[48 + 4 * r + c]) > abs(work[pivot + c]):
                pivot = 48 + 4 * r
        row = 48 + 4 * c
        if not abs(work[pivot + c]) > smallest:
            return False
        if pivot != row:
            for j in range(c, 4):
                work[row + j], work[pivot + j] = work[pivot + j], work[row + j]
        inverse = 1.0 / work[row + c]
        for r in range(c + 1, 3):
            below = 48 + 4 * r
            factor = work[below + c] * inverse
            for j in range(c + 1, 4):
                work[below + j] -= factor * work[row + j]
    for c in range(2, -1, -1):
        row = 48 + 4 * c
        total = work[row + 3]
        for j in range(c + 1, 3):
            total -= work[row + j] * work[63 + j]
        work[63 + c] = total / work[row + c]
    for i in range(3):
        for c in range(3):
            work[60 + i] -= work[16 * i + 4 + c] * work[63 + c]
    return True


@njit(cache=True, nogil=True, error_model="numpy")
def exact_command(target, tool, k, work, q):
    """Fill the joints q (3,) that bring the reference point to target (3,); return the status.

    `inverse` for one pose, to be called from a servo loop: tool (3,), k (3, :), scratch work (COMMAND_WORK,).
    q is NaN unless SOLVED.
    """
    pose = work[66:]
    for c in range(3):
        pose[c] = target[c]
    for c in range(3):
        pose[3 + c] = 0.0
    status = SOLVED
    for i in range(3):
        _joint(pose, 0.0, tool, k[i], work)
        q[i] = work[0]
        if not math.isfinite(q[i]):
            status = UNREACHABLE
    if status == SOLVED:
        status = UNREACHABLE
        for _ in range(MAX_STEPS):
            for i in range(3):
                _newton(pose, q[i], tool, k[i], work[16 * i : 16 * (i + 1)])
            if not _hold(work):
                status = SINGULAR
                break
            size = 0.0
            for i in range(3):
                q[i] -= work[60 + i]
                size = max(size, abs(work[60 + i]))
            for c in range(3):
                pose[3 + c] -= work[63 + c]
                size = max(size, abs(work[63 + c]))
            if size < COMMAND_DONE:
                status = SOLVED
                break
            if not size < STEP_LOST:
                break
    if status != SOLVED:
        for i in range(3):
            q[i] = np.nan
    return status


@njit(cache=True, nogil=True, error_model="numpy")
def linear_command(target, tool, k, work, q):
    """Fill the joints q (3,) that bring the reference point to target (3,) to first order in the errors; return the status.

    Bai's eqs. (23) and (25): the nominal joints of the target, and the change that keeps the reference point where it
    is, to first order, when the errors appear. tool (3,), k (3, 22) from `linear_constants`, scratch work
    (COMMAND_WORK,). q is NaN unless SOLVED.
    """
    status = SOLVED
    for i in range(3):
        _nominal_joint(target, 0.0, tool, k, i, q)
        if not math.isfinite(q[i]):
            status = UNREACHABLE
    if status == SOLVED:
        for i in range(3):
            _linear(target, q[i], tool, k, i, work)
        if not _hold(work):
            status = SINGULAR
    for i in range(3):
        q[i] = q[i] - work[60 + i] if status == SOLVED else np.nan
    return status


@njit(cache=True, nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 3) and status (N,) by `linear_command`; target (N, 3) and tool (N, 3), k (M, 3, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])
