"""Nonlinear least squares over states of any sort: damped steps, corrected to second order.

A step is that of the linear rows, damped as far as these mislead (Levenberg 1944, Marquardt 1963): after a step that
was not taken so much that the next one is a part as long (More 1978), after others by what they kept of the promise
(Nielsen 1999). Lengths are counted in the largest influence that each unknown has had, so that its unit does not
matter, or as the model says. Where the exact rows bend off the linear ones a step is corrected to second order
(Transtrum and Sethna 2012), as long as the correction is no longer than the step; one that keeps more than was promised
is made longer. Rows may be weighed anew at every state; what is remembered of earlier ones follows their size.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import Generic, NamedTuple, Protocol, TypeVar

import numpy as np

from deltacal_gen.inference.projection import Array

S = TypeVar("S")

TRIALS = 60  # of a step's length
SHRINK = 0.25  # of the length of a step that was not taken: that of the next one
EASE, FAINT = 0.1, 1e-3  # by which damping falls at most, and what of the weakest direction's it is as good as none
GOOD = 0.75  # of what the linear rows promised: a step that keeps less is bent
FLAT, LONGER, LONGEST = 1.5, 2.0, 64.0  # of it: a step that keeps more is too short, and made longer by these
KEPT = 1e-4  # of it: with less a step is not taken
NEAR = 0.1  # of the radius: how closely the length of a step meets it
SEARCHES = 50  # of the damping that belongs to a radius
ROUNDING = 1e-12  # of the objective: a smaller change of it is none
STALL, SLOW = 5, 0.6  # steps, and part of what was promised before them: where more still is, they lead nowhere
LITTLE = 0.05  # of the objective, where rows have unit noise: a small part of a standard deviation
RANK = 1e-14  # of the largest singular value: a direction below it stays as it is
TINY = 1e-300  # of squares


class Status(StrEnum):
    """Why an iteration ended."""

    CONVERGED = "converged"  # the next step promises less than the tolerance
    STALLED = "stalled"  # steps promise little, and for some while no less
    NO_DESCENT = "no descent"  # no step lowers the objective
    ITERATIONS = "iterations"  # there were as many as may be


@dataclass(frozen=True, eq=False)
class Linear:
    """Rows made linear: a step z leaves ``b - A z``.

    Attributes
    ----------
    rows : (m, n + 1) array
        A and b.
    triangle : (n + 1, n + 1) array
        Their triangle; of fewer rows as many.
    more : (k, n + 1) array, optional
        Few further rows, as of a prior.
    size : (n,) array, optional
        By what each unknown is multiplied where the length of a step counts; by default its largest influence so far.
    free : (n, k) array, optional
        Directions in which a step may go; all by default.
    step : (n,) array, optional
        Of a rule that minimises no objective: its whole step is taken.
    """

    rows: Array
    triangle: Array
    more: Array | None = None
    size: Array | None = None
    free: Array | None = None
    step: Array | None = None

    def left(self, step: Array) -> Array:
        """Return what a step leaves of all rows (m + k,)."""
        return np.concatenate([part @ np.append(-step, 1.0) for part in self._parts])

    def pull(self, rows: Array) -> Array:
        """Return the products (n,) of the columns with rows (m + k,)."""
        m = len(self.rows)
        each = zip(self._parts, (rows[:m], rows[m:]), strict=False)
        return np.asarray(np.sum([part[:, :-1].T @ own for part, own in each], axis=0))

    @cached_property
    def whole(self) -> Array:
        """Triangle of all rows."""
        if self.more is None:
            return self.triangle
        return np.asarray(np.linalg.qr(np.vstack([self.triangle, self.more]), mode="r"))

    @property
    def _parts(self) -> tuple[Array, ...]:
        return (self.rows,) if self.more is None else (self.rows, self.more)


class Model(Protocol[S]):
    """A sum of squares over states: the square of its rows."""

    def linearise(self, at: S, promised: Sequence[float]) -> Linear:
        """Return the rows made linear at a state, after steps that promised so much; they may be weighed anew."""

    def stepped(self, at: S, step: Array, near: S) -> S | None:
        """Return the state after a step (n,), sought near another; None where there is none."""

    def residual(self, at: S) -> Array:
        """Return the rows (m,) of another state, weighed as they were made linear."""

    def settle(self, promised: Sequence[float]) -> bool:
        """Tell whether weights and derivatives are final; otherwise they are made so when rows are next made linear."""


class Minimum(NamedTuple, Generic[S]):
    """Where an iteration ended, why, and what each step promised to lower the objective by."""

    at: S
    status: Status
    promised: list[float]


class _Steps:
    """The steps from one state, for every radius: decomposed once."""

    def __init__(self, linear: Linear, size: Array) -> None:
        self._linear, free = linear, np.eye(len(size)) if linear.free is None else linear.free
        # by lengths of influence; of directions without any, which move nothing, there is none
        back = free @ np.linalg.pinv(np.linalg.qr(size[:, None] * free, mode="r"), rcond=RANK)
        U, s, Vt = np.linalg.svd(linear.whole[:, :-1] @ back, full_matrices=False)
        kept = s > RANK * s.max(initial=0.0)
        self._back, self._s, self._c = back @ Vt[kept].T, s[kept], U[:, kept].T @ linear.whole[:, -1]

    @property
    def weakest(self) -> float:
        """Square of the smallest singular value."""
        return float(self._s.min(initial=np.inf) ** 2)

    @property
    def promised(self) -> float:
        """By how much the whole step lowers the objective."""
        return float(self._c @ self._c)

    def damping(self, radius: float) -> float:
        """Return that of the step whose length is the radius: none, where the whole step is shorter."""
        damping = 0.0
        for _ in range(SEARCHES):
            w = self._c * self._s / (self._s**2 + damping)
            length = float(np.linalg.norm(w))
            if length <= radius * (1 + NEAR):
                break
            damping += (length / radius - 1) * length**2 / float(np.sum(w**2 / (self._s**2 + damping)))  # More 1978
        return damping

    def step(self, damping: float) -> tuple[Array, float, float]:
        """Return a step (n,), its length, and by how much it lowers the linear objective."""
        w = self._c * self._s / (self._s**2 + damping)
        left = damping / (self._s**2 + damping) if damping else np.zeros(len(w))
        return self._back @ w, float(np.linalg.norm(w)), float(np.sum(self._c**2 * (1 - left**2)))

    def bent(self, rows: Array, step: Array, length: float, damping: float) -> Array | None:
        """Return a step corrected for the rows (m,) that it leaves; None where the correction is longer than it."""
        off = self._linear.pull(rows - self._linear.left(step))
        w = (self._back.T @ off) / (self._s**2 + damping)
        return step + self._back @ w if np.linalg.norm(w) <= length else None


def least_squares(
    model: Model[S], at: S, *, tolerance: float, iterations: int, radius: float = np.inf, little: float = LITTLE
) -> Minimum[S]:
    """Minimise the square of a model's rows.

    Parameters
    ----------
    at : state
        Where to begin.
    tolerance : float
        What a last step may still promise to lower the objective by.
    iterations : int
        How often rows are made linear at most.
    radius : float
        Length that a first step has at most.
    little : float
        What steps may promise that end where they stall.
    """
    promised: list[float] = []
    size, before, damping = np.zeros(1), np.nan, -1.0
    while True:
        linear = model.linearise(at, promised)
        now = _square(linear.whole[:, -1])
        if promised:  # rows may be weighed anew
            again = np.sqrt((now + TINY) / (before + TINY))
            size = again * size
        size = np.maximum(size, np.sqrt((linear.whole[:, :-1] ** 2).sum(axis=0)))
        steps = _Steps(linear, np.where(size > 0, size, 1.0) if linear.size is None else linear.size)
        promised.append(steps.promised if linear.step is None else abs(now - _square(linear.left(linear.step))))
        status = Status.CONVERGED if promised[-1] < tolerance else None
        if status is None and len(promised) > STALL and SLOW * promised[-1 - STALL] < promised[-1] < little:
            status = Status.STALLED
        if status is not None and model.settle(promised):
            return Minimum(at, status, promised)
        if len(promised) == iterations:
            return Minimum(at, Status.ITERATIONS, promised)
        damping = steps.damping(radius) if damping < 0 else damping * (damping > FAINT * steps.weakest)
        found, damping = _taken(model, at, linear, steps, now, damping, tolerance)
        if found is None and model.settle(promised):
            return Minimum(at, Status.NO_DESCENT, promised)
        at, before, damping = (at, now, 0.0) if found is None else (*found, damping)


@np.errstate(over="ignore", invalid="ignore")  # of steps that lead beyond all numbers: they are not taken
def _taken(
    model: Model[S], at: S, linear: Linear, steps: _Steps, now: float, damping: float, tolerance: float
) -> tuple[tuple[S, float] | None, float]:
    """Return the state that a step leads to, its objective, and the damping after it; None where none is lower."""

    def tried(step: Array, length: float, damping: float, enough: float) -> tuple[S | None, float]:
        """Return where a step leads to and what it leaves; one that lowers that by less than `enough` is corrected."""
        if (there := model.stepped(at, step, at)) is None:
            return None, np.inf
        rows = model.residual(there)
        square = _square(rows)
        if now - square < enough and (bent := steps.bent(rows, step, length, damping)) is not None:
            better = model.stepped(at, bent, there)
            if better is not None and (lower := _square(model.residual(better))) < square:
                return better, lower
        return there, square if np.isfinite(square) else np.inf

    for k in range(TRIALS):
        if linear.step is not None:
            there, after = tried(linear.step * SHRINK**k, 0.0, 0.0, -np.inf)
            if there is not None:
                return (there, after), damping
            continue
        step, length, gain = steps.step(damping)
        there, after = tried(step, length, damping, GOOD * gain)
        if there is not None and not damping and now - after > FLAT * gain > FLAT * tolerance:
            bottom = gain / max(2 * gain - now + after, gain / LONGEST)  # of a parabola, in steps
            for longer in LONGER ** np.arange(1, 1 + np.log(bottom) / np.log(LONGER)):
                far, lower = tried(longer * step, longer * length, 0.0, np.inf)
                if lower >= after:
                    break
                there, after = far, lower
        kept = (now - after) / max(gain, TINY)
        if steps.promised <= ROUNDING * now:  # the slope is known better than the objective
            kept = float(after <= now * (1 + ROUNDING / KEPT))
        if there is not None and kept > KEPT:
            return (there, after), damping * max(EASE, 1 - (2 * min(kept, 1.0) - 1) ** 3)  # Nielsen 1999
        if gain <= max(tolerance, ROUNDING * now):  # nothing to be had by shorter steps
            break
        damping = max(steps.damping(SHRINK * length), 2 * damping)
    return None, damping


def _square(values: Array) -> float:
    return float(values @ values)
