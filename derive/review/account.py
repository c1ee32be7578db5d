"""The account of a derivation: what is shown of a machine, an effect or an instrument, as formulas with places."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import COORDINATES, mechanism_of
from deltacal_gen.machine.rotation import cayley_vector
from derive import closed_form, registry, vectors
from derive.graph import Graph
from derive.language.effects import Effect, EffectQuantity
from derive.language.states import State
from derive.language.targets import PARTS
from derive.mathematics.derivative import derivative
from derive.review import checks, laws
from derive.review import typeset as ts
from derive.review.directions import unseen_of, unseen_of_chain
from derive.review.drawing import Pose, drawing
from derive.review.laws import Law, entries
from derive.review.machine import Written, difference
from derive.review.sources import Lines, Place, of_function
from derive.review.typeset import Math, Shown
from derive.review.written import OPAQUE, Entries, Reader, tidy
from derive.spec import ChainMechanism, Joint, LimbMechanism, Measurement, Platform, Quantity, Screw, Steps

TARGETS = ("joint", "limb.part", "turn.axis", "tool.axis", "reading.axis")  # one of each kind that an effect moves
LONGEST = 40  # operations of a formula that a reader wants to see


def table(quantities: Iterable[Quantity], symbols: Shown) -> list[dict[str, Any]]:
    """Return rows of a table: symbol, name, unit, meaning."""
    return [
        {
            "symbol": ts.expression(q.symbol, symbols),
            "name": q.name,
            "unit": q.unit,
            "meaning": q.meaning,
            "typical": q.typical,
        }
        for q in quantities
    ]


def mechanism(name: str, robot: Robot | None = None) -> dict[str, Any]:
    """Return the account of a registered mechanism.

    Parameters
    ----------
    robot : Robot, optional
        A machine in numbers, without which there is neither a null space nor a drawing.
    """
    exact = registry.mechanism(name)
    return _chain(exact, robot) if isinstance(exact, ChainMechanism) else _limbs(exact, robot)


def _limbs(exact: LimbMechanism, robot: Robot | None) -> dict[str, Any]:
    written = Written(exact.name)
    machine = written.mechanism
    steps: list[dict[str, Any]] = []
    for name in written.steps.written:
        steps.append(written.step(name, [s["name"] for s in steps]))
    closures = [written.closure(e) for e in machine.loop_closure]
    weights = [
        {
            "of": of,
            "mass": written.scalar(weight.mass),
            "point": written.formula(written.reader([s["name"] for s in steps]).read(weight.point)),
            "place": written.lines.keyword(f"{of}_weights"),
        }
        for of, weights in (("limb", machine.limb_weights), ("platform", machine.platform_weights))
        for weight in weights
    ]
    where = []
    for name in list(written.used):
        shown = Entries(sp.ImmutableMatrix(written.abbreviations[name])).math(written.symbols)
        at = Place(written.lines.path, written.steps.lines[name])
        where.append({"name": name, "formula": ts.equation(ts.vector(name), shown), "place": at})
    turns = any(q.name.startswith("c") for q in machine.platform)
    rotations = laws.rotations_used(written.rotations)
    return {
        "kind": "limbs",
        **_head(machine),
        "limbs": machine.limbs,
        "tables": {
            "platform": table(machine.platform, written.symbols),
            "joint": table([machine.joint], written.symbols),
            "tool": table(machine.tool, written.symbols),
            "geometry": [
                {**row, "key": g.key}
                for g, row in zip(
                    machine.geometry, table([g.quantity for g in machine.geometry], written.symbols), strict=True
                )
            ],
            "errors": table(machine.errors, written.symbols),
            "common": table(machine.common, written.symbols),
            "deflections": table(machine.deflections, written.symbols),
            "masses": table(machine.masses, written.symbols),
        },
        "where": where,
        "rotations": [{**vars(whole), "differential": change.formula} for whole, change in rotations],
        "steps": steps,
        "closures": closures,
        "implicit": _shown(laws.implicit(turns, written.lines.keyword("loop_closure"))),
        "gradient": {"place": of_function(Graph.gradient), "ends": ["newton", "parameters"]},
        "statics": _shown(laws.virtual_work(bool(machine.deflections or machine.rods))) if weights else [],
        "weights": weights,
        "seeds": seeds(exact, written),
        "home": exact.home is not None,
        "moves": _moves(written),
        "drawing": None if robot is None else drawing(exact, written, _middle(robot)),
        "unseen": None if robot is None else unseen_of(exact, written, robot),
    }


def _middle(robot: Robot) -> Pose:
    """Return the pose in the middle of a machine's workspace, in the coordinates of its mechanism."""
    mechanism, pose = mechanism_of(robot), checks.middle(robot)
    body = np.concatenate([pose.x[0, :3], cayley_vector(pose.x[:, 3:].reshape(-1, 3, 3))[0]])
    x = [float(body[COORDINATES.index(name)]) for name in mechanism.platform]
    return Pose(x, pose.q[0].tolist(), np.asarray(robot.tool).tolist(), mechanism.rows(robot)[0].tolist())


