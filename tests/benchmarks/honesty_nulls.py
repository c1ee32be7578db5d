"""Recordings of machines to which nothing is missing, in fifteen sorts of noise, and what noise they truly have.

Thirteen are noise and nothing else. Of an instrument that walks, and of errors that the readings of a pose share, which
repeats show to be no noise of a reading, *unexplained* is as right as *adequate*; a name is wrong.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping

import numpy as np

from deltacal_gen.machine.values import Recording
from tests.support.left_out import DELTA, channels, machine, record
from tests.support.prototype import plausible

ROBOT = machine()
SIGMA = 0.01  # mm
LENGTHS = (50, 100, 200)  # poses
# rows that carry about ninety of an effective size: where a fit that knows the model is within a fifth in nine of ten
LONG = {"AR 0.5": 140, "AR 0.9": 480, "AR 0.95": 880}
ROUNDED = ((0.1, 0.0), (0.02, 0.0), (0.0, 0.01), (0.0, 0.05))  # mm of a reading, deg of a joint
GROSS = 20.0  # standard deviations
WRONG = 2.0  # times by which a declared sigma is off
BETWEEN, READ_AT_ONCE = 2.5, 3  # standard deviations that readings of one pose share, and how many they are
AXES = np.array([0.6, 0.8, 1.4])  # of the sort that is unlike along them
WALK = 0.3  # standard deviations from row to row
SORTS = (
    *("white", "uniform", "laplace", "t3", "skewed"),
    *("AR 0.5", "AR 0.9", "AR 0.95", "AR mixed", "by pose"),
    *("rounded", "understated", "overstated", "gross", "walk"),
)
Array = np.ndarray


def drawn(sort: str, shape: tuple[int, int], rng: np.random.Generator) -> Array:
    """Return noise (n, 3) of a sort; of unit size, but for its gross errors and drifts."""
    e = rng.standard_normal(shape)
    if sort == "uniform":
        return rng.uniform(-(3**0.5), 3**0.5, shape)
    if sort == "laplace":
        return rng.laplace(0.0, 0.5**0.5, shape)
    if sort == "t3":
        return rng.standard_t(3, shape) / 3**0.5
    if sort == "skewed":
        return rng.exponential(1.0, shape) - 1
    if sort == "AR mixed":  # heavy tails, unlike along the axes
        return _together(rng.standard_t(4, shape) / 2**0.5, 0.7) * AXES
    if sort.startswith("AR"):
        return _together(e, float(sort.split()[1]))
    if sort == "gross":
        e[rng.choice(len(e), rng.integers(1, 4), replace=False)] += rng.normal(0, GROSS, (1, shape[1]))
    if sort == "walk":
        e = 0.5 * e + np.cumsum(WALK * rng.standard_normal(shape), axis=0)
    return e


def _together(e: Array, rho: float) -> Array:
    out = e.copy()
    for i in range(1, len(e)):
        out[i] = rho * out[i - 1] + (1 - rho**2) ** 0.5 * e[i]
    return out


def null(sort: str, k: int) -> Recording:
    """Return the k-th recording of a sort: three of five declare how large noise is."""
    n = LENGTHS[k % len(LENGTHS)] if k % 2 else LONG.get(sort, LENGTHS[k % len(LENGTHS)])
    rng = np.random.default_rng([k, 77])
    made = noiseless(n, k, READ_AT_ONCE if sort == "by pose" else 1)
    e = drawn("white" if sort == "gross" and k % 2 else sort, (n, 3), rng)
    if sort == "gross" and k % 2:  # one alone, at the pose that is farthest out
        out = np.linalg.norm(made.measured - made.measured.mean(axis=0), axis=1)
        e[np.argmax(out)] += GROSS * rng.standard_normal(3)
    if sort == "by pose":
        e += BETWEEN * rng.standard_normal((n, 3))[np.unique(made.pose, return_inverse=True)[1]]
    made = dataclasses.replace(made, measured=made.measured + SIGMA * e)
    if sort == "rounded":
        made = rounded(made, *ROUNDED[k % len(ROUNDED)])
    if sort == "AR mixed" and k % 2:
        made = rounded(made, SIGMA / 2, 0.0)
    off = {"understated": 1 / WRONG, "overstated": WRONG}
    stated = SIGMA * off.get(sort, 1.0) if sort in off or k % 5 < 3 else None
    return dataclasses.replace(made, measurement=dataclasses.replace(made.measurement, sigma_mm=stated))


def rounded(made: Recording, reading: float, joint: float) -> Recording:
    """Return a recording as an instrument [mm] and an encoder [deg] of so many steps write it."""
    if reading:
        made = dataclasses.replace(made, measured=np.round(made.measured / reading) * reading)
    if joint:
        made = dataclasses.replace(made, joints=np.radians(np.round(np.degrees(made.joints) / joint) * joint))
    return made


def noiseless(n: int, k: int, at_once: int, errors: Mapping[str, float] | None = None) -> Recording:
    """Return n readings without noise of a machine with errors of its geometry, some of each pose after one another.

    `errors` are the k-th machine's unless others are given.
    """
    of = channels(n, "approach", "temp", "time", "payload", seed=k)
    pose = np.arange(n) // at_once
    joints = np.degrees(record(ROBOT, n=n, seed=4000 + k, sigma=0.0).joints)[pose]
    errors = plausible(DELTA, k, size=0.3) if errors is None else errors
    labels = [f"p{i}" for i in pose]
    return record(ROBOT, n=n, of=of, errors=errors, sigma=0.0, declared=False, joints=joints, pose=labels)
