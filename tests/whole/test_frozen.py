"""The program answers what it answered when it was frozen: the essence of every case, on whatever processor.

Whole answers, to 1e-9, are compared on one machine by ``python -m tests.frozen``; here what a user acts on: verdicts,
names, limbs and exit codes exactly, numbers within a small part of their standard deviation.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import deltacal_kernels
import pytest
from deltacal_kernels import effects

from deltacal_gen.instrument.kinds import names as kinds
from tests.frozen.__main__ import ANSWERS, listed
from tests.frozen.answers import answered, differences, essence, intended
from tests.frozen.cases import QUICK, Case, cases

COMMITTED: dict[str, Any] = json.loads(ANSWERS.read_text(encoding="utf-8"))
OTHER_PROCESSOR = 1e-4  # of a number's scale: sums in another order, through fits of badly determined directions
CASES = [case for case in cases() if case.name in COMMITTED]


@pytest.mark.parametrize(
    "case", [pytest.param(c, marks=() if c.name in QUICK else pytest.mark.thorough, id=c.name) for c in CASES]
)
def test_answers_are_as_before(case: Case, tmp_path: Path) -> None:
    now = essence(answered(case, tmp_path / case.name))
    now = json.loads(json.dumps(now))  # what was kept has been through a file, too
    assert list(differences(COMMITTED[case.name], now, OTHER_PROCESSOR)) == []


def test_every_simulated_case_is_committed() -> None:
    simulated = {case.name for case in cases() if not case.name.startswith(("concealed", "real"))}
    assert set(COMMITTED) == simulated
    assert set(QUICK) <= simulated


def test_every_mechanism_kind_and_effect_has_a_case() -> None:
    """Of what is committed: the lists are not asked as registries, since what somebody adds to a copy is not frozen."""
    wanted = {f"machine-{name}" for name in deltacal_kernels.MECHANISMS} | {f"kind-{name}" for name in kinds()}
    wanted |= {f"effect-{name}" for name in (*effects.EFFECTS, *effects.OF_DRIVES)}
    assert wanted - set(COMMITTED) == set()


def test_every_intended_difference_has_a_reason() -> None:
    assert all(entry["case"] and entry["place"] and entry["reason"] for entry in listed())


def test_a_difference_is_seen_and_named_by_its_place() -> None:
    before = {"effects": [{"name": "backlash", "value": 0.05, "std": 1e-4}], "rms_mm": [1.0, 2.0]}
    assert list(differences(before, before)) == []
    moved = {"effects": [{"name": "backlash", "value": 0.05 + 2e-12, "std": 1e-4}], "rms_mm": [1.0, 2.0]}
    (line,) = differences(before, moved)
    assert line.startswith("/effects[0]/value: ")
    assert list(differences(before, moved, 1e-7)) == []
    assert intended(line, "effect-backlash", [{"case": "effect-*", "place": "/effects*/value"}])
    assert not intended(line, "kind-pose", [{"case": "effect-*", "place": "/effects*/value"}])
    other = {"effects": [{"name": "latency", "value": 0.05, "std": 1e-4}], "rms_mm": [1.0]}
    assert [d.partition(":")[0] for d in differences(before, other)] == ["/effects[0]/name", "/rms_mm"]
