"""Errors that name the file in which they were found, said once for all that is read of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from deltacal_gen.errors import InputError


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
