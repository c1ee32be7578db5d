"""The bed is not flat.

Generated from derive/effects/bed_shape.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both 782d144cfed8a29b; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 3): b x y;
coefficients c (M or 1, 9); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "bed_shape"
TITLE = "the bed is not flat"
ADVICE = "Use a flatter bed, or print with a bed mesh; the geometry must not take it over."
PER_LIMB = False
ACTS_ON = "reading"
OVER_ROWS = ("value", "jacobian", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("b", "x", "y", )
TARGETS = ("height", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('x', 'y', 'xx', 'xy', 'yy', 'xxx', 'xxy', 'xyy', 'yyy'), ('b', 'x', 'y')),
)
WHOLE = False
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
# range of each, in files
BELIEVABLE = ((-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), (-5.0, 5.0), )
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
    b = s[:, 0]
    x = s[:, 1]
    y = s[:, 2]
    c_x = c[:, 0]
    c_y = c[:, 1]
    xx = c[:, 2]
    xy = c[:, 3]
    yy = c[:, 4]
    xxx = c[:, 5]
    xxy = c[:, 6]
    xyy = c[:, 7]
    yyy = c[:, 8]
    s0 = (1.0 / b)
    s3 = (1.0 / (b * b))
    s4 = (x * x)
    s5 = -s3*s4*xx
    s6 = b**(-3)
    s8 = -s6*(x * x * x)*xxx
    s9 = (y * y)
    s10 = -s3*s9*yy
    s12 = -s6*(y * y * y)*yyy
    s13 = -s3*x*xy*y
    s14 = -s6*s9*x*xyy
    s15 = -s4*s6*xxy*y
    s16 = -c_x*s0*x - c_y*s0*y + s10 + s12 + s13 + s14 + s15 + s5 + s8
    out = np.zeros((len(s), 1))
    out[:, 0] = s16
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 9)."""
    b = s[:, 0]
    x = s[:, 1]
    y = s[:, 2]
    s0 = (1.0 / b)
    s3 = (1.0 / (b * b))
    s4 = (x * x)
    s6 = b**(-3)
    s9 = (y * y)
    s17 = -s0*x
    s18 = -s0*y
    s19 = -s3*s4
    s20 = -s3*x*y
    s21 = -s3*s9
    s22 = -s6*(x * x * x)
    s23 = -s4*s6*y
    s24 = -s6*s9*x
    s25 = -s6*(y * y * y)
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
