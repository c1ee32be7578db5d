"""What all targets have in common: a kernel becomes lines, in the words of a printer and a layout."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp
from sympy.printing.codeprinter import CodePrinter

from derive.backends.ir import Kernel, Load, Place

PRODUCTS = (2, 3, 4)  # powers that are written as products: a call would cost as much as ten of them
Names = Mapping[sp.Symbol, str]  # of symbols that a text calls otherwise than the mathematics
Layout = Callable[[Place], str]


class Printer(CodePrinter, ABC):
    """Prints expressions in one language, symbols by the names of the text; stands before SymPy's printer of it.

    Attributes
    ----------
    both, either : str
        Operators of two conditions.
    """

    both: ClassVar[str]
    either: ClassVar[str]

    def __init__(self, settings: Mapping[str, Any] | None = None) -> None:
        super().__init__(settings)
        self.names: Names = {}

    def expression(self, expr: sp.Expr, names: Names | None = None) -> str:
        """Return the text of an expression."""
        self.names = names or {}
        return str(self.doprint(expr))

    @abstractmethod
    def assignment(self, target: str, value: str) -> str:
        """Return the line that names a value."""

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return self.names.get(expr) or str(super()._print_Symbol(expr))

    def _print_And(self, expr: sp.And) -> str:
        return self._joined(expr, self.both)

    def _print_Or(self, expr: sp.Or) -> str:
        return self._joined(expr, self.either)

    def _joined(self, expr: sp.And | sp.Or, by: str) -> str:
        return "(" + f" {by} ".join(map(self._print, sorted(expr.args, key=sp.default_sort_key))) + ")"


@dataclass(frozen=True)
class Lines:
    """A kernel as finished lines, without indentation."""

    loads: list[str]
    assigns: list[str]
    stores: list[str]

    @property
    def all(self) -> list[str]:
        """Lines of the kernel in the order in which they run."""
        return [*self.loads, *self.assigns, *self.stores]


def arrays(**forms: str) -> Layout:
    """Return the layout that writes the entries of each array by a form, ``{}`` standing for the index.

    An array without a form is written ``array[index]``, a number by itself by its name.
    """

    def place(at: Place) -> str:
        if at.index is None:
            return forms.get(at.array, at.array)
        return forms.get(at.array, f"{at.array}[{{}}]").format(at.index)

    return place


def written(
    kernel: Kernel, printer: Printer, layout: Layout, out: Callable[[int], str], names: Names | None = None
) -> Lines:
    """Return a kernel as lines.

    Parameters
    ----------
    out : callable
        Text of what an entry of the result is stored in.
    names : mapping, optional
        Names of symbols where they are not their own.
    """
    return Lines(
        loads=[line for load in kernel.loads for line in loaded(load, printer, layout, names)],
        assigns=[printer.assignment(_name(a.symbol, names), printer.expression(a.expr, names)) for a in kernel.assigns],
        stores=[f"{out(s.index)} = {printer.expression(s.expr, names)}" for s in kernel.stores],
    )


def loaded(load: Load, printer: Printer, layout: Layout, names: Names | None = None) -> list[str]:
    """Return the line that loads a symbol; none where it stands in an argument of its name."""
    target, place = _name(load.symbol, names), layout(load.place)
    return [] if target == place else [printer.assignment(target, place)]


def _name(symbol: sp.Symbol, names: Names | None) -> str:
    return (names or {}).get(symbol, str(symbol))
