"""Variance components: what goes as chance has it along given functions, each group of them with one size.

The size is the likeliest by what is left beside all that is fitted (Patterson and Thompson 1971); it is sought along a
grid, group by group, until none changes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.machine.registry import Array

SIZES = np.geomspace(0.1, 1e6, 15)  # of the variance that a component brings the readings of, in those of their noise
SWEEPS = 3  # over all components, in which their sizes settle beside one another
EXACT = 1e-12  # of a sum of squares: what rounding leaves of it
UNSEEN = 1e-6  # of a unit column's square beside all that is fitted: less is a combination of that
SETTLED = 1.0  # of the deviance: a sweep that gains less was the last

Sizes = dict[int, float]  # of components, from 0; of those that are there


@dataclass(frozen=True)
class Components:
    """Normal equations of the functions of all components, beside everything else that is fitted.

    Attributes
    ----------
    G, b : (n, n), (n,) arrays
        Of columns that bring the readings of each component the variance of their noise.
    rest, least : float
        Sum of squares that is left without them, and what rounding leaves of that where all is explained.
    degrees : int
        Scalars, less what is fitted.
    owner : (n,) array of int
        Which component each column belongs to.
    prices : tuple of float
        Of each component, where it is there [deviance].
    """

    G: Array
    b: Array
    rest: float
    least: float
    degrees: int
    owner: np.ndarray
    prices: tuple[float, ...]

    @staticmethod
    def of(groups: Sequence[Array], beside: Beside, price: float | Sequence[float]) -> Components:
        """Return those of whitened columns (scalars, n_g) each, beside all that is fitted; each may have its price."""
        C, r = np.hstack(groups), beside.residual
        owner = np.repeat(np.arange(len(groups)), [g.shape[1] for g in groups])
        inside, left = beside.Q.T @ C, beside.squares
        degrees = max(len(r) - beside.Q.shape[1], 1)
        prices = tuple(np.broadcast_to(price, len(groups)).tolist())
        return Components(C.T @ C - inside.T @ inside, C.T @ r, left, max(EXACT * left, 1e-300), degrees, owner, prices)

    def deviance(self, sizes: Mapping[int, float]) -> float:
        """Return twice the negative logarithm of the likelihood, the components' price in it."""
        if not sizes:
            return self.degrees * float(np.log(max(self.rest, self.least)))
        own = np.flatnonzero(np.isin(self.owner, list(sizes)))
        d = np.sqrt([sizes[k] for k in self.owner[own]])
        L = np.linalg.cholesky(self.G[np.ix_(own, own)] * d * d[:, None] + np.eye(len(own)))
        z = np.linalg.solve(L, self.b[own] * d)
        left = max(self.rest - float(z @ z), self.least)
        return (
            self.degrees * float(np.log(left))
            + 2 * float(np.log(np.diag(L)).sum())
            + sum(self.prices[k] for k in sizes)
        )

    def likeliest(self, start: Mapping[int, float] | None = None) -> tuple[Sizes, float]:
        """Return the sizes that are likeliest, sought from some on, and their deviance."""
        has = dict(start or {})
        best = self.deviance(has)
        for _ in range(SWEEPS):
            before = best
            for j in np.unique(self.owner).tolist():
                tried = [{**has, j: float(s)} for s in SIZES] + [{k: s for k, s in has.items() if k != j}]
                costs = [self.deviance(t) for t in tried]
                k = int(np.argmin(costs))
                if costs[k] < best:
                    has, best = tried[k], costs[k]
            if best > before - SETTLED:
                break
        return has, best


def with_fitted(beside: Beside, columns: Array) -> Beside:
    """Return what is fitted with whitened columns (scalars, n) more, as far as they are no combinations of it."""
    if not columns.shape[1]:
        return beside
    own = columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    inside = beside.Q.T @ own
    size, V = np.linalg.eigh(own.T @ own - inside.T @ inside)
    return beside.joined(own @ V[:, size > UNSEEN])


def of_noise(columns: Array) -> float:
    """Return the factor by which whitened columns (scalars, n) bring the readings the variance of their noise."""
    return 1.0 / max(float(np.sqrt((columns**2).sum() / len(columns))), 1e-150)
