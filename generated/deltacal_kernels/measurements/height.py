"""Height of the reference point above the bed [mm].

Generated from derive/measurements/height.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both ab5e1869a644332c; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: poses x (N, 12), position and rotation matrix, `given` (N, 0) the
instrument's state: none.
Unknowns are increments of that state: none.
"""

import numpy as np

MEANING = "height of the reference point above the bed [mm]"
COLUMNS = ("height_mm",)
TARGETS = {"height": 0}
OVER_ROWS = ("reading", "by_platform", )  # functions over rows, which Numba compiles, too
PLATFORMS = 1
UNKNOWN = (
)
STATE = 0
START = ()
SCALE = 1.0
ROWS = 1
ROTATION_ROWS = ()


def reading(x, given):
    """Return the predicted reading (N, 1)."""
    pz = x[:, 2]
    out = np.zeros((len(x), 1))
    out[:, 0] = pz
    return out


def by_platform(x, given):
    """Return the derivatives by shift and turn of the platforms in {O} (N, 1, 1, 6)."""
    out = np.zeros((len(x), 6))
    out[:, 2] = 1
    return out.reshape(-1, 1, 1, 6)
