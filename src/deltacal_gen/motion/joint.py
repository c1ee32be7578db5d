"""One joint of a recording in motion: its samples, its candidates, and its fit."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.derivatives import Motion
from deltacal_gen.motion.ladder import BUYS, Ladder, LookedAt, columns_of
from deltacal_gen.motion.library import Rung, hats, of_joint, resolution, rungs
from deltacal_gen.motion.regression import BETWEEN, Bench, folds_of, together
from deltacal_gen.motion.sizes import settled
from deltacal_gen.motion.trajectories import Readout, Trajectories
from deltacal_gen.physics.splines import Samples, smooth
from deltacal_gen.units import of_joints

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

AT_REST = 0.01  # of a joint's highest speeds: below it friction is not known; of another joint's: it stands
NOISY_SPEED = 5.0  # standard deviations of a velocity: nor is its sign
USUAL = ("coulomb_friction", "viscous_friction", "torque_offset")  # what every drive has, to begin with
HIGHEST = 0.99  # quantile of speeds that is meant by highest
TURNED = 30.0  # of chi2: what friction that drives a joint must earn, so that its reading counts as turned round
FEW = 100  # samples: a joint with fewer in motion is not looked at
TRIED = 5  # sizes that are tried around the one found, before it is fitted
REFINED = (1.6, 1.12)  # factors either way: half of what lies between two sizes that are searched, then between these
ALIKE = 10.0  # of chi2: effects whose fits differ by less are not told apart
SETTLES = 2  # fits after which a load no longer changes by what readings tell
SMOOTH = 12  # hats of a smooth function of position, which waves must beat


@dataclass(frozen=True, eq=False)
class Joint:
    """Samples of one joint in motion.

    Attributes
    ----------
    series : Series
        Of all samples.
    delay : float
        Readings belong to joints so much earlier [s].
    number : int
        From 1.
    readout : Readout
    threshold : float
        Speed below which a sample is at rest [rad/s or mm/s].
    used : (N,) array of bool
        Samples in motion that hold a reading.
    resting : int
        Samples with a reading that were set aside as at rest.
    fold, held : (M,) arrays of int
        Of the samples used: in which they are fitted, and with which they are held out; see `folds_of`.
    rows : (M,) array of int
        Which samples these are.
    X, y : (M, r), (M,) arrays
        What each base parameter asks of the joint, and what it gave beyond what is known, in units inside.
    carried : (M,) array
        What is known beforehand: of the payload, of bodies that the robot file states.
    states : dict of (M,) arrays
        What effects read.
    piece : (N,) array of int
        Of all samples.
    step : float
        Between samples [s].
    """

    series: Series
    delay: float
    robot: Robot
    number: int
    readout: Readout
    threshold: float
    used: np.ndarray
    resting: int
    fold: np.ndarray
    held: np.ndarray
    rows: np.ndarray
    X: Array
    y: Array
    carried: Array
    states: dict[str, Array]
    piece: np.ndarray
    step: float

    @property
    def unit(self) -> str:
        """Of its readings in files."""
        return self.readout.unit

    @property
    def moves(self) -> bool:
        """Whether there are samples enough, in two folds at least."""
        return len(self.y) >= FEW and len(np.unique(self.fold[self.fold != BETWEEN])) > 1

    @property
    def silent(self) -> bool:
        """Whether its reading never changes: no drive that moves a joint gives that."""
        return len(self.rows) > 0 and float(np.ptp(self.series.y[self.rows])) == 0.0

    @cached_property
    def sense(self) -> float:
        """-1 where dry and viscous friction would drive the joint: its reading is counted against its angle; else 1."""
        some = [Rung(name) for name in USUAL]
        X, rigid = self.columns(some, self.carried), self.X.shape[1]
        bench = Bench.of(X, self.y, self.fold, rigid)
        every, own = range(X.shape[1]), slice(rigid, rigid + 2)
        bench = bench.with_ridge(every)
        found = bench.fit(every, range(len(bench.n))) / bench.scale
        if (X[:, own] @ found[own]) @ self.states["qd"] >= 0:
            return 1.0
        before, after = (bench.train(c, bench.folds) for c in ([*range(rigid), every[-1]], every))
        count = len(self.y) / self.correlated(self.y - X @ found)
        return -1.0 if count * float(np.log(before / max(after, 1e-300))) > TURNED else 1.0

    @cached_property
    def candidates(self) -> tuple[Rung, ...]:
        """All effects that these samples can tell, with the constants to be looked at."""
        every = np.ones(len(self.y), dtype=bool)
        return tuple(rungs(self.robot, self.states | {"torque": self.y + self.carried}, every))

    def columns(self, some: Sequence[Rung], load: Array) -> Array:
        """Return the columns (M, r + c) of the rigid machine and of some effects, by the load (M,) on the joint."""
        states = self.states | {"torque": load}
        return np.hstack([self.X, *(self.of_rung(rung, states) for rung in some)])

    def of_rung(self, rung: Rung, states: dict[str, Array]) -> Array:
        """Return the columns (M, c) of one effect at states of the joint, with what it remembers."""
        return rung.columns(states | self.remembered(rung))

    def remembered(self, rung: Rung) -> dict[str, Array]:
        """Return what an effect remembers at the samples used, by name (M,)."""
        late = functools.partial(earlier, delay=self.delay, time=self.series.time, piece=self.series.piece)
        return {name: late(values)[self.rows] for name, values in self.series.remembered(rung).items()}

    def load_by(self, folds: Sequence[int] | None) -> Array:
        """Return what the rigid machine asks of the joint (M,), by a fit beside usual friction to some folds or all."""
        some = [Rung(name) for name in USUAL]
        X = self.columns(some, self.carried)
        bench = Bench.of(X, self.y, self.fold, self.X.shape[1])
        every = range(X.shape[1])
        bench = bench.with_ridge(every)
        found = bench.fit(every, range(len(bench.n)) if folds is None else folds) / bench.scale
        rigid = self.X.shape[1]
        return np.asarray(X[:, :rigid] @ found[:rigid] + self.carried)

    def correlated(self, left: Array) -> float:
        """Return how many samples count as one, by residuals (M,)."""
        whole = np.zeros(len(self.piece))
        whole[self.rows] = left
        return together(whole, self.piece, self.used, self.step)

    def filtered(self, left: Array, time: Array, cutoff: float | None) -> Array:
        """Return residuals (M,) through the low-pass of the joints, readings and model alike; nan near rest."""
        if cutoff is None:
            return left
        whole = np.full((len(self.piece), 1), np.nan)
        whole[self.rows, 0] = left
        there = np.isfinite(whole[:, 0])
        parts = np.cumsum(np.diff(self.piece, prepend=0) + np.diff(there.astype(int), prepend=0) != 0)
        out = np.full(len(whole), np.nan)
        out[there] = smooth(Samples(whole[there], time[there], parts[there]), 0.5 / cutoff, 0)[0, :, 0]
        return np.asarray(out[self.rows])


@dataclass(frozen=True, eq=False)
class Series:
    """All samples of one joint, of which those in motion make a `Joint`.

    Attributes
    ----------
    X, y : (N, r), (N,) arrays
        What each unknown of the rigid machine asks of the joint, and what it gave, in units inside.
    carried : (N,) array
        What of it is known beforehand: of the payload, of bodies that the robot file states.
    states : dict of (N,) arrays
        What effects read.
    known : (N,) array of bool
        Samples whose derivatives are known.
    memories : dict
        What effects remember, as far as it was asked for.
    """

    robot: Robot
    number: int
    readout: Readout
    threshold: float
    X: Array
    y: Array
    carried: Array
    states: dict[str, Array]
    known: np.ndarray
    time: Array
    run: np.ndarray
    piece: np.ndarray
    step: float
    memories: dict[Rung, dict[str, Array]] = field(default_factory=dict, repr=False)

    def remembered(self, rung: Rung) -> dict[str, Array]:
        """Return what an effect remembers at all samples, by name (N,)."""
        if rung not in self.memories:
            self.memories[rung] = rung.remembered(self.states, self.time, self.piece)
        return self.memories[rung]

    def at(self, delay: float = 0.0) -> Joint:
        """Return the samples in motion, readings belonging to joints `delay` [s] earlier."""
        late = functools.partial(earlier, delay=delay, time=self.time, piece=self.piece)
        X, states = late(self.X), {name: late(values) for name, values in self.states.items()}
        y = self.y - late(self.carried)
        there = self.known & np.isfinite(y)
        used = there & (np.abs(states["qd"]) > self.threshold)
        rows = np.flatnonzero(used)
        fold, held = folds_of(self.time, self.run, used)
        return Joint(
            series=self,
            delay=delay,
            robot=self.robot,
            number=self.number,
            readout=self.readout,
            threshold=self.threshold,
            used=used,
            resting=int((there & ~used).sum()),
            fold=fold[rows],
            held=held[rows],
            rows=rows,
            X=X[rows],
            y=y[rows],
            carried=late(self.carried)[rows],
            states={name: values[rows] for name, values in states.items()},
            piece=self.piece,
            step=self.step,
        )


def earlier(values: Array, delay: float, time: Array, piece: np.ndarray) -> Array:
    """Return values (N, ...) as they were `delay` [s] before each sample, straight between samples of one movement."""
    if not delay:
        return values
    starts = np.flatnonzero(np.diff(piece, prepend=-1))
    out = np.empty_like(values)
    for own in np.split(np.arange(len(piece)), starts[1:]):
        if len(own) < 2:
            out[own] = values[own]
            continue
        when = np.clip(time[own] - delay, time[own[0]], time[own[-1]])
        at = np.clip(np.searchsorted(time[own], when), 1, len(own) - 1)
        part = (when - time[own[at - 1]]) / (time[own[at]] - time[own[at - 1]])
        part = part.reshape(-1, *[1] * (values.ndim - 1))
        out[own] = (1 - part) * values[own[at - 1]] + part * values[own[at]]
    return out


def series_of(
    robot: Robot, given: Trajectories, motion: Motion, columns: Sequence[Array], payload: Array, known: Array
) -> list[Series]:
    """Return every joint of a recording.

    Parameters
    ----------
    columns : sequence of (N, r) arrays
        What base parameters ask of each joint.
    payload : (N, n_q) array
        What 1 kg at the tool point asks of it.
    known : (N, n_q) array
        What is known beside, of bodies that the robot file states; only where a torque or a force is read.
    """
    found = []
    there = np.isfinite(motion.states).all(axis=(0, 2)) & ~motion.loose
    states = np.nan_to_num(motion.states)
    for j, X in enumerate(columns):
        readout = given.readouts[j]
        y = given.readings[:, j] * readout.inside
        carried = payload[:, j] * given.payload
        if carried.any() and not readout.forces:  # unknown per torque, for a payload as for the machine
            X = np.column_stack([X, carried])
        found.append(
            Series(
                robot=robot,
                number=j + 1,
                readout=readout,
                threshold=resting_below(motion, j, of_joints(given.joint_unit, len(columns))),
                X=X,
                y=y,
                carried=carried + known[:, j] if readout.forces else np.zeros(len(y)),
                states=of_joint(given, states, j),
                known=there,
                time=given.time,
                run=given.run,
                piece=given.piece,
                step=given.step,
            )
        )
    return found


def resting_below(motion: Motion, joint: int, units: Sequence[str]) -> float:
    """Return the speed [rad/s or mm/s] below which a joint (from 0) counts as at rest.

    A joint that hardly moves beside another of its unit is shaken by it: its friction holds, and has no known sign.
    """
    speeds = np.abs(motion.states[1])
    if not np.isfinite(speeds[:, joint]).any():
        return NOISY_SPEED * float(motion.noise[0, joint])
    usual = np.sqrt(np.nanmean(speeds**2, axis=0))
    most = max(speed for speed, unit in zip(usual, units, strict=True) if unit == units[joint])
    if usual[joint] < AT_REST * most:
        return float(np.nanmax(speeds[:, joint]))
    highest = float(np.nanquantile(speeds[:, joint], HIGHEST))
    return max(AT_REST * highest, NOISY_SPEED * float(motion.noise[0, joint]))


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
        Of chi2, likewise.
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
            states = self.joint.states | {"torque": self.load} | self.joint.remembered(rung)
            columns = rung.columns({name: values[picked] for name, values in states.items()} | moved)
            total += columns @ self.coefficients[at : at + rung.width]
            at += rung.width
        return total

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
    bench = Bench.of(np.hstack([X, by_size]), joint.y, joint.fold, joint.X.shape[1])
    every, each = range(X.shape[1]), range(X.shape[1] + by_size.shape[1])
    bench = bench.with_ridge(every)
    found = bench.fit(every, range(len(bench.n))) / bench.scale[every]
    left = joint.y - X @ found
    count = joint.correlated(left)
    free = max(1.0, len(left) / count - len(each))
    variance = float(left @ left) / count / free
    covariance = bench.covariance(each) * variance * count / np.outer(bench.scale, bench.scale)
    std = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    if held_out is None:
        held_out = np.full(len(left), np.nan)
        for fold in bench.folds:
            own = joint.held == fold
            apart = bench.fit(every, [f for f in bench.folds if f != fold]) / bench.scale[every]
            held_out[own] = joint.y[own] - X[own] @ apart
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
    for _ in range(SETTLES if any("torque" in rung.kernels.STATE for rung in some) else 0):
        bench, every = Bench.of(X, joint.y, joint.fold, rigid), range(X.shape[1])
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
    bench = Bench.of(X, joint.y, joint.fold, rigid)
    rival = tuple(range(width, X.shape[1]))
    resolved = resolution(joint.states)
    ladder = Ladder(bench, candidates, at, X, joint.y, joint.correlated, rival, resolved, sense=joint.sense)
    held_out = np.full(len(joint.y), np.nan)
    for fold in bench.folds:
        others, own = [f for f in bench.folds if f != fold], joint.held == fold
        held_out[own] = _apart(joint, ladder, others, own)
    plain = fitted(joint, []).held_out
    if _size(held_out) > (1.0 - BUYS) * _size(plain):  # what others choose does not foretell a fold: nothing is told
        chosen, held_out = list[int](), plain
    else:
        ladder, chosen = _climbed_by(joint, ladder, load, bench.folds)
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
        gains=tuple(ladder.gain(chosen, k, bench.folds) for k in chosen),
        alike=tuple(_alike(ladder, chosen, k) for k in chosen),
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
    moved = {k: rung for k, rung in found if rung.continuous or "torque" in rung.kernels.STATE}
    return fit, _with_rungs(joint, ladder, moved, fit.load)


def _apart(joint: Joint, ladder: Ladder, others: Sequence[int], own: np.ndarray) -> Array:
    """Return residuals of some samples `own` by a choice and a fit of other folds alone."""
    load = joint.load_by(others)
    by_load = {k: rung for k, rung in enumerate(ladder.rungs) if "torque" in rung.kernels.STATE}
    ladder, chosen = _climbed_by(joint, _with_rungs(joint, ladder, by_load, load), load, others)
    _, columns = _by_own_load(joint, [ladder.rungs[k] for k in chosen], load, others)
    apart, every = Bench.of(columns, joint.y, joint.fold, joint.X.shape[1]), range(columns.shape[1])
    found = apart.with_ridge(every, others).fit(every, others) / apart.scale
    return np.asarray(joint.y[own] - columns[own] @ found)


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
    states, every, X = joint.states | {"torque": load}, list(ladder.rungs), ladder.X.copy(order="K")
    for k, rung in rungs.items():
        every[k] = rung
        X[:, ladder.at[k]] = joint.of_rung(rung, states)
    changed = [c for k in rungs for c in ladder.at[k]]
    bench = ladder.bench.with_columns(changed, X, joint.y, joint.fold) if changed else ladder.bench
    return dataclasses.replace(ladder, bench=bench, X=X, rungs=tuple(every), counted={})


def _alike(ladder: Ladder, chosen: Sequence[int], rung: int) -> tuple[str, ...]:
    """Return the effects that would do as well in place of one: a difference in chi2 below 10."""
    others, bench = [k for k in chosen if k != rung], ladder.bench
    count = float(bench.n[list(bench.folds)].sum()) / ladder.together(others)
    now = bench.train(ladder.columns(chosen), bench.folds)
    own = ladder.rungs[rung].effect
    rivals = [k for k in ladder.open(chosen) if ladder.rungs[k].effect != own]
    without = ladder.columns(others)
    after = bench.train(without, bench.folds) - bench.gains(without, [ladder.at[k] for k in rivals], bench.folds)
    near = count * np.log(np.maximum(after, 1e-300) / now) < ALIKE
    return tuple(dict.fromkeys(ladder.rungs[k].effect for k, alike in zip(rivals, near, strict=True) if alike))


def _refined(joint: Joint, beside: Sequence[Rung], rung: Rung, wide: float, load: Array, folds: Sequence[int]) -> Rung:
    """Return an effect with the size, up to a factor `wide` from its own, that leaves least of some folds."""
    tried = [Rung(rung.effect, (rung.constants[0] * f,)) for f in np.geomspace(1 / wide, wide, TRIED)]
    X = joint.columns([*beside, *tried], load)
    bench = Bench.of(X, joint.y, joint.fold, joint.X.shape[1])
    first = X.shape[1] - sum(t.width for t in tried)
    errors = [bench.train([*range(first), first + n], folds) for n in range(len(tried))]
    return tried[int(np.argmin(errors))]
