"""What a recording tells of a machine: its errors, the physics that was left out, the matrix itself."""

from __future__ import annotations

import dataclasses
import io
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from deltacal_gen.app.commands.common import (
    Progress,
    Source,
    as_recording,
    as_robot,
    check_output,
    deliver,
    in_motion,
    made,
    refuse_in_motion,
    silent,
)

if TYPE_CHECKING:
    from deltacal_gen.app.commands.common import AnyRecording, AnyRobot
    from deltacal_gen.estimation.solvers import Solver
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.reader import Given
    from deltacal_gen.results.result import Firmware, Result


def identify(
    robot: AnyRobot,
    recording: AnyRecording,
    *,
    model: str | int | None = None,
    as_distance: bool = False,
    method: str | Solver = "prior",
    truncation: int | str = "gcv",
    robust: bool = True,
    physics: Given | None = None,
    output: Source | None = None,
    report: Source | None = None,
    progress: Progress = silent,
) -> Result:
    """Identify the geometric errors of a machine from a recording, with their uncertainty.

    From a recording in motion (kind torque) it identifies the base parameters of the rigid machine's dynamics.

    Parameters
    ----------
    robot : path, Robot or RobotTables
        Robot file (TOML).
    recording : path, data frame or Recording
        Joints and readings (CSV or Parquet), with their sidecar (TOML) beside them.
    model : str or int, optional
        Model to identify: delta/32 or 32; default the mechanism's largest.
    as_distance : bool
        Use the distances between all pairs of positions, which do not depend on the instrument's frame.
    method : str or Solver
        Estimator: prior ([tolerance] and typical errors regularise), least-squares, tsvd (truncated SVD) or ridge.
    truncation : int or str
        Method tsvd: number of singular values to keep, or the rule that chooses it, gcv or discrepancy.
    robust : bool
        Reduce the weight of outliers.
    physics : path or Diagnosis, optional
        DIAGNOSIS.json of an earlier session: its effects are kept, geometry and instrument frame are fitted again.
    output : path, optional
        RESULT.json, the result.
    report : path, optional
        Report (.html).
    progress : callable
        Called with what is being done.

    Returns
    -------
    Result
        Of a recording in motion a `results.motion.MotionResult`.

    Raises
    ------
    InputError
        A file, or data frame, that cannot be used, with its line, column and the remedy; an output that cannot be
        written.
    UsageError
        An unknown model, method or truncation; an option that means nothing for this recording.
    NoSolutionError
        Readings that contradict each other, or that no machine like this one gives.

    Examples
    --------
    deltacal identify robot.toml recording.csv --model delta/32 -o result.json
    """
    from deltacal_gen.app.commands.clocks import set_in_time, with_clock
    from deltacal_gen.diagnosis import spectrum
    from deltacal_gen.identification import carried, identification
    from deltacal_gen.use import firmware
    from deltacal_gen.use.known import known_diagnosis
    from deltacal_gen.use.prediction import calibrated_robot, known_effects
    from deltacal_gen.use.unseen import explained

    model = None if model is None else str(model)
    check_output(output, robot, recording, physics)
    check_output(report, robot, recording, physics, output)
    if (moving := in_motion(recording)) is not None:
        refuse_in_motion(as_distance=as_distance, physics=physics)
        in_drives = moving.identify(as_robot(robot), model).replace(made=made(robot, recording))
        return cast("Result", deliver(in_drives, output, report))
    diagnosis, files = None if physics is None else known_diagnosis(physics), (robot, recording, physics)
    robot, held = as_robot(robot), [] if diagnosis is None else known_effects(diagnosis)
    given, clock = set_in_time(robot, recording, model, held=held, progress=progress)
    fitted = identification.identify(
        robot,
        given if diagnosis is None else dataclasses.replace(given, begun=diagnosis.begun_s),
        model,
        as_distance=as_distance,
        solver=method,
        truncation=truncation,
        robust=robust,
        held=held if given.time_s is not None else [t.afterwards() for t in held],
        periodic=None if diagnosis is None else carried.Periodic.of(diagnosis),
        machine=None if diagnosis is None else calibrated_robot(diagnosis),
        progress=progress,
    )
    found = explained(fitted.answer())
    if diagnosis is None and firmware.knows(fitted.fit.problem):
        known = firmware.FROM_HEIGHTS if given.pairs is None else firmware.MODEL
        if found.model != firmware.MODEL and firmware.exceeded_by(found.model):
            progress(f"what firmware would fit: {known}")
            of_firmware = identification.identify(robot, given, known, solver=method, robust=robust).answer()
            found = found.replace(firmware=_as_firmware(of_firmware))
    if diagnosis is not None and found.continued is None:
        found = found.replace(never_seen=spectrum.never_seen(diagnosis.seen, robot.joint_sign * given.joints))
    return deliver(with_clock(found, clock).replace(made=made(*files, measured=given)), output, report)


def _as_firmware(found: Result) -> Firmware:
    """Return what of a fit of a firmware's own model stands beside a larger one's."""
    from deltacal_gen.results.result import Firmware

    return Firmware(
        model=found.model,
        train_rms_mm=found.train_rms_mm,
        heldout_rms_mm=found.heldout_rms_mm,
        errors=found.robot.errors,
    )


