r"""Which errors no reading sees, in closed form: the null space of the first-order closure over all poses at once.

Where the simplified limb is a sphere about ``c(q)`` (see `closed_form`), every pose of every limb is
``P = c(q) + rho n`` with a free joint q and a free unit vector n. Errors v, together with a motion of the frame in
which the instrument reads (shift t, turn w) and a turn k + m P of the platform that it does not read, are not seen if
the closure's first-order change vanishes at all of them::

    J_p v + J_x (t + w x P, k + m P) = 0        for all q and n

That is a polynomial in cos q, sin q (or q) and n; each of its coefficients, modulo ``cos^2 + sin^2 = n.n = 1``, is a
linear equation in v, t, w, k and m over the field of the geometry's symbols. No pose is chosen and no tolerance either.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import sympy as sp

from derive import closed_form, vectors
from derive.first_order import first_order
from derive.graph import expand_steps
from derive.spec import ChainMechanism, LimbMechanism

Numbers = Mapping[str, Sequence[float]]


def exact_angle(value: float) -> sp.Expr | None:
    """Return an angle as a rational multiple of pi with a denominator up to 36, or None."""
    ratio = sp.Rational(str(round(value / float(sp.pi), 12))).limit_denominator(36)
    return ratio * sp.pi if abs(float(ratio * sp.pi) - value) < 1e-9 else None


def _limb_values(mechanism: LimbMechanism, limb: int, numbers: Numbers) -> dict[sp.Symbol, sp.Expr] | None:
    """Return what is put for a limb's geometry: exact angles and sides; lengths stay symbols, of the limb if theirs."""
    found: dict[sp.Symbol, sp.Expr] = {}
    for entry in mechanism.geometry:
        symbol, given = entry.quantity.symbol, numbers[entry.key]
        own = given[limb - 1] if entry.per_limb else given[0]
        if entry.quantity.unit == "rad":
            angle = exact_angle(own)
            if angle is None:
                return None
            found[symbol] = angle
        elif entry.quantity.unit == "1":
            found[symbol] = sp.nsimplify(own)
        elif entry.per_limb and len(set(given)) > 1:
            found[symbol] = sp.Symbol(f"{symbol}_{limb}", positive=True)
        else:
            found[symbol] = sp.Symbol(str(symbol), positive=True)
    return found


def equations(
    mechanism: LimbMechanism, numbers: Numbers
) -> tuple[list[sp.Symbol], list[sp.Symbol], list[sp.Expr]] | None:
    """Return the unknown errors, the unknown motions and the linear equations they obey.

    None where the simplified limb is no sphere and the platform does not stay parallel either.

    Parameters
    ----------
    numbers : mapping
        Key of the robot file to the limbs' values [mm, rad]: which angles the limbs stand at, which lengths are equal.
    """
    try:
        centre, constant = closed_form.sphere(mechanism)
    except ValueError:
        return _parallel_equations(mechanism, numbers)
    dimension = mechanism.commanded
    steps, rates = first_order(mechanism)
    position = [quantity.symbol for quantity in mechanism.platform[:dimension]]
    turning = [quantity.symbol for quantity in mechanism.platform[dimension:]]
    q = mechanism.joint.symbol
    gone = dict.fromkeys((*(s.symbol for s in mechanism.deflections), *(s.symbol for s in mechanism.tool)), 0)
    nominal = dict.fromkeys((s.symbol for s in mechanism.varied), 0)
    n = sp.symbols("n_x n_y n_z", real=True)[:dimension]
    cos, sin = sp.symbols("cos sin", real=True)
    shift = sp.Matrix(sp.symbols("t_x t_y t_z", real=True)[:dimension])
    w = sp.Matrix(sp.symbols("w_x w_y w_z", real=True))
    k = [sp.Symbol(f"k_{s.name[1:]}", real=True) for s in turning]
    m = sp.Symbol("m", real=True)
    names = {quantity.symbol: sp.Symbol(quantity.name) for quantity in mechanism.common}
    closures = [
        (
            expand_steps(rate.get("errors", sp.Integer(0)), steps).xreplace(gone),
            [expand_steps(rate.get(str(s), sp.Integer(0)), steps).xreplace(gone) for s in turning],
        )
        for rate in rates
    ]
    found: list[sp.Expr] = []
    for limb in range(1, mechanism.limbs + 1):
        values = _limb_values(mechanism, limb, numbers)
        if values is None:
            return None
        at = centre.subs(nominal | gone).subs(values)
        square = sp.expand(sp.expand(at.dot(at) - 2 * constant.subs(nominal | gone).subs(values), trig=True))
        rho = sp.sqrt(sp.factor(sp.trigsimp(square)))
        P = at + rho * sp.Matrix(n)
        where = dict(zip(position, P, strict=True))
        flat = w[2] * sp.Matrix([-P[1], P[0]]) if dimension == 2 else sp.zeros(dimension, 1)
        moved = shift + (w.cross(P) if dimension == 3 else flat)
        own = {e.symbol: sp.Symbol(e.name_of(limb)) for e in mechanism.errors} | names
        for errors, turns in closures:
            change = errors.xreplace(values).xreplace(where).xreplace(own) + rho * sp.Matrix(n).dot(moved)
            by = [j.xreplace(values).xreplace(where) for j in turns]
            turned = [c + (m * P[j] if len(k) == 3 else 0) for j, c in enumerate(k)]
            change += sum(slope * turn for slope, turn in zip(by, turned, strict=True))
            change = sp.expand(sp.expand(change, trig=True).subs({sp.cos(q): cos, sp.sin(q): sin}))
            free = (cos, sin, *n) if change.has(cos) or change.has(sin) else (q, *n)
            found += _coefficients(change, free, {n[-1]: 1 - sum(e**2 for e in n[:-1]), sin: 1 - cos**2})
    every = [sp.Symbol(name) for name in mechanism.parameter_names]
    used = set().union(*(e.free_symbols for e in found))
    motions = [s for s in (*shift, *w, *k, m) if s in used]
    return every, motions, found


