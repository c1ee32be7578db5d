"""Generalised loads of `robotennis`: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both b3dd5d8749d724f4; SymPy 1.14.0.

Plain NumPy over all poses at once. masses: proximal proximal_com distal_rod platform; payload (N,) in kg at the
reference point. Every weight has its own acceleration field [m/s^2], fields (N, 3 weights): gravity for all, or minus
its own acceleration. Loads in N (along lengths) and N mm (along angles): on the joint, of a limb; on the
3 coordinates of the platform; the moment about {O}.
"""

import numpy as np

LIMB_WEIGHTS = 3
PLATFORM_WEIGHTS = 2
OVER_ROWS = ("limb", "limb_points", "platform", "platform_points", )  # functions over rows, which Numba compiles, too


def limb(x, q, tool, p, masses, fields):
    """Return generalised loads of the weights of one limb and their moment: (N, 7)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    proximal = masses[0]
    proximal_com = masses[1]
    distal_rod = masses[2]
    a = p[:, 0]
    h = p[:, 2]
    H = p[:, 3]
    phi = p[:, 4]
    da = p[:, 8]
    dh = p[:, 10]
    theta0 = p[:, 11]
    dphi = p[:, 12]
    dH = p[:, 13]
    px0 = p[:, 14]
    py0 = p[:, 15]
    pz0 = p[:, 16]
    tip_v = p[:, 17]
    tip_w = p[:, 18]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    f2x = fields[:, 6]
    f2y = fields[:, 7]
    f2z = fields[:, 8]
    s0 = dphi + phi
    u_x = np.cos(s0)
    u_y = np.sin(s0)
    s3 = H + dH
    A_x = s3*u_x
    A_y = s3*u_y
    s6 = q + theta0
    s7 = np.cos(s6)
    arm_x = s7*u_x
    arm_y = s7*u_y
    arm_z = np.sin(s6)
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
    out = np.zeros((len(x), 7))
    out[:, 0] = s126
    out[:, 1] = s79
    out[:, 2] = s77
    out[:, 3] = s75
    out[:, 4] = s155
    out[:, 5] = s168
    out[:, 6] = s181
    return out


def limb_points(x, q, tool, p, masses):
    """Return where the weights of one limb are: (N, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    proximal_com = masses[1]
    a = p[:, 0]
    h = p[:, 2]
    H = p[:, 3]
    phi = p[:, 4]
    da = p[:, 8]
    dh = p[:, 10]
    theta0 = p[:, 11]
    dphi = p[:, 12]
    dH = p[:, 13]
    px0 = p[:, 14]
    py0 = p[:, 15]
    pz0 = p[:, 16]
    tip_v = p[:, 17]
    tip_w = p[:, 18]
    s0 = dphi + phi
    u_x = np.cos(s0)
    u_y = np.sin(s0)
    s3 = H + dH
    A_x = s3*u_x
    A_y = s3*u_y
    s6 = q + theta0
    s7 = np.cos(s6)
    arm_x = s7*u_x
    arm_y = s7*u_y
    arm_z = np.sin(s6)
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
    out = np.zeros((len(x), 9))
    out[:, 0] = s45
    out[:, 1] = s48
    out[:, 2] = s55
    out[:, 3] = B_x
    out[:, 4] = B_y
    out[:, 5] = B_z
    out[:, 6] = C_x
    out[:, 7] = C_y
    out[:, 8] = centre_z
    return out


def platform(x, tool, masses, payload, fields):
    """Return generalised loads of the weights of one platform and their moment: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    platform = masses[3]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    s39 = px - tx
    s41 = py - ty
    s43 = pz - tz
    s60 = f0z*platform + f1z*payload
    s61 = f0y*platform + f1y*payload
    s62 = f0x*platform + f1x*payload
    s71 = payload*(-f1y*pz + f1z*py) + platform*(-f0y*s43 + f0z*s41)
    s80 = payload*(f1x*pz - f1z*px) + platform*(f0x*s43 - f0z*s39)
    s89 = payload*(-f1x*py + f1y*px) + platform*(-f0x*s41 + f0y*s39)
    out = np.zeros((len(x), 6))
    out[:, 0] = s62
    out[:, 1] = s61
    out[:, 2] = s60
    out[:, 3] = s71
    out[:, 4] = s80
    out[:, 5] = s89
    return out


def platform_points(x, tool, masses, payload):
    """Return where the weights of one platform are: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    s39 = px - tx
    s41 = py - ty
    s43 = pz - tz
    out = np.zeros((len(x), 6))
    out[:, 0] = s39
    out[:, 1] = s41
    out[:, 2] = s43
    out[:, 3] = px
    out[:, 4] = py
    out[:, 5] = pz
    return out
