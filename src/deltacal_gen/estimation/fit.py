"""Fits of the one estimation problem: a machine, its instrument, and how surely the readings know both.

Every task is the same weighted nonlinear least squares over parameters `p` and instrument `m`: Gauss-Newton on the
exact closure with analytic Jacobians. The instrument's unknowns are eliminated by projection in every step, so that a
solver's rule for weak directions acts on the machine's parameters only; a parameter that the data do not see stays at
the robot file's value.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence

import numpy as np

from deltacal_gen.errors import ImplausibleReadings, InputError, NoConvergence
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import BROAD, unsaid, with_prior
from deltacal_gen.estimation.problem import Problem, State
from deltacal_gen.estimation.residuals import (
    Repeats,
    lengths,
    rms,
    robust_sigma,
    robust_weights,
    shared_by_repeats,
)
from deltacal_gen.estimation.saddles import away, unforeseen
from deltacal_gen.estimation.solvers import LeastSquares, Prior, Solution, Solver
from deltacal_gen.estimation.system import System, system, whitened
from deltacal_gen.estimation.turns import turned
from deltacal_gen.inference.least_squares import LITTLE, TINY, Linear, Status, least_squares
from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.deformed import Deformed

MAX_ITERATIONS = 60
CONVERGED = 1e-4  # of chi2: what a last step could still gain; parameters then stand within 1e-2 of their deviation
PATIENCE = 30  # iterations after which a reading that is now an outlier and now not counts
SETTLED, UNSETTLED = LITTLE, 1.0  # of chi2: what a step promises that does not matter, and that does
ESTIMATED_AT = 3  # iteration in which at the latest the weight of repeats is estimated: the fit is then close
# of what a fit left the drawing by: where it begins on the other side; nearer it may come back, farther be led astray
OPPOSITE = 0.03, 0.3
ANY = 1e3  # ordinary errors: a prior of encoder offsets that never pulls
FEW = 12  # lines that a message lists
SPOILT = 30.0  # times the median residual: a reading so far off is named when a fit does not converge
LONGEST = 30.0  # ordinary errors: a truncation's step beyond it is no correction but a loss of direction
ARCS = 2  # corrections of a step, as the instrument turns along arcs
SPARE_READINGS = 3  # scalars beyond the unknowns, without which no noise can be told from errors


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
    tolerance: float = CONVERGED,
    across: bool | None = None,
    known: np.ndarray | None = None,
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
    tolerance : float
        What a last step may still gain of chi2.
    across : bool, optional
        Begin on the other side of the drawing, too, where the machine made linear there did not foresee the fit.
        By default so does the first fit of a search, and the last.
    known : (n_c,) array of bool, optional
        Coefficients of effects that a fit before had: no saddle is sought of these within a search.

    Raises
    ------
    NoSolutionError
        The iteration did not converge; the message gives the last steps.
    InputError
        A pose cannot be reached with the joints given.
    """
    drawn = errors is None or np.array_equal(errors[problem.columns], problem.reference[problem.columns])
    errors = problem.reference.copy() if errors is None else errors.copy()
    machine = problem.solve(errors) if machine is None else machine
    rule = LeastSquares() if solver is None else solver

    def ended(start: State, must_converge: bool, follow: bool = False, noise: Array | None = None) -> tuple[Fit, _Rows]:
        rows = _Rows(problem, start.instrument, robust, repeats, weigh_repeats, drop_gross, noise)
        return _ended(
            _Exact(problem, rule, rows, tolerance <= CONVERGED, follow), start, tolerance, must_converge
        ), rows

    begun = problem.begin(errors, machine) if instrument is None else instrument
    found, rows = ended(State(errors, begun, machine), must_converge)
    if found.solution.posterior and (tolerance <= CONVERGED or _asks_for_saddles(found, known)):
        found = _beside(found, rows, rule, ended)
    others: list[State] = []
    if instrument is None:
        own = slice(len(problem.scale), None)
        others += turned(problem, State(found.errors, found.instrument, found.machine), found.covariance[own, own])
        others += [] if drawn else _elsewhere(problem, errors, problem.reference)
    across = (instrument is None or tolerance <= CONVERGED) if across is None else across
    if across and unforeseen(found):
        way = found.errors - problem.reference
        others += [state for part in OPPOSITE for state in _elsewhere(problem, errors, problem.reference - part * way)]
    # with the noise that is known by now: taken for noise, what a start leaves would lead where this fit went
    ends = [ended(start, False, noise=found.sigma)[0] for start in others]
    ends = [end for end in ends if end.history[-1] <= max(SETTLED, found.history[-1])]  # others are on their way
    return min([found, *ends], key=lambda end: rows.objective(end, rule.weight or 0.0) + tolerance * (end is not found))


