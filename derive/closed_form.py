"""Closed-form positions of the simplified machine, solved from the loop closure: the seeds of Newton's method.

With the small errors at zero and the platform parallel to the base, the rods of a limb obey one equation. It is
quadratic in the position (a sphere, in the plane a circle) and, for a turning joint, linear in cos and sin of its
angle, for a sliding one quadratic.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import sympy as sp

from derive.graph import Steps, expand_steps
from derive.spec import LimbMechanism
from derive.vectors import Matrix, angle

ZERO = 1e-9  # of expressions in small numbers: rounding is some 1e-15


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


def vanishes(matrix: sp.Matrix) -> bool:
    """Whether a matrix is zero for all values of its symbols: simplified only where it is at values of no symmetry."""
    values = {s: sp.Rational(k + 2, 17 + 6 * k) for k, s in enumerate(sorted(matrix.free_symbols, key=str))}
    return all(abs(sp.N(e.xreplace(values))) < ZERO for e in matrix) and bool(
        matrix.applyfunc(sp.simplify).is_zero_matrix
    )


@cache
def sphere(mechanism: LimbMechanism) -> tuple[sp.Matrix, sp.Expr]:
    """Return centre c and constant d of the closure as a sphere, see `as_sphere`."""
    position = [quantity.symbol for quantity in mechanism.platform[: mechanism.commanded]]
    closure = simplified_closure(mechanism)
    origin = dict.fromkeys(position, 0)
    bent = sp.hessian(closure, position) - sp.eye(len(position))
    if not vanishes(bent):
        raise ValueError(f"{mechanism.name}: the simplified closure is no sphere in the position.")
    return sp.Matrix([-sp.diff(closure, p).subs(origin) for p in position]), closure.subs(origin)


@dataclass(frozen=True)
class Meeting:
    """Where spheres meet, in terms of `steps`.

    Attributes
    ----------
    position : sympy.Matrix
    clear : sympy.Expr
        Squared distance of the position from the centres' line or plane; negative where there is none.
    square, wide : sympy.Expr
        How far the centres lie apart, and what that is compared with: of three, squared products of two sides, so that
        the ratio is a squared sine; of two, squared distances, of one from the other and of both from the origin.
    """

    steps: Steps
    position: sp.Matrix
    clear: sp.Expr
    square: sp.Expr
    wide: sp.Expr


def meet(spheres: Sequence[tuple[sp.Matrix, sp.Expr]], side: int) -> Meeting:
    """Return where spheres ``|P|^2 - 2 c.P + d = 0`` meet: three in space, or two circles in the plane.

    Their differences, ``a.P = (d_i - d_0) / 2`` with ``a = c_i - c_0``, meet in a line along n, on which the first
    sphere is a quadratic. Where the line misses it the nearest point is taken: the exact machine may still reach what
    the simplified one cannot.

    Parameters
    ----------
    spheres : sequence of (sympy.Matrix, sympy.Expr)
        Centre c and constant d of each.
    side : {+1, -1}
        Which of the two points, counted along n turned so that its last component is positive.
    """
    steps: list[tuple[sp.Symbol, sp.Expr]] = []

    def named(name: str, value: sp.Expr) -> sp.Symbol:
        steps.append((sp.Symbol(name, real=True), value))
        return steps[-1][0]

    def vector(name: str, value: sp.Matrix) -> sp.Matrix:
        return sp.Matrix([named(f"{name}_{axis}", entry) for axis, entry in zip("xyz", value, strict=False)])

    (first, constant), *others = spheres
    a = [vector(name, centre - first) for name, (centre, _) in zip("ab", others, strict=False)]
    to = [named(f"to_{name}", (d - constant) / 2) for name, (_, d) in zip("ab", others, strict=False)]
    aa = named("aa", a[0].dot(a[0]))
    if len(a) == 1:
        n, square = sp.Matrix([-a[0][1], a[0][0]]), aa
        wide = first.dot(first) + others[0][0].dot(others[0][0])
        foot = [to[0]]
    else:
        n = vector("n", a[0].cross(a[1]))
        square, bb, ab = named("nn", n.dot(n)), named("bb", a[1].dot(a[1])), named("ab", a[0].dot(a[1]))
        wide = aa * bb
        foot = [to[0] * bb - to[1] * ab, to[1] * aa - to[0] * ab]  # Gram's equations: their determinant is |n|^2
    inverse = named("inverse", 1 / square)
    shares = [named(f"by_{name}", share * inverse) for name, share in zip("ab", foot, strict=False)]
    p = vector("p", sum((share * side_ for share, side_ in zip(shares, a, strict=True)), sp.zeros(len(first), 1)))
    half = named("half", (p - first).dot(n) * inverse)
    rest = named("rest", p.dot(p) - 2 * first.dot(p) + constant)
    under = named("under", half**2 - rest * inverse)
    root = sp.sqrt(named("kept", sp.Piecewise((under, under > 0), (0, True))))
    along = named("along", side * sp.Piecewise((root, n[-1] > 0), (-root, True)) - half)
    return Meeting(steps, p + along * n, under * square, square, wide)


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
