"""The shape of a law whose place and states are known: a product of curves, one of each state, each what it earns.

The first look at so many states takes few functions of each. Here every function of the grammar stands for each curve
in turn, alone or beside what is there, with the other curves as they are; all constants are then sought together. A
part that does not earn its price goes.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.charges import gains
from deltacal_gen.diagnosis.laws.ground import Ground, Place, Tried, joined
from deltacal_gen.diagnosis.laws.profile import refine
from deltacal_gen.diagnosis.laws.screen import price
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics import grammar
from deltacal_gen.physics.grammar import Atom, Curve, Form, renumbered
from deltacal_gen.states import named

ONE = Atom("1", (), 1)
MOST = 4  # functions in a curve
CLOSER = 4  # changes of which all constants are sought
CHANGES = 10  # at most
LITTLE = 0.5  # of chi2: a change that earns less beyond its price is none

Curves = tuple[Curve, ...]
Part = tuple[str, tuple[float, ...]]  # a factor, its constants as {0}


@dataclass(frozen=True)
class Change:
    """Another curve at a place of a product, as a sum of parts of which only the weights are not known yet."""

    at: int
    state: str
    parts: tuple[Curve, ...]

    @property
    def length(self) -> int:
        """How long it is to write: the lengths of its parts, and a sign between any two."""
        return sum(p.length for p in self.parts) + len(self.parts) - 1


def shaped(ground: Ground, tried: Tried) -> Tried:
    """Return a term of a law with the curves that it earns, and with another state that modulates it."""
    place, curves = ground.place(tried.target), curves_of(ground, tried)
    if curves is None:
        return tried
    now = _known(ground, place, tried, _form(curves))
    for _ in range(CHANGES):
        best, more = max(_changed(ground, place, now, curves), key=lambda f: f[0].score, default=(now, curves))
        if best.score < now.score + LITTLE:
            break
        now, curves = best, more
    whole = dataclasses.replace(tried, gain=ground.gain(place, tried.form, tried.limbs))
    return max(whole, now, key=lambda t: t.score)


def _own(ground: Ground, place: Place, limbs: tuple[int, ...]) -> list[str]:
    """Return the states that a law on some limbs may read: none reads its own joint as another's."""
    return [s for s in ground.readable(place) if named(s).joint not in limbs]


def _known(ground: Ground, place: Place, tried: Tried, form: Form) -> Tried:
    """Return a form in the place of another one, its constants where it explains most, with its price."""
    out = dataclasses.replace(tried, form=form, gain=ground.gain(place, form, tried.limbs))
    of_choice = tried.price - price(tried, 1)
    return refine(ground, place, dataclasses.replace(out, price=price(out, 1) + of_choice))


def _changed(ground: Ground, place: Place, now: Tried, curves: Curves) -> list[tuple[Tried, Curves]]:
    """Return a law with each of the changes that seem to earn most."""
    changes = [c for i in range(len(curves)) for c in _changes(ground, curves, i)]
    changes += _modulations(ground, place, curves, now.limbs)
    forms = [_beside(curves, c) for c in changes]
    prices = [price(dataclasses.replace(now, form=f), 1) for f in forms]
    order = np.argsort(prices - _gains(ground, place, forms, now.limbs))
    others = [_weighed(ground, now, curves, changes[k], forms[k]) for k in order[:CLOSER]]
    others += [curves[:k] + curves[k + 1 :] for k in range(len(curves) if len(curves) > 1 else 0)]
    out = []
    for other in others:
        tried = _known(ground, place, now, _form(other))
        out.append((tried, _read(other, tried.form)))
    return out


def _changes(ground: Ground, curves: Curves, i: int) -> Iterator[Change]:
    """Yield what may stand for a curve of a product: any function, or one more, or one less."""
    own, alone = curves[i], len(curves) == 1
    for atom in grammar.full(own.state, ground.states[own.state]):
        one = Curve(own.state, (atom,))
        yield Change(i, own.state, (one,))
        if not alone:
            yield Change(i, own.state, (one, Curve(own.state, (ONE,))))
        if len(own.atoms) < MOST and atom not in own.atoms and all(map(grammar.calm, (*own.atoms, atom))):
            yield Change(i, own.state, (own, one))
    for frequency in grammar.slow_waves(ground.states[own.state]):
        yield Change(i, own.state, grammar.sines(own.state, frequency))
    for frequency in {a.constants[0] for a in own.atoms if re.match(r"cos|sin", a.text)}:
        for atom in grammar.periodic(own.state, abs(frequency)):
            one = Curve(own.state, (atom,))
            yield Change(i, own.state, (one,) if alone else (one, Curve(own.state, (ONE,))))
    if not alone and ONE not in own.atoms and len(own.atoms) < MOST:
        yield Change(i, own.state, (own, Curve(own.state, (ONE,))))
    if len(own.atoms) > 1:
        for k in range(len(own.atoms)):
            yield Change(i, own.state, tuple(Curve(own.state, (a,)) for j, a in enumerate(own.atoms) if j != k))


