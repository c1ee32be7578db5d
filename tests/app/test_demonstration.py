"""The demonstration: its recording is what its truth says, and it finds, models and takes out what is concealed."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app import demonstration
from deltacal_gen.files.recording import read_recording
from deltacal_gen.machine.registry import load_mechanism


def test_the_recording_is_what_the_command_in_the_truth_file_makes(tmp_path: Path) -> None:
    folder = demonstration.example("gearbox")
    command = next(line for line in (folder / "truth.toml").read_text().splitlines() if "deltacal simulate" in line)
    noise, seed = float(command.split("--noise ")[1].split()[0]), int(command.split("--seed ")[1].split()[0])
    robot = folder / "robot.toml"
    made = dc.simulate(robot, folder / "poses.csv", truth=folder / "truth.toml", noise=noise, seed=seed)
    read = read_recording(folder / "recording.csv", load_mechanism("delta"))
    assert read.measured == pytest.approx(made.measured, abs=0.5001e-4)
    assert read.joints == pytest.approx(made.joints, abs=1e-12)
    assert not [name for name in read.channels if name.startswith("true_")]
    assert all(np.array_equal(read.channels[name], made.channels[name]) for name in read.channels)


@pytest.mark.walk
def test_the_demonstration_finds_models_and_takes_out_what_is_concealed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written: list[set[str]] = []
    read_truth = demonstration.read_truth

    def watched(*arguments: object) -> object:
        written.append({path.name for path in (tmp_path / "demo").iterdir()})
        return read_truth(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(demonstration, "read_truth", watched)
    found = dc.demo(output=tmp_path / "demo")
    assert written == [set(found["files"])]  # the truth is read after everything is written
    diagnosis = found["diagnosis"]
    assert diagnosis == json.loads((tmp_path / "demo" / "diagnosis.json").read_text())
    assert [(e["name"], e["limbs"]) for e in diagnosis["effects"]] == [(t["name"], t["limbs"]) for t in found["truth"]]
    (p,), (true,) = diagnosis["effects"][0]["parameters"], found["truth"][0]["parameters"]
    assert abs(p["value"] - true["value"]) < 3 * p["std"]
    # a misfit that geometry leaves, and noise once it is modelled
    assert found["result"]["heldout_rms_mm"] > 5 * diagnosis["noise"]["sigma_mm"]
    assert diagnosis["final"]["heldout_rms_mm"] < 1.2 * diagnosis["noise"]["sigma_mm"]
    drawn, calibrated, diagnosed = (row["rms_mm"] for row in found["check"])
    assert drawn > calibrated > 20 * diagnosed
    assert diagnosed < 0.01  # below the noise of one reading
    page = (tmp_path / "demo" / "diagnosis.html").read_text()
    assert "Backlash at limb 2" in page
