"""Noise that hangs together from row to row: a part that fades, and a part that is each row's own.

Of two readings `d` rows apart the noise has the correlation ``(1 - own) rho^d``: an instrument that wanders, read with
noise. Rows are freed of the first as Prais and Winsten (1954) do, which leaves the second with a covariance of three
diagonals; its factor takes that off too. All of it costs a few passes over the rows.
"""

from __future__ import annotations

import dataclasses
import itertools
from dataclasses import dataclass
from functools import cache, cached_property
from typing import NamedTuple

import numpy as np

from deltacal_gen.instrument.kind import Readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording

LONGEST = 1e-3  # 1 - rho of neighbours: within any recording that is a walk
FADES = (0.0, *np.linspace(-0.2, np.log(LONGEST), 12).tolist())  # log(1 - rho) that are tried
OWN = (0.1, 0.3, 0.5, 0.7, 0.9)  # parts of the variance that are each row's own, likewise
REFINED = 6  # times that the steps between those are halved
OWN_PRICE = 6.6  # of the deviance: what a part of each row's own must explain; chance does in one of a hundred
SIZES = np.geomspace(0.5, 2.0, 21)  # of noise that are tried, in the one that what each direction leaves speaks for
SETTLING = 10  # rounds to that one
SORTED = 0.2  # of the rows of a file, that are earlier than the one before: it is not in the order of reading
UNSEEN = 1e-6  # of the largest singular value: less is no direction that readings see
FAINT = 1e-6  # weight below which a reading counts for nothing
DEFINITE = 1e-12  # of the variance: keeps a factor real where rounding would not
TINY = 1e-300  # of what readings without any error leave


