"""Many recordings at once: identify, validate or diagnose all that lie in a folder; resumable, one table, one page.

A machine is a folder with a ``robot.toml``; its recordings are the tables beside it that hold joints and readings.
A task carries the files themselves, so that a worker needs no common file system, and is named by their content: what
was done with the same files is not done again, wherever the run directory has been copied to.
"""

from __future__ import annotations

import functools
import json
import re
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from deltacal_gen import commands
from deltacal_gen.comparison import compare
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.execution import Outcome, Store, Task, Told, content_key, run
from deltacal_gen.recording import csv_text, is_recording, write_files

SCHEMA = "deltacal.batch/1"
ACTIONS = ("diagnose", "identify", "validate")
ROBOT = "robot.toml"
RESULT = "result.json"  # beside the robot: what its recordings are validated against
LAST = "last.json"  # which task each recording was, the last time that all were done


@dataclass(frozen=True)
class Job:
    """A recording with its robot.

    Attributes
    ----------
    label : str
        Path of the recording below the folder.
    machine : str
        Recordings of one machine share it.
    files : dict of Path
        By the name that the worker gives them.
    """

    label: str
    machine: str
    files: Mapping[str, Path]

    def contents(self) -> dict[str, bytes]:
        """Return the files' contents by name."""
        return {name: path.read_bytes() for name, path in self.files.items()}


def jobs(folder: str | Path, action: str = "diagnose", machine: str | None = None) -> list[Job]:
    """Return the recordings of a folder, in the order of their paths.

    Parameters
    ----------
    machine : str, optional
        Regular expression; recordings whose paths give the same match are of one machine, default the folder.

    Raises
    ------
    InputError
        There is no recording beside a robot.toml.
    UsageError
        No such action, or no regular expression.
    """
    folder = Path(folder)
    if action not in ACTIONS:
        raise UsageError(f"there is no action '{action}'; known: {', '.join(ACTIONS)}.")
    try:
        pattern = None if machine is None else re.compile(machine)
    except re.error as error:
        raise UsageError(f"--machine is no regular expression: {error}.") from None
    found = []
    for robot in sorted(folder.rglob(ROBOT)):
        for table in sorted(robot.parent.glob("*.csv")):
            if table.name.endswith(".distances.csv") or not is_recording(table):
                continue
            label = table.relative_to(folder).as_posix()
            files = {ROBOT: robot, "recording.csv": table}
            for ending in (".toml", ".distances.csv"):
                if table.with_suffix(ending).exists():
                    files[f"recording{ending}"] = table.with_suffix(ending)
            if action == "validate":
                files[RESULT] = robot.parent / RESULT
            match = None if pattern is None else pattern.search(label)
            found.append(Job(label, match[0] if match else robot.parent.relative_to(folder).as_posix(), files))
    if not found:
        raise InputError(
            f"there is no recording beside a {ROBOT}.",
            f"Give a folder in which each machine has a folder with {ROBOT} and its recordings.",
            file=folder,
        )
    return found


