"""Long recordings: ``python -m tests.benchmarks.memory [--rows 1000000]``.

A recording of so many positions is simulated, identified in one linear pass, predicted and validated in blocks, from
CSV and from Parquet; shown are the rows a second and the largest resident memory so far.
"""

from __future__ import annotations

import argparse
import resource
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow.csv
import pyarrow.parquet

from deltacal_gen.use import streams

from .works import ROBOT, positions

ALLOWED_MIB = 1024


def main(arguments: list[str] | None = None) -> int:
    """Print rows a second and memory of every stage; return 1 where the memory is more than allowed."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.memory", description=__doc__.split("\n")[0])
    parser.add_argument("--rows", type=int, default=1_000_000)
    rows = parser.parse_args(arguments).rows
    with tempfile.TemporaryDirectory(prefix="deltacal-memory-") as place:
        folder = Path(place)
        poses, recording, predicted = (folder / f"{name}.csv" for name in ("poses", "recording", "predicted"))
        with poses.open("w") as file:
            file.write("x_mm,y_mm,z_mm\n")
            for first in range(0, rows, streams.ROWS):
                block = positions(min(streams.ROWS, rows - first), seed=first)
                np.savetxt(file, block, "%.9g", ",")
        poses.with_suffix(".toml").write_text('[measurement]\nkind = "position"\nframe = "unknown"\n')

        def simulate(source: Path) -> None:
            rng = np.random.default_rng(1)
            streams.simulate(ROBOT, source, recording, {"L_1": 0.1}, noise_mm=0.01, rng=rng)

        for kind in ("csv", "parquet"):
            if kind == "parquet":
                for path in (poses, recording):
                    _as_parquet(path)
            measured = recording.with_suffix(f".{kind}")
            _told(f"simulate, {kind}", rows, lambda: simulate(poses.with_suffix(f".{kind}")))  # noqa: B023
            found = _told(f"identify, {kind}", rows, lambda: streams.identify(ROBOT, measured, "18", passes=1))  # noqa: B023
            _told(f"predict, {kind}", rows, lambda: streams.predict(found.answer(), measured, predicted))  # noqa: B023
            _told(f"validate, {kind}", rows, lambda: streams.validate(found.answer(), measured))  # noqa: B023
    return int(_resident() > ALLOWED_MIB)


def _as_parquet(path: Path) -> None:
    target = path.with_suffix(".parquet")
    with pyarrow.csv.open_csv(path) as source, pyarrow.parquet.ParquetWriter(target, source.schema) as sink:
        for batch in source:
            sink.write_batch(batch)


def _told(what: str, rows: int, run: Callable[[], Any]) -> Any:
    begin = time.process_time()
    out = run()
    print(f"{what:20s} {rows / (time.process_time() - begin):10.0f} rows/s  {_resident():6.0f} MiB", flush=True)
    return out


def _resident() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


if __name__ == "__main__":
    sys.exit(main())
