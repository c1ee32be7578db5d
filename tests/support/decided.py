"""``python -m tests.support.decided``: runs the tests that decide the papers' claims, and writes down how they ended.

``claims/decided.json`` then says of every test its outcome, the day, the hash of what it was decided with (the
descriptions that SymPy reads, the runtime's kernels, the test's own modules), and its figures: every assertion with
what stood on its two sides when it held. Nobody types them; `pytest` tells what it compared. The page of claims shows
it.

All tests run twice: as they are, with machines written from the papers alone, and with the project's own kernels in
the place of these (`tests.claims.of_the_project`); ``by_project`` is how they end then.
"""

from __future__ import annotations

import ast
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from derive.review import ledger
from tests.claims import of_the_project

ROOT = Path(__file__).resolve().parents[2]
PROJECT = "--project"  # what the process of the second run is asked
ASSERTED, FOUND, FIGURES = 110, 80, 8  # letters of an assertion and of what was found, assertions of a test
RELATION = re.compile(r" (==|<=|>=|<|>) ")
LONG = re.compile(r"-?\d+\.\d{5,}(e[-+]\d+)?")
WRAPPED = re.compile(r"np\.\w+\(([^()]*)\)")


class Outcomes:
    """How tests ended and what they compared, by their names without parameters: the worst of all parameters counts."""

    def __init__(self) -> None:
        self.of: dict[str, str] = {}
        self.found: dict[str, dict[str, list[str]]] = defaultdict(lambda: defaultdict(list))
        self._gap = ""

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Take what pytest says of a phase of a test."""
        name = report.nodeid.partition("[")[0]
        if report.failed or (report.when == "call" and self.of.get(name) != "failed"):
            self.of[name] = "failed" if report.failed else report.outcome

    def pytest_assertion_pass(self, item: pytest.Item, orig: str, expl: str) -> None:
        """Take an assertion that held: its text, and pytest's explanation with the values in place of the names."""
        asserted = ast.unparse(ast.parse(f"({orig}\n)", mode="eval"))
        values = self._gap if "allclose(" in asserted else said(expl)
        self.found[item.nodeid.partition("[")[0]][asserted].append(values)

    def allclose(self, a: Any, b: Any, rtol: float = 1e-5, atol: float = 1e-8, equal_nan: bool = False) -> bool:
        """Compare as NumPy does, and remember by how much the two differ where they come nearest to what is allowed."""
        gap, allowed = (np.ravel(v) for v in np.broadcast_arrays(np.abs(np.subtract(a, b)), atol + rtol * np.abs(b)))
        worst = int(np.argmax(gap - allowed)) if gap.size else None
        self._gap = "" if worst is None else f"{gap[worst]:.3g} <= {allowed[worst]:.3g}"
        return bool(np.isclose(a, b, rtol, atol, equal_nan).all())

    def figures(self, test: str) -> list[dict[str, str]]:
        """Return the assertions of a test, each with what was found, those without a number last."""
        told = [{"asserted": cut(what, ASSERTED), "found": cut(over(v), FOUND)} for what, v in self.found[test].items()]
        return sorted(told, key=lambda figure: not re.search(r"\d", figure["found"]))[:FIGURES]


def said(explanation: str) -> str:
    """Return pytest's explanation of an assertion without what only a programmer wants; empty where it is but true."""
    line = " ".join(explanation.splitlines()[0].replace("\\n", " ").split())
    while (plain := WRAPPED.sub(r"\1", line)) != line:
        line = plain
    line = LONG.sub(lambda number: f"{float(number[0]):.6g}", line)
    return "" if line in ("True", "np.True_", "not False") or "<" in line.partition(" ")[0] else line


def over(found: list[str]) -> str:
    """Return what an assertion found each time it was asked as one text: from the least to the greatest."""
    first, parts = found[0], [RELATION.split(f, maxsplit=1) for f in found]
    if len(set(found)) == 1:
        return first
    try:
        left = sorted((float(p[0]), p[0]) for p in parts)
    except ValueError:
        return f"{first} (the first of {len(found)})"
    held = " ".join(parts[0][1:]) if len({tuple(p[1:]) for p in parts}) == 1 else f"{parts[0][1]} what is wanted"
    return f"{left[0][1]} to {left[-1][1]} {held}"


def cut(text: str, length: int) -> str:
    """Return a text that is no longer than this."""
    return text if len(text) <= length else f"{text[: length - 1]}…"


def decide(tests: list[str]) -> Outcomes:
    """Run tests, and return how they ended."""
    outcomes = Outcomes()
    with tempfile.TemporaryDirectory() as folder, pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "pycache_prefix", folder)  # what pytest had compiled before does not tell what it compares
        patch.setattr(np, "allclose", outcomes.allclose)
        asked = ["-o", "enable_assertion_pass_hook=true", "-o", "verbosity_assertions=2", "-m", ""]
        pytest.main(["-q", "-n0", "-p", "no:cacheprovider", *asked, *tests], plugins=[outcomes])
    return outcomes


def by_project() -> dict[str, str]:
    """Return how the tests end with the project's machines: in a process of its own, since tests are imported once."""
    done = subprocess.run(
        [sys.executable, "-m", "tests.support.decided", PROJECT], capture_output=True, text=True, check=True
    )
    found: dict[str, str] = json.loads(done.stdout.splitlines()[-1])
    return found


def main(arguments: Sequence[str]) -> int:
    """Run the tests; return 0 where all passed."""
    os.chdir(ROOT)
    tests = sorted({c.test for name in ledger.paper_names() for c in ledger.load_paper(name).claims})
    if PROJECT in arguments:
        of_the_project.install()
        print("", json.dumps(decide(tests).of), sep="\n")
        return 0
    now = float(os.environ.get("SOURCE_DATE_EPOCH") or time.time())  # before the tests forget it
    date = time.strftime("%Y-%m-%d", time.gmtime(now))
    outcomes, again = decide(tests), by_project()
    record = {
        test: {
            "outcome": outcomes.of.get(test, "not run"),
            "by_project": again.get(test, "not run"),
            "date": date,
            "sources": ledger.sources(ROOT, test),
            "figures": outcomes.figures(test),
        }
        for test in tests
    }
    path = ledger.folder() / "decided.json"
    path.write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    passed = [sum(r[of] == "passed" for r in record.values()) for of in ("outcome", "by_project")]
    print(f"{path.relative_to(ROOT)}: of {len(record)} passed {passed[0]}, with the project's machines {passed[1]}")
    return int(min(passed) < len(record))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
