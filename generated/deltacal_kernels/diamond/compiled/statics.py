"""Generalised loads of `diamond`: Diamond, two arms in a plane, row by row for Numba.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 523000b5315d8ee1; SymPy 1.14.0.

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
    """95 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        q_here = q[q_every * lane]
        proximal = masses[0]
        proximal_com = masses[1]
        distal_rod = masses[2]
        base_x = p[p_every * lane + 0]
        base_y = p[p_every * lane + 1]
        L = p[p_every * lane + 2]
        side = p[p_every * lane + 4]
        theta = p[p_every * lane + 5]
        ex = p[p_every * lane + 6]
        ey = p[p_every * lane + 7]
        dL = p[p_every * lane + 8]
        tip_v = p[p_every * lane + 12]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        f2x = fields[fields_every * lane + 6]
        f2y = fields[fields_every * lane + 7]
        f2z = fields[fields_every * lane + 8]
        B_x = base_x*side + ex
        B_y = base_y + ey
        s3 = L + dL
        s6 = q_here + theta - 0.5*math.pi*(1 - side)
        s7 = cosine(s6)
        s9 = sine(s6)
        C_x = B_x + s3*s7*side - s9*side*tip_v
        C_y = B_y + s3*s9*side + s7*side*tip_v
        A_x = px - tx
        A_y = py - ty
        s20 = B_x + proximal_com*s3*s7*side
        s23 = B_y + proximal_com*s3*s9*side
        s37 = 0.5*distal_rod
        s38 = f1y*s37
        s40 = f1x*s37
        s43 = f2y*s37
        s45 = f2x*s37
        s50 = proximal_com*s3*side
        s65 = s3*side
        s70 = side*tip_v
        s87 = -s9*(f0x*proximal*s50 + s38*s70 + s40*s65)
        s88 = s7*(f0y*proximal*s50 + s38*s65 - s40*s70) + s87
        s102 = 0.5*A_y*distal_rod*f2z + 0.5*C_y*distal_rod*f1z + f0z*proximal*s23
        s106 = -0.5*A_x*distal_rod*f2z - 0.5*C_x*distal_rod*f1z - f0z*proximal*s20
        s118 = 0.5*distal_rod*(C_x*f1y - C_y*f1x)
        s119 = 0.5*distal_rod*(A_x*f2y - A_y*f2x) + proximal*(-f0x*s23 + f0y*s20) + s118
        out[6 * lane + 0] = s88
        out[6 * lane + 1] = s45
        out[6 * lane + 2] = s43
        out[6 * lane + 3] = s102
        out[6 * lane + 4] = s106
        out[6 * lane + 5] = s119


@fast
def limb(x, q, tool, p, masses, fields):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    q_every = q.size // len(q) if len(q) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    p_every = p.size // len(p) if len(p) > 1 else 0
    fields_every = fields.size // len(fields) if len(fields) > 1 else 0
    out = np.zeros((many, 6))
    _limb(x, q, tool, p, masses, fields, x_every, q_every, tool_every, p_every, fields_every, out, many)
    return out.reshape(many, 6)


@straight
def _limb_points(x, q, tool, p, masses, x_every, q_every, tool_every, p_every, out, many):
    """33 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        q_here = q[q_every * lane]
        proximal_com = masses[1]
        base_x = p[p_every * lane + 0]
        base_y = p[p_every * lane + 1]
        L = p[p_every * lane + 2]
        side = p[p_every * lane + 4]
        theta = p[p_every * lane + 5]
        ex = p[p_every * lane + 6]
        ey = p[p_every * lane + 7]
        dL = p[p_every * lane + 8]
        tip_v = p[p_every * lane + 12]
        B_x = base_x*side + ex
        B_y = base_y + ey
        s3 = L + dL
        s6 = q_here + theta - 0.5*math.pi*(1 - side)
        s7 = cosine(s6)
        s9 = sine(s6)
        C_x = B_x + s3*s7*side - s9*side*tip_v
        C_y = B_y + s3*s9*side + s7*side*tip_v
        A_x = px - tx
        A_y = py - ty
        s20 = B_x + proximal_com*s3*s7*side
        s23 = B_y + proximal_com*s3*s9*side
        out[9 * lane + 0] = s20
        out[9 * lane + 1] = s23
        out[9 * lane + 3] = C_x
        out[9 * lane + 4] = C_y
        out[9 * lane + 6] = A_x
        out[9 * lane + 7] = A_y


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
    """32 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
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
        A_x = px - tx
        A_y = py - ty
        s39 = f0y*platform + f1y*payload_here
        s40 = f0x*platform + f1x*payload_here
        s46 = f1z*payload_here*py + platform*(A_y*f0z + f0y*tz)
        s52 = -f1z*payload_here*px + platform*(-A_x*f0z - f0x*tz)
        s61 = payload_here*(-f1x*py + f1y*px) + platform*(A_x*f0y - A_y*f0x)
        out[5 * lane + 0] = s40
        out[5 * lane + 1] = s39
        out[5 * lane + 2] = s46
        out[5 * lane + 3] = s52
        out[5 * lane + 4] = s61


@fast
def platform(x, tool, masses, payload, fields):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    tool_every = tool.size // len(tool) if len(tool) > 1 else 0
    payload_every = payload.size // len(payload) if len(payload) > 1 else 0
    fields_every = fields.size // len(fields) if len(fields) > 1 else 0
    out = np.zeros((many, 5))
    _platform(x, tool, masses, payload, fields, x_every, tool_every, payload_every, fields_every, out, many)
    return out.reshape(many, 5)


@straight
def _platform_points(x, tool, masses, payload, x_every, tool_every, payload_every, out, many):
    """3 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        A_x = px - tx
        A_y = py - ty
        out[6 * lane + 0] = A_x
        out[6 * lane + 1] = A_y
        out[6 * lane + 2] = -tz
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
