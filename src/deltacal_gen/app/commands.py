"""The commands as functions: paths or objects in, answers out (see `results`): attributes, and by key the JSON.

A function writes only where it is given an output path, and then all or nothing.
"""

from __future__ import annotations

import dataclasses
import io
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.recording import Recording, csv_text, file_columns, read_recording, write_files, write_recording
from deltacal_gen.files.robot import Robot, for_model, for_names, read_robot
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.results.reader import Given, read_diagnosis, read_result
from deltacal_gen.results.registered import (
    ClaimEntry,
    Dimension,
    EffectEntry,
    EffectUnknown,
    MechanismEntry,
    SourceError,
)
from deltacal_gen.results.result import Firmware, Result
from deltacal_gen.results.written import Derivation
from deltacal_gen.units import DEG, file_unit, joint_factors, joint_names, to_internal

if TYPE_CHECKING:
    from deltacal_gen.execution import Told
    from deltacal_gen.files.imports import Imported
    from deltacal_gen.machine.registry import Array
    from deltacal_gen.physics.physics import Term
    from deltacal_gen.results.base import Answer
    from deltacal_gen.results.batch import Batch
    from deltacal_gen.results.comparison import Comparison
    from deltacal_gen.results.demo import Demo
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.plan import Plan
    from deltacal_gen.results.study import Study
    from deltacal_gen.results.validation import Validation

Source = str | Path
PICTURES = (".svg", ".png", ".pdf")
Progress = Callable[[str], None]


def _silent(text: str) -> None:
    return None


def _untold(done: int, total: int, label: str) -> None:
    return None


def _robot(robot: Source | Robot) -> Robot:
    return robot if isinstance(robot, Robot) else read_robot(robot)


def _recording(recording: Source | Recording, robot: Robot, **how: bool) -> Recording:
    if isinstance(recording, Recording):
        return recording
    return read_recording(recording, mechanism_of(robot), **how)


def check_output(path: Source | None, *inputs: object, ending: Sequence[str] = ()) -> None:
    """Refuse an output that cannot be written, or that is one of the inputs, before anything is computed."""
    if path is None:
        return
    target = Path(path)
    if not str(path) or target.is_dir() or not target.name:
        raise InputError("this is no file to write to.", "Give the name of a file.", file=target)
    if not target.parent.is_dir():
        raise InputError("its folder does not exist.", "Make the folder first.", file=target)
    if ending and target.suffix not in ending:
        raise InputError(f"its name ends with none of {', '.join(ending)}.", "Change the ending.", file=target)
    given = [Path(i) for i in inputs if isinstance(i, str | Path)]
    if target.resolve() in [p.resolve() for i in given for p in (i, i.with_suffix(".toml"))]:
        raise InputError("the output would overwrite an input.", "Choose another name.", file=target)


def write_json(answer: Answer, path: Source) -> None:
    """Write an answer, replacing the file only when it is complete."""
    write_files({Path(path): answer.to_json()})


# --------------------------------------------------------------------------------------------------- the model side


def models() -> list[MechanismEntry]:
    """Return what is registered: every mechanism with its parameters, units and models."""
    return [
        MechanismEntry(
            mechanism=m.name,
            of=m.machine,
            title=m.title,
            reference=m.reference,
            models={name: tuple(names) for name, names in m.models.items()},
            parameters=tuple(
                SourceError(
                    name=p.name,
                    unit=file_unit(p.unit),
                    meaning=p.meaning,
                    typical=p.typical / to_internal(p.unit),
                )
                for p in m.parameters
            ),
            geometry=tuple(
                Dimension(
                    key=g.key,
                    table=g.table,
                    unit=file_unit(g.unit),
                    meaning=g.meaning,
                    required=g.default is None,
                )
                for g in m.geometry
            ),
        )
        for m in map(load_mechanism, mechanism_names())
    ]


def checkout() -> Path | None:
    """Return the root of the source checkout that this package runs from, or None."""
    root = Path(__file__).resolve().parents[3]
    return root if (root / "derive" / "__main__.py").exists() and (root / "templates").is_dir() else None


