"""batch.json of `batch`."""

from __future__ import annotations

from typing import ClassVar, Literal

from deltacal_gen.results.base import Answer, Value

Action = Literal["diagnose", "identify", "validate"]


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


Done = DiagnosedRow | IdentifiedRow | ValidatedRow
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
