"""Expressions as a graph of named steps, differentiated step by step.

Differentiating whole expressions and hunting for common parts afterwards is slow and misses most of them. Here every
distinct subexpression becomes a node once, and derivatives are built on the nodes: backwards from a scalar output to
everything that changes with the pose (one sweep, whatever the number of inputs), and forwards through what depends
on the parameters alone, which is evaluated once per machine and not once per pose.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from derive.mathematics.derivative import derivative

Steps = Sequence[tuple[sp.Symbol, sp.Expr]]


class Graph:
    """Nodes in the order of evaluation; equal subexpressions share one node.

    Parameters
    ----------
    steps : sequence of (symbol, expression)
        Named definitions, each in terms of inputs and earlier steps; they keep their names.
    invariant : iterable of sympy.Symbol
        Inputs that do not change from pose to pose. A node of these alone is *invariant*; sums and products are
        grouped so that their invariant part is one node.
    """

    def __init__(self, steps: Steps = (), invariant: Iterable[sp.Symbol] = ()) -> None:
        self.nodes: dict[sp.Symbol, sp.Expr] = {}
        self._names: dict[sp.Expr, sp.Symbol] = {}
        self._invariant = set(invariant)
        self._alias: dict[sp.Symbol, sp.Expr] = {}
        self._partials: dict[sp.Symbol, list[tuple[sp.Symbol, sp.Expr]]] = {}
        self._tangents: dict[sp.Symbol, dict[sp.Symbol, sp.Expr]] = {}
        self._forms: dict[sp.Symbol, dict[sp.Expr, sp.Expr]] = {}
        for symbol, expr in steps:
            shallow = self._shallow(sp.sympify(expr))
            if self._is_leaf(shallow):
                self._alias[symbol] = shallow
            else:
                self._define(symbol, shallow)

    def is_invariant(self, expr: sp.Expr) -> bool:
        """Tell whether `expr`, in terms of nodes and inputs, changes with no pose."""
        return bool(expr.free_symbols <= self._invariant)

    @staticmethod
    def _is_leaf(expr: sp.Expr) -> bool:
        return bool(expr.is_number or expr.is_Symbol or (-expr).is_Symbol)

    def _define(self, symbol: sp.Symbol, shallow: sp.Expr) -> None:
        self.nodes[symbol] = shallow
        self._names.setdefault(shallow, symbol)
        if self.is_invariant(shallow):
            self._invariant.add(symbol)

    def add(self, expr: sp.Expr) -> sp.Expr:
        """Return a leaf (number, symbol or minus a symbol) equal to `expr`, adding the nodes it needs."""
        shallow = self._shallow(sp.sympify(expr))
        if self._is_leaf(shallow):
            return shallow
        if shallow not in self._names:
            if -shallow in self._names:
                return -self._names[-shallow]
            self._define(sp.Symbol(f"s{len(self.nodes)}", real=True), shallow)
        return self._names[shallow]

    def _shallow(self, expr: sp.Expr) -> sp.Expr:
        if expr.is_Symbol:
            return self._alias.get(expr, expr)
        if expr.is_number:
            return expr
        if isinstance(expr, sp.Add | sp.Mul):
            args = [self.add(arg) for arg in expr.args]
            fixed = [arg for arg in args if self.is_invariant(arg)]
            moving = [arg for arg in args if not self.is_invariant(arg)]
            if moving and len(fixed) > 1 and any(arg.free_symbols for arg in fixed):
                return expr.func(self.add(expr.func(*fixed)), *moving)
            return expr.func(*args)
        if isinstance(expr, sp.Pow):
            return sp.Pow(self.add(expr.base), expr.exp)
        return expr.func(*map(self._argument, expr.args))

    def _argument(self, expr: sp.Basic) -> sp.Basic:
        """Return an argument of a function in terms of nodes; a condition, which is no number, is none itself."""
        if isinstance(expr, sp.Expr):
            return self.add(expr)
        if isinstance(expr, sp.ITE):  # which SymPy makes of the comparison of a choice
            return self._argument(expr.to_nnf())
        return expr.func(*map(self._argument, expr.args)) if expr.args else expr

    def _partial(self, symbol: sp.Symbol) -> list[tuple[sp.Symbol, sp.Expr]]:
        """Return the derivatives of a node by each of its own arguments."""
        if symbol not in self._partials:
            expr = self.nodes[symbol]
            arguments = sorted(expr.free_symbols, key=str)
            self._partials[symbol] = [(arg, self.add(derivative(expr, arg))) for arg in arguments]
        return self._partials[symbol]

    def gradient(self, output: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
        """Sweep backwards from a scalar; return the derivative by every input, and by every invariant node met.

        Invariant nodes are leaves of the sweep: their own derivatives are `_tangent`.
        """
        sign, start = (-1, -output) if (-output).is_Symbol else (1, output)
        terms: dict[sp.Symbol, list[sp.Expr]] = {start: [sp.Integer(sign)]}
        for symbol in reversed(list(self.nodes)):
            if symbol not in terms or symbol in self._invariant:
                continue
            weight = self.add(sp.Add(*terms.pop(symbol)))
            for arg, partial in self._partial(symbol):
                terms.setdefault(arg, []).append(self.add(weight * partial))
        return {symbol: self.add(sp.Add(*parts)) for symbol, parts in terms.items()}

    def _tangent(self, node: sp.Symbol, by: sp.Symbol) -> sp.Expr:
        """Return the derivative of an invariant node by an invariant input, swept forwards."""
        known = self._tangents.setdefault(by, {by: sp.Integer(1)})
        if node not in known:
            parts = []
            if node in self.nodes:
                parts = [self.add(partial * self._tangent(arg, by)) for arg, partial in self._partial(node)]
            known[node] = self.add(sp.Add(*parts))
        return known[node]

    def derivatives(self, output: sp.Expr, by: Sequence[sp.Symbol]) -> list[sp.Expr]:
        """Return leaves equal to the derivatives of a scalar by the inputs `by`, pose-dependent or invariant."""
        gradient = self.gradient(self.add(output))
        inner = [s for s in gradient if s in self._invariant]
        result = []
        for symbol in by:
            if symbol in self._invariant:
                parts = [self.add(gradient[s] * self._tangent(s, symbol)) for s in inner]
                result.append(self.add(sp.Add(*parts)))
            else:
                result.append(gradient.get(symbol, sp.Integer(0)))
        return result

    def rates(self, known: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
        """Return the rates of inputs and of all nodes that move with them, swept forwards, from those of the inputs.

        Applied again, with the rates of inputs as further inputs, it gives second derivatives.
        """
        found = dict(known)
        for symbol in list(self.nodes):
            if symbol not in self._invariant:
                moving = [(arg, partial) for arg, partial in self._partial(symbol) if arg in found]
                if parts := [self.add(partial * found[arg]) for arg, partial in moving]:
                    found[symbol] = self.add(sp.Add(*parts))
        return found

    @staticmethod
    def rate(leaf: sp.Expr, rates: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
        """Return the rate of a leaf: a node or an input, its negative, or a number."""
        if leaf.is_Symbol:
            return rates.get(leaf, sp.Integer(0))
        return -rates.get(-leaf, sp.Integer(0)) if (-leaf).is_Symbol else sp.Integer(0)

    def affine(self, expr: sp.Expr) -> dict[sp.Expr, sp.Expr] | None:
        """Return a sum's coefficients, which no pose changes, by what moves, and its constant part by 1.

        What moves are inputs and nodes that are no such sums themselves. None where `expr` is none.
        """
        if self.is_invariant(expr):
            return {sp.Integer(1): expr}
        if expr.is_Symbol:
            if expr not in self._forms:
                of_node = self.affine(self.nodes[expr]) if expr in self.nodes else None
                self._forms[expr] = of_node if of_node is not None else {expr: sp.Integer(1)}
            return self._forms[expr]
        if isinstance(expr, sp.Mul):
            moving = [arg for arg in expr.args if not self.is_invariant(arg)]
            form = self.affine(moving[0]) if len(moving) == 1 else None
            factor = sp.Mul(*(arg for arg in expr.args if self.is_invariant(arg)))
            return None if form is None else {atom: e * factor for atom, e in form.items()}
        if not isinstance(expr, sp.Add):
            return None
        total: dict[sp.Expr, sp.Expr] = {}
        for form in map(self.affine, expr.args):
            if form is None:
                return None
            for atom, e in form.items():
                total[atom] = total.get(atom, sp.Integer(0)) + e
        return total

    def at(self, values: Mapping[sp.Symbol, sp.Expr]) -> tuple[Graph, dict[sp.Symbol, sp.Expr]]:
        """Return the graph with some inputs at fixed values, and what each of this graph's nodes is in it."""
        fixed = Graph(invariant=self._invariant - set(self.nodes))
        known = dict(values)
        for symbol, expr in self.nodes.items():
            known[symbol] = fixed.add(expr.xreplace(known))
        return fixed, known

    def needed(self, outputs: Iterable[sp.Expr], known: Iterable[sp.Symbol] = ()) -> dict[sp.Symbol, sp.Expr]:
        """Return the nodes that `outputs` need, in order of evaluation, without those `known` already."""
        live = set().union(*(e.free_symbols for e in outputs)) - set(known)
        chosen = {}
        for symbol, expr in reversed(list(self.nodes.items())):
            if symbol in live:
                chosen[symbol] = expr
                live |= expr.free_symbols - set(known)
        return dict(reversed(list(chosen.items())))


