"""Tables of `delta`: Delta, three arms and six rods.

Generated from derive/mechanisms/delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/parameters.py.jinja; sha256 of both 7f39e49958dcb2e6; SymPy 1.14.0.
Units: mm, rad, kg.
"""

import numpy as np

NAME = "delta"
MACHINE = "delta"  # whose robot files these are the source errors of
TITLE = "Delta, three arms and six rods"
REFERENCE = "Bai, Mei, Huang, Chetwynd 2015, Proc. IMechE C 230(3), 414-424"
LIMBS = 3
EQUATIONS = 6
RODS = ("l",)
RODS_PER_CLOSURE = 1
JOINT_UNIT = "rad"
LAYERS = (-1, -1)  # of the workspace: sign of the first one's height, direction to the others

# (name, unit, meaning) of the platform's coordinates x: px py pz position, cx cy cz Cayley vector; the others are zero
PLATFORM = (
    ("px", "mm", "reference point P, x in {O}"),
    ("py", "mm", "reference point P, y in {O}"),
    ("pz", "mm", "reference point P, z in {O}"),
    ("cx", "rad", "Cayley vector of the platform's rotation, x"),
    ("cy", "rad", "Cayley vector of the platform's rotation, y"),
    ("cz", "rad", "Cayley vector of the platform's rotation, z"),
)

# (key of the robot file, unit, meaning, one value per limb?, default or None, table of the robot file, a length?,
# entry of a vector or None): the first columns of a limb's row of p
GEOMETRY = (
    ("base_radius", "mm", "b: O to B_i", False, None, "geometry", True, None),
    ("platform_radius", "mm", "a: O' to A_i", False, None, "geometry", True, None),
    ("proximal_length", "mm", "L: length of the arm", False, None, "geometry", True, None),
    ("distal_length", "mm", "l: length of the rods", False, None, "geometry", True, None),
    ("joint_spacing", "mm", "c: spacing of the two S-joints of a limb's end", False, None, "geometry", True, None),
    ("limb_angle_deg", "rad", "phi_i: direction of the limb about z", True, (-1.5707963267948966, 0.5235987755982989, 2.6179938779914944), "joints", True, None),
)

# (name, unit, meaning, size of an ordinary error, names limb by limb): the next columns, one source error each
ERRORS = (
    ("theta", "rad", "encoder offset of the joint", 0.017453292519943295, ("theta_1", "theta_2", "theta_3",)),
    ("ex", "mm", "base point minus platform point, x in {O}", 0.1, ("ex_1", "ex_2", "ex_3",)),
    ("ey", "mm", "base point minus platform point, y in {O}", 0.1, ("ey_1", "ey_2", "ey_3",)),
    ("ez", "mm", "base point minus platform point, z in {O}", 0.1, ("ez_1", "ez_2", "ez_3",)),
    ("L", "mm", "arm length", 0.1, ("L_1", "L_2", "L_3",)),
    ("alpha0", "rad", "joint axis turned about u0 (the limb's direction)", 0.0017453292519943296, ("alpha0_1", "alpha0_2", "alpha0_3",)),
    ("beta0", "rad", "joint axis turned about v0 (the vertical)", 0.0017453292519943296, ("beta0_1", "beta0_2", "beta0_3",)),
    ("l", "mm", "rod length, mean of the pair", 0.1, ("l_1", "l_2", "l_3",)),
    ("dl", "mm", "rod length, rod 1 minus rod 2", 0.1, ("dl_1", "dl_2", "dl_3",)),
    ("dc", "mm", "joint spacing, elbow minus platform", 0.1, ("dc_1", "dc_2", "dc_3",)),
    ("alpha03", "rad", "alpha0 minus the same error at the platform", 0.0017453292519943296, ("alpha03_1", "alpha03_2", "alpha03_3",)),
    ("beta03", "rad", "beta0 minus the same error at the platform", 0.0017453292519943296, ("beta03_1", "beta03_2", "beta03_3",)),
    ("alpha2", "rad", "elbow axis turned about the arm", 0.0017453292519943296, ("alpha2_1", "alpha2_2", "alpha2_3",)),
    ("beta2", "rad", "elbow axis turned about the normal of the arm", 0.0017453292519943296, ("beta2_1", "beta2_2", "beta2_3",)),
)

# the same, one for all limbs: the next columns, equal in every row
COMMON = (
)

# (name, unit, meaning): the last columns, zero on a rigid machine
DEFLECTIONS = (
    ("tip_v", "mm", "arm tip displaced normal to the arm, in its plane"),
    ("tip_w", "mm", "arm tip displaced normal to the arm, along the joint axis"),
)

# columns of a limb's row of p that are zero on the simplified machine, whose positions are closed form
SMALL = (11, 12, 14, 15, 16, 17, 18, 19, 20, 21, )

