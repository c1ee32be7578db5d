"""A measured point is not where it is said to be.

Generated from derive/effects/instrument_offset.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both eb24aa2d7988b12d; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 0): nothing;
coefficients c (M or 1, 3); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "instrument_offset"
TITLE = "a measured point is not where it is said to be"
ADVICE = "The machine is not at fault. Measure again where this reflector or probe sits on the platform, and correct tool_x_mm ... in the recording."
PER_LIMB = False
ACTS_ON = "point"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ()
TARGETS = ("tool.x", "tool.y", "tool.z", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('offset_x',), ()),
    (('offset_y',), ()),
    (('offset_z',), ()),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("offset_x", "mm", 1.0, "offset along x of {O'}"),
    ("offset_y", "mm", 1.0, "offset along y of {O'}"),
    ("offset_z", "mm", 1.0, "offset along z of {O'}"),
)
# range of each, in files
BELIEVABLE = ((-50.0, 50.0), (-50.0, 50.0), (-50.0, 50.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ()
CONSTANTS = (
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"points": "", }
SIZED = {}
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 3)."""
    offset_x = c[:, 0]
    offset_y = c[:, 1]
    offset_z = c[:, 2]
    out = np.zeros((len(s), 3))
    out[:, 0] = offset_x
    out[:, 1] = offset_y
    out[:, 2] = offset_z
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 3, 3)."""
    out = np.zeros((len(s), 9))
    out[:, 0] = 1
    out[:, 4] = 1
    out[:, 8] = 1
    return out.reshape(len(s), 3, 3)
