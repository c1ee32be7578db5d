"""What is derived of a machine, an effect or an instrument: functions on a graph, and where their inputs stand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from derive.backends.ir import Place
from derive.graph import Graph

Inputs = Mapping[sp.Symbol, Place]


def entries(array: str, symbols: Sequence[sp.Symbol], first: int = 0) -> dict[sp.Symbol, Place]:
    """Return the places of symbols that stand one after the other in an array."""
    return {s: Place(array, first + j) for j, s in enumerate(symbols)}


@dataclass(frozen=True)
class Function:
    """Outputs of a graph that are evaluated together.

    Attributes
    ----------
    name, meaning : str
    outputs : tuple of (int, sympy.Expr)
        Entry of the result and the leaf of the graph that it is.
    length : int
        Length of the result; what is no output is identically zero.
    inputs : mapping
        Where those inputs stand that a pose changes.
    """

    name: str
    meaning: str
    outputs: tuple[tuple[int, sp.Expr], ...]
    length: int
    inputs: Inputs


class Functions:
    """Functions of one graph, in order, which share what no pose changes.

    Parameters
    ----------
    graph : Graph
    parameters : mapping
        Where the invariant inputs stand.
    inputs : mapping
        Where those stand that a pose changes.

    Attributes
    ----------
    invariants : (str, str) or None
        Name and meaning of the function of the parameters that gives what no pose changes; see `constants`.
    """

    def __init__(self, graph: Graph, parameters: Inputs, inputs: Inputs) -> None:
        self.graph, self.parameters, self.inputs = graph, parameters, inputs
        self.invariants: tuple[str, str] | None = None
        self._functions: dict[str, Function] = {}

    def __getitem__(self, name: str) -> Function:
        return self._functions[name]

    def __iter__(self) -> Iterator[Function]:
        return iter(self._functions.values())

    def add(
        self,
        name: str,
        meaning: str,
        outputs: Sequence[sp.Expr | None],
        *,
        dense: bool = False,
        inputs: Inputs | None = None,
    ) -> None:
        """Add a function.

        Parameters
        ----------
        outputs : sequence of sympy.Expr or None
            One that is identically zero is stored only where `dense`, for callers whose array has been used before;
            None, which nobody reads, is never stored.
        inputs : mapping, optional
            Other places than those of the others, steps of the graph among them.
        """
        leaves = [None if e is None else self.graph.add(e) for e in outputs]
        kept = tuple((j, leaf) for j, leaf in enumerate(leaves) if leaf is not None and (dense or leaf != 0))
        found = Function(name, meaning, kept, len(leaves), self.inputs if inputs is None else inputs)
        if name in self._functions:
            raise ValueError(f"the function '{name}' is derived twice.")
        self._functions[name] = found

    def constants(self, name: str, meaning: str) -> None:
        """Name the function of what no pose changes: all that the others ask for, in the order in which they do."""
        self.invariants = name, meaning
