"""The nominal machine's differential, in a paper's letters: what stands in each column of a linear error model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache

import sympy as sp

from derive.first_order import first_order
from derive.graph import expand_steps
from derive.spec import LimbMechanism


def vector(name: str) -> sp.Matrix:
    """Return a vector (3, 1) of symbols, called by its name and x, y, z."""
    return sp.Matrix(sp.symbols(" ".join(f"{name}_{axis}" for axis in "xyz"), real=True))


@cache
def differentials(mechanism: LimbMechanism, rods: tuple[str, ...]) -> tuple[dict[sp.Symbol, sp.Expr], ...]:
    """Return the derivatives of each closure of a limb at nominal geometry, by all that it is made of.

    Parameters
    ----------
    mechanism : LimbMechanism
        As it is registered.
    rods : tuple of str
        Steps that stay letters, because the paper has a letter for them: the vectors along the rods.
    """
    known = (*mechanism.platform, mechanism.joint, *mechanism.errors, *mechanism.common)
    directions = {str(k.symbol): {k.symbol: sp.Integer(1)} for k in known}
    steps, closures = first_order(mechanism, directions)
    letters = {f"{rod}_{axis}" for rod in rods for axis in "xyz"}
    written_out = [(symbol, e) for symbol, e in steps if str(symbol) not in letters]
    return tuple({k.symbol: expand_steps(rates[str(k.symbol)], written_out) for k in known} for rates in closures)


@dataclass(frozen=True)
class Term:
    """A named matrix of a paper times a scalar."""

    factor: sp.Expr
    name: str

    def __str__(self) -> str:
        size = -self.factor if self.factor.could_extract_minus_sign() else self.factor
        scalar = sp.sstr(size)
        if self.name == "1":
            shown = scalar
        elif size == 1:
            shown = self.name
        else:
            shown = f"{self.name} {f'({scalar})' if size.is_Add else scalar}"
        return shown if size == self.factor else f"-{shown}"


class Dictionary:
    """The named vectors and matrices of a paper, in the order in which a derived one is looked up among them.

    Parameters
    ----------
    named : mapping
        Name to row or matrix, in the paper's symbols.
    variables : iterable of Symbol
        What a factor may not hold: the components of the vectors that the paper names.
    """

    def __init__(self, named: Mapping[str, sp.Matrix], variables: Iterable[sp.Symbol]) -> None:
        self.named = dict(named)
        self._variables = set(variables)

    def terms(self, *names: str | Mapping[str, sp.Expr | int]) -> list[Term]:
        """Return terms by their names; of a mapping with factors, a minus before a name belongs to the factor."""
        given = [pair for name in names for pair in (name.items() if isinstance(name, Mapping) else [(name, 1)])]
        return [Term(sp.sympify(k) * (-1 if n.startswith("-") else 1), n.removeprefix("-")) for n, k in given]

    def value(self, term: Term) -> sp.Matrix:
        """Return the entries of a term."""
        return term.factor * self.named[term.name]

    def read(self, value: sp.Matrix) -> str:
        """Return a derived row or matrix in the paper's names; entry by entry where no name is a multiple of it."""
        for name, known in self.named.items():
            if known.shape == value.shape and (factor := self._factor(value, known)) is not None:
                return str(Term(factor, name))
        return "[" + ", ".join(sp.sstr(sp.simplify(e)) for e in value) + "]"

    def _factor(self, value: sp.Matrix, known: sp.Matrix) -> sp.Expr | None:
        """Return the scalar by which `value` is a multiple of a known matrix, or None."""
        pivot = next((k for k, e in enumerate(known) if e != 0), None)
        if pivot is None:
            return None
        factor = sp.simplify(value[pivot] / known[pivot])
        if factor == 0 or factor.free_symbols & self._variables or not vanishes(value - factor * known):
            return None
        return factor


def vanishes(value: sp.Expr | sp.Matrix) -> bool:
    """Tell whether all entries are identically zero."""
    expanded = [sp.expand(e) for e in sp.Matrix([value])]
    return all(e == 0 or sp.simplify(e) == 0 for e in expanded)
