"""RESULT.json and DIAGNOSIS.json of recordings in motion: kind torque (contract, second part, section 8).

Their keys are those of answers of machines at rest wherever these have a meaning in motion, and so is `schema`; `kind`
tells them apart.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import ClassVar, Literal

from deltacal_gen.results.base import Answer, Column, Numbers, Value
from deltacal_gen.results.diagnosis import Diagnosed, Effect, EffectParameter, LawOf, NextMeasurement, Rejected
from deltacal_gen.results.document import Document, Text
from deltacal_gen.results.parts import Derivatives, RobotTables, Source, put_right
from deltacal_gen.results.result import Identified, OpenCombination, Parameter
from deltacal_gen.results.validation import Validated

ByJoint = tuple[float | None, ...]  # null of a joint that does not move in the recording


class Left(Value):
    """What a model leaves of the readings of samples in motion, all joints together and joint by joint.

    Together only where all joints are read in one unit. `_by_joint` are in `unit_by_joint`; `_filtered` are of readings
    and model both through the low-pass of the joints.
    """

    model: str | None = None
    train_rms: float | None = None
    heldout_rms: float | None = None
    train_rms_by_joint: ByJoint
    heldout_rms_by_joint: ByJoint
    heldout_rms_by_joint_filtered: ByJoint
    unit_by_joint: tuple[str, ...]
    chi2_per_dof: float | None = None
    """Where the noise is declared."""


class MotionNoise(Value):
    """Noise of single readings."""

    sigma: float | None = None
    sigma_by_joint: ByJoint
    unit_by_joint: tuple[str, ...]
    source: Source
    of_joints_by_joint: ByJoint = ()
    """What noise of velocities and accelerations adds to it, beside what the readings have of their own."""
    of_geometry_by_joint: ByJoint = ()
    """What the robot file's tolerances add that neither bodies nor friction take up; null where it says none."""
    together_by_joint: ByJoint
    """So many samples tell as much as one whose noise is its own."""


class TorqueTerm(Value):
    """An effect on the torque of a joint, in internal units (mm, rad, N, s, K; A or 1 where the reading is so)."""

    effect: str
    constants: tuple[float, ...]
    values: tuple[float, ...]


class JointUncertainty(Value):
    """How surely the reading of a joint is known: what bands are made of, in internal units."""

    factor: Numbers
    """Lower triangle, row by row, of L with covariance L L': of `coefficients`, `payload`, the values of `terms`, and
    the logarithms of the sizes in them."""
    scatter: float
    """By which single readings of runs that took no part depart beside it, noise and what the model leaves out."""
    degrees: float
    """Of freedom, on which this rests: samples that hang together count as one."""
    shown: float | None = None
    """Standard deviation of what coefficients predict, the largest of all samples of the fit."""
    delay_std: float | None = None
    """Of `delay` [s]."""


class JointModel(Value):
    """What predicts the reading of a joint, in internal units."""

    joint: int
    columns: tuple[int, ...]
    """Inertial parameters that have a coefficient, by their number in `inertial`."""
    coefficients: tuple[float, ...]
    payload: float | None = None
    """What the reading is per torque of the payload, where that had to be found."""
    terms: tuple[TorqueTerm, ...]
    at_rest_below: float
    """Speed [rad/s or mm/s]."""
    delay: float | None = None
    """By which readings come late [s]."""
    uncertainty: JointUncertainty | None = None


class PayloadState(Value):
    """What a payload has beyond what is written: mass [kg], centre from the tool point [mm]."""

    setup: str
    """No name where the recording has one set-up alone."""
    mass: float
    centre: tuple[float, ...]


class KnownMachine(Value):
    """What is taken as known of a machine, as its file states it [kg, mm]."""

    inertial: tuple[float, ...]
    """By the names of `inertial` beside it; 0 of what was found."""
    payloads: tuple[PayloadState, ...]


class RungOf(Value):
    """A rung of a joint's ladder."""

    limb: int
    name: str
    buys: float
    """Part of the held-out rms that it takes away beside the other rungs."""
    gain_chi2: float


