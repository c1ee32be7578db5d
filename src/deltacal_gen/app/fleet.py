"""Many recordings at once: identify, validate or diagnose all that lie in a folder; resumable, one table, one page.

A machine is a folder with a ``robot.toml``; its recordings are the tables beside it that hold joints and readings.
Where there are none, what a printer's firmware or a tracker keeps is imported first. A task carries the files
themselves, so that a worker needs no common file system, and is named by their content: what was done with the same
files is not done again, wherever the run directory has been copied to.
"""

from __future__ import annotations

import functools
import hashlib
import json
import os
import re
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, cast, get_args

from deltacal_gen.app.commands.assess import validate
from deltacal_gen.app.commands.calibration import diagnose, identify
from deltacal_gen.app.moved import moved
from deltacal_gen.errors import DeltacalError, FileNotReadable, ImportUnclear, InputError, UnknownName
from deltacal_gen.execution import Outcome, Store, Task, Told, content_key, run
from deltacal_gen.files import importers
from deltacal_gen.files.lists import is_table_of_joints
from deltacal_gen.files.recording import is_recording
from deltacal_gen.files.robot import robot_of
from deltacal_gen.files.writing import csv_text, write_files
from deltacal_gen.machine.places import place_of
from deltacal_gen.motion import kinds
from deltacal_gen.pages import report
from deltacal_gen.physics.law import PREFIX, load_law
from deltacal_gen.results.base import Answer, Json
from deltacal_gen.results.batch import Action, Batch, Moved, Row, in_table, worst
from deltacal_gen.results.diagnosis import Diagnosis, Geometry, LawTerm, Verdict
from deltacal_gen.results.motion import (
    MotionDiagnosis,
    MotionResult,
    MotionValidation,
)
from deltacal_gen.results.reader import read_answer
from deltacal_gen.results.result import Result
from deltacal_gen.results.validation import Validation

ACTIONS: tuple[Action, ...] = get_args(Action)
FIGURES = "figures"  # key beside those of an answer, in what a task keeps
Contents = Mapping[str, bytes]  # the files of one recording, by what a worker calls them
ROBOT, RECORDING = "robot.toml", "recording.csv"
RESULT = "result.json"  # beside the robot: what its recordings are validated against
PAGES = "pages"  # of single recordings, in the run directory
TABLES = (".csv", ".tsv", ".xlsx", ".xlsm", ".parquet")
OWN = (".toml", ".distances.csv", ".instrument.csv")  # ends of the names of files that belong to a recording
BESIDE = (".distances", ".instrument")  # ends of the names of tables that belong to a recording
LAST = "last.json"  # which files each recording was and which task, the last time that all were done
CONFIGS = ("config-override.g", "config.g")  # of RepRapFirmware: M500 writes the first, which then holds
LOOKED_AT = 1_000_000  # bytes of a text, to tell what it is


@dataclass(frozen=True)
class Job:
    """A recording with its robot.

    Attributes
    ----------
    label : str
        Path of the recording below the folder, and what of the file it is where that holds several.
    machine : str
        Recordings of one machine share it.
    contents : callable
        Returns the files by the name that the worker gives them.
    refused : str or None
        Why it is not done.
    warnings : tuple of str
        Of its import.
    """

    label: str
    machine: str
    contents: Callable[[], Contents]
    refused: str | None = None
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True)
class Session:
    """What firmware or a tracker keeps of a machine, to be imported: recordings of which only the import knows."""

    label: str
    kind: str
    files: Mapping[str, Path]  # by the name that the worker gives them, in the order of the import's arguments


