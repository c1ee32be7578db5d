"""Kinematics of `linear_delta` in plain NumPy: Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both f13c450aa9655d58; SymPy 1.14.0.

The functions of ``kinematics.py`` over all poses at once, from the same lowered kernels. Nothing is compiled: a first
small job is done before Numba would be loaded, and the compiled kernels have an independent check.
"""

import numpy as np

SOLVED, UNREACHABLE, SINGULAR = 0, 1, 2
FEW = 100  # poses at once, up to which calls of NumPy cost more than what they compute
MAX_STEPS = 30
STEP_DONE = 1e-9  # mm and rad; Newton is quadratic: after such a step the rest is rounding
STEP_LOST = 1e5  # mm and rad; a step of this size leads nowhere
ANGLE_STEP = 1e-3  # rad per mm: joints and rotations are asked for this much finer than lengths
CLOSED = 1e-3  # mm^2: loops that are open by more where Newton gets stuck cannot be closed
PIVOT_SINGULAR = 1e-9  # of the largest entry of its matrix, in mm


def constants(p):
    """Return k (M, 3, 53), what no pose changes, from p (386 operations).

    All rows at once.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((53, p.shape[1], 3))
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
    s148 = arm_0 + s147 + stretch
    s150 = -0.5*(s148 * s148)
    s268 = -2*s49*s7
    s269 = 2*s11
    s270 = 2*s7
    s271 = -2*s11*s49
    s273 = 0.5/np.sqrt(s55)
    s274 = 2*arm_0
    s276 = (1.0 / (axis_z * axis_z))
    s278 = -s148
    s280 = s273*s274*s58
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
    s514 = arm_0 - s147 + stretch
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
    s680 = 0.25*(s678 * s678)/(s60 * s60 * s60 * s60)
    s684 = -0.5*s657*s678
    s714 = -arm_0*stretch - 0.125*(dl * dl) + s672 - 0.5*(stretch * stretch)
    s834 = -0.5*s274 - stretch
    s862 = -0.25*dl
    s864 = -arm_0 - stretch
    s870 = -0.5*arm_0*dl - 0.5*dl*stretch
    s1004 = -0.5*arm_0 - 0.5*stretch
    s1009 = 0.5*c*u_y
    s1011 = -0.5*c*u_x
    s1049 = axis_x*s60
    s1051 = axis_y*s60
    s1053 = axis_z*s60
    k[0] = s60
    k[1] = s59
    k[2] = axis_x
    k[3] = s65
    k[4] = axis_y
    k[5] = s68
    k[6] = axis_z
    k[7] = s106
    k[8] = s109
    k[9] = u_x
    k[10] = u_y
    k[11] = s128
    k[12] = s150
    k[13] = s516
    k[14] = s660
    k[15] = s665
    k[16] = h
    k[17] = s672
    k[18] = s674
    k[19] = s680
    k[20] = s684
    k[21] = s58
    k[22] = s280
    k[23] = s278
    k[24] = s286
    k[25] = s326
    k[26] = s354
    k[27] = s358
    k[28] = s361
    k[29] = s397
    k[30] = s425
    k[31] = s429
    k[32] = s432
    k[33] = s468
    k[34] = s495
    k[35] = s498
    k[36] = s501
    k[37] = s628
    k[38] = s504
    k[39] = s656
    k[40] = s53
    k[41] = s714
    k[42] = s870
    k[43] = s1009
    k[44] = s1011
    k[45] = s1049
    k[46] = s1051
    k[47] = s1053
    k[48] = s834
    k[49] = s147
    k[50] = s862
    k[51] = s864
    k[52] = s1004
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


def _newton(x, q, tool, k):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint: (16, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
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
    out = np.zeros((16, *(k.shape[1], x.shape[-1])))
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
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (20, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
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
    out = np.zeros((20, *(k.shape[1], x.shape[-1])))
    out[0] = s277
    out[1] = s282
    out[2] = s288
    out[3] = s363
    out[4] = s434
    out[5] = s503
    out[6] = s259
    out[7] = s504
    out[8] = s288
    out[9] = s278
    out[10] = s627
    out[11] = s630
    out[12] = s634
    out[13] = s645
    out[14] = s650
    out[15] = s655
    out[16] = s618
    out[17] = s656
    out[18] = s634
    out[19] = s628
    return out


def _sphere(x, q, tool, k):
    """The simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d: (4, limbs, N)."""
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s60 = k[0]
    s660 = k[14]
    s665 = k[15]
    h = k[16]
    s53 = k[40]
    s687 = -s660 + tx
    s688 = -s665 + ty
    s689 = h - q*s60 + tz
    s693 = -s53 + (s687 * s687) + (s688 * s688) + (s689 * s689)
    out = np.zeros((4, *(k.shape[1], x.shape[-1])))
    out[0] = s687
    out[1] = s688
    out[2] = s689
    out[3] = s693
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (1, limbs, N)."""
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
    s686 = s669*s684 - np.sqrt(s670*s680 + s673*s674)
    out = np.zeros((1, *(k.shape[1], x.shape[-1])))
    out[0] = s686
    return out


