"""Noise that is not alike in all directions: an instrument that knows how far better than where to.

Its shape is Tyler's (1987, Ann. Statist. 15, 234-251): of each reading only the direction counts, which tails and gross
errors do not change. Whether directions differ at all, the likelihood of directions alone tells; noise of any tails
that knows none exceeds its bound as seldom.
"""

from __future__ import annotations

import numpy as np

from deltacal_gen.machine.registry import Array

CHANCE = 1e-3  # that noise alike in all directions is called otherwise
FEWEST = 5  # readings for each number that a shape has
EXACT = 1e-10  # of the variance along one axis: less along another is rounding
ROUNDS, SETTLED = 100, 1e-6  # of the fixed point, and what of the shape may still move


def shape_of(z: Array, ways: int = 1) -> Array | None:
    """Return the covariance (k, k) of readings (R, k) whose components are zero on average, of mean variance 1.

    None where they are as likely to be alike in all directions, or too few, or none is off in some direction. Each
    reading may come in so many `ways`.
    """
    z = z[(z**2).sum(axis=1) > 0]
    n, k = z.shape
    if k < 2 or n < FEWEST * ways * _numbers(k):
        return None
    shape = _likeliest(z)
    return shape if price_of(shape) < _explained(z, shape) / ways < np.inf else None


def explained(z: Array, ways: int = 1) -> float:
    """Return how much the likeliest shape explains of the directions of readings (R, k), in the deviance.

    Without end, where many lie exactly in a plane, or along a line: rounding is no noise that has a shape.
    """
    return _explained(z, _likeliest(z)) / ways


def _explained(z: Array, shape: Array) -> float:
    n, k = z.shape
    size = np.linalg.eigvalsh(shape)
    if size[0] < EXACT * size[-1]:
        return np.inf
    of_directions = k * np.log((z**2).sum(axis=1) / _squares(z, shape)).sum()
    return float(of_directions - n * np.linalg.slogdet(shape)[1])


def _likeliest(z: Array) -> Array:
    """Return the shape (k, k) by the directions of readings (R, k), none of which is zero: Tyler's fixed point."""
    k = z.shape[1]
    shape = np.eye(k)
    for _ in range(ROUNDS):
        before = shape
        if np.linalg.cond(shape) > 1 / EXACT:
            break
        shape = (z / _squares(z, shape)[:, None]).T @ z
        shape *= k / np.trace(shape)
        if np.abs(shape - before).max() < SETTLED:
            break
    return shape


def price_of(shape: Array) -> float:
    """Return what a shape (k, k) must explain, in the deviance."""
    from scipy.special import chdtri

    return float(chdtri(_numbers(len(shape)), CHANCE))


def _numbers(k: int) -> int:
    return k * (k + 1) // 2 - 1


def levelling(shape: Array) -> Array:
    """Return the symmetric matrix (k, k) that makes noise of a shape alike in all directions."""
    variances, axes = np.linalg.eigh(shape)
    return np.asarray((axes / np.sqrt(variances)) @ axes.T)


def _squares(z: Array, shape: Array) -> Array:
    """Return the squares (R,) of readings in units of their noise, but for its size."""
    return np.asarray(np.einsum("ri,ri->r", z, np.linalg.solve(shape, z.T).T))
