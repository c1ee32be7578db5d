"""Formulas as text: what laws are made of, in SymPy's way of writing, checked name by name and computed with NumPy.

``c1*tanh(tension_1/c2)`` is parsed by Python's own grammar; nothing is run that is not in the table of functions. Units
are checked, and those of constants follow: what is added, compared or asked for a function must be alike.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

import numpy as np

from deltacal_gen.machine.registry import Array

Unit = dict[str, Fraction]  # exponents by the names of units
LAG = "Lag"  # Lag(state, time constant): computed along a run, not here
FUNCTIONS: dict[str, tuple[Callable[..., Any], int | None]] = {  # and how many arguments they take; None: two or more
    "Abs": (np.abs, 1),
    "sign": (np.sign, 1),
    "sqrt": (np.sqrt, 1),
    "exp": (np.exp, 1),
    "log": (np.log, 1),
    "sin": (np.sin, 1),
    "cos": (np.cos, 1),
    "asin": (np.arcsin, 1),
    "tanh": (np.tanh, 1),
    "Max": (np.maximum, None),
    "Min": (np.minimum, None),
    "Heaviside": (lambda x: np.heaviside(x, 0.5), 1),
    "Mod": (np.mod, 2),
    "floor": (np.floor, 1),
}
_WAVES = ("sin", "cos", "Mod")  # of their first argument
_TWICE = 4 * np.pi  # of the argument of a smooth wave: two periods
_ALIKE = ("Abs", "Max", "Min", "Mod", "floor")  # of the unit of what they are given
_OPERATIONS: dict[type, Callable[..., Any]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.divide,
    ast.Pow: np.power,
    ast.Lt: np.less,
    ast.LtE: np.less_equal,
    ast.Gt: np.greater,
    ast.GtE: np.greater_equal,
}
LANGUAGE = (
    "+ - * /, powers with a number as exponent, comparisons in Piecewise, "
    f"{', '.join([*FUNCTIONS, 'Piecewise'])} and Lag(state, time constant)"
)


@dataclass(frozen=True)
class Formula:
    """A formula that has been checked.

    Attributes
    ----------
    text : str
        As it was given.

    Raises
    ------
    ValueError
        It holds what is not of the language; the message says what, and where in the text.
    """

    text: str

    def __post_init__(self) -> None:
        for node in ast.walk(self.tree):
            if problem := _problem(node):
                raise ValueError(f"'{self.text}', column {getattr(node, 'col_offset', 0) + 1}: {problem}")

    @cached_property
    def tree(self) -> ast.expr:
        """The formula as Python's grammar reads it."""
        try:
            return ast.parse(self.text, mode="eval").body
        except SyntaxError as error:
            raise ValueError(f"'{self.text}', column {error.offset}: {error.msg}.") from None

    @cached_property
    def names(self) -> tuple[str, ...]:
        """States and constants, in the order of the text; those of a Lag among them."""
        called = {id(n.func) for n in ast.walk(self.tree) if isinstance(n, ast.Call)}
        found = [n for n in ast.walk(self.tree) if isinstance(n, ast.Name) and id(n) not in called]
        return tuple(dict.fromkeys(n.id for n in sorted(found, key=lambda n: n.col_offset)))

    @cached_property
    def lags(self) -> tuple[tuple[str, str], ...]:
        """State and time constant of every Lag, in the order of the text."""
        calls = [n for n in ast.walk(self.tree) if isinstance(n, ast.Call) and _called(n) == LAG]
        calls.sort(key=lambda n: n.col_offset)
        return tuple(dict.fromkeys((ast.unparse(n.args[0]), ast.unparse(n.args[1])) for n in calls))

    @cached_property
    def recurring(self) -> frozenset[str]:
        """Names of which the formula asks for waves alone: wherever they go, it takes no value that it has not had."""
        bare = {n.id for n in _outside_waves(self.tree) if isinstance(n, ast.Name)}
        return frozenset(self.names) - bare

    @cached_property
    def waves(self) -> tuple[tuple[str, ast.Call], ...]:
        """Every wave, with the name of what it goes through as that changes; what multiplies or shifts that follows."""
        calls = [n for n in ast.walk(self.tree) if isinstance(n, ast.Call) and _called(n) in _WAVES]
        return tuple((n.id, c) for c in calls for n in ast.walk(c.args[0]) if isinstance(n, ast.Name))

    def recurs(self, name: str, low: float, high: float, known: Mapping[str, Array | float]) -> bool:
        """Tell whether all its waves of a name come again between two values of it; the others have values by name.

        Two periods of a smooth wave: any bend is like a part of one. One of a wave with corners, which stand out.
        """
        for own, wave in self.waves:
            if own != name:
                continue
            first, last = (float(_value(wave.args[0], {**known, name: v})) for v in (low, high))
            sharp = _called(wave) == "Mod"
            if not abs(last - first) >= (abs(float(_value(wave.args[1], known))) if sharp else _TWICE):
                return False
        return True

    @cached_property
    def linear(self) -> tuple[str, ...]:
        """The constants by which it is multiplied, one in each summand: coefficients, which a fit finds at once."""
        return tuple(dict.fromkeys(name for s in _summands(self.tree) if (name := _outer(s)) is not None))

    def __call__(self, values: Mapping[str, Array | float]) -> Array:
        """Return the formula at values by name, broadcast; a Lag is looked up by its own text."""
        with np.errstate(all="ignore"):
            return np.asarray(_value(self.tree, values), dtype=float)

    def units(self, known: Mapping[str, Unit], of: Unit) -> dict[str, Unit]:
        """Return the unit of every name that is not known, so that the formula is of a unit.

        Parameters
        ----------
        known : mapping
            Units of states, see `unit`.
        of : unit
            Of the formula.

        Raises
        ------
        ValueError
            Units do not agree, whatever the unknown ones are.
        """
        return _Units(known, [n for n in self.names if n not in known]).solved(self.tree, of)


