"""The same works in scalar Numba, one pose after the other, as a competent hand writes them."""

from __future__ import annotations

import math

import numpy as np
from numba import njit

from . import by_hand
from .by_hand import ARM, BASE, DONE, FRAMES, PHI, PLATFORM, ROD, SPACING, E

C, S = tuple(np.cos(PHI).tolist()), tuple(np.sin(PHI).tolist())


@njit(cache=True, error_model="numpy", inline="always")
def _cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@njit(cache=True, error_model="numpy", inline="always")
def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@njit(cache=True, error_model="numpy", inline="always")
def _limb(i, theta, x, y, z):
    """Return the rod, its normal n, a u0 x rod, and its parts along u0, w0, u1 and v1; sine and cosine."""
    s, c = math.sin(theta), math.cos(theta)
    reach = E + ARM * c
    rx, ry, rz = (x - C[i] * reach) / ROD, (y - S[i] * reach) / ROD, (z - ARM * s) / ROD
    u, w = C[i] * rx + S[i] * ry, S[i] * rx - C[i] * ry
    rod, normal = (rx, ry, rz), (-C[i] * rz, -S[i] * rz, u)
    return (
        rod,
        normal,
        (PLATFORM * S[i] * rz, -PLATFORM * C[i] * rz, -PLATFORM * w),
        (u, w, c * u + s * rz),
        (
            c * rz - s * u,
            s,
            c,
        ),
    )


@njit(cache=True, error_model="numpy")
def sensitivity(theta, r, out, offset=None):
    """Fill C (N, 3, 42) of eq. (8), of the platform's centre or of a point `offset` from it, three numbers."""
    for n in range(theta.shape[0]):
        limbs = (
            _limb(0, theta[n, 0], r[n, 0], r[n, 1], r[n, 2]),
            _limb(1, theta[n, 1], r[n, 0], r[n, 1], r[n, 2]),
            _limb(2, theta[n, 2], r[n, 0], r[n, 1], r[n, 2]),
        )
        g = (_cross(limbs[1][0], limbs[2][0]), _cross(limbs[2][0], limbs[0][0]), _cross(limbs[0][0], limbs[1][0]))
        m = (_cross(limbs[1][1], limbs[2][1]), _cross(limbs[2][1], limbs[0][1]), _cross(limbs[0][1], limbs[1][1]))
        by_g, by_m = 1 / _dot(limbs[0][0], g[0]), 1 / _dot(limbs[0][1], m[0])
        for i in range(3):
            rod, _, _, (u, w, u1), (v1, s, c) = limbs[i]
            a0, a1, a2 = _dot(limbs[0][2], m[i]), _dot(limbs[1][2], m[i]), _dot(limbs[2][2], m[i])
            aside = (0.0, 0.0, 0.0)
            if offset is not None:  # turns move the point by their cross product with the offset
                aside = _cross(m[i], offset)
            for x in range(3):
                G = g[i][x] * by_g
                row = out[n, x, 8 * i : 8 * i + 8]
                row[0], row[1], row[2], row[3] = G * v1, G * rod[0], G * rod[1], G * rod[2]
                row[4], row[5], row[6], row[7] = G * u1, G * s * w, -G * c * w, G
                H = -(g[0][x] * a0 + g[1][x] * a1 + g[2][x] * a2) * by_g * by_m
                if offset is not None:
                    H += aside[x] * by_m
                row = out[n, x, 24 + 6 * i : 30 + 6 * i]
                row[0], row[1], row[2], row[3], row[4], row[5] = H, H * w, -H * rod[2], H * u, -H * v1, H * u1


@njit(cache=True, error_model="numpy")
def identification_matrix(theta, r, offset, columns, C, chosen, H):
    """Fill H (n (n - 1) / 2, columns) of eq. (14) for all pairs; C (n, 3, 42), chosen (n, 3, columns): scratch."""
    sensitivity(theta, r, C, (offset[0], offset[1], offset[2]))
    for n in range(r.shape[0]):
        for x in range(3):
            for k in range(columns.shape[0]):
                chosen[n, x, k] = C[n, x, columns[k]]
    row = 0
    for a in range(r.shape[0]):
        for b in range(a + 1, r.shape[0]):
            gx, gy, gz = r[b, 0] - r[a, 0], r[b, 1] - r[a, 1], r[b, 2] - r[a, 2]
            by = 1 / math.sqrt(gx * gx + gy * gy + gz * gz)
            gx, gy, gz = gx * by, gy * by, gz * by
            A, B, h = chosen[a], chosen[b], H[row]
            for k in range(len(h)):
                h[k] = gx * (B[0, k] - A[0, k]) + gy * (B[1, k] - A[1, k]) + gz * (B[2, k] - A[2, k])
            row += 1


