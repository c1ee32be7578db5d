"""Which joint moves what is left: reading by reading along the direction in which that joint moves it.

Whatever a joint does moves every reading as the joint does there, be it a function of something that nobody recorded,
or one too fast for so few readings; no noise of an instrument is like it. The joint's error is taken as drawn by chance
anew in every row, with one size. Of each reading the direction alone counts (Tyler 1987), so that neither tails nor
gross errors change anything; the rival is an instrument whose noise has directions of its own.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from deltacal_gen.diagnosis.charges import quantile
from deltacal_gen.estimation.directions import FEWEST, explained
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.identification.noise import noise
from deltacal_gen.identification.rounding import moved_by_steps
from deltacal_gen.machine.registry import Array

ROUNDED = 4.0  # times the variance of a joint's steps: less is taken for their doing
SIZES = np.geomspace(0.05, 500.0, 24)  # of the variance that a joint brings a reading, in that of its other noise


@dataclass(frozen=True)
class Scatter:
    """A joint (from 1) whose error scatters, and the variance along it, in that of the noise as a fit counts it."""

    joint: int
    variance: float


def scattering(at: Fit) -> Scatter | None:
    """Return the joint that moves what a fit leaves; None where noise of the readings explains as much.

    What repeats show is noise, whoever makes it; joints that were written in steps scatter by these.
    """
    problem, k = at.problem, 3
    limbs, found = problem.mechanism.limbs, problem.readings
    if not found.kind.positions or at.residual.shape[1] < k or noise(at, problem.recording).repeated:
        return None
    dx = problem.displacements(at.machine)[:, :, :limbs]
    J, _ = at.instrument.linearise(found, problem.seen(at.machine), dx)
    freed = replace(at.repeats, shape=None).freed(at.residual / at.sigma)[:, :, :k]
    ways = len(freed)
    whole: np.ndarray = np.logical_and(np.isfinite(freed).all(axis=(0, 2)), (freed**2).any(axis=2).all(axis=0))
    if whole.sum() < FEWEST * k * limbs:
        return None
    z, along = freed[:, whole].reshape(-1, k), np.tile(J[whole, :k] / at.sigma[:k, None], (ways, 1, 1))
    size = (along**2).sum(axis=1)
    unit = size.mean(axis=0)
    if not (seen := unit > 0).any():
        return None
    size, part = size[:, seen] / unit[seen], np.einsum("rk,rkj->rj", z, along[:, :, seen] / np.sqrt(unit[seen])) ** 2
    whole_size = (z**2).sum(axis=1)[:, None, None]
    by = SIZES / (1 + SIZES * size[:, :, None])  # (rows, joints, sizes)
    gain = (-k * np.log1p(-by * part[:, :, None] / whole_size) - np.log1p(SIZES * size[:, :, None])).sum(axis=0) / ways
    j, s = np.unravel_index(int(np.argmax(gain)), gain.shape)
    joint = int(np.flatnonzero(seen)[j])
    whole_noise = 1 + SIZES[s] / k  # which a fit counts as one, in units of the noise beside the joint's
    if gain[j, s] - max(explained(z, ways), 0.0) < quantile(1, limbs):
        return None
    if SIZES[s] < ROUNDED * whole_noise * _by_steps(at, whole)[joint]:
        return None
    return Scatter(joint + 1, float((1 + SIZES[s]) / whole_noise))


def _by_steps(at: Fit, chosen: np.ndarray) -> Array:
    """Return the variance that steps in which joints were written bring some readings (R,), joint by joint."""
    moved = moved_by_steps(at)[chosen, :3] / at.sigma[:3, None]
    out: Array = (moved**2).sum(axis=1).mean(axis=0) / 12
    return out
