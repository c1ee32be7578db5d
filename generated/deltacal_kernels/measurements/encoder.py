"""Joint as a second encoder on it counts [mm, rad].

Generated from derive/measurements/encoder.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both afa73e5f0603de03; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: joints x (N, 1), `given` (N, 3) the
instrument's state: sign zero turns.
Unknowns are increments of that state: enc_zero.
"""

import numpy as np

MEANING = "joint as a second encoder on it counts [mm, rad]"
COLUMNS = ("enc{i}_{unit}",)
TARGETS = {}
OVER_ROWS = ("reading", "by_platform", "by_unknown", "stepped", )  # functions over rows, which Numba compiles, too
PLATFORMS = 1
JOINT = True
UNKNOWN = (
    ("enc_zero", "rad", 0.05, "zero of the encoder"),
)
STATE = 3
START = (1.0, 0.0, 1.0,)
SCALE = 100.0
ROWS = 1
ROTATION_ROWS = ()


def reading(x, given):
    """Return the predicted reading (N, 1)."""
    theta = x[:, 0]
    sign = given[:, 0]
    zero = given[:, 1]
    s1 = sign*(theta + zero)
    out = np.zeros((len(x), 1))
    out[:, 0] = s1
    return out


def by_platform(x, given):
    """Return the derivatives by the joint (N, 1, 1, 1)."""
    sign = given[:, 0]
    out = np.zeros((len(x), 1))
    out[:, 0] = sign
    return out.reshape(-1, 1, 1, 1)


def by_unknown(x, given):
    """Return the derivatives by the instrument's unknowns (N, 1, 1)."""
    sign = given[:, 0]
    out = np.zeros((len(x), 1))
    out[:, 0] = sign
    return out.reshape(-1, 1, 1)


def stepped(given, step):
    """Return the state (N, 3) after a step of the unknowns (N, 1)."""
    sign = given[:, 0]
    zero = given[:, 1]
    turns = given[:, 2]
    dzero = step[:, 0]
    s0 = dzero + zero
    out = np.zeros((len(given), 3))
    out[:, 0] = sign
    out[:, 1] = s0
    out[:, 2] = turns
    return out
