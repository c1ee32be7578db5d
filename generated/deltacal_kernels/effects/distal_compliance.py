"""Rods stretch.

Generated from derive/effects/distal_compliance.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both e028722e82533070; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): tension_1 tension_2;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "distal_compliance"
TITLE = "rods stretch"
ADVICE = "Check the rods and their ball joints for softness. Until then command by the payload."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("tension_1", "tension_2", )
TARGETS = ("limb.rod", "limb.rod_difference", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance',), ('tension_1', 'tension_2')),
    (('compliance',), ('tension_1', 'tension_2')),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("compliance", "mm/N", 1.0, "lengthening of a rod per tension"),
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
    tension_1 = s[:, 0]
    tension_2 = s[:, 1]
    compliance = c[:, 0]
    s1 = 0.5*compliance*(tension_1 + tension_2)
    s3 = compliance*(tension_1 - tension_2)
    out = np.zeros((len(s), 2))
    out[:, 0] = s1
    out[:, 1] = s3
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 2, 1)."""
    tension_1 = s[:, 0]
    tension_2 = s[:, 1]
    s2 = tension_1 - tension_2
    s6 = 0.5*tension_1 + 0.5*tension_2
    out = np.zeros((len(s), 2))
    out[:, 0] = s6
    out[:, 1] = s2
    return out.reshape(len(s), 2, 1)
