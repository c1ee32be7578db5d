"""Vectors and rotations, exact and smooth at zero angle."""

from __future__ import annotations

import sympy as sp

_TERMS = 9


def vector(*components: sp.Expr | int) -> sp.Matrix:
    """Return a column vector."""
    return sp.Matrix(components)


def skew(v: sp.Matrix) -> sp.Matrix:
    """Return the matrix of the cross product, ``skew(v) * w == v x w``."""
    return sp.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def _horner(coefficients: list[sp.Rational], s: sp.Expr) -> sp.Expr:
    value: sp.Expr = sp.Integer(0)
    for c in reversed(coefficients):
        value = c + s * value
    return value


def rotation_vector(v: sp.Matrix) -> sp.Matrix:
    """Return the rotation by a rotation vector, Rodrigues' formula.

    ``R = I + sin(t)/t [v] + (1 - cos(t))/t^2 [v]^2`` with ``t = |v|``. Both factors are entire functions of ``t^2``;
    they are written as their Taylor polynomials, so that value and derivatives are smooth at ``v = 0``, where every
    nominal machine stands. Nine terms leave less than 1e-16 for ``|v| <= 0.7 rad``: an assembly error of 40 degrees.
    """
    s = v.dot(v)
    sinc = _horner([sp.Rational((-1) ** k, sp.factorial(2 * k + 1)) for k in range(_TERMS)], s)
    cosc = _horner([sp.Rational((-1) ** k, sp.factorial(2 * k + 2)) for k in range(_TERMS)], s)
    K = skew(v)
    return sp.eye(3) + sinc * K + cosc * K * K


def cayley(c: sp.Matrix) -> sp.Matrix:
    """Return the rotation by a Cayley vector ``c = 2 tan(t/2) n``: rational, and equal to `n t` to second order."""
    K = skew(c)
    return sp.eye(3) + (K + K * K / 2) / (1 + c.dot(c) / 4)


def turn_about_z(t: sp.Expr) -> sp.Matrix:
    """Return the rotation about z by `t`."""
    return sp.Matrix([[sp.cos(t), -sp.sin(t), 0], [sp.sin(t), sp.cos(t), 0], [0, 0, 1]])
