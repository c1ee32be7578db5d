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
from collections.abc import Iterator

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


def averaged(at: Fit) -> Array:
    """Return the covariance (n + n_m, n + n_m) of parameters and instrument, averaged over noise models.

    Where readings belong to several rows, whose noise is of the points that they share, it is the fit's own.
    """
    problem = at.problem
    if problem.readings.rows.shape[1] != 1 or len(at.residual) < 3:
        return at.covariance
    state = problem.linearise(at.errors, at.instrument, at.machine)
    scale = np.append(problem.scale, np.ones(state.J_m.shape[2]))
    J = np.concatenate([state.J_p, state.J_m], axis=2) * scale
    creep, read = _creep(at), np.isfinite(state.residual)
    rows = np.concatenate([J, creep, state.residual[..., None]], axis=2)
    rows = in_unit_noise(rows, read, at.sigma, at.weights, at.repeats)
    n, prior = len(scale), np.eye(len(problem.scale), len(scale))
    A, B, e = rows[..., :n], rows[..., n:-1], rows[..., -1]
    flat = A.reshape(-1, n)
    size = length_of(np.vstack([flat, prior]))
    B = B * unit_variance(B.reshape(len(flat), -1))
    # an outlier is a reading of more noise: of it Huber's weights leave the root of how far it is off
    bounded, found = np.concatenate([A, B, e[..., None]], axis=2) * np.sqrt(at.weights)[:, None, None], []
    for odds, noise in _correlations(at):
        freed = noise.whiten(bounded).reshape(e.size, -1)
        whole = np.asarray(np.linalg.qr(freed, mode="r"))
        R, taken = whole[n:, n:], np.abs(np.diag(whole)[:n]) / size
        volume = read.any(axis=0).sum() * noise.log_det + 2 * np.log(np.maximum(taken, SEEN)).sum()
        model = MixedModel.of(R[:, :-1], R[:, -1], np.zeros((len(R), 0)))
        model = dataclasses.replace(model, contrasts=max(int(read.sum()) - n, 1))
        for creeps in CREEPS if creep.shape[2] else (0.0,):
            variances = np.full(B.shape[2], creeps**2)
            deviance = model.deviance(variances) + volume
            before = odds * creeps * np.exp(-((creeps / ORDINARY) ** 2) / 2) if creeps else odds
            found.append((np.log(before) - deviance / 2, noise, creeps, model.noise(variances)))
    weight = np.exp(np.array([f[0] for f in found]) - max(f[0] for f in found))
    weight /= weight.sum()
    # by an orthogonal basis: products of columns would lose half of the digits
    Q, R = np.linalg.qr(np.vstack([flat, prior]) / size)
    Q, pulled = Q[: len(flat)], Q[len(flat) :]
    across, middle, times = Q.T @ B.reshape(len(flat), -1), pulled.T @ pulled, dict[int, Array]()
    for w, (_, noise, creeps, level) in zip(weight.tolist(), found, strict=True):
        if w < HARDLY:
            continue
        if id(noise) not in times:
            times[id(noise)] = Q.T @ noise.times(Q.reshape(A.shape)).reshape(Q.shape)
        middle += w * level * (times[id(noise)] + creeps**2 * (across @ across.T))
    back = np.linalg.pinv(R, rcond=SEEN) * (scale / size)[:, None]
    return np.asarray(back @ middle @ back.T)


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
