"""Friction by the square of the speed.

Generated from derive/effects/quadratic_friction.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 115dfdb79c4cdc3c; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): qd;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "quadratic_friction"
TITLE = "friction by the square of the speed"
ADVICE = "Churned oil or air gives more of it than in proportion, grease that thins less (a negative one). Take it along in the feed-forward torque."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qd", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('quadratic',), ('qd',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("quadratic", "Nm s^2/deg^2", 3282806.350011744, "friction per square of the speed"),
)
# range of each, in files
BELIEVABLE = ((-10.0, 10.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("quadratic", )
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
    quadratic = c[:, 0]
    s1 = qd*quadratic*np.abs(qd)
    out = np.zeros((len(s), 1))
    out[:, 0] = s1
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qd = s[:, 0]
    s2 = qd*np.abs(qd)
    out = np.zeros((len(s), 1))
    out[:, 0] = s2
    return out.reshape(len(s), 1, 1)
