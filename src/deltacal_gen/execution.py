"""Many independent tasks on any executor: what is done is kept, what fails is listed, and workers change no result.

A task is a module's function and arguments that can be pickled; its result is JSON. Its key is a hash of all that the
result depends on, so that a run directory holds each result once, can be stopped, copied and resumed anywhere. Random
numbers belong to the task, not to the worker. No more tasks are in flight than keep the workers busy.
"""

from __future__ import annotations

import concurrent.futures
import functools
import hashlib
import json
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import deltacal_kernels

from deltacal_gen.errors import DeltacalError, InputError
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.results.base import Json

AHEAD = 2  # tasks in flight per worker: one at work, one waiting
HELD = 8  # results per worker that wait in memory for an earlier one
LIVES = 3  # workers that may end over one task before it counts as failed
CONNECT_S = 5.0  # for a scheduler to answer
FOLDER = "tasks"

Told = Callable[[int, int, str], None]


@dataclass(frozen=True)
class Task:
    """What is to be done.

    Attributes
    ----------
    key : str
        Hash of all that the result depends on; see `content_key`.
    label : str
        For people.
    arguments : callable
        Returns the function's arguments when the task's turn comes, so that what waits takes no memory.
    """

    key: str
    label: str
    arguments: Callable[[], tuple[Any, ...]]


@dataclass(frozen=True)
class Outcome:
    """What became of a task: its result, or in words why there is none."""

    key: str
    label: str
    result: Json | None
    error: str | None = None


@dataclass(frozen=True)
class Attempt:
    """What a worker says of a task: its result or what went wrong, and whether that would be so another time too."""

    result: Json | None
    error: str | None
    kept: bool

    @classmethod
    def failed(cls, error: str, *, kept: bool = False) -> Attempt:
        """Return an attempt that has no result."""
        return cls(None, error, kept)


@functools.cache
def code_digest() -> str:
    """Return a hash of this package and of its kernels: what other code has made is not taken for done."""
    digest = hashlib.sha256()
    for root in (Path(__file__).parent, Path(str(deltacal_kernels.__file__)).parent):
        for file in sorted(root.rglob("*.py")):
            digest.update(file.relative_to(root).as_posix().encode() + file.read_bytes())
    return digest.hexdigest()


def content_key(*parts: object) -> str:
    """Return a hash of JSON-like parts and bytes, and of the code."""
    digest = hashlib.sha256(code_digest().encode())
    for part in parts:
        data = part if isinstance(part, bytes) else json.dumps(part, sort_keys=True, default=str).encode()
        digest.update(len(data).to_bytes(8, "big") + data)
    return digest.hexdigest()[:32]


def run(
    function: Callable[..., Json],
    tasks: Iterable[Task],
    *,
    total: int,
    workers: int | None = None,
    cluster: str | None = None,
    directory: str | Path | None = None,
    told: Told = lambda done, total, label: None,
) -> Iterator[Outcome]:
    """Do tasks and yield their outcomes in the order of the tasks, whatever the order in which they end.

    Parameters
    ----------
    function : callable
        Of a module, so that a worker can import it.
    tasks : iterable of Task
        Read as workers become free.
    total : int
        How many there are, for the progress.
    workers : int, optional
        Local processes; default one per core, and with 1 everything is done in this process.
    cluster : str, optional
        Address of a Dask scheduler, ``tcp://HOST:PORT``, instead of local processes.
    directory : path, optional
        Results are kept there and not made again. A failure of the input is a result; one of a worker is tried again
        by the next run.
    told : callable
        Called with tasks done, `total` and the label of the one that has just ended.

    Raises
    ------
    InputError
        No scheduler answers at `cluster`, or the directory cannot be written.
    """
    store = None if directory is None else Store(Path(directory))
    with _pool(workers, cluster) as pool:
        yield from _Run(function, pool, store, total, told).outcomes(iter(tasks))


class Store:
    """Results by key, each a file that is complete or not there."""

    def __init__(self, directory: Path) -> None:
        self.folder = directory / FOLDER  # and in it 256 folders: 10^5 files in one are slow on network drives
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(f"cannot be made: {error.strerror}.", "Choose another folder.", file=directory) from None

    def get(self, key: str) -> Attempt | None:
        """Return what became of a task that was done, or None."""
        try:
            data = json.loads(self._file(key).read_text(encoding="utf-8"))
        except (OSError, json.JSONDecodeError):
            return None
        return Attempt(data["result"], data["error"], kept=True)

    def outcome(self, task: Task) -> Outcome | None:
        """Return the outcome of a task that was done, or None."""
        found = self.get(task.key)
        return None if found is None else Outcome(task.key, task.label, found.result, found.error)

    def has(self, key: str) -> bool:
        """Tell whether a task was done."""
        return self._file(key).exists()

    def put(self, outcome: Outcome) -> None:
        """Keep an outcome."""
        file = self._file(outcome.key)
        whole = file.with_suffix(f".{os.getpid()}")
        try:
            file.parent.mkdir(exist_ok=True)
            whole.write_text(json.dumps({"result": outcome.result, "error": outcome.error}), encoding="utf-8")
            whole.replace(file)
        except OSError as error:
            raise InputError(
                f"a result cannot be written: {error.strerror}.",
                "What was done before is kept; run again when there is room, or where it may be written.",
                file=self.folder,
            ) from None

    def _file(self, key: str) -> Path:
        return self.folder / key[:2] / f"{key}.json"


