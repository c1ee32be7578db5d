"""Answers as values: frozen, their fields, in order, the keys of their JSON.

Three rules say all of the form:

- a field without a default is always written; ``None`` in it is JSON's null;
- a field whose default is ``None`` is left out of the JSON while it is ``None``;
- a name that is a word of Python's ends with an underscore, which the key has not.

Arrays hold what comes in bulk; NaN in them is a blank cell, null in JSON. All other sequences are tuples.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from enum import Enum
from functools import cache
from types import NoneType
from typing import TYPE_CHECKING, Annotated, Any, Self, Union, dataclass_transform, get_args, get_type_hints

import numpy as np

from deltacal_gen.results import shown
from deltacal_gen.results.document import Document, Text, as_html, as_text, table_of

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

Json = dict[str, Any]


def key_of(field: str) -> str:
    """Return the key under which a field stands in JSON."""
    return field.removesuffix("_")


def plain(value: Any) -> Any:
    """Return a value as `json` reads it back: dictionaries, lists, numbers, text."""
    if isinstance(value, Value):
        return value.to_dict()
    if isinstance(value, np.ndarray):
        blank = np.isnan(value) if value.dtype.kind == "f" else np.False_
        whole: list[Any] = (np.where(blank, np.array(None), value) if blank.any() else value).tolist()
        return whole
    if isinstance(value, tuple | list):
        return [plain(v) for v in value]
    if isinstance(value, Mapping):
        return {k: plain(v) for k, v in value.items()}
    return value.value if isinstance(value, Enum) else value


FIGURE = re.compile(r"(\w*rms|sigma|worst|error|open|mean|expanded|machine)_mm")  # keys of what readings are off


def in_unit(found: Any, unit: str, length: float) -> Any:
    """Return JSON in which each figure of a reading stands in the unit of its kind too, beside its size in mm.

    Parameters
    ----------
    unit : str
        Of files: px, deg.
    length : float
        What it is at the platform [mm].
    """
    if isinstance(found, list):
        return [in_unit(v, unit, length) for v in found]
    if not isinstance(found, dict):
        return found
    out: Json = {}
    for key, value in found.items():
        out[key] = in_unit(value, unit, length)
        if FIGURE.fullmatch(key) and value is not None:
            each = {k: v / length for k, v in value.items()} if isinstance(value, dict) else value / length
            out[key.removesuffix("mm") + unit] = each
    return out


def shown_in(answer: Any) -> tuple[str, float]:
    """Return the unit in which an answer's figures are shown, that of its readings, and what it is in mm."""
    unit, length = getattr(answer, "unit", None), getattr(answer, "unit_mm", None)
    return (unit, length) if unit and length else ("mm", 1.0)


@dataclass_transform(kw_only_default=True, frozen_default=True)
class Value:
    """Part of an answer: to type checkers a frozen dataclass, given by keywords. Two are equal where their JSON is.

    `dataclasses.dataclass` compiles a constructor for each class: 25 ms of every start for those of this package.
    """

    _fields: tuple[str, ...] = ()
    _defaults: Mapping[str, Any] = {}
    _closed = False  # whether a key that is not known is an error

    def __init_subclass__(cls, *, closed: bool = False) -> None:
        own = [name for name, of in cls.__annotations__.items() if not str(of).startswith("ClassVar")]
        cls._fields, cls._closed = (*cls._fields, *own), closed
        cls._defaults = {**cls._defaults, **{name: vars(cls)[name] for name in own if name in vars(cls)}}

    def __init__(self, **given: Any) -> None:
        known = {name: given.pop(name) if name in given else self._default(name) for name in self._fields}
        if given:
            raise TypeError(f"{type(self).__name__} has no field '{next(iter(given))}'")
        vars(self).update(known)

    def _default(self, name: str) -> Any:
        if name not in self._defaults:
            raise TypeError(f"{type(self).__name__} needs '{name}'")
        return self._defaults[name]

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen; `replace` gives another one")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen")

    def replace(self, **changes: Any) -> Self:
        """Return the same with other values in some fields."""
        return type(self)(**{name: getattr(self, name) for name in self._fields} | changes)

    def written(self) -> Iterator[tuple[str, Any]]:
        """Yield key and value of all that is written, in the order of the file."""
        for name in self._fields:
            value = getattr(self, name)
            if value is not None or self._defaults.get(name, self) is not None:
                yield key_of(name), value

    def to_dict(self) -> Json:
        """Return the JSON as plain dictionaries, lists, numbers and text, the keys in the order of the file."""
        return {key: plain(value) for key, value in self.written()}

    def __eq__(self, other: object) -> bool:
        return self.to_dict() == other.to_dict() if isinstance(other, Value) else NotImplemented

    __hash__ = None  # type: ignore[assignment]  # as Python says that what compares by value has none

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in self._fields)})"

    @classmethod
    @cache  # annotations are read anew, word by word, at every call
    def types(cls) -> dict[str, Any]:
        """Return what each field holds where it is written."""
        hints = get_type_hints(cls, include_extras=True)
        for name, value in cls._defaults.items():
            if value is None:
                written = tuple(part for part in get_args(hints[name]) if part is not NoneType)
                hints[name] = Union[written]  # noqa: UP007  # of parts that are known when this runs
        return {name: hints[name] for name in cls._fields}

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: Any) -> Any:
        """Say to pydantic, which is loaded where a file is read or a schema is made, what the JSON holds."""
        from pydantic_core import core_schema

        table = core_schema.typed_dict_schema(
            {
                key_of(name): core_schema.typed_dict_field(
                    handler.generate_schema(hint), required=name not in cls._defaults or name == "schema"
                )
                for name, hint in cls.types().items()
            },
            extra_behavior="forbid" if cls._closed else "ignore",
            config=core_schema.CoreConfig(strict=True, allow_inf_nan=False),
        )
        return core_schema.no_info_after_validator_function(cls._read, table, ref=f"{cls.__module__}.{cls.__name__}")

    @classmethod
    def _read(cls, found: Json) -> Self:
        return cls(**{name: found[key_of(name)] for name in cls._fields if key_of(name) in found})


