"""DIAGNOSIS.json of `diagnose`."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Literal

from deltacal_kernels.effects import ORDERS

from deltacal_gen.results.base import Answer, Column, Counts, Rows, Value, shown_in
from deltacal_gen.results.document import Document, Table, Text, decimals, number, rounded
from deltacal_gen.results.parts import (
    AtRest,
    EffectName,
    MachineState,
    Made,
    Missing,
    NoiseModel,
    RobotTables,
    Source,
    TermState,
    put_right,
)
from deltacal_gen.results.result import Parameter

Row = dict[str, float | str]  # of a recording, by the names of its columns


class Verdict(StrEnum):
    """What a diagnosis comes to."""

    ADEQUATE = "adequate"
    MISSING_PHYSICS = "missing_physics"
    UNEXPLAINED = "unexplained"


class NoiseLevel(Value):
    """NoiseLevel per measured scalar, and where it is known from."""

    sigma_mm: float
    source: Source
    model: NoiseModel | None = None
    """Null in answers written before it was told."""


class Final(Value):
    """What a fit leaves."""

    train_rms_mm: float
    heldout_rms_mm: float | None
    """Of poses used neither for fitting nor for choosing the effects; null where nothing could be held out."""
    chi2_per_dof: float


class Baseline(Final):
    """What geometry alone leaves."""

    model: str
    parameters: int | None = None
    """How many source errors are free in it."""


class Channel(Value):
    """A channel that the misfit depends on."""

    name: str
    p_value: float
    share: float


class RegionOf(Value):
    """A ball in {O} within which the misfit lies."""

    centre_mm: tuple[float, ...]
    radius_mm: float


class Location(Value):
    """Where model and recording differ."""

    channels: tuple[Channel, ...]
    """By share, the first one is the answer."""
    limbs: tuple[int, ...]
    region: RegionOf | None
    text: str


class Hypothesis(Value):
    """Effects that the machine may have, fitted exactly with the noise that suits them."""

    effects: tuple[str, ...]
    """Each with where it is."""
    correlated: bool
    """Whether the noise of readings is correlated, or unlike in directions."""
    cost_chi2: float
    """-2 log of its posterior probability, a difference in chi2, above that of the most probable hypothesis."""
    moves: tuple[str, ...]
    """Steps of the search that led to it: `+` adds, `-` drops, `>` exchanges."""


class Searched(Value):
    """What the search comes to, before anything is named, and the hypotheses that it compared."""

    best: str | None
    """The effect that explains most for its price; null where none was tested."""
    p_value: float
    """Probability that noise alone lets the best of all forms of all effects explain as much: uniform where there is
    nothing but noise."""
    hypotheses: tuple[Hypothesis, ...] = ()
    """The most probable first."""


class EffectParameter(Value):
    """A coefficient or constant of an effect, in the units of files."""

    name: str
    limb: int | None
    value: float | str
    std: float | None
    """Null of what was searched for: an order, a time, the name of a column."""
    unit: str
    tool_mm: tuple[float, ...] | None = None
    """The tool point that it belongs to."""
    setup: str | None = None
    """The set-up that it belongs to, of a payload."""

    @property
    def label(self) -> str:
        """Its name, and of which measured point or of which set-up it is, where each has its own."""
        point = f"({', '.join(f'{v:g}' for v in self.tool_mm)})" if self.tool_mm else None
        return " of ".join(filter(None, (self.name, point, self.setup)))


class StandingOrder(Value):
    """An order of a joint's periodic error whose amplitude stands out of its standard deviation [deg]."""

    limb: int
    order: int
    amplitude_deg: float
    std_deg: float


class Effect(EffectName):
    """An effect that was found."""

    title: str
    parameters: tuple[EffectParameter, ...]
    orders: tuple[int, ...] | None = None
    """The first and the last, of a periodic error of many orders."""
    harmonic_of: float | None = None
    """Order of the fundamental with which it is one finding: a periodic error that is no sine."""
    standing_out: tuple[StandingOrder, ...] | None = None
    """Of one of many orders: those that carry most for how well they are known, joint by joint, the clearest first."""
    p_value: float
    """Probability that noise alone lets the best of all forms of all effects earn so much."""
    gain_chi2: float
    gain_by_limb: dict[str, float] | None = None
    share_of_excess: float
    """Part of the held-out variance above noise that it removes."""
    indistinguishable_from: tuple[str, ...]
    instead_of_limb: dict[str, tuple[int, ...]] | None = None
    """Limbs in whose place these others explain as much; of such limbs the one that gives least is named."""
    read_deg: dict[str, tuple[float, float]] | None = None
    """Of a wave that was not seen to repeat: between which turns each of its joints was read. Beyond, it is unknown."""
    moves_mm: float | None = None
    """By how much it moves a reading at most; absent where readings are no positions in one frame."""
    advice: str | None = None
    """What to do about it."""

    @property
    def periods(self) -> tuple[float, ...]:
        """Periods per turn that were searched for and found, of a wave of the joint's turn: one for each joint."""
        return tuple(float(p.value) for p in self.parameters if p.name == ORDERS.get(self.name))


