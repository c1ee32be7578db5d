"""What a kind of measurement is: one frozen object that everything else asks.

Its formulas are derived (``derive/measurements/KIND.py``): reading, derivatives, the instrument's state after a step,
and with them the names of columns and unknowns. `Kind` makes of them all that a reading of one row in a column of its
own needs, so that such a kind is that one file. A kind that is more than that (a frame to be aligned, readings between
two rows, a camera) says what differs in ``instrument/kinds/KIND.py``. Nobody else compares names of kinds.
"""

from __future__ import annotations

import dataclasses
import importlib
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import ClassVar

import numpy as np

from deltacal_gen.instrument.instrument import Instrument
from deltacal_gen.instrument.readings import ALL, Readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.machine.values import Measurement, Recording, Robot
from deltacal_gen.results.result import TouchedPoint

STARTS = 20  # steps of the instrument alone, from where its file lets it stand
TURN_MM = 100.0  # at which a measured turn of 1 rad counts as a shift: what 6D trackers read, 0.01 mm beside 0.006 deg
STARTED = 1e-12  # of a step's square: smaller ones change nothing

Frame = tuple[Array, Array]  # rotation vector [rad] and origin [mm] of {O} in the instrument's frame


@dataclass(frozen=True)
class Look:
    """Readings of a kind by which a machine's models are examined.

    Attributes
    ----------
    words : str
        What is read.
    points : int
        Reference points on the platform.
    motions : str
        What they leave open of the machine's place, as the derivation calls it; "" where it has no name for it.
    frame : {"unknown", "robot"}
    touches : bool
        Whether poses are looked at that bring the machine to the same fixed points.
    """

    words: str
    points: int = 1
    motions: str = ""
    frame: str = "unknown"
    touches: bool = False


