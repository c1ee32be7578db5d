"""How large rooms may be, that no way leads from one through others back to it, and that no test needs another.

No module above 600 lines, no function above 60, its docstring not counted. Imports inside functions, which save time at
the start, and those for type checkers alone are ways like others. No line is above 120 characters, in Python, in
what is written as kernels, and in what pages are made of.
"""

from __future__ import annotations

import ast
import graphlib
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from tests.benchmarks.lines import functions

ROOT = Path(__file__).resolve().parents[2]
PARTS = ("src/deltacal_gen", "derive", "tests")
MODULE, FUNCTION, LINE = 600, 60, 120
WRITTEN = ("*.py", "*.jinja", "*.css", "*.js")
PACKAGE = "src/deltacal_gen"
APART = {"support", "benchmarks", "claims", "frozen", "proof"}  # folders of tests that hold more than tests
SWITCHED_OFF = re.compile(r"#\s*(fmt|yapf|isort|ruff):\s*(off|skip|disable)\b")


def lines() -> Iterator[tuple[str, str]]:
    """Yield where each line of code stands, templates and styles among it, and its text."""
    for path in (path for part in (*PARTS, "templates") for kind in WRITTEN for path in (ROOT / part).rglob(kind)):
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


def _imported(tree: ast.AST, known: Mapping[str, object]) -> set[str]:
    """Return the modules among those known that a text imports, wherever in it: of a package what is taken of it."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            named = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, "modules are named in full"
            named = [f"{node.module}.{alias.name}" for alias in node.names]
        else:
            continue
        for name in named:
            while name and name not in known:
                name = name.rpartition(".")[0]
            found |= {name} - {""}
    return found


def _ways(texts: Mapping[str, str]) -> dict[str, set[str]]:
    """Return which modules each imports, by their names and their texts."""
    return {name: _imported(ast.parse(text), texts) - {name} for name, text in texts.items()}


def _circle(ways: Mapping[str, set[str]]) -> list[str]:
    """Return a way from a module back to it; none where there is none."""
    try:
        graphlib.TopologicalSorter(ways).prepare()
    except graphlib.CycleError as error:
        return [*reversed(error.args[1])]
    return []


def test_no_import_leads_back() -> None:
    texts = {}
    for path in (ROOT / PACKAGE).rglob("*.py"):
        parts = path.relative_to(ROOT / PACKAGE).with_suffix("").parts
        name = ".".join(("deltacal_gen", *(parts[:-1] if parts[-1] == "__init__" else parts)))
        texts[name] = path.read_text(encoding="utf-8")
    ways = _ways(texts)
    assert sum(map(len, ways.values())) > 1000  # they were read
    assert _circle(ways) == [], "what both need belongs below them"


def test_no_test_is_built_on_another() -> None:
    """What tests share stands in ``tests/support``, so that a part of them can be read, run, and taken out alone."""
    files = [*(ROOT / "tests").rglob("*.py")]
    assert sum(map(_is_test, files)) > 100  # they were found
    built = {str(path): _words(path) & {other.stem for other in files if _is_test(other)} for path in files}
    assert {name: on for name, on in built.items() if on} == {}, "move what both need to tests/support"
    stray = [path.name for path in files if not _is_test(path) and path.parent.name not in APART]
    assert stray == [], "no test: it belongs in tests/support"


def _is_test(path: Path) -> bool:
    return path.stem.startswith("test_") or path.stem == "conftest"


def _words(path: Path) -> set[str]:
    """Return the names in what a module imports: of packages, of modules, of what is taken of them."""
    nodes = [*ast.walk(ast.parse(path.read_text(encoding="utf-8")))]
    named = [n.module or "" for n in nodes if isinstance(n, ast.ImportFrom)]
    named += [alias.name for n in nodes if isinstance(n, ast.Import | ast.ImportFrom) for alias in n.names]
    return {word for name in named for word in name.split(".")}


def _by_name(path: Path) -> Iterator[str]:
    """Yield what a module imports of the package by its name in a text, up to where the text is filled in."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call) and ast.unparse(node.func).endswith("import_module"):
            text = next((n.value for n in ast.walk(node.args[0]) if isinstance(n, ast.Constant)), "")
            yield from [text] if str(text).startswith("deltacal_gen.") else []


def test_no_import_hides_in_a_text() -> None:
    """Walls see no import by name: a wing may look up its own rooms so; the package all, in its stub."""
    found = {path.relative_to(ROOT / PACKAGE).as_posix(): [*_by_name(path)] for path in (ROOT / PACKAGE).rglob("*.py")}
    assert len(found) > 200  # they were read
    hidden = {where: named for where, named in found.items() for n in named if n.split(".")[1] != where.split("/")[0]}
    assert hidden == {}, "give it as an argument, or move it below"


def test_a_way_back_is_found_wherever_it_begins() -> None:
    inner = "def f() -> None:\n    from a import b\n"
    typed = "from typing import TYPE_CHECKING\n\nif TYPE_CHECKING:\n    from a.b import C\n"
    for text in (inner, typed, "import a.b as b\n", "from a.b import c\n"):
        texts = {"a": "", "a.b": "from a.c import x\n", "a.c": text}
        assert set(_circle(_ways(texts))) == {"a.b", "a.c"}
        assert _circle(_ways(texts | {"a.c": "import os\nfrom a import x\n"})) == []
