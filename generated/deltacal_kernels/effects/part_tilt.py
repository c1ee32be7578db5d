"""The joint's axis tilts as a recorded column says.

Generated from derive/effects/part_tilt.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 46f920d4731c621d; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): recorded;
coefficients c (M or 1, 2); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "part_tilt"
TITLE = "the joint's axis tilts as a recorded column says"
ADVICE = "Look for what gives way there: a foot, a floor, a foundation, a clamp. Until it is fixed command by the column."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("recorded", )
TARGETS = ("limb.tilt_x", "limb.tilt_y", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('tilt_x',), ('recorded',)),
    (('tilt_y',), ('recorded',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("tilt_x", "deg", 0.017453292519943295, "tilt about x per unit of the column"),
    ("tilt_y", "deg", 0.017453292519943295, "tilt about y per unit of the column"),
)
# range of each, in files
BELIEVABLE = ((-10.0, 10.0), (-10.0, 10.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ()
CONSTANTS = (
    ("of", "1", 1.0, "name of the column"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"columns": "of", }
SIZED = {}
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 2)."""
    recorded = s[:, 0]
    tilt_x = c[:, 0]
    tilt_y = c[:, 1]
    s0 = recorded*tilt_x
    s1 = recorded*tilt_y
    out = np.zeros((len(s), 2))
    out[:, 0] = s0
    out[:, 1] = s1
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 2, 2)."""
    recorded = s[:, 0]
    out = np.zeros((len(s), 4))
    out[:, 0] = recorded
    out[:, 3] = recorded
    return out.reshape(len(s), 2, 2)
