"""Position [mm] and rotation [rad] of a body on the platform in the instrument's frame, row by row for Numba.

Generated from derive/measurements/pose.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 5ec58452c8a8fdf5; SymPy 1.14.0.

Functions of the NumPy module of this name, to be called likewise but for defaults, on C-contiguous arrays. Each is a
loop over rows; an array of one row counts for all of them.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.straight import straight

# of the arrays that each takes
DIMENSIONS = {"reading": (2, 2), "rotation": (2, 2), "by_platform": (2, 2), "by_unknown": (2, 2), "stepped": (2, 2)}

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
def _rotation(x, given, x_every, given_every, out, many):
    """90 operations a row."""
    for lane in range(many):
        R11 = x[x_every * lane + 3]
        R12 = x[x_every * lane + 4]
        R13 = x[x_every * lane + 5]
        R21 = x[x_every * lane + 6]
        R22 = x[x_every * lane + 7]
        R23 = x[x_every * lane + 8]
        R31 = x[x_every * lane + 9]
        R32 = x[x_every * lane + 10]
        R33 = x[x_every * lane + 11]
        F11 = given[given_every * lane + 0]
        F12 = given[given_every * lane + 1]
        F13 = given[given_every * lane + 2]
        F21 = given[given_every * lane + 3]
        F22 = given[given_every * lane + 4]
        F23 = given[given_every * lane + 5]
        F31 = given[given_every * lane + 6]
        F32 = given[given_every * lane + 7]
        F33 = given[given_every * lane + 8]
        D11 = given[given_every * lane + 12]
        D12 = given[given_every * lane + 13]
        D13 = given[given_every * lane + 14]
        D21 = given[given_every * lane + 15]
        D22 = given[given_every * lane + 16]
        D23 = given[given_every * lane + 17]
        D31 = given[given_every * lane + 18]
        D32 = given[given_every * lane + 19]
        D33 = given[given_every * lane + 20]
        s21 = F11*R11 + F12*R21 + F13*R31
        s25 = F11*R12 + F12*R22 + F13*R32
        s29 = F11*R13 + F12*R23 + F13*R33
        s33 = F21*R11 + F22*R21 + F23*R31
        s37 = F21*R12 + F22*R22 + F23*R32
        s41 = F21*R13 + F22*R23 + F23*R33
        s45 = F31*R11 + F32*R21 + F33*R31
        s49 = F31*R12 + F32*R22 + F33*R32
        s53 = F31*R13 + F32*R23 + F33*R33
        s57 = D11*s21 + D21*s25 + D31*s29
        s61 = D12*s21 + D22*s25 + D32*s29
        s65 = D13*s21 + D23*s25 + D33*s29
        s69 = D11*s33 + D21*s37 + D31*s41
        s73 = D12*s33 + D22*s37 + D32*s41
        s77 = D13*s33 + D23*s37 + D33*s41
        s81 = D11*s45 + D21*s49 + D31*s53
        s85 = D12*s45 + D22*s49 + D32*s53
        s89 = D13*s45 + D23*s49 + D33*s53
        out[9 * lane + 0] = s57
        out[9 * lane + 1] = s61
        out[9 * lane + 2] = s65
        out[9 * lane + 3] = s69
        out[9 * lane + 4] = s73
        out[9 * lane + 5] = s77
        out[9 * lane + 6] = s81
        out[9 * lane + 7] = s85
        out[9 * lane + 8] = s89


@fast
def rotation(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 9))
    _rotation(x, given, x_every, given_every, out, many)
    return out.reshape(many, 3, 3)


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
        out[36 * lane + 0] = F11
        out[36 * lane + 1] = F12
        out[36 * lane + 2] = F13
        out[36 * lane + 6] = F21
        out[36 * lane + 7] = F22
        out[36 * lane + 8] = F23
        out[36 * lane + 12] = F31
        out[36 * lane + 13] = F32
        out[36 * lane + 14] = F33
        out[36 * lane + 21] = F11
        out[36 * lane + 22] = F12
        out[36 * lane + 23] = F13
        out[36 * lane + 27] = F21
        out[36 * lane + 28] = F22
        out[36 * lane + 29] = F23
        out[36 * lane + 33] = F31
        out[36 * lane + 34] = F32
        out[36 * lane + 35] = F33


@fast
def by_platform(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 36))
    _by_platform(x, given, x_every, given_every, out, many)
    return out.reshape(many, 6, 1, 6)


@straight
def _by_unknown(x, given, x_every, given_every, out, many):
    """63 operations a row."""
    for lane in range(many):
        px = x[x_every * lane + 0]
        py = x[x_every * lane + 1]
        pz = x[x_every * lane + 2]
        R11 = x[x_every * lane + 3]
        R12 = x[x_every * lane + 4]
        R13 = x[x_every * lane + 5]
        R21 = x[x_every * lane + 6]
        R22 = x[x_every * lane + 7]
        R23 = x[x_every * lane + 8]
        R31 = x[x_every * lane + 9]
        R32 = x[x_every * lane + 10]
        R33 = x[x_every * lane + 11]
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
        s21 = F11*R11 + F12*R21 + F13*R31
        s25 = F11*R12 + F12*R22 + F13*R32
        s29 = F11*R13 + F12*R23 + F13*R33
        s33 = F21*R11 + F22*R21 + F23*R31
        s37 = F21*R12 + F22*R22 + F23*R32
        s41 = F21*R13 + F22*R23 + F23*R33
        s45 = F31*R11 + F32*R21 + F33*R31
        s49 = F31*R12 + F32*R22 + F33*R32
        s53 = F31*R13 + F32*R23 + F33*R33
        out[54 * lane + 1] = s9
        out[54 * lane + 2] = -s11
        out[54 * lane + 3] = 1
        out[54 * lane + 9] = -s9
        out[54 * lane + 11] = s12
        out[54 * lane + 13] = 1
        out[54 * lane + 18] = s11
        out[54 * lane + 19] = -s12
        out[54 * lane + 23] = 1
        out[54 * lane + 27] = 1
        out[54 * lane + 33] = s21
        out[54 * lane + 34] = s25
        out[54 * lane + 35] = s29
        out[54 * lane + 37] = 1
        out[54 * lane + 42] = s33
        out[54 * lane + 43] = s37
        out[54 * lane + 44] = s41
        out[54 * lane + 47] = 1
        out[54 * lane + 51] = s45
        out[54 * lane + 52] = s49
        out[54 * lane + 53] = s53


@fast
def by_unknown(x, given):
    """Return what the NumPy function of this name returns."""
    many = len(x)
    x_every = x.size // len(x) if len(x) > 1 else 0
    given_every = given.size // len(given) if len(given) > 1 else 0
    out = np.zeros((many, 54))
    _by_unknown(x, given, x_every, given_every, out, many)
    return out.reshape(many, 6, 9)


@straight
def _stepped(given, step, given_every, step_every, out, many):
    """203 operations a row."""
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
        D11 = given[given_every * lane + 12]
        D12 = given[given_every * lane + 13]
        D13 = given[given_every * lane + 14]
        D21 = given[given_every * lane + 15]
        D22 = given[given_every * lane + 16]
        D23 = given[given_every * lane + 17]
        D31 = given[given_every * lane + 18]
        D32 = given[given_every * lane + 19]
        D33 = given[given_every * lane + 20]
        wx = step[step_every * lane + 0]
        wy = step[step_every * lane + 1]
        wz = step[step_every * lane + 2]
        tx = step[step_every * lane + 3]
        ty = step[step_every * lane + 4]
        tz = step[step_every * lane + 5]
        dx = step[step_every * lane + 6]
        dy = step[step_every * lane + 7]
        dz = step[step_every * lane + 8]
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
        s68 = (dx * dx)
        s70 = (dy * dy)
        s72 = (dz * dz)
        s75 = (1.0 / (0.25*s68 + 0.25*s70 + 0.25*s72 + 1))
        s76 = -0.5*s70
        s77 = -0.5*s72
        s80 = s75*(s76 + s77) + 1
        s82 = 0.5*dx*dy
        s83 = -dz + s82
        s85 = 0.5*dx*dz
        s86 = dy + s85
        s88 = D11*s80 + D21*s75*s83 + D31*s75*s86
        s92 = D12*s80 + D22*s75*s83 + D32*s75*s86
        s96 = D13*s80 + D23*s75*s83 + D33*s75*s86
        s97 = -0.5*s68
        s100 = s75*(s77 + s97) + 1
        s102 = dz + s82
        s104 = 0.5*dy*dz
        s105 = -dx + s104
        s107 = D11*s102*s75 + D21*s100 + D31*s105*s75
        s111 = D12*s102*s75 + D22*s100 + D32*s105*s75
        s115 = D13*s102*s75 + D23*s100 + D33*s105*s75
        s118 = s75*(s76 + s97) + 1
        s120 = -dy + s85
        s122 = dx + s104
        s124 = D11*s120*s75 + D21*s122*s75 + D31*s118
        s128 = D12*s120*s75 + D22*s122*s75 + D32*s118
        s132 = D13*s120*s75 + D23*s122*s75 + D33*s118
        out[21 * lane + 0] = s20
        out[21 * lane + 1] = s24
        out[21 * lane + 2] = s28
        out[21 * lane + 3] = s39
        out[21 * lane + 4] = s43
        out[21 * lane + 5] = s47
        out[21 * lane + 6] = s56
        out[21 * lane + 7] = s60
        out[21 * lane + 8] = s64
        out[21 * lane + 9] = s65
        out[21 * lane + 10] = s66
        out[21 * lane + 11] = s67
        out[21 * lane + 12] = s88
        out[21 * lane + 13] = s92
        out[21 * lane + 14] = s96
        out[21 * lane + 15] = s107
        out[21 * lane + 16] = s111
        out[21 * lane + 17] = s115
        out[21 * lane + 18] = s124
        out[21 * lane + 19] = s128
        out[21 * lane + 20] = s132


@fast
def stepped(given, step):
    """Return what the NumPy function of this name returns."""
    many = len(given)
    given_every = given.size // len(given) if len(given) > 1 else 0
    step_every = step.size // len(step) if len(step) > 1 else 0
    out = np.zeros((many, 21))
    _stepped(given, step, given_every, step_every, out, many)
    return out.reshape(many, 21)
