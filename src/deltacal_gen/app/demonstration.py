"""The main job on an embedded recording: identify, see the misfit, diagnose, compensate, and only then the truth.

A packaging Delta was measured by a laser tracker in one morning: 150 poses, three payloads, a hall that warms up, the
direction in which each joint arrived. ``examples/gearbox/truth.toml`` says what was concealed in it and with which
command; it is read after everything else is written.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from importlib import resources
from pathlib import Path

import numpy as np

from deltacal_gen.app.commands.calibration import diagnose, identify
from deltacal_gen.estimation.residuals import rms
from deltacal_gen.files.robot import read_robot, robot_to_toml
from deltacal_gen.files.writing import write_files
from deltacal_gen.identification.accuracy import check_poses, workspace_of
from deltacal_gen.pages import figures
from deltacal_gen.physics.simulation import read_truth
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.demo import Check, Concealed, ConcealedParameter, Demo
from deltacal_gen.use.comparison import sizes_aligned
from deltacal_gen.use.compensation import Compensator
from deltacal_gen.use.exporters.c import export_c
from deltacal_gen.use.prediction import calibrated_robot, known_effects
from deltacal_gen.use.spans import spans

SEED = 7  # of the channels at the check poses


def example(name: str = "delta") -> Path:
    """Return the folder of an embedded example: robot.toml, poses.csv, truth.toml, recording.csv."""
    return Path(str(resources.files("deltacal_gen") / "examples" / name))


def run(folder: Path, progress: Callable[[str], None]) -> Demo:
    """Run the demonstration; return what was found, the check against the truth, and the files made below `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    source = example("gearbox")
    robot, recording = read_robot(source / "robot.toml"), source / "recording.csv"
    files = {
        name: folder / name
        for name in ("result.json", "diagnosis.json", "diagnosis.html", "diagnosis.svg", "calibrated.toml", "command.c")
    }
    result = identify(robot, recording, output=files["result.json"], progress=progress)
    found = diagnose(
        robot, recording, output=files["diagnosis.json"], report=files["diagnosis.html"], progress=progress
    )
    progress("picture")
    figures.write(found, files["diagnosis.svg"])
    progress("compensator")
    machine = calibrated_robot(found)
    write_files({files["calibrated.toml"]: robot_to_toml(machine)})
    compensator = Compensator(machine, terms=tuple(known_effects(found)))
    export_c(compensator, files["command.c"], spans(found))
    progress("check against the truth")
    truth = read_truth(source / "truth.toml", robot)
    commanders = (
        ("robot file", Compensator(robot)),
        (f"{result.model}, geometry alone", Compensator(calibrated_robot(result))),
        ("geometry and " + " and ".join(e.name for e in found.findings), compensator),
    )
    true = Compensator(dataclasses.replace(robot, errors=truth.errors), terms=truth.terms)
    return Demo(
        result=result,
        diagnosis=found,
        truth=tuple(map(_in_files, truth.terms)),
        check=_check(true, commanders),
        files={name: str(path) for name, path in files.items()},
    )


def _in_files(term: Term) -> Concealed:
    """Return a concealed effect as truth files write it."""
    factors = {name: (unit, factor) for name, unit, factor, _ in term.kernels.COEFFICIENTS}
    return Concealed(
        name=term.effect,
        limbs=term.limbs,
        parameters=tuple(
            ConcealedParameter(name=name, limb=limb, value=float(value / factor), unit=unit)
            for limb, row in zip(term.limbs or (None,), term.values, strict=True)
            for (name, (unit, factor)), value in zip(factors.items(), row, strict=True)
        ),
    )


def _check(truth: Compensator, commanders: Sequence[tuple[str, Compensator]]) -> tuple[Check, ...]:
    """Return where the true machine stands when it is commanded by each model of it, off the wanted check poses.

    Every pose is reached under a payload and temperature of the recording's ranges and in random directions. What the
    instrument cannot know is where {O} lies; the errors are taken after the best alignment of the whole set, which is
    what localising the base frame does on the floor.
    """
    robot = truth.robot
    targets = np.repeat(check_poses(workspace_of(robot)), 4, axis=0)
    rng, n = np.random.default_rng(SEED), len(targets)
    columns = {"payload_kg": rng.uniform(0.0, 3.0, n), "temp_C": rng.uniform(20.0, 25.0, n), "time_s": np.zeros(n)}
    columns |= {f"approach{i + 1}": rng.choice([-1.0, 1.0], n) for i in range(truth.mechanism.limbs)}
    rows = []
    for name, commander in commanders:
        joints, _ = commander.command(targets, None, commander.channels(columns, n)[0])
        reached, _ = truth.reached(joints, None, truth.channels(columns, n)[0])
        errors = sizes_aligned(targets, reached)
        rows.append(Check(model=name, rms_mm=rms(errors), worst_mm=float(errors.max()), poses=n))
    return tuple(rows)
