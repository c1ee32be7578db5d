"""What no pose changes: `linear_delta`, many machines at once, Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/constants.py.jinja; sha256 of both b6cda485c581688d; SymPy 1.14.0.

p (M, 3, 16) holds a machine's parameters, one row per limb; a loop over `lane` runs over the limbs
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
        r = p[16 * lane + 0]
        l = p[16 * lane + 1]
        phi = p[16 * lane + 2]
        home = p[16 * lane + 3]
        a = p[16 * lane + 4]
        c = p[16 * lane + 5]
        endstop = p[16 * lane + 6]
        arm = p[16 * lane + 7]
        radius = p[16 * lane + 8]
        angle = p[16 * lane + 9]
        lean_radial = p[16 * lane + 10]
        lean_tangential = p[16 * lane + 11]
        scale = p[16 * lane + 12]
        dl = p[16 * lane + 13]
        dr = p[16 * lane + 14]
        stretch = p[16 * lane + 15]
        s0 = angle + phi
        u_x = cosine(s0)
        u_y = sine(s0)
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
        h = endstop + home + math.sqrt(s55)
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
        s273 = 0.5/math.sqrt(s55)
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
        k[53 * lane + 0] = s60
        k[53 * lane + 1] = s59
        k[53 * lane + 2] = axis_x
        k[53 * lane + 3] = s65
        k[53 * lane + 4] = axis_y
        k[53 * lane + 5] = s68
        k[53 * lane + 6] = axis_z
        k[53 * lane + 7] = s106
        k[53 * lane + 8] = s109
        k[53 * lane + 9] = u_x
        k[53 * lane + 10] = u_y
        k[53 * lane + 11] = s128
        k[53 * lane + 12] = s150
        k[53 * lane + 13] = s516
        k[53 * lane + 14] = s660
        k[53 * lane + 15] = s665
        k[53 * lane + 16] = h
        k[53 * lane + 17] = s672
        k[53 * lane + 18] = s674
        k[53 * lane + 19] = s680
        k[53 * lane + 20] = s684
        k[53 * lane + 21] = s58
        k[53 * lane + 22] = s280
        k[53 * lane + 23] = s278
        k[53 * lane + 24] = s286
        k[53 * lane + 25] = s326
        k[53 * lane + 26] = s354
        k[53 * lane + 27] = s358
        k[53 * lane + 28] = s361
        k[53 * lane + 29] = s397
        k[53 * lane + 30] = s425
        k[53 * lane + 31] = s429
        k[53 * lane + 32] = s432
        k[53 * lane + 33] = s468
        k[53 * lane + 34] = s495
        k[53 * lane + 35] = s498
        k[53 * lane + 36] = s501
        k[53 * lane + 37] = s628
        k[53 * lane + 38] = s504
        k[53 * lane + 39] = s656
        k[53 * lane + 40] = s53
        k[53 * lane + 41] = s714
        k[53 * lane + 42] = s870
        k[53 * lane + 43] = s1009
        k[53 * lane + 44] = s1011
        k[53 * lane + 45] = s1049
        k[53 * lane + 46] = s1051
        k[53 * lane + 47] = s1053
        k[53 * lane + 48] = s834
        k[53 * lane + 49] = s147
        k[53 * lane + 50] = s862
        k[53 * lane + 51] = s864
        k[53 * lane + 52] = s1004


@fast
def _constants(p, k):
    _fill_constants(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, 3, 53), what no pose changes, from p (386 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (3, 16):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 3, 16) was expected.")
    k = np.empty((len(p), 3, 53))
    _constants(p, k)
    return k


@straight
def _fill_nominal_constants(p, k, rows):
    for lane in range(rows):
        r = p[16 * lane + 0]
        l = p[16 * lane + 1]
        phi = p[16 * lane + 2]
        home = p[16 * lane + 3]
        a = p[16 * lane + 4]
        c = p[16 * lane + 5]
        u_x = cosine(phi)
        s1 = sine(phi)
        u_y = sine(phi)
        u_y_angle = cosine(phi)
        s6 = (l * l) - (r * r)
        h = home + math.sqrt(s6)
        s9 = 1/math.sqrt(s6)
        h_arm = l*s9
        h_radius = -r*s9
        h_dr = -r*s9
        s14 = a + r
        s15 = s14*u_x
        C_x_angle = -s1*s14
        s19 = s14*u_y
        C_y_angle = s14*u_y_angle
        s23 = a*u_x
        s25 = a*u_y
        d_x_angle = -C_x_angle - a*s1
        d_y_angle = -C_y_angle + a*u_y_angle
        s_x_cz = -0.5*c*u_x
        s_y_cz = -0.5*c*u_y
        s_z_cx = 0.5*c*u_x
        s_z_cy = 0.5*c*u_y
        s73 = -0.5*l
        k[18 * lane + 0] = h
        k[18 * lane + 1] = u_x
        k[18 * lane + 2] = u_y
        k[18 * lane + 3] = s23
        k[18 * lane + 4] = s25
        k[18 * lane + 5] = s15
        k[18 * lane + 6] = s19
        k[18 * lane + 7] = s_z_cx
        k[18 * lane + 8] = s_z_cy
        k[18 * lane + 9] = s_x_cz
        k[18 * lane + 10] = s_y_cz
        k[18 * lane + 11] = h_arm
        k[18 * lane + 12] = l
        k[18 * lane + 13] = h_radius
        k[18 * lane + 14] = d_x_angle
        k[18 * lane + 15] = d_y_angle
        k[18 * lane + 16] = h_dr
        k[18 * lane + 17] = s73


@fast
def _nominal_constants(p, k):
    _fill_nominal_constants(p, k, p.shape[0] * p.shape[1])


def nominal_constants(p):
    """Return k (M, 3, 18), what `nominal_sensitivity` reads that no pose changes, from p (43 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (3, 16):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 3, 16) was expected.")
    k = np.empty((len(p), 3, 18))
    _nominal_constants(p, k)
    return k
