"""Joint zero moves with temperature.

Generated from derive/effects/thermal_zero.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both f1fef9788c6913d1; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): warming;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "thermal_zero"
TITLE = "joint zero moves with temperature"
ADVICE = "Look for what moves the encoder or its coupling with heat. Until then command by the temperature, or home again when it has changed."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("warming", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('drift',), ('warming',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("drift", "deg/K", 0.017453292519943295, "drift of the zero"),
)
# range of each, in files
BELIEVABLE = ((-1.0, 1.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("drift", )
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
    warming = s[:, 0]
    drift = c[:, 0]
    s0 = drift*warming
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    warming = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = warming
    return out.reshape(len(s), 1, 1)
