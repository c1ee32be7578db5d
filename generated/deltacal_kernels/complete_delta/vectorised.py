"""Kinematics of `complete_delta` in plain NumPy: Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/vectorised.py.jinja; sha256 of both 84d51c5807c3fd38; SymPy 1.14.0.

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
    """Return k (M, 3, 77), what no pose changes, from p (493 operations).

    All rows at once.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((77, p.shape[1], 3))
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
    s7 = 1.5619206968586225e-16*s0 + 1.5619206968586225e-16*s1 + 1.5619206968586225e-16*s2 - 4.779477332387385e-14
    s9 = s3*s7 + 1.1470745597729725e-11
    s11 = s3*s9 - 2.08767569878681e-09
    s13 = s11*s3 + 2.755731922398589e-07
    s15 = s13*s3 - 2.48015873015873e-05
    s17 = s15*s3 + 0.001388888888888889
    s19 = s17*s3 - 0.041666666666666664
    s21 = s19*s3 + 0.5
    s22 = -s0*s21
    s23 = -s2*s21
    s24 = s22 + s23 + 1
    s25 = np.sin(phi)
    s30 = 2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 + 2.8114572543455206e-15*s2 - 7.647163731819816e-13
    s32 = s3*s30 + 1.6059043836821613e-10
    s34 = s3*s32 - 2.505210838544172e-08
    s36 = s3*s34 + 2.7557319223985893e-06
    s38 = s3*s36 - 0.0001984126984126984
    s40 = s3*s38 + 0.008333333333333333
    s42 = s3*s40 - 0.16666666666666666
    s44 = s3*s42 + 1
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
    s220 = dl1 + l
    s222 = -0.5*(s220 * s220)
    s355 = 2*betay
    s356 = 2*betax
    s357 = 2*betaz
    s358 = betaz*s21
    s359 = betax*s21
    s360 = betax*betaz
    s361 = betay*s21
    s362 = betay*betaz
    s363 = betax*betay
    s368 = -s220
    s383 = s3*(s3*(s3*(2.8114572543455206e-15*s3*s356 + s30*s356) + s32*s356) + s34*s356)
    s390 = s3*(s3*(s3*(s356*s36 + s383) + s356*s38) + s356*s40) + s356*s42
    s391 = betay*s390
    s403 = s13*s356
    s404 = s3*(s11*s356 + s3*(s3*(1.5619206968586225e-16*s3*s356 + s356*s7) + s356*s9)) + s403
    s413 = s19*s356 + s3*(s17*s356 + s3*(s15*s356 + s3*s404))
    s415 = s358 + s360*s413
    s416 = -s391 + s415
    s419 = -betax*s390 - s44
    s420 = s362*s413
    s421 = -s419 + s420
    s423 = s25*s416 - s421*s48
    s424 = g1_x*s423
    s426 = -betaz*s390
    s428 = s361 + s363*s413
    s429 = -s426 + s428
    s431 = -s2*s413
    s434 = -s1*s413 - s21*s356
    s435 = s431 + s434
    s437 = s25*s429 - s435*s48
    s438 = g1_x*s437
    s440 = -s0*s413
    s441 = s431 + s440
    s443 = s426 + s428
    s445 = s25*s441 - s443*s48
    s446 = g1_x*s445
    s450 = s25*s421 + s416*s48
    s452 = s434 + s440
    s456 = s25*s435 + s429*s48
    s458 = s419 + s420
    s462 = s25*s443 + s441*s48
    s464 = s391 + s415
    s481 = s3*(s3*(s3*(2.8114572543455206e-15*s3*s355 + s30*s355) + s32*s355) + s34*s355)
    s488 = s3*(s3*(s3*(s355*s36 + s481) + s355*s38) + s355*s40) + s355*s42
    s490 = betay*s488 + s44
    s502 = s13*s355
    s503 = s3*(s11*s355 + s3*(s3*(1.5619206968586225e-16*s3*s355 + s355*s7) + s355*s9)) + s502
    s512 = s19*s355 + s3*(s17*s355 + s3*(s15*s355 + s3*s503))
    s513 = s360*s512
    s514 = -s490 + s513
    s516 = -betax*s488
    s518 = s358 + s362*s512
    s519 = -s516 + s518
    s521 = s25*s514 - s48*s519
    s522 = g1_x*s521
    s524 = -betaz*s488
    s526 = s359 + s363*s512
    s527 = -s524 + s526
    s529 = -s2*s512
    s530 = -s1*s512
    s531 = s529 + s530
    s533 = s25*s527 - s48*s531
    s534 = g1_x*s533
    s538 = -s0*s512 - s21*s355
    s539 = s529 + s538
    s541 = s524 + s526
    s543 = s25*s539 - s48*s541
    s544 = g1_x*s543
    s548 = s25*s519 + s48*s514
    s550 = s530 + s538
    s554 = s25*s531 + s48*s527
    s556 = s516 + s518
    s560 = s25*s541 + s48*s539
    s562 = s490 + s513
    s579 = s3*(s3*(s3*(2.8114572543455206e-15*s3*s357 + s30*s357) + s32*s357) + s34*s357)
    s586 = s3*(s3*(s3*(s357*s36 + s579) + s357*s38) + s357*s40) + s357*s42
    s587 = betay*s586
    s599 = s13*s357
    s600 = s3*(s11*s357 + s3*(s3*(1.5619206968586225e-16*s3*s357 + s357*s7) + s357*s9)) + s599
    s609 = s19*s357 + s3*(s17*s357 + s3*(s15*s357 + s3*s600))
    s611 = s359 + s360*s609
    s612 = -s587 + s611
    s614 = -betax*s586
    s616 = s361 + s362*s609
    s617 = -s614 + s616
    s619 = s25*s612 - s48*s617
    s620 = g1_x*s619
    s623 = -betaz*s586 - s44
    s624 = s363*s609
    s625 = -s623 + s624
    s629 = -s2*s609 - s21*s357
    s630 = -s1*s609
    s631 = s629 + s630
    s633 = s25*s625 - s48*s631
    s634 = g1_x*s633
    s636 = -s0*s609
    s637 = s629 + s636
    s639 = s623 + s624
    s641 = s25*s637 - s48*s639
    s642 = g1_x*s641
    s646 = s25*s617 + s48*s612
    s648 = s630 + s636
    s652 = s25*s631 + s48*s625
    s654 = s614 + s616
    s658 = s25*s639 + s48*s637
    s660 = s587 + s611
    s669 = dl2 + l
    s671 = -0.5*(s669 * s669)
    s799 = -s669
    s800 = g2_x*s423
    s802 = g2_x*s437
    s804 = g2_x*s445
    s813 = g2_x*s521
    s815 = g2_x*s533
    s817 = g2_x*s543
    s826 = g2_x*s619
    s828 = g2_x*s633
    s830 = g2_x*s641
    s839 = s137 - s146
    s841 = -L*s48
    s843 = s140 - s152
    s845 = -L*s25
    s856 = (l * l)
    s857 = -0.5*s856
    s858 = (L * L)
    s863 = s857 + 0.5*s858*((s25 * s25) + (s48 * s48))
    s890 = -0.25*(dl1 * dl1)
    s892 = -0.25*(dl2 * dl2)
    s899 = -0.5*dl1*l
    s900 = -0.5*dl2*l
    s901 = s857 + s890 + s892 + s899 + s900
    s1083 = -0.5*l
    s1091 = -0.5*dl1 + s1083
    s1097 = -0.5*dl2 + s1083
    s1139 = s890 - s892 + s899 - s900
    k[0] = R0_12
    k[1] = R0_13
    k[2] = R0_22
    k[3] = R0_23
    k[4] = R0_32
    k[5] = R0_33
    k[6] = g1_y
    k[7] = g1_z
    k[8] = s147
    k[9] = s153
    k[10] = s155
    k[11] = h1_x
    k[12] = h1_y
    k[13] = bz1
    k[14] = g2_y
    k[15] = g2_z
    k[16] = s185
    k[17] = s190
    k[18] = s192
    k[19] = h2_x
    k[20] = h2_y
    k[21] = bz2
    k[22] = s222
    k[23] = s671
    k[24] = s839
    k[25] = s841
    k[26] = s843
    k[27] = s845
    k[28] = s863
    k[29] = s858
    k[30] = L
    k[31] = R0_31
    k[32] = R0_21
    k[33] = R0_11
    k[34] = s424
    k[35] = s438
    k[36] = s446
    k[37] = s450
    k[38] = s452
    k[39] = s456
    k[40] = s458
    k[41] = s462
    k[42] = s464
    k[43] = s522
    k[44] = s534
    k[45] = s544
    k[46] = s548
    k[47] = s550
    k[48] = s554
    k[49] = s556
    k[50] = s560
    k[51] = s562
    k[52] = s620
    k[53] = s634
    k[54] = s642
    k[55] = s646
    k[56] = s648
    k[57] = s652
    k[58] = s654
    k[59] = s658
    k[60] = s660
    k[61] = s800
    k[62] = s802
    k[63] = s804
    k[64] = s813
    k[65] = s815
    k[66] = s817
    k[67] = s826
    k[68] = s828
    k[69] = s830
    k[70] = s368
    k[71] = s799
    k[72] = s856
    k[73] = s901
    k[74] = s1139
    k[75] = s1091
    k[76] = s1097
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
    R0_12 = k[0]
    R0_13 = k[1]
    R0_22 = k[2]
    R0_23 = k[3]
    R0_32 = k[4]
    R0_33 = k[5]
    g1_y = k[6]
    g1_z = k[7]
    s147 = k[8]
    s153 = k[9]
    s155 = k[10]
    h1_x = k[11]
    h1_y = k[12]
    bz1 = k[13]
    g2_y = k[14]
    g2_z = k[15]
    s185 = k[16]
    s190 = k[17]
    s192 = k[18]
    h2_x = k[19]
    h2_y = k[20]
    bz2 = k[21]
    s222 = k[22]
    s671 = k[23]
    s78 = np.cos(q)
    s80 = np.sin(q)
    R1_12 = R0_12*s78 + R0_13*s80
    R1_13 = -R0_12*s80 + R0_13*s78
    R1_22 = R0_22*s78 + R0_23*s80
    R1_23 = -R0_22*s80 + R0_23*s78
    R1_32 = R0_32*s78 + R0_33*s80
    R1_33 = -R0_32*s80 + R0_33*s78
    s98 = (cx * cx)
    s100 = (cy * cy)
    s102 = (cz * cz)
    s104 = 0.25*s100 + 0.25*s102 + 0.25*s98 + 1
    s105 = (1.0 / s104)
    s106 = -0.5*s100
    s107 = -0.5*s102
    s108 = s106 + s107
    R_11 = s105*s108 + 1
    s111 = 0.5*cx*cy
    s112 = -cz + s111
    R_12 = s105*s112
    s114 = 0.5*cx*cz
    s115 = cy + s114
    R_13 = s105*s115
    s117 = cz + s111
    R_21 = s105*s117
    s119 = -0.5*s98
    s120 = s107 + s119
    R_22 = s105*s120 + 1
    s123 = 0.5*cy*cz
    s124 = -cx + s123
    R_23 = s105*s124
    s126 = -cy + s114
    R_31 = s105*s126
    s128 = cx + s123
    R_32 = s105*s128
    s130 = s106 + s119
    R_33 = s105*s130 + 1
    A1_x = R1_12*g1_y + R1_13*g1_z + s147
    A1_y = R1_22*g1_y + R1_23*g1_z + s153
    A1_z = R1_32*g1_y + R1_33*g1_z + s155
    s159 = h1_x - tx
    s161 = h1_y - ty
    s163 = bz1 - tz
    B1_x = R_11*s159 + R_12*s161 + R_13*s163 + px
    B1_y = R_21*s159 + R_22*s161 + R_23*s163 + py
    B1_z = R_31*s159 + R_32*s161 + R_33*s163 + pz
    d1_x = -A1_x + B1_x
    d1_y = -A1_y + B1_y
    d1_z = -A1_z + B1_z
    A2_x = R1_12*g2_y + R1_13*g2_z + s185
    A2_y = R1_22*g2_y + R1_23*g2_z + s190
    A2_z = R1_32*g2_y + R1_33*g2_z + s192
    s196 = h2_x - tx
    s198 = h2_y - ty
    s200 = bz2 - tz
    B2_x = R_11*s196 + R_12*s198 + R_13*s200 + px
    B2_y = R_21*s196 + R_22*s198 + R_23*s200 + py
    B2_z = R_31*s196 + R_32*s198 + R_33*s200 + pz
    d2_x = -A2_x + B2_x
    d2_y = -A2_y + B2_y
    d2_z = -A2_z + B2_z
    s223 = 0.5*(d1_x * d1_x) + 0.5*(d1_y * d1_y) + 0.5*(d1_z * d1_z) + s222
    s224 = 2*d1_z
    s225 = 0.5*s224
    s226 = 2*d1_y
    s227 = 0.5*s226
    s228 = 2*d1_x
    s229 = 0.5*s228
    s230 = s163*s225
    s232 = s161*s225
    s234 = s159*s225
    s236 = s163*s227
    s238 = s161*s227
    s240 = s159*s227
    s242 = s163*s229
    s245 = s161*s229
    s248 = s159*s229
    s251 = -g1_z*s225
    s253 = -g1_y*s225
    s255 = -g1_z*s227
    s257 = -g1_y*s227
    s259 = -g1_z*s229
    s261 = -g1_y*s229
    s264 = s105*s230
    s266 = s105*s232
    s268 = s105*s234
    s270 = s105*s236
    s271 = s266 + s270
    s272 = 0.5*cz
    s273 = 0.5*cy
    s276 = s120*s238
    s277 = s105*s238
    s280 = s117*s240
    s281 = s105*s240
    s282 = s115*s242
    s283 = s105*s242
    s284 = s268 + s283
    s285 = 0.5*cx
    s288 = s112*s245
    s289 = s105*s245
    s290 = s281 + s289
    s293 = s108*s248
    s294 = s105*s248
    s299 = s124*s236 + s126*s234 + s128*s232 + s130*s230 + s276 + s280 + s282 + s288 + s293
    s300 = (1.0 / (s104 * s104))
    s302 = -0.25*s299*s300
    s304 = 2*cz
    s307 = 2*cy
    s310 = 2*cx
    s335 = s78*(-R0_12*s259 + R0_13*s261 - R0_22*s255 + R0_23*s257 - R0_32*s251 + R0_33*s253)
    s338 = R0_12*s261 + R0_13*s259 + R0_22*s257 + R0_23*s255 + R0_32*s253 + R0_33*s251
    s342 = s266 - s270 + s272*s284 + s273*s290 + s310*(-0.5*s264 - 0.5*s277 + s302)
    s343 = -s268 + s271*s272 + s283 + s285*s290 + s307*(-0.5*s264 - 0.5*s294 + s302)
    s344 = s271*s273 + s281 + s284*s285 - s289 + s304*(-0.5*s277 - 0.5*s294 + s302)
    s351 = s335 - s338*s80
    s672 = 0.5*(d2_x * d2_x) + 0.5*(d2_y * d2_y) + 0.5*(d2_z * d2_z) + s671
    s673 = 2*d2_z
    s674 = 0.5*s673
    s675 = 2*d2_y
    s676 = 0.5*s675
    s677 = 2*d2_x
    s678 = 0.5*s677
    s679 = s200*s674
    s681 = s198*s674
    s683 = s196*s674
    s685 = s200*s676
    s687 = s198*s676
    s689 = s196*s676
    s691 = s200*s678
    s694 = s198*s678
    s697 = s196*s678
    s700 = -g2_z*s674
    s702 = -g2_y*s674
    s704 = -g2_z*s676
    s706 = -g2_y*s676
    s708 = -g2_z*s678
    s710 = -g2_y*s678
    s713 = s105*s679
    s715 = s105*s681
    s717 = s105*s683
    s719 = s105*s685
    s720 = s715 + s719
    s723 = s120*s687
    s724 = s105*s687
    s727 = s117*s689
    s728 = s105*s689
    s729 = s115*s691
    s730 = s105*s691
    s731 = s717 + s730
    s734 = s112*s694
    s735 = s105*s694
    s736 = s728 + s735
    s739 = s108*s697
    s740 = s105*s697
    s745 = s124*s685 + s126*s683 + s128*s681 + s130*s679 + s723 + s727 + s729 + s734 + s739
    s747 = -0.25*s300*s745
    s777 = s78*(-R0_12*s708 + R0_13*s710 - R0_22*s704 + R0_23*s706 - R0_32*s700 + R0_33*s702)
    s780 = R0_12*s710 + R0_13*s708 + R0_22*s706 + R0_23*s704 + R0_32*s702 + R0_33*s700
    s784 = s272*s731 + s273*s736 + s310*(-0.5*s713 - 0.5*s724 + s747) + s715 - s719
    s785 = s272*s720 + s285*s736 + s307*(-0.5*s713 - 0.5*s740 + s747) - s717 + s730
    s786 = s273*s720 + s285*s731 + s304*(-0.5*s724 - 0.5*s740 + s747) + s728 - s735
    s793 = s777 - s780*s80
    out = np.zeros((16, *(k.shape[1], x.shape[-1])))
    out[0] = s223
    out[1] = s229
    out[2] = s227
    out[3] = s225
    out[4] = s342
    out[5] = s343
    out[6] = s344
    out[7] = s351
    out[8] = s672
    out[9] = s678
    out[10] = s676
    out[11] = s674
    out[12] = s784
    out[13] = s785
    out[14] = s786
    out[15] = s793
    return out


