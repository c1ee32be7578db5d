"""Answers as values: frozen, their fields, in order, the keys of their JSON.

Three rules say all of the form:

- a field without a default is always written; ``None`` in it is JSON's null;
- a field whose default is ``None`` is left out of the JSON while it is ``None``;
- a name that is a word of Python's, or of pydantic's, ends with an underscore, which the key has not.

Arrays hold what comes in bulk; NaN in them is a blank cell, null in JSON. All other sequences are tuples.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import AliasChoices, AliasGenerator, BaseModel, ConfigDict, model_serializer
from pydantic_core import core_schema

from deltacal_gen.errors import NotInstalled
from deltacal_gen.results.document import Document, Text, as_html, as_text, columns, table_of

if TYPE_CHECKING:
    import pandas as pd

Json = dict[str, Any]
UNITS = ("Nm", "N", "A", "1")  # of what drives give
OF_ALL_JOINTS = ("train_rms", "heldout_rms", "sigma", "rms")  # whose keys end in the one unit of what drives give
LENGTH = re.compile(r"(\w*rms|sigma|worst|error|open|mean|expanded|machine)_mm")  # keys of what readings are off


# ------------------------------------------------------------------------------------------- keys that end in a unit


def key_of(field: str) -> str:
    """Return the key under which a field stands in JSON."""
    return field.removesuffix("_")


def keys_of(field: str) -> tuple[str, ...]:
    """Return all keys under which a field may stand in JSON: of drives, each figure of all joints in their unit."""
    return tuple(f"{field}_{unit}" for unit in UNITS) if field in OF_ALL_JOINTS else (key_of(field),)


def _aliases(field: str) -> AliasChoices:
    return AliasChoices(*keys_of(field))


def in_units(found: Any, unit: str, length: float, lengths: re.Pattern[str] = LENGTH) -> Any:
    """Return JSON under the keys of files, which end in the unit of what was read.

    Parameters
    ----------
    unit : str
        Of files: px and deg, in which each length of a reading stands too; Nm, N, A or 1, in which drives are read.
    length : float
        What it is at the platform [mm].
    lengths : re.Pattern
        Keys of what stands in that unit too.
    """
    if isinstance(found, list) and found and isinstance(found[0], list | dict):
        return [in_units(v, unit, length, lengths) for v in found]
    if not isinstance(found, dict):
        return found
    out: Json = {}
    for key, value in found.items():
        out[f"{key}_{unit}" if key in OF_ALL_JOINTS else key] = in_units(value, unit, length, lengths)
        if lengths.fullmatch(key) and value is not None:
            each = {k: v / length for k, v in value.items()} if isinstance(value, dict) else value / length
            out[key.removesuffix("mm") + unit] = each
    return out


def shown_in(answer: Any) -> tuple[str, float]:
    """Return the unit in which an answer's figures are shown, that of its readings, and what it is in mm."""
    unit, length = getattr(answer, "unit", None), getattr(answer, "unit_mm", None)
    return (unit, length) if unit and length else ("mm", 1.0)


def plain(value: Any) -> Any:
    """Return a value as `json` reads it back: dictionaries, lists, numbers, text."""
    if isinstance(value, Value):
        return value.to_dict()
    if isinstance(value, Mapping):
        return {key: plain(v) for key, v in value.items()}
    return [plain(v) for v in value] if isinstance(value, tuple | list) else value


class Value(BaseModel):
    """Part of an answer. Two are equal where their JSON is."""

    model_config = ConfigDict(
        frozen=True,
        defer_build=True,  # until the first is made or read: a command uses few of these types
        arbitrary_types_allowed=True,
        allow_inf_nan=False,
        alias_generator=AliasGenerator(
            validation_alias=lambda f: AliasChoices(*keys_of(f)), serialization_alias=key_of
        ),
        populate_by_name=True,
        protected_namespaces=(),
    )

    def replace(self, **changes: Any) -> Self:
        """Return the same with other values in some fields."""
        if unknown := changes.keys() - type(self).model_fields.keys():
            raise TypeError(f"{type(self).__name__} has no field '{unknown.pop()}'")
        return type(self)(**vars(self) | changes)

    @model_serializer(mode="wrap")
    def _written(self, handler: Any) -> Json:
        """Return the JSON without keys that are left out while they are null."""
        fields = type(self).model_fields
        absent = {key_of(n) for n, value in vars(self).items() if value is None and not fields[n].is_required()}
        return {key: value for key, value in handler(self).items() if key not in absent}

    def to_dict(self) -> Json:
        """Return the JSON as plain dictionaries, lists, numbers and text, the keys in the order of the file."""
        return self.model_dump(mode="json", by_alias=True)

    def __eq__(self, other: object) -> bool:
        return self.to_dict() == other.to_dict() if isinstance(other, Value) else NotImplemented

    __hash__ = None  # type: ignore[assignment]  # as Python says that what compares by value has none


