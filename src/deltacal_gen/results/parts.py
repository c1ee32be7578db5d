"""What several answers have in common: the machine, the instrument, effects, parameters, what is missing."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from typing import Any, ClassVar, Literal

from deltacal_gen.results.base import Answer, Numbers, Rows, Value, Vector
from deltacal_gen.results.document import decimals
from deltacal_gen.results.places import Places, part_named

MOST_REPAIRS = 3  # that are shown line by line
SEEN = "the calibration was made of these very readings: they are no check of it"
Table = dict[str, Any]  # of a robot file; which keys it has, the mechanism says: `robot.robot_from_dict` checks them


class Source(StrEnum):
    """Where the noise is known from."""

    REPEATS = "repeats"
    DECLARED = "declared"
    RESIDUAL = "residual"


class Named(Value):
    """The head of a robot file."""

    name: str
    mechanism: str


class RobotTables(Value, extra="forbid"):
    """The tables of a complete robot file [mm, deg]."""

    robot: Named
    geometry: Table | None = None
    """Absent where only joints are read, and the file does not say how the machine is built."""
    workspace: Table | None = None
    masses: Table | None = None
    transmission: Table | None = None
    joints: Table
    joint: tuple[Table, ...] | None = None
    """Of an open chain, from the base."""
    limits: dict[str, tuple[float, ...]] | None = None
    """Between what a channel can be set, by its column."""
    errors: dict[str, float] | None = None
    """Actual minus [geometry], by the names of the mechanism's parameters."""
    tolerance: dict[str, float] | None = None

    @property
    def places(self) -> Places:
        """What its limbs are called, and which they are."""
        alone = len(self.joints["sign"]) == 1
        part = "joint" if alone or self.joint is not None else part_named(self.geometry or ())
        return Places.of([link["kind"] for link in self.joint or ()], self.robot.name, part)

    def __repr__(self) -> str:
        return f"<RobotTables '{self.robot.name}': {self.robot.mechanism}>"


class TermState(Value):
    """An effect with its coefficients, in internal units (mm, rad, N, s, K): what predictions are made of."""

    effect: str
    limbs: tuple[int, ...]
    constants: tuple[float | str, ...]
    values: Rows
    tools: tuple[Vector, ...]
    lacks: tuple[str, ...] | None = None
    """Coefficients, and targets of others, that it does not have, as the machine lacks them."""
    gaps: tuple[int, ...] | None = None
    """Sessions in which cells of a channel that it reads are blank: further coefficients, of each in turn."""


class InstrumentState(Value):
    """The instrument as the fit found it, in internal units (mm, rad): one row of unknowns per set-up."""

    kind: str
    state: Rows
    free: tuple[int, ...]
    scale: float = 1.0
    home: Vector = (0.0, 0.0, 0.0)
    ties: tuple[tuple[int, int, float], ...] = ()
    setups: tuple[str, ...]
    """Names of the set-ups, in the order of the rows."""
    zero: str
    columns: tuple[str, ...] | None = None
    """Of the readings, where they stand in fewer than their kind has: one coordinate alone."""


class Undiagnosed(Value):
    """What only a diagnosis knows, for those who read a machine whoever found it."""

    correction: ClassVar[None] = None
    clock: ClassVar[Literal["time_s", "row"]] = "time_s"  # by which moments are found
    poses: ClassVar[None] = None
    seen: ClassVar[None] = None  # joints with a periodic error of their own


class MachineState(Undiagnosed):
    """A machine with what acts on it and the instrument that saw it."""

    robot: RobotTables
    physics: tuple[TermState, ...]
    instrument: InstrumentState
    begun_s: ClassVar[float] = 0.0  # from when effects count the time


class Missing(Value):
    """An effect that cannot be used, and what a recording would have to hold for it, in words."""

    name: str
    missing: str


class NeverSeen(Value):
    """A joint that stands at angles where the readings of a diagnosis never were."""

    limb: int
    readings: int
    """How many stand there."""
    angles_deg: tuple[tuple[float, float], ...]
    """Where, within the turn."""

    @property
    def words(self) -> str:
        """Where it stands, and that its periodic error is not corrected there."""
        so = "its periodic error is not corrected there"
        return self._stands("at angles that the diagnosis never saw", " within the turn", so)

    @property
    def beyond_words(self) -> str:
        """The same of a joint beyond the turns at which a wave was read that was not seen to repeat."""
        so = "a periodic error of it was not seen to repeat, and is not known there"
        return self._stands("at turns beyond those of the diagnosis", "", so)

    def _stands(self, place: str, of: str, so: str) -> str:
        where = ", ".join(f"{a:.0f} to {b:.0f}" for a, b in self.angles_deg)
        return f"joint {self.limb} stands in {self.readings} readings {place} ({where} deg{of}): {so}"