@dataclass(frozen=True)
class Kind:
    """A kind of measurement: what of it stands in files, what is unknown of its instrument, what it can tell.

    Attributes
    ----------
    name : str
        As recordings and results call it; also of the generated module, unless `formulas` names another.
    positions : bool
        Whether the first values are coordinates of the measured point in a frame of the instrument.
    rotations : bool
        Whether rotations are read too; their noise is another than that of lengths.
    in_blocks : bool
        Whether a recording can be identified block by block: each row for itself, one noise.
    anew : bool
        Whether what is unknown of the instrument is unknown in every session, and found by its readings together.
    stays : bool
        Whether the instrument is part of the machine, so that set-ups make no difference.
    apart : bool
        Whether each column is a reading of its own, of which some may be blank, or not be there.
    in_motion : bool
        Whether rows may be samples of a motion, which tells how joints came and how fast; whole runs are then held out.
    follows : bool
        Whether the instrument's unknowns follow the machine along arcs, so that they are fitted again after each step.
    picked : bool
        Whether readings are points found in images one by one, some of them wrongly.
    probed : bool
        Whether a machine's own firmware takes such readings: a few, of roughly known noise.
    usual_noise : float
        [mm] of ordinary instruments, by which a few readings are guarded beside those of another kind.
    second_point, more_poses, position_beside, rotation_beside, distances_beside : bool
        Which further measurements are worth considering: of a second reference point, of one more pose, of the
        position itself, of the platform's rotation, of distances on a printed object.
    whereabouts : str
        What is unknown of the instrument's place, in words: it takes up what machine and instrument do alike.
    """

    name: str

    formulas: ClassVar[str] = ""
    whereabouts: ClassVar[str] = "where the instrument stands"
    aliases: ClassVar[tuple[str, ...]] = ()  # what sidecars may call it too
    positions: ClassVar[bool] = False
    in_blocks: ClassVar[bool] = False
    anew: ClassVar[bool] = False
    stays: ClassVar[bool] = False
    apart: ClassVar[bool] = False
    in_motion: ClassVar[bool] = False
    follows: ClassVar[bool] = False
    picked: ClassVar[bool] = False
    probed: ClassVar[bool] = False
    usual_noise: ClassVar[float] = 0.1  # a caliper's
    second_point: ClassVar[bool] = False
    more_poses: ClassVar[bool] = False
    position_beside: ClassVar[bool] = False
    rotation_beside: ClassVar[bool] = True
    distances_beside: ClassVar[bool] = False
    mount: ClassVar[tuple[str, ...]] = ()  # unknowns that may be source errors of the machine
    reported: ClassVar[Mapping[str, int]] = {}  # unknowns that answers give by name, and their places in the state
    confounds: ClassVar[Mapping[str, tuple[str, str]]] = {}  # of these: what may stand for one, what tells it from it
    sums: ClassVar[Mapping[str, tuple[str, str]]] = {}  # of these: what of the machine is in one, what tells it from it
    aims: ClassVar[str] = ""  # where a plan brings the machine: its tip to "touch" a board, a camera on it to "look"
    under: ClassVar[str] = ""  # another kind's name that sidecars use for this one, whose columns then say which
    filled: ClassVar[Mapping[str, float]] = {}  # columns that may be absent or blank, and what they then hold

    @property
    def words(self) -> str:
        """The name as sidecars write it."""
        return next((a for a in self.aliases if a.replace(" ", "_") == self.name), self.name)

    # ------------------------------------------------------------------------------------------------ as it is derived

    @property
    def kernels(self) -> ModuleType:
        """The generated module."""
        return importlib.import_module(f"deltacal_kernels.measurements.{self.formulas or self.name}")

    @property
    def meaning(self) -> str:
        """What is read, in words."""
        meaning: str = self.kernels.MEANING
        return meaning

    @property
    def pairs(self) -> bool:
        """Whether a reading lies between two rows."""
        return bool(self.kernels.PLATFORMS == 2)

    @property
    def sees_joints(self) -> bool:
        """Whether joints are read, not the platform: `x` then stands for joints (N, n_q); geometry plays no part."""
        return bool(getattr(self.kernels, "JOINT", False))

    @property
    def known(self) -> tuple[str, ...]:
        """Columns that say of each reading what it is of."""
        names: tuple[str, ...] = getattr(self.kernels, "KNOWN", ())
        return names

    @property
    def unknowns(self) -> tuple[tuple[str, str, float, str], ...]:
        """Name, unit, ordinary size and meaning of each unknown of the instrument."""
        found: tuple[tuple[str, str, float, str], ...] = self.kernels.UNKNOWN
        return found

    @property
    def unknown(self) -> tuple[tuple[str, str], ...]:
        """Name and unit of each unknown of the instrument."""
        return tuple((name, unit) for name, unit, *_ in self.unknowns)

    @property
    def state_size(self) -> int:
        """How many numbers say where an instrument of this kind stands, of each set-up."""
        return int(self.kernels.STATE)

    @property
    def typical(self) -> Array:
        """By how much an ordinary instrument is mounted off, by unknown [mm, rad]."""
        return np.array([size for _, _, size, _ in self.unknowns], dtype=float)

    @property
    def targets(self) -> Mapping[str, int]:
        """Columns of values by what effects on the reading move."""
        targets: Mapping[str, int] = self.kernels.TARGETS
        return targets

    @property
    def unit(self) -> str:
        """Unit of the values in files: mm, deg or px."""
        unit: str = self.kernels.COLUMNS[0].rpartition("_")[2]
        return unit

    def unit_in(self, columns: Collection[str]) -> str:
        """Return the unit in files of readings in some columns, in which their noise counts; mm where some are."""
        units = {name.rpartition("_")[2] for name in columns}
        return "mm" if "mm" in units or not units else min(units)

    @property
    def scale(self) -> float:
        """What one unit of a value inside (mm, rad, px) is at the platform [mm], as far as the file can say."""
        scale: float = self.kernels.SCALE
        return scale

    @property
    def turned(self) -> tuple[int, ...]:
        """Which columns of a residual are a rotation."""
        rows: tuple[int, ...] = self.kernels.ROTATION_ROWS
        return rows

    @property
    def rotations(self) -> bool:
        """Whether rotations are read beside the values."""
        return bool(self.turned)

    @property
    def width(self) -> int:
        """Number of values of a reading, rotations not counted."""
        return int(self.kernels.ROWS) - len(self.turned)

    @property
    def scalars(self) -> int:
        """Number of independent scalars of a reading."""
        return int(self.kernels.ROWS)

    @property
    def usual_noises(self) -> tuple[float, ...]:
        """Usual noise of each group [mm], where a few readings of one kind could be met exactly at others' cost."""
        return ()

    @property
    def per_pose(self) -> int:
        """How many scalars the readings of one pose are worth, however many they are."""
        return self.scalars

    def wanted(self, said: Measurement) -> tuple[int, ...]:
        """Return which unknowns a sidecar leaves to be found, seen or not."""
        return () if said.frame == "robot" else tuple(range(len(self.unknown)))

    def unit_of(self, unit: str, state: Array) -> str:
        """Return the unit inside of an unknown that the derivation calls `unit`, of an instrument in a state (g,)."""
        return unit

    @property
    def noises(self) -> int:
        """Number of noises that a reading's columns have."""
        return 1 + self.rotations

    def noise_groups(self, columns: int) -> np.ndarray:
        """Return which noise each of so many columns of a residual has, counted from 0: rotations have their own."""
        return np.isin(np.arange(columns), self.turned).astype(int)

    # ------------------------------------------------------------------------------------------------------- in files

    def columns(self, mechanism: Machine) -> tuple[str, ...]:
        """Return the columns of a recording, unit last; those that stand beside rows of joints hold one value per row.

        Readings between two rows have theirs in the file of pairs.
        """
        columns: tuple[str, ...] = self.kernels.COLUMNS
        return columns

    def read_in(self, columns: tuple[str, ...], given: Collection[str]) -> tuple[str, ...]:
        """Return the columns in which a recording holds readings, of all that this kind has and those given."""
        return columns

    @property
    def reserved(self) -> tuple[str, ...]:
        """Every column that such readings may stand in, on whatever machine."""
        columns: tuple[str, ...] = self.kernels.COLUMNS
        return columns

    @property
    def numbers(self) -> bool:
        """Whether every row of a recording holds the numbers of a reading."""
        return not self.pairs

    def check(
        self, said: Measurement, ties: Sequence[tuple[str, str, float]], cells: Mapping[str, Sequence[str]], file: Path
    ) -> None:
        """Raise an InputError where a sidecar `file` does not say what this kind needs.

        `ties` are known distances between fixed points, `cells` those of the recording, as text, by column.
        """

    def spreads(self, recording: Recording, joints: Array) -> Iterator[tuple[str, float, float]]:
        """Yield, where it tells a wrong unit: column, spread of its readings [mm], joint motion (N, n_q) meanwhile."""
        return iter(())

    def zero_at_home(self, recording: Recording) -> Array | None:
        """Return the measured cells (N, k) that read zero where the machine is at home; None where none need be."""
        return None

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
        by_platform = instrument.scale * by_platform
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

    def carried(self, mechanism: Machine) -> dict[int, int]:
        """Return which unknowns are source errors of the machine: {unknown: parameter}.

        A measuring mechanism that belongs to a machine has its errors in the machine's table (Mei 2018, eq. 17).
        """
        return {u: mechanism.index[name] for u, name in enumerate(self.mount) if name in mechanism.index}

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

    # ----------------------------------------------------------------------------------------------- what is said of it

    def measured_point(self, said: Measurement) -> tuple[float, ...] | None:
        """Return which point of the platform is measured where no row says it; None for the robot's own."""
        return None

    def sigma(self, said: Measurement, scale: float) -> float | None:
        """Return the noise of a value at the platform [mm] where the sidecar says it; `scale` as of an instrument."""
        if said.sigma_mm is not None or self.unit == "mm":
            return said.sigma_mm
        own = said.sigma_rad if self.unit == "deg" else said.sigma_px
        return None if own is None else own * scale

    def in_differences(self, said: Measurement) -> bool:
        """Tell whether the last unknown falls out of differences of adjacent readings, which the papers use."""
        return False

    # ------------------------------------------------------------------------------------------------------- examined

    @property
    def planned(self) -> str:
        """What poses are planned for, in words; "" where they cannot be."""
        return f"{self.meaning}; what is unknown of the instrument is projected out"

    def laid_out(self, recording: Recording, x: Array, mechanism: Machine) -> Recording:
        """Return the rows of a plan, at poses x (N, 12), as they are to be measured: one for each reading."""
        return recording

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return the readings of a machine that are examined, with one or several reference points.

        `stands` is in how many ways an open chain touches a fixed point.
        """
        return (Look(self.meaning),)

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
