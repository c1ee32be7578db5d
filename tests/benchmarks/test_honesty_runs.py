"""The benchmark of stated figures does what it says, on a job of each sort that costs little."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.benchmarks import honesty


def test_noise_is_of_unit_size_and_of_its_sort() -> None:
    rng = np.random.default_rng(1)
    for sort in ("white", "uniform", "AR 0.5", "AR 0.9"):
        assert np.std(honesty.noise(sort, (20000, 3), rng)) == pytest.approx(1.0, rel=0.05), sort
    e = honesty.noise("AR 0.9", (20000, 3), rng)
    assert np.mean(e[1:] * e[:-1]) == pytest.approx(0.9, abs=0.05)


def test_a_run_that_was_ended_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Any] = []

    def examined(job: honesty.Job) -> dict[str, Any]:
        asked.append(job)
        if len(asked) == 5:
            raise KeyboardInterrupt
        return {"named": False, "unexplained": False, "hinted": True, "told": True, "p": 0.5, "inside": 3, "of": 4}

    monkeypatch.setattr(honesty, "examined", examined)
    kept = tmp_path / "kept.txt"
    with pytest.raises(KeyboardInterrupt):
        honesty.main(["--count", "1", "--kept", str(kept)])
    assert len(kept.read_text().splitlines()) == 4
    assert honesty.main(["--count", "1", "--kept", str(kept)]) == 0
    assert len(asked) == 5 + len(honesty.jobs(1)) - 4
    assert len(set(asked)) == len(honesty.jobs(1))


def test_bands_are_counted_by_what_is_true() -> None:
    found = honesty.examined(("bands", "18", 0))
    assert found["of"] == 3 * honesty.NEW
    assert found["inside"] > 0.8 * found["of"]
