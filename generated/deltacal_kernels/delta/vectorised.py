"""Kinematics of `delta` in plain NumPy: Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both 91ada7d8569f8c14; SymPy 1.14.0.

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
    """Return k (M, 3, 91), what no pose changes, from p (777 operations).

    All rows at once.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((91, p.shape[1], 3))
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
    s5 = 1.5619206968586225e-16*s0 + 1.5619206968586225e-16*s1 - 4.779477332387385e-14
    s7 = s2*s5 + 1.1470745597729725e-11
    s9 = s2*s7 - 2.08767569878681e-09
    s11 = s2*s9 + 2.755731922398589e-07
    s13 = s11*s2 - 2.48015873015873e-05
    s15 = s13*s2 + 0.001388888888888889
    s17 = s15*s2 - 0.041666666666666664
    s19 = s17*s2 + 0.5
    s20 = -s0*s19
    s21 = s20 + 1
    s22 = np.cos(phi)
    s26 = 2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 - 7.647163731819816e-13
    s28 = s2*s26 + 1.6059043836821613e-10
    s30 = s2*s28 - 2.505210838544172e-08
    s32 = s2*s30 + 2.7557319223985893e-06
    s34 = s2*s32 - 0.0001984126984126984
    s36 = s2*s34 + 0.008333333333333333
    s38 = s2*s36 - 0.16666666666666666
    s40 = s2*s38 + 1
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
    s67 = 2.8114572543455206e-15*s62 + 2.8114572543455206e-15*s63 - 7.647163731819816e-13
    s69 = s64*s67 + 1.6059043836821613e-10
    s71 = s64*s69 - 2.505210838544172e-08
    s73 = s64*s71 + 2.7557319223985893e-06
    s75 = s64*s73 - 0.0001984126984126984
    s77 = s64*s75 + 0.008333333333333333
    s79 = s64*s77 - 0.16666666666666666
    s81 = s64*s79 + 1
    s82 = 0.5*c
    s84 = 0.5*dc + s82
    g_x = beta2*s81*s84
    g_y = -alpha2*s81*s84
    s89 = 1.5619206968586225e-16*s62 + 1.5619206968586225e-16*s63 - 4.779477332387385e-14
    s91 = s64*s89 + 1.1470745597729725e-11
    s93 = s64*s91 - 2.08767569878681e-09
    s95 = s64*s93 + 2.755731922398589e-07
    s97 = s64*s95 - 2.48015873015873e-05
    s99 = s64*s97 + 0.001388888888888889
    s101 = s64*s99 - 0.041666666666666664
    s103 = s101*s64 + 0.5
    s106 = -s103*s62 - s103*s63 + 1
    g_z = s106*s84
    s108 = alpha0 - alpha03
    s109 = (s108 * s108)
    s110 = beta0 - beta03
    s111 = (s110 * s110)
    s112 = s109 + s111
    s115 = 1.5619206968586225e-16*s109 + 1.5619206968586225e-16*s111 - 4.779477332387385e-14
    s117 = s112*s115 + 1.1470745597729725e-11
    s119 = s112*s117 - 2.08767569878681e-09
    s121 = s112*s119 + 2.755731922398589e-07
    s123 = s112*s121 - 2.48015873015873e-05
    s125 = s112*s123 + 0.001388888888888889
    s127 = s112*s125 - 0.041666666666666664
    s129 = s112*s127 + 0.5
    s132 = -(s108 * s108)*s129 - (s110 * s110)*s129 + 1
    s136 = 2.8114572543455206e-15*s109 + 2.8114572543455206e-15*s111 - 7.647163731819816e-13
    s138 = s112*s136 + 1.6059043836821613e-10
    s140 = s112*s138 - 2.505210838544172e-08
    s142 = s112*s140 + 2.7557319223985893e-06
    s144 = s112*s142 - 0.0001984126984126984
    s146 = s112*s144 + 0.008333333333333333
    s148 = s112*s146 - 0.16666666666666666
    s150 = s112*s148 + 1
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
    s290 = 0.5*dl
    s291 = dl_mean + l + s290
    s293 = -0.5*(s291 * s291)
    s456 = -0.5*c*s108
    s457 = 2*s108
    s458 = 2*s110
    s463 = s110*s41
    s467 = s110*s22
    s468 = 2*beta0
    s469 = 2*alpha0
    s470 = 2*alpha2
    s471 = 2*beta2
    s472 = -s81*s84
    s473 = -alpha2*s84
    s475 = beta2*s84
    s477 = -s40*s41
    s478 = -beta0*s41
    s480 = s22*s40
    s481 = beta0*s22
    s484 = alpha0*beta0
    s485 = -alpha0*s22
    s488 = alpha0*beta0*s41
    s489 = alpha0*s41
    s492 = alpha0*beta0*s22
    s507 = s112*(s112*(s112*(2.8114572543455206e-15*s112*s457 + s136*s457) + s138*s457) + s140*s457)
    s514 = s112*(s112*(s112*(s142*s457 + s507) + s144*s457) + s146*s457) + s148*s457
    s516 = -0.5*c*s150 + s456*s514
    s532 = s112*(s112*(s112*(1.5619206968586225e-16*s112*s457 + s115*s457) + s117*s457) + s119*s457)
    s539 = s112*(s112*(s112*(s121*s457 + s532) + s123*s457) + s125*s457) + s127*s457
    s543 = -2*s108*s129 - s109*s539 - s111*s539
    s547 = s82*(-s22*s543 + s463*s514)
    s552 = s82*(s41*s543 + s467*s514)
    s568 = s2*(s2*(s2*(2.8114572543455206e-15*s2*s469 + s26*s469) + s28*s469) + s30*s469)
    s575 = s2*(s2*(s2*(s32*s469 + s568) + s34*s469) + s36*s469) + s38*s469
    s577 = -alpha0*s575 - s40
    s578 = g_z*s577
    s580 = s478*s575
    s592 = s11*s469
    s593 = s2*(s2*(s2*(1.5619206968586225e-16*s2*s469 + s469*s5) + s469*s7) + s469*s9) + s592
    s602 = s17*s469 + s2*(s15*s469 + s2*(s13*s469 + s2*s593))
    s603 = -s0*s602
    s606 = -s1*s602 - s19*s469
    s607 = s603 + s606
    s609 = -s22*s607 - s580
    s610 = g_z*s609
    s613 = s481*s575
    s614 = s41*s607 + s613
    s615 = g_z*s614
    s617 = s577*tip_w
    s619 = s609*tip_w
    s621 = s614*tip_w
    s624 = beta0*s19 + s484*s602
    s628 = s41*s603 + s613
    s634 = beta0*s19*s41 - s480 + s485*s575 + s488*s602
    s637 = s22*s603 + s580
    s643 = beta0*s19*s22 - s477 + s489*s575 + s492*s602
    s660 = s112*(s112*(s112*(2.8114572543455206e-15*s112*s458 + s136*s458) + s138*s458) + s140*s458)
    s667 = s112*(s112*(s112*(s142*s458 + s660) + s144*s458) + s146*s458) + s148*s458
    s668 = s456*s667
    s684 = s112*(s112*(s112*(1.5619206968586225e-16*s112*s458 + s115*s458) + s117*s458) + s119*s458)
    s691 = s112*(s112*(s112*(s121*s458 + s684) + s123*s458) + s125*s458) + s127*s458
    s695 = -s109*s691 - 2*s110*s129 - s111*s691
    s700 = s82*(s150*s41 - s22*s695 + s463*s667)
    s706 = s82*(s150*s22 + s41*s695 + s467*s667)
    s722 = s2*(s2*(s2*(2.8114572543455206e-15*s2*s468 + s26*s468) + s28*s468) + s30*s468)
    s729 = s2*(s2*(s2*(s32*s468 + s722) + s34*s468) + s36*s468) + s38*s468
    s730 = -alpha0*s729
    s731 = g_z*s730
    s734 = s477 + s478*s729
    s747 = s11*s468
    s748 = s2*(s2*(s2*(1.5619206968586225e-16*s2*s468 + s468*s5) + s468*s7) + s468*s9) + s747
    s757 = s17*s468 + s2*(s15*s468 + s2*(s13*s468 + s2*s748))
    s759 = -s0*s757 - s19*s468
    s760 = -s1*s757
    s761 = s759 + s760
    s763 = -s22*s761 - s734
    s764 = g_z*s763
    s768 = s480 + s481*s729
    s769 = s41*s761 + s768
    s770 = g_z*s769
    s772 = s730*tip_w
    s774 = s763*tip_w
    s776 = s769*tip_w
    s779 = alpha0*s19 + s484*s757
    s783 = s41*s759 + s768
    s788 = alpha0*s19*s41 + s485*s729 + s488*s757
    s791 = s22*s759 + s734
    s796 = alpha0*s19*s22 + s489*s729 + s492*s757
    s799 = -s291
    s800 = 0.5*s799
    s801 = 0.5*s106
    s802 = R0_33*s801
    s804 = -0.5*alpha2*s81
    s806 = 0.5*beta2*s81
    s808 = R0_23*s801
    s810 = R0_13*s801
    s828 = s64*(s470*s93 + s64*(s470*s91 + s64*(1.5619206968586225e-16*s470*s64 + s470*s89)))
    s836 = s101*s470 + s64*(s470*s99 + s64*(s470*s97 + s64*(s470*s95 + s828)))
    s842 = s84*(-s103*s470 - s62*s836 - s63*s836)
    s843 = R0_33*s842
    s859 = s64*(s470*s71 + s64*(s470*s69 + s64*(2.8114572543455206e-15*s470*s64 + s470*s67)))
    s866 = s470*s79 + s64*(s470*s77 + s64*(s470*s75 + s64*(s470*s73 + s859)))
    s868 = s472 + s473*s866
    s870 = s475*s866
    s872 = R0_23*s842
    s874 = R0_13*s842
    s890 = s64*(s471*s93 + s64*(s471*s91 + s64*(1.5619206968586225e-16*s471*s64 + s471*s89)))
    s898 = s101*s471 + s64*(s471*s99 + s64*(s471*s97 + s64*(s471*s95 + s890)))
    s904 = s84*(-s103*s471 - s62*s898 - s63*s898)
    s905 = R0_33*s904
    s921 = s64*(s471*s71 + s64*(s471*s69 + s64*(2.8114572543455206e-15*s471*s64 + s471*s67)))
    s928 = s471*s79 + s64*(s471*s77 + s64*(s471*s75 + s64*(s471*s73 + s921)))
    s929 = s473*s928
    s932 = -s472 + s475*s928
    s934 = R0_23*s904
    s936 = R0_13*s904
    s952 = dl_mean + l - s290
    s954 = -0.5*(s952 * s952)
    s1140 = -s952
    s1141 = -0.5*s1140
    s1166 = -ex - s159 + s235
    s1168 = -s219*s22
    s1170 = -ey - s161 + s238
    s1172 = -s219*s41
    s1184 = ((dl_mean + l) * (dl_mean + l))
    s1191 = -0.5*s1184 + 0.5*(s219 * s219)*((s22 * s22) + (s41 * s41))
    s1196 = -2*L - 2*dL
    s1198 = 0.25*(s1196 * s1196)
    s1203 = -0.5*s1196
    s1243 = -0.125*(dl * dl) - 0.5*(dl_mean * dl_mean) - dl_mean*l - 0.5*(l * l)
    s1458 = -dl_mean - l
    s1459 = -0.25*dl
    s1489 = -0.5*dl*dl_mean - 0.5*dl*l
    s1690 = -0.5*dl_mean - 0.5*l
    k[0] = theta
    k[1] = R0_11
    k[2] = R0_12
    k[3] = R0_21
    k[4] = R0_22
    k[5] = R0_31
    k[6] = R0_32
    k[7] = s219
    k[8] = tip_v
    k[9] = s223
    k[10] = s228
    k[11] = s233
    k[12] = s235
    k[13] = s238
    k[14] = g_x
    k[15] = g_y
    k[16] = s253
    k[17] = s257
    k[18] = s261
    k[19] = h_x
    k[20] = h_y
    k[21] = h_z
    k[22] = s293
    k[23] = s954
    k[24] = s1166
    k[25] = s1168
    k[26] = s1170
    k[27] = s1172
    k[28] = ez
    k[29] = s1191
    k[30] = s1198
    k[31] = s1203
    k[32] = s516
    k[33] = s547
    k[34] = s552
    k[35] = s578
    k[36] = s610
    k[37] = s615
    k[38] = s617
    k[39] = s619
    k[40] = s621
    k[41] = s624
    k[42] = s606
    k[43] = s628
    k[44] = s634
    k[45] = s637
    k[46] = s643
    k[47] = s668
    k[48] = s700
    k[49] = s706
    k[50] = s731
    k[51] = s764
    k[52] = s770
    k[53] = s772
    k[54] = s774
    k[55] = s776
    k[56] = s779
    k[57] = s760
    k[58] = s783
    k[59] = s788
    k[60] = s791
    k[61] = s796
    k[62] = s802
    k[63] = s804
    k[64] = s806
    k[65] = s808
    k[66] = s810
    k[67] = s843
    k[68] = s868
    k[69] = s870
    k[70] = s872
    k[71] = s874
    k[72] = s905
    k[73] = s929
    k[74] = s932
    k[75] = s934
    k[76] = s936
    k[77] = R0_33
    k[78] = R0_23
    k[79] = R0_13
    k[80] = s799
    k[81] = s800
    k[82] = s1140
    k[83] = s1141
    k[84] = s1184
    k[85] = s1243
    k[86] = s1489
    k[87] = s1458
    k[88] = s1459
    k[89] = s290
    k[90] = s1690
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
    theta = k[0]
    R0_11 = k[1]
    R0_12 = k[2]
    R0_21 = k[3]
    R0_22 = k[4]
    R0_31 = k[5]
    R0_32 = k[6]
    s219 = k[7]
    tip_v = k[8]
    s223 = k[9]
    s228 = k[10]
    s233 = k[11]
    s235 = k[12]
    s238 = k[13]
    g_x = k[14]
    g_y = k[15]
    s253 = k[16]
    s257 = k[17]
    s261 = k[18]
    h_x = k[19]
    h_y = k[20]
    h_z = k[21]
    s293 = k[22]
    s954 = k[23]
    s163 = q + theta
    s164 = np.cos(s163)
    s166 = np.sin(s163)
    R1_11 = R0_11*s164 + R0_12*s166
    R1_12 = -R0_11*s166 + R0_12*s164
    R1_21 = R0_21*s164 + R0_22*s166
    R1_22 = -R0_21*s166 + R0_22*s164
    R1_31 = R0_31*s164 + R0_32*s166
    R1_32 = -R0_31*s166 + R0_32*s164
    s184 = (cx * cx)
    s186 = (cy * cy)
    s188 = (cz * cz)
    s190 = 0.25*s184 + 0.25*s186 + 0.25*s188 + 1
    s191 = (1.0 / s190)
    s192 = -0.5*s186
    s193 = -0.5*s188
    s194 = s192 + s193
    R_11 = s191*s194 + 1
    s197 = 0.5*cx*cy
    s198 = -cz + s197
    R_12 = s191*s198
    s200 = 0.5*cx*cz
    s201 = cy + s200
    R_13 = s191*s201
    s203 = cz + s197
    R_21 = s191*s203
    s205 = -0.5*s184
    s206 = s193 + s205
    R_22 = s191*s206 + 1
    s209 = 0.5*cy*cz
    s210 = -cx + s209
    R_23 = s191*s210
    s212 = -cy + s200
    R_31 = s191*s212
    s214 = cx + s209
    R_32 = s191*s214
    s216 = s192 + s205
    R_33 = s191*s216 + 1
    C_x = R1_11*s219 + R1_12*tip_v + s223
    C_y = R1_21*s219 + R1_22*tip_v + s228
    C_z = R1_31*s219 + R1_32*tip_v + s233
    s236 = s235 - tx
    s239 = s238 - ty
    A_x = R_11*s236 + R_12*s239 - R_13*tz + px
    A_y = R_21*s236 + R_22*s239 - R_23*tz + py
    A_z = R_31*s236 + R_32*s239 - R_33*tz + pz
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
    s281 = d_x + s_x
    s284 = d_y + s_y
    s287 = d_z + s_z
    s294 = 0.5*(s281 * s281) + 0.5*(s284 * s284) + 0.5*(s287 * s287) + s293
    s295 = 2*s287
    s296 = 0.5*s295
    s297 = 2*s284
    s298 = 0.5*s297
    s299 = 2*s281
    s300 = 0.5*s299
    s348 = h_z*s296 - s296*tz
    s350 = s191*s348
    s351 = h_y*s296 + s239*s296
    s353 = s191*s351
    s354 = h_x*s296 + s236*s296
    s356 = s191*s354
    s357 = h_z*s298 - s298*tz
    s359 = s191*s357
    s360 = s353 + s359
    s361 = 0.5*cz
    s362 = 0.5*cy
    s365 = h_y*s298 + s239*s298
    s366 = s206*s365
    s367 = s191*s365
    s370 = h_x*s298 + s236*s298
    s371 = s203*s370
    s372 = s191*s370
    s373 = h_z*s300 - s300*tz
    s374 = s201*s373
    s375 = s191*s373
    s376 = s356 + s375
    s377 = 0.5*cx
    s380 = h_y*s300 + s239*s300
    s381 = s198*s380
    s382 = s191*s380
    s383 = s372 + s382
    s386 = h_x*s300 + s236*s300
    s387 = s194*s386
    s388 = s191*s386
    s393 = s210*s357 + s212*s354 + s214*s351 + s216*s348 + s366 + s371 + s374 + s381 + s387
    s394 = (1.0 / (s190 * s190))
    s396 = -0.25*s393*s394
    s398 = 2*cz
    s401 = 2*cy
    s404 = 2*cx
    s406 = -g_y*s296 - s296*tip_v
    s411 = -g_x*s296 - s219*s296
    s416 = -g_y*s298 - s298*tip_v
    s421 = -g_x*s298 - s219*s298
    s426 = -g_y*s300 - s300*tip_v
    s431 = -g_x*s300 - s219*s300
    s435 = s164*(-R0_11*s426 + R0_12*s431 - R0_21*s416 + R0_22*s421 - R0_31*s406 + R0_32*s411)
    s438 = R0_11*s431 + R0_12*s426 + R0_21*s421 + R0_22*s416 + R0_31*s411 + R0_32*s406
    s440 = -s166*s438 + s435
    s444 = s353 - s359 + s361*s376 + s362*s383 + s404*(-0.5*s350 - 0.5*s367 + s396)
    s445 = -s356 + s360*s361 + s375 + s377*s383 + s401*(-0.5*s350 - 0.5*s388 + s396)
    s446 = s360*s362 + s372 + s376*s377 - s382 + s398*(-0.5*s367 - 0.5*s388 + s396)
    s943 = d_x - s_x
    s946 = d_y - s_y
    s949 = d_z - s_z
    s955 = 0.5*(s943 * s943) + 0.5*(s946 * s946) + 0.5*(s949 * s949) + s954
    s956 = 2*s949
    s957 = 0.5*s956
    s958 = 2*s946
    s959 = 0.5*s958
    s960 = 2*s943
    s961 = 0.5*s960
    s1009 = -h_z*s957 - s957*tz
    s1011 = s1009*s191
    s1012 = -h_y*s957 + s239*s957
    s1014 = s1012*s191
    s1015 = -h_x*s957 + s236*s957
    s1017 = s1015*s191
    s1018 = -h_z*s959 - s959*tz
    s1020 = s1018*s191
    s1021 = s1014 + s1020
    s1024 = -h_y*s959 + s239*s959
    s1025 = s1024*s206
    s1026 = s1024*s191
    s1029 = -h_x*s959 + s236*s959
    s1030 = s1029*s203
    s1031 = s1029*s191
    s1032 = -h_z*s961 - s961*tz
    s1033 = s1032*s201
    s1034 = s1032*s191
    s1035 = s1017 + s1034
    s1038 = -h_y*s961 + s239*s961
    s1039 = s1038*s198
    s1040 = s1038*s191
    s1041 = s1031 + s1040
    s1044 = -h_x*s961 + s236*s961
    s1045 = s1044*s194
    s1046 = s1044*s191
    s1051 = s1009*s216 + s1012*s214 + s1015*s212 + s1018*s210 + s1025 + s1030 + s1033 + s1039 + s1045
    s1053 = -0.25*s1051*s394
    s1060 = g_y*s957 - s957*tip_v
    s1065 = g_x*s957 - s219*s957
    s1070 = g_y*s959 - s959*tip_v
    s1075 = g_x*s959 - s219*s959
    s1080 = g_y*s961 - s961*tip_v
    s1085 = g_x*s961 - s219*s961
    s1089 = s164*(-R0_11*s1080 + R0_12*s1085 - R0_21*s1070 + R0_22*s1075 - R0_31*s1060 + R0_32*s1065)
    s1092 = R0_11*s1085 + R0_12*s1080 + R0_21*s1075 + R0_22*s1070 + R0_31*s1065 + R0_32*s1060
    s1094 = s1089 - s1092*s166
    s1098 = s1014 - s1020 + s1035*s361 + s1041*s362 + s404*(-0.5*s1011 - 0.5*s1026 + s1053)
    s1099 = -s1017 + s1021*s361 + s1034 + s1041*s377 + s401*(-0.5*s1011 - 0.5*s1046 + s1053)
    s1100 = s1021*s362 + s1031 + s1035*s377 - s1040 + s398*(-0.5*s1026 - 0.5*s1046 + s1053)
    out = np.zeros((16, *(k.shape[1], x.shape[-1])))
    out[0] = s294
    out[1] = s300
    out[2] = s298
    out[3] = s296
    out[4] = s444
    out[5] = s445
    out[6] = s446
    out[7] = s440
    out[8] = s955
    out[9] = s961
    out[10] = s959
    out[11] = s957
    out[12] = s1098
    out[13] = s1099
    out[14] = s1100
    out[15] = s1094
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (32, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    theta = k[0]
    R0_11 = k[1]
    R0_12 = k[2]
    R0_21 = k[3]
    R0_22 = k[4]
    R0_31 = k[5]
    R0_32 = k[6]
    s219 = k[7]
    tip_v = k[8]
    s223 = k[9]
    s228 = k[10]
    s233 = k[11]
    s235 = k[12]
    s238 = k[13]
    g_x = k[14]
    g_y = k[15]
    s253 = k[16]
    s257 = k[17]
    s261 = k[18]
    h_x = k[19]
    h_y = k[20]
    h_z = k[21]
    s516 = k[32]
    s547 = k[33]
    s552 = k[34]
    s578 = k[35]
    s610 = k[36]
    s615 = k[37]
    s617 = k[38]
    s619 = k[39]
    s621 = k[40]
    s624 = k[41]
    s606 = k[42]
    s628 = k[43]
    s634 = k[44]
    s637 = k[45]
    s643 = k[46]
    s668 = k[47]
    s700 = k[48]
    s706 = k[49]
    s731 = k[50]
    s764 = k[51]
    s770 = k[52]
    s772 = k[53]
    s774 = k[54]
    s776 = k[55]
    s779 = k[56]
    s760 = k[57]
    s783 = k[58]
    s788 = k[59]
    s791 = k[60]
    s796 = k[61]
    s802 = k[62]
    s804 = k[63]
    s806 = k[64]
    s808 = k[65]
    s810 = k[66]
    s843 = k[67]
    s868 = k[68]
    s870 = k[69]
    s872 = k[70]
    s874 = k[71]
    s905 = k[72]
    s929 = k[73]
    s932 = k[74]
    s934 = k[75]
    s936 = k[76]
    R0_33 = k[77]
    R0_23 = k[78]
    R0_13 = k[79]
    s799 = k[80]
    s800 = k[81]
    s1140 = k[82]
    s1141 = k[83]
    s163 = q + theta
    s164 = np.cos(s163)
    s166 = np.sin(s163)
    R1_11 = R0_11*s164 + R0_12*s166
    R1_12 = -R0_11*s166 + R0_12*s164
    R1_21 = R0_21*s164 + R0_22*s166
    R1_22 = -R0_21*s166 + R0_22*s164
    R1_31 = R0_31*s164 + R0_32*s166
    R1_32 = -R0_31*s166 + R0_32*s164
    s184 = (cx * cx)
    s186 = (cy * cy)
    s188 = (cz * cz)
    s191 = (1.0 / (0.25*s184 + 0.25*s186 + 0.25*s188 + 1))
    s192 = -0.5*s186
    s193 = -0.5*s188
    R_11 = s191*(s192 + s193) + 1
    s197 = 0.5*cx*cy
    R_12 = s191*(-cz + s197)
    s200 = 0.5*cx*cz
    R_13 = s191*(cy + s200)
    R_21 = s191*(cz + s197)
    s205 = -0.5*s184
    R_22 = s191*(s193 + s205) + 1
    s209 = 0.5*cy*cz
    R_23 = s191*(-cx + s209)
    R_31 = s191*(-cy + s200)
    R_32 = s191*(cx + s209)
    R_33 = s191*(s192 + s205) + 1
    C_x = R1_11*s219 + R1_12*tip_v + s223
    C_y = R1_21*s219 + R1_22*tip_v + s228
    C_z = R1_31*s219 + R1_32*tip_v + s233
    s236 = s235 - tx
    s239 = s238 - ty
    A_x = R_11*s236 + R_12*s239 - R_13*tz + px
    A_y = R_21*s236 + R_22*s239 - R_23*tz + py
    A_z = R_31*s236 + R_32*s239 - R_33*tz + pz
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
    s296 = d_z + s_z
    s298 = d_y + s_y
    s300 = d_x + s_x
    s339 = R_12*s300 + R_22*s298 + R_32*s296
    s341 = R_11*s300 + R_21*s298 + R_31*s296
    s406 = -g_y*s296 - s296*tip_v
    s411 = -g_x*s296 - s219*s296
    s416 = -g_y*s298 - s298*tip_v
    s421 = -g_x*s298 - s219*s298
    s426 = -g_y*s300 - s300*tip_v
    s431 = -g_x*s300 - s219*s300
    s435 = s164*(-R0_11*s426 + R0_12*s431 - R0_21*s416 + R0_22*s421 - R0_31*s406 + R0_32*s411)
    s438 = R0_11*s431 + R0_12*s426 + R0_21*s421 + R0_22*s416 + R0_31*s411 + R0_32*s406
    s440 = -s166*s438 + s435
    s441 = R_13*s300 + R_23*s298 + R_33*s296
    s442 = -R1_12*s300 - R1_22*s298 - R1_32*s296
    s443 = -R1_11*s300 - R1_21*s298 - R1_31*s296
    s447 = s164*s411 - s166*s406
    s448 = s164*s406 + s166*s411
    s449 = s164*s421 - s166*s416
    s450 = s164*s416 + s166*s421
    s451 = s164*s431 - s166*s426
    s452 = s164*s426 + s166*s431
    s517 = s441*s516
    s548 = s339*s547
    s553 = s341*s552
    s579 = -s296*s578
    s611 = -s298*s610
    s616 = -s300*s615
    s618 = -s296*s617
    s620 = -s298*s619
    s622 = -s300*s621
    s625 = s447*s624
    s626 = s448*s606
    s629 = s449*s628
    s635 = s450*s634
    s638 = s451*s637
    s644 = s452*s643
    s645 = s517 + s548 + s553 + s579 + s611 + s616 + s618 + s620 + s622 + s625 + s626 + s629 + s635 + s638 + s644
    s669 = s441*s668
    s701 = s339*s700
    s707 = s341*s706
    s732 = -s296*s731
    s765 = -s298*s764
    s771 = -s300*s770
    s773 = -s296*s772
    s775 = -s298*s774
    s777 = -s300*s776
    s780 = s447*s779
    s781 = s448*s760
    s784 = s449*s783
    s789 = s450*s788
    s792 = s451*s791
    s797 = s452*s796
    s798 = s669 + s701 + s707 + s732 + s765 + s771 + s773 + s775 + s777 + s780 + s781 + s784 + s789 + s792 + s797
    s812 = -s296*s802 - s298*s808 - s300*s810 + s442*s804 + s443*s806
    s813 = -s517 - s548 - s553
    s814 = -s669 - s701 - s707
    s876 = -s296*s843 - s298*s872 - s300*s874 + s442*s868 + s443*s870
    s938 = -s296*s905 - s298*s934 - s300*s936 + s442*s929 + s443*s932
    s942 = -R0_13*s300 - R0_23*s298 - R0_33*s296
    s957 = d_z - s_z
    s959 = d_y - s_y
    s961 = d_x - s_x
    s1000 = R_12*s961 + R_22*s959 + R_32*s957
    s1002 = R_11*s961 + R_21*s959 + R_31*s957
    s1060 = g_y*s957 - s957*tip_v
    s1065 = g_x*s957 - s219*s957
    s1070 = g_y*s959 - s959*tip_v
    s1075 = g_x*s959 - s219*s959
    s1080 = g_y*s961 - s961*tip_v
    s1085 = g_x*s961 - s219*s961
    s1089 = s164*(-R0_11*s1080 + R0_12*s1085 - R0_21*s1070 + R0_22*s1075 - R0_31*s1060 + R0_32*s1065)
    s1092 = R0_11*s1085 + R0_12*s1080 + R0_21*s1075 + R0_22*s1070 + R0_31*s1065 + R0_32*s1060
    s1094 = s1089 - s1092*s166
    s1095 = -R_13*s961 - R_23*s959 - R_33*s957
    s1096 = R1_12*s961 + R1_22*s959 + R1_32*s957
    s1097 = R1_11*s961 + R1_21*s959 + R1_31*s957
    s1101 = -s1060*s166 + s1065*s164
    s1102 = s1060*s164 + s1065*s166
    s1103 = -s1070*s166 + s1075*s164
    s1104 = s1070*s164 + s1075*s166
    s1105 = -s1080*s166 + s1085*s164
    s1106 = s1080*s164 + s1085*s166
    s1108 = s1095*s516
    s1109 = -s1000*s547
    s1110 = -s1002*s552
    s1111 = s578*s957
    s1112 = s610*s959
    s1113 = s615*s961
    s1114 = -s617*s957
    s1115 = -s619*s959
    s1116 = -s621*s961
    s1117 = s1101*s624
    s1118 = s1102*s606
    s1119 = s1103*s628
    s1120 = s1104*s634
    s1121 = s1105*s637
    s1122 = s1106*s643
    s1123 = s1108 + s1109 + s1110 + s1111 + s1112 + s1113 + s1114 + s1115 + s1116 + s1117 + s1118 + s1119 + s1120 + s1121 + s1122
    s1124 = s1095*s668
    s1125 = -s1000*s700
    s1126 = -s1002*s706
    s1127 = s731*s957
    s1128 = s764*s959
    s1129 = s770*s961
    s1130 = -s772*s957
    s1131 = -s774*s959
    s1132 = -s776*s961
    s1133 = s1101*s779
    s1134 = s1102*s760
    s1135 = s1103*s783
    s1136 = s1104*s788
    s1137 = s1105*s791
    s1138 = s1106*s796
    s1139 = s1124 + s1125 + s1126 + s1127 + s1128 + s1129 + s1130 + s1131 + s1132 + s1133 + s1134 + s1135 + s1136 + s1137 + s1138
    s1147 = s1096*s804 + s1097*s806 + s802*s957 + s808*s959 + s810*s961
    s1148 = -s1108 - s1109 - s1110
    s1149 = -s1124 - s1125 - s1126
    s1155 = s1096*s868 + s1097*s870 + s843*s957 + s872*s959 + s874*s961
    s1161 = s1096*s929 + s1097*s932 + s905*s957 + s934*s959 + s936*s961
    s1165 = -R0_13*s961 - R0_23*s959 - R0_33*s957
    out = np.zeros((32, *(k.shape[1], x.shape[-1])))
    out[0] = s440
    out[1] = -s300
    out[2] = -s298
    out[3] = -s296
    out[4] = s443
    out[5] = s645
    out[6] = s798
    out[7] = s799
    out[8] = s800
    out[9] = s812
    out[10] = s813
    out[11] = s814
    out[12] = s876
    out[13] = s938
    out[14] = s442
    out[15] = s942
    out[16] = s1094
    out[17] = -s961
    out[18] = -s959
    out[19] = -s957
    out[20] = -s1097
    out[21] = s1123
    out[22] = s1139
    out[23] = s1140
    out[24] = s1141
    out[25] = s1147
    out[26] = s1148
    out[27] = s1149
    out[28] = s1155
    out[29] = s1161
    out[30] = -s1096
    out[31] = s1165
    return out


def _sphere(x, q, tool, k):
    """The simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d: (4, limbs, N)."""
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    theta = k[0]
    s219 = k[7]
    s1166 = k[24]
    s1168 = k[25]
    s1170 = k[26]
    s1172 = k[27]
    ez = k[28]
    s1184 = k[84]
    s163 = q + theta
    s164 = np.cos(s163)
    s1212 = -s1166 - s1168*s164 + tx
    s1214 = -s1170 - s1172*s164 + ty
    s1216 = ez + s219*np.sin(s163) + tz
    s1220 = -s1184 + (s1212 * s1212) + (s1214 * s1214) + (s1216 * s1216)
    out = np.zeros((4, *(k.shape[1], x.shape[-1])))
    out[0] = s1212
    out[1] = s1214
    out[2] = s1216
    out[3] = s1220
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (1, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    theta = k[0]
    s1166 = k[24]
    s1168 = k[25]
    s1170 = k[26]
    s1172 = k[27]
    ez = k[28]
    s1191 = k[29]
    s1198 = k[30]
    s1203 = k[31]
    s1167 = px + s1166 - tx
    s1171 = py + s1170 - ty
    s1174 = s1167*s1168 + s1171*s1172
    s1176 = -ez + pz - tz
    s1177 = (s1176 * s1176)
    s1192 = 0.5*(s1167 * s1167) + 0.5*(s1171 * s1171) + 0.5*s1177 + s1191
    s1201 = np.sqrt((s1174 * s1174) + s1177*s1198 - (s1192 * s1192))
    s1210 = -theta + np.arctan2(-s1174*s1201 + s1176*s1192*s1203, -s1174*s1192 - s1176*s1201*s1203)
    out = np.zeros((1, *(k.shape[1], x.shape[-1])))
    out[0] = s1210
    return out


def _spin(x):
    """Turn about the axes of {O} by the Cayley vector: (9, N)."""
    cx = x[3]
    cy = x[4]
    cz = x[5]
    s191 = (1.0 / (0.25*(cx * cx) + 0.25*(cy * cy) + 0.25*(cz * cz) + 1))
    s1221 = -0.5*cz*s191
    s1222 = 0.5*cy*s191
    s1223 = -0.5*cx*s191
    out = np.zeros((9, *x.shape[1:]))
    out[0] = s191
    out[1] = s1221
    out[2] = s1222
    out[3] = -s1221
    out[4] = s191
    out[5] = s1223
    out[6] = -s1222
    out[7] = -s1223
    out[8] = s191
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
    J_p = _parameters(*_turned(x, q, tool, k)).reshape(2, 16, 3, -1).transpose(3, 2, 0, 1)
    S_p[:] = (by_limb @ J_p).transpose(0, 2, 1, 3).reshape(S_p.shape)
    S_q[:] = np.moveaxis((unit * J_q).reshape(6, 3, 2, -1).sum(axis=2), -1, 0)
    W = _spin(x.T).T.reshape(-1, 3, 3)
    S_p[:, 3:], S_q[:, 3:] = W @ S_p[:, 3:], W @ S_q[:, 3:]
