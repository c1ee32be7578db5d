"""Run the benchmarks: ``python -m tests.benchmarks [--quick] [--only W1s,W5] [--json FILE] [--measured]``.

All contenders of a work run in one process, in turn (A B C A B C ...), so that a busy machine slows them alike; a
ratio is the median over the repetitions of neighbouring runs. Ratios carry over to other machines, times do not.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded

import argparse
import gc
import json
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import mechanism_names
from tests.benchmarks.contenders import KERNEL, MISSING, NUMBA, NUMPY, OURS, TOOLS, Contender, Work
from tests.benchmarks.works import WORKS, disagreement, works
from tests.support.measured import write

SCALE = {"ns": 1e9, "us": 1e6, "ms": 1e3, "s": 1.0}
AT_MOST = {  # time of the kernel to that of scalar Numba by hand: what is asked for, on a machine with AVX-512
    "W1s": 0.7,
    "W2_19": 0.8,
    "W2_200": 0.8,
    "W3ik": 0.15,
    "W3fk": 0.15,
    "W4linear": 0.9,
    "W4py_linear": 0.6,
    "W5": 0.15,
    "W6_18": 0.12,
    "W6_32": 0.12,
    "W6_18kept": 0.35,
    "W6_32kept": 0.35,
}
BESIDE = {  # time of the kernel to that of another contender, of a work done in the same run: what is asked for
    "exact_dh": ("exact_dh", NUMPY, 1.5),
    "forward_serial": ("forward_delta", KERNEL, 1.8),
    "sensitivity_serial": ("sensitivity_delta", KERNEL, 2.0),
}
CALLS = {  # what a user calls for a work of the manual's table
    "W1s": "`delta.compiled.nominal_sensitivity`",
    "W2_19": "`delta.compiled.distance_rows`",
    "W2_200": "the same",
    "W3ik": "`delta.compiled.simplified_inverse`",
    "W3fk": "`delta.compiled.simplified_forward`",
    "W4linear": '`Compensator(robot, "linear").servo(change=True).command`',
    "W4py_linear": "`.servo(change=True).direct()`",
    "W5": "`delta.compiled.forward`",
    "W6_18": "`PoseSet`",
    "W6_32": "`PoseSet`",
    "W6_18kept": "`PoseSet`",
    "W6_32kept": "`PoseSet`",
    "W7_cold": "`dc.estimate`",
    "W7_warm": "`dc.estimate`",
}
AVX2 = {"NUMBA_CPU_NAME": "haswell", "NUMBA_CPU_FEATURES": "+avx2,+fma,+avx,+bmi,+bmi2,+popcnt,-avx512f"}
SECONDS = {"W7_cold": 2.0, "W7_warm": 0.35}  # time of a user's call: what is asked for
ENOUGH_S = 20.0  # what is spent on a work, however slow its contenders; all run twice at least
TITLE = (
    "median (minimum), times faster than NumPy. ours: the call a user writes; kernel: the part of it that computes; "
    "NumPy, Numba: by hand, Numba one pose after the other; kernel / Numba, or to what is named there: minima"
)


def measure(work: Work, repetitions: int, sample: float) -> dict[str, list[float]]:
    """Return the times [unit of the work] of every contender, repetition by repetition.

    Parameters
    ----------
    repetitions : int
        As long as they take no more than `ENOUGH_S` in all.
    sample : float
        A sample repeats short runs until they take about so long [s].
    """
    scale = SCALE[work.unit.split("/")[0]] / work.count
    once = {name: _timed(contender, 1) for name, contender in work.contenders.items()}
    loops = {name: max(1, round(sample / spent)) for name, spent in once.items()}
    count = min(repetitions, int(ENOUGH_S / sum(max(sample, spent) for spent in once.values())))
    times: dict[str, list[float]] = {name: [spent * scale] if count < 2 else [] for name, spent in once.items()}
    for _ in range(max(count, 1)):
        for name, contender in work.contenders.items():
            times[name].append(_timed(contender, loops[name]) * scale)
    return times


def _timed(contender: Contender, loops: int) -> float:
    """Return the time of one run [s], the mean of `loops`; where there is something to do before, of one alone."""
    if contender.before is not None:
        contender.before()
        loops = 1
    gc.collect()
    gc.disable()
    begin = time.perf_counter()
    for _ in range(loops):
        contender.run()
    spent = time.perf_counter() - begin
    gc.enable()
    return spent / loops


def row(name: str, work: Work, times: dict[str, list[float]]) -> dict[str, Any]:
    """Return a work's figures for the table and the JSON file."""
    ratio = {
        contender: statistics.median(b / a for a, b in zip(mine, times[NUMPY], strict=True))
        for contender, mine in times.items()
        if contender != NUMPY
    }
    compared = {"at_most_s": SECONDS.get(name)}
    if KERNEL in times and NUMBA in times:
        compared |= {"kernel_to_numba": min(times[KERNEL]) / min(times[NUMBA]), "at_most": AT_MOST.get(name)}
    return compared | {
        "work": name,
        "what": work.what,
        "unit": work.unit,
        "minimum": {contender: min(t) for contender, t in times.items()},
        "median": {contender: statistics.median(t) for contender, t in times.items()},
        "times_numpy": ratio,
        "repetitions": len(times[NUMPY]),
    }


def beside(rows: list[dict[str, Any]]) -> None:
    """Add to works that are asked for beside others how long their kernels take to those."""
    found = {r["work"]: r["minimum"] for r in rows}
    for r in rows:
        if r["work"] in BESIDE:
            other, contender, most = BESIDE[r["work"]]
            r |= {
                "beside": f"{other}'s {contender}",
                "kernel_to_it": found[r["work"]][KERNEL] / found[other][contender],
            }
            r["at_most"] = most


