"""How large errors are by the readings themselves, and how much of what was known beforehand readings replace."""

from __future__ import annotations

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import unsaid
from deltacal_gen.estimation.system import system
from deltacal_gen.files.robot import Robot
from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.inference.projection import basis
from deltacal_gen.inference.sizes import fit_sizes
from deltacal_gen.machine.registry import Array

FACTORS = (0.02, 4.0)  # of a prior's size, between which the likeliest is sought
NOTHING_LEFT = 1e-12  # of a prior's variance: then the data know everything


def learned(at: Fit, robot: Robot) -> Array:
    """Return standard deviations (n,) of source errors beforehand: as large as the readings show them on the whole.

    The factor common to all that the robot file gives no tolerance for is where the evidence is largest, everything
    that is fitted integrated out (MacKay 1992, Neural Computation 4, 415-447).
    """
    problem, n = at.problem, len(at.problem.names)
    state = problem.linearise(at.errors, at.instrument, at.machine)
    found = system(state, at.sigma, at.weights, at.repeats, problem.scale)
    A_p, A_m, b = found.A_p, found.A_m, found.b
    fitted = basis(np.hstack([A_m, A_p[:, n:]]))
    left_open = unsaid(problem)
    free = np.array([name not in robot.tolerance and name not in left_open for name in problem.names])
    low, high = FACTORS
    model = MixedModel.of(A_p[:, :n], b + A_p @ at.departure, fitted)
    size = fit_sizes(model, np.where(free, 0, -1), (low**2, high**2), noise=1.0).variances if free.any() else np.ones(1)
    out: Array = np.where(free, max(low, size[0] ** 0.5), 1.0) * problem.scale[:n]
    return out


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
