"""Links and base grow with temperature.

Generated from derive/effects/thermal_growth.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 500b61552a6ae82e; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 5): warming L l b phi;
coefficients c (M or 1, 3); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "thermal_growth"
TITLE = "links and base grow with temperature"
PER_LIMB = False
STATE = ("warming", "L", "l", "b", "phi", )
TARGETS = ("error.L", "error.l", "error.ex", "error.ey", )
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("expansion_proximal", "1/K", 1.0, "expansion of the arms"),
    ("expansion_distal", "1/K", 1.0, "expansion of the rods"),
    ("expansion_base", "1/K", 1.0, "expansion of the base"),
)
CONSTANTS = (
)


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 4)."""
    warming = s[:, 0]
    L = s[:, 1]
    l = s[:, 2]
    b = s[:, 3]
    phi = s[:, 4]
    expansion_proximal = c[:, 0]
    expansion_distal = c[:, 1]
    expansion_base = c[:, 2]
    s0 = L*expansion_proximal*warming
    s1 = expansion_distal*l*warming
    s3 = b*expansion_base*warming*np.cos(phi)
    s5 = b*expansion_base*warming*np.sin(phi)
    out = np.zeros((len(s), 4))
    out[:, 0] = s0
    out[:, 1] = s1
    out[:, 2] = s3
    out[:, 3] = s5
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 4, 3)."""
    warming = s[:, 0]
    L = s[:, 1]
    l = s[:, 2]
    b = s[:, 3]
    phi = s[:, 4]
    s6 = L*warming
    s7 = l*warming
    s8 = b*warming*np.cos(phi)
    s9 = b*warming*np.sin(phi)
    out = np.zeros((len(s), 12))
    out[:, 0] = s6
    out[:, 4] = s7
    out[:, 8] = s8
    out[:, 11] = s9
    return out.reshape(len(s), 4, 3)
