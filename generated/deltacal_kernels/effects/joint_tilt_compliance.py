"""Joint's axis tilts under the moment across it.

Generated from derive/effects/joint_tilt_compliance.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 2badb1955a58b6ba; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): on_tilt_x on_tilt_y;
coefficients c (M or 1, 2); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "joint_tilt_compliance"
TITLE = "joint's axis tilts under the moment across it"
ADVICE = "Check the bearing of the joint for wear and its screws. The tilt repeats with the load, so that commands by the payload undo it."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("on_tilt_x", "on_tilt_y", )
TARGETS = ("limb.tilt_x", "limb.tilt_y", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance_x',), ('on_tilt_x',)),
    (('compliance_y',), ('on_tilt_y',)),
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
    on_tilt_x = s[:, 0]
    on_tilt_y = s[:, 1]
    compliance_x = c[:, 0]
    compliance_y = c[:, 1]
    s0 = compliance_x*on_tilt_x
    s1 = compliance_y*on_tilt_y
    out = np.zeros((len(s), 2))
    out[:, 0] = s0
    out[:, 1] = s1
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 2, 2)."""
    on_tilt_x = s[:, 0]
    on_tilt_y = s[:, 1]
    out = np.zeros((len(s), 4))
    out[:, 0] = on_tilt_x
    out[:, 3] = on_tilt_y
    return out.reshape(len(s), 2, 2)
