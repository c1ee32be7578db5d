"""What is not named but may be there: effects that explain more than chance lets them, short of proof."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.charges import MARGIN
from deltacal_gen.diagnosis.refits import refitted, terms_of
from deltacal_gen.diagnosis.search import Found, Search
from deltacal_gen.diagnosis.selection import MOST_EFFECTS
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import Hint


@dataclass(frozen=True)
class Hinted:
    """An effect that may be there.

    Attributes
    ----------
    found : Found
        Its best form.
    term : Term
        With the coefficients that explain most.
    alike : tuple of str
        Effects that would explain the same.
    outweighed : bool
        Whether it earned its price beside noise of each row's own, but noise that hangs together explains more.
    """

    found: Found
    term: Term
    alike: tuple[str, ...]
    outweighed: bool = False


def hinted(search: Search, ambiguous: float) -> list[Hinted]:
    """Return what earns its charge beside all that was named, the best first.

    Beyond the first only what earned its full price, beside those before it.

    Parameters
    ----------
    search : Search
        Beside all that is named.
    ambiguous : float
        By how much less another effect may score that would explain the same [chi2].
    """
    out: list[Hinted] = []
    beside = search
    while (ranked := beside.ranked()) and ranked[0].score > (MARGIN if out else 0.0):
        best = ranked[0]
        others = [f for f in ranked[1:] if f.score > max(best.score - ambiguous, 0.0)]
        out.append(Hinted(best, search.estimated(best.term), tuple(f.term.effect for f in others)))
        beside = beside.added(*best.terms)
    return out


def outweighed(search: Search, others: Sequence[Hinted], ambiguous: float) -> list[Hinted]:
    """Return effects that correlated noise outweighs: in noise of each row's own they would earn their price."""
    at = search.fit
    if at.repeats.plain:
        return []
    white = refitted(at.problem, dataclasses.replace(at, repeats=at.repeats.as_plain()), terms_of(at))
    known = {name for name, _ in search.effects} | {name for h in others for name in (h.term.effect, *h.alike)}
    there = [] if white is None else hinted(Search(white, search.terms), ambiguous)
    out = []
    for hint in there:
        if hint.found.score > MARGIN and hint.term.effect not in known:
            gain = search.gain(search.where(hint.term))
            found = dataclasses.replace(hint.found, gain=gain, score=gain - search.price(hint.term))
            out.append(dataclasses.replace(hint, found=found, outweighed=True))
    return out


def told(several: list[Hinted], search: Search, chance: Chance) -> tuple[Hint, ...]:
    """Return hints as an answer tells them, beside all that was named in a search."""
    return tuple(
        Hint(
            name=h.term.effect,
            limbs=h.term.limbs,
            gain_chi2=h.found.gain,
            p_value=chance.of(h.found.score),
            indistinguishable_from=h.alike,
            earned=h.found.score > MARGIN and not h.outweighed,
            why=_why(h, len(search.effects)),
        )
        for h in several
    )


def _why(hint: Hinted, named: int) -> str:
    """Return why an effect is not named beside so many others."""
    if hint.outweighed:
        return "is explained as well by noise that hangs together from row to row: repeat poses measured long before"
    if hint.found.score <= MARGIN:
        return f"explains more than chance usually lets it; {MARGIN - hint.found.score:.0f} of chi2 are wanting"
    if named >= MOST_EFFECTS:
        return f"earned its price, but the search ends at {MOST_EFFECTS} effects: there is more to be found"
    return "earned its price, but readings held out do not bear it out yet"
