"""What no effect explains, corrected without physics: a smooth displacement of joints or of the reading.

The displacement is a function of one variable that was recorded, a Gaussian process on few knots (subset of
regressors; Rasmussen and Williams 2006, section 8.3.1), fitted together with geometry, instrument and effects. The
variable, the length over which the function varies and its size are chosen by held-out poses, and so is whether there
is a correction at all. It holds where there were readings; beyond them the machine is as it is without.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.structure import Structure, structures
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths, rms, robust_sigma, robust_weights
from deltacal_gen.estimation.series import sequence
from deltacal_gen.estimation.solvers import Prior, jitter
from deltacal_gen.identification.folds import folds, stands
from deltacal_gen.identification.together import rows_alone
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import SmoothState
from deltacal_gen.units import joint_factors, joint_names

CANDIDATES = 3  # structures that are tried, the strongest first
LENGTHS = (0.025, 0.05, 0.1, 0.2, 0.4)  # over which a function varies, parts of the diagonal of what was measured
KNOTS = 40  # so many as the shortest of them has in a row
SIZES = (1.0, 4.0, 16.0)  # standard deviations of noise by which a function may well move the readings
PROVEN = 3.0  # standard deviations by which held-out poses must be better
STEPS = 1024  # over a function's range, at which its waves are looked at
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

    def waves(self) -> tuple[float, tuple[float, ...]]:
        """Return the RMS [rad, mm] of a joint's function of one variable, and the lengths of the waves that carry most.

        Over the range of the knots, what goes straight through it taken off; lengths in the variable's unit, the
        strongest first, together half of the square.
        """
        v = np.linspace(self.knots.min(), self.knots.max(), STEPS)
        moved = self.displacement(v[:, None])[:, 0]
        moved = moved - np.polynomial.Polynomial.fit(v, moved, 1)(v)
        power = np.abs(np.fft.rfft(moved)[1:]) ** 2
        order = np.argsort(-power)
        most = 1 + int(np.searchsorted(np.cumsum(power[order]), 0.5 * power.sum()))
        return float(np.std(moved)), tuple(float(np.ptp(v) / (k + 1)) for k in order[:most])

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
    row_by_row : bool
        Whether these were held out without the rows around them, whose noise may hang together with theirs.
    size : float
        RMS [mm] by which it moves the readings beyond what geometry would make up for.
    each : tuple of float
        RMS [mm] by which each of the functions moves them alone.
    """

    smooth: tuple[Smooth, ...]
    errors: Array
    terms: tuple[Term, ...]
    instrument: Instrument
    heldout: tuple[float, float]
    row_by_row: bool
    size: float
    each: tuple[float, ...]

    @property
    def moving(self) -> tuple[Smooth, ...]:
        """Functions that move something; the others only say where these hold."""
        return self.smooth[: len(self.each)]


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


def displacement(functions: Sequence[Smooth], recording: Recording, q: Array, x: Array) -> tuple[Array, Array]:
    """Return by how much smooth functions move the joints (N, n_q) [rad, mm] and the platform (N, 3) [mm] of each row.

    `q` and `x` as in `variable`; what goes with a variable that a recording lacks is zero.
    """
    joints, shift = np.zeros_like(q), np.zeros((len(x), 3))
    for smooth in functions:
        if (values := variable(smooth.variable, recording, q, x)) is None:
            continue
        moved = smooth.displacement(values)
        if smooth.limbs:
            joints[:, [i - 1 for i in smooth.limbs]] += moved
        else:
            shift += moved
    return joints, shift


def holding(functions: Sequence[Smooth], recording: Recording, q: Array, x: Array) -> Array:
    """Return which part (N,) of smooth functions holds in each row: together they do where each of them does."""
    out = np.ones(len(x))
    for smooth in functions:
        values = variable(smooth.variable, recording, q, x)
        out = np.minimum(out, 0.0 if values is None else smooth.share(values))
    return out