class LadderOf(Value):
    """The ladder of a joint: what it has beside the rigid machine, and what each rung buys."""

    limb: int
    unit: str
    rungs: tuple[RungOf, ...]
    stops: str
    """Why no further rung is taken."""


class Unexplained(Value):
    """A joint that no rung explains, and what the rest depends on."""

    limb: int
    channel: str
    share: float
    """Part of the held-out rms that a smooth function of that channel would take away."""
    text: str


class InertialParameter(Parameter):
    """A base parameter, named after the first parameter of its combination; actual minus robot file."""

    combination: str | None = None
    """Absent of a clock, which is no part of the machine."""
    limb: int | None = None
    """Whose reading knows it, where what the drives give per torque is unknown."""


class Trace(Value):
    """Some samples of a joint, to be drawn; readings and errors in `unit`, joints in deg or mm, blank at rest."""

    limb: int
    unit: str
    slides: bool
    time: Column
    """In a row, from the middle of a movement [s]."""
    measured: Column
    before: Column
    """As the rigid machine alone predicts it."""
    after: Column
    speed: Column
    """Over the whole recording, from here on."""
    position: Column
    load: Column
    """What the rigid machine asks of the joint."""
    error_before: Column
    error_after: Column


class Consistent(Value):
    """An inertial parameter of bodies that could be built: positive masses, positive definite inertias; as it is."""

    name: str
    value: float
    unit: str


class MotionModel(Answer):
    """What results and diagnoses of recordings in motion have in common."""

    unit_mm: ClassVar[float] = 1.0  # of drives there is one unit alone
    final: Left
    kind: Literal["torque"]
    motion: Derivatives
    inertial: tuple[str, ...]
    """Names of all inertial parameters, body by body."""
    known: KnownMachine | None
    """Null where all bodies were found."""
    joints: tuple[JointModel, ...]
    """Of the joints that move."""
    columns: tuple[str, ...]
    """Of the readings, joint by joint."""
    robot: RobotTables
    parameters: tuple[InertialParameter, ...]
    """Base parameters of the rigid machine, beside all that was found; then two clocks, if there are."""
    rank: int | None = None
    """How many base parameters there are; absent in diagnoses that older versions wrote, as all that follows."""
    rank_tolerance: float | None = None
    singular_values: Numbers | None = None
    """Of the columns of the base parameters, each of size 1, over all readings by their noise."""
    condition: float | None = None
    scaling: str = ""
    unidentifiable: tuple[OpenCombination, ...] = ()
    """What no torque knows: parameters, and combinations that leave every torque as it is."""
    consistent: tuple[Consistent, ...] | None = None
    """Bodies that could be built; absent where what the drives give per torque is unknown."""
    consistent_off: float | None = None
    """By how much base parameters of these bodies are off those that were found: rms, in standard deviations."""
    traces: tuple[Trace, ...]
    gross_errors: tuple[int, ...]
    """Lines of the recording in which something was put right or left out: `motion.repairs` says what."""

    @property
    def unit(self) -> str | None:
        """In which all joints together are read."""
        return next(iter(self.final.unit_by_joint), None)

    @property
    def base(self) -> tuple[InertialParameter, ...]:
        """Base parameters alone."""
        return tuple(p for p in self.parameters if p.combination is not None)

    @property
    def has_law(self) -> bool:
        """Whether a joint has a law that nobody has registered."""
        return bool(getattr(self, "laws", ()))

    def document(self) -> Document:
        """Yield headline and table, and what was put right in the recording."""
        yield from super().document()
        yield from map(Text, put_right(self.motion.repairs))


class MotionResult(Identified, MotionModel):
    """The rigid machine in motion: contract, second part, section 8."""

    next_measurements: tuple[NextMeasurement, ...]
    noise: MotionNoise
    train_rms: float | None = None
    heldout_rms: float | None = None
    sigma: float | None = None
    friction: str | None = None
    """What friction, which is no part of the model, does to its parameters: where there is some."""

    @property
    def headline(self) -> str:
        """What the rigid machine leaves."""
        told = len(self.base)
        known = f"{told}" if self.rank == told else f"{self.rank} of {told}"
        left = f"{self.model}: {known} base parameters; held-out rms {by_joint(self.final)}"
        said = [*([self.friction] if self.friction else []), *(f"warning: {words}" for words in self.doubts or ())]
        return "; ".join([left, *said])

    def table(self) -> tuple[InertialParameter, ...]:
        """Return the base parameters."""
        return self.parameters


