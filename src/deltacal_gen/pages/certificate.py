"""The page of a certificate: A4, to be printed and signed."""

from __future__ import annotations

from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.pages import report
from deltacal_gen.pages.validation import norms
from deltacal_gen.results.certificate import Certificate
from deltacal_gen.results.document import decimals

MANY = 10_000  # degrees of freedom: t and normal distribution are one


def certificate(found: Certificate) -> str:
    """Return the page of a certificate."""
    budget = found.budget
    unit, length = (found.unit, found.unit_mm) if found.unit and found.unit_mm else ("mm", 1.0)
    scalar = "coordinate" if kind_of(found.kind).positions else "reading"

    def shown(value: float) -> str:
        return decimals(value / length)

    combined = ("combined", "", _degrees(budget.degrees), shown(budget.sigma_mm), "100 %")
    machine = (
        ""
        if not kind_of(found.kind).positions
        else (
            f" Of the position of the calibrated machine alone, without the noise of a reading: "
            f"{shown(budget.machine_mm)} {unit}."
        )
    )
    return report.page_of(
        "certificate",
        title=f"{found.machine}: calibration certificate",
        found=found,
        unit=unit,
        scalar=scalar,
        lead=f"As drawn the machine is off by {shown(found.before.rms_mm)} {unit} (rms of a {scalar}), calibrated by "
        f"{shown(found.after.rms_mm)} {unit}; expanded uncertainty of a {scalar} {shown(budget.expanded_mm)} {unit} "
        f"(k = {budget.factor:.2f}).",
        conditions=[
            f"{c.name} {c.low:g}{f' to {c.high:g}' if c.high > c.low else ''} {c.unit}" for c in found.conditions
        ],
        placed=" ".join(
            f"The set-up '{p.setup}' was placed by its {p.readings} readings ({p.unknowns} numbers)."
            for p in found.placed
        ),
        errors=[(e.of, *(shown(v) for v in (e.rms_mm, e.mean_mm, e.worst_mm))) for e in (found.before, found.after)],
        budget=[
            *(
                (c.source, c.evaluation, _degrees(c.degrees), shown(c.sigma_mm), f"{c.share:.0%}".replace("%", " %"))
                for c in budget.contributions
            ),
            combined,
        ],
        expanded=f"Expanded uncertainty U = {shown(budget.expanded_mm)} {unit}, k = {budget.factor:.2f}, "
        f"{budget.probability:.0%} coverage; {budget.within:.0%} of the {scalar}s lie within it.{machine}".replace(
            "%", " %"
        ),
        measurand=f"Measurand: {budget.measurand}.",
        norms=norms(found.iso9283, found.iso230),
        files=[
            *(("calibration", file) for file in (found.fitted.inputs if found.fitted else ())),
            *(("certificate", file) for file in found.made.inputs),
        ],
    )


def _degrees(value: float | None) -> str:
    return "∞" if value is None or value > MANY else f"{value:.0f}"
