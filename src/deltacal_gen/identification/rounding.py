"""What rounding adds to noise: the steps in which joints and readings were written, and how far they move a reading."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.units import joint_factors

LOOKED_AT = 300  # values of a column: a step that they share all have
SAME = 1e-9  # of the span of values: differences below it are rounding of the computer's own
DIGITS = 1e-15  # part of its size to which a number is known, after some turns of unit
FINEST = 1e-7  # of the span of values: a step below it rounds nothing
TOLD = 0.3  # of the larger of two: less adds a twentieth
FEWEST = 4  # distinct values, without which every step fits
ENCODERS = tuple(360.0 / 2**bits for bits in range(6, 26))  # deg: what encoders of one turn resolve


class Rounding(NamedTuple):
    """What the steps in which a recording was written add to the noise of a measured scalar.

    Attributes
    ----------
    of_joints, of_readings : float
        Standard deviation, root mean square over the readings [mm].
    text : str
        What was rounded, in words; empty where nothing was.
    """

    of_joints: float = 0.0
    of_readings: float = 0.0
    text: str = ""


def rounding_of(at: Fit) -> Rounding:
    """Return how coarsely a recording was written, and what that comes to where a fit's machine stands.

    Rounded values lie evenly within a step: its square over twelve is their variance. Whether the values were rounded,
    or commanded so, only what a fit leaves can tell.
    """
    problem, found = at.problem, at.problem.readings
    if not found.kind.positions or found.kind.sees_joints:
        return Rounding()
    factors = _factors(problem)
    read, joints = np.array([step_of(column) for column in found.values.T]), _joint_steps(problem) / factors
    of_joints = float(np.sqrt(np.mean((moved_by_steps(at)[:, :3] ** 2).sum(axis=2)) / 12))
    of_readings = float(np.sqrt(np.mean(read**2) / 12))
    unit = "mm" if (factors == 1).all() else "deg"
    least = TOLD * max(of_joints, of_readings)
    steps = {f"joints in steps of {joints.max():.3g} {unit}": of_joints}
    steps[f"readings in steps of {read.max():.3g} mm"] = of_readings
    told = [words for words, of in steps.items() if of > least]
    return Rounding(of_joints, of_readings, f"rounding of {' and '.join(told)} is in it" if told else "")


def moved_by_steps(at: Fit) -> Array:
    """Return how far readings (R, k, n_q) [mm, rad] move by the steps in which joints were written."""
    steps = _joint_steps(at.problem)
    moved: Array = at.by_displacements[:, :, : len(steps)] * steps
    return moved


def _factors(problem: Problem) -> Array:
    return np.asarray(joint_factors(problem.recording.joint_unit, problem.body.q.shape[1]))


def _joint_steps(problem: Problem) -> Array:
    """Return the steps (n_q,) in which joints were written [rad, mm]."""
    factors = _factors(problem)
    columns = zip((problem.recording.joints[problem.readings.used] / factors).T, factors, strict=True)
    return np.array([step_of(column, ENCODERS if factor != 1 else ()) for column, factor in columns]) * factors


def step_of(values: Array, usual: Sequence[float] = ()) -> float:
    """Return the largest step of which all differences of values (n,) are multiples; 0 where there is none.

    `usual` are steps that values are looked at for even where they were written with too few digits to show them.
    """
    v = np.unique(values[np.isfinite(values)])[:LOOKED_AT]
    if len(v) < FEWEST:
        return 0.0
    gaps, least = np.diff(v), FINEST * float(np.ptp(v))
    same = max(SAME * float(np.ptp(v)), DIGITS * float(np.abs(v).max()))  # however far from zero they are
    step = _divisor(gaps, same, least)
    # written in steps of their last digit: twice its half may part two values from a coarser grid
    for coarse in usual:
        turns = (v - v[0]) / coarse
        if step and coarse > 4 * step and np.abs(turns - np.round(turns)).max() * coarse <= 1.01 * step:
            return float(coarse)
    return step


def _divisor(gaps: Array, same: float, least: float) -> float:
    """Return the greatest common divisor of lengths (n,), alike up to `same`; 0 where it is less than `least`."""
    found = 0.0
    for whole in np.sort(gaps)[::-1].tolist():
        if whole < 2 * same:
            break  # and all that follow: what differs by no more than numbers are known to is one value
        gap = whole
        while gap > 2 * same:
            rest = found % gap if found else 0.0
            found, gap = gap, 0.0 if gap - rest < 2 * same else rest
        if found < least:
            return 0.0
        found = whole / np.round(whole / found)  # which keeps errors of rounding from growing
    return found
