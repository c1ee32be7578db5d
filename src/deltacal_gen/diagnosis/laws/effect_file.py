"""The way back: a law that was found, as the file of an effect that ``deltacal kernels`` takes as it is.

What the recording cannot know (a name, what someone should do about it, what is believable) stands there to be filled
in, with what was found as a first guess.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from deltacal_gen.errors import NotForThisMachine, ValueOutOfRange
from deltacal_gen.physics.formula import FUNCTIONS, LAG, Unit, unit, written
from deltacal_gen.physics.law import PREFIX, Law, inside, load_law
from deltacal_gen.results.diagnosis import LawOf, LawTerm
from deltacal_gen.states import named
from deltacal_gen.units import DEG

BELIEVABLE = 10.0  # times what was found: how large a coefficient may be, until someone knows better
AT = 0.7  # of the way through the range of each state: where the reference value is
_NAME = re.compile(r"[A-Za-z_]\w*")


@dataclass(frozen=True)
class _Part:
    """A term of a formula as the file writes it, its numbers with their units by the names they have there."""

    term: LawTerm
    law: Law
    formula: str
    coefficients: dict[str, tuple[float, Unit]]
    constants: dict[str, tuple[float, Unit]]


def effect_file(told: LawOf, path: Path) -> str:
    """Return the text of an effect's file, named after the file.

    Raises
    ------
    UsageError
        The name of the file is none of an effect, or the terms of the law act on different things.
    """
    name, parts = effect_name(path), _parts(told.terms)
    found = "; ".join(f"{t.target} by {t.expression}" for t in told.terms)
    acts_on = {p.law.ACTS_ON for p in parts}
    if len(acts_on) > 1:
        raise NotForThisMachine(f"the law moves {' and '.join(sorted(acts_on))}: write an effect for each by hand.")
    states = list(dict.fromkeys(s for p in parts for s in p.law.STATE))
    recorded = [s for s in states if named(s).unit == "as recorded"]
    own = [s for s in states if s not in recorded]
    taken = ["coefficient", *["covariate"] * bool(recorded), *["state"] * bool(own)]
    targets: dict[str, list[str]] = {}
    for p in parts:
        targets.setdefault(p.law.TARGETS[0], []).append(p.formula)
    lines = [
        f'"""TO BE SAID: what this is. Found by ``deltacal diagnose``: {found}."""\n',
        *(["import sympy as sp\n"] if any("sp." in p.formula for p in parts) else []),
        f"from derive.effects import {', '.join(taken)}",
        "from derive.language.effects import Effect, Reference",
        *(["from derive.language.memory import Lag"] if any(p.law.lags for p in parts) else []),
        "",
        *([f'{", ".join(own)}{"," * (len(own) == 1)} = state("{" ".join(own)}")'] if own else []),
        *(f'{s} = covariate("{s}")' for s in recorded),
        *(f"{n} = {v!r}  # {written(u) or 1}, as it was found" for p in parts for n, (v, u) in p.constants.items()),
        *(_coefficient(n, *c) for p in parts for n, c in p.coefficients.items()),
        "EFFECT = Effect(",
        f'    name="{name}",',
        f'    title="{name.replace("_", " ")}",',
        '    advice="TO BE FILLED IN: what someone who maintains the machine does about it.",',
        f'    source="derive/effects/{name}.py",',
        f"    per_limb={parts[0].law.PER_LIMB},",
        f"    coefficients=({', '.join(n for p in parts for n in p.coefficients)},),",
        "    targets={",
        *(f'        "{t}": {" + ".join(formulas)},' for t, formulas in targets.items()),
        "    },",
        f"    tests=({_reference(told, parts, states)},),",
        ")",
    ]
    return "\n".join(lines) + "\n"


def effect_name(path: Path) -> str:
    """Return the name of the effect that a file would hold.

    Raises
    ------
    UsageError
        It is none.
    """
    if not path.stem.isidentifier() or path.stem != path.stem.lower() or path.suffix != ".py":
        raise ValueOutOfRange(f"'{path.name}' names no effect: give a file like oil_creep.py.")
    return path.stem


def _parts(terms: Sequence[LawTerm]) -> list[_Part]:
    """Return the terms with names that all of them together have once."""
    out, count = [], itertools.count(1)
    for term in terms:
        law = load_law(f"{PREFIX}{term.target} = {term.expression}")
        units, names = law.units("rad"), dict[str, str]()
        of: dict[bool, dict[str, tuple[float, Unit]]] = {True: {}, False: {}}
        for c in (c for c in term.coefficients if c.limb in (None, min(term.limbs, default=None))):  # of one limb
            linear = c.name in law.formula.linear
            names[c.name] = f"{'c' if linear else 'K'}{next(count)}"
            of[linear][names[c.name]] = c.value, units[c.name]
        out.append(_Part(term, law, _in_python(term.expression, names), of[True], of[False]))
    return out


def _in_python(expression: str, names: Mapping[str, str]) -> str:
    return _NAME.sub(lambda m: _written(m[0], names), expression)


def _written(word: str, names: Mapping[str, str]) -> str:
    """Return a word of a formula as Python writes it with SymPy."""
    if word in names:
        return f"{names[word]}.symbol" if names[word].startswith("c") else names[word]
    return f"sp.{word}" if word in FUNCTIONS or word == "Piecewise" else word if word != LAG else "Lag"


def _coefficient(name: str, value: float, of: Unit) -> str:
    text, factor = _of_files(of)
    most = float(f"{BELIEVABLE * abs(value) / factor:.1g}")
    return f'{name} = coefficient("{name}", "{text}", {factor!r}, "TO BE SAID", (-{most:g}, {most:g}))'


def _of_files(of: Unit) -> tuple[str, float]:
    """Return a unit as files have it, deg and Nm for rad and N mm, and the factor to the unit inside."""
    shown, turns = dict(of), of.get("rad", Fraction(0))
    torque = of.get("N", Fraction(0)) if of.get("N") == of.get("mm") else Fraction(0)
    factor = DEG ** float(turns) * 1000.0 ** float(torque)
    if turns:
        shown = {"deg" if n == "rad" else n: p for n, p in shown.items()}
    if torque:
        shown = {n: p for n, p in shown.items() if n not in ("N", "mm")} | {"Nm": torque}
    return written(shown), factor


def _reference(told: LawOf, parts: Sequence[_Part], states: Sequence[str]) -> str:
    """Return a reference value: what the formula makes of states within their range."""
    at = {s: told.range[s][0] + AT * (told.range[s][1] - told.range[s][0]) for s in states}
    lags = dict.fromkeys(lag for p in parts for lag in p.law.lags)
    moved: dict[str, float] = {}
    for p in parts:
        known = at | {c.name: c.value for c in reversed(p.term.coefficients)}
        known |= {f"Lag({s}, {tau})": at[s] for s, tau in p.law.lags}
        moved[p.law.TARGETS[0]] = moved.get(p.law.TARGETS[0], 0.0) + float(p.law.formula({**known}))
    turned = {s: float(unit(inside(named(s), "rad")).get("rad", 0)) for s in states}
    given = {s: at[s] / DEG ** turned[s] for s in states} | {f"lag_{n}": at[s] for n, (s, _) in enumerate(lags, 1)}
    size = {n: v / _of_files(u)[1] for p in parts for n, (v, u) in p.coefficients.items()}
    tables = ("{" + ", ".join(f'"{n}": {v!r}' for n, v in table.items()) + "}" for table in (given, size, moved))
    return f"Reference({', '.join(tables)})"
