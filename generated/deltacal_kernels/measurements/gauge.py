"""Length from a point of the base to the reference point [mm].

Generated from derive/measurements/gauge.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both 798efcafe09d2c56; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: poses x (N, 12), position and rotation matrix, `given` (N, 4) the
instrument's state: gx gy gz zero.
Unknowns are increments of that state: mx my mz dzero.
"""

import numpy as np

MEANING = "length from a point of the base to the reference point [mm]"
COLUMNS = ("gauge_mm",)
TARGETS = {"length": 0}
OVER_ROWS = ("reading", "by_platform", "by_unknown", "stepped", )  # functions over rows, which Numba compiles, too
PLATFORMS = 1
UNKNOWN = (
    ("mx", "mm", 1.0, "error of the base point in {O}"),
    ("my", "mm", 1.0, "error of the base point in {O}"),
    ("mz", "mm", 1.0, "error of the base point in {O}"),
    ("dzero", "mm", 1.0, "error of the gauge's zero"),
)
STATE = 4
START = ()
SCALE = 1.0
ROWS = 1
ROTATION_ROWS = ()


def reading(x, given):
    """Return the predicted reading (N, 1)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    gx = given[:, 0]
    gy = given[:, 1]
    gz = given[:, 2]
    zero = given[:, 3]
    s8 = zero + np.sqrt(((-gx + px) * (-gx + px)) + ((-gy + py) * (-gy + py)) + ((-gz + pz) * (-gz + pz)))
    out = np.zeros((len(x), 1))
    out[:, 0] = s8
    return out


def by_platform(x, given):
    """Return the derivatives by shift and turn of the platforms in {O} (N, 1, 1, 6)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    gx = given[:, 0]
    gy = given[:, 1]
    gz = given[:, 2]
    s0 = -gx + px
    s2 = -gy + py
    s4 = -gz + pz
    s10 = 0.5/np.sqrt((s0 * s0) + (s2 * s2) + (s4 * s4))
    s12 = 2*s10*s4
    s14 = 2*s10*s2
    s16 = 2*s0*s10
    out = np.zeros((len(x), 6))
    out[:, 0] = s16
    out[:, 1] = s14
    out[:, 2] = s12
    return out.reshape(-1, 1, 1, 6)


def by_unknown(x, given):
    """Return the derivatives by the instrument's unknowns (N, 1, 4)."""
    px = x[:, 0]
    py = x[:, 1]
    pz = x[:, 2]
    gx = given[:, 0]
    gy = given[:, 1]
    gz = given[:, 2]
    s0 = -gx + px
    s2 = -gy + py
    s4 = -gz + pz
    s10 = 0.5/np.sqrt((s0 * s0) + (s2 * s2) + (s4 * s4))
    s12 = 2*s10*s4
    s14 = 2*s10*s2
    s16 = 2*s0*s10
    out = np.zeros((len(x), 4))
    out[:, 0] = -s16
    out[:, 1] = -s14
    out[:, 2] = -s12
    out[:, 3] = 1
    return out.reshape(-1, 1, 4)


def stepped(given, step):
    """Return the state (N, 4) after a step of the unknowns (N, 4)."""
    gx = given[:, 0]
    gy = given[:, 1]
    gz = given[:, 2]
    zero = given[:, 3]
    mx = step[:, 0]
    my = step[:, 1]
    mz = step[:, 2]
    dzero = step[:, 3]
    s0 = gx + mx
    s1 = gy + my
    s2 = gz + mz
    s3 = dzero + zero
    out = np.zeros((len(given), 4))
    out[:, 0] = s0
    out[:, 1] = s1
    out[:, 2] = s2
    out[:, 3] = s3
    return out
