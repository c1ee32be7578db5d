"""How a table is written down: its encoding, what stands before it, separators, decimal marks and units.

What is certain is read as it is meant. What is not, such as 1,234 where no other cell says what the comma is, is asked
for: ``--decimal ,`` or ``.`` (in Python `decimal_mark`).
"""

from __future__ import annotations

import contextlib
import csv
import re
import tomllib
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar, Token
from dataclasses import dataclass
from datetime import UTC, datetime, time
from pathlib import Path
from typing import Any

from deltacal_gen.errors import DecimalMark, FileFormat, UnknownName, WrongUnit
from deltacal_gen.files.columns import DRIVE, JOINT, RESERVED, is_channel
from deltacal_gen.files.toml import read_bytes
from deltacal_gen.states import TIME

_FOREIGN = (  # how files begin that are no text
    (b"PK\x03\x04", "a workbook or an archive", "Save the sheet as .xlsx, with that ending, or as CSV."),
    (b"\xd0\xcf\x11\xe0", "a workbook of an old kind (.xls)", "Save the sheet as .xlsx or CSV."),
    (b"\x1f\x8b", "compressed (gzip)", "Unpack it."),
    (b"PAR1", "Parquet", "Give it the ending .parquet."),
)
LOOKED_AT = 200  # lines in which the header is searched for
_MOMENT = re.compile(r"(date_?)?time(_?stamp)?|date|stamp")  # names of columns that hold moments
_DOTTED = re.compile(r"(?P<day>\d{1,2})\.(?P<month>\d{1,2})\.(?P<year>\d{4})[ T](?P<rest>.*)")  # the day is first
_SLASHED = re.compile(r"\d{4}/\d\d/\d\d[ T]")  # the year is first; 1/2/2026 is the one here and the other there
LABELS = {"pose", "setup", "contact", "pose_a", "pose_b", "run"}
_TABLE: dict[str, dict[str, Any]] = tomllib.loads(Path(__file__).with_name("units.toml").read_text("utf-8"))
_FACTORS, _ABOVE = _TABLE["factors"], _TABLE["above"]
_UNITS = [(re.compile(name), own, _FACTORS[own]) for name, units in _TABLE["columns"].items() for own in units]
_SPELT = {spelling: unit for unit, spellings in _TABLE["spellings"].items() for spelling in spellings}
_MM: dict[str, float] = _FACTORS["mm"]
_NO_UNIT = {"", "-", "none", "text", "name"}
_COMMA = re.compile(r"[-+]?\d+,\d+(?:[eE][-+]?\d+)?")
_WITH_COMMA = re.compile(r"[-+]?(?:\d*,\d+|\d+,)(?:[eE][-+]?\d+)?")
_POINT = re.compile(r"[-+]?\d*\.\d+(?:[eE][-+]?\d+)?")
_GROUPS = {mark: re.compile(rf"[-+]?\d{{1,3}}(?:{re.escape(mark)}\d{{3}})+") for mark in ",."}
_SPACED = re.compile(r"[-+]?\d{1,3}(?:[ '\u00a0\u202f\u2019]\d{3})+(?:[.,]\d+)?")
_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
Line = tuple[int, str]  # of a file: its number and its text
Scales = dict[str, Sequence[float]]  # of columns in other units than those of files: factor, and what is added then
_decimal: ContextVar[str | None] = ContextVar("decimal", default=None)


@contextmanager
def decimal_mark(mark: str) -> Iterator[None]:
    """Read tables with a decimal mark, "." or ",", instead of finding out.

    Raises
    ------
    UsageError
        Another mark.
    """
    token = set_decimal_mark(mark)
    try:
        yield
    finally:
        _decimal.reset(token)


def set_decimal_mark(mark: str | None) -> Token[str | None]:
    """Set the decimal mark of all tables that are read from here on; None: find out."""
    if mark not in (".", ",", None):
        raise UnknownName(f"'{mark}' is no decimal mark; known are . and ,")
    return _decimal.set(mark)


