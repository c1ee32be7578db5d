"""The answer of `validate`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value, shown_in
from deltacal_gen.results.document import Document, Text, decimals
from deltacal_gen.results.parts import SEEN, Made, NeverSeen, OfReadings, put_right


class Row(Value):
    """A reading and what it is off."""

    line: int
    error_mm: float


class Iso9283(Value):
    """Accuracy and repeatability of poses that were read at least twice (ISO 9283, section 7.2)."""

    poses: int
    AP_mean_mm: float
    AP_max_mm: float
    RP_mean_mm: float
    RP_max_mm: float
    AD_mean_mm: float | None = None
    AD_max_mm: float | None = None
    RD_max_mm: float | None = None
    note: str

    @property
    def words(self) -> str:
        """Its figures in a sentence."""
        said = {"accuracy AP": (self.AP_mean_mm, self.AP_max_mm), "repeatability RP": (self.RP_mean_mm, self.RP_max_mm)}
        each = [f"{name} {decimals(mean)} mm (largest {decimals(most)})" for name, (mean, most) in said.items()]
        return f"ISO 9283, {self.poses} poses: {', '.join(each)}"


class AxisPlace(Value):
    """Deviations at a position of an axis that was reached from either side: means and standard deviations."""

    at: float
    """Where the joint was commanded, in its own unit."""
    up_mm: float
    down_mm: float
    up_std_mm: float
    down_std_mm: float


class Iso230(Value):
    """One axis whose positions were read at least twice from both sides (ISO 230-2, bi-directional)."""

    poses: int
    A_mm: float
    E_mm: float
    R_mm: float
    B_mm: float
    M_mm: float
    unit: str = "mm"
    """Of the joint, mm or deg."""
    places: tuple[AxisPlace, ...] = ()
    """Position by position, the lowest first."""
    note: str

    @property
    def words(self) -> str:
        """Its figures in a sentence."""
        names = ("accuracy A", "systematic E", "repeatability R", "reversal B", "mean M")
        figures = (self.A_mm, self.E_mm, self.R_mm, self.B_mm, self.M_mm)
        each = [f"{name} {decimals(figure)}" for name, figure in zip(names, figures, strict=True)]
        return f"ISO 230-2, {self.poses} positions from both sides, mm: {', '.join(each)}"


class Placed(Value):
    """A set-up of the instrument that was placed by the readings themselves."""

    setup: str
    why: Literal["unknown", "elsewhere"]
    """The result knows no such set-up, or knows it at another place."""
    unknowns: int
    """How many numbers say where it stands; they count as no degrees of freedom."""
    readings: int
    rms_where_known_mm: float | None = None
    """What the readings would leave where the result knows the set-up."""
    shift_mm: float | None = None
    """From where the result knows it to where it stands."""
    turn_deg: float | None = None
    left_out: bool
    """Whether the errors are of readings that took no part in the placing; too few poses allow none."""

    @property
    def sentence(self) -> str:
        """That the set-up was placed by the readings, and what that means for the figures."""
        if self.why == "unknown":
            known = f"The result does not know the set-up '{self.setup}'"
        else:
            far = "" if self.shift_mm is None else f", {self.shift_mm:.1f} mm and {self.turn_deg:.2f} deg away"
            known = (
                f"The instrument (set-up '{self.setup}') stands elsewhere than the result knows it{far}; there these "
                f"readings would be off by {self.rms_where_known_mm:.4g} mm rms"
            )
        errors = "each error is of a pose that was left out of that"
        if not self.left_out:
            errors = "there are too few poses to leave some out, so that the errors flatter"
        return f"{known}. It was placed by its {self.readings} readings ({self.unknowns} numbers); {errors}."


class Apart(Value):
    """Readings that are off by more than three times what any other is."""

    lines: tuple[int, ...]
    """The farthest off first."""
    rms_of_others_mm: float
    largest_of_others_mm: float


class Validated(Answer):
    """What a check of a model says of every recording, at rest or in motion."""

    schema_: Literal["deltacal.validation/1"] = "deltacal.validation/1"
    kind: str
    readings: int
    chi2_per_dof: float | None
    """Of all readings, each with the part of it that placing the instrument has not taken."""
    degrees_of_freedom: int
    """Scalar readings less the numbers that place set-ups."""
    outside_law: int | None = None
    """Rows outside the range in which a law of the diagnosis was found; left out where it has none."""
    seen: Literal[True] | None = None
    """The calibration was made of this very file, which is then no check of it; left out of other readings."""
    repairs: tuple[str, ...] | None = None
    """What was put right in a recording in motion, or left out of it, with its line."""
    made: Made | None = None

    @property
    def told(self) -> tuple[str, ...]:
        """What is to be known beside the error: of which readings it is, and where the model is not known."""
        outside = self.outside_law
        law = [f"{outside} rows lie outside the range in which the law was found"] if outside else []
        return (*([SEEN] if self.seen else []), *self._beside(), *law)

    def _beside(self) -> tuple[str, ...]:
        """Return what this kind of readings has to tell beside the error."""
        return ()

    def document(self) -> Document:
        """Yield the error against the noise, what is said of it, and what was put right in the recording."""
        yield from map(Text, (self.headline, *self.told, *put_right(self.repairs or ())))


class Validation(Validated, OfReadings):
    """The error of a calibrated or diagnosed model on readings that it has not seen."""

    rms_mm: float
    worst_mm: float
    sigma_mm: float
    """The noise, as the result knows it."""
    placed: tuple[Placed, ...] | None = None
    """Set-ups that were placed by these readings; errors are then of poses left out in turn."""
    never_seen: tuple[NeverSeen, ...]
    """Joints that stand at angles which the diagnosis never saw."""
    beyond_waves: tuple[NeverSeen, ...] | None = None
    """Joints that stand beyond the turns at which a wave was read that was not seen to repeat."""
    rows: tuple[Row, ...]
    """The worst first."""
    gross_errors: tuple[int, ...] | None = None
    """Lines of points that were found wrongly in images, which no figure counts; left out of other readings."""
    apart: Apart | None = None
    """Readings of which the error tells more than of the machine; left out where there are none."""

    iso9283: Iso9283 | None = None
    iso230: Iso230 | None = None

    @property
    def headline(self) -> str:
        """The error against the noise."""
        unit, length = shown_in(self)
        return (
            f"{self.readings} readings: rms {self.rms_mm / length:.4g} {unit}, largest {self.worst_mm / length:.4g} "
            f"{unit} (noise {self.sigma_mm / length:.3g} {unit})"
        )

    def _beside(self) -> tuple[str, ...]:
        """Return what stands apart, what was placed, and where a joint was not seen."""
        lines = ", ".join(map(str, self.gross_errors or ()))
        return (
            *([f"points found wrongly in lines {lines}: no figure counts them"] if lines else []),
            *([] if self.apart is None else [self._of_apart(self.apart)]),
            *(p.sentence for p in self.placed or ()),
            *(joint.words for joint in self.never_seen),
            *(joint.beyond_words for joint in self.beyond_waves or ()),
        )

    def _of_apart(self, far: Apart) -> str:
        unit, length = shown_in(self)
        lines = f"line{'s' if len(far.lines) > 1 else ''} {', '.join(map(str, far.lines))}"
        return (
            f"{lines}: more than three times as far off as any other reading, which no machine does without a cause: "
            "look there first; all others: rms "
            f"{far.rms_of_others_mm / length:.4g} {unit}, largest {far.largest_of_others_mm / length:.4g} {unit}"
        )

    def table(self) -> tuple[Row, ...]:
        """Return the worst readings."""
        return self.rows

    def document(self) -> Document:
        """Yield the error against the noise, what is said of it, and the figures of ISO 9283 and ISO 230-2."""
        yield from super().document()
        yield from (Text(norm.words) for norm in (self.iso9283, self.iso230) if norm is not None)
