"""What no pose changes: `diamond`, many machines at once, Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/constants.py.jinja; sha256 of both a42d41023ecfc07f; SymPy 1.14.0.

p (M, 2, 13) holds a machine's parameters, one row per limb; a loop over `lane` runs over the limbs
of all machines.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import arcsine, arctangent, cosine, sine, tangent
from deltacal_kernels.straight import straight

fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _fill_constants(p, k, rows):
    for lane in range(rows):
        base_x = p[13 * lane + 0]
        base_y = p[13 * lane + 1]
        L = p[13 * lane + 2]
        l = p[13 * lane + 3]
        side = p[13 * lane + 4]
        theta = p[13 * lane + 5]
        ex = p[13 * lane + 6]
        ey = p[13 * lane + 7]
        dL = p[13 * lane + 8]
        dl = p[13 * lane + 9]
        tip_v = p[13 * lane + 12]
        B_x = base_x*side + ex
        B_y = base_y + ey
        s3 = L + dL
        s6 = theta - 0.5*math.pi*(1 - side)
        s9 = s3*side
        s12 = -side*tip_v
        s26 = dl + l
        s27 = (s26 * s26)
        s28 = -0.5*s27
        s51 = -s26
        s59 = (side * side)
        s60 = (s3 * s3)
        s62 = s28 + 0.5*s59*s60
        s66 = s59*s60
        s71 = s3*s59
        k[12 * lane + 0] = s6
        k[12 * lane + 1] = s9
        k[12 * lane + 2] = s12
        k[12 * lane + 3] = B_x
        k[12 * lane + 4] = B_y
        k[12 * lane + 5] = s28
        k[12 * lane + 6] = s62
        k[12 * lane + 7] = s66
        k[12 * lane + 8] = s71
        k[12 * lane + 9] = side
        k[12 * lane + 10] = s51
        k[12 * lane + 11] = s27


@fast
def _constants(p, k):
    _fill_constants(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, 2, 12), what no pose changes, from p (23 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (2, 13):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 2, 13) was expected.")
    k = np.empty((len(p), 2, 12))
    _constants(p, k)
    return k


@straight
def _fill_nominal_constants(p, k, rows):
    for lane in range(rows):
        base_x = p[13 * lane + 0]
        base_y = p[13 * lane + 1]
        L = p[13 * lane + 2]
        l = p[13 * lane + 3]
        side = p[13 * lane + 4]
        B_x = base_x*side
        s2 = -0.5*math.pi*(1 - side)
        s5 = L*side
        k[6 * lane + 0] = s2
        k[6 * lane + 1] = s5
        k[6 * lane + 2] = B_x
        k[6 * lane + 3] = side
        k[6 * lane + 4] = base_y
        k[6 * lane + 5] = l


@fast
def _nominal_constants(p, k):
    _fill_nominal_constants(p, k, p.shape[0] * p.shape[1])


def nominal_constants(p):
    """Return k (M, 2, 6), what `nominal_sensitivity` reads that no pose changes, from p (6 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (2, 13):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 2, 13) was expected.")
    k = np.empty((len(p), 2, 6))
    _nominal_constants(p, k)
    return k
