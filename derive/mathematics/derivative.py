"""Derivatives of the language of effects, one-sided at kinks.

SymPy differentiates a sign to Dirac's delta, a floor to nothing that can be evaluated, and the modulus of a number to
its sign, which at zero is neither of both slopes. Here a jump has the derivative 0 everywhere, and a kink that of one
of its sides: from above, where the sides are told by a comparison with zero.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

KINKED = (sp.Abs, sp.sign, sp.Max, sp.Min, sp.Heaviside, sp.Piecewise, sp.Mod, sp.floor)


def derivative(expr: sp.Expr, by: sp.Symbol) -> sp.Expr:
    """Return the derivative of an expression by a symbol; SymPy's own where nothing in it jumps or has a kink."""
    if by not in expr.free_symbols:
        return sp.Integer(0)
    if expr == by:
        return sp.Integer(1)
    if not expr.has(*KINKED):
        return sp.diff(expr, by)

    def inner(e: sp.Expr) -> sp.Expr:
        return derivative(e, by)

    if type(expr) in _RULES:
        return _RULES[type(expr)](expr, inner)
    arguments = [sp.Dummy(real=True) for _ in expr.args]
    outer, back = expr.func(*arguments), dict(zip(arguments, expr.args, strict=True))
    if isinstance(expr, sp.Pow):  # the exponent is a number
        outer = expr.func(arguments[0], expr.exp)
    parts = [(s, inner(e)) for s, e in back.items() if s in outer.free_symbols]
    return sp.Add(*(sp.diff(outer, s).xreplace(back) * rate for s, rate in parts if rate != 0))


Inner = Callable[[sp.Expr], sp.Expr]


def _modulus(expr: sp.Expr, inner: Inner) -> sp.Expr:
    (value,) = expr.args
    return sp.Piecewise((1, value >= 0), (-1, True)) * inner(value)


def _extreme(expr: sp.Expr, inner: Inner) -> sp.Expr:
    """Return the derivative of that argument which is the extreme; of several the first."""
    better = sp.Ge if isinstance(expr, sp.Max) else sp.Le
    *others, last = expr.args
    pieces = [(inner(e), sp.And(*(better(e, other) for other in expr.args if other != e))) for e in others]
    return sp.Piecewise(*pieces, (inner(last), True))


def _chosen(expr: sp.Expr, inner: Inner) -> sp.Expr:
    return sp.Piecewise(*((inner(e), condition) for e, condition in expr.args))


def _remainder(expr: sp.Expr, inner: Inner) -> sp.Expr:
    value, by = expr.args
    return inner(value) - sp.floor(value / by) * inner(by)


def _none(expr: sp.Expr, inner: Inner) -> sp.Expr:
    return sp.Integer(0)


_RULES: dict[type, Callable[[sp.Expr, Inner], sp.Expr]] = {
    sp.Abs: _modulus,
    sp.Max: _extreme,
    sp.Min: _extreme,
    sp.Piecewise: _chosen,
    sp.Mod: _remainder,
    sp.sign: _none,
    sp.floor: _none,
    sp.Heaviside: _none,
}
