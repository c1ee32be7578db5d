"""Closed-form positions of the simplified machine, solved from the loop closure: the seeds of Newton's method.

With the small errors at zero and the platform parallel to the base, both rods of a limb obey one equation. It is
quadratic in the position (a sphere) and, for a turning joint, linear in cos and sin of the joint angle.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derive.graph import expand_steps
from derive.spec import LimbMechanism


@cache
def simplified_closure(mechanism: LimbMechanism) -> sp.Expr:
    """Return the one closure equation of a limb with small errors and the platform's rotation at zero."""
    rotation = [quantity.symbol for quantity in mechanism.platform[3:]]
    zero = dict.fromkeys((*mechanism.small, *rotation), 0)
    steps = [(symbol, e.subs(zero)) for symbol, e in mechanism.steps]
    equations = [expand_steps(e.subs(zero), steps) for e in mechanism.loop_closure]
    for other in equations[1:]:
        if sp.expand(other - equations[0]) != 0:
            raise ValueError(f"{mechanism.name}: with the small errors at zero its rods do not obey one equation.")
    return equations[0]


@cache
def sphere(mechanism: LimbMechanism) -> tuple[sp.Matrix, sp.Expr]:
    """Return centre c and constant d of the closure as a sphere, ``|P|^2/2 - c.P + d = 0``."""
    position = [quantity.symbol for quantity in mechanism.platform[:3]]
    closure = simplified_closure(mechanism)
    origin = dict.fromkeys(position, 0)
    if sp.hessian(closure, position).applyfunc(sp.simplify) != sp.eye(len(position)):
        raise ValueError(f"{mechanism.name}: the simplified closure is no sphere in the position.")
    return sp.Matrix([-sp.diff(closure, p).subs(origin) for p in position]), closure.subs(origin)


@cache
def inverse_turn(mechanism: LimbMechanism) -> sp.Expr:
    r"""Return the joint angle for a given position: the closure read as ``A cos + B sin + C = 0``.

    ``theta = atan2(-B C + A D, -A C - B D)`` with ``D = +-sqrt(A^2 + B^2 - C^2)``. This form keeps full accuracy over
    the workspace; the half-angle form loses six digits. The sign of `D` is the mechanism's `elbow`.
    """
    joint = mechanism.joint.symbol
    turn, cos, sin = sp.symbols("turn cos sin", real=True)
    offset = next(e.symbol for e in mechanism.errors if e.name == "theta")
    closure = simplified_closure(mechanism).subs(joint, turn - offset).subs({sp.cos(turn): cos, sp.sin(turn): sin})
    at_zero = {cos: 0, sin: 0}
    square = sp.diff(closure, cos, 2) / 2
    if sp.simplify(square - sp.diff(closure, sin, 2) / 2) != 0 or sp.simplify(sp.diff(closure, cos, sin)) != 0:
        raise ValueError(f"{mechanism.name}: the simplified closure is not linear in cos and sin of the joint.")
    A, B = sp.diff(closure, cos).subs(at_zero), sp.diff(closure, sin).subs(at_zero)
    C = closure.subs(at_zero) + square
    D = mechanism.elbow * sp.sqrt(A**2 + B**2 - C**2)
    return sp.atan2(-B * C + A * D, -A * C - B * D) - offset
