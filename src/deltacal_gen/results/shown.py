"""Answers as data frames and pictures."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from deltacal_gen.errors import UsageError
from deltacal_gen.results.document import columns

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


def frame(rows: Sequence[Mapping[str, Any]]) -> pd.DataFrame:
    """Return the rows as a data frame; raises UsageError where pandas is not installed."""
    try:
        import pandas as pd
    except ImportError:
        raise UsageError("a data frame needs pandas, which is not installed: pip install pandas.") from None
    return pd.DataFrame(list(rows), columns=columns(rows))


_lent: dict[str, Callable[[Any], Any]] = {}  # by what they do


def lend(*, plot: Callable[[Any], Figure], columns: Callable[[Any], Any]) -> None:
    """Take what draws an answer, and what names the columns of a recording and of its distances as files do.

    Both are known in rooms above answers, which do not know them: the package lends them, which is above all rooms.
    """
    _lent.update(plot=plot, columns=columns)


def recorded(recording: object) -> pd.DataFrame:
    """Return a recording as a data frame; how its columns are called is known where files are written."""
    own, distances = _lent["columns"](recording)
    told = distances or own
    return frame([dict(zip(told, row, strict=True)) for row in zip(*told.values(), strict=True)])


def picture(answer: object) -> Figure:
    """Return the picture of an answer; how it is drawn is known where pages are made."""
    drawn: Figure = _lent["plot"](answer)
    return drawn
