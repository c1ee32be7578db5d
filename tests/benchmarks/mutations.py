"""Mistakes put into the derivation on purpose, and what notices: ``python -m tests.benchmarks.mutations --seed S``.

A mistake changes a sign, a factor, an index, a frame or a term in a file of mechanisms, effects or measurements, or in
that of statics. Which ones is drawn by a seed from all places where there is something to change; left out are those
that change no value of what the file describes, at two random points. The rest of the chain then runs as it would for
an author who made that mistake: verdicts on the papers are decided, kernels derived anew, tests run, the nearest ones
first. A mistake is noticed where one of them turns red; the first one that does is written down.

It works in a worktree of its own (``--folder``), which it makes from the committed state. The order in which a seed
draws depends on each mistake alone, so that it stays the same when other files change: a sitting (``--minutes M``) goes
on behind the seed's last row of the table. A test that does not end in time has noticed nothing.
"""

from __future__ import annotations

import argparse
import ast
import csv
import hashlib
import json
import os
import random
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, is_dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
FILES = ("derive/mechanisms/*.py", "derive/effects/*.py", "derive/measurements/*.py", "derive/statics.py")
TABLE = Path(__file__).parent / "mutations.csv"
COUNT, LIMIT = 40, 480  # mutants of a seed; seconds of a stage
NOTHING_CHOSEN, TOO_SLOW = 5, 124  # exit codes, of pytest and of here

# what is said of a thing rather than what it does: no kernel reads it
SAID = {
    "typical",
    "tests",
    "advice",
    "title",
    "reference",
    "source",
    "meaning",
    "searched",
    "nominal",
    "default",
    "steps",
}
PAPERS = {
    "delta": ("bai", "savoure"),
    "complete_delta": ("savoure",),
    "planar_parallelogram": ("savoure",),
    "simplified_parallelogram": ("savoure",),
    "diamond": ("mei",),
    "robotennis": ("traslosheros",),
    "distance": ("bai",),
    "gauge": ("mei",),
}
RELATED = {"delta": ("delta", "complete_delta"), "statics": ("delta", "linear_delta")}
NEAREST = {  # tests by what was changed, the nearest and quickest first
    "delta": (
        "machine/test_bai2015",
        *(f"claims/test_bai_{part}" for part in ("model", "identification", "experiment")),
    ),
    "complete_delta": ("machine/test_savoure2006",),
    "planar_parallelogram": ("machine/test_savoure2006",),
    "simplified_parallelogram": ("machine/test_savoure2006",),
    "diamond": ("machine/test_mei2018",),
    "robotennis": ("machine/test_traslosheros2013",),
    "linear_delta": ("machine/test_linear_delta",),
    "serial": ("machine/test_serial",),
}
BY_KIND = {
    "mechanisms": (
        "derive/test_papers",
        "whole/test_every_mechanism",
        "physics/test_physics",
        "derive/test_laws",
        "derive/test_derivation",
        "whole/test_frozen",
    ),
    "effects": (
        "physics/test_physics",
        "derive/test_states",
        "physics/test_memory",
        "derive/test_laws",
        "derive/test_derivation",
        "whole/test_frozen",
    ),
    "measurements": (
        "kinds/test_measurement",
        "kinds/test_boards",
        "kinds/test_kinds",
        "files/test_camera",
        "kinds/test_contact",
        "files/test_points",
        "machine/test_traslosheros2013",
        "whole/test_frozen",
    ),
    "statics": ("physics/test_physics", "derive/test_laws", "whole/test_frozen"),
}


@dataclass(frozen=True)
class Mistake:
    """A change of a line: kind, file, line, the text as it was and as it is, and where it stands in the file."""

    kind: str
    file: str
    line: int
    before: str
    after: str
    start: int
    end: int


# ------------------------------------------------------------------------------------------------ what can be changed


def _changes(node: ast.AST) -> Iterator[tuple[str, ast.expr]]:
    """Yield kinds of mistakes at a node, each with what takes its place."""
    match node:
        case ast.BinOp(left, ast.Add() as op, right) | ast.BinOp(left, ast.Sub() as op, right):
            yield "sign", ast.BinOp(left, ast.Sub() if isinstance(op, ast.Add) else ast.Add(), right)
            yield "term", left
        case ast.BinOp(left, ast.Mult(), right):
            yield "factor", left
            yield "factor", right
        case ast.BinOp(left, ast.Div(), _):
            yield "factor", left
        case ast.UnaryOp(ast.USub(), operand) if not isinstance(operand, ast.Constant):
            yield "sign", operand
        case ast.Call(ast.Attribute(value, "cos" | "sin" as name), args, []):
            yield "factor", ast.Call(ast.Attribute(value, {"cos": "sin", "sin": "cos"}[name]), args, [])
        case ast.Call(ast.Attribute(of, "cross"), [other], []):
            yield "frame", ast.Call(ast.Attribute(other, "cross"), [of], [])
        case ast.Call(ast.Attribute(value, name), args, []) if name.startswith("turn_about_"):
            yield "frame", ast.Call(ast.Attribute(value, f"turn_about_{'yzx'['xyz'.index(name[-1])]}"), args, [])
        case ast.Attribute(value, "T"):
            yield "frame", value
        case ast.Name("u0" | "v0" | "w0" as name, ast.Load()):
            yield "frame", ast.Name({"u0": "v0", "v0": "w0", "w0": "u0"}[name], ast.Load())
        case ast.Subscript(value, ast.Constant(int(index)), ast.Load()):
            yield "index", ast.Subscript(value, ast.Constant((index + 1) % 3), ast.Load())


