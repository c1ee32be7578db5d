"""Whether readings can be used: enough for a model, of different poses, of this machine."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence

import numpy as np

from deltacal_gen.errors import (
    ConstantReadings,
    ImplausibleReadings,
    MisreadReadings,
    OptionNotApplicable,
    TooFewReadings,
)
from deltacal_gen.estimation.fit import SPARE_READINGS, fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import robot_size
from deltacal_gen.identification.mistakes import (
    AS_NEAR,
    EXPLAINED,
    IMPLAUSIBLE,
    NEARER,
    Tried,
    attempt,
    tried,
    turns_alike,
    typical,
)
from deltacal_gen.identification.outliers import left_out
from deltacal_gen.identification.repeats import about_means
from deltacal_gen.identification.rotations import turned
from deltacal_gen.instrument.kinds import kind_of, mounts
from deltacal_gen.machine.values import Recording, numbered
from deltacal_gen.units import DEG

SPARE = 1.15  # scalar readings per unknown below which a model is not chosen unasked: firmware fits 6 to 7 heights
SPARE_HEIGHTS = 1  # of probed heights and printed distances, whose noise is roughly known
NONSENSE = 0.1  # of what poses spread over: so far off, the machine explains next to nothing of the readings
NOTHING = 0.5  # of what images differ by: a machine that leaves more explains less than three quarters of it
FEWEST_COPIES = 5  # rows: fewer may agree in every digit that was written
EXACT = 1e-6  # of the machine's size: a fit that leaves less is one of readings without noise
ELSEWHERE = 45 * DEG  # of an encoder offset: it is nearer to a quarter of a turn than to a joint that was homed badly


def chosen_model(problem: Problem, asked: str | None) -> str:
    """Return the model asked for, or the largest that the readings allow, repeats of a pose counted once.

    None of them sees a source error of joints.

    Raises
    ------
    InputError
        The readings are fewer than the unknowns of the model (of the smallest model, when none was asked for).
    """
    mechanism, kind = problem.mechanism, problem.readings.kind
    if kind.sees_joints:
        if asked is not None and mechanism.full_name(asked) != mechanism.rigid_model:
            raise OptionNotApplicable(f"readings of joints see no source error of {asked}; leave the model out.")
        asked = mechanism.rigid_model
    chosen = asked or _largest(problem)
    if asked or once(problem) < wanted(problem, chosen):
        check_count(problem, chosen, problem.readings.n_scalars, _spare(problem.recording))
    return mechanism.full_name(chosen)


def _largest(problem: Problem) -> str:
    """Return the largest model that the readings allow, or the smallest."""
    mechanism, scalars = problem.mechanism, once(problem)
    shown = {mechanism.parameters[p].name for p in problem.readings.kind.carried(mechanism).values()}
    fitting = [m for m, names in mechanism.models.items() if shown.issuperset(mounts() & set(names))]
    most = len(mechanism.model(mechanism.full_model))
    by_size = sorted(fitting, key=lambda m: -len(mechanism.models[m]))
    allowed = (m for m in by_size if len(mechanism.models[m]) <= most and scalars >= wanted(problem, m))
    return next(allowed, by_size[-1])


def wanted(problem: Problem, model: str) -> int:
    """Return how many scalar readings, repeats of a pose counted once, a model is chosen for unasked."""
    extra = problem.begin(problem.reference).n_unknown
    return math.ceil(SPARE * (len(problem.mechanism.model(model)) + extra))


def _spare(recording: Recording) -> int:
    """Return how many readings beyond the unknowns a fit needs: none where the noise is known beforehand."""
    kind = kind_of(recording.kind)
    if kind.probed:
        return SPARE_HEIGHTS
    known = recording.measurement.sigma_mm is not None and not kind.rotations and not kind.sees_joints
    return 0 if known else SPARE_READINGS


def check_count(problem: Problem, model: str, scalars: int, spare: int = SPARE_READINGS) -> None:
    """Raise an InputError where `scalars` are fewer than a model's unknowns and the `spare` ones that noise shows in.

    Repeats of a pose show noise, but nothing of the machine: where a recording is split into a part to fit and a part
    to judge by, they count once.
    """
    parameters, extra = len(problem.mechanism.model(model)), problem.begin(problem.reference).n_unknown
    needed = parameters + extra + spare
    if scalars >= needed:
        return
    repeated = scalars < problem.readings.n_scalars
    from_poses = f" of {_poses(problem)} different poses, repeats counted once" if repeated else ""
    of_instrument = f" and {extra} of the instrument" if extra else ""
    shows = f", and noise shows in no fewer than {spare} more" if spare else ""
    smaller = any(len(names) < parameters for names in problem.mechanism.models.values())
    or_else = ", or choose a smaller model with --model" if smaller else ""
    raise TooFewReadings(
        f"the recording holds {scalars} independent scalar readings{from_poses}; {problem.mechanism.full_name(model)} "
        f"has {parameters} parameters{of_instrument}{shows}: {needed} are needed.",
        f"Measure more poses (deltacal plan proposes them){or_else}.",
        file=problem.recording.path,
    )


def distinct(problem: Problem) -> None:
    """Raise an InputError where the readings come from fewer than three different poses."""
    if _poses(problem) < 3:
        raise TooFewReadings(
            "the readings come from fewer than three different poses.",
            "Measure poses spread over the workspace: deltacal plan proposes them.",
            file=problem.recording.path,
        )


def _poses(problem: Problem) -> int:
    """Return at how many different joints a problem has readings."""
    return len(np.unique(np.round(problem.body.q[problem.readings.used], 9), axis=0))


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
    problem, off = first.problem, typical(first)
    spread = _explained(first, off)
    if problem.readings.kind.sees_joints:
        return
    if off < IMPLAUSIBLE * max(robot_size(problem.robot), spread):
        turns_alike(first)
        _zeros(first)
        return
    _all_the_same(problem)
    mistakes = tried(problem, off)
    if words := [m.words for m in mistakes if m.left < EXPLAINED]:
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


def _explained(first: Fit, off: float) -> float:
    """Return what the machine's poses spread over [mm]; raise an InputError where it explains next to nothing.

    No gear slips by a part of its joint's way, and images that are as far off as from one another show nothing.
    Heights, lengths and leans may be alike at all poses.
    """
    problem, found = first.problem, first.problem.readings
    unit, _ = first.instrument.unit(problem.recording.columns) or ("mm", 1.0)
    if found.kind.sees_joints:
        joints = problem.body.q
        way = [np.ptp(joints[found.rows[found.setup == j, 0], j]) for j in np.unique(found.setup)]
        spread, most, what = (
            float(np.median(way)),
            NONSENSE,
            "the encoders are {:.0%} of the joints' way off the joints",
        )
        remedy = "Compare the columns, row by row: q1 and enc1 are of one joint, at one moment, and count in one sense."
    elif unit == "px":
        spread, most = float(np.linalg.norm(np.nanstd(found.values, axis=0))), NOTHING
        what = "the machine leaves {:.0%} of what the images differ by: it explains next to nothing of what was seen"
        remedy = "Compare joints and images, row by row, and the camera in the sidecar."
    else:
        return float(np.linalg.norm(first.machine.x[found.used, :3].std(axis=0)))
    spread *= first.instrument.scale
    if off > most * spread > 0:
        raise ImplausibleReadings(f"{what.format(off / spread)}.", remedy, file=problem.recording.path)
    return float(np.linalg.norm(first.machine.x[found.used, :3].std(axis=0)))


def _nearer(mistakes: Sequence[Tried], off: float, spread: float) -> str:
    """Return in words the mistakes with which readings that are refused would not be, as near as the nearest."""
    most = min(NONSENSE * spread / off, NEARER)
    if not mistakes or mistakes[0].left >= most:
        return ""
    words = [m.words for m in mistakes if m.left < min(most, AS_NEAR * mistakes[0].left)]
    return f" They would be {mistakes[0].left * off:.2g} mm off if {', or if '.join(words)}."


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
    both = (first.machine.x[found.rows[:, 0], :3], np.nan_to_num(found.values[:, :3]))
    moved, seen = (np.linalg.norm(about_means(each, found.setup)) / np.sqrt(len(found)) for each in both)
    if moved < NONSENSE * seen:
        raise ImplausibleReadings(
            f"the readings spread over {seen:.3g} mm, yet at the joints beside them the machine moves by no more than "
            f"{moved:.2g} mm: these are not the joints at which it was read.",
            "Log the joints of this machine anew at every reading.",
            file=first.problem.recording.path,
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
    how = {"weigh_repeats": False, "must_converge": False}
    again = attempt(fit, other, Prior(), errors=at.errors, machine=at.machine, **how)
    if again is None or again.rms() > NEARER * at.rms():
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
    counted = problem.readings.kind.in_differences(problem.recording.measurement)
    tries = tried(problem, typical(first)) if counted else ()
    if unit := [m.words for m in tries if m.left < 1 and not _elsewhere(m.fit)]:
        raise MisreadReadings(
            f"the readings agree with this machine if {', or if '.join(unit)}.",
            "Correct the recording or its sidecar.",
            file=problem.recording.path,
        )
    zeros = ", ".join(f"{kinds[k].name} = {first.errors[k] / DEG:.0f}" for k in far)
    raise MisreadReadings(
        f"the readings fit this machine only with {zeros} deg: the zero of a joint is elsewhere.",
        f"Correct the joints of the recording, or say it in the robot file: [errors] {zeros.replace(', ', ' and ')}.",
        file=problem.recording.path,
    )


def _elsewhere(at: Fit) -> list[int]:
    """Return the parameters by which zeros of joints are elsewhere."""
    moved = np.abs(at.errors - at.problem.reference)
    return [k for k, p in enumerate(at.problem.mechanism.parameters) if p.unit == "rad" and moved[k] > ELSEWHERE]


def doubted(of: Problem, at: Fit) -> tuple[str, ...]:
    """Return what is to be doubted of the readings of a problem, by a fit of all or of some of them."""
    return (*left_out(of), *copied(of.recording), *turned(at), *zeroed(at))


def copied(recording: Recording) -> tuple[str, ...]:
    """Return that rows are copies of others: the same in every number, which noise and clocks leave no repeat.

    Where any repeat differs, those that agree do so by chance or by their rounding.
    """
    told = [recording.tool, *recording.channels.values()]
    beside = [np.asarray(v, dtype=float).reshape(recording.n_rows, -1) for v in told if v is not None]
    posed = numbered(np.column_stack([recording.joints, recording.setup]))
    whole = np.nan_to_num(np.column_stack([posed, recording.measured, *beside]), nan=np.inf)
    read = np.isfinite(recording.measured).any(axis=1)
    number = numbered(whole)
    source = np.unique(number, return_index=True)[1][number]
    again = np.flatnonzero(read & (source != np.arange(recording.n_rows)))
    repeats = int(read.sum()) - len(np.unique(posed[read]))
    if recording.pairs is not None or len(again) < max(FEWEST_COPIES, repeats):
        return ()
    line, of = recording.line[again[0]], recording.line[source[again[0]]]
    return (
        f"{len(again)} rows are copies of others, the same in every number (line {line} of line {of}): repeats of a "
        "measurement differ by its noise. They claim more than was measured, and the deviations are too small: leave "
        "the copies out.",
    )
