"""What a kind of measurement is: one frozen object that everything else asks.

Its formulas are derived (``derive/measurements/KIND.py``): reading, derivatives, the instrument's state after a step,
and with them the names of columns and unknowns. `Kind` makes of them all that a reading of one row in a column of its
own needs, so that such a kind is that one file. A kind that is more than that (a frame to be aligned, readings between
two rows, a camera) says what differs in ``instrument/kinds/KIND.py``. Nobody else compares names of kinds.

A kind, the instruments that read so and what they read each know the other two: they are one module.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import InconsistentResult, NoReadings
from deltacal_gen.instrument.facts import Facts
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.machine.values import Measurement, Recording, Robot
from deltacal_gen.units import DEG, file_unit

if TYPE_CHECKING:
    from deltacal_gen.results.parts import InstrumentState
    from deltacal_gen.results.result import TouchedPoint

STARTS = 20  # steps of the instrument alone, from where its file lets it stand
TURN_MM = 100.0  # at which a measured turn of 1 rad counts as a shift: what 6D trackers read, 0.01 mm beside 0.006 deg
STARTED = 1e-12  # of a step's square: smaller ones change nothing
ROTATES = 1e-6  # by which products of a rotation's rows, written to a file, are off those of unit vectors
ALL = (0, 1, 2, 3, 4, 5)  # coordinates of a body: position, rotation

Frame = tuple[Array, Array]  # rotation vector [rad] and origin [mm] of {O} in the instrument's frame


@dataclass(frozen=True, eq=False)
class Readings:
    """What was measured, reading by reading; a reading belongs to one row of the recording, a distance to two.

    Attributes
    ----------
    kind : Kind
        As the recording says, or what several kinds read together.
    rows : (R, 1) or (R, 2) int array
        Rows of the recording; among readings of several kinds, one of a single row names it twice.
    values : (R, k) array
        Lengths [mm], or as the kind says [rad, px]. NaN along an axis that the machine does not have and, among
        readings of several kinds, in the columns of the others.
    rotations : (R, 3, 3) array or None
        Measured rotations; NaN where only the position was read.
    setup : (R,) int array
        Set-up of the instrument; of contacts, the point that is touched.
    group : (R,) int array
        Readings of one group stay together when readings are held out: repeats of a pose, of a pair of poses.
    line : (R,) int array
        Line in the file.
    made : bool
        Distances made of measured positions, which share their noise.
    following : int
        So many more follow from these, and were left out.
    known : (R, k) array or None
        What the recording tells of each reading beside what was read: where on a board its point lies [mm].
    components : tuple of int
        Which coordinates of a body (position, rotation) a position or pose holds: in the plane, not all.
    """

    kind: Kind
    rows: np.ndarray
    values: Array
    rotations: Array | None
    setup: np.ndarray
    group: np.ndarray
    line: np.ndarray
    made: bool = False
    following: int = 0
    known: Array | None = None
    components: tuple[int, ...] = ALL

    def __len__(self) -> int:
        return len(self.values)

    @property
    def n_scalars(self) -> int:
        """Number of independent scalar readings: distances made of positions hold no more than those."""
        if self.made:
            return min(len(self.values), 3 * len(self.used) - 6)
        turns = sum(c >= 3 for c in self.components)
        turned = 0 if self.rotations is None else turns * int(np.isfinite(self.rotations[:, 0, 0]).sum())
        return int(np.isfinite(self.values).sum()) + turned

    @cached_property
    def used(self) -> np.ndarray:
        """Rows of the recording to which readings belong, in their order."""
        return np.flatnonzero(np.bincount(self.rows.ravel()))

    def ends(self, values: Array) -> tuple[Array, ...]:
        """Return what holds at each end of the readings (R, ...) of values (N, ...) of all rows; in order no copy."""
        every = np.arange(len(values))
        return tuple(values if np.array_equal(rows, every) else values[rows] for rows in self.rows.T)

    def subset(self, chosen: np.ndarray) -> Readings:
        """Return the readings of an index or mask."""
        return dataclasses.replace(
            self,
            rows=self.rows[chosen],
            values=self.values[chosen],
            rotations=None if self.rotations is None else self.rotations[chosen],
            setup=self.setup[chosen],
            group=self.group[chosen],
            line=self.line[chosen],
            known=None if self.known is None else self.known[chosen],
        )

    def some(self, recording: Recording) -> Readings:
        """Return the readings; raise an InputError where there are none."""
        if len(self) == 0:
            raise NoReadings(
                "every measured cell is blank, so there is nothing to fit.",
                "Fill the measured columns, or use predict to compute them.",
                file=recording.path,
            )
        return self


@dataclass(frozen=True, eq=False)
class Instrument:
    """State of the instrument: one row of `state` per set-up, in the order of the generated `given`.

    Attributes
    ----------
    kind : Kind
    state : (S, g) array
    free : tuple of int
        Which unknowns of the kind are estimated; none of them in a frame that is known.
    scale : float
        What one unit of the reading is at the platform [mm]: of images, a pixel at the ball's distance. Residuals and
        derivatives come multiplied by it, but those of lengths; see `at_platform`.
    home : tuple of float
        From where positions count [mm], in {O}.
    ties : tuple of (int, int, float)
        Known distances [mm] between the points of two rows of the state: they leave so many unknowns fewer.
    """

    kind: Kind
    state: Array
    free: tuple[int, ...]
    scale: float = 1.0
    home: tuple[float, float, float] = (0.0, 0.0, 0.0)
    ties: tuple[tuple[int, int, float], ...] = ()

    @property
    def n_unknown(self) -> int:
        """Number of unknowns, all set-ups together."""
        return len(self.free) * len(self.state) - len(self.ties)

    @property
    def unknown(self) -> tuple[tuple[str, str], ...]:
        """Name and unit of each unknown, set-up by set-up."""
        named = [self.kind.unknown[j] for j in self.free]
        several = len(self.state) > 1 or self.kind.stays
        return tuple(
            (f"{name}_{s + 1}" if several else name, self.kind.unit_of(unit, row))
            for s, row in enumerate(self.state)
            for name, unit in named
        )

    @cached_property
    def at_platform(self) -> Array:
        """What one unit of each column of a residual (k,) is at the platform [mm]; of rotations 1."""
        return self.kind.at_platform(self.scale)

    def ends(self, found: Readings, x: Array) -> tuple[Array, ...]:
        """Return what readings belong to, one array per end: poses (R, 12), positions counted from the home.

        Of readings of joints, how far the joint has moved (R, 1).
        """
        if any(self.home):
            x = np.hstack([x[:, :3] - self.home, x[:, 3:]])
        ends = found.ends(x)
        return self.kind.looked_at(found, ends)

    def given(self, found: Readings) -> Array:
        """Return what the kernels are given of each reading (R, g): the instrument's state, and what is known of it."""
        state = self.state[found.setup]
        return state if found.known is None else np.hstack([state, found.known])

    def predict(self, found: Readings, x: Array) -> tuple[Array, Array | None]:
        """Return predicted values (R, k) and, where rotations are read, these (R, 3, 3), at platforms x (N, 12)."""
        return self.kind.predict(self, found, x)

    def residual(self, found: Readings, x: Array) -> Array:
        """Return measured minus predicted, (R, k): mm, and the rotation vector between the rotations in rad."""
        values, rotations = self.predict(found, x)
        r = self.at_platform[: values.shape[1]] * (found.values - values)
        if rotations is None or found.rotations is None:
            return r
        turned = np.full((len(found), 3), np.nan)
        read = np.isfinite(found.rotations[:, 0, 0])
        gap = found.rotations[read] @ np.swapaxes(rotations[read], 1, 2)
        turned[read] = to_vector(gap)
        turned[:, [c - 3 for c in range(3, 6) if c not in found.components]] = np.nan
        return np.hstack([r, turned])

    def by_unknown(self, found: Readings, x: Array, chosen: Sequence[int]) -> Array:
        """Return the derivatives (R, k, chosen) of the readings by unknowns of the kind, free or not."""
        by_unknown: Array = self.kind.kernels.by_unknown(*self.ends(found, x), self.given(found))
        derivatives = self.at_platform[:, None] * by_unknown
        return derivatives[:, :, list(chosen)]

    def linearise(self, found: Readings, x: Array, dx: Array) -> tuple[Array, Array]:
        """Return the derivatives of the readings by parameters and by the instrument's unknowns.

        Parameters
        ----------
        dx : (N, 6, n) array
            Derivatives of the platform coordinates by n parameters; (N, n_q, n) of joints, where these are read.

        Returns
        -------
        J_p : (R, k, n) array
        J_m : (R, k, n_unknown) array
        """
        J_p = self.kind.by_platform(self, found, x, dx)
        J_m = np.zeros((*J_p.shape[:2], len(self.state), len(self.free)))
        if self.free:
            J_m[np.arange(len(found)), :, found.setup] = self.by_unknown(found, x, self.free)
        J_m = J_m.reshape(*J_p.shape[:2], -1)
        return J_p, J_m @ self.kind.loose(self) if self.ties else J_m

    def add_carried(self, J: Array, mechanism: Machine, names: Sequence[str], found: Readings, x: Array) -> None:
        """Add to derivatives (R, k, n) by source errors `names` what those of the instrument's own mount do."""
        own = {
            u: names.index(name)
            for u, p in self.kind.carried(mechanism).items()
            if (name := mechanism.parameters[p].name) in names
        }
        if own:
            J[:, :, list(own.values())] += self.by_unknown(found, x, tuple(own))

    def mounted(self, mechanism: Machine, parameters: Array) -> Instrument:
        """Return the instrument where the machine's own parameters put it: (n_p,), or (S, n_p) by set-up."""
        own = self.kind.carried(mechanism)
        if not own:
            return self
        step = np.zeros((len(self.state), len(self.kind.unknown)))
        step[:, list(own)] = parameters[..., list(own.values())]
        return dataclasses.replace(self, state=self.kind.kernels.stepped(self.state, step))

    def stepped(self, increment: Array) -> Instrument:
        """Return the instrument after an increment (n_unknown,) of its unknowns."""
        if not self.n_unknown:
            return self
        if self.ties:
            increment = self.kind.loose(self) @ increment
        step = np.zeros((len(self.state), len(self.kind.unknown)))
        step[:, list(self.free)] = np.asarray(increment).reshape(len(self.state), -1)
        moved = dataclasses.replace(self, state=self.kind.kernels.stepped(self.state, step))
        return self.kind.tied(moved) if self.ties else moved

    def of_points(self) -> Instrument | None:
        """Return the instrument as it reads positions alone; None where it reads none."""
        return self.kind.of_points(self)

    def check_state(self) -> None:
        """Raise InconsistentResult where the state is none of this kind, or what is to be a rotation in it is none."""
        units, at = [unit for _, unit in self.kind.unknown], 0
        right = self.state.shape[1] == self.kind.state_size
        while right and units:
            step, size = (3, 9) if units[:3] == ["rad"] * 3 else (1, 1)  # a matrix stands where three turns are unknown
            turns = self.state[:, at : at + 9].reshape(-1, 3, 3) if size == 9 else np.zeros((0, 3, 3))
            square = np.abs(turns @ turns.mT - np.eye(3)).max(axis=(1, 2), initial=0.0) < ROTATES
            right = bool((square & (np.linalg.det(turns) > 0)).all())
            units, at = units[step:], at + size
        if not right:
            raise InconsistentResult(
                f"'instrument.state' is no state of a {self.kind.words}: a frame in it is mirrored or no rotation.",
                "Give the file as it was written, or identify again.",
            )

    def frames(self) -> list[tuple[Array, Array]]:
        """Return per set-up the rotation vector [rad] and the origin [mm] of {O} in the instrument's frame."""
        return self.kind.frames(self)

    @property
    def reported(self) -> dict[str, str]:
        """Unknowns that answers give by name, free or not, and their units in files."""
        each = dataclasses.replace(self, free=tuple(range(len(self.kind.unknown))))
        units = (("px" if name.endswith("_px") else file_unit(unit)) for name, unit in each.unknown)
        kinds = [self.kind.unknown[j][0] for _ in self.state for j in each.free]
        named = zip(each.unknown, units, kinds, strict=True)
        return {name: unit for (name, _), unit, own in named if own in self.kind.reported}

    def unit(self, columns: Sequence[str]) -> tuple[str, float] | None:
        """Return the unit of readings in columns of a file and what it is at the platform [mm]; None of lengths."""
        name = self.kind.unit_in(columns)
        return None if name == "mm" else (name, self.scale * (DEG if name == "deg" else 1.0))

    def kept(self, setups: Sequence[str], zero: str, columns: Sequence[str] = ()) -> InstrumentState:
        """Return what an answer keeps of it, and of the recording that it was found by; see `kinds.instrument_of`."""
        from deltacal_gen.results.parts import InstrumentState

        return InstrumentState(
            kind=self.kind.name,
            state=self.state,
            free=self.free,
            scale=self.scale,
            home=self.home,
            ties=self.ties,
            setups=tuple(setups),
            zero=zero,
            columns=tuple(columns) if len(columns) == 1 < self.kind.width else None,
        )


