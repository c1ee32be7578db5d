"""Errors for people: what was wrong, where, what was expected, what to do.

Each class carries the exit code of the command line (contract, section 6).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path


class DeltacalError(Exception):
    """Base of all errors that are explained to the user instead of shown as a traceback."""

    exit_code = 1


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


class NoSolutionError(DeltacalError):
    """The computation found no solution or did not converge (exit code 4)."""

    exit_code = 4
