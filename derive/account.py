r"""The account of a derivation: what a report shows of it, as plain data with formulas in MathML and LaTeX.

``python -m derive.account`` reads requests as JSON from its standard input, one list, and answers each with one line of
JSON. The runtime, which knows no SymPy, asks it so: numbers of a machine at one pose in, formulas out.
"""

from __future__ import annotations

import ast
import importlib
import inspect
import json
import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from derive import blocks, closed_form, notation, statics, unseen, vectors
from derive import typeset as ts
from derive.drawing import drawing
from derive.graph import Graph
from derive.language.states import State
from derive.language.targets import PARTS
from derive.spec import ChainMechanism, Effect, EffectQuantity, LimbMechanism, Measurement, Quantity
from derive.steps import Derivation
from derive.typeset import Math
from derive.written import (
    EXACT,
    ROTATIONS,
    Entries,
    Form,
    Named,
    Product,
    Reader,
    Sum,
    opaque,
    rotation_name,
    split,
    tidy,
)

ROOT = Path(__file__).resolve().parent.parent
Shown = Callable[[sp.Expr], Math | None]
LONGEST = 40  # operations of a vector that a file names beside its steps and a reader wants to see by name


def plain(value: Any) -> Any:
    """Return data for JSON: a formula is a pair of texts."""
    if isinstance(value, Math):
        return {"mathml": value.mathml, "latex": value.latex}
    if isinstance(value, Mapping):
        return {str(k): plain(v) for k, v in value.items()}
    if isinstance(value, Iterable) and not isinstance(value, str):
        return [plain(v) for v in value]
    return value


# --------------------------------------------------------------------------------------------------------- symbols


def typesetting(mechanism: LimbMechanism) -> Shown:
    """Return how a machine's symbols are shown: an error is the delta of what it is an error of."""
    shown: dict[sp.Symbol, Math] = {}
    taken: dict[str, int] = {}
    own = {e.symbol for e in mechanism.errors}
    for e in (*mechanism.common, *mechanism.errors):
        bare = e.name.replace("_{i}", "").replace("{i}", "")
        formula = _difference(bare)
        taken[formula.latex] = taken.get(formula.latex, 0) + 1
        if taken[formula.latex] > 1 and e.symbol in own:
            formula = ts.row(ts.letter("delta"), ts.sub(ts.name(bare), ts.letter("i")))
        shown[e.symbol] = formula
    return lambda s: shown.get(s)


def _difference(name: str) -> Math:
    formula = ts.name(name)
    return formula if formula.latex.startswith(r"\Delta") else ts.row(ts.letter("delta"), formula)


def vector_name(text: str) -> Math:
    """Return the name of a vector or matrix, bold; of its differential, with a d before it."""
    if text.startswith("d "):
        return ts.row(ts.words("d"), vector_name(text[2:]))
    return ts.name(text, bold=True)


