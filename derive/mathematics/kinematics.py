"""Functions of a machine of limbs: closures, their derivatives, and what Newton's method starts from."""

from __future__ import annotations

import sympy as sp

from derive import closed_form, vectors
from derive.backends.ir import Place
from derive.blocks import Blocks, blocks, turn_by_change
from derive.graph import Graph
from derive.mathematics.functions import Functions, entries
from derive.spec import LimbMechanism


def kinematics(mechanism: LimbMechanism) -> tuple[Functions, Blocks]:
    """Return a machine's functions of one limb, and of its limbs over lanes.

    `newton` (closure, its Jacobians by platform and joint), `parameters` (its Jacobian by errors and deflections),
    `sphere` (or `position`) and `joint` (the seeds), `constants`. What a command needs comes first, so that it reads
    the first columns of the constants only.
    """
    platform = [quantity.symbol for quantity in mechanism.platform]
    joint = mechanism.joint.symbol
    varied = [quantity.symbol for quantity in mechanism.varied]
    inputs = entries("x", platform) | entries("tool", [s.symbol for s in mechanism.tool]) | {joint: Place("q")}
    parameters = entries("p", [s.symbol for s in mechanism.limb_parameters])
    graph = Graph(mechanism.steps, invariant=parameters)
    functions = Functions(graph, parameters, inputs)
    newton: list[sp.Expr] = []
    errors: list[sp.Expr] = []
    for closure in mechanism.loop_closure:
        by = graph.derivatives(closure, [*platform, joint, *varied])
        newton += [closure, *by[: len(platform) + 1]]
        errors += by[len(platform) + 1 :]
    functions.add(
        "newton", "per rod of one limb: closure, its derivatives by the platform, by the joint", newton, dense=True
    )
    functions.add(
        "joint",
        "joint of the simplified limb at a given position, then the platform's coordinates that follow from it",
        closed_form.start_of_inverse(mechanism),
        dense=True,
    )
    functions.add("parameters", "per rod of one limb: derivatives of the closure by errors, by deflections", errors)
    meaning, start = _start_of_forward(mechanism)
    functions.add("position" if mechanism.seeds is not None else "sphere", meaning, start, dense=True)
    if turns := turn_by_change(mechanism):
        functions.add("spin", "turn about the axes of {O} by the Cayley vector", turns, dense=True)
    batch = blocks(mechanism, meaning, start, functions)
    functions.constants("constants", "what no pose changes")
    return functions, batch


def _start_of_forward(mechanism: LimbMechanism) -> tuple[str, list[sp.Expr]]:
    """Return what the forward position starts from, its meaning and expressions: spheres, or what the spec gives."""
    if mechanism.seeds is not None:
        position = [mechanism.seeds.get(quantity.symbol, sp.Integer(0)) for quantity in mechanism.platform]
        return "platform of the simplified machine at a given joint", position
    centre, constant = closed_form.sphere(mechanism)
    return "the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d", [*centre, 2 * constant]


def rotations() -> list[Functions]:
    """Return a platform's rotation `matrix` by its Cayley vector, and the `vector` by the matrix."""
    c = sp.Matrix(sp.symbols("cx cy cz", real=True))
    R = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"R_{i}{j}", real=True))
    by_vector = Functions(Graph(), {}, entries("own", list(c), 3))
    by_vector.add("matrix", "rotation matrix by the Cayley vector", list(vectors.cayley(c)))
    by_matrix = Functions(Graph(), {}, entries("pose", list(R), 3))
    by_matrix.add("vector", "Cayley vector by the rotation matrix", list(vectors.cayley_vector(R)))
    return [by_vector, by_matrix]
