"""What the best of many forms of an effect is worth: gains in chi2, and what chance alone lets the best one gain.

A form is an effect on some limbs, or tool points, with its searched constants. What the best of many explains by chance
grows with their number: the charge is the gain that nothing but noise exceeds with the probability `CHANCE`, all forms
of the effect together (Bonferroni).
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from functools import cache
from typing import TypeVar

import numpy as np

from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Constant, Term, load_effect, without_rows

MARGIN = 10.0  # of chi2, beyond all charges: what an effect must earn to be named, and what is left to be unexplained
CHANCE = 5e-4  # that noise alone earns a form, or a limb, its charge
MOST_SETS, MOST_FORMS = 6, 3  # limbs of which all sets are looked at; forms of an effect on more that are
UNSEEN = 1e-6  # part of a column's square beside the base: less is a combination of what is fitted
SMALLEST = 1e-8  # of the largest eigenvalue: below it columns are combinations of one another
NOTHING = 1e-6  # of chi2: what is worth so much more is rounding
AS_GOOD = 1.0  # of chi2: what explains so much less is as likely
BENT = 1e-4  # of a gain: what the linear machine may make of a movement of which a hundredth bends
T = TypeVar("T")


def gains(G: Array, b: Array) -> Array:
    """Return b G^+ b (M,) of M normal equations, (M, k, k) and (M, k); columns that are not seen take no part.

    Columns had unit length before the projection.
    """
    if G.shape[1] == 1:
        seen = G[:, 0] > UNSEEN
        return np.where(seen, b**2 / np.where(seen, G[:, 0], 1.0), 0.0)[:, 0]
    out, full = np.empty(len(G)), _all_seen(G)
    if full.any():
        inside = b[full][:, :, None]
        out[full] = np.sum(inside * np.linalg.solve(G[full], inside), axis=(1, 2))
    if not full.all():
        seen, vectors, sizes = directions(G[~full])
        along = np.einsum("mij,mi->mj", vectors, np.where(seen, b[~full], 0.0))
        out[~full] = np.sum(along**2 / sizes, axis=1)
    return out


def _all_seen(G: Array) -> np.ndarray:
    """Return of which normal equations (M, k, k) all columns and directions are seen, without looking for any: (M,).

    The smallest eigenvalue is no less than the determinant by what the others can be at most, of one trace.
    """
    k, each = G.shape[1], np.diagonal(G, axis1=1, axis2=2)
    trace = np.maximum(each.sum(axis=1), UNSEEN)
    with np.errstate(divide="ignore"):  # of singular ones: by logarithms
        least = np.linalg.det(G) * ((k - 1) / trace) ** (k - 1)
    return np.asarray((each > UNSEEN).all(axis=1) & (least > 2 * SMALLEST * trace))


def directions(G: Array) -> tuple[np.ndarray, Array, Array]:
    """Return which columns of M normal equations (M, k, k) are seen, their directions, and the size of each (M, k).

    Infinite is the size of one that is no more than rounding: divided by it nothing is left.
    """
    seen = np.diagonal(G, axis1=1, axis2=2) > UNSEEN
    values, vectors = np.linalg.eigh(np.where(seen[:, :, None] & seen[:, None, :], G, 0.0))
    keep = values > SMALLEST * np.maximum(values[:, -1:], UNSEEN)
    return seen, vectors, np.where(keep, values, np.inf)


def charge(term: Term, forms: int, together: int = 1) -> float:
    """Return the gain in chi2 that the best of `forms` of an effect exceeds by chance alone.

    Each limb, or tool point, has to earn its own: an effect on two limbs is charged as two. Of `together` terms, which
    differ in a constant alone, all coefficients of a limb earn theirs together.
    """
    rows, n_c = term.values.shape
    return _charge(rows, together * n_c, forms)


@cache
def quantile(degrees: int, forms: int) -> float:
    """Return what the largest of `forms` chi2 of so many degrees exceeds with the probability `CHANCE`, at most."""
    from scipy.special import chdtri  # scipy.stats would take a second to load

    return float(chdtri(degrees, CHANCE / forms))


def _charge(rows: int, n_c: int, forms: int) -> float:
    return rows * quantile(n_c, 1) + quantile(1, forms) - quantile(1, 1)


def several(effect: str) -> bool:
    """Tell whether a machine may have an effect more than once: periodic errors of different orders."""
    return "orders" in load_effect(effect).SEARCHED


def key(term: Term) -> tuple[str, tuple[Constant, ...]]:
    """Return an effect and its constants: a form, wherever it is."""
    return term.effect, term.constants


def carriers_of(term: Term) -> Sequence[object]:
    """Return the limbs, or the tool points, that an effect is on; none where it is of the whole machine."""
    return term.limbs or term.tools


def places(every: Term, part: Term) -> list[int]:
    """Return which coefficients of an effect on all limbs, or tool points, those on a part of them are."""
    return _places(every, carriers_of(part))


def _places(every: Term, own: Sequence[object]) -> list[int]:
    """Return the columns, among those of an effect on all limbs or tool points, of some of them."""
    n_c, carriers = every.values.shape[1], carriers_of(every)
    places = [carriers.index(c) for c in own] if carriers else [0]
    return [p * n_c + j for p in places for j in range(n_c)]


def _on(every: Term, carriers: Sequence[object]) -> Term:
    """Return an effect, blank, on some of its limbs or tool points."""
    return without_rows(every, [r for r, c in enumerate(carriers_of(every)) if c not in carriers]) or every


def best_part(every: Term, allowed: Sequence[object], forms: int, G: Array, b: Array) -> tuple[Term, int, float, float]:
    """Return which part of an effect, in which form, earns most beyond its charge, with gain and score.

    `every` is the effect on all limbs, to which the normal equations G (M, n, n) and b (M, n) of M forms belong;
    `allowed` are the limbs, or tool points, that it may be on. All sets of few limbs are looked at; of many, those on
    the way from none to all and back, of the forms that explain most on all.
    """
    most = gains(G, b)  # no part of a form explains more than the whole
    if len(allowed) > MOST_SETS:
        return _greedy(every, allowed, forms, G, b, np.argsort(-most)[:MOST_FORMS])
    carriers, found = carriers_of(every), (_on(every, allowed), 0, 0.0, -np.inf)
    largest = len(allowed) - bool(every.tools and len(allowed) == len(every.tools))
    for size in range(largest, 0, -1) if carriers else [0]:
        price = _charge(max(size, 1), every.values.shape[1], forms)
        some = np.flatnonzero(most - price > found[3])
        if not len(some):
            continue
        sets = list(itertools.combinations(allowed, size))[::-1]
        at = np.array([_places(every, own) for own in sets])
        those = G[some][:, at[:, :, None], at[:, None, :]], b[some][:, at]
        each = gains(*(values.reshape(-1, *at.shape[1:] * (values.ndim - 2)) for values in those))
        by_set = each.reshape(len(some), -1).T
        which, k = divmod(int(np.argmax(by_set)), len(some))
        gain = float(by_set[which, k])
        if gain - price > found[3]:
            found = _on(every, sets[which]), int(some[k]), gain, gain - price
    return found


def stiffest(every: Term, part: Term, G: Array, b: Array, size: Array) -> Term:
    """Return the part with the smallest coefficients of those that explain as much.

    In each another limb stands for one. Where poses do not tell limbs apart, as of parallel joints of which one alone
    turns, the one with the longest lever has to give least: machines are stiff.

    Parameters
    ----------
    G, b, size : (n, n), (n,) and (n,) array
        Normal equations of the form's unit columns on all limbs, and the columns' lengths.
    """
    own = list(carriers_of(part))
    others = [c for c in carriers_of(every) if c not in own]
    if not own or not others:
        return part
    sets = [own, *([*own[:i], other, *own[i + 1 :]] for i in range(len(own)) for other in others)]
    at = np.array([_places(every, one) for one in sets])
    those, along = G[at[:, :, None], at[:, None, :]], b[at]
    each = gains(those, along)
    near = each > each[0] - max(AS_GOOD, BENT * float(each[0]))
    near[0] = True
    inverse = np.linalg.pinv(those[near], rcond=SMALLEST, hermitian=True)
    seen = np.diagonal(those[near], axis1=1, axis2=2) > UNSEEN
    values = (inverse @ along[near][:, :, None])[:, :, 0] / np.where(seen, size[at][near], np.inf)
    return _on(every, sets[int(np.flatnonzero(near)[np.argmin(np.linalg.norm(values, axis=1))])])


def _greedy(
    every: Term, allowed: Sequence[object], forms: int, G: Array, b: Array, among: np.ndarray
) -> tuple[Term, int, float, float]:
    """Return what `_most` does, of some of the forms and of sets on the way from none to all and back."""
    n_c, best = every.values.shape[1], (every, 0, 0.0, -np.inf)
    for k in among.tolist():

        def worth(sets: Sequence[tuple[object, ...]], k: int = k) -> Sequence[float]:
            if every.tools and len(sets[0]) == len(every.tools):
                return [-np.inf]  # an offset of all tool points alike is another frame
            at = np.array([_places(every, own) for own in sets])
            found: list[float] = gains(G[k][at[:, :, None], at[:, None, :]], b[k][at]).tolist()
            return [gain - _charge(len(sets[0]), n_c, forms) for gain in found]

        own, score = best_set(allowed, worth)
        if score > best[3]:
            best = _on(every, own), k, score + _charge(len(own), n_c, forms), score
    return best


def best_set(
    items: Sequence[T], worth: Callable[[Sequence[tuple[T, ...]]], Sequence[float]]
) -> tuple[tuple[T, ...], float]:
    """Return the set of items that is worth most, and its worth: forwards one by one, then backwards from all.

    Where items stand for one another rounding decides which way is gone, and either may pass by the best: from the
    better end it goes on by one item more, fewer or exchanged, as long as that is worth more. `worth` takes sets of one
    size at a time.
    """
    found: list[tuple[float, tuple[T, ...]]] = []
    own: tuple[T, ...] = ()
    while len(own) < len(items):
        tried = [tuple(i for i in items if i in own or i == new) for new in items if new not in own]
        score, own = max(zip(worth(tried), tried, strict=True), key=lambda pair: pair[0])
        found.append((score, own))
    while len(own) > 1:
        tried = [tuple(i for i in own if i != old) for old in own]
        score, own = max(zip(worth(tried), tried, strict=True), key=lambda pair: pair[0])
        found.append((score, own))
    score, own = max(found, key=lambda pair: pair[0])
    while beside := _beside(own, items):
        better, other = max(
            (pair for sets in beside for pair in zip(worth(sets), sets, strict=True)), key=lambda pair: pair[0]
        )
        if better <= score + NOTHING:
            break
        score, own = better, other
    return own, score


def _beside(own: Sequence[T], items: Sequence[T]) -> list[list[tuple[T, ...]]]:
    """Return the sets of items, none of them empty, that differ from one by an item more, fewer or exchanged."""

    def of(without: Sequence[T], new: Sequence[T]) -> tuple[T, ...]:
        return tuple(i for i in items if i in new or (i in own and i not in without))

    others = [i for i in items if i not in own]
    more, fewer = [of((), (new,)) for new in others], [of((old,), ()) for old in own if len(own) > 1]
    exchanged = [of((old,), (new,)) for old in own for new in others]
    return [sets for sets in (more, fewer, exchanged) if sets]
