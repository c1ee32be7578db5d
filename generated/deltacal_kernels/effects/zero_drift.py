"""Joint zero moves with time.

Generated from derive/effects/zero_drift.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both b74e38355002d714; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): time;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "zero_drift"
TITLE = "joint zero moves with time"
ADVICE = "Look for a slipping coupling or an encoder that drifts. Home the joint often until it is found: a drift cannot be foretold."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("time", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('rate',), ('time',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("rate", "deg/h", 0.017453292519943295, "drift of the zero per hour"),
)
# range of each, in files
BELIEVABLE = ((-10.0, 10.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("rate", )
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
    time = s[:, 0]
    rate = c[:, 0]
    s0 = 0.0002777777777777778*rate*time
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    time = s[:, 0]
    s1 = 0.0002777777777777778*time
    out = np.zeros((len(s), 1))
    out[:, 0] = s1
    return out.reshape(len(s), 1, 1)
