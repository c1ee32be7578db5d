"""Do the stated figures hold: names, p-values, intervals, power, proposals: ``python -m tests.benchmarks.honesty``.

Every recording is a job with a seed of its own, done as `sitting` says: by some processes, what is done kept in a file
of lines (``--kept``), so that a run that was ended goes on where it stopped. Parts of a whole come with Wilson
intervals, of however much is done. How often the tool names something in white noise (``--only false``) is the rate
that the ideal detector of the power allows itself, once enough of it is kept.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.identification.identification import identify
from deltacal_gen.results.parts import Source
from deltacal_gen.use.bands import named, predicted_bands
from deltacal_gen.use.prediction import predict
from tests.benchmarks import honesty_likelihood as likelihood
from tests.benchmarks.honesty_chance import SORTS as LOOKS
from tests.benchmarks.honesty_chance import p_value
from tests.benchmarks.honesty_coverage import SORTS as COVERED
from tests.benchmarks.honesty_coverage import covered
from tests.benchmarks.honesty_nulls import ROBOT, SIGMA, SORTS, null
from tests.benchmarks.honesty_power import ASKED, EFFECTS, FALSE, apart, five, powered, preferred
from tests.benchmarks.honesty_rounds import SORTS as AMBIGUOUS
from tests.benchmarks.honesty_rounds import round_of
from tests.benchmarks.sitting import Entry, Sitting, add_options, kept, sit, wilson
from tests.support.left_out import DELTA, record
from tests.support.prototype import plausible

NEW = 25  # poses at which bands are asked
ALIKE = 10.0  # of chi2: effects that poses of an ideal detector part by less are not told apart
BOUNDS = (0.01, 0.05)  # below which parts of the p-values of nulls are counted
NEAR = 0.2  # of its size, within which noise is known well
WRONGLY = ("understated", "overstated")  # sorts in which what is declared is wrong: who keeps to it errs
WORSE = 1.3  # times the readings of the best design: what proposals may take
MODELS = ("42", "18", "3")
# recordings of each sort: of the whole, and within 20 minutes; intervals come by dozens from each
COUNTS = {
    "null": (300, 20),
    "false": (2000, 40),
    "chance": (500, 20),
    "bands": (40, 3),
    "coverage": (70, 3),
    "round": (8, 1),
    "five": (40, 3),
    "power": (100, 8),
}
BEYOND = 100_000  # where the white nulls of the rate of false names begin: no other job has one of them
ENOUGH = 1000  # of them: fewer do not tell a rate of one in a thousand
Job = tuple[str, str, int]


# ---------------------------------------------------------------------------------------------------------------- jobs


def examined(job: Job) -> Entry:
    """Return what came of a job."""
    what, sort, k = job
    if what == "null":
        return _null(sort, k)
    if what == "false":
        found = diagnose(ROBOT, null(sort, BEYOND + k)).answer()
        return {"named": bool(found.effects or found.laws)}
    if what == "chance":
        return {"p": p_value(sort, k)}
    if what == "bands":
        return _bands(sort, k)
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
    return _power(k, *sort.split("/"))


def _null(sort: str, k: int) -> Entry:
    found = diagnose(ROBOT, null(sort, k)).answer()
    assert found.search is not None
    assert found.noise.model is not None
    out: Entry = {
        "named": bool(found.effects or found.laws),
        "unexplained": found.verdict == "unexplained",
        "hinted": bool(found.hints),
        "p": found.search.p_value,
        "sigma": found.sigma_mm,
        "rows": found.noise.model.rows,
        "source": str(found.noise.source.value),
    }
    if sort in likelihood.SORTS:
        out["likeliest"] = list(likelihood.likeliest(sort, k))
    return out


def _bands(model: str, k: int) -> Entry:
    errors = plausible(DELTA, 1000 + k)
    result = identify(ROBOT, record(ROBOT, n=60, seed=k, errors=errors), model).answer()
    true = record(ROBOT, n=NEW, seed=5000 + k, errors=errors, sigma=0.0)
    ends = predicted_bands(result, true, predict(result, true))
    pairs = zip(true.measured.T, map(named, true.columns), strict=True)
    inside = [(ends[low] <= v) & (v <= ends[high]) for v, (low, high) in pairs]
    return {"inside": int(np.sum(inside)), "of": int(np.size(inside))}


def _power(k: int, name: str, asked: str, false: str) -> Entry:
    answer = diagnose(ROBOT, powered(name, asked, k, float(false))).answer()
    right = any(e.name == name for e in answer.effects)
    among = right or any(name in e.indistinguishable_from for e in answer.effects)
    told = among or any(name in (h.name, *h.indistinguishable_from) for h in answer.hints)
    alone = apart(name, asked, k, float(false))
    return {
        "named": right,
        "named or among what is not told apart": among,
        "told": told,
        "another effect within 10 of chi2 by rights": alone < ALIKE,
        "preferred": preferred(alone),
    }


def jobs(counts: Mapping[str, int], only: str = "", false: float = FALSE) -> list[Job]:
    """Return all jobs, so many of each sort of a kind, of each sort the same part first.

    `only` those whose kind and sort hold some words; `false` is the rate of false names of the ideal detector.
    """
    sorts = [("null", s) for s in SORTS] + [("bands", m) for m in MODELS] + [("five", "effects at once")]
    sorts += [("false", "white")] + [("chance", look) for look in LOOKS]
    sorts += [("coverage", c) for c in COVERED] + [("round", name) for name in AMBIGUOUS]
    sorts += [("power", f"{name}/{asked}/{false:g}") for name in EFFECTS for asked in ASKED]
    wanted = [s for s in sorts if any(words in " ".join(s) for words in only.split(","))]
    every = [(what, sort, k) for what, sort in wanted for k in range(counts[what])]
    return sorted(every, key=lambda job: (job[2] + 0.5) / counts[job[0]])


def rate_of_names(done: Mapping[Any, Entry]) -> tuple[int, int]:
    """Return how many of so many white nulls something was named in."""
    said = [e["named"] for job, e in done.items() if job[:2] in (("false", "white"), ("null", "white"))]
    return sum(said), len(said)


def allowed(done: Mapping[Any, Entry]) -> tuple[float, str]:
    """Return the rate of false names that the ideal detector allows itself, and in words where it comes from."""
    hits, count = rate_of_names(done)
    if count < ENOUGH:
        return FALSE, f"assumed: {count} white nulls are kept, {ENOUGH} are needed (--only false)"
    return max(hits / count, FALSE), f"measured: a name in {hits} of {count} white nulls, and not less than {FALSE:g}"


# --------------------------------------------------------------------------------------------------------------- tables


def distance(p: Iterable[float]) -> float:
    """Return Kolmogorov's distance of numbers from uniform ones."""
    from scipy.stats import kstest

    return float(kstest(list(p), "uniform").statistic)