def _modulations(ground: Ground, place: Place, curves: Curves, limbs: tuple[int, ...]) -> list[Change]:
    """Return by which straight line of another state each limb's law of one state may be multiplied."""
    if len(curves) > 1:
        return []
    others = [s for s in _own(ground, place, limbs) if s != curves[0].state]
    atoms = [(s, a) for s in others for a in grammar.linear(s, ground.states[s])]
    return [Change(1, s, (Curve(s, (ONE,)), Curve(s, (atom,)))) for s, atom in atoms]


def _gains(ground: Ground, place: Place, forms: Sequence[Form], limbs: tuple[int, ...]) -> Array:
    """Return by how much each form lowers chi2 on some limbs."""
    out = np.zeros(len(forms))
    for some, system in ground.systems(place, forms):
        out[some] = gains(*joined(system, limbs, place.columns.shape[2]))
    return out


def _weighed(ground: Ground, now: Tried, curves: Curves, change: Change, form: Form) -> Curves:
    """Return curves with a change, its parts weighed as they explain most on the limb that moves most."""
    values = ground.term(now.target, form, now.limbs).values
    size = np.abs(values).sum(axis=1)
    by = values[int(np.argmax(size))]
    moved = np.abs(by) * np.array([np.ptp(v) for v in np.moveaxis(ground.values(form), 2, 0)])
    order = sorted(range(len(by)), key=lambda k: -moved[k])
    atoms, weights = list[Atom](), list[float]()
    for k in order:
        part, of = change.parts[k], by[k] / (by[order[0]] or 1.0)
        atoms += part.atoms
        weights += [of, *(of * w for w in part.weights)]
    out = Curve(change.state, tuple(atoms), tuple(float(w) or 1e-9 for w in weights[1:]))
    return (*curves[: change.at], out, *curves[change.at + 1 :])


def _beside(curves: Curves, change: Change) -> Form:
    """Return a form with a function for every part of a change, times the other curves."""
    others = [(c.text, c.constants) for k, c in enumerate(curves) if k != change.at]
    states = dict.fromkeys([*(c.state for c in curves), change.state])
    out = of_parts([[(p.text, p.constants), *others] for p in change.parts], list(states))
    length = sum(c.length for k, c in enumerate(curves) if k != change.at) + len(others) + change.length
    return dataclasses.replace(out, length=length)


def _form(curves: Curves) -> Form:
    out = of_parts([[(c.text, c.constants) for c in curves]], [c.state for c in curves])
    return dataclasses.replace(out, length=sum(c.length for c in curves) + len(curves) - 1, curves=curves)


def of_parts(functions: Sequence[Sequence[Part]], states: Sequence[str]) -> Form:
    """Return a form of functions that are products of factors."""
    constants, factors = list[float](), list[tuple[str, ...]]()
    for parts in functions:
        texts = []
        for text, own in parts:
            texts.append(renumbered(text, len(constants)))
            constants += own
        factors.append(tuple(texts))
    return Form(tuple(factors), tuple(constants), tuple(states), 0)


def _read(curves: Curves, form: Form) -> Curves:
    """Return curves with the constants of a form."""
    left, out = list(form.constants), []
    for c in curves:
        out.append(c.with_constants(left[: len(c.constants)]))
        del left[: len(c.constants)]
    return tuple(out)


def curves_of(ground: Ground, tried: Tried) -> Curves | None:
    """Return a form as a product of curves, a wave weighed as it explains most; None where it is none."""
    form = tried.form
    if form.curves:
        return _read(form.curves, form)
    if len(form.functions) != 2 or len(form.states) > 1:
        return None
    blank, wave = (Curve(form.states[0], (ONE,)),), grammar.sines(form.states[0], form.constants[0])
    change = Change(0, form.states[0], wave)
    return _weighed(ground, tried, blank, change, _beside(blank, change))
