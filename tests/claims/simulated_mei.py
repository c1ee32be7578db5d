"""The procedure of Mei et al. 2018, simulated: what the claims of more than one section are decided with."""

from __future__ import annotations

from functools import cache

import numpy as np

from tests.claims import independent_mei as mei

SIX = mei.positions(3)
GROUPS = range(1, 7)
STOP = np.radians(0.1)  # mu_0 of section 6.2
SEEDS = 200


def condition(matrix: mei.Array) -> float:
    return float(np.linalg.cond(matrix))


@cache
def simulated(number: int, motor: bool = True, rounds: int = 20) -> mei.Procedure:
    """The paper's procedure on a group of table 2, SEEDS times, with the noise of eqs. (34), (35) or (34) alone."""
    noise = mei.Noise() if motor else mei.Noise(motor=0.0)
    return mei.procedure(mei.group(number), mei.MOUNTED, rounds, np.random.default_rng(number), SEEDS, noise)


@cache
def noise_free(number: int, rounds: int = 8) -> mei.Procedure:
    return mei.procedure(mei.group(number), mei.MOUNTED, rounds, None)


def when_stopped(done: mei.Procedure) -> tuple[mei.Array, mei.Array]:
    """Compensation (rad) and identified error of the mechanism (mm) where the rule of eq. (32) stops."""
    stop, row = done.stopped(STOP), np.arange(len(done.lengths))
    return done.compensated[row, stop], done.mechanism[row, stop - 1]
