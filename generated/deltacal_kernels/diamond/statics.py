"""Generalised loads of `diamond`: Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both f33b86fa2ec85999; SymPy 1.14.0.

Plain NumPy over all poses at once. masses: proximal proximal_com distal_rod platform; payload (N,) in kg at the
reference point. Every weight has its own acceleration field [m/s^2], fields (N, 3 weights): gravity for all, or minus
its own acceleration. Loads in N (along lengths) and N mm (along angles): on the joint, of a limb; on the
2 coordinates of the platform; the moment about {O}.
"""

import numpy as np

LIMB_WEIGHTS = 3
PLATFORM_WEIGHTS = 2
OVER_ROWS = ("limb", "limb_points", "platform", "platform_points", )  # functions over rows, which Numba compiles, too


def limb(x, q, tool, p, masses, fields):
    """Return generalised loads of the weights of one limb and their moment: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    tx = tool[:, 0]
    ty = tool[:, 1]
    proximal = masses[0]
    proximal_com = masses[1]
    distal_rod = masses[2]
    base_x = p[:, 0]
    base_y = p[:, 1]
    L = p[:, 2]
    side = p[:, 4]
    theta = p[:, 5]
    ex = p[:, 6]
    ey = p[:, 7]
    dL = p[:, 8]
    tip_v = p[:, 12]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    f2x = fields[:, 6]
    f2y = fields[:, 7]
    f2z = fields[:, 8]
    B_x = base_x*side + ex
    B_y = base_y + ey
    s3 = L + dL
    s6 = q + theta - 0.5*np.pi*(1 - side)
    s7 = np.cos(s6)
    s9 = np.sin(s6)
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
    out = np.zeros((len(x), 6))
    out[:, 0] = s88
    out[:, 1] = s45
    out[:, 2] = s43
    out[:, 3] = s102
    out[:, 4] = s106
    out[:, 5] = s119
    return out


def limb_points(x, q, tool, p, masses):
    """Return where the weights of one limb are: (N, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    tx = tool[:, 0]
    ty = tool[:, 1]
    proximal_com = masses[1]
    base_x = p[:, 0]
    base_y = p[:, 1]
    L = p[:, 2]
    side = p[:, 4]
    theta = p[:, 5]
    ex = p[:, 6]
    ey = p[:, 7]
    dL = p[:, 8]
    tip_v = p[:, 12]
    B_x = base_x*side + ex
    B_y = base_y + ey
    s3 = L + dL
    s6 = q + theta - 0.5*np.pi*(1 - side)
    s7 = np.cos(s6)
    s9 = np.sin(s6)
    C_x = B_x + s3*s7*side - s9*side*tip_v
    C_y = B_y + s3*s9*side + s7*side*tip_v
    A_x = px - tx
    A_y = py - ty
    s20 = B_x + proximal_com*s3*s7*side
    s23 = B_y + proximal_com*s3*s9*side
    out = np.zeros((len(x), 9))
    out[:, 0] = s20
    out[:, 1] = s23
    out[:, 3] = C_x
    out[:, 4] = C_y
    out[:, 6] = A_x
    out[:, 7] = A_y
    return out


def platform(x, tool, masses, payload, fields):
    """Return generalised loads of the weights of one platform and their moment: (N, 5)."""
    px = x[:, 0]
    py = x[:, 1]
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
    A_x = px - tx
    A_y = py - ty
    s39 = f0y*platform + f1y*payload
    s40 = f0x*platform + f1x*payload
    s46 = f1z*payload*py + platform*(A_y*f0z + f0y*tz)
    s52 = -f1z*payload*px + platform*(-A_x*f0z - f0x*tz)
    s61 = payload*(-f1x*py + f1y*px) + platform*(A_x*f0y - A_y*f0x)
    out = np.zeros((len(x), 5))
    out[:, 0] = s40
    out[:, 1] = s39
    out[:, 2] = s46
    out[:, 3] = s52
    out[:, 4] = s61
    return out


def platform_points(x, tool, masses, payload):
    """Return where the weights of one platform are: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    A_x = px - tx
    A_y = py - ty
    out = np.zeros((len(x), 6))
    out[:, 0] = A_x
    out[:, 1] = A_y
    out[:, 2] = -tz
    out[:, 3] = px
    out[:, 4] = py
    return out
