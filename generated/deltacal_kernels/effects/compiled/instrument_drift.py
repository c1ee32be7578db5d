"""The instrument drifts, row by row for Numba.

Generated from derive/effects/instrument_drift.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both fbd86cb38de0bdb3; SymPy 1.14.0.

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
    """6 operations a row."""
    for lane in range(many):
        time = s[s_every * lane + 0]
        rate_x = c[c_every * lane + 0]
        rate_y = c[c_every * lane + 1]
        rate_z = c[c_every * lane + 2]
        s0 = 0.0002777777777777778*rate_x*time
        s1 = 0.0002777777777777778*rate_y*time
        s2 = 0.0002777777777777778*rate_z*time
        out[3 * lane + 0] = s0
        out[3 * lane + 1] = s1
        out[3 * lane + 2] = s2


@fast
def value(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 3))
    _value(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 3)


@straight
def _jacobian(s, c, constants, s_every, c_every, out, many):
    """1 operations a row."""
    for lane in range(many):
        time = s[s_every * lane + 0]
        s3 = 0.0002777777777777778*time
        out[9 * lane + 0] = s3
        out[9 * lane + 4] = s3
        out[9 * lane + 8] = s3


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 9))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 3, 3)
