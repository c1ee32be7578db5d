"""What a law's form leaves of its own states: a smooth remainder, as large as the readings have it, beside the law.

A law is written with few functions, for few readings tell curves apart; nature's curve is mostly none of them. What the
form leaves of it is too little to be told, but not to be predicted: along each of its states, times what the law does
along the others, a sum of bumps, or of bends, is drawn by chance, and its size is the likeliest beside everything that
is fitted. The constants within the law stay. Bumps are zero where there were no readings, bends go on straight as laws
do; there is none of either where it does not pay for its size. What else the limb and the machine have may change what
a law does, too little to be told: so are bumps of each such state, alone and times the law, of which one that is chosen
pays for the choice as well.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from deltacal_gen.diagnosis.laws.ground import Ground, Tried, on
from deltacal_gen.diagnosis.laws.shape import Part, curves_of, of_parts
from deltacal_gen.diagnosis.refits import terms_of
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.inference.likelihood import unit_variance
from deltacal_gen.inference.sizes import fit_sizes
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.grammar import Curve, Form, renumbered, switch
from deltacal_gen.physics.law import load_law
from deltacal_gen.physics.terms import Term
from deltacal_gen.states import named

COUNTS = (5, 9)  # of bumps, and of bends, over the width of a state, each as wide as they are apart
PRICE = 2.0  # of the deviance (Akaike): what a size has to earn that serves predictions and claims nothing
ANY = 3  # bumps of a state that a law does not read


@dataclass(frozen=True)
class _Rest:
    """Functions of a state at a term of a law, and what they do to the readings, by the noise of which they are.

    `chosen` are those of a state that the law does not read.
    """

    term: Term
    columns: Array
    scale: float
    chosen: bool = False


def with_remainder(at: Fit, law: Sequence[Tried]) -> Fit:
    """Return a fit whose last terms are a law, with what their forms leave of their states after them.

    Parameters
    ----------
    law : sequence of Tried
        With the constants that the terms have.
    """
    ground, first = Ground(at), len(terms_of(at)) - len(law)
    each = [
        (ground.freed(i), t, term) for i, (t, term) in enumerate(zip(law, terms_of(at)[first:], strict=True), first)
    ]
    others = [r for freed, t, term in each for r in _others(ground, freed, t, term)]
    best, kept = np.inf, list[tuple[_Rest, float]]()
    for count in COUNTS:
        tried = [*(r for freed, t, term in each for r in _rests(ground, freed, t, term, count)), *others]
        if not tried:
            return at
        prices = [PRICE + 2 * float(np.log(max(len(others), 1))) * r.chosen for r in tried]
        owner = np.repeat(np.arange(len(tried)), [r.columns.shape[1] for r in tried])
        found = fit_sizes(ground.beside.model(np.hstack([r.columns for r in tried])), owner, prices=np.array(prices))
        if found.deviance < best:
            best = found.deviance
            kept = [(r, s**0.5 * r.scale) for r, s in zip(tried, found.variances.tolist(), strict=True) if s]
    return _joint(at, [r.term for r, _ in kept], [std for _, std in kept]) if kept else at


def _rests(ground: Ground, freed: Ground, tried: Tried, term: Term, count: int) -> Iterator[_Rest]:
    """Yield bumps, and bends, along each state of a term of a law, times its curves of the others."""
    module = load_law(term.effect)
    curves = (None if module.lags else curves_of(freed, tried)) or ()
    ends = dict(zip(module.STATE, module.ends(term.constants).tolist(), strict=True))
    for k, curve in enumerate(curves):
        others: list[Part] = [(c.text, c.constants) for c in (*curves[:k], *curves[k + 1 :])]
        low, high = ends[curve.state]
        for along in (_bumps, _bends):
            parts = along(curve.state, low, high, count)
            yield _rest(ground, tried, of_parts([[part, *others] for part in parts], module.STATE))


def _others(ground: Ground, freed: Ground, tried: Tried, term: Term) -> Iterator[_Rest]:
    """Yield bumps along each state that a term of a law does not read, alone and times the law about its mean.

    Those are of the limb itself, or of the machine as a whole; where neither is, and of other joints, there are many.
    """
    module = load_law(term.effect)
    curves = (None if module.lags else curves_of(freed, tried)) or ()
    laws: list[list[Part]] = [[], [_about_mean(ground, tried, curves)]] if curves else [[]]
    for name in ground.readable(ground.place(tried.target)):
        if name in module.STATE or named(name).joint or named(name).kind == "place":
            continue
        v = ground.states[name]
        v = v[:, [i - 1 for i in tried.limbs]] if v.ndim == 2 and tried.limbs else v
        bumps = [(name, ())] if switch(v) else _bumps(name, float(v.min()), float(v.max()), ANY)
        for law in laws:
            form = of_parts([[bump, *law] for bump in bumps], [*module.STATE, name] if law else [name])
            yield replace(_rest(ground, tried, form), chosen=True)


def _about_mean(ground: Ground, tried: Tried, curves: Sequence[Curve]) -> Part:
    """Return a product of curves, less its mean over the readings."""
    texts, constants = list[str](), list[float]()
    for c in curves:
        texts.append(renumbered(c.text, len(constants)))
        constants += c.constants
    v = ground.values(of_parts([[("*".join(texts), (*constants,))]], [c.state for c in curves]))
    own = v[:, [i - 1 for i in tried.limbs]] if v.shape[1] > 1 and tried.limbs else v
    return f"({'*'.join(texts)} - {{{len(constants)}}})", (*constants, float(own.mean()))


def _rest(ground: Ground, tried: Tried, form: Form) -> _Rest:
    """Return a form of bumps at the place of a term of a law, blank."""
    C = on(ground.columns(ground.place(tried.target), ground.values(form)), tried.limbs)
    columns = np.swapaxes(C, 1, 2).reshape(len(C), -1)
    scale, blank = unit_variance(columns), ground.term(tried.target, form, tried.limbs)
    return _Rest(blank.with_values(np.zeros(blank.n_coefficients)), columns * scale, scale)


def _bumps(state: str, low: float, high: float, count: int) -> list[Part]:
    """Return bumps of a state, evenly spread between its ends."""
    width = (high - low) / (count - 1)
    return [(f"exp(-(({state} - {{0}})/{{1}})**2)", (float(at), width)) for at in np.linspace(low, high, count)]


def _bends(state: str, low: float, high: float, count: int) -> list[Part]:
    """Return round bends of a state, where bumps are: its slope, of chance at each of them, walks at random."""
    return [(f"sqrt(({state} - {{0}})**2 + {{1}}**2)", at) for _, at in _bumps(state, low, high, count)]


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
