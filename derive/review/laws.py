r"""Laws that every machine goes through, as SymPy expressions of matrices: what a report shows is what SymPy made.

Nothing here is typed as it is shown. A law is a linear relation between differentials (`Linear`), solved, substituted
and transposed by rules of algebra, or read by the `Reader` from the same functions of `derive.vectors` from which
kernels are lowered. Each names the kernels and the methods of the runtime in which it ends, as objects; tests put
numbers into `Law.equations` and compare with these.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.chain import Chain
from deltacal_gen.machine.limbs import Limbs
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.reading import reading_shift
from derive import blocks, closed_form, statics, vectors
from derive.graph import Graph
from derive.language.targets import ON
from derive.review import typeset as ts
from derive.review.sources import Place, in_template, of_function
from derive.review.typeset import Math, Shown
from derive.review.written import ROTATIONS, rotation_name

End = str | Callable[..., Any]  # name of a generated function, or a function of the runtime


@dataclass(frozen=True)
class Law:
    """A formula that SymPy made, in words, where it is made and where it ends.

    Attributes
    ----------
    equations : tuple of (left, right)
        As SymPy has them: what a test evaluates.
    formula : Math
        The same, typeset.
    """

    text: str
    equations: tuple[tuple[sp.Basic, sp.Basic], ...]
    formula: Math
    place: Place | None = None
    ends: tuple[End, ...] = ()


def law(
    text: str,
    *equations: tuple[sp.Basic, sp.Basic],
    place: Place | None = None,
    ends: Sequence[End] = (),
    look: Shown = lambda s: None,
) -> Law:
    """Return equations as a law."""
    sides = [ts.equation(ts.expression(left, look), ts.expression(right, look)) for left, right in equations]
    return Law(text, equations, ts.separated(sides), place, tuple(ends))


class Linear(dict[sp.MatrixSymbol, sp.MatrixExpr]):
    """A linear relation: differential to the matrix before it, in the order in which a reader sees them."""

    @property
    def total(self) -> sp.MatrixExpr:
        """The sum of the products."""
        products = [matrix * d for d, matrix in self.items()]
        return products[0] if len(products) == 1 else sp.MatAdd(*products)

    def solved(self, unknown: sp.MatrixSymbol) -> Linear:
        """Return `unknown` in terms of the others, where the relation is zero."""
        return Linear({d: -(self[unknown].I * matrix) for d, matrix in self.items() if d != unknown})

    def where(self, d: sp.MatrixSymbol, means: Linear) -> Linear:
        """Return the relation with a differential replaced by what it is in terms of others."""
        put = {e: self[d] * matrix for e, matrix in means.items()}
        found = Linear({e: matrix for e, matrix in self.items() if e != d})
        for e, matrix in put.items():
            found[e] = sp.MatAdd(found[e], matrix) if e in found else matrix
        return found


# what laws are about; sizes are symbols too
_f, _q, _p, _r = sp.symbols("n_f n_q n_p n_r", integer=True, positive=True)
SIZES = {"x": _f, "q": _q, "p": _p}  # as many coordinates x as closures
d = {v: sp.MatrixSymbol(f"d {v}", n, 1) for v, n in SIZES.items()}
J = {v: sp.MatrixSymbol(f"J_{v}", _f, n) for v, n in SIZES.items()}
S, V = sp.MatrixSymbol("S", _f, _p), sp.MatrixSymbol("V", _f, _q)
mu, tau, load = sp.MatrixSymbol("mu", _f, 1), sp.MatrixSymbol("tau", _q, 1), sp.MatrixSymbol("f_p", _p, 1)
weights, points = sp.MatrixSymbol("G", _r, 1), {v: sp.MatrixSymbol(f"∂r/∂{v}", _r, n) for v, n in SIZES.items()}
W = {v: sp.MatrixSymbol(f"W_{v}", n, 1) for v, n in SIZES.items()}
CLOSURES = Linear({d[v]: J[v] for v in SIZES})  # the closures' total differential
MOTION = CLOSURES.solved(d["x"])


def implicit(turns: bool, closed_at: Place) -> list[Law]:
    """Return the implicit function theorem on the closures, which every machine of limbs goes through."""
    zero = sp.ZeroMatrix(_f, 1)
    F = sp.Function("F")(*(sp.Symbol(v) for v in SIZES))
    bold = {sp.Symbol(v): ts.vector(v) for v in SIZES}

    def look(s: sp.Expr) -> Math | None:
        if s == F:
            return ts.row(ts.vector("F"), ts.brackets(ts.separated(bold.values())))
        return bold.get(s)

    found = [
        law(
            "All closures of all limbs together, with as many equations as coordinates in x.",
            (F, zero),
            place=closed_at,
            ends=["newton"],
            look=look,
        ),
        law(
            "Built on the graph of the steps above: one sweep backwards from each closure.",
            *((J[v], sp.MatrixSymbol(f"∂F/∂{v}", *J[v].shape)) for v in SIZES),
            place=of_function(Graph.derivatives),
            ends=["newton", "parameters", "jacobians"],
        ),
        law("On the machine the closures stay zero.", (CLOSURES.total, zero), ends=["jacobians"]),
        law(
            "The implicit function theorem: where the first matrix is regular,",
            (d["x"], Linear({d["p"]: S, d["q"]: V}).total),
            ends=["sensitivity"],
        ),
        law(
            "with the sensitivity S by the errors and the velocity Jacobian V by the joints.",
            (S, MOTION[d["p"]]),
            (V, MOTION[d["q"]]),
            place=in_template("templates/mechanism/vectorised.py.jinja", "def sensitivity"),
            ends=["sensitivity"],
        ),
    ]
    if turns:
        K, s, look_c = _of_vector("c")
        phi, c = (sp.MatrixSymbol(f"d {name}", 3, 1) for name in ("phi", "c"))
        text = "A change of the Cayley vector as a turn about the axes of {O}, which is what the sensitivities give."
        at = of_function(blocks.turn_by_change)
        found.append(law(text, (phi, vectors.turn_by_cayley(K, s) * c), place=at, ends=["spin"], look=look_c))
    return found


def _of_vector(name: str) -> tuple[sp.MatrixSymbol, sp.Symbol, Shown]:
    """Return the matrix of the cross product with a vector, its squared length, and how they are shown."""
    K, s = sp.MatrixSymbol(f"[{name}]", 3, 3), sp.Symbol(f"{name}.{name}", nonnegative=True)
    squared = ts.sup(ts.brackets(ts.vector(name), "||"), ts.number(2))
    return K, s, lambda e: squared if e == s else None


def virtual_work(deflections: bool) -> list[Law]:
    """Return what weights exert on the joints, by virtual work on the closures.

    The weights do work along their points, the multipliers of the closures along the closures: what stands before a
    differential is the load on that coordinate, and the platform carries none.
    """
    work = Linear({d[v]: (points[v].T * weights).T for v in ("q", "x")})
    named = Linear({by: W[v].T for v, by in d.items() if by in work})
    held = Linear({d[v]: mu.T * J[v] for v in SIZES})
    exerted = {v: _transposed(_sum(named.get(d[v]), held[d[v]])) for v in SIZES}
    balance = Linear({mu: J["x"].T, W["x"]: sp.Identity(_f)})
    assert (exerted["x"] - balance.total).doit() == sp.ZeroMatrix(_f, 1)
    found = [
        law(
            "Generalised loads of the weights listed below: r are the points of all of them, G their weights m g.",
            *((W[v], work[d[v]].T.doit()) for v in ("q", "x")),
            place=of_function(statics.loads),
            ends=["limb", "platform"],
        ),
        law(
            "Equilibrium of the platform gives the multipliers of the closures.",
            (mu, balance.solved(mu).total.doit()),
            ends=[Limbs.loads],
        ),
        law(
            "What the loads exert on each joint, positive along its positive direction.",
            (tau, exerted["q"]),
            ends=[Limbs.loads],
        ),
    ]
    if deflections:
        text = "The load conjugate to an error or deflection p: the pull on an arm's tip, the tension of a rod."
        found.append(law(text, (load, exerted["p"]), ends=[Limbs.loads]))
    return found


def _sum(*terms: sp.MatrixExpr | None) -> sp.MatrixExpr:
    some = [term for term in terms if term is not None]
    return some[0] if len(some) == 1 else sp.MatAdd(*some)


def _transposed(e: sp.MatrixExpr) -> sp.MatrixExpr:
    """Return the transpose, the terms of a sum in their order."""
    return sp.MatAdd(*(_transposed(term) for term in e.args)) if isinstance(e, sp.MatAdd) else e.T.doit()


def sphere() -> Law:
    """Return the closure of a simplified limb as a sphere in the position."""
    P, c = (sp.MatrixSymbol(name, 3, 1) for name in "Pc")
    constant = sp.MatrixSymbol("d", 1, 1)
    left = closed_form.as_sphere(P, c, constant)
    look = {constant: ts.letter("d")}
    return law("", (left, sp.ZeroMatrix(1, 1)), place=of_function(closed_form.sphere), look=look.get)


# ------------------------------------------------------------------------------------------------------------- chains


def carried() -> tuple[sp.MatrixExpr, sp.MatrixExpr]:
    """Return the loads of all that a joint moves, conjugate to its twist: the force F, and the moment about p.

    A weight f at r does the work ``f . (s + w x (r - p))`` where the joint shifts its link's end p by s and turns it by
    w. What it exerts is linear in f and in its moment about {O}, ``r x f``, so that weights add up to one force F and
    one moment M.
    """
    f, F, M = (sp.MatrixSymbol(name, 3, 1) for name in "fFM")
    s, w = (sp.MatrixSymbol(f"d {name}", 3, 1) for name in "sw")
    r, p = (sp.MatrixSymbol(f"{name} ×", 3, 3) for name in "rp")
    work = Linear({s: f.T, w: sp.MatAdd(-(f.T * r), f.T * p)})  # w x r = -r x w
    skew = {r.T: -r, p.T: -p}
    force, moment = (_transposed(work[by]).xreplace(skew).doit() for by in (s, w))
    return force.xreplace({f: F}), moment.xreplace({r * f: M}).xreplace({f: F})


def weights_of_links() -> list[Law]:
    """Return what weights exert on the joints of a chain, by virtual work: from the last link to the first."""
    n = sp.Symbol("n_t", integer=True, positive=True)
    by_links, links = sp.MatrixSymbol("∂r/∂theta", _r, n), sp.MatrixSymbol("∂theta/∂q", n, _q)
    theta = sp.MatrixSymbol("d theta", n, 1)
    work = Linear({theta: weights.T * by_links}).where(theta, Linear({d["q"]: links}))
    names_of = ("r_j", "p_j", "c_j", "F_j", "M_j", "F_k", "M_k", "F_t", "M_t", "g")
    one = {name: sp.MatrixSymbol(name, 3, 1) for name in names_of}
    m, payload, R = sp.Symbol("m_j"), sp.Symbol("m_payload"), sp.MatrixSymbol("R_j", 3, 3)
    cross = {name: sp.MatrixSymbol(f"{name} ×", 3, 3) for name in ("r_j", "P")}
    behind, last = (ts.row(ts.letter(index), ts.op("+"), ts.number(1)) for index in "jn")
    names = {one[f"{v}_{k}"]: ts.sub(ts.vector(v), index) for v in "FM" for k, index in (("k", behind), ("t", last))}
    force, moment = carried()
    twist = [sp.MatrixSymbol(name, 3, 1) for name in "sw"]
    by_link = sp.MatrixSymbol("∂W/∂theta_j", 1, 1)
    names[by_link] = ts.partial(ts.letter("W"), ts.sub(ts.letter("theta"), ts.letter("j")))
    return [
        law(
            "Virtual work of each link's weight at its centre of mass and of the payload at the tool point: r are all "
            "these points, G the weights m g, and θ what each link's frame takes part in: its own joint's variable, "
            "or that of the joint to which it is coupled.",
            (tau, work[d["q"]].T.doit()),
            ends=[Chain.loads],
        ),
        law(
            "The centre of mass of link j: origin and rotation of its frame in {O}, and where in it the robot file "
            "says the mass lies.",
            (one["r_j"], sp.MatAdd(one["p_j"], R * one["c_j"])),
            ends=[Chain.weights_at],
        ),
        law(
            "Force and moment about {O} of all that a link carries: the payload, then link by link towards the base.",
            (one["F_t"], payload * one["g"]),
            (one["M_t"], payload * (cross["P"] * one["g"])),
            (one["F_j"], sp.MatAdd(one["F_k"], m * one["g"])),
            (one["M_j"], sp.MatAdd(one["M_k"], m * (cross["r_j"] * one["g"]))),
            look=names.get,
        ),
        law(
            "A joint moves all behind it as a rigid body, by the twist of its link given above: shift s of the link's "
            "end p, and turn w.",
            (by_link, sp.MatAdd(*(v.T * load for v, load in zip(twist, (force, moment), strict=True)))),
            ends=[Chain.loads],
            look=names.get,
        ),
    ]


# ------------------------------------------------------------------------------------------------------------ effects


def reaches(targets: Iterable[str], *, loaded: bool) -> list[Law]:
    """Return how targets of an effect reach a reading: the chain rule through a machine's own derivatives."""
    kinds = {target.partition(".")[0] for target in targets}
    one, three = sp.Integer(1), sp.Integer(3)

    c, names = ts.letter("c"), {}

    def by(of: str, shown: Math, rows: sp.Expr = three) -> sp.MatrixSymbol:
        symbol = sp.MatrixSymbol(f"∂{of}/∂c", rows, one)
        names[symbol] = ts.partial(shown, c)
        return symbol

    def moved(title: str, rows: sp.Expr = three) -> sp.MatrixSymbol:
        return by(f"Δ{title}", ts.row(ts.letter("Δ"), ts.words(title)), rows)

    of_part = sp.MatrixSymbol("∂p/∂part", _p, one)
    names[of_part] = ts.partial(ts.vector("p"), ts.words("part"))
    change = {d["q"]: moved("joint", _q), d["p"]: of_part * moved("limb.part", one)}
    parts = {"joint": d["q"], "limb": d["p"]}
    by_pose = Linear({d["q"]: V, d["p"]: S})
    terms = [by_pose[parts[k]] * change[parts[k]] for k in parts if k in kinds]
    terms += [matrix * moved(kind) for kind, matrix in displaced().items() if kind in kinds]
    x, y = by("x", ts.vector("x"), _f), by("y", ts.vector("y"))
    found = []
    if terms:
        text = "The pose moves by the machine's velocity Jacobian V and sensitivity S at the deformed pose."
        if loaded:
            text += " Loads are those of the deformed machine, found by iteration to static equilibrium."
        found.append(law(text, (x, _sum(*terms)), ends=[Body.columns], look=names.get))
        text = "The reading moves with the pose, as the instrument sees it."
        reading = sp.MatrixSymbol("∂y/∂x", three, _f) * x
        found.append(law(text, (y, reading), ends=[Instrument.linearise], look=names.get))
    if any(ON[kind] == "reading" for kind in kinds):
        text = "It acts on the reading itself; no pose and no command changes."
        found.append(law(text, (y, moved("reading")), ends=[reading_shift], look=names.get))
    return found