def mistakes(root: Path = ROOT) -> list[Mistake]:
    """Return all mistakes that can be made, file by file in the order of the text."""
    found = []
    for path in sorted(p for pattern in FILES for p in root.glob(pattern)):
        text = path.read_text(encoding="utf-8")
        starts = [0]
        for line in text.splitlines(keepends=True):
            starts.append(starts[-1] + len(line.encode()))
        in_text = {id(n) for f in ast.walk(ast.parse(text)) if isinstance(f, ast.JoinedStr) for n in ast.walk(f)}
        for node in ast.walk(ast.parse(text)):
            if not isinstance(node, ast.expr) or id(node) in in_text or node.end_col_offset is None:
                continue
            start = starts[node.lineno - 1] + node.col_offset
            end = starts[(node.end_lineno or node.lineno) - 1] + node.end_col_offset
            before = text.encode()[start:end].decode()
            for kind, changed in _changes(node):
                after = f"({ast.unparse(ast.fix_missing_locations(changed))})"
                found.append(Mistake(kind, path.relative_to(root).as_posix(), node.lineno, before, after, start, end))
    return found


# ---------------------------------------------------------------------------------------------- what a file describes


def _numbers(thing: Any, at: dict[Any, Any]) -> Any:
    """Return what a description computes at numbers, as lists and text."""
    import sympy as sp

    if isinstance(thing, sp.MatrixBase):
        return [_numbers(e, at) for e in thing]
    if isinstance(thing, sp.Basic):
        for symbol in sorted(thing.free_symbols - at.keys(), key=str):
            at[symbol] = sp.Float(random.Random(f"{at['seed']}{symbol}").uniform(0.2, 1.3))
        value = sp.N(thing.xreplace({s: v for s, v in at.items() if s != "seed"}))
        return f"{float(value):.9e}" if value.is_number and value.is_real else str(value)
    if is_dataclass(thing) and not isinstance(thing, type):
        if hasattr(thing, "steps"):
            for symbol, expr in thing.steps:
                at[symbol] = sp.Float(float(_numbers(expr, at)))
        return {f.name: _numbers(getattr(thing, f.name), at) for f in fields(thing) if f.name not in SAID}
    if isinstance(thing, dict):
        return {str(k): _numbers(v, at) for k, v in thing.items()}
    if isinstance(thing, list | tuple):
        return [_numbers(v, at) for v in thing]
    return None if isinstance(thing, float) else str(thing) if not callable(thing) else None


def described(file: str) -> str:
    """Return all that a file describes at two random points, as text: what does not change it is no mistake."""
    import sympy as sp

    from derive import registry, statics

    name, kind = Path(file).stem, Path(file).parent.name
    found: list[Any] = []
    for seed in (1, 2):
        at: dict[Any, Any] = {"seed": seed}
        if kind == "effects":
            found.append(_numbers(registry.effect(name), at))
        elif kind == "measurements":
            found.append(_numbers(registry.measurement(name), at))
        elif kind == "mechanisms":
            found += [_numbers(registry.mechanism(m), {"seed": seed}) for m in RELATED.get(name, (name,))]
        else:
            machine: Any = registry.mechanism("delta")
            for functions in statics.loads(machine):
                for symbol, expr in functions.graph.nodes.items():
                    at[symbol] = sp.Float(float(_numbers(expr, at)))
                found.append({f.name: [_numbers(e, at) for _, e in f.outputs] for f in functions})
    return json.dumps(found, sort_keys=True)


# ----------------------------------------------------------------------------------------------- what notices a mistake


