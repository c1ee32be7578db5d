"""batch.json of `batch`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value


class Failed(Value):
    """A recording that could not be done, and why."""

    recording: str
    machine: str
    error: str


class Diagnosed(Value):
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


class Identified(Value):
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


class Validated(Value):
    """A recording's line of the table."""

    recording: str
    machine: str
    after_mm: float
    worst_mm: float
    chi2_per_dof: float | None
    error: None
    warnings: str | None = None


Done = Diagnosed | Identified | Validated
Row = Done | Failed


class Moved(Value):
    """What moved in a machine from one recording to another."""

    machine: str
    from_: str
    to: str
    text: str


class Batch(Answer):
    """Many recordings: one row each, in the order of their paths, and what moved."""

    schema: Literal["deltacal.batch/1"] = "deltacal.batch/1"
    action: Literal["diagnose", "identify", "validate"]
    rows: tuple[Row, ...]
    changed: tuple[Moved, ...]
