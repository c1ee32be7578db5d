"""Links and base grow with temperature.

Generated from derive/effects/thermal_growth.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 547153078e04719d; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 4): warming L l b;
coefficients c (M or 1, 3); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "thermal_growth"
TITLE = "links and base grow with temperature"
ADVICE = "Measure and work at one temperature, or command by the temperature of the links."
PER_LIMB = False
ACTS_ON = "limb"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("warming", "L", "l", "b", )
TARGETS = ("limb.arm", "limb.rod", "limb.outwards", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('expansion_proximal',), ('warming', 'L')),
    (('expansion_distal',), ('warming', 'l')),
    (('expansion_base',), ('warming', 'b')),
)
WHOLE = False
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("expansion_proximal", "1/K", 1.0, "expansion of the arms, or of a chain's links"),
    ("expansion_distal", "1/K", 1.0, "expansion of the rods"),
    ("expansion_base", "1/K", 1.0, "expansion of the base"),
)
# range of each, in files
BELIEVABLE = ((-1e-05, 0.0001), (-1e-05, 0.0001), (-1e-05, 0.0001), )
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
    """Return by how much each target is moved, (M, 3)."""
    warming = s[:, 0]
    L = s[:, 1]
    l = s[:, 2]
    b = s[:, 3]
    expansion_proximal = c[:, 0]
    expansion_distal = c[:, 1]
    expansion_base = c[:, 2]
    s0 = L*expansion_proximal*warming
    s1 = expansion_distal*l*warming
    s2 = b*expansion_base*warming
    out = np.zeros((len(s), 3))
    out[:, 0] = s0
    out[:, 1] = s1
    out[:, 2] = s2
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 3, 3)."""
    warming = s[:, 0]
    L = s[:, 1]
    l = s[:, 2]
    b = s[:, 3]
    s3 = L*warming
    s4 = l*warming
    s5 = b*warming
    out = np.zeros((len(s), 9))
    out[:, 0] = s3
    out[:, 4] = s4
    out[:, 8] = s5
    return out.reshape(len(s), 3, 3)
