"""A joint lags the others, row by row for Numba.

Generated from derive/effects/joint_latency.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both cd02018d3596c468; SymPy 1.14.0.

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
    """5 operations a row."""
    for lane in range(many):
        qd = s[s_every * lane + 0]
        qdd = s[s_every * lane + 1]
        delay = c[c_every * lane + 0]
        s3 = 0.5*(delay * delay)*qdd - delay*qd
        out[1 * lane + 0] = s3


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
    """2 operations a row."""
    for lane in range(many):
        qd = s[s_every * lane + 0]
        qdd = s[s_every * lane + 1]
        delay = c[c_every * lane + 0]
        s5 = delay*qdd - qd
        out[1 * lane + 0] = s5


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 1))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 1, 1)
