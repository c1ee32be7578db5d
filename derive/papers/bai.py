"""Bai, Mei, Huang, Chetwynd 2015: the linear model of the Delta, its distances, its ranks, its compensator.

Dictionary: the paper's ``theta_i`` is our q, ``lhat`` the unit vector along the rods, from the elbow to the platform,
``e_i = b_i - a_i``; ``a_i`` leads from the reference point P
to A_i, as eqs. (13) to (16) need it where P is not O'. Half the sum of the
two closures of a limb over l is its eq. (6), their difference over l c its eq. (7).
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, partial
from itertools import combinations

import sympy as sp

from derive import registry
from derive.measurements import distance
from derive.mechanisms import delta
from derive.mechanisms.delta import ORIENTATION, POSITION, L, a, c, l, q, tool, u0, v0, w0
from derive.papers import exact
from derive.papers.deltas import closed_machine, lengths_of, lhat, places, rational_machine, theta
from derive.papers.exact import Field, Machine, Number, beside, less, minus, plain, product, solved
from derive.papers.letters import Dictionary, differentials, vanishes, vector
from derive.papers.statements import Formula, Least, Rank, Rows, Statement

u1 = sp.cos(theta) * u0 + sp.sin(theta) * v0
v1 = -sp.sin(theta) * u0 + sp.cos(theta) * v0
a_i = a * u0 - tool  # from the reference point
LETTERS = Dictionary(
    {
        "lhat^T": lhat.T,
        "(a x lhat)^T": a_i.cross(lhat).T,
        "(w0 x lhat)^T": w0.cross(lhat).T,
        "1": sp.ones(1, 1),
        **{
            f"lhat.{n}": sp.Matrix([lhat.dot(v)])
            for n, v in (("u0", u0), ("v0", v0), ("w0", w0), ("u1", u1), ("v1", v1))
        },
    },
    lhat,
)
CASES = {"delta": "distances between poses"}  # what the paper reads, as the rank tables call it
# the unknowns of eqs. (6) and (7) by our names, and what each is in terms of our error
UNKNOWNS = {"theta": L, "ex": 1, "ey": 1, "ez": 1, "L": 1, "alpha0": L, "beta0": L, "l": 1}
UNKNOWNS |= {"dl": 1 / c, "dc": 1 / c, "alpha03": 1, "beta03": 1, "alpha2": 1, "beta2": 1}
PLACE = delta.px, delta.py, delta.pz
TURN = delta.cx, delta.cy, delta.cz


@dataclass(frozen=True)
class Rods:
    """Half the sum and the difference of a limb's closures: coefficients of shift, turn, joint and unknowns."""

    place: sp.Matrix
    turn: sp.Matrix
    joint: sp.Expr
    unknowns: dict[str, sp.Expr]


@cache
def rods() -> tuple[Rods, Rods]:
    """Return eqs. (6) and (7) as they are derived: ``place dr + turn deps = unknowns dp``, for one limb."""
    mechanism = exact.limbs("delta")
    first, second = differentials(mechanism, ("d",))
    letters = dict(zip(vector("d"), l * lhat, strict=True)) | {q: theta}
    own = {e.name: e.symbol for e in mechanism.errors}

    def rod(sign: int, by: sp.Expr) -> Rods:
        def of(s: sp.Symbol) -> sp.Expr:
            return sp.expand(((first[s] + sign * second[s]) / by).xreplace(letters))

        return Rods(
            sp.Matrix([[of(s) for s in PLACE]]),
            sp.Matrix([[of(s) for s in TURN]]),
            -of(q) / L,
            {name: sp.expand(-of(own[name]) / scale) for name, scale in UNKNOWNS.items()},
        )

    return rod(+1, 2 * l), rod(-1, l * c)


def row(unknowns: dict[str, sp.Expr], *names: str) -> sp.Matrix:
    """Return some of a limb's coefficients as a row."""
    return sp.Matrix([[unknowns[n] for n in names]])


