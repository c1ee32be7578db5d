"""Inertia of the drive.

Generated from derive/effects/rotor_inertia.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both ebb51a29755a64aa; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): qdd;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "rotor_inertia"
TITLE = "inertia of the drive"
ADVICE = "Write it into the robot file (rotor_inertia): the square of the gear ratio makes a small rotor heavy."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qdd", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('inertia',), ('qdd',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("inertia", "kg mm^2", 0.001, "of rotor and gear, counted at the joint"),
)
# range of each, in files
BELIEVABLE = ((0.0, 1000000000.0), )
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
    qdd = s[:, 0]
    inertia = c[:, 0]
    s0 = inertia*qdd
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qdd = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = qdd
    return out.reshape(len(s), 1, 1)
