"""Steps that lower a sum of squares: machine and instrument move together, held where the linear machine misleads.

A whole Gauss-Newton step goes as far along a weak direction as noise takes it: a frame read from points near a line, a
pair of links that stand parallel in all poses. There the exact machine bends long before the step ends. Every step is
therefore the least squares solution with a damping in units of each column's own influence (Levenberg 1944, Marquardt
1963): strong directions move freely, weak ones as far as the exact machine follows. The damping eases where the linear
machine keeps its promise and grows where it does not (Nielsen 1999). A step that keeps more than was promised, in a
valley that is flatter than the linear machine's, is made longer.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.solvers import WEAKEST, Solution
from deltacal_gen.estimation.system import System, length_of
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.deformed import Deformed

TRIALS = 30  # of the damping within a step: from none to that of a gradient step of rounding's size
FIRST, NONE, MOST = 1e-3, 1e-7, 1e16  # dampings: the first that is tried, below which there is none, the largest
EASE = 0.1  # by which a damping falls at most
TRUE = 0.75  # of what the linear machine promised: a step that keeps less is bent
MORE, LONGER = 1.5, 64.0  # of it: a step that keeps more is too short; by how much at most it is made longer
WEAK = 1e-3  # of the strongest direction of the instrument: weaker ones are damped as if they were so strong
EXACT = 1e-5  # of chi2: poses are solved no more exactly than to change the objective by this
SAME = 1e-12  # of the objective: less is rounding
LONGEST = 30.0  # ordinary errors: a truncation's step beyond it is no correction but a loss of direction
ARCS = 2  # corrections of a step
RANK = 1e-12  # of the largest singular value of columns of one length: below it a step is arbitrary


class State(NamedTuple):
    """A machine with given parameters and an instrument: where an iteration stands."""

    errors: Array
    instrument: Instrument
    machine: Deformed


@dataclass(frozen=True, eq=False)
class Linear:
    """The objective of a machine made linear.

    Attributes
    ----------
    system : System
    departure : (n,) array
        Of the scaled parameters from their reference.
    weight : float or None
        By which the square of the departure counts; None where a rule minimises no objective.
    """

    system: System
    departure: Array
    weight: float | None

    def left(self, s: Array, t: Array) -> float:
        """Return what steps of parameters and instrument leave of the objective."""
        whole = self.departure + s
        return self.system.left(s, t) + (self.weight or 0.0) * float(whole @ whole)

    def gain(self, s: Array) -> float:
        """Return by how much a step of the parameters, the instrument following, lowers the objective."""
        A, b = self.system.machine
        rest, whole, now = b - A @ s, self.departure + s, self.system.triangle[:, -1]
        prior = self.departure @ self.departure - whole @ whole
        return abs(float(now @ now - rest @ rest + (self.weight or 0.0) * prior))


class Damped:
    """The steps from one state, for every damping: factored once.

    Parameters
    ----------
    linear : Linear
    solution : Solution
        Of the parameters, the instrument taken out: its rule says in which directions they may move.
    """

    def __init__(self, linear: Linear, solution: Solution) -> None:
        (along, _), n_m = linear.system.instrument, linear.system.n_m
        n, R = len(linear.departure), linear.system.triangle
        kept = solution.factors > 0
        free = np.eye(n) if solution.posterior or kept.sum() == n else solution.V[:, kept]
        weight = np.sqrt(linear.weight or 0.0)
        self._system, self._free, self._n = linear.system, free, free.shape[1]
        own = np.hstack([R[:, n_m:-1] @ free, R[:, :n_m], R[:, -1:]])
        low = np.hstack([weight * free, np.zeros((n, n_m)), -weight * linear.departure[:, None]])
        R = np.asarray(np.linalg.qr(np.vstack([own, low]), mode="r")) if weight else own
        self._R, self._b = R[:, :-1], R[:, -1]
        self._damper = np.zeros((n + n_m, self._n + n_m))
        self._damper[:n, : self._n] = free
        if n_m:
            size = length_of(along)
            _, s, Vt = np.linalg.svd(along / size)
            usual = np.sqrt(np.mean((linear.system.triangle[:, n_m:-1] ** 2).sum(axis=0))) if n else 1.0
            self._damper[n:, self._n :] = np.maximum(s, WEAK * s[0])[:, None] * Vt * size / max(usual, SAME)

    def step(self, damping: float) -> tuple[Array, Array]:
        """Return the steps (n,) of the scaled parameters and (n_m,) of the instrument."""
        return self._step(self._b, damping)

    def bent(self, off: Array, damping: float) -> tuple[Array, Array]:
        """Return what a step is lengthened by where the rows (scalars,) that it leaves are `off` the linear ones."""
        pull = self._system.rows[:, :-1].T @ off
        pull = np.concatenate([pull[self._system.n_m :] @ self._free, pull[: self._system.n_m]])
        return self._step(_solved(self._R.T, pull), damping)

    def _step(self, b: Array, damping: float) -> tuple[Array, Array]:
        A = self._R
        if damping:
            A = np.vstack([A, np.sqrt(damping) * self._damper])
            b = np.concatenate([b, np.zeros(len(self._damper))])
        z = _solved(A, b)
        return self._free @ z[: self._n], z[self._n :]


@np.errstate(over="ignore", invalid="ignore")  # of steps that lead beyond all numbers: they are not taken
def improved(
    problem: Problem,
    state: State,
    linear: Linear,
    solution: Solution,
    whitened: Callable[[Array], Array],
    damping: float,
    worth: float = 0.0,
) -> tuple[State, float]:
    """Take the step that lowers the objective, damped as far as needed; return the new state and the damping.

    The state is the same where no step lowers the objective beyond rounding. A rule without an objective (a truncation)
    takes whole steps.

    Parameters
    ----------
    whitened : callable
        Makes rows (scalars,) of residuals (R, k), weighed as those of `linear`.
    worth : float
        Of the objective: a shorter step that promises less is not tried.
    """
    if linear.weight is None:
        return _truncated(problem, state, linear, solution, whitened, damping)
    weight, steps = linear.weight, Damped(linear, solution)
    columns, scale = problem.columns, problem.scale

    def tried(s: Array, t: Array, near: State = state) -> tuple[State | None, Array, float]:
        """Return the state after a step, what it leaves of the rows, and the objective there."""
        trial = _moved(problem, state, linear, s, t, whitened, near.machine)
        if trial is None:
            return None, linear.system.b, np.inf
        rows = whitened(problem.residual(trial.errors, trial.instrument, problem.seen(trial.machine)))
        u = (trial.errors[columns] - problem.reference[columns]) / scale
        return trial, rows, float(rows @ rows + weight * (u @ u))

    still = np.zeros(len(scale)), np.zeros(linear.system.n_m)
    before, harder = linear.left(*still), 10.0
    for _ in range(TRIALS):
        s, t = steps.step(damping)
        trial, rows, after = tried(s, t)
        promised = before - linear.left(s, t)
        if trial is not None and before - after < TRUE * promised:
            s_2, t_2 = steps.bent(rows - linear.system.rest(s, t), damping)
            bent, _, lower = tried(s + s_2, t + t_2, trial)
            if lower < after:
                trial, after = bent, lower
        if trial is not None and not damping and before - after > MORE * promised > MORE * worth:
            # of a parabola: by how much longer a step ends at its bottom
            far, most = 2.0, promised / max(2 * promised - (before - after), SAME * before)
            while far <= min(most, LONGER):
                there, rows, _ = tried(far * s, far * t, trial)
                s_2, t_2 = steps.bent(rows - linear.system.rest(far * s, far * t), damping)
                there, _, lower = tried(far * s + s_2, far * t + t_2, there or trial)
                if there is None or lower >= after:
                    break
                trial, after, far = there, lower, 2 * far
        if trial is not None and after <= before * (1 - SAME):
            kept = float(np.clip((before - after) / promised, 0.0, 1.0)) if promised > EXACT else 1.0
            eased = damping * max(EASE, 1 - (2 * kept - 1) ** 3)
            return trial, eased if eased > NONE else 0.0
        if after <= before * (1 + SAME) or promised <= worth:
            break  # nothing better within rounding, or nothing to be had by shorter steps
        damping, harder = min(max(damping * harder, FIRST), MOST), 2 * harder
    return state, damping


def _truncated(
    problem: Problem,
    state: State,
    linear: Linear,
    solution: Solution,
    whitened: Callable[[Array], Array],
    damping: float,
) -> tuple[State, float]:
    """Take the whole step of a truncation, shortened where it is too long or leads to where no machine stands."""
    whole = solution.u - linear.departure
    whole = whole * min(1.0, LONGEST / max(float(np.max(np.abs(whole), initial=0.0)), LONGEST))
    for _ in range(TRIALS):
        s = whole / (1.0 + damping)
        trial = _moved(problem, state, linear, s, following(linear.system, s), whitened, state.machine)
        if trial is not None:
            return trial, damping / 10
        damping = max(4 * damping, 1.0)
    return state, damping


def _moved(
    problem: Problem,
    state: State,
    linear: Linear,
    s: Array,
    t: Array,
    whitened: Callable[[Array], Array],
    near: Deformed,
) -> State | None:
    """Return the state after a step, its machine sought near another; None where a pose is out of reach."""
    errors = state.errors.copy()
    errors[problem.columns] += s * problem.scale
    try:
        machine = problem.solve(errors, near=near)
    except InputError:
        return None
    moved = state.instrument.stepped(t)
    if len(t):
        # turns lead along arcs: what leaves the linear step is made up for where the instrument moves the readings much
        rest, back, x = linear.system.rest(s, t), linear.system.back, problem.seen(machine)
        for _ in range(ARCS):
            t = t + back @ (whitened(problem.residual(errors, moved, x)) - rest)
            moved = state.instrument.stepped(t)
    return State(errors, moved, machine)


def following(system: System, s: Array) -> Array:
    """Return the instrument's step that goes best with a step of the parameters."""
    if not system.n_m:
        return np.zeros(0)
    R, along = system.instrument
    return _solved(R, along[:, -1] - along[:, :-1] @ s, WEAKEST)


def _solved(A: Array, b: Array, rank: float = RANK) -> Array:
    """Return the least squares solution of columns made one length, directions below `rank` of the largest left."""
    size = length_of(A)
    return np.asarray(np.linalg.lstsq(A / size, b, rcond=rank)[0] / size)
