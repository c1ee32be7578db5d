"""What a law's form leaves of its own states: a smooth remainder, as large as the readings have it, beside the law.

A law is written with few functions, for few readings tell curves apart; nature's curve is mostly none of them. What the
form leaves of it is too little to be told, but not to be predicted: along each of its states, times what the law does
along the others, a sum of bumps is drawn by chance, and its size is the likeliest beside everything that is fitted. The
constants within the law stay. It is zero where there were no readings, and none where it does not pay for its size.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.components import Components, Sizes, of_noise
from deltacal_gen.diagnosis.laws.ground import Ground, Tried
from deltacal_gen.diagnosis.laws.shape import Part, curves_of, of_parts
from deltacal_gen.diagnosis.refits import terms_of
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.law import load_law
from deltacal_gen.physics.terms import Term

BUMPS = (5, 9)  # over the width of a state, each as wide as they are apart
PRICE = 2.0  # of the deviance (Akaike): what a size has to earn that serves predictions and claims nothing


@dataclass(frozen=True)
class _Rest:
    """Bumps along a state of a term of a law, and what they do to the readings, by the noise of which they are."""

    term: Term
    columns: Array
    scale: float


def with_remainder(at: Fit, law: Sequence[Tried]) -> Fit:
    """Return a fit whose last terms are a law, with what their forms leave of their states after them.

    Parameters
    ----------
    law : sequence of Tried
        With the constants that the terms have.
    """
    ground, first = Ground(at), len(terms_of(at)) - len(law)
    best, found, rests = np.inf, Sizes(), list[_Rest]()
    for count in BUMPS:
        each = enumerate(zip(law, terms_of(at)[first:], strict=True), first)
        tried = [r for i, (t, term) in each for r in _rests(ground, ground.freed(i), t, term, count)]
        if not tried:
            return at
        sizes, deviance = Components.of([r.columns for r in tried], ground.beside, PRICE).likeliest()
        if deviance < best:
            best, found, rests = deviance, sizes, tried
    kept = [(rests[k], size**0.5 * rests[k].scale) for k, size in found.items()]
    return _joint(at, [r.term for r, _ in kept], [std for _, std in kept]) if kept else at


def _rests(ground: Ground, freed: Ground, tried: Tried, term: Term, count: int) -> Iterator[_Rest]:
    """Yield the bumps along each state of a term of a law, times its curves of the others."""
    module, place = load_law(term.effect), ground.place(tried.target)
    curves = (None if module.lags else curves_of(freed, tried)) or ()
    ends = dict(zip(module.STATE, module.ends(term.constants).tolist(), strict=True))
    for k, curve in enumerate(curves):
        others: list[Part] = [(c.text, c.constants) for c in (*curves[:k], *curves[k + 1 :])]
        low, high = ends[curve.state]
        form = of_parts([[bump, *others] for bump in _bumps(curve.state, low, high, count)], module.STATE)
        C = ground.columns(place, ground.values(form))[:, :, [i - 1 for i in tried.limbs] or [0]]
        columns = np.swapaxes(C, 1, 2).reshape(len(C), -1)
        scale, blank = of_noise(columns), ground.term(tried.target, form, tried.limbs)
        yield _Rest(blank.with_values(np.zeros(blank.n_coefficients)), columns * scale, scale)


def _bumps(state: str, low: float, high: float, count: int) -> list[Part]:
    """Return bumps of a state, evenly spread between its ends."""
    width = (high - low) / (count - 1)
    return [(f"exp(-(({state} - {{0}})/{{1}})**2)", (float(at), width)) for at in np.linspace(low, high, count)]


def _joint(at: Fit, more: Sequence[Term], std: Sequence[float]) -> Fit:
    """Return the joint fit with more terms, each coefficient of one drawn from a normal distribution of its own."""
    n = len(at.problem.names)
    of_more = [np.full(t.n_coefficients, s) for t, s in zip(more, std, strict=True)]
    problem = at.problem.with_terms([*terms_of(at), *more], np.concatenate([at.problem.scale[n:], *of_more]))
    try:
        return fit(
            problem,
            Prior(),
            errors=np.concatenate([at.errors, *map(np.zeros_like, of_more)]),
            machine=at.machine,
            instrument=at.instrument,
            repeats=None if at.repeats.plain else at.repeats,
            drop_gross=False,
            must_converge=False,
        )
    except (NoSolutionError, InputError):
        return at
