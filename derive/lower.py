"""From functions on a graph to kernels of typed nodes.

A machine's parameters are the same for thousands of poses, so every node that depends on them alone is computed once,
by the kernel of constants, into an array `k`; the kernels that run per pose read `k` instead of `p`.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from derive.backends.ir import Assign, Kernel, Load, Place, Store
from derive.graph import inline
from derive.mathematics.functions import Functions, Inputs


def lower(functions: Functions) -> dict[str, Kernel]:
    """Return the kernels of functions by name, that of their constants last.

    Raises
    ------
    ValueError
        A function uses a symbol that stands nowhere.
    """
    graph, shared = functions.graph, dict[sp.Symbol, Place]()
    kernels = {}
    for function in functions:
        leaves = [leaf for _, leaf in function.outputs]
        needed = graph.needed(leaves, known=function.inputs)
        moving = {s: e for s, e in needed.items() if not graph.is_invariant(s)}
        for expr in (*moving.values(), *leaves):
            for symbol in sorted(expr.free_symbols, key=str):
                if graph.is_invariant(symbol):
                    shared.setdefault(symbol, Place("k", len(shared)))
        sources = {**function.inputs, **shared}
        kernels[function.name] = _kernel(
            function.name, function.meaning, sources, moving, function.outputs, function.length
        )
    if functions.invariants is not None:
        name, meaning = functions.invariants
        outputs = list(enumerate(shared))
        kernels[name] = _kernel(name, meaning, functions.parameters, graph.needed(shared), outputs, len(outputs))
    return kernels


def _kernel(
    name: str,
    meaning: str,
    sources: Inputs,
    nodes: Mapping[sp.Symbol, sp.Expr],
    outputs: Sequence[tuple[int, sp.Expr]],
    length: int,
) -> Kernel:
    nodes, leaves = inline(nodes, [leaf for _, leaf in outputs])
    nodes, leaves = _beside(nodes, leaves, {place.array for place in sources.values()})
    used = set().union(*(e.free_symbols for e in nodes.values()), *(e.free_symbols for e in leaves))
    if unknown := sorted(str(s) for s in used - set(sources) - set(nodes)):
        raise ValueError(f"kernel {name} uses {', '.join(unknown)}, for which no source is given.")
    return Kernel(
        name=name,
        meaning=meaning,
        loads=tuple(Load(s, place) for s, place in sources.items() if s in used),
        assigns=tuple(Assign(s, e) for s, e in nodes.items()),
        stores=tuple(Store(j, leaf) for (j, _), leaf in zip(outputs, leaves, strict=True)),
        length=length,
    )


def _beside(
    nodes: Mapping[sp.Symbol, sp.Expr], leaves: list[sp.Expr], arrays: Collection[str]
) -> tuple[Mapping[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """Return nodes and leaves in which no node has the name of an array that is read: a step may be called s."""
    other = {s: sp.Symbol(f"{s}_", real=True) for s in nodes if str(s) in arrays}
    if not other:
        return nodes, leaves
    return {other.get(s, s): e.xreplace(other) for s, e in nodes.items()}, [e.xreplace(other) for e in leaves]
