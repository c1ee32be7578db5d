"""Mei, Zang, Ding, Xie, Zhang 2018: the robot of two limbs, its measuring mechanism, what lengths identify.

Dictionary: ``u_i`` and ``w_i`` point along the arm and along the distal link, ``Q`` turns by 90 degrees; the paper's
``theta_i`` counts from the x axis in either limb, so a limb's own is ours on its side. ``lambda`` is the vector from
the scale's joint at the base to that on the platform, r - c - d, ``dr_M`` what the scale's mounting is off.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from functools import cache, partial

import sympy as sp

from derive import registry
from derive.graph import expand_steps
from derive.measurements import gauge
from derive.mechanisms import diamond
from derive.mechanisms.diamond import L, base_x, l, q, side
from derive.papers import exact
from derive.papers.exact import Field, Machine, Number, dot, less, minus, plain, product, solved, turned
from derive.papers.letters import Dictionary, differentials
from derive.papers.statements import Equal, Formula, Least, Rank, Rows, Statement

theta = sp.Symbol("theta", real=True)
w = sp.Matrix(sp.symbols("w_x w_y", real=True))
u = sp.Matrix([sp.cos(theta), sp.sin(theta)])
Q = sp.Matrix([[0, -1], [1, 0]])
LETTERS = Dictionary(
    {"w_i^T": w.T, "w_i^T Q u_i": w.T * Q * u, "w_i^T u_i": w.T * u, "1": sp.ones(1, 1)},
    w,
)
CASES = {"diamond": "gauge of which the machine knows the mount, its zero unknown"}  # what the paper reads
# the unknowns of eq. (12), and our errors of which they are made
COLUMNS = {"L dtheta": ("theta",), "de": ("ex", "ey"), "dL": ("L",), "dl": ("l",)}


@cache
def limb() -> tuple[sp.Matrix, dict[str, sp.Matrix]]:
    """Return eq. (11) as it is derived: the row by the platform, and those by ``L dtheta``, ``de``, ``dL``, ``dl``.

    Raises
    ------
    ValueError
        The two limbs differ by more than their letters.
    """
    mechanism = exact.limbs("diamond")
    (rates,) = differentials(mechanism, ("d",))
    own = {e.name: e.symbol for e in mechanism.errors}
    known = {sp.Symbol(f"d_{axis}", real=True): l * k for axis, k in zip("xy", w, strict=True)}

    def on(where: int) -> tuple[sp.Matrix, dict[str, sp.Matrix]]:
        def of(s: sp.Symbol) -> sp.Expr:
            return sp.simplify(rates[s].subs(side, where).xreplace(known).subs(q, theta)) / l

        scale = {"theta": L}
        platform = sp.Matrix([[of(diamond.px), of(diamond.py)]])
        return platform, {n: sp.Matrix([[-of(own[k]) / scale.get(k, 1) for k in by]]) for n, by in COLUMNS.items()}

    first, second = on(1), on(-1)
    if first != second:
        raise ValueError("the limbs of the Diamond differ by more than their letters.")
    return first


# ------------------------------------------------------------------------------------------------ machines in numbers

ANGLE = tuple(turned(f(theta)) for f in (sp.cos, sp.sin))


def rational_machine(seed: int) -> tuple[Machine, tuple[Number, Number]]:
    """Return two limbs with rational directions, and a rational direction of the scale."""
    rng = random.Random(seed)
    shared = {L: exact.rational(rng), l: exact.rational(rng)}
    limbs = [
        shared | dict(zip((*ANGLE, *w), (*exact.on_circle(rng), *exact.on_circle(rng)), strict=True)) for _ in "12"
    ]
    x, y = (sp.QQ.from_sympy(k) for k in exact.on_circle(rng))
    return exact.rationals(limbs), (x, y)


def printed_J(m: Machine) -> list[list[Number]]:
    """Return J' of eq. (12), by the ten errors."""
    own = sp.Matrix.hstack(*map(LETTERS.value, row().printed))
    return solved(m.stacked(plain(w.T)), m.diagonal(plain(own)), m.domain)


def derived_J(m: Machine) -> list[list[Number]]:
    """Return the shift by the ten errors, from both closures by the implicit function theorem."""
    platform, rows = limb()
    return solved(m.stacked(plain(platform)), m.diagonal(plain(sp.Matrix.hstack(*rows.values()))), m.domain)


def only(columns: Sequence[int], J: list[list[Number]]) -> list[list[Number]]:
    """Return some columns."""
    return [[r[k] for k in columns] for r in J]


OFFSETS = (0, 5)  # L dtheta_1 and L dtheta_2 among the ten


@cache
def by_length() -> tuple[sp.Matrix, sp.Matrix]:
    """Return the derivatives of the scale's reading by place and mounting times its length, and the vector lambda."""
    reading = registry.measurement("gauge").reading[0]
    size = sp.sqrt(gauge.length.dot(gauge.length))
    by = [*gauge.X.position[:2], *gauge.m[:2]]
    along = sp.Matrix([[sp.simplify(sp.diff(reading, s) * size) for s in by]])
    return along, gauge.length


def derived_length(m: Machine, direction: Sequence[Number]) -> list[list[Number]]:
    """Return the length's change by the ten errors and dr_M, by the chain rule through the reading."""
    along, _ = by_length()
    zero = direction[0] * 0
    nominal = dict.fromkeys([*gauge.m, *gauge.g, gauge.X.position[2]], zero)
    at = nominal | dict(zip(gauge.X.position[:2], direction, strict=True))
    n = [exact.evaluate(e, at, m.number) for e in along]
    return [[*product([n[:2]], derived_J(m))[0], *n[2:]]]


