"""RESULT.json of `identify`."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Literal

from deltacal_gen.results.base import Answer, BlankRows, Counts, Numbers, Value, shown_in
from deltacal_gen.results.document import Document, Table, Text, decimals, number, rounded
from deltacal_gen.results.parts import (
    AtRest,
    Continued,
    Made,
    Missing,
    NeverSeen,
    RobotTables,
    Source,
    TermState,
    Undiagnosed,
    needless,
    put_right,
)

FEW = 0.5  # of the readings: a fit that leaves fewer to judge it by takes a good part of the noise away
ABOVE_NOISE = 2.0  # chi2 per degree of freedom that no noise of the stated size leaves
MOST_OPEN, MOST_REMEDIES = 4, 2  # that are shown; the file has all


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
    meaning: str | None = None
    """What it is of the machine, in words."""


class OpenCombination(Value):
    """Parameters that the readings do not tell apart."""

    seen: Literal["not at all", "less than noise"]
    text: str
    terms: dict[str, float]
    """By parameter, per unit of its own."""
    meaning: str | None = None
    """What it does to the machine, in a sentence of geometry; absent where nothing simple is it."""


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


class FitResiduals(Value):
    """What the calibrated machine leaves of every reading, and where its tool was, in {O}."""

    line: Counts
    position_mm: BlankRows
    residual_mm: BlankRows
    """Measured minus calibrated, component by component; null where nothing was read."""


class Firmware(Value):
    """What the parameters that a printer's firmware has would leave."""

    model: str
    train_rms_mm: float
    heldout_rms_mm: float | None
    errors: dict[str, float] | None = None
    """Of that machine, actual minus robot file [mm, deg]."""


class Identified(Answer):
    """What every recording says of a machine, at rest or in motion: contract, sections 6 and 8."""

    schema_: Literal["deltacal.result/1"] = "deltacal.result/1"
    model: str
    condition: float | None
    """Null where the rank is not full."""
    scaling: str
    unidentifiable: tuple[OpenCombination, ...]
    """Parameters that no reading knows, and combinations that leave every reading as it is."""
    regularisation: Regularisation
    readings: Read
    sigma_source: Source
    chi2_per_dof: float | None
    robot: RobotTables
    """The calibrated machine."""
    doubts: tuple[str, ...] | None = None
    """Why the readings may be of another machine than the robot file's."""
    made: Made | None = None


