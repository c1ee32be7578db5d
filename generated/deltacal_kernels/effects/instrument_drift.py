"""The instrument drifts.

Generated from derive/effects/instrument_drift.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 2298d5345b10784e; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): time;
coefficients c (M or 1, 3); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "instrument_drift"
TITLE = "the instrument drifts"
ADVICE = "The machine is not at fault. Let the instrument warm up, fix its stand, and measure a fixed point again and again."
PER_LIMB = False
ACTS_ON = "reading"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("time", )
TARGETS = ("reading.x", "reading.y", "reading.z", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('rate_x',), ('time',)),
    (('rate_y',), ('time',)),
    (('rate_z',), ('time',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("rate_x", "mm/h", 1.0, "drift along the instrument's x"),
    ("rate_y", "mm/h", 1.0, "drift along the instrument's y"),
    ("rate_z", "mm/h", 1.0, "drift along the instrument's z"),
)
# range of each, in files
BELIEVABLE = ((-10.0, 10.0), (-10.0, 10.0), (-10.0, 10.0), )
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
    """Return by how much each target is moved, (M, 3)."""
    time = s[:, 0]
    rate_x = c[:, 0]
    rate_y = c[:, 1]
    rate_z = c[:, 2]
    s0 = 0.0002777777777777778*rate_x*time
    s1 = 0.0002777777777777778*rate_y*time
    s2 = 0.0002777777777777778*rate_z*time
    out = np.zeros((len(s), 3))
    out[:, 0] = s0
    out[:, 1] = s1
    out[:, 2] = s2
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 3, 3)."""
    time = s[:, 0]
    s3 = 0.0002777777777777778*time
    out = np.zeros((len(s), 9))
    out[:, 0] = s3
    out[:, 4] = s3
    out[:, 8] = s3
    return out.reshape(len(s), 3, 3)
