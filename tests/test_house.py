"""How large rooms may be: no module above 600 lines, no function above 60, its docstring not counted."""

from __future__ import annotations

from pathlib import Path

from tests.benchmarks.lines import functions

ROOT = Path(__file__).resolve().parents[1]
PARTS = ("src/deltacal_gen", "derive", "tests")
MODULE, FUNCTION = 600, 60


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
