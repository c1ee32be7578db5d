"""Many machines: simulated ones of a study, recorded ones of a batch."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from deltacal_gen.app.commands.common import (
    AnyRecording,
    AnyRobot,
    Source,
    as_recording,
    as_robot,
    check_output,
    in_motion,
    untold,
    write_json,
)
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import for_model
from deltacal_gen.files.sidecar import LEAST, MOST
from deltacal_gen.files.writing import write_files
from deltacal_gen.instrument.kind import TURN_MM
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Measurement

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
        Standard deviation of a reading in its unit, per coordinate: mm, px or deg. Default the sidecar's. Rotations
        beside lengths have its `sigma_deg`, or what 100 mm from the point is such a shift.
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
        Readings of joints, which see no source error, and nothing is suspected.
    """
    if in_motion(plan) is not None:
        raise UsageError(
            "a study is of poses, and this is a trajectory: deltacal plan --kind torque says how well it determines "
            "bodies and friction; simulate and diagnose try it on a machine."
        )
    if trials < 1 or diagnoses < 1 or seed < 0 or (noise is not None and not LEAST <= noise <= MOST):
        bounds = f"noise from {LEAST:g} to {MOST:g}"
        raise UsageError(f"trials and diagnoses must be at least 1, {bounds}, and seed an integer from 0.")
    check_output(output, robot, plan, *suspects)
    check_output(report, robot, plan, output, *suspects)
    how = {"workers": workers, "cluster": cluster, "directory": directory, "told": told}
    found = _of_poses(robot, plan, model, machine, noise, suspects, seed, trials, diagnoses, **how)
    if output is not None:
        write_json(found, output)
    if report is not None:
        from deltacal_gen.pages import studies as pages

        write_files({Path(report): pages.page(found)})
    return found


def _of_poses(
    robot: AnyRobot,
    plan: AnyRecording,
    model: str | int | None,
    machine: str | None,
    noise: float | None,
    suspects: Sequence[Source],
    seed: int,
    trials: int,
    diagnoses: int,
    **how: Any,
) -> Study:
    """Return the study of a plan of poses."""
    from deltacal_gen.identification.checks import chosen_model
    from deltacal_gen.physics import simulation
    from deltacal_gen.planning import machines, studies

    model = None if model is None else str(model)
    robot = as_robot(robot)
    for name in (model, machine):
        robot = robot if name is None else for_model(robot, name)
    poses = as_recording(plan, robot, need_measured=False, allow_targets=True)
    mechanism, kind = mechanism_of(robot), kind_of(poses.kind)
    unit = kind.unit_in(poses.columns)
    said = poses.measurement if noise is None else Measurement().with_noise(unit, noise)
    if kind.sigma(said, 1.0) is None:
        raise InputError(
            "nothing says how well the instrument reads.",
            f"Add sigma_{unit} to the sidecar, or --noise.",
            file=poses.path,
        )
    if kind.sees_joints and not suspects:
        raise InputError(
            "these readings see no source error: of such a plan can only be said what a diagnosis would find.",
            "Give --suspect TRUTH.toml.",
            file=poses.path,
        )
    concealed = tuple(simulation.read_truth(file, robot).terms for file in suspects)
    made = machines.Study(robot, poses, (), (), 0.0, 0.0, suspects=concealed, seed=seed)
    sigma = kind.sigma(said, made.instrument.scale) or 0.0
    turns = (poses.measurement.sigma_rad or sigma / TURN_MM) if kind.rotations else 0.0
    made = dataclasses.replace(made, sigma=sigma, turn_sigma=turns)
    chosen = chosen_model(mechanism, made.problem, poses, model)
    names = mechanism.model(chosen)
    wrong = names if machine is None else mechanism.model(machine)
    made = dataclasses.replace(made, names=names, errors=wrong)
    return studies.conduct(made, trials, diagnoses, model=chosen, **how)


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
