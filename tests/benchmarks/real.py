"""What a diagnosis of a real machine is worth: on the other half of a recording, and on another series.

    python -m tests.benchmarks.real halves FOLDER [FOLDER ...] [--halves 10] [--seed 7]
    python -m tests.benchmarks.real carry FOLDER FOLDER [FOLDER ...]

A folder holds ``robot.toml`` and ``recording.csv``. `halves`: one half of the poses, drawn at random, is calibrated and
diagnosed, the other predicted by both. `carry`: every folder is diagnosed; the even rows of every other one are
identified with that physics held and without, its odd rows predicted by both, and the other way round. Errors are mean
lengths in the unit of the readings; both know of the predicted rows nothing but joints and channels. Of three folders
and more all others together, each a set-up of its own in one recording, are carried to each one, too.
"""

from __future__ import annotations

import argparse
import itertools
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import deltacal_gen as dc
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording, Robot
from tests.benchmarks.arm import together


def given(folder: Path) -> tuple[Robot, Recording]:
    robot = dc.read_robot(folder / "robot.toml")
    return robot, dc.read_recording(folder / "recording.csv", mechanism_of(robot))


def error(known: dc.Result | dc.Diagnosis, asked: Recording) -> float:
    """Return the mean length of the errors of predicted readings, of lengths alone where there are rotations."""
    off = (dc.predict(known, asked).measured - asked.measured)[:, :3]
    read = np.isfinite(off).any(axis=1)
    return float(np.mean(np.linalg.norm(np.nan_to_num(off[read]), axis=1)))


def halves(folder: Path, count: int, seed: int) -> None:
    robot, recording = given(folder)
    rows = []
    for k in range(count):
        poses = np.unique(recording.pose)
        np.random.default_rng([seed, k]).shuffle(poses)
        first = np.isin(recording.pose, poses[: len(poses) // 2])
        train, test = (recording.subset(np.flatnonzero(part)) for part in (first, ~first))
        began = time.process_time()
        found = dc.diagnose(robot, train)
        spent = time.process_time() - began
        rows.append((error(dc.identify(robot, train), test), error(found, test)))
        named = ", ".join(f"{e.name} {list(e.limbs)}" for e in found.effects) or "nothing"
        smooth = " and a smooth correction" if found.correction is not None else ""
        print(
            f"{folder.name} half {k}: geometry {rows[-1][0]:.4f}, diagnosed {rows[-1][1]:.4f}; {found.verdict.value}: "
            f"{named}{smooth}; {spent:.0f} s of CPU",
            flush=True,
        )
    before, after = np.mean(rows, axis=0)
    print(f"{folder.name}, mean of {count} halves: geometry {before:.4f}, diagnosed {after:.4f}", flush=True)


def carry(folders: list[Path]) -> None:
    diagnoses = {folder: dc.diagnose(*given(folder)) for folder in folders}
    for source, target in itertools.permutations(folders, 2):
        carried(source.name, diagnoses[source], target)
    for target in folders if len(folders) > 2 else ():
        others = [folder for folder in folders if folder != target]
        with tempfile.TemporaryDirectory() as place:
            found = dc.diagnose(*given(together(others, Path(place))))
        carried(" and ".join(folder.name for folder in others), found, target)


def carried(name: str, found: dc.Diagnosis, target: Path) -> None:
    """Print what a diagnosis is worth on either half of the rows of another series."""
    robot, recording = given(target)
    parts = [recording.subset(np.arange(k, recording.n_rows, 2)) for k in (0, 1)]
    for train, test in (parts, parts[::-1]):
        held = error(dc.identify(robot, train, physics=found), test)
        alone = error(dc.identify(robot, train), test)
        print(f"{name} to {target.name}: {alone:.4f} to {held:.4f}, ratio {held / alone:.3f}", flush=True)


def main(arguments: list[str]) -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.real", description=__doc__.partition("\n")[0])
    parser.add_argument("what", choices=("halves", "carry"))
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--halves", type=int, default=10)
    parser.add_argument("--seed", type=int, default=7)
    said = parser.parse_args(arguments)
    if said.what == "carry":
        carry(said.folders)
        return
    for folder in said.folders:
        halves(folder, said.halves, said.seed)


if __name__ == "__main__":
    main(sys.argv[1:])
