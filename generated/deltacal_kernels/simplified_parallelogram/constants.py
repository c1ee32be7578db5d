"""What no pose changes: `simplified_parallelogram`, many machines at once, Planar parallelogram, simplified: one virtual rod.

Generated from derive/mechanisms/simplified_parallelogram.py by "deltacal kernels". Do not edit.
Template templates/mechanism/constants.py.jinja; sha256 of both ced08c63363e2b5e; SymPy 1.14.0.

p (M, 1, 11) holds a machine's parameters, one row per limb; a loop over `lane` runs over the limbs
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
        a1x = p[11 * lane + 0]
        b1x = p[11 * lane + 3]
        l1 = p[11 * lane + 6]
        h = p[11 * lane + 8]
        q0 = p[11 * lane + 9]
        dl1 = p[11 * lane + 10]
        A_x = -a1x + b1x
        s1 = dl1 + l1
        s12 = (1.0 / s1)
        s17 = (1.0 / (s1 * s1))
        k[6 * lane + 0] = q0
        k[6 * lane + 1] = s1
        k[6 * lane + 2] = A_x
        k[6 * lane + 3] = h
        k[6 * lane + 4] = s12
        k[6 * lane + 5] = s17


@fast
def _constants(p, k):
    _fill_constants(p, k, p.shape[0] * p.shape[1])


def constants(p):
    """Return k (M, 1, 6), what no pose changes, from p (5 operations)."""
    p = np.ascontiguousarray(p, dtype=float)
    if p.ndim != 3 or p.shape[1:] != (1, 11):
        raise ValueError(f"parameters have the shape {p.shape}; (M, 1, 11) was expected.")
    k = np.empty((len(p), 1, 6))
    _constants(p, k)
    return k
