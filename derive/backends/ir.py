"""Kernels as typed nodes: what stands between the mathematics and the text of any target.

Expressions stay SymPy's until a target prints them. A *place* says where a number stands, not how a language writes
it: that is the target's layout.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

import sympy as sp

RATES = "_by"  # behind the name of an array: that of the rates of its numbers


@dataclass(frozen=True)
class Place:
    """Where a number stands.

    Parameters
    ----------
    array : str
        Name of a flat array, or of a number by itself.
    index : int, optional
        Entry of the array; None for a number by itself.
    lane : bool
        Whether there is one number for every lane, `index` being the first lane's.
    """

    array: str
    index: int | None = None
    lane: bool = False


@dataclass(frozen=True)
class Load:
    """A symbol gets the number at a place."""

    symbol: sp.Symbol
    place: Place


@dataclass(frozen=True)
class Assign:
    """A symbol gets the value of an expression of symbols known before."""

    symbol: sp.Symbol
    expr: sp.Expr


@dataclass(frozen=True)
class Store:
    """An entry of the result gets the value of an expression."""

    index: int
    expr: sp.Expr


@dataclass(frozen=True)
class Kernel:
    """A straight-line function from flat arrays to one flat array.

    Attributes
    ----------
    name, meaning : str
    loads : tuple of Load
    assigns : tuple of Assign
        In the order of evaluation.
    stores : tuple of Store
    length : int
        Length of the result; what is not stored is identically zero.
    """

    name: str
    meaning: str
    loads: tuple[Load, ...]
    assigns: tuple[Assign, ...]
    stores: tuple[Store, ...]
    length: int

    @property
    def expressions(self) -> Iterator[sp.Expr]:
        """What is computed, in order."""
        yield from (node.expr for node in self.assigns)
        yield from (node.expr for node in self.stores)

    @property
    def operations(self) -> int:
        """Arithmetic operations."""
        return int(sum(sp.count_ops(e) for e in self.expressions))

    @property
    def chooses(self) -> bool:
        """Whether it computes branches that are not taken."""
        return any(e.has(sp.Piecewise) for e in self.expressions)

    def only(self, stored: Collection[int]) -> Kernel:
        """Return the kernel that computes some entries of the result, and nothing else."""
        stores = tuple(s for s in self.stores if s.index in stored)
        needed = set().union(*(s.expr.free_symbols for s in stores))
        assigns: list[Assign] = []
        for node in reversed(self.assigns):
            if node.symbol in needed:
                assigns.insert(0, node)
                needed |= node.expr.free_symbols
        return replace(
            self,
            loads=tuple(load for load in self.loads if load.symbol in needed),
            assigns=tuple(assigns),
            stores=stores,
        )

    def reads(self, array: str) -> list[int | None]:
        """Return which entries of an array, or ``[None]`` of a number by itself, are loaded."""
        return [load.place.index for load in self.loads if load.place.array == array]
