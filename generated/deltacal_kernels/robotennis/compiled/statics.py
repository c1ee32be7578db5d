"""Generalised loads of `robotennis`: RoboTennis, three arms with rods as single links, incremental home, row by row for Numba.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 3f7d5af55634c0cb; SymPy 1.14.0.

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
    """126 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        q_here = q[q_every * lane]
        proximal = masses[0]
        proximal_com = masses[1]
        distal_rod = masses[2]
        a = p[p_every * lane + 0]
        h = p[p_every * lane + 2]
        H = p[p_every * lane + 3]
        phi = p[p_every * lane + 4]
        da = p[p_every * lane + 8]
        dh = p[p_every * lane + 10]
        theta0 = p[p_every * lane + 11]
        dphi = p[p_every * lane + 12]
        dH = p[p_every * lane + 13]
        px0 = p[p_every * lane + 14]
        py0 = p[p_every * lane + 15]
        pz0 = p[p_every * lane + 16]
        tip_v = p[p_every * lane + 17]
        tip_w = p[p_every * lane + 18]
        f0x = fields[fields_every * lane + 0]
        f0y = fields[fields_every * lane + 1]
        f0z = fields[fields_every * lane + 2]
        f1x = fields[fields_every * lane + 3]
        f1y = fields[fields_every * lane + 4]
        f1z = fields[fields_every * lane + 5]
        f2x = fields[fields_every * lane + 6]
        f2y = fields[fields_every * lane + 7]
        f2z = fields[fields_every * lane + 8]
        s0 = dphi + phi
        u_x = cosine(s0)
        u_y = sine(s0)
        s3 = H + dH
        A_x = s3*u_x
        A_y = s3*u_y
        s6 = q_here + theta0
        s7 = cosine(s6)
        arm_x = s7*u_x
        arm_y = s7*u_y
        arm_z = sine(s6)
        s11 = a + da
        B_x = A_x + arm_x*s11 - arm_z*tip_v*u_x + tip_w*u_y
        B_y = A_y + arm_y*s11 - arm_z*tip_v*u_y - tip_w*u_x
        B_z = arm_z*s11 + s7*tip_v
        centre_x = px + px0 - tx
        centre_y = py + py0 - ty
        centre_z = pz + pz0 - tz
        s26 = dh + h
        C_x = centre_x + s26*u_x
        C_y = centre_y + s26*u_y
        s45 = A_x + arm_x*proximal_com*s11
        s48 = A_y + arm_y*proximal_com*s11
        s64 = proximal_com*s11
        s75 = distal_rod*f2z
        s77 = distal_rod*f2y
        s79 = distal_rod*f2x
        s81 = distal_rod*f1z
        s83 = distal_rod*f1y
        s85 = distal_rod*f1x
        s117 = s7*(f0z*proximal*proximal_com*s11 + s11*s81 - s83*tip_v*u_y - s85*tip_v*u_x)
        s122 = u_x*(f0x*proximal*s64 + s11*s85)
        s126 = -arm_z*(s122 + s81*tip_v + u_y*(f0y*proximal*s64 + s11*s83)) + s117
        s154 = proximal*(-arm_z*f0y*proximal_com*s11 + f0z*s48)
        s155 = distal_rod*(B_y*f1z - B_z*f1y) + distal_rod*(C_y*f2z - centre_z*f2y) + s154
        s167 = proximal*(arm_z*f0x*proximal_com*s11 - f0z*s45)
        s168 = distal_rod*(-B_x*f1z + B_z*f1x) + distal_rod*(-C_x*f2z + centre_z*f2x) + s167
        s180 = proximal*(-f0x*s48 + f0y*s45)
        s181 = distal_rod*(B_x*f1y - B_y*f1x) + distal_rod*(C_x*f2y - C_y*f2x) + s180
        out[7 * lane + 0] = s126
        out[7 * lane + 1] = s79
        out[7 * lane + 2] = s77
        out[7 * lane + 3] = s75
        out[7 * lane + 4] = s155
        out[7 * lane + 5] = s168
        out[7 * lane + 6] = s181


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
    """48 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        q_here = q[q_every * lane]
        proximal_com = masses[1]
        a = p[p_every * lane + 0]
        h = p[p_every * lane + 2]
        H = p[p_every * lane + 3]
        phi = p[p_every * lane + 4]
        da = p[p_every * lane + 8]
        dh = p[p_every * lane + 10]
        theta0 = p[p_every * lane + 11]
        dphi = p[p_every * lane + 12]
        dH = p[p_every * lane + 13]
        px0 = p[p_every * lane + 14]
        py0 = p[p_every * lane + 15]
        pz0 = p[p_every * lane + 16]
        tip_v = p[p_every * lane + 17]
        tip_w = p[p_every * lane + 18]
        s0 = dphi + phi
        u_x = cosine(s0)
        u_y = sine(s0)
        s3 = H + dH
        A_x = s3*u_x
        A_y = s3*u_y
        s6 = q_here + theta0
        s7 = cosine(s6)
        arm_x = s7*u_x
        arm_y = s7*u_y
        arm_z = sine(s6)
        s11 = a + da
        B_x = A_x + arm_x*s11 - arm_z*tip_v*u_x + tip_w*u_y
        B_y = A_y + arm_y*s11 - arm_z*tip_v*u_y - tip_w*u_x
        B_z = arm_z*s11 + s7*tip_v
        centre_x = px + px0 - tx
        centre_y = py + py0 - ty
        centre_z = pz + pz0 - tz
        s26 = dh + h
        C_x = centre_x + s26*u_x
        C_y = centre_y + s26*u_y
        s45 = A_x + arm_x*proximal_com*s11
        s48 = A_y + arm_y*proximal_com*s11
        s55 = arm_z*proximal_com*s11
        out[9 * lane + 0] = s45
        out[9 * lane + 1] = s48
        out[9 * lane + 2] = s55
        out[9 * lane + 3] = B_x
        out[9 * lane + 4] = B_y
        out[9 * lane + 5] = B_z
        out[9 * lane + 6] = C_x
        out[9 * lane + 7] = C_y
        out[9 * lane + 8] = centre_z


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
    """39 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
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
        s39 = px - tx
        s41 = py - ty
        s43 = pz - tz
        s60 = f0z*platform + f1z*payload_here
        s61 = f0y*platform + f1y*payload_here
        s62 = f0x*platform + f1x*payload_here
        s71 = payload_here*(-f1y*pz + f1z*py) + platform*(-f0y*s43 + f0z*s41)
        s80 = payload_here*(f1x*pz - f1z*px) + platform*(f0x*s43 - f0z*s39)
        s89 = payload_here*(-f1x*py + f1y*px) + platform*(-f0x*s41 + f0y*s39)
        out[6 * lane + 0] = s62
        out[6 * lane + 1] = s61
        out[6 * lane + 2] = s60
        out[6 * lane + 3] = s71
        out[6 * lane + 4] = s80
        out[6 * lane + 5] = s89


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
    """3 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        tx = tool[tool_every * lane + 0]
        ty = tool[tool_every * lane + 1]
        tz = tool[tool_every * lane + 2]
        s39 = px - tx
        s41 = py - ty
        s43 = pz - tz
        out[6 * lane + 0] = s39
        out[6 * lane + 1] = s41
        out[6 * lane + 2] = s43
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
