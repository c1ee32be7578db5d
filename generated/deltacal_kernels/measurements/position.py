"""Position of the reference point in the instrument's frame [mm].

Generated from derive/measurements/position.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both 938e456fe3ff8c61; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: poses x (N, 12), position and rotation matrix, `given` (N, 12) the
instrument's state: F11 F12 F13 F21 F22 F23 F31 F32 F33 fx fy fz.
Unknowns are increments of that state: wx wy wz tx ty tz.
"""

import numpy as np

UNKNOWN = (
    ("wx", "rad", "turn of {O} about the instrument's axes"),
    ("wy", "rad", "turn of {O} about the instrument's axes"),
    ("wz", "rad", "turn of {O} about the instrument's axes"),
    ("tx", "mm", "shift of {O} along the instrument's axes"),
    ("ty", "mm", "shift of {O} along the instrument's axes"),
    ("tz", "mm", "shift of {O} along the instrument's axes"),
)
ROWS = 3


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
