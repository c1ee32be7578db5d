"""Whether readings can be used: enough for a model, of different poses, of this machine, row by row of their joints."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from deltacal_gen.errors import (
    ConstantReadings,
    ContradictingRows,
    ImplausibleReadings,
    InputError,
    MisreadReadings,
    NoSolutionError,
    OptionNotApplicable,
    TooFewReadings,
)
from deltacal_gen.estimation.fit import SPARE_READINGS, fit, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import unsaid
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import HUBER, MOST_APART, MOST_GROSS, apart, lengths, rms
from deltacal_gen.estimation.series import sequence
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import robot_size
from deltacal_gen.identification.mistakes import (
    AS_NEAR,
    EXPLAINED,
    MOST_FITTED,
    NEARER,
    in_other_units,
    sizes,
    tried,
    turns_alike,
    typical,
)
from deltacal_gen.identification.rotations import turned
from deltacal_gen.instrument.kinds import kind_of, mounts, readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.values import Recording, numbered
from deltacal_gen.units import DEG

SPARE = 1.15  # scalar readings per unknown below which a model is not chosen unasked: firmware fits 6 to 7 heights
SPARE_HEIGHTS = 1  # of probed heights and printed distances, whose noise is roughly known
IMPLAUSIBLE = 0.005  # of the machine's size: more is no error of stiff parts; mistakes of the recording are looked for
NONSENSE = 0.1  # of what poses spread over: so far off, the machine explains next to nothing of the readings
NOTHING = 0.5  # of what images differ by: a machine that leaves more explains less than three quarters of it
FEW = 12  # lines that a sentence names
FEWEST_COPIES = 5  # rows: fewer may agree in every digit that was written
EXACT = 1e-6  # of the machine's size: a fit that leaves less is one of readings without noise
MOST_TRIED = 30  # poses: of more, what one says is little enough to be left to its weight
ELSEWHERE = 45 * DEG  # of an encoder offset: it is nearer to a quarter of a turn than to a joint that was homed badly


def chosen_model(mechanism: Machine, problem: Problem, recording: Recording, asked: str | None) -> str:
    """Return the model asked for, or the largest that the readings allow, repeats of a pose counted once.

    None of them sees a source error of joints.

    Raises
    ------
    InputError
        The readings are fewer than the unknowns of the model (of the smallest model, when none was asked for).
    """
    scalars = problem.readings.n_scalars
    extra = problem.begin(problem.reference).n_unknown
    if problem.readings.kind.sees_joints:
        if asked is not None and mechanism.full_name(asked) != mechanism.rigid_model:
            raise OptionNotApplicable(f"readings of joints see no source error of {asked}; leave the model out.")
        _check_count(recording, mechanism, scalars, 0, extra, mechanism.rigid_model, SPARE_READINGS)
        return mechanism.rigid_model
    shown = {mechanism.parameters[p].name for p in problem.readings.kind.carried(mechanism).values()}
    fitting = [m for m in mechanism.models if shown.issuperset(mounts() & set(mechanism.models[m]))]
    whole = len(mechanism.model(mechanism.full_model))
    by_size = sorted((m for m in fitting if len(mechanism.models[m]) <= whole), key=lambda m: -len(mechanism.models[m]))
    if asked is not None:
        names, name = mechanism.model(asked), mechanism.full_name(asked)
        _check_count(recording, mechanism, scalars, len(names), extra, name, _spare(recording))
        return name
    for name in by_size:
        if once(problem) >= wanted(problem, name):
            return name
    smallest = by_size[-1]
    _check_count(recording, mechanism, scalars, len(mechanism.models[smallest]), extra, smallest, _spare(recording))
    return smallest


def wanted(problem: Problem, model: str) -> int:
    """Return how many scalar readings, repeats of a pose counted once, a model is chosen for unasked."""
    extra = problem.begin(problem.reference).n_unknown
    return math.ceil(SPARE * (len(problem.mechanism.model(model)) + extra))


def enough(mechanism: Machine, problem: Problem, recording: Recording) -> None:
    """Raise an InputError where the readings cannot carry the problem's own parameters and the instrument's."""
    extra = problem.begin(problem.reference).n_unknown
    scalars = problem.readings.n_scalars
    _check_count(recording, mechanism, scalars, len(problem.names), extra, mechanism.full_model, SPARE_READINGS)


def _spare(recording: Recording) -> int:
    """Return how many readings beyond the unknowns a fit needs: none where the noise is known beforehand."""
    kind = kind_of(recording.kind)
    if kind.probed:
        return SPARE_HEIGHTS
    return 0 if recording.measurement.sigma_mm is not None and not kind.rotations else SPARE_READINGS


def _more_poses(mechanism: Machine, parameters: int, to: str = "more poses") -> str:
    """Return what to do where readings do not carry a model: a smaller one is offered where there is one."""
    smaller = any(len(names) < parameters for names in mechanism.models.values())
    or_else = ", or choose a smaller model with --model" if smaller else ""
    return f"Measure {to} (deltacal plan proposes them){or_else}."


def _check_count(
    recording: Recording, mechanism: Machine, scalars: int, parameters: int, extra: int, model: str, spare: int
) -> None:
    """Raise an InputError where readings are fewer than the unknowns and the `spare` ones that noise shows in."""
    needed = parameters + extra + spare
    if scalars >= needed:
        return
    of_instrument = f" and {extra} of the instrument" if extra else ""
    shows = f", and noise shows in no fewer than {spare} more" if spare else ""
    raise TooFewReadings(
        f"the recording holds {scalars} independent scalar readings; {model} has {parameters} "
        f"parameters{of_instrument}{shows}: {needed} are needed.",
        _more_poses(mechanism, parameters),
        file=recording.path,
    )


def distinct(problem: Problem, recording: Recording) -> None:
    """Raise an InputError where the readings come from fewer than three different poses."""
    used = np.unique(problem.readings.rows)
    if len(np.unique(np.round(problem.body.q[used], 9), axis=0)) < 3:
        raise TooFewReadings(
            "the readings come from fewer than three different poses.",
            "Measure poses spread over the workspace: deltacal plan proposes them.",
            file=recording.path,
        )


def enough_poses(problem: Problem, model: str) -> None:
    """Raise an InputError where different poses, each counted once, are fewer than a model's parameters need.

    Repeats of a pose show noise, but nothing of the machine: such a recording cannot be split into a part to fit and a
    part to judge by.
    """
    poses, scalars = _poses(problem), once(problem)
    extra = problem.begin(problem.reference).n_unknown
    needed = len(problem.names) + extra + SPARE_READINGS
    if scalars < needed:
        of_instrument = f" and {extra} of the instrument" if extra else ""
        raise TooFewReadings(
            f"the readings come from {poses} different poses: {scalars} scalars, each counted once, where {model} has "
            f"{len(problem.names)} parameters{of_instrument}. The recording is too short to split: repeats show noise, "
            "not what is missing.",
            _more_poses(problem.mechanism, len(problem.names), f"enough different poses for {needed} scalars"),
            file=problem.recording.path,
        )


def _poses(problem: Problem) -> int:
    """Return at how many different joints a problem has readings."""
    return len(np.unique(np.round(problem.body.q[np.unique(problem.readings.rows)], 9), axis=0))


def once(problem: Problem) -> int:
    """Return how many scalars the readings are where repeats of a pose count once."""
    found = problem.readings
    scalars = min(found.n_scalars, found.kind.per_pose * len(np.unique(found.group)))
    return min(scalars, 3 * _poses(problem)) if found.rows.shape[1] == 2 else scalars


def plausible(first: Fit) -> None:
    """Raise an InputError where the readings cannot be of this machine, and name the mistakes that would explain them.

    A rigid machine is off by less than half a per cent of its size once its encoder offsets are known. A soft one is
    off by more, and no check refuses it: beyond that, the mistakes that people make are tried, and the readings are
    refused where one of them explains nearly all, or where the machine explains next to nothing of what was read. Of
    a poor machine no mistake explains nearly all: then those are told with which nothing would be refused.
    """
    problem, found = first.problem, first.problem.readings
    off = typical(first)
    if found.kind.sees_joints:
        _of_these_joints(first, off)
        return
    _read_at_all(first, off)
    points = first.machine.x[found.used, :3]
    spread = float(np.linalg.norm(points.std(axis=0)))
    if off < IMPLAUSIBLE * max(robot_size(problem.robot), spread):
        turns_alike(first)
        _zeros(first)
        return
    _all_the_same(problem)
    mistakes = tried(problem, off)
    if words := [said for left, said in mistakes if left < EXPLAINED]:
        raise MisreadReadings(
            f"the readings are {off:.3g} mm off this machine, but agree with it if {', or if '.join(words)}.",
            "Correct the recording, its sidecar or the robot file.",
            file=problem.recording.path,
        )
    turns_alike(first)
    _stood_still(problem)
    _joints_stood_still(first)
    if off > NONSENSE * spread:
        raise ImplausibleReadings(
            f"the readings are {off:.3g} mm off this machine, {off / spread:.0%} of what its poses spread over: more "
            f"than any error of its parts.{_nearer(mistakes, off, spread)}",
            "Compare the robot file with the machine (of a chain also whether its table is standard or modified), and "
            "the columns of the recording with what was measured, and of which point.",
            file=problem.recording.path,
        )


def _nearer(mistakes: list[tuple[float, str]], off: float, spread: float) -> str:
    """Return in words the mistakes with which readings that are refused would not be, as near as the nearest."""
    most = NONSENSE * spread / off
    words = [said for left, said in mistakes if left < min(most, NEARER, AS_NEAR * mistakes[0][0])]
    if not words:
        return ""
    return f" They would be {mistakes[0][0] * off:.2g} mm off if {', or if '.join(words)}."


def _all_the_same(problem: Problem) -> None:
    """Raise an InputError where one coordinate never changes, its noise is not said, and the machine fell into it.

    Any machine folded flat fits a surface without error: what is left says nothing of the noise, nor of mistakes.
    """
    found, said = problem.readings, problem.recording.measurement
    if (
        not found.kind.positions
        or len(found.components) > 1
        or said.sigma_mm is not None
        or np.nanstd(found.values) > 0
    ):
        return
    raise ConstantReadings(
        "all readings are the same, as of a surface that was followed: a machine folded flat onto it would fit "
        "them without any error, so that their noise cannot be told from them.",
        "Say under [measurement] in the sidecar how well the surface was followed, sigma_mm.",
        file=problem.recording.path,
    )


def all_but_one(first: Fit) -> np.ndarray | None:
    """Return which readings are left where those of one pose alone are not of this machine; None where there is none.

    Where poses are few, one with the joints or cells of another pulls the machine so far that it does not stand out of
    what is left, whatever it weighs. It is among those that are farthest off the machine as drawn, and shows in what a
    fit of all others leaves.
    """
    problem, found = first.problem, first.problem.readings
    if not found.kind.positions or not 1 < len(np.unique(found.group)) <= MOST_TRIED:
        return None
    most, before = IMPLAUSIBLE * robot_size(problem.robot), sizes(first)
    others = found.group != found.group[np.argmax(before)]
    if rms(before[others]) < most and np.mean(~others) <= MOST_GROSS:
        return None  # its weight makes next to nothing of it
    models = problem.mechanism.models
    drawn = problem.with_names(unsaid(problem.with_names(max(models.values(), key=len))))
    far = sizes(fit(drawn, Prior(), weigh_repeats=False, must_converge=False))
    poses = list(dict.fromkeys(found.group[np.argsort(-far)].tolist()))
    for pose in poses[:MOST_FITTED]:
        rest = np.flatnonzero(found.group != pose)
        try:
            left = rms(sizes(rough(problem.subset(rest), must_converge=False)))
        except (InputError, NoSolutionError):
            continue
        if left < min(most, EXPLAINED * rms(before)):
            return rest
    return None


def _stood_still(problem: Problem) -> None:
    """Raise an InputError where an instrument wrote its last reading on, in every number, while joints moved."""
    found, joints = problem.readings, problem.body.q[problem.readings.rows[:, 0]]
    if np.isfinite(found.values).any(axis=0).sum() < 2 or found.rows.shape[1] > 1:
        return  # one length, height or coordinate may well be read twice
    if not found.kind.numbers or found.kind.aims == "touch":
        return  # what was touched may be touched again
    again = (np.nan_to_num(found.values[1:]) == np.nan_to_num(found.values[:-1])).all(axis=1)
    again &= (joints[1:] != joints[:-1]).any(axis=1)
    if again.sum() < FEWEST_COPIES:
        return
    start = int(np.argmax(again))
    end = start + int(np.argmin(np.append(again[start:], False)))
    raise ConstantReadings(
        f"{again.sum()} readings are the one before in every number, though joints moved (the first in lines "
        f"{found.line[start]} to {found.line[end]}): the instrument had lost its target, or stood still.",
        "Leave their measured cells blank.",
        file=problem.recording.path,
        line=int(found.line[start + 1]),
    )


def _joints_stood_still(first: Fit) -> None:
    """Raise an InputError where what was measured moved, set-up by set-up, and the machine at these joints did not."""
    found = first.problem.readings
    if not found.kind.positions or found.rows.shape[1] > 1:
        return
    points, read = first.machine.x[found.rows[:, 0], :3], found.values[:, :3]
    moved, seen = (_spread_within(found.setup, each) for each in (points, read))
    if moved < NONSENSE * seen:
        raise ImplausibleReadings(
            f"the readings spread over {seen:.3g} mm, yet at the joints beside them the machine moves by no more than "
            f"{moved:.2g} mm: these are not the joints at which it was read.",
            "Log the joints of this machine anew at every reading.",
            file=first.problem.recording.path,
        )


def _spread_within(setup: Array, points: Array) -> float:
    """Return what points (R, 3) spread over about the mean of their own set-up, whose frame is its own [mm]."""
    own = [np.ma.masked_invalid(points[setup == s]) for s in np.unique(setup)]
    squares = (((each - each.mean(axis=0)) ** 2).filled(0.0).sum() for each in own)
    return float(np.sqrt(sum(squares) / len(points)))


def _read_at_all(first: Fit, off: float) -> None:
    """Raise an InputError where images are as far off as they are from one another: then they show nothing."""
    found, problem = first.problem.readings, first.problem
    name, _ = first.instrument.unit(problem.recording.columns) or ("mm", 1.0)
    if name != "px":
        return  # heights, lengths and leans may be alike at all poses: what the poses spread over is what counts
    spread = first.instrument.scale * float(np.linalg.norm(np.nanstd(found.values, axis=0)))
    if off > NOTHING * spread > 0:
        raise ImplausibleReadings(
            f"the machine explains next to nothing of what was seen: it leaves {off / spread:.0%} of what the images "
            "differ by.",
            "Compare joints and images, row by row, and the camera in the sidecar.",
            file=problem.recording.path,
        )


def zeroed(at: Fit) -> tuple[str, ...]:
    """Return that lengths count from a zero of their own, where that takes away most of what a fit leaves.

    A wire's drum and a scale's slider know what moved, not how long it is. Left out, such a zero bends the machine and
    looks like noise that all rows share.
    """
    problem, said = at.problem, at.problem.recording.measurement
    freed = dataclasses.replace(said, zero="incremental")
    other = dataclasses.replace(problem, recording=dataclasses.replace(problem.recording, measurement=freed))
    counted = problem.readings.kind.in_differences(freed) and said.zero != freed.zero
    if not counted or at.rms() < EXACT * robot_size(problem.robot):
        return ()
    begun = other.begin(at.errors, at.machine)
    unknown = at.solution.degrees + begun.n_unknown + SPARE_READINGS
    if begun.n_unknown == at.instrument.n_unknown or problem.readings.n_scalars < unknown:
        return ()
    try:
        again = fit(other, Prior(), errors=at.errors, machine=at.machine, weigh_repeats=False, must_converge=False)
    except (InputError, NoSolutionError):
        return ()
    if again.rms() > NEARER * at.rms():
        return ()
    zero = float(np.median(again.instrument.state[:, again.instrument.free[-1]]))
    return (
        f"the lengths count from a zero of their own: {abs(zero):.3g} mm {'longer' if zero > 0 else 'shorter'} than "
        f"from point to point, which leaves {again.rms():.3g} mm instead of {at.rms():.3g} mm. Correct the column "
        f'{problem.recording.columns[0]}, or say zero = "incremental" under [measurement] in the sidecar.',
    )


def _zeros(first: Fit) -> None:
    """Raise an InputError where the readings agree with the machine by a joint whose zero is elsewhere."""
    problem, kinds, far = first.problem, first.problem.mechanism.parameters, _elsewhere(first)
    if not far:
        return
    if unit := [words for words, again in in_other_units(first) if not _elsewhere(again)]:
        raise MisreadReadings(
            f"the readings agree with this machine if {', or if '.join(unit)}.",
            "Correct the recording or its sidecar.",
            file=problem.recording.path,
        )
    zeros = ", ".join(f"{kinds[k].name} = {first.errors[k] / DEG:.0f}" for k in far)
    raise MisreadReadings(
        f"the readings want {zeros} deg of this machine: the zero of a joint is elsewhere.",
        f"Correct the joints of the recording, or say it in the robot file: [errors] {zeros.replace(', ', ' and ')}.",
        file=problem.recording.path,
    )


def _elsewhere(at: Fit) -> list[int]:
    """Return the parameters by which zeros of joints are elsewhere."""
    moved = np.abs(at.errors - at.problem.reference)
    return [k for k, p in enumerate(at.problem.mechanism.parameters) if p.unit == "rad" and moved[k] > ELSEWHERE]


def _of_these_joints(first: Fit, off: float) -> None:
    """Raise an InputError where encoders go with their joints hardly at all: no gear slips by a part of its way."""
    found, joints = first.problem.readings, first.problem.body.q
    way = np.array([np.ptp(joints[found.rows[found.setup == j, 0], j]) for j in np.unique(found.setup)])
    spread = first.instrument.scale * float(np.median(way))
    if off > NONSENSE * spread:
        raise MisreadReadings(
            f"the encoders are {off / spread:.0%} of the joints' way off what the joints say.",
            "Compare the columns, row by row: q1 and enc1 are of one joint, at one moment, and count in one sense.",
            file=first.problem.recording.path,
        )


def without_knocked(problem: Problem, first: Fit) -> Problem | None:
    """Return the problem without gross errors in runs, with the others again before and behind: no model's; else None.

    So many pull a fit towards them, that they do not stand out of it: what a fit of the others alone leaves of them
    tells. `first` is fitted to some readings or all.
    """
    some = first.problem
    suspect = _deviations(first.residual, first) > HUBER
    if some.readings.kind.picked or not MOST_GROSS < suspect.mean() <= MOST_APART:
        return None
    rest, begin = some.subset(np.flatnonzero(~suspect)), first.instrument
    try:
        others = fit(rest, Prior(), errors=first.errors, instrument=begin, weigh_repeats=False, must_converge=False)
    except (InputError, NoSolutionError):
        return None
    left = problem.residual(others.errors, others.instrument, problem.poses(others.errors))
    far = apart(_deviations(left, others))
    return problem.subset(np.flatnonzero(~far)) if _for_a_while(far, problem) else None


def _for_a_while(far: np.ndarray, problem: Problem) -> bool:
    """Tell whether readings (R,) are in runs, more than errors of measurement are, and end as they began.

    What reaches the begin or the end of a set-up may be a slip, which has a name.
    """
    found = problem.readings
    order = np.lexsort((sequence(found, problem.recording), found.setup))
    off, setup = far[order], found.setup[order]
    begins = np.append(True, setup[1:] != setup[:-1])
    both = off[1:] & off[:-1]
    in_runs = np.append(both, False) | np.append(False, both)
    ends = begins | np.append(begins[1:], True)
    return bool(in_runs.mean() > MOST_GROSS >= (off & ~in_runs).mean() and not off[ends].any())


def _deviations(residual: Array, at: Fit) -> Array:
    """Return how many standard deviations of a fit the largest component of each reading (R,) is off."""
    size: Array = np.nanmax(np.abs(residual) / at.sigma, axis=1)
    return size


def doubted(of: Problem, at: Fit) -> tuple[str, ...]:
    """Return what is to be doubted of the readings of a problem, by a fit of all or of some of them."""
    return (*left_out(of), *copied(of.recording), *turned(at), *zeroed(at))


def gross_lines(at: Fit) -> tuple[int, ...]:
    """Return the lines of gross errors, those among them that a fit was made without; see `without_knocked`."""
    found = at.problem.readings
    return tuple(sorted({*_left_out(at.problem), *found.line[at.gross].tolist()}))


def _left_out(of: Problem) -> list[int]:
    if of.readings.made:
        return []
    whole, kept = (
        set(zip(r.line.tolist(), r.setup.tolist(), strict=True)) for r in (readings(of.recording), of.readings)
    )
    return sorted({line for line, _ in whole - kept})  # of a line one encoder may be left out, and not the others


def left_out(of: Problem) -> tuple[str, ...]:
    """Return that readings of the recording are none of a problem's, and which; see `without_knocked`."""
    if not (lines := _left_out(of)):
        return ()
    named = ", ".join(map(str, lines[:FEW])) + (" ..." if len(lines) > FEW else "")
    return (
        f"{len(lines)} readings are far beyond all others together and were left out (lines {named}): an "
        "overflow, a reflector that was knocked or lost for a while, another one that was caught, or joints of another "
        "pose. Measure these poses again.",
    )


