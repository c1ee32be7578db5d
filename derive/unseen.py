r"""Which errors no reading sees, in closed form: the null space of the first-order closure over all poses at once.

Where the simplified limb is a sphere about ``c(q)`` (see `closed_form`), every pose of every limb is
``P = c(q) + rho n`` with a free joint q and a free unit vector n. Errors v, together with a motion of the frame in
which the instrument reads (shift t, turn w) and a turn k + m P of the platform that it does not read, are not seen if
the closure's first-order change vanishes at all of them::

    J_p v + J_x (t + w x P, k + m P) = 0        for all q and n

That is a polynomial in cos q, sin q (or q) and n; each of its coefficients, modulo ``cos^2 + sin^2 = n.n = 1``, is a
linear equation in v, t, w, k and m over the field of the geometry's symbols. No pose is chosen and no tolerance either.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from derive import closed_form
from derive.first_order import first_order
from derive.graph import expand_steps
from derive.spec import LimbMechanism

Numbers = Mapping[str, Sequence[float]]


def exact_angle(value: float) -> sp.Expr | None:
    """Return an angle as a rational multiple of pi with a denominator up to 36, or None."""
    ratio = sp.Rational(str(round(value / float(sp.pi), 12))).limit_denominator(36)
    return ratio * sp.pi if abs(float(ratio * sp.pi) - value) < 1e-9 else None


def _limb_values(mechanism: LimbMechanism, limb: int, numbers: Numbers) -> dict[sp.Symbol, sp.Expr] | None:
    """Return what is put for a limb's geometry: exact angles and sides; lengths stay symbols, of the limb if theirs."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for entry in mechanism.geometry:
        symbol, given = entry.quantity.symbol, numbers[entry.key]
        own = given[limb - 1] if entry.per_limb else given[0]
        if entry.quantity.unit == "rad":
            angle = exact_angle(own)
            if angle is None:
                return None
            found[symbol] = angle
        elif entry.quantity.unit == "1":
            found[symbol] = sp.nsimplify(own)
        elif entry.per_limb and len(set(given)) > 1:
            found[symbol] = sp.Symbol(f"{symbol}_{limb}", positive=True)
        else:
            found[symbol] = sp.Symbol(str(symbol), positive=True)
    return found


def equations(
    mechanism: LimbMechanism, numbers: Numbers
) -> tuple[list[sp.Symbol], list[sp.Symbol], list[sp.Expr]] | None:
    """Return the unknown errors, the unknown motions and the linear equations they obey; None where there is no sphere.

    Parameters
    ----------
    numbers : mapping
        Key of the robot file to the limbs' values [mm, rad]: which angles the limbs stand at, which lengths are equal.
    """
    try:
        centre, constant = closed_form.sphere(mechanism)
    except ValueError:
        return None
    dimension = mechanism.commanded
    steps, rates = first_order(mechanism)
    position = [quantity.symbol for quantity in mechanism.platform[:dimension]]
    turning = [quantity.symbol for quantity in mechanism.platform[dimension:]]
    q = mechanism.joint.symbol
    gone = dict.fromkeys((*(s.symbol for s in mechanism.deflections), *(s.symbol for s in mechanism.tool)), 0)
    nominal = dict.fromkeys((s.symbol for s in mechanism.varied), 0)
    n = sp.symbols("n_x n_y n_z", real=True)[:dimension]
    cos, sin = sp.symbols("cos sin", real=True)
    shift = sp.Matrix(sp.symbols("t_x t_y t_z", real=True)[:dimension])
    w = sp.Matrix(sp.symbols("w_x w_y w_z", real=True))
    k = [sp.Symbol(f"k_{s.name[1:]}", real=True) for s in turning]
    m = sp.Symbol("m", real=True)
    names = {quantity.symbol: sp.Symbol(quantity.name) for quantity in mechanism.common}
    closures = [
        (
            expand_steps(rate.get("errors", sp.Integer(0)), steps).xreplace(gone),
            [expand_steps(rate.get(str(s), sp.Integer(0)), steps).xreplace(gone) for s in turning],
        )
        for rate in rates
    ]
    found: list[sp.Expr] = []
    for limb in range(1, mechanism.limbs + 1):
        values = _limb_values(mechanism, limb, numbers)
        if values is None:
            return None
        at = centre.subs(nominal | gone).subs(values)
        square = sp.expand(sp.expand(at.dot(at) - 2 * constant.subs(nominal | gone).subs(values), trig=True))
        rho = sp.sqrt(sp.factor(sp.trigsimp(square)))
        P = at + rho * sp.Matrix(n)
        where = dict(zip(position, P, strict=True))
        flat = w[2] * sp.Matrix([-P[1], P[0]]) if dimension == 2 else sp.zeros(dimension, 1)
        moved = shift + (w.cross(P) if dimension == 3 else flat)
        own = {e.symbol: sp.Symbol(e.name_of(limb)) for e in mechanism.errors} | names
        for errors, turns in closures:
            change = errors.xreplace(values).xreplace(where).xreplace(own) + rho * sp.Matrix(n).dot(moved)
            by = [j.xreplace(values).xreplace(where) for j in turns]
            turned = [c + (m * P[j] if len(k) == 3 else 0) for j, c in enumerate(k)]
            change += sum(slope * turn for slope, turn in zip(by, turned, strict=True))
            change = sp.expand(sp.expand(change, trig=True).subs({sp.cos(q): cos, sp.sin(q): sin}))
            free = (cos, sin, *n) if change.has(cos) or change.has(sin) else (q, *n)
            found += _coefficients(change, free, {n[-1]: 1 - sum(e**2 for e in n[:-1]), sin: 1 - cos**2})
    every = [sp.Symbol(name) for name in mechanism.parameter_names]
    used = set().union(*(e.free_symbols for e in found))
    motions = [s for s in (*shift, *w, *k, m) if s in used]
    return every, motions, found