def closure() -> sp.Matrix:
    """Return eq. (1) as printed, times the direction of the rods, which its turns leave out: a row of either rod."""
    found = []
    for side in (1, -1):
        arm = sp.Rational(side, 2) * c * w0
        moved = {
            "theta": w0.cross(L * u1) + w0.cross(arm),
            **dict(zip(("ex", "ey", "ez"), (sp.eye(3).col(k) for k in range(3)), strict=True)),
            "L": u1,
            **{name: axis.cross(L * u1) for name, axis in (("alpha0", u0), ("beta0", v0))},
            "l": lhat,
            "dl": side * lhat / 2,
            "dc": side * w0 / 2,
            **{
                name: axis.cross(arm) for name, axis in (("alpha03", u0), ("beta03", v0), ("alpha2", u1), ("beta2", v1))
            },
        }
        own = sp.Matrix([[lhat.dot(moved[name]) for name in UNKNOWNS]])
        found.append(sp.Matrix.hstack(lhat.T, (a_i + arm).cross(lhat).T, own))
    return sp.Matrix.vstack(*found)


def derived_closure() -> sp.Matrix:
    """Return the same as it is derived: shift, turn and errors of either rod."""
    mean, half = rods()
    found = []
    for side in (1, -1):
        part = sp.Rational(side, 2) * c
        own = [(mean.unknowns[n] + part * half.unknowns[n]) * scale for n, scale in UNKNOWNS.items()]
        found.append(sp.Matrix.hstack(mean.place + part * half.place, mean.turn + part * half.turn, sp.Matrix([own])))
    return sp.Matrix.vstack(*found)


# ------------------------------------------------------------------------------------------------- matrices in numbers

NAMES = (*(f"{n}_{i}" for i in (1, 2, 3) for n in POSITION), *(f"{n}_{i}" for i in (1, 2, 3) for n in ORIENTATION))


def _by_platform(m: Machine) -> list[list[Number]]:
    """Return the derivatives of the six closures by shift and turn, (6, 6)."""
    return [r for k in rods() for r in m.stacked(plain(sp.Matrix.hstack(k.place, k.turn)))]


def derived_errors(m: Machine) -> list[list[Number]]:
    """Return shift and turn by the 42 errors, (6, 42): the six closures solved by the implicit function theorem."""
    mean, half = rods()
    first, second = (
        m.diagonal(plain(row(mean.unknowns, *POSITION))),
        m.diagonal(plain(row(half.unknowns, *ORIENTATION))),
    )
    zero = m.number(sp.Integer(0))
    right = [*([*r, *[zero] * len(second[0])] for r in first), *([*[zero] * len(first[0]), *r] for r in second)]
    return solved(_by_platform(m), right, m.domain)


def derived_compensator(m: Machine) -> list[list[Number]]:
    """Return the joints that hold the point, (3, 42): ``L dq`` with ``dr = 0`` in the six closures."""
    by_joint = [r for k in rods() for r in m.diagonal(plain(sp.Matrix([[k.joint]])))]
    return minus(solved(solved(_by_platform(m), by_joint, m.domain)[:3], derived_errors(m)[:3], m.domain))


def derived_inverse(m: Machine) -> list[list[Number]]:
    """Return the inverse of what the derivation has for A_ee."""
    return [list(r) for r in sp.Matrix(m.stacked(plain(rods()[1].turn))).inv().tolist()]


def blocks(m: Machine) -> dict[str, list[list[Number]]]:
    """Return A_rr, A_re, A_ee, B_r, B_e and B_m of the paper in numbers, from the printed forms."""
    printed = {s.name: plain(sp.Matrix.hstack(*map(LETTERS.value, s.printed))) for s in rows()}
    wide = {name: m.stacked(printed[name]) for name in ("A_rr", "A_re", "A_ee")}
    wide["B_m"] = m.diagonal(plain(LETTERS.named["lhat.v1"]))
    return wide | {name: m.diagonal(printed[name]) for name in ("B_r", "B_e")}


