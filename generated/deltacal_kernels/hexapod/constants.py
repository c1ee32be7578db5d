"""What no pose changes: `hexapod`, many machines at once, Hexapod of Gough and Stewart, six legs.

Generated from derive/mechanisms/hexapod.py by "deltacal kernels". Do not edit.
Template templates/mechanism/constants.py.jinja; sha256 of both d61ba2e26f895f61; SymPy 1.14.0.

p (M, 6, 18) holds a machine's parameters, one row per limb; a loop over `lane` runs over the limbs
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
        base = p[18 * lane + 0]
        alpha = p[18 * lane + 1]
        up = p[18 * lane + 2]
        plate = p[18 * lane + 3]
        beta = p[18 * lane + 4]
        down = p[18 * lane + 5]
        leg = p[18 * lane + 6]
        ax = p[18 * lane + 7]
        ay = p[18 * lane + 8]
        az = p[18 * lane + 9]
        bx = p[18 * lane + 10]
        by = p[18 * lane + 11]
        bz = p[18 * lane + 12]
        dl = p[18 * lane + 13]
        scale = p[18 * lane + 14]
        dtx = p[18 * lane + 15]
        dty = p[18 * lane + 16]
        dtz = p[18 * lane + 17]
        A_x = ax + base*cosine(alpha)
        A_y = ay + base*sine(alpha)
        A_z = az + up
        s44 = bx - dtx + plate*cosine(beta)
        s48 = by - dty + plate*sine(beta)
        s50 = bz + down - dtz
        s67 = scale + 1
        s69 = dl + leg
        s167 = (1.0 / (s67 * s67))
        s183 = (s69 * s69)
        s184 = -0.5*s183
        s186 = 2*s167
        s190 = 2*scale + 2
        s192 = 0.25*s183*(s190 * s190)/(s67 * s67 * s67 * s67)
        s195 = -0.5*s167*s190*s69
        s203 = -(base * base) + 2*base*plate*cosine(alpha - beta) + (leg * leg) - (plate * plate)
        s205 = -down + math.sqrt(s203) + up
        k[13 * lane + 0] = s44
        k[13 * lane + 1] = s48
        k[13 * lane + 2] = s50
        k[13 * lane + 3] = A_x
        k[13 * lane + 4] = A_y
        k[13 * lane + 5] = A_z
        k[13 * lane + 6] = s67
        k[13 * lane + 7] = s69
        k[13 * lane + 8] = s184
        k[13 * lane + 9] = s186
        k[13 * lane + 10] = s192
        k[13 * lane + 11] = s195
        k[13 * lane + 12] = s205


@fast
def _constants(p, k):
    _fill_constants(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, 6, 13), what no pose changes, from p (51 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (6, 18):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 6, 18) was expected.")
    k = np.empty((len(p), 6, 13))
    _constants(p, k)
    return k
