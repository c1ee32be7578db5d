"""Many independent tasks on the workers of joblib: what is done is kept, and workers change no result.

A task is a module's function and arguments that can be pickled; its result is JSON. Its key is a hash of all that the
result depends on, so that a run directory holds each result once, can be stopped, copied and resumed anywhere. Random
numbers belong to the task, not to the worker.
"""

from __future__ import annotations

import functools
import hashlib
import json
import os
import threading
import time
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import closing, contextmanager, nullcontext, suppress
from pathlib import Path
from typing import Any, NamedTuple

import deltacal_kernels

from deltacal_gen.errors import Cluster, DeltacalError, MissingLibrary
from deltacal_gen.files.writing import make_folder, write_files
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.results.base import Json

CONNECT_S = 5.0  # for a scheduler to answer
WATCH_S = 0.5  # after which a worker notices that the process which has started it is gone

Told = Callable[[int, int, str], None]
Function = Callable[..., Json]
Ended = Generator[tuple[int, "Outcome"], None, None]  # behind the numbers of their tasks
Pool = Callable[[Iterable[Any]], Ended]  # does jobs of joblib


class Task(NamedTuple):
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


class Outcome(NamedTuple):
    """What became of a task: its result, or in words why there is none; `final` where it would be so another time."""

    key: str
    label: str
    result: Json | None
    error: str | None = None
    final: bool = False


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


class Store:
    """Results by key, each a file that is complete or not there."""

    def __init__(self, directory: Path) -> None:
        self.folder = directory / "tasks"  # and in it 256 folders: 10^5 files in one are slow on network drives
        make_folder(self.folder)

    def get(self, key: str, label: str = "") -> Outcome | None:
        """Return the outcome of a task that was done, or None."""
        try:
            data = json.loads(self._file(key).read_text(encoding="utf-8"))
        except (OSError, json.JSONDecodeError):
            return None
        return Outcome(key, label, data["result"], data["error"], final=True)

    def put(self, outcome: Outcome) -> None:
        """Keep an outcome."""
        file = self._file(outcome.key)
        with suppress(OSError):  # which says itself, as the file cannot be written
            file.parent.mkdir(exist_ok=True)
        write_files({file: json.dumps({"result": outcome.result, "error": outcome.error})})

    def _file(self, key: str) -> Path:
        return self.folder / key[:2] / f"{key}.json"


def run(
    function: Function,
    tasks: Iterable[Task],
    *,
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
        Their arguments are asked for as workers become free.
    workers : int, optional
        Local processes; default one per core, and with 1 everything is done in this process.
    cluster : str, optional
        Address of a Dask scheduler, ``tcp://HOST:PORT``, instead of local processes.
    directory : path, optional
        Results are kept there as they end, and not made again. A failure of the input is a result; one of a worker is
        tried again by the next run.
    told : callable
        Called with tasks done, how many there are and the label of the one that has just ended.

    Raises
    ------
    InputError
        No scheduler answers at `cluster`, or the directory cannot be written.
    """
    store, every = None if directory is None else Store(Path(directory)), list(tasks)
    early: dict[int, Outcome] = {}  # of tasks that have ended before their turn
    left = {n: task for n, task in enumerate(every) if store is None or store.get(task.key) is None}
    with _pool(workers, cluster) as pool, closing(_ended(function, left.copy(), pool)) as ended:
        for at, task in enumerate(every):
            while at in left and at not in early:
                number, outcome = next(ended)
                if store is not None and outcome.final:
                    store.put(outcome)
                early[number] = outcome
                told(at + len(early), len(every), outcome.label)
            if at not in left:
                told(at + len(early) + 1, len(every), task.label)
            found = early.pop(at, None) or (None if store is None else store.get(task.key, task.label))
            yield found or Outcome(task.key, task.label, None, "a result that was there is gone: run again")


def _ended(function: Function, left: dict[int, Task], pool: Pool, alone: bool = False) -> Ended:
    """Yield outcomes as tasks end, behind their numbers.

    A worker that ends takes the pool with it; over which of the tasks in flight it ended is not known: each of them is
    done again alone.
    """
    while left:
        begun: list[int] = []
        with closing(pool(_jobs(function, list(left.items()), begun))) as results:
            try:
                for number, outcome in results:
                    del left[number]
                    yield number, outcome
            except Exception as error:  # of a worker that ended: loky, Dask and pickle each have classes of their own
                lost = [n for n in begun if n in left]
                if not lost:
                    raise  # no task's doing: trying again would not end
                if alone:
                    number, task = left.popitem()
                    words = f"its worker ended, out of memory or killed: {type(error).__name__}: {error}"
                    yield number, Outcome(task.key, task.label, None, words.partition(". ")[0])
                for number in () if alone else lost:
                    yield from _ended(function, {number: left.pop(number)}, pool, alone=True)


def _jobs(function: Function, tasks: list[tuple[int, Task]], begun: list[int]) -> Iterator[Any]:
    """Yield what workers are handed; of a task whose arguments, such as a file, cannot be had, that."""
    from joblib import delayed

    for number, task in tasks:
        begun.append(number)
        try:
            yield delayed(_attempt)(number, Outcome(task.key, task.label, None), function, task.arguments())
        except DeltacalError as error:
            yield delayed(tuple)((number, Outcome(task.key, task.label, None, str(error))))


def _attempt(number: int, of: Outcome, function: Function, arguments: tuple[Any, ...]) -> tuple[int, Outcome]:
    """Return what became of a task, behind its number; runs on the worker."""
    try:
        with using(Backend.COMPILED):
            return number, of._replace(result=function(*arguments), final=True)
    except Exception as error:  # one recording must not end a fleet's night
        of_input = isinstance(error, DeltacalError)
        return number, of._replace(error=str(error) if of_input else f"{type(error).__name__}: {error}", final=of_input)


@contextmanager
def _pool(workers: int | None, cluster: str | None) -> Iterator[Pool]:
    """Yield what does jobs of joblib, and yields their results as they end."""
    from joblib import Parallel, parallel_config

    client = None if cluster is None else _client(cluster)
    how: dict[str, Any] = {"backend": "dask", "client": client}
    if client is None:  # a core to each worker: matrices are small, threads of linear algebra wait for one another
        how = {"backend": "loky", "inner_max_num_threads": 1, "initializer": _end_with, "initargs": (os.getpid(),)}
    count = -1 if client is not None or workers is None else workers

    def done(jobs: Iterable[Any]) -> Any:
        with parallel_config(**how):
            return Parallel(count, return_as="generator_unordered", batch_size=1, max_nbytes=None)(jobs)

    with client or nullcontext():
        yield done


def _end_with(parent: int) -> None:
    """Begin a worker, which ends when the process that has started it does."""

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(WATCH_S)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def _client(address: str) -> Any:
    """Return a client of the Dask scheduler at an address."""
    try:
        from distributed import Client
    except ImportError:
        remedy = "pip install 'deltacal_gen[cluster]', or leave --cluster out."
        raise MissingLibrary("a cluster needs Dask, which is not installed.", remedy) from None
    if "://" not in address:
        raise Cluster(f"'{address}' is no address of a scheduler.", "Give tcp://HOST:PORT.")
    try:
        return Client(address, timeout=CONNECT_S, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise Cluster(
            f"no scheduler answers at {address} within {CONNECT_S:g} s ({type(error).__name__}).",
            "Start one (dask scheduler), or give its address: tcp://HOST:PORT. What was done before is kept.",
        ) from None
