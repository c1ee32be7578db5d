"""Recordings that are nonsense, of every kind: ``python -m tests.benchmarks.nonsense [--runs N] [--seed S]``.

Readings are shuffled among the rows, drawn at random, given one column of noise, multiplied, or taken from another
machine of the same mechanism. Every one has to be refused (exit code 3 or 4), or be answered with what is wrong with
it: a diagnosis that finds geometry adequate, or an identification that says nothing, is an answer without a warning.
"""

from __future__ import annotations

import argparse
import csv
import io
import json
import random
import re
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from tests.benchmarks import fuzz
from tests.benchmarks.fuzz_inputs import KINDS, MACHINES, Job, shelf

MEASURED = re.compile(r"[xyz]_mm|r[xyz]_deg|gauge_mm|height_mm|distance_mm|[uv]_px|enc\d_deg|tau\d_N?m?|board_[xyz]_mm")
LAWFUL = {("torque", "scaled"), ("axis", "rows turned round")}  # another unit of the drive; a way there and back
KNOWN = {"images": ("board_x_mm", "board_y_mm")}  # what a kind is told beside the readings
FACTORS = (0.001, 0.5, 0.9, 1.2, 2.0, 25.4, -1.0)
Values = np.ndarray
Way = Callable[[Values, np.random.Generator], Values]


def _one_of_noise(y: Values, dice: np.random.Generator) -> Values:
    out, j = y.copy(), dice.integers(y.shape[1])
    out[:, j] = dice.uniform(np.nanmin(y[:, j]), np.nanmax(y[:, j]), len(y))
    return out


WAYS: dict[str, Way] = {
    "shuffled": lambda y, dice: y[dice.permutation(len(y))],
    "random": lambda y, dice: dice.uniform(np.nanmin(y, axis=0), np.nanmax(y, axis=0), y.shape),
    "one column of noise": _one_of_noise,
    "scaled": lambda y, dice: y * dice.choice(FACTORS),
    "rows turned round": lambda y, dice: y[::-1],
}


def nonsense(table: str, name: str, way: str, dice: np.random.Generator) -> str:
    """Return a recording with its readings made nonsense."""
    head, *rows = csv.reader(io.StringIO(table))
    measured = [k for k, c in enumerate(head) if MEASURED.fullmatch(c) and c not in KNOWN.get(name, ())]
    y = np.array([[float(row[k] or "nan") for k in measured] for row in rows])
    for row, values in zip(rows, WAYS[way](y, dice), strict=True):
        for k, value in zip(measured, values, strict=True):
            row[k] = "" if np.isnan(value) else repr(float(value))
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([head, *rows])
    return out.getvalue()


def warned(said: str, folder: Path) -> bool:
    """Tell whether an answer says that something is wrong: words on the screen, or figures far above the noise."""
    found = json.loads((folder / "out.json").read_text())
    if found.get("verdict") in ("missing_physics", "unexplained"):
        return True
    return bool(re.search(r"warning:|above the noise|gross errors|times too small", said))


def main(arguments: Sequence[str] | None = None) -> int:
    """Return 0 where nothing was accepted without a warning."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--show", action="store_true", help="what was said to each")
    asked = parser.parse_args(arguments)
    fuzz.load()
    counts: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as temporary:
        good = Path(temporary) / "good"
        good.mkdir()
        shelf(good)
        names = [m for m in (*MACHINES, *KINDS) if (good / f"{m}.recording.csv").exists()]
        pairs = [(name, way) for way in WAYS for name in names if (name, way) not in LAWFUL]
        for k in range(asked.runs):
            name, way = pairs[k % len(pairs)]
            command = random.Random(f"{asked.seed}/{k}").choice(("identify", "diagnose"))
            dice = np.random.default_rng([asked.seed, k])
            table = nonsense((good / f"{name}.recording.csv").read_text(), name, way, dice)
            job = Job((command, f"{{{name}.robot.toml}}", f"{{{name}.recording.csv}}", "-o", "{out.json}"), ())
            outcome = fuzz.attempt(job, f"{name}.recording.csv", table.encode(), good, seen=warned)
            how = "refused" if outcome.code in (3, 4) else "answered with a warning" if outcome.warned else "ACCEPTED"
            how = outcome.flaw or how
            counts[how] += 1
            if how not in ("refused", "answered with a warning") or asked.show:
                print(f"{k} {name} {way} {command}: {how} ({outcome.code})\n{outcome.said[-700:]}", flush=True)
    print(dict(counts))
    return int(any(how not in ("refused", "answered with a warning") for how in counts))


if __name__ == "__main__":
    sys.exit(main())
