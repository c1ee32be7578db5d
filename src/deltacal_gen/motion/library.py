"""What drives have beside the rigid machine: effects on the torque as columns of a regression, joint by joint."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.trajectories import Trajectories, temperature
from deltacal_gen.physics.memory import along
from deltacal_gen.physics.terms import Kernels, drive_effect_names, load_effect, remembers
from deltacal_gen.states import CHANNELS, TEMPERATURE, read_by
from deltacal_gen.units import DEG

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

MOST_ORDER = 100  # periods per turn that are searched one by one
PERIODS = 2.0  # that a joint must pass, so that a wave can be told from a slope
PER_PERIOD = 4.0  # samples of a period at the joint's usual speed, at least
VELOCITIES = 20  # sizes of a state that are looked at
SMALLEST = 0.01  # of a state's usual size: the smallest of them
LARGEST = 0.4
VARIES = 0.5  # K: temperatures that differ by less tell nothing
TRAVELS = 2.5  # factor between ways of a joint that are looked at
SAMPLES = 2.0  # of a joint at its usual speed: the shortest way that its samples tell
LOAD = "torque"  # the state that is what the rigid machine asks of a joint: it comes with a fit, not with the motion
ASTRAY = 1e-2  # of what is remembered, from sample to sample: below what readings tell of one


@dataclass(frozen=True)
class Rung:
    """An effect on the torque of one joint, with what is searched of it.

    Attributes
    ----------
    effect : str
    constants : tuple of float
        In units inside.
    """

    effect: str
    constants: tuple[float, ...] = ()

    @property
    def kernels(self) -> Kernels:
        """The effect's generated module."""
        return load_effect(self.effect)

    @property
    def width(self) -> int:
        """Number of its coefficients."""
        return len(self.kernels.COEFFICIENTS)

    @property
    def of_load(self) -> bool:
        """Whether it reads what the rigid machine asks of the joint."""
        return LOAD in self.kernels.STATE

    @property
    def continuous(self) -> bool:
        """Whether its constant is a size, which may be any."""
        return bool({"sizes", "travels"} & set(self.kernels.SEARCHED))

    def columns(self, states: dict[str, Array]) -> Array:
        """Return the derivatives (N, c) of a joint's torque by the coefficients, at states by name (N,).

        What the effect remembers is among the states; see `remembered`.
        """
        n = len(next(iter(states.values())))
        memories = [name for name, _ in self.kernels.MEMORY] if remembers(self.kernels) else []
        s = np.column_stack([states[name] for name in (*self.kernels.STATE, *memories)] or [np.empty((n, 0))])
        found = self.kernels.jacobian(s, np.zeros((1, self.width)), self.constants)
        return np.asarray(found[:, 0])

    def remembered(self, states: dict[str, Array], time: Array, piece: np.ndarray) -> dict[str, Array]:
        """Return what the effect remembers at every sample, by name (N,); nothing of one without a memory.

        Parameters
        ----------
        states : dict of (N,) arrays
            At all samples of a joint.
        time, piece : (N,) arrays
            Of the samples [s], and which are one movement.
        """
        if not remembers(self.kernels):
            return {}
        s = np.column_stack([states[name] for name in self.kernels.STATE])[:, None]
        c = np.ones((len(s), 1, self.width))  # a rate that reads coefficients would not be linear in them
        found = along(self.kernels, s, c, self.constants, time, piece, tolerance=ASTRAY).value[:, 0]
        return {name: values for (name, _), values in zip(self.kernels.MEMORY, found.T, strict=True)}


def of_joint(given: Trajectories, motion: Array, joint: int, load: Array | None = None) -> dict[str, Array]:
    """Return what effects on the torque of a joint (from 0) read, by name of the state, (N,).

    Parameters
    ----------
    motion : (3, N, n_q) array
        As the controller counts.
    load : (N,) array, optional
        What the rigid machine asks of the joint; where it is not given nothing that reads it can be looked at.
    """
    q, qd, qdd = motion[:, :, joint]
    found = {"q": q, "turn": q, "qd": qd, "qdd": qdd, "time": given.time}
    if (known := temperature(given)) is not None:
        found |= {s.name: known - s.zero for s in CHANNELS if s.column == TEMPERATURE}
    return found if load is None else found | {LOAD: load}


def rungs(robot: Robot, states: dict[str, Array], used: np.ndarray) -> Iterator[Rung]:
    """Yield all that a joint may have and its samples `used` (N,) can tell, with each constant that is searched."""
    for name in drive_effect_names():
        kernels = load_effect(name)
        if any(state not in states for state in kernels.STATE):
            continue
        if any(np.nanstd(states[s.name][used]) < VARIES for s in read_by(kernels) if s.step):
            continue
        if not kernels.SEARCHED:
            yield Rung(name)
        for searched in kernels.SEARCHED:
            yield from (Rung(name, (value,)) for value in SEARCHES[searched](robot, kernels, states, used))


def _sizes(robot: Robot, kernels: Kernels, states: dict[str, Array], used: np.ndarray) -> list[float]:
    """Return sizes of a state, from a small part of its usual one to a large part."""
    (of,) = kernels.SIZED.values()
    usual = float(np.quantile(np.abs(states[of][used]), 0.95))
    return np.geomspace(SMALLEST * usual, LARGEST * usual, VELOCITIES).tolist()


def _travels(robot: Robot, kernels: Kernels, states: dict[str, Array], used: np.ndarray) -> list[float]:
    """Return ways over which something may build up, so that a joint's samples tell."""
    step = float(np.median(np.diff(states["time"])[np.diff(states["time"]) > 0]))
    shortest = SAMPLES * step * float(np.median(np.abs(states["qd"][used])))
    longest = LARGEST * float(np.ptp(states["q"][used]))
    count = 1 + int(np.log(max(longest / max(shortest, 1e-12), 1.0)) / np.log(TRAVELS))
    return [shortest * TRAVELS**k for k in range(count)]


def _orders(robot: Robot, kernels: Kernels, states: dict[str, Array], used: np.ndarray) -> list[float]:
    """Return the periods per turn that a joint's motion can tell: integers, and multiples of its gear ratio."""
    angle, speed = states["turn"][used], float(np.median(np.abs(states["qd"][used])))
    least = PERIODS * 360 * DEG / max(float(np.ptp(angle)), 1e-9)
    step = float(np.median(np.diff(states["time"])[np.diff(states["time"]) > 0]))
    most = 360 * DEG / max(PER_PERIOD * step * speed, 1e-9)
    gear = None if robot.transmission is None else robot.transmission.gear_ratio
    orders = {float(k) for k in range(1, MOST_ORDER + 1)}
    if gear is not None and gear > 1:
        orders |= {k * gear for k in (1, 2, 3, 4)}
    return sorted(order for order in orders if least <= order <= most)


# of the constant, by how an effect of drives declares that it is searched: one, or it has none
SEARCHES: Mapping[str, Callable[[Robot, Kernels, dict[str, Array], np.ndarray], list[float]]] = {
    "orders": _orders,
    "sizes": _sizes,
    "travels": _travels,
}


def resolution(states: dict[str, Array]) -> float:
    """Return by how many periods per turn two waves differ that a joint's motion tells apart."""
    return 360 * DEG / max(float(np.ptp(states["turn"])), 1e-9)


def hats(values: Array, count: int) -> Array:
    """Return overlapping hats (M, count or fewer) across the quantiles of values (M,): what is smooth in them."""
    knots = np.unique(np.quantile(values, np.linspace(0, 1, count)))
    return np.column_stack([np.interp(values, knots, row) for row in np.eye(len(knots))])
