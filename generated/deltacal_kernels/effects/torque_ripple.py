"""Torque that repeats with the turn of the joint.

Generated from derive/effects/torque_ripple.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 6d9b08de66b6f689; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): turn;
coefficients c (M or 1, 2); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "torque_ripple"
TITLE = "torque that repeats with the turn of the joint"
ADVICE = "Cogging of the motor or a tooth of the gear: the order says which part turns so often. It repeats exactly, so that the feed-forward torque takes it along."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("turn", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('cos', 'sin'), ('turn',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("cos", "Nm", 1000.0, "amplitude of the cosine"),
    ("sin", "Nm", 1000.0, "amplitude of the sine"),
)
# range of each, in files
BELIEVABLE = ((-10000.0, 10000.0), (-10000.0, 10000.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("cos", "sin", )
CONSTANTS = (
    ("order", "1", 1.0, "periods per turn of the joint"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"orders": "order", }
SIZED = {}
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    turn = s[:, 0]
    cos = c[:, 0]
    sin = c[:, 1]
    order = constants[0]
    s0 = order*turn
    s5 = cos*np.cos(s0) + sin*np.sin(s0)
    out = np.zeros((len(s), 1))
    out[:, 0] = s5
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 2)."""
    turn = s[:, 0]
    order = constants[0]
    s0 = order*turn
    s1 = np.cos(s0)
    s3 = np.sin(s0)
    out = np.zeros((len(s), 2))
    out[:, 0] = s1
    out[:, 1] = s3
    return out.reshape(len(s), 1, 2)
