"""Bands of what drives will give: they hold 95 % of readings of other movements, also where a model lacks something."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.motion import trajectories
from deltacal_gen.motion.bands import named
from deltacal_gen.motion.kinds import in_motion
from deltacal_gen.physics.factors import packed, unpacked
from deltacal_gen.results.reader import read_answer
from tests.support.commands import Run
from tests.support.motion_recordings import DEG, NOISE, Friction, robot, usual, written

SECOND, THIRD = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])


def dragged(states: np.ndarray, load: np.ndarray) -> np.ndarray:
    """What is pushed along where a joint goes farther than before: no effect, and no law of its states, is that."""
    pushed = np.zeros_like(load)
    for n in range(1, len(load)):
        pushed[n] = np.clip(pushed[n - 1], states[0, n] - 0.08, states[0, n] + 0.08)
    return -40.0 * (states[0] - pushed) * SECOND


def sticking(states: np.ndarray, load: np.ndarray) -> np.ndarray:
    return usual(states, load) + 3.0 * np.sign(states[1]) * (1 + np.exp(-((states[1] / DEG / 6.0) ** 2))) * THIRD


def predicted(found: Any, path: Path) -> tuple[trajectories.Trajectories, np.ndarray]:
    """Return what a model predicts of a recording, with bands, and what was read there."""
    moving = in_motion(path)
    assert moving is not None
    done: Any = dc.predict(found, path, bands=True)
    return done, moving.read(robot()).readings


def held(found: Any, path: Path) -> float:
    """Return the part of a recording's readings that lies in the bands of their predictions."""
    done, read = predicted(found, path)
    there = np.isfinite(done.readings)
    assert done.half is not None
    return float(np.mean((np.abs(read - done.readings) <= done.half)[there]))


SETTINGS: dict[str, tuple[Friction, Callable[..., Any], dict[str, Any]]] = {
    "all of it is found": (usual, dc.diagnose, {}),
    "a size within an effect": (sticking, dc.diagnose, {}),
    "two short runs, held out in stretches": (usual, dc.diagnose, {"runs": 2, "seconds": 6.0}),
    "friction is left out": (usual, dc.identify, {}),
    "what no effect is": (dragged, dc.diagnose, {}),
    "readings that come late": (usual, dc.diagnose, {"delay": (0.0, 0.03, 0.0)}),
}


ALIKE = ("a size within an effect", "readings that come late")  # found like any; both take ten seconds


@pytest.mark.walk
@pytest.mark.parametrize(
    "setting", [pytest.param(name, marks=pytest.mark.thorough if name in ALIKE else ()) for name in SETTINGS]
)
def test_bands_hold_what_drives_give_on_other_movements(setting: str, tmp_path: Path) -> None:
    law, fit, how = SETTINGS[setting]
    parts = []
    for seed in range(2):
        for name in ("fitted", "fresh"):
            (tmp_path / f"{name}{seed}").mkdir()
        found = fit(
            tmp_path / f"fitted{seed}" / "robot.toml", written(tmp_path / f"fitted{seed}", law, seed=20 + seed, **how)
        )
        fresh = {key: value for key, value in how.items() if key == "delay"}
        parts.append(held(found, written(tmp_path / f"fresh{seed}", law, runs=3, seed=70 + seed, **fresh)))
    assert 0.93 <= np.mean(parts) <= 0.97, parts


