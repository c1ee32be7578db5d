"""Generalised loads of `planar_parallelogram`: Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/statics.py.jinja; sha256 of both 73e42d3667b64c5a; SymPy 1.14.0.

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
    cz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    proximal = masses[0]
    proximal_com = masses[1]
    distal_rod = masses[2]
    a1x = p[:, 0]
    a2x = p[:, 1]
    a2y = p[:, 2]
    b2x = p[:, 4]
    b2y = p[:, 5]
    l1 = p[:, 6]
    h = p[:, 8]
    q0 = p[:, 9]
    da1x = p[:, 10]
    da2x = p[:, 11]
    da2y = p[:, 12]
    db2x = p[:, 14]
    db2y = p[:, 15]
    dl1 = p[:, 16]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
    f2x = fields[:, 6]
    f2y = fields[:, 7]
    f2z = fields[:, 8]
    A1_x = -a1x - da1x
    A2_x = a2x + da2x
    A2_y = a2y + da2y
    C_y = -h + ty
    b2_x = b2x + db2x
    b2_y = b2y + db2y
    s7 = dl1 + l1
    s8 = q + q0
    s9 = np.sin(s8)
    r1_x = s7*s9
    s11 = np.cos(s8)
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
    out = np.zeros((len(x), 7))
    out[:, 0] = s107
    out[:, 1] = s58
    out[:, 2] = s56
    out[:, 3] = s111
    out[:, 4] = s115
    out[:, 5] = s119
    out[:, 6] = s132
    return out


def limb_points(x, q, tool, p, masses):
    """Return where the weights of one limb are: (N, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    cz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    proximal_com = masses[1]
    a1x = p[:, 0]
    a2x = p[:, 1]
    a2y = p[:, 2]
    b2x = p[:, 4]
    b2y = p[:, 5]
    l1 = p[:, 6]
    h = p[:, 8]
    q0 = p[:, 9]
    da1x = p[:, 10]
    da2x = p[:, 11]
    da2y = p[:, 12]
    db2x = p[:, 14]
    db2y = p[:, 15]
    dl1 = p[:, 16]
    A1_x = -a1x - da1x
    A2_x = a2x + da2x
    A2_y = a2y + da2y
    C_y = -h + ty
    b2_x = b2x + db2x
    b2_y = b2y + db2y
    s7 = dl1 + l1
    s8 = q + q0
    r1_x = s7*np.sin(s8)
    r1_y = -s7*np.cos(s8)
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
    out = np.zeros((len(x), 9))
    out[:, 0] = s40
    out[:, 1] = s65
    out[:, 3] = A2_x
    out[:, 4] = A2_y
    out[:, 6] = B2_x
    out[:, 7] = B2_y
    return out


def platform(x, tool, masses, payload, fields):
    """Return generalised loads of the weights of one platform and their moment: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    cz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    platform = masses[3]
    f0x = fields[:, 0]
    f0y = fields[:, 1]
    f0z = fields[:, 2]
    f1x = fields[:, 3]
    f1y = fields[:, 4]
    f1z = fields[:, 5]
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
    s86 = f1y*payload + s55
    s89 = f1x*payload + s61
    s90 = 2*cz*(-0.5*s16*s74 + s82) + s16*s58 - s16*s62
    s93 = f0z*platform*s49 + f1z*payload*py
    s96 = -f0z*platform*s45 - f1z*payload*px
    s105 = payload*(-f1x*py + f1y*px) + platform*(-f0x*s49 + f0y*s45)
    out = np.zeros((len(x), 6))
    out[:, 0] = s89
    out[:, 1] = s86
    out[:, 2] = s90
    out[:, 3] = s93
    out[:, 4] = s96
    out[:, 5] = s105
    return out


def platform_points(x, tool, masses, payload):
    """Return where the weights of one platform are: (N, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    cz = x[:, 2]
    tx = tool[:, 0]
    ty = tool[:, 1]
    s13 = (cz * cz)
    s16 = (1.0 / (0.25*s13 + 1))
    s17 = -0.5*s13*s16
    R_11 = s17 + 1
    R_12 = -cz*s16
    R_21 = cz*s16
    R_22 = s17 + 1
    s45 = -R_11*tx - R_12*ty + px
    s49 = -R_21*tx - R_22*ty + py
    out = np.zeros((len(x), 6))
    out[:, 0] = s45
    out[:, 1] = s49
    out[:, 3] = px
    out[:, 4] = py
    return out
