"""A fit as it is handed on: the machine, its instrument, and how surely readings know both."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import GROSS, Repeats, lengths, rms
from deltacal_gen.estimation.solvers import Solution
from deltacal_gen.inference.least_squares import LITTLE, Status
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.deformed import Deformed

SEEN = 0.9  # of a direction's variance beforehand that readings take away: it holds still


@dataclass(frozen=True, eq=False)
class Fit:
    """A fitted machine and instrument.

    Attributes
    ----------
    errors : (n_p,) array
        All source errors of the mechanism [mm, rad]; then the coefficients of effects.
    machine : Deformed
        With these errors, at all rows of the recording.
    residual : (R, k) array
        Measured minus predicted, NaN where a component was not read.
    weights : (R,) array
        Robust weight of each reading, 1 where it counts fully.
    sigma : (k,) array
        Estimated noise of each component [mm, rad].
    solution : Solution
        Of the last step, in scaled parameters.
    covariance : (n + n_m, n + n_m) array
        Joint, of the free parameters and the instrument's unknowns [mm, rad].
    history : list of float
        What each iteration could still gain in chi2.
    status : Status
        Why the iteration ended.
    """

    problem: Problem
    errors: Array
    machine: Deformed
    instrument: Instrument
    residual: Array
    weights: Array
    sigma: Array
    solution: Solution
    covariance: Array
    repeats: Repeats
    history: list[float] = field(default_factory=list)
    status: Status = Status.CONVERGED

    @property
    def unsettled(self) -> tuple[str, ...]:
        """Why the iteration ended, in words, where a further step still promised something."""
        if self.status is Status.CONVERGED or self.history[-1] < LITTLE:
            return ()
        return (
            f"the fit did not converge ({self.status.value} after {len(self.history)} iterations): its next step still "
            f"promised to lower chi2 by {self.history[-1]:.2g}. Compare the result with that of a smaller model.",
        )

    @property
    def parameters(self) -> dict[str, float]:
        """The free source errors by name [mm, rad]."""
        names = self.problem.names
        return dict(zip(names, self.errors[self.problem.columns[: len(names)]].tolist(), strict=True))

    @property
    def departure(self) -> Array:
        """Departure (n,) of the free parameters from their reference, in their scale."""
        problem = self.problem
        out: Array = (self.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
        return out

    @cached_property
    def by_displacements(self) -> Array:
        """Derivatives (R, k, limbs + 3) of the readings by each joint and by a shift along each axis of {O}."""
        problem = self.problem
        instrument = self.instrument.mounted(problem.mechanism, self.errors)
        return instrument.linearise(problem.readings, problem.seen(self.machine), problem.displacements(self.machine))[
            0
        ]

    @property
    def gross(self) -> np.ndarray:
        """Readings (indices) so far off that they are gross errors, not noise: of few others are wrong, not of most."""
        size = np.nanmax(np.abs(self.repeats.off(self.residual)) / self.sigma, axis=1)
        off = np.flatnonzero(size > GROSS)
        return off if 2 * len(off) <= len(size) else off[:0]

    @property
    def unseen(self) -> np.ndarray:
        """Which coefficients (n_c,) of the effects that are fitted bear something, and the readings see none of it."""
        out: np.ndarray = np.diag(self.solution.covariance)[len(self.problem.names) :] >= 1.0 - SEEN
        return out & self.problem.borne(self.problem.terms) if out.any() else out

    def rms(self) -> float:
        """RMS of the residuals of length, each measured scalar once, gross errors left out [mm]."""
        return rms(lengths(np.delete(self.residual, self.gross, axis=0), self.problem.readings.kind))
