"""Rods of a pair differ and tilt the effector.

Generated from derive/effects/effector_tilt.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both f05a2350ef83ae3c; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 0): nothing;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "effector_tilt"
TITLE = "rods of a pair differ and tilt the effector"
ADVICE = "Geometry, not physics: make the two rods of each pair equally long, on a jig or by exchanging rods."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ()
TARGETS = ("limb.pair_difference", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('dl',), ()),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("dl", "mm", 1.0, "length of rod 1 minus rod 2"),
)
# range of each, in files
BELIEVABLE = ((-5.0, 5.0), )
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
    dl = c[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = dl
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    out = np.zeros((len(s), 1))
    out[:, 0] = 1
    return out.reshape(len(s), 1, 1)
