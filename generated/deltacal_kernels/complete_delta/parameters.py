"""Tables of `complete_delta`: Delta, complete geometry of the six rods.

Generated from derive/mechanisms/complete_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/parameters.py.jinja; sha256 of both 1e41e62812770f9f; SymPy 1.14.0.
Units: mm, rad, kg.
"""

import numpy as np

NAME = "complete_delta"
MACHINE = "delta"  # whose robot files these are the source errors of
TITLE = "Delta, complete geometry of the six rods"
REFERENCE = "Savoure, Maurine, Corbel, Krut 2006, ICRA, 769-776"
LIMBS = 3
EQUATIONS = 6
RODS = ("l_{i}1", "l_{i}2",)
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
    ("bx_{i}1", "mm", "rod 1: B in the platform, x", 0.1, ("bx_11", "bx_21", "bx_31",)),
    ("by_{i}1", "mm", "rod 1: B in the platform, y", 0.1, ("by_11", "by_21", "by_31",)),
    ("bz_{i}1", "mm", "rod 1: B in the platform, z", 0.1, ("bz_11", "bz_21", "bz_31",)),
    ("ax_{i}1", "mm", "rod 1: A in the arm, x", 0.1, ("ax_11", "ax_21", "ax_31",)),
    ("ay_{i}1", "mm", "rod 1: A in the arm, y", 0.1, ("ay_11", "ay_21", "ay_31",)),
    ("az_{i}1", "mm", "rod 1: A in the arm, z", 0.1, ("az_11", "az_21", "az_31",)),
    ("l_{i}1", "mm", "length of rod 1", 0.1, ("l_11", "l_21", "l_31",)),
    ("bx_{i}2", "mm", "rod 2: B in the platform, x", 0.1, ("bx_12", "bx_22", "bx_32",)),
    ("by_{i}2", "mm", "rod 2: B in the platform, y", 0.1, ("by_12", "by_22", "by_32",)),
    ("bz_{i}2", "mm", "rod 2: B in the platform, z", 0.1, ("bz_12", "bz_22", "bz_32",)),
    ("ax_{i}2", "mm", "rod 2: A in the arm, x", 0.1, ("ax_12", "ax_22", "ax_32",)),
    ("ay_{i}2", "mm", "rod 2: A in the arm, y", 0.1, ("ay_12", "ay_22", "ay_32",)),
    ("az_{i}2", "mm", "rod 2: A in the arm, z", 0.1, ("az_12", "az_22", "az_32",)),
    ("l_{i}2", "mm", "length of rod 2", 0.1, ("l_12", "l_22", "l_32",)),
    ("betax", "rad", "joint's axis and zero turned about x of {O}", 0.0017453292519943296, ("betax_1", "betax_2", "betax_3",)),
    ("betay", "rad", "joint's axis and zero turned about y of {O}", 0.0017453292519943296, ("betay_1", "betay_2", "betay_3",)),
    ("betaz", "rad", "joint's axis and zero turned about z of {O}", 0.0017453292519943296, ("betaz_1", "betaz_2", "betaz_3",)),
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
SMALL = (6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, )

# (name, meaning) of what `statics` reads as masses
MASSES = (
    ("proximal", "mass of an arm [kg]"),
    ("proximal_com", "its centre of mass, as a part of L from B_i"),
    ("distal_rod", "mass of a rod [kg], half at either end"),
    ("platform", "mass of the platform [kg], at O'"),
)

# model: names of its parameters
MODELS = {
    "delta/51": (
"bx_11", "by_11", "bz_11", "ax_11", "ay_11", "az_11", "l_11", "bx_12", "by_12", "bz_12", "ax_12", "ay_12", "az_12", "l_12",
"betax_1", "betay_1", "betaz_1", "bx_21", "by_21", "bz_21", "ax_21", "ay_21", "az_21", "l_21", "bx_22", "by_22", "bz_22", "ax_22",
"ay_22", "az_22", "l_22", "betax_2", "betay_2", "betaz_2", "bx_31", "by_31", "bz_31", "ax_31", "ay_31", "az_31", "l_31", "bx_32",
"by_32", "bz_32", "ax_32", "ay_32", "az_32", "l_32", "betax_3", "betay_3", "betaz_3",
    ),
}


def scaling(convention, geometry):
    """Return {error: factor} by which the columns of `convention` are divided; geometry maps keys to arrays."""
    return {
        "paper": {
        },
        "table": {
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
    c = geometry["joint_spacing"]
    phi = geometry["limb_angle_deg"]
    return {
        "offset": {"betax": np.sin(phi), "betay": -np.cos(phi)},
        "arm": {"ay_{i}1": 1, "ay_{i}2": 1},
        "rod": {"l_{i}1": 1, "l_{i}2": 1},
        "rod_difference": {"l_{i}1": 0.5, "l_{i}2": -0.5},
        "outwards": {"bx_{i}1": -np.cos(phi), "bx_{i}2": -np.cos(phi), "by_{i}1": -np.sin(phi), "by_{i}2": -np.sin(phi)},
        "tilt_x": {"betax": np.cos(phi), "betay": np.sin(phi)},
        "tilt_y": {"betaz": 1},
        "tip_v": {"tip_v": 1},
        "tip_w": {"tip_w": 1},
        "spacing_difference": {"ax_{i}1": 0.5, "ax_{i}2": -0.5},
        "hand_axis_u": {"bz_{i}1": 0.5*c, "bz_{i}2": -0.5*c},
        "hand_axis_v": {"bx_{i}1": -0.5*c*np.cos(phi), "bx_{i}2": 0.5*c*np.cos(phi), "by_{i}1": -0.5*c*np.sin(phi), "by_{i}2": 0.5*c*np.sin(phi)},
        "elbow_axis_u": {"az_{i}1": -0.5*c, "az_{i}2": 0.5*c},
        "elbow_axis_v": {"ay_{i}1": 0.5*c, "ay_{i}2": -0.5*c},
    }


def limb_inertia(geometry, masses):
    """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
    L = geometry["proximal_length"]
    proximal = masses.get("proximal", 0.0)
    return 0.08333333333333333*(L * L)*proximal
