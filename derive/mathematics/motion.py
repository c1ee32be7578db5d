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
from derive.mathematics.kinematics import LEAST
from derive.spec import ChainMechanism

GRAVITY = sp.Matrix(sp.symbols("gx gy gz", real=True))
AXIS = sp.Matrix(sp.symbols("ux uy uz wx wy wz", real=True))  # a joint's twist: shift of {O}'s origin, turn
ASKED = (*FORCE, *MOMENT)
TOOL = sp.Matrix(sp.symbols("tool_x tool_y tool_z", real=True))  # in the last frame
VECTOR = sp.Matrix(sp.symbols("vx vy vz", real=True))  # rad
TARGET = sp.symbols("target(:12)", real=True)  # where the tool point shall be, and the last frame's rotation


def _rates(symbols: list[sp.Symbol], order: int) -> list[sp.Symbol]:
    """Return the symbols of derivatives by time."""
    return [sp.Symbol(f"{s}_{'t' * order}", real=True) for s in symbols]


def motion(mechanism: ChainMechanism) -> Functions:
    """Return a chain's functions in motion.

    Of a link, for each convention: ``move_CONVENTION``, its frame with its first and its second derivative by time, by
    the same of the frame before and of its joint; ``axes_CONVENTION``, the twists by turn and by slide of its joint. Of
    a body: `ask`, force and moment about {O}; `ask_each`, the same for every inertial parameter by itself, which is 1.
    `give`: what a joint gives to what is asked behind it, by its `axis`; `give_each`: the same for every parameter.
    `of_point`: the parameters of a mass at a point. Of the tool, along the axes of {O}, shift before turn: `missed`,
    from where it is to a target; `tip`, its twist by a joint's; `led`, how it accelerates; `turned`: the rotation by a
    rotation vector.
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
        | entries("tool", list(TOOL))
        | entries("target", list(TARGET))
        | entries("vector", list(VECTOR))
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
        *_of_tool(frames[2]),
    ):
        functions.add(name, meaning, outputs, dense=True)
    functions.constants("constants", "what no pose changes of a link")
    return functions


def _of_tool(accelerations: list[sp.Symbol]) -> list[tuple[str, str, list[sp.Expr]]]:
    """Return the functions of the tool in the last frame: name, meaning, outputs."""
    R, R_tt, asked_R = ROTATION, sp.Matrix(3, 3, accelerations[3:]), sp.Matrix(3, 3, TARGET[3:])
    point, turn = ORIGIN + R * TOOL, sp.Matrix(AXIS[3:])
    t = sp.sqrt(VECTOR.dot(VECTOR) + sp.Float(LEAST**2))
    turned = vectors.about(vectors.skew(VECTOR), sp.sin(t) / t, 2 * (sp.sin(t / 2) / t) ** 2)
    return [
        (
            "missed",
            "how the tool misses a target: shift, and turn to first order",
            [*(sp.Matrix(TARGET[:3]) - point), *vectors.axial(asked_R * R.T)],
        ),
        ("tip", "twist of the tool point by that of a joint", [*(sp.Matrix(AXIS[:3]) + turn.cross(point)), *turn]),
        (
            "led",
            "how the tool accelerates",
            [*(sp.Matrix(accelerations[:3]) + R_tt * TOOL), *vectors.axial(R_tt * R.T)],
        ),
        ("turned", "rotation by a rotation vector, row by row", list(turned)),
    ]
