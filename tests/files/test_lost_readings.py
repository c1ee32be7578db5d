"""Readings that a logger lost are left out and told; those of a drive that gives the same all along are not."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from tests.support.motion_recordings import NOISE, named, usual, written

LOST, LONG, STRETCHES = 2, 45, 40  # the joint, samples of a stretch, and how many of them
Spoil = Any


def zeros(before: float) -> float:
    return 0.0


def frozen(before: float) -> float:
    return before


def spoilt(folder: Path, spoil: Spoil, **kept: Any) -> Path:
    """Write a recording of which one drive's reading stands still in places; return its path."""
    path, rng = written(folder, kept.pop("friction", usual), **kept), np.random.default_rng(1)
    head, *rows = [line.split(",") for line in path.read_text().splitlines()]
    column = head.index(f"tau{LOST}_Nm")
    for first in rng.integers(1, len(rows) - LONG, STRETCHES):
        value = spoil(float(rows[first - 1][column]))
        for row in rows[first : first + LONG]:
            row[column] = f"{value:.6f}"
    path.write_text("\n".join(",".join(row) for row in (head, *rows)) + "\n")
    return path


@pytest.mark.walk
@pytest.mark.parametrize("spoil", [zeros, frozen])
def test_readings_that_were_lost_are_left_out_and_told(tmp_path: Path, spoil: Spoil) -> None:
    path = spoilt(tmp_path, spoil)
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert max(found["final"]["heldout_rms_by_joint"]) < 1.2 * NOISE
    assert named(found) == {"coulomb_friction": [1, 2], "viscous_friction": [1, 3]}
    *_, said = found["motion"]["repairs"]
    assert f"tau{LOST}_Nm stands still" in said
    assert len(found["gross_errors"]) > 0.5 * LONG * STRETCHES
    rigid = dc.identify(tmp_path / "robot.toml", path)
    assert rigid["motion"]["repairs"][-1] == said


@pytest.mark.walk
def test_a_reading_that_ends_at_its_range_is_lost_there(tmp_path: Path) -> None:
    path = written(tmp_path, usual)
    head, *rows = [line.split(",") for line in path.read_text().splitlines()]
    column = head.index("tau1_Nm")
    most = 0.7 * max(abs(float(row[column])) for row in rows)
    clipped = [[*row[:column], f"{np.clip(float(row[column]), -most, most):.6f}", *row[column + 1 :]] for row in rows]
    path.write_text("\n".join(",".join(row) for row in (head, *clipped)) + "\n")
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert max(found["final"]["heldout_rms_by_joint"]) < 1.2 * NOISE
    assert named(found) == {"coulomb_friction": [1, 2], "viscous_friction": [1, 3]}


@pytest.mark.walk
def test_a_drive_of_coarse_counts_loses_nothing(tmp_path: Path) -> None:
    """Its readings repeat themselves, for long where it goes on evenly, and are all of them true."""
    path = written(tmp_path, usual)
    head, *rows = [line.split(",") for line in path.read_text().splitlines()]
    coarse = [[*row[:-3], *(f"{round(float(v) / 2) * 2:.1f}" for v in row[-3:])] for row in rows]
    path.write_text("\n".join(",".join(row) for row in (head, *coarse)) + "\n")
    assert dc.diagnose(tmp_path / "robot.toml", path)["motion"]["repairs"] == []


@pytest.mark.walk
def test_a_drive_that_gives_the_same_for_long_is_believed(tmp_path: Path) -> None:
    """Without noise an even motion asks for one torque all along: nothing was lost where the model gives it too."""
    (tmp_path / "robot.toml").write_text(
        '[robot]\nname = "axis"\nmechanism = "serial"\n[[joint]]\nkind = "revolute"\na = 100.0\nalpha = 0.0\n'
        "d = 0.0\ntheta = 0.0\n"
    )
    t = np.arange(0, 24, 0.01)
    speed = 30.0 * np.clip(3 * np.sin(2 * np.pi * t / 4), -1, 1)  # deg/s: even for most of the time
    q, qdd = np.cumsum(speed) * 0.01, np.gradient(speed, t)
    tau = 2.0 * np.sign(speed) + 0.02 * speed + 1e-3 * qdd
    rows = [f"{a:.2f},{b:.6f},{c:.6f}" for a, b, c in zip(t, q, tau, strict=True)]
    path = tmp_path / "recording.csv"
    path.write_text("\n".join(["time_s,q1_deg,tau1_Nm", *rows]) + "\n")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\n')
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert found["motion"]["repairs"] == []
    assert "coulomb_friction" in named(found)


def test_a_pendulum_that_swings_freely_gave_no_torque(tmp_path: Path) -> None:
    """Zeros while the drive is off are readings like others: the swing tells of friction."""
    (tmp_path / "robot.toml").write_text(
        '[robot]\nname = "pendulum"\nmechanism = "serial"\n[masses]\ngravity = [0.0, -9.81, 0.0]\n[[joint]]\n'
        'kind = "revolute"\na = 200.0\nalpha = 0.0\nd = 0.0\ntheta = -90.0\n'
    )
    rng, step, every = np.random.default_rng(0), 0.001, 5
    t = np.arange(0, 24, step)
    u = np.where(t % 8 < 4.5, 1.2 * np.sin(4.4 * t) + 0.8 * np.sin(1.95 * t), 0.0)
    q, w, angles = 0.3, 0.0, np.empty(len(t))
    for k, torque in enumerate(u):
        w += step * (torque - 2.0 * np.sin(q) - 0.08 * np.sign(w) - 0.03 * w) / 0.05
        q += step * w
        angles[k] = q
    at = slice(None, None, every)
    read = np.where(u == 0, 0.0, u + 0.02 * rng.standard_normal(len(u)))[at]
    seen = np.degrees(angles[at]) + 0.02 * rng.standard_normal(len(read))
    rows = [f"{a:.3f},{b:.4f},{c:.5f}" for a, b, c in zip(t[at], seen, read, strict=True)]
    (tmp_path / "recording.csv").write_text("\n".join(["time_s,q1_deg,tau1_Nm", *rows]) + "\n")
    (tmp_path / "recording.toml").write_text('[measurement]\nkind = "torque"\n')
    found = dc.diagnose(tmp_path / "robot.toml", tmp_path / "recording.csv")
    assert found["motion"]["repairs"] == []
    coefficients = {p["name"]: p["value"] for e in found["effects"] for p in e["parameters"]}
    assert coefficients == pytest.approx({"coulomb": 0.08, "viscous": 0.03 * np.pi / 180}, rel=0.1)
