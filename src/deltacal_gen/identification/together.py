"""How the noise of rows and directions hangs together, as what a fit leaves tells."""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.estimation.correlated import Correlated, Taken
from deltacal_gen.estimation.directions import price_of, shape_of
from deltacal_gen.estimation.ends import Ends
from deltacal_gen.estimation.fit import fit, held_out
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import GROSS, HUBER, Repeats
from deltacal_gen.estimation.series import Series
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.estimation.system import in_unit_noise
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.sandwich import averaged
from deltacal_gen.machine.registry import Array

PROVEN = 10.0  # of the deviance, that noise which hangs together must explain
PRICE = 15.2  # of it, that such noise pays beside physics: what its two numbers explain by chance once in 2000 times
MANY = 40  # scalars for each that is fitted: beyond, what the fit took of the noise makes no difference


def together(at: Fit) -> Repeats | None:
    """Return noise that hangs together from row to row, or is not alike in all directions, as what a fit leaves is.

    None where it is neither. Physics that was left out looks like it too, where neighbouring rows are neighbouring
    poses or times, and where it moves readings along one axis: which of the two it is, a comparison of both tells.
    """
    if common(at.problem, at) is None or len(at.residual) < 2:
        return None
    found, _ = suited(at, len(at.problem.scale))
    return None if found.plain else found


def common(problem: Problem, at: Fit) -> Correlated | None:
    """Return what readings of a problem may have in common, at a fit to them or others; None where they have nothing.

    Readings of one row follow on others; distances end in points that others end in.
    """
    found, recording = problem.readings, problem.recording
    if found.rows.shape[1] == 1:
        return Series.of(found, recording)
    same = at.problem.body is problem.body
    return Ends.of(found, recording, at.machine.x if same else problem.poses(at.errors))


def without_following(problem: Problem, first: Fit) -> Problem | None:
    """Return the problem without distances that follow from the others, as those of points measured once do; else None.

    They tell nothing that the others do not. `first` is fitted to some readings or all.
    """
    ends = common(problem, first)
    if not isinstance(ends, Ends):
        return None
    same = first.problem is problem
    left = first.residual if same else problem.residual(first.errors, first.instrument, problem.poses(first.errors))
    declared = problem.readings.kind.sigma(problem.recording.measurement, first.instrument.scale)
    noise = float(first.sigma[0]) if declared is None else min(declared, float(first.sigma[0]))
    if (leading := ends.leading(left[:, 0], noise)) is None:
        return None
    kept, lines = problem.readings.subset(leading), problem.recording.pair_line
    assert lines is not None
    kept = dataclasses.replace(kept, following=len(problem.readings) - len(kept))
    return dataclasses.replace(
        problem, readings=kept, recording=problem.recording.subset_pairs(np.isin(lines, kept.line))
    )


def rows_alone(at: Fit, drop_gross: bool = False) -> Fit:
    """Return the same fit with no row telling of another's noise."""
    return fit(
        at.problem,
        Prior(),
        errors=at.errors,
        instrument=at.instrument,
        repeats=dataclasses.replace(at.repeats, series=None),
        drop_gross=drop_gross,
        must_converge=False,
    )


def better_alone(at: Fit) -> Fit | None:
    """Return the fit with rows weighed alone where that predicts held-out readings better; None where it does not.

    What hangs together may be physics that was left out, which no weights of rows make good: readings decide. Those
    that know less than a position are too few to, and mostly lie along a path.
    """
    if not isinstance(at.repeats.series, Series):
        return None
    alone = rows_alone(at, drop_gross=True)
    parts = folds(at.problem.readings, at.problem.recording, rows=at.repeats.rows)
    decides = at.problem.readings.kind.positions
    return None if decides and held_out(at, Prior(), parts) <= held_out(alone, Prior(), parts) else alone


def as_predicts(at: Fit) -> Fit:
    """Return a fit with the machine that predicts held-out readings better; see `better_alone`. The noise stays.

    How surely it is known is asked of all noise models that the readings leave; see `sandwich`.
    """
    if (alone := better_alone(at)) is None:
        return dataclasses.replace(at, covariance=averaged(at))
    found = {name: getattr(alone, name) for name in ("errors", "machine", "instrument", "residual")}
    return dataclasses.replace(at, **found, covariance=averaged(alone))


def deviance_of(at: Fit) -> float:
    """Return the deviance of `suited`."""
    return suited(at)[1]


