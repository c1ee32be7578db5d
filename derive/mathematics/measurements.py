"""Functions of a measurement: its reading and derivatives, and its instrument after a step."""

from __future__ import annotations

import sympy as sp

from derive.graph import Graph
from derive.mathematics.functions import Functions, entries
from derive.spec import Measurement


def platform_names(spec: Measurement) -> tuple[str, ...]:
    """Return the arrays in which the poses of the platforms stand."""
    return ("x",) if len(spec.platforms) == 1 else ("x_a", "x_b")


def measurement(spec: Measurement) -> Functions:
    """Return a measurement's reading and derivatives, evaluated where the instrument's increments are zero."""
    poses = zip(platform_names(spec), spec.platforms, strict=True)
    inputs = {s: place for name, platform in poses for s, place in entries(name, platform.coordinates).items()}
    inputs |= entries("given", [quantity.symbol for quantity in (*spec.given, *spec.known)])
    turns = [s for platform in spec.platforms for s in platform.turn]
    zero = dict.fromkeys((*(quantity.symbol for quantity in spec.unknown), *turns), 0)
    moved = [s for platform in spec.platforms for s in platform.displacement]
    unknown = [quantity.symbol for quantity in spec.unknown]

    def spin(symbol: sp.Symbol) -> sp.Matrix:
        """Return axial(dR R^T) of a product of rotations: the factor's own, turned by the factors before it."""
        before = sp.eye(3)
        for factor in spec.rotation:
            if factor.has(symbol):
                others = {s: 0 for s in zero if s != symbol}
                turning = (sp.diff(factor.subs(others), symbol) * factor.subs(others).T).subs(zero).applyfunc(sp.cancel)
                return before * sp.Matrix([turning[2, 1], turning[0, 2], turning[1, 0]])
            before = before * factor.subs(zero)
        return sp.zeros(3, 1)

    graph = Graph(spec.steps)

    def jacobian(by: list[sp.Symbol]) -> list[sp.Expr]:
        rows = [graph.derivatives(e, by) for e in spec.reading]
        if spec.rotation:
            spins = [spin(s) for s in by]
            rows += [[column[k] for column in spins] for k in range(3)]
        return [e for row in rows for e in row]

    outputs = {"reading": list(spec.reading), "by_platform": jacobian(moved), "by_unknown": jacobian(unknown)}
    if spec.rotation:
        outputs["rotation"] = list(sp.prod([sp.eye(3), *spec.rotation]))
    leaves = {name: [graph.add(e) for e in exprs] for name, exprs in outputs.items()}
    graph, values = graph.at(zero)
    functions = Functions(graph, {}, inputs)
    for name, found in leaves.items():
        functions.add(name, name, [e.xreplace(values) for e in found])
    return functions


def step(spec: Measurement) -> Functions:
    """Return the instrument's state after a step of its unknowns."""
    inputs = entries("given", [quantity.symbol for quantity in spec.given])
    inputs |= entries("step", [quantity.symbol for quantity in spec.unknown])
    functions = Functions(Graph(), {}, inputs)
    functions.add("stepped", "stepped", list(spec.after))
    return functions


def distances(dimensions: int) -> Functions:
    """Return how the distance of two positions changes: `towards`, the unit vector from one to the other, and `apart`.

    `apart` is the change of the distance where either position shifts, in terms of that vector.
    """

    def vector(name: str) -> list[sp.Symbol]:
        return [sp.Symbol(f"{name}_{axis}", real=True) for axis in "xyz"[:dimensions]]

    a, b, gap, n, shift_a, shift_b = map(vector, ("a", "b", "gap", "n", "shift_a", "shift_b"))
    distance = sp.sqrt(sum(g**2 for g in gap))
    inputs = entries("a", a) | entries("b", b) | entries("towards", n)
    inputs |= entries("shift_a", shift_a) | entries("shift_b", shift_b)
    functions = Functions(Graph([(g, to - here) for g, here, to in zip(gap, a, b, strict=True)]), {}, inputs)
    slopes = [sp.diff(distance, g) for g in gap]
    functions.add("towards", "unit vector from one position to the other", slopes, dense=True)
    change = sum(along * (to - here) for along, here, to in zip(n, shift_a, shift_b, strict=True))
    functions.add("apart", "change of the distance where either shifts", [change], dense=True)
    return functions