@pytest.mark.walk
def test_bands_are_as_wide_as_the_noise_where_much_is_known_and_wider_where_little_is(tmp_path: Path, run: Run) -> None:
    found = {}
    for name, how in {"much": {}, "little": {"runs": 1, "seconds": 6.0}}.items():
        (tmp_path / name).mkdir()
        found[name] = dc.diagnose(tmp_path / name / "robot.toml", written(tmp_path / name, usual, seed=5, **how))
    path = written(tmp_path, usual, runs=1, seed=9)
    half = {name: predicted(known, path)[0].half for name, known in found.items()}
    halves = {name: np.nanmean(width) for name, width in half.items() if width is not None}
    assert halves["much"] == pytest.approx(1.96 * NOISE, rel=0.05)
    assert halves["little"] > 1.1 * halves["much"]
    (tmp_path / "known.json").write_text(found["much"].to_json())
    code, out, _ = run("predict", tmp_path / "known.json", path, "-o", tmp_path / "predicted.csv", "--bands")
    assert code == 0
    rows = list(csv.DictReader((tmp_path / "predicted.csv").read_text().splitlines()))
    assert list(rows[0])[-6:] == [n for i in (1, 2, 3) for n in (f"tau{i}_lo_Nm", f"tau{i}_hi_Nm")]
    assert "blank" in out
    for row in rows:
        for i in (1, 2, 3):
            low, value, high = (row[f"tau{i}_{end}Nm"] for end in ("lo_", "", "hi_"))
            assert (low == "") == (value == "") == (high == "")
            assert not value or float(low) < float(value) < float(high)
    with pytest.raises(UsageError, match="'place' means nothing"):
        dc.predict(found["much"], path, place=path, bands=True)


def test_a_result_that_keeps_no_uncertainty_says_so(tmp_path: Path) -> None:
    path = written(tmp_path, usual, runs=3, seed=1)
    found = dc.identify(tmp_path / "robot.toml", path).to_dict()
    cut = {k: v for k, v in found["joints"][0].items() if k != "uncertainty"}
    old = read_answer(found | {"joints": [cut, *found["joints"][1:]]})
    dc.predict(old, path)
    with pytest.raises(InputError, match="says nothing of how surely it knows joint 1"):
        dc.predict(old, path, bands=True)


def test_ends_are_named_after_their_column() -> None:
    assert named("tau12_Nm") == ("tau12_lo_Nm", "tau12_hi_Nm")
    assert named("current1_A") == ("current1_lo_A", "current1_hi_A")
    assert named("drive1") == ("drive1_lo", "drive1_hi")


def test_a_covariance_is_kept_by_its_factor() -> None:
    A = np.random.default_rng(0).standard_normal((4, 6)) * 10.0 ** np.arange(4)[:, None]
    L = unpacked(packed(A @ A.T))
    np.testing.assert_allclose(L @ L.T, A @ A.T, rtol=1e-7, atol=1e-7)


@pytest.mark.walk
@pytest.mark.parametrize("fit", [dc.identify, dc.diagnose])
def test_what_joints_that_stood_did_not_show_is_not_made_up_of_their_noise(
    fit: Callable[..., Any], tmp_path: Path, run: Run
) -> None:
    """Joint by joint a column of those that stand is noise; scaled by that, it foretold torques of any size."""
    for name in ("alone", "together"):
        (tmp_path / name).mkdir()
    alone = written(tmp_path / "alone", usual, runs=6, seed=7, seconds=6.0, alone=True)
    fresh = written(tmp_path / "together", usual, runs=1, seed=8)
    found = fit(alone.with_name("robot.toml"), alone)
    assert found["rank"] < len(found["parameters"]) == 15
    assert any("base parameters" in each["why"] for each in found["next_measurements"])
    given = np.nanmax(np.abs(predicted(found, fresh)[1]), axis=0)
    told = dc.validate(found.to_dict(), fresh)
    assert (np.array(told["rms_by_joint"]) < given).all()
    assert min(told["unshown_by_joint"][:2]) > 500
    assert sum(dc.validate(found.to_dict(), alone)["unshown_by_joint"]) == 0
    assert held(found.to_dict(), fresh) > 0.95
    result = tmp_path / "found.json"
    result.write_text(json.dumps(found.to_dict()))
    said: list[str] = []
    dc.predict(found.to_dict(), fresh, tell=said.append)
    assert any("must move at once" in words for words in said)
    assert "must move at once" in " ".join(run("validate", result, fresh)[1].split())


def test_a_movement_of_all_joints_shows_all(tmp_path: Path) -> None:
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
    found = dc.identify(tmp_path / "one" / "robot.toml", written(tmp_path / "one", usual, seed=7))
    told = dc.validate(found.to_dict(), written(tmp_path / "other", usual, runs=1, seed=8))
    assert found["rank"] == len(found["parameters"]) == 15
    assert list(told["unshown_by_joint"]) == [0, 0, 0]