def suited(at: Fit, count: int | None = None) -> tuple[Repeats, float]:
    """Return the noise that suits what a fit leaves best, and twice the negative logarithm of the likelihood with it.

    But for a constant. The first `count` parameters and the instrument are taken out, by default geometry and
    instrument whatever the effects: the likelihood is that of the same contrasts for all. Noise that is correlated pays
    its price, beside an effect or instead of it; so does one that has directions. An outlier counts as a reading of as
    much more noise as it is off. Where readings have nothing in common, their noise is each one's own.
    """
    z, series = _rows(at, at.residual), common(at.problem, at)
    scales = 2 * float((np.log(at.sigma) * np.isfinite(at.residual).sum(axis=0)).sum())
    if series is None:
        return at.repeats.as_plain(), float((z**2).sum()) + scales
    taken, series = _taken(at, len(at.problem.names) if count is None else count), series.weighted(_weights(at))
    best, cost = _along(at.repeats.as_plain(), series, z, taken)
    shape = _shape(at, z[None] if best.series is None else best.series.weighted(series.weight).ways(z))
    if shape is None:
        return best, cost + scales
    has = dataclasses.replace(best, series=None, shape=shape)
    level = has.levelled
    other, less = _along(has, series, level(z), taken and Taken(level(taken.known), taken.toward, level(taken.free)))
    less += len(z) * float(np.linalg.slogdet(shape)[1]) + price_of(shape)
    return (other, less + scales) if less < cost else (best, cost + scales)


def _along(has: Repeats, series: Correlated, z: Array, taken: Taken | None) -> tuple[Repeats, float]:
    """Return noise as readings have it in common, where that is proven, and the deviance, with its price."""
    alone = series.deviance(z, taken)
    found, deviance = series.likeliest(z, taken)
    if alone - deviance < PROVEN:
        return has, alone
    return dataclasses.replace(has, series=found.weighted(None)), min(deviance + PRICE, alone)


def _shape(at: Fit, z: Array) -> Array | None:
    """Return how noise differs between directions, of lengths and of rotations; None where it does not.

    Rows come (w, R, k), freed of one another in each way in which one may go through them.
    """
    if not np.isfinite(at.residual).all():
        return None
    ways, _, k = z.shape
    groups, shape = at.problem.readings.kind.noise_groups(k), np.eye(k)
    for group in np.unique(groups):
        own = np.flatnonzero(groups == group)
        if (found := shape_of(z[:, :, own].reshape(-1, len(own)), ways)) is not None:
            shape[np.ix_(own, own)] = found
    return None if (shape == np.eye(len(shape))).all() else shape


def _taken(at: Fit, count: int) -> Taken | None:
    """Return what the first parameters of a fit, and the instrument's unknowns, took out of the readings.

    None where that makes no difference, which is so, or not, whatever effects are beside them: deviances of several
    fits are compared.
    """
    problem = at.problem
    several = problem.readings.rows.shape[1] > 1  # many distances may have few points in common
    if not several and problem.readings.n_scalars > MANY * (count + at.instrument.n_unknown):
        return None
    state = problem.linearise(at.errors, at.instrument, at.machine)
    own = problem.columns[:count]
    departure = (at.errors[own] - problem.reference[own]) / problem.scale[:count]
    free = _rows(at, state.J_m)
    seen = free.any(axis=(0, 1))  # a turn that nothing reads takes nothing
    return Taken(_rows(at, (state.J_p * problem.scale)[..., :count]), -departure, free[..., seen])


def _weights(at: Fit) -> Array:
    """Return how much each reading (R,) counts: gross errors as ones of the likeliest noise, all others fully.

    A reading that is off by so many standard deviations most likely has so much noise of its own. What a fit thinks
    less of beside these is no likelihood.
    """
    read = np.isfinite(at.residual).any(axis=0)
    off = np.nanmax(np.abs(at.repeats.off(at.residual))[:, read] / at.sigma[read], axis=1)
    return np.where(at.weights < HUBER / GROSS, np.maximum(off, 1.0) ** -2, 1.0)


def _rows(at: Fit, values: Array) -> Array:
    """Return values (R, k, ...) in units of the noise, what repeats share taken off; see `_weights`."""
    read = np.isfinite(at.residual).any(axis=0)
    repeats = Repeats(at.repeats.group, np.broadcast_to(at.repeats.ratio, read.shape)[read])
    return in_unit_noise(values[:, read], np.isfinite(at.residual)[:, read], at.sigma[read], _weights(at), repeats)
