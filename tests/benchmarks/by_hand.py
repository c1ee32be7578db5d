"""The Delta of Bai 2015 in NumPy as a competent hand writes it: the paper's explicit formulas, all poses at once.

It imports NumPy only. Run as a script it is the shortest program that does the package's job: ``by_hand.py identify
RECORDING.csv`` fits model 18 to the distances of all pairs of poses, ``by_hand.py command X Y Z`` gives corrected
joints. Parameters are the paper's unknowns in the order of eq. (8): per limb L dtheta, ex, ey, ez, dL, L dalpha0,
L dbeta0, dl; then per limb dl/c, dc/c, dalpha03, dbeta03, dalpha2, dbeta2 [mm, rad].
"""

from __future__ import annotations

import sys

import numpy as np

BASE, PLATFORM, ARM, ROD, SPACING = 200.0, 51.0, 375.0, 950.0, 100.0  # Table 1: b, a, L, l, c
RADIUS, TOP, HEIGHT = 500.0, 728.0, 250.0  # of the workspace
E = BASE - PLATFORM
PHI = np.radians([-90.0, 30.0, 150.0])
CPHI, SPHI = np.cos(PHI)[:, None], np.sin(PHI)[:, None]
FRAMES = np.stack([[[c, 0.0, s], [s, 0.0, -c], [0.0, 1.0, 0.0]] for c, s in zip(np.cos(PHI), np.sin(PHI), strict=True)])
BLOCK = 2048  # poses at once: temporaries stay in the cache
DONE = 1e-6  # mm; Newton is quadratic: what a step of this size leaves is rounding
OFFSETS = [0, 8, 16]
MODEL_18 = [0, 2, 4, 5, 6, 7, 8, 9, 12, 13, 14, 15, 16, 17, 20, 21, 22, 23]


def in_blocks(function, rows, out, block=BLOCK):
    """Fill out (N, k) with function of rows (N, 3), some rows at a time."""
    for start in range(0, len(rows), block):
        out[start : start + block] = function(rows[start : start + block])
    return out


# ------------------------------------------------------------------------------------------------ the ideal machine


def ideal_inverse(r):
    """Return the joints (N, 3) [rad] at positions (N, 3)."""
    dx, dy, z = r[:, 0] - E * CPHI, r[:, 1] - E * SPHI, r[:, 2]
    x = CPHI * dx + SPHI * dy
    k = (dx * dx + dy * dy + z * z + (ARM**2 - ROD**2)) / (2 * ARM)
    root = np.sqrt(x * x + z * z - k * k)
    return np.arctan2(z * k + x * root, x * k - z * root).T


def ideal_forward(theta):
    """Return the positions (N, 3) at joints (N, 3): where three spheres about the elbows meet, the lower point."""
    theta = np.ascontiguousarray(theta.T)  # joint by joint: NumPy keeps the order of what it reads
    reach, z = E + ARM * np.cos(theta), ARM * np.sin(theta)
    x, y = CPHI * reach, SPHI * reach
    ax, ay, az, bx, by, bz = x[1] - x[0], y[1] - y[0], z[1] - z[0], x[2] - x[0], y[2] - y[0], z[2] - z[0]
    nx, ny, nz = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    aa, bb, ab = ax * ax + ay * ay + az * az, bx * bx + by * by + bz * bz, ax * bx + ay * by + az * bz
    nn = nx * nx + ny * ny + nz * nz
    u, v = bb * (aa - ab) / (2 * nn), aa * (bb - ab) / (2 * nn)
    t = np.copysign(np.sqrt((ROD**2 - u * u * aa - v * v * bb - 2 * u * v * ab) / nn), -nz)
    return np.stack(
        [x[0] + u * ax + v * bx + t * nx, y[0] + u * ay + v * by + t * ny, z[0] + u * az + v * bz + t * nz], axis=1
    )


# --------------------------------------------------------------------------------------------- the paper's linear model


def _cross(a, b):
    out = np.empty((3, *np.broadcast(a[0], b[0]).shape))
    for x, y, z in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        out[x] = a[y] * b[z]
        out[x] -= a[z] * b[y]
    return out


def _inverse(rows):
    """Return the columns (3, 3 limbs, N) of the inverse of the matrix whose rows (3, 3 limbs, N) are given."""
    around = np.concatenate([rows, rows[:, :2]], axis=1)
    columns = _cross(around[:, 1:4], around[:, 2:5])
    return columns / (rows[:, 0] * columns[:, 0]).sum(axis=0)


