"""Sizes inside effects, fitted with everything else: what was searched from value to value ends between them."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.motion.library import LOAD, Rung

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array
    from deltacal_gen.motion.joint import Joint

ROUNDS = 8
STEP = 0.05  # of a size, either way: for its derivative
LONGEST = 0.5  # of the logarithm: how far a size moves in one round
SETTLED = 0.1  # standard deviations that a last round may move


def settled(joint: Joint, rungs: Sequence[Rung], load: Array) -> tuple[list[Rung], Array]:
    """Return effects with the sizes that leave least beside all coefficients (Gauss-Newton).

    Returns
    -------
    rungs : list of Rung
    by_size : (M, k) array
        Derivatives of what the fit says of the joint by the logarithm of each size, in the order of the rungs that
        have one.
    """
    rungs, best = list(rungs), (np.inf, list(rungs), np.empty((len(joint.y), 0)))
    sized = [n for n, rung in enumerate(rungs) if rung.continuous]
    for _ in range(ROUNDS if sized else 0):
        X = joint.columns(rungs, load)
        bench = joint.bench(X).with_ridge(range(X.shape[1]))
        found = bench.fit(range(X.shape[1]), range(len(bench.n))) / bench.scale
        left = joint.y - X @ found
        D = by_sizes(joint, rungs, found, load)
        if (error := float(left @ left)) < best[0]:
            best = error, list(rungs), D
        else:
            break
        whole = joint.bench(np.hstack([X, D]))
        whole = dataclasses.replace(whole, ridge=bench.ridge)
        every = range(X.shape[1] + len(sized))
        steps = (whole.fit(every, range(len(whole.n))) / whole.scale)[X.shape[1] :]
        variance = error / len(left) * joint.correlated(left)
        std = np.sqrt(np.diag(whole.covariance(every))[X.shape[1] :] * variance) / whole.scale[X.shape[1] :]
        for n, step in zip(sized, np.clip(steps, -LONGEST, LONGEST), strict=True):
            rungs[n] = _times(rungs[n], float(np.exp(step)))
        if (np.abs(steps) < SETTLED * std).all():
            break
    return best[1], best[2]


def _times(rung: Rung, factor: float) -> Rung:
    return Rung(rung.effect, (rung.constants[0] * factor,))


def by_sizes(joint: Joint, rungs: Sequence[Rung], coefficients: Array, load: Array) -> Array:
    """Return the derivatives (M, k) of what a fit says of a joint by the logarithms of its sizes, in their order."""
    sized = [n for n, rung in enumerate(rungs) if rung.continuous]
    each = [_by_size(joint, rungs, n, coefficients, load) for n in sized]
    return np.column_stack(each) if each else np.empty((len(joint.y), 0))


def _by_size(joint: Joint, rungs: Sequence[Rung], n: int, coefficients: Array, load: Array) -> Array:
    """Return the derivative (M,) of what a fit says of a joint by the logarithm of one effect's size."""
    at = joint.X.shape[1] + sum(rung.width for rung in rungs[:n])
    own, states = coefficients[at : at + rungs[n].width], joint.states | {LOAD: load}
    ahead, back = (joint.of_rung(_times(rungs[n], float(np.exp(way))), states) for way in (STEP, -STEP))
    return np.asarray((ahead - back) @ own / (2 * STEP))
