"""A machine of limbs in motion: what its bodies ask of its joints, through the closure, by virtual work.

Bodies are written as points with masses (`derive.spec.Inertial`). Closures and points are differentiated by time,
twice, along the steps that lead to them: a platform that turns with w has the matrix ``R' = [w] R``. The closures'
first derivative gives the platform's velocity by those of the joints, the second its acceleration. A point asks for the
force ``p'' - g`` per mass (d'Alembert), and its virtual work along joint and platform gives what the joints must do.

Like the kinematics of a batch (`derive.blocks`), with whose lane arrays they work, the functions are written for poses
side by side.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from derive.backends.ir import Place
from derive.blocks import LANES, Blocks, equations_of, lane, rotation_of, rotation_steps, turning_axes
from derive.graph import Graph
from derive.mathematics.bodies import MM
from derive.mathematics.functions import Functions, Inputs, entries
from derive.spec import SHARE, Inertial, LimbMechanism
from derive.vectors import skew

GRAVITY = sp.Matrix(sp.symbols("gx gy gz", real=True))
RATES = sp.symbols("q_t q_tt", real=True)  # of a limb's joint


@dataclass(frozen=True)
class Motion:
    """Functions of a machine in motion, and where their lane arrays stand.

    Attributes
    ----------
    functions : tuple of Functions
        `curved` (second derivatives of a limb's closures by time where nothing accelerates), `move` (how the platform
        moves with each joint, and as it does), `accelerate`, ``limb_fields, platform_fields`` (gravity less
        acceleration of the points), ``limb_asks, platform_asks`` (loads on joint and platform per inertial parameter),
        `give` and `give_each` (what the joints give, altogether and per parameter).
    limb, shared : mapping
        Name of a group of lane arrays to its first one: in the region of a limb, ``d``; of all together, ``s``.
    stride, total : int
        How many there are of either.
    parameters : int
        Inertial parameters but the payload.
    given : tuple of (int, int)
        Joint and parameter of each number of `give_each`: the others are zero.
    """

    functions: tuple[Functions, ...]
    limb: Mapping[str, int]
    shared: Mapping[str, int]
    stride: int
    total: int
    parameters: int
    given: tuple[tuple[int, int], ...]


class _Lanes:
    """Lane arrays of one region, group by group."""

    def __init__(self, array: str) -> None:
        self.at: dict[str, int] = {}
        self.array, self.next = array, 0

    def take(self, name: str, symbols: Sequence[sp.Symbol]) -> dict[sp.Symbol, Place]:
        """Return the places of symbols in a group of their own."""
        self.at[name], self.next = self.next, self.next + len(symbols)
        return {s: self.of(self.at[name] + j) for j, s in enumerate(symbols)}

    def of(self, slot: int) -> Place:
        """Return the place of a lane array."""
        return Place(self.array, slot * LANES, lane=True)


def _numbered(name: str, *counts: int) -> list[sp.Symbol]:
    """Return symbols of an array, row by row."""
    names = [name]
    for count in counts:
        names = [f"{n}_{j}" for n in names for j in range(count)]
    return [sp.Symbol(n, real=True) for n in names]


class _Moving:
    """A machine whose joints and platform move, and the graph of what moves with them."""

    def __init__(self, mechanism: LimbMechanism, layout: Blocks) -> None:
        self.mechanism, self.layout = mechanism, layout
        self._turned = rotation_steps(mechanism)
        self._R = rotation_of(mechanism)
        self.shifts = [q.symbol for q in mechanism.platform if q.name[0] == "p"]
        self.turns = turning_axes(mechanism)
        self.twist = [sp.Symbol(f"v_{s}", real=True) for s in self.shifts]
        self.twist += [sp.Symbol(f"w_{'xyz'[k]}", real=True) for k in self.turns]
        self.twist_t = [sp.Symbol(f"{s}_t", real=True) for s in self.twist]
        self._steps = [(s, e) for s, e in mechanism.steps if s not in self._turned]
        self._parameters = entries("p", [q.symbol for q in mechanism.limb_parameters])
        self._inputs = {mechanism.joint.symbol: lane(layout.limb["q"])}
        groups = (
            ("tool", [q.symbol for q in mechanism.tool]),
            ("x", [q.symbol for q in mechanism.platform]),
            ("R", list(self._turned)),
        )
        for name, symbols in groups:
            self._inputs |= {s: lane(layout.limb[name] + j) for j, s in enumerate(symbols)}

    def functions(self, inputs: Inputs) -> Functions:
        """Return functions of a graph whose inputs are the machine's, and some more."""
        graph = Graph(self._steps, invariant=self._parameters)
        return Functions(graph, self._parameters, self._inputs | dict(inputs))

    def spun(self, k: int) -> sp.Matrix:
        """Return how the platform's matrix changes with a turn about an axis of {O}."""
        return skew(sp.eye(3)[:, k]) * self._R

    def twice(self, graph: Graph, leaves: Sequence[sp.Expr], *, accelerating: bool = True) -> list[sp.Expr]:
        """Return the second derivatives by time of leaves of a graph."""
        n = len(self.shifts)
        rates = dict(zip(self.shifts, self.twist[:n], strict=True)) | {self.mechanism.joint.symbol: RATES[0]}
        turned = sp.zeros(3, 3)
        for w, k in zip(self.twist[n:], self.turns, strict=True):
            turned += w * self.spun(k)
        rates |= {s: graph.add(turned[at]) for s, at in self._turned.items()}
        once = graph.rates(rates)
        first = [graph.rate(leaf, once) for leaf in leaves]
        if accelerating:
            rates |= dict(zip([*self.twist, RATES[0]], [*self.twist_t, RATES[1]], strict=True))
        again = graph.rates(rates)
        return [graph.rate(leaf, again) for leaf in first]

    def work(self, graph: Graph, work: sp.Expr) -> list[sp.Expr]:
        """Return the derivatives of a work by the joint, by shifts and by turns of the platform."""
        by = graph.gradient(graph.add(work))
        zero = sp.Integer(0)
        found = [by.get(s, zero) for s in (self.mechanism.joint.symbol, *self.shifts)]
        for k in self.turns:
            spun = self.spun(k)
            found.append(graph.add(sp.Add(*(by.get(s, zero) * spun[at] for s, at in self._turned.items()))))
        return found


