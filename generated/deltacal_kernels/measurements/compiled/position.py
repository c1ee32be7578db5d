"""Position of the reference point in the instrument's frame [mm], row by row for Numba.

Generated from derive/measurements/position.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both cc695b6e4ba2d4fb; SymPy 1.14.0.

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
    """18 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        F11 = given[given_every * lane + 0]
        F12 = given[given_every * lane + 1]
        F13 = given[given_every * lane + 2]
        F21 = given[given_every * lane + 3]
        F22 = given[given_every * lane + 4]
        F23 = given[given_every * lane + 5]
        F31 = given[given_every * lane + 6]
        F32 = given[given_every * lane + 7]
        F33 = given[given_every * lane + 8]
        fx = given[given_every * lane + 9]
        fy = given[given_every * lane + 10]
        fz = given[given_every * lane + 11]
        s3 = F11*px + F12*py + F13*pz + fx
        s14 = F21*px + F22*py + F23*pz + fy
        s16 = F31*px + F32*py + F33*pz + fz
        out[3 * lane + 0] = s3
        out[3 * lane + 1] = s14
        out[3 * lane + 2] = s16


@fast
def reading(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 3))
    _reading(x, given, x_every, given_every, out, many)
    return out.reshape(many, 3)


@straight
def _by_platform(x, given, x_every, given_every, out, many):
    """0 operations a row."""
    for lane in range(many):
        F11 = given[given_every * lane + 0]
        F12 = given[given_every * lane + 1]
        F13 = given[given_every * lane + 2]
        F21 = given[given_every * lane + 3]
        F22 = given[given_every * lane + 4]
        F23 = given[given_every * lane + 5]
        F31 = given[given_every * lane + 6]
        F32 = given[given_every * lane + 7]
        F33 = given[given_every * lane + 8]
        out[18 * lane + 0] = F11
        out[18 * lane + 1] = F12
        out[18 * lane + 2] = F13
        out[18 * lane + 6] = F21
        out[18 * lane + 7] = F22
        out[18 * lane + 8] = F23
        out[18 * lane + 12] = F31
        out[18 * lane + 13] = F32
        out[18 * lane + 14] = F33


@fast
def by_platform(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 18))
    _by_platform(x, given, x_every, given_every, out, many)
    return out.reshape(many, 3, 1, 6)


@straight
def _by_unknown(x, given, x_every, given_every, out, many):
    """18 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        F11 = given[given_every * lane + 0]
        F12 = given[given_every * lane + 1]
        F13 = given[given_every * lane + 2]
        F21 = given[given_every * lane + 3]
        F22 = given[given_every * lane + 4]
        F23 = given[given_every * lane + 5]
        F31 = given[given_every * lane + 6]
        F32 = given[given_every * lane + 7]
        F33 = given[given_every * lane + 8]
        s9 = F31*px + F32*py + F33*pz
        s11 = F21*px + F22*py + F23*pz
        s12 = F11*px + F12*py + F13*pz
        out[18 * lane + 1] = s9
        out[18 * lane + 2] = -s11
        out[18 * lane + 3] = 1
        out[18 * lane + 6] = -s9
        out[18 * lane + 8] = s12
        out[18 * lane + 10] = 1
        out[18 * lane + 12] = s11
        out[18 * lane + 13] = -s12
        out[18 * lane + 17] = 1


@fast
def by_unknown(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 18))
    _by_unknown(x, given, x_every, given_every, out, many)
    return out.reshape(many, 3, 6)


@straight
def _stepped(given, step, given_every, step_every, out, many):
    """103 operations a row."""
    for lane in range(many):
        F11 = given[given_every * lane + 0]
        F12 = given[given_every * lane + 1]
        F13 = given[given_every * lane + 2]
        F21 = given[given_every * lane + 3]
        F22 = given[given_every * lane + 4]
        F23 = given[given_every * lane + 5]
        F31 = given[given_every * lane + 6]
        F32 = given[given_every * lane + 7]
        F33 = given[given_every * lane + 8]
        fx = given[given_every * lane + 9]
        fy = given[given_every * lane + 10]
        fz = given[given_every * lane + 11]
        wx = step[step_every * lane + 0]
        wy = step[step_every * lane + 1]
        wz = step[step_every * lane + 2]
        tx = step[step_every * lane + 3]
        ty = step[step_every * lane + 4]
        tz = step[step_every * lane + 5]
        s0 = (wx * wx)
        s2 = (wy * wy)
        s4 = (wz * wz)
        s7 = (1.0 / (0.25*s0 + 0.25*s2 + 0.25*s4 + 1))
        s8 = -0.5*s2
        s9 = -0.5*s4
        s12 = s7*(s8 + s9) + 1
        s14 = 0.5*wx*wy
        s15 = s14 - wz
        s17 = 0.5*wx*wz
        s18 = s17 + wy
        s20 = F11*s12 + F21*s15*s7 + F31*s18*s7
        s24 = F12*s12 + F22*s15*s7 + F32*s18*s7
        s28 = F13*s12 + F23*s15*s7 + F33*s18*s7
        s29 = -0.5*s0
        s32 = s7*(s29 + s9) + 1
        s34 = s14 + wz
        s36 = 0.5*wy*wz
        s37 = s36 - wx
        s39 = F11*s34*s7 + F21*s32 + F31*s37*s7
        s43 = F12*s34*s7 + F22*s32 + F32*s37*s7
        s47 = F13*s34*s7 + F23*s32 + F33*s37*s7
        s50 = s7*(s29 + s8) + 1
        s52 = s17 - wy
        s54 = s36 + wx
        s56 = F11*s52*s7 + F21*s54*s7 + F31*s50
        s60 = F12*s52*s7 + F22*s54*s7 + F32*s50
        s64 = F13*s52*s7 + F23*s54*s7 + F33*s50
        s65 = fx + tx
        s66 = fy + ty
        s67 = fz + tz
        out[12 * lane + 0] = s20
        out[12 * lane + 1] = s24
        out[12 * lane + 2] = s28
        out[12 * lane + 3] = s39
        out[12 * lane + 4] = s43
        out[12 * lane + 5] = s47
        out[12 * lane + 6] = s56
        out[12 * lane + 7] = s60
        out[12 * lane + 8] = s64
        out[12 * lane + 9] = s65
        out[12 * lane + 10] = s66
        out[12 * lane + 11] = s67


@fast
def stepped(given, step):
    """Return what the NumPy function of this name returns."""
    many = len(given)
    given_every = given.size // len(given) if len(given) > 1 else 0
    step_every = step.size // len(step) if len(step) > 1 else 0
    out = np.zeros((many, 12))
    _stepped(given, step, given_every, step_every, out, many)
    return out.reshape(many, 12)
