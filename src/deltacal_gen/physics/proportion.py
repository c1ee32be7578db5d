"""Values out of all proportion: what an instrument, a drive or a bus writes where it has no reading."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

SPIKE = 50.0  # times what others are ordinarily off: no drive, no joint and no reading is
LONGEST_SPIKE = 3  # samples
ORDINARY = 0.99, 0.98, 0.95, 0.9  # of the samples: what these are off by is ordinary
BETWEEN = 5.0  # times what others are off: of more than the first of these parts, what is out of proportion
NOTHING = 1e-3  # of the size of what is read: to be off by less is ordinary


def out_of_proportion(off: Array, size: Array, count: float) -> np.ndarray:
    """Tell which samples (M,) are `off` by what no other is, beside their size (M,) and the least step of a column.

    One in a hundred may be, or more where nothing lies between these and all others.
    """
    for ordinary in ORDINARY:
        limit = float(np.quantile(off, ordinary))
        limit = max(limit, 1e-12 + NOTHING * float(np.quantile(size[off <= limit], ordinary)), count)
        out = np.asarray(off > SPIKE * limit)
        if out.any() and (ordinary == ORDINARY[0] or off[out].min() > BETWEEN * off[~out].max()):
            return out
    return np.zeros(len(off), dtype=bool)