class LawCoefficient(Value):
    """A coefficient of a law, or a constant within it, in the units that its expression is in."""

    name: str
    limb: int | None
    """Null of a constant within, and where the whole machine has the law."""
    value: float
    std: float | None
    unit: str


class Formula(Value):
    """What moves, by which expression: SymPy's text in mm, rad, s, kg, N, N mm and degC."""

    target: str
    limbs: tuple[int, ...]
    expression: str


class LawTerm(Formula):
    """A term of a law, with its coefficients."""

    coefficients: tuple[LawCoefficient, ...]


class LawCurve(Value):
    """A law along its first state, with what every reading says of it: what is left of the readings beside all else."""

    state: str
    unit: str
    target_unit: str
    at: Column
    """The curve, where it is drawn."""
    value: Column
    std: Column
    """Beside the curve's mean, where that is less known than the curve varies: geometry takes over what it is."""
    seen: Column
    """The state at the readings."""
    partial: Column
    """What the readings say there."""
    term: int = 0
    """Which of the law's terms it is of, from 0."""


class RunnerUp(Formula):
    """A form that was tried in place of a law's last term, and what it earns."""

    gain: float
    """In chi2, beside all else that is fitted."""
    charge: float
    """What chance and the search for it account for."""


class LawOf(Value):
    """What every law says that explains what no registered effect does; several are alternatives, never a sum."""

    terms: tuple[LawTerm, ...]
    states: tuple[str, ...]
    range: dict[str, tuple[float, float]]
    """Between which values each state was."""
    share_of_excess: float
    """Part of the variance above the noise that it removes, of readings that took no part in finding it."""
    gain: float
    charge: float
    alike: tuple[str, ...]
    """Laws that these readings cannot tell from it."""
    borne_out: bool
    curve: LawCurve | None = None
    """Of its first term."""
    curves: tuple[LawCurve, ...] = ()
    """Of every term that has one: what lags has none."""
    forms_tried: int | None = None
    """Among so many, place by place, its last term was chosen; null of rivals."""
    runners_up: tuple[RunnerUp, ...] = ()
    """Of these the best, but for what cannot be told from it."""


class Law(LawOf):
    """A law of a machine at rest."""

    heldout_rms_mm: float
    """Of readings that took no part in finding it."""
    remainder_rms_mm: float | None = None
    """By which what the form leaves of its states moves readings besides: predicted, never told; null for none."""


class Hint(EffectName):
    """An effect that may be there: it explains more than chance usually lets it, short of proof."""

    gain_chi2: float
    p_value: float
    """Probability that noise alone lets the best of all forms of all effects earn so much."""
    indistinguishable_from: tuple[str, ...]
    why: str
    """What is wanting; `next_measurements` holds what would decide it."""
    earned: bool = False
    """Whether it earned its full price beside all that was named."""


class Rejected(Value):
    """An effect that was looked at and not named."""

    name: str
    gain_chi2: float
    why: str


class NextMeasurement(Value):
    """What to measure next, and what for."""

    why: str
    text: str
    poses: tuple[Row, ...]
    """Rows of a recording without readings."""
    expected_chi2: float | None
    """The difference that they are expected to make, all rivals fitted again."""
    separates: tuple[str, ...] | None = None
    """Effects that they tell apart; of one alone, whether it is there."""
    chi2_by_pose: tuple[float, ...] | None = None
    """What the first of `poses`, by their worth, and then of `further` make."""
    further: tuple[Row, ...] | None = None
    """Rows for those who can measure more."""
    run: tuple[str, ...] | None = None
    """Of a recording in motion, where another run is what tells: the states that it must vary."""


class BeforeAfter(Value):
    """A figure without and with something."""

    before: float
    after: float


class SmoothState(Value):
    """A smooth function of one recorded variable that moves joints, or the platform [mm, rad]."""

    variable: str
    limbs: tuple[int, ...]
    knots: Rows
    length: float
    reach: float
    coefficients: Rows


