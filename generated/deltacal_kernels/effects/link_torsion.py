"""Link twists about its line under what it carries.

Generated from derive/effects/link_torsion.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 89d274f0c6954f5a; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): on_twist;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "link_torsion"
TITLE = "link twists about its line under what it carries"
ADVICE = "Check the link and its flanges for cracks and loose screws. The twist repeats with the load, so that commands by the payload undo it."
PER_LIMB = True
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("on_twist", )
TARGETS = ("limb.twist", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('compliance',), ('on_twist',)),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("compliance", "deg/Nm", 1.7453292519943296e-05, "twist of a link per moment about its line"),
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
    """Return by how much each target is moved, (M, 1)."""
    on_twist = s[:, 0]
    compliance = c[:, 0]
    s0 = compliance*on_twist
    out = np.zeros((len(s), 1))
    out[:, 0] = s0
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    on_twist = s[:, 0]
    out = np.zeros((len(s), 1))
    out[:, 0] = on_twist
    return out.reshape(len(s), 1, 1)