class Lines:
    """Where in a source file things are written."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.tree = ast.parse((ROOT / path).read_text(encoding="utf-8"))

    def keyword(self, name: str) -> int:
        """Return the line of a keyword argument, of the function it calls where it calls one of this file."""
        calls = [node for node in ast.walk(self.tree) if isinstance(node, ast.Call)]
        found = [k for call in calls for k in call.keywords if k.arg == name]
        if not found:
            return 1
        inner = [n.func for n in ast.walk(found[-1].value) if isinstance(n, ast.Call)]
        called = {f.id for f in inner if isinstance(f, ast.Name)}
        own = [node.lineno for node in self.tree.body if isinstance(node, ast.FunctionDef) and node.name in called]
        return own[0] if own else found[-1].value.lineno

    def assigned(self) -> dict[str, int]:
        """Return the names that the file binds once, at its top level, with their lines."""
        found: dict[str, int] = {}
        for node in self.tree.body:
            if isinstance(node, ast.Assign):
                for target in node.targets:
                    for name in ast.walk(target):
                        if isinstance(name, ast.Name):
                            found[name.id] = node.lineno
        return found

    def imported(self) -> dict[str, str]:
        """Return the names that come from another mechanism, with the file they come from."""
        return {
            alias.asname or alias.name: (node.module or "").replace(".", "/") + ".py"
            for node in self.tree.body
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("derive.mechanisms")
            for alias in node.names
            if (ROOT / ((node.module or "").replace(".", "/") + ".py")).exists()
        }


def place(path: str, line: int) -> dict[str, Any]:
    """Return where something is written, for a link."""
    return {"file": path, "line": line}


def _of(function: Callable[..., Any]) -> dict[str, Any]:
    function = inspect.unwrap(function)
    return place(f"derive/{Path(inspect.getsourcefile(function) or '').name}", inspect.getsourcelines(function)[1])


def _in_template(template: str, text: str) -> dict[str, Any]:
    """Return where a template begins a function."""
    lines = (ROOT / template).read_text(encoding="utf-8").splitlines()
    return place(template, next(n for n, line in enumerate(lines, start=1) if line.startswith(text)))


# --------------------------------------------------------------------------------------------- a machine of limbs


class Written:
    """A mechanism read with its rotations opaque.

    Parameters
    ----------
    mechanism : LimbMechanism
        As `opaque` imports it.
    module : module
        Where it is written.
    """

    def __init__(self, mechanism: LimbMechanism, module: ModuleType) -> None:
        self.mechanism, self.module = mechanism, module
        self.lines = Lines(mechanism.source)
        self.symbols = typesetting(mechanism)
        self.steps = mechanism.steps if isinstance(mechanism.steps, Derivation) else Derivation()
        self.defined = dict(mechanism.steps)
        names = {quantity.name: quantity.symbol for quantity in mechanism.platform}
        position = [names.get(n, sp.Integer(0)) for n in ("px", "py", "pz")]
        flat = position[2] == 0
        tool = [q.symbol for q in mechanism.tool]
        self.base = {"P": sp.Matrix(position), "tool": sp.Matrix([*tool[:2], 0 if flat else tool[2]])}
        self.used: dict[str, None] = {}
        self.shown: dict[str, Math] = {}  # names that are typeset another way than by their letters
        self.rotations: dict[str, None] = {}
        self.fixed: set[str] = set()  # steps that nothing varied changes

    @cached_property
    def abbreviations(self) -> dict[str, tuple[sp.Matrix, dict[str, Any]]]:
        """Vectors and matrices that the file names beside its steps, with where; longer ones first."""
        bound, found = self.lines.assigned(), {}
        imported = self.lines.imported()
        taken = {sp.ImmutableMatrix(m) for m in (*self.base.values(), *self._matrices_of_steps())}
        for name, value in vars(self.module).items():
            if not isinstance(value, sp.MatrixBase) or value.shape not in ((3, 1), (3, 3)) or name in self.base:
                continue
            if sp.ImmutableMatrix(value) in taken or not value.free_symbols or name in self.steps.written:
                continue
            if sum(int(sp.count_ops(e)) for e in value) > LONGEST:
                continue
            if name in bound and sum(name in _targets(n) for n in ast.walk(self.lines.tree)) == 1:
                found[name] = (value, place(self.lines.path, bound[name]))
            elif name in imported:
                found[name] = (value, place(imported[name], Lines(imported[name]).assigned().get(name, 1)))
        return dict(sorted(found.items(), key=lambda e: -sum(int(sp.count_ops(x)) for x in e[1][0])))

    def _matrices_of_steps(self) -> list[sp.Matrix]:
        return [v for v in self.steps.written.values() if isinstance(v, sp.MatrixBase)]

    def reader(self, before: Iterable[str], moved: Mapping[str, sp.Matrix] | None = None) -> Reader:
        """Return what takes expressions apart into the steps `before` them, and differentials."""
        known = {n: self.steps.written[n] for n in before}
        known = {n: v for n, v in known.items() if isinstance(v, sp.MatrixBase)}
        extra = {n: v for n, (v, _) in self.abbreviations.items()}
        everything = {**(moved or {}), **known, **self.base, **extra}
        return Reader(
            {n: v for n, v in everything.items() if v.shape == (3, 1)},
            {n: v for n, v in everything.items() if v.shape == (3, 3)},
            lambda name: self.shown.get(name) or vector_name(name),
            self.symbols,
        )

    def value(self, name: str) -> sp.Expr | sp.Matrix:
        """Return the definition of a step, entry by entry, in terms of earlier ones."""
        symbols = self.steps.written[name]
        if isinstance(symbols, sp.MatrixBase):
            return symbols.applyfunc(lambda s: self.defined.get(s, s))
        return self.defined[symbols]

    def formula(self, form: Form) -> Math:
        """Return a form as a formula, and remember the abbreviations it uses."""
        self._note(form)
        return form.math(self._with_differentials)

    def _note(self, form: Form) -> None:
        if isinstance(form, Named) and form.name in self.abbreviations:
            self.used[form.name] = None
        if isinstance(form, Product):
            for f in form.factors:
                self._note(f)
        if isinstance(form, Sum):
            for _, f in form.terms:
                self._note(f)

    def scalar(self, e: sp.Expr) -> Math:
        """Return a scalar as a formula."""
        return ts.expression(e, self._with_differentials)

    # -------------------------------------------------------------------------------------------- differentials

    @cached_property
    def varied(self) -> dict[sp.Symbol, sp.Symbol]:
        """Inputs that are varied, and the steps, each with its differential."""
        inputs = [quantity.symbol for quantity in (*self.mechanism.platform, *self.mechanism.varied)]
        return {s: sp.Symbol(f"d {s}", real=True) for s in (*inputs, self.mechanism.joint.symbol, *self.defined)}

    def differentials(self, before: Sequence[str]) -> dict[str, sp.Matrix]:
        """Return the vectors and matrices of differentials of the steps and of the platform."""
        known = {n: self.steps.written[n] for n in before} | {"P": self.base["P"]}
        return {
            f"d {n}": v.applyfunc(lambda s: self.varied.get(s, sp.Integer(0)))
            for n, v in known.items()
            if isinstance(v, sp.MatrixBase) and v.applyfunc(lambda s: self.varied.get(s, 0)) != sp.zeros(*v.shape)
        }

    # --------------------------------------------------------------------------------------------------- the steps

    def step(self, name: str, before: Sequence[str]) -> dict[str, Any]:
        """Return a step and its differential, with the line that makes it."""
        value, symbols = self.value(name), self.steps.written[name]
        if not isinstance(symbols, sp.MatrixBase):
            left = ts.expression(symbols)
            right = self.scalar(value)
            moved = self._scalar_change(self.differential(value), before)
            entries = [str(symbols)]
        else:
            left = self.shown.get(name) or vector_name(name)
            form = self.reader(before).read(value)
            right = self.formula(form)
            for f in sorted(value.atoms(AppliedUndef), key=str):
                self.rotations[split(f)[0]] = None
            change = self.change(form, before)
            moved = self.formula(change) if change is not None else None
            entries = [str(s) for s in symbols if s != 0]
        if moved is None:
            self.fixed.add(name)
        d = ts.row(ts.words("d"), left)
        return {
            "name": name,
            "formula": ts.equation(left, right),
            "differential": None if moved is None else ts.equation(d, moved),
            "place": place(self.lines.path, self.steps.lines[name]),
            "entries": entries,
        }

    def change(self, form: Form, before: Sequence[str]) -> Form | None:
        """Return the differential of a form by the product rule, or None where nothing varied is in it."""
        terms: list[tuple[sp.Expr, Form]] = []
        if isinstance(form, Sum):
            for c, part in form.terms:
                if (slope := self.collected(self.differential(c))) != 0:
                    terms.append((slope, part))
                if (moved := self.change(part, before)) is not None:
                    terms += [(c * k, f) for k, f in _terms(moved)]
        elif isinstance(form, Product):
            for n, factor in enumerate(form.factors):
                if (moved := self.change(factor, before)) is not None:
                    for k, f in _terms(moved) if n < len(form.factors) - 1 else [(sp.Integer(1), moved)]:
                        terms.append((k, Product((*form.factors[:n], f, *form.factors[n + 1 :]))))
        elif isinstance(form, Entries):
            slopes = form.entries.applyfunc(lambda e: self.collected(self.differential(e)))
            if slopes != sp.zeros(*slopes.shape):
                terms += _terms(self.reader(before).read(slopes))
        elif isinstance(form, Named):
            return self._change_of_named(form, before)
        if not terms:
            return None
        return terms[0][1] if len(terms) == 1 and terms[0][0] == 1 else Sum(tuple(terms))

    def _change_of_named(self, form: Named, before: Sequence[str]) -> Form | None:
        entries = form.entries
        if form.name in self.abbreviations:
            slopes = entries.applyfunc(self.differential)
            return None if slopes == sp.zeros(*slopes.shape) else self.reader(before).read(slopes)
        if form.name in self.fixed or not entries.free_symbols & set(self.varied):
            return None
        moved = entries.applyfunc(lambda e: self.varied.get(e, sp.Symbol(f"d {e}", real=True)) if e != 0 else e)
        function = form.shown.latex.startswith((r"\exp", r"\mathrm"))
        d = ts.row(ts.words("d"), ts.thin()) if function else ts.words("d")
        return Named(f"d {form.name}", sp.ImmutableMatrix(moved), ts.row(d, form.shown))

    def differential(self, e: sp.Expr) -> sp.Expr:
        """Return the total differential of a scalar: linear in the differentials of what it reads."""
        parts = [sp.diff(e, s) * d for s, d in self.varied.items() if s in e.free_symbols and str(s) not in self.fixed]
        return sp.Add(*parts)

    def collected(self, e: sp.Expr) -> sp.Expr:
        """Return a differential collected by what is varied."""
        return _slopes(sp.expand(e), [*self.varied.values()])

    def _scalar_change(self, change: sp.Expr, before: Sequence[str]) -> Math | None:
        if change == 0:
            return None
        vectors_moved = {n: v for n, v in self.differentials(before).items() if v.shape == (3, 1)}
        dots, rest = self.reader(before).dots(change, vectors_moved)
        terms = [ts.row(_bracketed(form, self.formula(form)), ts.op("·"), self.formula(v)) for form, v in dots]
        if (rest := _slopes(rest, [*self.varied.values()])) != 0:
            terms.append(ts.expression(rest, self._with_differentials))
        whole = terms[0]
        for term in terms[1:]:
            whole = whole + (ts.EMPTY if _starts_negative(term) else ts.op("+")) + term
        return ts.row(whole)

    def _with_differentials(self, s: sp.Expr) -> Math | None:
        if isinstance(s, sp.Symbol) and s.name.startswith("d "):
            of = sp.Symbol(s.name[2:], real=True)
            return ts.row(ts.words("d"), self.symbols(of) or ts.name(s.name[2:]))
        return self.symbols(s)

    def closure(self, equation: sp.Expr) -> dict[str, Any]:
        """Return a closure and its differential."""
        before = list(self.steps.written)
        norms, rest = self.reader(before).norms(equation)
        if len(norms) == 1 and rest != 0:
            c, form = norms[0]
            size = ts.sup(ts.brackets(self.formula(form), "||"), ts.number(2))
            other = sp.factor_terms(-rest / c)
            whole = ts.row(size, ts.op("−"), self.scalar(other))
            left = ts.row(self.scalar(c), ts.brackets(whole)) if c != 1 else whole
        else:
            left = self.scalar(equation)
        change = self._scalar_change(self.differential(equation), before)
        zero, F = ts.number(0), ts.row(ts.words("d"), ts.letter("F"))
        return {
            "equation": ts.equation(left, zero),
            "differential_equation": ts.equation(F, change if change is not None else zero),
            "place": place(self.lines.path, self.lines.keyword("loop_closure")),
        }


def _terms(form: Form) -> list[tuple[sp.Expr, Form]]:
    return list(form.terms) if isinstance(form, Sum) else [(sp.Integer(1), form)]


def _bracketed(form: Form, shown: Math) -> Math:
    return ts.brackets(shown) if isinstance(form, Sum) and len(form.terms) > 1 else shown


def _starts_negative(formula: Math) -> bool:
    return formula.latex.lstrip("{").startswith("-")


def _slopes(e: sp.Expr, differentials: Sequence[sp.Symbol]) -> sp.Expr:
    """Return a linear expression collected by differentials, each coefficient in its shortest form."""
    found = sp.Integer(0)
    for s in differentials:
        if e.has(s):
            slope = tidy(sp.diff(e, s))
            negative = all(term.could_extract_minus_sign() for term in sp.Add.make_args(slope))
            found += -(s * tidy(-slope)) if negative else s * slope
    return found


def _targets(node: ast.AST) -> list[str]:
    targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.For) else []
    return [n.id for target in targets for n in ast.walk(target) if isinstance(n, ast.Name)]


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


def cross(of: Math, power: int = 1) -> Math:
    """Return the matrix of the cross product with a vector, or a power of it."""
    inside = ts.brackets(of, "[]")
    whole = ts.sub(inside, ts.op("×"))
    return whole if power == 1 else ts.sup(whole, ts.number(power))


def rotations_used(short: Iterable[str]) -> list[dict[str, Any]]:
    """Return the definitions and differentials of rotations, with where they are made."""
    t, v, c, k = (ts.letter(x) for x in "tvck")
    of_v, of_c = ts.letter("v", bold=True), ts.letter("c", bold=True)
    eye, one, two, plus, d = ts.letter("I", bold=True), ts.number(1), ts.number(2), ts.op("+"), ts.words("d")
    exp, cay = (ts.row(ts.letter(n), ts.brackets(of)) for n, of in (("exp", of_v), ("cay", of_c)))

    def chain(title: str, whole: Math, entry: Math) -> Math:
        by = ts.sub(entry, k)
        slope = ts.frac(ts.row(ts.op("∂"), ts.letter(title)), ts.row(ts.op("∂"), by))
        return ts.equation(ts.row(d, whole), ts.row(ts.sub(ts.op("∑"), k), slope, d, by))

    sinc = ts.frac(ts.row(ts.letter("sin"), t), t)
    cosc = ts.frac(ts.row(one, ts.op("−"), ts.letter("cos"), t), ts.sup(t, two))
    half = ts.row(cross(of_c), plus, ts.frac(one, two), cross(of_c, 2))
    below = ts.row(one, plus, ts.frac(one, ts.number(4)), ts.sup(ts.brackets(of_c, "||"), two))
    known = {
        "exp": (
            ts.row(
                ts.equation(exp, ts.row(eye, plus, sinc, cross(of_v), plus, cosc, cross(of_v, 2))),
                ts.op(","),
                ts.gap(),
                ts.equation(t, ts.brackets(of_v, "||")),
            ),
            chain("exp", exp, v),
            "rotation_vector",
            "Both factors stand as Taylor polynomials in t², so that value and derivatives are smooth at zero.",
        ),
        "cay": (
            ts.equation(cay, ts.row(eye, plus, ts.frac(half, below))),
            chain("cay", cay, c),
            "cayley",
            "Rational in its argument, and equal to the rotation by that vector to second order.",
        ),
    }
    angle = sp.Symbol("t", real=True)
    for long, name in ROTATIONS.items():
        if long.startswith("turn"):
            M = EXACT[long](angle)
            head = ts.row(rotation_name(name), ts.brackets(t))
            known[name] = (
                ts.equation(head, entries(M)),
                ts.equation(ts.row(d, head), ts.row(entries(sp.diff(M, angle)), d, t)),
                long,
                "",
            )
    return [
        {"formula": formula, "differential": change, "place": _of(EXACT[long]), "note": note}
        for formula, change, long, note in (known[s] for s in short)
    ]


def entries(M: sp.Matrix, symbols: Shown = lambda s: None) -> Math:
    """Return a matrix entry by entry."""
    return ts.matrix([[ts.expression(e, symbols) for e in M.row(i)] for i in range(M.rows)])


# ------------------------------------------------------------------------------------------------------ the accounts


def limb_mechanism(exact: LimbMechanism, written: Written, request: Mapping[str, Any]) -> dict[str, Any]:
    """Return the account of a machine of limbs.

    Parameters
    ----------
    request : mapping
        ``numbers``: key of the robot file to the limbs' values [mm, rad]; ``at``: one nominal pose, see
        `drawing`. Either may be missing: then there is no null space or no drawing.
    """
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
            "place": place(written.lines.path, written.lines.keyword(f"{of}_weights")),
        }
        for of, weights in (("limb", machine.limb_weights), ("platform", machine.platform_weights))
        for weight in weights
    ]
    where = []
    for name in list(written.used):
        value, at = written.abbreviations[name]
        shown = Entries(sp.ImmutableMatrix(value)).math(written.symbols)
        where.append({"name": name, "formula": ts.equation(vector_name(name), shown), "place": at})
    numbers = request.get("numbers")
    return {
        "kind": "limbs",
        **_head(machine, written.module),
        "limbs": machine.limbs,
        "commanded": machine.commanded,
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
        "rotations": rotations_used(written.rotations),
        "steps": steps,
        "closures": closures,
        "implicit": implicit(
            any(q.name.startswith("c") for q in machine.platform),
            place(written.lines.path, written.lines.keyword("loop_closure")),
        ),
        "gradient": {"place": _of(Graph.gradient), "ends": ["newton", "parameters"]},
        "statics": virtual_work(bool(machine.deflections or machine.rods)) if weights else [],
        "weights": weights,
        "seeds": seeds(exact, written),
        "moves": _moves(written),
        "drawing": drawing(exact, written, request["at"]) if request.get("at") else None,
        "unseen": unseen_of(exact, written, numbers) if numbers else None,
    }


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


def _head(spec: LimbMechanism | ChainMechanism, module: ModuleType) -> dict[str, Any]:
    return {
        "name": spec.name,
        "title": spec.title,
        "reference": spec.reference,
        "source": spec.source,
        "docstring": inspect.getdoc(module) or "",
    }


def seeds(exact: LimbMechanism, written: Written) -> list[dict[str, Any]]:
    """Return what Newton's method starts from, where it is short enough to be read."""
    P, c, d = ts.letter("P", bold=True), ts.letter("c", bold=True), ts.letter("d")
    found: list[dict[str, Any]] = []
    given = exact.seeds if exact.seeds is not None else exact.home
    if given is not None:
        for s, e in given.items():
            if sp.count_ops(e) <= 2 * LONGEST:
                found.append({"formula": ts.equation(written.scalar(s), written.scalar(e)), "place": None})
        return found
    centre, _ = closed_form.sphere(exact)
    size = ts.row(ts.frac(ts.number(1), ts.number(2)), ts.sup(ts.brackets(P, "||"), ts.number(2)))
    sphere = ts.row(size, ts.op("−"), c, ts.op("·"), P, ts.op("+"), d)
    found.append({"formula": ts.equation(sphere, ts.number(0)), "place": _of(closed_form.sphere)})
    shown = entries(centre.applyfunc(lambda e: tidy(sp.expand(e))), written.symbols)
    found.append({"formula": ts.equation(c, shown), "place": None})
    return found


