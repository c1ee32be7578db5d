"""Where else a fit may begin: with the instrument turned, where the readings hardly tell how it stands.

Points near a line tell a turn about it by how far they lie off the line alone, and what no model explains lies off it
too. A step follows one valley; around the line there may be a lower one.
"""

from __future__ import annotations

import numpy as np

from deltacal_gen.estimation.problem import Problem, State
from deltacal_gen.machine.registry import Array

TURNED = 0.1  # rad: standard deviation of a turn; half a turn costs 2 / TURNED^2 of chi2 then, less than misfit may
QUARTER = 2.0  # length of the Cayley vector of a quarter turn
FURTHER = 3  # squares of what is off a line have two valleys around it at most


def turned(problem: Problem, at: State, covariance: Array) -> list[State]:
    """Return states with the instrument turned about the axis that the readings tell least; none where they tell it.

    Parameters
    ----------
    covariance : (n_m, n_m) array
        Of the instrument's unknowns.
    """
    every = [k for k, (_, unit) in enumerate(at.instrument.unknown) if unit == "rad"]
    frames = [every[first : first + 3] for first in range(0, len(every) - 2, 3)]  # of each set-up
    unsure = [float(np.linalg.eigvalsh(covariance[np.ix_(own, own)])[-1]) ** 0.5 for own in frames]
    if not frames or max(unsure) <= TURNED:
        return []
    own = frames[int(np.argmax(unsure))]
    A, _ = _columns(problem, at)
    size = np.sqrt((A**2).sum(axis=0))
    size = np.where(size > 0, size, 1.0)
    axis = (np.linalg.svd(A / size, full_matrices=False)[2][-1] / size)[
        own
    ]  # of the instrument on a machine that stays
    step = np.zeros(len(covariance))
    step[own] = QUARTER * axis / np.linalg.norm(axis)
    shifts = [k for k in range(len(step)) if k not in every]
    starts = []
    for _ in range(FURTHER):
        at = at._replace(instrument=at.instrument.stepped(step))
        A, b = _columns(problem, at)
        back = np.zeros(len(step))
        back[shifts] = np.linalg.lstsq(A[:, shifts], b, rcond=None)[0]  # about the middle of what was read
        at = at._replace(instrument=at.instrument.stepped(back))
        starts.append(at)
    return starts


def _columns(problem: Problem, at: State) -> tuple[Array, Array]:
    """Return the derivatives (scalars, n_m) of what was read by the instrument's unknowns, and the residuals."""
    found = problem.linearise(at.errors, at.instrument, at.machine)
    read = np.isfinite(found.residual)
    return found.J_m[read], found.residual[read]
