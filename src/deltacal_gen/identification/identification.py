"""Identification: a robot and a recording in, a calibrated robot and what the data pin of it out.

Two stages (Bai 2015, section 4.2): the encoder offsets first, iterated, since they are the largest by far; then all
parameters of the model. Both are exact: the stages differ in what is free, not in the machine.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.estimation.estimation import (
    SPARE_READINGS,
    Fit,
    Problem,
    Repeats,
    fit,
    held_out,
    lengths,
    pose_problem,
    rms,
    rough,
)
from deltacal_gen.estimation.solvers import TSVD, LeastSquares, Prior, Ridge, Solver
from deltacal_gen.files.recording import Recording, check_units
from deltacal_gen.files.robot import Robot, for_model, kept_robot, robot_size
from deltacal_gen.identification import identifiability
from deltacal_gen.identification.accuracy import check_joints, distance_error, largest, volumetric_error, without_motion
from deltacal_gen.identification.identifiability import Combination
from deltacal_gen.instrument.kinds import kind_of, mounts
from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.backend import by_recording
from deltacal_gen.machine.differences import between
from deltacal_gen.machine.registry import SOLVED, Array, Machine, mechanism_of
from deltacal_gen.physics.physics import Body, Term, kept_term, of_reading
from deltacal_gen.results.parts import Missing, Source
from deltacal_gen.results.result import (
    Accuracy,
    BaseFrame,
    BaseParameter,
    Largest,
    MapPoint,
    OpenCombination,
    Parameter,
    Read,
    Regularisation,
    Remedy,
    Result,
    Stage,
    Status,
    UncertaintyMap,
)
from deltacal_gen.units import DEG, file_unit, to_internal

FOLDS = 5
SEED = 20150415  # of the folds: results do not change from run to run
BROAD = 10.0  # standard deviation of a parameter of which nothing is known, in ordinary errors
SPARE = 1.15  # scalar readings per unknown below which a model is not chosen unasked: firmware fits 6 to 7 heights
NOTHING_LEFT = 1e-12  # of a prior's variance: then the data know everything
SPARE_HEIGHTS = 1  # of probed heights and printed distances, whose noise is roughly known
PROVEN = 4.0  # standard deviations by which one noise must exceed another to be called larger
LEAST_EXCESS = 1.15  # of chi2 per degree of freedom: a sidecar's sigma has a digit or two
IMPLAUSIBLE = 0.005  # of the machine's size: more is no error of parts but of the recording
RESOLVED = 0.5  # of a parameter's variance that comes from directions the data know better than the prior
Progress = Callable[[str], None]


@dataclass(frozen=True)
class Identification:
    """What a recording says of a robot.

    Attributes
    ----------
    model : str
    fit : Fit
        Of all readings.
    rough : Fit or None
        Of the encoder offsets alone.
    before_rms : float
        RMS of the residuals of the robot file's machine, the instrument fitted [mm].
    heldout_rms : float
        RMS of readings in folds that took no part in the fit [mm].
    observability : Observability
        Of the identification matrix at the robot file's machine, columns in ordinary errors.
    unseen, weak : list of Combination
        What no reading sees, and what the readings see less well than a broad prior.
    base : list of BaseParameter
        What the readings determine, parameter by parameter with those that act through it.
    remedies : tuple of Remedy
        Extra measurements and how many of the free directions each pins.
    noise : Noise
        Of the readings, and where it is known from.
    prior_given : tuple of bool
        Of each parameter: whether the robot file's ``[tolerance]`` names it.
    robot : Robot
        The calibrated machine.
    in_file : (n_p,) array
        Source errors of the robot file, from which those found count.
    not_held : tuple of Missing
        Effects that belong to the session they were found in, and what this one lacks for them.
    map : UncertaintyMap or None
        Over the workspace, where the robot has one.
    """

    model: str
    fit: Fit
    rough: Fit | None
    before_rms: float
    heldout_rms: float
    observability: identifiability.Observability
    unseen: list[Combination]
    weak: list[Combination]
    base: list[identifiability.BaseParameter]
    remedies: tuple[Remedy, ...]
    noise: Noise
    prior_given: tuple[bool, ...]
    robot: Robot
    in_file: Array
    not_held: tuple[Missing, ...]
    map: UncertaintyMap | None

    def answer(self) -> Result:
        """Return the same as users read it: RESULT.json."""
        return _result(self)


@by_recording("identify")
def identify(
    robot: Robot,
    recording: Recording,
    model: str | None = None,
    *,
    as_distance: bool = False,
    solver: str = "prior",
    truncation: int | str = "gcv",
    robust: bool = True,
    held: Sequence[Term] = (),
    machine: Robot | None = None,
    progress: Progress = lambda text: None,
) -> Identification:
    """Identify a robot's source errors from a recording.

    Parameters
    ----------
    model : str, optional
        ``delta/32`` or ``32``; default the largest that the number of readings allows.
    as_distance : bool
        Use the distances of all pairs of measured positions instead of the positions.
    solver : {"prior", "least-squares", "tsvd", "ridge"}
        Rule for directions that the data hardly see. ``prior`` uses the robot file's ``[tolerance]``, and ten times
        an ordinary manufacturing error for what it does not name.
    truncation : int or {"gcv", "discrepancy"}
        For ``tsvd``.
    robust : bool
        Let a few per cent of gross errors not move the result.
    held : sequence of Term
        Effects that stay as a diagnosis found them, while geometry and frame are refitted.
    machine : Robot, optional
        The machine as it was calibrated in another session: source errors that the model leaves out stay as they are
        there.
    progress : callable
        Told in words what is being done.

    Raises
    ------
    InputError
        Too few readings for the model; joints at which the machine cannot stand; units that cannot be.
    NoSolutionError
        No convergence.
    UsageError
        An unknown model or solver.
    """
    if model is not None:
        robot = for_model(robot, model)
    check_units(recording, robot)
    mechanism = mechanism_of(robot)
    everything = pose_problem(robot, recording, (), as_distance=as_distance)
    held, not_held = _carried(everything, held)
    everything = dataclasses.replace(everything, held=held)
    chosen = chosen_model(mechanism, everything, recording, model)
    names, in_file = mechanism.model(chosen), mechanism.vector(robot.errors)
    if machine is not None and len(names) < len(mechanism.parameters):
        robot = dataclasses.replace(robot, errors=_left_out(mechanism, robot, machine, names))
        everything = pose_problem(robot, recording, (), as_distance=as_distance, held=held)
    problem, given = _with_prior(everything.with_names(names), robot)
    rule = _solver(solver, truncation, recording.measurement.sigma_mm)
    if solver != "prior":
        problem = everything.with_names(names)

    progress("rough stage: encoder offsets")
    before = _residual_of(problem, problem.reference)
    distinct(everything, recording)
    first = rough(everything, robust)
    plausible(first)
    check_rows(first, recording)
    progress(f"fine stage: {len(names)} parameters of {chosen}")
    final = fit(problem, rule, errors=first.errors, machine=first.machine, instrument=first.instrument, robust=robust)
    progress(f"held-out error: {FOLDS} folds")
    heldout = held_out(final, rule, folds(problem.readings, recording))
    progress("identifiability")
    matrix = identifiability.identification_matrix(everything.with_names(names), "typical")
    observed = identifiability.observability(matrix.H, len(np.unique(final.problem.readings.group)))
    units = [mechanism.parameters[mechanism.index[n]].unit for n in names]
    typical = mechanism.typical[[mechanism.index[n] for n in names]]
    per_unit = matrix.H / typical
    unseen = identifiability.unseen(per_unit, names, units, typical)
    weak = _weak(final, len(unseen), units)
    calibrated = dataclasses.replace(
        robot,
        errors={
            p.name: float(v) for p, v in zip(mechanism.parameters, final.errors, strict=True) if v or p.name in names
        },
    )
    progress("uncertainty over the workspace")
    return Identification(
        model=chosen,
        fit=final,
        rough=first,
        before_rms=rms(lengths(before, problem.readings.kind)),
        heldout_rms=heldout,
        observability=observed,
        unseen=unseen,
        weak=weak,
        base=identifiability.base(per_unit, names, units, typical) if unseen else [],
        remedies=printed(final)
        if problem.readings.kind.distances_beside
        else _remedies(final)
        if unseen or weak
        else (),
        noise=noise(final, recording),
        prior_given=given,
        robot=calibrated,
        in_file=in_file,
        not_held=not_held,
        map=uncertainty_map(final, calibrated),
    )


def _carried(problem: Problem, held: Sequence[Term]) -> tuple[tuple[Term, ...], tuple[Missing, ...]]:
    """Return the effects that a recording can hold, and those of another session that it cannot, with what is missing.

    What the instrument did, or what went with the time of a session, is not the machine's.

    Raises
    ------
    InputError
        An effect of the machine needs a channel that is not there.
    """
    can, cannot = [], []
    for term in held:
        why = problem.body.missing(term.effect)
        if why is None:
            can.append(term)
        elif of_reading([term]) or any(s.column == "time_s" for s in term.states):
            cannot.append(Missing(name=term.effect, missing=why))
        else:
            raise InputError(f"the effect '{term.effect}' needs {why}.", "Add it.", file=problem.recording.path)
    return tuple(can), tuple(cannot)


def _left_out(mechanism: Machine, robot: Robot, machine: Robot, names: Sequence[str]) -> dict[str, float]:
    """Return a robot's source errors with those that a model leaves out as another session of the machine has them."""
    if machine.mechanism != robot.mechanism:
        raise InputError(
            f"the diagnosis is of another machine: {machine.mechanism}, where the robot file says {robot.mechanism}.",
            "Give the diagnosis of an earlier session of this machine.",
        )
    known, _ = between(mechanism, robot, machine)
    for name, value in machine.errors.items():
        known[name] = known.get(name, 0.0) + value
    return {n: v for n, v in known.items() if n not in names} | {n: v for n, v in robot.errors.items() if n in names}


