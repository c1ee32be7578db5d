"""All orders of the periodic errors of joints at once, beside geometry and instrument: sizes, coefficients, evidence.

The error of a joint is a function of its angle with a Gaussian prior. Before any readings its orders are independent,
with Matérn's spectrum (Rasmussen and Williams 2006, section 4.2.1): even up to a corner, and falling with the fourth
power beyond. What another session knew of it is a prior, too, which holds the function where that session read it.
"""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import NamedTuple

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.estimation.solvers import jitter
from deltacal_gen.estimation.system import in_unit_noise
from deltacal_gen.identification.folds import stands
from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.inference.sizes import fit_sizes
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term, effect_names, load_effect

ORDERS = 100  # integer orders of a periodic error that are searched
RANGE = 1e8  # of the variance of coefficients, either way of the one that brings readings that of their noise
PROVEN = 3.0  # standard deviations by which held-out poses must be better
SAMPLE = 500  # readings at which the error's standard deviation is looked at
SAME_NOISE = 1.5  # times: variances of noise that differ less weigh priors alike


@cache
def wave() -> str:
    """Return the name of the effect that is a wave of the joint's turn; "" where none is registered."""
    return next((name for name in effect_names() if load_effect(name).PERIODIC), "")


def as_terms(errors: Mapping[int, Array]) -> tuple[Term, ...]:
    """Return the errors of joints, coefficients (2 orders,) [rad] of each, as effects: one per order, from 1."""
    each = np.stack([values.reshape(ORDERS, 2) for values in errors.values()], axis=1)
    return tuple(Term(wave(), tuple(errors), each[k - 1], (float(k),)) for k in range(1, ORDERS + 1))


def waves(angle: Array) -> Array:
    """Return cosine and sine of every order (N, 2 orders)."""
    step = np.multiply.accumulate(np.repeat(np.exp(1j * angle)[:, None], ORDERS, axis=1), axis=1)
    out: Array = np.stack([step.real, step.imag], axis=2).reshape(len(angle), -1)
    return out


def shape(corner: float) -> Array:
    """Return how the variance of coefficients goes with the order (orders,)."""
    out: Array = (1 + (np.arange(1, ORDERS + 1) / corner) ** 2) ** -2.0
    return out


@dataclass(frozen=True)
class Sized:
    """How large the errors of joints are before the readings, by the largest evidence.

    Attributes
    ----------
    limbs : tuple of int
        Joints (from 1).
    corner : float
        Order beyond which coefficients become small.
    prior : (2 orders,) array
        Variances of the coefficients of a joint, but for a common factor.
    variance, noise : float
        The common factor, and the variance of the whitened readings.
    evidence : float
        Logarithm of the likelihood.
    """

    limbs: tuple[int, ...]
    corner: float
    prior: Array
    variance: float
    noise: float
    evidence: float


class Coefficients(NamedTuple):
    """The error of a joint: cosine and sine of each order (2 orders,) [rad], and their covariance [rad2].

    `rms` and `std` are those of the error and of its standard deviation over the readings [rad], but for a constant.
    """

    values: Array
    covariance: Array
    rms: float
    std: float