@dataclass(frozen=True)
class BorneOut:
    """Smooth functions that held-out poses bear out.

    Attributes
    ----------
    at : Fit
        That they were chosen beside.
    without, corrected : (R, k) array
        Errors [mm, rad] of held-out readings; nan of gross errors.
    row_by_row : bool
        Whether neighbours, whose noise may hang together with theirs, were not held out with them.
    """

    at: Fit
    linear: _Linear
    option: _Option
    without: Array
    corrected: Array
    row_by_row: bool

    @property
    def heldout(self) -> tuple[float, float]:
        """RMS [mm] of held-out readings without the functions and with them."""
        kind = self.at.problem.readings.kind
        return rms(lengths(self.without, kind)), rms(lengths(self.corrected, kind))

    def of_all(self, whole: Fit) -> Correction | None:
        """Return the correction with geometry, effects and instrument fitted to all readings beside it."""
        base = self.linear.step(None, set())
        step = self.linear.step(self.option, set())
        functions = tuple(_moved(smooth, self.at, whole) for smooth in self.option.smooth(step[len(base) :]))
        fitted = _beside(whole, functions)
        if fitted is None:
            return None
        kind, (source, _) = self.at.problem.readings.kind, whole.problem.split(fitted.errors)
        by_functions = self.linear.errors(base, None) - self.linear.errors(step, self.option)
        return Correction(
            smooth=functions,
            errors=source[: len(whole.problem.mechanism.parameters)],
            terms=whole.problem.acting(fitted.errors),
            instrument=fitted.instrument,
            heldout=self.heldout,
            row_by_row=self.row_by_row,
            size=rms(lengths(by_functions, kind)),
            each=tuple(rms(lengths(moved, kind)) for moved in self.option.moved(step[len(base) :])),
        )


def borne_out_beside(at: Fit, left: Sequence[Structure]) -> BorneOut | None:
    """Return the smooth functions that held-out poses bear out, None where they bear out none.

    What they depend on is chosen in the machine made linear; what they then are worth is measured as predictions use
    them: in the exact machine, geometry, effects and instrument fitted anew beside them, fading where there were no
    readings. Of readings that hang together no more count than tell something of their own.

    Parameters
    ----------
    left : sequence of Structure
        What is left of the fit, the strongest first.
    """
    # along a path functions of the joints hang together as noise does, which then stands for them
    if alike := at.repeats.rows > 1:
        at = rows_alone(at)
        left = structures(at)
    parts = folds(at.problem.readings, at.problem.recording)
    variables = [s for s in left if s.earned > 0][:CANDIDATES]
    first = _Linear(at, parts, at.weights)
    chosen = first.best(first.options(variables), set())
    if chosen is None:
        return None
    # what is left out looked like gross errors where it is strongest
    r, found = first.errors(first.step(chosen, set()), chosen), at.problem.readings
    sigma = robust_sigma(r, np.zeros(found.kind.noises), True, found)
    linear = _Linear(at, parts, robust_weights(r, sigma, found.kind))
    option = linear.best(options := linear.options(variables), set())
    if option is None:
        return None
    # every part is predicted by what the other parts choose and fit
    without, corrected = (np.full(at.residual.shape, np.nan) for _ in range(2))
    for k, (train, test) in enumerate(parts):
        without[test] = linear.errors(linear.step(None, {k}), None, test)
        corrected[test] = _predicted(at, linear, linear.best(options, {k}), k, train, test, without[test])
    without[linear.weights == 0] = corrected[linear.weights == 0] = np.nan
    made = BorneOut(at, linear, option, without, corrected, alike)
    poses = stands(found, at.problem.recording)
    _, some, pose = np.unique(poses, return_index=True, return_inverse=True)  # not every pose was read
    order = np.argsort(sequence(found, at.problem.recording)[some], kind="stable")
    squares = (np.nansum(lengths(errors, found.kind) ** 2, axis=1) for errors in (without, corrected))
    before, after = (np.bincount(pose, each).astype(float)[order] for each in squares)
    return made if _beyond_doubt(before, after) else None


