"""Tables of `robotennis`: RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/parameters.py.jinja; sha256 of both 821f666ddbe32774; SymPy 1.14.0.
Units: mm, rad, kg.
"""

NAME = "robotennis"
MACHINE = "robotennis"  # whose robot files these are the source errors of
TITLE = "RoboTennis, three arms with rods as single links, incremental home"
REFERENCE = "Traslosheros, Sebastian, Torrijos, Carelli, Castillo 2013, Sensors 13(8), 9941-9965"
LIMBS = 3
EQUATIONS = 3
RODS = ("b",)
RODS_PER_CLOSURE = 2
JOINT_UNIT = "rad"
LAYERS = (1, 1)  # of the workspace: sign of the first one's height, direction to the others

# (name, unit, meaning) of the platform's coordinates x: px py pz position, cx cy cz Cayley vector; the others are zero
PLATFORM = (
    ("px", "mm", "reference point P, x in {O}, counted from the home"),
    ("py", "mm", "reference point P, y in {O}, counted from the home"),
    ("pz", "mm", "reference point P, z in {O}, counted from the home"),
)

# (key of the robot file, unit, meaning, one value per limb?, default or None, table of the robot file, a length?,
# entry of a vector or None): the first columns of a limb's row of p
GEOMETRY = (
    ("arm_length", "mm", "a: length of the arm", False, None, "geometry", True, None),
    ("forearm_length", "mm", "b: length of the forearm", False, None, "geometry", True, None),
    ("effector_radius", "mm", "h: P to C_i", False, None, "geometry", True, None),
    ("base_radius", "mm", "H: O to A_i", False, None, "geometry", True, None),
    ("limb_angle_deg", "rad", "phi_i: direction of the limb about z", True, (0.0, 2.0943951023931957, 4.188790204786391), "geometry", False, None),
    ("home", "mm", "P at the home, x", False, None, "geometry", False, 0),
    ("home", "mm", "P at the home, y", False, None, "geometry", False, 1),
    ("home", "mm", "P at the home, z", False, None, "geometry", False, 2),
)

# (name, unit, meaning, size of an ordinary error, names limb by limb): the next columns, one source error each
ERRORS = (
    ("a", "mm", "arm length", 1.0, ("a_1", "a_2", "a_3",)),
    ("b", "mm", "forearm length", 1.0, ("b_1", "b_2", "b_3",)),
    ("h", "mm", "effector radius less base radius", 1.0, ("h_1", "h_2", "h_3",)),
    ("theta0", "rad", "joint angle at the home", 0.017453292519943295, ("theta0_1", "theta0_2", "theta0_3",)),
    ("phi", "rad", "direction of the limb about z", 0.017453292519943295, ("phi_1", "phi_2", "phi_3",)),
    ("H", "mm", "base radius", 1.0, ("H_1", "H_2", "H_3",)),
)

# the same, one for all limbs: the next columns, equal in every row
COMMON = (
    ("px0", "mm", "position of the home, x in {O}", 10.0),
    ("py0", "mm", "position of the home, y in {O}", 10.0),
    ("pz0", "mm", "position of the home, z in {O}", 10.0),
)

# (name, unit, meaning): the last columns, zero on a rigid machine
DEFLECTIONS = (
    ("tip_v", "mm", "arm tip displaced normal to the arm, in its plane"),
    ("tip_w", "mm", "arm tip displaced normal to the arm, along the joint axis"),
)

# columns of a limb's row of p that are zero on the simplified machine, whose positions are closed form
SMALL = (17, 18, )

# (name, meaning) of what `statics` reads as masses
MASSES = (
    ("proximal", "mass of an arm [kg]"),
    ("proximal_com", "its centre of mass, as a part of a from A_i"),
    ("distal_rod", "mass of a rod [kg], half at either end"),
    ("platform", "mass of the effector [kg], at its centre"),
)

# model: names of its parameters
MODELS = {
    "robotennis/15": (
"a_1", "b_1", "h_1", "theta0_1", "a_2", "b_2", "h_2", "theta0_2", "a_3", "b_3", "h_3", "theta0_3", "px0", "py0",
"pz0",
    ),
    "robotennis/21": (
"a_1", "b_1", "h_1", "theta0_1", "a_2", "b_2", "h_2", "theta0_2", "a_3", "b_3", "h_3", "theta0_3", "px0", "py0",
"pz0", "phi_1", "phi_2", "phi_3", "H_1", "H_2", "H_3",
    ),
    "robotennis/18": (
"a_1", "b_1", "h_1", "theta0_1", "a_2", "b_2", "h_2", "theta0_2", "a_3", "b_3", "h_3", "theta0_3", "px0", "py0",
"pz0", "phi_1", "phi_2", "phi_3",
    ),
    "robotennis/12": (
"a_1", "b_1", "h_1", "theta0_1", "a_2", "b_2", "h_2", "theta0_2", "a_3", "b_3", "h_3", "theta0_3",
    ),
    "robotennis/3": (
"theta0_1", "theta0_2", "theta0_3",
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
    a = geometry["arm_length"]
    b = geometry["forearm_length"]
    H = geometry["base_radius"]
    return {
        "L": a,
        "l": b,
        "b": H,
    }


def moves(geometry):
    """Return {what an effect moves: {error or deflection: how much of it}}: one value, or one per limb."""
    return {
        "offset": {"theta0": 1},
        "arm": {"a": 1},
        "rod": {"b": 1},
        "rod_difference": {},
        "outwards": {"h": -1},
        "tip_v": {"tip_v": 1},
        "tip_w": {"tip_w": 1},
    }


def limb_inertia(geometry, masses):
    """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
    a = geometry["arm_length"]
    proximal = masses.get("proximal", 0.0)
    return 0.08333333333333333*(a * a)*proximal
