"""Two clocks: joints in NAME.csv on one, readings in NAME.instrument.csv on another.

t_joints = t_instrument + offset of the run + rate t_instrument. Joints are splines in time, so that they are known at
whatever time a reading turns out to belong to. Readings are of the machine at rest, pose by pose, or of its drives.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from deltacal_gen.errors import ClockMismatch, OptionNotApplicable
from deltacal_gen.files.columns import instrument_path
from deltacal_gen.files.recording import recording_of_rows
from deltacal_gen.files.rows import Rows, read_table
from deltacal_gen.files.sidecar import measurement_of, read_sidecar
from deltacal_gen.motion import trajectories
from deltacal_gen.motion.derivatives import motion
from deltacal_gen.physics import splines
from deltacal_gen.physics.motion import REVERSED, approach
from deltacal_gen.physics.splines import Path as Movement
from deltacal_gen.physics.splines import Samples
from deltacal_gen.states import ACCELERATIONS, APPROACH, CLOCK, SPEEDS, TIME
from deltacal_gen.units import joint_factors, joint_names, of_joints

if TYPE_CHECKING:
    from scipy.interpolate import BSpline

    from deltacal_gen.machine.registry import Array, Machine
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.results.result import Parameter

OFFSET, RATE = CLOCK
CUBIC = 3  # degree of what lies between samples whose derivatives are known
SHARED = "own, same for all runs"  # one offset
SAME_RATE = "own, same rate"


@dataclass(frozen=True, eq=False)
class Clock:
    """Where the instrument's clock stands against that of the joints.

    Attributes
    ----------
    offsets : (R,) array
        By run [s].
    rate : float
    """

    offsets: Array
    rate: float = 0.0

    def joint_time(self, time: Array, run: np.ndarray) -> Array:
        """Return the joints' time (N,) [s] of instants on the instrument's clock in some runs."""
        return np.asarray(time + self.offsets[run] + self.rate * time)


@dataclass(frozen=True, eq=False)
class Clocked:
    """Readings and joints, each with its own time.

    Attributes
    ----------
    clock : str
        What the sidecar says of the clocks.
    offset : float or None
        Offset that the sidecar says [s].
    path : Path or str
        Of the readings.
    line : (N,) array of int
        In that file.
    time, run : (N,) arrays
        Of the readings [s]; run by index into `run_names`.
    run_names : tuple of str
    movements : list of (int, Movement)
        Joints as splines, with the run that each belongs to.
    joints : Trajectories
    """

    clock: str
    offset: float | None
    path: Path | str
    line: np.ndarray
    time: Array
    run: np.ndarray
    run_names: tuple[str, ...]
    movements: list[tuple[int, Movement]]
    joints: trajectories.Trajectories

    @property
    def shared(self) -> bool:
        """Whether all runs have one offset."""
        return self.clock == SHARED

    @property
    def rated(self) -> bool:
        """Whether one clock may run faster than the other."""
        return self.clock != SAME_RATE

    def states_at(self, clock: Clock, *, need_joints: bool = False) -> tuple[Array, np.ndarray]:
        """Return joints and their derivatives (3, N, n_q) at the readings, and where they are known (N,).

        Elsewhere joints are those of the nearest end of a movement of the run, derivatives 0; of rows to be predicted
        (`need_joints`) that is an error.

        Raises
        ------
        InputError
            No joints are known for a row to be predicted.
        """
        when = clock.joint_time(self.time, self.run)
        out = np.zeros((3, len(when), self.joints.joints.shape[1]))
        known, off = np.zeros(len(when), dtype=bool), np.full(len(when), np.inf)
        for run, movement in self.movements:
            own = self.run == run
            inside = own & movement.covers(when)
            away = np.maximum(movement.start - when, when - movement.end)
            nearest = own & ~known & (inside | (away < off))
            if nearest.any():
                out[0, nearest] = movement(np.clip(when[nearest], movement.start, movement.end))
            for order in (1, 2) if inside.any() else ():
                out[order, inside] = movement(when[inside], order)
            off[nearest] = away[nearest]
            known |= inside
        if need_joints and not known.all():
            row = int(np.argmin(known))
            raise ClockMismatch(
                f"at this time, {self.time[row]:g} s on the instrument's clock, no joints are known.",
                f"Record joints over all of run '{self.run_names[self.run[row]]}', or leave the row out.",
                file=self.path,
                line=int(self.line[row]),
                column=TIME,
            )
        return out, known

    def last_before(self, clock: Clock) -> np.ndarray:
        """Return the row of the joints' file (N,) that was the last at each reading, in its run."""
        when, out = clock.joint_time(self.time, self.run), np.zeros(len(self.time), dtype=int)
        for code in range(len(self.run_names)):
            rows, own = np.flatnonzero(self.run == code), np.flatnonzero(self.joints.run == code)
            at = np.searchsorted(self.joints.time[own], when[rows], side="right") - 1
            out[rows] = own[np.clip(at, 0, len(own) - 1)]
        return out

    def simulated(self, said: Mapping[str, float]) -> Clock:
        """Return the clock that a truth names, by the names in `CLOCK`.

        Raises
        ------
        UsageError
            It names a rate where the sidecar says that there is none.
        """
        if said.get(RATE) and not self.rated:
            raise OptionNotApplicable(f"the truth has a {RATE}, and the sidecar says clock = '{self.clock}'.")
        return Clock(np.full(len(self.run_names), said.get(OFFSET, 0.0)), said.get(RATE, 0.0))

    def known_clock(self, told: Iterable[Parameter]) -> Clock:
        """Return where the clocks stand as the parameters of a result, or else the sidecar, say.

        Raises
        ------
        InputError
            Neither says it of a run.
        """
        offsets, rate = dict[str | None, float](), 0.0
        for p in told:
            if p.name == RATE:
                rate = p.value
            elif p.name == OFFSET:
                offsets[p.run] = p.value
        found = np.empty(len(self.run_names))
        for k, run in enumerate(self.run_names):
            value = offsets.get(None, offsets.get(run, self.offset))
            if value is None:
                raise ClockMismatch(
                    f"where the instrument's clock stands in run '{run}' is not known: the result does not know that "
                    "run.",
                    "Say clock_offset_s under [measurement]: t_joints = t_instrument + clock_offset_s + clock_rate "
                    "t_instrument.",
                    file=self.path,
                )
            found[k] = value
        return Clock(found, rate)


