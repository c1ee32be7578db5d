"""``python -m tests.decided``: runs the tests that decide the claims of the papers, and writes down how they ended.

``claims/decided.json`` then says of every test its outcome, the day, and the hash of what it was decided with: the
descriptions that SymPy reads, the runtime's kernels, and the test's own file. The page of claims shows it.
"""

from __future__ import annotations

import json
import os
import sys
import time
from pathlib import Path

import pytest

from deltacal_gen.pages import ledger

ROOT = Path(__file__).resolve().parents[1]


class Outcomes:
    """How tests ended, by their names without parameters: the worst of all parameters counts."""

    def __init__(self) -> None:
        self.of: dict[str, str] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Take what pytest says of a phase of a test."""
        name = report.nodeid.partition("[")[0]
        if report.failed or (report.when == "call" and self.of.get(name) != "failed"):
            self.of[name] = "failed" if report.failed else report.outcome


def main() -> int:
    """Run the tests; return 0 where all passed."""
    os.chdir(ROOT)
    tests = sorted({c.test for name in ledger.paper_names() for c in ledger.load_paper(name).claims})
    outcomes = Outcomes()
    pytest.main(["-q", "-n0", "-p", "no:cacheprovider", "-m", "", *tests], plugins=[outcomes])
    now = float(os.environ.get("SOURCE_DATE_EPOCH") or time.time())
    date = time.strftime("%Y-%m-%d", time.gmtime(now))
    record = {
        test: {"outcome": outcomes.of.get(test, "not run"), "date": date, "sources": ledger.sources(ROOT, test)}
        for test in tests
    }
    path = ledger.folder() / "decided.json"
    path.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    print(f"{path.relative_to(ROOT)}: {sum(r['outcome'] == 'passed' for r in record.values())} of {len(record)} passed")
    return int(any(r["outcome"] != "passed" for r in record.values()))


if __name__ == "__main__":
    sys.exit(main())
