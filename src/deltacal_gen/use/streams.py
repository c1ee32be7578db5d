"""Recordings of any length, some rows at a time: simulated, identified, predicted and validated in a fixed memory.

Readings of one set-up, on machines without effects: what a row reads then depends on that row alone. The
identification is the fit of ``identify`` without its search for gross errors: in every pass over the file the rows
are reduced, block by block, to the triangle of their QR decomposition, which holds all that the fit asks of them.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from numbers import Integral
from pathlib import Path

import numpy as np

from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.files.recording import read_blocks
from deltacal_gen.files.robot import kept_robot
from deltacal_gen.files.writing import write_blocks
from deltacal_gen.identification import identifiability
from deltacal_gen.identification.answer import open_combinations, parameter_table
from deltacal_gen.instrument.kind import Instrument, Readings
from deltacal_gen.instrument.kinds import POINTS, kind_of, readings
from deltacal_gen.instrument.kinds.position import drawn_frames
from deltacal_gen.machine.backend import working
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Recording, Robot
from deltacal_gen.physics import simulation
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.parts import Source
from deltacal_gen.results.result import Read, Regularisation, Result, Status
from deltacal_gen.results.validation import Validation
from deltacal_gen.use import prediction, validation

ROWS = 10_000  # of a block: the derivatives of its poses take some 25 MB
PASSES = 8  # over the file, at most
DONE = 0.01  # standard deviations: by which the last pass may still change a parameter


@dataclass(frozen=True)
class Streamed:
    """A machine fitted to a recording that was read in blocks.

    Attributes
    ----------
    errors : (n_p,) array
        All source errors of the mechanism [mm, rad].
    covariance : (n + n_m, n + n_m) array
        Of the free parameters and the instrument's unknowns [mm, rad].
    sigma : float
        Noise per coordinate, from the residuals [mm].
    before, after : float
        RMS of the residuals of the robot file's machine, and of the one found [mm].
    matrix : (n, n) array
        The identification matrix as a triangle, in ordinary errors, the instrument projected out.
    rows : int
        Rows that hold a reading.
    passes : int
        Over the file.
    """

    robot: Robot
    model: str
    names: tuple[str, ...]
    errors: Array
    instrument: Instrument
    setups: tuple[str, ...]
    covariance: Array
    sigma: float
    before: float
    after: float
    matrix: Array
    scalars: int
    rows: int
    passes: int

    @property
    def parameters(self) -> dict[str, float]:
        """The free source errors by name [mm, rad]."""
        index = mechanism_of(self.robot).index
        return {name: float(self.errors[index[name]]) for name in self.names}

    def answer(self) -> Result:
        """Return what `identification.identify` answers, but for what it asks of single readings."""
        mechanism, n = mechanism_of(self.robot), len(self.names)
        named = {p.name: float(v) for p, v in zip(mechanism.parameters, self.errors, strict=True) if v}
        columns = [mechanism.index[name] for name in self.names]
        typical, units = mechanism.typical[columns], [mechanism.parameters[j].unit for j in columns]
        unseen = identifiability.unseen(self.matrix / typical, self.names, units, typical)
        seen = identifiability.observability(self.matrix, self.rows)
        open_ = {name for c in unseen for name in c.terms}
        deviation = np.sqrt(np.maximum(np.diag(self.covariance)[:n], 0.0))
        status = {name: Status.NOT_PINNED if name in open_ else Status.IDENTIFIED for name in self.names}
        change = self.errors - mechanism.vector(self.robot.errors)
        return Result(
            model=self.model,
            parameters=parameter_table(mechanism, change, status, deviation),
            rank=seen.rank,
            rank_tolerance=identifiability.RANK_TOLERANCE,
            singular_values=seen.singular_values,
            condition=seen.condition if np.isfinite(seen.condition) else None,
            scaling="columns in ordinary errors, rows in mm, the instrument projected out, at the machine found",
            unidentifiable=open_combinations(unseen, mechanism, "not at all"),
            next_measurements=(),
            regularisation=Regularisation(rule=f"least squares, {self.passes} passes over the file"),
            readings=Read(kind=POINTS, scalars=self.scalars, poses=self.rows),
            before_rms_mm=self.before,
            train_rms_mm=self.after,
            heldout_rms_mm=None,
            sigma_mm=self.sigma,
            sigma_source=Source.RESIDUAL,
            chi2_per_dof=1.0 if self.sigma > 0 else None,  # by definition
            gross_errors=None,  # not searched for
            accuracy=None,
            workspace=None,
            instrument=self.instrument.kept(self.setups, "absolute"),
            robot=kept_robot(dataclasses.replace(self.robot, errors=named)),
        )


def simulate(
    robot: Robot,
    poses: str | Path,
    output: str | Path,
    errors: Mapping[str, float] | None = None,
    *,
    noise: float = 0.0,
    rng: np.random.Generator | None = None,
    frame: tuple[Array, Array] | None = None,
    rows: int = ROWS,
) -> int:
    """Simulate a recording file to another, `rows` at a time; return the number of rows. See `simulation.simulate`.

    An unknown frame of the instrument that is not given is drawn first, as for a recording that is read whole.

    Raises
    ------
    InputError, NoSolutionError
        As `recording.read_blocks` and `simulation.simulate`.
    """
    mechanism, true = mechanism_of(robot), None if errors is None else dict(errors)

    def parts() -> Iterator[Recording]:
        seen = frame
        for part in blocks:
            if not Path(poses).with_suffix(".toml").exists():  # as `commands.simulate` has it
                part = dataclasses.replace(part, measurement=dataclasses.replace(part.measurement, frame="robot"))
            if (
                seen is None
                and kind_of(part.kind).positions
                and part.measurement.frame == "unknown"
                and rng is not None
            ):
                turn, origin = drawn_frames(part, 1, rng)
                seen = turn[0], origin[0]
            yield simulation.simulate(robot, part, true, noise=noise, rng=rng, frame=seen)

    size, blocks = _begun(read_blocks(poses, mechanism, rows, need_measured=False, allow_targets=True))
    with working("blocks", size):
        return write_blocks(parts(), output)


def _check_kind(part: Recording, file: str | Path) -> None:
    """Raise an InputError for readings that cannot be identified block by block."""
    if not kind_of(part.kind).in_blocks:
        raise InputError(
            f"only positions are identified in blocks, these readings are of the kind {part.kind}.",
            "Identify them as a whole.",
            file=file,
        )


def identify(robot: Robot, recording: str | Path, model: str, *, rows: int = ROWS, passes: int = PASSES) -> Streamed:
    """Identify a machine by least squares from a recording file, `rows` at a time.

    Parameters
    ----------
    model : str
        ``delta/32`` or ``32``.
    passes : int
        Steps of Gauss-Newton, each over the file, at most; one is the linear identification.

    Raises
    ------
    UsageError
        Less than one row or one pass.
    InputError
        As `recording.read_blocks`, or a kind other than position.
    NoSolutionError
        Several passes were allowed and did not settle.
    """
    if not isinstance(passes, Integral) or passes < 1:
        raise UsageError(f"passes = {passes}: a whole number of passes over the file was expected, at least 1.")
    mechanism = mechanism_of(robot)
    names, errors = mechanism.model(model), mechanism.vector(robot.errors)
    instrument: Instrument | None = None
    number, settled, before = 0, False, 0.0
    while not settled and number < passes:
        number += 1
        triangle: Array | None = None
        count = scalars = 0
        size, blocks = _begun(read_blocks(recording, mechanism, rows))
        for part in blocks:
            _check_kind(part, recording)
            with working("blocks", size):
                problem = pose_problem(robot, part, names)
                instrument = problem.begin(errors) if instrument is None else instrument
                triangle = _reduced(problem, errors, instrument, triangle)
            count, setups = count + len(problem.readings), part.setup_names
            scalars += problem.readings.n_scalars
        assert triangle is not None
        assert instrument is not None
        n = len(names)
        scale = np.concatenate([problem.scale, np.ones(triangle.shape[1] - 1 - n)])
        solution = LeastSquares().solve(triangle[:, :-1], triangle[:, -1])
        left = float(triangle[:, -1] @ triangle[:, -1] - solution.c @ solution.c)
        noise = float(np.sqrt(max(left, 0.0) / max(scalars - solution.degrees, 1.0)))
        before = float(np.linalg.norm(triangle[:, -1]) / np.sqrt(scalars)) if number == 1 else before
        step = solution.u * scale
        errors[problem.columns] += step[:n]
        instrument = instrument.stepped(step[n:])
        deviation = noise * np.sqrt(np.diag(solution.covariance))
        settled = bool((np.abs(solution.u) <= DONE * deviation).all())
    if not settled and passes > 1:
        raise NoSolutionError(f"the fit did not settle in {passes} passes over {recording}. Use a smaller model.")
    assert instrument is not None
    assert triangle is not None
    covariance = noise**2 * solution.covariance * np.outer(scale, scale)
    after_instrument = np.roll(triangle[:, :-1], -n, axis=1)  # its columns first: what is left below is projected
    matrix = np.asarray(np.linalg.qr(after_instrument, mode="r"))[triangle.shape[1] - 1 - n :, -n:]
    return Streamed(
        robot,
        mechanism.full_name(model),
        names,
        errors,
        instrument,
        setups,
        covariance,
        noise,
        before,
        float(np.sqrt(max(left, 0.0) / scalars)),
        matrix,
        scalars,
        count,
        number,
    )


def predict(result: Result | Diagnosis, recording: str | Path, output: str | Path, *, rows: int = ROWS) -> int:
    """Predict the readings of a recording file into another, `rows` at a time; see `prediction.predict`.

    Raises
    ------
    InputError
        As `recording.read_blocks` and `prediction.predict`.
    """
    robot = prediction.calibrated_robot(result)
    size, blocks = _begun(read_blocks(recording, mechanism_of(robot), rows, need_measured=False))
    with working("blocks", size):
        return write_blocks((prediction.predict(result, part) for part in blocks), output)


def validate(result: Result | Diagnosis, recording: str | Path, *, rows: int = ROWS) -> Validation:
    """Return the error of a result on a recording file, `rows` at a time; see `validation.validate`.

    Repeats of a pose may lie anywhere in the file: figures of ISO 9283 are not given.

    Raises
    ------
    InputError
        As `recording.read_blocks` and `validation.validate`; or contacts: where the points are, all their touches say
        together.
    """

    def parts() -> Iterator[tuple[Readings, Array]]:
        for part in blocks:
            if kind_of(part.kind).anew:
                raise InputError(
                    "contacts are not validated in blocks: where a point is, all its touches say together.",
                    "Validate them as a whole.",
                    file=recording,
                )
            found = readings(part)
            yield found, prediction.residual(result, part, found)

    size, blocks = _begun(read_blocks(recording, mechanism_of(prediction.calibrated_robot(result)), rows))
    with working("blocks", size):
        return validation.figures(result.sigma_mm, parts())


def _begun(blocks: Iterator[Recording]) -> tuple[int, Iterator[Recording]]:
    """Return the rows of the first block, which are as many as the work has or as a block holds, and all blocks."""
    first = next(blocks)
    return len(first.joints), itertools.chain([first], blocks)


def _reduced(problem: Problem, errors: Array, instrument: Instrument, triangle: Array | None) -> Array:
    """Return the triangle (n + 1, n + 1) of all rows so far: columns in ordinary sizes, then the residual."""
    state = problem.linearise(errors, instrument)
    read = np.isfinite(state.residual)
    block = np.column_stack([state.J_p[read] * problem.scale, state.J_m[read], state.residual[read]])
    return np.asarray(np.linalg.qr(block if triangle is None else np.vstack([triangle, block]), mode="r"))
