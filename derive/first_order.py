"""The machine to first order in its errors, about its nominal geometry: what a linear compensator needs.

Every step of the derivation is taken at its nominal value (errors, deflections and the platform's rotation at zero),
and beside it stand its rates along a few directions: the joint, each rotation of the platform, and the errors
themselves, all at once. Rates pass from step to step by the chain rule, up to the closure.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import sympy as sp

from derive.backends.ir import Place
from derive.closed_form import inverse_joint, uncommanded
from derive.graph import Graph, Steps, expand_steps
from derive.mathematics.functions import Functions, entries
from derive.spec import LimbMechanism


def _rate(expr: sp.Expr, rates: Mapping[sp.Symbol, sp.Expr], nominal: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    moving = sorted(expr.free_symbols & set(rates), key=str)
    return sp.Add(*(sp.diff(expr, s).xreplace(nominal) * rates[s] for s in moving))


Directions = Mapping[str, Mapping[sp.Symbol, sp.Expr]]


@cache
def to_all_errors(mechanism: LimbMechanism) -> tuple[Steps, list[dict[str, sp.Expr]]]:
    """Return `first_order` along its default directions."""
    return first_order(mechanism)


def first_order(
    mechanism: LimbMechanism, directions: Directions | None = None
) -> tuple[Steps, list[dict[str, sp.Expr]]]:
    """Return the steps at nominal geometry with their rates, and the rates of each closure by direction.

    A direction is the rates of inputs along it, by its name; default the joint, each uncommanded coordinate of the
    platform, and ``errors``: all errors and deflections at once.
    """
    if directions is None:
        single = (mechanism.joint.symbol, *(quantity.symbol for quantity in mechanism.platform[mechanism.commanded :]))
        together = {quantity.symbol: quantity.symbol for quantity in mechanism.varied}
        directions = {str(s): {s: sp.Integer(1)} for s in single} | {"errors": together}
    rotation = [quantity.symbol for quantity in mechanism.platform[mechanism.commanded :]]
    nominal: dict[sp.Symbol, sp.Expr] = {quantity.symbol: sp.Integer(0) for quantity in mechanism.varied}
    seeds = {s: e.xreplace(nominal) for s, e in uncommanded(mechanism).items() if e != 0}
    started = [(sp.Symbol(f"nominal_{s}", real=True), e) for s, e in seeds.items()]
    nominal |= dict.fromkeys(rotation, sp.Integer(0)) | dict(zip(seeds, (s for s, _ in started), strict=True))
    rates = {name: dict(start) for name, start in directions.items()}
    steps: list[tuple[sp.Symbol, sp.Expr]] = []
    for symbol, expr in mechanism.steps:
        steps.append((symbol, vanishing(expr.xreplace(nominal), steps)))
        for direction, known in rates.items():
            if (rate := vanishing(_rate(expr, known, nominal), steps)) != 0:
                known[symbol] = sp.Symbol(f"{symbol}_{direction}", real=True)
                steps.append((known[symbol], rate))
    closures = [{d: _rate(e, known, nominal) for d, known in rates.items()} for e in mechanism.loop_closure]
    return [*started, *steps], closures


def vanishing(expr: sp.Expr, steps: Steps) -> sp.Expr:
    """Return 0 for what is identically zero, the expression for what is not.

    What vanishes on every nominal machine (the rods of a pair are parallel) is zero, not a rounding error.
    """
    return sp.Integer(0) if expr != 0 and sp.expand(expand_steps(expr, steps)) == 0 else expr


def linear(mechanism: LimbMechanism) -> Functions:
    """Return the first-order machine: `linear`, `nominal_joint`, `linear_constants`.

    `linear` has the layout of `newton`: per rod the closure's change by all errors, its derivatives by the platform
    (those by the position, which a compensator holds, are left out) and by the joint. All read the rows of parameters
    of the *calibrated* machine: geometry is taken as nominal, errors as what to compensate.
    """
    platform = [quantity.symbol for quantity in mechanism.platform]
    joint = mechanism.joint.symbol
    errors = [quantity.symbol for quantity in mechanism.varied]
    inputs = entries("x", platform) | entries("tool", [s.symbol for s in mechanism.tool]) | {joint: Place("q")}
    parameters = entries("p", [s.symbol for s in mechanism.limb_parameters])
    steps, closures = to_all_errors(mechanism)
    functions = Functions(Graph(steps, invariant=parameters), parameters, inputs)
    rows: list[sp.Expr | None] = []
    for rate in closures:
        rows += [
            rate["errors"],
            *(None for _ in platform[: mechanism.commanded]),
            *(rate[str(s)] for s in platform[mechanism.commanded :]),
            rate[str(joint)],
        ]
    joint_at = inverse_joint(mechanism).xreplace(dict.fromkeys(errors, sp.Integer(0)))
    functions.add("nominal_joint", "joint of the nominal limb at a given position", [joint_at])
    functions.add(
        "linear",
        "per rod of one nominal limb: change of the closure by all errors, derivatives by rotation and joint",
        rows,
        dense=True,
    )
    functions.constants("linear_constants", "what `linear` reads that no pose changes")
    return functions
