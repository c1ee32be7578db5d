"""Whether an equation holds identically."""

from __future__ import annotations

import sympy as sp


def zero(expr: sp.Expr | sp.Matrix) -> bool:
    """Whether a polynomial in sines and cosines vanishes identically: sin^2 = 1 - cos^2 leaves a normal form."""

    def even(base: sp.Expr, power: sp.Expr) -> sp.Expr:
        if not (isinstance(base, sp.sin) and power.is_Integer and power > 1):
            return base**power
        return (1 - sp.cos(base.args[0]) ** 2) ** (power // 2) * base ** (power % 2)

    return all(sp.expand(sp.expand(sp.expand_trig(e)).replace(sp.Pow, even)) == 0 for e in sp.Matrix([expr]))
