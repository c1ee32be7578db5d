"""The fit of one joint of a recording in motion: the effects that are worth it, chosen and held out fold by fold."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.motion.joint import USUAL, Joint
from deltacal_gen.motion.ladder import BEGUN_WITH, BUYS, Ladder, LookedAt, columns_of
from deltacal_gen.motion.library import LOAD, Rung, hats, resolution
from deltacal_gen.motion.regression import BETWEEN, prior_of
from deltacal_gen.motion.sizes import settled

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

TRIED = 5  # sizes that are tried around the one found, before it is fitted
REFINED = (1.6, 1.12)  # factors either way: half of what lies between two sizes that are searched, then between these
SETTLES = 2  # fits after which a load no longer changes by what readings tell
MADE_UP = 1e-9  # of the largest singular value: effects that others make up are none
SMOOTH = 12  # hats of a smooth function of position, which waves must beat


@dataclass(frozen=True)
class Lag:
    """By how much the readings of a joint come late [s], and what it takes away of them; see `Fit`."""

    delay: float
    std: float
    bought: float
    gain: float


@dataclass(frozen=True, eq=False)
class Fit:
    """A joint with what was found.

    Attributes
    ----------
    joint : Joint
    rungs : tuple of Rung
    coefficients, std : (r + c,) arrays
        In units inside; of base parameters, then of effects.
    load : (M,) array
        What the rigid machine asks of the joint.
    left : (M,) array
        Residuals of the fit to all samples.
    held_out : (M,) array
        Residuals of samples that took no part in fit nor choice; nan of those that no fold holds.
    together : float
        Samples that count as one.
    bought : tuple of float
        Part of the held-out rms that each rung takes away beside the others.
    gains : tuple of float
        Of chi2, likewise: in a fit, or where that does not pay for the rung on samples it took no part in.
    alike : tuple of tuple of str
        Effects that would do as well in place of each.
    passed_over : tuple of LookedAt
        What the effects would do that were not taken.
    first : LookedAt or None
        The effect that explains most where nothing else is taken.
    lag : Lag or None
        By how much readings come late, where they do.
    size_std : tuple of float
        Standard deviation of the logarithm of each size, in the order of the rungs that have one.
    covariance : (p, p) array
        Of the coefficients, then of these logarithms.
    """

    joint: Joint
    rungs: tuple[Rung, ...]
    coefficients: Array
    std: Array
    load: Array
    left: Array
    held_out: Array
    together: float
    bought: tuple[float, ...] = ()
    gains: tuple[float, ...] = ()
    alike: tuple[tuple[str, ...], ...] = ()
    passed_over: tuple[LookedAt, ...] = ()
    first: LookedAt | None = None
    lag: Lag | None = None
    size_std: tuple[float, ...] = ()
    covariance: Array = field(default_factory=lambda: np.zeros((0, 0)), repr=False)

    @property
    def takes_away(self) -> float:
        """What all that was found takes away, each beside the others, in the variance that is left."""
        bought = [*self.bought, *([] if self.lag is None else [self.lag.bought])]
        return float(sum((1.0 - b) ** -2 - 1.0 for b in bought))

    def of_effects(self, picked: slice, moved: dict[str, Array]) -> Array:
        """Return what the effects add at some of the samples used, a few of the joint's states being other ones."""
        total, at = np.zeros(len(self.left[picked])), self.joint.X.shape[1]
        for rung in self.rungs:
            states = self.joint.states | {LOAD: self.load} | self.joint.remembered(rung)
            columns = rung.columns({name: values[picked] for name, values in states.items()} | moved)
            total += columns @ self.coefficients[at : at + rung.width]
            at += rung.width
        return total

    def beside_effects(self, X: Array) -> Array:
        """Return columns (M, r) without what the effects do as well: what may be either's tells of neither."""
        if not self.rungs:
            return X
        F = self.joint.columns(self.rungs, self.load)[:, self.joint.X.shape[1] :]
        return np.asarray(X - F @ np.linalg.lstsq(F, X, rcond=MADE_UP)[0])

    def ladder(self, more: Sequence[Rung] = ()) -> Ladder:
        """Return the ladder of what the fit has and of further rungs, to be asked what each is worth beside others."""
        joint, rungs = self.joint, (*self.rungs, *more)
        X = joint.columns(rungs, self.load)
        bench, at = joint.bench(X), columns_of(rungs, joint.X.shape[1])
        return Ladder(bench, rungs, at, X, joint.y, joint.correlated, joint.held, sense=joint.sense)

    def with_worth(self) -> Fit:
        """Return the fit with what each rung is worth beside the others, and what others would do beside all."""
        ladder, every = self.ladder(self.joint.candidates), range(len(self.rungs))
        return dataclasses.replace(
            self,
            bought=tuple(ladder.buys(every, k, ladder.bench.folds) for k in every),
            gains=tuple(ladder.earned(every, k, ladder.bench.folds) for k in every),
            passed_over=ladder.passed_over(every, ladder.bench.folds),
        )

    @property
    def prior(self) -> float:
        """What is known of the rigid machine beforehand, as a ridge; see `prior_of`."""
        return prior_of(self.left, self.together, self.joint.y + self.joint.carried)

    @property
    def sigma(self) -> float:
        """Standard deviation of residuals, for the coefficients that were fitted."""
        free = max(1.0, len(self.left) / self.together - len(self.coefficients))
        return float(np.sqrt(np.mean(self.left**2) * (len(self.left) / self.together) / free))


