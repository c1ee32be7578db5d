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
from typing import Any

from pydantic.json_schema import GenerateJsonSchema

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
    tops = [top.model_json_schema(schema_generator=Described) for top in types_of(schema)]
    parts = {name: part for top in tops for name, part in top.pop("$defs", {}).items()}
    whole = tops[0] if len(tops) == 1 else {"anyOf": tops}
    return {"$schema": DRAFT, "$id": schema, **whole, **({"$defs": dict(sorted(parts.items()))} if parts else {})}


class Described(GenerateJsonSchema):
    """JSON schemas with the words of types and fields; without titles, defaults, and nulls that are left out."""

    def field_title_should_be_set(self, schema: Any) -> bool:
        """No field has a title beside its key."""
        return False

    def default_schema(self, schema: Any) -> Any:
        """Return the schema of a field with a default as it is written: where that is null, not at all."""
        inner = schema["schema"]
        return self.generate_inner(inner["schema"] if schema.get("default", "") is None else inner)

    def model_schema(self, schema: Any) -> Any:
        """Return the schema of a type: under all its keys what stands below its fields, its own or inherited ones."""
        made, kind = super().model_schema(schema), schema["cls"]
        said = {
            name: words for of in reversed(kind.__mro__) if issubclass(of, Value) for name, words in _said(of).items()
        }
        keys = {key: (name, keys_of(name)[0]) for name in kind.model_fields for key in keys_of(name)}
        found = made["properties"]
        out = {
            "description": made["description"],
            **{key: value for key, value in made.items() if key not in ("description", "title")},
            "properties": {key: found[first] | said.get(name, {}) for key, (name, first) in keys.items()},
        }
        if "schema" in keys:
            out["required"] = [key for key in keys if key in ("schema", *out["required"])]
        return out


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