def _beyond_doubt(before: Array, after: Array) -> bool:
    """Tell whether squares (poses,) of held-out errors that become less are no chance, poses in the order of reading.

    All together, or each by its own part: a misfit that sits at few poses shows in the sum, one that is everywhere in
    the parts, which none outweighs.
    """
    seen = before + after > 0
    gain, total = (before - after)[seen], (before + after)[seen]
    return bool(gain.sum() > 0) and max(_score(gain), _score(gain / total)) > PROVEN


def _score(gain: Array) -> float:
    """Return a mean gain in standard deviations.

    Neighbours that correlate by r tell as much as the part (1 - r) / (1 + r) of their number.
    """
    apart = gain - gain.mean()
    size = max(float(apart @ apart), 1e-300)
    r = max(float(apart[1:] @ apart[:-1]) / size, 0.0)
    return float(gain.sum() / np.sqrt(size * (1 + r) / (1 - r)))


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
    functions = option.smooth(linear.step(option, {k})[len(linear.step(None, {k})) :])
    fitted = _beside(at, functions, train)
    if fitted is None:
        return plain
    problem = displaced(at, functions, at.problem)
    machine = problem.solve(fitted.errors)
    moved = problem.residual(fitted.errors, fitted.instrument, problem.seen(machine))[test]
    each = holding(functions, problem.recording, at.problem.body.q, at.machine.x)
    holds = each[at.problem.readings.rows[test]].min(axis=1)[:, None]
    out: Array = plain + holds * (moved - plain)
    return out


def _beside(at: Fit, functions: Sequence[Smooth], chosen: np.ndarray | None = None) -> Fit | None:
    """Return the fit of geometry, effects and instrument beside smooth functions, to some of the readings."""
    problem = displaced(at, functions, at.problem)
    problem = problem if chosen is None else problem.subset(np.flatnonzero(chosen))
    try:
        return fit(problem, Prior(), errors=at.errors, instrument=at.instrument, must_converge=False, tolerance=0.1)
    except (NoSolutionError, InputError):
        return None


def _moved(smooth: Smooth, at: Fit, whole: Fit) -> Smooth:
    """Return a function of the position whose knots lie where another fit has their poses, others as they are.

    Where {O} stands few readings tell, and what fits leave open of it is not the same in all of them.
    """
    if smooth.variable != POSITION:
        return smooth
    rows = _gaps(smooth.knots, at.machine.x[:, :3]).argmin(axis=1)
    lines = at.problem.recording.line[rows]
    there = np.argsort(whole.problem.recording.line, kind="stable")
    found = there[np.searchsorted(whole.problem.recording.line, lines, sorter=there)]
    return dataclasses.replace(smooth, knots=whole.machine.x[found, :3])


def displaced(at: Fit, functions: Sequence[Smooth], problem: Problem) -> Problem:
    """Return a problem whose joints and readings are moved by smooth functions as predictions move them."""
    body, x = problem.body, at.machine.x
    joints, shift = displacement(functions, problem.recording, body.q, x)
    share = holding(functions, problem.recording, body.q, x)[:, None]
    if joints.any():
        moved = Body(body.robot, body.mechanism, body.q + share * joints, body.tool, body.channels)
        problem = dataclasses.replace(problem, body=moved)
    if shift.any():
        instrument = at.instrument.mounted(problem.mechanism, at.errors)
        there, _ = instrument.predict(problem.readings, np.hstack([x[:, :3] + share * shift, x[:, 3:]]))
        here, _ = instrument.predict(problem.readings, x)
        readings = dataclasses.replace(problem.readings, values=problem.readings.values - (there - here))
        problem = dataclasses.replace(problem, readings=readings)
    return problem


