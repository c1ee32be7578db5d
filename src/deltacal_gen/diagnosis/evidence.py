"""What readings that took part in no fit say of an effect: a likelihood ratio, and how often it errs.

Where the effect is on the machine, twice the logarithm of the ratio of likelihoods with it and without it is on average
the sum D of squares of what it moves the held-out readings by, in standard deviations; where it is not, -D; it scatters
by 2 sqrt(D) either way. Decided at zero both errors are as likely, Phi(-sqrt(D) / 2). Huber's function in the place of
the square bounds what a gross error can say.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.residuals import HUBER
from deltacal_gen.machine.registry import Array

FAR = 3.0  # times what the ratio scatters by: so far below its size it is not of effects that hold
SHORT = 0.5  # of its size: what bears out less predicts hardly better than no effect (three quarters of each movement)
MOST_WRONG = 0.05  # probability of either error, beyond which held-out readings decide nothing


@dataclass(frozen=True)
class Evidence:
    """For effects, by held-out readings.

    Attributes
    ----------
    ratio : float
        Twice the logarithm of the likelihood ratio.
    size : float
        What it is on average where the effects hold, by squares.
    expected : float
        The same by Huber's function, of readings as far off as they are with the effects, to either side: of effects
        that move readings by many standard deviations it is far less.
    """

    ratio: float
    size: float
    expected: float

    @property
    def wrong(self) -> float:
        """Probability of naming what is not there, and of missing what is."""
        from scipy.special import ndtr

        return float(ndtr(-np.sqrt(self.size) / 2))

    @property
    def speaks(self) -> bool:
        """Whether the readings bear the effects out."""
        return self.ratio > 0 and self.wrong <= MOST_WRONG

    @property
    def denies(self) -> bool:
        """Whether the readings lie farther off with the effects, by more than the ratio scatters."""
        return self.ratio < -2 * float(np.sqrt(self.size))

    @property
    def falls_short(self) -> bool:
        """Whether the readings deny the effects, or bear out far less than effects that hold move them by.

        What only stands for something else, or was chosen of very many, moves readings by more than they bear out.
        Beside what nothing explains sizes differ from part to part by more than noise: then at least by half.
        """
        scatter = FAR * 2 * float(np.sqrt(max(self.expected, 0.0)))
        return self.denies or self.ratio < min(self.expected - scatter, SHORT * self.expected)


def evidence(at: Fit, before: Array, after: Array) -> Evidence:
    """Return what held-out errors (R, k) [mm, rad] without effects and with them say, as a fit counts readings."""
    seen: np.ndarray = np.isfinite(before) & np.isfinite(after)
    without, with_them = (_whitened(at, np.where(seen, e, 0.0), np.asarray(seen.any(axis=1))) for e in (before, after))
    ratio, moved = float((_huber(without) - _huber(with_them)).sum()), without - with_them
    either = (_huber(with_them + moved) + _huber(with_them - moved)) / 2 - _huber(with_them)
    return Evidence(ratio, float((moved**2).sum()), float(either.sum()))


def _whitened(at: Fit, errors: Array, known: np.ndarray) -> Array:
    """Return errors (R, k) in units of their noise, what repeats and neighbours that are `known` share taken off."""
    read = np.isfinite(at.residual).any(axis=0)
    ratio = np.broadcast_to(at.repeats.ratio, read.shape)[read]
    whole = dataclasses.replace(at.repeats, ratio=ratio)
    return whole.whiten(errors[:, read] / at.sigma[read] * np.sqrt(1 + ratio), known=known)


def _huber(z: Array) -> Array:
    size = np.abs(z)
    return np.where(size <= HUBER, size**2, 2 * HUBER * size - HUBER**2)
