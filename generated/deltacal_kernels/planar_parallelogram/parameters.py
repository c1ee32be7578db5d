"""Tables of `planar_parallelogram`: Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/parameters.py.jinja; sha256 of both cd684031bd32204d; SymPy 1.14.0.
Units: mm, rad, kg.
"""

NAME = "planar_parallelogram"
MACHINE = "planar_parallelogram"  # whose robot files these are the source errors of
TITLE = "Planar parallelogram, one joint"
REFERENCE = "Savoure, Maurine, Corbel, Krut 2006, ICRA, 769-776"
LIMBS = 1
EQUATIONS = 3
RODS = ()
RODS_PER_CLOSURE = 1
JOINT_UNIT = "rad"
LAYERS = (-1, -1)  # of the workspace: sign of the first one's height, direction to the others

# (name, unit, meaning) of the platform's coordinates x: px py pz position, cx cy cz Cayley vector; the others are zero
PLATFORM = (
    ("px", "mm", "reference point, x in {O}"),
    ("py", "mm", "reference point, y in {O}"),
    ("cz", "rad", "Cayley vector of the platform's rotation, z"),
)

# (key of the robot file, unit, meaning, one value per limb?, default or None, table of the robot file, a length?,
# entry of a vector or None): the first columns of a limb's row of p
GEOMETRY = (
    ("a1x", "mm", "A_1 left of O_b", False, None, "geometry", False, None),
    ("a2x", "mm", "A_2 right of O_b", False, None, "geometry", False, None),
    ("a2y", "mm", "A_2 above O_b", False, None, "geometry", False, None),
    ("b1x", "mm", "B_1 left of O_p", False, None, "geometry", False, None),
    ("b2x", "mm", "B_2 right of O_p", False, None, "geometry", False, None),
    ("b2y", "mm", "B_2 above O_p", False, None, "geometry", False, None),
    ("l1", "mm", "length of the driven rod A_1 B_1", False, None, "geometry", True, None),
    ("l2", "mm", "length of the rod A_2 B_2", False, None, "geometry", True, None),
    ("h", "mm", "tool: C below O_p", False, None, "geometry", False, None),
)

# (name, unit, meaning, size of an ordinary error, names limb by limb): the next columns, one source error each
ERRORS = (
)

# the same, one for all limbs: the next columns, equal in every row
COMMON = (
    ("q0", "rad", "encoder offset of the joint", 0.0017453292519943296),
    ("a1x", "mm", "A_1 left of O_b", 1.0),
    ("a2x", "mm", "A_2 right of O_b", 1.0),
    ("a2y", "mm", "A_2 above O_b", 1.0),
    ("b1x", "mm", "B_1 left of O_p", 1.0),
    ("b2x", "mm", "B_2 right of O_p", 1.0),
    ("b2y", "mm", "B_2 above O_p", 1.0),
    ("l1", "mm", "length of the driven rod", 1.0),
    ("l2", "mm", "length of the other rod", 1.0),
)

# (name, unit, meaning): the last columns, zero on a rigid machine
DEFLECTIONS = (
)

# columns of a limb's row of p that are zero on the simplified machine, whose positions are closed form
SMALL = ()

# (name, meaning) of what `statics` reads as masses
MASSES = (
    ("proximal", "mass of the driven rod [kg]"),
    ("proximal_com", "its centre of mass, as a part of l1 from A_1"),
    ("distal_rod", "mass of the other rod [kg], half at either end"),
    ("platform", "mass of the platform [kg], h below O_p: where the tool point counts from"),
)

# model: names of its parameters
MODELS = {
    "planar_parallelogram/9": (
"q0", "a1x", "a2x", "a2y", "b1x", "b2x", "b2y", "l1", "l2",
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
    a1x = geometry["a1x"]
    a2x = geometry["a2x"]
    l1 = geometry["l1"]
    l2 = geometry["l2"]
    return {
        "L": l1,
        "l": l2,
        "b": 0.5*a1x + 0.5*a2x,
    }


def moves(geometry):
    """Return {what an effect moves: {error or deflection: how much of it}}: one value, or one per limb."""
    return {
        "offset": {"q0": 1},
        "arm": {"l1": 1},
        "rod": {"l2": 1},
        "outwards": {"a1x": 1, "a2x": 1},
    }


def limb_inertia(geometry, masses):
    """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
    l1 = geometry["l1"]
    proximal = masses.get("proximal", 0.0)
    return 0.08333333333333333*(l1 * l1)*proximal
