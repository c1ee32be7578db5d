"""More friction near rest than in motion.

Generated from derive/effects/stribeck_friction.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 6b56a3fa31a214cd; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): qd;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "stribeck_friction"
TITLE = "more friction near rest than in motion"
ADVICE = "A joint that sticks: look at the lubrication, and avoid creeping moves."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qd", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('stribeck',), ('qd',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("stribeck", "Nm", 1000.0, "friction that motion takes away"),
)
# range of each, in files
BELIEVABLE = ((0.0, 10000.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("stribeck", "velocity", )
CONSTANTS = (
    ("velocity", "deg/s", 0.017453292519943295, "speed at which most of it is gone"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"sizes": "velocity", }
SIZED = {"velocity": "qd", }
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    qd = s[:, 0]
    stribeck = c[:, 0]
    velocity = constants[0]
    s5 = stribeck*np.exp(-(qd * qd)/(velocity * velocity))*np.sign(qd)
    out = np.zeros((len(s), 1))
    out[:, 0] = s5
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qd = s[:, 0]
    velocity = constants[0]
    s6 = np.exp(-(qd * qd)/(velocity * velocity))*np.sign(qd)
    out = np.zeros((len(s), 1))
    out[:, 0] = s6
    return out.reshape(len(s), 1, 1)
