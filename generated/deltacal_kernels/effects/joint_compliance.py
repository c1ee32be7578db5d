"""Joint or gearbox twists under the load.

Generated from derive/effects/joint_compliance.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 154723a19f9599ed; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): torque;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "joint_compliance"
TITLE = "joint or gearbox twists under the load"
ADVICE = "Check the gearbox and its fixing for softness. The deflection repeats with the load, so that commands by the payload undo it."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("torque", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance',), ('torque',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("compliance", "deg/Nm", 1.7453292519943296e-05, "twist per static torque"),
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
    torque = s[:, 0]
    compliance = c[:, 0]
    s0 = compliance*torque
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    torque = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = torque
    return out.reshape(len(s), 1, 1)
