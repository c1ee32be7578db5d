"""What is fitted already, taken out of the readings: a projection beside geometry, instrument, effects and orders."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.system import whitened
from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.machine.registry import Array

BLOCK = 256  # columns that are whitened at once: whitening needs four times their memory


class Beside:
    """Readings at a fit, whitened, and the projection beside geometry, instrument and effects that are fitted.

    Attributes
    ----------
    Q : (scalars, n) array
        The readings' part of an orthonormal basis of what is fitted; priors make it shorter than unit vectors.
    residual : (scalars,) array
        What is left of the readings by the projection, in standard deviations.
    squares : float
        Sum of squares that is left, of the readings and of what priors hold.
    readings : int
        Number of scalars.
    owner : (scalars,) int array
        The reading that each belongs to.
    read : (R, k) bool array
        Which components of readings the scalars are.
    """

    def __init__(self, at: Fit) -> None:
        self.fit, problem = at, at.problem
        self.machine = at.machine
        state = problem.linearise(at.errors, at.instrument, self.machine)
        self.read = np.isfinite(state.residual)
        self.owner = np.nonzero(self.read)[0]
        held, size = problem.held[: len(problem.held_std)], np.concatenate([[], *map(np.ravel, problem.held_std)])
        unknown = problem.term_columns(held, at.errors, at.instrument, self.machine) * size
        base = self.rows(np.concatenate([state.J_p * problem.scale, state.J_m, unknown], axis=2))
        # the priors' rows: geometry moves as far as drawings leave it open, not to the ends of a flat direction
        values = np.concatenate([[], *(t.values.ravel() for t in held)]) / size
        self._departure = np.concatenate([at.departure, np.zeros(state.J_m.shape[2]), values])
        own = len(problem.scale) + np.arange(state.J_m.shape[2])
        seen = own[base[:, own].any(axis=0)]  # a turn that nothing reads stays as it is
        pulls = np.delete(np.arange(base.shape[1]), seen)
        # the residual carries the influence of a reading, columns none of it: a gross error can earn but little
        r = self.rows((state.residual * at.weights[:, None])[..., None])[:, 0]
        self.readings = len(r)
        prior = np.eye(base.shape[1])[pulls]
        self._project(np.vstack([base, prior]), np.concatenate([r, -self._departure[pulls]]))

    def _project(self, base: Array, pulled: Array) -> None:
        self._base, self._pulled = base, pulled
        self._basis, self._R = np.linalg.qr(base)
        self._take_off()

    def _take_off(self) -> None:
        self.Q: Array = self._basis[: self.readings]
        left = self._pulled - self._basis @ (self._basis.T @ self._pulled)
        self.residual: Array = left[: self.readings]
        self.squares = float(left @ left)

    def freed(self, *effects: int) -> Freed:
        """Return the same with effects of the fit taken out: they stand in the readings, nothing else moves."""
        own = [j for i in effects for j in self.fit.problem.coefficients(i)]
        out = copy.copy(self)
        # what is orthogonal to all columns but these
        turn = Turn.of(np.linalg.solve(self._R.T, np.eye(len(self._R))[:, own]))
        out._R = turn.rest(np.delete(self._R, own, axis=1))
        put_back = self._R[:, own] @ self._departure[own]
        out._base = np.delete(self._base, own, axis=1)
        out._pulled = self._pulled + self._basis @ put_back
        out._basis = turn.rest(self._basis.T).T
        out._take_off()
        return Freed(out, turn, turn.part(self._basis.T @ out._pulled))

    def within(self, chosen: np.ndarray) -> Beside:
        """Return the same with some of the readings (R,) only; repeats of a pose must not be parted."""
        out = copy.copy(self)
        out.owner = self.owner[chosen[self.owner]]
        every = np.column_stack([self._base, self._pulled])
        kept = np.vstack([self.parted(every[: self.readings], chosen), every[self.readings :]])
        out.readings = len(out.owner)
        out._project(kept[:, :-1], kept[:, -1])
        return out

    def parted(self, rows: Array, chosen: np.ndarray) -> Array:
        """Return whitened rows (scalars, n) of some of the readings (R,)."""
        return self.fit.repeats.parted(rows, chosen[self.owner])

    def joined(self, columns: Array) -> Beside:
        """Return the same with other whitened columns (scalars, n) fitted too, free of any prior."""
        out = copy.copy(self)
        more = np.vstack([columns, np.zeros((len(self._base) - len(columns), columns.shape[1]))])
        out._base = np.hstack([self._base, more])
        for _ in range(2):  # the second takes off what rounding left of the first
            more = np.linalg.qr(more - self._basis @ (self._basis.T @ more))[0]
        out._basis = np.hstack([self._basis, more])
        out._R = out._basis.T @ out._base
        out._take_off()
        return out

    def model(self, columns: Array) -> MixedModel:
        """Return the mixed model of what is left, whose effects have whitened columns (scalars, n)."""
        inside, contrasts = self.Q.T @ columns, max(self.readings - self.Q.shape[1], 1)
        return MixedModel.normal(
            columns.T @ columns - inside.T @ inside, columns.T @ self.residual, self.squares, contrasts
        )

    def shifts(self, inside: Array) -> Array:
        """Return by how much readings shift what is fitted (n, m), of their coordinates (n, m) in the basis."""
        shift: Array = np.linalg.solve(self._R, inside)
        return shift

    def moved(self, columns: Sequence[int]) -> float:
        """Return by how much some of what is fitted moves the readings, all together, in standard deviations."""
        some = list(columns)
        return float(np.linalg.norm(self._base[: self.readings, some] @ self._departure[some]))

    def rows(self, values: Array) -> Array:
        """Return readings (R, k, n) as whitened rows (scalars, n), unread components dropped."""
        fit, out = self.fit, np.empty((int(self.read.sum()), values.shape[2]))
        for at in range(0, values.shape[2], BLOCK):
            some, fully = values[..., at : at + BLOCK], np.ones(len(values))
            out[:, at : at + BLOCK] = whitened(some, self.read, fit.sigma, fully, fit.repeats)
        return out


@dataclass(frozen=True)
class Turn:
    """An orthogonal matrix (n, n) whose first columns span a few directions, as a product of Householder's mirrors."""

    mirrors: Array
    scales: Array

    @staticmethod
    def of(directions: Array) -> Turn:
        """Return the turn for directions (n, k)."""
        mirrors, scales = np.linalg.qr(directions, mode="raw")
        own = np.triu(mirrors, 1) + np.eye(*mirrors.shape)
        return Turn(own, scales)

    def _along(self, values: Array) -> Array:
        out = np.array(values)
        for v, scale in zip(self.mirrors, self.scales, strict=True):
            out -= np.outer(scale * v, v @ out)
        return out

    def rest(self, values: Array) -> Array:
        """Return values (n, m) in the basis of what is orthogonal to the directions, (n - k, m)."""
        return self._along(values)[len(self.scales) :]

    def part(self, vector: Array) -> Array:
        """Return what of a vector (n,) lies along the directions (n,)."""
        inside = self._along(vector[:, None])
        inside[len(self.scales) :] = 0.0
        for v, scale in zip(self.mirrors[::-1], self.scales[::-1], strict=True):
            inside -= np.outer(scale * v, v @ inside)
        return inside[:, 0]


@dataclass(frozen=True)
class Freed:
    """What is fitted, less some effects.

    In the basis as it was: the basis now is what `turn` has beside its directions, and `left` (n,) is what the effects
    alone explained.
    """

    beside: Beside
    turn: Turn
    left: Array
