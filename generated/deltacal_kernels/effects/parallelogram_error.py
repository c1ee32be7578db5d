"""Rods, spacings or axes of a parallelogram differ.

Generated from derive/effects/parallelogram_error.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both a1815c19e20c87dd; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 0): nothing;
coefficients c (M or 1, 6); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "parallelogram_error"
TITLE = "rods, spacings or axes of a parallelogram differ"
ADVICE = "Geometry, not physics: identify with the full model, which takes these errors into the commands."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ()
TARGETS = ("limb.rod_difference", "limb.spacing_difference", "limb.hand_axis_u", "limb.hand_axis_v", "limb.elbow_axis_u", "limb.elbow_axis_v", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('dl',), ()),
    (('dc',), ()),
    (('alpha03',), ()),
    (('beta03',), ()),
    (('alpha2',), ()),
    (('beta2',), ()),
)
WHOLE = True
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("dl", "mm", 1.0, "length of rod 1 minus rod 2"),
    ("dc", "mm", 1.0, "spacing at the elbow minus spacing at the platform"),
    ("alpha03", "deg", 0.017453292519943295, "alpha0 minus the same error at the platform"),
    ("beta03", "deg", 0.017453292519943295, "beta0 minus the same error at the platform"),
    ("alpha2", "deg", 0.017453292519943295, "elbow axis turned about the arm"),
    ("beta2", "deg", 0.017453292519943295, "elbow axis turned about the normal of the arm"),
)
# range of each, in files
BELIEVABLE = ((-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), )
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
    """Return by how much each target is moved, (M, 6)."""
    dl = c[:, 0]
    dc = c[:, 1]
    alpha03 = c[:, 2]
    beta03 = c[:, 3]
    alpha2 = c[:, 4]
    beta2 = c[:, 5]
    out = np.zeros((len(s), 6))
    out[:, 0] = dl
    out[:, 1] = dc
    out[:, 2] = alpha03
    out[:, 3] = beta03
    out[:, 4] = alpha2
    out[:, 5] = beta2
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 6, 6)."""
    out = np.zeros((len(s), 36))
    out[:, 0] = 1
    out[:, 7] = 1
    out[:, 14] = 1
    out[:, 21] = 1
    out[:, 28] = 1
    out[:, 35] = 1
    return out.reshape(len(s), 6, 6)
