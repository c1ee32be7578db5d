"""Many jobs by some processes, in sittings: what is done is kept, and a run that was ended goes on where it stopped.

A job is a tuple that says all that there is to do; what comes of it a dictionary that JSON can hold. Each is a line of
the file of ``--kept`` as soon as it is done, with the seconds of CPU that it took. Ctrl-C, a signal to end and
``--minutes`` end a sitting with what is done; a job that raised is told, and is done again in the next one.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import signal
import sys
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from multiprocessing import Pipe, Process
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any

from threadpoolctl import threadpool_limits

Job = tuple[Any, ...]
Entry = dict[str, Any]
Examine = Callable[[Any], Entry]

EVERY_S = 60.0  # from one line of progress to the next where no one looks at a terminal
INTERRUPTED, FAILED = 130, 1  # exit codes


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add what all benchmarks of many jobs let one say."""
    parser.add_argument("--jobs", type=int, default=2, help="processes (default 2)")
    parser.add_argument("--minutes", type=float, default=math.inf, help="stop then; what is done is shown")
    parser.add_argument("--kept", type=Path, metavar="FILE", help="file of lines in which what is done is kept")


@dataclass
class Sitting:
    """What came of jobs, in their order; of those that raised the end of the trace, and whether it was broken off."""

    done: dict[Job, Entry] = field(default_factory=dict)
    seconds: dict[Job, float] = field(default_factory=dict)
    failed: dict[Job, str] = field(default_factory=dict)
    interrupted: bool = False

    @property
    def code(self) -> int:
        """The exit code."""
        return INTERRUPTED if self.interrupted else FAILED if self.failed else 0


def kept(path: Path | None) -> tuple[dict[Job, Entry], dict[Job, float]]:
    """Return what a file holds of earlier sittings, and the seconds each took; a last line cut short is none."""
    done: dict[Job, Entry] = {}
    seconds: dict[Job, float] = {}
    if path is None or not path.exists():
        return done, seconds
    for line in path.read_text(encoding="utf-8").splitlines(keepends=True):
        if line.endswith("\n"):
            match json.loads(line):
                case [list(job), dict(entry), float(spent)]:
                    done[_frozen(job)], seconds[_frozen(job)] = entry, spent
                case _:
                    raise SystemExit(f"{path} holds no lines of jobs: it is of another program, or of before.")
    return done, seconds


def sit(
    examine: Examine, jobs: Sequence[Job], given: argparse.Namespace, told: Callable[[Entry], str] | None = None
) -> Sitting:
    """Do the jobs that are not done yet.

    Parameters
    ----------
    examine : callable
        Returns what comes of a job; a function of a module where there are several processes.
    given : namespace
        With what `add_options` adds.
    told : callable, optional
        Says of what came of a job what is shown at once.
    """
    every, spent = kept(given.kept)
    left = [job for job in jobs if job not in every]
    found, end = Sitting(), time.monotonic() + 60 * given.minutes
    progress = _Progress(len(jobs), len(jobs) - len(left))
    with _ending(), _lines(given.kept) as write:
        ended = _by_processes(examine, left, given.jobs, end) if given.jobs > 1 else _here(examine, left, end)
        try:
            for job, entry, seconds, trace in ended:
                if entry is None:
                    found.failed[job] = trace
                else:
                    every[job], spent[job] = entry, seconds
                    write([job, entry, round(seconds, 3)])
                progress.step("" if told is None or entry is None else told(entry))
        except KeyboardInterrupt:
            found.interrupted = True
        finally:
            ended.close()
    progress.end()
    found.done = {job: every[job] for job in jobs if job in every}
    found.seconds = {job: spent[job] for job in found.done}
    for job, trace in found.failed.items():
        print(f"failed: {json.dumps(job)}\n{trace}", file=sys.stderr)
    return found


def wilson(hits: int, count: int) -> tuple[float, float]:
    """Return the 95 % interval of a share (Wilson 1927)."""
    if not count:
        return 0.0, 1.0
    z, p = 1.96, hits / count
    middle, half = p + z**2 / (2 * count), z * math.sqrt(p * (1 - p) / count + z**2 / (4 * count**2))
    return max(middle - half, 0.0) / (1 + z**2 / count), (middle + half) / (1 + z**2 / count)


def _frozen(value: Any) -> Any:
    return tuple(map(_frozen, value)) if isinstance(value, list) else value


# ------------------------------------------------------------------------------------------------------- how it is done

