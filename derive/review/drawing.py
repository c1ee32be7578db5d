r"""A machine drawn from its own equations: which of its vectors are points, which are joined, and how long.

A point moves along when the origin is moved, a difference of points does not. The platform's position P is a point, a
product with a rotation is none, and the vector of a closure is the difference of two; that decides the rest, step by
step: ``A = P + R (..)`` is a point, so is C in ``d = A - C``, so is B in ``C = B + R (..)``. A point is joined to the
one that it is built on, and the two ends of a closure's vector to one another: what of it depends on the platform is
one end, the rest the other.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import sympy as sp

from derive.backends import scalar
from derive.review.machine import Written
from derive.review.written import Form, Named, Product, Sum, exactly
from derive.spec import LimbMechanism

Vector = tuple[float, float, float]
PATH = 13  # points of the path that a joint's motion draws
SWING = 0.45  # of that path to either side of the pose [rad], and as part of a sliding joint's longest link


class Pose(NamedTuple):
    """A machine's coordinates, its joints, its tool point (3) and its limbs' rows of parameters [mm, rad]."""

    x: Sequence[float]
    q: Sequence[float]
    tool: Sequence[float]
    rows: Sequence[Sequence[float]]


def drawing(exact: LimbMechanism, written: Written, at: Pose) -> dict[str, Any]:
    """Return points, lines and paths of a machine at a pose, in {O} [mm]."""
    pose = dict(zip((q.symbol.name for q in exact.platform), at.x, strict=True))
    names = list(written.steps.written)
    forms = {n: f for n in names if (f := _form(written, n, names)) is not None}
    ends = _closures(written, names, forms)
    points = _points(forms, ends)
    values = _evaluator(exact)
    platform = {q.symbol for q in exact.platform}
    moved = _dependent(written, platform)
    turned = _dependent(written, {exact.joint.symbol})
    known = {e.quantity.symbol.name: e.quantity.symbol for e in exact.geometry if e.quantity.unit == "mm"}

    def side(name: str) -> str:
        return "platform" if name in moved else "link" if name in turned else "base"

    joint = exact.joint.symbol.name
    found: dict[str, Any] = {"points": [], "lines": [], "paths": [], "P": _position(pose), "joint": joint}
    for limb, values_of_limb in enumerate(at.rows):
        row = dict(zip((q.symbol.name for q in exact.limb_parameters), values_of_limb, strict=True))
        inputs = {**pose, **dict(zip(("tx", "ty", "tz"), at.tool, strict=True)), **row}

        def place(name: str, changed: Mapping[str, float], inputs: Mapping[str, float] = inputs) -> Vector:
            return _of(values({**inputs, **changed}), name, pose)

        here = {joint: at.q[limb]}
        for name in points:
            found["points"].append({"name": name, "limb": limb + 1, "at": place(name, here), "on": side(name)})
        for name in points:
            start = next((n for c, n in _named(forms[name]) if c == 1 and (n in points or n == "P")), None)
            here_is = partial(place, name)
            if start is not None:
                found["lines"].append(_line((partial(place, start), here_is), here, known, row, limb, side(name)))
            elif name in turned and name not in moved:  # an arm without a named joint stands where it does not move
                foot = partial(_fixed_part, written, forms[name], values, inputs, turned)
                found["lines"].append(_line((foot, here_is), here, known, row, limb, "link"))
                found["lines"].append(_line((_origin, foot), here, known, row, limb, "base"))
            else:
                found["lines"].append(_line((_origin, here_is), here, known, row, limb, side(name)))
        for terms, length in ends:
            head = {n: c for n, c in terms.items() if n in moved or n == "P"}
            tail = {n: -c for n, c in terms.items() if n not in head}
            sides = [partial(_sum, part, place) for part in (tail, head)]
            for part, end in zip((tail, head), sides, strict=True):
                point = next((n for n, c in part.items() if c == 1 and (n in points or n == "P")), None)
                if point is not None and len(part) > 1:
                    kind = "link" if part is tail else "platform"
                    found["lines"].append(_line((partial(place, point), end), here, known, row, limb, kind))
            if length is not None:
                entry = _line((sides[0], sides[1]), here, {}, row, limb, "rod")
                entry["label"] = length
                found["lines"].append(entry)
        for name in points:
            if name in turned and name not in moved:
                size = SWING if exact.joint.unit == "rad" else SWING * _longest(found["lines"])
                steps = [size * (2 * k / (PATH - 1) - 1) for k in range(PATH)]
                path = [place(name, {joint: at.q[limb] + s}) for s in steps]
                found["paths"].append({"limb": limb + 1, "points": path})
    found["lines"] = [line for line in found["lines"] if math.dist(line["from"], line["to"]) > 1e-6]
    return found


def _position(x: Mapping[str, float]) -> Vector:
    return x.get("px", 0.0), x.get("py", 0.0), x.get("pz", 0.0)


def _longest(lines: list[dict[str, Any]]) -> float:
    return max((math.dist(line["from"], line["to"]) for line in lines), default=1.0)


def _origin(changed: Mapping[str, float]) -> Vector:
    return 0.0, 0.0, 0.0


def _form(written: Written, name: str, names: list[str]) -> Form | None:
    value = written.value(name)
    if not isinstance(value, sp.MatrixBase) or value.shape != (3, 1):
        return None
    return written.reader(names[: names.index(name)]).read(value)


def _named(form: Form) -> list[tuple[sp.Expr, str]]:
    """Return the vectors that a form adds up, with their factors; products with rotations are left out."""
    terms = form.terms if isinstance(form, Sum) else ((sp.Integer(1), form),)
    return [(c, f.name) for c, f in terms if isinstance(f, Named)]


def _closures(
    written: Written, names: list[str], forms: Mapping[str, Form]
) -> list[tuple[dict[str, sp.Expr], str | None]]:
    """Return each closure's vector as a sum of vectors, and the symbol of its length where it has one."""
    reader = written.reader(names)
    found: list[tuple[dict[str, sp.Expr], str | None]] = []
    geometry = {e.quantity.symbol for e in written.mechanism.geometry}
    defined = written.defined
    for equation in written.mechanism.loop_closure:
        norms, rest = reader.norms(equation)
        if norms:
            lengths = {s for s in rest.free_symbols for s in ({s} if s in geometry else defined.get(s, s).free_symbols)}
            own = sorted(str(s) for s in lengths & geometry)
            found.append((_differences(norms[0][1], forms), own[0] if len(own) == 1 else None))
            continue
        terms: dict[str, sp.Expr] = {}
        for name, symbols in written.steps.written.items():
            if isinstance(symbols, sp.MatrixBase) and symbols.shape == (3, 1):
                for s in symbols:
                    if s != 0 and (c := equation.coeff(s)) != 0:
                        terms[name] = c
        if terms and terms not in [t for t, _ in found]:
            found.append((terms, None))
    return [(t, n) for k, (t, n) in enumerate(found) if not any(set(t) < set(u) for u, _ in found[:k] if n is None)]


