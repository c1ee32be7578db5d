"""Length from a point of the base to the reference point [mm], row by row for Numba.

Generated from derive/measurements/gauge.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both e0be41f320f0b356; SymPy 1.14.0.

Functions of the NumPy module of this name, to be called likewise but for defaults, on C-contiguous arrays. Each is a
loop over rows; an array of one row counts for all of them.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.straight import straight

# of the arrays that each takes
DIMENSIONS = {"reading": (2, 2), "by_platform": (2, 2), "by_unknown": (2, 2), "stepped": (2, 2)}

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _reading(x, given, x_every, given_every, out, many):
    """11 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        gx = given[given_every * lane + 0]
        gy = given[given_every * lane + 1]
        gz = given[given_every * lane + 2]
        zero = given[given_every * lane + 3]
        s8 = zero + math.sqrt(((-gx + px) * (-gx + px)) + ((-gy + py) * (-gy + py)) + ((-gz + pz) * (-gz + pz)))
        out[1 * lane + 0] = s8


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
    """18 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        gx = given[given_every * lane + 0]
        gy = given[given_every * lane + 1]
        gz = given[given_every * lane + 2]
        s0 = -gx + px
        s2 = -gy + py
        s4 = -gz + pz
        s10 = 0.5/math.sqrt((s0 * s0) + (s2 * s2) + (s4 * s4))
        s12 = 2*s10*s4
        s14 = 2*s10*s2
        s16 = 2*s0*s10
        out[6 * lane + 0] = s16
        out[6 * lane + 1] = s14
        out[6 * lane + 2] = s12


@fast
def by_platform(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 6))
    _by_platform(x, given, x_every, given_every, out, many)
    return out.reshape(many, 1, 1, 6)


@straight
def _by_unknown(x, given, x_every, given_every, out, many):
    """21 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        gx = given[given_every * lane + 0]
        gy = given[given_every * lane + 1]
        gz = given[given_every * lane + 2]
        s0 = -gx + px
        s2 = -gy + py
        s4 = -gz + pz
        s10 = 0.5/math.sqrt((s0 * s0) + (s2 * s2) + (s4 * s4))
        s12 = 2*s10*s4
        s14 = 2*s10*s2
        s16 = 2*s0*s10
        out[4 * lane + 0] = -s16
        out[4 * lane + 1] = -s14
        out[4 * lane + 2] = -s12
        out[4 * lane + 3] = 1


@fast
def by_unknown(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 4))
    _by_unknown(x, given, x_every, given_every, out, many)
    return out.reshape(many, 1, 4)


@straight
def _stepped(given, step, given_every, step_every, out, many):
    """4 operations a row."""
    for lane in range(many):
        gx = given[given_every * lane + 0]
        gy = given[given_every * lane + 1]
        gz = given[given_every * lane + 2]
        zero = given[given_every * lane + 3]
        mx = step[step_every * lane + 0]
        my = step[step_every * lane + 1]
        mz = step[step_every * lane + 2]
        dzero = step[step_every * lane + 3]
        s0 = gx + mx
        s1 = gy + my
        s2 = gz + mz
        s3 = dzero + zero
        out[4 * lane + 0] = s0
        out[4 * lane + 1] = s1
        out[4 * lane + 2] = s2
        out[4 * lane + 3] = s3


@fast
def stepped(given, step):
    """Return what the NumPy function of this name returns."""
    many = len(given)
    given_every = given.size // len(given) if len(given) > 1 else 0
    step_every = step.size // len(step) if len(step) > 1 else 0
    out = np.zeros((many, 4))
    _stepped(given, step, given_every, step_every, out, many)
    return out.reshape(many, 4)