@cache
def formula(text: str) -> Formula:
    """Return a formula, checked once."""
    return Formula(text)


def _outside_waves(node: ast.AST) -> Iterator[ast.AST]:
    """Yield nodes that stand in no wave's argument."""
    yield node
    waved = node.args[0] if isinstance(node, ast.Call) and _called(node) in _WAVES else None
    for child in ast.iter_child_nodes(node):
        if child is not waved:
            yield from _outside_waves(child)


def _called(node: ast.Call) -> str:
    return node.func.id if isinstance(node.func, ast.Name) else ""


def _problem(node: ast.AST) -> str | None:
    """Return what is wrong with a node by itself; None where nothing is."""
    if isinstance(node, ast.Call):
        name, count = _called(node), len(node.args)
        if node.keywords or name not in (*FUNCTIONS, "Piecewise", LAG):
            return f"there is no function '{name or ast.unparse(node.func)}'; there are {LANGUAGE}."
        if name == "Piecewise":
            cases = [a.elts for a in node.args if isinstance(a, ast.Tuple) and len(a.elts) == 2]
            last = cases[-1][1] if len(cases) == count and cases else None
            whole = isinstance(last, ast.Constant) and last.value is True
            return None if whole else "Piecewise takes pairs (value, condition), the last one with the condition True."
        wanted = 2 if name == LAG else FUNCTIONS[name][1]
        if count < 2 if wanted is None else count != wanted:
            return f"{name} takes {wanted or 'two or more'} arguments, not {count}."
        if name == LAG and not isinstance(node.args[0], ast.Name):
            return "Lag follows a state by its name."
        return None
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and _number(node.right) is None:
        return "an exponent is a number."
    if isinstance(node, ast.Compare) and len(node.ops) > 1:
        return "compare two things at a time."
    if isinstance(node, ast.Constant) and not isinstance(node.value, bool | int | float):
        return f"'{node.value!r}' is no number."
    allowed = (ast.BinOp, ast.UnaryOp, ast.Name, ast.Load, ast.Constant, ast.Compare, ast.Tuple, ast.USub, ast.UAdd)
    if not isinstance(node, allowed + tuple(_OPERATIONS)):
        return f"'{type(node).__name__}' is not of the language; there are {LANGUAGE}."
    return None


