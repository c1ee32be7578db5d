"""TOML files: read so that an error points at its line, checked by schemas, written with every digit."""

from __future__ import annotations

import dataclasses
import difflib
import json
import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, TypeVar, get_args

from pydantic import BaseModel, ConfigDict, Field, ValidationError, create_model
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from deltacal_gen.errors import BadValue, FileFormat, FileNotReadable, InputError, MissingKey, UnknownKey


class Table(BaseModel):
    """A TOML table that knows its keys: another key is an error."""

    model_config = ConfigDict(extra="forbid", frozen=True)


Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
NonNegative = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0)]
Positive = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0)]
Vector = Annotated[tuple[Number, ...], Field(min_length=3, max_length=3)]
Raw = Mapping[str, object]  # a table whose keys are not checked yet
_Schema = TypeVar("_Schema", bound=BaseModel)


@dataclass(frozen=True)
class TomlFile:
    """A parsed TOML file that can point at its lines; `path` is None for tables that come from elsewhere."""

    path: Path | None
    text: str
    data: dict[str, object]

    @classmethod
    def read(cls, path: str | Path) -> TomlFile:
        """Read and parse; raises InputError for a file that is missing, not UTF-8 or not TOML."""
        return cls.parse(Path(path), read_text(Path(path)))

    @classmethod
    def parse(cls, path: Path, text: str) -> TomlFile:
        """Parse the text of a file; raises InputError where it is not TOML."""
        try:
            return cls(path, text, tomllib.loads(text))
        except (ValueError, RecursionError) as error:
            line = re.search(r" \(at line (\d+), column \d+\)", str(error))
            problem = str(error).replace(line[0], "") if line else str(error)
            raise FileFormat(
                f"this is not TOML: {problem}.",
                "Correct the line; strings need quotes and decimals a point.",
                file=path,
                line=int(line[1]) if line else None,
            ) from None

    def error(self, problem: str, remedy: str, *keys: str, family: type[InputError] = BadValue) -> InputError:
        """InputError at the line of a key, or of its table where the key itself is not there."""
        lines = _toml_lines(self.text)
        found = (lines[keys[:n]] for n in range(len(keys), 0, -1) if keys[:n] in lines)
        return family(problem, remedy, file=self.path, line=next(found, None))

    def check(self, schema: type[_Schema]) -> _Schema:
        """Return the data as `schema`; raise InputError for the first flaw."""
        try:
            return schema.model_validate(self.data)
        except ValidationError as error:
            # A misspelt key shows twice, as unknown and as missing: the unknown one can name the right key.
            raise self._explained(schema, min(error.errors(), key=lambda f: f["type"] != "extra_forbidden")) from None

    def _explained(self, schema: type[BaseModel], flaw: ErrorDetails) -> InputError:
        keys = [key for key in flaw["loc"] if isinstance(key, str)]
        *tables, key = keys or ["file"]
        where = f" in [{'.'.join(tables)}]" if tables else ""
        fields = _fields(schema, tables)
        if flaw["type"] == "extra_forbidden":
            close = nearest(key, fields)
            remedy = f"Did you mean '{close}'?" if close else f"Known here: {', '.join(fields) or 'nothing'}."
            if elsewhere := [name for name in schema.model_fields if key in _fields(schema, [name])]:
                remedy = f"It belongs to {' or '.join(f'[{name}]' for name in elsewhere)}."
            return self.error(f"'{key}'{where} is not known.", remedy, *keys, family=UnknownKey)
        if flaw["type"] == "missing":
            meaning = fields[key].description if key in fields else None
            what = f"'{key}'{where}" if tables else f"the table [{key}]"
            return self.error(
                f"{what} is missing.", f"Add it{f': {meaning}' if meaning else ''}.", *keys, family=MissingKey
            )
        entry = "".join(f", entry {n + 1}" for n in flaw["loc"] if isinstance(n, int))
        expected = _EXPECTED[flaw["type"]].format(**flaw.get("ctx", {})) if flaw["type"] in _EXPECTED else flaw["msg"]
        found = repr(flaw["input"])
        found = found if len(found) <= 60 else f"{found[:56]} ..."
        return self.error(f"'{key}'{where}{entry} is {found}: {expected}.", "Correct the value.", *keys)


