"""A law on a page: as mathematics, in numbers, and along its state with what every reading says."""

from __future__ import annotations

import ast
import html
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from deltacal_gen.pages.figures import AFTER, BEFORE, MUTED
from deltacal_gen.results.diagnosis import LawCurve, LawOf, LawTerm, RunnerUp
from deltacal_gen.results.document import rounded
from deltacal_gen.results.places import Places

ADVICE = (
    "Nobody has registered this: it was read from the recording. Look for a part that behaves so; until then command "
    "by the states that it names."
)
WITHIN = 1.96  # standard deviations of the band: 95 %
_SIGNS = {ast.Lt: "&lt;", ast.LtE: "≤", ast.Gt: "&gt;", ast.GtE: "≥"}
_BINDS = {ast.Add: 1, ast.Sub: 1, ast.Mult: 2, ast.Div: 3, ast.Pow: 4}


def where(term: LawTerm, places: Places) -> str:
    """Return at which limbs a term sits, in words."""
    return places.at(term.limbs, _part(term, places))


def _part(term: LawTerm | RunnerUp, places: Places) -> str:
    """Return what the limbs of a term are called: drives are of joints."""
    return "joint" if term.target == "torque" else places.part


def headline(law: LawOf, places: Places) -> str:
    """Return a law in a few words."""
    return "A formula that nobody has registered: " + " and ".join(
        f"{t.target} goes with {' and '.join(_states(t))}{where(t, places)}" for t in law.terms
    )


def title(law: LawOf) -> str:
    """Return what a law is called among effects."""
    return f"a law of {' and '.join(dict.fromkeys(s for t in law.terms for s in _states(t)))}"


def _states(term: LawTerm) -> tuple[str, ...]:
    tree, own = ast.parse(term.expression, mode="eval"), {c.name for c in term.coefficients}
    called = {node.func for node in ast.walk(tree) if isinstance(node, ast.Call)}
    names = (node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and node not in called)
    return tuple(dict.fromkeys(name for name in names if name not in own))


def rows(law: LawOf, places: Places) -> list[tuple[str, ...]]:
    """Return the numbers of a law, as a table has them."""
    return [
        (
            t.target,
            "" if c.limb is None else places.number(c.limb),
            c.name,
            _number(c.value, c.std),
            "" if c.unit == "1" else c.unit,
        )
        for t in law.terms
        for c in t.coefficients
    ]


def _number(value: float, std: float | None) -> str:
    return f"{value:.4g}" if std is None else " ± ".join(rounded(value, std))


def mathematics(law: LawOf) -> list[str]:
    """Return every term as MathML."""
    return [
        f'<math display="block"><mi>{html.escape(t.target)}</mi><mo>+=</mo>{mathml(t.expression)}</math>'
        for t in law.terms
    ]


def mathml(expression: str) -> str:
    """Return a formula of the language of laws as presentation MathML."""
    return f"<mrow>{_of(ast.parse(expression, mode='eval').body)}</mrow>"


def _of(node: ast.expr, outer: int = 0) -> str:
    if isinstance(node, ast.Name):
        name, _, index = node.id.partition("_") if not node.id[-1:].isdecimal() or "_" in node.id else _split(node.id)
        base = f"<mi>{html.escape(name)}</mi>"
        return f"<msub>{base}<mi>{html.escape(index)}</mi></msub>" if index else base
    if isinstance(node, ast.Constant):
        return f"<mn>{node.value!r}</mn>"
    if isinstance(node, ast.UnaryOp):
        sign = "−" if isinstance(node.op, ast.USub) else ""
        return _bracketed(f"<mo>{sign}</mo>{_of(node.operand, 2)}", outer > 1)
    if isinstance(node, ast.BinOp):
        return _operation(node, outer)
    if isinstance(node, ast.Compare):
        return f"{_of(node.left)}<mo>{_SIGNS[type(node.ops[0])]}</mo>{_of(node.comparators[0])}"
    assert isinstance(node, ast.Call)  # all else was refused by the language
    return _call(node)


def _split(name: str) -> tuple[str, str, str]:
    """Return letters and digits of a name as ``c1``."""
    letters = name.rstrip("0123456789")
    return letters, "", name[len(letters) :]


def _operation(node: ast.BinOp, outer: int) -> str:
    binds = _BINDS[type(node.op)]
    if isinstance(node.op, ast.Div):
        return f"<mfrac><mrow>{_of(node.left)}</mrow><mrow>{_of(node.right)}</mrow></mfrac>"
    if isinstance(node.op, ast.Pow):
        base = _bracketed(
            _of(node.left, binds + 1), isinstance(node.left, ast.BinOp) and isinstance(node.left.op, ast.Div)
        )
        return f"<msup><mrow>{base}</mrow><mrow>{_of(node.right)}</mrow></msup>"
    sign = {ast.Add: "+", ast.Sub: "−", ast.Mult: "·"}[type(node.op)]
    right = _of(node.right, binds + isinstance(node.op, ast.Sub))
    return _bracketed(f"{_of(node.left, binds)}<mo>{sign}</mo>{right}", outer > binds)


