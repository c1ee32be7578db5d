"""How large rooms may be: no module above 600 lines, no function above 60, its docstring not counted.

No line is above 120 characters, in Python and in what is written as kernels; pages break where their paragraphs do.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from tests.benchmarks.lines import functions

ROOT = Path(__file__).resolve().parents[1]
PARTS = ("src/deltacal_gen", "derive", "tests")
MODULE, FUNCTION, LINE = 600, 60, 120
SWITCHED_OFF = re.compile(r"#\s*(fmt|yapf|isort|ruff):\s*(off|skip|disable)\b")


def lines() -> Iterator[tuple[str, str]]:
    """Yield where each line of code stands, templates of kernels among it, and its text."""
    python = (path for part in PARTS for path in (ROOT / part).rglob("*.py"))
    for path in (*python, *(ROOT / "templates").rglob("*.jinja")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            yield f"{path.relative_to(ROOT).as_posix()}:{number}", line


def test_no_module_is_larger_than_a_reader_holds() -> None:
    sizes = {
        path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8").count("\n")
        for part in PARTS
        for path in (ROOT / part).rglob("*.py")
    }
    assert {name: n for name, n in sizes.items() if n > MODULE} == {}, "divide it by what it does"


def test_no_function_is_longer_than_a_page() -> None:
    sizes = {
        f"{path.relative_to(ROOT).as_posix()}:{name}": n
        for part in PARTS
        for path in (ROOT / part).rglob("*.py")
        for name, _, n in functions(path.read_text(encoding="utf-8"))
        if n > FUNCTION
    }
    assert sizes == {}, "name its steps"


def test_no_line_is_wider_than_the_page() -> None:
    assert [where for where, line in lines() if len(line) > LINE] == [], "break it"


def test_no_formatter_is_switched_off() -> None:
    assert [where for where, line in lines() if SWITCHED_OFF.search(line)] == [], "let data be laid out as data"


def test_no_template_edits_what_was_written() -> None:
    """Text between mathematics and files is made right, not put right: printers and macros are told how to write it."""
    assert [where for where, line in lines() if where.startswith("templates/") and "replace(" in line] == []
