"""Readings that are none: one or a few in a row, beyond all that the machine and its instrument could do."""

from __future__ import annotations

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths
from deltacal_gen.estimation.series import sequence
from deltacal_gen.files.robot import robot_size
from deltacal_gen.physics.proportion import LONGEST_SPIKE, out_of_proportion


def without_overflow(problem: Problem, first: Fit) -> Problem | None:
    """Return the problem without readings that are out of all proportion by a fit to some or all; None if none are.

    However little they count, so far off they widen the noise of all others, which then seems to hang together. More of
    them in a row may be something else: a slip, or a reflector that was knocked.
    """
    found = problem.readings
    if found.kind.picked or found.made or len(found) < 2:
        return None
    left = problem.residual(first.errors, first.instrument, problem.poses(first.errors))
    off = np.nanmax(np.abs(lengths(left, found.kind)), axis=1)
    far = out_of_proportion(off, np.full(len(off), robot_size(problem.robot)), 0.0)
    if not far.any():
        return None
    order = np.lexsort((sequence(found, problem.recording), found.setup))
    stretch = np.cumsum(np.diff(far[order].astype(int), prepend=0) != 0) + len(order) * found.setup[order]
    if np.unique(stretch[far[order]], return_counts=True)[1].max() > LONGEST_SPIKE:
        return None
    return problem.subset(np.flatnonzero(~far))
