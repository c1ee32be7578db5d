"""What moving bodies ask of those that carry them: d'Alembert's principle on any point of a body, summed over its mass.

A point of a body with the mass element dm asks for the force ``dm (p'' - g)`` and its moment about {O}. Both are
polynomials of second order in the point's place in the body's frame, so that the sum over the body needs no more than
its moments of order 0, 1 and 2: mass, first moments, tensor of inertia. All of them enter linearly.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

MM = sp.Rational(1, 1000)  # an acceleration of mm/s^2 in m/s^2 = N/kg

PLACE = sp.Matrix(sp.symbols("rx ry rz", real=True))  # of a point in its body's frame
MASS = sp.Symbol("m", real=True)
FIRST = sp.Matrix(sp.symbols("m_x m_y m_z", real=True))  # moments of first order about the frame's origin
IXX, IYY, IZZ, IXY, IXZ, IYZ = sp.symbols("ixx iyy izz ixy ixz iyz", real=True)  # the tensor about the same
INERTIA = (MASS, *FIRST, IXX, IYY, IZZ, IXY, IXZ, IYZ)
_TENSOR = sp.Matrix([[IXX, IXY, IXZ], [IXY, IYY, IYZ], [IXZ, IYZ, IZZ]])
SECOND = _TENSOR.trace() / 2 * sp.eye(3) - _TENSOR  # moments of second order: the tensor is tr(S) 1 - S


def over_mass(density: sp.Expr) -> sp.Expr:
    """Return the sum over a body of what one of its points adds per mass, a polynomial of second order in `PLACE`."""
    at_origin = dict.fromkeys(PLACE, 0)
    parts = [MASS * density.xreplace(at_origin)]
    for i, x in enumerate(PLACE):
        slope = sp.diff(density, x)
        parts.append(FIRST[i] * slope.xreplace(at_origin))
        parts += [SECOND[i, j] / 2 * sp.diff(slope, y) for j, y in enumerate(PLACE)]
    return sp.Add(*parts)


def asked(
    origin: sp.Matrix, rotation: sp.Matrix, origin_tt: sp.Matrix, rotation_tt: sp.Matrix, gravity: sp.Matrix
) -> list[sp.Expr]:
    """Return the force that a body asks for and its moment about {O}, six numbers [N, N mm].

    Parameters
    ----------
    origin, rotation : (3, 1), (3, 3) matrices
        The body's frame in {O} [mm].
    origin_tt, rotation_tt : (3, 1), (3, 3) matrices
        Their second derivatives by time.
    gravity : (3, 1) matrix
        In {O} [m/s^2].
    """
    at_origin, slope = (sp.Matrix(r, c, lambda i, j: sp.Dummy(real=True)) for r, c in ((3, 1), (3, 3)))
    field, arm = at_origin + slope * PLACE, rotation * PLACE
    force = sp.Matrix([over_mass(e) for e in field])
    own = [sp.collect(sp.expand(over_mass(e)), [*slope, *at_origin]) for e in arm.cross(field)]
    known = dict(zip([*at_origin, *slope], [*(MM * origin_tt - gravity), *(MM * rotation_tt)], strict=True))
    return [e.xreplace(known) for e in (*force, *(origin.cross(force) + sp.Matrix(own)))]


def by_inertia(asks: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return what each of a body's inertial parameters adds to what it asks for, parameter by parameter."""
    return [sp.diff(e, s) for s in INERTIA for e in asks]


def of_point(place: sp.Matrix) -> list[sp.Expr]:
    """Return the inertial parameters of a mass of 1 kg at a place in a frame."""
    squares = place * place.T
    tensor = squares.trace() * sp.eye(3) - squares
    return [sp.Integer(1), *place, *(tensor[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))]
