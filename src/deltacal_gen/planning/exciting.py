"""Exciting trajectories: movements along which a torque tells the most of a machine's masses and friction.

Every joint follows a finite Fourier series, which starts and ends at rest and whose derivatives are exact. A series is
as large as the limits of position, speed and acceleration let it be, then all joints together as large as the workspace
does: at every moment, not at samples alone. Of many series the one of the best condition number is taken, and then
improved for the determinant of the information (D-optimality) as long as the condition number does not grow. Each
further run adds to what those before it tell, and can be held out.

References
----------
Swevers, J., Ganseman, C., Tukel, D. B., De Schutter, J., Van Brussel, H.: Optimal robot excitation and identification.
IEEE Transactions on Robotics and Automation 13(5), 1997, 730-740.
Ehlich, H., Zeller, K.: Schwankung von Polynomen zwischen Gitterpunkten. Mathematische Zeitschrift 86, 1964, 41-44.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import NoPlan, ValueOutOfRange
from deltacal_gen.files.columns import Columns
from deltacal_gen.files.toml import toml_text
from deltacal_gen.files.writing import csv_text, write_files
from deltacal_gen.identification.identifiability import Observability, observability
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import Array, Machine, mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.limits import PATTERNS, home_of, limits_of
from deltacal_gen.motion.rigid import Rigid
from deltacal_gen.planning.matrix import finite, indices_of
from deltacal_gen.results.plan import JointSeries, MotionPlan
from deltacal_gen.results.reader import TORQUE
from deltacal_gen.states import TIME
from deltacal_gen.units import file_unit, joint_factors, joint_names, to_internal

STARTS, STEPS = 60, 240  # series that are drawn, and changes that are tried of the best
CHANGE = 0.5  # of a coefficient, at first; at last a tenth of it
LOOKED_AT, PER_WAVE = 25.0, 40  # samples per second, and of the fastest wave at least, by which a series is judged
BULGES = 0.16  # of second differences: how far a way leaves its chords (1/8, and a quarter more as they are averages)
TRIED, ASIDE = 4000, 0.25  # joints that are drawn for a beginning; part of their travel that it keeps from the ends
HALVINGS = 14  # of the size, until all of it lies in the workspace


@dataclass(frozen=True, eq=False)
class Series:
    """A periodic movement of all joints, as the controller counts.

    Attributes
    ----------
    centre : (n_q,) array
        Where it begins and ends [rad or mm].
    cosine, sine : (H, n_q) arrays
        Amplitudes of the velocity at multiples of 1 / period [rad/s or mm/s].
    period : float
        s
    """

    centre: Array
    cosine: Array
    sine: Array
    period: float

    def states(self, time: Array) -> Array:
        """Return joints, velocities, accelerations (3, N, n_q)."""
        w = 2 * math.pi / self.period * np.arange(1, len(self.cosine) + 1)
        c, s = np.cos(np.outer(time, w)), np.sin(np.outer(time, w))
        q = self.centre + (s / w) @ self.cosine + ((1 - c) / w) @ self.sine
        return np.stack([q, c @ self.cosine + s @ self.sine, (-s * w) @ self.cosine + (c * w) @ self.sine])

    def slower(self, factor: float) -> Series:
        """Return the same way so many times as slowly."""
        return dataclasses.replace(
            self, cosine=self.cosine / factor, sine=self.sine / factor, period=self.period * factor
        )

    def times(self, factor: Array | float) -> Series:
        """Return the movement so many times as large, joint by joint."""
        return dataclasses.replace(self, cosine=self.cosine * factor, sine=self.sine * factor)


class Excitation:
    """Series of one robot within its limits, and what they tell; see `plan_trajectories`."""

    def __init__(self, robot: Robot, period: float, harmonics: int, seed: int) -> None:
        self._robot, self._mechanism, self.rigid = robot, mechanism_of(robot), Rigid(robot)
        self._rng, self._period, self._harmonics = np.random.default_rng(seed), period, harmonics
        count = max(round(period * LOOKED_AT), PER_WAVE * harmonics)
        self._time = np.arange(count) * period / count
        self._between = math.cos(math.pi * harmonics / count)  # a series is no larger than at samples by this (Ehlich)
        (self.low, self.high, self.speed, self.acceleration), self.notes = limits_of(robot)
        self._rows = self._mechanism.rows(robot)
        self._centre = self._middle()
        Y = self._asked(self.drawn().states(self._time))
        self._weights = [1 / (np.abs(y).max() or 1.0) for y in Y]

    @property
    def names(self) -> tuple[str, ...]:
        """What is to be told: base parameters, then usual friction joint by joint."""
        joints = range(1, len(self.low) + 1)
        own = [self.rigid.names[k] for k in self.rigid.common.chosen]
        return (*own, *(f"{name}_{j}" for j in joints for name in ("coulomb", "viscous")))

    def _middle(self) -> Array:
        """Return where series begin: the middle of the workspace, or of the limits; of a chain, where both hold."""
        space, middle = self._robot.workspace, (self.low + self.high) / 2
        if not self._mechanism.many_ways and space is not None:
            return home_of(self._robot)
        if space is None or space.holds(self._positions(middle[None])).all():
            return middle
        # the workspace may lie where only some of the joints' travel leads: as near to its middle as they come
        room = (self.high - self.low) / 2 * (1 - ASIDE)
        q = middle + room * self._rng.uniform(-1.0, 1.0, (TRIED, len(middle)))
        inside = np.flatnonzero(space.holds(x := self._positions(q)))
        if not len(inside):
            raise NoPlan(
                "no joints within their limits bring the reference point into the workspace: compare [workspace] with "
                "limits_deg."
            )
        return q[inside[np.argmin(np.linalg.norm(x[inside] - space.home, axis=1))]]

    def drawn(self) -> Series:
        """Return a series at random, as large as limits let it be."""
        shape = (2, self._harmonics, len(self.low))
        cosine, sine = self._rng.standard_normal(shape) * self._rng.uniform(0.3, 1.0, shape[2])
        return self.fitted(Series(self._centre, cosine, sine, self._period))

    def changed(self, of: Series, much: float) -> Series:
        """Return another series near one."""
        size = np.sqrt(np.mean(of.cosine**2 + of.sine**2, axis=0) / 2)
        by = much * size * self._rng.standard_normal((2, *of.cosine.shape))
        return self.fitted(dataclasses.replace(of, cosine=of.cosine + by[0], sine=of.sine + by[1]))

    def fitted(self, series: Series) -> Series:
        """Return a series that begins at rest, and is as large as limits and workspace let it be."""
        k = np.arange(1, self._harmonics + 1)[:, None]
        series = dataclasses.replace(
            series,
            cosine=series.cosine - series.cosine.mean(axis=0),
            sine=series.sine - k * (k * series.sine).sum(axis=0) / (k**2).sum(),
        )
        q, qd, qdd = series.states(self._time)
        middle, half = (q.max(axis=0) + q.min(axis=0)) / 2 - self._centre, np.ptp(q, axis=0) / 2 / self._between
        way = np.maximum([middle + half, half - middle], 1e-12)
        room = [(self.high - self._centre) / way[0], (self._centre - self.low) / way[1]]
        most = self._between / np.abs([qd, qdd]).max(axis=1)
        room += [self.speed * most[0], self.acceleration * most[1]]
        series = series.times(np.min(room, axis=0))
        low, high = 0.0, 1.0
        if self._stays(series):
            return series
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if self._stays(series.times(middle)) else (low, middle)
        if low == 0.0:
            raise NoPlan("no trajectory from where it begins stays in the workspace.")
        return series.times(low)

    def _stays(self, series: Series) -> bool:
        """Tell whether the reference point stays in the workspace, and the machine in one piece."""
        x = self._positions(series.states(self._time)[0])
        if (space := self._robot.workspace) is None or not np.isfinite(x).all():
            return bool(np.isfinite(x).all())
        bends = np.linalg.norm(np.roll(x, 1, axis=0) - 2 * x + np.roll(x, -1, axis=0), axis=1)
        return bool(space.holds(x, BULGES * float(bends.max())).all())

    def _positions(self, joints: Array) -> Array:
        """Return where the reference point is (N, 3) at joints as the controller counts; NaN where it cannot be."""
        return self._mechanism.positions(self._robot.joint_sign * joints, self._robot.tool[None], self._rows)

    def _asked(self, states: Array) -> list[Array]:
        return self.rigid.columns(states, [self.rigid.common.chosen] * len(self.low))

    def columns(self, series: Series) -> Array:
        """Return what a unit of each of `names` asks of the joints, joint by joint, each joint by its own size."""
        states = series.states(self._time)
        qd, n, rows = states[1], len(self.low), []
        for j, (Y, weight) in enumerate(zip(self._asked(states), self._weights, strict=True)):
            friction = np.zeros((len(qd), 2 * n))
            friction[:, 2 * j], friction[:, 2 * j + 1] = np.sign(qd[:, j]), qd[:, j] / self.speed[j]
            rows.append(np.hstack([Y * weight, friction]))
        return np.concatenate(rows)

    def judge(self, information: Array) -> tuple[float, float]:
        """Return condition number, columns of one size, and logarithm of the determinant, of an information matrix."""
        size = np.sqrt(np.diag(information))
        if not (size > 0).all():
            return math.inf, -math.inf
        values = np.linalg.eigvalsh(information / np.outer(size, size))
        if values[0] <= 0:
            return math.inf, -math.inf
        return math.sqrt(values[-1] / values[0]), float(np.linalg.slogdet(information)[1])

    def best(self, known: Array) -> Series:
        """Return the series that adds most to what is known (n, n)."""

        def judged(series: Series) -> tuple[float, float]:
            W = self.columns(series)
            return self.judge(known + W.T @ W)

        found = min((self.drawn() for _ in range(STARTS)), key=lambda series: judged(series)[0])
        condition, determinant = judged(found)
        for step in range(STEPS):
            other = self.changed(found, CHANGE * 0.1 ** (step / STEPS))
            now = judged(other)
            if now[0] <= condition and now[1] > determinant:
                found, (condition, determinant) = other, now
        return found


def _in_files(chosen: Sequence[Series], mechanism: Machine) -> tuple[JointSeries, ...]:
    """Return series, joint by joint, in the units of files."""
    units = mechanism.joint_units
    factors = [to_internal(unit) for unit in units]
    return tuple(
        JointSeries(
            run=k + 1,
            joint=j + 1,
            unit=file_unit(units[j]),
            centre=float(s.centre[j] / factors[j]),
            cosine=tuple((s.cosine[:, j] / factors[j]).tolist()),
            sine=tuple((s.sine[:, j] / factors[j]).tolist()),
        )
        for k, s in enumerate(chosen)
        for j in range(len(factors))
    )


def plan_trajectories(
    robot: Robot, *, runs: int = 3, period: float = 10.0, harmonics: int = 5, rate: float = 100.0, seed: int = 0
) -> tuple[MotionPlan, tuple[Series, ...]]:
    """Return exciting trajectories of a robot, and what they tell.

    Parameters
    ----------
    runs : int
        Movements, one after the other, each a run of the recording.
    period : float
        Of each [s].
    harmonics : int
        Of its series.
    rate : float
        Samples per second in the file [Hz].
    seed : int
        Of the series that are drawn.

    Raises
    ------
    UsageError
        A number is out of range, or the dynamics of the mechanism are not derived.
    NoSolutionError
        No trajectory stays in the workspace.
    """
    if runs < 1 or harmonics < 2 or not period > 0 or not rate >= 4 * harmonics / period:
        raise ValueOutOfRange(
            f"{runs} runs of {period:g} s with {harmonics} harmonics at {rate:g} Hz cannot be planned. "
            "Give at least one run, two harmonics (a start at rest needs them) and four samples per wave."
        )
    search = Excitation(robot, period, harmonics, seed)
    names = search.names
    known = np.zeros((len(names), len(names)))
    chosen: list[Series] = []
    blocks: list[Array] = []
    found: list[Observability] = []
    for _ in range(runs):
        with using(Backend.COMPILED):  # thousands of calls, which few poses alone would not be worth
            chosen.append(search.best(known))
        blocks.append(search.columns(chosen[-1]))
        known = known + blocks[-1].T @ blocks[-1]
        W = np.concatenate(blocks)
        found.append(observability(W / np.linalg.norm(W, axis=0), len(W)))
    answer = MotionPlan(
        robot=robot.name,
        mechanism=robot.mechanism,
        model=f"{robot.mechanism}/rigid",
        kind=TORQUE,
        method="fourier",
        parameters=names,
        runs=runs,
        period_s=period,
        harmonics=harmonics,
        rate_Hz=rate,
        n=tuple(range(1, runs + 1)),
        readings=tuple(k * len(blocks[0]) for k in range(1, runs + 1)),
        condition=tuple(finite(step.condition) for step in found),
        log_determinant=search.judge(known)[1],
        **indices_of([step.indices for step in found]),
        chosen=runs,
        series=_in_files(chosen, search._mechanism),
        notes=tuple(search.notes),
    )
    return answer, tuple(chosen)


def columns_of(
    robot: Robot,
    series: Sequence[Series],
    rate: float,
    names: Sequence[object] = (),
    channels: Mapping[str, Sequence[float]] | None = None,
) -> Columns:
    """Return the columns of a trajectory's file: runs, times, joints, velocities, accelerations.

    Parameters
    ----------
    names : sequence, optional
        Of the runs; counted from 1 by default.
    channels : mapping, optional
        Further columns, with the value of each run.
    """
    machine = mechanism_of(robot)
    unit, limbs = machine.joint_unit, machine.limbs
    times = [np.arange(0, round(s.period * rate) + 1) / rate for s in series]
    states = np.concatenate([s.states(time) for s, time in zip(series, times, strict=True)], axis=1)

    def each(values: Sequence[Any]) -> list[Any]:
        return [value for value, time in zip(values, times, strict=True) for _ in time]

    found: Columns = {"run": each(names or range(1, len(series) + 1))}
    found[TIME] = np.concatenate(times)
    for values, pattern in zip(states, PATTERNS, strict=True):
        found |= dict(zip(joint_names(unit, limbs, pattern), (values / joint_factors(unit, limbs)).T, strict=True))
    return found | {name: each(values) for name, values in (channels or {}).items()}


def write_trajectory(robot: Robot, series: Sequence[Series], rate: float, path: str | Path, **further: Any) -> None:
    """Write trajectories as a CSV that `simulate` takes, with its sidecar; `further` of `columns_of`."""
    sidecar = toml_text({"measurement": {"kind": TORQUE}})
    columns = columns_of(robot, series, rate, **further)
    write_files({Path(path): csv_text(columns), Path(path).with_suffix(".toml"): sidecar})
