"""Play, flips with the direction of approach.

Generated from derive/effects/backlash.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 1746e1c7e30a7be2; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): approach;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "backlash"
TITLE = "play, flips with the direction of approach"
ADVICE = "Look for play in the gearbox and its couplings, and take it out. Until then command by the direction of approach, or always arrive from the same side."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("approach", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('width',), ('approach',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("width", "deg", 0.017453292519943295, "the full gap"),
)
# range of each, in files
BELIEVABLE = ((0.0, 5.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("width", )
CONSTANTS = (
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {}
SIZED = {}
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    approach = s[:, 0]
    width = c[:, 0]
    s0 = -0.5*approach*width
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    approach = s[:, 0]
    s1 = -0.5*approach
    out = np.zeros((len(s), 1))
    out[:, 0] = s1
    return out.reshape(len(s), 1, 1)