def effects() -> list[EffectEntry]:
    """Return the registered effects: what each is, its parameters with units, what it reads and moves."""
    from deltacal_gen.physics.physics import effect_names, load_effect

    return [
        EffectEntry(
            effect=name,
            title=found.TITLE,
            per_limb=found.PER_LIMB,
            parameters=tuple(
                EffectUnknown(name=n, unit=unit, meaning=meaning, searched=searched)
                for rows, searched in ((found.COEFFICIENTS, False), (found.CONSTANTS, True))
                for n, unit, _, meaning in rows
            ),
            reads=tuple(found.STATE),
            moves=tuple(found.TARGETS),
        )
        for name, found in ((name, load_effect(name)) for name in effect_names())
    ]


def claims(*, paper: str | None = None, status: str | None = None) -> list[ClaimEntry]:
    """Return the ledger of claims, or the part of one paper or one status: what is printed, what is right, the test.

    Raises
    ------
    UsageError
        There is no such paper or status.
    """
    from deltacal_gen.pages import ledger

    if status is not None and status not in ledger.STATUSES:
        raise UsageError(f"there is no status '{status}'; known: {', '.join(ledger.STATUSES)}.")
    names = ledger.paper_names() if paper is None else (paper,)
    found = (claim for name in names for claim in ledger.load_paper(name).claims)
    return [ClaimEntry(**claim.model_dump()) for claim in found if status in (None, claim.status)]


def _deriving(elsewhere: str) -> Path:
    """Return the root of the checkout in which to derive; raises UsageError where there is none, or no SymPy."""
    root = checkout()
    if root is None:
        raise UsageError(elsewhere)
    if subprocess.run([sys.executable, "-c", "import sympy, jinja2"], capture_output=True).returncode:
        raise UsageError("deriving needs SymPy and Jinja: pip install 'sympy>=1.14,<1.15' jinja2.")
    return root


def derivation(model: str | None, output: Source, *, every: bool = False, progress: Progress = _silent) -> Derivation:
    """Write the report of a derivation for reviewers; return what was written.

    Parameters
    ----------
    model : str
        A model (``delta/42``), a mechanism (its largest model) or an effect.
    output : path
        ``.html`` or ``.md``, whose pictures are written beside it; with `every` a folder for all reports in HTML and
        an index.
    every : bool
        All models of all mechanisms, and all effects.

    Raises
    ------
    UsageError
        No such model; or this is no source checkout, or SymPy is not installed.
    """
    if (model is None) != every:
        raise UsageError("give a model, a mechanism or an effect, or else --all.")
    root = _deriving("reports are made from a source checkout; this is an installed package.")
    target = Path(output)
    if model is not None:
        check_output(output, ending=(".html", ".md"))
    elif target.exists() and not target.is_dir():
        raise InputError("this is a file, and the reports need a folder.", "Choose another name.", file=target)
    answer = _reviewed(root, *([model] if model else []), "-o", target.absolute(), progress=progress)
    folder = target if every else target.parent
    return Derivation(files=tuple(str(folder / Path(line).name) for line in answer.split("\n")))


def _reviewed(root: Path, *arguments: object, progress: Progress = _silent) -> str:
    """Return what ``python -m derive review`` answers; raises its errors, of which `derive.review.command` tells."""
    command = [sys.executable, "-m", "derive", "review", *map(str, arguments)]
    said: list[str] = []
    with subprocess.Popen(
        command, cwd=root, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8"
    ) as process:
        assert process.stderr is not None
        assert process.stdout is not None
        for line in process.stderr:
            said.append(line)
            progress(line.rstrip())
        answer = process.stdout.read().rstrip()
    if process.returncode == UsageError.exit_code:
        raise UsageError(answer)
    if process.returncode == InputError.exit_code:
        raise InputError(**json.loads(answer))
    if process.returncode:
        raise RuntimeError("".join(said) + answer)
    return answer