def _parallel_equations(
    mechanism: LimbMechanism, numbers: Numbers
) -> tuple[list[sp.Symbol], list[sp.Symbol], list[sp.Expr]] | None:
    """Return the same of a machine in the plane with one joint, whose nominal platform keeps its direction.

    Dimensions that are equal in the robot file are one symbol, as a parallelogram asks for. The platform's turn, which
    a point does not show, is then k + m.P: the closures make it a polynomial of first degree in cos q and sin q.
    """
    if mechanism.limbs > 1 or len(mechanism.platform) != 3:
        return None
    seen: dict[float, sp.Symbol] = {0.0: sp.Integer(0)}
    values = {e.quantity.symbol: numbers[e.key][0] for e in mechanism.geometry}
    put: dict[sp.Symbol, sp.Expr] = {s: seen.setdefault(v, sp.Symbol(str(s), positive=True)) for s, v in values.items()}
    gone = dict.fromkeys(
        (*(s.symbol for s in mechanism.deflections), *(s.symbol for s in mechanism.tool)), sp.Integer(0)
    )
    nominal = dict.fromkeys((s.symbol for s in mechanism.varied), sp.Integer(0))
    px, py, cz = (quantity.symbol for quantity in mechanism.platform)
    closures = [expand_steps(e, mechanism.steps).subs(gone).subs(put) for e in mechanism.loop_closure]
    parallel = [e.subs(nominal).subs(cz, 0) for e in closures]
    linear = [e for e in parallel if e.has(px, py) and sp.Poly(e, px, py).total_degree() == 1]
    where = sp.solve(linear, (px, py), dict=True) if len(linear) == 2 else []
    if not where or any(sp.simplify(e.subs(where[0])) != 0 for e in parallel):
        return None
    P = sp.Matrix([where[0][px], where[0][py]])
    t_x, t_y, w, k, m_x, m_y = motions = list(sp.symbols("t_x t_y w_z k_z m_x m_y", real=True))
    moved = {px: t_x - w * P[1], py: t_y + w * P[0], cz: k + m_x * P[0] + m_y * P[1]}
    moved |= {s.symbol: sp.Symbol(s.name) for s in mechanism.varied if s.symbol not in gone}
    changes = [
        sum((sp.diff(e, s) * much for s, much in moved.items()), sp.Integer(0)).subs(nominal).subs({cz: 0, **where[0]})
        for e in closures
    ]
    return [sp.Symbol(name) for name in mechanism.parameter_names], motions, _trigonometric(changes)


