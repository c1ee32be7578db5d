r"""The planar parallelogram: a platform on two rods, one of them driven (Savoure 2006, section III).

Frame: x along the base, from O_b away from A_1, y up; the platform hangs at negative y. The joint angle is counted from
the vertical that points down, so ``A_1 B_1 = l1 (sin, -cos)`` at ``q + q0`` (eq. 61). With the platform turned by alpha
about z::

    base        A_1 = (-a1x, 0)        A_2 = (a2x, a2y)
    platform    B_1 = (-b1x, 0)        B_2 = (b2x, b2y)        C = (0, -h) + tool
    closure     P + R (B_1 - C) - A_1 - l1 (sin, -cos) = 0     the driven rod (eq. 42), two equations
                (|P + R (B_2 - C) - A_2|^2 - l2^2) / 2 = 0     the other one

The driven rod fixes B_1; the other one is then linear in cos alpha and sin alpha, so the forward position is closed.
That is the paper's eq. (52), whose printed form fails; here it is solved from the closure.
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.masses import of_arm, of_platform, of_rods
from derive.spec import GeometryKey, LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, angle, vector

px, py, cz, q, tx, ty, tz = sp.symbols("px py cz q tx ty tz", real=True)
a1x, a2x, a2y, b1x, b2x, b2y, l1, l2, h = sp.symbols("a1x a2x a2y b1x b2x b2y l1 l2 h", real=True)
proximal, proximal_com, distal_rod, body, payload = sp.symbols(
    "proximal proximal_com distal_rod platform payload", real=True
)
q0, da1x, da2x, da2y, db1x, db2x, db2y, dl1, dl2 = sp.symbols("q0 da1x da2x da2y db1x db2x db2y dl1 dl2", real=True)


def turn(cos: sp.Expr, sin: sp.Expr) -> sp.Matrix:
    """Return the rotation about z."""
    return sp.Matrix([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])


_angle, _length = 0.1 * float(sp.pi) / 180, 1.0  # ordinary errors: those of the paper's Table 2 [rad, mm]
MACHINE = partial(  # what no rotation enters
    LimbMechanism,
    name="planar_parallelogram",
    title="Planar parallelogram, one joint",
    reference="Savoure, Maurine, Corbel, Krut 2006, ICRA, 769-776",
    source="derive/mechanisms/planar_parallelogram.py",
    limbs=1,
    platform=(
        Quantity(px, "mm", "reference point, x in {O}"),
        Quantity(py, "mm", "reference point, y in {O}"),
        Quantity(cz, "rad", "Cayley vector of the platform's rotation, z"),
    ),
    tool=(
        Quantity(tx, "mm", "reference point from C, x in the platform"),
        Quantity(ty, "mm", "reference point from C, y in the platform"),
        Quantity(tz, "mm", "reference point from C, z: out of the plane"),
    ),
    joint=Quantity(q, "rad", "joint angle as the controller reports it, from the vertical"),
    geometry=(
        GeometryKey("a1x", Quantity(a1x, "mm", "A_1 left of O_b"), positive=False),
        GeometryKey("a2x", Quantity(a2x, "mm", "A_2 right of O_b"), positive=False),
        GeometryKey("a2y", Quantity(a2y, "mm", "A_2 above O_b"), positive=False),
        GeometryKey("b1x", Quantity(b1x, "mm", "B_1 left of O_p"), positive=False),
        GeometryKey("b2x", Quantity(b2x, "mm", "B_2 right of O_p"), positive=False),
        GeometryKey("b2y", Quantity(b2y, "mm", "B_2 above O_p"), positive=False),
        GeometryKey("l1", Quantity(l1, "mm", "length of the driven rod A_1 B_1")),
        GeometryKey("l2", Quantity(l2, "mm", "length of the rod A_2 B_2")),
        GeometryKey("h", Quantity(h, "mm", "tool: C below O_p"), positive=False),
    ),
    errors=(),
    common=(
        Quantity(q0, "rad", "encoder offset of the joint", typical=_angle),
        Quantity(da1x, "mm", "A_1 left of O_b", typical=_length, label="a1x"),
        Quantity(da2x, "mm", "A_2 right of O_b", typical=_length, label="a2x"),
        Quantity(da2y, "mm", "A_2 above O_b", typical=_length, label="a2y"),
        Quantity(db1x, "mm", "B_1 left of O_p", typical=_length, label="b1x"),
        Quantity(db2x, "mm", "B_2 right of O_p", typical=_length, label="b2x"),
        Quantity(db2y, "mm", "B_2 above O_p", typical=_length, label="b2y"),
        Quantity(dl1, "mm", "length of the driven rod", typical=_length, label="l1"),
        Quantity(dl2, "mm", "length of the other rod", typical=_length, label="l2"),
    ),
    deflections=(),
    small=(),
    masses=(
        Quantity(proximal, "1", "mass of the driven rod [kg]"),
        Quantity(proximal_com, "1", "its centre of mass, as a part of l1 from A_1"),
        Quantity(distal_rod, "1", "mass of the other rod [kg], half at either end"),
        Quantity(body, "1", "mass of the platform [kg], h below O_p: where the tool point counts from"),
    ),
    elbow=+1,
    assembly=+1,
    roles={"L": l1, "l": l2, "b": (a1x + a2x) / 2},
    moves={  # the driven rod is the arm; a base that grows takes A_1 and A_2 apart, up to a shift of the frame
        "offset": {"q0": sp.Integer(1)},
        "arm": {"l1": sp.Integer(1)},
        "rod": {"l2": sp.Integer(1)},
        "outwards": {"a1x": sp.Integer(1), "a2x": sp.Integer(1)},
    },
    limb_inertia=proximal * l1**2 / 12,  # a slender rod
    models={
        "planar_parallelogram/9": ("q0", "a1x", "a2x", "a2y", "b1x", "b2x", "b2y", "l1", "l2"),
    },
    scalings={"paper": {}, "table": {}},  # mm and rad
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step = steps.step
    A_1 = step("A1", vector(-(a1x + da1x), 0, 0))
    A_2 = step("A2", vector(a2x + da2x, a2y + da2y, 0))
    C = step("C", vector(tx, ty - h, 0))
    b_1 = step("b1", vector(-(b1x + db1x), 0, 0))
    b_2 = step("b2", vector(b2x + db2x, b2y + db2y, 0))
    length_1, length_2 = l1 + dl1, l2 + dl2
    rod_1 = step("r1", length_1 * vector(sp.sin(q + q0), -sp.cos(q + q0), 0))

    P, R = vector(px, py, 0), step("R", v.cayley(vector(0, 0, cz)))
    B_1, B_2 = step("B1", P + R * (b_1 - C)), step("B2", P + R * (b_2 - C))
    driven, other = B_1 - A_1 - rod_1, step("r2", B_2 - A_2)

    # the forward position: B_1 hangs on the driven rod, the other rod turns the platform about it
    cos, sin = sp.symbols("cos sin", real=True)
    free = A_1 + rod_1 + turn(cos, sin) * (b_2 - b_1) - A_2
    square = sp.expand(free.dot(free) - length_2**2).subs(sin**2, 1 - cos**2).expand()
    flat = {cos: 0, sin: 0}
    alpha = angle(sp.diff(square, cos).subs(flat), sp.diff(square, sin).subs(flat), square.subs(flat), side=+1)
    at_C = A_1 + rod_1 + turn(sp.cos(alpha), sp.sin(alpha)) * (C - b_1)

    return MACHINE(
        steps=steps,
        loop_closure=(driven[0], driven[1], (other.dot(other) - length_2**2) / 2),
        limb_inertials=(
            *of_arm(A_1, rod_1 / length_1, length_1, l1),
            of_rods([(A_2, B_2)], "mass of the rod that is not driven"),
        ),
        platform_inertials=of_platform(P - R * vector(tx, ty, 0), P),
        limb_weights=(
            Weight(proximal, A_1 + proximal_com * rod_1),
            Weight(distal_rod / 2, A_2),
            Weight(distal_rod / 2, B_2),
        ),
        platform_weights=(Weight(body, P - R * vector(tx, ty, 0)), Weight(payload, P)),
        seeds={
            px: at_C[0],
            py: at_C[1],
            cz: 2 * sp.tan(alpha / 2),
            q: sp.asin((px - C[0] - A_1[0] + b_1[0]) / length_1) - q0,  # eq. (35)
        },
    )
