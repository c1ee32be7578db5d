"""An answer as a person reads it: sentences and tables, which a terminal, a notebook or a page shows in its own way."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

SMALLEST = -6  # place of a digit that is still written out
COARSE = 1e-3  # below, four decimals are a digit or none
MOST_ROWS = 60  # of a table; a data frame has all


class Text(NamedTuple):
    """A sentence; `lead` are its first words, which stand out."""

    words: str
    lead: str = ""
    level: int = 0
    """How far it is indented."""

    def __str__(self) -> str:
        return "  " * self.level + self.lead + self.words


class Table(NamedTuple):
    """Cells as text."""

    head: tuple[str, ...]
    rows: Sequence[tuple[str, ...]]
    title: str = ""

    @property
    def numeric(self) -> list[bool]:
        """Whether a column holds numbers alone, or dashes where there is none."""
        return [all(_is_number(cell) for cell in column) for column in zip(*self.rows, strict=True)]


Document = Iterable[Text | Table]


def table_of(rows: Sequence[Mapping[str, Any]], title: str = "") -> Iterator[Text | Table]:
    """Yield a table with a column to each key, and how many rows more there are; nothing where there is no row."""
    if not rows:
        return
    head = columns(rows)
    yield Table(head, [_cells(row, head) for row in rows[:MOST_ROWS]], title)
    if len(rows) > MOST_ROWS:
        yield Text(f"and {len(rows) - MOST_ROWS} more")


def columns(rows: Sequence[Mapping[str, Any]]) -> tuple[str, ...]:
    """Return the keys of rows, each once, in their order."""
    return tuple(dict.fromkeys(name for row in rows for name in row))


def as_text(document: Document) -> str:
    """Return a document as plain text."""
    return "\n".join(line for part in document for line in _lines(part))


def _lines(part: Text | Table) -> Iterator[str]:
    if isinstance(part, Text):
        yield str(part)
        return
    cells = [part.head, *part.rows]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    yield from [part.title] if part.title else []
    for row in cells:
        yield "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()


def as_html(document: Document) -> str:
    """Return a document as HTML, for a notebook."""
    from html import escape

    def row(cells: tuple[str, ...], mark: str) -> str:
        return f"<tr>{''.join(f'<{mark}>{escape(cell)}</{mark}>' for cell in cells)}</tr>"

    def shown(part: Text | Table) -> str:
        if isinstance(part, Text):
            return f"<p><b>{escape(part.lead)}</b>{escape(part.words)}</p>"
        title = f"<caption>{escape(part.title)}</caption>" if part.title else ""
        body = "".join(row(cells, "td") for cells in part.rows)
        return f"<table>{title}<thead>{row(part.head, 'th')}</thead><tbody>{body}</tbody></table>"

    return "".join(map(shown, document))


# -------------------------------------------------------------------------------------------------- numbers as text


def rounded(value: float, std: float | None) -> tuple[str, str]:
    """Return a value and its standard uncertainty, both to two digits of that."""
    if std is None or not 0.0 < std < math.inf:
        return f"{value:.4g}", "-"
    last = math.floor(math.log10(std)) - 1  # place of the last digit
    if last < SMALLEST:
        first = math.floor(math.log10(max(abs(value), std)))
        return f"{value:.{first - last}e}", f"{std:.1e}"
    digits = max(-last, 0)
    return f"{round(value, digits) + 0.0:.{digits}f}", f"{std:.{digits}f}"  # no -0.00


def decimals(value: float) -> str:
    """Return an error or a noise to four decimals, or to two digits where these show less."""
    return f"{value:.4f}" if value == 0 or not abs(value) < COARSE else f"{value:.2g}"


def number(value: float | None, digits: int = 4) -> str:
    """Return a number to so many significant digits; a dash where there is none."""
    return "-" if value is None else f"{value:.{digits}g}"


def some(names: Sequence[str], most: int) -> str:
    """Return names, of many the first ones and how many more."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def _cells(row: Mapping[str, Any], names: Sequence[str]) -> tuple[str, ...]:
    cells = {name: _cell(row.get(name)) for name in names}
    value, std = row.get("value"), row.get("std")
    if isinstance(value, float) and isinstance(std, float):
        cells |= zip(("value", "std"), rounded(value, std), strict=True)
    return tuple(cells.values())


def _cell(value: object) -> str:
    if isinstance(value, list | tuple):
        return ", ".join(map(_cell, value))
    return number(value) if value is None or isinstance(value, float) else str(value)


def _is_number(cell: str) -> bool:
    try:
        float(cell.removesuffix("%"))
    except ValueError:
        return cell in ("", "-")
    return True
