"""Least squares of one joint, fold by fold: normal equations once, then any choice of columns on any of the folds.

Neighbouring samples are not independent. Held out are whole runs, or stretches of at least a second with gaps between
them, and every count of samples is divided by the samples that hang together (`together`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import wraps
from typing import TYPE_CHECKING, TypeVar, cast

import numpy as np
from scipy.linalg import LinAlgError, cho_factor, cho_solve

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

T = TypeVar("T")

LEAST_RUNS = 3  # runs in which a joint moves, so that whole runs are held out
MOST_FOLDS = 6
PART = 0.25  # of an even share of a joint's samples: a run with less is none of its own
STRETCHES, STRETCH = 20, 1.0  # of a recording of few runs: how many, and how long at least [s]
FOLDS = 5  # of stretches
GAP = 0.3  # s on either side of a stretch that no fit uses
BETWEEN = -1  # fold of samples in such gaps
FEWEST = 20  # samples of a fold
MOVING = 0.5  # of the shortest stretch: so long the joint must be in motion in a fold of them, too
LONGEST = 2.0  # s over which samples hang together, at most
NOTHING = 1e-9  # of a column's mean square: what is left of one that others make up
RIDGES = tuple(10.0**k for k in range(-9, -1))  # of a column's size, per sample
EXACT = 1e-5  # of what a drive gives (rms): less is nothing, no drive is read so well, and files round
BELIEVED = 3.0  # times what the joint gave: so much may one parameter of a machine ask in a movement of all joints


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
    moving = float(np.minimum(step[(step > 0) & used[1:]], STRETCH).sum())  # clocks jump in between
    length, done = max(STRETCH + 2 * GAP, moving / STRETCHES), 0
    for code in np.unique(run[used]):
        own = np.flatnonzero(used & (run == code))
        at = time[own] - time[own[0]] + GAP  # a movement asks for no gap at its ends
        count = max(1, int((at[-1] + GAP) // length))
        width = (at[-1] + GAP) / count
        block = np.minimum(np.floor(at / width).astype(int), count - 1)
        inside = at - block * width
        kept = (inside >= GAP) & (inside <= width - GAP)
        held[own] = (done + block) % FOLDS
        out[own[kept]] = held[own[kept]]
        done += int(block[-1]) + 1
    least = max(FEWEST, MOVING * STRETCH / float(np.median(step[step > 0])))
    for fold in range(FOLDS):
        if (out == fold).sum() < least:
            out[out == fold] = held[held == fold] = BETWEEN
    return out, held


def together(residual: Array, piece: np.ndarray, used: np.ndarray, step: float) -> float:
    """Return how many samples tell as much as one whose noise is its own: the sum of their correlations.

    Up to the first lag that correlates no more (Geyer 1992).
    """
    most = max(2, int(LONGEST / step))
    apart = np.arange(len(piece)) + most * piece  # movements so far from each other that no lag reaches across
    length = 1 << int(apart[-1] + most).bit_length()
    series = np.zeros((2, length))
    series[:, apart] = np.where(used, residual, 0.0), used
    product, both = np.fft.irfft(np.abs(np.fft.rfft(series)) ** 2, length)[:, :most]
    both = np.rint(both)
    if product[0] <= 0 or both[0] == 0:
        return 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        rho = product / both / (product[0] / both[0])
        ends = (both < FEWEST) | (rho < 2.0 / np.sqrt(both))
    ends[0] = False
    last = int(np.argmax(ends)) if ends.any() else most
    return float(1.0 + 2 * rho[1:last].sum())


def prior_of(left: Array, together: float, given: Array) -> float:
    """Return the ridge, per sample, that says what is known of a machine beforehand.

    In a movement of all joints no parameter asks for more than `BELIEVED` times what the joint gave, `given` (M,). It
    counts by what is left (M,) of a fit, `together` samples as one. Where joints stood, nothing else is known.
    """
    size = BELIEVED**2 * float(given @ given)
    return max(RIDGES[0], float(left @ left) * together / len(left) / size) if size else RIDGES[0]


def _once(
    ask: Callable[[Bench, Sequence[int], Sequence[int]], T],
) -> Callable[[Bench, Sequence[int], Sequence[int]], T]:
    """Keep what equations answer of columns and folds: a search asks of the same again and again."""

    @wraps(ask)
    def asked(self: Bench, columns: Sequence[int], folds: Sequence[int]) -> T:
        key = ask.__name__, tuple(columns), tuple(folds)
        if key not in self.answers:
            self.answers[key] = ask(self, columns, folds)
        return cast(T, self.answers[key])

    return asked


@dataclass(frozen=True, eq=False)
class Bench:
    """Normal equations of one joint by fold.

    Columns are scaled to a mean square of 1; those of the rigid machine by what it would be in a movement of all
    joints. Where joints stand, a column of theirs holds noise, and scaled by that it would be believed.

    Attributes
    ----------
    G, g, yy, n : (F, p, p), (F, p), (F,), (F,) arrays
        Fold by fold; the last one holds the samples between folds.
    scale : (p,) array
        By which columns were divided.
    rigid : int
        How many columns, the first ones, are the rigid machine's.
    prior : float
        What is known of these beforehand, in the same measure; see `prior_of`.
    ridge : float
        What is added to their normal equations, per sample, where it is more than that.
    least : float
        Mean square that is told from nothing.
    answers : dict
        What was asked of these equations; others begin with none.
    """

    G: Array
    g: Array
    yy: Array
    n: Array
    scale: Array
    rigid: int
    prior: float = RIDGES[0]
    ridge: float = RIDGES[0]
    least: float = 0.0
    answers: dict[tuple[object, ...], object] = field(init=False, default_factory=dict, repr=False)

    @classmethod
    def of(cls, X: Array, y: Array, fold: np.ndarray, usual: Array, given: float = 0.0) -> Bench:
        """Return the normal equations of columns X (N, p) and readings y (N,) of folds (N,).

        The first columns (r) are the rigid machine's, `usual` (r,) their size in a movement of all joints; `given` is
        the mean square of what the drive gave.
        """
        scale = np.sqrt(np.mean(X**2, axis=0))
        scale[: len(usual)] = usual
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
            len(usual),
            least=EXACT**2 * given,
        )

    def with_columns(self, at: Sequence[int], X: Array, y: Array, fold: np.ndarray) -> Bench:
        """Return the equations with other values in some columns, as X (N, p) has them, unscaled."""
        G, g, count = self.G.copy(), self.g.copy(), len(self.n)
        own = fold[:, None] == [*range(count - 1), BETWEEN]
        values = X[:, at] / self.scale[list(at)]
        of_fold = (own[:, :, None] * values[:, None, :]).reshape(len(X), -1)
        rows = (X.T @ of_fold / self.scale[:, None]).reshape(-1, count, len(at)).transpose(1, 2, 0)
        G[:, at], G[:, :, at], g[:, at] = rows, rows.transpose(0, 2, 1), (y @ of_fold).reshape(count, -1)
        return replace(self, G=G, g=g)

    def with_prior(self, prior: float) -> Bench:
        """Return the equations with what is known of the rigid machine beforehand, if that is more; see `prior_of`."""
        return replace(self, prior=max(self.prior, prior))

    @property
    def folds(self) -> tuple[int, ...]:
        """Folds that hold samples."""
        return tuple(int(f) for f in np.flatnonzero(self.n[:-1]))

    def _of(self, columns: Sequence[int], folds: Sequence[int]) -> tuple[Array, Array]:
        """Return the normal equations of columns on some folds together."""
        at, rows = np.asarray(columns, dtype=int), np.asarray(folds, dtype=int)
        rows = rows[:, None]
        return self.G[rows[:, :, None], at[:, None], at].sum(axis=0), self.g[rows, at].sum(axis=0)

    def fit(self, columns: Sequence[int], folds: Sequence[int], ridge: float | None = None) -> Array:
        """Return the coefficients of columns, as scaled, by least squares on some folds."""
        (G, g), at = self._of(columns, folds), np.asarray(columns, dtype=int)
        n = self.n[list(folds)].sum()
        G[np.diag_indices_from(G)] += self._held(at, self.ridge if ridge is None else ridge) * n
        return _solved(G, g)

    def _held(self, columns: np.ndarray, ridge: float | Array) -> Array:
        """Return what is added for columns (p,), per sample, with a ridge of the rigid machine's, or several (R, 1)."""
        return np.where(columns < self.rigid, np.maximum(ridge, self.prior), RIDGES[0])

    def left(self, X: Array, y: Array, columns: Sequence[int], folds: Sequence[int]) -> Array:
        """Return what a fit of columns to some folds leaves of samples (M,), X (M, p) unscaled."""
        return np.asarray(y - X[:, columns] @ (self.fit(columns, folds) / self.scale[list(columns)]))

    def left_apart(self, X: Array, y: Array, held: np.ndarray, columns: Sequence[int], folds: Sequence[int]) -> Array:
        """Return what is left of samples (M,) of some folds, each by a fit to the others; nan of all other samples."""
        out = np.full(len(y), np.nan)
        for fold in folds:
            own = held == fold
            out[own] = self.left(X[own], y[own], columns, [f for f in folds if f != fold])
        return out

    def error(self, columns: Sequence[int], coefficients: Array, folds: Sequence[int]) -> float:
        """Return the sum of squares that coefficients leave on some folds."""
        G, g = self._of(columns, folds)
        left = self.yy[list(folds)].sum() - 2 * coefficients @ g + coefficients @ G @ coefficients
        return float(max(left, self.least * self.n[list(folds)].sum()))

    @_once
    def train(self, columns: Sequence[int], folds: Sequence[int]) -> float:
        """Return the sum of squares that a fit on some folds leaves there."""
        return self.error(columns, self.fit(columns, folds), folds)

    def gains(self, columns: Sequence[int], groups: Sequence[Sequence[int]], folds: Sequence[int]) -> Array:
        """Return by how much the sum of squares of a fit to some folds falls with each group of further columns."""
        at, rows = np.asarray(columns, dtype=int), list(folds)
        G, g = self.G[rows].sum(axis=0), self.g[rows].sum(axis=0)
        inner = G[np.ix_(at, at)]
        inner[np.diag_indices_from(inner)] += self._held(at, self.ridge) * self.n[rows].sum()
        if len(at):
            found = np.linalg.lstsq(inner, np.column_stack([G[at], g[at]]), rcond=1e-12)[0]
        else:
            found = np.zeros((0, G.shape[0] + 1))
        rest, left = G - G[:, at] @ found[:, :-1], g - G[:, at] @ found[:, -1]
        count, out = np.array([len(group) for group in groups]), np.empty(len(groups))
        for k in np.unique(count):  # those of like many columns at once
            some = np.flatnonzero(count == k).tolist()
            own = np.array([groups[i] for i in some], dtype=int).reshape(-1, k)
            inner = rest[own[:, :, None], own[:, None, :]] + NOTHING * self.n[rows].sum() * np.eye(k)
            out[some] = (left[own] * np.linalg.solve(inner, left[own][..., None])[..., 0]).sum(axis=1)
        return out

    def held_out(self, columns: Sequence[int], folds: Sequence[int]) -> float:
        """Return the mean square on each of some folds, of fits to the others with the ridge that serves best."""
        return float(self._held_out(columns, folds).min())

    def with_ridge(self, columns: Sequence[int], folds: Sequence[int] | None = None) -> Bench:
        """Return the equations with the ridge that predicts some folds best, of fits to the others."""
        errors = self._held_out(columns, self.folds if folds is None else folds)
        return replace(self, ridge=RIDGES[int(np.argmin(errors))])

    @_once
    def _held_out(self, columns: Sequence[int], folds: Sequence[int]) -> Array:
        """Return the mean square on each of some folds, of fits to the others, for every ridge: all solved at once."""
        at, rows = np.asarray(columns, dtype=int), np.asarray(folds, dtype=int)
        if not len(at):
            return np.full(len(RIDGES), max(self.yy[rows].sum() / self.n[rows].sum(), self.least))
        G, g, n = self.G[rows[:, None, None], at[:, None], at], self.g[rows[:, None], at], self.n[rows]
        each = self._held(at, np.array(RIDGES)[:, None])
        rest = np.repeat((G.sum(axis=0) - G)[None], len(RIDGES), axis=0)
        rest[..., np.arange(len(at)), np.arange(len(at))] += each[:, None] * (n.sum() - n)[:, None]
        found = _each_solved(rest, g.sum(axis=0) - g)
        left = self.yy[rows] + (found * ((G @ found[..., None])[..., 0] - 2 * g)).sum(axis=2)
        return np.asarray(np.maximum(left.sum(axis=1) / n.sum(), self.least))

    def covariance(self, columns: Sequence[int], folds: Sequence[int] | None = None) -> Array:
        """Return the inverse of the normal equations of some folds, or all samples, of coefficients as scaled.

        Without the ridge that serves predictions best: it is no knowledge of any coefficient.
        """
        at = np.asarray(columns, dtype=int)
        rows = range(len(self.n)) if folds is None else folds
        G, _ = self._of(columns, rows)
        G[np.diag_indices_from(G)] += self._held(at, RIDGES[0]) * self.n[list(rows)].sum()
        return np.asarray(np.linalg.pinv(G, hermitian=True))


def _each_solved(G: Array, g: Array) -> Array:
    """Return the solutions (R, F, p) of normal equations (R, F, p, p), (F, p)."""
    try:
        return np.asarray(np.linalg.solve(G, g[None, :, :, None])[..., 0])
    except LinAlgError:
        return np.array([[_solved(*pair) for pair in zip(of_ridge, g, strict=True)] for of_ridge in G])


def _solved(G: Array, g: Array) -> Array:
    """Return the solution of normal equations, the shortest one where they are singular."""
    if not len(g):
        return g
    try:
        return np.asarray(cho_solve(cho_factor(G, check_finite=False), g, check_finite=False))
    except LinAlgError:
        return np.asarray(np.linalg.lstsq(G, g, rcond=None)[0])
