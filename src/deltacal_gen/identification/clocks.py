"""Two clocks set against each other: offset and rate, found together with geometry and instrument.

Readings are smooth functions of the nominal pose, whatever the frame: by these it is found where the clocks may stand
(`motion.alignment`). The derivative of a reading by its time is that by the joints times their velocity.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Factored, Prior
from deltacal_gen.estimation.system import system
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.checks import chosen_model
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.motion import alignment
from deltacal_gen.motion.alignment import GRID, Alignment, Bar, Made
from deltacal_gen.motion.clocks import Clock, TwoClocks
from deltacal_gen.motion.regression import together
from deltacal_gen.physics.terms import Term
from deltacal_gen.states import SPEEDS, TIME
from deltacal_gen.units import joint_factors, joint_names

Progress = Callable[[str], None]

BAR = Bar(follows=0.9, as_good=2.0)
MOST = 4000  # readings by which clocks are set; more tell no more than the next minute does


def aligned(
    robot: Robot,
    given: TwoClocks,
    model: str | None = None,
    *,
    held: Sequence[Term] = (),
    start: Clock | None = None,
    progress: Progress = lambda text: None,
) -> Alignment:
    """Set the clocks of a recording against each other.

    Parameters
    ----------
    model : str, optional
        Geometry that is fitted beside; default as `identify`.
    held : sequence of Term
        Effects on the machine.
    start : Clock, optional
        Where they stand about; looked for by default.

    Raises
    ------
    InputError
        The clocks cannot be set by these readings; the message says why.
    """
    progress("where the clocks stand")
    clock = start or alignment.first(given, lambda runs: [_made(robot, given, runs)], BAR)
    mechanism = mechanism_of(robot)
    last: Fit | None = None

    def step(clock: Clock) -> tuple[Array, Array]:
        nonlocal last
        everything = pose_problem(robot, _some(given.at(clock)), (), held=held)
        own = everything.with_names(mechanism.model(chosen_model(everything, model)))
        near = last if last is not None and last.problem.names == own.names else None
        begun: dict[str, Any] = {} if near is None else {"errors": near.errors, "instrument": near.instrument}
        last = fit(with_prior(own, robot)[0], Prior(), weigh_repeats=False, **begun)
        return _step(given, len(clock.offsets), last)

    return alignment.settled(given, clock, step, beside="geometry or frame")


def _some(recording: Recording) -> Recording:
    """Return a recording, of a long one rows spread evenly."""
    if recording.n_rows <= MOST:
        return recording
    return recording.subset(np.unique(np.linspace(0, recording.n_rows - 1, MOST).astype(int)))


# ------------------------------------------------------------------------------------------------------------- a step


def _step(given: TwoClocks, count: int, found: Fit) -> tuple[Array, Array]:
    """Return what all unknowns together move the clocks by, offsets and then rate, and their standard deviations."""
    problem, recording = found.problem, found.problem.recording
    rows = problem.readings.rows[:, 0]
    run, time = recording.channels["run"][rows].astype(int), recording.channels[TIME][rows]
    linear = problem.linearise(found.errors, found.instrument, found.machine)
    by_time = _by_time(problem, found)
    runs = np.ones((len(run), 1)) if given.shared else run[:, None] == np.arange(count)
    by_clock = by_time[:, :, None] * runs[:, None, :]
    if given.rated:
        by_clock = np.concatenate([by_clock, (by_time * time[:, None])[:, :, None]], axis=2)
    by_all = linear._replace(J_m=np.concatenate([linear.J_m, by_clock], axis=2))
    whole = system(by_all, found.sigma, found.weights, found.repeats, problem.scale)
    known = Factored(whole.rows[:, :-1], np.repeat([0.0, 1.0], [whole.n_m, len(problem.scale)]))
    step = known.step(whole.b, np.concatenate([np.zeros(whole.n_m), found.departure]))
    std = np.sqrt(np.diag(known.covariance) * _together(found, run, time))
    clocks = slice(linear.J_m.shape[2], whole.n_m)
    return step[clocks], std[clocks]


def _by_time(problem: Problem, found: Fit) -> Array:
    """Return the derivatives (R, k) of readings by the joints' time."""
    recording, count = problem.recording, problem.recording.joints.shape[1]
    names = joint_names(recording.joint_unit, count, SPEEDS)
    speeds = np.column_stack([recording.channels[n] for n in names]) * joint_factors(recording.joint_unit, count)
    turned = (problem.robot.joint_sign * speeds)[problem.readings.rows[:, 0]]
    return np.einsum("rkj,rj->rk", found.by_displacements[:, :, :count], turned)


def _together(found: Fit, run: np.ndarray, time: Array) -> float:
    """Return how many readings tell as much as one whose noise is its own, of the component where these are most."""
    step = float(np.median(np.abs(np.diff(time)))) or 1.0
    left = np.nan_to_num(found.residual / found.sigma)
    used = np.isfinite(found.residual) & (found.weights > 0)[:, None]
    return max(together(left[:, k], run, used[:, k], step) for k in range(left.shape[1]))


# ------------------------------------------------------------------------------------------------------ where they are


def _made(robot: Robot, given: TwoClocks, runs: Sequence[int]) -> Made:
    """Return the readings, and functions of the nominal pose in some runs."""
    found = []
    for r, movement in ((r, movement) for r, movement in given.movements if r in runs):
        times = np.arange(movement.start, movement.end, GRID / 2)
        rows = np.zeros(len(times), dtype=int)
        along = dataclasses.replace(given, recording=given.recording.subset(rows), time=times, run=rows + r)
        problem = pose_problem(robot, along.at(Clock(np.zeros(len(given.run_names)))), ())
        seen = problem.seen(problem.body.solve(*problem.split(problem.reference))[0])
        x = seen if problem.readings.kind.sees_joints else seen[:, :3]
        there = np.isfinite(x).all(axis=1)
        if there.sum() > 2:
            found.append((r, times[there], x[there]))
    if not found:
        return Made(given.recording.measured, [])
    every = np.concatenate([x for *_, x in found])
    middle, size = every.mean(axis=0), np.maximum(every.std(axis=0), 1e-9)
    return Made(given.recording.measured, [(r, t, _functions((x - middle) / size)) for r, t, x in found])


def _functions(x: Array) -> Array:
    """Return 1, coordinates (M, n), and their products."""
    i, j = np.triu_indices(x.shape[1])
    return np.hstack([np.ones((len(x), 1)), x, x[:, i] * x[:, j]])
