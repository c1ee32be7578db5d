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

from deltacal_gen.diagnosis.charges import MARGIN, gains
from deltacal_gen.diagnosis.laws.ground import CHUNK, Ground, Place, Tried
from deltacal_gen.diagnosis.laws.profile import refine
from deltacal_gen.diagnosis.laws.screen import PART, price
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics import grammar
from deltacal_gen.physics.grammar import CONSTANT, Atom, Curve, Form, renumbered
from deltacal_gen.states import named

ONE = Atom("1", (), 1)
MOST = 4  # functions in a curve
CLOSER = 4  # changes of which all constants are sought
CHANGES = 10  # at most
STARTS = 2  # of a shape, anew: a function of one state in the place of a curve
LITTLE = 0.5  # of chi2: a change that earns less beyond its price is none
HARDLY = 5.0  # of chi2, likewise: by what less a form may earn than the best and still be as good, 12 to 1
RUNS = 10.0  # times what a law does where it was seen: what grows to more, a little beyond, runs away
FARTHER = 0.25  # of the width of a state, beyond both of its ends: how far forms are compared


Curves = tuple[Curve, ...]
Part = tuple[str, tuple[float, ...]]  # a factor, its constants as {0}


@dataclass(frozen=True)
class Change:
    """Another curve at a place of a product, as a sum of parts of which only the weights are not known yet."""

    at: int
    state: str
    parts: tuple[Curve, ...]

    @property
    def texts(self) -> set[str]:
        """Its functions."""
        return {a.text for p in self.parts for a in p.atoms}

    @property
    def periodic(self) -> bool:
        """Whether one of them is periodic and no sine: only where its period begins exactly does it show its worth."""
        return any("Mod(" in t or "Abs(sin(" in t for t in self.texts)

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
    every = [now]
    for _ in range(CHANGES):
        found = _changed(ground, place, now, curves)
        every += [t for t, _ in found]
        best, more = max(found, key=lambda f: _worth(f[0]), default=(now, curves))
        if _worth(best) < _worth(now) + LITTLE:
            break
        now, curves = best, more
    whole = dataclasses.replace(tried, gain=ground.gain(place, tried.form, tried.limbs))
    return _middle(ground, [whole, *every])


def reread(ground: Ground, tried: Tried) -> Tried:
    """Return a term of a law shaped anew from a single function in the place of a curve, of whichever state.

    What is left of a curve may be taken up by ever more parts of one of a state that nearly goes with the right one, or
    that had the simpler functions at first. Where it is hardly told apart it stays as it is.
    """
    curves = curves_of(ground, tried)
    if curves is None:
        return tried
    place = ground.place(tried.target)
    now = dataclasses.replace(tried, gain=ground.gain(place, tried.form, tried.limbs))
    starts = sorted(_starts(ground, place, now, curves), key=_worth, reverse=True)[:STARTS]
    best = max((shaped(ground, start) for start in starts), key=_worth, default=now)
    return best if _worth(best) > _worth(now) + HARDLY else tried


