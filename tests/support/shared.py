"""The tests that run over a registry, found in their sources: what is added to the registry must pass them all.

Either a test's parameters (or those of a fixture) ask the registry, or its own lines do, in a loop over all that there
is. Names of constants and functions are followed through the modules of the tests.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
REGISTRIES = {  # by the calls that list them; the last one lists all that is generated
    "mechanisms": ("mechanism_names", "registry.mechanisms", "pkgutil.walk_packages"),
    "effects": ("effect_names", "registry.effects", "pkgutil.walk_packages"),
    "measurements": ("measurement_names", "kinds.names", "registry.measurements", "pkgutil.walk_packages"),
}


@dataclass(frozen=True)
class Module:
    """A module of the tests: its definitions by their names, and where the names come from that it imports."""

    tree: ast.Module
    own: dict[str, list[ast.AST]]
    imported: dict[str, tuple[str, str]]  # module, and the name there; "" for the module itself

    @classmethod
    @cache
    def of(cls, name: str) -> Module | None:
        path = TESTS.parent / f"{name.replace('.', '/')}.py"
        if not path.exists():
            return None
        tree = ast.parse(path.read_text(encoding="utf-8"))
        own: dict[str, list[ast.AST]] = {}
        imported: dict[str, tuple[str, str]] = {}
        for node in tree.body:
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                own.setdefault(node.name, []).append(node)
            elif isinstance(node, ast.Assign | ast.AnnAssign | ast.AugAssign) and node.value is not None:
                for target in node.targets if isinstance(node, ast.Assign) else [node.target]:
                    for name in (n.id for n in ast.walk(target) if isinstance(n, ast.Name)):
                        own.setdefault(name, []).append(node.value)
            elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
                where = node.module
                for alias in node.names:
                    whole = Module.file(f"{where}.{alias.name}")
                    imported[alias.asname or alias.name] = (
                        (f"{where}.{alias.name}", "") if whole else (where, alias.name)
                    )
        return cls(tree, own, imported)

    @staticmethod
    def file(name: str) -> bool:
        return name.startswith("tests.") and (TESTS.parent / f"{name.replace('.', '/')}.py").exists()


def _calls(node: ast.AST, registry: str) -> bool:
    """Tell whether a registry is asked in a node itself."""
    called = (ast.unparse(n.func) for n in ast.walk(node) if isinstance(n, ast.Call))
    return any(f".{c}".endswith(tuple(f".{asked}" for asked in REGISTRIES[registry])) for c in called)


@cache
def _asks(module: str, name: str, registry: str, seen: frozenset[tuple[str, str]] = frozenset()) -> bool:
    """Tell whether what a name of a module stands for comes from a registry."""
    found = Module.of(module)
    if found is None or (module, name) in seen:
        return False
    if name in found.imported:
        where, other = found.imported[name]
        return bool(other) and _asks(where, other, registry, seen | {(module, name)})
    return any(_follows(module, node, registry, seen | {(module, name)}) for node in found.own.get(name, ()))


def _follows(module: str, node: ast.AST, registry: str, seen: frozenset[tuple[str, str]] = frozenset()) -> bool:
    """Tell whether a node asks a registry, itself or through what it names."""
    found = Module.of(module)
    assert found is not None
    if _calls(node, registry):
        return True
    for n in ast.walk(node):
        if isinstance(n, ast.Name) and _asks(module, n.id, registry, seen):
            return True
        if isinstance(n, ast.Attribute) and isinstance(n.value, ast.Name) and n.value.id in found.imported:
            where, other = found.imported[n.value.id]
            if not other and _asks(where, n.attr, registry, seen):
                return True
    return False


def _parametrised(module: str, registry: str) -> bool:
    """Tell whether the parameters of any test or fixture of a module come from a registry."""
    found = Module.of(module)
    assert found is not None
    functions = (n for n in ast.walk(found.tree) if isinstance(n, ast.FunctionDef))
    return any(_by_parameters(module, function, registry) for function in functions)


def _by_parameters(module: str, function: ast.FunctionDef, registry: str) -> bool:
    return any(_follows(module, d, registry) for d in function.decorator_list if isinstance(d, ast.Call))


def _looping(module: str, registry: str) -> Iterator[str]:
    """Yield the other tests of a module that ask a registry in their own lines, or name a constant that does."""
    found = Module.of(module)
    assert found is not None
    constants = {n for n, (what, *_) in found.own.items() if not isinstance(what, ast.FunctionDef | ast.ClassDef)}
    for test in (n for n in found.tree.body if isinstance(n, ast.FunctionDef) and n.name.startswith("test_")):
        if _by_parameters(module, test, registry):
            continue
        named = {n.id for line in test.body for n in ast.walk(line) if isinstance(n, ast.Name)} & constants
        if any(_calls(line, registry) for line in test.body) or any(_asks(module, n, registry) for n in named):
            yield test.name


def parametrised(registry: str) -> list[str]:
    """Return the modules (``tests/use/test_x.py``) of tests whose parameters come from a registry."""
    return [_path(m) for m in _modules() if _parametrised(m, registry)]


def looping(registry: str) -> list[str]:
    """Return the other tests (``tests/use/test_x.py::test_y``) that run over a registry, all at once."""
    return [f"{_path(m)}::{name}" for m in _modules() for name in _looping(m, registry)]


def _modules() -> list[str]:
    files = (path.relative_to(TESTS.parent).with_suffix("") for path in sorted(TESTS.rglob("test_*.py")))
    return [".".join(file.parts) for file in files]


def _path(module: str) -> str:
    return f"{module.replace('.', '/')}.py"
