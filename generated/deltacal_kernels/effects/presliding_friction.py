"""Dry friction that builds up over a way.

Generated from derive/effects/presliding_friction.py by "deltacal kernels". Do not edit.
Template templates/effect.py.jinja; sha256 of both c55ac4f20916dc0b; SymPy 1.14.0.

Plain NumPy over M rows (poses times limbs, or poses): state s (M, 1): qd;
coefficients c (M or 1, 1); constants, one number each. Units mm, rad, N, s, K.
"""

import numpy as np

NAME = "presliding_friction"
TITLE = "dry friction that builds up over a way"
ADVICE = "The joint gives before it slides: after each reversal friction comes late. Let the feed-forward follow the way since the reversal, and approach from one side where the last of it counts."
PER_LIMB = True
ACTS_ON = "drive"
OVER_ROWS = ("value", "jacobian", "by_memory", "start", "step", )  # functions over rows, which Numba compiles, too
PERIODIC = False  # a wave of the joint's turn, cosine and sine
STATE = ("qd", )
TARGETS = ("torque", )
# the coefficients in each, and the states; whether it is an effect only where a machine has all that it moves
PARTS = (
    (('stiffness',), ('qd',)),
)
WHOLE = True
# (name, unit in files, factor to the unit inside, meaning)
COEFFICIENTS = (
    ("stiffness", "Nm/deg", 57295.77951308232, "of what gives before the joint slides"),
)
# range of each, in files
BELIEVABLE = ((0.0, 1000000.0), )
# of these a joint that slides has mm for deg and N for Nm
OF_JOINT = ("stiffness", "travel", )
# (name, meaning) of what is remembered along a run: the last columns of s
MEMORY = (
    ("z", "part of the friction that has built up"),
)
CONSTANTS = (
    ("travel", "deg", 0.017453292519943295, "way over which friction builds up"),
)
# what it becomes where its size is large: that is simpler
EXTENDS = ""
# how it is searched, and the constant that is; of what state that is a size; what constants are after the recording
SEARCHED = {"travels": "travel", }
SIZED = {}
AFTERWARDS = {}


def value(s, c, constants=()):
    """Return by how much each target is moved, (M, 1)."""
    qd = s[:, 0]
    stiffness = c[:, 0]
    travel = constants[0]
    z = s[:, 1]
    s2 = stiffness*travel*(z - np.sign(qd))
    out = np.zeros((len(s), 1))
    out[:, 0] = s2
    return out


def jacobian(s, c, constants=()):
    """Return the derivatives of `value` by the coefficients, (M, 1, 1)."""
    qd = s[:, 0]
    travel = constants[0]
    z = s[:, 1]
    s3 = travel*(z - np.sign(qd))
    out = np.zeros((len(s), 1))
    out[:, 0] = s3
    return out.reshape(len(s), 1, 1)


def by_memory(s, c, constants=()):
    """Return the derivatives of `value` by the memories, (M, 1, 1)."""
    stiffness = c[:, 0]
    travel = constants[0]
    s4 = stiffness*travel
    out = np.zeros((len(s), 1))
    out[:, 0] = s4
    return out.reshape(len(s), 1, 1)


def start(s, c, constants=()):
    """Return the memories at the first row of a run, (M, 1); s without memories."""
    out = np.zeros((len(s), 1))
    return out


@np.errstate(all="ignore")  # of what is not chosen
def step(z, s, to, h, c, constants=()):
    """Return the memories z (M, 1) after an interval, (M, 1, 3), and by what they change.

    States, without memories, go straight from s to `to` within the time h (M,) [s]. The derivatives are those of each
    memory by itself at the begin of the interval, then by the coefficients.
    """
    qd = s[:, 0]
    travel = constants[0]
    qd_to = to[:, 0]
    z = z[:, 0]
    s0 = (1.0 / travel)
    s3 = 0.5*qd + 0.5*qd_to
    x_z = -h*s0*s3*np.sign(s3)
    s13 = x_z*(x_z*(x_z*(1.5619206968586225e-16*x_z + 2.8114572543455206e-15) + 4.779477332387385e-14) + 7.647163731819816e-13) + 1.1470745597729725e-11
    s21 = x_z*(x_z*(x_z*(s13*x_z + 1.6059043836821613e-10) + 2.08767569878681e-09) + 2.505210838544172e-08) + 2.755731922398589e-07
    s29 = x_z*(x_z*(x_z*(s21*x_z + 2.7557319223985893e-06) + 2.48015873015873e-05) + 0.0001984126984126984) + 0.001388888888888889
    s37 = x_z*(x_z*(x_z*(s29*x_z + 0.008333333333333333) + 0.041666666666666664) + 0.16666666666666666) + 0.5
    s40 = np.abs(x_z)
    s42 = np.exp(x_z)
    phi1_z = np.where((s40 < 1), s37*x_z + 1, (s42 - 1)/x_z)
    s53 = x_z*(x_z*(x_z*(8.22063524662433e-18*x_z + 1.5619206968586225e-16) + 2.8114572543455206e-15) + 4.779477332387385e-14) + 7.647163731819816e-13
    s61 = x_z*(x_z*(x_z*(s53*x_z + 1.1470745597729725e-11) + 1.6059043836821613e-10) + 2.08767569878681e-09) + 2.505210838544172e-08
    s69 = x_z*(x_z*(x_z*(s61*x_z + 2.755731922398589e-07) + 2.7557319223985893e-06) + 2.48015873015873e-05) + 0.0001984126984126984
    s77 = x_z*(x_z*(x_z*(s69*x_z + 0.001388888888888889) + 0.008333333333333333) + 0.041666666666666664) + 0.16666666666666666
    phi2_z = np.where((s40 < 1), s77*x_z + 0.5, (s42 - x_z - 1)/(x_z * x_z))
    s156 = np.sign(qd_to)
    s160 = np.sign(qd)
    s162 = -s160*z + 1
    s167 = phi1_z*qd*s0*s162 + phi2_z*(-qd*s0*s162 + qd_to*s0*(-s156*z + 1))
    s169 = h*s167 + z
    s177 = h*(-phi1_z*qd*s0*s160 + phi2_z*(qd*s0*s160 - qd_to*s0*s156)) + 1
    out = np.zeros((len(s), 3))
    out[:, 0] = s169
    out[:, 1] = s177
    return out.reshape(len(s), 1, 3)
