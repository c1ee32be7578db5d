"""Expressions at numbers."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp

from derive.review.written import exactly


def numbers(symbols: set[sp.Symbol]) -> dict[sp.Symbol, float]:
    rng = np.random.default_rng(7)
    return {s: float(rng.uniform(0.2, 0.5)) for s in sorted(symbols, key=str)}


def value(e: sp.Expr, at: Mapping[sp.Symbol, float]) -> float:
    return float(sp.N(exactly(e).xreplace({s: sp.Float(v) for s, v in at.items()})))
