r"""RoboTennis: a Delta whose limbs are single rods, read in increments from an unknown home (Traslosheros 2013).

Frames (sections 3 and 4). {O} lies at the base centre, z towards the effector. Limb i lies in the plane at phi_i about
z; ``theta = q + theta0_i`` is the angle the geometry sees; 0 puts the arm along ``u = (cos phi, sin phi, 0)``, positive
turns it towards +z. The parallelogram of a limb only keeps the effector parallel to the base, so its pair of rods
stands for one::

    elbow        B_i = (H + (a + a_i) cos(theta)) u + (a + a_i) sin(theta) z
    effector     C_i = P + p0 + (h + h_i) u
    closure      (|C_i - B_i|^2 - (b + b_i)^2) / 2 = 0          half of equation (4)

Positions P count from the home where the robot file puts it: ``P = home + Pi``, with Pi what an incremental instrument
reads, while the effector stands at ``P + p0``. So p0 is how far the home lies from where the robot file says, the
paper's P_0 less the nominal one. The paper keeps H_i and phi_i at their nominal values, and so does its model of 15. H
enters as ``h - H`` only, so no reading tells the two apart; phi_i can be found (``robotennis/18``).
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from derive.masses import of_arm, of_platform, of_rods
from derive.spec import GeometryKey, LimbMechanism, Quantity, Weight
from derive.steps import Derivation
from derive.vectors import Algebra, vector

DEG = sp.pi / 180

px, py, pz, tx, ty, tz, q = sp.symbols("px py pz tx ty tz q", real=True)
a, b, h, H, phi, hx, hy, hz = sp.symbols("a b h H phi hx hy hz", real=True)
da, db, dh, theta0, dphi, dH = sp.symbols("da db dh theta0 dphi dH", real=True)
px0, py0, pz0 = sp.symbols("px0 py0 pz0", real=True)
tip_v, tip_w = sp.symbols("tip_v tip_w", real=True)
proximal, proximal_com, distal_rod, body, payload = sp.symbols(
    "proximal proximal_com distal_rod platform payload", real=True
)

z = vector(0, 0, 1)
P, tool = vector(px, py, pz), vector(tx, ty, tz)
theta = q + theta0

LIMBS = tuple(f"{e}_{i}" for i in (1, 2, 3) for e in ("a", "b", "h", "theta0"))
HOME = ("px0", "py0", "pz0")
_angle, _length = float(DEG), 1.0  # ordinary errors of a machine built in a workshop, and of its homing [rad, mm]
MACHINE = partial(  # what no rotation enters
    LimbMechanism,
    name="robotennis",
    title="RoboTennis, three arms with rods as single links, incremental home",
    reference="Traslosheros, Sebastian, Torrijos, Carelli, Castillo 2013, Sensors 13(8), 9941-9965",
    source="derive/mechanisms/robotennis.py",
    limbs=3,
    platform=(
        Quantity(px, "mm", "reference point P, x in {O}, counted from the home"),
        Quantity(py, "mm", "reference point P, y in {O}, counted from the home"),
        Quantity(pz, "mm", "reference point P, z in {O}, counted from the home"),
    ),
    tool=(
        Quantity(tx, "mm", "reference point P in {O'}, x"),
        Quantity(ty, "mm", "reference point P in {O'}, y"),
        Quantity(tz, "mm", "reference point P in {O'}, z"),
    ),
    joint=Quantity(q, "rad", "joint angle as the controller reports it, counted from the home"),
    geometry=(
        GeometryKey("arm_length", Quantity(a, "mm", "a: length of the arm")),
        GeometryKey("forearm_length", Quantity(b, "mm", "b: length of the forearm")),
        GeometryKey("effector_radius", Quantity(h, "mm", "h: P to C_i")),
        GeometryKey("base_radius", Quantity(H, "mm", "H: O to A_i")),
        GeometryKey(
            "limb_angle_deg",
            Quantity(phi, "rad", "phi_i: direction of the limb about z"),
            per_limb=True,
            default=tuple(float(v * DEG) for v in (0, 120, 240)),
            positive=False,
        ),
        *(
            GeometryKey("home", Quantity(s, "mm", f"P at the home, {axis}"), positive=False, entry=n)
            for n, (s, axis) in enumerate(zip((hx, hy, hz), "xyz", strict=True))
        ),
    ),
    errors=(
        Quantity(da, "mm", "arm length", typical=_length, label="a"),
        Quantity(db, "mm", "forearm length", typical=_length, label="b"),
        Quantity(dh, "mm", "effector radius less base radius", typical=_length, label="h"),
        Quantity(theta0, "rad", "joint angle at the home", typical=_angle),
        Quantity(dphi, "rad", "direction of the limb about z", typical=_angle, label="phi"),
        Quantity(dH, "mm", "base radius", typical=_length, label="H"),
    ),
    common=(
        Quantity(px0, "mm", "position of the home, x in {O}", typical=10 * _length),
        Quantity(py0, "mm", "position of the home, y in {O}", typical=10 * _length),
        Quantity(pz0, "mm", "position of the home, z in {O}", typical=10 * _length),
    ),
    deflections=(
        Quantity(tip_v, "mm", "arm tip displaced normal to the arm, in its plane"),
        Quantity(tip_w, "mm", "arm tip displaced normal to the arm, along the joint axis"),
    ),
    small=(tip_v, tip_w),
    masses=(
        Quantity(proximal, "1", "mass of an arm [kg]"),
        Quantity(proximal_com, "1", "its centre of mass, as a part of a from A_i"),
        Quantity(distal_rod, "1", "mass of a rod [kg], half at either end"),
        Quantity(body, "1", "mass of the effector [kg], at its centre"),
    ),
    elbow=1,
    assembly=1,
    models={
        "robotennis/15": (*LIMBS, *HOME),
        "robotennis/21": (*LIMBS, *HOME, *(f"{e}_{i}" for e in ("phi", "H") for i in (1, 2, 3))),
        "robotennis/18": (*LIMBS, *HOME, *(f"phi_{i}" for i in (1, 2, 3))),
        "robotennis/12": LIMBS,
        "robotennis/3": ("theta0_1", "theta0_2", "theta0_3"),
    },
    roles={"L": a, "l": b, "b": H},
    moves={
        "offset": {"theta0": sp.Integer(1)},
        "arm": {"a": sp.Integer(1)},
        "rod": {"b": sp.Integer(1)},
        "rod_difference": {},
        "outwards": {"h": sp.Integer(-1)},
        "tip_v": {"tip_v": sp.Integer(1)},
        "tip_w": {"tip_w": sp.Integer(1)},
    },
    rods=("b",),
    layers=(1, 1),
    rods_per_closure=2,
    limb_inertia=proximal * a**2 / 12,  # a slender rod
    scalings={"paper": {}, "table": {}},  # mm and rad
)


def mechanism(v: Algebra) -> LimbMechanism:
    """Return the machine, its rotations written in an algebra."""
    steps = Derivation()
    step = steps.step
    u = step("u", vector(sp.cos(phi + dphi), sp.sin(phi + dphi), 0))
    A = step("A", (H + dH) * u)
    arm = step("arm", sp.cos(theta) * u + sp.sin(theta) * z)
    normal = -sp.sin(theta) * u + sp.cos(theta) * z
    B = step("B", A + (a + da) * arm + tip_v * normal + tip_w * u.cross(z))
    centre = step("centre", P + vector(px0, py0, pz0) - tool)  # of the effector: the tool point is what is read
    C = step("C", centre + (h + dh) * u)
    rod = step("rod", C - B)

    return MACHINE(
        steps=steps,
        loop_closure=((rod.dot(rod) - (b + db) ** 2) / 2,),
        limb_inertials=(*of_arm(A, arm, a + da, a), of_rods([(B, C)], "mass of each rod of the pair", each=2)),
        platform_inertials=of_platform(P - tool, P),
        limb_weights=(
            Weight(proximal, A + proximal_com * (a + da) * arm),
            Weight(distal_rod, B),  # half of either rod of the pair at the elbow
            Weight(distal_rod, C),  # half of either rod at the effector
        ),
        platform_weights=(Weight(body, P - tool), Weight(payload, P)),
    )
