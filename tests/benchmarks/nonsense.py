"""Recordings that are nonsense, of every kind: ``python -m tests.benchmarks.nonsense [--runs N] [--seed S]``.

Readings are shuffled among the rows, drawn at random, given one column of noise, multiplied, turned round, or taken
from another machine of the same mechanism. Every one has to be refused (exit code 3 or 4), or be answered with what is
wrong with it: a diagnosis that finds geometry adequate, or an identification that says nothing, is an answer without a
warning. With ``--log FILE`` runs that the file has are not run again; ``--minutes M`` ends a sitting.
"""

from __future__ import annotations

import argparse
import csv
import dataclasses
import io
import json
import random
import re
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

import deltacal_gen as dc
from deltacal_gen.errors import DeltacalError
from deltacal_gen.files.robot import read_robot
from tests.benchmarks import fuzz
from tests.benchmarks.fuzz_inputs import KINDS, MACHINES, Job, shelf

MEASURED = re.compile(r"[xyz]_mm|r[xyz]_deg|gauge_mm|height_mm|distance_mm|[uv]_px|enc\d_deg|tau\d_N?m?|board_[xyz]_mm")
LAWFUL = {
    ("torque", "scaled"),  # another unit of the drive
    ("axis", "rows turned round"),  # a way there and back
    *((name, "of another machine") for name in ("axis", "encoder", "torque")),  # what they read has no lengths
}
KNOWN = {"images": ("board_x_mm", "board_y_mm")}  # what a kind is told beside the readings
FACTORS = (0.001, 0.5, 0.9, 1.2, 2.0, 25.4, -1.0)
OTHER, OTHERS = "of another machine", (0.7, 1.3)  # and its lengths, of this one's
TURN = 2 * np.pi  # [rad]: what a geometry has no more of is angles
FINE = ("refused", "answered with a warning")
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


PAIRS = [(name, way) for way in (*WAYS, OTHER) for name in (*MACHINES, *KINDS) if (name, way) not in LAWFUL]
FOUND = (  # seed, run, and what it was: images of noise (a fault), another machine's readings
    (1901, 17, ("images", "random")),
    (1901, 51, ("linear_delta", OTHER)),
    (1901, 105, ("planar_parallelogram", OTHER)),
)


def nonsense(good: Path, name: str, way: str, dice: np.random.Generator) -> str:
    """Return a recording of the shelf with its readings made nonsense."""
    head, *rows = csv.reader(io.StringIO((good / f"{name}.recording.csv").read_text()))
    measured = [k for k, c in enumerate(head) if MEASURED.fullmatch(c) and c not in KNOWN.get(name, ())]
    if way == OTHER:
        return _of_another(good, name, [c for k, c in enumerate(head) if k not in measured], dice)
    y = np.array([[float(row[k] or "nan") for k in measured] for row in rows])
    for row, values in zip(rows, WAYS[way](y, dice), strict=True):
        for k, value in zip(measured, values, strict=True):
            row[k] = "" if np.isnan(value) else repr(float(value))
    return _table(head, rows)


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([head, *rows])
    return out.getvalue()


def _of_another(good: Path, name: str, kept: Sequence[str], dice: np.random.Generator) -> str:
    """Return what a machine of other lengths gives at the same joints, drawn until it reaches them all."""
    robot, rows = read_robot(good / f"{name}.robot.toml"), csv.DictReader((good / f"{name}.recording.csv").open())
    with tempfile.TemporaryDirectory() as temporary:
        poses, out = (Path(temporary) / file for file in ("poses.csv", "out.csv"))
        poses.write_text(_table(kept, [[row[c] for c in kept] for row in rows]))
        if (good / f"{name}.poses.toml").exists():
            poses.with_suffix(".toml").write_bytes((good / f"{name}.poses.toml").read_bytes())
        while True:
            lengths = {
                key: value * dice.uniform(*OTHERS, value.shape) if np.abs(value).max() > TURN else value
                for key, value in robot.geometry.items()
            }
            try:
                other = dataclasses.replace(robot, geometry=lengths)
                dc.simulate(other, poses, output=out, noise=0.02, seed=int(dice.integers(1000)))
            except DeltacalError:
                continue
            return out.read_text()


def warned(said: str, folder: Path) -> bool:
    """Tell whether an answer says that something is wrong: words on the screen, or figures far above the noise."""
    found = json.loads((folder / "out.json").read_text())
    if found.get("verdict") in ("missing_physics", "unexplained"):
        return True
    words = " ".join(said.split())  # lines are broken where the screen ends
    return bool(re.search(r"warning:|above the noise|gross errors|times too small|farther from the robot file", words))


def words_of(k: int) -> str:
    """Return what run `k` makes nonsense, and how."""
    return f"{k} {' '.join(PAIRS[k % len(PAIRS)])}"


def one(seed: int, k: int, good: Path, *, pair: tuple[str, str] | None = None, show: bool = False) -> fuzz.Run:
    """Run number `k`, of its own pair or another; print what was accepted, or all that was said."""
    name, way = pair or PAIRS[k % len(PAIRS)]
    command = random.Random(f"{seed}/{k}").choice(("identify", "diagnose"))
    table = nonsense(good, name, way, np.random.default_rng([seed, k]))
    job = Job((command, f"{{{name}.robot.toml}}", f"{{{name}.recording.csv}}", "-o", "{out.json}"), ())
    outcome = fuzz.attempt(job, f"{name}.recording.csv", table.encode(), good, seen=warned)
    how = "refused" if outcome.code in (3, 4) else "answered with a warning" if outcome.warned else "ACCEPTED"
    how = outcome.flaw or how
    if how not in FINE or show:
        print(f"{seed}/{words_of(k)} {command}: {how} ({outcome.code})\n{outcome.said[-700:]}", flush=True)
    return k, f"{name} {way} {command}", outcome.code, how


def main(arguments: Sequence[str] | None = None) -> int:
    """Return 0 where nothing was accepted without a warning."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", help="runs whose words begin so: '17 ', 'delta', ...", default="")
    parser.add_argument("--show", action="store_true", help="what was said to each")
    parser.add_argument("--log", type=Path, help="a line to each run (CSV); those that it has are not run again")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="after which no further run begins")
    asked = parser.parse_args(arguments)
    fuzz.load()
    done, end = fuzz.logged(asked.log), time.monotonic() + 60 * asked.minutes
    had = {k for k, *_ in done}
    with tempfile.TemporaryDirectory() as temporary:
        good = Path(temporary) / "good"
        good.mkdir()
        shelf(good)
        for seed, k, pair in FOUND if not (had or asked.only) else ():
            done.append((-1, *one(seed, k, good, pair=pair, show=asked.show)[1:]))
        for k in (k for k in range(asked.runs) if k not in had and words_of(k).startswith(asked.only)):
            if time.monotonic() > end:
                break
            done.append(one(asked.seed, k, good, show=asked.show))
            fuzz.log(asked.log, done[-1])
    counts = Counter(how for *_, how in done)
    print(dict(counts))
    return int(any(how not in FINE for how in counts))


if __name__ == "__main__":
    sys.exit(main())
