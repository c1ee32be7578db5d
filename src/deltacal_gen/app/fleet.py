"""Many recordings at once: identify, validate or diagnose all that lie in a folder; resumable, one table, one page.

A machine is a folder with a ``robot.toml``; its recordings are the tables beside it that hold joints and readings.
Where there are none, what a printer's firmware or a tracker keeps is imported first. A task carries the files
themselves, so that a worker needs no common file system, and is named by their content: what was done with the same
files is not done again, wherever the run directory has been copied to.
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
import os
import re
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from operator import attrgetter
from pathlib import Path
from typing import Any, cast, get_args

from deltacal_gen.app.commands.assess import validate
from deltacal_gen.app.commands.calibration import diagnose, identify
from deltacal_gen.app.moved import moved
from deltacal_gen.errors import DeltacalError, FileNotReadable, ImportUnclear, InputError, UnknownName
from deltacal_gen.execution import Outcome, Store, Task, Told, content_key, run
from deltacal_gen.files import importers
from deltacal_gen.files.recording import is_recording
from deltacal_gen.files.writing import csv_text, write_files
from deltacal_gen.motion import kinds
from deltacal_gen.pages import report
from deltacal_gen.pages.answer import page_of
from deltacal_gen.physics.law import PREFIX, load_law
from deltacal_gen.results.base import Answer, Json
from deltacal_gen.results.batch import Action, Batch, Moved, Row, in_table, worst
from deltacal_gen.results.diagnosis import Diagnosis, Geometry, LawTerm, Verdict
from deltacal_gen.results.motion import MotionDiagnosis, MotionResult, MotionValidation
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
_JOINTS = {"unit_by_joint": "final.unit_by_joint", "after_by_joint": "final.heldout_rms_by_joint"}
_JOINTS |= {"noise_by_joint": "noise.sigma_by_joint"}
_FIELDS: Mapping[type[Answer], Mapping[str, str]] = {  # of a row: where an answer has them
    Diagnosis: {
        "verdict": "verdict",
        "model": "baseline.model",
        "before_mm": "baseline.heldout_rms_mm",
        "after_mm": "final.heldout_rms_mm",
        "noise_mm": "noise.sigma_mm",
    },
    Result: {
        "model": "model",
        "before_mm": "before_rms_mm",
        "after_mm": "heldout_rms_mm",
        "fitted_mm": "train_rms_mm",
        "noise_mm": "sigma_mm",
    },
    Validation: {"after_mm": "rms_mm", "worst_mm": "worst_mm", "chi2_per_dof": "chi2_per_dof"},
    MotionDiagnosis: {
        "verdict": "verdict",
        "model": "baseline.model",
        "before_by_joint": "baseline.heldout_rms_by_joint",
        **_JOINTS,
    },
    MotionResult: {"model": "model", "fitted_by_joint": "final.train_rms_by_joint", **_JOINTS},
    MotionValidation: {
        "unit_by_joint": "unit_by_joint",
        "after_by_joint": "rms_by_joint",
        "readings": "readings",
        "chi2_per_dof": "chi2_per_dof",
    },
}


@dataclass(frozen=True)
class Job:
    """A recording with its robot, or what firmware or a tracker keeps, which is to be imported first.

    Attributes
    ----------
    label : str
        Path of the recording below the folder, and what of the file it is where that holds several.
    machine : str
        Recordings of one machine share it.
    files : mapping of str to Path
        By the names that the worker gives them; of what is imported in the order of the import's arguments.
    refused : str or None
        Why it is not done.
    warnings : tuple of str
        Of its import.
    kind : str or None
        Of the import that it needs.
    """

    label: str
    machine: str
    files: Mapping[str, Path]
    refused: str | None = None
    warnings: tuple[str, ...] = ()
    kind: str | None = None

    def contents(self) -> Contents:
        """Return what is in the files."""
        try:
            return {name: path.read_bytes() for name, path in self.files.items()}
        except OSError as error:
            problem = f"cannot be read: {error.strerror}."
            raise FileNotReadable(problem, "Look at the file.", file=error.filename) from None


def find(folder: str | Path, action: str = "diagnose", machine: str | None = None) -> list[Job]:
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
    found: list[Job] = []
    for place in _folders(folder):
        tables = [t for t in sorted(place.glob("*.csv")) if not t.name.endswith(OWN)]
        recordings = [t for t in tables if is_recording(t) or kinds.is_recording(t)]
        result = place / RESULT if action == "validate" else None
        found += [_job(t.relative_to(folder).as_posix(), machine, place / ROBOT, t, result) for t in recordings]
        for kind, path, files in () if recordings else importers.recognised(place):
            label = path.relative_to(folder).as_posix()
            found.append(Job(label, _machine_of(label, machine), {f.name: f for f in files}, kind=kind))
    if all(job.refused for job in found):
        raise ImportUnclear(
            f"nothing can be done: {found[0].label}: {found[0].refused}"
            if found
            else f"there is no recording beside a {ROBOT}, and nothing that can be imported.",
            f"Give a folder in which each machine has a folder with {ROBOT} and its recordings, or with what its "
            "firmware keeps.",
            file=folder,
        )
    return found


def _job(label: str, machine: str | None, robot: Path, table: Path, result: Path | None, *warnings: str) -> Job:
    """Return the job of a recording; `result` is what it is validated against."""
    files = {ROBOT: robot, RECORDING: table} | ({} if result is None else {RESULT: result})
    files |= {f"recording{end}": own for end in OWN if (own := table.with_suffix(end)).exists()}
    refused = None if robot.exists() else f"there is no {ROBOT} beside it."
    if result is not None and not result.exists():
        refused = f"there is no {RESULT} beside it, which identify or diagnose write."
    return Job(label, _machine_of(label, machine), files, refused, warnings)


def passed_over(folder: Path, found: Sequence[Job]) -> tuple[str, ...]:
    """Return the tables below a folder that nothing is done with."""
    known = {path for job in found for path in job.files.values()}
    tables = (p for place in _folders(folder) for p in sorted(place.iterdir()) if p.suffix.lower() in TABLES)
    return tuple(p.relative_to(folder).as_posix() for p in tables if p not in known and not p.stem.endswith(BESIDE))


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


@contextmanager
def _called_by_name() -> Iterator[None]:
    """Let errors call files by their names, as the user knows them, not by where they lie."""
    try:
        yield
    except InputError as error:
        file = None if error.file is None else Path(str(error.file)).name
        raise type(error)(error.problem, error.remedy, file=file, line=error.line, column=error.column) from None


def unpack(kind: str, files: Sequence[Path], folder: Path) -> Json:
    """Import what firmware or a tracker keeps into a folder; return the names of its recordings, and its warnings."""
    with _called_by_name():
        made = importers.importer(kind)(*files, output=folder)
    return {"recordings": list(made.recordings), "warnings": list(made.warnings)}


def _unpacked(
    found: Sequence[Job], folder: Path, into: Path, action: str, machine: str | None, workers: int | None
) -> Iterator[Job]:
    """Yield all jobs, those of an import as it names them."""

    def given(job: Job) -> tuple[Any, ...]:
        return job.kind, list(job.files.values()), into / job.label

    outcomes = run(unpack, [Task("", job.label, partial(given, job)) for job in found if job.kind], workers=workers)
    for job in found:
        if job.kind is None:
            yield job
            continue
        outcome, made = next(outcomes), into / job.label
        if outcome.result is None:
            yield dataclasses.replace(job, refused=outcome.error)
            continue
        result = (folder / job.label).parent / RESULT if action == "validate" else None
        for name in outcome.result["recordings"]:
            label = job.label if name == "recording" else f"{job.label}:{name}"
            yield _job(label, machine, made / ROBOT, made / f"{name}.csv", result, *outcome.result["warnings"])


def do(action: str, model: str | None, files: Contents) -> Json:
    """Do one task in a folder of its own; runs on a worker."""
    with tempfile.TemporaryDirectory() as temporary, _called_by_name():
        folder = Path(temporary)
        for name, content in files.items():
            (folder / name).write_bytes(content)
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
    folder, directory, listed = Path(folder), Path(directory), find(folder, action, machine)
    store = Store(directory)
    with tempfile.TemporaryDirectory() as imported:
        jobs = list(_unpacked(listed, folder, Path(imported), action, machine, workers))
        open_ = [job for job in jobs if job.refused is None]
        known = {job.label: _key(job, action, model) for job in open_}

        def given(job: Job) -> tuple[Any, ...]:
            return action, model, job.contents()

        tasks = [Task(known[job.label][1], job.label, partial(given, job)) for job in open_]
        outcomes = run(do, tasks, workers=workers, cluster=cluster, directory=directory, told=told)
        rows = [_row(job, Outcome("", "", None, job.refused) if job.refused else next(outcomes)) for job in jobs]
    changed = _changed(open_, known, store, _last(directory))
    passed = passed_over(folder, listed) or None
    found = Batch(action=cast("Action", action), rows=tuple(rows), changed=changed, passed_over=passed)
    columns = list(dict.fromkeys(name for row in rows for name in row.to_dict()))
    table = {c: [in_table(getattr(row, c, None)) for row in rows] for c in columns}
    write_files(
        {
            directory / "table.csv": csv_text(table),
            directory / "batch.json": json.dumps(found.to_dict(), indent=1) + "\n",
            directory / LAST: json.dumps(known, indent=1) + "\n",
        }
    )
    return found


def _key(job: Job, action: str, model: str | None) -> tuple[str, str]:
    """Return a hash of a job's files, and the key of its task; unreadable files fail in their turn."""
    digest = hashlib.sha256()
    try:
        for name, content in sorted(job.contents().items()):
            digest.update(f"{name} {len(content)} ".encode() + content)
    except InputError as error:
        digest.update(str(error).encode())
    return digest.hexdigest()[:32], content_key(Batch.named(), action, model, digest.hexdigest())