# what an instrument cannot tell from errors: a motion of its frame (t, w), a turn of the platform, k + m P or k + m.P
SHIFT, TURN, PLATFORM = ("t_x", "t_y", "t_z"), ("w_x", "w_y", "w_z"), ("k_x", "k_y", "k_z")
FREE = (*PLATFORM, "m", "m_x", "m_y")
ONE_POINT = ("frame of the robot", "unknown frame, one point", "flat bed")
MOTIONS = {
    "frame of the robot": FREE,
    "unknown frame, one point": (*SHIFT, *TURN, *FREE),
    "unknown frame, several points": (*SHIFT, *TURN),  # the platform turns with the frame
    "unknown frame and body": (*SHIFT, *TURN, *PLATFORM),
    "flat bed": ("t_x", "t_y", "w_z", *FREE),
}


def unseen_of(exact: LimbMechanism, written: Written, numbers: unseen.Numbers) -> dict[str, Any] | None:
    """Return what no reading sees, model by model: in an unknown frame and in the robot's own."""
    equations = unseen.equations(exact, numbers)
    if equations is None:
        return None
    errors, motions, found = equations
    own = {q.name: q.symbol for q in (*exact.errors, *exact.common)}
    shown = {e.name_of(i): (e.symbol, i) for i in range(1, exact.limbs + 1) for e in exact.errors}

    def symbol(name: str) -> Math:
        if name in shown:
            base = ts.expression(shown[name][0], written.symbols)
            return _with_limb(base, shown[name][1])
        return ts.expression(own[name], written.symbols)

    try:
        whole = unseen.NullSpace(errors, motions, found)
    except ValueError:
        return None
    out: dict[str, Any] = {}
    for model, names in exact.models.items():
        chosen = [s for s in errors if s.name in names]
        for kind, free in MOTIONS.items():
            moving, tied = [s for s in motions if s.name in free], {}
            if kind == "unknown frame, several points":
                by_name = {s.name: s for s in motions}
                pairs = [(by_name.get(k), by_name.get(w)) for k, w in zip(PLATFORM, TURN, strict=True)]
                tied = {k: w for k, w in pairs if k is not None and w is not None}
                moving = [s for s in moving if s.name in SHIFT or s in tied.values()]
            basis = whole.of(chosen, moving, tied)
            out.setdefault(model, {})[kind] = _vectors(basis, symbol, written.symbols)
    return out


