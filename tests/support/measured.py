"""Write the manual's measured tables: the rows, and what made them. No date: equal figures are equal files.

Every command of ``tests`` that measures something takes ``--measured`` and calls `write`.
"""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Sequence
from importlib import metadata
from pathlib import Path

from deltacal_gen.pages import manual

SCHEMA = "deltacal.measured/1"
PACKAGES = ("deltacal_gen", "numpy", "scipy", "numba")


def write(
    name: str,
    columns: Sequence[str],
    rows: Sequence[Sequence[str]],
    command: str,
    *,
    packages: Sequence[str] = PACKAGES,
    note: str = "",
    folder: Path | None = None,
) -> Path:
    """Write a table as ``manual/measured/NAME.json``, a line to each row; return its path.

    Parameters
    ----------
    command : str
        What was typed.
    packages : sequence of str
        Whose versions are told, beside Python's.
    note : str
        What else a reader must know of the run: how many cases, which files.
    folder : path, optional
        Elsewhere than in the package.
    """
    table = {
        "schema": SCHEMA,
        "command": command,
        "versions": {"Python": platform.python_version(), **{p: metadata.version(p) for p in packages}},
        "processor": processor(),
        "note": note,
        "columns": list(columns),
    }
    lines = ",\n".join(f"  {json.dumps(list(row), ensure_ascii=False)}" for row in rows)
    head = json.dumps(table, ensure_ascii=False, indent=1).removesuffix("\n}")
    path = (folder or manual.folder() / "measured") / f"{name}.json"
    path.write_text(f'{head},\n "rows": [\n{lines}\n ]\n}}\n', encoding="utf-8")
    return path


def processor() -> str:
    """Return what computes: the processor by its own name, and how many of its cores."""
    told = Path("/proc/cpuinfo")
    lines = told.read_text().splitlines() if told.exists() else []
    named = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    return f"{os.cpu_count()} cores of {named or platform.processor() or platform.machine()}"
