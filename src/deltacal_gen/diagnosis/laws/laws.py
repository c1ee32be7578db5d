"""A law for what no registered effect explains: found, asked, fitted to everything, with what it makes needless."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.diagnosis.charges import MARGIN, gains
from deltacal_gen.diagnosis.designs import Question
from deltacal_gen.diagnosis.laws.ground import Ground, Tried
from deltacal_gen.diagnosis.laws.proof import Proof, goes_with_time, judged, parted
from deltacal_gen.diagnosis.laws.screen import counted, stands_out
from deltacal_gen.diagnosis.laws.search import FormulaFit, fitted, grow, polished, shaped_all
from deltacal_gen.diagnosis.refits import COMPARED, form, refitted, terms_of
from deltacal_gen.diagnosis.strategy import Outcome
from deltacal_gen.diagnosis.wandering import following_walks
from deltacal_gen.errors import InputError
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.identification.together import deviance_of, together
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import Term

MOST_POSES, SEED = 250, 1859  # on which a law is sought, drawn at random where there are more; all are asked at last
FEWEST = 3  # readings on which a law is found, and that are asked
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
    # rows that hang together are the law's doing, where there is one; its price is compared with theirs
    named = FormulaFit(dataclasses.replace(at, repeats=at.repeats.as_plain()), prices=_prices(found))
    more = found.unexplained or (bool(named.names) and stands_out(Ground(at)))
    if not (more or doubted):
        return Sought()
    progress("laws")
    out = Sought()
    for names in ([], named.names) if named.names and more else ([],):
        try:
            out = _beside(problem, named, names, found)
        except InputError:
            continue  # under it the machine cannot stand where it stood: it is no law
        if out.laws:
            break
    return out


def _prices(found: Outcome) -> dict[tuple[object, ...], float]:
    """Return what each named effect has to earn; waves of one finding share what they earn together."""
    terms, out = terms_of(found.search.fit), dict[tuple[object, ...], float]()
    for own in found.search.grouped(terms):
        whole = found.search.price(*(terms[k] for k in own)) + MARGIN
        out |= {form(terms[k]): whole / len(own) for k in own}
    return out


def _beside(problem: Problem, named: FormulaFit, names: Sequence[Term], found: Outcome) -> Sought:
    """Return what `laws` does, of laws found beside some of the named effects."""
    if (base := refitted(problem, named.fit, names)) is None:
        return Sought()
    train, test = parted(problem, False)
    law = _of_part(problem, base, named, train, test)
    if law is not None and goes_with_time(problem, law):  # that is asked of what comes last
        train, test = parted(problem, True)
        law = _of_part(problem, base, named, train, test)
    if law is None:
        return Sought()
    proof = judged(problem, law, train, test)
    if proof is None or not proof.holds:
        doubtful = proof is not None and proof.share > 0 and not _by_walks(law)
        return Sought(doubtful=law.terms[0] if doubtful else None)
    # a form that has the part of a name needs none: warmth times a gauge, and warmth, are warmth times its reading
    every = (_of_all(problem, named, law, beside) for beside in (named.names, []))
    whole = min((h for h in every if h is not None), key=lambda h: h.cost, default=named)
    if not whole.law or whole.cost >= deviance_of(found.search.fit) + sum(named.charges) or _by_walks(whole):
        return Sought()
    asked = _asked(problem, whole, proof)  # what is told is asked for as it is written
    if asked is None or not asked.holds:
        return Sought()
    calm = together(whole.fit)
    still = calm and refitted(problem, dataclasses.replace(whole.fit, repeats=calm), terms_of(whole.fit))
    return Sought(tuple(_told(problem, dataclasses.replace(whole, fit=still or whole.fit), asked)))


def _of_part(problem: Problem, base: Fit, named: FormulaFit, train: np.ndarray, test: np.ndarray) -> FormulaFit | None:
    """Return the law that a part (R,) of the readings has beside a fit; none that costs more than the named effects."""
    if min(train.sum(), test.sum()) < FEWEST:
        return None
    part = problem.subset(np.flatnonzero(train)).some(MOST_POSES, np.random.default_rng(SEED))
    first = refitted(part, base, terms_of(base))
    instead = refitted(part, base, named.names, tolerance=COMPARED) if named.names and not terms_of(base) else None
    most = np.inf if instead is None else dataclasses.replace(named, fit=instead).cost
    return None if first is None else grow(part, first, most)


def _by_walks(law: FormulaFit) -> bool:
    """Tell whether a law is better told of what goes by no law: an instrument, or joints, that wander."""
    charges = law.charges
    return bool(following_walks(law.fit, {law.place(i): charges[law.place(i)] for i in range(len(law.law))})[0])


def _of_all(problem: Problem, named: FormulaFit, law: FormulaFit, names: Sequence[Term]) -> FormulaFit | None:
    """Return a law that was found on a part of the readings as all have it, beside those names that it needs."""
    fit = refitted(problem, named.fit, [*names, *law.terms])
    if fit is None:
        return None
    out = dataclasses.replace(named, fit=fit, law=law.law)
    for i in range(len(law.law)):
        out = polished(problem, out, i)
    return _needed(problem, shaped_all(problem, out))


def _needed(problem: Problem, now: FormulaFit) -> FormulaFit:
    """Return a law and named effects without what does not earn its price beside the rest, the worst first.

    Where a name and a term of the law explain the same, the name stays: it has the lower price. Which are the worst is
    told by the fit's own covariance; the exact fit is asked for `DOUBTED` of them.
    """
    while now.law:
        terms, charges = terms_of(now.fit), now.charges
        order = sorted(range(len(terms)), key=lambda i: _earned(now.fit, i) - charges[i])
        for worst in order[:DOUBTED]:
            fit = refitted(problem, now.fit, terms[:worst] + terms[worst + 1 :], tolerance=COMPARED)
            law = tuple(t for i, t in enumerate(now.law) if now.place(i) != worst)
            fewer = None if fit is None else dataclasses.replace(now, fit=fit, law=law)
            if fewer is not None and fewer.cost < now.cost:
                now = fewer
                break
        else:
            break
    return now


def _earned(at: Fit, i: int) -> float:
    """Return by how much chi2 would rise without a term of a fit, to first order."""
    own = at.problem.coefficients(i)
    covariance = at.covariance[np.ix_(own, own)]
    std = np.sqrt(np.diag(covariance))
    sizes = terms_of(at)[i].values.ravel() / std
    return float(sizes @ np.linalg.pinv(covariance / np.outer(std, std), hermitian=True) @ sizes)


def _told(problem: Problem, best: FormulaFit, proof: Proof) -> list[Lawful]:
    """Return a law and its rivals, with how sure their numbers are.

    Each stands beside the names that it needs itself: a rival that needs fewer may cost less, and is then the law.
    """
    ground, own = best.freed(-1), best.law[-1]
    gain = ground.gain(ground.place(own.target), own.form, own.limbs)
    told, less = [(best, proof)], list[Tried]()
    every, count = counted(ground)
    for other in every:
        more = set(other.form.states) > set(own.form.states)
        same = (other.target, set(other.form.states)) == (own.target, set(own.form.states))
        near = not more and other.score >= gain - own.price - RIVALS and len(told) < MOST
        rival = fitted(problem, best, ground, other, -1) if near and not same else None
        rival = _needed(problem, rival) if rival is not None and rival.names else rival
        asked = _asked(problem, rival, proof) if rival is not None and len(rival.law) == len(best.law) else None
        if rival is not None and asked is not None:
            told.append((rival, asked))
        elif not same and 0 < other.score < gain - own.price:
            less.append(other)
    able = [law for law, asked in told if law is best or (asked.holds and not _by_walks(law))]
    told.sort(key=lambda pair: pair[0].cost if pair[0] in able else np.inf)
    first, *others = (_with_figures(*pair) for pair in told)
    return [dataclasses.replace(first, count=count, runners_up=tuple(less[:RUNNERS_UP])), *others]


def _asked(problem: Problem, law: FormulaFit, proof: Proof) -> Proof | None:
    """Return what readings that were asked say of a law whose form is given, its numbers as the others have them."""
    part = problem.subset(np.flatnonzero(proof.train))
    fit = refitted(part, law.fit, terms_of(law.fit))
    if fit is None:
        return None
    known = dataclasses.replace(law, fit=fit)
    for i in range(len(law.law)):
        known = polished(part, known, i)
    return judged(problem, known, proof.train, proof.test)


def _with_figures(law: FormulaFit, proof: Proof) -> Lawful:
    ground, own = Ground(law.fit), [law.place(i) for i in range(len(law.law))]
    unsure = (_unsure(ground, ground.freed(i), t, terms_of(law.fit)[i]) for i, t in zip(own, law.law, strict=True))
    without = ground.freed(*own)
    columns = [without.of(without.place(t.target), t.form, t.limbs) for t in law.law]
    G, b, _ = without.normal(np.hstack(columns)[:, None])
    return Lawful(law.fit, law.law, proof, float(gains(G, b)[0]), law.cost, tuple(unsure))


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
