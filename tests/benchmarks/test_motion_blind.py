"""The blind batch of machines in motion runs, and grades what it is given."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.benchmarks import motion_blind, motion_by_hand
from tests.benchmarks.motion_cases import FOREIGN, generate, torque
from tests.support.motion_recordings import usual, written


def test_kinds_fall_to_both_machines() -> None:
    every = {(motion_blind.kind_of(seed), seed % 2) for seed in range(40)}
    assert every == {(kind, side) for kind in ("0", "1", "2", "3", *FOREIGN) for side in (0, 1)}


def test_a_case_is_drawn_again_as_it_was_and_what_it_conceals_shows() -> None:
    one, other = generate(2, "1", 50.0), generate(2, "1", 50.0)
    assert (one.tau == other.tau).all()
    assert one.concealed == other.concealed
    by = torque(one.concealed[0], one.movement) if one.concealed[0].name != "latency" else one.tau[:, 0]
    assert by.std() > 0


@pytest.mark.walk
def test_a_case_is_graded_and_kept(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kept = tmp_path / "kept.jsonl"
    arguments = ["--first", "4", "--count", "1", "--rate", "100", "--kept", str(kept), "--files", str(tmp_path)]
    assert motion_blind.main(arguments) == 0
    (row,) = map(json.loads, kept.read_text().splitlines())
    assert (row["kind"], row["machine"], row["false"]) == ("1", "arm", [])
    assert "one             1 of   1 right" in capsys.readouterr().out
    assert {path.name for path in (tmp_path / "m004").iterdir()} == {"robot.toml", "recording.csv", "recording.toml"}
    assert motion_blind.main(arguments) == 0
    assert "1 right" in kept.with_suffix(".txt").read_text()
    assert len(kept.read_text().splitlines()) == 1


@pytest.mark.walk
def test_the_ladder_by_hand_stands_beside_the_tool_s(tmp_path: Path) -> None:
    recording = written(tmp_path, usual, runs=3)
    found = motion_by_hand.beside(tmp_path / "robot.toml", recording)
    assert [row[0] for row in found] == [1, 2, 3]
    for _, tool, by_hand, rungs, _ in found:
        assert len(tool) == len(by_hand) == 4
        assert max(a / b for a, b in zip(tool, by_hand, strict=True)) < motion_by_hand.MOST
        assert rungs
    assert found[0][4] == ["coulomb", "viscous"]
