"""Joints and readings that were logged as they came, each with its own stamps: to rows in which they belong together.

Where the joints stand still while something is read, a row is such a standstill, joints and readings averaged: samples
of one standstill share what sets it apart from the next, and are no repeats. In motion a row is a reading, its joints
interpolated between the samples before and after it. Stamps that come twice, run back or leave gaps are told.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from deltacal_gen.errors import ClockMismatch
from deltacal_gen.files.imported import Imported, recorded
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import POSITION, ROTATION, Robot
from deltacal_gen.states import TIME

GAP = 3.0  # periods: joints that far apart say nothing of what is between
STILL = 1e-3  # of a joint's whole way: noise and quantisation of encoders at rest stay below
WINDOW = 0.25  # s, in which joints at rest stay so near
FEWEST = 3  # standstills: fewer are pauses of a motion


@dataclass(frozen=True)
class Samples:
    """What was logged under one name: stamps (N,) [s] and values (N, k)."""

    name: str
    time: Array
    values: Array


@dataclass(frozen=True)
class Joined:
    """Rows of joints and readings that belong together, and what a user should know of how they came about."""

    time: Array
    joints: Array
    readings: Array
    told: tuple[str, ...]


def ordered(given: Samples) -> tuple[Samples, tuple[str, ...]]:
    """Return samples whose stamps increase, and what was left out or is missing, in words."""
    if not len(given.time):
        return given, ()
    latest = np.maximum.accumulate(np.concatenate([[-np.inf], given.time[:-1]]))
    keep = (given.time > latest) & np.isfinite(given.values).any(axis=1)
    kept, told = replace(given, time=given.time[keep], values=given.values[keep]), []
    if again := int((given.time <= latest).sum()):
        told.append(f"{given.name}: {again} of {len(keep)} samples repeat a stamp or come before it, and are left out")
    steps = np.diff(kept.time)
    if len(steps) and (gaps := int((steps > GAP * np.median(steps)).sum())):
        told.append(
            f"{given.name}: {gaps} gap{'s' * (gaps > 1)}, the longest {steps.max():.3g} s, where a sample comes every "
            f"{np.median(steps):.3g} s"
        )
    return kept, tuple(told)


def join(joints: Samples, readings: Samples, *, moving: bool, path: Path) -> Joined:
    """Return rows of joints and readings.

    Parameters
    ----------
    moving : bool
        Whether every reading is a row, also where the joints stand still.

    Raises
    ------
    InputError
        No reading was taken while joints were logged.
    """
    joints, first = ordered(joints)
    readings, second = ordered(readings)
    told = [*first, *second]
    if len(joints.time) > 1 and not moving:
        rests = [r for r in standstills(joints) if ((readings.time >= r[0]) & (readings.time <= r[1])).any()]
        if len(rests) >= FEWEST:
            return _at_rest(joints, readings, rests, told)
    before = np.searchsorted(joints.time, readings.time, side="right") - 1
    inside = (before >= 0) & (readings.time <= joints.time[-1]) if len(joints.time) else np.zeros(len(before), bool)
    steps = np.diff(joints.time)
    if len(steps):
        beside = steps[np.clip(before, 0, len(steps) - 1)] <= GAP * np.median(steps)
        exact = np.isin(readings.time, joints.time)
        inside &= beside | exact
    if not inside.any():
        raise ClockMismatch(
            f"no reading of {readings.name} was taken while {joints.name} was logged.",
            "Give names whose clocks are the same, or say by how much they differ (--offset).",
            file=path,
        )
    if lost := int((~inside).sum()):
        told.append(f"{lost} of {len(inside)} readings have no joints beside them, and are left out")
    t = readings.time[inside]
    q = np.column_stack([np.interp(t, joints.time, c) for c in joints.values.T])
    return Joined(t, q, readings.values[inside], tuple(told))


def standstills(joints: Samples) -> list[tuple[float, float]]:
    """Return from when to when no joint moved."""
    from scipy.ndimage import maximum_filter1d, minimum_filter1d

    q, way = joints.values, np.ptp(joints.values, axis=0)
    width = max(round(WINDOW / float(np.median(np.diff(joints.time)))), 2)
    span = maximum_filter1d(q, width, axis=0) - minimum_filter1d(q, width, axis=0)
    still = np.concatenate([[False], (span <= STILL * way).all(axis=1), [False]])
    begins, ends = np.flatnonzero(~still[:-1] & still[1:]), np.flatnonzero(still[:-1] & ~still[1:]) - 1
    return [(float(joints.time[a]), float(joints.time[b])) for a, b in zip(begins, ends, strict=True)]


def _at_rest(joints: Samples, readings: Samples, rests: list[tuple[float, float]], told: list[str]) -> Joined:
    def means(of: Samples) -> Array:
        return np.array([np.nanmean(of.values[(of.time >= a) & (of.time <= b)], axis=0) for a, b in rests])

    used = sum(int(((readings.time >= a) & (readings.time <= b)).sum()) for a, b in rests)
    told.append(
        f"the joints stand still {len(rests)} times: a row for each, the mean of its readings "
        f"({used} of {len(readings.time)}); --moving makes a row of every reading"
    )
    middle = np.array([(a + b) / 2 for a, b in rests])
    return Joined(middle, means(joints), means(readings), tuple(told))


def imported(
    joined: Joined, units: tuple[str, ...], machine: Robot | None, path: Path, told: tuple[str, ...] = ()
) -> Imported:
    """Return rows as a recording: of positions, or of poses where rotation vectors [rad] stand beside.

    Parameters
    ----------
    units : tuple of str
        Of the joints, rad or mm.
    machine : Robot, optional
        It is written beside the recording.
    """
    posed = joined.readings.shape[1] == len(POSITION + ROTATION)
    kind, columns = ("pose", POSITION + ROTATION) if posed else ("position", POSITION)
    channels = {TIME: joined.time - joined.time[0]}
    recording = recorded(path, kind, units, joined.joints, columns, joined.readings, channels=channels)
    return Imported(machine, {"recording": recording}, (*told, *joined.told))
