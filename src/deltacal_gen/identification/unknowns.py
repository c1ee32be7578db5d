"""What is unknown of the instrument and has a name: its value, what knows it, and what may stand for it.

A print that is larger than it says looks like a machine that is smaller than drawn, a longer lens like a board further
off. Whether these readings tell them apart is asked of the information that they and the priors hold together, with all
unknown that is unknown; what rests on nothing but a broad prior has no standard deviation.
"""

from __future__ import annotations

import dataclasses
from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import BROAD
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.registry import Array
from deltacal_gen.results.diagnosis import NextMeasurement
from deltacal_gen.results.result import OpenCombination, Parameter, Remedy, Status
from deltacal_gen.units import to_internal

FREER = 10.0  # times a prior: what grows along with priors that loosen is not known by the readings
GROWS = 1.5  # by how much it may grow all the same
NOWHERE = 1e4  # ordinary sizes: where an unknown of the instrument may stand that nothing sees
TOGETHER = 0.3  # correlation beyond which parameters stand for an unknown
MOST_TOLD = 6  # of them
ANYTHING = "what else is unknown", "read from other places and directions"


class _Named(NamedTuple):
    """An unknown of the instrument that has a name, in a set-up that was read.

    Attributes
    ----------
    setup, place : int
        Where it stands among set-ups, and among all that is unknown.
    kind : str
        What its kind calls it, whatever the set-up.
    name, unit : str
        As answers call it, and its unit inside.
    typical : float
        Its ordinary size.
    """

    setup: int
    place: int
    kind: str
    name: str
    unit: str
    typical: float


@dataclass(frozen=True)
class Open:
    """An unknown of the instrument that readings and tolerances leave open, and what may stand for it.

    Attributes
    ----------
    name, words : str
        Of the unknown, and of what may stand for it.
    remedy : str
        What would tell them apart.
    terms : dict
        What moves along with it, and by how much in ordinary errors of its own, the unknown itself among them [units
        of files].
    summed : bool
        Whether what is found is the sum of both; otherwise it is neither.
    """

    name: str
    words: str
    remedy: str
    terms: dict[str, float]
    summed: bool

    @property
    def sentence(self) -> str:
        """Both members in a sentence."""
        one = f"{self.name} and {self.words} are one number in these readings"
        if self.summed:
            return f"{one}: their sum is found"
        return f"{one} ({', '.join(f'{name} {value:+.2g}' for name, value in self.terms.items())}): neither is found"


