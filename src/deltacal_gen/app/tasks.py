"""What a worker is given: the files of one recording, laid out in a folder of its own."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from deltacal_gen.errors import InputError

ROBOT, RECORDING = "robot.toml", "recording.csv"  # what a worker calls the files of a recording
Contents = Mapping[str, bytes]


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
            raise InputError(error.problem, error.remedy, file=file, line=error.line, column=error.column) from None
