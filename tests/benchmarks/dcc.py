"""A certificate against PTB's own schema and rules: ``python -m tests.benchmarks.dcc [FILE.xml] --schema DCC.XSD``.

Give a copy of https://ptb.de/dcc/v3.3.0/dcc.xsd whose imports (SI_Format.xsd, xmldsig-core-schema.xsd) lie where it
says; it needs xmlschema (``pip install .[bench]``). ``--rules`` holds the certificate against the Schematron rules that
go with the schema, as the package dcclib (LGPL-3.0) has them: ``pip install dcclib``, in an environment of its own.
Without a certificate one is made of the Delta's example.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from tests.support.dcc_structure import flaws


def main() -> int:
    """Return 0 where the certificate is valid; else say what is not, and return 1."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("certificate", type=Path, nargs="?")
    parser.add_argument("--schema", type=Path)
    parser.add_argument("--rules", action="store_true")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = given.certificate or _made(Path(folder))
        told = flaws(path.read_text(encoding="utf-8"))
        if given.schema is not None:
            import xmlschema

            told += [str(e.reason) for e in xmlschema.XMLSchema(str(given.schema)).iter_errors(str(path))]
        if given.rules:
            from dcclib.validation import SchematronValidator

            found = SchematronValidator.for_dcc().validate_file(str(path))
            against = (*found.failed_assertions, *found.successful_reports)
            told += [f"{each.text} ({each.location})" for each in against if each.role in ("error", "warning")]
    print("\n".join(told) or "valid")
    return int(bool(told))


def _made(folder: Path) -> Path:
    robot = example() / "robot.toml"
    result = dc.identify(robot, example() / "recording.csv", model="32")
    other = folder / "other.csv"
    dc.simulate(robot, example() / "poses.csv", output=other, truth=example() / "truth.toml", noise=0.005, seed=9)
    about = folder / "about.toml"
    about.write_text('[laboratory]\ncountry = "DE"\n', encoding="utf-8")  # the rules know no country that is not stated
    dc.certificate(result, other, output=folder / "certificate.html", about=about)
    return folder / "certificate.xml"


if __name__ == "__main__":
    sys.exit(main())
