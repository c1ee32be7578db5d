"""Tables of `simplified_parallelogram`: Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/parameters.py.jinja; sha256 of both a37b0f12f696b16c; SymPy 1.14.0.
Units: mm, rad, kg.
"""

NAME = "simplified_parallelogram"
MACHINE = "planar_parallelogram"  # whose robot files these are the source errors of
TITLE = "Planar parallelogram, simplified: one virtual rod"
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
    ("l1", "mm", "length of the virtual rod", 1.0),
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
    "planar_parallelogram/2": (
"q0", "l1",
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
    l1 = geometry["l1"]
    return {
        "L": l1,
    }


def moves(geometry):
    """Return {what an effect moves: {error or deflection: how much of it}}: one value, or one per limb."""
    return {
        "offset": {"q0": 1},
        "arm": {"l1": 1},
    }


def limb_inertia(geometry, masses):
    """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
    l1 = geometry["l1"]
    proximal = masses.get("proximal", 0.0)
    return 0.08333333333333333*(l1 * l1)*proximal
