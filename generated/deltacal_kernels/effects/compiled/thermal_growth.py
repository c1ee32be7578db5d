"""Links and base grow with temperature, row by row for Numba.

Generated from derive/effects/thermal_growth.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both a4760c030f7de50a; SymPy 1.14.0.

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
        warming = s[s_every * lane + 0]
        L = s[s_every * lane + 1]
        l = s[s_every * lane + 2]
        b = s[s_every * lane + 3]
        expansion_proximal = c[c_every * lane + 0]
        expansion_distal = c[c_every * lane + 1]
        expansion_base = c[c_every * lane + 2]
        s0 = L*expansion_proximal*warming
        s1 = expansion_distal*l*warming
        s2 = b*expansion_base*warming
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
    """3 operations a row."""
    for lane in range(many):
        warming = s[s_every * lane + 0]
        L = s[s_every * lane + 1]
        l = s[s_every * lane + 2]
        b = s[s_every * lane + 3]
        s3 = L*warming
        s4 = l*warming
        s5 = b*warming
        out[9 * lane + 0] = s3
        out[9 * lane + 4] = s4
        out[9 * lane + 8] = s5


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 9))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 3, 3)
