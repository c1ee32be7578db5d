"""Errors for people: which family, what was wrong, where, what was expected, what to do.

Each class below the three kinds is a family of errors: its code is its name in small letters, MissingColumn is
``missing-column``, and its docstring what ``deltacal explain CODE`` prints. Nothing raises the kinds themselves. The
kinds carry the exit code of the command line (contract, section 6).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path


class DeltacalError(Exception):
    """Base of all errors that are explained to the user instead of shown as a traceback."""

    exit_code = 1

    @property
    def code(self) -> str:
        """The stable name of its family."""
        return code_of(type(self))


def code_of(family: type[DeltacalError]) -> str:
    """Return the code of a family of errors."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "-", family.__name__).lower()


def families() -> dict[str, type[DeltacalError]]:
    """Return all families of errors by their codes."""
    return {code_of(family): family for kind in DeltacalError.__subclasses__() for family in kind.__subclasses__()}


class UsageError(DeltacalError):
    """The call itself makes no sense: an unknown model, a missing option (exit code 2)."""

    exit_code = 2


class InputError(DeltacalError):
    """A file says something that cannot be used (exit code 3).

    Parameters
    ----------
    problem : str
        What was wrong and what was expected.
    remedy : str
        What to do about it.
    file : path, optional
    line : int, optional
        Line in the file, the first is 1.
    column : str, optional
        Name of the column or key.
    """

    exit_code = 3

    def __init__(
        self,
        problem: str,
        remedy: str,
        *,
        file: str | Path | None = None,
        line: int | None = None,
        column: str | None = None,
    ) -> None:
        where = "" if file is None else str(file)
        if line is not None:
            where += f", line {line}"
        if column is not None:
            where += f", column '{column}'"
        self.problem, self.remedy = problem, remedy
        self.file, self.line, self.column = file, line, column
        super().__init__(f"{where.removeprefix(', ')}: {problem} {remedy}" if where else f"{problem} {remedy}")


@contextmanager
def naming(file: Path) -> Iterator[None]:
    """Name a file in each InputError that names none, while it is read."""
    try:
        yield
    except InputError as error:
        if error.file is not None:
            raise
        raise type(error)(error.problem, error.remedy, file=file, line=error.line, column=error.column) from None


def listed(names: Sequence[str], most: int) -> str:
    """Return names as a message lists them: the first ones, as many as `most`."""
    return ", ".join(names[:most]) + " ..." * (len(names) > most)


class NoSolutionError(DeltacalError):
    """The computation found no solution or did not converge (exit code 4)."""

    exit_code = 4


class NeedsCheckout(UsageError):
    """Derivations, claims and reproductions are made in a source checkout.

    Clone the repository and run the command there.
    """


class NotForThisMachine(UsageError):
    """The mechanism does not have what is wanted: a chain has no loops, a planar machine no table, an effect no C.

    The message names what there is instead.
    """


class NotInstalled(UsageError):
    """An optional package is missing.

    The message has the command that installs it.
    """


class NothingToShow(UsageError):
    """There is no such page, or nothing to draw in this answer."""


class OptionMissing(UsageError):
    """An option that this use of the command needs is missing.

    The message names it.
    """


class OptionNotApplicable(UsageError):
    """An option means nothing here, or excludes another one.

    Leave it out.
    """


class UnknownModel(UsageError):
    """The mechanism has no such model or parameter.

    `deltacal models MECHANISM` lists them.
    """


class UnknownName(UsageError):
    """There is no effect, kind, method, scaling or layer of this name.

    The message lists those that there are.
    """


class ValueOutOfRange(UsageError):
    """A number is out of its range.

    The message says which numbers are possible.
    """


class WrongArray(UsageError):
    """An array has another shape than expected, or holds what is no number.

    The message names the shape.
    """


class BadValue(InputError):
    """A key of a robot file, sidecar or truth has a value of the wrong type or size.

    The message says what is expected.
    """


class ClockMismatch(InputError):
    """Joints and readings cannot be brought to one time: clocks, runs or logged spans do not match.

    Check the runs of both files, `clock` in the sidecar, and that both were recorded at the same time.
    """


class Cluster(InputError):
    """No Dask scheduler answers.

    Check the address, `tcp://HOST:PORT`, or leave `--cluster` out.
    """


class ConstantReadings(InputError):
    """Readings do not change although joints move: the instrument or the log stood still.

    Remove these rows.
    """


class ContradictingRows(InputError):
    """Two rows cannot both be right: two sets of joints under one pose label, swapped readings, an entry given twice.

    Correct the rows that the message names.
    """


class DecimalMark(InputError):
    """Whether a comma is a decimal mark is not certain.

    Give `--decimal ,` or `--decimal .`.
    """


class FileFormat(InputError):
    """The file is not what its name or place says: no CSV, TOML, JSON, XML, workbook or capture, or one without rows.

    Give the right file, or save it again.
    """


class FileNotReadable(InputError):
    """There is no such file, or it may not be read.

    Check the path and the permissions.
    """


class FileNotWritable(InputError):
    """The output cannot be written: its folder does not exist, is full, or may not be written.

    Make the folder, or choose another.
    """


