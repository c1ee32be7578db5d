"""STUDY.json and PLAN.json of kind torque: what a trajectory tells of bodies and drives."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.document import Document, Table, Text, number
from deltacal_gen.results.motion import ByJoint, by_limb
from deltacal_gen.results.parts import Missing, RobotTables
from deltacal_gen.results.result import OpenCombination
from deltacal_gen.results.study import Suspect, suspected


class ToldParameter(Value):
    """How well a base parameter is found, in its own unit."""

    name: str
    combination: str
    unit: str
    drawn_std: float
    std: float
    """Of estimate minus truth."""
    bias: float
    predicted_std: float | None
    """What the linear problem expects of `std`; null where the trajectory does not tell it."""
    stated_std: float
    """What an identification will say."""


class TorqueSpread(Value):
    """What is predicted wrong of a joint's torque on other movements, over all machines, in `unit`."""

    limb: int
    unit: str
    before_rms: float
    """By the bodies of the robot file."""
    after_rms: float
    """As identified."""
    p95: float
    """Of the machines' own rms, 95 % lie below."""
    predicted_rms: float | None
    """What the linear problem expects of `after_rms`; null where the trajectory leaves something open."""
    readings: int
    """In motion."""


class TorqueAddition(Value):
    """What a further movement leaves of the errors of the joints that move, by the linear problem."""

    add: str
    rms_by_joint: ByJoint


class MotionStudy(Answer):
    """STUDY.json of kind torque: what a trajectory will tell of bodies and drives."""

    model: str
    schema: Literal["deltacal.study/1"] = "deltacal.study/1"
    robot: RobotTables
    kind: Literal["torque"]
    readings: int
    runs: int
    sigma_by_joint: tuple[float, ...]
    unit_by_joint: tuple[str, ...]
    machines: int
    seed: int
    parameters: tuple[ToldParameter, ...]
    torque: tuple[TorqueSpread, ...]
    """Of the joints that move."""
    unidentifiable: tuple[OpenCombination, ...]
    suspects: tuple[Suspect, ...]
    channels_wanted: tuple[Missing, ...]
    add: tuple[TorqueAddition, ...]
    notes: tuple[str, ...]
    """Limits that were assumed."""

    @property
    def headline(self) -> str:
        """What is predicted wrong, joint by joint."""
        before = by_limb(((t.before_rms, t.unit) for t in self.torque), 3)
        after = by_limb(((t.after_rms, t.unit) for t in self.torque), 3)
        return f"{self.model}: torques off by {before} as drawn, {after} identified ({self.machines} machines)"

    def table(self) -> tuple[ToldParameter, ...]:
        """Return how well each base parameter is found."""
        return self.parameters

    def document(self) -> Document:
        """Yield errors of torques, base parameters, suspects, and what a further movement would bring."""
        rows = [
            (f"joint {t.limb}", *(_blank(v) for v in (t.before_rms, t.after_rms, t.p95, t.predicted_rms)), t.unit)
            for t in self.torque
        ]
        head = ("torque on other movements", "as drawn", "identified", "95 % of machines", "predicted", "unit")
        yield Table(head, rows)
        known = [
            (p.name, *(_blank(v, "not told") for v in (p.drawn_std, p.std, p.predicted_std, p.stated_std)), p.unit)
            for p in self.parameters
        ]
        yield Table(("base parameter", "drawn", "std", "predicted", "stated", "unit"), known)
        yield from suspected(self.suspects, self.channels_wanted, self.robot.places, "joint")
        yield from (Text(f"{a.add}: {', '.join(number(v, 3) for v in a.rms_by_joint)}") for a in self.add)
        yield from (Text(note, level=1) for note in self.notes)


def _blank(value: float | None, otherwise: str = "") -> str:
    return otherwise if value is None else number(value, 3)


class JointSeries(Value):
    """A joint's movement in one run: its speed is the sum of cosine_k cos(2 pi k t / period) and sine_k sin of that."""

    run: int
    joint: int
    unit: str
    """Of the place; the others are speeds, per second."""
    centre: float
    """Where it begins and ends."""
    cosine: tuple[float, ...]
    sine: tuple[float, ...]


class MotionPlan(Answer):
    """PLAN.json of kind torque: exciting trajectories. Figures stand run by run, each with those before it."""

    schema: Literal["deltacal.plan/1"] = "deltacal.plan/1"
    robot: str
    mechanism: str
    model: str
    kind: Literal["torque"]
    method: Literal["fourier"]
    parameters: tuple[str, ...]
    """What is to be told: base parameters, dry and viscous friction of every joint."""
    runs: int
    period_s: float
    harmonics: int
    rate_Hz: float
    n: tuple[int, ...]
    readings: tuple[int, ...]
    condition: tuple[float | None, ...]
    """Columns of one size, torques by what each joint gives at most; null where it is infinite."""
    log_determinant: float
    O1: tuple[float, ...]
    O2: tuple[float, ...]
    O3: tuple[float, ...]
    O4: tuple[float, ...]
    O5: tuple[float, ...]
    chosen: int
    series: tuple[JointSeries, ...]
    notes: tuple[str, ...]
    """Limits that were assumed."""

    @property
    def headline(self) -> str:
        """How many movements, and how well they tell."""
        last = self.condition[-1]
        told = "infinite" if last is None else f"{last:.3g}"
        return f"{self.runs} runs of {self.period_s:g} s for {self.model}: condition number {told}"

    def table(self) -> tuple[JointSeries, ...]:
        """Return the series."""
        return self.series

    def document(self) -> Document:
        """Yield how well the movements tell, run by run."""
        yield Text(self.headline)
        each = zip(self.n, self.readings, self.condition, self.O1, self.O3, strict=True)
        rows = [(str(n), str(readings), *map(number, figures)) for n, readings, *figures in each]
        yield Table(("runs", "readings", "condition", "O1", "O3"), rows)
        yield from (Text(note, level=1) for note in self.notes)

    def summary(self) -> str:
        """Return the answer as text."""
        return self.headline
