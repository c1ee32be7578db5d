"""The main job on an embedded recording: identify, look, compensate, and hold the outcome against the truth.

The recording was made by ``deltacal simulate`` from ``examples/delta``: robot.toml, poses.csv, truth.toml, with
``--noise 0.005 --seed 2015``. The truth is read only after everything has been identified.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen import commands, compensation, figures
from deltacal_gen.accuracy import check_poses, workspace_of
from deltacal_gen.measurement import align
from deltacal_gen.mechanism import Array, mechanism_of
from deltacal_gen.prediction import calibrated_robot
from deltacal_gen.recording import write_files
from deltacal_gen.robot import Robot, read_robot, robot_to_toml
from deltacal_gen.simulation import read_truth


def example(name: str = "delta") -> Path:
    """Return the folder of an embedded example: robot.toml, poses.csv, truth.toml, recording.csv."""
    return Path(str(resources.files("deltacal_gen") / "examples" / name))


def run(folder: Path, progress: Callable[[str], None]) -> dict[str, Any]:
    """Run the demonstration; return the result, the check against the truth and the files made below `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    source = example()
    robot = read_robot(source / "robot.toml")
    result = commands.identify(robot, source / "recording.csv", output=folder / "result.json", progress=progress)
    calibrated = calibrated_robot(result)
    write_files({folder / "calibrated.toml": robot_to_toml(calibrated)})
    progress("compensator")
    compensation.export_c(compensation.Compensator(calibrated), folder / "compensator.c")
    progress("check against the truth")
    check = _check(robot, calibrated, result, read_truth(source / "truth.toml", robot).errors)
    progress("picture")
    picture = folder / "calibration.png"
    figures.calibration(result, picture, check)
    return {
        "schema": "deltacal.demo/1",
        "result": result,
        "check": [{k: v for k, v in row.items() if k != "errors_mm"} for row in check],
        "picture": str(picture),
        "files": [str(folder / name) for name in ("calibrated.toml", "result.json", "compensator.c")],
    }


def _check(robot: Robot, calibrated: Robot, result: dict[str, Any], truth: dict[str, float]) -> list[dict[str, Any]]:
    """Return where the true machine stands when it is commanded by each model of it, off the wanted check poses.

    What the instrument cannot know is where {O} lies; the errors are taken after the best alignment of the whole set,
    which is what localising the base frame does on the floor.
    """
    mechanism = mechanism_of(robot)
    targets = check_poses(workspace_of(robot))
    true_machine = dataclasses.replace(robot, errors=truth)
    offsets = {n: v for n, v in calibrated.errors.items() if n.startswith("theta_")}
    machines = (
        ("robot file", robot),
        ("encoder offsets alone", dataclasses.replace(robot, errors=offsets)),
        (result["model"], calibrated),
    )
    rows = []
    for name, machine in machines:
        joints, _, _ = mechanism.inverse(targets, robot.tool, mechanism.rows(machine))
        reached, _ = mechanism.forward(joints, robot.tool, mechanism.rows(true_machine))
        errors = np.linalg.norm(_aligned(reached[:, :3], targets), axis=1)
        rows.append(
            {
                "machine": name,
                "rms_mm": float(np.sqrt(np.mean(errors**2))),
                "worst_mm": float(errors.max()),
                "errors_mm": errors.tolist(),
            }
        )
    return rows


def _aligned(reached: Array, wanted: Array) -> Array:
    """Return reached minus wanted (N, 3) after the rigid motion that fits the two best."""
    a, w = reached - reached.mean(axis=0), wanted - wanted.mean(axis=0)
    aligned: Array = a - w @ align(w, a).T
    return aligned