def _solver(name: str, truncation: int | str, sigma: float | None) -> Solver:
    solvers: dict[str, Callable[[], Solver]] = {
        "prior": Prior,
        "least-squares": LeastSquares,
        "tsvd": lambda: TSVD(truncation, sigma),
        "ridge": Ridge,
    }
    if name not in solvers:
        raise UsageError(f"there is no solver '{name}'; known: {', '.join(solvers)}.")
    return solvers[name]()


def _with_prior(problem: Problem, robot: Robot) -> tuple[Problem, tuple[bool, ...]]:
    given = tuple(n in robot.tolerance for n in problem.names)
    sd = np.array([robot.tolerance.get(n, BROAD * s) for n, s in zip(problem.names, problem.scale, strict=True)])
    return dataclasses.replace(problem, scale=sd), given


def chosen_model(mechanism: Machine, problem: Problem, recording: Recording, asked: str | None) -> str:
    """Return the model asked for, or the largest that the readings allow.

    Raises
    ------
    InputError
        The readings are fewer than the unknowns of the model (of the smallest model, when none was asked for).
    """
    scalars = problem.readings.n_scalars
    extra = problem.begin(problem.reference).n_unknown
    shown = {mechanism.parameters[p].name for p in problem.readings.kind.carried(mechanism).values()}
    fitting = [m for m in mechanism.models if shown.issuperset(mounts() & set(mechanism.models[m]))]
    whole = len(mechanism.model(mechanism.full_model))
    by_size = sorted((m for m in fitting if len(mechanism.models[m]) <= whole), key=lambda m: -len(mechanism.models[m]))
    if asked is not None:
        mechanism.model(asked)
        name = mechanism.full_name(asked)
        _check_count(recording, scalars, len(mechanism.models[name]), extra, name, _spare(recording))
        return name
    for name in by_size:
        if scalars >= SPARE * (len(mechanism.models[name]) + extra):
            return name
    smallest = by_size[-1]
    _check_count(recording, scalars, len(mechanism.models[smallest]), extra, smallest, _spare(recording))
    return smallest