def chain_equations(
    mechanism: ChainMechanism, links: Sequence[Mapping[str, Any]], tool: Sequence[float], *, point: bool
) -> tuple[list[sp.Symbol], list[sp.Symbol], list[sp.Expr]] | None:
    """Return the unknown errors, the unknown motions and the linear equations they obey; None where joints are coupled.

    Errors of a chain are unseen where they hand a constant twist (s, v) from frame to frame: with p the end of link k
    in the frame before it, R its rotation and E the twists by its errors,

        E errors + (s + v x p, v) of frame k - 1  =  (R s, R v) of frame k        for every q_k

    It begins with a motion (t, w) of the instrument's frame. It ends, where the body is seen, with a turn k of the body
    that the instrument may not know. Where only a point is seen, the last links need not hand on a twist but keep the
    point: those after which it no longer moves, in the frame behind them.

    Parameters
    ----------
    links : sequence of mapping
        ``kind``, ``convention``, a, d [mm], alpha and theta [rad] of each link, from the base.
    tool : (3,) sequence of float
        The tool point in the last frame [mm].
    point : bool
        Whether only the tool point is seen, not the body's rotation.
    """
    frames = [_nominal_link(mechanism, link, k) for k, link in enumerate(links, start=1)]
    if any(frame is None for frame in frames):
        return None
    at = sp.Matrix([_length(f"tool_{axis}", e) for axis, e in zip("xyz", tool, strict=True)])
    tool_errors = sp.Matrix(sp.symbols("tx ty tz"))
    shift, turned = (sp.Matrix(sp.symbols(f"{name}_x {name}_y {name}_z", real=True)) for name in "tw")
    errors, motions, found = [], [*shift, *turned], []
    held = len(frames)  # links that hand on a twist
    if point:
        seen = at
        while held and not (seen := _behind(frames[held - 1], seen)).has(sp.cos, sp.sin, *_SLIDES):
            held -= 1
        held -= held > 0
    for k, frame in enumerate(frames, start=1):
        assert frame is not None
        R, p, twists = frame
        moved, rate = shift + turned.cross(p), turned
        for name, twist in twists.items():
            errors.append(sp.Symbol(f"{name}_{k}"))
            moved, rate = moved + errors[-1] * twist[:3, :], rate + errors[-1] * twist[3:, :]
        if k <= held and k < len(frames):
            shift, turned = (sp.Matrix(sp.symbols(f"{n}{k}_x {n}{k}_y {n}{k}_z", real=True)) for n in "sv")
            motions += [*shift, *turned]
        elif k <= held:
            turned = sp.Matrix(sp.symbols("k_x k_y k_z", real=True))
            shift = -turned.cross(at) - tool_errors
            motions += [*turned]
        else:  # along with the frame, into whose axes it is turned
            shift, turned = R.T * moved, R.T * rate
            continue
        found += _trigonometric([*(moved - R * shift), *(rate - R * turned)])
    if held < len(frames):
        found += _trigonometric(shift + turned.cross(at) + tool_errors)
    return [*errors, *tool_errors], motions, found


_Frame = tuple[sp.Matrix, sp.Matrix, dict[str, sp.Matrix]]
_SLIDES = sp.symbols("slide_1:20", real=True)


def _nominal_link(mechanism: ChainMechanism, link: Mapping[str, Any], k: int) -> _Frame | None:
    """Return rotation and end of link k at any joint, and the twist by each error; None where an angle is not exact."""
    alpha, theta = exact_angle(link["alpha"]), exact_angle(link["theta"])
    turns = link["kind"] == "revolute"
    if link["kind"] == "coupled" or alpha is None or (theta is None and not turns):
        return None
    given = {"a": _length(f"a_{k}", link["a"]), "d": _length(f"d_{k}", link["d"]), "alpha": alpha, "theta": theta}
    by_turn, by_slide = (v.symbol for v in mechanism.joint)
    nominal: dict[sp.Expr, sp.Expr] = dict.fromkeys((e.symbol for e in mechanism.errors), sp.Integer(0))
    nominal |= {g.quantity.symbol: given[g.key] for g in mechanism.geometry}
    nominal |= {by_turn: sp.Integer(0), by_slide: _SLIDES[k - 1] if link["kind"] == "prismatic" else sp.Integer(0)}
    if turns:  # any angle: what is added to the reading plays no part
        nominal |= {by_turn: sp.Symbol(f"q_{k}", real=True)}
        nominal |= {g.quantity.symbol: sp.Integer(0) for g in mechanism.geometry if g.key == "theta"}
    put = [(s, e.subs(nominal)) for s, e in mechanism.steps]
    R, p, twists = vectors.follow(mechanism.transforms[link["convention"]])
    by = {
        e.name: sum((sp.diff(w, e.symbol) * twists[s] for s, w in mechanism.steps), sp.zeros(6, 1))
        for e in mechanism.errors
    }
    return R.subs(put), p.subs(put), {name: twist.subs(put) for name, twist in by.items()}


