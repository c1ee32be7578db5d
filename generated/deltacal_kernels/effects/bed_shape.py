"""The bed is not flat.

Generated from derive/effects/bed_shape.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 6c7834f7ba534874; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 3): b p_x p_y;
coefficients c (M or 1, 9); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "bed_shape"
TITLE = "the bed is not flat"
ADVICE = "Use a flatter bed, or print with a bed mesh; the geometry must not take it over."
PER_LIMB = False
STATE = ("b", "p_x", "p_y", )
TARGETS = ("height", )
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("x", "mm", 1.0, "height of the bed along x^1 y^0, at the machine's radius"),
    ("y", "mm", 1.0, "height of the bed along x^0 y^1, at the machine's radius"),
    ("xx", "mm", 1.0, "height of the bed along x^2 y^0, at the machine's radius"),
    ("xy", "mm", 1.0, "height of the bed along x^1 y^1, at the machine's radius"),
    ("yy", "mm", 1.0, "height of the bed along x^0 y^2, at the machine's radius"),
    ("xxx", "mm", 1.0, "height of the bed along x^3 y^0, at the machine's radius"),
    ("xxy", "mm", 1.0, "height of the bed along x^2 y^1, at the machine's radius"),
    ("xyy", "mm", 1.0, "height of the bed along x^1 y^2, at the machine's radius"),
    ("yyy", "mm", 1.0, "height of the bed along x^0 y^3, at the machine's radius"),
)
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ()
CONSTANTS = (
)


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    b = s[:, 0]
    p_x = s[:, 1]
    p_y = s[:, 2]
    x = c[:, 0]
    y = c[:, 1]
    xx = c[:, 2]
    xy = c[:, 3]
    yy = c[:, 4]
    xxx = c[:, 5]
    xxy = c[:, 6]
    xyy = c[:, 7]
    yyy = c[:, 8]
    s0 = (1.0 / b)
    s3 = (1.0 / (b * b))
    s4 = (p_x * p_x)
    s5 = -s3*s4*xx
    s6 = b**(-3)
    s8 = -(p_x * p_x * p_x)*s6*xxx
    s9 = (p_y * p_y)
    s10 = -s3*s9*yy
    s12 = -(p_y * p_y * p_y)*s6*yyy
    s13 = -p_x*p_y*s3*xy
    s14 = -p_x*s6*s9*xyy
    s15 = -p_y*s4*s6*xxy
    s16 = -p_x*s0*x - p_y*s0*y + s10 + s12 + s13 + s14 + s15 + s5 + s8
    out = np.zeros((len(s), 1))
    out[:, 0] = s16
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 9)."""
    b = s[:, 0]
    p_x = s[:, 1]
    p_y = s[:, 2]
    s0 = (1.0 / b)
    s3 = (1.0 / (b * b))
    s4 = (p_x * p_x)
    s6 = b**(-3)
    s9 = (p_y * p_y)
    s17 = -p_x*s0
    s18 = -p_y*s0
    s19 = -s3*s4
    s20 = -p_x*p_y*s3
    s21 = -s3*s9
    s22 = -(p_x * p_x * p_x)*s6
    s23 = -p_y*s4*s6
    s24 = -p_x*s6*s9
    s25 = -(p_y * p_y * p_y)*s6
    out = np.zeros((len(s), 9))
    out[:, 0] = s17
    out[:, 1] = s18
    out[:, 2] = s19
    out[:, 3] = s20
    out[:, 4] = s21
    out[:, 5] = s22
    out[:, 6] = s23
    out[:, 7] = s24
    out[:, 8] = s25
    return out.reshape(len(s), 1, 9)
