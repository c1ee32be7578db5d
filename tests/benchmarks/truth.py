"""What each instrument can know of each machine: ``python -m tests.benchmarks.truth [--measured]``.

Ranks of the largest models at poses without any symmetry, with all that is unknown of the instrument projected out:
how many of a model's parameters, or independent combinations of them, the readings tell.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from deltacal_gen.identification.identifiability import RANK_TOLERANCE
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import mechanism_names, mechanism_of
from deltacal_gen.machine.values import Camera, Measurement, Robot
from derive.review import checks
from derive.review.subjects import example
from tests.support.measured import write

COMMAND = "python -m tests.benchmarks.truth --measured"
MORE: dict[str, tuple[str, Mapping[str, Any]]] = {  # what else may be unknown of boards
    "points of a board in an unknown place, its print's scale unknown": ("touched_board", {"board_scale": "unknown"}),
    "images of a board, the print's scale unknown": ("board_image", {"board_scale": "unknown"}),
    "images of a board, the lens unknown": (
        "board_image",
        {"camera": Camera(**dict.fromkeys(("k1", "k2", "p1", "p2", "k3"), math.nan))},
    ),
}

BEHIND = {  # whether the zeros are unknown
    "a second encoder on every joint, its zero unknown": True,
    "a second encoder on every joint, its zero known": False,
}


def machines() -> dict[str, dict[str, str]]:
    """Return by machine what each kind of reading sees of its largest model."""
    found: dict[str, dict[str, str]] = {}
    for name in mechanism_names():
        robot = example(name)
        if robot is None:
            continue
        mechanism = mechanism_of(robot)
        names, at = mechanism.models[mechanism.full_model], checks.trials(robot)
        typical = mechanism.typical[[mechanism.index[n] for n in names]]
        column = {rank.kind: f"{rank.rank} of {rank.columns}" for rank in checks.ranks(robot, at, names)}
        for words, (kind, said) in MORE.items():
            if kind_of(kind).looks(mechanism, 1, 1):
                H = checks.identification(robot, at.sets[:1], list(names), kind_of(kind), said=said)
                s = np.linalg.svd(H * typical, compute_uv=False)
                column[words] = f"{int((s > RANK_TOLERANCE * s[0]).sum())} of {len(names)}"
        column |= {words: f"{behind(robot, at, names, words)} of {len(names)}" for words in BEHIND}
        found[mechanism.full_model] = column
    return found


def behind(robot: Robot, at: checks.Trials, names: Sequence[str], words: str) -> int:
    """Return the rank by encoders on the joints themselves, their zeros projected out where these are unknown.

    They see errors that move the platform, wherever it is, as a step of joints does: as that step. Of what moves it
    otherwise they see nothing.
    """
    mechanism, poses = mechanism_of(robot), at.poses
    moved = mechanism.sensitivity(poses.x, poses.q, poses.tool, mechanism.rows(robot))
    typical = mechanism.typical[[mechanism.index[n] for n in names]]
    by_errors = moved.parameters[:, :, [mechanism.index[n] for n in names]] * typical
    both = np.concatenate([by_errors, -kind_of("encoder").typical[0] * moved.joints], axis=2)
    _, size, each = np.linalg.svd(np.linalg.qr(both.reshape(-1, both.shape[2]), mode="r"))
    step = kind_of("encoder").typical[0] * each[size <= RANK_TOLERANCE * size[0], len(names) :].T
    found, instrument = kind_of("encoder").imagined(poses.q, 1, mechanism, Measurement())
    dx = np.broadcast_to(step, (len(poses.q), *step.shape))
    J, zeros = (v.reshape(len(found), -1) for v in instrument.linearise(found, poses.q, dx))
    if BEHIND[words]:
        J = J - zeros @ np.linalg.lstsq(zeros, J, rcond=None)[0]
    least = RANK_TOLERANCE * float(np.linalg.norm(zeros)) * float(kind_of("encoder").typical[0])
    return int((np.linalg.svd(J, compute_uv=False) > least).sum())


def main(arguments: Sequence[str]) -> int:
    """Print the table, or write it for the manual."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--measured", action="store_true", help="write the manual's table")
    asked = parser.parse_args(arguments)
    found = machines()
    kinds = list(dict.fromkeys(kind for column in found.values() for kind in column))
    rows = [[kind, *(column.get(kind, "-") for column in found.values())] for kind in kinds]
    if asked.measured:
        print(write("truth", ["what is read", *found], rows, COMMAND, packages=("deltacal_gen", "numpy")))
    else:
        print(*(" | ".join(row) for row in [["", *found], *rows]), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
