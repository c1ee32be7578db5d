"""States with a memory along a run, ``dz/dt = f(z, states)``: from the rows of a recording in the order of time.

An effect's generated module says what becomes of z over an interval, ``step``, and where a run begins, ``start``. A run
is one system of equations with two diagonals, ``z_k+1 = step(z_k)``: it is solved by Newton's method for all rows at
once, which takes one round where f is linear in z. Intervals are halved until what halving changes is below a
tolerance; how far z may be off is carried along the run as z itself is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Constant, Kernels

TOLERANCE = 1e-7  # see `along`
ROUNDING = 1e-14  # of the same: no interval is halved for less
HALVINGS = 24  # of an interval between two rows
MOST, PER_ROW = 50_000, 20  # points of all runs together, or so many for each row
ROUNDS = 30  # of Newton's method
SETTLED = 1e-12  # of z, or of 1 where z is smaller: the last round's change
THIRD_ORDER = 8 / 7  # error of an interval, fourth order in its length, by what halving it changes


@dataclass(frozen=True, eq=False)
class Along:
    """Memories at the rows of a recording.

    Attributes
    ----------
    value : (N, limbs, m) array
        NaN where Newton's method does not settle.
    by_coefficients : (N, limbs, m, n_c) array
        Derivatives by an effect's coefficients.
    bound : (N, limbs, m) array
        How far the values may be off, as far as halving the intervals tells.
    settled : (N, limbs) array of bool
        Whether the interval before a row adds less than the tolerance to that.
    """

    value: Array
    by_coefficients: Array
    bound: Array
    settled: np.ndarray


def along(
    kernels: Kernels,
    states: Array,
    coefficients: Array,
    constants: tuple[Constant, ...],
    time: Array,
    run: np.ndarray,
    *,
    tolerance: float = TOLERANCE,
) -> Along:
    """Return an effect's memories at all rows.

    Parameters
    ----------
    kernels : module
        Of the effect.
    states : (N, limbs, n_s) array
        What the effect reads, row by row; limbs is 1 for an effect of the machine.
    coefficients : (N, limbs, n_c) array
    time : (N,) array [s]
    run : (N,) array of int
        Which rows are one uninterrupted movement; within a run rows are taken in the order of time.
    tolerance : float
        How far a memory may go astray from row to row, of itself or of 1 where it is smaller.
    """
    order = np.lexsort((time, run))
    first = np.r_[True, np.diff(run[order]) != 0]
    length = np.where(first, 0.0, np.diff(time[order], prepend=0.0))
    share, rows = np.ones(len(order)), np.arange(len(order))
    points = _Points(kernels, constants, length, share, states[order], coefficients[order], first, rows)
    z, whole, slope, by_c = points.solved()
    for halving in range(HALVINGS + 1):
        errors = points.errors(z, whole)
        allowed = np.maximum(tolerance * points.share[:, None, None], ROUNDING) * np.maximum(1.0, np.abs(z))
        coarse: np.ndarray = np.any(errors > allowed, axis=(1, 2))
        if halving == HALVINGS or not coarse.any() or len(z) + coarse.sum() > max(MOST, PER_ROW * len(time)):
            break
        points = points.halved(coarse)
        z, whole, slope, by_c = points.solved()
    bound = recursion(np.abs(slope), errors)
    rows, back = points.rows, np.argsort(order)
    settled = np.logical_and.reduceat((errors <= allowed).all(axis=2), np.r_[0, rows[:-1] + 1], axis=0)
    return Along(z[rows][back], by_c[rows][back], bound[rows][back], settled[back])


@dataclass(frozen=True, eq=False)
class _Points:
    """Rows, in the order of time, and the points between them at which a run is solved.

    Attributes
    ----------
    length : (K,) array
        Of the interval that ends at each point; 0 where a run begins.
    share : (K,) array
        Part of the time between two rows that an interval takes.
    states, coefficients : (K, limbs, n) arrays
    first : (K,) array of bool
        Points at which a run begins.
    rows : (N,) array of int
        Which points are rows.
    """

    kernels: Kernels
    constants: tuple[Constant, ...]
    length: Array
    share: Array
    states: Array
    coefficients: Array
    first: np.ndarray
    rows: np.ndarray

    def halved(self, chosen: np.ndarray) -> _Points:
        """Return the points, and those in the middle of the intervals that end at the chosen ones (K,)."""
        at = np.flatnonzero(chosen & ~self.first)
        half = np.where(np.isin(np.arange(len(self.length)), at), 0.5, 1.0)
        return replace(
            self,
            length=np.insert(self.length * half, at, self.length[at] / 2),
            share=np.insert(self.share * half, at, self.share[at] / 2),
            states=np.insert(self.states, at, (self.states[at - 1] + self.states[at]) / 2, axis=0),
            coefficients=np.insert(self.coefficients, at, self.coefficients[at], axis=0),
            first=np.insert(self.first, at, False),
            rows=self.rows + np.searchsorted(at, self.rows, side="right"),
        )

    def solved(self) -> tuple[Array, Array, Array, Array]:
        """Return z (K, limbs, m), what each interval makes of the one before, and the derivatives by that and by c."""
        start = self._flat(self.kernels.start, self.states, self.coefficients)
        z = start[np.maximum.accumulate(np.where(self.first, np.arange(len(start)), 0))]
        begins = self.first[:, None, None]
        for _ in range(ROUNDS):
            found = self._over(z[self._before], self.states[self._before], self.states, self.length)
            slope = np.where(begins, 0.0, found[..., 1])
            change = recursion(slope, np.where(begins, start, found[..., 0]) - z)
            z = z + change
            if not np.abs(change).max(initial=0.0) > SETTLED * max(1.0, float(np.abs(z).max(initial=0.0))):
                break
        else:
            z = np.full_like(z, np.nan)
        by = np.where(begins[..., None], 0.0, found[..., 2:])
        return z, found[..., 0], slope, recursion(np.broadcast_to(slope[..., None], by.shape), by)

    def errors(self, z: Array, whole: Array) -> Array:
        """Return how far each point is off by its own interval, (K, limbs, m): what halving it would change.

        `whole` is what the intervals make of the points before them, as `solved` returns it.
        """
        begin, half = self.states[self._before], self.length / 2
        middle = (begin + self.states) / 2
        there = self._over(z[self._before], begin, middle, half)[..., 0]
        halves = self._over(there, middle, self.states, half)[..., 0]
        return np.where(self.first[:, None, None], 0.0, np.abs(whole - halves) * THIRD_ORDER)

    @property
    def _before(self) -> np.ndarray:
        return np.maximum(np.arange(len(self.length)) - 1, 0)

    def _over(self, z: Array, states: Array, to: Array, length: Array) -> Array:
        """Return z at the end of intervals, its derivative by that at the begin, and those by the coefficients.

        The kernel's rule is of second order; over both halves of an interval, and over the whole, it gives one of
        third (Richardson's extrapolation).

        Returns
        -------
        (K, limbs, m, 2 + n_c) array
        """
        middle, half = (states + to) / 2, length / 2
        whole, there = self._step(z, states, to, length), self._step(z, states, middle, half)
        halves = self._step(there[..., 0], middle, to, half)
        by = halves[..., 1:2] * there[..., 1:]  # through the first half
        by[..., 1:] += halves[..., 2:]
        both = np.concatenate([halves[..., :1], by], axis=-1)
        return both + (both - whole) / 3

    def _step(self, z: Array, states: Array, to: Array, length: Array) -> Array:
        found = self._flat(self.kernels.step, z, states, to, np.repeat(length, z.shape[1]), self.coefficients)
        return found.reshape(*z.shape, -1)

    def _flat(self, kernel: Callable[..., Array], *arrays: Array) -> Array:
        """Return a kernel's result (K, limbs, n); it takes rows, one for each point and limb."""
        flat = [a.reshape(-1, a.shape[2]) if a.ndim == 3 else a for a in arrays]
        return kernel(*flat, self.constants).reshape(*self.states.shape[:2], -1)


def recursion(factor: Array, added: Array) -> Array:
    """Return y (K, ...) with ``y_k = factor_k y_k-1 + added_k``."""
    from scipy.linalg import solve_banded  # as long to import as a whole identification takes; few effects remember

    factors, columns = factor.reshape(len(factor), -1), added.reshape(len(added), -1)
    out = np.empty_like(columns)
    for j in range(columns.shape[1]):
        diagonals = np.vstack([np.ones(len(columns)), np.append(-factors[1:, j], 0.0)])
        out[:, j] = solve_banded((1, 0), diagonals, columns[:, j], check_finite=False)
    return out.reshape(added.shape)