def text_of(path: Path) -> str:
    r"""Return a file's text, lines ended by ``\n``: by its byte order mark, or UTF-8 where it is that, or Windows' own.

    Raises
    ------
    InputError
        The file cannot be read, or is no text.
    """
    data = read_bytes(path)
    for magic, what, remedy in _FOREIGN:
        if data.startswith(magic):
            raise FileFormat(f"this is no text, but {what}.", remedy, file=path)
    if b"\0" in data[:200] or data.startswith((b"\xff\xfe", b"\xfe\xff")):
        marked = data.startswith((b"\xff\xfe", b"\xfe\xff"))
        encodings = ["utf-16" if marked else "utf-16-le" if data[1:2] == b"\0" else "utf-16-be"]
    else:
        encodings = ["utf-8-sig", "cp1252"]
    for encoding in encodings:
        with contextlib.suppress(UnicodeDecodeError):
            return "\n".join(re.split("\r\n|\r|\n", data.decode(encoding)))
    raise FileFormat("the file is not text.", "Save the file as text in UTF-8.", file=path)


@dataclass(frozen=True)
class Layout:
    """Where a table begins among its lines, and how its cells are written.

    Attributes
    ----------
    header : int
        Which of the lines it is, from 0.
    separator : str
        "" where blanks alone separate columns.
    decimal : str
        "." or ",".
    units : bool
        Whether the row after the header holds units.
    bare : bool
        Whether there is no header: that line is the first row.
    """

    header: int
    separator: str
    decimal: str
    units: bool = False
    bare: bool = False


@dataclass(frozen=True)
class Vocabulary:
    """What tables of one sort call their columns, and what may stand around these.

    Attributes
    ----------
    name : callable
        Returns the columns of a header by their names in files here, and factor and offset of those in other units. It
        takes the header, the units that a row says, and the lines before the table.
    separators : sequence of str
        "" for blanks.
    remarks : tuple of str
        How lines begin that hold no cells.
    bare : callable, optional
        Returns the header that a table without one could have had; it takes the cells of its rows.
    """

    name: Callable[[Sequence[str], Sequence[str], str], tuple[list[str], Scales]]
    separators: Sequence[str] = (",", ";", "\t", "|")
    remarks: tuple[str, ...] = ("#",)
    bare: Callable[[Sequence[Sequence[str]]], list[str]] | None = None

    def knows(self, cells: Sequence[str]) -> bool:
        """Tell whether cells are a header: more than one of them is the name of a column."""
        return sum(map(is_known, self.name(cells, [""] * len(cells), "")[0])) > 1

    def beginning(self, lines: Sequence[Line]) -> tuple[int, str, bool] | None:
        """Return the line in which a table begins, its separator and whether it has no header; None where none does."""
        for k, (_, text) in enumerate(lines[:LOOKED_AT]):
            for separator in self.separators:
                cells = split(text, separator)
                if len(cells) > 1 and self.knows(cells):
                    return k, separator, False
                if self.bare and len(cells) > 3 and sum(map(is_number, cells)) >= 3:
                    return k, separator, True
        return None


def split(text: str, separator: str) -> list[str]:
    """Return the cells of a line, as far as quotes do not matter."""
    return [cell.strip().strip('"') for cell in text.split(separator or None)]


def is_number(cell: str) -> bool:
    """Tell whether a cell holds a number, with a decimal point or a comma."""
    return (_WITH_COMMA.fullmatch(cell) or _NUMBER.fullmatch(cell)) is not None


def layout_of(lines: Sequence[Line], vocabulary: Vocabulary) -> Layout:
    """Return the layout of a table by its lines, numbered as in the file.

    Raises
    ------
    InputError
        What the commas between digits are is not certain.
    """
    first = lines[0][1]
    usual = max(vocabulary.separators, key=lambda s: first.count(s) if s else 0.5)
    header, separator, bare = vocabulary.beginning(lines) or (0, usual, False)
    rows = csv.reader((text for _, text in parted(lines[header:], separator)), delimiter=separator or "\t")
    names, *cells = rows
    if len(names) == 1 and vocabulary.knows(names[0].split()):
        raise FileFormat(
            "its columns are parted by blanks.", "Part them by commas, semicolons or tabs.", line=lines[header][0]
        )
    units = bool(cells) and len(cells[0]) == len(names) and _are_units(cells[0])
    numbered = zip((number for number, _ in lines[header:]), [names, *cells] if bare else [[], *cells], strict=False)
    shown = ((number, cell.strip()) for number, row in numbered for cell in row)
    commas = separator != "," or any('"' in text for _, text in lines)  # where commas part cells, others are in quotes
    decimal = decimal_of(shown) if commas else _decimal.get() or "."
    return Layout(header, separator, decimal, units, bare)