def _spin(x):
    """Turn about the axes of {O} by the Cayley vector: (9, N)."""
    cx = x[3]
    cy = x[4]
    cz = x[5]
    s78 = (1.0 / (0.25*(cx * cx) + 0.25*(cy * cy) + 0.25*(cz * cz) + 1))
    s694 = -0.5*cz*s78
    s695 = 0.5*cy*s78
    s696 = -0.5*cx*s78
    out = np.zeros((9, *x.shape[1:]))
    out[0] = s78
    out[1] = s694
    out[2] = s695
    out[3] = -s694
    out[4] = s78
    out[5] = s696
    out[6] = -s695
    out[7] = -s696
    out[8] = s78
    return out


def _of(k, chosen):
    return k[chosen] if len(k) > 1 else k


def _turned(x, q, tool, k):
    """Return arrays as the kernels read them: poses last, limbs before them, so that one call does all limbs.

    Few poses are laid out for every limb, and constants for every pose: matching shapes is most of what a small
    operation of NumPy costs.
    """
    if len(x) > FEW:
        return x.T.copy(), q.T.copy(), tool.T.copy(), k.T.copy()
    x, tool, k = (np.broadcast_to(a, (len(a), 3, len(x))).copy() for a in (x.T[:, None], tool.T[:, None], k.T))
    return x, q.T.copy(), tool, k


def _by_rod(values):
    """Return what a kernel gives of the rods of a limb (rods k, limbs, N) as (6, k, N): limb by limb."""
    each = len(values) // 2
    by_rod = values.reshape(2, each, *values.shape[1:])
    return by_rod.transpose(2, 0, 1, 3).reshape(6, each, values.shape[2])


def _closure(x, q, tool, k):
    """Return F (6, N), J_x (6, 6, N) and the joints' part J_q (6, N)."""
    rows = _by_rod(_newton(*_turned(x, q, tool, k)))
    return rows[:, 0], rows[:, 1 : 7], rows[:, 7]


def _solve(A, B):
    """Return X of A X = B (n, m, N) by Gauss-Jordan elimination, partial pivoting, and (N,) whether A is regular."""
    n, both, every = len(A), np.concatenate([A, B], axis=1), np.arange(A.shape[2])
    pivots = np.empty((n, len(every)))
    with np.errstate(divide="ignore", invalid="ignore"):
        for c in range(n):
            pivot = c + np.abs(both[c:, c]).argmax(axis=0)
            row = both[pivot, c:, every].T
            both[pivot, c:, every] = both[c, c:].T
            pivots[c] = row[0]
            row = row[1:] / row[0]
            both[:, c + 1 :] -= both[:, c, None] * row
            both[c, c + 1 :] = row
    return both[:, n:], (np.abs(pivots) > PIVOT_SINGULAR * np.abs(A).max(axis=(0, 1), initial=0.0)).all(axis=0)


def jacobians(x, q, tool, k, F, J_x, J_q, J_p):
    """See ``kinematics.jacobians``."""
    for given, found in zip((F, J_x, J_q), _closure(x, q, tool, k), strict=True):
        given[:] = np.moveaxis(found, -1, 0)
    J_p[:] = np.moveaxis(_by_rod(_parameters(*_turned(x, q, tool, k))), -1, 0)


def _meet(spheres):
    """Where the spheres meet; how far off the centres, how far these are apart, what that is compared with: (6, N)."""
    c_00 = spheres[0]
    c_01 = spheres[1]
    c_02 = spheres[2]
    c_03 = spheres[3]
    c_10 = spheres[4]
    c_11 = spheres[5]
    c_12 = spheres[6]
    c_13 = spheres[7]
    c_20 = spheres[8]
    c_21 = spheres[9]
    c_22 = spheres[10]
    c_23 = spheres[11]
    a_x = -c_00 + c_10
    a_y = -c_01 + c_11
    a_z = -c_02 + c_12
    b_x = -c_00 + c_20
    b_y = -c_01 + c_21
    b_z = -c_02 + c_22
    s7 = -0.5*c_03
    to_a = 0.5*c_13 + s7
    to_b = 0.5*c_23 + s7
    aa = (a_x * a_x) + (a_y * a_y) + (a_z * a_z)
    n_x = a_y*b_z - a_z*b_y
    n_y = -a_x*b_z + a_z*b_x
    n_z = a_x*b_y - a_y*b_x
    nn = (n_x * n_x) + (n_y * n_y) + (n_z * n_z)
    bb = (b_x * b_x) + (b_y * b_y) + (b_z * b_z)
    ab = a_x*b_x + a_y*b_y + a_z*b_z
    inverse = (1.0 / nn)
    by_a = inverse*(-ab*to_b + bb*to_a)
    by_b = inverse*(aa*to_b - ab*to_a)
    p_x = a_x*by_a + b_x*by_b
    p_y = a_y*by_a + b_y*by_b
    p_z = a_z*by_a + b_z*by_b
    half = inverse*(n_x*(-c_00 + p_x) + n_y*(-c_01 + p_y) + n_z*(-c_02 + p_z))
    s66 = -2*c_01*p_y
    s67 = -2*c_02*p_z
    rest = -2*c_00*p_x + c_03 + (p_x * p_x) + (p_y * p_y) + (p_z * p_z) + s66 + s67
    under = (half * half) - inverse*rest
    kept = np.where((under > 0), under, 0)
    s73 = np.sqrt(kept)
    along = -half - np.where((n_z > 0), s73, -s73)
    s77 = along*n_x + p_x
    s79 = along*n_y + p_y
    s81 = along*n_z + p_z
    s82 = nn*under
    s83 = aa*bb
    out = np.zeros((6, *spheres.shape[1:]))
    out[0] = s77
    out[1] = s79
    out[2] = s81
    out[3] = s82
    out[4] = nn
    out[5] = s83
    return out