def enough(mechanism: Machine, problem: Problem, recording: Recording) -> None:
    """Raise an InputError where the readings cannot carry the problem's own parameters and the instrument's."""
    extra = problem.begin(problem.reference).n_unknown
    scalars = problem.readings.n_scalars
    _check_count(recording, scalars, len(problem.names), extra, mechanism.full_model, SPARE_READINGS)


def _spare(recording: Recording) -> int:
    """Return how many readings beyond the unknowns a fit needs: none where the noise is known beforehand."""
    kind = kind_of(recording.kind)
    if kind.probed:
        return SPARE_HEIGHTS
    return 0 if recording.measurement.sigma_mm is not None and not kind.rotations else SPARE_READINGS


def _check_count(recording: Recording, scalars: int, parameters: int, extra: int, model: str, spare: int) -> None:
    """Raise an InputError where readings are fewer than the unknowns and the `spare` ones that noise shows in."""
    needed = parameters + extra + spare
    if scalars >= needed:
        return
    of_instrument = f" and {extra} of the instrument" if extra else ""
    shows = f", and noise shows in no fewer than {spare} more" if spare else ""
    raise InputError(
        f"the recording holds {scalars} independent scalar readings; {model} has {parameters} "
        f"parameters{of_instrument}{shows}: {needed} are needed.",
        "Measure more poses (deltacal plan proposes them) or choose a smaller model with --model.",
        file=recording.path,
    )


def distinct(problem: Problem, recording: Recording) -> None:
    """Raise an InputError where the readings come from fewer than three different poses."""
    used = np.unique(problem.readings.rows)
    if len(np.unique(np.round(problem.body.q[used], 9), axis=0)) < 3:
        raise InputError(
            "the readings come from fewer than three different poses.",
            "Measure poses spread over the workspace: deltacal plan proposes them.",
            file=recording.path,
        )


def enough_poses(problem: Problem, model: str) -> None:
    """Raise an InputError where different poses, each counted once, are fewer than a model's parameters need.

    Repeats of a pose show noise, but nothing of the machine: such a recording cannot be split into a part to fit and a
    part to judge by.
    """
    found = problem.readings
    poses = len(np.unique(np.round(problem.body.q[np.unique(found.rows)], 9), axis=0))
    scalars = found.kind.scalars * len(np.unique(found.group))
    if found.rows.shape[1] == 2:
        scalars = min(scalars, 3 * poses)
    extra = problem.begin(problem.reference).n_unknown
    needed = len(problem.names) + extra + SPARE_READINGS
    if scalars < needed:
        of_instrument = f" and {extra} of the instrument" if extra else ""
        raise InputError(
            f"the readings come from {poses} different poses: {scalars} scalars, each counted once, where {model} has "
            f"{len(problem.names)} parameters{of_instrument}. The recording is too short to split: repeats show noise, "
            "not what is missing.",
            f"Measure enough different poses for {needed} scalars (deltacal plan proposes them), or choose a smaller "
            "model with --model.",
            file=problem.recording.path,
        )


def plausible(first: Fit) -> None:
    """Raise an InputError where the readings cannot be of this machine, and name the mistake that would explain them.

    After the encoder offsets no machine is off by half a per cent of its size. The mistakes that people make are tried
    one by one: joints counted the other way or exchanged, axes exchanged or mirrored, a column in metres, readings
    shifted by a row, a frame that is not the robot's.
    """
    problem, found = first.problem, first.problem.readings
    size = robot_size(problem.robot)
    off = float(np.median(np.linalg.norm(np.nan_to_num(lengths(first.residual, found.kind)), axis=1)))
    if off < IMPLAUSIBLE * size:
        return
    for words, changed in _mistakes(problem) if found.kind.positions else ():
        try:
            again = rough(changed)
        except (InputError, NoSolutionError):
            continue
        if float(np.median(np.linalg.norm(np.nan_to_num(lengths(again.residual, found.kind)), axis=1))) < 0.1 * off:
            raise InputError(
                f"the readings are {off:.3g} mm off this machine, but agree with it if {words}.",
                "Correct the recording, its sidecar or the robot file.",
                file=problem.recording.path,
            )
    raise InputError(
        f"the readings are {off:.3g} mm off this machine, more than any error of its parts.",
        "Compare the robot file with the machine, and the columns of the recording with what was measured.",
        file=problem.recording.path,
    )


