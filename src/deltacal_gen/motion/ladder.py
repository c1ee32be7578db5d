"""The ladder of one joint: effects that are taken one by one, as long as each buys something on held-out samples."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.motion.joint import DRY, VISCOUS
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.regression import Bench

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

BUYS = 0.02  # of the held-out rms: what a rung must take away
NEARLY = 0.5  # of that: a size between those that are searched may buy the rest
MOST = 8  # rungs
BEGUN_WITH = DRY, VISCOUS
LOOKED_AT = 15  # of the candidates that leave least of the samples of a fit: the ones that are held out
PAIRED = 3  # of the rungs that buy enough and earn too little: those to which another is sought
ROUNDS = 3  # of climbing and stepping back
PER_COEFFICIENT = 6.0  # of chi2: what a coefficient must earn; and twice the logarithm of how many were looked at
ALIKE = 10.0  # of chi2: effects whose fits differ by less are not told apart
SEVERAL = "orders"  # a machine may have an effect that is searched so at several of them


@dataclass(frozen=True)
class LookedAt:
    """What an effect would do on one joint, in the form that explains most.

    Attributes
    ----------
    effect : str
    gain : float
        Of chi2, samples that hang together counted as one.
    width : int
        Its coefficients.
    tried : int
        Candidates among which it was looked for.
    buys : float
        Part of the held-out rms that it takes away beside the rungs chosen.
    impossible : bool
        Whether it has a coefficient there whose sign no drive has.
    """

    effect: str
    gain: float
    width: int
    tried: int
    buys: float = 0.0
    impossible: bool = False

    @property
    def price(self) -> float:
        """What it must earn in chi2."""
        return price(self.width, self.tried)


def price(width: int, tried: int) -> float:
    """Return what an effect of some coefficients, the best of some candidates, must earn in chi2."""
    return PER_COEFFICIENT * width + 2 * float(np.log(tried))


def columns_of(rungs: Sequence[Rung], first: int) -> tuple[tuple[int, ...], ...]:
    """Return where the columns of each of some rungs stand, one after another from `first` on."""
    ends = first + np.cumsum([0, *(rung.width for rung in rungs)])
    return tuple(tuple(range(a, b)) for a, b in pairwise(ends.tolist()))


@dataclass(frozen=True)
class Ladder:
    """Candidates of one joint and where their columns stand.

    Attributes
    ----------
    bench : Bench
    rungs : tuple of Rung
    at : tuple of tuple of int
        Columns of each.
    X, y : (M, p), (M,) arrays
        The columns, unscaled, and the readings.
    correlated : callable
        How many samples count as one, by residuals (M,).
    held : (M,) array of int
        Fold with which each sample is held out.
    rival : tuple of int
        Columns of a smooth function of the joint's position: what is no better than that is no periodic effect.
    resolution : float
        Periods per turn by which two waves differ that the joint's motion tells apart.
    sense : float
        -1 where readings are counted against the joint's angle: so are coefficients then.
    counted : dict
        What `correlated` said of fits of some rungs.
    """

    bench: Bench
    rungs: tuple[Rung, ...]
    at: tuple[tuple[int, ...], ...]
    X: Array
    y: Array
    correlated: Callable[[Array], float]
    held: np.ndarray
    rival: tuple[int, ...] = ()
    resolution: float = 1.0
    sense: float = 1.0
    counted: dict[frozenset[int], float] = field(default_factory=dict)

    def columns(self, chosen: Sequence[int]) -> list[int]:
        """Return the columns of the rigid machine and of some rungs."""
        return [*range(self.bench.rigid), *(c for k in chosen for c in self.at[k])]

    def climb(self, folds: Sequence[int]) -> list[int]:
        """Return the rungs that are worth it, by what they buy on folds that fits took no part in."""
        chosen = self._climb(range(len(self.rungs)), folds)
        waves = [k for k in chosen if SEVERAL in self.rungs[k].kernels.SEARCHED]
        if waves:
            others = [k for k in chosen if k not in waves]
            smooth = self.bench.held_out([*self.columns(others), *self.rival], folds)
            if smooth <= self.bench.held_out(self.columns(chosen), folds):
                chosen = self._climb([k for k, r in enumerate(self.rungs) if SEVERAL not in r.kernels.SEARCHED], folds)
        return chosen

    def _climb(self, allowed: Sequence[int], folds: Sequence[int]) -> list[int]:
        """Return the rungs of those allowed that are worth it, beginning with what drives usually have.

        Begun with nothing, a rare effect that looks like two usual ones together would be taken in their place.
        """
        chosen = [k for k in allowed if self.rungs[k].effect in BEGUN_WITH]
        for _ in range(ROUNDS):
            before = list(chosen)
            while len(chosen) < MOST and (found := self._next(chosen, folds, allowed)):
                chosen.extend(found)
            chosen = self.needed(chosen, folds)
            if set(chosen) == set(before):
                break
        return chosen

    def buys(self, chosen: Sequence[int], rung: int, folds: Sequence[int]) -> float:
        """Return which part of the held-out rms a rung takes away beside the others chosen."""
        without = self.bench.held_out(self.columns([k for k in chosen if k != rung]), folds)
        return 1.0 - float(np.sqrt(self.bench.held_out(self.columns([*chosen]), folds) / max(without, 1e-300)))

    def together(self, chosen: Sequence[int]) -> float:
        """Return how many samples count as one, by what a fit of some rungs leaves.

        What a rung explains that is not taken yet hangs together as well: the fewer rungs, the fewer samples.
        """
        if (key := frozenset(chosen)) not in self.counted:
            columns = self.columns(chosen)
            found = self.bench.fit(columns, range(len(self.bench.n))) / self.bench.scale[columns]
            self.counted[key] = self.correlated(self.y - self.X[:, columns] @ found)
        return self.counted[key]

    def gain(self, chosen: Sequence[int], rung: int, folds: Sequence[int]) -> float:
        """Return by how much chi2 falls with a rung beside the others, samples that hang together counted as one."""
        others = [k for k in chosen if k != rung]
        count = float(self.bench.n[list(folds)].sum()) / self.together(others)
        before = self.bench.train(self.columns(others), folds)
        after = self.bench.train(self.columns([*chosen]), folds)
        return count * float(np.log(before / max(after, 1e-300)))

    def foretells(self, chosen: Sequence[int], rung: int, folds: Sequence[int]) -> float:
        """Return by how much chi2 falls on folds that fits took no part in, samples that hang together there as one.

        Many base parameters take up in a fit what a rung would explain, and predict no other movement by that. What
        is predicted wrong with a rung that is none hangs together for longer than noise: it goes with the movement.
        """
        count = float(self.bench.n[list(folds)].sum()) / self.correlated(self.apart(chosen, folds))
        return -2.0 * count * float(np.log1p(-min(self.buys(chosen, rung, folds), 1.0 - 1e-12)))

    def apart(self, chosen: Sequence[int], folds: Sequence[int]) -> Array:
        """Return residuals (M,) of samples of some folds, each by a fit of some rungs to the others; 0 elsewhere."""
        columns = self.columns(chosen)
        bench = self.bench.with_ridge(columns, folds)
        return np.nan_to_num(bench.left_apart(self.X, self.y, self.held, columns, folds))

    def impossible(self, chosen: Sequence[int], folds: Sequence[int]) -> list[int]:
        """Return the rungs that a fit gives a coefficient below zero, where its effect has none: no drive has that."""
        columns = self.columns(chosen)
        found = dict(zip(columns, self.bench.fit(columns, folds), strict=True))
        signed = {k: [low >= 0 for low, _ in self.rungs[k].kernels.BELIEVABLE] for k in chosen}
        return [
            k
            for k in chosen
            if any(self.sense * found[c] < 0 for c, of_one in zip(self.at[k], signed[k], strict=True) if of_one)
        ]

    def charge(self, rung: int) -> float:
        """Return what a rung must earn in chi2."""
        return price(len(self.at[rung]), len(self.rungs))

    def passed_over(self, chosen: Sequence[int], folds: Sequence[int]) -> tuple[LookedAt, ...]:
        """Return what each effect that is not chosen would do beside the rungs chosen."""
        found = []
        for k in self._best_of_each(chosen, folds):
            own = self.rungs[k].effect, self.gain([*chosen, k], k, folds), len(self.at[k]), len(self.rungs)
            driven = k in self.impossible([*chosen, k], folds)
            found.append(LookedAt(*own, self.buys([*chosen, k], k, folds), driven))
        return tuple(found)

    def nearly(self, chosen: Sequence[int], folds: Sequence[int]) -> list[int]:
        """Return of every effect that is not chosen the rung that explains most, where that buys nearly enough."""
        best = self._best_of_each(chosen, folds)
        return [k for k in best if self.buys([*chosen, k], k, folds) > NEARLY * BUYS]

    def alike(self, chosen: Sequence[int], rung: int) -> tuple[str, ...]:
        """Return the effects that would do as well in place of one of the rungs chosen."""
        others = [k for k in chosen if k != rung]
        count = float(self.bench.n[list(self.bench.folds)].sum()) / self.together(others)
        rivals = [k for k in self.open(chosen) if self.rungs[k].effect != self.rungs[rung].effect]
        worse = count * self.worse_by(others, rivals, chosen)
        return tuple(dict.fromkeys(self.rungs[k].effect for k, by in zip(rivals, worse, strict=True) if by < ALIKE))

    def worse_by(self, others: Sequence[int], rivals: Sequence[int], chosen: Sequence[int]) -> Array:
        """Return the logarithm of the mean square that each of some rungs leaves beside others, over that of `chosen`.

        The mean squares are those of fits to all folds.
        """
        bench, without = self.bench, self.columns(others)
        after = bench.train(without, bench.folds) - bench.gains(without, [self.at[k] for k in rivals], bench.folds)
        return np.asarray(np.log(np.maximum(after, 1e-300) / bench.train(self.columns(chosen), bench.folds)))

    def first(self, folds: Sequence[int]) -> LookedAt | None:
        """Return the effect that explains most for its price, where nothing is chosen yet."""
        each = [(k, self.gain([k], k, folds)) for k in self._best_of_each([], folds)]
        if not each:
            return None
        k, gain = max(each, key=lambda pair: pair[1] - self.charge(pair[0]))
        return LookedAt(self.rungs[k].effect, gain, len(self.at[k]), len(self.rungs))

    def _best_of_each(self, chosen: Sequence[int], folds: Sequence[int]) -> list[int]:
        """Return of every effect that is not chosen the rung that leaves least of a fit to some folds."""
        taken = {self.rungs[k].effect for k in chosen}
        rest = [k for k in range(len(self.rungs)) if self.rungs[k].effect not in taken]
        if not rest:
            return []
        gains = self.bench.gains(self.columns(chosen), [self.at[k] for k in rest], folds)
        best: dict[str, int] = {}
        for n in np.argsort(-gains):
            best.setdefault(self.rungs[rest[n]].effect, rest[n])
        return list(best.values())

    def open(self, chosen: Sequence[int]) -> list[int]:
        """Return the rungs that may still be taken: an effect once, at one of its sizes."""
        taken = {self.rungs[k].effect for k in chosen if SEVERAL not in self.rungs[k].kernels.SEARCHED}
        near = {k for k, r in enumerate(self.rungs) for c in chosen if self._near(r, self.rungs[c])}
        return [k for k, r in enumerate(self.rungs) if k not in near and k not in chosen and r.effect not in taken]

    def _near(self, one: Rung, other: Rung) -> bool:
        """Tell whether two waves differ by less than a period over what the joint passes: nobody tells them apart."""
        waves = one.effect == other.effect and SEVERAL in one.kernels.SEARCHED
        return waves and abs(one.constants[0] - other.constants[0]) < self.resolution

    def _next(self, chosen: list[int], folds: Sequence[int], allowed: Sequence[int]) -> list[int]:
        """Return the rung that buys most, or two of which neither pays without the other; none where none buys enough.

        What two explain hangs together, as long as either is not taken, and counts as few samples.
        """
        unpaid = []
        for k in self._buying(chosen, folds, allowed):
            if self._pays([*chosen, k], [k], folds):
                return [k]
            unpaid.append(k)
        for k in unpaid[:PAIRED]:
            for other in self._buying([*chosen, k], folds, allowed)[:PAIRED]:
                if self._pays([*chosen, k, other], [k, other], folds):
                    return [k, other]
        return []

    def _buying(self, chosen: list[int], folds: Sequence[int], allowed: Sequence[int]) -> list[int]:
        """Return the rungs that may still be taken and buy enough, what buys most first."""
        rest = [k for k in self.open(chosen) if k in allowed]
        if not rest or len(folds) < 2:
            return []
        gains = self.bench.gains(self.columns(chosen), [self.at[k] for k in rest], folds)
        rest = [rest[n] for n in np.argsort(-gains)[:LOOKED_AT]]
        now = self.bench.held_out(self.columns(chosen), folds)
        errors = [self.bench.held_out(self.columns([*chosen, k]), folds) for k in rest]
        return [rest[n] for n in np.argsort(errors) if errors[n] < (1.0 - BUYS) ** 2 * now]

    def _pays(self, chosen: list[int], taken: Sequence[int], folds: Sequence[int]) -> bool:
        """Tell whether each of some rungs of those chosen could be and earns more than its charge.

        One of two may earn it on folds that it took no part in: a fit without it counts as few samples.
        """
        if set(taken) & set(self.impossible(chosen, folds)):
            return False
        unpaid = [k for k in taken if self.gain(chosen, k, folds) <= self.charge(k)]
        return len(unpaid) < len(taken) and all(self.foretells(chosen, k, folds) > self.charge(k) for k in unpaid)

    def needed(self, chosen: list[int], folds: Sequence[int]) -> list[int]:
        """Return the rungs without those that the others make needless, the most needless first.

        What drives usually have is begun with, not chosen: it too must earn what it costs, in a fit or on the folds
        that it took no part in.
        """
        while chosen:
            bought = {k: self.buys(chosen, k, folds) for k in chosen}
            least = min(self.impossible(chosen, folds) or chosen, key=bought.__getitem__)
            if bought[least] >= BUYS and not self.impossible(chosen, folds):
                unpaid = [k for k in chosen if self.rungs[k].effect in BEGUN_WITH]
                earned = {k: self.earned(chosen, k, folds) - self.charge(k) for k in unpaid}
                least = min(earned, key=earned.__getitem__, default=-1)
                if least < 0 or earned[least] > 0:
                    break
            chosen = [k for k in chosen if k != least]
        return chosen

    def earned(self, chosen: Sequence[int], rung: int, folds: Sequence[int]) -> float:
        """Return what a rung earns in chi2: in a fit, or where that does not pay for it on folds it took no part in."""
        gain = self.gain(chosen, rung, folds)
        return gain if gain > self.charge(rung) else max(gain, self.foretells(chosen, rung, folds))
