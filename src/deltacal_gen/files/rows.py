"""Rows of a table, CSV or Parquet, as cells of text that know their line and column."""

from __future__ import annotations

import csv
import dataclasses
import itertools
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import (
    BadCell,
    BlankCell,
    FileFormat,
    FileNotReadable,
    InputError,
    MissingColumn,
    MissingLibrary,
    listed,
    naming,
)
from deltacal_gen.files import dialect
from deltacal_gen.files.columns import RESERVED, is_channel
from deltacal_gen.files.dialect import LOOKED_AT, RECORDED, Layout, Scales, Vocabulary
from deltacal_gen.files.toml import nearest

WORKBOOKS = (".xlsx", ".xlsm")
PARQUET = ".parquet"
SHOWN = 12  # columns that a message lists
LARGEST = 1e30  # number of a cell: its cube, and sums of these, are numbers still


@dataclass(frozen=True)
class Rows:
    """Cells of a file, as text, by column."""

    path: Path
    columns: dict[str, list[str]]
    line: np.ndarray  # of each row
    header_line: int | None
    scales: Scales = field(default_factory=dict)
    """Factor, and what is added then, of columns in other units than their names say now."""
    sheet: str = ""
    """Of a workbook that has several."""

    def error(
        self,
        problem: str,
        remedy: str,
        *,
        row: int | None = None,
        column: str | None = None,
        family: type[InputError] = BadCell,
    ) -> InputError:
        """Return the error that names file, line (that of the header without a row) and column."""
        line = self.header_line if row is None else int(self.line[row])
        problem = f"in the sheet '{self.sheet}': {problem}" if self.sheet else problem
        return family(problem, remedy, file=self.path, line=line, column=column)

    def refuse(self, rows: np.ndarray, problem: str | Callable[[int], str], remedy: str, **how: Any) -> None:
        """Raise for the first of the rows (N,) that are marked, if there is one."""
        if rows.any():
            row = int(np.argmax(rows))
            raise self.error(problem if isinstance(problem, str) else problem(row), remedy, row=row, **how)

    def subset(self, kept: np.ndarray) -> Rows:
        """Return the rows (N,) that are marked."""
        columns = {name: list(itertools.compress(cells, kept)) for name, cells in self.columns.items()}
        return dataclasses.replace(self, columns=columns, line=self.line[kept])

    def without(self, names: Iterable[str]) -> Rows:
        """Return the rows without these columns; one that is not there is no error."""
        dropped = set(names)
        kept = {name: cells for name, cells in self.columns.items() if name not in dropped}
        return dataclasses.replace(self, columns=kept)

    def require(self, *names: str) -> None:
        """Raise for the first column that is not there, naming one that may be meant."""
        for name in names:
            if name in self.columns:
                continue
            others = [n for n in self.columns if n not in RESERVED.union(names) and not is_channel(n)]
            stem = name.split("_")[0]
            close = next((n for n in others if n.lower().split("_")[0] == stem), None) or nearest(name, others)
            unit = f" in {name.split('_')[-1]}" if "_" in name else ""
            problem = f"the column is missing; '{close}' looks like it." if close else "the column is missing."
            remedy = f"Rename it to '{name}' and give it{unit}." if close else f"Add it{unit}, or correct the header."
            if not close and others:
                remedy += f" Other columns are {listed(others, SHOWN)}."
            raise self.error(problem, remedy, column=name, family=MissingColumn)

    def filled(self, name: str, value: float, beside: str) -> Rows:
        """Return the rows with a value in blank cells of a column, or of one not there, where those beside are full."""
        cells = self.columns.get(name) or [""] * len(self.line)
        there = self.columns.get(beside) or [""] * len(self.line)
        whole = [cell or (str(value) if other else "") for cell, other in zip(cells, there, strict=True)]
        return dataclasses.replace(self, columns=self.columns | {name: whole})

    def labels(self, name: str, *, blank: bool = True) -> list[str] | None:
        """Return a column of names, None where there is none; a blank one is named after its line, or raises."""
        cells = self.columns.get(name)
        if cells is not None and not blank and "" in cells:
            raise self.error("the cell is blank.", "Fill it in.", row=cells.index(""), column=name, family=BlankCell)
        return cells and [cell or f"line {line}" for cell, line in zip(cells, self.line, strict=True)]

    def numbers(self, *names: str, blank: bool = True) -> np.ndarray:
        """(N, k) numbers of k columns that belong together: a row is complete, or all blank where that is allowed."""
        self.require(*names)
        values = np.column_stack([self._column(name) for name in names])
        gaps = np.isnan(values)
        bad = gaps.any(axis=1) & ~(gaps.all(axis=1) & blank)
        if bad.any():
            row = int(np.argmax(bad))
            problem, remedy = "the cell is blank.", "Fill it in, or remove the row."
            if blank:
                problem = f"the cell is blank, but other cells of {', '.join(names)} are not."
                remedy = "Fill it in, or blank them all."
            name = names[int(np.argmax(gaps[row]))]
            raise self.error(problem, remedy, row=row, column=name, family=BlankCell)
        return values

    def each(self, *names: str) -> np.ndarray:
        """(N, k) numbers of k columns, each for itself; one that is not there is blank."""
        blank = np.full(len(self.line), np.nan)
        return np.column_stack([self._column(name) if name in self.columns else blank for name in names])

    def numeric(self, *but: str) -> dict[str, np.ndarray]:
        """Return the other columns (N,) that hold numbers alone, and some, by their names."""
        return {
            name: self._column(name)
            for name, cells in self.columns.items()
            if name not in but and any(cells) and all(number_of(cell) is not None for cell in cells if cell)
        }

    def _column(self, name: str) -> np.ndarray:
        cells, (factor, above) = self.columns[name], self.scales.get(name, (1.0, 0.0))
        values = np.array([number_of(cell) if cell else None for cell in cells], dtype=float)
        wrong = ~(np.abs(values) <= LARGEST) & np.array([cell != "" for cell in cells])
        if wrong.any():
            raise self._no_number(int(np.argmax(wrong)), name)
        return values * factor + above

    def _no_number(self, row: int, name: str) -> InputError:
        cell = self.columns[name][row]
        value, remedy, expected = number_of(cell), "Correct the cell or remove the row.", "a number"
        if value is not None and np.isfinite(value):
            expected = f"a number below {LARGEST:g}"
        elif value is not None:
            expected = "a finite number"
            remedy = "Leave the cell blank where nothing was measured; joints must be complete."
        elif dialect.is_number(cell):
            remedy = "Write a decimal point, or say --decimal , where all cells have a comma."
        shown = cell if len(cell) <= 40 else f"{cell[:36]} ..."
        return self.error(f"the cell holds '{shown}', {expected} was expected.", remedy, row=row, column=name)


