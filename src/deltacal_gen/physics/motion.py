"""What a recording in motion tells of its joints beside where they are: the way they came, and how fast.

Without delay: differences are central, so that what is made of them does not look like friction or latency.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.units import joint_factors, joint_names

REVERSED = 1e-4  # of a joint's range: way back that is a reversal, and no flutter of the reading


def motion_of(recording: Recording) -> dict[str, Array]:
    """Return columns (N,) that a recording with time lacks: ``approach1 ..., qd1_deg_s ..., qdd1_deg_s2 ...``.

    Rows of one ``run`` (or set-up) follow each other. Nothing is made where the time does not increase within them.
    """
    time, joints = recording.time_s, recording.joints
    if time is None or not np.isfinite(time).all():
        return {}
    unit, count = recording.joint_unit, joints.shape[1]
    label = recording.channels.get("run", np.zeros(len(joints)))
    _, run = np.unique(np.column_stack([recording.setup, label]), axis=0, return_inverse=True)
    runs = [np.flatnonzero(np.ravel(run) == k) for k in range(int(run.max(initial=-1)) + 1)]
    if any(len(rows) < 3 or np.diff(time[rows]).min() <= 0 for rows in runs):
        return {}
    way, speed, rate = (np.zeros(joints.shape) for _ in range(3))
    for rows in runs:
        speed[rows] = np.gradient(joints[rows], time[rows], axis=0)
        rate[rows] = np.gradient(speed[rows], time[rows], axis=0)
        for j in range(count):
            way[rows, j] = approach(joints[rows, j], REVERSED * float(np.ptp(joints[:, j])))
    factors = np.array(joint_factors(unit, count))
    made = {
        "approach{i}": way,
        "qd{i}_{unit}_s": speed / factors,
        "qdd{i}_{unit}_s2": rate / factors,
    }
    found = {n: column for p, v in made.items() for n, column in zip(joint_names(unit, count, p), v.T, strict=True)}
    return {name: column for name, column in found.items() if name not in recording.channels}


def approach(q: Array, least: float) -> Array:
    """Return the direction (N,) in which a joint q (N,) last moved, 1 or -1; 0 before it has moved.

    It turns where the joint has gone back by more than `least`.
    """
    out, way, far = np.zeros(len(q)), 0.0, q[0] if len(q) else 0.0
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
    (name,) = joint_names(recording.joint_unit, 1, "approach{i}")
    q, way = recording.joints[:, 0], np.zeros(recording.n_rows)
    if name in recording.channels:
        return {}
    for s in np.unique(recording.setup):
        rows = np.flatnonzero(recording.setup == s)
        way[rows] = approach(q[rows], REVERSED * float(np.ptp(q)))
    return {name: way}


def with_motion(recording: Recording) -> Recording:
    """Return the recording, of a kind that may be read in motion with what the motion tells of its joints.

    That of a single axis always tells which way it came.
    """
    if recording.joints.shape[1] == 1 and recording.pairs is None:
        recording = dataclasses.replace(recording, channels=recording.channels | in_order(recording))
    if not kind_of(recording.kind).in_motion:
        return recording
    return dataclasses.replace(recording, channels=recording.channels | motion_of(recording))
