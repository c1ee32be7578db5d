"""Which form at which place explains most of what a fit leaves, beyond the price of having looked at so many.

First every state and every product of two, in few functions each, at every place. Then, where that explains most, every
function that the grammar has; last the constants within the best ones, between the steps of their grids.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterable, Sequence
from functools import cache

import numpy as np

from deltacal_gen.diagnosis.charges import MARGIN, MOST_SETS, best_set, gains, quantile
from deltacal_gen.diagnosis.laws.ground import Ground, Place, Tried
from deltacal_gen.diagnosis.laws.profile import refine
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics import grammar
from deltacal_gen.physics.grammar import Form
from deltacal_gen.states import named

PART = 2 * np.log(4)  # of chi2: price of each part that there is to say of a law, one of four or more that it may be
LOOKED_AT = 10  # states, or pairs of them, at a place, of which every function is tried
KINDS = 8  # functions of a state of which the best constants are sought
REFINED = 16  # forms whose constants are sought between the steps of their grids
NEAR = 0.5  # of the best score: what explains less is not looked at closer


def ranked(ground: Ground, looked_at: int = LOOKED_AT) -> list[Tried]:
    """Return the best form of every place and set of states that earns something, the best first.

    `looked_at` of them are looked at closer.
    """
    return counted(ground, looked_at)[0]


def counted(ground: Ground, looked_at: int = LOOKED_AT) -> tuple[list[Tried], int]:
    """Return what `ranked` does, and among how many forms, place by place, these were chosen."""
    tried = _first(ground)
    count = max(len(tried), 1)
    heads = _each_once(sorted(tried, key=lambda t: -t.score))[:looked_at]
    heads = [h for h in heads if h.score > NEAR * heads[0].score - 50.0] if heads else []
    places = {p.target: p for p in ground.places}
    closer: list[Tried] = []
    for head in heads:
        forms = list(_closer(ground, head))
        count += len(forms)
        found = sorted(_screened(ground, places[head.target], forms), key=lambda t: -t.score)
        kinds = {t.form.functions: t for t in reversed(found[: 20 * KINDS])}  # one of each, with its best constants
        some = sorted([head, *kinds.values()], key=lambda t: -t.score)[: KINDS if len(head.form.states) == 1 else 3]
        closer += [_carried(ground, places[head.target], t) for t in some]
    priced = [dataclasses.replace(t, price=price(t, count)) for t in closer]
    priced.sort(key=lambda t: -t.score)
    refined = [refine(ground, places[t.target], t) for t in priced[:REFINED]]
    return _each_once(sorted([*refined, *priced[REFINED:]], key=lambda t: -t.score)), count


def stands_out(ground: Ground) -> bool:
    """Tell whether some simple form earns its price: what a fit leaves is then more than noise."""
    tried = _first(ground)
    of_choice = quantile(1, max(len(tried), 1)) - quantile(1, 1)
    return any(t.score - of_choice > MARGIN for t in tried)


def _each_once(tried: Iterable[Tried]) -> list[Tried]:
    """Return the first of every place and set of states."""
    out: dict[tuple[str, frozenset[str]], Tried] = {}
    for t in tried:
        out.setdefault((t.target, frozenset(t.form.states)), t)
    return list(out.values())


def price(tried: Tried, count: int) -> float:
    """Return the gain that the best of `count` forms exceeds by chance alone, and what there is to say of this one."""
    return _price(tried.form, tried.limbs, count)


def _price(form: Form, limbs: Sequence[int], count: int) -> float:
    columns = len(form.factors) * max(len(limbs), 1)
    of_choice = quantile(1, count) - quantile(1, 1)
    return columns * quantile(1, 1) + of_choice + PART * form.length


def _first(ground: Ground) -> list[Tried]:
    """Return what simple functions of every state, and products of two, explain at every place."""
    out: list[Tried] = []
    for place in ground.places:
        key = tuple(ground.readable(place)), place.remembers
        if key not in ground.coarse:
            ground.coarse[key] = _coarse(ground, *key)
        out += _screened(ground, place, ground.coarse[key])
    return out


def _coarse(ground: Ground, names: Sequence[str], remembers: bool) -> list[Form]:
    """Return simple functions of every state, waves, and products of two; and states that lag."""
    states, lags = ground.states, ground.lags[2::3] if remembers else ()
    ones = [grammar.single(n, a) for n in names for a in grammar.simple(n, states[n])]
    lines = {n: grammar.linear(n, states[n]) for n in names}
    for a, b in itertools.combinations(names, 2):
        ones += [grammar.product((a, f), (b, g)) for f, g in itertools.product(lines[a], lines[b])]
    ones += [grammar.single(n, grammar.lagging(n, tau)) for n in names if not named(n).passes for tau in lags]
    ones += [w for n in names if states[n].ndim == 1 and n[:2] != "q_" for w in grammar.waves(n, states[n])]
    return ones


def _closer(ground: Ground, head: Tried) -> Iterable[Form]:
    """Yield every form of the states of one that explains much."""
    names, states = head.form.states, ground.states
    lags = ground.lags if ground.place(head.target).remembers else ()
    make = grammar.full if len(names) == 1 else grammar.factors
    atoms = [make(n, states[n], () if named(n).passes else lags) for n in names]
    if len(names) == 1:
        yield from (grammar.single(names[0], a) for a in atoms[0])
        if len(head.form.functions) == 2:  # a wave
            yield from (grammar.single(names[0], a) for a in grammar.periodic(names[0], head.form.constants[0]))
        return
    a, b = names
    for f, g in itertools.product(*atoms):
        yield grammar.product((a, f), (b, g))
    for m, n, g in ((a, b, atoms[1][0]), (b, a, atoms[0][0])):
        yield from (grammar.modulated(m, f, (n, g)) for f in grammar.slow_waves(states[m]))
    for (m, f), (n, g) in (((a, atoms[0][0]), (b, atoms[1][0])), ((b, atoms[1][0]), (a, atoms[0][0]))):
        yield grammar.product((m, f), (n, g), beside=True)


def _screened(ground: Ground, place: Place, forms: Sequence[Form]) -> list[Tried]:
    """Return the forms on the limb, or on all limbs, on which each explains most beyond its own price."""
    out: list[Tried] = []
    for some, values in ground.batches(forms):
        out += _scored(place, some, *ground.normal_of(place, some, values))
    return out


def _scored(place: Place, forms: Sequence[Form], G: Array, b: Array) -> list[Tried]:
    limbs, m = place.columns.shape[2], len(forms[0].factors)
    each = np.stack([gains(G[:, at : at + m, at : at + m], b[:, at : at + m]) for at in range(0, limbs * m, m)], axis=1)
    single, one = each.max(axis=1), each.argmax(axis=1)
    whole = gains(G, b) if limbs > 1 else single
    on_all = whole - (limbs - 1) * m * quantile(1, 1) > single
    own = [place.limbs if every else place.limbs[k : k + 1] for every, k in zip(on_all.tolist(), one, strict=True)]
    gain = np.where(on_all, whole, single).tolist()
    columns = [m * max(len(some), 1) * quantile(1, 1) for some in (place.limbs[:1], place.limbs)]  # see `_price`
    return [
        Tried(place.target, form, some, most, columns[every] + PART * form.length)
        for form, some, most, every in zip(forms, own, gain, on_all.tolist(), strict=True)
    ]


def _carried(ground: Ground, place: Place, tried: Tried) -> Tried:
    """Return a form on the set of limbs that earns most."""
    limbs = len(place.limbs)
    if limbs < 2:
        return tried
    G, b = ground.normal_of(place, [tried.form], ground.values(tried.form))
    m = len(tried.form.functions)

    @cache
    def gain(own: tuple[int, ...]) -> float:
        at = [(i - 1) * m + j for i in own for j in range(m)]
        return float(gains(G[0][np.ix_(at, at)][None], b[0, at][None])[0])

    def worth(own: tuple[int, ...]) -> float:
        return gain(own) - len(own) * m * quantile(1, 1)

    if limbs > MOST_SETS:
        own = best_set(place.limbs, lambda sets: [worth(s) for s in sets])[0]
    else:
        sets = [s for n in range(1, limbs + 1) for s in itertools.combinations(place.limbs, n)]
        own = max(sets, key=worth)
    return dataclasses.replace(tried, limbs=own, gain=gain(own))
