"""Random functions of unknown size, beside geometry, instrument and effects, by parts of the readings.

A random function displaces joints, or the platform along the axes of {O}, by a combination of functions of the row with
coefficients c ~ N(0, size D): any smooth function of a channel, all orders of a joint's periodic error. Size and noise
are those of the largest evidence, with all that is fitted integrated out (restricted likelihood; Patterson and Thompson
1971); coefficients are those of the posterior. Readings held out are predicted by the fits to the other parts, and say
whether that is confirmed: evidence chooses, and they decide.

Rows that are correlated count by their effective number: what whitens them would mix functions of different rows.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence, Set
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths
from deltacal_gen.estimation.series import sequence
from deltacal_gen.estimation.solvers import jitter
from deltacal_gen.estimation.system import whitened
from deltacal_gen.identification.folds import stands
from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.inference.sizes import fit_sizes
from deltacal_gen.machine.registry import Array

RANGE = 1e8  # of the variance of coefficients, either way of the one that brings readings that of their noise
PROVEN = 3.0  # standard deviations by which held-out poses must be better
SAME_NOISE = 1.5  # times: variances of noise that differ less weigh priors alike
NONE: Set[int] = frozenset()


@dataclass(frozen=True, eq=False)
class Function:
    """Functions (N, m) of the rows of a recording, each of which displaces some places for itself.

    `places` are columns of `Problem.displacements`: joints from 0, then the axes of {O}. Coefficients are (m * places,)
    [rad, mm], those of one function together.
    """

    values: Array
    places: tuple[int, ...]


class Functions(NamedTuple):
    """Functions that act together, and the products of all columns in each part of the readings.

    Of n columns that are fitted, the readings themselves, and then each function's.
    """

    each: tuple[Function, ...]
    products: tuple[Array, ...]

    def parted(self, values: np.ndarray) -> list[np.ndarray]:
        """Return values (n, ...) of all coefficients function by function."""
        return np.split(values, np.cumsum([f.values.shape[1] * len(f.places) for f in self.each], dtype=int))[:-1]


class Sized(NamedTuple):
    """How large functions are before the readings: c ~ N(0, variance D), in whitened rows of variance `noise`.

    `evidence` is the logarithm of the likelihood.
    """

    functions: Functions
    D: Array
    variance: float
    noise: float
    evidence: float


class Linear:
    """The machine made linear at a fit, with random functions beside all that is fitted.

    Parameters
    ----------
    parts : sequence of (train, test)
        Masks (R,) of readings, no reading in two tests; repeats of a pose stay together.
    put_back : iterable of (Function, coefficients)
        That are held in the fit, but stand in the readings here.

    Attributes
    ----------
    residual : (R, k) array
        What is measured beyond the machine.
    n : int
        Number of columns that are fitted.
    """

    def __init__(
        self,
        at: Fit,
        parts: Sequence[tuple[np.ndarray, np.ndarray]],
        put_back: Iterable[tuple[Function, Array]] = (),
    ) -> None:
        problem, machine = at.problem, at.machine
        state = problem.linearise(at.errors, at.instrument, machine)
        self._fit = at
        self._dx, self._seen = problem.displacements(machine), problem.seen(machine)
        self._tests, every = [test for _, test in parts], np.ones(len(problem.readings), dtype=bool)
        self.residual: Array = state.residual + sum(self.moved(f, every) @ c for f, c in put_back)
        self._raw = np.concatenate([state.J_p * problem.scale, state.J_m], axis=2)
        self.n, free = self._raw.shape[2], np.zeros(state.J_m.shape[2])
        self._scale, self._departure = np.append(problem.scale, free + 1), np.append(at.departure, free)
        self._prior = np.append(np.ones(len(problem.scale)), free)
        self._number = 1 / at.repeats.rows
        self._noise = 1.0  # of the whitened readings: against it priors weigh
        self.alone = self.sized(self.functions([]), np.zeros(0))

    def functions(self, each: Sequence[Function]) -> Functions:
        """Return functions that act together."""
        return Functions((*each,), tuple(self._products(each, test) for test in self._tests))

    def _products(self, each: Sequence[Function], chosen: np.ndarray) -> Array:
        columns = [self._raw[chosen], self.residual[chosen, :, None], *(self.moved(f, chosen) for f in each)]
        fit, read = self._fit, np.isfinite(self.residual[chosen])
        apart = dataclasses.replace(fit.repeats, series=None, group=fit.repeats.group[chosen])
        A = whitened(np.concatenate(columns, axis=2), read, fit.sigma, fit.weights[chosen], apart)
        return np.asarray(self._number * (A.T @ A))

    def moved(self, function: Function, chosen: np.ndarray) -> Array:
        """Return by how much each coefficient of a function moves some readings, (R, k, m * places)."""
        found = self._fit.problem.readings.subset(chosen)
        used, rows = np.unique(found.rows, return_inverse=True)
        dx = self._dx[used][:, :, None, function.places] * function.values[used][:, None, :, None]
        own = dataclasses.replace(found, rows=rows.reshape(found.rows.shape))
        return self._fit.instrument.linearise(own, self._seen[used], dx.reshape(*dx.shape[:2], -1))[0]

    def units(self, functions: Functions) -> Array:
        """Return D of functions, each of which brings each of its places' readings the variance of their noise."""
        square = np.diag(np.sum(functions.products, axis=0))[self.n + 1 :] / self._scalars(NONE)
        unit = [np.zeros(0)]
        for f, own in zip(functions.each, functions.parted(square), strict=True):
            by_place = own.reshape(-1, len(f.places)).sum(axis=0)
            unit.append(np.tile(np.where(by_place > 0, 1 / np.maximum(by_place, 1e-300), 0.0), f.values.shape[1]))
        return np.concatenate(unit)

    def _scalars(self, without: Set[int]) -> float:
        """Return the effective number of scalars that are read, but for those of some parts."""
        read = np.isfinite(self.residual) & (self._fit.weights > 0)[:, None]
        return self._number * float(sum(read[test].sum() for k, test in enumerate(self._tests) if k not in without))

    def _whole(self, functions: Functions, noise: float, without: Set[int] = NONE) -> Array:
        """Return the products of all columns, the priors of what is fitted among them."""
        n, G = self.n, np.sum([G for k, G in enumerate(functions.products) if k not in without], axis=0)
        held = noise * self._prior
        G[:n, :n] += np.diag(held + jitter(np.diag(G)[:n]))
        G[:n, n] -= held * self._departure
        G[n, :n] = G[:n, n]
        G[n, n] += held @ self._departure**2
        return G

    def _model(self, functions: Functions, D: Array, without: Set[int]) -> tuple[MixedModel, float]:
        """Return the mixed model of coefficients in units of D, and what of log p does not depend on their size."""
        n, G = self.n, self._whole(functions, self._noise, without)
        H = G[:n, :n]
        S = G[n:, n:] - G[n:, :n] @ np.linalg.solve(H, G[:n, n:])
        free = n - self._noise * float(self._prior @ np.diag(np.linalg.inv(H)))  # directions that readings determine
        apart = 0.5 * ((n - free) * np.log(2 * np.pi * self._noise) - float(np.linalg.slogdet(H)[1]))
        root, scalars = np.sqrt(D), max(self._scalars(without) - free, 1.0)
        return MixedModel.normal(root[:, None] * S[1:, 1:] * root, root * S[1:, 0], float(S[0, 0]), scalars), apart

    def sized(self, functions: Functions, D: Array, without: Set[int] = NONE) -> Sized:
        """Return the size of functions, and the noise, of the largest evidence."""
        found = self._sized(functions, D, without)
        if not 1 / SAME_NOISE < found.noise / self._noise < SAME_NOISE:
            self._noise = found.noise
            found = self._sized(functions, D, without)
        return found

    def _sized(self, functions: Functions, D: Array, without: Set[int] = NONE) -> Sized:
        model, apart = self._model(functions, D, without)
        diagonal, m = model.diagonal(), len(model.s)
        unit = m / max(float((model.s**2).sum()), 1e-300)
        ratios, noise, _ = fit_sizes(diagonal, np.zeros(m, dtype=int), (unit / RANGE, unit * RANGE))
        variance = float(ratios.sum()) * noise
        return Sized(functions, D, variance, noise, apart + diagonal.evidence(np.full(m, variance), noise))

    def gain(self, found: Sized, kept: Array) -> float:
        """Return twice the logarithm of the evidence for functions beside those that are kept, of which D is `kept`."""
        return 2 * (found.evidence - self._sized(found.functions, kept).evidence)

    def _normal(self, found: Sized, without: Set[int] = NONE) -> tuple[Array, Array]:
        """Return the normal equations of what is fitted and of functions, with their priors."""
        G = self._whole(found.functions, found.noise, without)
        H, g = np.delete(np.delete(G, self.n, axis=0), self.n, axis=1), np.delete(G[:, self.n], self.n)
        H[self.n :, self.n :] += np.diag(found.noise / np.maximum(found.variance * found.D, 1e-300))
        return H, g

    def step(self, found: Sized, without: Set[int] = NONE) -> Array:
        """Return the step of what is fitted, in its scales, and the coefficients, by all parts but some."""
        return np.asarray(np.linalg.solve(*self._normal(found, without)))

    def covariance(self, found: Sized) -> Array:
        """Return the covariance of what is fitted [mm, rad], and of the coefficients."""
        scale = np.append(self._scale, np.ones(len(found.D)))
        return np.asarray(found.noise * np.linalg.inv(self._normal(found)[0]) * scale * scale[:, None])

    def moves(self, functions: Functions, step: Array, chosen: np.ndarray) -> list[Array]:
        """Return by how much each function moves some readings (R, k) [mm, rad] in a step."""
        each = zip(functions.each, functions.parted(step[self.n :]), strict=True)
        return [self.moved(f, chosen) @ own for f, own in each]

    def errors(self, found: Sized, step: Array, chosen: np.ndarray) -> Array:
        """Return what a step leaves of some readings (R, k) [mm, rad]."""
        left = self.residual[chosen] - self._raw[chosen] @ step[: self.n]
        return np.asarray(left - sum(self.moves(found.functions, step, chosen)))

    def held_out(self, found: Sized) -> Array:
        """Return the errors (R, k) of readings by fits that have not seen them; nan of gross errors."""
        out = np.full(self.residual.shape, np.nan)
        for k, test in enumerate(self._tests):
            out[test] = self.errors(found, self.step(found, {k}), test)
        out[self._fit.weights == 0] = np.nan
        return out


