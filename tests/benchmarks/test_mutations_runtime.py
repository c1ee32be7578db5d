"""What the benchmark of planted mistakes plants, and which tests it asks."""

from __future__ import annotations

from pathlib import Path

from tests.benchmarks.mutations import Mistake
from tests.benchmarks.mutations_runtime import MOST_TESTS, PACKAGE, SECONDS, Coverage, mistakes

TEXT = '''"""3 < 4."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    SEEN_BY_TYPES = 1 + 1


def share(x: "int | None", limit: float = 0.5) -> float:
    if x is None:
        raise ValueError(f"{x - 1} is less than {2 * limit}")
    return x / limit
'''


def planted(tree: Path, text: str) -> set[tuple[str, int, str, str]]:
    (tree / PACKAGE).mkdir(parents=True)
    (tree / PACKAGE / "share.py").write_text(text)
    return {(m.kind, m.line, m.before, m.after) for m in mistakes(tree)}


def test_only_what_runs_is_changed(tmp_path: Path) -> None:
    assert planted(tmp_path, TEXT) == {
        ("constant", 9, "0.5", "(0.75)"),
        ("operator", 10, "x is None", "(x is not None)"),
        ("condition", 10, "x is None", "(True)"),
        ("condition", 10, "x is None", "(False)"),
        ("operator", 12, "x / limit", "(x * limit)"),
    }


def test_a_mistake_meets_the_quickest_tests_of_its_line() -> None:
    tests = [("slow", SECONDS), ("quick", 0.1), ("elsewhere", 0.0), *((f"t{k}", 0.2) for k in range(MOST_TESTS))]
    lines = {"a.py": {"7": [0, 1], "8": [*range(len(tests))]}}
    coverage = Coverage(lines, tests)

    def of(line: int) -> list[str]:
        return coverage.of(Mistake("constant", "a.py", line, "1", "(2)", 0, 1))

    assert of(7) == ["quick"]
    assert of(8)[:2] == ["elsewhere", "quick"]
    assert len(of(8)) == MOST_TESTS
    assert of(9) == []
