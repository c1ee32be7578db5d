"""The joint moves with another one.

Generated from derive/effects/joint_coupling.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both ec78b6730a2113a0; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): q_other;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "joint_coupling"
TITLE = "the joint moves with another one"
ADVICE = "Check the coupling of the two joints in the controller (a wrist's gears, a parallelogram's rod, a belt that runs past an axis), and correct its ratio there."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("q_other", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('coupling',), ('q_other',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("coupling", "1", 1.0, "way of the joint per way of the other, in their units"),
)
# range of each, in files
BELIEVABLE = ((-0.2, 0.2), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ()
CONSTANTS = (
    ("of", "1", 1.0, "number of the other joint"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"joints": "of", }
SIZED = {}
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    q_other = s[:, 0]
    coupling = c[:, 0]
    s0 = coupling*q_other
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    q_other = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = q_other
    return out.reshape(len(s), 1, 1)
