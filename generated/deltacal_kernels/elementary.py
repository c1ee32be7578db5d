"""Elementary functions without branches and calls, for loops that a compiler turns into SIMD code.

Written by "deltacal kernels". Do not edit.

Cody and Waite 1980 reduction by pi/2 in three parts, and the polynomials of Moshier's Cephes: within 2 units in the
last place, or 1e-15 absolute, for arguments up to 1e5 rad. A NaN goes through.
"""

import math
import threading

import numpy as np
from numba import njit, types
from numba.extending import intrinsic

ROUND = 6755399441055744.0  # 1.5 * 2^52: what is added and taken away again leaves an integer
_kept = threading.local()


def scratch(size):
    """Return an array (size,) that this thread keeps for later calls, on a boundary of the widest registers."""
    kept = _kept.__dict__
    if size not in kept:
        room = np.zeros(size + 8)
        start = -room.ctypes.data % 64 // 8
        kept[size] = room[start : start + size]
    return kept[size]


@intrinsic
def wide(_context):
    """Let the compiler use the widest registers in the function that calls this, and keep it a function of its own.

    LLVM takes half of AVX-512 on some processors, which costs these loops a third of their speed; and a loop that is
    inlined elsewhere would be optimised, slowly, once more.
    """

    def codegen(context, builder, _signature, _arguments):
        builder.function.attributes.add("noinline")
        set.add(builder.function.attributes, '"prefer-vector-width"="512"')  # which llvmlite does not know by name
        return context.get_dummy_value()

    return types.none(), codegen


@njit(error_model="numpy", fastmath={"contract"})
def _reduced(x):
    """Return r in -pi/4 .. pi/4 and the quarter turns, -2 .. 2, by which x is ahead of it."""
    turns = (x * 0.6366197723675814 + ROUND) - ROUND
    r = ((x - turns * 1.5707963267341256) - turns * 6.077100506303966e-11) - turns * 2.0222662487959506e-21
    return r, turns - 4.0 * ((0.25 * turns + ROUND) - ROUND)


@njit(error_model="numpy", fastmath={"contract"})
def _sine(r):
    z = r * r
    p = 1.58962301576546568060e-10 * z - 2.50507477628578072866e-8
    p = (p * z + 2.75573136213857245213e-6) * z - 1.98412698295895385996e-4
    p = (p * z + 8.33333333332211858878e-3) * z - 1.66666666666666307295e-1
    return r + r * z * p


@njit(error_model="numpy", fastmath={"contract"})
def _cosine(r):
    z = r * r
    p = -1.13585365213876817300e-11 * z + 2.08757008419747316778e-9
    p = (p * z - 2.75573141792967388112e-7) * z + 2.48015872888517045348e-5
    p = (p * z - 1.38888888888730564116e-3) * z + 4.16666666666665929218e-2
    return 1.0 - 0.5 * z + z * z * p


@njit(error_model="numpy", fastmath={"contract"})
def sine(x):
    """Return sin x."""
    r, quarter = _reduced(x)
    value = _cosine(r) if abs(quarter) == 1.0 else _sine(r)
    return -value if (abs(quarter) == 2.0) | (quarter == -1.0) else value


@njit(error_model="numpy", fastmath={"contract"})
def cosine(x):
    """Return cos x."""
    r, quarter = _reduced(x)
    value = _sine(r) if abs(quarter) == 1.0 else _cosine(r)
    return -value if (abs(quarter) == 2.0) | (quarter == 1.0) else value


@njit(error_model="numpy", fastmath={"contract"})
def tangent(x):
    """Return tan x."""
    return sine(x) / cosine(x)


@njit(error_model="numpy", fastmath={"contract"})
def arctangent(y, x):
    """Return the angle of the point (x, y), -pi .. pi; 0 for the origin."""
    a, b = abs(y), abs(x)
    small, large = (a, b) if a < b else (b, a)
    far = small > 0.66 * large
    above = small - large if far else small
    below = small + large if far else large
    t = above / (below if below != 0.0 else 1.0)
    z = t * t
    p = (-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1
    p = (p * z - 1.228866684490136173410e2) * z - 6.485021904942025371773e1
    q = ((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2
    q = (q * z + 4.853903996359136964868e2) * z + 1.945506571482613964425e2
    angle = t + t * (z * p / q)
    angle = angle + 0.25 * math.pi if far else angle
    angle = 0.5 * math.pi - angle if a >= b else angle
    angle = math.pi - angle if x < 0.0 else angle
    angle = 0.0 if below == 0.0 else angle
    return -angle if y < 0.0 else angle


@njit(error_model="numpy", fastmath={"contract"})
def arcsine(x):
    """Return asin x; NaN beyond -1 .. 1."""
    return arctangent(x, math.sqrt((1.0 - x) * (1.0 + x)))
