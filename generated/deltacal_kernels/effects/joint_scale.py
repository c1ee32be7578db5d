"""Gear ratio or encoder scale is off.

Generated from derive/effects/joint_scale.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 241ddbe6d8cf74ba; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): q;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "joint_scale"
TITLE = "gear ratio or encoder scale is off"
ADVICE = "Check the gear ratio and the encoder's counts per turn in the controller, and correct them there."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("q", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('scale',), ('q',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("scale", "1", 1.0, "error of the scale"),
)
# range of each, in files
BELIEVABLE = ((-0.025, 0.025), )
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
    """Return by how much each target is moved, (M, 1)."""
    q = s[:, 0]
    scale = c[:, 0]
    s0 = q*scale
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    q = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = q
    return out.reshape(len(s), 1, 1)
