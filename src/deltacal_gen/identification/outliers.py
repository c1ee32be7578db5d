"""Readings that are none, or of no pose that they stand beside: they are left out, or the recording is refused.

A few outliers are left to their robust weights. Those that are left out here are beyond them: out of all proportion,
too many and too far, or of so few poses that they pull the machine along.
"""

from __future__ import annotations

import numpy as np

from deltacal_gen.errors import ContradictingRows
from deltacal_gen.estimation.fit import FEW, fit, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import unsaid
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import HUBER, MOST_APART, MOST_GROSS, apart, lengths, rms
from deltacal_gen.estimation.series import sequence
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import robot_size
from deltacal_gen.identification.mistakes import EXPLAINED, IMPLAUSIBLE, MOST_FITTED, attempt, sizes
from deltacal_gen.instrument.kinds import readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.proportion import LONGEST_SPIKE, out_of_proportion

MOST_TRIED = 30  # poses: of more, what one says is little enough to be left to its weight
MOST_SWAPPED = 0.2  # of the readings
FITS, FITS_NOT = 6.0, 60.0  # times what is left in the median: a swapped reading fits the other pose, and not its own


def without_overflow(problem: Problem, first: Fit) -> Problem | None:
    """Return the problem without readings that are out of all proportion by a fit to some or all; None if none are.

    However little they count, so far off they widen the noise of all others, which then seems to hang together. More of
    them in a row may be something else: a slip, or a reflector that was knocked.
    """
    found = problem.readings
    if found.kind.picked or found.made or len(found) < 2:
        return None
    off = np.nanmax(np.abs(lengths(_left_by(first, problem), found.kind)), axis=1)
    far = out_of_proportion(off, np.full(len(off), robot_size(problem.robot)), 0.0)
    alone = far.any() and _runs(far, problem)[0].max() <= LONGEST_SPIKE
    return problem.subset(np.flatnonzero(~far)) if alone else None


def without_knocked(problem: Problem, first: Fit) -> Problem | None:
    """Return the problem without gross errors in runs, with the others again before and behind: no model's; else None.

    So many pull a fit towards them, that they do not stand out of it: what a fit of the others alone leaves of them
    tells. What reaches the begin or the end of a set-up may be a slip, which has a name. `first` is fitted to some
    readings or all.
    """
    some = first.problem
    suspect = _deviations(first.residual, first) > HUBER
    if some.readings.kind.picked or not MOST_GROSS < suspect.mean() <= MOST_APART:
        return None
    rest, begin = some.subset(np.flatnonzero(~suspect)), first.instrument
    how = {"weigh_repeats": False, "must_converge": False}
    if (others := attempt(fit, rest, Prior(), errors=first.errors, instrument=begin, **how)) is None:
        return None
    far = apart(_deviations(_left_by(others, problem), others))
    length, at_end = _runs(far, problem)
    for_a_while = (length > 1).mean() > MOST_GROSS >= (length == 1).mean() and not at_end.any()
    return problem.subset(np.flatnonzero(~far)) if for_a_while else None


def begun(problem: Problem, robust: bool = True) -> tuple[Problem, Fit]:
    """Return a rough fit, and the problem: without a pose that is of none of the others, where these are few.

    It need not have converged: `checks.plausible` says why.
    """
    first = rough(problem, robust, must_converge=False)
    if not robust or (rest := _all_but_one(first)) is None:
        return problem, first
    problem = problem.subset(rest)
    return problem, rough(problem, must_converge=False)