@njit(cache=True, error_model="numpy", inline="always")
def _joint(i, x, y, z):
    dx, dy = x - E * C[i], y - E * S[i]
    x = C[i] * dx + S[i] * dy
    k = (dx * dx + dy * dy + z * z + (ARM**2 - ROD**2)) / (2 * ARM)
    root = math.sqrt(x * x + z * z - k * k)
    return math.atan2(z * k + x * root, x * k - z * root)


@njit(cache=True, error_model="numpy")
def ideal_inverse(r, theta):
    """Fill the joints theta (N, 3) of the ideal machine at positions r (N, 3)."""
    for n in range(r.shape[0]):
        for i in range(3):
            theta[n, i] = _joint(i, r[n, 0], r[n, 1], r[n, 2])


@njit(cache=True, error_model="numpy", inline="always")
def _position(t0, t1, t2):
    h0, h1, h2 = E + ARM * math.cos(t0), E + ARM * math.cos(t1), E + ARM * math.cos(t2)
    x0, y0, z0 = C[0] * h0, S[0] * h0, ARM * math.sin(t0)
    a = (C[1] * h1 - x0, S[1] * h1 - y0, ARM * math.sin(t1) - z0)
    b = (C[2] * h2 - x0, S[2] * h2 - y0, ARM * math.sin(t2) - z0)
    n, aa, bb, ab = _cross(a, b), _dot(a, a), _dot(b, b), _dot(a, b)
    half = 0.5 / _dot(n, n)
    u, v = bb * (aa - ab) * half, aa * (bb - ab) * half
    t = math.copysign(math.sqrt((ROD * ROD - u * u * aa - v * v * bb - 2 * u * v * ab) * 2 * half), -n[2])
    return (
        x0 + u * a[0] + v * b[0] + t * n[0],
        y0 + u * a[1] + v * b[1] + t * n[1],
        z0 + u * a[2] + v * b[2] + t * n[2],
    )


@njit(cache=True, error_model="numpy")
def ideal_forward(theta, r):
    """Fill the positions r (N, 3) of the ideal machine at joints theta (N, 3)."""
    for n in range(theta.shape[0]):
        r[n, 0], r[n, 1], r[n, 2] = _position(theta[n, 0], theta[n, 1], theta[n, 2])


@njit(cache=True, error_model="numpy")
def changes(theta, r, p, dq):
    """Fill dq (N, 3) with what eq. (23) adds to the joints theta (N, 3) at positions r (N, 3)."""
    for n in range(theta.shape[0]):
        x, y, z = r[n, 0], r[n, 1], r[n, 2]
        limbs = (_limb(0, theta[n, 0], x, y, z), _limb(1, theta[n, 1], x, y, z), _limb(2, theta[n, 2], x, y, z))
        m = (_cross(limbs[1][1], limbs[2][1]), _cross(limbs[2][1], limbs[0][1]), _cross(limbs[0][1], limbs[1][1]))
        by_m = 1 / _dot(limbs[0][1], m[0])
        e0 = e1 = e2 = 0.0
        for i in range(3):
            rod, _, _, (u, w, u1), (v1, s, c) = limbs[i]
            f = p[24 + 6 * i : 30 + 6 * i]
            turned = by_m * (f[0] + f[1] * w - f[2] * rod[2] + f[3] * u - f[4] * v1 + f[5] * u1)
            e0, e1, e2 = e0 + m[i][0] * turned, e1 + m[i][1] * turned, e2 + m[i][2] * turned
        for i in range(3):
            rod, _, arm, (u, w, u1), (v1, s, c) = limbs[i]
            f = p[8 * i : 8 * i + 8]
            along = f[0] * v1 + f[1] * rod[0] + f[2] * rod[1] + f[3] * rod[2] + f[4] * u1
            along += (f[5] * s - f[6] * c) * w + f[7] - (arm[0] * e0 + arm[1] * e1 + arm[2] * e2)
            dq[n, i] = -along / (ARM * v1)


