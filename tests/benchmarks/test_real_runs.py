"""The benchmarks of real recordings run, on a printer's session that needs no real data."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.app.demonstration import example
from tests.benchmarks import arrival, real, sweep


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a folder of one recording of the package's example, short."""
    place = tmp_path / "contract" / "gearbox"
    place.mkdir(parents=True)
    for name in ("robot.toml", "recording.toml"):
        shutil.copy(example("gearbox") / name, place / name)
    lines = (example("gearbox") / "recording.csv").read_text(encoding="utf-8").splitlines(keepends=True)
    (place / "recording.csv").write_text("".join(lines[:121]), encoding="utf-8")
    return place


@pytest.mark.walk
def test_every_recording_is_swept_in_a_process_of_its_own(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kept = folder.parent / "kept.jsonl"
    code = sweep.main([str(folder.parent), "--jobs", "1", "--kept", str(kept)])
    said = capsys.readouterr().out
    assert code == 0, said
    assert "3 recordings and halves, 0 break a bound" in said
    assert "of 1 larger recordings 0 are predicted worse" in said
    assert len(kept.read_text().splitlines()) == 3


def test_what_breaks_a_bound_is_told() -> None:
    fine = {"code": 0, "cpu": 3.0, "MiB": 90.0, "kind": "position", "rows": 30, "verdict": "adequate"}
    done = {
        ("a/b/c/slow.csv", "whole"): fine | {"cpu": 61.0},
        ("a/b/c/large.csv", "whole"): fine | {"MiB": 1100.0},
        ("a/b/c/refused.csv", "whole"): {"code": 3, "cpu": 1.0, "MiB": 50.0, "message": "too few"},
        ("a/b/c/broken.csv", "whole"): {"code": 1, "message": "KeyError: 3", "broken": True},
        ("a/b/c/flat.csv", "whole"): fine | {"gradient": 0.3, "tolerance": 0.01},
        ("a/b/c/small.csv", "half"): fine | {"errors": [1.0, 0.9]},
        ("a/b/c/large.csv", "half"): fine | {"rows": 99, "errors": [1.0, 1.1]},
    }
    said = "\n".join(sweep.told(done))
    for words in ("61 s of CPU", "1100 MiB", "refused (exit 3): too few", "exit 1: KeyError: 3", "gain 3.0e-01"):
        assert words in said
    assert "4 break a bound" in said
    assert "position, fewer than 60 readings: error to geometry's 0.900" in said
    assert "of 1 larger recordings 1 are predicted worse" in said


def test_sizes_scatter_by_what_is_told() -> None:
    rng = np.random.default_rng(3)
    blocks = [[v, 0.1] for v in 1 + 0.2 * rng.standard_normal(40)]
    _, said = real.scatter("a", {"blocks": 40, "sizes": [{"name": "x", "whole": [1.0, 0.02], "blocks": blocks}]})
    times = float(said.partition("scatter by ")[2].split()[0])
    assert times == pytest.approx(2.0, rel=0.3)


@pytest.mark.walk
def test_halves_and_blocks_are_printed(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert real.main(["halves", str(folder), "--halves", "1", "--jobs", "1"]) == 0
    assert "mean of 1 halves" in capsys.readouterr().out
    assert real.main(["blocks", str(folder), "--rows", "60", "--jobs", "1"]) == 0
    said = capsys.readouterr().out
    assert "2 blocks" in said


@pytest.mark.walk
def test_problems_are_kept_with_their_seed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kept = ["--jobs", "1", "--starts", "1", "--kept", str(tmp_path / "kept.jsonl")]
    arrival.main(["--problems", "2", *kept])
    seed = capsys.readouterr().out.partition("seed ")[2].partition(":")[0]
    arrival.main(["--problems", "3", *kept])
    assert f"seed {seed}:" in capsys.readouterr().out