def _coefficients(change: sp.Expr, free: Sequence[sp.Symbol], squares: Mapping[sp.Symbol, sp.Expr]) -> list[sp.Expr]:
    """Return the coefficients of a polynomial in the free variables, whose squares obey a relation."""
    reduced: dict[tuple[int, ...], sp.Expr] = {}
    todo = list(sp.Poly(change, *free).terms())
    while todo:
        powers, coefficient = todo.pop()
        place = next((j for j, s in enumerate(free) if powers[j] >= 2 and s in squares), None)
        if place is None:
            reduced[powers] = reduced.get(powers, sp.Integer(0)) + coefficient
            continue
        rest = sp.Integer(1)
        for j, s in enumerate(free):
            rest *= s ** (powers[j] - 2 * (j == place))
        todo += sp.Poly(coefficient * rest * squares[free[place]], *free).terms()
    return [e for c in reduced.values() if (e := sp.expand(c)) != 0]


class _Number:
    """``a + b sqrt(d)`` with a, b rational functions of the geometry: what angles of 30 or 45 deg leave."""

    __slots__ = ("a", "b", "d")

    def __init__(self, a: Any, b: Any, d: int) -> None:
        self.a, self.b, self.d = a, b, d

    def __bool__(self) -> bool:
        return bool(self.a or self.b)

    def __sub__(self, other: _Number) -> _Number:
        return _Number(self.a - other.a, self.b - other.b, self.d)

    def __mul__(self, other: _Number) -> _Number:
        a = self.a * other.a + (self.b * other.b * self.d if self.b and other.b else 0)
        return _Number(a, self.a * other.b + self.b * other.a, self.d)

    def __truediv__(self, other: _Number) -> _Number:
        if not other.b:
            return _Number(self.a / other.a, self.b / other.a, self.d)
        norm = other.a**2 - other.b**2 * self.d
        return self * _Number(other.a / norm, -other.b / norm, self.d)

    @property
    def size(self) -> int:
        """How long it is."""
        return sum(len(e.numer.terms()) + len(e.denom.terms()) for e in (self.a, self.b) if e)


_Row = dict[int, _Number]


