"""Concealed cases are the same for the same seed, hold what they claim, and are told apart from geometry."""

from __future__ import annotations

import numpy as np
import pytest

from tests.benchmarks.concealed_cases import OUTSIDE, generate, plan, readings
from tests.benchmarks.concealed_machines import INSTRUMENTS, shown


@pytest.mark.parametrize(
    ("kind", "names"),
    [("null", ()), ("single", ("zero_jump",)), ("outside", ("local_bump",))],
)
def test_a_case_is_drawn_from_its_seed(kind: str, names: tuple[str, ...]) -> None:
    first, again = generate(kind, names, (3, 0, 0)), generate(kind, names, (3, 0, 0))
    assert first.recording.joints.tolist() == again.recording.joints.tolist()
    assert [t.effect for t in first.terms] == (list(names) if kind == "single" else [])
    assert first.excess == pytest.approx(again.excess, rel=1e-6, abs=1e-9)
    assert first.excess < 1e-6 if kind == "null" else first.excess > 1.4
    assert first.fresh.n_rows == 100
    channels = [c for name, c in first.recording.channels.items() if not name.startswith("true_")]
    assert len(channels) == len(first.recording.channels)
    assert all(np.isfinite(c).all() for c in channels)


@pytest.mark.walk
@pytest.mark.parametrize("of", INSTRUMENTS)
def test_boards_and_encoders_conceal_effects(of: str) -> None:
    case, again = (generate("single", ("backlash",), (3, 1, 0), f"delta {of}") for _ in range(2))
    assert case.exact.kind == of
    assert case.recording.measured.tolist() == again.recording.measured.tolist()
    assert case.excess > 1.4
    assert case.fresh.measured.shape[1] == case.exact.measured.shape[1]
    noise = (case.recording.measured - case.exact.measured) / {"touched_board": case.sigma}.get(of, 1.0)
    assert np.median(np.abs(noise[np.abs(noise) > 0])) < 5.0
    assert "tool_slip" in shown(f"delta {of}") or of == "encoder"
    assert {"instrument_drift", "effector_tilt"} & set(shown("delta encoder")) == set()


def test_every_kind_has_its_share() -> None:
    work = plan({"null": 40, "outside": 14}, seed=2)
    assert len(work) == 54
    assert {names[0] for kind, names, *_ in work if kind == "outside"} == set(OUTSIDE)
    assert work == plan({"null": 40, "outside": 14}, seed=2)


def test_foreign_physics_is_concealed_in_poses_as_well() -> None:
    case = generate("outside", ("random_walk",), (3, 3, 6))
    assert case.exact.kind == "pose"
    assert readings(case.exact).shape == (case.exact.n_rows, 6)
    assert case.excess > 1.4
