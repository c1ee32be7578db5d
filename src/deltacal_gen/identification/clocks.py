"""Two clocks set against each other: offset and rate, found together with geometry and instrument.

Where they may stand is first looked for over all offsets at which joints and readings overlap: readings are smooth
functions of the nominal pose, whatever the frame. From there Gauss-Newton on all unknowns at once: the derivative of a
reading by its time is that by the joints times their velocity.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.checks import chosen_model
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.motion.clocks import Clock, TwoClocks
from deltacal_gen.motion.regression import together
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.result import Parameter, Status
from deltacal_gen.states import SPEEDS, TIME
from deltacal_gen.units import joint_factors, joint_names

Progress = Callable[[str], None]

MOST_LAGS = 20000  # offsets that are looked at
GRID = 0.02  # s between offsets that are looked at first: a tenth of the quickest swing of a large machine
LOOKED_AT = 400  # readings of a run, at most, by which offsets are looked at
OVERLAP = 0.5  # of the readings that an offset may leave with joints, at least, of the most that any leaves
FOLLOWS = 0.9  # of the readings' variance that the joints must make at the best offset
AS_GOOD = 2.0  # times what the best offset leaves: another one that leaves less cannot be told from it
MOST = 4000  # readings by which clocks are set; more tell no more than the next minute does
ROUNDS = 20
SETTLED = 0.02  # standard deviations that the last step may still move a clock by
LEAST_KNOWN = 0.02  # s of standard deviation of an offset: less well known it is not known


@dataclass(frozen=True, eq=False)
class Alignment:
    """How the instrument's clock stands, and how surely.

    Attributes
    ----------
    clock : Clock
    offset_std : (R,) array
        [s]
    rate_std : float or None
        None where the rate is said to be the same.
    """

    clocks: TwoClocks
    clock: Clock
    offset_std: Array
    rate_std: float | None

    @property
    def recording(self) -> Recording:
        """The readings with the joints as they were then."""
        return self.clocks.at(self.clock)

    def again(
        self, robot: Robot, model: str | None, *, held: Sequence[Term], progress: Progress
    ) -> tuple[Recording, Alignment]:
        """Return the recording, and how its clocks stand, beside effects that act on the machine."""
        found = aligned(robot, self.clocks, model, held=held, start=self.clock, progress=progress)
        return found.recording, found

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Offsets and rate as answers give them."""
        runs = [None] if self.clocks.shared else list(self.clocks.run_names)
        found = [
            _parameter("clock_offset", float(self.clock.offsets[k]), float(self.offset_std[k]), "s", run)
            for k, run in enumerate(runs)
        ]
        if self.rate_std is not None:
            found.append(_parameter("clock_rate", self.clock.rate, self.rate_std, "1", None))
        return tuple(found)


def _parameter(name: str, value: float, std: float, unit: str, run: str | None) -> Parameter:
    alike = ("latency: readings that come late do what a clock does that stands off",) if name[6:] == "offset" else None
    return Parameter(
        name=name, value=value, std=std, unit=unit, status=Status.IDENTIFIED, run=run, indistinguishable_from=alike
    )


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
    clock = _first(robot, given) if start is None else start
    mechanism, fitted = mechanism_of(robot), None
    for _ in range(ROUNDS):
        recording = _some(given.at(clock))
        everything = pose_problem(robot, recording, (), held=held)
        names = mechanism.model(chosen_model(mechanism, everything, recording, model))
        problem, _given = with_prior(everything.with_names(names), robot)
        same = fitted is not None and fitted.problem.names == problem.names
        fitted = fit(
            problem,
            Prior(),
            errors=fitted.errors if fitted is not None and same else None,
            instrument=fitted.instrument if fitted is not None and same else None,
            weigh_repeats=False,
        )
        step, std = _step(given, len(clock.offsets), fitted)
        count = len(clock.offsets) if not given.shared else 1
        offsets = np.broadcast_to(step[:count], clock.offsets.shape)
        clock = Clock(clock.offsets + offsets, clock.rate + (float(step[count]) if given.rated else 0.0))
        if (np.abs(step) < SETTLED * std).all():
            break
    else:
        raise _refused(given, "the offset of the clocks does not settle", "Record a movement with sharper turns.")
    loose = std[:count] > LEAST_KNOWN
    if loose.any():
        run = "" if given.shared else f" of run '{given.run_names[int(np.argmax(loose))]}'"
        raise _refused(
            given,
            f"the movement{run} does not tell its clock: the offset is known to {std[:count].max():.2g} s only, since "
            "geometry or frame can do the same",
            "Let the joints change their speeds and turn back.",
        )
    return Alignment(
        given, clock, np.broadcast_to(std[:count], clock.offsets.shape), float(std[count]) if given.rated else None
    )