def fitted(joint: Joint, some: Sequence[Rung], held_out: Array | None = None) -> Fit:
    """Return the fit of a joint's rigid machine and some effects to all samples.

    `held_out` are residuals that were found otherwise; by default those of folds, each fitted by the others.
    """
    load, X = _by_own_load(joint, some, joint.load_by(None), None)
    some, by_size = settled(joint, some, load)
    X = joint.columns(some, load)
    bench = joint.bench(np.hstack([X, by_size]))
    every, each = range(X.shape[1]), range(X.shape[1] + by_size.shape[1])
    bench = bench.with_ridge(every)
    left = bench.left(X, joint.y, every, range(len(bench.n)))
    bench = bench.with_prior(prior_of(left, joint.correlated(left), joint.y + joint.carried))
    found = bench.fit(every, range(len(bench.n))) / bench.scale[every]
    left = joint.y - X @ found
    count = joint.correlated(left)
    free = max(1.0, len(left) / count - len(each))
    variance = float(left @ left) / count / free
    covariance = bench.covariance(each) * variance * count / np.outer(bench.scale, bench.scale)
    std = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    if held_out is None:
        held_out = bench.left_apart(X, joint.y, joint.held, every, bench.folds)
    rigid = joint.X.shape[1]
    load = np.asarray(joint.X @ found[:rigid] + joint.carried)
    sized = tuple(std[len(found) :])
    fit = Fit(joint, tuple(some), found, std[every], load, left, held_out, count, size_std=sized)
    return dataclasses.replace(fit, covariance=covariance)


def _by_own_load(joint: Joint, some: Sequence[Rung], load: Array, folds: Sequence[int] | None) -> tuple[Array, Array]:
    """Return the load on a joint by a fit of these very effects to some folds or all, and the columns by that load.

    It begins with a load by usual friction, which of a joint with more takes a part of that for the machine's.
    """
    X, rigid = joint.columns(some, load), joint.X.shape[1]
    for _ in range(SETTLES if any(rung.of_load for rung in some) else 0):
        bench, every = joint.bench(X), range(X.shape[1])
        bench = bench.with_ridge(every, folds)
        found = bench.fit(every, range(len(bench.n)) if folds is None else folds) / bench.scale
        load = np.asarray(joint.X @ found[:rigid] + joint.carried)
        X = joint.columns(some, load)
    return load, X


def climbed(joint: Joint) -> Fit:
    """Return the fit of a joint with the effects that are worth it.

    Fold by fold the effects are chosen, and fitted, by the others: residuals of that fold are those of a choice and a
    fit that it took no part in. The effects that are named are then chosen by all folds.
    """
    candidates = joint.candidates
    load = joint.load_by(None)
    X = joint.columns(candidates, load)
    rigid, width = joint.X.shape[1], X.shape[1]
    at = columns_of(candidates, rigid)
    X = np.asfortranarray(np.hstack([X, hats(joint.states["q"], SMOOTH)]))  # what is read is some columns
    bench = joint.bench(X)
    rival = tuple(range(width, X.shape[1]))
    resolved = resolution(joint.states)
    ladder = Ladder(bench, candidates, at, X, joint.y, joint.correlated, joint.held, rival, resolved, sense=joint.sense)
    held_out = np.full(len(joint.y), np.nan)
    for fold in bench.folds:
        others, own = [f for f in bench.folds if f != fold], joint.held == fold
        held_out[own] = _apart(joint, ladder, others, own)
    plain, usual = (fitted(joint, some).held_out for some in ([], [Rung(name) for name in BEGUN_WITH]))
    if _size(held_out) <= (1.0 - BUYS) * _size(plain):
        ladder, chosen = _climbed_by(joint, ladder, load, bench.folds)
    elif (joint.fold == BETWEEN).any() and _size(usual) <= (1.0 - BUYS) * _size(plain):
        # of few and short stretches others choose nothing that holds, and what drives usually have may
        held_out = usual
        chosen = ladder.needed([k for k, rung in enumerate(candidates) if rung.effect in BEGUN_WITH], bench.folds)
    else:  # nothing that is chosen foretells a fold: nothing is told
        chosen, held_out = list[int](), plain
    chosen.sort(key=lambda k: (candidates[k].effect not in USUAL, candidates[k].effect, candidates[k].constants))
    fit, ladder = _settled(joint, ladder, chosen, held_out)
    if len(needed := ladder.needed(chosen, bench.folds)) < len(
        chosen
    ):  # it made up for a size, or a load, that was off
        chosen = needed
        fit, ladder = _settled(joint, ladder, chosen, held_out)
    return dataclasses.replace(
        fit,
        bought=tuple(ladder.buys(chosen, k, bench.folds) for k in chosen),
        gains=tuple(ladder.earned(chosen, k, bench.folds) for k in chosen),
        alike=tuple(ladder.alike(chosen, k) for k in chosen),
        passed_over=ladder.passed_over(chosen, bench.folds),
        first=ladder.first(bench.folds),
    )


