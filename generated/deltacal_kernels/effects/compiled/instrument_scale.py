"""The instrument's length scale is wrong, row by row for Numba.

Generated from derive/effects/instrument_scale.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 7f0ff48b2533ccc3; SymPy 1.14.0.

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
    """4 operations a row."""
    for lane in range(many):
        y_x = s[s_every * lane + 0]
        y_y = s[s_every * lane + 1]
        y_z = s[s_every * lane + 2]
        y_length = s[s_every * lane + 3]
        scale = c[c_every * lane + 0]
        s0 = scale*y_x
        s1 = scale*y_y
        s2 = scale*y_z
        s3 = scale*y_length
        out[4 * lane + 0] = s0
        out[4 * lane + 1] = s1
        out[4 * lane + 2] = s2
        out[4 * lane + 3] = s3


@fast
def value(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 4))
    _value(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 4)


@straight
def _jacobian(s, c, constants, s_every, c_every, out, many):
    """0 operations a row."""
    for lane in range(many):
        y_x = s[s_every * lane + 0]
        y_y = s[s_every * lane + 1]
        y_z = s[s_every * lane + 2]
        y_length = s[s_every * lane + 3]
        out[4 * lane + 0] = y_x
        out[4 * lane + 1] = y_y
        out[4 * lane + 2] = y_z
        out[4 * lane + 3] = y_length


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 4))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 4, 1)
