"""By how much two robot files of one machine differ."""

from __future__ import annotations

import numpy as np

from deltacal_gen.machine.machine import Machine
from deltacal_gen.machine.values import Robot


def between(mechanism: Machine, first: Robot, second: Robot) -> tuple[dict[str, float], list[str]]:
    """Return what the second robot's dimensions have more than the first's, and which differences cannot be said so.

    A dimension and an error are one where moving either moves the machine alike.

    Returns
    -------
    errors : dict
        By name of a source error (internal units).
    other : list of str
        Keys of dimensions that differ and are no source error.
    """
    out: dict[str, float] = {}
    other: list[str] = []
    for key, value in first.geometry.items():
        undrawn = np.isnan(value) & np.isnan(second.geometry[key])
        gap = np.where(undrawn, 0.0, second.geometry[key] - value)
        if not gap.any():
            continue
        errors = mechanism.same_as(first, key)
        gaps = np.broadcast_to(gap, (len(errors),)).tolist() if errors else []
        found = {name: g for name, g in zip(errors, gaps, strict=True) if g}
        if not errors or not found.keys() <= mechanism.index.keys():
            other.append(key)
        else:
            out |= found
    return out, other
