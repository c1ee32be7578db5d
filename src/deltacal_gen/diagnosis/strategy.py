"""The search for what was left out: what is selected, whether held-out readings bear it out, and what it leaves."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.charges import AS_GOOD, MARGIN
from deltacal_gen.diagnosis.evidence import evidence
from deltacal_gen.diagnosis.refits import COMPARED, form, refitted, terms_of
from deltacal_gen.diagnosis.scattering import scattering
from deltacal_gen.diagnosis.search import Found, Search
from deltacal_gen.diagnosis.selection import MOST_EFFECTS, Hypothesis, Progress, select
from deltacal_gen.diagnosis.spectrum import Spectrum, periodic
from deltacal_gen.diagnosis.structure import Structure, alike, smooth_columns, structures
from deltacal_gen.estimation.fit import held_out, held_out_errors
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.noise import lack_of_fit, merely_more
from deltacal_gen.identification.orders import wave
from deltacal_gen.identification.together import PRICE, deviance_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term, on_limbs

REVISIONS = 4  # in which what is found and many orders settle beside one another
TURNS, SETTLED = 4, 0.5  # in which orders and what is beside them settle; standard deviations that are as good as none
HARDLY_ALIKE = 2.5  # standard deviations by which neighbouring poses may correlate where nothing is left
SOLVED_TO = 1e-8  # mm, rad: what is left of readings without noise is how far poses are solved, and no physics
ALIKE = 4.0  # standard deviations by which what is left must correlate between neighbouring poses to be no noise
BORNE_OUT = 2.0  # standard deviations by which held-out readings must speak for what is named


@dataclass(frozen=True)
class Outcome:
    """What a search has found: the fit with all effects that hold, what it leaves, and what it was judged by.

    Attributes
    ----------
    first : Fit
        Of geometry and instrument alone.
    left : list of Structure
        What is left, the strongest first.
    parts : list of (train, test)
        Masks of readings, held out in turn.
    without, predicted : (R, k) array
        Errors of held-out readings [mm, rad] by geometry alone, and with what `tested` had found.
    hypotheses : tuple of Hypothesis
        That were compared, the cheapest first.
    wandering : tuple of int
        Joints, from 1, and 0 for the instrument, that go as chance has it where effects of time were found at first.
    """

    problem: Problem
    first: Fit
    search: Search
    considered: list[Found]
    left: list[Structure]
    spectrum: Spectrum | None
    unexplained: bool
    parts: list[tuple[np.ndarray, np.ndarray]]
    tested: Fit
    without: Array
    predicted: Array
    hypotheses: tuple[Hypothesis, ...] = ()
    wandering: tuple[int, ...] = ()


def searched(some: Problem, first: Fit, terms: Sequence[Term], lean: bool, progress: Progress) -> Outcome:
    """Search for what was left out, beside a fit of geometry and instrument."""
    search, considered, weighed = Search(first, terms), list[Found](), tuple[Hypothesis, ...]()
    if not lean:
        selected = select(some, search, progress)
        search, considered = _stiffest(some, selected.search), selected.considered
        weighed = selected.hypotheses
        first = _beside(some, first, search.fit)
    parts = folds(some.readings, some.recording, rows=search.fit.repeats.rows)
    progress("held-out error")
    without, tested = held_out_errors(first, Prior(), parts), search.fit
    predicted = held_out_by(some, search, parts) if search.effects else without
    if search.effects and not _speak_for(search, first, without, predicted, parts):
        first = next((h.fit for h in weighed if not terms_of(h.fit)), first)  # in the noise that suits what it leaves
        search, without = Search(first, terms), held_out_errors(first, Prior(), parts)
    progress("what is left")
    search, left = _without_gross(some, search)

    spectrum = None
    if unexplained := _unexplained(search, left, lean):
        progress("periodic errors of many orders")
        spectrum = _spectrum(some, search, parts)
    if spectrum is not None:
        some, search, spectrum, considered = _beside_orders(some, search, spectrum, parts, progress)
        search, left = _without_gross(some, search)
        unexplained = _unexplained(search, left, lean)
    rest = smooth_columns(search.fit, left[0].channel) if left[0].earned > MARGIN else None
    if search.effects and (rest is not None or scattering(search.fit)):
        proven = _proven(some, search, rest)
        if proven is not search:
            search, left = proven, structures(proven.fit)
            unexplained = _unexplained(search, left, lean)
    judged = (spectrum, unexplained, parts, tested, without, predicted)
    return Outcome(some, first, search, considered, left, *judged, hypotheses=weighed)


def in_white_noise(found: Outcome) -> Outcome | None:
    """Return what was found beside noise of each row's own; None where it is so already."""
    at = found.search.fit
    if at.repeats.plain:
        return None
    white = refitted(found.problem, dataclasses.replace(at, repeats=at.repeats.as_plain()), terms_of(at))
    if white is None:
        return None
    first = _beside(found.problem, found.first, white)
    search, left = Search(white, found.search.terms), structures(white)
    return dataclasses.replace(
        found, first=first, search=search, left=left, tested=white, unexplained=_unexplained(search, left, False)
    )


