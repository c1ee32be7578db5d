"""Functions of a link of an open chain, of any convention: links are put one behind the other by a loop over them."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from derive import vectors
from derive.graph import Graph
from derive.mathematics.functions import Functions, entries
from derive.spec import ChainMechanism

ORIGIN = sp.Matrix(sp.symbols("ox oy oz", real=True))
ROTATION = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"R_{i}{j}", real=True))
POINT = sp.Matrix(sp.symbols("px py pz", real=True))
FORCE, MOMENT = sp.Matrix(sp.symbols("fx fy fz", real=True)), sp.Matrix(sp.symbols("mx my mz", real=True))
CENTRE = sp.Matrix(sp.symbols("cx cy cz", real=True))  # of mass, in the link's frame
FRAME = [*ORIGIN, *ROTATION]  # a frame in {O}, as it stands in an array: origin, rotation row by row


def links(mechanism: ChainMechanism) -> Functions:
    """Return a chain's functions.

    Of a link, for each convention: ``place_CONVENTION``, its frame by the `frame` before it; and ``reach_CONVENTION``,
    the same, then how errors and joint move a `point` of the chain behind the link: for each of them a shift of the
    point and a turn, along the axes of the base. Of the last frame: `tip`, where the tool point is, and `reach_tip`,
    how errors of the tool move it. All of them share `constants`, what no pose changes of a link.

    What weights exert follows by virtual work, from the last link to the first: ``exert_CONVENTION``, the work that the
    `load` of a link and all behind it does along its errors and its joint's motion. A load is a force and its moment;
    `centre` is where a link's weight acts, `moment` that of a force at a point.
    """
    tool = [quantity.symbol for quantity in mechanism.tool]
    common = [quantity.symbol for quantity in mechanism.common]
    parameters = entries("p", [quantity.symbol for quantity in mechanism.link_parameters])
    inputs = entries("joint", [quantity.symbol for quantity in mechanism.joint]) | entries("frame", FRAME)
    inputs |= entries("point", list(POINT)) | entries("tool", tool) | entries("centre", list(CENTRE))
    inputs |= entries("load", [*FORCE, *MOMENT])
    functions = Functions(Graph(mechanism.steps, invariant=parameters), parameters, inputs)
    for convention in mechanism.transforms:
        _link(functions, mechanism, convention)
    tip = ORIGIN + ROTATION * sp.Matrix([s + e for s, e in zip(tool, common, strict=True)])
    by_tool = [sp.diff(entry, e) for e in common for entry in (*tip, 0, 0, 0)]
    centre, moment = ORIGIN + ROTATION * CENTRE, POINT.cross(FORCE)
    for name, meaning, outputs in (
        ("tip", "position of the tool point by the last frame", [*tip]),
        ("reach_tip", "shift of the tool point and turn by each error of the tool", by_tool),
        ("centre", "where a link's weight acts, by its frame", [*centre]),
        ("moment", "moment about {O} of a force at a point", [*moment]),
    ):
        functions.add(name, meaning, outputs, dense=True)
    functions.constants("constants", "what no pose changes of a link")
    return functions


def _link(functions: Functions, mechanism: ChainMechanism, convention: str) -> None:
    """Add the functions of a link of a convention."""
    errors, joint = ([quantity.symbol for quantity in some] for some in (mechanism.errors, mechanism.joint))

    def placed(point: sp.Matrix, by: Sequence[sp.Symbol]) -> tuple[list[sp.Expr], list[sp.Matrix]]:
        """Return the frame behind the link, and the twist of a point by each symbol."""
        rotation, origin, by_step = vectors.follow(mechanism.transforms[convention], ROTATION, ORIGIN, point)
        parts = ([sp.diff(added, s) * by_step[step] for step, added in mechanism.steps] for s in by)
        return [*origin, *rotation], [sum(part, sp.zeros(6, 1)) for part in parts]

    frame, twists = placed(POINT, [*errors, *joint])
    _, at_base = placed(sp.zeros(3, 1), [*errors, *joint])
    for name, meaning, outputs in (
        ("place", "its frame by the one before", frame),
        (
            "reach",
            "its frame; shift of a point behind it and turn, by each error, by turn and slide of the joint",
            [*frame, *(entry for twist in twists for entry in twist)],
        ),
        (
            "exert",
            "work of the load of all that it carries by each error, by turn and slide of its joint",
            [twist.dot([*FORCE, *MOMENT]) for twist in at_base],
        ),
    ):
        functions.add(f"{name}_{convention}", f"a link, {convention} convention: {meaning}", outputs, dense=True)
