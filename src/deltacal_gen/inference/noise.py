"""Noise of rows that have a part in common, as a sum of pieces: white, serial, shared.

The covariance is ``diag(own) + fading S + B B'``. S is that of a part which fades along runs of rows (autoregressive of
first order: ``exp(-dt / tau)`` between rows dt apart), B holds what rows share: the error of a point that several end
in, of a pose that several are of. Rows are freed of the serial part as Prais and Winsten (1954) do; that leaves the
white part with a covariance of three diagonals, whose factor takes it off too. What is shared is of low rank beside
that. Nothing of the size of the covariance is ever formed.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from deltacal_gen.inference.projection import Array

DEFINITE = 1e-12  # of a variance: keeps a factor real where rounding would not
FLAT = 1e-10  # of the largest square: less is a direction in which nothing that is shared moves a row
ALONE = 1e-6  # part of a row's variance that others leave of it, at least


@dataclass(frozen=True, eq=False)
class NoiseModel:
    """The covariance of rows.

    Attributes
    ----------
    order : (R,) int array
        Rows run by run; all that follows is in this order.
    own : (R,) array
        Variance of each row's own.
    told : (R,) array
        Correlation of the serial part of a row with that of the row before; 0 where a run begins.
    fading : float
        Variance of the serial part.
    shared : (R, m) array
        By how much each of m numbers of variance 1 moves the rows.
    """

    order: np.ndarray
    own: Array
    told: Array
    fading: float
    shared: Array

    def whiten(self, values: Array) -> Array:
        """Return rows (R, ...) freed of one another, of variance 1."""
        (U, square), e = self._span, self._in_order(values[self.order].reshape(len(values), -1))
        out = np.empty_like(e)
        if len(square):
            e -= U @ ((1 - 1 / np.sqrt(1 + square))[:, None] * (U.T @ e))
        out[self.order] = e
        return out.reshape(values.shape)

    def times(self, values: Array) -> Array:
        """Return the covariance times rows (R, ...)."""
        from scipy.linalg import solve_banded

        v = values[self.order].reshape(len(values), -1)
        ones = np.ones_like(self.told)
        after = solve_banded((1, 0), np.stack([ones, -np.append(self.told[1:], 0.0)]), v)
        before = solve_banded((0, 1), np.stack([-self.told, ones]), v)
        out = np.empty_like(v)
        out[self.order] = self.own[:, None] * v + self.fading * (before + after - v) + self.shared @ (self.shared.T @ v)
        return out.reshape(values.shape)

    @cached_property
    def log_det(self) -> float:
        """Logarithm of the determinant of the covariance."""
        return float(2 * np.log(self._left * self._factor[0]).sum() + np.log1p(self._span[1]).sum())

    def sized(self, own: float, shared: float) -> NoiseModel:
        """Return the noise of which what rows share is so many times as large, and all else; its span is known."""
        out = replace(self, own=own * self.own, fading=own * self.fading, shared=np.sqrt(shared) * self.shared)
        vars(out)["_span"] = self._span[0], self._span[1] * shared / own
        return out

    def restore(self, white: Array) -> Array:
        """Return rows (R, ...) as they were before they were freed, where none fades."""
        (U, square), e = self._span, white.reshape(len(white), -1)
        e = e + U @ ((np.sqrt(1 + square) - 1)[:, None] * (U.T @ e))
        return (e * np.sqrt(self.own)[:, None]).reshape(white.shape)

    def alone(self, values: Array) -> Array:
        """Return what all others do not tell of each row (R, k), of variance 1, where none fades."""
        (U, square), e = self._span, self._in_order(values)
        gone = square / (1 + square)
        e -= U @ (gone[:, None] * (U.T @ e))
        return e / np.sqrt(np.maximum(1 - U**2 @ gone, ALONE))[:, None]

    def _in_order(self, values: Array) -> Array:
        """Return rows (R, n) freed of the white and the serial part."""
        from scipy.linalg import solve_banded

        e = values / self._left[:, None]
        e[1:] -= (self.told / self._left)[1:, None] * values[:-1]
        return np.asarray(solve_banded((1, 0), self._factor, e, overwrite_b=True, check_finite=False))

    @cached_property
    def _left(self) -> Array:
        """Standard deviation (R,) of what the row before does not tell of the serial part, of variance 1."""
        return np.asarray(np.sqrt(1 - self.told**2))

    @cached_property
    def _factor(self) -> Array:
        """Factor (2, R) of the covariance of rows that are freed of what fades, as `solve_banded` takes it."""
        from scipy.linalg import cholesky_banded

        told, left, covariance = self.told, self._left, np.zeros((2, len(self.own)))
        covariance[0] = self.fading + self.own / left**2
        covariance[0, 1:] += told[1:] ** 2 * self.own[:-1] / left[1:] ** 2
        covariance[0] *= 1 + DEFINITE
        covariance[1, :-1] = -self.own[:-1] * told[1:] / left[1:] / left[:-1]
        return np.asarray(cholesky_banded(covariance, lower=True, check_finite=False))

    @cached_property
    def _span(self) -> tuple[Array, Array]:
        """Left singular vectors (R, r) of what is shared, freed of the rest, and squares (r,) of singular values."""
        if not self.shared.any():
            return self.shared[:, :0], np.zeros(0)
        B, tall = self._in_order(self.shared), np.greater(*self.shared.shape)
        square, V = np.linalg.eigh(B.T @ B if tall else B @ B.T)
        seen = square > FLAT * square.max(initial=0.0)
        square, V = square[seen], V[:, seen]
        return B @ V / np.sqrt(square) if tall else V, square