class ImplausibleReadings(InputError):
    """Readings are much further from the machine than any calibration explains.

    Check the robot file's dimensions, the units, which point was measured, and that joints and readings of a row
    belong together.
    """


class ImportUnclear(InputError):
    """What another program keeps does not say which topic, marker, point or field is meant, or holds none of them.

    Name it by an option, or by the file of `--mapping`.
    """


class ImpossiblePose(InputError):
    """At these joints the loops of the machine do not close, or it is singular.

    Check joints, signs and limits, and the dimensions of the robot file.
    """


class InconsistentResult(InputError):
    """Parts of a result file do not belong together: it was edited by hand.

    Identify or diagnose again.
    """


class MisreadReadings(InputError):
    """Readings agree with the machine if columns, signs, units or conventions are taken otherwise than they say.

    The message says how. Correct the column names or the sidecar.
    """


class MissingChannel(InputError):
    """A column or a key of the sidecar is missing on which an effect or a kind of reading depends.

    Add it, or leave the effect out.
    """


class MissingColumn(InputError):
    """A column is missing, or a name stands for none that is known.

    Add or rename the column; `deltacal manual files` lists the names.
    """


class MissingKey(InputError):
    """A key of the robot file or of a sidecar is missing: a dimension, limits, a mass, the workspace.

    Add it.
    """


class MissingLibrary(InputError):
    """A library that reads this kind of file, or runs on a cluster, is not installed.

    The message has the command that installs it.
    """


class NoReadings(InputError):
    """No row holds a reading: measured columns are blank, or no pairs of poses are given."""


class NoiseUnknown(InputError):
    """Nothing says how well the instrument reads.

    Add `sigma_mm` (`sigma_px`, `sigma_deg`) to the sidecar, or give `--noise`.
    """


class NotExcited(InputError):
    """Joints move too little, or the robot file's dimensions are far off: the torques determine nothing.

    Record a trajectory of `deltacal plan --kind torque`.
    """


class OtherMachine(InputError):
    """Files are of different machines: mechanisms, numbers of joints or dimensions differ.

    Give files of one machine.
    """


class OtherVersion(InputError):
    """The file was written by another version of deltacal, whose schema differs.

    Make it again with this version.
    """


class OutputName(InputError):
    """The name of the output cannot be used: a wrong ending, a folder, or the name of another input or output."""


class PrinterFile(InputError):
    """A firmware's configuration, log or map lacks what is needed, or contradicts itself.

    The message names the line and the setting.
    """


class ReadingsAlreadySeen(InputError):
    """The readings took part in the fit, so that they are no check of it.

    Give readings that did not.
    """


class TimeOrder(InputError):
    """Times go backwards within a run, or some rows have none.

    Sort the rows, or split the runs.
    """


class TooFewReadings(InputError):
    """There are fewer readings, poses or samples than unknowns.

    Measure more poses, or identify a smaller model.
    """


class UnknownSetup(InputError):
    """The result does not know where the instrument stands in this set-up.

    Give `--place` with readings of it, or label the set-up as in the recording.
    """


class UnusableURDF(InputError):
    """The URDF cannot be read as one chain.

    The message names the line; `--base` and `--tip` choose the chain.
    """


class WrongFile(InputError):
    """The file holds another kind of answer than this command takes, e.g.

    a result where a diagnosis is needed, or one in motion.
    """


class WrongKind(InputError):
    """Columns and `kind` of the sidecar do not agree, or the columns hold readings of several kinds.

    Keep one kind, and name it.
    """


class WrongUnit(InputError):
    """Values look like another unit than the column or key says: radians, metres, counts.

    Convert them, or rename the column.
    """


class ExportNotPossible(NoSolutionError):
    """A table of corrections cannot meet the tolerance over the whole workspace.

    Allow a larger `--tolerance`, make the workspace smaller, or export C.
    """


class NoConvergence(NoSolutionError):
    """The fit did not converge.

    Readings contradict each other, or the start is far off: check the robot file's dimensions, leave out doubtful
    rows, or identify a smaller model.
    """


class NoImprovement(NoSolutionError):
    """The new firmware lines would be no better than those in the file now.

    Keep these, or probe more points.
    """


class NoPlan(NoSolutionError):
    """No poses or trajectories of this kind fit into workspace and joint limits.

    Check `[workspace]` and `limits_deg`, or ask for fewer.
    """


class OutOfReach(NoSolutionError):
    """A target, or the whole workspace, is out of the machine's reach.

    Check the targets, `[workspace]` and `[geometry]`.
    """


class BadCell(InputError):
    """A cell of a table holds no number, or one that cannot stand there.

    Correct the cell, or leave it blank if it is not known.
    """


class BlankCell(InputError):
    """A cell that every row needs is blank: a joint, or a part of a reading of which other parts are there.

    Fill it in, blank the whole reading, or remove the row.
    """


class UnknownKey(InputError):
    """The file has a key that is not known.

    The message names the nearest one that is, or the table to which it belongs.
    """


class CommandLine(UsageError):
    """The command line cannot be read: an unknown command or option, a missing argument, a value of the wrong type.

    See `deltacal COMMAND --help`.
    """
