"""Tasks on executors: the same results whatever does the work, nothing lost when it stops."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from deltacal_gen import InputError, execution
from deltacal_gen.errors import BadValue, FileNotReadable
from deltacal_gen.execution import Task, content_key, run

ROOT = Path(__file__).resolve().parents[2]
PATIENCE_S = 300.0  # before a test that waits for something gives up: no measure of speed


def square(n: int) -> dict[str, Any]:
    return {"n": n, "square": n * n}


def refuse(n: int) -> dict[str, Any]:
    if n == 2:
        raise BadValue("two cannot be squared.", "Take three.")
    if n == 3:
        raise ZeroDivisionError("three")
    return square(n)


def die_once(n: int, marker: str) -> dict[str, Any]:
    """End the worker the first time that anybody meets task 1."""
    if n == 1 and not Path(marker).exists():
        Path(marker).touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return square(n)


def die_always(n: int) -> dict[str, Any]:
    if n == 1:
        os.kill(os.getpid(), signal.SIGKILL)
    return square(n)


def slowly(n: int) -> dict[str, Any]:
    time.sleep(0.3)
    return square(n)


def numbered(count: int, *more: Any) -> Iterator[Task]:
    for n in range(count):
        yield Task(content_key("square", n, *more), str(n), lambda n=n: (n, *more))  # type: ignore[misc]


def squares(outcomes: Any) -> list[int | None]:
    return [None if o.result is None else o.result["square"] for o in outcomes]


@pytest.mark.parametrize("workers", [1, 2])
def test_outcomes_come_in_the_order_of_the_tasks(workers: int) -> None:
    told: list[int] = []
    found = run(square, numbered(20), workers=workers, told=lambda done, total, label: told.append(done))
    assert squares(found) == [n * n for n in range(20)]
    assert told == list(range(1, 21))


@pytest.mark.parametrize("workers", [1, 2])
def test_what_fails_is_told_and_does_not_stop_the_rest(workers: int) -> None:
    found = list(run(refuse, numbered(5), workers=workers))
    assert squares(found) == [0, 1, None, None, 16]
    assert found[2].error == "two cannot be squared. Take three."
    assert found[3].error == "ZeroDivisionError: three"


def test_what_is_done_is_not_done_again_and_a_workers_failure_is(tmp_path: Path) -> None:
    list(run(refuse, numbered(5), workers=1, directory=tmp_path))
    again = list(run(square, numbered(5), workers=1, directory=tmp_path))
    assert squares(again) == [0, 1, None, 9, 16]  # the input's failure is a result; the other is tried again
    assert not list(tmp_path.rglob("*.[0-9]*")), "nothing half-written is left"


def test_a_result_that_was_cut_off_is_made_again(tmp_path: Path) -> None:
    list(run(square, numbered(2), workers=1, directory=tmp_path))
    file = next((tmp_path / "tasks").rglob("*.json"))
    file.write_text(file.read_text()[:5])
    assert squares(run(square, numbered(2), workers=1, directory=tmp_path)) == [0, 1]
    assert json.loads(file.read_text())["error"] is None


def test_a_killed_worker_loses_nothing(tmp_path: Path) -> None:
    marker = str(tmp_path / "killed")
    found = list(run(die_once, numbered(8, marker), workers=2))
    assert Path(marker).exists()
    assert squares(found) == [n * n for n in range(8)]


@pytest.mark.walk
def test_a_task_that_ends_every_worker_fails_alone() -> None:
    found = list(run(die_always, numbered(6), workers=2))
    assert squares(found) == [0, None, 4, 9, 16, 25]
    assert "worker ended" in str(found[1].error)


@pytest.mark.filterwarnings("ignore:.*still being processed")  # joblib says so when nobody waits for the rest
def test_no_more_arguments_are_made_than_the_workers_need() -> None:
    made: list[int] = []

    def arguments(n: int) -> tuple[int]:
        made.append(n)
        return (n,)

    outcomes = run(slowly, [Task(content_key(n), str(n), partial(arguments, n)) for n in range(60)], workers=2)
    next(outcomes)
    assert len(made) <= 4 + 16
    outcomes.close()  # type: ignore[attr-defined]


def one_slow(n: int, folder: str, others: int) -> dict[str, Any]:
    """Take as long, for task 0, as it takes until so many others have been done; they leave a mark in the folder."""
    until = time.monotonic() + PATIENCE_S
    while n == 0 and len(os.listdir(folder)) < others and time.monotonic() < until:
        time.sleep(0.005)
    if n:
        (Path(folder) / str(n)).touch()
    return square(n)


@pytest.mark.parametrize("kept", [False, True])
def test_a_long_task_holds_up_nobody_and_what_has_ended_is_kept_at_once(kept: bool, tmp_path: Path) -> None:
    marks, directory, count = tmp_path / "marks", tmp_path / "run", 40
    marks.mkdir()
    ended: list[str] = []
    files: list[int] = []

    def told(done: int, total: int, label: str) -> None:
        assert (done, total) == (len(ended) + 1, count)
        ended.append(label)
        files.append(len(list(directory.rglob("*.json"))))

    tasks = numbered(count, str(marks), count - 1)
    outcomes = run(one_slow, tasks, workers=2, directory=directory if kept else None, told=told)
    assert squares(outcomes) == [n * n for n in range(count)]
    assert ended[-1] == "0"
    assert files == (list(range(1, count + 1)) if kept else [0] * count)


def test_a_task_whose_files_have_gone_fails_alone() -> None:
    def gone() -> tuple[Any, ...]:
        raise FileNotReadable("cannot be read.", "Look at the file.")

    for workers in (1, 2):
        found = list(run(square, [*numbered(2), Task("x", "gone", gone)], workers=workers))
        assert squares(found) == [0, 1, None]
        assert "cannot be read" in str(found[2].error)


@pytest.mark.filterwarnings("ignore:.*still being processed", "ignore:.*not used")
def test_a_directory_that_cannot_be_written_is_said(tmp_path: Path) -> None:
    (tmp_path / "tasks").write_text("a file")
    for workers in (1, 2):
        with pytest.raises(InputError, match="cannot be made"):
            list(run(square, numbered(3), workers=workers, directory=tmp_path))
    (tmp_path / "tasks").unlink()
    (tmp_path / "tasks").mkdir()
    for start in "0123456789abcdef":
        for more in "0123456789abcdef":
            (tmp_path / "tasks" / (start + more)).write_text("a file")
    for workers in (1, 2):
        with pytest.raises(InputError, match="the file cannot be written"):
            list(run(square, numbered(3), workers=workers, directory=tmp_path))


def forever(n: int, folder: str) -> dict[str, Any]:
    (Path(folder) / f"{os.getpid()}.pid").touch()
    time.sleep(600)
    return square(n)


def ended(process: int) -> bool:
    """Tell whether a process is gone, or dead and not yet fetched by who inherited it."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] in "ZX"
    except OSError:
        return True


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.parametrize("stop", [signal.SIGKILL, signal.SIGINT])
def test_workers_end_with_the_process_that_has_started_them(tmp_path: Path, stop: signal.Signals) -> None:
    # a job that a shell starts in the background ignores Ctrl-C, and so would what it starts
    heard = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    tasks = f"t.numbered(4, {str(tmp_path)!r})"
    code = f"{heard}\nfrom tests.app import test_execution as t\nlist(t.run(t.forever, {tasks}, workers=2))"
    here = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), *sys.path])}
    process = subprocess.Popen([sys.executable, "-c", code], env=here, stderr=subprocess.PIPE)
    until = time.monotonic() + PATIENCE_S
    while len(found := list(tmp_path.glob("*.pid"))) < 2 and time.monotonic() < until:
        time.sleep(0.02)
    process.send_signal(stop)
    _, said = process.communicate(timeout=PATIENCE_S)
    while not all(ended(int(f.stem)) for f in found) and time.monotonic() < until:
        time.sleep(0.02)
    assert len(found) == 2
    assert all(ended(int(f.stem)) for f in found)
    # of this process may speak its own interruption, and the pool's thread that loses its pipes in the same moment
    assert said.count(b"Traceback") <= 1 + said.count(b"Exception in thread"), "workers say nothing"
    assert b"Process " not in said, "workers say nothing"


