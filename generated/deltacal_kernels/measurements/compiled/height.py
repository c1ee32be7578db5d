"""Height of the reference point above the bed [mm], row by row for Numba.

Generated from derive/measurements/height.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 88f2b3590965dd4d; SymPy 1.14.0.

Functions of the NumPy module of this name, to be called likewise but for defaults, on C-contiguous arrays. Each is a
loop over rows; an array of one row counts for all of them.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.straight import straight

# of the arrays that each takes
DIMENSIONS = {"reading": (2, 2), "by_platform": (2, 2)}

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _reading(x, given, x_every, given_every, out, many):
    """0 operations a row."""
    for lane in range(many):
        pz = x[x_every * lane + 2]
        out[1 * lane + 0] = pz


@fast
def reading(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 1))
    _reading(x, given, x_every, given_every, out, many)
    return out.reshape(many, 1)


@straight
def _by_platform(x, given, x_every, given_every, out, many):
    """0 operations a row."""
    for lane in range(many):
        out[6 * lane + 2] = 1


@fast
def by_platform(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 6))
    _by_platform(x, given, x_every, given_every, out, many)
    return out.reshape(many, 1, 1, 6)