def forward(q, tool, k, x, status, warm):
    """See ``kinematics.forward``."""
    status[:] = UNREACHABLE
    if not (warm and np.isfinite(x).all()):
        x[:] = 0.0
        spheres = _sphere(*_turned(x, q, tool, k)).swapaxes(0, 1).reshape(12, -1)
        with np.errstate(divide="ignore", invalid="ignore"):
            *at, _, square, wide = _meet(spheres)
        x[:, :3] = np.transpose(at)
        status[~(square > PIVOT_SINGULAR * wide)] = SINGULAR
    active = np.flatnonzero(status == UNREACHABLE)
    for _ in range(MAX_STEPS):
        if not len(active):
            break
        F, J_x, _ = _closure(x[active], q[active], tool[active], _of(k, active))
        step, regular = _solve(J_x, F[:, None])
        status[active[~regular]] = np.where(
            np.abs(F[:, ~regular]).max(axis=0, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE
        )
        active, step = active[regular], step[:, 0, regular].T
        x[active] -= step
        size = np.abs(step).max(axis=1, initial=0.0)
        status[active[size < STEP_DONE]] = SOLVED
        active = active[(size >= STEP_DONE) & (size < STEP_LOST)]
    x[status != SOLVED] = np.nan


def inverse(target, tool, k, x, q, status):
    """See ``kinematics.inverse``."""
    x[:] = 0.0
    x[:, :3] = target
    with np.errstate(invalid="ignore"):
        x_, _, tool_, k_ = _turned(x, q, tool, k)
        start = _joint(x_, 0.0, tool_, k_)
    q[:] = start[0].T
    status[:] = UNREACHABLE
    active = np.flatnonzero(np.isfinite(q).all(axis=1))
    for _ in range(MAX_STEPS):
        if not len(active):
            break
        F, J_x, J_q = _closure(x[active], q[active], tool[active], _of(k, active))
        A = np.zeros((6, 6, len(active)))
        A[range(6), np.arange(6) // 2] = J_q
        A[:, 3:] = J_x[:, 3:]
        step, regular = _solve(A, F[:, None])
        status[active[~regular]] = np.where(
            np.abs(F[:, ~regular]).max(axis=0, initial=0.0) < CLOSED, SINGULAR, UNREACHABLE
        )
        active, step = active[regular], step[:, 0, regular].T
        q[active] -= step[:, :3]
        x[active, 3:] -= step[:, 3:]
        size = np.abs(step).max(axis=1, initial=0.0)
        status[active[size < STEP_DONE * ANGLE_STEP]] = SOLVED
        active = active[(size >= STEP_DONE * ANGLE_STEP) & (size < STEP_LOST)]
    x[status != SOLVED], q[status != SOLVED] = np.nan, np.nan


def sensitivity(x, q, tool, k, S_p, S_q, status):
    """See ``kinematics.sensitivity``."""
    _, J_x, J_q = _closure(x, q, tool, k)
    unit, regular = _solve(J_x, np.tile(-np.eye(6)[:, :, None], len(x)))
    status[:] = np.where(regular, SOLVED, SINGULAR)
    unit[:, :, ~regular] = np.nan
    by_limb = unit.reshape(6, 3, 2, -1).transpose(3, 1, 0, 2)
    J_p = _parameters(*_turned(x, q, tool, k)).reshape(2, 10, 3, -1).transpose(3, 2, 0, 1)
    S_p[:] = (by_limb @ J_p).transpose(0, 2, 1, 3).reshape(S_p.shape)
    S_q[:] = np.moveaxis((unit * J_q).reshape(6, 3, 2, -1).sum(axis=2), -1, 0)
    W = _spin(x.T).T.reshape(-1, 3, 3)
    S_p[:, 3:], S_q[:, 3:] = W @ S_p[:, 3:], W @ S_q[:, 3:]
