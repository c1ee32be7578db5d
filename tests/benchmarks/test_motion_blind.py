"""The blind batch of machines in motion runs, and grades what it is given."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.benchmarks import motion_blind
from tests.benchmarks.motion_cases import FOREIGN, generate, torque


def test_kinds_fall_to_both_machines() -> None:
    every = {(motion_blind.kind_of(seed), seed % 2) for seed in range(40)}
    assert every == {(kind, side) for kind in ("0", "1", "2", "3", *FOREIGN) for side in (0, 1)}


def test_a_case_is_drawn_again_as_it_was_and_what_it_conceals_shows() -> None:
    one, other = generate(2, "1", 50.0), generate(2, "1", 50.0)
    assert (one.tau == other.tau).all()
    assert one.concealed == other.concealed
    by = torque(one.concealed[0], one.movement) if one.concealed[0].name != "latency" else one.tau[:, 0]
    assert by.std() > 0


def test_a_case_is_graded_and_kept(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kept = tmp_path / "kept.jsonl"
    arguments = ["--first", "4", "--count", "1", "--rate", "100", "--kept", str(kept)]
    assert motion_blind.main(arguments) == 0
    (row,) = map(json.loads, kept.read_text().splitlines())
    assert (row["kind"], row["machine"], row["false"]) == ("1", "arm", [])
    assert "one             1 of   1 right" in capsys.readouterr().out
    assert motion_blind.main(arguments) == 0
    assert len(kept.read_text().splitlines()) == 1