class Figures:
    """The table of all figures."""

    def __init__(self) -> None:
        self.shown = Table("figure", "of", "part", "95 %")

    def part(self, words: str, hits: int, count: int) -> None:
        """Add a part of a whole, with its interval."""
        if count:
            low, high = wilson(hits, count)
            self.shown.add_row(words, str(count), f"{hits / count:.3f}", f"{low:.3f} to {high:.3f}")

    def number(self, words: str, count: int, value: str, note: str = "") -> None:
        """Add another number."""
        self.shown.add_row(words, str(count), value, note)

    def noise(self, sort: str, own: list[Entry]) -> None:
        """Add how well noise is known, beside who knows its model; a size that was declared is none that was found."""
        low, middle, high = np.quantile([e["sigma"] / SIGMA for e in own], [0.1, 0.5, 0.9])
        self.number(f"noise {sort}: its size", len(own), f"{middle:.3f}", f"80 %: {low:.2f} to {high:.2f}")
        low, middle, high = np.quantile([e["rows"] for e in own], [0.1, 0.5, 0.9])
        self.number(f"noise {sort}: rows that count as one", len(own), f"{middle:.1f}", f"{low:.1f} to {high:.1f}")
        told = [e for e in own if "likeliest" in e]
        found = [e for e in told if e["source"] != Source.DECLARED or sort in WRONGLY]
        self._beside(f"noise {sort}: its size", [(e["sigma"] / SIGMA, e["likeliest"][0] / SIGMA) for e in found])
        if sort in likelihood.TRUE:
            true = likelihood.rows_of(likelihood.TRUE[sort])
            pairs = [(e["rows"] / true, e["likeliest"][1] / true) for e in told]
            self._beside(f"noise {sort}: rows that count as one", pairs)

    def designs(self, words: str, own: list[Entry]) -> None:
        """Add how many readings are proposed, by those of who knows the truth, and by random ones."""
        asked = [e for e in own if "rows" in e and "chi2" in e]
        if not asked:
            return
        rows, best = (np.array([float(e[key]) for e in asked]) for key in ("rows", "best"))
        for key, whose in (("best", "the best design's"), ("random", "random ones")):
            other = np.array([float(e[key]) for e in asked])
            note = f"{rows.mean():.1f} to {other.mean():.1f}"
            ratio = f"{rows.sum() / other.sum():.2f}"
            self.number(f"{words}: readings proposed, to {whose}", len(asked), ratio, note)
        self.part(f"{words}: at most {WORSE} times the best design's", int((rows <= WORSE * best).sum()), len(asked))
        chi2, every = (np.median([e[key] for e in asked]) for key in ("chi2", "rows in all"))
        note = f"{every:.0f} with those for other questions"
        self.number(f"{words}: chi2 that parts the truth after them, median", len(asked), f"{chi2:.0f}", note)

    def _beside(self, words: str, pairs: list[tuple[float, float]]) -> None:
        if not pairs:
            return
        ours, best = np.log(np.array(pairs)).T
        ratio = np.sqrt(np.mean(ours**2) / np.mean(best**2))
        errors = f"{np.sqrt(np.mean(ours**2)):.3f} to {np.sqrt(np.mean(best**2)):.3f}"
        self.number(f"{words}, error to the likeliest's", len(pairs), f"{ratio:.2f}", errors)
        for who, off in (("", ours), (", the likeliest", best)):
            self.part(f"{words} within {NEAR:.0%}{who}", int((np.abs(np.expm1(off)) < NEAR).sum()), len(off))