def table(rows: list[dict[str, Any]]) -> Table:
    """Return the table of all works, a column for each contender."""
    out, contenders = Table("work", "what", "unit", title=TITLE), (OURS, KERNEL, NUMPY, NUMBA, *TOOLS)
    for head in (*contenders, "kernel / Numba", "at most"):
        out.add_column(head, justify="right")
    for r in rows:
        cells = [_cell(r, contender) for contender in contenders]
        against, goal, seconds = r.get("kernel_to_numba"), r.get("at_most"), r.get("at_most_s")
        cells += ["" if against is None else f"{against:.2f}", "" if goal is None else f"{goal:g}"]
        cells[-2] += f"{r['kernel_to_it']:.2f} of {r['beside']}" if "beside" in r else ""
        cells[-1] += "" if seconds is None else f"ours {seconds:g} s"
        out.add_row(r["work"], r["what"], r["unit"], *cells)
    return out


def measured(rows: list[dict[str, Any]], command: str, quick: bool) -> None:
    """Write the manual's tables of which all works were run: kernels beside Numba by hand, and every mechanism."""
    found = {r["work"]: r for r in rows}
    if CALLS.keys() <= found.keys():
        narrow = _without_avx512([name for name in CALLS if "kernel_to_numba" in found[name]], quick)
        cells = [
            [f"{name}: {r['what']}", _against(r), call, _against(narrow[name]) if name in narrow else ""]
            for name, call in CALLS.items()
            if (r := found[name])
        ]
        write("kernels", ("work", "kernel / Numba", "call", "AVX2"), cells, command)
    every = {name: [found.get(f"{what}_{name}") for what in ("forward", "sensitivity")] for name in mechanism_names()}
    if all(None not in pair for pair in every.values()):
        heads = ("mechanism", "forward", "in NumPy", "sensitivity", "in NumPy")
        least = [
            [
                f"`{name}`",
                *(_short(r["minimum"][of]) if of in r["minimum"] else "-" for r in pair if r for of in (KERNEL, NUMPY)),
            ]
            for name, pair in every.items()
        ]
        write("machines", heads, least, command)


def _against(row: dict[str, Any]) -> str:
    """Return the kernel's time to that of Numba by hand; of a user's whole call seconds."""
    return f"{row['kernel_to_numba']:.2f}" if "kernel_to_numba" in row else f"{row['minimum'][OURS]:.2f} s"


def _without_avx512(names: list[str], quick: bool) -> dict[str, dict[str, Any]]:
    """Return the works run anew in a process whose Numba knows no AVX-512."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "works.json"
        options = ["--only", ",".join(names), "--json", str(file), *(["--quick"] if quick else [])]
        subprocess.run([sys.executable, "-m", "tests.benchmarks", *options], env={**os.environ, **AVX2}, check=True)
        return {r["work"]: r for r in json.loads(file.read_text())["works"]}


def _cell(row: dict[str, Any], contender: str) -> str:
    if contender not in row["median"]:
        return ""
    faster = f" {row['times_numpy'][contender]:.2g}x" if contender != NUMPY else ""
    return f"{_short(row['median'][contender])} ({_short(row['minimum'][contender])}){faster}"


def _told(row: dict[str, Any]) -> str:
    """Return a work's figures in one line, for those who wait for the table."""
    times = ", ".join(f"{who} {_short(least)}" for who, least in row["minimum"].items())
    against = f"; kernel / Numba {row['kernel_to_numba']:.2f}" if "kernel_to_numba" in row else ""
    return f"{times} {row['unit']}{against}"


def _short(value: float) -> str:
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


@using(Backend.COMPILED)  # as who does a work over and over would
def main(arguments: list[str] | None = None) -> int:
    """Run the works asked for, print the table; return 1 where contenders disagree."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks", description=__doc__.split("\n")[0])
    parser.add_argument("--quick", action="store_true", help="smaller sizes, fewer repetitions")
    parser.add_argument("--only", default=",".join(WORKS), metavar="W1s,W5", help="these works, or all that begin so")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write all figures")
    parser.add_argument("--measured", action="store_true", help="write the manual's tables too")
    given = parser.parse_args(arguments)
    asked = given.only.split(",")
    names = [name for name in WORKS if name in asked or any(name.startswith(a) and a not in WORKS for a in asked)]
    others = {BESIDE[name][0] for name in names if name in BESIDE}
    names = [name for name in WORKS if name in names or name in others]
    if not names:
        parser.error(f"no such work; there are {', '.join(WORKS)}")
    rows, wrong = [], []
    for done, (name, work) in enumerate(works(names, int(given.quick))):
        print(f"{done + 1}/{len(names)} {name}: {work.what}", file=sys.stderr, flush=True)
        wrong += [
            f"{name}: {who} differs from NumPy by {much:.2g} tolerances"
            for who, much in disagreement(work).items()
            if not much <= 1
        ]
        rows.append(row(name, work, measure(work, 5 if given.quick else 15, 0.01 if given.quick else 0.05)))
        print(f"    {_told(rows[-1])}", file=sys.stderr, flush=True)
    beside(rows)
    Console(width=None if sys.stdout.isatty() else 240).print(table(rows))
    if MISSING:
        print(f"Not installed, and left out: {', '.join(MISSING)}; pip install --editable '.[bench]'.", file=sys.stderr)
    if given.json is not None:
        machine = {"machine": platform.platform(), "python": platform.python_version()}
        given.json.write_text(json.dumps({**machine, "quick": given.quick, "works": rows}, indent=1) + "\n")
    if given.measured:
        words = sys.argv[1:] if arguments is None else arguments
        measured(rows, " ".join(["python -m tests.benchmarks", *words]), given.quick)
    for line in wrong:
        print(line, file=sys.stderr)
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