@njit(cache=True, error_model="numpy")
def commands(target, p, q):
    """Fill the joints q (N, 3) that eq. (23) gives at targets (N, 3)."""
    ideal_inverse(target, q)
    dq = np.empty_like(q)
    changes(q, target, p, dq)
    for n in range(q.shape[0]):
        for i in range(3):
            q[n, i] += dq[n, i]


@njit(cache=True, error_model="numpy")
def forward(theta, rods, x):
    """Fill the exact poses x (N, 6) by Newton on the six rods; `rods` from ``by_hand.machine``."""
    A, elbow = np.empty((6, 7)), np.empty((6, 3))
    for n in range(theta.shape[0]):
        angle = (theta[n, 0] + rods[0, 13], theta[n, 1] + rods[2, 13], theta[n, 2] + rods[4, 13])
        for i in range(3):
            s, c = math.sin(angle[i]), math.cos(angle[i])
            for j in range(2 * i, 2 * i + 2):
                for k in range(3):
                    elbow[j, k] = rods[j, k] * c + rods[j, 3 + k] * s + rods[j, 6 + k]
        px, py, pz = _position(angle[0], angle[1], angle[2])
        cx = cy = cz = 0.0
        size = math.inf
        while size > DONE:
            turn = (cx, cy, cz)
            shrink = 1 / (1 + _dot(turn, turn) / 4)
            for j in range(6):
                hand = (rods[j, 9], rods[j, 10], rods[j, 11])
                t = _cross(turn, hand)
                v = _cross(turn, t)
                hand = (
                    hand[0] + shrink * (t[0] + v[0] / 2),
                    hand[1] + shrink * (t[1] + v[1] / 2),
                    hand[2] + shrink * (t[2] + v[2] / 2),
                )
                d = (px + hand[0] - elbow[j, 0], py + hand[1] - elbow[j, 1], pz + hand[2] - elbow[j, 2])
                t = _cross(hand, d)
                v = _cross(t, turn)
                for k in range(3):
                    A[j, k], A[j, 3 + k] = d[k], shrink * (t[k] + v[k] / 2)
                A[j, 6] = (_dot(d, d) - rods[j, 12] * rods[j, 12]) / 2
            _solve(A)
            size = 0.0
            for j in range(6):
                size = max(size, abs(A[j, 6]))
            px, py, pz, cx, cy, cz = (
                px - A[0, 6],
                py - A[1, 6],
                pz - A[2, 6],
                cx - A[3, 6],
                cy - A[4, 6],
                cz - A[5, 6],
            )
        x[n, 0], x[n, 1], x[n, 2], x[n, 3], x[n, 4], x[n, 5] = px, py, pz, cx, cy, cz


@njit(cache=True, error_model="numpy")
def _solve(A):
    """Solve six equations (6, 7) in place by elimination with partial pivoting; the solution is the last column."""
    for c in range(6):
        pivot = c
        for r in range(c + 1, 6):
            if abs(A[r, c]) > abs(A[pivot, c]):
                pivot = r
        if pivot != c:
            for k in range(c, 7):
                A[c, k], A[pivot, k] = A[pivot, k], A[c, k]
        inverse = 1 / A[c, c]
        for r in range(c + 1, 6):
            factor = A[r, c] * inverse
            for k in range(c + 1, 7):
                A[r, k] -= factor * A[c, k]
    for c in range(5, -1, -1):
        A[c, 6] /= A[c, c]
        for r in range(c):
            A[r, 6] -= A[r, c] * A[c, 6]


@njit(cache=True, error_model="numpy", inline="always")
def _turned(a, b):
    """Return the columns of the rotation by the rotation vector (a, b, 0)."""
    t = math.sqrt(a * a + b * b)
    s, c = (math.sin(t) / t, (1 - math.cos(t)) / (t * t)) if t > 1e-8 else (1.0, 0.5)
    return (
        (1 - c * b * b, c * a * b, -s * b),
        (c * a * b, 1 - c * a * a, s * a),
        (s * b, -s * a, 1 - c * (a * a + b * b)),
    )