def warm(progress: Callable[[str, float], None] = lambda name, seconds: None) -> dict[str, float]:
    """Compile modules to byte code and the kernels of all mechanisms ahead; return and tell the seconds of each."""
    import compileall
    import importlib.util
    import time

    spent: dict[str, float] = {}
    for package in ("deltacal_gen", "deltacal_kernels"):
        start, found = time.perf_counter(), importlib.util.find_spec(package)
        if found is not None and found.origin is not None:
            compileall.compile_dir(Path(found.origin).parent, quiet=2)  # a folder that cannot be written stays as it is
        spent[package] = time.perf_counter() - start
        progress(package, spent[package])
    for name in mechanism_names():
        for kernel, seconds in load_mechanism(name).compile():
            spent[kernel] = seconds
            progress(kernel, seconds)
    return spent


def kernels(names: Sequence[str] = (), *, check: bool = False) -> bool:
    """Derive kernels and write them, or with `check` compare them; return whether it went well.

    Parameters
    ----------
    names : sequence of str
        Of mechanisms, effects or measurements; default all.

    The derivation runs in a process of its own: nothing at run time imports SymPy.

    Raises
    ------
    UsageError
        This is no source checkout, or SymPy is not installed.
    """
    root = _deriving("kernels are derived from a source checkout; those of an installed package are done.")
    command = [sys.executable, "-m", "derive", *names, *(["--check"] if check else [])]
    return subprocess.run(command, cwd=root, env={**os.environ, "PYTHONHASHSEED": "0"}).returncode == 0


def trial(robot: Source, output: Source | None = None) -> str:
    """Return in words how a machine does whose kernels were just derived, and draw it from its own equations.

    Parameters
    ----------
    output : path
        The drawing (``.svg``); default named after the mechanism.

    Raises
    ------
    InputError
        The robot file cannot be used.
    UsageError
        This is no source checkout, or SymPy is not installed.
    """
    check_output(output, robot, ending=(".svg",))
    root = _deriving("a machine is drawn from its equations, in a source checkout.")
    answer = _reviewed(root, "--try", Path(robot).absolute(), "-o", Path(output or "").absolute())
    return answer.replace(f"{Path().absolute()}{os.sep}", "")


def plan(
    robot: Source | Robot,
    model: str,
    output: Source | None = None,
    *,
    optimal: int | None = None,
    picture: Source | None = None,
    gauge: Source | None = None,
    **options: Any,
) -> Plan:
    """Return measuring poses for a model: rings by the paper's rule (21), or a D-optimal set.

    Parameters
    ----------
    output : path
        The targets as a CSV that `simulate` reads.
    optimal : int
        So many D-optimal poses instead of rings.
    picture : path
        Condition number against n.
    gauge : path
        A sidecar with ``base_point_mm`` and ``platform_point_mm``: where the ends of a gauge are mounted.
    options
        Of `planning.plan`, or of `planning.d_optimal`.
    """
    from deltacal_gen.planning import planning

    check_output(output, robot)
    check_output(picture, robot, ending=PICTURES)
    robot = for_model(_robot(robot), model)
    if gauge is not None and optimal is not None:
        raise UsageError("D-optimal sets are chosen for positions and distances, not for a gauge.")
    if gauge is not None:
        options = {"kind": "gauge", "mount": planning.read_mount(gauge), **options}
    found = (
        planning.plan(robot, model, **options)
        if optimal is None
        else planning.d_optimal(robot, model, optimal, **options)
    )
    if output is not None:
        planning.write_targets(found, output)
    if picture is not None:
        from deltacal_gen.pages import plans

        plans.figure(found, picture)
    return found.answer()


