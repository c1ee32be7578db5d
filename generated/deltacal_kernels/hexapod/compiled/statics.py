"""Generalised loads of `hexapod`: Hexapod of Gough and Stewart, six legs, row by row for Numba.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 5980eab1cf9dd776; SymPy 1.14.0.

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
    """251 operations a row."""
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
        base = p[p_every * lane + 0]
        alpha = p[p_every * lane + 1]
        up = p[p_every * lane + 2]
        plate = p[p_every * lane + 3]
        beta = p[p_every * lane + 4]
        down = p[p_every * lane + 5]
        leg = p[p_every * lane + 6]
        ax = p[p_every * lane + 7]
        ay = p[p_every * lane + 8]
        az = p[p_every * lane + 9]
        bx = p[p_every * lane + 10]
        by = p[p_every * lane + 11]
        bz = p[p_every * lane + 12]
        dl = p[p_every * lane + 13]
        scale = p[p_every * lane + 14]
        dtx = p[p_every * lane + 15]
        dty = p[p_every * lane + 16]
        dtz = p[p_every * lane + 17]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        s0 = (cx * cx)
        s2 = (cy * cy)
        s4 = (cz * cz)
        s6 = 0.25*s0 + 0.25*s2 + 0.25*s4 + 1
        s7 = (1.0 / s6)
        s8 = -0.5*s2
        s9 = -0.5*s4
        s10 = s8 + s9
        R_11 = s10*s7 + 1
        s13 = 0.5*cx*cy
        s14 = -cz + s13
        R_12 = s14*s7
        s16 = 0.5*cx*cz
        s17 = cy + s16
        R_13 = s17*s7
        s19 = cz + s13
        R_21 = s19*s7
        s21 = -0.5*s0
        s22 = s21 + s9
        R_22 = s22*s7 + 1
        s25 = 0.5*cy*cz
        s26 = -cx + s25
        R_23 = s26*s7
        s28 = -cy + s16
        R_31 = s28*s7
        s30 = cx + s25
        R_32 = s30*s7
        s32 = s21 + s8
        R_33 = s32*s7 + 1
        A_x = ax + base*cosine(alpha)
        A_y = ay + base*sine(alpha)
        A_z = az + up
        b_x = bx - dtx + plate*cosine(beta) - tx
        b_y = by - dty + plate*sine(beta) - ty
        b_z = bz + down - dtz - tz
        B_x = R_11*b_x + R_12*b_y + R_13*b_z + px
        B_y = R_21*b_x + R_22*b_y + R_23*b_z + py
        B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz
        d_x = -A_x + B_x
        d_y = -A_y + B_y
        d_z = -A_z + B_z
        s64 = scale + 1
        s = dl + leg + q_here*s64
        s67 = (1.0 / s)
        e_x = d_x*s67
        e_y = d_y*s67
        e_z = d_z*s67
        s72 = B_x - 0.5*e_x*leg
        s75 = B_y - 0.5*e_y*leg
        s78 = B_z - 0.5*e_z*leg
        s83 = A_x + e_x*leg*proximal_com
        s86 = A_y + e_y*leg*proximal_com
        s89 = A_z + e_z*leg*proximal_com
        s96 = leg*proximal_com
        s117 = distal_rod*f1z
        s118 = -0.5*leg
        s123 = distal_rod*f1y
        s128 = distal_rod*f1x
        s132 = f0z*proximal*s96 + s117*s118
        s135 = f0y*proximal*s96 + s118*s123
        s138 = f0x*proximal*s96 + s118*s128
        s144 = -s64*(d_x*s138 + d_y*s135 + d_z*s132)/(s * s)
        s146 = s117 + s132*s67
        s147 = b_z*s146
        s149 = b_y*s146
        s151 = b_x*s146
        s153 = s123 + s135*s67
        s154 = b_z*s153
        s156 = b_y*s153
        s158 = b_x*s153
        s160 = s128 + s138*s67
        s161 = b_z*s160
        s163 = b_y*s160
        s165 = b_x*s160
        s185 = s147*s7
        s187 = s149*s7
        s189 = s151*s7
        s191 = s154*s7
        s193 = s187 + s191
        s194 = 0.5*cz
        s195 = 0.5*cy
        s198 = s156*s7
        s199 = s156*s22
        s202 = s158*s7
        s203 = s158*s19
        s204 = s161*s7
        s205 = s161*s17
        s206 = s189 + s204
        s207 = 0.5*cx
        s210 = s163*s7
        s211 = s14*s163
        s212 = s202 + s210
        s215 = s165*s7
        s216 = s10*s165
        s221 = s147*s32 + s149*s30 + s151*s28 + s154*s26 + s199 + s203 + s205 + s211 + s216
        s224 = -0.25*s221/(s6 * s6)
        s240 = 2*cx*(-0.5*s185 - 0.5*s198 + s224) + s187 - s191 + s194*s206 + s195*s212
        s241 = 2*cy*(-0.5*s185 - 0.5*s215 + s224) - s189 + s193*s194 + s204 + s207*s212
        s242 = 2*cz*(-0.5*s198 - 0.5*s215 + s224) + s193*s195 + s202 + s206*s207 - s210
        s251 = distal_rod*(-f1y*s78 + f1z*s75) + proximal*(-f0y*s89 + f0z*s86)
        s260 = distal_rod*(f1x*s78 - f1z*s72) + proximal*(f0x*s89 - f0z*s83)
        s269 = distal_rod*(-f1x*s75 + f1y*s72) + proximal*(-f0x*s86 + f0y*s83)
        out[10 * lane + 0] = s144
        out[10 * lane + 1] = s160
        out[10 * lane + 2] = s153
        out[10 * lane + 3] = s146
        out[10 * lane + 4] = s240
        out[10 * lane + 5] = s241
        out[10 * lane + 6] = s242
        out[10 * lane + 7] = s251
        out[10 * lane + 8] = s260
        out[10 * lane + 9] = s269


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
    """110 operations a row."""
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
        base = p[p_every * lane + 0]
        alpha = p[p_every * lane + 1]
        up = p[p_every * lane + 2]
        plate = p[p_every * lane + 3]
        beta = p[p_every * lane + 4]
        down = p[p_every * lane + 5]
        leg = p[p_every * lane + 6]
        ax = p[p_every * lane + 7]
        ay = p[p_every * lane + 8]
        az = p[p_every * lane + 9]
        bx = p[p_every * lane + 10]
        by = p[p_every * lane + 11]
        bz = p[p_every * lane + 12]
        dl = p[p_every * lane + 13]
        scale = p[p_every * lane + 14]
        dtx = p[p_every * lane + 15]
        dty = p[p_every * lane + 16]
        dtz = p[p_every * lane + 17]
        s0 = (cx * cx)
        s2 = (cy * cy)
        s4 = (cz * cz)
        s7 = (1.0 / (0.25*s0 + 0.25*s2 + 0.25*s4 + 1))
        s8 = -0.5*s2
        s9 = -0.5*s4
        R_11 = s7*(s8 + s9) + 1
        s13 = 0.5*cx*cy
        R_12 = s7*(-cz + s13)
        s16 = 0.5*cx*cz
        R_13 = s7*(cy + s16)
        R_21 = s7*(cz + s13)
        s21 = -0.5*s0
        R_22 = s7*(s21 + s9) + 1
        s25 = 0.5*cy*cz
        R_23 = s7*(-cx + s25)
        R_31 = s7*(-cy + s16)
        R_32 = s7*(cx + s25)
        R_33 = s7*(s21 + s8) + 1
        A_x = ax + base*cosine(alpha)
        A_y = ay + base*sine(alpha)
        A_z = az + up
        b_x = bx - dtx + plate*cosine(beta) - tx
        b_y = by - dty + plate*sine(beta) - ty
        b_z = bz + down - dtz - tz
        B_x = R_11*b_x + R_12*b_y + R_13*b_z + px
        B_y = R_21*b_x + R_22*b_y + R_23*b_z + py
        B_z = R_31*b_x + R_32*b_y + R_33*b_z + pz
        d_x = -A_x + B_x
        d_y = -A_y + B_y
        d_z = -A_z + B_z
        s = dl + leg + q_here*(scale + 1)
        s67 = (1.0 / s)
        e_x = d_x*s67
        e_y = d_y*s67
        e_z = d_z*s67
        s72 = B_x - 0.5*e_x*leg
        s75 = B_y - 0.5*e_y*leg
        s78 = B_z - 0.5*e_z*leg
        s83 = A_x + e_x*leg*proximal_com
        s86 = A_y + e_y*leg*proximal_com
        s89 = A_z + e_z*leg*proximal_com
        out[6 * lane + 0] = s83
        out[6 * lane + 1] = s86
        out[6 * lane + 2] = s89
        out[6 * lane + 3] = s72
        out[6 * lane + 4] = s75
        out[6 * lane + 5] = s78


@fast
def limb_points(x, q, tool, p, masses):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    q_every = q.size // len(q) if len(q) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    p_every = p.size // len(p) if len(p) > 1 else 0
    out = np.zeros((many, 6))
    _limb_points(x, q, tool, p, masses, x_every, q_every, tool_every, p_every, out, many)
    return out.reshape(many, 6)


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
        s0 = (cx * cx)
        s2 = (cy * cy)
        s4 = (cz * cz)
        s6 = 0.25*s0 + 0.25*s2 + 0.25*s4 + 1
        s7 = (1.0 / s6)
        s8 = -0.5*s2
        s9 = -0.5*s4
        s10 = s8 + s9
        R_11 = s10*s7 + 1
        s13 = 0.5*cx*cy
        s14 = -cz + s13
        R_12 = s14*s7
        s16 = 0.5*cx*cz
        s17 = cy + s16
        R_13 = s17*s7
        s19 = cz + s13
        R_21 = s19*s7
        s21 = -0.5*s0
        s22 = s21 + s9
        R_22 = s22*s7 + 1
        s25 = 0.5*cy*cz
        s26 = -cx + s25
        R_23 = s26*s7
        s28 = -cy + s16
        R_31 = s28*s7
        s30 = cx + s25
        R_32 = s30*s7
        s32 = s21 + s8
        R_33 = s32*s7 + 1
        s79 = -R_11*tx - R_12*ty - R_13*tz + px
        s84 = -R_21*tx - R_22*ty - R_23*tz + py
        s89 = -R_31*tx - R_32*ty - R_33*tz + pz
        s95 = f0z*platform
        s96 = -s95*tz
        s98 = -s95*ty
        s100 = -s95*tx
        s103 = f0y*platform
        s104 = -s103*tz
        s106 = -s103*ty
        s108 = -s103*tx
        s111 = f0x*platform
        s112 = -s111*tz
        s114 = -s111*ty
        s116 = -s111*tx
        s124 = s7*s96
        s126 = s7*s98
        s128 = s100*s7
        s130 = s104*s7
        s132 = s126 + s130
        s133 = 0.5*cz
        s134 = 0.5*cy
        s137 = s106*s7
        s138 = s106*s22
        s141 = s108*s7
        s142 = s108*s19
        s143 = s112*s7
        s144 = s112*s17
        s145 = s128 + s143
        s146 = 0.5*cx
        s149 = s114*s7
        s150 = s114*s14
        s151 = s141 + s149
        s154 = s116*s7
        s155 = s10*s116
        s160 = s100*s28 + s104*s26 + s138 + s142 + s144 + s150 + s155 + s30*s98 + s32*s96
        s163 = -0.25*s160/(s6 * s6)
        s173 = f1z*payload_here + s95
        s177 = f1y*payload_here + s103
        s178 = f1x*payload_here + s111
        s179 = 2*cx*(-0.5*s124 - 0.5*s137 + s163) + s126 - s130 + s133*s145 + s134*s151
        s180 = 2*cy*(-0.5*s124 - 0.5*s154 + s163) - s128 + s132*s133 + s143 + s146*s151
        s181 = 2*cz*(-0.5*s137 - 0.5*s154 + s163) + s132*s134 + s141 + s145*s146 - s149
        s190 = payload_here*(-f1y*pz + f1z*py) + platform*(-f0y*s89 + f0z*s84)
        s199 = payload_here*(f1x*pz - f1z*px) + platform*(f0x*s89 - f0z*s79)
        s208 = payload_here*(-f1x*py + f1y*px) + platform*(-f0x*s84 + f0y*s79)
        out[9 * lane + 0] = s178
        out[9 * lane + 1] = s177
        out[9 * lane + 2] = s173
        out[9 * lane + 3] = s179
        out[9 * lane + 4] = s180
        out[9 * lane + 5] = s181
        out[9 * lane + 6] = s190
        out[9 * lane + 7] = s199
        out[9 * lane + 8] = s208


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
        s0 = (cx * cx)
        s2 = (cy * cy)
        s4 = (cz * cz)
        s7 = (1.0 / (0.25*s0 + 0.25*s2 + 0.25*s4 + 1))
        s8 = -0.5*s2
        s9 = -0.5*s4
        R_11 = s7*(s8 + s9) + 1
        s13 = 0.5*cx*cy
        R_12 = s7*(-cz + s13)
        s16 = 0.5*cx*cz
        R_13 = s7*(cy + s16)
        R_21 = s7*(cz + s13)
        s21 = -0.5*s0
        R_22 = s7*(s21 + s9) + 1
        s25 = 0.5*cy*cz
        R_23 = s7*(-cx + s25)
        R_31 = s7*(-cy + s16)
        R_32 = s7*(cx + s25)
        R_33 = s7*(s21 + s8) + 1
        s79 = -R_11*tx - R_12*ty - R_13*tz + px
        s84 = -R_21*tx - R_22*ty - R_23*tz + py
        s89 = -R_31*tx - R_32*ty - R_33*tz + pz
        out[6 * lane + 0] = s79
        out[6 * lane + 1] = s84
        out[6 * lane + 2] = s89
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