class TorqueEffect(Effect):
    """An effect on the torque, over all joints that have it."""

    heldout_gain: tuple[float, ...]
    """Part of the held-out rms that it takes away, joint by joint of `limbs`."""
    common: tuple[EffectParameter, ...] | None = None
    """One value for all of `limbs`, where those of the joints agree within their deviations: `p_value` charges it once.
    """


class HeldOut(Value):
    """What is left of held-out samples, together and joint by joint; null where the joint has nothing of it."""

    heldout_rms: float | None = None
    heldout_rms_by_joint: ByJoint
    unit_by_joint: tuple[str, ...] = ()


class TorqueRejected(Rejected, HeldOut):
    """An effect that was looked at and not named, with what would be left of held-out samples with it."""


class TorqueLaw(LawOf, HeldOut):
    """A law of drives."""


class MotionDiagnosis(Diagnosed, MotionModel):
    """Which friction and relatives of it a machine in motion has: contract, second part, section 8."""

    noise: MotionNoise
    baseline: Left
    effects: tuple[TorqueEffect, ...]
    ladder: tuple[LadderOf, ...]
    unexplained: tuple[Unexplained, ...]
    rejected: tuple[TorqueRejected, ...]
    laws: tuple[TorqueLaw, ...] = ()
    """At most one: of every joint that has one a term or more, each at its joint."""

    def table(self) -> tuple[RungOf, ...]:
        """Return the rungs, joint by joint, the one that buys most first."""
        return tuple(rung for ladder in self.ladder for rung in ladder.rungs)


class Worst(Value):
    """A reading and what it is off, in the unit of its joint."""

    line: int
    limb: int
    error: float
    unit: str


class MotionValidation(Validated):
    """The error of a model on samples in motion that it has not seen."""

    unit_mm: ClassVar[float] = 1.0  # of drives there is one unit alone
    kind: Literal["torque"]
    rms: float | None = None
    rms_by_joint: ByJoint
    rms_by_joint_filtered: ByJoint
    unit_by_joint: tuple[str, ...]
    noise: MotionNoise
    """As the result knows it."""
    at_rest: int
    """Readings at rest, which took no part."""
    rows: tuple[Worst, ...]
    """The worst first."""
    unshown_by_joint: tuple[int, ...] = ()
    """Samples that ask of a joint what the recording of the model did not show."""

    @property
    def unit(self) -> str | None:
        """In which all joints together are read."""
        return next(iter(self.unit_by_joint), None)

    @property
    def headline(self) -> str:
        """The error, joint by joint."""
        each = zip(self.rms_by_joint, self.unit_by_joint, strict=True)
        return f"{self.readings} readings in motion: rms {by_limb(each)}"

    def _beside(self) -> tuple[str, ...]:
        words = not_shown(self.unshown_by_joint)
        return () if words is None else (words,)


def not_shown(samples: Sequence[int]) -> str | None:
    """Return in words of which joints a recording asks what that of a model did not show; None where of none."""
    each = [f"joint {j} in {n} samples" for j, n in enumerate(samples, start=1) if n]
    if not each:
        return None
    return (
        f"{', '.join(each)}: this movement asks for what the model's recording did not show, and what is foretold is "
        "far less sure there than a reading; in that recording all joints must move at once"
    )


def by_joint(left: Left) -> str:
    """Return held-out figures in words."""
    return by_limb(zip(left.heldout_rms_by_joint, left.unit_by_joint, strict=True))


def by_limb(each: Iterable[tuple[float | None, str]]) -> str:
    """Return figures of joints with their units, in words."""
    values = list(each)
    units = {unit for _, unit in values}
    texts = ["-" if v is None else f"{v:.4g}" + (f" {unit}" if len(units) > 1 else "") for v, unit in values]
    return ", ".join(texts) + (f" {units.pop()}" if len(units) == 1 else "")
