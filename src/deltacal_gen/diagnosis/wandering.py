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

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.charges import MARGIN, quantile
from deltacal_gen.diagnosis.refits import terms_of
from deltacal_gen.diagnosis.structure import Displaced
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.inference.functions import walk
from deltacal_gen.inference.likelihood import MixedModel, unit_variance
from deltacal_gen.inference.sizes import Sizes, fit_sizes
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term

MODES = 24  # functions of a walk, which carry 98 % of its variance
SEEN = 1e-6  # of a unit column's square beside all that is fitted: less is a combination of that


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
    without = Beside(at).freed(*doubted).beside
    places = _columns(at, without)
    walks, owner = np.hstack([A * unit_variance(A) for A in places]), np.repeat(np.arange(len(places)), MODES)
    each = {
        i: without.rows(at.problem.term_columns([terms[i]], at.errors, at.instrument, without.machine)) for i in doubted
    }

    def given(kept: Sequence[int]) -> tuple[float, Sequence[int], MixedModel, Sizes]:
        """Return what some effects and the likeliest walks cost [deviance]."""
        own = np.hstack([np.zeros((without.readings, 0)), *(each[i] for i in kept)])
        own /= np.maximum(np.linalg.norm(own, axis=0), 1e-300)
        seen = without.model(own)
        model = without.joined(own @ seen.V[:, seen.s**2 > SEEN]).model(walks)
        sizes = fit_sizes(model, owner, prices=quantile(1, len(places)))
        return sizes.deviance + sum(prices[i] for i in kept), kept, model, sizes

    best = given(doubted)
    named = best[2].deviance(np.zeros(len(owner))) + sum(prices[i] for i in doubted)
    while best[1]:
        fewer = min((given([k for k in best[1] if k != i]) for i in best[1]), key=lambda found: found[0])
        if fewer[0] >= best[0]:
            break
        best = fewer
    cost, kept, _, sizes = best
    if len(kept) == len(doubted) or cost >= named - MARGIN:
        return set(), ()
    joints = {j + 1 if j < at.problem.mechanism.limbs else 0 for j in np.flatnonzero(sizes.variances).tolist()}
    return set(doubted) - set(kept), tuple(sorted(joints))


def _goes_with_time(term: Term) -> bool:
    """Tell whether an effect reads the time, or a channel of the whole machine."""
    return any(s.by or (s.kind == "channel" and s.per == "machine") for s in term.states)


def _columns(at: Fit, beside: Beside) -> list[Array]:
    """Return whitened columns (scalars, MODES) of a walk at each place."""
    problem = at.problem
    moved = Displaced(at, beside).columns(walk(_passed(problem), MODES))
    return list(np.moveaxis(moved, 2, 0)[: None if problem.readings.kind.positions else problem.mechanism.limbs])


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
