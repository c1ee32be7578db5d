"""Least squares of one joint, fold by fold: normal equations once, then any choice of columns on any of the folds.

Neighbouring samples are not independent. Held out are whole runs, or stretches of at least a second with gaps between
them, and every count of samples is divided by the samples that hang together (`together`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from scipy.linalg import LinAlgError, cho_factor, cho_solve

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

LEAST_RUNS = 3  # runs in which a joint moves, so that whole runs are held out
MOST_FOLDS = 6
PART = 0.25  # of an even share of a joint's samples: a run with less is none of its own
STRETCHES, STRETCH = 20, 1.0  # of a recording of few runs: how many, and how long at least [s]
FOLDS = 5  # of stretches
GAP = 0.3  # s on either side of a stretch that no fit uses
BETWEEN = -1  # fold of samples in such gaps
FEWEST = 20  # samples of a fold
LONGEST = 2.0  # s over which samples hang together, at most
NOTHING = 1e-9  # of a column's mean square: what is left of one that others make up
RIDGES = (1e-9, 1e-6, 1e-4, 1e-2)  # of a column's size, per sample


def folds_of(time: Array, run: np.ndarray, used: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the fold (N,) in which each sample is fitted, and the one with which it is held out.

    They differ in the gaps between stretches: no fit of a fold uses these samples (`BETWEEN`), and they lie as far as
    those of their stretch from all that others use. Both are `BETWEEN` where a sample is not used.
    """
    out = np.full(len(time), BETWEEN)
    counts = np.bincount(run[used], minlength=int(run.max()) + 1)
    share = counts.sum() / max(np.count_nonzero(counts), 1)
    whole = np.flatnonzero(counts > PART * share)
    if len(whole) >= LEAST_RUNS:
        for n, code in enumerate(whole):
            out[used & (run == code)] = n % MOST_FOLDS
        return out, out
    held = out.copy()
    step = np.diff(time)
    moving = float(step[(step > 0) & used[1:]].sum())
    length, done = max(STRETCH + 2 * GAP, moving / STRETCHES), 0
    for code in np.unique(run[used]):
        own = np.flatnonzero(used & (run == code))
        at = time[own] - time[own[0]]
        block = np.floor(at / length).astype(int)
        inside = at - block * length
        kept = (inside >= GAP) & (inside <= length - GAP)
        held[own] = (done + block) % FOLDS
        out[own[kept]] = held[own[kept]]
        done += int(block[-1]) + 1
    for fold in range(FOLDS):
        if (out == fold).sum() < FEWEST:
            out[out == fold] = held[held == fold] = BETWEEN
    return out, held


def together(residual: Array, piece: np.ndarray, used: np.ndarray, step: float) -> float:
    """Return how many samples tell as much as one whose noise is its own: the sum of their correlations.

    Up to the first lag that correlates no more (Geyer 1992).
    """
    r = np.where(used, residual, 0.0)
    power = float(r @ r) / max(int(used.sum()), 1)
    total = 1.0
    for lag in range(1, max(2, int(LONGEST / step))):
        both = used[lag:] & used[:-lag] & (piece[lag:] == piece[:-lag])
        if both.sum() < FEWEST or power == 0:
            break
        rho = float((r[lag:] * r[:-lag])[both].mean()) / power
        if rho < 2.0 / np.sqrt(both.sum()):
            break
        total += 2 * rho
    return total


