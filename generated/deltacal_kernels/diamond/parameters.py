"""Tables of `diamond`: Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/parameters.py.jinja; sha256 of both b92fba8ce4f88713; SymPy 1.14.0.
Units: mm, rad, kg.
"""

NAME = "diamond"
MACHINE = "diamond"  # whose robot files these are the source errors of
TITLE = "Diamond, two arms in a plane"
REFERENCE = "Mei, Zang, Ding, Xie, Zhang, Strojniski vestnik 63(12), 715-724"
LIMBS = 2
EQUATIONS = 2
RODS = ("l",)
RODS_PER_CLOSURE = 1
JOINT_UNIT = "rad"
LAYERS = (-1, -1)  # of the workspace: sign of the first one's height, direction to the others

# (name, unit, meaning) of the platform's coordinates x: px py pz position, cx cy cz Cayley vector; the others are zero
PLATFORM = (
    ("px", "mm", "reference point P, x in {O}"),
    ("py", "mm", "reference point P, y in {O}"),
)

# (key of the robot file, unit, meaning, one value per limb?, default or None, table of the robot file, a length?,
# entry of a vector or None): the first columns of a limb's row of p
GEOMETRY = (
    ("base_x", "mm", "e_x: distance of the motors from {O} along x", False, None, "geometry", True, None),
    ("base_y", "mm", "e_y: height of the motors in {O}", False, None, "geometry", False, None),
    ("proximal_length", "mm", "L: length of the arm", False, None, "geometry", True, None),
    ("distal_length", "mm", "l: length of the distal link", False, None, "geometry", True, None),
    ("side", "1", "on which side of {O} the limb stands, +1 at +x", True, (1.0, -1.0), "joints", True, None),
)

# (name, unit, meaning, size of an ordinary error, names limb by limb): the next columns, one source error each
ERRORS = (
    ("theta", "rad", "zero offset of the joint", 0.017453292519943295, ("theta_1", "theta_2",)),
    ("ex", "mm", "base point, x", 0.1, ("ex_1", "ex_2",)),
    ("ey", "mm", "base point, y", 0.1, ("ey_1", "ey_2",)),
    ("L", "mm", "arm length", 0.1, ("L_1", "L_2",)),
    ("l", "mm", "length of the distal link", 0.1, ("l_1", "l_2",)),
)

# the same, one for all limbs: the next columns, equal in every row
COMMON = (
    ("mx", "mm", "measuring mechanism, both ends together, x", 1.0),
    ("my", "mm", "measuring mechanism, both ends together, y", 1.0),
)

# (name, unit, meaning): the last columns, zero on a rigid machine
DEFLECTIONS = (
    ("tip_v", "mm", "arm tip displaced normal to the arm"),
)

# columns of a limb's row of p that are zero on the simplified machine, whose positions are closed form
SMALL = (12, )

# (name, meaning) of what `statics` reads as masses
MASSES = (
    ("proximal", "mass of an arm [kg]"),
    ("proximal_com", "its centre of mass, as a part of L"),
    ("distal_rod", "mass of a distal link [kg], half at either end"),
    ("platform", "mass of the platform [kg]"),
)

# model: names of its parameters
MODELS = {
    "diamond/12": (
"theta_1", "ex_1", "ey_1", "L_1", "l_1", "theta_2", "ex_2", "ey_2", "L_2", "l_2", "mx", "my",
    ),
    "diamond/10": (
"theta_1", "ex_1", "ey_1", "L_1", "l_1", "theta_2", "ex_2", "ey_2", "L_2", "l_2",
    ),
    "diamond/4": (
"theta_1", "theta_2", "mx", "my",
    ),
    "diamond/2": (
"theta_1", "theta_2",
    ),
}


def scaling(convention, geometry):
    """Return {error: factor} by which the columns of `convention` are divided; geometry maps keys to arrays."""
    L = geometry["proximal_length"]
    return {
        "paper": {
            "theta": L,
        },
        "table": {
            "theta": L,
        },
    }[convention]


def roles(geometry):
    """Return what effects read of the geometry, by the names of their state [mm, rad]: one value, or one per limb."""
    base_x = geometry["base_x"]
    L = geometry["proximal_length"]
    l = geometry["distal_length"]
    return {
        "L": L,
        "l": l,
        "b": base_x,
    }


def moves(geometry):
    """Return {what an effect moves: {error or deflection: how much of it}}: one value, or one per limb."""
    side = geometry["side"]
    return {
        "offset": {"theta": 1},
        "arm": {"L": 1},
        "rod": {"l": 1},
        "outwards": {"ex": side},
        "tip_v": {"tip_v": 1},
    }


def limb_inertia(geometry, masses):
    """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
    L = geometry["proximal_length"]
    proximal = masses.get("proximal", 0.0)
    return 0.08333333333333333*(L * L)*proximal
