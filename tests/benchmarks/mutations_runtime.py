"""Mistakes put into the runtime on purpose, and which test notices each.

Run ``python -m tests.benchmarks.mutations_runtime --folder WORKTREE``.

A mistake changes an operator, a comparison, a number, or forces an ``if`` either way, somewhere in `src`. Which ones is
drawn by a seed from all places of lines that tests execute; messages, docstrings, annotations and what only type
checkers read are left out. First, once for a state of the tree, the tests run under coverage, so that it is known which
tests execute which line (``--map`` does that alone); then each mistake meets only the tests that execute its line, the
quickest first, for at most `SECONDS` in all. Lines that no test executes are drawn, too, and are noticed by nothing.

Rows go to a table as they come, and a sitting goes on behind the seed's last row: ``--minutes`` ends it.
"""

from __future__ import annotations

import argparse
import ast
import csv
import json
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from tests.benchmarks.mutations import Bench, Mistake, drawn, row

ROOT = Path(__file__).resolve().parents[2]
TABLE = Path(__file__).parent / "mutations_runtime.csv"
PACKAGE = "src/deltacal_gen"
COUNT = 60
SECONDS = 60.0  # that the tests of one mistake may take
MOST_TESTS = 40  # of one mistake
MAP = "tests_by_line.json"  # beside the worktree
HEADER = ["seed", "kind", "file", "line", "before", "after", "noticed by"]

OPERATORS: dict[type[ast.operator], ast.operator] = {
    ast.Add: ast.Sub(),
    ast.Sub: ast.Add(),
    ast.Mult: ast.Div(),
    ast.Div: ast.Mult(),
    ast.FloorDiv: ast.Div(),
    ast.Mod: ast.Mult(),
    ast.Pow: ast.Mult(),
    ast.BitAnd: ast.BitOr(),
    ast.BitOr: ast.BitAnd(),
    ast.MatMult: ast.Mult(),
}
COMPARISONS: dict[type[ast.cmpop], ast.cmpop] = {
    ast.Lt: ast.GtE(),
    ast.LtE: ast.Gt(),
    ast.Gt: ast.LtE(),
    ast.GtE: ast.Lt(),
    ast.Eq: ast.NotEq(),
    ast.NotEq: ast.Eq(),
    ast.In: ast.NotIn(),
    ast.NotIn: ast.In(),
    ast.Is: ast.IsNot(),
    ast.IsNot: ast.Is(),
}


def changes(node: ast.AST) -> Iterator[tuple[str, ast.expr, ast.expr]]:
    """Yield kinds of mistakes at a node: what is changed, and what takes its place."""
    match node:
        case ast.BinOp(left, operator, right) if type(operator) in OPERATORS:
            yield "operator", node, ast.BinOp(left, OPERATORS[type(operator)], right)
        case ast.Compare(left, [operator], [right]):
            yield "operator", node, ast.Compare(left, [COMPARISONS[type(operator)]], [right])
        case ast.BoolOp(ast.And(), values):
            yield "operator", node, ast.BoolOp(ast.Or(), values)
        case ast.BoolOp(ast.Or(), values):
            yield "operator", node, ast.BoolOp(ast.And(), values)
        case ast.UnaryOp(ast.USub() | ast.Not(), operand) if not isinstance(operand, ast.Constant):
            yield "operator", node, operand
        case ast.Constant(bool()):
            yield "constant", node, ast.Constant(not node.value)
        case ast.Constant(int() as value):
            yield "constant", node, ast.Constant(value + 1)
        case ast.Constant(float() as value):
            yield "constant", node, ast.Constant(1.5 * value if value else 1.0)
        case ast.If(test) | ast.IfExp(test) if ast.unparse(test) != "TYPE_CHECKING":
            yield "condition", test, ast.Constant(True)
            yield "condition", test, ast.Constant(False)


def _unread(tree: ast.AST) -> set[int]:
    """Return the nodes in which a change is no mistake: texts, annotations, what is raised, what types alone need."""
    out: set[int] = set()
    for node in ast.walk(tree):
        aside: list[ast.AST | None] = []
        match node:
            case ast.JoinedStr() | ast.Raise():
                aside = [node]
            case ast.AnnAssign(_, annotation) | ast.arg(_, annotation):
                aside = [annotation]
            case ast.FunctionDef(returns=returns):
                aside = [returns]
            case ast.If(test) if ast.unparse(test) == "TYPE_CHECKING":
                aside = [node]
        out |= {id(inner) for part in aside if part is not None for inner in ast.walk(part)}
    return out


