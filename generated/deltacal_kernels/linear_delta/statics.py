"""Generalised loads of `linear_delta`: Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both efc708c52ef3fce8; SymPy 1.14.0.

Plain NumPy over all poses at once. masses: carriage distal_rod platform; payload (N,) in kg at the
reference point. Every weight has its own acceleration field [m/s^2]: gravity for all, or minus its own acceleration.
Loads in N (along lengths) and N mm (along angles).
"""

import numpy as np

LIMB_WEIGHTS = 3
PLATFORM_WEIGHTS = 2


def _limb(x, q, tool, p, masses, fields):
    """Generalised loads of the weights of one limb and their moment: (N, 10)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    carriage = masses[0]
    distal_rod = masses[1]
    r = p[:, 0]
    l = p[:, 1]
    phi = p[:, 2]
    home = p[:, 3]
    a = p[:, 4]
    endstop = p[:, 6]
    arm = p[:, 7]
    radius = p[:, 8]
    angle = p[:, 9]
    lean_radial = p[:, 10]
    lean_tangential = p[:, 11]
    scale = p[:, 12]
    dr = p[:, 14]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    f2x = fields[:, 6]
    f2y = fields[:, 7]
    f2z = fields[:, 8]
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
    s21 = s13*(s13*(s13*(2.8114572543455206e-15*s12 + 2.8114572543455206e-15*s8 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
    s29 = s13*(s13*(s13*(s13*(s21 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
    s30 = s29 + 1
    axis_x = s30*s7
    axis_y = -s11*s30
    s40 = s13*(s13*(s13*(1.5619206968586225e-16*s12 + 1.5619206968586225e-16*s8 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
    s48 = s13*(s13*(s13*(s13*(s40 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
    s49 = s48 + 0.5
    axis_z = -(s11 * s11)*s49 - s49*(s7 * s7) + 1
    h = endstop + home + np.sqrt((arm_0 * arm_0) - (r_0 * r_0))
    s60 = scale + 1
    s62 = -q*s60 + h/axis_z
    s64 = a + r_0
    C_x = axis_x*s62 + s64*u_x
    C_y = axis_y*s62 + s64*u_y
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
    s107 = a*u_x - tx
    s110 = a*u_y - ty
    A_x = R_11*s107 + R_12*s110 - R_13*tz + px
    A_y = R_21*s107 + R_22*s110 - R_23*tz + py
    A_z = R_31*s107 + R_32*s110 - R_33*tz + pz
    s159 = distal_rod*f2z
    s161 = distal_rod*f2y
    s163 = distal_rod*f2x
    s171 = -s159*tz
    s173 = s110*s159
    s175 = s107*s159
    s177 = -s161*tz
    s179 = s110*s161
    s181 = s107*s161
    s183 = -s163*tz
    s185 = s110*s163
    s190 = s107*s163
    s195 = s171*s78
    s197 = s173*s78
    s200 = s175*s78
    s202 = s177*s78
    s203 = s197 + s202
    s204 = 0.5*cz
    s205 = 0.5*cy
    s208 = s179*s93
    s209 = s179*s78
    s212 = s181*s90
    s213 = s181*s78
    s214 = s183*s88
    s215 = s183*s78
    s216 = s200 + s215
    s217 = 0.5*cx
    s220 = s185*s85
    s221 = s185*s78
    s222 = s213 + s221
    s225 = s190*s81
    s226 = s190*s78
    s231 = s101*s173 + s103*s171 + s175*s99 + s177*s97 + s208 + s212 + s214 + s220 + s225
    s234 = -0.25*s231/(s77 * s77)
    s257 = axis_x*(carriage*f0x + distal_rod*f1x)
    s259 = -s60*(axis_y*(carriage*f0y + distal_rod*f1y) + axis_z*(carriage*f0z + distal_rod*f1z) + s257)
    s340 = 2*cx*(-0.5*s195 - 0.5*s209 + s234) + s197 - s202 + s204*s216 + s205*s222
    s341 = 2*cy*(-0.5*s195 - 0.5*s226 + s234) - s200 + s203*s204 + s215 + s217*s222
    s342 = 2*cz*(-0.5*s209 - 0.5*s226 + s234) + s203*s205 + s213 + s216*s217 - s221
    s356 = distal_rod*(C_y*f1z - C_z*f1y)
    s357 = carriage*(C_y*f0z - C_z*f0y) + distal_rod*(A_y*f2z - A_z*f2y) + s356
    s369 = distal_rod*(-C_x*f1z + C_z*f1x)
    s370 = carriage*(-C_x*f0z + C_z*f0x) + distal_rod*(-A_x*f2z + A_z*f2x) + s369
    s382 = distal_rod*(C_x*f1y - C_y*f1x)
    s383 = carriage*(C_x*f0y - C_y*f0x) + distal_rod*(A_x*f2y - A_y*f2x) + s382
    out = np.zeros((len(x), 10))
    out[:, 0] = s259
    out[:, 1] = s163
    out[:, 2] = s161
    out[:, 3] = s159
    out[:, 4] = s340
    out[:, 5] = s341
    out[:, 6] = s342
    out[:, 7] = s357
    out[:, 8] = s370
    out[:, 9] = s383
    return out


def _limb_points(x, q, tool, p, masses):
    """Where the weights of one limb are: (N, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    r = p[:, 0]
    l = p[:, 1]
    phi = p[:, 2]
    home = p[:, 3]
    a = p[:, 4]
    endstop = p[:, 6]
    arm = p[:, 7]
    radius = p[:, 8]
    angle = p[:, 9]
    lean_radial = p[:, 10]
    lean_tangential = p[:, 11]
    scale = p[:, 12]
    dr = p[:, 14]
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
    s21 = s13*(s13*(s13*(2.8114572543455206e-15*s12 + 2.8114572543455206e-15*s8 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
    s29 = s13*(s13*(s13*(s13*(s21 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
    s30 = s29 + 1
    axis_x = s30*s7
    axis_y = -s11*s30
    s40 = s13*(s13*(s13*(1.5619206968586225e-16*s12 + 1.5619206968586225e-16*s8 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
    s48 = s13*(s13*(s13*(s13*(s40 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
    s49 = s48 + 0.5
    axis_z = -(s11 * s11)*s49 - s49*(s7 * s7) + 1
    h = endstop + home + np.sqrt((arm_0 * arm_0) - (r_0 * r_0))
    s62 = -q*(scale + 1) + h/axis_z
    s64 = a + r_0
    C_x = axis_x*s62 + s64*u_x
    C_y = axis_y*s62 + s64*u_y
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
    s107 = a*u_x - tx
    s110 = a*u_y - ty
    A_x = R_11*s107 + R_12*s110 - R_13*tz + px
    A_y = R_21*s107 + R_22*s110 - R_23*tz + py
    A_z = R_31*s107 + R_32*s110 - R_33*tz + pz
    out = np.zeros((len(x), 9))
    out[:, 0] = C_x
    out[:, 1] = C_y
    out[:, 2] = C_z
    out[:, 3] = C_x
    out[:, 4] = C_y
    out[:, 5] = C_z
    out[:, 6] = A_x
    out[:, 7] = A_y
    out[:, 8] = A_z
    return out


def _platform(x, tool, masses, payload, fields):
    """Generalised loads of the weights of one platform and their moment: (N, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    platform = masses[2]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
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
    s144 = -R_11*tx - R_12*ty - R_13*tz + px
    s148 = -R_21*tx - R_22*ty - R_23*tz + py
    s152 = -R_31*tx - R_32*ty - R_33*tz + pz
    s158 = f0z*platform
    s159 = -s158*ty
    s161 = -s158*tx
    s164 = f0y*platform
    s165 = -s164*ty
    s167 = -s164*tx
    s170 = f0x*platform
    s171 = -s170*ty
    s173 = -s170*tx
    s181 = -s158*tz
    s183 = -s164*tz
    s185 = -s170*tz
    s187 = s181*s78
    s189 = s159*s78
    s192 = s161*s78
    s194 = s183*s78
    s195 = s189 + s194
    s196 = 0.5*cz
    s197 = 0.5*cy
    s200 = s165*s93
    s201 = s165*s78
    s204 = s167*s90
    s205 = s167*s78
    s206 = s185*s88
    s207 = s185*s78
    s208 = s192 + s207
    s209 = 0.5*cx
    s212 = s171*s85
    s213 = s171*s78
    s214 = s205 + s213
    s217 = s173*s81
    s218 = s173*s78
    s223 = s101*s159 + s103*s181 + s161*s99 + s183*s97 + s200 + s204 + s206 + s212 + s217
    s226 = -0.25*s223/(s77 * s77)
    s236 = f1z*payload + s158
    s239 = f1y*payload + s164
    s240 = f1x*payload + s170
    s242 = 2*cx*(-0.5*s187 - 0.5*s201 + s226) + s189 - s194 + s196*s208 + s197*s214
    s243 = 2*cy*(-0.5*s187 - 0.5*s218 + s226) - s192 + s195*s196 + s207 + s209*s214
    s244 = 2*cz*(-0.5*s201 - 0.5*s218 + s226) + s195*s197 + s205 + s208*s209 - s213
    s253 = payload*(-f1y*pz + f1z*py) + platform*(-f0y*s152 + f0z*s148)
    s262 = payload*(f1x*pz - f1z*px) + platform*(f0x*s152 - f0z*s144)
    s271 = payload*(-f1x*py + f1y*px) + platform*(-f0x*s148 + f0y*s144)
    out = np.zeros((len(x), 9))
    out[:, 0] = s240
    out[:, 1] = s239
    out[:, 2] = s236
    out[:, 3] = s242
    out[:, 4] = s243
    out[:, 5] = s244
    out[:, 6] = s253
    out[:, 7] = s262
    out[:, 8] = s271
    return out


def _platform_points(x, tool, masses, payload):
    """Where the weights of one platform are: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
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
    s144 = -R_11*tx - R_12*ty - R_13*tz + px
    s148 = -R_21*tx - R_22*ty - R_23*tz + py
    s152 = -R_31*tx - R_32*ty - R_33*tz + pz
    out = np.zeros((len(x), 6))
    out[:, 0] = s144
    out[:, 1] = s148
    out[:, 2] = s152
    out[:, 3] = px
    out[:, 4] = py
    out[:, 5] = pz
    return out


def points(x, q, tool, p, masses, payload):
    """Return where the weights are, (N, 11, 3): limb by limb, then the platform's."""
    parts = [_limb_points(x, q[:, i], tool, p[:, i], masses) for i in range(3)]
    return np.hstack([*parts, _platform_points(x, tool, masses, payload)]).reshape(len(x), -1, 3)


def loads(x, q, tool, p, masses, payload, fields):
    """Return generalised loads W_q (N, 3) on the joints, W_x (N, 6) on the platform, and the moment about {O} (N, 3).

    fields (N, weights, 3): in the order of `points`.
    """
    flat = fields.reshape(len(x), -1)
    W_q = np.zeros((len(x), 3))
    rest = _platform(x, tool, masses, payload, flat[:, 27:])
    for i in range(3):
        own = _limb(x, q[:, i], tool, p[:, i], masses, flat[:, 9 * i :])
        W_q[:, i] = own[:, 0]
        rest += own[:, 1:]
    return W_q, rest[:, :6], rest[:, 6:]