def simulate(
    robot: Source | Robot,
    poses: Source | Recording,
    output: Source | None = None,
    *,
    truth: Source | Mapping[str, float] | None = None,
    noise: float = 0.0,
    seed: int = 0,
) -> Recording:
    """Simulate a recording exactly; see `simulation.simulate`.

    Parameters
    ----------
    truth : path or mapping
        TRUTH.toml, or source errors by name [mm, rad].
    noise : float
        Standard deviation per coordinate [mm].
    seed : int
        Of noise and of an unknown instrument frame.
    """
    from deltacal_gen.physics import simulation

    check_output(output, robot, poses, truth, ending=(".csv",))
    if not (noise >= 0 and np.isfinite(noise)) or seed < 0:
        raise UsageError("noise must be a number of mm that is not negative, and seed an integer from 0.")
    robot = _robot(robot)
    given = _recording(poses, robot, need_measured=False, allow_targets=True)
    if not isinstance(poses, Recording) and not Path(given.path).with_suffix(".toml").exists():
        given = dataclasses.replace(given, measurement=dataclasses.replace(given.measurement, frame="robot"))
    robot, errors, terms = _truth(robot, truth)
    done = simulation.simulate(
        robot,
        given,
        errors,
        noise_mm=noise,
        noise_rad=given.measurement.sigma_rad or 0.0 if noise else 0.0,
        rng=np.random.default_rng(seed),
        terms=terms,
    )
    if output is not None:
        write_recording(done, output)
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


def simulate_blocks(
    robot: Source | Robot,
    poses: Source,
    output: Source,
    *,
    truth: Source | Mapping[str, float] | None = None,
    noise: float = 0.0,
    seed: int = 0,
) -> int:
    """Simulate a recording of any length, from file to file in a fixed memory; return the rows. See `simulate`.

    Raises
    ------
    UsageError
        A truth with effects: they may ask for the whole recording.
    """
    from deltacal_gen.use import streams

    check_output(output, robot, poses, truth, ending=(".csv",))
    robot, errors, terms = _truth(_robot(robot), truth)
    if terms:
        raise UsageError("effects are not simulated in blocks; leave --blocks out.")
    return streams.simulate(robot, poses, output, errors, noise_mm=noise, rng=np.random.default_rng(seed))


# --------------------------------------------------------------------------------------------------- the data side


def identify_blocks(
    robot: Source | Robot, recording: Source, model: str | None = None, output: Source | None = None
) -> Result:
    """Identify from a recording of any length, in a fixed memory; see `streams.identify`."""
    from deltacal_gen.use import streams

    check_output(output, robot, recording)
    robot = _robot(robot)
    model = mechanism_of(robot).full_model if model is None else model
    found = streams.identify(for_model(robot, model), recording, model).answer()
    if output is not None:
        write_json(found, output)
    return found


def identify(
    robot: Source | Robot,
    recording: Source | Recording,
    model: str | None = None,
    output: Source | None = None,
    *,
    as_distance: bool = False,
    solver: str = "prior",
    truncation: int | str = "gcv",
    robust: bool = True,
    physics: Given | None = None,
    report: Source | None = None,
    progress: Progress = _silent,
) -> Result:
    """Identify a robot's source errors; see `identification.identify` for the options. `output` is RESULT.json.

    `report` is one self-contained HTML page of the same.

    `physics` is a DIAGNOSIS.json whose effects are held while geometry and frame are refitted: how a diagnosis carries
    to another session. Source errors that the model leaves out are held too, as the diagnosis has them. `never_seen`
    of the result says which joints stand where the readings of the diagnosis never were.
    """
    from deltacal_gen.diagnosis import spectrum
    from deltacal_gen.identification import identification
    from deltacal_gen.use import firmware
    from deltacal_gen.use.prediction import calibrated_robot, known_effects

    check_output(output, robot, recording, physics)
    check_output(report, robot, recording, physics)
    diagnosis = None if physics is None else read_diagnosis(physics)
    robot = _robot(robot)
    given = _recording(recording, robot)
    found = identification.identify(
        robot,
        given,
        model,
        as_distance=as_distance,
        solver=solver,
        truncation=truncation,
        robust=robust,
        held=[] if diagnosis is None else known_effects(diagnosis, timed=given.time_s is not None),
        machine=None if diagnosis is None else calibrated_robot(diagnosis),
        progress=progress,
    ).answer()
    if model is None and diagnosis is None and robot.mechanism == firmware.MODEL.partition("/")[0]:
        known = firmware.FROM_HEIGHTS if given.pairs is None else firmware.MODEL
        if known != found.model:
            progress(f"what firmware would fit: {known}")
            beside = identification.identify(robot, given, known, solver=solver, robust=robust).answer()
            fitted = Firmware(
                model=beside.model, train_rms_mm=beside.train_rms_mm, heldout_rms_mm=beside.heldout_rms_mm
            )
            found = found.replace(firmware=fitted)
    if diagnosis is not None:
        found = found.replace(never_seen=spectrum.never_seen(diagnosis.seen, robot.joint_sign * given.joints))
    if output is not None:
        write_json(found, output)
    if report is not None:
        from deltacal_gen.pages import report as page

        write_files({Path(report): page.calibration(found)})
    return found


