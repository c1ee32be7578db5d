"""How long every mechanism compiles: ``python -m tests.benchmarks.compile [--only delta,rows] [--write]``.

Each module of kernels is compiled in a process of its own from an empty folder of compiled code; counted is processor
time, without importing Numba. ``--write`` puts the figures into ``compile.csv`` beside this file. A time is told in
seconds and in those that one kernel by hand (the scalar forward position) takes in the same process: machines differ.
``rows`` are the functions over rows of effects, measurements and statics, which nobody needs all of at once.
"""

from __future__ import annotations

import argparse
import csv
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

from deltacal_kernels.cache import PACKAGE

from deltacal_gen.machine.registry import load_mechanism, mechanism_names

TABLE = Path(__file__).with_name("compile.csv")
MODULE_S, MECHANISM_S = 4.0, 15.0  # the budget, of a machine on which the yardstick takes YARDSTICK_S
YARDSTICK_S = 1.0
ROWS = "rows"
PROGRAM = """
import json, sys, time
import numpy as np
from numba import njit
from deltacal_gen.machine.backend import compile_row_functions
from deltacal_gen.machine.registry import load_mechanism
from tests.benchmarks import by_hand, by_hand_numba
njit(lambda x: x + 1.0)(1.0)  # Numba itself is ready
begin = time.process_time()
solve, forward = (njit(error_model="numpy")(f.py_func) for f in (by_hand_numba._solve, by_hand_numba.forward))
forward(np.full((1, 3), -0.1), by_hand.machine(np.zeros(42)), np.empty((1, 6)))
yardstick = time.process_time() - begin
spent, begin = {}, time.process_time()
rows = sys.argv[1] == "rows"
for name, _ in compile_row_functions() if rows else load_mechanism(sys.argv[1]).compile():
    now = time.process_time()
    spent[name] = now - begin
    begin = now
print(json.dumps([yardstick, spent]))
"""


def modules() -> set[str]:
    """Return the modules that are compiled: each has its functions decorated so."""
    texts = {path.relative_to(PACKAGE).as_posix(): path.read_text(encoding="utf-8") for path in PACKAGE.rglob("*.py")}
    return {path for path, text in texts.items() if "\n@fast\n" in text}


def measure(name: str) -> tuple[float, dict[str, float]]:
    """Return the yardstick's processor time [s], and that of the modules of a mechanism."""
    with tempfile.TemporaryDirectory(prefix="deltacal-compile-") as place:
        environment = os.environ | {"NUMBA_CACHE_DIR": place}
        command = [sys.executable, "-c", PROGRAM, name]
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    yardstick, spent = json.loads(done.stdout)
    total = defaultdict[str, float](float)
    if name == ROWS:
        for kernel, seconds in spent.items():
            total[f"{kernel.rpartition('.')[0].replace('.', '/')}.py"] += seconds
        return yardstick, dict(total)
    machine = load_mechanism(name)
    for kernel, seconds in spent.items():
        function = kernel.split(".")[1]
        modules = [machine.servo, machine.compiled] if machine.written_out else [machine.compiled]
        if importlib.util.find_spec(f"deltacal_kernels.{name}.dynamics"):
            modules.append(importlib.import_module(f"deltacal_kernels.{name}.dynamics"))
        of = next(getattr(module, function) for module in modules if hasattr(module, function))
        total[f"{of.__module__.partition('.')[2].replace('.', '/')}.py"] += seconds
    return yardstick, dict(total)


def main(arguments: list[str] | None = None) -> int:
    """Print the table; return 1 where the budget is exceeded."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.compile", description=__doc__.split("\n")[0])
    parser.add_argument("--only", default=",".join([*mechanism_names(), ROWS]), metavar="delta,rows")
    parser.add_argument("--write", action="store_true", help=f"write {TABLE.name}")
    given = parser.parse_args(arguments)
    known = {row["module"]: row for row in read()}
    over = False
    for name in given.only.split(","):
        yardstick, spent = measure(name)
        scale = YARDSTICK_S / yardstick
        for module, seconds in spent.items():
            known[module] = {"module": module, "seconds": f"{seconds:.1f}", "yardsticks": f"{seconds * scale:.1f}"}
            over |= seconds * scale > MODULE_S
            print(f"{module:45s} {seconds:6.1f} s  {seconds * scale:6.1f} yardsticks", flush=True)
        over |= name != ROWS and sum(spent.values()) * scale > MECHANISM_S
        if given.write:
            _write([known[module] for module in sorted(known) if module in modules()])
    return int(over)


def _write(table: list[dict[str, str]]) -> None:
    with TABLE.open("w", newline="") as file:
        rows = csv.DictWriter(file, ["module", "seconds", "yardsticks"], lineterminator="\n")
        rows.writeheader()
        rows.writerows(table)


def read() -> list[dict[str, str]]:
    """Return the rows of the committed table."""
    if not TABLE.exists():
        return []
    with TABLE.open() as file:
        return list(csv.DictReader(file))


if __name__ == "__main__":
    sys.exit(main())
