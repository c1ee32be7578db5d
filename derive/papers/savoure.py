"""Savoure, Maurine, Corbel, Krut 2006: the Delta with 51 errors, and the planar parallelogram.

Dictionary: ``AB`` leads along a rod from the arm to the plate, ``BC`` from the plate's joint to the tool, ``AP`` from
the arm's joint to P_i; the paper's ``P_i`` turns by phi - 90 deg, ``Q_i`` by q (theta here), ``R_i = P_i Q_i``. Of the
planar mechanism ``(u, v)`` is the direction of the rods.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from functools import cache, partial

import sympy as sp

from derive.graph import expand_steps
from derive.mechanisms import complete_delta, delta
from derive.mechanisms import planar_parallelogram as planar
from derive.mechanisms.delta import L, a, c, l, q, tool, u0, v0, w0
from derive.papers import exact
from derive.papers.deltas import closed_machine, lengths_of, lhat, places, rational_machine, theta
from derive.papers.exact import Field, Machine, Number, plain, solved
from derive.papers.letters import Dictionary, differentials, vector
from derive.papers.statements import Equal, Formula, Least, Rank, Rows, Statement
from derive.vectors import skew, turn_about_x

CASES = {"complete_delta": "poses in a known frame", "planar_parallelogram": "poses in a known frame"}  # what it reads
AB = vector("AB")
R_i = sp.Matrix.hstack(w0, u0, v0) * turn_about_x(theta)


def letters(side: int) -> Dictionary:
    """Return the paper's vectors and matrices of rod 1 (side +1) or 2 (side -1) of a pair."""
    BC = tool - a * u0 - side * c / 2 * w0
    AP = -R_i * sp.Matrix([side * c / 2, L, 0])
    named = {"AB^T": AB.T, "AB^T R_i": AB.T * R_i, "AB^T hat(BC)": AB.T * skew(BC), "AB^T hat(AP)": AB.T * skew(AP)}
    return Dictionary({**named, "l": sp.Matrix([[l]])}, AB)


@cache
def blocks(rod: int) -> dict[str, sp.Matrix]:
    """Return relation (12) as it is derived, ``[x, alpha] = [b, a, l, beta]``, for rod 1 or 2 of a limb."""
    rates = differentials(exact.limbs("complete_delta"), ("d1", "d2"))[rod - 1]
    known = dict(zip(vector(f"d{rod}"), AB, strict=True)) | {q: theta}
    in_platform, in_arm, dl = complete_delta.errors_of(rod)

    def row(symbols: Sequence[sp.Symbol], sign: int = -1) -> sp.Matrix:
        return sp.Matrix([[sp.expand(sign * rates[s].xreplace(known)) for s in symbols]])

    platform = {"x": row((delta.px, delta.py, delta.pz), 1), "alpha": row((delta.cx, delta.cy, delta.cz), 1)}
    return platform | {"b": row(in_platform), "a": row(in_arm), "l": row([dl]), "beta": row(complete_delta.beta)}


# ---------------------------------------------------------------------------------------------- the Delta in numbers

RATES = ("b", "a", "l")


def _numbers(m: Machine) -> Machine:
    """Return a machine with its rods as vectors."""
    return Machine(
        tuple({**k, **{s: k[l] * k[h] for s, h in zip(AB, lhat, strict=True)}} for k in m.limbs), m.domain, m.number
    )


