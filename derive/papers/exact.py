"""Numbers without rounding: rational machines, and machines over a prime field, whose square roots exist.

A rational machine has rational lengths, and rational sines, cosines and directions: what holds on it holds exactly. It
need not close from limb to limb, as no column of a linear model knows of the other limbs. A rank needs poses that
close. Over a prime field half of all numbers have a square root, so that poses are found by trying; a rank there is no
more than that of the real machine at a generic pose.
"""

from __future__ import annotations

import operator
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from derive import registry
from derive.spec import LimbMechanism

Number = Any  # of a field: a rational, or an element of a prime field
Values = Mapping[sp.Symbol, Number]
Rows = Sequence[Sequence[Number]]
SEED = 1


def limbs(name: str) -> LimbMechanism:
    """Return a registered machine of limbs."""
    found = registry.mechanism(name)
    if not isinstance(found, LimbMechanism):
        raise TypeError(f"{name} is no machine of limbs.")
    return found


def rational(rng: random.Random, least: int = 1, most: int = 9) -> sp.Rational:
    """Return a positive rational number."""
    return sp.Rational(rng.randint(least, most), rng.randint(1, 7))


def on_circle(rng: random.Random) -> tuple[sp.Rational, sp.Rational]:
    """Return a rational cosine and sine."""
    t = rational(rng) * rng.choice((-1, 1))
    return (1 - t**2) / (1 + t**2), 2 * t / (1 + t**2)


def on_sphere(rng: random.Random) -> tuple[sp.Rational, sp.Rational, sp.Rational]:
    """Return a rational unit vector."""
    u, v = rational(rng) * rng.choice((-1, 1)), rational(rng)
    size = 1 + u**2 + v**2
    return 2 * u / size, 2 * v / size, (size - 2) / size


class Field:
    """Integers by a prime that leaves 3 by 4, in which 3 has a square root."""

    def __init__(self, prime: int) -> None:
        self.prime = prime
        self.domain = sp.GF(prime, symmetric=False)
        root = self.root(self(3))
        if root is None or prime % 4 != 3:
            raise ValueError(f"{prime} leaves another remainder by 4 than 3, or 3 has no square root in it.")
        self.root3 = root

    def __call__(self, value: int | sp.Rational) -> Number:
        """Return a rational number as an element."""
        value = sp.Rational(value)
        return self.domain(int(value.p)) / self.domain(int(value.q))

    def any(self, rng: random.Random) -> Number:
        """Return an element drawn at random."""
        return self.domain(rng.randrange(1, self.prime))

    def root(self, square: Number) -> Number | None:
        """Return a square root, or None where there is none."""
        found = square ** ((self.prime + 1) // 4)
        return found if found * found == square else None

    def angle(self, A: Number, B: Number, C: Number) -> tuple[Number, Number] | None:
        """Return cosine and sine with ``A cos + B sin = C``, or None where there are none."""
        size = A * A + B * B
        root = self.root(size - C * C)
        if root is None or size == 0:
            return None
        return (A * C - B * root) / size, (B * C + A * root) / size

    def rank(self, rows: Sequence[Sequence[Number]]) -> int:
        """Return the rank of a matrix of elements."""
        return int(DomainMatrix([list(r) for r in rows], (len(rows), len(rows[0])), self.domain).rank())


PRIMES = (2305843009213693907, 2305843009213693487)  # the largest two below 2^61 that a `Field` can have


def evaluate(expr: sp.Expr, values: Values, number: Callable[[sp.Rational], Number] = sp.Rational) -> Number:
    """Return the value of a rational expression, exactly; `number` takes a rational number to the field."""
    if expr.is_Rational:
        return number(expr)
    if expr.is_Add or expr.is_Mul:
        parts = [evaluate(e, values, number) for e in expr.args]
        whole = parts[0]
        for part in parts[1:]:
            whole = whole + part if expr.is_Add else whole * part
        return whole
    if expr.is_Pow and expr.exp.is_Integer:
        return evaluate(expr.base, values, number) ** int(expr.exp)
    return values[expr]


# -------------------------------------------------------------------------------------------------- matrices as lists


def solved(A: Rows, B: Rows, domain: Any) -> list[list[Number]]:
    """Return ``A^-1 B`` over a field."""
    left = DomainMatrix([list(r) for r in A], (len(A), len(A)), domain)
    right = DomainMatrix([list(r) for r in B], (len(B), len(B[0])), domain)
    found: list[list[Number]] = left.lu_solve(right).to_list()
    return found


def dot(v: Sequence[Number], w: Sequence[Number]) -> Number:
    """Return the sum of the products of the entries."""
    return reduce(operator.add, map(operator.mul, v, w))


def product(A: Rows, B: Rows) -> list[list[Number]]:
    """Return ``A B``."""
    columns = list(zip(*B, strict=True))
    return [[dot(r, k) for k in columns] for r in A]


def minus(A: Rows) -> list[list[Number]]:
    """Return ``-A``."""
    return [[-x for x in r] for r in A]


def less(A: Rows, B: Rows) -> list[list[Number]]:
    """Return ``A - B``."""
    return [[x - y for x, y in zip(r, s, strict=True)] for r, s in zip(A, B, strict=True)]


def beside(A: Rows, B: Rows) -> list[list[Number]]:
    """Return ``[A, B]``."""
    return [[*x, *y] for x, y in zip(A, B, strict=True)]


@dataclass(frozen=True)
class Machine:
    """Limbs in numbers: values of all letters, limb by limb, and the field that they are of.

    Sines and cosines are letters, too: `plain` puts them in their places.
    """

    limbs: tuple[dict[sp.Symbol, Number], ...]
    domain: Any
    number: Callable[[sp.Rational], Number]

    def block(self, matrix: sp.Matrix, limb: int) -> list[list[Number]]:
        """Return a matrix of one limb in numbers."""
        return [[evaluate(e, self.limbs[limb], self.number) for e in matrix.row(r)] for r in range(matrix.rows)]

    def stacked(self, matrix: sp.Matrix) -> list[list[Number]]:
        """Return the rows of all limbs one below the other."""
        return [row for i in range(len(self.limbs)) for row in self.block(matrix, i)]

    def diagonal(self, matrix: sp.Matrix) -> list[list[Number]]:
        """Return the rows of all limbs as blocks on a diagonal."""
        width, zero, many = matrix.cols, self.number(sp.Integer(0)), len(self.limbs)
        return [
            [*[zero] * width * i, *row, *[zero] * width * (many - 1 - i)]
            for i in range(many)
            for row in self.block(matrix, i)
        ]


def rationals(limbs: Iterable[dict[sp.Symbol, sp.Rational]]) -> Machine:
    """Return a machine of rational numbers."""
    return Machine(
        tuple({s: sp.QQ.from_sympy(sp.Rational(v)) for s, v in k.items()} for k in limbs), sp.QQ, sp.QQ.from_sympy
    )


def plain(expr: sp.Expr | sp.Matrix) -> Any:
    """Return an expression with the sines and cosines of angles as letters of their own."""
    return expr.replace(lambda e: isinstance(e, sp.sin | sp.cos), turned)


def turned(e: sp.Expr) -> sp.Symbol:
    """Return the letter of a sine or cosine."""
    return sp.Symbol(f"{type(e).__name__}_{e.args[0]}")
