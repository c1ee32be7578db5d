"""What is known of parameters before the readings: what the robot file says, or that parts are made as parts are."""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.values import Robot

BROAD = 10.0  # standard deviation of a parameter of which nothing is known, in ordinary errors
UNSAID = 100.0  # mm: of a tool point of which the robot file says nothing, along each axis
TOOL = ("tx", "ty", "tz")  # of a chain; platforms have theirs known


def with_prior(problem: Problem, robot: Robot, broad: float = BROAD) -> tuple[Problem, tuple[bool, ...]]:
    """Return the problem in standard deviations of its priors, and which of them the robot file's tolerances give.

    Of what the robot file does not say the prior is as `broad` as so many ordinary errors. No reflector sits in the
    origin of a flange: a tool point of zeros is one that nobody has written down.
    """
    given = tuple(n in robot.tolerance for n in problem.names)
    open_ = unsaid(robot)
    sd = [
        robot.tolerance.get(n, UNSAID if n in open_ else broad * s)
        for n, s in zip(problem.names, problem.scale, strict=True)
    ]
    return dataclasses.replace(problem, scale=np.array(sd)), given


def unsaid(robot: Robot) -> tuple[str, ...]:
    """Return the parameters of which the robot file leaves open more than parts are off."""
    return () if robot.tool.any() else TOOL
