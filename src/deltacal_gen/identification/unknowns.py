"""What is unknown of the instrument and has a name: its value, what knows it, and what may stand for it.

A print that is larger than it says looks like a machine that is smaller than drawn, a longer lens like a board further
off. Whether these readings tell them apart is asked of the information that they and the priors hold together, with all
unknown that is unknown; what rests on nothing but a broad prior has no standard deviation.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from functools import cached_property

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
    summed: bool = False

    @property
    def sentence(self) -> str:
        """Both members in a sentence."""
        if self.summed:
            return f"{self.name} and {self.words} are one number in these readings: their sum is found"
        moved = ", ".join(f"{name} {value:+.2g}" for name, value in self.terms.items())
        return f"{self.name} and {self.words} are one number in these readings ({moved}): neither is found"


@dataclass(frozen=True, eq=False)
class Unknowns:
    """What a fit says of the unknowns of its instrument that have a name.

    Attributes
    ----------
    given : tuple of bool
        Which of the fit's parameters the robot file's tolerances know.
    """

    final: Fit
    given: tuple[bool, ...]

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
        final, problem = self.final, self.final.problem
        state = problem.linearise(final.errors, self.instrument, final.machine)
        J = np.concatenate([state.J_p, state.J_m], axis=2) * self._sizes
        rows = (J * (np.sqrt(final.weights)[:, None] / final.sigma)[..., None])[np.isfinite(state.residual)]
        information: Array = rows.T @ rows
        return information

    def _covariance(self, assumed: float, told: float) -> Array:
        """Return the covariance in ordinary sizes, with priors so many times as wide: assumed ones, told ones."""
        priors = np.full(len(self._sizes), 1 / NOWHERE**2)
        priors[: len(self.final.problem.scale)] = 1 / assumed**2
        priors[: len(self.given)][np.array(self.given, dtype=bool)] = 1 / told**2
        scale = 1 / np.sqrt(np.diag(self._information) + priors)
        whole = (self._information + np.diag(priors)) * np.outer(scale, scale)
        return np.asarray(np.linalg.pinv(whole, hermitian=True, rcond=1e-15) * np.outer(scale, scale))

    @cached_property
    def _stages(self) -> tuple[Array, Array, Array]:
        """Covariances with the priors as they are, without those that no drawing gives, and without any."""
        return self._covariance(1.0, 1.0), self._covariance(FREER, 1.0), self._covariance(FREER, FREER)

    def _named(self) -> list[tuple[int, int, int]]:
        """Return set-up, unknown and place among all of each unknown that has a name, of set-ups that were read."""
        at, n = self.instrument, len(self.final.problem.scale)
        each = len(at.free)
        wanted = [k for k, u in enumerate(at.free) if at.kind.unknown[u][0] in at.kind.reported]
        read = np.unique(self.final.problem.readings.setup)
        return [(int(s), at.free[k], n + int(s) * each + k) for s in read for k in wanted]

    def _status(self, j: int) -> Status:
        own, loose, looser = (np.sqrt(C[j, j]) for C in self._stages)
        if loose > GROWS * own or own > BROAD:
            return Status.NOT_PINNED
        return Status.BY_PRIOR if looser > GROWS * own else Status.IDENTIFIED

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """The unknowns with values, set-up by set-up, in the units of files."""
        at, n = self.instrument, len(self.final.problem.scale)
        found, open_ = [], {o.name: o for o in self.open}
        for s, u, j in self._named():
            name, unit = at.unknown[j - n]
            status, std = self._status(j), float(np.sqrt(self._stages[0][j, j]) * self._sizes[j])
            other = open_.get(name)
            found.append(
                Parameter(
                    name=name,
                    value=float(at.state[s, at.kind.reported[at.kind.unknown[u][0]]]) / to_internal(unit),
                    std=None if status is Status.NOT_PINNED else std / to_internal(unit),
                    unit=at.reported[name],
                    status=status,
                    indistinguishable_from=None if other is None else (other.words, *list(other.terms)[1:]),
                )
            )
        return tuple(found)

    @cached_property
    def open(self) -> tuple[Open, ...]:
        """The unknowns that are not pinned, and those that are found together with something of the machine."""
        at, problem, n = self.instrument, self.final.problem, len(self.final.problem.scale)
        names = [*problem.names, *(f"({t.effect})" for t in problem.terms for _ in range(t.n_coefficients))]
        units = [problem.mechanism.parameters[problem.mechanism.index[name]].unit for name in problem.names]
        found = []
        for s, u, j in self._named():
            if self._status(j) is not Status.NOT_PINNED:
                if at.kind.unknown[u][0] in at.kind.sums:
                    found.append(self._summed(s, u, j))
                continue
            C = self._stages[2]
            close = C[:, j] / np.sqrt(np.maximum(np.diag(C) * C[j, j], 1e-300))
            along = C[:, j] / C[j, j] * self._sizes / self._sizes[j] * at.kind.typical[u]
            order = [k for k in np.argsort(-np.abs(close[: len(units)])) if abs(close[k]) > TOGETHER][:MOST_TOLD]
            name = at.unknown[j - n][0]
            words, remedy = at.kind.confounds.get(
                at.kind.unknown[u][0], ("what else is unknown", "read from other places and directions")
            )
            terms = {name: float(at.kind.typical[u]) / to_internal(at.kind.unknown[u][1])}
            terms |= {names[k]: float(along[k]) / to_internal(units[k]) for k in order}
            own = self._enough(j)
            size = max(abs(float(at.state[s, at.kind.reported[at.kind.unknown[u][0]]])), 1e-300)
            needed = {
                "accuracy": self._needed(),
                "own": own / to_internal(at.unknown[j - n][1]),
                "percent": 100 * own / size,
            }
            found.append(Open(name, words, remedy.format(**needed), terms))
        return tuple(found)

    def _summed(self, s: int, u: int, j: int) -> Open:
        """Return an unknown that is found together with what of the machine is in it."""
        at, n = self.instrument, len(self.final.problem.scale)
        words, remedy = at.kind.sums[at.kind.unknown[u][0]]
        name, unit = at.unknown[j - n]
        told = {"number": s + 1, "own": self._enough(j) / to_internal(unit), "unit": at.reported[name]}
        size = float(at.kind.typical[u]) / to_internal(unit)
        return Open(name, words.format(**told), remedy.format(**told), {name: size}, summed=True)

    def _needed(self) -> float:
        """Return how well a length must be known [%] to leave less than the noise over what the readings span."""
        final = self.final
        rows = final.problem.readings.used
        span = float(np.linalg.norm(np.ptp(final.machine.x[rows, :3], axis=0)))
        return 100 * float(final.sigma[0]) / max(span, 1e-9)

    def _enough(self, j: int) -> float:
        """Return how far off the j-th may be to move readings by less than their noise, root mean square."""
        return float(self._sizes[j] * np.sqrt(self.final.problem.readings.n_scalars / self._information[j, j]))

    @property
    def combinations(self) -> tuple[OpenCombination, ...]:
        """What stands for one another, as results tell it."""
        return tuple(OpenCombination(seen="not at all", text=o.sentence, terms=o.terms) for o in self.open)

    @property
    def remedies(self) -> tuple[Remedy, ...]:
        """What to read to tell them apart, as results tell it; once where it serves several."""
        each = {o.remedy: o for o in self.open}
        count = [sum(o.remedy == remedy for o in self.open) for remedy in each]
        return tuple(Remedy(measurement=r, pins=k, of=len(self.open)) for r, k in zip(each, count, strict=True))

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


def unknowns_of(final: Fit) -> Unknowns:
    """Return what a fit says of its instrument's unknowns, the robot file's tolerances taken as what is known."""
    return Unknowns(final, tuple(name in final.problem.robot.tolerance for name in final.problem.names))