@dataclass(frozen=True)
class _Part:
    """One of the functions of an option; columns (R, k, K * carriers) and (scalars, ...) of unit size."""

    like: Smooth
    to_knots: Array
    scale: Array
    raw: Array
    whitened: Array

    def smooth(self, c: Array) -> Smooth:
        """Return the function with coefficients in units of its size."""
        values = (c * np.tile(self.scale, self.to_knots.shape[1])).reshape(self.to_knots.shape[1], -1)
        return dataclasses.replace(self.like, coefficients=self.to_knots @ values)


@dataclass(frozen=True)
class _Option:
    """Functions of the same size that act together, to choose from; `key` is theirs whatever the size.

    Those of `there` move nothing, and say where the others hold.
    """

    key: tuple[object, ...]
    parts: tuple[_Part, ...]
    there: tuple[Smooth, ...]
    size: float

    @property
    def raw(self) -> Array:
        return np.concatenate([part.raw for part in self.parts], axis=2)

    @property
    def whitened(self) -> Array:
        return np.hstack([part.whitened for part in self.parts])

    def smooth(self, c: Array) -> tuple[Smooth, ...]:
        """Return the functions with coefficients of unit columns."""
        return (*(part.smooth(own) for part, own in self._parted(c)), *self.there)

    def moved(self, c: Array) -> list[Array]:
        """Return by how much each of the functions moves the readings (R, k) [mm, rad]."""
        return [part.raw @ own for part, own in self._parted(c)]

    def _parted(self, c: Array) -> list[tuple[_Part, Array]]:
        ends = np.cumsum([part.whitened.shape[1] for part in self.parts])[:-1]
        return list(zip(self.parts, np.split(c, ends), strict=True))


