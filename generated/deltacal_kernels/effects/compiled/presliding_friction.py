"""Dry friction that builds up over a way, row by row for Numba.

Generated from derive/effects/presliding_friction.py by "deltacal kernels". Do not edit.
Template templates/rows.py.jinja; sha256 of both 53a504648f369bdb; SymPy 1.14.0.

Functions of the NumPy module of this name, to be called likewise but for defaults, on C-contiguous arrays. Each is a
loop over rows; an array of one row counts for all of them.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import exponential
from deltacal_kernels.straight import straight

# of the arrays that each takes
DIMENSIONS = {"value": (2, 2, 1), "jacobian": (2, 2, 1), "by_memory": (2, 2, 1), "start": (2, 2, 1), "step": (2, 2, 2, 1, 2, 1)}

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _value(s, c, constants, s_every, c_every, out, many):
    """4 operations a row."""
    for lane in range(many):
        qd = s[s_every * lane + 0]
        stiffness = c[c_every * lane + 0]
        travel = constants[0]
        z = s[s_every * lane + 1]
        s2 = stiffness*travel*(z - (1.0 if (qd > 0) else (-1.0 if (qd < 0) else (0.0 * qd))))
        out[1 * lane + 0] = s2


@fast
def value(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 1))
    _value(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 1)


@straight
def _jacobian(s, c, constants, s_every, c_every, out, many):
    """3 operations a row."""
    for lane in range(many):
        qd = s[s_every * lane + 0]
        travel = constants[0]
        z = s[s_every * lane + 1]
        s3 = travel*(z - (1.0 if (qd > 0) else (-1.0 if (qd < 0) else (0.0 * qd))))
        out[1 * lane + 0] = s3


@fast
def jacobian(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 1))
    _jacobian(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 1, 1)


@straight
def _by_memory(s, c, constants, s_every, c_every, out, many):
    """1 operations a row."""
    for lane in range(many):
        stiffness = c[c_every * lane + 0]
        travel = constants[0]
        s4 = stiffness*travel
        out[1 * lane + 0] = s4


@fast
def by_memory(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 1))
    _by_memory(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 1, 1)


@straight
def _start(s, c, constants, s_every, c_every, out, many):
    """0 operations a row."""


@fast
def start(s, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(s)
    s_every = s.size // len(s) if len(s) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 1))
    _start(s, c, constants, s_every, c_every, out, many)
    return out.reshape(many, 1)


@straight
def _step(z, s, to, h, c, constants, z_every, s_every, to_every, h_every, c_every, out, many):
    """150 operations a row."""
    for lane in range(many):
        qd = s[s_every * lane + 0]
        travel = constants[0]
        qd_to = to[to_every * lane + 0]
        z_here = z[z_every * lane + 0]
        h_here = h[h_every * lane]
        s0 = (1.0 / travel)
        s3 = 0.5*qd + 0.5*qd_to
        x_z = -h_here*s0*s3*(1.0 if (s3 > 0) else (-1.0 if (s3 < 0) else (0.0 * s3)))
        s13 = x_z*(x_z*(x_z*(1.5619206968586225e-16*x_z + 2.8114572543455206e-15) + 4.779477332387385e-14) + 7.647163731819816e-13) + 1.1470745597729725e-11
        s21 = x_z*(x_z*(x_z*(s13*x_z + 1.6059043836821613e-10) + 2.08767569878681e-09) + 2.505210838544172e-08) + 2.755731922398589e-07
        s29 = x_z*(x_z*(x_z*(s21*x_z + 2.7557319223985893e-06) + 2.48015873015873e-05) + 0.0001984126984126984) + 0.001388888888888889
        s37 = x_z*(x_z*(x_z*(s29*x_z + 0.008333333333333333) + 0.041666666666666664) + 0.16666666666666666) + 0.5
        s40 = abs(x_z)
        s42 = exponential(x_z)
        phi1_z = (s37*x_z + 1 if (s40 < 1) else (s42 - 1)/x_z)
        s53 = x_z*(x_z*(x_z*(8.22063524662433e-18*x_z + 1.5619206968586225e-16) + 2.8114572543455206e-15) + 4.779477332387385e-14) + 7.647163731819816e-13
        s61 = x_z*(x_z*(x_z*(s53*x_z + 1.1470745597729725e-11) + 1.6059043836821613e-10) + 2.08767569878681e-09) + 2.505210838544172e-08
        s69 = x_z*(x_z*(x_z*(s61*x_z + 2.755731922398589e-07) + 2.7557319223985893e-06) + 2.48015873015873e-05) + 0.0001984126984126984
        s77 = x_z*(x_z*(x_z*(s69*x_z + 0.001388888888888889) + 0.008333333333333333) + 0.041666666666666664) + 0.16666666666666666
        phi2_z = (s77*x_z + 0.5 if (s40 < 1) else (s42 - x_z - 1)/(x_z * x_z))
        s156 = (1.0 if (qd_to > 0) else (-1.0 if (qd_to < 0) else (0.0 * qd_to)))
        s160 = (1.0 if (qd > 0) else (-1.0 if (qd < 0) else (0.0 * qd)))
        s162 = -s160*z_here + 1
        s167 = phi1_z*qd*s0*s162 + phi2_z*(-qd*s0*s162 + qd_to*s0*(-s156*z_here + 1))
        s169 = h_here*s167 + z_here
        s177 = h_here*(-phi1_z*qd*s0*s160 + phi2_z*(qd*s0*s160 - qd_to*s0*s156)) + 1
        out[3 * lane + 0] = s169
        out[3 * lane + 1] = s177


@fast
def step(z, s, to, h, c, constants):
    """Return what the NumPy function of this name returns."""
    many = len(z)
    z_every = z.size // len(z) if len(z) > 1 else 0
    s_every = s.size // len(s) if len(s) > 1 else 0
    to_every = to.size // len(to) if len(to) > 1 else 0
    h_every = h.size // len(h) if len(h) > 1 else 0
    c_every = c.size // len(c) if len(c) > 1 else 0
    out = np.zeros((many, 3))
    _step(z, s, to, h, c, constants, z_every, s_every, to_every, h_every, c_every, out, many)
    return out.reshape(many, 1, 3)
