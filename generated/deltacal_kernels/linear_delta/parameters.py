"""Tables of `linear_delta`: Linear delta, three towers and six rods.

Generated from derive/mechanisms/linear_delta.py by "deltacal kernels". Do not edit.
Template templates/mechanism/parameters.py.jinja; sha256 of both 05ddf7698794fefc; SymPy 1.14.0.
Units: mm, rad, kg.
"""

import numpy as np

NAME = "linear_delta"
MACHINE = "linear_delta"  # whose robot files these are the source errors of
TITLE = "Linear delta, three towers and six rods"
REFERENCE = "Klipper, klippy/kinematics/delta.py; RepRapFirmware, LinearDeltaKinematics"
LIMBS = 3
EQUATIONS = 6
RODS = ("stretch",)
RODS_PER_CLOSURE = 1
JOINT_UNIT = "mm"
LAYERS = (1, -1)  # of the workspace: sign of the first one's height, direction to the others

# (name, unit, meaning) of the platform's coordinates x: px py pz position, cx cy cz Cayley vector; the others are zero
PLATFORM = (
    ("px", "mm", "nozzle P, x in {O}"),
    ("py", "mm", "nozzle P, y in {O}"),
    ("pz", "mm", "nozzle P, z in {O}"),
    ("cx", "rad", "Cayley vector of the effector's rotation, x"),
    ("cy", "rad", "Cayley vector of the effector's rotation, y"),
    ("cz", "rad", "Cayley vector of the effector's rotation, z"),
)

# (key of the robot file, unit, meaning, one value per limb?, default or None, table of the robot file, a length?,
# entry of a vector or None): the first columns of a limb's row of p
GEOMETRY = (
    ("radius", "mm", "horizontal distance from carriage joint to effector joint", False, None, "geometry", True, None),
    ("arm_length", "mm", "length of the rods", True, None, "geometry", True, None),
    ("tower_angle", "rad", "direction of the tower about z", True, None, "geometry", True, None),
    ("endstop", "mm", "nozzle height when all carriages sit at their endstops", True, None, "geometry", False, None),
    ("effector_radius", "mm", "effector's centre to its joints; only `dl` needs it", False, (30.0,), "geometry", True, None),
    ("rod_spacing", "mm", "spacing of the two rods of a pair; only `dl` needs it", False, (50.0,), "geometry", True, None),
)

# (name, unit, meaning, size of an ordinary error, names limb by limb): the next columns, one source error each
ERRORS = (
    ("endstop", "mm", "height of the endstop", 1.0, ("endstop_1", "endstop_2", "endstop_3",)),
    ("arm", "mm", "rod length, mean of the pair", 0.3, ("arm_1", "arm_2", "arm_3",)),
    ("radius", "mm", "radius of this tower, beside what all share", 0.3, ("radius_1", "radius_2", "radius_3",)),
    ("angle", "rad", "direction of the tower about z", 0.003490658503988659, ("angle_1", "angle_2", "angle_3",)),
    ("lean_radial", "rad", "lean of the tower outwards, about its foot", 0.003490658503988659, ("lean_radial_1", "lean_radial_2", "lean_radial_3",)),
    ("lean_tangential", "rad", "lean of the tower counter-clockwise, about its foot", 0.003490658503988659, ("lean_tangential_1", "lean_tangential_2", "lean_tangential_3",)),
    ("scale", "1", "true way of the carriage per counted way, less 1", 0.0003, ("scale_1", "scale_2", "scale_3",)),
    ("dl", "mm", "rod length, rod 1 minus rod 2", 0.3, ("dl_1", "dl_2", "dl_3",)),
)

# the same, one for all limbs: the next columns, equal in every row
COMMON = (
    ("radius", "mm", "radius, all towers", 0.3),
)

# (name, unit, meaning): the last columns, zero on a rigid machine
DEFLECTIONS = (
    ("stretch", "mm", "rods longer than where the carriage homes"),
)

# columns of a limb's row of p that are zero on the simplified machine, whose positions are closed form
SMALL = (10, 11, 13, 15, )

# (name, meaning) of what `statics` reads as masses
MASSES = (
    ("carriage", "mass of a carriage [kg]"),
    ("distal_rod", "mass of a rod [kg], half at either end"),
    ("platform", "mass of the effector [kg], at its centre"),
)

# model: names of its parameters
MODELS = {
    "linear_delta/21": (
"endstop_1", "arm_1", "radius_1", "angle_1", "lean_radial_1", "lean_tangential_1", "scale_1", "endstop_2", "arm_2", "radius_2", "angle_2", "lean_radial_2", "lean_tangential_2", "scale_2",
"endstop_3", "arm_3", "radius_3", "angle_3", "lean_radial_3", "lean_tangential_3", "scale_3",
    ),
    "linear_delta/9": (
"endstop_1", "endstop_2", "endstop_3", "radius", "angle_1", "angle_2", "arm_1", "arm_2", "arm_3",
    ),
    "linear_delta/6": (
"endstop_1", "endstop_2", "endstop_3", "radius", "angle_1", "angle_2",
    ),
    "linear_delta/4": (
"endstop_1", "endstop_2", "endstop_3", "radius",
    ),
    "linear_delta/3": (
"endstop_1", "endstop_2", "endstop_3",
    ),
}


def scaling(convention, geometry):
    """Return {error: factor} by which the columns of `convention` are divided; geometry maps keys to arrays."""
    return {
    }[convention]


def roles(geometry):
    """Return what effects read of the geometry, by the names of their state [mm, rad]: one value, or one per limb."""
    r = geometry["radius"]
    l = geometry["arm_length"]
    return {
        "l": l,
        "b": r,
    }


def moves(geometry):
    """Return {what an effect moves: {error or deflection: how much of it}}: one value, or one per limb."""
    r = geometry["radius"]
    l = geometry["arm_length"]
    return {
        "rod": {"stretch": 1},
        "rod_difference": {"dl": 1},
        "pair_difference": {"dl": 1},
        "outwards": {"radius": 1, "endstop": r/np.sqrt((l * l) - (r * r))},
        "tilt_x": {"lean_tangential": -1},
        "tilt_y": {"lean_radial": 1},
        "lean_radial": {"lean_radial": 1},
        "lean_tangential": {"lean_tangential": 1},
    }


def limb_inertia(geometry, masses):
    """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
    return 0
