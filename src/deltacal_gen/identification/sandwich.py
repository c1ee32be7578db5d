"""How surely readings know what was fitted, where nobody knows how their noise is correlated.

A fit weighs rows by one noise model. What it knows depends on the noise there is: readings that follow one another may
share a part that fades, and an instrument's frame may creep. Neither has to be proven to make bands too narrow. The
covariance of the estimate is therefore that of generalised least squares under each of many noise models (the sandwich
``N^-1 (A' V A + P) N^-1`` of White 1980, Econometrica 48, 817-838), averaged by their evidence (Kass and Raftery 1995,
J. Am. Stat. Assoc. 90, 773-795). The frame that is asked for is the one at the end of a set-up: an instrument that
warms up reads it then.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.series import Series, sequence
from deltacal_gen.estimation.system import in_unit_noise, length_of
from deltacal_gen.inference.functions import walk
from deltacal_gen.inference.likelihood import MixedModel, unit_variance
from deltacal_gen.inference.noise import NoiseModel
from deltacal_gen.machine.registry import Array

MEMORIES = (1.0, 3.0, 10.0)  # rows over which noise may fade to a third
SHARES = (0.3, 0.6, 1.0)  # of its variance that does
ORDINARY = 0.3  # standard deviations of noise by which a frame may well creep: the scale of a half-normal prior
CREEPS = np.geomspace(0.05, 3.0, 8)  # likewise, that are averaged over
MODES = 8  # functions of a walk, which carry 95 % of its variance
SEEN = 1e-12  # of columns of unit length: a direction that is less is none
HARDLY = 1e-3  # of the likelihood: noise models below it change no variance


class _Weighed(NamedTuple):
    """A noise model: correlated rows, a frame that creeps by a size, the level of both, and its probability."""

    rows: NoiseModel
    creep: float
    level: float
    probability: float


def averaged(at: Fit) -> Array:
    """Return the covariance (n + n_m, n + n_m) of parameters and instrument, averaged over noise models.

    Where readings belong to several rows, whose noise is of the points that they share, it is the fit's own.
    """
    problem = at.problem
    if problem.readings.rows.shape[1] != 1 or len(at.residual) < 3:
        return at.covariance
    state = problem.linearise(at.errors, at.instrument, at.machine)
    scale = np.append(problem.scale, np.ones(state.J_m.shape[2]))
    n, prior, read = len(scale), np.eye(len(problem.scale), len(scale)), np.isfinite(state.residual)
    J = np.concatenate([state.J_p, state.J_m], axis=2) * scale
    rows = np.concatenate([J, _creep(at), state.residual[..., None]], axis=2)
    rows = in_unit_noise(rows, read, at.sigma, at.weights, at.repeats)
    flat = rows.reshape(-1, rows.shape[2])
    flat[:, n:-1] *= unit_variance(flat[:, n:-1])
    size = length_of(np.vstack([flat[:, :n], prior]))
    # by an orthogonal basis: products of columns would lose half of the digits
    Q, R = np.linalg.qr(np.vstack([flat[:, :n], prior]) / size)
    Q, pulled = Q[: len(flat)], Q[len(flat) :]
    # an outlier is a reading of more noise: of it Huber's weights leave the root of how far it is off
    models = _weighed(at, flat.reshape(rows.shape) * np.sqrt(at.weights)[:, None, None], read, size)
    creeping, middle = Q.T @ flat[:, n:-1], pulled.T @ pulled
    for noise, alike in itertools.groupby(models, key=lambda model: model.rows):
        own = [(m.probability * m.level, m.creep) for m in alike if m.probability > HARDLY]
        if own:
            moved = noise.times(Q.reshape(*read.shape, n)).reshape(Q.shape)
            middle += sum(w for w, _ in own) * (Q.T @ moved)
            middle += sum(w * creep**2 for w, creep in own) * (creeping @ creeping.T)
    back = np.linalg.pinv(R, rcond=SEEN) * (scale / size)[:, None]
    return np.asarray(back @ middle @ back.T)


def _weighed(at: Fit, rows: Array, read: np.ndarray, size: Array) -> list[_Weighed]:
    """Return noise models by their evidence, all that is fitted taken out.

    Parameters
    ----------
    rows : (R, k, n + m + 1) array
        In unit noise: what is fitted, how the frame creeps, the residual.
    size : (n,) array
        Lengths of the columns that are fitted.
    """
    n, found, log = len(size), list[tuple[NoiseModel, float, float]](), list[float]()
    for odds, noise in _correlations(at):
        whole = np.asarray(np.linalg.qr(noise.whiten(rows).reshape(-1, rows.shape[2]), mode="r"))
        taken, rest = np.abs(np.diag(whole)[:n]) / size, whole[n:, n:]
        volume = read.any(axis=0).sum() * noise.log_det + 2 * np.log(np.maximum(taken, SEEN)).sum()
        model = MixedModel.of(rest[:, :-1], rest[:, -1], np.zeros((len(rest), 0)))
        model = dataclasses.replace(model, contrasts=max(int(read.sum()) - n, 1))
        for creep in CREEPS if rest.shape[1] > 1 else (0.0,):
            variances = np.full(rest.shape[1] - 1, creep**2)
            before = np.log(odds) + (np.log(creep) - (creep / ORDINARY) ** 2 / 2 if creep else 0.0)
            found.append((noise, creep, model.noise(variances)))
            log.append(before - (model.deviance(variances) + volume) / 2)
    weight = np.exp(np.array(log) - max(log))
    return [_Weighed(*each, float(w)) for each, w in zip(found, weight / weight.sum(), strict=True)]


def _correlations(at: Fit) -> Iterator[tuple[float, NoiseModel]]:
    """Yield noise of the rows of a fit, correlated in the order of reading or not, with prior probabilities.

    Where the fit has taken off what follows on other rows, none is left.
    """
    series, rows = Series.of(at.problem.readings, at.problem.recording), len(at.residual)
    assert series is not None
    if at.repeats.series is not None:
        series = dataclasses.replace(series, gap=np.full(rows, np.inf))
    yield 0.5, dataclasses.replace(series, rho=0.0, own=0.0).noise
    if at.repeats.series is None:
        each = 0.5 / (len(MEMORIES) * len(SHARES))
        for memory in MEMORIES:
            for share in SHARES:
                yield each, dataclasses.replace(series, rho=float(np.exp(-1 / memory)), own=1 - share).noise


def _creep(at: Fit) -> Array:
    """Return columns (R, k, MODES * 3) of the readings where the instrument's frame walks, each set-up to its end."""
    problem = at.problem
    if problem.readings.kind.sees_joints or len(at.residual) < 2 * MODES:
        return np.zeros((*at.residual.shape, 0))
    functions = walk(1 - _passed(problem), MODES)
    dx = problem.displacements(at.machine)[:, :, problem.mechanism.limbs :]
    J, _ = at.instrument.linearise(problem.readings, problem.seen(at.machine), dx)
    return (J[:, :, None] * functions[:, None, :, None]).reshape(*J.shape[:2], -1)


def _passed(problem: Problem) -> Array:
    """Return which part of its set-up has passed at each reading (R,), by time or else by the order of rows."""
    found, time = problem.readings, problem.recording.time_s
    clock = sequence(found, problem.recording).astype(float)
    if time is not None and not problem.recording.begins_anew and np.isfinite(time[found.rows[:, 0]]).all():
        clock = time[found.rows[:, 0]]
    out = np.zeros(len(found))
    for setup in np.unique(found.setup):
        own = found.setup == setup
        out[own] = (clock[own] - clock[own].min()) / max(float(np.ptp(clock[own])), 1e-300)
    return out