def _vectors(
    basis: Iterable[Mapping[str, sp.Expr]], symbol: Callable[[str], Math], symbols: Shown
) -> list[dict[str, Any]]:
    return [
        {
            "names": list(vector),
            "entries": [ts.equation(symbol(n), ts.expression(tidy(e), symbols)) for n, e in vector.items()],
        }
        for vector in basis
    ]


def null_spaces_of_chain(
    spec: ChainMechanism, request: Mapping[str, Any]
) -> dict[str, dict[str, list[dict[str, sp.Expr]]]] | None:
    """Return a basis of what no reading sees of the chain that a request describes, by model and `MOTIONS`."""
    systems: dict[bool, tuple[list[sp.Symbol], list[sp.Symbol], unseen.NullSpace]] = {}
    for point in (False, True):
        equations = unseen.chain_equations(spec, request["links"], request["tool"], point=point)
        if equations is None:
            return None
        systems[point] = (equations[0], equations[1], unseen.NullSpace(*equations))
    out: dict[str, dict[str, list[dict[str, sp.Expr]]]] = {}
    for model, names in request["models"].items():
        for kind, free in MOTIONS.items():
            errors, motions, whole = systems[kind in ONE_POINT]
            between = [s for s in motions if s.name not in (*SHIFT, *TURN, *PLATFORM)]  # twists from link to link
            moving = [*between, *(s for s in motions if s.name in free)]
            basis = whole.of([s for s in errors if s.name in names], moving, {})
            out.setdefault(model, {})[kind] = basis
    return out


