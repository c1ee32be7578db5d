"""A machine of limbs as it is written down: its steps and closures as formulas, and their differentials."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from derive import registry
from derive.review import typeset as ts
from derive.review.sources import Lines, Place
from derive.review.typeset import Math, Shown
from derive.review.written import OPAQUE, Entries, Form, Named, Product, Reader, Sum, negative, split, tidy
from derive.spec import LimbMechanism
from derive.steps import Derivation


def typesetting(mechanism: LimbMechanism) -> Shown:
    """Return how a machine's symbols are shown: an error is the delta of what it is an error of."""
    shown: dict[sp.Symbol, Math] = {}
    taken: dict[str, int] = {}
    own = {e.symbol for e in mechanism.errors}
    for e in (*mechanism.common, *mechanism.errors):
        bare = e.name.replace("_{i}", "").replace("{i}", "")
        formula = difference(bare)
        taken[formula.latex] = taken.get(formula.latex, 0) + 1
        if taken[formula.latex] > 1 and e.symbol in own:
            formula = ts.row(ts.letter("delta"), ts.sub(ts.name(bare), ts.letter("i")))
        shown[e.symbol] = formula
    return lambda s: shown.get(s)


def difference(name: str) -> Math:
    """Return the formula of a source error: a Greek delta before its name, unless that begins with one."""
    formula = ts.name(name)
    return formula if formula.latex.startswith(r"\Delta") else ts.row(ts.letter("delta"), formula)


class Written:
    """A mechanism of limbs as it is written, its rotations left as names.

    Parameters
    ----------
    name : str
        As it is registered.
    """

    def __init__(self, name: str) -> None:
        mechanism = registry.mechanism(name, OPAQUE)
        assert isinstance(mechanism, LimbMechanism)
        self.mechanism = mechanism
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
        self.rotations: dict[str, None] = {}
        self.fixed: set[str] = set()  # steps that nothing varied changes

    @cached_property
    def abbreviations(self) -> dict[str, sp.Matrix]:
        """Vectors and matrices that the file names beside its steps; longer ones first."""
        return dict(sorted(self.steps.shown.items(), key=lambda e: -sum(int(sp.count_ops(x)) for x in e[1])))

    def reader(self, before: Iterable[str]) -> Reader:
        """Return what takes expressions apart into the steps `before` them, and differentials."""
        known = {n: self.steps.written[n] for n in before}
        known = {n: v for n, v in known.items() if isinstance(v, sp.MatrixBase)}
        everything = {**known, **self.base, **self.abbreviations}
        return Reader(
            {n: v for n, v in everything.items() if v.shape == (3, 1)},
            {n: v for n, v in everything.items() if v.shape == (3, 3)},
            ts.vector,
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
            left = ts.vector(name)
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
            "place": Place(self.lines.path, self.steps.lines[name]),
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
            "place": self.lines.keyword("loop_closure"),
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
            found += -(s * tidy(-slope)) if negative(slope) else s * slope
    return found
