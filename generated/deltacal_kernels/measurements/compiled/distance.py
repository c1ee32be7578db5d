"""Distance between the reference points of two poses [mm], row by row for Numba.

Generated from derive/measurements/distance.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both a9f35743f896ca9d; SymPy 1.14.0.

Functions of the NumPy module of this name, to be called likewise but for defaults, on C-contiguous arrays. Each is a
loop over rows; an array of one row counts for all of them.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.straight import straight

# of the arrays that each takes
DIMENSIONS = {"reading": (2, 2, 2), "by_platform": (2, 2, 2)}

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _reading(x_a, x_b, given, x_a_every, x_b_every, given_every, out, many):
    """10 operations a row."""
    for lane in range(many):
        px_a = x_a[x_a_every * lane + 0]
        py_a = x_a[x_a_every * lane + 1]
        pz_a = x_a[x_a_every * lane + 2]
        px_b = x_b[x_b_every * lane + 0]
        py_b = x_b[x_b_every * lane + 1]
        pz_b = x_b[x_b_every * lane + 2]
        s7 = math.sqrt(((-px_a + px_b) * (-px_a + px_b)) + ((-py_a + py_b) * (-py_a + py_b)) + ((-pz_a + pz_b) * (-pz_a + pz_b)))
        out[1 * lane + 0] = s7


@fast
def reading(x_a, x_b, given):
    """Return what the NumPy function of this name returns."""
    many = len(x_a)
    x_a_every = x_a.size // len(x_a) if len(x_a) > 1 else 0
    x_b_every = x_b.size // len(x_b) if len(x_b) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 1))
    _reading(x_a, x_b, given, x_a_every, x_b_every, given_every, out, many)
    return out.reshape(many, 1)


@straight
def _by_platform(x_a, x_b, given, x_a_every, x_b_every, given_every, out, many):
    """21 operations a row."""
    for lane in range(many):
        px_a = x_a[x_a_every * lane + 0]
        py_a = x_a[x_a_every * lane + 1]
        pz_a = x_a[x_a_every * lane + 2]
        px_b = x_b[x_b_every * lane + 0]
        py_b = x_b[x_b_every * lane + 1]
        pz_b = x_b[x_b_every * lane + 2]
        s0 = -px_a + px_b
        s2 = -py_a + py_b
        s4 = -pz_a + pz_b
        s9 = 0.5/math.sqrt((s0 * s0) + (s2 * s2) + (s4 * s4))
        s11 = 2*s4*s9
        s13 = 2*s2*s9
        s15 = 2*s0*s9
        out[12 * lane + 0] = -s15
        out[12 * lane + 1] = -s13
        out[12 * lane + 2] = -s11
        out[12 * lane + 6] = s15
        out[12 * lane + 7] = s13
        out[12 * lane + 8] = s11


@fast
def by_platform(x_a, x_b, given):
    """Return what the NumPy function of this name returns."""
    many = len(x_a)
    x_a_every = x_a.size // len(x_a) if len(x_a) > 1 else 0
    x_b_every = x_b.size // len(x_b) if len(x_b) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 12))
    _by_platform(x_a, x_b, given, x_a_every, x_b_every, given_every, out, many)
    return out.reshape(many, 1, 2, 6)
