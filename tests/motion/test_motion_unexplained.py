"""What no ladder explains of a recording in motion: told with its joint, and on what it depends."""

from __future__ import annotations

from itertools import count
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from tests.support.motion_recordings import DEG, STEP, usual, written


@pytest.mark.walk
def test_what_no_rung_explains_is_told_with_its_joint(tmp_path: Path) -> None:
    """A stop in which the rest of a movement is lost: torque that depends on the ways it came."""
    second = np.array([0.0, 1.0, 0.0])

    def dragged(states: np.ndarray, load: np.ndarray) -> np.ndarray:
        """What is pushed along where a joint goes farther than before, and holds it there."""
        pushed = np.zeros_like(load)
        for n in range(1, len(load)):
            pushed[n] = np.clip(pushed[n - 1], states[0, n] - 0.08, states[0, n] + 0.08)
        return -40.0 * (states[0] - pushed) * second

    path = written(tmp_path, dragged, seed=3)
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert found["verdict"] == "unexplained"
    assert [u["limb"] for u in found["unexplained"]] == [2]


@pytest.mark.walk
def test_friction_that_runs_in_depends_on_the_time(tmp_path: Path) -> None:
    """In proportion to the speed, whose mean is none: what is left does not go with the time by itself."""
    second, run = np.array([0.0, 1.0, 0.0]), count()

    def friction(states: np.ndarray, load: np.ndarray) -> np.ndarray:
        t = (12.0 * next(run) + STEP * np.arange(len(load)))[:, None]
        return 0.02 * (1 + np.exp(-t / 15.0)) * states[1] / DEG * second

    found = dc.diagnose(tmp_path / "robot.toml", written(tmp_path, friction, seed=7))
    assert [(u["limb"], u["channel"]) for u in found["unexplained"]] == [(2, "time")]


@pytest.mark.walk
def test_what_is_no_noise_and_depends_on_nothing_recorded_is_not_adequate(tmp_path: Path) -> None:
    """Drag that comes and goes by itself: slow against the samples, told by nothing in the file."""
    slow = np.repeat(np.random.default_rng(9).standard_normal(13), 100)[50:1250]
    second = np.array([0.0, 1.0, 0.0])
    path = written(tmp_path, lambda s, load: slow[:, None] * second + 0 * load, seed=4)
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert found["verdict"] == "unexplained"
    assert [u["limb"] for u in found["unexplained"]] == [2]


def test_a_movement_too_short_to_tell_is_told_so(tmp_path: Path) -> None:
    """What bodies are fitted to five seconds meets these, and foretells nothing."""
    found = dc.diagnose(tmp_path / "robot.toml", written(tmp_path, usual, runs=1, seconds=5.0, seed=4))
    assert [u["limb"] for u in found["unexplained"]] == [1, 2, 3]
    assert all("it moved too little" in u["text"] and "nothing recorded" not in u["text"] for u in found["unexplained"])
    (longer, *_) = found["next_measurements"]
    assert longer["text"].startswith("Record joint 1, 2, 3 for longer")
    assert longer["run"] == ["q", "qd"]  # of which `next` makes a movement


@pytest.mark.walk
def test_what_each_run_has_of_its_own_is_told(tmp_path: Path) -> None:
    """A sensor whose zero is another one in every run: no function of anything recorded foretells it."""
    zeros = iter([0.8, -1.5, 2.0, -0.6])
    path = written(tmp_path, lambda s, load: usual(s, load) + next(zeros) * np.array([0.0, 1.0, 0.0]), seed=5)
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert [(u["limb"], u["channel"]) for u in found["unexplained"]] == [(2, "run")]
    assert found["unexplained"][0]["share"] > 0.8
    assert found["laws"] == []
    assert "zero it before it" in found["next_measurements"][0]["text"]
