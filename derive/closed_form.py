"""Closed-form positions of the simplified machine, solved from the loop closure: the seeds of Newton's method.

With the small errors at zero and the platform parallel to the base, the rods of a limb obey one equation. It is
quadratic in the position (a sphere, in the plane a circle) and, for a turning joint, linear in cos and sin of its
angle, for a sliding one quadratic.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from derive.graph import expand_steps
from derive.spec import LimbMechanism
from derive.vectors import Matrix, angle


@cache
def simplified_closure(mechanism: LimbMechanism) -> sp.Expr:
    """Return the one closure equation of a limb with small errors and the platform's rotation at zero."""
    held = [quantity.symbol for quantity in mechanism.platform[mechanism.commanded :]]
    zero = dict.fromkeys((*mechanism.small, *held), 0)
    steps = [(symbol, e.subs(zero)) for symbol, e in mechanism.steps]
    equations = [expand_steps(e.subs(zero), steps) for e in mechanism.loop_closure]
    for other in equations[1:]:
        if sp.expand(other - equations[0]) != 0:
            raise ValueError(f"{mechanism.name}: with the small errors at zero its rods do not obey one equation.")
    return equations[0]


def as_sphere(P: Matrix, c: Matrix, d: Matrix) -> Matrix:
    """Return ``|P|^2/2 - c.P + d``, zero on a sphere about c: of columns and a (1, 1) matrix, or of symbols."""
    return P.T * P / 2 - c.T * P + d


@cache
def sphere(mechanism: LimbMechanism) -> tuple[sp.Matrix, sp.Expr]:
    """Return centre c and constant d of the closure as a sphere, see `as_sphere`."""
    position = [quantity.symbol for quantity in mechanism.platform[: mechanism.commanded]]
    closure = simplified_closure(mechanism)
    origin = dict.fromkeys(position, 0)
    if sp.hessian(closure, position).applyfunc(sp.simplify) != sp.eye(len(position)):
        raise ValueError(f"{mechanism.name}: the simplified closure is no sphere in the position.")
    return sp.Matrix([-sp.diff(closure, p).subs(origin) for p in position]), closure.subs(origin)


def start_of_inverse(mechanism: LimbMechanism) -> list[sp.Expr]:
    """Return the joint of the simplified limb for a given position, then the coordinates that no command asks for.

    Where the limbs are spheres the latter are rotations, which are zero, and left out.
    """
    joint = inverse_joint(mechanism)
    if mechanism.seeds is None:
        return [joint]
    return [joint, *(e.xreplace({mechanism.joint.symbol: joint}) for e in uncommanded(mechanism).values())]


def uncommanded(mechanism: LimbMechanism) -> dict[sp.Symbol, sp.Expr]:
    """Return the coordinates that no command asks for, of the simplified machine, in terms of the joint."""
    seeds = mechanism.seeds or {}
    held = (quantity.symbol for quantity in mechanism.platform[mechanism.commanded :])
    return {s: expand_steps(sp.sympify(seeds.get(s, 0)), mechanism.steps) for s in held}


@cache
def inverse_joint(mechanism: LimbMechanism) -> sp.Expr:
    """Return the joint of the simplified limb for a given position; raises ValueError where none is found.

    `mechanism.elbow` chooses between the two solutions of a turning joint, or of a sliding one.
    """
    if mechanism.seeds is not None:
        return mechanism.seeds[mechanism.joint.symbol]
    joint = mechanism.joint.symbol
    closure = simplified_closure(mechanism)
    turns = {f.args[0] for f in closure.atoms(sp.cos, sp.sin) if f.has(joint)}
    if not turns:
        return _slide(mechanism, closure)
    if len(turns) > 1 or sp.diff(*turns, joint) != 1:
        raise ValueError(f"{mechanism.name}: the simplified closure turns by {turns}, not by one joint plus an offset.")
    return _turn(mechanism, closure, turns.pop() - joint)


def _slide(mechanism: LimbMechanism, closure: sp.Expr) -> sp.Expr:
    joint = mechanism.joint.symbol
    A, B, C = (sp.diff(closure, joint, n).subs(joint, 0) / sp.factorial(n) for n in (2, 1, 0))
    if sp.simplify(sp.diff(closure, joint, 3)) != 0 or sp.simplify(A) == 0:
        raise ValueError(f"{mechanism.name}: the simplified closure is not quadratic in its sliding joint.")
    half = B / (2 * A)
    return -half + mechanism.elbow * sp.sqrt(half**2 - C / A)


def _turn(mechanism: LimbMechanism, closure: sp.Expr, offset: sp.Expr) -> sp.Expr:
    """Read the closure as ``A cos + B sin + C = 0``."""
    turn, cos, sin = sp.symbols("turn cos sin", real=True)
    closure = closure.subs(mechanism.joint.symbol, turn - offset).subs({sp.cos(turn): cos, sp.sin(turn): sin})
    at_zero = {cos: 0, sin: 0}
    square = sp.diff(closure, cos, 2) / 2
    if sp.simplify(square - sp.diff(closure, sin, 2) / 2) != 0 or sp.simplify(sp.diff(closure, cos, sin)) != 0:
        raise ValueError(f"{mechanism.name}: the simplified closure is not linear in cos and sin of the joint.")
    A, B = sp.diff(closure, cos).subs(at_zero), sp.diff(closure, sin).subs(at_zero)
    return angle(A, B, closure.subs(at_zero) + square, mechanism.elbow) - offset
