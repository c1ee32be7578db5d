"""What version 3.3.0 of PTB's schema of digital calibration certificates asks of the elements that are written here.

The schema itself (LGPL-3.0) is not shipped and never fetched; ``python -m tests.benchmarks.dcc --schema DCC.XSD
--rules`` holds a certificate against a copy of it, and against the Schematron rules that go with it. An element's
children are listed in their order: ``?`` may be absent, ``+`` repeats, ``|`` any one of several, as often as one likes.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

DCC, SI = "{https://ptb.de/dcc}", "{https://ptb.de/si}"
_TEXT, _RICH, _PARTY = "content+", "name? content+", "name location"
SEQUENCES = {
    "digitalCalibrationCertificate": "administrativeData measurementResults",
    "administrativeData": "dccSoftware coreData items calibrationLaboratory respPersons customer statements?",
    "dccSoftware": "software+",
    "usedSoftware": "software+",
    "software": "name release type?",
    "coreData": "countryCodeISO3166_1 usedLangCodeISO639_1+ mandatoryLangCodeISO639_1+ uniqueIdentifier "
    "beginPerformanceDate endPerformanceDate performanceLocation issueDate?",
    "items": "item+",
    "item": "name description? manufacturer identifications",
    "manufacturer": "name",
    "identifications": "identification+",
    "identification": "issuer value",
    "calibrationLaboratory": "contact",
    "contact": _PARTY,
    "customer": _PARTY,
    "location": "city|countryCode|street|further",
    "further": _RICH,
    "respPersons": "respPerson+",
    "respPerson": "person mainSigner?",
    "person": "name",
    "statements": "statement+",
    "statement": "name declaration",
    "declaration": _RICH,
    "description": _RICH,
    "measurementResults": "measurementResult+",
    "usedMethods": "usedMethod+",
    "usedMethod": "name description? norm+",
    "measuringEquipments": "measuringEquipment+",
    "measuringEquipment": "name",
    "influenceConditions": "influenceCondition+",
    "influenceCondition": "name data",
    "measurementMetaData": "metaData+",
    "metaData": "name declaration",
    "measurementResult": "name usedMethods usedSoftware measuringEquipments influenceConditions results "
    "measurementMetaData?",  # all but name and results may be absent by the schema, not by PTB's rules (Schematron)
    "results": "result+",
    "result": "name data",
    "data": "text|list",
    "text": _RICH,
    "list": "quantity+",
    "quantity": "name real",
    "real": "value unit measurementUncertaintyUnivariate?",
    "measurementUncertaintyUnivariate": "expandedMU",
    "expandedMU": "valueExpandedMU coverageFactor coverageProbability distribution?",
    "name": _TEXT,
}
_DAY, _WORDS, _NUMBER = r"\d{4}-\d\d-\d\d", r"\S+(\s+\S+)*", r"-?\d+(\.\d+)?(e-?\d+)?"
TEXTS = {
    "countryCodeISO3166_1": "[A-Z]{2}",
    "countryCode": "[A-Z]{2}",
    "usedLangCodeISO639_1": "[a-z]{2}",
    "mandatoryLangCodeISO639_1": "[a-z]{2}",
    "beginPerformanceDate": _DAY,
    "endPerformanceDate": _DAY,
    "issueDate": _DAY,
    "performanceLocation": "laboratory|customer|laboratoryBranch|customerBranch|other",
    "type": "application",
    "release": r"[a-zA-Z] ?(\d{1,3}\.){0,3}\d{1,3}",
    "issuer": "manufacturer|other",
    "mainSigner": "true",
    "value": f"{_WORDS}",
    "valueExpandedMU": _NUMBER,
    "coverageFactor": _NUMBER,
    "coverageProbability": "0\\.95",
    "unit": r"(\\[a-z]+)+",
    "distribution": "normal",
}
_OF_SI = {"real", "measurementUncertaintyUnivariate", "expandedMU", "unit", "valueExpandedMU", "coverageFactor"}
_OF_SI |= {"coverageProbability", "distribution"}


def flaws(text: str) -> list[str]:
    """Return what is against the schema in a certificate; raises ParseError where it is no XML."""
    root = ET.fromstring(text)
    out = [] if root.get("schemaVersion") == "3.3.0" else ["schemaVersion"]
    return out + [flaw for element in root.iter() for flaw in _flaws(element)]


def _flaws(element: ET.Element) -> list[str]:
    name = element.tag.partition("}")[2]
    children = [child.tag.partition("}")[2] for child in element]
    own = SI if name in _OF_SI else DCC
    out = []
    if not (element.tag.startswith(own) or name == "value"):
        out.append(f"{name} is of another vocabulary")
    if name in SEQUENCES and children:
        pattern = "".join(_pattern(part) for part in SEQUENCES[name].split())
        if not re.fullmatch(pattern, "".join(f"<{c}>" for c in children)):
            out.append(f"{name} holds {', '.join(children)}; wanted: {SEQUENCES[name]}")
    elif name in SEQUENCES or children:
        out.append(f"{name} holds {', '.join(children) or 'nothing'}")
    elif not re.fullmatch(TEXTS.get(name, _WORDS), element.text or ""):
        out.append(f"{name} says {element.text!r}")
    return out


def _pattern(part: str) -> str:
    words, repeats = part.rstrip("?+"), part[-1] if part[-1] in "?+" else ""
    choice = "|".join(f"<{w}>" for w in words.split("|"))
    return f"(?:{choice}){'+' if '|' in words else repeats}"