def _some(recording: Recording) -> Recording:
    """Return a recording, of a long one rows spread evenly."""
    if recording.n_rows <= MOST:
        return recording
    return recording.subset(np.unique(np.linspace(0, recording.n_rows - 1, MOST).astype(int)))


def _refused(given: TwoClocks, problem: str, remedy: str) -> InputError:
    return InputError(f"joints and readings cannot be aligned in time: {problem}.", remedy, file=given.recording.path)


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
    J = np.concatenate([linear.J_p * problem.scale, linear.J_m, by_clock], axis=2)
    weight = np.sqrt(found.weights)[:, None] / found.sigma
    read = np.isfinite(linear.residual)
    A, r = (J * weight[:, :, None])[read], (linear.residual * weight)[read]
    n, size = len(problem.scale), np.linalg.norm(A, axis=0)
    size[size == 0] = 1.0
    prior = np.zeros((n, A.shape[1]))
    prior[np.arange(n), np.arange(n)] = 1.0
    departed = (found.errors - problem.reference)[problem.columns] / problem.scale
    whole = np.vstack([A, prior]) / size
    solution = np.linalg.lstsq(whole, np.concatenate([r, -departed]), rcond=1e-12)[0] / size
    covariance = np.linalg.pinv(whole.T @ whole, rcond=1e-13, hermitian=True) / np.outer(size, size)
    std = np.sqrt(np.maximum(np.diag(covariance), 0.0)) * np.sqrt(_together(found, run, time))
    at = n + linear.J_m.shape[2]
    return solution[at:], std[at:]


def _by_time(problem: Problem, found: Fit) -> Array:
    """Return the derivatives (R, k) of readings by the joints' time."""
    used, x = problem.readings.used, problem.seen(found.machine)
    sensitivity = problem.sensitivity(found.machine, used)
    recording, count = problem.recording, problem.recording.joints.shape[1]
    names = joint_names(recording.joint_unit, count, SPEEDS)
    speeds = np.column_stack([recording.channels[n] for n in names]) * joint_factors(recording.joint_unit, count)
    turned = problem.robot.joint_sign * speeds
    dx = np.zeros((len(x), sensitivity.joints.shape[1], 1))
    dx[used, :, 0] = np.einsum("nxj,nj->nx", sensitivity.joints, turned[used])
    mounted = found.instrument.mounted(problem.mechanism, found.errors)
    return np.asarray(mounted.linearise(problem.readings, x, dx)[0][:, :, 0])


def _together(found: Fit, run: np.ndarray, time: Array) -> float:
    """Return how many readings tell as much as one whose noise is its own, of the component where these are most."""
    step = float(np.median(np.abs(np.diff(time)))) or 1.0
    left = np.nan_to_num(found.residual / found.sigma)
    used = np.isfinite(found.residual) & (found.weights > 0)[:, None]
    return max(together(left[:, k], run, used[:, k], step) for k in range(left.shape[1]))


# ------------------------------------------------------------------------------------------------------ where they are


def _first(robot: Robot, given: TwoClocks) -> Clock:
    """Return where the clocks stand about, by an offset of every run, or one of all."""
    groups = [list(range(len(given.run_names)))] if given.shared else [[k] for k in range(len(given.run_names))]
    offsets = np.zeros(len(given.run_names))
    for runs in groups:
        offsets[runs] = _best(robot, given, runs)
    return Clock(offsets)


