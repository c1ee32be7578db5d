"""Concealed recordings: what the diagnosis names on machines of which it knows nothing, against what is the case.

``python -m tests.benchmarks.concealed [--null N] [--single N] [--pair N] [--outside N] [--seed S] [--machine M]
[--kind K]``

Cases are those of `concealed_cases`, judged as `concealed_grading` does, and done as `sitting` says: with ``--kept`` a
run that was ended goes on where it stopped.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded

import argparse
import sys

from rich.console import Console

from deltacal_gen.physics.terms import effect_names
from tests.benchmarks.concealed_cases import ORDINARY, plan
from tests.benchmarks.concealed_grading import examine, failures, table
from tests.benchmarks.concealed_machines import INSTRUMENTS, MACHINES
from tests.benchmarks.sitting import add_options, sit


def main(arguments: list[str] | None = None) -> int:
    """Run the cases, print the table and the failures."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.concealed", description=__doc__.split("\n")[0])
    for kind, count in ORDINARY.items():
        parser.add_argument(f"--{kind}", type=int, metavar="N", default=count, help=f"cases (default {count})")
    parser.add_argument("--only", default="", help="effects, with commas, that singles and pairs are made of")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--machine", choices=MACHINES, default="delta")
    parser.add_argument("--kind", choices=INSTRUMENTS, default="", help="by which alone it is measured; default drawn")
    add_options(parser)
    given = parser.parse_args(arguments)
    only = [name for name in given.only.split(",") if name]
    if unknown := set(only) - set(effect_names()):
        parser.error(f"no such effect: {', '.join(sorted(unknown))}")
    work = plan(
        {kind: getattr(given, kind) for kind in ORDINARY}, given.seed, only, f"{given.machine} {given.kind}".strip()
    )
    sitting = sit(examine, work, given)
    found = list(sitting.done.values())
    for entry in found:
        if "skipped" in entry:
            print(entry["skipped"], file=sys.stderr)
    graded = [entry for entry in found if "skipped" not in entry]
    Console(width=None if sys.stdout.isatty() else 150).print(table(graded))
    for line in failures(graded):
        print(line)
    return sitting.code


if __name__ == "__main__":
    sys.exit(main())
