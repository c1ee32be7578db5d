"""What is known of parameters before the readings, and how much of it the readings then replace."""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.estimation.fit import BROAD, Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import Array

NOTHING_LEFT = 1e-12  # of a prior's variance: then the data know everything


def with_prior(problem: Problem, robot: Robot) -> tuple[Problem, tuple[bool, ...]]:
    """Return the problem in standard deviations of its priors, and which of them the robot file's tolerances give."""
    given = tuple(n in robot.tolerance for n in problem.names)
    sd = np.array([robot.tolerance.get(n, BROAD * s) for n, s in zip(problem.names, problem.scale, strict=True)])
    return dataclasses.replace(problem, scale=sd), given


def share_of_data(final: Fit) -> Array:
    """Return the part (n,) of each parameter's variance that lies in directions which the data determine."""
    solution = final.solution
    left = 1 / (1 + solution.singular_values**2)  # of each direction's prior variance
    share = solution.V**2 * left
    determined = solution.factors > 0.5
    rest = np.maximum(1 - (solution.V**2).sum(axis=1), 0.0)  # directions beyond the readings
    total = share.sum(axis=1) + rest
    result: Array = share[:, determined].sum(axis=1) / np.maximum(total, 1e-300)
    return np.where(total < NOTHING_LEFT, 1.0, result)