def diagnose(
    robot: AnyRobot,
    recording: AnyRecording,
    *,
    model: str | int | None = None,
    output: Source | None = None,
    report: Source | None = None,
    write_effect: Source | None = None,
    progress: Progress = silent,
) -> Diagnosis:
    """Find where model and recording differ, and which physical effect explains it.

    From a recording in motion (kind torque) it finds the friction of every joint, and what else drives show.

    Parameters
    ----------
    robot : path, Robot or RobotTables
        Robot file (TOML).
    recording : path, data frame or Recording
        Joints and readings (CSV or Parquet), with their sidecar (TOML) beside them.
    model : str or int, optional
        Geometric model that is fitted along with all effects: delta/32 or 32; default the mechanism's largest.
    output : path, optional
        DIAGNOSIS.json, the result.
    report : path, optional
        Report (.html).
    write_effect : path, optional
        NAME.py: writes the formula that was found as an effect file for derive/effects. If none was found, nothing is
        written and the exit code is 1.
    progress : callable
        Called with what is being done.

    Returns
    -------
    Diagnosis
        Of a recording in motion a `results.motion.MotionDiagnosis`.

    Raises
    ------
    InputError, UsageError, NoSolutionError
        As `identify`.

    Examples
    --------
    deltacal diagnose robot.toml recording.csv -o diagnosis.json --report diagnosis.html
    """
    from deltacal_gen.diagnosis.laws.effect_file import effect_file, effect_name
    from deltacal_gen.files.writing import write_files

    check_output(output, robot, recording)
    check_output(report, robot, recording, output)
    check_output(write_effect, robot, recording, output, report)
    if write_effect is not None:
        effect_name(Path(write_effect))
    if (moving := in_motion(recording)) is not None:
        refuse_in_motion(model=model)
        found = cast("Diagnosis", moving.diagnose(as_robot(robot), progress).replace(made=made(robot, recording)))
    else:
        found = _diagnosed(robot, recording, model, progress)
    progress("report")
    if write_effect is not None and found.laws:
        write_files({Path(write_effect): effect_file(found.laws[0], Path(write_effect))})
    return deliver(found, output, report)


def _diagnosed(robot: AnyRobot, recording: AnyRecording, model: str | int | None, progress: Progress) -> Diagnosis:
    """Return the diagnosis of a recording at rest; clocks and effects, which may move each other, are found in turn."""
    from deltacal_gen.app.commands.clocks import set_in_time, with_clock
    from deltacal_gen.diagnosis import diagnosis
    from deltacal_gen.machine.registry import mechanism_of
    from deltacal_gen.use.prediction import known_effects

    files = (robot, recording)
    robot = as_robot(robot)
    name = None if model is None else mechanism_of(robot).full_name(str(model))
    given, clock = set_in_time(robot, recording, name, doubtful=True, progress=progress)
    found = diagnosis.diagnose(robot, given, name, progress=progress).answer()
    if clock is not None and found.physics:
        held = known_effects(found)
        given, clock = set_in_time(robot, recording, name, held=held, start=clock, doubtful=True, progress=progress)
        found = diagnosis.diagnose(robot, given, name, progress=progress).answer()
    return with_clock(found, clock).replace(made=made(*files, measured=given))


def matrix(
    robot: AnyRobot,
    recording: AnyRecording,
    *,
    model: str | int,
    as_distance: bool = False,
    scaling: Literal["file", "paper", "table", "typical"] = "file",
    output: Source | None = None,
) -> dict[str, Any]:
    """Write the identification matrix of a recording, as arrays.

    The arrays are H (rows, parameters) [mm per unit], r (rows), measured minus nominal [mm], names, units and scaling.
    For a recording in motion (kind torque), H is the regressor of the rigid machine in Nm or N per unit of the inertial
    parameters, with joint and line of each row, the base parameters (base, combinations) and what is unidentifiable.

    Parameters
    ----------
    robot : path, Robot or RobotTables
        Robot file (TOML).
    recording : path, data frame or Recording
        Joints and readings (CSV or Parquet), with their sidecar (TOML) beside them.
    model : str or int
        Model whose parameters are the columns: delta/32 or 32.
    as_distance : bool
        Use the distances between all pairs of positions, which do not depend on the instrument's frame.
    scaling : {"file", "paper", "table", "typical"}
        Units of the columns: file (mm, deg), paper (those of its equations), table (of its tables) or typical (typical
        errors).
    output : path, optional
        FILE.npz, an archive of NumPy.

    Examples
    --------
    deltacal matrix robot.toml recording.csv --model delta/36 --as distance -o matrix.npz
    """
    import numpy as np

    from deltacal_gen.estimation.problem import pose_problem
    from deltacal_gen.files.robot import for_model
    from deltacal_gen.files.writing import write_files
    from deltacal_gen.identification.identifiability import identification_matrix
    from deltacal_gen.machine.registry import mechanism_of
    from deltacal_gen.motion.identification import rigid_model

    check_output(output, robot, recording, ending=(".npz",))
    model = str(model)
    found: Any  # of either sort, whose arrays are called alike
    if (moving := in_motion(recording)) is not None:
        refuse_in_motion(as_distance=as_distance, scaling=scaling != "file")
        robot = as_robot(robot)
        rigid_model(robot, model)
        found = moving.matrix(robot)
        base = np.array(found.base).reshape(-1, 2)
        arrays = {"joint": found.joint, "line": found.line, "base": base[:, 0], "combinations": base[:, 1]}
        arrays |= {"scaling": np.array("file"), "unidentifiable": np.array(found.unseen)}
    else:
        robot = for_model(as_robot(robot), model)
        names = mechanism_of(robot).model(model)
        problem = pose_problem(robot, as_recording(recording, robot), names, as_distance=as_distance)
        found = identification_matrix(problem, scaling)
        arrays = {"scaling": np.array(found.convention)}
    arrays |= {"H": found.H, "r": found.r, "names": np.array(found.names), "units": np.array(found.units)}
    if output is not None:
        stream = io.BytesIO()
        np.savez_compressed(stream, allow_pickle=False, **arrays)
        write_files({Path(output): stream.getvalue()})
    return arrays
