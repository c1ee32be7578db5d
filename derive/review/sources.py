"""Where things are written: lines of sources that a report leads to, and generated kernels counted in their text."""

from __future__ import annotations

import ast
import hashlib
import inspect
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parents[2]
PAGES = Path(__file__).parent / "pages"
EXAMPLES = Path(str(resources.files("deltacal_gen") / "examples"))


class Place(NamedTuple):
    """A line of a file of the checkout."""

    file: str
    line: int


class Lines:
    """Where in a source file things are written."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.tree = ast.parse((ROOT / path).read_text(encoding="utf-8"))

    def keyword(self, name: str) -> Place:
        """Return the place of a keyword argument, of the function it calls where it calls one of this file."""
        nodes = list(ast.walk(self.tree))
        found = [k for call in nodes if isinstance(call, ast.Call) for k in call.keywords if k.arg == name]
        if not found:
            return Place(self.path, 1)
        inner = [n.func for n in ast.walk(found[-1].value) if isinstance(n, ast.Call)]
        called = {f.id for f in inner if isinstance(f, ast.Name)}
        own = [node.lineno for node in nodes if isinstance(node, ast.FunctionDef) and node.name in called]
        return Place(self.path, own[0] if own else found[-1].value.lineno)


def of_function(function: Callable[..., Any]) -> Place:
    """Return where a function or a method is defined."""
    function = inspect.unwrap(function)
    file = Path(inspect.getsourcefile(function) or "").resolve().relative_to(ROOT)
    return Place(file.as_posix(), inspect.getsourcelines(function)[1])


def in_template(template: str, text: str) -> Place:
    """Return where a template begins a function."""
    lines = (ROOT / template).read_text(encoding="utf-8").splitlines()
    return Place(template, next(n for n, line in enumerate(lines, start=1) if line.startswith(text)))


class Sources:
    """The files of the checkout that a report leads to, and the lines it leads to in them.

    Parameters
    ----------
    root : path
        Of the checkout.
    """

    def __init__(self, root: Path = ROOT) -> None:
        self.root = root
        self._texts: dict[str, str] = {}
        self._wanted: dict[str, set[int]] = {}

    def text(self, file: str) -> str:
        """Return a file's text."""
        if file not in self._texts:
            self._texts[file] = (self.root / file).read_text(encoding="utf-8")
        return self._texts[file]

    def at(self, file: str, line: int) -> dict[str, Any]:
        """Return a place to lead to: its text, and the name of its anchor."""
        self._wanted.setdefault(file, set()).add(line)
        return {"file": file, "line": line, "text": f"{file}:{line}", "anchor": _anchor(file, line)}

    def functions(self, file: str) -> dict[str, ast.FunctionDef]:
        """Return the functions of a file, those of a class by ``Class.name``."""
        return _functions(self.text(file))

    def listings(self) -> list[dict[str, Any]]:
        """Return what the report embeds: a mechanism or an effect whole, of other files the functions in question."""
        found = []
        for file in sorted(self._wanted):
            lines, wanted = self.text(file).splitlines(), sorted(self._wanted[file])
            spans = [(1, len(lines))]
            if file.endswith(".jinja"):
                spans = [(n, _paragraphs(lines, n)) for n in wanted]
            elif not file.startswith(("derive/mechanisms", "derive/effects", "derive/measurements")):
                nodes = self.functions(file).values()
                first = [min([node.lineno, *(d.lineno for d in node.decorator_list)]) for node in nodes]
                every = [(a, node.end_lineno or a) for a, node in zip(first, nodes, strict=True)]
                spans = [(a, b) for a, b in every if any(a <= line <= b for line in wanted)]
            found.append(
                {
                    "file": file,
                    "parts": [
                        [
                            {"number": n, "text": lines[n - 1], "anchor": _anchor(file, n) if n in wanted else ""}
                            for n in range(a, b + 1)
                        ]
                        for a, b in spans
                    ],
                }
            )
        return found

    def digest(self, file: str) -> str:
        """Return the SHA-256 of a file's bytes."""
        return hashlib.sha256(self.text(file).encode()).hexdigest()


@cache
def _functions(text: str) -> dict[str, ast.FunctionDef]:
    found = {}
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef):
            found[node.name] = node
        elif isinstance(node, ast.ClassDef):
            found |= {f"{node.name}.{f.name}": f for f in node.body if isinstance(f, ast.FunctionDef)}
    return found


