"""A law, term by term: the forms that seem to explain most are fitted exactly with everything else, the cheapest stays.

What one fit leaves is far above the noise while a law is missing, and all that resembles the law looks alike in it. The
forms are therefore ranked twice: by what is left, then by the noise that the best of them leaves. The shape of each of
the best is sought before they are compared. What a hypothesis costs is its deviance and the price of all that it says.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from deltacal_gen.diagnosis.charges import MARGIN
from deltacal_gen.diagnosis.laws.ground import Ground, Tried
from deltacal_gen.diagnosis.laws.profile import refine
from deltacal_gen.diagnosis.laws.screen import ranked
from deltacal_gen.diagnosis.laws.shape import shaped
from deltacal_gen.diagnosis.refits import COMPARED, form, refitted, terms_of
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.identification.together import deviance_of
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import Term

MOST_TERMS = 3
AT_FIRST = 3  # forms that are looked at closer before the noise is known
TRIED = 3  # forms of which the exact fit is asked for
LOOKS = 4  # at the shape of a term


@dataclass(frozen=True, eq=False)
class FormulaFit:
    """A fit of geometry, instrument and named effects with a law, whose terms come last in it.

    Attributes
    ----------
    prices : mapping
        What each named effect has to earn, by its form.
    """

    fit: Fit
    law: tuple[Tried, ...] = ()
    prices: Mapping[tuple[object, ...], float] = field(default_factory=dict)

    @property
    def terms(self) -> list[Term]:
        """The terms of the law as they are fitted."""
        return [t for t in terms_of(self.fit) if is_law(t.effect)]

    @property
    def names(self) -> list[Term]:
        """The effects beside the law."""
        return [t for t in terms_of(self.fit) if not is_law(t.effect)]

    @property
    def charges(self) -> list[float]:
        """What each term of the fit has to earn."""
        return [*(self.prices.get(form(t), 0.0) for t in self.names), *(t.price + MARGIN for t in self.law)]

    @cached_property
    def cost(self) -> float:
        """Deviance, and the price of every term."""
        return deviance_of(self.fit) + sum(self.charges)

    def place(self, i: int) -> int:
        """Return where in the fit a term of the law is."""
        return len(terms_of(self.fit)) - len(self.law) + i % len(self.law)

    def freed(self, i: int) -> Ground:
        """Return what is left of the readings without a term of the law."""
        return Ground(self.fit).freed(self.place(i))


def grow(problem: Problem, base: Fit, most: float = np.inf) -> FormulaFit | None:
    """Return the law that explains most beside a fit, None where none earns its price.

    From its first term on a law has to cost less than `most`.
    """
    best = FormulaFit(base)
    while len(best.law) < MOST_TERMS and (longer := _longer(problem, best)) is not None:
        best = longer
        if best.cost >= most:
            return None
    return best if best.law else None


def _longer(problem: Problem, now: FormulaFit) -> FormulaFit | None:
    """Return the law with the term more that costs least; None where none earns its price."""
    ground = Ground(now.fit)
    # on a jump by what the machine itself changes it may not come to rest: elsewhere it does
    rough = next(iter(_fitted(problem, now, ground, ranked(ground, AT_FIRST))), None)
    if rough is None:
        return None
    sharper = ground.sharper(rough.fit)
    found = _fitted(problem, now, sharper, ranked(sharper)) or [rough]
    best = min((shaped_all(problem, polished(problem, h, -1)) for h in found), key=lambda h: h.cost)
    return best if best.cost < now.cost else None


def _fitted(problem: Problem, now: FormulaFit, ground: Ground, forms: Sequence[Tried]) -> list[FormulaFit]:
    """Return the law with each of the best forms more."""
    tried = (fitted(problem, now, ground, t) for t in forms[:TRIED] if t.score > MARGIN)
    return [h for h in tried if h is not None]


def fitted(problem: Problem, now: FormulaFit, ground: Ground, tried: Tried, at: int | None = None) -> FormulaFit | None:
    """Return the exact fit of a law with one more form, or with it in place of the term `at`."""
    law, terms = list(now.law), terms_of(now.fit)
    term = ground.term(tried.target, tried.form, tried.limbs)
    if at is None:
        law, terms = [*law, tried], [*terms, term]
    else:
        law[at], terms[now.place(at)] = tried, term
    found = refitted(problem, now.fit, terms, tolerance=COMPARED)
    return None if found is None else dataclasses.replace(now, fit=found, law=tuple(law))


def polished(problem: Problem, now: FormulaFit, i: int) -> FormulaFit:
    """Return a law with the constants within a term where they explain most in the exact fit."""
    own, ground = now.law[i], now.freed(i)
    place = ground.place(own.target)
    found = dataclasses.replace(own, gain=ground.gain(place, own.form, own.limbs))
    return _cheaper(now, fitted(problem, now, ground, refine(ground, place, found), i))


def shaped_all(problem: Problem, now: FormulaFit) -> FormulaFit:
    """Return a law whose terms each have the shape that they earn beside everything else that is fitted.

    What counts as a gross error, and the noise, follow the shape: each is looked at again by what it leaves.
    """
    for i in range(len(now.law)):
        for _ in range(LOOKS):
            ground, before = now.freed(i), now.law[i]
            now = _cheaper(now, fitted(problem, now, ground, shaped(ground, placed(ground, before)), i))
            if (now.law[i].form.functions, now.law[i].target) == (before.form.functions, before.target):
                break
    return now


def _cheaper(now: FormulaFit, other: FormulaFit | None) -> FormulaFit:
    """Return another hypothesis unless it costs more."""
    return now if other is None or other.cost > now.cost + COMPARED else other


def placed(ground: Ground, tried: Tried) -> Tried:
    """Return a term of a law at the place where its form explains most, on the limbs that carry it.

    Places were compared by few simple forms; a curve tells them apart that is nearly right.
    """
    own = ground.place(tried.target)
    read = set(tried.form.states)
    others = [p for p in ground.places if p.limbs == own.limbs and read <= set(ground.readable(p))]
    at = [
        dataclasses.replace(tried, target=p.target, gain=ground.gain(p, tried.form, tried.limbs))
        for p in (own, *(p for p in others if p.remembers or not tried.form.lags))
    ]
    best = max(at, key=lambda t: t.gain)
    return best if best.gain > at[0].gain + COMPARED else tried
