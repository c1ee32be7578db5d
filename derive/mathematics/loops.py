"""A machine of limbs in motion: what its bodies ask of its joints, through the closure, by virtual work.

Bodies are written as points with masses (`derive.spec.Inertial`). Closures and points are differentiated by time,
twice, along the steps that lead to them. A point asks for the force ``p'' - g`` per mass (d'Alembert); its virtual work
along joint and platform, and the multipliers of the closures, give what the joints must do (see `derive.statics`).
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from derive.graph import Graph
from derive.mathematics.bodies import MM
from derive.mathematics.functions import Functions, entries
from derive.spec import Inertial, LimbMechanism

GRAVITY = sp.Matrix(sp.symbols("gx gy gz", real=True))


def loops(mechanism: LimbMechanism) -> list[Functions]:
    """Return a machine's functions in motion, of one limb and of the platform.

    `closing`: per closure its second derivative by time where nothing accelerates, its derivatives by the platform, by
    the joint. ``limb_fields, platform_fields``: gravity less acceleration, of each point. ``limb_asks,
    platform_asks``: per inertial parameter the generalised loads of these fields, on the joint (of a limb), on the
    platform.
    """
    platform, joint = [quantity.symbol for quantity in mechanism.platform], mechanism.joint.symbol
    every = [*platform, joint]
    by_time = [[sp.Symbol(f"{s}_{'t' * order}", real=True) for s in every] for order in (1, 2)]
    first, second = dict(zip(every, by_time[0], strict=True)), dict(zip(by_time[0], by_time[1], strict=True))
    inputs = entries("x", platform) | entries("x_t", by_time[0][:-1]) | entries("x_tt", by_time[1][:-1])
    inputs |= entries("joint", [joint, by_time[0][-1], by_time[1][-1]]) | entries("gravity", list(GRAVITY))
    inputs |= entries("tool", [s.symbol for s in mechanism.tool])
    inputs |= entries("p", [s.symbol for s in mechanism.limb_parameters])
    still = dict.fromkeys(by_time[0], sp.Integer(0))

    def twice(graph: Graph, leaves: Sequence[sp.Expr], then: dict[sp.Symbol, sp.Expr]) -> list[sp.Expr]:
        once = graph.rates(first)
        rates = [graph.rate(leaf, once) for leaf in leaves]
        again = graph.rates(first | then)
        return [graph.rate(leaf, again) for leaf in rates]

    graph = Graph(mechanism.steps)
    found = [Functions(graph, {}, inputs)]
    closures = [graph.add(e) for e in mechanism.loop_closure]
    curved = twice(graph, closures, still)
    rows = [[e, *graph.derivatives(c, every)] for e, c in zip(curved, closures, strict=True)]
    meaning = "per closure of one limb: second derivative by time without accelerations, by platform, by joint"
    found[0].add("closing", meaning, [e for row in rows for e in row], dense=True)
    for name, bodies, by in (
        ("limb", mechanism.limb_inertials, [joint, *platform]),
        ("platform", mechanism.platform_inertials, platform),
    ):
        points = points_of(bodies)
        fields = [sp.Matrix(sp.symbols(f"f{j}x f{j}y f{j}z", real=True)) for j in range(len(points))]
        graph = Graph(mechanism.steps)
        functions = Functions(graph, {}, inputs | entries("fields", [s for f in fields for s in f]))
        leaves = [graph.add(e) for point in points for e in point]
        felt = [GRAVITY[n % 3] - MM * e for n, e in enumerate(twice(graph, leaves, second))]
        functions.add(f"{name}_fields", f"gravity less acceleration of the points of one {name}", felt, dense=True)
        loads: list[sp.Expr] = []
        for body in bodies:
            of_point = [(mass, points.index(point)) for mass, point in body.points]
            work = sp.Add(*(mass * fields[n].dot(points[n]) for mass, n in of_point))
            loads += graph.derivatives(work, by)
        functions.add(f"{name}_asks", f"generalised loads per inertial parameter of one {name}", loads, dense=True)
        found.append(functions)
    return found


def points_of(bodies: Sequence[Inertial]) -> list[sp.Matrix]:
    """Return the points of some inertial parameters, each once."""
    found: list[sp.Matrix] = []
    for body in bodies:
        found += [point for _, point in body.points if point not in found]
    return found