def collected(steps: Steps, invariant: Iterable[sp.Symbol]) -> list[tuple[sp.Symbol, sp.Expr]]:
    """Return the steps with those that are linear in what moves written so: few products, and more that is fixed.

    An arm's point, say, through a chain of rotations, becomes ``a cos q + b sin q + c``.
    """
    graph = Graph(steps, invariant)
    nodes = dict(graph.nodes)
    names = {symbol for symbol, _ in steps}
    for symbol in nodes:
        form = graph.affine(nodes[symbol]) if symbol in names and not graph.is_invariant(symbol) else None
        if form is not None:
            nodes[symbol] = sp.Add(*(sp.factor_terms(sp.expand(e)) * atom for atom, e in form.items()))
    aliases = {symbol: graph._alias[symbol] for symbol, _ in steps if symbol not in nodes}
    live = (names & set(nodes)).union(*(e.free_symbols for e in aliases.values()))
    for symbol in reversed(list(nodes)):
        if symbol in live:
            live |= nodes[symbol].free_symbols
    own = {s: s if s in names else sp.Symbol(f"by_{s}", real=True) for s in nodes}  # the next graph numbers its own
    kept = [(own[s], e.xreplace(own)) for s, e in nodes.items() if s in live]
    return [*kept, *((s, e.xreplace(own)) for s, e in aliases.items())]