def _shown(found: Iterable[Law]) -> list[dict[str, Any]]:
    return [dict(vars(law)) for law in found]


def _moves(written: Written) -> list[dict[str, Any]]:
    """Return which errors and deflections an effect's parts are on this machine, and how much of each."""
    machine = written.mechanism
    own = {q.name: q.symbol for q in (*machine.errors, *machine.common, *machine.deflections)}
    found = []
    for part, how in machine.moves.items():
        moved = ts.words(part)
        sides = [
            ts.equation(
                ts.row(ts.letter("Δ"), written.scalar(own[n])), ts.row(_times(written, e), ts.letter("Δ"), moved)
            )
            for n, e in how.items()
        ]
        found.append({"part": part, "meaning": PARTS.get(part, part), "formula": ts.separated(sides, ",")})
    return found


def _times(written: Written, e: sp.Expr) -> Math:
    e = sp.sympify(e)
    return ts.EMPTY if e == 1 else ts.op("−") if e == -1 else written.scalar(e) + ts.thin()


def _head(spec: LimbMechanism | ChainMechanism) -> dict[str, Any]:
    return {
        "name": spec.name,
        "title": spec.title,
        "reference": spec.reference,
        "source": spec.source,
        "docstring": inspect.getdoc(registry.file_of(spec)) or "",
    }


def seeds(exact: LimbMechanism, written: Written) -> list[dict[str, Any]]:
    """Return what Newton's method starts from, where it is short enough to be read."""
    found: list[dict[str, Any]] = []
    given = exact.seeds if exact.home is None else exact.home
    if given is not None:
        for s, e in given.items():
            if sp.count_ops(e) <= 2 * LONGEST:
                found.append({"formula": ts.equation(written.scalar(s), written.scalar(e)), "place": None})
        return found
    centre, _ = closed_form.sphere(exact)
    shown = entries(centre.applyfunc(lambda e: tidy(sp.expand(e))), written.symbols)
    return [vars(laws.sphere()), {"formula": ts.equation(ts.vector("c"), shown), "place": None}]


def _chain(spec: ChainMechanism, robot: Robot | None) -> dict[str, Any]:
    """Return the account of an open chain: one link of each convention, its twists by each error and by its joint."""
    symbols: dict[sp.Symbol, Math] = {e.symbol: difference(e.name) for e in spec.errors}
    look: Shown = symbols.get
    lines = Lines(spec.source)
    d = ts.words("d")
    varied = {v.symbol: sp.Symbol(f"d {v.symbol}") for v in (*spec.errors, *spec.joint)}
    moving = {change: ts.row(d, ts.expression(s, look)) for s, change in varied.items()}
    chain = None if robot is None else mechanism_of(robot)
    common = () if chain is None else (p for p in chain.parameters if not p.limb)
    steps = []
    for s, e in spec.steps:
        moved = (ts.expression(sp.diff(e, v) * change, moving.get) for v, change in varied.items() if e.has(v))
        steps.append(
            {
                "name": str(s),
                "formula": ts.equation(ts.name(str(s)), ts.expression(e, look)),
                "differential": ts.equation(ts.row(d, ts.name(str(s))), ts.separated(moved, "+")),
                "place": lines.keyword("steps"),
                "entries": [str(s)],
            }
        )
    at = lines.keyword("transforms")
    return {
        "kind": "chain",
        "gradient": {
            "place": of_function(vectors.follow),
            "ends": [f"reach_{convention}" for convention in spec.transforms],
        },
        **_head(spec),
        "tables": {
            "joint": table(spec.joint, look),
            "geometry": [
                {**row, "key": g.key}
                for g, row in zip(spec.geometry, table([g.quantity for g in spec.geometry], look), strict=True)
            ],
            "errors": table(spec.errors, look),
            "common": [
                {"symbol": difference(p.name), **{k: getattr(p, k) for k in ("name", "unit", "meaning", "typical")}}
                for p in common
            ],
        },
        "where": [],
        "rotations": [],
        "steps": steps,
        "moves": [],
        "links": [{**_link(convention, screws, look), "place": at} for convention, screws in spec.transforms.items()],
        "statics": _shown(laws.weights_of_links()),
        "weights": [],
        "unseen": None if robot is None else unseen_of_chain(spec, robot),
    }


