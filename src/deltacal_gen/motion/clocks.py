"""Two clocks: joints in NAME.csv on one, readings in NAME.instrument.csv on another.

t_joints = t_instrument + offset of the run + rate t_instrument. Joints are splines in time, so that they are known at
whatever time a reading turns out to belong to.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.columns import instrument_path
from deltacal_gen.files.recording import recording_of_rows
from deltacal_gen.files.rows import Rows, read_table
from deltacal_gen.files.sidecar import read_sidecar
from deltacal_gen.motion import trajectories
from deltacal_gen.motion.derivatives import removed, what_was_done
from deltacal_gen.physics import splines
from deltacal_gen.physics.motion import REVERSED, approach
from deltacal_gen.physics.splines import Path as Movement
from deltacal_gen.physics.splines import Samples
from deltacal_gen.states import ACCELERATIONS, APPROACH, SPEEDS, TIME
from deltacal_gen.units import joint_factors, joint_names, of_joints

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array, Machine
    from deltacal_gen.machine.values import Recording

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
class TwoClocks:
    """Readings and joints, each with its own time.

    Attributes
    ----------
    clock : str
        What the sidecar says of the clocks.
    offset : float or None
        Offset that the sidecar says [s].
    recording : Recording
        The readings; its joints mean nothing until a clock is known.
    time, run : (N,) arrays
        Of the readings [s]; run by index into `run_names`.
    movements : list of (int, Path)
        Joints as splines, with the run that each belongs to.
    joints : Trajectories
    spacing : float
        Of the splines' knots [s].
    removed : float
        Part of the joints' signal that the low-pass takes away.
    """

    clock: str
    offset: float | None
    recording: Recording
    time: Array
    run: np.ndarray
    run_names: tuple[str, ...]
    movements: list[tuple[int, Movement]]
    joints: trajectories.Trajectories
    spacing: float
    removed: float

    @property
    def shared(self) -> bool:
        """Whether all runs have one offset."""
        return self.clock == SHARED

    @property
    def rated(self) -> bool:
        """Whether one clock may run faster than the other."""
        return self.clock != SAME_RATE

    @property
    def text(self) -> str:
        """What was done to the joints, in words."""
        return what_was_done("joints", self.spacing)

    def at(self, clock: Clock, *, need_joints: bool = False) -> Recording:
        """Return the readings with the joints and their channels as they were then.

        A reading at which no joints are known is left out (blank); of rows to be predicted (`need_joints`) that is an
        error.

        Raises
        ------
        InputError
            No joints are known for a row to be predicted.
        """
        q, known = self._at(clock, 0)
        if need_joints and not known.all():
            row = int(np.argmin(known))
            raise InputError(
                f"at this time, {self.time[row]:g} s on the instrument's clock, no joints are known.",
                f"Record joints over all of run '{self.run_names[self.run[row]]}', or leave the row out.",
                file=self.recording.path,
                line=int(self.recording.line[row]),
                column=TIME,
            )
        measured = np.where(known[:, None], self.recording.measured, np.nan)
        unit, count = self.recording.joint_unit, q.shape[1]
        factors = np.array(joint_factors(unit, count))
        made = {SPEEDS: self._at(clock, 1)[0] / factors, ACCELERATIONS: self._at(clock, 2)[0] / factors}
        channels = {
            n: column for p, v in made.items() for n, column in zip(joint_names(unit, count, p), v.T, strict=True)
        }
        channels |= self._channels(clock) | {"run": self.run.astype(float)} | self.recording.channels
        return dataclasses.replace(self.recording, joints=q, measured=measured, channels=channels)

    def _at(self, clock: Clock, order: int) -> tuple[Array, np.ndarray]:
        """Return joints or a derivative (N, n_q) at the readings, and where they are known (N,).

        Elsewhere joints are those of the nearest end of a movement of the run, derivatives 0.
        """
        when = clock.joint_time(self.time, self.run)
        out = np.zeros((len(when), self.joints.joints.shape[1]))
        known, off = np.zeros(len(when), dtype=bool), np.full(len(when), np.inf)
        for run, movement in self.movements:
            own = self.run == run
            inside = own & movement.covers(when)
            away = np.maximum(movement.start - when, when - movement.end)
            nearest = own & ~known & (inside | (away < off))
            if order == 0 and nearest.any():
                out[nearest] = movement(np.clip(when[nearest], movement.start, movement.end))
            elif inside.any():
                out[inside] = movement(when[inside], order)
            off[nearest] = away[nearest]
            known |= inside
        return out, known

    def _channels(self, clock: Clock) -> dict[str, Array]:
        """Return what was recorded beside the joints, and the way they came, as it last was at the readings."""
        given, when = self.joints, clock.joint_time(self.time, self.run)
        unit, count = given.joint_unit, given.joints.shape[1]
        least = REVERSED * np.ptp(given.joints, axis=0)
        way = np.zeros(given.joints.shape)
        for code in range(len(given.run_names)):
            own = given.run == code
            for j in range(count):
                way[own, j] = approach(given.joints[own, j], float(least[j]))
        known = dict(given.channels) | dict(zip(joint_names(unit, count, APPROACH), way.T, strict=True))
        out = {name: np.full(len(when), np.nan) for name in known}
        for code in range(len(self.run_names)):
            rows, own = np.flatnonzero(self.run == code), np.flatnonzero(given.run == code)
            last = own[np.clip(np.searchsorted(given.time[own], when[rows], side="right") - 1, 0, len(own) - 1)]
            for name, values in known.items():
                out[name][rows] = values[last]
        return out


def two_clocks(path: Path, machine: Machine, *, need_measured: bool = True, **how: Any) -> TwoClocks | None:
    """Read a recording whose sidecar says that it has two clocks; None of any other.

    Raises
    ------
    InputError
        A file cannot be used, or runs of one are not in the other.
    """
    sidecar = read_sidecar(path)
    if (said := sidecar.measurement.clock) is None:
        return None
    rows = read_table(path)
    motion = trajectories.Sidecar.model_validate({"measurement": {"kind": sidecar.measurement.kind or "position"}})
    joints = trajectories.trajectories(rows, machine, motion, need_measured=False)
    if not (beside := instrument_path(path)).exists():
        raise InputError(
            f"the sidecar says that the instrument has a clock of its own, and there is no {beside.name}.",
            f"Put the readings there, with time_s; {path.name} holds the joints.",
            file=path.with_suffix(".toml"),
        )
    readings = read_table(beside)
    readings.require(TIME)
    time = readings.numbers(TIME, blank=False)[:, 0]
    labels = readings.labels("run", blank=False) or [joints.run_names[0]] * len(time)
    if "run" in rows.columns and "run" not in readings.columns and len(joints.run_names) > 1:
        raise readings.error("the joints have several runs, and these readings none.", "Add the column run.")
    strange = next((k for k, label in enumerate(labels) if label not in joints.run_names), None)
    if strange is not None:
        raise readings.error(
            f"{path.name} has no run '{labels[strange]}'.", "Give its joints.", row=strange, column="run"
        )
    samples = Samples(joints.joints, joints.time, joints.piece)
    units = of_joints(joints.joint_unit, joints.joints.shape[1])
    spacing = splines.chosen_spacing(samples, 2, units)
    of_piece = [int(joints.run[own[0]]) for own in samples.pieces]
    movements = [(r, p) for r, p in zip(of_piece, splines.paths(samples, spacing), strict=True) if p is not None]
    return TwoClocks(
        clock=said,
        offset=sidecar.measurement.clock_offset_s,
        recording=recording_of_rows(
            _with_joints(readings, joints), sidecar, machine, need_measured=need_measured, **how
        ),
        time=time,
        run=np.array([joints.run_names.index(label) for label in labels]),
        run_names=joints.run_names,
        movements=movements,
        joints=joints,
        spacing=spacing,
        removed=removed(samples, splines.smooth(samples, spacing, 0)[0], units),
    )


def _with_joints(readings: Rows, joints: trajectories.Trajectories) -> Rows:
    """Return the table of readings with columns of joints, so that it reads as a recording: at rest.

    Which joints belong to a reading is not known before the clocks are.
    """
    count = joints.joints.shape[1]
    first = joints.joints[0] / joint_factors(joints.joint_unit, count)
    names = joint_names(joints.joint_unit, count)
    columns = {name: [repr(float(at))] * len(readings.line) for name, at in zip(names, first, strict=True)}
    own = readings.without({*names, "run"}).columns
    return dataclasses.replace(readings, columns=own | columns)