class _Linear:
    """The machine made linear at a fit: steps of geometry, effects, instrument and a smooth function together."""

    def __init__(self, at: Fit, parts: Sequence[tuple[np.ndarray, np.ndarray]], weights: Array) -> None:
        problem = at.problem
        self._fit, self._beside = at, Beside(at)
        self._limbs, self._sees_joints = problem.mechanism.limbs, problem.readings.kind.sees_joints
        machine = self._beside.machine
        self._x, self._seen, self._dx = machine.x, problem.seen(machine), problem.displacements(machine)
        state = problem.linearise(at.errors, at.instrument, machine)
        self._residual, self.weights = state.residual, weights
        self._raw = np.concatenate([state.J_p * problem.scale, state.J_m], axis=2)
        self._base = self._rows(self._raw)
        self._target = self._rows(state.residual[..., None])[:, 0]
        self._prior = np.concatenate([at.departure, np.zeros(state.J_m.shape[2])])
        self._held = np.repeat([1.0, 0.0], state.J_p.shape[2:] + state.J_m.shape[2:])
        self._tests = [test[self._beside.owner] for _, test in parts]
        self._grams: dict[object, list[tuple[Array, Array]]] = {}

    def _rows(self, values: Array) -> Array:
        return self._beside.rows(values * np.sqrt(self.weights)[:, None, None])

    def options(self, found: Sequence[Structure]) -> list[_Option | None]:
        """Return what there is to choose from: no function, one of a structure's variable, or one of every joint."""
        names = joint_names(self._fit.problem.recording.joint_unit, self._limbs)
        own: list[tuple[str, tuple[int, ...]]] = [(name, (j + 1,)) for j, name in enumerate(names)]
        sets = [own, *([(s.channel, s.limbs)] for s in found if s.limbs or not self._sees_joints)]
        out: list[_Option | None] = [None]
        for functions, length in itertools.product(sets, LENGTHS):
            likes = [like for name, limbs in functions if (like := self._like(name, limbs, length)) is not None]
            # along one path a function of any joint is one of all others: it holds where the path was
            there = self._like(POSITION, (), length) if functions is own and not self._sees_joints else None
            if likes:
                parts, key = tuple(map(self._part, likes)), (*functions, length)
                out += [_Option(key, parts, () if there is None else (there,), size) for size in SIZES]
        return out

    def _like(self, name: str, limbs: tuple[int, ...], length: float) -> Smooth | None:
        """Return a function of a variable at joints or in the reading, that is zero; None where nothing varies."""
        problem = self._fit.problem
        used = np.unique(problem.readings.rows)
        values = variable(name, problem.recording, problem.body.q, self._x)
        if values is None or not (known := values[used][np.isfinite(values[used]).all(axis=1)]).size:
            return None
        span = float(np.linalg.norm(np.ptp(known, axis=0)))
        if span == 0:
            return None
        knots = _knots(known, KNOTS)
        reach = float(_gaps(known, knots).min(axis=1).max())
        return Smooth(name, limbs, knots, length * span, reach, np.zeros((len(knots), len(limbs) or 3)))

    def _part(self, like: Smooth) -> _Part:
        problem = self._fit.problem
        values = variable(like.variable, problem.recording, problem.body.q, self._x)
        assert values is not None  # the function has knots of them
        carriers = [i - 1 for i in like.limbs] or list(range(self._limbs, self._dx.shape[2]))
        dx = self._dx[:, :, carriers]
        J, _ = self._fit.instrument.linearise(problem.readings, self._seen, dx)
        unit = np.sqrt(np.mean(self._rows(J) ** 2, axis=0))
        scale = np.where(unit > 0, 1 / np.maximum(unit, 1e-300), 0.0)
        U, s, _ = np.linalg.svd(_kernel(like.knots, like.knots, like.length), hermitian=True)
        keep = s > JITTER * s[0]
        to_knots = U[:, keep] / np.sqrt(s[keep])
        f = np.nan_to_num(_kernel(values, like.knots, like.length)) @ to_knots
        moved = (dx * scale)[:, :, None] * f[:, None, :, None]
        raw, _ = self._fit.instrument.linearise(problem.readings, self._seen, moved.reshape(*dx.shape[:2], -1))
        return _Part(like, to_knots, scale, raw, self._rows(raw))

    def step(self, option: _Option | None, without: set[int]) -> Array:
        """Return the step that fits all parts but some: geometry and effects in their scales, instrument, function."""
        G, g = self._normal(option, without)
        n = len(self._held)
        g[:n] -= self._prior
        drawn = np.full(len(g) - n, option.size**-2 if option else 1.0)
        G[np.diag_indices_from(G)] += np.append(self._held, drawn) + jitter(np.diag(G))
        return np.linalg.solve(G, g).astype(float)

    def best(self, options: Sequence[_Option | None], without: set[int]) -> _Option | None:
        """Return the option that predicts each of the other parts best from the rest."""
        losses = []
        for option in options:
            loss = 0.0
            for k in set(range(len(self._tests))) - without:
                u = self.step(option, without | {k})
                G, g = self._gram(option)[k]
                loss += float(u @ G @ u - 2 * u @ g)  # beyond what the readings themselves are
            losses.append(loss)
        return options[int(np.argmin(losses))]

    def errors(self, step: Array, option: _Option | None, chosen: np.ndarray | slice = slice(None)) -> Array:
        """Return what a step leaves of readings (R, k) [mm, rad]."""
        n = len(self._held)
        moved = self._raw[chosen] @ step[:n]
        if option is not None:
            moved = moved + option.raw[chosen] @ step[n:]
        left: Array = self._residual[chosen] - moved
        return left

    def _normal(self, option: _Option | None, without: set[int]) -> tuple[Array, Array]:
        kept = [gram for k, gram in enumerate(self._gram(option)) if k not in without]
        return np.sum([G for G, _ in kept], axis=0), np.sum([g for _, g in kept], axis=0)

    def _gram(self, option: _Option | None) -> list[tuple[Array, Array]]:
        key = None if option is None else option.key
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