def _factors(theta, r):
    """Return rods, B_r (8, 3, N) and B_e (6, 3, N) of eqs. (6) and (7); axes: component, limb, pose."""
    theta = np.ascontiguousarray(theta.T)
    sin, cos = np.sin(theta), np.cos(theta)
    reach = E + ARM * cos
    rod = np.stack([r[:, 0] - CPHI * reach, r[:, 1] - SPHI * reach, r[:, 2] - ARM * sin]) / ROD
    ru, rw = CPHI * rod[0] + SPHI * rod[1], SPHI * rod[0] - CPHI * rod[1]
    ru1, rv1 = cos * ru + sin * rod[2], cos * rod[2] - sin * ru
    B_r, B_e = np.empty((8, *sin.shape)), np.empty((6, *sin.shape))
    B_r[0], B_r[1:4], B_r[4], B_r[5], B_r[6], B_r[7] = rv1, rod, ru1, sin * rw, -cos * rw, 1.0
    B_e[0], B_e[1], B_e[2], B_e[3], B_e[4], B_e[5] = 1.0, rw, -rod[2], ru, -rv1, ru1
    return rod, B_r, B_e


def _turning(rod):
    """Return A_ee^-1 (3, limb, N) and A_re A_ee^-1 (row, limb, N)."""
    M = _inverse(np.stack([-CPHI * rod[2], -SPHI * rod[2], CPHI * rod[0] + SPHI * rod[1]]))
    arm = PLATFORM * np.stack([SPHI * rod[2], -CPHI * rod[2], CPHI * rod[1] - SPHI * rod[0]])
    return M, (arm[:, :, None] * M[:, None]).sum(axis=0)


def sensitivity(theta, r, out, offset=(0.0, 0.0, 0.0)):
    """Fill out (N, 3, 42) with C of eq. (8), and with C_P of a point `offset` off the platform's centre."""
    for start in range(0, len(theta), BLOCK):
        part = slice(start, start + BLOCK)
        rod, B_r, B_e = _factors(theta[part], r[part])
        G, (M, AM) = _inverse(rod), _turning(rod)
        H = -(G[:, :, None] * AM).sum(axis=1)
        if any(offset):
            H += _cross(M, offset)
        own = out[part]
        _products(G, B_r, own[..., :24].reshape(-1, 3, 3, 8))
        _products(H, B_e, own[..., 24:].reshape(-1, 3, 3, 6))
    return out


def _products(G, B, out):
    """Fill out (N, 3, limb, b) with G (3, limb, N) times B (b, limb, N), pose by pose as it lies in memory."""
    G, B = np.ascontiguousarray(G.transpose(2, 0, 1)), np.ascontiguousarray(B.transpose(2, 1, 0))
    np.multiply(G[..., None], B[:, None], out=out)


def identification_matrix(theta, r, offset, columns):
    """Return H (n (n - 1) / 2, columns) of eq. (14) for all pairs of poses."""
    return differences(np.take(sensitivity(theta, r, np.empty((len(r), 3, 42)), offset), columns, axis=2), r)


def differences(C, r):
    """Return rows (n (n - 1) / 2, columns) of distances between all pairs, by the sensitivities C (n, 3, columns)."""
    i, j = np.triu_indices(len(r), 1)
    gap = r[j] - r[i]
    gap /= np.linalg.norm(gap, axis=1)[:, None]
    return np.einsum("kx,kxc->kc", gap, C[j] - C[i])


def change(theta, r, p):
    """Return what eq. (23) adds to the joints theta (N, 3) [rad] of the ideal machine at positions r (N, 3)."""
    rod, B_r, B_e = _factors(theta, r)
    _, AM = _turning(rod)
    along = (B_r * p[:24].reshape(3, 8).T[..., None]).sum(axis=0)
    turned = (B_e * p[24:].reshape(3, 6).T[..., None]).sum(axis=0)
    return ((AM * turned).sum(axis=1) - along).T / (ARM * B_r[0]).T


def command(target, p):
    """Return joints (N, 3) [rad] that bring the reference point to target (N, 3) to first order."""
    theta = ideal_inverse(target)
    return theta + change(theta, target, p)


# ----------------------------------------------------------------------------------------------- the exact machine


