"""The instrument that made the readings: a value. Its unknowns are increments of its state; a step gives a new one."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.results.parts import InstrumentState
from deltacal_gen.units import DEG, file_unit

if TYPE_CHECKING:
    from deltacal_gen.instrument.kind import Kind


@dataclass(frozen=True, eq=False)
class Instrument:
    """State of the instrument: one row of `state` per set-up, in the order of the generated `given`.

    Attributes
    ----------
    kind : Kind
    state : (S, g) array
    free : tuple of int
        Which unknowns of the kind are estimated; none of them in a frame that is known.
    scale : float
        What one unit of the reading is at the platform [mm]: of images, a pixel at the ball's distance. Residuals and
        derivatives come multiplied by it.
    home : tuple of float
        From where positions count [mm], in {O}.
    ties : tuple of (int, int, float)
        Known distances [mm] between the points of two rows of the state: they leave so many unknowns fewer.
    """

    kind: Kind
    state: Array
    free: tuple[int, ...]
    scale: float = 1.0
    home: tuple[float, float, float] = (0.0, 0.0, 0.0)
    ties: tuple[tuple[int, int, float], ...] = ()

    @property
    def n_unknown(self) -> int:
        """Number of unknowns, all set-ups together."""
        return len(self.free) * len(self.state) - len(self.ties)

    @property
    def unknown(self) -> tuple[tuple[str, str], ...]:
        """Name and unit of each unknown, set-up by set-up."""
        named = [self.kind.unknown[j] for j in self.free]
        several = len(self.state) > 1 or self.kind.stays
        return tuple(
            (f"{name}_{s + 1}" if several else name, self.kind.unit_of(unit, row))
            for s, row in enumerate(self.state)
            for name, unit in named
        )

    def ends(self, found: Readings, x: Array) -> tuple[Array, ...]:
        """Return what readings belong to, one array per end: poses (R, 12), positions counted from the home.

        Of readings of joints, how far the joint has moved (R, 1).
        """
        if any(self.home):
            x = np.hstack([x[:, :3] - self.home, x[:, 3:]])
        ends = found.ends(x)
        return self.kind.looked_at(found, ends)

    def given(self, found: Readings) -> Array:
        """Return what the kernels are given of each reading (R, g): the instrument's state, and what is known of it."""
        state = self.state[found.setup]
        return state if found.known is None else np.hstack([state, found.known])

    def predict(self, found: Readings, x: Array) -> tuple[Array, Array | None]:
        """Return predicted values (R, k) and, where rotations are read, these (R, 3, 3), at platforms x (N, 12)."""
        return self.kind.predict(self, found, x)

    def residual(self, found: Readings, x: Array) -> Array:
        """Return measured minus predicted, (R, k): mm, and the rotation vector between the rotations in rad."""
        values, rotations = self.predict(found, x)
        r = self.scale * (found.values - values)
        if rotations is None or found.rotations is None:
            return r
        turned = np.full((len(found), 3), np.nan)
        read = np.isfinite(found.rotations[:, 0, 0])
        gap = found.rotations[read] @ np.swapaxes(rotations[read], 1, 2)
        turned[read] = to_vector(gap)
        turned[:, [c - 3 for c in range(3, 6) if c not in found.components]] = np.nan
        return np.hstack([r, turned])

    def by_unknown(self, found: Readings, x: Array, chosen: Sequence[int]) -> Array:
        """Return the derivatives (R, k, chosen) of the readings by unknowns of the kind, free or not."""
        derivatives: Array = self.scale * self.kind.kernels.by_unknown(*self.ends(found, x), self.given(found))
        return derivatives[:, :, list(chosen)]

    def linearise(self, found: Readings, x: Array, dx: Array) -> tuple[Array, Array]:
        """Return the derivatives of the readings by parameters and by the instrument's unknowns.

        Parameters
        ----------
        dx : (N, 6, n) array
            Derivatives of the platform coordinates by n parameters; (N, n_q, n) of joints, where these are read.

        Returns
        -------
        J_p : (R, k, n) array
        J_m : (R, k, n_unknown) array
        """
        J_p = self.kind.by_platform(self, found, x, dx)
        J_m = np.zeros((*J_p.shape[:2], len(self.state), len(self.free)))
        if self.free:
            J_m[np.arange(len(found)), :, found.setup] = self.by_unknown(found, x, self.free)
        J_m = J_m.reshape(*J_p.shape[:2], -1)
        return J_p, J_m @ self.kind.loose(self) if self.ties else J_m

    def add_carried(self, J: Array, mechanism: Machine, names: Sequence[str], found: Readings, x: Array) -> None:
        """Add to derivatives (R, k, n) by source errors `names` what those of the instrument's own mount do."""
        own = {
            u: names.index(name)
            for u, p in self.kind.carried(mechanism).items()
            if (name := mechanism.parameters[p].name) in names
        }
        if own:
            J[:, :, list(own.values())] += self.by_unknown(found, x, tuple(own))

    def mounted(self, mechanism: Machine, parameters: Array) -> Instrument:
        """Return the instrument where the machine's own parameters put it: (n_p,), or (S, n_p) by set-up."""
        own = self.kind.carried(mechanism)
        if not own:
            return self
        step = np.zeros((len(self.state), len(self.kind.unknown)))
        step[:, list(own)] = parameters[..., list(own.values())]
        return dataclasses.replace(self, state=self.kind.kernels.stepped(self.state, step))

    def stepped(self, increment: Array) -> Instrument:
        """Return the instrument after an increment (n_unknown,) of its unknowns."""
        if not self.n_unknown:
            return self
        if self.ties:
            increment = self.kind.loose(self) @ increment
        step = np.zeros((len(self.state), len(self.kind.unknown)))
        step[:, list(self.free)] = np.asarray(increment).reshape(len(self.state), -1)
        moved = dataclasses.replace(self, state=self.kind.kernels.stepped(self.state, step))
        return self.kind.tied(moved) if self.ties else moved

    def of_points(self) -> Instrument | None:
        """Return the instrument as it reads positions alone; None where it reads none."""
        return self.kind.of_points(self)

    def frames(self) -> list[tuple[Array, Array]]:
        """Return per set-up the rotation vector [rad] and the origin [mm] of {O} in the instrument's frame."""
        return self.kind.frames(self)

    @property
    def reported(self) -> dict[str, str]:
        """Unknowns that answers give by name, free or not, and their units in files."""
        each = dataclasses.replace(self, free=tuple(range(len(self.kind.unknown))))
        units = (("px" if name.endswith("_px") else file_unit(unit)) for name, unit in each.unknown)
        kinds = [self.kind.unknown[j][0] for _ in self.state for j in each.free]
        named = zip(each.unknown, units, kinds, strict=True)
        return {name: unit for (name, _), unit, own in named if own in self.kind.reported}

    def unit(self, columns: Sequence[str]) -> tuple[str, float] | None:
        """Return the unit of readings in columns of a file and what it is at the platform [mm]; None of lengths."""
        name = self.kind.unit_in(columns)
        return None if name == "mm" else (name, self.scale * (DEG if name == "deg" else 1.0))

    def kept(self, setups: Sequence[str], zero: str, columns: Sequence[str] = ()) -> InstrumentState:
        """Return what an answer keeps of it, and of the recording that it was found by; see `kinds.instrument_of`."""
        return InstrumentState(
            kind=self.kind.name,
            state=self.state,
            free=self.free,
            scale=self.scale,
            home=self.home,
            ties=self.ties,
            setups=tuple(setups),
            zero=zero,
            columns=tuple(columns) if len(columns) == 1 < self.kind.width else None,
        )


def align(a: Array, b: Array) -> Array:
    """Return the rotation R (3, 3) that minimises |b - R a|^2 (Kabsch)."""
    if len(a) < 3:
        return np.eye(3)
    U, _, Vt = np.linalg.svd(b.T @ a)
    turn: Array = U @ np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    return turn
