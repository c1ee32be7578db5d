"""Joint twists under the payload.

Generated from derive/effects/payload_deflection.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 6bd78fc54bfea7d5; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): payload_torque;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "payload_deflection"
TITLE = "joint twists under the payload"
ADVICE = "Check the gearbox and its fixing for softness. The deflection repeats with the payload, so that commands by it undo it."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("payload_torque", )
TARGETS = ("joint", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance',), ('payload_torque',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("compliance", "deg/Nm", 1.7453292519943296e-05, "twist per torque of the payload"),
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
    payload_torque = s[:, 0]
    compliance = c[:, 0]
    s0 = compliance*payload_torque
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    payload_torque = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = payload_torque
    return out.reshape(len(s), 1, 1)
