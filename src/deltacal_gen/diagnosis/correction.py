"""What no effect explains, corrected without physics: a smooth displacement of joints or of the reading.

The displacement is a function of one variable that was recorded, a Gaussian process on few knots (subset of
regressors; Rasmussen and Williams 2006, section 8.3.1), fitted together with geometry, instrument and effects. The
variable, the length over which the function varies and its size are chosen by held-out poses, and so is whether there
is a correction at all. It holds where there were readings; beyond them the machine is as it is without.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.structure import Structure, displacements
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.fit import Fit, fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths, rms, robust_sigma, robust_weights
from deltacal_gen.estimation.solvers import Prior, jitter
from deltacal_gen.instrument.instrument import Instrument
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import SmoothState
from deltacal_gen.units import joint_factors, joint_names

CANDIDATES = 3  # structures that are tried, the strongest first
KNOTS = 32
LENGTHS = (0.05, 0.1, 0.2, 0.4)  # over which a function varies, parts of the diagonal of what was measured
SIZES = (1.0, 4.0, 16.0)  # standard deviations of noise by which a function may well move the readings
PROVEN = 3.0  # standard deviations by which held-out poses must be better
JITTER = 1e-8  # of a knot's variance: knots that say nearly the same
POSITION = "position"


@dataclass(frozen=True)
class Smooth:
    """A smooth function of a variable that displaces joints, or the platform along the axes of {O}.

    Attributes
    ----------
    variable : str
        A channel, a joint (`q1_deg`) or the `position` in {O}.
    limbs : tuple of int
        Limbs (from 1) whose joints it displaces; empty for the platform.
    knots : (K, d) array
        Values of the variable, in its own unit.
    length : float
        Over which the function varies, in the same unit.
    reach : float
        Within which of a knot everything lies that was measured.
    coefficients : (K, limbs or 3) array
        [rad, mm]
    """

    variable: str
    limbs: tuple[int, ...]
    knots: Array
    length: float
    reach: float
    coefficients: Array

    def displacement(self, values: Array) -> Array:
        """Return the displacement (N, limbs or 3) at values (N, d) of the variable [rad, mm]."""
        out: Array = np.nan_to_num(_kernel(values, self.knots, self.length)) @ self.coefficients
        return out

    def share(self, values: Array) -> Array:
        """Return which part (N,) of the correction holds: 1 where there were readings, 0 far off or where blank."""
        gap = np.maximum(_gaps(values, self.knots).min(axis=1) - self.reach * (1 + JITTER), 0.0)
        out: Array = np.where(np.isfinite(gap), np.exp(-0.5 * np.nan_to_num(gap / self.length) ** 2), 0.0)
        return np.where(out < 0.01, 0.0, out)

    def kept(self) -> SmoothState:
        """Return what an answer keeps of it."""
        return SmoothState(**{field.name: getattr(self, field.name) for field in dataclasses.fields(self)})

    @staticmethod
    def of(kept: SmoothState) -> Smooth:
        """Return the function that an answer kept."""
        return Smooth(kept.variable, kept.limbs, kept.knots, kept.length, kept.reach, kept.coefficients)


@dataclass(frozen=True)
class Correction:
    """A smooth function, and geometry, effects and instrument as they are beside it.

    Attributes
    ----------
    errors : (n_p,) array
        Source errors [mm, rad].
    heldout : (float, float)
        RMS [mm] of readings that took part neither in the fit nor in its choices, without and with the correction.
    size : float
        RMS [mm] by which it moves the readings beyond what geometry would make up for.
    """

    smooth: Smooth
    errors: Array
    terms: tuple[Term, ...]
    instrument: Instrument
    heldout: tuple[float, float]
    size: float


def variable(name: str, recording: Recording, q: Array, x: Array) -> Array | None:
    """Return the values (N, d) of a variable of a recording, None if it has none.

    Parameters
    ----------
    q : (N, n_q) array
        Joints as the geometry counts them.
    x : (N, 12) array
        Poses.
    """
    if name == POSITION:
        return x[:, :3]
    if name in recording.channels:
        return recording.channels[name][:, None]
    names, unit = joint_names(recording.joint_unit, q.shape[1]), joint_factors(recording.joint_unit, q.shape[1])
    return dict(zip(names, (q / unit).T[:, :, None], strict=True)).get(name)


def correct(
    at: Fit, whole: Fit, left: Sequence[Structure], parts: Sequence[tuple[np.ndarray, np.ndarray]]
) -> Correction | None:
    """Return the smooth correction that held-out poses bear out, None where they bear out none.

    What it depends on is chosen in the machine made linear; what it then is worth is measured as predictions use it: in
    the exact machine, geometry, effects and instrument fitted anew beside it, fading where there were no readings.

    Parameters
    ----------
    at : Fit
        Of the readings that `left` and `parts` are of.
    whole : Fit
        Of all readings, with the same effects: the correction is fitted to them.
    left : sequence of Structure
        What is left of the fit, the strongest first.
    parts : sequence of (train, test)
        Masks (R,) of readings; repeats of a pose stay together.
    """
    variables = [s for s in left if s.earned > 0][:CANDIDATES]
    first = _Linear(at, parts, at.weights)
    chosen = first.best(options := first.options(variables), set())
    if chosen is None:
        return None
    # what is left out looked like gross errors where it is strongest
    r, found = first.errors(first.step(chosen, set()), chosen), at.problem.readings
    sigma = robust_sigma(r, np.zeros(found.kind.noises), True, found)
    linear = _Linear(at, parts, robust_weights(r, sigma, found.kind))
    options = linear.options(variables)
    # every part is predicted by what the other parts choose and fit
    without, corrected = [], []
    for k, (train, test) in enumerate(parts):
        before = linear.errors(linear.step(None, {k}), None, test)
        without.append(before)
        corrected.append(_predicted(at, linear, linear.best(options, {k}), k, train, test, before))
    order = np.concatenate([np.flatnonzero(test) for _, test in parts])
    quiet = linear.weights[order] > 0
    before, after = (lengths(np.concatenate(errors)[quiet], found.kind) for errors in (without, corrected))
    gain = np.nansum(before**2 - after**2, axis=1)
    _, group = np.unique(at.problem.readings.group[order][quiet], return_inverse=True)
    better = np.bincount(group, gain)
    spread = float(np.std(better)) * np.sqrt(len(better))
    option = linear.best(options, set())
    if option is None or better.sum() <= PROVEN * spread:
        return None
    step, base = linear.step(option, set()), linear.step(None, set())
    smooth = option.smooth(step[len(base) :])
    fitted = _beside(whole, smooth)
    if fitted is None:
        return None
    source, _ = whole.problem.split(fitted.errors)
    return Correction(
        smooth=smooth,
        errors=source[: len(whole.problem.mechanism.parameters)],
        terms=whole.problem.acting(fitted.errors),
        instrument=fitted.instrument,
        heldout=(rms(before), rms(after)),
        size=rms(lengths(linear.errors(base, None) - linear.errors(step, option), found.kind)),
    )


def _predicted(
    at: Fit,
    linear: _Linear,
    option: _Option | None,
    k: int,
    train: np.ndarray,
    test: np.ndarray,
    plain: Array,
) -> Array:
    """Return the errors (test, k) of readings as predictions with a correction make them, fitted to the other parts.

    `plain` are the errors without it, which hold where it does not.
    """
    if option is None:
        return plain
    smooth = option.smooth(linear.step(option, {k})[len(linear.step(None, {k})) :])
    fitted = _beside(at, smooth, train)
    if fitted is None:
        return plain
    problem = displaced(at, smooth, at.problem)
    machine = problem.solve(fitted.errors)
    moved = problem.residual(fitted.errors, fitted.instrument, problem.seen(machine))[test]
    values = variable(smooth.variable, problem.recording, at.problem.body.q, at.machine.x)
    assert values is not None  # the option was made of it
    holds = smooth.share(values)[at.problem.readings.rows[test]].min(axis=1)[:, None]
    out: Array = plain + holds * (moved - plain)
    return out


def _beside(at: Fit, smooth: Smooth, chosen: np.ndarray | None = None) -> Fit | None:
    """Return the fit of geometry, effects and instrument beside a smooth function, to some of the readings."""
    problem = displaced(at, smooth, at.problem)
    problem = problem if chosen is None else problem.subset(np.flatnonzero(chosen))
    try:
        return fit(problem, Prior(), errors=at.errors, instrument=at.instrument, must_converge=False, tolerance=0.1)
    except (NoSolutionError, InputError):
        return None


def displaced(at: Fit, smooth: Smooth, problem: Problem) -> Problem:
    """Return a problem whose joints, or whose readings, are moved by a smooth function as predictions move them."""
    body = problem.body
    values = variable(smooth.variable, problem.recording, body.q, at.machine.x)
    if values is None:
        return problem
    moved = np.nan_to_num(smooth.displacement(values)) * smooth.share(values)[:, None]
    if smooth.limbs:
        q = body.q.copy()
        q[:, [i - 1 for i in smooth.limbs]] += moved
        return dataclasses.replace(problem, body=Body(body.robot, body.mechanism, q, body.tool, body.channels))
    x = at.machine.x
    instrument = at.instrument.mounted(problem.mechanism, at.errors)
    there, _ = instrument.predict(problem.readings, np.hstack([x[:, :3] + moved, x[:, 3:]]))
    here, _ = instrument.predict(problem.readings, x)
    readings = dataclasses.replace(problem.readings, values=problem.readings.values - (there - here))
    return dataclasses.replace(problem, readings=readings)


@dataclass(frozen=True)
class _Option:
    """A variable, length and size to choose from; columns (R, k, K * carriers) and (scalars, ...) of unit size."""

    like: Smooth
    to_knots: Array
    raw: Array
    whitened: Array
    scale: Array
    size: float

    def smooth(self, c: Array) -> Smooth:
        """Return the function with coefficients in units of its size."""
        values = (c * self.scale * self.size).reshape(self.to_knots.shape[1], -1)
        return dataclasses.replace(self.like, coefficients=self.to_knots @ values)


class _Linear:
    """The machine made linear at a fit: steps of geometry, effects, instrument and a smooth function together."""

    def __init__(self, at: Fit, parts: Sequence[tuple[np.ndarray, np.ndarray]], weights: Array) -> None:
        problem = at.problem
        self._fit, self._beside = at, Beside(at)
        machine = self._beside.machine
        self._x, self._seen, self._dx = machine.x, problem.seen(machine), displacements(problem, machine)
        state = problem.linearise(at.errors, at.instrument, machine)
        self._residual, self.weights = state.residual, weights
        self._raw = np.concatenate([state.J_p * problem.scale, state.J_m], axis=2)
        self._base = self._rows(self._raw)
        self._target = self._rows(state.residual[..., None])[:, 0]
        departure = (at.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
        self._prior = np.concatenate([departure, np.zeros(self._base.shape[1] - len(departure))])
        self._held = (np.arange(self._base.shape[1]) < len(departure)).astype(float)
        self._tests = [test[self._beside.owner] for _, test in parts]
        self._grams: dict[object, list[tuple[Array, Array]]] = {}

    def _rows(self, values: Array) -> Array:
        return self._beside.rows(values * np.sqrt(self.weights)[:, None, None])

    def options(self, found: Sequence[Structure]) -> list[_Option | None]:
        """Return what there is to choose from: no function, or one of the variables of structures."""
        return [None, *(option for s in found for option in self._along(s))]

    def _along(self, found: Structure) -> Iterator[_Option]:
        """Yield smooth functions of the variable of a structure, at the joints or in the reading where it sits."""
        problem = self._fit.problem
        used = np.unique(problem.readings.rows)
        values = variable(found.channel, problem.recording, problem.body.q, self._x)
        if problem.readings.kind.sees_joints and not found.limbs:
            return
        if values is None or not (known := used[np.isfinite(values[used]).all(axis=1)]).size:
            return
        knots = _knots(values[known], KNOTS)
        reach = float(_gaps(values[known], knots).min(axis=1).max())
        span = float(np.linalg.norm(np.ptp(values[known], axis=0)))
        n_q = problem.mechanism.limbs
        carriers = [i - 1 for i in found.limbs] or list(range(n_q, self._dx.shape[2]))
        dx = self._dx[:, :, carriers]
        J, _ = self._fit.instrument.linearise(problem.readings, self._seen, dx)
        seen = self._rows(J)
        unit = np.sqrt(np.mean(seen**2, axis=0))
        scale = np.where(unit > 0, 1 / np.maximum(unit, 1e-300), 0.0)
        for part in LENGTHS:
            length = part * span
            U, s, _ = np.linalg.svd(_kernel(knots, knots, length), hermitian=True)
            keep = s > JITTER * s[0]
            to_knots = U[:, keep] / np.sqrt(s[keep])
            f = np.nan_to_num(_kernel(values, knots, length)) @ to_knots
            moved = (dx * scale)[:, :, None] * f[:, None, :, None]
            raw, _ = self._fit.instrument.linearise(problem.readings, self._seen, moved.reshape(*dx.shape[:2], -1))
            like = Smooth(found.channel, found.limbs, knots, length, reach, np.zeros((len(knots), len(carriers))))
            whitened, many = self._rows(raw), np.tile(scale, f.shape[1])
            for size in SIZES:
                yield _Option(like, to_knots, raw, whitened, many, size)

    def step(self, option: _Option | None, without: set[int]) -> Array:
        """Return the step that fits all parts but some: geometry and effects in their scales, instrument, function."""
        G, g = self._normal(option, without)
        n = len(self._held)
        prior = np.concatenate([self._held, np.ones(len(g) - n)])
        size = np.concatenate([np.ones(n), np.full(len(g) - n, option.size if option else 1.0)])
        G, g = G * size * size[:, None], g * size
        g[:n] -= self._prior
        G[np.diag_indices_from(G)] += prior + jitter(np.diag(G))
        u: Array = np.linalg.solve(G, g)
        return u

    def best(self, options: Sequence[_Option | None], without: set[int]) -> _Option | None:
        """Return the option that predicts each of the other parts best from the rest."""
        losses = []
        for option in options:
            loss = 0.0
            for k in set(range(len(self._tests))) - without:
                u = self.step(option, without | {k})
                u[len(self._held) :] *= option.size if option else 1.0
                G, g = self._gram(option)[k]
                loss += float(u @ G @ u - 2 * u @ g)  # beyond what the readings themselves are
            losses.append(loss)
        return options[int(np.argmin(losses))]

    def errors(self, step: Array, option: _Option | None, chosen: np.ndarray | slice = slice(None)) -> Array:
        """Return what a step leaves of readings (R, k) [mm, rad]."""
        n = len(self._held)
        moved = self._raw[chosen] @ step[:n]
        if option is not None:
            moved = moved + option.raw[chosen] @ (option.size * step[n:])
        left: Array = self._residual[chosen] - moved
        return left

    def _normal(self, option: _Option | None, without: set[int]) -> tuple[Array, Array]:
        kept = [gram for k, gram in enumerate(self._gram(option)) if k not in without]
        return np.sum([G for G, _ in kept], axis=0), np.sum([g for _, g in kept], axis=0)

    def _gram(self, option: _Option | None) -> list[tuple[Array, Array]]:
        key = None if option is None else (option.like.variable, option.like.length)
        if key not in self._grams:
            A = self._base if option is None else np.hstack([self._base, option.whitened])
            self._grams[key] = [(A[t].T @ A[t], A[t].T @ self._target[t]) for t in self._tests]
        return self._grams[key]


def _gaps(values: Array, knots: Array) -> Array:
    gaps: Array = np.linalg.norm(values[:, None] - knots, axis=2)
    return gaps


def _kernel(values: Array, knots: Array, length: float) -> Array:
    out: Array = np.exp(-0.5 * (_gaps(values, knots) / length) ** 2)
    return out


def _knots(values: Array, most: int) -> Array:
    """Return up to `most` of the values (N, d): the farthest from all knots so far, again and again."""
    knots = values[:1]
    while len(knots) < most:
        gap = _gaps(values, knots).min(axis=1)
        if gap.max() == 0:
            break
        knots = np.vstack([knots, values[np.argmax(gap)]])
    return knots
