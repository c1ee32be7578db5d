"""The joint's centre orbits with its angle.

Generated from derive/effects/joint_axis_runout.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 77b8df5fd2879a62; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 2): theta phi;
coefficients c (M or 1, 2); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "joint_axis_runout"
TITLE = "the joint's centre orbits with its angle"
PER_LIMB = True
STATE = ("theta", "phi", )
TARGETS = ("error.ex", "error.ey", )
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("cos", "mm", 1.0, "amplitude of the cosine"),
    ("sin", "mm", 1.0, "amplitude of the sine"),
)
CONSTANTS = (
)


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 2)."""
    theta = s[:, 0]
    phi = s[:, 1]
    cos = c[:, 0]
    sin = c[:, 1]
    s4 = cos*np.cos(theta) + sin*np.sin(theta)
    s6 = s4*np.cos(phi)
    s8 = s4*np.sin(phi)
    out = np.zeros((len(s), 2))
    out[:, 0] = s6
    out[:, 1] = s8
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 2, 2)."""
    theta = s[:, 0]
    phi = s[:, 1]
    s0 = np.cos(theta)
    s2 = np.sin(theta)
    s5 = np.cos(phi)
    s7 = np.sin(phi)
    s9 = s0*s5
    s10 = s2*s5
    s11 = s0*s7
    s12 = s2*s7
    out = np.zeros((len(s), 4))
    out[:, 0] = s9
    out[:, 1] = s10
    out[:, 2] = s11
    out[:, 3] = s12
    return out.reshape(len(s), 2, 2)