class Taken(NamedTuple):
    """What a fit may have taken out of readings.

    Columns (R, k, n) of what it knew to one, and where it drew to (n,); columns (R, k, m) of what it knew nothing of.
    """

    known: Array
    toward: Array
    free: Array


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
class Series:
    """Readings in the order in which they were taken, and how their noise hangs together.

    Attributes
    ----------
    order : (R,) int array
        Readings, set-up by set-up.
    gap : (R,) array
        Rows of the file since the one before; infinite for the first of a set-up.
    rho : float
        Correlation from row to row of the part that fades.
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
        return Series(order, np.concatenate([[np.inf], gap]))

    @property
    def rows(self) -> float:
        """So many rows tell as much of a mean as one whose noise is its own; all of a set-up at most."""
        return min(1 + 2 * (1 - self.own) * self.rho / (1 - self.rho), self._of_a_set_up)

    @property
    def rows_of_size(self) -> float:
        """So many rows tell as much of the size of noise as one whose noise is its own; all of a set-up at most."""
        return min(1 + 2 * (1 - self.own) ** 2 * self.rho**2 / (1 - self.rho**2), self._of_a_set_up)

    @property
    def within(self) -> float:
        """Part of the variance that rows of a set-up show about their mean: what fades slowly is alike in all of them.

        Of an instrument that walks the rest is its frame's, and as large as one cares to wait.
        """
        shown, starts = 0.0, np.flatnonzero(np.isinf(self.gap)).tolist()
        for start, end in itertools.pairwise([*starts, len(self.gap)]):
            n, before, alike = end - start, 0.0, 0.0
            for told in self._told[start + 1 : end].tolist():
                before = told * (1 + before)
                alike += before
            shown += n - 2 * (1 - self.own) * alike / max(n - 1, 1)
        return shown / len(self.gap)

    @property
    def _of_a_set_up(self) -> float:
        """Rows that a set-up has, in the mean."""
        return len(self.gap) / float(np.isinf(self.gap).sum())

    def freed(self, values: Array) -> Array:
        """Return rows (R, ...) freed of what those before them tell; noise of size 1 stays so."""
        out = np.empty_like(values, dtype=float)
        v = values[self.order].reshape(len(self.order), -1)
        if self.weight is not None:
            v = v / np.sqrt(self._counts)[:, None]
        e = np.array(v, dtype=float)
        e[1:] -= self._told[1:, None] * v[:-1]
        e /= self._left[:, None]
        if self._parted:
            from scipy.linalg import solve_banded

            e = solve_banded((1, 0), self._factor, e, overwrite_b=True, check_finite=False)
        out[self.order] = e.reshape(values[self.order].shape)
        return out

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
    def _told(self) -> Array:
        """What the row before tells of each."""
        told: Array = self.rho**self.gap
        return told

    @cached_property
    def _left(self) -> Array:
        """Standard deviation of what it does not tell."""
        left: Array = np.sqrt(1 - self._told**2)
        return left

    @cached_property
    def _counts(self) -> Array:
        """How much each row counts, in their order."""
        return np.ones(len(self.order)) if self.weight is None else np.maximum(self.weight[self.order], FAINT)

    @cached_property
    def _parted(self) -> bool:
        """Whether any row has noise of its own."""
        return bool(self.own or (self._counts < 1).any())

    @cached_property
    def _factor(self) -> Array:
        """Factor (2, R) of the covariance of rows that are freed of what fades, as `solve_banded` takes it."""
        from scipy.linalg import cholesky_banded

        told, left = self._told, self._left
        covariance = np.zeros((2, len(left)))
        own = self.own + 1 / self._counts - 1
        covariance[0] = (1 - self.own) + own / left**2 + DEFINITE
        covariance[0, 1:] += told[1:] ** 2 * own[:-1] / left[1:] ** 2
        covariance[1, :-1] = -own[:-1] * told[1:] / left[1:] / left[:-1]
        factor: Array = cholesky_banded(covariance, lower=True, check_finite=False)
        return factor

    @property
    def volume(self) -> float:
        """Logarithm of the determinant of the covariance of one component."""
        volume = 2 * float(np.log(self._left).sum())
        return volume + 2 * float(np.log(self._factor[0]).sum()) if self._parted else volume

    def deviance(self, z: Array, taken: Taken | None = None) -> float:
        """Return twice the negative logarithm of the likelihood of rows (R, k), but for a constant.

        Their common size is the one that fits best. What a fit may have taken is taken out as this noise has it: the
        likelihood is that of the rest (Patterson and Thompson 1971, Biometrika 58, 545-554).
        """
        e = self.freed(z).ravel()
        volume = z.shape[1] * self.volume
        if taken is None:
            return float(e.size * np.log(np.mean(e**2)) + volume)
        A, M = (self.freed(columns).reshape(len(e), -1) for columns in (taken.known, taken.free))
        Q, R = np.linalg.qr(M)
        both = np.column_stack([A, e])
        both -= Q @ (Q.T @ both)
        A, e = both[:, :-1], both[:, -1]
        A, inner = np.linalg.qr(A)
        U, root, V = np.linalg.svd(inner)
        seen = root > UNSEEN * root.max(initial=0.0)  # of joints without a drawing the instrument alone is unknown
        A, root = A @ U[:, seen], root[seen]
        along, size = A.T @ e, root**2
        rest, free = max(float(np.sum((e - A @ along) ** 2)), TINY), len(e) - M.shape[1]
        inside = (along - root * (V[seen] @ taken.toward)) ** 2
        about = max(float(e @ e), TINY) / max(free, 1)  # what the fit leaves is near to it, wherever the machine stands
        for _ in range(SETTLING):  # to where the slope of the likelihood by the size is nothing
            noise = about / (about + size)
            about = (rest + (inside * noise**2).sum()) / max(free - len(size) + noise.sum(), DEFINITE)
        s = about * SIZES[:, None] ** 2
        each = free * np.log(s[:, 0]) + np.log1p(size / s).sum(axis=1)
        each += rest / s[:, 0] + (inside / (s + size)).sum(axis=1)
        return _least(each) + volume + 2 * float(np.log(np.abs(np.diagonal(R))).sum())

    def likeliest(self, z: Array, taken: Taken | None = None) -> tuple[Series, float]:
        """Return the noise that explains rows (R, k) best, beside what a fit took out of them, and its deviance."""

        @cache
        def tried(fades: float, own: float) -> tuple[float, float, float]:
            at = dataclasses.replace(self, rho=1 - float(np.exp(fades)), own=own)
            return at.deviance(z, taken) + OWN_PRICE * (own > 0), fades, own

        best = min(tried(fades, 0.0) for fades in FADES)
        if best[1]:
            k = FADES.index(best[1])
            for own in OWN:  # noise that is each row's own makes the rest fade more slowly: the best is near the last
                here = tried(FADES[k], own)
                for way in (1, -1):
                    while 1 <= k + way < len(FADES) and (beside := tried(FADES[k + way], own)) < here:
                        here, k = beside, k + way
                best = min(best, here)
            step, part = FADES[1] - FADES[2], OWN[1] - OWN[0]
            for _ in range(REFINED):
                step, part = step / 2, part / 2
                _, at, own = best
                shifts = ((at + step, own), (at - step, own), (at, own + part), (at, own - part))
                best = min(best, *(tried(min(a, 0.0), o) for a, o in shifts if 0 <= o < 1))
        cost, fades, own = best
        return dataclasses.replace(self, rho=1 - float(np.exp(fades)), own=own), cost - OWN_PRICE * (own > 0)


def _least(each: Array) -> float:
    """Return the least of values (n,) in equal steps, between them by a parabola."""
    k = int(np.clip(np.argmin(each), 1, len(each) - 2))
    before, at, after = each[k - 1 : k + 2]
    bend = before - 2 * at + after
    return float(at - (after - before) ** 2 / (8 * bend)) if bend > 0 else float(min(each))
