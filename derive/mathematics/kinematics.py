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


def meeting(mechanism: LimbMechanism) -> list[Functions]:
    """Return where the simplified limbs `meet`, by what `sphere` gives of each, limb by limb; none without spheres."""
    if _start_of_forward(mechanism)[0] != "sphere":
        return []
    n = mechanism.commanded
    every = [sp.symbols(f"c_{i}(:{n + 1})", real=True) for i in range(mechanism.limbs)]
    found = closed_form.meet([(sp.Matrix(s[:n]), s[n]) for s in every], mechanism.assembly)
    functions = Functions(Graph(found.steps), {}, entries("spheres", [s for sphere in every for s in sphere]))
    meaning = "where the spheres meet; how far off the centres, how far these are apart, what that is compared with"
    functions.add("meet", meaning, [*found.position, found.clear, found.square, found.wide], dense=True)
    return [functions]


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


def rotations(vector: str = "c", matrix: str = "R", first: int = 0) -> list[Functions]:
    """Return a platform's rotation `matrix` by its Cayley vector, its `spin` by a change of that, the `vector` again.

    `swept` is how positions move where a body turns about the axes of {O}, `aim` the turns about z, then x, that bring
    the axis y along a line.

    Parameters
    ----------
    vector, matrix : str
        Arrays in which the vector and the matrix stand, from the entry `first` on.
    """
    c, turn, P = (sp.Matrix(sp.symbols(" ".join(f"{s}{a}" for a in "xyz"), real=True)) for s in "cwp")
    R = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"R_{i}{j}", real=True))
    by_vector = Functions(Graph(), {}, entries(vector, list(c), first))
    by_vector.add("matrix", "rotation matrix by the Cayley vector", list(vectors.cayley(c)))
    spin = vectors.turn_by_cayley(vectors.skew(c), c.dot(c))
    by_vector.add("spin", "turn about the axes of {O} by a change of the Cayley vector", list(spin))
    by_matrix = Functions(Graph(), {}, entries(matrix, list(R), first))
    by_matrix.add("vector", "Cayley vector by the rotation matrix", list(vectors.cayley_vector(R)))
    by_turn = (vectors.cayley(turn) * P).jacobian(turn).xreplace(dict.fromkeys(turn, sp.Integer(0)))
    positions = Functions(Graph(), {}, entries("p", list(P)))
    positions.add("swept", "shift of a position by turns about the axes of {O}", list(by_turn))
    # y goes to (-sin about_z cos about_x, cos about_z cos about_x, sin about_x)
    aim = [sp.atan2(-P[0], P[1]), sp.atan2(P[2], sp.sqrt(P[0] ** 2 + P[1] ** 2))]
    positions.add("aim", "turns about z, then x, that bring y along a line", aim)
    return [by_vector, by_matrix, positions]
