"""How the noise of rows hangs together, as what a fit leaves tells."""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.estimation.fit import Fit
from deltacal_gen.estimation.residuals import GROSS, HUBER, Repeats
from deltacal_gen.estimation.series import Series, Taken
from deltacal_gen.machine.registry import Array

PROVEN = 10.0  # of the deviance, that noise which hangs together must explain
MANY = 40  # scalars for each that is fitted: beyond, what the fit took of the noise makes no difference


def together(at: Fit) -> Repeats | None:
    """Return noise that hangs together from row to row, where what a fit leaves looks like it; None where not.

    Physics that was left out hangs together too, where neighbouring rows are neighbouring poses or times: which of the
    two it is, a comparison of both tells.
    """
    series = Series.of(at.problem.readings)
    if series is None or len(series.order) < 2:
        return None
    z, taken = _rows(at, at.residual), _taken(at, len(at.problem.scale))
    found, deviance = series.likeliest(z, taken)
    if series.deviance(z, taken) - deviance < PROVEN:
        return None
    return dataclasses.replace(at.repeats, series=found)


def deviance_of(at: Fit) -> float:
    """Return twice the negative logarithm of the likelihood of a fit's readings, but for a constant.

    The noise is the one that suits best what it leaves: one that leaves white noise needs none that hangs together.
    Geometry and instrument are taken out whatever the effects: the likelihood is that of the same contrasts for all.
    Noise that hangs together pays what proves it, beside an effect or instead of it.
    """
    series = Series.of(at.problem.readings)
    assert series is not None  # otherwise nothing is compared
    z, taken = _rows(at, at.residual), _taken(at, len(at.problem.names))
    found = min(series.deviance(z, taken), series.likeliest(z, taken)[1] + PROVEN)
    return found + 2 * float((np.log(at.sigma) * np.isfinite(at.residual).sum(axis=0)).sum())


def _taken(at: Fit, count: int) -> Taken | None:
    """Return what the first parameters of a fit, and the instrument's unknowns, took out of the readings.

    None where that makes no difference.
    """
    problem = at.problem
    if problem.readings.n_scalars > MANY * (at.solution.degrees + at.instrument.n_unknown):
        return None
    state = problem.linearise(at.errors, at.instrument, at.machine)
    own = problem.columns[:count]
    departure = (at.errors[own] - problem.reference[own]) / problem.scale[:count]
    return Taken(_rows(at, (state.J_p * problem.scale)[..., :count]), -departure, _rows(at, state.J_m))


def _rows(at: Fit, values: Array) -> Array:
    """Return values (R, k, ...) in units of the noise, what repeats share taken off.

    Gross errors count as little as the fit lets them, all others fully: what one fit thinks less of is no likelihood.
    """
    read = np.isfinite(at.residual).any(axis=0)
    ratio = np.broadcast_to(at.repeats.ratio, read.shape)[read]
    weights = np.where(at.weights < HUBER / GROSS, at.weights, 1.0)
    w = np.sqrt(weights)[:, None] / at.sigma[read] * np.sqrt(1 + ratio)
    each = np.where(np.isfinite(at.residual).reshape(*at.residual.shape, *[1] * (values.ndim - 2)), values, 0.0)
    return Repeats(at.repeats.group, ratio).whiten(
        each[:, read] * w.reshape(*w.shape, *[1] * (values.ndim - 2)), weights
    )