def mistakes(root: Path = ROOT) -> list[Mistake]:
    """Return all mistakes that can be made in the runtime, file by file in the order of the text."""
    found = []
    for path in sorted((root / PACKAGE).rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        starts = [0]
        for line in text.splitlines(keepends=True):
            starts.append(starts[-1] + len(line.encode()))
        tree = ast.parse(text)
        aside = _unread(tree)
        for node in ast.walk(tree):
            if id(node) in aside:
                continue
            for kind, changed, instead in changes(node):
                start = starts[changed.lineno - 1] + changed.col_offset
                end = starts[(changed.end_lineno or changed.lineno) - 1] + (changed.end_col_offset or 0)
                before = text.encode()[start:end].decode()
                after = f"({ast.unparse(ast.fix_missing_locations(instead))})"
                file = path.relative_to(root).as_posix()
                found.append(Mistake(kind, file, changed.lineno, before, after, start, end))
    return found


class Coverage:
    """Which tests execute which line, and how long each takes."""

    def __init__(self, lines: Mapping[str, Mapping[str, Sequence[int]]], tests: Sequence[tuple[str, float]]) -> None:
        self.lines, self.tests = lines, tests

    @classmethod
    def measured(cls, bench: Bench) -> Coverage:
        """Run the tests of a worktree under coverage, or read what an earlier run of the same state has found."""
        kept = bench.folder.with_name(f"{bench.folder.name}.{MAP}")
        state = subprocess.run(["git", "-C", str(bench.folder), "rev-parse", "HEAD"], capture_output=True, text=True)
        if kept.exists() and (found := json.loads(kept.read_text()))["state"] == state.stdout:
            return cls(found["lines"], found["tests"])
        print("running the tests under coverage", flush=True)
        report = bench.folder / "durations.xml"
        subprocess.run(
            [
                *(sys.executable, "-m", "pytest", "-q", "-n", "2", f"--junitxml={report}", "-p", "no:cacheprovider"),
                *(f"--cov={PACKAGE}", "--cov-context=test", "--cov-report=", "--ignore=tests/benchmarks"),
            ],
            cwd=bench.folder,
            env=bench.environment,
            check=False,
        )
        seconds = _durations(report)
        lines, names = _contexts(bench.folder, seconds)
        found = {"state": state.stdout, "lines": lines, "tests": [(name, seconds.get(name, 0.0)) for name in names]}
        kept.write_text(json.dumps(found))
        return cls(lines, found["tests"])

    def of(self, mistake: Mistake) -> list[str]:
        """Return the tests that execute a mistake's line, the quickest first, as far as time allows."""
        numbers = self.lines.get(mistake.file, {}).get(str(mistake.line), ())
        out, left = [], SECONDS
        for name, took in sorted((self.tests[n] for n in numbers), key=lambda test: test[1])[:MOST_TESTS]:
            left -= took
            if left < 0 and out:
                break
            out.append(name)
        return out


def _durations(report: Path) -> dict[str, float]:
    """Return how long each test took by its node's name [s], of a report in JUnit's form."""
    from xml.etree import ElementTree

    out: dict[str, float] = {}
    for case in ElementTree.parse(report).iter("testcase"):
        module = (case.get("classname") or "").replace(".", "/")
        out[f"{module}.py::{case.get('name')}"] = float(case.get("time") or 0.0)
    return out


def _contexts(folder: Path, known: Mapping[str, float]) -> tuple[dict[str, dict[str, list[int]]], list[str]]:
    """Return the numbers of tests by file and line, and their names."""
    import coverage

    data = coverage.CoverageData(str(folder / ".coverage"))
    data.read()
    names: dict[str, int] = {}
    lines: dict[str, dict[str, list[int]]] = {}
    for file in data.measured_files():
        place = Path(file).relative_to(folder).as_posix()
        lines[place] = {}
        for line, contexts in data.contexts_by_lineno(file).items():
            tests = {context.partition("|")[0] for context in contexts} & set(known)
            lines[place][str(line)] = [names.setdefault(test, len(names)) for test in sorted(tests)]
    return lines, list(names)


def noticed(bench: Bench, coverage: Coverage, mistake: Mistake) -> str:
    """Return which test notices a mistake that is made, or an empty text."""
    code, said = bench.run("-c", "import deltacal_gen.app.commands")
    if code:
        return f"import: {(said.strip().splitlines() or [''])[-1][:90]}"
    tests = coverage.of(mistake)
    return bench.pytest("-m", "", *tests)[1] if tests else ""


def trial(bench: Bench, coverage: Coverage, seed: int, done: Sequence[Sequence[str]]) -> Iterator[tuple[Mistake, str]]:
    """Yield mistakes of a seed behind those that are done, with what notices each."""
    bench.clean()
    had = {tuple(line[:-1]) for line in done}
    for mistake in drawn(seed, mistakes(bench.folder)):
        if tuple(row(seed, mistake)) in had:
            continue
        bench.clean()
        bench.make(mistake)
        yield mistake, noticed(bench, coverage, mistake)
    bench.clean()


def _by_wing(rows: Sequence[Sequence[str]]) -> str:
    """Return how many mistakes each wing had, and how many of them nothing noticed."""
    all_, missed = (
        Counter(Path(line[2]).parts[2] for line in rows if line[-1] == "nothing" or whole) for whole in (True, False)
    )
    return ", ".join(f"{wing} {missed[wing]} of {count}" for wing, count in sorted(all_.items()))


def main(arguments: Sequence[str]) -> int:
    """Try the mistakes of a seed; write the table; return the number that nothing noticed."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=COUNT)
    parser.add_argument("--folder", type=Path, required=True, help="of the worktree, which is made of the last commit")
    parser.add_argument("-o", "--output", type=Path, default=TABLE)
    parser.add_argument("--minutes", type=float, default=float("inf"), help="after which no further one begins")
    parser.add_argument("--map", action="store_true", help="measure which tests execute which line, and end")
    given = parser.parse_args(arguments)
    bench, end = Bench(given.folder.resolve()), time.monotonic() + 60 * given.minutes
    coverage = Coverage.measured(bench)
    if given.map:
        return 0
    rows = [*csv.reader(given.output.open(encoding="utf-8"))] if given.output.exists() else [HEADER]
    done = [line for line in rows if line[0] == str(given.seed)]
    with given.output.open("a", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        if len(rows) == 1:
            table.writerow(HEADER)
        for mistake, by in trial(bench, coverage, given.seed, done) if len(done) < given.count else ():
            done.append([*row(given.seed, mistake), by or "nothing"])
            table.writerow(done[-1])
            file.flush()
            print(len(done), *done[-1][1:], sep=" | ", flush=True)
            if len(done) >= given.count or time.monotonic() > end:
                break
    bench.clean()
    unnoticed = sum(line[-1] == "nothing" for line in done)
    print(f"{len(done) - unnoticed} of {len(done)} noticed; unnoticed by wing: {_by_wing(done)}")
    return unnoticed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
