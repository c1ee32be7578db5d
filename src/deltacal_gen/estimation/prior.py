"""What is known of parameters before the readings: what the robot file says, or that parts are made as parts are."""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.values import Robot

BROAD = 10.0  # standard deviation of a parameter of which nothing is known, in ordinary errors
UNSAID = 100.0  # mm: of a tool point of which the robot file says nothing, along each axis


def with_prior(problem: Problem, robot: Robot, broad: float = BROAD) -> tuple[Problem, tuple[bool, ...]]:
    """Return the problem in standard deviations of its priors, and which of them the robot file's tolerances give.

    Of what the robot file does not say the prior is as `broad` as so many ordinary errors.
    """
    given, left_open = tuple(n in robot.tolerance for n in problem.names), unsaid(problem)
    sd = [
        robot.tolerance.get(n, UNSAID if n in left_open else broad * s)
        for n, s in zip(problem.names, problem.scale, strict=True)
    ]
    return dataclasses.replace(problem, scale=np.array(sd)), given


def unsaid(problem: Problem) -> tuple[str, ...]:
    """Return the free source errors of which nobody has said more than nothing: where the measured point is.

    The sidecar of a gauge tells to which point of the platform it is fixed.
    """
    if problem.readings.kind.measured_point(problem.recording.measurement) is not None:
        return ()
    return tuple(n for n in problem.robot.unsaid if n in problem.names)
