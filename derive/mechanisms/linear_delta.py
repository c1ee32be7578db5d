r"""The linear delta of printers: three upright towers, carriages on belts, a pair of rods from each to the effector.

Frame: {O} lies on the nominal bed plane, z up. Tower i stands in the direction
``u = (cos angle, sin angle, 0)``; ``t = z x u`` is the direction of its pair of rods, rod 1 lies on the positive side.
The joint `q` is the carriage's way down from its endstop. All values are actual ones, nominal plus error::

    axis of the tower   d = exp(lean_radial t - lean_tangential u) z: outwards and counter-clockwise positive
    height at q = 0     h = endstop + sqrt(arm^2 - radius^2), radius that of the tower
    carriage            C_j = (radius + a) u + (h / d_z - (1 + scale) q) d +- c/2 t
    effector            A_j = P + R (a u +- c/2 t - tool)
    closure             (|A_j - C_j|^2 - (arm + stretch +- dl/2)^2) / 2 = 0       + for rod 1, - for rod 2

`endstop` is a height of the nozzle, so that a rod that is longer homes its carriage higher; `stretch` is by how much
the rods grow or give way afterwards, the carriage being where its switch is.

`a` (effector's centre to its joints) and `c` (spacing of a pair) cancel while the rods of every pair are equal; they
matter for `dl` alone, by which the effector tilts.

Firmware. Klipper (``klippy/kinematics/delta.py``): delta_radius is `radius`, arm_length_a, b, c are `arm_length`,
angle_a, b, c are `tower_angle`, position_endstop_a, b, c are `endstop`; its ``delta_calibrate`` fits linear_delta/6 to
heights, linear_delta/9 to heights and distances. RepRapFirmware (M665, M666; D. Crocker): R is `radius`, L is
`arm_length`, X, Y, Z are additions to the tower angles 210, 330, 90 deg; the carriages home at a height of H, the
largest of the three, less the trims' mean, plus the trim of the tower, so that ``endstop_i = H + trim_i - mean trim``.
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.masses import CARRIAGE, of_platform, of_rods
from derive.spec import GeometryKey, Inertial, LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, vector

DEG = float(sp.pi) / 180

px, py, pz, cx, cy, cz = sp.symbols("px py pz cx cy cz", real=True)
tx, ty, tz, q = sp.symbols("tx ty tz q", real=True)
r, l, phi, home, a, c = sp.symbols("r l phi home a c", real=True)
dr, endstop, arm, radius, angle, lean_radial, lean_tangential, scale, dl = sp.symbols(
    "dr endstop arm radius angle lean_radial lean_tangential scale dl", real=True
)
stretch = sp.Symbol("stretch", real=True)
carriage, rod_mass, body, payload = sp.symbols("carriage distal_rod platform payload", real=True)


def _names(*errors: str) -> tuple[str, ...]:
    return tuple(f"{e}_{i}" for i in (1, 2, 3) for e in errors)


ENDSTOPS = _names("endstop")
FIRMWARE = (*ENDSTOPS, "radius", "angle_1", "angle_2")
TOWER = ("endstop", "arm", "radius", "angle", "lean_radial", "lean_tangential", "scale")
MACHINE = partial(  # what no rotation enters
    LimbMechanism,
    name="linear_delta",
    title="Linear delta, three towers and six rods",
    reference="Klipper, klippy/kinematics/delta.py; RepRapFirmware, LinearDeltaKinematics",
    source="derive/mechanisms/linear_delta.py",
    limbs=3,
    platform=(
        Quantity(px, "mm", "nozzle P, x in {O}"),
        Quantity(py, "mm", "nozzle P, y in {O}"),
        Quantity(pz, "mm", "nozzle P, z in {O}"),
        Quantity(cx, "rad", "Cayley vector of the effector's rotation, x"),
        Quantity(cy, "rad", "Cayley vector of the effector's rotation, y"),
        Quantity(cz, "rad", "Cayley vector of the effector's rotation, z"),
    ),
    tool=(
        Quantity(tx, "mm", "nozzle P from the point that the geometry describes, x"),
        Quantity(ty, "mm", "nozzle P from the point that the geometry describes, y"),
        Quantity(tz, "mm", "nozzle P from the point that the geometry describes, z"),
    ),
    joint=Quantity(q, "mm", "way of the carriage down from its endstop, as the motor has counted it"),
    geometry=(
        GeometryKey("radius", Quantity(r, "mm", "horizontal distance from carriage joint to effector joint")),
        GeometryKey("arm_length", Quantity(l, "mm", "length of the rods"), per_limb=True),
        GeometryKey("tower_angle", Quantity(phi, "rad", "direction of the tower about z"), per_limb=True),
        GeometryKey(
            "endstop",
            Quantity(home, "mm", "nozzle height when all carriages sit at their endstops"),
            per_limb=True,
            positive=False,
        ),
        GeometryKey(
            "effector_radius", Quantity(a, "mm", "effector's centre to its joints; only `dl` needs it"), default=(30.0,)
        ),
        GeometryKey(
            "rod_spacing", Quantity(c, "mm", "spacing of the two rods of a pair; only `dl` needs it"), default=(50.0,)
        ),
    ),
    errors=(
        Quantity(endstop, "mm", "height of the endstop", typical=1.0),
        Quantity(arm, "mm", "rod length, mean of the pair", typical=0.3),
        Quantity(radius, "mm", "radius of this tower, beside what all share", typical=0.3),
        Quantity(angle, "rad", "direction of the tower about z", typical=0.2 * DEG),
        Quantity(lean_radial, "rad", "lean of the tower outwards, about its foot", typical=0.2 * DEG),
        Quantity(lean_tangential, "rad", "lean of the tower counter-clockwise, about its foot", typical=0.2 * DEG),
        Quantity(scale, "1", "true way of the carriage per counted way, less 1", typical=3e-4),
        Quantity(dl, "mm", "rod length, rod 1 minus rod 2", typical=0.3),
    ),
    common=(Quantity(dr, "mm", "radius, all towers", typical=0.3, label="radius"),),
    deflections=(Quantity(stretch, "mm", "rods longer than where the carriage homes"),),
    small=(lean_radial, lean_tangential, dl, stretch),
    masses=(
        Quantity(carriage, "1", "mass of a carriage [kg]"),
        Quantity(rod_mass, "1", "mass of a rod [kg], half at either end"),
        Quantity(body, "1", "mass of the effector [kg], at its centre"),
    ),
    elbow=-1,
    assembly=-1,
    models={
        "linear_delta/21": _names(*TOWER),
        "linear_delta/9": (*FIRMWARE, *_names("arm")),
        "linear_delta/6": FIRMWARE,
        "linear_delta/4": (*ENDSTOPS, "radius"),
        "linear_delta/3": ENDSTOPS,
    },
    roles={"l": l, "b": r},
    moves={
        "rod": {"stretch": sp.Integer(1)},
        "rod_difference": {"dl": sp.Integer(1)},
        "pair_difference": {"dl": sp.Integer(1)},
        "outwards": {"radius": sp.Integer(1), "endstop": r / sp.sqrt(l**2 - r**2)},  # the carriage stays where it homes
        "tilt_x": {"lean_tangential": sp.Integer(-1)},
        "tilt_y": {"lean_radial": sp.Integer(1)},
        "lean_radial": {"lean_radial": sp.Integer(1)},
        "lean_tangential": {"lean_tangential": sp.Integer(1)},
    },
    layers=(1, -1),
    rods=("stretch",),
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step = steps.step
    P, tool = vector(px, py, pz), vector(tx, ty, tz)
    u = step("u", vector(sp.cos(phi + angle), sp.sin(phi + angle), 0))
    t = steps.named("t", vector(-u[1], u[0], 0))
    length, out = step("arm_0", l + arm), step("r_0", r + dr + radius)
    axis = step("axis", v.rotation_vector(lean_radial * t - lean_tangential * u)[:, 2])
    height = step("h", home + endstop + sp.sqrt(length**2 - out**2))
    C = step("C", (out + a) * u + (height / axis[2] - (1 + scale) * q) * axis)
    R = step("R", v.cayley(vector(cx, cy, cz)))
    A = step("A", P + R * (a * u - tool))
    rod, rod_half = step("d", A - C), step("s", c / 2 * (R * t - t))

    half = c / 2 * t
    rods = [(C + side * half, A + side * R * half) for side in (1, -1)]

    def closure(side: int) -> sp.Expr:
        """Return the loop closure of rod 1 (side +1) or rod 2 (side -1), in mm^2."""
        d = rod + side * rod_half
        return (d.dot(d) - (length + stretch + side * dl / 2) ** 2) / 2

    return MACHINE(
        steps=steps,
        loop_closure=(closure(+1), closure(-1)),
        limb_inertials=(
            Inertial("m_carriage", "kg", "mass of the carriage", ((sp.Integer(1), C),), CARRIAGE),
            of_rods(rods, "mass of each of the two rods"),
        ),
        platform_inertials=of_platform(P - R * tool, P),
        limb_weights=(
            Weight(carriage, C),
            Weight(rod_mass, C),  # half of either rod at the carriage
            Weight(rod_mass, A),  # half of either rod at the effector
        ),
        platform_weights=(Weight(body, P - R * tool), Weight(payload, P)),
    )
