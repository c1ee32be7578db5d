"""Prediction: what an identified machine would read at other joints, in the instrument's frame."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from deltacal_gen.diagnosis.correction import Smooth, displacement, holding
from deltacal_gen.diagnosis.harmonics import turns
from deltacal_gen.diagnosis.spectrum import standing
from deltacal_gen.errors import MissingChannel, UnknownSetup, WrongFile, WrongKind
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.files.columns import ONE_SETUP
from deltacal_gen.files.imported import recorded
from deltacal_gen.files.robot import Robot, robot_of
from deltacal_gen.instrument.kind import Instrument, Readings
from deltacal_gen.instrument.kinds import POINTS, instrument_of, kind_of, readings
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.deformed import Deformed
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.ranges import outside
from deltacal_gen.physics.reading import reading_shift
from deltacal_gen.physics.terms import Term, of_reading, term_of
from deltacal_gen.results.diagnosis import Diagnosis, SmoothCorrection
from deltacal_gen.results.parts import MachineState, NeverSeen
from deltacal_gen.results.result import Result
from deltacal_gen.states import ACCELERATIONS, APPROACH, SPEEDS
from deltacal_gen.units import DEG

Known = Result | Diagnosis | MachineState  # of a machine: what is predicted from
LEAST_SEEN = 1e-9  # of the best seen combination of an instrument's unknowns: the least seen one is not seen at all
CORRECTED = "correction_share"  # channel of a prediction
COMMAND_STEPS = 20
JUST_THERE = 1e-6  # deg: the readings that were diagnosed lie not beyond themselves
COMMAND_SETTLED_MM = 1e-7  # by which a command with a smooth correction may still miss


@dataclass(frozen=True)
class Place:
    """Readings by which set-ups of the instrument are placed that a result does not know.

    Attributes
    ----------
    recording : Recording
    readings : Readings
        Of the recording, those that place.
    anew : frozenset of str
        Set-ups that are placed although the result knows one of that name: they stand elsewhere.
    """

    recording: Recording
    readings: Readings
    anew: frozenset[str] = frozenset()


def calibrated_robot(result: Known) -> Robot:
    """Return the calibrated robot of a result."""
    return robot_of(result.robot)


def known_effects(result: Known, recording: Recording | None = None) -> list[Term]:
    """Return the effects that a result knows as they act on other readings.

    A jump that was found by its row is past, unless the numbers of the poses tell which rows it lies between; and so is
    one that was found by its time, where the other readings have none.

    Parameters
    ----------
    recording : Recording, optional
        The other readings; None for a machine whose channels tell the time.
    """
    held = [term_of(t) for t in result.physics or ()]
    if recording is not None and (among := _rows_among(result, recording)) is not None:
        rows, none = np.arange(len(among)), len(among)
        return [t.counted(lambda when: float(np.interp(when, among, rows, left=-1, right=none))) for t in held]
    if result.clock == "row" or (recording is not None and recording.time_s is None):
        held = [t.afterwards() for t in held]
    return held


def _rows_among(result: Known, recording: Recording) -> Array | None:
    """Return where the rows (N,) of a recording stand among those of the recording that was diagnosed.

    That is told by the numbers of their poses where these never fall from row to row and no number is in both: parts of
    one series keep their numbers, a series that was measured anew has the same ones again. None where nothing tells it.
    """
    if result.poses is None or (numbers := recording.numbers) is None or np.isin(numbers, result.poses).any():
        return None
    return np.asarray(np.searchsorted(result.poses, numbers) - 0.5, dtype=float)


def told_of_events(result: Known, recording: Recording) -> str | None:
    """Return in words how readings are placed before or after events, where no time tells it; None where one does."""
    held = (term_of(t) for t in result.physics or ())
    events = ", ".join(dict.fromkeys(t.effect for t in held if t.happens))
    if not events or (result.clock != "row" and recording.time_s is not None):
        return None
    if _rows_among(result, recording) is not None:
        return (
            f"rows are taken as before or after the {events} by the numbers of their poses, which stand between those "
            "of the recording that was diagnosed"
        )
    lacking = "the readings" if result.clock != "row" else "the recording that was diagnosed"
    return (
        f"taken as after the {events} that was found: {lacking} had no time_s, by which readings before it would be "
        "told from those behind"
    )


def predict(result: Known, recording: Recording, place: Place | None = None) -> Recording:
    """Return the recording with its measured cells as the identified model predicts them.

    Parameters
    ----------
    result : Result or Diagnosis
    recording : Recording
        Joints, tool points and channels; its measured cells are not read.
    place : Place, optional
        Readings at other joints that say where set-ups stand which the result does not know.

    Returns
    -------
    Recording
        Where a diagnosis has a smooth correction, the channel `correction_share` says which part of it holds in each
        row: 1 where readings like it were measured, 0 far from them, where nothing is corrected.

    Raises
    ------
    InputError
        A set-up of the recording whose frame the result does not know, a channel that an effect reads and that is not
        given, or a pose that cannot be.
    """
    problem, instrument = prediction_problem(result, recording, place=place)
    x = problem.poses(problem.reference)
    values, rotations = _read(problem, instrument, x)
    if (correction := result.correction) is not None:
        share, corrected, seen, moved = _corrected(result, correction, recording, x, place=place)
        other, turned = _read(corrected, seen, moved)
        each = share[problem.readings.rows].min(axis=1)[:, None]
        values = values + each * (other - values)
        if rotations is not None and turned is not None:
            rotations = from_vector(each * to_vector(turned @ np.swapaxes(rotations, 1, 2))) @ rotations
        recording = dataclasses.replace(recording, channels=recording.channels | {CORRECTED: share})
    return problem.readings.kind.with_values(recording, problem.readings, values, rotations)


def corrected_joints(
    result: Known,
    correction: SmoothCorrection,
    joints: Array,
    tool: Array | None,
    channels: Mapping[str, Array | float],
) -> tuple[Array, Array]:
    """Return commands (N, n_q) that undo a smooth correction too, and which part (N,) of it they undo.

    Parameters
    ----------
    joints : (N, n_q) array
        Commands that bring the machine to its targets but for the correction, as the controller counts.
    tool : (3,) or (N, 3) array, optional
    channels : mapping of (N,) arrays or numbers
        Of each command, by the names of the recording's columns.

    Notes
    -----
    Newton's method with the Jacobian of the machine without the correction, on positions as the instrument reads them:
    both descriptions of the machine are fitted in that frame.
    """
    robot = calibrated_robot(result)
    mechanism = mechanism_of(robot)
    commands = commanded(result, joints, tool, channels)
    problem, instrument = prediction_problem(result, commands)
    rows = mechanism.rows(robot)
    wanted, _ = _read(problem, instrument, problem.poses(problem.reference))
    turn, tool = instrument.state[0, :9].reshape(3, 3), problem.body.tool
    for _ in range(COMMAND_STEPS):
        at = dataclasses.replace(commands, joints=joints)
        plain, seen = prediction_problem(result, at)
        x = plain.poses(plain.reference)
        reached, _ = _read(plain, seen, x)
        share, beside, other, moved = _corrected(result, correction, at, x)
        reached = reached + share[:, None] * (_read(beside, other, moved)[0] - reached)
        miss = (reached - wanted) @ turn
        joints = joints + robot.joint_sign * mechanism.undo(miss, x, plain.body.q, tool, rows)
        if np.abs(mechanism.asked(miss)).max() < COMMAND_SETTLED_MM:
            break
    return joints, share


def commanded(
    result: Known,
    joints: Array,
    tool: Array | None,
    channels: Mapping[str, Array | float],
    frame: str = "unknown",
) -> Recording:
    """Return commands (N, n_q) as a recording of positions that the result's first set-up would read, or in {O}."""
    n, mechanism = len(joints), mechanism_of(calibrated_robot(result))
    return recorded(
        Path("targets"),
        POINTS,
        mechanism.joint_units,
        joints,
        [f"{axis}_mm" for axis in mechanism.axes],
        np.full((n, len(mechanism.axes)), np.nan),
        measurement=Measurement(kind=POINTS, frame=frame),
        channels={k: np.broadcast_to(np.asarray(v, dtype=float), (n,)) for k, v in channels.items()},
        setup_names=result.instrument.setups[:1],
        tool=None if tool is None else np.broadcast_to(tool, (n, 3)),
    )


