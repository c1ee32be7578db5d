"""Many machines: simulated ones of a study, recorded ones of a batch."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.app.commands.common import (
    AnyRecording,
    AnyRobot,
    Source,
    as_recording,
    as_robot,
    check_output,
    untold,
    write_json,
)
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import for_model
from deltacal_gen.files.writing import write_files
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.units import DEG

if TYPE_CHECKING:
    from deltacal_gen.execution import Told
    from deltacal_gen.results.batch import Batch
    from deltacal_gen.results.study import Study


def study(
    robot: AnyRobot,
    plan: AnyRecording,
    output: Source | None = None,
    *,
    model: str | int | None = None,
    machine: str | None = None,
    trials: int = 1000,
    noise: float | None = None,
    suspects: Sequence[Source] = (),
    diagnoses: int = 10,
    seed: int = 0,
    workers: int | None = None,
    cluster: str | None = None,
    directory: Source | None = None,
    report: Source | None = None,
    told: Told = untold,
) -> Study:
    """Say what a measuring plan will give; see `studies.conduct`.

    Parameters
    ----------
    plan : path or Recording
        Poses as `simulate` takes them: joints or targets, with a sidecar that says kind, frame and noise.
    model : str, optional
        What the calibration frees; default the largest that the plan carries.
    machine : str, optional
        Model of what machines are wrong in; default what the calibration frees.
    noise : float, optional
        Standard deviation per coordinate [mm], where the sidecar says none.
    suspects : sequence of path
        TRUTH.toml files, each with the effects of one suspicion.
    diagnoses : int
        Recordings in which each suspicion is concealed.
    directory : path, optional
        Where results are kept, to be resumed.
    report : path, optional
        One self-contained HTML page of the same.

    Raises
    ------
    InputError
        The plan cannot be reached or carries too little; no noise is given; no scheduler answers at `cluster`.
    """
    from deltacal_gen.identification.checks import chosen_model
    from deltacal_gen.physics import simulation
    from deltacal_gen.planning import machines, studies

    model = None if model is None else str(model)
    check_output(output, robot, plan, *suspects)
    check_output(report, robot, plan, *suspects)
    if trials < 1 or diagnoses < 1 or seed < 0 or (noise is not None and not (noise > 0 and np.isfinite(noise))):
        raise UsageError("trials and diagnoses must be at least 1, noise above 0 mm, and seed an integer from 0.")
    robot = as_robot(robot)
    for name in (model, machine):
        robot = robot if name is None else for_model(robot, name)
    poses = as_recording(plan, robot, need_measured=False, allow_targets=True)
    sigma = noise if noise is not None else poses.measurement.sigma_mm
    if sigma is None:
        raise InputError(
            "nothing says how well the instrument reads.",
            "Add sigma_mm to the sidecar, or --noise MM.",
            file=poses.path,
        )
    mechanism = mechanism_of(robot)
    concealed = tuple(simulation.read_truth(file, robot).terms for file in suspects)
    made = machines.Study(
        robot, poses, (), (), sigma, (poses.measurement.sigma_deg or 0.0) * DEG, suspects=concealed, seed=seed
    )
    chosen = chosen_model(mechanism, made.problem, poses, model)
    names = mechanism.model(chosen)
    wrong = names if machine is None else mechanism.model(machine)
    made = dataclasses.replace(made, names=names, errors=wrong)
    found = studies.conduct(
        made, trials, diagnoses, model=chosen, workers=workers, cluster=cluster, directory=directory, told=told
    )
    if output is not None:
        write_json(found, output)
    if report is not None:
        from deltacal_gen.pages import report as pages

        write_files({Path(report): pages.study(found)})
    return found


def batch(
    folder: Source,
    directory: Source,
    action: str = "diagnose",
    *,
    model: str | None = None,
    machine: str | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    told: Told = untold,
) -> Batch:
    """Identify, validate or diagnose all recordings of a folder; see `fleet.conduct`. A page stands by the table."""
    from deltacal_gen.app import fleet
    from deltacal_gen.pages import report as pages

    found = fleet.conduct(
        folder, directory, action, model=model, machine=machine, workers=workers, cluster=cluster, told=told
    )
    write_files({Path(directory) / "index.html": pages.batch(found, fleet.write_pages(found, Path(directory)))})
    return found
