"""Derivatives of the nominal machine's position by its errors, many poses at once: `diamond`, Diamond, two arms in a plane.

Generated from derive/mechanisms/diamond.py by "deltacal kernels". Do not edit.
Template templates/mechanism/nominal.py.jinja; sha256 of both 5267f783ec45100c; SymPy 1.14.0.

Rods of a pair are parallel there, and the platform does not turn, which leaves little of the exact machine's
derivatives. x (N, 2) is the position of the reference point, q (N, 2) the joints there, tool
(N or 1, 3) the reference point in {O'}, k from `nominal_constants` of the nominal machine: errors and
deflections among its parameters play no part. Poses stand side by side as in ``kinematics.py``. The functions return
False where the machine is singular at one of the poses, or nearly so.
"""

import math

import numpy as np

from deltacal_kernels.cache import kernel
from deltacal_kernels.elementary import arctangent, cosine, outer, outer_of, scratch, sine, tangent, wide
from deltacal_kernels.straight import straight

from .blocks import LANES, SPARE, WORK, aim, hold, load

# where in w the terms of each column of the sensitivity have their factors and values
FACTORS = np.array(((1920, 1920, 1920, 1920, 1920, 1920, 1920, 1952, 1952, 1952, 1952, 1952, 1952, 1952),))
VALUES = np.array(((640, 672, 704, 736, 768, 800, 832, 1536, 1568, 1600, 1632, 1664, 1696, 1728),))
fast = kernel(nogil=True, error_model="numpy", fastmath={"contract"})


@straight
def _nominal(w, k, n):
    """Equations of a nominal limb by platform and errors (26 operations)."""
    s2 = k[0]
    s5 = k[1]
    B_x = k[2]
    side = k[3]
    base_y = k[4]
    l = k[5]
    for lane in range(n):
        q = w[0 + lane]
        tx = w[32 + lane]
        ty = w[64 + lane]
        px = w[128 + lane]
        py = w[160 + lane]
        s3 = q + s2
        s4 = cosine(s3)
        C_x = B_x + s4*s5
        s8 = sine(s3)
        C_x_theta = -s5*s8
        C_x_dL = s4*side
        C_y = -C_x_theta + base_y
        C_y_theta = s4*s5
        C_y_dL = s8*side
        A_x = px - tx
        A_y = py - ty
        d_x = A_x - C_x
        d_y = A_y - C_y
        s20 = -C_x_theta*d_x - C_y_theta*d_y
        s23 = -C_x_dL*d_x - C_y_dL*d_y
        w[224 + lane] = d_x
        w[256 + lane] = d_y
        w[640 + lane] = s20
        w[672 + lane] = -d_x
        w[704 + lane] = -d_y
        w[736 + lane] = s23
        w[768 + lane] = -l
        w[800 + lane] = 0
        w[832 + lane] = 0


@straight
def _nominal_inverse(w, n):
    """Minus the inverse of the derivatives, its rows of the position; how far the equations are from dependent (24 operations)."""
    for lane in range(n):
        J00_0 = w[224 + lane]
        J10_0 = w[1120 + lane]
        J00_1 = w[256 + lane]
        J10_1 = w[1152 + lane]
        G_det_00 = J00_0*J10_1 - J00_1*J10_0
        G_by_00 = (1.0 / G_det_00)
        G_inv_00 = G_by_00*J10_1
        G_inv_01 = -G_by_00*J00_1
        G_inv_10 = -G_by_00*J10_0
        G_inv_11 = G_by_00*J00_0
        s16 = (G_det_00 * G_det_00) - 1.0e-12*((J00_0 * J00_0) + (J00_1 * J00_1))*((J10_0 * J10_0) + (J10_1 * J10_1))
        w[1920 + lane] = -G_inv_00
        w[1952 + lane] = -G_inv_01
        w[1984 + lane] = -G_inv_10
        w[2016 + lane] = -G_inv_11
        w[2048 + lane] = s16


@straight
def _singular(w, poses):
    """Return how many of the poses are not regular."""
    many = 0
    for lane in range(poses):
        many += 0 if (w[2048 + lane] > 0.0) else 1
    return many


@fast
def _products(w, S, first, last):
    """Multiply the inverse and the derivatives by the errors where they do not vanish."""
    wide()
    for lane in range(0, last - first + 1, 8):
        whole = 28 * (first + lane + 8) <= S.size  # else the last poses are written through scratch
        to, at = (S, 28 * (first + lane)) if whole else (w[WORK:], 0)
        for i in range(2):
            outer(to, at + 7 * i + 0, 28, 14, 2, w, (1920 + 32 * i + lane, ), 64, (640 + 896 * i + lane, ), 32, 7)
        if not whole:
            for c in range(28 * (last + 1 - first - lane)):
                S[28 * (first + lane) + c] = to[c]