@dataclass(frozen=True, eq=False)
class Bench:
    """Normal equations of one joint by fold; columns are scaled to a mean square of 1.

    Attributes
    ----------
    G, g, yy, n : (F, p, p), (F, p), (F,), (F,) arrays
        Fold by fold; the last one holds the samples between folds.
    scale : (p,) array
        By which columns were divided.
    rigid : int
        How many columns, the first ones, are the rigid machine's.
    ridge : float
        What is added to their normal equations, per sample.
    """

    G: Array
    g: Array
    yy: Array
    n: Array
    scale: Array
    rigid: int
    ridge: float = RIDGES[0]

    @classmethod
    def of(cls, X: Array, y: Array, fold: np.ndarray, rigid: int) -> Bench:
        """Return the normal equations of columns X (N, p) and readings y (N,) of folds (N,)."""
        scale = np.sqrt(np.mean(X**2, axis=0))
        scale[scale == 0] = 1.0
        count = int(fold.max(initial=BETWEEN)) + 1
        parts = [fold == f for f in (*range(count), BETWEEN)]
        scaled = [X[p] / scale for p in parts]
        return cls(
            np.array([x.T @ x for x in scaled]),
            np.array([x.T @ y[p] for x, p in zip(scaled, parts, strict=True)]),
            np.array([y[p] @ y[p] for p in parts]),
            np.array([float(p.sum()) for p in parts]),
            scale,
            rigid,
        )

    def with_column(self, at: int, values: Array, X: Array, y: Array, fold: np.ndarray) -> Bench:
        """Return the equations with other values (N,) in one column, as scaled; X (N, p) holds the others, unscaled."""
        G, g = self.G.copy(), self.g.copy()
        for f in range(len(self.n)):
            own = fold == (f if f < len(self.n) - 1 else BETWEEN)
            row = (values[own] @ X[own]) / self.scale
            row[at] = values[own] @ values[own]
            G[f, at], G[f, :, at], g[f, at] = row, row, values[own] @ y[own]
        return replace(self, G=G, g=g)

    @property
    def folds(self) -> tuple[int, ...]:
        """Folds that hold samples."""
        return tuple(int(f) for f in np.flatnonzero(self.n[:-1]))

    def fit(self, columns: Sequence[int], folds: Sequence[int], ridge: float | None = None) -> Array:
        """Return the coefficients of columns, as scaled, by least squares on some folds."""
        at, rows = np.asarray(columns, dtype=int), list(folds)
        G = self.G[rows].sum(axis=0)[np.ix_(at, at)]
        g = self.g[rows].sum(axis=0)[at]
        n = self.n[rows].sum()
        G[np.diag_indices_from(G)] += np.where(at < self.rigid, self.ridge if ridge is None else ridge, RIDGES[0]) * n
        return _solved(G, g)

    def error(self, columns: Sequence[int], coefficients: Array, folds: Sequence[int]) -> float:
        """Return the sum of squares that coefficients leave on some folds."""
        at, rows = np.asarray(columns, dtype=int), list(folds)
        G = self.G[rows].sum(axis=0)[np.ix_(at, at)]
        g = self.g[rows].sum(axis=0)[at]
        left = self.yy[rows].sum() - 2 * coefficients @ g + coefficients @ G @ coefficients
        return float(max(left, 0.0))

    def train(self, columns: Sequence[int], folds: Sequence[int]) -> float:
        """Return the sum of squares that a fit on some folds leaves there."""
        return self.error(columns, self.fit(columns, folds), folds)

    def gains(self, columns: Sequence[int], groups: Sequence[Sequence[int]], folds: Sequence[int]) -> Array:
        """Return by how much the sum of squares of a fit to some folds falls with each group of further columns."""
        at, rows = np.asarray(columns, dtype=int), list(folds)
        G, g = self.G[rows].sum(axis=0), self.g[rows].sum(axis=0)
        inner = G[np.ix_(at, at)]
        inner[np.diag_indices_from(inner)] += np.where(at < self.rigid, self.ridge, RIDGES[0]) * self.n[rows].sum()
        if len(at):
            found = np.linalg.lstsq(inner, np.column_stack([G[at], g[at]]), rcond=1e-12)[0]
        else:
            found = np.zeros((0, G.shape[0] + 1))
        rest, left = G - G[:, at] @ found[:, :-1], g - G[:, at] @ found[:, -1]
        out = []
        for group in groups:
            own = rest[np.ix_(group, group)] + NOTHING * self.n[rows].sum() * np.eye(len(group))
            out.append(float(left[list(group)] @ np.linalg.solve(own, left[list(group)])))
        return np.array(out)

    def held_out(self, columns: Sequence[int], folds: Sequence[int]) -> float:
        """Return the mean square on each of some folds, of fits to the others with the ridge that serves best."""
        return min(self._held_out(columns, folds, ridge) for ridge in RIDGES)

    def with_ridge(self, columns: Sequence[int], folds: Sequence[int] | None = None) -> Bench:
        """Return the equations with the ridge that predicts some folds best, of fits to the others."""
        folds = self.folds if folds is None else folds
        errors = [self._held_out(columns, folds, ridge) for ridge in RIDGES]
        return replace(self, ridge=RIDGES[int(np.argmin(errors))])

    def _held_out(self, columns: Sequence[int], folds: Sequence[int], ridge: float) -> float:
        at, total = np.asarray(columns, dtype=int), 0.0
        G, g = self.G[:, at[:, None], at], self.g[:, at]
        whole, of_all, n = G[list(folds)].sum(axis=0), g[list(folds)].sum(axis=0), self.n[list(folds)].sum()
        each = np.where(at < self.rigid, ridge, RIDGES[0])
        for fold in folds:
            rest = whole - G[fold]
            rest[np.diag_indices_from(rest)] += each * (n - self.n[fold])
            found = _solved(rest, of_all - g[fold])
            total += self.yy[fold] - 2 * found @ g[fold] + found @ G[fold] @ found
        return max(float(total), 0.0) / float(n)

    def covariance(self, columns: Sequence[int]) -> Array:
        """Return the inverse of the normal equations of all samples, of coefficients as scaled."""
        at = np.asarray(columns, dtype=int)
        G = self.G.sum(axis=0)[np.ix_(at, at)]
        G[np.diag_indices_from(G)] += np.where(at < self.rigid, self.ridge, RIDGES[0]) * self.n.sum()
        return np.asarray(np.linalg.pinv(G, hermitian=True))


def _solved(G: Array, g: Array) -> Array:
    """Return the solution of normal equations, the shortest one where they are singular."""
    if not len(g):
        return g
    try:
        return np.asarray(cho_solve(cho_factor(G, check_finite=False), g, check_finite=False))
    except LinAlgError:
        return np.asarray(np.linalg.lstsq(G, g, rcond=None)[0])