# ------------------------------------------------------------------------------------------------------------ a cluster


def test_an_address_without_a_scheduler_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("distributed", reason="Dask is not installed")
    monkeypatch.setattr(execution, "CONNECT_S", 0.5)  # nobody answers, however long it is waited
    list(run(square, numbered(2), workers=1, directory=tmp_path))
    with pytest.raises(InputError, match=r"no scheduler answers at tcp://127\.0\.0\.1:9"):
        list(run(square, numbered(4), cluster="tcp://127.0.0.1:9", directory=tmp_path))
    with pytest.raises(InputError, match="'nonsense' is no address"):
        list(run(square, numbered(4), cluster="nonsense"))
    assert len(list((tmp_path / "tasks").rglob("*.json"))) == 2


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    """A scheduler on the loopback interface with two workers, each one process of one thread."""
    pytest.importorskip("distributed", reason="Dask is not installed")
    here = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), *sys.path])}
    dask = [sys.executable, "-m", "dask"]
    quiet: dict[str, Any] = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "env": here, "cwd": tmp_path}
    told = tmp_path / "scheduler.json"
    scheduler = subprocess.Popen(
        [*dask, "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", str(told)],
        **quiet,
    )
    workers = []
    try:
        for _ in range(300):
            if told.exists() and told.read_text().strip().endswith("}"):
                break
            time.sleep(0.1)
        address = json.loads(told.read_text())["address"]
        workers = [
            subprocess.Popen([*dask, "worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard"], **quiet)
            for _ in range(2)
        ]
        from distributed import Client

        with Client(address, timeout=20, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=60)
        yield address, workers
    finally:
        for process in (*workers, scheduler):
            process.kill()
            process.wait()


def test_a_cluster_gives_what_local_workers_give_though_one_is_killed(
    cluster: tuple[str, list[subprocess.Popen[bytes]]],
) -> None:
    address, workers = cluster
    found = []
    for outcome in run(slowly, numbered(16), cluster=address):
        found.append(outcome)
        if len(found) == 3:
            workers[0].kill()
    assert squares(found) == [n * n for n in range(16)]


def test_what_no_task_did_is_raised_and_not_tried_for_ever() -> None:
    def broken(jobs: Iterator[Any]) -> Iterator[Any]:
        raise OSError("no room for workers")
        yield from jobs

    with pytest.raises(OSError, match="no room for workers"):
        next(execution._ended(square, {0: Task("key", "one", lambda: (1,))}, broken))