@cache  # nothing changes it, and SymPy takes a tenth of a second for it
def displaced() -> dict[str, sp.MatrixExpr]:
    """Return how the measured point moves with a turn of the base and with a shift of the tool, at zero.

    The point is ``cay(turn) (P + R tool)``; its derivatives are read as what they are made of.
    """
    turn, tool, P = (sp.Matrix(sp.symbols(f"{n}_x {n}_y {n}_z", real=True)) for n in ("turn", "tool", "P"))
    R = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"R_{i + 1}{j + 1}", real=True))
    known = {"P ×": (vectors.skew(P), sp.MatrixSymbol("P ×", 3, 3)), "R": (R, sp.MatrixSymbol("R", 3, 3))}
    point = vectors.cayley(turn) * (P + R * tool)
    zero = dict.fromkeys((*turn, *tool), 0)
    found = {}
    for kind, by in (("turn", turn), ("tool", tool)):
        slope = point.jacobian(by).subs(zero)
        found[kind] = next(s * symbol for entries, symbol in known.values() for s in (1, -1) if slope == s * entries)
    return found


# ---------------------------------------------------------------------------------------------------------- rotations


def rotations_used(short: Iterable[str]) -> list[tuple[Law, Law]]:
    """Return the definition and the differential of each rotation, from the functions that kernels are made of."""
    return [_turned(name) if name.startswith("R_") else _by_vector(name) for name in short]


