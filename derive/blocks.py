"""The kernels of a batch: many poses of one machine side by side, in the shape that compilers turn into SIMD code.

Poses are taken in blocks. Every quantity is a *lane array*, one number per pose of the block, and all lane arrays lie
in one flat scratch array at offsets known when the kernels are written. A kernel is a straight line of statements in
a loop over the poses, without branches and without calls that the compiler cannot look into. The limbs of a machine
run through the same kernel, each in its own region of the scratch array.

What the scalar kernels leave to elimination with pivoting is closed form here: the mean of a limb's two closures
holds the position, their difference the rotation, and blocks of at most three equations are solved by cofactors.
Derivatives are taken by turns of the platform about the axes of {O}, forwards along the steps, where a rotation
matrix gives cross products. Poses for which the closed form is poor, or Newton slow, are left to the plain kernels.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from derive import closed_form
from derive.backends.ir import Place
from derive.first_order import first_order, vanishing
from derive.graph import Graph, Steps
from derive.mathematics.functions import Functions, Inputs, entries
from derive.spec import LimbMechanism
from derive.vectors import cayley, skew, turn_by_cayley

LANES = 32  # poses of a block: what it computes with stays in the first cache
REGULAR = 1e-6  # determinant of a system over the product of its rows' lengths: below it is left to elimination
FAR = "; how far the equations are from dependent"


@dataclass(frozen=True)
class Blocks:
    """Functions over lanes, and where their quantities stand.

    Attributes
    ----------
    functions : tuple of Functions
        Of the system of all limbs; those of a limb are among the machine's other functions, with which they share what
        no pose changes.
    limb : mapping
        Name of a group of lane arrays to its first one, in the region of a limb.
    shared : mapping
        The same for what all limbs share, counted from the start of the scratch array.
    stride, total : int
        Lane arrays of a limb's region, and of everything.
    rows : tuple of tuple of int
        Row of the system for each limb and each of its closures.
    turned, matrix : int
        Coordinates of the platform that are turns; entries of its rotation matrix among the lane arrays.
    checks, held : int
        Of how many systems `step`, and `command`, say how far they are from dependent.
    paired : bool
        Whether the rows of a limb are mean and half the difference of two closures.
    seeds : tuple of int
        Lane array of each number that Newton's method starts from, limb by limb.
    """

    functions: tuple[Functions, ...]
    limb: Mapping[str, int]
    shared: Mapping[str, int]
    stride: int
    total: int
    rows: tuple[tuple[int, ...], ...]
    turned: int
    matrix: int
    checks: int
    held: int
    paired: bool
    seeds: tuple[int, ...]
    lanes: int = LANES


def supported(mechanism: LimbMechanism) -> bool:
    """Tell whether the machine's equations fall into two blocks of at most three."""
    return mechanism.limbs * len(mechanism.loop_closure) <= 6


def rotation_steps(mechanism: LimbMechanism) -> dict[sp.Symbol, tuple[int, int]]:
    """Return the steps that are the entries of the platform's rotation matrix; in a plane two of them are alike."""
    entries: dict[sp.Expr, list[tuple[int, int]]] = {}
    for n, e in enumerate(cayley(_rotation(mechanism))):
        entries.setdefault(e, []).append(divmod(n, 3))
    return {s: entries[e].pop(0) for s, e in mechanism.steps if entries.get(e) and e.free_symbols}


def rotation_of(mechanism: LimbMechanism) -> sp.Matrix:
    """Return the platform's rotation matrix by the steps that are its entries, 0 of those that are none."""
    named = {at: s for s, at in rotation_steps(mechanism).items()}
    return sp.Matrix(3, 3, lambda r, c: named.get((r, c), 0))


def _rotation(mechanism: LimbMechanism) -> sp.Matrix:
    """Return the Cayley vector of the platform's rotation; a component that does not move is zero."""
    found = {str(quantity.symbol): quantity.symbol for quantity in mechanism.platform}
    return sp.Matrix([found.get(name, sp.Integer(0)) for name in ("cx", "cy", "cz")])


