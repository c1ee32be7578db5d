"""From the graph of a machine to kernels: names, strings and numbers; from here on nothing sees a symbolic object.

A machine's parameters are the same for thousands of poses, so every node that depends on them alone is computed once,
by the kernel `constants`, into an array `k`; the kernels that run per pose read `k` instead of `p`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from derive.graph import Graph, inline
from derive.printer import python

Text = Callable[[sp.Expr], str]


@dataclass(frozen=True)
class Kernel:
    """A straight-line function from flat arrays to one flat array `out`; all plain text.

    Attributes
    ----------
    loads, statements : tuple of (str, str)
        Target and right-hand side, in order.
    stores : tuple of (int, str)
        Index into `out` and right-hand side.
    length : int
        Length of `out`; what is not stored is identically zero.
    operations : int
        Arithmetic operations.
    """

    name: str
    meaning: str
    loads: tuple[tuple[str, str], ...]
    statements: tuple[tuple[str, str], ...]
    stores: tuple[tuple[int, str], ...]
    length: int
    operations: int

    def of_limb(self, i: int) -> Kernel:
        """Return the kernel with names of its own, for text in which several limbs stand side by side.

        What is loaded from the platform or the tool is the same for all limbs and keeps its name.
        """
        shared = {target for target, load in self.loads if load[0] in "xt"}
        own = {name for name, _ in (*self.loads, *self.statements)} - shared
        name = re.compile(r"\b(" + "|".join(sorted(own, key=len, reverse=True)) + r")\b")

        def renamed(text: str) -> str:
            return name.sub(rf"\1_{i}", text)

        return replace(
            self,
            loads=tuple((renamed(target) if target in own else target, load) for target, load in self.loads),
            statements=tuple((renamed(target), renamed(value)) for target, value in self.statements),
            stores=tuple((j, renamed(value)) for j, value in self.stores),
        )


class Lowering:
    """Lowers several kernels of one graph that share their invariants.

    Parameters
    ----------
    graph : Graph
    parameters : mapping
        Invariant inputs to the text that loads them.
    inputs : mapping
        Pose-dependent inputs to the text that loads them.
    constant : str
        Text that loads invariant number ``{}``.
    """

    def __init__(
        self,
        graph: Graph,
        parameters: Mapping[sp.Symbol, str],
        inputs: Mapping[sp.Symbol, str],
        constant: str = "k[{}]",
        text: Text = python,
    ) -> None:
        self._graph, self._parameters, self._inputs = graph, parameters, inputs
        self._constant, self._text = constant, text
        self._shared: dict[sp.Symbol, str] = {}

    def kernel(self, name: str, meaning: str, outputs: Sequence[sp.Expr | None], *, dense: bool = False) -> Kernel:
        """Lower `outputs`.

        One that is identically zero is stored only where `dense`, for callers whose array has been used before; None,
        which nobody reads, is never stored.
        """
        leaves = [self._graph.add(e) for e in outputs if e is not None]
        stored = [j for j, e in enumerate(outputs) if e is not None]
        moving = {
            s: e for s, e in self._graph.needed(leaves, known=self._inputs).items() if not self._graph.is_invariant(s)
        }
        for expr in (*moving.values(), *leaves):
            for symbol in sorted(expr.free_symbols, key=str):
                if self._graph.is_invariant(symbol) and symbol not in self._shared:
                    self._shared[symbol] = self._constant.format(len(self._shared))
        lowered = self._straight(name, meaning, {**self._inputs, **self._shared}, moving, leaves)
        stores = tuple((stored[j], value) for j, value in lowered.stores if dense or leaves[j] != 0)
        return replace(lowered, stores=stores, length=len(outputs))

    def over(self, inputs: Mapping[sp.Symbol, str]) -> Lowering:
        """Return the lowering of the same graph with other inputs, steps among them; the invariants are shared."""
        other = Lowering(self._graph, self._parameters, inputs, self._constant, self._text)
        other._shared = self._shared
        return other

    def constants(self, name: str, meaning: str) -> Kernel:
        """Lower the invariants that the kernels so far have asked for; call this last."""
        nodes = self._graph.needed(self._shared)
        return self._straight(name, meaning, self._parameters, nodes, list(self._shared))

    def _straight(
        self,
        name: str,
        meaning: str,
        sources: Mapping[sp.Symbol, str],
        nodes: Mapping[sp.Symbol, sp.Expr],
        outputs: Sequence[sp.Expr],
    ) -> Kernel:
        nodes, leaves = inline(nodes, outputs)
        used = set().union(*(e.free_symbols for e in nodes.values()), *(e.free_symbols for e in leaves))
        if unknown := sorted(str(s) for s in used - set(sources) - set(nodes)):
            raise ValueError(f"kernel {name} uses {', '.join(unknown)}, for which no source is given.")
        return Kernel(
            name=name,
            meaning=meaning,
            loads=tuple((str(s), load) for s, load in sources.items() if s in used),
            statements=tuple((str(s), self._text(e)) for s, e in nodes.items()),
            stores=tuple((j, self._text(e)) for j, e in enumerate(leaves)),
            length=len(leaves),
            operations=int(sum(sp.count_ops(e) for e in (*nodes.values(), *leaves))),
        )
