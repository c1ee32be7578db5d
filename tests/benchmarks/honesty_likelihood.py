"""What a fit that knows the model of the noise says of its size, and of how many rows count as one.

The likelihood is that of what geometry and instrument leave free (Patterson and Thompson 1971, Biometrika 58, 545-554):
their columns, differences of simulated readings, are taken out, but for those that tolerances hold. It knows that noise
fades from row to row, is shared by the readings of a pose, is unlike along the axes, or has the tails of Laplace's or
Student's distribution, and which readings are gross; how large it is, and how much of it is shared, it seeks. Of the
uniform and of a skewed one it takes the normal's: that their ends are sharp no instrument promises.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar

from tests.benchmarks.honesty_nulls import AXES, READ_AT_ONCE, SIGMA, noiseless, null
from tests.support.left_out import DELTA
from tests.support.prototype import plausible

Array = np.ndarray
STEP = 1e-3  # ordinary errors: of a difference
WIDE = 5.0  # ordinary errors: what a machine may well be off by, as a diagnosis has it
GROSS = 6.0  # standard deviations beyond which it is known that a reading is gross
TRUE = {"AR 0.5": 0.5, "AR 0.9": 0.9, "AR 0.95": 0.95, "AR mixed": 0.7}  # correlations from row to row
SORTS = (*("white", "uniform", "laplace", "t3", "skewed"), *TRUE, "by pose", "understated", "overstated", "gross")
STUDENT = 3.0  # degrees of freedom
ROUNDS = 60  # of weights


class Likeliest(NamedTuple):
    """Size of noise [mm], and how many rows count as one."""

    sigma: float
    rows: float


def rows_of(rho: float) -> float:
    """Return how many rows with such a correlation from one to the next tell as much as one of its own."""
    return (1 + rho) / (1 - rho)


def likeliest(sort: str, k: int) -> Likeliest:
    """Return what is likeliest of the k-th null of a sort."""
    made = null(sort, k)
    at_once = READ_AT_ONCE if sort == "by pose" else 1
    exact = noiseless(len(made.measured), k, at_once)
    e = made.measured - exact.measured
    X = _columns(len(e), k, at_once)
    scale = AXES if sort == "AR mixed" else np.ones(3)
    e, X = e / scale, _free(X / scale[:, None])
    if sort in TRUE:
        return _hanging_together(e, X)
    if sort == "by pose":
        return Likeliest(_shared(e, X, np.unique(made.pose, return_inverse=True)[1]), 1.0)
    if sort == "gross":
        e, X = _without(e, X)
    weigh = {"t3": _student, "laplace": _laplace}.get(sort)
    return Likeliest(_alone(e, X) if weigh is None else weigh(e, X), 1.0)


def _columns(n: int, k: int, at_once: int) -> Array:
    """Return what errors of geometry and the instrument's place do to readings (n, 3, p), in units of the noise."""
    errors, columns = plausible(DELTA, k, size=0.3), []
    for p in DELTA.parameters:
        step = STEP * p.typical
        ends = (noiseless(n, k, at_once, errors | {p.name: errors.get(p.name, 0.0) + way * step}) for way in (1, -1))
        high, low = (made.measured for made in ends)
        columns.append((high - low) / (2 * STEP) * WIDE / SIGMA)
    at = noiseless(n, k, at_once).measured
    turns = [np.cross(axis, at - at.mean(axis=0)) for axis in np.eye(3)]
    shifts = [np.broadcast_to(axis, at.shape) for axis in np.eye(3)]
    size = WIDE / SIGMA  # far more than noise: the instrument may stand anywhere
    return np.stack([*columns, *(size * c / np.abs(c).max() for c in (*turns, *shifts))], axis=2)


def _free(X: Array) -> Array:
    """Return columns (n, 3, r) at right angles, of what moves readings by more than the noise within tolerances."""
    U, size, _ = np.linalg.svd(X.reshape(-1, X.shape[2]), full_matrices=False)
    return U[:, size > 1].reshape(*X.shape[:2], -1)


