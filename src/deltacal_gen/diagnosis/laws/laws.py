"""A law for what no registered effect explains: found, asked, fitted to everything, with what it makes needless."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.diagnosis.charges import MARGIN, gains, quantile
from deltacal_gen.diagnosis.discrimination import Question
from deltacal_gen.diagnosis.laws.ground import Ground, Tried
from deltacal_gen.diagnosis.laws.proof import MOST_POSES, SEED, Instead, Proof, judged, proven
from deltacal_gen.diagnosis.laws.screen import counted, stands_out
from deltacal_gen.diagnosis.laws.search import Grown, curved, fitted, polished, unexplained
from deltacal_gen.diagnosis.refits import COMPARED, refitted, terms_of
from deltacal_gen.diagnosis.strategy import Outcome
from deltacal_gen.diagnosis.structure import by_instrument
from deltacal_gen.diagnosis.wandering import following_walks
from deltacal_gen.errors import InputError
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.identification.together import deviance_of, together
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import Term
from deltacal_gen.states import named

MOST = 5  # laws that are told
RIVALS = 10.0 + 4 * 10.0**0.5  # of chi2, as for effects: a law that earns less than that less is not told from the best
DOUBTED = 2  # terms that earn least: of these a fit without each is asked whether it is needed
STEP = 1e-3  # of a constant, by which its derivative is taken
RUNNERS_UP = 8  # forms that are told beside a law, and what they earn


class Unsure(NamedTuple):
    """How unknown the constants (n,) within a term are, and what that does to its coefficients (n_c,).

    Attributes
    ----------
    std : (n,) array
    added : (n_c,) array
        What they add to the variances of the coefficients.
    covariance : (n, n) array
    by : (n, n_c) array
        By how much the coefficients go with each of them.
    """

    std: Array
    added: Array
    covariance: Array
    by: Array


@dataclass(frozen=True)
class Lawful:
    """A law: a fit with it, what other readings say of it, and how sure its numbers are.

    Attributes
    ----------
    fit : Fit
        Of the readings that the search looks at; the terms of the law come last.
    law : tuple of Tried
        The terms of the law.
    proof : Proof
    gain : float
        In chi2, beside all else.
    cost : float
        Deviance, and the price of the law and of the names beside it.
    unsure : tuple of Unsure
        Of each term.
    whole : bool
        Whether what it leaves is noise.
    count : int
        Forms, place by place, among which its last term was looked for at last; 0 for rivals.
    runners_up : tuple of Tried
        Those that could stand for its last term but for what they earn, the best first.
    """

    fit: Fit
    law: tuple[Tried, ...]
    proof: Proof
    gain: float
    cost: float
    unsure: tuple[Unsure, ...]
    whole: bool = True
    count: int = 0
    runners_up: tuple[Tried, ...] = ()

    @property
    def terms(self) -> list[Term]:
        """The terms of the law as they are fitted."""
        return [t for t in terms_of(self.fit) if is_law(t.effect)]

    @property
    def charge(self) -> float:
        """What the law had to earn."""
        return sum(t.price for t in self.law)

    @property
    def text(self) -> str:
        """The law in one line."""
        return "; ".join(t.effect.removeprefix("law ") for t in self.terms)


@dataclass(frozen=True)
class Sought:
    """What the search for a law comes to.

    Attributes
    ----------
    laws : tuple of Lawful
        The law that is borne out, and those that these readings cannot tell from it.
    doubtful : Term, optional
        A law that readings which took no part in finding it neither bear out nor refuse.
    """

    laws: tuple[Lawful, ...] = ()
    doubtful: Term | None = None

    @property
    def questions(self) -> list[Question]:
        """What is open: a law against its rivals, or against there being none."""
        if not self.laws:
            return [Question(self.doubtful, proven=False)] if self.doubtful is not None else []
        *others, last = self.laws[0].terms
        rivals = tuple(law.terms[-1] for law in self.laws[1:] if law.proof.holds)
        return [*map(Question, others), Question(last, rivals)]


def laws(found: Outcome, progress: Callable[[str], None], doubted: bool = False) -> Sought:
    """Return the law that is borne out, and its rivals, where named effects leave more than noise.

    With the named effects beside it, and without: what a law explains alone needs no name seen through the wrong
    glasses. Of names that are `doubted`, whatever they leave, a law is sought in place of them all.
    """
    problem, at = found.problem, found.search.fit
    if problem.readings.rows.shape[1] != 1:
        return Sought()  # of distances, either end could be moved
    names = [t for t in terms_of(at) if not is_law(t.effect)]
    more = found.unexplained or (bool(names) and stands_out(Ground(at)))
    if not (more or doubted):
        return Sought()
    # rows that hang together are the law's doing, where there is one; its price is compared with theirs
    white = dataclasses.replace(at, repeats=at.repeats.as_plain())
    out = Sought()
    for terms in ([], names) if names and more else ([],):
        try:
            out = _beside(found, white, terms, names, progress)
        except InputError:
            continue  # under it the machine cannot stand where it stood: it is no law
        if out.laws:
            break
    return out


def _beside(
    found: Outcome, white: Fit, beside: Sequence[Term], names: Sequence[Term], progress: Callable[[str], None]
) -> Sought:
    """Return what `laws` does, of laws found beside some of the named effects."""
    problem = found.problem
    base = refitted(problem, white, beside)
    if base is None:
        return Sought()
    progress("laws")
    instead = Instead() if beside else Instead(names, sum(_prices(names, found)))
    proof = proven(problem, base, instead, again=not beside)
    if proof is None:
        return Sought()
    if not proof.holds:
        return Sought(doubtful=proof.grown.terms[0] if proof.share > 0 and not _by_others(proof.grown) else None)
    some = problem.some(MOST_POSES, np.random.default_rng(SEED))
    first = _of_all(some, base, proof.grown, names)
    for grown in () if first is None else (curved(some, first), first):
        for kept in _alone_first(some, base, proof.grown, _needed(some, grown, found), found):
            whole = kept if some is problem or not kept.law else _of_all(problem, base, kept, kept.names)
            if whole is None or not whole.law or whole.cost >= deviance_of(found.search.fit) or _by_others(whole):
                continue
            asked = _asked(problem, whole, proof)  # what is told is asked for as it is written
            if asked is not None and asked.holds:
                return Sought(tuple(_told(problem, _calm(problem, whole), asked, found)))
    return Sought()


def _by_others(grown: Grown) -> bool:
    """Tell whether a law is better told of what goes by no law: an instrument that moves, or joints that wander."""
    first = len(terms_of(grown.fit)) - len(grown.law)
    prices = {first + i: t.price + MARGIN for i, t in enumerate(grown.law)}
    return _moved(grown) or bool(following_walks(grown.fit, prices)[0])


def _moved(grown: Grown) -> bool:
    """Tell whether the instrument could have moved so: shifts and turns of it by the same functions explain as much.

    That is asked of laws of limbs that read channels of the machine alone.
    """
    terms = terms_of(grown.fit)
    first = len(terms) - len(grown.law)
    for i, t in enumerate(grown.law):
        ground = Ground(grown.fit).freed(first + i)
        values = ground.values(t.form)
        if not t.limbs or values.shape[1] > 1 or any(named(s).joint for s in t.form.states):
            continue
        own = ground.gain(ground.place(t.target), t.form, t.limbs) - len(t.limbs) * values.shape[2] * quantile(1, 1)
        columns = by_instrument(grown.fit, ground.beside, values[:, 0])
        G, b, _ = ground.normal(columns[:, None])
        if float(gains(G, b)[0]) - columns.shape[1] * quantile(1, 1) > own:
            return True
    return False


def _calm(problem: Problem, grown: Grown) -> Grown:
    """Return a law beside noise that hangs together, where what it leaves does."""
    calm = together(grown.fit)
    if calm is None:
        return grown
    fit = refitted(problem, dataclasses.replace(grown.fit, repeats=calm), terms_of(grown.fit))
    return grown if fit is None else dataclasses.replace(grown, fit=fit)


def _prices(terms: Sequence[Term], found: Outcome) -> list[float]:
    """Return what each named effect has to earn; waves of one finding share what they earn together."""
    out = [0.0] * len(terms)
    for own in found.search.grouped(terms):
        for i in own:
            out[i] = (found.search.price(*(terms[k] for k in own)) + MARGIN) / len(own)
    return out


def _of_all(problem: Problem, base: Fit, grown: Grown, names: Sequence[Term]) -> Grown | None:
    """Return a law that was found on a part of the readings as all have it, named effects beside it."""
    found = refitted(problem, base, [*names, *grown.terms])
    if found is None:
        return None
    out = Grown(found, grown.law, (), deviance_of(found) + sum(t.price + MARGIN for t in grown.law))
    for i in range(len(grown.law)):
        out = polished(problem, out, i)
    return out


def _alone_first(problem: Problem, base: Fit, law: Grown, kept: Grown, found: Outcome) -> list[Grown]:
    """Return a law with the names that it needs; before it without any, where a form that has their part costs less.

    Warmth times what a gauge reads, and warmth, are warmth times what the gauge reads from elsewhere on.
    """
    if not (kept.law and kept.names) or terms_of(base):
        return [kept]
    alone = _of_all(problem, base, law, [])
    alone = None if alone is None else curved(problem, alone)
    return [kept] if alone is None or _cost(alone, found) >= _cost(kept, found) else [alone, kept]


def _needed(problem: Problem, grown: Grown, found: Outcome) -> Grown:
    """Return a law and named effects without what does not earn its price beside the rest, the worst first.

    Where a name and a term of the law explain the same, the name stays: it has the lower price. Which are the worst is
    told by the fit's own covariance; the exact fit is asked for `DOUBTED` of them.
    """
    while True:
        terms, now = terms_of(grown.fit), deviance_of(grown.fit)
        count = len(terms) - len(grown.law)
        prices = [*_prices(terms[:count], found), *(t.price + MARGIN for t in grown.law)]
        order = sorted(range(len(terms)), key=lambda i: _earned(grown.fit, i) - prices[i])
        for worst in order[:DOUBTED]:
            at = refitted(problem, grown.fit, terms[:worst] + terms[worst + 1 :], tolerance=COMPARED)
            if at is not None and deviance_of(at) - prices[worst] < now:
                break
        else:
            return grown
        law = tuple(t for k, t in enumerate(grown.law) if k != worst - count)
        grown = Grown(at, law, (), deviance_of(at) + sum(t.price + MARGIN for t in law))
        if not law:
            return grown


def _earned(at: Fit, i: int) -> float:
    """Return by how much chi2 would rise without a term of a fit, to first order."""
    own = at.problem.coefficients(i)
    covariance = at.covariance[np.ix_(own, own)]
    std = np.sqrt(np.diag(covariance))
    sizes = terms_of(at)[i].values.ravel() / std
    return float(sizes @ np.linalg.pinv(covariance / np.outer(std, std), hermitian=True) @ sizes)


def _told(problem: Problem, grown: Grown, proof: Proof, found: Outcome) -> list[Lawful]:
    """Return a law and its rivals, with how sure their numbers are.

    Each stands beside the names that it needs itself: a rival that needs fewer may cost less, and is then the law.
    """
    terms = terms_of(grown.fit)
    last = len(terms) - 1
    ground = Ground(grown.fit).freed(last)
    own = grown.law[-1]
    gain = ground.gain(ground.place(own.target), own.form, own.limbs)
    told = [(grown, proof)]
    every, count = counted(ground)
    less: list[Tried] = []
    for other in every:
        more = set(other.form.states) > set(own.form.states)
        same = (other.target, set(other.form.states)) == (own.target, set(own.form.states))
        if same or more or other.score < gain - own.price - RIVALS or len(told) == MOST:
            less += [] if same else [other]
            continue
        rival = fitted(problem, grown, ground, other, (), len(grown.law) - 1)
        if rival is not None and rival.names:
            rival = _needed(problem, rival, found)
        asked = _asked(problem, rival, proof) if rival is not None and len(rival.law) == len(grown.law) else None
        if rival is not None and asked is not None:
            told.append((rival, asked))
        else:
            less.append(other)
    cost = [_cost(law, found) for law, _ in told]
    best = min(range(len(told)), key=cost.__getitem__)
    if best and (not told[best][1].holds or _by_others(told[best][0])):
        best = 0
    order = [best, *(k for k in range(len(told)) if k != best)]
    first, *others = (_with_figures(*told[k], cost[k]) for k in order)
    return [
        dataclasses.replace(first, count=count, runners_up=tuple(t for t in less[:RUNNERS_UP] if t.score > 0)),
        *others,
    ]


def _cost(grown: Grown, found: Outcome) -> float:
    """Return the deviance of a law and the names beside it, and the price of all of them."""
    names = sum(_prices(grown.names, found))
    return deviance_of(grown.fit) + names + sum(t.price + MARGIN for t in grown.law)


def _asked(problem: Problem, grown: Grown, proof: Proof) -> Proof | None:
    """Return what readings that were asked say of a law whose form is given, its numbers as the others have them."""
    part = problem.subset(np.flatnonzero(proof.train))
    terms = terms_of(grown.fit)
    without = refitted(part, grown.fit, terms[: len(terms) - len(grown.law)])
    found = refitted(part, grown.fit, terms)
    alone = refitted(part, grown.fit, []) if grown.names else without
    if without is None or alone is None or found is None:
        return None
    known = Grown(found, grown.law, (), deviance_of(found) + sum(t.price + MARGIN for t in grown.law))
    for i in range(len(grown.law)):
        known = polished(part, known, i)
    return judged(problem, (without, alone), known, proof.train, proof.test)


def _with_figures(grown: Grown, proof: Proof, cost: float) -> Lawful:
    count, n = len(grown.law), len(terms_of(grown.fit))
    ground = Ground(grown.fit)
    without = ground.freed(*range(n - count, n))
    unsure, columns = [], []
    for i, (tried, term) in enumerate(zip(grown.law, terms_of(grown.fit)[n - count :], strict=True)):
        unsure.append(_unsure(ground, ground.freed(n - count + i), tried, term))
        place = without.place(tried.target)
        C = without.columns(place, without.values(tried.form))[:, :, [k - 1 for k in tried.limbs] or [0]]
        columns.append(C.reshape(len(C), -1))
    G, b, _ = without.normal(np.hstack(columns)[:, None])
    gain = float(b[0] @ np.linalg.pinv(G[0], rcond=1e-8, hermitian=True) @ b[0])
    return Lawful(grown.fit, grown.law, proof, gain, cost, tuple(unsure), not unexplained(grown.fit))


def _unsure(ground: Ground, freed: Ground, tried: Tried, term: Term) -> Unsure:
    """Return how unknown a term's constants are.

    Parameters
    ----------
    ground, freed : Ground
        At the exact fit, with the term fitted, and with it taken out.
    """
    form, place = tried.form, ground.place(tried.target)
    n = len(form.constants)
    if not n:
        return Unsure(np.zeros(0), np.zeros(term.n_coefficients), np.zeros((0, 0)), np.zeros((0, term.n_coefficients)))
    at = np.array(form.constants)
    steps, moved = STEP * np.maximum(np.abs(at), 1e-12), []
    for step in np.diag(steps):
        ends = [freed.term(tried.target, form.with_constants(c), tried.limbs) for c in (at + step, at - step)]
        moved.append((ends[0].values.ravel() - ends[1].values.ravel()) / (2 * step.max()))
    columns = ground.by_constants(place, form, tried.limbs, term.values, steps)
    G, _, size = ground.normal(columns[:, None])
    scale = np.where(size[0] > 0, size[0], 1.0)
    covariance = np.linalg.pinv(G[0], rcond=1e-8, hermitian=True) / np.outer(scale, scale)
    by = np.array(moved)
    std = np.sqrt(np.maximum(np.diag(covariance), 0.0))
    return Unsure(std, np.einsum("kc,kl,lc->c", by, covariance, by), covariance, by)
