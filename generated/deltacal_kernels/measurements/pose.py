"""Position [mm] and rotation [rad] of a body on the platform in the instrument's frame.

Generated from derive/measurements/pose.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both 9819e27cd678d235; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: platform coordinates (N, 6), `given` (N, 21) the
instrument's state: F11 F12 F13 F21 F22 F23 F31 F32 F33 fx fy fz D11 D12 D13 D21 D22 D23 D31 D32 D33.
Unknowns are increments of that state: wx wy wz tx ty tz dx dy dz.
"""

import numpy as np

UNKNOWN = (
    ("wx", "rad", "turn of {O} about the instrument's axes"),
    ("wy", "rad", "turn of {O} about the instrument's axes"),
    ("wz", "rad", "turn of {O} about the instrument's axes"),
    ("tx", "mm", "shift of {O} along the instrument's axes"),
    ("ty", "mm", "shift of {O} along the instrument's axes"),
    ("tz", "mm", "shift of {O} along the instrument's axes"),
    ("dx", "rad", "turn of the measured body about the axes of {O'}"),
    ("dy", "rad", "turn of the measured body about the axes of {O'}"),
    ("dz", "rad", "turn of the measured body about the axes of {O'}"),
)
ROWS = 6


def reading(x, given):
    """Return the predicted reading (N, 3)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    F11 = given[:, 0]
    F12 = given[:, 1]
    F13 = given[:, 2]
    F21 = given[:, 3]
    F22 = given[:, 4]
    F23 = given[:, 5]
    F31 = given[:, 6]
    F32 = given[:, 7]
    F33 = given[:, 8]
    fx = given[:, 9]
    fy = given[:, 10]
    fz = given[:, 11]
    s3 = F11*px + F12*py + F13*pz + fx
    s7 = F21*px + F22*py + F23*pz + fy
    s11 = F31*px + F32*py + F33*pz + fz
    out = np.zeros((len(x), 3))
    out[:, 0] = s3
    out[:, 1] = s7
    out[:, 2] = s11
    return out


def rotation(x, given):
    """Return the predicted rotation (N, 3, 3)."""
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    F11 = given[:, 0]
    F12 = given[:, 1]
    F13 = given[:, 2]
    F21 = given[:, 3]
    F22 = given[:, 4]
    F23 = given[:, 5]
    F31 = given[:, 6]
    F32 = given[:, 7]
    F33 = given[:, 8]
    D11 = given[:, 12]
    D12 = given[:, 13]
    D13 = given[:, 14]
    D21 = given[:, 15]
    D22 = given[:, 16]
    D23 = given[:, 17]
    D31 = given[:, 18]
    D32 = given[:, 19]
    D33 = given[:, 20]
    s12 = (cx * cx)
    s13 = (cy * cy)
    s14 = (cz * cz)
    s60 = (1.0 / (0.25*s12 + 0.25*s13 + 0.25*s14 + 1))
    s61 = -0.5*s13
    s62 = -0.5*s14
    s65 = s60*(s61 + s62) + 1
    s67 = 0.5*cx*cy
    s68 = cz + s67
    s70 = 0.5*cx*cz
    s71 = -cy + s70
    s73 = F11*s65 + F12*s60*s68 + F13*s60*s71
    s74 = -0.5*s12
    s77 = s60*(s62 + s74) + 1
    s79 = -cz + s67
    s81 = 0.5*cy*cz
    s82 = cx + s81
    s84 = F11*s60*s79 + F12*s77 + F13*s60*s82
    s87 = s60*(s61 + s74) + 1
    s89 = cy + s70
    s91 = -cx + s81
    s93 = F11*s60*s89 + F12*s60*s91 + F13*s87
    s97 = F21*s65 + F22*s60*s68 + F23*s60*s71
    s101 = F21*s60*s79 + F22*s77 + F23*s60*s82
    s105 = F21*s60*s89 + F22*s60*s91 + F23*s87
    s109 = F31*s65 + F32*s60*s68 + F33*s60*s71
    s113 = F31*s60*s79 + F32*s77 + F33*s60*s82
    s117 = F31*s60*s89 + F32*s60*s91 + F33*s87
    s121 = D11*s73 + D21*s84 + D31*s93
    s125 = D12*s73 + D22*s84 + D32*s93
    s129 = D13*s73 + D23*s84 + D33*s93
    s133 = D11*s97 + D21*s101 + D31*s105
    s137 = D12*s97 + D22*s101 + D32*s105
    s141 = D13*s97 + D23*s101 + D33*s105
    s145 = D11*s109 + D21*s113 + D31*s117
    s149 = D12*s109 + D22*s113 + D32*s117
    s153 = D13*s109 + D23*s113 + D33*s117
    out = np.zeros((len(x), 9))
    out[:, 0] = s121
    out[:, 1] = s125
    out[:, 2] = s129
    out[:, 3] = s133
    out[:, 4] = s137
    out[:, 5] = s141
    out[:, 6] = s145
    out[:, 7] = s149
    out[:, 8] = s153
    return out.reshape(-1, 3, 3)


def by_platform(x, given):
    """Return the derivatives by the platforms' coordinates (N, 6, 1, 6)."""
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    F11 = given[:, 0]
    F12 = given[:, 1]
    F13 = given[:, 2]
    F21 = given[:, 3]
    F22 = given[:, 4]
    F23 = given[:, 5]
    F31 = given[:, 6]
    F32 = given[:, 7]
    F33 = given[:, 8]
    s16 = (1.0 / ((cx * cx) + (cy * cy) + (cz * cz) + 4))
    s20 = 4*F11*s16 + 2*F12*cz*s16 - 2*F13*cy*s16
    s24 = -2*F11*cz*s16 + 4*F12*s16 + 2*F13*cx*s16
    s28 = 2*F11*cy*s16 - 2*F12*cx*s16 + 4*F13*s16
    s32 = 4*F21*s16 + 2*F22*cz*s16 - 2*F23*cy*s16
    s36 = -2*F21*cz*s16 + 4*F22*s16 + 2*F23*cx*s16
    s40 = 2*F21*cy*s16 - 2*F22*cx*s16 + 4*F23*s16
    s44 = 4*F31*s16 + 2*F32*cz*s16 - 2*F33*cy*s16
    s48 = -2*F31*cz*s16 + 4*F32*s16 + 2*F33*cx*s16
    s52 = 2*F31*cy*s16 - 2*F32*cx*s16 + 4*F33*s16
    out = np.zeros((len(x), 36))
    out[:, 0] = F11
    out[:, 1] = F12
    out[:, 2] = F13
    out[:, 6] = F21
    out[:, 7] = F22
    out[:, 8] = F23
    out[:, 12] = F31
    out[:, 13] = F32
    out[:, 14] = F33
    out[:, 21] = s20
    out[:, 22] = s24
    out[:, 23] = s28
    out[:, 27] = s32
    out[:, 28] = s36
    out[:, 29] = s40
    out[:, 33] = s44
    out[:, 34] = s48
    out[:, 35] = s52
    return out.reshape(-1, 6, 1, 6)


