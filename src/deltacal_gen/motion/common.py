"""Effects in common: drives of one make have the same friction.

What no joint's readings can pay for alone those of all may pay for together (`asked_in_common`): what is searched, the
effect and its size, is charged once. Values that agree are one number, known by all joints (`in_common`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.stats import chi2

from deltacal_gen.motion.fit import Fit, fitted
from deltacal_gen.motion.ladder import BUYS, SEVERAL, Ladder, price
from deltacal_gen.motion.library import Rung
from deltacal_gen.results.diagnosis import EffectParameter

ALIKE = 0.05  # p-value of what joints' values differ by: above it they agree within their standard deviations
SIZES = 12  # that are looked at of an effect in common, over those that any of its joints would tell


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


def asked_in_common(fits: Sequence[Fit], units: Sequence[str]) -> list[Fit]:
    """Return the ladders of all joints with the rungs that those which lack them pay for together.

    Parameters
    ----------
    units : sequence of str
        Of all joints, "rad" or "mm": what turns has no friction in common with what slides.
    """
    found = {fit.joint.number: fit for fit in fits}
    for unit in dict.fromkeys(units):
        while more := _asked([fit for j, fit in found.items() if units[j - 1] == unit]):
            found |= {fit.joint.number: fit for fit in more}
    return list(found.values())


def _asked(fits: Sequence[Fit]) -> list[Fit]:
    """Return the fits of the joints that lack a rung with it: the one that earns most beyond its price, if any does."""
    looked = _looked_at(fits)
    tried, best = sum(len(rungs) for rungs in looked.values()), (0.0, list[Fit]())
    for effect, rungs in looked.items():
        lacking = [fit for fit in fits if all(rung.effect != effect for rung in fit.rungs)]
        if len(lacking) < 2:
            continue
        ladders = [fit.ladder(rungs) for fit in lacking]
        options = range(-len(rungs), 0)
        total = np.sum([[_gain(ladder, n) for n in options] for ladder in ladders], axis=0)
        surplus = float(total.max()) - price(rungs[0].width * len(lacking), tried)
        if surplus > best[0] and _borne_out(ladders, options) and (more := _with(lacking, rungs[int(total.argmax())])):
            best = surplus, more
    return best[1]


def _looked_at(fits: Sequence[Fit]) -> dict[str, list[Rung]]:
    """Return by effect the rungs that joints may have in common: sizes over all that any of them would tell."""
    sizes: dict[str, set[tuple[float, ...]]] = {}
    for fit in fits:
        for rung in fit.joint.candidates:
            if SEVERAL not in rung.kernels.SEARCHED:
                sizes.setdefault(rung.effect, set()).add(rung.constants)
    found = {}
    for effect, own in sizes.items():
        every = np.array(sorted(own))[:, :1].ravel()
        found[effect] = (
            [Rung(effect, (float(size),)) for size in np.geomspace(every[0], every[-1], SIZES)]
            if len(every)
            else [Rung(effect)]
        )
    return found


def _beside(ladder: Ladder, option: int) -> tuple[list[int], int]:
    """Return what a joint has with an option, counted from behind, and the option's place."""
    own = len(ladder.rungs) + option
    return [*(k for k, rung in enumerate(ladder.rungs) if rung.effect != ladder.rungs[own].effect), own], own


def _gain(ladder: Ladder, option: int, but: int | None = None) -> float:
    """Return what an option earns on a joint in chi2, without a fold; less than anything where no drive has that."""
    folds = [f for f in ladder.bench.folds if f != but]
    chosen, own = _beside(ladder, option)
    return -np.inf if own in ladder.impossible(chosen, folds) else ladder.gain(chosen, own, folds)


def _borne_out(ladders: Sequence[Ladder], options: Sequence[int]) -> bool:
    """Tell whether what other folds choose takes enough of every fold away, and makes no joint worse."""
    before, after = np.zeros(len(ladders)), np.zeros(len(ladders))
    for fold in sorted({f for ladder in ladders for f in ladder.bench.folds}):
        total = np.sum([[_gain(ladder, n, fold) for n in options] for ladder in ladders], axis=0)
        option = options[int(np.argmax(total))]
        for j, ladder in enumerate(ladders):
            others = [f for f in ladder.bench.folds if f != fold]
            if len(others) == len(ladder.bench.folds):
                continue
            chosen, own = _beside(ladder, option)
            for rungs, out in (([k for k in chosen if k != own], before), (chosen, after)):
                columns = ladder.columns(rungs)
                bench = ladder.bench.with_ridge(columns, others)
                out[j] += bench.error(columns, bench.fit(columns, others), [fold])
    ratio = after / np.maximum(before, 1e-300)
    return bool((ratio <= 1.0).all()) and 1.0 - float(np.sqrt(ratio.mean())) >= BUYS


def _with(fits: Sequence[Fit], rung: Rung) -> list[Fit]:
    """Return fits with a further rung, its size the joint's own by then; nothing where one foretells worse so."""
    found = []
    for fit in fits:
        after = fitted(fit.joint, [*fit.rungs, rung])
        if _size(after) > _size(fitted(fit.joint, fit.rungs)):
            return []
        after = replace(after, alike=(*fit.alike, ()), lag=fit.lag, first=fit.first)
        found.append(after.with_worth())
    return found


def _size(fit: Fit) -> float:
    return float(np.nanmean(fit.held_out**2))
