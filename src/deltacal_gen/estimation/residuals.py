"""What residuals tell: their lengths, the noise of each component, what repeats share, how much each reading counts."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from functools import cached_property
from math import erf, erfc, exp, pi, sqrt

import numpy as np

from deltacal_gen.estimation.correlated import Correlated
from deltacal_gen.estimation.directions import levelling
from deltacal_gen.instrument.kind import Kind, Readings
from deltacal_gen.machine.registry import Array

SMALLEST_SIGMA = 1e-7  # mm and rad: noise below this is rounding of what went before, not of a reading
HUBER = 2.5  # standard deviations beyond which a reading's pull stops growing
# variance of normal noise of size 1 that is clipped there
CLIPPED = erf(HUBER / sqrt(2)) - sqrt(2 / pi) * HUBER * exp(-(HUBER**2) / 2) + HUBER**2 * erfc(HUBER / sqrt(2))
MOST_GROSS = 0.06  # of all readings: more than this are no errors of measurement but something left out
MOST_APART, APART = 0.25, 3.0  # of all readings, and times the largest of the others: such a gap no misfit leaves
FEWEST_APART = 3  # readings: fewer stand out by chance where a fit has taken most of what they say
MOST_WRONG = 0.2  # of points found in images: those of a part that is hidden or mirrored, and stray ones
USUAL_COUNTS = 3  # readings that knowing the usual noise of an instrument is worth
MOST_STEPS, SETTLED = 50, 1e-9  # towards what repeats share, and of its equation what is as good as none
GROSS = 6.0  # standard deviations beyond which a reading is listed as a gross error


@dataclass(frozen=True, eq=False)
class Repeats:
    """Readings of one pose share what their pose has in common: an error of re-aiming, of the machine, of the model.

    With `n` readings of a pose, variance 1 within and `ratio` between poses, the pose's mean has the variance
    ``ratio + 1/n``: more readings of the same pose do not make it any surer. The rows are whitened by taking the part
    ``1 - 1/sqrt(1 + n ratio)`` of the pose's mean off each reading (quasi-demeaning, generalised least squares of a
    random-effects model). The noise of a single reading is ``1 + ratio``; rows come divided by the part within.
    `ratio` is a number, or one for each component of a reading: positions may be aimed anew where rotations are not.

    Noise may hang together in time, too: `series` says how, and in which order readings were taken; of distances, which
    points they lie between and share the errors of. Where it is not
    alike in all directions, `shape` (k, k) is its covariance in units of the mean variance.
    """

    group: np.ndarray
    ratio: float | Array = 0.0
    series: Correlated | None = None
    shape: Array | None = None

    @property
    def plain(self) -> bool:
        """Whether the noise of each row is its own, and alike in all directions."""
        return self.series is None and self.shape is None

    @property
    def by_row(self) -> bool:
        """Whether a row is whitened by itself: its noise is its own, be it alike in all directions or not."""
        return self.series is None and not np.any(self.ratio)

    def as_plain(self) -> Repeats:
        """Return what repeats share alone."""
        return self if self.plain else dataclasses.replace(self, series=None, shape=None)

    @property
    def rows(self) -> float:
        """So many rows tell as much as one whose noise is its own."""
        return 1.0 if self.series is None else self.series.rows

    def whiten(self, values: Array, weights: Array | None = None, known: np.ndarray | None = None) -> Array:
        """Return rows (R, k, ...) with all that they share taken off, alike in all directions.

        They come multiplied by the roots of `weights` (R,); those that are not `known` (R,) are zero.
        """
        apart = self._apart(self.levelled(values), np.ones(len(values)) if weights is None else weights)
        if self.series is None:
            return apart
        series = self.series.weighted(weights)
        return series.freed(apart) if known is None else series.freed_among(apart, known)

    def parted(self, rows: Array, chosen: np.ndarray, weights: Array | None = None) -> Array:
        """Return some (scalars,) of whitened rows (scalars, n); see `whiten`."""
        return rows[chosen] if self.series is None else self.series.weighted(weights).parted(rows, chosen)

    def levelled(self, values: Array) -> Array:
        """Return rows (R, k, ...) whose noise is alike in all directions."""
        if self._level is None:
            return values
        return np.einsum("ij,rj...->ri...", self._level, values)

    def freed(self, residual: Array) -> Array:
        """Return residuals (R, k), NaN where nothing was read, as noise that each row has of its own would leave them.

        They come (w, R, k), in as many ways as one may go through rows that hang together: what is said of noise is
        the same whichever way a file runs. What of noise that fades a fit took shows in them.
        """
        levelled = self.levelled(residual)
        if self.series is None:
            return levelled[None]
        return np.where(np.isfinite(levelled), self.series.ways(np.nan_to_num(levelled)), np.nan)

    def off(self, residual: Array) -> Array:
        """Return how far readings (R, k) are off what is predicted and, where they hang together, off their neighbours.

        The lesser of the two counts: rows that wandered off together are no gross errors, nor are those beside one.
        """
        levelled = self.levelled(residual)
        if self.series is None:
            return levelled
        alone = self.series.alone(np.nan_to_num(levelled))
        return np.where(np.abs(alone) < np.abs(levelled), alone, levelled)

    @cached_property
    def _level(self) -> Array | None:
        return None if self.shape is None else levelling(self.shape)

    def _apart(self, values: Array, weights: Array) -> Array:
        if not np.any(self.ratio):
            return values
        order = np.argsort(self.group, kind="stable")
        _, first, own = np.unique(self.group[order], return_index=True, return_inverse=True)
        root = np.sqrt(weights[order]).reshape(-1, *[1] * (values.ndim - 1))
        count = np.add.reduceat(weights[order], first).reshape(-1, *[1] * np.ndim(self.ratio))
        part = (1 - 1 / np.sqrt(1 + count * self.ratio)) / np.maximum(count, 1e-300)
        part = part.reshape(*part.shape, *[1] * (values.ndim - part.ndim))
        sums = np.add.reduceat(values[order] * root, first, axis=0) * part
        whitened = np.array(values, dtype=float)
        whitened[order] -= sums[own] * root
        return whitened

    @staticmethod
    def ratio_of(
        residual: Array, group: np.ndarray, fitted: float = 0.0, inside: float = 0.0
    ) -> tuple[float, float, int]:
        """Return (variance between / within, variance within, degrees of freedom within) of residuals (R, k).

        `fitted` is the number of parameters that the means of the groups have carried, `inside` that of those that the
        differences within them have.
        """
        residual = np.nan_to_num(_read(residual))
        count = np.bincount(group)
        several = count[group] > 1
        degrees = int((count[count > 1] - 1).sum()) * residual.shape[1]
        if degrees < 6:
            return 0.0, 0.0, degrees
        sums = np.zeros((len(count), residual.shape[1]))
        np.add.at(sums, group, residual)
        means = sums / np.maximum(count, 1)[:, None]
        within = float(((residual - means[group])[several] ** 2).sum() / max(degrees - inside, 1.0))
        some = count > 0
        spare = max(some.sum() * residual.shape[1] - fitted, 1.0)
        square = (means[some] ** 2).sum(axis=1) / max(within, SMALLEST_SIGMA**2)
        return _between(square, count[some], spare), within, degrees


def _between(square: Array, count: np.ndarray, spare: float) -> float:
    """Return the ratio at which means of `count` (G,) readings scatter as they do, `square` (G,) times noise within.

    Means of few readings have more noise and tell less (Paule, Mandel 1982): ``sum(square / (ratio + 1 / count))`` is
    their degrees of freedom. It falls and is convex, so that Newton's steps come from below.
    """
    ratio = 0.0
    for _ in range(MOST_STEPS):
        weight = 1 / (ratio + 1 / count)
        excess = float(square @ weight) - spare
        if excess <= SETTLED * spare:
            break
        ratio += excess / float(square @ weight**2)
    return ratio


def rms(values: Array) -> float:
    """Return the RMS of the values that are finite; NaN where none is."""
    found = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(found**2))) if found.size else float("nan")


def lengths(residual: Array, kind: Kind) -> Array:
    """Return the components of length of residuals (R, k) [mm]: no rotations, and no axis that nothing reads."""
    return _read(np.delete(residual, kind.turned, axis=1))


def _read(residual: Array) -> Array:
    """Return the columns of residuals (R, k) in which anything was read."""
    return residual[:, np.isfinite(residual).any(axis=0)]


def shared_by_repeats(
    found: Readings, residual: Array, quiet: np.ndarray, carried: tuple[float, float], leverage: Array
) -> Repeats:
    """Return what repeats share, of each group of columns for itself; they part what the fit took by their leverage.

    `carried` is how many parameters the means of poses have carried, and how many the differences within them.
    """
    groups, ratio = found.kind.noise_groups(residual.shape[1]), np.zeros(residual.shape[1])
    parts = [groups == g for g in range(len(leverage))]
    taken = [used * np.isfinite(residual[:, part]).sum() for used, part in zip(leverage, parts, strict=True)]
    for part, some in zip(parts, taken, strict=True):
        rows = quiet & np.isfinite(residual[:, part]).any(axis=1)
        if rows.any():
            fitted, inside = (each * some / max(sum(taken), 1e-300) for each in carried)
            ratio[part], *_ = Repeats.ratio_of(residual[np.ix_(rows, part)], found.group[rows], fitted, inside)
    return Repeats(found.group, ratio)


def robust_sigma(residual: Array, leverage: Array, robust: bool, found: Readings) -> Array:
    """Return the noise (k,) of each group of columns (lengths and rotations, heights and distances) from its residuals.

    `leverage` (g,) is the part of each that the fit has used up.
    """
    sigma, groups = np.ones(residual.shape[1]), found.kind.noise_groups(residual.shape[1])
    usual = found.kind.usual_noises
    for group, used in enumerate(leverage):
        part = groups == group
        r = residual[:, part]
        r = r[np.isfinite(r)]
        if not r.size:
            continue
        spread = max(1.4826 * _median(np.abs(r)), SMALLEST_SIGMA)
        if robust:  # Huber's proposal 2 from the median: efficient on normal noise, bounded on gross errors
            for _ in range(3):
                clipped = np.clip(r / spread, -HUBER, HUBER)
                spread = max(spread * float(np.sqrt(np.mean(clipped**2) / CLIPPED)), SMALLEST_SIGMA)
        else:
            spread = max(float(np.sqrt(np.mean(r**2))), SMALLEST_SIGMA)
        sigma[part] = spread / np.sqrt(max(1 - used, 0.1))
        if usual:
            # a few readings of one kind can be met exactly at the other's cost: what such instruments read guards them
            free = len(r) * max(1 - used, 0.1)
            known = USUAL_COUNTS * usual[group] ** 2
            sigma[part] = np.sqrt((free * sigma[part] ** 2 + known) / (free + USUAL_COUNTS))
    return sigma


def _median(values: Array) -> float:
    """Return the median of finite values (n,); NumPy's own would first load masked arrays, a fifth of a first fit."""
    middle = [(len(values) - 1) // 2, len(values) // 2]
    return float(np.partition(values, middle)[middle].mean())


def robust_weights(residual: Array, sigma: Array, drop: Kind | None = None) -> Array:
    """Return Huber's weights (R,); none for gross errors of the kind `drop`, unless they are too many to be errors."""
    size = np.sqrt(np.nanmean((residual / sigma) ** 2, axis=1))
    weights = np.minimum(1.0, HUBER / np.maximum(size, 1e-300))
    if drop is not None:
        largest = np.nanmax(np.abs(residual) / sigma, axis=1)
        gross = largest > GROSS
        if gross.mean() <= (MOST_WRONG if drop.picked else MOST_GROSS) or apart(largest).any():
            weights[gross] = 0.0
    return weights


def apart(size: Array) -> np.ndarray:
    """Return which readings (R,) are gross errors that nothing leads to from the others, of their sizes in deviations.

    A reflector that was knocked, or a beam that another one caught, is off for many rows; what a model does not know
    moves readings by all sizes up to its largest.
    """
    far: np.ndarray = size > GROSS
    few = FEWEST_APART <= far.sum() <= MOST_APART * len(size)
    return far if few and size[far].min() > APART * size[~far].max() else np.zeros(len(size), dtype=bool)


def wrongly_found(residual: Array, found: Readings) -> np.ndarray:
    """Return which readings (R,) are points found wrongly in images: they say nothing of the machine."""
    if not found.kind.picked or not len(residual):
        return np.zeros(len(residual), dtype=bool)
    sigma = robust_sigma(residual, np.zeros(found.kind.noises), True, found)
    wrong: np.ndarray = robust_weights(residual, sigma, found.kind) == 0
    return wrong
