"""Before anyone measures: poses are chosen, recordings simulated."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, cast

from deltacal_gen.app.commands.common import Source, as_recording, as_robot, check_output, in_motion
from deltacal_gen.errors import OptionNotApplicable, ValueOutOfRange, WrongFile

if TYPE_CHECKING:
    from deltacal_gen.app.commands.common import AnyRecording, AnyRobot
    from deltacal_gen.machine.values import Recording, Robot
    from deltacal_gen.motion.trajectories import Trajectories
    from deltacal_gen.physics.terms import Term
    from deltacal_gen.results.motion import MotionDiagnosis
    from deltacal_gen.results.reader import Given
    from deltacal_gen.results.written import Experiment


def simulate(
    robot: AnyRobot,
    poses: AnyRecording,
    *,
    truth: Source | Mapping[str, float] | None = None,
    noise: float = 0.0,
    seed: int = 0,
    output: Source | None = None,
) -> Recording:
    """Simulate a recording with the exact non-linear model.

    Kind, frame and camera are those of the poses' sidecar (default: positions in the robot's frame).

    Parameters
    ----------
    robot : path, Robot or RobotTables
        Robot file (TOML).
    poses : path, data frame or Recording
        Joints, or targets x_mm, y_mm, z_mm in {O}, with the channels that effects depend on (CSV).
    truth : path or mapping, optional
        TRUTH.toml: true source errors [mm, deg] and effects; from Python also source errors by name [mm, rad].
    noise : float
        Measurement noise (1 sigma) in the unit of the readings (mm, px, deg; in motion Nm, N, A). Rotations of poses
        have the sidecar's sigma_deg, by default noise / 100 mm [rad].
    seed : int
        Seed of the noise and of an unknown instrument frame.
    output : path, optional
        RECORDING.csv; its sidecar RECORDING.toml is written beside it.

    Raises
    ------
    UsageError
        A noise or seed that is none.
    NoSolutionError
        A target out of reach.

    Examples
    --------
    deltacal simulate robot.toml targets.csv --truth truth.toml --noise 0.01 -o recording.csv
    """
    import numpy as np

    from deltacal_gen.app.commands.clocks import clocks_of, write_two_clocks
    from deltacal_gen.files.writing import write_recording
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.physics import simulation

    check_output(output, robot, poses, truth, ending=(".csv",))
    if not 0 <= noise < math.inf or seed < 0:
        raise ValueOutOfRange("noise must be a number that is not negative, and seed an integer from 0.")
    if (moving := in_motion(poses)) is not None:
        if isinstance(truth, Mapping):
            raise OptionNotApplicable("the truth of a recording in motion is a file, TRUTH.toml.")
        return cast("Recording", _in_motion(moving.simulate(as_robot(robot), truth, noise, seed), output, noise))
    robot = as_robot(robot)
    timed = clocks_of(poses, robot, need_measured=False)
    if timed is None:
        given = as_recording(poses, robot, need_measured=False, allow_targets=True)
    else:
        given = timed.at(timed.simulated(_clock_of(truth)))
    if not isinstance(poses, Recording) and not Path(given.path).with_suffix(".toml").exists():
        given = dataclasses.replace(given, measurement=dataclasses.replace(given.measurement, frame="robot"))
    robot, errors, terms = _truth(robot, truth)
    done = simulation.simulate(robot, given, errors, noise=noise, rng=np.random.default_rng(seed), terms=terms)
    if timed is not None and output is not None:
        write_two_clocks(timed, done, output)
    elif output is not None:
        write_recording(done, output)
    return done


def _clock_of(truth: Source | Mapping[str, float] | None) -> Mapping[str, float]:
    """Return what a truth says of the instrument's clock."""
    from deltacal_gen.physics import simulation

    return simulation.truth_clock(truth) if isinstance(truth, str | Path) else {}


