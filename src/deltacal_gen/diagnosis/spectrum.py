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
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np

from deltacal_gen.diagnosis.library import ORDERS
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.estimation.solvers import jitter
from deltacal_gen.identification.folds import stands
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term, effect_names, load_effect
from deltacal_gen.results.diagnosis import Seen
from deltacal_gen.results.parts import NeverSeen

LEAST_TURN = 2 * np.pi / 3  # a joint that moves less can hardly show that its error repeats
MARGIN = 10.0  # twice the logarithm of the evidence: what a joint's error must earn
PROVEN = 3.0  # standard deviations by which held-out poses must be better
CORNER = 10.0  # order at which the search for the corner begins; it doubles and halves
SAMPLE = 500  # readings at which the error's standard deviation is looked at
ROUNDS = 200  # of the estimation of sizes, each of them cheap
IDLE = 0.05  # of a joint's variance: so little is at the highest orders that nothing else could take it for its own
STANDS_OUT = 2.45  # standard deviations of an amplitude: 95 % of those of an order that is not there are smaller
MOST_OUT = 5  # orders of a joint that are told
SAME_NOISE = 1.5  # times: variances of noise that differ less weigh priors alike


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
        Of each joint, over the readings: root mean square of its error, and of the error's standard deviation [rad].
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
        Of each joint: orders whose amplitude exceeds its standard deviation most, the clearest first.
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

    def held_in(self, problem: Problem) -> Problem:
        """Return a problem in which the orders are held, as unknown as they are."""
        return dataclasses.replace(problem, held=self.terms, held_std=self.prior)


@cache
def wave() -> str:
    """Return the name of the effect that is a wave of the joint's turn; "" where none is registered."""
    return next((name for name in effect_names() if load_effect(name).PERIODIC), "")


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
    turns = problem.body.q[rows[:, 0]]
    turning = [unit == "rad" for unit in problem.mechanism.joint_units]
    limbs = [j + 1 for j, span in enumerate(np.ptp(turns, axis=0)) if turning[j] and span > LEAST_TURN]
    if not limbs:
        return None
    linear = _Linear(at, turns, limbs, parts, known)
    gains, found, corner = {}, None, CORNER if known is None else known.corner
    while limbs:
        found = linear.sized(limbs, corner)
        if linear.weighs_otherwise(found.noise):
            found = linear.sized(limbs, found.corner)
        corner = found.corner
        gains = {j: linear.gain(found, j) for j in limbs}
        if all(g > MARGIN for g in gains.values()):
            break
        limbs = [j for j in limbs if gains[j] > MARGIN]
    if not limbs or found is None:
        return None
    before, after = linear.held_out(None), linear.held_out(found)
    before, after = (lengths(errors, problem.readings.kind) for errors in (before, after))
    pose = stands(problem.readings, problem.recording)
    better = np.bincount(pose, np.nansum(before**2 - after**2, axis=1))[np.bincount(pose) > 0]
    if better.sum() <= PROVEN * float(np.std(better)) * np.sqrt(len(better)):
        return None
    values, size, std, standing = linear.solved(found)
    return Spectrum(
        tuple(Term(wave(), tuple(limbs), values[k - 1], (float(k),)) for k in range(1, ORDERS + 1)),
        tuple(np.full((len(limbs), 2), v**0.5) for v in found.variance * _carrying(_shape(found.corner))),
        gains,
        size,
        std,
        {j: seen(turns[:, j - 1], found.corner) for j in limbs},
        found.corner,
        (rms(before), rms(after)),
        linear.covariance(found),
        standing,
    )


def _standing(values: Array, covariance: np.ndarray) -> tuple[Standing, ...]:
    """Return the orders of a joint whose amplitude exceeds its standard deviation most, the clearest first.

    Parameters
    ----------
    values, covariance : (2 orders,), (2 orders, 2 orders) array
        Cosine and sine, order by order [rad].
    """
    found = []
    for k in range(ORDERS):
        own, amplitude = slice(2 * k, 2 * k + 2), float(np.hypot(*values[2 * k : 2 * k + 2]))
        along = values[own] / max(amplitude, 1e-300)
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
    out = []
    if known is None:
        return ()
    for joint in known.joints:
        turn = turns[:, joint.limb - 1]
        far = unseen(turn, joint.angles_deg, known.within_deg)
        if far.any():
            where = tuple(seen(turn[far], 180.0 / known.within_deg))
            out.append(NeverSeen(limb=joint.limb, readings=int(far.sum()), angles_deg=where))
    return tuple(out)


