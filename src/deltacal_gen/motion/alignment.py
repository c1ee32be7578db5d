"""Two clocks set against each other: what any kind of readings has in common.

Where they may stand is first looked for over all offsets at which joints and readings overlap: by functions of what the
joints do, of which the readings are made as closely as at no other. From there Gauss-Newton on all unknowns at once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import ClockMismatch, InputError
from deltacal_gen.motion.clocks import OFFSET, RATE, Clock, Clocked
from deltacal_gen.results.result import Parameter, Status

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

MOST_LAGS = 20000  # offsets that are looked at
GRID = 0.02  # s between offsets that are looked at first: a tenth of the quickest swing of a large machine
LOOKED_AT, IN_ALL = 400, 1000  # readings of a run, and of all runs, at most, by which offsets are looked at
ABOUT = 0.25  # s by which an offset that is said may be off
OVERLAP = 0.5  # of the readings that an offset may leave with joints, at least, of the most that any leaves
ROUNDS = 20
SETTLED = 0.02  # standard deviations that the last step may still move a clock by
LEAST_KNOWN = 0.02  # s of standard deviation of an offset: less well known it is not known


@dataclass(frozen=True, eq=False)
class Alignment:
    """How the instrument's clock stands, and how surely.

    Attributes
    ----------
    clock : Clock
    offset_std : (R,) array
        [s]
    rate_std : float or None
        None where the rate is said to be the same.
    """

    clocks: Clocked
    clock: Clock
    offset_std: Array
    rate_std: float | None

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Offsets and rate as answers give them."""
        runs = [None] if self.clocks.shared else list(self.clocks.run_names)
        found = [
            _parameter(OFFSET, float(self.clock.offsets[k]), float(self.offset_std[k]), "s", run)
            for k, run in enumerate(runs)
        ]
        if self.rate_std is not None:
            found.append(_parameter(RATE, self.clock.rate, self.rate_std, "1", None))
        return tuple(found)

    def moved_since(self, other: Alignment) -> float:
        """Return by how many standard deviations a clock stands elsewhere than it was said to, at most."""
        off = np.abs(self.clock.offsets - other.clock.offsets) / self.offset_std
        rate = abs(self.clock.rate - other.clock.rate) / self.rate_std if self.rate_std else 0.0
        return float(max(off.max(), rate))


def _parameter(name: str, value: float, std: float, unit: str, run: str | None) -> Parameter:
    alike = ("latency: readings that come late do what a clock does that stands off",) if name == OFFSET else None
    return Parameter(
        name=name, value=value, std=std, unit=unit, status=Status.IDENTIFIED, run=run, indistinguishable_from=alike
    )


def refused(given: Clocked, problem: str, remedy: str) -> InputError:
    """Return the error of clocks that readings do not tell."""
    return ClockMismatch(f"joints and readings cannot be aligned in time: {problem}.", remedy, file=given.path)


def settled(given: Clocked, clock: Clock, step: Callable[[Clock], tuple[Array, Array]], *, beside: str) -> Alignment:
    """Return where the clocks stand by steps from where they stand about.

    Parameters
    ----------
    step : callable
        What the readings move a clock by, offsets (one where all runs share it) and then rate, and the standard
        deviations of these.
    beside : str
        What is found with them, in words.

    Raises
    ------
    InputError
        The clocks cannot be set by these readings; the message says why.
    """
    count = 1 if given.shared else len(clock.offsets)
    for _ in range(ROUNDS):
        by, std = step(clock)
        offsets = np.broadcast_to(by[:count], clock.offsets.shape)
        clock = Clock(clock.offsets + offsets, clock.rate + (float(by[count]) if given.rated else 0.0))
        if (np.abs(by) < SETTLED * std).all():
            break
    else:
        raise refused(given, "the offset of the clocks does not settle", "Record a movement with sharper turns.")
    loose = std[:count] > LEAST_KNOWN
    if loose.any():
        run = "" if given.shared else f" of run '{given.run_names[int(np.argmax(loose))]}'"
        raise refused(
            given,
            f"the movement{run} does not tell its clock: the offset is known to {std[:count].max():.2g} s only, since "
            f"{beside} can do the same",
            "Let the joints change their speeds and turn back.",
        )
    return Alignment(
        given, clock, np.broadcast_to(std[:count], clock.offsets.shape), float(std[count]) if given.rated else None
    )


@dataclass(frozen=True, eq=False)
class Made:
    """Readings, and of what functions they are made.

    Attributes
    ----------
    readings : (N, k) array
        One by one of a recording's readings; nan where nothing was read.
    tables : sequence of (int, (M,) array, (M, b) array)
        Of each movement its run, times [s] and the functions then.
    """

    readings: Array
    tables: Sequence[tuple[int, Array, Array]]


@dataclass(frozen=True)
class Bar:
    """What an offset must do, to be the one.

    Attributes
    ----------
    follows : float
        Part of the readings' variance that the functions must make at the best one.
    as_good : float
        Times what the best one leaves: another one that leaves less cannot be told from it.
    exact : float
        Part of the variance that counts as nothing.
    """

    follows: float
    as_good: float
    exact: float = 0.0