def matrices(m: Machine, *, printed: bool, sign: int = 1) -> tuple[list[list[Number]], list[list[Number]]]:
    """Return J_X (6, 6) and J_kC (6, 51): derived, or of eqs. (14), (15), (18) and (19), with a sign of (14)."""
    zero = m.number(sp.Integer(0))
    left, right = [], []
    for n, i, j in ((n, n // 2, n % 2 + 1) for n in range(6)):
        own = blocks(j)
        if printed:
            k = letters(3 - 2 * j)
            own = {"x": k.named["AB^T"], "alpha": k.named["AB^T hat(BC)"], "b": sign * k.named["AB^T"]}
            own |= {"a": k.named["AB^T R_i"], "l": k.named["l"], "beta": k.named["AB^T hat(AP)"]}
        left.append(m.block(plain(sp.Matrix.hstack(own["x"], own["alpha"])), i)[0])
        seven = m.block(plain(sp.Matrix.hstack(*(own[name] for name in RATES))), i)[0]
        beta = m.block(plain(own["beta"]), i)[0]
        right.append([*[zero] * 7 * n, *seven, *[zero] * 7 * (5 - n), *[zero] * 3 * i, *beta, *[zero] * 3 * (2 - i)])
    return left, right


def S_C(m: Machine, *, printed: bool, sign: int = 1) -> list[list[Number]]:
    """Return ``J_X^-1 J_kC``, eq. (22)."""
    return solved(*matrices(_numbers(m), printed=printed, sign=sign), m.domain)


def pose_rows(field: Field, poses: int, coordinates: slice = slice(0, 6)) -> list[list[Number]]:
    """Return S_G, eq. (24), of poses in a known frame that close over a prime field."""
    rng = random.Random(exact.SEED)
    lengths = lengths_of(field, rng)
    machines = [closed_machine(field, lengths, place) for place in places(field, rng, lengths, poses)]
    return [row for m in machines if m is not None for row in S_C(m, printed=False)[coordinates]]


# ------------------------------------------------------------------------------------------------------- in the plane

u, v = sp.symbols("u v", real=True)


@cache
def in_the_plane() -> tuple[sp.Matrix, sp.Matrix]:
    """Return J_X (3, 3) and J_kC (3, 9) of the planar mechanism as they are derived from its closures, line by line."""
    mechanism = exact.limbs("planar_parallelogram")
    rod = {sp.Symbol("r2_x", real=True): u, sp.Symbol("r2_y", real=True): v}  # the other rod, and its direction
    lines = [expand_steps(e, mechanism.steps) for e in mechanism.loop_closure[:2]]
    ends = {s: expand_steps(s, mechanism.steps) for s in rod}
    other = mechanism.loop_closure[2]
    equal = {planar.l1: l, planar.l2: l, planar.a2y: 0, planar.b2y: 0, sp.sin(q): u, sp.cos(q): -v}
    nominal = dict.fromkeys([k.symbol for k in (*mechanism.common, *mechanism.tool)], 0) | {planar.cz: 0}

    def by(s: sp.Symbol) -> list[sp.Expr]:
        third = sp.diff(other, s) + sum(sp.diff(other, k) * sp.diff(e, s) for k, e in ends.items())
        x, y, third = (
            e.subs({k: l * d for k, d in rod.items()}).subs(nominal).subs(equal)
            for e in (*(sp.diff(e, s) for e in lines), third)
        )
        found = (u * x + v * y, third / l, -v * x + u * y)
        return [sp.expand(sp.expand(e).subs(v**2, 1 - u**2)) for e in found]

    J_X = sp.Matrix([by(k.symbol) for k in mechanism.platform]).T
    J_kC = -sp.Matrix([by(k.symbol) for k in mechanism.common]).T
    return J_X, J_kC


# ------------------------------------------------------------------------------------------------------ what is printed


def statements() -> tuple[Statement, ...]:
    """Return what the paper states of matrices and of what they can identify."""
    machines = [rational_machine(seed) for seed in (1, 2)]
    first, k = blocks(1), letters(1)
    J_X, J_kC = in_the_plane()
    b1x, b2x, h = planar.b1x, planar.b2x, planar.h
    relation = "[AB^T, AB^T hat(BC)] [dx; dalpha] = [{}AB^T, AB^T R_i, l, AB^T hat(AP)] [db'; da; dl; dbeta]"
    printed, derived = partial(S_C, printed=True), partial(S_C, printed=False)
    S_G = "{rank} of 51 errors to be identified with full poses"
    printed_J_X = sp.Matrix([[u, v, -u * h - v * b1x], [u, v, -u * h + v * b2x], [-v, u, v * h - u * b1x]])
    printed_J_kC = sp.Matrix(
        [[0, -u, 0, 0, u, 0, 0, 1, 0], [0, 0, u, v, 0, -u, -v, 0, 1], [-l, 0, 0, 0, -v, 0, 0, 0, 0]]
    )
    return (
        Formula(
            "eq. (12)",
            "rod",
            relation.format("+"),
            printed,
            derived,
            machines,
            corrected=(relation.format("-"), partial(printed, sign=-1)),
        ),
        Rows("eq. (14)", "J^a", "J^a", k, k.terms("AB^T", "AB^T R_i", "l"), [first[name] for name in RATES]),
        Rows("eq. (15)", "J^b", "J^b", k, k.terms("AB^T hat(AP)"), [first["beta"]]),
        Rows("eq. (18)", "J_X", "J_X,ij", k, k.terms("AB^T", "AB^T hat(BC)"), [first["x"], first["alpha"]]),
        Formula("eq. (22)", "S_C", "S_C = J_X^-1 J_kC", partial(printed, sign=-1), derived, machines),
        Rank("section II.B", "rank of S_G", S_G, 51, partial(pose_rows, poses=9)),
        Least("section II.B", "number of poses", "m = {count}", 9, pose_rows, range(7, 11)),
        Equal("eq. (64)", "J_X of the plane", "J_X", printed_J_X, J_X),
        Equal("eq. (65)", "J_kC of the plane", "J_kC", printed_J_kC, J_kC),
    )
