"""Point of a printed board that the reference point touches, in the print's coordinates [mm].

Generated from derive/measurements/touched_board.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both 3728b99c7ae237e5; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: poses x (N, 12), position and rotation matrix, `given` (N, 13) the
instrument's state: F11 F12 F13 F21 F22 F23 F31 F32 F33 fx fy fz scale.
Unknowns are increments of that state: wx wy wz tx ty tz board_scale.
"""

import numpy as np

MEANING = "point of a printed board that the reference point touches, in the print's coordinates [mm]"
COLUMNS = ("board_x_mm", "board_y_mm", "board_z_mm",)
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
    ("board_scale", "1", 0.002, "by how much the print is larger than it says"),
)
STATE = 13
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
    scale = given[:, 12]
    s1 = (1.0 / (scale + 1))
    s6 = s1*(F11*px + F12*py + F13*pz + fx)
    s32 = s1*(F21*px + F22*py + F23*pz + fy)
    s42 = s1*(F31*px + F32*py + F33*pz + fz)
    out = np.zeros((len(x), 3))
    out[:, 0] = s6
    out[:, 1] = s32
    out[:, 2] = s42
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
    scale = given[:, 12]
    s1 = (1.0 / (scale + 1))
    s7 = F13*s1
    s12 = F12*s1
    s17 = F11*s1
    s33 = F23*s1
    s34 = F22*s1
    s35 = F21*s1
    s43 = F33*s1
    s44 = F32*s1
    s45 = F31*s1
    out = np.zeros((len(x), 18))
    out[:, 0] = s17
    out[:, 1] = s12
    out[:, 2] = s7
    out[:, 6] = s35
    out[:, 7] = s34
    out[:, 8] = s33
    out[:, 12] = s45
    out[:, 13] = s44
    out[:, 14] = s43
    return out.reshape(-1, 3, 1, 6)


def by_unknown(x, given):
    """Return the derivatives by the instrument's unknowns (N, 3, 7)."""
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
    scale = given[:, 12]
    s0 = scale + 1
    s1 = (1.0 / s0)
    s8 = pz*s1
    s13 = py*s1
    s18 = px*s1
    s20 = F31*s18 + F32*s13 + F33*s8
    s22 = F21*s18 + F22*s13 + F23*s8
    s24 = F11*s18 + F12*s13 + F13*s8
    s26 = (1.0 / (s0 * s0))
    s27 = -s26*(F11*px + F12*py + F13*pz + fx)
    s37 = -s26*(F21*px + F22*py + F23*pz + fy)
    s47 = -s26*(F31*px + F32*py + F33*pz + fz)
    out = np.zeros((len(x), 21))
    out[:, 1] = s20
    out[:, 2] = -s22
    out[:, 3] = s1
    out[:, 6] = s27
    out[:, 7] = -s20
    out[:, 9] = s24
    out[:, 11] = s1
    out[:, 13] = s37
    out[:, 14] = s22
    out[:, 15] = -s24
    out[:, 19] = s1
    out[:, 20] = s47
    return out.reshape(-1, 3, 7)


def stepped(given, step):
    """Return the state (N, 13) after a step of the unknowns (N, 7)."""
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
    scale = given[:, 12]
    wx = step[:, 0]
    wy = step[:, 1]
    wz = step[:, 2]
    tx = step[:, 3]
    ty = step[:, 4]
    tz = step[:, 5]
    dscale = step[:, 6]
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
    s68 = dscale + scale
    out = np.zeros((len(given), 13))
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
    out[:, 12] = s68
    return out
