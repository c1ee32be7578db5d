"""The same commands, from the command line, for every mechanism: its example from drawing to corrected commands."""

from __future__ import annotations

import csv
import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.app import cli
from deltacal_gen.files.robot import for_model, read_robot
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from deltacal_gen.machine.rotation import align
from deltacal_gen.physics.simulation import truth_names
from tests.support.drawn import example_of

NOISE = 0.003  # mm
COMPILER = shutil.which("cc")


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Any:
    def command(*arguments: object, code: int = 0) -> str:
        monkeypatch.setattr(sys, "argv", ["deltacal", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            cli.main()
        said = capsys.readouterr()
        assert int(end.value.code or 0) == code, said.err
        return said.out if code == 0 else said.err

    return command


def without_repeats(poses: Path, folder: Path) -> Path:
    """A copy of a file of poses in which each stands once: repeats tell of noise, and take time."""
    head, *rows = poses.read_text().splitlines()
    (folder / "poses.csv").write_text("\n".join([head, *dict.fromkeys(rows)]) + "\n")
    shutil.copy(poses.with_suffix(".toml"), folder / "poses.toml")
    return folder / "poses.csv"


def table(path: Path, *columns: str) -> np.ndarray:
    with path.open() as file:
        rows = list(csv.DictReader(file))
    return np.array([[float(row[c]) for c in columns] for row in rows])


def off_target(reached: np.ndarray, wanted: np.ndarray) -> float:
    """Largest error [mm]; in space up to a motion as a body, since an instrument anywhere does not show the base."""
    if wanted.shape[1] == 3:
        turn = align(wanted - wanted.mean(axis=0), reached - reached.mean(axis=0))
        wanted = (wanted - wanted.mean(axis=0)) @ turn.T + reached.mean(axis=0)
    return float(np.abs(reached - wanted).max())


@pytest.mark.parametrize("name", mechanism_names())
def test_from_drawing_to_corrected_commands(name: str, run: Any, tmp_path: Path) -> None:
    """simulate, identify, matrix, plan, validate, predict, compensate; the true machine then meets its targets."""
    robot, poses, truth = (example_of(name) / file for file in ("robot.toml", "poses.csv", "truth.toml"))
    drawn, poses = read_robot(robot), without_repeats(poses, tmp_path)
    # the model that the readings allow, or of another description of the machine its own
    chosen = [] if drawn.mechanism == name else ["--model", load_mechanism(name).full_model]
    described = mechanism_of(for_model(drawn, chosen[1]) if chosen else drawn)
    simplified = not set(truth_names(truth)) <= described.index.keys()  # what it cannot hold is left
    recording, result, targets = (tmp_path / file for file in ("recording.csv", "result.json", "targets.csv"))
    run("simulate", robot, poses, "-o", recording, "--truth", truth, "--noise", NOISE, "--seed", 4)
    found = json.loads(run("identify", robot, recording, *chosen, "-o", result, "--json"))
    model = found["model"]
    assert model in described.models
    assert found["heldout_rms_mm"] < found["before_rms_mm"] / (1 if simplified else 20)
    run("matrix", robot, recording, "--model", model, "-o", tmp_path / "H.npz")
    with np.load(tmp_path / "H.npz") as file:
        H = dict(file)
    assert H["H"].shape == (len(H["r"]), len(H["names"]))
    assert list(H["names"]) == [p["name"] for p in found["parameters"] if p["status"] != "fixed"]
    assert "chosen" in run("plan", robot, "--model", model, "-o", targets)
    assert "noise" in run("validate", result, recording)
    run("predict", result, recording, "-o", tmp_path / "predicted.csv")
    measured = [
        c for c in recording.read_text().splitlines()[0].split(",") if c in ("x_mm", "y_mm", "z_mm", "gauge_mm")
    ]
    missed = table(tmp_path / "predicted.csv", *measured) - table(recording, *measured)
    assert np.sqrt(np.mean(missed**2)) < (found["before_rms_mm"] if simplified else 3 * NOISE)
    axes = [f"{axis}_mm" for axis in described.axes if f"p{axis}" in described.asks]
    run("compensate", result, targets, "-o", tmp_path / "joints.csv")
    for file in ("joints.toml", "targets.toml"):
        (tmp_path / file).write_text('[measurement]\nkind = "position"\nframe = "robot"\n')
    run("simulate", robot, tmp_path / "joints.csv", "-o", tmp_path / "reached.csv", "--truth", truth)
    run("simulate", robot, targets, "-o", tmp_path / "uncorrected.csv", "--truth", truth)
    run("simulate", robot, targets, "-o", tmp_path / "wanted.csv")
    corrected, plain = (
        off_target(table(tmp_path / file, *axes), table(tmp_path / "wanted.csv", *axes))
        for file in ("reached.csv", "uncorrected.csv")
    )
    assert corrected < plain / (1 if simplified else 10)
    if not described.written_out:
        said = run("compensate", result, "--export", "c", "-o", tmp_path / "command.c", code=2)
        assert "how it stands is part of every command" in " ".join(said.split())
        return
    run("compensate", result, "--export", "c", "-o", tmp_path / "command.c")
    if COMPILER:
        built = [COMPILER, "-std=c99", "-Wall", "-Wextra", "-Werror", "-c", "command.c"]
        assert subprocess.run(built, cwd=tmp_path, check=False).returncode == 0
