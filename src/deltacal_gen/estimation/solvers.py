"""Linear least squares as values: what to do with directions that the data hardly see.

Every solver works on the singular values of a matrix whose columns have been scaled to ordinary errors and whose rows
have been divided by the noise, so that a singular value reads "how many standard deviations an ordinary error in this
direction moves the readings". A solver is then a rule that gives each direction a factor between 0 (left at the
nominal value) and 1 (as the data say).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from numbers import Integral
from typing import Protocol

import numpy as np

from deltacal_gen.errors import OptionMissing, UnknownName
from deltacal_gen.machine.registry import Array

BLOCK = 1024  # rows of a tall matrix that are factored at once
WEAKEST = 1e-6  # of the largest singular value: below it a direction is seen through finite errors at most
UNSEEN = 1e-6  # of ordinary errors by the noise: what is seen so little is not seen


@dataclass(frozen=True, eq=False)
class Solution:
    """Solution of ``min |A u - b|`` under a solver's rule.

    Attributes
    ----------
    u : (n,) array
    singular_values : (min(m, n),) array
    factors : (min(m, n),) array
        What the rule left of each direction.
    V : (n, min(m, n)) array
        Right singular vectors.
    c : (min(m, n),) array
        Coordinates of b along the left singular vectors.
    covariance : (n, n) array
        Of u, for rows of unit variance: posterior where a prior acts, of the kept directions otherwise.
    rule : str
        What was done, in words.
    posterior : bool
        Whether a prior acts: what the data leave open is then uncertain as the prior has it, and not fixed.
    """

    u: Array
    singular_values: Array
    factors: Array
    V: Array
    c: Array
    covariance: Array
    rule: str
    posterior: bool = False

    @property
    def degrees(self) -> float:
        """Effective number of parameters that the data determine."""
        return float(self.factors.sum())


def jitter(diagonal: Array) -> Array:
    """Return what to add to the diagonal of normal equations so that a column of zeros has the solution zero.

    Others change by a part of 1e-12.
    """
    return np.where(diagonal > 0, 1e-12 * diagonal, 1.0)


@dataclass(frozen=True, eq=False)
class Factored:
    """Linear least squares with the factor kept: one matrix, many right-hand sides.

    Parameters
    ----------
    J : (m, n) array
        Rows divided by their noise.
    prior : (n,) array
        Inverse variance of each unknown; 0 where nothing is known of it.

    Attributes
    ----------
    covariance : (n, n) array
        Of the unknowns, for rows of unit variance. Directions that neither rows nor prior determine stay as they are.
    gain : (n, m) array
        By which a right-hand side is multiplied.
    """

    J: Array
    prior: Array

    @cached_property
    def _inverse(self) -> tuple[Array, Array]:
        whole = np.vstack([self.J, np.diag(np.sqrt(self.prior))[self.prior > 0]])
        size = np.sqrt((whole**2).sum(axis=0))
        size = np.where(size > 0, size, 1.0)  # columns of one length: the condition number is then the least
        U, s, Vt = np.linalg.svd(whole / size, full_matrices=False)
        kept = s > WEAKEST * s[0] if len(s) else s > 0
        back = Vt[kept].T / (s[kept] * size[:, None])
        return back @ back.T, back @ U[: len(self.J), kept].T

    @property
    def covariance(self) -> Array:
        """Of the unknowns (n, n); see the class."""
        return self._inverse[0]

    @property
    def gain(self) -> Array:
        """By which a right-hand side is multiplied (n, m); see the class."""
        return self._inverse[1]

    def step(self, residual: Array, u: Array | None = None) -> Array:
        """Return by how much (T, n) the unknowns move for residuals (T, m), the prior drawing them back from u (T, n).

        One step solves a linear problem; more of them, with residuals of the exact machine, an almost linear one.
        """
        step: Array = residual @ self.gain.T
        return step if u is None else step - (self.prior * u) @ self.covariance


class Solver(Protocol):
    """A rule for weak directions.

    `weight` is what the rule adds to the sum of squares, per square of u; None where it minimises no objective.
    """

    @property
    def weight(self) -> float | None:
        """What the rule adds to the sum of squares, per square of u; None where it minimises no objective."""

    def solve(self, A: Array, b: Array, sigma: float = 1.0, rows: int | None = None) -> Solution:
        """Return the solution of ``min |A u - b|``, A (m, n) scaled as the module says, b (m,).

        `sigma` is the noise [mm] by which the rows were divided; `rows` says of how many A and b are the triangle.
        """
        ...

    def settled(self, solution: Solution) -> Solver:
        """Return the rule with its choice made as in `solution`: an iteration must not choose anew at every step."""
        ...


def triangle(A: Array) -> Array:
    """Return R (n, n) of a tall matrix's QR factorisation, in blocks of rows that stay in the processor's cache."""
    n, blocks = A.shape[1], len(A) // BLOCK
    if blocks < 2 or 2 * n > BLOCK:
        return np.asarray(np.linalg.qr(A, mode="r"))
    of_blocks = np.asarray(np.linalg.qr(A[: blocks * BLOCK].reshape(blocks, BLOCK, n), mode="r"))
    return np.asarray(np.linalg.qr(np.vstack([of_blocks.reshape(-1, n), A[blocks * BLOCK :]]), mode="r"))


def _factored(A: Array, b: Array, rule: Callable[[Array, Array, float], tuple[Array, Array, str]]) -> Solution:
    whole = float(b @ b)
    n = A.shape[1]
    if len(A) > 2 * (n + 1):  # the triangle of a tall matrix has the same singular values and products with b
        R = triangle(np.column_stack([A, b]))
        A, b = R[:, :n], R[:, n]
    U, s, Vt = np.linalg.svd(A, full_matrices=False)
    c = U.T @ b
    rest = whole - float(c @ c)
    factors, variance, words = rule(s, c, max(rest, 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        amplitude = np.where(factors > 0, factors * c / s, 0.0)
    return Solution(Vt.T @ amplitude, s, factors, Vt.T, c, (Vt.T * variance) @ Vt, words)


def _kept(s: Array, keep: np.ndarray, words: str) -> tuple[Array, Array, str]:
    with np.errstate(divide="ignore"):
        return keep.astype(float), np.where(keep, 1.0 / s**2, 0.0), words


@dataclass(frozen=True)
class LeastSquares:
    """Least squares of minimum norm: directions below `rcond` of the largest singular value stay at nominal.

    So do those that no reading sees at all, where the largest is but rounding: noise would move them without end.
    """

    rcond: float = WEAKEST

    @property
    def weight(self) -> float:
        """Nothing is added."""
        return 0.0

    def solve(self, A: Array, b: Array, sigma: float = 1.0, rows: int | None = None) -> Solution:
        """See `Solver`."""

        def rule(s: Array, c: Array, rest: float) -> tuple[Array, Array, str]:
            keep = s > max(self.rcond * s[0], UNSEEN) if len(s) else s > 0
            return _kept(s, keep, f"least squares, {int(keep.sum())} of {len(s)} directions")

        return _factored(A, b, rule)

    def settled(self, solution: Solution) -> Solver:
        """Nothing was chosen."""
        return self


@dataclass(frozen=True)
class TSVD:
    """Truncated SVD (Mei 2018, section 3): the weakest directions stay at nominal.

    Parameters
    ----------
    truncation : int or {"discrepancy", "gcv"}
        How many directions to keep; or the fewest whose residual is no larger than the noise (Morozov), or the
        number that minimises generalised cross-validation (Golub, Heath, Wahba 1979).
    noise : float, optional
        Standard deviation of the readings [mm], known beforehand: what the discrepancy principle measures against.
    chosen_by : str
        Where a given number comes from, in a word.
    """

    truncation: int | str = "gcv"
    noise: float | None = None
    chosen_by: str = "given"

    def __post_init__(self) -> None:
        if isinstance(self.truncation, Integral) and self.truncation >= 0:
            object.__setattr__(self, "truncation", int(self.truncation))  # one of NumPy too
        elif self.truncation not in ("discrepancy", "gcv"):
            raise UnknownName(f"truncation '{self.truncation}' is not known; give a number, 'discrepancy' or 'gcv'.")
        if self.truncation == "discrepancy" and self.noise is None:
            raise OptionMissing("the discrepancy principle needs a known noise: give sigma_mm in the sidecar.")

    @property
    def weight(self) -> None:
        """A truncation minimises no objective."""

    def solve(self, A: Array, b: Array, sigma: float = 1.0, rows: int | None = None) -> Solution:
        """See `Solver`."""
        m = len(b) if rows is None else rows

        def rule(s: Array, c: Array, rest: float) -> tuple[Array, Array, str]:
            usable = int((s > WEAKEST * s[0]).sum()) if len(s) else 0
            left = rest + np.concatenate([[c @ c], c @ c - np.cumsum(c**2)])[: usable + 1]
            if isinstance(self.truncation, int):
                k = min(self.truncation, usable)
            elif self.truncation == "discrepancy":
                small = np.flatnonzero(left <= m * ((self.noise or 0.0) / sigma) ** 2)
                k = int(small[0]) if len(small) else usable
            else:
                k = int(np.argmin(left / np.maximum(m - np.arange(usable + 1), 1e-300) ** 2))
            how = self.chosen_by if isinstance(self.truncation, int) else self.truncation
            return _kept(s, np.arange(len(s)) < k, f"truncated SVD, {k} of {len(s)} directions kept ({how})")

        return _factored(A, b, rule)

    def settled(self, solution: Solution) -> Solver:
        """Keep as many directions as `solution` kept."""
        how = self.chosen_by if isinstance(self.truncation, int) else self.truncation
        return TSVD(int(solution.factors.sum()), self.noise, how)


@dataclass(frozen=True)
class Ridge:
    """Ridge (Tikhonov): every parameter drawn to nominal with weight `strength`; None chooses it by GCV."""

    strength: float | None = None

    @property
    def weight(self) -> float | None:
        """The square of the strength, where it is given."""
        return None if self.strength is None else self.strength**2

    def solve(self, A: Array, b: Array, sigma: float = 1.0, rows: int | None = None) -> Solution:
        """See `Solver`."""
        m = len(b) if rows is None else rows

        def rule(s: Array, c: Array, rest: float) -> tuple[Array, Array, str]:
            strength = self.strength
            if strength is None:
                candidates = s[0] * np.logspace(-10, 0, 81)
                f = s**2 / (s**2 + candidates[:, None] ** 2)
                score = (rest + (((1 - f) * c) ** 2).sum(axis=1)) / (m - f.sum(axis=1)) ** 2
                strength = float(candidates[int(np.argmin(score))])
            damped = np.maximum(s**2 + strength**2, 1e-300)
            return s**2 / damped, s**2 / damped**2, f"ridge, strength {strength:.3g}"

        return _factored(A, b, rule)

    def settled(self, solution: Solution) -> Solver:
        """Keep the strength that `solution` was found with."""
        s, f = solution.singular_values, solution.factors
        j = int(np.argmin(np.abs(f - 0.5)))
        if not 0 < f[j] < 1:
            return self
        return Ridge(float(s[j] * np.sqrt(1 / f[j] - 1)))


@dataclass(frozen=True)
class Prior:
    """Each parameter is known beforehand to its standard deviation: the columns are scaled to those, A = J sd / sigma.

    The posterior covariance is honest for every direction: where the data say nothing the prior's own is left.

    Parameters
    ----------
    words : str
        What the solution's `rule` says of it; no figure depends on them.
    """

    words: str = "priors"

    @property
    def weight(self) -> float:
        """One: u counts standard deviations off the prior."""
        return 1.0

    def solve(self, A: Array, b: Array, sigma: float = 1.0, rows: int | None = None) -> Solution:
        """See `Solver`."""

        def rule(s: Array, c: Array, rest: float) -> tuple[Array, Array, str]:
            return s**2 / (s**2 + 1), 1 / (s**2 + 1), self.words

        solution = _factored(A, b, rule)
        missing = np.eye(A.shape[1]) - solution.V @ solution.V.T  # directions beyond the rows: prior alone
        return dataclasses.replace(solution, covariance=solution.covariance + missing, posterior=True)

    def settled(self, solution: Solution) -> Solver:
        """Nothing was chosen."""
        return self
