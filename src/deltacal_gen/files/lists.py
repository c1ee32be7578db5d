"""Tables of points and of joints as text, with whatever stands before them and between their columns."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.dialect import Layout, decimal_of, encoding_of, plain_number
from deltacal_gen.files.rows import number_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.units import to_internal

LENGTHS = {  # mm
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 1.0),
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1000.0),
    **dict.fromkeys(("in", "inch", "inches"), 25.4),
    **dict.fromkeys(("cm", "centimeters", "centimetres"), 10.0),
}
_UNITS = re.compile(rf"\bunits?\b[^A-Za-z]*({'|'.join(sorted(LENGTHS, key=len, reverse=True))})\b", re.IGNORECASE)
GROUP, POINT = (
    ("group", "groupname", "setup", "station"),
    ("point", "pointname", "pointid", "target", "pose", "name", "id"),
)
_JOINT = re.compile(r"(?:q|j|a|e|axis|joint|theta)(\d+)")


@dataclass(frozen=True)
class TextTable:
    """Cells of a text file, with the line of each row; `header` is empty where the file has none."""

    path: Path
    header: list[str]
    cells: list[list[str]]
    lines: list[int]
    unit: str = ""  # of lengths, where what stands before the table says it

    def column(self, names: Sequence[str]) -> int | None:
        """Return the place of the first column with one of these names."""
        plain = [plain_name(h)[0] for h in self.header]
        return next((plain.index(n) for n in names if n in plain), None)

    def numbers(self, column: int) -> Array:
        """Return a column (N,) of numbers, nan where a cell is blank."""
        out = []
        for row, line in zip(self.cells, self.lines, strict=True):
            cell = row[column] if column < len(row) else ""
            value = number_of(cell) if cell else np.nan
            if value is None:
                raise InputError(
                    f"'{cell}' is no number.",
                    "Write numbers with a decimal point, or commas where columns are not separated by them.",
                    file=self.path,
                    line=line,
                    column=self.header[column] if self.header else str(column + 1),
                )
            out.append(value)
        return np.array(out)


def joints_in_time(path: Path) -> tuple[Array, Array, str]:
    """Return stamps (N,) [s], joints (N, n) and their unit inside, rad or mm, of a table with a column ``time_s``."""
    table = read_text_table(path)
    q, unit, _ = joints_of(table)
    return table.numbers(required_column(table, ("time", "times", "t"), "the time")), q, unit


def is_table_of_joints(path: Path) -> bool:
    """Tell whether a file has columns of joints; its values are not judged."""
    try:
        return any(_JOINT.fullmatch(plain_name(head)[0]) for head in read_text_table(path).header)
    except InputError:
        return False


def joints_of(table: TextTable) -> tuple[Array, str, list[int]]:
    """Return joints (N, n) [rad or mm], their unit inside, and their columns."""
    found: dict[int, tuple[int, str]] = {}
    for c, head in enumerate(table.header):
        name, unit = plain_name(head)
        if match := _JOINT.fullmatch(name):
            found[int(match[1])] = c, unit
    if not found or sorted(found) != list(range(1, len(found) + 1)):
        raise InputError(
            "the joints' columns are missing, or not numbered from 1.",
            "Name them q1_deg, q2_deg, ... (q1_mm for sliding joints).",
            file=table.path,
        )
    values, units = [], set()
    for number in sorted(found):
        column, unit = found[number]
        if unit not in ("deg", "rad", "mm"):
            raise InputError(
                "the unit of a joint is not said.",
                f"Name the column q{number}_deg, q{number}_rad or q{number}_mm.",
                file=table.path,
                column=table.header[column],
            )
        q = table.numbers(column)
        if not np.isfinite(q).all():
            raise InputError(
                "a joint is blank.",
                "Fill in all joints of a row, or remove it.",
                file=table.path,
                line=table.lines[int(np.argmax(~np.isfinite(q)))],
                column=table.header[column],
            )
        values.append(q if unit == "rad" else q * to_internal("rad" if unit == "deg" else "mm"))
        units.add("mm" if unit == "mm" else "rad")
    if len(units) > 1:
        raise InputError("joints in deg and in mm in one table.", "Give them in one unit.", file=table.path)
    return np.column_stack(values), units.pop(), [c for c, _ in found.values()]


def plain_name(head: str) -> tuple[str, str]:
    """Return a column's name without blanks and marks, in small letters, and the unit that stands with it."""
    text = head.strip().strip('"').lower()
    match = re.fullmatch(r"(.*?)[\s_]*(?:[\[(]\s*(\w+)\s*[\])]|[\s_](deg|rad|mm|cm|m|in|inch|inches|degrees))?", text)
    name, unit = (match[1], match[2] or match[3] or "") if match else (text, "")
    return re.sub(r"[\s_.]+", "", name), {"degrees": "deg", "°": "deg", "radians": "rad"}.get(unit, unit)


