"""Where laws were found, and which rows of other recordings lie outside of it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from deltacal_gen.physics.body import Body
from deltacal_gen.physics.deformed import Deformed
from deltacal_gen.physics.law import Law
from deltacal_gen.physics.terms import Term


def outside(body: Body, machine: Deformed, terms: Sequence[Term]) -> np.ndarray:
    """Return which rows (N,) lie where some law among effects was never seen: beyond the range of a state it reads."""
    out: np.ndarray = np.zeros(len(body.q), dtype=bool)
    for term in terms:
        law = term.kernels
        if not isinstance(law, Law) or not law.STATE:
            continue
        x = np.nan_to_num(machine.x)
        state = body.state([s.name for s in term.states], x, machine.q, machine.rows, term.limbs)
        for k in range(len(term.limbs) or 1):
            each = [state[name] for name in law.STATE]
            own = [values[:, term.limbs[k] - 1] if values.ndim == 2 else values for values in each]
            out |= law.beyond(np.stack(own, axis=1), term.constants).any(axis=1)
    return out


def in_words(beyond: np.ndarray, what: str) -> str | None:
    """Return how many rows lie outside of where a law was found, None where none does."""
    if not beyond.any():
        return None
    return (
        f"{beyond.sum()} of {len(beyond)} {what} lie outside the range in which the law was found: it goes on for half "
        "of that range, by no more than it varied within, and then stays"
    )
