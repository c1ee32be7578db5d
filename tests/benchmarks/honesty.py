"""Do the stated figures hold: names on noise, p-values, bands, power: ``python -m tests.benchmarks.honesty``.

Every recording is a job with a seed of its own; what is done is kept in a file of lines (``--kept``), so that a run
that was ended goes on where it stopped. Parts of a whole come with Wilson intervals.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.values import Recording
from deltacal_gen.use.bands import named, predicted_bands
from deltacal_gen.use.prediction import predict
from tests.benchmarks.laws import wilson
from tests.conftest import plausible
from tests.left_out import DELTA, channels, effect, machine, record

SIGMA = 0.01  # mm
POSES, NEW = 100, 25
NOISES = ("white", "uniform", "t3", "AR 0.5", "AR 0.9", "gross", "rounded", "walk")
MODELS = ("42", "18", "3")
PLAY = (0.0011, 0.0013, 0.0015, 0.0017, 0.002)  # deg
ROBOT = machine()
Job = tuple[str, str, int]


def noise(sort: str, shape: tuple[int, ...], rng: np.random.Generator) -> np.ndarray:
    """Return noise (n, 3) of a sort, of unit size but for its gross errors and drifts."""
    e = rng.standard_normal(shape)
    if sort == "uniform":
        return rng.uniform(-(3**0.5), 3**0.5, shape)
    if sort == "t3":
        return rng.standard_t(3, shape) / 3**0.5
    if sort.startswith("AR"):
        rho = float(sort.split()[1])
        for i in range(1, len(e)):
            e[i] = rho * e[i - 1] + (1 - rho**2) ** 0.5 * e[i]
    if sort == "gross":
        e[rng.choice(len(e), 3, replace=False)] += rng.normal(0, 20, (3, shape[1]))
    if sort == "walk":
        e = 0.5 * e + np.cumsum(0.3 * rng.standard_normal(shape), axis=0)
    return e


def null(sort: str, k: int) -> Recording:
    """Return a recording of a machine to which nothing is missing."""
    of = channels(POSES, "approach", "temp", "time", "payload", seed=k)
    errors = plausible(DELTA, k, size=0.3)
    made = record(ROBOT, seed=4000 + k, n=POSES, of=of, errors=errors, sigma=0.0, declared=False)
    read = made.measured + SIGMA * noise(sort, made.measured.shape, np.random.default_rng([k, 77]))
    return dataclasses.replace(made, measured=np.round(read, 2) if sort == "rounded" else read)


def examined(job: Job) -> dict[str, Any]:
    """Return what came of a job."""
    what, sort, k = job
    if what == "null":
        found = diagnose(ROBOT, null(sort, k)).answer()
        assert found.search is not None
        return {
            "named": bool(found.effects or found.laws),
            "unexplained": found.verdict == "unexplained",
            "hinted": bool(found.hints),
            "p": found.search.p_value,
        }
    errors = plausible(DELTA, 1000 + k)
    if what == "bands":
        result = identify(ROBOT, record(ROBOT, n=60, seed=k, errors=errors), sort).answer()
        true = record(ROBOT, n=NEW, seed=5000 + k, errors=errors, sigma=0.0)
        ends = predicted_bands(result, true, predict(result, true))
        pairs = zip(true.measured.T, map(named, true.columns), strict=True)
        inside = [(ends[low] <= v) & (v <= ends[high]) for v, (low, high) in pairs]
        return {"inside": int(np.sum(inside)), "of": int(np.size(inside))}
    of = channels(POSES, "approach", "temp", "time", "payload", seed=k)
    play = effect("backlash", (2,), float(sort))
    answer = diagnose(ROBOT, record(ROBOT, play, seed=6000 + k, n=POSES, of=of, declared=False)).answer()
    told = {name for h in answer.hints for name in (h.name, *h.indistinguishable_from)}
    right = any(e.name == "backlash" for e in answer.effects)
    return {"named": right, "told": right or "backlash" in told}


def jobs(count: int) -> list[Job]:
    """Return all jobs, `count` of each sort."""
    sorts = [("null", s) for s in NOISES] + [("bands", m) for m in MODELS] + [("power", str(size)) for size in PLAY]
    return [(what, sort, k) for k in range(count) for what, sort in sorts]


def distance(p: Iterable[float]) -> float:
    """Return Kolmogorov's distance of numbers from uniform ones."""
    from scipy.stats import kstest

    return float(kstest(list(p), "uniform").statistic)


def table(done: Mapping[Job, Mapping[str, Any]]) -> Table:
    """Return all figures, parts of a whole with their intervals."""
    shown = Table("figure", "of", "part", "95 %")

    def row(words: str, hits: int, count: int) -> None:
        low, high = wilson(hits, count)
        shown.add_row(words, str(count), f"{hits / count:.3f}", f"{low:.3f} to {high:.3f}")

    for what, sort in dict.fromkeys(job[:2] for job in done):
        own = [e for job, e in done.items() if job[:2] == (what, sort)]
        if what == "bands":
            row(
                f"delta/{sort}: true readings within their bands",
                sum(e["inside"] for e in own),
                sum(e["of"] for e in own),
            )
            continue
        where = f"noise {sort}" if what == "null" else f"play of {sort} deg"
        for key in ("named", "unexplained", "hinted") if what == "null" else ("named", "told"):
            row(f"{where}: {key}", sum(e[key] for e in own), len(own))
        if what == "null":
            shown.add_row(
                f"{where}: p-values, distance from uniform", str(len(own)), f"{distance(e['p'] for e in own):.3f}", ""
            )
    return shown


def main(arguments: list[str] | None = None) -> int:
    """Do the jobs that are not done yet, and print what they come to."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.honesty", description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=300, help="recordings of each sort (default 300)")
    parser.add_argument("--quick", action="store_true", help="40 of each sort")
    parser.add_argument("--kept", type=Path, help="file of lines in which what is done is kept")
    given = parser.parse_args(arguments)
    done: dict[Job, dict[str, Any]] = {}
    if given.kept is not None and given.kept.exists():
        for line in given.kept.read_text(encoding="utf-8").splitlines():
            job, entry = json.loads(line)
            done[tuple(job)] = entry
    asked = jobs(40 if given.quick else given.count)
    for n, job in enumerate(asked):
        if job in done:
            continue
        done[job] = examined(job)
        print(f"\r{n + 1} of {len(asked)}", end="", file=sys.stderr, flush=True)
        if given.kept is not None:
            with given.kept.open("a", encoding="utf-8") as file:
                file.write(json.dumps([job, done[job]]) + "\n")
    print(file=sys.stderr)
    Console(width=None if sys.stdout.isatty() else 120).print(table({job: done[job] for job in asked}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
