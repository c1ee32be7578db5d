"""Column leans the more, the higher it is.

Generated from derive/effects/column_lean.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 4f5ac7cdb49535e4; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 7): q on_side_x on_side_y on_tilt_x on_tilt_y foot slides;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "column_lean"
TITLE = "column leans the more, the higher it is"
ADVICE = "Check the column's guides and its foot. The lean repeats with load and height, so that commands by the payload undo it."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("q", "on_side_x", "on_side_y", "on_tilt_x", "on_tilt_y", "foot", "slides", )
TARGETS = ("limb.tilt_x", "limb.tilt_y", "limb.side_x", "limb.side_y", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance',), ('q', 'on_side_y', 'on_tilt_x', 'foot', 'slides')),
    (('compliance',), ('q', 'on_side_x', 'on_tilt_y', 'foot', 'slides')),
    (('compliance',), ('q', 'on_side_x', 'on_tilt_y', 'foot', 'slides')),
    (('compliance',), ('q', 'on_side_y', 'on_tilt_x', 'foot', 'slides')),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("compliance", "deg/(Nm mm)", 1.7453292519943296e-05, "slope of the column's top per moment there and height"),
)
# range of each, in files
BELIEVABLE = ((0.0, 0.001), )
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
    """Return by how much each target is moved, (M, 4)."""
    q = s[:, 0]
    on_side_x = s[:, 1]
    on_side_y = s[:, 2]
    on_tilt_x = s[:, 3]
    on_tilt_y = s[:, 4]
    foot = s[:, 5]
    slides = s[:, 6]
    compliance = c[:, 0]
    s1 = foot + q*slides
    s3 = on_side_y*s1 + on_tilt_x
    s4 = compliance*s1*s3
    s6 = -on_side_x*s1 + on_tilt_y
    s7 = compliance*s1*s6
    s8 = (s1 * s1)
    s9 = -0.5*compliance*s6*s8
    s10 = 0.5*compliance*s3*s8
    out = np.zeros((len(s), 4))
    out[:, 0] = s4
    out[:, 1] = s7
    out[:, 2] = s9
    out[:, 3] = s10
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 4, 1)."""
    q = s[:, 0]
    on_side_x = s[:, 1]
    on_side_y = s[:, 2]
    on_tilt_x = s[:, 3]
    on_tilt_y = s[:, 4]
    foot = s[:, 5]
    slides = s[:, 6]
    s1 = foot + q*slides
    s3 = on_side_y*s1 + on_tilt_x
    s6 = -on_side_x*s1 + on_tilt_y
    s8 = (s1 * s1)
    s11 = s1*s3
    s12 = s1*s6
    s13 = -0.5*s6*s8
    s14 = 0.5*s3*s8
    out = np.zeros((len(s), 4))
    out[:, 0] = s11
    out[:, 1] = s12
    out[:, 2] = s13
    out[:, 3] = s14
    return out.reshape(len(s), 4, 1)
