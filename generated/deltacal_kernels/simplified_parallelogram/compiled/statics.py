"""Generalised loads of `simplified_parallelogram`: Planar parallelogram, simplified: one virtual rod, row by row for Numba.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both f3b23040868d10d8; SymPy 1.14.0.

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
    """58 operations a row."""
    for lane in range(many):
        q_here = q[q_every * lane]
        proximal = masses[0]
        proximal_com = masses[1]
        distal_rod = masses[2]
        a1x = p[p_every * lane + 0]
        b1x = p[p_every * lane + 3]
        l1 = p[p_every * lane + 6]
        q0 = p[p_every * lane + 9]
        dl1 = p[p_every * lane + 10]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        f2x = fields[fields_every * lane + 6]
        f2y = fields[fields_every * lane + 7]
        f2z = fields[fields_every * lane + 8]
        A_x = -a1x + b1x
        s1 = dl1 + l1
        s2 = q_here + q0
        s3 = sine(s2)
        r_x = s1*s3
        s5 = cosine(s2)
        r_y = -s1*s5
        B_x = A_x + r_x
        s11 = A_x + proximal_com*r_x
        s26 = 0.5*distal_rod
        s48 = s1*s5*(f0x*proximal*proximal_com + f2x*s26)
        s49 = s1*s3*(f0y*proximal*proximal_com + f2y*s26) + s48
        s56 = 0.5*distal_rod*f2z*r_y + f0z*proximal*proximal_com*r_y
        s60 = -0.5*A_x*distal_rod*f1z - 0.5*B_x*distal_rod*f2z - f0z*proximal*s11
        s69 = 0.5*A_x*distal_rod*f1y
        s70 = 0.5*distal_rod*(B_x*f2y - f2x*r_y) + proximal*(-f0x*proximal_com*r_y + f0y*s11) + s69
        out[7 * lane + 0] = s49
        out[7 * lane + 4] = s56
        out[7 * lane + 5] = s60
        out[7 * lane + 6] = s70


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
    """12 operations a row."""
    for lane in range(many):
        q_here = q[q_every * lane]
        proximal_com = masses[1]
        a1x = p[p_every * lane + 0]
        b1x = p[p_every * lane + 3]
        l1 = p[p_every * lane + 6]
        q0 = p[p_every * lane + 9]
        dl1 = p[p_every * lane + 10]
        A_x = -a1x + b1x
        s1 = dl1 + l1
        s2 = q_here + q0
        r_x = s1*sine(s2)
        r_y = -s1*cosine(s2)
        B_x = A_x + r_x
        s11 = A_x + proximal_com*r_x
        s31 = proximal_com*r_y
        out[9 * lane + 0] = s11
        out[9 * lane + 1] = s31
        out[9 * lane + 3] = A_x
        out[9 * lane + 6] = B_x
        out[9 * lane + 7] = r_y


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
    """28 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
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
        C_x = px - tx
        s15 = py - ty
        s28 = f0y*platform + f1y*payload_here
        s29 = f0x*platform + f1x*payload_here
        s32 = f0z*platform*s15 + f1z*payload_here*py
        s35 = -C_x*f0z*platform - f1z*payload_here*px
        s44 = payload_here*(-f1x*py + f1y*px) + platform*(C_x*f0y - f0x*s15)
        out[6 * lane + 0] = s29
        out[6 * lane + 1] = s28
        out[6 * lane + 3] = s32
        out[6 * lane + 4] = s35
        out[6 * lane + 5] = s44


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
    """2 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        C_x = px - tx
        s15 = py - ty
        out[6 * lane + 0] = C_x
        out[6 * lane + 1] = s15
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
