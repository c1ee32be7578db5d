"""Arm bends under the rods' pull.

Generated from derive/effects/proximal_bending.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both d2c4606f5c145f6f; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): pull_v pull_w;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "proximal_bending"
TITLE = "arm bends under the rods' pull"
ADVICE = "Check the arm and its clamping for cracks and loose screws. The bending repeats with the load, so that commands by the payload undo it."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("pull_v", "pull_w", )
TARGETS = ("limb.tip_v", "limb.tip_w", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance',), ('pull_v',)),
    (('compliance',), ('pull_w',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("compliance", "mm/N", 1.0, "deflection of the tip per force"),
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
    """Return by how much each target is moved, (M, 2)."""
    pull_v = s[:, 0]
    pull_w = s[:, 1]
    compliance = c[:, 0]
    s0 = compliance*pull_v
    s1 = compliance*pull_w
    out = np.zeros((len(s), 2))
    out[:, 0] = s0
    out[:, 1] = s1
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 2, 1)."""
    pull_v = s[:, 0]
    pull_w = s[:, 1]
    out = np.zeros((len(s), 2))
    out[:, 0] = pull_v
    out[:, 1] = pull_w
    return out.reshape(len(s), 2, 1)