def diagnose(
    robot: Source | Robot,
    recording: Source | Recording,
    output: Source | None = None,
    *,
    model: str | None = None,
    report: Source | None = None,
    progress: Progress = _silent,
) -> Diagnosis:
    """Find where model and recording differ, and which physics was left out; `output` is DIAGNOSIS.json.

    `model` is the geometry that is fitted beside everything, the mechanism's largest where it is not given; `report`
    is one self-contained HTML page of the same.
    """
    from deltacal_gen.diagnosis import diagnosis

    check_output(output, robot, recording)
    check_output(report, robot, recording)
    robot = _robot(robot)
    given = _recording(recording, robot, doubtful=True)
    found = diagnosis.diagnose(robot, given, model, progress=progress).answer()
    if output is not None:
        write_json(found, output)
    if report is not None:
        from deltacal_gen.pages import report as page

        progress("report")
        write_files({Path(report): page.diagnosis(found)})
    return found


def matrix(
    robot: Source | Robot,
    recording: Source | Recording,
    model: str,
    output: Source | None = None,
    *,
    as_distance: bool = False,
    scaling: str = "file",
) -> dict[str, Any]:
    """Return the identification matrix: H (rows, n), r (rows,) [mm], names, units, scaling; `output` is an .npz."""
    from deltacal_gen.estimation.estimation import pose_problem
    from deltacal_gen.identification.identifiability import identification_matrix

    check_output(output, robot, recording, ending=(".npz",))
    robot = for_model(_robot(robot), model)
    names = mechanism_of(robot).model(model)
    problem = pose_problem(robot, _recording(recording, robot), names, as_distance=as_distance)
    found = identification_matrix(problem, scaling)
    arrays = {
        "H": found.H,
        "r": found.r,
        "names": np.array(found.names),
        "units": np.array(found.units),
        "scaling": np.array(found.convention),
    }
    if output is not None:
        path = Path(output)
        stream = io.BytesIO()
        np.savez_compressed(stream, **arrays)  # type: ignore[arg-type]
        part = path.with_name(f".{path.name}.{os.getpid()}.part")
        try:
            part.write_bytes(stream.getvalue())
            os.replace(part, path)
        except OSError as error:
            raise InputError(f"the file cannot be written: {error.strerror}.", "Check the folder.", file=path) from None
    return arrays


def predict(
    result: Given,
    recording: Source | Recording,
    output: Source | None = None,
    *,
    tell: Progress = _silent,
) -> Recording:
    """Return a recording's readings as an identified or diagnosed model predicts them; `output` is PREDICTED.csv.

    `tell` is told in words which joints stand at angles that the diagnosis never saw.
    """
    from deltacal_gen.diagnosis import spectrum
    from deltacal_gen.use import prediction

    check_output(output, result, recording)
    known = read_result(result)
    robot = prediction.calibrated_robot(known)
    given = _recording(recording, robot, need_measured=False)
    for joint in spectrum.never_seen(known.seen, robot.joint_sign * given.joints):
        tell(spectrum.words(joint))
    done = prediction.predict(known, given)
    if output is not None:
        columns, pairs = file_columns(done)
        write_files({Path(output): csv_text(pairs or columns)})
    return done


