"""SymPy expressions as text: Python for Numba, C99 for a controller."""

from __future__ import annotations

import re

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.pycode import PythonCodePrinter

PRODUCTS = (2, 3, 4)  # powers that are written as products: a call would cost as much as ten of them


class _Python(PythonCodePrinter):
    """Numba-friendly Python: small powers as products, roots by `math.sqrt`, rationals as decimals."""

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
        return super()._print_Pow(expr, rational=rational)


class _C(C99CodePrinter):
    """C99 with small powers as products."""

    def _print_Pow(self, expr: sp.Pow) -> str:
        base = self.parenthesize(expr.base, 100)
        if expr.exp in PRODUCTS:
            return f"({' * '.join([base] * int(expr.exp))})"
        if expr.exp == -2:
            return f"(1.0 / ({base} * {base}))"
        return super()._print_Pow(expr)


_FACTOR = re.compile(r"(?<![\w)])\((\d+\.\d+(?:e-?\d+)?)\)(?=\*)")  # "(0.5)*x" says no more than "0.5*x"
_PYTHON = _Python({"fully_qualified_modules": True})
_C99 = _C()


def python(expr: sp.Expr) -> str:
    """Return `expr` as Python that Numba compiles."""
    return _FACTOR.sub(r"\1", str(_PYTHON.doprint(expr)))


def c99(expr: sp.Expr) -> str:
    """Return `expr` as C99."""
    return str(_C99.doprint(expr))