def _call(node: ast.Call) -> str:
    name = node.func.id if isinstance(node.func, ast.Name) else ""
    if name == "Abs":
        return f"<mrow><mo>|</mo>{_of(node.args[0])}<mo>|</mo></mrow>"
    if name == "sqrt":
        return f"<msqrt>{_of(node.args[0])}</msqrt>"
    if name == "Piecewise":
        cases = [c.elts for c in node.args if isinstance(c, ast.Tuple)]
        lines = [
            f"<mtr><mtd>{_of(v)}</mtd><mtd><mtext>{'else' if k == len(cases) - 1 else 'where '}</mtext>"
            f"{'' if k == len(cases) - 1 else _of(c)}</mtd></mtr>"
            for k, (v, c) in enumerate(cases)
        ]
        return f"<mrow><mo>{{</mo><mtable>{''.join(lines)}</mtable></mrow>"
    inside = "<mo>,</mo>".join(_of(a) for a in node.args)
    return f"<mi>{html.escape(name)}</mi>{_bracketed(inside, True)}"


def _bracketed(inside: str, needed: bool) -> str:
    return f"<mrow><mo>(</mo>{inside}<mo>)</mo></mrow>" if needed else f"<mrow>{inside}</mrow>"


def drawn(law: LawOf, draw: Callable[[Callable[[Axes], None]], str]) -> list[dict[str, str]]:
    """Return the picture of every term that has one, with its title where there are several terms."""
    curves = law.curves or ((law.curve,) if law.curve is not None else ())
    several = len(law.terms) > 1
    return [
        {"title": _short(law.terms[c.term]) if several else "", "svg": draw(partial(along, law=law, curve=c))}
        for c in curves
    ]


def _short(term: LawTerm) -> str:
    return f"{term.target}: {term.expression}"


def along(axes: Axes, law: LawOf, curve: LawCurve) -> None:
    """Draw a term of a law along its first state: what the readings say, the curve, and its band of 95 %."""
    at, value = np.asarray(curve.at), np.asarray(curve.value)
    band = WITHIN * np.asarray(curve.std)
    axes.plot(curve.seen, curve.partial, "o", ms=3.0, mew=0, alpha=0.6, color=BEFORE)
    axes.fill_between(at, value - band, value + band, color=AFTER, alpha=0.25, lw=0)
    axes.plot(at, value, color=AFTER, lw=1.6)
    axes.axhline(0, color=MUTED, lw=0.8)
    wide = float(np.ptp(value)) + 1e-300
    low, high = np.percentile(np.asarray(curve.partial), (1, 99))
    axes.set_ylim(min(low, value.min()) - 0.1 * wide, max(high, value.max()) + 0.1 * wide)
    axes.set_xlabel(f"{curve.state}{'' if curve.unit == '1' else f', {curve.unit}'}")
    axes.set_ylabel(f"{law.terms[curve.term].target}, {curve.target_unit}")


def described(
    law: LawOf, others: tuple[LawOf, ...], heldout: str, places: Places, remainder: float | None = None
) -> dict[str, Any]:
    """Return what a page says of a law beside its picture; `heldout` is what is left of readings, with the unit."""
    seen = ", ".join(f"{s} {low:.4g} to {high:.4g}" for s, (low, high) in law.range.items())
    return {
        "mathematics": mathematics(law),
        "rows": rows(law, places),
        "places": [f"{t.target}{where(t, places)}" for t in law.terms],
        "range": seen,
        "part": _part(law.terms[0], places),
        "heldout": heldout,
        "share": f"{law.share_of_excess:.0%}",
        "gain": f"{law.gain:.0f}",
        "charge": f"{law.charge:.0f}",
        "remainder": None if remainder is None else f"{remainder:.4f}",
        "alike": list(law.alike),
        "tried": law.forms_tried,
        "runners_up": [
            (
                f"{r.target} by {r.expression}{places.at(r.limbs, _part(r, places))}",
                f"{r.gain:.0f}",
                f"{r.charge:.0f}",
                f"{r.gain - r.charge:.0f}",
            )
            for r in law.runners_up
        ],
        "others": [" and ".join(f"{t.target} by {t.expression}{where(t, places)}" for t in o.terms) for o in others],
    }