def _starts(ground: Ground, place: Place, now: Tried, curves: Curves) -> Iterator[Tried]:
    """Yield a law with the best function of each state in the place of each curve."""
    of_choice = now.price - price(now, 1)
    for k in range(len(curves)):
        others = [c.state for c in (*curves[:k], *curves[k + 1 :])]
        for state in (s for s in _own(ground, place, now.limbs) if s not in others):
            each = [Curve(state, (atom,)) for atom in grammar.full(state, ground.states[state])]
            forms = [_form((*curves[:k], one, *curves[k + 1 :])) for one in each]
            found = _gains(ground, place, forms, now.limbs)
            best = int(np.argmax(found - PART * np.array([f.length for f in forms])))
            start = dataclasses.replace(now, form=forms[best], gain=float(found[best]))
            yield dataclasses.replace(start, price=price(start, 1) + of_choice)


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
    changes = [c for i in range(len(curves)) for c in _changes(ground, curves, i) if c.texts != _texts(curves[i])]
    changes += _modulations(ground, place, curves, now.limbs)
    forms = [_beside(curves, c) for c in changes]
    lengths = [_form(curves).length - (curves[c.at].length if c.at < len(curves) else -1) + c.length for c in changes]
    more = np.array([MARGIN * (c.at == len(curves)) for c in changes])
    found = _gains(ground, place, forms, now.limbs) - PART * np.array(lengths) - more
    out = []
    order = np.argsort(-found)
    for k in dict.fromkeys([*order[:CLOSER], *[k for k in order if changes[k].periodic][: CLOSER // 2]]):
        other = _weighed(ground, now, curves, changes[k], forms[k])
        tried = _known(ground, place, now, _form(other))
        if not _runs_away(ground, tried):
            out.append((tried, _read(other, tried.form)))
    for k in range(len(curves) if len(curves) > 1 else 0):
        fewer = curves[:k] + curves[k + 1 :]
        tried = _known(ground, place, now, _form(fewer))
        out.append((tried, _read(fewer, tried.form)))
    return out


def _middle(ground: Ground, every: Sequence[Tried]) -> Tried:
    """Return, of forms that the readings can hardly tell apart, the simplest; of several, what goes on as most do.

    That is the one nearest to the mean of all, each weighed by its likelihood and its price, over the states as far as
    a law may be asked for: the best by a hair may be the only one that runs away.
    """
    best = max(_worth(t) for t in every)
    near = [t for t in every if _worth(t) > best - HARDLY]
    simplest = [k for k, t in enumerate(near) if t.form.length == min(o.form.length for o in near)]
    if len(simplest) == 1 or any(t.form.lags for t in near):
        return max((near[k] for k in simplest), key=_worth)
    weights = np.exp([(_worth(t) - best) / 2 for t in near])
    moved = np.array([beyond - within.mean() for within, beyond in (_moved(ground, t) for t in near)])
    off = ((moved - weights @ moved / weights.sum()) ** 2).sum(axis=1)
    return near[min(simplest, key=lambda k: off[k])]


def _worth(tried: Tried) -> float:
    """Return what a shape earns beyond its parts, and beyond what each of its states has to earn."""
    return tried.gain - PART * tried.form.length - MARGIN * len(tried.form.states)


def _runs_away(ground: Ground, tried: Tried) -> bool:
    """Tell whether a form grows beyond where it was seen to many times what it was there."""
    if tried.form.lags:
        return False
    within, beyond = _moved(ground, tried)
    return bool(np.ptp(beyond) > RUNS * np.ptp(within))


def _moved(ground: Ground, tried: Tried) -> tuple[Array, Array]:
    """Return what a form does (R,), on its first limb, at states as they are and as they reach farther."""
    by = ground.term(tried.target, tried.form, tried.limbs).values[0]
    both = ground.values(tried.form), ground.farther(tried.form, FARTHER)
    within, beyond = (v[:, (tried.limbs or (1,))[0] - 1 if v.shape[1] > 1 else 0] @ by for v in both)
    return within, beyond


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
        wave = grammar.wave(own.state, frequency)
        yield Change(i, own.state, tuple(Curve(own.state, (Atom(f, wave.constants, 2),)) for f in wave.functions))
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
    own, out = [i - 1 for i in limbs] or [0], np.zeros(len(forms))
    for width in {len(f.factors) for f in forms}:
        every = [k for k, f in enumerate(forms) if len(f.factors) == width]
        step = max(CHUNK // (width * place.columns.shape[2]), 1)
        for some in (every[s : s + step] for s in range(0, len(every), step)):
            shape = len(ground.rows), place.columns.shape[2], width
            values = [np.broadcast_to(ground.values(forms[k]), shape) for k in some]
            C = ground.columns(place, np.concatenate(values, axis=2))[:, :, own]
            G, b, _ = ground.normal(C.reshape(len(C), len(some), -1))
            out[some] = gains(G, b)
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


def _texts(curve: Curve) -> set[str]:
    return {a.text for a in curve.atoms}


def _beside(curves: Curves, change: Change) -> Form:
    """Return a form with a function for every part of a change, times the other curves."""
    others = [(c.text, c.constants) for k, c in enumerate(curves) if k != change.at]
    states = dict.fromkeys([*(c.state for c in curves), change.state])
    return of_parts([[(p.text, p.constants), *others] for p in change.parts], list(states))


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
    """Return a form as a product of curves, weighed as they explain most; None where it is none."""
    form = tried.form
    if form.curves:
        return _read(form.curves, form)
    common = [t for t in form.factors[0] if all(t in f for f in form.factors)]
    rest = [[t for t in f if t not in common] for f in form.factors]
    if any(len(r) > 1 for r in rest):
        return None
    out = [_curve(ground, form, t) for t in common]
    if len(form.factors) == 1:
        return tuple(out)
    text = next(r[0] for r in rest if r)
    blank = dataclasses.replace(_curve(ground, form, text), atoms=(ONE,))
    parts = tuple(_curve(ground, form, r[0]) if r else blank for r in rest)
    change = Change(len(out), blank.state, parts)
    return _weighed(ground, tried, (*out, blank), change, _beside((*out, blank), change))


def _curve(ground: Ground, form: Form, text: str) -> Curve:
    """Return a factor of a form by itself."""
    state = next(s for s in form.states if re.search(rf"\b{s}\b", text))
    own = list(dict.fromkeys(int(k) for k in CONSTANT.findall(text)))
    alone = CONSTANT.sub(lambda m: f"{{{own.index(int(m[1]))}}}", text)
    known = {a.text: a.length for a in grammar.full(state, ground.states[state])}
    atom = Atom(alone, tuple(form.constants[k] for k in own), known.get(alone, 1 + 2 * len(own)))
    return Curve(state, (atom,))
