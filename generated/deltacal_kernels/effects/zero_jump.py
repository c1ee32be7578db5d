"""Joint zero jumps once.

Generated from derive/effects/zero_jump.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 11ab1c9181d4931f; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): after;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "zero_jump"
TITLE = "joint zero jumps once"
ADVICE = "Look for a coupling that slipped or a collision at that time, tighten it, and home the joint. What was taught before is off by the jump."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("after", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('size',), ('after',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("size", "deg", 0.017453292519943295, "size of the jump"),
)
# range of each, in files
BELIEVABLE = ((-30.0, 30.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("size", )
CONSTANTS = (
    ("when", "s", 1.0, "time of the jump; the row, where there is no time"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"moments": "when", }
SIZED = {}
AFTERWARDS = {"when": float("-1000000000000.0"), }


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    after = s[:, 0]
    size = c[:, 0]
    s0 = after*size
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    after = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = after
    return out.reshape(len(s), 1, 1)
