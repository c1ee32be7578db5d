"""Do the stated figures hold: names, p-values, intervals, power, proposals: ``python -m tests.benchmarks.honesty``.

Every recording is a job with a seed of its own; what is done is kept in a file of lines (``--kept``), so that a run
that was ended goes on where it stopped. Parts of a whole come with Wilson intervals.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.identification.identification import identify
from deltacal_gen.use.bands import named, predicted_bands
from deltacal_gen.use.prediction import predict
from tests.benchmarks.honesty_chance import SORTS as LOOKS
from tests.benchmarks.honesty_chance import p_value
from tests.benchmarks.honesty_coverage import SORTS as COVERED
from tests.benchmarks.honesty_coverage import covered
from tests.benchmarks.honesty_nulls import ROBOT, SIGMA, SORTS, null
from tests.benchmarks.honesty_power import ASKED, EFFECTS, apart, five, powered, preferred
from tests.benchmarks.honesty_rounds import SORTS as AMBIGUOUS
from tests.benchmarks.honesty_rounds import round_of
from tests.benchmarks.laws import wilson
from tests.conftest import plausible
from tests.left_out import DELTA, record

NEW = 25  # poses at which bands are asked
ALIKE = 10.0  # of chi2: effects that poses of an ideal detector part by less are not told apart
BOUNDS = (0.01, 0.05)  # below which parts of the p-values of nulls are counted
MODELS = ("42", "18", "3")
Job = tuple[str, str, int]


def examined(job: Job) -> dict[str, Any]:
    """Return what came of a job."""
    what, sort, k = job
    if what == "null":
        found = diagnose(ROBOT, null(sort, k)).answer()
        assert found.search is not None
        assert found.noise.model is not None
        return {
            "named": bool(found.effects or found.laws),
            "unexplained": found.verdict == "unexplained",
            "hinted": bool(found.hints),
            "p": found.search.p_value,
            "sigma": found.sigma_mm,
            "rows": found.noise.model.rows,
        }
    if what == "chance":
        return {"p": p_value(sort, k)}
    if what == "bands":
        errors = plausible(DELTA, 1000 + k)
        result = identify(ROBOT, record(ROBOT, n=60, seed=k, errors=errors), sort).answer()
        true = record(ROBOT, n=NEW, seed=5000 + k, errors=errors, sigma=0.0)
        ends = predicted_bands(result, true, predict(result, true))
        pairs = zip(true.measured.T, map(named, true.columns), strict=True)
        inside = [(ends[low] <= v) & (v <= ends[high]) for v, (low, high) in pairs]
        return {"inside": int(np.sum(inside)), "of": int(np.size(inside))}
    if what == "coverage":
        inside, of = covered(sort, k)
        return {"inside": inside, "of": of}
    if what == "round":
        return round_of(sort, k)
    if what == "five":
        made, terms = five(k)
        several = diagnose(ROBOT, made).answer()
        sets = [{e.name, *e.indistinguishable_from} for e in several.effects]
        return {"named": all(any(t.effect in s for s in sets) for t in terms)}
    name, asked = sort.split("/")
    answer = diagnose(ROBOT, powered(name, asked, k)).answer()
    right = any(e.name == name for e in answer.effects)
    among = right or any(name in e.indistinguishable_from for e in answer.effects)
    told = among or any(name in (h.name, *h.indistinguishable_from) for h in answer.hints)
    alone = apart(name, asked, k)
    return {
        "named": right,
        "named or among what is not told apart": among,
        "told": told,
        "another effect within 10 of chi2 by rights": alone < ALIKE,
        "preferred": preferred(alone),
    }


def jobs(count: int, only: str = "") -> list[Job]:
    """Return all jobs, `count` of each sort; `only` those whose kind and sort hold some words."""
    sorts = [("null", s) for s in SORTS] + [("bands", m) for m in MODELS] + [("five", "effects at once")]
    sorts += [("chance", look) for look in LOOKS]
    sorts += [("coverage", c) for c in COVERED] + [("round", name) for name in AMBIGUOUS]
    sorts += [("power", f"{name}/{asked}") for name in EFFECTS for asked in ASKED]
    wanted = [s for s in sorts if any(words in " ".join(s) for words in only.split(","))]
    return [(what, sort, k) for k in range(count) for what, sort in wanted]


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
        if what in ("bands", "coverage"):
            words = f"delta/{sort}: true readings within their bands" if what == "bands" else f"intervals of {sort}"
            row(words, sum(e["inside"] for e in own), sum(e["of"] for e in own))
            continue
        where = f"noise {sort}" if what == "null" else f"{what} {sort}"
        for key in dict.fromkeys(key for e in own for key, value in e.items() if isinstance(value, bool)):
            said = [e[key] for e in own if key in e]
            row(f"{where}: {key}", sum(said), len(said))
        if what == "power":
            best = float(np.mean([e["preferred"] for e in own]))
            shown.add_row(f"{where}: who knows it and its rival prefers it", str(len(own)), f"{best:.3f}", "")
        if what in ("null", "chance"):
            p = [e["p"] for e in own]
            shown.add_row(f"{where}: p-values, distance from uniform", str(len(own)), f"{distance(p):.3f}", "")
            for bound in BOUNDS:
                row(f"{where}: p-values below {bound}", sum(value < bound for value in p), len(p))
        if what == "null":
            low, middle, high = np.quantile([e["sigma"] / SIGMA for e in own], [0.1, 0.5, 0.9])
            shown.add_row(f"{where}: size of noise", str(len(own)), f"{middle:.3f}", f"80 %: {low:.2f} to {high:.2f}")
            low, middle, high = np.quantile([e["rows"] for e in own], [0.1, 0.5, 0.9])
            shown.add_row(
                f"{where}: rows that count as one", str(len(own)), f"{middle:.1f}", f"{low:.1f} to {high:.1f}"
            )
    return shown


def main(arguments: list[str] | None = None) -> int:
    """Do the jobs that are not done yet, and print what they come to."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.honesty", description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=300, help="recordings of each sort (default 300)")
    parser.add_argument("--quick", action="store_true", help="20 of each sort")
    parser.add_argument("--only", default="", help="sorts that hold one of these words, parted by commas")
    parser.add_argument("--minutes", type=float, default=np.inf, help="stop then; what is done is shown")
    parser.add_argument("--kept", type=Path, help="file of lines in which what is done is kept")
    given = parser.parse_args(arguments)
    done: dict[Job, dict[str, Any]] = {}
    if given.kept is not None and given.kept.exists():
        for line in given.kept.read_text(encoding="utf-8").splitlines():
            job, entry = json.loads(line)
            done[tuple(job)] = entry
    asked, end = jobs(20 if given.quick else given.count, given.only), time.monotonic() + 60 * given.minutes
    for n, job in enumerate(asked):
        if job in done or time.monotonic() > end:
            continue
        done[job] = examined(job)
        print(f"\r{n + 1} of {len(asked)}", end="", file=sys.stderr, flush=True)
        if given.kept is not None:
            with given.kept.open("a", encoding="utf-8") as file:
                file.write(json.dumps([job, done[job]]) + "\n")
    print(file=sys.stderr)
    Console(width=None if sys.stdout.isatty() else 120).print(table({job: done[job] for job in asked if job in done}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
