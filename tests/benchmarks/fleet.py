"""What tasks of studies and batches weigh, and what a second worker gains.

    python -m tests.benchmarks.fleet FOLDER [--machines 10000,50000,150000] [--measured]

FOLDER is one of machines, as ``deltacal batch`` takes it. Every task is done in this process, and measured: what would
travel to a worker and back, and processor time. Then studies of so many machines run with one worker and with two.
"""

from __future__ import annotations

import argparse
import pickle
import resource
import statistics
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest import mock

import deltacal_gen as dc
from deltacal_gen.app import fleet
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import DeltacalError
from deltacal_gen.execution import Outcome, Task
from deltacal_gen.planning import studies
from deltacal_gen.planning.machines import Study
from tests.support.measured import write

COMMAND = "python -m tests.benchmarks.fleet FOLDER --measured"
MODEL = "delta/32"
WORKERS = (1, 2)


@dataclass
class Weight:
    """What a task takes: bytes to the worker and back, processor time [s]."""

    sent: int
    back: int
    seconds: float


def weighed(weights: list[Weight]) -> Callable[..., Iterator[Outcome]]:
    """Return what takes the place of `execution.run`: all in this process, each task weighed."""

    def run(function: Callable[..., dict[str, Any]], tasks: Iterable[Task], **_: Any) -> Iterator[Outcome]:
        for task in tasks:
            arguments = task.arguments()
            sent, begin = len(pickle.dumps((function, arguments))), time.process_time()
            try:
                result, error = function(*arguments), None
            except DeltacalError as failed:
                result, error = None, str(failed)
            weights.append(Weight(sent, len(pickle.dumps(result)), time.process_time() - begin))
            yield Outcome(task.key, task.label, result, error)

    return run


def study(machines: int, workers: int | None = None) -> float:
    """Conduct a study of the paper's 19 poses; return its time [s]."""
    robot = example() / "robot.toml"
    with tempfile.TemporaryDirectory() as folder:
        plan = Path(folder) / "plan.csv"
        dc.plan(robot, model="delta/18", output=plan)
        begin = time.perf_counter()
        dc.study(robot, plan=plan, model=MODEL, noise=0.01, trials=machines, workers=workers)
        return time.perf_counter() - begin


def _bytes(count: float) -> str:
    return f"{count / 1e6:.1f} MB" if count >= 1e6 else f"{count / 1e3:.1f} kB"


def _memory() -> str:
    return f"{resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6:.1f} GB"


def main() -> None:
    """Print both tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--machines", default="10000,50000,150000", help="of the studies")
    parser.add_argument("--measured", action="store_true", help="write the manual's tables too")
    given = parser.parse_args()
    study(Study.chunk, 1)  # compiles
    of_study: list[Weight] = []
    with mock.patch.object(studies, "run", weighed(of_study)):
        study(Study.chunk)
    what = f"study: {Study.chunk} machines, 19 poses, {MODEL}"
    rows = [[what, *_cells(of_study, statistics.median), _memory()]]
    of_batch: list[Weight] = []
    with tempfile.TemporaryDirectory() as run, mock.patch.object(fleet, "run", weighed(of_batch)):
        dc.batch(given.folder, output=run)
    for name, of in (("median", statistics.median), ("mean", statistics.fmean), ("largest", max)):
        rows.append([f"batch: a recording, {name}", *_cells(of_batch, of), _memory() if of is max else ""])
    gains = []
    for machines in map(int, given.machines.split(",")):
        gains.append([f"{machines:,}".replace(",", " "), *(f"{study(machines, w):.1f} s" for w in WORKERS)])
    print("\n".join(" | ".join(row) for row in (*rows, *gains)))
    if given.measured:
        heads = ("work", "task, pickled", "its result", "CPU time", "memory of a worker")
        write("fleet_tasks", heads, rows, COMMAND, note=f"{len(of_batch)} tasks of a batch")
        write("studies", ("machines", *(f"{w} worker{'s' * (w > 1)}" for w in WORKERS)), gains, COMMAND)


def _cells(weights: list[Weight], of: Callable[[list[float]], float]) -> list[str]:
    sent, back, seconds = (of([getattr(w, name) for w in weights]) for name in ("sent", "back", "seconds"))
    return [_bytes(sent), _bytes(back), f"{seconds:.2g} s"]


if __name__ == "__main__":
    main()
