"""Laws of one coefficient, in the language of the manual."""

from __future__ import annotations

import numpy as np

from deltacal_gen.physics.law import load_law
from deltacal_gen.physics.terms import Term

LIMB = 2
ENDS = (-1e9, 1e9)


def law(text: str, value: float, *constants: float, limbs: tuple[int, ...] = (LIMB,)) -> Term:
    """Return a law with one coefficient, found everywhere."""
    found = load_law(f"law {text}")
    own = limbs if found.PER_LIMB else ()
    return Term(found.NAME, own, np.full((max(len(own), 1), 1), value), (*constants, *ENDS * len(found.STATE)))
