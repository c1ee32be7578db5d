"""The one estimation problem: exact readings of a machine with errors, seen by an instrument with unknowns.

Every task is the same weighted nonlinear least squares over parameters `p` and instrument `m`: Gauss-Newton on the
exact closure with analytic Jacobians. The instrument's unknowns are eliminated by projection in every step, so that a
solver's rule for weak directions acts on the machine's parameters only; a parameter that the data do not see stays at
the robot file's value.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import NamedTuple

import numpy as np

from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.solvers import LeastSquares, Solution, Solver
from deltacal_gen.instrument.instrument import Instrument
from deltacal_gen.instrument.kind import Kind
from deltacal_gen.instrument.kinds import measured_points, readings
from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.registry import Array, Machine, Sensitivity, mechanism_of
from deltacal_gen.machine.values import Recording, Robot
from deltacal_gen.physics.physics import Body, Channels, Deformed, Term, of_reading, reading_shift

MAX_ITERATIONS = 40
CONVERGED = 1e-4  # of chi2: what a last step could still gain; parameters then stand within 1e-2 of their deviation
# a direction that the data hardly see converges slowly where the model bends within its noise: no step of it matters
PATIENCE, SETTLED, UNSETTLED = 12, 5e-2, 1.0
ESTIMATED_AT = 3  # iteration in which at the latest the weight of repeats is estimated: the fit is then close
STEP_LIMIT = 30.0  # of an ordinary error: a longer step at once is no correction but a loss of direction
TRIALS = 12
SMALLEST_SIGMA = 1e-7  # mm and rad: noise below this is rounding of what went before, not of a reading
HUBER = 2.5  # standard deviations beyond which a reading's pull stops growing
SPOILT = 30.0  # times the median residual: a reading so far off is named when a fit does not converge
MOST_GROSS = 0.06  # of all readings: more than this are no errors of measurement but something left out
SPARE_READINGS = 3  # scalars beyond the unknowns, without which no noise can be told from errors
USUAL_COUNTS = 3  # readings that knowing the usual noise of an instrument is worth
GROSS = 6.0  # standard deviations beyond which a reading is listed as a gross error


class Linearised(NamedTuple):
    """Residuals and Jacobians of all readings at one state; rows (R, k), NaN where a component was not read."""

    residual: Array
    J_p: Array
    J_m: Array


@dataclass(frozen=True, eq=False)
class Problem:
    """A robot, its readings, and which parameters are free.

    The vector of parameters holds all source errors of the mechanism, then the coefficients of the effects on it.

    Attributes
    ----------
    names : tuple of str
        Free source errors; the coefficients of `terms` are free too.
    scale : (n,) array
        Ordinary size of each free parameter, or the standard deviation of its prior [mm, rad, N, s, K].
    reference : (n_p,) array
        Source errors of the robot file, from which the free ones depart, then zeros [mm, rad].
    body : Body
        The robot at the rows of the recording.
    terms : tuple of Term
        Effects on the machine whose coefficients are free.
    held : tuple of Term
        Effects on it that stay as they are.
    """

    robot: Robot
    mechanism: Machine
    recording: Recording
    readings: Readings
    names: tuple[str, ...]
    scale: Array
    reference: Array
    body: Body
    terms: tuple[Term, ...] = ()
    held: tuple[Term, ...] = ()

    @property
    def columns(self) -> list[int]:
        """Index of each free parameter in the vector of parameters."""
        n_p = len(self.mechanism.parameters)
        return [self.mechanism.index[n] for n in self.names] + list(range(n_p, len(self.reference)))

    def coefficients(self, i: int) -> list[int]:
        """Return the places of an effect's coefficients among the free parameters."""
        start = len(self.names) + sum(t.n_coefficients for t in self.terms[:i])
        return list(range(start, start + self.terms[i].n_coefficients))

    def split(self, parameters: Array) -> tuple[Array, tuple[Term, ...]]:
        """Return source errors (n_p,) and the free effects with their coefficients."""
        n = len(self.mechanism.parameters)
        errors, rest = parameters[:n], parameters[n:]
        if not self.terms:
            return errors, ()
        ends = np.cumsum([t.n_coefficients for t in self.terms])
        parts = np.split(rest, ends[:-1])
        return errors, tuple(t.with_values(v) for t, v in zip(self.terms, parts, strict=True))

    def acting(self, parameters: Array) -> tuple[Term, ...]:
        """Return all effects on the machine with their coefficients, the free ones first."""
        return (*self.split(parameters)[1], *self.held)

    def solve(self, parameters: Array, near: Array | None = None) -> Deformed:
        """Return the machine in equilibrium at all rows; `near` is the poses of a machine that differs little.

        Raises
        ------
        InputError
            A row that readings refer to has no pose: out of reach or singular.
        """
        machine, status = self.body.solve(*self.split(parameters), near, self.held)
        self.body.check(machine, status, self.readings.used, self.recording)
        return machine._replace(x=np.where(np.isfinite(machine.x), machine.x, 0.0))

    def poses(self, parameters: Array, near: Array | None = None) -> Array:
        """Return the exact platform poses (N, 12) of all rows; see `solve`."""
        return self.solve(parameters, near).x

    def residual(self, parameters: Array, instrument: Instrument, x: Array) -> Array:
        """Return measured minus predicted (R, k), effects on the reading included [mm, rad]."""
        instrument = instrument.mounted(self.mechanism, parameters)
        r = instrument.residual(self.readings, x)
        if terms := of_reading(self.acting(parameters)):
            values, _ = instrument.predict(self.readings, x)
            r[:, : values.shape[1]] -= reading_shift(terms, self.body, self.readings, values, x)[0]
        return r

    def linearise(self, parameters: Array, instrument: Instrument, machine: Deformed | None = None) -> Linearised:
        """Return residuals and Jacobians at a vector of parameters and an instrument's state."""
        machine = self.solve(parameters) if machine is None else machine
        _, terms = self.split(parameters)
        used = self.readings.used
        rows = machine.rows if len(machine.rows) == 1 else machine.rows[used]
        sensitivity = self.mechanism.sensitivity(machine.x[used], machine.q[used], machine.tool[used], rows)
        if not np.isfinite(sensitivity.parameters).all():
            row = int(used[~np.isfinite(sensitivity.parameters).all(axis=(1, 2))][0])
            raise InputError(
                "at these joints the machine is singular.",
                "Remove the row.",
                file=self.recording.path,
                line=int(self.recording.line[row]),
            )
        dx = np.zeros((len(machine.x), self.mechanism.n_x, len(self.names)))
        dx[used] = sensitivity.parameters[:, :, [self.mechanism.index[n] for n in self.names]]
        effects = self.effect_columns(terms, machine, used, sensitivity)
        mounted = instrument.mounted(self.mechanism, parameters)
        J_p, J_m = mounted.linearise(self.readings, machine.x, np.concatenate([dx, effects], axis=2))
        mounted.add_carried(J_p, self.mechanism, self.names, self.readings, machine.x)
        if terms:
            values, _ = mounted.predict(self.readings, machine.x)
            shifted = reading_shift(terms, self.body, self.readings, values, machine.x)[1]
            J_p[:, : values.shape[1], len(self.names) :] += shifted
        return Linearised(self.residual(parameters, instrument, machine.x), J_p, J_m)

    def effect_columns(
        self, terms: Sequence[Term], machine: Deformed, used: np.ndarray, sensitivity: Sensitivity
    ) -> Array:
        """Return the derivatives (N, n_x, n_c) of the platform coordinates by the coefficients of effects."""
        return self.body.columns(terms, machine, sensitivity, used)

    def term_columns(
        self, terms: Sequence[Term], parameters: Array, instrument: Instrument, machine: Deformed
    ) -> Array:
        """Return the derivatives (R, k, n_c) of the readings by the coefficients of effects, free or not."""
        instrument = instrument.mounted(self.mechanism, parameters)
        used = self.readings.used
        rows = machine.rows if len(machine.rows) == 1 else machine.rows[used]
        S = self.mechanism.sensitivity(machine.x[used], machine.q[used], machine.tool[used], rows)
        J, _ = instrument.linearise(self.readings, machine.x, self.effect_columns(terms, machine, used, S))
        values, _ = instrument.predict(self.readings, machine.x)
        J[:, : values.shape[1]] += reading_shift(terms, self.body, self.readings, values, machine.x)[1]
        return J

    def begin(self, parameters: Array, machine: Deformed | None = None) -> Instrument:
        """Return the instrument's first state for a machine with `parameters`."""
        x = self.poses(parameters) if machine is None else machine.x
        return self.readings.kind.start(self.readings, self.recording, self.robot, x)

    def subset(self, chosen: np.ndarray) -> Problem:
        """Return the problem with these readings only."""
        return dataclasses.replace(self, readings=self.readings.subset(chosen))

    def with_tool(self, tool: Array) -> Problem:
        """Return the problem with other measured points (N, 3) of the platform."""
        b = self.body
        return dataclasses.replace(self, body=Body(b.robot, b.mechanism, b.q, tool, b.channels))

    def with_names(self, names: Sequence[str]) -> Problem:
        """Return the problem with other free source errors, in their ordinary scale, and only the effects held."""
        index = [self.mechanism.index[n] for n in names]
        return dataclasses.replace(
            self,
            names=tuple(names),
            scale=self.mechanism.typical[index],
            reference=self.reference[: len(self.mechanism.parameters)],
            terms=(),
        )

    def with_terms(self, terms: Sequence[Term], scale: Array) -> Problem:
        """Return the problem with free effects; `scale` (n_c,) is the size that their coefficients may well have."""
        n_p, n = len(self.mechanism.parameters), len(self.names)
        return dataclasses.replace(
            self,
            terms=tuple(terms),
            reference=np.concatenate([self.reference[:n_p], np.zeros(len(scale))]),
            scale=np.concatenate([self.scale[:n], scale]),
        )


