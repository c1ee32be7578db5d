"""The answer of `certificate`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Value, shown_in
from deltacal_gen.results.document import Document, Table, Text, decimals
from deltacal_gen.results.parts import Made, OfReadings
from deltacal_gen.results.validation import Iso230, Iso9283, Placed


class Party(Value):
    """A laboratory, a customer or a maker; what is null was not stated."""

    name: str | None = None
    street: str | None = None
    city: str | None = None
    country: str | None = None
    """Two capital letters, ISO 3166-1."""


class Errors(Value):
    """What readings are off, against what a machine is predicted to read."""

    of: Literal["as drawn", "calibrated"]
    rms_mm: float
    """Of each measured scalar."""
    mean_mm: float
    """Of the lengths of the errors."""
    worst_mm: float


class Contribution(Value):
    """A line of the uncertainty budget."""

    source: str
    evaluation: Literal["A", "B"]
    """By statistics of readings, or by other means (GUM, 4.2 and 4.3)."""
    degrees: float | None
    """Of freedom; null: a value that is taken as known."""
    sigma_mm: float
    """Standard uncertainty of a coordinate (of a reading, where the kind reads none), rms over the readings."""
    share: float
    """Of the combined variance."""


class Budget(Value):
    """The uncertainty of the difference between a reading and the calibrated machine, by the GUM."""

    measurand: str
    contributions: tuple[Contribution, ...]
    sigma_mm: float
    """Combined standard uncertainty."""
    degrees: float | None
    """Effective degrees of freedom, by Welch and Satterthwaite (GUM, G.4); null: without bound."""
    factor: float
    """Coverage factor."""
    expanded_mm: float
    probability: float
    machine_mm: float
    """The same of the calibrated machine's position alone, without the noise of a reading."""
    within: float
    """Share of all that was read for the validation, scalar by scalar, that lies within the expanded uncertainty."""


class Condition(Value):
    """Between which values something stood while it was measured."""

    name: str
    low: float
    high: float
    unit: str


class Certificate(OfReadings):
    """What is certified of a machine: its errors before and after, and how surely they are known."""

    schema_: Literal["deltacal.certificate/1"] = "deltacal.certificate/1"
    identifier: str
    machine: str
    mechanism: str
    model: str
    manufacturer: str | None
    serial: str | None
    instrument: str | None
    kind: str
    readings: int
    performed: tuple[str, str] | None
    """First and last day, as 2026-01-31."""
    place: str | None
    person: str | None
    laboratory: Party
    customer: Party
    conditions: tuple[Condition, ...]
    before: Errors
    after: Errors
    budget: Budget
    placed: tuple[Placed, ...]
    iso9283: Iso9283 | None
    iso230: Iso230 | None
    fitted: Made | None
    """Of what the calibration itself was made."""
    made: Made

    @property
    def headline(self) -> str:
        """Errors before and after, with their uncertainty."""
        unit, length = shown_in(self)
        return (
            f"{self.machine}: {self.before.rms_mm / length:.4g} {unit} before, {self.after.rms_mm / length:.4g} {unit} "
            f"after; U = {self.budget.expanded_mm / length:.3g} {unit} (k = {self.budget.factor:.2f})"
        )

    def table(self) -> tuple[Contribution, ...]:
        """Return the uncertainty budget."""
        return self.budget.contributions

    def document(self) -> Document:
        """Yield errors before and after, and the uncertainty budget."""
        unit, length = shown_in(self)
        yield Text(self.headline)
        rows = [(c.source, c.evaluation, decimals(c.sigma_mm / length), f"{c.share:.1%}") for c in self.table()]
        yield Table(("contribution", "type", unit, "share"), rows)
        yield Text(f"{self.budget.within:.0%} of what was read lies within U")