def table(done: Mapping[Job, Entry]) -> Table:
    """Return all figures, parts of a whole with their intervals."""
    out = Figures()
    nulls = [e["named"] for job, e in done.items() if job[0] == "null"]
    out.part("noise of all sorts: named", sum(nulls), len(nulls))
    for effects in (True, False):
        held = [e for job, e in done.items() if job[0] == "coverage" and job[1].startswith("effect/") is effects]
        words = "effects" if effects else "geometry and maps"
        out.part(f"intervals of all {words}", sum(e["inside"] for e in held), sum(e["of"] for e in held))
    rounds = [e for job, e in done.items() if job[0] == "round"]
    for key in ("truth in the set", "alone after a round, of those that can be resolved", "wrong after a round"):
        said = [e[key] for e in rounds if key in e and e["open"]]
        out.part(f"rounds of all open sorts: {key}", sum(said), len(said))
    out.designs("rounds of all open sorts", rounds)
    for what, sort in sorted(dict.fromkeys(job[:2] for job in done), key=lambda key: list(COUNTS).index(key[0])):
        own = [e for job, e in done.items() if job[:2] == (what, sort)]
        if what in ("bands", "coverage"):
            words = f"delta/{sort}: true readings within their bands" if what == "bands" else f"intervals of {sort}"
            out.part(words, sum(e["inside"] for e in own), sum(e["of"] for e in own))
            continue
        where = f"noise {sort}" if what == "null" else f"{what} {sort}"
        for key in dict.fromkeys(key for e in own for key, value in e.items() if isinstance(value, bool)):
            said = [e[key] for e in own if key in e]
            out.part(f"{where}: {key}", sum(said), len(said))
        if what == "power":
            best = float(np.mean([e["preferred"] for e in own]))
            out.number(f"{where}: who knows it and its rival prefers it", len(own), f"{best:.3f}")
        if what == "round":
            out.designs(where, own)
        if what in ("null", "chance"):
            p = [e["p"] for e in own]
            out.number(f"{where}: p-values, distance from uniform", len(own), f"{distance(p):.3f}")
            for bound in BOUNDS:
                out.part(f"{where}: p-values below {bound}", sum(value < bound for value in p), len(p))
        if what == "null":
            out.noise(sort, own)
    return out.shown


def spent(seconds: Mapping[Job, float], counts: Mapping[str, int]) -> str:
    """Return what the jobs of each kind take, and what all sorts that were looked at would take in full."""
    whole, parts = 0.0, []
    for what in dict.fromkeys(job[0] for job in seconds):
        own = [s for job, s in seconds.items() if job[0] == what]
        sorts = len({job[1] for job in seconds if job[0] == what})
        whole += float(np.mean(own)) * sorts * counts[what]
        parts.append(f"{what} {np.mean(own):.1f} s")
    return f"CPU of a job: {', '.join(parts)}; of all that was asked {whole / 3600:.1f} h"


def main(arguments: list[str] | None = None) -> int:
    """Do the jobs that are not done yet, and print what they come to."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.honesty", description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, help="recordings of each sort, in place of what the whole takes of it")
    parser.add_argument("--quick", action="store_true", help="a few of each sort, within 20 minutes")
    parser.add_argument("--only", default="", help="sorts that hold one of these words, parted by commas")
    add_options(parser)
    given = parser.parse_args(arguments)
    counts = {what: given.count or both[given.quick] for what, both in COUNTS.items()}
    begin, found, done = time.monotonic(), Sitting(), kept(given.kept)[0]
    first = [job for job in jobs(counts, given.only) if job[0] == "false"]
    if len(first) >= ENOUGH:  # the rate is known before it is used
        found = sit(examined, first, given)
        done |= found.done
        given.minutes -= (time.monotonic() - begin) / 60
    false, why = allowed(done)
    asked = jobs(counts, given.only, false)
    if not found.interrupted:
        failed, found = found.failed, sit(examined, asked, given)
        found.failed |= failed
        done |= found.done
    Console(width=None if sys.stdout.isatty() else 140).print(table({job: done[job] for job in asked if job in done}))
    if any(job[0] == "power" for job in asked):
        print(f"the ideal detector's rate of false names is {false:g}, {why}")
    if found.seconds:
        print(spent(found.seconds, counts))
    return found.code


if __name__ == "__main__":
    sys.exit(main())