@njit(cache=True, error_model="numpy")
def machine(p, offset, rods):
    """Fill the table (6, 14) of ``by_hand.machine``."""
    for i in range(3):
        F, f, g = FRAMES[i], p[8 * i : 8 * i + 8], p[24 + 6 * i : 30 + 6 * i]
        alpha0, beta0 = f[5] / ARM, f[6] / ARM
        R, elbow, hand = _turned(alpha0, beta0), _turned(g[4], g[5])[2], _turned(alpha0 - g[2], beta0 - g[3])[2]
        for j in range(2):
            side = 0.5 - j
            wide = side * SPACING * (1 + g[1])
            tip = (ARM + f[4] + wide * elbow[0], wide * elbow[1], wide * elbow[2])
            row = rods[2 * i + j]
            for x in range(3):
                u = F[x, 0] * R[0][0] + F[x, 1] * R[0][1] + F[x, 2] * R[0][2]
                v = F[x, 0] * R[1][0] + F[x, 1] * R[1][1] + F[x, 2] * R[1][2]
                w = F[x, 0] * R[2][0] + F[x, 1] * R[2][1] + F[x, 2] * R[2][2]
                row[x], row[3 + x] = u * tip[0] + v * tip[1], v * tip[0] - u * tip[1]
                row[6 + x] = BASE * F[x, 0] + f[1 + x] + w * tip[2]
                row[9 + x] = PLATFORM * F[x, 0] - offset[x]
                row[9 + x] += side * SPACING * (F[x, 0] * hand[0] + F[x, 1] * hand[1] + F[x, 2] * hand[2])
            row[12], row[13] = ROD + f[7] + side * SPACING * g[0], f[0] / ARM


@njit(cache=True, error_model="numpy")
def _worst(x, wanted):
    """Return the largest error of the distances from home, the first pose."""
    worst = 0.0
    for n in range(1, len(x)):
        a, b = x[n, :3] - x[0, :3], wanted[n] - wanted[0]
        worst = max(worst, abs(math.sqrt(_dot(a, a)) - math.sqrt(_dot(b, b))))
    return worst


@njit(cache=True, error_model="numpy")
def trials(theta, r, offsets, columns, check, joints, errors, noise, gain, out):
    """Identify machines one after the other, from the distances of their measured positions.

    Parameters
    ----------
    theta, r : (n, 3) arrays
        Measuring poses of the ideal machine.
    offsets : (points, 3) array
    check, joints : (97, 3) arrays
        Where machines are judged.
    errors : (T, 42) array
    noise : (T, points, n, 3) array
    gain : (columns, M) array
        Least squares inverse of the identification matrix; empty to build the matrix and solve by SVD in each trial.
    out : (T, 2) array
        Largest distance error before and after.
    """
    n, points, m = len(theta), len(offsets), len(columns)
    per = n * (n - 1) // 2
    rods, x, C = np.empty((6, 14)), np.empty((n, 6)), np.empty((n, 3, 42))
    H, d, chosen = np.empty((points * per, m)), np.empty(points * per), np.empty((n, 3, m))
    zero = np.zeros(3)
    y, q, p = np.empty((len(check), 6)), np.empty((len(check), 3)), np.zeros(42)
    for t in range(len(errors)):
        for k in range(points):
            machine(errors[t], offsets[k], rods)
            forward(theta, rods, x)
            row = k * per
            for a in range(n):
                for b in range(a + 1, n):
                    was = now = 0.0
                    for c in range(3):
                        gap = x[b, c] + noise[t, k, b, c] - x[a, c] - noise[t, k, a, c]
                        now += gap * gap
                        was += (r[b, c] - r[a, c]) ** 2
                    d[row] = math.sqrt(now) - math.sqrt(was)
                    row += 1
            if len(gain) == 0:
                identification_matrix(theta, r, offsets[k], columns, C, chosen, H[k * per : (k + 1) * per])
        found = np.linalg.lstsq(H, d)[0] if len(gain) == 0 else gain @ d
        for k in range(m):
            p[columns[k]] = found[k]
        machine(errors[t], zero, rods)
        forward(joints, rods, y)
        out[t, 0] = _worst(y, check)
        commands(check, p, q)
        forward(q, rods, y)
        out[t, 1] = _worst(y, check)


def _poses(theta, rods, _):
    x = np.empty((len(theta), 6))
    forward(theta, rods, x)
    return x


def _matrix(theta, r, offset, columns):
    n, m = len(r), len(columns)
    H = np.empty((n * (n - 1) // 2, m))
    identification_matrix(theta, r, offset, np.array(columns), np.empty((n, 3, 42)), np.empty((n, 3, m)), H)
    return H


if __name__ == "__main__":
    by_hand.main(_poses, _matrix)