def _beside(problem: Problem, first: Fit, chosen: Fit) -> Fit:
    """Return the fit of geometry alone in the noise of another."""
    if chosen.repeats.plain and first.repeats.plain:
        return first
    return refitted(problem, dataclasses.replace(first, repeats=chosen.repeats), []) or first


def _speak_for(
    search: Search, first: Fit, without: Array, predicted: Array, parts: Sequence[tuple[np.ndarray, np.ndarray]]
) -> bool:
    """Tell whether held-out readings bear out what was found, and are not farther off where others choose for them.

    Effects that other readings would not have chosen, or in sizes that spoil the prediction, hold for their own alone.
    """
    found = evidence(first, without, held_out_errors(search.fit, Prior(), parts))
    return found.speaks and not evidence(first, without, predicted).falls_short


def _unexplained(search: Search, left: Sequence[Structure], lean: bool) -> bool:
    """Tell whether more is left than noise: by its size, along a channel, a place, a joint, or alike in neighbours."""
    if lean:
        return False
    at, recording = search.fit, search.fit.problem.recording
    if float(np.nanmax(np.abs(at.residual))) < SOLVED_TO:
        return False
    if any(s.earned > MARGIN for s in left) or alike(at)[1] > ALIKE or scattering(at):
        return True
    return lack_of_fit(at, recording) and not (merely_more(at, recording) and _structureless(search, left))


def _structureless(search: Search, left: Sequence[Structure]) -> bool:
    """Tell whether nothing that was recorded, no neighbour and no effect explains more of what is left than chance.

    Then a declared noise that is less than it is wrong: no physics is left to be sought.
    """
    calm = alike(search.fit)[1] < HARDLY_ALIKE and all(s.earned <= 0 for s in left)
    return calm and all(f.score <= 0 for f in search.ranked())


def deviance(found: Outcome) -> float:
    """Return twice the negative logarithm of the likelihood of what was found, with its price; see `deviance_of`.

    An instrument that wanders moves readings as effects without limbs do: those pay as much more as such noise does.
    """
    terms = terms_of(found.search.fit)
    price = found.search.priced(terms) + PRICE * any(not t.limbs for t in terms)
    of_spectrum = 0.0 if found.spectrum is None else 2 * len(found.spectrum.limbs) * found.spectrum.corner + MARGIN
    return deviance_of(found.search.fit) + price + of_spectrum