Ended = tuple[Job, Entry | None, float, str]  # a job, what came of it, its seconds of CPU, the end of a trace


def _once(examine: Examine, job: Job) -> Ended:
    begin = time.process_time()
    try:
        entry = examine(job)
    except Exception:
        return job, None, 0.0, "".join(traceback.format_exc().splitlines(keepends=True)[-3:])
    return job, entry, time.process_time() - begin, ""


def _here(examine: Examine, jobs: Sequence[Job], end: float) -> Iterator[Ended]:
    with threadpool_limits(1):
        for job in jobs:
            if time.monotonic() > end:
                return
            yield _once(examine, job)


class _Worker:
    """A process that does one job after the other; it ends with the pipe, however whoever holds its other end does."""

    def __init__(self, examine: Examine) -> None:
        self.pipe, theirs = Pipe()
        self._process = Process(target=_work, args=(examine, theirs), daemon=True)
        self._process.start()
        theirs.close()
        self.job: Job = ()

    def begin(self, job: Job) -> None:
        self.job = job
        self.pipe.send(job)

    def ended(self) -> Ended | None:
        """Return what came of the job; None where the process died of it."""
        try:
            found: Ended = self.pipe.recv()
        except (EOFError, OSError):
            return None
        return found

    def close(self) -> None:
        self.pipe.close()
        self._process.terminate()
        self._process.join(1.0)
        self._process.kill()  # where it was so young that it had not yet learned to end
        self._process.join()


def _work(examine: Examine, pipe: Connection) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # whoever sits at the terminal ends the whole, not each part
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    with threadpool_limits(1):
        while True:
            try:
                job = pipe.recv()
            except EOFError:
                return
            pipe.send(_once(examine, job))


def _by_processes(examine: Examine, jobs: Sequence[Job], count: int, end: float) -> Iterator[Ended]:
    left = iter(jobs)
    busy: list[_Worker] = []

    def next_of(worker: _Worker | None) -> None:
        """Give a worker, or a new one, what is next, or nothing more."""
        job = next(left, None) if time.monotonic() < end else None
        if job is not None:
            worker = worker or _Worker(examine)
            busy.append(worker)
            worker.begin(job)
        elif worker is not None:
            worker.close()

    try:
        for _ in range(count):
            next_of(None)
        while busy:
            for pipe in wait([w.pipe for w in busy]):
                worker = next(w for w in busy if w.pipe is pipe)
                busy.remove(worker)
                found = worker.ended()
                if found is None:
                    worker.close()
                    next_of(None)
                else:
                    next_of(worker)
                yield found or (worker.job, None, 0.0, "its process died\n")
    finally:
        for worker in busy:
            worker.close()


@contextmanager
def _lines(path: Path | None) -> Iterator[Callable[[Any], None]]:
    """Open a file for further lines, without one that was cut short."""
    if path is None:
        yield lambda value: None
        return
    if path.exists() and not (text := path.read_bytes()).endswith(b"\n"):
        os.truncate(path, text.rfind(b"\n") + 1)
    with path.open("a", encoding="utf-8") as file:

        def write(value: Any) -> None:
            file.write(json.dumps(value) + "\n")
            file.flush()

        yield write


@contextmanager
def _ending() -> Iterator[None]:
    """Take a signal to end as Ctrl-C."""

    def end(*_: object) -> None:
        raise KeyboardInterrupt

    try:
        before = signal.signal(signal.SIGTERM, end)
    except ValueError:  # not in the main thread, which alone gets signals
        yield
        return
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


class _Progress:
    """How many jobs are done, and for how long there is still to do."""

    def __init__(self, total: int, done: int) -> None:
        self._total, self._done, self._own = total, done, 0
        self._begin = self._last = time.monotonic()

    def step(self, text: str) -> None:
        self._done, self._own, now = self._done + 1, self._own + 1, time.monotonic()
        if text:
            print(text, file=sys.stderr, flush=True)
        terminal = sys.stderr.isatty()
        if terminal or now - self._last > EVERY_S or self._done == self._total:
            self._last = now
            minutes = (now - self._begin) / self._own * (self._total - self._done) / 60
            words = f"{self._done} of {self._total}, some {minutes:.0f} min left"
            print(f"\r{words}   " if terminal else words, end="" if terminal else "\n", file=sys.stderr, flush=True)

    def end(self) -> None:
        if sys.stderr.isatty():
            print(file=sys.stderr)
