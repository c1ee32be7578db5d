"""Every error is of a family, whose code stays and which says what to do."""

from __future__ import annotations

import ast
import inspect
import pickle
from pathlib import Path

from deltacal_gen import errors

ROOT = Path(__file__).resolve().parents[2]
KINDS = {"DeltacalError", "UsageError", "InputError", "NoSolutionError"}


def _names() -> dict[str, set[str]]:
    """Return what modules call and what they name, by where."""
    called: set[str] = set()
    named: set[str] = set()
    for path in (p for part in ("src/deltacal_gen", "derive") for p in sorted((ROOT / part).rglob("*.py"))):
        if path.name != "errors.py":
            nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
            named |= {node.id for node in nodes if isinstance(node, ast.Name)}
            called |= {n.func.id for n in nodes if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)}
    return {"called": called, "named": named}


def test_no_error_is_raised_without_its_family_and_no_family_is_idle() -> None:
    found, families = _names(), errors.families()
    assert found["called"] & KINDS == set(), "raise a family of deltacal_gen.errors"
    assert {family.__name__ for family in families.values()} - found["named"] == set()
    assert 40 <= len(families) <= 60


def test_a_family_says_what_it_means_and_what_to_do() -> None:
    for code, family in errors.families().items():
        first, _, remedy = (inspect.getdoc(family) or "").partition("\n\n")
        assert family.__doc__ != family.__base__.__doc__, code
        assert first.endswith("."), code
        assert len(first) + len(remedy) > 40, code


def test_an_error_comes_whole_from_another_process() -> None:
    error = errors.OutOfReach("too far")
    copy = pickle.loads(pickle.dumps(error))
    assert (str(copy), copy.code, copy.exit_code) == ("too far", "out-of-reach", 4)
