"""Kinematics of `complete_delta`: Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/kinematics.py.jinja; sha256 of both b162fba828d40a53; SymPy 1.14.0.

Arrays are C-contiguous float64, the pose first, lengths in mm, angles in rad:

x (N, 6)  platform: px py pz cx cy cz
q (N, 3)  joints        tool (N, 3)  reference point in {O'}
p (M, 3, 25)  one row of parameters per limb: b a L l c phi bx_{i}1 by_{i}1 bz_{i}1 ax_{i}1 ay_{i}1 az_{i}1 l_{i}1 bx_{i}2 by_{i}2 bz_{i}2 ax_{i}2 ay_{i}2 az_{i}2 l_{i}2 betax betay betaz tip_v tip_w
k (M, 3, 73)  what `constants` makes of p; M is 1 (one machine) or N (parameters that change from pose to pose)

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
COMMAND_CONSTANTS = 31  # `exact_command` reads these first columns of k only


def constants(p):
    """Return k (M, 3, 73), what no pose changes, from p (468 operations).

    Plain NumPy over all rows at once: it runs once per machine, and compiling it would take longer than running it.
    """
    k = np.zeros((p.shape[0], 3, 73))
    b = p[..., 0]
    a = p[..., 1]
    L = p[..., 2]
    l = p[..., 3]
    c = p[..., 4]
    phi = p[..., 5]
    bx1 = p[..., 6]
    by1 = p[..., 7]
    bz1 = p[..., 8]
    ax1 = p[..., 9]
    ay1 = p[..., 10]
    az1 = p[..., 11]
    dl1 = p[..., 12]
    bx2 = p[..., 13]
    by2 = p[..., 14]
    bz2 = p[..., 15]
    ax2 = p[..., 16]
    ay2 = p[..., 17]
    az2 = p[..., 18]
    dl2 = p[..., 19]
    betax = p[..., 20]
    betay = p[..., 21]
    betaz = p[..., 22]
    tip_v = p[..., 23]
    tip_w = p[..., 24]
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
    F_11 = s24*s25 - s47*s48
    F_12 = s24*s48 + s25*s47
    s54 = betay*s44
    s55 = betax*betaz*s21
    F_13 = s54 + s55
    s57 = -s45 + s46
    s59 = -s1*s21
    s60 = s23 + s59 + 1
    F_21 = s25*s57 - s48*s60
    F_22 = s25*s60 + s48*s57
    s66 = -betax*s44
    s67 = betay*betaz*s21
    F_23 = s66 + s67
    s69 = -s54 + s55
    s71 = -s66 + s67
    F_31 = s25*s69 - s48*s71
    F_32 = s25*s71 + s48*s69
    F_33 = s22 + s59 + 1
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
    s147 = F_11*g1_x + s146
    s152 = b*s25
    s153 = F_21*g1_x + s152
    s155 = F_31*g1_x
    g2_x = ax2 - s133 + tip_w
    g2_y = L + ay2
    g2_z = az2 + tip_v
    h2_x = bx2 + s137 - s138
    h2_y = by2 + s140 - s141
    s185 = F_11*g2_x + s146
    s190 = F_21*g2_x + s152
    s192 = F_31*g2_x
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
    s857 = -0.5*(l * l)
    s858 = (L * L)
    s863 = s857 + 0.5*s858*((s25 * s25) + (s48 * s48))
    k[..., 0] = F_12
    k[..., 1] = F_13
    k[..., 2] = F_22
    k[..., 3] = F_23
    k[..., 4] = F_32
    k[..., 5] = F_33
    k[..., 6] = g1_y
    k[..., 7] = g1_z
    k[..., 8] = s147
    k[..., 9] = s153
    k[..., 10] = s155
    k[..., 11] = h1_x
    k[..., 12] = h1_y
    k[..., 13] = bz1
    k[..., 14] = g2_y
    k[..., 15] = g2_z
    k[..., 16] = s185
    k[..., 17] = s190
    k[..., 18] = s192
    k[..., 19] = h2_x
    k[..., 20] = h2_y
    k[..., 21] = bz2
    k[..., 22] = s222
    k[..., 23] = s671
    k[..., 24] = s839
    k[..., 25] = s841
    k[..., 26] = s843
    k[..., 27] = s845
    k[..., 28] = s863
    k[..., 29] = s858
    k[..., 30] = L
    k[..., 31] = F_31
    k[..., 32] = F_21
    k[..., 33] = F_11
    k[..., 34] = s424
    k[..., 35] = s438
    k[..., 36] = s446
    k[..., 37] = s450
    k[..., 38] = s452
    k[..., 39] = s456
    k[..., 40] = s458
    k[..., 41] = s462
    k[..., 42] = s464
    k[..., 43] = s522
    k[..., 44] = s534
    k[..., 45] = s544
    k[..., 46] = s548
    k[..., 47] = s550
    k[..., 48] = s554
    k[..., 49] = s556
    k[..., 50] = s560
    k[..., 51] = s562
    k[..., 52] = s620
    k[..., 53] = s634
    k[..., 54] = s642
    k[..., 55] = s646
    k[..., 56] = s648
    k[..., 57] = s652
    k[..., 58] = s654
    k[..., 59] = s658
    k[..., 60] = s660
    k[..., 61] = s800
    k[..., 62] = s802
    k[..., 63] = s804
    k[..., 64] = s813
    k[..., 65] = s815
    k[..., 66] = s817
    k[..., 67] = s826
    k[..., 68] = s828
    k[..., 69] = s830
    k[..., 70] = s368
    k[..., 71] = s799
    k[..., 72] = s857
    return k


@njit(cache=True, nogil=True, error_model="numpy")
def _newton(x, q, tool, k, out):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint (395 operations)."""
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
    F_12 = k[0]
    F_13 = k[1]
    F_22 = k[2]
    F_23 = k[3]
    F_32 = k[4]
    F_33 = k[5]
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
    s78 = math.cos(q)
    s80 = math.sin(q)
    R1_12 = F_12*s78 + F_13*s80
    R1_13 = -F_12*s80 + F_13*s78
    R1_22 = F_22*s78 + F_23*s80
    R1_23 = -F_22*s80 + F_23*s78
    R1_32 = F_32*s78 + F_33*s80
    R1_33 = -F_32*s80 + F_33*s78
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
    s335 = s78*(-F_12*s259 + F_13*s261 - F_22*s255 + F_23*s257 - F_32*s251 + F_33*s253)
    s338 = F_12*s261 + F_13*s259 + F_22*s257 + F_23*s255 + F_32*s253 + F_33*s251
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
    s777 = s78*(-F_12*s708 + F_13*s710 - F_22*s704 + F_23*s706 - F_32*s700 + F_33*s702)
    s780 = F_12*s710 + F_13*s708 + F_22*s706 + F_23*s704 + F_32*s702 + F_33*s700
    s784 = s272*s731 + s273*s736 + s310*(-0.5*s713 - 0.5*s724 + s747) + s715 - s719
    s785 = s272*s720 + s285*s736 + s307*(-0.5*s713 - 0.5*s740 + s747) - s717 + s730
    s786 = s273*s720 + s285*s731 + s304*(-0.5*s724 - 0.5*s740 + s747) + s728 - s735
    s793 = s777 - s780*s80
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


