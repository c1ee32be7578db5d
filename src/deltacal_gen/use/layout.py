"""Files for a controller as text: the templates of the folder ``layouts``, and numbers as C writes them."""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Sequence
from typing import Any

import jinja2

from deltacal_gen.machine.registry import Array
from deltacal_gen.use.spans import stated


@functools.cache
def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("deltacal_gen.use", "layouts"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters |= {"numbers": c_numbers, "wrapped": wrapped, "stated": _stated, "toml": _toml}
    return environment


def laid_out(template: str, **content: Any) -> str:
    """Return the text of a template: ``command.c``."""
    return _environment().get_template(f"{template}.jinja").render(**content)


def _stated(measured: float) -> str:
    return f"{stated(measured):.1e}"


def _toml(value: Any) -> str:
    return json.dumps(value).replace("\x7f", "\\u007f")


def plain(text: str) -> str:
    """Return `text` without anything that means something in a C comment."""
    return re.sub(r"[^\w .,:;()+-]", "_", text)


def c_numbers(values: Array | Sequence[float]) -> str:
    """Return numbers as C writes them, to the last digit."""
    return ", ".join(repr(float(v)) for v in values)


def wrapped(values: Array, per_line: int = 5) -> str:
    """Return a row of numbers as C writes them, a few in a line."""
    return ",\n      ".join(c_numbers(values[j : j + per_line]) for j in range(0, len(values), per_line))