def _mistakes(problem: Problem) -> Iterator[tuple[str, Problem]]:
    found, body = problem.readings, problem.body

    def with_values(values: Array) -> Problem:
        return dataclasses.replace(problem, readings=dataclasses.replace(found, values=values))

    def with_joints(q: Array) -> Problem:
        return dataclasses.replace(problem, body=Body(body.robot, body.mechanism, q, body.tool, body.channels))

    if problem.recording.measurement.frame == "robot":
        free = dataclasses.replace(problem.recording.measurement, frame="unknown")
        yield (
            'the instrument has a frame of its own (frame = "unknown" in the sidecar)',
            dataclasses.replace(problem, recording=dataclasses.replace(problem.recording, measurement=free)),
        )
    yield "every joint counts the other way ([joints] sign)", with_joints(-body.q)
    names = [f"q{i + 1}" for i in range(body.q.shape[1])]
    for order in itertools.permutations(range(len(names))):
        if list(order) != sorted(order):
            yield f"the joints stand in the order {', '.join(names[i] for i in order)}", with_joints(body.q[:, order])
    axes = "xyz"
    read = [c for c in found.components if c < 3]
    for i, j in itertools.combinations(read, 2):
        swapped = [j if k == i else i if k == j else k for k in range(3)]
        yield f"{axes[i]}_mm and {axes[j]}_mm are exchanged", with_values(found.values[:, swapped])
    for i in read:
        for factor, unit in ((1000.0, "metres"), (0.001, "micrometres")):
            scale = np.where(np.arange(3) == i, factor, 1.0)
            yield f"{axes[i]}_mm is in {unit}", with_values(found.values * scale)
    for shift in (1, -1):
        yield (
            "the readings are shifted against the joints by one row",
            with_values(np.roll(found.values, shift, axis=0)),
        )


