"""What may stand in the formula of an effect: the functions and constructs that every target can write.

A formula is made of states, coefficients, constants and numbers by sums, products, powers with a number as exponent,
comparisons (in a `Piecewise`) and the functions below. Anything else is refused by name where an effect is declared,
not where a kernel of it fails.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from sympy.functions.elementary.piecewise import ExprCondPair
from sympy.logic.boolalg import BooleanAtom

FUNCTIONS = (
    sp.Abs,
    sp.sign,
    sp.exp,
    sp.log,
    sp.sin,
    sp.cos,
    sp.asin,
    sp.tanh,
    sp.Max,
    sp.Min,
    sp.Heaviside,
    sp.Piecewise,
    sp.Mod,
    sp.floor,
)
_CONSTRUCTS = (
    sp.Symbol,
    sp.Rational,
    sp.Float,
    sp.NumberSymbol,
    sp.Add,
    sp.Mul,
    ExprCondPair,
    BooleanAtom,
    sp.core.relational.Relational,
    sp.And,
    sp.Or,
    sp.ITE,
)
ALLOWED = ", ".join(["sqrt", *(f.__name__ for f in FUNCTIONS)])


def check(name: str, expr: sp.Expr) -> None:
    """Refuse what no target could write.

    Parameters
    ----------
    name : str
        What the expression belongs to, for the message.

    Raises
    ------
    ValueError
        The expression holds something else than the language; the message names it and what is allowed.
    """
    if stray := list(dict.fromkeys(_strays(expr))):
        raise ValueError(
            f"{name}: {', '.join(stray)} cannot be written in every target. There are + - * /, powers with a number as "
            f"exponent, comparisons in Piecewise, and {ALLOWED}."
        )


def _strays(expr: sp.Basic) -> Iterator[str]:
    """Yield what is not of the language, in the order of the expression."""
    for node in sp.preorder_traversal(expr):
        if isinstance(node, sp.Symbol) and not node.is_real:
            yield f"the symbol {node}, which is not declared real"
        elif isinstance(node, sp.Pow):
            if not node.exp.is_Rational and not node.exp.is_Float:
                yield f"a power with the exponent {node.exp}"
        elif isinstance(node, sp.Piecewise) and node.args[-1].cond != sp.true:
            yield "a Piecewise without a last case (..., True)"
        elif not isinstance(node, FUNCTIONS + _CONSTRUCTS):
            yield type(node).__name__ if node.args else str(node)