def predict_blocks(result: Given, recording: Source, output: Source) -> int:
    """Predict the readings of a recording of any length, from file to file in a fixed memory; return the rows.

    Raises
    ------
    UsageError
        A diagnosis with effects or a smooth correction: they may ask for the whole recording.
    """
    from deltacal_gen.use import streams

    check_output(output, result, recording, ending=(".csv",))
    return streams.predict(_of_rows(result), recording, output)


def _of_rows(result: Given) -> Result | Diagnosis:
    """Return a result by which each row of a recording is predicted for itself."""
    known = read_result(result)
    if known.physics or known.correction is not None:
        raise UsageError("a diagnosis, with its effects, is not used in blocks; leave --blocks out.")
    return known


def validate_blocks(result: Given, recording: Source) -> Validation:
    """Return the error of a calibrated model on a recording of any length, in a fixed memory; see `validate`.

    Raises
    ------
    UsageError
        A diagnosis with effects or a smooth correction: they may ask for the whole recording.
    """
    from deltacal_gen.use import streams

    return streams.validate(_of_rows(result), recording)


def validate(result: Given, recording: Source | Recording) -> Validation:
    """Return the error of a calibrated model on readings it has not seen, against the noise."""
    from deltacal_gen.use import validation

    known = read_result(result)
    robot = validation.calibrated_robot(known)
    return validation.validate(known, _recording(recording, robot))


def compensate(
    result: Given,
    targets: Source | Array | None = None,
    output: Source | None = None,
    *,
    kind: str = "exact",
    export: str | None = None,
    worst_mm: float = 0.01,
    channels: Mapping[str, Array | float] | None = None,
    tell: Progress = _silent,
) -> Array:
    """Return corrected joint commands (N, n_q) [deg or mm] for targets (N, 3) [mm], or export the compensator.

    Parameters
    ----------
    result : path or mapping
        RESULT.json, or DIAGNOSIS.json: then the commands include the effects that were found.
    targets : path or (N, 3) array
        A CSV with ``x_mm, y_mm, z_mm`` in {O} (tool columns and channels too), or positions. Not needed with `export`.
        Of an open chain ``rx_deg, ry_deg, rz_deg`` beside, or an array (N, 6); or a CSV with joints instead, the
        program as it is: wanted is where the chain as drawn stands at them, and it goes on standing so.
    output : path
        JOINTS.csv; with `export` the compensator's own file.
    kind : {"exact", "linear"}
    export : {"c", "table", "klipper", "rrf"}, optional
        The last two: a printer's own lines, see `firmware`.
    worst_mm : float
        Of a table: what it may leave.
    channels : mapping of (N,) arrays or numbers, optional
        Beside an array of targets, what the effects depend on, by the names of a recording's columns:
        ``temp_C, payload_kg, time_s, approach1`` ...
    tell : callable
        Told in words what was assumed where a channel is not given.
    """
    from deltacal_gen.use import compensation, exports, firmware, prediction

    check_output(output, result, targets)
    known = read_result(result)
    robot = prediction.calibrated_robot(known)
    mechanism = mechanism_of(robot)
    terms = prediction.known_effects(known, timed=True)
    compensator = compensation.Compensator(robot, kind, terms)
    if export is not None:
        spans = exports.spans(known)
        writers = {
            "c": lambda path: exports.export_c(compensator, path, spans),
            "table": lambda path: exports.export_table(compensator, path, spans, worst_mm=worst_mm),
            "klipper": lambda path: firmware.export_firmware(robot, "klipper", path, [t.effect for t in terms]),
            "rrf": lambda path: firmware.export_firmware(robot, "rrf", path, [t.effect for t in terms]),
        }
        if export not in writers:
            raise UsageError(f"there is no export '{export}' for {robot.mechanism}; known: {', '.join(writers)}.")
        compensator.needs_loops(f"export '{export}'")
        if output is None:
            raise UsageError("an export needs the file to write: give -o FILE.")
        if known.correction is not None:
            tell("the smooth correction is not part of an export; compensate targets instead")
        writers[export](output)
        return np.zeros((0, mechanism.limbs))
    if targets is None:
        raise UsageError("give the targets: a CSV with x_mm, y_mm, z_mm.")
    recording: Recording | None = None
    tool = near = None
    columns = dict(channels or {})
    if isinstance(targets, str | Path):
        recording = _recording(targets, robot, need_measured=False, allow_targets=True)
        if recording.tool is not None:
            tool = np.where(np.isfinite(recording.tool), recording.tool, robot.tool)
        if recording.targets is not None:
            positions = recording.targets
        elif not mechanism.many_ways:
            raise InputError(
                "the file gives joints, not targets.", "Give the columns x_mm, y_mm, z_mm and no joints.", file=targets
            )
        else:
            near = recording.joints
            positions, _ = compensation.Compensator(compensator.nominal).pose(near, tool)
            if np.isfinite(recording.measured).any():
                tell("readings of the file are not read: wanted is where the chain as drawn stands at its joints")
        columns |= recording.channels
    else:
        positions = np.asarray(targets, dtype=float)
        if mechanism.turning and positions.ndim == 2 and positions.shape[1] == 6:
            positions = np.hstack([positions[:, :3], from_vector(positions[:, 3:] * DEG).reshape(-1, 9)])
    at, assumed = compensator.channels(columns, len(positions))
    for words in assumed:
        tell(words)
    joints = compensator.joints(positions, tool, at, near)
    if mechanism.many_ways and positions.shape[1] > 3:
        turned = np.linalg.norm(compensator.missed(joints, positions, tool, at)[:, 3:], axis=1) / DEG
        if (off := turned > compensation.TURNED_DEG).any():
            why = "it has fewer than six joints" if mechanism.limbs < 6 else "it is near singular there"
            tell(
                f"{off.sum()} of {len(off)} commands leave the last frame turned by up to {turned.max():.2g} deg: {why}"
            )
    if (correction := known.correction) is not None:
        if kind_of(known.instrument.kind).positions:
            joints, share = prediction.corrected_joints(known, correction, joints, tool, columns)
            if (outside := share < 0.5).any():
                tell(f"{outside.sum()} of {len(share)} targets lie outside what the smooth correction was made of")
        else:
            tell("the smooth correction is not part of these commands: it was made of readings that know no position")
    factors = joint_factors(mechanism.joint_unit, mechanism.limbs)
    if output is not None:
        table: dict[str, Any] = {} if recording is None else {"pose": recording.pose.tolist()}
        table |= zip(joint_names(mechanism.joint_unit, mechanism.limbs), (joints / factors).T, strict=True)
        if tool is not None:  # so that the file can be simulated, or measured, as it stands
            table |= {f"tool_{axis}_mm": values for axis, values in zip("xyz", tool.T, strict=True)}
        write_files({Path(output): csv_text(table)})
    in_files: Array = joints / factors
    return in_files


