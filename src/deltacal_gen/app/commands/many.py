"""Many machines: simulated ones of a study, recorded ones of a batch."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from deltacal_gen.app.commands.common import (
    Source,
    as_recording,
    as_robot,
    check_output,
    deliver,
    in_motion,
    untold,
)
from deltacal_gen.errors import MissingChannel, NoiseUnknown, OptionNotApplicable, ValueOutOfRange, WrongFile

if TYPE_CHECKING:
    from deltacal_gen.app.commands.common import AnyRecording, AnyRobot
    from deltacal_gen.execution import Told
    from deltacal_gen.planning.machines import Study as Machines
    from deltacal_gen.results.batch import Batch
    from deltacal_gen.results.study import Study


def study(
    robot: AnyRobot,
    *,
    plan: AnyRecording,
    model: str | int | None = None,
    machine: str | None = None,
    trials: int = 1000,
    noise: float | None = None,
    suspect: Sequence[Source] = (),
    diagnoses: int = 10,
    seed: int = 0,
    workers: int | None = None,
    cluster: str | None = None,
    resume: Source | None = None,
    output: Source | None = None,
    report: Source | None = None,
    told: Told = untold,
) -> Study:
    """Predict what a measuring plan will give, by Monte Carlo: simulate and calibrate many machines.

    Parameters
    ----------
    robot : path, Robot or RobotTables
        Robot file (TOML).
    plan : path, data frame or Recording
        Planned poses (CSV), joints or targets as simulate takes them, with a sidecar of kind, frame and noise.
    model : str or int, optional
        Model that the calibration identifies: delta/32 or 32; default the largest that the plan can identify.
    machine : str, optional
        Model whose errors the simulated machines have; default that of the calibration.
    trials : int
        Number of simulated machines.
    noise : float, optional
        Measurement noise (1 sigma) in the unit of the readings (mm, px, deg); default that of the sidecar. Rotations
        of poses have the sidecar's sigma_deg, by default noise / 100 mm [rad].
    suspect : sequence of path
        TRUTH.toml with effects that may be present: how often would the diagnosis find them? May be repeated.
    diagnoses : int
        Number of simulated recordings for each suspected set of effects.
    seed : int
        Seed of the random machines and of the noise.
    workers : int, optional
        Number of local processes; default one per core.
    cluster : str, optional
        Dask scheduler to use instead of local processes: tcp://HOST:PORT.
    resume : path, optional
        Folder that keeps intermediate results, so that the same command can go on after a stop.
    output : path, optional
        STUDY.json, the result.
    report : path, optional
        Report (.html).
    told : callable
        Called with how many tasks are done, of how many, and the last.

    Raises
    ------
    InputError
        The plan cannot be reached or carries too little; no noise is given; no scheduler answers at `cluster`.
        Readings of joints, which determine no source error, and nothing is suspected.

    Examples
    --------
    deltacal study robot.toml --plan targets.csv --noise 0.01 -o study.json --report study.html
    """
    from deltacal_gen.files.sidecar import LEAST, MOST
    from deltacal_gen.planning import studies

    if in_motion(plan) is not None:
        raise OptionNotApplicable(
            "a study is of poses, and this is a trajectory: deltacal plan --kind torque says how well it determines "
            "bodies and friction; simulate and diagnose try it on a machine."
        )
    if trials < 1 or diagnoses < 1 or seed < 0 or (noise is not None and not LEAST <= noise <= MOST):
        bounds = f"noise from {LEAST:g} to {MOST:g}"
        raise ValueOutOfRange(f"trials and diagnoses must be at least 1, {bounds}, and seed an integer from 0.")
    check_output(output, robot, plan, *suspect)
    check_output(report, robot, plan, output, *suspect)
    machines, chosen = _machines(robot, plan, model, machine, noise, suspect, seed)
    found = studies.conduct(
        machines, trials, diagnoses, model=chosen, told=told, workers=workers, cluster=cluster, directory=resume
    )
    return deliver(found, output, report)


def _machines(
    robot: AnyRobot,
    plan: AnyRecording,
    model: str | int | None,
    machine: str | None,
    noise: float | None,
    suspects: Sequence[Source],
    seed: int,
) -> tuple[Machines, str]:
    """Return the machines of a study of a plan of poses, and the model that is calibrated."""
    from deltacal_gen.files.robot import for_model
    from deltacal_gen.identification.checks import chosen_model
    from deltacal_gen.instrument.kind import TURN_MM
    from deltacal_gen.instrument.kinds import kind_of
    from deltacal_gen.machine.registry import mechanism_of
    from deltacal_gen.machine.values import Measurement
    from deltacal_gen.physics import simulation
    from deltacal_gen.planning.machines import Study as Machines

    model = None if model is None else str(model)
    robot = as_robot(robot)
    for name in (model, machine):
        robot = robot if name is None else for_model(robot, name)
    poses = as_recording(plan, robot, need_measured=False, allow_targets=True)
    mechanism, kind = mechanism_of(robot), kind_of(poses.kind)
    unit = kind.unit_in(poses.columns)
    said = poses.measurement if noise is None else Measurement().with_noise(unit, noise)
    if kind.sigma(said, 1.0) is None:
        raise NoiseUnknown(
            "nothing says how well the instrument reads.",
            f"Add sigma_{unit} to the sidecar, or --noise.",
            file=poses.path,
        )
    if kind.sees_joints and not suspects:
        raise MissingChannel(
            "these readings see no source error: of such a plan can only be said what a diagnosis would find.",
            "Give --suspect TRUTH.toml.",
            file=poses.path,
        )
    concealed = tuple(simulation.read_truth(file, robot).terms for file in suspects)
    if plain := [file for file, terms in zip(suspects, concealed, strict=True) if not terms]:
        raise WrongFile("this names no effect, so nothing would be concealed.", "Add [[effects]].", file=plain[0])
    made = Machines(robot, poses, (), (), 0.0, 0.0, suspects=concealed, seed=seed)
    sigma = kind.sigma(said, made.instrument.scale) or 0.0
    turns = (poses.measurement.sigma_rad or sigma / TURN_MM) if kind.rotations else 0.0
    made = dataclasses.replace(made, sigma=sigma, turn_sigma=turns)
    chosen = chosen_model(made.problem, model)
    names = mechanism.model(chosen)
    wrong = names if machine is None else mechanism.model(machine)
    return dataclasses.replace(made, names=names, errors=wrong), chosen


def batch(
    folder: Source,
    *,
    output: Source,
    do: Literal["identify", "validate", "diagnose"] = "diagnose",
    model: str | None = None,
    group_by: str | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    told: Told = untold,
) -> Batch:
    """Identify, validate or diagnose all recordings in a folder; resumable.

    Parameters
    ----------
    folder : path
        Folder that holds a folder for each machine: robot.toml and its recordings, or files of printer firmware.
    output : path
        Run directory for table.csv, index.html and all results; what it holds already is not computed again.
    do : {"diagnose", "identify", "validate"}
        What to do with each recording; validate needs a result.json beside each robot.toml.
    model : str, optional
        Model to identify: delta/32 or 32; default the mechanism's largest.
    group_by : str, optional
        Regular expression: recordings whose paths have the same match belong to one machine; default its folder.
    workers : int, optional
        Number of local processes; default one per core.
    cluster : str, optional
        Dask scheduler to use instead of local processes: tcp://HOST:PORT.
    told : callable
        Called with how many tasks are done, of how many, and the last.

    Raises
    ------
    InputError
        A folder without recordings, or one that cannot be written.
    UsageError
        A regular expression that is none.

    Examples
    --------
    deltacal batch machines -o run --do identify
    """
    from deltacal_gen.app import fleet
    from deltacal_gen.files.writing import write_files
    from deltacal_gen.pages import report as pages

    found = fleet.conduct(
        folder, output, do, model=model, machine=group_by, workers=workers, cluster=cluster, told=told
    )
    write_files({Path(output) / "index.html": pages.batch(found, fleet.write_pages(found, Path(output)))})
    return found
