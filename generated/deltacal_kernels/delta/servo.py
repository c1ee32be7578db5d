"""Commands of one pose for a servo loop: `delta`, Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/servo.py.jinja; sha256 of both e29f1e8aeac1af86; SymPy 1.14.0.

Scalar code without allocation, to be called from loops that Numba compiles. Lengths in mm, angles in rad.
"""

import math

import numpy as np

from deltacal_kernels.compiled import kernel

from .vectorised import MAX_STEPS, PIVOT_SINGULAR, SINGULAR, SOLVED, STEP_LOST, UNREACHABLE

COMMAND_DONE = 3e-8  # rad; after such a step a command is exact to its square: 1e-15 rad
COMMAND_WORK = 72  # length of the scratch array of `exact_command` and `linear_command`
COMMAND_CONSTANTS = 32  # `exact_command` reads these first columns of k only


@kernel(nogil=True, error_model="numpy")
def _newton(x, q, tool, k, out):
    """Per rod of one limb: closure, its derivatives by the platform, by the joint (452 operations)."""
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
    s164 = math.cos(s163)
    s166 = math.sin(s163)
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


@kernel(nogil=True, error_model="numpy")
def _joint(x, q, tool, k, out):
    """Joint of the simplified limb at a given position, then the platform's coordinates that follow from it (36 operations)."""
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
    s1201 = math.sqrt((s1174 * s1174) + s1177*s1198 - (s1192 * s1192))
    s1210 = -theta + math.atan2(-s1174*s1201 + s1176*s1192*s1203, -s1174*s1192 - s1176*s1201*s1203)
    out[0] = s1210


