"""What a diagnosis concludes: effects with their uncertainty and rivals, and the fits that all of it rests on."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.correction import Correction
from deltacal_gen.diagnosis.laws.laws import Lawful
from deltacal_gen.diagnosis.selection import Hypothesis
from deltacal_gen.diagnosis.spectrum import Spectrum
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.identification.noise import Noise, coordinate_sigma
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import Hint, Location, NextMeasurement, Rejected, Verdict
from deltacal_gen.results.parts import Missing

SHORT = 2.0  # times the noise: a held-out error beyond it says that the geometry itself is hardly known


@dataclass(frozen=True)
class Named:
    """An effect that was found, with the gain in chi2 that it brings beside all others.

    `score` is what is left of the gain after its charge. `rivals` explain the same misfit as well; `unrecorded` name
    effects that could, through a channel that was not recorded or did not vary. `of_constant` is the standard
    deviation of a constant that was searched. `lead` is by how much the score exceeds that of the best rival. A
    harmonic names its `fundamental`, with which it is one finding: score and rivals are of all its waves together.
    `elsewhere` has the limbs in whose place others explain as much, and these; `turned` an effect that would do as much
    if the direction of approach counted the other way.
    """

    term: Term
    std: Array
    gain: float
    share: float
    rivals: tuple[Term, ...]
    unrecorded: tuple[str, ...]
    score: float
    of_constant: float | None = None
    lead: float = np.inf
    fundamental: Term | None = None
    elsewhere: dict[int, tuple[int, ...]] = dataclasses.field(default_factory=dict)
    turned: tuple[str, ...] = ()

    @property
    def alike(self) -> tuple[str, ...]:
        """Names of the effects that the readings cannot tell from it."""
        return (*(t.effect for t in self.rivals), *self.unrecorded, *self.turned)


@dataclass(frozen=True)
class Conclusion:
    """What a diagnosis concludes, with the fits that it rests on."""

    verdict: Verdict
    model: str
    baseline: Fit
    final: Fit
    effects: tuple[Named, ...]
    heldout: tuple[float, float]
    noise: Noise
    location: Location
    rejected: tuple[Rejected, ...]
    hints: tuple[Hint, ...]
    not_tested: tuple[Missing, ...]
    next_measurements: tuple[NextMeasurement, ...]
    robot: Robot
    chance: Chance
    hypotheses: tuple[Hypothesis, ...] = ()
    correction: Correction | None = None
    spectrum: Spectrum | None = None
    lean: bool = False
    laws: tuple[Lawful, ...] = ()
    turned: str = ""
    doubts: tuple[str, ...] = ()
    redrawn: bool = False  # `robot` is drawn as the readings want it, not as its file does

    @property
    def short(self) -> bool:
        """Whether there are too few readings to tell a lesser effect from geometry.

        What a fit leaves of the readings that it saw, such as noise that repeats within a few rows do not show, is no
        want of readings.
        """
        return self.verdict is Verdict.ADEQUATE and not self.heldout[0] <= SHORT * self._left

    @property
    def unsure(self) -> bool:
        """Whether what was found predicts held-out readings far worse than those that it was fitted to."""
        return self.heldout[1] > SHORT * self._left

    @property
    def _left(self) -> float:
        """The noise of a coordinate [mm], known or as the fit leaves it."""
        return max(self.noise.sigma, coordinate_sigma(self.final))
