"""Second encoders in motion, beside a fit by hand: ``python -m tests.benchmarks.encoders FOLDER [--halves 4]``.

The folder holds ``robot.toml`` and ``recording.csv`` of the kind encoder, with runs. Half of the runs are diagnosed, or
fitted by hand, and the others predicted, and the other way round, for as many halves as asked. By hand is least squares
at each joint of a zero, one order of sines and one delay; either each row counts, or each wait, the rows of a run in
which no joint moves, once. The errors are root mean squares [deg] in motion, and at rest of each wait once and of each
row.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

import deltacal_gen as dc
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording, poses_of
from deltacal_gen.physics.motion import motion_of
from deltacal_gen.units import DEG

Array = np.ndarray
WHERE = ("in motion", "at rest, each wait once", "at rest, each row")


def halves(recording: Recording, count: int, seed: int) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Yield the rows of one half of the runs and of the other, either way round."""
    runs, rng = np.unique(recording.channels["run"]), np.random.default_rng(seed)
    for _ in range(count):
        first = np.isin(recording.channels["run"], rng.permutation(runs)[: len(runs) // 2])
        yield from ((np.flatnonzero(own), np.flatnonzero(~own)) for own in (first, ~first))


def waits(recording: Recording) -> tuple[np.ndarray, Array]:
    """Return which rows (N,) are at rest, and how much each counts where a wait counts once."""
    pose = poses_of(recording)
    count = np.bincount(pose)[pose]
    return count > 1, 1.0 / count


def by_hand(recording: Recording, train: np.ndarray, test: np.ndarray, weight: Array) -> Array:
    """Return the readings (T, n) of `test` [deg] by a fit to `train`, rows of `weight` (N,)."""
    speeds = motion_of(recording)
    q, read, root = recording.joints / DEG, recording.measured / DEG, np.sqrt(weight[train])[:, None]
    told = np.empty((len(test), q.shape[1]))
    for j in range(q.shape[1]):
        angle, speed = recording.joints[:, j], speeds[f"qd{j + 1}_deg_s"]
        A = np.column_stack([np.ones(len(q)), np.sin(angle), np.cos(angle), speed])
        off = read[train, j] - q[train, j]
        told[:, j] = q[test, j] + A[test] @ np.linalg.lstsq(A[train] * root, off * root[:, 0], rcond=None)[0]
    return told


def errors(recording: Recording, test: np.ndarray, told: Array) -> list[float]:
    """Return root mean squares [deg], see `WHERE`."""
    rest, once = (values[test] for values in waits(recording))
    square = np.mean((told - recording.measured[test] / DEG) ** 2, axis=1)
    parts = ((~rest, np.ones(len(test))), (rest, once), (rest, np.ones(len(test))))
    return [float(np.sqrt(np.average(square[own], weights=weight[own]))) for own, weight in parts]


def compared(folder: Path, count: int, seed: int) -> dict[str, Array]:
    """Return the errors of every half (2 count, 3) by who predicts it."""
    robot = dc.read_robot(folder / "robot.toml")
    recording = dc.read_recording(folder / "recording.csv", mechanism_of(robot))
    out: dict[str, list[list[float]]] = {"by hand, each row": [], "by hand, each wait once": [], "diagnose": []}
    for train, test in halves(recording, count, seed):
        found = dc.diagnose(robot, recording.subset(train))
        told = np.asarray(dc.predict(found, recording.subset(test)).measured) / DEG
        weights = (np.ones(recording.n_rows), waits(recording)[1])
        each = [*(by_hand(recording, train, test, weight) for weight in weights), told]
        for own, values in zip(out.values(), each, strict=True):
            own.append(errors(recording, test, values))
        named = ", ".join(f"{e.name} {list(e.limbs)}" for e in found.effects) or "nothing"
        print(f"named: {named}; {' '.join(f'{v:.3f}' for v in out['diagnose'][-1])}", flush=True)
    return {who: np.array(own) for who, own in out.items()}


def main(arguments: list[str] | None = None) -> int:
    """Compare, and print what it comes to."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--halves", type=int, default=4)
    parser.add_argument("--seed", type=int, default=7)
    said = parser.parse_args(arguments)
    found = compared(said.folder, said.halves, said.seed)
    for k, where in enumerate(WHERE):
        whole = {who: float(np.sqrt(np.mean(own[:, k] ** 2))) for who, own in found.items()}
        print(f"{where}, deg: " + ", ".join(f"{who} {value:.3f}" for who, value in whole.items()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