def compare(before: Given, after: Given, output: Source | None = None) -> Comparison:
    """Return what changed between two sessions of one machine, by parameter with its uncertainty; see `comparison`."""
    from deltacal_gen.use import comparison

    check_output(output, before, after)
    found = comparison.compare(_calibration(before), _calibration(after))
    if output is not None:
        write_json(found, output)
    return found


def _calibration(given: Given) -> Result:
    """Return a result of `identify`; a diagnosis has no parameters to compare."""
    found = read_result(given)
    if not isinstance(found, Result):
        raise InputError(
            "this is no result of identify.",
            "Give two files that identify wrote; of a diagnosed session: identify --physics DIAGNOSIS.json.",
            file=None if isinstance(given, Mapping) else given,
        )
    return found


def import_klipper(path: Source, output: Source | None = None) -> Imported:
    """Return a robot and recordings of a Klipper printer.cfg; see `imports.import_klipper`."""
    from deltacal_gen.files import imports

    return imports.import_klipper(path, output)


def import_rrf(config: Source, height_map: Source, output: Source | None = None) -> Imported:
    """Return a robot and a recording of RepRapFirmware's config.g and height map; see `imports.import_rrf`."""
    from deltacal_gen.files import imports

    return imports.import_rrf(config, height_map, output)


