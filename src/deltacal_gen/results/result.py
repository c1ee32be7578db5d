"""RESULT.json of `identify`."""

from __future__ import annotations

from enum import StrEnum
from typing import ClassVar, Literal

from deltacal_gen.results.base import Answer, Numbers, Value
from deltacal_gen.results.parts import (
    Continued,
    InstrumentState,
    Made,
    Missing,
    NeverSeen,
    RobotTables,
    SeriesMade,
    Source,
    TermState,
    Uncertainty,
)


class Status(StrEnum):
    """What a parameter's value rests on."""

    IDENTIFIED = "identified"
    BY_PRIOR = "pinned by prior"
    NOT_PINNED = "not pinned"
    FIXED = "fixed"


class Parameter(Value):
    """A source error, actual minus robot file."""

    name: str
    value: float
    std: float | None
    """Null where nothing pins it."""
    unit: str
    status: Status
    indistinguishable_from: tuple[str, ...] | None = None
    """Of an unknown of the instrument: what these readings do not tell it from, in words and by name."""
    run: str | None = None
    """Of a clock's offset: the run that it is of; absent where it is of all."""


class OpenCombination(Value):
    """Parameters that the readings do not tell apart."""

    seen: Literal["not at all", "less than noise"]
    text: str
    terms: dict[str, float]
    """By parameter, per unit of its own."""


class BaseParameter(Value):
    """A combination of parameters that the readings do determine."""

    name: str
    combination: str
    value: float
    std: float
    unit: str


class Remedy(Value):
    """An extra measurement, and how many of the free directions it would pin."""

    measurement: str
    pins: int
    of: int
    open_mm: float | None = None
    """Of a distance to be printed: how far it is open now."""


class Regularisation(Value):
    """What was done with directions that the readings hardly see."""

    rule: str
    determined: float | None = None
    """Effective number of parameters that the readings determine."""


class Read(Value):
    """How much was read."""

    kind: str
    scalars: int
    poses: int


class Stage(Value):
    """A stage of the identification."""

    stage: Literal["rough", "fine"]
    parameters: int
    iterations: int
    train_rms_mm: float


class Largest(Value):
    """The largest errors relative to home."""

    distance_mm: float
    volumetric_mm: float


class Accuracy(Value):
    """The paper's two error measures of the measured positions, stage by stage."""

    home_line: int
    note: str
    before: Largest
    rough: Largest | None = None
    after: Largest


class BaseFrame(Value):
    """Where {O} stands in the instrument's frame; a standard deviation of zero: no reading depends on it."""

    setup: str
    rotation_deg: tuple[float, ...]
    rotation_std_deg: tuple[float, ...]
    origin_mm: tuple[float, ...]
    origin_std_mm: tuple[float, ...]


class TouchedPoint(Value):
    """Where a point that was touched is in {O}."""

    name: str
    position_mm: tuple[float, ...]


class MapPoint(Value):
    """A place of the workspace, and how well the tool's position is known there."""

    target_mm: tuple[float, ...]
    std_mm: tuple[float, ...]


class UncertaintyMap(Value):
    """The standard deviation of the tool position over the workspace."""

    frame: str
    tool_mm: tuple[float, ...]
    worst_mm: float
    median_mm: float
    points: tuple[MapPoint, ...]
    unreachable: int


class Firmware(Value):
    """What the parameters that a printer's firmware has would leave."""

    model: str
    train_rms_mm: float
    heldout_rms_mm: float | None
    errors: dict[str, float] | None = None
    """Of that machine, actual minus robot file [mm, deg]."""


class Result(Answer):
    """What a recording says of a machine: contract, section 6."""

    schema: Literal["deltacal.result/1"] = "deltacal.result/1"
    model: str
    parameters: tuple[Parameter, ...]
    """All source errors of the mechanism, in the order of its table; then what is unknown of the instrument by name."""
    rank: int
    rank_tolerance: float
    singular_values: Numbers
    condition: float | None
    """Null where the rank is not full."""
    scaling: str
    unidentifiable: tuple[OpenCombination, ...]
    base: tuple[BaseParameter, ...] | None = None
    next_measurements: tuple[Remedy, ...]
    regularisation: Regularisation
    readings: Read
    before_rms_mm: float
    """Of the robot file's machine, the instrument fitted."""
    degrees_of_freedom: float | None = None
    """Scalar readings less what the data determine."""
    train_rms_mm: float
    heldout_rms_mm: float | None
    """Of readings in folds that took no part in the fit."""
    sigma_mm: float
    sigma_source: Source
    residual_sigma_mm: float | None = None
    chi2_per_dof: float | None
    gross_errors: tuple[int, ...] | None
    """Lines of the recording; null where none were searched for."""
    stages: tuple[Stage, ...] | None = None
    accuracy: Accuracy | None
    base_frame: tuple[BaseFrame, ...] | None = None
    contacts: tuple[TouchedPoint, ...] | None = None
    workspace: UncertaintyMap | None
    iterations: int | None = None
    physics: tuple[TermState, ...] | None = None
    """Effects that were held as a diagnosis found them, but for what `continued` says."""
    physics_not_held: tuple[Missing, ...] | None = None
    continued: Continued | None = None
    """Null where the readings tell no more of the joints' periodic errors than the diagnosis."""
    instrument: InstrumentState
    robot: RobotTables
    """The calibrated machine."""
    uncertainty: Uncertainty | None = None
    """Null where an earlier version wrote the file."""
    unit: str | None = None
    """Of the readings, where they are no lengths: px, deg. Each of their figures stands in this unit beside mm."""
    unit_mm: float | None = None
    """What one unit is at the platform."""
    firmware: Firmware | None = None
    never_seen: tuple[NeverSeen, ...] | None = None
    """Joints that stand where the readings of the diagnosis never were."""
    motion: SeriesMade | None = None
    """Of a recording in motion."""
    doubts: tuple[str, ...] | None = None
    """Why the readings may be of another machine than the robot file's."""
    begun_s: float = 0.0
    """From when effects count the time [s]: 0, or the first reading where stamps count from long before it."""
    made: Made | None = None

    # what only a diagnosis knows, for those who read either
    correction: ClassVar[None] = None
    seen: ClassVar[None] = None
    clock: ClassVar[Literal["time_s", "row"]] = "time_s"
    poses: ClassVar[None] = None

    @property
    def headline(self) -> str:
        """Errors before and after, and what was found."""
        unit, length = (self.unit, self.unit_mm) if self.unit and self.unit_mm else ("mm", 1.0)
        count = sum(p.status is Status.IDENTIFIED for p in self.parameters)
        free = sum(p.status is not Status.FIXED for p in self.parameters)
        held = "" if self.heldout_rms_mm is None else f", held-out {self.heldout_rms_mm / length:.4g} {unit}"
        found = (
            f"{self.model}: {count} of {free} parameters identified; rms {self.before_rms_mm / length:.4g} -> "
            f"{self.train_rms_mm / length:.4g} {unit}{held} (noise {self.sigma_mm / length:.3g}, {self.sigma_source})"
        )
        return "; ".join([found, *(f"warning: {words}" for words in self.doubts or ())])

    def table(self) -> tuple[Parameter, ...]:
        """Return the parameters that were free."""
        return tuple(p for p in self.parameters if p.status is not Status.FIXED)

    def summary(self) -> str:
        """Return the answer as text, as `print` shows it."""
        return str(self)
