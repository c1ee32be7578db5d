"""The instrument slips once.

Generated from derive/effects/instrument_slip.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both ee7546fd4f56c712; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): after;
coefficients c (M or 1, 3); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "instrument_slip"
TITLE = "the instrument slips once"
ADVICE = "The machine is not at fault. Fix the instrument's stand, measure fixed points before and after a session, and give what was read since a set-up of its own."
PER_LIMB = False
ACTS_ON = "reading"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("after", )
TARGETS = ("reading.x", "reading.y", "reading.z", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('offset_x',), ('after',)),
    (('offset_y',), ('after',)),
    (('offset_z',), ('after',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("offset_x", "mm", 1.0, "shift of readings along the instrument's x"),
    ("offset_y", "mm", 1.0, "shift of readings along the instrument's y"),
    ("offset_z", "mm", 1.0, "shift of readings along the instrument's z"),
)
# range of each, in files
BELIEVABLE = ((-50.0, 50.0), (-50.0, 50.0), (-50.0, 50.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ()
CONSTANTS = (
    ("when", "s", 1.0, "time of the slip; the row, where there is no time"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"moments": "when", }
SIZED = {}
AFTERWARDS = {"when": float("-1000000000000.0"), }


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 3)."""
    after = s[:, 0]
    offset_x = c[:, 0]
    offset_y = c[:, 1]
    offset_z = c[:, 2]
    s0 = after*offset_x
    s1 = after*offset_y
    s2 = after*offset_z
    out = np.zeros((len(s), 3))
    out[:, 0] = s0
    out[:, 1] = s1
    out[:, 2] = s2
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 3, 3)."""
    after = s[:, 0]
    out = np.zeros((len(s), 9))
    out[:, 0] = after
    out[:, 4] = after
    out[:, 8] = after
    return out.reshape(len(s), 3, 3)