def check_rows(first: Fit, recording: Recording) -> None:
    """Refuse rows whose measured cells stand against the joints of another row.

    Two readings that are gross errors, and each of which fits the pose of the other, were swapped.
    """
    found, suspects = first.problem.readings, first.gross
    if not found.kind.positions or not 2 <= len(suspects) <= max(2, len(found) // 5):
        return
    predicted = found.values - first.residual[:, :3]
    within = 6 * float(np.median(np.linalg.norm(lengths(first.residual, found.kind), axis=1))) + 1e-9
    gap = np.linalg.norm(np.nan_to_num(found.values[suspects][:, None] - predicted[suspects][None]), axis=2)
    for i in range(len(suspects)):
        j = int(np.argmin(gap[i]))
        if i < j and gap[i, j] < within and gap[j, i] < within and min(gap[i, i], gap[j, j]) > 10 * within:
            a, b = sorted(int(found.line[suspects[k]]) for k in (i, j))
            raise InputError(
                f"the readings of lines {a} and {b} are swapped: each fits the joints of the other to "
                f"{max(gap[i, j], gap[j, i]):.3g} mm and its own only to {min(gap[i, i], gap[j, j]):.3g} mm.",
                "Exchange the measured cells of the two lines.",
                file=recording.path,
                line=a,
            )


def _residual_of(problem: Problem, errors: Array) -> Array:
    """Return the residual of a machine with given errors, the instrument alone fitted."""
    free = problem.with_names(())
    return fit(free, LeastSquares(), errors=errors, weigh_repeats=False, must_converge=False).residual


# ------------------------------------------------------------------------------------------------------- held out


def folds(found: Readings, recording: Recording, count: int = FOLDS) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return (train, test) masks of readings; repeats of a pose, or of a pair of poses, stay together.

    Distances made of positions are split by pose: a distance counts where both its poses are in the same part.
    """
    rng = np.random.default_rng(SEED)
    if found.made:
        _, pose = np.unique(recording.pose, return_inverse=True)
        ends = pose[found.rows]
        part = _parts(int(pose.max()) + 1, count, rng)[ends]
        return [((part != k).all(axis=1), (part == k).all(axis=1)) for k in range(count)]
    groups = int(found.group.max()) + 1
    part = _parts(groups, min(count, groups), rng)[found.group]
    return [(part != k, part == k) for k in range(min(count, groups))]


def _parts(n: int, count: int, rng: np.random.Generator) -> np.ndarray:
    return rng.permutation(np.arange(n) % count)


# ----------------------------------------------------------------------------------------------- what is pinned


def coordinate_sigma(found: Fit) -> float:
    """Return the noise that a fit leaves per measured scalar [mm]; a distance made of positions holds that of two."""
    return float(found.sigma[0]) / (np.sqrt(2.0) if found.problem.readings.made else 1.0)


@dataclass(frozen=True)
class Noise:
    """Noise per measured scalar [mm], where it is known from, and the degrees of freedom of that knowledge."""

    sigma: float
    source: Source
    degrees: float


def noise(final: Fit, recording: Recording) -> Noise:
    """Return the noise, from the sidecar, from repeats, or from what the fit leaves.

    Repeats count where every channel but time is the same in both readings. A declared sigma holds unless repeats
    contradict it: clearly smaller ones do; clearly larger ones do unless the closest of them agree with it, since what
    happens between two readings of a pose adds to the spread of some and not of others.
    """
    found, residual = final.problem.readings, coordinate_sigma(final)
    declared = found.kind.sigma(recording.measurement, final.instrument.scale)
    if found.made:
        return (
            Noise(residual, Source.RESIDUAL, np.inf) if declared is None else Noise(declared, Source.DECLARED, np.inf)
        )
    quiet = np.setdiff1d(np.arange(len(found)), final.gross)
    r, group = np.nan_to_num(lengths(final.residual[quiet], found.kind)), _repeats(found, recording)[quiet]
    _, within, degrees = Repeats.ratio_of(r, group)
    repeated = degrees >= 12 and within > 0
    if declared is not None:
        doubt = PROVEN * np.sqrt(_spread(r) / max(degrees, 1))
        gap = np.log(within / declared**2) if repeated else 0.0
        if abs(gap) <= doubt or (gap > 0 and _closest(r, group) < 2 * declared):
            return Noise(declared, Source.DECLARED, np.inf)
    if repeated:
        return Noise(float(np.sqrt(within)), Source.REPEATS, float(degrees))
    return Noise(residual, Source.RESIDUAL, np.inf)


def _repeats(found: Readings, recording: Recording) -> np.ndarray:
    """Return groups (R,) of readings of one pose with every channel but time the same."""
    channels = [
        v for name, v in sorted(recording.channels.items()) if name != "time_s" and not name.startswith("true_")
    ]
    if found.rows.shape[1] != 1 or not channels:
        return found.group
    same = np.column_stack([found.group, np.nan_to_num(np.array(channels).T[found.rows[:, 0]], nan=-1e9)])
    return np.ravel(np.unique(same, axis=0, return_inverse=True)[1])


def _spread(r: Array) -> float:
    """Return the variance of squares in units of the variance's square: 2 where noise is normal, more in its tails."""
    squares = r[np.isfinite(r)] ** 2
    mean = float(np.mean(squares)) + 1e-300
    return max(float(np.mean(squares**2)) / mean**2, 3.0) - 1


def _closest(r: Array, group: np.ndarray) -> float:
    """Return the noise that the closest quarter of repeats speaks for, as if noise were normal [mm]."""
    order = np.argsort(group, kind="stable")
    together = group[order][1:] == group[order][:-1]
    gaps = np.abs(np.diff(r[order], axis=0)[together])
    return float(np.quantile(gaps, 0.25) / (0.3186 * np.sqrt(2.0)))


def lack_of_fit(final: Fit, recording: Recording) -> bool:
    """Tell whether what a fit leaves is more than a noise known beforehand, each as uncertain as it is."""
    known = noise(final, recording)
    if known.source is Source.RESIDUAL:
        return False
    r = np.delete(
        lengths(final.residual / final.sigma, final.problem.readings.kind) * final.sigma[0], final.gross, axis=0
    )
    r = r[np.isfinite(r)] / (np.sqrt(2.0) if final.problem.readings.made else 1.0)
    free = max(len(r) - final.solution.degrees - final.instrument.n_unknown, 1.0)
    excess = np.log(float(r @ r) / free / known.sigma**2)
    doubt = PROVEN * np.sqrt(_spread(r) * (1 / free + 1 / known.degrees))
    return bool(excess > max(doubt, np.log(LEAST_EXCESS)))


def _weak(final: Fit, n_unseen: int, units: list[str]) -> list[Combination]:
    """Return the directions, beside those no reading sees, that the data know less well than the prior."""
    solution = final.solution
    order = np.argsort(solution.singular_values)[n_unseen:]
    rows = [solution.V[:, j] for j in order if solution.factors[j] < 0.5]
    if not rows:
        return []
    found = identifiability.combinations(np.array(rows), final.problem.names, units, final.problem.scale)
    return [
        dataclasses.replace(c, text=c.text.replace("change no reading", "change the readings by less than their noise"))
        for c in found
    ]


def _remedies(final: Fit) -> tuple[Remedy, ...]:
    """Return extra measurements, each with how many more directions it would pin, most first."""
    problem = final.problem
    known = _pinned([problem], final)
    span = float(np.mean([v[0] for v in problem.robot.geometry.values()][:2])) / 2
    ideas: list[tuple[str, list[Problem]]] = []
    tools = [problem.body.tool + np.array(offset) * span for offset in ((1, 0, 0), (0, 1, 0), (0, 0, -1))]
    moved = [problem.with_tool(tool) for tool in tools]
    if not problem.readings.kind.carried(problem.mechanism):  # a measuring mechanism mounted anew has new errors
        beside = f"{span:.0f} mm beside the first, at the same poses"
        ideas.append((f"a second reference point, {beside}", moved[:1]))
        ideas.append((f"a second and a third reference point, {beside}", moved[:2]))
    if problem.readings.kind.position_beside:
        ideas.append(("the position itself at the same poses, with a tracker or a camera", [_as_positions(problem)]))
    if problem.readings.kind.rotation_beside and problem.mechanism.turns:
        full = _as_positions(problem)
        three = [full.with_tool(full.body.tool + np.array(o) * span) for o in ((0, 0, 0), (1, 0, 0), (0, 1, 0))]
        ideas.append(("the platform's rotation (kind pose) at the same poses", three))
    gains = {text: _pinned([problem, *extra], final) - known for text, extra in ideas}
    # what pins no more than less of the same is no idea
    told = [
        text for text, extra in ideas if gains[text] > max((gains[t] for t, e in ideas if e == extra[:-1]), default=0)
    ]
    return tuple(
        Remedy(measurement=text, pins=gains[text], of=len(problem.names) - known)
        for text in sorted(told, key=lambda text: -gains[text])
    )


def printed(final: Fit) -> tuple[Remedy, ...]:
    """Return the one or two distances to print and measure that settle what probed heights leave open.

    Heights make a bed flat; the size of what is printed over it hangs on arms, radius and towers that they hardly see.
    All source errors count here, free or not, each with its prior: `[tolerance]`, or a broad one. What a distance may
    be off by is told with the change of the machine that goes along with it.
    """
    robot, mechanism = final.problem.robot, final.problem.mechanism
    names, noise = mechanism.model(mechanism.full_model), kind_of("distance").usual_noise
    every, _ = _with_prior(final.problem.with_names(names), robot)
    state = every.linearise(final.errors, final.instrument)
    A = np.nan_to_num(state.J_p * every.scale / final.sigma[None, :, None]).reshape(-1, len(names))
    C = np.linalg.inv(A.T @ A + np.eye(len(names))) * np.outer(every.scale, every.scale)
    reach = every.body.solve(final.errors, ())[0].x[np.unique(every.readings.rows)]
    wide = float(np.max(np.linalg.norm(reach[:, :2], axis=1)))
    turns = np.arange(0, 180, 30) * DEG
    ends = wide * np.column_stack([np.cos(turns), np.sin(turns), 0 * turns])
    points = np.concatenate([-ends, ends])
    points[:, 2] = np.median(reach[:, 2])
    rows = mechanism.rows(robot, final.errors)
    q, x, status = mechanism.inverse(points, robot.tool, rows)
    if (status != SOLVED).any():
        return ()
    dx = mechanism.sensitivity(x, q, robot.tool, rows).parameters[:, :3, every.columns]
    n = len(turns)
    J = np.einsum("ni,nij->nj", ends / wide, dx[n:] - dx[:n])
    chosen: list[Remedy] = []
    while len(chosen) < 2:
        std = np.sqrt(np.einsum("ni,ij,nj->n", J, C, J))
        k = int(np.argmax(std))
        if std[k] < 2 * noise:
            break
        along = C @ J[k] / std[k]
        size = np.abs(along) / mechanism.typical[every.columns]
        told = [
            f"{names[j]} {along[j] / to_internal(unit):+.2g} {file_unit(unit)}"
            for j in np.argsort(-size)[:4]
            for unit in [mechanism.parameters[mechanism.index[names[j]]].unit]
        ]
        text = (
            f"print two marks {2 * wide:.0f} mm apart through the centre, {turns[k] / DEG:.0f} deg from x, and measure "
            f"their distance: the heights leave it open by {std[k]:.2g} mm, with a bed as flat ({', '.join(told)})"
        )
        chosen.append(Remedy(measurement=text, pins=1, of=len(names), open_mm=float(std[k])))
        gain = C @ J[k]
        C = C - np.outer(gain, gain) / (std[k] ** 2 + noise**2)
    return tuple(chosen)


def _as_positions(problem: Problem) -> Problem:
    readings = kind_of("position").taken(np.unique(problem.readings.rows)[:, None])
    recording = dataclasses.replace(problem.recording, setup=np.zeros(problem.recording.n_rows, dtype=int))
    return dataclasses.replace(problem, readings=readings, recording=recording)


def _pinned(problems: list[Problem], final: Fit) -> int:
    """Return how many directions readings of all `problems` together would know better than the prior."""
    blocks: dict[str, list[tuple[Array, Array]]] = {}
    for p in problems:
        machine = p.solve(final.errors)
        same = p.readings.kind == final.instrument.kind
        instrument = final.instrument if same else p.begin(final.errors)
        predicted, rotations = instrument.mounted(p.mechanism, final.errors).predict(p.readings, machine.x)
        ideal = dataclasses.replace(p.readings, values=predicted, rotations=rotations)
        state = dataclasses.replace(p, readings=ideal).linearise(final.errors, instrument, machine)
        sigma = np.resize(final.sigma, state.residual.shape[1])[None, :, None]
        J_p, J_m = state.J_p * p.scale / sigma, state.J_m / sigma
        count = J_p.shape[0] * J_p.shape[1]
        blocks.setdefault(p.readings.kind.name, []).append((J_p.reshape(count, -1), J_m.reshape(count, J_m.shape[2])))
    A = []
    for parts in blocks.values():  # readings of one kind share the instrument
        J_p, J_m = np.vstack([a for a, _ in parts]), np.vstack([b for _, b in parts])
        Q = np.linalg.qr(J_m)[0] if J_m.shape[1] else np.zeros((len(J_m), 0))
        A.append(J_p - Q @ (Q.T @ J_p))
    return int((np.linalg.svd(np.vstack(A), compute_uv=False) > 1).sum())


# ------------------------------------------------------------------------------------------ over the workspace


def uncertainty_map(final: Fit, robot: Robot) -> UncertaintyMap | None:
    """Return the standard deviation of the tool position over the workspace, or None where the robot has none.

    Positions and poses: of the position in the instrument's frame, its frame's uncertainty included. Distances and
    gauge lengths know no frame: of the position after the best alignment of the map as a whole. What the data do not
    pin enters with its prior. The point of the platform is that of the first reading.
    """
    if robot.workspace is None:
        return None
    problem = final.problem
    mechanism, n = problem.mechanism, len(problem.names)
    tool = problem.body.tool[problem.readings.rows[0, 0]]
    q, x, targets, ok = check_joints(robot, tool)
    if not ok.any():
        return None
    dx = mechanism.sensitivity(x, q, tool, mechanism.rows(robot)).parameters[:, :, problem.columns]
    if (frame := final.instrument.of_points()) is not None:
        J_p, J_m = frame.linearise(frame.kind.taken(np.arange(ok.sum())[:, None]), x, dx)
        whole, part = len(final.instrument.free), len(frame.free)
        keep = [n + s * whole + j for s in range(len(frame.state)) for j in range(part)]
        J = np.concatenate([J_p, J_m], axis=2)
        C = final.covariance[np.ix_([*range(n), *keep], [*range(n), *keep])]
    else:
        J = without_motion(dx[:, :3].reshape(-1, n), x[:, :3]).reshape(-1, 3, n)
        C = final.covariance[:n, :n]
    std = np.sqrt(np.maximum(np.einsum("nij,jk,nik->ni", J, C, J), 0.0))
    norm = np.linalg.norm(std, axis=1)
    return UncertaintyMap(
        frame="best alignment of the map" if frame is None else "instrument",
        tool_mm=tuple(tool.tolist()),
        worst_mm=float(norm.max()),
        median_mm=float(np.median(norm)),
        points=tuple(
            MapPoint(target_mm=tuple(t), std_mm=tuple(s))
            for t, s in zip(targets[ok].tolist(), std.tolist(), strict=True)
        ),
        unreachable=int((~ok).sum()),
    )


# -------------------------------------------------------------------------------------------------- RESULT.json


def parameter_table(
    mechanism: Machine, change: Array, status: Mapping[str, Status], deviation: Array
) -> tuple[Parameter, ...]:
    """Return the parameters of a result: all source errors of a mechanism, in the units of files.

    Parameters
    ----------
    change : (n_p,) array
        Actual minus robot file [mm, rad].
    status : mapping
        Of the parameters that were free, by their names.
    deviation : (n,) array
        Their standard deviations [mm, rad], in the order of `status`; one that is not pinned has none.
    """
    std = {name: float(d) for (name, s), d in zip(status.items(), deviation, strict=True) if s is not Status.NOT_PINNED}
    return tuple(
        Parameter(
            name=p.name,
            value=float(value) / to_internal(p.unit),
            std=std[p.name] / to_internal(p.unit) if p.name in std else None,
            unit=file_unit(p.unit),
            status=status.get(p.name, Status.FIXED),
        )
        for p, value in zip(mechanism.parameters, change, strict=True)
    )


def _result(found: Identification) -> Result:
    final, problem = found.fit, found.fit.problem
    mechanism, names = problem.mechanism, problem.names
    n = len(names)
    deviation = np.sqrt(np.maximum(np.diag(final.covariance)[:n], 0.0))
    ruled_out = {name for c in (*found.unseen, *found.weak) for name in c.terms}
    by_prior = final.solution.posterior
    by_data = _share_of_data(final)
    status: dict[str, Status] = {}
    for j, name in enumerate(names):
        known = by_data[j] > RESOLVED if by_prior else name not in ruled_out
        given = by_prior and found.prior_given[j]
        status[name] = Status.IDENTIFIED if known else Status.BY_PRIOR if given else Status.NOT_PINNED
    sigma, recording = found.noise.sigma, problem.recording
    residual_sigma = coordinate_sigma(final)
    return Result(
        model=found.model,
        parameters=parameter_table(mechanism, final.errors - found.in_file, status, deviation),
        rank=found.observability.rank,
        rank_tolerance=identifiability.RANK_TOLERANCE,
        singular_values=found.observability.singular_values,
        condition=found.observability.condition if np.isfinite(found.observability.condition) else None,
        scaling="columns in ordinary errors, rows in mm, unknown frame projected out, at the robot file's machine",
        unidentifiable=(
            *open_combinations(found.unseen, mechanism, "not at all"),
            *open_combinations(found.weak, mechanism, "less than noise"),
        ),
        base=_base(found),
        next_measurements=found.remedies,
        regularisation=_regularisation(found),
        readings=Read(
            kind=problem.readings.kind.name, scalars=problem.readings.n_scalars, poses=len(np.unique(recording.pose))
        ),
        before_rms_mm=found.before_rms,
        degrees_of_freedom=freedom(final),
        train_rms_mm=final.rms(),
        heldout_rms_mm=found.heldout_rms if np.isfinite(found.heldout_rms) else None,
        sigma_mm=sigma,
        sigma_source=found.noise.source,
        residual_sigma_mm=residual_sigma,
        chi2_per_dof=(residual_sigma / sigma) ** 2 if sigma > 0 else None,
        gross_errors=tuple(int(problem.readings.line[j]) for j in final.gross),
        stages=_stages(found),
        accuracy=_accuracy(found),
        base_frame=_base_frames(found),
        contacts=final.instrument.kind.points(final.instrument, recording),
        workspace=found.map,
        iterations=len(final.history),
        physics=tuple(map(kept_term, problem.held)),
        physics_not_held=found.not_held,
        instrument=final.instrument.kept(recording.setup_names, recording.measurement.zero),
        robot=kept_robot(found.robot),
    )


def freedom(final: Fit) -> float:
    """Return how many scalar readings a fit leaves to judge it by: all, less what the data determine."""
    return float(final.problem.readings.n_scalars - final.solution.degrees - final.instrument.n_unknown)


def _base(found: Identification) -> tuple[BaseParameter, ...]:
    """Return the base parameters with values and standard deviations, where single parameters have none."""
    problem, n = found.fit.problem, len(found.fit.problem.names)
    values = (found.fit.errors - problem.reference)[problem.columns[:n]]
    entries = []
    for b in found.base:
        unit = problem.mechanism.parameters[problem.mechanism.index[b.name]].unit
        share = np.array([b.terms.get(name, 0.0) for name in problem.names])
        std = float(np.sqrt(max(share @ found.fit.covariance[:n, :n] @ share, 0.0)))
        entries.append(
            BaseParameter(
                name=b.name,
                combination=b.text,
                value=float(share @ values) / to_internal(unit),
                std=std / to_internal(unit),
                unit=file_unit(unit),
            )
        )
    return tuple(entries)


def _share_of_data(final: Fit) -> Array:
    """Return the part (n,) of each parameter's variance that lies in directions which the data determine."""
    solution = final.solution
    left = 1 / (1 + solution.singular_values**2)  # of each direction's prior variance
    share = solution.V**2 * left
    determined = solution.factors > 0.5
    rest = np.maximum(1 - (solution.V**2).sum(axis=1), 0.0)  # directions beyond the readings
    total = share.sum(axis=1) + rest
    result: Array = share[:, determined].sum(axis=1) / np.maximum(total, 1e-300)
    return np.where(total < NOTHING_LEFT, 1.0, result)


def open_combinations(
    several: Sequence[Combination], mechanism: Machine, seen: Literal["not at all", "less than noise"]
) -> tuple[OpenCombination, ...]:
    """Return combinations of parameters that readings do not determine, in the units of files."""
    units = {p.name: to_internal(p.unit) for p in mechanism.parameters}
    return tuple(
        OpenCombination(seen=seen, text=c.text, terms={n: v / units[n] for n, v in c.terms.items()}) for c in several
    )


def _regularisation(found: Identification) -> Regularisation:
    if not found.fit.solution.posterior:
        return Regularisation(rule=found.fit.solution.rule)
    given = sum(found.prior_given)
    return Regularisation(
        rule=f"priors: {given} from [tolerance], {len(found.prior_given) - given} broad ({BROAD:g} ordinary errors)",
        determined=found.fit.solution.degrees,
    )


def _stages(found: Identification) -> tuple[Stage, ...]:
    stages: tuple[tuple[Literal["rough", "fine"], Fit | None], ...] = (("rough", found.rough), ("fine", found.fit))
    return tuple(
        Stage(stage=name, parameters=len(f.problem.names), iterations=len(f.history), train_rms_mm=f.rms())
        for name, f in stages
        if f is not None
    )


def _accuracy(found: Identification) -> Accuracy | None:
    """Return the paper's two error measures of the measured positions, before and after; home is the most central."""
    problem, final = found.fit.problem, found.fit
    if not problem.readings.kind.positions:
        return None
    chosen = np.setdiff1d(np.arange(len(problem.readings)), final.gross)
    chosen = chosen[problem.readings.setup[chosen] == problem.readings.setup[chosen[0]]]
    measured, rows = np.nan_to_num(problem.readings.values[chosen]), problem.readings.rows[chosen, 0]
    home = int(np.argmin(np.linalg.norm(measured - np.median(measured, axis=0), axis=1)))

    def at(errors: Array) -> Largest:
        wanted = problem.poses(errors)[rows, :3]
        return Largest(
            distance_mm=largest(distance_error(measured, wanted, home)),
            volumetric_mm=largest(volumetric_error(measured, wanted, home)),
        )

    return Accuracy(
        home_line=int(problem.readings.line[chosen[home]]),
        note="largest errors relative to home; the distance error is the same in every frame, the volumetric error "
        "is taken after the rotation that fits the two sets best",
        before=at(problem.reference),
        rough=at(found.rough.errors) if found.rough else None,
        after=at(final.errors),
    )


def _base_frames(found: Identification) -> tuple[BaseFrame, ...]:
    """Return where {O} stands in the instrument's frame, set-up by set-up, with standard deviations."""
    instrument, n = found.fit.instrument, len(found.fit.problem.names)
    frames = instrument.frames()
    if 3 not in instrument.free or not frames:
        return ()
    std = np.zeros((len(instrument.state), 9))  # zero: not estimated, because no reading depends on it
    std[:, list(instrument.free)] = np.sqrt(np.maximum(np.diag(found.fit.covariance)[n:], 0.0)).reshape(len(std), -1)
    return tuple(
        BaseFrame(
            setup=found.fit.problem.recording.setup_names[s],
            rotation_deg=tuple((turn / DEG).tolist()),
            rotation_std_deg=tuple((std[s, :3] / DEG).tolist()),
            origin_mm=tuple(origin.tolist()),
            origin_std_mm=tuple(std[s, 3:6].tolist()),
        )
        for s, (turn, origin) in enumerate(frames)
    )