def find(folder: str | Path, action: str = "diagnose", machine: str | None = None) -> list[Job | Session]:
    """Return what a folder holds, in the order of the paths; links are followed.

    Parameters
    ----------
    machine : str, optional
        Regular expression; recordings whose paths give the same match are of one machine, default the folder.

    Raises
    ------
    InputError
        There is neither a recording beside a robot.toml nor anything that can be imported.
    UsageError
        No such action, or no regular expression.
    """
    folder = Path(folder)
    if action not in ACTIONS:
        raise UnknownName(f"there is no action '{action}'; known: {', '.join(ACTIONS)}.")
    _machine_of("", machine)
    found: list[Job | Session] = []
    for place in _folders(folder):
        tables = [t for t in sorted(place.glob("*.csv")) if not t.name.endswith(OWN)]
        recordings = [t for t in tables if is_recording(t) or kinds.is_recording(t)]
        robot = place / ROBOT
        for table in recordings:
            label = table.relative_to(folder).as_posix()
            files = {ROBOT: robot, RECORDING: table}
            for ending in OWN:
                if table.with_suffix(ending).exists():
                    files[f"recording{ending}"] = table.with_suffix(ending)
            refused = None if robot.exists() else f"there is no {ROBOT} beside it."
            if action == "validate":
                files[RESULT] = place / RESULT
                if not files[RESULT].exists():
                    refused = f"there is no {RESULT} beside it, which identify or diagnose write."
            found.append(Job(label, _machine_of(label, machine), functools.partial(_contents, files), refused))
        if not recordings:
            found += _sessions(folder, place, tables)
    if not any(isinstance(f, Session) or f.refused is None for f in found):
        first = next((f for f in found if isinstance(f, Job)), None)
        raise ImportUnclear(
            f"there is no recording beside a {ROBOT}, and nothing that can be imported."
            if first is None
            else f"nothing can be done: {first.label}: {first.refused}",
            f"Give a folder in which each machine has a folder with {ROBOT} and its recordings, or with what its "
            "firmware keeps.",
            file=folder,
        )
    return found


def passed_over(folder: Path, found: Sequence[Job | Session]) -> tuple[str, ...]:
    """Return the tables below a folder that nothing is done with."""
    known = {f.label.partition(":")[0] for f in found}
    for session in found:
        if isinstance(session, Session):
            known |= {path.relative_to(folder).as_posix() for path in session.files.values()}
    tables = (p for place in _folders(folder) for p in sorted(place.iterdir()) if p.suffix.lower() in TABLES)
    names = (p.relative_to(folder).as_posix() for p in tables if not p.stem.endswith(BESIDE))
    return tuple(name for name in names if name not in known)


def _folders(top: Path) -> Iterator[Path]:
    """Yield a folder and all below it, each once, whatever links there are."""
    met = set()
    for path, names, _ in os.walk(top, followlinks=True):
        known = os.stat(path)
        if (known.st_dev, known.st_ino) in met:
            names.clear()
            continue
        met.add((known.st_dev, known.st_ino))
        names[:] = sorted(n for n in names if not n.startswith("."))
        yield Path(path)


def _machine_of(label: str, pattern: str | None) -> str:
    """Return the machine of a recording: its folder, or what a pattern finds; each map of a printer is its own."""
    path, _, part = label.partition(":")
    try:
        match = None if pattern is None else re.search(pattern, path)
    except re.error as error:
        raise UnknownName(f"--group-by is no regular expression: {error}.") from None
    name = match[0] if match else Path(path).parent.as_posix()
    return f"{name} {part}" if part not in ("", "recording") else name


def _sessions(folder: Path, place: Path, tables: Sequence[Path]) -> Iterator[Job | Session]:
    """Yield what can be imported of the files of one folder, and what of them lacks its other half."""

    def label(path: Path) -> str:
        return path.relative_to(folder).as_posix()

    for path in sorted(p for p in place.iterdir() if p.suffix in (".cfg", ".txt")):
        text = _beginning(path)
        if "#*#" in text and "delta_radius" in text:  # Klipper's saved block, of a delta
            yield Session(label(path), "klipper", {path.name: path})
    config = next((place / c for c in CONFIGS if "M665" in _beginning(place / c)), None)
    for table in tables:
        if _beginning(table).startswith("RepRapFirmware height map"):
            if config is None:
                why = (
                    "a height map alone does not say where the carriages were: config.g with its M665 is not beside it."
                )
                yield Job(label(table), place.relative_to(folder).as_posix(), dict, why)
            else:
                yield Session(label(table), "rrf", {config.name: config, table.name: table})
    if (place / ROBOT).exists():
        lists = [p for p in sorted(place.iterdir()) if p.suffix in (".csv", ".txt", ".tsv", ".asc")]
        joints = [p for p in lists if is_table_of_joints(p)]
        if len(lists) == 2 and len(joints) == 1:
            points = next(p for p in lists if p not in joints)
            files = {points.name: points, joints[0].name: joints[0], ROBOT: place / ROBOT}
            yield Session(label(points), "points", files)