def required_column(table: TextTable, names: Sequence[str], what: str) -> int:
    """Return the place of the first column with one of these names; raise an InputError where there is none."""
    column = table.column(names)
    if column is None:
        raise InputError(
            f"there is no column with {what}; there are {', '.join(table.header) or 'none with a name'}.",
            f"Name one '{names[0]}'.",
            file=table.path,
            line=1,
        )
    return column


def is_numeric(table: TextTable, column: int) -> bool:
    """Tell whether a column holds numbers, and nothing else."""
    cells = [row[column] for row in table.cells if column < len(row) and row[column]]
    return bool(cells) and all(number_of(c) is not None for c in cells)


def read_text_table(path: Path) -> TextTable:
    """Return the cells of a file whose columns are separated by tabs, semicolons, commas or blanks.

    What an instrument's software writes before the table (job, date, operator, units) is passed over: the table begins
    with a header that names X, Y and Z or joints, or with the first of the lines that hold three numbers.
    """
    text = path.read_text(encoding=encoding_of(path), errors="replace")
    kept = [
        (number, line.strip())
        for number, line in enumerate(text.split("\n"), start=1)
        if line.strip() and not line.lstrip().startswith(("#", "//", "%"))
    ]
    if not kept:
        raise InputError("the file holds no lines.", "Export the points again.", file=path)
    start = next((k for k, (_, line) in enumerate(kept) if _begins(line)), 0)
    unit = next((m[1].lower() for _, line in kept[:start] if (m := _UNITS.search(line)) is not None), "")
    kept = kept[start:]
    mark = next((m for m in ("\t", ";", ",") if all(m in line for _, line in kept)), None)
    cells = [[c.strip().strip('"') for c in (line.split(mark) if mark else line.split())] for _, line in kept]
    cells = [[part for k, c in enumerate(row) for part in (_named(c) if k == 0 else [c])] for row in cells]
    lines = [number for number, _ in kept]
    if mark != ",":
        numbered = ((n, cell) for n, row in zip(lines, cells, strict=True) for cell in row)
        layout = Layout(0, mark or " ", decimal_of(path, numbered), False)
        cells = [[plain_number(cell, layout) for cell in row] for row in cells]
    if sum(number_of(c) is not None for c in cells[0]) < 2:
        return TextTable(path, cells[0], cells[1:], lines[1:], unit)
    return TextTable(path, [], cells, lines, unit)


def _begins(line: str) -> bool:
    """Tell whether a table may begin with a line: a header with known names, or three numbers at least."""
    for mark in ("\t", ";", ",", None):
        cells = [c.strip().strip('"') for c in (line.split(mark) if mark else line.split())]
        names = {plain_name(c)[0] for c in cells}
        joints = sum(_JOINT.fullmatch(n) is not None for n in names)
        if {"x", "y", "z"} <= names or (joints and names & {*POINT, *GROUP}) or joints > 1:
            return True
        if len(cells) > 3 and sum(number_of(c) is not None for c in cells) >= 3:
            return True
    return False


def _named(cell: str) -> list[str]:
    """Return group and point of a name like ``A::Main::p1``, collection and all in the group; other cells alone."""
    group, mark, point = cell.rpartition("::")
    return [group, point] if mark else [cell]