def _asks_for_saddles(found: Fit, known: np.ndarray | None) -> bool:
    """Tell whether readings see nothing of a coefficient of which no fit before was asked for a saddle."""
    unseen = found.unseen
    return bool((unseen if known is None else unseen & ~known).any())


def _beside(found: Fit, rows: _Rows, rule: Solver, ended: Callable[[State, bool, bool], tuple[Fit, _Rows]]) -> Fit:
    """Return the lowest of a fit and those that lead away from it, on both sides, where it ended on a saddle."""
    ends = [found, *(ended(state, False, True)[0] for state in away(found))]
    return min(ends, key=lambda end: rows.objective(end, rule.weight or 0.0))


def _elsewhere(problem: Problem, errors: Array, other: Array) -> list[State]:
    """Return a start where what is fitted is as in `other`; none where no machine stands there."""
    errors = errors.copy()
    errors[problem.columns] = other[problem.columns]
    try:
        machine = problem.solve(errors)
    except InputError:
        return []
    return [State(errors, problem.begin(errors, machine), machine)]


class _Rows:
    """How much each reading counts, estimated anew at every state: noise, robust weights, what repeats share."""

    def __init__(
        self,
        problem: Problem,
        instrument: Instrument,
        robust: bool,
        repeats: Repeats | None,
        weigh_repeats: bool,
        drop_gross: bool,
        noise: Array | None = None,
    ) -> None:
        self._at_first = noise  # until a fit is close
        self._found, self._robust, self._drop_gross = problem.readings, robust, drop_gross
        self.estimated = repeats is None and weigh_repeats
        self.shared = Repeats(self._found.group) if repeats is None else repeats
        scalars, n, n_m = self._found.n_scalars, len(problem.names), instrument.n_unknown
        scarce = scalars - n_m - n < SPARE_READINGS and not self._found.kind.rotations
        self._known = problem.recording.measurement.sigma_mm if scarce else None
        self._leverage = np.full(self._found.kind.noises, float(n_m + min(n, 1)) / max(scalars, 1))
        self._carried = 0.0, 0.0
        # gross or not, as the others count it: what came back once stays where a fit does not settle for it
        self._dropped, self._doubtful = np.zeros((2, len(self._found.values)), dtype=bool)
        # points found wrongly go first: their pull would pass for what the points of an image share
        self.later = int(self._found.kind.picked)

    def weigh(self, residual: Array, iteration: int, close: int) -> None:
        """Estimate noise and weights from residuals (R, k); what repeats share once, when the fit is close."""
        self.sigma = self._noise(residual) if self._at_first is None or iteration >= close else self._at_first
        drop = self._found.kind if self._drop_gross and iteration > close - self.later else None
        off = self.shared.off(residual)
        self.weights = robust_weights(off, self.sigma, drop) if self._robust else np.ones(len(residual))
        self._doubtful |= self._dropped & (self.weights > 0)
        self._dropped = self.weights == 0
        if iteration >= PATIENCE and (back := self._dropped & self._doubtful).any():
            self.weights = np.where(back, robust_weights(off, self.sigma), self.weights)
        if not self.weights.all():  # what has no weight in the fit has none in its noise
            self.sigma = self._noise(residual, self.weights > 0)
        if self.estimated and iteration == close + self.later:
            quiet = robust_weights(residual, self.sigma, self._found.kind) > 0  # gross errors say nothing of poses
            self.shared = shared_by_repeats(self._found, residual, quiet, self._carried, self._leverage)

    def _noise(self, residual: Array, quiet: np.ndarray | None = None) -> Array:
        if self._known is not None:
            return np.full(residual.shape[1], self._known)
        freed = self.shared.freed(residual if quiet is None else np.where(quiet[:, None], residual, np.nan))
        return robust_sigma(freed.reshape(-1, residual.shape[1]), self._leverage, self._robust, self._found)

    def used(self, linear: System, solution: Solution, read: np.ndarray) -> None:
        """Note which part of each group's readings a solution has used up."""
        degrees = solution.degrees + linear.n_m
        self._leverage = (
            np.full(len(self._leverage), degrees / max(self._found.n_scalars, 1.0))
            if self._found.made
            else _leverage(linear, solution, read, self._found.kind.noise_groups(6))
        )
        self._carried = degrees, 0.0
        if self.estimated and self._found.known is not None:  # points of one pose tell more than their mean
            means = by_means(_taken_up(linear, solution), read, self._found.group)
            self._carried = means, degrees - means

    def objective(self, at: Fit, weight: float) -> float:
        """Return the objective where a fit ended, rows weighed as here."""
        rows = self.whitened(at.residual)
        return float(rows @ rows + weight * np.sum(at.departure**2))

    def whitened(self, residual: Array) -> Array:
        """Return residuals (R, k) as `system` weighs them (scalars,), unread components dropped."""
        return whitened(residual, np.isfinite(residual), self.sigma, self.weights, self.shared)


