"""A joint lags the others.

Generated from derive/effects/joint_latency.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both ef740ea7b1cf179f; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): qd qdd;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "joint_latency"
TITLE = "a joint lags the others"
ADVICE = "One drive follows its command later than the others, or its encoder is read at another instant. Look at the gains and filters of its controller, and at the order in which joints are read."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qd", "qdd", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('delay',), ('qd', 'qdd')),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("delay", "s", 1.0, "time by which the position lags"),
)
# range of each, in files
BELIEVABLE = ((-1.0, 1.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ()
CONSTANTS = (
)
# what it becomes where its size is large: that is simpler
EXTENDS = "latency"
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {}
SIZED = {}
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    qd = s[:, 0]
    qdd = s[:, 1]
    delay = c[:, 0]
    s3 = 0.5*(delay * delay)*qdd - delay*qd
    out = np.zeros((len(s), 1))
    out[:, 0] = s3
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qd = s[:, 0]
    qdd = s[:, 1]
    delay = c[:, 0]
    s5 = delay*qdd - qd
    out = np.zeros((len(s), 1))
    out[:, 0] = s5
    return out.reshape(len(s), 1, 1)
