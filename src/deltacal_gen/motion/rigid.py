"""The rigid machine in a recording: base parameters, and what each of them asks of the joints at every sample."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from deltacal_gen.errors import NotExcited
from deltacal_gen.machine.dynamics import Dynamics, dynamics_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.results.result import OpenCombination

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

GENERAL = 60  # samples in general position per joint, by which ranks are found
NEAR = 0.4  # of these, around joints at zero, where a machine with loops can stand
REGULAR = 10.0  # times the ordinary size of a regressor: beyond lies a singularity
SIZE = {"rad": 1.0, "mm": 200.0}  # of joints, velocities and accelerations there
RANK = 1e-9  # of the largest: a smaller diagonal of R is a column that others make up
TERM = 1e-6  # of a combination's largest term: smaller ones are not told
BLOCK = 4096  # samples at a time


@dataclass(frozen=True, eq=False)
class Base:
    """Parameters that some rows of the regressor can know.

    Attributes
    ----------
    chosen : (r,) array of int
        Columns that no combination of earlier ones makes up.
    made_up : (r, n) array
        What each base parameter is made of: ``base = made_up @ parameters``.
    """

    chosen: np.ndarray
    made_up: Array

    @property
    def rank(self) -> int:
        """How many there are."""
        return len(self.chosen)


class Asked(NamedTuple):
    """What is asked of the joints at some samples, positive along positive readings.

    Attributes
    ----------
    columns : list of (N, r) arrays
        By each base parameter of a joint's own torque, per joint.
    payload : (N, n_q) array
        By 1 kg at the tool point.
    """

    columns: list[Array]
    payload: Array


class Rigid:
    """A robot whose inertial parameters are unknown.

    Attributes
    ----------
    dynamics : Dynamics
    own : tuple of Base
        Base parameters by the torque of each joint alone.
    common : Base
        Those by all joints together.
    known : (n,) array
        Inertial parameters that are taken as the robot file states them; 0 of those that are to be found.
    """

    def __init__(self, robot: Robot, *, stated: bool = False) -> None:
        self.dynamics: Dynamics = dynamics_of(robot)
        self._sign = robot.joint_sign
        rng = np.random.default_rng(0)  # of a rank, which general position does not depend on
        sizes = np.array([SIZE[unit] for unit in self.dynamics.joint_units])
        general = rng.standard_normal((3, GENERAL * self.dynamics.joints, self.dynamics.joints)) * sizes
        general[0] *= 1.0 if self.dynamics.bodies else NEAR
        Y = self.dynamics.regressor(general)
        size = np.abs(Y).max(axis=(1, 2))  # NaN where a machine with loops cannot stand, large where it nearly cannot
        if not np.isfinite(size).any():
            raise NotExcited(
                "what its drives would have to give is no number anywhere: a dimension cannot be.",
                "Correct the lengths and angles of the robot file.",
                file=robot.source,
            )
        regular = np.nan_to_num(size, nan=np.inf) < REGULAR * np.nanmedian(size)
        self._general, Y = general[:, regular] / sizes, Y[regular]
        said = self.dynamics.stated() if stated else np.full(len(self.names), np.nan)
        self.known = np.nan_to_num(said)
        Y[:, :, np.isfinite(said)] = 0.0  # what is known is no unknown
        self.own = tuple(base_of(Y[:, j]) for j in range(self.dynamics.joints))
        scale = [max(float(np.abs(Y[:, j]).max()), 1e-300) for j in range(self.dynamics.joints)]
        self.common = base_of(np.concatenate([Y[:, j] / s for j, s in enumerate(scale)]))

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the inertial parameters."""
        return self.dynamics.names

    def columns(self, states: Array, chosen: Sequence[np.ndarray] | None = None) -> list[Array]:
        """Return what inertial parameters ask of each joint, (N, r) per joint, positive along positive readings.

        Parameters
        ----------
        states : (3, N, n_q) array
            As the controller counts.
        chosen : sequence of (r,) arrays of int, optional
            Numbers of the parameters, per joint; the base by its own torque by default.
        """
        chosen = [base.chosen for base in self.own] if chosen is None else chosen
        out = [np.empty((states.shape[1], len(some))) for some in chosen]
        for first in range(0, states.shape[1], BLOCK):
            part = slice(first, first + BLOCK)
            Y = self._sign[:, None] * self.dynamics.regressor(self._sign * states[:, part])
            for j, some in enumerate(chosen):
                out[j][part] = Y[:, j, some]
        return out

    def asked(self, states: Array) -> Asked:
        """Return what is asked of the joints at states (3, N, n_q), as the controller counts."""
        return Asked(self.columns(states), self.of_payload(states))

    def as_lively(self, states: Array) -> Array:
        """Return states (3, G, n_q) in general position, all joints as quick as the quickest of some states is.

        Quick by the rms of speeds and accelerations of `states` (3, N, n_q).
        """
        sizes = np.array([SIZE[unit] for unit in self.dynamics.joint_units])
        quick = np.sqrt(np.mean((states / sizes) ** 2, axis=1)).max(axis=1)
        quick[0] = 1.0  # positions are what they are
        return np.asarray(self._sign * self._general * sizes * quick[:, None, None])

    def torque(self, states: Array, inertia: Array) -> Array:
        """Return what a machine with inertial parameters (n,) asks of each joint (N, n_q)."""
        return np.asarray(self._sign * self.dynamics.torque(self._sign * states, inertia))

    def of_payload(self, states: Array, off: Array | None = None) -> Array:
        """Return what 1 kg at the tool point, or `off` (3,) it [mm], asks of each joint (N, n_q)."""
        return np.asarray(self._sign * self.dynamics.payload(self._sign * states, off))

    def words(self, base: Base) -> list[tuple[str, str]]:
        """Return name and combination of each base parameter."""
        found = []
        for row, k in zip(base.made_up, base.chosen, strict=True):
            terms = [(k, 1.0), *((n, c) for n, c in enumerate(row) if n != k and abs(c) > TERM)]
            text = " ".join(f"{'-' if c < 0 else '+'} {_factor(abs(c))}{self.names[n]}" for n, c in terms)
            found.append((self.names[k], text.removeprefix("+ ")))
        return found

    def unseen(self, base: Base) -> list[OpenCombination]:
        """Return what no torque knows: parameters, and combinations of them that leave every torque as it is."""
        found = []
        if never := [self.names[n] for n in np.flatnonzero(~base.made_up.any(axis=0))]:
            text = f"no torque depends on {', '.join(never)}"
            found.append(OpenCombination(seen="not at all", text=text, terms=dict.fromkeys(never, 1.0)))
        for n in np.flatnonzero(base.made_up.any(axis=0)):
            if n in base.chosen:
                continue
            others = [(k, -row[n]) for k, row in zip(base.chosen, base.made_up, strict=True) if abs(row[n]) > TERM]
            terms = {self.names[n]: 1.0} | {self.names[k]: float(c) for k, c in others}
            undone = " ".join(f"{'-' if c < 0 else '+'} {_factor(abs(c))}{self.names[k]}" for k, c in others)
            text = f"{self.names[n]}: its torques are undone by {undone.removeprefix('+ ')}"
            found.append(OpenCombination(seen="not at all", text=text, terms=terms))
        return found

    def stated_base(self, base: Base) -> Array:
        """Return base parameters (r,) of the bodies that the robot file states; of others it says nothing, which is 0.

        A body of which no inertia is said is a point, as in a simulation.
        """
        return np.asarray(base.made_up @ np.nan_to_num(self.dynamics.stated(points=True)))


