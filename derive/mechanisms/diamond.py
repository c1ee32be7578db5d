r"""The Diamond: two arms in a plane carry a platform that two parallelograms keep from turning (Mei 2018).

Frame (Mei 2018, section 2; the figures of its tables decide what its text leaves open): x along the line of the two
motors, y up, the platform hangs at negative y. Limb 1 stands at ``+base_x``, limb 2 at ``-base_x``, elbows outwards.
Joint angles are counted from the x axis: at home, with both arms level, ``theta = (0, 180) deg``. The parallelograms
are exact, so that a limb is one link from the arm's tip to the platform (eq. 1)::

    B = (side base_x + ex, base_y + ey)
    C = B + (L + dL) (cos theta, sin theta)         theta = q + theta_i
    closure   (|P - tool - C|^2 - (l + dl)^2) / 2 = 0

The measuring mechanism, a linear scale between a point of the base and one of the platform, reads
``|P - g - (mx, my)|``: its manufacturing and assembly errors (eq. 17) move no link, but they are parameters of the
machine as much as the others (``diamond/12``, ``diamond/4``).
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.masses import of_arm, of_platform, of_rods
from derive.spec import GeometryKey, LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, vector

px, py, q, tx, ty, tz = sp.symbols("px py q tx ty tz", real=True)
base_x, base_y, L, l, side = sp.symbols("base_x base_y L l side", real=True)
theta, ex, ey, dL, dl, mx, my = sp.symbols("theta ex ey dL dl mx my", real=True)
tip_v = sp.Symbol("tip_v", real=True)
proximal, proximal_com, distal_rod, body, payload = sp.symbols(
    "proximal proximal_com distal_rod platform payload", real=True
)

LIMB = ("theta", "ex", "ey", "L", "l")


def _names(errors: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(f"{e}_{i}" for i in (1, 2) for e in errors)


_angle, _length = 1.0 * float(sp.pi) / 180, 0.1  # ordinary errors [rad, mm]
MACHINE = partial(  # what no rotation enters
    LimbMechanism,
    name="diamond",
    title="Diamond, two arms in a plane",
    reference="Mei, Zang, Ding, Xie, Zhang, Strojniski vestnik 63(12), 715-724",
    source="derive/mechanisms/diamond.py",
    limbs=2,
    platform=(
        Quantity(px, "mm", "reference point P, x in {O}"),
        Quantity(py, "mm", "reference point P, y in {O}"),
    ),
    tool=(
        Quantity(tx, "mm", "reference point P from the platform's centre, x"),
        Quantity(ty, "mm", "reference point P from the platform's centre, y"),
        Quantity(tz, "mm", "reference point P from the platform's centre, z"),
    ),
    joint=Quantity(q, "rad", "joint angle as the controller reports it"),
    geometry=(
        GeometryKey("base_x", Quantity(base_x, "mm", "e_x: distance of the motors from {O} along x")),
        GeometryKey("base_y", Quantity(base_y, "mm", "e_y: height of the motors in {O}"), positive=False),
        GeometryKey("proximal_length", Quantity(L, "mm", "L: length of the arm")),
        GeometryKey("distal_length", Quantity(l, "mm", "l: length of the distal link")),
        GeometryKey(
            "side",
            Quantity(side, "1", "on which side of {O} the limb stands, +1 at +x"),
            table="joints",
            per_limb=True,
            default=(1.0, -1.0),
        ),
    ),
    errors=(
        Quantity(theta, "rad", "zero offset of the joint", typical=_angle),
        Quantity(ex, "mm", "base point, x", typical=_length),
        Quantity(ey, "mm", "base point, y", typical=_length),
        Quantity(dL, "mm", "arm length", typical=_length, label="L"),
        Quantity(dl, "mm", "length of the distal link", typical=_length, label="l"),
    ),
    common=(
        Quantity(mx, "mm", "measuring mechanism, both ends together, x", typical=1.0),
        Quantity(my, "mm", "measuring mechanism, both ends together, y", typical=1.0),
    ),
    deflections=(Quantity(tip_v, "mm", "arm tip displaced normal to the arm"),),
    small=(tip_v,),
    masses=(
        Quantity(proximal, "1", "mass of an arm [kg]"),
        Quantity(proximal_com, "1", "its centre of mass, as a part of L"),
        Quantity(distal_rod, "1", "mass of a distal link [kg], half at either end"),
        Quantity(body, "1", "mass of the platform [kg]"),
    ),
    elbow=-side,
    assembly=-1,
    models={
        "diamond/12": (*_names(LIMB), "mx", "my"),
        "diamond/10": _names(LIMB),
        "diamond/4": (*_names(("theta",)), "mx", "my"),
        "diamond/2": _names(("theta",)),
    },
    roles={"L": L, "l": l, "b": base_x},
    moves={
        "offset": {"theta": sp.Integer(1)},
        "arm": {"L": sp.Integer(1)},
        "rod": {"l": sp.Integer(1)},
        "outwards": {"ex": side},
        "tip_v": {"tip_v": sp.Integer(1)},
    },
    rods=("l",),
    limb_inertia=proximal * L**2 / 12,  # a slender rod
    scalings={"paper": {"theta": L}, "table": {"theta": L}},  # the unknowns of eqs. (12) and (28)
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step, named = steps.step, steps.named
    # from the limb's own direction, so that no reading of limb 2 jumps where it passes 180 deg
    turn = q + theta - sp.pi * (1 - side) / 2
    arm = named("arm", side * vector(sp.cos(turn), sp.sin(turn), 0))
    normal = named("normal", side * vector(-sp.sin(turn), sp.cos(turn), 0))
    P, tool = vector(px, py, 0), vector(tx, ty, tz)
    B = step("B", vector(side * base_x + ex, base_y + ey, 0))
    C = step("C", B + (L + dL) * arm + tip_v * normal)
    A = step("A", vector(px - tx, py - ty, 0))
    rod = step("d", A - C)

    return MACHINE(
        steps=steps,
        loop_closure=((rod.dot(rod) - (l + dl) ** 2) / 2,),
        limb_inertials=(*of_arm(B, arm, L + dL, L), of_rods([(C, A)], "mass of the distal link")),
        platform_inertials=of_platform(P - tool, P),
        limb_weights=(
            Weight(proximal, B + proximal_com * (L + dL) * arm),
            Weight(distal_rod / 2, C),
            Weight(distal_rod / 2, A),
        ),
        platform_weights=(Weight(body, P - tool), Weight(payload, P)),
    )
