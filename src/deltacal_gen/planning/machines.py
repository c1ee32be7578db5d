"""Machines drawn at random, measured as planned and calibrated, chunk by chunk; effects concealed in some."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Factored
from deltacal_gen.execution import content_key
from deltacal_gen.files.robot import Robot, robot_to_dict
from deltacal_gen.identification.accuracy import check_joints, without_motion
from deltacal_gen.instrument.kind import Instrument, Readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, kept_term
from deltacal_gen.results import study as results
from deltacal_gen.results.base import Value

STEPS = 12  # of Gauss-Newton with the nominal Jacobian, at most
DONE = 0.05  # standard deviations: by which the last step may still change a parameter; a next one would be a tenth


@dataclass(frozen=True)
class Study:
    """A robot, a plan of poses, and what is unknown of the machine.

    Attributes
    ----------
    robot : Robot
        The machine as drawn, with tolerances.
    poses : Recording
        Joints or targets, kind and channels of the measurement; its readings are not looked at.
    names : tuple of str
        Source errors that the calibration frees.
    errors : tuple of str
        Source errors that machines have.
    sigma, turn_sigma : float
        Noise per coordinate [mm], of images and encoders at the platform, and of rotations [rad].
    suspects : tuple of tuple of Term
        Each what one machine has beside its geometry.
    seed : int
    """

    robot: Robot
    poses: Recording
    names: tuple[str, ...]
    errors: tuple[str, ...]
    sigma: float
    turn_sigma: float = 0.0
    suspects: tuple[tuple[Term, ...], ...] = ()
    seed: int = 0
    chunk: ClassVar[int] = 500

    @cached_property
    def problem(self) -> Problem:
        """The calibration of the plan's recording, read from the nominal machine without noise."""
        nominal = dataclasses.replace(self.robot, errors={})
        problem = pose_problem(nominal, simulate(nominal, self.poses), self.names)
        return with_prior(problem, self.robot)[0]

    @cached_property
    def spread(self) -> Array:
        """Standard deviations (n_p,) of the source errors of machines; 0 for those that they do not have."""
        mechanism = self.problem.mechanism
        named = [
            self.robot.tolerance.get(p.name, t) for p, t in zip(mechanism.parameters, mechanism.typical, strict=True)
        ]
        return np.where([p.name in self.errors for p in mechanism.parameters], named, 0.0)

    @cached_property
    def linear(self) -> Linear:
        """The plan's linear problem at the nominal machine."""
        return Linear.of(self, self.problem)

    @cached_property
    def check(self) -> tuple[Array, Array]:
        """Joints (C, n_q) and nominal poses (C, 12) at which the machine is judged; the plan's, without a workspace."""
        problem = self.problem
        if self.robot.workspace is None:
            return problem.body.q, problem.poses(problem.reference)
        q, x, *_ = check_joints(problem.robot, problem.body.tool[0])
        return q, x

    @cached_property
    def home(self) -> Array:
        """Poses (N, 12) of the nominal machine at the plan's joints."""
        return self.problem.poses(self.problem.reference)

    @cached_property
    def over_workspace(self) -> Array:
        """Derivatives (3 C, n_p) of the judged positions by all source errors, a rigid motion of the map taken off."""
        q, x = self.check
        mechanism = self.problem.mechanism
        S = mechanism.sensitivity(x, q, self.problem.body.tool[0], mechanism.rows(self.problem.robot)).parameters
        flat = S[:, :3].reshape(-1, S.shape[2])
        return flat if self.known_frame else without_motion(flat, x[:, :3])

    @cached_property
    def instrument(self) -> Instrument:
        """The instrument as it stands before the first machine is measured."""
        return self.problem.begin(self.problem.reference)

    @property
    def sees_joints(self) -> bool:
        """Whether joints are read, so that no source error is seen and nothing calibrated."""
        return self.problem.readings.kind.sees_joints

    @property
    def known_frame(self) -> bool:
        """Whether the instrument stands in the robot's frame, so that nothing has to be aligned."""
        return self.problem.readings.kind.positions and not self.instrument.free

    def noise(self, columns: int) -> Array:
        """Return the noise (columns,) of a reading: lengths [mm], then rotations [rad]."""
        return np.array([self.sigma] * min(columns, 3) + [self.turn_sigma or self.sigma] * max(columns - 3, 0))

    def fingerprint(self) -> str:
        """Return a hash of all that the study's results depend on."""
        p = self.poses
        arrays = (p.joints, p.targets, p.tool, p.setup, p.pairs, p.pose, *p.channels.values())
        return content_key(
            results.Study.named(),
            robot_to_dict(self.robot),
            p.kind,
            dataclasses.asdict(p.measurement),
            list(p.channels),
            [None if a is None else np.asarray(a).tolist() for a in arrays],
            [self.names, self.errors, self.sigma, self.turn_sigma, self.seed],
            [[kept_term(t).to_dict() for t in terms] for terms in self.suspects],
        )