def _read(problem: Problem, instrument: Instrument, x: Array) -> tuple[Array, Array | None]:
    values, rotations = instrument.mounted(problem.mechanism, problem.reference).predict(problem.readings, x)
    return values + reading_shift(of_reading(problem.held), problem.body, problem.readings, values, x)[0], rotations


def _corrected(
    result: Known,
    correction: SmoothCorrection,
    recording: Recording,
    x: Array,
    found: Readings | None = None,
    place: Place | None = None,
) -> tuple[Array, Problem, Instrument, Array]:
    """Return which part (N,) of a smooth correction holds in each row, and all that a reading with it comes from.

    `x` are the poses without it.
    """
    machine, functions = correction.machine, [Smooth(**vars(kept)) for kept in correction.smooth]
    beside = result.replace(robot=machine.robot, physics=machine.physics, instrument=machine.instrument)
    robot = calibrated_robot(beside)
    q = robot.joint_sign * recording.joints
    share = holding(functions, recording, q, x)
    moved, shift = displacement(functions, recording, q, x)
    recording = dataclasses.replace(recording, joints=recording.joints + robot.joint_sign * moved)
    problem, instrument = prediction_problem(beside, recording, found, place)
    x = problem.poses(problem.reference)
    return share, problem, instrument, np.hstack([x[:, :3] + shift, x[:, 3:]])


