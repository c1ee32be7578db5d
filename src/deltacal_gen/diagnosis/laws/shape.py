"""The shape of a law whose place and states are known: what is left along them is added, bend by bend.

No list of functions holds every curve. Where a law has been found, a few hinges more follow what its own function does
not, each where it explains most (multivariate adaptive regression splines, Friedman 1991, Annals of Statistics 19,
1-67): straight beyond the last one, so that no polynomial runs away.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterator

import numpy as np

from deltacal_gen.diagnosis.laws import grammar
from deltacal_gen.diagnosis.laws.grammar import Form, switch
from deltacal_gen.diagnosis.laws.ground import Ground, Place, Tried
from deltacal_gen.diagnosis.laws.screen import price, refine
from deltacal_gen.diagnosis.strategy import MARGIN
from deltacal_gen.machine.registry import Array

MOST = 7  # functions of a term
KNOTS = np.linspace(0.1, 0.9, 9)  # quantiles of a state at which a curve may bend
BEND = 7.0  # of chi2: what the best of a dozen hinges that are not there exceeds in one of ten searches
Piece = tuple[str, tuple[float, ...]]  # a factor, its constants as {0}


def shaped(ground: Ground, tried: Tried) -> Tried:
    """Return a term of a law with another state that modulates it, and the bends that it earns."""
    place = ground.place(tried.target)
    now = dataclasses.replace(tried, gain=ground.gain(place, tried.form, tried.limbs))
    now = _modulated(ground, place, now)
    cost = BEND * max(len(now.limbs), 1)
    while len(now.form.functions) < MOST:
        forms = list(_longer(ground, now.form))
        gains = [ground.gain(place, form, now.limbs) for form in forms]
        best = int(np.argmax(gains))
        if gains[best] - now.gain < cost:
            break
        more = dataclasses.replace(now, form=forms[best], gain=gains[best], price=now.price + cost)
        now = refine(ground, place, more)
    return tried if now.form.functions == tried.form.functions else now


def _modulated(ground: Ground, place: Place, tried: Tried) -> Tried:
    """Return a form of one state times a straight line of another one, where that earns its price."""
    if len(tried.form.states) > 1 or len(tried.form.functions) > 2:
        return tried
    others = [s for s in ground.readable(place) if s not in tried.form.states]
    forms = [_times(tried.form, s, atom) for s in others for atom in grammar.linear(s, ground.states[s])]
    every = [dataclasses.replace(tried, form=f, gain=ground.gain(place, f, tried.limbs)) for f in forms]
    priced = [dataclasses.replace(t, price=price(t, len(every))) for t in every]
    best = max(priced, key=lambda t: t.score, default=tried)
    return refine(ground, place, best) if best.score > tried.score + MARGIN else tried


def _times(form: Form, state: str, atom: grammar.Atom) -> Form:
    """Return a form, and the same times a function of another state beside it."""
    text = atom.text.replace("{0}", f"{{{len(form.constants)}}}")
    return dataclasses.replace(
        form,
        factors=(*form.factors, *((*f, text) for f in form.factors)),
        constants=(*form.constants, *atom.constants),
        states=(*form.states, state),
        length=form.length + atom.length + 2,
    )


def _longer(ground: Ground, form: Form) -> Iterator[Form]:
    """Yield a form with one function more of its states."""
    each = [[*_pieces(s, ground.states[s]), None] for s in form.states]
    for pieces in itertools.product(*each):
        if any(pieces):
            yield _with(form, [p for p in pieces if p is not None])
    if len(form.states) == 2 and len(form.factors[0]) == 2:  # beside one factor as it is, the other one bends
        for factor, own in zip(reversed(form.factors[0]), each, strict=False):
            for piece in own[:-1]:
                yield _with(form, [(factor, ()), piece] if piece else [(factor, ())])


def _pieces(state: str, values: Array) -> list[Piece | None]:
    """Return what a curve of a state is put together of."""
    out: list[Piece | None] = [(state, ())]
    if not switch(values):
        out += [(f"Max({state} - {{0}}, 0)", (float(k),)) for k in np.unique(np.quantile(values, KNOTS))]
    return out


def _with(form: Form, pieces: list[Piece]) -> Form:
    """Return a form with a product of pieces beside its functions."""
    constants, factors = list(form.constants), []
    for text, own in pieces:
        factors.append(text.replace("{0}", f"{{{len(constants)}}}") if own else text)
        constants += own
    return dataclasses.replace(
        form, factors=(*form.factors, tuple(factors)), constants=tuple(constants), length=form.length + 3
    )
