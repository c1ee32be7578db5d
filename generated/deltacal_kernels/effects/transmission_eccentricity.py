"""Periodic error of the transmission.

Generated from derive/effects/transmission_eccentricity.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both bdb35423f400ff9c; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): turn;
coefficients c (M or 1, 2); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "transmission_eccentricity"
TITLE = "periodic error of the transmission"
ADVICE = "Check the gear or encoder disc that turns so often for eccentricity. The error repeats exactly, so that the corrected commands undo it."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = True  # a wave of the joint's turn, cosine and sine
STATE = ("turn", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('cos', 'sin'), ('turn',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("cos", "deg", 0.017453292519943295, "amplitude of the cosine"),
    ("sin", "deg", 0.017453292519943295, "amplitude of the sine"),
)
# range of each, in files
BELIEVABLE = ((-5.0, 5.0), (-5.0, 5.0), )
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
