"""An open chain in motion: what its bodies ask of its joints, from the products of transforms of its kinematics.

A link's frame is differentiated by time, twice, along the steps that lead to it; what its body asks for follows by
d'Alembert's principle (`derive.mathematics.bodies`), and what a joint must give by virtual work: the twist of all that
is behind it, times the force and the moment that this asks for.
"""

from __future__ import annotations

import sympy as sp

from derive import vectors
from derive.graph import Graph
from derive.mathematics.bodies import INERTIA, PLACE, asked, by_inertia, of_point
from derive.mathematics.chains import FORCE, FRAME, MOMENT, ORIGIN, ROTATION
from derive.mathematics.functions import Functions, entries
from derive.spec import ChainMechanism

GRAVITY = sp.Matrix(sp.symbols("gx gy gz", real=True))
AXIS = sp.Matrix(sp.symbols("ux uy uz wx wy wz", real=True))  # a joint's twist: shift of {O}'s origin, turn
ASKED = (*FORCE, *MOMENT)


def _rates(symbols: list[sp.Symbol], order: int) -> list[sp.Symbol]:
    """Return the symbols of derivatives by time."""
    return [sp.Symbol(f"{s}_{'t' * order}", real=True) for s in symbols]


def motion(mechanism: ChainMechanism) -> Functions:
    """Return a chain's functions in motion.

    Of a link, for each convention: ``move_CONVENTION``, its frame with its first and its second derivative by time, by
    the same of the frame before and of its joint; ``axes_CONVENTION``, the twists by turn and by slide of its joint. Of
    a body: `ask`, force and moment about {O}; `ask_each`, the same for every inertial parameter by itself, which is 1.
    `give`: what a joint gives to what is asked behind it, by its `axis`; `give_each`: the same for every parameter.
    `of_point`: the parameters of a mass at a point.
    """
    joint = [quantity.symbol for quantity in mechanism.joint]
    parameters = entries("p", [quantity.symbol for quantity in mechanism.link_parameters])
    orders = range(3)
    frames = [FRAME, _rates(FRAME, 1), _rates(FRAME, 2)]
    joints = [joint, _rates(joint, 1), _rates(joint, 2)]
    each = sp.Matrix(len(INERTIA), 6, lambda i, j: sp.Symbol(f"{INERTIA[i]}_{ASKED[j]}", real=True))
    inputs = entries("joint", [s for symbols in joints for s in symbols])
    inputs |= entries("frame", [s for symbols in frames for s in symbols])
    inputs |= entries("body", list(INERTIA)) | entries("gravity", list(GRAVITY))
    inputs |= (
        entries("point", list(PLACE))
        | entries("asked", list(ASKED))
        | entries("axis", list(AXIS))
        | entries("each", list(each))
    )
    functions = Functions(Graph(mechanism.steps, invariant=parameters), parameters, inputs)
    graph = functions.graph
    first, second = (dict(zip((*frames[o], *joints[o]), (*frames[o + 1], *joints[o + 1]), strict=True)) for o in (0, 1))
    for convention, screws in mechanism.transforms.items():
        rotation, origin, twist_of = vectors.follow(screws, ROTATION, ORIGIN, sp.zeros(3, 1))
        place = [graph.add(e) for e in (*origin, *rotation)]
        by_time: list[list[sp.Expr]] = [place]
        for known in (first, first | second):
            rates = graph.rates(known)
            by_time.append([graph.rate(e, rates) for e in by_time[-1]])
        functions.add(
            f"move_{convention}",
            f"a link, {convention} convention: its frame, and how that moves, by the one before",
            [e for order in orders for e in by_time[order]],
            dense=True,
        )
        steps = dict(mechanism.steps)
        twists = [sum((sp.diff(steps[s], j) * t for s, t in twist_of.items()), sp.zeros(6, 1)) for j in joint]
        functions.add(
            f"axes_{convention}",
            f"a link, {convention} convention: twists of all behind it by turn and slide of its joint",
            [e for twist in twists for e in twist],
            dense=True,
        )
    R_tt = sp.Matrix(3, 3, frames[2][3:])
    asks = asked(ORIGIN, ROTATION, sp.Matrix(frames[2][:3]), R_tt, GRAVITY)
    for name, meaning, outputs in (
        ("ask", "force that a body asks for, and its moment about {O}", asks),
        ("ask_each", "the same for each inertial parameter by itself", by_inertia(asks)),
        ("of_point", "inertial parameters of a mass of 1 kg at a point of a link", of_point(PLACE)),
        ("give", "what a joint gives to what is asked behind it", [AXIS.dot(ASKED)]),
        ("give_each", "the same for each inertial parameter", [AXIS.dot(each.row(i)) for i in range(len(INERTIA))]),
    ):
        functions.add(name, meaning, outputs, dense=True)
    functions.constants("constants", "what no pose changes of a link")
    return functions
