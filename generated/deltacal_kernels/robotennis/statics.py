"""Generalised loads of `robotennis`: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both 7b2be5512c413628; SymPy 1.14.0.

Plain NumPy over all poses at once. masses: proximal proximal_com distal_rod platform; payload (N,) in kg at the
reference point. Every weight has its own acceleration field [m/s^2]: gravity for all, or minus its own acceleration.
Loads in N (along lengths) and N mm (along angles).
"""

import numpy as np

LIMB_WEIGHTS = 3
PLATFORM_WEIGHTS = 2


def _limb(x, q, tool, p, masses, fields):
    """Generalised loads of the weights of one limb and their moment: (N, 7)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    q = q
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
    px0 = p[:, 12]
    py0 = p[:, 13]
    pz0 = p[:, 14]
    tip_v = p[:, 15]
    tip_w = p[:, 16]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    f2x = fields[:, 6]
    f2y = fields[:, 7]
    f2z = fields[:, 8]
    s0 = np.cos(phi)
    A_x = H*s0
    s2 = np.sin(phi)
    A_y = H*s2
    s4 = q + theta0
    s5 = np.cos(s4)
    arm_x = s0*s5
    arm_y = s2*s5
    arm_z = np.sin(s4)
    s9 = a + da
    B_x = A_x + arm_x*s9 - arm_z*s0*tip_v + s2*tip_w
    B_y = A_y + arm_y*s9 - arm_z*s2*tip_v - s0*tip_w
    B_z = arm_z*s9 + s5*tip_v
    centre_x = px + px0 - tx
    centre_y = py + py0 - ty
    centre_z = pz + pz0 - tz
    s24 = dh + h
    C_x = centre_x + s0*s24
    C_y = centre_y + s2*s24
    s43 = A_x + arm_x*proximal_com*s9
    s46 = A_y + arm_y*proximal_com*s9
    s48 = arm_z*proximal_com*s9
    s55 = proximal_com*s9
    s72 = distal_rod*f2z
    s74 = distal_rod*f2y
    s76 = distal_rod*f2x
    s78 = distal_rod*f1z
    s80 = distal_rod*f1y
    s82 = distal_rod*f1x
    s120 = s0*(f0x*proximal*s55 + s82*s9)
    s122 = -arm_z*(s120 + s2*(f0y*proximal*s55 + s80*s9) + s78*tip_v)
    s123 = s122 + s5*(f0z*proximal*s55 - s0*s82*tip_v - s2*s80*tip_v + s78*s9)
    s151 = proximal*(-f0y*s48 + f0z*s46)
    s152 = distal_rod*(B_y*f1z - B_z*f1y) + distal_rod*(C_y*f2z - centre_z*f2y) + s151
    s164 = proximal*(f0x*s48 - f0z*s43)
    s165 = distal_rod*(-B_x*f1z + B_z*f1x) + distal_rod*(-C_x*f2z + centre_z*f2x) + s164
    s177 = proximal*(-f0x*s46 + f0y*s43)
    s178 = distal_rod*(B_x*f1y - B_y*f1x) + distal_rod*(C_x*f2y - C_y*f2x) + s177
    out = np.zeros((len(x), 7))
    out[:, 0] = s123
    out[:, 1] = s76
    out[:, 2] = s74
    out[:, 3] = s72
    out[:, 4] = s152
    out[:, 5] = s165
    out[:, 6] = s178
    return out


def _limb_points(x, q, tool, p, masses):
    """Where the weights of one limb are: (N, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    q = q
    proximal_com = masses[1]
    a = p[:, 0]
    h = p[:, 2]
    H = p[:, 3]
    phi = p[:, 4]
    da = p[:, 8]
    dh = p[:, 10]
    theta0 = p[:, 11]
    px0 = p[:, 12]
    py0 = p[:, 13]
    pz0 = p[:, 14]
    tip_v = p[:, 15]
    tip_w = p[:, 16]
    s0 = np.cos(phi)
    A_x = H*s0
    s2 = np.sin(phi)
    A_y = H*s2
    s4 = q + theta0
    s5 = np.cos(s4)
    arm_x = s0*s5
    arm_y = s2*s5
    arm_z = np.sin(s4)
    s9 = a + da
    B_x = A_x + arm_x*s9 - arm_z*s0*tip_v + s2*tip_w
    B_y = A_y + arm_y*s9 - arm_z*s2*tip_v - s0*tip_w
    B_z = arm_z*s9 + s5*tip_v
    centre_x = px + px0 - tx
    centre_y = py + py0 - ty
    centre_z = pz + pz0 - tz
    s24 = dh + h
    C_x = centre_x + s0*s24
    C_y = centre_y + s2*s24
    s43 = A_x + arm_x*proximal_com*s9
    s46 = A_y + arm_y*proximal_com*s9
    s48 = arm_z*proximal_com*s9
    out = np.zeros((len(x), 9))
    out[:, 0] = s43
    out[:, 1] = s46
    out[:, 2] = s48
    out[:, 3] = B_x
    out[:, 4] = B_y
    out[:, 5] = B_z
    out[:, 6] = C_x
    out[:, 7] = C_y
    out[:, 8] = centre_z
    return out


def _platform(x, tool, masses, payload, fields):
    """Generalised loads of the weights of one platform and their moment: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    payload = payload
    platform = masses[3]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    s37 = px - tx
    s39 = py - ty
    s41 = pz - tz
    s58 = f0z*platform + f1z*payload
    s59 = f0y*platform + f1y*payload
    s60 = f0x*platform + f1x*payload
    s69 = payload*(-f1y*pz + f1z*py) + platform*(-f0y*s41 + f0z*s39)
    s78 = payload*(f1x*pz - f1z*px) + platform*(f0x*s41 - f0z*s37)
    s87 = payload*(-f1x*py + f1y*px) + platform*(-f0x*s39 + f0y*s37)
    out = np.zeros((len(x), 6))
    out[:, 0] = s60
    out[:, 1] = s59
    out[:, 2] = s58
    out[:, 3] = s69
    out[:, 4] = s78
    out[:, 5] = s87
    return out


def _platform_points(x, tool, masses, payload):
    """Where the weights of one platform are: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    tz = tool[:, 2]
    s37 = px - tx
    s39 = py - ty
    s41 = pz - tz
    out = np.zeros((len(x), 6))
    out[:, 0] = s37
    out[:, 1] = s39
    out[:, 2] = s41
    out[:, 3] = px
    out[:, 4] = py
    out[:, 5] = pz
    return out


def points(x, q, tool, p, masses, payload):
    """Return where the weights are, (N, 11, 3): limb by limb, then the platform's."""
    parts = [_limb_points(x, q[:, i], tool, p[:, i], masses) for i in range(3)]
    return np.hstack([*parts, _platform_points(x, tool, masses, payload)]).reshape(len(x), -1, 3)


def loads(x, q, tool, p, masses, payload, fields):
    """Return generalised loads W_q (N, 3) on the joints, W_x (N, 3) on the platform, and the moment about {O} (N, 3).

    fields (N, weights, 3): in the order of `points`.
    """
    flat = fields.reshape(len(x), -1)
    W_q = np.zeros((len(x), 3))
    rest = _platform(x, tool, masses, payload, flat[:, 27:])
    for i in range(3):
        own = _limb(x, q[:, i], tool, p[:, i], masses, flat[:, 9 * i :])
        W_q[:, i] = own[:, 0]
        rest += own[:, 1:]
    return W_q, rest[:, :3], rest[:, 3:]