def C_e(m: Machine) -> list[list[Number]]:
    """Return eq. (9)."""
    k = blocks(m)
    return solved(k["A_ee"], k["B_e"], m.domain)


def C_r(m: Machine) -> list[list[Number]]:
    """Return eq. (8)."""
    k = blocks(m)
    return solved(k["A_rr"], beside(k["B_r"], minus(product(k["A_re"], C_e(m)))), m.domain)


def compensator(m: Machine) -> list[list[Number]]:
    """Return eq. (23), dq_m by the 42 errors, with B_m on its diagonal."""
    k = blocks(m)
    return minus(solved(k["B_m"], beside(k["B_r"], minus(product(k["A_re"], C_e(m)))), m.domain))


def inverse_of_turns(m: Machine, *, transposed: bool) -> list[list[Number]]:
    """Return eq. (24): cross products of the rows of A_ee over their triple product, as columns or as printed."""
    n = [sp.Matrix(r) for r in blocks(m)["A_ee"]]
    crossed = [n[1].cross(n[2]), n[2].cross(n[0]), n[0].cross(n[1])]
    found = sp.Matrix.hstack(*crossed) / n[0].dot(crossed[0])
    return [list(r) for r in (found.T if transposed else found).tolist()]


def eliminated() -> bool:
    """Tell whether SymPy finds eqs. (8) and (9) from the rows: what (6), (7) leave out vanishes; algebra is left."""
    mean, half = rods()
    absent = [*half.place, *(mean.unknowns[n] for n in ORIENTATION), *(half.unknowns[n] for n in POSITION)]
    compared = all(s.verdict().status == "proved" for s in rows())
    A_rr, A_re, A_ee = (sp.MatrixSymbol(name, 3, 3) for name in ("A_rr", "A_re", "A_ee"))
    x, y = sp.MatrixSymbol("x", 3, 1), sp.MatrixSymbol("y", 3, 1)  # B_r dp_r and B_e dp_e
    turn = A_ee.I * y
    shift = A_rr.I * x - A_rr.I * A_re * turn
    solves = sp.expand(A_rr * shift + A_re * turn).doit() == x and (A_ee * turn).doit() == y
    return compared and solves and vanishes(sp.Matrix(absent))


def compensated() -> bool:
    """Tell whether SymPy finds eq. (23): joints enter the rows of (6) by B_m only, and its dq_m leaves no shift."""
    mean, half = rods()
    B_m = sp.MatrixSymbol("B_m", 3, 3)
    z = sp.MatrixSymbol("z", 3, 1)  # B_r dp_r - A_re A_ee^-1 B_e dp_e
    leaves = (z + B_m * (-B_m.I * z)).doit() == sp.ZeroMatrix(3, 1)
    joints = sp.Matrix([mean.joint - LETTERS.named["lhat.v1"][0], half.joint])
    return eliminated() and leaves and vanishes(joints)


# ------------------------------------------------------------------------------------------------------------ distances


@dataclass(frozen=True)
class Poses:
    """Machines at poses, and the places of the reference point there."""

    machines: Sequence[Machine]
    points: Sequence[Sequence[Number]]


@cache
def slopes() -> tuple[sp.Matrix, sp.Matrix]:
    """Return a distance times its derivatives by both places, of which the root cancels; and these six letters."""
    places = sp.Matrix([*distance.A.position, *distance.B.position])
    reading = registry.measurement("distance").reading[0]
    return sp.Matrix([[sp.simplify(reading * sp.diff(reading, s)) for s in places]]), places


