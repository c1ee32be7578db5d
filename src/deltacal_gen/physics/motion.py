"""What a recording in motion tells of its joints beside where they are: the way they came, and how fast.

Without delay, so that what is made of them does not look like friction or latency: by splines (`physics.splines`); of
the few samples of a short run, and where a motion turns within a few samples, by central differences.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording, numbered
from deltacal_gen.physics import splines
from deltacal_gen.states import ACCELERATIONS, APPROACH, SPEEDS
from deltacal_gen.units import joint_factors, joint_names, of_joints

QUICK = 0.2  # s between rows, at most, of samples in motion that no run tells: no machine comes to rest so often
GOES_ON = 0.5  # of what joints go from row to row: what that differs by; of poses in any order it is the root of 3
REVERSED = 1e-4  # of a joint's range: way back that is a reversal, and no flutter of the reading


def at_rate(recording: Recording) -> bool:
    """Tell whether rows are samples of a motion: run by run, or quick and each going on as the one before it came.

    Poses at which a machine was brought to rest are seconds apart, and in most plans each lies elsewhere.
    """
    time = recording.time_s
    if time is None or recording.pairs is not None or not np.isfinite(time).all():
        return False
    if "run" in recording.channels or kind_of(recording.kind).in_motion:
        return True
    runs = runs_of(recording)
    if any(len(rows) < splines.LEAST or np.diff(time[rows]).min() <= 0 for rows in runs):
        return False
    steps = [np.diff(recording.joints[rows], axis=0) for rows in runs]
    on = sum(float(np.sum(np.diff(s, axis=0) ** 2)) for s in steps)
    quick = float(np.median(np.concatenate([np.diff(time[rows]) for rows in runs]))) <= QUICK
    return bool(quick and on < GOES_ON**2 * sum(float(np.sum(s**2)) for s in steps))


def runs_of(recording: Recording) -> list[np.ndarray]:
    """Return the rows of each run, or of each set-up where no runs are named."""
    label = recording.channels.get("run", np.zeros(recording.n_rows))
    run = numbered(np.column_stack([recording.setup, label]))
    return [np.flatnonzero(run == k) for k in range(int(run.max(initial=-1)) + 1)]


def motion_of(recording: Recording) -> dict[str, Array]:
    """Return columns (N,) that a recording with time lacks: ``approach1 ..., qd1_deg_s ..., qdd1_deg_s2 ...``.

    Rows of one ``run`` (or set-up) follow each other. Nothing is made where the time does not increase within them.
    A joint that begins a run where it ended the last one still stands as it then came.
    """
    time, joints = recording.time_s, recording.joints
    if time is None or not np.isfinite(time).all():
        return {}
    unit, count = recording.joint_unit, joints.shape[1]
    runs = runs_of(recording)
    if any(len(rows) < 3 or np.diff(time[rows]).min() <= 0 for rows in runs):
        return {}
    way, speed, rate = (np.zeros(joints.shape) for _ in range(3))
    spline = _spline_derivatives(recording, runs)
    ended = np.full((2, count), np.nan)  # where the run before left the joints, and which way they had come
    for rows in runs:
        if spline is None:
            speed[rows] = np.gradient(joints[rows], time[rows], axis=0)
            rate[rows] = np.gradient(speed[rows], time[rows], axis=0)
        else:
            speed[rows], rate[rows] = spline[:, rows]
        for j in range(count):
            least = REVERSED * float(np.ptp(joints[:, j]))
            stayed = abs(joints[rows[0], j] - ended[0, j]) <= least
            way[rows, j] = approach(joints[rows, j], least, ended[1, j] if stayed else 0.0)
        ended = np.array([joints[rows[-1]], way[rows[-1]]])
    factors = np.array(joint_factors(unit, count))
    made = {
        APPROACH: way,
        SPEEDS: speed / factors,
        ACCELERATIONS: rate / factors,
    }
    found = {n: column for p, v in made.items() for n, column in zip(joint_names(unit, count, p), v.T, strict=True)}
    return {name: column for name, column in found.items() if name not in recording.channels}


def _spline_derivatives(recording: Recording, runs: list[np.ndarray]) -> Array | None:
    """Return velocities and accelerations (2, N, n_q) by splines; None where movements are too short or too quick."""
    rows = np.concatenate(runs)
    run = np.repeat(np.arange(len(runs)), [len(own) for own in runs])
    assert recording.time_s is not None
    time = recording.time_s[rows]
    samples = splines.Samples(recording.joints[rows], time, splines.pieces_of(time, run))
    if min(len(own) for own in samples.pieces) < splines.LEAST:
        return None
    units = of_joints(recording.joint_unit, recording.joints.shape[1])
    spacing = splines.chosen_spacing(samples, 2, units)
    if not splines.resolves(samples, spacing, units):
        return None
    out = np.empty((2, *recording.joints.shape))
    out[:, rows] = splines.smooth(samples, spacing, 2)[1:]
    return out


def approach(q: Array, least: float, way: float = 0.0) -> Array:
    """Return the direction (N,) in which a joint q (N,) last moved, 1 or -1; `way` before it has moved, 0: unknown.

    It turns where the joint has gone back by more than `least`.
    """
    out, far = np.zeros(len(q)), q[0] if len(q) else 0.0
    for k, at in enumerate(q):
        if abs(at - far) > least and (at - far) * way <= 0:
            way, far = float(np.sign(at - far)), at
        elif (at - far) * way > 0:
            far = at
        out[k] = way
    return out


def in_order(recording: Recording) -> dict[str, Array]:
    """Return the column (N,) of the way that the only joint of a machine came, by the order of the rows, if it lacks.

    An axis that goes forth and back is measured row after row.
    """
    (name,) = joint_names(recording.joint_unit, 1, APPROACH)
    q, way = recording.joints[:, 0], np.zeros(recording.n_rows)
    if name in recording.channels:
        return {}
    for s in np.unique(recording.setup):
        rows = np.flatnonzero(recording.setup == s)
        way[rows] = approach(q[rows], REVERSED * float(np.ptp(q)))
    return {name: way}


def with_motion(recording: Recording) -> Recording:
    """Return the recording, of samples in motion with what the motion tells of its joints; see `at_rate`.

    That of a single axis always tells which way it came.
    """
    if recording.joints.shape[1] == 1 and recording.pairs is None:
        recording = dataclasses.replace(recording, channels=recording.channels | in_order(recording))
    if not at_rate(recording):
        return recording
    return dataclasses.replace(recording, channels=recording.channels | motion_of(recording))