def turning_axes(mechanism: LimbMechanism) -> list[int]:
    """Return the axes about which the platform turns."""
    return [j for j, s in enumerate(_rotation(mechanism)) if s != 0]


def change_by_turn(mechanism: LimbMechanism) -> sp.Matrix:
    """Return dc/dw (3, 3): how the Cayley vector changes when the platform turns about the axes of {O}."""
    c = _rotation(mechanism)
    return sp.eye(3) - skew(c) / 2 + c * c.T / 4


def turn_by_change(mechanism: LimbMechanism) -> list[sp.Expr]:
    """Return dw/dc, row by row, of the axes about which the platform turns: the inverse of `change_by_turn`."""
    c, axes = _rotation(mechanism), turning_axes(mechanism)
    return list(turn_by_cayley(skew(c), c.dot(c)).extract(axes, axes))


def _rates(mechanism: LimbMechanism, start: Mapping[sp.Symbol, sp.Expr], turn: int | None) -> list[sp.Expr]:
    """Return the rates of the closures, rod by rod, along a direction, forwards through the steps."""
    entries = rotation_steps(mechanism)
    spun = skew(sp.eye(3)[:, turn]) * rotation_of(mechanism) if turn is not None else sp.zeros(3, 3)
    known = dict(start)
    for symbol, expr in mechanism.steps:
        rate = spun[entries[symbol]] if turn is not None and symbol in entries else _rate(expr, known)
        if rate != 0:
            known[symbol] = rate
    return [_rate(e, known) for e in equations_of(mechanism)]


