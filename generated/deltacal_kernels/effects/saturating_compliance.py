"""Joint gives way under the load, less and less.

Generated from derive/effects/saturating_compliance.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 0a0c6e182be04d8f; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): torque;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "saturating_compliance"
TITLE = "joint gives way under the load, less and less"
ADVICE = "Look for play under preload, a soft coupling with a stop, or a flexspline that hardens. The deflection repeats with the load, so that commands by the payload undo it."
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
    ("compliance", "deg/Nm", 1.7453292519943296e-05, "twist per torque while that is small"),
)
# range of each, in files
BELIEVABLE = ((0.0, 1.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("compliance", "limit", )
CONSTANTS = (
    ("limit", "Nm", 1000.0, "torque about which the spring hardens"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = "joint_compliance"
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"sizes": "limit", }
SIZED = {"limit": "torque", }
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    torque = s[:, 0]
    compliance = c[:, 0]
    limit = constants[0]
    s3 = compliance*limit*np.tanh(torque/limit)
    out = np.zeros((len(s), 1))
    out[:, 0] = s3
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    torque = s[:, 0]
    limit = constants[0]
    s4 = limit*np.tanh(torque/limit)
    out = np.zeros((len(s), 1))
    out[:, 0] = s4
    return out.reshape(len(s), 1, 1)
