"""Families of functions of one variable or of a place: random functions are combinations of them.

A random function has coefficients c ~ N(0, size D). Each family says what D is, or has functions for which it is one.
"""

from __future__ import annotations

import numpy as np

from deltacal_gen.inference.projection import Array


def gaps(values: Array, knots: Array) -> Array:
    """Return how far values (N, d) lie from knots (K, d), (N, K)."""
    return np.asarray(np.linalg.norm(values[:, None] - knots, axis=2))


def bumps(values: Array, knots: Array, length: float) -> Array:
    """Return bumps (N, K) about knots (K, d): covariances of a smooth function over a length, too."""
    return np.asarray(np.exp(-0.5 * (gaps(values, knots) / length) ** 2))


def farthest(values: Array, most: int) -> list[int]:
    """Return which values (N, d), up to `most` of them, lie farthest from all chosen so far, again and again."""
    chosen, gap = [0], gaps(values, values[:1])[:, 0]
    while len(chosen) < most and gap.max() > 0:
        chosen.append(int(np.argmax(gap)))
        gap = np.minimum(gap, gaps(values, values[chosen[-1:]])[:, 0])
    return chosen


def waves(angle: Array, orders: int) -> Array:
    """Return cosine and sine of every order (N, 2 orders)."""
    step = np.multiply.accumulate(np.repeat(np.exp(1j * angle)[:, None], orders, axis=1), axis=1)
    return np.stack([step.real, step.imag], axis=2).reshape(len(angle), -1)


def spectrum(orders: int, corner: float) -> Array:
    """Return Matérn's D (orders,) of waves: even up to a corner, falling with the fourth power beyond."""
    return np.asarray((1 + (np.arange(1, orders + 1) / corner) ** 2) ** -2.0)


def walk(passed: Array, modes: int) -> Array:
    """Return functions (N, modes) of the part of the time that has passed: a Brownian walk is drawn of them."""
    k = np.arange(modes) + 0.5
    return np.asarray(np.sin(np.pi * k * passed[:, None]) * np.sqrt(2) / (np.pi * k))
