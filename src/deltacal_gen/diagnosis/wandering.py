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
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.charges import MARGIN, quantile
from deltacal_gen.diagnosis.components import Components, of_noise, with_fitted
from deltacal_gen.diagnosis.refits import terms_of
from deltacal_gen.diagnosis.structure import by_instrument
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term

MODES = 24  # functions of a walk, which carry 98 % of its variance


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
    whole = ground.beside(kept)
    named = whole.deviance({}) + sum(owed)
    walks, cost = whole.likeliest()
    best = cost + sum(owed)
    while kept:
        tried = []
        for i in kept:
            others = [k for k in kept if k != i]
            beside, cost = ground.beside(others).likeliest(walks)
            tried.append((cost + sum(owed[k] for k in others), others, beside))
        least, others, beside = min(tried, key=lambda t: t[0])
        if least >= best:
            break
        best, kept, walks = least, others, beside
    if len(kept) == len(doubted) or best >= named - MARGIN:
        return set(), ()
    joints = {place + 1 if place < at.problem.mechanism.limbs else 0 for place in walks}
    return {i for k, i in enumerate(doubted) if k not in kept}, tuple(sorted(joints))


def _goes_with_time(term: Term) -> bool:
    """Tell whether an effect reads the time, or a channel of the whole machine."""
    return any(s.by or (s.kind == "channel" and s.per == "machine") for s in term.states)


@dataclass(frozen=True)
class _Ground:
    """What is fitted without some effects, their columns, and walks of all places: joints, axes of the instrument.

    Attributes
    ----------
    without : Beside
    effects : (scalars, n_e) array
    owner : (n_e,) array of int
        Which effect each of them belongs to.
    walks : list of (scalars, MODES) arrays
        Each brings the readings the variance of their noise.
    """

    without: Beside
    effects: Array
    owner: np.ndarray
    walks: list[Array]

    @staticmethod
    def of(at: Fit, effects: Sequence[int]) -> _Ground:
        without = Beside(at).freed(*effects).beside
        terms = [terms_of(at)[i] for i in effects]
        own = without.rows(at.problem.term_columns(terms, at.errors, at.instrument, without.machine))
        owner = np.repeat(np.arange(len(terms)), [t.n_coefficients for t in terms])
        return _Ground(without, own, owner, [A * of_noise(A) for A in _columns(at, without)])

    def beside(self, kept: Sequence[int]) -> Components:
        """Return the walks beside some of the effects."""
        own = self.effects[:, np.isin(self.owner, list(kept))]
        return Components.of(self.walks, with_fitted(self.without, own), quantile(1, len(self.walks)))


def _columns(at: Fit, beside: Beside) -> list[Array]:
    """Return whitened columns (scalars, MODES) of a walk at each place."""
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
    return each


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
