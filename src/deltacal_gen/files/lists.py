"""Lists of points and tables of joints: how instruments, their software and robots call their columns.

A list holds group, point, X, Y, Z, line by line; whatever stands between the columns, with or without a header, and
whatever the software writes before it (job, date, operator, units).
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from deltacal_gen.errors import InputError, MissingColumn, WrongUnit
from deltacal_gen.files.dialect import Scales, Vocabulary, length_unit, named
from deltacal_gen.files.rows import Rows, number_of, read_table
from deltacal_gen.machine.registry import Array
from deltacal_gen.states import TIME
from deltacal_gen.units import to_internal

POINT, GROUP = "pose", "setup"  # columns of files here that a point's name and its group become
_CALLED = {  # what these are called, the surest first
    GROUP: ("group", "groupname", "setup", "station"),
    POINT: ("point", "pointname", "pointid", "target", "pose", "name", "id"),
    TIME: ("time", "times", "t"),
}
_HEAD = re.compile(r"(.*?)[\s_]*(?:[\[(]\s*(\w+)\s*[\])]|[\s_](deg|rad|mm|cm|m|in|inch|inches|degrees))?")
_UNITS = re.compile(r"\bunits?\b[^A-Za-z]*([A-Za-z]+)", re.IGNORECASE)
_JOINT = re.compile(r"(?:q|j|a|e|axis|joint|theta)(\d+)")
_READ = re.compile(r"q(\d+)(?:_(deg|mm))?")


def _name(header: Sequence[str], units: Sequence[str], before: str) -> tuple[list[str], Scales]:
    """Return a list's columns by their names in files here; lengths are in mm where neither they nor `before` say."""
    plain = [_plain(head) for head in header]
    names, stems = list(header), [stem if unit in ("", "s") else "" for stem, unit in plain]
    for own, others in _CALLED.items():
        if (found := next((stems.index(other) for other in others if other in stems), None)) is not None:
            names[found] = own
    length = next((unit for said in _UNITS.findall(before) if (unit := length_unit(said)) is not None), "mm")
    for k, (stem, unit) in enumerate(plain):
        if (joint := _JOINT.fullmatch(stem)) is not None:
            names[k] = f"q{joint[1]} [{unit}]" if unit else f"q{joint[1]}"
        elif stem in ("x", "y", "z"):
            names[k] = f"{stem} [{unit or length}]"
    return named(names, units)


def _plain(head: str) -> tuple[str, str]:
    """Return a column's name without blanks and marks, in small letters, and the unit that stands with it."""
    match = _HEAD.fullmatch(head.strip().lower().rpartition("::")[2])
    return (re.sub(r"[\s_.]+", "", match[1]), match[2] or match[3] or "") if match else (head, "")


def _bare(rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the header of a list without one: group and point stand before the first three columns of numbers."""
    width = min(map(len, rows))
    numeric = [all(number_of(row[c]) is not None for row in rows) for c in range(width)]
    first = max(next((c for c in range(width) if numeric[c] or c == 2), 1), 1)
    known = [*(["group"] if first > 1 else []), "point", "x", "y", "z"]
    rest = [f"column {c + 1}" for c in range(len(rows[0]))]
    return [*rest[: max(first - 2, 0)], *known, *rest[first + 3 :]]


LISTED = Vocabulary(_name, ("\t", ";", ",", ""), ("#", "//", "%"), _bare)


def read_list(path: Path) -> Rows:
    """Read a list of points, or a table of joints, with columns by their names in files here; raises InputError."""
    return read_table(path, LISTED)


def points_of(rows: Rows) -> tuple[list[str], list[str]]:
    """Return the groups of points, blank where there are none, and their names; of ``A::Main::p1`` the name is p1."""
    rows.require(POINT)
    names, groups = rows.columns[POINT], rows.columns.get(GROUP, [""] * len(rows.line))
    parts = [name.rpartition("::") for name in names]
    return [part[0] or group for part, group in zip(parts, groups, strict=True)], [part[2] for part in parts]


def joints_of(rows: Rows) -> tuple[Array, tuple[str, ...]]:
    """Return joints (N, n) and the unit of each, rad or mm; raises InputError where they cannot be used."""
    found = {int(match[1]): name for name in rows.columns if (match := _READ.fullmatch(name)) is not None}
    if not found or sorted(found) != list(range(1, len(found) + 1)):
        raise rows.error(
            "the joints' columns are missing, or not numbered from 1.",
            "Name them q1_deg, q2_deg, ... (q1_mm for sliding joints).",
            family=MissingColumn,
        )
    names = [found[number] for number in sorted(found)]
    for name in names:
        if "_" not in name:
            raise rows.error(
                "the unit of a joint is not said.",
                f"Name the column {name}_deg, {name}_rad or {name}_mm.",
                column=name,
                family=WrongUnit,
            )
    units = tuple("mm" if name.endswith("_mm") else "rad" for name in names)
    return rows.numbers(*names, blank=False) * [to_internal(unit) for unit in units], units


def joints_in_time(path: Path) -> tuple[Array, Array, tuple[str, ...]]:
    """Return stamps (N,) [s], joints (N, n) and the unit of each, rad or mm, of a table with a column ``time_s``."""
    rows = read_list(path)
    return rows.numbers(TIME, blank=False)[:, 0], *joints_of(rows)


def is_table_of_joints(path: Path) -> bool:
    """Tell whether a file has columns of joints; its values are not judged."""
    try:
        return any(_READ.fullmatch(name) for name in read_list(path).columns)
    except InputError:
        return False