def _size(residuals: Array) -> float:
    """Return the rms of those residuals that are known; nothing where none is."""
    known = residuals[np.isfinite(residuals)]
    return float(np.sqrt(np.mean(known**2))) if len(known) else 0.0


def _settled(joint: Joint, ladder: Ladder, chosen: Sequence[int], held_out: Array) -> tuple[Fit, Ladder]:
    """Return the fit of some rungs to all samples, and the ladder with these at the sizes and the load found."""
    fit = fitted(joint, [ladder.rungs[k] for k in chosen], held_out)
    found = zip(chosen, fit.rungs, strict=True)
    moved = {k: rung for k, rung in found if rung.continuous or rung.of_load}
    return fit, _with_rungs(joint, ladder, moved, fit.load)


def _apart(joint: Joint, ladder: Ladder, others: Sequence[int], own: np.ndarray) -> Array:
    """Return residuals of some samples `own` by a choice and a fit of other folds alone."""
    load = joint.load_by(others)
    by_load = {k: rung for k, rung in enumerate(ladder.rungs) if rung.of_load}
    ladder, chosen = _climbed_by(joint, _with_rungs(joint, ladder, by_load, load), load, others)
    _, columns = _by_own_load(joint, [ladder.rungs[k] for k in chosen], load, others)
    apart, every = joint.bench(columns), range(columns.shape[1])
    return apart.with_ridge(every, others).left(columns[own], joint.y[own], every, others)


def _climbed_by(joint: Joint, ladder: Ladder, load: Array, folds: Sequence[int]) -> tuple[Ladder, list[int]]:
    """Return the rungs that some folds choose, and the ladder with these at the sizes that leave least there.

    What is searched from size to size leaves something between them, which another effect might seem to explain, and
    for want of which one might buy too little: sizes are refined by themselves, and the ladder is climbed again.
    """
    chosen = ladder.climb(folds)
    for wide in REFINED:
        sized = [k for k in (*chosen, *ladder.nearly(chosen, folds)) if ladder.rungs[k].continuous]
        if not sized:
            break
        beside = [ladder.rungs[k] for k in chosen if k not in sized]
        refined = {k: _refined(joint, beside, ladder.rungs[k], wide, load, folds) for k in sized}
        ladder = _with_rungs(joint, ladder, refined, load)
        chosen = ladder.climb(folds)
    return ladder, chosen


def _with_rungs(joint: Joint, ladder: Ladder, rungs: Mapping[int, Rung], load: Array) -> Ladder:
    """Return a ladder with other rungs of the same effects in some places, by some load."""
    states, every, X = joint.states | {LOAD: load}, list(ladder.rungs), ladder.X.copy(order="K")
    for k, rung in rungs.items():
        every[k] = rung
        X[:, ladder.at[k]] = joint.of_rung(rung, states)
    changed = [c for k in rungs for c in ladder.at[k]]
    bench = ladder.bench.with_columns(changed, X, joint.y, joint.fold) if changed else ladder.bench
    return dataclasses.replace(ladder, bench=bench, X=X, rungs=tuple(every), counted={})


def _refined(joint: Joint, beside: Sequence[Rung], rung: Rung, wide: float, load: Array, folds: Sequence[int]) -> Rung:
    """Return an effect with the size, up to a factor `wide` from its own, that leaves least of some folds."""
    tried = [Rung(rung.effect, (rung.constants[0] * f,)) for f in np.geomspace(1 / wide, wide, TRIED)]
    X = joint.columns([*beside, *tried], load)
    bench = joint.bench(X)
    first = X.shape[1] - sum(t.width for t in tried)
    errors = [bench.train([*range(first), first + n], folds) for n in range(len(tried))]
    return tried[int(np.argmin(errors))]