def _rate(expr: sp.Expr, rates: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    return sp.Add(*(sp.diff(expr, s) * rates[s] for s in sorted(expr.free_symbols & set(rates), key=str)))


def equations_of(mechanism: LimbMechanism) -> list[sp.Expr]:
    """Return the equations of a limb: mean and half the difference of a pair of rods, or its closures as they are."""
    if len(mechanism.loop_closure) != 2:
        return list(mechanism.loop_closure)
    first, second = mechanism.loop_closure
    return [sp.expand((first + second) / 2), sp.expand((first - second) / 2)]


def equations(mechanism: LimbMechanism) -> list[list[sp.Expr]]:
    """Return a limb's equations, each with its derivatives by shifts, by turns of the platform and by the joint."""
    shifts = [_rates(mechanism, {q.symbol: sp.Integer(1)}, None) for q in mechanism.platform if q.name[0] == "p"]
    change = change_by_turn(mechanism)
    changed = [(m, c) for m, c in enumerate(_rotation(mechanism)) if c != 0]
    spins = [_rates(mechanism, {c: change[m, k] for m, c in changed}, k) for k in turning_axes(mechanism)]
    by_joint = _rates(mechanism, {mechanism.joint.symbol: sp.Integer(1)}, None)
    return [list(row) for row in zip(equations_of(mechanism), *shifts, *spins, by_joint, strict=True)]


def of_rows(rates: Sequence[sp.Expr], steps: Steps) -> list[sp.Expr]:
    """Return the rates of a nominal limb's equations, see `_rows`, by those of its closures."""
    values = list(rates)
    if len(values) == 2:
        values = [(values[0] + values[1]) / 2, (values[0] - values[1]) / 2]
    zero = {symbol: e for symbol, e in steps if e == 0}
    return [sp.expand(e.xreplace(zero)) for e in values]


def _named(steps: list[tuple[sp.Symbol, sp.Expr]], name: str, values: sp.Matrix) -> sp.Matrix:
    symbols = sp.Matrix(*values.shape, lambda r, c: sp.Symbol(f"{name}_{r}{c}", real=True))
    steps.extend(zip(symbols, values, strict=True))
    return symbols


def _cofactors(steps: list[tuple[sp.Symbol, sp.Expr]], name: str, A: sp.Matrix) -> tuple[sp.Matrix, sp.Expr, sp.Expr]:
    """Return the cofactors of A, one over its determinant, and how far its rows are from dependent."""
    cofactors = _named(steps, f"{name}_cof", A.cofactor_matrix())
    det = _named(steps, f"{name}_det", sp.Matrix([A[0, :].dot(cofactors[0, :])]))[0]
    by = _named(steps, f"{name}_by", sp.Matrix([1 / det]))[0]
    return cofactors, by, det**2 - REGULAR**2 * sp.Mul(*(A[r, :].dot(A[r, :]) for r in range(A.rows)))


def _inverse(steps: list[tuple[sp.Symbol, sp.Expr]], name: str, A: sp.Matrix) -> tuple[sp.Matrix, sp.Expr]:
    """Return the inverse of A by cofactors, and how far its rows are from dependent."""
    cofactors, by, far = _cofactors(steps, name, A)
    return _named(steps, f"{name}_inv", cofactors.T * by), far


def felt(by_joint: sp.Expr, by_platform: sp.Matrix) -> sp.Expr:
    """Return how far an equation is from not feeling its joint (positive: far enough)."""
    return by_joint**2 - REGULAR**2 * by_platform.dot(by_platform)


def held(
    F: sp.Matrix, J: sp.Matrix, J_q: sp.Matrix, joints: int, commanded: int, paired: bool
) -> tuple[list[tuple[sp.Symbol, sp.Expr]], list[sp.Expr]]:
    """Return the steps to a solution of ``J_q dq + J dx = F`` where the commanded coordinates stay, then the solution.

    Each limb's joint is eliminated by its first equation; where that leaves equations, what comes last is how far they
    are from dependent.
    """
    steps: list[tuple[sp.Symbol, sp.Expr]] = []
    if paired:
        by = _named(steps, "by", sp.Matrix([1 / J_q[i] for i in range(joints)]))
        ratio = _named(steps, "ratio", sp.Matrix([J_q[joints + i] * by[i] for i in range(joints)]))
        E = _named(steps, "E", J[joints:, commanded:] - sp.diag(*ratio) * J[:joints, commanded:])
        rest = sp.Matrix([F[joints + i] - ratio[i] * F[i] for i in range(joints)])
        cofactors, by_det, far = _cofactors(steps, "E", E)
        turned = _named(steps, "w", by_det * (cofactors.T * rest))
        return steps, [*(by[i] * (F[i] - J[i, commanded:].dot(turned)) for i in range(joints)), *turned, far]
    if F.rows == joints:
        return steps, [F[i] / J_q[i] for i in range(joints)]
    cofactors, by_det, far = _cofactors(steps, "A", sp.Matrix.hstack(J_q, J[:, commanded:]))
    return steps, [*(by_det * (cofactors.T * F)), far]


def motion(mechanism: LimbMechanism, step: Sequence[sp.Expr]) -> tuple[list[tuple[sp.Symbol, sp.Expr]], list[sp.Expr]]:
    """Return the steps to the platform after a step, then the platform and what moves of its rotation matrix."""
    platform = [quantity.symbol for quantity in mechanism.platform]
    turns = turning_axes(mechanism)
    n_p = len(platform) - len(turns)
    steps: list[tuple[sp.Symbol, sp.Expr]] = []
    turn = sp.Matrix([step[n_p + turns.index(k)] if k in turns else 0 for k in range(3)])
    changed = change_by_turn(mechanism) * turn
    new = [s - step[j] for j, s in enumerate(platform[:n_p])]
    new += [s - changed[k] for s, k in zip(platform[n_p:], turns, strict=True)]
    after = dict(zip(platform, _named(steps, "new", sp.Matrix(new)), strict=True))
    matrix = cayley(_rotation(mechanism).xreplace(after))
    return steps, [*after.values(), *(matrix[at] for at in rotation_steps(mechanism).values())]


class _Region:
    """Lane arrays one after the other."""

    def __init__(self, start: int = 0) -> None:
        self.at: dict[str, int] = {}
        self.next = start

    def take(self, name: str, count: int) -> int:
        self.at[name], self.next = self.next, self.next + count
        return self.at[name]


def lane(slot: int) -> Place:
    """Return the place of a lane array's entry."""
    return Place("w", slot * LANES, lane=True)


def _lanes(symbols: Iterable[sp.Symbol], start: int) -> dict[sp.Symbol, Place]:
    return {s: lane(start + j) for j, s in enumerate(symbols)}


def blocks(mechanism: LimbMechanism, seed: str, seeds: Sequence[sp.Expr], functions: Functions) -> Blocks:
    """Add a mechanism's functions over lanes.

    Parameters
    ----------
    seed : str
        What `seeds` mean: what the forward position starts from.
    functions : Functions
        The mechanism's other ones, to which those of a limb are added.

    Raises
    ------
    ValueError
        The machine's equations do not fall into blocks of at most three.
    """
    if not supported(mechanism):
        raise ValueError(f"{mechanism.name}: its equations do not fall into blocks of at most three.")
    graph = functions.graph
    limbs, rods = mechanism.limbs, len(mechanism.loop_closure)
    entries, paired = list(rotation_steps(mechanism)), rods == 2

    region = _Region()
    inputs = _inputs(mechanism, entries, region)
    region.take("rows", rods * (len(mechanism.platform) + 2))
    newton, joints, errors = _of_limb(mechanism, graph)
    late = {*(quantity.symbol for quantity in mechanism.platform), *entries}
    early = _early(graph, [graph.add(e) for e in newton if e is not None], late, inputs)
    starts = closed_form.start_of_inverse(mechanism)
    more = _early(graph, [graph.add(e) for e in (*joints, *errors) if e is not None], late, inputs)
    more = [s for s in more if s not in early]
    kept = region.take("early", len(early))
    region.take("seed", len(seeds))
    region.take("start", len(starts))
    further = region.take("more", len(more))
    region.take("errors", rods * len(mechanism.varied))
    with_early = inputs | _lanes(early, kept) | _lanes(more, further)
    for name, meaning, outputs, given in (
        ("early", f"what moves with a joint only; then {seed}", [*early, *seeds], inputs),
        ("more", "what else derivatives by joint and errors read of it", more, inputs),
        ("start", "joint of the simplified limb at a given position", starts, inputs),
        ("rows", "equations of a limb, their derivatives by shift and turn of the platform", newton, with_early),
        ("joints", "derivatives of a limb's equations by its joint", joints, with_early),
        ("errors", "derivatives of a limb's equations by errors, by deflections", errors, with_early),
    ):
        functions.add(name, meaning, outputs, dense=True, inputs=given)

    stride = region.next
    common = _Region(limbs * stride)
    order = tuple(tuple(j * limbs + i if paired else rods * i + j for j in range(rods)) for i in range(limbs))
    solved = _System(mechanism, region.at, stride, order, paired, common)
    return Blocks(
        functions=tuple(solved.functions),
        limb=region.at,
        shared=common.at,
        stride=stride,
        total=common.next,
        rows=order,
        turned=len(turning_axes(mechanism)),
        matrix=len(entries),
        checks=common.at["going"] - common.at["regular"],
        held=solved.held,
        paired=paired,
        seeds=tuple(i * stride + region.at["seed"] + c for i in range(limbs) for c in range(len(seeds))),
    )


def _inputs(mechanism: LimbMechanism, entries: Sequence[sp.Symbol], region: _Region) -> dict[sp.Symbol, Place]:
    """Return where a limb's functions read joint, tool, platform and its rotation matrix, with their places taken."""
    given = {
        "q": [mechanism.joint.symbol],
        "tool": [quantity.symbol for quantity in mechanism.tool],
        "x": [quantity.symbol for quantity in mechanism.platform],
        "R": entries,
    }
    return {s: at for name, own in given.items() for s, at in _lanes(own, region.take(name, len(own))).items()}


def _of_limb(
    mechanism: LimbMechanism, graph: Graph
) -> tuple[list[sp.Expr | None], list[sp.Expr | None], list[sp.Expr]]:
    """Return a limb's equations with their derivatives by shift and turn, those by its joint, and those by errors."""
    newton: list[sp.Expr | None] = []
    joints: list[sp.Expr | None] = []
    errors: list[sp.Expr] = []
    varied = [quantity.symbol for quantity in mechanism.varied]
    for row, *by_platform, by_joint in equations(mechanism):
        newton += [row, *by_platform, None]
        joints += [*[None] * (len(by_platform) + 1), by_joint]
        errors += graph.derivatives(row, varied)
    return newton, joints, errors


def _early(graph: Graph, wanted: Sequence[sp.Expr], late: set[sp.Symbol], inputs: Inputs) -> list[sp.Symbol]:
    """Return the nodes that do not move with the platform and that `wanted`, or nodes that do, are made of."""
    nodes = graph.needed(wanted, known=inputs)
    moving = set(late)
    found: dict[sp.Symbol, None] = {}
    for symbol, expr in nodes.items():
        if expr.free_symbols & moving:
            moving.add(symbol)
    for expr in (*(nodes[s] for s in nodes if s in moving), *wanted):
        for s in sorted(expr.free_symbols, key=str):
            if s in nodes and s not in moving and not graph.is_invariant(s):
                found[s] = None
    return list(found)


@dataclass(frozen=True)
class Nominal:
    """Functions of the nominal machine's sensitivity.

    Attributes
    ----------
    runs : tuple of (int, int, tuple of int)
        First error, error after the last, and the equations of a limb that these change: of each error as many.
    factors, values : tuple of tuple of int
        By equation, where in scratch each column of the sensitivity, limb by limb, has what is multiplied and summed.
    """

    functions: tuple[Functions, ...]
    errors: int
    positions: int
    runs: tuple[tuple[int, int, tuple[int, ...]], ...]
    factors: tuple[tuple[int, ...], ...]
    values: tuple[tuple[int, ...], ...]


def nominal(mechanism: LimbMechanism, layout: Blocks) -> Nominal | None:
    """Return the sensitivity of the nominal machine's position by its errors, in the places of the exact one.

    Rods of a pair are parallel then, which leaves most derivatives of their difference zero. Functions: `nominal` (a
    limb's equations by platform and errors; those stored are the ones that do not vanish), `nominal_inverse`,
    `nominal_constants`. None where positions turn the platform.
    """
    if mechanism.seeds is not None or mechanism.home is not None:
        return None
    limbs, rods = mechanism.limbs, len(mechanism.loop_closure)
    n_x = len(mechanism.platform)
    platform = [quantity.symbol for quantity in mechanism.platform]
    errors = [quantity.symbol for quantity in (*mechanism.errors, *mechanism.common)]
    steps, closures = first_order(mechanism, {str(s): {s: sp.Integer(1)} for s in (*platform, *errors)})
    rates = {
        s: [vanishing(e, steps) for e in of_rows([rate[str(s)] for rate in closures], steps)]
        for s in (*platform, *errors)
    }
    felt = _felt([rates[s] for s in errors])

    inputs = _lanes([mechanism.joint.symbol], layout.limb["q"])
    inputs |= _lanes([quantity.symbol for quantity in mechanism.tool], layout.limb["tool"])
    inputs |= _lanes(platform[: mechanism.commanded], layout.limb["x"])
    parameters = entries("p", [quantity.symbol for quantity in mechanism.limb_parameters])
    functions = Functions(Graph(steps, invariant=parameters), parameters, inputs)
    start, width = layout.limb["rows"], len(mechanism.varied)
    places: dict[int, sp.Expr] = {}
    read: dict[sp.Symbol, Place] = {}
    J = sp.zeros(limbs * rods, n_x)
    for j in range(rods):
        for c, s in enumerate(platform):
            slot = start + j * (n_x + 2) + 1 + c
            if rates[s][j] != 0:
                places[slot - start] = rates[s][j]
                for i in range(limbs):
                    J[layout.rows[i][j], c] = sp.Symbol(f"J{i}{j}_{c}", real=True)
                    read[J[layout.rows[i][j], c]] = lane(i * layout.stride + slot)
        for e, s in enumerate(errors):
            if j in felt[e]:
                places[layout.limb["errors"] - start + j * width + e] = rates[s][j]
    outputs = [places.get(j) for j in range(max(places) + 1)]

    solved, block, checks = _position_of(J, limbs)
    # zeros are stored too: what stands in scratch is left over
    functions.add("nominal", "equations of a nominal limb by platform and errors", outputs, dense=True)
    functions.constants("nominal_constants", "what `nominal_sensitivity` reads that no pose changes")
    inverse = Functions(Graph(solved), {}, read)
    inverse.add(
        "nominal_inverse",
        f"minus the inverse of the derivatives, its rows of the position{FAR}",
        [*block, *checks],
        dense=True,
    )
    factors, values = _products(layout, felt, width)
    return Nominal((functions, inverse), len(errors), block.rows, _runs(felt), factors, values)


def _felt(rates: Sequence[Sequence[sp.Expr]]) -> list[tuple[int, ...]]:
    """Return the equations of a limb that each error changes, as many of each: some are told that are not changed."""
    changed = [tuple(j for j, rate in enumerate(of_error) if rate != 0) for of_error in rates]
    most, every = max(map(len, changed)), range(len(rates[0]))
    return [tuple(sorted({*some, *[j for j in every if j not in some][: most - len(some)]})) for some in changed]


def _runs(felt: Sequence[tuple[int, ...]]) -> tuple[tuple[int, int, tuple[int, ...]], ...]:
    """Return errors that stand side by side and change the same equations as one; see `Nominal`."""
    first = [e for e in range(len(felt)) if e == 0 or felt[e] != felt[e - 1]]
    return tuple((e, end, felt[e]) for e, end in zip(first, [*first[1:], len(felt)], strict=True))


def _products(layout: Blocks, felt: Sequence[tuple[int, ...]], width: int) -> list[tuple[tuple[int, ...], ...]]:
    """Return the factors and the values of `Nominal`, for rows of derivatives by errors of a width."""
    columns = [(i, e) for i in range(len(layout.rows)) for e in range(len(felt))]
    factors, values = [], []
    for j in range(len(felt[0])):
        factors.append([layout.shared["inverse"] + layout.rows[i][felt[e][j]] for i, e in columns])
        values.append([i * layout.stride + layout.limb["errors"] + felt[e][j] * width + e for i, e in columns])
    return [tuple(tuple(LANES * place for place in places) for places in both) for both in (factors, values)]


def _position_of(J: sp.Matrix, a: int) -> tuple[list[tuple[sp.Symbol, sp.Expr]], sp.Matrix, list[sp.Expr]]:
    """Return steps, minus the inverse's rows of the position, and how far what is divided by is from dependent.

    The position stands in the first `a` equations; where a turn follows from further ones, it is eliminated.
    """
    solved: list[tuple[sp.Symbol, sp.Expr]] = []
    G, far = _inverse(solved, "G", J[:a, :a])
    block, checks = -G, [far]
    if J.rows > a:
        U = _named(solved, "U", G * J[:a, a:])
        S = _named(solved, "S", J[a:, a:] - J[a:, :a] * U)
        Si, far = _inverse(solved, "Si", S)
        lower = _named(solved, "V", -Si * J[a:, :a] * G)
        block = sp.Matrix.hstack(U * lower - G, U * Si)
        checks.append(far)
    return solved, block, checks


class _System:
    """The equations of all limbs together: Newton's step forwards and backwards, the inverse, the platform's motion."""

    def __init__(
        self,
        mechanism: LimbMechanism,
        limb: Mapping[str, int],
        stride: int,
        order: tuple[tuple[int, ...], ...],
        paired: bool,
        common: _Region,
    ) -> None:
        limbs, rods = mechanism.limbs, len(mechanism.loop_closure)
        n_x, f = len(mechanism.platform), mechanism.limbs * len(mechanism.loop_closure)
        a = limbs if paired else min(f, 3)  # equations, and coordinates, of the first block
        self.functions: list[Functions] = []
        F, J, J_q = sp.zeros(f, 1), sp.zeros(f, n_x), sp.zeros(f, 1)
        read: dict[sp.Symbol, Place] = {}
        for i in range(limbs):
            for j in range(rods):
                names = sp.symbols([f"F{i}{j}", *(f"J{i}{j}_{c}" for c in range(n_x)), f"Q{i}{j}"], real=True)
                read |= _lanes(names, i * stride + limb["rows"] + j * (n_x + 2))
                row = order[i][j]
                F[row], J[row, :], J_q[row] = names[0], sp.Matrix([names[1:-1]]), names[-1]
        step = common.take("step", n_x)
        common.take("regular", 2 if f > a else 1)
        common.take("going", 1)

        steps: list[tuple[sp.Symbol, sp.Expr]] = []
        G, far = _inverse(steps, "G", J[:a, :a])
        first = _named(steps, "u", G * F[:a, :])
        checks = [far]
        if f > a:
            U = _named(steps, "U", G * J[:a, a:])
            S = _named(steps, "S", J[a:, a:] - J[a:, :a] * U)
            Si, _ = _inverse(steps, "Si", S)
            det = next(s for s, _ in steps if str(s) == "Si_det_00")
            checks.append(det**2 - REGULAR**2 * sp.Mul(*(J[r, a:].dot(J[r, a:]) for r in range(a, f))))
            turned = _named(steps, "w", Si * (F[a:, :] - J[a:, :a] * first))
            moved = first - U * turned
            self._add("step", f"Newton's step of the platform{FAR}", steps, read, [*moved, *turned, *checks])
            lower = _named(steps, "V", -Si * J[a:, :a] * G)
            block = sp.Matrix.vstack(sp.Matrix.hstack(U * lower - G, U * Si), sp.Matrix.hstack(-lower, -Si))
        else:
            self._add("step", f"Newton's step of the platform{FAR}", steps, read, [*first, *checks])
            block = -G
        common.take("inverse", n_x * f + len(checks))
        self._add("inverse", f"minus the inverse of the derivatives, row by row{FAR}", steps, read, [*block, *checks])
        self._command(mechanism, F, J, J_q, read, common, paired)
        self._move(mechanism, limb, step, common)

    def _command(
        self,
        mechanism: LimbMechanism,
        F: sp.Matrix,
        J: sp.Matrix,
        J_q: sp.Matrix,
        read: Inputs,
        common: _Region,
        paired: bool,
    ) -> None:
        """Add Newton's step of an inverse position."""
        common.take("change", len(mechanism.platform))
        steps, outputs = held(F, J, J_q, mechanism.limbs, mechanism.commanded, paired)
        if len(mechanism.loop_closure) <= 2:
            outputs += [felt(J_q[i], J[i, : mechanism.commanded]) for i in range(mechanism.limbs)]
        self.held = len(outputs) - len(mechanism.platform)
        common.take("held", self.held)
        self._add("command", f"Newton's step of joints and rotation{FAR}", steps, read, outputs)

    def _move(self, mechanism: LimbMechanism, limb: Mapping[str, int], step: int, common: _Region) -> None:
        """Add the step's effect on the platform: x as it is or less the step, and its rotation matrix."""
        platform = [quantity.symbol for quantity in mechanism.platform]
        y = sp.symbols([f"y{j}" for j in range(len(platform))], real=True)
        going = sp.Symbol("going", real=True)
        read = _lanes(platform, limb["x"]) | _lanes(y, step) | _lanes([going], common.at["going"])
        steps, outputs = motion(mechanism, [going * s for s in y])
        self._add(
            "move",
            "the platform after a step, and its rotation matrix",
            steps,
            read,
            outputs,
        )

    def _add(self, name: str, meaning: str, steps: Steps, read: Inputs, outputs: Sequence[sp.Expr]) -> None:
        functions = Functions(Graph(steps), {}, read)
        functions.add(name, meaning, outputs, dense=True)
        self.functions.append(functions)
