"""Position of the reference point in the instrument's frame [mm].

Generated from derive/measurements/position.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both d0c451bde062153a; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: poses x (N, 12), position and rotation matrix, `given` (N, 12) the
instrument's state: F11 F12 F13 F21 F22 F23 F31 F32 F33 fx fy fz.
Unknowns are increments of that state: wx wy wz tx ty tz.
"""

import numpy as np

MEANING = "position of the reference point in the instrument's frame [mm]"
COLUMNS = ("x_mm", "y_mm", "z_mm",)
TARGETS = {"reading.x": 0, "reading.y": 1, "reading.z": 2}
OVER_ROWS = ("reading", "by_platform", "by_unknown", "stepped", )  # functions over rows, which Numba compiles, too
PLATFORMS = 1
UNKNOWN = (
    ("wx", "rad", 0.3, "turn of {O} about the instrument's axes"),
    ("wy", "rad", 0.3, "turn of {O} about the instrument's axes"),
    ("wz", "rad", 0.3, "turn of {O} about the instrument's axes"),
    ("tx", "mm", 1000.0, "shift of {O} along the instrument's axes"),
    ("ty", "mm", 1000.0, "shift of {O} along the instrument's axes"),
    ("tz", "mm", 1000.0, "shift of {O} along the instrument's axes"),
)
STATE = 12
START = ()
SCALE = 1.0
ROWS = 3
ROTATION_ROWS = ()


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


def by_platform(x, given):
    """Return the derivatives by shift and turn of the platforms in {O} (N, 3, 1, 6)."""
    F11 = given[:, 0]
    F12 = given[:, 1]
    F13 = given[:, 2]
    F21 = given[:, 3]
    F22 = given[:, 4]
    F23 = given[:, 5]
    F31 = given[:, 6]
    F32 = given[:, 7]
    F33 = given[:, 8]
    out = np.zeros((len(x), 18))
    out[:, 0] = F11
    out[:, 1] = F12
    out[:, 2] = F13
    out[:, 6] = F21
    out[:, 7] = F22
    out[:, 8] = F23
    out[:, 12] = F31
    out[:, 13] = F32
    out[:, 14] = F33
    return out.reshape(-1, 3, 1, 6)


def by_unknown(x, given):
    """Return the derivatives by the instrument's unknowns (N, 3, 6)."""
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
    s9 = F31*px + F32*py + F33*pz
    s11 = F21*px + F22*py + F23*pz
    s12 = F11*px + F12*py + F13*pz
    out = np.zeros((len(x), 18))
    out[:, 1] = s9
    out[:, 2] = -s11
    out[:, 3] = 1
    out[:, 6] = -s9
    out[:, 8] = s12
    out[:, 10] = 1
    out[:, 12] = s11
    out[:, 13] = -s12
    out[:, 17] = 1
    return out.reshape(-1, 3, 6)


def stepped(given, step):
    """Return the state (N, 12) after a step of the unknowns (N, 6)."""
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
    wx = step[:, 0]
    wy = step[:, 1]
    wz = step[:, 2]
    tx = step[:, 3]
    ty = step[:, 4]
    tz = step[:, 5]
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
    out = np.zeros((len(given), 12))
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
    return out