@dataclass(frozen=True, eq=False)
class TwoClocks(Clocked):
    """Readings pose by pose; see `Clocked`.

    Attributes
    ----------
    recording : Recording
        The readings; its joints mean nothing until a clock is known.
    spacing : float
        Of the splines' knots [s].
    removed : float
        Part of the joints' signal that the low-pass takes away.
    """

    recording: Recording
    spacing: float
    removed: float

    @property
    def text(self) -> str:
        """What was done to the joints, in words."""
        return splines.what_was_done("joints", self.spacing)

    def at(self, clock: Clock, *, need_joints: bool = False) -> Recording:
        """Return the readings with the joints and their channels as they were then.

        A reading at which no joints are known is left out (blank); of rows to be predicted (`need_joints`) that is an
        error; see `states_at`.
        """
        (q, *rates), known = self.states_at(clock, need_joints=need_joints)
        measured = np.where(known[:, None], self.recording.measured, np.nan)
        unit, count = self.recording.joint_unit, q.shape[1]
        factors = np.array(joint_factors(unit, count))
        made = {pattern: rate / factors for pattern, rate in zip((SPEEDS, ACCELERATIONS), rates, strict=True)}
        channels = {
            n: column for p, v in made.items() for n, column in zip(joint_names(unit, count, p), v.T, strict=True)
        }
        channels |= self._channels(clock) | {"run": self.run.astype(float)} | self.recording.channels
        return dataclasses.replace(self.recording, joints=q, measured=measured, channels=channels)

    def _channels(self, clock: Clock) -> dict[str, Array]:
        """Return what was recorded beside the joints, and the way they came, as it last was at the readings."""
        given, last = self.joints, self.last_before(clock)
        unit, count = given.joint_unit, given.joints.shape[1]
        least = REVERSED * np.ptp(given.joints, axis=0)
        way = np.zeros(given.joints.shape)
        for code in range(len(given.run_names)):
            own = given.run == code
            for j in range(count):
                way[own, j] = approach(given.joints[own, j], float(least[j]))
        known = dict(given.channels) | dict(zip(joint_names(unit, count, APPROACH), way.T, strict=True))
        return {name: values[last] for name, values in known.items()}


