r"""A machine as it is written down: vectors and rotations instead of thousands of entries.

SymPy keeps the entries of ``B + R exp(v) e``, not the formula. Two things bring it back. Written in the algebra
`OPAQUE` a machine's rotations are functions of their arguments, ``exp_23(v)`` instead of polynomials; a vector of such
entries is linear in each rotation and in each earlier step, and `Reader` takes it apart accordingly::

    value = N M C + rest,        N_ik C_lj = d value_ij / d M_kl

for one known matrix M after the other, then for the known vectors. What it returns is equal to what it was given, entry
by entry; `Form.explicit` says so to a test. Where nothing is recognised, the entries stand as they are.
"""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import sympy as sp
from sympy.core.function import AppliedUndef

from derive.review import typeset as ts
from derive.review.typeset import Math, Shown
from derive.vectors import EXACT, Algebra

ROTATIONS = {
    "rotation_vector": "exp",
    "cayley": "cay",
    "turn_about_x": "R_x",
    "turn_about_y": "R_y",
    "turn_about_z": "R_z",
}


def _opaque(short: str) -> Callable[[sp.Expr | sp.Matrix], sp.Matrix]:
    def rotation(argument: sp.Expr | sp.Matrix) -> sp.Matrix:
        of = tuple(argument) if isinstance(argument, sp.MatrixBase) else (sp.sympify(argument),)
        return sp.Matrix(3, 3, lambda i, j: sp.Function(f"{short}_{i + 1}{j + 1}", real=True)(*of))

    return rotation


OPAQUE = Algebra(**{long: _opaque(short) for long, short in ROTATIONS.items()})


def exactly(expr: sp.Expr) -> sp.Expr:
    """Return an opaque expression with its rotations written out."""
    found = {}
    for f in expr.atoms(AppliedUndef):
        short, i, j = split(f)
        long = next(n for n, s in ROTATIONS.items() if s == short)
        argument = f.args[0] if long.startswith("turn") else sp.Matrix(f.args)
        found[f] = getattr(EXACT, long)(argument)[i, j]
    return expr.xreplace(found)


def split(f: AppliedUndef) -> tuple[str, int, int]:
    """Return the rotation's short name and the place of an opaque entry."""
    short, _, place = f.func.__name__.rpartition("_")
    return short, int(place[0]) - 1, int(place[1]) - 1


# --------------------------------------------------------------------------------------------------------- the forms


class Form(ABC):
    """A vector (3, 1) or matrix (3, 3) as a human writes it."""

    @abstractmethod
    def explicit(self) -> sp.Matrix:
        """Return the entries."""

    @abstractmethod
    def math(self, symbols: Shown) -> Math:
        """Return the formula."""


@dataclass(frozen=True)
class Named(Form):
    """A known vector or matrix."""

    name: str
    entries: sp.ImmutableMatrix
    shown: Math

    def explicit(self) -> sp.Matrix:
        """Return the entries."""
        return self.entries

    def math(self, symbols: Shown) -> Math:
        """Return its name."""
        return self.shown


@dataclass(frozen=True)
class Entries(Form):
    """Entries as they are."""

    entries: sp.ImmutableMatrix

    def explicit(self) -> sp.Matrix:
        """Return the entries."""
        return self.entries

    def math(self, symbols: Shown) -> Math:
        """Return the column or matrix."""
        if self.entries == sp.eye(3):
            return ts.letter("I", bold=True)
        inside = self.entries.applyfunc(tidy)
        if inside.shape == (3, 1) and sorted(inside, key=str) == [0, 0, 1]:
            return ts.sub(ts.letter("e", bold=True), ts.letter("xyz"[list(inside).index(1)]))
        return ts.matrix([[ts.expression(e, symbols) for e in inside.row(r)] for r in range(inside.rows)])


@dataclass(frozen=True)
class Product(Form):
    """A product of matrices, the last of which may be a vector."""

    factors: tuple[Form, ...]

    def explicit(self) -> sp.Matrix:
        """Return the entries."""
        whole = self.factors[0].explicit()
        for factor in self.factors[1:]:
            whole = whole * factor.explicit()
        return whole

    def math(self, symbols: Shown) -> Math:
        """Return the factors side by side; a scalar of the last one comes to the front."""
        whole = ts.EMPTY
        for n, f in enumerate(self.factors):
            shown = f.math(symbols)
            several = isinstance(f, Sum) and len(f.terms) > 1
            whole = whole + (ts.thin() if n else ts.EMPTY) + (ts.brackets(shown) if several else shown)
        return ts.row(whole)


