"""Lists of points, as trackers and their software write them, beside a table of joints: to a recording.

A list holds group, point, X, Y, Z, line by line; whatever stands between the columns, with or without a header, with
decimal points or commas. A group is a set-up of the instrument where there is more than one; a point that comes again
in its group is a repeat. The joints of each point come from a second table, by the point's name.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.dialect import Layout, decimal_of, encoding_of, plain_number
from deltacal_gen.files.imports import Imported, write_import
from deltacal_gen.files.robot import read_robot
from deltacal_gen.files.rows import number_of
from deltacal_gen.instrument.kinds import POINTS
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.units import to_internal

LENGTHS = {  # mm
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 1.0),
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1000.0),
    **dict.fromkeys(("in", "inch", "inches"), 25.4),
    **dict.fromkeys(("cm", "centimeters", "centimetres"), 10.0),
}
_UNITS = re.compile(rf"\bunits?\b[^A-Za-z]*({'|'.join(sorted(LENGTHS, key=len, reverse=True))})\b", re.IGNORECASE)
_GROUP, _POINT = (
    ("group", "groupname", "setup", "station"),
    ("point", "pointname", "pointid", "target", "pose", "name", "id"),
)
_JOINT = re.compile(r"(?:q|j|a|e|axis|joint|theta)(\d+)")
ROTATIONS = ("rx", "ry", "rz")
FEW = 3  # names that a message lists


@dataclass(frozen=True)
class _Table:
    """Cells of a text file, with the line of each row; `header` is empty where the file has none."""

    path: Path
    header: list[str]
    cells: list[list[str]]
    lines: list[int]
    unit: str = ""  # of lengths, where what stands before the table says it

    def column(self, names: Sequence[str]) -> int | None:
        """Return the place of the first column with one of these names."""
        plain = [_plain(h)[0] for h in self.header]
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


def _rows_of_points(table: _Table, q: Array, where: int, group: int | None) -> dict[tuple[str, str], int]:
    """Return the row of each point by its group and name; raise an InputError where one has two places."""
    keys: dict[tuple[str, str], int] = {}
    for j, row in enumerate(table.cells):
        key = (row[group] if group is not None else "", row[where])
        if key in keys and not np.array_equal(q[keys[key]], q[j]):
            raise InputError(
                f"the point '{row[where]}' comes twice, with different joints.",
                "Give every point a name of its own, or add a column 'group'.",
                file=table.path,
                line=table.lines[j],
            )
        keys.setdefault(key, j)
    return keys


def import_points(
    points: str | Path, joints: str | Path, robot: str | Path | None = None, output: str | Path | None = None
) -> Imported:
    """Return a recording of positions from a tracker's list of points and a table of joints.

    Parameters
    ----------
    points : path
        Group, point, X, Y, Z in this order, or in any with a header; mm unless the header says m, cm or in.
    joints : path
        A header with the point's name, `q1_deg ...` (`_rad`, `_mm`; `J1`, `A1`, `joint 1 [deg]` are understood too), a
        group where names repeat among groups, and any channel.
    robot : path, optional
        Robot file; it is written beside the recording, and the number of joints is checked.
    output : path, optional
        Folder for recording.csv, and robot.toml.

    Raises
    ------
    InputError
        A cell that is no number, an angle without a unit, no point that both files name.
    """
    measured, table = _points(Path(points)), _table(Path(joints))
    where, names = _required(table, _POINT, "the point's name"), measured[1]
    group = table.column(_GROUP)
    q, unit, used = _joints(table)
    machine = None if robot is None else read_robot(robot)
    if machine is not None and len(machine.joint_sign) not in (1, q.shape[1]):
        raise InputError(
            f"the table has {q.shape[1]} joints, the robot {len(machine.joint_sign)}.",
            "Give the joints of the robot file, in its order.",
            file=table.path,
        )
    keys = _rows_of_points(table, q, where, group)
    groups = measured[0]
    rows = [keys.get((g if group is not None else "", p)) for g, p in zip(groups, names, strict=True)]
    taken = [i for i, j in enumerate(rows) if j is not None]
    if not taken:
        raise InputError(
            f"no point of the list ({', '.join(names[:FEW])}) is in the table of joints "
            f"({', '.join(row[where] for row in table.cells[:FEW])}).",
            "Name the points alike in both files.",
            file=table.path,
        )
    of_row = np.array([j for j in rows if j is not None])
    setups = list(dict.fromkeys(groups[i] for i in taken))
    recording = Recording(
        path=Path(points),
        kind=POINTS,
        measurement=Measurement(kind=POINTS, frame="unknown"),
        joint_unit=unit,
        joints=q[of_row],
        columns=("x_mm", "y_mm", "z_mm"),
        measured=measured[2][taken],
        pose=np.array([names[i] for i in taken]),
        line=np.array([measured[3][i] for i in taken]),
        channels={
            table.header[c].strip(): table.numbers(c)[of_row]
            for c in range(len(table.header))
            if c not in (where, group, *used) and _numeric(table, c)
        },
        setup=np.array([setups.index(groups[i]) for i in taken]),
        setup_names=tuple(setups),
    )
    warnings = []
    if lost := [names[i] for i, j in enumerate(rows) if j is None]:
        warnings.append(f"{len(lost)} points have no joints ({', '.join(lost[:FEW])}{' ...' * (len(lost) > FEW)})")
    seen = set(of_row.tolist())
    if idle := [row[where] for j, row in enumerate(table.cells) if j not in seen]:
        warnings.append(f"{len(idle)} joints have no point ({', '.join(idle[:FEW])}{' ...' * (len(idle) > FEW)})")
    header = _table(Path(points)).header
    if turns := [head.strip() for head in header if _plain(head)[0] in ROTATIONS]:
        warnings.append(
            f"{', '.join(turns)} are not read: a list is of positions. Rotations stand in a recording of kind pose, as "
            "rx_deg, ry_deg, rz_deg; its sidecar says what their angles are"
        )
    return write_import(Imported(machine, {"recording": recording}, tuple(warnings)), output)


def joints_in_time(path: Path) -> tuple[Array, Array, str]:
    """Return stamps (N,) [s], joints (N, n) and their unit inside, rad or mm, of a table with a column ``time_s``."""
    table = _table(path)
    q, unit, _ = _joints(table)
    return table.numbers(_required(table, ("time", "times", "t"), "the time")), q, unit


def is_table_of_joints(path: Path) -> bool:
    """Tell whether a file has columns of joints; its values are not judged."""
    try:
        return any(_JOINT.fullmatch(_plain(head)[0]) for head in _table(path).header)
    except InputError:
        return False


def _points(path: Path) -> tuple[list[str], list[str], Array, list[int]]:
    """Return groups, names, positions (N, 3) [mm] and lines of a list of points."""
    table = _table(path)
    if table.header:
        where, group = _required(table, _POINT, "the point's name"), table.column(_GROUP)
        axes = [_required(table, (a,), a.upper()) for a in "xyz"]
        units = [_plain(table.header[a])[1] or table.unit or "mm" for a in axes]
    else:
        width = min(len(row) for row in table.cells)
        if width < 4:
            raise InputError(
                f"a line has {width} cells, where group, point, X, Y, Z were expected.",
                "Export the points with their group and name, in this order.",
                file=path,
                line=next(n for n, row in zip(table.lines, table.cells, strict=True) if len(row) == width),
            )
        first = next(c for c in range(width) if all(number_of(row[c]) is not None for row in table.cells) or c == 2)
        first = max(first, 1)
        where, group, axes, units = (
            first - 1,
            first - 2 if first > 1 else None,
            [first, first + 1, first + 2],
            [table.unit or "mm"],
        )
    bad = next((u for u in units if u not in LENGTHS), None)
    if bad is not None:
        raise InputError(f"'{bad}' is no unit of length.", f"Known: {', '.join(LENGTHS)}.", file=path)
    scale = [LENGTHS[u] for u in units]
    xyz = np.column_stack([table.numbers(c) for c in axes]) * scale
    groups = [row[group] if group is not None else "points" for row in table.cells]
    return groups, [row[where] for row in table.cells], xyz, table.lines


def _joints(table: _Table) -> tuple[Array, str, list[int]]:
    """Return joints (N, n) [rad or mm], their unit inside, and their columns."""
    found: dict[int, tuple[int, str]] = {}
    for c, head in enumerate(table.header):
        name, unit = _plain(head)
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


def _plain(head: str) -> tuple[str, str]:
    """Return a column's name without blanks and marks, in small letters, and the unit that stands with it."""
    text = head.strip().strip('"').lower()
    match = re.fullmatch(r"(.*?)[\s_]*(?:[\[(]\s*(\w+)\s*[\])]|[\s_](deg|rad|mm|cm|m|in|inch|inches|degrees))?", text)
    name, unit = (match[1], match[2] or match[3] or "") if match else (text, "")
    return re.sub(r"[\s_.]+", "", name), {"degrees": "deg", "°": "deg", "radians": "rad"}.get(unit, unit)