def first(given: Clocked, made_of: Callable[[Sequence[int]], Sequence[Made]], bar: Bar) -> Clock:
    """Return where the clocks stand about, by an offset of every run, or one of all.

    Where a movement repeats itself, the sidecar may say which of its repetitions it is.

    Parameters
    ----------
    made_of : callable
        The readings of some runs, and what they are made of.
    bar : Bar

    Raises
    ------
    InputError
        No offset is good, or two are.
    """
    groups = [list(range(len(given.run_names)))] if given.shared else [[k] for k in range(len(given.run_names))]
    offsets = np.zeros(len(given.run_names))
    for runs in groups:
        offsets[runs] = _best(given, runs, made_of(runs), bar)
    return Clock(offsets)


def _best(given: Clocked, runs: Sequence[int], groups: Sequence[Made], bar: Bar) -> float:
    """Return the offset [s] at which some runs' readings are best made of their functions."""
    read = np.any([np.isfinite(g.readings).any(axis=1) for g in groups], axis=0) if groups else np.False_
    own = np.flatnonzero(np.isin(given.run, runs) & read)
    most = min(LOOKED_AT * len(runs), IN_ALL)
    own = own[np.unique(np.linspace(0, len(own) - 1, most).astype(int))] if len(own) else own
    tables = [table for g in groups for table in g.tables]
    if not tables or not len(own):
        raise refused(given, "no joints, or no readings, of a run", "Record both.")
    time, run = given.time[own], given.run[own]
    each_of = [(_whole(g.readings[own]), g.tables) for g in groups]
    low = min(t[0] - time[run == r].max() for r, t, _ in tables if (run == r).any())
    high = max(t[-1] - time[run == r].min() for r, t, _ in tables if (run == r).any())
    lags = np.linspace(low, high, min(MOST_LAGS, max(3, round((high - low) / GRID))))
    left_by = [[_left(lag, time, run, Y, of) for lag in lags] for Y, of in each_of]
    each = np.hstack([[rest for rest, _ in some] for some in left_by])
    count = np.min([[n for _, n in some] for some in left_by], axis=0)
    each[count < OVERLAP * count.max()] = np.inf
    followed = each.min(axis=0) < 1.0 - bar.follows  # a platform that does not turn tells no time by its turns
    if not followed.any():
        raise refused(
            given,
            "the readings follow the joints at no offset",
            "Check that both files are of the same movement, and that the robot file is of this machine.",
        )
    left = each[:, followed].mean(axis=1)
    best = int(np.argmin(left))

    def between(lag: float) -> float:
        each = np.concatenate([_left(lag, time, run, Y, of)[0] for Y, of in each_of])
        return float(each[followed].mean())

    least, lag = _lowest(between, lags, best)
    if (other := _other_valley(left, best)) is not None:
        rival, elsewhere = _lowest(between, lags, other)
        alike = rival < bar.as_good * max(least, bar.exact)
        if alike and given.offset is not None:
            near = np.where(np.abs(lags - given.offset) < ABOUT, left, np.inf)
            return _lowest(between, lags, int(np.argmin(near)))[1]
        if alike:
            raise refused(
                given,
                f"offsets of {lag:.3f} s and {elsewhere:.3f} s do as well, since the movement repeats itself",
                "Begin the movement with something that does not come again, or say clock_offset_s.",
            )
    return lag


def _whole(Y: Array) -> Array:
    """Return the columns of readings (M, k) that are whole, or the first where none is."""
    whole = np.isfinite(Y).all(axis=0)
    return Y[:, whole] if whole.any() else Y[:, :1]


def _lowest(left: Callable[[float], float], lags: Array, k: int) -> tuple[float, float]:
    """Return the least of what offsets about one of those looked at leave, and that offset."""
    from scipy.optimize import minimize_scalar

    step = lags[1] - lags[0]
    found = minimize_scalar(left, bounds=(lags[k] - step, lags[k] + step), method="bounded")
    return float(found.fun), float(found.x)


def _other_valley(left: Array, best: int) -> int | None:
    """Return the best offset (index) beyond the slopes about the best one; None where there is none."""
    first = last = best
    while first > 0 and left[first - 1] >= left[first]:
        first -= 1
    while last < len(left) - 1 and left[last + 1] >= left[last]:
        last += 1
    outside = np.concatenate([np.arange(first), np.arange(last + 1, len(left))])
    return int(outside[np.argmin(left[outside])]) if len(outside) else None


def _left(
    lag: float, time: Array, run: np.ndarray, Y: Array, tables: Sequence[tuple[int, Array, Array]]
) -> tuple[Array, int]:
    """Return which part of the variance of each reading (k,) an offset leaves, and of how many rows."""
    rows, basis = [], []
    for r, times, columns in tables:
        when = time + lag
        inside = np.flatnonzero((run == r) & (when >= times[0]) & (when <= times[-1]) & np.isfinite(Y).all(axis=1))
        rows.append(inside)
        at = np.clip(np.searchsorted(times, when[inside]), 1, len(times) - 1)
        part = ((when[inside] - times[at - 1]) / (times[at] - times[at - 1]))[:, None]
        basis.append((1 - part) * columns[at - 1] + part * columns[at])
    own, B = np.concatenate(rows), np.concatenate(basis)
    if len(own) < 3 * B.shape[1]:
        return np.full(Y.shape[1], np.inf), len(own)
    y = Y[own] - Y[own].mean(axis=0)
    G = B.T @ B
    G[np.diag_indices_from(G)] *= 1 + 1e-9
    b = B.T @ y
    rest = np.sum(y**2, axis=0) - np.sum(b * np.linalg.solve(G, b), axis=0)
    return np.asarray(rest / np.maximum(np.sum(y**2, axis=0), 1e-300)), len(own)