class _Processes(ProcessPoolExecutor):
    """Local processes that end when this one closes a pipe that they watch, or ends itself, however it does."""

    def __init__(self, count: int) -> None:
        context = multiprocessing.get_context("fork" if _alone() else "spawn")
        watched, self._held = context.Pipe(duplex=False)
        super().__init__(count, mp_context=context, initializer=_begin, initargs=(watched, self._held))

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End the processes at once, whatever they are doing, and the threads that served them."""
        self._held.close()
        super().shutdown(cancel_futures=True)


def _alone() -> bool:
    """Tell whether this process can be forked safely: no other thread, of Python or not, may hold a lock."""
    return sys.platform == "linux" and len(os.listdir("/proc/self/task")) == 1


def _begin(watched: Connection, held: Connection) -> None:
    """Begin a worker: what the keyboard sends is for the process that has started it."""
    held.close()
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with, args=(watched,), daemon=True).start()


def _end_with(watched: Connection) -> None:
    try:
        watched.recv_bytes()
    except EOFError:
        os._exit(1)


@dataclass(frozen=True)
class _Pool:
    """An executor that can be made anew after its processes have ended."""

    make: Callable[[], Executor] | None
    width: int


@contextmanager
def _pool(workers: int | None, cluster: str | None) -> Iterator[_Pool]:
    if cluster is not None:
        with _dask(cluster) as pool:
            yield pool
        return
    count = workers if workers is not None else os.cpu_count() or 1
    if count <= 1:
        yield _Pool(None, 1)
        return
    # a core to each worker: matrices here are small, and threads of the linear algebra would only wait for one another
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    yield _Pool(lambda: _Processes(count), count)


@contextmanager
def _dask(address: str) -> Iterator[_Pool]:
    try:
        from distributed import Client
    except ImportError:
        raise InputError(
            "a cluster needs Dask, which is not installed.",
            "pip install 'deltacal_gen[cluster]', or leave --cluster out.",
        ) from None
    if "://" not in address:
        raise InputError(f"'{address}' is no address of a scheduler.", "Give tcp://HOST:PORT.")
    try:
        client = Client(address, timeout=CONNECT_S, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise InputError(
            f"no scheduler answers at {address} within {CONNECT_S:g} s ({type(error).__name__}).",
            "Start one (dask scheduler), or give its address: tcp://HOST:PORT. What was done before is kept.",
        ) from None
    try:
        width = sum(client.nthreads().values())
        yield _Pool(lambda: client.get_executor(pure=False), max(width, 1))
    finally:
        client.close()


def attempt(function: Callable[..., Json], arguments: tuple[Any, ...]) -> Attempt:
    """Return what became of a task; runs on the worker."""
    try:
        with using(Backend.COMPILED):
            return Attempt(function(*arguments), None, kept=True)
    except DeltacalError as error:
        return Attempt.failed(str(error), kept=True)
    except Exception as error:  # one recording must not end a fleet's night
        return Attempt.failed(f"{type(error).__name__}: {error}")


class _Line:
    """Tasks on their way: at work, to be tried again since their worker ended, or done before their turn."""

    def __init__(self, tasks: Iterator[Task], width: int, store: Store | None) -> None:
        self.flying: dict[Future[Attempt], tuple[int, Task]] = {}
        self.deaths: dict[str, int] = {}
        self._width, self._store = width, store
        self._upcoming, self._more = enumerate(tasks), True
        self._waiting: list[tuple[int, Task]] = []
        self._following = 0
        self._done: dict[int, Outcome] = {}
        self._kept: dict[int, Task] = {}  # done, and in the directory until its turn: a long task holds nobody up

    @property
    def empty(self) -> bool:
        return not self._more and not self._waiting

    def take(self) -> tuple[int, Task] | None:
        """Return the next task for a worker; None where nobody is free, or nothing is left to do.

        Whoever was at work when a worker ended is tried alone, so that nobody pays for another.
        """
        if len(self.flying) >= (1 if self._waiting else AHEAD * self._width):
            return None
        if self._waiting:
            return self._waiting.pop(0)
        if len(self._done) >= HELD * self._width:
            return None
        taken = next(self._upcoming, None)
        self._more = taken is not None
        return taken

    def try_again(self, tasks: Sequence[tuple[int, Task]]) -> None:
        self._waiting = sorted([*self._waiting, *tasks], key=lambda w: w[0])

    def end(self, number: int, task: Task, outcome: Outcome) -> None:
        if number != self._following and self._store is not None and self._store.has(task.key):
            self._kept[number] = task
        else:
            self._done[number] = outcome

    def due(self) -> Iterator[Outcome | Task]:
        """Yield what is done up to the first that is not; of what is in the directory, the task."""
        while (at := self._following) in self._done or at in self._kept:
            yield self._done.pop(at) if at in self._done else self._kept.pop(at)
            self._following += 1


class _Run:
    def __init__(
        self,
        function: Callable[..., Json],
        pool: _Pool,
        store: Store | None,
        total: int,
        told: Told,
    ) -> None:
        self.function, self.pool, self.store, self.total, self.told = function, pool, store, total, told
        self.ended = 0

    def outcomes(self, tasks: Iterator[Task]) -> Iterator[Outcome]:
        if self.pool.make is None:
            for task in tasks:
                yield self._known(task) or self._close(task, self._done_here(task))
            return
        yield from self._in_order(tasks)

    def _done_here(self, task: Task) -> Attempt:
        try:
            arguments = task.arguments()
        except DeltacalError as error:  # a file that has gone, or cannot be read
            return Attempt.failed(str(error))
        return attempt(self.function, arguments)

    def _known(self, task: Task) -> Outcome | None:
        outcome = None if self.store is None else self.store.outcome(task)
        if outcome is not None:
            self._tell(task.label)
        return outcome

    def _close(self, task: Task, said: Attempt) -> Outcome:
        outcome = Outcome(task.key, task.label, said.result, said.error)
        if self.store is not None and said.kept:
            self.store.put(outcome)
        self._tell(task.label)
        return outcome

    def _tell(self, label: str) -> None:
        self.ended += 1
        self.told(self.ended, self.total, label)

    def _in_order(self, tasks: Iterator[Task]) -> Iterator[Outcome]:
        """Keep the workers busy, and yield outcomes by the order of the tasks."""
        assert self.pool.make is not None
        executor, line = self.pool.make(), _Line(tasks, self.pool.width, self.store)
        try:
            while True:
                while (taken := line.take()) is not None:
                    number, task = taken
                    begun = self._begun(task, executor, again=task.key in line.deaths)
                    if isinstance(begun, Outcome):
                        line.end(number, task, begun)
                    else:
                        line.flying[begun] = (number, task)
                for due in line.due():
                    yield due if isinstance(due, Outcome) else self._kept(due)
                if not line.flying:
                    if line.empty:
                        return
                    continue
                ready, _ = concurrent.futures.wait(line.flying, return_when=concurrent.futures.FIRST_COMPLETED)
                lost: list[tuple[int, Task]] = []  # at work, or about to be, when a worker ended
                for future in ready:
                    number, task = line.flying.pop(future)
                    if (outcome := self._ended(task, future)) is None:
                        lost.append((number, task))
                    else:
                        line.end(number, task, outcome)
                if lost:
                    lost += line.flying.values()
                    line.flying.clear()
                    executor.shutdown(wait=False)
                    executor = self.pool.make()
                    line.try_again(self._survivors(lost, line))
        finally:
            for future in line.flying:
                future.cancel()
            executor.shutdown(wait=False)

    def _begun(self, task: Task, executor: Executor, *, again: bool) -> Future[Attempt] | Outcome:
        """Hand a task to a worker; return its outcome where it is known, or where its arguments cannot be had."""
        if not again and (known := self._known(task)) is not None:
            return known
        try:
            arguments = task.arguments()
        except DeltacalError as error:
            return self._close(task, Attempt.failed(str(error)))
        return executor.submit(attempt, self.function, arguments)

    def _ended(self, task: Task, future: Future[Attempt]) -> Outcome | None:
        """Return the outcome of a task that a worker had; None where the worker ended."""
        try:
            return self._close(task, future.result())
        except BrokenProcessPool:
            return None
        except DeltacalError:  # the directory cannot be written
            raise
        except Exception as error:  # of the cluster: a worker lost for good, a result that cannot travel
            return self._close(task, Attempt.failed(f"{type(error).__name__}: {error}"))

    def _kept(self, task: Task) -> Outcome:
        assert self.store is not None
        outcome = self.store.outcome(task)
        if outcome is None:
            raise InputError("a result that was there is gone.", "Run again.", file=self.store.folder)
        return outcome

    def _survivors(self, lost: list[tuple[int, Task]], line: _Line) -> list[tuple[int, Task]]:
        """Return the tasks to be tried again after a worker ended; which one ended it is not known."""
        left = []
        for number, task in lost:
            line.deaths[task.key] = line.deaths.get(task.key, 0) + 1
            if line.deaths[task.key] >= LIVES * AHEAD:
                words = "the worker ended every time: out of memory, or killed"
                line.end(number, task, self._close(task, Attempt.failed(words)))
            else:
                left.append((number, task))
        return left