def _in_motion(done: Trajectories, output: Source | None, noise: float) -> Trajectories:
    """Return a simulated recording in motion, written with its sidecar where that is wanted."""
    from deltacal_gen.files.columns import instrument_path
    from deltacal_gen.files.writing import csv_text, write_files
    from deltacal_gen.motion.kinds import columns_of
    from deltacal_gen.motion.simulation import sidecar_text

    if output is not None:
        path, own = Path(output), done.joints_path
        files: dict[Path, str | bytes] = {path.with_suffix(".toml"): sidecar_text(done, noise)}
        if own is None:
            files[path] = csv_text(columns_of(done))
        else:
            files |= {path: Path(own).read_bytes(), instrument_path(path): csv_text(columns_of(done, joints=False))}
        write_files(files)
    return done


def _truth(
    robot: Robot, truth: Source | Mapping[str, float] | None
) -> tuple[Robot, dict[str, float] | None, Sequence[Term]]:
    """Return the mechanism that has what a truth names, all source errors and the effects."""
    from deltacal_gen.files.robot import for_names
    from deltacal_gen.physics import simulation

    if truth is None:
        return robot, None, ()
    robot = for_names(robot, truth if isinstance(truth, Mapping) else simulation.truth_names(truth))
    told = simulation.Truth(dict(truth)) if isinstance(truth, Mapping) else simulation.read_truth(truth, robot)
    names = told.errors.keys() | robot.errors.keys()
    return robot, {n: told.errors.get(n, 0.0) + robot.errors.get(n, 0.0) for n in names}, told.terms


def next_poses(diagnosis: Given, *, budget: int | None = None, output: Source | None = None) -> Experiment:
    """Propose the poses to measure next, to decide what a diagnosis leaves open.

    For a diagnosis in motion it proposes runs of a trajectory. The exit code is 1 if nothing is open.

    Parameters
    ----------
    diagnosis : path or Diagnosis
        DIAGNOSIS.json, written by diagnose.
    budget : int, optional
        Largest number of poses, shared among the open questions: the least decided first, new poses before repeats;
        default as many as each question needs.
    output : path, optional
        POSES.csv: rows to measure and to append to the recording; in motion a trajectory with its sidecar.

    Raises
    ------
    InputError
        It is no diagnosis.
    UsageError
        A budget of no row.

    Examples
    --------
    deltacal next diagnosis.json -o poses.csv
    """
    from deltacal_gen.files.writing import csv_text, write_files
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.motion import MotionDiagnosis
    from deltacal_gen.results.written import Asked, Experiment
    from deltacal_gen.use import experiments
    from deltacal_gen.use.known import known_model

    check_output(output, diagnosis)
    if budget is not None and budget < 1:
        raise ValueOutOfRange(f"a budget of {budget} rows is none; give 1 or more.")
    known = known_model(diagnosis)
    if isinstance(known, MotionDiagnosis):
        return _next_runs(known, output, budget)
    if not isinstance(known, Diagnosis):
        raise WrongFile("this is no diagnosis, and leaves no question open.", "Give what deltacal diagnose wrote.")
    questions = experiments.open_questions(known)
    found = experiments.shared(questions, budget) if questions else experiments.Shared((), ())
    rows = experiments.next_rows(questions, found)
    if rows and output is not None:
        write_files({Path(output): csv_text(experiments.columns_of(rows))})
    return Experiment(
        file=str(output) if rows and output is not None else None,
        poses=tuple(rows),
        questions=tuple(
            Asked(why=q.why, rows=n, expected_chi2=q.after(n)) for q, n in zip(questions, found.counts, strict=False)
        ),
        advice=tuple(f"{n.why}: {n.text}" for n in known.next_measurements if not n.poses),
    )


def _next_runs(known: MotionDiagnosis, output: Source | None, budget: int | None) -> Experiment:
    """Return the runs to record next, written where one of them tells something."""
    from deltacal_gen.planning import runs
    from deltacal_gen.results.written import Experiment

    file = None if output is None else Path(output)
    if budget is not None:
        raise OptionNotApplicable(
            "a diagnosis in motion asks for runs, of which rows are not counted; leave --budget out, or plan as many "
            f"runs as may be: {runs.command(known, file)}"
        )
    found = runs.asked(known, file)
    if found is not None and file is not None:
        runs.write(known, found, file)
    return Experiment(
        file=None if found is None or file is None else str(file),
        poses=(),
        questions=(),
        advice=tuple(f"{n.why}: {n.text}" for n in known.next_measurements),
        motion=None if found is None else found.answer,
    )
