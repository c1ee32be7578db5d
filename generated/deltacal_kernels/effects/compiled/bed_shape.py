"""The bed is not flat, row by row for Numba.

Generated from derive/effects/bed_shape.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 7893184ef2599e5e; SymPy 1.14.0.

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
    """45 operations a row."""
    for lane in range(many):
        b = s[s_every * lane + 0]
        x = s[s_every * lane + 1]
        y = s[s_every * lane + 2]
        c_x = c[c_every * lane + 0]
        c_y = c[c_every * lane + 1]
        xx = c[c_every * lane + 2]
        xy = c[c_every * lane + 3]
        yy = c[c_every * lane + 4]
        xxx = c[c_every * lane + 5]
        xxy = c[c_every * lane + 6]
        xyy = c[c_every * lane + 7]
        yyy = c[c_every * lane + 8]
        s0 = (1.0 / b)
        s3 = (1.0 / (b * b))
        s4 = (x * x)
        s5 = -s3*s4*xx
        s6 = (1.0 / (b * b * b))
        s8 = -s6*(x * x * x)*xxx
        s9 = (y * y)
        s10 = -s3*s9*yy
        s12 = -s6*(y * y * y)*yyy
        s13 = -s3*x*xy*y
        s14 = -s6*s9*x*xyy
        s15 = -s4*s6*xxy*y
        s16 = -c_x*s0*x - c_y*s0*y + s10 + s12 + s13 + s14 + s15 + s5 + s8
        out[1 * lane + 0] = s16


@fast
def value(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 1))
    _value(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 1)


@straight
def _jacobian(s, c, constants, s_every, c_every, out, many):
    """30 operations a row."""
    for lane in range(many):
        b = s[s_every * lane + 0]
        x = s[s_every * lane + 1]
        y = s[s_every * lane + 2]
        s0 = (1.0 / b)
        s3 = (1.0 / (b * b))
        s4 = (x * x)
        s6 = (1.0 / (b * b * b))
        s9 = (y * y)
        s17 = -s0*x
        s18 = -s0*y
        s19 = -s3*s4
        s20 = -s3*x*y
        s21 = -s3*s9
        s22 = -s6*(x * x * x)
        s23 = -s4*s6*y
        s24 = -s6*s9*x
        s25 = -s6*(y * y * y)
        out[9 * lane + 0] = s17
        out[9 * lane + 1] = s18
        out[9 * lane + 2] = s19
        out[9 * lane + 3] = s20
        out[9 * lane + 4] = s21
        out[9 * lane + 5] = s22
        out[9 * lane + 6] = s23
        out[9 * lane + 7] = s24
        out[9 * lane + 8] = s25


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 9))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 1, 9)