def _factor(c: float) -> str:
    return "" if abs(c - 1) < TERM else f"{c:.6g} "


def base_of(Y: Array) -> Base:
    """Return the base parameters of a regressor (M, n) in general position: QR, column by column."""
    sizes = np.linalg.norm(Y, axis=0)
    seen = np.flatnonzero(sizes > RANK * sizes.max())
    if not len(seen):
        return Base(seen, np.zeros((0, Y.shape[1])))
    R = np.linalg.qr(Y[:, seen] / sizes[seen], mode="r")
    chosen: list[int] = []
    kept: list[Array] = []  # orthonormal directions so far
    scaled = np.asarray(R)
    for c in range(len(seen)):
        rest = scaled[:, c].copy()
        for _ in range(2):
            for direction in kept:
                rest -= direction * (direction @ rest)
        size = float(np.linalg.norm(rest))
        if size > 1e-7:
            kept.append(rest / size)
            chosen.append(c)
    columns = scaled[:, chosen]
    weights = np.linalg.lstsq(columns, scaled, rcond=None)[0]
    made_up = np.zeros((len(chosen), Y.shape[1]))
    made_up[:, seen] = weights * sizes[seen] / sizes[seen[chosen]][:, None]
    made_up[np.abs(made_up) < 1e-9 * np.abs(made_up).max(axis=1, keepdims=True)] = 0.0
    return Base(seen[chosen], made_up)