def unseen_of_chain(spec: ChainMechanism, request: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return `null_spaces_of_chain` as formulas; None where there are none in closed form."""
    try:
        found = null_spaces_of_chain(spec, request)
    except ValueError:  # roots of several kinds
        return None
    errors = {e.name: _difference(e.name) for e in spec.errors}
    dimensions = {e.key: ts.expression(e.quantity.symbol) for e in spec.geometry}

    def error(name: str) -> Math:
        own, _, link = name.rpartition("_")
        return _with_limb(errors[own], int(link)) if own in errors else _difference(name)

    def dimension(s: sp.Expr) -> Math | None:
        own, _, link = str(s).rpartition("_")
        return _with_limb(dimensions[own], int(link)) if own in dimensions else ts.sub(ts.letter("t"), ts.letter(link))

    return found and {
        model: {kind: _vectors(basis, error, dimension) for kind, basis in kinds.items()}
        for model, kinds in found.items()
    }


def _with_limb(base: Math, limb: int) -> Math:
    return Math(
        f"<msup>{ts.row(base).mathml}<mrow><mo>(</mo><mn>{limb}</mn><mo>)</mo></mrow></msup>",
        f"{base.latex}^{{({limb})}}",
    )


def _partial(of: Math, by: Math) -> Math:
    return ts.frac(ts.row(ts.op("∂"), of), ts.row(ts.op("∂"), by))


def _by(matrix: str, by: str) -> Math:
    return ts.sub(ts.letter(matrix, bold=True), ts.letter(by))


def implicit(turns: bool, closed_at: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the implicit function theorem on the closures, which every machine of limbs goes through.

    `ends`: the generated functions that evaluate a step.
    """
    F, x, q, p, d = *(ts.letter(n, bold=True) for n in "Fxqp"), ts.words("d")
    J = {n: _by("J", n) for n in "xqp"}
    closed = ts.equation(ts.row(F, ts.brackets(ts.separated((x, q, p)))), ts.letter("0", bold=True))
    jacobians = ts.separated((ts.equation(J[n], _partial(F, v)) for n, v in zip("xqp", (x, q, p), strict=True)), ",")
    total = ts.equation(
        ts.row(J["x"], d, x, ts.op("+"), J["q"], d, q, ts.op("+"), J["p"], d, p), ts.letter("0", bold=True)
    )
    inverse = ts.sup(J["x"], ts.row(ts.op("−"), ts.number(1)))
    S, V = ts.letter("S", bold=True), ts.letter("V", bold=True)
    solved = ts.equation(ts.row(d, x), ts.row(S, d, p, ts.op("+"), V, d, q))
    matrices = ts.row(
        ts.equation(S, ts.row(ts.op("−"), inverse, J["p"])),
        ts.op(","),
        ts.gap(),
        ts.equation(V, ts.row(ts.op("−"), inverse, J["q"])),
    )
    found = [
        {
            "formula": closed,
            "text": "All closures of all limbs together, with as many equations as coordinates in x.",
            "place": closed_at,
            "ends": ["newton"],
        },
        {
            "formula": jacobians,
            "text": "Built on the graph of the steps above: one sweep backwards from each closure.",
            "place": _of(Graph.derivatives),
            "ends": ["newton", "parameters", "jacobians"],
        },
        {"formula": total, "text": "On the machine the closures stay zero.", "place": None, "ends": ["jacobians"]},
        {
            "formula": solved,
            "text": "The implicit function theorem: where the first matrix is regular,",
            "place": None,
            "ends": ["sensitivity"],
        },
        {
            "formula": matrices,
            "text": "with the sensitivity S by the errors and the velocity Jacobian V by the joints.",
            "place": _in_template("templates/mechanism/vectorised.py.jinja", "def sensitivity"),
            "ends": ["sensitivity"],
        },
    ]
    if turns:
        c, phi, one, two = ts.letter("c", bold=True), ts.letter("phi", bold=True), ts.number(1), ts.number(2)
        above = ts.row(ts.letter("I", bold=True), ts.op("+"), ts.frac(one, two), cross(c))
        below = ts.row(one, ts.op("+"), ts.frac(one, ts.number(4)), ts.sup(ts.brackets(c, "||"), two))
        text = "A change of the Cayley vector as a turn about the axes of {O}, which is what the sensitivities give."
        turn = ts.equation(ts.row(d, phi), ts.row(ts.frac(above, below), d, c))
        found.append({"formula": turn, "text": text, "place": _of(blocks.turn_by_change), "ends": ["spin"]})
    return found


def virtual_work(deflections: bool) -> list[dict[str, Any]]:
    """Return what weights exert on the joints, by virtual work on the closures."""
    m, g, r, x, q = ts.letter("m"), *(ts.letter(n, bold=True) for n in "grxq")
    W, J = {n: _by("W", n) for n in "qx"}, {n: _by("J", n) for n in "xqp"}
    mu, tau, top = ts.letter("mu", bold=True), ts.letter("tau", bold=True), ts.op("⊤")
    sums = [ts.equation(W[n], ts.row(ts.op("∑"), m, ts.sup(_partial(r, v), top), g)) for n, v in (("q", q), ("x", x))]
    held = ts.equation(ts.row(ts.sup(J["x"], top), mu), ts.row(ts.op("−"), W["x"]))
    torque = ts.equation(tau, ts.row(W["q"], ts.op("+"), ts.sup(J["q"], top), mu))
    found = [
        {
            "formula": ts.separated(sums, ","),
            "text": "Generalised loads of the weights listed below.",
            "place": _of(statics.loads),
            "ends": ["limb", "platform"],
        },
        {
            "formula": held,
            "text": "Equilibrium of the platform gives the multipliers of the closures.",
            "place": None,
            "ends": ["Limbs.loads"],
        },
        {
            "formula": torque,
            "text": "What the loads exert on each joint, positive along its positive direction.",
            "place": None,
            "ends": ["Limbs.loads"],
        },
    ]
    if deflections:
        load = ts.equation(ts.sub(ts.letter("f"), ts.letter("p")), ts.row(ts.sup(J["p"], top), mu))
        text = "The load conjugate to an error or deflection p: the pull on an arm's tip, the tension of a rod."
        found.append({"formula": load, "text": text, "place": None, "ends": ["Limbs.loads"]})
    return found


def chain_mechanism(spec: ChainMechanism, module: ModuleType, request: Mapping[str, Any]) -> dict[str, Any]:
    """Return the account of an open chain: one link of each convention, its twists by each error and by its joint.

    Parameters
    ----------
    request : mapping
        ``links``, ``tool`` and ``models`` of one chain, see `unseen.chain_equations`, without which there is no null
        space; ``common``: errors that belong to no link.
    """
    symbols: dict[sp.Symbol, Math] = {e.symbol: _difference(e.name) for e in spec.errors}
    look: Shown = symbols.get
    lines = Lines(spec.source)
    d = ts.words("d")
    steps = []
    for s, e in spec.steps:
        moved = [v for v in (*spec.errors, *spec.joint) if e.has(v.symbol)]
        change = ts.separated((ts.row(d, ts.expression(v.symbol, look)) for v in moved), "+")
        steps.append(
            {
                "name": str(s),
                "formula": ts.equation(ts.name(str(s)), ts.expression(e, look)),
                "differential": ts.equation(ts.row(d, ts.name(str(s))), change),
                "place": place(spec.source, lines.keyword("steps")),
                "entries": [str(s)],
            }
        )
    links = []
    for convention, screws in spec.transforms.items():
        R, shift, twists = vectors.follow(screws)
        factors = []
        for screw in screws:
            axis = ts.letter(screw.axis)
            for title, amount in (("R", screw.turn), ("T", screw.shift)):
                if amount != 0:
                    head = ts.sub(ts.letter(title, bold=True), axis)
                    factors.append(ts.row(head, ts.brackets(ts.expression(amount, look))))
        links.append(
            {
                "convention": convention,
                "product": ts.row(*factors),
                "rotation": entries(R),
                "shift": entries(shift),
                "twists": [
                    {"by": ts.name(str(by)), "shift": entries(twist[:3, :]), "turn": entries(twist[3:, :])}
                    for by, twist in twists.items()
                ],
                "place": place(spec.source, lines.keyword("transforms")),
                "ends": [convention],
            }
        )
    return {
        "kind": "chain",
        "gradient": {"place": _of(vectors.follow), "ends": list(spec.transforms)},
        **_head(spec, module),
        "tables": {
            "joint": table(spec.joint, look),
            "geometry": [
                {**row, "key": g.key}
                for g, row in zip(spec.geometry, table([g.quantity for g in spec.geometry], look), strict=True)
            ],
            "errors": table(spec.errors, look),
            "common": [{**row, "symbol": _difference(row["name"])} for row in request.get("common", ())],
        },
        "where": [],
        "rotations": [],
        "steps": steps,
        "moves": [],
        "links": links,
        "statics": weights_of_links(),
        "weights": [],
        "unseen": unseen_of_chain(spec, request) if "links" in request else None,
    }


def weights_of_links() -> list[dict[str, Any]]:
    """Return what weights exert on the joints of a chain, by virtual work: from the last link to the first."""
    F, M, P, R, g, p, r, c, s, w = (ts.letter(n, bold=True) for n in "FMPRgprcsw")
    i, j, n, m, tau, q = *(ts.letter(x) for x in "ijnm"), ts.letter("tau"), ts.letter("q")
    plus, minus, dot, cross_ = (ts.op(sign) for sign in "+−·×")
    payload, one = ts.sub(m, ts.words("payload")), ts.number(1)
    behind, last = ts.row(j, plus, one), ts.row(n, plus, one)
    F_j, M_j, m_j, p_j, r_j, s_j, w_j = (ts.sub(e, j) for e in (F, M, m, p, r, s, w))
    q_i, tau_i, sum_j = ts.sub(q, i), ts.sub(tau, i), ts.sub(ts.op("∑"), j)
    lever = ts.brackets(ts.row(M_j, minus, p_j, cross_, F_j))
    work = ts.brackets(ts.row(s_j, dot, F_j, plus, w_j, dot, lever))
    formulas: tuple[tuple[Math, str, list[str]], ...] = (
        (
            ts.equation(tau_i, ts.row(sum_j, m_j, g, dot, _partial(r_j, q_i), plus, payload, g, dot, _partial(P, q_i))),
            "Virtual work of each link's weight at its centre of mass and of the payload at the tool point.",
            [],
        ),
        (
            ts.equation(r_j, ts.row(p_j, plus, ts.sub(R, j), ts.sub(c, j))),
            "The centre of mass of link j: origin and rotation of its frame in {O}, and where in it the robot file "
            "says the mass lies.",
            ["Chain.weights_at"],
        ),
        (
            ts.separated(
                (
                    ts.equation(ts.sub(F, last), ts.row(payload, g)),
                    ts.equation(ts.sub(M, last), ts.row(P, cross_, payload, g)),
                    ts.equation(F_j, ts.row(ts.sub(F, behind), plus, m_j, g)),
                    ts.equation(M_j, ts.row(ts.sub(M, behind), plus, r_j, cross_, m_j, g)),
                ),
                ",",
            ),
            "Force and moment about {O} of all that a link carries: the payload, then link by link towards the base.",
            [],
        ),
        (
            ts.equation(tau_i, ts.row(sum_j, _partial(ts.sub(q, j), q_i), work)),
            "A joint moves all behind it as a rigid body, by the twist of its link given above: shift s of the link's "
            "end p, and turn w. The sum holds the joint's own link, and links coupled to it by their ratio.",
            ["Chain.loads"],
        ),
    )
    return [{"formula": formula, "text": text, "place": None, "ends": ends} for formula, text, ends in formulas]


def effect(spec: Effect, module: ModuleType) -> dict[str, Any]:
    """Return the account of an effect: what it reads, moves, and its columns."""
    read = spec.states
    lines = Lines(spec.source)
    d = ts.op("∂")

    # a coefficient called cos or xy is neither a function nor a product
    odd = [c for c in spec.coefficients if c.name in ("cos", "sin") or set(c.name) <= {"x", "y"}]
    shown: dict[sp.Expr, Math] = {c.symbol: ts.sub(ts.letter("c"), ts.words(c.name)) for c in odd}
    look: Shown = shown.get

    def row(q: EffectQuantity | State) -> dict[str, Any]:
        return {"symbol": ts.expression(q.symbol, look), "name": q.name, "unit": q.unit, "meaning": q.meaning}

    targets = []
    for target, e in spec.targets.items():
        moved = ts.row(ts.letter("Δ"), ts.words(target))
        columns = [
            ts.equation(
                ts.frac(ts.row(d, moved), ts.row(d, ts.expression(c.symbol, look))),
                ts.expression(sp.diff(e, c.symbol), look),
            )
            for c in spec.coefficients
        ]
        targets.append(
            {
                "target": target,
                "meaning": target_meaning(target),
                "formula": ts.equation(moved, ts.expression(e, look)),
                "columns": columns,
                "place": place(spec.source, lines.keyword("targets")),
            }
        )
    return {
        "kind": "effect",
        "name": spec.name,
        "title": spec.title,
        "source": spec.source,
        "docstring": inspect.getdoc(module) or "",
        "per_limb": spec.per_limb,
        "advice": spec.advice,
        "coefficients": [row(q) for q in spec.coefficients],
        "constants": [row(q) for q in spec.constants],
        "states": [row(q) for q in read],
        "targets": targets,
        "chain": reaches(set(spec.targets), any(s.kind == "load" for s in read)),
    }


def reaches(targets: set[str], loaded: bool) -> list[dict[str, Any]]:
    """Return how targets of an effect reach a reading: the chain rule through a machine's own derivatives."""
    x, y, d, c = ts.letter("x", bold=True), ts.letter("y", bold=True), ts.op("∂"), ts.letter("c")

    def moved(title: str) -> Math:
        return ts.frac(ts.row(d, ts.letter("Δ"), ts.words(title)), ts.row(d, c))

    slope, terms = ts.frac(ts.row(d, x), ts.row(d, c)), []
    if "joint" in targets:
        terms.append(ts.row(ts.letter("V", bold=True), moved("joint")))
    if any(t.startswith("limb.") for t in targets):
        terms.append(
            ts.row(ts.letter("S", bold=True), _partial(ts.letter("p", bold=True), ts.words("part")), moved("limb.part"))
        )
    if any(t.startswith("turn.") for t in targets):
        terms.append(ts.row(moved("turn"), ts.op("×"), ts.letter("P", bold=True)))
    if any(t.startswith("tool.") for t in targets):
        terms.append(ts.row(ts.letter("R", bold=True), moved("tool")))
    found = []
    if terms:
        text = "The pose moves by the machine's velocity Jacobian V and sensitivity S at the deformed pose."
        if loaded:
            text += " Loads are those of the deformed machine, found by iteration to static equilibrium."
        moving = ts.equation(slope, ts.separated(terms, "+"))
        found.append({"formula": moving, "text": text, "place": None, "ends": ["Body.columns"]})
        reading = ts.equation(ts.frac(ts.row(d, y), ts.row(d, c)), ts.row(_partial(y, x), slope))
        text = "The reading moves with the pose, as the instrument sees it."
        found.append({"formula": reading, "text": text, "place": None, "ends": ["Instrument.linearise"]})
    if any(t.startswith("reading.") or t in ("length", "height") for t in targets):
        reading = ts.equation(ts.frac(ts.row(d, y), ts.row(d, c)), moved("reading"))
        text = "It acts on the reading itself; no pose and no command changes."
        found.append({"formula": reading, "text": text, "place": None, "ends": ["reading_shift"]})
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
    }.get(kind, target)