def by_unknown(x, given):
    """Return the derivatives by the instrument's unknowns (N, 6, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    cx = x[:, 3]
    cy = x[:, 4]
    cz = x[:, 5]
    F11 = given[:, 0]
    F12 = given[:, 1]
    F13 = given[:, 2]
    F21 = given[:, 3]
    F22 = given[:, 4]
    F23 = given[:, 5]
    F31 = given[:, 6]
    F32 = given[:, 7]
    F33 = given[:, 8]
    s12 = (cx * cx)
    s13 = (cy * cy)
    s14 = (cz * cz)
    s53 = F31*px + F32*py + F33*pz
    s54 = -F21*px - F22*py - F23*pz
    s55 = F11*px + F12*py + F13*pz
    s60 = (1.0 / (0.25*s12 + 0.25*s13 + 0.25*s14 + 1))
    s61 = -0.5*s13
    s62 = -0.5*s14
    s65 = s60*(s61 + s62) + 1
    s67 = 0.5*cx*cy
    s68 = cz + s67
    s70 = 0.5*cx*cz
    s71 = -cy + s70
    s73 = F11*s65 + F12*s60*s68 + F13*s60*s71
    s74 = -0.5*s12
    s77 = s60*(s62 + s74) + 1
    s79 = -cz + s67
    s81 = 0.5*cy*cz
    s82 = cx + s81
    s84 = F11*s60*s79 + F12*s77 + F13*s60*s82
    s87 = s60*(s61 + s74) + 1
    s89 = cy + s70
    s91 = -cx + s81
    s93 = F11*s60*s89 + F12*s60*s91 + F13*s87
    s97 = F21*s65 + F22*s60*s68 + F23*s60*s71
    s101 = F21*s60*s79 + F22*s77 + F23*s60*s82
    s105 = F21*s60*s89 + F22*s60*s91 + F23*s87
    s109 = F31*s65 + F32*s60*s68 + F33*s60*s71
    s113 = F31*s60*s79 + F32*s77 + F33*s60*s82
    s117 = F31*s60*s89 + F32*s60*s91 + F33*s87
    out = np.zeros((len(x), 54))
    out[:, 1] = s53
    out[:, 2] = s54
    out[:, 3] = 1
    out[:, 9] = -s53
    out[:, 11] = s55
    out[:, 13] = 1
    out[:, 18] = -s54
    out[:, 19] = -s55
    out[:, 23] = 1
    out[:, 27] = 1
    out[:, 33] = s73
    out[:, 34] = s84
    out[:, 35] = s93
    out[:, 37] = 1
    out[:, 42] = s97
    out[:, 43] = s101
    out[:, 44] = s105
    out[:, 47] = 1
    out[:, 51] = s109
    out[:, 52] = s113
    out[:, 53] = s117
    return out.reshape(-1, 6, 9)
