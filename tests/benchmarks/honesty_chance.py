"""How surely noise alone explains as much as the best of all forms did: the p-value of a search at its first look.

What a diagnosis does before it names anything: geometry, the noise as it hangs together, the competition, the draws. A
recording costs a fraction of a second, so that hundreds of p-values can be held against uniform ones.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.diagnosis import SEED, _first, _geometry
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.files.checks import set_aside
from deltacal_gen.identification.together import together
from deltacal_gen.machine.values import Recording
from tests.benchmarks.honesty_nulls import LENGTHS, ROBOT, null

SEEDS = ("first", "second", "third")
SORTS = tuple(f"{noise}/{seed}" for noise in ("white", "tails", "rows") for seed in SEEDS)
NOISE = {  # in turn, each in recordings of all lengths
    "white": ("white", "uniform", "skewed"),
    "tails": ("laplace", "t3", "gross", "rounded", "understated", "overstated"),
    "rows": ("AR 0.5", "AR 0.9", "AR 0.95", "AR mixed"),
}
APART = 10_000  # recordings from one of `SORTS` to the next: no two share poses and noise


def p_value(sort: str, k: int) -> float:
    """Return the p-value of the k-th recording of a seed, its noise of several sorts in turn."""
    several = NOISE[sort.partition("/")[0]]
    return first_look(null(several[k // len(LENGTHS) % len(several)], APART * (1 + SORTS.index(sort)) + k)).p_value


def first_look(recording: Recording) -> Chance:
    """Return what noise alone lets the best of all forms score beside geometry and instrument."""
    first = geometry_of(recording)
    if (calm := together(first)) is not None:
        first = refitted(first.problem, dataclasses.replace(first, repeats=calm), []) or first
    return Chance(Search(first, library(first.problem)[0]), np.random.default_rng(SEED))


def geometry_of(recording: Recording) -> Fit:
    """Return the fit of geometry and instrument with which a diagnosis begins."""
    recording = set_aside(recording, ROBOT)
    return _first(_geometry(ROBOT, recording, None)[0])
