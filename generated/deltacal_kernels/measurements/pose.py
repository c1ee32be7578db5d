"""Position [mm] and rotation [rad] of a body on the platform in the instrument's frame.

Generated from derive/measurements/pose.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both 9190277c00850dd1; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: poses x (N, 12), position and rotation matrix, `given` (N, 21) the
instrument's state: F11 F12 F13 F21 F22 F23 F31 F32 F33 fx fy fz D11 D12 D13 D21 D22 D23 D31 D32 D33.
Unknowns are increments of that state: wx wy wz tx ty tz dx dy dz.
"""

import numpy as np

MEANING = "position [mm] and rotation [rad] of a body on the platform in the instrument's frame"
COLUMNS = ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg",)
TARGETS = {"reading.x": 0, "reading.y": 1, "reading.z": 2}
OVER_ROWS = ("reading", "rotation", "by_platform", "by_unknown", "stepped", )  # functions over rows, which Numba compiles, too
PLATFORMS = 1
UNKNOWN = (
    ("wx", "rad", 0.3, "turn of {O} about the instrument's axes"),
    ("wy", "rad", 0.3, "turn of {O} about the instrument's axes"),
    ("wz", "rad", 0.3, "turn of {O} about the instrument's axes"),
    ("tx", "mm", 1000.0, "shift of {O} along the instrument's axes"),
    ("ty", "mm", 1000.0, "shift of {O} along the instrument's axes"),
    ("tz", "mm", 1000.0, "shift of {O} along the instrument's axes"),
    ("dx", "rad", 1.0, "turn of the measured body about the axes of {O'}"),
    ("dy", "rad", 1.0, "turn of the measured body about the axes of {O'}"),
    ("dz", "rad", 1.0, "turn of the measured body about the axes of {O'}"),
)
STATE = 21
START = ()
SCALE = 1.0
ROWS = 6
ROTATION_ROWS = (3, 4, 5)


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
    s14 = F21*px + F22*py + F23*pz + fy
    s16 = F31*px + F32*py + F33*pz + fz
    out = np.zeros((len(x), 3))
    out[:, 0] = s3
    out[:, 1] = s14
    out[:, 2] = s16
    return out


def rotation(x, given):
    """Return the predicted rotation (N, 3, 3)."""
    R11 = x[:, 3]
    R12 = x[:, 4]
    R13 = x[:, 5]
    R21 = x[:, 6]
    R22 = x[:, 7]
    R23 = x[:, 8]
    R31 = x[:, 9]
    R32 = x[:, 10]
    R33 = x[:, 11]
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
    s21 = F11*R11 + F12*R21 + F13*R31
    s25 = F11*R12 + F12*R22 + F13*R32
    s29 = F11*R13 + F12*R23 + F13*R33
    s33 = F21*R11 + F22*R21 + F23*R31
    s37 = F21*R12 + F22*R22 + F23*R32
    s41 = F21*R13 + F22*R23 + F23*R33
    s45 = F31*R11 + F32*R21 + F33*R31
    s49 = F31*R12 + F32*R22 + F33*R32
    s53 = F31*R13 + F32*R23 + F33*R33
    s57 = D11*s21 + D21*s25 + D31*s29
    s61 = D12*s21 + D22*s25 + D32*s29
    s65 = D13*s21 + D23*s25 + D33*s29
    s69 = D11*s33 + D21*s37 + D31*s41
    s73 = D12*s33 + D22*s37 + D32*s41
    s77 = D13*s33 + D23*s37 + D33*s41
    s81 = D11*s45 + D21*s49 + D31*s53
    s85 = D12*s45 + D22*s49 + D32*s53
    s89 = D13*s45 + D23*s49 + D33*s53
    out = np.zeros((len(x), 9))
    out[:, 0] = s57
    out[:, 1] = s61
    out[:, 2] = s65
    out[:, 3] = s69
    out[:, 4] = s73
    out[:, 5] = s77
    out[:, 6] = s81
    out[:, 7] = s85
    out[:, 8] = s89
    return out.reshape(-1, 3, 3)


def by_platform(x, given):
    """Return the derivatives by shift and turn of the platforms in {O} (N, 6, 1, 6)."""
    F11 = given[:, 0]
    F12 = given[:, 1]
    F13 = given[:, 2]
    F21 = given[:, 3]
    F22 = given[:, 4]
    F23 = given[:, 5]
    F31 = given[:, 6]
    F32 = given[:, 7]
    F33 = given[:, 8]
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
    out[:, 21] = F11
    out[:, 22] = F12
    out[:, 23] = F13
    out[:, 27] = F21
    out[:, 28] = F22
    out[:, 29] = F23
    out[:, 33] = F31
    out[:, 34] = F32
    out[:, 35] = F33
    return out.reshape(-1, 6, 1, 6)


