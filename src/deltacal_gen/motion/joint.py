"""One joint of a recording in motion: its samples and its candidates."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.library import LOAD, Rung, of_joint, rungs
from deltacal_gen.motion.regression import BETWEEN, Bench, folds_of, together
from deltacal_gen.motion.rigid import Asked
from deltacal_gen.motion.trajectories import Motion, Readout, Trajectories
from deltacal_gen.physics.splines import HIGHEST, Samples, smooth
from deltacal_gen.units import of_joints

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

AT_REST = 0.01  # of a joint's highest speeds: below it friction is not known; of another joint's: it stands
NOISY_SPEED = 5.0  # standard deviations of a velocity: nor is its sign
DRY, VISCOUS, OFFSET = USUAL = "coulomb_friction", "viscous_friction", "torque_offset"  # what every drive begins with
TURNED = 30.0  # of chi2: what friction that drives a joint must earn, so that its reading counts as turned round
SAME_TIME = 1e-9  # s
FEW = 100  # samples: a joint with fewer in motion is not looked at


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
    usual : (r,) array
        Size (rms) of these columns where all joints move as the liveliest one did; see `Rigid.as_lively`.
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
    usual: Array
    carried: Array
    states: dict[str, Array]
    piece: np.ndarray
    step: float

    def bench(self, columns: Array, fold: np.ndarray | None = None) -> Bench:
        """Return the normal equations of columns (M, r + c), the rigid machine's first, by its folds (M,) or others."""
        return Bench.of(columns, self.y, self.fold if fold is None else fold, self.usual, self.given**2)

    @property
    def given(self) -> float:
        """What its drive gave (rms), in units inside."""
        return float(np.sqrt(np.mean((self.y + self.carried) ** 2)))

    @property
    def unit(self) -> str:
        """Of its readings in files."""
        return self.readout.unit

    @property
    def moves(self) -> bool:
        """Whether there are samples enough, in two folds at least."""
        return len(self.y) >= FEW and len(np.unique(self.fold[self.fold != BETWEEN])) > 1

    @property
    def unread(self) -> bool:
        """Whether its cells are blank, or all but some."""
        return int(np.isfinite(self.series.y).sum()) < FEW

    @property
    def silent(self) -> bool:
        """Whether its reading never changes: no drive that moves a joint gives that."""
        return len(self.rows) > 0 and float(np.ptp(self.series.y[self.rows])) == 0.0

    @cached_property
    def sense(self) -> float:
        """-1 where dry and viscous friction would drive the joint: its reading is counted against its angle; else 1."""
        some = [Rung(name) for name in USUAL]
        X, rigid = self.columns(some, self.carried), self.X.shape[1]
        bench = self.bench(X)
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
        return tuple(rungs(self.robot, self.states | {LOAD: self.y + self.carried}, every))

    def columns(self, some: Sequence[Rung], load: Array) -> Array:
        """Return the columns (M, r + c) of the rigid machine and of some effects, by the load (M,) on the joint."""
        states = self.states | {LOAD: load}
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
        bench = self.bench(X)
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
    usual : (r,) array
        Size (rms) of these columns where all joints move as the liveliest one did; see `Rigid.as_lively`.
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
    usual: Array
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
        then = late(
            np.column_stack([self.time, self.known])
        )  # of what the joints did before a movement nothing is known
        there = self.known & np.isfinite(y) & (then[:, 1] == 1.0) & (np.abs(self.time - delay - then[:, 0]) < SAME_TIME)
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
            usual=self.usual,
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
    robot: Robot, given: Trajectories, motion: Motion, asked: Asked, usual: Asked, known: Array
) -> list[Series]:
    """Return every joint of a recording.

    Parameters
    ----------
    asked : Asked
        What base parameters and a payload ask of each joint, at all samples.
    usual : Asked
        The same in general position, all joints as quick as the quickest was; see `Rigid.as_lively`.
    known : (N, n_q) array
        What is known beside, of bodies that the robot file states; only where a torque or a force is read.
    """
    found = []
    there = np.isfinite(motion.states).all(axis=(0, 2)) & ~motion.loose
    states = np.nan_to_num(motion.states)
    for j, (X, general) in enumerate(zip(asked.columns, usual.columns, strict=True)):
        readout = given.readouts[j]
        y = given.readings[:, j] * readout.inside
        carried = asked.payload[:, j] * given.payload
        if carried.any() and not readout.forces:  # unknown per torque, for a payload as for the machine
            X = np.column_stack([X, carried])
            general = np.column_stack([general, usual.payload[:, j] * given.payload.max()])
        found.append(
            Series(
                robot=robot,
                number=j + 1,
                readout=readout,
                threshold=resting_below(motion, j, of_joints(given.joint_unit, len(asked.columns))),
                X=X,
                y=y,
                usual=np.sqrt(np.mean(general**2, axis=0)),
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
