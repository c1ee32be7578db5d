r"""The planar parallelogram as its controller sees it: one virtual rod, no turn (Savoure 2006, III.A.1).

Frame and dimensions are those of ``planar_parallelogram``; the closure is eq. (34), with the tool below O_p::

    base        A = (b1x - a1x, 0)                                      A_1, by B_1's offset
    platform    B = A + l1 (sin, -cos)(q + q0)                          at O_p
    closure     P = B + (0, -h) + tool                                  alpha = 0
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.masses import of_arm, of_platform, of_rods
from derive.mechanisms import planar_parallelogram as complete
from derive.mechanisms.planar_parallelogram import (
    a1x,
    b1x,
    body,
    cz,
    distal_rod,
    dl1,
    h,
    l1,
    payload,
    proximal,
    proximal_com,
    px,
    py,
    q,
    q0,
    tx,
    ty,
)
from derive.spec import LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, vector

MACHINE = partial(  # what no rotation enters
    complete.MACHINE,
    name="simplified_parallelogram",
    title="Planar parallelogram, simplified: one virtual rod",
    source="derive/mechanisms/simplified_parallelogram.py",
    common=(
        Quantity(q0, "rad", "encoder offset of the joint", typical=complete._angle),
        Quantity(dl1, "mm", "length of the virtual rod", typical=complete._length, label="l1"),
    ),
    roles={"L": l1},
    moves={"offset": {"q0": sp.Integer(1)}, "arm": {"l1": sp.Integer(1)}},
    models={"planar_parallelogram/2": ("q0", "l1")},
    of="planar_parallelogram",
    scalings={"paper": {}, "table": {}},  # mm and rad
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step = steps.step
    A = step("A", vector(b1x - a1x, 0, 0))
    rod = step("r", (l1 + dl1) * vector(sp.sin(q + q0), -sp.cos(q + q0), 0))
    B = step("B", A + rod)
    C = step("C", vector(px, py, 0) + vector(-tx, h - ty, 0))

    x = b1x - a1x + (l1 + dl1) * sp.sin(q + q0) + tx
    y = -(l1 + dl1) * sp.cos(q + q0) - h + ty

    return MACHINE(
        steps=steps,
        loop_closure=(C[0] - B[0], C[1] - B[1], cz),
        limb_inertials=(
            *of_arm(A, rod / (l1 + dl1), l1 + dl1, l1),
            of_rods([(A, B)], "mass of the rod that is not driven, which goes as the other"),
        ),
        platform_inertials=of_platform(vector(px - tx, py - ty, 0), vector(px, py, 0)),
        limb_weights=(
            Weight(proximal, A + proximal_com * rod),
            Weight(distal_rod / 2, A),
            Weight(distal_rod / 2, B),
        ),
        platform_weights=(Weight(body, vector(px - tx, py - ty, 0)), Weight(payload, vector(px, py, 0))),
        seeds={px: x, py: y, cz: sp.Integer(0), q: sp.asin((px + a1x - b1x - tx) / (l1 + dl1)) - q0},  # eq. (35)
    )
