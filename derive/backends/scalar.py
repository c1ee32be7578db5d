"""Python of single numbers: what Numba compiles, and what Python itself can run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from typing import Any, ClassVar

import sympy as sp
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pycode import PythonCodePrinter

from derive.backends.ir import Kernel
from derive.backends.text import PRODUCTS, Lines, Printer, arrays, written


class Python(Printer, PythonCodePrinter):
    """Small powers as products, roots by a function, rationals as decimals, symbols by the names of the text.

    Attributes
    ----------
    functions : mapping
        Name of SymPy's class to what the text calls the function.
    root, floor, larger, smaller : str
        What the text calls the square root, the next integer below, the larger and the smaller of two numbers.
    """

    both: ClassVar[str] = "&"
    either: ClassVar[str] = "|"
    functions: ClassVar[Mapping[str, str]] = {}
    root: ClassVar[str] = "math.sqrt"
    floor: ClassVar[str] = "math.floor"
    larger: ClassVar[str] = "max"
    smaller: ClassVar[str] = "min"

    def __init__(self, **settings: Any) -> None:
        super().__init__({"fully_qualified_modules": True, **settings})
        self.known_functions.update(self.functions)

    def assignment(self, target: str, value: str) -> str:
        """Return the line that names a value."""
        return f"{target} = {value}"

    def parenthesize(self, item: sp.Expr, level: int, strict: bool = False) -> str:
        """Return an operand; a decimal needs no parentheses, though the fraction that it was does."""
        if item.is_Rational and not item.is_Integer and item > 0:
            return str(self._print(item))
        return str(super().parenthesize(item, level, strict))

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

    def _print_floor(self, expr: sp.floor) -> str:
        return f"{self.floor}({self._print(expr.args[0])})"

    def _print_Mod(self, expr: sp.Mod) -> str:
        value, by = (self.parenthesize(arg, PRECEDENCE["Pow"]) for arg in expr.args)
        return f"({value} - {by} * {self.floor}({value} / {by}))"

    def _print_Max(self, expr: sp.Max) -> str:
        return reduce(lambda first, second: f"{self.larger}({first}, {second})", map(self._print, expr.args))

    def _print_Min(self, expr: sp.Min) -> str:
        return reduce(lambda first, second: f"{self.smaller}({first}, {second})", map(self._print, expr.args))

    def _print_sign(self, expr: sp.sign) -> str:
        value = self.parenthesize(expr.args[0], PRECEDENCE["Pow"])
        return self._chosen([(f"({value} > 0)", "1.0"), (f"({value} < 0)", "-1.0")], f"(0.0 * {value})")

    def _print_Heaviside(self, expr: sp.Heaviside) -> str:
        value, at_zero = map(self._print, expr.args)
        return self._chosen([(f"({value} > 0)", "1.0"), (f"({value} < 0)", "0.0")], f"({at_zero} + {value})")

    def _print_Piecewise(self, expr: sp.Piecewise) -> str:
        *cases, (last, _) = expr.args
        return self._chosen([(self._print(c), self._print(e)) for e, c in cases], self._print(last))

    def _chosen(self, cases: Sequence[tuple[str, str]], last: str) -> str:
        """Return the text of the first value whose condition holds, of (condition, value), or the last one."""
        for condition, value in reversed(cases):
            last = f"({value} if {condition} else {last})"
        return last


PRINTER = Python()


def expression(expr: sp.Expr) -> str:
    """Return the text of an expression."""
    return PRINTER.expression(expr)


def lines(kernel: Kernel) -> Lines:
    """Return the lines of a kernel of single numbers, which stand in arrays."""
    return written(kernel, PRINTER, arrays(), "out[{}]".format)