class Answer(Value, Mapping[str, Any]):
    """What a command answers: attributes for programs, and by key the JSON itself, as a plain part of it.

    ``answer["effects"][0]["name"]`` is what the file says under these keys; ``answer | {...}`` is the JSON as a
    dictionary with other values. Where readings have another unit than mm, `unit` names it, `unit_mm` says what it is
    at the platform, and the file gives each of their figures in either.
    """

    lengths: ClassVar[re.Pattern[str]] = LENGTH

    @classmethod
    def named(cls) -> str:
        """Return what `schema` says in answers of this type."""
        return str(cls.model_fields["schema_"].default)

    def to_dict(self, only: set[str] | None = None) -> Json:
        """Return the JSON as plain dictionaries, lists, numbers and text, the keys in the order of the file."""
        unit, length = shown_in(self)
        found = self.model_dump(mode="json", by_alias=True, include=only)
        return found if unit == "mm" else in_units(found, unit, length, self.lengths)

    @property
    def headline(self) -> str:
        """The answer in one line."""
        return f"{len(self.table())} rows" if self.table() else ", ".join(self)

    def table(self) -> tuple[Value, ...]:
        """Return the rows that a person looks at first; none where there is no such table."""
        return ()

    def to_dataframe(self) -> pd.DataFrame:
        """Return the table as a data frame, a column to each key; needs pandas."""
        return frame_of([row.to_dict() for row in self.table()])

    def document(self) -> Document:
        """Yield the answer as a person reads it: sentences and tables."""
        yield Text(self.headline)
        yield from table_of([row.to_dict() for row in self.table()])

    def __str__(self) -> str:
        """Return the answer as text."""
        return as_text(self.document())

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.headline}>"

    def _repr_html_(self) -> str:
        return as_html(self.document())

    def to_json(self) -> str:
        """Return the text of the file: a line to each key.

        Python writes indented JSON ten times as slowly, and a diagnosis holds a number for every reading.
        """
        lines = (f" {json.dumps(k)}: {json.dumps(v, allow_nan=False)}" for k, v in self.to_dict().items())
        return "{\n" + ",\n".join(lines) + "\n}\n"

    def __getitem__(self, key: str) -> Any:
        field = {name for name in type(self).model_fields if key_of(name) == key}
        return self.to_dict(field or None)[key]

    def __iter__(self) -> Iterator[str]:  # type: ignore[override]  # of a mapping, as pydantic's own is of pairs
        return iter(self.to_dict())

    def __len__(self) -> int:
        return len(self.to_dict())

    def __or__(self, other: Mapping[str, Any]) -> Json:
        return {**self.to_dict(), **plain(dict(other))}

    def __eq__(self, other: object) -> bool:
        return self.to_dict() == plain(other) if isinstance(other, Mapping) else NotImplemented

    __hash__ = None  # type: ignore[assignment]  # as Python says that what compares by value has none


def frame_of(rows: list[Json]) -> pd.DataFrame:
    """Return rows as a data frame; raises UsageError where pandas is not installed."""
    try:
        import pandas as pd
    except ImportError:
        raise NotInstalled("a data frame needs pandas, which is not installed: pip install pandas.") from None
    return pd.DataFrame(rows, columns=columns(rows))


class _ArrayOf:
    """How pydantic reads and writes an array: lists of numbers, nested `depth` times, all of a depth of one length."""

    def __init__(self, dtype: type, depth: int, *, blanks: bool = False) -> None:
        self.dtype, self.depth, self.blanks = dtype, depth, blanks

    def _read(self, found: Any, checked: Any) -> np.ndarray:
        if isinstance(found, np.ndarray):
            return found
        cells = checked(found)
        if self.depth == 2 and len({len(row) for row in cells}) > 1:
            raise ValueError("the rows are not equally long")
        return np.array(cells, dtype=self.dtype)  # of None it makes nan

    def _written(self, array: np.ndarray) -> Any:
        blank = np.isnan(array) if array.dtype.kind == "f" else np.False_
        return (np.where(blank, np.array(None), array) if blank.any() else array).tolist()

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        cells: Any = self.dtype | None if self.blanks else self.dtype
        for _ in range(self.depth):
            cells = list[cells]
        written = core_schema.plain_serializer_function_ser_schema(self._written)
        return core_schema.no_info_wrap_validator_function(
            self._read, handler.generate_schema(cells), serialization=written
        )


Numbers = Annotated[np.ndarray, _ArrayOf(float, 1)]
Rows = Annotated[np.ndarray, _ArrayOf(float, 2)]
Counts = Annotated[np.ndarray, _ArrayOf(int, 1)]
Column = Annotated[np.ndarray, _ArrayOf(float, 1, blanks=True)]
BlankRows = Annotated[np.ndarray, _ArrayOf(float, 2, blanks=True)]
Vector = tuple[float, float, float]
