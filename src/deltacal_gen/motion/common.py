"""Effects in common: drives of one make have the same friction, and then it is one number, known by all joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2

from deltacal_gen.results.diagnosis import EffectParameter

ALIKE = 0.05  # p-value of what joints' values differ by: above it they agree within their standard deviations


@dataclass(frozen=True)
class Common:
    """Values that joints have in common.

    Attributes
    ----------
    parameters : tuple of EffectParameter
        Of all the joints, weighted by how surely each knows them.
    lost : float
        Of chi2, by not having a value for each.
    """

    parameters: tuple[EffectParameter, ...]
    lost: float


def in_common(each: Sequence[EffectParameter]) -> Common | None:
    """Return what joints have in common of an effect; None where there is one joint, or one of its values differs.

    A constant without a deviation, as an order, must be the same.
    """
    of_name: dict[str, list[EffectParameter]] = {}
    for p in each:
        of_name.setdefault(p.name, []).append(p)
    joints = len(each) // max(len(of_name), 1)
    found, lost, degrees = [], 0.0, 0
    for name, own in of_name.items():
        values = np.array([np.nan if isinstance(p.value, str) else p.value for p in own])
        std = np.array([np.nan if p.std is None else p.std for p in own])
        if len({p.unit for p in own}) > 1 or joints < 2 or not np.isfinite(values).all():
            return None
        if np.isnan(std).any():
            if np.ptp(values) > 0:
                return None
            continue
        weight = 1.0 / np.maximum(std, 1e-300) ** 2
        mean = float(values @ weight / weight.sum())
        lost += float(((values - mean) ** 2) @ weight)
        degrees += joints - 1
        deviation = float(weight.sum() ** -0.5)
        found.append(EffectParameter(name=name, limb=None, value=mean, std=deviation, unit=own[0].unit))
    if not found or chi2.sf(lost, degrees) < ALIKE:
        return None
    return Common(tuple(found), lost)
