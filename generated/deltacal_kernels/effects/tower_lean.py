"""The towers lean.

Generated from derive/effects/tower_lean.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both e93ce6507bdec528; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 0): nothing;
coefficients c (M or 1, 2); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "tower_lean"
TITLE = "the towers lean"
ADVICE = "Geometry, not physics: set the towers upright with a square, or identify with linear_delta/21."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ()
TARGETS = ("limb.lean_radial", "limb.lean_tangential", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('radial',), ()),
    (('tangential',), ()),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("radial", "deg", 0.017453292519943295, "lean outwards"),
    ("tangential", "deg", 0.017453292519943295, "lean counter-clockwise"),
)
# range of each, in files
BELIEVABLE = ((-5.0, 5.0), (-5.0, 5.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ()
CONSTANTS = (
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {}
SIZED = {}
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 2)."""
    radial = c[:, 0]
    tangential = c[:, 1]
    out = np.zeros((len(s), 2))
    out[:, 0] = radial
    out[:, 1] = tangential
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 2, 2)."""
    out = np.zeros((len(s), 4))
    out[:, 0] = 1
    out[:, 3] = 1
    return out.reshape(len(s), 2, 2)
