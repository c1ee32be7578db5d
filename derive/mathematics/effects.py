"""Functions of an effect: its deformation and derivatives."""

from __future__ import annotations

import sympy as sp

from derive.graph import Graph
from derive.mathematics.functions import Functions, entries
from derive.spec import Effect


def effect(spec: Effect) -> Functions:
    """Return an effect's deformation, `value`, and its derivatives by the coefficients, `jacobian`."""
    coefficients = [c.symbol for c in spec.coefficients]
    inputs = entries("s", [s.symbol for s in spec.states]) | entries("c", coefficients)
    inputs |= entries("constants", [c.symbol for c in spec.constants])
    functions = Functions(Graph(), {}, inputs)
    functions.add("value", "value", list(spec.targets.values()))
    functions.add("jacobian", "jacobian", [sp.diff(e, c) for e in spec.targets.values() for c in coefficients])
    return functions