def _parameters(x, q, tool, k):
    """Per rod of one limb: derivatives of the closure by errors, by deflections: (38, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    cx = x[3]
    cy = x[4]
    cz = x[5]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    R0_12 = k[0]
    R0_13 = k[1]
    R0_22 = k[2]
    R0_23 = k[3]
    R0_32 = k[4]
    R0_33 = k[5]
    g1_y = k[6]
    g1_z = k[7]
    s147 = k[8]
    s153 = k[9]
    s155 = k[10]
    h1_x = k[11]
    h1_y = k[12]
    bz1 = k[13]
    g2_y = k[14]
    g2_z = k[15]
    s185 = k[16]
    s190 = k[17]
    s192 = k[18]
    h2_x = k[19]
    h2_y = k[20]
    bz2 = k[21]
    R0_31 = k[31]
    R0_21 = k[32]
    R0_11 = k[33]
    s424 = k[34]
    s438 = k[35]
    s446 = k[36]
    s450 = k[37]
    s452 = k[38]
    s456 = k[39]
    s458 = k[40]
    s462 = k[41]
    s464 = k[42]
    s522 = k[43]
    s534 = k[44]
    s544 = k[45]
    s548 = k[46]
    s550 = k[47]
    s554 = k[48]
    s556 = k[49]
    s560 = k[50]
    s562 = k[51]
    s620 = k[52]
    s634 = k[53]
    s642 = k[54]
    s646 = k[55]
    s648 = k[56]
    s652 = k[57]
    s654 = k[58]
    s658 = k[59]
    s660 = k[60]
    s800 = k[61]
    s802 = k[62]
    s804 = k[63]
    s813 = k[64]
    s815 = k[65]
    s817 = k[66]
    s826 = k[67]
    s828 = k[68]
    s830 = k[69]
    s368 = k[70]
    s799 = k[71]
    s78 = np.cos(q)
    s80 = np.sin(q)
    R1_12 = R0_12*s78 + R0_13*s80
    R1_13 = -R0_12*s80 + R0_13*s78
    R1_22 = R0_22*s78 + R0_23*s80
    R1_23 = -R0_22*s80 + R0_23*s78
    R1_32 = R0_32*s78 + R0_33*s80
    R1_33 = -R0_32*s80 + R0_33*s78
    s98 = (cx * cx)
    s100 = (cy * cy)
    s102 = (cz * cz)
    s105 = (1.0 / (0.25*s100 + 0.25*s102 + 0.25*s98 + 1))
    s106 = -0.5*s100
    s107 = -0.5*s102
    R_11 = s105*(s106 + s107) + 1
    s111 = 0.5*cx*cy
    R_12 = s105*(-cz + s111)
    s114 = 0.5*cx*cz
    R_13 = s105*(cy + s114)
    R_21 = s105*(cz + s111)
    s119 = -0.5*s98
    R_22 = s105*(s107 + s119) + 1
    s123 = 0.5*cy*cz
    R_23 = s105*(-cx + s123)
    R_31 = s105*(-cy + s114)
    R_32 = s105*(cx + s123)
    R_33 = s105*(s106 + s119) + 1
    A1_x = R1_12*g1_y + R1_13*g1_z + s147
    A1_y = R1_22*g1_y + R1_23*g1_z + s153
    A1_z = R1_32*g1_y + R1_33*g1_z + s155
    s159 = h1_x - tx
    s161 = h1_y - ty
    s163 = bz1 - tz
    B1_x = R_11*s159 + R_12*s161 + R_13*s163 + px
    B1_y = R_21*s159 + R_22*s161 + R_23*s163 + py
    B1_z = R_31*s159 + R_32*s161 + R_33*s163 + pz
    d1_x = -A1_x + B1_x
    d1_y = -A1_y + B1_y
    d1_z = -A1_z + B1_z
    A2_x = R1_12*g2_y + R1_13*g2_z + s185
    A2_y = R1_22*g2_y + R1_23*g2_z + s190
    A2_z = R1_32*g2_y + R1_33*g2_z + s192
    s196 = h2_x - tx
    s198 = h2_y - ty
    s200 = bz2 - tz
    B2_x = R_11*s196 + R_12*s198 + R_13*s200 + px
    B2_y = R_21*s196 + R_22*s198 + R_23*s200 + py
    B2_z = R_31*s196 + R_32*s198 + R_33*s200 + pz
    d2_x = -A2_x + B2_x
    d2_y = -A2_y + B2_y
    d2_z = -A2_z + B2_z
    s224 = 2*d1_z
    s225 = 0.5*s224
    s226 = 2*d1_y
    s227 = 0.5*s226
    s228 = 2*d1_x
    s229 = 0.5*s228
    s244 = R_13*s229 + R_23*s227 + R_33*s225
    s247 = R_12*s229 + R_22*s227 + R_32*s225
    s250 = R_11*s229 + R_21*s227 + R_31*s225
    s251 = -g1_z*s225
    s253 = -g1_y*s225
    s255 = -g1_z*s227
    s257 = -g1_y*s227
    s259 = -g1_z*s229
    s261 = -g1_y*s229
    s340 = -R1_13*s229 - R1_23*s227 - R1_33*s225
    s341 = -R1_12*s229 - R1_22*s227 - R1_32*s225
    s345 = -s251*s80 + s253*s78
    s346 = s251*s78 + s253*s80
    s347 = -s255*s80 + s257*s78
    s348 = s255*s78 + s257*s80
    s349 = -s259*s80 + s261*s78
    s350 = s259*s78 + s261*s80
    s367 = -R0_11*s229 - R0_21*s227 - R0_31*s225
    s453 = s346*s452
    s457 = s347*s456
    s459 = s348*s458
    s463 = s349*s462
    s465 = s350*s464
    s466 = -s225*s424 - s227*s438 - s229*s446 + s345*s450 + s453 + s457 + s459 + s463 + s465
    s551 = s346*s550
    s555 = s347*s554
    s557 = s348*s556
    s561 = s349*s560
    s563 = s350*s562
    s564 = -s225*s522 - s227*s534 - s229*s544 + s345*s548 + s551 + s555 + s557 + s561 + s563
    s649 = s346*s648
    s653 = s347*s652
    s655 = s348*s654
    s659 = s349*s658
    s661 = s350*s660
    s662 = -s225*s620 - s227*s634 - s229*s642 + s345*s646 + s649 + s653 + s655 + s659 + s661
    s673 = 2*d2_z
    s674 = 0.5*s673
    s675 = 2*d2_y
    s676 = 0.5*s675
    s677 = 2*d2_x
    s678 = 0.5*s677
    s693 = R_13*s678 + R_23*s676 + R_33*s674
    s696 = R_12*s678 + R_22*s676 + R_32*s674
    s699 = R_11*s678 + R_21*s676 + R_31*s674
    s700 = -g2_z*s674
    s702 = -g2_y*s674
    s704 = -g2_z*s676
    s706 = -g2_y*s676
    s708 = -g2_z*s678
    s710 = -g2_y*s678
    s782 = -R1_13*s678 - R1_23*s676 - R1_33*s674
    s783 = -R1_12*s678 - R1_22*s676 - R1_32*s674
    s787 = -s700*s80 + s702*s78
    s788 = s700*s78 + s702*s80
    s789 = -s704*s80 + s706*s78
    s790 = s704*s78 + s706*s80
    s791 = -s708*s80 + s710*s78
    s792 = s708*s78 + s710*s80
    s798 = -R0_11*s678 - R0_21*s676 - R0_31*s674
    s807 = s452*s788
    s808 = s456*s789
    s809 = s458*s790
    s810 = s462*s791
    s811 = s464*s792
    s812 = s450*s787 - s674*s800 - s676*s802 - s678*s804 + s807 + s808 + s809 + s810 + s811
    s820 = s550*s788
    s821 = s554*s789
    s822 = s556*s790
    s823 = s560*s791
    s824 = s562*s792
    s825 = s548*s787 - s674*s813 - s676*s815 - s678*s817 + s820 + s821 + s822 + s823 + s824
    s833 = s648*s788
    s834 = s652*s789
    s835 = s654*s790
    s836 = s658*s791
    s837 = s660*s792
    s838 = s646*s787 - s674*s826 - s676*s828 - s678*s830 + s833 + s834 + s835 + s836 + s837
    out = np.zeros((38, *(k.shape[1], x.shape[-1])))
    out[0] = s250
    out[1] = s247
    out[2] = s244
    out[3] = s367
    out[4] = s341
    out[5] = s340
    out[6] = s368
    out[14] = s466
    out[15] = s564
    out[16] = s662
    out[17] = s340
    out[18] = s367
    out[26] = s699
    out[27] = s696
    out[28] = s693
    out[29] = s798
    out[30] = s783
    out[31] = s782
    out[32] = s799
    out[33] = s812
    out[34] = s825
    out[35] = s838
    out[36] = s782
    out[37] = s798
    return out


def _sphere(x, q, tool, k):
    """The simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d: (4, limbs, N)."""
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s839 = k[24]
    s841 = k[25]
    s843 = k[26]
    s845 = k[27]
    L = k[30]
    s856 = k[72]
    s78 = np.cos(q)
    s877 = -s78*s841 - s839 + tx
    s879 = -s78*s845 - s843 + ty
    s881 = L*np.sin(q) + tz
    s885 = -s856 + (s877 * s877) + (s879 * s879) + (s881 * s881)
    out = np.zeros((4, *(k.shape[1], x.shape[-1])))
    out[0] = s877
    out[1] = s879
    out[2] = s881
    out[3] = s885
    return out


def _joint(x, q, tool, k):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it: (1, limbs, N)."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s839 = k[24]
    s841 = k[25]
    s843 = k[26]
    s845 = k[27]
    s863 = k[28]
    s858 = k[29]
    L = k[30]
    s840 = px + s839 - tx
    s844 = py + s843 - ty
    s847 = s840*s841 + s844*s845
    s849 = pz - tz
    s850 = (s849 * s849)
    s864 = 0.5*(s840 * s840) + 0.5*(s844 * s844) + 0.5*s850 + s863
    s868 = np.sqrt((s847 * s847) + s850*s858 - (s864 * s864))
    s875 = np.arctan2(L*s849*s864 - s847*s868, -L*s849*s868 - s847*s864)
    out = np.zeros((1, *(k.shape[1], x.shape[-1])))
    out[0] = s875
    return out


def _spin(x):
    """Turn about the axes of {O} by the Cayley vector: (9, N)."""
    cx = x[3]
    cy = x[4]
    cz = x[5]
    s105 = (1.0 / (0.25*(cx * cx) + 0.25*(cy * cy) + 0.25*(cz * cz) + 1))
    s886 = -0.5*cz*s105
    s887 = 0.5*cy*s105
    s888 = -0.5*cx*s105
    out = np.zeros((9, *x.shape[1:]))
    out[0] = s105
    out[1] = s886
    out[2] = s887
    out[3] = -s886
    out[4] = s105
    out[5] = s888
    out[6] = -s887
    out[7] = -s888
    out[8] = s105
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
    J_p = _parameters(*_turned(x, q, tool, k)).reshape(2, 19, 3, -1).transpose(3, 2, 0, 1)
    S_p[:] = (by_limb @ J_p).transpose(0, 2, 1, 3).reshape(S_p.shape)
    S_q[:] = np.moveaxis((unit * J_q).reshape(6, 3, 2, -1).sum(axis=2), -1, 0)
    W = _spin(x.T).T.reshape(-1, 3, 3)
    S_p[:, 3:], S_q[:, 3:] = W @ S_p[:, 3:], W @ S_q[:, 3:]
