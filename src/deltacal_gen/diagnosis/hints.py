"""What is not named but may be there: effects that explain more than chance lets them, short of proof."""

from __future__ import annotations

from dataclasses import dataclass

from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.charges import MARGIN
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
    """

    found: Found
    term: Term
    alike: tuple[str, ...]


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


def told(several: list[Hinted], search: Search, chance: Chance) -> tuple[Hint, ...]:
    """Return hints as an answer tells them, beside all that was named in a search."""
    return tuple(
        Hint(
            name=h.term.effect,
            limbs=h.term.limbs,
            gain_chi2=h.found.gain,
            p_value=chance.of(h.found.score),
            indistinguishable_from=h.alike,
            earned=h.found.score > MARGIN,
            why=_why(h, len(search.effects)),
        )
        for h in several
    )


def _why(hint: Hinted, named: int) -> str:
    """Return why an effect is not named beside so many others."""
    if hint.found.score <= MARGIN:
        return f"explains more than chance usually lets it; {MARGIN - hint.found.score:.0f} of chi2 are wanting"
    if named >= MOST_EFFECTS:
        return f"earned its price, but the search ends at {MOST_EFFECTS} effects: there is more to be found"
    return "earned its price, but readings held out do not bear it out yet"