def _behind(frame: _Frame | None, point: sp.Matrix) -> sp.Matrix:
    """Return a point of a link's frame in the frame before the link."""
    assert frame is not None
    return (frame[1] + frame[0] * point).applyfunc(lambda e: sp.simplify(sp.expand(e)))


def _trigonometric(changes: Iterable[sp.Expr]) -> list[sp.Expr]:
    """Return the coefficients of expressions that vanish for all joints q_k, or slides."""
    found = []
    for change in changes:
        change = sp.expand(sp.expand(change, trig=True))
        angles = sorted({f.args[0] for f in change.atoms(sp.cos, sp.sin)}, key=str)
        pairs = [(sp.cos(q), sp.sin(q), *sp.symbols(f"cos_{q} sin_{q}", real=True)) for q in angles]
        put = {f: s for cos, sin, c, s_ in pairs for f, s in ((cos, c), (sin, s_))}
        free = [s for _, _, c, s_ in pairs for s in (c, s_)] + [s for s in _SLIDES if change.has(s)]
        if change != 0:
            found += _coefficients(change.subs(put), free or [_SLIDES[-1]], {s_: 1 - c**2 for _, _, c, s_ in pairs})
    return found


def _length(name: str, value: float) -> sp.Expr:
    return sp.Symbol(name, real=True) if value else sp.Integer(0)


def _coefficients(change: sp.Expr, free: Sequence[sp.Symbol], squares: Mapping[sp.Symbol, sp.Expr]) -> list[sp.Expr]:
    """Return the coefficients of a polynomial in the free variables, whose squares obey a relation."""
    reduced: dict[tuple[int, ...], sp.Expr] = {}
    todo = list(sp.Poly(change, *free).terms())
    while todo:
        powers, coefficient = todo.pop()
        place = next((j for j, s in enumerate(free) if powers[j] >= 2 and s in squares), None)
        if place is None:
            reduced[powers] = reduced.get(powers, sp.Integer(0)) + coefficient
            continue
        rest = sp.Integer(1)
        for j, s in enumerate(free):
            rest *= s ** (powers[j] - 2 * (j == place))
        todo += sp.Poly(coefficient * rest * squares[free[place]], *free).terms()
    return [e for c in reduced.values() if (e := sp.expand(c)) != 0]


class _Number:
    """``a + b sqrt(d)`` with a, b rational functions of the geometry: what angles of 30 or 45 deg leave."""

    __slots__ = ("a", "b", "d")

    def __init__(self, a: Any, b: Any, d: int) -> None:
        self.a, self.b, self.d = a, b, d

    def __bool__(self) -> bool:
        return bool(self.a or self.b)

    def __sub__(self, other: _Number) -> _Number:
        return _Number(self.a - other.a, self.b - other.b, self.d)

    def __mul__(self, other: _Number) -> _Number:
        a = self.a * other.a + (self.b * other.b * self.d if self.b and other.b else 0)
        return _Number(a, self.a * other.b + self.b * other.a, self.d)

    def __truediv__(self, other: _Number) -> _Number:
        if not other.b:
            return _Number(self.a / other.a, self.b / other.a, self.d)
        norm = other.a**2 - other.b**2 * self.d
        return self * _Number(other.a / norm, -other.b / norm, self.d)

    @property
    def size(self) -> int:
        """How long it is."""
        return sum(len(e.numer.terms()) + len(e.denom.terms()) for e in (self.a, self.b) if e)


_Row = dict[int, _Number]


