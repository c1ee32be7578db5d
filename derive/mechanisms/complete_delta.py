r"""The Delta with the complete geometry of its six rods: 51 source errors (Savoure 2006, section II.B).

Frame, dimensions and joints are those of ``delta``. Limb i has the local basis (x, y, z) = (joint axis w0, limb's
direction u0, up): the paper's (u_i, v_i, z). With finite errors::

    elbow       A_ij = b u0 + exp(beta_i) [w0 u0 v0] Rx(q) ((+-c/2, L, 0) + (ax, ay, az)_ij)
    platform    B_ij = P + R (a u0 +- c/2 w0 - tool + (bx, by, bz)_ij)
    closure     (|B_ij - A_ij|^2 - (l + l_ij)^2) / 2 = 0           + for rod 1, - for rod 2

`beta` is a rotation vector in {O} about the joint's centre; `a` counts in the arm, `b` in the platform. Of the errors
of B_ij and of the joint's centre only the difference is seen, eq. (13): `b` stands for it and acts at the platform.
To first order this is eq. (12) with its first sign corrected.
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.masses import of_arm, of_platform, of_rods
from derive.mechanisms import delta
from derive.mechanisms.delta import (
    NOMINAL_FRAME,
    L,
    P,
    a,
    b,
    body,
    c,
    cx,
    cy,
    cz,
    distal_rod,
    l,
    payload,
    proximal,
    proximal_com,
    q,
    tip_v,
    tip_w,
    tool,
    u0,
    w0,
)
from derive.spec import LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, vector

beta = vector(*sp.symbols("betax betay betaz", real=True))
half = sp.Rational(1, 2)
SIDES = ((1, 1), (2, -1))  # of the rods of a pair


def errors_of(rod: int) -> tuple[sp.Matrix, sp.Matrix, sp.Symbol]:
    """Return the errors of the rod's end in the platform, of its end in the arm, and of its length."""
    by_name = [sp.Symbol(f"{name}{rod}", real=True) for name in ("bx", "by", "bz", "ax", "ay", "az", "dl")]
    return vector(*by_name[:3]), vector(*by_name[3:6]), by_name[6]


def pair(name: str, much: sp.Expr | int = 1, *, opposite: bool = False) -> dict[str, sp.Expr]:
    """Return how much an error of both rods moves, in opposite directions where asked."""
    return {f"{name}_{{i}}{j}": sp.sympify(much) * (-1 if opposite and j == 2 else 1) for j in (1, 2)}


errors = []
for j, _ in SIDES:
    in_platform, in_arm, dl = errors_of(j)
    for place, symbols, where in (("b", in_platform, "B in the platform"), ("a", in_arm, "A in the arm")):
        errors += [
            Quantity(s, "mm", f"rod {j}: {where}, {axis}", typical=delta._length, label=f"{place}{axis}_{{i}}{j}")
            for axis, s in zip("xyz", symbols, strict=True)
        ]
    errors.append(Quantity(dl, "mm", f"length of rod {j}", typical=delta._length, label=f"l_{{i}}{j}"))
errors += [
    Quantity(s, "rad", f"joint's axis and zero turned about {axis} of {{O}}", typical=delta._angle)
    for axis, s in zip("xyz", beta, strict=True)
]

MACHINE = partial(  # what no rotation enters
    delta.MACHINE,
    name="complete_delta",
    title="Delta, complete geometry of the six rods",
    reference="Savoure, Maurine, Corbel, Krut 2006, ICRA, 769-776",
    source="derive/mechanisms/complete_delta.py",
    errors=tuple(errors),
    small=(*(e.symbol for e in errors), tip_v, tip_w),
    models={"delta/51": tuple(e.name_of(i) for i in (1, 2, 3) for e in errors)},
    moves={
        "offset": {"betax": w0[0], "betay": w0[1]},
        "arm": pair("ay"),
        "rod": pair("l"),
        "rod_difference": pair("l", half, opposite=True),
        "outwards": pair("bx", -u0[0]) | pair("by", -u0[1]),  # b stands for B in the platform less the joint's centre
        "tilt_x": {"betax": u0[0], "betay": u0[1]},
        "tilt_y": {"betaz": sp.Integer(1)},
        "tip_v": {"tip_v": sp.Integer(1)},
        "tip_w": {"tip_w": sp.Integer(1)},
        "spacing_difference": pair("ax", half, opposite=True),
        "hand_axis_u": pair("bz", c / 2, opposite=True),
        "hand_axis_v": pair("bx", -c / 2 * u0[0], opposite=True) | pair("by", -c / 2 * u0[1], opposite=True),
        "elbow_axis_u": pair("az", -c / 2, opposite=True),
        "elbow_axis_v": pair("ay", c / 2, opposite=True),
    },
    rods=("l_{i}1", "l_{i}2"),
    scalings={"paper": {}, "table": {}},
    of="delta",
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step, named = steps.step, steps.named
    named("u0", u0), named("w0", w0), named("beta", beta)
    # [w0 u0 v0]: the joint's axis, the limb's direction, up
    axes = named("axes", sp.Matrix.hstack(NOMINAL_FRAME[:, 2], NOMINAL_FRAME[:, 0], NOMINAL_FRAME[:, 1]))
    R0 = step("R0", v.rotation_vector(beta) * axes)
    turn = named("turn", sp.Matrix([[1, 0, 0], [0, sp.cos(q), -sp.sin(q)], [0, sp.sin(q), sp.cos(q)]]))
    R1, R = step("R1", R0 * turn), step("R", v.cayley(vector(cx, cy, cz)))
    base = named("base", b * u0)
    tip = named("tip", vector(tip_w, 0, tip_v))  # a bent arm: along the joint's axis, normal to the arm

    closures, elbows, hands = [], [], []
    for j, side in SIDES:
        in_platform, in_arm, dl = errors_of(j)
        lever = step(f"g{j}", vector(side * c / 2, L, 0) + in_arm + tip)
        hand = step(f"h{j}", a * u0 + side * c / 2 * w0 + in_platform)
        elbows.append(step(f"A{j}", base + R1 * lever))
        hands.append(step(f"B{j}", P + R * (hand - tool)))
        rod = step(f"d{j}", hands[-1] - elbows[-1])
        closures.append((rod.dot(rod) - (l + dl) ** 2) / 2)

    return MACHINE(
        steps=steps,
        loop_closure=tuple(closures),
        limb_inertials=(
            *of_arm(base, R1[:, 1], L, L),
            of_rods(list(zip(elbows, hands, strict=True)), "mass of each of the two rods"),
        ),
        platform_inertials=of_platform(P - R * tool, P),
        limb_weights=(
            Weight(proximal, base + proximal_com * R1 * vector(0, L, 0)),
            *(Weight(distal_rod / 2, end) for end in (*elbows, *hands)),  # half of either rod at either end
        ),
        platform_weights=(Weight(body, P - R * tool), Weight(payload, P)),
    )
