"""What wanders: a walk of each joint, and of the instrument, is the rival of whatever is named with time.

A belt that creeps, a screw that works loose, a joint that settles anew at every stop, a stand that gives: none follows
a function of time, and any few functions of time that a search may combine follow some of it. No noise of readings is
like it, for it moves them as the joint does, or turns them all. A walk is drawn by chance (Brownian, by the functions
of Karhunen and Loeve), with one size for each joint, and for each axis that the instrument shifts along or turns about:
the likeliest by what is left beside geometry and instrument (a variance component; Patterson and Thompson 1971). It
pays for its size alone, an effect for what had to be said of it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.search import quantile
from deltacal_gen.diagnosis.strategy import MARGIN, terms_of
from deltacal_gen.diagnosis.structure import by_instrument
from deltacal_gen.estimation.fit import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term

MODES = 24  # functions of a walk, which carry 98 % of its variance
SIZES = np.geomspace(0.1, 1e6, 15)  # of the variance that a walk brings the readings of, in those of their noise
SWEEPS = 3  # over all joints, in which their sizes settle beside one another
EXACT = 1e-12  # of a sum of squares: what rounding leaves of it
UNSEEN = 1e-6  # of a unit column's square beside all that is fitted: less is a combination of that


def following_walks(at: Fit, prices: Mapping[int, float]) -> tuple[set[int], tuple[int, ...]]:
    """Return the effects of a fit that only follow walks, and which joints (from 1) wander; 0 is the instrument.

    Parameters
    ----------
    prices : mapping
        What effects had to earn, by their place in the fit [chi2]. Those are asked that read the time, or a channel of
        the whole machine; laws likewise.
    """
    terms, found = terms_of(at), at.problem.readings
    doubted = [i for i in prices if _goes_with_time(terms[i])]
    if not doubted or found.rows.shape[1] != 1 or len(found) < MODES:
        return set(), ()
    ground = _Ground.of(at, doubted)
    owed = [prices[i] for i in doubted]
    kept = list(range(len(doubted)))
    named = ground.cost(kept) + sum(owed)
    walks, cost = ground.likeliest(kept)
    best = cost + sum(owed)
    while kept:
        tried = []
        for i in kept:
            others = [k for k in kept if k != i]
            beside, cost = ground.likeliest(others, walks)
            tried.append((cost + sum(owed[k] for k in others), others, beside))
        least, others, beside = min(tried, key=lambda t: t[0])
        if least >= best:
            break
        best, kept, walks = least, others, beside
    if len(kept) == len(doubted) or best >= named - MARGIN:
        return set(), ()
    joints = {place + 1 if place < at.problem.mechanism.limbs else 0 for place, _ in walks}
    return {i for k, i in enumerate(doubted) if k not in kept}, tuple(sorted(joints))


def _goes_with_time(term: Term) -> bool:
    """Tell whether an effect reads the time, or a channel of the whole machine."""
    return any(s.by or (s.kind == "channel" and s.per == "machine") for s in term.states)


Walks = tuple[tuple[int, float], ...]  # places, from 0: joints, then axes of the instrument; the size of each one's


@dataclass(frozen=True)
class _Ground:
    """Normal equations of effects and walks beside everything else that is fitted.

    Attributes
    ----------
    G, b : (n, n), (n,) arrays
        The effects' columns first, then `MODES` of each place, each walk's of unit variance of the readings.
    rest, least : float
        Sum of squares that is left without them, and what rounding leaves of that where all is explained.
    degrees : int
        Scalars, less what is fitted.
    owner : (n_e,) array of int
        Which effect each of the first columns belongs to.
    """

    G: Array
    b: Array
    rest: float
    least: float
    degrees: int
    owner: np.ndarray

    @staticmethod
    def of(at: Fit, effects: Sequence[int]) -> _Ground:
        beside = Beside(at).freed(*effects).beside
        terms = [terms_of(at)[i] for i in effects]
        own = beside.rows(at.problem.term_columns(terms, at.errors, at.instrument, beside.machine))
        walks = _columns(at, beside)
        C = np.hstack([own / np.maximum(np.linalg.norm(own, axis=0), 1e-300), walks])
        C -= beside.Q @ (beside.Q.T @ C)
        r, owner = beside.residual, np.repeat(np.arange(len(terms)), [t.n_coefficients for t in terms])
        left = float(r @ r)
        return _Ground(C.T @ C, r @ C, left, max(EXACT * left, 1e-300), max(len(r) - beside.Q.shape[1], 1), owner)

    @property
    def places(self) -> int:
        return (len(self.b) - len(self.owner)) // MODES

    def cost(self, kept: Sequence[int]) -> float:
        """Return twice the negative logarithm of the likelihood beside some effects, without any walk."""
        return self._beside(kept)._deviance(())

    def likeliest(self, kept: Sequence[int], walks: Walks = ()) -> tuple[Walks, float]:
        """Return the walks that are likeliest beside some effects, sought from some on, and `cost` with their price."""
        ground = self._beside(kept)
        has, best = dict(walks), ground._deviance(walks)
        for _ in range(SWEEPS):
            before = best
            for j in range(self.places):
                tried = [{**has, j: float(s)} for s in SIZES] + [{k: s for k, s in has.items() if k != j}]
                costs = [ground._deviance(tuple(t.items())) for t in tried]
                k = int(np.argmin(costs))
                if costs[k] < best:
                    has, best = tried[k], costs[k]
            if best > before - 1.0:
                break
        return tuple(has.items()), best

    def _beside(self, kept: Sequence[int]) -> _Ground:
        """Return the normal equations of the walks alone, some of the effects fitted."""
        n = len(self.owner)
        some = np.flatnonzero(np.isin(self.owner, list(kept)))
        G, b, rest, rank = self.G[n:, n:], self.b[n:], self.rest, 0
        if len(some):
            size, V = np.linalg.eigh(self.G[np.ix_(some, some)])
            seen = size > UNSEEN
            half = V[:, seen] / np.sqrt(size[seen])
            across, along = self.G[n:, some] @ half, self.b[some] @ half
            G, b, rank = G - across @ across.T, b - across @ along, int(seen.sum())
            rest = max(rest - float(along @ along), self.least)
        return replace(self, G=G, b=b, rest=rest, degrees=max(self.degrees - rank, 1), owner=self.owner[:0])

    def _deviance(self, walks: Walks) -> float:
        if not walks:
            return self.degrees * float(np.log(max(self.rest, self.least)))
        own = np.concatenate([j * MODES + np.arange(MODES) for j, _ in walks])
        d = np.repeat(np.sqrt([s for _, s in walks]), MODES)
        L = np.linalg.cholesky(self.G[np.ix_(own, own)] * d * d[:, None] + np.eye(len(own)))
        z = np.linalg.solve(L, self.b[own] * d)
        left = max(self.rest - float(z @ z), self.least)
        price = len(walks) * quantile(1, self.places)
        return self.degrees * float(np.log(left)) + 2 * float(np.log(np.diag(L)).sum()) + price


def _columns(at: Fit, beside: Beside) -> Array:
    """Return whitened columns (scalars, places * MODES) of a walk at each place, of unit variance of the readings."""
    problem, machine = at.problem, beside.machine
    k = np.arange(MODES) + 0.5
    functions = np.sin(np.pi * k * _passed(problem)[:, None]) * np.sqrt(2) / (np.pi * k)
    dx, seen = problem.displacements(machine)[:, :, : problem.mechanism.limbs], problem.seen(machine)
    each = []
    for j in range(dx.shape[2]):
        J, _ = at.instrument.linearise(problem.readings, seen, dx[:, :, j : j + 1] * functions[:, None, :])
        each.append(beside.rows(J))
    if problem.readings.kind.positions:
        moved = by_instrument(at, beside, functions[problem.readings.rows[:, 0]])
        each.extend(np.moveaxis(moved.reshape(len(moved), MODES, -1), 2, 0))
    return np.hstack([A / max(float(np.sqrt((A**2).sum() / len(A))), 1e-300) for A in each])


def _passed(problem: Problem) -> Array:
    """Return which part of the time has passed at every row (N,), sessions one after another; 0 where it is unknown."""
    body, used = problem.body, np.unique(problem.readings.rows)
    out, before = np.zeros(len(body.q)), 0.0
    for session in np.unique(body.session[used]):
        rows = used[body.session[used] == session]
        clock = body.channels.clock[rows]
        if np.isfinite(clock).any():
            out[rows] = before + np.nan_to_num(clock - np.nanmin(clock))
            before = float(out[rows].max())
    return out / max(before, 1e-300)