class Result(Identified, AtRest, Undiagnosed):
    """What a recording says of a machine: contract, section 6."""

    parameters: tuple[Parameter, ...]
    """All source errors of the mechanism, in the order of its table; then what is unknown of the instrument by name."""
    rank: int
    rank_tolerance: float
    singular_values: Numbers
    base: tuple[BaseParameter, ...] | None = None
    next_measurements: tuple[Remedy, ...]
    before_rms_mm: float
    """Of the robot file's machine, the instrument fitted."""
    degrees_of_freedom: float | None = None
    """Scalar readings less what the data determine."""
    train_rms_mm: float
    heldout_rms_mm: float | None
    """Of readings in folds that took no part in the fit."""
    residual_sigma_mm: float | None = None
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
    firmware: Firmware | None = None
    never_seen: tuple[NeverSeen, ...] | None = None
    """Joints that stand where the readings of the diagnosis never were."""
    residuals: FitResiduals | None = None
    """Null in answers written before they were kept."""

    @property
    def headline(self) -> str:
        """Errors before and after, and what was found."""
        count = sum(p.status is Status.IDENTIFIED for p in self.parameters)
        found = f"{self.model}: {count} of {len(self.table())} parameters identified; {self._errors()}"
        return "; ".join([found, *(f"warning: {words}" for words in self.doubts or ())])

    def _errors(self) -> str:
        unit, length = shown_in(self)
        before, after, sigma = (decimals(v / length) for v in (self.before_rms_mm, self.train_rms_mm, self.sigma_mm))
        held = "" if self.heldout_rms_mm is None else f", held-out {number(self.heldout_rms_mm / length)} {unit}"
        return f"rms before {before} -> after {after} {unit}{held} (noise {sigma}, {self.sigma_source})"

    @property
    def flattered(self) -> str:
        """By how much the residual understates the noise, where there are few readings; else nothing."""
        unit, length = shown_in(self)
        return flattered(self.degrees_of_freedom, self.readings.scalars, self.train_rms_mm / length, unit)

    @property
    def errors_told(self) -> list[str]:
        """How the errors before and after are to be taken, where not as they are."""
        (unit, length), held = shown_in(self), self.heldout_rms_mm
        vain = needless(self.before_rms_mm / length, held and held / length, unit) if self.rank else ""
        return [said for said in (self.flattered, vain) if said]

    @property
    def carried_told(self) -> list[str]:
        """What became of the effects that another session's diagnosis knows."""
        told = [joint.words for joint in self.never_seen or ()]
        told += [] if self.continued is None else [self.continued.words(self.robot.places)]
        told += [
            f"not held: {e.name} of the diagnosed session: this one lacks {e.missing}"
            for e in self.physics_not_held or ()
        ]
        return [f"{said[0].upper()}{said[1:]}." for said in told]

    def table(self) -> tuple[Parameter, ...]:
        """Return the parameters that were free."""
        return tuple(p for p in self.parameters if p.status is not Status.FIXED)

    def document(self) -> Document:
        """Yield parameters, what is not identifiable, errors before and after, and what is said of them."""
        yield from map(Text, self.carried_told)
        rows = [(p.name, *_value(p), p.unit, p.status) for p in self.table()]
        title = f"{self.model}: parameters, actual minus robot file"
        yield Table(("parameter", "value", "std", "unit", "status"), rows, title)
        yield from self._open()
        if self.gross_errors:
            yield Text(f"outliers in lines {', '.join(map(str, self.gross_errors))}: they have almost no weight")
        yield from self._positions()
        if self.uncertainty is not None and self.uncertainty.left_out:
            yield Text(self.uncertainty.text)
        count = sum(p.status is Status.IDENTIFIED for p in self.parameters)
        yield Text(
            f", {self.readings.scalars} scalar readings: {self._errors()}",
            f"{count} of {len(rows)} parameters identified",
        )
        yield from map(Text, self.errors_told)
        if firmware := self.firmware:
            yield Text(
                f"for comparison, what firmware fits ({firmware.model}): {decimals(firmware.train_rms_mm)} mm, "
                f"held-out {number(firmware.heldout_rms_mm)} mm"
            )
        chi2 = self.chi2_per_dof
        if chi2 is not None and chi2 > ABOVE_NOISE and self.sigma_source is not Source.RESIDUAL:
            yield Text("The residual is above the noise: this geometry does not explain all of these readings.")
        yield from (Text(doubt, "warning: ") for doubt in self.doubts or ())
        yield from map(Text, put_right(self.motion.repairs if self.motion else ()))

    def _open(self) -> Iterator[Text]:
        """Yield which directions the readings leave open, and what would make them identifiable."""
        shown = self.unidentifiable[:MOST_OPEN]
        if shown:
            yield Text("; the robot file's values hold along them:", "Not identifiable from these readings")
            yield from (Text(f"- {c.meaning or c.text}", level=1) for c in shown)
        if more := len(self.unidentifiable) - len(shown):
            yield Text(f"- and {more} more, in the result file", level=1)
        for m in self.next_measurements[:MOST_REMEDIES]:
            pins = "" if m.open_mm is not None else f" would make {m.pins} of the {m.of} free directions identifiable"
            yield Text(f"+ {m.measurement}{pins}", level=1)

    def _positions(self) -> Iterator[Text | Table]:
        if a := self.accuracy:
            stages = ((a.before, "robot file"), (a.rough, "encoder offsets"), (a.after, self.model))
            told = [(name, f"{s.distance_mm:.3f}", f"{s.volumetric_mm:.3f}") for s, name in stages if s is not None]
            yield Table(("largest error relative to home", "distance, mm", "volumetric, mm"), told)
        if w := self.workspace:
            yield Text(
                f"standard uncertainty of the tool position over the workspace: median {w.median_mm:.3f} mm, largest "
                f"{w.worst_mm:.3f} mm"
            )


def _value(p: Parameter) -> tuple[str, str]:
    return (f"{p.value:.4f}", "-") if p.std is None else rounded(p.value, p.std)


def flattered(left: float | None, readings: int, rms: float, unit: str = "mm") -> str:
    """Say by how much the residual of a fit understates the noise, where its readings are few; else nothing.

    Parameters
    ----------
    left : float or None
        Degrees of freedom: readings less parameters.
    rms : float
        Of the residual [unit].
    unit : str
    """
    if left is None or left > FEW * readings:
        return ""
    said = f"{readings} readings less {readings - left:.3g} parameters leave {max(left, 0):.3g} degrees of freedom"
    if left < 1:
        return f"{said}: the residual of {rms:.3g} {unit} says nothing of the noise."
    part = (left / readings) ** 0.5
    return (
        f"{said}: noise of {rms / part:.3g} {unit} leaves a residual of {rms:.3g} {unit}, "
        f"and the next session of an unchanged machine, predicted from this one, at least {1 / part:.2g} times as much."
    )
