# Copied from derive/support/elementary.py by "deltacal kernels". Do not edit.

"""Elementary functions without branches and calls, for loops that a compiler turns into SIMD code.

Cody and Waite 1980 reduction by pi/2 in three parts, and the polynomials of Moshier's Cephes: within 2 units in the
last place, or 1e-15 absolute, for arguments up to 1e5 rad. A NaN goes through.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from llvmlite import ir
from numba import njit, types
from numba.core import cgutils
from numba.extending import intrinsic

from .straight import check_layout, exponent, flipped, fraction, odd, power, widen

ROUND = 6755399441055744.0  # 1.5 * 2^52: what is added to it is rounded to an integer, and stands in its last bits


def aligned(size: int) -> np.ndarray:
    """Return an array (size,) of zeros on a boundary of the widest registers."""
    room = np.zeros(size + 8)
    start = -room.ctypes.data % 64 // 8
    return room[start : start + size]


def copied(values: np.ndarray) -> np.ndarray:
    """Return a copy of an array (size,), `aligned`."""
    found = aligned(len(values))
    found[:] = values
    return found


@njit(error_model="numpy", inline="always")
def scratch(size: int) -> np.ndarray:
    """Return an array (size,) for a compiled function to compute with, `aligned`; what stands in it is left over.

    Taken anew by every call, and at once: to be handed one by Python takes longer.
    """
    room = np.empty(size + 8)
    return room[(64 - room.ctypes.data % 64) % 64 // 8 :]


@intrinsic
def wide(_context: Any) -> Any:
    """`widen` the function that calls this."""

    def codegen(context: Any, builder: Any, _signature: Any, _arguments: Any) -> Any:
        widen(builder.function)
        return context.get_dummy_value()

    return types.none(), codegen


TRANSPOSED = {1: (0, 8, 2, 10, 4, 12, 6, 14), 2: (0, 1, 8, 9, 4, 5, 12, 13), 4: (0, 1, 2, 3, 8, 9, 10, 11)}


def _transposed(builder: Any, columns: Sequence[Any]) -> Sequence[Any]:
    """Return the eight rows of eight columns: vectors of eight numbers."""
    for apart, order in TRANSPOSED.items():
        pairs = [(columns[j], columns[j + apart]) for j in range(8) if not j & apart]
        picks = [_numbers(k + s for k in order) for s in (0, apart)]
        first, second = ([builder.shuffle_vector(*pair, pick) for pair in pairs] for pick in picks)
        columns = [(second if j & apart else first)[j // (2 * apart) * apart + j % apart] for j in range(8)]
    return columns


def _numbers(values: Iterable[int]) -> Any:
    every = list(values)
    return ir.Constant(ir.VectorType(ir.IntType(32), len(every)), every)


@intrinsic(prefer_literal=True)
def outer(
    _context: Any,
    out: Any,
    at: Any,
    pitch: Any,
    width: Any,
    rows: Any,
    w: Any,
    factors: Any,
    step: Any,
    values: Any,
    lanes: Any,
    count: Any,
) -> Any:
    """Multiply factors and values of eight poses side by side, and write the products pose by pose.

    ``out[at + pose * pitch + r * width + c]`` becomes the sum of ``w[factors[j] + r * step + pose]`` times
    ``w[values[j] + c * lanes + pose]`` over j, for ``r < rows``, ``c < count`` (up to 8). Compilers write such arrays
    number by number; here eight values of a pose are brought into one register, where they stay for all rows.
    """
    if not isinstance(count, types.IntegerLiteral) or not isinstance(lanes, types.IntegerLiteral):
        return None
    many, apart = count.literal_value, lanes.literal_value
    vector, contract = ir.VectorType(ir.DoubleType(), 8), ("contract",)

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        _, at, pitch, width, rows, _, factors, step, values = arguments[:9]
        data = [context.make_array(signature.args[j])(context, builder, arguments[j]).data for j in (0, 5)]
        nothing = ir.Constant(vector, ir.Undefined)

        def place(array: int, *offsets: Any) -> Any:
            total = offsets[0]
            for offset in offsets[1:]:
                total = builder.add(total, offset if isinstance(offset, ir.Value) else ir.Constant(total.type, offset))
            return builder.gep(data[array], [total])

        def column(j: int, c: int) -> Any:
            start = place(1, builder.extract_value(values, j), c * apart)
            return builder.load(builder.bitcast(start, vector.as_pointer()), align=8)

        terms = range(len(signature.args[6]))
        turned = [_transposed(builder, [column(j, c) if c < many else nothing for c in range(8)]) for j in terms]
        with cgutils.for_range(builder, rows) as loop:
            for pose in range(8):
                total = None
                for j in terms:
                    factor = place(1, builder.extract_value(factors, j), builder.mul(loop.index, step), pose)
                    factor = builder.insert_element(nothing, builder.load(factor), ir.Constant(ir.IntType(32), 0))
                    factor = builder.shuffle_vector(factor, nothing, _numbers([0] * 8))
                    term = builder.fmul(factor, turned[j][pose], flags=contract)
                    total = term if total is None else builder.fadd(total, term, flags=contract)
                total = builder.shuffle_vector(total, nothing, _numbers(range(many)))
                row = builder.mul(loop.index, width)
                start = place(0, at, row, builder.mul(pitch, ir.Constant(pitch.type, pose)))
                builder.store(total, builder.bitcast(start, total.type.as_pointer()), align=8)
        return context.get_dummy_value()

    return types.none(out, at, pitch, width, rows, w, factors, step, values, lanes, count), codegen


@intrinsic(prefer_literal=True)
def outer_of(
    _context: Any,
    out: Any,
    at: Any,
    pitch: Any,
    width: Any,
    rows: Any,
    w: Any,
    pose: Any,
    step: Any,
    factors: Any,
    values: Any,
    columns: Any,
    start: Any,
    terms: Any,
) -> Any:
    """Like `outer`, for eight chosen columns, ``columns[start : start + 8]``, the last again where there are no more.

    The places of factors and values stand in arrays (terms, number of columns); w counts from `pose`.
    """
    check_layout("outer_of", out, w, columns)
    if not isinstance(terms, types.IntegerLiteral):
        return None
    many = terms.literal_value

    def codegen(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        (_, at, pitch, width, rows, _, pose, step), start = arguments[:8], arguments[11]
        arrays = {j: context.make_array(signature.args[j])(context, builder, arguments[j]) for j in (0, 5, 8, 9, 10)}
        vector, number = ir.VectorType(ir.DoubleType(), 8), start.type

        def load(j: int, index: Any) -> Any:
            return builder.load(builder.gep(arrays[j].data, [index]))

        def eight(*offsets: Any) -> Any:
            total = pose
            for offset in offsets:
                total = builder.add(total, offset)
            return builder.load(builder.bitcast(builder.gep(arrays[5].data, [total]), vector.as_pointer()), align=8)

        last = builder.sub(builder.extract_value(arrays[10].shape, 0), number(1))
        apart = builder.extract_value(arrays[8].shape, 1)
        places = []
        for c in range(8):
            index = builder.add(start, number(c))
            column = load(10, builder.select(builder.icmp_signed("<", index, last), index, last))
            terms = [builder.add(column, builder.mul(apart, number(t))) for t in range(many)]
            places.append([(load(8, term), load(9, term)) for term in terms])
        with cgutils.for_range(builder, rows) as loop:
            row = builder.mul(loop.index, step)
            sums = []
            for column in places:
                total = None
                for factor, value in column:
                    term = builder.fmul(eight(factor, row), eight(value), flags=("contract",))
                    total = term if total is None else builder.fadd(total, term, flags=("contract",))
                sums.append(total)
            first = builder.add(at, builder.mul(loop.index, width))
            for j, numbers in enumerate(_transposed(builder, sums)):
                place = builder.gep(arrays[0].data, [builder.add(first, builder.mul(pitch, number(j)))])
                builder.store(numbers, builder.bitcast(place, vector.as_pointer()), align=8)
        return context.get_dummy_value()

    return types.none(out, at, pitch, width, rows, w, pose, step, factors, values, columns, start, terms), codegen


@njit(error_model="numpy", fastmath={"contract"})
def _reduced(x: float) -> tuple[float, float]:
    """Return r in -pi/4 .. pi/4, and the quarter turns by which x is ahead of it, in the last bits of a number."""
    counted = x * 0.6366197723675814 + ROUND
    turns = counted - ROUND
    return ((x - turns * 1.5707963267341256) - turns * 6.077100506303966e-11) - turns * 2.0222662487959506e-21, counted


@njit(error_model="numpy", fastmath={"contract"})
def _sine(r: float) -> float:
    z = r * r
    p = 1.58962301576546568060e-10 * z - 2.50507477628578072866e-8
    p = (p * z + 2.75573136213857245213e-6) * z - 1.98412698295895385996e-4
    p = (p * z + 8.33333333332211858878e-3) * z - 1.66666666666666307295e-1
    return r + r * z * p


@njit(error_model="numpy", fastmath={"contract"})
def _cosine(r: float) -> float:
    z = r * r
    p = -1.13585365213876817300e-11 * z + 2.08757008419747316778e-9
    p = (p * z - 2.75573141792967388112e-7) * z + 2.48015872888517045348e-5
    p = (p * z - 1.38888888888730564116e-3) * z + 4.16666666666665929218e-2
    return 1.0 - 0.5 * z + z * z * p


@njit(error_model="numpy", fastmath={"contract"})
def sine(x: float) -> float:
    """Return sin x."""
    r, counted = _reduced(x)
    return flipped(_cosine(r) if odd(counted) else _sine(r), counted)


@njit(error_model="numpy", fastmath={"contract"})
def cosine(x: float) -> float:
    """Return cos x."""
    r, counted = _reduced(x)
    return flipped(_sine(r) if odd(counted) else _cosine(r), counted + 1.0)


@njit(error_model="numpy", fastmath={"contract"})
def tangent(x: float) -> float:
    """Return tan x."""
    return sine(x) / cosine(x)


@njit(error_model="numpy", fastmath={"contract"})
def arctangent(y: float, x: float) -> float:
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
def arcsine(x: float) -> float:
    """Return asin x; NaN beyond -1 .. 1."""
    return arctangent(x, math.sqrt((1.0 - x) * (1.0 + x)))


@njit(error_model="numpy", fastmath={"contract"})
def exponential(x: float) -> float:
    """Return e to the power x."""
    x = 710.0 if x > 710.0 else x  # beyond, and below -746, the result is infinite, and zero
    x = -746.0 if x < -746.0 else x
    counted = x * 1.4426950408889634 + ROUND
    twos = counted - ROUND
    r = (x - twos * 6.93145751953125e-1) - twos * 1.42860682030941723212e-6
    z = r * r
    p = r * ((1.26177193074810590878e-4 * z + 3.02994407707441961300e-2) * z + 9.99999999999999999910e-1)
    q = (3.00198505138664455042e-6 * z + 2.52448340349684104192e-3) * z + 2.27265548208155028766e-1
    half = twos * 0.5 + ROUND  # two powers: one alone may be no number of its own
    return (1.0 + 2.0 * p / (q * z + 2.0 - p)) * power(half) * power(twos - (half - ROUND) + ROUND)


@njit(error_model="numpy", fastmath={"contract"})
def logarithm(x: float) -> float:
    """Return the natural logarithm: -inf at 0, NaN below."""
    tiny = x < 2.2250738585072014e-308
    y = x * 18014398509481984.0 if tiny else x
    m, e = fraction(y), exponent(y) - (4503599627370496.0 + 1023.0)
    high = m > 1.4142135623730951
    m = 0.5 * m if high else m
    e = (e + 1.0 if high else e) - (54.0 if tiny else 0.0)
    r = m - 1.0
    z = r * r
    p = (1.01875663804580931796e-4 * r + 4.97494994976747001425e-1) * r + 4.70579119878881725854
    p = ((p * r + 1.44989225341610930846e1) * r + 1.79368678507819816313e1) * r + 7.70838733755885391666
    q = ((r + 1.12873587189167450590e1) * r + 4.52279145837532221105e1) * r + 8.29875266912776603211e1
    q = (q * r + 7.11544750618563894466e1) * r + 2.31251620126765340583e1
    found = r * (z * p / q) - e * 2.121944400546905827679e-4 - 0.5 * z
    found = r + found + e * 0.693359375
    found = math.inf if x == math.inf else found
    return found if x > 0.0 else (-math.inf if x == 0.0 else math.nan)


@njit(error_model="numpy", fastmath={"contract"})
def hyperbolic_tangent(x: float) -> float:
    """Return tanh x."""
    z = x * x
    p = (-9.64399179425052238628e-1 * z - 9.92877231001918586564e1) * z - 1.61468768441708447952e3
    q = ((z + 1.12811678491632931402e2) * z + 2.23548839060100448583e3) * z + 4.84406305325125486048e3
    size = abs(x)
    far = 1.0 - 2.0 / (exponential(2.0 * size) + 1.0)
    return x + x * (z * p / q) if size < 0.625 else (far if x > 0.0 else -far)


@njit(error_model="numpy", fastmath={"contract"})
def larger(a: float, b: float) -> float:
    """Return the larger of two numbers; NaN where one of them is."""
    return a if (a > b) | (a != a) else b


@njit(error_model="numpy", fastmath={"contract"})
def smaller(a: float, b: float) -> float:
    """Return the smaller of two numbers; NaN where one of them is."""
    return a if (a < b) | (a != a) else b