def measurement(spec: Measurement, module: ModuleType) -> dict[str, Any]:
    """Return the account of a kind of measurement: its reading in terms of the platform and the instrument."""
    lines = Lines(spec.source)
    known_vectors = {f"P{suffix}": p.position for p, suffix in _suffixed(spec)}
    known_matrices = {f"R{suffix}": p.rotation for p, suffix in _suffixed(spec)}
    known_turns = {f"s{suffix}": p.turn for p, suffix in _suffixed(spec)}
    others = [m for m in vars(module).values() if isinstance(m, ModuleType) and m.__name__.startswith("derive.measure")]
    for name, value in [e for m in (module, *others) for e in vars(m).items()]:
        if isinstance(value, sp.MatrixBase) and all(e.is_Symbol for e in value):
            (known_vectors if value.shape == (3, 1) else known_matrices)[name] = value
    reader = Reader(known_vectors | known_turns, known_matrices, vector_name)
    y = ts.letter("y")
    steps = [ts.equation(ts.name(str(s)), ts.expression(tidy(e))) for s, e in spec.steps if sp.count_ops(e) < LONGEST]
    readings: list[Math] = []
    if len(spec.reading) == 3:
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
        "steps": steps,
        "readings": readings,
        "given": _by_meaning(spec.given),
        "unknown": _by_meaning(spec.unknown),
        "place": place(spec.source, lines.keyword("reading")),
    }


