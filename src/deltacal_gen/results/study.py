"""STUDY.json of `study`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import ClassVar, Literal

from deltacal_gen.results.base import Answer, Counts, Numbers, Value, shown_in
from deltacal_gen.results.document import Document, Table, Text, number
from deltacal_gen.results.parts import EffectName, Missing, RobotTables
from deltacal_gen.results.places import Places


class StudyParameter(Value):
    """How well a parameter is found, in its own unit."""

    name: str
    unit: str
    drawn_std: float
    std: float
    """Of estimate minus truth."""
    bias: float
    predicted_std: float
    """What the linear problem expects of `std`."""
    stated_std: float
    """What a calibration will say."""


class Histogram(Value):
    """How many machines lie between the edges."""

    edges_mm: Numbers
    count: Counts


class Spread(Value):
    """Position errors of all machines; of each its root mean square over the workspace, and its largest."""

    rms_mm: float
    median_mm: float
    p95_mm: float
    worst_median_mm: float
    worst_p95_mm: float
    histogram: Histogram
    predicted_rms_mm: float | None = None

    @property
    def cells(self) -> tuple[str, ...]:
        """Its figures as a row of a table."""
        predicted = "" if self.predicted_rms_mm is None else f"{self.predicted_rms_mm:.4f}"
        return f"{self.rms_mm:.4f}", f"{self.p95_mm:.4f}", f"{self.worst_p95_mm:.4f}", predicted


class Position(Value):
    """The position over the workspace, as built and calibrated."""

    aligned: bool
    """Whether a motion of the map as a whole is taken off."""
    points: int
    before: Spread
    after: Spread


class Suspect(Value):
    """How often effects that were concealed were named."""

    effects: tuple[EffectName, ...]
    """None: nothing was concealed."""
    recordings: int
    named_right: int
    named_among_equals: int
    """Named, or named indistinguishable from what was named."""
    chance: float | None
    interval: tuple[float, float]
    """That holds the chance with 95 %."""
    instead: dict[str, int]
    before_mm: float | None
    after_mm: float | None
    next: tuple[str, ...]
    failed: tuple[str, ...]


def suspected(suspects: Sequence[Suspect], wanted: Sequence[Missing], places: Places) -> Iterator[Text]:
    """Yield how often what was concealed was named, and what cannot be found without which channel."""
    for s in suspects:
        words = " and ".join(f"{e.name}{places.at(e.limbs)}" for e in s.effects) or "nothing"
        low, high = s.interval
        yield Text(
            f"{words} concealed: said so in {s.named_right} of {s.recordings} recordings "
            f"(95 %: {low:.0%} to {high:.0%})"
        )
        yield from (Text(f"not simulated: {why}", level=1) for why in s.failed)
    yield from (Text(f"{c.name} cannot be found without {c.missing}") for c in wanted)


class Times(Value):
    """What so many times the plan's readings leave."""

    times: float
    rms_mm: float


class Addition(Value):
    """What a further measurement leaves."""

    add: str
    rms_mm: float
    gain: float
    """Part of the error that it takes off."""


class Advice(Value):
    """What more measuring would bring, by the linear problem."""

    rms_mm: float
    enough: tuple[Times, ...]
    doubling: float
    """Part of the error that twice the readings take off."""
    worth: bool
    add: tuple[Addition, ...]


class Study(Answer):
    """What a measuring plan will give."""

    lengths: ClassVar[re.Pattern[str]] = re.compile("sigma_mm")  # positions stand in mm alone
    model: str
    schema_: Literal["deltacal.study/1"] = "deltacal.study/1"
    robot: RobotTables
    kind: str
    readings: int
    poses: int
    sigma_mm: float
    """Noise of a coordinate at the platform; in the unit of readings beside it."""
    turn_sigma_deg: float | None = None
    """Noise of rotations, where they are read."""
    unit: str | None = None
    """Of readings that are no lengths: px, deg."""
    unit_mm: float | None = None
    """What it is at the platform."""
    machines: int
    lost: int
    """Machines that could not be simulated or calibrated."""
    seed: int
    parameters: tuple[StudyParameter, ...]
    position: Position | None
    """None of readings of joints, which see no source error."""
    suspects: tuple[Suspect, ...]
    channels_wanted: tuple[Missing, ...]
    advice: Advice | None

    @property
    def noise(self) -> float:
        """Noise of a reading in its unit."""
        return self.sigma_mm / shown_in(self)[1]

    @property
    def noise_told(self) -> str:
        """Noise of a reading in words."""
        turns = "" if self.turn_sigma_deg is None else f" and {self.turn_sigma_deg:.3g} deg"
        return f"{self.noise:.6g} {shown_in(self)[0]}{turns}"

    @property
    def headline(self) -> str:
        """What the plan leaves."""
        if self.position is None:
            named = sum(s.named_right for s in self.suspects)
            return f"{self.model}: {named} of {sum(s.recordings for s in self.suspects)} diagnoses name what is there"
        before, after = self.position.before, self.position.after
        errors = f"{before.rms_mm:.4g} mm as built, {after.rms_mm:.4g} mm calibrated"
        return f"{self.model}: {errors} ({self.machines} machines)"

    def table(self) -> tuple[StudyParameter, ...]:
        """Return how well each parameter is found."""
        return self.parameters

    def document(self) -> Document:
        """Yield errors, parameters, suspects, and what more measuring would bring."""
        position, advice = self.position, self.advice
        told = suspected(self.suspects, self.channels_wanted, self.robot.places)
        if position is None or advice is None:
            yield Text(f"{self.model}: these readings see no source error; noise {self.noise_told}")
            yield from told
            return
        head = ("position over the workspace, mm", "rms", "95 % of machines", "largest, 95 %", "predicted rms")
        stages = ((position.before, "as built"), (position.after, f"calibrated, {self.model}"))
        yield Table(head, [(words, *spread.cells) for spread, words in stages])
        known = [
            (q.name, *(number(v, 3) for v in (q.drawn_std, q.std, q.predicted_std)), q.unit) for q in self.parameters
        ]
        yield Table(("parameter", "drawn", "std", "predicted", "unit"), known)
        yield from told
        if self.unit is not None or self.turn_sigma_deg is not None:
            yield Text(f"The noise of each coordinate is {self.noise_told}.")
        yield Text(f"Twice the readings reduce the error by {advice.doubling:.0%}.")
        yield from (Text(f"{g.add}: {g.gain:.0%} less") for g in advice.add)
        if self.lost:
            yield Text(f"{self.lost} machines could not be simulated or calibrated, and are not counted")
