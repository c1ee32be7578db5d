"""Functions of an effect: its deformation and derivatives."""

from __future__ import annotations

from derive.graph import Graph
from derive.language.effects import Effect
from derive.mathematics.derivative import derivative
from derive.mathematics.functions import Functions, entries
from derive.mathematics.memory import memory_functions


def effect(spec: Effect) -> list[Functions]:
    """Return an effect's deformation, `value`, and its derivatives by the coefficients, `jacobian`.

    Of an effect with memories also the derivatives by these, `by_memory`, and what becomes of them along a run, see
    `memory_functions`.
    """
    coefficients = [c.symbol for c in spec.coefficients]
    read, memories = [s.symbol for s in spec.states], [m.symbol for m in spec.memory]
    inputs = entries("s", read) | entries("c", coefficients)
    inputs |= entries("constants", [c.symbol for c in spec.constants])
    functions = Functions(Graph(), {}, inputs | entries("s", memories, len(read)))
    functions.add("value", "value", list(spec.targets.values()))
    functions.add("jacobian", "jacobian", [derivative(e, c) for e in spec.targets.values() for c in coefficients])
    if not memories:
        return [functions]
    functions.add("by_memory", "by_memory", [derivative(e, z) for e in spec.targets.values() for z in memories])
    return [functions, *memory_functions(spec.memory, read, inputs)]