def _number(node: ast.expr) -> Fraction | None:
    """Return a literal number, None where it is none."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        inner = _number(node.operand)
        return None if inner is None else -inner
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):  # a half is written 1/2
        top, below = _number(node.left), _number(node.right)
        return None if top is None or not below else top / below
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool):
        return Fraction(node.value)
    return None


def _value(node: ast.expr, values: Mapping[str, Array | float]) -> Any:
    if isinstance(node, ast.Name):
        return values[node.id]
    if isinstance(node, ast.Constant):
        return node.value
    if isinstance(node, ast.BinOp):
        exponent = _number(node.right) if isinstance(node.op, ast.Pow) else None
        right = _value(node.right, values) if exponent is None else float(exponent)
        return _OPERATIONS[type(node.op)](_value(node.left, values), right)
    if isinstance(node, ast.UnaryOp):
        return -_value(node.operand, values) if isinstance(node.op, ast.USub) else _value(node.operand, values)
    if isinstance(node, ast.Compare):
        return _OPERATIONS[type(node.ops[0])](_value(node.left, values), _value(node.comparators[0], values))
    assert isinstance(node, ast.Call)  # all else was refused
    name = _called(node)
    if name == LAG:
        return values[ast.unparse(node)]
    if name == "Piecewise":
        cases = [case.elts for case in node.args if isinstance(case, ast.Tuple)]
        out = _value(cases[-1][0], values)
        for value, condition in reversed(cases[:-1]):
            out = np.where(_value(condition, values), _value(value, values), out)
        return out
    function, arguments = FUNCTIONS[name][0], [_value(a, values) for a in node.args]
    out = function(*arguments[:2])
    for more in arguments[2:]:
        out = function(out, more)
    return out


def _summands(node: ast.expr) -> list[ast.expr]:
    """Return what a sum is made of."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        return [*_summands(node.left), *_summands(node.right)]
    if isinstance(node, ast.UnaryOp):
        return _summands(node.operand)
    return [node]


def _outer(node: ast.expr) -> str | None:
    """Return the first factor of a product, where that is a name."""
    while isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult | ast.Div):
        node = node.left
    return node.id if isinstance(node, ast.Name) else None


# ------------------------------------------------------------------------------------------------------------- units


def unit(text: str) -> Unit:
    """Return a unit as ``rad/s^2``, ``N mm`` or ``mm/(N K)`` writes it; of a number 1."""
    above, _, below = text.partition("/")
    out: Unit = {}
    for part, sign in ((above, 1), (below.strip("() "), -1)):
        for factor in part.split():
            name, _, power = factor.partition("^")
            if name != "1":
                out[name] = out.get(name, Fraction(0)) + sign * Fraction(power or 1)
    return out


def written(of: Unit) -> str:
    """Return a unit as text, `unit`'s inverse."""

    def product(sign: int) -> list[str]:
        return [n if sign * p == 1 else f"{n}^{float(sign * p):g}" for n, p in of.items() if sign * p > 0]

    above, below = " ".join(product(1)) or "1", product(-1)
    if not below:
        return above
    return f"{above}/{below[0]}" if len(below) == 1 else f"{above}/({' '.join(below)})"


