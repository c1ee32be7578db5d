"""Distance between the reference points of two poses [mm].

Generated from derive/measurements/distance.py by "deltacal kernels". Do not edit.
Template templates/measurement.py.jinja; sha256 of both 0c44444ccfbeb06c; SymPy 1.14.0.

Plain NumPy, vectorised over the readings: poses x (N, 12), position and rotation matrix, `given` (N, 0) the
instrument's state: none.
Unknowns are increments of that state: none.
"""

import numpy as np

MEANING = "distance between the reference points of two poses [mm]"
COLUMNS = ("distance_mm",)
TARGETS = {"length": 0}
OVER_ROWS = ("reading", "by_platform", )  # functions over rows, which Numba compiles, too
PLATFORMS = 2
UNKNOWN = (
)
STATE = 0
START = ()
SCALE = 1.0
ROWS = 1
ROTATION_ROWS = ()


def reading(x_a, x_b, given):
    """Return the predicted reading (N, 1)."""
    px_a = x_a[:, 0]
    py_a = x_a[:, 1]
    pz_a = x_a[:, 2]
    px_b = x_b[:, 0]
    py_b = x_b[:, 1]
    pz_b = x_b[:, 2]
    s7 = np.sqrt(((-px_a + px_b) * (-px_a + px_b)) + ((-py_a + py_b) * (-py_a + py_b)) + ((-pz_a + pz_b) * (-pz_a + pz_b)))
    out = np.zeros((len(x_a), 1))
    out[:, 0] = s7
    return out


def by_platform(x_a, x_b, given):
    """Return the derivatives by shift and turn of the platforms in {O} (N, 1, 2, 6)."""
    px_a = x_a[:, 0]
    py_a = x_a[:, 1]
    pz_a = x_a[:, 2]
    px_b = x_b[:, 0]
    py_b = x_b[:, 1]
    pz_b = x_b[:, 2]
    s0 = -px_a + px_b
    s2 = -py_a + py_b
    s4 = -pz_a + pz_b
    s9 = 0.5/np.sqrt((s0 * s0) + (s2 * s2) + (s4 * s4))
    s11 = 2*s4*s9
    s13 = 2*s2*s9
    s15 = 2*s0*s9
    out = np.zeros((len(x_a), 12))
    out[:, 0] = -s15
    out[:, 1] = -s13
    out[:, 2] = -s11
    out[:, 6] = s15
    out[:, 7] = s13
    out[:, 8] = s11
    return out.reshape(-1, 1, 2, 6)
