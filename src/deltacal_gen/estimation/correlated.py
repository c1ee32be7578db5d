"""Noise that readings have in common: what every sort of it answers, and how likely it is beside what a fit took."""

from __future__ import annotations

import dataclasses
from abc import ABC, abstractmethod
from typing import Any, NamedTuple, Self, cast

import numpy as np

from deltacal_gen.inference.likelihood import TINY, MixedModel
from deltacal_gen.inference.noise import NoiseModel
from deltacal_gen.machine.registry import Array

NOISES = 10.0  # times the variance that a fit leaves, either way: between these that of noise is sought
FAINT = 1e-6  # weight below which a reading counts for nothing
MOST_STEPS, SETTLED = 50, 1e-6  # towards the likeliest noise, and of the deviance's slope what is as good as none


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
    def rows(self) -> float:
        """So many rows tell as much of a mean as one whose noise is its own; by default as many as of its size."""
        return self.rows_of_size

    @property
    @abstractmethod
    def rows_of_size(self) -> float:
        """So many rows tell as much of the size of noise as one whose noise is its own."""

    @property
    def within(self) -> float:
        """Part of the variance that rows of a set-up show about their mean; by default all of it."""
        return 1.0

    @property
    @abstractmethod
    def noise(self) -> NoiseModel:
        """Noise of one component."""

    @property
    @abstractmethod
    def text(self) -> str:
        """What readings have in common, in words."""

    def like(self, other: Correlated) -> Self:
        """Return the noise of these readings as that of others is, of the same sort."""
        return dataclasses.replace(cast(Any, self), rho=other.rho, own=other.own)

    def weighted(self, weight: Array | None) -> Self:
        """Return the noise of rows that count so much (R,), 1 fully."""
        return dataclasses.replace(cast(Any, self), weight=weight)

    def counts(self, n: int) -> Array:
        """Return how much each of n rows counts."""
        return np.ones(n) if self.weight is None else np.maximum(self.weight, FAINT)

    def freed(self, values: Array) -> Array:
        """Return rows (R, ...) freed of what others tell, those before them where they have an order, of size 1."""
        root = np.sqrt(self.counts(len(values)))
        return self.noise.whiten(values / root.reshape(-1, *[1] * (values.ndim - 1)))

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
        volume = z.shape[1] * self.noise.log_det
        if taken is None:
            return float(z.size * np.log(np.mean(self.freed(z) ** 2)) + volume)
        rows = self.freed(np.concatenate([taken.free, taken.known, z[..., None]], axis=2)).reshape(z.size, -1)
        free, R = taken.free.shape[2], np.asarray(np.linalg.qr(rows, mode="r"))
        A, e, contrasts = R[free:, free:-1], R[free:, -1], len(rows) - free
        model = MixedModel.of(A, e - A @ taken.toward, np.zeros((len(A), 0))).diagonal()
        model = dataclasses.replace(model, contrasts=contrasts)
        about = max(float(R[:, -1] @ R[:, -1]), TINY) / max(contrasts, 1)  # what the fit leaves, wherever it stands
        ones, noise = np.ones(len(model.s)), about
        for _ in range(MOST_STEPS):  # fixed point of MacKay 1992, Neural Computation 4, 415-447
            each, slope = model.slopes(ones, noise)
            noise = float(np.clip(noise * (1 - slope / (contrasts - each.sum())), about / NOISES, about * NOISES))
            if abs(slope) < SETTLED:
                break
        return model.deviance(ones, noise) + volume + 2 * float(np.log(np.abs(np.diagonal(R)[:free])).sum())