def _beginning(path: Path) -> str:
    try:
        with path.open("rb") as file:
            return file.read(LOOKED_AT).decode("utf-8", errors="replace")
    except OSError:
        return ""


@contextmanager
def laid_out(files: Contents) -> Iterator[Path]:
    """Yield a folder with the files, which errors call as the user knows them: by their names, not by where they lie.

    It goes afterwards.
    """
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for name, content in files.items():
            (folder / name).write_bytes(content)
        try:
            yield folder
        except InputError as error:
            file = None if error.file is None else Path(str(error.file)).name
            raise type(error)(error.problem, error.remedy, file=file, line=error.line, column=error.column) from None


def unpack(kind: str, files: Contents) -> Json:
    """Import a session in a folder of its own; runs on a worker.

    Returns
    -------
    dict
        ``recordings``: by name, the files as a job has them, as text; ``warnings`` of the import.
    """
    with laid_out(files) as folder:
        out = folder / "imported"
        made = importers.importer(kind)(*(folder / name for name in files), output=out)
        recordings = {}
        for name in made.recordings:
            ends = (".csv", *OWN)
            parts = {f"recording{e}": (out / f"{name}{e}") for e in ends if (out / f"{name}{e}").exists()}
            recordings[name] = {n: p.read_text(encoding="utf-8") for n, p in {ROBOT: out / ROBOT, **parts}.items()}
        return {"recordings": recordings, "warnings": list(made.warnings)}


def do(action: str, model: str | None, files: Contents) -> Json:
    """Do one task in a folder of its own; runs on a worker."""
    with laid_out(files) as folder:
        robot, recording = folder / ROBOT, folder / RECORDING
        moving = kinds.in_motion(recording) is not None
        model = None if moving else model  # of the geometry
        if action == "validate":
            return _with_figures(validate(folder / RESULT, recording))
        if action == "identify":
            return _with_figures(identify(robot, recording, model=model))
        found = diagnose(robot, recording, model=model)
        # else what is left out would be taken for parts that moved
        if found.verdict is Verdict.ADEQUATE and not moving:
            with suppress(DeltacalError):
                calibrated = identify(robot, recording, model=model)
                geometry = Geometry(robot=calibrated.robot, parameters=calibrated.parameters)
                found = found.replace(geometry=geometry)
        return _with_figures(found)


def _with_figures(found: Answer) -> Json:
    """Return an answer's JSON with its figures for the table: the one process that writes it reads no answers."""
    return found | {FIGURES: _figures(found)}


def conduct(
    folder: str | Path,
    directory: str | Path,
    action: str = "diagnose",
    *,
    model: str | None = None,
    machine: str | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    told: Told = lambda done, total, label: None,
) -> Batch:
    """Do all recordings of a folder, and write ``table.csv`` and ``batch.json`` into the run directory."""
    directory, listed = Path(directory), find(folder, action, machine)
    store = Store(directory)
    where: dict[str, Any] = {"workers": workers, "cluster": cluster, "directory": directory, "told": told}
    todo = list(_unpacked(Path(folder), listed, action, machine, store, where))
    open_ = [job for job in todo if job.refused is None]
    keys: dict[str, str] = {}
    files: dict[str, str] = {}

    def given(job: Job) -> tuple[Any, ...]:
        return action, model, job.contents()

    def tasks() -> Iterator[Task]:
        for job in open_:
            key, files[job.label] = _key(job.contents, action, model)
            keys[job.label] = key
            yield Task(key, job.label, partial(given, job))

    outcomes = run(do, tasks(), **where)
    rows = []
    for job in todo:
        outcome = Outcome("", job.label, None, job.refused) if job.refused is not None else next(outcomes)
        rows.append(_row(job, outcome))
    changed = _changed(open_, keys, files, store, _last(directory))
    passed = passed_over(Path(folder), listed) or None
    found = Batch(action=cast("Action", action), rows=tuple(rows), changed=changed, passed_over=passed)
    lines = [row.to_dict() for row in rows]
    columns = list(dict.fromkeys(name for line in lines for name in line))
    table = {c: [in_table(getattr(row, c, None)) for row in rows] for c in columns}
    write_files(
        {
            directory / "table.csv": csv_text(table),
            directory / "batch.json": json.dumps(found.to_dict(), indent=1) + "\n",
            directory / LAST: json.dumps({n: [files[n], keys[n]] for n in keys}, indent=1) + "\n",
        }
    )
    return found