def _turned(a, b):
    """Return the rotation by the rotation vector (a, b, 0)."""
    t = np.hypot(a, b)
    K = np.array([[0.0, 0.0, b], [0.0, 0.0, -a], [-b, a, 0.0]])
    return np.eye(3) + np.sinc(t / np.pi) * K + 0.5 * np.sinc(t / (2 * np.pi)) ** 2 * K @ K


def machine(p, offset=(0.0, 0.0, 0.0)):
    """Return what no pose changes of a machine with finite errors p: a table (6 rods, 14).

    Columns: cosine, sine and constant part of the elbow end; end on the platform; length; offset of the joint.
    """
    out = np.zeros((6, 14))
    for i, F in enumerate(FRAMES):
        dtheta, ex, ey, ez, dL, alpha0, beta0, dl_mean = p[8 * i : 8 * i + 8]
        dl, dc, alpha03, beta03, alpha2, beta2 = p[24 + 6 * i : 30 + 6 * i]
        alpha0, beta0 = alpha0 / ARM, beta0 / ARM
        R0 = F @ _turned(alpha0, beta0)
        elbow, hand = _turned(alpha2, beta2)[:, 2], F @ _turned(alpha0 - alpha03, beta0 - beta03)[:, 2]
        for j, side in enumerate((0.5, -0.5)):
            tip = np.array([ARM + dL, 0.0, 0.0]) + side * SPACING * (1 + dc) * elbow
            row = out[2 * i + j]
            row[0:3] = R0[:, 0] * tip[0] + R0[:, 1] * tip[1]
            row[3:6] = R0[:, 1] * tip[0] - R0[:, 0] * tip[1]
            row[6:9] = BASE * F[:, 0] + (ex, ey, ez) + R0[:, 2] * tip[2]
            row[9:12] = PLATFORM * F[:, 0] + side * SPACING * hand - offset
            row[12], row[13] = ROD + dl_mean + side * SPACING * dl, dtheta / ARM
    return out


def _elbows(theta, rods):
    """Return the elbow ends of the rods and their derivatives by the joints, (3, 6, N)."""
    angle = theta.T[[0, 0, 1, 1, 2, 2]] + rods[:, 13, None]
    sin, cos = np.sin(angle), np.cos(angle)
    a, b, rest = (rods[:, k : k + 3].T[..., None] for k in (0, 3, 6))
    return a * cos + b * sin + rest, b * cos - a * sin


def _closure(P, c, elbow, rods):
    """Return F (6, N), rods d (3, 6, N) and the derivatives by the Cayley vector (3, 6, N); P, c are (3, N)."""
    hand, c = rods[:, 9:12].T[..., None], c[:, None]
    shrink = 1 / (1 + (c * c).sum(axis=0) / 4)
    turn = _cross(c, hand)
    hand = hand + shrink * (turn + _cross(c, turn) / 2)
    d = P[:, None] + hand - elbow
    moment = _cross(hand, d)
    return ((d * d).sum(axis=0) - rods[:, 12, None] ** 2) / 2, d, shrink * (moment + _cross(moment, c) / 2)


def machine_derivatives(p, offset=(0.0, 0.0, 0.0), h=1e-4):
    """Return the derivatives (14 errors, 6 rods, 14) of `machine` by the errors of a rod's own limb."""
    whole = np.array([machine(p + h * e, offset) - machine(p - h * e, offset) for e in np.eye(42)]) / (2 * h)
    first, second = whole[:24].reshape(3, 8, 6, 14), whole[24:].reshape(3, 6, 6, 14)
    return np.concatenate([first, second], axis=1).sum(axis=0)  # a rod of another limb does not change