def parted(lines: Sequence[Line], separator: str) -> Sequence[Line]:
    """Return lines whose cells are separated by a mark, a tab where it was blanks."""
    return lines if separator else [(number, "\t".join(text.split())) for number, text in lines]


def with_header(lines: list[Line], remarks: Sequence[Line], vocabulary: Vocabulary) -> list[Line]:
    """Return lines that hold cells with their header, which may be a remark before them, as `numpy.savetxt` writes it.

    `remarks` are lines that hold no cells, numbered likewise.
    """
    before = [(number, text.lstrip("#%/ \t")) for number, text in remarks if number < lines[0][0]][::-1]
    found, there = vocabulary.beginning(before), vocabulary.beginning(lines)
    if found is None or found[2] or not (there is None or there[2]):
        return lines
    return [before[found[0]], *lines]


def is_known(name: str) -> bool:
    """Tell whether a column of this name, as files here have it, means something to the program."""
    plain = name in RESERVED or name in LABELS or JOINT.fullmatch(name) or is_channel(name)
    return bool(plain or re.fullmatch(r"q\d+[ab]?(_(deg|mm))?", name))


def _are_units(cells: Sequence[str]) -> bool:
    """Tell whether a row holds units alone, and some."""
    plain = [_unit(cell) for cell in cells]
    known = {u for _, _, factors in _UNITS for u in factors} | {"px"}
    return all(u in known or u in _NO_UNIT for u in plain) and any(u in known for u in plain)


def _unit(text: str) -> str:
    plain = text.strip().strip("[]()").strip().lower()
    return _SPELT.get(plain, plain)


def length_unit(text: str) -> str | None:
    """Return a unit of length by its short name, of whatever spelling; None where the text is none."""
    unit = _unit(text)
    return unit if unit in _MM else None


def length_mm(text: str) -> float:
    """Return how many mm a unit of length has; raises InputError where it is none."""
    if (unit := length_unit(text)) is None:
        raise WrongUnit(f"'{text}' is no unit of length.", f"Known: {', '.join(_MM)}.")
    return _MM[unit]


def converted(name: str, unit: str = "") -> tuple[str, float, float]:
    """Return a column's name as files here have it, the factor to its unit, and what is added.

    ``X [m]`` is ``x_mm``, times 1000; ``temp [K]`` is ``temp_C``, less 273.15; ``Run`` is ``run``. `unit` is what a row
    of units says. A name that is not known stays as it is.
    """
    stem, said = name.strip(), _unit(unit)
    if any(stem.endswith(f"_{own}") and p.fullmatch(stem.removesuffix(f"_{own}")) for p, own, _ in _UNITS):
        return stem, 1.0, 0.0
    if (bracket := re.fullmatch(r"(.*?)[\s_]*[\[(]([^\])]*)[\])]", stem)) is not None:
        stem, said = bracket[1], said or _unit(bracket[2])
    plain = stem.lower().replace(" ", "_")
    head, _, tail = plain.rpartition("_")
    plain = f"{head}_{_SPELT[tail]}" if tail in _SPELT else plain  # x_inch, q1_degrees
    for pattern, own, factors in _UNITS:
        if pattern.fullmatch(plain) and said in factors:
            return f"{plain}_{own}", factors[said], _ABOVE.get(said, 0.0)
        for other, factor in factors.items():
            if plain.endswith(f"_{other}") and pattern.fullmatch(plain.removesuffix(f"_{other}")):
                return f"{plain.removesuffix(f'_{other}')}_{own}", factor, _ABOVE.get(other, 0.0)
    bare = plain in LABELS or is_channel(plain) or DRIVE.fullmatch(plain)  # Run, Drive1
    return plain if bare else name, 1.0, 0.0


