"""Functions of a camera's images: where directions of sight stand in them, and how a ball stands out.

A direction of sight is (x, y, 1) in the camera's frame, z along the optical axis. A lens with radial distortion k shows
it at ``u = u0 + fu x (1 + k (x^2 + y^2))``, and so v.
"""

from __future__ import annotations

import sympy as sp

from derive.backends.ir import Place
from derive.graph import Graph
from derive.mathematics.functions import Functions, entries

LENS = sp.symbols("fu fv u0 v0 k", real=True)


def images() -> list[Functions]:
    """Return the functions of images.

    `direction`: the direction of sight of a pixel, by one that is nearly right. `by_sight`: derivatives of the pixel by
    the direction. `outline`: how far inside a ball's outline a pixel lies [px], and the direction in the image that
    leads inward. `tangent`: the plane through the optical centre that touches a ball at an extreme of its outline, as a
    row of an equation for the ball's centre.
    """
    return [_lens(), _outline(), _tangent()]


def _lens() -> Functions:
    x, y, u, v = sp.symbols("x y u v", real=True)
    fu, fv, u0, v0, k = LENS
    bent = 1 + k * (x**2 + y**2)
    slopes = [sp.diff(e, s) for e in (u0 + fu * x * bent, v0 + fv * y * bent) for s in (x, y)]
    places = entries("pixel", [u, v]) | entries("sight", [x, y]) | entries("lens", LENS)
    functions = Functions(Graph(), {}, places)
    found = [(u - u0) / fu / bent, (v - v0) / fv / bent]
    functions.add("direction", "direction of sight (2, ...) of a pixel, by one that is nearly right", found)
    functions.add("by_sight", "derivatives (4, ...) of a pixel by its direction of sight", slopes)
    return functions


def _outline() -> Functions:
    x, y, radius = sp.symbols("x y radius", real=True)
    centre = sp.Matrix(sp.symbols("cx cy cz", real=True))
    J = sp.Matrix(2, 2, sp.symbols("x_u x_v y_u y_v", real=True))  # of the direction by the pixel
    sight = sp.Matrix([x, y, 1])
    off, ahead = sight.cross(centre), sight.dot(centre)
    inside = sp.asin(radius / sp.sqrt(centre.dot(centre))) - sp.atan2(sp.sqrt(off.dot(off)), ahead)
    graph = Graph()
    by_sight = graph.derivatives(inside, [x, y])
    inward = [by_sight[0] * J[0, j] + by_sight[1] * J[1, j] for j in range(2)]
    steep = graph.add(sp.sqrt(inward[0] ** 2 + inward[1] ** 2))
    places = entries("sight", [x, y]) | entries("by_pixel", list(J)) | entries("centre", list(centre))
    functions = Functions(graph, {}, places | {radius: Place("radius")})
    meaning = "how far inside a ball's outline pixels lie [px], and the direction that leads inward (3, ...)"
    functions.add("outline", meaning, [e / steep for e in (inside, *inward)])
    return functions


def _tangent() -> Functions:
    along, side, radius = sp.symbols("along side radius", real=True)
    centre = sp.Matrix(sp.symbols("c_along c_across c_depth", real=True))
    normal = sp.Matrix([-1, 0, along])  # of the plane of all sights (along, anything, 1)
    apart = sp.Matrix([side * normal.dot(centre)])
    functions = Functions(Graph(), {}, {s: Place(str(s)) for s in (along, side, radius)})
    row = [*apart.jacobian([centre[0], centre[2]]), radius * sp.sqrt(normal.dot(normal))]
    functions.add("tangent", "factors of a ball's centre, along and in depth, and what their sum is (3, ...)", row)
    return functions