def _link(convention: str, screws: Sequence[Screw], look: Shown) -> dict[str, Any]:
    """Return what a link of a convention is: its product of screws, its rotation and shift, its twists."""
    R, shift, twists = vectors.follow(screws)
    factors = []
    for screw in screws:
        axis = ts.letter(screw.axis)
        for title, amount in (("R", screw.turn), ("T", screw.shift)):
            if amount != 0:
                head = ts.sub(ts.letter(title, bold=True), axis)
                factors.append(ts.row(head, ts.brackets(ts.expression(amount, look))))
    return {
        "convention": convention,
        "product": ts.row(*factors),
        "rotation": entries(R),
        "shift": entries(shift),
        "twists": [
            {"by": ts.name(str(by)), "shift": entries(twist[:3, :]), "turn": entries(twist[3:, :])}
            for by, twist in twists.items()
        ],
        "ends": [f"{what}_{convention}" for what in ("place", "reach")],
    }


def effect(name: str) -> dict[str, Any]:
    """Return the account of a registered effect: what it reads, remembers and moves, and its columns."""
    spec = registry.effect(name)
    look = _coefficients(spec)

    def row(q: EffectQuantity | State) -> dict[str, Any]:
        return {"symbol": ts.expression(q.symbol, look), "name": q.name, "unit": q.unit, "meaning": q.meaning}

    return {
        "kind": "effect",
        "name": spec.name,
        "title": spec.title,
        "source": spec.source,
        "docstring": inspect.getdoc(registry.file_of(spec)) or "",
        "per_limb": spec.per_limb,
        "advice": spec.advice,
        "coefficients": [row(q) for q in spec.coefficients],
        "constants": [row(q) for q in spec.constants],
        "states": [row(q) for q in spec.states],
        "memory": memories(spec),
        "targets": [{**target, "place": Lines(spec.source).keyword("targets")} for target in targets(spec)],
        "chain": _shown(laws.reaches(spec.targets, loaded=any(s.kind == "load" for s in spec.states))),
    }


def _coefficients(spec: Effect) -> Shown:
    """Return how coefficients are shown: one called cos or xy is neither a function nor a product."""
    odd = [c for c in spec.coefficients if c.name in ("cos", "sin") or set(c.name) <= {"x", "y"}]
    shown: dict[sp.Expr, Math] = {c.symbol: ts.sub(ts.letter("c"), ts.words(c.name)) for c in odd}
    return shown.get


def memories(spec: Effect) -> list[dict[str, Any]]:
    """Return what an effect remembers: how it changes with time, and where it starts."""
    look, d = _coefficients(spec), ts.words("d")
    found = []
    for memory in spec.memory:
        z = ts.expression(memory.symbol, look)
        rate = ts.equation(ts.frac(ts.row(d, z), ts.row(d, ts.letter("t"))), ts.expression(memory.rate, look))
        start = ts.equation(ts.row(z, ts.brackets(ts.number(0))), ts.expression(memory.start, look))
        found.append({"meaning": memory.meaning, "rate": rate, "start": start})
    return found


def targets(spec: Effect) -> list[dict[str, Any]]:
    """Return what an effect moves, and the derivatives by its coefficients, one-sided where a formula has a kink."""
    look, found = _coefficients(spec), []
    for target, e in spec.targets.items():
        moved = ts.row(ts.letter("Δ"), ts.words(target))
        columns = [
            ts.equation(ts.partial(moved, ts.expression(c.symbol, look)), ts.expression(derivative(e, c.symbol), look))
            for c in spec.coefficients
        ]
        formula = ts.equation(moved, ts.expression(e, look))
        found.append({"target": target, "meaning": target_meaning(target), "formula": formula, "columns": columns})
    return found


def target_meaning(target: str) -> str:
    """Return what a target of an effect is, in words."""
    kind, _, part = target.partition(".")
    return {
        "joint": "angle or way of the joint: what the geometry sees less what the controller reports",
        "limb": PARTS.get(part, part),
        "turn": f"turn of the base about {{O}}, axis {part}",
        "tool": f"measured point in {{O'}}, {part}",
        "reading": f"reading along the instrument's {part}",
        "length": "reading of a length",
        "height": "reading of a height",
        "torque": "what the joint's drive gives, beside what the rigid machine asks of it",
    }.get(kind, target)


def reader_of(spec: Measurement) -> Reader:
    """Return what reads an instrument's formulas: its platforms' and its own vectors and matrices are known by name."""
    vectors = {f"P{suffix}": p.position for p, suffix in _suffixed(spec)}
    vectors |= {f"s{suffix}": p.turn for p, suffix in _suffixed(spec)}
    matrices = {f"R{suffix}": p.rotation for p, suffix in _suffixed(spec)}
    own = [*(q.symbol for q in (*spec.given, *spec.unknown)), *(s for s, _ in spec.steps)]
    entries_of: dict[str, list[sp.Symbol]] = {}
    for s in own:  # gx gy gz, c_x c_y c_z; F11 ... F33
        entries_of.setdefault(re.sub(r"(_?[xyz]|[1-3]{2})$", "", str(s)), []).append(s)
    vectors |= {name: sp.Matrix(e) for name, e in entries_of.items() if len(e) == 3}
    matrices |= {name: sp.Matrix(3, 3, e) for name, e in entries_of.items() if len(e) == 9}
    return Reader(vectors, matrices, ts.vector, transposes=True)


