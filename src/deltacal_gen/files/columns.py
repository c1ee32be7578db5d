"""Columns of a recording by their names: joints, channels, tool point, and the file beside it with distances."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from deltacal_gen.errors import FileFormat
from deltacal_gen.instrument import kinds
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.rotation import Array
from deltacal_gen.states import RECORDED

TOOL = ("tool_x_mm", "tool_y_mm", "tool_z_mm")
MEASURED = {column for name in kinds.names() for column in kind_of(name).reserved}
RESERVED = {*MEASURED, *TOOL, "pose", "setup"}
ONE_SETUP = ("1",)  # name of the only set-up, where the file names none

JOINT = re.compile(r"q\d+_(deg|mm)")
DRIVE = re.compile(r"(tau|current|drive)\d+(_[A-Za-z]+)?")  # what drives give


def is_channel(column: str) -> bool:
    """Tell whether a column holds a channel that the program knows, of whatever joint or part."""
    return any(s.holds(column) for s in RECORDED)


Column = Sequence[float | str] | Array
Columns = dict[str, Column]  # of a file, by name


def distances_path(path: Path) -> Path:
    """Return where the distances between rows of a recording lie, if there are any."""
    return path.with_name(f"{path.stem}.distances.csv")


def instrument_path(path: Path) -> Path:
    """Return where the readings of a recording lie, if the instrument has a clock of its own."""
    return path.with_name(f"{path.stem}.instrument{path.suffix}")


def sidecar_path(path: Path) -> Path:
    """Return where the sidecar of a recording lies, if there is one.

    Raises
    ------
    InputError
        What lies there instead has the name that one thinks of first, ``NAME.csv.toml``: it would not be read.
    """
    if not path.name:  # a folder, "." or "/": itself, which those who read it name
        return path
    own = path.with_suffix(".toml")
    for other in (path.with_name(f"{path.name}.toml"), path.with_suffix(".TOML")):
        if other != own and other.exists() and not own.exists():
            raise FileFormat(
                f"this looks like the sidecar of {path.name}, which is {own.name}.", "Rename it.", file=other
            )
    return own