def by_unknown(x, given):
    """Return the derivatives by the instrument's unknowns (N, 6, 9)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    R11 = x[:, 3]
    R12 = x[:, 4]
    R13 = x[:, 5]
    R21 = x[:, 6]
    R22 = x[:, 7]
    R23 = x[:, 8]
    R31 = x[:, 9]
    R32 = x[:, 10]
    R33 = x[:, 11]
    F11 = given[:, 0]
    F12 = given[:, 1]
    F13 = given[:, 2]
    F21 = given[:, 3]
    F22 = given[:, 4]
    F23 = given[:, 5]
    F31 = given[:, 6]
    F32 = given[:, 7]
    F33 = given[:, 8]
    s9 = F31*px + F32*py + F33*pz
    s11 = F21*px + F22*py + F23*pz
    s12 = F11*px + F12*py + F13*pz
    s21 = F11*R11 + F12*R21 + F13*R31
    s25 = F11*R12 + F12*R22 + F13*R32
    s29 = F11*R13 + F12*R23 + F13*R33
    s33 = F21*R11 + F22*R21 + F23*R31
    s37 = F21*R12 + F22*R22 + F23*R32
    s41 = F21*R13 + F22*R23 + F23*R33
    s45 = F31*R11 + F32*R21 + F33*R31
    s49 = F31*R12 + F32*R22 + F33*R32
    s53 = F31*R13 + F32*R23 + F33*R33
    out = np.zeros((len(x), 54))
    out[:, 1] = s9
    out[:, 2] = -s11
    out[:, 3] = 1
    out[:, 9] = -s9
    out[:, 11] = s12
    out[:, 13] = 1
    out[:, 18] = s11
    out[:, 19] = -s12
    out[:, 23] = 1
    out[:, 27] = 1
    out[:, 33] = s21
    out[:, 34] = s25
    out[:, 35] = s29
    out[:, 37] = 1
    out[:, 42] = s33
    out[:, 43] = s37
    out[:, 44] = s41
    out[:, 47] = 1
    out[:, 51] = s45
    out[:, 52] = s49
    out[:, 53] = s53
    return out.reshape(-1, 6, 9)


def stepped(given, step):
    """Return the state (N, 21) after a step of the unknowns (N, 9)."""
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
    D11 = given[:, 12]
    D12 = given[:, 13]
    D13 = given[:, 14]
    D21 = given[:, 15]
    D22 = given[:, 16]
    D23 = given[:, 17]
    D31 = given[:, 18]
    D32 = given[:, 19]
    D33 = given[:, 20]
    wx = step[:, 0]
    wy = step[:, 1]
    wz = step[:, 2]
    tx = step[:, 3]
    ty = step[:, 4]
    tz = step[:, 5]
    dx = step[:, 6]
    dy = step[:, 7]
    dz = step[:, 8]
    s0 = (wx * wx)
    s2 = (wy * wy)
    s4 = (wz * wz)
    s7 = (1.0 / (0.25*s0 + 0.25*s2 + 0.25*s4 + 1))
    s8 = -0.5*s2
    s9 = -0.5*s4
    s12 = s7*(s8 + s9) + 1
    s14 = 0.5*wx*wy
    s15 = s14 - wz
    s17 = 0.5*wx*wz
    s18 = s17 + wy
    s20 = F11*s12 + F21*s15*s7 + F31*s18*s7
    s24 = F12*s12 + F22*s15*s7 + F32*s18*s7
    s28 = F13*s12 + F23*s15*s7 + F33*s18*s7
    s29 = -0.5*s0
    s32 = s7*(s29 + s9) + 1
    s34 = s14 + wz
    s36 = 0.5*wy*wz
    s37 = s36 - wx
    s39 = F11*s34*s7 + F21*s32 + F31*s37*s7
    s43 = F12*s34*s7 + F22*s32 + F32*s37*s7
    s47 = F13*s34*s7 + F23*s32 + F33*s37*s7
    s50 = s7*(s29 + s8) + 1
    s52 = s17 - wy
    s54 = s36 + wx
    s56 = F11*s52*s7 + F21*s54*s7 + F31*s50
    s60 = F12*s52*s7 + F22*s54*s7 + F32*s50
    s64 = F13*s52*s7 + F23*s54*s7 + F33*s50
    s65 = fx + tx
    s66 = fy + ty
    s67 = fz + tz
    s68 = (dx * dx)
    s70 = (dy * dy)
    s72 = (dz * dz)
    s75 = (1.0 / (0.25*s68 + 0.25*s70 + 0.25*s72 + 1))
    s76 = -0.5*s70
    s77 = -0.5*s72
    s80 = s75*(s76 + s77) + 1
    s82 = 0.5*dx*dy
    s83 = -dz + s82
    s85 = 0.5*dx*dz
    s86 = dy + s85
    s88 = D11*s80 + D21*s75*s83 + D31*s75*s86
    s92 = D12*s80 + D22*s75*s83 + D32*s75*s86
    s96 = D13*s80 + D23*s75*s83 + D33*s75*s86
    s97 = -0.5*s68
    s100 = s75*(s77 + s97) + 1
    s102 = dz + s82
    s104 = 0.5*dy*dz
    s105 = -dx + s104
    s107 = D11*s102*s75 + D21*s100 + D31*s105*s75
    s111 = D12*s102*s75 + D22*s100 + D32*s105*s75
    s115 = D13*s102*s75 + D23*s100 + D33*s105*s75
    s118 = s75*(s76 + s97) + 1
    s120 = -dy + s85
    s122 = dx + s104
    s124 = D11*s120*s75 + D21*s122*s75 + D31*s118
    s128 = D12*s120*s75 + D22*s122*s75 + D32*s118
    s132 = D13*s120*s75 + D23*s122*s75 + D33*s118
    out = np.zeros((len(given), 21))
    out[:, 0] = s20
    out[:, 1] = s24
    out[:, 2] = s28
    out[:, 3] = s39
    out[:, 4] = s43
    out[:, 5] = s47
    out[:, 6] = s56
    out[:, 7] = s60
    out[:, 8] = s64
    out[:, 9] = s65
    out[:, 10] = s66
    out[:, 11] = s67
    out[:, 12] = s88
    out[:, 13] = s92
    out[:, 14] = s96
    out[:, 15] = s107
    out[:, 16] = s111
    out[:, 17] = s115
    out[:, 18] = s124
    out[:, 19] = s128
    out[:, 20] = s132
    return out
