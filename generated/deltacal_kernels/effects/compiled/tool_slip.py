"""The measured point slips on the platform once, row by row for Numba.

Generated from derive/effects/tool_slip.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both d6393b9d8306bcfa; SymPy 1.14.0.

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
    """3 operations a row."""
    for lane in range(many):
        after = s[s_every * lane + 0]
        offset_x = c[c_every * lane + 0]
        offset_y = c[c_every * lane + 1]
        offset_z = c[c_every * lane + 2]
        s0 = after*offset_x
        s1 = after*offset_y
        s2 = after*offset_z
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
    """0 operations a row."""
    for lane in range(many):
        after = s[s_every * lane + 0]
        out[9 * lane + 0] = after
        out[9 * lane + 4] = after
        out[9 * lane + 8] = after


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 9))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 3, 3)
