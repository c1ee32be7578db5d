"""Joint as a second encoder on it counts [mm, rad], row by row for Numba.

Generated from derive/measurements/encoder.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 1aec7608158fffd2; SymPy 1.14.0.

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
    """2 operations a row."""
    for lane in range(many):
        theta = x[x_every * lane + 0]
        sign = given[given_every * lane + 0]
        zero = given[given_every * lane + 1]
        s1 = sign*(theta + zero)
        out[1 * lane + 0] = s1


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
        sign = given[given_every * lane + 0]
        out[1 * lane + 0] = sign


@fast
def by_platform(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 1))
    _by_platform(x, given, x_every, given_every, out, many)
    return out.reshape(many, 1, 1, 1)


@straight
def _by_unknown(x, given, x_every, given_every, out, many):
    """0 operations a row."""
    for lane in range(many):
        sign = given[given_every * lane + 0]
        out[1 * lane + 0] = sign


@fast
def by_unknown(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 1))
    _by_unknown(x, given, x_every, given_every, out, many)
    return out.reshape(many, 1, 1)


@straight
def _stepped(given, step, given_every, step_every, out, many):
    """1 operations a row."""
    for lane in range(many):
        sign = given[given_every * lane + 0]
        zero = given[given_every * lane + 1]
        turns = given[given_every * lane + 2]
        dzero = step[step_every * lane + 0]
        s0 = dzero + zero
        out[3 * lane + 0] = sign
        out[3 * lane + 1] = s0
        out[3 * lane + 2] = turns


@fast
def stepped(given, step):
    """Return what the NumPy function of this name returns."""
    many = len(given)
    given_every = given.size // len(given) if len(given) > 1 else 0
    step_every = step.size // len(step) if len(step) > 1 else 0
    out = np.zeros((many, 3))
    _stepped(given, step, given_every, step_every, out, many)
    return out.reshape(many, 3)