@njit(cache=True, nogil=True, error_model="numpy")
def _parameters(x, q, tool, k, out):
    """Per rod of one limb: derivatives of the closure by errors, by deflections (375 operations)."""
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
    F_12 = k[0]
    F_13 = k[1]
    F_22 = k[2]
    F_23 = k[3]
    F_32 = k[4]
    F_33 = k[5]
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
    F_31 = k[31]
    F_21 = k[32]
    F_11 = k[33]
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
    s78 = math.cos(q)
    s80 = math.sin(q)
    R1_12 = F_12*s78 + F_13*s80
    R1_13 = -F_12*s80 + F_13*s78
    R1_22 = F_22*s78 + F_23*s80
    R1_23 = -F_22*s80 + F_23*s78
    R1_32 = F_32*s78 + F_33*s80
    R1_33 = -F_32*s80 + F_33*s78
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
    s367 = -F_11*s229 - F_21*s227 - F_31*s225
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
    s798 = -F_11*s678 - F_21*s676 - F_31*s674
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


@njit(cache=True, nogil=True, error_model="numpy")
def _sphere(x, q, tool, k, out):
    """The simplified limb as a sphere |P|^2 / 2 - c.P + d = 0: c, d (19 operations)."""
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    q = q
    s839 = k[24]
    s841 = k[25]
    s843 = k[26]
    s845 = k[27]
    L = k[30]
    s857 = k[72]
    s78 = math.cos(q)
    s877 = -s78*s841 - s839 + tx
    s879 = -s78*s845 - s843 + ty
    s881 = L*math.sin(q) + tz
    s888 = s857 + 0.5*(s877 * s877) + 0.5*(s879 * s879) + 0.5*(s881 * s881)
    out[0] = s877
    out[1] = s879
    out[2] = s881
    out[3] = s888