class Continued(Value):
    """The periodic errors of joints that a diagnosis knew, told further by the readings of another session."""

    limbs: tuple[int, ...]
    change_rms_deg: dict[str, float]
    """Of each joint, over these readings: by how much its error is another one than the diagnosis has."""
    held_rms_mm: float
    """Of held-out readings, the errors held as the diagnosis has them."""
    heldout_rms_mm: float
    """Of the same, the errors told further by the others."""

    def words(self, places: Places) -> str:
        """Return which periodic errors are updated, and what that is worth."""
        return (
            f"the periodic errors{places.at(self.limbs)} are updated from those of the diagnosis: held-out error "
            f"{self.held_rms_mm:.3g} mm with its own, {self.heldout_rms_mm:.3g} mm with these readings too"
        )


class InputFile(Value):
    """A file that an answer was made of."""

    name: str
    sha256: str


class Made(Value):
    """What made an answer, when, of which files, measured by what and whom."""

    version: str
    date: str
    """UTC, as 2026-01-31."""
    inputs: tuple[InputFile, ...]
    instrument: str | None = None
    operator: str | None = None


class EffectName(Value):
    """An effect and where it sits."""

    name: str
    limbs: tuple[int, ...]
    """Those that the data bear out; none of an effect of the whole machine."""


class SeriesMade(Value):
    """What a recording in motion tells of its joints beside where they were, and how that was made."""

    cutoff_Hz: float | None
    """Of the low-pass; null where there is none."""
    removed: float
    """Part of the joints' signal, rms of its variation, that the low-pass takes away."""
    text: str
    repairs: tuple[str, ...]
    """What was put right in the file, with its line."""


class Derivatives(SeriesMade):
    """How velocities and accelerations were made of the joints, where drives are read."""

    filter: str
    """What was filtered beside the joints."""
    at_rest: tuple[int, ...]
    """Samples of each joint that were set aside, since friction at rest is not known."""
    at_rest_below: tuple[float, ...]
    """Speed of each joint below which it counts as at rest [deg/s or mm/s]."""
    held_out: str


class Uncertainty(Value):
    """How surely a machine and its instrument are known: what bands are made of."""

    parameters: tuple[str, ...]
    """Source errors, those that the model leaves out last."""
    coefficients: int
    """Of the first effects of `physics`, whose uncertainty stands after that of `parameters`."""
    factor: Numbers
    """Lower triangle, row by row, of L with covariance L L' [mm, rad, N, s, K]; after the coefficients come the
    instrument's unknowns, set-up by set-up."""
    degrees: float
    """Of freedom, on which the noise in it rests."""
    scatter: Numbers
    """By which each component of a reading departs from the model, pose by pose, beyond noise [mm, rad]."""
    left_out: dict[str, float] | None = None
    """Of source errors that the model leaves out, by their unit: their size in ordinary ones, or in tolerances."""
    text: str
    """What bands hold, and what not."""


def put_right(repairs: Sequence[str]) -> list[str]:
    """Return in words what was put right in a recording: the first of it, and how much more."""
    more = len(repairs) - MOST_REPAIRS
    return [*repairs[:MOST_REPAIRS], *([f"and {more} more that were put right or left out"] if more > 0 else [])]


def needless(filed: float, heldout: float | None, unit: str = "mm") -> str:
    """Say that a calibrated machine is no nearer to readings that it has not seen than the robot file's; else nothing.

    Parameters
    ----------
    filed, heldout : float
        Errors of the robot file's machine, and of the calibrated one where readings were held out [unit].
    unit : str
    """
    if heldout is None or not heldout >= filed:
        return ""
    return (
        f"The machine as the robot file has it leaves no more, {decimals(filed)} {unit}, than the calibrated one does "
        f"of readings that it has not seen, {decimals(heldout)} {unit}: these readings do not show that it wants a "
        "correction. Where the instrument is surer than that, compare with the recording which point was measured, and "
        "whether joints and readings of a row belong together."
    )


class NoiseModel(Value):
    """How the noise of one row hangs together with that of the next."""

    rho: float
    """Correlation from row to row of the part that fades."""
    rows: float
    """So many rows tell as much as one whose noise is its own."""
    own: float
    """Part of the variance that is each row's own, beside what fades."""
    columns: tuple[float, ...] | None = None
    """Standard deviation of each component of a reading, in units of all together; null where they are alike."""
    tails: Literal["Laplace", "Student"] | None = None
    """The distribution that large errors are as frequent in; null where they are in the normal one."""
    degrees: float | None = None
    """Of freedom, of Student's distribution."""
    text: str


class OfReadings(Answer):
    """An answer whose figures are those of readings, in their unit."""

    unit: str | None = None
    """Of the readings, where they are no lengths: px, deg. Each of their figures stands in this unit beside mm."""
    unit_mm: float | None = None
    """What one unit is at the platform."""


class AtRest(OfReadings):
    """What is known of a machine at rest, whether it was identified or diagnosed."""

    sigma_mm: float
    instrument: InstrumentState
    uncertainty: Uncertainty | None = None
    """Null where an earlier version wrote the file."""
    motion: SeriesMade | None = None
    """Of a recording in motion."""
    begun_s: float = 0.0
    """From when effects count the time [s]: 0, or the first reading where stamps count from long before it."""
