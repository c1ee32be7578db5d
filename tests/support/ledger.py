"""A paper's file of the ledger of claims."""

from __future__ import annotations

import json
from pathlib import Path

ENTRY = {
    "where": "eq. (3)",
    "statement": "Two and two make five.",
    "status": "contradicted",
    "printed": "2 + 2 = 5",
    "correct": "2 + 2 = 4",
    "evidence": "Counted: 4.",
    "test": "tests/pages/test_claims.py::test_every_claim_names_a_test",
}


def write(folder: Path, *entries: dict[str, str], name: str = "euclid") -> Path:
    """Write a paper's file; JSON strings are TOML strings."""
    text = 'title = "Euclid, Elements"\n'
    for entry in entries:
        text += "\n[[claim]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in entry.items())
    path = folder / f"{name}.toml"
    path.write_text(text)
    return path