def derived_distances(poses: Poses, columns: Sequence[int] | None = None) -> list[list[Number]]:
    """Return rho times each row of H, all pairs of poses: the derivative of the reading, by the chain rule."""
    slope, letters = slopes()
    shifts = [derived_errors(m)[:3] for m in poses.machines]
    if columns is not None:
        shifts = [[[r[k] for k in columns] for r in shift] for shift in shifts]
    found = []
    for i, j in combinations(range(len(shifts)), 2):
        at = dict(zip(letters, (*poses.points[i], *poses.points[j]), strict=True))
        n = [exact.evaluate(e, at, poses.machines[0].number) for e in slope]
        found += product([n], [*shifts[i], *shifts[j]])
    return found


def printed_distances(poses: Poses) -> list[list[Number]]:
    """Return rho times eq. (14), ``n^T [C_rr,j - C_rr,i, C_re,j - C_re,i]``."""
    C = [C_r(m) for m in poses.machines]
    found = []
    for i, j in combinations(range(len(C)), 2):
        found += product(less([poses.points[j]], [poses.points[i]]), less(C[j], C[i]))
    return found


def rational_poses(count: int) -> Poses:
    """Return machines that need not close, and places that need not be theirs: the relation is one of matrices."""
    rng = random.Random(exact.SEED)
    points = [[exact.rational(rng) for _ in range(3)] for _ in range(count)]
    return Poses([rational_machine(seed) for seed in range(count)], [[sp.QQ.from_sympy(k) for k in p] for p in points])


def distance_rows(field: Field, points: int, model: str) -> list[list[Number]]:
    """Return H of a model over a prime field: all distances of 13 poses that close, point by point."""
    rng = random.Random(exact.SEED)
    lengths = lengths_of(field, rng)
    columns = [NAMES.index(n) for n in exact.limbs("delta").models[model]]
    centres = places(field, rng, lengths, 13)
    found: list[list[Number]] = []
    for _ in range(points):
        point = [field.any(rng) for _ in range(3)]
        here = lengths | dict(zip(tool, point, strict=True))
        machines = [m for centre in centres if (m := closed_machine(field, here, centre)) is not None]
        at = [[k + t for k, t in zip(centre, point, strict=True)] for centre in centres]
        found += derived_distances(Poses(machines, at), columns)
    return found


# ------------------------------------------------------------------------------------------------------ what is printed


@cache
def rows() -> tuple[Rows, ...]:
    """Return the rows of eqs. (6) and (7), limb by limb."""
    mean, half = rods()
    s, k = sp.sin(theta), sp.cos(theta)
    by = mean.unknowns
    position = [row(by, "theta"), row(by, "ex", "ey", "ez"), *(row(by, n) for n in ("L", "alpha0", "beta0", "l"))]
    printed = {"lhat.v1": 1, "lhat^T": 1, "lhat.u1": 1, "lhat.w0": s, "-lhat.w0": k, "1": 1}
    return (
        Rows("eq. (6)", "A_rr", "A_rr,i", LETTERS, LETTERS.terms("lhat^T"), [mean.place]),
        Rows("eq. (6)", "A_re", "A_re,i", LETTERS, LETTERS.terms("(a x lhat)^T"), [mean.turn]),
        Rows("eq. (6)", "B_r", "B_r,i", LETTERS, LETTERS.terms(printed), position),
        Rows("eq. (7)", "A_ee", "A_ee,i", LETTERS, LETTERS.terms("(w0 x lhat)^T"), [half.turn]),
        Rows(
            "eq. (7)",
            "B_e",
            "B_e,i",
            LETTERS,
            LETTERS.terms("1", "lhat.w0", "-lhat.v0", "lhat.u0", "-lhat.v1", "lhat.u1"),
            [row(half.unknowns, n) for n in ORIENTATION],
        ),
    )


INVERSE = "A_ee^-1 = 1/(n1.(n2 x n3)) [n2 x n3, n3 x n1, n1 x n2]{}, n_i = w_0,i x lhat_i"


