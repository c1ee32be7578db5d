"""Generalised loads of `linear_delta`: Linear delta, three towers and six rods, row by row for Numba.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 52902b9abd6f86ce; SymPy 1.14.0.

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
    """305 operations a row."""
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
        carriage = masses[0]
        distal_rod = masses[1]
        r = p[p_every * lane + 0]
        l = p[p_every * lane + 1]
        phi = p[p_every * lane + 2]
        home = p[p_every * lane + 3]
        a = p[p_every * lane + 4]
        endstop = p[p_every * lane + 6]
        arm = p[p_every * lane + 7]
        radius = p[p_every * lane + 8]
        angle = p[p_every * lane + 9]
        lean_radial = p[p_every * lane + 10]
        lean_tangential = p[p_every * lane + 11]
        scale = p[p_every * lane + 12]
        dr = p[p_every * lane + 14]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        f2x = fields[fields_every * lane + 6]
        f2y = fields[fields_every * lane + 7]
        f2z = fields[fields_every * lane + 8]
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
        s21 = s13*(s13*(s13*(2.8114572543455206e-15*s12 + 2.8114572543455206e-15*s8 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
        s29 = s13*(s13*(s13*(s13*(s21 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
        s30 = s29 + 1
        axis_x = s30*s7
        axis_y = -s11*s30
        s40 = s13*(s13*(s13*(1.5619206968586225e-16*s12 + 1.5619206968586225e-16*s8 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
        s48 = s13*(s13*(s13*(s13*(s40 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        s49 = s48 + 0.5
        axis_z = -(s11 * s11)*s49 - s49*(s7 * s7) + 1
        h = endstop + home + math.sqrt((arm_0 * arm_0) - (r_0 * r_0))
        s60 = scale + 1
        s62 = -q_here*s60 + h/axis_z
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
        out[10 * lane + 0] = s259
        out[10 * lane + 1] = s163
        out[10 * lane + 2] = s161
        out[10 * lane + 3] = s159
        out[10 * lane + 4] = s340
        out[10 * lane + 5] = s341
        out[10 * lane + 6] = s342
        out[10 * lane + 7] = s357
        out[10 * lane + 8] = s370
        out[10 * lane + 9] = s383


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
    """160 operations a row."""
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
        r = p[p_every * lane + 0]
        l = p[p_every * lane + 1]
        phi = p[p_every * lane + 2]
        home = p[p_every * lane + 3]
        a = p[p_every * lane + 4]
        endstop = p[p_every * lane + 6]
        arm = p[p_every * lane + 7]
        radius = p[p_every * lane + 8]
        angle = p[p_every * lane + 9]
        lean_radial = p[p_every * lane + 10]
        lean_tangential = p[p_every * lane + 11]
        scale = p[p_every * lane + 12]
        dr = p[p_every * lane + 14]
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
        s21 = s13*(s13*(s13*(2.8114572543455206e-15*s12 + 2.8114572543455206e-15*s8 - 7.647163731819816e-13) + 1.6059043836821613e-10) - 2.505210838544172e-08)
        s29 = s13*(s13*(s13*(s13*(s21 + 2.7557319223985893e-06) - 0.0001984126984126984) + 0.008333333333333333) - 0.16666666666666666)
        s30 = s29 + 1
        axis_x = s30*s7
        axis_y = -s11*s30
        s40 = s13*(s13*(s13*(1.5619206968586225e-16*s12 + 1.5619206968586225e-16*s8 - 4.779477332387385e-14) + 1.1470745597729725e-11) - 2.08767569878681e-09)
        s48 = s13*(s13*(s13*(s13*(s40 + 2.755731922398589e-07) - 2.48015873015873e-05) + 0.001388888888888889) - 0.041666666666666664)
        s49 = s48 + 0.5
        axis_z = -(s11 * s11)*s49 - s49*(s7 * s7) + 1
        h = endstop + home + math.sqrt((arm_0 * arm_0) - (r_0 * r_0))
        s62 = -q_here*(scale + 1) + h/axis_z
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
        out[9 * lane + 0] = C_x
        out[9 * lane + 1] = C_y
        out[9 * lane + 2] = C_z
        out[9 * lane + 3] = C_x
        out[9 * lane + 4] = C_y
        out[9 * lane + 5] = C_z
        out[9 * lane + 6] = A_x
        out[9 * lane + 7] = A_y
        out[9 * lane + 8] = A_z


@fast
def limb_points(x, q, tool, p, masses):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    q_every = q.size // len(q) if len(q) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    p_every = p.size // len(p) if len(p) > 1 else 0
    out = np.zeros((many, 9))
    _limb_points(x, q, tool, p, masses, x_every, q_every, tool_every, p_every, out, many)
    return out.reshape(many, 9)


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
        platform = masses[2]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
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
        s236 = f1z*payload_here + s158
        s239 = f1y*payload_here + s164
        s240 = f1x*payload_here + s170
        s242 = 2*cx*(-0.5*s187 - 0.5*s201 + s226) + s189 - s194 + s196*s208 + s197*s214
        s243 = 2*cy*(-0.5*s187 - 0.5*s218 + s226) - s192 + s195*s196 + s207 + s209*s214
        s244 = 2*cz*(-0.5*s201 - 0.5*s218 + s226) + s195*s197 + s205 + s208*s209 - s213
        s253 = payload_here*(-f1y*pz + f1z*py) + platform*(-f0y*s152 + f0z*s148)
        s262 = payload_here*(f1x*pz - f1z*px) + platform*(f0x*s152 - f0z*s144)
        s271 = payload_here*(-f1x*py + f1y*px) + platform*(-f0x*s148 + f0y*s144)
        out[9 * lane + 0] = s240
        out[9 * lane + 1] = s239
        out[9 * lane + 2] = s236
        out[9 * lane + 3] = s242
        out[9 * lane + 4] = s243
        out[9 * lane + 5] = s244
        out[9 * lane + 6] = s253
        out[9 * lane + 7] = s262
        out[9 * lane + 8] = s271


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
        out[6 * lane + 0] = s144
        out[6 * lane + 1] = s148
        out[6 * lane + 2] = s152
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