def _unpacked(
    folder: Path,
    found: Sequence[Job | Session],
    action: str,
    machine: str | None,
    store: Store,
    where: Mapping[str, Any],
) -> Iterator[Job]:
    """Yield all jobs, those of sessions as their import names them."""
    sessions = [f for f in found if isinstance(f, Session)]

    def tasks() -> Iterator[Task]:
        for session in sessions:
            key, _ = _key(functools.partial(_contents, session.files), "import", session.kind)
            yield Task(key, session.label, functools.partial(_imported_from, session))

    outcomes = run(unpack, tasks(), **where)
    for item in found:
        if isinstance(item, Job):
            yield item
            continue
        outcome = next(outcomes)
        if outcome.result is None:
            yield Job(item.label, _machine_of(item.label, machine), dict, outcome.error)
            continue
        beside = {RESULT: (folder / item.label).parent / RESULT} if action == "validate" else {}
        for name in outcome.result["recordings"]:
            label = item.label if name == "recording" else f"{item.label}:{name}"
            contents = functools.partial(_of_session, store, outcome.key, name, beside)
            yield Job(label, _machine_of(label, machine), contents, warnings=tuple(outcome.result["warnings"]))


def _imported_from(session: Session) -> tuple[str, Contents]:
    return session.kind, _contents(session.files)


def _of_session(store: Store, key: str, name: str, beside: Mapping[str, Path]) -> Contents:
    """Return the files of an imported recording, which the run directory keeps."""
    kept = store.get(key)
    if kept is None or kept.result is None:
        raise FileNotReadable("a result that was there is gone.", "Run again.", file=store.folder)
    texts: dict[str, str] = kept.result["recordings"][name]
    return {n: t.encode() for n, t in texts.items()} | dict(_contents(beside))


def _contents(files: Mapping[str, Path]) -> Contents:
    try:
        return {name: path.read_bytes() for name, path in files.items()}
    except OSError as error:
        raise FileNotReadable(f"cannot be read: {error.strerror}.", "Look at the file.", file=error.filename) from None


def _key(contents: Callable[[], Contents], *more: str | None) -> tuple[str, str]:
    """Return the key of a task with these files, and a hash of the files; unreadable ones fail in their turn."""
    digest = hashlib.sha256()
    try:
        for name, content in sorted(contents().items()):
            digest.update(f"{name} {len(content)} ".encode() + content)
    except InputError as error:
        digest.update(str(error).encode())
    return content_key(Batch.named(), *more, digest.hexdigest()), digest.hexdigest()[:32]


def _figures(found: Answer) -> Json:
    """Return what the table says of an answer, by the fields of its row."""
    if isinstance(found, MotionDiagnosis | MotionResult | MotionValidation):
        return _figures_of_drives(found)
    if isinstance(found, Diagnosis):
        robot = robot_of(found.robot)
        return {
            "verdict": str(found.verdict),
            "effects": "; ".join(", ".join(filter(None, (e.name, place_of(robot, e.limbs)))) for e in found.findings),
            "model": found.baseline.model,
            "before_mm": found.baseline.heldout_rms_mm,
            "after_mm": found.final.heldout_rms_mm,
            "noise_mm": found.noise.sigma_mm,
            "law": "; ".join(map(place_of_law, found.laws[0].terms)) if found.laws else None,
        }
    if isinstance(found, Result):
        return {
            "model": found.model,
            "before_mm": found.before_rms_mm,
            "after_mm": found.heldout_rms_mm,
            "fitted_mm": found.train_rms_mm,
            "noise_mm": found.sigma_mm,
        }
    assert isinstance(found, Validation)
    return {"after_mm": found.rms_mm, "worst_mm": found.worst_mm, "chi2_per_dof": found.chi2_per_dof}


def place_of_law(term: LawTerm) -> str:
    """Return what a term of a law moves and what it reads, whatever its shape: ``joint(oil_C, payload)``."""
    states = sorted(load_law(f"{PREFIX}{term.target} = {term.expression}").STATE)
    return f"{term.target}({', '.join(states)})"