def measurement(name: str) -> dict[str, Any]:
    """Return the account of a kind of measurement: its reading in terms of the platform and the instrument."""
    spec = registry.measurement(name, OPAQUE)
    lines, reader = Lines(spec.source), reader_of(spec)
    y = ts.letter("y")
    steps = list(_steps(spec.steps, reader))
    readings: list[Math] = []
    if {"x_mm", "y_mm", "z_mm"} <= {*spec.columns}:  # of a point
        form = reader.read(sp.Matrix(spec.reading))
        readings.append(ts.equation(ts.letter("y", bold=True), form.math(lambda s: None)))
    elif len(spec.reading) == 1:
        readings.append(ts.equation(y, _length(spec.reading[0], reader)))
    else:
        readings += [ts.equation(ts.sub(y, ts.number(n + 1)), ts.expression(e)) for n, e in enumerate(spec.reading)]
    if spec.rotation:
        factors = [reader.read(sp.Matrix(M)).math(lambda s: None) for M in spec.rotation]
        spaced = [e for f in factors for e in (ts.thin(), f)][1:]
        readings.append(ts.equation(ts.letter("Y", bold=True), ts.row(*spaced)))
    return {
        "kind": "measurement",
        "name": spec.name,
        "meaning": spec.meaning,
        "source": spec.source,
        "docstring": inspect.getdoc(registry.file_of(spec)) or "",
        "of": _looked_at(spec.platforms),
        "columns": spec.columns,
        "known": [q.name for q in spec.known],
        "steps": steps,
        "readings": readings,
        "given": _by_meaning(spec.given),
        "unknown": _by_meaning(spec.unknown),
        "place": lines.keyword("reading"),
    }


def _steps(steps: Steps, reader: Reader) -> Iterator[Math]:
    """Yield named quantities as formulas: of a vector, x, y and z one after the other, one formula."""
    waiting = list(steps)
    while waiting:
        stem, axis = str(waiting[0][0])[:-1], str(waiting[0][0])[-1]
        three = [str(s) for s, _ in waiting[:3]]
        if axis == "x" and three == [f"{stem}{other}" for other in "xyz"]:
            form = reader.read(sp.Matrix([e for _, e in waiting[:3]]))
            yield ts.equation(ts.vector(stem.removesuffix("_")), form.math(lambda s: None))
            waiting = waiting[3:]
        else:
            symbol, value = waiting.pop(0)
            yield ts.equation(ts.name(str(symbol)), ts.expression(tidy(value)))


def _looked_at(platforms: Sequence[Platform | Joint]) -> str:
    """Return what one reading is of, in words."""
    if len(platforms) > 1:
        return "the platform at two rows"
    return "the platform" if isinstance(platforms[0], Platform) else "one joint"


def _by_meaning(quantities: Iterable[Quantity]) -> list[dict[str, Any]]:
    """Return quantities that mean the same, the entries of a vector or matrix, under one symbol."""
    found: dict[str, list[Quantity]] = {}
    for q in quantities:
        found.setdefault(q.meaning.partition(", entry")[0], []).append(q)
    return [
        {
            "symbol": ts.name(re.sub(r"[xyz]$|_?11$", "", str(alike[0].symbol)), bold=True)
            if len(alike) > 1
            else ts.name(str(alike[0].symbol)),
            "names": [q.name for q in alike],
            "unit": "" if alike[0].unit == "1" else alike[0].unit,
            "meaning": meaning,
        }
        for meaning, alike in found.items()
    ]


def _suffixed(spec: Measurement) -> list[tuple[Any, str]]:
    return [(p, str(p.position[0])[2:]) for p in spec.platforms if isinstance(p, Platform)]


def _length(e: sp.Expr, reader: Reader) -> Math:
    """Return a reading in which the length of a vector occurs."""
    found = ts.EMPTY
    for n, term in enumerate(sp.Add.make_args(e)):
        base, exponent = term.as_base_exp()
        shown = ts.expression(term)
        if exponent == sp.Rational(1, 2):
            norms, rest = reader.norms(base)
            if len(norms) == 1 and rest == 0 and norms[0][0] == 1:
                shown = ts.brackets(norms[0][1].math(lambda s: None), "||")
        found = found + (ts.op("+") if n else ts.EMPTY) + shown
    return ts.row(found)
