"""Dry friction.

Generated from derive/effects/coulomb_friction.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 11f9861169afa522; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): qd;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "coulomb_friction"
TITLE = "dry friction"
ADVICE = "Every joint has some. More than last time is a seal, a bearing under too much preload, or a brake that drags; the feed-forward torque takes it along."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qd", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('coulomb',), ('qd',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("coulomb", "Nm", 1000.0, "dry friction"),
)
# range of each, in files
BELIEVABLE = ((0.0, 10000.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("coulomb", )
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
    coulomb = c[:, 0]
    s1 = coulomb*np.sign(qd)
    out = np.zeros((len(s), 1))
    out[:, 0] = s1
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qd = s[:, 0]
    s0 = np.sign(qd)
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out.reshape(len(s), 1, 1)
