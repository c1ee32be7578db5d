"""The cycle of experiments that decide: rows are proposed, measured by a command of the user, appended, diagnosed."""

from __future__ import annotations

import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from deltacal_gen.diagnosis.candidates import joint_cells
from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.files.columns import distances_path
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.rows import Rows, read_table
from deltacal_gen.files.writing import csv_text, write_files
from deltacal_gen.machine.registry import SOLVED, mechanism_of, nominal_joints
from deltacal_gen.planning.targets import candidates_of
from deltacal_gen.results.diagnosis import Diagnosis, Row
from deltacal_gen.results.written import Looped, Round
from deltacal_gen.use.experiments import columns_of, next_rows, open_questions, shared

BUDGET = 120  # rows, unless the user says how many
SEED = 1987  # of the first poses
POSES, READINGS = "{poses}", "{readings}"  # in a command: the files that it reads and writes
Step = Callable[[str], None]


def loop(
    robot: Robot,
    recording: Path,
    measure: str,
    diagnose: Callable[[Path, Step], Diagnosis],
    *,
    budget: int = BUDGET,
    told: Callable[[Round], None] = lambda done: None,
    progress: Step = lambda text: None,
) -> Looped:
    """Propose rows, have them measured, append them and diagnose, until nothing is open or the budget is spent.

    Parameters
    ----------
    recording : path
        A CSV that grows; where there is none yet, it begins with poses all over the workspace.
    measure : str
        The command: it reads the rows to measure and writes the same rows with readings. ``{poses}`` and
        ``{readings}`` in it stand for the two files; without them they are its last two arguments.
    diagnose : callable
        Of the path of a recording.
    budget : int
        How many rows may be measured.
    told, progress : callable
        Told of every round, and in words what is being done; nothing while the command runs.

    Raises
    ------
    InputError
        The command fails, or what it wrote is no reading of the rows; the recording stays as it was.
    """
    command = shlex.split(measure)
    if not command or budget < 1:
        raise UsageError("a loop needs a command that measures, and a budget of 1 row or more.")
    if recording.suffix != ".csv":
        raise InputError("a recording that grows is a CSV.", "Choose a name that ends with .csv.", file=recording)
    if distances_path(recording).exists():
        raise InputError(
            "distances between rows cannot be appended.", "Give both joints of each in one row.", file=recording
        )
    spent, rounds = 0, list[Round]()
    while True:
        if recording.exists():
            known = diagnose(recording, progress)
            questions = open_questions(known)
            wanted = shared(questions, None) if questions else None
            if wanted is not None and spent + len(wanted.rows) > budget:
                wanted = shared(questions, budget - spent) if spent < budget else None
            rows = next_rows(questions, wanted) if wanted is not None else []
            names = tuple(e.name for e in known.effects)
            laws = tuple(f"{t.target} = {t.expression}" for law in known.laws[:1] for t in law.terms)
            rounds.append(
                Round(
                    verdict=known.verdict,
                    effects=names,
                    laws=laws,
                    open=tuple(q.why for q in questions),
                    rows=len(rows),
                )
            )
            told(rounds[-1])
            if not rows:
                return Looped(recording=str(recording), rows=spent, settled=not questions, rounds=tuple(rounds))
        else:
            rows = first_rows(robot, budget)
        progress("")  # the terminal is the command's
        measured(robot, recording, command, rows)
        spent += len(rows)


def first_rows(robot: Robot, most: int) -> list[Row]:
    """Return poses all over the workspace, as many as the largest model has parameters: 3 readings for each."""
    mechanism = mechanism_of(robot)
    q = candidates_of(robot)
    if not mechanism.many_ways:
        found, status = nominal_joints(robot, q, robot.tool)
        q = robot.joint_sign * found[status == SOLVED]
    if robot.joint_limits is not None:
        low, high = robot.joint_limits.T
        q = q[((q >= low) & (q <= high)).all(axis=1)]
    if not len(q):
        raise NoSolutionError("no pose of the workspace can be reached within the limits of the joints.")
    count = min(most, len(mechanism.model(mechanism.full_model)), len(q))
    some = np.random.default_rng(SEED).permutation(len(q))[:count]
    return [{"pose": f"start{n}"} | joint_cells(q[k], mechanism.joint_unit) for n, k in enumerate(some.tolist(), 1)]


