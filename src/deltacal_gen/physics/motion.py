"""What a recording in motion tells of its joints beside where they are: the way they came, and how fast.

Without delay, so that what is made of them does not look like friction or latency: by splines (`physics.splines`); of
the few samples of a short run, and where a motion turns within a few samples, by central differences.
"""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from deltacal_gen.errors import TimeOrder
from deltacal_gen.instrument.sampled import at_rate, runs_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics import splines
from deltacal_gen.states import ACCELERATIONS, APPROACH, SPEEDS, TIME
from deltacal_gen.units import joint_factors, joint_names, of_joints

if TYPE_CHECKING:
    from deltacal_gen.results.parts import SeriesMade

FEWEST = 3  # instants of a run: of fewer there is no acceleration
RECORDED = "velocities and accelerations as recorded"
TOO_SHORT = f"no velocities, accelerations or ways of approach: a run has fewer than {FEWEST} instants"
DIFFERENCES = "central differences of the joints: no delay; splines would cut motions that turn within a few samples"
REVERSED = 1e-4  # of a joint's range: way back that is a reversal, and no flutter of the reading


def motion_of(recording: Recording) -> dict[str, Array]:
    """Return columns (N,) that a recording with time lacks: ``approach1 ..., qd1_deg_s ..., qdd1_deg_s2 ...``.

    Rows of one ``run`` (or set-up) follow each other; those of one time are of one instant. Nothing is made of runs of
    fewer than three instants. A joint that begins a run where it ended the last one still stands as it then came.

    Raises
    ------
    InputError
        Time goes backwards within a run.
    """
    return _made(recording)[0]


def _made(recording: Recording) -> tuple[dict[str, Array], SeriesMade | None]:
    """Return columns as `motion_of` does, and what was done; nothing where nothing is made."""
    from deltacal_gen.results.parts import SeriesMade

    time, joints = recording.time_s, recording.joints
    if time is None or not np.isfinite(time).all():
        return {}, None
    unit, count = recording.joint_unit, joints.shape[1]
    instant = _instants(recording, time)
    runs = [np.unique(instant[rows]) for rows in runs_of(recording)]

    def told(text: str, cutoff: float | None = None, removed: float = 0.0) -> SeriesMade:
        return SeriesMade(cutoff_Hz=cutoff, removed=removed, text=text, repairs=recording.repairs)

    if any(len(rows) < FEWEST for rows in runs):
        return {}, told(TOO_SHORT)
    spline = _spline_derivatives(recording, runs)
    if spline is None:
        speed, rate = np.zeros(joints.shape), np.zeros(joints.shape)
        for rows in runs:
            speed[rows] = np.gradient(joints[rows], time[rows], axis=0)
            rate[rows] = np.gradient(speed[rows], time[rows], axis=0)
    else:
        speed, rate = spline.derivatives
    factors = np.array(joint_factors(unit, count))
    made = {APPROACH: _ways(joints, runs), SPEEDS: speed / factors, ACCELERATIONS: rate / factors}
    every = {n: c[instant] for p, v in made.items() for n, c in zip(joint_names(unit, count, p), v.T, strict=True)}
    found = {name: column for name, column in every.items() if name not in recording.channels}
    if not found.keys() & {*joint_names(unit, count, SPEEDS), *joint_names(unit, count, ACCELERATIONS)}:
        return found, told(RECORDED)
    if spline is None:
        return found, told(DIFFERENCES)
    return found, told(splines.what_was_done("joints", spline.spacing), 0.5 / spline.spacing, spline.removed)


def _instants(recording: Recording, time: Array) -> np.ndarray:
    """Return the first row (N,) of the same time in the run of each; raises InputError where time goes backwards."""
    found = np.empty(recording.n_rows, dtype=int)
    for rows in runs_of(recording):
        steps = np.diff(time[rows], prepend=-np.inf)
        if (steps < 0).any():
            raise TimeOrder(
                "time goes backwards within a run.",
                "Sort the rows, or give each uninterrupted movement a label of its own in the column 'run'.",
                file=recording.path,
                line=int(recording.line[rows[steps < 0][0]]),
                column=TIME,
            )
        found[rows] = rows[steps > 0][np.cumsum(steps > 0) - 1]
    return found


def _ways(joints: Array, runs: list[np.ndarray]) -> Array:
    """Return the way (N, n_q) that each joint came; one that begins a run where it ended the last came as it then did.

    0: nobody knows.
    """
    way, count = np.zeros(joints.shape), joints.shape[1]
    ended = np.full((2, count), np.nan)  # where the run before left the joints, and which way they had come
    for rows in runs:
        for j in range(count):
            least = REVERSED * float(np.ptp(joints[:, j]))
            stayed = abs(joints[rows[0], j] - ended[0, j]) <= least
            way[rows, j] = approach(joints[rows, j], least, ended[1, j] if stayed else 0.0)
        ended = np.array([joints[rows[-1]], way[rows[-1]]])
    return way


class _Smooth(NamedTuple):
    """Velocities and accelerations (2, N, n_q) by splines with knots `spacing` [s] apart, and what these take away."""

    derivatives: Array
    spacing: float
    removed: float


def _spline_derivatives(recording: Recording, runs: list[np.ndarray]) -> _Smooth | None:
    """Return velocities and accelerations by splines; None where movements are too short or too quick."""
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
    fitted, *derivatives = splines.smooth(samples, spacing, 2)
    out[:, rows] = derivatives
    return _Smooth(out, spacing, splines.removed(samples, fitted, units))


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
    if recording.motion is not None or not at_rate(recording):
        return recording
    columns, made = _made(recording)
    return dataclasses.replace(recording, channels=recording.channels | columns, motion=made)