class _Units:
    """Units of a formula: exponents of known units, and of those sought, by name; equations between them."""

    def __init__(self, known: Mapping[str, Unit], sought: list[str]) -> None:
        self._known, self._sought = known, sought
        self._equations: list[tuple[Unit, Unit, str]] = []  # exponents of sought units, of known ones; where

    def solved(self, tree: ast.expr, of: Unit) -> dict[str, Unit]:
        self._same(self._of(tree), ({}, of), tree)
        rows = [(dict(a), dict(b), where) for a, b, where in self._equations]
        pivots: list[tuple[str, Unit, Unit]] = []
        for name in reversed(self._sought):  # what comes last in a formula is told by what stands beside it
            k = next((k for k, (a, _, _) in enumerate(rows) if a.get(name)), None)
            if k is None:
                continue
            a, b, _ = rows.pop(k)
            a, b = _times(a, 1 / a[name]), _times(b, 1 / a[name])
            rows = [
                (_plus(ra, a, -ra.get(name, Fraction(0))), _plus(rb, b, -ra.get(name, Fraction(0))), w)
                for ra, rb, w in rows
            ]
            pivots.append((name, a, b))
        for _, left, where in rows:
            if set(_clean(left)) - {"rad"}:  # an angle is a number
                raise ValueError(f"units do not agree in '{where}': {written(_clean(left))} is left over.")
        out: dict[str, Unit] = {name: {} for name in self._sought}
        for name, a, b in reversed(pivots):
            rest = b
            for other, power in a.items():
                if other != name:
                    rest = _plus(rest, out[other], power)
            out[name] = _clean(_times(rest, Fraction(-1)))
        return out

    def _same(self, a: tuple[Unit, Unit], b: tuple[Unit, Unit], node: ast.expr) -> None:
        one = Fraction(-1)
        self._equations.append((_clean(_plus(a[0], b[0], one)), _plus(a[1], b[1], one), ast.unparse(node)))

    def _of(self, node: ast.expr) -> tuple[Unit, Unit]:
        """Return the unit of a part of a formula."""
        if isinstance(node, ast.Name):
            return ({}, dict(self._known[node.id])) if node.id in self._known else ({node.id: Fraction(1)}, {})
        if isinstance(node, ast.UnaryOp):
            return self._of(node.operand)
        if isinstance(node, ast.BinOp):
            return self._of_operation(node)
        if isinstance(node, ast.Compare):
            return self._alike([node.left, node.comparators[0]], node)
        if isinstance(node, ast.Call):
            return self._of_call(node)
        return {}, {}

    def _of_operation(self, node: ast.BinOp) -> tuple[Unit, Unit]:
        if isinstance(node.op, ast.Add | ast.Sub):
            return self._alike([node.left, node.right], node)
        left = self._of(node.left)
        if isinstance(node.op, ast.Pow):
            power = _number(node.right) or Fraction(0)
            return _times(left[0], power), _times(left[1], power)
        right, sign = self._of(node.right), Fraction(1 if isinstance(node.op, ast.Mult) else -1)
        return _plus(left[0], right[0], sign), _plus(left[1], right[1], sign)

    def _of_call(self, node: ast.Call) -> tuple[Unit, Unit]:
        name = _called(node)
        if name == "Piecewise":
            cases = [case.elts for case in node.args if isinstance(case, ast.Tuple)]
            for _, condition in cases[:-1]:
                self._of(condition)
            return self._alike([value for value, _ in cases], node)
        if name == LAG:
            self._same(self._of(node.args[1]), ({}, {"s": Fraction(1)}), node)
            return self._of(node.args[0])
        if name in _ALIKE:
            return self._alike(list(node.args), node)
        inside = self._of(node.args[0])
        if name == "sqrt":
            return _times(inside[0], Fraction(1, 2)), _times(inside[1], Fraction(1, 2))
        if name not in ("sign", "Heaviside"):  # which ask for the sign alone
            self._same(inside, ({}, {"rad": Fraction(1)} if name in ("sin", "cos") else {}), node)
        return {}, {"rad": Fraction(1)} if name == "asin" else {}

    def _alike(self, parts: list[ast.expr], node: ast.expr) -> tuple[Unit, Unit]:
        """Return the unit of parts that have the same; nought has any."""
        found = [self._of(p) for p in parts if _number(p) != 0]
        for other in found[1:]:
            self._same(found[0], other, node)
        return found[0] if found else ({}, {})


def _times(of: Unit, by: Fraction) -> Unit:
    return {name: power * by for name, power in of.items()}


def _plus(a: Unit, b: Unit, by: Fraction) -> Unit:
    out = dict(a)
    for name, power in b.items():
        out[name] = out.get(name, Fraction(0)) + by * power
    return out


def _clean(of: Unit) -> Unit:
    return {name: power for name, power in of.items() if power}
