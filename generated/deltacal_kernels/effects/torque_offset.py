"""Constant torque.

Generated from derive/effects/torque_offset.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 28854e710ded8bc0; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 0): nothing;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "torque_offset"
TITLE = "constant torque"
ADVICE = "A current sensor's zero, a hanging cable or a spring. Zero the sensor with the drive off."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ()
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('offset',), ()),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("offset", "Nm", 1000.0, "constant reading"),
)
# range of each, in files
BELIEVABLE = ((-10000.0, 10000.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("offset", )
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
    offset = c[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = offset
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    out = np.zeros((len(s), 1))
    out[:, 0] = 1
    return out.reshape(len(s), 1, 1)
