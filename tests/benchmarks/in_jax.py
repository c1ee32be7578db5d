"""The works in JAX: one pose in arrays over limbs or rods, mapped over the poses, compiled; float64, one thread.

Every public function gets a work ready and returns what computes it: a function without arguments that returns an
array. Names, order and units as in `by_hand`.
"""

from __future__ import annotations

import os

os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1")
os.environ.setdefault("NPROC", "1")  # threads; read when JAX is loaded

import jax
import jax.numpy as jnp
import numpy as np

from tests.benchmarks import by_hand
from tests.benchmarks.by_hand import ARM, BASE, DONE, FRAMES, PLATFORM, ROD, SPACING, E

NAME = "JAX"
U, V, W = FRAMES.transpose(2, 0, 1)  # u0, v0 and w0 of the limbs, (3, 3) each
jax.config.update("jax_enable_x64", True)
jax.config.update("jax_platforms", "cpu")


def _inverse(rows):
    """Return the columns (3, 3) of the inverse of a matrix of three rows, column by column."""
    columns = jnp.cross(rows[np.array([1, 2, 0])], rows[np.array([2, 0, 1])])
    return columns / (rows[0] @ columns[0])


def _joints(r):
    d = r - E * U
    x, z = (d * U).sum(axis=1), r[2]
    k = ((d * d).sum(axis=1) + (ARM**2 - ROD**2)) / (2 * ARM)
    root = jnp.sqrt(x * x + z * z - k * k)
    return jnp.arctan2(z * k + x * root, x * k - z * root)


def _position(theta):
    c, s = jnp.cos(theta)[:, None], jnp.sin(theta)[:, None]
    elbow = (E + ARM * c) * U + ARM * s * V
    a, b = elbow[1] - elbow[0], elbow[2] - elbow[0]
    n, aa, bb, ab = jnp.cross(a, b), a @ a, b @ b, a @ b
    half = 0.5 / (n @ n)
    u, v = bb * (aa - ab) * half, aa * (bb - ab) * half
    t = jnp.sqrt((ROD**2 - u * u * aa - v * v * bb - 2 * u * v * ab) * 2 * half)
    return elbow[0] + u * a + v * b - jnp.copysign(t, n[2]) * n


def _factors(theta, r):
    """Return A_rr^-1, A_ee^-1 (limb by limb), A_re (3, 3), B_r (3, 8) and B_e (3, 6) of eqs. (6) and (7)."""
    c, s = jnp.cos(theta)[:, None], jnp.sin(theta)[:, None]
    u1, v1 = c * U + s * V, c * V - s * U
    rod = (r - E * U - ARM * u1) / ROD
    along_u, along_w, along_u1, along_v1 = ((rod * axis).sum(axis=1) for axis in (U, W, u1, v1))
    one = jnp.ones(3)
    B_r = jnp.stack([along_v1, *rod.T, along_u1, s[:, 0] * along_w, -c[:, 0] * along_w, one], axis=1)
    B_e = jnp.stack([one, along_w, -rod[:, 2], along_u, -along_v1, along_u1], axis=1)
    return _inverse(rod), _inverse(jnp.cross(W, rod)), PLATFORM * jnp.cross(U, rod), B_r, B_e


def _C(theta, r, offset):
    G, M, arm, B_r, B_e = _factors(theta, r)
    H = jnp.cross(M, offset) - (M @ arm.T) @ G
    return jnp.hstack([(a.T[:, :, None] * b).reshape(3, -1) for a, b in ((G, B_r), (H, B_e))])


def _change(theta, r, p):
    _, M, arm, B_r, B_e = _factors(theta, r)
    turn = (B_e * p[24:].reshape(3, 6)).sum(axis=1) @ M
    return (arm @ turn - (B_r * p[:24].reshape(3, 8)).sum(axis=1)) / (ARM * B_r[:, 0])


def _H(theta, r, offset, columns):
    i, j = np.triu_indices(len(r), 1)
    C = jax.vmap(_C, (0, 0, None))(theta, r, offset)[:, :, columns]
    gap = r[j] - r[i]
    return jnp.einsum("kx,kxc->kc", gap / jnp.linalg.norm(gap, axis=1, keepdims=True), C[j] - C[i])


def _pose(theta, rods):
    angle = (theta + rods[::2, 13]).repeat(2)[:, None]
    elbow = rods[:, :3] * jnp.cos(angle) + rods[:, 3:6] * jnp.sin(angle) + rods[:, 6:9]

    def further(state):
        x, _ = state
        shrink = 1 / (1 + x[3:] @ x[3:] / 4)
        first = jnp.cross(x[3:], rods[:, 9:12])
        hand = rods[:, 9:12] + shrink * (first + jnp.cross(x[3:], first) / 2)
        d = x[:3] + hand - elbow
        moment = jnp.cross(hand, d)
        F = ((d * d).sum(axis=1) - rods[:, 12] ** 2) / 2
        J = jnp.hstack([d, shrink * (moment + jnp.cross(moment, x[3:]) / 2)])
        step = jnp.linalg.solve(J, F)
        return x - step, jnp.abs(step).max()

    start = jnp.concatenate([_position(angle[::2, 0]), jnp.zeros(3)]), jnp.inf
    return jax.lax.while_loop(lambda state: state[1] > DONE, further, start)[0]


