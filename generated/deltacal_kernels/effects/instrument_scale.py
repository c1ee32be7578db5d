"""The instrument's length scale is wrong.

Generated from derive/effects/instrument_scale.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 2b4232093a8fd674; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 4): y_x y_y y_z y_length;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "instrument_scale"
TITLE = "the instrument's length scale is wrong"
ADVICE = "The machine is not at fault, unless it is warmer than its drawing. Hold the instrument against a length that is known."
PER_LIMB = False
ACTS_ON = "reading"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("y_x", "y_y", "y_z", "y_length", )
TARGETS = ("reading.x", "reading.y", "reading.z", "length", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('scale',), ('y_x',)),
    (('scale',), ('y_y',)),
    (('scale',), ('y_z',)),
    (('scale',), ('y_length',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("scale", "ppm", 1e-06, "error of the length scale"),
)
# range of each, in files
BELIEVABLE = ((-10000.0, 10000.0), )
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
    """Return by how much each target is moved, (M, 4)."""
    y_x = s[:, 0]
    y_y = s[:, 1]
    y_z = s[:, 2]
    y_length = s[:, 3]
    scale = c[:, 0]
    s0 = scale*y_x
    s1 = scale*y_y
    s2 = scale*y_z
    s3 = scale*y_length
    out = np.zeros((len(s), 4))
    out[:, 0] = s0
    out[:, 1] = s1
    out[:, 2] = s2
    out[:, 3] = s3
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 4, 1)."""
    y_x = s[:, 0]
    y_y = s[:, 1]
    y_z = s[:, 2]
    y_length = s[:, 3]
    out = np.zeros((len(s), 4))
    out[:, 0] = y_x
    out[:, 1] = y_y
    out[:, 2] = y_z
    out[:, 3] = y_length
    return out.reshape(len(s), 4, 1)
