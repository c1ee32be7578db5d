r"""The hexapod of Gough and Stewart: a platform on six legs, each between a ball joint and a universal joint.

Frame: {O} in the middle of the base, z up, towards the platform. With the platform at P, turned by R::

    base joint      A = base_radius (cos, sin)(base_angle) + base_height z + (ax, ay, az)
    platform joint  B = P + R (platform_radius (cos, sin)(platform_angle) + platform_height z + (bx, by, bz) - tool - t)
    closure         (|B - A|^2 - (leg_length + l + (1 + scale) q)^2) / 2 = 0

A command asks for position and rotation: the way of a leg follows from its own closure. The forward position has up to
forty solutions; the machine's is the one near its home, level above the base with all legs drawn in.

Seven errors a leg are the 42 of the literature (Masory, Wang, Zhuang); `scale` is the lead of its spindle. Readings of
poses in an unknown frame see 33 of the 42: another frame of the base is the instrument's, another rotation of the
platform the target's. Where nobody knows the reference point either, they see 30: t moves it, and the platform turns,
so that a reflector that sits elsewhere than it is said to is no frame of the instrument.
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.masses import of_leg, of_platform
from derive.spec import GeometryKey, LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, vector

px, py, pz, cx, cy, cz = sp.symbols("px py pz cx cy cz", real=True)
tx, ty, tz, q = sp.symbols("tx ty tz q", real=True)
base, alpha, up, platform, beta, down, l = sp.symbols("base alpha up plate beta down leg", real=True)
ax, ay, az, bx, by, bz, dl, scale = sp.symbols("ax ay az bx by bz dl scale", real=True)
t = sp.symbols("dtx dty dtz", real=True)
lower, lower_com, upper, body, payload = sp.symbols("proximal proximal_com distal_rod platform payload", real=True)

LENGTHS = ("ax", "ay", "az", "bx", "by", "bz", "l")
LEGS = (1, 2, 3, 4, 5, 6)
TOOL_ERRORS = ("tx", "ty", "tz")
DEG = float(sp.pi) / 180
_length = 0.1  # an ordinary error [mm]


def _names(*errors: str) -> tuple[str, ...]:
    return tuple(f"{e}_{i}" for i in LEGS for e in errors)


MACHINE = partial(  # what no rotation enters
    LimbMechanism,
    name="hexapod",
    title="Hexapod of Gough and Stewart, six legs",
    reference="Masory, Wang, Zhuang 1993, IEEE ICRA, 725-731; Stewart 1965, Proc. IMechE 180, 371-386",
    source="derive/mechanisms/hexapod.py",
    limbs=6,
    platform=(
        Quantity(px, "mm", "reference point, x in {O}"),
        Quantity(py, "mm", "reference point, y in {O}"),
        Quantity(pz, "mm", "reference point, z in {O}"),
        Quantity(cx, "rad", "Cayley vector of the platform's rotation, x"),
        Quantity(cy, "rad", "Cayley vector of the platform's rotation, y"),
        Quantity(cz, "rad", "Cayley vector of the platform's rotation, z"),
    ),
    tool=(
        Quantity(tx, "mm", "reference point from the platform's centre, x"),
        Quantity(ty, "mm", "reference point from the platform's centre, y"),
        Quantity(tz, "mm", "reference point from the platform's centre, z"),
    ),
    joint=Quantity(q, "mm", "way of the leg out of its shortest length, as the motor has counted it"),
    geometry=(
        GeometryKey("base_radius", Quantity(base, "mm", "distance of a base joint from {O}'s z axis"), per_limb=True),
        GeometryKey("base_angle", Quantity(alpha, "rad", "direction of a base joint"), per_limb=True, positive=False),
        GeometryKey(
            "base_height",
            Quantity(up, "mm", "height of a base joint"),
            per_limb=True,
            positive=False,
            default=(0.0,) * 6,
        ),
        GeometryKey(
            "platform_radius", Quantity(platform, "mm", "distance of a platform joint from its z axis"), per_limb=True
        ),
        GeometryKey(
            "platform_angle", Quantity(beta, "rad", "direction of a platform joint"), per_limb=True, positive=False
        ),
        GeometryKey(
            "platform_height",
            Quantity(down, "mm", "height of a platform joint over the platform's centre"),
            per_limb=True,
            positive=False,
            default=(0.0,) * 6,
        ),
        GeometryKey("leg_length", Quantity(l, "mm", "length of a leg at q = 0"), per_limb=True),
    ),
    errors=(
        Quantity(ax, "mm", "base joint, x in {O}", typical=_length),
        Quantity(ay, "mm", "base joint, y in {O}", typical=_length),
        Quantity(az, "mm", "base joint, z in {O}", typical=_length),
        Quantity(bx, "mm", "platform joint, x in {O'}", typical=_length),
        Quantity(by, "mm", "platform joint, y in {O'}", typical=_length),
        Quantity(bz, "mm", "platform joint, z in {O'}", typical=_length),
        Quantity(dl, "mm", "length of the leg at q = 0, with the zero of its drive", typical=1.0, label="l"),
        Quantity(scale, "1", "true way of the leg per counted way, less 1", typical=3e-4),
    ),
    common=tuple(
        Quantity(e, "mm", f"reference point, {a} in {{O'}}", typical=_length, label=f"t{a}")
        for e, a in zip(t, "xyz", strict=True)
    ),
    deflections=(),
    small=(),
    masses=(
        Quantity(lower, "1", "mass of the part of a leg that hangs on the base joint [kg]"),
        Quantity(lower_com, "1", "its centre of mass from there, of leg_length"),
        Quantity(upper, "1", "mass of the part that slides out, a thin rod of leg_length from the platform joint [kg]"),
        Quantity(body, "1", "mass of the platform [kg], at its centre"),
    ),
    elbow=+1,
    assembly=+1,
    home={
        px: tx,
        py: ty,
        pz: tz + up - down + sp.sqrt(l**2 - base**2 - platform**2 + 2 * base * platform * sp.cos(alpha - beta)),
    },
    layers=(1, -1),
    models={
        "hexapod/51": (*_names(*LENGTHS, "scale"), *TOOL_ERRORS),
        "hexapod/48": _names(*LENGTHS, "scale"),
        "hexapod/42": _names(*LENGTHS),
        "hexapod/6": _names("l"),
    },
    roles={"l": l, "b": base},
    moves={
        "rod": {"l": sp.Integer(1)},
        "outwards": {"ax": sp.cos(alpha), "ay": sp.sin(alpha)},
    },
    rods=("l",),
    limb_inertia=lower * l**2 / 12,
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step = steps.step
    P, R = vector(px, py, pz), step("R", v.cayley(vector(cx, cy, cz)))
    tool = vector(tx, ty, tz)  # of the weight of the platform, too, which no error moves
    A = step("A", vector(base * sp.cos(alpha) + ax, base * sp.sin(alpha) + ay, up + az))
    b = step("b", vector(platform * sp.cos(beta) + bx, platform * sp.sin(beta) + by, down + bz) - tool - vector(*t))
    B = step("B", P + R * b)
    leg, length = step("d", B - A), step("s", l + dl + (1 + scale) * q)
    along = step("e", leg / length)

    return MACHINE(
        steps=steps,
        loop_closure=((leg.dot(leg) - length**2) / 2,),
        limb_inertials=of_leg(A, B, along, l),
        platform_inertials=of_platform(P - R * tool, P),
        limb_weights=(Weight(lower, A + lower_com * l * along), Weight(upper, B - l * along / 2)),
        platform_weights=(Weight(body, P - R * tool), Weight(payload, P)),
    )
