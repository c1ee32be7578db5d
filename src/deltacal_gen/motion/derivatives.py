"""Velocities and accelerations of recorded joints, without delay, and how much of the signal that takes away.

Joints are fitted by splines of fifth degree, least squares over evenly spaced knots: a low-pass without phase that
takes samples as they come, even or not, and has exact derivatives. How far apart the knots stand is told by the joints
alone: where knots closer together change the accelerations by no more than the noise of the joints does.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import BSpline, make_lsq_spline

from deltacal_gen.motion.trajectories import Trajectories
from deltacal_gen.units import of_joints

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

DEGREE = 5
FINEST = 4.0  # samples between two knots, at least
COARSEST = 1.0  # s between them, at most
RATIO = 2**0.5  # between spacings that are looked at
LEAST = 2 * (DEGREE + 1)  # samples of a piece
AS_MUCH = 0.1  # of the motion of the joint that moves most
WINDOW = 40  # knots over which the noise of derivatives is computed


@dataclass(frozen=True, eq=False)
class Motion:
    """Joints with their derivatives.

    Attributes
    ----------
    states : (3, N, n_q) array
        Joints, velocities, accelerations [rad or mm, s]; nan in pieces that are too short.
    noise : (2, n_q) array
        Standard deviation of velocities and accelerations, as far as the joints' own noise goes.
    loose : (N,) array of bool
        Samples near the ends of a piece, where derivatives are known worse: no fit uses them.
    cutoff : float or None
        Of the low-pass [Hz]; None where derivatives were recorded.
    removed : float
        Part of the joints' signal (rms, of its own variation) that the low-pass takes away.
    text : str
        What was done.
    """

    states: Array
    noise: Array
    loose: np.ndarray
    cutoff: float | None
    removed: float
    text: str


def motion(given: Trajectories, cutoff: float | None = None) -> Motion:
    """Return joints with their derivatives; `cutoff` [Hz] where it is known already."""
    said = given.said.motion.derivatives
    if said == "recorded":
        states = np.stack([given.joints, *given.recorded])
        loose = np.zeros(len(given.time), dtype=bool)
        return Motion(
            states, np.zeros((2, states.shape[2])), loose, None, 0.0, "velocities and accelerations as recorded"
        )
    base, order = (given.joints, 0) if said is None else (given.recorded[0], 1)
    spacing = _chosen(given, base, 2 - order) if cutoff is None else 0.5 / cutoff
    fitted = smooth(base, given.time, given.piece, spacing, 2 - order)
    states = fitted if order == 0 else np.stack([given.joints, *fitted])
    sigma = _noise(base, fitted[0], given, spacing)
    per = [_unit_noise(given.step, spacing, d) for d in ((1, 2) if order == 0 else (0, 1))]
    spread = np.nanstd(base, axis=0)
    lost = np.sqrt(np.nanmean((base - fitted[0]) ** 2, axis=0))
    moving = _moving(base, given)
    removed = float((lost[moving] / spread[moving]).max(initial=0.0))
    what = "joints" if order == 0 else "recorded velocities"
    text = (
        f"splines of degree {DEGREE} through the {what}, least squares, a knot every {1000 * spacing:.3g} ms: no "
        f"delay, cut-off {0.5 / spacing:.3g} Hz, chosen by the {what} alone"
    )
    loose = ~_inside(given.time, given.piece, spacing)
    return Motion(states, np.outer(per, sigma), loose, 0.5 / spacing, removed, text)


def smooth(values: Array, time: Array, piece: np.ndarray, spacing: float, orders: int) -> Array:
    """Return values (N, k) through the low-pass and their derivatives, (1 + orders, N, k), piece by piece."""
    out = np.full((1 + orders, *values.shape), np.nan)
    starts = np.flatnonzero(np.diff(piece, prepend=-1))
    for own in np.split(np.arange(len(piece)), starts[1:]):
        if len(own) < LEAST:
            continue
        fit = _fit(time[own], values[own], spacing)
        for order in range(1 + orders):
            out[order, own] = fit.derivative(order)(time[own]) if order else fit(time[own])
    return out


def _fit(time: Array, values: Array, spacing: float) -> BSpline:
    """Return the spline of one piece, its knots as near to a spacing [s] as the piece allows."""
    parts = int(max(1, min(round((time[-1] - time[0]) / spacing), (len(time) - DEGREE - 1) // 2)))
    inner = np.linspace(time[0], time[-1], parts + 1)[1:-1]
    counts = np.histogram(time, [time[0], *inner, time[-1]])[0]
    if (counts == 0).any():  # samples so uneven that an interval holds none
        inner = np.quantile(time, np.linspace(0, 1, parts + 1)[1:-1])
    knots = np.concatenate([[time[0]] * (DEGREE + 1), inner, [time[-1]] * (DEGREE + 1)])
    return make_lsq_spline(time, values, knots, DEGREE)


def _chosen(given: Trajectories, base: Array, order: int) -> float:
    """Return the spacing of the knots [s] that leaves the least error of the highest derivative.

    Its error is noise, which falls with the spacing, and what knots closer together show beyond their own noise
    (Goldenshluger, Lepski 2011).
    """
    finest = FINEST * given.step
    count = 2 + int(np.log(max(COARSEST / finest, RATIO)) / np.log(RATIO))
    spacings = finest * RATIO ** np.arange(count)
    inside = _inside(given.time, given.piece, COARSEST / 2)
    derivatives = [smooth(base, given.time, given.piece, h, order)[:, inside] for h in spacings]
    base = base[inside]
    sigma = _noise(base, derivatives[0][0], given, finest)
    moving = _moving(base, given)
    noise = [np.outer(_unit_noise(given.step, h, order), sigma)[0] ** 2 for h in spacings]
    apart = np.nanmean((derivatives[0][-1] - derivatives[1][-1]) ** 2, axis=0)
    coloured = np.maximum(1.0, apart / (noise[0] - noise[1]))  # no motion is taken for so quick: it is noise, not white
    noise = [coloured * each for each in noise]
    whole = np.nanmean(derivatives[0][-1] ** 2, axis=0) - noise[0]
    whole = np.maximum(whole, 1e-12 + 1e-3 * noise[0])
    risks = []
    for n, own in enumerate(derivatives):
        beyond = np.zeros_like(whole)
        for finer, of_finer in zip(derivatives[:n], noise[:n], strict=True):
            apart = np.nanmean((own[-1] - finer[-1]) ** 2, axis=0)
            beyond = np.maximum(beyond, apart - (of_finer - noise[n]))
        risks.append(float(((beyond + noise[n]) / whole)[moving].sum()))
    return float(spacings[int(np.argmin(risks))])


def _inside(time: Array, piece: np.ndarray, within: float) -> np.ndarray:
    """Tell which samples are not `within` [s] of the ends of their piece, where splines are loose; all if none is."""
    start, end = (np.array([f(time[piece == code]) for code in range(piece[-1] + 1)])[piece] for f in (np.min, np.max))
    found = (time - start > within) & (end - time > within)
    return found if found.any() else np.ones(len(time), dtype=bool)


def _moving(base: Array, given: Trajectories) -> np.ndarray:
    """Tell which joints move as much as others of their unit do, by `AS_MUCH` at least, (n_q,)."""
    spread, units = np.nanstd(base, axis=0), np.array(of_joints(given.joint_unit, base.shape[1]))
    most = np.array([spread[units == unit].max() for unit in units])
    return np.asarray((spread >= AS_MUCH * most) & (spread > 0))


def _noise(base: Array, fitted: Array, given: Trajectories, spacing: float) -> Array:
    """Return the noise of single samples (n_q,), from what a spline of some spacing leaves."""
    left = 1.0 - min(0.9, given.step / spacing)  # degrees of freedom that it leaves, of one
    return np.asarray(np.sqrt(np.nanmean((base - fitted) ** 2, axis=0) / left))


def _unit_noise(step: float, spacing: float, order: int) -> float:
    """Return the noise of a derivative where that of a sample is 1, in the middle of a long piece."""
    per = max(1, round(spacing / step))
    inner = np.arange(-DEGREE, WINDOW + DEGREE + 1) * per * step
    time = np.arange(WINDOW * per) * step
    rows = BSpline.design_matrix(time, inner, DEGREE).toarray()
    columns = rows.shape[1]
    slopes = BSpline(inner, np.eye(columns), DEGREE).derivative(order)(time) if order else rows
    middle = slopes[len(time) // 2 - per // 2 : len(time) // 2 + per // 2 + 1]
    inverse = np.linalg.pinv(rows.T @ rows)
    return float(np.sqrt(np.mean(np.sum((middle @ inverse) * middle, axis=1))))
