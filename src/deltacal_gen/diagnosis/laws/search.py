"""A law, term by term: what earns most is fitted exactly with everything else, until noise is left or nothing earns.

What one fit leaves is far above the noise while a law is missing, and all that resembles the law looks alike in it. The
forms are therefore ranked twice: by what is left, then by the noise that the best of them leaves.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.charges import MARGIN
from deltacal_gen.diagnosis.laws.ground import Ground, Tried
from deltacal_gen.diagnosis.laws.profile import refine
from deltacal_gen.diagnosis.laws.screen import ranked
from deltacal_gen.diagnosis.laws.shape import reread, shaped
from deltacal_gen.diagnosis.refits import COMPARED, refitted, terms_of
from deltacal_gen.diagnosis.strategy import ALIKE
from deltacal_gen.diagnosis.structure import alike, structures
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.identification.noise import lack_of_fit
from deltacal_gen.identification.together import deviance_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import Term

MOST_TERMS = 3
AT_FIRST = 3  # forms that are looked at closer before the noise is known
SHARE = 0.75  # of what stands above the noise: what a law has to take
ON_THE_WAY = (0.3, 0.55)  # of the same: what one term, and two, have to take, or the search ends
TRIMMED = 0.03  # of readings: the largest errors, which may be gross
TRIED = 3  # forms of which the exact fit is asked for
LOOKS = 4  # at the shape of a term


@dataclass(frozen=True)
class Grown:
    """A fit with a law: its terms come last in the fit, in this order.

    Attributes
    ----------
    others : tuple of Tried
        Forms that could stand for the last term, the best first, that one among them.
    cost : float
        Deviance, and the price of every term.
    """

    fit: Fit
    law: tuple[Tried, ...]
    others: tuple[Tried, ...]
    cost: float

    @property
    def terms(self) -> list[Term]:
        """The terms of the law as they are fitted."""
        return [t for t in terms_of(self.fit) if is_law(t.effect)]

    @property
    def names(self) -> list[Term]:
        """The effects beside the law."""
        return [t for t in terms_of(self.fit) if not is_law(t.effect)]

    @property
    def states(self) -> frozenset[str]:
        """What the law reads."""
        return frozenset(s for t in self.law for s in t.form.states)

    @property
    def remembers(self) -> bool:
        """Whether it holds something that lags."""
        return any(t.kernels.MEMORY for t in self.terms)


def grow(problem: Problem, base: Fit, most: float = np.inf) -> Grown | None:
    """Return the law that explains most beside a fit, None where none earns its price.

    From its first term on a law has to cost less than `most`.
    """
    nothing = best = Grown(base, (), (), deviance_of(base))
    while len(best.law) < MOST_TERMS:
        longer = _longer(problem, best)
        if longer is None:
            break
        best = longer
        if len(best.law) == 2:  # by the noise that two terms leave, another single one may explain as much
            other = _sharpened(problem, nothing, best.fit)
            best = best if other is None or other.cost > best.cost else other
        if len(best.law) > 1:
            best = _revised(problem, best)
        best = reshaped(problem, curved(problem, best))
        taken = explained(base.residual / best.fit.sigma, best.fit.residual / best.fit.sigma)
        if taken < (*ON_THE_WAY, SHARE)[len(best.law) - 1] or best.cost >= most:
            return None
    return best if best.law else None


def explained(before: Array, after: Array) -> float:
    """Return which part of squares above the noise goes, errors (R, k) in standard deviations of the noise."""
    a, b = np.nansum(before**2, axis=1), np.nansum(after**2, axis=1)
    kept = quiet(before, after)
    scalars = np.isfinite(before[kept]).sum()
    excess = a[kept].sum() - scalars
    return float(1.0 - (b[kept].sum() - scalars) / excess) if excess > 0 else 0.0


def quiet(before: Array, after: Array) -> np.ndarray:
    """Return the readings (R,) of which there are errors, but for those of the largest errors."""
    b = np.nansum(after**2, axis=1)
    seen = np.flatnonzero(np.isfinite(before).any(axis=1))
    kept: np.ndarray = seen[np.argsort(b[seen])[: len(seen) - int(TRIMMED * len(seen))]]
    return kept


def unexplained(at: Fit) -> bool:
    """Tell whether a fit leaves more than noise: by its size, along a channel or a place, or alike in neighbours."""
    if lack_of_fit(at, at.problem.recording) or alike(at)[1] > ALIKE:
        return True
    return any(s.earned > MARGIN for s in structures(at))


def _longer(problem: Problem, now: Grown) -> Grown | None:
    """Return the law with one more term; None where none earns its price."""
    ground = Ground(now.fit)
    first = [t for t in ranked(ground, AT_FIRST)[:TRIED] if t.score > MARGIN]
    # on a jump by what the machine itself changes it may not come to rest: elsewhere it does
    tried = (fitted(problem, now, ground, t, first) for t in first)
    rough = next((g for g in tried if g is not None), None)
    if rough is None or rough.fit.sigma[0] >= now.fit.sigma[0]:
        return None
    return _sharpened(problem, now, rough.fit, ground, rough)


def _sharpened(
    problem: Problem, now: Grown, noise: Fit, ground: Ground | None = None, rough: Grown | None = None
) -> Grown | None:
    """Return the law with the term that is best by the noise that a fit leaves; None where none earns its price."""
    sharper = (Ground(now.fit) if ground is None else ground).sharper(noise)
    others = ranked(sharper)
    tried = [fitted(problem, now, sharper, t, others) for t in others[:TRIED] if t.score > MARGIN]
    found = [g for g in (rough, *tried) if g is not None]
    if not found:
        return None
    best = min(found, key=lambda g: g.cost)
    best = polished(problem, dataclasses.replace(best, others=tuple(others)))
    return best if best.cost < now.cost else None


def fitted(
    problem: Problem, now: Grown, ground: Ground, tried: Tried, others: Sequence[Tried], at: int | None = None
) -> Grown | None:
    """Return the exact fit of a law with one more form, or with it in place of the term `at`."""
    law, terms = list(now.law), terms_of(now.fit)
    term = ground.term(tried.target, tried.form, tried.limbs)
    if at is None:
        law, terms = [*law, tried], [*terms, term]
    else:
        law[at] = tried
        terms[len(terms) - len(law) + at] = term
    found = refitted(problem, now.fit, terms, tolerance=COMPARED)
    if found is None:
        return None
    cost = deviance_of(found) + sum(t.price + MARGIN for t in law)
    return Grown(found, tuple(law), tuple(others), cost)


def polished(problem: Problem, grown: Grown, i: int = -1) -> Grown:
    """Return a law with the constants within a term, default the last, where they explain most in the exact fit."""
    own, i = grown.law[i], i % len(grown.law)
    ground = Ground(grown.fit).freed(len(terms_of(grown.fit)) - len(grown.law) + i)
    found = dataclasses.replace(own, gain=ground.gain(ground.place(own.target), own.form, own.limbs))
    better = refine(ground, ground.place(own.target), found)
    if own.form.constants and np.allclose(better.form.constants, own.form.constants, rtol=1e-3):
        better = found
    again = fitted(problem, grown, ground, better, grown.others, i)
    return again if again is not None and again.cost <= grown.cost + MARGIN else grown


def curved(problem: Problem, grown: Grown) -> Grown:
    """Return a law whose terms each have the shape that they earn beside everything else that is fitted.

    What counts as a gross error, and the noise, follow the shape: each is looked at again by what it leaves.
    """
    for i in range(len(grown.law)):
        for _ in range(LOOKS):
            ground = Ground(grown.fit).freed(len(terms_of(grown.fit)) - len(grown.law) + i)
            bent = shaped(ground, placed(ground, grown.law[i]))
            same = bent.form.functions == grown.law[i].form.functions and bent.target == grown.law[i].target
            again = fitted(problem, grown, ground, bent, grown.others, i)
            if again is None or again.cost > grown.cost + COMPARED:
                break
            grown = again
            if same:
                break
    return grown


def reshaped(problem: Problem, grown: Grown) -> Grown:
    """Return a law whose terms are each shaped anew, of other states where these explain more."""
    for i in range(len(grown.law)):
        ground = Ground(grown.fit).freed(len(terms_of(grown.fit)) - len(grown.law) + i)
        other = reread(ground, grown.law[i])
        again = None if other is grown.law[i] else fitted(problem, grown, ground, other, grown.others, i)
        if again is not None and again.cost < grown.cost:
            grown = curved(problem, again)
    return grown


def placed(ground: Ground, tried: Tried) -> Tried:
    """Return a term of a law at the place where its form explains most, on the limbs that carry it.

    Places were compared by few simple forms; a curve tells them apart that is nearly right.
    """
    own = ground.place(tried.target)
    able = [p for p in ground.places if p.remembers or not tried.form.lags]
    others = [p for p in able if p.limbs == own.limbs and p is not own]
    read = [p for p in others if set(tried.form.states) <= set(ground.readable(p))]
    at = [
        dataclasses.replace(tried, target=p.target, gain=ground.gain(p, tried.form, tried.limbs)) for p in (own, *read)
    ]
    best = max(at, key=lambda t: t.gain)
    return best if best.gain > at[0].gain + COMPARED else tried


def _revised(problem: Problem, grown: Grown) -> Grown:
    """Return a law of several terms, each looked at again with the others beside it; dropped, where it is needless."""
    for i in range(len(grown.law) - 1):
        index = len(terms_of(grown.fit)) - len(grown.law) + i
        ground = Ground(grown.fit).freed(index)
        others = ranked(ground, AT_FIRST)
        if not others:
            continue
        other = fitted(problem, grown, ground, others[0], grown.others, i)
        if other is not None and other.cost < grown.cost:
            grown = other
    return grown
