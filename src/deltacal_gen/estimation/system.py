"""The readings made linear at a state of the fit, each divided by its noise: the one matrix that every step is of.

It is factored once. The triangle of its columns, the instrument's first, holds all that a step, its rule and its
uncertainty ask of the rows; what the instrument explains is taken out where the triangle is cut.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from deltacal_gen.estimation.problem import Linearised
from deltacal_gen.estimation.residuals import Repeats
from deltacal_gen.estimation.solvers import WEAKEST, triangle
from deltacal_gen.machine.registry import Array

STRONG = 1e-2  # of the largest singular value of such columns: the instrument is led along arcs there


@dataclass(frozen=True, eq=False)
class System:
    """Rows of unit noise: ``b - A_p s - A_m t`` is left by a step s of scaled parameters and t of the instrument.

    Attributes
    ----------
    rows : (scalars, n_m + n + 1) array
        Columns of the instrument, those of the parameters, what was measured beyond the machine.
    n_m : int
        Unknowns of the instrument.
    """

    rows: Array
    n_m: int

    @property
    def A_m(self) -> Array:
        """Columns (scalars, n_m) of the instrument."""
        return self.rows[:, : self.n_m]

    @property
    def A_p(self) -> Array:
        """Columns (scalars, n) of the scaled parameters."""
        return self.rows[:, self.n_m : -1]

    @property
    def b(self) -> Array:
        """What was measured beyond the machine (scalars,)."""
        return self.rows[:, -1]

    @cached_property
    def triangle(self) -> Array:
        """R (n_m + n + 1, the same) of the rows; of fewer rows as many."""
        return triangle(self.rows)

    @property
    def machine(self) -> tuple[Array, Array]:
        """The triangle (n + 1, n) and (n + 1,) of A_p and b without what the instrument explains."""
        R = self.triangle[self.n_m :]
        return R[:, self.n_m : -1], R[:, -1]

    @property
    def instrument(self) -> tuple[Array, Array]:
        """The triangle (n_m, n_m) of the instrument's columns, and what of A_p and b lies along them (n_m, n + 1)."""
        R = self.triangle[: self.n_m]
        return R[:, : self.n_m], R[:, self.n_m :]

    def subset(self, chosen: np.ndarray, weights: Array, shared: Repeats) -> System:
        """Return the system of some of its rows, weighed as all are."""
        return dataclasses.replace(self, rows=shared.parted(self.rows, chosen, weights))

    def following(self, s: Array) -> Array:
        """Return the instrument's step (n_m,) that goes best with a step of the parameters."""
        if not self.n_m:
            return np.zeros(0)
        R, along = self.instrument
        size = length_of(R)
        return np.linalg.lstsq(R / size, along[:, -1] - along[:, :-1] @ s, rcond=WEAKEST)[0] / size

    @cached_property
    def back(self) -> Array:
        """By which rows are multiplied (n_m, scalars) for the instrument's step along what moves them much."""
        R, _ = self.instrument
        size = length_of(R)
        _, s, Vt = np.linalg.svd(R / size, full_matrices=False)
        V = Vt[s > STRONG * s[0]].T / s[s > STRONG * s[0]]
        return np.asarray((V @ V.T / size / size[:, None]) @ self.A_m.T)


def system(state: Linearised, sigma: Array, weights: Array, shared: Repeats, scale: Array) -> System:
    """Return rows divided by the noise, columns multiplied by the scale, unread components dropped."""
    (R, k, n), n_m = state.J_p.shape, state.J_m.shape[2]
    rows = np.empty((R, k, n_m + n + 1))
    rows[..., :n_m] = state.J_m
    np.multiply(state.J_p, scale, out=rows[..., n_m:-1])
    rows[..., -1] = state.residual
    return System(whitened(rows, np.isfinite(state.residual), sigma, weights, shared, out=rows), n_m)


def whitened(
    values: Array, read: np.ndarray, sigma: Array, weights: Array, shared: Repeats, out: Array | None = None
) -> Array:
    """Return values (R, k, ...) as rows (scalars, ...) of unit noise; `read` (R, k) says which there are."""
    rows = in_unit_noise(values, read, sigma, weights, shared, out)
    return rows.reshape(-1, *rows.shape[2:]) if read.all() else rows[read]


def in_unit_noise(
    values: Array, read: np.ndarray, sigma: Array, weights: Array, shared: Repeats, out: Array | None = None
) -> Array:
    """Return values (R, k, ...) whitened, those that are not `read` (R, k) as zero."""
    by = np.sqrt(weights)[:, None] * (np.sqrt(1 + np.asarray(shared.ratio)) / sigma)
    rows = np.multiply(values, by.reshape(*by.shape, *[1] * (values.ndim - 2)), out=out)
    if not read.all():
        rows[~read] = 0.0
    return shared.whiten(rows, weights)


def length_of(A: Array) -> Array:
    """Return the length of the columns; one of columns without any, which nothing moves."""
    size = np.sqrt((A**2).sum(axis=0))
    return np.where(size > 0, size, 1.0)
