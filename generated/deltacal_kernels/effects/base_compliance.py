"""Frame tilts under the moving weight.

Generated from derive/effects/base_compliance.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 541dcb6feda4b0d1; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): moment_x moment_y;
coefficients c (M or 1, 2); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "base_compliance"
TITLE = "frame tilts under the moving weight"
ADVICE = "Check the frame's fixing and stiffness. Until then command by the payload, or calibrate with the payload that is carried."
PER_LIMB = False
ACTS_ON = "base"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("moment_x", "moment_y", )
TARGETS = ("turn.x", "turn.y", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance_x',), ('moment_x',)),
    (('compliance_y',), ('moment_y',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("compliance_x", "deg/Nm", 1.7453292519943296e-05, "tilt about x per moment about x"),
    ("compliance_y", "deg/Nm", 1.7453292519943296e-05, "tilt about y per moment about y"),
)
# range of each, in files
BELIEVABLE = ((0.0, 1.0), (0.0, 1.0), )
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
    """Return by how much each target is moved, (M, 2)."""
    moment_x = s[:, 0]
    moment_y = s[:, 1]
    compliance_x = c[:, 0]
    compliance_y = c[:, 1]
    s0 = compliance_x*moment_x
    s1 = compliance_y*moment_y
    out = np.zeros((len(s), 2))
    out[:, 0] = s0
    out[:, 1] = s1
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 2, 2)."""
    moment_x = s[:, 0]
    moment_y = s[:, 1]
    out = np.zeros((len(s), 4))
    out[:, 0] = moment_x
    out[:, 3] = moment_y
    return out.reshape(len(s), 2, 2)
