"""Generalised loads of `simplified_parallelogram`: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both a1a519b044577847; SymPy 1.14.0.

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
    proximal = masses[0]
    proximal_com = masses[1]
    distal_rod = masses[2]
    a1x = p[:, 0]
    b1x = p[:, 3]
    l1 = p[:, 6]
    q0 = p[:, 9]
    dl1 = p[:, 10]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    f2x = fields[:, 6]
    f2y = fields[:, 7]
    f2z = fields[:, 8]
    A_x = -a1x + b1x
    s1 = dl1 + l1
    s2 = q + q0
    s3 = np.sin(s2)
    r_x = s1*s3
    s5 = np.cos(s2)
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
    out = np.zeros((len(x), 7))
    out[:, 0] = s49
    out[:, 4] = s56
    out[:, 5] = s60
    out[:, 6] = s70
    return out


def limb_points(x, q, tool, p, masses):
    """Return where the weights of one limb are: (N, 9)."""
    proximal_com = masses[1]
    a1x = p[:, 0]
    b1x = p[:, 3]
    l1 = p[:, 6]
    q0 = p[:, 9]
    dl1 = p[:, 10]
    A_x = -a1x + b1x
    s1 = dl1 + l1
    s2 = q + q0
    r_x = s1*np.sin(s2)
    r_y = -s1*np.cos(s2)
    B_x = A_x + r_x
    s11 = A_x + proximal_com*r_x
    s31 = proximal_com*r_y
    out = np.zeros((len(x), 9))
    out[:, 0] = s11
    out[:, 1] = s31
    out[:, 3] = A_x
    out[:, 6] = B_x
    out[:, 7] = r_y
    return out


def platform(x, tool, masses, payload, fields):
    """Return generalised loads of the weights of one platform and their moment: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    tx = tool[:, 0]
    ty = tool[:, 1]
    platform = masses[3]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    C_x = px - tx
    s15 = py - ty
    s28 = f0y*platform + f1y*payload
    s29 = f0x*platform + f1x*payload
    s32 = f0z*platform*s15 + f1z*payload*py
    s35 = -C_x*f0z*platform - f1z*payload*px
    s44 = payload*(-f1x*py + f1y*px) + platform*(C_x*f0y - f0x*s15)
    out = np.zeros((len(x), 6))
    out[:, 0] = s29
    out[:, 1] = s28
    out[:, 3] = s32
    out[:, 4] = s35
    out[:, 5] = s44
    return out


def platform_points(x, tool, masses, payload):
    """Return where the weights of one platform are: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    tx = tool[:, 0]
    ty = tool[:, 1]
    C_x = px - tx
    s15 = py - ty
    out = np.zeros((len(x), 6))
    out[:, 0] = C_x
    out[:, 1] = s15
    out[:, 3] = px
    out[:, 4] = py
    return out
