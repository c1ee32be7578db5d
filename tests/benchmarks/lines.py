"""How large the code is: ``python -m tests.benchmarks.lines [TREE] [--lower]``.

Lines of code are those that hold code: no docstring, no comment, no blank line; of all that is no Python, lines that
are not blank count. Tokens are counted beside lines, so that a line which holds more is no saving. ``--lower`` writes
into `tests/house/budget.csv` what a wing has become, where that is less than the budget allows; a budget is raised by
hand, in the commit that says why.
"""

from __future__ import annotations

import argparse
import ast
import csv
import io
import sys
import tokenize
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUDGET = ROOT / "tests" / "house" / "budget.csv"
PACKAGE = Path("src/deltacal_gen")
PARTS = (str(PACKAGE), "derive", "tests")
DATA = (".jinja", ".toml", ".json", ".pyi")  # what code can be moved to
TOP = "package"  # the modules that stand in no wing
SHOWN = 12
QUIET = {
    tokenize.COMMENT,
    tokenize.NL,
    tokenize.NEWLINE,
    tokenize.INDENT,
    tokenize.DEDENT,
    tokenize.ENDMARKER,
    tokenize.ENCODING,
}


@dataclass(frozen=True)
class Size:
    """How large a wing is: lines of code, their tokens, and lines of templates and data within it."""

    lines: int = 0
    tokens: int = 0
    data: int = 0

    def __add__(self, other: Size) -> Size:
        return Size(self.lines + other.lines, self.tokens + other.tokens, self.data + other.data)


def docstring_lines(text: str) -> set[int]:
    """Return the lines of a module that hold docstrings."""
    found: set[int] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef) and node.body:
            first = node.body[0]
            if (
                isinstance(first, ast.Expr)
                and isinstance(first.value, ast.Constant)
                and isinstance(first.value.value, str)
            ):
                found |= set(range(first.lineno, (first.end_lineno or first.lineno) + 1))
    return found


def code_size(text: str) -> Size:
    """Return how many lines of a module hold code, and how many tokens stand in them."""
    documented = docstring_lines(text)
    held: set[int] = set()
    tokens = 0
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in QUIET and token.start[0] not in documented:
            held |= set(range(token.start[0], token.end[0] + 1))
            tokens += 1
    return Size(lines=len(held), tokens=tokens)


def code_lines(text: str) -> int:
    """Return how many lines of a module hold code."""
    return code_size(text).lines


def data_size(path: Path) -> Size:
    """Return how many lines of a template or a data file are not blank."""
    return Size(data=sum(bool(line.strip()) for line in path.read_text(encoding="utf-8").splitlines()))


def wing_sizes(tree: Path = ROOT) -> dict[str, Size]:
    """Return how large each wing of the runtime, the derivation and the templates are, by name."""
    sizes: defaultdict[str, Size] = defaultdict(Size)
    for path in sorted((tree / PACKAGE).rglob("*")):
        inside = path.relative_to(tree / PACKAGE).parts
        wing = f"src/{inside[0] if len(inside) > 1 else TOP}"
        if path.suffix == ".py":
            sizes[wing] += code_size(path.read_text(encoding="utf-8"))
        elif path.suffix in DATA:
            sizes[wing] += data_size(path)
    for path in sorted((tree / "derive").rglob("*.py")):
        sizes["derive"] += code_size(path.read_text(encoding="utf-8"))
    for path in sorted(p for part in ("derive", "templates") for p in (tree / part).rglob("*") if p.suffix in DATA):
        sizes[path.relative_to(tree).parts[0]] += data_size(path)
    return dict(sizes)


def read_budget() -> dict[str, Size]:
    """Return what each wing may be at most."""
    with BUDGET.open(encoding="utf-8", newline="") as file:
        return {
            row["wing"]: Size(int(row["lines"]), int(row["tokens"]), int(row["data"])) for row in csv.DictReader(file)
        }


def lower_budget(sizes: dict[str, Size]) -> list[str]:
    """Write the smaller of what each wing was allowed and what it is, and return what changed."""
    known = read_budget()
    kept = {wing: known.get(wing, size) for wing, size in sorted(sizes.items())}
    new = {
        wing: Size(min(old.lines, is_.lines), min(old.tokens, is_.tokens), min(old.data, is_.data))
        for wing, old in kept.items()
        for is_ in (sizes[wing],)
    }
    rows = [f"{wing},{size.lines},{size.tokens},{size.data}" for wing, size in new.items()]
    BUDGET.write_text("\n".join(["wing,lines,tokens,data", *rows]) + "\n", encoding="utf-8")
    return [f"{w}: {known[w].lines} -> {s.lines}" for w, s in new.items() if w in known and known[w] != s]


def functions(text: str) -> Iterator[tuple[str, int, int]]:
    """Yield name, line and length of every function of a module; a docstring is not counted."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            told = ast.get_docstring(node, clean=False)
            first = node.body[0]
            docstring = (first.end_lineno or 0) - first.lineno + 1 if told is not None else 0
            yield node.name, node.lineno, (node.end_lineno or node.lineno) - node.lineno + 1 - docstring


def main() -> int:
    """Print the counts of a tree, or lower its budget."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("tree", type=Path, nargs="?", default=ROOT)
    parser.add_argument("--lower", action="store_true", help="write smaller budgets for wings that fell below theirs")
    given = parser.parse_args()
    sizes = wing_sizes(given.tree)
    if given.lower:
        print(*lower_budget(sizes), sep="\n")
        return 0
    print(f"{'':22} {'lines':>7} {'tokens':>8} {'data':>7}")
    for wing, size in sorted(sizes.items(), key=lambda item: -item[1].lines):
        print(f"{wing:22} {size.lines:7} {size.tokens:8} {size.data:7}")
    runtime = sum((size for wing, size in sizes.items() if wing.startswith("src/")), Size())
    print(f"{'src':22} {runtime.lines:7} {runtime.tokens:8} {runtime.data:7}")
    _print_longest(given.tree)
    return 0


def _print_longest(tree: Path) -> None:
    """Print the assertions of the tests, and the longest modules (all lines) and functions (without docstring)."""
    modules: list[tuple[int, str]] = []
    long: list[tuple[int, str]] = []
    for path in sorted(path for part in PARTS[:2] for path in (tree / part).rglob("*.py")):
        text, place = path.read_text(encoding="utf-8"), path.relative_to(tree)
        modules.append((len(text.splitlines()), str(place)))
        long += [(size, f"{place}:{line} {name}") for name, line, size in functions(text)]
    asserts = sum(p.read_text(encoding="utf-8").count("assert ") for p in (tree / "tests").rglob("*.py"))
    print(f"{'assertions of tests':22} {asserts:7}")
    print(f"\nmodules above 600 lines: {sum(size > 600 for size, _ in modules)}")
    print(*(f"{size:6} {name}" for size, name in sorted(modules, reverse=True)[:SHOWN]), sep="\n")
    print(f"\nfunctions above 60 lines: {sum(size > 60 for size, _ in long)}")
    print(*(f"{size:6} {name}" for size, name in sorted(long, reverse=True)[:SHOWN]), sep="\n")


if __name__ == "__main__":
    sys.exit(main())
