"""Noise that readings have in common: what every sort of it answers, and how likely it is beside what a fit took."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import NamedTuple, Self

import numpy as np

from deltacal_gen.machine.registry import Array

SIZES = np.geomspace(0.5, 2.0, 21)  # of noise that are tried, in the one that what each direction leaves speaks for
SETTLING = 10  # rounds to that one
UNSEEN = 1e-6  # of the largest singular value: less is no direction that readings see
DEFINITE = 1e-12  # of the variance: keeps a factor real where rounding would not
TINY = 1e-300  # of what readings without any error leave


class Taken(NamedTuple):
    """What a fit may have taken out of readings.

    Columns (R, k, n) of what it knew to one, and where it drew to (n,); columns (R, k, m) of what it knew nothing of.
    """

    known: Array
    toward: Array
    free: Array


class Correlated(ABC):
    """Noise of which readings have a part in common; that of a reading has the variance 1."""

    weight: Array | None
    rho: float
    own: float

    @property
    @abstractmethod
    def rows(self) -> float:
        """So many rows tell as much of a mean as one whose noise is its own."""

    @property
    @abstractmethod
    def rows_of_size(self) -> float:
        """So many rows tell as much of the size of noise as one whose noise is its own."""

    @property
    @abstractmethod
    def within(self) -> float:
        """Part of the variance that rows of a set-up show about their mean."""

    @property
    @abstractmethod
    def volume(self) -> float:
        """Logarithm of the determinant of the covariance of one component."""

    @property
    @abstractmethod
    def text(self) -> str:
        """What readings have in common, in words."""

    @abstractmethod
    def like(self, other: Correlated) -> Self:
        """Return the noise of these readings as that of others is, of the same sort."""

    @abstractmethod
    def weighted(self, weight: Array | None) -> Self:
        """Return the noise of rows that count so much (R,), 1 fully."""

    @abstractmethod
    def freed(self, values: Array) -> Array:
        """Return rows (R, ...) freed of what others tell; noise of size 1 stays so."""

    def ways(self, values: Array) -> Array:
        """Return rows (R, ...) freed in each way (w, R, ...) in which one may go through them: none is the noise's own.

        Sums of their squares are the same but where a row counts less; a robust size is not.
        """
        return self.freed(values)[None]

    @abstractmethod
    def alone(self, values: Array) -> Array:
        """Return what all others do not tell of each row (R, k); noise of size 1 stays so."""

    @abstractmethod
    def likeliest(self, z: Array, taken: Taken | None = None) -> tuple[Self, float]:
        """Return the noise that explains rows (R, k) best, beside what a fit took out of them, and its deviance."""

    def parted(self, freed: Array, chosen: np.ndarray) -> Array:
        """Return of rows (scalars, ...) that are freed some (scalars,), freed of one another; here as they are."""
        return freed[chosen]

    def freed_among(self, values: Array, known: np.ndarray) -> Array:
        """Return rows (R, ...) freed of those that are known (R,), others zero, as they come."""
        return self.freed(values)

    def deviance(self, z: Array, taken: Taken | None = None) -> float:
        """Return twice the negative logarithm of the likelihood of rows (R, k), but for a constant.

        Their common size is the one that fits best. What a fit may have taken is taken out as this noise has it: the
        likelihood is that of the rest (Patterson and Thompson 1971, Biometrika 58, 545-554).
        """
        e = self.freed(z).ravel()
        volume = z.shape[1] * self.volume
        if taken is None:
            return float(e.size * np.log(np.mean(e**2)) + volume)
        A, M = (self.freed(columns).reshape(len(e), -1) for columns in (taken.known, taken.free))
        Q, R = np.linalg.qr(M)
        both = np.column_stack([A, e])
        both -= Q @ (Q.T @ both)
        A, e = both[:, :-1], both[:, -1]
        A, inner = np.linalg.qr(A)
        U, root, V = np.linalg.svd(inner, full_matrices=False)  # a part may have fewer readings than columns
        seen = root > UNSEEN * root.max(initial=0.0)  # of joints without a drawing the instrument alone is unknown
        A, root = A @ U[:, seen], root[seen]
        along, size = A.T @ e, root**2
        rest, free = max(float(np.sum((e - A @ along) ** 2)), TINY), len(e) - M.shape[1]
        inside = (along - root * (V[seen] @ taken.toward)) ** 2
        about = max(float(e @ e), TINY) / max(free, 1)  # what the fit leaves is near to it, wherever the machine stands
        for _ in range(SETTLING):  # to where the slope of the likelihood by the size is nothing
            noise = about / (about + size)
            about = (rest + (inside * noise**2).sum()) / max(free - len(size) + noise.sum(), DEFINITE)
        s = about * SIZES[:, None] ** 2
        each = free * np.log(s[:, 0]) + np.log1p(size / s).sum(axis=1)
        each += rest / s[:, 0] + (inside / (s + size)).sum(axis=1)
        return _least(each) + volume + 2 * float(np.log(np.abs(np.diagonal(R))).sum())


def _least(each: Array) -> float:
    """Return the least of values (n,) in equal steps, between them by a parabola."""
    k = int(np.clip(np.argmin(each), 1, len(each) - 2))
    before, at, after = each[k - 1 : k + 2]
    bend = before - 2 * at + after
    return float(at - (after - before) ** 2 / (8 * bend)) if bend > 0 else float(min(each))