def pose_problem(
    robot: Robot,
    recording: Recording,
    names: Sequence[str],
    *,
    as_distance: bool = False,
    found: Readings | None = None,
    held: Sequence[Term] = (),
) -> Problem:
    """Return the estimation problem of a recording for a set of free source errors; `held` effects stay as they are."""
    mechanism = mechanism_of(robot)
    tool = measured_points(robot, recording)
    q = robot.joint_sign * recording.joints
    return Problem(
        robot=robot,
        mechanism=mechanism,
        recording=recording,
        readings=readings(recording, as_distance=as_distance) if found is None else found,
        names=tuple(names),
        scale=mechanism.typical[[mechanism.index[n] for n in names]],
        reference=mechanism.vector(robot.errors),
        body=Body(robot, mechanism, q, tool, Channels.of(recording, robot)),
        held=tuple(held),
    )


@dataclass(frozen=True, eq=False)
class Repeats:
    """Readings of one pose share what their pose has in common: an error of re-aiming, of the machine, of the model.

    With `n` readings of a pose, variance 1 within and `ratio` between poses, the pose's mean has the variance
    ``ratio + 1/n``: more readings of the same pose do not make it any surer. The rows are whitened by taking the part
    ``1 - 1/sqrt(1 + n ratio)`` of the pose's mean off each reading (quasi-demeaning, generalised least squares of a
    random-effects model). The noise of a single reading is ``1 + ratio``; rows come divided by the part within.
    `ratio` is a number, or one for each component of a reading: positions may be aimed anew where rotations are not.
    """

    group: np.ndarray
    ratio: float | Array = 0.0

    def whiten(self, values: Array) -> Array:
        """Return rows (R, ...), of components (R, k, ...), with the shared part of each group taken off."""
        if not np.any(self.ratio):
            return values
        order = np.argsort(self.group, kind="stable")
        _, first, own, count = np.unique(self.group[order], return_index=True, return_inverse=True, return_counts=True)
        count = count.reshape(-1, *[1] * np.ndim(self.ratio))
        part = (1 - 1 / np.sqrt(1 + count * self.ratio)) / count
        part = part.reshape(*part.shape, *[1] * (values.ndim - part.ndim))
        sums = np.add.reduceat(values[order], first, axis=0) * part
        whitened = np.array(values, dtype=float)
        whitened[order] -= sums[own]
        return whitened

    @staticmethod
    def ratio_of(residual: Array, group: np.ndarray, fitted: float = 0.0) -> tuple[float, float, int]:
        """Return (variance between / within, variance within, degrees of freedom within) of residuals (R, k).

        `fitted` is the number of parameters that the means of the groups have carried.
        """
        residual = np.nan_to_num(_read(residual))
        count = np.bincount(group)
        several = count[group] > 1
        degrees = int((count[count > 1] - 1).sum()) * residual.shape[1]
        if degrees < 6:
            return 0.0, 0.0, degrees
        sums = np.zeros((len(count), residual.shape[1]))
        np.add.at(sums, group, residual)
        means = sums / np.maximum(count, 1)[:, None]
        within = float(((residual - means[group])[several] ** 2).sum() / degrees)
        some = count > 0
        spare = max(some.sum() * residual.shape[1] - fitted, 1.0)
        excess = (means[some] ** 2).sum() / spare - within * (1 / count[some]).mean()
        return float(max(excess, 0.0) / max(within, SMALLEST_SIGMA**2)), within, degrees


