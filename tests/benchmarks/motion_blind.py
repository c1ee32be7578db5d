"""Drives that have what nobody says, diagnosed blind: how often it is named, how large, and how well it predicts.

    python -m tests.benchmarks.motion_blind --count 200 --kept blind.jsonl [--rate 500] [--files FOLDER]

Nothing, one, two or three effects, or what no effect is (Bouc-Wen, a counterweight with a spring, friction that runs
in, a cable that drags), on an arm of six joints and a six-rod Delta; see `motion_cases`. What was done is kept, and
goes on where it ended; the table stands beside it (``blind.txt``), and with ``--files`` what the tool was given stays.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import deltacal_gen as dc
from tests.benchmarks.motion_cases import FOREIGN, NOISE, RUNS, Case, Concealed, generate, write

KINDS = ("0", "1", "1", "2", "3", *FOREIGN, "1")  # of ten cases in a row
SURE = 3.0  # standard deviations
GROUPS = {"nothing": ("0",), "one": ("1",), "two or three": ("2", "3"), "foreign": FOREIGN}
HEADS = ("concealed", "cases", "right", "with a false name", "within 3 std", "to ideal", "CPU")


def kind_of(seed: int) -> str:
    """Return what a seed conceals: each kind falls to both machines."""
    return KINDS[(seed // 2) % len(KINDS)]


def examine(seed: int, rate: float, files: Path | None = None) -> dict[str, Any]:
    """Generate a case, diagnose it blind, and grade the answer; its files stay in a folder `files` of its own."""
    case = generate(seed, kind_of(seed), rate)
    with tempfile.TemporaryDirectory() as folder:
        robot, recording = write(case, Path(folder) if files is None else files / f"m{seed:03d}")
        start = time.process_time()
        found = dc.diagnose(robot, recording)
        spent = time.process_time() - start
    return grade(case, found.to_dict()) | {"cpu_s": round(spent, 2)}


def grade(case: Case, found: dict[str, Any]) -> dict[str, Any]:
    """Return how an answer to a case ends."""
    named = {(e["name"], j): e for e in found["effects"] for j in e["limbs"] or [0]}
    true = {(each.name, each.joint): each for each in case.concealed if each.name not in FOREIGN}
    alike = {(name, j) for (_, j), e in named.items() for name in e["indistinguishable_from"]}
    lawful = sorted({int(j) for law in found.get("laws", ()) for term in law["terms"] for j in term["limbs"]})
    open_ = sorted({int(u["limb"]) for u in found["unexplained"]} | set(lawful))  # a law borne out is an answer, too
    off = [d for key, each in true.items() if key in named for d in deviations(each, named[key])]
    strange = [
        key for key in named if key not in true and not set(named[key]["indistinguishable_from"]) & _at(true, key)
    ]
    foreign = [each.joint for each in case.concealed if each.name in FOREIGN]
    if foreign:  # an effect at its joint may stand for a part of it; what is asked is that it is not all that is said
        strange = [key for key in strange if key[1] not in foreign]
    return {
        "seed": case.seed,
        "machine": case.machine,
        "engine": case.engine,
        "kind": case.kind,
        "stated": case.stated,
        "true": [[each.name, each.joint, each.values] for each in case.concealed],
        "named": [list(key) for key in named],
        "verdict": found["verdict"],
        "unexplained": open_,
        "laws": [term["expression"] for law in found.get("laws", ()) for term in law["terms"]],
        "right": all(key in named or key in alike for key in true) and not strange and (open_ == sorted(set(foreign))),
        "missed": [list(key) for key in true if key not in named and key not in alike],
        "false": [list(key) for key in strange],
        "off": off,
        "ratio": over_ideal(case, found),
    }


def _at(true: dict[tuple[str, int], Concealed], key: tuple[str, int]) -> set[str]:
    """Return the names of what a joint truly has."""
    return {name for name, joint in true if joint == key[1]}


def deviations(each: Concealed, named: dict[str, Any]) -> list[list[Any]]:
    """Return name, true value and how many standard deviations it is off, of every parameter that has some."""
    values = dict(each.values)
    if each.name == "presliding_friction":
        values["travel"] = values.pop("force") / values["stiffness"]
    told = {p["name"]: p for p in named["parameters"] if p.get("limb") in (each.joint, None)}
    return [
        [name, v, round((told[name]["value"] - v) / told[name]["std"], 2)]
        for name, v in values.items()
        if name in told and told[name].get("std")
    ]


def over_ideal(case: Case, found: dict[str, Any]) -> float:
    """Return held-out error over what an ideal fit leaves, its coefficients' share added, rms over joints."""
    at, rows = case.movement, len(case.tau) * (RUNS - 1) / RUNS
    noise = NOISE * np.sqrt(np.mean(at.load**2, axis=0)) / 1e3
    ideal = np.sqrt(1.0 + len(case.concealed) / rows)  # what nobody knows counts for the tool, not for the ideal
    left = np.array([v if v is not None else np.nan for v in found["final"]["heldout_rms_by_joint"]])
    return float(np.sqrt(np.nanmean((left / noise) ** 2)) / ideal)


def told(rows: Sequence[dict[str, Any]]) -> list[list[str]]:
    """Return what came of all, in the order of `HEADS`, by what was concealed."""
    found = []
    for name, kinds in GROUPS.items():
        if own := [r for r in rows if r["kind"] in kinds]:
            off = np.array([abs(d[2]) for r in own for d in r["off"]])
            found.append(
                [
                    name,
                    str(len(own)),
                    str(sum(r["right"] for r in own)),
                    str(sum(bool(r["false"]) for r in own)),
                    f"{np.sum(off < SURE)}/{len(off)}" if len(off) else "",
                    f"{np.median([r['ratio'] for r in own]):.3f}",
                    f"{np.median([r['cpu_s'] for r in own]):.1f} s",
                ]
            )
    return found


def table(rows: Sequence[dict[str, Any]]) -> str:
    """Return what came of all, in words."""
    lines = [
        f"{name:13s} {right:>3s} of {count:>3s} right   over ideal {ratio}   {cpu} of CPU"
        for name, count, right, _, _, ratio, cpu in told(rows)
    ]
    off = np.array([abs(d[2]) for r in rows for d in r["off"]])
    false = sum(bool(r["false"]) for r in rows)
    lines.append(f"false names in {false} of {len(rows)}; within {SURE:g} std {np.sum(off < SURE)} of {len(off)}")
    return "\n".join(lines)


def kept(path: Path) -> list[dict[str, Any]]:
    """Return the cases that a file holds; none where there is no such file."""
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


def main(arguments: list[str] | None = None) -> int:
    """Examine cases until there are enough, and print the table."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.motion_blind", description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--rate", type=float, default=500.0, help="samples per second")
    parser.add_argument("--kept", type=Path, default=Path("motion_blind.jsonl"))
    parser.add_argument("--files", type=Path, help="folder in which the cases stay")
    given = parser.parse_args(arguments)
    rows = kept(given.kept)
    done = {row["seed"] for row in rows}
    for seed in range(given.first, given.first + given.count):
        if seed in done:
            continue
        rows.append(examine(seed, given.rate, given.files))
        given.kept.parent.mkdir(parents=True, exist_ok=True)
        with given.kept.open("a") as file:
            file.write(json.dumps(rows[-1]) + "\n")
        print(seed, rows[-1]["kind"], "right" if rows[-1]["right"] else rows[-1], flush=True)
    given.kept.with_suffix(".txt").write_text(table(rows) + "\n")
    print(table(rows))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
