"""How large rooms may be: no module above 600 lines, no function above 60, its docstring not counted.

A function that is larger is listed with its size, which may shrink and never grow; what is listed and small enough is
an error.
"""

from __future__ import annotations

from pathlib import Path

from tests.benchmarks.lines import functions

ROOT = Path(__file__).resolve().parents[1]
PARTS = ("src/deltacal_gen", "derive", "tests")
MODULE, FUNCTION = 600, 60
FUNCTIONS = {
    "src/deltacal_gen/diagnosis/diagnosis.py:diagnose": 69,
    "src/deltacal_gen/identification/identification.py:identify": 72,
}


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
    assert {name: n for name, n in sizes.items() if n > FUNCTIONS.get(name, FUNCTION)} == {}, "name its steps"
    assert [name for name in FUNCTIONS if name not in sizes] == [], "short enough: take it off the list"
