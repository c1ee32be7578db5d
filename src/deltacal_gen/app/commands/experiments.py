"""Before anyone measures: poses are chosen, recordings simulated."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from deltacal_gen.app.commands.clocks import clocks_of, write_two_clocks
from deltacal_gen.app.commands.common import (
    PICTURES,
    AnyRecording,
    AnyRobot,
    Source,
    as_recording,
    as_robot,
    check_output,
    in_motion,
)
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.columns import instrument_path
from deltacal_gen.files.robot import Robot, for_model, for_names
from deltacal_gen.files.sidecar import read_measurement
from deltacal_gen.files.writing import csv_text, write_files, write_recording
from deltacal_gen.instrument.kinds import MOUNTED
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording

if TYPE_CHECKING:
    from deltacal_gen.motion.trajectories import Trajectories
    from deltacal_gen.physics.terms import Term
    from deltacal_gen.results.motion import MotionDiagnosis
    from deltacal_gen.results.plan import CyclePlan, Plan
    from deltacal_gen.results.reader import Given
    from deltacal_gen.results.trajectories import MotionPlan
    from deltacal_gen.results.written import Experiment


def plan(
    robot: AnyRobot,
    model: str | int | None = None,
    output: Source | None = None,
    *,
    optimal: int | None = None,
    picture: Source | None = None,
    gauge: Source | None = None,
    sidecar: Source | None = None,
    **options: Any,
) -> Plan:
    """Return measuring poses for a model: rings by the paper's rule (21), or a D-optimal set.

    Of one axis, and of kind encoder, the answer is a `results.plan.CyclePlan`: joints that are reached from either
    side, see `planning.both_sides`.

    Of kind torque (or model ``MECHANISM/rigid``) the answer is a `results.motion.MotionPlan`: exciting
    trajectories, see `planning.exciting`.

    Parameters
    ----------
    model : str
        Needed but for kinds torque and encoder, and a machine that has but one.
    output : path
        The targets as a CSV that `simulate` reads; the trajectory with its sidecar.
    optimal : int
        So many D-optimal poses instead of rings.
    picture : path
        Condition number against n; of trajectories their course and their limits.
    gauge : path
        A sidecar with ``base_point_mm`` and ``platform_point_mm``: where the ends of a gauge are mounted.
    sidecar : path
        What the readings' own will say: ``kind``, and of images ``[measurement.camera]`` with its ``place``.
    options
        Of `planning.plan`, of `optimal.d_optimal`, of `exciting.exciting`, or of `both_sides.both_sides`.
    """
    from deltacal_gen.motion.kinds import plans_motion
    from deltacal_gen.planning import matrix, planning
    from deltacal_gen.planning.optimal import d_optimal

    model = None if model is None else str(model)
    check_output(output, robot)
    check_output(picture, robot, output, ending=PICTURES)
    if sidecar is not None:
        said = read_measurement(sidecar)
        options["kind"] = options.get("kind") or said.kind
        options["said"] = said
    if plans_motion(options.get("kind"), model):
        if optimal is not None or gauge is not None or sidecar is not None:
            raise UsageError("trajectories are planned without --optimal, --gauge and --sidecar.")
        options.pop("kind", None)
        return cast("Plan", _exciting(as_robot(robot), output, picture, **options))
    robot = as_robot(robot)
    reached = {name: options.pop(name, None) for name in ("positions", "cycles")}
    if (named := _from_both_sides(robot, options.get("kind"))) is not None and gauge is None:
        if optimal is not None or picture is not None or options.get("singular") is not None:
            raise UsageError(
                "joints that are reached from both sides are planned without --optimal, --singular, --picture."
            )
        return cast("Plan", _both_sides(robot, named, output, **reached))
    if any(value is not None for value in reached.values()):
        raise UsageError(
            "positions and cycles are of one axis and of kind encoder; poses have their number by --optimal."
        )
    if model is None:
        model, *others = mechanism_of(robot).models
        if others:
            raise UsageError(
                f"give the model whose parameters the poses shall tell: --model {', '.join((model, *others))}."
            )
    robot = for_model(robot, model)
    if gauge is not None and optimal is not None:
        raise UsageError("D-optimal sets are chosen for positions and distances, not for a gauge.")
    if gauge is not None:
        options = {"kind": MOUNTED, "mount": matrix.read_mount(gauge), **options}
    found = planning.plan(robot, model, **options) if optimal is None else d_optimal(robot, model, optimal, **options)
    if output is not None:
        planning.write_targets(found, output)
    if picture is not None:
        from deltacal_gen.pages import plans

        plans.figure(found, picture)
    return found.answer()


def _from_both_sides(robot: Robot, kind: str | None) -> str | None:
    """Return the kind of readings for which joints are gone through from both sides; None of any other."""
    from deltacal_gen.instrument import kinds

    name = next((n for n in kinds.names() if kind in (n, *kinds.kind_of(n).aliases)), kind)
    if name in kinds.names() and kinds.kind_of(name).sees_joints:
        return name
    machine = mechanism_of(robot)
    one_axis = machine.limbs == 1 and machine.many_ways  # a chain of one joint
    return kinds.POINTS if one_axis and name in (None, kinds.POINTS) else None


def _both_sides(robot: Robot, kind: str, output: Source | None, **options: Any) -> CyclePlan:
    """Return joints that are reached from both sides, written where asked."""
    from deltacal_gen.planning import both_sides

    found = both_sides.both_sides(robot, kind, **options)
    if output is not None:
        both_sides.write_rows(found, output)
    return found.answer()


def _exciting(robot: Robot, output: Source | None, picture: Source | None, **options: Any) -> MotionPlan:
    """Return exciting trajectories, written and drawn where asked."""
    from deltacal_gen.planning import exciting

    found, series = exciting.exciting(robot, **options)
    if output is not None:
        exciting.write_trajectory(robot, series, found.rate_Hz, output)
    if picture is not None:
        from deltacal_gen.pages import plans

        plans.trajectory(robot, found, exciting.columns_of(robot, series, found.rate_Hz), picture)
    return found


def simulate(
    robot: AnyRobot,
    poses: AnyRecording,
    output: Source | None = None,
    *,
    truth: Source | Mapping[str, float] | None = None,
    noise: float = 0.0,
    seed: int = 0,
) -> Recording:
    """Simulate a recording exactly; see `simulation.simulate`, and `motion.simulation.simulated` of one in motion.

    Parameters
    ----------
    truth : path or mapping
        TRUTH.toml, or source errors by name [mm, rad].
    noise : float
        Standard deviation of a reading in its unit: per coordinate mm, px or deg; in motion Nm, N or A. Rotations
        beside lengths have the sidecar's `sigma_deg`, or what 100 mm from the measured point is such a shift.
    seed : int
        Of noise and of an unknown instrument frame.
    """
    from deltacal_gen.physics import simulation

    check_output(output, robot, poses, truth, ending=(".csv",))
    if not (noise >= 0 and np.isfinite(noise)) or seed < 0:
        raise UsageError("noise must be a number that is not negative, and seed an integer from 0.")
    if (moving := in_motion(poses)) is not None:
        if isinstance(truth, Mapping):
            raise UsageError("the truth of a recording in motion is a file, TRUTH.toml.")
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
    done = simulation.simulate(
        robot,
        given,
        errors,
        noise=noise,
        rng=np.random.default_rng(seed),
        terms=terms,
    )
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
    from deltacal_gen.physics import simulation

    if truth is None:
        return robot, None, ()
    robot = for_names(robot, truth if isinstance(truth, Mapping) else simulation.truth_names(truth))
    told = simulation.Truth(dict(truth)) if isinstance(truth, Mapping) else simulation.read_truth(truth, robot)
    names = told.errors.keys() | robot.errors.keys()
    return robot, {n: told.errors.get(n, 0.0) + robot.errors.get(n, 0.0) for n in names}, told.terms


def next_poses(diagnosis: Given, output: Source | None = None, *, budget: int | None = None) -> Experiment:
    """Return the rows to measure next, which settle what a diagnosis leaves open; `output` is POSES.csv.

    Of a diagnosis in motion they are runs: `output` is a trajectory, with its sidecar; see `planning.runs`.

    Parameters
    ----------
    budget : int, optional
        How many rows, shared among the open questions by what is least separated; new poses before repeats. Default as
        many as each question takes.

    Raises
    ------
    InputError
        It is no diagnosis.
    UsageError
        A budget of no row.
    """
    from deltacal_gen.files.writing import csv_text, write_files
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.motion import MotionDiagnosis
    from deltacal_gen.results.written import Asked, Experiment
    from deltacal_gen.use import experiments
    from deltacal_gen.use.known import known_model

    check_output(output, diagnosis)
    if budget is not None and budget < 1:
        raise UsageError(f"a budget of {budget} rows is none; give 1 or more.")
    known = known_model(diagnosis)
    if isinstance(known, MotionDiagnosis):
        return _next_runs(known, output, budget)
    if not isinstance(known, Diagnosis):
        raise InputError("this is no diagnosis, and leaves no question open.", "Give what deltacal diagnose wrote.")
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
        raise UsageError(
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
