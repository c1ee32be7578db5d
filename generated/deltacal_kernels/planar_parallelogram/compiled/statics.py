"""Generalised loads of `planar_parallelogram`: Planar parallelogram, one joint, row by row for Numba.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both d19b72848da969a9; SymPy 1.14.0.

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
    """113 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        cz = x[x_every * lane + 2]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        q_here = q[q_every * lane]
        proximal = masses[0]
        proximal_com = masses[1]
        distal_rod = masses[2]
        a1x = p[p_every * lane + 0]
        a2x = p[p_every * lane + 1]
        a2y = p[p_every * lane + 2]
        b2x = p[p_every * lane + 4]
        b2y = p[p_every * lane + 5]
        l1 = p[p_every * lane + 6]
        h = p[p_every * lane + 8]
        q0 = p[p_every * lane + 9]
        da1x = p[p_every * lane + 10]
        da2x = p[p_every * lane + 11]
        da2y = p[p_every * lane + 12]
        db2x = p[p_every * lane + 14]
        db2y = p[p_every * lane + 15]
        dl1 = p[p_every * lane + 16]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        f2x = fields[fields_every * lane + 6]
        f2y = fields[fields_every * lane + 7]
        f2z = fields[fields_every * lane + 8]
        A1_x = -a1x - da1x
        A2_x = a2x + da2x
        A2_y = a2y + da2y
        C_y = -h + ty
        b2_x = b2x + db2x
        b2_y = b2y + db2y
        s7 = dl1 + l1
        s8 = q_here + q0
        s9 = sine(s8)
        r1_x = s7*s9
        s11 = cosine(s8)
        r1_y = -s11*s7
        s13 = (cz * cz)
        s15 = 0.25*s13 + 1
        s16 = (1.0 / s15)
        s17 = -0.5*s13*s16
        R_11 = s17 + 1
        R_12 = -cz*s16
        R_21 = cz*s16
        R_22 = s17 + 1
        s29 = b2_x - tx
        s31 = -C_y + b2_y
        B2_x = R_11*s29 + R_12*s31 + px
        B2_y = R_21*s29 + R_22*s31 + py
        s40 = A1_x + proximal_com*r1_x
        s55 = 0.5*distal_rod
        s56 = f2y*s55
        s58 = f2x*s55
        s77 = s29*s56
        s79 = s31*s58
        s89 = s29*s58 + s31*s56
        s97 = -0.25*(cz*s77 - cz*s79 - 0.5*s13*s89)/(s15 * s15)
        s107 = f0x*proximal*proximal_com*s11*s7 + f0y*proximal*proximal_com*s7*s9
        s111 = 2*cz*(-0.5*s16*s89 + s97) + s16*s77 - s16*s79
        s115 = 0.5*A2_y*distal_rod*f1z + 0.5*B2_y*distal_rod*f2z + f0z*proximal*proximal_com*r1_y
        s119 = -0.5*A2_x*distal_rod*f1z - 0.5*B2_x*distal_rod*f2z - f0z*proximal*s40
        s131 = 0.5*distal_rod*(B2_x*f2y - B2_y*f2x)
        s132 = 0.5*distal_rod*(A2_x*f1y - A2_y*f1x) + proximal*(-f0x*proximal_com*r1_y + f0y*s40) + s131
        out[7 * lane + 0] = s107
        out[7 * lane + 1] = s58
        out[7 * lane + 2] = s56
        out[7 * lane + 3] = s111
        out[7 * lane + 4] = s115
        out[7 * lane + 5] = s119
        out[7 * lane + 6] = s132


@fast
def limb(x, q, tool, p, masses, fields):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    q_every = q.size // len(q) if len(q) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    p_every = p.size // len(p) if len(p) > 1 else 0
    fields_every = fields.size // len(fields) if len(fields) > 1 else 0
    out = np.zeros((many, 7))
    _limb(x, q, tool, p, masses, fields, x_every, q_every, tool_every, p_every, fields_every, out, many)
    return out.reshape(many, 7)


