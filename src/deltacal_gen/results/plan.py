"""PLAN.json of `plan`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.document import Document, Table, Text, number

MOST_NOTES = 4  # that are shown
Method = Literal["rings", "edges", "joints", "singular", "d-optimal"]


class JointsOf(Value):
    """Joints under the key of their unit."""

    joints_deg: tuple[float, ...] | None = None
    joints_mm: tuple[float, ...] | None = None
    joints: tuple[float, ...] | None = None
    """Of a machine that has joints of both kinds: deg and mm."""


class PlannedPose(JointsOf):
    """A pose to be measured; its joints under the key of their unit."""

    target_mm: tuple[float, ...]
    tool_mm: tuple[float, ...]


class Deviation(Value):
    """What noise will leave of a parameter."""

    name: str
    std: float
    unit: str


class Expected(Value):
    """What noise will leave, by unweighted least squares."""

    sigma_mm: float
    parameters: tuple[Deviation, ...]
    tool_mean_mm: float
    tool_max_mm: float


class Planned(Answer):
    """How well what was planned determines a model. Figures stand set by set, or run by run with those before it."""

    schema_: Literal["deltacal.plan/1"] = "deltacal.plan/1"
    robot: str
    mechanism: str
    model: str
    parameters: tuple[str, ...]
    """What is to be found; in motion base parameters, dry and viscous friction of every joint."""
    n: tuple[int, ...]
    readings: tuple[int, ...]
    condition: tuple[float | None, ...]
    """Null where it is infinite; in motion of columns of one size, torques by what each joint gives at most."""
    O1: tuple[float, ...]
    O2: tuple[float, ...]
    O3: tuple[float, ...]
    O4: tuple[float, ...]
    O5: tuple[float, ...]


class Plan(Planned):
    """Measuring poses and how they were chosen. Figures stand set by set; null stands for what is infinite."""

    dropped: tuple[str, ...]
    """Parameters that no poses tell from the others."""
    method: Method
    conventions: str
    kind: str
    scaling: str
    norm: str
    tools_mm: tuple[tuple[float, ...], ...]
    layers: tuple[float, ...]
    start_angle_deg: float
    threshold: float
    pose_count: tuple[int, ...]
    rank: tuple[int, ...]
    corrected: tuple[float | None, ...]
    change: tuple[float | None, ...]
    chosen: int | None
    settled: int | None
    poses: tuple[PlannedPose, ...]
    prediction: Expected | None
    notes: tuple[str, ...] | None = None
    """What became of poses where the machine may not stand."""

    @property
    def headline(self) -> str:
        """How many poses, and for what."""
        return f"{len(self.poses)} poses for {self.model}, {self.method}"

    def table(self) -> tuple[PlannedPose, ...]:
        """Return the poses."""
        return self.poses

    def document(self) -> Document:
        """Yield how well the sets of poses tell, and which was chosen."""
        yield Text(self.conventions)
        if self.n:
            columns = (self.n, self.pose_count, self.rank, self.condition, self.change, self.O1, self.O3)
            rows = [
                (
                    f"{n} <-" if n == self.chosen else str(n),
                    str(poses),
                    str(rank),
                    number(condition),
                    "-" if change is None else f"{100 * change:.2f} %",
                    number(o1),
                    number(o3),
                )
                for n, poses, rank, condition, change, o1, o3 in zip(*columns, strict=True)
            ]
            yield Table(("n", "poses", "rank", "condition", "change", "O1", "O3"), rows)
        notes = self.notes or ()
        yield from (Text(note, level=1) for note in notes[:MOST_NOTES])
        if len(notes) > MOST_NOTES:
            yield Text(f"and {len(notes) - MOST_NOTES} more poses likewise", level=1)
        yield Text(f"chosen: {self.chosen}, {len(self.poses)} poses")


class Visit(JointsOf):
    """A row to be measured: joints under the key of their unit, and from which side each of them comes."""

    approach: tuple[int, ...]
    cycle: int | None = None


class CyclePlan(Answer):
    """Joints that are gone through from both sides: one axis in cycles, or joints behind second encoders."""

    schema_: Literal["deltacal.cycles/1"] = "deltacal.cycles/1"
    robot: str
    mechanism: str
    kind: str
    positions: int
    cycles: int | None
    """Of one axis, each forth and back; null of several joints."""
    conventions: str
    poses: tuple[Visit, ...]

    @property
    def headline(self) -> str:
        """How many rows."""
        return f"{len(self.poses)} rows: {self.conventions}"

    def table(self) -> tuple[Visit, ...]:
        """Return the rows."""
        return self.poses

    def document(self) -> Document:
        """Yield how many rows there are."""
        yield Text(self.headline)


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


class MotionPlan(Planned):
    """PLAN.json of kind torque: exciting trajectories."""

    kind: Literal["torque"]
    method: Literal["fourier"]
    runs: int
    period_s: float
    harmonics: int
    rate_Hz: float
    log_determinant: float
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
