"""What an instrument writes where it has no reading is left out and told, and hides no effect."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.physics.proportion import out_of_proportion

ROBOT = """[robot]
name = "arm"
mechanism = "serial"

[[joint]]
kind = "revolute"
convention = "standard"
a = 300.0
alpha = 0.0
d = 0.0
theta = 0.0

[[joint]]
kind = "revolute"
convention = "standard"
a = 250.0
alpha = 0.0
d = 0.0
theta = 0.0
"""


def written(folder: Path, overflow: float | None) -> Path:
    """Write what second encoders of an arm read of a movement, one of them with play, and its robot file."""
    rng, t = np.random.default_rng(0), np.arange(0, 20, 0.05)
    q = np.column_stack([40 * np.sin(0.9 * t), 50 * np.sin(0.7 * t + 1) + 10 * np.sin(2.3 * t)])
    way = np.sign(np.gradient(q, axis=0))
    read = q + np.array([1.5, -2.0]) - 0.3 * way * [1, 0] + 0.02 * rng.standard_normal(q.shape)
    if overflow is not None:
        read[rng.choice(len(t), 6, replace=False), 1] = overflow
    path = folder / "recording.csv"
    rows = np.column_stack([np.ones(len(t)), t, q, read])
    head = "run,time_s,q1_deg,q2_deg,enc1_deg,enc2_deg"
    np.savetxt(path, rows, "%.4f", ",", header=head, comments="")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "encoder"\n')
    (folder / "robot.toml").write_text(ROBOT)
    return path


@pytest.mark.parametrize("overflow", [4095.0, 32767.0])
def test_overflow_of_an_encoder_is_left_out_and_hides_no_play(tmp_path: Path, overflow: float) -> None:
    path = written(tmp_path, overflow)
    lines = {n for n, line in enumerate(path.read_text().splitlines(), 1) if f"{overflow:.4f}" in line}
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert [effect["name"] for effect in found["effects"]] == ["backlash"]
    assert found["final"]["heldout_rms_deg"] < 0.03
    assert lines <= {*found["gross_errors"]}
    assert "6 readings are far beyond all others" in found["summary"]


@pytest.mark.parametrize(("share", "told"), [(0.005, True), (0.04, True), (0.3, False)])
def test_so_many_may_be_out_of_proportion(share: float, told: bool) -> None:
    off = np.abs(np.random.default_rng(1).standard_normal(1000))
    off[: int(1000 * share)] = 1e4
    out = out_of_proportion(off, np.ones(1000), 0.0)
    assert out.sum() == (int(1000 * share) if told else 0)


def test_tails_are_in_proportion() -> None:
    off = np.abs(np.random.default_rng(1).standard_t(2, 5000))
    assert not out_of_proportion(off, np.ones(5000), 0.0).any()
