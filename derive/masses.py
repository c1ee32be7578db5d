"""The bodies of machines with arms and rods, as points with masses, for all mechanisms that have such parts."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from derive.spec import OWN, SHARE, Inertial

PROXIMAL, CENTRE, CARRIAGE, ROD, BODY = sp.symbols("proximal proximal_com carriage distal_rod platform", real=True)


def of_arm(joint: sp.Matrix, line: sp.Matrix, length: sp.Expr, drawn: sp.Expr) -> tuple[Inertial, ...]:
    """Return the parameters of an arm that turns about a point of the base: points a length either side of it.

    Parameters
    ----------
    joint, line : (3, 1) matrices
        Where it turns, and its direction.
    length, drawn : sympy.Expr
        As it is, and as the robot file has it, of which the centre of mass is a part.
    """
    return _turning("arm", "the arm", joint, line, length, drawn)


def of_leg(low: sp.Matrix, high: sp.Matrix, line: sp.Matrix, drawn: sp.Expr) -> tuple[Inertial, ...]:
    """Return the parameters of a leg of two parts: one turns about its low end, the other slides out, a thin rod.

    Both are as long as the leg is drawn in. The lower part's mass at its joint, which stands, moves nothing.
    """
    lower = _turning("lower", "the leg's lower part", low, line, drawn, drawn)
    return *lower[1:], of_rods([(high - drawn * line, high)], "mass of the leg's upper part")


def _turning(
    name: str, words: str, joint: sp.Matrix, line: sp.Matrix, length: sp.Expr, drawn: sp.Expr
) -> tuple[Inertial, ...]:
    """Return mass, first moment and inertia of a body that turns about a joint: points a length either side of it."""
    ends = joint + length * line, joint - length * line
    turning = tuple((side / (2 * length), end) for side, end in zip((1, -1), ends, strict=True))
    spread = tuple((1 / (2 * length**2), end) for end in ends)
    centre = CENTRE * drawn
    return (
        Inertial(f"m_{name}", "kg", f"mass of {words}, at its joint", ((sp.Integer(1), joint),), PROXIMAL),
        Inertial(f"mx_{name}", "kg mm", f"its first moment along {words}", turning, PROXIMAL * centre),
        Inertial(f"i_{name}", "kg mm^2", "its inertia about the joint", spread, OWN + PROXIMAL * centre**2),
    )


def of_rods(ends: Sequence[tuple[sp.Matrix, sp.Matrix]], meaning: str, each: int = 1) -> Inertial:
    """Return the mass of rods between points, each standing for as many: at the ends and in the middle.

    A uniform rod has a sixth of its mass at either end (Simpson's rule); what other inertia it has is another share.
    """
    parts = (each * SHARE, each * (1 - 2 * SHARE), each * SHARE)
    points = [pair for a, b in ends for pair in zip(parts, (a, (a + b) / 2, b), strict=True)]
    return Inertial("m_rod", "kg", meaning, tuple(points), ROD)


def of_platform(centre: sp.Matrix, P: sp.Matrix) -> tuple[Inertial, Inertial]:
    """Return the mass of a platform at its centre, and of a payload at the reference point."""
    return (
        Inertial("m_platform", "kg", "mass of the platform, at its centre", ((sp.Integer(1), centre),), BODY),
        Inertial("payload", "kg", "mass at the reference point", ((sp.Integer(1), P),)),
    )