def expand_steps(expr: sp.Expr, steps: Steps) -> sp.Expr:
    """Return `expr` with all steps written out."""
    for symbol, definition in reversed(steps):
        if expr.has(symbol):
            expr = expr.xreplace({symbol: definition})
    return expr


def inline(
    nodes: Mapping[sp.Symbol, sp.Expr], outputs: Sequence[sp.Expr], longest: int = 12
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """Write nodes used once, unless they are named steps, into the place of their use, up to `longest` operations."""
    nodes, outputs = dict(nodes), list(outputs)
    uses: dict[sp.Symbol, int] = {}
    for e in (*nodes.values(), *outputs):
        for s in e.free_symbols:
            uses[s] = uses.get(s, 0) + (2 if e.count(s) > 1 else 1)
    users = {s: key for key, e in nodes.items() for s in e.free_symbols}
    for symbol in list(nodes):
        temporary = str(symbol)[0] == "s" and str(symbol)[1:].isdigit()
        if temporary and uses.get(symbol) == 1 and symbol in users:
            user = users[symbol]
            merged = nodes[user].xreplace({symbol: nodes[symbol]})
            if sp.count_ops(merged) <= longest and not merged.is_Symbol:
                nodes[user] = merged
                for s in nodes[symbol].free_symbols:
                    users[s] = user
                del nodes[symbol]
    return nodes, outputs