class NullSpace:
    """All errors and motions that the equations allow; models and instruments are parts of it.

    Exact elimination, once; equations are short, and pivots are taken where they stay so.

    Parameters
    ----------
    errors, motions, found
        Of `equations`.

    Raises
    ------
    ValueError
        More than one square root occurs.
    """

    def __init__(self, errors: Sequence[sp.Symbol], motions: Sequence[sp.Symbol], found: Sequence[sp.Expr]) -> None:
        self._columns = {s: j for j, s in enumerate((*motions, *errors))}
        self._first = len(motions)
        halves = {r for e in found for r in e.atoms(sp.Pow) if r.exp.is_Rational and r.exp.q == 2}
        lengths = sorted({r.base for r in halves if not r.base.is_Integer}, key=str)  # their roots are lengths too
        named = {base: sp.Symbol(f"root_{j}", positive=True) for j, base in enumerate(lengths)}
        found = [e.xreplace({r: named[r.base] ** (2 * r.exp) for r in halves if r.base in named}) for e in found]
        roots = {sp.sqrt(r.base) for r in halves if r.base.is_Integer}
        if len(roots) > 1:
            raise ValueError("more than one square root occurs.")
        self._root = next(iter(roots), sp.Integer(1))
        self._back = {s: sp.sqrt(base) for base, s in named.items()}
        symbols = sorted(set().union(*(e.free_symbols for e in found)) - set(self._columns), key=str)
        self._field = sp.QQ.frac_field(*symbols) if symbols else sp.QQ.frac_field(sp.Symbol("one"))
        rows = []
        for e in found:
            slopes = {s: sp.diff(e, s) for s in e.free_symbols if s in self._columns}
            rows.append({self._columns[s]: n for s, slope in slopes.items() if (n := self._number(slope))})
        self._basis = self._solutions(_eliminated(rows, self._first), len(self._columns))

    def _number(self, e: sp.Expr) -> _Number:
        mark = sp.Symbol("root")
        e = sp.expand(e).subs(self._root, mark) if self._root != 1 else e
        a, b = (self._field.from_sympy(e.coeff(mark, n)) for n in (0, 1))
        return _Number(a, b, int(self._root**2))

    def _solutions(self, solved: dict[int, _Row], count: int) -> list[_Row]:
        """Return a basis of what solved equations in `count` unknowns leave free."""
        zero, one = (_Number(n, self._field.zero, int(self._root**2)) for n in (self._field.zero, self._field.one))
        basis: list[_Row] = []
        for free in (j for j in range(count) if j not in solved):
            basis.append({j: zero - row[free] for j, row in solved.items() if free in row} | {free: one})
        return basis

    def of(
        self, errors: Sequence[sp.Symbol], motions: Sequence[sp.Symbol], tied: Mapping[sp.Symbol, sp.Symbol]
    ) -> list[dict[str, sp.Expr]]:
        """Return a basis of the errors of a model that some of the motions make invisible.

        Motions that are `tied` to others are equal to them; all other unknowns are zero.
        """
        free = {*errors, *motions, *tied}
        conditions: list[_Row] = []
        for s, j in self._columns.items():
            if s not in free:
                conditions.append({n: row[j] for n, row in enumerate(self._basis) if j in row})
        for s, to in tied.items():
            left, right = self._columns[s], self._columns[to]
            both = [(n, row.get(left), row.get(right)) for n, row in enumerate(self._basis)]
            zero = _Number(self._field.zero, self._field.zero, int(self._root**2))
            conditions.append({n: e for n, a, b in both if (e := (a or zero) - (b or zero))})
        kept = self._solutions(_eliminated(conditions, 0), len(self._basis))
        vectors = []
        for combination in kept:
            vector: _Row = {}
            for n, much in combination.items():
                vector = _plus(vector, much, self._basis[n])
            vectors.append({j: e for j, e in vector.items() if j >= self._first})
        names = list(self._columns)
        return [
            {str(names[j]): self._expression(value) for j, value in sorted(row.items())}
            for row in _eliminated(vectors, 0).values()
        ]

    def _expression(self, value: _Number) -> sp.Expr:
        a, b = self._field.to_sympy(value.a), self._field.to_sympy(value.b)
        return (a + b * self._root).xreplace(self._back)


def _plus(row: _Row, much: _Number, other: _Row) -> _Row:
    """Return a row and so much of another one."""
    out = dict(row)
    zero = much - much
    for j, value in other.items():
        out[j] = out.get(j, zero) - (zero - much) * value
    return {j: value for j, value in out.items() if value}


def _eliminated(rows: list[_Row], first: int) -> dict[int, _Row]:
    """Return the rows solved for one column each; columns before `first` are solved for where they can be."""
    todo = [row for row in rows if row]
    solved: dict[int, _Row] = {}
    while todo:
        pick = min(
            ((j >= first, len(row), value.size, j, n) for n, row in enumerate(todo) for j, value in row.items()),
        )
        column, row = pick[3], todo.pop(pick[4])
        pivot = row[column]
        row = {j: value / pivot for j, value in row.items()}
        todo = [other for other in (_without(other, column, row) for other in todo) if other]
        solved = {j: _without(other, column, row) for j, other in solved.items()} | {column: row}
    return solved


def _without(row: _Row, column: int, solved: _Row) -> _Row:
    return _plus(row, row[column] - row[column] - row[column], solved) if column in row else row
