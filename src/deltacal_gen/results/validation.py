"""The answer of `validate`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.parts import NeverSeen


class Row(Value):
    """A reading and what it is off."""

    line: int
    error_mm: float


class Iso9283(Value):
    """Accuracy and repeatability of poses that were read at least twice (ISO 9283, section 7.2)."""

    poses: int
    AP_mean_mm: float
    AP_max_mm: float
    RP_mean_mm: float
    RP_max_mm: float
    AD_mean_mm: float | None = None
    AD_max_mm: float | None = None
    RD_max_mm: float | None = None
    note: str


class Validation(Answer):
    """The error of a calibrated or diagnosed model on readings that it has not seen."""

    schema: Literal["deltacal.validation/1"] = "deltacal.validation/1"
    kind: str
    readings: int
    rms_mm: float
    worst_mm: float
    sigma_mm: float
    """The noise, as the result knows it."""
    chi2_per_dof: float | None
    never_seen: tuple[NeverSeen, ...]
    """Joints that stand at angles which the diagnosis never saw."""
    rows: tuple[Row, ...]
    """The worst first."""
    iso9283: Iso9283 | None = None
