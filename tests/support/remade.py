"""The papers' tables, remade in little time; ``python -m tests.support.remade`` writes them down."""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path

from derive.review import ledger
from derive.review.reproduction.sheet import Sheet

FILE = Path(__file__).resolve().parents[1] / "derive" / "tables.json"
SHORT = {"mei": {"seeds": 2}, "traslosheros": {"images": 30}}  # fewer procedures, shorter paths of the ball
Tables = dict[str, list[str]]


def quiet(_: str) -> None:
    """Report nothing."""


def tables(paper: str) -> Tables:
    """Return the rows of each table of a paper, heads first, by its number and title."""
    study = importlib.import_module(f"derive.review.reproduction.{paper}").study
    sheets = [part for part in study(quiet, **SHORT.get(paper, {})) if isinstance(part, Sheet)]
    return {f"{s.of}: {s.title}": [" | ".join(row) for row in (s.columns, *s.rows)] for s in sheets}


def main() -> int:
    """Write the tables of all papers."""
    found = {paper: tables(paper) for paper in ledger.paper_names()}
    FILE.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
