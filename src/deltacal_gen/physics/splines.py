"""Series in time as splines, movement by movement: a low-pass without delay, with exact derivatives.

Series are fitted by splines of fifth degree, least squares over evenly spaced knots: samples are taken as they come,
even or not. How far apart the knots stand is told by the series alone: where knots closer together change the
derivatives by no more than its noise does.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from scipy.interpolate import BSpline

    from deltacal_gen.machine.registry import Array

DEGREE = 5
FINEST = 4.0  # samples between two knots, at least
COARSEST = 1.0  # s between them, at most
LOOSE = 2.0  # knots: nearer to an end, the noise of an acceleration is up to fifty times that in the middle
KEPT = 0.5  # of the recorded time: knots of which the loose ends leave less are too far apart
SHIFTS = 0.0, 0.5  # of the spacing, of the knots of splines whose mean is taken
RATIO = 2**0.5  # between spacings that are looked at
LEAST = 2 * (DEGREE + 1)  # samples of a piece
FAR = 6.0  # standard deviations of a speed from samples alone: what it differs by more is no noise
PART = 0.1  # of the highest speed: and a turn that a low-pass cuts
ALIKE = 0.5  # of the greater: what the speeds before and behind a sample must differ by, for a turn and no late sample
CALM, OF_ALL = 0.9, 0.79  # quantile of misfits below which no turn is cut, and their rms of that of all, of white noise
HIGHEST = 0.99  # quantile of speeds that is meant by highest
AS_MUCH = 0.1  # of the motion of the series that moves most
WINDOW = 40  # knots over which the noise of derivatives is computed
GAP = 4.5  # times the ordinary interval: what lies on both sides is not one movement


@dataclass(frozen=True, eq=False)
class Samples:
    """Series (N, k) sampled at times (N,) [s], and which samples are one movement without a gap (N,), from 0."""

    values: Array
    time: Array
    piece: np.ndarray

    @property
    def step(self) -> float:
        """Ordinary interval between two samples [s]."""
        return ordinary_step(self.time, self.piece)

    @property
    def pieces(self) -> list[np.ndarray]:
        """Rows of each movement."""
        return np.split(np.arange(len(self.piece)), np.flatnonzero(np.diff(self.piece)) + 1)


@dataclass(frozen=True, eq=False)
class Path:
    """One movement as the mean of splines, from its first sample to its last [s]."""

    start: float
    end: float
    splines: tuple[BSpline, ...]

    def covers(self, time: Array) -> np.ndarray:
        """Tell which times lie within the movement."""
        return np.asarray((time >= self.start) & (time <= self.end))

    def __call__(self, time: Array, order: int = 0) -> Array:
        """Return the series, or a derivative of it, at times (M,): (M, k)."""
        return np.mean([each(time, nu=order) for each in self.splines], axis=0)


def ordinary_step(time: Array, piece: np.ndarray) -> float:
    """Return the median interval [s] between samples of one movement."""
    steps = np.diff(time)[np.diff(piece) == 0]
    return float(np.median(steps)) if len(steps) else 1.0


def pieces_of(time: Array, run: np.ndarray) -> np.ndarray:
    """Return which samples belong to one movement without a gap (N,), counted over all runs."""
    same = np.diff(run) == 0
    steps = np.diff(time)
    ordinary = float(np.median(steps[same])) if same.any() else np.inf
    return np.concatenate([[0], np.cumsum(~same | (steps > GAP * ordinary))])


def paths(given: Samples, spacing: float) -> list[Path | None]:
    """Return each movement as splines with knots `spacing` [s] apart; None of one that is too short.

    How well a spline meets a quick turn depends on where its knots happen to lie: it is the mean of two, the knots of
    one halfway between those of the other (cycle spinning: Coifman, Donoho 1995).
    """
    found: list[Path | None] = []
    for own in given.pieces:
        time, values = given.time[own], given.values[own]
        enough = len(own) >= LEAST
        each = (_fit(time, values, spacing, shift) for shift in SHIFTS)
        found.append(Path(time[0], time[-1], tuple(each)) if enough else None)
    return found


def smooth(given: Samples, spacing: float, orders: int) -> Array:
    """Return the series through the low-pass and their derivatives, (1 + orders, N, k); nan in pieces too short."""
    out = np.full((1 + orders, *given.values.shape), np.nan)
    for own, path in zip(given.pieces, paths(given, spacing), strict=True):
        if path is not None:
            for order in range(1 + orders):
                out[order, own] = path(given.time[own], order)
    return out


def _fit(time: Array, values: Array, spacing: float, shift: float) -> BSpline:
    """Return the spline of one piece, its knots as near to a spacing [s] as the piece allows, `shift` of it later."""
    from scipy.interpolate import make_lsq_spline  # what stands still does without

    parts = int(max(1, min(round((time[-1] - time[0]) / spacing), (len(time) - DEGREE - 1) // 2)))
    places = (np.arange(1, parts - (shift > 0)) + shift) / parts  # no interval at an end is shorter than others
    inner = time[0] + places * (time[-1] - time[0])
    counts = np.histogram(time, [time[0], *inner, time[-1]])[0]
    if (counts == 0).any():  # samples so uneven that an interval holds none
        inner = np.quantile(time, places)
    knots = np.concatenate([[time[0]] * (DEGREE + 1), inner, [time[-1]] * (DEGREE + 1)])
    return make_lsq_spline(time, values, knots, DEGREE)


def chosen_spacing(given: Samples, order: int, units: Sequence[str]) -> float:
    """Return the spacing of the knots [s] that leaves the least error of a derivative.

    Its error is noise, which falls with the spacing, and what knots closer together show beyond their own noise
    (Goldenshluger, Lepski 2011). Series count that move as much as others of their unit do.
    """
    finest = FINEST * given.step
    count = 2 + int(np.log(max(COARSEST / finest, RATIO)) / np.log(RATIO))
    spacings = finest * RATIO ** np.arange(count)
    spacings = spacings[: max(2, int((_kept(given, spacings) >= KEPT).sum()))]
    within = inside(given, min(COARSEST / 2, LOOSE * spacings[-1]))
    derivatives = [smooth(given, h, order)[:, within] for h in spacings]
    base = given.values[within]
    sigma = noise(base, derivatives[0][0], given.step, finest)
    counted = moving(base, units)
    of_noise = [np.outer(unit_noise(given.step, h, order), sigma)[0] ** 2 for h in spacings]
    apart = np.nanmean((derivatives[0][-1] - derivatives[1][-1]) ** 2, axis=0)
    # no motion is taken for so quick: it is noise, not white
    coloured = np.maximum(1.0, apart / np.maximum(of_noise[0] - of_noise[1], 1e-300))
    of_noise = [coloured * each for each in of_noise]
    whole = np.nanmean(derivatives[0][-1] ** 2, axis=0) - of_noise[0]
    whole = np.maximum(whole, 1e-12 + 1e-3 * of_noise[0])
    risks = []
    for n, own in enumerate(derivatives):
        beyond = np.zeros_like(whole)
        for finer, of_finer in zip(derivatives[:n], of_noise[:n], strict=True):
            apart = np.nanmean((own[-1] - finer[-1]) ** 2, axis=0)
            beyond = np.maximum(beyond, apart - (of_finer - of_noise[n]))
        risks.append(float(((beyond + of_noise[n]) / whole)[counted].sum()))
    return float(spacings[int(np.argmin(risks))])


def _kept(given: Samples, spacings: np.ndarray) -> Array:
    """Return which part of the recorded time is not loose with knots so far apart [s]."""
    lasts = np.array([given.time[own[-1]] - given.time[own[0]] for own in given.pieces])
    left = np.maximum(lasts - 2 * LOOSE * spacings[:, None], 0.0).sum(axis=1)
    return np.asarray(left / max(lasts.sum(), 1e-300))


def resolves(given: Samples, spacing: float, units: Sequence[str]) -> bool:
    """Tell whether splines with knots `spacing` [s] apart know the series better than the next samples do.

    Each sample is left out: what a spline through all others makes of it, and what the straight line between the sample
    before and the one after does. Splines average noise; a motion that turns within a few samples is cut by them.
    """
    left = given.values - smooth(given, spacing, 0)[0]
    left /= 1.0 - min(given.step / spacing, 0.9)  # as if the spline had not seen the sample
    line = np.full(left.shape, np.nan)
    for own in given.pieces:
        time, values = given.time[own], given.values[own]
        part = ((time[1:-1] - time[:-2]) / (time[2:] - time[:-2]))[:, None]
        line[own[1:-1]] = values[1:-1] - (values[:-2] + part * (values[2:] - values[:-2]))
    counted = moving(given.values, units)
    left, line = (values[:, counted] / np.nanstd(given.values[:, counted], axis=0) for values in (left, line))
    seen = np.isfinite(left) & np.isfinite(line)
    return float((left[seen] ** 2).sum()) <= float((line[seen] ** 2).sum())


def inside(given: Samples, within: float) -> np.ndarray:
    """Tell which samples are not `within` [s] of the ends of their piece, where splines are loose; all if none is."""
    start, end = (np.array([f(given.time[own]) for own in given.pieces])[given.piece] for f in (np.min, np.max))
    found = (given.time - start > within) & (end - given.time > within)
    return found if found.any() else np.ones(len(given.time), dtype=bool)


def cut(given: Samples, fitted: Array, spacing: float, units: Sequence[str]) -> np.ndarray:
    """Tell which samples (N,) lie within `LOOSE` knots of a turn that the low-pass `fitted` (orders, N, k) cuts.

    Its derivatives there are of its own making: a joint that stops from one sample to the next is slow before, and goes
    on behind. Such a turn is seen in speeds from the sample before and to the one after, which are noisy, but of no
    knots. A sample that was read late makes the joint too slow on its one side and too quick on the other: no turn.
    """
    found = np.zeros(len(given.time), dtype=bool)
    counted, highest = moving(given.values, units), np.nanquantile(np.abs(fitted[1]), HIGHEST, axis=0)
    misfit = np.abs(given.values - fitted[0])
    calm = np.where(misfit <= np.nanquantile(misfit, CALM, axis=0), given.values, np.nan)
    noisy = FAR * noise(calm, fitted[0], given.step, spacing) / OF_ALL / (np.sqrt(2.0) * given.step)
    for own in given.pieces:
        time, values, within = given.time[own], given.values[own], own[1:-1]
        speeds = np.diff(values, axis=0) / np.diff(time)[:, None]
        before, behind = speeds[:-1] - fitted[1, within], speeds[1:] - fitted[1, within]
        agreed = before * behind >= ALIKE * np.maximum(before**2, behind**2)
        turns = agreed & (np.abs(before + behind) / 2 > np.maximum(noisy, PART * highest))
        at = given.time[within[turns[:, counted].any(axis=1)]]
        if len(at):
            next_one = np.searchsorted(at, time).clip(max=len(at) - 1)
            away = np.minimum(np.abs(at[next_one] - time), np.abs(at[(next_one - 1).clip(min=0)] - time))
            found[own] = away <= LOOSE * spacing
    return found


def moving(values: Array, units: Sequence[str]) -> np.ndarray:
    """Tell which series move as much as others of their unit do, by `AS_MUCH` at least, (k,)."""
    spread, of = np.nanstd(values, axis=0), np.array(units)
    most = np.array([spread[of == unit].max() for unit in of])
    return np.asarray((spread >= AS_MUCH * most) & (spread > 0))


def noise(values: Array, fitted: Array, step: float, spacing: float) -> Array:
    """Return the noise of single samples (k,), from what a spline of some spacing leaves."""
    own = min(0.9, step / spacing)
    left = max(1.0 - 2 * own + unit_noise(step, spacing, 0) ** 2, 0.1)  # of the square of a sample's own
    return np.asarray(np.sqrt(np.nanmean((values - fitted) ** 2, axis=0) / left))


def unit_noise(step: float, spacing: float, order: int) -> float:
    """Return the noise of a derivative where that of a sample is 1, in the middle of a long piece."""
    from scipy.interpolate import BSpline

    per = max(1, round(spacing / step))
    time = np.arange(WINDOW * per) * step
    middle = time[len(time) // 2 - per // 2 : len(time) // 2 + per // 2 + 1]
    every, taken = [], []  # values of basis functions, and what each of these counts for
    for shift in SHIFTS:
        knots = (np.arange(-DEGREE - 1, WINDOW + DEGREE + 1) + shift) * per * step
        rows = BSpline.design_matrix(time, knots, DEGREE)
        slopes = BSpline(knots, np.eye(rows.shape[1]), DEGREE)(middle, nu=order)
        every.append(rows)
        taken.append(slopes @ np.linalg.pinv((rows.T @ rows).toarray()) / len(SHIFTS))
    pairs = itertools.product(zip(every, taken, strict=True), repeat=2)
    squares = sum(((a @ (A.T @ B).toarray()) * b).sum(axis=1) for (A, a), (B, b) in pairs)
    return float(np.sqrt(np.mean(squares)))


def removed(given: Samples, fitted: Array, units: Sequence[str]) -> float:
    """Return the largest part of a series' signal, rms of its own variation, that the low-pass takes away."""
    lost = np.sqrt(np.nanmean((given.values - fitted) ** 2, axis=0)) / np.maximum(
        np.nanstd(given.values, axis=0), 1e-300
    )
    return float(lost[moving(given.values, units)].max(initial=0.0))


def what_was_done(what: str, spacing: float) -> str:
    """Return in words how derivatives were made of `what`, with knots `spacing` [s] apart."""
    return (
        f"splines of degree {DEGREE} through the {what}, least squares, a knot every {1000 * spacing:.3g} ms: no "
        f"delay, cut-off {0.5 / spacing:.3g} Hz, chosen by the {what} alone"
    )
