"""batch.json of `batch`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.document import MOST_ROWS, Document, Table, Text, columns, number, some

Action = Literal["diagnose", "identify", "validate"]
ASIDE = ("machine", "error", "warnings")  # of a row, told apart from the table
ByJoint = tuple[float | None, ...]
FEW = 3  # recordings that are named where many have the same to say


class Row(Value):
    """A recording's line of the table: figures in mm, or joint by joint of one in motion (kind torque)."""

    recording: str
    machine: str
    verdict: str | None = None
    effects: str | None = None
    law: str | None = None
    model: str | None = None
    before_mm: float | None = None
    after_mm: float | None = None
    fitted_mm: float | None = None
    worst_mm: float | None = None
    noise_mm: float | None = None
    unit_by_joint: tuple[str, ...] | None = None
    before_by_joint: ByJoint | None = None
    after_by_joint: ByJoint | None = None
    fitted_by_joint: ByJoint | None = None
    noise_by_joint: ByJoint | None = None
    readings: int | None = None
    chi2_per_dof: float | None = None
    error: str | None
    """Why it could not be done; null where it was."""
    warnings: str | None = None

    @property
    def in_mm(self) -> bool:
        """Whether it was done and its figures are lengths."""
        return self.error is None and self.unit_by_joint is None


class Moved(Value):
    """What moved in a machine from one recording to another."""

    machine: str
    from_: str
    to: str
    text: str


class Batch(Answer):
    """Many recordings: one row each, in the order of their paths, and what moved."""

    schema_: Literal["deltacal.batch/1"] = "deltacal.batch/1"
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
        found = columns([row.to_dict() for row in self.rows])
        return [c for c in found if c not in ASIDE]

    def document(self) -> Document:
        """Yield a row for each recording, what moved, common laws, failures and warnings."""
        head, rows = self.columns, self.rows
        cells = ([getattr(r, c) for c in head] for r in worst(rows, MOST_ROWS))
        shown = [tuple(number(c) if isinstance(c, float) else str(in_table(c)) for c in row) for row in cells]
        yield Table(tuple(c.replace("_", " ") for c in head), shown)
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


def worst(rows: Sequence[Row], most: int) -> list[Row]:
    """Return the rows of a batch, in their order; of too many, those with the largest errors first."""
    if len(rows) <= most:
        return list(rows)
    done = [r for r in rows if r.error is None]
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
    return [(some(names, FEW), text) for text, names in by_text.items()]
