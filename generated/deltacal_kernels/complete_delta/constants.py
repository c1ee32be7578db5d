"""What no pose changes: `complete_delta`, many machines at once, Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/constants.py.jinja; sha256 of both 7c04cfeb327e6479; SymPy 1.14.0.

p (M, 3, 25) holds a machine's parameters, one row per limb; a loop over `lane` runs over the limbs
of all machines.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import arcsine, arctangent, cosine, sine, tangent
from deltacal_kernels.straight import straight

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _fill_constants(p, k, rows):
    for lane in range(rows):
        b = p[25 * lane + 0]
        a = p[25 * lane + 1]
        L = p[25 * lane + 2]
        l = p[25 * lane + 3]
        c = p[25 * lane + 4]
        phi = p[25 * lane + 5]
        bx1 = p[25 * lane + 6]
        by1 = p[25 * lane + 7]
        bz1 = p[25 * lane + 8]
        ax1 = p[25 * lane + 9]
        ay1 = p[25 * lane + 10]
        az1 = p[25 * lane + 11]
        dl1 = p[25 * lane + 12]
        bx2 = p[25 * lane + 13]
        by2 = p[25 * lane + 14]
        bz2 = p[25 * lane + 15]
        ax2 = p[25 * lane + 16]
        ay2 = p[25 * lane + 17]
        az2 = p[25 * lane + 18]
        dl2 = p[25 * lane + 19]
        betax = p[25 * lane + 20]
        betay = p[25 * lane + 21]
        betaz = p[25 * lane + 22]
        tip_v = p[25 * lane + 23]
        tip_w = p[25 * lane + 24]
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
        s25 = sine(phi)
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
        k[77 * lane + 0] = R0_12
        k[77 * lane + 1] = R0_13
        k[77 * lane + 2] = R0_22
        k[77 * lane + 3] = R0_23
        k[77 * lane + 4] = R0_32
        k[77 * lane + 5] = R0_33
        k[77 * lane + 6] = g1_y
        k[77 * lane + 7] = g1_z
        k[77 * lane + 8] = s147
        k[77 * lane + 9] = s153
        k[77 * lane + 10] = s155
        k[77 * lane + 11] = h1_x
        k[77 * lane + 12] = h1_y
        k[77 * lane + 13] = bz1
        k[77 * lane + 14] = g2_y
        k[77 * lane + 15] = g2_z
        k[77 * lane + 16] = s185
        k[77 * lane + 17] = s190
        k[77 * lane + 18] = s192
        k[77 * lane + 19] = h2_x
        k[77 * lane + 20] = h2_y
        k[77 * lane + 21] = bz2
        k[77 * lane + 22] = s222
        k[77 * lane + 23] = s671
        k[77 * lane + 24] = s839
        k[77 * lane + 25] = s841
        k[77 * lane + 26] = s843
        k[77 * lane + 27] = s845
        k[77 * lane + 28] = s863
        k[77 * lane + 29] = s858
        k[77 * lane + 30] = L
        k[77 * lane + 31] = R0_31
        k[77 * lane + 32] = R0_21
        k[77 * lane + 33] = R0_11
        k[77 * lane + 34] = s424
        k[77 * lane + 35] = s438
        k[77 * lane + 36] = s446
        k[77 * lane + 37] = s450
        k[77 * lane + 38] = s452
        k[77 * lane + 39] = s456
        k[77 * lane + 40] = s458
        k[77 * lane + 41] = s462
        k[77 * lane + 42] = s464
        k[77 * lane + 43] = s522
        k[77 * lane + 44] = s534
        k[77 * lane + 45] = s544
        k[77 * lane + 46] = s548
        k[77 * lane + 47] = s550
        k[77 * lane + 48] = s554
        k[77 * lane + 49] = s556
        k[77 * lane + 50] = s560
        k[77 * lane + 51] = s562
        k[77 * lane + 52] = s620
        k[77 * lane + 53] = s634
        k[77 * lane + 54] = s642
        k[77 * lane + 55] = s646
        k[77 * lane + 56] = s648
        k[77 * lane + 57] = s652
        k[77 * lane + 58] = s654
        k[77 * lane + 59] = s658
        k[77 * lane + 60] = s660
        k[77 * lane + 61] = s800
        k[77 * lane + 62] = s802
        k[77 * lane + 63] = s804
        k[77 * lane + 64] = s813
        k[77 * lane + 65] = s815
        k[77 * lane + 66] = s817
        k[77 * lane + 67] = s826
        k[77 * lane + 68] = s828
        k[77 * lane + 69] = s830
        k[77 * lane + 70] = s368
        k[77 * lane + 71] = s799
        k[77 * lane + 72] = s856
        k[77 * lane + 73] = s901
        k[77 * lane + 74] = s1139
        k[77 * lane + 75] = s1091
        k[77 * lane + 76] = s1097


@fast
def _constants(p, k):
    _fill_constants(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, 3, 77), what no pose changes, from p (493 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (3, 25):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 3, 25) was expected.")
    k = np.empty((len(p), 3, 77))
    _constants(p, k)
    return k


@straight
def _fill_nominal_constants(p, k, rows):
    for lane in range(rows):
        b = p[25 * lane + 0]
        a = p[25 * lane + 1]
        L = p[25 * lane + 2]
        l = p[25 * lane + 3]
        c = p[25 * lane + 4]
        phi = p[25 * lane + 5]
        R0_11 = sine(phi)
        R0_11_betaz = cosine(phi)
        R0_12 = cosine(phi)
        R0_21_betaz = sine(phi)
        R0_22 = sine(phi)
        R0_22_betaz = cosine(phi)
        R0_32_betax = sine(phi)
        g1_x = 0.5*c
        s22 = R0_11_betaz*a
        s23 = 0.5*R0_11*c
        h1_x = s22 + s23
        s25 = R0_11*a
        s26 = -0.5*R0_11_betaz*c
        h1_y = s25 + s26
        s28 = R0_11*g1_x
        s30 = R0_11_betaz*b
        s31 = s28 + s30
        s34 = R0_11_betaz*g1_x
        s38 = R0_11*b
        s39 = -s34 + s38
        s41 = R0_21_betaz*g1_x
        g2_x = -0.5*c
        h2_x = s22 - s23
        h2_y = s25 - s26
        s59 = R0_11*g2_x
        s60 = s30 + s59
        s62 = R0_11_betaz*g2_x
        s64 = s38 - s62
        s66 = R0_21_betaz*g2_x
        s105 = -0.5*R0_11
        s107 = 0.5*R0_11_betaz
        s118 = -0.5*l
        k[24 * lane + 0] = R0_12
        k[24 * lane + 1] = R0_11
        k[24 * lane + 2] = R0_22
        k[24 * lane + 3] = R0_22_betaz
        k[24 * lane + 4] = R0_32_betax
        k[24 * lane + 5] = R0_11_betaz
        k[24 * lane + 6] = L
        k[24 * lane + 7] = s31
        k[24 * lane + 8] = s34
        k[24 * lane + 9] = s39
        k[24 * lane + 10] = s41
        k[24 * lane + 11] = s28
        k[24 * lane + 12] = h1_x
        k[24 * lane + 13] = h1_y
        k[24 * lane + 14] = s60
        k[24 * lane + 15] = s62
        k[24 * lane + 16] = s64
        k[24 * lane + 17] = s66
        k[24 * lane + 18] = s59
        k[24 * lane + 19] = h2_x
        k[24 * lane + 20] = h2_y
        k[24 * lane + 21] = s105
        k[24 * lane + 22] = s107
        k[24 * lane + 23] = s118


@fast
def _nominal_constants(p, k):
    _fill_nominal_constants(p, k, p.shape[0] * p.shape[1])


def nominal_constants(p):
    """Return k (M, 3, 24), what `nominal_sensitivity` reads that no pose changes, from p (38 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (3, 25):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 3, 25) was expected.")
    k = np.empty((len(p), 3, 24))
    _nominal_constants(p, k)
    return k