@dataclass(frozen=True)
class Sum(Form):
    """A sum of forms with scalar factors."""

    terms: tuple[tuple[sp.Expr, Form], ...]

    def explicit(self) -> sp.Matrix:
        """Return the entries."""
        return sum((c * f.explicit() for c, f in self.terms[1:]), self.terms[0][0] * self.terms[0][1].explicit())

    def math(self, symbols: Shown) -> Math:
        """Return the sum, positive terms first."""
        whole = ts.EMPTY
        ordered = sorted(self.terms, key=lambda t: negative(t[0]))
        for n, (c, form) in enumerate(ordered):
            below = negative(c)
            size = -c if below else c
            sign = ts.op("−") if below else ts.op("+") if n else ts.EMPTY
            shown = form.math(symbols)
            whole = whole + sign + (shown if size == 1 else ts.row(_scalar(size, symbols), ts.thin(), shown))
        return ts.row(whole)


def negative(c: sp.Expr) -> bool:
    """Tell whether an expression is shown as minus another: all its terms are negative."""
    return all(term.could_extract_minus_sign() for term in sp.Add.make_args(c))


def _scalar(c: sp.Expr, symbols: Shown) -> Math:
    shown = ts.expression(c, symbols)
    return ts.brackets(shown) if c.is_Add else shown


def _content(entries: sp.Matrix) -> sp.Expr:
    """Return what all entries have in common, a sign aside."""
    some = [sp.expand(e) for e in entries if e != 0]
    if len(some) == 1 and entries.cols == 1:
        return some[0]
    if len(some) < 2 or any(e.is_number for e in some):
        return sp.Integer(1)
    shared = sp.gcd_list(some)
    shared = sp.Integer(1) if shared.is_number else shared
    numbers = [(e / shared).cancel().as_content_primitive()[0] for e in some]
    return shared * sp.gcd_list(numbers) if shared != 1 else shared


def _ratio(value: sp.Matrix, of: sp.Matrix) -> sp.Expr | None:
    """Return the scalar by which `value` is a multiple of another, or None."""
    if any((e == 0) != (o == 0) for e, o in zip(value, of, strict=True)) or value == sp.zeros(*value.shape):
        return None
    ratios = {sp.cancel(e / o) for e, o in zip(value, of, strict=True) if o != 0}
    return tidy(ratios.pop()) if len(ratios) == 1 else None


@cache
def tidy(expr: sp.Expr) -> sp.Expr:
    """Return the shortest of some equal ways to write a scalar."""
    expanded = sp.expand(expr)
    ways = [expr, expanded, sp.factor_terms(expr), sp.factor(expr)]
    ways += [sp.collect(expanded, s) for s in sorted(expr.free_symbols, key=str)]
    sizes = [sp.count_ops(e) for e in ways]
    shortest = {e for e, size in zip(ways, sizes, strict=True) if size == min(sizes)}
    return min(shortest, key=lambda e: (len(str(e)), str(e)))


# ---------------------------------------------------------------------------------------------------------- the reader

TRANSPOSED = "⊤"