@dataclass(frozen=True, eq=False)
class Fit:
    """A fitted machine and instrument.

    Attributes
    ----------
    errors : (n_p,) array
        All source errors of the mechanism [mm, rad]; then the coefficients of effects.
    machine : Deformed
        With these errors, at all rows of the recording.
    residual : (R, k) array
        Measured minus predicted, NaN where a component was not read.
    weights : (R,) array
        Robust weight of each reading, 1 where it counts fully.
    sigma : (k,) array
        Estimated noise of each component [mm, rad].
    solution : Solution
        Of the last step, in scaled parameters.
    covariance : (n + n_m, n + n_m) array
        Joint, of the free parameters and the instrument's unknowns [mm, rad].
    history : list of float
        What each iteration could still gain in chi2.
    """

    problem: Problem
    errors: Array
    machine: Deformed
    instrument: Instrument
    residual: Array
    weights: Array
    sigma: Array
    solution: Solution
    covariance: Array
    repeats: Repeats
    history: list[float] = field(default_factory=list)

    @property
    def parameters(self) -> dict[str, float]:
        """The free source errors by name [mm, rad]."""
        names = self.problem.names
        return dict(zip(names, self.errors[self.problem.columns[: len(names)]].tolist(), strict=True))

    @property
    def gross(self) -> np.ndarray:
        """Readings (indices) so far off that they are gross errors, not noise."""
        size = np.nanmax(np.abs(self.residual) / self.sigma, axis=1)
        return np.flatnonzero(size > GROSS)

    def rms(self) -> float:
        """RMS of the residuals of length, each measured scalar once, gross errors left out [mm]."""
        return rms(lengths(np.delete(self.residual, self.gross, axis=0), self.problem.readings.kind))