def _figures(found: Answer) -> Json:
    """Return what the table says of an answer, by the fields of its row."""
    figures: Json = {field: attrgetter(path)(found) for field, path in _FIELDS[type(found)].items()}
    if isinstance(found, Diagnosis | MotionDiagnosis):
        named, part = (found.findings, None) if isinstance(found, Diagnosis) else (found.effects, "joint")
        places = [(e.name, found.robot.places.name(e.limbs, part)) for e in named]
        figures["effects"] = "; ".join(", ".join(filter(None, place)) for place in places)
        figures["law"] = "; ".join(dict.fromkeys(map(place_of_law, found.laws[0].terms))) if found.laws else None
    return figures


def place_of_law(term: LawTerm) -> str:
    """Return what a term of a law moves and what it reads, whatever its shape: ``joint(oil_C, payload)``."""
    states = sorted(load_law(f"{PREFIX}{term.target} = {term.expression}").STATE)
    return f"{term.target}({', '.join(states)})"


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
        if row.error is not None:
            continue
        key = last[row.recording][1]
        place = directory / PAGES / f"{key}.html"
        if not place.exists() and (answer := _answer(store, key)) is not None:
            place.parent.mkdir(exist_ok=True)
            write_files({place: page_of(answer)})
        if place.exists():
            links[row.recording] = f"{PAGES}/{place.name}"
    return links