class Bench:
    """A worktree in which mistakes are made."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        if not folder.exists():
            subprocess.run(["git", "-C", str(ROOT), "worktree", "add", "--detach", "-q", str(folder)], check=True)
        path = [folder / "src", folder / "generated", folder]
        self.environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, path)), "PYTHONHASHSEED": "0"}

    def clean(self) -> None:
        """Undo everything."""
        subprocess.run(["git", "-C", str(self.folder), "checkout", "-q", "--", "."], check=True)

    def make(self, mistake: Mistake) -> None:
        """Make a mistake."""
        path = self.folder / mistake.file
        text = path.read_bytes()
        path.write_bytes(text[: mistake.start] + mistake.after.encode() + text[mistake.end :])

    def run(self, *arguments: str) -> tuple[int, str]:
        """Run Python in the worktree; return the exit code, `TOO_SLOW` after `LIMIT` seconds, and what it said."""
        try:
            where = {"cwd": self.folder, "env": self.environment, "timeout": LIMIT}
            done = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, **where)
        except subprocess.TimeoutExpired:
            return TOO_SLOW, ""
        return done.returncode, (done.stdout + done.stderr)

    def described(self, file: str) -> tuple[int, str]:
        """Return what a file of the worktree describes."""
        code, said = self.run("-c", f"from tests.benchmarks.mutations import described; print(described({file!r}))")
        return code, said.strip().splitlines()[-1] if said.strip() else ""

    def noticed(self, mistake: Mistake) -> str:
        """Return what notices a mistake that is made, or an empty text."""
        name, kind = Path(mistake.file).stem, Path(mistake.file).parent.name
        kind = kind if kind != "derive" else "statics"
        chosen = " or ".join(PAPERS.get(name, ()))
        if chosen:
            code, said = self.pytest("tests/derive/test_papers.py", "-k", f"committed and ({chosen})")
            if code:
                return said
        code, said = self.run("-m", "derive", *RELATED.get(name, (name,)))
        if code not in (0, TOO_SLOW):
            return f"refused: {_last(said)}"
        for test in (*NEAREST.get(name, ()), *BY_KIND[kind]):
            code, said = self.pytest(f"tests/{test}.py")
            if code:
                return said
        return ""

    def pytest(self, *arguments: str) -> tuple[int, str]:
        """Run tests until one fails; return the exit code and its name."""
        code, said = self.run("-m", "pytest", "-x", "-q", "-n0", "-p", "no:cacheprovider", *arguments)
        failed = [line.split(" ")[1] for line in said.splitlines() if line.startswith(("FAILED", "ERROR"))]
        return (0, "") if code in (NOTHING_CHOSEN, TOO_SLOW) else (code, failed[0] if failed else arguments[0])


def _last(said: str) -> str:
    return (said.strip().splitlines() or [""])[-1][:90]


def drawn(seed: int, every: Sequence[Mistake]) -> list[Mistake]:
    """Return mistakes in the order of a seed: by a hash of each one, which knows nothing of the others."""
    alike: Counter[tuple[str, ...]] = Counter()
    keys = {}
    for mistake in every:
        what = (mistake.kind, mistake.file, mistake.before, mistake.after)
        alike[what] += 1
        keys[mistake] = hashlib.sha256(repr((seed, *what, alike[what])).encode()).hexdigest()
    return sorted(every, key=keys.__getitem__)


def row(seed: int, mistake: Mistake) -> list[str]:
    """Return a mistake as the table holds it, without what notices it."""
    before, after = (" ".join(t.split()) for t in (mistake.before, mistake.after))
    return [str(seed), mistake.kind, mistake.file, str(mistake.line), before, after]


def trial(bench: Bench, seed: int, count: int, last: Sequence[str] = ()) -> Iterator[tuple[Mistake, str]]:
    """Yield `count` mistakes of a seed behind a row, with what notices each; what changes nothing is none."""
    bench.clean()
    every = drawn(seed, mistakes(bench.folder))
    begin = next((n + 1 for n, m in enumerate(every) if row(seed, m) == list(last)), 0)
    right: dict[str, str] = {}
    done = 0
    for mistake in every[begin:]:
        if done == count:
            break
        bench.clean()
        if mistake.file not in right:
            right[mistake.file] = bench.described(mistake.file)[1]
        bench.make(mistake)
        code, now = bench.described(mistake.file)
        if not code and now == right[mistake.file]:
            continue
        done += 1
        yield mistake, f"refused: {_last(now)}" if code else bench.noticed(mistake)
    bench.clean()


def main(arguments: Sequence[str]) -> int:
    """Try the mistakes of a seed; write the table; return the number that nothing noticed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=COUNT)
    parser.add_argument("--folder", type=Path, required=True, help="of the worktree")
    parser.add_argument("-o", "--output", type=Path, default=TABLE)
    parser.add_argument("--minutes", type=float, default=float("inf"), help="after which no further one begins")
    asked = parser.parse_args(arguments)
    bench, end = Bench(asked.folder), time.monotonic() + 60 * asked.minutes
    new = not asked.output.exists()
    had = [] if new else [row for row in csv.reader(asked.output.open(encoding="utf-8")) if row[0] == str(asked.seed)]
    tried, unnoticed = len(had), sum(row[-1] == "nothing" for row in had)
    with asked.output.open("a", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        if new:
            table.writerow(["seed", "kind", "file", "line", "before", "after", "noticed by"])
        for mistake, by in trial(bench, asked.seed, asked.count - len(had), had[-1][:-1] if had else ()):
            tried, unnoticed = tried + 1, unnoticed + (not by)
            told = [*row(asked.seed, mistake), by or "nothing"]
            table.writerow(told)
            file.flush()
            print(tried, *told, sep=" | ", flush=True)
            if time.monotonic() > end:
                break
    print(f"{tried - unnoticed} of {tried} noticed")
    return unnoticed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
