"""What no reading sees, as formulas: null spaces in closed form, model by model and motion by motion."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import mechanism_of
from derive.review import typeset as ts
from derive.review import unseen
from derive.review.machine import Written, difference
from derive.review.typeset import Math, Shown
from derive.review.written import tidy
from derive.spec import ChainMechanism, LimbMechanism

# what an instrument cannot tell from errors: a motion of its frame (t, w), a turn of the platform, k + m P or k + m.P
SHIFT, TURN, PLATFORM = ("t_x", "t_y", "t_z"), ("w_x", "w_y", "w_z"), ("k_x", "k_y", "k_z")
FREE = (*PLATFORM, "m", "m_x", "m_y")
ONE_POINT = ("frame of the robot", "unknown frame, one point", "flat bed")
MOTIONS = {
    "frame of the robot": FREE,
    "frame and body known": (),
    "unknown frame, one point": (*SHIFT, *TURN, *FREE),
    "unknown frame, several points": (*SHIFT, *TURN),  # the platform turns with the frame
    "unknown frame and body": (*SHIFT, *TURN, *PLATFORM),
    "flat bed": ("t_x", "t_y", "w_z", *FREE),
}


def unseen_of(exact: LimbMechanism, written: Written, robot: Robot) -> dict[str, Any] | None:
    """Return what no reading sees, model by model: in an unknown frame and in the robot's own."""
    equations = unseen.equations(exact, {key: np.asarray(values).tolist() for key, values in robot.geometry.items()})
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
            "divides": sorted({str(d) for e in vector.values() for d in _divisors(e)}),
            "entries": [ts.equation(symbol(n), ts.expression(tidy(e), symbols)) for n, e in vector.items()],
        }
        for vector in basis
    ]


def _divisors(e: sp.Expr) -> list[sp.Expr]:
    """Return what an entry divides by: where one of these vanishes, the closed basis is none."""
    factors = sp.factor_list(sp.denom(sp.together(e)))[1]
    return [factor for factor, _ in factors if factor.free_symbols]


def links_of(robot: Robot) -> list[dict[str, Any]]:
    """Return kind, convention, a, d [mm], alpha and theta [rad] of each link of a chain, from the base."""
    lengths = {key: np.asarray(values).tolist() for key, values in robot.geometry.items()}
    return [
        {"kind": link.kind, "convention": link.convention, **{key: values[k] for key, values in lengths.items()}}
        for k, link in enumerate(robot.links)
    ]


def null_spaces_of_chain(
    spec: ChainMechanism,
    links: Sequence[Mapping[str, Any]],
    tool: Sequence[float],
    models: Mapping[str, Sequence[str]],
) -> dict[str, dict[str, list[dict[str, sp.Expr]]]] | None:
    """Return a basis of what no reading sees of a chain, by model and `MOTIONS`; see `links_of`."""
    systems: dict[bool, tuple[list[sp.Symbol], list[sp.Symbol], unseen.NullSpace]] = {}
    for point in (False, True):
        equations = unseen.chain_equations(spec, links, tool, point=point)
        if equations is None:
            return None
        systems[point] = (equations[0], equations[1], unseen.NullSpace(*equations))
    out: dict[str, dict[str, list[dict[str, sp.Expr]]]] = {}
    for model, names in models.items():
        for kind, free in MOTIONS.items():
            errors, motions, whole = systems[kind in ONE_POINT]
            between = [s for s in motions if s.name not in (*SHIFT, *TURN, *PLATFORM)]  # twists from link to link
            moving = [*between, *(s for s in motions if s.name in free)]
            basis = whole.of([s for s in errors if s.name in names], moving, {})
            out.setdefault(model, {})[kind] = basis
    return out


def unseen_of_chain(spec: ChainMechanism, robot: Robot) -> dict[str, Any] | None:
    """Return `null_spaces_of_chain` as formulas; None where there are none in closed form."""
    try:
        found = null_spaces_of_chain(spec, links_of(robot), list(robot.tool), mechanism_of(robot).models)
    except ValueError:  # roots of several kinds
        return None
    errors = {e.name: difference(e.name) for e in spec.errors}
    dimensions = {e.key: ts.expression(e.quantity.symbol) for e in spec.geometry}

    def error(name: str) -> Math:
        own, _, link = name.rpartition("_")
        return _with_limb(errors[own], int(link)) if own in errors else difference(name)

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
