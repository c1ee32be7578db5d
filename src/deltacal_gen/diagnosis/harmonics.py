"""Periodic errors that are no sine: the waves of one period, a fundamental and its harmonics, which are one finding.

What repeats k times a turn is a sum of waves of the orders k, 2 k, 3 k, ... (Fourier), of the odd ones alone where its
second half is the first one turned over: a square wave, a tooth that catches. Taken one by one each harmonic would have
to earn the price of an order chosen among a hundred, and those that follow an order in size would lie below it. They
are charged together instead, as coefficients of one form that is chosen among all fundamentals and lengths. That an
error repeats is claimed only where it was seen to: over more than one period.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np

from deltacal_gen.diagnosis.charges import several
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term

LONGEST = 10  # waves of one period: what finer ones carry is a few per cent of any shape that a machine has
LATTICES = (1, 2)  # every multiple of the fundamental, or every second one
SEEN_TWICE = 1.25  # periods over which joints moved: a quarter of one was then seen twice
FEW = 0.1  # of the scalars, at most as many coefficients: more explain by their number, whatever the shape
DIGITS = 6  # to which multiples of orders are alike: they differ by rounding


def order_of(term: Term) -> float:
    """Return the order of a wave."""
    return float(term.constants[0])


class Series(NamedTuple):
    """Fundamentals with some of their harmonics.

    Attributes
    ----------
    places : tuple of tuple of int
        Of each, which of the orders it has, the fundamental first.
    holds : (S, orders) bool array
        The same.
    """

    places: tuple[tuple[int, ...], ...]
    holds: np.ndarray


@cache
def series(orders: tuple[float, ...], least: float) -> Series:
    """Return all that is searched.

    Parameters
    ----------
    orders : tuple of float
        That may be taken.
    least : float
        The lowest of them that is a fundamental.
    """
    place = {round(order, DIGITS): i for i, order in enumerate(orders)}
    out: list[tuple[int, ...]] = []
    for fundamental in orders:
        for step in LATTICES if fundamental >= least else ():
            own = [place.get(round((1 + step * m) * fundamental, DIGITS)) for m in range(LONGEST)]
            known = [i for i in own if i is not None]
            out += [tuple(known[:n]) for n in range(2, len(known) + 1)]
    unlike = tuple(dict.fromkeys(out))
    holds = np.zeros((len(unlike), len(orders)), dtype=bool)
    for s, taken in enumerate(unlike):
        holds[s, list(taken)] = True
    return Series(unlike, holds)


def travelled(problem: Problem) -> Sequence[float]:
    """Return how far each joint turned [rad]."""
    travel: list[float] = np.ptp(turns(problem)[np.unique(problem.readings.rows)], axis=0).tolist()
    return travel


def turns(problem: Problem) -> Array:
    """Return the turn of each joint (N, limbs) at each row [rad]."""
    body = problem.body
    nowhere = np.zeros((len(body.q), 12))  # turns do not depend on the pose
    turn: Array = body.state(["turn"], nowhere, body.q, body.mechanism.rows(problem.robot))["turn"]
    return turn


def unrepeated(problem: Problem, wave: Term) -> dict[int, tuple[float, float]]:
    """Return between which turns [rad] the joints of a wave were read that was not seen to repeat; of others nothing.

    Beyond them it may be anything: any function of a joint that is smooth there is some wave.
    """
    turn = turns(problem)[np.unique(problem.readings.rows)]
    read = {i: (float(turn[:, i - 1].min()), float(turn[:, i - 1].max())) for i in wave.limbs}
    least = min(high - low for low, high in read.values())
    return {} if order_of(wave) >= lowest_repeating(least) else read


def lowest_repeating(travel: float) -> float:
    """Return the lowest order that is seen to repeat by a joint that turns so far [rad]."""
    return SEEN_TWICE * 2 * math.pi / max(travel, 1e-9)


def once(travel: float) -> float:
    """Return the highest whole order that does not repeat where a joint turns so far [rad]; 0 where all do."""
    return float(math.floor(2 * math.pi / max(travel, 1e-9)))


def is_multiple(order: float, of: float) -> bool:
    """Tell whether an order is another one, or a harmonic of it."""
    ratio = round(order / of, DIGITS) if of else 0.5
    return ratio.is_integer() and ratio >= 1


def _following(
    waves: Mapping[tuple[tuple[int, ...], float], int], limbs: tuple[int, ...], order: float, step: int, taken: set[int]
) -> Iterator[int]:
    """Yield the waves that follow one another on a lattice, up to the first that is missing."""
    for m in range(LONGEST):
        place = waves.get((limbs, round((1 + step * m) * order, DIGITS)))
        if place is None or place in taken:
            return
        yield place


def grouped(terms: Sequence[Term], repeats: Callable[[Term], bool]) -> list[tuple[int, ...]]:
    """Return which terms are one finding: waves of the same limbs that follow one another from a fundamental on.

    Every other term stands alone, also waves whose orders happen to be multiples of a much lower one's.
    """
    out: list[tuple[int, ...]] = []
    taken: set[int] = set()
    waves = {(t.limbs, round(order_of(t), DIGITS)): i for i, t in enumerate(terms) if several(t.effect)}
    for (limbs, order), i in sorted(waves.items(), key=lambda item: item[0][1]):
        if i in taken:
            continue
        own: tuple[int, ...] = (i,)
        for step in LATTICES if repeats(terms[i]) else ():
            own = max(own, tuple(_following(waves, limbs, order, step, taken)), key=len)
        taken |= set(own)
        out.append(own)
    return sorted([*out, *((i,) for i, t in enumerate(terms) if not several(t.effect))])
