"""A Delta with errors at poses that its kernels solved."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import SOLVED, Machine
from tests.support.prototype import plausible, scattered

TOOL = np.array([30.0, -20.0, -55.0])


class Solved(NamedTuple):
    """A machine with errors at some of its poses."""

    errors: dict[str, float]
    rows: np.ndarray
    q: np.ndarray
    x: np.ndarray
    tool: np.ndarray


def solved(robot: Robot, mechanism: Machine, seed: int, poses: int = 12, size: float = 3.0) -> Solved:
    """Return a machine of random finite errors, `size` times ordinary ones, at random poses and tool points."""
    errors = plausible(mechanism, seed, size=size)
    rows = mechanism.rows(robot, mechanism.vector(errors))
    tool = TOOL * np.random.default_rng(seed).random((poses, 3))
    q, x, status = mechanism.inverse(scattered(robot, poses, seed), tool, rows)
    assert (status == SOLVED).all()
    return Solved(errors, rows, q, x, tool)