def number_of(cell: str) -> float | None:
    """Return the number in a cell; None where it holds none."""
    try:
        return None if "_" in cell else float(cell)  # float() takes 1_000
    except ValueError:
        return None


def read_table(path: Path, vocabulary: Vocabulary = RECORDED) -> Rows:
    """Read a table: Parquet or a workbook by its ending, otherwise text; raises InputError."""
    if path.suffix.lower() not in (PARQUET, *WORKBOOKS):
        return read_csv(path, vocabulary=vocabulary)
    with naming(path):
        try:
            return _read_parquet(path) if path.suffix.lower() == PARQUET else _read_workbook(path, vocabulary)
        except ImportError as error:
            library, extra = ("pyarrow", "parquet") if path.suffix.lower() == PARQUET else ("openpyxl", "xlsx")
            raise MissingLibrary(
                f"reading it needs {library}, which is not installed ({error}).",
                f"Install it (pip install 'deltacal_gen[{extra}]'), or save the table as CSV.",
            ) from None
        except OSError as error:
            raise FileNotReadable(f"the file cannot be read: {error.strerror or error}.", "Check the path.") from None


def read_csv(path: Path, first: int | None = None, vocabulary: Vocabulary = RECORDED) -> Rows:
    """Read a table of text, or its first rows, as many as `first`; raises InputError."""
    numbered = list(enumerate(dialect.text_of(path).split("\n"), start=1))
    lines = [(n, line) for n, line in numbered if line.strip() and not line.startswith(vocabulary.remarks)]
    remarks = [(n, line) for n, line in numbered[:LOOKED_AT] if line.startswith(vocabulary.remarks)]
    with naming(path):
        if not lines:
            raise FileFormat("the file is empty.", "Give a header and one row per reading.")
        lines = dialect.with_header(lines, remarks, vocabulary)
        table: list[list[str]] = []
        numbers = [0]  # of the lines in which rows end
        try:
            layout = dialect.layout_of(lines if first is None else lines[:LOOKED_AT], vocabulary)
            lines, before = lines[layout.header :], "\n".join(text for _, text in lines[: layout.header])
            texts = (text for _, text in dialect.parted(lines, layout.separator))
            reader = csv.reader(texts, delimiter=layout.separator or "\t", strict=True)
            for cells in itertools.islice(reader, None if first is None else 1 + layout.units + first):
                table.append([cell.strip() for cell in cells])
                numbers.append(lines[reader.line_num - 1][0])
        except csv.Error as error:
            begins = next(n for n, _ in lines if n > numbers[-1])
            raise FileFormat(f"this is not CSV: {error}.", "Correct the quotes.", line=begins) from None
        return _of_cells(path, table, numbers[1:], layout, vocabulary, before)