def _machine(p, offset):
    """Return the table (6, 14) of ``by_hand.machine``."""

    def limb(f, g, frame):
        base, elbow, hand = _turned(f[5:7] / ARM), _turned(g[4:6])[:, 2], _turned(f[5:7] / ARM - g[2:4])[:, 2]
        side = jnp.array([0.5, -0.5])[:, None] * SPACING
        tip, R = jnp.array([ARM + f[4], 0.0, 0.0]) + side * (1 + g[1]) * elbow, frame @ base
        return jnp.hstack(
            [
                tip[:, :1] * R[:, 0] + tip[:, 1:2] * R[:, 1],
                tip[:, :1] * R[:, 1] - tip[:, 1:2] * R[:, 0],
                BASE * frame[:, 0] + f[1:4] + tip[:, 2:] * R[:, 2],
                PLATFORM * frame[:, 0] + side * (frame @ hand) - offset,
                ROD + f[7] + side * g[0],
                jnp.full((2, 1), f[0] / ARM),
            ]
        )

    return jax.vmap(limb)(p[:24].reshape(3, 8), p[24:].reshape(3, 6), FRAMES).reshape(6, 14)


def _turned(turn):
    """Return the rotation by the rotation vector (a, b, 0)."""
    a, b = turn
    t = jnp.sqrt(a * a + b * b)
    K = jnp.array([[0.0, 0.0, b], [0.0, 0.0, -a], [-b, a, 0.0]])
    return jnp.eye(3) + jnp.sinc(t / np.pi) * K + 0.5 * jnp.sinc(t / (2 * np.pi)) ** 2 * K @ K


_poses = jax.jit(jax.vmap(_pose, (0, None)))
_matrix = jax.jit(_H)


def _ready(function, *given):
    given = [jnp.asarray(g) for g in given]
    return lambda: function(*given).block_until_ready()


def sensitivity(theta, r):
    """C of eq. (8), (N, 3, 42)."""
    return _ready(jax.jit(jax.vmap(_C, (0, 0, None))), theta, r, np.zeros(3))


def identification_matrix(theta, r, offset, columns):
    """H of eq. (14)."""
    return _ready(_matrix, theta, r, offset, np.array(columns))


def ideal_inverse(r):
    """Joints (N, 3)."""
    return _ready(jax.jit(jax.vmap(_joints)), r)


def ideal_forward(theta):
    """Positions (N, 3)."""
    return _ready(jax.jit(jax.vmap(_position)), theta)


def change(theta, r, p):
    """What eq. (23) adds to the joints (N, 3)."""
    return _ready(jax.jit(jax.vmap(_change, (0, 0, None))), theta, r, p)


def forward(theta, rods):
    """Exact poses (N, 6) by Newton on the six rods."""
    return _ready(_poses, theta, rods)


def trials(theta, r, offsets, columns, target, joints, errors, noise):
    """Largest distance errors (T, 2) before and after; the matrix is the same for all machines, and factored once."""
    i, j = np.triu_indices(len(r), 1)

    def lengths(at):
        return jnp.linalg.norm(at[..., j, :] - at[..., i, :], axis=-1)

    def worst(q, rods):
        x = jax.vmap(_pose, (0, None))(q, rods)[:, :3]
        return jnp.abs(jnp.linalg.norm(x - x[0], axis=1) - jnp.linalg.norm(target - target[0], axis=1)).max()

    def trial(p, noise):
        rods = jax.vmap(_machine, (None, 0))(p, offsets)
        x = jax.vmap(jax.vmap(_pose, (0, None)), (None, 0))(theta, rods)[..., :3]
        H = jnp.concatenate([_H(theta, r, offset, columns) for offset in offsets])
        found = jnp.linalg.lstsq(H, (lengths(x + noise) - lengths(r)).ravel())[0]
        rods, ideal = _machine(p, np.zeros(3)), jax.vmap(_joints)(target)
        added = jax.vmap(_change, (0, 0, None))(ideal, target, jnp.zeros(42).at[columns].set(found))
        return jnp.stack([worst(joints, rods), worst(ideal + added, rods)])

    theta, r, target, joints = (jnp.asarray(given) for given in (theta, r, target, joints))
    return _ready(jax.jit(jax.vmap(trial)), errors, noise)


if __name__ == "__main__":
    by_hand.main(lambda theta, rods, _: np.array(_poses(theta, rods)), lambda *given: np.array(_matrix(*given)))
