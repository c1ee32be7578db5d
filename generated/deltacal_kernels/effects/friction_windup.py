"""Friction winds the joint up, by direction and load.

Generated from derive/effects/friction_windup.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 07ab8d425176a0c0; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): approach torque;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "friction_windup"
TITLE = "friction winds the joint up, by direction and load"
ADVICE = "Look for friction in the joint and for a soft transmission behind it. Until then command by direction of approach and payload."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("approach", "torque", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance',), ('approach', 'torque')),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("compliance", "deg/Nm", 1.7453292519943296e-05, "windup per torque"),
)
# range of each, in files
BELIEVABLE = ((0.0, 1.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("compliance", )
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
    approach = s[:, 0]
    torque = s[:, 1]
    compliance = c[:, 0]
    s1 = -approach*compliance*np.abs(torque)
    out = np.zeros((len(s), 1))
    out[:, 0] = s1
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    approach = s[:, 0]
    torque = s[:, 1]
    s2 = -approach*np.abs(torque)
    out = np.zeros((len(s), 1))
    out[:, 0] = s2
    return out.reshape(len(s), 1, 1)