def words(joint: NeverSeen) -> str:
    """Return an entry of `never_seen` in words."""
    where = ", ".join(f"{a:.0f} to {b:.0f}" for a, b in joint.angles_deg)
    return (
        f"joint {joint.limb} stands in {joint.readings} readings at angles that the diagnosis never saw "
        f"({where} deg within the turn): its periodic error is not corrected there"
    )


def unseen(turn: Array, intervals: Sequence[Sequence[float]], within: float) -> np.ndarray:
    """Tell which turns (N,) [rad] are farther than `within` [deg] from all angles that were seen."""
    angle = np.degrees(turn)[:, None] % 360.0
    first, last = np.array(intervals).T
    inside = (angle - first) % 360.0 <= last - first
    gap = np.minimum((first - angle) % 360.0, (angle - last) % 360.0)
    return ~(inside | (gap <= within)).any(axis=1)


def _waves(angle: Array) -> Array:
    """Return cosine and sine of every order (N, 2 orders)."""
    step = np.multiply.accumulate(np.repeat(np.exp(1j * angle)[:, None], ORDERS, axis=1), axis=1)
    out: Array = np.stack([step.real, step.imag], axis=2).reshape(len(angle), -1)
    return out


def _shape(corner: float) -> Array:
    """Return how the variance of coefficients goes with the order (orders,)."""
    out: Array = (1 + (np.arange(1, ORDERS + 1) / corner) ** 2) ** -2.0
    return out


def _carrying(shape: Array) -> Array:
    """Return the variances (orders,) of the lowest orders, which carry nearly all of them."""
    out: Array = shape[: 1 + int(np.searchsorted(np.cumsum(shape), (1 - IDLE) * shape.sum()))]
    return out


@dataclass(frozen=True)
class _Sized:
    """Joints, the corner of their spectrum, the variance of its first coefficients, and the noise (of the whitened)."""

    limbs: tuple[int, ...]
    corner: float
    variance: float
    noise: float
    evidence: float


