"""Friction that grows with the speed.

Generated from derive/effects/viscous_friction.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 05095af6cd16d861; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): qd;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "viscous_friction"
TITLE = "friction that grows with the speed"
ADVICE = "Every gear has some; cold or wrong grease has more. Warm the machine up, or take it along in the feed-forward torque."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qd", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('viscous',), ('qd',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("viscous", "Nm s/deg", 57295.77951308232, "friction per speed"),
)
# range of each, in files
BELIEVABLE = ((0.0, 1000.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("viscous", )
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
    qd = s[:, 0]
    viscous = c[:, 0]
    s0 = qd*viscous
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qd = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = qd
    return out.reshape(len(s), 1, 1)
