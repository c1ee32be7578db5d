"""Delta printers in a folder: what calibration leaves beside firmware's fit, and whether one session predicts another.

    python -m tests.benchmarks.printers FOLDER [--measured]

Every ``robot.toml`` of a linear delta under FOLDER with its ``recording.csv`` counts; recordings whose names are alike
up to ``-sNN`` and ``-meshN`` are sessions of one machine. From session to session everything is held but what firmware
fits (`linear_delta/6`), as the diagnosis of the earlier one has it.
"""

from __future__ import annotations

import argparse
import itertools
import re
from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np

import deltacal_gen as dc
from deltacal_gen.errors import DeltacalError
from tests.support.measured import write

COMMAND = "python -m tests.benchmarks.printers FOLDER --measured"
SESSION = re.compile(r"-s\d+(-mesh\d+)?$")
FIRMWARE = ("6", "9")  # without and with distances
BAR = 1.3  # held over own fit
MANY = 29  # readings of a mesh: with fewer, a fit of its own takes a good part of the noise away


def row(folder: Path) -> dict[str, Any]:
    """Return what a printer's recording comes to: rms [mm] as saved, by firmware's parameters, and by diagnosis."""
    robot, recording = folder / "robot.toml", folder / "recording.csv"
    with_distances = recording.with_suffix(".distances.csv").exists()
    firmware = dc.identify(robot, recording, model=FIRMWARE[with_distances])
    found = dc.diagnose(robot, recording)
    return {
        "name": folder.name,
        "readings": firmware["readings"]["scalars"],
        "distances": with_distances,
        "saved": firmware["before_rms_mm"],
        "firmware": firmware["train_rms_mm"],
        "model": found["baseline"]["model"],
        "fit": found["final"]["train_rms_mm"],
        "heldout": found["final"]["heldout_rms_mm"],
        "verdict": found["verdict"],
        "effects": [e["name"] for e in found["effects"]],
        "gross": len(found["gross_errors"]),
        "diagnosis": found,
    }


def carried(earlier: dict[str, Any], later: Path) -> dict[str, float]:
    """Return the rms [mm] of a later session: from the earlier one, with the same model fitted anew, by firmware."""
    robot, recording = later / "robot.toml", later / "recording.csv"
    held = dc.identify(robot, recording, model=FIRMWARE[0], physics=earlier["diagnosis"])
    own = dc.identify(robot, recording, model=earlier["model"])
    return {
        "held": held["train_rms_mm"],
        "own": own["train_rms_mm"],
        "firmware": dc.identify(robot, recording, model=FIRMWARE[0])["train_rms_mm"],
        "readings": held["readings"]["scalars"],
    }


def main() -> None:
    """Print both tables."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--measured", action="store_true", help="write the manual's tables too")
    given = parser.parse_args()
    found = sorted(p.parent for p in given.folder.rglob("robot.toml"))
    folders = [f for f in found if 'mechanism = "linear_delta"' in (f / "robot.toml").read_text(encoding="utf-8")]
    rows = each_recording(folders)
    told = by_size(rows)
    print("\n".join(", ".join(line) for line in told))
    kept = by_size_of_pairs(each_pair(rows))
    print("\n".join(", ".join(line) for line in kept))
    if given.measured:
        heads = ("readings", "recordings", "as saved, mm", "firmware's model, mm", "largest model, mm")
        write("printers", heads, told, COMMAND, note=f"{len(rows)} recordings of printers")
        write("printers_sessions", ("meshes of", "pairs", "held / own fit, median", f"within {BAR}"), kept, COMMAND)


def each_recording(folders: list[Path]) -> dict[Path, dict[str, Any]]:
    """Print what every recording comes to, and return `row` of those that can be used."""
    rows = {}
    print("| recording | readings | as saved | firmware's fit | diagnosis | model | held out | verdict |")
    print(8 * "|---" + "|")
    for folder in folders:
        try:
            r = rows[folder] = row(folder)
        except DeltacalError as error:
            print(f"| {folder.name} | {error} |")
            continue
        named = f": {', '.join(r['effects'])}" if r["effects"] else ""
        rms = " | ".join(f"{r[k]:.4f}" for k in ("saved", "firmware", "fit"))
        print(
            f"| {r['name']} | {r['readings']}{' with distances' if r['distances'] else ''} | {rms} | {r['model']} | "
            f"{r['heldout']:.4f} | {r['verdict']}{named} |",
            flush=True,
        )
    return rows


def by_size(rows: dict[Path, dict[str, Any]]) -> list[list[str]]:
    """Return how many recordings there are of a size, and the medians [mm] as saved, by firmware's fit, diagnosed."""
    groups: dict[str, list[dict[str, Any]]] = defaultdict(list)
    for r in rows.values():
        groups["heights and distances" if r["distances"] else _size(r["readings"])].append(r)
    return [
        [words, str(len(group)), *(f"{np.median([r[k] for r in group]):.3f}" for k in ("saved", "firmware", "fit"))]
        for words, group in sorted(groups.items(), key=lambda item: min(r["readings"] for r in item[1]))
    ]


def each_pair(rows: dict[Path, dict[str, Any]]) -> dict[bool, list[float]]:
    """Print how far meshes of a machine predict its later ones; return held over own fit, of many readings or few."""
    machines: dict[str, list[Path]] = defaultdict(list)
    for folder in rows:
        if "-mesh" in folder.name:
            machines[SESSION.sub("", folder.name)].append(folder)
    pairs = [pair for sessions in machines.values() for pair in itertools.combinations(sessions, 2)]
    print("\n| earlier | later | readings | held | own fit | firmware alone | held / own |\n" + 7 * "|---" + "|")
    ratios: dict[bool, list[float]] = defaultdict(list)
    for earlier, later in pairs:
        try:
            c = carried(rows[earlier], later)
        except DeltacalError as error:
            print(f"| {earlier.name} | {later.name} | {error} |")
            continue
        ratio = c["held"] / c["own"]
        ratios[c["readings"] >= MANY].append(ratio)
        rms = " | ".join(f"{c[k]:.4f}" for k in ("held", "own", "firmware"))
        print(f"| {earlier.name} | {later.name} | {c['readings']} | {rms} | {ratio:.2f} |", flush=True)
    return ratios


def by_size_of_pairs(ratios: dict[bool, list[float]]) -> list[list[str]]:
    """Return how many pairs there are of a size, the median of their ratios, and the part within the bar."""
    return [
        [
            f"{MANY} heights and more" if many else f"fewer than {MANY} heights",
            str(len(values)),
            f"{np.median(values):.2f}",
            f"{np.mean(np.array(values) <= BAR):.0%}",
        ]
        for many, values in sorted(ratios.items(), reverse=True)
    ]


def _size(readings: int) -> str:
    """Return which recordings are told together: those of as many heights, meshes of many as one."""
    return f"{MANY} heights and more" if readings >= MANY else f"{readings} heights"


if __name__ == "__main__":
    main()
