"""Commands of one pose for a servo loop: `complete_delta`, Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both b779cdd40b88fa71; SymPy 1.14.0.

Scalar code without allocation, to be called from loops that Numba compiles. Lengths in mm, angles in rad.
"""

import math

import numpy as np

from deltacal_kernels.compiled import kernel

from .vectorised import MAX_STEPS, PIVOT_SINGULAR, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 72  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 31  # `exact_command` reads these first columns of k only


@kernel(nogil=True, error_model="numpy")
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


@kernel(nogil=True, error_model="numpy")
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


def linear_constants(p):
    """Return k (M, 3, 40), what `linear` reads that no pose changes, from p (77 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((40, p.shape[1], 3))
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
    k[0] = s125
    k[1] = s127
    k[2] = s129
    k[3] = s131
    k[4] = s148
    k[5] = s143
    k[6] = L
    k[7] = F_12
    k[8] = F_12_errors
    k[9] = betay
    k[10] = F_22
    k[11] = F_22_errors
    k[12] = betax
    k[13] = F_32_errors
    k[14] = s46
    k[15] = ay1
    k[16] = g1_z_errors
    k[17] = s54
    k[18] = s59
    k[19] = s67
    k[20] = s71
    k[21] = h1_x
    k[22] = h1_y
    k[23] = bx1
    k[24] = by1
    k[25] = bz1
    k[26] = s93
    k[27] = ay2
    k[28] = g2_z_errors
    k[29] = s99
    k[30] = s102
    k[31] = s108
    k[32] = s110
    k[33] = h2_x
    k[34] = h2_y
    k[35] = bx2
    k[36] = by2
    k[37] = bz2
    k[38] = s164
    k[39] = s182
    return np.ascontiguousarray(np.moveaxis(k, 0, -1))


@kernel(nogil=True, error_model="numpy")
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


@kernel(nogil=True, error_model="numpy")
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


@kernel(nogil=True, error_model="numpy")
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


@kernel(nogil=True, error_model="numpy")
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


@kernel(nogil=True, error_model="numpy")
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


@kernel(nogil=True, error_model="numpy")
def linear_commands(target, tool, k, q, status):
    """Fill joints q (N, 3) and status (N,) by `linear_command`; target (N, 3) and tool (N, 3), k (M, 3, :)."""
    work = np.zeros(COMMAND_WORK)
    for n in range(target.shape[0]):
        status[n] = linear_command(target[n], tool[n], k[n if k.shape[0] > 1 else 0], work, q[n])


@kernel(nogil=True, error_model="numpy")
def exact_joints(px, py, pz, state):
    """Return the joints of `exact_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (3,), scratch
    (COMMAND_WORK,) and k (3, COMMAND_CONSTANTS), one after the other.
    """
    state[0] = px
    state[1] = py
    state[2] = pz
    q = state[6:9]
    exact_command(state[:3], state[3:6], state[84:].reshape((3, COMMAND_CONSTANTS)), state[12:84], q)
    return q[0] * state[9], q[1] * state[10], q[2] * state[11], 


@kernel(nogil=True, error_model="numpy")
def linear_joints(px, py, pz, state):
    """Return the joints of `linear_command` for a target, as the controller counts them; NaN where there are none.

    For calls from Python, which pay for every array: state holds the target, tool (3,), joints, signs (3,), scratch
    (COMMAND_WORK,) and k (3, 40), one after the other.
    """
    state[0] = px
    state[1] = py
    state[2] = pz
    q = state[6:9]
    linear_command(state[:3], state[3:6], state[84:].reshape((3, 40)), state[12:84], q)
    return q[0] * state[9], q[1] * state[10], q[2] * state[11], 
