"""Rods, spacings or axes of a parallelogram differ, row by row for Numba.

Generated from derive/effects/parallelogram_error.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both d21e4d8bd6175584; SymPy 1.14.0.

Functions of the NumPy module of this name, to be called likewise but for defaults, on C-contiguous arrays. Each is a
loop over rows; an array of one row counts for all of them.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.straight import straight

# of the arrays that each takes
DIMENSIONS = {"value": (2, 2, 1), "jacobian": (2, 2, 1)}

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _value(s, c, constants, s_every, c_every, out, many):
    """0 operations a row."""
    for lane in range(many):
        dl = c[c_every * lane + 0]
        dc = c[c_every * lane + 1]
        alpha03 = c[c_every * lane + 2]
        beta03 = c[c_every * lane + 3]
        alpha2 = c[c_every * lane + 4]
        beta2 = c[c_every * lane + 5]
        out[6 * lane + 0] = dl
        out[6 * lane + 1] = dc
        out[6 * lane + 2] = alpha03
        out[6 * lane + 3] = beta03
        out[6 * lane + 4] = alpha2
        out[6 * lane + 5] = beta2


@fast
def value(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 6))
    _value(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 6)


@straight
def _jacobian(s, c, constants, s_every, c_every, out, many):
    """0 operations a row."""
    for lane in range(many):
        out[36 * lane + 0] = 1
        out[36 * lane + 7] = 1
        out[36 * lane + 14] = 1
        out[36 * lane + 21] = 1
        out[36 * lane + 28] = 1
        out[36 * lane + 35] = 1


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 36))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 6, 6)
