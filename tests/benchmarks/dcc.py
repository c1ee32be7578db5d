"""A certificate against PTB's own schema: ``python -m tests.benchmarks.dcc DCC.XSD [CERTIFICATE.xml]``.

Give a copy of https://ptb.de/dcc/v3.3.0/dcc.xsd whose imports (SI_Format.xsd, xmldsig-core-schema.xsd) lie where it
says. Needs xmlschema (``pip install .[bench]``). Without a certificate one is made of the Delta's example.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from tests.dcc_structure import flaws


def main() -> int:
    """Return 0 where the certificate is valid; else say what is not, and return 1."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("schema", type=Path)
    parser.add_argument("certificate", type=Path, nargs="?")
    given = parser.parse_args()
    import xmlschema

    with tempfile.TemporaryDirectory() as folder:
        path = given.certificate or _made(Path(folder))
        told = [str(e.reason) for e in xmlschema.XMLSchema(str(given.schema)).iter_errors(str(path))]
        told += flaws(path.read_text(encoding="utf-8"))
    print("\n".join(told) or "valid")
    return int(bool(told))


def _made(folder: Path) -> Path:
    robot = example() / "robot.toml"
    result = dc.identify(robot, example() / "recording.csv", "32")
    other = folder / "other.csv"
    dc.simulate(robot, example() / "poses.csv", other, truth=example() / "truth.toml", noise=0.005, seed=9)
    dc.certificate(result, other, folder / "certificate.html")
    return folder / "certificate.xml"


if __name__ == "__main__":
    sys.exit(main())