@njit(cache=True, nogil=True, error_model="numpy")
def _joint(x, q, tool, k, out):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (34 operations)."""
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
    s868 = math.sqrt((s847 * s847) + s850*s858 - (s864 * s864))
    s875 = math.atan2(L*s849*s864 - s847*s868, -L*s849*s868 - s847*s864)
    out[0] = s875


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
    """Fill the closure F (N, 6) and its Jacobians J_x (N, 6, 6), J_q (N, 6), J_p (N, 6, 19).

    Rows 2 i .. 2 i + 1 belong to limb i and depend on its own joint, errors and deflections only:
    J_q and J_p hold the derivatives by those.
    """
    out, by_errors = np.zeros(16), np.zeros(38)
    for n in range(x.shape[0]):
        m = n if k.shape[0] > 1 else 0
        _closure(x[n], q[n], tool[n], k[m], out, F[n], J_x[n], J_q[n])
        for i in range(3):
            _parameters(x[n], q[n, i], tool[n], k[m, i], by_errors)
            for j in range(2):
                for c in range(19):
                    J_p[n, 2 * i + j, c] = by_errors[19 * j + c]


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
    """Fill the derivatives of the exact pose: S_p (N, 6, 57) by errors and deflections, S_q (N, 6, 3) by joints.

    ``J_x S = -J``. Columns of S_p run limb by limb. S_q is the velocity Jacobian.
    """
    F, J_q = np.empty(6), np.empty(6)
    J_x = np.empty((6, 6))
    unit = np.empty((6, 6))
    out = np.zeros(16)
    J_p = np.zeros(38)
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
                for c in range(19):
                    total = 0.0
                    for j in range(2):
                        total += unit[r, 2 * i + j] * J_p[19 * j + c]
                    S_p[n, r, 19 * i + c] = total if status[n] == SOLVED else np.nan
                total = 0.0
                for j in range(2):
                    total += unit[r, 2 * i + j] * J_q[2 * i + j]
                S_q[n, r, i] = total if status[n] == SOLVED else np.nan


def linear_constants(p):
    """Return k (M, 3, 40), what `linear` reads that no pose changes, from p (77 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    k = np.zeros((p.shape[0], 3, 40))
    b = p[..., 0]
    a = p[..., 1]
    L = p[..., 2]
    l = p[..., 3]
    c = p[..., 4]
    phi = p[..., 5]
    bx1 = p[..., 6]
    by1 = p[..., 7]
    bz1 = p[..., 8]
    ax1 = p[..., 9]
    ay1 = p[..., 10]
    az1 = p[..., 11]
    dl1 = p[..., 12]
    bx2 = p[..., 13]
    by2 = p[..., 14]
    bz2 = p[..., 15]
    ax2 = p[..., 16]
    ay2 = p[..., 17]
    az2 = p[..., 18]
    dl2 = p[..., 19]
    betax = p[..., 20]
    betay = p[..., 21]
    betaz = p[..., 22]
    tip_v = p[..., 23]
    tip_w = p[..., 24]
    F_11 = np.sin(phi)
    s1 = np.cos(phi)
    F_11_errors = betaz*s1
    F_12 = np.cos(phi)
    F_12_errors = -F_11*betaz
    F_21_errors = F_11*betaz
    F_22 = np.sin(phi)
    F_22_errors = betaz*s1
    F_31_errors = -F_11*betay - betax*s1
    F_32_errors = F_11*betax - betay*s1
    g1_x = 0.5*c
    g1_x_errors = ax1 + tip_w
    g1_z_errors = az1 + tip_v
    s37 = a*s1
    s38 = 0.5*F_11*c
    h1_x = s37 + s38
    s40 = F_11*a
    s41 = -0.5*c*s1
    h1_y = s40 + s41
    s45 = b*s1
    s46 = F_11*g1_x + s45
    s54 = F_11*g1_x_errors + F_11_errors*g1_x
    s58 = F_11*b
    s59 = -g1_x*s1 + s58
    s67 = F_21_errors*g1_x - g1_x_errors*s1
    s71 = F_31_errors*g1_x
    g2_x = -0.5*c
    g2_x_errors = ax2 + tip_w
    g2_z_errors = az2 + tip_v
    h2_x = s37 - s38
    h2_y = s40 - s41
    s93 = F_11*g2_x + s45
    s99 = F_11*g2_x_errors + F_11_errors*g2_x
    s102 = -g2_x*s1 + s58
    s108 = F_21_errors*g2_x - g2_x_errors*s1
    s110 = F_31_errors*g2_x
    s125 = s37 - s45
    s127 = -L*s1
    s129 = s40 - s58
    s131 = -F_11*L
    s143 = (L * L)
    s148 = -0.5*(l * l) + 0.5*s143*((F_11 * F_11) + (s1 * s1))
    s164 = -dl1*l
    s182 = -dl2*l
    k[..., 0] = s125
    k[..., 1] = s127
    k[..., 2] = s129
    k[..., 3] = s131
    k[..., 4] = s148
    k[..., 5] = s143
    k[..., 6] = L
    k[..., 7] = F_12
    k[..., 8] = F_12_errors
    k[..., 9] = betay
    k[..., 10] = F_22
    k[..., 11] = F_22_errors
    k[..., 12] = betax
    k[..., 13] = F_32_errors
    k[..., 14] = s46
    k[..., 15] = ay1
    k[..., 16] = g1_z_errors
    k[..., 17] = s54
    k[..., 18] = s59
    k[..., 19] = s67
    k[..., 20] = s71
    k[..., 21] = h1_x
    k[..., 22] = h1_y
    k[..., 23] = bx1
    k[..., 24] = by1
    k[..., 25] = bz1
    k[..., 26] = s93
    k[..., 27] = ay2
    k[..., 28] = g2_z_errors
    k[..., 29] = s99
    k[..., 30] = s102
    k[..., 31] = s108
    k[..., 32] = s110
    k[..., 33] = h2_x
    k[..., 34] = h2_y
    k[..., 35] = bx2
    k[..., 36] = by2
    k[..., 37] = bz2
    k[..., 38] = s164
    k[..., 39] = s182
    return k


@njit(cache=True, nogil=True, error_model="numpy")
def _nominal_joint(x, q, tool, k, i, out):
    """Joint of the nominal limb at a given position (34 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    s125 = k[i, 0]
    s127 = k[i, 1]
    s129 = k[i, 2]
    s131 = k[i, 3]
    s148 = k[i, 4]
    s143 = k[i, 5]
    L = k[i, 6]
    B1_z = pz - tz
    s126 = px + s125 - tx
    s130 = py + s129 - ty
    s133 = s126*s127 + s130*s131
    s135 = (B1_z * B1_z)
    s149 = 0.5*(s126 * s126) + 0.5*(s130 * s130) + 0.5*s135 + s148
    s153 = math.sqrt((s133 * s133) + s135*s143 - (s149 * s149))
    s160 = math.atan2(B1_z*L*s149 - s133*s153, -B1_z*L*s153 - s133*s149)
    row = 1 * i
    out[row + 0] = s160


@njit(cache=True, nogil=True, error_model="numpy")
def _linear(x, q, tool, k, i, out):
    """Per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint (124 operations); limb i of k, row i of out."""
    px = x[0]
    py = x[1]
    pz = x[2]
    tx = tool[0]
    ty = tool[1]
    tz = tool[2]
    L = k[i, 6]
    F_12 = k[i, 7]
    F_12_errors = k[i, 8]
    betay = k[i, 9]
    F_22 = k[i, 10]
    F_22_errors = k[i, 11]
    betax = k[i, 12]
    F_32_errors = k[i, 13]
    s46 = k[i, 14]
    ay1 = k[i, 15]
    g1_z_errors = k[i, 16]
    s54 = k[i, 17]
    s59 = k[i, 18]
    s67 = k[i, 19]
    s71 = k[i, 20]
    h1_x = k[i, 21]
    h1_y = k[i, 22]
    bx1 = k[i, 23]
    by1 = k[i, 24]
    bz1 = k[i, 25]
    s93 = k[i, 26]
    ay2 = k[i, 27]
    g2_z_errors = k[i, 28]
    s99 = k[i, 29]
    s102 = k[i, 30]
    s108 = k[i, 31]
    s110 = k[i, 32]
    h2_x = k[i, 33]
    h2_y = k[i, 34]
    bx2 = k[i, 35]
    by2 = k[i, 36]
    bz2 = k[i, 37]
    s164 = k[i, 38]
    s182 = k[i, 39]
    s14 = math.cos(q)
    s15 = F_12*s14
    s16 = math.sin(q)
    s17 = -F_12*s16
    R1_12_errors = F_12_errors*s14 + betay*s16
    s24 = F_22*s14
    s25 = -F_22*s16
    R1_22_errors = F_22_errors*s14 - betax*s16
    R1_32_errors = F_32_errors*s14
    s44 = L*s15
    A1_x = s44 + s46
    s48 = L*s17
    s52 = L*R1_12_errors
    A1_x_errors = ay1*s15 + g1_z_errors*s17 + s52 + s54
    s57 = L*s24
    A1_y = s57 + s59
    s61 = L*s25
    s65 = L*R1_22_errors
    A1_y_errors = ay1*s24 + g1_z_errors*s25 + s65 + s67
    s69 = L*s16
    s70 = L*s14
    s73 = L*R1_32_errors
    A1_z_errors = ay1*s16 + g1_z_errors*s14 + s71 + s73
    s76 = h1_x - tx
    s77 = h1_y - ty
    B1_x = px + s76
    B1_y = py + s77
    B1_z = pz - tz
    d1_x = -A1_x + B1_x
    d1_x_errors = -A1_x_errors + bx1
    d1_y = -A1_y + B1_y
    d1_y_errors = -A1_y_errors + by1
    d1_z = B1_z - s69
    d1_z_errors = -A1_z_errors + bz1
    A2_x = s44 + s93
    A2_x_errors = ay2*s15 + g2_z_errors*s17 + s52 + s99
    A2_y = s102 + s57
    A2_y_errors = ay2*s24 + g2_z_errors*s25 + s108 + s65
    A2_z_errors = ay2*s16 + g2_z_errors*s14 + s110 + s73
    s114 = h2_x - tx
    s115 = h2_y - ty
    B2_x = px + s114
    B2_y = py + s115
    B2_z = pz - tz
    d2_x = -A2_x + B2_x
    d2_x_errors = -A2_x_errors + bx2
    d2_y = -A2_y + B2_y
    d2_y_errors = -A2_y_errors + by2
    d2_z = B2_z - s69
    d2_z_errors = -A2_z_errors + bz2
    s165 = d1_x*d1_x_errors + d1_y*d1_y_errors + d1_z*d1_z_errors + s164
    s168 = d1_y*tz + d1_z*s77
    s171 = -d1_x*tz - d1_z*s76
    s174 = -d1_x*s77 + d1_y*s76
    s178 = -d1_x*s48 - d1_y*s61 - d1_z*s70
    s183 = d2_x*d2_x_errors + d2_y*d2_y_errors + d2_z*d2_z_errors + s182
    s186 = d2_y*tz + d2_z*s115
    s189 = -d2_x*tz - d2_z*s114
    s192 = -d2_x*s115 + d2_y*s114
    s196 = -d2_x*s48 - d2_y*s61 - d2_z*s70
    row = 16 * i
    out[row + 0] = s165
    out[row + 4] = s168
    out[row + 5] = s171
    out[row + 6] = s174
    out[row + 7] = s178
    out[row + 8] = s183
    out[row + 12] = s186
    out[row + 13] = s189
    out[row + 14] = s192
    out[row + 15] = s196


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
    is, to first order, when the errors appear. tool (3,), k (3, 40) from `linear_constants`, scratch work
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