def printed_length(m: Machine, direction: Sequence[Number]) -> list[list[Number]]:
    """Return g' of eq. (21), ``lambda^T [J', -I]``."""
    return [[*product([direction], printed_J(m))[0], *minus([direction])[0]]]


def closed_machine(field: Field, lengths: dict[sp.Symbol, Number], place: Sequence[Number]) -> Machine | None:
    """Return the machine at a place, or None where a limb does not reach it."""
    limbs = []
    for where in (field(1), field(-1)):
        r = (place[0] - where * lengths[base_x], place[1])
        level = (dot(r, r) + lengths[L] ** 2 - lengths[l] ** 2) / (field(2) * lengths[L])
        angle = field.angle(*r, level)
        if angle is None:
            return None
        link = [(k - lengths[L] * t) / lengths[l] for k, t in zip(r, angle, strict=True)]
        limbs.append({**lengths, **dict(zip((*ANGLE, *w), (*angle, *link), strict=True))})
    return Machine(tuple(limbs), field.domain, field)


def length_rows(field: Field, poses: int, columns: Sequence[int] = range(12)) -> list[list[Number]]:
    """Return G' of eq. (24), or some of its columns: differences of adjacent lengths at poses that close."""
    rng = random.Random(exact.SEED)
    lengths = {s: field.any(rng) for s in (L, l, base_x)}
    mount = [field.any(rng) for _ in range(2)]
    rows: list[list[Number]] = []
    while len(rows) < poses:
        place = [field.any(rng) for _ in range(2)]
        m = closed_machine(field, lengths, place)
        vector = [k - g for k, g in zip(place, mount, strict=True)]
        size = field.root(dot(vector, vector))
        if m is not None and size is not None:
            rows += only(columns, derived_length(m, [k / size for k in vector]))
    return less(rows[1:], rows[:-1])


# ------------------------------------------------------------------------------------------------------ what is printed


@cache
def row() -> Rows:
    """Return the row of a limb, eq. (12)."""
    printed = LETTERS.terms("w_i^T Q u_i", "w_i^T", "w_i^T u_i", "1")
    return Rows("eq. (12)", "J'_i", "J'_i", LETTERS, printed, list(limb()[1].values()))


def closure() -> Statement:
    """Return eq. (5), the closure with the distal direction eliminated."""
    mechanism = exact.limbs("diamond")
    r, e = sp.Matrix([diamond.px, diamond.py]), sp.Matrix([base_x, diamond.base_y])
    rigid = {k.symbol: 0 for k in (*mechanism.errors, *mechanism.deflections, *mechanism.tool)} | {side: 1}
    derived = 2 * expand_steps(mechanism.loop_closure[0], mechanism.steps).subs(rigid).subs(q, theta)
    arm = e + L * u
    text = "r^T r - 2 (e_i + L_i u_i)^T r + (e_i + L_i u_i)^T (e_i + L_i u_i) = l_i^2"
    return Equal("eq. (5)", "closure", "0", r.dot(r) - 2 * arm.dot(r) + arm.dot(arm) - l**2, sp.expand(derived), text)


def statements() -> tuple[Statement, ...]:
    """Return what the paper states of its closure, its matrices and what they can identify."""
    machines = [rational_machine(seed) for seed in (1, 2, 3)]
    f, M = (sp.Matrix(sp.symbols(f"{n}_x {n}_y", real=True)) for n in ("f", "dr_M"))
    length = by_length()[1].xreplace(dict(zip((*gauge.X.position, *gauge.g), (*f, 0, 0, 0, 0), strict=True)))
    mounted = sp.Matrix(length[:2]).xreplace(dict(zip(gauge.m[:2], M, strict=True)))
    mounting = Dictionary({"dr_M^(j-1)": M}, ())
    J = "[w_1 w_2]^-T blockdiag(J'_1, J'_2)"
    J0 = "J = [w_1 w_2]^-T diag(w_1^T Q u_1, w_2^T Q u_2)"
    four = (*OFFSETS, 10, 11)
    return (
        closure(),
        row(),
        Formula("eq. (12)", "J'", f"J' = {J}", lambda k: printed_J(k[0]), lambda k: derived_J(k[0]), machines),
        Formula(
            "eq. (13)",
            "J",
            J0,
            lambda k: only(OFFSETS, printed_J(k[0])),
            lambda k: only(OFFSETS, derived_J(k[0])),
            machines,
        ),
        Formula(
            "eq. (21)",
            "g'",
            "g'_k = lambda^_k^T [J'_k, -I]",
            lambda k: printed_length(*k),
            lambda k: derived_length(*k),
            machines,
        ),
        Rank("section 4", "rank of G'", "rank(G') = {rank}", 12, partial(length_rows, poses=14)),
        Rank("section 4", "rank of G", "rank(G) = {rank}", 4, partial(length_rows, poses=5, columns=four)),
        Least("section 4", "number of positions", "K >= {count}", 13, length_rows, range(8, 15)),
        Rows("eq. (30)", "f", "f_k^(j) - f_k^(j-1)", mounting, mounting.terms("dr_M^(j-1)"), [mounted - f]),
    )
