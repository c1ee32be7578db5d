"""Vectors and rotations, exact and smooth at zero angle."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from derive.spec import Screw

Matrix = Any  # entries, or a matrix symbol

_TERMS = 9
ANGLE = sp.Symbol("t", positive=True)
RODRIGUES = (sp.sin(ANGLE) / ANGLE, (1 - sp.cos(ANGLE)) / ANGLE**2)  # factors of [v] and [v]^2, by the angle t = |v|


def vector(*components: sp.Expr | int) -> sp.Matrix:
    """Return a column vector."""
    return sp.Matrix(components)


def skew(v: sp.Matrix) -> sp.Matrix:
    """Return the matrix of the cross product, ``skew(v) * w == v x w``."""
    return sp.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def axial(K: sp.Matrix) -> sp.Matrix:
    """Return the vector whose `skew` is the skew part of a matrix."""
    return sp.Matrix([K[2, 1] - K[1, 2], K[0, 2] - K[2, 0], K[1, 0] - K[0, 1]]) / 2


def _horner(coefficients: list[sp.Rational], s: sp.Expr) -> sp.Expr:
    value: sp.Expr = sp.Integer(0)
    for c in reversed(coefficients):
        value = c + s * value
    return value


@cache
def _taylor(f: sp.Expr) -> list[sp.Rational]:
    """Return the first Taylor coefficients of an entire function of the squared angle."""
    series = sp.series(f, ANGLE, 0, 2 * _TERMS).removeO()
    return [series.coeff(ANGLE, 2 * k) for k in range(_TERMS)]


def about(K: Matrix, sinc: sp.Expr, cosc: sp.Expr) -> Matrix:
    """Return Rodrigues' formula for ``K = [v]``: entries, or a matrix symbol."""
    return sp.eye(3) + sinc * K + cosc * K * K


def rotation_vector(v: sp.Matrix) -> sp.Matrix:
    """Return the rotation by a rotation vector, Rodrigues' formula.

    ``R = I + sin(t)/t [v] + (1 - cos(t))/t^2 [v]^2`` with ``t = |v|``. Both factors are entire functions of ``t^2``;
    they are written as their Taylor polynomials, so that value and derivatives are smooth at ``v = 0``, where every
    nominal machine stands. Nine terms leave less than 1e-16 for ``|v| <= 0.7 rad``: an assembly error of 40 degrees.
    """
    s = v.dot(v)
    return about(skew(v), *(_horner(_taylor(f), s) for f in RODRIGUES))


def by_cayley(K: Matrix, s: sp.Expr) -> Matrix:
    """Return the rotation by a Cayley vector with ``K = [c]`` and ``s = c.c``: entries, or symbols."""
    return sp.eye(3) + (K + K * K / 2) / (1 + s / 4)


def turn_by_cayley(K: Matrix, s: sp.Expr) -> Matrix:
    """Return how a rotation turns about the axes of the base frame by its Cayley vector, in terms of `by_cayley`."""
    return (sp.eye(3) + K / 2) / (1 + s / 4)


def cayley(c: sp.Matrix) -> sp.Matrix:
    """Return the rotation by a Cayley vector ``c = 2 tan(t/2) n``: rational, and equal to `n t` to second order."""
    return by_cayley(skew(c), c.dot(c))


def cayley_vector(R: sp.Matrix) -> sp.Matrix:
    """Return the Cayley vector of a rotation by less than half a turn, from its matrix: the inverse of `cayley`."""
    return 2 / (1 + R.trace()) * (2 * axial(R))


def turn_about_z(t: sp.Expr) -> sp.Matrix:
    """Return the rotation about z by `t`."""
    return sp.Matrix([[sp.cos(t), -sp.sin(t), 0], [sp.sin(t), sp.cos(t), 0], [0, 0, 1]])


def turn_about_x(t: sp.Expr) -> sp.Matrix:
    """Return the rotation about x by `t`."""
    return sp.Matrix([[1, 0, 0], [0, sp.cos(t), -sp.sin(t)], [0, sp.sin(t), sp.cos(t)]])


def turn_about_y(t: sp.Expr) -> sp.Matrix:
    """Return the rotation about y by `t`."""
    return sp.Matrix([[sp.cos(t), 0, sp.sin(t)], [0, 1, 0], [-sp.sin(t), 0, sp.cos(t)]])


@dataclass(frozen=True)
class Algebra:
    """The rotations in which machines and instruments are written down: exact matrices, or names that a report reads.

    Attributes
    ----------
    rotation_vector, cayley : callable
        Rotation (3, 3) by a vector (3, 1).
    turn_about_x, turn_about_y, turn_about_z : callable
        Rotation (3, 3) by an angle.
    """

    rotation_vector: Callable[[sp.Matrix], sp.Matrix]
    cayley: Callable[[sp.Matrix], sp.Matrix]
    turn_about_x: Callable[[sp.Expr], sp.Matrix]
    turn_about_y: Callable[[sp.Expr], sp.Matrix]
    turn_about_z: Callable[[sp.Expr], sp.Matrix]


EXACT = Algebra(rotation_vector, cayley, turn_about_x, turn_about_y, turn_about_z)


def follow(
    screws: Sequence[Screw],
    rotation: sp.Matrix | None = None,
    origin: sp.Matrix | None = None,
    end: sp.Matrix | None = None,
) -> tuple[sp.Matrix, sp.Matrix, dict[sp.Expr, sp.Matrix]]:
    """Return rotation (3, 3) and origin (3, 1) behind screws one after the other, and the twist (6, 1) by each of them.

    All of it along the axes in which the frame before the first screw has this `rotation` and `origin`: its own, unless
    they are given. A turn or a shift moves all that comes behind it as a rigid body: a turn by w shifts the `end`, by
    default that of the last screw, by ``w x (end - axis)``. A twist is the shift of the end and the turn.
    """
    about = {"x": turn_about_x, "y": turn_about_y, "z": turn_about_z}
    rotation = sp.eye(3) if rotation is None else rotation
    at = sp.zeros(3, 1) if origin is None else origin
    moved: list[tuple[sp.Expr, sp.Matrix, sp.Matrix | None]] = []  # variable, its axis, a point of it where it turns
    for screw in screws:
        axis = rotation[:, "xyz".index(screw.axis)]
        moved += [(screw.turn, axis, at), (screw.shift, axis, None)]
        rotation, at = rotation * about[screw.axis](screw.turn), at + axis * screw.shift
    end = at if end is None else end
    twists = {
        by: sp.Matrix.vstack(axis, sp.zeros(3, 1)) if point is None else sp.Matrix.vstack(axis.cross(end - point), axis)
        for by, axis, point in moved
        if by != 0
    }
    return rotation, at, twists


def angle(A: sp.Expr, B: sp.Expr, C: sp.Expr, side: int) -> sp.Expr:
    r"""Return the angle with ``A cos + B sin + C = 0``; `side`, +1 or -1, chooses between the two.

    ``atan2(-B C + A D, -A C - B D)`` with ``D = +-sqrt(A^2 + B^2 - C^2)``: full accuracy for every angle, where the
    half-angle form loses six digits.
    """
    D = side * sp.sqrt(A**2 + B**2 - C**2)
    return sp.atan2(-B * C + A * D, -A * C - B * D)
