"""Long recordings: ``python -m tests.benchmarks.memory [--rows 1000000] [--measured]``.

A recording of so many positions is simulated, identified in one linear pass, predicted and validated in blocks, from
CSV and from Parquet; shown are the rows a second and the largest resident memory so far. With ``--measured`` the
commands are run instead, each in a process of its own, and the manual's table is written.
"""

from __future__ import annotations

import argparse
import os
import resource
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.csv
import pyarrow.parquet

from deltacal_gen import robot_to_toml
from deltacal_gen.use import streams
from tests.measured import write

from .contenders import ROBOT, positions

ALLOWED_MIB = 1024
COMMANDS = (
    "deltacal simulate robot.toml poses.csv -o recording.csv --noise 0.01 --blocks",
    "deltacal identify robot.toml recording.csv --model 18 -o result.json --blocks",
    "deltacal predict result.json recording.csv -o predicted.csv --blocks",
    "deltacal validate result.json recording.csv --blocks",
    "deltacal compensate result.json poses.csv -o joints.csv",
)


def main(arguments: list[str] | None = None) -> int:
    """Print rows a second and memory of every stage; return 1 where the memory is more than allowed."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.memory", description=__doc__.split("\n")[0])
    parser.add_argument("--rows", type=int, default=1_000_000)
    parser.add_argument("--measured", action="store_true", help="run the commands and write the manual's table")
    given = parser.parse_args(arguments)
    rows = given.rows
    with tempfile.TemporaryDirectory(prefix="deltacal-memory-") as place:
        folder = Path(place)
        poses, recording, predicted = (folder / f"{name}.csv" for name in ("poses", "recording", "predicted"))
        _write_poses(poses, rows)
        if given.measured:
            (folder / "robot.toml").write_text(robot_to_toml(ROBOT))
            cells = [[f"`{command}`", *_run(command, folder)] for command in COMMANDS]
            made = f"python -m tests.benchmarks.memory --rows {rows} --measured"
            write("blocks", ("command", "memory", "time"), cells, made)
            return 0

        def simulate(source: Path) -> None:
            rng = np.random.default_rng(1)
            streams.simulate(ROBOT, source, recording, {"L_1": 0.1}, noise=0.01, rng=rng)

        for kind in ("csv", "parquet"):
            if kind == "parquet":
                for path in (poses, recording):
                    _as_parquet(path)
            measured = recording.with_suffix(f".{kind}")
            _told(f"simulate, {kind}", rows, simulate, poses.with_suffix(f".{kind}"))
            found = _told(f"identify, {kind}", rows, streams.identify, ROBOT, measured, "18", passes=1)
            _told(f"predict, {kind}", rows, streams.predict, found.answer(), measured, predicted)
            _told(f"validate, {kind}", rows, streams.validate, found.answer(), measured)
    return int(_resident() > ALLOWED_MIB)


def _write_poses(path: Path, rows: int) -> None:
    """Write positions all over the workspace as targets, with their sidecar."""
    with path.open("w") as file:
        file.write("x_mm,y_mm,z_mm\n")
        for first in range(0, rows, streams.ROWS):
            block = positions(min(streams.ROWS, rows - first), seed=first)
            np.savetxt(file, block, "%.9g", ",")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "position"\nframe = "unknown"\n')


def _run(command: str, folder: Path) -> tuple[str, str]:
    """Run a command; return its largest resident memory and its time."""
    begin = time.perf_counter()
    process = subprocess.Popen(
        [sys.executable, "-m", "deltacal_gen.app.cli", *shlex.split(command)[1:]], cwd=folder, stdout=subprocess.DEVNULL
    )
    _, status, used = os.wait4(process.pid, 0)
    if status:
        raise SystemExit(f"{command} failed")
    told = f"{used.ru_maxrss / 1024:.0f} MiB", f"{time.perf_counter() - begin:.0f} s"
    print(f"{command}: {', '.join(told)}", flush=True)
    return told


def _as_parquet(path: Path) -> None:
    target = path.with_suffix(".parquet")
    with pyarrow.csv.open_csv(path) as source, pyarrow.parquet.ParquetWriter(target, source.schema) as sink:
        for batch in source:
            sink.write_batch(batch)


def _told(what: str, rows: int, run: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
    begin = time.process_time()
    out = run(*arguments, **options)
    print(f"{what:20s} {rows / (time.process_time() - begin):10.0f} rows/s  {_resident():6.0f} MiB", flush=True)
    return out


def _resident() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


if __name__ == "__main__":
    sys.exit(main())