def _made(short: str) -> Callable[..., sp.Matrix]:
    made: Callable[..., sp.Matrix] = getattr(vectors.EXACT, next(n for n, s in ROTATIONS.items() if s == short))
    return made


def _by_vector(short: str) -> tuple[Law, Law]:
    """Return the rotation by a vector v, or c: its formula in terms of the cross product, and the chain rule."""
    of = {"exp": "v", "cay": "c"}[short]
    K, s, look = _of_vector(of)
    head = ts.row(ts.letter(short), ts.brackets(ts.vector(of)))
    if short == "exp":
        right, text = vectors.about(K, *vectors.RODRIGUES), "Both factors stand as Taylor polynomials in t²"
        text += ", so that value and derivatives are smooth at zero."
        angle = ts.equation(ts.expression(vectors.ANGLE), ts.brackets(ts.vector(of), "||"))
        formula = ts.row(ts.equation(head, ts.expression(right)), ts.op(","), ts.gap(), angle)
    else:
        right = vectors.by_cayley(K, s)
        text = "Rational in its argument, and equal to the rotation by that vector to second order."
        formula = ts.equation(head, ts.expression(right, look))
    entry, change = sp.Symbol(f"{of}_k"), sp.Symbol(f"d {of}_k")
    slope = sp.Derivative(sp.Function(short)(sp.Symbol(of)), entry, evaluate=False)
    shown = {change: ts.row(ts.words("d"), ts.expression(entry))}
    total = ts.expression(sp.Sum(slope * change, (sp.Symbol("k"), 1, 3)), shown.get)
    at = of_function(_made(short))
    law_ = Law(text, ((sp.Symbol(short), right),), formula, at)
    return law_, Law("", (), ts.equation(ts.row(ts.words("d"), head), total), at)


def _turned(short: str) -> tuple[Law, Law]:
    """Return the rotation about an axis, entry by entry, and its differential."""
    t, at = sp.Symbol("t", real=True), of_function(_made(short))
    R = _made(short)(t)
    head = ts.row(rotation_name(short), ts.brackets(ts.letter("t")))
    moved = ts.row(entries(sp.diff(R, t)), ts.words("d"), ts.letter("t"))
    law_ = Law("", ((sp.Symbol(short), R),), ts.equation(head, entries(R)), at)
    return law_, Law("", (), ts.equation(ts.row(ts.words("d"), head), moved), at)


def entries(M: sp.Matrix, symbols: Shown = lambda s: None) -> Math:
    """Return a matrix entry by entry."""
    return ts.matrix([[ts.expression(e, symbols) for e in M.row(i)] for i in range(M.rows)])