def _paragraphs(lines: Sequence[str], first: int) -> int:
    """Return the last line of a function in a template: two empty lines follow it."""
    return next(
        (n for n in range(first, len(lines) - 1) if not lines[n].strip() and not lines[n + 1].strip()), len(lines)
    )


def _anchor(file: str, line: int) -> str:
    return f"{re.sub(r'[^a-z0-9]+', '-', file.lower())}-{line}"


@dataclass(frozen=True)
class Assigned:
    """A named value in a kernel: its line, its operations as they stand and written out."""

    line: int
    operations: int
    written_out: int


@dataclass(frozen=True)
class Kernel:
    """A straight-line function of the generated package, counted in its committed text.

    `operations`: of its statements, common subexpressions once; `written_out`: of its outputs with every name replaced
    by what it stands for, down to the inputs.
    """

    name: str
    file: str
    line: int
    meaning: str
    outputs: int
    operations: int
    written_out: int
    assigned: Mapping[str, Assigned]


def kernels(sources: Sources, file: str) -> list[Kernel]:
    """Return the straight-line functions of a generated file, of one limb too; constants count in what reads them."""
    shared: dict[str, int] = {}
    constants: dict[tuple[str, str], int] = {}  # of commands of one pose, by kind and name: they lie in w with all else
    found = []
    for name, node in sources.functions(file).items():
        kind = name.lstrip("_").split("_")[0]
        inside = [a.arg for a in node.args.args][:1] == ["w"]
        out = "k" if name.endswith("constants") else "w" if inside else "out"
        body = [s for part in node.body for s in (part.body if inside and isinstance(part, ast.For) else [part])]
        if any(isinstance(s, ast.For | ast.While | ast.If) for s in body):
            continue
        sizes: dict[str, int] = {}
        assigned: dict[str, Assigned] = {}
        operations = outputs = written_out = 0
        for statement in body:
            if not isinstance(statement, ast.Assign):
                continue
            target = statement.targets[0]
            if inside and isinstance(target, ast.Name) and isinstance(statement.value, ast.Subscript):
                sizes[target.id] = constants.get((kind, target.id), 0)
                continue  # reads a place of w
            if isinstance(target, ast.Name) and target.id == out:
                continue  # makes the array
            own, whole = _size(statement.value, sizes, shared if out == "out" else {})
            operations += own
            if isinstance(target, ast.Name):
                sizes[target.id] = whole
                assigned[target.id] = Assigned(statement.lineno, own, whole)
            elif isinstance(target, ast.Subscript) and isinstance(target.value, ast.Name) and target.value.id == out:
                outputs += 1
                written_out += whole
                if out == "k":
                    shared[_index(target)] = whole
                    if name.startswith("_") and isinstance(statement.value, ast.Name):
                        constants[kind, statement.value.id] = whole
        if outputs and operations:
            doc = (ast.get_docstring(node) or "").split("\n")[0]
            doc = re.sub(r"^Return k \(.*?\), (.*), from p \(.*", lambda m: m[1][0].upper() + m[1][1:], doc)
            doc = doc.split(" (")[0].rstrip(".:,")
            found.append(Kernel(name, file, node.lineno, doc, outputs, operations, written_out, assigned))
    return found


def table_of(used: Sequence[Kernel], sources: Sources) -> list[dict[str, Any]]:
    """Return kernels as rows of the page: what they compute, of how many operations, and where they stand."""
    return [
        {
            "name": k.name,
            "meaning": k.meaning,
            "outputs": k.outputs,
            "operations": k.operations,
            "written_out": k.written_out,
            "at": sources.at(k.file, k.line),
        }
        for k in used
    ]


def _index(node: ast.Subscript) -> str:
    return ast.unparse(node.slice).split(", ")[-1].rstrip(")")


def _size(node: ast.expr, sizes: Mapping[str, int], shared: Mapping[str, int]) -> tuple[int, int]:
    """Return the operations of an expression as it stands, and with its names written out."""
    own = whole = 0
    for part in ast.walk(node):
        if isinstance(part, ast.BinOp | ast.Call) or (isinstance(part, ast.UnaryOp) and isinstance(part.op, ast.USub)):
            own += 1
        elif isinstance(part, ast.Name):
            whole += sizes.get(part.id, 0)
        elif isinstance(part, ast.Subscript) and isinstance(part.value, ast.Name) and part.value.id == "k":
            whole += shared.get(_index(part), 0)
    return own, own + whole