@straight
def _limb_points(x, q, tool, p, masses, x_every, q_every, tool_every, p_every, out, many):
    """39 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        cz = x[x_every * lane + 2]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        q_here = q[q_every * lane]
        proximal_com = masses[1]
        a1x = p[p_every * lane + 0]
        a2x = p[p_every * lane + 1]
        a2y = p[p_every * lane + 2]
        b2x = p[p_every * lane + 4]
        b2y = p[p_every * lane + 5]
        l1 = p[p_every * lane + 6]
        h = p[p_every * lane + 8]
        q0 = p[p_every * lane + 9]
        da1x = p[p_every * lane + 10]
        da2x = p[p_every * lane + 11]
        da2y = p[p_every * lane + 12]
        db2x = p[p_every * lane + 14]
        db2y = p[p_every * lane + 15]
        dl1 = p[p_every * lane + 16]
        A1_x = -a1x - da1x
        A2_x = a2x + da2x
        A2_y = a2y + da2y
        C_y = -h + ty
        b2_x = b2x + db2x
        b2_y = b2y + db2y
        s7 = dl1 + l1
        s8 = q_here + q0
        r1_x = s7*sine(s8)
        r1_y = -s7*cosine(s8)
        s13 = (cz * cz)
        s16 = (1.0 / (0.25*s13 + 1))
        s17 = -0.5*s13*s16
        R_11 = s17 + 1
        R_12 = -cz*s16
        R_21 = cz*s16
        R_22 = s17 + 1
        s29 = b2_x - tx
        s31 = -C_y + b2_y
        B2_x = R_11*s29 + R_12*s31 + px
        B2_y = R_21*s29 + R_22*s31 + py
        s40 = A1_x + proximal_com*r1_x
        s65 = proximal_com*r1_y
        out[9 * lane + 0] = s40
        out[9 * lane + 1] = s65
        out[9 * lane + 3] = A2_x
        out[9 * lane + 4] = A2_y
        out[9 * lane + 6] = B2_x
        out[9 * lane + 7] = B2_y


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
    """73 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        cz = x[x_every * lane + 2]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        payload_here = payload[payload_every * lane]
        platform = masses[3]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        s13 = (cz * cz)
        s15 = 0.25*s13 + 1
        s16 = (1.0 / s15)
        s17 = -0.5*s13*s16
        R_11 = s17 + 1
        R_12 = -cz*s16
        R_21 = cz*s16
        R_22 = s17 + 1
        s45 = -R_11*tx - R_12*ty + px
        s49 = -R_21*tx - R_22*ty + py
        s55 = f0y*platform
        s58 = -s55*tx
        s61 = f0x*platform
        s62 = -s61*ty
        s74 = -s55*ty - s61*tx
        s82 = -0.25*(cz*s58 - cz*s62 - 0.5*s13*s74)/(s15 * s15)
        s86 = f1y*payload_here + s55
        s89 = f1x*payload_here + s61
        s90 = 2*cz*(-0.5*s16*s74 + s82) + s16*s58 - s16*s62
        s93 = f0z*platform*s49 + f1z*payload_here*py
        s96 = -f0z*platform*s45 - f1z*payload_here*px
        s105 = payload_here*(-f1x*py + f1y*px) + platform*(-f0x*s49 + f0y*s45)
        out[6 * lane + 0] = s89
        out[6 * lane + 1] = s86
        out[6 * lane + 2] = s90
        out[6 * lane + 3] = s93
        out[6 * lane + 4] = s96
        out[6 * lane + 5] = s105


@fast
def platform(x, tool, masses, payload, fields):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    payload_every = payload.size // len(payload) if len(payload) > 1 else 0
    fields_every = fields.size // len(fields) if len(fields) > 1 else 0
    out = np.zeros((many, 6))
    _platform(x, tool, masses, payload, fields, x_every, tool_every, payload_every, fields_every, out, many)
    return out.reshape(many, 6)


@straight
def _platform_points(x, tool, masses, payload, x_every, tool_every, payload_every, out, many):
    """20 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        cz = x[x_every * lane + 2]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        s13 = (cz * cz)
        s16 = (1.0 / (0.25*s13 + 1))
        s17 = -0.5*s13*s16
        R_11 = s17 + 1
        R_12 = -cz*s16
        R_21 = cz*s16
        R_22 = s17 + 1
        s45 = -R_11*tx - R_12*ty + px
        s49 = -R_21*tx - R_22*ty + py
        out[6 * lane + 0] = s45
        out[6 * lane + 1] = s49
        out[6 * lane + 3] = px
        out[6 * lane + 4] = py


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