def _answer(store: Store, key: str) -> Answer | None:
    """Return the answer that a task has given; None where it has given none."""
    kept = store.get(key)
    return None if kept is None or kept.result is None else read_answer(kept.result)


# ------------------------------------------------------------------------------------------------------ what changed


def _last(directory: Path) -> dict[str, tuple[str, str]]:
    try:
        known: dict[str, tuple[str, str]] = json.loads((directory / LAST).read_text(encoding="utf-8"))
    except (OSError, json.JSONDecodeError):
        return {}
    return known


def _changed(
    done: Sequence[Job], known: Mapping[str, tuple[str, str]], store: Store, last: Mapping[str, tuple[str, str]]
) -> tuple[Moved, ...]:
    """Return what moved, machine by machine: from one recording to the next, and since the last time."""
    changed = []
    before: dict[str, Job] = {}
    for job in done:
        files, key = known[job.label]
        others = []
        if job.machine in before:
            others.append((before[job.machine].label, known[before[job.machine].label][1]))
        was, task = last.get(job.label, (files, ""))
        if was != files:  # other files; the same ones done by other code are no change
            others.append((f"{job.label}, last time", task))
        before[job.machine] = job
        for label, other in others:
            try:
                old, new = _answer(store, other), _answer(store, key)
                text = None if old is None or new is None else moved(old, new)
            except InputError as error:  # other machines, or a run of another version
                text = str(error)
            if text is not None:
                changed.append(Moved(machine=job.machine, from_=label, to=job.label, text=text))
    return tuple(changed)