def _by_meaning(quantities: Iterable[Quantity]) -> list[dict[str, Any]]:
    """Return quantities that mean the same, the entries of a vector or matrix, under one symbol."""
    found: dict[str, list[Quantity]] = {}
    for q in quantities:
        found.setdefault(q.meaning.partition(", entry")[0], []).append(q)
    return [
        {
            "symbol": ts.name(re.sub(r"[xyz]$|_?11$", "", alike[0].name), bold=True)
            if len(alike) > 1
            else ts.name(alike[0].name),
            "unit": "" if alike[0].unit == "1" else alike[0].unit,
            "meaning": meaning,
        }
        for meaning, alike in found.items()
    ]


def _suffixed(spec: Measurement) -> list[tuple[Any, str]]:
    return [(p, str(p.position[0])[2:]) for p in spec.platforms]


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


def answer(request: Mapping[str, Any]) -> dict[str, Any]:
    """Return the account that a request asks for.

    Of a ``mechanism``, an ``effect`` or a ``measurement``; ``texts`` are read, and ``reaches`` are targets of effects.
    """
    if "texts" in request:
        return {"texts": [notation.read(text) for text in request["texts"]]}
    if "reaches" in request:
        return {"chain": reaches(set(request["reaches"]), loaded=True)}
    kind, name = next((k, request[k]) for k in ("mechanism", "effect", "measurement") if k in request)
    if kind == "effect":
        module = importlib.import_module(f"derive.effects.{name}")
        return effect(module.EFFECT, module)
    exact = importlib.import_module(f"derive.{kind}s.{name}")
    if isinstance(getattr(exact, kind.upper()), ChainMechanism):
        return chain_mechanism(exact.MECHANISM, exact, request)
    with opaque():
        module = importlib.import_module(f"derive.{kind}s.{name}")
        if kind == "measurement":
            return measurement(module.MEASUREMENT, module)
        return limb_mechanism(exact.MECHANISM, Written(module.MECHANISM, module), request)


def main() -> None:
    """Answer the requests on the standard input, each by a line of JSON."""
    for request in json.load(sys.stdin):
        print(json.dumps({**plain(answer(request)), "sympy": sp.__version__}), flush=True)


if __name__ == "__main__":
    main()