class NullSpace:
    """All errors and motions that the equations allow; models and instruments are parts of it.

    Exact elimination, once; equations are short, and pivots are taken where they stay so.

    Parameters
    ----------
    errors, motions, found
        Of `equations`.

    Raises
    ------
    ValueError
        More than one square root occurs.
    """

    def __init__(self, errors: Sequence[sp.Symbol], motions: Sequence[sp.Symbol], found: Sequence[sp.Expr]) -> None:
        self._columns = {s: j for j, s in enumerate((*motions, *errors))}
        self._first = len(motions)
        halves = {r for e in found for r in e.atoms(sp.Pow) if r.exp.is_Rational and r.exp.q == 2}
        lengths = sorted({r.base for r in halves if not r.base.is_Integer}, key=str)  # their roots are lengths too
        named = {base: sp.Symbol(f"root_{j}", positive=True) for j, base in enumerate(lengths)}
        found = [e.xreplace({r: named[r.base] ** (2 * r.exp) for r in halves if r.base in named}) for e in found]
        roots = {sp.sqrt(r.base) for r in halves if r.base.is_Integer}
        if len(roots) > 1:
            raise ValueError("more than one square root occurs.")
        self._root = next(iter(roots), sp.Integer(1))
        self._back = {s: sp.sqrt(base) for base, s in named.items()}
        symbols = sorted(set().union(*(e.free_symbols for e in found)) - set(self._columns), key=str)
        self._field = sp.QQ.frac_field(*symbols) if symbols else sp.QQ.frac_field(sp.Symbol("one"))
        rows = []
        for e in found:
            slopes = {s: sp.diff(e, s) for s in e.free_symbols if s in self._columns}
            rows.append({self._columns[s]: n for s, slope in slopes.items() if (n := self._number(slope))})
        self._basis = self._solutions(_eliminated(rows, self._first), len(self._columns))

    def _number(self, e: sp.Expr) -> _Number:
        mark = sp.Symbol("root")
        e = sp.expand(e).subs(self._root, mark) if self._root != 1 else e
        a, b = (self._field.from_sympy(e.coeff(mark, n)) for n in (0, 1))
        return _Number(a, b, int(self._root**2))

    def _solutions(self, solved: dict[int, _Row], count: int) -> list[_Row]:
        """Return a basis of what solved equations in `count` unknowns leave free."""
        zero, one = (_Number(n, self._field.zero, int(self._root**2)) for n in (self._field.zero, self._field.one))
        basis: list[_Row] = []
        for free in (j for j in range(count) if j not in solved):
            basis.append({j: zero - row[free] for j, row in solved.items() if free in row} | {free: one})
        return basis

    def of(
        self, errors: Sequence[sp.Symbol], motions: Sequence[sp.Symbol], tied: Mapping[sp.Symbol, sp.Symbol]
    ) -> list[dict[str, sp.Expr]]:
        """Return a basis of the errors of a model that some of the motions make invisible.

        Motions that are `tied` to others are equal to them; all other unknowns are zero.
        """
        free = {*errors, *motions, *tied}
        conditions: list[_Row] = []
        for s, j in self._columns.items():
            if s not in free:
                conditions.append({n: row[j] for n, row in enumerate(self._basis) if j in row})
        for s, to in tied.items():
            left, right = self._columns[s], self._columns[to]
            both = [(n, row.get(left), row.get(right)) for n, row in enumerate(self._basis)]
            zero = _Number(self._field.zero, self._field.zero, int(self._root**2))
            conditions.append({n: e for n, a, b in both if (e := (a or zero) - (b or zero))})
        kept = self._solutions(_eliminated(conditions, 0), len(self._basis))
        vectors = []
        for combination in kept:
            vector: _Row = {}
            for n, much in combination.items():
                vector = _plus(vector, much, self._basis[n])
            vectors.append({j: e for j, e in vector.items() if j >= self._first})
        names = list(self._columns)
        return [
            {str(names[j]): self._expression(value) for j, value in sorted(row.items())}
            for row in _eliminated(vectors, 0).values()
        ]

    def _expression(self, value: _Number) -> sp.Expr:
        a, b = self._field.to_sympy(value.a), self._field.to_sympy(value.b)
        return (a + b * self._root).xreplace(self._back)


def _plus(row: _Row, much: _Number, other: _Row) -> _Row:
    """Return a row and so much of another one."""
    out = dict(row)
    zero = much - much
    for j, value in other.items():
        out[j] = out.get(j, zero) - (zero - much) * value
    return {j: value for j, value in out.items() if value}


def _eliminated(rows: list[_Row], first: int) -> dict[int, _Row]:
    """Return the rows solved for one column each; columns before `first` are solved for where they can be."""
    todo = [row for row in rows if row]
    solved: dict[int, _Row] = {}
    while todo:
        pick = min(
            ((j >= first, len(row), value.size, j, n) for n, row in enumerate(todo) for j, value in row.items()),
        )
        column, row = pick[3], todo.pop(pick[4])
        pivot = row[column]
        row = {j: value / pivot for j, value in row.items()}
        todo = [other for other in (_without(other, column, row) for other in todo) if other]
        solved = {j: _without(other, column, row) for j, other in solved.items()} | {column: row}
    return solved


def _without(row: _Row, column: int, solved: _Row) -> _Row:
    return _plus(row, row[column] - row[column] - row[column], solved) if column in row else row