class JointFunction(Value):
    """What a smooth correction says of one joint's own function, over the range that it was seen in."""

    limb: int
    rms_mm: float
    """By which it moves the readings."""
    joint_rms_deg: float | None
    """By which it moves a joint that turns, what goes straight through the range taken off."""
    joint_rms_mm: float | None
    """Of one that slides."""
    orders: tuple[float, ...] | None
    """Waves a turn that carry half of its square, the strongest first; over less than a turn no period is claimed."""
    waves_mm: tuple[float, ...] | None
    """Of a joint that slides: their lengths."""


class SmoothCorrection(Value):
    """What corrects a misfit that no effect explains, without physics."""

    depends_on: tuple[str, ...]
    limbs: tuple[int, ...]
    rms_mm: float
    """By which it moves the readings beyond what geometry would make up for."""
    heldout_rms_mm: BeforeAfter
    share_of_excess: float
    functions: tuple[JointFunction, ...] = ()
    """Of corrections in which each joint goes with its own angle or travel, the strongest first."""
    smooth: tuple[SmoothState, ...]
    """Functions that act together."""
    machine: MachineState
    """Geometry, effects and instrument as they are beside it."""


class PartialResiduals(Value):
    """Residuals as one number per reading, where the cause is seen best: at the joint, or where most is left."""

    of: str
    """What they are, in words."""
    unit: str
    without: str | None
    """The effect that is switched off in `before`; null where that is what geometry alone leaves."""
    before: Column
    after: Column

    @property
    def title(self) -> str:
        """What `before` is, in words."""
        return f"without {self.without.replace('_', ' ')}" if self.without else "geometry alone"


class Residuals(Value):
    """What every reading is off, before and after, where it was read and what the channels said there."""

    line: Counts
    position_mm: Rows
    before_mm: Rows
    after_mm: Rows
    channels: dict[str, Column]
    """By the names of the recording's columns; null: not recorded."""
    partial: PartialResiduals | None = None
    """Null in answers written before it was given."""


class SeenJoint(Value):
    """Between which angles of the turn a joint was read."""

    limb: int
    angles_deg: tuple[tuple[float, float], ...]


class Seen(Value):
    """Where joints with a periodic error were read, and how near to that the error is still known."""

    within_deg: float
    joints: tuple[SeenJoint, ...]


class Geometry(Value):
    """The calibration beside a diagnosis that found nothing else, to be compared with other sessions."""

    robot: RobotTables
    parameters: tuple[Parameter, ...]


class Diagnosed(Answer):
    """What every diagnosis says, at rest or in motion: contract, sections 4 and 8."""

    schema_: Literal["deltacal.diagnosis/1"] = "deltacal.diagnosis/1"
    verdict: Verdict
    summary: str
    """One paragraph that a maintenance engineer can act on."""
    location: Location
    """In motion its channels carry the number of their joint: `speed2`, `angle3`."""
    search: Searched | None = None
    """Null in answers written before it was told."""
    hints: tuple[Hint, ...] = ()
    """What is not named but may be there."""
    not_tested: tuple[Missing, ...]
    next_measurements: tuple[NextMeasurement, ...]
    gross_errors: tuple[int, ...]
    """Lines of the recording; in motion also those in which something was put right."""
    robot: RobotTables
    """The calibrated machine."""
    made: Made | None = None

    @property
    def headline(self) -> str:
        """Verdict and summary."""
        return f"{self.verdict.replace('_', ' ')}: {self.summary}"