def _differences(form: Form, forms: Mapping[str, Form]) -> dict[str, sp.Expr]:
    """Return a form as a sum of named vectors, those that are sums of named vectors written out."""
    terms = form.terms if isinstance(form, Sum) else ((sp.Integer(1), form),)
    total: dict[str, sp.Expr] = {}
    for c, f in terms:
        if not isinstance(f, Named):
            continue
        inner = forms.get(f.name)
        parts = inner.terms if isinstance(inner, Sum) else ()
        if inner and parts and all(isinstance(p, Named) and k.is_number and p.name in forms for k, p in parts):
            for n, k in _differences(inner, forms).items():
                total[n] = total.get(n, sp.Integer(0)) + c * k
        else:
            total[f.name] = total.get(f.name, sp.Integer(0)) + c
    return total


def _points(forms: Mapping[str, Form], ends: list[tuple[dict[str, sp.Expr], str | None]]) -> list[str]:
    """Return the names of the vectors that are points; a vector that nothing decides is none."""
    is_point = {n: sp.Symbol(n) for n in forms}
    one = {"P": sp.Integer(1)}
    equations = []
    for name, form in forms.items():
        terms = _named(form)
        products = [f for _, f in (form.terms if isinstance(form, Sum) else ((1, form),)) if isinstance(f, Product)]
        last = [getattr(f.factors[-1], "name", "") for f in products]
        equations += [is_point[n] for n in last if n in is_point]
        if products and len(products) == len(getattr(form, "terms", (form,))):
            equations.append(is_point[name])
        for c, n in terms:
            if not c.is_number and n in is_point:
                equations.append(is_point[n])
        numeric = [(c, n) for c, n in terms if c.is_number and (n in is_point or n == "P")]
        if numeric:
            equations.append(is_point[name] - sum(c * is_point.get(n, one.get(n, 0)) for c, n in numeric))
    for ended, _ in ends:
        equations.append(sum(c * is_point.get(n, one.get(n, 0)) for n, c in ended.items()))
    solved = sp.solve(equations, list(is_point.values()), dict=True)
    known = solved[0] if solved else {}
    none = dict.fromkeys(is_point.values(), 0)  # what is open: an earlier vector is where a later one starts
    return [name for name, s in is_point.items() if known.get(s, sp.Integer(0)).subs(none) == 1]