def _spectrum(problem: Problem, search: Search, parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> Spectrum | None:
    """Return periodic errors of many orders where they predict readings better than the few that were found."""
    beside = refitted(problem, search.fit, _beside_waves(search))
    found = None if beside is None else periodic(beside, parts)
    if found is None or found.heldout[1] >= held_out(search.fit, Prior(), parts):
        return None
    return found


def _beside_orders(
    some: Problem,
    search: Search,
    spectrum: Spectrum,
    parts: Sequence[tuple[np.ndarray, np.ndarray]],
    progress: Progress,
) -> tuple[Problem, Search, Spectrum, list[Found]]:
    """Search beside many orders, and estimate these beside what is found, in turn, until both stay."""
    terms = [t for t in search.terms if t.effect != wave()]
    considered: list[Found] = []
    at, effects = search.fit, _beside_waves(search)
    for _ in range(REVISIONS):
        beside = refitted(spectrum.held_in(some), at, effects)
        if beside is None:
            break
        beside, spectrum = settled(some, beside, spectrum, parts)
        some = spectrum.held_in(some)
        before = {form(t) for t in terms_of(beside)}
        selected = select(some, Search(beside, terms), progress)
        search, considered = selected.search, considered or selected.considered
        at, effects = search.fit, terms_of(search.fit)
        if {form(t) for t in effects} == before:
            break
    return some, search, spectrum, considered


def settled(
    problem: Problem,
    at: Fit,
    spectrum: Spectrum,
    parts: Sequence[tuple[np.ndarray, np.ndarray]],
) -> tuple[Fit, Spectrum]:
    """Return a fit and the orders that are held in it, each as it is beside the other.

    Orders and all that is fitted beside them are estimated jointly in the machine made linear; that is repeated in the
    exact one until nothing moves by much of what it is uncertain by.
    """
    for _ in range(TURNS):
        again = periodic(at, parts, spectrum)
        if again is None:
            break
        new = refitted(again.held_in(problem), at, terms_of(at))
        if new is None:
            break
        own = at.problem.columns
        std = np.sqrt(np.maximum(np.diag(again.covariance)[: len(own)], 1e-300))
        moved = float(np.abs((new.errors[own] - at.errors[own]) / std).max())
        at, spectrum = new, again
        if moved < SETTLED:
            break
    return at, spectrum


def _beside_waves(search: Search) -> list[Term]:
    """Return the effects found that are no waves, simple ones for those that extend them.

    Whether the flexible ones are needed is seen in what many orders leave.
    """
    found = [t for t in terms_of(search.fit) if t.effect != wave()]
    blanks = {t.effect: t for t in search.terms if all(t.effect != other.effect for other in found)}
    simple = (blanks.get(t.kernels.EXTENDS) for t in found)
    return [t if s is None else on_limbs(s, t.limbs) for t, s in zip(found, simple, strict=True)]


def _without_gross(problem: Problem, search: Search) -> tuple[Search, list[Structure]]:
    """Return the search without gross errors, and what it leaves.

    They are dropped only where nothing is left with them: readings that lie off together, in a region or for a time,
    are no gross errors but what the model does not know. For that, none counts more than an ordinary reading that is
    just off: the squares of Huber's weights bound what each adds to a gain.
    """
    left = structures(dataclasses.replace(search.fit, weights=search.fit.weights**2))
    if left[0].earned > MARGIN or not len(search.fit.gross):
        return search, left
    final = refitted(problem, search.fit, terms_of(search.fit), drop_gross=True)
    if final is None:
        return search, left
    search = _proven(problem, Search(final, search.terms))
    return search, structures(search.fit)


def _stiffest(problem: Problem, search: Search) -> Search:
    """Return the search with effects at the limbs that give least, of those that nothing tells apart beside all others.

    Not before: what is not found yet may tell them apart.
    """
    for i in range(len(terms_of(search.fit))):
        terms = terms_of(search.fit)
        if (other := search.freed(i).stiffer(terms[i])) is None:
            continue
        tried = refitted(problem, search.fit, [*terms[:i], other, *terms[i + 1 :]])
        if tried is None:
            continue
        worse = 2 * problem.readings.n_scalars * float(np.log(tried.sigma[0] / search.fit.sigma[0]))
        if worse < AS_GOOD:
            search = Search(tried, search.terms)
    return search


def _proven(problem: Problem, search: Search, rest: Array | None = None) -> Search:
    """Drop the effects that do not earn their price, or do not beside the rest, columns that explain them as well.

    What no effect explains is easily imitated in part by some that vary with the same channel, or move the same joint.
    """
    drop_gross = not search.fit.weights.all()
    while search.effects:
        terms, scatter = terms_of(search.fit), scattering(search.fit)
        each, scores = search.grouped(terms), []
        for places in each:
            own = [terms[i] for i in places]
            beside = search.freed(*places) if rest is None else search.freed(*places).joined(rest)
            noisy = scatter.variance if scatter and own[0].limbs == (scatter.joint,) else 1.0
            scores.append(beside.gain(beside.columns_of(*own)) / noisy - search.price(*own))
        worst = int(np.argmin(scores))
        if scores[worst] > MARGIN:
            break
        others = [t for i, t in enumerate(terms) if i not in each[worst]]
        kept = refitted(problem, search.fit, others, drop_gross=drop_gross)
        if kept is None:
            break
        search = Search(kept, search.terms)
    return search


def borne_out(before: Array, after: Array) -> bool:
    """Tell whether readings held out lie nearer to their prediction after than before, (R, k) in standard deviations.

    Each counts by the part of its square that goes or comes, which no gross error outweighs.
    """
    a, b = np.nansum(before**2, axis=1), np.nansum(after**2, axis=1)
    seen = np.isfinite(before).any(axis=1) & np.isfinite(after).any(axis=1) & (a + b > 0)
    gone = (a[seen] - b[seen]) / (a[seen] + b[seen])
    if len(gone) < 2:
        return False
    return bool(gone.mean() > BORNE_OUT * gone.std(ddof=1) / np.sqrt(len(gone)))


def held_out_by(problem: Problem, search: Search, parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> Array:
    """Return the errors (R, k) [mm, rad] of readings that took part neither in a fit nor in the choice of its effects.

    Each part of the readings is predicted from the others, which choose their own effects: by the same charges, in the
    machine made linear at the final fit.
    """
    final = {form(t): t for t in terms_of(search.fit)}
    out = np.full(search.fit.residual.shape, np.nan)
    for train, test in parts:
        part = search.freed(*range(len(final))).within(train)
        chosen: list[Term] = []
        while len(part.grouped(chosen)) < MOST_EFFECTS and (best := part.ranked()[0]).score > MARGIN:
            chosen += best.terms
            part = part.added(*best.terms)
        same = {form(t) for t in chosen} == final.keys()
        terms = [final.get(form(t), t) for t in chosen]
        fitted = search.fit if same else refitted(problem, search.fit, terms, tolerance=COMPARED, known=terms)
        if fitted is not None:
            out[test] = held_out_errors(fitted, Prior(), [(train, test)])[test]
    return out
