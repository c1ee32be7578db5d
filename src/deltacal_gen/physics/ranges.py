"""Where laws were found, and which rows of other recordings lie outside of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from deltacal_gen.physics.body import Body, Deformed
from deltacal_gen.physics.law import Law
from deltacal_gen.physics.terms import Term

ROUNDING = 1e-9  # of a range: less beyond it is none


def outside(body: Body, machine: Deformed, terms: Sequence[Term]) -> np.ndarray:
    """Return which rows (N,) lie where some law among effects was never seen: beyond the range of a state it reads."""
    out: np.ndarray = np.zeros(len(body.q), dtype=bool)
    for term in terms:
        law = term.kernels
        if not isinstance(law, Law) or not law.STATE:
            continue
        x = np.nan_to_num(machine.x)
        state = body.state([s.name for s in term.states], x, machine.q, machine.rows, term.limbs)
        low, high = law.ends(term.constants).T
        width = ROUNDING * (high - low)
        for name, least, most in zip(law.STATE, low - width, high + width, strict=True):
            values = state[name]
            own = values[:, [i - 1 for i in term.limbs]] if values.ndim == 2 and term.limbs else values
            beyond = (own < least) | (own > most)
            out |= beyond.any(axis=1) if beyond.ndim == 2 else beyond
    return out


def in_words(beyond: np.ndarray, what: str) -> str | None:
    """Return how many rows lie outside of where a law was found, None where none does."""
    if not beyond.any():
        return None
    return (
        f"{beyond.sum()} of {len(beyond)} {what} lie outside the range in which the law was found: it goes on for half "
        "of that range and then stays"
    )
