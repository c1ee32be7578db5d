"""What is known of a kind of measurement before anything is read: names, columns, units, what it is good for.

All of it stands in the generated module of its formulas, or is said by the kind itself; see `kind`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np

from deltacal_gen.machine.backend import RowFunctions, row_functions
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.values import Measurement, Recording


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
class Facts:
    """A kind of measurement: what of it stands in files, what is unknown of its instrument, what it can tell.

    Attributes
    ----------
    name : str
        As recordings and results call it; also of the generated module, unless `formulas` names another.
    positions : bool
        Whether the first values are coordinates of the measured point in a frame of the instrument.
    rotations : bool
        Whether rotations are read too; their noise is another than that of lengths.
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
    touched : tuple of str
        Coordinates of the platform in which a surface is touched: there what the machine believes is the misfit itself.
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
    anew: ClassVar[bool] = False
    stays: ClassVar[bool] = False
    apart: ClassVar[bool] = False
    in_motion: ClassVar[bool] = False
    follows: ClassVar[bool] = False
    picked: ClassVar[bool] = False
    touched: ClassVar[tuple[str, ...]] = ()
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
    def kernels(self) -> RowFunctions:
        """The generated module."""
        return row_functions(f"measurements.{self.formulas or self.name}")

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
        return self.unit_in(self.kernels.COLUMNS)

    def unit_in(self, columns: Collection[str]) -> str:
        """Return the unit in files of readings in some columns, in which their noise counts; mm where some are.

        A column that says none holds names, of what was touched.
        """
        units = {unit for said, _, unit in (name.rpartition("_") for name in columns) if said}
        return "mm" if "mm" in units or not units else min(units)

    @property
    def scale(self) -> float:
        """What one unit of a value inside (rad, px) is at the platform [mm], as far as the file can say."""
        scale: float = self.kernels.SCALE
        return scale

    def at_platform(self, scale: float) -> Array:
        """Return what one unit of each column of a residual (k,) is at the platform [mm], of an instrument's `scale`.

        A length is as long there, whatever stands beside it; rotations have a noise of their own.
        """
        lengths = np.array([name.endswith("_mm") for name in self.kernels.COLUMNS])
        lengths[list(self.turned)] = True
        return np.where(lengths, 1.0, scale)

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

    # ------------------------------------------------------------------------------------------------- the instrument

    def carried(self, mechanism: Machine) -> dict[int, int]:
        """Return which unknowns are source errors of the machine: {unknown: parameter}.

        A measuring mechanism that belongs to a machine has its errors in the machine's table (Mei 2018, eq. 17).
        """
        return {u: mechanism.index[name] for u, name in enumerate(self.mount) if name in mechanism.index}

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