@dataclass(frozen=True)
class Linear(Factored):
    """Readings by the n free source errors and the m unknowns of the instrument, in units of their noise.

    Attributes
    ----------
    whole : (M, n_p) array
        The same readings by all source errors of the mechanism.
    """

    whole: Array

    @staticmethod
    def of(study: Study, problem: Problem) -> Linear:
        """Return the linear problem of a plan."""
        J, whole = rows_of(study, problem)
        prior = np.concatenate([1 / problem.scale**2, np.zeros(J.shape[1] - len(problem.names))])
        return Linear(J, prior, whole)

    def and_more(self, J: Array, whole: Array) -> Linear:
        """Return the linear problem with further readings."""
        return Linear(np.vstack([self.J, J]), self.prior, np.vstack([self.whole, whole]))

    def times(self, factor: float) -> Linear:
        """Return the linear problem of so many times the readings."""
        return Linear(math.sqrt(factor) * self.J, self.prior, math.sqrt(factor) * self.whole)

    def of_estimate(self, spread: Array, columns: Sequence[int]) -> Array:
        """Return the second moments (n_p, n_p) of estimate minus truth, machines drawn with `spread` (n_p,)."""
        gain = np.zeros((self.whole.shape[1], len(self.J)))
        gain[columns] = self.gain[: len(columns)]
        drawn = (gain @ self.whole - np.eye(len(spread))) * spread
        moments: Array = gain @ gain.T + drawn @ drawn.T
        return moments


def rows_of(study: Study, problem: Problem) -> tuple[Array, Array]:
    """Return a problem's readings by its unknowns (M, n + m) and by all source errors (M, n_p), in units of noise."""
    everything = problem.with_names([p.name for p in problem.mechanism.parameters])
    instrument = problem.begin(problem.reference)
    state = everything.linearise(problem.reference, instrument)
    both = np.concatenate([state.J_p, state.J_m], axis=2) / study.noise(state.J_p.shape[1])[:, None]
    both[np.isnan(instrument.residual(problem.readings, problem.poses(problem.reference)))] = 0.0  # not read
    flat, n_p = np.nan_to_num(both).reshape(-1, both.shape[2]), len(problem.mechanism.parameters)
    return np.hstack([flat[:, problem.columns], flat[:, n_p:]]), flat[:, :n_p]


class Machines(Value):
    """Machines that were simulated and calibrated.

    `sum` and `squares` are of estimate minus truth by parameter [mm, rad]; `before` and `after` hold the root mean
    square and the largest position error over the workspace of each machine [mm]; `lost` could not be simulated or did
    not converge.
    """

    count: int
    lost: int
    sum: list[float]
    squares: list[float]
    before: list[list[float]]
    after: list[list[float]]


class Trial(Value):
    """What the diagnosis said of a recording in which something was concealed."""

    right: bool
    among: bool
    named: list[tuple[str, list[int]]]
    verdict: str
    before_mm: float | None
    after_mm: float | None
    next: list[str]


