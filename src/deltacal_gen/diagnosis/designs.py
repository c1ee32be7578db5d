"""The readings that two explanations of one misfit differ in most: chosen one by one, then exchanged.

If one of two explanations holds, a fit of the other beside geometry and instrument leaves a misfit; readings are chosen
so that this misfit, expected in chi2, grows most: T-optimality (Atkinson and Fedorov 1975, Biometrika 62, 57-70), with
the one of the two as the truth that is the harder to prove. What was chosen first is worth less beside what came later:
each is then exchanged for the best that there is beside all others (Fedorov 1972).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from deltacal_gen.machine.registry import Array

WEAK = 1e-9  # of a column's information: holds what no reading sees, without pulling on what they do see
EXCHANGED = 250  # candidates that an exchange looks at: those that tell most
ROUNDS = 2  # of exchanges
WORTH = 0.01  # of the misfit: an exchange that gains less is none


class Refutation:
    """What a wrong model leaves of a displacement, and by how much further readings would raise it.

    Parameters
    ----------
    X : (M, p) array
        Columns of the wrong model, in units of the noise.
    d : (M,) array
        What the true one displaces, in units of the noise.
    prior : (p,) array
        Information on each parameter that comes from elsewhere.
    unseen : (p,) array, optional
        Sizes of columns that neither readings nor a prior know: what they are in readings to come.
    """

    def __init__(self, X: Array, d: Array, prior: Array, unseen: Array | None = None) -> None:
        known = np.sqrt((X**2).sum(axis=0) + prior)
        other = np.ones_like(known) if unseen is None else np.where(unseen > 0, unseen, 1.0)
        self._size = np.where(known > 0, known, other)
        Z = X / self._size
        self._information = Z.T @ Z + np.diag(prior / self._size**2 + WEAK)
        self._moment, self._whole = Z.T @ d, float(d @ d)
        self._inverse = np.linalg.inv(self._information)

    @property
    def coefficients(self) -> Array:
        """Return the wrong model's best fit (p,) to the displacement."""
        fitted: Array = self._inverse @ self._moment / self._size
        return fitted

    @property
    def misfit(self) -> float:
        """Return the chi2 that the wrong model leaves."""
        return self._whole - float(self._moment @ self._inverse @ self._moment)

    def gains(self, X: Array, d: Array) -> Array:
        """Return by how much each of C readings, columns (C, k, p) and displacements (C, k), would raise the misfit."""
        count, k, p = X.shape
        Z = X / self._size
        known = (Z.reshape(-1, p) @ self._inverse).reshape(count, k, p)
        unforeseen = d - known @ self._moment
        scatter = np.eye(k) + np.einsum("ckp,clp->ckl", known, Z)
        gains: Array = np.einsum("ck,ck->c", unforeseen, np.linalg.solve(scatter, unforeseen[..., None])[..., 0])
        return gains

    def take(self, X: Array, d: Array, sign: float = 1.0) -> None:
        """Add one reading (k, p), (k,); with `sign` -1 take it back."""
        Z = X / self._size
        self._information = self._information + sign * Z.T @ Z
        self._moment, self._whole = self._moment + sign * Z.T @ d, self._whole + sign * float(d @ d)
        self._inverse = np.linalg.inv(self._information)


class Duel(NamedTuple):
    """A wrong model beside the readings taken, and its columns (C, k, p) and what it cannot follow (C, k) at others."""

    wrong: Refutation
    X: Array
    shift: Array

    def take(self, j: int, sign: float = 1.0) -> None:
        """Add candidate j, or take it back."""
        self.wrong.take(self.X[j], self.shift[j], sign)


class Chosen(NamedTuple):
    """Candidates in the order of their worth, the misfit [chi2] that the first n bring, and how many suffice."""

    order: tuple[int, ...]
    gained: tuple[float, ...]
    needed: int


def choose(duels: Sequence[Duel], fewest: int, most: int, clear: float, further: int = 0) -> Chosen:
    """Return candidates that let every wrong model fail, the hardest one first thought of; and some further ones.

    Parameters
    ----------
    fewest, most : int
        How many readings.
    clear : float
        Misfit that suffices [chi2].
    """
    count = len(duels[0].shift)
    before = _least(duels)
    chosen: list[int] = []
    while len(chosen) < min(most, count) and (len(chosen) < fewest or _least(duels) < before + clear):
        chosen.append(_best(duels, range(count), chosen))
        _take(duels, chosen[-1])
    most_telling = _best_few(duels, count, chosen)
    for _ in range(ROUNDS):
        if not sum(_exchange(duels, chosen, n, most_telling, before) for n in range(len(chosen))):
            break
    for j in sorted(chosen, key=lambda j: _without(duels, j), reverse=True):  # those that are no longer needed
        if len(chosen) <= fewest or _without(duels, j) < before + clear:
            break
        _take(duels, j, -1.0)
        chosen.remove(j)
    for j in chosen:
        _take(duels, j, -1.0)
    order, gained = _ordered(duels, chosen, before)
    while len(order) < min(len(chosen) + further, count):
        order.append(
            _best(duels, most_telling, order) if len(most_telling) > further else _best(duels, range(count), order)
        )
        _take(duels, order[-1])
        gained.append(_least(duels) - before)
    return Chosen(tuple(order), tuple(gained), len(chosen))


def _ordered(duels: Sequence[Duel], chosen: Sequence[int], before: float) -> tuple[list[int], list[float]]:
    """Return candidates, none of which is taken, in the order of what each adds to those before it; all are taken."""
    order: list[int] = []
    gained: list[float] = []
    while len(order) < len(chosen):
        order.append(_best(duels, [j for j in chosen if j not in order], ()))
        _take(duels, order[-1])
        gained.append(_least(duels) - before)
    return order, gained


def _least(duels: Sequence[Duel]) -> float:
    return min(d.wrong.misfit for d in duels)


def _take(duels: Sequence[Duel], j: int, sign: float = 1.0) -> None:
    for d in duels:
        d.take(j, sign)


def _after(duels: Sequence[Duel], among: Sequence[int]) -> Array:
    """Return the least misfit with each of some candidates."""
    some = np.asarray(among, dtype=int)
    each: Array = np.min([d.wrong.misfit + d.wrong.gains(d.X[some], d.shift[some]) for d in duels], axis=0)
    return each


def _best(duels: Sequence[Duel], among: Sequence[int], without: Sequence[int]) -> int:
    free = [j for j in among if j not in without]
    return free[int(np.argmax(_after(duels, free)))]


def _best_few(duels: Sequence[Duel], count: int, chosen: Sequence[int]) -> list[int]:
    after = _after(duels, range(count))
    few: list[int] = np.argsort(-after)[:EXCHANGED].tolist()
    return [j for j in few if j not in chosen]


def _without(duels: Sequence[Duel], j: int) -> float:
    """Return the least misfit without a candidate that is taken."""
    _take(duels, j, -1.0)
    left = _least(duels)
    _take(duels, j)
    return left


def _exchange(duels: Sequence[Duel], chosen: list[int], n: int, among: Sequence[int], before: float) -> bool:
    """Put a better candidate for the n-th that is chosen, if there is one; tell whether there was."""
    now, old = _least(duels), chosen[n]
    _take(duels, old, -1.0)
    new = _best(duels, among, chosen) if len(among) > len(chosen) else old
    if float(_after(duels, [new])[0]) <= now + WORTH * max(now - before, 0.0):
        new = old
    _take(duels, new)
    chosen[n] = new
    return new != old