@dataclass(frozen=True, eq=False)
class DriveClocks(Clocked):
    """What drives give, and joints on another clock; see `Clocked`.

    Attributes
    ----------
    readings : Trajectories
        Its joints mean nothing until a clock is known.
    motion : Motion
        The joints with their derivatives, on their own clock.
    """

    readings: trajectories.Trajectories
    motion: trajectories.Motion

    def at(self, clock: Clock, *, need_joints: bool = False) -> trajectories.Trajectories:
        """Return the readings with the joints, their derivatives and channels as they were then; see `states_at`.

        Readings at which no joints are known, or hardly, take part in no fit.
        """
        states, known = self.states_at(clock, need_joints=need_joints)
        last, given = self.last_before(clock), self.joints
        moved = dataclasses.replace(self.motion, states=states, loose=self.motion.loose[last] | ~known)
        beside = {name: values[last] for name, values in given.channels.items()}
        return dataclasses.replace(
            self.readings,
            joints=states[0],
            channels=beside | dict(self.readings.channels),
            setups=self.readings.setups or tuple(given.setups[k] for k in last if given.setups),
            moved=moved,
            joints_path=given.path,
        )


@dataclass(frozen=True, eq=False)
class _Known(Movement):
    """A movement through samples of which the derivatives are known: each has a spline of its own."""

    rates: tuple[BSpline, ...]

    def __call__(self, time: Array, order: int = 0) -> Array:
        return np.asarray(self.rates[order - 1](time)) if order else super().__call__(time)


def two_clocks(path: Path, machine: Machine, *, need_measured: bool = True, **how: Any) -> TwoClocks | None:
    """Read a recording whose sidecar says that it has two clocks; None of any other.

    Raises
    ------
    InputError
        A file cannot be used, or runs of one are not in the other.
    """
    sidecar = read_sidecar(path)
    said = measurement_of(sidecar)
    if said.clock is None:
        return None
    kind = said.kind or "position"
    motion_of = trajectories.Sidecar.model_validate({"measurement": {"kind": kind}})
    joints, readings, time, run = _both(path, machine, motion_of)
    samples = Samples(joints.joints, joints.time, joints.piece)
    units = of_joints(joints.joint_unit, joints.joints.shape[1])
    spacing = splines.chosen_spacing(samples, 2, units)
    recording = recording_of_rows(readings.without({"run"}), sidecar, machine, need_measured=need_measured, **how)
    return TwoClocks(
        clock=said.clock,
        offset=said.clock_offset_s,
        path=recording.path,
        line=recording.line,
        recording=recording,
        time=time,
        run=run,
        run_names=joints.run_names,
        movements=_by_run(joints, splines.paths(samples, spacing)),
        joints=joints,
        spacing=spacing,
        removed=splines.removed(samples, splines.smooth(samples, spacing, 0)[0], units),
    )


