"""Recordings that were never a file: data frames of pandas, and what makes one (xarray, polars, Arrow)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from deltacal_gen.errors import WrongArray
from deltacal_gen.files.dialect import is_known
from deltacal_gen.files.rows import Rows, typed_rows
from deltacal_gen.files.sidecar import Sidecar
from deltacal_gen.files.toml import TomlFile, nearest
from deltacal_gen.files.writing import file_columns
from deltacal_gen.machine.values import Recording
from deltacal_gen.results.base import frame_of

if TYPE_CHECKING:
    import pandas as pd

PATH = Path("data frame")  # what messages call it
_MAKERS = ("to_dataframe", "to_pandas")  # methods that make a data frame


def is_frame(given: object) -> bool:
    """Tell whether an object has columns with names, or makes what has them."""
    if any(hasattr(given, maker) for maker in _MAKERS):
        return True
    return any(isinstance(name, str | tuple) for name in getattr(given, "columns", ()))


def rows_of(frame: object) -> tuple[Rows, Sidecar]:
    """Return the table of a data frame, and what its ``attrs`` say in the place of a sidecar.

    Columns are those of a file, with its units; an index counts as a column where it has the name of one.

    Raises
    ------
    UsageError
        It is no data frame.
    InputError
        It has no rows, two columns of one name, or `attrs` with a mistake; lines count the rows from 1.
    """
    if not (hasattr(frame, "columns") or any(hasattr(frame, maker) for maker in _MAKERS)):
        raise WrongArray(
            f"a {type(frame).__name__} is no recording: give the path of a file, or a data frame with its columns."
        )
    table = _table(frame)
    columns = [table.iloc[:, k] for k in range(table.shape[1])]
    cells = [["" if off else str(v).strip() for v, off in zip(own, own.isna(), strict=True)] for own in columns]
    rows = typed_rows(PATH, [str(name).strip() for name in table.columns], cells, len(table))
    return rows, _sidecar(getattr(frame, "attrs", {}))


def to_dataframe(recording: Recording) -> pd.DataFrame:
    """Return what the file of a recording would hold, as a data frame; of distances those alone. Needs pandas."""
    own, distances = file_columns(recording)
    cells = distances or own
    return frame_of([dict(zip(cells, row, strict=True)) for row in zip(*cells.values(), strict=True)])


def _table(frame: Any) -> Any:
    """Return the data frame of pandas, with those levels of its index as columns that have the name of one."""
    if hasattr(frame, "to_dataframe"):
        return frame.to_dataframe().reset_index()
    table = frame.to_pandas() if hasattr(frame, "to_pandas") else frame
    names = [n for n in table.index.names if isinstance(n, str) and n not in table.columns and is_known(n)]
    return table.reset_index(names) if names else table


def _sidecar(attrs: Mapping[Any, Any]) -> Sidecar:
    """Return the tables of a sidecar among what a data frame carries, which may be anything beside.

    What can only be meant for a sidecar, a table's name misspelt or a key outside of its table, is an error as there.
    """
    tables = Sidecar.model_fields
    own = {key for field in tables.values() for key in getattr(field.annotation, "model_fields", {})}
    meant = {
        str(key): value
        for key, value in attrs.items()
        if (isinstance(value, Mapping) and (key in tables or nearest(str(key), tables, cutoff=0.8)))
        or key == "measurement"
        or (key in own and "_" in str(key))
    }
    return TomlFile(PATH, "", meant).check(Sidecar)