def first_order(machines: Sequence[Machine]) -> Formula:
    """Return eq. (1)."""
    unit = lhat[2] ** 2, 1 - lhat[0] ** 2 - lhat[1] ** 2
    return Formula(
        "eq. (1)",
        "closure",
        "dr = de + dL u1 + R0 (dth0 + dth1) x L u1 + s/2 dc_c w0 + l deps_j x lhat + dl_j lhat"
        " + R0 (dth0 + dth1 + R1 dth2) x s/2 c w0 - s/2 dc_a w0 - (deps + R3 dth3) x s/2 c w0 - deps x a",
        lambda m: m.stacked(plain(closure())),
        lambda m: m.stacked(plain(derived_closure())),
        machines,
        proof=lambda: vanishes((closure() - derived_closure()).expand().subs(*unit)),
    )


def statements() -> tuple[Statement, ...]:
    """Return what the paper states of matrices, ranks and its compensator."""
    machines = [rational_machine(seed) for seed in (1, 2, 3)]
    return (first_order(machines), *rows(), *_sensitivities(machines), *_ranks(), *_compensators(machines))


def _sensitivities(machines: Sequence[Machine]) -> tuple[Statement, ...]:
    """Return what is stated of the point, the plate and distances by the errors."""
    return (
        Formula(
            "eq. (8)",
            "C_r",
            "C_r = [A_rr^-1 B_r, -A_rr^-1 A_re A_ee^-1 B_e]",
            C_r,
            lambda m: derived_errors(m)[:3],
            machines,
            proof=eliminated,
        ),
        Formula(
            "eq. (9)",
            "C_e",
            "C_e = A_ee^-1 B_e",
            C_e,
            lambda m: [r[24:] for r in derived_errors(m)[3:]],
            machines,
            proof=eliminated,
        ),
        Formula(
            "eq. (16)",
            "H",
            "drho = [H_r H_e] (dp_r; dp_e), rows n0^T [C_rr,j - C_rr,i, C_re,j - C_re,i]",
            printed_distances,
            derived_distances,
            [rational_poses(4)],
        ),
    )


def _ranks() -> tuple[Statement, ...]:
    """Return what is stated of how much distances know."""
    points = "points on the plate whose distances see model 32: {count}"
    return (
        Rank(
            "section 3.2", "rank of H_r", "rank(H_r) = {rank}", 18, partial(distance_rows, points=1, model="delta/18")
        ),
        Rank("section 3.2", "rank of H", "rank(H) = {rank}", 32, partial(distance_rows, points=3, model="delta/36")),
        Least("section 3.2", "number of points", points, 2, partial(distance_rows, model="delta/32"), range(1, 3)),
    )


def _compensators(machines: Sequence[Machine]) -> tuple[Statement, ...]:
    """Return what is stated of the commands that take errors back."""
    return (
        Formula(
            "eq. (22)",
            "B_m",
            "B_m = [lhat_1.v_1,1; lhat_2.v_2,1; lhat_3.v_3,1]",
            None,  # a column, by frames of limb 1 that do not exist: it multiplies no dq_m
            lambda m: m.diagonal(plain(sp.Matrix([[rods()[0].joint]]))),
            machines,
            corrected=("B_m = diag(lhat_1.v_1,1, lhat_2.v_1,2, lhat_3.v_1,3)", lambda m: blocks(m)["B_m"]),
        ),
        Formula(
            "eq. (23)",
            "dq_m",
            "dq_m = -B_m^-1 (B_r dp_r - A_re A_ee^-1 B_e dp_e)",
            compensator,
            derived_compensator,
            machines,
            proof=compensated,
        ),
        Formula(
            "eq. (24)",
            "A_ee^-1",
            INVERSE.format("^T"),
            partial(inverse_of_turns, transposed=True),
            derived_inverse,
            machines,
            corrected=(INVERSE.format(""), partial(inverse_of_turns, transposed=False)),
        ),
    )
