"""What no pose changes: `planar_parallelogram`, many machines at once, Planar parallelogram, one joint.

Generated from derive/mechanisms/planar_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/constants.py.jinja; sha256 of both 3bd2cd4ef60d8e5b; SymPy 1.14.0.

p (M, 1, 18) holds a machine's parameters, one row per limb; a loop over `lane` runs over the limbs
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
        a1x = p[18 * lane + 0]
        a2x = p[18 * lane + 1]
        a2y = p[18 * lane + 2]
        b1x = p[18 * lane + 3]
        b2x = p[18 * lane + 4]
        b2y = p[18 * lane + 5]
        l1 = p[18 * lane + 6]
        l2 = p[18 * lane + 7]
        h = p[18 * lane + 8]
        q0 = p[18 * lane + 9]
        da1x = p[18 * lane + 10]
        da2x = p[18 * lane + 11]
        da2y = p[18 * lane + 12]
        db1x = p[18 * lane + 13]
        db2x = p[18 * lane + 14]
        db2y = p[18 * lane + 15]
        dl1 = p[18 * lane + 16]
        dl2 = p[18 * lane + 17]
        A1_x = -a1x - da1x
        A2_x = a2x + da2x
        A2_y = a2y + da2y
        b1_x = -b1x - db1x
        b2_x = b2x + db2x
        b2_y = b2y + db2y
        s7 = dl1 + l1
        s69 = dl2 + l2
        s71 = -0.5*(s69 * s69)
        s101 = -s69
        s102 = (1.0 / s7)
        s103 = -A1_x + b1_x
        s108 = (1.0 / (s7 * s7))
        s116 = -2*b2_y
        s120 = -2*b2_x*s7
        s122 = 2*b1_x*s7
        s124 = -2*A1_x*b2_y + 2*A2_x*b2_y + 2*A2_y*b1_x - 2*A2_y*b2_x
        s130 = -2*b1_x
        s133 = 2*A1_x*b2_x
        s134 = 2*b2_x
        s136 = -2*b2_y*s7
        s138 = -2*A1_x*b1_x + 2*A2_x*b1_x - 2*A2_x*b2_x - 2*A2_y*b2_y + s133
        s143 = (b2_x * b2_x)
        s144 = (b2_y * b2_y)
        s145 = (A1_x * A1_x)
        s146 = (b1_x * b1_x)
        s147 = (dl2 * dl2)
        s148 = (l2 * l2)
        s149 = (s7 * s7)
        s151 = -2*dl2*l2
        s152 = -2*A1_x*A2_x
        s153 = -2*A2_x
        s155 = -2*b1_x*b2_x
        s156 = 2*A1_x
        s158 = 2*A2_y*s7
        s160 = (A2_x * A2_x) + (A2_y * A2_y) + s143 + s144 + s145 + s146 - s147 - s148 + s151 + s152 + s155
        s195 = -2*A2_y
        k[28 * lane + 0] = h
        k[28 * lane + 1] = q0
        k[28 * lane + 2] = s7
        k[28 * lane + 3] = b1_x
        k[28 * lane + 4] = b2_x
        k[28 * lane + 5] = b2_y
        k[28 * lane + 6] = A2_x
        k[28 * lane + 7] = A2_y
        k[28 * lane + 8] = A1_x
        k[28 * lane + 9] = s71
        k[28 * lane + 10] = s103
        k[28 * lane + 11] = s102
        k[28 * lane + 12] = s108
        k[28 * lane + 13] = s116
        k[28 * lane + 14] = s120
        k[28 * lane + 15] = s122
        k[28 * lane + 16] = s124
        k[28 * lane + 17] = s130
        k[28 * lane + 18] = s134
        k[28 * lane + 19] = s136
        k[28 * lane + 20] = s138
        k[28 * lane + 21] = s149
        k[28 * lane + 22] = s153
        k[28 * lane + 23] = s156
        k[28 * lane + 24] = s158
        k[28 * lane + 25] = s160
        k[28 * lane + 26] = s101
        k[28 * lane + 27] = s195


@fast
def _constants(p, k):
    _fill_constants(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, 1, 28), what no pose changes, from p (91 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (1, 18):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 1, 18) was expected.")
    k = np.empty((len(p), 1, 28))
    _constants(p, k)
    return k
