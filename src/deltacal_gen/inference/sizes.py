"""Sizes of random effects by evidence: the variances of blocks, and of the noise, where the likelihood is highest.

A variance may be 0. Of a block that is not there the likelihood has its maximum at 0 half of the time, so that what its
presence gains is 0, and else chi-square of one degree of freedom (Self and Liang 1987, J. Am. Stat. Assoc. 82,
605-610). Sizes are scanned coarsely one after another, 0 among them, and then refined together by the likelihood's
slope: of several maxima the scan finds the highest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.inference.projection import Array

WITHIN = (0.1, 1e6)  # sizes of effects that bring rows the variance of their noise
STEP = 10**0.5  # between variances that are scanned: the likelihood of one has no maximum that is narrower
SWEEPS = 3  # over all sizes, each given the others as they are
SETTLED = 1.0  # of the deviance: a sweep that gains less is the last
EXACT = {"ftol": 1e-13, "gtol": 1e-7}  # of the deviance, and of its slope, where refinement ends


class Sizes(NamedTuple):
    """Variance (k,) of the effects of each block, 0 where it is not there, the noise's, and the deviance."""

    variances: Array
    noise: float
    deviance: float


def fit_sizes(
    model: MixedModel,
    owner: np.ndarray,
    within: tuple[float, float] = WITHIN,
    *,
    noise: float | tuple[float, float] | None = None,
    prices: float | Array = 0.0,
    spread: float = np.inf,
) -> Sizes:
    """Return the sizes of the highest evidence.

    Parameters
    ----------
    owner : (n,) int array
        Block that each effect belongs to; the variance of effects of none, -1, is 1.
    within : (float, float)
        Between which variances sizes are sought, 0 beside them.
    noise : float or (float, float), optional
        Variance of whitened rows, or between which it is sought. Where none is given variances are ratios to it.
    prices : float or (k,) array
        What a block's presence has to earn of the deviance.
    spread : float
        Standard deviation of the logarithm of a block's standard deviation about 0, beforehand; none is then 0.
    """
    from scipy.optimize import minimize

    k, prior = int(owner.max(initial=-1)) + 1, 0.25 / spread**2  # of the square of a variance's logarithm
    limits = [within] * k + ([noise] if isinstance(noise, tuple) else [])

    def given(v: Array) -> tuple[Array, float | None]:
        return np.append(v[:k], 1.0)[owner], float(v[k]) if isinstance(noise, tuple) else noise

    def cost(v: Array) -> float:
        before = prior * np.log(v[:k]) ** 2 if prior else prices * (v[:k] > 0)
        return model.deviance(*given(v)) + float(np.sum(before))

    def slopes(v: Array) -> Array:
        each, of_noise = model.slopes(*given(v))
        by_block = np.bincount(owner + 1, each, k + 1)[1:] + (2 * prior * np.log(v[:k]) if prior else 0.0)
        return np.append(by_block, of_noise)[: len(v)]

    v = np.append(np.full(k, float(prior > 0)), np.ones(len(limits) - k))
    best = cost(v)
    for _ in range(SWEEPS):
        before = best
        for j, (low, high) in reversed(list(enumerate(limits))):
            grid = np.geomspace(low, high, round(np.log(high / low) / np.log(STEP)) + 1)
            tried = [np.where(np.arange(len(v)) == j, s, v) for s in ([*grid] if prior or j == k else [*grid, 0.0])]
            costs = [cost(t) for t in tried]
            if min(costs) < best:
                best, v = min(costs), tried[int(np.argmin(costs))]
        if best > before - SETTLED or len(v) == 1:
            break
    there = np.flatnonzero(v)

    def at(log: Array) -> Array:
        return np.exp(np.bincount(there, log, len(v))) * (v > 0)

    if len(there):
        how = {"method": "L-BFGS-B", "bounds": np.log(limits)[there], "options": EXACT}
        end = minimize(lambda log: cost(at(log)), np.log(v[there]), jac=lambda log: slopes(at(log))[there], **how)
        best, v = (float(end.fun), at(end.x)) if end.fun <= best else (best, v)
    variances, found = given(v)
    return Sizes(v[:k], model.noise(variances) if found is None else found, best)


def least(
    cost: Callable[[Any], float], starts: Iterable[Any], steps: ArrayLike, limits: ArrayLike
) -> tuple[list[float], float]:
    """Return where a cost without a slope is least, and how little: from the best start (Nelder and Mead 1965)."""
    from scipy.optimize import minimize

    best, wide = np.array([min(starts, key=cost), steps], dtype=float)
    inward = np.where(best + wide > np.asarray(limits)[:, 1], -wide, wide)
    how = {"initial_simplex": best + np.vstack([0 * best, np.diag(inward)]), "xatol": 5e-3, "fatol": 1e-3}
    found = minimize(cost, best, method="Nelder-Mead", bounds=limits, options=how)
    return found.x.tolist(), found.fun
