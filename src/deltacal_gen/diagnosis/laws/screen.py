"""Which form at which place explains most of what a fit leaves, beyond the price of having looked at so many.

First every state and every product of two, in few functions each, at every place. Then, where that explains most, every
function that the grammar has; last the constants within the best ones, between the steps of their grids.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterable, Sequence

import numpy as np

from deltacal_gen.diagnosis.charges import MARGIN, MOST_SETS, gains, quantile
from deltacal_gen.diagnosis.laws.ground import Ground, Place, Tried, joined
from deltacal_gen.diagnosis.laws.profile import refine
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
        kinds = {t.form.functions: t for t in reversed(found)}  # one of each, with its best constants
        some = sorted([head, *kinds.values()], key=lambda t: -t.score)[:KINDS]
        closer += _screened(ground, places[head.target], [t.form for t in some], closer=True)
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
    columns = len(tried.form.factors) * max(len(tried.limbs), 1)
    return columns * quantile(1, 1) + quantile(1, count) - quantile(1, 1) + _said(tried.form)


def _said(form: Form) -> float:
    """Return the price of all that there is to say of a form, of each state that it reads beside the first one, too."""
    return PART * form.length + MARGIN * (len(form.states) - 1)


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
    """Yield every form of the state of one that explains much; a product stays as it is, and is shaped later."""
    if len(head.form.states) > 1:
        yield head.form
        return
    (name,), lags = head.form.states, ground.lags if ground.place(head.target).remembers else ()
    atoms = grammar.full(name, ground.states[name], () if named(name).passes else lags)
    if len(head.form.functions) == 2:  # a wave
        atoms += grammar.periodic(name, head.form.constants[0])
    yield from (grammar.single(name, a) for a in atoms)


def _screened(ground: Ground, place: Place, forms: Sequence[Form], closer: bool = False) -> list[Tried]:
    """Return the forms on those limbs on which each explains most beyond its own price.

    All limbs share their coefficients, or one has its own, or each has; looked at `closer`, any of them have.
    """
    every = place.columns.shape[2]
    sizes = [n for n in range(1, every + 1) if n in (1, every) or (closer and (every <= MOST_SETS or n == 2))]
    sets = [s for n in sizes if place.limbs for s in itertools.combinations(place.limbs, n)]
    sets += [()] if every > 1 or not sets else []
    out: list[Tried] = []
    for some, system in ground.systems(place, forms):
        m = system[0].shape[1] // every
        gain = np.array([gains(*joined(system, own, every)) for own in sets])
        columns = m * quantile(1, 1) * np.maximum([len(own) for own in sets], 1)
        if place.limbs and not sets[-1]:  # what another joint does is another's for each limb
            gain[-1, [any(named(s).joint for s in forms[k].states) for k in some]] = 0.0
        best = np.argmax(gain - columns[:, None], axis=0)
        for at, (k, which) in enumerate(zip(some, best.tolist(), strict=True)):
            worth = float(gain[which, at]), float(columns[which]) + _said(forms[k])  # see `price`
            out.append(Tried(place.target, forms[k], sets[which], *worth))
    return out
