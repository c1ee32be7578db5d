"""Tables of `hexapod`: Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/parameters.py.jinja; sha256 of both 9e781194b0dc657a; SymPy 1.14.0.
Units: mm, rad, kg.
"""

import numpy as np

NAME = "hexapod"
MACHINE = "hexapod"  # whose robot files these are the source errors of
TITLE = "Hexapod of Gough and Stewart, six legs"
REFERENCE = "Masory, Wang, Zhuang 1993, IEEE ICRA, 725-731; Stewart 1965, Proc. IMechE 180, 371-386"
LIMBS = 6
EQUATIONS = 6
RODS = ("l",)
RODS_PER_CLOSURE = 1
JOINT_UNIT = "mm"
LAYERS = (1, -1)  # of the workspace: sign of the first one's height, direction to the others

# (name, unit, meaning) of the platform's coordinates x: px py pz position, cx cy cz Cayley vector; the others are zero
PLATFORM = (
    ("px", "mm", "reference point, x in {O}"),
    ("py", "mm", "reference point, y in {O}"),
    ("pz", "mm", "reference point, z in {O}"),
    ("cx", "rad", "Cayley vector of the platform's rotation, x"),
    ("cy", "rad", "Cayley vector of the platform's rotation, y"),
    ("cz", "rad", "Cayley vector of the platform's rotation, z"),
)

# (key of the robot file, unit, meaning, one value per limb?, default or None, table of the robot file, a length?,
# entry of a vector or None): the first columns of a limb's row of p
GEOMETRY = (
    ("base_radius", "mm", "distance of a base joint from {O}'s z axis", True, None, "geometry", True, None),
    ("base_angle", "rad", "direction of a base joint", True, None, "geometry", False, None),
    ("base_height", "mm", "height of a base joint", True, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0), "geometry", False, None),
    ("platform_radius", "mm", "distance of a platform joint from its z axis", True, None, "geometry", True, None),
    ("platform_angle", "rad", "direction of a platform joint", True, None, "geometry", False, None),
    ("platform_height", "mm", "height of a platform joint over the platform's centre", True, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0), "geometry", False, None),
    ("leg_length", "mm", "length of a leg at q = 0", True, None, "geometry", True, None),
)

# (name, unit, meaning, size of an ordinary error, names limb by limb): the next columns, one source error each
ERRORS = (
    ("ax", "mm", "base joint, x in {O}", 0.1, ("ax_1", "ax_2", "ax_3", "ax_4", "ax_5", "ax_6",)),
    ("ay", "mm", "base joint, y in {O}", 0.1, ("ay_1", "ay_2", "ay_3", "ay_4", "ay_5", "ay_6",)),
    ("az", "mm", "base joint, z in {O}", 0.1, ("az_1", "az_2", "az_3", "az_4", "az_5", "az_6",)),
    ("bx", "mm", "platform joint, x in {O'}", 0.1, ("bx_1", "bx_2", "bx_3", "bx_4", "bx_5", "bx_6",)),
    ("by", "mm", "platform joint, y in {O'}", 0.1, ("by_1", "by_2", "by_3", "by_4", "by_5", "by_6",)),
    ("bz", "mm", "platform joint, z in {O'}", 0.1, ("bz_1", "bz_2", "bz_3", "bz_4", "bz_5", "bz_6",)),
    ("l", "mm", "length of the leg at q = 0, with the zero of its drive", 1.0, ("l_1", "l_2", "l_3", "l_4", "l_5", "l_6",)),
    ("scale", "1", "true way of the leg per counted way, less 1", 0.0003, ("scale_1", "scale_2", "scale_3", "scale_4", "scale_5", "scale_6",)),
)

# the same, one for all limbs: the next columns, equal in every row
COMMON = (
    ("tx", "mm", "reference point, x in {O'}", 0.1),
    ("ty", "mm", "reference point, y in {O'}", 0.1),
    ("tz", "mm", "reference point, z in {O'}", 0.1),
)

# (name, unit, meaning): the last columns, zero on a rigid machine
DEFLECTIONS = (
)

# columns of a limb's row of p that are zero on the simplified machine, whose positions are closed form
SMALL = ()

# (name, meaning) of what `statics` reads as masses
MASSES = (
    ("proximal", "mass of the part of a leg that hangs on the base joint [kg]"),
    ("proximal_com", "its centre of mass from there, of leg_length"),
    ("distal_rod", "mass of the part that slides out, a thin rod of leg_length from the platform joint [kg]"),
    ("platform", "mass of the platform [kg], at its centre"),
)

# model: names of its parameters
MODELS = {
    "hexapod/51": (
"ax_1", "ay_1", "az_1", "bx_1", "by_1", "bz_1", "l_1", "scale_1", "ax_2", "ay_2", "az_2", "bx_2", "by_2", "bz_2",
"l_2", "scale_2", "ax_3", "ay_3", "az_3", "bx_3", "by_3", "bz_3", "l_3", "scale_3", "ax_4", "ay_4", "az_4", "bx_4",
"by_4", "bz_4", "l_4", "scale_4", "ax_5", "ay_5", "az_5", "bx_5", "by_5", "bz_5", "l_5", "scale_5", "ax_6", "ay_6",
"az_6", "bx_6", "by_6", "bz_6", "l_6", "scale_6", "tx", "ty", "tz",
    ),
    "hexapod/48": (
"ax_1", "ay_1", "az_1", "bx_1", "by_1", "bz_1", "l_1", "scale_1", "ax_2", "ay_2", "az_2", "bx_2", "by_2", "bz_2",
"l_2", "scale_2", "ax_3", "ay_3", "az_3", "bx_3", "by_3", "bz_3", "l_3", "scale_3", "ax_4", "ay_4", "az_4", "bx_4",
"by_4", "bz_4", "l_4", "scale_4", "ax_5", "ay_5", "az_5", "bx_5", "by_5", "bz_5", "l_5", "scale_5", "ax_6", "ay_6",
"az_6", "bx_6", "by_6", "bz_6", "l_6", "scale_6",
    ),
    "hexapod/42": (
"ax_1", "ay_1", "az_1", "bx_1", "by_1", "bz_1", "l_1", "ax_2", "ay_2", "az_2", "bx_2", "by_2", "bz_2", "l_2",
"ax_3", "ay_3", "az_3", "bx_3", "by_3", "bz_3", "l_3", "ax_4", "ay_4", "az_4", "bx_4", "by_4", "bz_4", "l_4",
"ax_5", "ay_5", "az_5", "bx_5", "by_5", "bz_5", "l_5", "ax_6", "ay_6", "az_6", "bx_6", "by_6", "bz_6", "l_6",
    ),
    "hexapod/6": (
"l_1", "l_2", "l_3", "l_4", "l_5", "l_6",
    ),
}


def scaling(convention, geometry):
    """Return {error: factor} by which the columns of `convention` are divided; geometry maps keys to arrays."""
    return {
    }[convention]


def roles(geometry):
    """Return what effects read of the geometry, by the names of their state [mm, rad]: one value, or one per limb."""
    base = geometry["base_radius"]
    leg = geometry["leg_length"]
    return {
        "l": leg,
        "b": base,
    }


def moves(geometry):
    """Return {what an effect moves: {error or deflection: how much of it}}: one value, or one per limb."""
    alpha = geometry["base_angle"]
    return {
        "rod": {"l": 1},
        "outwards": {"ax": np.cos(alpha), "ay": np.sin(alpha)},
    }


def limb_inertia(geometry, masses):
    """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
    leg = geometry["leg_length"]
    proximal = masses.get("proximal", 0.0)
    return 0.08333333333333333*(leg * leg)*proximal
