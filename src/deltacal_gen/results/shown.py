"""Answers as people meet them in a session: one line, a table as text or HTML, a data frame."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from deltacal_gen.errors import UsageError

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

SMALLEST = -6  # place of a digit that is still written out
COARSE = 1e-3  # below, four decimals are a digit or none
MOST = 60  # rows that are shown; a data frame has all

Table = Sequence[Mapping[str, Any]]


def text(headline: str, rows: Table) -> str:
    """Return a line and a table below it."""
    names = _names(rows)
    cells = [names, *(_cells(row, names) for row in rows[:MOST])]
    widths = [max(len(row[k]) for row in cells) for k in range(len(names))]
    lines = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in cells]
    return "\n".join([headline, *(lines if rows else []), *_rest(rows)])


def page(headline: str, rows: Table) -> str:
    """Return the same as HTML, for a notebook."""
    import html  # the package imports this module, and makes no page by that

    names = _names(rows)
    head = "".join(f"<th>{html.escape(name)}</th>" for name in names)
    body = "".join(
        f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in _cells(row, names))}</tr>" for row in rows[:MOST]
    )
    table = f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>" if rows else ""
    return f"<p>{html.escape(headline)}</p>{table}{''.join(f'<p>{html.escape(line)}</p>' for line in _rest(rows))}"


def frame(rows: Table) -> pd.DataFrame:
    """Return the rows as a data frame; raises UsageError where pandas is not installed."""
    try:
        import pandas as pd
    except ImportError:
        raise UsageError("a data frame needs pandas, which is not installed: pip install pandas.") from None
    return pd.DataFrame(list(rows), columns=_names(rows))


_lent: dict[str, Callable[[Any], Any]] = {}  # by what they do


def lend(*, plot: Callable[[Any], Figure], columns: Callable[[Any], Any]) -> None:
    """Take what draws an answer, and what names the columns of a recording and of its distances as files do.

    Both are known in rooms above answers, which do not know them: the package lends them, which is above all rooms.
    """
    _lent.update(plot=plot, columns=columns)


def recorded(recording: object) -> pd.DataFrame:
    """Return a recording as a data frame; how its columns are called is known where files are written."""
    columns, distances = _lent["columns"](recording)
    told = distances or columns
    return frame([dict(zip(told, row, strict=True)) for row in zip(*told.values(), strict=True)])


def picture(answer: object) -> Figure:
    """Return the picture of an answer; how it is drawn is known where pages are made."""
    drawn: Figure = _lent["plot"](answer)
    return drawn


def _names(rows: Table) -> list[str]:
    return list(dict.fromkeys(name for row in rows for name in row))


def rounded(value: float, std: float | None) -> tuple[str, str]:
    """Return a value and its standard deviation as people read them: as far as it is known, to two digits of that."""
    if std is None or not 0.0 < std < math.inf:
        return f"{value:.4g}", "-"
    last = math.floor(math.log10(std)) - 1  # place of the last digit
    if last < SMALLEST:
        first = math.floor(math.log10(max(abs(value), std)))
        return f"{value:.{first - last}e}", f"{std:.1e}"
    digits = max(-last, 0)
    return f"{round(value, digits) + 0.0:.{digits}f}", f"{std:.{digits}f}"  # no -0.00


def decimals(value: float) -> str:
    """Return an error or a noise as people read it: to four decimals, or to two digits where these show less."""
    return f"{value:.4f}" if value == 0 or not abs(value) < COARSE else f"{value:.2g}"


def needless(filed: float, heldout: float | None, unit: str = "mm") -> str:
    """Say that a calibrated machine is no nearer to readings that it has not seen than the robot file's; else nothing.

    Parameters
    ----------
    filed, heldout : float
        Errors of the robot file's machine, and of the calibrated one where readings were held out [unit].
    unit : str
    """
    if heldout is None or not heldout >= filed:
        return ""
    return (
        f"The machine as the robot file has it leaves no more, {decimals(filed)} {unit}, than the calibrated one does "
        f"of readings that it has not seen, {decimals(heldout)} {unit}: these readings do not show that it wants a "
        "correction. Where the instrument is surer than that, compare with the recording which point was measured, and "
        "whether joints and readings of a row belong together."
    )


def _cells(row: Mapping[str, Any], names: Sequence[str]) -> list[str]:
    """Return a row as text; a value beside its standard deviation as far as it is known."""
    cells = {name: _cell(row.get(name)) for name in names}
    value, std = row.get("value"), row.get("std")
    if isinstance(value, float) and isinstance(std, float):
        cells |= zip(("value", "std"), rounded(value, std), strict=True)
    return list(cells.values())


def _cell(value: object) -> str:
    if value is None:
        return "-"
    if isinstance(value, list | tuple):
        return ", ".join(map(_cell, value))
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _rest(rows: Table) -> list[str]:
    return [f"and {len(rows) - MOST} more"] if len(rows) > MOST else []