def _figures_of_drives(found: MotionDiagnosis | MotionResult | MotionValidation) -> Json:
    """Return what the table says of an answer in motion."""
    if isinstance(found, MotionValidation):
        return {
            "unit_by_joint": found.unit_by_joint,
            "after_by_joint": found.rms_by_joint,
            "readings": found.readings,
            "chi2_per_dof": found.chi2_per_dof,
        }
    said = {
        "unit_by_joint": found.final.unit_by_joint,
        "after_by_joint": found.final.heldout_rms_by_joint,
        "noise_by_joint": found.noise.sigma_by_joint,
    }
    if isinstance(found, MotionResult):
        return said | {"model": found.model, "fitted_by_joint": found.final.train_rms_by_joint}
    return said | {
        "verdict": str(found.verdict),
        "effects": "; ".join(f"{e.name} {' '.join(map(str, e.limbs))}".strip() for e in found.effects),
        "model": found.baseline.model,
        "before_by_joint": found.baseline.heldout_rms_by_joint,
        "law": "; ".join(dict.fromkeys(map(place_of_law, found.laws[0].terms))) if found.laws else None,
    }


def _row(job: Job, outcome: Outcome) -> Row:
    """Return a recording's line of the table."""
    if outcome.result is None:
        return Row(recording=job.label, machine=job.machine, error=outcome.error or "")
    figures: Json = {k: tuple(v) if isinstance(v, list) else v for k, v in outcome.result[FIGURES].items()}
    warnings = " ".join(job.warnings) or None
    return Row(recording=job.label, machine=job.machine, **figures, error=None, warnings=warnings)


# ------------------------------------------------------------------------------------------------------ for readers


def write_pages(found: Batch, directory: Path) -> dict[str, str]:
    """Write the page of each recording, of too many those of the worst; return where they are, by recording.

    A page is named by what the task was made of, and is written once.
    """
    store, last, links = Store(directory), _last(directory), {}
    done = [] if found.action == "validate" else worst(found.rows, report.MOST_DRAWN)
    for row in done:
        kept = None if row.error is not None else store.get(last[row.recording][1])
        if kept is None or kept.result is None:
            continue
        place = Path(PAGES) / f"{last[row.recording][1]}.html"
        if not (directory / place).exists():
            (directory / PAGES).mkdir(exist_ok=True)
            answer = read_answer(kept.result)
            write_files({directory / place: _page(answer)})
        links[row.recording] = place.as_posix()
    return links


def _page(answer: Answer) -> str:
    """Return the page of a recording."""
    if isinstance(answer, MotionResult | MotionDiagnosis):
        from deltacal_gen.pages import motion

        return motion.motion(answer)
    return report.calibration(answer) if isinstance(answer, Result) else report.diagnosis(cast("Any", answer))


# ------------------------------------------------------------------------------------------------------ what changed


def _last(directory: Path) -> dict[str, tuple[str, str]]:
    try:
        known: dict[str, tuple[str, str]] = json.loads((directory / LAST).read_text(encoding="utf-8"))
    except (OSError, json.JSONDecodeError):
        return {}
    return known


def _changed(
    todo: Sequence[Job],
    keys: Mapping[str, str],
    files: Mapping[str, str],
    store: Store,
    last: Mapping[str, tuple[str, str]],
) -> tuple[Moved, ...]:
    """Return what moved, machine by machine: from one recording to the next, and since the last time."""
    changed = []
    before: dict[str, Job] = {}
    for job in todo:
        pairs = []
        if job.machine in before:
            pairs.append((before[job.machine].label, keys[before[job.machine].label]))
        was, task = last.get(job.label, (files[job.label], ""))
        if was != files[job.label]:  # other files; the same ones done by other code are no change
            pairs.append((f"{job.label}, last time", task))
        before[job.machine] = job
        for label, key in pairs:
            old, new = store.get(key), store.get(keys[job.label])
            if old is None or new is None or old.result is None or new.result is None:
                continue
            try:
                text = moved(read_answer(old.result), read_answer(new.result))
            except InputError as error:  # other machines, or a run of another version
                text = str(error)
            if text is not None:
                changed.append(Moved(machine=job.machine, from_=label, to=job.label, text=text))
    return tuple(changed)