def prediction_problem(
    result: Known, recording: Recording, found: Readings | None = None, place: Place | None = None
) -> tuple[Problem, Instrument]:
    """Return the problem of a recording with nothing free, and the instrument that a result knows for it.

    `place` says where set-ups stand that the result does not know.
    """
    problem = _known_problem(result, recording, found)
    problem, instrument = _with_instrument(result, problem, place)
    for term in problem.held:
        if why := problem.body.missing(term):
            raise MissingChannel(
                f"what was diagnosed ({term.effect}) needs {why}.",
                f"Add it, with the values at which the readings are to be predicted{_made_of(term, recording)}.",
                file=recording.path,
            )
    return problem, instrument


def _known_problem(result: Known, recording: Recording, found: Readings | None = None) -> Problem:
    """Return the problem of readings, by default of all that a recording may hold, of a machine with nothing free."""
    recording = dataclasses.replace(
        recording, begun=result.begun_s
    )  # its time counts from when that of the result does
    found = kind_of(recording.kind).unread(recording) if found is None else found
    return pose_problem(calibrated_robot(result), recording, (), found=found, held=known_effects(result, recording))


def _made_of(term: Term, recording: Recording) -> str:
    """Return what the states of an effect are made of, in words, where a recording could have that in their place."""
    of_motion = any(c.column in (SPEEDS, ACCELERATIONS, APPROACH) for s in term.states for c in s.channels)
    if not of_motion or recording.time_s is not None:
        return ""
    return "; or time_s, and run where a movement begins anew, of rows along it: it is made of them"


def has_law(result: Known) -> bool:
    """Tell whether a law that nobody has registered is part of a result."""
    return any(is_law(t.effect) for t in result.physics or ())


def beyond_laws(result: Known, recording: Recording) -> np.ndarray:
    """Return which rows (N,) of a recording lie outside the range in which a law of a result was found."""
    if not has_law(result):
        return np.zeros(recording.n_rows, dtype=bool)
    problem = _known_problem(result, recording)
    return outside(problem.body, problem.solve(problem.reference), problem.held)


def beyond_waves(result: Known, recording: Recording) -> tuple[NeverSeen, ...]:
    """Return the joints that stand beyond the turns at which a wave was read that was not seen to repeat."""
    waves = [e.read_deg for e in result.effects if e.read_deg] if isinstance(result, Diagnosis) else []
    read = {int(limb): span for wave in waves for limb, span in wave.items()}
    if not read:
        return ()
    turn = turns(_known_problem(result, recording))
    every = [(limb, turn[:, limb - 1], span) for limb, span in sorted(read.items())]
    return standing(
        (limb, own, (own / DEG < low - JUST_THERE) | (own / DEG > high + JUST_THERE), partial(_on_both_sides, low))
        for limb, own, (low, high) in every
    )


def _on_both_sides(low: float, turn: Array) -> list[tuple[float, float]]:
    """Return between which angles [deg] turns (N,) [rad] lie, those below `low` [deg] and the others."""
    ways = (turn[turn / DEG < low] / DEG, turn[turn / DEG >= low] / DEG)
    return [(float(way.min()), float(way.max())) for way in ways if len(way)]


def place_of(other: Recording, asked: Recording) -> Place:
    """Return where the set-ups of a recording stand by another recording's readings of other poses.

    Raises
    ------
    InputError
        It is the recording that is asked for, or holds no reading.
    """
    if Path(other.path).resolve() == Path(asked.path).resolve():
        raise WrongFile(
            "the file would place the instrument by the readings that are to be predicted.",
            "Give readings of other poses from the same set-up.",
            file=other.path,
        )
    if len(other.setup_names) == len(asked.setup_names) == 1 and ONE_SETUP in (other.setup_names, asked.setup_names):
        other = dataclasses.replace(other, setup_names=asked.setup_names)
    return Place(other, readings(other), frozenset(other.setup_names))


def unknown_setups(result: Known, recording: Recording) -> tuple[str, ...]:
    """Return the names of a recording's set-ups that a result does not know: of another kind of readings, all.

    Where neither side has more than one, and one side gives it no name, they are the same.
    """
    known, asked = result.instrument.setups, recording.setup_names
    if kind_of(recording.kind).stays and result.instrument.kind == recording.kind:
        return ()
    if kind_of(recording.kind).like(instrument_of(result.instrument), recording) is None:
        return asked
    if len(known) == len(asked) == 1 and ONE_SETUP in (tuple(known), tuple(asked)):
        return ()
    return tuple(n for n in asked if n not in known)