def loops(mechanism: LimbMechanism, layout: Blocks) -> Motion:
    """Return a machine's functions in motion, over the lane arrays of its kinematics."""
    moving = _Moving(mechanism, layout)
    limb, shared = _Lanes("d"), _Lanes("s")
    speeds = _numbered("V", len(mechanism.platform), mechanism.limbs)
    at_speeds = shared.take("speeds", speeds)
    moves = shared.take("twist", moving.twist) | shared.take("twist_t", moving.twist_t)
    given = moves | limb.take("rates", RATES) | entries("gravity", list(GRAVITY)) | entries("shares", [SHARE])

    rows = equations_of(mechanism)
    limb.take("curved", _numbered("c", len(rows)))
    functions, of_platform = moving.functions(given), moving.functions(given)
    closures = [functions.graph.add(e) for e in rows]
    curved = moving.twice(functions.graph, closures, accelerating=False)
    meaning = "second derivatives of a limb's equations by time where nothing accelerates"
    functions.add("curved", meaning, curved, dense=True)
    on_limb = _asked(functions, moving, "limb", mechanism.limb_inertials, limb)
    functions.constants("constants", "what no pose changes of bodies in motion")
    on_platform = _asked(of_platform, moving, "platform", mechanism.platform_inertials, shared)

    system = _System(mechanism, layout, limb, speeds, at_speeds)
    system.moves()
    loads = system.loads(on_limb, on_platform, shared)
    shared.take("torque", _numbered("T", mechanism.limbs))
    pairs = system.gives(loads)
    shared.take("each", _numbered("Y", len(pairs)))
    return Motion(
        functions=(functions, of_platform, *system.functions),
        limb=limb.at,
        shared=shared.at,
        stride=limb.next,
        total=shared.next,
        parameters=len(loads) - 1,
        given=tuple(pairs),
    )


def _asked(
    functions: Functions, moving: _Moving, name: str, bodies: Sequence[Inertial], region: _Lanes
) -> list[tuple[int, int]]:
    """Add fields and loads of the bodies of a limb, or of the platform; return parameter and direction of each load.

    Direction 0 is the joint, the others are those of the platform.
    """
    graph, points = functions.graph, points_of(bodies)
    fields = [sp.Matrix(sp.symbols(f"f{j}x f{j}y f{j}z", real=True)) for j in range(len(points))]
    felt = [s for field in fields for s in field]
    places = region.take("fields", felt)
    loads: dict[tuple[int, int], sp.Expr] = {}
    for b, body in enumerate(bodies):
        work = sp.Add(*(mass * fields[points.index(point)].dot(point) for mass, point in body.points))
        loads |= {(b, d): e for d, e in enumerate(moving.work(graph, work)) if e != 0}
    region.take("asks", _numbered("a", len(loads)))
    nodes = graph.needed(loads.values())
    read = set().union(*(e.free_symbols for e in (*nodes.values(), *loads.values())))
    leaves = [graph.add(e) for point in points for e in point]
    moved = moving.twice(graph, leaves)
    outputs = [GRAVITY[n % 3] - MM * e if felt[n] in read else None for n, e in enumerate(moved)]
    meaning = f"gravity less acceleration of the points of a {name}"
    functions.add(f"{name}_fields", meaning, outputs, dense=True)
    meaning = f"loads per inertial parameter of a {name}, along joint, shifts and turns"
    functions.add(f"{name}_asks", meaning, list(loads.values()), dense=True, inputs={**functions.inputs, **places})
    return list(loads)


