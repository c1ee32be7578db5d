"""Generalised loads of `complete_delta`: Delta, complete geometry of the six rods, row by row for Numba.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 64721d0d1a4378c6; SymPy 1.14.0.

Functions of the NumPy module of this name, to be called likewise but for defaults, on C-contiguous arrays. Each is a
loop over rows; an array of one row counts for all of them.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import cosine, sine
from deltacal_kernels.straight import straight

# of the arrays that each takes
DIMENSIONS = {"limb": (2, 1, 2, 2, 1, 2), "limb_points": (2, 1, 2, 2, 1), "platform": (2, 2, 1, 1, 2), "platform_points": (2, 2, 1, 2)}

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _limb(x, q, tool, p, masses, fields, x_every, q_every, tool_every, p_every, fields_every, out, many):
    """537 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        cx = x[x_every * lane + 3]
        cy = x[x_every * lane + 4]
        cz = x[x_every * lane + 5]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        q_here = q[q_every * lane]
        proximal = masses[0]
        proximal_com = masses[1]
        distal_rod = masses[2]
        b = p[p_every * lane + 0]
        a = p[p_every * lane + 1]
        L = p[p_every * lane + 2]
        c = p[p_every * lane + 4]
        phi = p[p_every * lane + 5]
        bx1 = p[p_every * lane + 6]
        by1 = p[p_every * lane + 7]
        bz1 = p[p_every * lane + 8]
        ax1 = p[p_every * lane + 9]
        ay1 = p[p_every * lane + 10]
        az1 = p[p_every * lane + 11]
        bx2 = p[p_every * lane + 13]
        by2 = p[p_every * lane + 14]
        bz2 = p[p_every * lane + 15]
        ax2 = p[p_every * lane + 16]
        ay2 = p[p_every * lane + 17]
        az2 = p[p_every * lane + 18]
        betax = p[p_every * lane + 20]
        betay = p[p_every * lane + 21]
        betaz = p[p_every * lane + 22]
        tip_v = p[p_every * lane + 23]
        tip_w = p[p_every * lane + 24]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        f2x = fields[fields_every * lane + 6]
        f2y = fields[fields_every * lane + 7]
        f2z = fields[fields_every * lane + 8]
        f3x = fields[fields_every * lane + 9]
        f3y = fields[fields_every * lane + 10]
        f3z = fields[fields_every * lane + 11]
        f4x = fields[fields_every * lane + 12]
        f4y = fields[fields_every * lane + 13]
        f4z = fields[fields_every * lane + 14]
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
        s25 = sine(phi)
        s33 = s3*(s3*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 + 2.8114572543455206e-15*s2 - 7.647163731819816e-13) + 1.6059043836821613e-10)
        s41 = s3*(s3*(s3*(s3*(s33 - 2.505210838544172e-08) + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333)
        s44 = s3*(s41 - 0.16666666666666666) + 1
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
        s78 = cosine(q_here)
        s80 = sine(q_here)
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
        A1_x = R0_11*g1_x + R1_12*g1_y + R1_13*g1_z + s146
        s151 = b*s25
        A1_y = R0_21*g1_x + R1_22*g1_y + R1_23*g1_z + s151
        A1_z = R0_31*g1_x + R1_32*g1_y + R1_33*g1_z
        s157 = h1_x - tx
        s159 = h1_y - ty
        s161 = bz1 - tz
        B1_x = R_11*s157 + R_12*s159 + R_13*s161 + px
        B1_y = R_21*s157 + R_22*s159 + R_23*s161 + py
        B1_z = R_31*s157 + R_32*s159 + R_33*s161 + pz
        g2_x = ax2 - s133 + tip_w
        g2_y = L + ay2
        g2_z = az2 + tip_v
        h2_x = bx2 + s137 - s138
        h2_y = by2 + s140 - s141
        A2_x = R0_11*g2_x + R1_12*g2_y + R1_13*g2_z + s146
        A2_y = R0_21*g2_x + R1_22*g2_y + R1_23*g2_z + s151
        A2_z = R0_31*g2_x + R1_32*g2_y + R1_33*g2_z
        s192 = h2_x - tx
        s194 = h2_y - ty
        s196 = bz2 - tz
        B2_x = R_11*s192 + R_12*s194 + R_13*s196 + px
        B2_y = R_21*s192 + R_22*s194 + R_23*s196 + py
        B2_z = R_31*s192 + R_32*s194 + R_33*s196 + pz
        s211 = L*R1_12*proximal_com + s146
        s214 = L*R1_22*proximal_com + s151
        s241 = 0.5*distal_rod
        s242 = f4z*s241
        s244 = f4y*s241
        s246 = f4x*s241
        s249 = f3z*s241
        s251 = f3y*s241
        s253 = f3x*s241
        s256 = f2z*s241
        s258 = f2y*s241
        s260 = f2x*s241
        s263 = f1z*s241
        s265 = f1y*s241
        s267 = f1x*s241
        s280 = L*proximal_com
        s398 = s161*s249 + s196*s242
        s400 = s105*s398
        s401 = s159*s249 + s194*s242
        s403 = s105*s401
        s404 = s157*s249 + s192*s242
        s406 = s105*s404
        s407 = s161*s251 + s196*s244
        s409 = s105*s407
        s410 = s403 + s409
        s411 = 0.5*cz
        s412 = 0.5*cy
        s415 = s159*s251 + s194*s244
        s416 = s120*s415
        s417 = s105*s415
        s420 = s157*s251 + s192*s244
        s421 = s117*s420
        s422 = s105*s420
        s423 = s161*s253 + s196*s246
        s424 = s115*s423
        s425 = s105*s423
        s426 = s406 + s425
        s427 = 0.5*cx
        s430 = s159*s253 + s194*s246
        s431 = s112*s430
        s432 = s105*s430
        s433 = s422 + s432
        s436 = s157*s253 + s192*s246
        s437 = s108*s436
        s438 = s105*s436
        s443 = s124*s407 + s126*s404 + s128*s401 + s130*s398 + s416 + s421 + s424 + s431 + s437
        s446 = -0.25*s443/(s104 * s104)
        s456 = g1_z*s263 + g2_z*s256
        s461 = L*f0z*proximal*proximal_com + g1_y*s263 + g2_y*s256
        s466 = g1_z*s265 + g2_z*s258
        s471 = f0y*proximal*s280 + g1_y*s265 + g2_y*s258
        s476 = g1_z*s267 + g2_z*s260
        s481 = f0x*proximal*s280 + g1_y*s267 + g2_y*s260
        s485 = s78*(-R0_12*s476 + R0_13*s481 - R0_22*s466 + R0_23*s471 - R0_32*s456 + R0_33*s461)
        s488 = R0_12*s481 + R0_13*s476 + R0_22*s471 + R0_23*s466 + R0_32*s461 + R0_33*s456
        s614 = s242 + s249
        s615 = s244 + s251
        s616 = s246 + s253
        s623 = 2*cx*(-0.5*s400 - 0.5*s417 + s446) + s403 - s409 + s411*s426 + s412*s433
        s624 = 2*cy*(-0.5*s400 - 0.5*s438 + s446) - s406 + s410*s411 + s425 + s427*s433
        s625 = 2*cz*(-0.5*s417 - 0.5*s438 + s446) + s410*s412 + s422 + s426*s427 - s432
        s626 = s485 - s488*s80
        s638 = 0.5*distal_rod*(A1_y*f1z - A1_z*f1y)
        s642 = 0.5*distal_rod*(A2_y*f2z - A2_z*f2y)
        s646 = 0.5*distal_rod*(B1_y*f3z - B1_z*f3y)
        s650 = 0.5*distal_rod*(B2_y*f4z - B2_z*f4y)
        s651 = proximal*(-L*R1_32*f0y*proximal_com + f0z*s214) + s638 + s642 + s646 + s650
        s659 = 0.5*distal_rod*(-A1_x*f1z + A1_z*f1x)
        s663 = 0.5*distal_rod*(-A2_x*f2z + A2_z*f2x)
        s667 = 0.5*distal_rod*(-B1_x*f3z + B1_z*f3x)
        s671 = 0.5*distal_rod*(-B2_x*f4z + B2_z*f4x)
        s672 = proximal*(L*R1_32*f0x*proximal_com - f0z*s211) + s659 + s663 + s667 + s671
        s680 = 0.5*distal_rod*(A1_x*f1y - A1_y*f1x)
        s684 = 0.5*distal_rod*(A2_x*f2y - A2_y*f2x)
        s688 = 0.5*distal_rod*(B1_x*f3y - B1_y*f3x)
        s692 = 0.5*distal_rod*(B2_x*f4y - B2_y*f4x)
        s693 = proximal*(-f0x*s214 + f0y*s211) + s680 + s684 + s688 + s692
        out[10 * lane + 0] = s626
        out[10 * lane + 1] = s616
        out[10 * lane + 2] = s615
        out[10 * lane + 3] = s614
        out[10 * lane + 4] = s623
        out[10 * lane + 5] = s624
        out[10 * lane + 6] = s625
        out[10 * lane + 7] = s651
        out[10 * lane + 8] = s672
        out[10 * lane + 9] = s693


@fast
def limb(x, q, tool, p, masses, fields):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    q_every = q.size // len(q) if len(q) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    p_every = p.size // len(p) if len(p) > 1 else 0
    fields_every = fields.size // len(fields) if len(fields) > 1 else 0
    out = np.zeros((many, 10))
    _limb(x, q, tool, p, masses, fields, x_every, q_every, tool_every, p_every, fields_every, out, many)
    return out.reshape(many, 10)


@straight
def _limb_points(x, q, tool, p, masses, x_every, q_every, tool_every, p_every, out, many):
    """282 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        cx = x[x_every * lane + 3]
        cy = x[x_every * lane + 4]
        cz = x[x_every * lane + 5]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        q_here = q[q_every * lane]
        proximal_com = masses[1]
        b = p[p_every * lane + 0]
        a = p[p_every * lane + 1]
        L = p[p_every * lane + 2]
        c = p[p_every * lane + 4]
        phi = p[p_every * lane + 5]
        bx1 = p[p_every * lane + 6]
        by1 = p[p_every * lane + 7]
        bz1 = p[p_every * lane + 8]
        ax1 = p[p_every * lane + 9]
        ay1 = p[p_every * lane + 10]
        az1 = p[p_every * lane + 11]
        bx2 = p[p_every * lane + 13]
        by2 = p[p_every * lane + 14]
        bz2 = p[p_every * lane + 15]
        ax2 = p[p_every * lane + 16]
        ay2 = p[p_every * lane + 17]
        az2 = p[p_every * lane + 18]
        betax = p[p_every * lane + 20]
        betay = p[p_every * lane + 21]
        betaz = p[p_every * lane + 22]
        tip_v = p[p_every * lane + 23]
        tip_w = p[p_every * lane + 24]
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
        s25 = sine(phi)
        s33 = s3*(s3*(2.8114572543455206e-15*s0 + 2.8114572543455206e-15*s1 + 2.8114572543455206e-15*s2 - 7.647163731819816e-13) + 1.6059043836821613e-10)
        s41 = s3*(s3*(s3*(s3*(s33 - 2.505210838544172e-08) + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333)
        s44 = s3*(s41 - 0.16666666666666666) + 1
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
        s78 = cosine(q_here)
        s80 = sine(q_here)
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
        A1_x = R0_11*g1_x + R1_12*g1_y + R1_13*g1_z + s146
        s151 = b*s25
        A1_y = R0_21*g1_x + R1_22*g1_y + R1_23*g1_z + s151
        A1_z = R0_31*g1_x + R1_32*g1_y + R1_33*g1_z
        s157 = h1_x - tx
        s159 = h1_y - ty
        s161 = bz1 - tz
        B1_x = R_11*s157 + R_12*s159 + R_13*s161 + px
        B1_y = R_21*s157 + R_22*s159 + R_23*s161 + py
        B1_z = R_31*s157 + R_32*s159 + R_33*s161 + pz
        g2_x = ax2 - s133 + tip_w
        g2_y = L + ay2
        g2_z = az2 + tip_v
        h2_x = bx2 + s137 - s138
        h2_y = by2 + s140 - s141
        A2_x = R0_11*g2_x + R1_12*g2_y + R1_13*g2_z + s146
        A2_y = R0_21*g2_x + R1_22*g2_y + R1_23*g2_z + s151
        A2_z = R0_31*g2_x + R1_32*g2_y + R1_33*g2_z
        s192 = h2_x - tx
        s194 = h2_y - ty
        s196 = bz2 - tz
        B2_x = R_11*s192 + R_12*s194 + R_13*s196 + px
        B2_y = R_21*s192 + R_22*s194 + R_23*s196 + py
        B2_z = R_31*s192 + R_32*s194 + R_33*s196 + pz
        s211 = L*R1_12*proximal_com + s146
        s214 = L*R1_22*proximal_com + s151
        s271 = L*R1_32*proximal_com
        out[15 * lane + 0] = s211
        out[15 * lane + 1] = s214
        out[15 * lane + 2] = s271
        out[15 * lane + 3] = A1_x
        out[15 * lane + 4] = A1_y
        out[15 * lane + 5] = A1_z
        out[15 * lane + 6] = A2_x
        out[15 * lane + 7] = A2_y
        out[15 * lane + 8] = A2_z
        out[15 * lane + 9] = B1_x
        out[15 * lane + 10] = B1_y
        out[15 * lane + 11] = B1_z
        out[15 * lane + 12] = B2_x
        out[15 * lane + 13] = B2_y
        out[15 * lane + 14] = B2_z


@fast
def limb_points(x, q, tool, p, masses):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    q_every = q.size // len(q) if len(q) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    p_every = p.size // len(p) if len(p) > 1 else 0
    out = np.zeros((many, 15))
    _limb_points(x, q, tool, p, masses, x_every, q_every, tool_every, p_every, out, many)
    return out.reshape(many, 15)


@straight
def _platform(x, tool, masses, payload, fields, x_every, tool_every, payload_every, fields_every, out, many):
    """187 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        cx = x[x_every * lane + 3]
        cy = x[x_every * lane + 4]
        cz = x[x_every * lane + 5]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        payload_here = payload[payload_every * lane]
        platform = masses[3]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
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
        s218 = -R_11*tx - R_12*ty - R_13*tz + px
        s223 = -R_21*tx - R_22*ty - R_23*tz + py
        s228 = -R_31*tx - R_32*ty - R_33*tz + pz
        s234 = f0z*platform
        s235 = -s234*tz
        s237 = -s234*ty
        s239 = -s234*tx
        s242 = f0y*platform
        s243 = -s242*tz
        s245 = -s242*ty
        s247 = -s242*tx
        s250 = f0x*platform
        s251 = -s250*tz
        s253 = -s250*ty
        s255 = -s250*tx
        s264 = s105*s235
        s266 = s105*s237
        s268 = s105*s239
        s270 = s105*s243
        s271 = s266 + s270
        s272 = 0.5*cz
        s273 = 0.5*cy
        s276 = s120*s245
        s277 = s105*s245
        s280 = s117*s247
        s281 = s105*s247
        s282 = s115*s251
        s283 = s105*s251
        s284 = s268 + s283
        s285 = 0.5*cx
        s288 = s112*s253
        s289 = s105*s253
        s290 = s281 + s289
        s293 = s108*s255
        s294 = s105*s255
        s299 = s124*s243 + s126*s239 + s128*s237 + s130*s235 + s276 + s280 + s282 + s288 + s293
        s302 = -0.25*s299/(s104 * s104)
        s312 = f1z*payload_here + s234
        s316 = f1y*payload_here + s242
        s317 = f1x*payload_here + s250
        s318 = 2*cx*(-0.5*s264 - 0.5*s277 + s302) + s266 - s270 + s272*s284 + s273*s290
        s319 = 2*cy*(-0.5*s264 - 0.5*s294 + s302) - s268 + s271*s272 + s283 + s285*s290
        s320 = 2*cz*(-0.5*s277 - 0.5*s294 + s302) + s271*s273 + s281 + s284*s285 - s289
        s329 = payload_here*(-f1y*pz + f1z*py) + platform*(-f0y*s228 + f0z*s223)
        s338 = payload_here*(f1x*pz - f1z*px) + platform*(f0x*s228 - f0z*s218)
        s347 = payload_here*(-f1x*py + f1y*px) + platform*(-f0x*s223 + f0y*s218)
        out[9 * lane + 0] = s317
        out[9 * lane + 1] = s316
        out[9 * lane + 2] = s312
        out[9 * lane + 3] = s318
        out[9 * lane + 4] = s319
        out[9 * lane + 5] = s320
        out[9 * lane + 6] = s329
        out[9 * lane + 7] = s338
        out[9 * lane + 8] = s347


@fast
def platform(x, tool, masses, payload, fields):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    payload_every = payload.size // len(payload) if len(payload) > 1 else 0
    fields_every = fields.size // len(fields) if len(fields) > 1 else 0
    out = np.zeros((many, 9))
    _platform(x, tool, masses, payload, fields, x_every, tool_every, payload_every, fields_every, out, many)
    return out.reshape(many, 9)


@straight
def _platform_points(x, tool, masses, payload, x_every, tool_every, payload_every, out, many):
    """61 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        cx = x[x_every * lane + 3]
        cy = x[x_every * lane + 4]
        cz = x[x_every * lane + 5]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
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
        s218 = -R_11*tx - R_12*ty - R_13*tz + px
        s223 = -R_21*tx - R_22*ty - R_23*tz + py
        s228 = -R_31*tx - R_32*ty - R_33*tz + pz
        out[6 * lane + 0] = s218
        out[6 * lane + 1] = s223
        out[6 * lane + 2] = s228
        out[6 * lane + 3] = px
        out[6 * lane + 4] = py
        out[6 * lane + 5] = pz


@fast
def platform_points(x, tool, masses, payload):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    payload_every = payload.size // len(payload) if len(payload) > 1 else 0
    out = np.zeros((many, 6))
    _platform_points(x, tool, masses, payload, x_every, tool_every, payload_every, out, many)
    return out.reshape(many, 6)