def do(action: str, model: str | None, files: Mapping[str, bytes]) -> dict[str, Any]:
    """Do one task in a folder of its own; runs on a worker."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for name, content in files.items():
            (folder / name).write_bytes(content)
        robot, recording = folder / ROBOT, folder / "recording.csv"
        try:
            if action == "validate":
                return commands.validate(folder / RESULT, recording)
            if action == "identify":
                return commands.identify(robot, recording, model)
            return commands.diagnose(robot, recording, model=model)
        except InputError as error:
            file = None if error.file is None else Path(str(error.file)).name
            raise InputError(error.problem, error.remedy, file=file, line=error.line, column=error.column) from None


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
) -> dict[str, Any]:
    """Do all recordings of a folder, and write ``table.csv`` and ``batch.json`` into the run directory.

    Returns
    -------
    dict
        ``schema, action, rows`` (one per recording, in the order of their paths, with ``error`` where it failed) and
        ``changed``: machine by machine what moved since the recording before, and since the last time.
    """
    directory = Path(directory)
    todo = jobs(folder, action, machine)
    store = Store(directory)
    keys: dict[str, str] = {}

    def tasks() -> Iterator[Task]:
        for job in todo:
            key = content_key(SCHEMA, action, model, sorted((n, c.hex()) for n, c in _read(job).items()))
            keys[job.label] = key
            yield Task(key, job.label, functools.partial(_arguments, action, model, job))

    rows = []
    for job, outcome in zip(
        todo,
        run(do, tasks(), total=len(todo), workers=workers, cluster=cluster, directory=directory, told=told),
        strict=True,
    ):
        rows.append(_row(job, outcome))
    found = {
        "schema": SCHEMA,
        "action": action,
        "rows": rows,
        "changed": _changed(todo, keys, store, _last(directory)),
    }
    columns = list(dict.fromkeys(name for row in rows for name in row))
    table = {c: ["" if row.get(c) is None else row[c] for row in rows] for c in columns}
    write_files(
        {
            directory / "table.csv": csv_text(table),
            directory / "batch.json": json.dumps(found, indent=1) + "\n",
            directory / LAST: json.dumps(keys, indent=1) + "\n",
        }
    )
    return found


def _read(job: Job) -> dict[str, bytes]:
    try:
        return job.contents()
    except OSError as error:
        raise InputError(
            f"cannot be read: {error.strerror}.",
            f"Put {RESULT}, which identify or diagnose wrote, beside the robot."
            if RESULT in str(error.filename)
            else "",
            file=error.filename,
        ) from None


def _arguments(action: str, model: str | None, job: Job) -> tuple[str, str | None, dict[str, bytes]]:
    return action, model, job.contents()


def _row(job: Job, outcome: Outcome) -> dict[str, Any]:
    """Return a recording's line of the table."""
    row: dict[str, Any] = {"recording": job.label, "machine": job.machine}
    r = outcome.result
    if r is None:
        return row | {"error": outcome.error}
    if r["schema"].startswith("deltacal.diagnosis/"):
        named = "; ".join(f"{e['name']} {' '.join(map(str, e['limbs']))}".strip() for e in r["effects"])
        row |= {
            "verdict": r["verdict"],
            "effects": named,
            "model": r["baseline"]["model"],
            "before_mm": r["baseline"]["heldout_rms_mm"],
            "after_mm": r["final"]["heldout_rms_mm"],
            "noise_mm": r["noise"]["sigma_mm"],
        }
    elif r["schema"].startswith("deltacal.result/"):
        row |= {
            "model": r["model"],
            "before_mm": r["before_rms_mm"],
            "after_mm": r["heldout_rms_mm"],
            "fitted_mm": r["train_rms_mm"],
            "noise_mm": r["sigma_mm"],
        }
    else:
        row |= {"after_mm": r["rms_mm"], "worst_mm": r["worst_mm"], "chi2_per_dof": r["chi2_per_dof"]}
    return row | {"error": None}


# ------------------------------------------------------------------------------------------------------ what changed


def _last(directory: Path) -> dict[str, str]:
    try:
        known: dict[str, str] = json.loads((directory / LAST).read_text(encoding="utf-8"))
    except (OSError, json.JSONDecodeError):
        return {}
    return known


def _changed(
    todo: Sequence[Job], keys: Mapping[str, str], store: Store, last: Mapping[str, str]
) -> list[dict[str, str]]:
    """Return what moved, machine by machine: from one recording to the next, and since the last time."""
    changed = []
    before: dict[str, Job] = {}
    for job in todo:
        new = store.get(keys[job.label])
        pairs = []
        if job.machine in before:
            pairs.append((before[job.machine].label, keys[before[job.machine].label]))
        if last.get(job.label, keys[job.label]) != keys[job.label]:
            pairs.append((f"{job.label}, last time", last[job.label]))
        before[job.machine] = job
        for label, key in pairs:
            old = store.get(key)
            if old is None or new is None or old["result"] is None or new["result"] is None:
                continue
            changed.append(
                {"machine": job.machine, "from": label, "to": job.label, "text": _moved(old["result"], new["result"])}
            )
    return changed


def _moved(old: Mapping[str, Any], new: Mapping[str, Any]) -> str:
    if "parameters" in old and "parameters" in new:
        try:
            return str(compare(old, new)["summary"])
        except InputError as error:
            return str(error)
    if "verdict" in old and "verdict" in new:
        names = [sorted(e["name"] for e in r["effects"]) for r in (old, new)]
        gone, come = (sorted(set(a) - set(b)) for a, b in (names, names[::-1]))
        parts = [f"{old['verdict']} became {new['verdict']}"] if old["verdict"] != new["verdict"] else []
        parts += [f"{name} appeared" for name in come] + [f"{name} is gone" for name in gone]
        said = "; ".join(parts) or f"still {new['verdict']}"
        return f"{said}; held out {old['final']['heldout_rms_mm']:.4f} -> {new['final']['heldout_rms_mm']:.4f} mm."
    return f"error {old.get('rms_mm', 0.0):.4f} -> {new.get('rms_mm', 0.0):.4f} mm."
