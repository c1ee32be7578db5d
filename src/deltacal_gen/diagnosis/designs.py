"""The readings that two explanations of one misfit differ in most: chosen one by one, then exchanged.

If one of two explanations holds, a fit of the other, with geometry and instrument free, leaves a misfit; readings are
chosen so that this misfit, expected in chi2, grows most: T-optimality (Atkinson and Fedorov 1975, Biometrika 62,
57-70), with the one of the two as the truth that is the harder to prove. What was chosen first is worth less once
others are there: each is then exchanged for the best given all others (Fedorov 1972).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term

WEAK = 1e-9  # of a column's information: holds what no reading sees, without pulling on what they do see
EXCHANGED = 250  # candidates that an exchange looks at: those that gain most
ROUNDS = 2  # of exchanges


@dataclass(frozen=True)
class Question:
    """What a diagnosis leaves open.

    Attributes
    ----------
    truth : Term
        An effect with its coefficients.
    rivals : tuple of Term
        Those that the readings cannot tell from it; their coefficients are not read.
    unrecorded : tuple of str
        Effects that could do the same through a channel that was not recorded or did not vary.
    proven : bool
        Whether the readings bear `truth` out against there being nothing.
    """

    truth: Term
    rivals: tuple[Term, ...] = ()
    unrecorded: tuple[str, ...] = ()
    proven: bool = True


class Duel:
    """A wrong model after the readings taken: what it leaves of the truth's displacement, and by which it would grow.

    Parameters
    ----------
    X, d : (M, p) and (M,) array
        Columns of the wrong model at the readings taken, and what the truth displaces there, in units of the noise.
    prior : (p,) array
        Information on each parameter that comes from elsewhere.
    more, shift : (C, k, p) and (C, k) array
        The same at readings that could be taken.
    """

    def __init__(self, X: Array, d: Array, prior: Array, more: Array, shift: Array) -> None:
        known, ahead = np.sqrt((X**2).sum(axis=0) + prior), np.abs(more).max(axis=(0, 1))
        self._size = np.where(known > 0, known, np.where(ahead > 0, ahead, 1.0))
        Z = X / self._size
        self._more, self._shift = more / self._size, shift
        self._information = Z.T @ Z + np.diag(prior / self._size**2 + WEAK)
        self._moment, self._whole = Z.T @ d, float(d @ d)
        self._inverse = np.linalg.inv(self._information)

    def __len__(self) -> int:
        return len(self._shift)

    @property
    def coefficients(self) -> Array:
        """The wrong model's best fit (p,) to the displacement."""
        fitted: Array = self._inverse @ self._moment / self._size
        return fitted

    @property
    def misfit(self) -> float:
        """The chi2 that the wrong model leaves."""
        return self._whole - float(self._moment @ self._inverse @ self._moment)

    def gains(self, some: Sequence[int]) -> Array:
        """Return by how much each of some candidates would raise the misfit."""
        Z, d = self._more[some], self._shift[some]
        count, k, p = Z.shape
        known = (Z.reshape(-1, p) @ self._inverse).reshape(count, k, p)
        unforeseen = d - known @ self._moment
        scatter = np.eye(k) + np.einsum("ckp,clp->ckl", known, Z)
        gains: Array = np.einsum("ck,ck->c", unforeseen, np.linalg.solve(scatter, unforeseen[..., None])[..., 0])
        return gains

    def take(self, j: int, sign: float = 1.0) -> None:
        """Add candidate j to the readings taken; with `sign` -1 take it back."""
        Z, d = self._more[j], self._shift[j]
        self._information = self._information + sign * Z.T @ Z
        self._moment, self._whole = self._moment + sign * Z.T @ d, self._whole + sign * float(d @ d)
        self._inverse = np.linalg.inv(self._information)


class Design(NamedTuple):
    """Candidates in the order of their worth, the misfit [chi2] that the first n bring, and how many suffice."""

    order: tuple[int, ...]
    gained: tuple[float, ...]
    needed: int


def choose(duels: Sequence[Duel], fewest: int, most: int, clear: float, further: int = 0) -> Design:
    """Return candidates that let every wrong model fail, the hardest one first thought of; and some further ones.

    Parameters
    ----------
    fewest, most : int
        How many readings.
    clear : float
        Misfit that suffices [chi2].
    """
    every, before = range(len(duels[0])), least_misfit(duels)
    chosen: list[int] = []
    while len(chosen) < min(most, len(every)) and (len(chosen) < fewest or least_misfit(duels) < before + clear):
        chosen.append(_take_best(duels, every, chosen))
    few = np.argsort(-_misfits(duels, every))[:EXCHANGED].tolist()
    for _ in range(ROUNDS):
        for old in list(chosen):
            take(duels, old, -1.0)
            chosen.remove(old)
            chosen.append(_take_best(duels, [old, *few], chosen))
    for j in chosen:
        take(duels, j, -1.0)
    order: list[int] = []
    gained: list[float] = []
    for among in [chosen] * len(chosen) + [every] * min(further, len(every) - len(chosen)):
        order.append(_take_best(duels, among, order))
        gained.append(least_misfit(duels) - before)
    enough = [n for n in range(fewest, len(chosen)) if gained[n - 1] >= clear]
    return Design(tuple(order), tuple(gained), min([*enough, len(chosen)]))


def least_misfit(duels: Iterable[Duel]) -> float:
    """Return the misfit [chi2] of the wrong model that fails least."""
    return min(d.misfit for d in duels)


def take(duels: Iterable[Duel], j: int, sign: float = 1.0) -> None:
    """Add candidate j to the readings of all duels; with `sign` -1 take it back."""
    for d in duels:
        d.take(j, sign)


def _misfits(duels: Sequence[Duel], some: Sequence[int]) -> Array:
    """Return the least misfit with each of some candidates."""
    each: Array = np.min([d.misfit + d.gains(some) for d in duels], axis=0)
    return each


def _take_best(duels: Sequence[Duel], among: Sequence[int], without: Sequence[int]) -> int:
    """Return the candidate that raises the least misfit most, which is then taken."""
    free = [j for j in among if j not in without]
    best = free[int(np.argmax(_misfits(duels, free)))]
    take(duels, best)
    return best