def named(header: Sequence[str], units: Sequence[str], before: str = "") -> tuple[list[str], Scales]:
    """Return columns by their names in files here, and the scales of those in other units.

    The same quantity twice, in two units, is taken in that of files, and the other column stays what it is.
    """
    own = [converted(name, unit) for name, unit in zip(header, units, strict=True)]
    times = Counter(name for name, *_ in own)
    own = [one if times[one[0]] == 1 else (name, 1.0, 0.0) for name, one in zip(header, own, strict=True)]
    return [name for name, *_ in own], {name: scale for name, *scale in own if scale != [1.0, 0.0]}


RECORDED = Vocabulary(named)


def decimal_of(cells: Iterable[tuple[int, str]]) -> str:
    """Return the decimal mark of cells, with their lines, that are separated by no comma.

    Raises
    ------
    InputError
        No cell says it for certain, or cells contradict one another.
    """
    if (said := _decimal.get()) is not None:
        return said
    doubtful: tuple[int, str] | None = None
    point = comma = None
    for line, cell in cells:
        if "," not in cell:
            if _POINT.fullmatch(cell) and not _GROUPS["."].fullmatch(cell):
                point = point or (line, cell)
            continue
        whole, _, part = cell.rpartition(",")
        if "." in part or (_GROUPS[","].fullmatch(cell) and cell.count(",") > 1):
            point = point or (line, cell)
        elif "." in whole or (_COMMA.fullmatch(cell) and not _GROUPS[","].fullmatch(cell)) or whole in ("0", "-0"):
            comma = comma or (line, cell)
        elif _GROUPS[","].fullmatch(cell):
            doubtful = doubtful or (line, cell)
    if point and comma:
        raise DecimalMark(
            f"'{comma[1]}' in line {comma[0]} has a decimal comma, and '{point[1]}' a decimal point.",
            "Write all with one mark.",
            line=point[0],
        )
    if doubtful and not (point or comma):
        raise DecimalMark(
            f"whether the comma in '{doubtful[1]}' is a decimal mark or parts thousands, no cell says.",
            "Say it: --decimal , or --decimal .",
            line=doubtful[0],
        )
    return "," if comma else "."


def plain_number(cell: str, layout: Layout) -> str:
    """Return a number with a decimal point and without marks between thousands; other cells as they are."""
    decimal, other = layout.decimal, "," if layout.decimal == "." else "."
    bare = re.sub(r"[ '\u00a0\u202f\u2019]", "", cell) if _SPACED.fullmatch(cell) else cell
    whole, mark, part = bare.partition(decimal)
    if other != layout.separator and _GROUPS[other].fullmatch(whole):
        bare = whole.replace(other, "") + mark + part
    if decimal == "," and _WITH_COMMA.fullmatch(bare):
        return bare.replace(",", ".")
    return bare


def in_seconds(columns: dict[str, list[str]]) -> dict[str, list[str]]:
    """Return columns (of cells) with moments, written as dates and times of the day (ISO 8601), as seconds ``time_s``.

    Where dots part a date its day is first; where its year is first slashes may part it. Those of dates count from
    1970, UTC where no zone is said, others from midnight.
    """
    if TIME in columns:
        return columns
    for name, cells in columns.items():
        if _MOMENT.fullmatch(name.lower().replace(" ", "_")) and any(cells):
            seconds = [_seconds(cell) for cell in cells]
            if None not in seconds:
                told = {TIME: [str(s) for s in seconds]}
                return {k: v for n, c in columns.items() for k, v in (told if n == name else {n: c}).items()}
    return columns


def _seconds(cell: str) -> str | None:
    """Return a moment in seconds, as text; "" of a blank cell, None of what is none."""
    if not cell:
        return ""
    if ":" not in cell:
        return None
    if (dotted := _DOTTED.fullmatch(cell)) is not None:
        cell = f"{dotted['year']}-{dotted['month']:0>2}-{dotted['day']:0>2} {dotted['rest']}"
    elif _SLASHED.match(cell):
        cell = cell.replace("/", "-")
    with contextlib.suppress(ValueError):
        moment = datetime.fromisoformat(cell)
        return repr((moment if moment.tzinfo else moment.replace(tzinfo=UTC)).timestamp())
    with contextlib.suppress(ValueError):
        at = time.fromisoformat(cell)
        return repr(3600 * at.hour + 60 * at.minute + at.second + at.microsecond / 1e6)
    return None