def confirmed(problem: Problem, before: Array, after: Array) -> bool:
    """Tell whether held-out errors (R, k) of readings that become less are no chance, by poses in the order of reading.

    All together, or each by its own part: a misfit that sits at few poses shows in the sum, one that is everywhere in
    the parts, which none outweighs.
    """
    found, recording = problem.readings, problem.recording
    _, some, pose = np.unique(stands(found, recording), return_index=True, return_inverse=True)  # not every was read
    order = np.argsort(sequence(found, recording)[some], kind="stable")
    squares = [np.nansum(lengths(errors, found.kind) ** 2, axis=1) for errors in (before, after)]
    a, b = (np.bincount(pose, each).astype(float)[order] for each in squares)
    seen = a + b > 0
    gain, total = (a - b)[seen], (a + b)[seen]
    return bool(gain.sum() > 0) and max(_score(gain), _score(gain / total)) > PROVEN


def _score(gain: Array) -> float:
    """Return a mean gain in standard deviations.

    Neighbours that correlate by r tell as much as the part (1 - r) / (1 + r) of their number.
    """
    apart = gain - gain.mean()
    size = max(float(apart @ apart), 1e-300)
    r = max(float(apart[1:] @ apart[:-1]) / size, 0.0)
    return float(gain.sum() / np.sqrt(size * (1 + r) / (1 - r)))
