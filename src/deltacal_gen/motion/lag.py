"""Readings of a drive that come late: the delay against its joints, found beside the rungs of its ladder."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np

from deltacal_gen.motion.fit import Fit, Lag, climbed
from deltacal_gen.motion.joint import USUAL, Joint
from deltacal_gen.motion.ladder import BUYS, PER_COEFFICIENT
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.regression import BETWEEN

LATENCY = "latency"  # as the vocabulary calls it
LONGEST = 0.25  # s
ROUNDS = 16
STRIDE = 0.02  # s: farthest that one round may go, or four samples where these are farther apart
PROMISING = 0.5  # of what a rung must buy: a first step that promises less is the last
LEAST_FOLDS = 3  # by one of two alone a delay looks like a term that lacks, and bodies make up for the rest
CLIMBS, NEAR = 3, 0.5  # of the ladder with a delay, until that is beside its rungs so many deviations away
SETTLED = 0.1  # standard deviations that a last step may move


def with_lag(fit: Fit) -> Fit:
    """Return a joint's ladder with the delay of its readings, where that is worth it; the ladder is climbed again.

    Dry friction that comes late looks like friction that builds up over a way, beside which no small delay buys a
    thing, and where all comes late nothing may be chosen at all: beside usual friction it is looked for once more, and
    must then buy more than the rungs that had been taken.
    """
    found = _late(fit, fit.rungs)
    if found is not None:
        return found
    if fit.rungs and not any("travels" in rung.kernels.SEARCHED for rung in fit.rungs):
        return fit
    found = _late(fit, [Rung(name) for name in USUAL])
    return fit if found is None or _size(found) > (1.0 - BUYS) * _size(fit) else found


def _late(fit: Fit, rungs: Sequence[Rung]) -> Fit | None:
    """Return the ladder with a delay that is found beside some rungs; None where it is worth nothing."""
    again, found = fit, _lag(fit.joint, rungs, fit.load)
    for _ in range(CLIMBS):  # beside other rungs it is another delay, and at another delay these are other rungs
        if found is None or not _worth(found):
            return None
        again = climbed(fit.joint.series.at(found.delay))
        found = _lag(again.joint, again.rungs, again.load)
        if found is not None and abs(found.delay - again.joint.delay) < NEAR * found.std:
            break
    if found is None or not _worth(found) or not _foretold(again.joint, again.rungs, again.load):
        return None
    return dataclasses.replace(again, lag=dataclasses.replace(found, delay=again.joint.delay))


def _foretold(joint: Joint, rungs: Sequence[Rung], load: np.ndarray) -> bool:
    """Tell whether the delays that other folds find take enough of the folds away: short movements have many.

    Of a fold of whose others no delay comes, nothing is taken away.
    """
    if len(np.unique(joint.fold[joint.fold != BETWEEN])) < LEAST_FOLDS:
        return False
    plain = joint.series.at(0.0)
    before, after = np.full(len(joint.used), np.nan), np.full(len(joint.used), np.nan)
    for fold in np.unique(joint.held[joint.held != BETWEEN]):
        others = [f for f in np.unique(joint.fold[joint.fold != BETWEEN]) if f != fold]
        lag = _lag(joint, rungs, load, others)  # from the delay of all on: it ends where that of these is
        for at, out in ((plain, before), (plain if lag is None else joint.series.at(lag.delay), after)):
            own = at.rows[at.held == fold]
            out[own] = _apart(at, rungs, others)[at.held == fold]
    both = np.isfinite(before) & np.isfinite(after)
    return float(np.sum(after[both] ** 2)) < (1.0 - BUYS) ** 2 * float(np.sum(before[both] ** 2))


def _apart(joint: Joint, rungs: Sequence[Rung], folds: Sequence[int]) -> np.ndarray:
    """Return what a fit to some folds leaves of all samples (M,)."""
    X = _columns(joint, rungs)
    bench, every = joint.bench(X), range(X.shape[1])
    return bench.with_ridge(every, folds).left(X, joint.y, every, folds)


def _size(fit: Fit) -> float:
    return float(np.sqrt(np.nanmean(fit.held_out**2)))


def _worth(lag: Lag) -> bool:
    return lag.bought >= BUYS and lag.gain > PER_COEFFICIENT


def _lag(joint: Joint, rungs: Sequence[Rung], load: np.ndarray, folds: Sequence[int] | None = None) -> Lag | None:
    """Return the delay that leaves least of some folds, or all samples, beside some rungs; None where it settles not.

    By Gauss-Newton.
    """
    series, delay = joint.series, joint.delay
    for _ in range(ROUNDS):
        here = series.at(delay)
        sides = series.at(delay + here.step), series.at(delay - here.step)
        if not all(_tells(at, folds) for at in (here, *sides)):
            return None
        X, (per_second, of_known) = _columns(here, rungs), _by_delay(here, sides, rungs)
        bench = here.bench(X)
        every = range(X.shape[1])
        bench = bench.with_ridge(every)
        rows = range(len(bench.n)) if folds is None else folds
        fitted = bench.fit(every, rows) / bench.scale
        whole = np.column_stack([X, per_second @ fitted + of_known])
        moved = here.bench(whole)
        moved = dataclasses.replace(moved, ridge=bench.ridge)
        each = range(whole.shape[1])
        solution = moved.fit(each, rows) / moved.scale
        left = here.y - whole @ solution
        if delay == 0 and np.std(left) > (1.0 - PROMISING * BUYS) * np.std(here.y - X @ fitted):
            return None
        together = here.correlated(left)
        variance = float(left @ left) / max(len(left) - len(solution) * together, 1.0)
        std = float(np.sqrt(moved.covariance(each)[-1, -1] * variance * together) / moved.scale[-1])
        step = float(solution[-1])
        stride = max(STRIDE, 4 * here.step)
        delay += float(np.clip(step, -stride, stride))
        if not abs(delay) < LONGEST:
            return None
        if abs(step) < SETTLED * std:
            return _told(joint, rungs, delay, std, together)
    return None


def _told(joint: Joint, rungs: Sequence[Rung], delay: float, std: float, together: float) -> Lag | None:
    """Return a delay with what it takes away of held-out samples, and of the chi2 of all."""
    late, now = joint.series.at(delay), joint.series.at(0.0)
    if not _tells(late):
        return None
    held, left = [], []
    for at in (now, late):
        X = _columns(at, rungs)
        bench = at.bench(X)
        every, folds = range(X.shape[1]), bench.folds
        held.append(bench.held_out(every, folds))
        left.append(bench.train(every, folds) / float(bench.n[list(folds)].sum()))
    gain = len(late.y) / together * float(np.log(left[0] / left[1]))
    return Lag(delay, std, 1.0 - float(np.sqrt(held[1] / held[0])), gain)


def _tells(joint: Joint, folds: Sequence[int] | None = None) -> bool:
    """Tell whether a delay leaves samples enough, in each of some folds: each run loses some at its beginning."""
    return joint.moves and set(folds or ()) <= set(joint.fold.tolist())


def _columns(joint: Joint, rungs: Sequence[Rung]) -> np.ndarray:
    return joint.columns(rungs, joint.load_by(None))


def _by_delay(joint: Joint, sides: Sequence[Joint], rungs: Sequence[Rung]) -> tuple[np.ndarray, np.ndarray]:
    """Return the derivatives of the columns (M, p), and of what is known (M,), by the delay: central differences.

    `sides` are the joint a sample later and earlier.
    """
    values = []
    for other in sides:
        columns = np.column_stack([_columns(other, rungs), other.carried])
        whole = np.full((len(joint.used), columns.shape[1]), np.nan)
        whole[other.rows] = columns
        values.append(whole[joint.rows])
    found = np.nan_to_num((values[0] - values[1]) / (2 * joint.step))
    return found[:, :-1], found[:, -1]