def linear_constants(p):
    """Return k (M, 3, 35), what `linear` reads that no pose changes, from p (81 operations).

    p is that of the calibrated machine: its geometry is taken as nominal, its errors as what to compensate.
    """
    p = np.moveaxis(p, -1, 0).copy()  # value by value, so that all rows of one lie side by side
    k = np.zeros((35, p.shape[1], 3))
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
    R0_11 = np.cos(phi)
    s1 = np.sin(phi)
    R0_11_errors = -beta0*s1
    R0_12_errors = alpha0*s1
    R0_13 = np.sin(phi)
    R0_13_errors = R0_11*beta0
    R0_21 = np.sin(phi)
    R0_21_errors = R0_11*beta0
    R0_22_errors = -R0_11*alpha0
    R0_23_errors = beta0*s1
    g_x_errors = 0.5*beta2*c
    g_y_errors = -0.5*alpha2*c
    g_z = 0.5*c
    g_z_errors = 0.5*dc
    h_x = 0.5*c*s1
    h_x_errors = 0.5*R0_11*beta0*c - 0.5*R0_11*beta03*c
    h_y = -0.5*R0_11*c
    h_y_errors = 0.5*beta0*c*s1 - 0.5*beta03*c*s1
    h_z_errors = -0.5*alpha0*c + 0.5*alpha03*c
    B_x = R0_11*b
    B_y = b*s1
    s58 = R0_13*tip_w + ex
    s67 = -R0_11*tip_w + ey
    s75 = R0_11*a
    s77 = a*s1
    s87 = R0_13*g_z_errors + R0_13_errors*g_z
    s94 = -R0_11*g_z_errors + R0_23_errors*g_z
    s98 = -alpha0*g_z
    s106 = -B_x + s75
    s108 = -L*R0_11
    s110 = -B_y + s77
    s112 = -L*s1
    s124 = (L * L)
    s129 = -0.5*(l * l) + 0.5*s124*((R0_11 * R0_11) + (s1 * s1))
    s148 = -dl_mean*l
    s149 = -0.5*dl*l
    s150 = s148 + s149
    s169 = s148 - s149
    k[0] = s106
    k[1] = s108
    k[2] = s110
    k[3] = s112
    k[4] = s129
    k[5] = s124
    k[6] = L
    k[7] = R0_11
    k[8] = R0_11_errors
    k[9] = R0_12_errors
    k[10] = theta
    k[11] = R0_21
    k[12] = R0_21_errors
    k[13] = R0_22_errors
    k[14] = B_x
    k[15] = dL
    k[16] = tip_v
    k[17] = s58
    k[18] = B_y
    k[19] = s67
    k[20] = ez
    k[21] = s75
    k[22] = s77
    k[23] = g_x_errors
    k[24] = g_y_errors
    k[25] = s87
    k[26] = s94
    k[27] = s98
    k[28] = h_x_errors
    k[29] = h_y_errors
    k[30] = h_z_errors
    k[31] = s150
    k[32] = h_y
    k[33] = h_x
    k[34] = s169
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
    s106 = k[i, 0]
    s108 = k[i, 1]
    s110 = k[i, 2]
    s112 = k[i, 3]
    s129 = k[i, 4]
    s124 = k[i, 5]
    L = k[i, 6]
    A_z = pz - tz
    s107 = px + s106 - tx
    s111 = py + s110 - ty
    s114 = s107*s108 + s111*s112
    s116 = (A_z * A_z)
    s130 = 0.5*(s107 * s107) + 0.5*(s111 * s111) + 0.5*s116 + s129
    s134 = math.sqrt((s114 * s114) + s116*s124 - (s130 * s130))
    s141 = math.atan2(A_z*L*s130 - s114*s134, -A_z*L*s134 - s114*s130)
    row = 1 * i
    out[row + 0] = s141


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
    R0_11 = k[i, 7]
    R0_11_errors = k[i, 8]
    R0_12_errors = k[i, 9]
    theta = k[i, 10]
    R0_21 = k[i, 11]
    R0_21_errors = k[i, 12]
    R0_22_errors = k[i, 13]
    B_x = k[i, 14]
    dL = k[i, 15]
    tip_v = k[i, 16]
    s58 = k[i, 17]
    B_y = k[i, 18]
    s67 = k[i, 19]
    ez = k[i, 20]
    s75 = k[i, 21]
    s77 = k[i, 22]
    g_x_errors = k[i, 23]
    g_y_errors = k[i, 24]
    s87 = k[i, 25]
    s94 = k[i, 26]
    s98 = k[i, 27]
    h_x_errors = k[i, 28]
    h_y_errors = k[i, 29]
    h_z_errors = k[i, 30]
    s150 = k[i, 31]
    h_y = k[i, 32]
    h_x = k[i, 33]
    s169 = k[i, 34]
    s27 = math.cos(q)
    s28 = R0_11*s27
    s29 = math.sin(q)
    s30 = -R0_11*s29
    R1_11_errors = R0_11_errors*s27 + R0_12_errors*s29 + s30*theta
    s39 = R0_21*s27
    s40 = -R0_21*s29
    R1_21_errors = R0_21_errors*s27 + R0_22_errors*s29 + s40*theta
    R1_31_errors = s27*theta
    C_x = B_x + L*s28
    C_x_q = L*s30
    C_x_errors = L*R1_11_errors + dL*s28 + s30*tip_v + s58
    C_y = B_y + L*s39
    C_y_q = L*s40
    C_y_errors = L*R1_21_errors + dL*s39 + s40*tip_v + s67
    C_z_q = L*s27
    C_z_errors = L*R1_31_errors + dL*s29 + ez + s27*tip_v
    s76 = s75 - tx
    s78 = s77 - ty
    A_x = px + s76
    A_y = py + s78
    A_z = pz - tz
    c1_x_errors = g_x_errors*s28 + g_y_errors*s30 + s87
    c1_y_errors = g_x_errors*s39 + g_y_errors*s40 + s94
    c1_z_errors = g_x_errors*s29 + g_y_errors*s27 + s98
    d_x = A_x - C_x
    d_y = A_y - C_y
    d_z = A_z - L*s29
    s_x_errors = -c1_x_errors + h_x_errors
    s_y_errors = -c1_y_errors + h_y_errors
    s_z_errors = -c1_z_errors + h_z_errors
    s142 = -C_x_errors*d_x
    s143 = -C_y_errors*d_y
    s144 = -C_z_errors*d_z
    s145 = d_x*s_x_errors
    s146 = d_y*s_y_errors
    s147 = d_z*s_z_errors
    s151 = s142 + s143 + s144 + s145 + s146 + s147 + s150
    s152 = d_y*tz
    s153 = d_z*s78
    s154 = d_z*h_y
    s155 = s152 + s153 + s154
    s156 = -d_x*tz
    s157 = -d_z*s76
    s158 = -d_z*h_x
    s159 = s156 + s157 + s158
    s160 = -d_x*s78
    s161 = d_y*s76
    s162 = -d_x*h_y
    s163 = d_y*h_x
    s164 = s160 + s161 + s162 + s163
    s168 = -C_x_q*d_x - C_y_q*d_y - C_z_q*d_z
    s170 = s142 + s143 + s144 - s145 - s146 - s147 + s169
    s171 = s152 + s153 - s154
    s172 = s156 + s157 - s158
    s173 = s160 + s161 - s162 - s163
    row = 16 * i
    out[row + 0] = s151
    out[row + 4] = s155
    out[row + 5] = s159
    out[row + 6] = s164
    out[row + 7] = s168
    out[row + 8] = s170
    out[row + 12] = s171
    out[row + 13] = s172
    out[row + 14] = s173
    out[row + 15] = s168


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
    is, to first order, when the errors appear. tool (3,), k (3, 35) from `linear_constants`, scratch work
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
    (COMMAND_WORK,) and k (3, 35), one after the other.
    """
    state[0] = px
    state[1] = py
    state[2] = pz
    q = state[6:9]
    linear_command(state[:3], state[3:6], state[84:].reshape((3, 35)), state[12:84], q)
    return q[0] * state[9], q[1] * state[10], q[2] * state[11], 