class Orders:
    """Normal equations of geometry, instrument and effects with all orders of some joints, part by part.

    A joint's columns are its displacement of the readings times functions of its angle: their products are sums over
    the rows of products of functions, and the columns themselves are never formed.

    Parameters
    ----------
    at : Fit
        Geometry and other effects; linear from here.
    turns : (R, n_q) array
        Joints of the readings [rad].
    limbs : sequence of int
        Joints (from 1) that may have an error.
    parts : sequence of (train, test)
        Masks (R,) of readings, every reading in one test.
    held : mapping
        Of joints whose error, or part of it, is held in the fit but sought here: its coefficients (orders, 2) [rad].
    roots : sequence of (2 orders, 2 orders) arrays, optional
        Of each joint, L of what is sought, u, where its coefficients are L u; without them they are u.
    """

    def __init__(
        self,
        at: Fit,
        turns: Array,
        limbs: Sequence[int],
        parts: Sequence[tuple[np.ndarray, np.ndarray]],
        held: Mapping[int, Array],
        roots: Sequence[Array] = (),
    ) -> None:
        problem = at.problem
        machine = at.machine
        state = problem.linearise(at.errors, at.instrument, machine)
        J, _ = at.instrument.linearise(problem.readings, problem.seen(machine), problem.displacements(machine))
        self._J = J[:, :, [j - 1 for j in limbs]]
        self._F = [waves(turns[:, j - 1]) for j in limbs]
        self._F = [F @ L for F, L in zip(self._F, roots, strict=True)] if roots else self._F
        self._limbs = tuple(limbs)
        self._y = state.residual
        for i, j in enumerate(limbs):
            if j in held:
                self._y = self._y + self._J[:, :, i] * (self._F[i] @ held[j].ravel())[:, None]
        self._raw = np.concatenate([state.J_p * problem.scale, state.J_m], axis=2)
        self._n, self._problem = self._raw.shape[2], problem
        self._scale = np.concatenate([problem.scale, np.ones(state.J_m.shape[2])])
        self._held = (np.arange(self._n) < len(problem.scale)).astype(float)
        self._departure = np.append(at.departure, np.zeros(state.J_m.shape[2]))
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
        every = np.concatenate([self._raw, self._y[..., None]], axis=2), self._J
        return [number**0.5 * in_unit_noise(values, read, at.sigma, at.weights, apart) for values in every]

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
        first = np.array([self._n + 1 + m * self._limbs.index(j) for j in limbs], dtype=int)
        return (first[:, None] + np.arange(m)).ravel()

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
        n, G = self._n, np.sum(self._grams, axis=0)
        H, g = self._normal(G, None)
        S = np.linalg.solve(H, np.column_stack([G[:n, n + 1 :], g]))
        coupling = G[n + 1 :, :n]
        rest = float(G[n, n] + self._noise * self._departure @ self._departure - g @ S[:, -1])
        return G[n + 1 :, n + 1 :] - coupling @ S[:, :-1], G[n + 1 :, n] - coupling @ S[:, -1], rest

    def _normal(self, G: Array, found: Sized | None) -> tuple[Array, Array]:
        """Return the normal equations of what is fitted, and then of the orders that are found, with their priors."""
        n, limbs, held = self._n, found.limbs if found else (), self._noise * self._held
        own = np.append(np.arange(n), self._places(limbs))
        H, g = G[np.ix_(own, own)], G[own, n]
        prior = found.noise / found.variance / np.tile(found.prior, len(limbs)) if found else np.zeros(0)
        H[np.diag_indices_from(H)] += np.append(held + jitter(np.diag(G)[:n]), prior)
        g[:n] -= held * self._departure
        return H, g

    def sized(self, limbs: Sequence[int], start: float) -> Sized:
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

    def _at_corner(self, limbs: Sequence[int], corner: float) -> Sized:
        return self.of_prior(limbs, corner, np.repeat(shape(corner), 2))

    def of_prior(self, limbs: Sequence[int], corner: float, prior: Array) -> Sized:
        """Return the common factor of a prior, and the noise, of the largest evidence; see `Sized`."""
        model = self._model(limbs, prior).diagonal()
        n, unit = len(model.s), len(model.s) / max(float((model.s**2).sum()), 1e-300)
        ratios, noise, _ = fit_sizes(model, np.zeros(n, dtype=int), (unit / RANGE, unit * RANGE))
        variance = max(float(ratios[0]), unit / RANGE) * noise
        evidence = model.evidence(np.full(n, variance), noise)
        return Sized(tuple(limbs), corner, prior, variance, noise, evidence)

    def _model(self, limbs: Sequence[int], prior: Array) -> MixedModel:
        """Return the mixed model of joints' coefficients in units of the roots of their prior variances."""
        own, (S, g, rest) = self._places(limbs) - self._n - 1, self._whole
        root = np.tile(np.sqrt(prior), len(limbs))
        return MixedModel.normal(root[:, None] * S[np.ix_(own, own)] * root, root * g[own], rest, self._scalars)

    def gain(self, found: Sized, without: int) -> float:
        """Return twice the logarithm of the evidence for the error of one of the joints."""
        kept = [j for j in found.limbs if j != without]
        model, variances = self._model(kept, found.prior), np.full(len(kept) * len(found.prior), found.variance)
        return 2 * (found.evidence - model.evidence(variances, found.noise if kept else model.noise(variances)))

    def solved(self, found: Sized) -> dict[int, Coefficients]:
        """Return the coefficients of each joint."""
        root = np.tile(np.sqrt(found.prior), len(found.limbs))
        model, out, m = self._model(found.limbs, found.prior), {}, 2 * ORDERS
        mean, covariance = model.posterior(np.full(len(root), found.variance), found.noise)
        for i, j in enumerate(found.limbs):
            own, F = slice(m * i, m * (i + 1)), self._F[self._limbs.index(j)]
            values, C = root[own] * mean[own], root[own] * covariance[own, own] * root[own, None]
            some = F[:: max(len(F) // SAMPLE, 1)] - F.mean(axis=0)  # a constant is the joint's zero
            std = float(np.sqrt(np.mean(((some @ C) * some).sum(axis=1))))
            out[j] = Coefficients(values, C, float(np.std(F @ values)), std)
        return out

    def covariance(self, found: Sized) -> Array:
        """Return the covariance of what is fitted beside orders that are as unknown as the readings leave them."""
        n, (H, _) = self._n, self._normal(np.sum(self._grams, axis=0), found)
        C = found.noise * np.linalg.solve(H, np.eye(len(H), n))[:n]
        covariance: Array = C * self._scale * self._scale[:, None]
        return covariance

    def borne_out(self, found: Sized) -> tuple[float, float] | None:
        """Return RMS [mm] of held-out readings without and with the errors; None where these do not prove them."""
        before, after = (lengths(self.held_out(f), self._problem.readings.kind) for f in (None, found))
        pose = stands(self._problem.readings, self._problem.recording)
        better = np.bincount(pose, np.nansum(before**2 - after**2, axis=1))[np.bincount(pose) > 0]
        proven = better.sum() > PROVEN * float(np.std(better)) * np.sqrt(len(better))
        return (rms(before), rms(after)) if proven else None

    def without(self, errors: Mapping[int, np.ndarray]) -> Orders:
        """Return the same of readings in which errors (2 orders,) [rad] that are held in the fit stand again."""
        out, T = copy.copy(self), np.eye(len(self._grams[0]))
        for j, values in errors.items():
            i = self._limbs.index(j)
            out._y = out._y + self._J[:, :, i] * (self._F[i] @ values)[:, None]
            T[self._places([j]), self._n] = values
        out._grams = [T.T @ G @ T for G in self._grams]
        vars(out).pop("_whole", None)
        return out

    def held_out_rms(self, found: Sized | None) -> float:
        """Return the RMS [mm] of readings held out, beside no errors but those that are held where `found` is None."""
        return rms(lengths(self.held_out(found), self._problem.readings.kind))

    def held_out(self, found: Sized | None) -> Array:
        """Return the errors (R, k) of readings by fits that have not seen them; nan of gross errors."""
        whole, n, out = np.sum(self._grams, axis=0), self._n, np.full(self._y.shape, np.nan)
        for test, gram in zip(self._tests, self._grams, strict=True):
            u = np.linalg.solve(*self._normal(whole - gram, found))
            left = self._y[test] - self._raw[test] @ u[:n]
            for j, values in zip(found.limbs if found else (), u[n:].reshape(-1, 2 * ORDERS), strict=True):
                i = self._limbs.index(j)
                left -= self._J[test][:, :, i] * (self._F[i][test] @ values)[:, None]
            out[test] = left
        out[~self._quiet] = np.nan
        return out
