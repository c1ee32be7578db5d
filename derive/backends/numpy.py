"""NumPy: every number of a kernel is an array, over rows or with the poses last."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

import sympy as sp

from derive.backends.ir import Kernel
from derive.backends.scalar import Python
from derive.backends.text import Lines, arrays, written


class NumPy(Python):
    """Python of arrays."""

    functions: ClassVar = {
        "Abs": "np.abs",
        "acos": "np.acos",
        "asin": "np.asin",
        "atan": "np.atan",
        "atan2": "np.arctan2",
        "cos": "np.cos",
        "exp": "np.exp",
        "log": "np.log",
        "sign": "np.sign",
        "sin": "np.sin",
        "tan": "np.tan",
        "tanh": "np.tanh",
    }
    root: ClassVar = "np.sqrt"
    floor: ClassVar = "np.floor"
    larger: ClassVar = "np.maximum"
    smaller: ClassVar = "np.minimum"

    def _print_Pi(self, expr: sp.Expr) -> str:
        return "np.pi"

    def _print_Abs(self, expr: sp.Abs) -> str:
        return f"np.abs({self._print(expr.args[0])})"

    def _print_sign(self, expr: sp.sign) -> str:
        return f"np.sign({self._print(expr.args[0])})"

    def _print_Heaviside(self, expr: sp.Heaviside) -> str:
        return f"np.heaviside({', '.join(map(self._print, expr.args))})"

    def _chosen(self, cases: Sequence[tuple[str, str]], last: str) -> str:
        for condition, value in reversed(cases):
            last = f"np.where({condition}, {value}, {last})"
        return last


PRINTER = NumPy()


def expression(expr: sp.Expr) -> str:
    """Return the text of an expression."""
    return PRINTER.expression(expr)


def calls_numpy(expr: sp.Expr) -> bool:
    """Tell whether the text of an expression calls NumPy."""
    roots = any(abs(power.exp) == sp.Rational(1, 2) for power in expr.atoms(sp.Pow))
    return roots or bool(expr.atoms(sp.Function, sp.NumberSymbol))


def poses_last(kernel: Kernel, out: str = "out") -> Lines:
    """Return lines over arrays whose first axis counts the numbers, so that entry j of x is ``x[j]``."""
    return written(kernel, PRINTER, arrays(), lambda j: f"{out}[{j}]")


def over_rows(kernel: Kernel, shared: Sequence[str] = ()) -> Lines:
    """Return lines over arrays whose first axis counts the rows: entry j of x is ``x[:, j]``, of `shared` ones not."""
    names = {load.place.array for load in kernel.loads if load.place.index is not None}
    forms = {name: f"{name}[:, {{}}]" for name in sorted(names - set(shared))}
    return written(kernel, PRINTER, arrays(**forms), lambda j: f"out[:, {j}]")
