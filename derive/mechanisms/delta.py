r"""The Delta with all six rods: three arms, each carrying the platform by a pair of rods (R-(SS)^2).

Frames (Bai 2015, section 2). {O} lies at the base centre, z up. Limb i points along
``u0 = (cos phi, sin phi, 0)``; ``v0 = z``; ``w0 = u0 x v0`` is the nominal axis of the joint, and rod 1 lies on its
positive side. ``theta = q + theta_i`` is the angle the geometry sees; 0 puts the arm along u0, positive lifts it.

Source errors are geometry, not a first-order model: each orientation error is a rotation vector in its own nominal
frame, applied as a finite rotation::

    base frame   R0 = [u0 v0 w0] exp(alpha0, beta0, 0)
    elbow        C_j = b u0 + e + R0 Rz(theta) ((L, tip_v, tip_w) +- (c + dc)/2 exp(alpha2, beta2, 0) z)
    platform     A_j = P + R (a u0 +- c/2 [u0 v0 w0] exp(alpha0 - alpha03, beta0 - beta03, 0) z - tool)
    closure      (|A_j - C_j|^2 - (l + l_i +- dl/2)^2) / 2 = 0          + for rod 1, - for rod 2

Only differences enter the paper's linear model, so each difference is put on one side here: `e` at the base, `dc` at
the elbow, `alpha03` and `beta03` at the platform. To first order in the errors this is Bai's eq. (1).
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.masses import of_arm, of_platform, of_rods
from derive.spec import GeometryKey, LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, vector

DEG = sp.pi / 180

px, py, pz, cx, cy, cz = sp.symbols("px py pz cx cy cz", real=True)
tx, ty, tz, q = sp.symbols("tx ty tz q", real=True)
b, a, L, l, c, phi = sp.symbols("b a L l c phi", real=True)
theta, ex, ey, ez, dL, alpha0, beta0, dl_mean = sp.symbols("theta ex ey ez dL alpha0 beta0 dl_mean", real=True)
dl, dc, alpha03, beta03, alpha2, beta2 = sp.symbols("dl dc alpha03 beta03 alpha2 beta2", real=True)
tip_v, tip_w = sp.symbols("tip_v tip_w", real=True)
proximal, proximal_com, distal_rod, body, payload = sp.symbols(
    "proximal proximal_com distal_rod platform payload", real=True
)

u0, v0 = vector(sp.cos(phi), sp.sin(phi), 0), vector(0, 0, 1)
w0 = u0.cross(v0)
NOMINAL_FRAME = sp.Matrix.hstack(u0, v0, w0)

P, tool = vector(px, py, pz), vector(tx, ty, tz)

FRAME_FIXED = ("ex_1", "ey_2", "ey_3", "ez_1", "ez_2", "ez_3")  # Bai, eq. (11)
UNSEEN = ("alpha03_2", "alpha03_3", "beta03_3", "alpha2_3")  # Bai, section 3.2, below eq. (19)
POSITION = ("theta", "ex", "ey", "ez", "L", "alpha0", "beta0", "l")
ORIENTATION = ("dl", "dc", "alpha03", "beta03", "alpha2", "beta2")


def _names(errors: tuple[str, ...], without: tuple[str, ...] = ()) -> tuple[str, ...]:
    everything = (f"{e}_{i}" for i in (1, 2, 3) for e in errors)
    return tuple(n for n in everything if n not in without)


_angle, _length = 0.1 * float(sp.pi) / 180, 0.1  # ordinary errors of a machined part [rad, mm]
MACHINE = partial(  # what no rotation enters
    LimbMechanism,
    name="delta",
    title="Delta, three arms and six rods",
    reference="Bai, Mei, Huang, Chetwynd 2015, Proc. IMechE C 230(3), 414-424",
    source="derive/mechanisms/delta.py",
    limbs=3,
    platform=(
        Quantity(px, "mm", "reference point P, x in {O}"),
        Quantity(py, "mm", "reference point P, y in {O}"),
        Quantity(pz, "mm", "reference point P, z in {O}"),
        Quantity(cx, "rad", "Cayley vector of the platform's rotation, x"),
        Quantity(cy, "rad", "Cayley vector of the platform's rotation, y"),
        Quantity(cz, "rad", "Cayley vector of the platform's rotation, z"),
    ),
    tool=(
        Quantity(tx, "mm", "reference point P in {O'}, x"),
        Quantity(ty, "mm", "reference point P in {O'}, y"),
        Quantity(tz, "mm", "reference point P in {O'}, z"),
    ),
    joint=Quantity(q, "rad", "joint angle as the controller reports it"),
    geometry=(
        GeometryKey("base_radius", Quantity(b, "mm", "b: O to B_i")),
        GeometryKey("platform_radius", Quantity(a, "mm", "a: O' to A_i")),
        GeometryKey("proximal_length", Quantity(L, "mm", "L: length of the arm")),
        GeometryKey("distal_length", Quantity(l, "mm", "l: length of the rods")),
        GeometryKey("joint_spacing", Quantity(c, "mm", "c: spacing of the two S-joints of a limb's end")),
        GeometryKey(
            "limb_angle_deg",
            Quantity(phi, "rad", "phi_i: direction of the limb about z"),
            table="joints",
            per_limb=True,
            default=tuple(float(v * DEG) for v in (-90, 30, 150)),
        ),
    ),
    errors=(
        Quantity(theta, "rad", "encoder offset of the joint", typical=1.0 * float(DEG)),
        Quantity(ex, "mm", "base point minus platform point, x in {O}", typical=_length),
        Quantity(ey, "mm", "base point minus platform point, y in {O}", typical=_length),
        Quantity(ez, "mm", "base point minus platform point, z in {O}", typical=_length),
        Quantity(dL, "mm", "arm length", typical=_length, label="L"),
        Quantity(alpha0, "rad", "joint axis turned about u0 (the limb's direction)", typical=_angle),
        Quantity(beta0, "rad", "joint axis turned about v0 (the vertical)", typical=_angle),
        Quantity(dl_mean, "mm", "rod length, mean of the pair", typical=_length, label="l"),
        Quantity(dl, "mm", "rod length, rod 1 minus rod 2", typical=_length),
        Quantity(dc, "mm", "joint spacing, elbow minus platform", typical=_length),
        Quantity(alpha03, "rad", "alpha0 minus the same error at the platform", typical=_angle),
        Quantity(beta03, "rad", "beta0 minus the same error at the platform", typical=_angle),
        Quantity(alpha2, "rad", "elbow axis turned about the arm", typical=_angle),
        Quantity(beta2, "rad", "elbow axis turned about the normal of the arm", typical=_angle),
    ),
    deflections=(
        Quantity(tip_v, "mm", "arm tip displaced normal to the arm, in its plane"),
        Quantity(tip_w, "mm", "arm tip displaced normal to the arm, along the joint axis"),
    ),
    small=(alpha0, beta0, dl, dc, alpha03, beta03, alpha2, beta2, tip_v, tip_w),
    masses=(
        Quantity(proximal, "1", "mass of an arm [kg]"),
        Quantity(proximal_com, "1", "its centre of mass, as a part of L from B_i"),
        Quantity(distal_rod, "1", "mass of a rod [kg], half at either end"),
        Quantity(body, "1", "mass of the platform [kg], at O'"),
    ),
    elbow=-1,
    assembly=-1,
    models={
        "delta/42": _names(POSITION + ORIENTATION),
        "delta/36": _names(POSITION + ORIENTATION, FRAME_FIXED),
        "delta/32": _names(POSITION + ORIENTATION, FRAME_FIXED + UNSEEN),
        "delta/24": _names(POSITION),
        "delta/18": _names(POSITION, FRAME_FIXED),
        "delta/3": _names(("theta",)),
    },
    roles={"L": L, "l": l, "b": b},
    moves={
        "offset": {"theta": sp.Integer(1)},
        "arm": {"L": sp.Integer(1)},
        "rod": {"l": sp.Integer(1)},
        "rod_difference": {"dl": sp.Integer(1)},
        "outwards": {"ex": u0[0], "ey": u0[1]},
        "tilt_x": {"alpha0": sp.Integer(1), "alpha03": sp.Integer(1)},  # the platform's axis stays
        "tilt_y": {"beta0": sp.Integer(1), "beta03": sp.Integer(1)},
        "tip_v": {"tip_v": sp.Integer(1)},
        "tip_w": {"tip_w": sp.Integer(1)},
        "spacing_difference": {"dc": sp.Integer(1)},
        "hand_axis_u": {"alpha03": sp.Integer(1)},
        "hand_axis_v": {"beta03": sp.Integer(1)},
        "elbow_axis_u": {"alpha2": sp.Integer(1)},
        "elbow_axis_v": {"beta2": sp.Integer(1)},
    },
    rods=("l",),
    limb_inertia=proximal * L**2 / 12,  # a slender rod
    scalings={
        # the unknowns of eqs. (6) and (7): L dtheta, L dalpha0, L dbeta0 in mm; the second group in rad
        "paper": {"theta": L, "alpha0": L, "beta0": L, "dl": 1 / c, "dc": 1 / c},
        # the entries of Tables 3 and 4: everything in mm, angles of the second group times c
        "table": {"theta": L, "alpha0": L, "beta0": L, "alpha03": c, "beta03": c, "alpha2": c, "beta2": c},
    },
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step, named = steps.step, steps.named
    named("u0", u0), named("NOMINAL_FRAME", NOMINAL_FRAME)
    # what no pose changes
    R0 = step("R0", NOMINAL_FRAME * v.rotation_vector(vector(alpha0, beta0, 0)))
    elbow_half = step("g", (c + dc) / 2 * (v.rotation_vector(vector(alpha2, beta2, 0)) * vector(0, 0, 1)))
    hand_half = step(
        "h", c / 2 * (NOMINAL_FRAME * v.rotation_vector(vector(alpha0 - alpha03, beta0 - beta03, 0))[:, 2])
    )
    B = step("B", b * u0 + vector(ex, ey, ez))
    # the arm, the platform, and the two ends of the rods: middle of the pair, and from it to rod 1
    R1 = step("R1", R0 * v.turn_about_z(q + theta))
    R = step("R", v.cayley(vector(cx, cy, cz)))
    C = step("C", B + R1 * vector(L + dL, tip_v, tip_w))
    A = step("A", P + R * (a * u0 - tool))
    C_half, A_half = step("c1", R1 * elbow_half), step("a1", R * hand_half)
    rod, rod_half = step("d", A - C), step("s", A_half - C_half)

    def closure(side: int) -> sp.Expr:
        """Return the loop closure of rod 1 (side +1) or rod 2 (side -1), in mm^2."""
        d = rod + side * rod_half
        return (d.dot(d) - (l + dl_mean + side * dl / 2) ** 2) / 2

    rods = [(C + side * C_half, A + side * A_half) for side in (1, -1)]
    return MACHINE(
        steps=steps,
        limb_inertials=(*of_arm(B, R1[:, 0], L + dL, L), of_rods(rods, "mass of each of the two rods")),
        platform_inertials=of_platform(P - R * tool, P),
        loop_closure=(closure(+1), closure(-1)),
        limb_weights=(
            Weight(proximal, B + R1 * vector(proximal_com * (L + dL), 0, 0)),
            Weight(distal_rod, C),  # half of either rod at the elbow
            Weight(distal_rod, A),  # half of either rod at the platform
        ),
        platform_weights=(Weight(body, P - R * tool), Weight(payload, P)),
    )
