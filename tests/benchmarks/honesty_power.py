"""Recordings with effects as large as an ideal detector needs them: what it would see half the time, or nearly always.

The ideal detector knows how large the white noise is, the columns of geometry and instrument, and the effect's own on
its own limb; it tests one likelihood ratio, at the rate of false names divided by the forms that the tool tries.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np

from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term
from tests.benchmarks.honesty_chance import geometry_of
from tests.benchmarks.honesty_nulls import ROBOT, SIGMA
from tests.support.left_out import DELTA, channels, effect, record
from tests.support.prototype import plausible

POSES, LIMB = 100, (2,)
SHOWN = 60.0  # of chi2: about what an effect of the sizes below explains
FALSE = 1e-3  # rate of false names that the ideal detector allows itself, at least: where the tool's own is not known
# parts of recordings that the ideal detector names, and times its size at which the tool should
ASKED = {"half": (0.5, 1.2), "nearly all": (0.95, 1.25)}
EFFECTS: dict[str, tuple[float, ...]] = {
    "backlash": (1.0,),
    "joint_compliance": (1.0,),
    "transmission_eccentricity": (0.6, 0.8),
    "thermal_zero": (1.0,),
    "zero_jump": (1.0,),
    "distal_compliance": (1.0,),
}
FIVE = {  # effects, and coefficients that gears, joints and rods may well have
    "backlash": (0.02,),
    "joint_compliance": (0.01,),
    "transmission_eccentricity": (0.003, 0.004),
    "thermal_zero": (0.004,),
    "proximal_bending": (0.02,),
}
SPOILT = 3  # gross errors beside five effects


def powered(name: str, asked: str, k: int, false: float = FALSE) -> Recording:
    """Return the k-th recording with an effect at so many times the size at which the ideal detector names it.

    `false` is the rate of false names that the detector allows itself.
    """
    part, times = ASKED[asked]
    seen = _seen(name, k)
    size = times * np.sqrt(_needed(part, seen.forms, seen.degrees, false) / seen.square)
    return _made(name, [_term(name, k, size)], k)


def apart(name: str, asked: str, k: int, false: float = FALSE) -> float:
    """Return by how much chi2 the truth outdoes on average what explains as much of the k-th recording but for it."""
    part, times = ASKED[asked]
    seen = _seen(name, k)
    return times**2 * _needed(part, seen.forms, seen.degrees, false) * seen.own


def preferred(chi2: float) -> float:
    """Return how often the truth is preferred to a rival from which `chi2` parts it: the floor of a single name.

    So does who knows noise, geometry and both effects; of more rivals that are as near it is less.
    """
    from scipy.special import ndtr

    return float(ndtr(np.sqrt(max(chi2, 0.0)) / 2))


def five(k: int) -> tuple[Recording, list[Term]]:
    """Return the k-th recording with five effects, each on a limb of its own, and gross errors; and the effects."""
    rng = np.random.default_rng([k, 5])
    terms = [_term(n, k, rng.uniform(1, 2), FIVE[n], (int(rng.integers(1, 4)),)) for n in FIVE]
    made = _made("backlash", terms, k)
    made.measured[rng.choice(POSES, SPOILT, replace=False)] += rng.normal(0, 1.0, (SPOILT, 3))  # mm
    return made, terms


def _made(name: str, terms: Sequence[Term], k: int) -> Recording:
    errors = plausible(DELTA, 1000 + k, size=0.3)
    return record(ROBOT, *terms, n=POSES, seed=6000 + k, of=_channels(k), errors=errors, declared=False)


def _channels(k: int) -> dict[str, np.ndarray]:
    return channels(POSES, "approach", "temp", "time", "payload", seed=k)


def _term(name: str, k: int, size: float, values: Sequence[float] = (), limbs: tuple[int, ...] = LIMB) -> Term:
    constants: tuple[float, ...] = ()
    if name == "zero_jump":
        constants = (float(_channels(k)["time_s"][30 + k % 40]),)
    if name == "transmission_eccentricity":
        constants = (2 + k % 19,)
    return effect(name, limbs, *(size * v for v in values or EFFECTS[name]), constants=constants)


class _Seen(NamedTuple):
    """What an ideal detector knows: the square of what an effect of size 1 moves readings by, in noise.

    Beside geometry and instrument; the forms that the tool tries, each on each limb; the effect's coefficients; the
    part of the square that no other effect explains.
    """

    square: float
    forms: int
    degrees: int
    own: float


@cache
def _seen(name: str, k: int) -> _Seen:
    one = _term(name, k, 1.0)
    at = geometry_of(_made(name, [], k))
    terms = library(at.problem)[0]
    search = Search(at, [at.problem.body.blank(name, (1, 2, 3), one.constants)])
    columns = search.beside.rows(at.problem.term_columns([one], at.errors, at.instrument, search.beside.machine))
    moved = columns @ one.values.ravel()
    moved -= search.beside.Q @ (search.beside.Q.T @ moved)
    square = float(moved @ moved)
    others, beside = Search(at, _others(terms, name)), copy.copy(search.beside)
    beside.residual = moved * np.sqrt(SHOWN / square)
    others._place(beside)
    best = max(found.gain for found in others.ranked())
    forms = sum(max(len(t.limbs), 1) for t in terms)
    return _Seen(square * (at.sigma[0] / SIGMA) ** 2, forms, len(search.where(one)), 1 - best / SHOWN)


def _others(terms: Sequence[Term], name: str) -> list[Term]:
    """Return the forms of other effects; what becomes the effect in a limit explains all that it does."""
    return [t for t in terms if t.effect != name and name != t.kernels.EXTENDS]


def _needed(part: float, forms: int, degrees: int, false: float = FALSE) -> float:
    """Return the square at which a likelihood ratio of so many degrees, one of so many tests, is found so often."""
    from scipy.optimize import brentq
    from scipy.stats import chi2, ncx2

    bound = chi2.isf(false / forms, degrees)
    return float(brentq(lambda size: ncx2.sf(bound, degrees, size) - part, 1e-3, 1e3))
