"""PLAN.json of kind torque: what a trajectory tells of bodies and drives."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.document import Document, Table, Text, number


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

    schema_: Literal["deltacal.plan/1"] = "deltacal.plan/1"
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