def _of_cells(
    path: Path,
    table: list[list[str]],
    numbers: list[int],
    layout: Layout,
    vocabulary: Vocabulary,
    before: str = "",
    sheet: str = "",
) -> Rows:
    """Return cells (header, units where there are, rows) with their lines as columns in the units of files."""
    table, header_line = _without_blank_ends(table), numbers[0]
    if layout.bare and vocabulary.bare is not None:
        table = [vocabulary.bare([[dialect.plain_number(cell, layout) for cell in row] for row in table]), *table]
        numbers = [header_line, *numbers]
    header, units = table[0], table[1] if layout.units else [""] * len(table[0])
    table, numbers = table[1 + layout.units :], numbers[1 + layout.units :]
    header, scales = vocabulary.name(header, units, before)
    _check_header(header, header_line)
    for cells, line in zip(table, numbers, strict=True):
        if len(cells) != len(header):
            comma = " Decimals need a point, not a comma." if len(cells) > len(header) else ""
            raise FileFormat(
                f"the row has {len(cells)} cells, the header {len(header)}.", f"Correct the row.{comma}", line=line
            )
    if not table:
        raise FileFormat("there is a header but no row.", "Add one row per reading.", line=header_line)
    columns = {name: [cells[k] for cells in table] for k, name in enumerate(header)}
    if layout.separator != "," or layout.decimal != ".":
        for name in columns.keys() - dialect.LABELS:
            columns[name] = [dialect.plain_number(cell, layout) for cell in columns[name]]
    return Rows(path, dialect.in_seconds(columns), np.array(numbers), header_line, scales, sheet)


def typed_rows(path: Path, header: Sequence[str], cells: Sequence[list[str]], count: int) -> Rows:
    """Return columns of cells, of a table that holds so many rows of numbers and not their text, in the units of files.

    Raises
    ------
    InputError
        There is no row, a column has no name, or two have one.
    """
    with naming(path):
        if not count:
            raise FileFormat("there is no row.", "Add one row per reading.")
        _check_header(header, None)
    names, scales = dialect.named(header, [""] * len(header))
    return Rows(path, dialect.in_seconds(dict(zip(names, cells, strict=True))), np.arange(1, count + 1), None, scales)


def _without_blank_ends(table: list[list[str]]) -> list[list[str]]:
    """Return rows without blank cells beyond the last name: of separators that end a line."""
    width = len(_trimmed(table[0]))
    if not any(any(row[width:]) for row in table):
        return [row[:width] for row in table]
    return table


def _read_workbook(path: Path, vocabulary: Vocabulary) -> Rows:
    """Read a workbook (``.xlsx``): the first sheet with columns that are known, or the first that is not empty."""
    import openpyxl

    try:
        book = openpyxl.load_workbook(path, read_only=True, data_only=True)
        sheets = {s.title: [list(map(_text_of, row)) for row in s.values] for s in book.worksheets}
        book.close()
    except OSError:
        raise
    except Exception as error:  # of a library that lets through whatever is wrong inside the archive
        raise FileFormat(f"this is no workbook: {type(error).__name__}.", "Save it again as .xlsx.") from None
    tables = {}
    for title, sheet in sheets.items():
        kept = [(n, _trimmed(row)) for n, row in enumerate(sheet, start=1) if any(row) and not row[0].startswith("#")]
        if kept:
            tables[title] = kept, [(n, "\t".join(cell.replace("\t", " ") for cell in row)) for n, row in kept]
    if not tables:
        raise FileFormat("no sheet holds a table.", "Give a header and one row per reading.")
    title = next((own for own, (_, lines) in tables.items() if vocabulary.beginning(lines)), next(iter(tables)))
    kept, lines = tables[title]
    layout = dataclasses.replace(dialect.layout_of(lines, vocabulary), separator="\t")
    width = len(kept[layout.header][1])
    rows = [row + [""] * (width - len(row)) for _, row in kept[layout.header :]]
    numbers = [n for n, _ in kept[layout.header :]]
    return _of_cells(path, rows, numbers, layout, vocabulary, sheet=title if len(sheets) > 1 else "")


def _text_of(value: object) -> str:
    return "" if value is None else str(value).strip()


def _trimmed(row: list[str]) -> list[str]:
    """Return a row without the blank cells at its end."""
    while row and not row[-1]:
        row = row[:-1]
    return row


def _read_parquet(path: Path) -> Rows:
    """Read a Parquet file; raises InputError."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        with pq.ParquetFile(path) as file:
            table = file.read()
        cells = [list(map(_text_of, column.to_pylist())) for column in table.columns]
    except (OSError, ValueError, pa.ArrowException) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise FileFormat(f"this is not a readable Parquet file: {reason}.", "Save it again.") from None
    return typed_rows(path, table.schema.names, cells, table.num_rows)


def _check_header(header: Sequence[str], line: int | None) -> None:
    for k, name in enumerate(header):
        if not name:
            raise MissingColumn(f"column {k + 1} has no name.", "Name it, or remove the comma too many.", line=line)
        if name in header[:k]:
            raise MissingColumn(
                f"the name stands over columns {header.index(name) + 1} and {k + 1}.",
                "Rename or remove one of them.",
                line=line,
                column=name,
            )
