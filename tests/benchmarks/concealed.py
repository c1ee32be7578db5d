"""Concealed recordings: what the diagnosis names on machines of which it knows nothing, against what is the case.

``python -m tests.benchmarks.concealed [--null N] [--single N] [--pair N] [--outside N] [--seed S] [--machine M]``

Cases are those of `concealed_cases`, judged as `concealed_grading` does. With ``--json`` every case is written as soon
as it is done, and a run that was interrupted goes on where it stopped.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded

import argparse
import json
import multiprocessing
import sys
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

from deltacal_gen.physics.terms import effect_names
from tests.benchmarks.concealed_cases import ORDINARY, plan
from tests.benchmarks.concealed_grading import examine, failures, table
from tests.benchmarks.concealed_machines import MACHINES

PARTS = ("kind", "names", "seed", "machine")  # of a job, as `concealed_cases.plan` lists them


def main(arguments: list[str] | None = None) -> int:
    """Run the cases, print the table and the failures."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.concealed", description=__doc__.split("\n")[0])
    for kind, count in ORDINARY.items():
        parser.add_argument(f"--{kind}", type=int, metavar="N", default=count, help=f"cases (default {count})")
    parser.add_argument("--only", default="", help="effects, with commas, that singles and pairs are made of")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path, metavar="FILE", help="one line for each case; those there are not redone")
    parser.add_argument("--machine", choices=MACHINES, default="delta")
    given = parser.parse_args(arguments)
    only = [name for name in given.only.split(",") if name]
    if unknown := set(only) - set(effect_names()):
        parser.error(f"no such effect: {', '.join(sorted(unknown))}")
    work = plan({kind: getattr(given, kind) for kind in ORDINARY}, given.seed, only, given.machine)
    done: dict[str, dict[str, Any]] = {}
    if given.json is not None and given.json.exists():
        lines = given.json.read_text(encoding="utf-8").splitlines()
        done = {_key(entry): entry for entry in map(json.loads, lines)}
    found = [done[key] for job in work if (key := _key(dict(zip(PARTS, job, strict=True)))) in done]
    left = [job for job in work if _key(dict(zip(PARTS, job, strict=True))) not in done]
    errors = Console(stderr=True)
    columns = (*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=errors) as progress, multiprocessing.Pool(given.jobs) as pool:
        task = progress.add_task("cases", total=len(work), completed=len(found))
        for entry in pool.imap_unordered(examine, left):
            progress.advance(task)
            found.append(entry)
            if given.json is not None:
                with given.json.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(entry) + "\n")
    for entry in found:
        if "skipped" in entry:
            errors.print(entry["skipped"], markup=False, highlight=False)
    graded = [entry for entry in found if "skipped" not in entry]
    Console(width=None if sys.stdout.isatty() else 150).print(table(graded))
    for line in failures(graded):
        print(line)
    return 0


def _key(entry: dict[str, Any]) -> str:
    return json.dumps([entry["kind"], list(entry["names"]), list(entry["seed"]), entry["machine"]])


if __name__ == "__main__":
    sys.exit(main())
