"""Friction that grows with the load.

Generated from derive/effects/load_friction.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both f1b7a31014e68817; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): qd torque;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "load_friction"
TITLE = "friction that grows with the load"
ADVICE = "Gears lose a part of what they carry. A larger part than last time is wear or want of lubrication."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qd", "torque", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('load',), ('qd', 'torque')),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("load", "1", 1.0, "friction per torque"),
)
# range of each, in files
BELIEVABLE = ((0.0, 1.0), )
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
    """Return by how much each target is moved, (M, 1)."""
    qd = s[:, 0]
    torque = s[:, 1]
    load = c[:, 0]
    s2 = load*np.abs(torque)*np.sign(qd)
    out = np.zeros((len(s), 1))
    out[:, 0] = s2
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qd = s[:, 0]
    torque = s[:, 1]
    s3 = np.abs(torque)*np.sign(qd)
    out = np.zeros((len(s), 1))
    out[:, 0] = s3
    return out.reshape(len(s), 1, 1)