@dataclass(frozen=True)
class Kind(Facts):
    """A kind of measurement with what it does: readings of a recording, an instrument that fits them, predictions."""

    # ------------------------------------------------------------------------------------------------------- readings

    def readings(self, recording: Recording, pose: np.ndarray) -> Readings:
        """Return the readings of a recording, blank ones left out; `pose` (N,) says which rows are repeats."""
        taken = np.flatnonzero(np.isfinite(recording.measured).all(axis=1))
        return Readings(
            self,
            taken[:, None],
            recording.measured[taken],
            None,
            self._setups(recording)[taken],
            pose[taken],
            recording.line[taken],
            known=self._known(recording, taken),
        )

    def unread(self, recording: Recording) -> Readings:
        """Return the readings that would be taken: every row, or every pair; values are zero.

        Raises
        ------
        InputError
            Nothing could be taken.
        """
        every = np.arange(recording.n_rows)
        return Readings(
            self,
            every[:, None],
            np.zeros((len(every), self.width)),
            None,
            self._setups(recording),
            every,
            every,
            known=self._known(recording, every),
            components=recording.components or ALL,
        )

    def _known(self, recording: Recording, rows: np.ndarray) -> Array | None:
        """Return what a recording tells of the readings of some rows beside what was read."""
        return np.column_stack([recording.channels[name][rows] for name in self.known]) if self.known else None

    def with_values(self, recording: Recording, found: Readings, values: Array, rotations: Array | None) -> Recording:
        """Return the recording whose measured cells hold values (R, k) and rotations of all that `unread` lists."""
        if rotations is not None:
            values = np.hstack([values, to_vector(rotations)])
        measured = np.full((recording.n_rows, values.shape[1]), np.nan)
        measured[found.rows[:, 0]] = values
        return dataclasses.replace(recording, measured=measured)

    def as_distances(self, found: Readings, recording: Recording) -> Readings:
        """Return the distances between the points that were read; the readings themselves where none were."""
        return found

    def _setups(self, recording: Recording) -> np.ndarray:
        """Return the set-up (N,) of each row; one for all where nothing of the instrument is unknown."""
        return recording.setup if self.unknown else np.zeros(recording.n_rows, dtype=int)

    # ------------------------------------------------------------------------------------------------- the instrument

    def predict(self, instrument: Instrument, found: Readings, x: Array) -> tuple[Array, Array | None]:
        """Return predicted values (R, k) and rotations (R, 3, 3), if any; see `Instrument.predict`."""
        ends, given = instrument.ends(found, x), instrument.given(found)
        values: Array = self.kernels.reading(*ends, given)
        return values, self.kernels.rotation(*ends, given) if self.rotations else None

    def by_platform(self, instrument: Instrument, found: Readings, x: Array, dx: Array) -> Array:
        """Return the derivatives (R, k, n) of the readings where platforms move by `dx` (N, 6, n)."""
        by_platform = self.kernels.by_platform(*instrument.ends(found, x), instrument.given(found))
        by_platform = instrument.at_platform[:, None, None] * by_platform
        parts = (by_platform[:, :, e] @ moved for e, moved in enumerate(found.ends(dx)))
        J: Array = next(parts)
        for part in parts:
            J += part
        return J

    def looked_at(self, found: Readings, ends: tuple[Array, ...]) -> tuple[Array, ...]:
        """Return what readings are of, of all that stands in the rows of their ends."""
        return ends

    def loose(self, instrument: Instrument) -> Array:
        """Return the directions (unknowns, n_unknown) of the unknowns that keep the instrument's ties."""
        return np.eye(instrument.n_unknown)

    def tied(self, instrument: Instrument) -> Instrument:
        """Return the instrument moved, as little as need be, until its ties hold."""
        return instrument

    def of_points(self, instrument: Instrument) -> Instrument | None:
        """Return the instrument as it reads positions alone; None where it reads none."""
        return None

    def frames(self, instrument: Instrument) -> list[Frame]:
        """Return where {O} stands in the instrument's frame, set-up by set-up; empty where it has none."""
        return []

    def points(self, instrument: Instrument, recording: Recording) -> tuple[TouchedPoint, ...]:
        """Return fixed points that the readings have found, by name, in {O}; empty where there are none."""
        return ()

    def first(self) -> Instrument:
        """Return the instrument in the state that its file gives, all its unknowns free."""
        state = np.array(self.kernels.START if self.unknown else (), dtype=float)
        return Instrument(self, state[None], tuple(range(len(self.unknown))), self.scale)

    def standing(self, recording: Recording) -> Instrument:
        """Return the instrument as its file lets it stand before anything is known of it, all its unknowns free.

        In a frame that is said to be known, none is.
        """
        setups = int(self._setups(recording).max(initial=0)) + 1
        at = self.first()
        known = recording.measurement.frame == "robot"
        return dataclasses.replace(at, state=np.tile(at.state, (setups, 1)), free=() if known else at.free)

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the instrument in its first state, from the poses x (N, 12) of the machine as known so far.

        From where its file lets it stand, steps of Gauss-Newton on the instrument alone.
        """
        instrument = self.standing(recording)
        for _ in range(STARTS if instrument.n_unknown else 0):
            r = instrument.residual(found, x)
            _, J = instrument.linearise(found, x, np.zeros((len(x), 6, 0)))
            read = np.isfinite(r)
            step = np.asarray(np.linalg.lstsq(J[read], r[read], rcond=None)[0], dtype=float)
            instrument = instrument.stepped(step)
            if step @ step <= STARTED:
                break
        return instrument

    def drawn(
        self, recording: Recording, robot: Robot, x: Array, frame: Frame | None, rng: np.random.Generator | None
    ) -> Instrument:
        """Return the instrument that reads in a simulation of poses x (N, 12).

        It stands in the robot's frame, in the one given, or, with `rng`, as it was mounted: off by ordinary errors.
        """
        instrument = self.standing(recording)
        if rng is not None:
            count = len(instrument.state), len(instrument.free)
            off = self.typical[list(instrument.free)] * rng.standard_normal(count)
            instrument = instrument.stepped(off.reshape(-1))
        return dataclasses.replace(instrument, free=())

    def own(self, found: Readings, recording: Recording, robot: Robot, poses: Callable[[], Array]) -> Instrument | None:
        """Return the instrument of another recording that asks nothing of a result; None where it does.

        `poses` solves the machine at the recording's rows.
        """
        known = not self.unknown or recording.measurement.frame == "robot"
        return self.start(found, recording, robot, poses()) if known else None

    def like(self, instrument: Instrument, recording: Recording) -> Instrument | None:
        """Return a result's instrument as one of this kind for another recording; None where it cannot be."""
        return instrument if instrument.kind == self else None

    # ------------------------------------------------------------------------------------------------------- examined

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return the readings that an instrument would take at poses, and the instrument with its unknowns free.

        Parameters
        ----------
        x : (N, 12) array
            In `sets` blocks of equal size, one per reference point.
        said : Measurement
            What a sidecar would say.
        """
        return self.taken(np.arange(len(x))[:, None]), self.first()

    def taken(self, rows: np.ndarray, setup: np.ndarray | None = None, values: Array | None = None) -> Readings:
        """Return readings at rows (R, 1) or (R, 2), each a pose of its own; values (R, k) are zero unless given."""
        zeros, every = np.zeros(len(rows), dtype=int), np.arange(len(rows))
        values = np.zeros((len(rows), self.width)) if values is None else values
        return Readings(self, rows, values, None, zeros if setup is None else setup, every, zeros)