def drive_clocks(
    path: Path, machine: Machine, sidecar: trajectories.Sidecar, *, need_measured: bool, cutoff: float | None = None
) -> DriveClocks:
    """Read a recording of what drives give whose sidecar says that it has two clocks.

    Parameters
    ----------
    cutoff : float, optional
        Of the joints' low-pass [Hz], where it is known already.

    Raises
    ------
    InputError
        A file cannot be used, or runs of one are not in the other.
    """
    said = sidecar.measurement
    assert said.clock is not None
    joints, table, *_ = _both(path, machine, sidecar)
    bare = sidecar.model_copy(update={"motion": trajectories.Sidecar(measurement=said).motion})
    own = trajectories.trajectories(table, machine, bare, need_measured=need_measured)
    found = motion(joints, cutoff)
    repaired = sorted({*joints.repaired, *own.repaired})
    readings = dataclasses.replace(own, said=sidecar, repairs=(*joints.repairs, *own.repairs), repaired=tuple(repaired))
    return DriveClocks(
        clock=said.clock,
        offset=said.clock_offset_s,
        path=own.path,
        line=own.line,
        time=own.time,
        run=np.array([joints.run_names.index(own.run_names[code]) for code in own.run]),
        run_names=joints.run_names,
        movements=_by_run(joints, _known(joints, found)),
        joints=joints,
        readings=readings,
        motion=found,
    )


def _both(
    path: Path, machine: Machine, sidecar: trajectories.Sidecar
) -> tuple[trajectories.Trajectories, Rows, Array, np.ndarray]:
    """Return the joints of a recording, the table of its readings, and time (N,) [s] and run (N,) of these."""
    rows = read_table(path)
    joints = trajectories.trajectories(rows, machine, sidecar, need_measured=False)
    if not (beside := instrument_path(path)).exists():
        raise ClockMismatch(
            f"the sidecar says that the instrument has a clock of its own, and there is no {beside.name}.",
            f"Put the readings there, with time_s; {path.name} holds the joints.",
            file=path.with_suffix(".toml"),
        )
    readings = read_table(beside)
    readings.require(TIME)
    time = readings.numbers(TIME, blank=False)[:, 0]
    labels = readings.labels("run", blank=False) or [joints.run_names[0]] * len(time)
    if "run" in rows.columns and "run" not in readings.columns and len(joints.run_names) > 1:
        raise readings.error(
            "the joints have several runs, and these readings none.", "Add the column run.", family=ClockMismatch
        )
    strange = next((k for k, label in enumerate(labels) if label not in joints.run_names), None)
    if strange is not None:
        raise readings.error(
            f"{path.name} has no run '{labels[strange]}'.",
            "Give its joints.",
            row=strange,
            column="run",
            family=ClockMismatch,
        )
    run = np.array([joints.run_names.index(label) for label in labels])
    return joints, _with_joints(readings, joints), time, run


def _by_run(joints: trajectories.Trajectories, each: Iterable[Movement | None]) -> list[tuple[int, Movement]]:
    """Return the movements that are long enough, each with its run."""
    pieces = Samples(joints.joints, joints.time, joints.piece).pieces
    return [(int(joints.run[own[0]]), p) for own, p in zip(pieces, each, strict=True) if p is not None]


def _known(joints: trajectories.Trajectories, found: trajectories.Motion) -> Iterator[_Known | None]:
    """Yield each movement of joints whose derivatives are known at its samples; None of one that is too short."""
    from scipy.interpolate import make_interp_spline

    for own in Samples(joints.joints, joints.time, joints.piece).pieces:
        time, states = joints.time[own], found.states[:, own]
        if len(own) <= CUBIC or not np.isfinite(states).all():
            yield None
        else:
            place, *rates = (make_interp_spline(time, each, CUBIC) for each in states)
            yield _Known(time[0], time[-1], (place,), tuple(rates))


def _with_joints(readings: Rows, joints: trajectories.Trajectories) -> Rows:
    """Return the table of readings with columns of joints, so that it reads as a recording: at rest.

    Which joints belong to a reading is not known before the clocks are.
    """
    count = joints.joints.shape[1]
    first = joints.joints[0] / joint_factors(joints.joint_unit, count)
    names = joint_names(joints.joint_unit, count)
    columns = {name: [repr(float(at))] * len(readings.line) for name, at in zip(names, first, strict=True)}
    own = readings.without(set(names)).columns
    return dataclasses.replace(readings, columns=own | columns)