def _all_but_one(first: Fit) -> np.ndarray | None:
    """Return which readings are left where those of one pose alone are not of this machine; None where there is none.

    Where poses are few, one with the joints or cells of another pulls the machine so far that it does not stand out of
    what is left, whatever it weighs. It is among those that are farthest off the machine as drawn, and shows in what a
    fit of all others leaves.
    """
    problem, found = first.problem, first.problem.readings
    if not found.kind.positions or not 1 < len(np.unique(found.group)) <= MOST_TRIED:
        return None
    most, before = IMPLAUSIBLE * robot_size(problem.robot), sizes(first.residual, problem)
    others = found.group != found.group[np.argmax(before)]
    if rms(before[others]) < most and np.mean(~others) <= MOST_GROSS:
        return None  # its weight makes next to nothing of it
    models = problem.mechanism.models
    drawn = problem.with_names(unsaid(problem.with_names(max(models.values(), key=len))))
    far = sizes(fit(drawn, Prior(), weigh_repeats=False, must_converge=False).residual, problem)
    for pose in list(dict.fromkeys(found.group[np.argsort(-far)].tolist()))[:MOST_FITTED]:
        rest = np.flatnonzero(found.group != pose)
        without = attempt(rough, problem.subset(rest), must_converge=False)
        if without and rms(sizes(without.residual, without.problem)) < min(most, EXPLAINED * rms(before)):
            return rest
    return None


def check_rows(first: Fit) -> None:
    """Refuse rows whose measured cells stand against the joints of another row.

    Two readings that are gross errors, and each of which fits the pose of the other, were swapped.
    """
    problem, found, suspects = first.problem, first.problem.readings, first.gross
    if not found.kind.positions or not 2 <= len(suspects) <= max(2, MOST_SWAPPED * len(found)):
        return
    predicted = found.values - first.residual[:, :3]
    usual = float(np.median(sizes(first.residual, problem))) + 1e-9
    gap = np.linalg.norm(np.nan_to_num(found.values[suspects][:, None] - predicted[suspects][None]), axis=2)
    own, fits = np.diag(gap), gap < FITS * usual
    swapped = fits & fits.T & (np.minimum(own[:, None], own) > FITS_NOT * usual)
    if swapped.any():
        i, j = np.argwhere(swapped)[0]
        a, b = sorted(int(found.line[suspects[k]]) for k in (i, j))
        raise ContradictingRows(
            f"the readings of lines {a} and {b} are swapped: each fits the joints of the other to "
            f"{max(gap[i, j], gap[j, i]):.3g} mm and its own only to {min(own[i], own[j]):.3g} mm.",
            "Exchange the measured cells of the two lines.",
            file=problem.recording.path,
            line=a,
        )


def gross_lines(at: Fit) -> tuple[int, ...]:
    """Return the lines of gross errors, those among them that a fit was made without."""
    found = at.problem.readings
    return tuple(sorted({*_lines_left_out(at.problem), *found.line[at.gross].tolist()}))


def left_out(of: Problem) -> tuple[str, ...]:
    """Return that readings of the recording are none of a problem's, and which."""
    if not (lines := _lines_left_out(of)):
        return ()
    named = ", ".join(map(str, lines[:FEW])) + (" ..." if len(lines) > FEW else "")
    return (
        f"{len(lines)} readings are far beyond all others together and were left out (lines {named}): an "
        "overflow, a reflector that was knocked or lost for a while, another one that was caught, or joints of another "
        "pose. Measure these poses again.",
    )


def _lines_left_out(of: Problem) -> list[int]:
    if of.readings.made:
        return []
    whole, kept = (
        set(zip(r.line.tolist(), r.setup.tolist(), strict=True)) for r in (readings(of.recording), of.readings)
    )
    return sorted({line for line, _ in whole - kept})  # of a line one encoder may be left out, and not the others


def _left_by(at: Fit, problem: Problem) -> Array:
    """Return the residuals (R, k) of readings of a problem by a fit to some of them or all."""
    return problem.residual(at.errors, at.instrument, problem.poses(at.errors))


def _deviations(residual: Array, at: Fit) -> Array:
    """Return how many standard deviations of a fit the largest component of each reading (R,) is off."""
    size: Array = np.nanmax(np.abs(residual) / at.sigma, axis=1)
    return size


def _runs(far: np.ndarray, problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    """Return the length of the run of far readings that each (R,) is in, else 0; and which are ends of a set-up."""
    found = problem.readings
    order = np.lexsort((sequence(found, problem.recording), found.setup))
    off, setup = far[order], found.setup[order]
    begins = np.append(True, setup[1:] != setup[:-1])
    run = np.cumsum(begins | np.append(True, off[1:] != off[:-1]))
    return np.bincount(run)[run] * off, off & (begins | np.append(begins[1:], True))
