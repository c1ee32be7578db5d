"""Generalised loads of `simplified_parallelogram`: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both e2b99d8f71ab8e22; SymPy 1.14.0.

Plain NumPy over all poses at once. masses: proximal proximal_com distal_rod platform; payload (N,) in kg at the
reference point. Every weight has its own acceleration field [m/s^2]: gravity for all, or minus its own acceleration.
Loads in N (along lengths) and N mm (along angles).
"""

import numpy as np

LIMB_WEIGHTS = 3
PLATFORM_WEIGHTS = 2


def _limb(x, q, tool, p, masses, fields):
    """Generalised loads of the weights of one limb and their moment: (N, 7)."""
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


def _limb_points(x, q, tool, p, masses):
    """Where the weights of one limb are: (N, 9)."""
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


def _platform(x, tool, masses, payload, fields):
    """Generalised loads of the weights of one platform and their moment: (N, 6)."""
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


def _platform_points(x, tool, masses, payload):
    """Where the weights of one platform are: (N, 6)."""
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


def points(x, q, tool, p, masses, payload):
    """Return where the weights are, (N, 5, 3): limb by limb, then the platform's."""
    parts = [_limb_points(x, q[:, i], tool, p[:, i], masses) for i in range(1)]
    return np.hstack([*parts, _platform_points(x, tool, masses, payload)]).reshape(len(x), -1, 3)


def loads(x, q, tool, p, masses, payload, fields):
    """Return generalised loads W_q (N, 1) on the joints, W_x (N, 3) on the platform, and the moment about {O} (N, 3).

    fields (N, weights, 3): in the order of `points`.
    """
    flat = fields.reshape(len(x), -1)
    W_q = np.zeros((len(x), 1))
    rest = _platform(x, tool, masses, payload, flat[:, 9:])
    for i in range(1):
        own = _limb(x, q[:, i], tool, p[:, i], masses, flat[:, 9 * i :])
        W_q[:, i] = own[:, 0]
        rest += own[:, 1:]
    return W_q, rest[:, :3], rest[:, 3:]