def _fields(schema: type[BaseModel], tables: Iterable[str]) -> dict[str, FieldInfo]:
    """Fields of a nested table of the schema, by key; none of a table that takes any key."""
    for name in tables:
        annotation: Any = schema.model_fields[name].annotation
        nested = [part for part in (annotation, *get_args(annotation)) if hasattr(part, "model_fields")]
        if not nested:
            return {}
        schema = nested[0]
    return dict(schema.model_fields)


_EXPECTED = {  # by the type of a flaw, with what pydantic knows of it
    "float_type": "a number was expected",
    "finite_number": "a finite number was expected",
    "string_type": "a text in quotes was expected",
    "tuple_type": "a list was expected",
    "model_type": "a table was expected",
    "model_attributes_type": "a table was expected",
    "greater_than": "a number above 0 was expected",
    "greater_than_equal": "a number not below {ge:g} was expected",
    "less_than_equal": "a number not above {le:g} was expected",
    "too_short": "{min_length} entries were expected",
    "too_long": "{max_length} entries were expected",
    "literal_error": "{expected} was expected",
    "value_error": "{error}",
}


def table_of(value: type, number: Any, /, **others: Any) -> Any:
    """Return the table of which a value is made: the fields of its class, numbers of one kind but for `others`.

    A field whose default is None may be absent; one for which None is given is no key of the file.
    """
    kinds = {f.name: (others.get(f.name, number), f.default) for f in dataclasses.fields(value)}
    fields: dict[str, Any] = {
        name: (kind | None if default is None else kind, default)
        for name, (kind, default) in kinds.items()
        if kind is not None
    }
    return create_model(value.__name__, __base__=Table, **fields)


_HEADER = re.compile(r"""\s*\[\[?\s*([A-Za-z_"'][\w."' -]*?)\s*\]\]?\s*(?:#.*)?$""")
_KEY = re.compile(r"""\s*([\w."' -]+?)\s*=""")


def _toml_lines(text: str) -> dict[tuple[str, ...], int]:
    """Line of each table and key, by its path; the first line where there are several."""
    lines: dict[tuple[str, ...], int] = {}
    table: tuple[str, ...] = ()
    for number, line in enumerate(text.split("\n"), start=1):
        if header := _HEADER.match(line):
            path = table = _key_path(header[1])
        elif key := _KEY.match(line):
            path = table + _key_path(key[1])
        else:
            continue
        for n in range(1, len(path) + 1):
            lines.setdefault(path[:n], number)
    return lines


def _key_path(dotted: str) -> tuple[str, ...]:
    return tuple(part.strip(" \"'") for part in dotted.split("."))


def toml_text(tables: Mapping[str, Raw | Sequence[Raw]]) -> str:
    """TOML text of flat tables of strings, numbers and nested lists.

    ``"a.b"`` names a table within a table; a list of tables is written as ``[[name]]``.
    """
    each = (
        (f"[{name}]" if isinstance(keys, Mapping) else f"[[{name}]]", table)
        for name, keys in tables.items()
        for table in ([keys] if isinstance(keys, Mapping) else keys)
    )
    blocks = ([head, *(f"{key} = {_toml_value(v)}" for key, v in table.items())] for head, table in each)
    return "\n\n".join("\n".join(block) for block in blocks) + "\n"


def _toml_value(value: object) -> str:
    if isinstance(value, str):
        # JSON escapes what TOML wants escaped, but for DEL.
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        return f"{{{', '.join(f'{key} = {_toml_value(item)}' for key, item in value.items())}}}"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_toml_value(item) for item in value)}]"
    return repr(value)


def read_bytes(path: Path) -> bytes:
    """Return what a file holds; raise InputError where it cannot be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise FileNotReadable(
            f"the file cannot be read: {error.strerror}.", "Check the path and the permissions.", file=path
        ) from None


def read_text(path: Path) -> str:
    r"""Return the text of a UTF-8 file, without its byte order mark, lines ended by ``\n``; raise InputError."""
    data = read_bytes(path)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise FileFormat(
            f"byte {error.start + 1} is not UTF-8 text.",
            "Save the file as text in UTF-8.",
            file=path,
            line=data[: error.start].count(b"\n") + 1,
        ) from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def nearest(name: str, known: Iterable[str], cutoff: float = 0.6) -> str | None:
    """Return the known name that `name` is probably a misspelling of, or None."""
    return next(iter(difflib.get_close_matches(name, list(known), n=1, cutoff=cutoff)), None)