def machines(study: Study, index: int, count: int) -> Machines:
    """Simulate and calibrate machines; the random numbers belong to the chunk's index."""
    rng = np.random.default_rng([study.seed, 0, index])
    truth = rng.standard_normal((count, len(study.spread))) * study.spread
    x = _stand(study, truth, None)
    estimate, settled = _calibrate(study, _read(study, truth, x, rng), x)
    off = (estimate - truth)[:, study.problem.columns]
    actual = _map(study, truth)
    before = _apart(study.check[1][None, :, :3], actual, study.known_frame)
    after = _apart(_map(study, estimate), actual, study.known_frame)
    ok = settled & np.isfinite(x).all(axis=(1, 2)) & np.isfinite(after).all(axis=1)
    return Machines(
        count=int(ok.sum()),
        lost=int(count - ok.sum()),
        sum=off[ok].sum(axis=0).tolist(),
        squares=(off[ok] ** 2).sum(axis=0).tolist(),
        before=_figures(before[ok]),
        after=_figures(after[ok]),
    )


def _figures(error: Array) -> list[list[float]]:
    return np.column_stack([np.sqrt((error**2).mean(axis=1)), error.max(axis=1, initial=0.0)]).tolist()


def _stand(study: Study, errors: Array, near: Array | None) -> Array:
    """Return the poses (T, N, 12) of machines with source errors (T, n_p) at the plan's joints."""
    problem, body, count = study.problem, study.problem.body, len(errors)
    rows = problem.mechanism.rows(problem.robot, errors)
    close = None if near is None else near.reshape(-1, near.shape[2])
    x, _ = problem.mechanism.forward(np.tile(body.q, (count, 1)), np.tile(body.tool, (count, 1)), rows, close)
    return x.reshape(count, len(body.q), -1)


def _map(study: Study, errors: Array) -> Array:
    """Return the positions (T, C, 3) at which machines are judged."""
    problem, (q, _) = study.problem, study.check
    rows = problem.mechanism.rows(problem.robot, errors)
    x = problem.mechanism.positions(np.tile(q, (len(errors), 1)), problem.body.tool[0], rows)
    return x.reshape(len(errors), len(q), 3)


def _stacked(study: Study, count: int) -> Readings:
    """Return the plan's readings of machines one after another, each with set-ups of its own."""
    found, each = study.problem.readings, np.repeat(np.arange(count), len(study.problem.readings))
    return dataclasses.replace(
        found,
        rows=np.tile(found.rows, (count, 1)) + len(study.problem.body.q) * each[:, None],
        values=np.tile(found.values, (count, 1)),
        rotations=None if found.rotations is None else np.tile(found.rotations, (count, 1, 1)),
        setup=np.tile(found.setup, count) + (int(found.setup.max()) + 1) * each,
        group=np.tile(found.group, count),
        line=np.tile(found.line, count),
        known=None if found.known is None else np.tile(found.known, (count, 1)),
    )


def _read(study: Study, truth: Array, x: Array, rng: np.random.Generator) -> Readings:
    """Return what is read of machines with source errors (T, n_p) at their poses (T, N, 12)."""
    stacked = _stacked(study, len(truth))
    instrument = _mounted(study, _several(study, len(truth)), truth)
    values, rotations = instrument.predict(stacked, x.reshape(-1, x.shape[2]))
    values = values + study.sigma / instrument.at_platform[: values.shape[1]] * rng.standard_normal(values.shape)
    values[np.isnan(stacked.values)] = np.nan
    if rotations is not None and stacked.rotations is not None:
        rotations = from_vector(study.turn_sigma * rng.standard_normal((len(values), 3))) @ rotations
    return dataclasses.replace(stacked, values=values, rotations=rotations)


def _several(study: Study, count: int) -> Instrument:
    """Return the plan's instrument once for each machine."""
    return dataclasses.replace(study.instrument, state=np.tile(study.instrument.state, (count, 1)))


def _mounted(study: Study, instrument: Instrument, errors: Array) -> Instrument:
    """Return the instruments of machines where the machines' own errors (T, n_p) put them."""
    each = len(instrument.state) // len(errors)
    return instrument.mounted(study.problem.mechanism, np.repeat(errors, each, axis=0))