def measured(robot: Robot, recording: Path, command: Sequence[str], rows: Sequence[Row]) -> None:
    """Have rows measured and append them to a recording, whole or not at all.

    Raises
    ------
    InputError
        See `loop`.
    """
    with tempfile.TemporaryDirectory(prefix="deltacal-loop-") as folder:
        poses, readings = Path(folder) / "poses.csv", Path(folder) / "readings.csv"
        poses.write_text(csv_text(columns_of(rows)), encoding="utf-8")
        _run(command, poses, readings)
        whole = Path(folder) / recording.name
        whole.write_text(_appended(recording, read_table(poses), read_table(readings)), encoding="utf-8")
        sidecar = next((p for p in (recording.with_suffix(".toml"), readings.with_suffix(".toml")) if p.exists()), None)
        new = {recording: whole.read_text(encoding="utf-8")}
        if sidecar is not None:
            shutil.copyfile(sidecar, whole.with_suffix(".toml"))
            new[recording.with_suffix(".toml")] = sidecar.read_text(encoding="utf-8")
        try:
            read_recording(whole, mechanism_of(robot))
        except InputError as error:
            raise InputError(
                f"with what the command measured the recording cannot be read: {error.problem}",
                f"{error.remedy} Nothing was appended.",
                file=recording,
                line=error.line,
                column=error.column,
            ) from None
        write_files(new)


def _run(command: Sequence[str], poses: Path, readings: Path) -> None:
    """Run the measuring command; what it prints goes to standard error."""
    files = {POSES: str(poses), READINGS: str(readings)}
    named = any(place in word for word in command for place in files)
    words = [_filled(word, files) for word in command] + ([] if named else list(files.values()))
    try:
        done = subprocess.run(words, stdout=2, check=False)
    except OSError as error:
        raise UsageError(f"the measuring command '{words[0]}' cannot be run: {error.strerror}.") from None
    if done.returncode:
        raise InputError(
            f"the measuring command ended with exit code {done.returncode}: {shlex.join(words)}.",
            "Nothing was appended; the same loop goes on from there.",
        )
    if not readings.exists():
        raise InputError(f"the measuring command wrote no readings: {shlex.join(words)}.", "Let it write this file.")


def _filled(word: str, files: dict[str, str]) -> str:
    for place, path in files.items():
        word = word.replace(place, path)
    return word


def _appended(recording: Path, poses: Rows, readings: Rows) -> str:
    """Return the text of a recording with rows behind it: cells that one of both lacks are blank.

    What the command did not repeat of a row stands as it was asked for.
    """
    count = len(poses.line)
    if len(readings.line) != count:
        raise InputError(
            f"the command measured {len(readings.line)} rows, and {count} were asked for.",
            "Let it write every row, in their order; the cells of what could not be measured stay blank.",
        )
    new = poses.columns | _plain(readings)
    old = _plain(read_table(recording)) if recording.exists() else {}
    before = len(next(iter(old.values()), []))
    names = dict.fromkeys((*old, *new))
    return csv_text({n: [*old.get(n, [""] * before), *new.get(n, [""] * count)] for n in names})


def _plain(rows: Rows) -> dict[str, list[str]]:
    """Return cells by column, as text, in the units that the names of columns say."""
    out = dict(rows.columns)
    for name, (factor, above) in rows.scales.items():
        out[name] = [repr(float(cell) * factor + above) if cell else "" for cell in rows.columns[name]]
    return out
