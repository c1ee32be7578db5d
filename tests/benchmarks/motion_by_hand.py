"""The tool's ladders beside those by hand, joint by joint, as recorded and at 5, 10 and 20 Hz.

    python -m tests.benchmarks.motion_by_hand ROBOT.toml RECORDING.csv [RECORDING.csv ...]

Both leave residuals of folds that took part neither in choice nor in fit: the same folds, since what a stretch costs
that nobody has seen depends on the stretch. Compared are the samples that both hold out, through one low-pass. What the
tool takes for its cut-off comes of the joints, and knows nothing of these figures.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from deltacal_gen.files.robot import read_robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.motion.bodies import searched
from deltacal_gen.motion.session import Session
from deltacal_gen.motion.trajectories import read, read_sidecar
from tests.benchmarks import by_hand_motion

MOST = 1.05


def beside(robot: Path, recording: Path) -> list[tuple[int, list[float], list[float], list[str], list[str]]]:
    """Return of every joint that moves its number, the tool's rms and that by hand, and the rungs of both."""
    machine, said = read_robot(robot), read_sidecar(recording)
    assert said is not None, f"{recording} has no sidecar of kind torque"
    given = read(recording, mechanism_of(machine), said)
    session = Session.of(machine, given)
    rows, count = given.line - 2, int(given.line[-1]) - 1  # a header above, and lines left out as repaired
    split = np.full((2, count, len(session.joints)), -1)
    for joint in session.joints:
        split[:, rows[joint.rows], joint.number - 1] = joint.fold, joint.held
    _, time, step, names, by_hand = by_hand_motion.residuals(recording, robot, split)
    out = []
    for fit in searched(session, lambda _: None).fits:
        j = fit.joint.number - 1
        own = names[j]
        if own is None:
            continue
        tool = np.full(len(time), np.nan)
        tool[rows[fit.joint.rows]] = fit.held_out / fit.joint.readout.inside
        both = np.isfinite(tool) & np.isfinite(by_hand[:, j])
        figures = [by_hand_motion.low_passed(np.where(both, left, np.nan), step) for left in (tool, by_hand[:, j])]
        out.append((j + 1, *figures, [rung.effect for rung in fit.rungs], own))
    return out


def main(arguments: list[str] | None = None) -> int:
    """Print the table; return 1 where a joint is left with more than `MOST` times what is left by hand."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.benchmarks.motion_by_hand", description=__doc__.split("\n")[0]
    )
    parser.add_argument("robot", type=Path)
    parser.add_argument("recordings", type=Path, nargs="+")
    given, over = parser.parse_args(arguments), False
    for recording in given.recordings:
        for number, tool, by_hand, rungs, own in beside(given.robot, recording):
            ratios = [a / b for a, b in zip(tool, by_hand, strict=True)]
            over |= max(ratios) > MOST
            words = " ".join(f"{r:.3f}" for r in ratios)
            print(f"{recording.stem} joint {number}: {words} (recorded, 5, 10, 20 Hz)", flush=True)
            print(f"    {', '.join(rungs)}; by hand {', '.join(own)}", flush=True)
    return int(over)


if __name__ == "__main__":
    raise SystemExit(main())
