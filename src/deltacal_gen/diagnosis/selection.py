"""Which effects are on the machine: the set of findings that one objective prefers, reached by moves.

A hypothesis is a set of findings and a noise model. Its cost is -2 log of its posterior probability, but for a constant
that all hypotheses share: the deviance of the readings, geometry and instrument taken out (`together.deviance_of`), and
the price of each finding. A move adds a finding, drops one, or exchanges one or two for others. The linear machine
proposes (a score test beside all that is fitted), an exact refit in the noise that suits it decides. The cheapest
hypothesis is looked at first; others that are nearly as cheap follow, for a set that no single step improves may still
be the wrong one: of two events either may be taken for the other's kind.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.diagnosis.charges import AS_GOOD, MARGIN
from deltacal_gen.diagnosis.refits import believable, form, place, refitted, terms_of
from deltacal_gen.diagnosis.search import Found, Search
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import Repeats
from deltacal_gen.identification.orders import wave
from deltacal_gen.identification.together import suited
from deltacal_gen.physics.terms import Term

MOST_EFFECTS = 8  # findings that are searched: more were never told apart
MOST_WAVES = 3  # periodic errors among them: what shows at more is one error of many orders
MOST_REFITTED = 20  # hypotheses, after which those at hand decide
PROPOSED = 4  # moves of a hypothesis that are refitted: those that promise most
RIVALS = 3  # effects that are thought of in the place of one or two
NEAR = 20.0  # of the cost: what costs so much more in the linear machine may cost less in the exact one
EXCHANGED = 3  # findings up to which two at a time are exchanged
Progress = Callable[[str], None]


class Move(NamedTuple):
    """A step to another set of findings: what it is called, all effects after it, and what it should cost."""

    name: str
    terms: Sequence[Term]
    cost: float

    @property
    def exchanges(self) -> bool:
        """Whether something comes in the place of something else."""
        return ">" in self.name


@dataclass(frozen=True)
class Hypothesis:
    """A set of findings, fitted exactly.

    Attributes
    ----------
    white, fit : Fit
        In noise of each row's own, and in the noise that suits what that leaves.
    cost : float
        -2 log of its posterior probability, but for a constant.
    moves : tuple of str
        That led to it.
    """

    white: Fit
    fit: Fit
    cost: float
    moves: tuple[str, ...] = ()

    @property
    def forms(self) -> frozenset[tuple[object, ...]]:
        """Which effects are where, with which constants."""
        return _forms(terms_of(self.fit))


@dataclass(frozen=True)
class Selection:
    """What was selected, hypotheses from the cheapest on, and the best form of each effect at the first look."""

    search: Search
    hypotheses: tuple[Hypothesis, ...]
    considered: list[Found]


def select(problem: Problem, start: Search, progress: Progress) -> Selection:
    """Return the cheapest hypothesis that moves lead to, from a fit with or without findings.

    Parameters
    ----------
    start : Search
        Its forms are those that are sought.
    """
    terms, done, considered = start.terms, list[Hypothesis](), list[Found]()
    fresh = [_weighed(problem, start, start.fit, terms_of(start.fit))]
    seen = {fresh[0].forms}
    while fresh and len(seen) < MOST_REFITTED:
        now = min(fresh, key=_cost)
        least = min([now, *done], key=_cost).cost
        if now.cost > least + NEAR:
            break
        fresh.remove(now)
        done.append(now)
        progress(f"search {len(done)}: {len(terms)} forms of {len({t.effect for t in terms})} effects")
        # correlated noise hides what goes with time
        searches = [Search(at, terms) for at in ([now.fit] if now.fit is now.white else [now.white, now.fit])]
        considered = considered or searches[0].ranked()
        moves = [m for s in searches for m in _moves(s, now.cost) if not crowded(s, m.terms)]
        moves.sort(key=lambda m: m.cost)
        for move in _promising(moves, now.cost, least, seen):
            new = _weighed(problem, start, now.white, move.terms, (*now.moves, move.name))
            if new.forms == _forms(move.terms) or new.forms not in seen:
                seen.add(new.forms)
                fresh.append(new)
    every = sorted([*done, *fresh], key=_cost)
    return Selection(Search(every[0].fit, terms), tuple(every), considered)


def _promising(
    moves: Sequence[Move], cost: float, least: float, seen: set[frozenset[tuple[object, ...]]]
) -> Iterator[Move]:
    """Yield the moves that are worth a refit, each once: those that promise most, and none that was made before."""
    tried = 0
    for move in moves:
        if tried == PROPOSED or move.cost > least + NEAR:
            return
        if (move.exchanges or move.cost < cost) and (there := _forms(move.terms)) not in seen:
            seen.add(there)
            tried += 1
            yield move


def _weighed(
    problem: Problem, start: Search, near: Fit, terms: Sequence[Term], moves: tuple[str, ...] = ()
) -> Hypothesis:
    """Return a set of findings, fitted from near to it; it costs infinitely much where there is no fit."""
    white = _in_noise(problem, near, near.repeats.as_plain(), terms)
    if white is None:
        return Hypothesis(near, near, np.inf, moves)
    white = believable(problem, white)
    own, (noise, deviance) = terms_of(white), suited(white)
    price = start.priced(own)
    calm = None if noise.plain else _in_noise(problem, white, noise, own)
    fit, deviance = (white, deviance) if calm is None else (calm, suited(calm)[1])
    return Hypothesis(white, fit, deviance + price, moves)


def _in_noise(problem: Problem, at: Fit, noise: Repeats, terms: Sequence[Term]) -> Fit | None:
    """Return the fit of effects in other noise, starting from a fit."""
    same = noise.plain and at.repeats.plain and _forms(terms) == _forms(terms_of(at))
    return at if same else refitted(problem, dataclasses.replace(at, repeats=noise), terms)


def _forms(terms: Sequence[Term]) -> frozenset[tuple[object, ...]]:
    return frozenset(map(form, terms))


def _cost(of: Hypothesis) -> float:
    return of.cost


def _moves(search: Search, cost: float) -> Iterator[Move]:
    """Yield the moves from a fit, with what the linear machine expects them to cost."""
    terms = terms_of(search.fit)
    each = search.grouped(terms)
    own = [[terms[i] for i in places] for places in each]
    if len(each) < MOST_EFFECTS:
        for f in search.ranked()[:RIVALS]:
            yield Move(f"+ {f.term.effect}", [*terms, *f.terms], cost + MARGIN - f.score)
    for places, mine in zip(each, own, strict=True):
        rest = [t for i, t in enumerate(terms) if i not in places]
        freed, name = search.freed(*places), mine[0].effect
        worth = _worth(freed, [mine])
        yield Move(f"- {name}", rest, cost + worth)
        if len(mine) > 1:  # so many waves imitate what is not found yet
            alone = max(mine, key=lambda t: freed.gain(freed.where(t)))
            yield from _exchanges(freed, [[alone]], rest, f"{name} of one order", cost + worth)
        for f in freed.ranked()[:RIVALS]:
            other = Move(f"{name} > {f.term.effect}", [*rest, *f.terms], cost + worth + MARGIN - f.score)
            if {*map(place, f.terms)} != {*map(place, mine)} or other.cost < cost - AS_GOOD:  # a size by itself
                yield other
    if len(each) > EXCHANGED:
        return
    for (p, mine), (q, others) in itertools.combinations(zip(each, own, strict=True), 2):
        rest = [t for i, t in enumerate(terms) if i not in (*p, *q)]
        freed, name = search.freed(*p, *q), f"{mine[0].effect}, {others[0].effect}"
        worth, ranked = _worth(freed, [mine, others]), freed.ranked()[:RIVALS]
        for f in ranked:
            yield Move(f"{name} > {f.term.effect}", [*rest, *f.terms], cost + worth + MARGIN - f.score)
            yield from _exchanges(freed, [f.terms], rest, name, cost + worth)


def _exchanges(
    freed: Search, first: Sequence[Sequence[Term]], rest: Sequence[Term], name: str, cost: float
) -> Iterator[Move]:
    """Yield what some findings and the one that explains most beside them cost in the place of what is freed.

    The first is taken in the form that is best beside the second.
    """
    ranked = freed.added(*itertools.chain(*first)).ranked()
    if not ranked:
        return
    second = ranked[0].terms
    again = freed.added(*second).best(first[0][0].effect).terms
    for one in {frozenset(map(place, own)): own for own in (first[0], again)}.values():
        terms = [*rest, *one, *second]
        yield Move(f"{name} > {one[0].effect}, {second[0].effect}", terms, cost - _worth(freed, [one, second]))


def _worth(search: Search, findings: Sequence[Sequence[Term]]) -> float:
    """Return by how much findings lower the cost together, in the linear machine."""
    gain = search.gain(search.columns_of(*itertools.chain(*findings)))
    return gain - sum(search.price(*own) + MARGIN for own in findings)


def crowded(search: Search, terms: Sequence[Term], most: int = MOST_WAVES) -> bool:
    """Tell whether there are too many periodic errors to be told apart: all orders are then one error."""
    return len(search.grouped([t for t in terms if t.effect == wave()])) > most
