"""What rounding adds to noise: the steps in which joints and readings were written, and how far they move a reading."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.units import joint_factors

LOOKED_AT = 300  # values of a column: a step that they share all have
SAME = 1e-9  # of the span of values: differences below it are rounding of the computer's own
DIGITS = 1e-15  # part of its size to which a number is known, after some turns of unit
FINEST = 1e-7  # of the span of values: a step below it rounds nothing
TOLD = 0.3  # of the larger of two: less adds a twentieth
FEWEST = 4  # distinct values, without which every step fits
ENCODERS = tuple(360.0 / 2**bits for bits in range(6, 26))  # deg: what encoders of one turn resolve


@dataclass(frozen=True)
class Rounding:
    """Steps in which a recording was written, and the standard deviation per measured scalar that they come to [mm].

    Attributes
    ----------
    joint : float
        Largest step of a joint, in the recording's unit of joints (deg or mm).
    reading : float
        Largest step of a reading [mm].
    of_joints, of_readings : float
        What they add to the noise of a measured scalar, root mean square [mm].
    """

    joint: float
    reading: float
    of_joints: float
    of_readings: float
    unit: str = "deg"

    @property
    def text(self) -> str:
        """What was rounded, in words; empty where nothing was."""
        steps = (
            (self.joint, self.of_joints, f"joints in steps of {self.joint:.3g} {self.unit}"),
            (self.reading, self.of_readings, f"readings in steps of {self.reading:.3g} mm"),
        )
        most = max(self.of_joints, self.of_readings)
        told = [words for step, of, words in steps if step and of > TOLD * most]
        return f"rounding of {' and '.join(told)} is in it" if told else ""


def rounding_of(at: Fit, recording: Recording) -> Rounding:
    """Return how coarsely a recording was written, and what that comes to where a fit's machine stands.

    Rounded values lie evenly within a step: its square over twelve is their variance. Whether the values were rounded,
    or commanded so, only what a fit leaves can tell.
    """
    problem = at.problem
    found, kind = problem.readings, problem.readings.kind
    if not kind.positions or kind.sees_joints:
        return Rounding(0.0, 0.0, 0.0, 0.0)
    rows = found.used
    own, unit = _joint_steps(recording, rows, problem.body.q.shape[1])
    read = [step_of(column) for column in found.values.T]
    moved = problem.sensitivity(at.machine, rows).joints[:, :3] * own
    of_joints = float(np.sqrt(np.mean((moved**2).sum(axis=2)) / 12))
    of_readings = float(np.sqrt(np.mean(np.square(read)) / 12))
    factors = np.asarray(joint_factors(recording.joint_unit, len(own)))
    return Rounding(float((own / factors).max()), float(max(read)), of_joints, of_readings, unit)


def moved_by_steps(at: Fit) -> Array:
    """Return how far readings (R, k, n_q) [mm, rad] move by the steps in which joints were written."""
    problem, found = at.problem, at.problem.readings
    own, _ = _joint_steps(problem.recording, found.used, problem.body.q.shape[1])
    instrument = at.instrument.mounted(problem.mechanism, at.errors)
    joints = problem.displacements(at.machine)[:, :, : len(own)] * own
    return instrument.linearise(found, problem.seen(at.machine), joints)[0]


def _joint_steps(recording: Recording, rows: np.ndarray, count: int) -> tuple[Array, str]:
    """Return the steps (n_q,) in which joints were written [rad, mm], and the unit in which they were."""
    factors = np.asarray(joint_factors(recording.joint_unit, count))
    columns = zip((recording.joints[rows] / factors).T, factors, strict=True)
    steps = [step_of(column, ENCODERS if factor != 1 else ()) for column, factor in columns]
    return np.array(steps) * factors, "mm" if (factors == 1).all() else "deg"


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
