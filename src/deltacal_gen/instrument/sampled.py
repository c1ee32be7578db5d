"""Recordings whose rows are samples of a motion: which are, and which of their rows are of one run."""

from __future__ import annotations

import numpy as np

from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.values import Recording, numbered

FEWEST = 12  # samples of a run, where no run is named
QUICK = 0.2  # s between rows, at most, of samples in motion that no run tells: no machine comes to rest so often
GOES_ON = 0.5  # of what joints go from row to row: what that differs by; of poses in any order it is the root of 3


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
    if any(len(rows) < FEWEST or np.diff(time[rows]).min() < 0 for rows in runs):
        return False
    steps = [np.diff(recording.joints[rows], axis=0) for rows in runs]
    on = sum(float(np.sum(np.diff(s, axis=0) ** 2)) for s in steps)
    step = float(np.median(np.concatenate([np.diff(time[rows]) for rows in runs])))
    return bool(0 < step <= QUICK and on < GOES_ON**2 * sum(float(np.sum(s**2)) for s in steps))


def runs_of(recording: Recording) -> list[np.ndarray]:
    """Return the rows of each run, or of each set-up where no runs are named."""
    label = recording.channels.get("run", np.zeros(recording.n_rows))
    run = numbered(np.column_stack([recording.setup, label]))
    return [np.flatnonzero(run == k) for k in range(int(run.max(initial=-1)) + 1)]


def several_at_once(recording: Recording) -> bool:
    """Tell whether an instrument reads several points at a time, each in a row: of a board, or of the machine."""
    return bool(kind_of(recording.kind).known) or recording.tool is not None