class _Exact:
    """A problem as a sum of squares: rows weighed anew and the rule's directions chosen wherever it is made linear."""

    def __init__(self, problem: Problem, solver: Solver, rows: _Rows, exact: bool, follow: bool) -> None:
        self.problem, self._solver, self.rows = problem, solver, rows
        self._soft = problem.gives_way and exact
        self._close = ESTIMATED_AT
        self._follow = follow and self._soft
        self._felt: tuple[Array, int] | None = None  # by which derivatives gain as loads follow, and when that was so

    def linearise(self, at: State, promised: Sequence[float]) -> Linear:
        """Weigh the rows, solve by the rule, and return what is left of its objective by steps.

        Derivatives follow the loads where they are to, and from there on are taken for those: they are as good as exact
        while steps stay within a part of a standard deviation, as those do that promise little.
        """
        problem, rows, count = self.problem, self.rows, len(promised)
        found = problem.linearise(at.errors, at.instrument, at.machine)
        if self._follow:
            self._felt, self._follow = (problem.followed(*at), count), False
        if self._felt is not None:
            found = found._replace(J_p=found.J_p + self._felt[0])
        if 0 < count < self._close and promised[-1] < UNSETTLED:
            self._close = count
        rows.weigh(found.residual, count, self._close)
        departure = (at.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
        self.system = system(found, rows.sigma, rows.weights, rows.shared, problem.scale)
        A, b = self.system.machine
        # the solver draws towards the reference: it is asked for the whole departure, not for a step
        solution = self._solver.solve(A, b + A @ departure, float(rows.sigma[0]), len(self.system.b))
        if count == self._close:
            self._solver = self._solver.settled(solution)
        rows.used(self.system, solution, np.isfinite(found.residual))
        self.residuals, self.solution, self._departure = found.residual, solution, departure
        return self._linear()

    def _linear(self) -> Linear:
        n_m, n, departure = self.system.n_m, len(self._departure), self._departure
        rows, triangle, kept = self.system.rows, self.system.triangle, self.solution.factors > 0
        if (weight := self._solver.weight) is None:  # a truncation goes the whole way, but for where it lost direction
            s = self.solution.u - departure
            s = s * min(1.0, LONGEST / max(float(np.max(np.abs(s), initial=0.0)), LONGEST))
            return Linear(rows, triangle, step=np.concatenate([self.system.following(s), s]))
        more = np.sqrt(weight) * np.column_stack([np.zeros((n, n_m)), np.eye(n), -departure]) if weight else None
        influence = np.sqrt((triangle[:, :-1] ** 2).sum(axis=0))
        usual = np.sqrt(np.mean(influence[n_m:] ** 2)) if n else 1.0
        size = np.append(influence[:n_m] / max(usual, TINY), np.ones(n))  # an instrument's as that of ordinary errors
        if self.solution.posterior or kept.sum() == n:
            return Linear(rows, triangle, more, size)
        free = np.zeros((n_m + n, n_m + int(kept.sum())))
        free[:n_m, :n_m], free[n_m:, n_m:] = np.eye(n_m), self.solution.V[:, kept]
        return Linear(rows, triangle, more, size, free)

    def stepped(self, at: State, step: Array, near: State) -> State | None:
        """Return the state after a step of instrument and parameters; None where a pose is out of reach."""
        problem, n_m = self.problem, self.system.n_m
        errors = at.errors.copy()
        errors[problem.columns] += step[n_m:] * problem.scale
        try:
            machine = problem.solve(errors, near=near.machine)
        except InputError:
            return None
        t = step[:n_m]
        moved = at.instrument.stepped(t)
        if n_m:
            # turns lead along arcs: what leaves the linear step is made up for where the instrument moves much
            rest, back, x = self.system.rows @ np.append(-step, 1.0), self.system.back, problem.seen(machine)
            for _ in range(ARCS):
                t = t + back @ (self.rows.whitened(problem.residual(errors, moved, x)) - rest)
                moved = at.instrument.stepped(t)
        return State(errors, moved, machine)

    def residual(self, at: State) -> Array:
        """Return the rows at a state, and those of the prior."""
        problem = self.problem
        rows = self.rows.whitened(problem.residual(at.errors, at.instrument, problem.seen(at.machine)))
        if not self._solver.weight:
            return rows
        departure = (at.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
        return np.concatenate([rows, -np.sqrt(self._solver.weight) * departure])

    def settle(self, promised: Sequence[float]) -> bool:
        """Tell whether weights have been estimated, and derivatives follow the loads: otherwise they will."""
        if len(promised) <= (self._close + 1 + self.rows.later if self.rows.estimated else 1):
            return False
        self._follow = self._soft and (self._felt is None or sum(promised[self._felt[1] :]) >= SETTLED)
        return not self._follow


def _ended(model: _Exact, start: State, tolerance: float, must_converge: bool) -> Fit:
    """Return the fit that an iteration from a state leads to."""
    little = SETTLED if tolerance <= CONVERGED else np.inf  # within a search the rest of a bent valley is not walked
    end = least_squares(model, start, tolerance=tolerance, iterations=MAX_ITERATIONS, little=little)
    problem, rows = model.problem, model.rows
    if must_converge and end.status is Status.ITERATIONS and min(end.promised[-3:]) >= UNSETTLED:
        _blame(problem, model.residuals)
        last = ", ".join(f"{h:.1e}" for h in end.promised[-3:])
        raise NoConvergence(
            f"the fit of {len(problem.names)} parameters did not converge in {MAX_ITERATIONS} iterations: the "
            f"last ones promised to lower chi2 by {last}. Try a smaller model, a TSVD or priors."
        )
    noise = _shared_noise(problem, rows.weights, end.at.machine.x)
    return Fit(
        problem=problem,
        errors=end.at.errors,
        machine=end.at.machine,
        instrument=end.at.instrument,
        residual=model.residuals,
        weights=rows.weights,
        sigma=rows.sigma,
        solution=model.solution,
        covariance=_joint_covariance(model.solution, model.system, problem.scale, noise),
        repeats=rows.shared,
        history=end.promised,
        status=end.status,
    )


def rough(problem: Problem, robust: bool = True, must_converge: bool = True) -> Fit:
    """Fit the mechanism's smallest model, the encoder offsets, starting from the robot file.

    A mechanism without a smaller model than its full one is fitted whole, with as much as drawings leave open, or its
    file. Where nobody says where the measured point is, it is found beside. Readings of joints see none of it.
    """
    models = problem.mechanism.models
    smallest = () if problem.readings.kind.sees_joints else min(models.values(), key=len)
    left_open = unsaid(problem.with_names(max(models.values(), key=len))) if smallest else ()
    coarse = problem.with_names(tuple(dict.fromkeys((*smallest, *left_open))))
    whole = len(smallest) == max(map(len, models.values()))
    if whole or left_open:
        broad = np.maximum((BROAD if whole else ANY) * coarse.scale, with_prior(coarse, problem.robot)[0].scale)
        coarse = dataclasses.replace(coarse, scale=broad)
    solver = Prior() if whole or left_open else LeastSquares()
    return fit(coarse, solver, robust=robust, weigh_repeats=False, must_converge=must_converge, across=False)


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
    linear = system(state, full.sigma, full.weights, full.repeats, problem.scale)
    read = np.isfinite(state.residual)
    owner = np.repeat(np.arange(len(read)), read.sum(axis=1))
    departure = full.departure
    gross = np.zeros(len(read), dtype=bool)
    gross[full.gross] = True
    out = np.full(state.residual.shape, np.nan)
    for train, test in parts:
        rows, test = train[owner], test & ~gross
        if not test.any() or rows.sum() <= full.solution.degrees + full.instrument.n_unknown:
            continue
        part = linear.subset(rows, full.weights, full.repeats)
        A, b = part.machine
        step = solver.solve(A, b + A @ departure, float(full.sigma[0]), len(part.b)).u - departure
        R, along = part.instrument
        m_step = np.linalg.lstsq(R, along[:, -1] - along[:, :-1] @ step, rcond=None)[0]
        moved = state.J_p[test] @ (step * problem.scale) + state.J_m[test] @ m_step
        out[test] = state.residual[test] - moved
    return out


def _blame(problem: Problem, residual: Array) -> None:
    """Raise an InputError that names the worst reading, where one stands so far out that it spoils the fit."""
    size = np.linalg.norm(np.nan_to_num(lengths(residual, problem.readings.kind)), axis=1)
    worst, usual = int(np.argmax(size)), float(np.median(size))
    if size[worst] > SPOILT * usual:
        lines = [str(line) for line in problem.readings.line[size > SPOILT * usual]]
        remedy = "Check the joints and the measured cells of this row, or remove it."
        if len(lines) > 1:
            remedy = (
                f"{len(lines)} readings are so far off: lines {', '.join(lines[:FEW])}{' ...' * (len(lines) > FEW)}. "
                "Check their joints and measured cells; where a joint moves in these rows alone, compare it with the "
                "robot file."
            )
        raise ImplausibleReadings(
            f"the reading is {size[worst]:.4g} mm off the machine at these joints, most others {usual:.3g} mm.",
            remedy,
            file=problem.recording.path,
            line=int(problem.readings.line[worst]),
        )


def _leverage(linear: System, solution: Solution, read: np.ndarray, groups: np.ndarray) -> Array:
    """Return the part of each group's readings that the fit uses up (g,): the mean of the hat matrix's diagonal."""
    if not groups[: read.shape[1]].any():  # of all rows it is the trace
        return np.array([(solution.degrees + linear.n_m) / max(len(linear.b), 1)])
    hat = (_taken_up(linear, solution) ** 2).sum(axis=1)
    own = np.broadcast_to(groups[: read.shape[1]], read.shape)[read]
    parts = (own == group for group in range(groups.max() + 1))
    return np.array([hat[part].mean() if part.any() else 0.0 for part in parts])


def _taken_up(linear: System, solution: Solution) -> Array:
    """Return columns (scalars, n_m + n) whose products are the hat matrix: what of the rows a solution takes up."""
    Q = basis(linear.A_m)
    A = project_out(linear.A_p, Q)
    with np.errstate(divide="ignore", invalid="ignore"):
        weight = np.where(solution.factors > 0, np.sqrt(solution.factors) / solution.singular_values, 0.0)
    return np.hstack([Q, A @ solution.V * weight])


def by_means(taken: Array, read: np.ndarray, group: np.ndarray) -> float:
    """Return how many of the parameters that columns (scalars, n) took up were carried by the means of groups (R,)."""
    pose, component = np.broadcast_to(group[:, None], read.shape)[read], np.nonzero(read)[1]
    _, mean = np.unique(np.column_stack([pose, component]), axis=0, return_inverse=True)
    mean = np.ravel(mean)
    sums = np.zeros((int(mean.max()) + 1, taken.shape[1]))
    np.add.at(sums, mean, taken)
    return float((sums**2 / np.bincount(mean)[:, None]).sum())


def _shared_noise(problem: Problem, weights: Array, x: Array) -> Array | None:
    """Return how the noise of positions enters distances made of them, (R, positions * 3), rows as in `system`.

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


def _joint_covariance(solution: Solution, linear: System, scale: Array, shared: Array | None) -> Array:
    """Return the covariance of parameters and instrument: ``m = m* - A_m^+ A_p dp``."""
    C = solution.covariance
    if shared is not None:
        with np.errstate(divide="ignore", invalid="ignore"):
            inverse_s = np.where(solution.factors > 0, solution.factors / solution.singular_values, 0.0)
            U = np.where(solution.factors > 0, (linear.A_p @ solution.V) / solution.singular_values, 0.0)
        response = (solution.V * inverse_s) @ (U.T @ shared)
        left = (solution.V * (1 - solution.factors) ** 2) @ solution.V.T if solution.posterior else 0.0
        beyond = np.eye(len(C)) - solution.V @ solution.V.T if solution.posterior else 0.0
        C = response @ response.T + left + beyond
    n, n_m = len(scale), linear.n_m
    out = np.zeros((n + n_m, n + n_m))
    out[:n, :n] = C
    if n_m:
        R, along = linear.instrument
        inverse = np.linalg.pinv(R)
        follow = -np.linalg.lstsq(R, along[:, :-1], rcond=None)[0]
        out[n:, :n] = follow @ C
        out[:n, n:] = out[n:, :n].T
        out[n:, n:] = follow @ C @ follow.T + inverse @ inverse.T
    full = np.concatenate([scale, np.ones(n_m)])
    result: Array = out * np.outer(full, full)
    return result
