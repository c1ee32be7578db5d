"""batch.json of `batch`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, ClassVar, Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.document import MOST_ROWS, Document, Table, Text, number, some

Action = Literal["diagnose", "identify", "validate"]
ASIDE = ("machine", "error", "warnings")  # of a row, told apart from the table
ByJoint = tuple[float | None, ...]
FEW = 3  # recordings that are named where many have the same to say


class FailedRow(Value):
    """A recording that could not be done, and why."""

    recording: str
    machine: str
    error: str

    warnings: ClassVar[None] = None


class DiagnosedRow(Value):
    """A recording's line of the table."""

    recording: str
    machine: str
    verdict: str
    effects: str
    model: str
    before_mm: float | None
    after_mm: float | None
    noise_mm: float
    error: None
    warnings: str | None = None
    law: str | None = None


class IdentifiedRow(Value):
    """A recording's line of the table."""

    recording: str
    machine: str
    model: str
    before_mm: float
    after_mm: float | None
    fitted_mm: float
    noise_mm: float
    error: None
    warnings: str | None = None


class ValidatedRow(Value):
    """A recording's line of the table."""

    recording: str
    machine: str
    after_mm: float
    worst_mm: float
    chi2_per_dof: float | None
    error: None
    warnings: str | None = None

    before_mm: ClassVar[None] = None


class DrivesRow(Value):
    """A line of a recording in motion (kind torque): figures joint by joint, null of one that did not move."""

    recording: str
    machine: str
    unit_by_joint: tuple[str, ...]
    error: None
    warnings: str | None = None

    before_mm: ClassVar[None] = None
    after_mm: ClassVar[None] = None


class DiagnosedDrivesRow(DrivesRow):
    """A recording's line of the table."""

    verdict: str
    effects: str
    model: str
    before_by_joint: ByJoint
    after_by_joint: ByJoint
    noise_by_joint: ByJoint
    law: str | None = None


class IdentifiedDrivesRow(DrivesRow):
    """A recording's line of the table."""

    model: str
    after_by_joint: ByJoint
    fitted_by_joint: ByJoint
    noise_by_joint: ByJoint


class ValidatedDrivesRow(DrivesRow):
    """A recording's line of the table."""

    after_by_joint: ByJoint
    readings: int
    chi2_per_dof: float | None


Done = DiagnosedRow | IdentifiedRow | ValidatedRow | DiagnosedDrivesRow | IdentifiedDrivesRow | ValidatedDrivesRow
Row = Done | FailedRow


class Moved(Value):
    """What moved in a machine from one recording to another."""

    machine: str
    from_: str
    to: str
    text: str


class Batch(Answer):
    """Many recordings: one row each, in the order of their paths, and what moved."""

    schema: Literal["deltacal.batch/1"] = "deltacal.batch/1"
    action: Action
    rows: tuple[Row, ...]
    changed: tuple[Moved, ...]
    passed_over: tuple[str, ...] | None = None
    """Tables in the folder that are no recordings, and nothing that is imported; left out where there are none."""

    @property
    def headline(self) -> str:
        """How many recordings, and how many failed."""
        failed = sum(row.error is not None for row in self.rows)
        return f"{self.action}: {len(self.rows)} recordings, {failed} failed, {len(self.changed)} changes"

    def table(self) -> tuple[Row, ...]:
        """Return a row for each recording."""
        return self.rows

    @property
    def columns(self) -> list[str]:
        """The keys of its table."""
        return [c for c in dict.fromkeys(k for r in self.rows for k, _ in r.written()) if c not in ASIDE]

    def document(self) -> Document:
        """Yield a row for each recording, what moved, common laws, failures and warnings."""
        columns, rows = self.columns, self.rows
        cells = ([getattr(r, c, None) for c in columns] for r in worst(rows, MOST_ROWS))
        shown = [tuple(number(c) if isinstance(c, float) else str(in_table(c)) for c in row) for row in cells]
        yield Table(tuple(c.replace("_", " ") for c in columns), shown)
        if len(rows) > MOST_ROWS:
            yield Text(f"These are the {MOST_ROWS} with the largest errors.")
        yield from (Text(f" after {c.from_}: {c.text}", c.to) for c in self.changed[:MOST_ROWS])
        if len(self.changed) > MOST_ROWS:
            yield Text(f"{len(self.changed) - MOST_ROWS} more comparisons are in the run's page")
        yield from self._aside()

    def _aside(self) -> Iterator[Text]:
        failed = alike([(r.recording, r.error) for r in self.rows if r.error is not None])
        warned = alike([(r.recording, r.warnings) for r in self.rows if r.warnings])
        for words, told in (("failed", failed), ("warning", warned)):
            yield from (Text(f"{words}: {names}: {why}") for names, why in told[:MOST_ROWS])
        if self.passed_over:
            yield Text(f"passed over: {some(self.passed_over, FEW)}: no recordings")
        done = sum(r.error is None for r in self.rows)
        yield Text(f"{done} of {len(self.rows)} recordings done")

    def summary(self) -> str:
        """Return the answer as text, as `print` shows it."""
        return str(self)


def _listed(names: Sequence[str]) -> str:
    return some(names, FEW)


def worst(rows: Sequence[Row], most: int) -> list[Row]:
    """Return the rows of a batch, in their order; of too many, those with the largest errors first."""
    if len(rows) <= most:
        return list(rows)
    done = [r for r in rows if not isinstance(r, FailedRow)]
    return [*sorted(done, key=lambda r: -(r.after_mm or 0.0))[:most]]


def in_table(value: Any) -> Any:
    """Return a value as it stands in a table: joints side by side, blank where there is none."""
    if isinstance(value, tuple):
        return " ".join("-" if v is None else f"{v:.4g}" if isinstance(v, float) else str(v) for v in value)
    return "" if value is None else value


def alike(said: Sequence[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return recordings of which the same is said, together: (the first of them and how many more, what is said)."""
    by_text: dict[str, list[str]] = {}
    for name, text in said:
        by_text.setdefault(text, []).append(name)
    return [(_listed(names), text) for text, names in by_text.items()]
