"""JSON Schema as far as the published schemas use it, checked without the library that makes them."""

from __future__ import annotations

import json
import math
from importlib import resources
from typing import Any

IS: dict[str, Any] = {
    "object": lambda v: isinstance(v, dict),
    "array": lambda v: isinstance(v, list),
    "string": lambda v: isinstance(v, str),
    "boolean": lambda v: isinstance(v, bool),
    "null": lambda v: v is None,
    "integer": lambda v: isinstance(v, int) and not isinstance(v, bool),
    "number": lambda v: isinstance(v, int | float) and not isinstance(v, bool) and math.isfinite(v),
}
KNOWN = {"$schema", "$id", "$defs", "description", "type", "const", "enum", "properties", "required", "items"}
KNOWN |= {"additionalProperties", "prefixItems", "minItems", "maxItems", "anyOf", "$ref"}


def committed(schema: str) -> dict[str, Any]:
    """Return the published schema of the answers with a `schema`."""
    name = schema.replace("/", ".") + ".json"
    found: dict[str, Any] = json.loads((resources.files("deltacal_gen") / "results" / "schemas" / name).read_text())
    return found


def flaws(value: Any, schema: dict[str, Any], top: dict[str, Any] | None = None, at: str = "") -> list[str]:
    """Return in words where a value is not as a schema has it."""
    top = schema if top is None else top
    assert schema.keys() <= KNOWN, f"{at}: what does {schema.keys() - KNOWN} say?"
    if "$ref" in schema:
        return flaws(value, top["$defs"][schema["$ref"].removeprefix("#/$defs/")], top, at)
    if "anyOf" in schema:
        each = [flaws(value, part, top, at) for part in schema["anyOf"]]
        return [] if [] in each else min(each, key=len)
    if "type" in schema and not IS[schema["type"]](value):
        return [f"{at}: {value!r} is no {schema['type']}"]
    if ("const" in schema and value != schema["const"]) or ("enum" in schema and value not in schema["enum"]):
        return [f"{at}: {value!r} is none of {schema.get('enum', schema.get('const'))}"]
    return [*_of_object(value, schema, top, at), *_of_array(value, schema, top, at)]


def _of_object(value: Any, schema: dict[str, Any], top: dict[str, Any], at: str) -> list[str]:
    if not isinstance(value, dict):
        return []
    known, more = schema.get("properties", {}), schema.get("additionalProperties", True)
    found = [f"{at}: {key} is missing" for key in schema.get("required", ()) if key not in value]
    for key, part in value.items():
        if key in known or isinstance(more, dict):
            found += flaws(part, known.get(key, more), top, f"{at}.{key}")
        elif not more:
            found.append(f"{at}: {key} is not known")
    return found


def _of_array(value: Any, schema: dict[str, Any], top: dict[str, Any], at: str) -> list[str]:
    if not isinstance(value, list):
        return []
    first = schema.get("prefixItems", [])
    if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", math.inf):
        return [f"{at}: {len(value)} items"]
    parts = [*first, *[schema.get("items", {})] * (len(value) - len(first))]
    return [w for i, (v, part) in enumerate(zip(value, parts, strict=True)) for w in flaws(v, part, top, f"{at}[{i}]")]
