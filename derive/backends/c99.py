"""C99 for a controller."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import ClassVar

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import PRECEDENCE

from derive.backends.ir import Kernel, Place
from derive.backends.text import PRODUCTS, Lines, Names, Printer, arrays, written


class C(Printer, C99CodePrinter):
    """Small powers as products, symbols by the names of the text."""

    both: ClassVar = "&&"
    either: ClassVar = "||"

    def assignment(self, target: str, value: str) -> str:
        """Return the line that names a value."""
        return f"const double {target} = {value};"

    def _print_Pow(self, expr: sp.Pow) -> str:
        base = self.parenthesize(expr.base, 100)
        if expr.exp in PRODUCTS:
            return f"({' * '.join([base] * int(expr.exp))})"
        if expr.exp == -2:
            return f"(1.0 / ({base} * {base}))"
        return str(super()._print_Pow(expr))

    def _print_Abs(self, expr: sp.Abs) -> str:
        return f"fabs({self._print(expr.args[0])})"  # of whole numbers too, which are doubles

    def _print_Mod(self, expr: sp.Mod) -> str:
        value, by = (self.parenthesize(arg, PRECEDENCE["Pow"]) for arg in expr.args)
        return f"({value} - {by}*floor({value}/{by}))"

    def _print_sign(self, expr: sp.sign) -> str:
        value = self._print(expr.args[0])
        return f"(({value} > 0) ? 1.0 : (({value} < 0) ? -1.0 : 0.0))"

    def _print_Heaviside(self, expr: sp.Heaviside) -> str:
        value, at_zero = map(self._print, expr.args)
        return f"(({value} > 0) ? 1.0 : (({value} < 0) ? 0.0 : {at_zero}))"


PRINTER = C()


def function(kernel: Kernel, arguments: Sequence[str], names: Names | None = None) -> Lines:
    """Return the body of a function of `arguments`; those that it does not read are named all the same."""
    lines = written(kernel, PRINTER, arrays(), "out[{}]".format, names)
    unused = [f"(void)({name});" for name in arguments if not kernel.reads(name)]
    return Lines(lines.loads, [*lines.assigns, *unused], [f"{line};" for line in lines.stores])


def alone(
    kernel: Kernel,
    arguments: Sequence[str],
    lanes: int,
    into: str,
    at: int,
    copies: Sequence[int] = (0,),
    single: Collection[int] = (),
) -> list[str]:
    """Return the body of a function of one pose, of a kernel that is written for many side by side.

    See `derive.backends.lanes.block`: where that has a lane array of so many `lanes`, this has a number.
    """

    def place(of: Place) -> str:
        if of.lane and of.index is not None:
            return f"{of.array}[{of.index // lanes}]"
        return arrays()(of)

    lines = written(kernel, PRINTER, place, str)
    read = {load.place.array for load in kernel.loads} | {into}
    unused = [f"(void)({name});" for name in arguments if name not in read]
    stores = [
        f"{into}[{copy + at + store.index}] = {PRINTER.expression(store.expr)};"
        for store in kernel.stores
        for copy in (copies[:1] if store.index in single else copies)
    ]
    return [*lines.loads, *lines.assigns, *unused, *stores]


def value(kernel: Kernel, arguments: Sequence[str]) -> list[str]:
    """Return the body of a function that returns the only result."""
    names = _own_names(kernel)
    lines = function(kernel, arguments, names)
    (result,) = kernel.stores
    return [*lines.loads, *lines.assigns, f"return {PRINTER.expression(result.expr, names)};"]


def into(kernel: Kernel, array: str, every: int, arguments: Sequence[str]) -> list[str]:
    """Return the body of a function that writes each of so many results, and computes no other, into an array."""
    some = kernel.only(range(0, kernel.length, every))
    names = _own_names(some)
    lines = written(some, PRINTER, arrays(), lambda j: f"{array}[{j // every}]", names)
    unused = [f"(void)({name});" for name in arguments if not some.reads(name)]
    zero = [f"{array}[{j // every}] = 0.0;" for j in range(0, kernel.length, every) if j not in _stored(some)]
    return [*lines.loads, *lines.assigns, *unused, *(f"{line};" for line in lines.stores), *zero]


def _stored(kernel: Kernel) -> set[int]:
    return {store.index for store in kernel.stores}


def _own_names(kernel: Kernel) -> Names:
    """Return names of what is loaded that hide no function and no array: a coefficient may be called cos."""
    arrays_ = {load.place.array for load in kernel.loads if load.place.index is not None}
    names = {load.symbol: f"own_{load.symbol}" for load in kernel.loads if str(load.symbol) in arrays_}
    return names | {load.symbol: f"c_{load.symbol}" for load in kernel.loads if load.place.array == "c"}