def _without(e: Array, X: Array) -> tuple[Array, Array]:
    right = np.linalg.norm(e, axis=1) < GROSS * SIGMA
    return e[right], _free(X[right] / 1e-6)  # they are of unit size


def _cost(e: Array, X: Array, spread: float) -> tuple[float, float]:
    """Return twice the negative logarithm of the likelihood of white rows, and their variance.

    `spread` is the logarithm of the determinant that whitening took, of all axes.
    """
    y, A = e.ravel(), X.reshape(-1, X.shape[2])
    Q, R = np.linalg.qr(A)
    left = y - Q @ (Q.T @ y)
    free = len(y) - A.shape[1]
    variance = float(left @ left) / free
    return free * np.log(variance) + spread + 2 * float(np.log(np.abs(np.diag(R))).sum()), variance


def _alone(e: Array, X: Array) -> float:
    return float(np.sqrt(_cost(e, X, 0.0)[1]))


def _hanging_together(e: Array, X: Array) -> Likeliest:
    def whitened(rho: float, v: Array) -> Array:
        out = v.copy()
        out[1:] = (v[1:] - rho * v[:-1]) / np.sqrt(1 - rho**2)
        return out

    def cost(rho: float) -> tuple[float, float]:
        return _cost(whitened(rho, e), whitened(rho, X), 3 * (len(e) - 1) * float(np.log(1 - rho**2)))

    rho = _least(lambda a: cost(float(np.tanh(a)))[0], 0.0, np.arctanh(0.999), np.tanh)
    return Likeliest(float(np.sqrt(cost(rho)[1])), rows_of(rho))


def _shared(e: Array, X: Array, pose: Array) -> float:
    """Return the size of what each reading has alone, beside what those of a pose share."""
    count = np.bincount(pose)

    def whitened(ratio: float, v: Array) -> Array:
        flat = v.reshape(len(v), -1)
        mean = np.stack([np.bincount(pose, column) for column in flat.T], axis=1) / count[:, None]
        less = (1 - 1 / np.sqrt(1 + ratio * count))[:, None] * mean
        return (flat - less[pose]).reshape(v.shape)

    def cost(ratio: float) -> tuple[float, float]:
        return _cost(whitened(ratio, e), whitened(ratio, X), 3 * float(np.log1p(ratio * count).sum()))

    ratio = _least(lambda a: cost(float(np.exp(a)))[0], -7.0, 7.0, np.exp)
    return float(np.sqrt(cost(ratio)[1]))


def _least(cost: Callable[[float], float], low: float, high: float, of: Callable[[float], float]) -> float:
    found = minimize_scalar(cost, bounds=(low, high), method="bounded", options={"xatol": 1e-4})
    return float(of(found.x))


def _student(e: Array, X: Array) -> float:
    def weight(r: Array) -> Array:
        return (STUDENT + 1) / (STUDENT - 2 + r**2)  # of a distribution whose variance is 1

    return _weighed(e, X, lambda r, s: weight(r / s), lambda r, w, free: float(np.sqrt((w * r**2).sum() / free)))


def _laplace(e: Array, X: Array) -> float:
    def weight(r: Array, s: float) -> Array:
        return 1 / np.maximum(np.abs(r), 1e-3 * s)

    return _weighed(e, X, weight, lambda r, w, free: float(2**0.5 * np.abs(r).sum() / free))


def _weighed(
    e: Array, X: Array, weight: Callable[[Array, float], Array], size: Callable[[Array, Array, int], float]
) -> float:
    """Return the size of noise with other tails, what was fitted counted as a normal's."""
    y, A = e.ravel(), X.reshape(-1, X.shape[2])
    r, s = y - A @ np.linalg.lstsq(A, y, rcond=None)[0], float(np.std(y))
    for _ in range(ROUNDS):
        w = weight(r, s)
        root = np.sqrt(w)
        r = y - A @ np.linalg.lstsq(A * root[:, None], y * root, rcond=None)[0]
        s = size(r, weight(r, s), len(y) - A.shape[1])
    return s