class Diagnosis(Diagnosed, AtRest):
    """Where model and recording differ and which physics was left out: contract, section 4."""

    noise: NoiseLevel
    baseline: Baseline
    effects: tuple[Effect, ...]
    final: Final
    rejected: tuple[Rejected, ...]
    correction: SmoothCorrection | None
    residuals: Residuals
    physics: tuple[TermState, ...]
    """All that acts, in the order of `effects`; a periodic error of many orders is as many terms."""
    seen: Seen | None
    clock: Literal["time_s", "row"]
    """By what a moment was found: the time, or the row."""
    poses: tuple[int, ...] | None = None
    """Numbers of the poses, row by row, where a moment was found by its row and poses are numbered as measured."""
    parameters: tuple[Parameter, ...] | None = None
    """What is unknown of the instrument and has a name."""
    geometry: Geometry | None = None
    turned: str | None = None
    """What would explain the most if the direction of approach counted the other way, in words; null for none."""
    laws: tuple[Law, ...] = ()
    """What was found where no registered effect explains the misfit, the best first; it stands in `physics`."""

    @property
    def findings(self) -> tuple[Effect, ...]:
        """The effects without harmonics, which are one finding with their fundamental."""
        return tuple(e for e in self.effects if e.harmonic_of is None)

    def harmonics(self, of: Effect) -> tuple[Effect, ...]:
        """Return the harmonics that are one finding with an effect, if it is a fundamental that has some."""
        if not of.periods or of.harmonic_of is not None:
            return ()
        return tuple(e for e in self.effects if e.harmonic_of == of.periods[0] and e.limbs == of.limbs)

    def document(self) -> Document:
        """Yield the verdict, what was found, errors without and with it, what is suspected, and what to do next."""
        places, (unit, length) = self.robot.places, shown_in(self)
        yield Text(f": {self.summary}", self.verdict.replace("_", " "))
        yield from self._found()
        yield from (Text(words, level=1) for words in self._laws())
        rows = [
            (
                words,
                decimals(row.train_rms_mm / length),
                number(row.heldout_rms_mm and row.heldout_rms_mm / length),
                f"{row.chi2_per_dof:.2f}",
            )
            for words, row in (("geometry", self.baseline), ("with what was found", self.final))
        ]
        yield Table((f"{unit}, rms of the readings", "fitted", "held out", "chi2 per degree of freedom"), rows)
        yield from self._compared()
        for hint in self.hints:
            yield Text(f"suspected, p = {hint.p_value:.2g}: {hint.name}{places.at(hint.limbs)}; it {hint.why}", level=1)
        for question in self.next_measurements:
            clear = question.expected_chi2
            promise = "" if clear is None else f" (expected difference in chi2: {clear:.0f})"
            yield Text(f"next, {question.why}: {question.text}{promise}", level=1)
        for missing in dict.fromkeys(other.missing for other in self.not_tested):
            names = ", ".join(other.name for other in self.not_tested if other.missing == missing)
            yield Text(f"not tested: {names}; needs {missing}", level=1)
        if self.gross_errors:
            yield Text(f"outliers in lines {', '.join(map(str, self.gross_errors))}")
        yield from map(Text, put_right(self.motion.repairs if self.motion else ()))

    def _found(self) -> Iterator[Text | Table]:
        """Yield the parameters of the effects, and what they are indistinguishable from."""
        places, rows = self.robot.places, []
        for effect in self.effects:
            for p in effect.parameters:
                limb = "" if p.limb is None else places.number(p.limb)
                value, std = (p.value, "-") if isinstance(p.value, str) else rounded(p.value, p.std)
                rows.append((effect.name, limb, p.label, value, std, p.unit))
        if rows:
            yield Table(("effect", places.part, "parameter", "value", "std", "unit"), rows)
        for effect in self.findings:
            if effect.indistinguishable_from:
                others = ", ".join(effect.indistinguishable_from)
                yield Text(f"at these poses {effect.name} is indistinguishable from {others}", level=1)
            for limb, instead in (effect.instead_of_limb or {}).items():
                which = f"{effect.name}{places.at([int(limb)])} is indistinguishable from one{places.at(instead)}"
                yield Text(f"at these poses {which}", level=1)

    def _compared(self) -> Iterator[Table]:
        """Yield the hypotheses that the search compared, where there are several."""
        weighed = () if self.search is None else self.search.hypotheses
        rows = [
            (" + ".join(h.effects) or "geometry alone", "correlated" if h.correlated else "white", f"{h.cost_chi2:.1f}")
            for h in weighed
        ]
        if len(rows) > 1:
            yield Table(("hypothesis", "noise", "-2 log odds against it"), rows)

    def _laws(self) -> Iterator[str]:
        """Yield the laws that were found, the first with its coefficients."""
        places = self.robot.places
        for k, law in enumerate(self.laws):
            for term in law.terms:
                where = places.at(term.limbs)
                yield f"{'or' if k else 'law:'} {term.target} moves by {term.expression}{where}"
                for c in () if k else term.coefficients:
                    where = "" if c.limb is None else places.at([c.limb])
                    yield f"  {c.name} = {' +- '.join(rounded(c.value, c.std))} {c.unit}{where}"

    def table(self) -> tuple[EffectParameter, ...]:
        """Return the parameters of the effects that were found."""
        return tuple(p for effect in self.effects for p in effect.parameters)