def import_points(
    points: Source, joints: Source, robot: Source | None = None, output: Source | None = None
) -> Imported:
    """Return a recording of a tracker's list of points and a table of joints; see `points.import_points`."""
    from deltacal_gen.files import points as lists

    return lists.import_points(points, joints, robot, output)


def demo(output: Source = "demo", progress: Progress = _silent) -> Demo:
    """Run the main job on the embedded recording; write its files and a picture below `output`."""
    from deltacal_gen.app import demonstration

    if Path(output).exists() and not Path(output).is_dir():
        raise InputError("this is a file, and the demonstration needs a folder.", "Choose another name.", file=output)
    return demonstration.run(Path(output), progress)


# -------------------------------------------------------------------------------------------------------- the manual


def manual(topic: str | None = None) -> str:
    """Return a page of the manual as Markdown, without a topic its contents.

    Raises
    ------
    UsageError
        There is no such topic; the nearest are named.
    """
    from deltacal_gen.pages import manual as pages

    return pages.read(topic or pages.CONTENTS).text


def manual_site(folder: Source) -> Path:
    """Write the manual as a site that opens from disk and can be searched; return its first page.

    Raises
    ------
    InputError
        The folder cannot be made or written.
    """
    from deltacal_gen.pages import site

    made = site.files(Path(folder))
    for place in {path.parent for path in made}:
        _make(place)
    write_files(made)
    return next(iter(made))


def manual_examples(folder: Source) -> list[Path]:
    """Copy the examples on which the manual's commands run into `folder`; return their folders.

    Raises
    ------
    InputError
        The folder cannot be made, or holds one of them already: what was tried there is not overwritten.
    """
    from deltacal_gen.app.demonstration import example

    names = sorted(path.parent.name for path in example("").glob("*/robot.toml"))
    copies = [Path(folder) / name for name in names]
    if there := next((path for path in copies if path.exists()), None):
        raise InputError("this is there already.", "Choose another folder.", file=there)
    _make(Path(folder))
    for name, copy in zip(names, copies, strict=True):
        shutil.copytree(example(name), copy, ignore=shutil.ignore_patterns("*.png", "*.svg"))
    return copies


def _make(folder: Path) -> None:
    """Make a folder, if it is not there."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"the folder cannot be made: {error.strerror}.", "Choose another.", file=folder) from None


# ------------------------------------------------------------------------------------------------- studies and fleets


def study(
    robot: Source | Robot,
    plan: Source | Recording,
    output: Source | None = None,
    *,
    model: str | None = None,
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
    told: Told = _untold,
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
    from deltacal_gen.identification.identification import chosen_model
    from deltacal_gen.physics import simulation
    from deltacal_gen.planning import studies

    check_output(output, robot, plan, *suspects)
    check_output(report, robot, plan, *suspects)
    if trials < 1 or diagnoses < 1 or seed < 0 or (noise is not None and not (noise > 0 and np.isfinite(noise))):
        raise UsageError("trials and diagnoses must be at least 1, noise above 0 mm, and seed an integer from 0.")
    robot = _robot(robot)
    for name in (model, machine):
        robot = robot if name is None else for_model(robot, name)
    poses = _recording(plan, robot, need_measured=False, allow_targets=True)
    sigma = noise if noise is not None else poses.measurement.sigma_mm
    if sigma is None:
        raise InputError(
            "nothing says how well the instrument reads.",
            "Add sigma_mm to the sidecar, or --noise MM.",
            file=poses.path,
        )
    mechanism = mechanism_of(robot)
    concealed = tuple(simulation.read_truth(file, robot).terms for file in suspects)
    made = studies.Study(
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
    told: Told = _untold,
) -> Batch:
    """Identify, validate or diagnose all recordings of a folder; see `fleet.conduct`. A page stands by the table."""
    from deltacal_gen.app import fleet
    from deltacal_gen.pages import report as pages

    found = fleet.conduct(
        folder, directory, action, model=model, machine=machine, workers=workers, cluster=cluster, told=told
    )
    write_files({Path(directory) / "index.html": pages.batch(found)})
    return found
