"""The joint's centre orbits with its angle.

Generated from derive/effects/joint_axis_runout.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 5f32bac50c5c0882; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): theta;
coefficients c (M or 1, 2); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "joint_axis_runout"
TITLE = "the joint's centre orbits with its angle"
ADVICE = "Check the bearings of the joint axis. The error repeats exactly, so that the corrected commands undo it."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("theta", )
TARGETS = ("limb.outwards", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('cos', 'sin'), ('theta',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("cos", "mm", 1.0, "amplitude of the cosine"),
    ("sin", "mm", 1.0, "amplitude of the sine"),
)
# range of each, in files
BELIEVABLE = ((-5.0, 5.0), (-5.0, 5.0), )
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
    theta = s[:, 0]
    cos = c[:, 0]
    sin = c[:, 1]
    s4 = cos*np.cos(theta) + sin*np.sin(theta)
    out = np.zeros((len(s), 1))
    out[:, 0] = s4
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 2)."""
    theta = s[:, 0]
    s0 = np.cos(theta)
    s2 = np.sin(theta)
    out = np.zeros((len(s), 2))
    out[:, 0] = s0
    out[:, 1] = s2
    return out.reshape(len(s), 1, 2)