def _dependent(written: Written, on: set[sp.Symbol]) -> set[str]:
    """Return the steps that change with some inputs."""
    moving: set[sp.Symbol] = set(on)
    for s, e in written.mechanism.steps:
        if e.free_symbols & moving:
            moving.add(s)
    return {n for n, v in written.steps.written.items() if set(v if isinstance(v, sp.MatrixBase) else [v]) & moving}


def _evaluator(exact: LimbMechanism) -> Callable[[Mapping[str, float]], dict[str, float]]:
    """Return what evaluates all steps at numbers."""
    lines = "\n".join(f"{s} = {scalar.PRINTER.expression(e)}" for s, e in exact.steps)
    code = compile(lines, exact.source, "exec")

    def values(inputs: Mapping[str, float]) -> dict[str, float]:
        scope: dict[str, Any] = {"math": math, **inputs}
        exec(code, scope)
        return scope

    return values


def _of(scope: Mapping[str, float], name: str, x: Mapping[str, float]) -> Vector:
    if name == "P":
        return x.get("px", 0.0), x.get("py", 0.0), x.get("pz", 0.0)
    a, b, c = (float(scope.get(f"{name}_{axis}", 0.0)) for axis in "xyz")
    return a, b, c


def _sum(part: Mapping[str, sp.Expr], place: Callable[..., Vector], changed: Mapping[str, float]) -> Vector:
    at = [[float(c) * e for e in place(n, changed)] for n, c in part.items()]
    x, y, z = (sum(column) for column in zip(*at, strict=True))
    return x, y, z


def _fixed_part(
    written: Written,
    form: Form,
    values: Callable[[Mapping[str, float]], dict[str, float]],
    inputs: Mapping[str, float],
    turned: set[str],
    changed: Mapping[str, float],
) -> Vector:
    """Return the part of a vector that the joint does not move: where a limb stands on the base."""
    scope = values({**inputs, **changed})
    moving = {written.mechanism.joint.symbol} | {s for n in turned for s in _symbols(written.steps.written[n])}
    terms = form.terms if isinstance(form, Sum) else ((sp.Integer(1), form),)
    total = [0.0, 0.0, 0.0]
    for c, f in terms:
        e = (c * f.explicit()).applyfunc(exactly)
        if not e.free_symbols & moving:
            for k in range(3):
                total[k] += float(sp.N(e[k].xreplace({s: sp.Float(scope[s.name]) for s in e[k].free_symbols})))
    return total[0], total[1], total[2]


def _symbols(value: sp.Expr | sp.Matrix) -> set[sp.Symbol]:
    return set(value) if isinstance(value, sp.MatrixBase) else {value}


def _line(
    ends: tuple[Callable[[Mapping[str, float]], Vector], Callable[[Mapping[str, float]], Vector]],
    here: Mapping[str, float],
    geometry: Mapping[str, sp.Symbol],
    row: Mapping[str, float],
    limb: int,
    kind: str,
) -> dict[str, Any]:
    """Return a line, with the dimension that is its length, or half of it, where there is one."""
    length = math.dist(ends[0](here), ends[1](here))
    slopes = {}
    for name in geometry:
        changed = {**here, name: row[name] + 1e-3}  # a dimension, by a thousandth of a millimetre
        slopes[name] = (math.dist(ends[0](changed), ends[1](changed)) - length) / 1e-3
    strong = {n: s for n, s in slopes.items() if abs(s) > 1e-3}
    label = None
    if len(strong) == 1:
        ((name, slope),) = strong.items()
        label = name if abs(slope - 1) < 1e-3 else f"{name}/2" if abs(slope - 0.5) < 1e-3 else None
    return {"from": ends[0](here), "to": ends[1](here), "limb": limb + 1, "kind": kind, "label": label}
