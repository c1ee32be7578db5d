"""What no pose changes: `robotennis`, many machines at once, RoboTennis, three arms with rods as single links, incremental home.

Generated from derive/mechanisms/robotennis.py by "deltacal kernels". Do not edit.
Template templates/mechanism/constants.py.jinja; sha256 of both 897a11d729c9b474; SymPy 1.14.0.

p (M, 3, 19) holds a machine's parameters, one row per limb; a loop over `lane` runs over the limbs
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
        a = p[19 * lane + 0]
        b = p[19 * lane + 1]
        h = p[19 * lane + 2]
        H = p[19 * lane + 3]
        phi = p[19 * lane + 4]
        da = p[19 * lane + 8]
        db = p[19 * lane + 9]
        dh = p[19 * lane + 10]
        theta0 = p[19 * lane + 11]
        dphi = p[19 * lane + 12]
        dH = p[19 * lane + 13]
        px0 = p[19 * lane + 14]
        py0 = p[19 * lane + 15]
        pz0 = p[19 * lane + 16]
        tip_v = p[19 * lane + 17]
        tip_w = p[19 * lane + 18]
        s0 = dphi + phi
        u_x = cosine(s0)
        u_y = sine(s0)
        s3 = H + dH
        A_x = s3*u_x
        A_y = s3*u_y
        s11 = a + da
        s14 = -tip_v*u_x
        s16 = A_x + tip_w*u_y
        s20 = -tip_v*u_y
        s22 = A_y - tip_w*u_x
        s30 = dh + h
        s31 = s30*u_x
        s33 = s30*u_y
        s44 = b + db
        s45 = (s44 * s44)
        s46 = -0.5*s45
        s77 = -s44
        s96 = -A_x + px0 + s31
        s98 = -s11*u_x
        s100 = -A_y + py0 + s33
        s102 = -s11*u_y
        s117 = 0.5*(s11 * s11)*((u_x * u_x) + (u_y * u_y)) + s46
        s122 = -2*a - 2*da
        s124 = 0.25*(s122 * s122)
        s129 = -0.5*s122
        k[24 * lane + 0] = theta0
        k[24 * lane + 1] = u_x
        k[24 * lane + 2] = u_y
        k[24 * lane + 3] = s11
        k[24 * lane + 4] = s14
        k[24 * lane + 5] = s16
        k[24 * lane + 6] = s20
        k[24 * lane + 7] = s22
        k[24 * lane + 8] = tip_v
        k[24 * lane + 9] = px0
        k[24 * lane + 10] = py0
        k[24 * lane + 11] = pz0
        k[24 * lane + 12] = s31
        k[24 * lane + 13] = s33
        k[24 * lane + 14] = s46
        k[24 * lane + 15] = s96
        k[24 * lane + 16] = s98
        k[24 * lane + 17] = s100
        k[24 * lane + 18] = s102
        k[24 * lane + 19] = s117
        k[24 * lane + 20] = s124
        k[24 * lane + 21] = s129
        k[24 * lane + 22] = s77
        k[24 * lane + 23] = s45


@fast
def _constants(p, k):
    _fill_constants(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, 3, 24), what no pose changes, from p (46 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (3, 19):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 3, 19) was expected.")
    k = np.empty((len(p), 3, 24))
    _constants(p, k)
    return k


@straight
def _fill_nominal_constants(p, k, rows):
    for lane in range(rows):
        a = p[19 * lane + 0]
        b = p[19 * lane + 1]
        h = p[19 * lane + 2]
        H = p[19 * lane + 3]
        phi = p[19 * lane + 4]
        u_x = cosine(phi)
        s1 = sine(phi)
        u_y = sine(phi)
        u_y_dphi = cosine(phi)
        A_x = H*u_x
        A_x_dphi = -H*s1
        A_y = H*u_y
        A_y_dphi = H*u_y_dphi
        s33 = h*u_x
        C_x_dphi = -h*s1
        s36 = h*u_y
        C_y_dphi = h*u_y_dphi
        k[14 * lane + 0] = u_x
        k[14 * lane + 1] = s1
        k[14 * lane + 2] = u_y
        k[14 * lane + 3] = u_y_dphi
        k[14 * lane + 4] = a
        k[14 * lane + 5] = A_x
        k[14 * lane + 6] = A_x_dphi
        k[14 * lane + 7] = A_y
        k[14 * lane + 8] = A_y_dphi
        k[14 * lane + 9] = s33
        k[14 * lane + 10] = s36
        k[14 * lane + 11] = C_x_dphi
        k[14 * lane + 12] = C_y_dphi
        k[14 * lane + 13] = b


@fast
def _nominal_constants(p, k):
    _fill_nominal_constants(p, k, p.shape[0] * p.shape[1])


def nominal_constants(p):
    """Return k (M, 3, 14), what `nominal_sensitivity` reads that no pose changes, from p (14 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (3, 19):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 3, 19) was expected.")
    k = np.empty((len(p), 3, 14))
    _nominal_constants(p, k)
    return k
