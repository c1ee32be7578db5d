"""Noise that hangs together from row to row: a part that fades, and a part that is each row's own.

Of two readings `d` rows apart the noise has the correlation ``(1 - own) rho^d``: an instrument that wanders, read with
noise. Points that are read one after another while the machine stands are no row apart: where it stands wrongly, all of
them are off. Rows are freed of the first as Prais and Winsten (1954) do, which leaves the second with a covariance of
three diagonals; its factor takes that off too. All of it costs a few passes over the rows.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from deltacal_gen.estimation.correlated import Correlated, Taken
from deltacal_gen.inference.noise import NoiseModel
from deltacal_gen.inference.sizes import least
from deltacal_gen.instrument.kind import Readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording, numbered

LONGEST = 1e-3  # 1 - rho of neighbours: within any recording that is a walk
FADES = (0.0, *np.linspace(-0.2, np.log(LONGEST), 12).tolist())  # log(1 - rho) that are tried
OWN = (0.1, 0.5, 0.9)  # parts of the variance that are each row's own, likewise
STEPS, LIMITS = (0.6, 0.2), ((np.log(LONGEST), 0.0), (0.0, 0.99))  # of both, from the best of these on
OWN_PRICE = 6.6  # of the deviance: what a part of each row's own must explain; chance does in one of a hundred
TWICE = 2.0  # times that a set-up shows what fades: what it shows less often goes from one end of it to the other
SORTED = 0.2  # of the rows of a file, that are earlier than the one before: it is not in the order of reading
STILL = 1e-3  # rows between points of one pose: none, but for what keeps their covariance from being singular


def points_of_a_pose(found: Readings, recording: Recording) -> np.ndarray | None:
    """Return where the machine stood at each reading (R,), by number; None where no other point of it was read."""
    rows, tool = found.rows[:, 0], recording.tool
    if found.rows.shape[1] != 1 or tool is None or not np.ptp(np.nan_to_num(tool[rows]), axis=0).any():
        return None
    return numbered(np.round(np.column_stack([recording.joints, recording.setup]), 9)[rows])


def sequence(found: Readings, recording: Recording) -> np.ndarray:
    """Return where each reading (R,) stands in the order in which they were taken: its line, or its place in time.

    A file whose times mostly jump was sorted by something else. Where they begin anew a few times it was put together
    of several, and its lines are in order.
    """
    time = recording.time_s
    if time is None or recording.begins_anew or found.rows.shape[1] != 1:
        return found.line
    lines, at = np.lexsort((found.line, found.setup)), time[found.rows[:, 0]]
    back = np.diff(at[lines])[np.diff(found.setup[lines]) == 0] < 0
    if not len(back) or not np.isfinite(at).all() or back.mean() < SORTED:
        return found.line
    place = np.empty(len(at), dtype=int)
    place[np.lexsort((found.line, at, found.setup))] = np.arange(len(at))
    return place


@dataclass(frozen=True, eq=False)
class Series(Correlated):
    """Readings in the order in which they were taken, and how their noise hangs together.

    Attributes
    ----------
    order : (R,) int array
        Readings, set-up by set-up.
    gap : (R,) array
        Rows of the file since the one before; infinite for the first of a set-up, hardly any for a further point of a
        pose.
    rho : float
        Correlation from row to row of the part that fades; from pose to pose, where each is of several points.
    own : float
        Part of the variance that is each row's own.
    weight : (R,) array, optional
        How much each reading counts, 1 fully: one that counts less has more noise of its own, whatever its neighbours
        have. Values come multiplied by its root.
    """

    order: np.ndarray
    gap: Array
    rho: float = 0.0
    own: float = 0.0
    weight: Array | None = None

    @staticmethod
    def of(found: Readings, recording: Recording) -> Series | None:
        """Return the readings in their order; None of those that belong to two rows."""
        if found.rows.shape[1] != 1:
            return None
        place = sequence(found, recording)
        order = np.lexsort((place, found.setup))
        same = np.diff(found.setup[order]) == 0
        gap = np.where(same, np.maximum(np.diff(place[order]), 1), np.inf)
        if (pose := points_of_a_pose(found, recording)) is not None:
            gap[same & (np.diff(pose[order]) == 0)] = STILL
        return Series(order, np.concatenate([[np.inf], gap]))

    @property
    def text(self) -> str:
        """How the noise of rows hangs together, in words."""
        if round(self.points) > 1:  # as most poses are read: a pose or two with more points say nothing of the rest
            words = f"the points of a pose have {1 - self.own:.0%} of the noise's variance in common"
            return f"{words} (correlation {self.rho:.2f} from pose to pose)"
        words = f"the noise hangs together over {self.rows:.0f} rows (correlation {self.rho:.2f} from row to row"
        return words + (f", beside {self.own:.0%} of its variance that is each row's own)" if self.own else ")")

    @cached_property
    def points(self) -> float:
        """Rows that are read of a pose, in the mean."""
        return len(self.gap) / max(float((self.gap > STILL).sum()), 1.0)

    @property
    def rows(self) -> float:
        """So many rows tell as much of a mean as one whose noise is its own; all of a set-up at most."""
        return min(self._alike(self.rho, 1 - self.own), self.rows_of_a_set_up)

    def _alike(self, rho: float, shared: float) -> float:
        """Return the sum of a row's correlations with all, itself among them."""
        beside = (self.points - 1) * (self.rho > 0)
        return 1 + shared * (beside + 2 * self.points * rho / (1 - rho))

    @property
    def lasts(self) -> bool:
        """Whether what fades lasts so long that a set-up shows it once: a way that something went, no noise."""
        return TWICE * self.rows > self.rows_of_a_set_up

    @property
    def rows_of_size(self) -> float:
        """So many rows tell as much of the size of noise as one whose noise is its own; all of a set-up at most."""
        return min(self._alike(self.rho**2, (1 - self.own) ** 2), self.rows_of_a_set_up)

    @property
    def within(self) -> float:
        """Part of the variance that rows of a set-up show about their mean: what fades slowly is alike in all of them.

        Of an instrument that walks the rest is its frame's, and as large as one cares to wait.
        """
        alike = self.weighted(None).noise.times(np.ones(len(self.gap)))[self.order]  # a row's correlations with all
        setup = np.cumsum(np.isinf(self.gap)) - 1
        n = np.bincount(setup)
        return float((n - (np.bincount(setup, alike) - n) / np.maximum(n - 1, 1)).sum() / len(self.gap))

    @property
    def rows_of_a_set_up(self) -> float:
        """Rows that a set-up has, in the mean."""
        return len(self.gap) / float(np.isinf(self.gap).sum())

    def ways(self, values: Array) -> Array:
        """Return rows (R, ...) freed of what those before tell, and of what those after do, (2, R, ...)."""
        return np.stack([self.freed(values), self._backwards.freed(values)])

    def alone(self, values: Array) -> Array:
        """Return what the rows before and after do not tell of each row (R, k); noise of size 1 stays so."""
        after = np.append(self._told[1:], 0.0)
        a, b, both = (1 - self.own) * self._told, (1 - self.own) * after, (1 - self.own) * self._told * after
        by_a, by_b = ((x - y * both) / (1 - both**2) for x, y in ((a, b), (b, a)))
        v, out = values[self.order], np.empty_like(values, dtype=float)
        told = np.zeros_like(v)
        told[1:] += by_a[1:, None] * v[:-1]
        told[:-1] += by_b[:-1, None] * v[1:]
        out[self.order] = (v - told) / np.sqrt(1 - by_a * a - by_b * b)[:, None]
        return out

    @cached_property
    def _backwards(self) -> Series:
        """The same rows, from the last to the first."""
        gap = np.concatenate([[np.inf], self.gap[:0:-1]])
        return dataclasses.replace(self, order=self.order[::-1], gap=gap)

    @cached_property
    def _told(self) -> Array:
        """What the row before tells of each."""
        return np.asarray(self.rho**self.gap)

    @cached_property
    def noise(self) -> NoiseModel:
        """Noise of one component."""
        own = self.own + 1 / self.counts(len(self.gap))[self.order] - 1
        return NoiseModel(self.order, own, self._told, 1 - self.own, np.zeros((len(own), 0)))

    def likeliest(self, z: Array, taken: Taken | None = None) -> tuple[Series, float]:
        """Return the noise that explains rows (R, k) best, beside what a fit took out of them, and its deviance."""

        def tried(fades: float, own: float = 0.0) -> Series:
            return dataclasses.replace(self, rho=1 - float(np.exp(fades)), own=own)

        def cost(x: Sequence[float] | Array) -> float:
            return tried(*x).deviance(z, taken)

        first = min(FADES, key=lambda fades: cost([fades]))
        if not first and self.points == 1:
            return tried(0.0), cost([0.0])
        lone, alone = least(cost, [[first]], STEPS[:1], LIMITS[:1])
        both, shared = least(cost, [*itertools.product(FADES[1::3], OWN)], STEPS, LIMITS)
        return (tried(*both), shared) if shared + OWN_PRICE < alone else (tried(*lone), alone)