def rms(values: Array) -> float:
    """Return the RMS of the values that are finite; NaN where none is."""
    found = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(found**2))) if found.size else float("nan")


def lengths(residual: Array, kind: Kind) -> Array:
    """Return the components of length of residuals (R, k) [mm]: no rotations, and no axis that nothing reads."""
    return _read(np.delete(residual, kind.turned, axis=1))


def _read(residual: Array) -> Array:
    """Return the columns of residuals (R, k) in which anything was read."""
    return residual[:, np.isfinite(residual).any(axis=0)]


def fit(
    problem: Problem,
    solver: Solver | None = None,
    *,
    errors: Array | None = None,
    machine: Deformed | None = None,
    instrument: Instrument | None = None,
    robust: bool = True,
    repeats: Repeats | None = None,
    weigh_repeats: bool = True,
    drop_gross: bool = True,
    must_converge: bool = True,
) -> Fit:
    """Fit a machine's parameters and the instrument to readings, exactly.

    Parameters
    ----------
    problem : Problem
    solver : Solver, optional
        Rule for weak directions; default `LeastSquares`.
    errors : (n_p,) array, optional
        Where to start; default the robot file's.
    machine : Deformed, optional
        With these errors, where it has been solved already.
    instrument : Instrument, optional
        Where to start; default aligned with the machine there.
    robust : bool
        Huber weights per reading: a few per cent of gross errors do not move the result.
    repeats : Repeats, optional
        How repeated readings of a pose are weighed; default estimated on the way.
    weigh_repeats : bool
        Otherwise every reading counts alone.
    drop_gross : bool
        Give readings that prove gross errors no weight in the end, as long as they are few.
    must_converge : bool
        Otherwise the last state is returned when the iteration does not end.

    Raises
    ------
    NoSolutionError
        The iteration did not converge; the message gives the last steps.
    InputError
        A pose cannot be reached with the joints given.
    """
    solver = LeastSquares() if solver is None else solver
    errors = problem.reference.copy() if errors is None else errors.copy()
    machine = problem.solve(errors) if machine is None else machine
    if instrument is None:
        instrument = problem.begin(errors, machine)
    n_m = instrument.n_unknown
    estimated = repeats is None and weigh_repeats
    shared = Repeats(problem.readings.group, repeats.ratio if repeats else 0.0)
    history: list[float] = []
    scalars = int(np.isfinite(instrument.residual(problem.readings, machine.x)).sum())
    scarce = scalars - n_m - len(problem.names) < SPARE_READINGS and not problem.readings.kind.rotations
    known = problem.recording.measurement.sigma_mm if scarce else None
    groups = problem.readings.kind.noise_groups(6)
    leverage = np.full(problem.readings.kind.noises, float(n_m + min(len(problem.names), 1)) / max(scalars, 1))
    damping, degrees, close = 0.0, 0.0, ESTIMATED_AT
    while True:
        state = problem.linearise(errors, instrument, machine)
        sigma = (
            robust_sigma(state.residual, leverage, robust, problem.readings)
            if known is None
            else np.full(state.residual.shape[1], known)
        )
        if len(history) < close and history and history[-1] < UNSETTLED:
            close = len(history)
        drop = drop_gross and len(history) > close
        weights = robust_weights(state.residual, sigma, drop) if robust else np.ones(len(state.residual))
        if estimated and len(history) == close:
            quiet = robust_weights(state.residual, sigma, drop=True) > 0  # gross errors say nothing of poses
            shared = _shared(problem.readings, state.residual, quiet, degrees, leverage)
        A_p, A_m, b = _system(state, sigma, weights, shared, problem.scale)
        # the solver draws towards the reference: it is asked for the whole departure, not for a step
        departure = (errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
        Q = np.linalg.qr(A_m)[0] if n_m else np.zeros((len(b), 0))
        target = b + A_p @ departure
        A = A_p - Q @ (Q.T @ A_p)
        solution = solver.solve(A, target - Q @ (Q.T @ target), float(sigma[0]))
        if len(history) == close:
            solver = solver.settled(solution)
        degrees = solution.degrees + n_m
        leverage = (
            np.full(len(leverage), degrees / max(problem.readings.n_scalars, 1.0))
            if problem.readings.made
            else _leverage(A, Q, solution, np.isfinite(state.residual), groups)
        )
        history.append(_gain(solution.u - departure, departure, A_p, Q, b, solver.weight or 0.0))
        if len(history) > (close + 1 if estimated else 1) and history[-1] < (
            CONVERGED if len(history) < PATIENCE else SETTLED
        ):
            break
        if len(history) == MAX_ITERATIONS:
            if not must_converge or min(history[-3:]) < UNSETTLED:
                break
            _blame(problem, state.residual)
            raise NoSolutionError(
                f"the fit of {len(problem.names)} parameters did not converge in {MAX_ITERATIONS} iterations: the last "
                f"ones promised to lower chi2 by {', '.join(f'{h:.1e}' for h in history[-3:])}. Try a smaller model, a "
                "TSVD or priors."
            )
        before = errors
        errors, instrument, machine, damping = _damped(
            problem,
            (errors, instrument, machine),
            solution,
            (A_p, A_m, b),
            partial(_scalars, sigma=sigma, weights=weights, shared=shared),
            solver.weight,
            damping,
        )
        if errors is before and len(history) > close + 1:
            break  # no step lowers the objective: what the linear machine still promises is not to be had
    return Fit(
        problem=problem,
        errors=errors,
        machine=machine,
        instrument=instrument,
        residual=state.residual,
        weights=weights,
        sigma=sigma,
        solution=solution,
        covariance=_joint_covariance(solution, A_p, A_m, problem.scale, _shared_noise(problem, weights, machine.x)),
        repeats=shared,
        history=history,
    )


def _shared(found: Readings, residual: Array, quiet: np.ndarray, degrees: float, leverage: Array) -> Repeats:
    """Return what repeats share, of each group of columns for itself; they part what the fit took by their leverage."""
    groups, ratio = found.kind.noise_groups(residual.shape[1]), np.zeros(residual.shape[1])
    parts = [groups == g for g in range(len(leverage))]
    taken = [used * np.isfinite(residual[:, part]).sum() for used, part in zip(leverage, parts, strict=True)]
    for part, some in zip(parts, taken, strict=True):
        rows = quiet & np.isfinite(residual[:, part]).any(axis=1)
        if rows.any():
            fitted = degrees * some / max(sum(taken), 1e-300)
            ratio[part], *_ = Repeats.ratio_of(residual[np.ix_(rows, part)], found.group[rows], fitted=fitted)
    return Repeats(found.group, ratio)


def rough(problem: Problem, robust: bool = True, must_converge: bool = True) -> Fit:
    """Fit the mechanism's smallest model, the encoder offsets, starting from the robot file."""
    smallest = min(problem.mechanism.models.values(), key=len)
    return fit(
        problem.with_names(smallest), LeastSquares(), robust=robust, weigh_repeats=False, must_converge=must_converge
    )


def held_out(full: Fit, solver: Solver, parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> float:
    """Return the RMS [mm] of readings predicted by fits that did not see them; see `held_out_errors`."""
    return rms(lengths(held_out_errors(full, solver, parts), full.problem.readings.kind))


def held_out_errors(full: Fit, solver: Solver, parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> Array:
    """Return the errors (R, k) [mm, rad] of predictions by fits that did not see the readings; nan where there is none.

    Gross errors of the full fit are not predicted. Each fit starts from the full one and differs from it by less than a
    standard deviation, where the machine is linear to far below its noise: one step is the fit.

    Parameters
    ----------
    parts : sequence of (train, test)
        Masks (R,) of readings.
    """
    problem = full.problem
    state = problem.linearise(full.errors, full.instrument, full.machine)
    A_p, A_m, b = _system(state, full.sigma, full.weights, full.repeats, problem.scale)
    read = np.isfinite(state.residual)
    owner = np.repeat(np.arange(len(read)), read.sum(axis=1))
    departure = (full.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
    gross = np.zeros(len(read), dtype=bool)
    gross[full.gross] = True
    out = np.full(state.residual.shape, np.nan)
    for train, test in parts:
        rows, test = train[owner], test & ~gross
        if not test.any() or rows.sum() <= full.solution.degrees + full.instrument.n_unknown:
            continue
        Q = np.linalg.qr(A_m[rows])[0]
        target = b[rows] + A_p[rows] @ departure
        solution = solver.solve(A_p[rows] - Q @ (Q.T @ A_p[rows]), target - Q @ (Q.T @ target), float(full.sigma[0]))
        step = solution.u - departure
        m_step = np.linalg.lstsq(A_m[rows], b[rows] - A_p[rows] @ step, rcond=None)[0]
        moved = state.J_p[test] @ (step * problem.scale) + state.J_m[test] @ m_step
        out[test] = state.residual[test] - moved
    return out


def _blame(problem: Problem, residual: Array) -> None:
    """Raise an InputError that names the worst reading, where one stands so far out that it spoils the fit."""
    size = np.linalg.norm(np.nan_to_num(lengths(residual, problem.readings.kind)), axis=1)
    worst, usual = int(np.argmax(size)), float(np.median(size))
    if size[worst] > SPOILT * usual:
        raise InputError(
            f"the reading is {size[worst]:.4g} mm off the machine at these joints, most others {usual:.3g} mm.",
            "Check the joints and the measured cells of this row, or remove it.",
            file=problem.recording.path,
            line=int(problem.readings.line[worst]),
        )


def _gain(step: Array, departure: Array, A_p: Array, Q: Array, b: Array, weight: float) -> float:
    """Return by how much a whole step would lower the objective, were the machine linear."""
    rest = b - A_p @ step
    rest, whole = rest - Q @ (Q.T @ rest), departure + step
    return abs(float(b @ b - rest @ rest + weight * (departure @ departure - whole @ whole)))


def _leverage(A: Array, Q: Array, solution: Solution, read: np.ndarray, groups: np.ndarray) -> Array:
    """Return the part of each group's readings that the fit uses up (g,): the mean of the hat matrix's diagonal."""
    with np.errstate(divide="ignore", invalid="ignore"):
        weight = np.where(solution.factors > 0, np.sqrt(solution.factors) / solution.singular_values, 0.0)
    hat = ((A @ solution.V * weight) ** 2).sum(axis=1) + (Q**2).sum(axis=1)
    own = np.broadcast_to(groups[: read.shape[1]], read.shape)[read]
    parts = (own == group for group in range(groups.max() + 1))
    return np.array([hat[part].mean() if part.any() else 0.0 for part in parts])


def robust_sigma(residual: Array, leverage: Array, robust: bool, found: Readings) -> Array:
    """Return the noise (k,) of each group of columns (lengths and rotations, heights and distances) from its residuals.

    `leverage` (g,) is the part of each that the fit has used up.
    """
    sigma, groups = np.ones(residual.shape[1]), found.kind.noise_groups(residual.shape[1])
    usual = found.kind.usual_noises
    for group, used in enumerate(leverage):
        part = groups == group
        r = residual[:, part]
        r = r[np.isfinite(r)]
        if not r.size:
            continue
        spread = max(1.4826 * _median(np.abs(r)), SMALLEST_SIGMA)
        if robust:  # Huber's proposal 2 from the median: efficient on normal noise, bounded on gross errors
            for _ in range(3):
                clipped = np.clip(r / spread, -HUBER, HUBER)
                spread = max(spread * float(np.sqrt(np.mean(clipped**2) / 0.9775)), SMALLEST_SIGMA)
        else:
            spread = max(float(np.sqrt(np.mean(r**2))), SMALLEST_SIGMA)
        sigma[part] = spread / np.sqrt(max(1 - used, 0.1))
        if usual:
            # a few readings of one kind can be met exactly at the other's cost: what such instruments read guards them
            free = len(r) * max(1 - used, 0.1)
            known = USUAL_COUNTS * usual[group] ** 2
            sigma[part] = np.sqrt((free * sigma[part] ** 2 + known) / (free + USUAL_COUNTS))
    return sigma


def _median(values: Array) -> float:
    """Return the median of finite values (n,); NumPy's own would first load masked arrays, a fifth of a first fit."""
    middle = [(len(values) - 1) // 2, len(values) // 2]
    return float(np.partition(values, middle)[middle].mean())


def robust_weights(residual: Array, sigma: Array, drop: bool) -> Array:
    """Return Huber's weights (R,); with `drop` none for gross errors, unless they are too many to be errors."""
    size = np.sqrt(np.nanmean((residual / sigma) ** 2, axis=1))
    weights = np.minimum(1.0, HUBER / np.maximum(size, 1e-300))
    gross = np.nanmax(np.abs(residual) / sigma, axis=1) > GROSS
    if drop and gross.mean() <= MOST_GROSS:
        weights[gross] = 0.0
    return weights


def _system(
    state: Linearised, sigma: Array, weights: Array, shared: Repeats, scale: Array
) -> tuple[Array, Array, Array]:
    """Return A_p, A_m, b: rows divided by the noise, columns multiplied by the scale, unread components dropped."""
    w = (np.sqrt(weights)[:, None] / sigma * np.sqrt(1 + shared.ratio))[..., None]
    read = np.isfinite(state.residual)
    stacked = np.concatenate([state.J_p * scale, state.J_m, state.residual[..., None]], axis=2) * w
    stacked = shared.whiten(np.where(read[..., None], stacked, 0.0))[read]
    n = len(scale)
    return stacked[:, :n], stacked[:, n:-1], stacked[:, -1]


def _scalars(residual: Array, sigma: Array, weights: Array, shared: Repeats) -> Array:
    """Return the residuals as `_system` weighs them, unread components as zeros."""
    rows = np.where(np.isfinite(residual), residual, 0.0) * np.sqrt(weights)[:, None] / sigma
    return shared.whiten(rows * np.sqrt(1 + shared.ratio))


def _damped(
    problem: Problem,
    state: tuple[Array, Instrument, Deformed],
    solution: Solution,
    system: tuple[Array, Array, Array],
    whitened: Callable[[Array], Array],
    weight: float | None,
    damping: float,
) -> tuple[Array, Instrument, Deformed, float]:
    """Take the step that lowers the objective, damped as far as needed; return the new state and the damping.

    A rule without an objective (a truncation) takes whole steps.
    """
    errors, instrument, machine = state
    A_p, A_m, b = system
    columns, scale = problem.columns, problem.scale
    departure = (errors[columns] - problem.reference[columns]) / scale

    def objective(at: Array, with_instrument: Instrument, poses: Array) -> float:
        u = (at[columns] - problem.reference[columns]) / scale
        r = whitened(problem.residual(at, with_instrument, poses))
        return float((r**2).sum() + (weight or 0.0) * (u @ u))

    before = objective(errors, instrument, machine.x)
    harder = 2.0
    for _ in range(TRIALS):
        if weight is None:
            step = solution.u - departure
            step = step * min(1.0, STEP_LIMIT / max(float(np.max(np.abs(step), initial=0.0)), STEP_LIMIT))
            step = step / (1.0 + damping)
        else:
            step = solution.damped(departure, weight, damping)
        m_step = np.linalg.lstsq(A_m, b - A_p @ step, rcond=None)[0] if A_m.shape[1] else np.zeros(0)
        trial = errors.copy()
        trial[columns] += step * scale
        moved = instrument.stepped(np.asarray(m_step, dtype=float))
        try:
            deformed = problem.solve(trial, near=machine.x)
        except InputError:
            damping, harder = max(damping * harder, 1.0), 2 * harder
            continue
        if moved.kind.follows:  # what was touched turns with the machine, along an arc that no linear step follows
            off = whitened(problem.residual(trial, moved, deformed.x)).ravel()
            moved = instrument.stepped(m_step + np.linalg.lstsq(A_m, off, rcond=None)[0])
        if weight is None:
            return trial, moved, deformed, damping / 10
        after = objective(trial, moved, deformed.x)
        if after <= before * (1 + 1e-12):
            if after > before * (1 - 1e-12):
                break  # nothing better within rounding, whatever the linear machine promises
            rest = b - A_p @ step - (A_m @ m_step if len(m_step) else 0.0)
            whole = departure + step
            promised = float(b @ b - rest @ rest + weight * (departure @ departure - whole @ whole))
            kept = float(np.clip((before - after) / max(promised, 1e-300), 0.0, 1.0))
            # Nielsen 1999: ease where the linear machine keeps its promises, hold where it does not
            return trial, moved, deformed, damping * max(1 / 3, 1 - (2 * kept - 1) ** 3)
        damping, harder = max(damping * harder, 1.0), 2 * harder
    return errors, instrument, machine, damping


def _shared_noise(problem: Problem, weights: Array, x: Array) -> Array | None:
    """Return how the noise of positions enters distances made of them, (R, positions * 3), rows as in `_system`.

    x (N, 12) are the poses of all rows. Two distances that share a position share its noise; None where every reading
    has noise of its own.
    """
    found = problem.readings
    if not found.made:
        return None
    rows = found.used
    a, b = np.searchsorted(rows, found.rows).T
    at = x[:, :3]
    direction = at[found.rows[:, 1]] - at[found.rows[:, 0]]
    direction /= np.linalg.norm(direction, axis=1)[:, None]
    # a distance has the noise of two positions along it
    direction *= np.sqrt(weights / 2)[:, None]
    out = np.zeros((len(found), len(rows), 3))
    every = np.arange(len(found))
    out[every, b] = direction
    out[every, a] = -direction
    return out.reshape(len(found), -1)


def _joint_covariance(solution: Solution, A_p: Array, A_m: Array, scale: Array, shared: Array | None) -> Array:
    """Return the covariance of parameters and instrument: ``m = m* - A_m^+ A_p dp``."""
    C = solution.covariance
    if shared is not None:
        with np.errstate(divide="ignore", invalid="ignore"):
            inverse_s = np.where(solution.factors > 0, solution.factors / solution.singular_values, 0.0)
            U = np.where(solution.factors > 0, (A_p @ solution.V) / solution.singular_values, 0.0)
        response = (solution.V * inverse_s) @ (U.T @ shared)
        left = (solution.V * (1 - solution.factors) ** 2) @ solution.V.T if solution.posterior else 0.0
        beyond = np.eye(len(C)) - solution.V @ solution.V.T if solution.posterior else 0.0
        C = response @ response.T + left + beyond
    n, n_m = A_p.shape[1], A_m.shape[1]
    out = np.zeros((n + n_m, n + n_m))
    out[:n, :n] = C
    if n_m:
        R = np.linalg.qr(A_m, mode="r")
        inverse = np.linalg.pinv(R)
        follow = -np.linalg.lstsq(A_m, A_p, rcond=None)[0]
        out[n:, :n] = follow @ C
        out[:n, n:] = out[n:, :n].T
        out[n:, n:] = follow @ C @ follow.T + inverse @ inverse.T
    full = np.concatenate([scale, np.ones(n_m)])
    result: Array = out * np.outer(full, full)
    return result
