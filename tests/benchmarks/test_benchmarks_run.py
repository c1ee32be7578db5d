"""Every contender of every benchmark computes the same numbers: no benchmark compares different work."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

# by the name that `python -m tests.benchmarks` uses: Numba's cache holds the names of modules
sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
from tests.benchmarks import compile, memory, scaling
from tests.benchmarks.works import WORKS, disagreement, works

QUICK = [name for name in WORKS if not name.endswith("_cold") and "command" not in name]


@pytest.mark.parametrize("name", QUICK)
def test_all_contenders_agree(name: str) -> None:
    [(_, work)] = works([name], size=2)
    assert all(much <= 1 for much in disagreement(work).values())


def test_scaling_and_memory_are_measured(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert scaling.main(["--most", "1000", "-o", str(tmp_path / "scaling.png")]) == 0
    assert (tmp_path / "scaling.png").stat().st_size > 10_000
    assert memory.main(["--rows", "2000"]) == 0
    said = capsys.readouterr().out
    for words in ("two threads: W5", "linearise 200 poses", "simulate, csv", "predict, parquet"):
        assert words in said


def test_the_table_of_compile_times_names_modules_that_exist() -> None:
    told = compile.read()
    assert {row["module"] for row in told} == compile.modules(), "run tests.benchmarks.compile --write"
    assert all(float(row["seconds"]) > 0 for row in told)