class Reader:
    """Takes vectors, matrices and scalars apart into what is known by name.

    Parameters
    ----------
    vectors, matrices : mapping
        Name to entries, (3, 1) or (3, 3); entries may be zero. Earlier ones are tried first.
    shown : callable
        How a name is typeset.
    symbols : callable
        How a symbol is typeset, or None for the way of its name.
    transposes : bool
        Whether to look for matrices and rotations that are transposed, too.
    """

    def __init__(
        self,
        vectors: Mapping[str, sp.Matrix],
        matrices: Mapping[str, sp.Matrix],
        shown: Callable[[str], Math],
        symbols: Shown = lambda s: None,
        transposes: bool = False,
    ) -> None:
        self._dummies: dict[sp.Expr, sp.Symbol] = {}
        self._vectors = {n: self._plain(v).applyfunc(sp.expand) for n, v in vectors.items()}
        self._shown, self._symbols, self._transposes = shown, symbols, transposes
        self._matrices: dict[str, sp.Matrix] = {}
        for n, m in matrices.items():
            self._matrices |= self._both(n, self._plain(m))

    def _both(self, name: str, M: sp.Matrix) -> dict[str, sp.Matrix]:
        """Return a matrix by its name, and transposed where such are looked for."""
        return {name: M, f"{name}{TRANSPOSED}": M.T} if self._transposes else {name: M}

    def _plain(self, entries: sp.Matrix) -> sp.Matrix:
        """Return entries with applied functions as symbols, by which SymPy differentiates."""
        for f in sorted(entries.atoms(AppliedUndef), key=str):
            self._dummies.setdefault(f, sp.Symbol(f"\x01{len(self._dummies)}", real=True))
        return entries.xreplace(self._dummies)

    def _back(self, value: sp.Expr) -> sp.Expr:
        return value.xreplace({s: f for f, s in self._dummies.items()})

    def read(self, value: sp.Matrix) -> Form:
        """Return a vector (3, 1) or matrix (3, 3) as a form; equal to it entry by entry."""
        self._rotations(value)
        return self._read(self._plain(sp.Matrix(value)))

    def _rotations(self, value: sp.Matrix) -> None:
        """Get to know the rotations that occur."""
        for f in sorted(value.atoms(AppliedUndef), key=str):
            short, *_ = split(f)
            key = f"{short}{f.args}"
            if short in ROTATIONS.values() and key not in self._matrices:
                whole = _opaque(short)(sp.Matrix(f.args))
                self._matrices = {**self._both(key, self._plain(whole)), **self._matrices}

    def _named(self, name: str, entries: sp.Matrix) -> Named:
        if name.endswith(TRANSPOSED):
            of = self._named(name.removesuffix(TRANSPOSED), entries.T)
            return Named(name, sp.ImmutableMatrix(self._back(entries)), ts.transposed(of.shown))
        original = self._back(entries)
        f = next(iter(original.atoms(AppliedUndef)), None) if name not in self._vectors else None
        if f is not None and split(f)[0] in ROTATIONS.values() and name.startswith(split(f)[0]):
            return Named(name, sp.ImmutableMatrix(original), self.rotation(split(f)[0], f.args))
        return Named(name, sp.ImmutableMatrix(original), self._shown(name))

    def _read(self, value: sp.Matrix) -> Form:
        terms: list[tuple[sp.Expr, Form]] = []
        rest = value.applyfunc(sp.expand)
        for name, M in self._matrices.items():
            if not rest.free_symbols & M.free_symbols:
                continue
            if rest == M:
                terms.append((sp.Integer(1), self._named(name, M)))
                return self._summed(terms)
            found = self._product(rest, M)
            if found is None:
                continue
            N, C = found
            after = (rest - N * M * C).applyfunc(sp.expand)
            if after.free_symbols & M.free_symbols:
                continue
            terms.append(self._factors(N, name, M, C))
            rest = after
        rest = self._take_vectors(rest, terms) if rest.cols == 1 else self._take_matrices(rest, terms)
        if rest != sp.zeros(*rest.shape):
            factor = _content(rest)
            terms.append((factor, Entries(sp.ImmutableMatrix(self._back((rest / factor).applyfunc(sp.cancel))))))
        return self._summed(terms) if terms else Entries(sp.ImmutableMatrix(rest))

    def _summed(self, terms: list[tuple[sp.Expr, Form]]) -> Form:
        terms = [(tidy(self._back(c)), f) for c, f in terms]
        return terms[0][1] if len(terms) == 1 and terms[0][0] == 1 else Sum(tuple(terms))

    @staticmethod
    def _product(value: sp.Matrix, M: sp.Matrix) -> tuple[sp.Matrix, sp.Matrix] | None:
        """Return N and C with ``value = N M C + terms without M``, where there are such."""
        T: dict[tuple[int, int, int, int], sp.Expr] = {}
        for (i, e), (k, s) in itertools.product(enumerate(value), enumerate(M)):
            if s in e.free_symbols:
                slope = sp.expand(sp.diff(e, s))
                if slope.free_symbols & M.free_symbols:
                    return None
                T[(*divmod(i, value.cols), *divmod(k, 3))] = slope
        if not T:
            return None
        i0, j0, k0, l0 = min(T, key=lambda at: (at[0] != at[2], at))
        pivot = T[i0, j0, k0, l0]
        left = sp.Matrix(3, 3, lambda i, k: T.get((i, j0, k, l0), 0))
        right = sp.Matrix(3, value.cols, lambda l, j: T.get((i0, j, k0, l), 0))
        if left == pivot * sp.eye(3):
            N, C = sp.eye(3), right
        else:
            N, C = left, (right / pivot).applyfunc(sp.cancel)
        for at in itertools.product(range(3), range(value.cols), range(3), range(3)):
            i, j, k, l = at
            if sp.expand(T.get(at, 0) - N[i, k] * C[l, j]) != 0:
                return None
        return N, C

    def _factors(self, N: sp.Matrix, name: str, M: sp.Matrix, C: sp.Matrix) -> tuple[sp.Expr, Form]:
        scalar = sp.Integer(1)
        if C.shape == (3, 1) and (factor := _content(C)) != 1:
            scalar, C = factor, (C / factor).applyfunc(sp.cancel)
        parts: list[Form] = [] if sp.eye(3) == N else [self._read(N)]
        parts.append(self._named(name, M))
        if sp.eye(3) != C:
            parts.append(self._read(C))
        if isinstance(parts[-1], Sum) and len(parts[-1].terms) == 1:  # a scalar comes to the front
            c, last = parts[-1].terms[0]
            scalar, parts[-1] = scalar * c, last
        if isinstance(parts[0], Sum) and len(parts[0].terms) == 1:
            c, first = parts[0].terms[0]
            scalar, parts[0] = scalar * c, first
        return scalar, parts[0] if len(parts) == 1 else Product(tuple(parts))

    def _take_vectors(self, rest: sp.Matrix, terms: list[tuple[sp.Expr, Form]]) -> sp.Matrix:
        for name, V in (*self._vectors.items(), *self._vectors.items()):
            if not V.free_symbols or not rest.free_symbols & V.free_symbols:
                continue
            slope = _ratio(rest, V)
            if slope is None:
                slope = self._share(rest, V)
            if slope is None:
                continue
            terms.append((slope, self._named(name, V)))
            rest = (rest - slope * V).applyfunc(lambda e: sp.expand(sp.cancel(sp.expand(e))))
        return rest

    @staticmethod
    def _share(rest: sp.Matrix, V: sp.Matrix) -> sp.Expr | None:
        """Return how much of V is in `rest`, where its entries occur in it linearly and nowhere else."""
        slopes = set()
        for e, v in zip(rest, V, strict=True):
            if v != 0:
                factor, body = v.as_coeff_Mul()
                slopes.add(sp.expand(sp.expand(e).coeff(body) / factor))
        if len(slopes) != 1 or (slope := slopes.pop()) == 0:
            return None
        after = (rest - slope * V).applyfunc(sp.expand)
        for e, v in zip(after, V, strict=True):
            body = v.as_coeff_Mul()[1]
            if not v.is_number and (e.has(body) or slope.has(body)):
                return None
        return slope

    def _take_matrices(self, rest: sp.Matrix, terms: list[tuple[sp.Expr, Form]]) -> sp.Matrix:
        for name, M in self._matrices.items():
            if M.free_symbols and (slope := _ratio(rest, M)) is not None:
                terms.append((slope, self._named(name, M)))
                return sp.zeros(3, 3)
        return rest

    def rotation(self, short: str, argument: Sequence[sp.Expr]) -> Math:
        """Return ``exp(v)``, ``cay(c)`` or ``R_z(t)`` as a formula, its argument as a vector where that is one."""
        form = self.read(sp.Matrix(argument)) if len(argument) == 3 else None
        if (
            form is None
            or isinstance(form, Entries)
            or any(isinstance(f, Entries) for _, f in getattr(form, "terms", ()))
        ):
            inside = ts.separated(ts.expression(a, self._symbols) for a in argument)
        else:
            inside = form.math(self._symbols) if form is not None else ts.EMPTY
        return ts.row(rotation_name(short), ts.brackets(inside))

    # ------------------------------------------------------------------------------------------------- scalars

    def norms(self, expr: sp.Expr) -> tuple[list[tuple[sp.Expr, Form]], sp.Expr]:
        """Return a scalar as ``sum c |v|^2 + rest``: the factors with their vectors, and the rest."""
        expanded = sp.Add.make_args(sp.expand(expr, deep=False, multinomial=False, power_base=False))
        squares: dict[sp.Expr, list[sp.Expr]] = {}
        rest: list[sp.Expr] = []
        for term in expanded:
            c, body = term.as_coeff_Mul()
            base, exponent = body.as_base_exp()
            if exponent == 2 and c.is_positive:
                squares.setdefault(c, []).append(base)
            else:
                rest.append(term)
        found: list[tuple[sp.Expr, Form]] = []
        for c, bases in squares.items():
            vector = self._vector_of(bases) if 2 <= len(bases) <= 3 else None
            if vector is None:
                rest += [c * b**2 for b in bases]
            else:
                found.append((c, vector))
        return found, sp.Add(*rest)

    def _vector_of(self, entries: Sequence[sp.Expr]) -> Form | None:
        padded = [*entries, *[sp.Integer(0)] * (3 - len(entries))]
        for order in itertools.permutations(padded):
            form = self.read(sp.Matrix(order))
            if all(not isinstance(f, Entries) for _, f in getattr(form, "terms", ((1, form),))):
                return form
        return None

    def dots(self, expr: sp.Expr, moved: Mapping[str, sp.Matrix]) -> tuple[list[tuple[Form, Named]], sp.Expr]:
        """Return a scalar that is linear in vectors as ``sum g . v + rest``."""
        found: list[tuple[Form, Named]] = []
        for name, V in moved.items():
            slopes = sp.Matrix([sp.diff(expr, s) if s != 0 else 0 for s in V])
            if slopes == sp.zeros(3, 1):
                continue
            found.append((self.read(slopes), self._named(name, self._plain(V))))
            expr = expr - sum((g * s for g, s in zip(slopes, V, strict=True)), sp.Integer(0))
        return found, sp.expand(expr) if found else expr


def rotation_name(short: str) -> Math:
    """Return the name of a rotation: exp, cay, or R with its axis."""
    return ts.letter(short) if "_" not in short else ts.sub(ts.letter("R", bold=True), ts.letter(short[-1]))