def exact_sensitivity(theta, x, rods, derivatives):
    """Return the derivatives of the exact poses x (N, 6) by the errors, (N, 6, 3 limbs, 14 errors)."""
    out = np.empty((len(x), 6, 3, 14))
    elbow, turned = _elbows(theta, rods)
    J = np.empty((len(x), 6, 6))
    _, d, J.T[3:] = _closure(x.T[:3], x.T[3:], elbow, rods)
    J.T[:3] = d
    inverse = np.linalg.inv(J)
    c = x.T[3:, None]
    back = _cross(d, c)  # the rods as the platform sees them
    back = d + (back - _cross(back, c) / -2) / (1 + (c * c).sum(axis=0) / 4)
    angle = theta + rods[::2, 13]
    sin, cos = np.sin(angle)[..., None], np.cos(angle)[..., None]
    for i in range(3):
        J_p = np.empty((len(x), 2, 14))
        for j, rod in enumerate((2 * i, 2 * i + 1)):
            D, own = derivatives[:, rod].T, d[:, rod].T
            J_p[:, j] = (
                back[:, rod].T @ D[9:12] - own @ D[6:9] - cos[:, i] * (own @ D[0:3]) - sin[:, i] * (own @ D[3:6])
            )
            J_p[:, j] -= rods[rod, 12] * D[12] + np.outer((own * turned[:, rod].T).sum(axis=1), D[13])
        np.matmul(-inverse[:, :, 2 * i : 2 * i + 2], J_p, out=out[:, :, i])
    return out


def forward(theta, rods, offset=(0.0, 0.0, 0.0)):
    """Return the exact pose (N, 6), position and Cayley vector, by Newton on the six rods from the ideal pose."""
    x, step = np.zeros((6, len(theta))), np.inf
    x[:3] = (ideal_forward(theta + rods[::2, 13]) + offset).T
    elbow, _ = _elbows(theta, rods)
    J = np.empty((len(theta), 6, 6))
    while np.abs(step).max() > DONE:
        F, J.T[:3], J.T[3:] = _closure(x[:3], x[3:], elbow, rods)
        step = np.linalg.solve(J, F.T[..., None])[..., 0].T
        x -= step
    return x.T


def inverse(target, rods, offset=(0.0, 0.0, 0.0)):
    """Return the joints (N, 3) that bring the reference point exactly to target, by Newton on joints and rotation."""
    q, c = ideal_inverse(target - offset) - rods[::2, 13], np.zeros((3, len(target)))
    J, step = np.zeros((len(target), 6, 6)), np.inf
    while np.abs(step).max() > DONE / 1000:
        elbow, turned = _elbows(q, rods)
        F, d, J.T[3:] = _closure(target.T, c, elbow, rods)
        J.T[[0, 0, 1, 1, 2, 2], range(6)] = -(d * turned).sum(axis=0)
        step = np.linalg.solve(J, F.T[..., None])[..., 0]
        q, c = q - step[:, :3], c - step[:, 3:].T
    return q


# --------------------------------------------------------------------------------------------------- identification


def identify(theta, points, columns, forward=forward, matrix=identification_matrix, settled=1e-4):
    """Return p (42,): first the encoder offsets, then the columns of a model, from distances of all pairs of poses.

    Gauss-Newton: residuals of the exact machine, and the paper's matrix at the ideal machine with the offsets found.

    Parameters
    ----------
    theta : (n, 3) array
    points : list of (offset (3,), positions (n, 3))
        What a tracker read at each reference point.
    forward, matrix : callable
        What computes exact poses and the matrix: these, or another tool's.
    settled : float
        Size of the last step [mm].
    """
    i, j = np.triu_indices(len(theta), 1)
    measured = [np.linalg.norm(at[j] - at[i], axis=1) for _, at in points]
    p = np.zeros(42)
    for free in (OFFSETS, columns):
        step = np.inf
        while np.abs(step).max() > settled:
            seen = theta + p[OFFSETS] / ARM
            r = ideal_forward(seen)
            rest, H = [], []
            for (offset, _), distance in zip(points, measured, strict=True):
                x = forward(theta, machine(p, offset), offset)[:, :3]
                rest.append(distance - np.linalg.norm(x[j] - x[i], axis=1))
                H.append(matrix(seen, r, offset, free))
            step = np.linalg.lstsq(np.concatenate(H), np.concatenate(rest), rcond=None)[0]
            p[free] += step
    return p


def main(forward=forward, matrix=identification_matrix):
    """Do what the command line asks for."""
    if sys.argv[1] == "identify":
        with open(sys.argv[2]) as file:  # by its name NumPy would first load what reads compressed files and addresses
            table = np.loadtxt(file, delimiter=",", skiprows=1)
        points = [(np.zeros(3), table[:, 3:6])]
        print(*identify(np.radians(table[:, :3]), points, MODEL_18, forward, matrix))
    else:
        print(*command(np.array([sys.argv[2:5]], dtype=float), np.array(sys.argv[5:], dtype=float))[0])


if __name__ == "__main__":
    main()
