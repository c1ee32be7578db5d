"""What no pose changes: `delta`, many machines at once, Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/constants.py.jinja; sha256 of both 7f131917119bc251; SymPy 1.14.0.

p (M, 3, 22) holds a machine's parameters, one row per limb; a loop over `lane` runs over the limbs
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
        b = p[22 * lane + 0]
        a = p[22 * lane + 1]
        L = p[22 * lane + 2]
        l = p[22 * lane + 3]
        c = p[22 * lane + 4]
        phi = p[22 * lane + 5]
        theta = p[22 * lane + 6]
        ex = p[22 * lane + 7]
        ey = p[22 * lane + 8]
        ez = p[22 * lane + 9]
        dL = p[22 * lane + 10]
        alpha0 = p[22 * lane + 11]
        beta0 = p[22 * lane + 12]
        dl_mean = p[22 * lane + 13]
        dl = p[22 * lane + 14]
        dc = p[22 * lane + 15]
        alpha03 = p[22 * lane + 16]
        beta03 = p[22 * lane + 17]
        alpha2 = p[22 * lane + 18]
        beta2 = p[22 * lane + 19]
        tip_v = p[22 * lane + 20]
        tip_w = p[22 * lane + 21]
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
        s22 = cosine(phi)
        s26 = 2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 - 7.647163731819816e-13
        s28 = s2*s26 + 1.6059043836821613e-10
        s30 = s2*s28 - 2.505210838544172e-08
        s32 = s2*s30 + 2.7557319223985893e-06
        s34 = s2*s32 - 0.0001984126984126984
        s36 = s2*s34 + 0.008333333333333333
        s38 = s2*s36 - 0.16666666666666666
        s40 = s2*s38 + 1
        s41 = sine(phi)
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
        k[91 * lane + 0] = theta
        k[91 * lane + 1] = R0_11
        k[91 * lane + 2] = R0_12
        k[91 * lane + 3] = R0_21
        k[91 * lane + 4] = R0_22
        k[91 * lane + 5] = R0_31
        k[91 * lane + 6] = R0_32
        k[91 * lane + 7] = s219
        k[91 * lane + 8] = tip_v
        k[91 * lane + 9] = s223
        k[91 * lane + 10] = s228
        k[91 * lane + 11] = s233
        k[91 * lane + 12] = s235
        k[91 * lane + 13] = s238
        k[91 * lane + 14] = g_x
        k[91 * lane + 15] = g_y
        k[91 * lane + 16] = s253
        k[91 * lane + 17] = s257
        k[91 * lane + 18] = s261
        k[91 * lane + 19] = h_x
        k[91 * lane + 20] = h_y
        k[91 * lane + 21] = h_z
        k[91 * lane + 22] = s293
        k[91 * lane + 23] = s954
        k[91 * lane + 24] = s1166
        k[91 * lane + 25] = s1168
        k[91 * lane + 26] = s1170
        k[91 * lane + 27] = s1172
        k[91 * lane + 28] = ez
        k[91 * lane + 29] = s1191
        k[91 * lane + 30] = s1198
        k[91 * lane + 31] = s1203
        k[91 * lane + 32] = s516
        k[91 * lane + 33] = s547
        k[91 * lane + 34] = s552
        k[91 * lane + 35] = s578
        k[91 * lane + 36] = s610
        k[91 * lane + 37] = s615
        k[91 * lane + 38] = s617
        k[91 * lane + 39] = s619
        k[91 * lane + 40] = s621
        k[91 * lane + 41] = s624
        k[91 * lane + 42] = s606
        k[91 * lane + 43] = s628
        k[91 * lane + 44] = s634
        k[91 * lane + 45] = s637
        k[91 * lane + 46] = s643
        k[91 * lane + 47] = s668
        k[91 * lane + 48] = s700
        k[91 * lane + 49] = s706
        k[91 * lane + 50] = s731
        k[91 * lane + 51] = s764
        k[91 * lane + 52] = s770
        k[91 * lane + 53] = s772
        k[91 * lane + 54] = s774
        k[91 * lane + 55] = s776
        k[91 * lane + 56] = s779
        k[91 * lane + 57] = s760
        k[91 * lane + 58] = s783
        k[91 * lane + 59] = s788
        k[91 * lane + 60] = s791
        k[91 * lane + 61] = s796
        k[91 * lane + 62] = s802
        k[91 * lane + 63] = s804
        k[91 * lane + 64] = s806
        k[91 * lane + 65] = s808
        k[91 * lane + 66] = s810
        k[91 * lane + 67] = s843
        k[91 * lane + 68] = s868
        k[91 * lane + 69] = s870
        k[91 * lane + 70] = s872
        k[91 * lane + 71] = s874
        k[91 * lane + 72] = s905
        k[91 * lane + 73] = s929
        k[91 * lane + 74] = s932
        k[91 * lane + 75] = s934
        k[91 * lane + 76] = s936
        k[91 * lane + 77] = R0_33
        k[91 * lane + 78] = R0_23
        k[91 * lane + 79] = R0_13
        k[91 * lane + 80] = s799
        k[91 * lane + 81] = s800
        k[91 * lane + 82] = s1140
        k[91 * lane + 83] = s1141
        k[91 * lane + 84] = s1184
        k[91 * lane + 85] = s1243
        k[91 * lane + 86] = s1489
        k[91 * lane + 87] = s1458
        k[91 * lane + 88] = s1459
        k[91 * lane + 89] = s290
        k[91 * lane + 90] = s1690


@fast
def _constants(p, k):
    _fill_constants(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, 3, 91), what no pose changes, from p (777 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (3, 22):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 3, 22) was expected.")
    k = np.empty((len(p), 3, 91))
    _constants(p, k)
    return k


@straight
def _fill_nominal_constants(p, k, rows):
    for lane in range(rows):
        b = p[22 * lane + 0]
        a = p[22 * lane + 1]
        L = p[22 * lane + 2]
        l = p[22 * lane + 3]
        c = p[22 * lane + 4]
        phi = p[22 * lane + 5]
        R0_11 = cosine(phi)
        s1 = sine(phi)
        R0_12_alpha0 = sine(phi)
        R0_13 = sine(phi)
        R0_21 = sine(phi)
        R0_21_beta0 = cosine(phi)
        g_x_beta2 = 0.5*c
        g_y_alpha2 = -0.5*c
        h_x = 0.5*c*s1
        h_x_beta03 = -0.5*R0_11*c
        h_y = -0.5*R0_11*c
        h_y_beta03 = -0.5*c*s1
        h_z_alpha03 = 0.5*c
        B_x = R0_11*b
        B_y = b*s1
        s47 = R0_11*a
        s49 = a*s1
        c1_x_dc = 0.5*R0_13
        c1_y_dc = -0.5*R0_11
        s97 = -0.5*l
        k[21 * lane + 0] = R0_11
        k[21 * lane + 1] = R0_12_alpha0
        k[21 * lane + 2] = s1
        k[21 * lane + 3] = R0_21
        k[21 * lane + 4] = R0_21_beta0
        k[21 * lane + 5] = L
        k[21 * lane + 6] = B_x
        k[21 * lane + 7] = B_y
        k[21 * lane + 8] = s47
        k[21 * lane + 9] = s49
        k[21 * lane + 10] = g_y_alpha2
        k[21 * lane + 11] = g_x_beta2
        k[21 * lane + 12] = h_y
        k[21 * lane + 13] = h_x
        k[21 * lane + 14] = c1_x_dc
        k[21 * lane + 15] = c1_y_dc
        k[21 * lane + 16] = h_z_alpha03
        k[21 * lane + 17] = h_x_beta03
        k[21 * lane + 18] = h_y_beta03
        k[21 * lane + 19] = l
        k[21 * lane + 20] = s97


@fast
def _nominal_constants(p, k):
    _fill_nominal_constants(p, k, p.shape[0] * p.shape[1])


def nominal_constants(p):
    """Return k (M, 3, 21), what `nominal_sensitivity` reads that no pose changes, from p (30 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (3, 22):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 3, 22) was expected.")
    k = np.empty((len(p), 3, 21))
    _nominal_constants(p, k)
    return k