@dataclass(frozen=True, eq=False)
class Unknowns:
    """What a fit says of the unknowns of its instrument that have a name.

    The robot file's tolerances are taken as what is known of its parameters.
    """

    final: Fit

    @cached_property
    def instrument(self) -> Instrument:
        """The instrument, free in all that has a name and is not known, seen or not."""
        at, said = self.final.instrument, self.final.problem.recording.measurement
        named = {u for u in at.kind.wanted(said) if at.kind.unknown[u][0] in at.kind.reported}
        return dataclasses.replace(at, free=tuple(sorted({*at.free, *named})))

    @cached_property
    def _sizes(self) -> Array:
        """Ordinary sizes of parameters and unknowns [mm, rad, 1]."""
        at = self.instrument
        typical = np.tile(at.kind.typical[list(at.free)], len(at.state))
        return np.concatenate([self.final.problem.scale, typical[: at.n_unknown]])

    @cached_property
    def _information(self) -> Array:
        final = self.final
        state = final.problem.linearise(final.errors, self.instrument, final.machine)
        J = np.concatenate([state.J_p, state.J_m], axis=2) * self._sizes
        rows = (J * (np.sqrt(final.weights)[:, None] / final.sigma)[..., None])[np.isfinite(state.residual)]
        information: Array = rows.T @ rows
        return information

    def _covariance(self, assumed: float, told: float) -> Array:
        """Return the covariance in ordinary sizes, with priors so many times as wide: assumed ones, told ones."""
        problem = self.final.problem
        priors = np.full(len(self._sizes), 1 / NOWHERE**2)
        priors[: len(problem.scale)] = 1 / assumed**2
        priors[[j for j, name in enumerate(problem.names) if name in problem.robot.tolerance]] = 1 / told**2
        scale = 1 / np.sqrt(np.diag(self._information) + priors)
        whole = (self._information + np.diag(priors)) * np.outer(scale, scale)
        return np.asarray(np.linalg.pinv(whole, hermitian=True, rcond=1e-15) * np.outer(scale, scale))

    @cached_property
    def _stages(self) -> tuple[Array, Array, Array]:
        """Covariances with the priors as they are, without those that no drawing gives, and without any."""
        return self._covariance(1.0, 1.0), self._covariance(FREER, 1.0), self._covariance(FREER, FREER)

    @cached_property
    def _named(self) -> list[_Named]:
        at, n, found = self.instrument, len(self.final.problem.scale), []
        for s in np.unique(self.final.problem.readings.setup).tolist():
            for k, u in enumerate(at.free):
                kind, j = at.kind.unknown[u][0], s * len(at.free) + k
                if kind in at.kind.reported:
                    name, unit = at.unknown[j]
                    found.append(_Named(s, n + j, kind, name, unit, float(at.kind.typical[u])))
        return found

    def _value(self, one: _Named) -> float:
        return float(self.instrument.state[one.setup, self.instrument.kind.reported[one.kind]])

    def _status(self, one: _Named) -> Status:
        own, loose, looser = (np.sqrt(C[one.place, one.place]) for C in self._stages)
        if loose > GROWS * own or own > BROAD:
            return Status.NOT_PINNED
        return Status.BY_PRIOR if looser > GROWS * own else Status.IDENTIFIED

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """The unknowns with values, set-up by set-up, in the units of files."""
        found, open_ = [], {o.name: o for o in self.open}
        for one in self._named:
            status, other, unit = self._status(one), open_.get(one.name), to_internal(one.unit)
            std = float(np.sqrt(self._stages[0][one.place, one.place]) * self._sizes[one.place])
            found.append(
                Parameter(
                    name=one.name,
                    value=self._value(one) / unit,
                    std=None if status is Status.NOT_PINNED else std / unit,
                    unit=self.instrument.reported[one.name],
                    status=status,
                    indistinguishable_from=(other.words, *list(other.terms)[1:]) if other else None,
                )
            )
        return tuple(found)

    @cached_property
    def open(self) -> tuple[Open, ...]:
        """The unknowns that are not pinned, and those that are found together with something of the machine."""
        kind, found = self.instrument.kind, []
        for one in self._named:
            free = self._status(one) is Status.NOT_PINNED
            if not free and one.kind not in kind.sums:
                continue
            words, remedy = (kind.confounds if free else kind.sums).get(one.kind, ANYTHING)
            # how far off it may be to move readings by less than their noise, root mean square
            seen = self._information[one.place, one.place] / self.final.problem.readings.n_scalars
            own = float(self._sizes[one.place] / np.sqrt(seen))
            told = {
                "number": one.setup + 1,
                "own": own / to_internal(one.unit),
                "unit": self.instrument.reported[one.name],
                "accuracy": self._needed(),
                "percent": 100 * own / max(abs(self._value(one)), 1e-300),
            }
            terms = {one.name: one.typical / to_internal(one.unit)} | (self._along(one) if free else {})
            found.append(Open(one.name, words.format(**told), remedy.format(**told), terms, summed=not free))
        return tuple(found)

    def _along(self, one: _Named) -> dict[str, float]:
        """Return which source errors stand for an unknown, and how large they are where it has its ordinary size."""
        problem, C, j = self.final.problem, self._stages[2], one.place
        close = C[:, j] / np.sqrt(np.maximum(np.diag(C) * C[j, j], 1e-300))
        along = C[:, j] / C[j, j] * self._sizes / self._sizes[j] * one.typical
        units = [problem.mechanism.parameters[problem.mechanism.index[name]].unit for name in problem.names]
        order = [k for k in np.argsort(-np.abs(close[: len(units)])) if abs(close[k]) > TOGETHER][:MOST_TOLD]
        return {problem.names[k]: float(along[k]) / to_internal(units[k]) for k in order}

    def _needed(self) -> float:
        """Return how well a length must be known [%] to leave less than the noise over what the readings span."""
        final = self.final
        span = float(np.linalg.norm(np.ptp(final.machine.x[final.problem.readings.used, :3], axis=0)))
        return 100 * float(final.sigma[0]) / max(span, 1e-9)

    @property
    def combinations(self) -> tuple[OpenCombination, ...]:
        """What stands for one another, as results tell it."""
        return tuple(OpenCombination(seen="not at all", text=o.sentence, terms=o.terms) for o in self.open)

    @property
    def remedies(self) -> tuple[Remedy, ...]:
        """What to read to tell them apart, as results tell it; once where it serves several."""
        each = Counter(o.remedy for o in self.open)
        return tuple(Remedy(measurement=r, pins=k, of=len(self.open)) for r, k in each.items())

    @property
    def next_measurements(self) -> tuple[NextMeasurement, ...]:
        """The same, as diagnoses tell it."""
        return tuple(
            NextMeasurement(
                why=f"separates {o.name} from {o.words}",
                text=f"{o.remedy[0].upper()}{o.remedy[1:]}.",
                poses=(),
                expected_chi2=None,
            )
            for o in self.open
        )