class _System:
    """All limbs together: how the platform moves with the joints, and what they give."""

    def __init__(
        self,
        mechanism: LimbMechanism,
        layout: Blocks,
        limb: _Lanes,
        speeds: Sequence[sp.Symbol],
        at_speeds: Inputs,
    ) -> None:
        self._mechanism, self._layout, self._limb, self._at_speeds = mechanism, layout, limb, at_speeds
        self._V = sp.Matrix(len(mechanism.platform), mechanism.limbs, speeds)
        self.functions: list[Functions] = []

    def _of_limb(self, i: int, name: str, j: int) -> Place:
        return self._limb.of(i * self._limb.next + self._limb.at[name] + j)

    def moves(self) -> None:
        """Add `move`, which gives what is read behind it in order, and `accelerate`."""
        n_x, limbs = self._V.shape
        f = limbs * len(self._mechanism.loop_closure)
        inverse = sp.Matrix(n_x, f, _numbered("M", n_x, f))
        by_joint, bent = sp.Matrix(_numbered("Q", f)), sp.Matrix(_numbered("c", f))
        q_t, q_tt = (sp.Matrix(_numbered(f"q_{'t' * order}", limbs)) for order in (1, 2))
        read = {s: lane(self._layout.shared["inverse"] + j) for j, s in enumerate(inverse)}
        V = sp.zeros(n_x, limbs)
        for i, rows in enumerate(self._layout.rows):
            read |= {s[i]: self._of_limb(i, "rates", order) for order, s in enumerate((q_t, q_tt))}
            for j, row in enumerate(rows):
                slot = i * self._layout.stride + self._layout.limb["rows"] + j * (n_x + 2) + n_x + 1
                read |= {by_joint[row]: lane(slot), bent[row]: self._of_limb(i, "curved", j)}
                V[:, i] += inverse[:, row] * by_joint[row]
        meaning = "how the platform moves with each joint, and how it does"
        self._add("move", meaning, list(zip(self._V, V, strict=True)), read, [*self._V, *(self._V * q_t)])
        accelerated = self._V * q_tt + inverse * bent
        self._add("accelerate", "the platform's acceleration", [], {**read, **self._at_speeds}, list(accelerated))

    def loads(
        self, on_limb: Sequence[tuple[int, int]], on_platform: Sequence[tuple[int, int]], shared: _Lanes
    ) -> list[tuple[sp.Matrix, sp.Matrix]]:
        """Return what each inertial parameter asks of the joints themselves and of the platform; the payload last."""
        n_x, limbs = self._V.shape
        found: list[tuple[sp.Matrix, sp.Matrix]] = []
        self._asks: dict[sp.Symbol, Place] = {}

        def add(body: str, loads: Sequence[tuple[int, int]], parameter: int, joint: int) -> None:
            on_joints, along = sp.zeros(limbs, 1), sp.zeros(n_x, 1)
            for j, (b, d) in enumerate(loads):
                if b != parameter:
                    continue
                s = sp.Symbol(f"a_{body}_{j}", real=True)
                self._asks[s] = self._of_limb(joint, "asks", j) if body != "p" else shared.of(shared.at["asks"] + j)
                if d == 0:
                    on_joints[joint] = s
                else:
                    along[d - 1] = s
            found.append((on_joints, along))

        for i in range(limbs):
            for b in range(len(self._mechanism.limb_inertials)):
                add(str(i), on_limb, b, i)
        for b in range(len(self._mechanism.platform_inertials)):
            add("p", on_platform, b, 0)
        return found

    def gives(self, loads: Sequence[tuple[sp.Matrix, sp.Matrix]]) -> list[tuple[int, int]]:
        """Add `give` and `give_each`; return joint and parameter of each number that the latter gives."""
        inertia = _numbered("m", len(loads))
        read = {**self._asks, **self._at_speeds}
        on_joints, along = sp.zeros(self._V.cols, 1), sp.zeros(self._V.rows, 1)
        for m, (own, others) in zip(inertia, loads, strict=True):
            on_joints, along = on_joints + m * own, along + m * others
        steps = [(sp.Symbol(f"W_{j}", real=True), e) for j, e in enumerate(along)]
        held = on_joints + self._V.T * sp.Matrix([s for s, _ in steps])
        self._add("give", "what the joints give", steps, {**read, **entries("inertia", inertia)}, list(-held))
        every = [-(own + self._V.T * others) for own, others in loads[:-1]]
        found = {(j, n): e[j] for n, e in enumerate(every) for j in range(len(e)) if e[j] != 0}
        self._add("give_each", "what the joints give for each inertial parameter", [], read, list(found.values()))
        return list(found)

    def _add(
        self,
        name: str,
        meaning: str,
        steps: Sequence[tuple[sp.Symbol, sp.Expr]],
        read: Inputs,
        outputs: Sequence[sp.Expr],
    ) -> None:
        functions = Functions(Graph(steps), {}, read)
        functions.add(name, meaning, outputs, dense=True)
        self.functions.append(functions)


def points_of(bodies: Sequence[Inertial]) -> list[sp.Matrix]:
    """Return the points of some inertial parameters, each once."""
    found: list[sp.Matrix] = []
    for body in bodies:
        found += [point for _, point in body.points if point not in found]
    return found
