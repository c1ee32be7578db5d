"""Traslosheros, Sebastian, Torrijos, Carelli, Castillo 2013: constraints in increments, and what they identify.

Dictionary: the paper's ``a_i, b_i, h_i`` are ours with their errors, ``theta_i0 + Theta_ik`` is theta0 + q, and
``P_0 + Pi_k`` our P + p0. ``Gamma`` is twice our closure.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from functools import cache, partial

import sympy as sp

from derive.graph import expand_steps
from derive.mechanisms import robotennis as own
from derive.mechanisms.robotennis import H, a, b, h, phi
from derive.papers import exact
from derive.papers.exact import Field, Machine, Number, dot, plain, turned
from derive.papers.letters import differentials
from derive.papers.statements import Equal, Least, Rank, Statement

CASES = {"robotennis": "positions in a known frame"}  # what the paper reads, as the rank tables call it
theta0, Theta = sp.symbols("theta0 Theta", real=True)
P0 = sp.Matrix(sp.symbols("P_x0 P_y0 P_z0", real=True))
Pi = sp.Matrix(sp.symbols("Pi_x Pi_y Pi_z", real=True))

_turned = theta0 + Theta
across = (a * sp.cos(_turned) + H, sp.cos(phi), sp.sin(phi))
GAMMA = (  # eq. (4), as printed
    (P0[0] + h * across[1] + Pi[0] - across[0] * across[1]) ** 2
    + (P0[1] + h * across[2] + Pi[1] - across[0] * across[2]) ** 2
    + (P0[2] + Pi[2] - a * sp.sin(_turned)) ** 2
    - b**2
)
U_i = (a, b, h, theta0)  # the unknowns of a limb, eq. (7)
OWN, COMMON = (own.da, own.db, own.dh, own.theta0), (own.px0, own.py0, own.pz0)  # ours


@cache
def derived() -> sp.Expr:
    """Return twice the closure of a limb, in the paper's letters."""
    mechanism = exact.limbs("robotennis")
    rigid = {k.symbol: 0 for k in (*mechanism.deflections, *mechanism.tool)} | {own.dphi: 0, own.dH: 0}
    absolute = {own.da: 0, own.db: 0, own.dh: 0}  # a, b, h stand for the whole length
    counted = dict(zip((own.px, own.py, own.pz), Pi, strict=True)) | {own.q: Theta, own.theta0: theta0}
    home = dict(zip((own.px0, own.py0, own.pz0), P0, strict=True))
    closure = expand_steps(mechanism.loop_closure[0], mechanism.steps)
    return 2 * closure.subs(rigid | absolute).subs(counted | home)


def derived_slopes() -> sp.Matrix:
    """Return the derivatives of Gamma by a limb's unknowns and the home: twice the closure's differential."""
    (rates,) = differentials(exact.limbs("robotennis"), ())
    at = (
        {own.q: theta0 + Theta} | dict(zip((own.px, own.py, own.pz), P0 + Pi, strict=True)) | dict.fromkeys(own.tool, 0)
    )
    return 2 * sp.Matrix([[rates[s] for s in (*OWN, *COMMON)]]).subs(at)


# ------------------------------------------------------------------------------------------------ machines in numbers

ROD = sp.symbols("rod_x rod_y rod_z", real=True)
ANGLES = tuple(turned(f(s)) for s in (own.q, phi) for f in (sp.cos, sp.sin))


@cache
def rows() -> tuple[sp.Matrix, sp.Matrix]:
    """Return the derivatives of a limb's closure by its own errors and by the home, the rod as a vector."""
    (rates,) = differentials(exact.limbs("robotennis"), ("rod",))
    return plain(sp.Matrix([[rates[s] for s in OWN]])), plain(sp.Matrix([[rates[s] for s in COMMON]]))


def closed_machine(field: Field, lengths: dict[sp.Symbol, Number], place: Sequence[Number]) -> Machine | None:
    """Return the machine at a place, or None where a limb does not reach it."""
    half = field(sp.Rational(1, 2))
    limbs = []
    for C, S in ((field(1), field(0)), (-half, half * field.root3), (-half, -half * field.root3)):
        e = lengths[h] - lengths[H]
        r = (place[0] + e * C, place[1] + e * S, place[2])
        level = (dot(r, r) + lengths[a] ** 2 - lengths[b] ** 2) / (field(2) * lengths[a])
        found = field.angle(r[0] * C + r[1] * S, r[2], level)
        if found is None:
            return None
        rod = [k - lengths[a] * t for k, t in zip(r, (found[0] * C, found[0] * S, found[1]), strict=True)]
        limbs.append({**lengths, **dict(zip((*ANGLES, *ROD), (*found, C, S, *rod), strict=True))})
    return Machine(tuple(limbs), field.domain, field)


def constraint_rows(field: Field, poses: int) -> list[list[Number]]:
    """Return J of eq. (7) at poses that close: per limb the columns of its own errors, the home common to all."""
    rng = random.Random(exact.SEED)
    lengths = {s: field.any(rng) for s in (a, b, h, H)}
    single, common = rows()
    found: list[list[Number]] = []
    while len(found) < 3 * poses:
        m = closed_machine(field, lengths, [field.any(rng) for _ in range(3)])
        if m is not None:
            found += exact.beside(m.diagonal(single), m.stacked(common))
    return found


# ------------------------------------------------------------------------------------------------------ what is printed


def statements() -> tuple[Statement, ...]:
    """Return what the paper states of its constraints and of what they identify."""
    printed = (
        "(Px0 + h cos phi + Pi_x - (a cos(theta0 + Theta) + H) cos phi)^2"
        " + (Py0 + h sin phi + Pi_y - (a cos(theta0 + Theta) + H) sin phi)^2"
        " + (Pz0 + Pi_z - a sin(theta0 + Theta))^2 - b^2 = 0"
    )
    unknowns = (*U_i, *P0)
    J = "J_ik = [Gamma_a, Gamma_b, Gamma_h, Gamma_theta0, 0, ..., 0, Gamma_P0]"  # an index: derivative by it
    printed_slopes = sp.Matrix([[sp.diff(GAMMA, s) for s in unknowns]])
    return (
        Equal("eq. (4)", "closure", "Gamma", GAMMA, derived(), printed),
        Equal("eq. (7)", "J", "J_ik", printed_slopes, derived_slopes(), J),
        Rank("section 4", "rank of J", "rank(J) = {rank} of 15", 15, partial(constraint_rows, poses=7)),
        Least("section 5.1", "number of poses", "at least {count} poses", 6, constraint_rows, range(3, 9)),
    )