def _calibrate(study: Study, found: Readings, near: Array) -> tuple[Array, np.ndarray]:
    """Return the estimated source errors (T, n_p) of machines that stand at (T, N, 12), and which have settled."""
    problem, linear = study.problem, study.linear
    columns, n, count = problem.columns, len(problem.names), len(near)
    deviation = np.sqrt(np.diag(linear.covariance)[:n])
    u = np.zeros((count, len(linear.covariance)))
    errors = np.zeros((count, len(study.spread)))
    instrument = _several(study, count)
    left = np.arange(count)  # machines that have not settled
    x = np.broadcast_to(study.home, near.shape)
    for number in range(STEPS):
        if number:
            x = _stand(study, errors[left], near[left] if number == 1 else x)
        r = _mounted(study, instrument, errors[left]).residual(found, np.nan_to_num(x).reshape(-1, x.shape[2]))
        r = np.nan_to_num(r / study.noise(r.shape[1])).reshape(len(left), -1)
        step = linear.step(r, u[left])
        u[left] += step
        errors[left[:, None], columns] = u[left, :n]
        instrument = instrument.stepped(step[:, n:])
        closed = np.isfinite(x).all(axis=(1, 2))
        on = ~(closed & np.all(np.abs(step[:, :n]) < DONE * deviation, axis=1))
        left, x = left[on], x[on]
        if not len(left):
            break
        if not on.all():
            again = np.repeat(on, len(problem.readings))
            turned = None if found.rotations is None else found.rotations[again]
            found = dataclasses.replace(_stacked(study, len(left)), values=found.values[again], rotations=turned)
            state = instrument.state[np.repeat(on, len(instrument.state) // len(on))]
            instrument = dataclasses.replace(instrument, state=state)
    return errors, ~np.isin(np.arange(count), left)


def _apart(wanted: Array, actual: Array, known_frame: bool) -> Array:
    """Return distances (T, C) between two maps (T, C, 3) [mm], the first turned and shifted onto the second.

    Those of a map with a point that could not be reached are NaN.
    """
    if not known_frame:
        centre = np.full(actual.shape[1], 1 / actual.shape[1])
        wanted, actual = wanted - (centre @ wanted)[:, None], actual - (centre @ actual)[:, None]
        product = np.swapaxes(actual, 1, 2) @ wanted
        product[~np.isfinite(product.sum(axis=(1, 2)))] = 0.0  # NaN stays in the maps
        U, _, Vt = np.linalg.svd(product)
        U[:, :, 2] *= np.sign(np.linalg.det(U @ Vt))[:, None]
        wanted = wanted @ np.swapaxes(U @ Vt, 1, 2)
    gap = actual - wanted
    return np.asarray(np.sqrt(np.einsum("tcj,tcj->tc", gap, gap)))


def concealed(study: Study, suspect: int, trial: int) -> Trial:
    """Conceal a suspect in a recording of the plan and diagnose it; suspect -1 conceals nothing."""
    from deltacal_gen.diagnosis.diagnosis import diagnose  # as long to load as a hundred machines to calibrate

    rng = np.random.default_rng([study.seed, 1 + suspect + 1, trial])
    terms = () if suspect < 0 else study.suspects[suspect]
    drawn = rng.standard_normal(len(study.spread)) * study.spread
    names = [p.name for p in study.problem.mechanism.parameters]
    errors = {n: float(v) for n, v in zip(names, drawn, strict=True) if v}
    recording = simulate(
        study.robot, study.poses, errors, noise_mm=study.sigma, noise_rad=study.turn_sigma, rng=rng, terms=terms
    )
    found = diagnose(study.robot, dataclasses.replace(recording, channels=recording.told)).answer()
    named = [(e.name, e.limbs) for e in found.findings]
    wanted = [(t.effect, t.limbs) for t in terms]
    alike = {name for e in found.effects for name in e.indistinguishable_from}
    return Trial(
        right=sorted(named) == sorted(wanted),
        among=bool(wanted) and {n for n, _ in wanted} <= {n for n, _ in named} | alike,
        named=[(name, list(limbs)) for name, limbs in named],
        verdict=found.verdict,
        before_mm=found.baseline.heldout_rms_mm,
        after_mm=found.final.heldout_rms_mm,
        next=[n.text for n in found.next_measurements],
    )


def rms_of(study: Study, linear: Linear) -> float:
    """Return the position error over the workspace [mm] that a calibration leaves, machines drawn as the study does."""
    moments = linear.of_estimate(study.spread, study.problem.columns)
    W = study.over_workspace
    return float(np.sqrt(np.einsum("ij,ij->", W @ moments, W) / (len(W) / 3)))