# (name, meaning) of what `statics` reads as masses
MASSES = (
    ("proximal", "mass of an arm [kg]"),
    ("proximal_com", "its centre of mass, as a part of L from B_i"),
    ("distal_rod", "mass of a rod [kg], half at either end"),
    ("platform", "mass of the platform [kg], at O'"),
)

# model: names of its parameters
MODELS = {
    "delta/42": (
"theta_1", "ex_1", "ey_1", "ez_1", "L_1", "alpha0_1", "beta0_1", "l_1", "dl_1", "dc_1", "alpha03_1", "beta03_1", "alpha2_1", "beta2_1",
"theta_2", "ex_2", "ey_2", "ez_2", "L_2", "alpha0_2", "beta0_2", "l_2", "dl_2", "dc_2", "alpha03_2", "beta03_2", "alpha2_2", "beta2_2",
"theta_3", "ex_3", "ey_3", "ez_3", "L_3", "alpha0_3", "beta0_3", "l_3", "dl_3", "dc_3", "alpha03_3", "beta03_3", "alpha2_3", "beta2_3",
    ),
    "delta/36": (
"theta_1", "ey_1", "L_1", "alpha0_1", "beta0_1", "l_1", "dl_1", "dc_1", "alpha03_1", "beta03_1", "alpha2_1", "beta2_1", "theta_2", "ex_2",
"L_2", "alpha0_2", "beta0_2", "l_2", "dl_2", "dc_2", "alpha03_2", "beta03_2", "alpha2_2", "beta2_2", "theta_3", "ex_3", "L_3", "alpha0_3",
"beta0_3", "l_3", "dl_3", "dc_3", "alpha03_3", "beta03_3", "alpha2_3", "beta2_3",
    ),
    "delta/32": (
"theta_1", "ey_1", "L_1", "alpha0_1", "beta0_1", "l_1", "dl_1", "dc_1", "alpha03_1", "beta03_1", "alpha2_1", "beta2_1", "theta_2", "ex_2",
"L_2", "alpha0_2", "beta0_2", "l_2", "dl_2", "dc_2", "beta03_2", "alpha2_2", "beta2_2", "theta_3", "ex_3", "L_3", "alpha0_3", "beta0_3",
"l_3", "dl_3", "dc_3", "beta2_3",
    ),
    "delta/24": (
"theta_1", "ex_1", "ey_1", "ez_1", "L_1", "alpha0_1", "beta0_1", "l_1", "theta_2", "ex_2", "ey_2", "ez_2", "L_2", "alpha0_2",
"beta0_2", "l_2", "theta_3", "ex_3", "ey_3", "ez_3", "L_3", "alpha0_3", "beta0_3", "l_3",
    ),
    "delta/18": (
"theta_1", "ey_1", "L_1", "alpha0_1", "beta0_1", "l_1", "theta_2", "ex_2", "L_2", "alpha0_2", "beta0_2", "l_2", "theta_3", "ex_3",
"L_3", "alpha0_3", "beta0_3", "l_3",
    ),
    "delta/3": (
"theta_1", "theta_2", "theta_3",
    ),
}


def scaling(convention, geometry):
    """Return {error: factor} by which the columns of `convention` are divided; geometry maps keys to arrays."""
    L = geometry["proximal_length"]
    c = geometry["joint_spacing"]
    return {
        "paper": {
            "theta": L,
            "alpha0": L,
            "beta0": L,
            "dl": (1.0 / c),
            "dc": (1.0 / c),
        },
        "table": {
            "theta": L,
            "alpha0": L,
            "beta0": L,
            "alpha03": c,
            "beta03": c,
            "alpha2": c,
            "beta2": c,
        },
    }[convention]


def roles(geometry):
    """Return what effects read of the geometry, by the names of their state [mm, rad]: one value, or one per limb."""
    b = geometry["base_radius"]
    L = geometry["proximal_length"]
    l = geometry["distal_length"]
    return {
        "L": L,
        "l": l,
        "b": b,
    }


def moves(geometry):
    """Return {what an effect moves: {error or deflection: how much of it}}: one value, or one per limb."""
    phi = geometry["limb_angle_deg"]
    return {
        "offset": {"theta": 1},
        "arm": {"L": 1},
        "rod": {"l": 1},
        "rod_difference": {"dl": 1},
        "outwards": {"ex": np.cos(phi), "ey": np.sin(phi)},
        "tilt_x": {"alpha0": 1, "alpha03": 1},
        "tilt_y": {"beta0": 1, "beta03": 1},
        "tip_v": {"tip_v": 1},
        "tip_w": {"tip_w": 1},
        "spacing_difference": {"dc": 1},
        "hand_axis_u": {"alpha03": 1},
        "hand_axis_v": {"beta03": 1},
        "elbow_axis_u": {"alpha2": 1},
        "elbow_axis_v": {"beta2": 1},
    }


def limb_inertia(geometry, masses):
    """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
    L = geometry["proximal_length"]
    proximal = masses.get("proximal", 0.0)
    return 0.08333333333333333*(L * L)*proximal
