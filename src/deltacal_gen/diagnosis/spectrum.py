"""Periodic errors of many orders at once: what encoders and gears do to each joint, turn after turn.

A single order is a term like any other, of the effect that is a wave of the joint's turn (`wave`). Magnetic encoders
and strain-wave gears err at dozens of orders, none of which is large, and poses that do not fill the turn cannot tell
neighbouring ones apart: taken one by one their amplitudes would be arbitrary. Here the error of a joint is a periodic
function of its angle, a Gaussian process with Matérn's spectrum (Rasmussen and Williams 2006, section 4.2.1): every
order is a coefficient with a prior, even up to a corner and falling with the fourth power beyond. Its size and corner
are those of the largest evidence, geometry, instrument and other effects fitted beside it. Where a joint has not been,
the function falls back to nothing: it does not extrapolate.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.identification.functions import Functions, Linear, Sized, confirmed
from deltacal_gen.identification.orders import ORDERS, all_orders, as_terms, solved, wave
from deltacal_gen.inference.functions import spectrum, waves
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import Seen
from deltacal_gen.results.parts import NeverSeen

LEAST_TURN = 2 * np.pi / 3  # a joint that moves less can hardly show that its error repeats
MARGIN = 10.0  # twice the logarithm of the evidence: what a joint's error must earn
CORNER = 10.0  # order at which the search for the corner begins; it doubles and halves
IDLE = 0.05  # of a joint's variance: so little is at the highest orders that nothing else could take it for its own
STANDS_OUT = 2.45  # standard deviations of an amplitude: 95 % of those of an order that is not there are smaller
MOST_OUT = 5  # orders of a joint that are told
STEP = 360.0 / (4 * ORDERS)  # deg: a quarter of the shortest period


@dataclass(frozen=True)
class Standing:
    """An order that stands out of a spectrum: amplitude, and its standard deviation [rad]."""

    order: int
    amplitude: float
    std: float


@dataclass(frozen=True)
class Spectrum:
    """Periodic errors of joints, all orders together.

    Attributes
    ----------
    terms : tuple of Term
        One per order, the lowest first, all on the same joints.
    gains : dict
        Of each joint (from 1): twice the logarithm of the evidence for its error.
    rms, std : dict
        Of each joint, over the readings: root mean square of its error, and of the error's standard deviation [rad],
        but for a constant, which is the joint's zero.
    prior : tuple of (joints, 2) array
        Of each of the orders that carry nearly all: standard deviation of coefficients before the readings [rad].
    seen : dict
        Of each joint: between which angles [deg, within a turn] it was read.
    corner : float
        Order beyond which coefficients become small.
    heldout : (float, float)
        RMS [mm] of readings that the fit has not seen, without and with the errors.
    covariance : (n + n_m, n + n_m) array
        Of what is fitted beside, parameters and the instrument's unknowns [mm, rad], the errors unknown as they are.
    standing : dict
        Of each joint: orders whose amplitude exceeds its standard deviation most, the clearest first; none that
        others cancel.
    """

    terms: tuple[Term, ...]
    prior: tuple[Array, ...]
    gains: dict[int, float]
    rms: dict[int, float]
    std: dict[int, float]
    seen: dict[int, list[tuple[float, float]]]
    corner: float
    heldout: tuple[float, float]
    covariance: Array
    standing: dict[int, tuple[Standing, ...]]

    @property
    def limbs(self) -> tuple[int, ...]:
        """Joints (from 1) that have an error."""
        return self.terms[0].limbs

    def coefficients(self, limb: int) -> Array:
        """Return cosine and sine of each order (orders, 2) [rad] of a joint's error."""
        return np.array([t.values[self.limbs.index(limb)] for t in self.terms])

    def held_in(self, problem: Problem) -> Problem:
        """Return a problem in which the orders are held, as unknown as they are."""
        return dataclasses.replace(problem, held=self.terms, held_std=self.prior)


def periodic(at: Fit, parts: Sequence[tuple[np.ndarray, np.ndarray]], known: Spectrum | None = None) -> Spectrum | None:
    """Return the periodic errors of the joints, None where the readings do not bear them out.

    Parameters
    ----------
    at : Fit
        Geometry and other effects; linear from here.
    parts : sequence of (train, test)
        Masks (R,) of readings, every reading in one test; repeats of a pose stay together.
    known : Spectrum, optional
        Errors that are held in the fit already: they are estimated anew.
    """
    problem = at.problem
    rows = problem.readings.rows
    if rows.shape[1] != 1 or not wave():
        return None
    q, used = problem.body.q, rows[:, 0]
    turning = [unit == "rad" for unit in problem.mechanism.joint_units]
    limbs = [j + 1 for j, span in enumerate(np.ptp(q[used], axis=0)) if turning[j] and span > LEAST_TURN]
    if not limbs:
        return None
    held = {} if known is None else {j: known.coefficients(j).ravel() for j in known.limbs}
    linear = Linear(at, parts, put_back=[(all_orders(q, j), c) for j, c in held.items()])
    corner = CORNER if known is None else known.corner
    while limbs:
        functions = linear.functions([all_orders(q, j) for j in limbs])
        found, corner = _sized(linear, functions, corner)
        joints = np.repeat(limbs, 2 * ORDERS)
        gains = {j: linear.gain(found, np.where(joints == j, 0.0, found.D)) for j in limbs}
        if all(g > MARGIN for g in gains.values()):
            break
        limbs = [j for j in limbs if gains[j] > MARGIN]
    if not limbs:
        return None
    before, after = linear.held_out(linear.alone), linear.held_out(found)
    if not confirmed(problem, before, after):
        return None
    kind, (each, covariance) = problem.readings.kind, solved(linear, found, used)
    own = dict(zip(limbs, each, strict=True))
    angles = {j: seen(q[used, j - 1], corner) for j in limbs}
    return Spectrum(
        as_terms({j: c.values for j, c in own.items()}),
        tuple(np.full((len(limbs), 2), v**0.5) for v in found.variance * _carrying(spectrum(ORDERS, corner))),
        gains,
        {j: c.rms for j, c in own.items()},
        {j: c.std for j, c in own.items()},
        angles,
        corner,
        (rms(lengths(before, kind)), rms(lengths(after, kind))),
        covariance,
        {j: _standing(c.values, c.covariance, angles[j]) for j, c in own.items()},
    )


