"""Column leans the more, the higher it is, row by row for Numba.

Generated from derive/effects/column_lean.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 520c9c7082d660c5; SymPy 1.14.0.

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
    """18 operations a row."""
    for lane in range(many):
        q = s[s_every * lane + 0]
        on_side_x = s[s_every * lane + 1]
        on_side_y = s[s_every * lane + 2]
        on_tilt_x = s[s_every * lane + 3]
        on_tilt_y = s[s_every * lane + 4]
        foot = s[s_every * lane + 5]
        slides = s[s_every * lane + 6]
        compliance = c[c_every * lane + 0]
        s1 = foot + q*slides
        s3 = on_side_y*s1 + on_tilt_x
        s4 = compliance*s1*s3
        s6 = -on_side_x*s1 + on_tilt_y
        s7 = compliance*s1*s6
        s8 = (s1 * s1)
        s9 = -0.5*compliance*s6*s8
        s10 = 0.5*compliance*s3*s8
        out[4 * lane + 0] = s4
        out[4 * lane + 1] = s7
        out[4 * lane + 2] = s9
        out[4 * lane + 3] = s10


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
    """14 operations a row."""
    for lane in range(many):
        q = s[s_every * lane + 0]
        on_side_x = s[s_every * lane + 1]
        on_side_y = s[s_every * lane + 2]
        on_tilt_x = s[s_every * lane + 3]
        on_tilt_y = s[s_every * lane + 4]
        foot = s[s_every * lane + 5]
        slides = s[s_every * lane + 6]
        s1 = foot + q*slides
        s3 = on_side_y*s1 + on_tilt_x
        s6 = -on_side_x*s1 + on_tilt_y
        s8 = (s1 * s1)
        s11 = s1*s3
        s12 = s1*s6
        s13 = -0.5*s6*s8
        s14 = 0.5*s3*s8
        out[4 * lane + 0] = s11
        out[4 * lane + 1] = s12
        out[4 * lane + 2] = s13
        out[4 * lane + 3] = s14


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 4))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 4, 1)
