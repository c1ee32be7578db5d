"""Functions of an effect: its deformation and derivatives."""

from __future__ import annotations

import sympy as sp

import derive.effects
from derive.graph import Graph
from derive.mathematics.functions import Functions, entries
from derive.spec import Effect, EffectQuantity


def states(spec: Effect) -> list[EffectQuantity]:
    """Return the state that an effect reads."""
    read = set().union(*(e.free_symbols for e in spec.targets.values()))
    return [s for s in derive.effects.STATE if s.symbol in read]


def effect(spec: Effect) -> Functions:
    """Return an effect's deformation, `value`, and its derivatives by the coefficients, `jacobian`.

    Raises
    ------
    ValueError
        A target does not vanish with the coefficients.
    """
    coefficients = [c.symbol for c in spec.coefficients]
    for target, e in spec.targets.items():
        if e.subs(dict.fromkeys(coefficients, 0)) != 0:
            raise ValueError(f"effect {spec.name}: {target} does not vanish where all coefficients are zero.")
    inputs = entries("s", [s.symbol for s in states(spec)]) | entries("c", coefficients)
    inputs |= entries("constants", [c.symbol for c in spec.constants])
    functions = Functions(Graph(), {}, inputs)
    functions.add("value", "value", list(spec.targets.values()))
    functions.add("jacobian", "jacobian", [sp.diff(e, c) for e in spec.targets.values() for c in coefficients])
    return functions
