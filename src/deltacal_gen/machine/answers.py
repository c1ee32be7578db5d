"""What machines are asked and answer with: sensitivities and loads, in arrays of their own or in the caller's.

Inside: mm, rad, kg, s, N.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, Protocol

import numpy as np

from deltacal_gen.machine.rotation import Array


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """Derivatives of the exact platform pose at N poses: shift of the reference point, turn about the axes of {O}.

    Attributes
    ----------
    own : (N, n_x, limbs, n_e) array
        By each limb's source errors [unit of x / mm or rad].
    common : (N, n_x, limbs, n_s) array
        By the errors that all limbs share, limb by limb: what each limb's share of them does. Empty where limbs share
        none, as the errors of a chain's tool, which no link has.
    bent : (N, n_x, rows, n_d) array, or callable that returns it for some limbs
        See `by_deflections`.
    joints : (N, n_x, n_q) array
        The velocity Jacobian.
    whole : (N, n_x, n_p) array, optional
        See `parameters`, where they were computed side by side.
    """

    own: Array
    common: Array
    bent: Array | Callable[[Sequence[int]], Array]
    joints: Array
    whole: Array | None = None

    @cached_property
    def deflections(self) -> Array:
        """By the displacements that vanish on a rigid machine, (N, n_x, limbs or links, n_d)."""
        return self.by_deflections(())

    def by_deflections(self, limbs: Sequence[int]) -> Array:
        """Return `deflections`, of which those of some limbs, from 1, are wanted; of all, where none is named."""
        if isinstance(self.bent, np.ndarray):
            return self.bent
        if (found := self._known.get(tuple(limbs))) is None:
            found = self._known[tuple(limbs)] = self.bent(limbs)
        return found

    @cached_property
    def _known(self) -> dict[tuple[int, ...], Array]:
        """What `bent` returned: several effects on the same limbs read it."""
        return {}

    @cached_property
    def parameters(self) -> Array:
        """By the source errors, (N, n_x, n_p), in the order of ``Machine.parameters``."""
        if self.whole is not None:
            return self.whole
        flat = self.own.reshape(*self.own.shape[:2], -1)
        return np.concatenate([flat, self.common.sum(axis=2)], axis=2) if self.common.shape[3] else flat

    def turned(self, turns: Array) -> Sensitivity:
        """Return the derivatives of poses that are turned about the origin of {O} by matrices (N, 3, 3)."""

        def led(by: Array) -> Array:
            both = turns.reshape(len(turns), 1, 3, 3) @ by.reshape(len(by), 2, 3, -1)  # shift and turn
            return np.asarray(both.reshape(by.shape))

        bent = self.bent
        return Sensitivity(
            own=led(self.own),
            common=led(self.common),
            bent=led(bent) if isinstance(bent, np.ndarray) else lambda limbs: led(bent(limbs)),
            joints=led(self.joints),
            whole=None if self.whole is None else led(self.whole),
        )


class Standing(Protocol):
    """A machine as it stands, moved by effects or not: poses, joints, tools and rows as `Machine.forward` has them."""

    @property
    def x(self) -> Array:
        """Poses (N, 12): position [mm] and rotation matrix of the platform, row by row."""

    @property
    def q(self) -> Array:
        """Joints (N, n_q) [rad or mm]."""

    @property
    def tool(self) -> Array:
        """Reference point (3,) or (N, 3) in {O'} [mm]."""

    @property
    def rows(self) -> Array:
        """Rows of parameters that the kernels read, (M, limbs or links, n)."""


Reach = Callable[[Array, np.ndarray], tuple[Standing, np.ndarray]]  # see `Machine.follow`


class Weights(NamedTuple):
    """What `Machine.loads` is asked for: see there."""

    masses: Mapping[str, float]
    fields: Array
    payload: Array
    limbs: Sequence[int]


class Loads(NamedTuple):
    """What weights exert in a machine at N poses; each is conjugate to a displacement, positive along it.

    Attributes
    ----------
    torque : (N, n_q) array
        On the joints [N mm]; gravity on a horizontal arm is negative.
    pull : (N, limbs, n_d) array
        Along each limb's deflections [N, N mm]: of its rods, or of what a joint and its link carry.
    tension : (N, limbs, rods) array
        In the rods [N].
    moment : (N, 3) array
        Of all weights about {O} [N mm].
    """

    torque: Array
    pull: Array
    tension: Array
    moment: Array

    @classmethod
    def written(cls, out: Sequence[Array] | None, *values: Array) -> Loads:
        """Return loads in the caller's arrays, where there are any; see `result`."""
        return cls(*values if out is None else map(filled, out, values))


def result(out: Array | None, shape: tuple[int, ...]) -> Array:
    """Return the array that a batch function writes its result into: the caller's `out`, or a new one.

    Raises
    ------
    ValueError
        `out` has another shape or type, is not contiguous, or cannot be written.
    """
    if out is None:
        return np.empty(shape)
    if out.shape != shape or out.dtype != float or not (out.flags.c_contiguous and out.flags.writeable):
        raise ValueError(
            f"out is an array {out.shape} of {out.dtype}; it must be a contiguous array {shape} of float64 to write to."
        )
    return out


def filled(out: Array | None, values: Array) -> Array:
    """Return values in the caller's `out`, or as they are where there is none; see `result`."""
    if out is None:
        return values
    result(out, values.shape)[:] = values
    return out
