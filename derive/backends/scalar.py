"""Python of single numbers: what Numba compiles, and what Python itself can run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

import sympy as sp
from sympy.printing.pycode import PythonCodePrinter

from derive.backends.ir import Kernel
from derive.backends.text import PRODUCTS, Lines, Names, arrays, written


class Python(PythonCodePrinter):
    """Small powers as products, roots by a function, rationals as decimals, symbols by the names of the text.

    Attributes
    ----------
    functions : mapping
        Name of SymPy's class to what the text calls the function.
    root : str
    """

    functions: ClassVar[Mapping[str, str]] = {}
    root: ClassVar[str] = "math.sqrt"

    def __init__(self, **settings: Any) -> None:
        super().__init__({"fully_qualified_modules": True, **settings})
        self.known_functions.update(self.functions)
        self.names: Names = {}

    def expression(self, expr: sp.Expr, names: Names | None = None) -> str:
        """Return the text of an expression."""
        self.names = names or {}
        return str(self.doprint(expr))

    def assignment(self, target: str, value: str) -> str:
        """Return the line that names a value."""
        return f"{target} = {value}"

    def parenthesize(self, item: sp.Expr, level: int, strict: bool = False) -> str:
        """Return an operand; a decimal needs no parentheses, though the fraction that it was does."""
        if item.is_Rational and not item.is_Integer and item > 0:
            return str(self._print(item))
        return str(super().parenthesize(item, level, strict))

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return self.names.get(expr) or str(super()._print_Symbol(expr))

    def _print_Rational(self, expr: sp.Rational) -> str:
        return repr(float(expr))

    def _print_Half(self, expr: sp.Expr) -> str:
        return "0.5"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        base = self.parenthesize(expr.base, 100)
        if expr.exp in PRODUCTS:
            return f"({' * '.join([base] * int(expr.exp))})"
        if expr.exp == -1:
            return f"(1.0 / {base})"
        if expr.exp == -2:
            return f"(1.0 / ({base} * {base}))"
        return str(self._hprint_Pow(expr, rational=rational, sqrt=self.root))


PRINTER = Python()


def expression(expr: sp.Expr) -> str:
    """Return the text of an expression."""
    return PRINTER.expression(expr)


def lines(kernel: Kernel) -> Lines:
    """Return the lines of a kernel of single numbers, which stand in arrays."""
    return written(kernel, PRINTER, arrays(), "out[{}]".format)