def _best(robot: Robot, given: TwoClocks, runs: Sequence[int]) -> float:
    """Return the offset [s] at which some runs' readings are best made of functions of the nominal pose.

    Raises
    ------
    InputError
        None is good, or two are.
    """
    tables = _tables(robot, given, runs)
    own = np.flatnonzero(np.isin(given.run, runs) & np.isfinite(given.recording.measured).any(axis=1))
    own = own[np.unique(np.linspace(0, len(own) - 1, LOOKED_AT * len(runs)).astype(int))] if len(own) else own
    if not tables or not len(own):
        raise _refused(given, "no joints, or no readings, of a run", "Record both.")
    time, run, Y = given.time[own], given.run[own], given.recording.measured[own]
    Y = Y[:, np.isfinite(Y).all(axis=0)] if np.isfinite(Y).all(axis=0).any() else Y[:, :1]
    low = min(t[0] - time[run == r].max() for r, t, _ in tables if (run == r).any())
    high = max(t[-1] - time[run == r].min() for r, t, _ in tables if (run == r).any())
    lags = np.linspace(low, high, min(MOST_LAGS, max(3, round((high - low) / GRID))))
    each, count = (np.array(v) for v in zip(*(_left(lag, time, run, Y, tables) for lag in lags), strict=True))
    each[count < OVERLAP * count.max()] = np.inf
    follows = each.min(axis=0) < 1.0 - FOLLOWS  # a platform that does not turn tells no time by its turns
    if not follows.any():
        raise _refused(
            given,
            "the readings follow the joints at no offset",
            "Check that both files are of the same movement, and that the robot file is of this machine.",
        )
    left = each[:, follows].mean(axis=1)
    best = int(np.argmin(left))
    if (other := _other_valley(left, best)) is not None and left[other] < AS_GOOD * left[best]:
        raise _refused(
            given,
            f"offsets of {lags[best]:.3f} s and {lags[other]:.3f} s do as well, since the movement repeats itself",
            "Begin the movement with something that does not come again, or say clock_offset_s.",
        )
    return float(lags[best])


def _other_valley(left: Array, best: int) -> int | None:
    """Return the best offset (index) beyond the slopes about the best one; None where there is none."""
    first = last = best
    while first > 0 and left[first - 1] >= left[first]:
        first -= 1
    while last < len(left) - 1 and left[last + 1] >= left[last]:
        last += 1
    outside = np.concatenate([np.arange(first), np.arange(last + 1, len(left))])
    return int(outside[np.argmin(left[outside])]) if len(outside) else None


def _left(
    lag: float, time: Array, run: np.ndarray, Y: Array, tables: Sequence[tuple[int, Array, Array]]
) -> tuple[Array, int]:
    """Return which part of the variance of each reading (k,) an offset leaves, and of how many rows."""
    rows, basis = [], []
    for r, times, columns in tables:
        when = time + lag
        inside = np.flatnonzero((run == r) & (when >= times[0]) & (when <= times[-1]) & np.isfinite(Y).all(axis=1))
        rows.append(inside)
        at = np.clip(np.searchsorted(times, when[inside]), 1, len(times) - 1)
        part = ((when[inside] - times[at - 1]) / (times[at] - times[at - 1]))[:, None]
        basis.append((1 - part) * columns[at - 1] + part * columns[at])
    own, B = np.concatenate(rows), np.concatenate(basis)
    if len(own) < 3 * B.shape[1]:
        return np.full(Y.shape[1], np.inf), len(own)
    y = Y[own] - Y[own].mean(axis=0)
    G = B.T @ B
    G[np.diag_indices_from(G)] *= 1 + 1e-9
    b = B.T @ y
    rest = np.sum(y**2, axis=0) - np.sum(b * np.linalg.solve(G, b), axis=0)
    return np.asarray(rest / np.maximum(np.sum(y**2, axis=0), 1e-300)), len(own)


def _tables(robot: Robot, given: TwoClocks, runs: Sequence[int]) -> list[tuple[int, Array, Array]]:
    """Return of each movement of some runs its run, times (M,), and functions (M, b) of the nominal pose then."""
    found = []
    for r, movement in given.movements:
        if r not in runs:
            continue
        times = np.arange(movement.start, movement.end, GRID / 2)
        rows = np.zeros(len(times), dtype=int)
        along = dataclasses.replace(
            given, recording=given.recording.subset(rows), time=times, run=np.full(len(times), r)
        )
        problem = pose_problem(robot, along.at(Clock(np.zeros(len(given.run_names)))), ())
        machine, _ = problem.body.solve(*problem.split(problem.reference))
        x = problem.seen(machine)[:, :3] if not problem.readings.kind.sees_joints else problem.seen(machine)
        there = np.isfinite(x).all(axis=1)
        if there.sum() > 2:
            found.append((r, times[there], x[there]))
    if not found:
        return []
    every = np.concatenate([x for *_, x in found])
    middle, size = every.mean(axis=0), np.maximum(every.std(axis=0), 1e-9)
    return [(r, t, _functions((x - middle) / size)) for r, t, x in found]


def _functions(x: Array) -> Array:
    """Return 1, coordinates (M, n), and their products."""
    i, j = np.triu_indices(x.shape[1])
    return np.hstack([np.ones((len(x), 1)), x, x[:, i] * x[:, j]])
