"""``python -m derive verdicts [--check]``: decide what the papers print, and write it for the ledger of claims."""

from __future__ import annotations

import argparse
import difflib
import importlib
import json
from collections.abc import Sequence
from pathlib import Path

from derive.papers.statements import Statement, Verdict

FILE = Path(__file__).resolve().parents[1] / "review/claims/derived.json"
COMMAND = "python -m derive verdicts"


STATED = ("bai", "mei", "savoure", "traslosheros")  # the papers, by their modules here


def case_of(mechanism: str) -> str | None:
    """Return what the paper on a mechanism reads, as the rank tables call it; None of a mechanism of no paper."""
    modules = (importlib.import_module(f"derive.papers.{paper}") for paper in STATED)
    return next((m.CASES[mechanism] for m in modules if mechanism in m.CASES), None)


def decided(paper: str) -> dict[str, Verdict]:
    """Return the verdicts of a paper by their names.

    Raises
    ------
    ValueError
        Two statements share a name.
    """
    found: dict[str, Verdict] = {}
    statements: Sequence[Statement] = importlib.import_module(f"derive.papers.{paper}").statements()
    for verdict in (s.verdict() for s in statements):
        if verdict.name in found:
            raise ValueError(f"two statements are named '{verdict.name}'.")
        found[verdict.name] = verdict
    return found


def text() -> str:
    """Return the file of all verdicts."""
    every = {paper: {n: v.entry() for n, v in decided(paper).items()} for paper in STATED}
    return json.dumps(every, indent=1, ensure_ascii=False) + "\n"


def main(arguments: Sequence[str]) -> int:
    """Write the verdicts, or with ``--check`` show by what the committed ones differ."""
    parser = argparse.ArgumentParser(prog=COMMAND, description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; fail if the committed verdicts differ")
    check = parser.parse_args(arguments).check
    fresh, old = text(), FILE.read_text(encoding="utf-8") if FILE.exists() else ""
    if fresh == old:
        print(f"{FILE.name} is what derive/papers yields")
        return 0
    print(
        *difflib.unified_diff(old.splitlines(), fresh.splitlines(), "committed", "derived", lineterm="", n=1), sep="\n"
    )
    if not check:
        FILE.write_text(fresh, encoding="utf-8")
    else:
        print(f'Run "{COMMAND}" and commit.')
    return int(check)
