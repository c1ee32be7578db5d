"""Jobs of several processes: all are done once, what is done is kept, and nothing that ends a part ends the whole."""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from tests.benchmarks import sitting

ROOT = Path(__file__).resolve().parents[2]


def how(*words: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    sitting.add_options(parser)
    return parser.parse_args(words)


def square(job: tuple[str, int]) -> dict[str, Any]:
    what, k = job
    if what == "raises":
        raise ValueError("no square of this")
    if what == "dies":
        os.kill(os.getpid(), signal.SIGKILL)
    if what == "slow":
        time.sleep(0.3)
    return {"square": k * k, "process": os.getpid(), "threads": os.environ.get("OPENBLAS_NUM_THREADS")}


def test_jobs_are_done_by_several_processes_and_kept(tmp_path: Path) -> None:
    kept = tmp_path / "kept.jsonl"
    jobs = [("slow", k) for k in range(6)]
    found = sitting.sit(square, jobs, how("--jobs", "3", "--kept", str(kept)))
    assert list(found.done) == jobs
    assert [e["square"] for e in found.done.values()] == [k * k for k in range(6)]
    assert len({e["process"] for e in found.done.values()} - {os.getpid()}) == 3
    assert {e["threads"] for e in found.done.values()} == {"1"}
    assert found.code == 0
    again = sitting.sit(square, [*jobs, ("fast", 9)], how("--kept", str(kept)))
    assert {job: again.done[job] for job in jobs} == found.done
    assert len(kept.read_text().splitlines()) == 7


@pytest.mark.parametrize("processes", ["1", "2"])
def test_a_job_that_raises_ends_no_other(processes: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kept = tmp_path / "kept.jsonl"
    jobs = [("raises", 1), ("fast", 2), ("fast", 3)]
    found = sitting.sit(square, jobs, how("--jobs", processes, "--kept", str(kept)))
    assert list(found.done) == jobs[1:]
    assert found.code == sitting.FAILED
    assert "no square of this" in capsys.readouterr().err
    assert len(kept.read_text().splitlines()) == 2  # what failed is tried again


def test_a_process_that_dies_ends_no_other_job() -> None:
    jobs = [("dies", 1), ("fast", 2), ("dies", 3), ("fast", 4)]
    found = sitting.sit(square, jobs, how("--jobs", "2"))
    assert list(found.done) == [("fast", 2), ("fast", 4)]
    assert set(found.failed) == {("dies", 1), ("dies", 3)}


def test_no_job_is_begun_after_the_time() -> None:
    for processes in ("1", "2"):
        assert not sitting.sit(square, [("fast", 1)], how("--jobs", processes, "--minutes", "-1")).done


def test_a_line_cut_short_is_done_again(tmp_path: Path) -> None:
    kept = tmp_path / "kept.jsonl"
    kept.write_text(json.dumps([["fast", 5], {"square": 25}, 0.1]) + '\n[["fast", 6], {"squ')
    found = sitting.sit(square, [("fast", 5), ("fast", 6)], how("--jobs", "1", "--kept", str(kept)))
    assert [e["square"] for e in found.done.values()] == [25, 36]
    assert len(list(map(json.loads, kept.read_text().splitlines()))) == 2


def test_a_file_of_another_program_is_left_alone(tmp_path: Path) -> None:
    kept = tmp_path / "kept.jsonl"
    kept.write_text('{"kind": "null", "seed": [21, 2, 0]}\n')
    with pytest.raises(SystemExit, match="no lines of jobs"):
        sitting.sit(square, [("fast", 5)], how("--kept", str(kept)))
    assert len(kept.read_text().splitlines()) == 1


@pytest.mark.skipif(sys.platform != "linux", reason="signals as Linux has them")
def test_a_signal_to_end_leaves_what_is_done_and_no_process(tmp_path: Path) -> None:
    kept = tmp_path / "kept.jsonl"
    text = (
        "from tests.benchmarks import sitting, test_sitting as t\n"
        f"found = sitting.sit(t.square, [('slow', k) for k in range(100)], t.how('--kept', {str(kept)!r}))\n"
        "print(len(found.done), found.code)"
    )
    with subprocess.Popen([sys.executable, "-c", text], cwd=ROOT, stdout=subprocess.PIPE, text=True) as run:
        while not kept.exists() or len(kept.read_text().splitlines()) < 2:
            time.sleep(0.05)
        run.send_signal(signal.SIGTERM)
        out = run.communicate(timeout=20)[0].split()
    assert int(out[0]) == len(kept.read_text().splitlines())
    assert int(out[1]) == sitting.INTERRUPTED
    workers = {entry["process"] for _, entry, _ in map(json.loads, kept.read_text().splitlines())}
    assert not [pid for pid in workers if Path(f"/proc/{pid}").exists()]