def _with_instrument(result: Known, problem: Problem, place: Place | None) -> tuple[Problem, Instrument]:
    """Return a problem whose set-ups are counted as the rows of an instrument, and the instrument."""
    recording, found = problem.recording, problem.readings
    own = found.kind.own(found, recording, problem.robot, lambda: problem.poses(problem.reference))
    if own is not None:
        return problem, own
    names, given = result.instrument.setups, instrument_of(result.instrument)
    if found.kind.stays and given.kind == found.kind:
        return problem, given
    instrument = found.kind.like(given, recording)
    asked = {recording.setup_names[k] for k in np.unique(found.setup)}
    unknown = sorted(asked & {*unknown_setups(result, recording)})
    anew = frozenset(unknown) | (place.anew & asked if place else frozenset())
    row = {name: k for k, name in enumerate(names)}
    if anew and place is not None:
        placed = _placed(result, place, anew)
        state = placed.state if instrument is None else np.vstack([instrument.state, placed.state])
        row |= {name: len(state) - len(placed.state) + k for k, name in enumerate(sorted(anew))}
        instrument = dataclasses.replace(placed, state=state)
    elif instrument is None:
        raise WrongKind(
            f"the result was identified from readings of the kind '{given.kind.name}' and knows no frame for "
            f"'{found.kind.name}'.",
            f'Give readings of the kind {given.kind.name}, or say frame = "robot" in the sidecar.',
            file=recording.path,
        )
    elif unknown:
        raise UnknownSetup(
            f"the result knows no frame of the set-up '{unknown[0]}'; it knows {', '.join(names)}.",
            "Give readings of that set-up at other poses: predict --place OTHER.csv.",
            file=recording.path,
            column="setup",
        )
    setup = np.array([row.get(name, 0) for name in recording.setup_names])[found.setup]
    return dataclasses.replace(problem, readings=dataclasses.replace(found, setup=setup)), instrument


def _placed(result: Known, place: Place, anew: frozenset[str]) -> Instrument:
    """Return an instrument with a row for each of the set-ups `anew`, in the order of their names.

    Raises
    ------
    InputError
        There are no readings of one of them, or they leave open where it stands.
    """
    names, recording = sorted(anew), place.recording
    code = np.array([names.index(n) if n in anew else -1 for n in recording.setup_names])
    found = place.readings.subset(code[place.readings.setup] >= 0)
    found = dataclasses.replace(found, setup=code[found.setup])
    for k, name in enumerate(names):
        if not (found.setup == k).any():
            raise UnknownSetup(
                f"there is no reading that says where the set-up '{name}' stands.",
                "Measure some poses from there.",
                file=recording.path,
                column="setup",
            )
    recording = dataclasses.replace(recording, setup=np.maximum(code[recording.setup], 0), setup_names=tuple(names))
    problem = _known_problem(result, recording, found)
    machine = problem.solve(problem.reference)
    start = problem.begin(problem.reference, machine)
    _check_seen(problem, start, machine, names)
    return fit(problem, LeastSquares(), machine=machine, instrument=start, weigh_repeats=False).instrument


def _check_seen(problem: Problem, instrument: Instrument, machine: Deformed, names: Sequence[str]) -> None:
    """Raise an InputError where readings do not say where the instrument stands: too few of them, or all on a line."""
    if not instrument.n_unknown:
        return
    _, _, J = problem.linearise(problem.reference, instrument, machine)
    typical = np.tile(instrument.kind.typical[list(instrument.free)], len(instrument.state))
    for k, name in enumerate(names):
        mine = problem.readings.setup == k
        own = J[mine] * typical
        rows = own.reshape(-1, own.shape[2])
        sizes = np.linalg.svd(rows[np.isfinite(rows).all(axis=1)], compute_uv=False)
        if len(sizes) < len(instrument.free) or sizes[len(instrument.free) - 1] <= LEAST_SEEN * sizes[0]:
            raise UnknownSetup(
                f"the {mine.sum()} readings of the set-up '{name}' leave open where it stands.",
                "Measure at least four poses from there that do not lie on a line.",
                file=problem.recording.path,
                column="setup",
            )


def residual(result: Known, recording: Recording, found: Readings, place: Place | None = None) -> Array:
    """Return measured minus predicted (R, k) of readings that the result has not seen [mm, rad]."""
    problem, instrument = prediction_problem(result, recording, found, place)
    x = problem.poses(problem.reference)
    r = problem.residual(problem.reference, instrument, x)
    if (correction := result.correction) is not None:
        share, other, seen, moved = _corrected(result, correction, recording, x, found, place)
        r += share[found.rows].min(axis=1)[:, None] * (other.residual(other.reference, seen, moved) - r)
    return r