def copied(recording: Recording) -> tuple[str, ...]:
    """Return that rows are copies of others: the same in every number, which noise and clocks leave no repeat.

    Where any repeat differs, those that agree do so by chance or by their rounding.
    """
    told = [recording.tool, *(recording.channels[name] for name in sorted(recording.channels))]
    beside = [np.asarray(v, dtype=float).reshape(recording.n_rows, -1) for v in told if v is not None]
    posed = numbered(np.column_stack([recording.joints, recording.setup]))
    whole = np.nan_to_num(np.column_stack([posed, recording.measured, *beside]), nan=np.inf)
    read = np.isfinite(recording.measured).any(axis=1)
    _, first, row = np.unique(whole, axis=0, return_index=True, return_inverse=True)
    again = read & (first[row.ravel()] != np.arange(recording.n_rows))
    repeats = int(read.sum()) - len(np.unique(posed[read]))
    if recording.pairs is not None or again.sum() < FEWEST_COPIES or again.sum() < repeats:
        return ()
    line = recording.line[np.flatnonzero(again)[0]]
    of = recording.line[first[row.ravel()[np.flatnonzero(again)[0]]]]
    return (
        f"{again.sum()} rows are copies of others, the same in every number (line {line} of line {of}): repeats of a "
        "measurement differ by its noise. They claim more than was measured, and the deviations are too small: leave "
        "the copies out.",
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
            raise ContradictingRows(
                f"the readings of lines {a} and {b} are swapped: each fits the joints of the other to "
                f"{max(gap[i, j], gap[j, i]):.3g} mm and its own only to {min(gap[i, i], gap[j, j]):.3g} mm.",
                "Exchange the measured cells of the two lines.",
                file=recording.path,
                line=a,
            )