def _required(table: _Table, names: Sequence[str], what: str) -> int:
    column = table.column(names)
    if column is None:
        raise InputError(
            f"there is no column with {what}; there are {', '.join(table.header) or 'none with a name'}.",
            f"Name one '{names[0]}'.",
            file=table.path,
            line=1,
        )
    return column


def _numeric(table: _Table, column: int) -> bool:
    cells = [row[column] for row in table.cells if column < len(row) and row[column]]
    return bool(cells) and all(number_of(c) is not None for c in cells)


def _table(path: Path) -> _Table:
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
        return _Table(path, cells[0], cells[1:], lines[1:], unit)
    return _Table(path, [], cells, lines, unit)


def _begins(line: str) -> bool:
    """Tell whether a table may begin with a line: a header with known names, or three numbers at least."""
    for mark in ("\t", ";", ",", None):
        cells = [c.strip().strip('"') for c in (line.split(mark) if mark else line.split())]
        names = {_plain(c)[0] for c in cells}
        joints = sum(_JOINT.fullmatch(n) is not None for n in names)
        if {"x", "y", "z"} <= names or (joints and names & {*_POINT, *_GROUP}) or joints > 1:
            return True
        if len(cells) > 3 and sum(number_of(c) is not None for c in cells) >= 3:
            return True
    return False


def _named(cell: str) -> list[str]:
    """Return group and point of a name like ``A::Main::p1``, collection and all in the group; other cells alone."""
    group, mark, point = cell.rpartition("::")
    return [group, point] if mark else [cell]
