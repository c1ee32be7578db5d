"""JSON schemas of all answers, made of their types: ``python -m deltacal_gen.results.published [--check]``.

They are committed in ``schemas/`` and shipped, so that a program in another language can check what it reads. A key
that a schema does not know is no error: a later version may say more.
"""

from __future__ import annotations

import ast
import functools
import inspect
import json
import sys
from pathlib import Path
from typing import Any, get_args

from deltacal_gen.results.base import Value, keys_of
from deltacal_gen.results.reader import ANSWERS, types_of

FOLDER = Path(__file__).parent / "schemas"
DRAFT = "https://json-schema.org/draft/2020-12/schema"


def file_of(schema: str) -> str:
    """Return the name of the file that holds a schema."""
    return schema.replace("/", ".") + ".json"


def published() -> dict[str, str]:
    """Return the text of all schemas, by the names of their files."""
    return {file_of(s): json.dumps(schema_of(s), indent=1, ensure_ascii=False) + "\n" for s in ANSWERS}


def schema_of(schema: str) -> dict[str, Any]:
    """Return the JSON schema of the answers with a `schema`, described as their types are."""
    tops: list[dict[str, Any]] = []
    every: dict[str, Any] = {}
    for top in types_of(schema):
        made = top.model_json_schema()
        parts = {**made.pop("$defs", {}), top.__name__: made}
        described = {name: _described(parts[name], kind) for name, kind in kinds_in(top).items() if name in parts}
        tops.append(described.pop(top.__name__))
        every |= {name: described.get(name, _untitled(part)) for name, part in parts.items() if name != top.__name__}
    whole = tops[0] if len(tops) == 1 else {"anyOf": tops}
    return {"$schema": DRAFT, "$id": schema, **whole, **({"$defs": dict(sorted(every.items()))} if every else {})}


def kinds_in(top: Any) -> dict[str, type]:
    """Return all types that a type is made of, by their names."""
    if not isinstance(top, type):
        return {name: kind for part in get_args(top) for name, kind in kinds_in(part).items()}
    found: dict[str, type] = {top.__name__: top}
    for field in top.model_fields.values() if issubclass(top, Value) else ():
        found |= kinds_in(field.annotation)
    return found


def _described(part: dict[str, Any], kind: type) -> dict[str, Any]:
    """Return a part of a schema with the words of its type and of its fields, without pydantic's titles."""
    told = {"description": inspect.cleandoc(kind.__doc__ or "")}
    said = {name: words for of in reversed(kind.__mro__) if issubclass(of, Value) for name, words in _said(of).items()}
    keys: dict[str, Any] = {}
    for name in kind.model_fields if issubclass(kind, Value) else ():
        choices = keys_of(name)
        keys |= {key: _untitled(_present(part["properties"][choices[0]])) | said.get(name, {}) for key in choices}
    out = told | _untitled(part) | ({"properties": keys} if keys else {})
    if "schema" in keys:
        out["required"] = [name for name in keys if name in ("schema", *out["required"])]
    return out


def _present(key: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of a field whose default is null as it is written, which it is where it is not null."""
    if "default" not in key or key["default"] is not None:
        return key
    some = [part for part in key["anyOf"] if part != {"type": "null"}]
    return some[0] if len(some) == 1 else {"anyOf": some}


def _untitled(part: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in part.items() if key not in ("title", "description", "default")}


@functools.cache
def _said(kind: type) -> dict[str, dict[str, str]]:
    """Return what stands as text below the fields of a type, by their names."""
    body = ast.parse(inspect.getsource(kind)).body[0]
    assert isinstance(body, ast.ClassDef)
    found = {}
    for field, below in zip(body.body, body.body[1:], strict=False):
        match field, below:
            case ast.AnnAssign(target=ast.Name(id=name)), ast.Expr(value=ast.Constant(value=str(text))):
                found[name] = {"description": inspect.cleandoc(text)}
    return found


def main(arguments: list[str]) -> int:
    """Write the schemas, or with ``--check`` say which of the committed ones differ."""
    fresh = published()
    known = {p.name: p.read_text(encoding="utf-8") for p in FOLDER.glob("*.json")}
    off = sorted(name for name in fresh.keys() | known.keys() if fresh.get(name) != known.get(name))
    for name in off:
        print(name)
        if "--check" in arguments:
            continue
        if name in fresh:
            (FOLDER / name).write_text(fresh[name], encoding="utf-8")
        else:
            (FOLDER / name).unlink()
    return int(bool(off) and "--check" in arguments)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
