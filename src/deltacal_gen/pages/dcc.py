"""A certificate as digital calibration certificate: XML after version 3.3.0 of PTB's schema (https://ptb.de/dcc).

Values are D-SI elements (https://ptb.de/si). What nobody stated is said so in words where the schema asks for a text,
and the country is ZZ, which ISO 3166-1 leaves to users.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable

from deltacal_gen.results.certificate import Certificate, Condition, Party

VERSION = "3.3.0"
DCC, SI = "https://ptb.de/dcc", "https://ptb.de/si"
XSI = "http://www.w3.org/2001/XMLSchema-instance"
PROBABILITY = 0.95  # of expanded uncertainties
UNSTATED, NOWHERE = "not stated", "ZZ"
UNITS = {"mm": r"\milli\metre", "deg": r"\degree", "px": r"\one", "degC": r"\degreecelsius", "kg": r"\kilogram"}
UNITS |= {"s": r"\second"}

for _prefix, _uri in (("dcc", DCC), ("si", SI), ("xsi", XSI)):
    ET.register_namespace(_prefix, _uri)


def dcc(found: Certificate) -> str:
    """Return the XML text of a certificate."""
    root = ET.Element(f"{{{DCC}}}digitalCalibrationCertificate", {"schemaVersion": VERSION})
    root.set(f"{{{XSI}}}schemaLocation", f"{DCC} {DCC}/v{VERSION}/dcc.xsd")
    _administrative(_add(root, "administrativeData"), found)
    _results(_add(root, "measurementResults"), found)
    ET.indent(root, " ")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{ET.tostring(root, encoding="unicode")}\n'


def _add(parent: ET.Element, name: str, text: str | None = None, space: str = DCC) -> ET.Element:
    """Add an element; of its text the letters that XML can hold, and no white space about them."""
    child = ET.SubElement(parent, f"{{{space}}}{name}")
    child.text = None if text is None else "".join(c for c in text if c.isprintable()).strip() or UNSTATED
    return child


def _said(parent: ET.Element, name: str, text: str) -> ET.Element:
    """Add an element that holds a text in English."""
    child = _add(parent, name)
    _add(child, "content", text).set("lang", "en")
    return child


def _administrative(at: ET.Element, found: Certificate) -> None:
    _software(_add(at, "dccSoftware"), found)
    core = _add(at, "coreData")
    _add(core, "countryCodeISO3166_1", found.laboratory.country or NOWHERE)
    _add(core, "usedLangCodeISO639_1", "en")
    _add(core, "mandatoryLangCodeISO639_1", "en")
    _add(core, "uniqueIdentifier", found.identifier)
    begin, end = found.performed or (found.made.date,) * 2
    _add(core, "beginPerformanceDate", begin)
    _add(core, "endPerformanceDate", end)
    _add(core, "performanceLocation", found.place or "other")
    _add(core, "issueDate", found.made.date)
    item = _add(_add(at, "items"), "item")
    _said(item, "name", found.machine)
    _said(item, "description", f"{found.mechanism}, model {found.model}")
    _said(_add(item, "manufacturer"), "name", found.manufacturer or UNSTATED)
    identification = _add(_add(item, "identifications"), "identification")
    _add(identification, "issuer", "manufacturer" if found.serial else "other")
    _add(identification, "value", found.serial or found.machine)
    _contact(_add(_add(at, "calibrationLaboratory"), "contact"), found.laboratory)
    person = _add(_add(at, "respPersons"), "respPerson")
    _said(_add(person, "person"), "name", found.person or UNSTATED)
    _add(person, "mainSigner", "true")
    _contact(_add(at, "customer"), found.customer)
    statements = _add(at, "statements")
    told = {"uncertainty": _coverage(found), "conformity": "No statement of conformity is made."}
    if found.performed is None:
        told["dates"] = "The days of the measurement were not stated; the day of issue stands for them."
    for name, text in told.items():
        statement = _add(statements, "statement")
        _said(statement, "name", name)
        _said(statement, "declaration", text)


def _coverage(found: Certificate) -> str:
    budget = found.budget
    return (
        f"The uncertainty is the combined standard uncertainty times k = {budget.factor:.2f}, which holds "
        f"{budget.probability:.0%} (GUM, JCGM 100:2008). Measurand: {budget.measurand}."
    )


def _software(at: ET.Element, found: Certificate) -> None:
    software = _add(at, "software")
    _said(software, "name", "deltacal")
    _add(software, "release", f"v{found.made.version}")  # a number alone is none to PTB's rules
    _add(software, "type", "application")


def _contact(at: ET.Element, party: Party) -> None:
    _said(at, "name", party.name or UNSTATED)
    where = _add(at, "location")
    for name, value in (("city", party.city), ("countryCode", party.country), ("street", party.street)):
        if value is not None:
            _add(where, name, value)
    if not len(where):
        _said(where, "further", UNSTATED)


def _results(at: ET.Element, found: Certificate) -> None:
    own = _add(at, "measurementResult")
    _said(own, "name", "errors of the machine")
    method = _add(_add(own, "usedMethods"), "usedMethod")
    _said(method, "name", "kinematic calibration, validated on readings that took no part in it")
    _said(method, "description", f"model {found.model}; readings of the kind {found.kind}")
    _add(method, "norm", "JCGM 100:2008")
    if found.iso9283 is not None:
        _add(method, "norm", "ISO 9283:1998")
    if found.iso230 is not None:
        _add(method, "norm", "ISO 230-2:2014")
    _software(_add(own, "usedSoftware"), found)
    equipment = _add(_add(own, "measuringEquipments"), "measuringEquipment")
    _said(equipment, "name", found.instrument or UNSTATED)
    conditions = _add(own, "influenceConditions")
    for condition in found.conditions:
        _condition(conditions, condition)
    if not found.conditions:
        nothing = _add(conditions, "influenceCondition")
        _said(nothing, "name", "temperature")
        _said(_add(nothing, "data"), "text", UNSTATED)
    results = _add(own, "results")
    for name, quantities in _figures(found):
        _quantities(_add(results, "result"), name, quantities)
    files = (*(found.fitted.inputs if found.fitted else ()), *found.made.inputs)
    known = _add(own, "measurementMetaData") if files else own
    for file in files:
        data = _add(known, "metaData")
        _said(data, "name", file.name)
        _said(data, "declaration", f"SHA-256 {file.sha256}")


Expanded = tuple[float, float]  # uncertainty, coverage factor
Quantity = tuple[str, float, str, Expanded | None]  # name, value, unit


def _figures(found: Certificate) -> Iterable[tuple[str, list[Quantity]]]:
    budget = found.budget
    length = found.unit_mm or 1.0
    unit = found.unit or "mm"

    def quantity(name: str, value: float, expanded: Expanded | None = None) -> Quantity:
        return name, value / length, unit, expanded

    for errors in (found.before, found.after):
        yield (
            f"error, machine {errors.of}",
            [
                quantity(
                    "root mean square of a coordinate", errors.rms_mm, (budget.expanded_mm / length, budget.factor)
                ),
                quantity("mean length", errors.mean_mm),
                quantity("largest length", errors.worst_mm),
            ],
        )
    yield (
        "standard uncertainties of a coordinate",
        [quantity(c.source, c.sigma_mm) for c in budget.contributions] + [quantity("combined", budget.sigma_mm)],
    )
    for norm, answer in (("ISO 9283", found.iso9283), ("ISO 230-2", found.iso230)):
        if answer is not None:
            told = ((k, v) for k, v in answer.to_dict().items() if k.endswith("_mm"))
            yield norm, [(key.removesuffix("_mm"), value, "mm", None) for key, value in told]


def _quantities(at: ET.Element, name: str, quantities: list[Quantity]) -> None:
    _said(at, "name", name)
    held = _add(_add(at, "data"), "list")
    for each, value, unit, expanded in quantities:
        quantity = _add(held, "quantity")
        _said(quantity, "name", each)
        _real(quantity, value, unit, expanded)


def _condition(at: ET.Element, condition: Condition) -> None:
    own = _add(at, "influenceCondition")
    _said(own, "name", condition.name)
    held = _add(_add(own, "data"), "list")
    for name, value in (("lowest", condition.low), ("highest", condition.high)):
        quantity = _add(held, "quantity")
        _said(quantity, "name", name)
        _real(quantity, value, condition.unit, None)


def _real(at: ET.Element, value: float, unit: str, expanded: Expanded | None) -> None:
    real = _add(at, "real", space=SI)
    _add(real, "value", repr(float(value)), SI)
    _add(real, "unit", UNITS[unit], SI)
    if expanded is not None:
        univariate = _add(_add(real, "measurementUncertaintyUnivariate", space=SI), "expandedMU", space=SI)
        for name, number in zip(("valueExpandedMU", "coverageFactor"), expanded, strict=True):
            _add(univariate, name, repr(float(number)), SI)
        _add(univariate, "coverageProbability", str(PROBABILITY), SI)
        _add(univariate, "distribution", "normal", SI)
