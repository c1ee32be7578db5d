"""Functions of a machine of limbs: closures, their derivatives, and what Newton's method starts from."""

from __future__ import annotations

import math

import sympy as sp

from derive import closed_form, vectors
from derive.backends.ir import Place
from derive.blocks import Blocks, blocks, turn_by_change
from derive.graph import Graph
from derive.mathematics.functions import Functions, entries
from derive.spec import LimbMechanism

DEG = sp.Float(math.pi / 180)
LEAST = 1e-150  # rad: a turn, so that none has an axis all the same


def kinematics(mechanism: LimbMechanism) -> tuple[Functions, Blocks]:
    """Return a machine's functions of one limb, and of its limbs over lanes.

    `newton` (closure, its Jacobians by platform and joint), `parameters` (its Jacobian by errors and deflections),
    `sphere`, `position` or `home`, and `joint` (what Newton's method starts from), `constants`. What a command needs
    comes first, so that it reads the first columns of the constants only.
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
    name, meaning, start = _start_of_forward(mechanism)
    functions.add(name, meaning, start, dense=True)
    if turns := turn_by_change(mechanism):
        functions.add("spin", "turn about the axes of {O} by the Cayley vector", turns, dense=True)
    batch = blocks(mechanism, meaning, start, functions)
    functions.constants("constants", "what no pose changes")
    return functions, batch


def _start_of_forward(mechanism: LimbMechanism) -> tuple[str, str, list[sp.Expr]]:
    """Return what the forward position starts from: name, meaning, expressions of spheres or of what the spec gives."""
    for name, meaning, given in (
        ("position", "platform of the simplified machine at a given joint", mechanism.seeds),
        ("home", "platform at home, whatever the joint", mechanism.home),
    ):
        if given is not None:
            return name, meaning, [sp.sympify(given.get(q.symbol, 0)) for q in mechanism.platform]
    centre, constant = closed_form.sphere(mechanism)
    return "sphere", "the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d", [*centre, 2 * constant]


def stated(mechanism: LimbMechanism) -> Functions:
    """Return the commanded coordinates by a target as files state it: position [mm], rotation vector [deg]."""
    commanded = [quantity.symbol for quantity in mechanism.platform[: mechanism.commanded]]
    turns = [s for s in commanded if str(s)[0] == "c"]
    vector = {s: DEG * s for s in turns}
    turn = sp.sqrt(sum((v**2 for v in vector.values()), sp.Float(LEAST**2)))
    known = {s: 2 * sp.tan(turn / 2) / turn * v for s, v in vector.items()}
    functions = Functions(Graph(), {}, entries("x", commanded))
    meaning = "coordinates of a target: position [mm], rotation vector [deg]"
    functions.add("stated", meaning, [known.get(s, s) for s in commanded], dense=True)
    return functions


def rotations() -> list[Functions]:
    """Return a platform's rotation `matrix` by its Cayley vector, and the `vector` by the matrix."""
    c = sp.Matrix(sp.symbols("cx cy cz", real=True))
    R = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"R_{i}{j}", real=True))
    by_vector = Functions(Graph(), {}, entries("own", list(c), 3))
    by_vector.add("matrix", "rotation matrix by the Cayley vector", list(vectors.cayley(c)))
    by_matrix = Functions(Graph(), {}, entries("pose", list(R), 3))
    by_matrix.add("vector", "Cayley vector by the rotation matrix", list(vectors.cayley_vector(R)))
    return [by_vector, by_matrix]
