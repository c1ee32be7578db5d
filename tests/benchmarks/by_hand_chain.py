"""An open chain by Denavit and Hartenberg in NumPy as a competent hand writes it: twists, all poses at once.

It imports NumPy only. Every error of a link is a screw: the turn and the shift that it gives to all that comes behind,
along the base's axes. Parameters are a, alpha, d, theta of each link, then the tool's three [mm, rad].
"""

from __future__ import annotations

import numpy as np

TYPICAL = np.array([0.3, np.radians(0.1), 0.3, np.radians(0.1)])  # size of an ordinary error of a, alpha, d, theta
DONE = 1e-6  # mm: by how much a step moves the readings
SMALLEST = 1e-9  # of the largest singular value: directions that no reading sees


def turned(R, v):
    """Return vectors (..., 3, N) turned by rotations (3, 3, N)."""
    return R[:, 0] * v[..., 0:1, :] + R[:, 1] * v[..., 1:2, :] + R[:, 2] * v[..., 2:3, :]


def cross(a, b):
    """Return the products of vectors (3, N)."""
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def forward(q, links, tool, derivatives=False):
    """Return positions (3, N) of the tool point and, on demand, their derivatives (3, n_p, N).

    q is (N, n), links (n, 4) hold a, alpha, d, theta with their errors, tool (3,).
    """
    N, n = q.shape
    R, o = np.repeat(np.eye(3)[:, :, None], N, axis=2), np.zeros((3, N))
    axes = []  # of every link: z before, x after, where it begins and where it ends
    for k, (a, alpha, d, theta) in enumerate(links):
        c, s, ca, sa = np.cos(q[:, k] + theta), np.sin(q[:, k] + theta), np.cos(alpha), np.sin(alpha)
        z, begin = R[:, 2], o
        x = R[:, 0] * c + R[:, 1] * s
        y = R[:, 1] * c - R[:, 0] * s
        o = o + d * z + a * x
        R = np.stack([x, ca * y + sa * z, ca * z - sa * y], axis=1)
        axes.append((z, x, begin, o))
    P = o + turned(R, tool[:, None])
    if not derivatives:
        return P
    J = np.empty((3, 4 * n + 3, N))
    for k, (z, x, begin, end) in enumerate(axes):
        J[:, 4 * k], J[:, 4 * k + 1] = x, cross(x, P - end)
        J[:, 4 * k + 2], J[:, 4 * k + 3] = z, cross(z, P - begin)
    J[:, 4 * n :] = R
    return P, J


def identify(q, measured, links, tool, steps=20):
    """Return errors (n_p,) and the frame (R, t) by Gauss and Newton from positions (N, 3) in an unknown frame."""
    links, tool, found = links.copy(), tool.copy(), np.zeros(4 * len(links) + 3)
    scale = np.concatenate([np.tile(TYPICAL, len(links)), np.ones(3)])
    y, P = measured.T, forward(q, links, tool)
    U, _, Vt = np.linalg.svd((y - y.mean(1, keepdims=True)) @ (P - P.mean(1, keepdims=True)).T)
    F = U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    t = y.mean(1) - F @ P.mean(1)
    for _ in range(steps):
        P, J = forward(q, links, tool, derivatives=True)
        at = F @ P
        columns = np.concatenate([np.einsum("ij,jpn->ipn", F, J) * scale[:, None], np.empty((3, 6, len(q)))], axis=1)
        for j, e in enumerate(np.eye(3)):
            columns[:, -6 + j] = cross(np.repeat(e[:, None], len(q), 1), at)
            columns[:, -3 + j] = e[:, None]
        A, r = columns.transpose(2, 0, 1).reshape(3 * len(q), -1), (y - at - t[:, None]).T.ravel()
        u = np.linalg.lstsq(A, r, rcond=SMALLEST)[0]
        step, w = u[:-6] * scale, u[-6:-3]
        found, t = found + step, t + u[-3:]
        angle = np.linalg.norm(w)
        K = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]]) / max(angle, 1e-300)
        F = (np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K) @ F
        links, tool = links + step[:-3].reshape(-1, 4), tool + step[-3:]
        if np.abs(A @ u).max() < DONE:
            break
    return found, (F, t)
