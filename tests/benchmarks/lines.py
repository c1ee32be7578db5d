"""How large the code is: ``python -m tests.benchmarks.lines [TREE]``.

Lines of code are those that hold code: no docstring, no comment, no blank line. Of templates all lines that are not
blank count. Printed for each part, then the longest modules (all lines) and functions (all lines, without docstring).
"""

from __future__ import annotations

import ast
import io
import sys
import tokenize
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PARTS = ("src/deltacal_gen", "derive", "tests")
SHOWN = 12
QUIET = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}


def code_lines(text: str) -> int:
    """Return how many lines of a module hold code."""
    told = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef) and node.body:
            first = node.body[0]
            if (
                isinstance(first, ast.Expr)
                and isinstance(first.value, ast.Constant)
                and isinstance(first.value.value, str)
            ):
                told |= set(range(first.lineno, (first.end_lineno or first.lineno) + 1))
    held: set[int] = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in QUIET:
            held |= set(range(token.start[0], token.end[0] + 1))
    return len(held - told)


def functions(text: str) -> Iterator[tuple[str, int, int]]:
    """Yield name, line and length of every function of a module; a docstring is not counted."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            told = ast.get_docstring(node, clean=False)
            first = node.body[0]
            docstring = (first.end_lineno or 0) - first.lineno + 1 if told is not None else 0
            yield node.name, node.lineno, (node.end_lineno or node.lineno) - node.lineno + 1 - docstring


def main() -> int:
    """Print the counts of a tree."""
    tree = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT
    modules: list[tuple[int, str]] = []
    long: list[tuple[int, str]] = []
    for part in PARTS:
        total = 0
        for path in sorted((tree / part).rglob("*.py")):
            text, place = path.read_text(encoding="utf-8"), path.relative_to(tree)
            total += code_lines(text)
            if part != "tests":
                modules.append((len(text.splitlines()), str(place)))
                long += [(size, f"{place}:{line} {name}") for name, line, size in functions(text)]
        print(f"{part:20} {total:6} lines of code")
    texts = (p.read_text(encoding="utf-8") for p in (tree / "templates").rglob("*.jinja"))
    print(f"{'templates':20} {sum(bool(line.strip()) for text in texts for line in text.splitlines()):6} lines")
    asserts = sum(p.read_text(encoding="utf-8").count("assert ") for p in (tree / "tests").rglob("*.py"))
    print(f"{'tests':20} {asserts:6} assertions")
    print(f"\nmodules above 600 lines: {sum(size > 600 for size, _ in modules)}")
    print(*(f"{size:6} {name}" for size, name in sorted(modules, reverse=True)[:SHOWN]), sep="\n")
    print(f"\nfunctions above 60 lines: {sum(size > 60 for size, _ in long)}")
    print(*(f"{size:6} {name}" for size, name in sorted(long, reverse=True)[:SHOWN]), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
