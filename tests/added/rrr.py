r"""The planar 3-RRR: a platform on three limbs of arm and rod, which turns on command as well as it moves.

Frame: x and y in the plane, {O} in the middle of the motors; limb i stands at the angle phi_i, its arm at
``phi_i + q``. With the platform turned by alpha about z::

    base        A = base_radius (cos phi, sin phi)          B = A + L (cos(phi + q), sin(phi + q))
    platform    C = platform_radius (cos phi, sin phi)      in {O'}, reference point at the tool
    closure     (|P + R (C - tool) - B|^2 - l^2) / 2 = 0

A command asks for all three coordinates: a limb's joint follows from its own closure. The forward position has up to
six solutions; the machine's is the one near its home, the platform in the middle and level.
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.spec import GeometryKey, LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, vector

px, py, cz, q, tx, ty, tz = sp.symbols("px py cz q tx ty tz", real=True)
base, platform, L, l, phi = sp.symbols("base platform L l phi", real=True)
theta, ex, ey, dL, dl, bx, by = sp.symbols("theta ex ey dL dl bx by", real=True)
arm_mass, rod_mass, body, payload = sp.symbols("proximal distal_rod platform_mass payload", real=True)

ERRORS = ("theta", "ex", "ey", "L", "l", "bx", "by")
_angle, _length = 0.2 * float(sp.pi) / 180, 0.1  # ordinary errors [rad, mm]
_third = 2 * float(sp.pi) / 3

MACHINE = partial(  # what no rotation enters
    LimbMechanism,
    name="rrr",
    title="Planar 3-RRR, position and rotation commanded",
    reference="Gosselin, Angeles 1988, J. Mech. Transm. Autom. Des. 110(1), 35-41",
    source="derive/mechanisms/rrr.py",
    limbs=3,
    platform=(
        Quantity(px, "mm", "reference point, x in {O}"),
        Quantity(py, "mm", "reference point, y in {O}"),
        Quantity(cz, "rad", "Cayley vector of the platform's rotation, z"),
    ),
    tool=(
        Quantity(tx, "mm", "reference point from the platform's centre, x"),
        Quantity(ty, "mm", "reference point from the platform's centre, y"),
        Quantity(tz, "mm", "reference point from the platform's centre, z: out of the plane"),
    ),
    joint=Quantity(q, "rad", "angle of the arm from its limb's outward direction"),
    geometry=(
        GeometryKey("base_radius", Quantity(base, "mm", "distance of the motors from {O}")),
        GeometryKey("platform_radius", Quantity(platform, "mm", "distance of the platform's joints from {O'}")),
        GeometryKey("proximal_length", Quantity(L, "mm", "length of the arm")),
        GeometryKey("distal_length", Quantity(l, "mm", "length of the rod")),
        GeometryKey(
            "limb_angle_deg",
            Quantity(phi, "rad", "where the limb stands"),
            table="joints",
            per_limb=True,
            default=(_third / 4 * 3, _third / 4 * 7, _third / 4 * 11),  # 90, 210, 330 deg
        ),
    ),
    errors=(
        Quantity(theta, "rad", "zero offset of the joint", typical=_angle),
        Quantity(ex, "mm", "motor, outwards", typical=_length),
        Quantity(ey, "mm", "motor, across", typical=_length),
        Quantity(dL, "mm", "length of the arm", typical=_length, label="L"),
        Quantity(dl, "mm", "length of the rod", typical=_length, label="l"),
        Quantity(bx, "mm", "joint on the platform, outwards", typical=_length),
        Quantity(by, "mm", "joint on the platform, across", typical=_length),
    ),
    deflections=(),
    small=(),
    masses=(
        Quantity(arm_mass, "1", "mass of an arm [kg]"),
        Quantity(rod_mass, "1", "mass of a rod [kg], half at either end"),
        Quantity(body, "1", "mass of the platform [kg]", label="platform"),
    ),
    elbow=+1,
    assembly=+1,
    home={px: tx, py: ty},  # the platform in the middle, level
    layers=(1, -1),
    models={
        "rrr/21": tuple(f"{e}_{i}" for i in (1, 2, 3) for e in ERRORS),
        "rrr/3": ("theta_1", "theta_2", "theta_3"),
    },
    roles={"L": L, "l": l, "b": base},
    moves={
        "offset": {"theta": sp.Integer(1)},
        "arm": {"L": sp.Integer(1)},
        "rod": {"l": sp.Integer(1)},
        "outwards": {"ex": sp.Integer(1)},
    },
    rods=("l",),
    limb_inertia=arm_mass * L**2 / 12,
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step = steps.step
    out, across = vector(sp.cos(phi), sp.sin(phi), 0), vector(-sp.sin(phi), sp.cos(phi), 0)
    arm = sp.cos(q + theta) * out + sp.sin(q + theta) * across  # from the limb's own direction: no reading jumps

    P, R = vector(px, py, 0), v.cayley(vector(0, 0, cz))
    A = step("A", (base + ex) * out + ey * across)
    B = step("B", A + (L + dL) * arm)
    c = step("c", (platform + bx) * out + by * across - vector(tx, ty, 0))
    C = step("C", P + R * c)
    rod = step("d", C - B)

    return MACHINE(
        steps=steps,
        loop_closure=((rod.dot(rod) - (l + dl) ** 2) / 2,),
        limb_weights=(Weight(arm_mass, A + (L + dL) * arm / 2), Weight(rod_mass / 2, B), Weight(rod_mass / 2, C)),
        platform_weights=(Weight(body, P - R * vector(tx, ty, 0)), Weight(payload, P)),
    )
