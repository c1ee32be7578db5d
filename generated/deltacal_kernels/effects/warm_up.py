"""The joint's zero creeps while the machine warms up.

Generated from derive/effects/warm_up.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 78b2eea1d6b8032f; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): passed;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "warm_up"
TITLE = "the joint's zero creeps while the machine warms up"
ADVICE = "Let the machine warm up for some time constants before it is measured or works, and home it then."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("passed", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('size',), ('passed',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("size", "deg", 0.017453292519943295, "shift of the zero when all is warm"),
)
# range of each, in files
BELIEVABLE = ((-5.0, 5.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("size", )
CONSTANTS = (
    ("per", "1", 1.0, "name of the column in which the time constant counts"),
    ("time_constant", "s", 1.0, "time in which all but 1/e of it has come"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"clocks": "per", "sizes": "time_constant", }
SIZED = {"time_constant": "passed", }
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    passed = s[:, 0]
    size = c[:, 0]
    time_constant = constants[1]
    s4 = size*(1 - np.exp(-passed/time_constant))
    out = np.zeros((len(s), 1))
    out[:, 0] = s4
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    passed = s[:, 0]
    time_constant = constants[1]
    s3 = 1 - np.exp(-passed/time_constant)
    out = np.zeros((len(s), 1))
    out[:, 0] = s3
    return out.reshape(len(s), 1, 1)