class _Linear:
    """Normal equations of geometry, instrument and effects with all orders of some joints, part by part.

    A joint's columns are its displacement of the readings times functions of its angle: their products are sums over
    the rows of products of functions, and the columns themselves are never formed.
    """

    def __init__(
        self,
        at: Fit,
        turns: Array,
        limbs: Sequence[int],
        parts: Sequence[tuple[np.ndarray, np.ndarray]],
        known: Spectrum | None,
    ) -> None:
        problem = at.problem
        machine = at.machine
        state = problem.linearise(at.errors, at.instrument, machine)
        J, _ = at.instrument.linearise(problem.readings, problem.seen(machine), problem.displacements(machine))
        self._J = J[:, :, [j - 1 for j in limbs]]
        self._F = [_waves(turns[:, j - 1]) for j in limbs]
        self._limbs = tuple(limbs)
        self._y = state.residual
        if known is not None:
            c = {j: np.stack([t.values[i] for t in known.terms]).ravel() for i, j in enumerate(known.limbs)}
            for i, j in enumerate(limbs):
                if j in c:
                    self._y = self._y + self._J[:, :, i] * (self._F[i] @ c[j])[:, None]
        self._raw = np.concatenate([state.J_p * problem.scale, state.J_m], axis=2)
        self._n = self._raw.shape[2]
        self._scale = np.concatenate([problem.scale, np.ones(state.J_m.shape[2])])
        self._held = (np.arange(self._n) < len(problem.scale)).astype(float)
        departure = (at.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
        self._departure = np.concatenate([departure, np.zeros(self._n - len(departure))])
        self._noise = 1.0  # of the whitened readings: against it priors weigh
        self._tests = [test for _, test in parts]
        self._quiet = at.weights > 0
        every = self._whitened(at)
        self._grams = [self._gram([v[test] for v in every], [F[test] for F in self._F]) for test in self._tests]

    def _whitened(self, at: Fit) -> list[Array]:
        """Return rows by the noise: of what is fitted and the readings (R, k, n + 1), of the joints (R, k, joints).

        Rows that hang together count by their effective number: what frees them of one another would mix functions of
        different angles.
        """
        read = np.isfinite(self._y)
        apart, series = dataclasses.replace(at.repeats, series=None), at.repeats.series
        number = 1.0 if series is None else 1 / series.rows
        self._scalars = number * float((read & (at.weights > 0)[:, None]).sum())
        w = np.sqrt(at.weights * number)[:, None] / at.sigma * np.sqrt(1 + at.repeats.ratio)
        out = []
        for values in (np.concatenate([self._raw, self._y[..., None]], axis=2), self._J):
            out.append(apart.whiten(np.where(read[..., None], values * w[..., None], 0.0), at.weights))
        return out

    def _gram(self, whitened: Sequence[Array], waves: Sequence[Array]) -> Array:
        """Return the products of all columns: n fitted, the readings, then the orders of each joint."""
        base, J = whitened
        n, m = self._n + 1, 2 * ORDERS
        G = np.zeros((n + m * len(waves),) * 2)
        flat = base.reshape(-1, n)
        G[:n, :n] = flat.T @ flat
        for i, F in enumerate(waves):
            own = slice(n + m * i, n + m * (i + 1))
            G[:n, own] = np.matvec(np.swapaxes(base, 1, 2), J[:, :, i]).T @ F
            G[own, :n] = G[:n, own].T
            for j in range(i, len(waves)):
                other = slice(n + m * j, n + m * (j + 1))
                G[own, other] = (F * (J[:, :, i] * J[:, :, j]).sum(axis=1)[:, None]).T @ waves[j]
                G[other, own] = G[own, other].T
        return G

    def _places(self, limbs: Sequence[int]) -> np.ndarray:
        m = 2 * ORDERS
        return np.concatenate([self._n + 1 + m * self._limbs.index(j) + np.arange(m) for j in limbs])

    def weighs_otherwise(self, noise: float) -> bool:
        """Weigh priors of what is fitted by another noise; tell whether that changes anything."""
        if 1 / SAME_NOISE < noise / self._noise < SAME_NOISE:
            return False
        self._noise = noise
        del self._whole
        return True

    @cached_property
    def _whole(self) -> tuple[Array, Array, float]:
        """Return normal equations of the orders and the sum of squares, all that is fitted beside taken out."""
        return self._beside(np.sum(self._grams, axis=0))

    def _beside(self, G: Array) -> tuple[Array, Array, float]:
        n = self._n
        H, g = self._geometry(G)
        S = np.linalg.solve(H, np.column_stack([G[:n, n + 1 :], g]))
        coupling = G[n + 1 :, :n]
        rest = float(G[n, n] + self._noise * self._departure @ self._departure - g @ S[:, -1])
        return G[n + 1 :, n + 1 :] - coupling @ S[:, :-1], G[n + 1 :, n] - coupling @ S[:, -1], rest

    def _geometry(self, G: Array) -> tuple[Array, Array]:
        """Return the normal equations (n, n) and (n,) of what is fitted beside the orders, with its priors."""
        n, held = self._n, self._noise * self._held
        return G[:n, :n] + np.diag(held + jitter(np.diag(G)[:n])), G[:n, n] - held * self._departure

    def sized(self, limbs: Sequence[int], start: float) -> _Sized:
        """Return size, corner and noise of the largest evidence, sought from a corner on."""
        best = self._at_corner(limbs, start)
        for factor in (2.0, 0.5):
            while 1.0 < best.corner * factor < ORDERS:
                other = self._at_corner(limbs, best.corner * factor)
                if other.evidence <= best.evidence:
                    break
                best = other
            if best.corner > start:
                break
        return best

    def _at_corner(self, limbs: Sequence[int], corner: float) -> _Sized:
        own = self._places(limbs) - self._n - 1
        S, g, rest = self._whole
        d = np.sqrt(np.tile(np.repeat(_shape(corner), 2), len(limbs)))
        size, vectors = np.linalg.eigh(S[np.ix_(own, own)] * d * d[:, None])
        size, along = np.maximum(size, 0.0), vectors.T @ (g[own] * d)
        n = self._scalars
        noise = rest / n
        variance = len(own) * noise / max(float(size.sum()), 1e-300)
        for _ in range(ROUNDS):  # expectation and maximisation (MacKay 1992)
            c, spread = variance * along / (variance * size + noise), variance * noise / (variance * size + noise)
            new = float(np.mean(c**2 + spread))
            noise = (rest - 2 * float(c @ along) + float(c**2 @ size) + float(size @ spread)) / n
            done, variance = abs(new - variance) < 1e-4 * variance, new
            if done:
                break
        left = rest - float((variance * along**2 / (variance * size + noise)).sum())
        evidence = -0.5 * (n * np.log(noise) + float(np.log1p(variance * size / noise).sum()) + left / noise)
        return _Sized(tuple(limbs), corner, variance, noise, evidence)

    def gain(self, found: _Sized, without: int) -> float:
        """Return twice the logarithm of the evidence for the error of one of the joints."""
        limbs = [j for j in found.limbs if j != without]
        if not limbs:
            n, rest = self._scalars, self._whole[2]
            return 2 * (found.evidence + 0.5 * (n * np.log(rest / n) + n))
        own = self._places(limbs) - self._n - 1
        S, g, rest = self._whole
        d = np.sqrt(found.variance * np.tile(np.repeat(_shape(found.corner), 2), len(limbs)))
        L = np.linalg.cholesky(S[np.ix_(own, own)] * d * d[:, None] / found.noise + np.eye(len(own)))
        z = np.linalg.solve(L, g[own] * d)
        left = rest - float(z @ z) / found.noise
        evidence = -0.5 * (self._scalars * np.log(found.noise) + 2 * np.log(np.diag(L)).sum() + left / found.noise)
        return 2 * float(found.evidence - evidence)

    def solved(
        self, found: _Sized
    ) -> tuple[Array, dict[int, float], dict[int, float], dict[int, tuple[Standing, ...]]]:
        """Return coefficients (orders, joints, 2) [rad]; of each joint rms and standard deviation [rad], and orders."""
        own = self._places(found.limbs) - self._n - 1
        S, g, _ = self._whole
        inverse = np.linalg.inv(S[np.ix_(own, own)] + np.diag(self._prior(found)))
        values, m = inverse @ g[own], 2 * ORDERS
        size, std, standing = {}, {}, {}
        for i, j in enumerate(found.limbs):
            F, part = self._F[self._limbs.index(j)], slice(m * i, m * (i + 1))
            size[j] = float(np.std(F @ values[part]))
            F = F[:: max(len(F) // SAMPLE, 1)]
            std[j] = float(np.sqrt(found.noise * np.mean(((F @ inverse[part, part]) * F).sum(axis=1))))
            standing[j] = _standing(values[part], found.noise * inverse[part, part])
        return np.swapaxes(values.reshape(len(found.limbs), ORDERS, 2), 0, 1), size, std, standing

    def covariance(self, found: _Sized) -> Array:
        """Return the covariance of what is fitted beside orders that are as unknown as the readings leave them."""
        n, own, G = self._n, self._places(found.limbs), np.sum(self._grams, axis=0)
        H, _ = self._geometry(G)
        orders = G[np.ix_(own, own)] + np.diag(self._prior(found))
        C = found.noise * np.linalg.inv(H - G[:n, own] @ np.linalg.solve(orders, G[own, :n]))
        covariance: Array = C * self._scale * self._scale[:, None]
        return covariance

    def _prior(self, found: _Sized) -> Array:
        """Return what the prior adds to the diagonal of the normal equations."""
        out: Array = found.noise / (found.variance * np.tile(np.repeat(_shape(found.corner), 2), len(found.limbs)))
        return out

    def held_out(self, found: _Sized | None) -> Array:
        """Return the errors (R, k) of readings by fits that have not seen them; nan of gross errors."""
        whole, n = np.sum(self._grams, axis=0), self._n
        limbs = () if found is None else found.limbs
        own = self._places(limbs) if found is not None else np.zeros(0, dtype=int)
        out = np.full(self._y.shape, np.nan)
        for test, gram in zip(self._tests, self._grams, strict=True):
            S, g, _ = self._beside(G := whole - gram)
            c = np.zeros(0)
            if found is not None:
                at = own - n - 1
                c = np.linalg.solve(S[np.ix_(at, at)] + np.diag(self._prior(found)), g[at])
            H, b = self._geometry(G)
            u = np.linalg.solve(H, b - G[:n, own] @ c)
            left = self._y[test] - self._raw[test] @ u
            for j, values in zip(limbs, c.reshape(-1, 2 * ORDERS), strict=True):
                i = self._limbs.index(j)
                left -= self._J[test][:, :, i] * (self._F[i][test] @ values)[:, None]
            out[test] = left
        out[~self._quiet] = np.nan
        return out
