"""Friction that changes with the temperature.

Generated from derive/effects/warm_friction.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 58e21e218d273241; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): qd warming;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "warm_friction"
TITLE = "friction that changes with the temperature"
ADVICE = "Grease thins while the machine warms up. Warm it up before it works, or take the temperature along in the feed-forward torque."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qd", "warming", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('warm',), ('qd', 'warming')),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("warm", "Nm s/(deg K)", 57295.77951308232, "viscous friction per temperature"),
)
# range of each, in files
BELIEVABLE = ((-100.0, 100.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("warm", )
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
    warming = s[:, 1]
    warm = c[:, 0]
    s0 = qd*warm*warming
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qd = s[:, 0]
    warming = s[:, 1]
    s1 = qd*warming
    out = np.zeros((len(s), 1))
    out[:, 0] = s1
    return out.reshape(len(s), 1, 1)