def _sized(linear: Linear, functions: Functions, start: float) -> tuple[Sized, float]:
    """Return the size and the corner of the largest evidence, sought from a corner on."""

    def at(corner: float) -> Sized:
        return linear.sized(functions, np.tile(np.repeat(spectrum(ORDERS, corner), 2), len(functions.each)))

    best, corner = at(start), start
    for factor in (2.0, 0.5):
        while 1.0 < corner * factor < ORDERS and (other := at(corner * factor)).evidence > best.evidence:
            best, corner = other, corner * factor
        if corner > start:
            break
    return best, corner


def _standing(values: Array, covariance: np.ndarray, angles: Sequence[tuple[float, float]]) -> tuple[Standing, ...]:
    """Return the orders of a joint whose amplitude exceeds its standard deviation most, the clearest first.

    Over a part of the turn orders are nearly alike, and large ones that cancel make a small error: where one of them,
    taken away, leaves more at the angles that were seen, its amplitude is none that the joint has shown.

    Parameters
    ----------
    values, covariance : (2 orders,), (2 orders, 2 orders) array
        Cosine and sine, order by order [rad].
    angles : sequence of (float, float)
        Between which angles [deg] the joint was read.
    """
    there = np.concatenate([np.arange(a, b + STEP, STEP) for a, b in angles])
    each = (waves(np.radians(there), ORDERS) * values).reshape(len(there), ORDERS, 2).sum(axis=2)
    error = each.sum(axis=1)
    found = []
    for k in range(ORDERS):
        own, amplitude = slice(2 * k, 2 * k + 2), float(np.hypot(*values[2 * k : 2 * k + 2]))
        along = values[own] / max(amplitude, 1e-300)
        if np.std(error - each[:, k]) < np.std(error):
            found.append(Standing(k + 1, amplitude, float(np.sqrt(along @ covariance[own, own] @ along))))
    out = sorted((s for s in found if s.amplitude > STANDS_OUT * s.std), key=lambda s: -s.amplitude / s.std)
    return tuple(out[:MOST_OUT])


def seen(turn: Array, corner: float) -> list[tuple[float, float]]:
    """Return the intervals [deg, within a turn] in which angles lie, closer together than half a period of `corner`."""
    angle = np.unique(np.round(np.degrees(turn) % 360.0, 3))
    gaps = np.flatnonzero(np.diff(angle) > 180.0 / corner)
    first, last = angle[np.concatenate([[0], gaps + 1])], angle[np.concatenate([gaps, [-1]])]
    return [(float(a), float(b)) for a, b in zip(first, last, strict=True)]


def never_seen(known: Seen | None, turns: Array) -> tuple[NeverSeen, ...]:
    """Return the joints that stand at angles where the readings of a diagnosis never were, how often and where.

    Parameters
    ----------
    known : Seen, optional
        `seen` of a diagnosis.
    turns : (N, n_q) array
        Joints [rad].
    """
    if known is None:
        return ()

    def spans(turn: Array) -> list[tuple[float, float]]:
        return seen(turn, 180.0 / known.within_deg)

    each = ((j.limb, turns[:, j.limb - 1], j.angles_deg) for j in known.joints)
    return standing((limb, turn, unseen(turn, angles, known.within_deg), spans) for limb, turn, angles in each)


Spans = Callable[[Array], list[tuple[float, float]]]  # between which angles [deg] turns [rad] lie


def standing(joints: Iterable[tuple[int, Array, np.ndarray, Spans]]) -> tuple[NeverSeen, ...]:
    """Return how often joints stand far off, and where; each with its turns (N,), which are far, and their spans."""
    return tuple(
        NeverSeen(limb=limb, readings=int(far.sum()), angles_deg=tuple(spans(turn[far])))
        for limb, turn, far, spans in joints
        if far.any()
    )


def unseen(turn: Array, intervals: Sequence[Sequence[float]], within: float) -> np.ndarray:
    """Tell which turns (N,) [rad] are farther than `within` [deg] from all angles that were seen."""
    angle = np.degrees(turn)[:, None] % 360.0
    first, last = np.array(intervals).T
    inside = (angle - first) % 360.0 <= last - first
    gap = np.minimum((first - angle) % 360.0, (angle - last) % 360.0)
    return ~(inside | (gap <= within)).any(axis=1)


def _carrying(shape: Array) -> Array:
    """Return the variances (orders,) of the lowest orders, which carry nearly all of them."""
    out: Array = shape[: 1 + int(np.searchsorted(np.cumsum(shape), (1 - IDLE) * shape.sum()))]
    return out
