"""What every recording of a folder ends with: ``python -m tests.benchmarks.sweep FOLDER [FOLDER ...]``.

Of every CSV file beside a ``robot.toml`` under a folder that has a sidecar, all and two halves of its poses, drawn at
random, are diagnosed, each in a process of its own: seconds of CPU and peak memory as a user pays them, exit code,
verdict, and whether the fit that is told ended at its tolerance. Half by half the other is predicted, by geometry alone
and by what was found. Printed is what breaks a bound, what was refused, and what predictions are worth: of small
recordings the median over each kind. A recording in motion is diagnosed whole. What there is to do is done as
`sitting` says.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.sitting import Entry, add_options, sit

MOST_S, MOST_MIB = 60.0, 1024.0  # of CPU, and of memory
ENDED_S = 300  # of CPU, after which a process is ended
SMALL = 60  # readings: of fewer one half tells so little that a kind is judged as a whole
WORSE = 1.02  # times the error of geometry alone: what a prediction may have
PARTS = ("whole", "half", "other half")
SEED = 7
MOTION = "torque"  # kind of recordings in motion
ROOT = Path(__file__).resolve().parents[2]
Job = tuple[str, str]  # recording, part


# ------------------------------------------------------------------------------------------------- in its own process


def one(file: Path, part: str, out: Path) -> int:
    """Write what comes of a recording or half of it; return the exit code of the command line."""
    from deltacal_gen.errors import DeltacalError

    said: Entry = {}
    try:
        said = _diagnosed(file, part)
    except DeltacalError as error:
        said = _spent() | {"code": error.exit_code, "message": str(error)}
    out.write_text(json.dumps(said), encoding="utf-8")
    return int(said.get("code", 0))


def _spent() -> Entry:
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (2**20 if sys.platform == "darwin" else 2**10)
    return {"cpu": time.process_time(), "MiB": peak}


def _diagnosed(file: Path, part: str) -> Entry:
    import deltacal_gen as dc
    from deltacal_gen.diagnosis.diagnosis import diagnose
    from deltacal_gen.diagnosis.refits import SEARCHED
    from deltacal_gen.machine.registry import mechanism_of
    from tests.benchmarks.real import error

    if moves(file):
        verdict = dc.diagnose(file.parent / "robot.toml", file)["verdict"]
        return _spent() | {"kind": MOTION, "verdict": str(verdict)}
    robot = dc.read_robot(file.parent / "robot.toml")
    recording = dc.read_recording(file, mechanism_of(robot))
    own, other = recording, None
    if part != "whole":
        poses = np.unique(recording.pose)
        np.random.default_rng([SEED, 0]).shuffle(poses)
        first = np.isin(recording.pose, poses[: len(poses) // 2]) == (part == "half")
        own, other = (recording.subset(np.flatnonzero(rows)) for rows in (first, ~first))
    found = diagnose(robot, own)
    said = _spent() | {"kind": recording.kind, "rows": recording.n_rows, "verdict": found.verdict.value}
    said |= {"gradient": found.final.history[-1], "tolerance": SEARCHED}
    if other is not None:
        said["errors"] = [error(dc.identify(robot, own), other), error(found.answer(), other)]
    return said


def moves(file: Path) -> bool:
    """Tell whether a recording is of torques in motion."""
    measurement = tomllib.loads(file.with_suffix(".toml").read_text(encoding="utf-8")).get("measurement", {})
    return measurement.get("kind") == MOTION


# ----------------------------------------------------------------------------------------------------------- the whole


def examine(job: Job) -> Entry:
    """Return what came of a recording, or half of it, in a process of its own."""
    with tempfile.TemporaryDirectory() as place:
        out = Path(place) / "said.json"
        run = subprocess.run(
            [sys.executable, "-m", "tests.benchmarks.sweep", "--one", *job, str(out)],
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (ENDED_S, ENDED_S)),
        )
        said: Entry = json.loads(out.read_text(encoding="utf-8")) if out.exists() else {}
    if not said:
        last = (run.stderr.strip().splitlines() or [f"ended after {ENDED_S} s of CPU, or by a signal"])[-1]
        said = {"message": last, "broken": True}
    return said | {"code": run.returncode}


def jobs(folders: Iterable[Path]) -> list[Job]:
    """Return every recording and half of it under some folders."""
    robots = {path.parent for folder in folders for path in folder.rglob("robot.toml")}
    every = [file.resolve() for robot in sorted(robots) for file in sorted(robot.glob("*.csv"))]
    every = [file for file in every if file.with_suffix(".toml").exists()]
    return [(str(file), part) for file in every for part in (PARTS[:1] if moves(file) else PARTS)]


def bounds(said: Mapping[str, Any]) -> list[str]:
    """Return which bounds what came of a recording breaks, in words."""
    out = [f"exit {said['code']}: {said['message']}"] if said.get("broken") else []
    if said.get("cpu", 0.0) > MOST_S:
        out.append(f"{said['cpu']:.0f} s of CPU")
    if said.get("MiB", 0.0) > MOST_MIB:
        out.append(f"{said['MiB']:.0f} MiB")
    if "gradient" in said and not said["gradient"] <= said["tolerance"]:
        out.append(f"a further step would gain {said['gradient']:.1e} of chi2")
    return out


def told(done: Mapping[Job, Entry]) -> Iterable[str]:
    """Return what all recordings together say."""
    for (file, part), said in done.items():
        name = f"{_name(file)}, {part}"
        if broken := bounds(said):
            yield f"{name}: {'; '.join(broken)}"
        elif said["code"]:
            yield f"{name}: refused (exit {said['code']}): {said['message'][:100]}"
    cpu, peak = (np.array([said[key] for said in done.values() if key in said]) for key in ("cpu", "MiB"))
    if len(cpu):
        broken = sum(bool(bounds(said)) for said in done.values())
        verdicts = [said.get("verdict", f"exit {said['code']}") for said in done.values()]
        counts = ", ".join(f"{verdicts.count(v)} {v}" for v in sorted(set(verdicts)))
        yield f"{len(done)} recordings and halves, {broken} break a bound: {counts}"
        yield f"CPU {np.median(cpu):.1f} s, at most {cpu.max():.1f}; memory {np.median(peak):.0f} MiB, {peak.max():.0f}"
    yield from worth(done)


def worth(done: Mapping[Job, Entry]) -> Iterable[str]:
    """Return what was found predicts of the other half, by what geometry alone does."""
    ratios: dict[str, list[float]] = {}
    kinds: dict[str, list[float]] = {}
    for (file, _), said in done.items():
        if "errors" in said:
            alone, found = said["errors"]
            if said["rows"] < SMALL:
                kinds.setdefault(said["kind"], []).append(found / alone)
            else:
                ratios.setdefault(file, []).append(found / alone)
    for kind, values in kinds.items():
        words = f"error to geometry's {np.median(values):.3f} in the median of {len(values)} halves"
        yield f"{kind}, fewer than {SMALL} readings: {words}"
    worse = {file: float(np.mean(values)) for file, values in ratios.items() if np.mean(values) > WORSE}
    yield f"of {len(ratios)} larger recordings {len(worse)} are predicted worse than {WORSE} times as geometry does"
    for file, ratio in worse.items():
        yield f"  {_name(file)}: {ratio:.3f}"


def _name(file: str) -> str:
    return "/".join(Path(file).with_suffix("").parts[-3:])


def main(arguments: list[str] | None = None) -> int:
    """Diagnose all recordings, and print what they come to; return 1 where one breaks a bound."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.sweep", description=__doc__.split("\n")[0])
    parser.add_argument("folders", nargs="*", type=Path)
    parser.add_argument("--one", nargs=3, metavar=("FILE", "PART", "OUT"), help=argparse.SUPPRESS)
    parser.add_argument("--every", type=int, default=1, metavar="N", help="each N-th recording alone")
    add_options(parser)
    given = parser.parse_args(arguments)
    if given.one:
        return one(Path(given.one[0]), given.one[1], Path(given.one[2]))
    asked = jobs(given.folders)
    chosen = sorted({file for file, _ in asked})[:: given.every]
    found = sit(examine, [job for job in asked if job[0] in chosen], given)
    for line in told(found.done):
        print(line)
    return found.code or int(any(map(bounds, found.done.values())))


if __name__ == "__main__":
    sys.exit(main())
