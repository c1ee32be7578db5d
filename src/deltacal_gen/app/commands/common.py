"""What commands share: their inputs read or taken as they are, their outputs checked and written.

Modules of commands import at their top what starts at once; what reads and computes is imported by what needs it, so
that the help of a command is there before NumPy would be.
"""

from __future__ import annotations

import hashlib
import os
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from deltacal_gen.errors import FileNotWritable, OptionNotApplicable, OutputName, WrongFile
from deltacal_gen.version import __version__

if TYPE_CHECKING:
    from typing import Protocol

    from deltacal_gen.machine.values import Recording, Robot
    from deltacal_gen.motion.kinds import Torque
    from deltacal_gen.results.base import Answer
    from deltacal_gen.results.parts import Made, RobotTables

    class Frame(Protocol):
        """A data frame of pandas; it need not be installed."""

        @property
        def columns(self) -> Any:
            """Names of its columns."""

        def __getitem__(self, key: Any, /) -> Any: ...

    class MakesFrame(Protocol):
        """What makes a data frame, as a data set of xarray does."""

        def to_dataframe(self) -> Any:
            """Return the data frame."""

    AnyRobot = str | Path | Robot | RobotTables
    AnyRecording = str | Path | Recording | Frame | MakesFrame

Source = str | Path
Progress = Callable[[str], None]
AnyAnswer = TypeVar("AnyAnswer", bound="Answer")
PICTURES = (".svg", ".png", ".pdf")


def silent(text: str) -> None:
    """Report no stage of the work."""


def untold(done: int, total: int, label: str) -> None:
    """Report no task of a run as done."""


def as_robot(robot: AnyRobot) -> Robot:
    """Return a robot: read from its file, or as an answer holds it (``result.robot``), or as it is."""
    from deltacal_gen.files.robot import read_robot, robot_of
    from deltacal_gen.machine.values import Robot
    from deltacal_gen.results.parts import RobotTables

    if isinstance(robot, RobotTables):
        return robot_of(robot)
    return robot if isinstance(robot, Robot) else read_robot(robot)


def as_recording(recording: AnyRecording, robot: Robot, **how: Any) -> Recording:
    """Return a recording: read from its file, or made of a data frame, or as it is."""
    from deltacal_gen.files.recording import read_recording, recording_of
    from deltacal_gen.machine.registry import mechanism_of
    from deltacal_gen.machine.values import Recording

    if isinstance(recording, Recording):
        return recording
    if not isinstance(recording, str | Path):
        return recording_of(recording, mechanism_of(robot), **how)
    return read_recording(recording, mechanism_of(robot), **how)


def in_motion(recording: object) -> Torque | None:
    """Return a recording as one in motion, samples in time; None where its sidecar does not say so."""
    from deltacal_gen.motion import kinds

    return kinds.in_motion(recording)


def moving_like(recording: object) -> Torque:
    """Return a recording in motion, which a result of one needs; raises InputError where it is none."""
    found = in_motion(recording)
    if found is None:
        raise WrongFile(
            "the result is of a recording in motion, and this is none.",
            'Give one whose sidecar says kind = "torque" under [measurement].',
            file=recording if isinstance(recording, str | Path) else None,
        )
    return found


def refuse_in_motion(**options: object) -> None:
    """Raise a UsageError for the first option that means nothing for a recording in motion."""
    for name, value in options.items():
        if value:
            said = name.replace("_", " ")
            raise OptionNotApplicable(f"'{said}' means nothing for a recording in motion; leave it out.")


def check_output(path: Source | None, *inputs: object, ending: Sequence[str] = ()) -> None:
    """Refuse an output that cannot be written, or that is one of the other files, before anything is computed."""
    from deltacal_gen.files.writing import is_stream

    if path is None:
        return
    target = Path(path)
    if not ending and is_stream(target):
        return
    if not str(path) or target.is_dir() or not target.name:
        raise OutputName("this is no file to write to.", "Give the name of a file.", file=target)
    if not target.parent.is_dir():
        raise FileNotWritable("its folder does not exist.", "Make the folder first.", file=target)
    if ending and target.suffix not in ending:
        raise OutputName(f"its name ends with none of {', '.join(ending)}.", "Change the ending.", file=target)
    given = [Path(i) for i in inputs if isinstance(i, str | Path)]
    if target.resolve() in [p.resolve() for i in given for p in (i, i.with_suffix(".toml"))]:
        raise OutputName("the output would overwrite an input or another output.", "Choose another name.", file=target)


def made(*inputs: object, measured: Recording | None = None) -> Made:
    """Return what an answer says of where it comes from: version, date, files with their hashes, instrument.

    The sidecar of a recording and its distances are files of their own. The date is that of SOURCE_DATE_EPOCH where it
    is set, so that a build can be made again.
    """
    from deltacal_gen.results.parts import InputFile, Made

    files = [path for i in inputs if isinstance(i, str | Path) for path in _with_its_own(Path(i))]
    said = None if measured is None else measured.measurement
    now = float(os.environ.get("SOURCE_DATE_EPOCH") or time.time())
    return Made(
        version=__version__,
        date=time.strftime("%Y-%m-%d", time.gmtime(now)),
        inputs=tuple(InputFile(name=path.name, sha256=hashlib.sha256(path.read_bytes()).hexdigest()) for path in files),
        instrument=None if said is None else said.instrument,
        operator=None if said is None else said.operator,
    )


def _with_its_own(path: Path) -> list[Path]:
    """Return a file, and those that are read with it."""
    from deltacal_gen.files.columns import distances_path, instrument_path

    if path.suffix in (".toml", ".json"):
        beside = []
    else:
        beside = [path.with_suffix(".toml"), distances_path(path), instrument_path(path)]
    return [p for p in (path, *beside) if p.is_file()]


def deliver(answer: AnyAnswer, output: Source | None, report: Source | None = None) -> AnyAnswer:
    """Return an answer, its JSON and its page written where these are wanted."""
    from deltacal_gen.files.writing import write_files

    if output is not None:
        write_files({Path(output): answer.to_json()})
    if report is not None:
        from deltacal_gen.pages.answer import page_of

        write_files({Path(report): page_of(answer)})
    return answer


def check_folder(path: Source) -> None:
    """Refuse a folder for outputs that is a file."""
    if Path(path).is_file():
        raise OutputName("this is a file, and a folder is needed.", "Choose another name.", file=path)