class Answer(Value, Mapping[str, Any]):
    """What a command answers: attributes for programs, and by key the JSON itself, as a plain part of it.

    ``answer["effects"][0]["name"]`` is what the file says under these keys; ``answer | {...}`` is the JSON as a
    dictionary with other values. Where readings have another unit than mm, `unit` names it, `unit_mm` says what it is
    at the platform, and the file gives each of their figures in either.
    """

    def written(self) -> Iterator[tuple[str, Any]]:
        """Yield key and value of all that is written, in the order of the file."""
        unit, length = getattr(self, "unit", None), getattr(self, "unit_mm", None)
        if unit is None or length is None:
            yield from super().written()
        else:
            yield from in_unit({key: plain(value) for key, value in super().written()}, unit, length).items()

    @property
    def headline(self) -> str:
        """The answer in one line."""
        return f"{len(self.table())} rows" if self.table() else ", ".join(key for key, _ in self.written())

    def table(self) -> tuple[Value, ...]:
        """Return the rows that a person looks at first; none where there is no such table."""
        return ()

    def to_dataframe(self) -> pd.DataFrame:
        """Return the table as a data frame, a column to each key; needs pandas."""
        return shown.frame([row.to_dict() for row in self.table()])

    def plot(self) -> Figure:
        """Return a picture of the answer, which a notebook shows; ``answer.plot().savefig("it.svg")`` writes it."""
        return shown.picture(self)

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
        for known, value in self.written():
            if known == key:
                return plain(value)
        raise KeyError(key)

    def __iter__(self) -> Iterator[str]:
        return (key for key, _ in self.written())

    def __len__(self) -> int:
        return sum(1 for _ in self.written())

    def __or__(self, other: Mapping[str, Any]) -> Json:
        return {**self.to_dict(), **plain(dict(other))}

    def __eq__(self, other: object) -> bool:
        return self.to_dict() == plain(other) if isinstance(other, Mapping) else NotImplemented

    __hash__ = None  # type: ignore[assignment]  # as Python says that what compares by value has none


class _ArrayOf:
    """How pydantic reads an array: lists of numbers, nested `depth` times, all of a depth of one length."""

    def __init__(self, dtype: type, depth: int, *, blanks: bool = False) -> None:
        self.dtype, self.depth, self.blanks = dtype, depth, blanks

    def _read(self, cells: list[Any]) -> np.ndarray:
        if self.depth == 2 and len({len(row) for row in cells}) > 1:
            raise ValueError("the rows are not equally long")
        return np.array([np.nan if v is None else v for v in cells] if self.blanks else cells, dtype=self.dtype)

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        from pydantic_core import core_schema

        cell: Any = core_schema.int_schema() if self.dtype is int else core_schema.float_schema()
        cells: Any = core_schema.list_schema(core_schema.nullable_schema(cell) if self.blanks else cell)
        if self.depth == 2:
            cells = core_schema.list_schema(cells)
        return core_schema.no_info_after_validator_function(self._read, cells)


Numbers = Annotated[np.ndarray, _ArrayOf(float, 1)]
Rows = Annotated[np.ndarray, _ArrayOf(float, 2)]
Counts = Annotated[np.ndarray, _ArrayOf(int, 1)]
Column = Annotated[np.ndarray, _ArrayOf(float, 1, blanks=True)]
Vector = tuple[float, float, float]
