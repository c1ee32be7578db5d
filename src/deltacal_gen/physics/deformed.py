"""A machine that effects have moved, and how what moves all of it at once carries its pose along."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import cayley_matrix, spin, swept
from deltacal_gen.physics.targets import Target


class Deformed(NamedTuple):
    """A machine moved by effects: what the kernels read.

    Attributes
    ----------
    x, q, tool, rows : (N, 12), (N, n_q), (N, 3), (1 or N, limbs, n_p) arrays
    restless : (N,) array of int, optional
        At rows without static equilibrium the joint, from 1, that is thrown back and forth; 0 elsewhere.
    turn : (N, 3) array, optional
        Cayley vectors by which the base has turned under it: x is beyond it, joints and loads before.
    """

    x: Array
    q: Array
    tool: Array
    rows: Array
    restless: np.ndarray | None = None
    turn: Array | None = None

    @property
    def upright(self) -> Array:
        """The poses x (N, 12) before the base has turned; zero where there is none."""
        x = np.nan_to_num(self.x)
        return x if self.turn is None else turned(x, cayley_matrix(-self.turn))


def carried(target: Target, machine: Deformed) -> Array:
    """Return the derivative (N, 6) of the pose by a turn of the base, or by a shift of the measured point."""
    axis, x = target.axis, np.nan_to_num(machine.x)
    if target.sort == "tool":
        return np.hstack([x[:, 3:].reshape(-1, 3, 3)[:, :, axis], np.zeros((len(x), 3))])
    turn = np.zeros((len(x), 3)) if machine.turn is None else machine.turn
    unit = spin(turn)[:, :, axis]
    return np.hstack([(swept(x[:, :3]) @ unit[:, :, None])[:, :, 0], unit])


def turned(x: Array, turns: Array) -> Array:
    """Return poses x (N, 12) turned about the origin of {O} by matrices (N, 3, 3)."""
    rotations = turns @ x[:, 3:].reshape(-1, 3, 3)
    return np.hstack([(turns @ x[:, :3, None])[:, :, 0], rotations.reshape(-1, 9)])