@fast
def nominal_sensitivity(x, q, tool, k, S):
    """Fill S (N, 2, 14) with the derivatives by the errors, limb by limb.

    Those of one limb are in the order of ``parameters.ERRORS``, then ``COMMON``.
    """
    w, whole = scratch(WORK + SPARE), S.reshape(S.size)
    w_1 = w[0:896]
    w_2 = w[896:1792]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    k_1, k_2 = k[0, 0], k[0, 1]
    left = 0
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        load(x, w, first, last, n)
        if len(tool) > 1:
            hold(tool, w, first, last, n)
        aim(w, n)
        load(q, w, first, last, n)
        _nominal(w_1, k_1, n)
        _nominal(w_2, k_2, n)
        _nominal_inverse(w, n)
        left += _singular(w, last - first + 1)
        _products(w, whole, first, last)
    return left == 0


@fast
def _chosen_products(w, columns, C, first, last):
    """Multiply them for some columns; rows of C (N, 2, n) are filled up to a multiple of eight numbers."""
    wide()
    n = (columns.size + 7) // 8 * 8
    for start in range(0, n, 8):
        for lane in range(0, last - first + 1, 8):
            outer_of(
                C, 2 * n * (first + lane) + start, 2 * n, n, 2,
                w, lane, 64, FACTORS, VALUES, columns, start, 1,
            )


@straight
def _along(x, C, m, H, n, towards, poses):
    """Fill the rows of all pairs: along the line from one position to the other, the difference of their derivatives."""
    row = 0
    for a in range(poses):
        for b in range(a + 1, poses):
            a_x = x[2 * a + 0]
            a_y = x[2 * a + 1]
            b_x = x[2 * b + 0]
            b_y = x[2 * b + 1]
            gap_x = -a_x + b_x
            gap_y = -a_y + b_y
            s5 = 1/math.sqrt((gap_x * gap_x) + (gap_y * gap_y))
            s6 = gap_x*s5
            s7 = gap_y*s5
            towards[0 * poses + b] = s6
            towards[1 * poses + b] = s7
        for b in range(a + 1, poses):
            for j in range(n):
                n_x = towards[0 * poses + b]
                n_y = towards[1 * poses + b]
                shift_a_x = C[m * (2 * a + 0) + j]
                shift_a_y = C[m * (2 * a + 1) + j]
                shift_b_x = C[m * (2 * b + 0) + j]
                shift_b_y = C[m * (2 * b + 1) + j]
                s12 = n_x*(-shift_a_x + shift_b_x) + n_y*(-shift_a_y + shift_b_y)
                H[n * row + j] = s12
            row += 1


@fast
def distance_rows(x, q, tool, k, columns, H):
    """Fill the identification matrix H (N (N - 1) / 2, n) of the distances of all pairs of positions, first with second and so on.

    columns (n,) are those of `nominal_sensitivity`, whose derivatives are contracted and not returned. The row of two
    equal positions is NaN.
    """
    poses, n_h = len(q), len(columns)
    if H.shape[0] != poses * (poses - 1) // 2 or H.shape[1] != n_h:
        raise ValueError("H must have a row for every pair of poses and a column for every chosen one")
    for j in range(n_h):
        if not 0 <= columns[j] < 14:
            raise IndexError("there is no such column of the sensitivity")
    m = (n_h + 7) // 8 * 8
    w = scratch(WORK + 2 * ((poses + 7) * m + poses))
    C = w[WORK:]
    w_1 = w[0:896]
    w_2 = w[896:1792]
    if len(tool) == 1:
        hold(tool, w, 0, 0, LANES)
    k_1, k_2 = k[0, 0], k[0, 1]
    left = 0
    for first in range(0, len(q), LANES):
        last = min(first + LANES, len(q)) - 1
        n = (last - first + 8) // 8 * 8
        load(x, w, first, last, n)
        if len(tool) > 1:
            hold(tool, w, first, last, n)
        aim(w, n)
        load(q, w, first, last, n)
        _nominal(w_1, k_1, n)
        _nominal(w_2, k_2, n)
        _nominal_inverse(w, n)
        left += _singular(w, last - first + 1)
        _chosen_products(w, columns, C, first, last)
    _along(x, C, m, H, n_h, C[2 * (poses + 7) * m :], poses)
    return left == 0
